// SPDX-License-Identifier: MIT
// Geometry without text is executed as the same text is, and text and blocks follow each other.
#include "front_check.h"

static front_t front;

static void begin(uint32_t slope)
{
    front_machine(&front, slope);
    (void)front_start(&front);
}

static nck_block_in_t with_feed(nck_block_in_t block, nck_feed_mode_t mode, double feed)
{
    block.sets |= NCK_IN_SETS_FEED;
    block.feed_mode = (uint8_t)mode;
    block.feed = feed;
    return block;
}

static nck_block_in_t with_path(nck_block_in_t block, nck_path_mode_t mode, double tolerance)
{
    block.sets |= NCK_IN_SETS_PATH;
    block.path_mode = (uint8_t)mode;
    block.tolerance = tolerance;
    return block;
}

static const char *const words =
    "G61 G1 F900 X3 Y0.1234567\nX6 Y4\nG64 P0.01\nX5 Y4.5\nX4 Y4\nX3.5 Y5\n"
    "G3 X1.5 Y5 I-1 J0 Z2 F1200\nG2 X1.5 Y5 I-1 J0 P2\nG4 P0.02\nS500\nM3\nT4\nM8\nG0 X0 Y0\n"
    "G93 G1 X1 Y1 F30\nG95 X2 F0.5\nG61.1 X3 Y3\nG94 F600 X4 Y0\nM9\n";

static void push_the_same(void)
{
    const double end[2] = {1.5, 5.0};
    const double centre[2][2] = {{2.5, 5.0}, {0.5, 5.0}};
    nck_block_in_t helix = front_arc(7, end, centre[0], 1);
    helix.axes |= 1 << NCK_AXIS_Z;
    helix.target[NCK_AXIS_Z] = 2.0;
    const nck_block_in_t path = front_to(1, NCK_IN_LINE, 3.0, 0.1234567);
    const nck_block_in_t blocks[] = {
        with_path(with_feed(path, NCK_FEED_PER_MINUTE, 900.0), NCK_PATH_EXACT, 0.0),
        front_to(2, NCK_IN_LINE, 6.0, 4.0),
        with_path(front_word(3, NCK_IN_SET, 0.0), NCK_PATH_CONTINUOUS, 0.01),
        front_to(4, NCK_IN_LINE, 5.0, 4.5), front_to(5, NCK_IN_LINE, 4.0, 4.0),
        front_to(6, NCK_IN_LINE, 3.5, 5.0), with_feed(helix, NCK_FEED_PER_MINUTE, 1200.0),
        front_arc(8, end, centre[1], -2), front_word(9, NCK_IN_DWELL, 0.02),
        front_word(10, NCK_IN_S, 500.0), front_word(11, NCK_IN_M, 3.0),
        front_word(12, NCK_IN_T, 4.0), front_word(13, NCK_IN_M, 8.0),
        front_to(14, NCK_IN_RAPID, 0.0, 0.0),
        with_feed(front_to(15, NCK_IN_LINE, 1.0, 1.0), NCK_FEED_INVERSE, 30.0),
        with_feed(front_to(16, NCK_IN_LINE, 2.0, 1.0), NCK_FEED_PER_REV, 0.5),
        with_path(front_to(17, NCK_IN_LINE, 3.0, 3.0), NCK_PATH_STOP, 0.0),
        with_feed(front_to(18, NCK_IN_LINE, 4.0, 0.0), NCK_FEED_PER_MINUTE, 600.0),
        front_word(19, NCK_IN_M, 9.0)};
    for (unsigned k = 0; k < sizeof blocks / sizeof blocks[0]; k++) {
        (void)front_push_block(&front, &blocks[k]);
    }
}

static void blocks_are_executed_as_the_same_text(check_t *check)
{
    for (uint32_t slope = NCK_SLOPE_LINEAR; slope <= NCK_SLOPE_JERK; slope++) {
        uint64_t hash[2] = {0, 0}, ticks[2] = {0, 0};
        double values[2] = {0.0, 0.0};
        for (int n = 0; n < 2; n++) {
            begin(slope);
            if (n == 0) front_push(&front, words);
            else push_the_same();
            nck_end(&front.nck);
            front_rest(&front);
            CHECK_INT(check, front.error, NCK_OK);
            CHECK_INT(check, front.outputs, 6); // M2 at the end
            for (uint32_t k = 0; k < 6; k++) values[n] = 10.0 * values[n] + front.output[k].value;
            hash[n] = front.hash;
            ticks[n] = front.moving;
            CHECK_NEAR(check, front_x(&front), 4.0, 1e-9);
        }
        CHECK(check, hash[0] == hash[1] && ticks[0] == ticks[1] && values[0] == values[1]);
    }
}

// The caller's id is what pose and outputs call the block.
static void the_id_comes_back(check_t *check)
{
    begin(NCK_SLOPE_JERK);
    nck_block_in_t block = front_to(70001, NCK_IN_LINE, 1.0, 0.0);
    CHECK_INT(check, front_push_block(&front, &block), NCK_OK);
    block = front_word(5, NCK_IN_M, 8.0);
    CHECK_INT(check, front_push_block(&front, &block), NCK_OK);
    block = front_to(4000000000u, NCK_IN_LINE, 2.0, 2.0);
    CHECK_INT(check, front_push_block(&front, &block), NCK_OK);
    nck_flush(&front.nck);
    front_rest(&front);
    CHECK_INT(check, front.lines, 2);
    CHECK_INT(check, front.line[0], 70001);
    CHECK_INT(check, front.line[1], 4000000000u);
    CHECK_INT(check, front.output[0].line, 5);
}

// Text goes on from a block's target, in its modes; a block from where text has come.
static void text_and_blocks_alternate(check_t *check)
{
    nck_modal_t modal;
    begin(NCK_SLOPE_JERK);
    front_push(&front, "G92 X10 Y10\nG20 G91 G18\nG1 F50 X1\n");
    nck_block_in_t block = front_to(9, NCK_IN_LINE, 12.0, 11.0);
    block = with_path(with_feed(block, NCK_FEED_PER_MINUTE, 720.0), NCK_PATH_CONTINUOUS, 0.02);
    CHECK_INT(check, front_push_block(&front, &block), NCK_OK);
    front_push(&front, "X-0.1\n"); // 2.54 mm back, still a line
    nck_flush(&front.nck);
    front_rest(&front);
    CHECK_NEAR(check, front_x(&front), 2.0 - 2.54, 1e-9);
    CHECK_NEAR(check, front_y(&front), 1.0, 1e-9);
    nck_modal(&front.nck, &modal);
    CHECK_INT(check, modal.motion, 1);
    CHECK(check, modal.inch && modal.incremental && modal.plane == 18);
    CHECK_NEAR(check, modal.feed, 720.0, 0.0);
    CHECK_NEAR(check, modal.tolerance_mm, 0.02, 0.0);
    CHECK_INT(check, modal.position_nm[0], -540000);
    CHECK_INT(check, modal.origin_nm[1], -10000000);
    const double end[2] = {10.0, 12.0}, centre[2] = {9.46, 11.5};
    block = front_arc(10, end, centre, 1);
    CHECK_INT(check, front_push_block(&front, &block), NCK_OK);
    nck_flush(&front.nck);
    front_rest(&front);
    CHECK_INT(check, front.error, NCK_E_ARC_RADIUS);
}

// What is wrong with a block in itself is refused at the door.
static void bad_arguments_are_refused(check_t *check)
{
    const double nan = (double)NAN;
    const double end[2] = {1.0, 1.0};
    nck_block_in_t bad[] = {
        front_to(1, NCK_IN_LINE, nan, 0.0), front_to(2, (nck_in_kind_t)8, 0.0, 0.0),
        front_word(3, NCK_IN_DWELL, -1.0), front_word(4, NCK_IN_M, 3.5),
        front_arc(5, end, end, 0), front_word(6, NCK_IN_S, nan), front_word(7, NCK_IN_T, -1.0),
        with_feed(front_to(8, NCK_IN_LINE, 1.0, 0.0), NCK_FEED_PER_MINUTE, 0.0),
        with_feed(front_to(9, NCK_IN_LINE, 1.0, 0.0), (nck_feed_mode_t)3, 1.0),
        with_path(front_to(10, NCK_IN_LINE, 1.0, 0.0), NCK_PATH_CONTINUOUS, -0.1),
        with_path(front_to(11, NCK_IN_LINE, 1.0, 0.0), (nck_path_mode_t)4, 0.0),
        front_arc(12, end, end, 1), front_to(13, NCK_IN_LINE, 1.0, 0.0)};
    bad[11].plane = 20;
    bad[12].sets = 4;
    begin(NCK_SLOPE_JERK);
    for (unsigned k = 0; k < sizeof bad / sizeof bad[0]; k++) {
        if (!CHECK(check, nck_push_block(&front.nck, &bad[k]) == NCK_E_ARGUMENT)) {
            printf("    block %u\n", (unsigned)bad[k].id);
        }
    }
    const nck_block_in_t good = front_to(14, NCK_IN_LINE, 1.0, 0.0);
    front_push(&front, "G1 X");
    CHECK_INT(check, nck_push_block(&front.nck, &good), NCK_E_STATE);
    front_push(&front, "2\n");
    CHECK_INT(check, nck_push_block(&front.nck, &good), NCK_FULL);
    nck_end(&front.nck);
    CHECK_INT(check, nck_push_block(&front.nck, &good), NCK_E_STATE);
}

// What is wrong with it on this machine, here, is the program's error: told with its id, and all
// before it is executed.
static void program_errors_have_the_id(check_t *check)
{
    const double end[2] = {2.0, 2.0}, centre[2] = {1.5, 1.0};
    nck_block_in_t bad[] = {
        front_to(101, NCK_IN_LINE, 50.0, 0.0), front_to(102, NCK_IN_LINE, 2e6, 0.0),
        front_to(103, NCK_IN_LINE, 1.0, 0.0), front_arc(104, end, centre, 1),
        front_word(105, NCK_IN_M, 987.0), front_word(106, NCK_IN_S, 90000.0),
        with_feed(front_to(107, NCK_IN_LINE, 2.0, 0.0), NCK_FEED_PER_REV, 1.0)};
    const nck_status_t errors[] = {NCK_E_TRAVEL, NCK_E_NUMBER_RANGE, NCK_E_AXIS_UNKNOWN,
                                   NCK_E_ARC_RADIUS, NCK_E_M_UNKNOWN, NCK_E_NUMBER_RANGE,
                                   NCK_E_FEED_MISSING};
    bad[2].axes |= 1 << NCK_AXIS_Z;
    for (unsigned k = 0; k < sizeof bad / sizeof bad[0]; k++) {
        nck_diagnostic_t found;
        front_machine(&front, NCK_SLOPE_JERK);
        front.machine.axis[NCK_AXIS_X].max_nm = 20000000;
        front.machine.axis[NCK_AXIS_Z].present = 0;
        front.machine.spindle.rpm_max = 5000.0;
        (void)front_start(&front);
        const nck_block_in_t good = front_to(100, NCK_IN_LINE, 1.0, 1.0);
        CHECK_INT(check, front_push_block(&front, &good), NCK_OK);
        CHECK_INT(check, front_push_block(&front, &bad[k]), NCK_OK);
        front_rest(&front);
        CHECK_INT(check, front.error, errors[k]);
        CHECK_INT(check, nck_diagnostic(&front.nck, &found), NCK_OK);
        CHECK_INT(check, found.line, bad[k].id);
        CHECK_INT(check, found.column, 0);
        CHECK_NEAR(check, front_x(&front), 1.0, 1e-9);
        CHECK_INT(check, nck_begin(&front.nck), NCK_OK);
    }
}

// Beside a contour an arc of another plane has no radius, nor has another tool the one in force.
static void a_contour_keeps_its_plane_and_tool(check_t *check)
{
    const double end[2] = {40.0, 10.0}, centre[2] = {40.0, 5.0};
    nck_block_in_t blocks[] = {front_arc(7, end, centre, 1), front_word(7, NCK_IN_M, 8.0),
                               front_arc(7, end, centre, 1), front_word(7, NCK_IN_M, 6.0)};
    blocks[2].plane = 18;
    for (int k = 0; k < 4; k++) {
        const double values[] = {0.0, 0.0, 18.0, 6.0};
        nck_diagnostic_t found;
        double told = 0.0;
        begin(NCK_SLOPE_JERK);
        front_push(&front, "G64 P0 F900\nG41.1 D4 G1 X10 Y0\nX40\n");
        CHECK_INT(check, front_push_block(&front, &blocks[k]), NCK_OK);
        nck_end(&front.nck);
        front_rest(&front);
        CHECK_INT(check, front.error, k < 2 ? NCK_OK : NCK_E_COMP_ON);
        while (nck_diagnostic(&front.nck, &found) == NCK_OK) {
            if (found.line == 7) told += found.value;
        }
        CHECK_NEAR(check, told, values[k], 0.0);
    }
}

// M codes do what they do in text: M0 waits, M2 ends, M6 stops the spindle first.
static void codes_mean_what_they_mean_in_text(check_t *check)
{
    begin(NCK_SLOPE_JERK);
    nck_block_in_t block = front_word(1, NCK_IN_M, 6.0);
    CHECK_INT(check, front_push_block(&front, &block), NCK_OK);
    block = front_to(2, NCK_IN_LINE, 1.0, 0.0);
    CHECK_INT(check, front_push_block(&front, &block), NCK_OK);
    block = front_word(3, NCK_IN_M, 2.0);
    CHECK_INT(check, front_push_block(&front, &block), NCK_OK);
    front_rest(&front);
    CHECK_INT(check, front.state, NCK_TICK_WAIT);
    CHECK_INT(check, front.outputs, 2);
    CHECK_NEAR(check, front.output[0].value, 5.0, 0.0);
    nck_resume(&front.nck);
    front_rest(&front);
    CHECK_INT(check, front.status, NCK_DONE);
    CHECK_NEAR(check, front_x(&front), 1.0, 1e-9);
    CHECK_INT(check, nck_push_block(&front.nck, &block), NCK_E_STATE);
}

static nck_status_t set_limits(void)
{
    nck_status_t status = nck_set_limits(&front.nck, &front.machine);
    for (int n = 0; status == NCK_FULL && n < FRONT_TICKS; n++) {
        front_tick(&front);
        status = nck_set_limits(&front.nck, &front.machine);
    }
    return status;
}

// Limits change where they are said to: what was pushed before keeps the old ones to its end.
static void limits_change_in_their_place(check_t *check)
{
    for (uint32_t slope = NCK_SLOPE_LINEAR; slope <= NCK_SLOPE_JERK; slope++) {
        begin(slope);
        front_push(&front, "G64 P0.01\nG1 F4800 X30\nX60 Y1\n");
        front.machine.path.feed_max = 20.0;
        front.machine.axis[NCK_AXIS_X].rapid = 10.0;
        front.machine.axis[NCK_AXIS_X].a_max = 100.0;
        front.machine.path.tolerance = 0.5;
        CHECK_INT(check, set_limits(), NCK_OK);
        front_push(&front, "X30 Y1\nG64 G0 X20\n");
        nck_flush(&front.nck);
        for (int n = 0; n < FRONT_TICKS && front_x(&front) < 59.9999; n++) front_tick(&front);
        CHECK(check, front.v_most > 25.0 && front.v_most < 80.1);
        front.v_most = 0.0;
        for (int n = 0; n < FRONT_TICKS && front_x(&front) > 30.5; n++) front_tick(&front);
        CHECK(check, front.v_most > 11.0 && front.v_most < 20.1);
        front_rest(&front);
        front.v_most = 0.0;
        front_push(&front, "G0 X10\n");
        nck_flush(&front.nck);
        front_rest(&front);
        CHECK(check, front.v_most > 5.0 && front.v_most < 10.1);
        CHECK_NEAR(check, front_x(&front), 10.0, 1e-9);
        nck_modal_t modal;
        nck_modal(&front.nck, &modal);
        CHECK_NEAR(check, modal.tolerance_mm, 0.5, 0.0);
        front.machine.path.a_max = -1.0;
        CHECK_INT(check, nck_set_limits(&front.nck, &front.machine), NCK_E_MACHINE);
    }
}

// How much is under way goes up with what is pushed, and down to nothing.
static void the_queue_tells_what_is_under_way(check_t *check)
{
    nck_queue_t queue;
    begin(NCK_SLOPE_JERK);
    front_push(&front, "G64 P0.01\nG1 X5\nX5 Y5\nM8\nX0\n");
    front_prep(&front);
    nck_queue(&front.nck, &queue);
    CHECK_INT(check, queue.blocks, 4);
    CHECK_INT(check, queue.cells, nck_queue_cells(&front.nck));
    nck_flush(&front.nck);
    front_prep(&front);
    nck_queue(&front.nck, &queue);
    CHECK(check, queue.segs >= 3 && queue.cells > 0);
    front_rest(&front);
    nck_queue(&front.nck, &queue);
    CHECK(check, queue.smooth == 0 && queue.segs == 0);
    CHECK(check, queue.outputs == 0 && queue.cells == 0);
}

int main(void)
{
    check_t check = {0};
    CHECK_RUN(&check, blocks_are_executed_as_the_same_text);
    CHECK_RUN(&check, the_id_comes_back);
    CHECK_RUN(&check, text_and_blocks_alternate);
    CHECK_RUN(&check, bad_arguments_are_refused);
    CHECK_RUN(&check, program_errors_have_the_id);
    if (NCK_HAS_COMP) CHECK_RUN(&check, a_contour_keeps_its_plane_and_tool);
    CHECK_RUN(&check, codes_mean_what_they_mean_in_text);
    CHECK_RUN(&check, limits_change_in_their_place);
    CHECK_RUN(&check, the_queue_tells_what_is_under_way);
    return check_end(&check);
}
