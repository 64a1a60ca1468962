// SPDX-License-Identifier: MIT
// Builds that leave out rooms or planners: what is left out is told, and what is there runs every
// program to its end within its limits. It runs in every set of capacities.
#include "motion_check.h" // motion_t

enum { SLOPES = 3 };

static motion_t motion;
static const int built[SLOPES] = {1, NCK_HAS_JERK, NCK_HAS_OPTIMAL};
static const char *const slope_name[SLOPES] = {"linear", "jerk", "optimal"};

static void begin(uint32_t slope, uint64_t seed)
{
    motion_begin(&motion, seed);
    motion.machine.slope = slope;
}

// The jerk of the linear slope has no limit.
static void judge(check_t *check, const char *what)
{
    if (motion.machine.slope == NCK_SLOPE_LINEAR) motion.peak.j = 0.0;
    motion_holds(check, &motion, what);
}

// The first finding with this code; code 0: there is none.
static nck_diagnostic_t find(int32_t code)
{
    nck_diagnostic_t found;
    while (nck_diagnostic(&motion.nck, &found) == NCK_OK) {
        if (found.code == code) return found;
    }
    return (nck_diagnostic_t){0, 0, 0, 0, 0.0, 0.0};
}

static void a_slope_that_is_left_out_is_refused(check_t *check)
{
    nck_machine_default(&motion.machine);
    CHECK_INT(check, nck_machine_check(&motion.machine), NCK_OK);
    CHECK(check, built[motion.machine.slope]);
    for (uint32_t slope = 0; slope < SLOPES; slope++) {
        const nck_status_t wanted = built[slope] ? NCK_OK : NCK_E_UNSUPPORTED;
        begin(slope, 1);
        CHECK_INT(check, nck_machine_check(&motion.machine), wanted);
        CHECK_INT(check, motion_start(&motion), wanted);
    }
    motion.machine.slope = SLOPES;
    CHECK_INT(check, nck_machine_check(&motion.machine), NCK_E_MACHINE);
}

// Corners of 5 mm, on the exact path or within a tolerance. Returns the setpoints' hash.
static uint64_t run_corners(check_t *check, const char *mode, uint32_t slope)
{
    char words[80];
    begin(slope, 1);
    motion_line(&motion, "G21 G90 G17 F3000");
    motion_line(&motion, mode);
    for (int n = 1; n <= 40; n++) {
        snprintf(words, sizeof words, "G1 X%d Y%d", 5 * (n / 2), 5 * ((n + 1) / 2));
        motion_line(&motion, words);
    }
    motion_line(&motion, "M2");
    CHECK(check, motion_run(&motion, NULL) && motion.error == NCK_OK);
    return motion.hash;
}

static void without_smoothing_a_tolerance_is_noted_and_the_path_exact(check_t *check)
{
    for (uint32_t slope = 0; slope < SLOPES; slope++) {
        if (!built[slope]) continue;
        const uint64_t exact = run_corners(check, "G61", slope);
        CHECK_INT(check, find(NCK_NOTE_TOLERANCE).code, 0);
        judge(check, slope_name[slope]);
        const uint64_t within = run_corners(check, "G64 P0.05", slope);
        const nck_diagnostic_t note = find(NCK_NOTE_TOLERANCE);
        CHECK_INT(check, note.code, slope == NCK_SLOPE_OPTIMAL ? 0 : NCK_NOTE_TOLERANCE);
        CHECK_INT(check, note.line, slope == NCK_SLOPE_OPTIMAL ? 0 : 2);
        CHECK(check, (within != exact) == (slope == NCK_SLOPE_OPTIMAL));
    }
}

// Geometry that asks for a tolerance hears the same.
static void without_smoothing_a_block_with_a_tolerance_is_noted(check_t *check)
{
    nck_block_in_t block;
    begin(NCK_SLOPE_LINEAR, 1);
    CHECK_INT(check, motion_start(&motion), NCK_OK);
    memset(&block, 0, sizeof block);
    block.id = 7;
    block.kind = NCK_IN_LINE;
    block.axes = 1 << NCK_AXIS_X;
    block.target[0] = 1.0;
    block.sets = NCK_IN_SETS_PATH;
    block.path_mode = NCK_PATH_CONTINUOUS;
    block.tolerance = 0.01;
    CHECK_INT(check, nck_push_block(&motion.nck, &block), NCK_OK);
    while (nck_prep(&motion.nck) == NCK_OK) continue;
    CHECK_INT(check, find(NCK_NOTE_TOLERANCE).line, 7);
}

static void what_the_language_lacks_is_an_error_of_its_line(check_t *check)
{
    const struct {
        const char *line;
        int is_built;
    } cases[] = {{"G1 X[1+1]", NCK_HAS_VARIABLES}, {"G81 X1 Z-1 R1", NCK_HAS_CYCLES},
                 {"G41 D1", NCK_HAS_COMP}, {"G51 X0 Y0 P2.0", NCK_HAS_LAYOUTS}};
    for (unsigned k = 0; k < sizeof cases / sizeof cases[0]; k++) {
        begin(NCK_SLOPE_LINEAR, 1);
        motion.machine.tool_count = 1;
        motion.machine.tool[0].number = 1;
        if (k == 3) motion.machine.dialect.base = NCK_DIALECT_FANUC;
        motion_line(&motion, "G21 G90 G17 G61 G1 X1 Z1 F600");
        motion_line(&motion, cases[k].line);
        motion_line(&motion, "M2");
        CHECK(check, motion_run(&motion, NULL));
        if (!CHECK(check, (motion.error == NCK_OK) == cases[k].is_built)) {
            printf("    %s: %s\n", cases[k].line, nck_status_id(motion.error));
        }
        if (!cases[k].is_built) CHECK_INT(check, find(motion.error).line, 2);
    }
}

static void every_program_keeps_its_limits_to_its_end(check_t *check)
{
    char name[120];
    for (uint32_t slope = 0; slope < SLOPES; slope++) {
        for (int k = 0; built[slope] && k < 2 * MOTION_FAMILIES; k++) {
            const motion_family_t *const family = &motion_family[k / 2];
            begin(slope, 1 + (uint64_t)k);
            motion_program(&motion, family, k % 2 ? 0.1 : 0.0);
            const int over = motion_run(&motion, NULL);
            snprintf(name, sizeof name, "%s, %s, %d", slope_name[slope], family->name, k % 2);
            if (!CHECK(check, over && motion.error == NCK_OK && motion.early == 0)) {
                printf("    %s: over %d, %s\n", name, over, nck_status_id(motion.error));
            }
            judge(check, name);
            if (!CHECK(check, motion.starved <= motion.ticks / 50)) {
                printf("    %s: starved %d of %d ticks\n", name, (int)motion.starved,
                       (int)motion.ticks);
            }
            const nck_seg_t *const last = &motion.seg[motion.segs - 1];
            for (int x = 0; x < 3; x++) CHECK(check, motion.pose.axis[x] == last->end[x]);
            CHECK_INT(check, nck_invariants(&motion.nck), 0);
        }
    }
}

// More outputs than their ring holds, between moves that fill the window.
static void outputs_that_fill_their_ring_stop_nothing(check_t *check)
{
    char words[80];
    for (uint32_t slope = 0; slope < SLOPES; slope++) {
        if (!built[slope]) continue;
        begin(slope, 1);
        motion_line(&motion, "G21 G90 G17 G61 G1 F3000");
        for (int k = 1; k <= 2 * NCK_WINDOW; k++) {
            snprintf(words, sizeof words, "X%d Y%d", k, k & 1);
            motion_line(&motion, words);
            for (int n = 0; n < (k == NCK_WINDOW ? 2 * NCK_OUTPUT_MAX : 3); n++) {
                motion_line(&motion, "M8");
            }
        }
        motion_line(&motion, "M2");
        CHECK(check, motion_run(&motion, NULL));
        CHECK_INT(check, motion.outputs, 3 * (2 * NCK_WINDOW - 1) + 2 * NCK_OUTPUT_MAX + 1);
        CHECK_INT(check, motion.early, 0);
        judge(check, slope_name[slope]);
    }
}

// Few steps of prep between ticks, as many as do not starve it.
static uint32_t few_steps(void *user, uint64_t tick)
{
    (void)tick;
    return *(const uint32_t *)user;
}

static void setpoints_do_not_hang_on_the_pace_of_prep(check_t *check)
{
    uint32_t steps = 200;
    const motion_script_t script = {few_steps, NULL, &steps};
    for (uint32_t slope = 0; slope < SLOPES; slope++) {
        for (int k = 0; built[slope] && k < 2; k++) {
            const motion_family_t *const family = &motion_family[k ? 5 : 0];
            begin(slope, 9);
            motion_program(&motion, family, 0.0);
            CHECK(check, motion_run(&motion, NULL));
            const uint64_t hash = motion.hash;
            CHECK(check, motion_run(&motion, &script));
            if (motion.starved == 0) CHECK(check, motion.hash == hash);
            CHECK_INT(check, (int)motion.starved, 0);
        }
    }
}

// An operator: holds, goes on, overrides up and down, again and again.
static void meddle(void *user, uint64_t tick)
{
    (void)user;
    switch (tick % 400) {
    case 60: nck_hold(&motion.nck); break;
    case 160: nck_resume(&motion.nck); break;
    case 200: nck_set_override(&motion.nck, 30 * NCK_PERCENT, 30 * NCK_PERCENT); break;
    case 260: nck_set_override(&motion.nck, 180 * NCK_PERCENT, 100 * NCK_PERCENT); break;
    case 330: nck_set_override(&motion.nck, 100 * NCK_PERCENT, 100 * NCK_PERCENT); break;
    default: break;
    }
}

static void an_operator_breaks_no_limit(check_t *check)
{
    const motion_script_t script = {NULL, meddle, NULL};
    for (uint32_t slope = 0; slope < SLOPES; slope++) {
        for (int family = 0; built[slope] && family < MOTION_FAMILIES; family++) {
            begin(slope, 20 + (uint64_t)family);
            motion_program(&motion, &motion_family[family], 0.05);
            if (!CHECK(check, motion_run(&motion, &script) && motion.error == NCK_OK)) {
                printf("    %s, %s\n", slope_name[slope], motion_family[family].name);
            }
            judge(check, motion_family[family].name);
        }
    }
}

static void abort_here(void *user, uint64_t tick)
{
    (void)user;
    if (tick == 100) nck_abort(&motion.nck);
}

static void an_abort_rests_soon_and_another_program_begins_there(check_t *check)
{
    const motion_script_t script = {NULL, abort_here, NULL};
    for (uint32_t slope = 0; slope < SLOPES; slope++) {
        if (!built[slope]) continue;
        begin(slope, 3);
        motion_line(&motion, "G21 G90 G61 G1 X500 F6000");
        motion_line(&motion, "M2");
        CHECK(check, motion_run(&motion, &script));
        CHECK(check, motion.ticks < 500 && motion.pose.axis[0] > 1.0);
        judge(check, slope_name[slope]);
        CHECK_INT(check, nck_begin(&motion.nck), NCK_OK);
        motion.used = 0;
        motion.segs = 0;
        motion.status = NCK_OK;
        while (motion_tick(&motion, NULL)) continue;
        CHECK(check, motion.is_over && motion.pose.axis[0] == 500.0);
    }
}

int main(void)
{
    check_t check = {0};
    CHECK_RUN(&check, a_slope_that_is_left_out_is_refused);
    CHECK_RUN(&check, without_smoothing_a_tolerance_is_noted_and_the_path_exact);
    CHECK_RUN(&check, without_smoothing_a_block_with_a_tolerance_is_noted);
    CHECK_RUN(&check, what_the_language_lacks_is_an_error_of_its_line);
    CHECK_RUN(&check, every_program_keeps_its_limits_to_its_end);
    CHECK_RUN(&check, outputs_that_fill_their_ring_stop_nothing);
    CHECK_RUN(&check, setpoints_do_not_hang_on_the_pace_of_prep);
    CHECK_RUN(&check, an_operator_breaks_no_limit);
    CHECK_RUN(&check, an_abort_rests_soon_and_another_program_begins_there);
    return check_end(&check);
}
