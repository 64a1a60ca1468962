// SPDX-License-Identifier: MIT
// What fuzzing has found (tests/fuzz/kernel.c), as programs; and what must not happen ends in one
// error and a stop.
#include "motion_check.h"

static motion_t self;

// ---- a broken invariant

// As a cell that is none does (tests/c/test_link.c).
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
    for (uint32_t slope = NCK_SLOPE_LINEAR; slope <= NCK_SLOPE_SSHAPE; slope++) {
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
    for (uint32_t slope = NCK_SLOPE_LINEAR; slope <= NCK_SLOPE_SSHAPE; slope++) {
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
static void begin_talkative(uint32_t slope, int moves, int outputs) {
    char words[80];
    motion_begin(&self, 1);
    self.machine.slope = slope;
    motion_line(&self, "G21 G90 G17 G61 G1 F3000");
    for (int k = 1; k <= moves; k++) {
        snprintf(words, sizeof words, "X%d", k & 1);
        motion_line(&self, words);
        for (int n = 0; n < outputs; n++) motion_line(&self, "M8");
    }
    motion_line(&self, "M2");
}

static void outputs_that_fill_their_ring_do_not_stop_the_program(check_t *check) {
    const int cases[][2] = {{2 * NCK_WINDOW, 3}, {2 * NCK_WINDOW, 7}, {5, 2 * NCK_OUTPUT_MAX}};
    for (uint32_t slope = NCK_SLOPE_LINEAR; slope <= NCK_SLOPE_SSHAPE; slope++) {
        for (unsigned k = 0; k < sizeof cases / sizeof cases[0]; k++) {
            begin_talkative(slope, cases[k][0], cases[k][1]);
            if (!CHECK(check, motion_run(&self, NULL))) return;
            CHECK_INT(check, self.outputs, (uint32_t)(cases[k][0] * cases[k][1]) + 1);
            CHECK_INT(check, self.early, 0);
            CHECK(check, self.peak.a <= self.machine.path.a_max * (1.0 + 1e-6));
        }
    }
}

int main(void) {
    check_t check = {0};
    CHECK_RUN(&check, a_broken_plan_ends_in_one_error_and_a_stop);
    CHECK_RUN(&check, an_abort_ends_wherever_it_comes);
    CHECK_RUN(&check, an_abort_in_the_stop_tail_ends);
    CHECK_RUN(&check, outputs_that_fill_their_ring_do_not_stop_the_program);
    return check_end(&check);
}
