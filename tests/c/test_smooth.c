// SPDX-License-Identifier: MIT
// Room 3: within a tolerance the path is smooth, and never outside of it. The programmed path that
// it is held against comes from the same blocks in exact path mode.
#include <math.h>   // sin cos fabs hypot
#include <string.h> // memcmp memset

#include "check.h"
#include "nck/base/path_math.h"       // nck_path_…
#include "nck/prep/3_smooth/smooth.h" // nck_smooth_…

enum { BLOCK_MAX = 3000, SEG_MAX = 12000, OUTPUT_MAX = 400 };

#define SAMPLES 24.0 // of a seg

static nck_machine_t machine;
static nck_smooth_t smooth;
static nck_block_t block[BLOCK_MAX];
static int blocks;

// What came out.
typedef struct path {
    nck_seg_t seg[SEG_MAX];
    nck_output_t output[OUTPUT_MAX];
    int segs, outputs;
} path_t;

static path_t exact;
static path_t path;

static uint32_t random_state;

static double random_between(double low, double high)
{
    random_state = random_state * 1664525u + 1013904223u;
    return low + (high - low) * (random_state >> 8) / 16777216.0;
}

static void begin(void)
{
    nck_machine_default(&machine);
    for (int x = 0; x < NCK_AXIS_MAX; x++) {
        machine.axis[x] = machine.axis[0];
        machine.axis[x].rotary = x >= NCK_AXIS_A && x <= NCK_AXIS_C;
    }
    blocks = 0;
    random_state = 1;
}

// A block at the last one's end.
static nck_block_t *add(int kind, double tolerance)
{
    nck_block_t *const next = &block[blocks];
    memset(next, 0, sizeof *next);
    if (blocks > 0) memcpy(next->target_nm, block[blocks - 1].target_nm, sizeof next->target_nm);
    next->kind = (uint8_t)kind;
    next->line = (uint32_t)blocks + 1;
    next->path_mode = NCK_PATH_CONTINUOUS;
    next->tolerance_mm = tolerance;
    next->feed = 6000.0;
    next->plane = 17;
    blocks++;
    return next;
}

static void line_to(double x, double y, double z, double tolerance)
{
    nck_block_t *const next = add(NCK_BLOCK_LINE, tolerance);
    next->target_nm[0] = llround(x * 1e6);
    next->target_nm[1] = llround(y * 1e6);
    next->target_nm[2] = llround(z * 1e6);
}

// An arc about (u, v) by sweep, rising by z. Its end is rounded to nanometres; then the centre moves
// onto the chord's bisector and the sweep stays, as from room 1. No whole turns.
static void arc_about(double u, double v, double sweep, double z, double tolerance)
{
    nck_block_t *const next = add(NCK_BLOCK_ARC, tolerance);
    const double turn = fabs(sin(0.5 * sweep)) < 0.05 ? 0.9 * sweep : sweep;
    const double x = 1e-6 * (double)next->target_nm[0];
    const double y = 1e-6 * (double)next->target_nm[1];
    next->target_nm[0] = llround((u + (x - u) * cos(turn) - (y - v) * sin(turn)) * 1e6);
    next->target_nm[1] = llround((v + (x - u) * sin(turn) + (y - v) * cos(turn)) * 1e6);
    next->target_nm[2] += llround(z * 1e6);
    const double half_u = 0.5 * (1e-6 * (double)next->target_nm[0] - x);
    const double half_v = 0.5 * (1e-6 * (double)next->target_nm[1] - y);
    const double height = cos(0.5 * turn) / sin(0.5 * turn);
    next->centre_mm[0] = x + half_u - half_v * height;
    next->centre_mm[1] = y + half_v + half_u * height;
    next->sweep_rad = turn;
}

// Take what the room gives until it asks for a block; 0 if it breaks a promise.
static int drain(path_t *out)
{
    nck_smooth_item_t item;
    nck_status_t status = nck_smooth_pull(&smooth, &item);
    while (status == NCK_OK) {
        if (!nck_smooth_invariants(&smooth)) return 0;
        if (item.is_output) {
            if (out->outputs == OUTPUT_MAX) return 0;
            out->output[out->outputs++] = item.output;
        } else {
            if (out->segs == SEG_MAX) return 0;
            out->seg[out->segs++] = item.seg;
        }
        status = nck_smooth_pull(&smooth, &item);
    }
    return status == NCK_EMPTY || status == NCK_DONE;
}

// All blocks through the room; exactly if is_exact.
static int run(path_t *out, int is_exact)
{
    nck_smooth_init(&smooth, &machine);
    out->segs = 0;
    out->outputs = 0;
    int good = drain(out);
    for (int k = 0; k < blocks; k++) {
        nck_block_t next = block[k];
        if (is_exact && next.path_mode != NCK_PATH_STOP) next.path_mode = NCK_PATH_EXACT;
        good = good && nck_smooth_push(&smooth, &next, (uint32_t)k) == NCK_OK && drain(out);
    }
    nck_smooth_end(&smooth);
    return good && drain(out) && smooth.run.kinks == 0;
}

static int is_smooth(const nck_seg_t *seg)
{
    const nck_block_t *const from = &block[seg->block];
    return from->path_mode == NCK_PATH_CONTINUOUS && from->tolerance_mm > 0.0 && seg->length > 0.0;
}

static double distance(const double *p, const double *q)
{
    double sum = 0.0;
    for (int x = 0; x < NCK_AXIS_MAX; x++) sum += (p[x] - q[x]) * (p[x] - q[x]);
    return sqrt(sum);
}

// How far a point may be from the programmed one at s, as a share of the tolerance there. Walks on
// from *at.
static double share_used(const double *p, double s, int *at)
{
    while (*at + 1 < exact.segs && exact.seg[*at].s_begin + exact.seg[*at].length < s) (*at)++;
    const nck_seg_t *const seg = &exact.seg[*at];
    double q[NCK_AXIS_MAX];
    nck_path_point(seg, s - seg->s_begin, q);
    const double tolerance = block[seg->block].tolerance_mm;
    return distance(p, q) / (tolerance > 0.0 ? tolerance : 1e-9);
}

// Largest share of the tolerance, sampled densely.
static double worst_share(void)
{
    double worst = 0.0;
    int at = 0;
    for (int k = 0; k < path.segs; k++) {
        const nck_seg_t *const seg = &path.seg[k];
        for (double n = 0.0; n <= SAMPLES && seg->length > 0.0; n += 1.0) {
            double p[NCK_AXIS_MAX];
            const double s = seg->length * n / SAMPLES;
            nck_path_point(seg, s, p);
            worst = fmax(worst, share_used(p, seg->s_begin + s, &at));
        }
    }
    return worst;
}

// The largest jump of p′ and p″ where two smooth segs meet, as the distance that it makes over the
// shorter of them [mm].
static double worst_jump(void)
{
    double worst = 0.0;
    for (int k = 0; k + 1 < path.segs; k++) {
        const nck_seg_t *const in = &path.seg[k];
        const nck_seg_t *const out = &path.seg[k + 1];
        if (!is_smooth(in) || !is_smooth(out)) continue;
        const double h = fmin(in->length, out->length);
        double a[NCK_AXIS_MAX];
        double b[NCK_AXIS_MAX];
        nck_path_tangent(in, in->length, a);
        nck_path_tangent(out, 0.0, b);
        worst = fmax(worst, distance(a, b) * h);
        nck_path_second(in, in->length, a);
        nck_path_second(out, 0.0, b);
        worst = fmax(worst, distance(a, b) * h * h);
    }
    return worst;
}

// Ends meet to the bit, lengths agree, the last point is the programmed one.
static int is_chained(void)
{
    for (int k = 0; k + 1 < path.segs; k++) {
        const nck_seg_t *const in = &path.seg[k];
        const nck_seg_t *const out = &path.seg[k + 1];
        if (memcmp(in->end, out->start, sizeof in->end) != 0) return 0;
        if (fabs(in->s_begin + in->length - out->s_begin) > 1e-9) return 0;
    }
    const nck_seg_t *const last = &path.seg[path.segs - 1];
    const nck_seg_t *const wanted = &exact.seg[exact.segs - 1];
    return memcmp(last->end, wanted->end, sizeof last->end) == 0
           && memcmp(path.seg[0].start, exact.seg[0].start, sizeof last->start) == 0;
}

// Blocks as they are now: what must hold for every path.
static void hold_promises(check_t *check, const char *name)
{
    const int good = CHECK(check, run(&exact, 1)) && CHECK(check, run(&path, 0));
    if (!good) {
        printf("    %s: %d segs, %u kinks\n", name, path.segs, smooth.run.kinks);
        return;
    }
    const double share = worst_share();
    const double jump = worst_jump();
    if (!CHECK(check, share <= 1.0 && jump <= 1e-10) || !CHECK(check, is_chained())) {
        printf("    %s: share %.9f, jump %.3g\n", name, share, jump);
    }
}

static void corners_of_lines_and_arcs_stay_within_the_tolerance(check_t *check)
{
    static const double tolerance[] = {1e-4, 0.01, 0.3, 2.0};
    for (int k = 0; k < 4; k++) {
        const double p = tolerance[k];
        begin();
        line_to(10.0, 0.0, 0.0, p);
        line_to(10.0, 5.0, 0.0, p);
        line_to(0.0, 5.0, 0.1, p);
        line_to(5.0, 5.0, 0.1, p);               // a reversal
        arc_about(5.0, 7.0, 2.0, 0.0, p);        // tangent, then not
        line_to(20.0, 10.0, -3.0, p);
        arc_about(22.0, 10.0, -4.0, 2.0, p);
        arc_about(21.0, 12.0, 5.0, -1.0, p);
        arc_about(21.5, 12.5, 20.0, 3.0, p);     // a helix of three turns
        line_to(0.0, 0.0, 0.0, p);
        hold_promises(check, "lines and arcs");
    }
}

// Chords of a curve, rounded to digits: from 0.05 mm down.
static void add_micro_segments(double chord, double rounding, double tolerance)
{
    for (int k = 1; k < BLOCK_MAX - 1; k++) {
        const double t = chord * k / 50.0;
        const double r = 50.0 + 3.0 * sin(9.0 * t);
        line_to(rounding * floor(r * cos(t) / rounding + 0.5),
                rounding * floor(r * sin(t) / rounding + 0.5),
                rounding * floor(2.0 * sin(5.0 * t) / rounding + 0.5), tolerance);
    }
}

static void micro_segments_stay_within_the_tolerance(check_t *check)
{
    static const double chord[] = {0.002, 0.01, 0.055, 0.3};
    static const double tolerance[] = {0.001, 0.01, 0.1};
    for (int k = 0; k < 12; k++) {
        begin();
        machine.start_nm[0] = 50000000;
        add_micro_segments(chord[k / 3], k % 2 ? 1e-3 : 1e-4, tolerance[k % 3]);
        hold_promises(check, "micro-segments");
        for (int n = 0; n < blocks; n++) block[n].merge_mm = tolerance[k % 3];
        hold_promises(check, "merged micro-segments");
    }
}

// Everything at random: lengths over four decades, tolerances that change, all axes.
static void add_random_block(void)
{
    static const double tolerances[] = {0.001, 0.01, 0.05, 0.5};
    const double p = tolerances[(int)random_between(0.0, 3.999)];
    const double reach = pow(10.0, random_between(-2.0, 1.5));
    const double x = blocks ? 1e-6 * (double)block[blocks - 1].target_nm[0] : 0.0;
    const double y = blocks ? 1e-6 * (double)block[blocks - 1].target_nm[1] : 0.0;
    if (blocks > 0 && random_between(0.0, 1.0) < 0.3) {
        const double angle = random_between(0.0, 6.28);
        arc_about(x + reach * cos(angle), y + reach * sin(angle), random_between(-7.0, 7.0),
                  random_between(-1.0, 1.0), p);
        return;
    }
    line_to(x + random_between(-reach, reach), y + random_between(-reach, reach), 0.0, p);
    nck_block_t *const last = &block[blocks - 1];
    last->merge_mm = random_between(0.0, p);
    last->kind = random_between(0.0, 1.0) < 0.1 ? NCK_BLOCK_RAPID : NCK_BLOCK_LINE;
    for (int axis = 2; axis < NCK_AXIS_MAX; axis++) {
        const double counts = nck_machine_counts(&machine, axis);
        last->target_nm[axis] = llround(counts * random_between(-reach, reach));
    }
}

static void random_paths_of_all_axes_stay_within_the_tolerance(check_t *check)
{
    for (uint32_t seed = 1; seed <= 40; seed++) {
        begin();
        random_state = seed;
        for (int k = 0; k < 250; k++) add_random_block();
        hold_promises(check, "random");
    }
}

static void a_corner_uses_most_of_its_tolerance(check_t *check)
{
    begin();
    line_to(10.0, 0.0, 0.0, 0.01);
    line_to(10.0, 10.0, 0.0, 0.01);
    hold_promises(check, "a corner");
    CHECK(check, worst_share() > 0.9);
    CHECK_INT(check, path.segs, 4);
    CHECK(check, path.seg[0].kind == NCK_SEG_LINE && path.seg[3].kind == NCK_SEG_LINE);
    CHECK(check, path.seg[0].length > 9.9 && path.seg[3].length > 9.9);
}

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
                && seg->dwell_s == exact.seg[i].dwell_s && seg->feed == exact.seg[i].feed
                && seg->kind == exact.seg[i].kind;
    }
    CHECK_INT(check, same, 20 + 3); // the first block has no length
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

static void a_seg_takes_the_slowest_feed_and_the_line_of_its_middle(check_t *check)
{
    begin();
    line_to(1.0, 0.0, 0.0, 0.2);
    line_to(1.2, 0.1, 0.0, 0.2);
    block[1].feed = 60.0;
    line_to(2.0, 0.2, 0.0, 0.2);
    add(NCK_BLOCK_RAPID, 0.2)->target_nm[0] = 3000000;
    CHECK(check, run(&exact, 1) && run(&path, 0));
    int slow = 0;
    for (int k = 0; k < path.segs; k++) {
        const nck_seg_t *const seg = &path.seg[k];
        const double s_end = seg->s_begin + seg->length;
        const int overlaps = seg->s_begin < exact.seg[2].s_begin && s_end > exact.seg[1].s_begin;
        const int is_rapid = seg->s_begin >= exact.seg[3].s_begin;
        CHECK(check, seg->rapid == is_rapid && (seg->feed > 0.0) == !is_rapid);
        CHECK(check, is_rapid || (seg->feed == 1.0) == overlaps);
        slow += overlaps;
        const double middle = 0.5 * (seg->s_begin + s_end);
        const nck_seg_t *const raw = &exact.seg[seg->block];
        CHECK(check, raw->s_begin <= middle && middle <= raw->s_begin + raw->length);
        CHECK_INT(check, seg->line, seg->block + 1);
    }
    CHECK(check, slow > 0);
}

static void push_waits_until_pull_asks(check_t *check)
{
    begin();
    line_to(1.0, 0.0, 0.0, 0.0);
    nck_smooth_init(&smooth, &machine);
    nck_smooth_item_t item;
    CHECK_INT(check, nck_smooth_push(&smooth, &block[0], 0), NCK_FULL);
    CHECK_INT(check, nck_smooth_pull(&smooth, &item), NCK_EMPTY);
    CHECK_INT(check, nck_smooth_push(&smooth, &block[0], 0), NCK_OK);
    CHECK_INT(check, nck_smooth_push(&smooth, &block[0], 0), NCK_FULL);
    CHECK_INT(check, nck_smooth_pull(&smooth, &item), NCK_OK);
    nck_smooth_end(&smooth);
    CHECK_INT(check, nck_smooth_pull(&smooth, &item), NCK_DONE);
}

// |p″| and |p‴| of the smoothest path within a looser tolerance, as the time they cost.
static double time_of(void)
{
    double time = 0.0;
    for (int k = 0; k < path.segs; k++) {
        const nck_seg_t *const seg = &path.seg[k];
        double second[2][NCK_AXIS_MAX];
        double third[NCK_AXIS_MAX];
        nck_path_second(seg, 0.0, second[0]);
        nck_path_second(seg, seg->length, second[1]);
        nck_path_third(seg, 0.0, third);
        double v = 100.0;
        for (int x = 0; x < NCK_AXIS_MAX; x++) {
            const double bend = fmax(fabs(second[0][x]), fabs(second[1][x]));
            if (bend > 0.0) v = fmin(v, sqrt(1000.0 / bend));
            if (third[x] != 0.0) v = fmin(v, cbrt(10000.0 / fabs(third[x])));
        }
        time += seg->length / v;
    }
    return time;
}

static void a_looser_tolerance_is_not_slower(check_t *check)
{
    static const double tolerance[] = {0.003, 0.01, 0.03, 0.1, 0.3, 1.0};
    double least = 1e9;
    for (int k = 0; k < 6; k++) {
        begin();
        machine.start_nm[0] = 50000000;
        add_micro_segments(0.055, 1e-4, tolerance[k]);
        CHECK(check, run(&path, 0));
        const double time = time_of();
        if (!CHECK(check, time <= 1.02 * least)) {
            printf("    P%g takes %.4f s, not %.4f\n", tolerance[k], time, least);
        }
        least = fmin(least, time);
    }
}

int main(void)
{
    check_t check = {0};
    CHECK_RUN(&check, corners_of_lines_and_arcs_stay_within_the_tolerance);
    CHECK_RUN(&check, micro_segments_stay_within_the_tolerance);
    CHECK_RUN(&check, random_paths_of_all_axes_stay_within_the_tolerance);
    CHECK_RUN(&check, a_corner_uses_most_of_its_tolerance);
    CHECK_RUN(&check, straight_blocks_become_straight_segs);
    CHECK_RUN(&check, nearly_collinear_lines_are_merged_within_q);
    CHECK_RUN(&check, exact_blocks_pass_unchanged);
    CHECK_RUN(&check, outputs_keep_order_and_place);
    CHECK_RUN(&check, a_seg_takes_the_slowest_feed_and_the_line_of_its_middle);
    CHECK_RUN(&check, push_waits_until_pull_asks);
    CHECK_RUN(&check, a_looser_tolerance_is_not_slower);
    return check_end(&check);
}
