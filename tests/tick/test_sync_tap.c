// SPDX-License-Identifier: MIT
// Room 6 alone: a tap, tick by tick, against the place that the spindle's angle says; stops, and
// spindles that are late, tremble, or do not turn round.
#include <math.h> // fmax fmin pow

#include "sync_check.h"

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
