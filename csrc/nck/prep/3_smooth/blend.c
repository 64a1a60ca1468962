// SPDX-License-Identifier: MIT
// Inside room 3: is a blend of its own worth it, how long is it, and its pieces.
//
// A spline within the tolerance takes a sharp corner at a speed that falls with the tolerance, and
// the path has to slow down to it and to speed up again. The blend is passed at one speed, as wide
// as the lines allow: slowing down is part of its shape (README, "Corners").
#include "nck/prep/3_smooth/blend.h"

#include <string.h> // memcpy memset

#include "nck/base/real.h"                 // nck_min nck_max
#include "nck/base/root_math.h"            // nck_root_cube
#include "nck/prep/3_smooth/blend_math.h"  // nck_blend_…
#include "nck/prep/3_smooth/raw.h"         // nck_raw_at
#include "nck/prep/3_smooth/spline_math.h" // nck_spline_…

#define HALF 0.495           // of a line, for the blend at one of its ends
#define TOLERANCE_SHARE 0.98 // of P: rounding of setpoints is the rest
#define JERK_SHARE 0.85      // of what room 4 lets the bend use of an axis' jerk
#define ACCEL_SHARE 0.95     // the same of its acceleration
#define WORTH 0.98           // of the spline's time, to be taken
#define LEAST 1e-9           // [path mm]: a piece shorter than that is rounding
enum { HALVINGS = 30, MIDDLE = 3 };

// What a corner is like. Speeds in path mm/s.
typedef struct corner {
    double in[NCK_AXIS_MAX];  // unit tangents
    double out[NCK_AXIS_MAX];
    double sine;              // of the angle between the two lines
    double turn;              // |out − in|
    double tolerance;         // [path mm]
    double half;              // most that a blend may take of either line [path mm]
    double v_max;             // of the lines
    double a, j;              // tangential, of the slower line
    double bend_a, bend_j;    // of v²·(shape) and v³·(shape): see limits_of
    double plain_j;           // the same of the spline
} corner_t;

// Largest number whose product with every axis' part keeps to that axis' limit.
static double least_of(double so_far, double limit, double part) {
    const double size = nck_fabs(part);
    return size > 0.0 ? nck_min(so_far, limit / size) : so_far;
}

// What the axes allow: along the lines, and of |p″| and |p‴| of the shapes in units of 1/d, 1/d².
static void limits_of(const nck_machine_t *machine, corner_t *corner) {
    corner->a = machine->path.a_max;
    corner->j = machine->path.j_max;
    corner->bend_a = machine->path.a_max;
    corner->bend_j = machine->path.j_max;
    corner->plain_j = machine->path.j_max;
    for (int x = 0; x < NCK_AXIS_MAX; x++) {
        const double a = machine->axis[x].a_max;
        const double j = machine->axis[x].j_max;
        const double in = corner->in[x];
        const double out = corner->out[x];
        const double sum = nck_fabs(in) + nck_fabs(out);
        corner->a = least_of(least_of(corner->a, a, in), a, out);
        corner->j = least_of(least_of(corner->j, j, in), j, out);
        corner->bend_a = least_of(corner->bend_a, a, sum);
        corner->bend_j = least_of(corner->bend_j, j, sum);
        corner->plain_j = least_of(corner->plain_j, j, out - in);
    }
    corner->bend_a *= ACCEL_SHARE;
    corner->bend_j *= JERK_SHARE;
    corner->plain_j *= JERK_SHARE;
}

// Speed through a blend of half-width d.
static double blend_speed(const corner_t *corner, double d) {
    const double by_jerk = nck_root_cube(corner->bend_j * d * d);
    return nck_min(corner->v_max, nck_min(by_jerk, nck_sqrt(corner->bend_a * d)));
}

// Time of an S-shaped ramp over a difference of speeds.
static double ramp_time(const corner_t *corner, double dv) {
    const double a = corner->a;
    const double j = corner->j;
    return dv * j <= a * a ? 2.0 * nck_sqrt(dv / j) : dv / a + a / j;
}

// Time lost by a ramp between v and full speed, against full speed over the same path.
static double ramp_loss(const corner_t *corner, double v) {
    const double dv = nck_max(0.0, corner->v_max - v);
    return ramp_time(corner, dv) * dv / (2.0 * corner->v_max);
}

// Least time over a length from v on, and the speed at its end.
static double ramp_over(const corner_t *corner, double v, double length, double *v_end) {
    double low = v;
    double high = corner->v_max;
    for (int n = 0; n < HALVINGS; n++) {
        const double middle = 0.5 * (low + high);
        if (0.5 * (v + middle) * ramp_time(corner, middle - v) <= length) low = middle;
        else high = middle;
    }
    const double t = ramp_time(corner, low - v);
    *v_end = low;
    return t + (length - 0.5 * (v + low) * t) / low;
}

// Time of half a corner over a length of line beside it, ramps to full speed included.
static double plain_time(const corner_t *corner, double length) {
    const double d = nck_spline_vertex_spacing(corner->tolerance, corner->turn);
    const double v = nck_min(corner->v_max, nck_root_cube(corner->plain_j * d * d));
    double v_end = 0.0;
    if (!(v > 0.0) || d >= length) return 0.0;
    const double t = d / v + ramp_over(corner, v, length - d, &v_end);
    return t + ramp_loss(corner, v_end);
}

static double blend_time(const corner_t *corner, double d, double parking) {
    const double v = blend_speed(corner, d);
    return (d + 0.5 * parking) / v + ramp_loss(corner, v);
}

static double line_speed(const nck_smooth_t *self, const nck_seg_t *seg) {
    double v = nck_min(self->machine->path.feed_max, seg->rapid ? 1e9 : seg->feed);
    for (int x = 0; x < NCK_AXIS_MAX; x++) {
        const nck_axis_t *const axis = &self->machine->axis[x];
        const double limit = seg->rapid ? axis->rapid : axis->v_max;
        v = least_of(v, limit, (seg->end[x] - seg->start[x]) / seg->length);
    }
    return v;
}

// 1 if there is a corner that might want a blend.
static int measure(const nck_smooth_t *self, const nck_raw_t *a, const nck_raw_t *b,
                   corner_t *corner) {
    double cosine = 0.0;
    for (int x = 0; x < NCK_AXIS_MAX; x++) {
        corner->in[x] = (a->seg.end[x] - a->seg.start[x]) / a->seg.length;
        corner->out[x] = (b->seg.end[x] - b->seg.start[x]) / b->seg.length;
        cosine += corner->in[x] * corner->out[x];
    }
    corner->turn = nck_spline_distance(corner->in, corner->out);
    corner->sine = nck_sqrt(nck_max(0.0, 1.0 - cosine * cosine));
    corner->tolerance = TOLERANCE_SHARE * nck_min(a->tolerance, b->tolerance);
    corner->half = nck_min(nck_min(a->seg.length, HALF * (a->seg.length + a->cut)),
                           HALF * b->seg.length);
    corner->v_max = nck_min(line_speed(self, &a->seg), line_speed(self, &b->seg));
    limits_of(self->machine, corner);
    return corner->turn > 0.0;
}

// The half-width and the parking of a blend that is faster than the spline; 0: none is.
static double width_of(const corner_t *corner, double *parking) {
    const double v = corner->v_max;
    const double enough = nck_max(v * v / corner->bend_a,
                                  nck_sqrt(v * v * v / corner->bend_j));
    const double d = nck_min(corner->half, enough);
    *parking = nck_blend_parking(d, corner->tolerance, corner->sine);
    if (!(*parking > LEAST)) return 0.0;
    const double plain = plain_time(corner, d);
    return plain > 0.0 && blend_time(corner, d, *parking) < WORTH * plain ? d : 0.0;
}

// ---- the pieces

typedef struct shape {
    const corner_t *corner;
    const double *vertex;
    double d, parking;
    int is_split; // 1: a piece ends in the middle, for outputs
} shape_t;

static void point(const shape_t *shape, double s, double *p, double *tangent) {
    const double back = shape->parking - s;
    const double in = nck_blend_stop(s, shape->d);
    const double out = -nck_blend_stop(back, shape->d);
    const double in_slope = nck_blend_stop_slope(s, shape->d);
    const double out_slope = nck_blend_stop_slope(back, shape->d);
    for (int x = 0; x < NCK_AXIS_MAX; x++) {
        const double u = shape->corner->in[x];
        const double w = shape->corner->out[x];
        p[x] = shape->vertex[x] + (u * in + w * out);
        tangent[x] = u * in_slope + w * out_slope;
    }
}

static void set_piece(const shape_t *shape, double from, double to, nck_seg_t *seg) {
    double t0[NCK_AXIS_MAX];
    double t1[NCK_AXIS_MAX];
    const double third = (to - from) / 3.0;
    point(shape, from, seg->start, t0);
    point(shape, to, seg->end, t1);
    for (int x = 0; x < NCK_AXIS_MAX; x++) {
        seg->inner[0][x] = seg->start[x] + t0[x] * third;
        seg->inner[1][x] = seg->end[x] - t1[x] * third;
    }
    seg->kind = NCK_SEG_SPLINE;
    seg->blend = 1;
    seg->length = to - from;
    seg->program = seg->length * (2.0 * shape->d / (2.0 * shape->d + shape->parking));
}

// The places where the shape's third derivative changes, in order; and its middle, if outputs are
// to come there. Returns how many.
static int knots_of(const shape_t *shape, double *knot) {
    const double inner = shape->parking - shape->d;
    const double places[NCK_BLEND_SEGS + 1] = {
        -shape->d, nck_min(0.0, inner), nck_max(0.0, inner),
        0.5 * shape->parking, // MIDDLE
        nck_min(shape->d, shape->parking), nck_max(shape->d, shape->parking),
        shape->parking + shape->d};
    int count = 0;
    for (int k = 0; k <= NCK_BLEND_SEGS; k++) {
        if (k == MIDDLE && !shape->is_split) continue;
        if (count == 0 || places[k] > knot[count - 1] + LEAST) knot[count++] = places[k];
    }
    return count;
}

static void take_words(const nck_raw_t *a, const nck_raw_t *b, int later, nck_seg_t *seg) {
    const nck_seg_t *const named = later ? &b->seg : &a->seg;
    const double least = nck_min(a->seg.feed, b->seg.feed);
    seg->line = named->line;
    seg->block = named->block;
    seg->rapid = a->seg.rapid && b->seg.rapid;
    seg->feed = a->seg.rapid || b->seg.rapid ? nck_max(a->seg.feed, b->seg.feed) : least;
    seg->feed_scale = nck_max(a->seg.feed_scale, b->seg.feed_scale);
}

// Where the corner of a blend is in the ring, by counts.
typedef struct place {
    uint32_t first; // the block before the corner; outputs follow
    uint32_t last;  // the block behind it
    uint32_t end;   // behind the blocks that move along
} place_t;

static void move_block(nck_smooth_t *self, uint32_t from, uint32_t by) {
    *nck_raw_at(self, from + by) = *nck_raw_at(self, from);
}

// Room for the pieces of the corner: so many before its outputs, so many behind them.
static void make_way(nck_smooth_t *self, const place_t *place, uint32_t before, uint32_t behind) {
    uint32_t k = place->end;
    while (k != place->last) {
        k--;
        move_block(self, k, before + behind);
    }
    k--;
    while (k != place->first) {
        move_block(self, k, before);
        k--;
    }
}

// The pieces take the places in front of the outputs and behind them; the lines get shorter.
static uint32_t insert(nck_smooth_t *self, const shape_t *shape, const place_t *place) {
    double knot[NCK_BLEND_SEGS + 1];
    const uint32_t count = (uint32_t)knots_of(shape, knot) - 1;
    const uint32_t outputs = place->last - place->first - 1;
    const uint32_t before = outputs > 0 ? count / 2 : count;
    make_way(self, place, before, count - before);
    nck_raw_t *const a = nck_raw_at(self, place->first);
    nck_raw_t *const b = nck_raw_at(self, place->last + count);
    const double *start = shape->vertex;
    for (uint32_t k = 0; k < count; k++) {
        const uint32_t at = place->first + 1 + k + (k < before ? 0 : outputs);
        nck_raw_t *const raw = nck_raw_at(self, at);
        memset(raw, 0, sizeof *raw);
        raw->has_seg = 1;
        set_piece(shape, knot[k], knot[k + 1], &raw->seg);
        take_words(a, b, knot[k] + knot[k + 1] > shape->parking, &raw->seg);
        if (k > 0) memcpy(raw->seg.start, start, sizeof raw->seg.start);
        start = raw->seg.end;
    }
    memcpy(a->seg.end, nck_raw_at(self, place->first + 1)->seg.start, sizeof a->seg.end);
    a->seg.length -= shape->d;
    memcpy(b->seg.start, start, sizeof b->seg.start);
    b->seg.length -= shape->d;
    b->cut = shape->d;
    b->s = 0.0; // a run of its own: outputs behind it are at its end
    self->raw.head += count;
    for (uint32_t k = place->last + 1; k != place->end; k++) {
        nck_raw_at(self, k + count)->s = b->seg.length;
    }
    return count;
}

static int is_line(const nck_raw_t *raw) {
    return raw->smooth && raw->has_seg && raw->seg.kind == NCK_SEG_LINE;
}

// How much of a line the spline of the corner between it and another block may bend. Where the run
// goes on from a blend its first stretch must be straight: the blend ends without curvature.
static double bent_by(const nck_smooth_t *self, const nck_raw_t *a, const nck_raw_t *b) {
    if (!a->smooth || !b->smooth) return 0.0;
    double by[NCK_AXIS_MAX];
    const double turn = nck_raw_turn(&a->seg, &b->seg, by);
    const double tolerance = nck_min(a->tolerance, b->tolerance);
    const double spacing = turn > 0.0 ? nck_spline_vertex_spacing(tolerance, turn) : 1e9;
    return NCK_BLEND_KEEP_OFF * nck_min(nck_max(a->spacing, spacing), self->spacing_max);
}

// What the corners at the far ends of both lines leave to a blend between them.
static double room_of(nck_smooth_t *self, const place_t *place) {
    const nck_raw_t *const a = nck_raw_at(self, place->first);
    const nck_raw_t *const b = nck_raw_at(self, place->last);
    double room = nck_min(a->seg.length, b->seg.length);
    if (place->end != place->last + 1) {
        room = nck_min(room, b->seg.length - bent_by(self, b, nck_raw_at(self, place->end - 1)));
    }
    uint32_t count = place->first;
    while (count != self->raw.tail && !nck_raw_at(self, count - 1)->has_seg) count--;
    if (count != self->raw.tail) {
        room = nck_min(room, a->seg.length - bent_by(self, nck_raw_at(self, count - 1), a));
    }
    return room;
}

// The run at the front may have gone too far along the first line already.
static int is_free(nck_smooth_t *self, uint32_t count, double d) {
    const nck_raw_t *const raw = nck_raw_at(self, count);
    const int in_run = self->run.open && (int32_t)(self->run.end - count) > 0;
    const double *const t = self->run.t;
    const double taken = t[self->run.chosen ? 5 : 4] + NCK_BLEND_KEEP_OFF * (t[4] - t[3]);
    return !(raw->spacing > 0.0) && (!in_run || raw->s + raw->seg.length - d > taken + LEAST);
}

// The newest two blocks of the ring with segs. 0 if there are no two.
static int find_place(nck_smooth_t *self, uint32_t more, place_t *place) {
    place->end = self->raw.head + more;
    place->last = self->raw.head;
    do {
        if (place->last == self->raw.tail) return 0;
    } while (!nck_raw_at(self, --place->last)->has_seg);
    place->first = place->last;
    do {
        if (place->first == self->raw.tail) return 0;
    } while (!nck_raw_at(self, --place->first)->has_seg);
    return place->end - self->raw.tail + NCK_BLEND_SEGS <= NCK_SMOOTH_SPAN;
}

uint32_t nck_blend_corner(nck_smooth_t *self, uint32_t more) {
    place_t place;
    corner_t corner;
    if (self->machine->slope == NCK_SLOPE_LINEAR) return 0;
    if (!find_place(self, more, &place)) return 0;
    nck_raw_t *const a = nck_raw_at(self, place.first);
    const nck_raw_t *const b = nck_raw_at(self, place.last);
    if (!is_line(a) || !is_line(b) || !measure(self, a, b, &corner)) return 0;
    corner.half = nck_min(corner.half, room_of(self, &place));
    if (!(corner.half > 0.0)) return 0;
    double parking = 0.0;
    const double d = width_of(&corner, &parking);
    if (!(d > 0.0) || !is_free(self, place.first, d)) return 0;
    double vertex[NCK_AXIS_MAX];
    memcpy(vertex, a->seg.end, sizeof vertex);
    const shape_t shape = {&corner, vertex, d, parking, place.last != place.first + 1};
    const uint32_t count = insert(self, &shape, &place);
    if (self->run.open && (int32_t)(self->run.end - place.first) > 1) {
        self->run.end = place.first + 1;
        self->run.closed = 1;
    }
    return count;
}
