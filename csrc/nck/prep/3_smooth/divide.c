// SPDX-License-Identifier: MIT
// Inside room 3: pieces of a seg over which the spindle's speed changes little.
//
//     r ─▶  0 ──── flat ──────────────────────── surface speed        n = min(V / 2πr, most)
//           │ one piece │ each 1 % of its r long                      F a revolution, times n
#include "nck/prep/3_smooth/divide.h"

#include <string.h> // memcpy

#include "nck/base/path.h"                 // nck_path_part
#include "nck/base/real.h"                 // nck_min nck_max nck_fabs
#include "nck/base/spin_math.h"            // nck_spin_…

#define SHARE 0.01 // of r from one end of a piece to the other: its feed is off by half of it

// How much of a step along the seg the radius can change by: of a line its direction cosine.
static double slant(const nck_seg_t *seg) {
    const int x = NCK_AXIS_X;
    if (seg->kind != NCK_SEG_LINE) return 1.0;
    return nck_fabs(seg->end[x] - seg->start[x]) / seg->length;
}

// Distance from the spindle's axis at s.
static double radius(const nck_seg_t *seg, double s) {
    double point[NCK_AXIS_MAX];
    nck_path_part(seg, s, NCK_AXIS_X + 1, point);
    return nck_fabs(point[NCK_AXIS_X] - seg->spin.x);
}

int nck_divide_begin(nck_smooth_t *self, const nck_seg_t *seg) {
    if (!NCK_HAS_LATHE) return 0;
    const double a = self->terms->machine->spindle.a_max_rpm_s;
    const int moves = seg->kind < NCK_SEG_DWELL && seg->spin.most > 0.0;
    if (!moves || !(seg->spin.per_rev > 0.0 || a > 0.0)) return 0;
    self->divide.seg = *seg;
    self->divide.from = 0.0;
    return 1;
}

// Where the next piece ends. Two that are left of about a piece share it evenly.
static double piece_end(const nck_seg_t *seg, double from) {
    const double c = slant(seg);
    const double r = radius(seg, from);
    const double r_flat = nck_spin_flat(&seg->spin);
    const double step = r > r_flat ? SHARE * r : nck_max(r_flat - r, SHARE * r_flat);
    const double rest = seg->length - from;
    if (rest * c <= step) return seg->length;
    return rest * c < 2.0 * step ? from + 0.5 * rest : from + step / c;
}

// The part of a line or an arc.
static void take_part(nck_seg_t *seg, double from, double to, int axes) {
    const nck_seg_t whole = *seg;
    if (from > 0.0) nck_path_part(&whole, from, axes, seg->start);
    if (to < whole.length) nck_path_part(&whole, to, axes, seg->end);
    if (seg->kind == NCK_SEG_ARC) seg->shape.arc.sweep *= (to - from) / whole.length;
    seg->length = to - from;
}

// How fast the piece may be taken, where the speed is below its most, so that the spindle follows.
static double follows_at(const nck_seg_t *seg, double from, double to, double a) {
    const double c = slant(seg);
    const double r0 = radius(seg, from);
    const double r1 = radius(seg, to);
    const double r_flat = nck_spin_flat(&seg->spin);
    if (!(a > 0.0) || c == 0.0 || nck_max(r0, r1) <= r_flat) return 0.0;
    const double r = nck_max(r_flat, nck_min(r0, r1));
    return nck_spin_follow(&seg->spin, r, a) / c;
}

void nck_divide_next(nck_smooth_t *self, nck_seg_t *seg_out) {
    if (!NCK_HAS_LATHE) return;
    const nck_seg_t *const seg = &self->divide.seg;
    const double from = self->divide.from;
    const double to = piece_end(seg, from);
    double middle[NCK_AXIS_MAX];
    *seg_out = *seg;
    take_part(seg_out, from, to, self->terms->axes);
    if (to < seg->length) seg_out->stop = 0;
    nck_path_part(seg, 0.5 * (from + to), NCK_AXIS_X + 1, middle);
    seg_out->feed = nck_spin_feed(&seg->spin, seg->feed, middle[NCK_AXIS_X]);
    seg_out->v_most = follows_at(seg, from, to, self->terms->machine->spindle.a_max_rpm_s);
    self->divide.from = to;
}
