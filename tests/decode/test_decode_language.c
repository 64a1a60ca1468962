// SPDX-License-Identifier: MIT
// Room 1: what a line may say, and what it may not: an error with line and column, never silence.
#include "check.h"
#include "decode_check.h"

static decode_case_t self;

static void outputs_come_in_the_order_of_execution(check_t *check) {
    static const double values[] = {500.0, 2.0, 5.0, 6.0, 3.0, 7.0, 8.0, 48.0};
    case_begin(&self);
    case_decode(&self, "M48 M8 M7 M3 M6 T2 S500 M0 G4 P1.5 F100 G1 X1\nM2\n");
    CHECK_INT(check, self.errors, 0);
    CHECK_INT(check, self.blocks, 12);
    for (int k = 0; k < 8; k++) CHECK_NEAR(check, self.block[k].output.value, values[k], 0.0);
    CHECK_INT(check, self.block[0].output.kind, NCK_OUTPUT_SPINDLE_SPEED);
    CHECK_INT(check, self.block[1].output.kind, NCK_OUTPUT_TOOL);
    CHECK_INT(check, self.block[2].kind, NCK_BLOCK_OUTPUT);
    CHECK_INT(check, self.block[3].kind, NCK_BLOCK_WAIT);
    CHECK_INT(check, self.block[4].kind, NCK_BLOCK_OUTPUT);
    CHECK_INT(check, self.block[8].kind, NCK_BLOCK_DWELL);
    CHECK_NEAR(check, self.block[8].dwell_s, 1.5, 0.0);
    CHECK_INT(check, self.block[9].kind, NCK_BLOCK_LINE);
    CHECK_NEAR(check, self.block[9].spindle_rpm, 500.0, 0.0);
    CHECK_INT(check, self.block[10].kind, NCK_BLOCK_WAIT);
    CHECK_NEAR(check, self.block[10].output.value, 0.0, 0.0);
    CHECK_INT(check, self.block[11].kind, NCK_BLOCK_END);
    CHECK_NEAR(check, self.block[11].output.value, 2.0, 0.0);
}

static void a_tool_change_stops_the_spindle(check_t *check) {
    case_begin(&self);
    case_decode(&self, "F100 S500 M3\nG1 X1\nM6\nX2\nM3 X3\nM2\n");
    CHECK_INT(check, self.errors, 0);
    CHECK_INT(check, self.block[3].kind, NCK_BLOCK_OUTPUT);
    CHECK_NEAR(check, self.block[3].output.value, 5.0, 0.0);
    CHECK_INT(check, self.block[4].kind, NCK_BLOCK_WAIT);
    CHECK_NEAR(check, self.block[4].output.value, 6.0, 0.0);
    CHECK_NEAR(check, self.block[2].spindle_rpm, 500.0, 0.0);
    CHECK_NEAR(check, self.block[5].spindle_rpm, 0.0, 0.0);
    CHECK_NEAR(check, self.block[7].spindle_rpm, 500.0, 0.0);
    check_error(check, &self, "G95 F.1 S9 M3 G1 X1\nM6\nX2\nX3\nM2\n", NCK_E_FEED_MISSING, 3, 0);
}

static void a_repeated_speed_is_handed_over_once(check_t *check) {
    case_begin(&self);
    case_decode(&self, "G0 X1 S100\nX2 S100\nX3 S200\nX4 S0\nX5 S0\nM30\n");
    CHECK_INT(check, self.blocks, 5 + 3 + 1);
    CHECK_NEAR(check, self.block[8].output.value, 30.0, 0.0);
}

static void m1_stops_only_where_the_machine_wants_it(check_t *check) {
    case_begin(&self);
    case_decode(&self, "M1\nM2\n");
    CHECK_INT(check, self.block[0].kind, NCK_BLOCK_OUTPUT);
    self.machine.dialect.optional_stop = 1;
    case_decode(&self, "M1\nM60\nM2\n");
    CHECK_INT(check, self.block[0].kind, NCK_BLOCK_WAIT);
    CHECK_INT(check, self.block[1].kind, NCK_BLOCK_WAIT);
}

static void letters_blanks_and_comments_may_be_anywhere(check_t *check) {
    case_begin(&self);
    case_decode(&self, "n10 g 0 (to 10 here) x 1 0 y-\t5 ; and (on\n"
                       "N20(only a remark)\n\n\t \nG0X2Y3Z4N30\nO1001 (name)\nO7\nm2\n");
    CHECK_INT(check, self.errors, 0);
    CHECK_INT(check, self.blocks, 3);
    CHECK_INT(check, self.block[0].target_nm[0], 10000000);
    CHECK_INT(check, self.block[0].target_nm[1], -5000000);
    CHECK_INT(check, self.block[1].target_nm[2], 4000000);
    CHECK_INT(check, self.block[1].line, 5);
}

static void a_slash_skips_the_line_where_the_machine_wants_it(check_t *check) {
    case_begin(&self);
    case_decode(&self, "G0 X1\n /X2\nM2\n");
    CHECK_INT(check, self.blocks, 3);
    self.machine.dialect.block_skip = 1;
    case_decode(&self, "G0 X1\n /X2 #nonsense\nM2\n");
    CHECK_INT(check, self.blocks, 2);
    CHECK_INT(check, self.errors, 0);
}

// Of a G code of another language: a build without some of the tables cannot say whose it is.
#define OTHER_BASE \
    (NCK_HAS_CYCLES && NCK_HAS_CONTOUR && NCK_HAS_LAYOUTS ? NCK_E_OTHER_BASE : NCK_E_UNSUPPORTED)

typedef struct wrong {
    const char *text;
    nck_status_t code;
    unsigned line, column;
} wrong_t;

static const wrong_t wrongs[] = {
    {"G0 X1 !\nM2\n", NCK_E_CHARACTER, 1, 7},
    {"G0 X1\n5 X2\nM2\n", NCK_E_CHARACTER, 2, 1},
    {"G0 X1 )\nM2\n", NCK_E_CHARACTER, 1, 7},
    {"G0 X\nM2\n", NCK_E_NUMBER, 1, 4},
    {"G0 X1.2.3\nM2\n", NCK_E_NUMBER, 1, 8},
    {"G0 X1-2\nM2\n", NCK_E_NUMBER, 1, 6},
    {"GX1\nM2\n", NCK_E_NUMBER, 1, 1},
    {"G0 X2000000\nM2\n", NCK_E_NUMBER_RANGE, 1, 4},
    {"G20 G0 Y39371\nM2\n", NCK_E_NUMBER_RANGE, 1, 8},
    {"G0 X900000\nG91 X900000\nM2\n", NCK_E_NUMBER_RANGE, 2, 5},
    {"F-1\nM2\n", NCK_E_NUMBER_RANGE, 1, 1},
    {"S-1\nM2\n", NCK_E_NUMBER_RANGE, 1, 1},
    {"T1.5\nM2\n", NCK_E_NUMBER_RANGE, 1, 1},
    {"G4 P-1\nM2\n", NCK_E_NUMBER_RANGE, 1, 4},
    {"G4 P1000001\nM2\n", NCK_E_NUMBER_RANGE, 1, 4},
    {"G0 X1 (remark\nM2\n", NCK_E_COMMENT, 1, 7},
    {"G0 X1 E5\nM2\n", NCK_E_WORD_UNKNOWN, 1, 7},
    {"G0 X1 Y2 X3\nM2\n", NCK_E_WORD_TWICE, 1, 10},
    {"G0 X1 I1\nM2\n", NCK_E_WORD_UNUSED, 1, 7},
    {"G0 X1 P1\nM2\n", NCK_E_WORD_UNUSED, 1, 7},
    {"G49 H1\nM2\n", NCK_E_WORD_UNUSED, 1, 5},
    {"G40 D1\nM2\n", NCK_E_WORD_UNUSED, 1, 5},
    {"G80 X1\nM2\n", NCK_E_WORD_UNUSED, 1, 5},
    {"G4\nM2\n", NCK_E_WORD_MISSING, 1, 1},
    {"G92\nM2\n", NCK_E_WORD_MISSING, 1, 1},
    {"G10 P1 X1\nM2\n", NCK_E_WORD_MISSING, 1, 1},
    {"G10 L2 X1\nM2\n", NCK_E_WORD_MISSING, 1, 1},
    {"G53\nM2\n", NCK_E_WORD_MISSING, 1, 1},
    {"G53 G2 X1 R5 F1\nM2\n", NCK_E_WORD_MISSING, 1, 1},
    {"G0 G12.34 X1\nM2\n", NCK_E_G_UNKNOWN, 1, 4},
    {"G55.5\nM2\n", NCK_E_G_UNKNOWN, 1, 1},
    {"M428\nM2\n", NCK_E_M_UNKNOWN, 1, 1},
    {"M3.5\nM2\n", NCK_E_M_UNKNOWN, 1, 1},
    {"G0 G1 X1\nM2\n", NCK_E_MODAL_GROUP, 1, 4},
    {"G0 G80 G1 X1\nM2\n", NCK_E_MODAL_GROUP, 1, 8},
    {"G80 G80\nM2\n", NCK_E_MODAL_GROUP, 1, 5},
    {"F9 G64 P2 G2 I3 J4\nM2\n", NCK_E_WORD_SHARED, 1, 8},
    {"F9 G2 I3\nG64 P2 I3\nM2\n", NCK_E_WORD_SHARED, 2, 5},
    {"F9 G4 P2 G2 I3 J4\nM2\n", NCK_E_WORD_SHARED, 1, 7},
    {"G4 P2 G64\nM2\n", NCK_E_WORD_SHARED, 1, 4},
    {"G10 L2 P1 X1 G64\nM2\n", NCK_E_WORD_SHARED, 1, 8},
    {"G91 G53 G0 X1\nM2\n", NCK_E_INCREMENTAL, 1, 5},
    {"G91\nG53 G0 X1\nM2\n", NCK_E_INCREMENTAL, 2, 1},
    {"G92 S500\nM2\n", NCK_E_UNSUPPORTED, 1, 1},
    {"G50 S500\nM2\n", OTHER_BASE, 1, 1},
    {"M19\nM2\n", NCK_E_UNSUPPORTED, 1, 1},
    {"G17 G18\nM2\n", NCK_E_MODAL_GROUP, 1, 5},
    {"M3 M4\nM2\n", NCK_E_MODAL_GROUP, 1, 4},
    {"M7 M9\nM2\n", NCK_E_MODAL_GROUP, 1, 4},
    {"G0 G28 X1\nM2\n", NCK_E_MODAL_GROUP, 1, 4},
    {"G0 G41.1 X1\nM2\n", NCK_E_WORD_MISSING, 1, 4},
    {"G41.1 D4 L10\nM2\n", NCK_E_NUMBER_RANGE, 1, 10},
    {"G42 D1.5\nM2\n", NCK_E_NUMBER_RANGE, 1, 5},
    {"G41 L2\nM2\n", NCK_E_WORD_UNUSED, 1, 5},
    {"G17 G41.1 D4 L2\nM2\n", NCK_E_COMP_PLANE, 1, 5},
    {"G41.1 D4\nG42.1 D4\nM2\n", NCK_E_COMP_ON, 2, 1},
    {"G41.1 D4\nG18\nM2\n", NCK_E_COMP_ON, 2, 1},
    {"G41.1 D4\nN5 G55\nM2\n", NCK_E_COMP_ON, 2, 4},
    {"G41.1 D4\nG49\nM2\n", NCK_E_COMP_ON, 2, 1},
    {"G41.1 D4\nG92 X0\nM2\n", NCK_E_COMP_ON, 2, 1},
    {"G41.1 D4\nG28\nM2\n", NCK_E_COMP_ON, 2, 1},
    {"G41.1 D4\nG0 G53 X1\nM2\n", NCK_E_COMP_ON, 2, 4},
    {"G41.1 D4\nG40 M6\nM2\n", NCK_E_COMP_ON, 2, 5},
    {"G0 X1\n G87 Z-1 R1\nM2\n", NCK_E_UNSUPPORTED, 2, 2},
    {"G6.2 X1 Y1 P1\nM2\n", NCK_E_UNSUPPORTED, 1, 1},
    {"G10 L3 P1 X0\nM2\n", NCK_E_UNSUPPORTED, 1, 5},
    {"G0 X1\nY2 U3\nM2\n", NCK_E_AXIS_UNKNOWN, 2, 4},
    {"X1\nM2\n", NCK_E_NO_MOTION, 1, 1},
    {"G0 X1\nG80\nF5 Z2\nM2\n", NCK_E_NO_MOTION, 3, 4},
    {"G1 X1\nM2\n", NCK_E_FEED_MISSING, 1, 0},
    {"G93 F2 G1 X1\nX2\nM2\n", NCK_E_FEED_MISSING, 2, 0},
    {"F100 G93 G1 X1\nG94 X2\nM2\n", NCK_E_FEED_MISSING, 2, 0},
    {"G95 F0.1 G1 X1\nM2\n", NCK_E_FEED_MISSING, 1, 0},
};

// Where the capacities leave parameters out.
static const wrong_t left_out[] = {
    {"M98 P1\nM2\n", NCK_E_UNSUPPORTED, 1, 1},
    {"G65 P1 X1\nM2\n", NCK_E_UNSUPPORTED, 1, 1},
    {"#1=5\nM2\n", NCK_E_UNSUPPORTED, 1, 1},
    {"G0 X#1\nM2\n", NCK_E_UNSUPPORTED, 1, 4},
    {"G0 X [1+2]\nM2\n", NCK_E_UNSUPPORTED, 1, 4},
    {"G0 X-SIN[2]\nM2\n", NCK_E_UNSUPPORTED, 1, 4},
    {"o100 sub\nM2\n", NCK_E_UNSUPPORTED, 1, 1},
    {"o<cut> call\nM2\n", NCK_E_UNSUPPORTED, 1, 1},
    {"N5 IF [#1 EQ 2] GOTO 7\nM2\n", NCK_E_UNSUPPORTED, 1, 4},
    {"GOTO 7\nM2\n", NCK_E_UNSUPPORTED, 1, 1},
};

static void what_is_left_out_is_told(check_t *check) {
    case_begin(&self);
    for (unsigned k = 0; k < sizeof left_out / sizeof left_out[0] && !NCK_HAS_VARIABLES; k++) {
        const wrong_t *const row = &left_out[k];
        check_error(check, &self, row->text, row->code, row->line, row->column);
    }
}

static void every_mistake_is_one_error_with_its_place(check_t *check) {
    case_begin(&self);
    for (unsigned k = 0; k < sizeof wrongs / sizeof wrongs[0]; k++) {
        const wrong_t *const row = &wrongs[k];
        check_error(check, &self, row->text, row->code, row->line, row->column);
    }
}

// What RS274NGC and Fanuc's controls name and the kernel does not build: told apart from nonsense.
static void check_code(check_t *check, const char *code, nck_status_t status) {
    char text[32];
    memset(text, 0, sizeof text);
    memcpy(text, code, strlen(code));
    memcpy(text + strlen(code), "\nM2\n", 4);
    check_error(check, &self, text, status, 1, 1);
}

static void standard_codes_are_unsupported_not_unknown(check_t *check) {
    static const char *const codes[] = {
        "G17.1", "G38.2", "G70", "G71", "G72", "G87", "G88", "M19", "M41"
    };
    case_begin(&self);
    for (unsigned k = 0; k < sizeof codes / sizeof codes[0]; k++) {
        check_code(check, codes[k], NCK_E_UNSUPPORTED);
    }
}

static void what_another_language_has_is_refused_by_its_name(check_t *check) {
    static const char *const codes[] = {
        "G7.1", "G12.1", "G27", "G29", "G31", "G34", "G41.2", "G42.2", "G43.4", "G44", "G45",
        "G60", "G68.2", "G75", "G77", "G79", "G84.2", "M96", "M198"
    };
    for (unsigned k = 0; k < sizeof codes / sizeof codes[0]; k++) {
        case_begin(&self);
        const nck_status_t status = codes[k][0] == 'M' ? NCK_E_OTHER_BASE : OTHER_BASE;
        check_code(check, codes[k], status);
        CHECK(check, status == NCK_E_UNSUPPORTED
                         || ((int)self.first.limit & NCK_TONGUE_FANUC) != 0);
        self.machine.dialect.base = NCK_DIALECT_FANUC;
        check_code(check, codes[k], NCK_E_UNSUPPORTED);
    }
}

// The safety line of most post-processors: G80 cancels cycles, the motion beside it is in force.
static void g80_beside_a_motion_is_the_motion(check_t *check) {
    case_begin(&self);
    case_decode(&self, "G90 G17 G40 G80 G0 G21\nX1\nF60 G1 G80 X2\nG80 G91 G28 Z0\nM2\n");
    CHECK_INT(check, self.errors, 0);
    CHECK_INT(check, self.blocks, 5);
    CHECK_INT(check, self.block[0].kind, NCK_BLOCK_RAPID);
    CHECK_INT(check, self.block[1].kind, NCK_BLOCK_LINE);
    CHECK_INT(check, self.block[1].target_nm[0], 2000000);
    check_error(check, &self, "G80 G28 Z0\nX1\nM2\n", NCK_E_NO_MOTION, 2, 1);
}

static void a_refused_feed_speed_or_motion_is_one_finding(check_t *check) {
    case_begin(&self);
    check_error(check, &self, "F-1\nG1 X1\nX2\nG2 X3 I.5\nM2\n", NCK_E_NUMBER_RANGE, 1, 1);
    CHECK_INT(check, self.blocks, 1);
    check_error(check, &self, "G1 X1 F1 F2\nM3 S5\nX2\nM2\n", NCK_E_WORD_TWICE, 1, 10);
    check_error(check, &self, "G0 G41.2 X1 f 200\nG1 X2\nX3\nM2\n", OTHER_BASE, 1, 4);
    check_error(check, &self, "G1 X1\nX2\nX3\nM2\n", NCK_E_FEED_MISSING, 1, 0);
    check_error(check, &self, "G53 G0 Q1 X1\nX2\nX3\nM2\n", NCK_E_WORD_UNUSED, 1, 8);
    check_error(check, &self, "G95 F1 G1\nS-1 M3\nX2\nX3\nM2\n", NCK_E_NUMBER_RANGE, 2, 1);
    case_decode(&self, "F-1\nG1 X1\nF60 X2\nG93 X3\nX4\nM2\n"); // a good F ends the excuse
    CHECK_INT(check, self.errors, 2);
    CHECK_INT(check, self.blocks, 2);
    CHECK_INT(check, self.block[0].target_nm[0], 2000000);
    case_decode(&self, "G0 X1 Q5 (F5)\nG1 X2\nM2\n"); // a remark is no F
    CHECK_INT(check, self.errors, 2);
}

static void a_line_with_an_error_moves_nothing(check_t *check) {
    case_begin(&self);
    case_decode(&self, "G0 X1\nX2 Q7\nX3\nM2\n");
    CHECK_INT(check, self.errors, 1);
    CHECK_INT(check, self.blocks, 3);
    CHECK_INT(check, self.block[1].target_nm[0], 3000000);
}

static void a_tool_must_be_in_the_table_if_there_is_one(check_t *check) {
    case_begin(&self);
    check_error(check, &self, "T77 M6\nM2\n", NCK_OK, 0, 0);
    self.machine.tool_count = 1;
    self.machine.tool[0].number = 5;
    check_error(check, &self, "T77 M6\nM2\n", NCK_E_TOOL_UNKNOWN, 1, 1);
    check_error(check, &self, "G42 D9\nM2\n", NCK_E_TOOL_UNKNOWN, 1, 5);
    check_error(check, &self, "T5 M6\nT0 M6\nM2\n", NCK_OK, 0, 0);
}

static void speed_beyond_the_spindle_is_an_error(check_t *check) {
    case_begin(&self);
    self.machine.spindle.rpm_max = 3000.0;
    check_error(check, &self, "S3000\nS3000.5\nM2\n", NCK_E_NUMBER_RANGE, 2, 1);
    CHECK_NEAR(check, self.first.limit, 3000.0, 0.0);
    CHECK_NEAR(check, self.first.value, 3000.5, 0.0);
}

static void a_number_of_any_length_is_a_finite_finding(check_t *check) {
    char text[NCK_LINE_MAX] = "F";
    case_begin(&self);
    memset(text + 1, '9', sizeof text - 5);
    memcpy(text + sizeof text - 4, "\nM2", 4);
    check_error(check, &self, text, NCK_E_NUMBER_RANGE, 1, 1);
    CHECK(check, self.first.value > 1e100 && self.first.value < 1e300);
}

static void dialects_read_dwell_and_first_motion_their_way(check_t *check) {
    case_begin(&self);
    self.machine.dialect.base = NCK_DIALECT_FANUC;
    case_decode(&self, "X1\nG4 P1500\nG4 X2.5\nG0 G28 Z0\nG61 G0 X5\nM2\n");
    CHECK_INT(check, self.errors, 0);
    CHECK_INT(check, self.blocks, 7);
    CHECK_INT(check, self.block[0].kind, NCK_BLOCK_RAPID);
    CHECK_NEAR(check, self.block[1].dwell_s, 1.5, 0.0);
    CHECK_NEAR(check, self.block[2].dwell_s, 2.5, 0.0);
    CHECK_INT(check, self.block[2].target_nm[0], 1000000);
    CHECK_INT(check, self.block[5].path_mode, NCK_PATH_STOP);
    self.machine.dialect.base = NCK_DIALECT_MARLIN;
    case_decode(&self, "G4 S2\nG4 P250\nG0 X5 Y5\nG28 X0\n");
    CHECK_INT(check, self.errors, 0);
    CHECK_NEAR(check, self.block[0].dwell_s, 2.0, 0.0);
    CHECK_NEAR(check, self.block[1].dwell_s, 0.25, 0.0);
    CHECK_INT(check, self.block[3].target_nm[0], 5000000); // no point on the way
    CHECK_INT(check, self.block[4].target_nm[0], 0);
    CHECK_INT(check, self.block[4].target_nm[1], 5000000);
    self.machine.dialect.base = NCK_DIALECT_GRBL;
    check_error(check, &self, "X1\nM2\n", NCK_OK, 0, 0);
}

static void path_modes_carry_their_tolerance(check_t *check) {
    case_begin(&self);
    self.machine.path.tolerance = 0.02;
    case_decode(&self, "G0 X1\nG61 X2\nG61.1 X3\nG64 X4\nG64 P0.1 X5\nG20 G64 P0.01 Q0.02 X0\n"
                       "G61.1 X1\nG64 X0\nM2\n");
    CHECK_INT(check, self.errors, 0);
    CHECK_NEAR(check, self.block[0].tolerance_mm, 0.02, 0.0);
    CHECK_INT(check, self.block[1].path_mode, NCK_PATH_EXACT);
    CHECK_NEAR(check, self.block[1].tolerance_mm, 0.0, 0.0);
    CHECK_INT(check, self.block[2].path_mode, NCK_PATH_STOP);
    CHECK_INT(check, self.block[3].path_mode, NCK_PATH_CONTINUOUS);
    CHECK_NEAR(check, self.block[3].merge_mm, 0.02, 0.0);
    CHECK_NEAR(check, self.block[4].merge_mm, 0.1, 0.0);
    CHECK_NEAR(check, self.block[5].tolerance_mm, 0.254, 1e-15);
    CHECK_NEAR(check, self.block[5].merge_mm, 0.508, 1e-15);
    CHECK_INT(check, self.block[6].path_mode, NCK_PATH_STOP);
    CHECK_INT(check, self.block[7].path_mode, NCK_PATH_CONTINUOUS);
}

int main(void) {
    check_t check = {0};
    CHECK_RUN(&check, outputs_come_in_the_order_of_execution);
    CHECK_RUN(&check, a_tool_change_stops_the_spindle);
    CHECK_RUN(&check, a_repeated_speed_is_handed_over_once);
    CHECK_RUN(&check, m1_stops_only_where_the_machine_wants_it);
    CHECK_RUN(&check, letters_blanks_and_comments_may_be_anywhere);
    CHECK_RUN(&check, a_slash_skips_the_line_where_the_machine_wants_it);
    CHECK_RUN(&check, what_is_left_out_is_told);
    CHECK_RUN(&check, every_mistake_is_one_error_with_its_place);
    CHECK_RUN(&check, standard_codes_are_unsupported_not_unknown);
    CHECK_RUN(&check, what_another_language_has_is_refused_by_its_name);
    CHECK_RUN(&check, g80_beside_a_motion_is_the_motion);
    CHECK_RUN(&check, a_refused_feed_speed_or_motion_is_one_finding);
    CHECK_RUN(&check, a_line_with_an_error_moves_nothing);
    CHECK_RUN(&check, a_tool_must_be_in_the_table_if_there_is_one);
    CHECK_RUN(&check, speed_beyond_the_spindle_is_an_error);
    CHECK_RUN(&check, a_number_of_any_length_is_a_finite_finding);
    CHECK_RUN(&check, dialects_read_dwell_and_first_motion_their_way);
    CHECK_RUN(&check, path_modes_carry_their_tolerance);
    return check_end(&check);
}
