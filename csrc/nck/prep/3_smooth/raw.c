// SPDX-License-Identifier: MIT
// Inside room 3: the programmed path of a run.
#include "nck/prep/3_smooth/raw.h"

#include <string.h> // memset

#include "nck/base/path.h"                 // nck_path_point nck_path_tangent nck_path_second
#include "nck/base/real.h"                 // nck_sqrt nck_min nck_max
#include "nck/prep/3_smooth/spline_math.h" // nck_spline_…

enum {
    PARTS = 8,                    // a knot interval is looked at in so many parts at least
    FIT_BLOCKS = 8,               // that it is compared with in one call
    NEAR = 6                      // guesses at a place's block, before all are looked at
};
#define LEAST 1e-9                // [path mm] a thousandth of what a setpoint can tell
#define LEAST_SHARE 1e-15         // of the place, whose own rounding this is

// A block that lasts so many periods at its feed is long: even in a window of 32 such blocks, the
// least under a jerk limit, half a second of path is known then, more than a brake takes.
#define LONG_PERIODS 16.0

double nck_raw_least(double s) { return LEAST + LEAST_SHARE * s; }

int nck_raw_is_long(const nck_smooth_t *self, const nck_seg_t *seg) {
    const nck_machine_t *const machine = self->terms->machine;
    const double most = machine->path.feed_max;
    const double feed = seg->rapid ? most : nck_min(seg->feed, most);
    return seg->length >= LONG_PERIODS * machine->period_s * feed;
}

// The first of so many blocks from `low` on that ends at s or behind it, or the one behind them.
static uint32_t search(nck_smooth_t *self, uint32_t low, uint32_t count, double s) {
    while (count > 0) {
        const uint32_t half = count / 2;
        if (nck_raw_end(nck_raw_at(self, low + half)) < s) {
            low += half + 1;
            count -= half + 1;
        } else {
            count = half;
        }
    }
    return low;
}

static uint32_t skip_outputs(nck_smooth_t *self, uint32_t low) {
    const uint32_t count = low == self->run.end ? low : nck_raw_next(self, low);
    return count == self->run.end ? nck_raw_last(self) : count;
}

// The block with length of the run from `low` on.
static inline uint32_t with_length(nck_smooth_t *self, uint32_t low) {
    return low != self->run.end && nck_raw_at(self, low)->has_seg ? low : skip_outputs(self, low);
}

// A block begins where the one before it ends, to the bit: is s in it, or at its end?
static int is_in(const nck_raw_t *raw, double s) { return raw->s < s && !(nck_raw_end(raw) < s); }

// So many blocks on or back, at most: where s would be if all were as long as this one, one at
// least.
static uint32_t leap(const nck_raw_t *raw, double way, uint32_t most) {
    if (!(way > raw->seg.length) || !(raw->seg.length > 0.0)) return 1; // outputs have no length
    return (uint32_t)nck_min((double)most, way / raw->seg.length);
}

// nck_raw_find, from a guess.
static uint32_t find_near(nck_smooth_t *self, uint32_t guess, double s) {
    const uint32_t low = self->raw.tail;
    const uint32_t last = self->run.end - 1;
    uint32_t at = guess;
    for (int n = 0; n < NEAR; n++) {
        const nck_raw_t *const raw = nck_raw_at(self, at);
        if (is_in(raw, s)) return at;
        if (raw->s < s) {
            if (at == last) return nck_raw_last(self);
            at += leap(raw, s - raw->s, last - at);
        } else {
            if (at == low) return with_length(self, at);
            at -= leap(raw, raw->s - s + raw->seg.length, at - low);
        }
    }
    return with_length(self, search(self, low, last + 1 - low, s));
}

// Blocks are much of a length: the guess is where s would be if they all were.
uint32_t nck_raw_find(nck_smooth_t *self, double s) {
    const uint32_t low = self->raw.tail;
    const uint32_t most = self->run.end - low - 1;
    const double first = nck_raw_end(nck_raw_at(self, low));
    const double last = nck_raw_end(nck_raw_at(self, low + most));
    if (!(s > first)) return with_length(self, low);
    if (s > last) return nck_raw_last(self);
    const double blocks = (double)most * ((s - first) / (last - first));
    return find_near(self, low + (uint32_t)blocks, s);
}

static inline int is_inside(const nck_seg_t *seg, double s) { return s > 0.0 && s < seg->length; }

// nck_path_part; most places are inside a line.
static inline void part_of(const nck_seg_t *seg, double s, int axes, double *point_out) {
    if (seg->kind != NCK_SEG_LINE || !is_inside(seg, s)) {
        nck_path_part(seg, s, axes, point_out);
        return;
    }
    const double f = s / seg->length;
    for (int x = 0; x < axes; x++) point_out[x] = nck_path_straight(seg, x, f);
}

// The point at s, beside a block or at one of its ends, which is its point to the bit.
static void point_beside(const nck_raw_t *raw, double s, int axes, double *point_out) {
    const int before = s < raw->s;
    const double *const end = before ? raw->seg.start : raw->seg.end;
    const double beyond = s - (before ? raw->s : nck_raw_end(raw));
    if (beyond == 0.0) {
        for (int x = 0; x < axes; x++) point_out[x] = end[x];
        return;
    }
    if (raw->seg.kind == NCK_SEG_LINE) {
        for (int x = 0; x < axes; x++) {
            point_out[x] = end[x] + nck_path_slope(&raw->seg, x) * beyond;
        }
        return;
    }
    nck_path_tangent_part(&raw->seg, before ? 0.0 : raw->seg.length, axes, point_out);
    for (int x = 0; x < axes; x++) point_out[x] = end[x] + point_out[x] * beyond;
}

// The point at s, of a block that it is in, or nearest to.
static inline void point_by(const nck_raw_t *raw, double s, int axes, double *point_out) {
    if (s >= raw->s && s < nck_raw_end(raw)) part_of(&raw->seg, s - raw->s, axes, point_out);
    else point_beside(raw, s, axes, point_out);
}

void nck_raw_point(nck_smooth_t *self, double s, double *point_out) {
    point_by(nck_raw_at(self, nck_raw_find(self, s)), s, self->terms->axes, point_out);
}

void nck_raw_points(nck_smooth_t *self, uint32_t near, const double *places, int count,
                    double (*points_out)[NCK_AXIS_MAX], uint32_t *off) {
    const int axes = self->terms->axes;
    const uint32_t last = self->run.end - 1;
    uint32_t at = self->raw.tail;
    for (int k = 0; k < count; k++) {
        const uint32_t guess = near + off[k];
        if (guess - at <= last - at) at = guess;
        at = find_near(self, at, places[k]);
        point_by(nck_raw_at(self, at), places[k], axes, points_out[k]);
        off[k] = at - near;
    }
}

void nck_raw_ahead(nck_smooth_t *self, uint32_t near, double s, double *point_out,
                   uint32_t *off) {
    const uint32_t last = nck_raw_last(self);
    const nck_raw_t *const raw = nck_raw_at(self, last);
    uint32_t at = last;
    if (!(s > nck_raw_end(raw))) {
        at = find_near(self, *off < last - near ? near + *off : last, s);
        point_by(nck_raw_at(self, at), s, self->terms->axes, point_out);
    } else {
        point_beside(raw, s, self->terms->axes, point_out);
    }
    *off = at - near;
}

void nck_raw_spread(nck_smooth_t *self, double s, double step, int count,
                    double (*points_out)[NCK_AXIS_MAX]) {
    double places[NCK_RAW_SPREAD];
    uint32_t off[NCK_RAW_SPREAD] = {0};
    for (int k = 0; k < count; k++) places[k] = s + step * (double)k;
    nck_raw_points(self, nck_raw_find(self, s), places, count, points_out, off);
}

double nck_raw_turn(const nck_seg_t *in, const nck_seg_t *out, int axes, double *turn_out) {
    double tangent[NCK_AXIS_MAX];
    if (in->kind == NCK_SEG_LINE && out->kind == NCK_SEG_LINE) {
        double sum = 0.0;
        for (int x = 0; x < axes; x++) {
            const double by = nck_path_slope(out, x) - nck_path_slope(in, x);
            turn_out[x] = by;
            sum += by * by;
        }
        return nck_sqrt(sum);
    }
    nck_path_tangent_part(in, in->length, axes, tangent);
    nck_path_tangent_part(out, 0.0, axes, turn_out);
    for (int x = 0; x < axes; x++) turn_out[x] -= tangent[x];
    return nck_spline_norm(turn_out, axes);
}

// 1 if an end of a block is off the program.
static int is_moved(const nck_raw_t *raw) {
    return raw->moved[0] != 0.0f || raw->moved[1] != 0.0f;
}

double nck_raw_stretch(const nck_raw_t *raw, int axes) {
    if (!is_moved(raw)) return 1.0;
    return nck_spline_distance(raw->seg.start, raw->seg.end, axes) / raw->seg.length;
}

double nck_raw_curvature(const nck_seg_t *seg, int axes) {
    double second[NCK_AXIS_MAX];
    if (seg->kind == NCK_SEG_LINE) return 0.0;
    nck_path_second(seg, 0.0, second);
    return nck_spline_norm(second, axes);
}

// The control points of a straight stretch of path lie on it evenly, and so does the spline.
static int is_straight(nck_smooth_t *self, double from, double to) {
    const double least = nck_raw_least(to);
    const nck_raw_t *const raw = nck_raw_at(self, nck_raw_find(self, to - least));
    return raw->seg.kind == NCK_SEG_LINE && raw->s <= from + least;
}

// As nck_raw_spline, but only what tells its points: kind, length, and of the Bernstein points the
// coordinates that may change.
static void take_shape(nck_smooth_t *self, int first, nck_seg_t *seg_out) {
    const double *const t = self->run.t + first;
    nck_spline_bernstein(t, self->run.c + first, self->terms->axes, seg_out);
    seg_out->length = t[3] - t[2];
    double from = t[3];
    double to = t[2];
    for (int i = first; i < first + 4; i++) {
        from = nck_min(from, self->run.reach[i][0]);
        to = nck_max(to, self->run.reach[i][1]);
    }
    seg_out->kind = is_straight(self, from, to) ? NCK_SEG_LINE : NCK_SEG_SPLINE;
}

void nck_raw_spline(nck_smooth_t *self, int first, nck_seg_t *seg_out) {
    const double *const stays = self->run.c[first];
    memset(seg_out, 0, sizeof *seg_out);
    take_shape(self, first, seg_out);
    for (int x = self->terms->axes; x < NCK_AXIS_MAX; x++) {
        seg_out->shape.inner[0][x] = stays[x];
        seg_out->shape.inner[1][x] = stays[x];
        seg_out->start[x] = stays[x];
        seg_out->end[x] = stays[x];
    }
    if (seg_out->kind == NCK_SEG_LINE) memset(&seg_out->shape, 0, sizeof seg_out->shape);
}

// |p″| over a spline: the larger end's, for it is linear in between.
static double largest_second(const nck_seg_t *seg, int axes) {
    double start[NCK_AXIS_MAX];
    double end[NCK_AXIS_MAX];
    nck_path_second_part(seg, 0.0, axes, start);
    nck_path_second_part(seg, seg->length, axes, end);
    return nck_max(nck_spline_norm(start, axes), nck_spline_norm(end, axes));
}

// A piece of the spline.
typedef struct piece {
    nck_seg_t seg;
    double begin;  // where in its run [path mm]
    double second; // the largest |p″| [1/mm]
    int axes;      // that may move
} piece_t;

// Distance of a piece's point at s of the spline's run from another one.
static double distance_to(const piece_t *piece, double s, const double *point) {
    const double along = s - piece->begin;
    double sum = 0.0;
    if (!is_inside(&piece->seg, along)) {
        double p[NCK_AXIS_MAX];
        nck_path_part(&piece->seg, along, piece->axes, p);
        return nck_spline_distance(p, point, piece->axes);
    }
    const double f = along / piece->seg.length;
    for (int x = 0; x < piece->axes; x++) {
        const double off = nck_path_cubic(&piece->seg, x, f) - point[x];
        sum += off * off;
    }
    return nck_sqrt(sum);
}

// |spline − programmed path| at s of the spline's run; many places are at a block's end.
static inline double deviation(const piece_t *piece, const nck_raw_t *raw, double s) {
    const double along = s - raw->s;
    double point[NCK_AXIS_MAX];
    if (along >= raw->seg.length) return distance_to(piece, s, raw->seg.end);
    part_of(&raw->seg, along, piece->axes, point);
    return distance_to(piece, s, point);
}

// The largest |p̃″ − p″| of a piece and a block, from range[0] to range[1]: p̃″ is linear
// there, and an arc's p″, which turns by ω over a unit of path, leaves its chord by no more than
// |p″|ω²h²/8.
static double second_apart(const piece_t *piece, const nck_raw_t *raw, const double *range) {
    if (raw->seg.kind == NCK_SEG_LINE) return piece->second;
    const double turned =
        raw->seg.shape.arc.sweep / raw->seg.length * (range[1] - range[0]);
    double apart = 0.0;
    double kappa = 0.0;
    for (int n = 0; n < 2; n++) {
        double p[NCK_AXIS_MAX];
        double q[NCK_AXIS_MAX];
        nck_path_second_part(&piece->seg, range[n] - piece->begin, piece->axes, p);
        nck_path_second_part(&raw->seg, range[n] - raw->s, piece->axes, q);
        apart = nck_max(apart, nck_spline_distance(p, q, piece->axes));
        kappa = nck_spline_norm(q, piece->axes);
    }
    return apart + kappa * turned * turned / 8.0;
}

// How much of its tolerance such a block has used at s of its run.
static double used_at(const nck_raw_t *raw, double s) {
    const double first = (double)raw->moved[0];
    return first + ((double)raw->moved[1] - first) * (s - raw->s) / raw->seg.length;
}

// As nck_raw_fit, over one block: from range[0] to range[1]. Between two points that are looked at
// the deviation cannot exceed the larger one by more than what their difference can sag.
// off: the deviation at range[0]; negative if it is not known. Takes that at range[1].
static int block_fits(const piece_t *piece, const nck_raw_t *raw, const double *range,
                      double allowed, double *off) {
    const double length = range[1] - range[0];
    const int parts = 1 + (int)(length * (double)PARTS / piece->seg.length);
    const double h = length / (double)parts;
    const double near = allowed - nck_spline_sag(second_apart(piece, raw, range), h);
    if (*off < 0.0) *off = deviation(piece, raw, range[0]);
    const int moved = is_moved(raw);
    int fits = *off + (moved ? used_at(raw, range[0]) : 0.0) <= near;
    for (int n = 1; n <= parts && fits; n++) {
        const double s = range[0] + h * (double)n;
        *off = deviation(piece, raw, s);
        fits = *off + (moved ? used_at(raw, s) : 0.0) <= near;
    }
    return fits;
}

void nck_raw_begin_fit(nck_smooth_t *self, int first) {
    self->run.trial.count = nck_raw_find(self, self->run.t[first + 2]);
    self->run.trial.off = -1.0;
}

nck_status_t nck_raw_fit(nck_smooth_t *self, int first, double share) {
    nck_trial_t *const trial = &self->run.trial;
    const double from = self->run.t[first + 2];
    const double to = self->run.t[first + 3];
    piece_t piece;
    if (!(to > from)) return NCK_DONE;
    take_shape(self, first, &piece.seg);
    if (piece.seg.kind == NCK_SEG_LINE) return NCK_DONE;
    piece.begin = from;
    piece.axes = self->terms->axes;
    piece.second = largest_second(&piece.seg, piece.axes);
    for (int n = 0; n < FIT_BLOCKS; n++) {
        if (trial->count == self->run.end) return NCK_DONE;
        const nck_raw_t *const raw = nck_raw_at(self, trial->count);
        const double range[2] = {nck_max(from, raw->s), nck_min(to, nck_raw_end(raw))};
        if (!(range[0] < to)) return NCK_DONE;
        if (!block_fits(&piece, raw, range, share * raw->tolerance, &trial->off)) {
            return NCK_E_STATE;
        }
        trial->count = nck_raw_next(self, trial->count);
    }
    return NCK_OK;
}
