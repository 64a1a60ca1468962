// SPDX-License-Identifier: MIT
// The ground: a default machine that is good, a check that finds each bad number, ids for every
// code.
#include <math.h>   // NAN INFINITY
#include <string.h> // strcmp

#include "check.h"
#include "nck/base/machine.h" // nck_machine_check

enum {
    BEST = NCK_HAS_OPTIMAL ? NCK_SLOPE_OPTIMAL : NCK_HAS_JERK ? NCK_SLOPE_JERK : NCK_SLOPE_LINEAR
};

static nck_machine_t machine;

static void the_default_machine_is_good(check_t *check) {
    nck_machine_default(&machine);
    CHECK_INT(check, nck_machine_check(&machine), NCK_OK);
    CHECK(check, machine.axis[0].present && machine.axis[2].present && !machine.axis[0].rotary);
}

static void the_default_machine_is_what_its_header_says(check_t *check) {
    nck_machine_default(&machine);
    CHECK(check, machine.period_s == 1e-3 && machine.slope == BEST);
    CHECK(check, machine.path.tolerance == 0.01);
    CHECK(check, machine.kinematics == NCK_KINEMATICS_IDENTITY);
    CHECK(check, machine.dialect.base == NCK_DIALECT_LINUXCNC && machine.dialect.plane == 17);
    for (int x = 0; x < NCK_AXIS_MAX; x++) {
        const nck_axis_t *const axis = &machine.axis[x];
        CHECK_INT(check, axis->present, x <= NCK_AXIS_Z);
        CHECK_INT(check, axis->rotary, x >= NCK_AXIS_A && x <= NCK_AXIS_C);
        CHECK(check, axis->v_max == 100.0 && axis->rapid == 100.0 && axis->a_max == 1e3);
        CHECK(check, axis->j_max == 1e4 && axis->max_nm == INT64_MAX);
        CHECK(check, axis->min_nm == -INT64_MAX - 1);
        CHECK(check, nck_machine_counts(&machine, x) == (axis->rotary ? 1e9 : 1e6));
    }
    CHECK(check, machine.path.feed_max == 100.0 && machine.path.a_max == 1e3);
    CHECK(check, machine.path.j_max == 1e4 && machine.path.tolerance == 0.01);
    CHECK(check, machine.path.chord_error == 1e-3 && machine.path.arc_radius == 5e-3);
}

// Every real number of the machine must be refused when it is NaN, infinite or negative.
static void each_bad_number_is_found(check_t *check) {
    double *const numbers[] = {
        &machine.period_s, &machine.axis[0].v_max, &machine.axis[1].rapid, &machine.axis[2].a_max,
        &machine.axis[0].j_max, &machine.path.feed_max, &machine.path.a_max, &machine.path.j_max,
        &machine.path.chord_error, &machine.path.tolerance, &machine.path.arc_radius,
        &machine.dialect.feed_default, &machine.spindle.rpm_max, &machine.tool[0].radius_mm};
    const double bad[] = {(double)NAN, (double)INFINITY, -(double)INFINITY, -1.0};
    for (unsigned k = 0; k < sizeof numbers / sizeof numbers[0]; k++) {
        for (unsigned n = 0; n < sizeof bad / sizeof bad[0]; n++) {
            nck_machine_default(&machine);
            machine.tool_count = 1;
            CHECK_INT(check, nck_machine_check(&machine), NCK_OK);
            *numbers[k] = bad[n];
            CHECK_INT(check, nck_machine_check(&machine), NCK_E_MACHINE);
        }
    }
}

// The range's ends are good, their neighbours are not.
static void each_limit_has_its_range(check_t *check) {
    const struct {
        double *number;
        nck_quantity_t quantity;
    } limits[] = {
        {&machine.period_s, NCK_QUANTITY_PERIOD}, {&machine.axis[0].v_max, NCK_QUANTITY_SPEED},
        {&machine.axis[1].rapid, NCK_QUANTITY_SPEED}, {&machine.path.feed_max, NCK_QUANTITY_SPEED},
        {&machine.axis[2].a_max, NCK_QUANTITY_ACCELERATION},
        {&machine.path.a_max, NCK_QUANTITY_ACCELERATION},
        {&machine.axis[0].j_max, NCK_QUANTITY_JERK}, {&machine.path.j_max, NCK_QUANTITY_JERK},
        {&machine.path.chord_error, NCK_QUANTITY_ERROR},
        {&machine.path.arc_radius, NCK_QUANTITY_ERROR},
        {&machine.path.tolerance, NCK_QUANTITY_SIZE},
        {&machine.tool[0].radius_mm, NCK_QUANTITY_SIZE},
        {&machine.dialect.feed_default, NCK_QUANTITY_FEED},
        {&machine.spindle.rpm_max, NCK_QUANTITY_ROTATION}};
    for (unsigned k = 0; k < sizeof limits / sizeof limits[0]; k++) {
        nck_range_t range;
        nck_machine_range(limits[k].quantity, &range);
        nck_machine_default(&machine);
        machine.tool_count = 1;
        machine.axis[0].rapid = 1e-6;
        machine.axis[1].v_max = 1e6;
        const double good[] = {range.low, range.high};
        const double bad[] = {nextafter(range.low, -1.0), nextafter(range.high, 2e12)};
        for (int n = 0; n < 2; n++) {
            *limits[k].number = good[n];
            CHECK_INT(check, nck_machine_check(&machine), NCK_OK);
            *limits[k].number = bad[n];
            CHECK_INT(check, nck_machine_check(&machine), NCK_E_MACHINE);
        }
    }
}

// A limit of zero would let nothing move, and what divides by it would be infinite.
static void a_limit_of_zero_is_found(check_t *check) {
    double *const limits[] = {
        &machine.period_s, &machine.axis[0].v_max, &machine.axis[1].rapid, &machine.axis[2].a_max,
        &machine.axis[0].j_max, &machine.path.feed_max, &machine.path.a_max, &machine.path.j_max,
        &machine.path.chord_error, &machine.path.arc_radius};
    double *const may_be_zero[] = {&machine.path.tolerance, &machine.dialect.feed_default,
                                   &machine.spindle.rpm_max, &machine.tool[0].radius_mm};
    for (unsigned k = 0; k < sizeof limits / sizeof limits[0]; k++) {
        nck_machine_default(&machine);
        *limits[k] = 0.0;
        CHECK_INT(check, nck_machine_check(&machine), NCK_E_MACHINE);
    }
    nck_machine_default(&machine);
    machine.tool_count = 1;
    for (unsigned k = 0; k < sizeof may_be_zero / sizeof may_be_zero[0]; k++) {
        *may_be_zero[k] = 0.0;
    }
    CHECK_INT(check, nck_machine_check(&machine), NCK_OK);
}

static void each_bad_choice_is_found(check_t *check) {
    uint8_t *const bytes[] = {&machine.axis[0].present, &machine.axis[0].rotary,
                              &machine.dialect.diameter, &machine.dialect.inch,
                              &machine.dialect.plane, &machine.dialect.arc_absolute,
                              &machine.dialect.block_skip, &machine.dialect.optional_stop};
    uint32_t *const words[] = {&machine.slope, &machine.kinematics, &machine.dialect.base,
                               &machine.work_system, &machine.tool_count};
    for (unsigned k = 0; k < sizeof bytes / sizeof bytes[0]; k++) {
        nck_machine_default(&machine);
        *bytes[k] = 2;
        CHECK_INT(check, nck_machine_check(&machine), NCK_E_MACHINE);
    }
    for (unsigned k = 0; k < sizeof words / sizeof words[0]; k++) {
        nck_machine_default(&machine);
        *words[k] = 2000;
        CHECK_INT(check, nck_machine_check(&machine), NCK_E_MACHINE);
    }
    nck_machine_default(&machine);
    machine.lookahead_blocks = 1;
    CHECK_INT(check, nck_machine_check(&machine), NCK_E_MACHINE);
    machine.lookahead_blocks = NCK_WINDOW + 1;
    CHECK_INT(check, nck_machine_check(&machine), NCK_E_MACHINE);
    machine.lookahead_blocks = NCK_WINDOW;
    CHECK_INT(check, nck_machine_check(&machine), NCK_OK);
}

// Where the axis of approach is, and how high: what is said, or what follows from the machine.
static void the_way_in_is_said_or_follows(check_t *check) {
    nck_machine_default(&machine);
    CHECK(check, machine.approach.feed == 100.0 / 60.0);
    CHECK_INT(check, nck_machine_approach_axis(&machine), NCK_AXIS_Z);
    CHECK(check, nck_machine_approach_nm(&machine) == INT64_MAX);
    machine.axis[NCK_AXIS_Z].max_nm = 7;
    CHECK(check, nck_machine_approach_nm(&machine) == 7);
    machine.approach.height_nm = 5;
    CHECK(check, nck_machine_approach_nm(&machine) == 5);
    CHECK_INT(check, nck_machine_check(&machine), NCK_OK);
    machine.kinematics = NCK_KINEMATICS_LATHE_XZ;
    CHECK_INT(check, nck_machine_approach_axis(&machine), NCK_AXIS_X);
    machine.approach.axis = 1 + NCK_AXIS_Y;
    CHECK_INT(check, nck_machine_approach_axis(&machine), NCK_AXIS_Y);
    machine.axis[NCK_AXIS_Y].present = 0;
    CHECK(check, nck_machine_approach_nm(&machine) == -INT64_MAX - 1);
}

static void a_way_in_that_cannot_be_is_found(check_t *check) {
    nck_machine_default(&machine);
    machine.axis[NCK_AXIS_Z].min_nm = -7;
    machine.axis[NCK_AXIS_Z].max_nm = 7;
    const struct { int64_t height_nm; int good; } heights[] = {
        {INT64_MAX, 1}, {7, 1}, {-7, 1}, {8, 0}, {-8, 0}};
    for (unsigned k = 0; k < sizeof heights / sizeof heights[0]; k++) {
        machine.approach.height_nm = heights[k].height_nm;
        const nck_status_t status = nck_machine_check(&machine);
        CHECK_INT(check, status, heights[k].good ? NCK_OK : NCK_E_MACHINE);
    }
    machine.approach.height_nm = INT64_MAX;
    for (uint32_t axis = 0; axis <= NCK_AXIS_MAX + 1u; axis++) {
        const int turns = axis >= 1 + NCK_AXIS_A && axis <= 1 + NCK_AXIS_C;
        machine.approach.axis = axis;
        const int good = axis <= NCK_AXIS_MAX && !turns;
        CHECK_INT(check, nck_machine_check(&machine), good ? NCK_OK : NCK_E_MACHINE);
    }
    machine.approach.axis = 0;
    machine.approach.feed = 0.0;
    CHECK_INT(check, nck_machine_check(&machine), NCK_E_MACHINE);
}

static void check_word(check_t *check, uint32_t *word, uint32_t value, int good) {
    const uint32_t before = *word;
    *word = value;
    CHECK_INT(check, nck_machine_check(&machine), good ? NCK_OK : NCK_E_MACHINE);
    *word = before;
}

static void choices_end_at_their_last_one(check_t *check) {
    nck_machine_default(&machine);
    check_word(check, &machine.slope, NCK_SLOPE_JERK, 1);
    check_word(check, &machine.slope, NCK_SLOPE_OPTIMAL + 1, 0);
    check_word(check, &machine.kinematics, NCK_KINEMATICS_LATHE_XZ, 1);
    check_word(check, &machine.kinematics, NCK_KINEMATICS_LATHE_XZ + 1, 0);
    check_word(check, &machine.dialect.base, NCK_DIALECT_GRBLHAL, 1);
    check_word(check, &machine.dialect.base, NCK_DIALECT_GRBLHAL + 1, 0);
    check_word(check, &machine.work_system, NCK_WORK_SYSTEMS - 1, 1);
    check_word(check, &machine.work_system, NCK_WORK_SYSTEMS, 0);
    check_word(check, &machine.tool_count, NCK_TOOL_MAX, 1);
    check_word(check, &machine.tool_count, NCK_TOOL_MAX + 1, 0);
    machine.tool_count = NCK_TOOL_MAX;
    check_word(check, &machine.tool[NCK_TOOL_MAX - 1].orientation, 9, 1);
    check_word(check, &machine.tool[NCK_TOOL_MAX - 1].orientation, 10, 0);
    check_word(check, &machine.lookahead_blocks, 1, 0);
    check_word(check, &machine.lookahead_blocks, 2, 1);
    for (uint8_t plane = 15; plane < 22; plane++) {
        machine.dialect.plane = plane;
        const int good = plane >= 17 && plane <= 19;
        CHECK_INT(check, nck_machine_check(&machine), good ? NCK_OK : NCK_E_MACHINE);
    }
}

// A place may be as far as the kernel's range and not a count further, on either side.
static void check_place(check_t *check, int64_t *place, int64_t furthest) {
    for (int sign = -1; sign <= 1; sign += 2) {
        *place = sign * furthest;
        CHECK_INT(check, nck_machine_check(&machine), NCK_OK);
        *place = sign * (furthest + 1);
        CHECK_INT(check, nck_machine_check(&machine), NCK_E_MACHINE);
        *place = 0;
    }
}

static void every_place_may_be_as_far_as_the_kernels_range(check_t *check) {
    nck_machine_default(&machine);
    machine.tool_count = NCK_TOOL_MAX;
    for (int x = 0; x < NCK_AXIS_MAX; x++) {
        const int64_t furthest = machine.axis[x].rotary
                                     ? (int64_t)NCK_ROTARY_MAX_DEG * NCK_COUNTS_PER_DEG
                                     : (int64_t)NCK_LINEAR_MAX_MM * NCK_COUNTS_PER_MM;
        check_place(check, &machine.start_nm[x], furthest);
        for (int n = 0; n < NCK_HOMES; n++) check_place(check, &machine.home_nm[n][x], furthest);
        for (int n = 0; n < NCK_WORK_SYSTEMS; n++) {
            check_place(check, &machine.work_nm[n][x], furthest);
        }
    }
    for (int x = 0; x < 3; x++) {
        const int64_t furthest = (int64_t)NCK_LINEAR_MAX_MM * NCK_COUNTS_PER_MM;
        check_place(check, &machine.tool[NCK_TOOL_MAX - 1].offset_nm[x], furthest);
        machine.axis[x].min_nm = -furthest;
        machine.axis[x].max_nm = furthest;
        CHECK_INT(check, nck_machine_check(&machine), NCK_OK);
        machine.axis[x].max_nm = furthest + 1;
        CHECK_INT(check, nck_machine_check(&machine), NCK_E_MACHINE);
        machine.axis[x].max_nm = machine.axis[x].min_nm; // no travel is one, too
        CHECK_INT(check, nck_machine_check(&machine), NCK_OK);
    }
}

static void places_must_be_within_the_kernels_range(check_t *check) {
    const int64_t beyond = (int64_t)NCK_LINEAR_MAX_MM * NCK_COUNTS_PER_MM + 1;
    int64_t *const places[] = {&machine.axis[0].min_nm, &machine.start_nm[1],
                               &machine.home_nm[1][0], &machine.work_nm[8][2],
                               &machine.tool[0].offset_nm[2]};
    for (unsigned k = 0; k < sizeof places / sizeof places[0]; k++) {
        nck_machine_default(&machine);
        machine.tool_count = 1;
        *places[k] = -beyond;
        CHECK_INT(check, nck_machine_check(&machine), NCK_E_MACHINE);
    }
    nck_machine_default(&machine);
    machine.axis[0].min_nm = 5;
    machine.axis[0].max_nm = 4;
    CHECK_INT(check, nck_machine_check(&machine), NCK_E_MACHINE);
    nck_machine_default(&machine);
    machine.axis[0].rapid = 101.0;
    CHECK_INT(check, nck_machine_check(&machine), NCK_E_MACHINE);
}

static void a_lathe_needs_its_two_axes(check_t *check) {
    nck_machine_default(&machine);
    machine.kinematics = NCK_KINEMATICS_LATHE_XZ;
    machine.axis[1].present = 0;
    CHECK_INT(check, nck_machine_check(&machine), NCK_OK);
    machine.axis[0].present = 0;
    CHECK_INT(check, nck_machine_check(&machine), NCK_E_MACHINE);
    machine.axis[0].present = 1;
    machine.axis[2].present = 0;
    CHECK_INT(check, nck_machine_check(&machine), NCK_E_MACHINE);
    machine.axis[0].present = 0;
    machine.kinematics = NCK_KINEMATICS_IDENTITY;
    CHECK_INT(check, nck_machine_check(&machine), NCK_E_MACHINE); // no axis at all
}

static void every_code_has_an_id_of_its_own(check_t *check) {
    int known = 0;
    for (int code = NCK_E_INTERNAL; code <= NCK_WAIT; code++) {
        if (strcmp(nck_status_id(code), "unknown") == 0) continue;
        known++;
        for (int before = NCK_E_INTERNAL; before < code; before++) {
            CHECK(check, strcmp(nck_status_id(before), nck_status_id(code)) != 0
                             || strcmp(nck_status_id(before), "unknown") == 0);
        }
    }
    CHECK_INT(check, known, 5 + 39 + 9 + 3 + 1);
    CHECK(check, strcmp(nck_status_id(NCK_E_ARC_RADIUS), "arc-radius") == 0);
    CHECK(check, strcmp(nck_status_id(12345), "unknown") == 0);
    for (int note = NCK_NOTE_UNITS; note <= NCK_NOTE_COMP_LEFT; note++) {
        CHECK(check, strcmp(nck_diagnostic_id(note), "unknown") != 0);
    }
    CHECK(check, strcmp(nck_diagnostic_id(NCK_NOTE_ARC_CENTRE), "assumed-centre") == 0);
    CHECK(check, strcmp(nck_diagnostic_id(NCK_E_ARC_RADIUS), "arc-radius") == 0);
}

int main(void) {
    check_t check = {0};
    CHECK_RUN(&check, the_default_machine_is_good);
    CHECK_RUN(&check, the_default_machine_is_what_its_header_says);
    CHECK_RUN(&check, each_bad_number_is_found);
    CHECK_RUN(&check, each_limit_has_its_range);
    CHECK_RUN(&check, a_limit_of_zero_is_found);
    CHECK_RUN(&check, each_bad_choice_is_found);
    CHECK_RUN(&check, the_way_in_is_said_or_follows);
    CHECK_RUN(&check, a_way_in_that_cannot_be_is_found);
    CHECK_RUN(&check, choices_end_at_their_last_one);
    CHECK_RUN(&check, every_place_may_be_as_far_as_the_kernels_range);
    CHECK_RUN(&check, places_must_be_within_the_kernels_range);
    CHECK_RUN(&check, a_lathe_needs_its_two_axes);
    CHECK_RUN(&check, every_code_has_an_id_of_its_own);
    return check_end(&check);
}
