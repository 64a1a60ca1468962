// SPDX-License-Identifier: MIT
// Room 1: canned cycles of drilling and boring, in RS274NGC and in Fanuc's language.
#include "check.h"
#include "decode_check.h"

static decode_case_t self;

// What a program does in the order of its blocks: a letter each (rapid, line, dwell, M code, else
// ?) and the height of the drill in mm, or the number that goes with it.
typedef struct deed {
    char kind;
    double value;
} deed_t;

static char kind_of(const nck_block_t *block) {
    switch (block->kind) {
    case NCK_BLOCK_RAPID: return 'r';
    case NCK_BLOCK_LINE: return 'l';
    case NCK_BLOCK_DWELL: return 'd';
    case NCK_BLOCK_OUTPUT: return block->output.kind == NCK_OUTPUT_M ? 'm' : '?';
    default: return '?';
    }
}

static double value_of(const nck_block_t *block, unsigned drill) {
    if (block->kind == NCK_BLOCK_DWELL) return block->dwell_s;
    if (block->kind == NCK_BLOCK_OUTPUT) return block->output.value;
    return (double)block->target_nm[drill] / 1e6;
}

// From block `first` on; ended by a kind of 0.
static void check_deeds(check_t *check, int first, unsigned drill, const deed_t *deeds) {
    int k = first;
    for (; deeds->kind != 0; deeds++, k++) {
        if (k >= self.blocks) break;
        CHECK_INT(check, kind_of(&self.block[k]), deeds->kind);
        CHECK_NEAR(check, value_of(&self.block[k], drill), deeds->value, 1e-9);
    }
    CHECK_INT(check, deeds->kind, 0);
    CHECK_INT(check, k, self.blocks - 1);
}

static void begin(uint32_t dialect) {
    case_begin(&self);
    self.machine.dialect.base = dialect;
}

static void each_cycle_does_what_it_is_for(check_t *check) {
    begin(NCK_DIALECT_LINUXCNC);
    case_decode(&self, "G21 G90 G99 F60 G0 Z9\nG81 X1 R2 Z-1\nM2\n");
    check_deeds(check, 1, 2, (const deed_t[]){{'r', 9}, {'r', 2}, {'l', -1}, {'r', 2}, {0, 0}});
    case_decode(&self, "G21 G90 G98 F60 G0 Z9\nG82 X1 R2 Z-1 P.5\nM2\n");
    check_deeds(check, 1, 2, (const deed_t[]){{'r', 9}, {'r', 2}, {'l', -1}, {'d', 0.5}, {'r', 9},
                                              {0, 0}});
    case_decode(&self, "G21 G90 G98 F60 G0 Z9\nG85 X1 R2 Z-1\nM2\n");
    check_deeds(check, 1, 2, (const deed_t[]){{'r', 9}, {'r', 2}, {'l', -1}, {'l', 2}, {'r', 9},
                                              {0, 0}});
    case_decode(&self, "G21 G90 G98 F60 G0 Z9\nG89 X1 R2 Z-1 P1\nM2\n");
    check_deeds(check, 1, 2, (const deed_t[]){{'r', 9}, {'r', 2}, {'l', -1}, {'d', 1}, {'l', 9},
                                              {0, 0}});
    case_decode(&self, "G21 G90 G98 F60 M4 G0 Z9\nG86 X1 R2 Z-1 P0\nM2\n");
    check_deeds(check, 2, 2, (const deed_t[]){{'r', 9}, {'r', 2}, {'l', -1}, {'m', 5}, {'r', 9},
                                              {'m', 4}, {0, 0}});
}

static void pecks_back_off_as_linuxcnc_does_and_never_above_r(check_t *check) {
    begin(NCK_DIALECT_LINUXCNC);
    case_decode(&self, "G21 G90 G98 F60 G0 Z9\nG83 X1 R2 Z-1 Q1.5\nM2\n");
    check_deeds(check, 1, 2, (const deed_t[]){{'r', 9}, {'r', 2}, {'l', 0.5}, {'r', 2},
                                              {'r', 0.754}, {'l', -1}, {'r', 9}, {0, 0}});
    case_decode(&self, "G21 G90 G99 F60 G0 Z9\nG73 X1 R2 Z-1 Q2\nM2\n");
    check_deeds(check, 1, 2, (const deed_t[]){{'r', 9}, {'r', 2}, {'l', 0}, {'r', 0.254},
                                              {'l', -1}, {'r', 2}, {0, 0}});
    case_decode(&self, "G21 G90 G99 F60 G0 Z9\nG73 X1 R2 Z1.7 Q.2\nM2\n");
    check_deeds(check, 1, 2, (const deed_t[]){{'r', 9}, {'r', 2}, {'l', 1.8}, {'r', 2},
                                              {'l', 1.7}, {'r', 2}, {0, 0}});
}

static void below_r_the_drill_rises_before_it_goes(check_t *check) {
    begin(NCK_DIALECT_LINUXCNC);
    case_decode(&self, "G21 G90 G98 F60 G0 Z1\nG81 X1 R3 Z-1\nM2\n");
    check_deeds(check, 1, 2, (const deed_t[]){{'r', 3}, {'r', 3}, {'l', -1}, {'r', 3}, {0, 0}});
    CHECK_INT(check, self.block[1].target_nm[0], 0);
    CHECK_INT(check, self.block[2].target_nm[0], 1000000);
}

static void every_plane_has_its_drill(check_t *check) {
    begin(NCK_DIALECT_LINUXCNC);
    case_decode(&self, "G21 G90 G98 F60 G0 Y9\nG18 G81 X1 Z4 R2 Y-1\nM2\n");
    check_deeds(check, 1, 1, (const deed_t[]){{'r', 9}, {'r', 2}, {'l', -1}, {'r', 9}, {0, 0}});
    CHECK_INT(check, self.block[2].target_nm[2], 4000000);
    case_decode(&self, "G21 G90 G98 F60 G0 X9\nG19 G81 Y1 Z4 R2 X-1\nM2\n");
    check_deeds(check, 1, 0, (const deed_t[]){{'r', 9}, {'r', 2}, {'l', -1}, {'r', 9}, {0, 0}});
    check_error(check, &self, "G90 F60\nG81 X1 R2 Z-1\nG18 X3 Z4\nM2\n", NCK_E_WORD_MISSING, 3, 0);
}

static void a_line_of_holes_counts_its_steps(check_t *check) {
    begin(NCK_DIALECT_LINUXCNC);
    case_decode(&self, "G21 G91 G99 F60 G0 Z9\nG81 X2 Y1 R-7 Z-3 L3\nX2 R-7 Z-3\nM2\n");
    CHECK_INT(check, self.errors, 0);
    CHECK_INT(check, self.blocks, 1 + 4 + 3 + 3 + 3 + 1);
    CHECK_INT(check, self.block[10].target_nm[0], 6000000);
    CHECK_INT(check, self.block[10].target_nm[1], 3000000);
    CHECK_INT(check, self.block[13].target_nm[0], 8000000);
    CHECK_INT(check, self.block[12].target_nm[2], -1000000);
    CHECK_INT(check, nck_decode_invariants(&self.decode), 1);
}

// R and depth said in steps are places: a change of the distance mode leaves them where they are.
static void fanuc_keeps_places_and_data(check_t *check) {
    begin(NCK_DIALECT_FANUC);
    case_decode(&self, "G21 G90 F60 G0 Z9\nG91 G81 X2 R-7 Z-3\nG90 X4\nM2\n");
    CHECK_INT(check, self.errors, 0);
    check_deeds(check, 5, 2, (const deed_t[]){{'r', 9}, {'r', 2}, {'l', -1}, {'r', 9}, {0, 0}});
    case_decode(&self, "G21 G90 G99 F60 G0 Z9\nG81 X2 R2 Z-1 K0\nG83 X4 Q2.\nR1\nF70\nM2\n");
    CHECK_INT(check, self.errors, 0);
    check_deeds(check, 1, 2, (const deed_t[]){{'r', 9}, {'r', 2}, {'l', 0}, {'r', 2}, {'r', 0.254},
                                              {'l', -1}, {'r', 2}, {'r', 1}, {'l', -1}, {'r', 1},
                                              {0, 0}});
    case_decode(&self, "G21 G90 F60 G0 Z9\nG82 R2 Z-1 P1500\nG91 X1 K2\nM2\n");
    CHECK_INT(check, self.errors, 0);
    CHECK_NEAR(check, self.block[3].dwell_s, 1.5, 1e-12);
    case_decode(&self, "G21 G90 F60 G0 Z9\nG89 X1 R2 Z-1\nM2\n");
    check_deeds(check, 1, 2, (const deed_t[]){{'r', 9}, {'r', 2}, {'l', -1}, {'l', 2}, {'r', 9},
                                              {0, 0}});
}

static void corners_of_a_cycle_are_not_rounded(check_t *check) {
    begin(NCK_DIALECT_LINUXCNC);
    case_decode(&self, "G21 G90 G98 F60 G64 P1 G0 Z9\nG81 X1 R2 Z-1\nG61.1 X2\nX3\nM2\n");
    CHECK_INT(check, self.block[0].path_mode, NCK_PATH_CONTINUOUS);
    for (int k = 1; k < 5; k++) {
        CHECK_INT(check, self.block[k].path_mode, NCK_PATH_TURNS);
        CHECK_NEAR(check, self.block[k].tolerance_mm, 0.0, 0.0);
    }
    CHECK_INT(check, self.block[5].path_mode, NCK_PATH_STOP);
    CHECK_INT(check, self.block[9].path_mode, NCK_PATH_STOP);
    case_decode(&self, "G21 G90 G98 F60 G61 G0 Z9\nG81 X1 R2 Z-1\nG64 P0.00009 X2\nM2\n");
    for (int k = 1; k < 9; k++) CHECK_INT(check, self.block[k].path_mode, NCK_PATH_EXACT);
}

typedef struct wrong {
    const char *text;
    nck_status_t code;
    unsigned line, column;
} wrong_t;

static void what_a_cycle_lacks_is_told(check_t *check) {
    static const wrong_t wrongs[] = {
        {"G90 F9 G81 X1 Z-1\nM2\n", NCK_E_WORD_MISSING, 1, 8},
        {"G90 F9 G81 X1 R1\nM2\n", NCK_E_WORD_MISSING, 1, 8},
        {"G90 F9 G81\nM2\n", NCK_E_WORD_MISSING, 1, 8},
        {"G90 F9 G82 X1 Z-1 R1\nM2\n", NCK_E_WORD_MISSING, 1, 8},
        {"G90 F9 G83 X1 Z-1 R1\nM2\n", NCK_E_WORD_MISSING, 1, 8},
        {"G90 F9 G81 Z-1 R1\nG82 X2 P1\nM2\n", NCK_E_WORD_MISSING, 2, 1},
        {"G90 F9 G86 Z-1 R1 P1\nM2\n", NCK_E_WORD_MISSING, 1, 8},
        {"G90 F9 G83 X1 Z-1 R1 Q0\nM2\n", NCK_E_NUMBER_RANGE, 1, 22},
        {"G90 F9 G81 X1 Z2 R1\nM2\n", NCK_E_NUMBER_RANGE, 1, 18},
        {"G90 F9 G81 X1 Z-2 R1 L0\nM2\n", NCK_E_NUMBER_RANGE, 1, 22},
        {"G90 F9 G81 X1 Z-2 R1 L1.5\nM2\n", NCK_E_NUMBER_RANGE, 1, 22},
        {"G90 F9 G81 X1 Z-2 R1 K2\nM2\n", NCK_E_WORD_UNUSED, 1, 22},
        {"G90 F9 G81 X1 Z-2 R1 A2\nM2\n", NCK_E_AXIS_UNKNOWN, 1, 22},
        {"G90 F9 G81 X1 Z-2 R1 Q2\nM2\n", NCK_E_WORD_UNUSED, 1, 22},
        {"G90 F9 G82 X1 Z-2 R1 P2 G4\nM2\n", NCK_E_WORD_SHARED, 1, 22},
        {"G90 F9 G81 X1 Z-2 R1\nP1\nM2\n", NCK_E_WORD_UNUSED, 2, 1},
        {"G90 G81 X1 Z-2 R1\nM2\n", NCK_E_FEED_MISSING, 1, 0},
        {"G93 F9 G81 X1 Z-2 R1\nM2\n", NCK_E_UNSUPPORTED, 1, 0},
        {"G91 F9 G81 X1000 Z-2 R1 L1000000\nM2\n", NCK_E_NUMBER_RANGE, 1, 12},
        {"G90 F9 G81 X1 Z-2 R1 P1\nM2\n", NCK_E_WORD_UNUSED, 1, 22},
        {"G90 F9 G83 X1 Z-1 R1\nX2\nX3 Q2\nM2\n", NCK_E_WORD_MISSING, 1, 8},
        {"G90 F9 G83 X1 Z-1 R1 Q0\nX2\nX3 Q2\nM2\n", NCK_E_NUMBER_RANGE, 1, 22},
        {"G98 G99\nM2\n", NCK_E_MODAL_GROUP, 1, 5},
        {"G81 G82 X1\nM2\n", NCK_E_MODAL_GROUP, 1, 5},
        {"G90 F9 G53 G81 X1 Z-2 R1\nM2\n", NCK_E_WORD_MISSING, 1, 8}
    };
    begin(NCK_DIALECT_LINUXCNC);
    for (unsigned k = 0; k < sizeof wrongs / sizeof wrongs[0]; k++) {
        check_error(check, &self, wrongs[k].text, wrongs[k].code, wrongs[k].line,
                    wrongs[k].column);
    }
    begin(NCK_DIALECT_FANUC);
    check_error(check, &self, "G90 F9 G81 X1 Z-2 R1 K2 L2\nM2\n", NCK_E_WORD_SHARED, 1, 22);
    self.machine.kinematics = NCK_KINEMATICS_LATHE_XZ;
    check_error(check, &self, "F9 G82 Z-2 R1 P2\nM2\n", NCK_E_UNSUPPORTED, 1, 4);
}

// Nothing moves until the whole row of holes is known to be within the travel.
static void a_row_that_leaves_the_travel_moves_nothing(check_t *check) {
    begin(NCK_DIALECT_LINUXCNC);
    self.machine.axis[0].max_nm = 5000000;
    self.machine.axis[2].min_nm = -1000000;
    check_error(check, &self, "G91 F9 G99 G81 X2 Z-1 R1 L3\nM2\n", NCK_E_TRAVEL, 1, 16);
    CHECK_INT(check, self.blocks, 1);
    check_error(check, &self, "G90 F9 G81 X2 Z-1.1 R1\nM2\n", NCK_E_TRAVEL, 1, 15);
    check_error(check, &self, "G91 F9 G81 X2 Z-1 R1 L2\nM2\n", NCK_OK, 0, 0);
}

static void without_cycles_they_are_unsupported(check_t *check) {
    begin(NCK_DIALECT_LINUXCNC);
    check_error(check, &self, "G0 X1\n G81 Z-1 R1\nM2\n", NCK_E_UNSUPPORTED, 2, 2);
    check_error(check, &self, "G98\nM2\n", NCK_E_UNSUPPORTED, 1, 1);
}

int main(void) {
    check_t check = {0};
    if (NCK_HAS_CYCLES) {
        CHECK_RUN(&check, each_cycle_does_what_it_is_for);
        CHECK_RUN(&check, pecks_back_off_as_linuxcnc_does_and_never_above_r);
        CHECK_RUN(&check, below_r_the_drill_rises_before_it_goes);
        CHECK_RUN(&check, every_plane_has_its_drill);
        CHECK_RUN(&check, a_line_of_holes_counts_its_steps);
        CHECK_RUN(&check, fanuc_keeps_places_and_data);
        CHECK_RUN(&check, corners_of_a_cycle_are_not_rounded);
        CHECK_RUN(&check, what_a_cycle_lacks_is_told);
        CHECK_RUN(&check, a_row_that_leaves_the_travel_moves_nothing);
    } else {
        CHECK_RUN(&check, without_cycles_they_are_unsupported);
    }
    return check_end(&check);
}
