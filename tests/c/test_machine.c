// SPDX-License-Identifier: MIT
// The ground: a default machine that is good, a check that finds each bad number, ids for every
// code.
#include <math.h>   // NAN INFINITY
#include <string.h> // strcmp

#include "check.h"
#include "nck/base/machine.h" // nck_machine_check

static nck_machine_t machine;

static void the_default_machine_is_good(check_t *check) {
    nck_machine_default(&machine);
    CHECK_INT(check, nck_machine_check(&machine), NCK_OK);
    CHECK(check, machine.axis[0].present && machine.axis[2].present && !machine.axis[0].rotary);
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
    machine.kinematics = NCK_KINEMATICS_IDENTITY;
    machine.axis[2].present = 0;
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
    CHECK_INT(check, known, 5 + 24 + 3 + 1);
    CHECK(check, strcmp(nck_status_id(NCK_E_ARC_RADIUS), "arc-radius") == 0);
    CHECK(check, strcmp(nck_status_id(12345), "unknown") == 0);
    for (int note = NCK_NOTE_UNITS; note <= NCK_NOTE_AFTER_END; note++) {
        CHECK(check, strcmp(nck_note_id(note), "unknown") != 0);
    }
    CHECK(check, strcmp(nck_note_id(NCK_NOTE_ARC_CENTRE), "assumed-centre") == 0);
}

int main(void) {
    check_t check = {0};
    CHECK_RUN(&check, the_default_machine_is_good);
    CHECK_RUN(&check, each_bad_number_is_found);
    CHECK_RUN(&check, a_limit_of_zero_is_found);
    CHECK_RUN(&check, each_bad_choice_is_found);
    CHECK_RUN(&check, places_must_be_within_the_kernels_range);
    CHECK_RUN(&check, a_lathe_needs_its_two_axes);
    CHECK_RUN(&check, every_code_has_an_id_of_its_own);
    return check_end(&check);
}
