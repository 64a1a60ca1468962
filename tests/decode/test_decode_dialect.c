// SPDX-License-Identifier: MIT
// Room 1: names, switches, points and codes that dialects and machines add to the language.
#include "check.h"
#include "decode_check.h"

static decode_case_t self;

static void a_program_is_named_by_a_letter_or_a_colon(check_t *check) {
    case_begin(&self);
    case_decode(&self, "%\n:0100 (a part)\nO0100\nG0 X1\nM2\n");
    CHECK_INT(check, self.errors, 0);
    CHECK_INT(check, self.blocks, 2);
    check_error(check, &self, ": X1\nM2\n", NCK_HAS_CALLS ? NCK_E_EXPRESSION : NCK_E_UNSUPPORTED,
                1, NCK_HAS_CALLS ? 3 : 1);
    check_error(check, &self, "G0 X1 :5 X2\nM2\n", NCK_E_UNSUPPORTED, 1, 7);
}

static void a_skipped_line_may_say_its_switch(check_t *check) {
    case_begin(&self);
    case_decode(&self, "G0 X1\n/2 X2\n / 9N10X3\n/ X4\nM2\n");
    CHECK_INT(check, self.errors, 0);
    CHECK_INT(check, self.blocks, 5);
    CHECK_INT(check, self.block[2].target_nm[0], 3000000);
    self.machine.dialect.block_skip = 1;
    case_decode(&self, "G0 X1\n/2 X2\n / 9N10X3\n/ X4\nM2\n");
    CHECK_INT(check, self.blocks, 2);
    self.machine.dialect.block_skip = 0;
    check_error(check, &self, "G0 X1\n/0 X2\nM2\n", NCK_E_CHARACTER, 2, 2);
    check_error(check, &self, "G0 X1\n/12 X2\nM2\n", NCK_E_CHARACTER, 2, 3);
}

static void g30_p_names_the_reference_point(check_t *check) {
    case_begin(&self);
    self.machine.home_nm[1][0] = 7000000;
    check_error(check, &self, "G30 P2 X0\nM2\n", NCK_E_WORD_UNUSED, 1, 5);
    self.machine.dialect.base = NCK_DIALECT_FANUC;
    case_decode(&self, "G21 G90 G0 X1\nG30 P2 X3\nG30 X2\nM2\n");
    CHECK_INT(check, self.errors, 0);
    CHECK_INT(check, self.blocks, 6);
    CHECK_INT(check, self.block[1].target_nm[0], 3000000);
    CHECK_INT(check, self.block[2].target_nm[0], 7000000);
    CHECK_INT(check, self.block[4].target_nm[0], 7000000);
    check_error(check, &self, "G30 P3 X0\nM2\n", NCK_E_UNSUPPORTED, 1, 5);
    check_error(check, &self, "G30 P5 X0\nM2\n", NCK_E_NUMBER_RANGE, 1, 5);
    check_error(check, &self, "G30 P1 X0\nM2\n", NCK_E_NUMBER_RANGE, 1, 5);
    check_error(check, &self, "G30 P2.5 X0\nM2\n", NCK_E_NUMBER_RANGE, 1, 5);
    check_error(check, &self, "G28 P2 X0\nM2\n", NCK_E_WORD_UNUSED, 1, 5);
    check_error(check, &self, "G30 P2 G4 X0\nM2\n", NCK_E_WORD_SHARED, 1, 5);
}

static void further_reference_points_are_the_machines(check_t *check) {
    case_begin(&self);
    self.machine.dialect.base = NCK_DIALECT_FANUC;
    self.machine.home_more = 1u << (NCK_HOMES - 2);
    CHECK_INT(check, nck_machine_check(&self.machine), NCK_E_MACHINE);
    if (NCK_HOMES < 4) return;
    self.machine.home_nm[NCK_HOMES - 1][0] = 9000000;
    self.machine.home_more = 2;
    CHECK_INT(check, nck_machine_check(&self.machine), NCK_OK);
    check_error(check, &self, "G30 P3 X0\nM2\n", NCK_E_UNSUPPORTED, 1, 5);
    case_decode(&self, "G21 G90 G30 P4 X3\nM2\n");
    CHECK_INT(check, self.errors, 0);
    CHECK_INT(check, self.block[0].target_nm[0], 3000000);
    CHECK_INT(check, self.block[1].target_nm[0], 9000000);
}

static void the_machine_has_codes_of_its_own(check_t *check) {
    case_begin(&self);
    self.machine.own_m_count = 3;
    self.machine.own_m[0] = (nck_own_m_t){428, 0, 0};
    self.machine.own_m[1] = (nck_own_m_t){88, 1, 0};
    self.machine.own_m[2] = (nck_own_m_t){3, 1, 0}; // the kernel's own stays what it is
    case_decode(&self, "M428 M8 G0 X1\nM88\nM3\nM2\n");
    CHECK_INT(check, self.errors, 0);
    CHECK_INT(check, self.blocks, 6);
    CHECK_INT(check, self.block[1].kind, NCK_BLOCK_OUTPUT);
    CHECK_NEAR(check, self.block[1].output.value, 428.0, 0.0);
    CHECK_INT(check, self.block[2].kind, NCK_BLOCK_RAPID);
    CHECK_INT(check, self.block[3].kind, NCK_BLOCK_WAIT);
    CHECK_NEAR(check, self.block[3].output.value, 88.0, 0.0);
    CHECK_INT(check, self.block[4].kind, NCK_BLOCK_OUTPUT);
    check_error(check, &self, "M428.1\nM2\n", NCK_E_M_UNKNOWN, 1, 1);
    check_error(check, &self, "M429\nM2\n", NCK_E_M_UNKNOWN, 1, 1);
    check_error(check, &self, "M428 M88\nM2\n", NCK_E_MODAL_GROUP, 1, 6);
    CHECK_INT(check, nck_machine_check(&self.machine), NCK_OK);
    self.machine.own_m[0].code = NCK_M_MAX + 1;
    CHECK_INT(check, nck_machine_check(&self.machine), NCK_E_MACHINE);
    self.machine.own_m[0].code = NCK_M_MAX;
    self.machine.own_m[1].waits = 2;
    CHECK_INT(check, nck_machine_check(&self.machine), NCK_E_MACHINE);
    self.machine.own_m[1].waits = 0;
    self.machine.own_m_count = NCK_OWN_M_MAX + 1;
    CHECK_INT(check, nck_machine_check(&self.machine), NCK_E_MACHINE);
}

// The message names the mode in which the arc would be on a circle; it is not taken in silence.
static void an_arc_off_its_circle_tells_the_mode_that_fits(check_t *check) {
    case_begin(&self);
    check_error(check, &self, "G0 X10 Y10\nG1 F100\nG2 X20 Y10 I15 J10\nM2\n", NCK_E_ARC_MODE, 3,
                1);
    CHECK_INT(check, self.first.letter, 'A');
    check_error(check, &self, "G90.1 G0 X10 Y10\nG2 X20 Y10 I5 J0 F9\nM2\n", NCK_E_ARC_MODE, 2, 1);
    CHECK_INT(check, self.first.letter, 'I');
    check_error(check, &self, "G0 X10 Y10\nG2 X20 Y10 I16 J10 F9\nM2\n", NCK_E_ARC_RADIUS, 2, 1);
    check_error(check, &self, "G0 X10 Y10\nG2 X20 Y10 I15 F9\nM2\n", NCK_E_ARC_RADIUS, 2, 1);
    check_error(check, &self, "G0 X10\nG2 X20 I10 J0 F9\nM2\n", NCK_E_ARC_RADIUS, 2, 1);
    check_error(check, &self, "G92 X5 Y5\nG0 X10 Y10\nG2 X20 Y10 I15 J10 F9\nM2\n",
                NCK_E_ARC_MODE, 3, 1);
}

int main(void) {
    check_t check = {0};
    CHECK_RUN(&check, a_program_is_named_by_a_letter_or_a_colon);
    CHECK_RUN(&check, a_skipped_line_may_say_its_switch);
    CHECK_RUN(&check, g30_p_names_the_reference_point);
    CHECK_RUN(&check, further_reference_points_are_the_machines);
    CHECK_RUN(&check, the_machine_has_codes_of_its_own);
    CHECK_RUN(&check, an_arc_off_its_circle_tells_the_mode_that_fits);
    return check_end(&check);
}
