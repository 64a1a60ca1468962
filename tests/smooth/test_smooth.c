// SPDX-License-Identifier: MIT
// Room 3: what goes through it one by one: exact blocks, outputs between them, divided lines.
#include <math.h>   // cos sin fabs llround
#include <string.h> // memcmp memset

#include "check.h"
#include "nck/prep/3_smooth/smooth.h" // nck_smooth_…
#include "terms_check.h"              // terms_of

enum { BLOCK_MAX = 300, SEG_MAX = 3000, OUTPUT_MAX = 400 };

static nck_machine_t machine;
static nck_smooth_t smooth;
static nck_block_t block[BLOCK_MAX];
static int blocks;

// What came out.
static nck_seg_t seg[SEG_MAX];
static nck_output_t output[OUTPUT_MAX];
static int segs, outputs;

static void begin(uint32_t slope)
{
    nck_machine_default(&machine);
    machine.slope = slope;
    for (int x = 0; x < NCK_AXIS_MAX; x++) {
        machine.axis[x] = machine.axis[0];
        machine.axis[x].rotary = x >= NCK_AXIS_A && x <= NCK_AXIS_C;
    }
    blocks = 0;
}

// A block at the last one's end.
static nck_block_t *add(int kind)
{
    nck_block_t *const next = &block[blocks];
    memset(next, 0, sizeof *next);
    if (blocks > 0) memcpy(next->target_nm, block[blocks - 1].target_nm, sizeof next->target_nm);
    next->kind = (uint8_t)kind;
    next->line = (uint32_t)blocks + 1;
    next->path_mode = NCK_PATH_EXACT;
    next->feed = 6000.0;
    next->plane = 17;
    blocks++;
    return next;
}

static nck_block_t *line_to(double x, double y)
{
    nck_block_t *const next = add(NCK_BLOCK_LINE);
    next->target_nm[0] = llround(x * 1e6);
    next->target_nm[1] = llround(y * 1e6);
    return next;
}

// Half a circle to the left, rising.
static void half_to(double x, double y)
{
    const nck_block_t *const before = &block[blocks - 1];
    nck_block_t *const next = line_to(x, y);
    next->kind = NCK_BLOCK_ARC;
    next->centre_mm[0] = 5e-7 * (double)(before->target_nm[0] + next->target_nm[0]);
    next->centre_mm[1] = 5e-7 * (double)(before->target_nm[1] + next->target_nm[1]);
    next->sweep_rad = 3.14159265358979323846;
    next->target_nm[2] += 1000000;
}

// Take what the room gives until it asks for a block; 0 if it breaks a promise.
static int drain(void)
{
    nck_smooth_item_t item;
    nck_status_t status = nck_smooth_pull(&smooth, &item);
    for (; status == NCK_OK; status = nck_smooth_pull(&smooth, &item)) {
        if (!nck_smooth_invariants(&smooth) || segs == SEG_MAX || outputs == OUTPUT_MAX) return 0;
        if (item.is_output) output[outputs++] = item.output;
        else seg[segs++] = item.seg;
    }
    return status == NCK_EMPTY || status == NCK_DONE;
}

// All blocks through the room.
static int run(void)
{
    nck_smooth_init(&smooth, terms_of(&machine));
    segs = 0;
    outputs = 0;
    int good = drain();
    for (int k = 0; k < blocks; k++) {
        good = good && nck_smooth_push(&smooth, &block[k], (uint32_t)k) == NCK_OK && drain();
    }
    nck_smooth_end(&smooth);
    return good && drain();
}

// Ends meet to the bit, lengths agree, each seg is of its block.
static int is_chained(void)
{
    for (int k = 0; k < segs; k++) {
        if (seg[k].line != seg[k].block + 1) return 0;
        if (k == 0) continue;
        if (memcmp(seg[k - 1].end, seg[k].start, sizeof seg[k].start) != 0) return 0;
        if (fabs(seg[k - 1].s_begin + seg[k - 1].length - seg[k].s_begin) > 1e-9) return 0;
    }
    return 1;
}

static void mixed_blocks(void)
{
    for (int k = 0; k < 60; k++) {
        if (k % 7 == 3) half_to(k % 2, k);
        else line_to(k % 2, k)->target_nm[2] = 100000 * k;
        if (k % 20 >= 5 && k % 20 < 7) block[blocks - 1].path_mode = NCK_PATH_STOP;
        if (k % 20 == 9) add(NCK_BLOCK_DWELL)->dwell_s = 0.5;
        if (k % 11 == 4) line_to(k % 2, k); // no length: it vanishes
    }
}

// One block, one seg. Under a slope that does not smooth a tolerance changes nothing.
static void blocks_become_segs_one_by_one(check_t *check)
{
    static nck_seg_t exact[SEG_MAX];
    static const uint32_t slope[] = {NCK_SLOPE_LINEAR, NCK_SLOPE_JERK};
    for (int n = 0; n < 2; n++) {
        begin(slope[n]);
        mixed_blocks();
        CHECK(check, run() && is_chained());
        CHECK_INT(check, segs, 60 - 1 + 3); // the first one has no length
        const int wanted = segs;
        memcpy(exact, seg, sizeof exact);
        for (int k = 0; k < blocks; k++) {
            if (block[k].path_mode == NCK_PATH_STOP) continue;
            block[k].path_mode = NCK_PATH_CONTINUOUS;
            block[k].tolerance_mm = 0.05;
        }
        CHECK(check, run());
        CHECK_INT(check, segs, wanted);
        CHECK(check, memcmp(exact, seg, (size_t)segs * sizeof seg[0]) == 0);
    }
}

// A block with a seg that is made in its place is the same, to the bit.
static void a_block_that_passes_is_the_same(check_t *check)
{
    begin(NCK_SLOPE_JERK);
    mixed_blocks();
    CHECK(check, run());
    nck_smooth_init(&smooth, terms_of(&machine));
    int at = 0;
    nck_smooth_item_t item;
    CHECK_INT(check, nck_smooth_pull(&smooth, &item), NCK_EMPTY);
    for (int k = 0; k < blocks; k++) {
        nck_status_t status = nck_smooth_pass(&smooth, &block[k], (uint32_t)k, &item.seg);
        if (status == NCK_FULL) {
            CHECK_INT(check, nck_smooth_push(&smooth, &block[k], (uint32_t)k), NCK_OK);
            status = nck_smooth_pull(&smooth, &item);
            CHECK_INT(check, status, NCK_OK);
            nck_smooth_item_t none;
            CHECK_INT(check, nck_smooth_pull(&smooth, &none), NCK_EMPTY);
        }
        if (status == NCK_EMPTY) continue;
        CHECK(check, memcmp(&item.seg, &seg[at], sizeof item.seg) == 0);
        at++;
    }
    CHECK_INT(check, at, segs);
}

static void outputs_keep_order_and_place(check_t *check)
{
    begin(NCK_SLOPE_LINEAR);
    for (int k = 1; k <= 100; k++) {
        line_to(0.3 * k, (k % 3) * 0.2);
        if (k % 2 == 0) add(NCK_BLOCK_OUTPUT)->output.value = k;
        if (k % 37 == 0) add(NCK_BLOCK_WAIT)->output.value = k;
    }
    add(NCK_BLOCK_END)->output.value = 101;
    CHECK(check, run());
    CHECK_INT(check, outputs, 50 + 2 + 1);
    for (int k = 0; k < outputs; k++) {
        const int waits = (int)(output[k].value - 1.0) / 37; // a seg each, behind its output
        CHECK_INT(check, output[k].after_segs, fmin(output[k].value, 100.0) + waits);
        CHECK_INT(check, block[output[k].line - 1].output.value, output[k].value);
    }
}

static void push_waits_until_pull_asks(check_t *check)
{
    begin(NCK_SLOPE_LINEAR);
    line_to(1.0, 0.0);
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
        begin(NCK_SLOPE_JERK);
        machine.spindle.a_max_rpm_s = which & 1 ? 0.5 : 0.0;
        line_to(40.0, 0.0);
        nck_block_t *const faces = line_to(10.0, 0.0);
        faces->surface = 100000.0;   // [mm/min]
        faces->spindle_rpm = 3000.0; // at most
        faces->feed_mode = which & 2 ? NCK_FEED_PER_REV : NCK_FEED_PER_MINUTE;
        faces->feed = which & 2 ? 0.2 : 600.0;
        CHECK(check, run() && is_chained());
        CHECK(check, which == 0 ? segs == 2 : segs > 4);
    }
}

int main(void)
{
    check_t check = {0};
    CHECK_RUN(&check, blocks_become_segs_one_by_one);
    CHECK_RUN(&check, a_block_that_passes_is_the_same);
    CHECK_RUN(&check, outputs_keep_order_and_place);
    CHECK_RUN(&check, a_surface_speed_divides_a_line_whose_feed_or_spindle_follows);
    CHECK_RUN(&check, push_waits_until_pull_asks);
    return check_end(&check);
}
