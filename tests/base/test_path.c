// SPDX-License-Identifier: MIT
// Rooms 2 and 3 and base/path_math.h: blocks become exact pieces of path where no tolerance is in
// force.
#include <math.h>   // hypot fabs
#include <string.h> // memset

#include "check.h"
#include "nck/base/path.h"                // nck_path_point nck_path_tangent
#include "nck/prep/2_toolcomp/toolcomp.h" // nck_toolcomp_place
#include "nck/prep/3_smooth/smooth.h"     // nck_smooth_push nck_smooth_pull
#include "terms_check.h" // terms_of

static nck_machine_t machine;
static nck_smooth_t smooth;

static nck_block_t block_to(int kind, int64_t x_nm, int64_t y_nm, int64_t z_nm)
{
    nck_block_t block;
    memset(&block, 0, sizeof block);
    block.kind = (uint8_t)kind;
    block.feed = 600.0;
    block.plane = 17;
    block.target_nm[NCK_AXIS_X] = x_nm;
    block.target_nm[NCK_AXIS_Y] = y_nm;
    block.target_nm[NCK_AXIS_Z] = z_nm;
    return block;
}

static void begin(void)
{
    nck_machine_default(&machine);
    machine.slope = NCK_SLOPE_LINEAR;
    nck_smooth_init(&smooth, terms_of(&machine));
}

// One block in, its seg out: what the exact path does.
static nck_status_t push_block(const nck_block_t *block, nck_seg_t *seg_out)
{
    nck_smooth_item_t item;
    nck_status_t status = nck_smooth_pull(&smooth, &item);
    if (status != NCK_EMPTY) return NCK_E_INTERNAL;
    status = nck_smooth_push(&smooth, block, 0);
    if (status != NCK_OK) return status;
    status = nck_smooth_pull(&smooth, &item);
    *seg_out = item.seg;
    return status;
}

static void line_begins_and_ends_to_the_bit(check_t *check)
{
    begin();
    const nck_block_t block = block_to(NCK_BLOCK_LINE, 1234567, -7654321, 3);
    nck_seg_t seg;
    double p[NCK_AXIS_MAX];
    CHECK_INT(check, push_block(&block, &seg), NCK_OK);
    nck_path_point(&seg, seg.length, p);
    CHECK(check, p[0] == 1.234567 && p[1] == -7.654321 && p[2] == 3e-6);
    nck_path_point(&seg, 0.0, p);
    CHECK(check, p[0] == 0.0 && p[1] == 0.0 && p[2] == 0.0);
    CHECK(check, seg.feed == 10.0);
}

static void block_without_length_vanishes(check_t *check)
{
    begin();
    const nck_block_t block = block_to(NCK_BLOCK_LINE, 0, 0, 0);
    nck_seg_t seg;
    CHECK_INT(check, push_block(&block, &seg), NCK_EMPTY);
    CHECK_INT(check, smooth.seq, 0);
}

static void helix_stays_on_its_cylinder_and_rises_evenly(check_t *check)
{
    begin();
    nck_block_t block = block_to(NCK_BLOCK_ARC, 0, 0, 5000000);
    block.centre_mm[0] = 3.0;
    block.centre_mm[1] = 4.0;
    block.sweep_rad = -6.0 * NCK_PI;
    nck_seg_t seg;
    CHECK_INT(check, push_block(&block, &seg), NCK_OK);
    CHECK_NEAR(check, seg.length, hypot(30.0 * NCK_PI, 5.0), 1e-12);
    for (int k = 0; k <= 1000; k++) {
        double p[NCK_AXIS_MAX];
        double t[NCK_AXIS_MAX];
        const double s = seg.length * k / 1000.0;
        nck_path_point(&seg, s, p);
        nck_path_tangent(&seg, s, t);
        CHECK_NEAR(check, hypot(p[0] - 3.0, p[1] - 4.0), 5.0, 2e-14);
        CHECK_NEAR(check, p[2], 5.0 * k / 1000.0, 1e-14);
        CHECK_NEAR(check, sqrt(t[0] * t[0] + t[1] * t[1] + t[2] * t[2]), 1.0, 1e-14);
    }
}

static void tangent_is_the_derivative_of_the_point(check_t *check)
{
    begin();
    nck_block_t block = block_to(NCK_BLOCK_ARC, 2000000, 0, 1000000);
    block.centre_mm[0] = 1.0;
    block.sweep_rad = NCK_PI;
    nck_seg_t seg;
    push_block(&block, &seg);
    for (int k = 1; k < 50; k++) {
        double a[NCK_AXIS_MAX];
        double b[NCK_AXIS_MAX];
        double t[NCK_AXIS_MAX];
        const double s = seg.length * k / 50.0;
        nck_path_point(&seg, s - 1e-5, a);
        nck_path_point(&seg, s + 1e-5, b);
        nck_path_tangent(&seg, s, t);
        for (int x = 0; x < 3; x++) CHECK_NEAR(check, (b[x] - a[x]) / 2e-5, t[x], 1e-9);
    }
}

// Each derivative is the slope of the one before.
static void derivatives_of_a_spline_and_an_arc_follow_one_another(check_t *check)
{
    nck_seg_t segs[2];
    memset(segs, 0, sizeof segs);
    segs[0].kind = NCK_SEG_SPLINE;
    segs[1].kind = NCK_SEG_ARC;
    segs[1].shape.arc.axis_v = NCK_AXIS_Y;
    segs[1].shape.arc.sweep = -2.5;
    for (int x = 0; x < NCK_AXIS_MAX; x++) {
        segs[0].start[x] = 0.1 * x;
        segs[0].shape.inner[0][x] = 1.0 - 0.2 * x * x;
        segs[0].shape.inner[1][x] = 1.5 + x;
        segs[0].end[x] = 2.0 - x;
    }
    segs[0].length = 3.5;
    segs[1].start[NCK_AXIS_X] = 2.0;
    segs[1].end[NCK_AXIS_Z] = 1.0;
    segs[1].length = sqrt(26.0);
    for (int k = 1; k < 20; k++) {
        const nck_seg_t *const seg = &segs[k % 2];
        const double s = seg->length * k / 20.0;
        const double h = 1e-4;
        double d[3][3][NCK_AXIS_MAX];
        for (int i = 0; i < 3; i++) {
            nck_path_tangent(seg, s + (i - 1) * h, d[0][i]);
            nck_path_second(seg, s + (i - 1) * h, d[1][i]);
            nck_path_third(seg, s + (i - 1) * h, d[2][i]);
        }
        for (int x = 0; x < 3; x++) {
            CHECK_NEAR(check, (d[0][2][x] - d[0][0][x]) / (2.0 * h), d[1][1][x], 1e-8);
            CHECK_NEAR(check, (d[1][2][x] - d[1][0][x]) / (2.0 * h), d[2][1][x], 1e-8);
        }
    }
}

static void spline_ends_to_the_bit_and_its_tangent_is_its_derivative(check_t *check)
{
    nck_seg_t seg;
    memset(&seg, 0, sizeof seg);
    seg.kind = NCK_SEG_SPLINE;
    seg.length = 0.7;
    for (int x = 0; x < NCK_AXIS_MAX; x++) {
        seg.start[x] = 0.1 + x;
        seg.shape.inner[0][x] = 0.3 + x;
        seg.shape.inner[1][x] = 0.7;
        seg.end[x] = 1.1 / 3.0;
    }
    double p[3][NCK_AXIS_MAX];
    double t[NCK_AXIS_MAX];
    nck_path_point(&seg, 0.0, p[0]);
    nck_path_point(&seg, 0.7, p[1]);
    CHECK(check, memcmp(p[0], seg.start, sizeof p[0]) == 0);
    CHECK(check, memcmp(p[1], seg.end, sizeof p[1]) == 0);
    for (int k = 1; k < 10; k++) {
        nck_path_point(&seg, 0.07 * k - 1e-5, p[0]);
        nck_path_point(&seg, 0.07 * k + 1e-5, p[1]);
        nck_path_tangent(&seg, 0.07 * k, t);
        for (int x = 0; x < 3; x++) CHECK_NEAR(check, (p[1][x] - p[0][x]) / 2e-5, t[x], 1e-8);
    }
}

static void feed_counts_linear_axes_when_rotary_ones_join_in(check_t *check)
{
    nck_machine_default(&machine);
    machine.slope = NCK_SLOPE_LINEAR;
    machine.axis[NCK_AXIS_A % NCK_AXIS_MAX].present = 1;
    machine.axis[NCK_AXIS_A % NCK_AXIS_MAX].rotary = NCK_AXIS_MAX > NCK_AXIS_A;
    nck_smooth_init(&smooth, terms_of(&machine));
    nck_block_t block = block_to(NCK_BLOCK_LINE, 3000000, 0, 0);
    block.target_nm[NCK_AXIS_A % NCK_AXIS_MAX] = NCK_AXIS_MAX > NCK_AXIS_A ? 4000000000 : 3000000;
    nck_seg_t seg;
    push_block(&block, &seg);
    CHECK_NEAR(check, seg.feed * seg.feed_scale, 10.0, 1e-14);
    CHECK_NEAR(check, seg.length, NCK_AXIS_MAX > NCK_AXIS_A ? 5.0 : 3.0, 1e-14);
}

static void inverse_time_takes_its_time(check_t *check)
{
    begin();
    nck_block_t block = block_to(NCK_BLOCK_LINE, 3000000, 4000000, 0);
    block.feed_mode = NCK_FEED_INVERSE;
    block.feed = 30.0;
    nck_seg_t seg;
    push_block(&block, &seg);
    CHECK_NEAR(check, seg.length / seg.feed, 2.0, 1e-14);
}

static void feed_per_revolution_of_a_spindle_at_rest_is_refused(check_t *check)
{
    begin();
    nck_block_t block = block_to(NCK_BLOCK_LINE, 3000000, 4000000, 0);
    block.feed_mode = NCK_FEED_PER_REV;
    nck_seg_t seg;
    CHECK_INT(check, push_block(&block, &seg), NCK_E_FEED_MISSING);
}

static void tool_offset_moves_target_and_centre(check_t *check)
{
    begin();
    static nck_toolcomp_t toolcomp;
    nck_toolcomp_init(&toolcomp, &machine);
    nck_block_t block = block_to(NCK_BLOCK_ARC, 10, 20, 30);
    block.plane = 18;
    block.tool_nm[NCK_AXIS_X] = 1000000;
    block.tool_nm[NCK_AXIS_Z] = 2000000;
    nck_toolcomp_place(&toolcomp, &block);
    CHECK_INT(check, block.target_nm[NCK_AXIS_X], 1000010);
    CHECK_INT(check, block.target_nm[NCK_AXIS_Y], 20);
    CHECK_INT(check, block.target_nm[NCK_AXIS_Z], 2000030);
    CHECK(check, block.centre_mm[0] == 2.0 && block.centre_mm[1] == 1.0);
}

int main(void)
{
    check_t check = {0};
    CHECK_RUN(&check, line_begins_and_ends_to_the_bit);
    CHECK_RUN(&check, block_without_length_vanishes);
    CHECK_RUN(&check, helix_stays_on_its_cylinder_and_rises_evenly);
    CHECK_RUN(&check, tangent_is_the_derivative_of_the_point);
    CHECK_RUN(&check, derivatives_of_a_spline_and_an_arc_follow_one_another);
    CHECK_RUN(&check, spline_ends_to_the_bit_and_its_tangent_is_its_derivative);
    CHECK_RUN(&check, feed_counts_linear_axes_when_rotary_ones_join_in);
    CHECK_RUN(&check, inverse_time_takes_its_time);
    CHECK_RUN(&check, feed_per_revolution_of_a_spindle_at_rest_is_refused);
    CHECK_RUN(&check, tool_offset_moves_target_and_centre);
    return check_end(&check);
}
