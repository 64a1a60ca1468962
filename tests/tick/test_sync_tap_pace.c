// SPDX-License-Identifier: MIT
// Room 6 alone: taps at any pace of the spindle, and stops that find it slow, beside the angle, or
// about to turn round.
#include <math.h> // fabs fmax fmin

#include "sync_check.h"

#define FASTER 1.05 // than commanded, a spindle may turn

// X 0.6, Z −0.8 of the way: 15 mm/s, and the other axes stand.
static void a_tap_may_lie_across(check_t *check) {
    begin_tap(NCK_SLOPE_JERK);
    seg.shape.tap.way[0] = 18.0;
    seg.shape.tap.way[2] = -24.0;
    seg.start[NCK_AXIS_Y] = 3.0;
    (void)wait_for_begin(check);
    CHECK_NEAR(check, sync.rate * PERIOD, sync.t, 1e-15); // in the first tick, too
    for (double rate = 1.0; rate > 0.3; rate -= 0.2) {
        jump(0.5, rate);
        CHECK_INT(check, tick(), NCK_SYNC_RUNS);
        CHECK_NEAR(check, pose.feed, 15.0, 1e-12);
        CHECK_NEAR(check, pose.v, 15.0 * rate, 1e-9);
        const double s = sync.pass.ramp.length + 15.0 * (sync.t - sync.pass.ramp.time);
        CHECK_NEAR(check, pose.axis[NCK_AXIS_X], 10.0 + 0.6 * s, 1e-9);
        CHECK_NEAR(check, pose.axis[NCK_AXIS_Y], 3.0, 0.0);
        CHECK_NEAR(check, pose.axis[NCK_AXIS_Z], 5.0 - 0.8 * s, 1e-9);
    }
}

// What the axes have, less s″·r² of the run-in behind the worst of the tick, is left to change the
// pace with; inward or outward.
static void check_change(check_t *check, double t, double rate, double faster) {
    nck_moment_t at, far = {0.0, 0.0, 0.0};
    begin_tap(NCK_SLOPE_JERK);
    (void)wait_for_begin(check);
    const nck_ramp_t *const ramp = &sync.pass.ramp;
    const double on = t + (rate < 0.0 ? -1.0 : 1.0) * FASTER * PERIOD;
    if (t < ramp->time) nck_thread_on_ramp(ramp, t, &at);
    else at = (nck_moment_t){0.0, 15.0, 0.0};
    if (on < ramp->time) nck_thread_on_ramp(ramp, fmax(0.0, on), &far);
    sync.stop.rate = rate < 0.0 ? 1.0 : 0.0;
    jump(t, rate);
    sync.was = at.a;
    rpm = faster * 600.0;
    (void)tick();
    const double most = fmax(at.a, far.a), least = fmin(at.a, far.a);
    const double up = 1000.0 - 0.5 * most * (rate * rate + FASTER * FASTER);
    const double down = 1000.0 + 0.5 * least * rate * rate;
    const double change = (faster > rate ? up : -down) / at.v * PERIOD;
    CHECK_NEAR(check, sync.rate, rate + change, 1e-9);
}

static void the_pace_changes_as_the_axes_can(check_t *check) {
    for (double t = 0.02; t < 0.09; t += 0.01) {
        check_change(check, t, 0.01, 4.0);
        check_change(check, t, 0.3, 4.0);
        check_change(check, t, -0.2, -8.0);
        check_change(check, t, -0.9, -0.01);
    }
    begin_tap(NCK_SLOPE_JERK);
    (void)wait_for_begin(check);
    const double end = sync.pass.ramp.time;
    check_change(check, end - 0.0005, 0.3, 0.9);
    check_change(check, end + 0.0005, -0.3, -0.9);
    check_change(check, 0.5, 0.3, 0.9);
    check_change(check, 0.5, 0.3, 0.05);
    check_change(check, 0.5, -0.3, -0.9);
}

// Just in, the spindle turns back by as much again: the tool stands where the hole begins, and the
// tap has not ended there.
static void a_tap_does_not_go_out_before_it_is_in(check_t *check) {
    begin_tap(NCK_SLOPE_JERK);
    (void)wait_for_begin(check);
    tick_for(5);
    rpm = -300.0;
    double least = 0.0;
    for (int k = 0; k < 200; k++) {
        CHECK(check, tick() != NCK_SYNC_ENDS || sync.lost != 0);
        least = fmin(least, gone());
        if (sync.state == NCK_SYNC_NOT) break;
        CHECK(check, sync.t >= 0.0);
    }
    CHECK_INT(check, sync.lost, 1);
    CHECK_NEAR(check, least, 0.0, 0.0);
}

// Nobody measures, and the angle leaps by 5 revolutions: as far as the axis may go, and lost.
static void a_leap_takes_a_tap_no_further_than_its_axis(check_t *check) {
    for (int way = -1; way <= 1; way += 2) {
        begin_tap(NCK_SLOPE_LINEAR);
        machine.axis[NCK_AXIS_Z].min_nm = -27000000; // 2 mm behind the bottom
        (void)wait_for_begin(check);
        jump(way > 0 ? 2.05 : 0.05, 1.0);
        sync.measured = 0;
        for (int k = 0; k < 200 && sync.state == NCK_SYNC_RUNS; k++) {
            sync.turns += way * 0.01;
            (void)nck_sync_tick(&sync, &machine, &seg, &pose);
            CHECK(check, gone() >= 0.0 && gone() <= 32.0 + NEAR);
        }
        CHECK_INT(check, sync.lost, 1);
    }
}

// The tick that begins it: a tap that was stopped has left nothing.
static void nothing_is_left_of_the_tap_before(check_t *check) {
    begin_tap(NCK_SLOPE_LINEAR);
    sync.stop.rate = 1.0;
    sync.stop.size = 0.0;
    sync.slow = 1.0;
    pose.spindle_rpm = 600.0;
    (void)wait_for_begin(check);
    tick_for(300);
    CHECK_NEAR(check, sync.stop.rate, 0.0, 0.0);
    CHECK_NEAR(check, pose.spindle_rpm, 600.0, 0.0);
    nck_sync_turn(&sync, &machine, 600.0);
    sync.slow = 0.001;
    sync.stop.size = 7.0;
    sync.asked = 1;
    CHECK_INT(check, tick(), NCK_SYNC_STOPS);
    CHECK_NEAR(check, sync.stop.size, 1.0, 1e-9);
    CHECK_NEAR(check, sync.slow, 1.0, 1e-9);
}

// It was a tenth of a revolution beside the angle, and stays so: the spindle, which takes its time
// to brake, takes the tool along.
static void a_stop_keeps_in_step_from_where_it_is(check_t *check) {
    begin_tap(NCK_SLOPE_LINEAR);
    pose.spindle_rpm = 600.0;
    (void)wait_for_begin(check);
    for (int k = 0; k < 500; k++) {
        (void)tick();
        nck_sync_turn(&sync, &machine, pose.spindle_rpm);
    }
    turns += 0.1;
    for (int k = 0; k < 5; k++) {
        (void)tick();
        nck_sync_turn(&sync, &machine, pose.spindle_rpm);
    }
    CHECK_INT(check, sync.state, NCK_SYNC_STOPS);
    const double from = gone(), angle = turns;
    uint32_t state = NCK_SYNC_STOPS;
    for (int k = 0; k < 10000 && state == NCK_SYNC_STOPS; k++) {
        rpm += (pose.spindle_rpm - rpm) * 0.02; // 50 ms late
        state = tick();
        nck_sync_turn(&sync, &machine, pose.spindle_rpm);
        CHECK_NEAR(check, gone() - from, (turns - angle) * 1.5, 1e-9);
    }
    CHECK_INT(check, state, NCK_SYNC_ENDS);
}

// As it comes to the bottom, and as it leaves it, the spindle is told less than a millimetre a
// second: it brakes from that, the way it turns.
static void a_stop_at_the_bottom_brakes_the_way_the_spindle_turns(check_t *check) {
    for (int back = 0; back < 2; back++) {
        begin_tap(NCK_SLOPE_LINEAR);
        pose.spindle_rpm = 600.0;
        (void)wait_for_begin(check);
        double told = 600.0;
        for (int k = 0; k < 100000; k++) {
            rpm = pose.spindle_rpm;
            (void)tick();
            told = pose.spindle_rpm;
            nck_sync_turn(&sync, &machine, told);
            if (back ? told < -1.0 : told < 39.0) break;
        }
        CHECK(check, back ? told > -39.0 : told > 1.0);
        sync.asked = 1;
        uint32_t state = NCK_SYNC_RUNS;
        for (int k = 0; k < 10000 && state != NCK_SYNC_ENDS; k++) {
            rpm = pose.spindle_rpm;
            state = tick();
            nck_sync_turn(&sync, &machine, pose.spindle_rpm);
            CHECK(check, back ? pose.spindle_rpm <= 0.0 : pose.spindle_rpm >= 0.0);
            CHECK(check, fabs(pose.spindle_rpm) <= fabs(told) + NEAR);
        }
        CHECK_INT(check, state, NCK_SYNC_ENDS);
    }
}

// On its way out it turns at 0.06 of its speed: by 0.04 it is too slow, 2 ms in 50 ticks.
static void a_spindle_that_hardly_turns_back_loses_the_tap(check_t *check) {
    begin_tap(NCK_SLOPE_LINEAR);
    pose.spindle_rpm = 600.0;
    (void)wait_for_begin(check);
    int ordered = 0;
    for (int k = 0; k < 100000 && ordered < 1200; k++) {
        rpm = pose.spindle_rpm;
        CHECK_INT(check, tick(), NCK_SYNC_RUNS);
        ordered += pose.spindle_rpm < 600.0;
    }
    while (rpm < -61.0) { // the axes follow that
        rpm += 0.6;
        CHECK_INT(check, tick(), NCK_SYNC_RUNS);
    }
    CHECK_INT(check, sync.lost, 0);
    rpm = -36.0;
    int ticks = 0;
    while (sync.lost == 0 && ticks < 1000) {
        (void)tick();
        ticks++;
    }
    CHECK_NEAR(check, ticks, 51.0, 1.0);
}

int main(void) {
    check_t check = {0};
    if (!NCK_HAS_CYCLES) return 0;
    CHECK_RUN(&check, a_tap_may_lie_across);
    CHECK_RUN(&check, the_pace_changes_as_the_axes_can);
    CHECK_RUN(&check, a_tap_does_not_go_out_before_it_is_in);
    CHECK_RUN(&check, a_leap_takes_a_tap_no_further_than_its_axis);
    CHECK_RUN(&check, nothing_is_left_of_the_tap_before);
    CHECK_RUN(&check, a_stop_keeps_in_step_from_where_it_is);
    CHECK_RUN(&check, a_stop_at_the_bottom_brakes_the_way_the_spindle_turns);
    CHECK_RUN(&check, a_spindle_that_hardly_turns_back_loses_the_tap);
    return check_end(&check);
}
