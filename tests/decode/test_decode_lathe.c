// SPDX-License-Identifier: MIT
// Room 1: lathes that speak Fanuc's language, in G-code systems A, B and C.
#include "check.h"
#include "decode_check.h"

static decode_case_t self;

static void begin(nck_system_t system) {
    case_begin(&self);
    self.machine.dialect.feed = NCK_FEED_START_MINUTE;
    self.machine.dialect.base = NCK_DIALECT_FANUC;
    self.machine.dialect.system = (uint8_t)system;
    self.machine.dialect.plane = 18;
    self.machine.dialect.diameter = 1;
    self.machine.kinematics = NCK_KINEMATICS_LATHE_XZ;
}

// A move: rapid or line, to radius X and Z [mm].
typedef struct move {
    char kind;
    double x, z;
} move_t;

// Kinds: r rapid, l a line with a stop where it turns, c a line along a contour.
// The moves from block `first` on; ended by a kind of 0.
static void check_moves(check_t *check, int first, const move_t *moves) {
    int k = first;
    CHECK_INT(check, self.errors, 0);
    for (; moves->kind != 0 && k < self.blocks; moves++, k++) {
        const nck_block_t *const block = &self.block[k];
        CHECK_INT(check, block->kind, moves->kind == 'r' ? NCK_BLOCK_RAPID : NCK_BLOCK_LINE);
        CHECK_NEAR(check, (double)block->target_nm[0] / 1e6, moves->x, 1e-9);
        CHECK_NEAR(check, (double)block->target_nm[2] / 1e6, moves->z, 1e-9);
        CHECK_INT(check, block->feed > 0.0, moves->kind != 'r');
        CHECK_INT(check, block->path_mode,
                  moves->kind == 'c' ? NCK_PATH_CONTINUOUS : NCK_PATH_TURNS);
    }
    CHECK_INT(check, moves->kind, 0);
    CHECK_INT(check, nck_decode_invariants(&self.decode), 1);
}

static void a_turning_cycle_is_a_rectangle_by_every_name(check_t *check) {
    static const move_t cut[] = {{'r', 25, 2}, {'l', 25, -30}, {'l', 30, -30}, {'r', 30, 2},
                                 {0, 0, 0}};
    begin(NCK_SYSTEM_A);
    case_decode(&self, "G21 G98 F60 G0 X60 Z2\nG90 X50 Z-30\nM2\n");
    check_moves(check, 1, cut);
    CHECK_INT(check, self.blocks, 6);
    case_decode(&self, "G21 G98 F60 G0 X60 Z2\nG90 U-10 W-32\nM2\n");
    check_moves(check, 1, cut);
    begin(NCK_SYSTEM_B);
    case_decode(&self, "G21 G94 F60 G90 G0 X60 Z2\nG77 X50 Z-30\nM2\n");
    check_moves(check, 1, cut);
    case_decode(&self, "G21 G94 F60 G90 G0 X60 Z2\nG91 G77 X-10 Z-32\nM2\n");
    check_moves(check, 1, cut);
    begin(NCK_SYSTEM_C);
    case_decode(&self, "G71 G94 F60 G90 G0 X60 Z2\nG20 X50 Z-30\nM2\n");
    check_moves(check, 1, cut);
    case_decode(&self, "G70 G90 G0 X1 Z2\nG71 X1\nM2\n");
    CHECK_INT(check, self.block[0].target_nm[0], 12700000);
    CHECK_INT(check, self.block[1].target_nm[0], 500000);
}

static void a_facing_cycle_goes_the_other_way_round(check_t *check) {
    static const move_t cut[] = {{'r', 30, -1}, {'l', 10, -1}, {'l', 10, 2}, {'r', 30, 2},
                                 {0, 0, 0}};
    begin(NCK_SYSTEM_A);
    case_decode(&self, "G21 G98 F60 G0 X60 Z2\nG94 X20 Z-1\nM2\n");
    check_moves(check, 1, cut);
    begin(NCK_SYSTEM_B);
    case_decode(&self, "G21 G94 F60 G0 X60 Z2\nG79 X20 Z-1\nM2\n");
    check_moves(check, 1, cut);
    begin(NCK_SYSTEM_C);
    case_decode(&self, "G71 G94 F60 G0 X60 Z2\nG24 X20 Z-1\nM2\n");
    check_moves(check, 1, cut);
}

// R is how far from the end of the cut, along the infeed, it begins; a radius.
static void a_taper_begins_by_r_beside_the_end(check_t *check) {
    static const move_t turned[] = {{'r', 20, 2}, {'l', 25, -30}, {'l', 30, -30}, {'r', 30, 2},
                                    {'r', 18, 2}, {'l', 23, -30}, {'l', 30, -30}, {'r', 30, 2},
                                    {0, 0, 0}};
    static const move_t faced[] = {{'r', 30, -3}, {'l', 10, -1}, {'l', 10, 2}, {'r', 30, 2},
                                   {0, 0, 0}};
    begin(NCK_SYSTEM_A);
    case_decode(&self, "G21 G98 F60 G0 X60 Z2\nG90 X50 Z-30 R-5\nX46\nM2\n");
    check_moves(check, 1, turned);
    case_decode(&self, "G21 G98 F60 G0 X60 Z2\nG90 X50 Z-30 I-5\nU-14\nM2\n");
    check_moves(check, 1, turned);
    case_decode(&self, "G21 G98 F60 G0 X60 Z2\nG94 X20 Z-1 R-2\nM2\n");
    check_moves(check, 1, faced);
    case_decode(&self, "G21 G98 F60 G0 X60 Z2\nG94 X20 Z-1 K-2\nM2\n");
    check_moves(check, 1, faced);
    check_error(check, &self, "G21 F9 G0 X60 Z2\nG90 X50 Z-30 R6\nM2\n", NCK_E_NUMBER_RANGE, 2, 14);
    check_error(check, &self, "G21 F9 G0 X60 Z2\nG90 X50 Z2 R-1\nM2\n", NCK_E_NUMBER_RANGE, 2, 12);
    check_error(check, &self, "F9 G0 X60 Z2\nG90 X50 Z-3 R-1 I-1\nM2\n", NCK_E_WORD_SHARED, 2, 17);
    check_error(check, &self, "F9 G0 X60 Z2\nG90 X50 Z-3 K-1\nM2\n", NCK_E_WORD_UNUSED, 2, 13);
}

static void a_cycle_holds_until_another_motion(check_t *check) {
    begin(NCK_SYSTEM_A);
    case_decode(&self, "G21 G98 F60 G0 X60 Z2\nG90 X50 Z-30\nM8\nX40 F70\nW-12\nG1 X20\nM2\n");
    CHECK_INT(check, self.errors, 0);
    CHECK_INT(check, self.blocks, 1 + 4 + 1 + 4 + 4 + 1 + 1);
    CHECK_INT(check, self.block[6].target_nm[0], 20000000);
    CHECK_INT(check, self.block[7].target_nm[2], -30000000);
    CHECK_NEAR(check, self.block[7].feed, 70.0, 0.0);
    CHECK_INT(check, self.block[11].target_nm[2], -10000000);
    CHECK_INT(check, self.block[14].kind, NCK_BLOCK_LINE);
    check_error(check, &self, "G98 F9 G0 X60 Z2\nG90 X50 Z-3\nG94 X40\nM2\n", NCK_E_WORD_MISSING, 3,
                1);
}

// Where a code may mean something else in the program's own system, it is told, not guessed.
static void what_another_system_may_mean_is_refused(check_t *check) {
    begin(NCK_SYSTEM_OPEN);
    check_error(check, &self, "F9 G90 X5\nM2\n", NCK_E_WORD_MISSING, 1, 4);
    CHECK_NEAR(check, self.first.value, 90.0, 0.0);
    check_error(check, &self, "F9 G90 X5\nX4\nX3 R1\nM2\n", NCK_E_WORD_MISSING, 1, 4);
    check_error(check, &self, "F9 G94 Z5\nM2\n", NCK_E_WORD_MISSING, 1, 4);
    check_error(check, &self, "G0 G90 X5\nM2\n", NCK_E_MODAL_GROUP, 1, 4);
    check_error(check, &self, "G91\nM2\n", NCK_E_UNSUPPORTED, 1, 1);
    check_error(check, &self, "G95\nM2\n", NCK_E_UNSUPPORTED, 1, 1);
    check_error(check, &self, "G92 X49.2 Z-20\nX48\nM2\n", NCK_E_WORD_MISSING, 1, 1);
    check_error(check, &self, "G77 X1 Z1\nM2\n", NCK_E_UNSUPPORTED, 1, 1);
    check_error(check, &self, "G50 S500\nM2\n", NCK_OK, 0, 0);
    check_error(check, &self, "F9 G0 X5 Z5\nG90 X4 Z1\nG90 X3 Z1\nM2\n", NCK_OK, 0, 0);
    CHECK_INT(check, case_noted(&self, NCK_NOTE_SYSTEM), 1);
    begin(NCK_SYSTEM_A);
    check_error(check, &self, "F9 G0 X5 Z5\nG90 X4 Z1\nM2\n", NCK_OK, 0, 0);
    CHECK_INT(check, case_noted(&self, NCK_NOTE_SYSTEM), 0);
    check_error(check, &self, "G93 F9 G90 X4 Z-1\nM2\n", NCK_E_UNSUPPORTED, 1, 0);
    self.machine.tool_count = 1;
    self.machine.tool[0] = (nck_tool_t){.number = 1, .orientation = 3, .radius_mm = 0.4};
    check_error(check, &self, "F9 G18 G0 X9 Z9\nG42 D1 X8\nG90 X4 Z-1\nM2\n", NCK_E_COMP_ON, 3, 0);
    begin(NCK_SYSTEM_B);
    check_error(check, &self, "G92 S500\nM2\n", NCK_OK, 0, 0);
    check_error(check, &self, "G81\nM2\n", NCK_E_UNSUPPORTED, 1, 1);
    check_error(check, &self, "G0 U5\nM2\n", NCK_E_AXIS_UNKNOWN, 1, 4);
    begin(NCK_SYSTEM_C);
    check_error(check, &self, "G21\nM2\n", NCK_E_WORD_MISSING, 1, 1);
    check_error(check, &self, "G79 X1 Z1\nM2\n", NCK_E_UNSUPPORTED, 1, 1);
}

// The first line of many a program: nothing moves, and the motion behind it is named.
static void safety_lines_are_read_in_a(check_t *check) {
    begin(NCK_SYSTEM_A);
    case_decode(&self, "G18 G21 G40 G90 G94 G54\nF60 G1 X4\nX6\nG90 G0 X8\nX10\nG90 G4 X2.\nM2\n");
    CHECK_INT(check, self.errors, 0);
    CHECK_INT(check, self.blocks, 6);
    CHECK_INT(check, self.block[0].kind, NCK_BLOCK_LINE);
    CHECK_INT(check, self.block[1].target_nm[0], 3000000);
    CHECK_INT(check, self.block[3].kind, NCK_BLOCK_RAPID);
    CHECK_INT(check, self.block[4].kind, NCK_BLOCK_DWELL);
}

static void feed_modes_have_their_names(check_t *check) {
    begin(NCK_SYSTEM_A);
    case_decode(&self, "G21 S500 M3 G99 F.2 G1 X4\nG98 F60 X5\nM2\n");
    CHECK_INT(check, self.errors, 0);
    CHECK_INT(check, self.block[2].feed_mode, NCK_FEED_PER_REV);
    CHECK_INT(check, self.block[3].feed_mode, NCK_FEED_PER_MINUTE);
    begin(NCK_SYSTEM_B);
    case_decode(&self, "G21 S500 M3 G95 F.2 G1 X4\nG94 F60 X5\nM2\n");
    CHECK_INT(check, self.errors, 0);
    CHECK_INT(check, self.block[2].feed_mode, NCK_FEED_PER_REV);
    CHECK_INT(check, self.block[3].feed_mode, NCK_FEED_PER_MINUTE);
}

static void u_and_w_count_steps(check_t *check) {
    begin(NCK_SYSTEM_A);
    case_decode(&self, "G21 G98 F60 G0 X40 Z5\nG1 U-3.333 W-2.0001\nX10 W1\nG3 U4 W-2 R2\nG4 U1.5\n"
                       "G28 U0 W0\nM2\n");
    CHECK_INT(check, self.errors, 0);
    CHECK_INT(check, self.block[1].target_nm[0], 18333500);
    CHECK_INT(check, self.block[1].target_nm[2], 2999900);
    CHECK_INT(check, self.block[2].target_nm[0], 5000000);
    CHECK_INT(check, self.block[2].target_nm[2], 3999900);
    CHECK_INT(check, self.block[3].kind, NCK_BLOCK_ARC);
    CHECK_INT(check, self.block[3].target_nm[0], 7000000);
    CHECK_NEAR(check, self.block[4].dwell_s, 1.5, 0.0);
    CHECK_INT(check, self.block[5].target_nm[0], 7000000);
    CHECK_INT(check, self.block[6].target_nm[0], 0);
    check_error(check, &self, "G0 X1 U2\nM2\n", NCK_E_WORD_TWICE, 1, 7);
    check_error(check, &self, "G54 G0 U2\nM2\n", NCK_E_INCREMENTAL, 1, 8);
    check_error(check, &self, "G53 G0 W2\nM2\n", NCK_E_INCREMENTAL, 1, 8);
    check_error(check, &self, "G10 L2 P1 W2\nM2\n", NCK_E_INCREMENTAL, 1, 11);
    check_error(check, &self, "G0 V2\nM2\n", NCK_OK, 0, 0); // the default machine has a Y
    check_error(check, &self, "G0 U999999 \nU9999999\nM2\n", NCK_E_NUMBER_RANGE, 2, 1);
    check_error(check, &self, "G0 U2 A1\nM2\n", NCK_E_AXIS_UNKNOWN, 1, 7);
}

// Inches, diameters, both signs: many steps there and back end where they began, to the nanometre.
static void steps_add_up_to_the_nanometre(check_t *check) {
    begin(NCK_SYSTEM_A);
    case_decode(&self, "G20 G98 F60 G0 X1.0003 Z-2.00007\nU.0001 W-.0007\nU-3.30031 W5.00003\n"
                       "U3.30021 W-4.99933\nG50 U.5 W1\nG0 X1.5003 Z-1.00007\nM2\n");
    CHECK_INT(check, self.errors, 0);
    CHECK_INT(check, self.block[0].target_nm[0], 12703810);
    CHECK_INT(check, self.block[3].target_nm[0], 12703810);
    CHECK_INT(check, self.block[3].target_nm[2], self.block[0].target_nm[2]);
    CHECK_INT(check, self.block[4].target_nm[0], 12703810);
    CHECK_INT(check, self.block[4].target_nm[2], self.block[0].target_nm[2]);
}

// A mill and another language know none of this.
static void others_read_their_own_codes(check_t *check) {
    begin(NCK_SYSTEM_A);
    self.machine.kinematics = NCK_KINEMATICS_IDENTITY;
    check_error(check, &self, "F9 G90 X5 Z-3\nG92 X4\nG0 G94 X2\nG0 G90 X1\nM2\n", NCK_OK, 0, 0);
    CHECK_INT(check, self.blocks, 4);
    begin(NCK_SYSTEM_A);
    self.machine.dialect.base = NCK_DIALECT_LINUXCNC;
    check_error(check, &self, "G0 G90 X5 Z-3\nG92 X4\nG94 X2\nM2\n", NCK_OK, 0, 0);
}

static void the_whole_rectangle_is_within_the_travel(check_t *check) {
    begin(NCK_SYSTEM_A);
    self.machine.axis[0].min_nm = 20000000;
    self.machine.axis[2].min_nm = -30000000;
    self.machine.start_nm[0] = 30000000;
    check_error(check, &self, "G98 F60 G90 X50 Z-30 R-5.001\nM2\n", NCK_E_TRAVEL, 1, 13);
    check_error(check, &self, "G98 F60 G90 X50 Z-30.001\nM2\n", NCK_E_TRAVEL, 1, 17);
    CHECK_INT(check, self.blocks, 1);
    check_error(check, &self, "G98 F60 G90 X50 Z-30 R-5\nM2\n", NCK_OK, 0, 0);
    check_error(check, &self, "G98 G90 X50 Z-30\nM2\n", NCK_E_FEED_MISSING, 1, 0);
}

// Lines P … Q are recorded as they come; G70 goes back to them, which pushed text cannot.
static void contours_are_read_from_pushed_text(check_t *check) {
    static const move_t cut[] = {{'r', 8, 0}, {'l', 8, -5}, {'r', 9, -4}, {'r', 9, 0}, {'r', 6, 0},
                                 {'l', 6, -5}, {'r', 7, -4}, {'r', 7, 0}, {'r', 5, 0},
                                 {'l', 5, -5}, {'r', 6, -4}, {'r', 6, 0}, {'c', 5, 0},
                                 {'c', 5, -5}, {'c', 10, -5}, {'r', 10, 0}, {0, 0, 0}};
    static const char *const texts[] = {
        "G21 G98 F60 G0 X20 Z0\nG71 U2 R1\nG71 P1 Q2\nN1 G0 X10\nG1 Z-5\nN2 X20\nG0 X22\nM2\n",
        "G21 G98 F60 G0 X20 Z0\nG71 D2. P1 Q2\nN1 G0 X10\nG1 W-5\nN2 U10\nG0 X22\nM2\n"
    };
    begin(NCK_SYSTEM_A);
    case_decode(&self, texts[0]);
    check_moves(check, 1, cut);
    CHECK_INT(check, self.blocks, 19);
    CHECK_NEAR(check, (double)self.block[17].target_nm[0] / 1e6, 11.0, 1e-9);
    CHECK_INT(check, self.block[1].line, 3);
    case_decode(&self, texts[1]);
    CHECK_INT(check, self.errors, 0);
    begin(NCK_SYSTEM_C);
    case_decode(&self, "G71 G94 F60 G0 X20 Z0\nG73 U2 R1\nG73 P1 Q2\nN1 G0 X10\nG1 Z-5\nN2 X20\n"
                       "G0 X22\nM2\n");
    check_moves(check, 1, cut);
    begin(NCK_SYSTEM_A);
    check_error(check, &self, "N1 G0 X10 F9\nN2 Z-5\nG70 P1 Q2\nM2\n", NCK_E_NO_SEEK, 3, 0);
}

static void pecks_go_back_by_r_and_rows_lie_side_by_side(check_t *check) {
    static const move_t drilled[] = {{'l', 0, -2}, {'r', 0, -1}, {'l', 0, -4}, {'r', 0, -3},
                                     {'l', 0, -5}, {'r', 0, 0}, {0, 0, 0}};
    static const move_t grooves[] = {{'l', 7, -9}, {'r', 7.5, -9}, {'l', 5, -9}, {'r', 10, -9},
                                     {'r', 10, -11}, {'l', 7, -11}, {'r', 7.5, -11},
                                     {'l', 5, -11}, {'r', 10, -11}, {'r', 10, -12},
                                     {'l', 7, -12}, {'r', 7.5, -12}, {'l', 5, -12},
                                     {'r', 10, -12}, {'r', 10, -9}, {0, 0, 0}};
    begin(NCK_SYSTEM_A);
    case_decode(&self, "G21 G98 F60 G0 X0 Z0\nG74 R1.\nG74 Z-5. Q2000\nM2\n");
    check_moves(check, 1, drilled);
    case_decode(&self, "G21 G98 F60 G0 X0 Z0\nG74 R9.\nG74 Z-5. Q2500\nM2\n");
    CHECK_INT(check, self.block[2].target_nm[2], 0); // no further than where it began
    case_decode(&self, "G20 G98 F6 G0 X0 Z0\nG21 G74 R1\nG74 W-5. K2.\nX2\nM2\n");
    check_moves(check, 1, drilled);
    CHECK_INT(check, self.block[7].kind, NCK_BLOCK_RAPID); // G0 holds
    case_decode(&self, "G21 G98 F60 G0 X20 Z-9\nG75 X10. Z-12. P3000 Q2. R0\nM2\n");
    check_moves(check, 1, grooves);
    begin(NCK_SYSTEM_C);
    case_decode(&self, "G71 G94 F60 G90 G0 X20 Z-9\nG77 R.5\nG77 X10. Z-12. I3. K2.\nM2\n");
    check_moves(check, 1, grooves);
    case_decode(&self, "G71 G94 F60 G90 G0 X0 Z0\nG76 R1.\nG76 Z-5. Q2000\nM2\n");
    check_moves(check, 1, drilled);
}

static void a_peck_without_its_words_is_told(check_t *check) {
    begin(NCK_SYSTEM_A);
    check_error(check, &self, "F9 G0 X6 Z2\nG74\nM2\n", NCK_E_WORD_MISSING, 2, 1);
    check_error(check, &self, "F9 G0 X6 Z2\nG74 R-1.\nM2\n", NCK_E_NUMBER_RANGE, 2, 5);
    check_error(check, &self, "F9 G0 X6 Z2\nG74 X3.\nM2\n", NCK_E_WORD_MISSING, 2, 1);
    check_error(check, &self, "F9 G0 X6 Z2\nG74 Z0\nM2\n", NCK_E_WORD_MISSING, 2, 1);
    check_error(check, &self, "F9 G0 X6 Z2\nG74 Q5.\nM2\n", NCK_E_WORD_MISSING, 2, 1);
    check_error(check, &self, "F9 G0 X6 Z2\nG74 X3. Z0 Q9\nM2\n", NCK_E_WORD_MISSING, 2, 1);
    check_error(check, &self, "F9 G0 X6 Z2\nG74 Z0 Q0\nM2\n", NCK_E_NUMBER_RANGE, 2, 8);
    check_error(check, &self, "F9 G0 X6 Z2\nG74 Z0 Q[1/3]\nM2\n", NCK_E_NUMBER_RANGE, 2, 8);
    check_error(check, &self, "F9 G0 X6 Z2\nG74 Z0 Q5 K5\nM2\n", NCK_E_WORD_SHARED, 2, 11);
    check_error(check, &self, "F9 G0 X6 Z2\nG74 Z0 Q5 R1\nM2\n", NCK_E_UNSUPPORTED, 2, 11);
    check_error(check, &self, "G0 X6 Z2\nG74 Z0 Q5\nM2\n", NCK_E_FEED_MISSING, 2, 0);
    self.machine.axis[NCK_AXIS_Z].min_nm = -1000000;
    check_error(check, &self, "F9 G0 X6 Z2\nG74 Z-2. Q5\nM2\n", NCK_E_TRAVEL, 2, 5);
}

int main(void) {
    check_t check = {0};
    if (NCK_HAS_CYCLES) {
        CHECK_RUN(&check, a_turning_cycle_is_a_rectangle_by_every_name);
        CHECK_RUN(&check, a_facing_cycle_goes_the_other_way_round);
        CHECK_RUN(&check, a_taper_begins_by_r_beside_the_end);
        CHECK_RUN(&check, pecks_go_back_by_r_and_rows_lie_side_by_side);
        CHECK_RUN(&check, a_peck_without_its_words_is_told);
        if (NCK_HAS_CONTOUR) CHECK_RUN(&check, contours_are_read_from_pushed_text);
        CHECK_RUN(&check, a_cycle_holds_until_another_motion);
        CHECK_RUN(&check, what_another_system_may_mean_is_refused);
        CHECK_RUN(&check, safety_lines_are_read_in_a);
        CHECK_RUN(&check, the_whole_rectangle_is_within_the_travel);
    }
    CHECK_RUN(&check, feed_modes_have_their_names);
    CHECK_RUN(&check, u_and_w_count_steps);
    CHECK_RUN(&check, steps_add_up_to_the_nanometre);
    CHECK_RUN(&check, others_read_their_own_codes);
    return check_end(&check);
}
