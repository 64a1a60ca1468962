// SPDX-License-Identifier: MIT
// What fuzzing has found (tests/house/fuzz/kernel.c), as programs; and what must not happen ends in
// one error and a stop.
#include "motion_check.h"

static motion_t self;

// ---- a broken invariant

// As a cell that is none does (tests/base/test_link.c).
static void spoil(void) {
    self.nck.link.broken = 1;
    self.nck.link.broken_line = 2;
}

static void begin_zigzag(uint32_t slope) {
    char words[80];
    motion_begin(&self, 1);
    self.machine.slope = slope;
    motion_line(&self, "G21 G90 G17 G61 G1 F3000");
    for (int k = 1; k <= 400; k++) {
        snprintf(words, sizeof words, "X%d Y%d", k, k & 1);
        motion_line(&self, words);
    }
    motion_line(&self, "M2");
}

// Up to the end, or to the number of ticks. Returns how many errors prep has told.
static int count_errors(uint64_t ticks) {
    int errors = 0;
    nck_diagnostic_t finding;
    for (uint64_t n = 0; n < ticks && motion_tick(&self, NULL); n++) continue;
    while (nck_diagnostic(&self.nck, &finding) == NCK_OK) {
        errors += finding.code == NCK_E_INTERNAL && finding.line == 2;
    }
    return errors;
}

static void a_broken_plan_ends_in_one_error_and_a_stop(check_t *check) {
    for (uint32_t slope = NCK_SLOPE_LINEAR; slope <= NCK_SLOPE_JERK; slope++) {
        begin_zigzag(slope);
        CHECK_INT(check, motion_start(&self), NCK_OK);
        CHECK_INT(check, count_errors(500), 0);
        CHECK(check, self.pose.v > 0.0);
        spoil();
        CHECK_INT(check, count_errors(100000), 1);
        CHECK(check, self.is_over && self.error == NCK_E_INTERNAL);
        CHECK_INT(check, nck_prep(&self.nck), NCK_DONE);
        CHECK_INT(check, nck_tick(&self.nck, &self.pose, &self.axes), NCK_TICK_HOLD);
        CHECK(check, self.pose.v <= 0.0);
        CHECK(check, self.pose.s > 1.0 && self.pose.s < 400.0);
        CHECK(check, self.peak.a <= self.machine.path.a_max * (1.0 + 1e-6));
    }
}

// ---- abort

static void abort_at(void *user, uint64_t tick) {
    if (tick == *(const uint64_t *)user) nck_abort(&self.nck);
}

// Also where the cells end at a corner that is passed at no speed.
static void an_abort_ends_wherever_it_comes(check_t *check) {
    for (uint32_t slope = NCK_SLOPE_LINEAR; slope <= NCK_SLOPE_JERK; slope++) {
        for (uint64_t at = 1; at < 3000; at += 149) {
            const motion_script_t script = {NULL, abort_at, &at};
            begin_zigzag(slope);
            if (!CHECK(check, motion_run(&self, &script))) return;
            CHECK_INT(check, nck_tick(&self.nck, &self.pose, &self.axes), NCK_TICK_HOLD);
        }
    }
}

// Prep is slow: the tick enters the stop tail while the plan of the abort is made.
static uint32_t slowly(void *user, uint64_t tick) {
    const uint64_t at = *(const uint64_t *)user;
    return tick <= at ? MOTION_STEPS : tick % 100 == 0 ? 3 : 0;
}

static void an_abort_in_the_stop_tail_ends(check_t *check) {
    for (uint64_t at = 10; at < 3000; at += 149) {
        const motion_script_t script = {slowly, abort_at, &at};
        begin_zigzag(NCK_SLOPE_JERK);
        if (!CHECK(check, motion_run(&self, &script))) return;
    }
}

// ---- full rings

// Moves with so many outputs behind each of them.
static void begin_talkative(uint32_t slope, const char *mode, int moves, int outputs) {
    char words[80];
    motion_begin(&self, 1);
    self.machine.slope = slope;
    motion_line(&self, "G21 G90 G17 G1 F3000");
    motion_line(&self, mode);
    for (int k = 1; k <= moves; k++) {
        snprintf(words, sizeof words, "X%d Y%d", k, k & 1);
        motion_line(&self, words);
        for (int n = 0; n < outputs; n++) motion_line(&self, "M8");
    }
}

static void outputs_that_fill_their_ring_do_not_stop_the_program(check_t *check) {
    static const struct {
        const char *mode;
        int moves, outputs;
    } cases[] = {{"G61", 2 * NCK_WINDOW, 3}, {"G61", 2 * NCK_WINDOW, 7},
                 {"G61", 5, 2 * NCK_OUTPUT_MAX}, {"G64 P0.01", 2 * NCK_WINDOW, 3},
                 {"G64 P0.01", 5, 2 * NCK_OUTPUT_MAX}};
    for (uint32_t slope = NCK_SLOPE_LINEAR; slope <= NCK_SLOPE_JERK; slope++) {
        for (unsigned k = 0; k < sizeof cases / sizeof cases[0]; k++) {
            begin_talkative(slope, cases[k].mode, cases[k].moves, cases[k].outputs);
            motion_line(&self, "M2");
            if (!CHECK(check, motion_run(&self, NULL))) return;
            CHECK_INT(check, self.outputs, (uint32_t)(cases[k].moves * cases[k].outputs) + 1);
            CHECK_INT(check, self.early, 0);
            CHECK(check, self.peak.a <= self.machine.path.a_max * (1.0 + 1e-6));
        }
    }
}

// What is known of the path ends there: the line is not the way to what comes behind them.
static void outputs_behind_a_short_line_do_not_lengthen_it(check_t *check) {
    for (uint32_t slope = NCK_SLOPE_LINEAR; slope <= NCK_SLOPE_JERK; slope++) {
        begin_talkative(slope, "G64 P0.01", 0, 0);
        motion_line(&self, "G1 X0.000029 Y0.000032");
        for (int n = 0; n < 2 * NCK_WINDOW; n++) motion_line(&self, "M8");
        motion_line(&self, "X5 Y0");
        if (!CHECK(check, motion_run(&self, NULL))) return;
        CHECK_NEAR(check, self.peak.s, 5.0, 0.001);
        CHECK_NEAR(check, self.pose.axis[NCK_AXIS_X], 5.0, 1e-9);
    }
}

// ---- short blocks

// So few blocks in sight that a plan is one cell: nothing is left of it to take over from.
static void plans_of_one_cell_are_executed(check_t *check) {
    motion_begin(&self, 1);
    self.machine.period_s = 0.1;
    self.machine.lookahead_blocks = 2;
    self.machine.path.j_max = 113.7;
    motion_line(&self, "G21 G91 G17 G61 G1 F3000");
    for (int k = 0; k < 4; k++) motion_line(&self, "G1 X-0.000002 Y0.000002");
    CHECK(check, motion_run(&self, NULL));
    motion_holds(check, &self, "2.8 nm");
}

// Two jerk limits a factor of a hundred apart, cells that last longer than the jerk rule counts:
// the way down from the faster piece comes to nothing where the way up is slow.
static void no_plan_stands_still_between_two_nodes(check_t *check) {
    static const double limits[3][3] = {
        {7.49273, 22.9608, 19131.7}, {7.94269, 1.88873, 50506.9}, {781.232, 19699.8, 9.08488}};
    static const double places[10][2] = {
        {499, 500}, {479, 519}, {459, 537}, {439, 554}, {417, 570},
        {395, 585}, {373, 600}, {350, 614}, {326, 627}, {302, 638}}; // [nm]
    char words[80];
    motion_begin(&self, 1);
    self.machine.period_s = 0.00025;
    self.machine.lookahead_blocks = 2;
    self.machine.path.feed_max = 4.14695;
    self.machine.path.a_max = 6506.51;
    for (int x = 0; x < 3; x++) {
        self.machine.axis[x].v_max = self.machine.axis[x].rapid = limits[x][0];
        self.machine.axis[x].a_max = limits[x][1];
        self.machine.axis[x].j_max = limits[x][2];
    }
    for (int k = 0; k < 10; k++) {
        snprintf(words, sizeof words, "G1 X%.6f Y%.6f Z%.6f", places[k][0] * 1e-6,
                 places[k][1] * 1e-6, k == 9 ? 0.000147 : 0.0);
        motion_line(&self, words);
    }
    CHECK(check, motion_run(&self, NULL));
    motion_holds(check, &self, "28 nm");
}

int main(void) {
    check_t check = {0};
    CHECK_RUN(&check, a_broken_plan_ends_in_one_error_and_a_stop);
    CHECK_RUN(&check, an_abort_ends_wherever_it_comes);
    CHECK_RUN(&check, an_abort_in_the_stop_tail_ends);
    CHECK_RUN(&check, outputs_that_fill_their_ring_do_not_stop_the_program);
    CHECK_RUN(&check, outputs_behind_a_short_line_do_not_lengthen_it);
    CHECK_RUN(&check, plans_of_one_cell_are_executed);
    CHECK_RUN(&check, no_plan_stands_still_between_two_nodes);
    return check_end(&check);
}
