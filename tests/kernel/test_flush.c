// SPDX-License-Identifier: MIT
// Text that stops coming is executed to its end, where it was flushed, and the path goes on.
#include <math.h>   // fabs fmax
#include <stdio.h>  // snprintf
#include <string.h> // memmove

#include "front_check.h"
#include "host/host.h" // nck_host_plan_…

enum { LINES = 300, FIRST = 400, AHEAD = 50, LATE_LINES = 800 };
enum { DROPS = 2000, BUDGET = 16 }; // a block a tick, and steps of prep
#define LATE_S 0.05 // how much longer than its plan a line alone may take

static front_t front;
static nck_t other;
static nck_host_plan_t plan;
static char text[20000];

static const char *const slope_name[] = {"linear", "jerk"};
#define LATE_TICKS 7700 // at 100 mm/s all the way

static double planned_s(const char *program)
{
    if (nck_host_plan_init(&plan, &other, &front.machine, program, strlen(program)) != NCK_OK) {
        return 0.0;
    }
    while (nck_host_plan_run(&plan) == NCK_OK) continue;
    return plan.totals.time_s;
}

static void begin(uint32_t slope)
{
    front_machine(&front, slope);
    (void)front_start(&front);
}

// A line alone, flushed: at its target within its time and 50 ms.
static void a_console_line_ends_on_its_target_in_time(check_t *check)
{
    static const char *const lines[] = {"G1 X5\n", "G1 X-0.001\n", "G0 X20 Y30\n", "G2 X0 Y10 J5\n",
                                        "G64 P0.01 G1 X2 Y2\n", "G61.1 G1 X1"};
    static const double ends[][2] = {{5, 0}, {-0.001, 0}, {20, 30}, {0, 10}, {2, 2}, {1, 0}};
    for (uint32_t slope = 0; slope <= NCK_SLOPE_JERK; slope++) {
        for (unsigned k = 0; k < sizeof lines / sizeof lines[0]; k++) {
            begin(slope);
            const double time_s = planned_s(lines[k]);
            front_push(&front, lines[k]);
            nck_flush(&front.nck);
            const uint64_t most = (uint64_t)((time_s + LATE_S) / front.machine.period_s);
            for (uint64_t n = 0; n < most; n++) front_tick(&front);
            const int there = fabs(front_x(&front) - ends[k][0]) < 1e-9
                              && fabs(front_y(&front) - ends[k][1]) < 1e-9;
            if (!CHECK(check, there)) printf("    %s: %s", slope_name[slope], lines[k]);
            CHECK(check, front.status == NCK_EMPTY && front.state == NCK_TICK_IDLE);
        }
    }
}

// All lines known, none behind them: executed to the end of the last one.
static void what_is_known_is_executed(check_t *check)
{
    static const char *const modes[] = {"G61.1\n", "G61\n", "G64 P0.01\n", "G64 P0.001 Q0\n"};
    for (uint32_t slope = 0; slope <= NCK_SLOPE_JERK; slope++) {
        for (unsigned k = 0; k < sizeof modes / sizeof modes[0]; k++) {
            const int lines = k == 0 ? 10 : LINES;
            begin(slope);
            front_push(&front, modes[k]);
            for (int n = 1; n <= lines; n++) {
                snprintf(text, sizeof text, "G1 X%.3f Y%.3f\n", 0.05 * n, 0.02 * (n % 3));
                front_push(&front, text);
            }
            nck_flush(&front.nck);
            front_rest(&front);
            if (!CHECK(check, fabs(front_x(&front) - 0.05 * lines) < 1e-9)) {
                printf("    %s: %s    at %.6f\n", slope_name[slope], modes[k], front_x(&front));
            }
            CHECK_INT(check, front.line[front.lines - 1], lines + 1);
        }
    }
}

// After the first lines input is only AHEAD mm before the tool. That costs no rest; where it is
// more than braking takes no speed, but in a window of a few mm.
static void late_input_costs_no_stop(check_t *check, uint32_t slope)
{
    const int may_creep = NCK_WINDOW < AHEAD;
    int known = 0, rests = 0;
    double before = 0.0;
    begin(slope);
    front_push(&front, "G61 F6000\n");
    for (double x = 0.0; x < LATE_LINES - AHEAD && rests < 100; x = front_x(&front)) {
        for (; known < FIRST || known < (int)x + AHEAD; known++) {
            snprintf(text, sizeof text, "G1 X%d\n", known + 1);
            front_push(&front, text);
        }
        front_tick(&front);
        rests += x > 0.0 && x == before;
        before = x;
    }
    CHECK_INT(check, rests, 0);
    if (!CHECK(check, may_creep || front.moving <= LATE_TICKS)) {
        printf("    %s: %u ticks\n", slope_name[slope], (unsigned)front.moving);
    }
}

static void input_that_comes_late_costs_no_stop(check_t *check)
{
    for (uint32_t slope = 0; slope <= NCK_SLOPE_JERK; slope++) {
        late_input_costs_no_stop(check, slope);
    }
}

// One tick with a budget. What prep wants more of is one block, once.
static void drip(uint32_t *dropped, uint32_t periods)
{
    int wants = 1;
    for (int n = 0; n < BUDGET; n++) {
        const nck_status_t status = nck_prep(&front.nck);
        if (status == NCK_OK) continue;
        if (status != NCK_EMPTY || !wants || *dropped == DROPS) break;
        ++*dropped;
        const nck_block_in_t block = front_to(*dropped, NCK_IN_LINE, 0.08 * *dropped, 0.0);
        (void)nck_push_block(&front.nck, &block);
        wants = 0;
    }
    if (periods > 0) nck_hurry(&front.nck, periods);
    front.state = nck_tick(&front.nck, &front.pose, &front.axes);
}

// Blocks that come one a tick, under a budget: hurried in time the path begins soon and never
// starves; by itself prep is hurried too late for its budget.
static void a_caller_with_a_budget_hurries_in_time(check_t *check)
{
    uint32_t begun[2] = {0, 0}, starved[2] = {0, 0};
    if (NCK_PROFILE < 256) return; // its window is full from rest at once
    for (int hurries = 0; hurries < 2; hurries++) {
        uint32_t dropped = 0;
        begin(NCK_SLOPE_JERK);
        front_push(&front, "G61 F6000\n");
        for (uint32_t tick = 0; tick < DROPS; tick++) {
            drip(&dropped, hurries ? 60 : 0);
            if (front.pose.v > 0.0 && begun[hurries] == 0) begun[hurries] = tick;
            starved[hurries] += front.state == NCK_TICK_STARVED;
        }
    }
    CHECK(check, begun[1] > 0 && begun[1] < begun[0] / 2);
    if (!CHECK(check, starved[1] == 0 && starved[0] > 0)) {
        printf("    starved %u, hurried %u ticks\n", starved[0], starved[1]);
    }
}

// Flushed anywhere, a path is the same path; behind the flush it goes on to its end.
static void behind_a_flush_the_path_goes_on(check_t *check)
{
    for (uint32_t slope = 0; slope <= NCK_SLOPE_JERK; slope++) {
        for (int every = 1; every <= 64; every *= 4) {
            begin(slope);
            front_push(&front, "G64 P0.005\n");
            for (int n = 1; n <= 2 * LINES / 3; n++) {
                snprintf(text, sizeof text, "G1 X%.3f Y%.3f\n", 0.1 * n, 0.2 * (n / 7 % 2));
                front_push(&front, text);
                if (n % every == 0) nck_flush(&front.nck);
            }
            nck_flush(&front.nck);
            front_rest(&front);
            CHECK_NEAR(check, front_x(&front), 0.1 * (2 * LINES / 3), 1e-9);
            CHECK(check, front.step_most <= 1.0 + 1e-6);
        }
    }
}

// Where a flush stands decides where the path rests, not when it is heard: the same setpoints
// whatever the pace of prep.
static void a_flush_has_a_place_not_a_time(check_t *check)
{
    uint64_t hash[2] = {0, 0};
    for (int eager = 0; eager < 2; eager++) {
        begin(NCK_SLOPE_JERK);
        for (int n = 1; n <= 40; n++) {
            snprintf(text, sizeof text, "G1 X%.3f\n", 2.0 * n);
            front_push(&front, text);
            if (eager) front_prep(&front);
            if (n == 20) nck_flush(&front.nck);
        }
        nck_end(&front.nck);
        front_rest(&front);
        CHECK_NEAR(check, front_x(&front), 80.0, 1e-9);
        hash[eager] = front.hash;
    }
    CHECK(check, hash[0] == hash[1]);
}

// A flush in front of the end changes nothing.
static void a_flush_at_the_end_is_the_end(check_t *check)
{
    uint64_t hash[2] = {0, 0};
    for (uint32_t slope = 0; slope <= NCK_SLOPE_JERK; slope++) {
        for (int flushes = 0; flushes < 2; flushes++) {
            begin(slope);
            front_push(&front, "G64 P0.01\nG1 X3\nY4 X6\nG3 X0 I-3\nG1 X-5\n");
            if (flushes) nck_flush(&front.nck);
            nck_end(&front.nck);
            front_rest(&front);
            CHECK_INT(check, front.status, NCK_DONE);
            hash[flushes] = front.hash;
        }
        CHECK(check, hash[0] == hash[1]);
    }
}

// A flush with nothing before it, and two in a row, do nothing; an output alone is handed over.
static void an_empty_flush_does_nothing(check_t *check)
{
    begin(NCK_SLOPE_JERK);
    nck_flush(&front.nck);
    nck_flush(&front.nck);
    front_rest(&front);
    CHECK_INT(check, front.moving, 0);
    CHECK_INT(check, front.status, NCK_EMPTY);
    front_push(&front, "M8\n");
    nck_flush(&front.nck);
    front_rest(&front);
    CHECK_INT(check, front.outputs, 1);
    front_push(&front, "G1 X1");
    nck_flush(&front.nck);
    front_rest(&front);
    CHECK_NEAR(check, front_x(&front), 1.0, 1e-9);
    front_push(&front, "X2\n");
    nck_flush(&front.nck);
    front_rest(&front);
    CHECK_NEAR(check, front_x(&front), 2.0, 1e-9);
}

// While a flush is under way nothing is taken, so that none of it is lost.
static void pushing_waits_for_the_flush(check_t *check)
{
    size_t used = 1;
    const nck_block_in_t block = front_to(7, NCK_IN_LINE, 1.0, 0.0);
    begin(NCK_SLOPE_JERK);
    front_push(&front, "G1 X5\n");
    nck_flush(&front.nck);
    CHECK_INT(check, nck_push(&front.nck, "X6\n", 3, &used), NCK_FULL);
    CHECK_INT(check, used, 0);
    CHECK_INT(check, nck_push_block(&front.nck, &block), NCK_FULL);
    front_prep(&front);
    CHECK_INT(check, nck_push_block(&front.nck, &block), NCK_OK);
}

int main(void)
{
    check_t check = {0};
    CHECK_RUN(&check, a_console_line_ends_on_its_target_in_time);
    CHECK_RUN(&check, what_is_known_is_executed);
    CHECK_RUN(&check, input_that_comes_late_costs_no_stop);
    CHECK_RUN(&check, a_caller_with_a_budget_hurries_in_time);
    CHECK_RUN(&check, behind_a_flush_the_path_goes_on);
    CHECK_RUN(&check, a_flush_has_a_place_not_a_time);
    CHECK_RUN(&check, a_flush_at_the_end_is_the_end);
    CHECK_RUN(&check, an_empty_flush_does_nothing);
    CHECK_RUN(&check, pushing_waits_for_the_flush);
    return check_end(&check);
}
