// SPDX-License-Identifier: MIT
// Room 1: what G10 L1 L10 L11 changes in the tool table, and who reads it.
#include "check.h"
#include "decode_check.h"

static decode_case_t self;

static void begin(nck_dialect_t base) {
    case_begin(&self);
    self.machine.dialect.base = base;
    self.machine.tool_count = 2;
    self.machine.tool[0] = (nck_tool_t){1, 0, {0, 0, 10000000}, 3.0, 0.5};
    self.machine.tool[1] = (nck_tool_t){2, 0, {0, 0, 20000000}, 0.0, 0.0};
}

static double offset_of(int k, unsigned axis) {
    return (double)self.block[k].tool_nm[axis] / 1e6;
}

static void an_entry_counts_from_the_next_g43_on(check_t *check) {
    begin(NCK_DIALECT_LINUXCNC);
    case_decode(&self, "G21 G90 G43 H1\nG0 Z1\nG10 L1 P1 X2 Z5\nZ2\nG43 H1\nZ3\nG43 H2\nZ4\nM2\n");
    CHECK_INT(check, self.errors, 0);
    CHECK_NEAR(check, offset_of(1, 2), 10.0, 0.0);
    CHECK_NEAR(check, offset_of(2, 2), 5.0, 0.0);
    CHECK_NEAR(check, offset_of(2, 0), 2.0, 0.0);
    CHECK_NEAR(check, offset_of(3, 2), 20.0, 0.0);
}

static void an_entry_makes_the_axes_stand_where_the_words_say(check_t *check) {
    begin(NCK_DIALECT_LINUXCNC);
    case_decode(&self, "G21 G90 G10 L2 P9 Z-7\nG43 H1 G0 Z7\nG92 Z9\nG10 L10 P1 Z1\nG43 H1\nZ1.5\n"
                       "G10 L11 P1 Z2\nG43 H1 Z3\nM2\n");
    CHECK_INT(check, self.errors, 0);
    CHECK_NEAR(check, offset_of(1, 2), 18.0, 0.0);
    CHECK_NEAR(check, offset_of(2, 2), 22.5, 0.0);
}

static void a_radius_and_an_orientation_count_from_the_next_g41_on(check_t *check) {
    if (!NCK_HAS_COMP) return;
    begin(NCK_DIALECT_LINUXCNC);
    case_decode(&self, "G21 G90 G18 F9\nG10 L1 P1 R2 Q3\nG41 D1\nG40\nG10 L1 P1 R[1/4]\nM2\n");
    CHECK_INT(check, self.errors, 0);
    CHECK_NEAR(check, self.block[0].output.value, 2.5, 0.0); // and its wear
    CHECK_NEAR(check, self.block[0].centre_mm[0], -2.5, 0.0);
    CHECK_NEAR(check, self.block[0].centre_mm[1], 2.5, 0.0);
}

static void fanucs_lengths_and_their_wear_add_up(check_t *check) {
    begin(NCK_DIALECT_FANUC);
    case_decode(&self, "G21 G90 G10 L10 P1 R30.\nG10 L11 P1 R-0.5\nG43 H1 G0 Z1.\nG49\n"
                       "G91 G10 L10 P1 R1.\nG10 L11 P1 R0.2\nG90 G43 H1 Z2.\nM30\n");
    CHECK_INT(check, self.errors, 0);
    CHECK_NEAR(check, offset_of(0, 2), 29.5, 0.0);
    CHECK_NEAR(check, offset_of(1, 2), 30.7, 1e-9);
    check_error(check, &self, "G43 H1\nG10 L10 P1 R30.\nM30\n", NCK_E_UNSUPPORTED, 2, 0);
    check_error(check, &self, "G10 L12 P1 R30.\nM30\n", NCK_E_UNSUPPORTED, 1, 5);
    check_error(check, &self, "G10 L10 P1\nM30\n", NCK_E_WORD_MISSING, 1, 1);
    check_error(check, &self, "G10 L10 P1 R1. Z3.\nM30\n", NCK_E_WORD_UNUSED, 1, 16);
    check_error(check, &self, "G10 L10 P7 R1.\nM30\n", NCK_E_TOOL_UNKNOWN, 1, 9);
}

static void fanucs_radii_are_what_the_machine_says(check_t *check) {
    if (!NCK_HAS_COMP) return;
    begin(NCK_DIALECT_FANUC);
    self.machine.dialect.d_offset = NCK_D_RADIUS;
    case_decode(&self, "G21 G90 G94 F9\nG10 L12 P1 R2.\nG10 L13 P1 R-.25\nG41 D1\nG40\n"
                       "G91 G10 L12 P1 R1.\nG10 L13 P1 R.5\nG90 G41 D1\nM30\n");
    CHECK_INT(check, self.errors, 0);
    CHECK_NEAR(check, self.block[0].output.value, 1.75, 0.0);
    CHECK_NEAR(check, self.block[2].output.value, 3.25, 0.0);
    self.machine.dialect.d_offset = NCK_D_DIAMETER;
    case_decode(&self, "G21 G90 G94 F9\nG10 L12 P1 R5.\nG41 D1\nM30\n");
    CHECK_NEAR(check, self.block[0].output.value, 3.0, 0.0); // and its wear
    check_error(check, &self, "G10 L12 P1\nM30\n", NCK_E_WORD_MISSING, 1, 1);
    self.machine.dialect.base = NCK_DIALECT_LINUXCNC;
    check_error(check, &self, "G10 L12 P1 R5\nM2\n", NCK_E_UNSUPPORTED, 1, 5);
}

static void a_line_that_is_refused_changes_nothing(check_t *check) {
    begin(NCK_DIALECT_LINUXCNC);
    case_decode(&self, "G21 G90 G10 L1 P1 X1 Y2 Z9999999\nG10 L1 P1 Z5 R1 Q12\n"
                       "G10 L2 P1 X4 Z9999999\nG10 L20 P1 X4 Z9999999\nG43 H1 G0 X1 Z1\nM2\n");
    CHECK_INT(check, self.errors, 4);
    CHECK_NEAR(check, offset_of(0, 0), 0.0, 0.0);
    CHECK_NEAR(check, offset_of(0, 2), 10.0, 0.0);
    CHECK_INT(check, self.block[0].target_nm[0], 1000000);
}

static void what_a_table_cannot_take_is_told(check_t *check) {
    begin(NCK_DIALECT_LINUXCNC);
    check_error(check, &self, "G10 L1 P3 Z1\nM2\n", NCK_E_TOOL_UNKNOWN, 1, 8);
    check_error(check, &self, "G10 L1 P0 Z1\nM2\n", NCK_E_TOOL_UNKNOWN, 1, 8);
    check_error(check, &self, "G10 L1 P1.5 Z1\nM2\n", NCK_E_NUMBER_RANGE, 1, 8);
    check_error(check, &self, "G10 L1 P1 Q10\nM2\n", NCK_E_NUMBER_RANGE, 1, 11);
    check_error(check, &self, "G10 L1 P1 Z1e9\nM2\n", NCK_E_WORD_UNKNOWN, 1, 13);
    check_error(check, &self, "G10 L10 P1 Z-999999\nM2\n", NCK_OK, 0, 0);
    check_error(check, &self, "G10 L1 P1 R9999999\nM2\n", NCK_E_NUMBER_RANGE, 1, 11);
    check_error(check, &self, "G10 L2 P1 Q1\nM2\n", NCK_E_WORD_UNUSED, 1, 11);
    check_error(check, &self, "G10 L20 P1 R30\nM2\n", NCK_E_UNSUPPORTED, 1, 12);
    check_error(check, &self, "G10 L2 P1 R0 X1\nM2\n", NCK_OK, 0, 0);
    check_error(check, &self, "G10 L1.5 P1 X1\nM2\n", NCK_E_UNSUPPORTED, 1, 5);
    self.machine.dialect.base = NCK_DIALECT_GRBL;
    check_error(check, &self, "G10 L1 P1 Z1\nM2\n", NCK_E_UNSUPPORTED, 1, 5);
}

static nck_status_t pull_all(void) {
    nck_block_t block;
    nck_status_t status = NCK_OK;
    while (status != NCK_DONE && status != NCK_EMPTY) {
        status = nck_decode_pull(&self.decode, &block);
        case_take(&self, status, &block);
    }
    return status;
}

static void push(const char *text) {
    size_t used = 0, n = strlen(text);
    while (n > 0) {
        (void)nck_decode_push(&self.decode, text, n, &used);
        text += used;
        n -= used;
        (void)pull_all();
    }
}

static void a_changed_tool_outlives_its_program_and_a_parameter_does_not(check_t *check) {
    begin(NCK_DIALECT_LINUXCNC);
    case_decode(&self, "#100=5 #101=6\nG10 L1 P2 Z33\n#102=7\nG10 L1 P1 Z44\nM2\n");
    CHECK_INT(check, self.errors, 0);
    nck_decode_begin(&self.decode);
    CHECK(check, nck_decode_invariants(&self.decode));
    self.blocks = 0;
    push("G21 G90 G43 H2 G0 Z1\nG43 H1 Z[#100+#102]\nM2\n");
    CHECK_INT(check, self.errors, 0);
    CHECK_NEAR(check, offset_of(0, 2), 33.0, 0.0);
    CHECK_NEAR(check, offset_of(1, 2), 44.0, 0.0);
    CHECK_INT(check, self.block[1].target_nm[2], 0);
}

static void without_parameters_the_table_stays_what_it_is(check_t *check) {
    begin(NCK_DIALECT_LINUXCNC);
    check_error(check, &self, "G10 L1 P1 Z1\nM2\n", NCK_E_UNSUPPORTED, 1, 5);
}

int main(void) {
    check_t check = {0};
    if (!NCK_HAS_VARIABLES) {
        CHECK_RUN(&check, without_parameters_the_table_stays_what_it_is);
        return check_end(&check);
    }
    CHECK_RUN(&check, an_entry_counts_from_the_next_g43_on);
    CHECK_RUN(&check, an_entry_makes_the_axes_stand_where_the_words_say);
    CHECK_RUN(&check, a_radius_and_an_orientation_count_from_the_next_g41_on);
    CHECK_RUN(&check, fanucs_lengths_and_their_wear_add_up);
    CHECK_RUN(&check, fanucs_radii_are_what_the_machine_says);
    CHECK_RUN(&check, a_line_that_is_refused_changes_nothing);
    CHECK_RUN(&check, what_a_table_cannot_take_is_told);
    CHECK_RUN(&check, a_changed_tool_outlives_its_program_and_a_parameter_does_not);
    return check_end(&check);
}
