// SPDX-License-Identifier: MIT
// Room 6 alone: passes whose spindle is not at its command: how X holds their pace, and stops from
// any of it, against the way and the time that the limits of the axes say.
#include <math.h> // ceil fabs sqrt

#include "sync_check.h"

#define FASTER 1.05 // than commanded, a spindle may turn

static const double a_most = 1000.0 / (FASTER * FASTER);
static const double j_most = 10000.0 / (FASTER * FASTER * FASTER);

static void nothing_is_left_of_the_pass_before(check_t *check) {
    begin(NCK_SLOPE_JERK);
    sync.was = 5.0;
    sync.slow = 1.0;
    sync.t = 3.0;
    sync.seen = -1e6;
    CHECK_INT(check, tick(), NCK_SYNC_WAITS);
    CHECK_NEAR(check, sync.was, 0.0, 0.0);
    (void)wait_for_begin(check);
    CHECK_NEAR(check, sync.spin, 1.0, NEAR);
    CHECK(check, sync.t <= FASTER * PERIOD);
    CHECK_INT(check, tick(), NCK_SYNC_RUNS);
    CHECK_INT(check, sync.lost, 0);
}

// X goes in until 0.3 s and out from `leave_at` for 0.3 s, and takes changes of 5 and 3 a second of
// a spindle that turns faster; the axes alone 33.
static void check_change(check_t *check, double t, double leave_at, double change) {
    begin(NCK_SLOPE_JERK);
    (void)wait_for_begin(check);
    sync.pass.enter_s = 0.3;
    sync.pass.leave_at = leave_at;
    sync.pass.leave_s = 0.3;
    sync.pass.change[0] = 5.0;
    sync.pass.change[1] = 3.0;
    jump(t, 0.5);
    rpm = 0.9 * 1200.0;
    CHECK_INT(check, tick(), NCK_SYNC_RUNS);
    CHECK_NEAR(check, sync.rate, 0.5 + change * PERIOD, NEAR);
}

static void the_pace_changes_as_x_can(check_t *check) {
    const double axes = 1000.0 / 30.0;
    const double step = FASTER * PERIOD;
    check_change(check, 0.2, 0.5, 5.0);
    check_change(check, 0.2999, 0.5, 5.0);
    check_change(check, 0.3, 0.5, axes);
    check_change(check, 0.35, 0.5, axes);
    check_change(check, 0.4985, 0.5, axes);
    check_change(check, 0.4985, 0.4985 + step, axes);
    check_change(check, 0.4995, 0.5, 3.0);
    check_change(check, 0.5, 0.5, 3.0);
    check_change(check, 0.7995, 0.5, 3.0);
    check_change(check, 0.5 + 0.3, 0.5, axes);
    check_change(check, 0.25, 0.2, 3.0); // in and out at once
    check_change(check, 0.45, 0.2, 3.0);
}

// Running in, the pass takes s″·r² itself: of 1000 mm/s² that much is left to gain pace with.
static void the_pace_changes_as_the_way_leaves_it(check_t *check) {
    for (double t = 0.01; t < 0.11; t += 0.01) {
        nck_moment_t at, far;
        begin(NCK_SLOPE_JERK);
        (void)wait_for_begin(check);
        nck_thread_at(&sync.pass, t, &at);
        nck_thread_at(&sync.pass, t + FASTER * PERIOD, &far);
        jump(t, 0.5);
        sync.was = at.a;
        rpm = 0.9 * 1200.0;
        (void)tick();
        const double most = fmax(at.a, far.a);
        const double change = (1000.0 - 0.5 * most * (0.25 + FASTER * FASTER)) / at.v;
        CHECK_NEAR(check, sync.rate, fmin(0.5 + change * PERIOD, 0.9), 1e-9);
    }
}

// An encoder that steps to and fro by more than the spindle turns: the tool never goes back.
static void a_tool_never_goes_back(check_t *check) {
    begin(NCK_SLOPE_JERK);
    (void)wait_for_begin(check);
    jump(0.4, 0.12);
    const double mean = rpm;
    double before = sync.t;
    for (int k = 0; k < 200; k++) {
        rpm = mean + (k % 2 ? 0.5 : -0.5) * 1200.0;
        (void)tick();
        CHECK(check, sync.t >= before);
        CHECK(check, pose.v >= 0.0);
        before = sync.t;
    }
    CHECK_INT(check, sync.lost, 0);
    jump(0.4, 0.02); // it turns slowly, and was 0.5 ms ahead
    turns -= 0.01;
    before = sync.t;
    for (int k = 0; k < 10; k++) {
        CHECK_INT(check, tick(), NCK_SYNC_RUNS);
        CHECK(check, sync.t >= before);
        before = sync.t;
    }
    CHECK_NEAR(check, sync.rate, 0.0, 0.0);
}

// Stop at t and a rate. Returns in how many ticks it is at rest, and how far from where it was.
static int stop_at(check_t *check, double t, double rate, double *way) {
    jump(t, rate);
    sync.stop.t = 5.0; // of a stop before
    sync.asked = 1;
    CHECK_INT(check, tick(), NCK_SYNC_STOPS);
    const double from = gone();
    const int ticks = run_out(check, NCK_SYNC_STOPS);
    CHECK_NEAR(check, pose.v, 0.0, 0.0);
    *way = gone() - from;
    return ticks;
}

// The acceleration of then, a·r², goes first, in a·r²/j, for a²/2j more of speed.
static void a_stop_at_any_pace_lets_its_acceleration_go_first(check_t *check) {
    static const double rates[] = {1.0, 0.8, 0.5, 0.2};
    for (int k = 0; k < 4; k++) {
        for (double t = 0.02; t < 0.2; t += 0.02) {
            const double r = rates[k];
            nck_moment_t at;
            double way = 0.0;
            begin(NCK_SLOPE_JERK);
            (void)wait_for_begin(check);
            nck_thread_at(&sync.pass, t + r * PERIOD, &at);
            const int ticks = stop_at(check, t, r, &way);
            const double a = at.a * r * r, ease = a / j_most;
            const double v = at.v * r + 0.5 * a * ease;
            const double time = ease + 2.0 * sqrt(v / j_most);
            CHECK_NEAR(check, sync.stop.ease, ease, 1e-9);
            CHECK_NEAR(check, way, at.v * r * ease + a * ease * ease / 3.0 + v * sqrt(v / j_most),
                       1e-6);
            CHECK_NEAR(check, ticks, ceil(time / PERIOD), 1.0);
        }
    }
}

// A tenth of a millimetre a second, at less than 1 mm/s³.
static void a_slow_pass_with_little_jerk_stops_as_others_do(check_t *check) {
    nck_moment_t at;
    double way = 0.0;
    begin(NCK_SLOPE_JERK);
    machine.path.j_max = 0.9;
    seg.shape.thread.lead = 0.1;
    seg.spin.speed = 60.0;
    rpm = 60.0;
    const double j = 0.9 / (FASTER * FASTER * FASTER);
    while (tick() == NCK_SYNC_WAITS) continue;
    nck_thread_at(&sync.pass, 0.2 + PERIOD, &at);
    (void)stop_at(check, 0.2, 1.0, &way);
    const double ease = at.a / j, v = at.v + 0.5 * at.a * ease;
    CHECK_NEAR(check, sync.stop.ease, ease, 1e-9);
    CHECK_NEAR(check, way, at.v * ease + at.a * ease * ease / 3.0 + v * sqrt(v / j), 1e-6);
}

// Is there room for a ramp of its own? Of the way that is left it needs v²/2a, or v·√(v/j).
static void a_stop_with_no_room_ends_the_pass(check_t *check) {
    for (uint32_t slope = NCK_SLOPE_LINEAR; slope <= NCK_SLOPE_JERK; slope++) {
        for (int near = -1; near <= 1; near += 2) {
            begin(slope);
            (void)wait_for_begin(check);
            const double v = 1.04 * 30.0;
            const double needs = slope == NCK_SLOPE_JERK ? v * sqrt(v / j_most)
                                                         : v * v / 2.0 / a_most;
            const double cruised = 25.0 - needs + near * 0.005 - sync.pass.ramp.length;
            const double t = sync.pass.ramp.time + cruised / 30.0 - 1.04 * PERIOD;
            jump(t, 1.04);
            sync.asked = 1;
            CHECK_INT(check, tick(), NCK_SYNC_STOPS);
            CHECK_INT(check, sync.stop.ease < 0.0, near > 0);
            CHECK_NEAR(check, sync.stop.ease, near > 0 ? -1.0 : 0.0, 1e-12);
        }
    }
    begin(NCK_SLOPE_JERK); // as it still gains speed: 907 mm/s² take 0.105 s, and 5 mm/s more
    seg.end[NCK_AXIS_Z] = -2.5;
    seg.shape.thread.length = 7.5;
    (void)wait_for_begin(check);
    nck_moment_t at;
    const double t = 0.7 * sync.pass.ramp.time;
    nck_thread_at(&sync.pass, t + PERIOD, &at);
    jump(t, 1.0);
    sync.asked = 1;
    (void)tick();
    const double ease = at.a / j_most, v = at.v + 0.5 * at.a * ease;
    const double needs = at.v * ease + at.a * ease * ease / 3.0 + v * sqrt(v / j_most);
    CHECK_INT(check, sync.stop.ease < 0.0, 7.5 - at.s <= needs);
}

// In the run-out a ramp of its own would be a step of acceleration, a·r² in a tick; of a spindle
// that is so slow that it is within j·T, at a rate below √(j·T/a) = 0.098, it is none.
static void a_stop_in_the_run_out_of_a_slow_spindle_has_its_own_ramp(check_t *check) {
    static const double rates[] = {0.03, 0.09, 0.106, 0.2, 0.9};
    for (int k = 0; k < 5; k++) {
        begin(NCK_SLOPE_JERK);
        (void)wait_for_begin(check);
        const double out = sync.pass.ramp.time + sync.pass.cruise;
        jump(out + 0.2 * sync.pass.ramp.time, rates[k]);
        sync.asked = 1;
        CHECK_INT(check, tick(), NCK_SYNC_STOPS);
        CHECK_NEAR(check, sync.stop.ease, rates[k] < 0.098 ? 0.0 : -1.0, 0.0);
        const double from = gone(), v = pose.v;
        if (rates[k] > 0.098) continue;
        (void)run_out(check, NCK_SYNC_STOPS);
        CHECK_NEAR(check, gone() - from, v * sqrt(v / j_most), 1e-9);
        CHECK_NEAR(check, pose.v, 0.0, 0.0);
    }
}

// The stop is over long before X is out: it ends that, and the pass with it.
static void x_goes_out_although_the_tool_stands(check_t *check) {
    for (uint32_t slope = NCK_SLOPE_LINEAR; slope <= NCK_SLOPE_JERK; slope++) {
        for (int in = 0; in < 2; in++) {
            double way = 0.0;
            begin(slope);
            seg.shape.thread.enter = in ? -2.0 : 0.0;
            seg.shape.thread.entry = in ? 18.0f : 0.0f;
            seg.shape.thread.leave = in ? 0.0 : 2.0;
            seg.shape.thread.exit = in ? 0.0f : 18.0f;
            seg.end[NCK_AXIS_X] = in ? 8.0 : 12.0;
            (void)wait_for_begin(check);
            const double swing = in ? sync.pass.enter_s : sync.pass.leave_s;
            const double t = (in ? 0.0 : sync.pass.leave_at) + 0.3 * swing;
            const int ticks = stop_at(check, t, 0.8, &way);
            CHECK_NEAR(check, pose.axis[NCK_AXIS_X], seg.end[NCK_AXIS_X], 1e-9);
            CHECK_NEAR(check, ticks, 0.7 * swing / 0.8 / PERIOD, 2.0);
            CHECK(check, gone() < 24.0);
        }
    }
}

// A spindle as good as stands: X lets its pace go, 2·d/T at that rate, of the faster swing.
static void check_fade(check_t *check, double enter, double leave, double a_x) {
    begin(NCK_SLOPE_JERK);
    seg.shape.thread.enter = enter;
    seg.shape.thread.entry = enter != 0.0 ? 18.0f : 0.0f;
    seg.shape.thread.leave = leave;
    seg.shape.thread.exit = leave != 0.0 ? 12.0f : 0.0f;
    seg.end[NCK_AXIS_X] = 10.0 + enter + leave;
    (void)wait_for_begin(check);
    double v = 0.0;
    if (enter != 0.0) v = 2.0 * fabs(enter) / sync.pass.enter_s;
    if (leave != 0.0) v = fmax(v, 2.0 * fabs(leave) / sync.pass.leave_s);
    machine.axis[NCK_AXIS_X].a_max = a_x;
    const double t = 0.3 * (enter != 0.0 ? sync.pass.enter_s : sync.pass.leave_s)
                     + (enter != 0.0 ? 0.0 : sync.pass.leave_at);
    jump(t, 0.06);
    sync.asked = 1;
    CHECK_INT(check, tick(), NCK_SYNC_STOPS);
    const double fade = fmax(1.5 * v * 0.06 / a_x, sqrt(6.0 * v * 0.06 / 10000.0));
    CHECK_NEAR(check, sync.stop.fade, fade, 1e-9);
    const double from = sync.t;
    const int ticks = run_out(check, NCK_SYNC_STOPS);
    const double ramp = 2.0 * sqrt(30.0 * 0.06 / j_most);
    CHECK(check, ticks <= fmax(fade, ramp) / PERIOD + 2.0); // X stands where it has come to
    CHECK_NEAR(check, sync.t - from, 0.5 * 0.06 * fade, 0.06 * PERIOD);
    CHECK_NEAR(check, pose.axis[NCK_AXIS_X], 10.0 + nck_thread_beside(&sync.pass, sync.t), 1e-9);
}

static void x_stands_with_a_spindle_that_stands(check_t *check) {
    check_fade(check, 0.0, 0.0, 1000.0);
    check_fade(check, -0.5, 0.0, 1000.0);
    check_fade(check, 0.0, 0.15, 1000.0);
    check_fade(check, -0.5, 0.25, 1000.0);
    check_fade(check, -0.5, 2.0, 1000.0);
    check_fade(check, -0.5, 2.0, 1.0);
}

int main(void) {
    check_t check = {0};
    if (!NCK_HAS_CYCLES) return 0;
    CHECK_RUN(&check, nothing_is_left_of_the_pass_before);
    CHECK_RUN(&check, the_pace_changes_as_x_can);
    CHECK_RUN(&check, the_pace_changes_as_the_way_leaves_it);
    CHECK_RUN(&check, a_tool_never_goes_back);
    CHECK_RUN(&check, a_stop_at_any_pace_lets_its_acceleration_go_first);
    CHECK_RUN(&check, a_slow_pass_with_little_jerk_stops_as_others_do);
    CHECK_RUN(&check, a_stop_with_no_room_ends_the_pass);
    CHECK_RUN(&check, a_stop_in_the_run_out_of_a_slow_spindle_has_its_own_ramp);
    CHECK_RUN(&check, x_goes_out_although_the_tool_stands);
    CHECK_RUN(&check, x_stands_with_a_spindle_that_stands);
    return check_end(&check);
}
