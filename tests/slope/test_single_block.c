// SPDX-License-Identifier: MIT
// The operator is heard on the way to a block's end, where single block has planned a rest: hold,
// abort and overrides act as they do without it, and the rest at the block's end stays. A slow
// preparation hears him later, but before the path rests.
#include "motion_check.h"

// Ticks until a brake begins. In a short window the speed is never steady.
enum { HEARD = NCK_PROFILE < 256 ? 30 : 10, SWITCHED_ON = 100, LONG_RUN = 40000 };

static motion_t motion;

// A block that the plan sees the end of in every capacity, and one behind it.
static void begin(uint32_t tick)
{
    motion_begin(&motion, 1);
    motion.machine.slope = NCK_SLOPE_JERK;
    motion_line(&motion, "G21 G90 G61 G1 F1500 X20");
    motion_line(&motion, "Y10");
    motion_line(&motion, "M2");
    motion.status = motion_start(&motion);
    while (motion.ticks < tick && motion_tick(&motion, NULL)) {
        if (motion.ticks == SWITCHED_ON) nck_set_single_block(&motion.nck, 1);
    }
}

static int rests(void)
{
    const double *const s = motion.s;
    return s[3] == s[2] && s[2] == s[1];
}

// Ticks until the path rests.
static uint32_t ticks_to_rest(void)
{
    uint32_t ticks = 0;
    do {
        (void)motion_tick(&motion, NULL);
        ticks++;
    } while (!rests() && ticks < LONG_RUN);
    return ticks;
}

// From rest on to the next one; the place there.
static double next_rest(void)
{
    nck_resume(&motion.nck);
    for (int k = 0; k < 10; k++) (void)motion_tick(&motion, NULL);
    (void)ticks_to_rest();
    return motion.pose.s;
}

// Ticks until the path slows down.
static uint32_t ticks_to_brake(void)
{
    const double v = motion.s[3] - motion.s[2];
    uint32_t ticks = 0;
    while (ticks < LONG_RUN && motion.s[3] - motion.s[2] > v * (1.0 - 1e-9)) {
        (void)motion_tick(&motion, NULL);
        ticks++;
    }
    return ticks;
}

static void a_hold_brakes_at_once_and_resume_goes_on_to_the_block_end(check_t *check)
{
    for (uint32_t tick = SWITCHED_ON + 100; tick < 750; tick += 50) {
        begin(tick);
        nck_hold(&motion.nck);
        CHECK(check, ticks_to_brake() <= HEARD);
        CHECK(check, ticks_to_rest() <= 300);
        CHECK(check, motion.pose.s < 20.0);
        CHECK_INT(check, motion.pose.state, NCK_TICK_HOLD);
        CHECK_NEAR(check, next_rest(), 20.0, 1e-9);
        CHECK_INT(check, motion.pose.state, NCK_TICK_HOLD);
        CHECK_NEAR(check, next_rest(), 30.0, 1e-9);
        motion_holds(check, &motion, "hold behind single block");
    }
}

static void an_abort_brakes_at_once(check_t *check)
{
    begin(400);
    nck_abort(&motion.nck);
    CHECK(check, ticks_to_brake() <= HEARD);
    CHECK(check, ticks_to_rest() <= 300);
    CHECK(check, motion.pose.s < 20.0);
    CHECK(check, motion.is_over);
    motion_holds(check, &motion, "abort behind single block");
}

static void an_override_is_met_and_the_block_end_kept(check_t *check)
{
    static const uint32_t percent[] = {10, 50, 99, 120, 200};
    for (int k = 0; k < 5; k++) {
        double v_least = 1e9;
        double v_most = 0.0;
        begin(400);
        nck_set_override(&motion.nck, percent[k] * NCK_PERCENT, 100 * NCK_PERCENT);
        while (motion.pose.s < 18.0 && motion.ticks < LONG_RUN) {
            (void)motion_tick(&motion, NULL);
            if (motion.pose.s > 17.0) continue;
            v_least = fmin(v_least, motion.pose.v);
            v_most = fmax(v_most, motion.pose.v);
        }
        const double v = percent[k] < 100 ? v_least : v_most;
        const double wanted = 0.25 * percent[k];
        if (NCK_PROFILE >= 256) CHECK(check, fabs(v - wanted) < 0.01 * wanted);
        (void)ticks_to_rest();
        CHECK_NEAR(check, motion.pose.s, 20.0, 1e-9);
        CHECK_INT(check, motion.pose.state, NCK_TICK_HOLD);
        CHECK_NEAR(check, next_rest(), 30.0, 1e-9);
        motion_holds(check, &motion, "override behind single block");
    }
}

static void an_override_of_zero_rests_on_the_way_and_goes_on_with_it(check_t *check)
{
    begin(400);
    nck_set_override(&motion.nck, 0, 100 * NCK_PERCENT);
    CHECK(check, ticks_to_rest() <= 300);
    CHECK(check, motion.pose.s < 20.0);
    nck_set_override(&motion.nck, 100 * NCK_PERCENT, 100 * NCK_PERCENT);
    for (int k = 0; k < 10; k++) (void)motion_tick(&motion, NULL);
    (void)ticks_to_rest();
    CHECK_NEAR(check, motion.pose.s, 20.0, 1e-9);
    motion_holds(check, &motion, "override of zero behind single block");
}

// Every 8th tick of the whole block, also while it brakes for its end: the run comes to its end
// without a resume, until the last periods, which are final. There it takes one.
static void single_block_switched_off_on_the_way_needs_no_resume(check_t *check)
{
    for (uint32_t tick = SWITCHED_ON + 4; tick < 960; tick += 8) {
        begin(tick);
        if (rests()) break;
        nck_set_single_block(&motion.nck, 0);
        const int late = 20.0 - motion.pose.s < 1e-3;
        while (motion.ticks < 4000 && motion_tick(&motion, NULL)) continue;
        if (!late && !CHECK(check, motion.is_over && motion.pose.s > 30.0 - 1e-9)) {
            printf("    off at %d: rests at %g\n", (int)tick, motion.pose.s);
        }
        motion_holds(check, &motion, "single block switched off");
    }
}

// Off and on again while the path brakes for the block's end: there it waits for a resume.
static void single_block_switched_on_again_on_the_way_waits_for_a_resume(check_t *check)
{
    begin(SWITCHED_ON + 1);
    const uint32_t end = SWITCHED_ON + 1 + ticks_to_rest();
    for (uint32_t before = 13; before < 70; before += 7) {
        begin(end - before);
        nck_set_single_block(&motion.nck, 0);
        (void)motion_tick(&motion, NULL);
        nck_set_single_block(&motion.nck, 1);
        for (int k = 0; k < 100; k++) (void)motion_tick(&motion, NULL);
        CHECK_INT(check, motion.pose.state, NCK_TICK_HOLD);
        CHECK_NEAR(check, motion.pose.s, 20.0, 1e-9);
        CHECK_NEAR(check, next_rest(), 30.0, 1e-9);
    }
}

static void single_block_switched_off_at_rest_waits_for_a_resume(check_t *check)
{
    begin(SWITCHED_ON + 1);
    (void)ticks_to_rest();
    nck_set_single_block(&motion.nck, 0);
    for (int k = 0; k < 100; k++) (void)motion_tick(&motion, NULL);
    CHECK_NEAR(check, motion.pose.s, 20.0, 1e-9);
    CHECK_NEAR(check, next_rest(), 30.0, 1e-9);
}

// A spindle that starts behind a block does so when the operator goes on, wherever he switched
// single block on; what stands behind the last block, too.
static void what_stands_behind_a_block_waits(check_t *check)
{
    static const uint8_t slope[] = {NCK_SLOPE_LINEAR, NCK_SLOPE_JERK};
    uint64_t seed = 2912;
    for (int n = 0; n < 24; n++) {
        const uint64_t on = (uint64_t)(500.0 * motion_random(&seed));
        motion_begin(&motion, 1);
        motion.machine.slope = slope[n & 1];
        motion_line(&motion, "G21 G90 G61 G1 F1500 X20");
        motion_line(&motion, "S500 M3");
        motion_line(&motion, "M8");
        motion_line(&motion, "Y10");
        motion_line(&motion, "M9");
        motion_line(&motion, "M2");
        motion.status = motion_start(&motion);
        while (motion.ticks < on && motion_tick(&motion, NULL)) continue;
        nck_set_single_block(&motion.nck, 1);
        while (motion.pose.state != NCK_TICK_HOLD && motion_tick(&motion, NULL)) continue;
        (void)ticks_to_rest();
        for (int k = 0; k < 50; k++) (void)motion_tick(&motion, NULL);
        CHECK_NEAR(check, motion.pose.s, 20.0, 1e-9);
        CHECK_INT(check, motion.outputs, 0);
        nck_resume(&motion.nck);
        for (int k = 0; k < 50; k++) (void)motion_tick(&motion, NULL);
        CHECK_INT(check, motion.outputs, 3);
        for (int press = 0; press < 2 && !motion.is_over; press++) {
            (void)ticks_to_rest();
            nck_resume(&motion.nck);
            for (int k = 0; k < 50 && motion_tick(&motion, NULL); k++) continue;
        }
        CHECK(check, motion.is_over);
        CHECK_INT(check, motion.outputs, 5);
    }
}

// The most prep steps between two ticks, until the path rests.
static uint32_t most_steps_to_rest(void)
{
    uint32_t most = 0;
    do {
        uint32_t steps = 0;
        while (steps < MOTION_STEPS && motion_prep(&motion)) steps++;
        most = steps > most ? steps : most;
        (void)motion_tick(&motion, NULL);
    } while (!rests() && motion.ticks < LONG_RUN);
    return most;
}

static void block_ends_too_near_to_rest_at_are_passed(check_t *check)
{
    for (int k = 1; k <= 3; k++) {
        motion_begin(&motion, 1);
        motion.machine.slope = NCK_SLOPE_JERK;
        motion_line(&motion, "G21 G90 G61 G1 F1500 X10");
        for (int n = 1; n <= k; n++) motion_line(&motion, "G91 X0.1");
        motion_line(&motion, "G90 X20");
        motion_line(&motion, "Y10");
        motion_line(&motion, "M2");
        motion.status = motion_start(&motion);
        motion_to(&motion, 9.7);
        nck_set_single_block(&motion.nck, 1);
        CHECK(check, most_steps_to_rest() < MOTION_STEPS / 2);
        CHECK_INT(check, motion.starved, 0);
        CHECK_INT(check, motion.pose.state, NCK_TICK_HOLD);
        if (NCK_PROFILE >= 256) CHECK_NEAR(check, motion.pose.s, 20.0, 1e-9);
        motion_holds(check, &motion, "block ends too near");
    }
}

// On a rapid, before a block that may not be entered any more: too late to rest in front of it, but
// for the low speeds of a short window.
static void an_override_of_zero_rests_behind_a_block_end_too_near(check_t *check)
{
    for (uint32_t single = 0; single < 2; single++) {
        motion_begin(&motion, 1);
        motion.machine.slope = NCK_SLOPE_JERK;
        motion_line(&motion, "G21 G90 G61 G0 X20");
        motion_line(&motion, "G1 X60 F6000");
        motion_line(&motion, "Y10");
        motion_line(&motion, "M2");
        motion.status = motion_start(&motion);
        motion_to(&motion, 13.0);
        nck_set_single_block(&motion.nck, single);
        nck_set_override(&motion.nck, 0, 100 * NCK_PERCENT);
        CHECK(check, most_steps_to_rest() < MOTION_STEPS / 2);
        CHECK_INT(check, motion.starved, 0);
        CHECK(check, motion.pose.s < 40.0);
        nck_set_override(&motion.nck, 100 * NCK_PERCENT, 100 * NCK_PERCENT);
        for (int k = 0; k < 10; k++) (void)motion_tick(&motion, NULL);
        (void)ticks_to_rest();
        const int in_front = NCK_PROFILE < 256 && single;
        CHECK_NEAR(check, motion.pose.s, in_front ? 20.0 : single ? 60.0 : 70.0, 1e-9);
        motion_holds(check, &motion, "override of zero on a rapid");
    }
}

static uint32_t slow_steps(void *user, uint64_t tick)
{
    return tick < 200 ? MOTION_STEPS : *(const uint32_t *)user;
}

// The answer is made again from further on, as often as it takes: the path never gets to the tail.
static void a_slow_preparation_hears_a_hold_before_the_window_ends(check_t *check)
{
    static uint32_t steps[] = {24, 48, 100};
    for (int k = 0; k < 3; k++) {
        const motion_script_t script = {slow_steps, NULL, &steps[k]};
        motion_begin(&motion, 1);
        motion.machine.slope = NCK_SLOPE_JERK;
        motion_line(&motion, "G61 G1 X250 F3000");
        motion_line(&motion, "M2");
        motion.status = motion_start(&motion);
        while (motion.ticks < 300) (void)motion_tick(&motion, &script);
        nck_hold(&motion.nck);
        const uint64_t begin_tick = motion.ticks;
        do (void)motion_tick(&motion, &script);
        while (!rests() && motion.ticks - begin_tick < 3000);
        CHECK_INT(check, motion.starved, 0);
        CHECK_INT(check, motion.pose.state, NCK_TICK_HOLD);
        const uint64_t ticks = motion.ticks - begin_tick;
        if (!CHECK(check, ticks <= 250)) printf("    %d steps: %d\n", (int)steps[k], (int)ticks);
        motion_holds(check, &motion, "slow preparation");
    }
}

int main(void)
{
    check_t check = {0};
    CHECK_RUN(&check, a_hold_brakes_at_once_and_resume_goes_on_to_the_block_end);
    CHECK_RUN(&check, an_abort_brakes_at_once);
    CHECK_RUN(&check, an_override_is_met_and_the_block_end_kept);
    CHECK_RUN(&check, an_override_of_zero_rests_on_the_way_and_goes_on_with_it);
    CHECK_RUN(&check, single_block_switched_off_on_the_way_needs_no_resume);
    CHECK_RUN(&check, single_block_switched_on_again_on_the_way_waits_for_a_resume);
    CHECK_RUN(&check, single_block_switched_off_at_rest_waits_for_a_resume);
    CHECK_RUN(&check, what_stands_behind_a_block_waits);
    CHECK_RUN(&check, block_ends_too_near_to_rest_at_are_passed);
    CHECK_RUN(&check, an_override_of_zero_rests_behind_a_block_end_too_near);
    CHECK_RUN(&check, a_slow_preparation_hears_a_hold_before_the_window_ends);
    return check_end(&check);
}
