// SPDX-License-Identifier: MIT
// Room 1: corners that ,R rounds and ,C cuts off.
#include <math.h>  // hypot
#include <stdio.h> // snprintf

#include "check.h"
#include "decode_check.h"

static decode_case_t self;

static void begin(void) {
    case_begin(&self);
    self.machine.dialect.base = NCK_DIALECT_FANUC;
}

static void begin_lathe(void) {
    begin();
    self.machine.dialect.system = (uint8_t)NCK_SYSTEM_A;
    self.machine.dialect.plane = 18;
    self.machine.dialect.diameter = 1;
    self.machine.kinematics = NCK_KINEMATICS_LATHE_XZ;
}

// A block: its kind and where it ends, along two axes [mm].
static void check_block(check_t *check, int k, nck_block_kind_t kind, double u, double v) {
    const nck_block_t *const block = &self.block[k];
    const int z = block->plane == 18;
    CHECK_INT(check, block->kind, kind);
    CHECK_NEAR(check, (double)block->target_nm[z ? 2 : 0] / 1e6, u, 2e-6);
    CHECK_NEAR(check, (double)block->target_nm[z ? 0 : 1] / 1e6, v, 2e-6);
}

static void a_right_angle_is_rounded_and_cut_off(check_t *check) {
    begin();
    case_decode(&self, "G21 G90 G17 G1 X10 Y0 F100 ,R2\nY20 ,C3\nX0\nM30\n");
    CHECK_INT(check, self.errors, 0);
    check_block(check, 0, NCK_BLOCK_LINE, 8, 0);
    check_block(check, 1, NCK_BLOCK_ARC, 10, 2);
    CHECK_NEAR(check, self.block[1].centre_mm[0], 8.0, 2e-6);
    CHECK_NEAR(check, self.block[1].centre_mm[1], 2.0, 2e-6);
    CHECK_NEAR(check, self.block[1].sweep_rad, 0.5 * 3.14159265358979, 1e-6);
    check_block(check, 2, NCK_BLOCK_LINE, 10, 17);
    check_block(check, 3, NCK_BLOCK_LINE, 7, 20);
    check_block(check, 4, NCK_BLOCK_LINE, 0, 20);
    CHECK_INT(check, self.block[1].line, 1);
    CHECK_INT(check, self.block[3].line, 2);
    CHECK_NEAR(check, self.block[1].feed, 100.0, 0.0);
}

// The words of the second line count behind the corner and before its move.
static void outputs_keep_their_place(check_t *check) {
    begin();
    case_decode(&self, "G21 G90 G1 X10 Y0 F100 M8 ,R2\n(far)\nF50\nY20 S500 M3 M9\nX0\nM30\n");
    CHECK_INT(check, self.errors, 0);
    CHECK_INT(check, self.block[0].kind, NCK_BLOCK_OUTPUT);
    check_block(check, 1, NCK_BLOCK_LINE, 8, 0);
    check_block(check, 2, NCK_BLOCK_ARC, 10, 2);
    for (int k = 3; k < 6; k++) {
        check_block(check, k, NCK_BLOCK_OUTPUT, 10, 2);
        CHECK_INT(check, self.block[k].line, 4);
    }
    check_block(check, 6, NCK_BLOCK_LINE, 10, 20);
    CHECK_NEAR(check, self.block[6].spindle_rpm, 500.0, 0.0);
    CHECK_NEAR(check, self.block[2].spindle_rpm, 0.0, 0.0);
    CHECK_NEAR(check, self.block[2].feed, 100.0, 0.0);
    CHECK_NEAR(check, self.block[6].feed, 50.0, 0.0);
}

// A line up to an arc about (10, 10) of radius 10, from (10, 0) anticlockwise.
static void a_line_and_an_arc_are_rounded_without_a_bend(check_t *check) {
    begin();
    case_decode(&self, "G21 G90 G17 G0 X10 Y-20\nG1 Y0 F100 ,R2\nG3 X20 Y10 J10\nM30\n");
    CHECK_INT(check, self.errors, 0);
    const nck_block_t *const arc = &self.block[2];
    CHECK_INT(check, arc->kind, NCK_BLOCK_ARC);
    CHECK_INT(check, arc->sweep_rad < 0.0, 1);
    CHECK_NEAR(check, arc->centre_mm[0], 12.0, 2e-6);
    CHECK_NEAR(check, hypot(arc->centre_mm[0] - 10.0, arc->centre_mm[1] - 10.0), 12.0, 4e-6);
    CHECK_INT(check, self.block[3].kind, NCK_BLOCK_ARC);
    CHECK_NEAR(check, self.block[3].centre_mm[0], 10.0, 1e-5);
    CHECK_NEAR(check, self.block[3].centre_mm[1], 10.0, 1e-5);
    check_block(check, 3, NCK_BLOCK_ARC, 20, 10);
}

// A corner may take all of a side, as its end is rounded to whole nanometres twice; no more.
static void a_corner_may_use_up_a_side_and_no_more(check_t *check) {
    static const char *const fits[] = {",R10", ",R10.000001", ",C10", ",C10.000001"};
    static const char *const wide[] = {",R10.000003", ",R10.001", ",C10.000003", ",C10.001"};
    char text[80];
    begin();
    for (unsigned k = 0; k < 4; k++) {
        snprintf(text, sizeof text, "G21 G90 G1 X10 Y0 F9 %s\nY20\nM30\n", fits[k]);
        case_decode(&self, text);
        CHECK_INT(check, self.errors, 0);
        snprintf(text, sizeof text, "G21 G90 G1 X20 Y0 F9 %s\nY10\nM30\n", fits[k]);
        case_decode(&self, text);
        CHECK_INT(check, self.errors, 0);
        snprintf(text, sizeof text, "G21 G90 G1 X10 Y0 F9 %s\nY20\nM30\n", wide[k]);
        check_error(check, &self, text, NCK_E_CORNER, 1, 23);
        snprintf(text, sizeof text, "G21 G90 G1 X20 Y0 F9 %s\nY10\nM30\n", wide[k]);
        check_error(check, &self, text, NCK_E_CORNER, 1, 23);
    }
}

static void a_corner_that_does_not_fit_is_one_error(check_t *check) {
    static const struct {
        const char *text;
        unsigned line, column;
    } cases[] = {
        {"G21 G90 G1 X10 Y0 F9 ,R11\nY20\nM30\n", 1, 23},
        {"G21 G90 G1 X10 Y0 F9 ,C11\nY20\nM30\n", 1, 23},
        {"G21 G90 G1 X10 Y0 F9 ,R2\nX20\nM30\n", 1, 23},
        {"G21 G90 G1 X10 Y0 F9 ,R2\nX5\nM30\n", 1, 23},
        {"G21 G90 G1 X10 Y0 F9 ,R2\nG0 Y9\nM30\n", 1, 23},
        {"G21 G90 G1 X10 Y0 F9 ,R2\nM8\nY9\nM30\n", 1, 23},
        {"G21 G90 G1 X10 Y0 F9 ,R2\nM30\n", 1, 23},
        {"G21 G90 G1 X10 Y0 F9 ,R2\n", 1, 23},
        {"G21 G90 G1 X10 Y0 F9 ,R2\nG4 P9\nY9\nM30\n", 1, 23},
        {"G21 G90 G1 X10 Y0 F9 ,R2\nG18\nM30\n", 1, 23},
        {"G21 G90 G1 X10 Y0 F9 ,R2\nY20 Z1\nM30\n", 1, 23},
        {"G21 G90 G1 X10 Y0 F9 ,R-2\nY20\nM30\n", 1, 23},
        {"G21 G90 G0 X10 Y0 F9 ,R2\nG1 Y20\nM30\n", 1, 23},
        {"G21 G90 G1 F9 ,R2\nY20\nM30\n", 1, 16}
    };
    begin();
    for (unsigned k = 0; k < sizeof cases / sizeof cases[0]; k++) {
        check_error(check, &self, cases[k].text, NCK_E_CORNER, cases[k].line, cases[k].column);
    }
    check_error(check, &self, "G1 X9 F9 ,R1 ,C2\nY20\nM30\n", NCK_E_WORD_TWICE, 1, 15);
    check_error(check, &self, "G1 X9 F9 ,B1\nY20\nM30\n", NCK_E_CHARACTER, 1, 10);
    check_error(check, &self, "G1 X9 F9 ,R\nY20\nM30\n", NCK_E_NUMBER, 1, 11);
    check_error(check, &self, "G1 X9 F9 ,R0\nY20\nM30\n", NCK_E_NUMBER_RANGE, 1, 11);
    check_error(check, &self, "G51 X0 Y0 P2.\nG1 X9 F9 ,R1\nY20\nM30\n", NCK_E_LAYOUT_ON, 2, 11);
}

static void who_has_no_such_word_refuses_the_comma(check_t *check) {
    case_begin(&self);
    check_error(check, &self, "G1 X9 F9 ,R1\nY20\nM30\n", NCK_E_CHARACTER, 1, 10);
    begin();
    if (!NCK_HAS_CYCLES) {
        check_error(check, &self, "G1 X9 F9 ,R1\nY20\nM30\n", NCK_E_CHARACTER, 1, 10);
    }
}

// On lathes R, I and K without a comma, too: their sign says which way the next move goes.
static void a_lathe_spells_it_without_a_comma(check_t *check) {
    begin_lathe();
    case_decode(&self, "G21 G98 F60 G0 X20 Z2\nG1 Z-10 R2\nX40 K-1\nZ-20 I3\nX60\nM30\n");
    CHECK_INT(check, self.errors, 0);
    check_block(check, 1, NCK_BLOCK_LINE, -8, 10);
    check_block(check, 2, NCK_BLOCK_ARC, -10, 12);
    check_block(check, 3, NCK_BLOCK_LINE, -10, 19);
    check_block(check, 4, NCK_BLOCK_LINE, -11, 20);
    check_block(check, 5, NCK_BLOCK_LINE, -17, 20);
    check_block(check, 6, NCK_BLOCK_LINE, -20, 23);
    check_block(check, 7, NCK_BLOCK_LINE, -20, 30);
    check_error(check, &self, "G21 G98 F60 G0 X20 Z2\nG1 Z-10 R-2\nX40\nM30\n", NCK_E_CORNER, 2, 9);
    check_error(check, &self, "G21 G98 F60 G0 X20 Z2\nG1 Z-10 K2\nX40\nM30\n", NCK_E_CORNER, 2, 9);
    check_error(check, &self, "G21 G98 F60 G0 X20 Z2\nG1 Z-10 R2\nX40 Z-12\nM30\n", NCK_E_CORNER,
                2, 9);
}

int main(void) {
    check_t check = {0};
    if (NCK_HAS_CYCLES) {
        CHECK_RUN(&check, a_right_angle_is_rounded_and_cut_off);
        CHECK_RUN(&check, outputs_keep_their_place);
        CHECK_RUN(&check, a_line_and_an_arc_are_rounded_without_a_bend);
        CHECK_RUN(&check, a_corner_may_use_up_a_side_and_no_more);
        CHECK_RUN(&check, a_corner_that_does_not_fit_is_one_error);
        CHECK_RUN(&check, a_lathe_spells_it_without_a_comma);
    }
    CHECK_RUN(&check, who_has_no_such_word_refuses_the_comma);
    return check_end(&check);
}
