// SPDX-License-Identifier: MIT
// Inside room 3: the programmed path of a run.
#include "nck/prep/3_smooth/raw.h"

#include <string.h> // memset

#include "nck/base/path.h"                 // nck_path_point nck_path_tangent nck_path_second
#include "nck/base/real.h"                 // nck_sqrt nck_min nck_max
#include "nck/prep/3_smooth/spline_math.h" // nck_spline_…

enum { PARTS = 8 };               // a knot interval is looked at in so many parts at least
#define LEAST 1e-9                // [path mm] a thousandth of what a setpoint can tell
#define LEAST_SHARE 1e-15         // of the place, whose own rounding this is

double nck_raw_least(double s) { return LEAST + LEAST_SHARE * s; }

int nck_raw_is_full(const nck_smooth_t *self) {
    return self->raw.head - self->raw.tail == NCK_SMOOTH_SPAN;
}

static double raw_end(const nck_raw_t *raw) { return raw->s + raw->seg.length; }

uint32_t nck_raw_next(nck_smooth_t *self, uint32_t count) {
    count++;
    while (count != self->run.end && !nck_raw_at(self, count)->has_seg) count++;
    return count;
}

uint32_t nck_raw_last(nck_smooth_t *self) {
    uint32_t count = self->run.end - 1;
    while (!nck_raw_at(self, count)->has_seg) count--;
    return count;
}

double nck_raw_known(nck_smooth_t *self) { return raw_end(nck_raw_at(self, nck_raw_last(self))); }

uint32_t nck_raw_find(nck_smooth_t *self, double s) {
    uint32_t low = self->raw.tail;
    uint32_t count = self->run.end - low;
    while (count > 0) {
        const uint32_t half = count / 2;
        if (raw_end(nck_raw_at(self, low + half)) < s) {
            low += half + 1;
            count -= half + 1;
        } else {
            count = half;
        }
    }
    if (low != self->run.end && !nck_raw_at(self, low)->has_seg) low = nck_raw_next(self, low);
    return low == self->run.end ? nck_raw_last(self) : low;
}

void nck_raw_point(nck_smooth_t *self, double s, double *point_out) {
    const nck_raw_t *const raw = nck_raw_at(self, nck_raw_find(self, s));
    const double beyond = nck_min(s - raw->s, nck_max(0.0, s - raw_end(raw)));
    // The end is its point to the bit, whatever s − raw->s rounds to.
    const double inside = s >= raw_end(raw) ? raw->seg.length : nck_max(0.0, s - raw->s);
    const int axes = self->terms->axes;
    nck_path_part(&raw->seg, inside, axes, point_out);
    if (beyond == 0.0) return;
    double tangent[NCK_AXIS_MAX];
    nck_path_tangent_part(&raw->seg, inside, axes, tangent);
    for (int x = 0; x < axes; x++) point_out[x] += tangent[x] * beyond;
}

double nck_raw_turn(const nck_seg_t *in, const nck_seg_t *out, int axes, double *turn_out) {
    double tangent[NCK_AXIS_MAX];
    nck_path_tangent_part(in, in->length, axes, tangent);
    nck_path_tangent_part(out, 0.0, axes, turn_out);
    for (int x = 0; x < axes; x++) turn_out[x] -= tangent[x];
    return nck_spline_norm(turn_out, axes);
}

// The control points of a straight stretch of path lie on it evenly, and so does the spline.
static int is_straight(nck_smooth_t *self, double from, double to) {
    const double least = nck_raw_least(to);
    const nck_raw_t *const raw = nck_raw_at(self, nck_raw_find(self, to - least));
    return raw->seg.kind == NCK_SEG_LINE && raw->s <= from + least;
}

void nck_raw_spline(nck_smooth_t *self, int first, nck_seg_t *seg_out) {
    const double *const t = self->run.t + first;
    memset(seg_out, 0, sizeof *seg_out);
    nck_spline_bernstein(t, self->run.c[first], self->run.c[first + 1], self->run.c[first + 2],
                         self->run.c[first + 3], seg_out);
    seg_out->length = t[3] - t[2];
    seg_out->kind = NCK_SEG_SPLINE;
    if (!is_straight(self, nck_spline_greville(t), nck_spline_greville(t + 3))) return;
    seg_out->kind = NCK_SEG_LINE;
    memset(&seg_out->shape, 0, sizeof seg_out->shape);
}

// |p″| over a seg: of a spline the larger end's, for it is linear in between.
static double largest_second(const nck_seg_t *seg, int axes) {
    if (seg->kind == NCK_SEG_LINE) return 0.0;
    double start[NCK_AXIS_MAX];
    double end[NCK_AXIS_MAX];
    nck_path_second(seg, 0.0, start);
    nck_path_second(seg, seg->length, end);
    return nck_max(nck_spline_norm(start, axes), nck_spline_norm(end, axes));
}

// A piece of the spline.
typedef struct piece {
    nck_seg_t seg;
    double begin;  // where in its run [path mm]
    double second; // the largest |p″| [1/mm]
    int axes;      // that may move
} piece_t;

// |spline − programmed path| at s of the spline's run.
static double deviation(const piece_t *piece, const nck_raw_t *raw, double s) {
    double p[NCK_AXIS_MAX];
    double q[NCK_AXIS_MAX];
    nck_path_part(&piece->seg, s - piece->begin, piece->axes, p);
    nck_path_part(&raw->seg, s - raw->s, piece->axes, q);
    return nck_spline_distance(p, q, piece->axes);
}

// As nck_raw_fits, over one block: from range[0] to range[1]. Between two points that are looked at
// the deviation cannot exceed the larger one by more than the sag of both curves.
static int block_fits(const piece_t *piece, const nck_raw_t *raw, const double *range,
                      double allowed) {
    const double length = range[1] - range[0];
    const int parts = 1 + (int)(length * (double)PARTS / piece->seg.length);
    const double h = length / (double)parts;
    const double second = piece->second + largest_second(&raw->seg, piece->axes);
    const double near = allowed - nck_spline_sag(second, h);
    for (int n = 0; n <= parts; n++) {
        if (!(deviation(piece, raw, range[0] + h * (double)n) <= near)) return 0;
    }
    return 1;
}

int nck_raw_fits(nck_smooth_t *self, int first, double share) {
    const double from = self->run.t[first + 2];
    const double to = self->run.t[first + 3];
    if (!(to > from)) return 1;
    piece_t piece;
    nck_raw_spline(self, first, &piece.seg);
    if (piece.seg.kind == NCK_SEG_LINE) return 1;
    piece.begin = from;
    piece.axes = self->terms->axes;
    piece.second = largest_second(&piece.seg, piece.axes);
    double range[2] = {from, from};
    uint32_t count = nck_raw_find(self, from);
    while (count != self->run.end && range[1] < to) {
        const nck_raw_t *const raw = nck_raw_at(self, count);
        range[1] = nck_min(to, raw_end(raw));
        if (!block_fits(&piece, raw, range, share * raw->tolerance)) return 0;
        range[0] = range[1];
        count = nck_raw_next(self, count);
    }
    return 1;
}
