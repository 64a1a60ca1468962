// SPDX-License-Identifier: MIT
// Passes of threads and taps: ramps, X beside them and times, against what follows by hand from the
// limits of the axes, a spindle that is 5 % too fast included.
#include <math.h>   // cbrt fabs fmax sqrt
#include <string.h> // memset

#include "check.h"
#include "nck/base/thread.h" // nck_thread_plan …

#define F 1.05      // how much faster the spindle may turn
#define EVEN 0.8    // of X's acceleration, in motions of its own
#define NEAR 1e-12  // double arithmetic on numbers of the order of 1 … 100

static nck_machine_t machine;
static const double origin[NCK_AXIS_MAX];

// X 50 mm/s, 400 mm/s², 4000 mm/s³; Z 100, 1000, 10000; along the path 800, 9000.
static void begin(uint32_t slope) {
    nck_machine_default(&machine);
    machine.slope = slope;
    machine.axis[NCK_AXIS_X].v_max = 50.0;
    machine.axis[NCK_AXIS_X].a_max = 400.0;
    machine.axis[NCK_AXIS_X].j_max = 4000.0;
    machine.path.a_max = 800.0;
    machine.path.j_max = 9000.0;
}

static void check_moment(check_t *check, const nck_ramp_t *ramp, double t, double s, double v,
                         double a) {
    nck_moment_t at;
    nck_thread_on_ramp(ramp, t, &at);
    CHECK_NEAR(check, at.s, s, NEAR);
    CHECK_NEAR(check, at.v, v, NEAR);
    CHECK_NEAR(check, at.a, a, 100.0 * NEAR);
}

static void check_ramp(check_t *check, const nck_ramp_t *ramp, double t_jerk, double t_even,
                       double length) {
    CHECK_NEAR(check, ramp->t_jerk, t_jerk, NEAR);
    CHECK_NEAR(check, ramp->t_even, t_even, NEAR);
    CHECK_NEAR(check, ramp->time, 2.0 * t_jerk + t_even, NEAR);
    CHECK_NEAR(check, ramp->length, length, NEAR);
}

// 10 mm/s at 250 mm/s³: 0.2 s up to 50 mm/s², 0.2 s down; half of it at a mean speed of 5 mm/s.
static void a_ramp_that_never_has_its_acceleration(check_t *check) {
    nck_ramp_t ramp;
    nck_thread_ramp(10.0, 100.0, 250.0, &ramp);
    check_ramp(check, &ramp, 0.2, 0.0, 2.0);
    check_moment(check, &ramp, 0.0, 0.0, 0.0, 0.0);
    check_moment(check, &ramp, 0.1, 0.25 / 6.0, 1.25, 25.0);
    check_moment(check, &ramp, 0.2, 2.0 / 6.0, 5.0, 50.0);
    check_moment(check, &ramp, 0.3, 1.0 + 0.25 / 6.0, 8.75, 25.0);
    check_moment(check, &ramp, 0.4, 2.0, 10.0, 0.0);
}

// 10 mm/s at 10 mm/s² and 100 mm/s³: 0.1 s of jerk, 0.9 s even, 0.1 s of jerk.
static void a_ramp_that_has_it_for_a_while(check_t *check) {
    nck_ramp_t ramp;
    nck_thread_ramp(10.0, 10.0, 100.0, &ramp);
    check_ramp(check, &ramp, 0.1, 0.9, 5.5);
    check_moment(check, &ramp, 0.05, 0.0125 / 6.0, 0.125, 5.0);
    check_moment(check, &ramp, 0.5, 0.1 / 6.0 + 1.0, 4.5, 10.0);
    check_moment(check, &ramp, 1.05, 5.0 + 0.0125 / 6.0, 9.875, 5.0);
    check_moment(check, &ramp, 1.1, 5.5, 10.0, 0.0);
}

// 0.125 mm/s at 0.5 mm/s³: half a second up to 0.25 mm/s², and half a second down.
static void a_ramp_may_take_its_time(check_t *check) {
    nck_ramp_t ramp;
    nck_thread_ramp(0.125, 1.0, 0.5, &ramp);
    check_ramp(check, &ramp, 0.5, 0.0, 0.0625);
    check_moment(check, &ramp, 0.5, 0.5 * 0.125 / 6.0, 0.0625, 0.25);
}

static void a_ramp_without_jerk_has_it_all_the_time(check_t *check) {
    nck_ramp_t ramp;
    nck_thread_ramp(10.0, 10.0, 0.0, &ramp);
    check_ramp(check, &ramp, 0.0, 1.0, 5.0);
    check_moment(check, &ramp, 0.5, 1.25, 5.0, 10.0);
    check_moment(check, &ramp, 1.0, 5.0, 10.0, 10.0);
}

static nck_thread_t thread_of(double length, double lead) {
    nck_thread_t thread;
    memset(&thread, 0, sizeof thread);
    thread.length = length;
    thread.lead = lead;
    return thread;
}

// 25 mm along Z, X 3 mm inward beside its own 1 + 2 mm in and out: 6 mm with the pass.
static void the_slowest_axis_bounds_a_pass(check_t *check) {
    double end[NCK_AXIS_MAX] = {-3.0, 0.0, -25.0};
    nck_thread_t thread = thread_of(25.0, 1.5);
    begin(NCK_SLOPE_JERK);
    thread.enter = 1.0;
    thread.leave = 2.0;
    CHECK_NEAR(check, nck_thread_speed_most(&machine, origin, end, &thread), 100.0 / F, NEAR);
    machine.axis[NCK_AXIS_X].v_max = 12.0;
    CHECK_NEAR(check, nck_thread_speed_most(&machine, origin, end, &thread), 50.0 / F, NEAR);
    thread.enter = -3.0;
    thread.leave = 0.0;
    CHECK_NEAR(check, nck_thread_speed_most(&machine, origin, end, &thread), 100.0 / F, NEAR);
}

static nck_tap_t tap_of(double x, double y, double z) {
    nck_tap_t tap;
    memset(&tap, 0, sizeof tap);
    tap.way[0] = x;
    tap.way[1] = y;
    tap.way[2] = z;
    tap.lead = 1.5;
    return tap;
}

// 3, 0, −4: of the way of 5 mm X has 0.6, Z 0.8.
static void the_slowest_axis_bounds_a_tap(check_t *check) {
    const nck_tap_t tap = tap_of(3.0, 0.0, -4.0);
    begin(NCK_SLOPE_JERK);
    CHECK_NEAR(check, nck_tap_speed_most(&machine, &tap), 50.0 / 0.6 / F, NEAR);
    machine.axis[NCK_AXIS_X].v_max = 90.0;
    CHECK_NEAR(check, nck_tap_speed_most(&machine, &tap), 100.0 / 0.8 / F, NEAR);
}

// The time of a ramp of v within a and j, where j alone counts, and its length.
static double time_of(double v, double j) { return 2.0 * sqrt(v / j); }

// 1200 rpm at 1.5 mm: 30 mm/s. The path's 800 and 9000 hold Z, less (1.05)² and (1.05)³.
static void a_pass_runs_in_and_out_as_the_path_may(check_t *check) {
    const double end[NCK_AXIS_MAX] = {0.0, 0.0, -25.0};
    const nck_thread_t thread = thread_of(25.0, 1.5);
    nck_pass_t pass;
    nck_moment_t at;
    begin(NCK_SLOPE_JERK);
    nck_thread_plan(&machine, origin, end, &thread, 1200.0, &pass);
    const double time = time_of(30.0, 9000.0 / (F * F * F));
    CHECK_NEAR(check, pass.way[NCK_AXIS_Z], -1.0, NEAR);
    CHECK_NEAR(check, pass.ramp.a, 800.0 / (F * F), 1e-9);
    CHECK_NEAR(check, pass.ramp.j, 9000.0 / (F * F * F), 1e-9);
    CHECK_NEAR(check, pass.ramp.time, time, NEAR);
    CHECK_NEAR(check, pass.cruise, 25.0 / 30.0 - time, NEAR);
    CHECK_NEAR(check, pass.total, 25.0 / 30.0 + time, NEAR);
    CHECK_NEAR(check, pass.length, 25.0, 0.0);
    CHECK_NEAR(check, pass.enter_s + pass.leave_s, 0.0, 0.0);
    nck_thread_at(&pass, 0.5 * time, &at); // half of the ramp: half of the speed, a third of the
    CHECK_NEAR(check, at.v, 15.0, 1e-9);   // way of that speed in that time
    CHECK_NEAR(check, at.s, 15.0 * 0.5 * time / 3.0, NEAR);
    nck_thread_at(&pass, 0.4, &at);
    CHECK_NEAR(check, at.v, 30.0, 0.0);
    CHECK_NEAR(check, at.s, 30.0 * (0.4 - 0.5 * time), NEAR);
    CHECK_NEAR(check, at.a, 0.0, 0.0);
    nck_thread_at(&pass, pass.total - 0.5 * time, &at);
    CHECK_NEAR(check, at.v, 15.0, 1e-9);
    CHECK_NEAR(check, at.s, 25.0 - 15.0 * 0.5 * time / 3.0, NEAR);
    CHECK_NEAR(check, at.a, -pass.ramp.j * 0.5 * time, 1e-9);
    nck_thread_at(&pass, pass.total + 1.0, &at);
    CHECK_NEAR(check, at.s, 25.0, NEAR);
    CHECK_NEAR(check, at.v, 0.0, NEAR);
}

// Each axis bounds a pass by its share of the way: here X −0.6, beside Z −0.8 of 1. Of a straight
// pass X has all that it can.
static void an_axis_bounds_the_ramp_by_its_share(check_t *check) {
    const double end[NCK_AXIS_MAX] = {-15.0, 0.0, -20.0};
    const nck_thread_t thread = thread_of(25.0, 1.5);
    nck_pass_t pass;
    begin(NCK_SLOPE_JERK);
    nck_thread_plan(&machine, origin, end, &thread, 1200.0, &pass);
    CHECK_NEAR(check, pass.ramp.a, 400.0 / 0.6 / (F * F), 1e-9);
    CHECK_NEAR(check, pass.ramp.j, 4000.0 / 0.6 / (F * F * F), 1e-9);
    begin(NCK_SLOPE_LINEAR);
    nck_thread_plan(&machine, origin, end, &thread, 1200.0, &pass);
    CHECK_NEAR(check, pass.ramp.j, 0.0, 0.0);
    CHECK_NEAR(check, pass.ramp.time, 30.0 / pass.ramp.a, NEAR);
}

// The lead along Z, and the way twice as long as that: X as far as Z, X 1 mm a mm of length.
static void the_path_bounds_the_ramp_by_its_length(check_t *check) {
    const double end[NCK_AXIS_MAX] = {3.0, 0.0, -4.0};
    const nck_thread_t thread = thread_of(4.0, 0.25);
    nck_pass_t pass;
    begin(NCK_SLOPE_JERK);
    machine.path.a_max = 50.0;
    machine.path.j_max = 500.0;
    nck_thread_plan(&machine, origin, end, &thread, 60.0, &pass);
    CHECK_NEAR(check, pass.ramp.v, 0.25, 0.0);
    CHECK_NEAR(check, pass.ramp.a, 50.0 / 1.25 / (F * F), 1e-9); // 5 mm a length of 4
    CHECK_NEAR(check, pass.ramp.j, 500.0 / 1.25 / (F * F * F), 1e-9);
}

// 1 mm from rest to rest at the jerk 4000, −4000, −4000, 4000: T³ = 32 d / j.
static void x_goes_in_and_out_as_it_can(check_t *check) {
    const double end[NCK_AXIS_MAX] = {1.0, 0.0, -25.0};
    nck_thread_t thread = thread_of(25.0, 1.5);
    nck_pass_t pass;
    begin(NCK_SLOPE_JERK);
    thread.enter = -1.0;
    thread.leave = 2.0;
    nck_thread_plan(&machine, origin, end, &thread, 1200.0, &pass);
    const double in = F * cbrt(32.0 / 4000.0), out = F * cbrt(64.0 / 4000.0);
    const double run_out = pass.ramp.time + pass.cruise;
    CHECK_NEAR(check, pass.enter, -1.0, 0.0);
    CHECK_NEAR(check, pass.enter_s, in, 1e-9); // of its cube root
    CHECK_NEAR(check, pass.leave, 2.0, 0.0);
    CHECK_NEAR(check, pass.leave_s, out, 1e-9);
    CHECK_NEAR(check, pass.leave_at, run_out, NEAR);
    CHECK_NEAR(check, pass.total, run_out + out, 1e-9);
    // 8 d / T², 5 % faster, is what it takes of X's 400 mm/s²; what is left changes 2 d / T.
    CHECK_NEAR(check, pass.change[0], (400.0 - 8.0 * F * F / (in * in)) * in / 2.0, 1e-5);
    CHECK_NEAR(check, pass.change[1], (400.0 - 16.0 * F * F / (out * out)) * out / 4.0, 1e-5);
    // Its way: x³·16/3 in the first quarter, and so on.
    const double shares[] = {0.0, 0.125, 0.25, 0.4, 0.5, 0.75, 0.875, 1.0, 1.5};
    const double ways[] = {0.0, 1.0 / 96.0, 1.0 / 12.0, 1.0 / 12.0 + 0.15 + 0.09 - 0.018, 0.5,
                           11.0 / 12.0, 95.0 / 96.0, 1.0, 1.0};
    for (int k = 0; k < 9; k++) {
        CHECK_NEAR(check, nck_thread_beside(&pass, shares[k] * in), -ways[k], 1e-7);
        CHECK_NEAR(check, nck_thread_beside(&pass, run_out + shares[k] * out),
                   -1.0 + 2.0 * ways[k], 1e-7);
    }
}

// Its acceleration alone without jerk: T² = 8 d / (0.8 a); its speed, where that is little.
static void x_is_bound_by_speed_and_acceleration(check_t *check) {
    const double end[NCK_AXIS_MAX] = {-1.0, 0.0, -25.0};
    nck_thread_t thread = thread_of(25.0, 1.5);
    nck_pass_t pass;
    begin(NCK_SLOPE_LINEAR);
    thread.enter = -1.0;
    nck_thread_plan(&machine, origin, end, &thread, 1200.0, &pass);
    CHECK_NEAR(check, pass.enter_s, F * sqrt(8.0 / (EVEN * 400.0)), NEAR);
    CHECK_NEAR(check, pass.leave_s, 0.0, 0.0);
    CHECK_NEAR(check, pass.change[1], 1e30, 0.0); // it does not go out: nothing bounds it
    CHECK_NEAR(check, nck_thread_beside(&pass, 9.0), -1.0, NEAR);
    machine.axis[NCK_AXIS_X].v_max = 5.0;
    nck_thread_plan(&machine, origin, end, &thread, 1200.0, &pass);
    CHECK_NEAR(check, pass.enter_s, 2.0 * F / 5.0, NEAR);
    CHECK_NEAR(check, pass.change[0], (400.0 - 8.0 * F * F / (0.42 * 0.42)) * 0.42 / 2.0, 1e-9);
    machine.axis[NCK_AXIS_X].v_max = 50.0;
    machine.axis[NCK_AXIS_X].a_max = 1e-3; // it needs all of it, and has none left
    nck_thread_plan(&machine, origin, end, &thread, 1200.0, &pass);
    CHECK_NEAR(check, pass.enter_s, F * sqrt(8.0 / (EVEN * 1e-3)), 1e-9);
    CHECK_NEAR(check, pass.total, pass.enter_s, 0.0); // longer than the pass
    CHECK_NEAR(check, pass.change[0], 0.2e-3 * pass.enter_s / 2.0, 1e-9); // a fifth is left
}

// E of a G76: X goes in over 6 mm and out over 9 mm, at 30 mm/s.
static void x_goes_in_and_out_over_what_is_said(check_t *check) {
    const double end[NCK_AXIS_MAX] = {0.0, 0.0, -25.0};
    nck_thread_t thread = thread_of(25.0, 1.5);
    nck_pass_t pass;
    begin(NCK_SLOPE_LINEAR);
    thread.enter = -0.01;
    thread.leave = 0.01;
    thread.entry = 6.0f;
    thread.exit = 9.0f;
    nck_thread_plan(&machine, origin, end, &thread, 1200.0, &pass);
    const double lag = 0.5 * pass.ramp.time; // behind a tool that starts at full speed
    CHECK_NEAR(check, pass.enter_s, 6.0 / 30.0 + lag, NEAR);
    CHECK_NEAR(check, pass.leave_at, 16.0 / 30.0 + lag, NEAR);
    CHECK_NEAR(check, pass.leave_s, 0.3, NEAR);
    CHECK_NEAR(check, pass.total, 25.0 / 30.0 + 2.0 * lag, NEAR);
    thread.entry = 0.5f; // shorter than the run-in: as soon as it can
    thread.exit = 24.9f; // not before the run-in is over
    nck_thread_plan(&machine, origin, end, &thread, 1200.0, &pass);
    CHECK_NEAR(check, pass.enter_s, F * sqrt(0.08 / (EVEN * 400.0)), NEAR);
    CHECK_NEAR(check, pass.leave_at, pass.ramp.time, NEAR);
    CHECK_NEAR(check, pass.leave_s, (double)24.9f / 30.0, NEAR);
}

// Where the pass leads along X, too, X's own motions have half of it, and so has the pass.
static void x_is_shared_where_both_need_it(check_t *check) {
    const double end[NCK_AXIS_MAX] = {-16.0, 0.0, -20.0};
    nck_thread_t thread = thread_of(25.0, 1.5);
    nck_pass_t pass;
    begin(NCK_SLOPE_JERK);
    thread.enter = -1.0;
    nck_thread_plan(&machine, origin, end, &thread, 1200.0, &pass);
    CHECK_NEAR(check, pass.way[NCK_AXIS_X], -0.6, NEAR);
    CHECK_NEAR(check, pass.ramp.a, 200.0 / 0.6 / (F * F), 1e-9);
    CHECK_NEAR(check, pass.enter_s, F * cbrt(32.0 / 2000.0), 1e-9);
    CHECK_NEAR(check, pass.change[0],
               (200.0 - 8.0 * F * F / (pass.enter_s * pass.enter_s)) * pass.enter_s / 2.0, 1e-9);
}

// 600 rpm at 1.5 mm: 15 mm/s. The spindle brakes at 50 rpm/s: 1.25 mm/s² of the tool.
static void a_tap_brakes_as_its_spindle_can(check_t *check) {
    nck_tap_t tap = tap_of(0.0, -30.0, -40.0);
    nck_pass_t pass;
    nck_ramp_t back;
    tap.dwell = 0.25f;
    begin(NCK_SLOPE_JERK);
    nck_tap_plan(&machine, &tap, 600.0, &pass, &back);
    CHECK_NEAR(check, pass.length, 50.0, NEAR);
    CHECK_NEAR(check, pass.way[NCK_AXIS_Y], -0.6, NEAR);
    CHECK_NEAR(check, pass.way[NCK_AXIS_Z], -0.8, NEAR);
    CHECK_NEAR(check, pass.ramp.v, 15.0, NEAR);
    CHECK_NEAR(check, pass.ramp.a, 800.0 / (F * F), 1e-9);
    CHECK_NEAR(check, back.a, pass.ramp.a, 0.0); // a spindle that follows at once
    CHECK_NEAR(check, back.j, pass.ramp.j, 0.0);
    CHECK_NEAR(check, pass.leave_at, 50.0 - back.length, NEAR);
    machine.spindle.a_max_rpm_s = 50.0;
    nck_tap_plan(&machine, &tap, 600.0, &pass, &back);
    const double a = 1.25, j = pass.ramp.j, time = 15.0 / a + a / j;
    CHECK_NEAR(check, back.time, time, 1e-9);
    CHECK_NEAR(check, back.length, 7.5 * time, 1e-9);
    CHECK_NEAR(check, pass.leave_at, 50.0 - 7.5 * time, 1e-9);
    CHECK_NEAR(check, pass.cruise, (50.0 - 7.5 * time - pass.ramp.length) / 15.0, 1e-9);
    CHECK_NEAR(check, pass.total, 2.0 * (pass.ramp.time + pass.cruise + time) + 0.25, 1e-9);
    machine.spindle.a_max_rpm_s = 1e6; // beyond what the axes can
    nck_tap_plan(&machine, &tap, 600.0, &pass, &back);
    CHECK_NEAR(check, back.a, pass.ramp.a, 0.0);
}

int main(void) {
    check_t check = {0};
    CHECK_RUN(&check, a_ramp_that_never_has_its_acceleration);
    CHECK_RUN(&check, a_ramp_that_has_it_for_a_while);
    CHECK_RUN(&check, a_ramp_may_take_its_time);
    CHECK_RUN(&check, a_ramp_without_jerk_has_it_all_the_time);
    if (!NCK_HAS_THREADS) return check_end(&check);
    CHECK_RUN(&check, the_slowest_axis_bounds_a_pass);
    CHECK_RUN(&check, the_slowest_axis_bounds_a_tap);
    CHECK_RUN(&check, a_pass_runs_in_and_out_as_the_path_may);
    CHECK_RUN(&check, an_axis_bounds_the_ramp_by_its_share);
    CHECK_RUN(&check, the_path_bounds_the_ramp_by_its_length);
    CHECK_RUN(&check, x_goes_in_and_out_as_it_can);
    CHECK_RUN(&check, x_is_bound_by_speed_and_acceleration);
    CHECK_RUN(&check, x_goes_in_and_out_over_what_is_said);
    CHECK_RUN(&check, x_is_shared_where_both_need_it);
    CHECK_RUN(&check, a_tap_brakes_as_its_spindle_can);
    return check_end(&check);
}
