// SPDX-License-Identifier: MIT
// Room 6 alone: a pass and a tap, tick by tick, against the place that the spindle's angle says;
// and stops, against the way and the time that the limits of the axes say.
#include <math.h>   // ceil fabs floor fmax pow sqrt
#include <string.h> // memset

#include "check.h"
#include "nck/tick/6_interpolate/sync.h" // nck_sync_tick

#define PERIOD 1e-3
#define NEAR 1e-9 // [mm] of sums over some thousand ticks

static nck_machine_t machine;
static nck_sync_t sync;
static nck_seg_t seg;
static nck_pose_t pose;
static double turns; // of the spindle, as measured
static double rpm;   // at which it turns

// 25 mm along Z at a lead of 1.5 mm and 1200 rpm, 30 mm/s: in the ninth part of a revolution from
// where the spindle is.
static void begin(uint32_t slope) {
    nck_machine_default(&machine);
    machine.slope = slope;
    machine.period_s = PERIOD;
    memset(&sync, 0, sizeof sync);
    memset(&seg, 0, sizeof seg);
    memset(&pose, 0, sizeof pose);
    seg.kind = NCK_SEG_THREAD;
    seg.start[NCK_AXIS_X] = 10.0;
    seg.end[NCK_AXIS_X] = 10.0;
    seg.start[NCK_AXIS_Z] = 5.0;
    seg.end[NCK_AXIS_Z] = -20.0;
    seg.spin.speed = 1200.0;
    seg.shape.thread.length = 25.0;
    seg.shape.thread.lead = 1.5;
    seg.shape.thread.turn = 0.25f;
    turns = 7.1;
    rpm = 1200.0;
}

// A hole of 30 mm at 600 rpm and 1.5 mm: 15 mm/s.
static void begin_tap(uint32_t slope) {
    begin(slope);
    memcpy(seg.end, seg.start, sizeof seg.end);
    seg.kind = NCK_SEG_TAP;
    seg.spin.speed = 600.0;
    rpm = 600.0;
    memset(&seg.shape, 0, sizeof seg.shape);
    seg.shape.tap.way[2] = -30.0;
    seg.shape.tap.lead = 1.5;
}

static uint32_t tick(void) {
    turns += rpm / 60.0 * PERIOD;
    nck_sync_measure(&sync, turns);
    return nck_sync_tick(&sync, &machine, &seg, &pose);
}

static double fraction(double x) { return x - floor(x); }

// Tick until the pass runs. Returns how many ticks it has waited.
static int wait_for_begin(check_t *check) {
    int ticks = 0;
    while (tick() == NCK_SYNC_WAITS && ticks < 1000) {
        CHECK_INT(check, pose.state, NCK_TICK_DWELL);
        ticks++;
    }
    CHECK_INT(check, sync.state, NCK_SYNC_RUNS);
    CHECK_INT(check, pose.state, NCK_TICK_MOVE);
    return ticks;
}

static void tick_for(int ticks) {
    for (int k = 0; k < ticks; k++) (void)tick();
}

// How far it is along Z.
static double gone(void) { return seg.start[NCK_AXIS_Z] - pose.axis[NCK_AXIS_Z]; }

// Tick until the end. Returns the ticks; the state is `state` until then.
static int run_out(check_t *check, uint32_t state) {
    int ticks = 1;
    while (tick() != NCK_SYNC_ENDS && ticks < 100000) {
        if (sync.state != state) CHECK_INT(check, sync.state, state);
        ticks++;
    }
    CHECK_INT(check, sync.state, NCK_SYNC_NOT);
    return ticks;
}

static void a_pass_is_where_the_angle_says(check_t *check) {
    for (uint32_t slope = NCK_SLOPE_LINEAR; slope <= NCK_SLOPE_JERK; slope++) {
        nck_moment_t at;
        begin(slope);
        const double from = turns;
        const int ticks = wait_for_begin(check);
        CHECK(check, ticks < 50); // a turn
        CHECK(check, sync.begin > from && sync.begin <= from + 1.02);
        const double total = sync.pass.total;
        int runs = 0;
        while (sync.state == NCK_SYNC_RUNS && tick() == NCK_SYNC_RUNS) {
            const double t = (turns - sync.begin) / 20.0;
            nck_thread_at(&sync.pass, t, &at);
            CHECK_NEAR(check, gone(), at.s, NEAR);
            CHECK_NEAR(check, pose.v, at.v, 1e-6);
            CHECK_NEAR(check, pose.feed, 30.0, NEAR);
            CHECK_NEAR(check, pose.axis[NCK_AXIS_X], 10.0, 0.0);
            if (gone() > 2.0 && gone() < 22.0) {
                CHECK_NEAR(check, fraction(turns - gone() / 1.5), 0.25, NEAR);
            }
            runs++;
        }
        CHECK_NEAR(check, runs + 1, total / PERIOD, 1.0);
        CHECK_NEAR(check, pose.axis[NCK_AXIS_Z], -20.0, 0.0);
        CHECK_INT(check, sync.lost, 0);
    }
}

// Nobody measures: the spindle turns as it is commanded, from the angle that it has.
static void without_an_encoder_the_command_counts(check_t *check) {
    begin(NCK_SLOPE_JERK);
    nck_sync_turn(&sync, &machine, 600.0);
    nck_sync_turn(&sync, &machine, 600.0);
    nck_sync_turn(&sync, &machine, 1200.0);
    CHECK_NEAR(check, sync.turns, 0.02, 1e-15); // two periods at 600 rpm
    int ticks = 0;
    while (nck_sync_tick(&sync, &machine, &seg, &pose) == NCK_SYNC_WAITS && ticks < 1000) {
        nck_sync_turn(&sync, &machine, 1200.0);
        ticks++;
    }
    CHECK_NEAR(check, sync.turns, 0.02 + 0.02 * (ticks + 1), 1e-12);
    for (int k = 0; k < 300; k++) {
        nck_sync_turn(&sync, &machine, 1200.0);
        CHECK_INT(check, nck_sync_tick(&sync, &machine, &seg, &pose), NCK_SYNC_RUNS);
    }
    CHECK_NEAR(check, fraction(sync.turns - gone() / 1.5), 0.25, NEAR);
    CHECK_INT(check, sync.lost, 0);
}

static void an_angle_beyond_all_turns_is_none(check_t *check) {
    begin(NCK_SLOPE_JERK);
    nck_sync_measure(&sync, 0.999e12);
    CHECK_NEAR(check, sync.turns, 0.999e12, 0.0);
    nck_sync_measure(&sync, 1e12);
    nck_sync_measure(&sync, -1e12);
    nck_sync_measure(&sync, (double)NAN);
    CHECK_NEAR(check, sync.turns, 0.999e12, 0.0);
    nck_sync_measure(&sync, -0.999e12);
    CHECK_NEAR(check, sync.turns, -0.999e12, 0.0);
}

static void what_waits_is_held_and_stopped_before_it_cuts(check_t *check) {
    begin(NCK_SLOPE_JERK);
    sync.held = 1;
    for (int k = 0; k < 200; k++) {
        CHECK_INT(check, tick(), NCK_SYNC_WAITS);
        CHECK_INT(check, pose.state, NCK_TICK_HOLD);
        CHECK(check, sync.begin > turns - 0.021 && sync.begin <= turns + 1.0);
    }
    sync.asked = 1;
    CHECK_INT(check, tick(), NCK_SYNC_ENDS);
    CHECK_INT(check, pose.state, NCK_TICK_HOLD);
    CHECK_INT(check, sync.state, NCK_SYNC_NOT);
    CHECK_INT(check, sync.lost, 0);
}

// v²/2a from the tick on in which it was asked, and v/a of time.
static void a_stop_takes_the_way_that_its_deceleration_needs(check_t *check) {
    begin(NCK_SLOPE_LINEAR);
    (void)wait_for_begin(check);
    tick_for(300);
    const double a = 1000.0 / (1.05 * 1.05);
    sync.asked = 1;
    CHECK_INT(check, tick(), NCK_SYNC_STOPS);
    CHECK_INT(check, pose.state, NCK_TICK_HOLD);
    CHECK_INT(check, sync.lost, 1);
    const double from = gone();
    CHECK_NEAR(check, pose.v, 30.0, 1e-6);
    for (int k = 1; k <= 33; k++) {
        CHECK_INT(check, tick(), NCK_SYNC_STOPS);
        CHECK_INT(check, pose.state, NCK_TICK_HOLD);
        CHECK_NEAR(check, pose.v, 30.0 - a * PERIOD * k, 1e-6);
        CHECK_NEAR(check, gone() - from, 0.03 * k - 0.5 * a * (PERIOD * k) * (PERIOD * k), 1e-7);
    }
    CHECK_INT(check, tick(), NCK_SYNC_ENDS);
    CHECK_NEAR(check, pose.v, 0.0, 0.0);
    CHECK_NEAR(check, gone() - from, 450.0 / a, 1e-7);
}

// In the run-in it still gains speed: the acceleration a goes first, in a/j, for a²/2j more.
static void a_stop_in_the_run_in_lets_its_acceleration_go_first(check_t *check) {
    for (int after = 5; after < 110; after += 9) {
        nck_moment_t at;
        begin(NCK_SLOPE_JERK);
        (void)wait_for_begin(check);
        tick_for(after);
        sync.asked = 1;
        CHECK_INT(check, tick(), NCK_SYNC_STOPS);
        nck_thread_at(&sync.pass, (turns - sync.begin) / 20.0, &at);
        const double from = gone(), j = sync.pass.ramp.j, ease = at.a / j;
        const double v = at.v + 0.5 * at.a * ease;
        const double way = at.v * ease + at.a * ease * ease / 3.0 + v * sqrt(v / j);
        double speed = pose.v, most = 0.0;
        const double time = ease + 2.0 * sqrt(v / j);
        int ticks = 1;
        while (tick() == NCK_SYNC_STOPS && ticks < 1000) {
            most = fmax(most, fabs(pose.v - speed));
            speed = pose.v;
            ticks++;
        }
        CHECK_NEAR(check, from, at.s, NEAR);
        CHECK_NEAR(check, gone() - from, way, 1e-6);
        CHECK_NEAR(check, ticks, ceil(time / PERIOD), 0.0);
        CHECK(check, most <= fmax(at.a, sqrt(v * j)) * PERIOD * (1.0 + 1e-6));
    }
}

// No room is left for more: the pass ends as planned.
static void a_stop_in_the_run_out_is_the_run_out(check_t *check) {
    for (uint32_t slope = NCK_SLOPE_LINEAR; slope <= NCK_SLOPE_JERK; slope++) {
        begin(slope);
        (void)wait_for_begin(check);
        const double total = sync.pass.total;
        const int near = (int)((total - 0.5 * sync.pass.ramp.time) / PERIOD);
        tick_for(near);
        sync.asked = 1;
        CHECK_INT(check, tick(), NCK_SYNC_STOPS);
        const int ticks = run_out(check, NCK_SYNC_STOPS);
        CHECK_NEAR(check, near + 1 + ticks, total / PERIOD, 1.0);
        CHECK_NEAR(check, pose.axis[NCK_AXIS_Z], -20.0, 1e-6);
        CHECK_INT(check, sync.lost, 1);
    }
}

// X goes in 1 mm in the beginning and out 2 mm in the end: what it has begun it ends, and what it
// has not it does not begin.
static void x_ends_what_it_has_begun(check_t *check) {
    static const double places[] = {0.05, 0.4, 0.95};
    for (int k = 0; k < 3; k++) {
        begin(NCK_SLOPE_JERK);
        seg.shape.thread.enter = -1.0;
        seg.shape.thread.leave = 2.0;
        seg.shape.thread.exit = 6.0f;
        seg.end[NCK_AXIS_X] = 11.0;
        (void)wait_for_begin(check);
        tick_for((int)(places[k] * sync.pass.total / PERIOD));
        const int leaves = sync.t > sync.pass.leave_at;
        CHECK_INT(check, leaves, k == 2);
        sync.asked = 1;
        CHECK_INT(check, tick(), NCK_SYNC_STOPS);
        (void)run_out(check, NCK_SYNC_STOPS);
        CHECK_NEAR(check, pose.axis[NCK_AXIS_X], leaves ? 11.0 : 9.0, 1e-6);
    }
}

static void a_spindle_that_leaps_or_stalls_loses_the_thread(check_t *check) {
    static const double leaps[] = {0.03, -0.03, 0.2, -3.0}; // 0.04 revolutions are 2 ms
    for (int k = 0; k < 4; k++) {
        begin(NCK_SLOPE_JERK);
        (void)wait_for_begin(check);
        tick_for(200);
        turns += leaps[k];
        tick_for(40);
        CHECK_INT(check, sync.lost, fabs(leaps[k]) > 0.04);
    }
    begin(NCK_SLOPE_JERK);
    (void)wait_for_begin(check);
    tick_for(200);
    rpm = 0.0;
    tick_for(2); // 2 ms behind
    CHECK_INT(check, sync.lost, 0);
    tick_for(1);
    CHECK_INT(check, sync.lost, 1);
}

// An even slower spindle is followed to a tenth of its speed; from 2 ms behind that on it is lost,
// and X lets its pace go instead of going on.
static void a_spindle_that_slows_down_is_followed_to_a_tenth(check_t *check) {
    begin(NCK_SLOPE_JERK);
    (void)wait_for_begin(check);
    tick_for(150);
    for (int k = 0; k < 1000 && rpm > 132.0; k++) {
        rpm -= 1.2;
        CHECK_INT(check, tick(), NCK_SYNC_RUNS);
    }
    CHECK_NEAR(check, pose.v, 30.0 * rpm / 1200.0, 0.05);
    tick_for(200);
    CHECK_INT(check, sync.lost, 0);
    int ticks = 0;
    rpm = 60.0; // half of a tenth: 2 ms in 40 ticks
    while (sync.lost == 0 && ticks < 1000) {
        (void)tick();
        ticks++;
    }
    CHECK_NEAR(check, ticks, 41.0, 1.0);
    CHECK(check, sync.stop.fade >= 0.0);
    const double from = gone(), v = pose.v;
    (void)run_out(check, NCK_SYNC_STOPS);
    CHECK_NEAR(check, gone() - from, v * sqrt(v / sync.pass.ramp.j), 0.02 * v);
}

// X is on its way in, 1 mm in T, as the spindle slows down to half of a tenth: its pace of 2/T, at
// that rate, goes by a cubic of y = t/fade whose steepest part takes all that X has.
static void x_lets_its_pace_go_with_a_spindle_that_stops(check_t *check) {
    for (int k = 0; k < 3; k++) {
        begin(NCK_SLOPE_JERK);
        seg.shape.thread.enter = -1.0;
        seg.shape.thread.entry = 20.0f;
        seg.end[NCK_AXIS_X] = 9.0;
        if (k == 2) { // it would go out faster
            seg.shape.thread.leave = 2.0;
            seg.end[NCK_AXIS_X] = 11.0;
        }
        (void)wait_for_begin(check);
        tick_for(200);
        while (rpm > 60.0) {
            rpm -= 1.2;
            (void)tick();
        }
        if (k == 1) machine.axis[NCK_AXIS_X].a_max = 1.0; // it counts beside the jerk
        for (int n = 0; n < 1000 && sync.lost == 0; n++) (void)tick();
        const double v = k == 2 ? 4.0 / sync.pass.leave_s : 2.0 / sync.pass.enter_s;
        const double rate = sync.stop.rate;
        const double fade = k == 1 ? 1.5 * v * rate : sqrt(6.0 * v * rate / 10000.0);
        CHECK(check, rate > 0.04 && rate < 0.1);
        CHECK_NEAR(check, sync.stop.fade, fade, 1e-12);
        double t = sync.t;
        for (int n = 1; n < 400; n++) {
            const double y = PERIOD * n / fade;
            if (tick() == NCK_SYNC_ENDS) break;
            t += y < 1.0 ? rate * (1.0 - 3.0 * y * y + 2.0 * y * y * y) * PERIOD : 0.0;
            CHECK_NEAR(check, sync.t, t, 1e-12);
            CHECK_NEAR(check, pose.axis[NCK_AXIS_X], 10.0 + nck_thread_beside(&sync.pass, t),
                       1e-9);
        }
    }
}

// ---- taps

// In: as the spindle turns. Its command is 600 rpm until it is to brake, 0 at the bottom.
static void a_tap_goes_in_and_out_with_the_spindle(check_t *check) {
    for (uint32_t slope = NCK_SLOPE_LINEAR; slope <= NCK_SLOPE_JERK; slope++) {
        double bottom = 0.0, told = 600.0, before = 0.0, least = 0.0;
        int ticks = 0, rests = 0;
        begin_tap(slope);
        seg.shape.tap.dwell = 0.25f;
        pose.spindle_rpm = 600.0;
        (void)wait_for_begin(check);
        const double total = sync.pass.total;
        uint32_t state = NCK_SYNC_RUNS;
        while (state == NCK_SYNC_RUNS && ticks < 100000) {
            before = gone();
            rpm = pose.spindle_rpm; // it turns as it is told
            state = tick();
            bottom = fmax(bottom, gone());
            least = fmin(least, pose.spindle_rpm);
            rests += gone() == before;
            ticks++;
            if (gone() > 1.0 && told > 0.0) {
                const double lag = sync.pass.ramp.v * sync.pass.ramp.time
                                   - sync.pass.ramp.length;
                CHECK_NEAR(check, gone(), (turns - sync.begin) * 1.5 - lag, 1e-6);
            }
            told = pose.spindle_rpm;
        }
        CHECK_INT(check, state, NCK_SYNC_ENDS);
        CHECK_NEAR(check, bottom, 30.0, 1e-3);
        CHECK_NEAR(check, least, -600.0, 1e-6);
        CHECK_NEAR(check, rests, 0.25 / PERIOD, 2.0);
        CHECK_NEAR(check, ticks, total / PERIOD, 3.0);
        CHECK_NEAR(check, pose.axis[NCK_AXIS_Z], 5.0, 0.0);
        CHECK_NEAR(check, pose.v, 0.0, 0.0);
        CHECK_INT(check, sync.state, NCK_SYNC_NOT);
        CHECK_INT(check, sync.lost, 0);
    }
}

// As far as the first of the axes may go: from the start at 15 mm/s, less what the ramp lags.
static void check_reach(check_t *check, double x, double y, double z, double most) {
    begin_tap(NCK_SLOPE_LINEAR);
    for (int k = 0; k < 3; k++) {
        machine.axis[k].min_nm = -40000000;
        machine.axis[k].max_nm = 60000000;
    }
    seg.shape.tap.way[0] = x;
    seg.shape.tap.way[1] = y;
    seg.shape.tap.way[2] = z;
    (void)tick();
    const nck_ramp_t *const ramp = &sync.pass.ramp;
    CHECK_NEAR(check, sync.pass.enter_s, ramp->time + (most - ramp->length) / 15.0, NEAR);
}

static void a_late_spindle_may_drive_a_tap_to_the_end_of_the_travel(check_t *check) {
    check_reach(check, 0.0, 0.0, -30.0, 45.0); // from 5 to -40
    check_reach(check, 0.0, 0.0, 30.0, 55.0);  // from 5 to 60
    check_reach(check, 30.0, 0.0, 0.0, 50.0);  // from 10 to 60
    check_reach(check, -30.0, 0.0, 0.0, 50.0); // from 10 to -40
    check_reach(check, 0.0, 30.0, 0.0, 60.0);
    check_reach(check, 0.0, -30.0, 0.0, 40.0);
    check_reach(check, 18.0, 0.0, -24.0, 56.25); // X 0.6, Z -0.8: Z ends first, 45/0.8
    check_reach(check, 24.0, 18.0, 0.0, 62.5);   // X 0.8: 50/0.8
    check_reach(check, 0.0, 0.0, -45.0, 45.0);   // the bottom is the end
}

// 0.08 of its speed lacks 0.02 of a tenth's slack a tick: 2 ms in 100 ticks of 1 ms.
static void a_spindle_that_hardly_turns_loses_the_tap(check_t *check) {
    begin_tap(NCK_SLOPE_JERK);
    pose.spindle_rpm = 600.0;
    (void)wait_for_begin(check);
    tick_for(200);
    while (rpm > 66.0) {
        rpm -= 0.6;
        CHECK_INT(check, tick(), NCK_SYNC_RUNS);
    }
    tick_for(300);
    CHECK_INT(check, sync.lost, 0);
    int ticks = 0;
    rpm = 48.0;
    while (sync.lost == 0 && ticks < 1000) {
        (void)tick();
        ticks++;
    }
    CHECK_NEAR(check, ticks, 101.0, 1.0);
}

// On the way out the spindle turns back: it brakes from that, and the tool goes on outward.
static void a_tap_that_is_stopped_on_its_way_out_goes_on_outward(check_t *check) {
    begin_tap(NCK_SLOPE_LINEAR);
    pose.spindle_rpm = 600.0;
    (void)wait_for_begin(check);
    double deepest = 0.0;
    for (int k = 0; k < 100000 && gone() > deepest - 10.0; k++) {
        rpm = pose.spindle_rpm;
        (void)tick();
        nck_sync_turn(&sync, &machine, pose.spindle_rpm);
        deepest = fmax(deepest, gone());
    }
    CHECK_NEAR(check, pose.spindle_rpm, -600.0, 1e-6);
    const double from = gone(), a = 1000.0 / (1.05 * 1.05);
    uint32_t state = NCK_SYNC_RUNS;
    sync.asked = 1;
    for (int k = 0; k < 10000 && state != NCK_SYNC_ENDS; k++) {
        rpm = pose.spindle_rpm;
        state = tick();
        nck_sync_turn(&sync, &machine, pose.spindle_rpm);
        CHECK(check, pose.spindle_rpm <= 0.0);
    }
    CHECK_INT(check, state, NCK_SYNC_ENDS);
    CHECK_INT(check, sync.state, NCK_SYNC_NOT);
    CHECK_NEAR(check, pose.v, 0.0, 0.0);
    CHECK_NEAR(check, from - gone(), 2.0 * 15.0 * PERIOD + 112.5 / a, 0.016);
}

// An encoder that steps to and fro by 0.01 of the speed: the mean of n ticks, p = T/0.5 s, is
// (1 − p)ⁿ, and the mean of its size (1 + n·p)·(1 − p)ⁿ. It stands where that is below 0.005.
static void a_spindle_that_only_trembles_stands(check_t *check) {
    begin_tap(NCK_SLOPE_LINEAR);
    pose.spindle_rpm = 600.0;
    (void)wait_for_begin(check);
    for (int k = 0; k < 500; k++) {
        (void)tick();
        nck_sync_turn(&sync, &machine, pose.spindle_rpm);
    }
    sync.asked = 1;
    int ticks = 0, want = 0;
    uint32_t state = NCK_SYNC_RUNS;
    while (state != NCK_SYNC_ENDS && ticks < 10000) {
        state = tick();
        nck_sync_turn(&sync, &machine, pose.spindle_rpm);
        const double trembles = ticks % 2 ? 6.0 : -6.0;
        rpm = pose.spindle_rpm > 0.0 ? pose.spindle_rpm : trembles;
        ticks++;
    }
    const double p = PERIOD / 0.5;
    while ((1.0 + p * want) * pow(1.0 - p, want) >= 5e-3) want++;
    CHECK_NEAR(check, ticks, want, 0.03 * want); // while it brakes it still turns
}

// Asked, the spindle brakes from what it was told; the tool stays in step until it stands.
static void a_tap_that_is_stopped_stays_in_step(check_t *check) {
    begin_tap(NCK_SLOPE_LINEAR);
    pose.spindle_rpm = 600.0;
    (void)wait_for_begin(check);
    for (int k = 0; k < 500; k++) {
        (void)tick();
        nck_sync_turn(&sync, &machine, pose.spindle_rpm);
    }
    const double from = gone(), a = 1000.0 / (1.05 * 1.05);
    uint32_t state = NCK_SYNC_RUNS;
    int ticks = 0;
    sync.asked = 1;
    while (state != NCK_SYNC_ENDS && ticks < 10000) {
        state = tick();
        nck_sync_turn(&sync, &machine, pose.spindle_rpm);
        rpm = pose.spindle_rpm;
        if (state != NCK_SYNC_ENDS) CHECK_INT(check, pose.state, NCK_TICK_HOLD);
        ticks++;
    }
    CHECK_INT(check, sync.lost, 1);
    CHECK_NEAR(check, rpm, 0.0, 1e-6);
    CHECK_NEAR(check, gone() - from, 15.0 * PERIOD + 112.5 / a, 1e-3); // the tick, and v²/2a
    CHECK_NEAR(check, pose.v, 0.0, 0.0);
}

// The spindle turns on instead of back: lost, a second and the braking behind the order. The tool
// goes no further than the axis may.
static void a_tap_whose_spindle_ignores_its_order_is_lost(check_t *check) {
    begin_tap(NCK_SLOPE_LINEAR);
    machine.axis[NCK_AXIS_Z].min_nm = -27000000; // 2 mm behind the bottom
    pose.spindle_rpm = 600.0;
    (void)wait_for_begin(check);
    double deepest = 0.0;
    int ordered = 0, ticks = 0;
    while (sync.lost == 0 && ticks < 100000) {
        (void)tick();
        deepest = fmax(deepest, gone());
        ordered += pose.spindle_rpm < 600.0;
        ticks++;
    }
    CHECK(check, deepest <= 32.0 + NEAR);
    CHECK(check, ordered > 0);
    tick_for(2000);
    CHECK(check, gone() <= 32.0 + NEAR);
}

// It turns on, and there is room for it: twice the ramp, the rest and a second it may take to turn
// round, and then is 2 ms late in two ticks more.
static void a_spindle_has_a_second_to_turn_round(check_t *check) {
    begin_tap(NCK_SLOPE_LINEAR);
    seg.shape.tap.dwell = 0.5f;
    pose.spindle_rpm = 600.0;
    (void)wait_for_begin(check);
    int ordered = 0;
    for (int k = 0; k < 100000 && sync.lost == 0; k++) {
        (void)tick();
        ordered += pose.spindle_rpm < 600.0;
    }
    CHECK_NEAR(check, ordered, (2.0 * 15.0 * 1.05 * 1.05 / 1000.0 + 1.5) / PERIOD + 2.0, 2.0);
}

int main(void) {
    check_t check = {0};
    if (!NCK_HAS_CYCLES) return 0;
    CHECK_RUN(&check, a_pass_is_where_the_angle_says);
    CHECK_RUN(&check, without_an_encoder_the_command_counts);
    CHECK_RUN(&check, an_angle_beyond_all_turns_is_none);
    CHECK_RUN(&check, what_waits_is_held_and_stopped_before_it_cuts);
    CHECK_RUN(&check, a_stop_takes_the_way_that_its_deceleration_needs);
    CHECK_RUN(&check, a_stop_in_the_run_in_lets_its_acceleration_go_first);
    CHECK_RUN(&check, a_stop_in_the_run_out_is_the_run_out);
    CHECK_RUN(&check, x_ends_what_it_has_begun);
    CHECK_RUN(&check, a_spindle_that_leaps_or_stalls_loses_the_thread);
    CHECK_RUN(&check, a_spindle_that_slows_down_is_followed_to_a_tenth);
    CHECK_RUN(&check, x_lets_its_pace_go_with_a_spindle_that_stops);
    CHECK_RUN(&check, a_tap_goes_in_and_out_with_the_spindle);
    CHECK_RUN(&check, a_late_spindle_may_drive_a_tap_to_the_end_of_the_travel);
    CHECK_RUN(&check, a_spindle_that_hardly_turns_loses_the_tap);
    CHECK_RUN(&check, a_tap_that_is_stopped_on_its_way_out_goes_on_outward);
    CHECK_RUN(&check, a_spindle_that_only_trembles_stands);
    CHECK_RUN(&check, a_tap_that_is_stopped_stays_in_step);
    CHECK_RUN(&check, a_tap_whose_spindle_ignores_its_order_is_lost);
    CHECK_RUN(&check, a_spindle_has_a_second_to_turn_round);
    return check_end(&check);
}
