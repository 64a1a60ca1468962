// SPDX-License-Identifier: MIT
// Room 3: what else goes through it: straight and exact blocks, merged ones, outputs, feeds.
#include <string.h> // memcmp memset

#include "check.h"
#include "nck/prep/3_smooth/smooth.h" // nck_smooth_…
#include "smooth_check.h"             // line_to hold_promises

static void straight_blocks_become_straight_segs(check_t *check)
{
    begin();
    for (int k = 1; k < 20; k++) line_to(0.7 * k, 0.3 * k, 0.1 * k, 0.01);
    hold_promises(check, "a straight line");
    CHECK(check, worst_share() < 1e-9);
    begin();
    line_to(30.0, 40.0, 0.0, 0.5);
    CHECK(check, run(&exact, 1) && run(&path, 0));
    CHECK_INT(check, path.segs, 1);
    CHECK_INT(check, path.seg[0].keeps, NCK_KEEP_SMOOTH);
    CHECK_INT(check, exact.seg[0].keeps, NCK_KEEP_NOTHING);
    path.seg[0].keeps = exact.seg[0].keeps;
    CHECK(check, memcmp(&path.seg[0], &exact.seg[0], sizeof path.seg[0]) == 0);
}

// Q joins what is nearly one line, up to nine blocks; never across a feed, an output or a corner.
static void nearly_collinear_lines_are_merged_within_q(check_t *check)
{
    begin();
    for (int k = 1; k <= 36; k++) {
        line_to(0.1 * k, k % 2 ? 0.0003 : 0.0, 0.0, 0.01);
        block[blocks - 1].merge_mm = 0.01;
    }
    hold_promises(check, "merged lines");
    CHECK_INT(check, smooth.raw.head, 4);
    for (int k = 0; k < blocks; k++) block[k].merge_mm = 1e-4;
    hold_promises(check, "lines too far from one for Q");
    CHECK_INT(check, smooth.raw.head, 36);
    for (int k = 0; k < blocks; k++) block[k].merge_mm = 0.01;
    for (int k = 0; k < 18; k++) block[k].feed = 1000.0 + k;
    hold_promises(check, "lines of many feeds");
    CHECK_INT(check, smooth.raw.head, 18 + 2);
    block[30].target_nm[1] += 1000000;
    hold_promises(check, "lines with a spike");
    CHECK_INT(check, smooth.raw.head, 18 + 5);
}

// What is not smoothed is the same to the bit beside a run as alone.
static void exact_blocks_pass_unchanged(check_t *check)
{
    begin();
    for (int k = 0; k < 60; k++) {
        line_to(k % 2, k, 0.1 * k, 0.05);
        block[blocks - 1].path_mode = (uint8_t)(k % 20 < 5    ? NCK_PATH_EXACT
                                                : k % 20 < 7 ? NCK_PATH_STOP
                                                             : NCK_PATH_CONTINUOUS);
        if (k % 20 == 9) add(NCK_BLOCK_DWELL, 0.05)->dwell_s = 0.5;
    }
    hold_promises(check, "exact and smooth");
    int same = 0;
    for (int k = 0, i = 0; k < path.segs; k++) {
        const nck_seg_t *const seg = &path.seg[k];
        if (is_smooth(seg)) continue;
        while (exact.seg[i].block != seg->block) i++;
        same += memcmp(seg->start, exact.seg[i].start, sizeof seg->start) == 0
                && memcmp(seg->end, exact.seg[i].end, sizeof seg->end) == 0
                && seg->length == exact.seg[i].length && seg->stop == exact.seg[i].stop
                && memcmp(&seg->shape, &exact.seg[i].shape, sizeof seg->shape) == 0
                && seg->feed == exact.seg[i].feed && seg->kind == exact.seg[i].kind;
    }
    CHECK_INT(check, same, 20 + 3); // the first block has no length
}

static void outputs_are_in_order_and_place(check_t *check)
{
    CHECK_INT(check, path.outputs, exact.outputs);
    for (int k = 0; k < path.outputs && k < exact.outputs; k++) {
        CHECK(check, path.output[k].value == exact.output[k].value
                         && path.output[k].line == exact.output[k].line);
        const uint32_t here = path.output[k].after_segs;
        const uint32_t there = exact.output[k].after_segs;
        const double s = here < (uint32_t)path.segs ? path.seg[here].s_begin : 1e9;
        const double wanted = there < (uint32_t)exact.segs ? exact.seg[there].s_begin : 1e9;
        CHECK_NEAR(check, s, wanted, 1e-9);
    }
}

static void outputs_keep_order_and_place(check_t *check)
{
    begin();
    for (int k = 0; k < 200; k++) {
        line_to(0.3 * k, (k % 3) * 0.2, 0.0, k % 50 < 40 ? 0.02 : 0.0);
        if (k % 2 == 0) add(NCK_BLOCK_OUTPUT, 0.0)->output.value = k;
        if (k % 37 == 0) add(NCK_BLOCK_WAIT, 0.0)->output.value = k + 0.5;
    }
    add(NCK_BLOCK_END, 0.0)->output.value = 1e9;
    hold_promises(check, "outputs");
    outputs_are_in_order_and_place(check);
}

static uint32_t stops(void)
{
    uint32_t count = 0;
    for (int k = 0; k < path.segs; k++) count += path.seg[k].stop;
    return count;
}

// Long sharp corners, where the path stops, and others. What is between two lines comes with their
// corner, and changes nothing of it.
static void outputs_leave_a_corner_as_it_is(check_t *check)
{
    uint32_t alone = 0;
    uint32_t once = 0;
    for (int many = 0; many < 4; many++) {
        begin();
        random_state = 7;
        for (int k = 0; k < 60; k++) {
            const double reach = k % 10 < 7 ? 5.0 : 0.2;
            line_to(reach * (k % 2) + random_between(0.0, 0.5 * reach), reach * (k % 3), 0.0, 0.01);
            if (k % 13 == 5) arc_about(reach, 0.0, 2.0, 0.0, 0.01);
            for (int n = 0; n < many; n++) add(NCK_BLOCK_OUTPUT, 0.0)->output.value = 10 * k + n;
        }
        add(NCK_BLOCK_END, 0.0);
        hold_promises(check, "corners with outputs");
        outputs_are_in_order_and_place(check);
        if (many == 0) alone = stops();
        CHECK(check, alone > 20 && stops() == alone);
        uint32_t at_corners = 0;
        for (int k = 0; k < path.outputs; k++) {
            const uint32_t after = path.output[k].after_segs;
            at_corners += after > 0 && path.seg[after - 1].stop;
        }
        if (many == 1) once = at_corners;
        CHECK(check, many == 0 || once > 20);
        CHECK_INT(check, at_corners, (uint32_t)many * once);
    }
}

// A change nearer to a knot than this comes at the knot (3_smooth/part.c) [mm].
#define NO_PART 1e-3

// Feeds and rapids change where the program changes them, however the knots lie.
static void words_change_where_the_program_changes_them(check_t *check)
{
    static const double tolerance[] = {0.002, 0.02, 0.2};
    for (int k = 0; k < 3; k++) {
        begin();
        line_to(1.0, 0.0, 0.0, tolerance[k]);
        line_to(1.2, 0.1, 0.0, tolerance[k]);
        block[1].feed = 60.0;
        line_to(2.0, 0.2, 0.0, tolerance[k]);
        for (int n = 1; n < 30; n++) {
            line_to(2.0 + 0.01 * n, 0.2 + 0.001 * n * n, 0.0, tolerance[k]);
            block[blocks - 1].feed = 600.0 + n;
        }
        add(NCK_BLOCK_RAPID, tolerance[k])->target_nm[0] = 3000000;
        hold_promises(check, "changing feeds");
        for (int n = 0; n < path.segs; n++) {
            const nck_seg_t *const seg = &path.seg[n];
            const nck_seg_t *const raw = &exact.seg[seg->block];
            // The spline may be longer than its path.
            const double tool = seg->feed * seg->feed_scale;
            CHECK(check, seg->rapid == raw->rapid && seg->feed <= raw->feed);
            CHECK_NEAR(check, tool, raw->feed * raw->feed_scale, 1e-12 * tool);
            CHECK_INT(check, seg->line, seg->block + 1);
            CHECK(check, raw->s_begin <= seg->s_begin + NO_PART);
            CHECK(check, seg->s_begin + seg->length <= raw->s_begin + raw->length + NO_PART);
        }
    }
}

// A block that makes much of an interval of knots ends where a seg does: there single block rests.
// Where a block ends a seg of its own does, so that single block rests there.
static void check_ends(check_t *check)
{
    int at = 0;
    for (int k = 0; k < exact.segs; k++) {
        const double end = exact.seg[k].s_begin + exact.seg[k].length;
        while (at + 1 < path.segs && path.seg[at].s_begin + path.seg[at].length < end - 1e-9) {
            at++;
        }
        CHECK_NEAR(check, path.seg[at].s_begin + path.seg[at].length, end, 1e-9);
        CHECK_INT(check, path.seg[at].block, exact.seg[k].block);
    }
}

static void long_blocks_end_with_a_seg(check_t *check)
{
    begin();
    random_state = 3;
    for (int k = 1; k < 60; k++) {
        line_to(3.0 * k, random_between(0.0, 3.0), random_between(0.0, 2.0), 0.05);
    }
    hold_promises(check, "long blocks");
    check_ends(check);
}

// 16 periods are 1.573 mm at the first feed, and 1.6 mm at the second one.
static void long_lines_on_one_line_end_with_a_seg(check_t *check)
{
    begin();
    double x = 0.0;
    line_to(x, 0.0, 0.0, 0.05);
    for (int k = 0; k < 60; k++) {
        x += k % 20 == 19 ? 100.0 : 1.59;
        line_to(x, 0.0, 0.0, 0.05);
        block[blocks - 1].merge_mm = 0.05;
        block[blocks - 1].feed = 5900.0;
    }
    hold_promises(check, "long lines on one line");
    check_ends(check);
    for (int k = 1; k < blocks; k++) block[k].feed = 6000.0;
    hold_promises(check, "lines that last less");
    CHECK(check, smooth.raw.head < 40); // of 60 blocks: short ones are merged
}

static void push_waits_until_pull_asks(check_t *check)
{
    begin();
    line_to(1.0, 0.0, 0.0, 0.0);
    nck_smooth_init(&smooth, terms_of(&machine));
    nck_smooth_item_t item;
    CHECK_INT(check, nck_smooth_push(&smooth, &block[0], 0), NCK_FULL);
    CHECK_INT(check, nck_smooth_pull(&smooth, &item), NCK_EMPTY);
    CHECK_INT(check, nck_smooth_push(&smooth, &block[0], 0), NCK_OK);
    CHECK_INT(check, nck_smooth_push(&smooth, &block[0], 0), NCK_FULL);
    CHECK_INT(check, nck_smooth_pull(&smooth, &item), NCK_OK);
    CHECK_INT(check, nck_smooth_push(&smooth, &block[0], 0), NCK_FULL);
    nck_smooth_end(&smooth);
    CHECK_INT(check, nck_smooth_pull(&smooth, &item), NCK_DONE);
}

// Facing under a surface speed: the line is divided where the feed follows the radius, or what the
// spindle can.
static void a_surface_speed_divides_a_line_whose_feed_or_spindle_follows(check_t *check)
{
    for (int which = 0; which < 4; which++) {
        begin();
        machine.spindle.a_max_rpm_s = which & 1 ? 0.5 : 0.0;
        line_to(40.0, 0.0, 0.0, 0.0);
        line_to(10.0, 0.0, 0.0, 0.0);
        block[1].surface = 100000.0;   // [mm/min]
        block[1].spindle_rpm = 3000.0; // at most
        block[1].feed_mode = which & 2 ? NCK_FEED_PER_REV : NCK_FEED_PER_MINUTE;
        block[1].feed = which & 2 ? 0.2 : 600.0;
        CHECK(check, run(&exact, 1));
        CHECK(check, which == 0 ? exact.segs == 2 : exact.segs > 4);
    }
}

int main(void)
{
    check_t check = {0};
    CHECK_RUN(&check, straight_blocks_become_straight_segs);
    CHECK_RUN(&check, nearly_collinear_lines_are_merged_within_q);
    CHECK_RUN(&check, exact_blocks_pass_unchanged);
    CHECK_RUN(&check, outputs_keep_order_and_place);
    CHECK_RUN(&check, outputs_leave_a_corner_as_it_is);
    CHECK_RUN(&check, words_change_where_the_program_changes_them);
    CHECK_RUN(&check, long_blocks_end_with_a_seg);
    CHECK_RUN(&check, long_lines_on_one_line_end_with_a_seg);
    CHECK_RUN(&check, a_surface_speed_divides_a_line_whose_feed_or_spindle_follows);
    CHECK_RUN(&check, push_waits_until_pull_asks);
    return check_end(&check);
}
