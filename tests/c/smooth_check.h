// SPDX-License-Identifier: MIT
// Paths for the tests of room 3, and what must hold for every one of them: within the tolerance,
// C², ends to the bit. The programmed path that it is held against comes from the same blocks in
// exact path mode.
#ifndef SMOOTH_CHECK_H
#define SMOOTH_CHECK_H

#include <math.h>   // sin cos fabs hypot isfinite
#include <string.h> // memcmp memset

#include "check.h"
#include "nck/base/path.h"            // nck_path_…
#include "nck/prep/3_smooth/smooth.h" // nck_smooth_…
#include "terms_check.h"                 // terms_of

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

static inline double random_between(double low, double high)
{
    random_state = random_state * 1664525u + 1013904223u;
    return low + (high - low) * (random_state >> 8) / 16777216.0;
}

static inline void begin(void)
{
    nck_machine_default(&machine);
    machine.slope = NCK_SLOPE_JERK;
    for (int x = 0; x < NCK_AXIS_MAX; x++) {
        machine.axis[x] = machine.axis[0];
        machine.axis[x].rotary = x >= NCK_AXIS_A && x <= NCK_AXIS_C;
    }
    blocks = 0;
    random_state = 1;
}

// A block at the last one's end.
static inline nck_block_t *add(int kind, double tolerance)
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

static inline void line_to(double x, double y, double z, double tolerance)
{
    nck_block_t *const next = add(NCK_BLOCK_LINE, tolerance);
    next->target_nm[0] = llround(x * 1e6);
    next->target_nm[1] = llround(y * 1e6);
    next->target_nm[2] = llround(z * 1e6);
}

// An arc about (u, v) by sweep, rising by z. Its end is rounded to nanometres; then the centre
// moves onto the chord's bisector and the sweep stays, as from room 1. No whole turns.
static inline void arc_about(double u, double v, double sweep, double z, double tolerance)
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

// A pull tries one knot, or goes on with one.
static inline int is_bounded(void)
{
    return smooth.run.tries <= 1;
}

// A seg that moves has a length that setpoints can tell, and no number that is none. What an arc or
// a dwell has of its own lies where a spline has its inner points.
static inline int is_sound(const nck_seg_t *seg)
{
    double sum = seg->length + seg->feed;
    for (int x = 0; x < NCK_AXIS_MAX; x++) {
        sum += seg->start[x] + seg->end[x] + seg->shape.inner[0][x] + seg->shape.inner[1][x];
    }
    return isfinite(sum) && (seg->kind >= NCK_SEG_DWELL || seg->length > 0.5e-9);
}

// Take what the room gives until it asks for a block; 0 if it breaks a promise.
static inline int drain(path_t *out)
{
    nck_smooth_item_t item;
    nck_status_t status = nck_smooth_pull(&smooth, &item);
    while (status == NCK_OK || status == NCK_FULL) {
        if (!nck_smooth_invariants(&smooth) || !is_bounded()) return 0;
        if (status == NCK_FULL) {
            status = nck_smooth_pull(&smooth, &item);
            continue;
        }
        if (!item.is_output && !is_sound(&item.seg)) return 0;
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
static inline int run(path_t *out, int is_exact)
{
    nck_smooth_init(&smooth, terms_of(&machine));
    out->segs = 0;
    out->outputs = 0;
    int good = drain(out);
    for (int k = 0; k < blocks; k++) {
        nck_block_t next = block[k];
        if (is_exact && next.path_mode != NCK_PATH_STOP) next.path_mode = NCK_PATH_EXACT;
        good = good && nck_smooth_push(&smooth, &next, (uint32_t)k) == NCK_OK && drain(out);
    }
    nck_smooth_end(&smooth);
    return good && drain(out);
}

static inline int is_smooth(const nck_seg_t *seg)
{
    const nck_block_t *const from = &block[seg->block];
    return from->path_mode == NCK_PATH_CONTINUOUS && from->tolerance_mm > 0.0 && seg->length > 0.0;
}

static inline double distance(const double *p, const double *q)
{
    double sum = 0.0;
    for (int x = 0; x < NCK_AXIS_MAX; x++) sum += (p[x] - q[x]) * (p[x] - q[x]);
    return sqrt(sum);
}

// The programmed point at s. Walks on from *at, to the seg that it is on.
static inline void programmed(double s, int *at, double *point_out)
{
    while (*at + 1 < exact.segs && exact.seg[*at].s_begin + exact.seg[*at].length < s) (*at)++;
    nck_path_point(&exact.seg[*at], s - exact.seg[*at].s_begin, point_out);
}

// How far a point may be from the programmed one at s, as a share of the tolerance there. Walks on
// from *at.
static inline double share_used(const double *p, double s, int *at)
{
    double q[NCK_AXIS_MAX];
    programmed(s, at, q);
    const double tolerance = block[exact.seg[*at].block].tolerance_mm;
    return distance(p, q) / (tolerance > 0.0 ? tolerance : 1e-9);
}

// Distance of a point from the exact line of a block.
static inline double distance_from_line(const double *p, const nck_seg_t *line)
{
    double along = 0.0;
    double q[NCK_AXIS_MAX];
    for (int x = 0; x < NCK_AXIS_MAX; x++) {
        along += (p[x] - line->start[x]) * (line->end[x] - line->start[x]) / line->length;
    }
    nck_path_point(line, fmin(line->length, fmax(0.0, along)), q);
    return distance(p, q);
}

// Largest share of the tolerance, sampled densely.
static inline double worst_share(void)
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
static inline double worst_jump(void)
{
    double worst = 0.0;
    for (int k = 0; k + 1 < path.segs; k++) {
        const nck_seg_t *const in = &path.seg[k];
        const nck_seg_t *const out = &path.seg[k + 1];
        if (!is_smooth(in) || !is_smooth(out) || in->stop) continue;
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
static inline int is_chained(void)
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
static inline void hold_promises(check_t *check, const char *name)
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

#endif
