// SPDX-License-Identifier: MIT
// nck_tick and its operator: what the state says, when the kernel is idle, and that a wait ends as
// it is told to.
#include "motion_check.h"

enum { MANY = 400, STAY = 100 };

static motion_t motion;

static void begin(uint32_t slope)
{
    motion_begin(&motion, 1);
    motion.machine.slope = slope;
    motion_line(&motion, "G21 G90 G61 G1 F3000");
}

// A dense line of 40 mm: more cells than the ring holds.
static void put_dense_line(void)
{
    char words[40];
    for (int k = 0; k < MANY; k++) {
        snprintf(words, sizeof words, "X%.3f", 0.1 * (k + 1));
        motion_line(&motion, words);
    }
    motion_line(&motion, "M2");
}

// One tick; prep does all that it can before it, or nothing.
static nck_tick_state_t tick(int prep)
{
    while (prep && motion_prep(&motion)) continue;
    const nck_tick_state_t state = nck_tick(&motion.nck, &motion.pose, &motion.axes);
    motion_judge(&motion);
    return state;
}

static nck_tick_state_t tick_until(nck_tick_state_t wanted)
{
    nck_tick_state_t state = NCK_TICK_IDLE;
    for (int k = 0; k < 20000 && state != wanted; k++) state = tick(1);
    return state;
}

static int runs_to_the_end(void)
{
    for (int k = 0; k < 20000; k++) {
        const nck_tick_state_t state = tick(1);
        if (state == NCK_TICK_WAIT) nck_resume(&motion.nck);
        if (motion.status == NCK_DONE && nck_is_idle(&motion.nck)) return 1;
    }
    return 0;
}

// Of the linear slope: it reports its jerk and does not limit it.
static void check_limits(check_t *check)
{
    const motion_peak_t *const peak = &motion.peak;
    CHECK(check, peak->v <= 50.0 * (1.0 + 1e-9) && peak->v_axis <= 1.0 + 1e-6);
    CHECK(check, peak->a <= motion.machine.path.a_max * (1.0 + 1e-6));
    CHECK(check, peak->a_axis <= 1.0 + 1e-6 && peak->back <= 0.0 && peak->off <= 1e-9);
}

static void check_stays(check_t *check, double x, nck_tick_state_t state)
{
    for (int k = 0; k < STAY; k++) {
        CHECK_INT(check, tick(1), state);
        CHECK(check, motion.pose.axis[0] == x && motion.pose.v == 0.0);
    }
}

// The final cells are run out, then the stop tail: from there on it is a hold, not starvation.
static void hold_is_told_on_the_stop_tail_and_at_rest(check_t *check)
{
    begin(NCK_SLOPE_LINEAR);
    put_dense_line();
    CHECK_INT(check, motion_start(&motion), NCK_OK);
    for (int k = 0; k < 20; k++) CHECK(check, tick(1) == NCK_TICK_MOVE || k == 0);
    nck_hold(&motion.nck);
    CHECK_INT(check, tick(1), NCK_TICK_MOVE);
    CHECK_INT(check, tick_until(NCK_TICK_HOLD), NCK_TICK_HOLD);
    CHECK(check, motion.pose.v > 0.0);
    for (int k = 0; k < 20000 && motion.pose.v > 0.0; k++) {
        CHECK_INT(check, tick(1), NCK_TICK_HOLD);
    }
    CHECK(check, motion.pose.axis[0] < 40.0);
    check_stays(check, motion.pose.axis[0], NCK_TICK_HOLD);
    nck_resume(&motion.nck);
    CHECK(check, runs_to_the_end() && motion.pose.axis[0] == 40.0);
    check_limits(check);
}

static void hold_at_rest_is_told_until_it_is_resumed(check_t *check)
{
    begin(NCK_SLOPE_LINEAR);
    CHECK_INT(check, motion_start(&motion), NCK_OK);
    CHECK_INT(check, tick(0), NCK_TICK_IDLE);
    nck_hold(&motion.nck);
    CHECK_INT(check, tick(0), NCK_TICK_HOLD);
    nck_resume(&motion.nck);
    CHECK_INT(check, tick(0), NCK_TICK_IDLE);
}

static void starvation_is_told_until_prep_goes_on(check_t *check)
{
    begin(NCK_SLOPE_LINEAR);
    put_dense_line();
    CHECK_INT(check, motion_start(&motion), NCK_OK);
    for (int k = 0; k < 20; k++) (void)tick(1);
    nck_tick_state_t state = NCK_TICK_MOVE;
    for (int k = 0; k < 20000 && state == NCK_TICK_MOVE; k++) state = tick(0);
    CHECK_INT(check, state, NCK_TICK_STARVED);
    for (int k = 0; k < 20000 && motion.pose.v > 0.0; k++) (void)tick(0);
    CHECK_INT(check, tick(0), NCK_TICK_STARVED);
    CHECK_INT(check, motion.pose.limit, NCK_LIMIT_STARVED);
    CHECK(check, runs_to_the_end() && motion.pose.axis[0] == 40.0);
    check_limits(check);
}

static void wait_lasts_until_it_is_resumed(check_t *check)
{
    for (uint32_t slope = NCK_SLOPE_LINEAR; slope <= NCK_SLOPE_JERK; slope++) {
        begin(slope);
        motion_line(&motion, "X1");
        motion_line(&motion, "M0");
        motion_line(&motion, "X2");
        motion_line(&motion, "M2");
        CHECK_INT(check, motion_start(&motion), NCK_OK);
        CHECK_INT(check, tick_until(NCK_TICK_WAIT), NCK_TICK_WAIT);
        CHECK_INT(check, motion.outputs, 1);
        check_stays(check, 1.0, NCK_TICK_WAIT);
        CHECK(check, !nck_is_idle(&motion.nck));
        nck_resume(&motion.nck);
        CHECK(check, !nck_is_idle(&motion.nck)); // X2 is left
        CHECK(check, runs_to_the_end() && motion.pose.axis[0] == 2.0);
        CHECK_INT(check, motion.outputs, 2); // M0 and M2, each once
    }
}

// A spindle that starts behind M0 or M6 does so when the operator goes on; after an abort never.
static void what_stands_behind_a_wait_waits(check_t *check)
{
    static const char *const words[] = {"M8", "S500 M3", "M62 P1", "M64 P2", "M5", "G4 P0.01"};
    static const char *const stops[] = {"M0", "T1 M6", "M60"};
    uint64_t seed = 2611;
    for (int n = 0; n < 96; n++) {
        const int aborts = n & 1, waits = n >> 1;
        begin(waits % 2 ? NCK_SLOPE_JERK : NCK_SLOPE_LINEAR);
        if (waits % 3) motion_line(&motion, "X1");
        motion_line(&motion, stops[(int)(3.0 * motion_random(&seed))]);
        for (int k = 0; k < 3; k++) motion_line(&motion, words[(int)(6.0 * motion_random(&seed))]);
        motion_line(&motion, "M9");
        motion_line(&motion, "X2");
        motion_line(&motion, "M2");
        CHECK_INT(check, motion_start(&motion), NCK_OK);
        CHECK_INT(check, tick_until(NCK_TICK_WAIT), NCK_TICK_WAIT);
        const uint32_t outputs = motion.outputs;
        CHECK(check, outputs <= 3); // M0; T, M5 and M6
        for (int k = 0; k < 40; k++) CHECK_INT(check, tick(1), NCK_TICK_WAIT);
        CHECK_INT(check, motion.outputs, outputs);
        if (aborts) nck_abort(&motion.nck);
        else nck_resume(&motion.nck);
        for (int k = 0; k < 40; k++) (void)tick(1);
        CHECK(check, aborts ? motion.outputs == outputs : motion.outputs > outputs);
        CHECK(check, aborts || (runs_to_the_end() && motion.pose.axis[0] == 2.0));
    }
}

static void abort_at_a_wait_ends_there(check_t *check)
{
    for (uint32_t slope = NCK_SLOPE_LINEAR; slope <= NCK_SLOPE_JERK; slope++) {
        begin(slope);
        motion_line(&motion, "X1");
        motion_line(&motion, "M0");
        motion_line(&motion, "X2");
        motion_line(&motion, "M2");
        CHECK_INT(check, motion_start(&motion), NCK_OK);
        CHECK_INT(check, tick_until(NCK_TICK_WAIT), NCK_TICK_WAIT);
        nck_abort(&motion.nck);
        CHECK_INT(check, tick(1), NCK_TICK_HOLD);
        nck_resume(&motion.nck); // only nck_init goes on
        check_stays(check, 1.0, NCK_TICK_HOLD);
        CHECK(check, nck_is_idle(&motion.nck));
        CHECK_INT(check, motion.status, NCK_DONE);
    }
}

// What is final is run before the rest is dropped; on the way the kernel is not idle.
static void abort_is_idle_only_at_rest(check_t *check)
{
    begin(NCK_SLOPE_LINEAR);
    put_dense_line();
    CHECK_INT(check, motion_start(&motion), NCK_OK);
    while (motion_prep(&motion)) continue;
    nck_abort(&motion.nck);
    CHECK(check, !nck_is_idle(&motion.nck));
    for (int k = 0; k < 20000 && !nck_is_idle(&motion.nck); k++) (void)tick(1);
    CHECK(check, motion.pose.axis[0] > 0.0 && motion.pose.axis[0] < 40.0);
    check_stays(check, motion.pose.axis[0], NCK_TICK_HOLD);
    CHECK(check, nck_is_idle(&motion.nck));
    CHECK_INT(check, motion.status, NCK_DONE);
    check_limits(check);
}

static void kernel_is_idle_when_nothing_is_left_to_do(check_t *check)
{
    begin(NCK_SLOPE_LINEAR);
    motion_line(&motion, "S100");
    CHECK_INT(check, motion_start(&motion), NCK_OK);
    CHECK(check, nck_is_idle(&motion.nck));
    while (motion_prep(&motion)) continue;
    CHECK(check, !nck_is_idle(&motion.nck)); // an output waits
    CHECK_INT(check, tick(0), NCK_TICK_IDLE);
    CHECK_INT(check, motion.outputs, 2); // S, and that the text has ended
    CHECK(check, nck_is_idle(&motion.nck));
    begin(NCK_SLOPE_LINEAR);
    motion_line(&motion, "X1");
    CHECK_INT(check, motion_start(&motion), NCK_OK);
    while (motion_prep(&motion)) continue;
    CHECK(check, !nck_is_idle(&motion.nck)); // a cell waits
    CHECK_INT(check, tick(0), NCK_TICK_MOVE);
    CHECK(check, !nck_is_idle(&motion.nck)); // on the way
    CHECK(check, runs_to_the_end() && motion.pose.axis[0] == 1.0);
}

// A kernel without hooks drops its outputs, in the tick as in planning.
static void outputs_need_no_hook(check_t *check)
{
    nck_cell_t cell;
    begin(NCK_SLOPE_LINEAR);
    motion_line(&motion, "S100 X1");
    motion_line(&motion, "M2");
    for (int plans = 0; plans < 2; plans++) {
        (void)motion_start(&motion);
        CHECK_INT(check, nck_init(&motion.nck, &motion.machine, NULL), NCK_OK);
        while (motion_prep(&motion)) continue;
        while (plans && nck_take(&motion.nck, &cell) == NCK_OK) continue;
        CHECK(check, runs_to_the_end());
        CHECK_INT(check, motion.outputs, 0);
    }
}

int main(void)
{
    check_t check = {0};
    CHECK_RUN(&check, hold_is_told_on_the_stop_tail_and_at_rest);
    CHECK_RUN(&check, hold_at_rest_is_told_until_it_is_resumed);
    CHECK_RUN(&check, starvation_is_told_until_prep_goes_on);
    CHECK_RUN(&check, wait_lasts_until_it_is_resumed);
    CHECK_RUN(&check, what_stands_behind_a_wait_waits);
    CHECK_RUN(&check, abort_at_a_wait_ends_there);
    CHECK_RUN(&check, abort_is_idle_only_at_rest);
    CHECK_RUN(&check, kernel_is_idle_when_nothing_is_left_to_do);
    CHECK_RUN(&check, outputs_need_no_hook);
    return check_end(&check);
}
