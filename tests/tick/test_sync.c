// SPDX-License-Identifier: MIT
// Room 6 alone: a pass, tick by tick, against the place that the spindle's angle says; and stops,
// against the way and the time that the limits of the axes say.
#include <math.h> // ceil fabs fmax sqrt

#include "sync_check.h"

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
    return check_end(&check);
}
