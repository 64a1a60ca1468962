// SPDX-License-Identifier: MIT
// Room 1: targets in machine coordinates, whatever offsets, units and modes are in force.
#include "check.h"
#include "decode_check.h"

static decode_case_t self;

// Block k goes to x, y, z [mm], tool tip in machine coordinates.
static void goes_to(check_t *check, int k, double x, double y, double z) {
    CHECK(check, k < self.blocks);
    CHECK_INT(check, self.errors, 0);
    CHECK_NEAR(check, (double)self.block[k].target_nm[0] / 1e6, x, 1e-9);
    CHECK_NEAR(check, (double)self.block[k].target_nm[1] / 1e6, y, 1e-9);
    CHECK_NEAR(check, (double)self.block[k].target_nm[2] / 1e6, z, 1e-9);
}

static void axes_without_a_word_stay(check_t *check) {
    case_begin(&self);
    self.machine.start_nm[1] = 7000000;
    case_decode(&self, "G0 X1\nZ2\nG91 X1 Z-1\nG1 F60 Y-.5\nM2\n");
    goes_to(check, 0, 1, 7, 0);
    goes_to(check, 1, 1, 7, 2);
    goes_to(check, 2, 2, 7, 1);
    goes_to(check, 3, 2, 6.5, 1);
    CHECK_INT(check, self.block[2].kind, NCK_BLOCK_RAPID);
    CHECK_INT(check, self.block[3].kind, NCK_BLOCK_LINE);
    CHECK_NEAR(check, self.block[2].feed, 0.0, 0.0);
    CHECK_NEAR(check, self.block[3].feed, 60.0, 0.0);
}

static void units_apply_to_their_own_block(check_t *check) {
    case_begin(&self);
    case_decode(&self, "X1 G0 G20\nG1 X2 F10\nG21 X3\nG0 X0 F30\nG1 X1\nM2\n");
    goes_to(check, 0, 25.4, 0, 0);
    goes_to(check, 1, 50.8, 0, 0);
    goes_to(check, 2, 3, 0, 0);
    CHECK_NEAR(check, self.block[1].feed, 254.0, 1e-12);
    CHECK_NEAR(check, self.block[2].feed, 254.0, 1e-12);
    CHECK_NEAR(check, self.block[4].feed, 30.0, 0.0);
}

// RS274NGC sets the feed before the units; other controls know those of the line.
static void a_feed_beside_a_change_of_units_is_in_those_that_the_language_has(check_t *check) {
    case_begin(&self);
    case_decode(&self, "G1 F10 G20 X1\nM2\n");
    CHECK_NEAR(check, self.block[0].feed, 10.0, 1e-12);
    if (NCK_LANGUAGE == 0) return;
    case_begin(&self);
    self.machine.dialect.base = NCK_DIALECT_GRBL;
    case_decode(&self, "G1 F10 G20 X1\nM2\n");
    CHECK_NEAR(check, self.block[0].feed, 254.0, 1e-12);
}

static void work_offsets_shift_the_zero(check_t *check) {
    case_begin(&self);
    self.machine.work_nm[0][0] = 100000000;
    self.machine.work_nm[8][1] = -20000000;
    case_decode(&self, "G0 X1 Y1\nG59.3 X1 Y1\nG54 G10 L2 P2 X5 Z6\nX2\nG55 X0 Y0 Z0\nG53 X0 Z1\n"
                       "G10 L2 P0 X50\nX0\nM2\n");
    goes_to(check, 0, 101, 1, 0);
    goes_to(check, 1, 1, -19, 0);
    goes_to(check, 2, 102, -19, 0);
    goes_to(check, 3, 5, 0, 6);
    goes_to(check, 4, 0, 0, 1);
    goes_to(check, 5, 50, 0, 1);
}

static void g92_renames_the_position(check_t *check) {
    case_begin(&self);
    case_decode(&self, "G0 X10 Y10\nG92 X0\nX1\nG92.2\nX1\nG92.3\nX1\nG92.1\nX1\nG92.3\nX2\n"
                       "G91 X5\nG92 X100\nG90 X101\nM2\n");
    goes_to(check, 1, 11, 10, 0);
    goes_to(check, 2, 1, 10, 0);
    goes_to(check, 3, 11, 10, 0);
    goes_to(check, 4, 1, 10, 0);
    goes_to(check, 5, 2, 10, 0);
    goes_to(check, 6, 7, 10, 0);
    goes_to(check, 7, 8, 10, 0);
}

static void tool_length_moves_the_tip_not_the_machine(check_t *check) {
    case_begin(&self);
    self.machine.tool_count = 2;
    self.machine.tool[0].number = 3;
    self.machine.tool[0].offset_nm[2] = 80000000;
    self.machine.tool[1].number = 4;
    self.machine.tool[1].offset_nm[0] = 1000000;
    case_decode(&self, "G0 Z100\nG43 H3\nX1\nZ100\nG53 Z0\nG49\nX2\nT4 M6\nG43\nX3\nM2\n");
    goes_to(check, 1, 1, 0, 20); // the machine is at 100 still
    CHECK_INT(check, self.block[1].tool_nm[2], 80000000);
    goes_to(check, 2, 1, 0, 100);
    goes_to(check, 3, 1, 0, -80);
    goes_to(check, 4, 2, 0, 0);
    goes_to(check, 8, 3, 0, 0); // behind the tool, the spindle's stop and the wait
    CHECK_INT(check, self.block[8].tool_nm[0], 1000000);
    CHECK_INT(check, self.block[8].tool_nm[2], 0);
}

static void g53_is_the_machine_position_with_the_tool(check_t *check) {
    case_begin(&self);
    self.machine.tool_count = 1;
    self.machine.tool[0].number = 1;
    self.machine.tool[0].offset_nm[2] = 30000000;
    self.machine.work_nm[0][2] = -500000000;
    case_decode(&self, "G43 H1\nG91\nG90 G53 G0 Z-5\nM2\n");
    goes_to(check, 0, 0, 0, -35);
}

static void g28_goes_home_by_way_of_a_point(check_t *check) {
    case_begin(&self);
    self.machine.home_nm[0][2] = 50000000;
    self.machine.home_nm[1][0] = -50000000;
    case_decode(&self, "G0 X1 Y2 Z3\nG91 G28 Z1\nG90 G28\nG30 X10\nM2\n");
    goes_to(check, 1, 1, 2, 4);
    goes_to(check, 2, 1, 2, 50);
    goes_to(check, 3, 1, 2, 50);
    goes_to(check, 4, 0, 0, 50);
    goes_to(check, 5, 10, 0, 50);
    goes_to(check, 6, -50, 0, 50);
}

static void diameter_mode_halves_x_words_only(check_t *check) {
    case_begin(&self);
    self.machine.dialect.diameter = 1;
    self.machine.dialect.plane = 18;
    case_decode(&self, "G0 X20 Z1\nG91 X-1 Z-1\nG90 G92 X30\nX32\nG8 X5\nG7 G20 X1\nM2\n");
    goes_to(check, 0, 10, 0, 1);
    goes_to(check, 1, 9.5, 0, 0);
    goes_to(check, 2, 10.5, 0, 0); // named 30 at 9.5
    goes_to(check, 3, -0.5, 0, 0);
    goes_to(check, 4, 7.2, 0, 0);
}

static void travel_is_checked_on_the_machine_position(check_t *check) {
    case_begin(&self);
    self.machine.axis[2].min_nm = -10000000;
    self.machine.axis[2].max_nm = 100000000;
    self.machine.tool_count = 1;
    self.machine.tool[0].number = 1;
    self.machine.tool[0].offset_nm[2] = 60000000;
    check_error(check, &self, "G0 Z100\nG0 Z-10\nM2\n", NCK_OK, 0, 0);
    check_error(check, &self, "G0 Z100.000001\nM2\n", NCK_E_TRAVEL, 1, 4);
    CHECK_INT(check, self.first.letter, 'Z');
    CHECK_NEAR(check, self.first.value, 100.000001, 1e-12);
    CHECK_NEAR(check, self.first.limit, 100.0, 0.0);
    check_error(check, &self, "G43 H1\nG0 X1 Z40\nG1 F9 X2 Z41\nM2\n", NCK_E_TRAVEL, 3, 10);
    check_error(check, &self, "G91 G28 Z-11\nM2\n", NCK_E_TRAVEL, 1, 9);
    self.machine.start_nm[2] = 200000000; // outside at start: only what moves is looked at
    check_error(check, &self, "G0 X1\nZ50\nM2\n", NCK_OK, 0, 0);
}

static void inverse_time_and_feed_per_revolution(check_t *check) {
    case_begin(&self);
    case_decode(&self, "G93 G1 X1 F30\nX2 F20\nG94 F100 X3\nG95 F.2 S600 M3 X4\nM5\nG0 X0\nM2\n");
    CHECK_INT(check, self.errors, 0);
    CHECK_INT(check, self.block[1].feed_mode, NCK_FEED_INVERSE);
    CHECK_NEAR(check, self.block[1].feed, 20.0, 0.0);
    CHECK_INT(check, self.block[5].feed_mode, NCK_FEED_PER_REV);
    CHECK_NEAR(check, self.block[5].feed, 0.2, 0.0);
    CHECK_NEAR(check, self.block[5].spindle_rpm, 600.0, 0.0);
    CHECK_NEAR(check, self.block[7].spindle_rpm, 0.0, 0.0);
}

static void a_default_feed_is_in_force_before_the_first_f(check_t *check) {
    case_begin(&self);
    self.machine.dialect.feed_default = 500.0;
    case_decode(&self, "G94 G1 X1\nF20 X2\nM2\n");
    CHECK_INT(check, self.errors, 0);
    CHECK_NEAR(check, self.block[0].feed, 500.0, 0.0);
    CHECK_NEAR(check, self.block[1].feed, 20.0, 0.0);
}

static void rotary_axes_count_in_degrees_and_ignore_inches(check_t *check) {
    if (NCK_AXIS_MAX < 4) return;
    case_begin(&self);
    self.machine.axis[NCK_AXIS_Z + 1].present = 1;
    case_decode(&self, "G20\nG1 F100 A90.0000005\nA91 X1\nG91 A1\nG2 I1 A1\nM2\n");
    CHECK_INT(check, self.errors, 0);
    CHECK_INT(check, self.block[0].target_nm[NCK_AXIS_MAX > 3 ? 3 : 0],
              (int64_t)90 * NCK_COUNTS_PER_DEG + NCK_COUNTS_PER_DEG / 2000000);
    CHECK_NEAR(check, self.block[0].feed, 100.0, 0.0);
    CHECK_NEAR(check, self.block[1].feed, 2540.0, 1e-9);
    CHECK_NEAR(check, self.block[2].feed, 100.0, 0.0);
    CHECK_NEAR(check, self.block[3].feed, 2540.0, 1e-9);
}

static void a_motion_code_without_words_only_sets_the_mode(check_t *check) {
    case_begin(&self);
    case_decode(&self, "G1 F100\nX1\nG0\nX2\nM2\n");
    CHECK_INT(check, self.errors, 0);
    CHECK_INT(check, self.blocks, 3);
    CHECK_INT(check, self.block[0].kind, NCK_BLOCK_LINE);
    CHECK_INT(check, self.block[1].kind, NCK_BLOCK_RAPID);
}

int main(void) {
    check_t check = {0};
    CHECK_RUN(&check, axes_without_a_word_stay);
    CHECK_RUN(&check, units_apply_to_their_own_block);
    CHECK_RUN(&check, a_feed_beside_a_change_of_units_is_in_those_that_the_language_has);
    CHECK_RUN(&check, work_offsets_shift_the_zero);
    CHECK_RUN(&check, g92_renames_the_position);
    CHECK_RUN(&check, tool_length_moves_the_tip_not_the_machine);
    CHECK_RUN(&check, g53_is_the_machine_position_with_the_tool);
    CHECK_RUN(&check, g28_goes_home_by_way_of_a_point);
    CHECK_RUN(&check, diameter_mode_halves_x_words_only);
    CHECK_RUN(&check, travel_is_checked_on_the_machine_position);
    CHECK_RUN(&check, inverse_time_and_feed_per_revolution);
    CHECK_RUN(&check, a_default_feed_is_in_force_before_the_first_f);
    CHECK_RUN(&check, rotary_axes_count_in_degrees_and_ignore_inches);
    CHECK_RUN(&check, a_motion_code_without_words_only_sets_the_mode);
    return check_end(&check);
}
