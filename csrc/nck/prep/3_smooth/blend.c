// SPDX-License-Identifier: MIT
// Inside room 3: where a corner is in the ring, how much room it has, and the pieces of its blend.
#include "nck/prep/3_smooth/blend.h"

#include <assert.h> // assert
#include <string.h> // memcpy memset

#include "nck/base/real.h"                 // nck_min nck_max
#include "nck/prep/3_smooth/blend_math.h"  // nck_blend_…
#include "nck/prep/3_smooth/choice.h"      // nck_choice_blend
#include "nck/prep/3_smooth/raw.h"         // nck_raw_at
#include "nck/prep/3_smooth/spline_math.h" // nck_spline_…

#define LEAST 1e-9 // [path mm]: a piece shorter than that is rounding

// ---- the pieces

typedef struct shape {
    const nck_blend_t *corner;
    const double *vertex;
    double d, parking;
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
        seg->shape.inner[0][x] = seg->start[x] + t0[x] * third;
        seg->shape.inner[1][x] = seg->end[x] - t1[x] * third;
    }
    seg->kind = NCK_SEG_SPLINE;
    seg->blend = 1;
    seg->length = to - from;
    seg->program = seg->length * (2.0 * shape->d / (2.0 * shape->d + shape->parking));
}

// The places where the shape's third derivative changes, in order, and its middle: there one block
// ends and the next one begins, and outputs come. Returns how many.
static int knots_of(const shape_t *shape, double *knot) {
    const double inner = shape->parking - shape->d;
    const double places[NCK_BLEND_SEGS + 1] = {
        -shape->d, nck_min(0.0, inner), nck_max(0.0, inner),
        0.5 * shape->parking,
        nck_min(shape->d, shape->parking), nck_max(shape->d, shape->parking),
        shape->parking + shape->d};
    int count = 1;
    knot[0] = places[0];
    for (int k = 1; k <= NCK_BLEND_SEGS; k++) {
        if (places[k] > knot[count - 1] + LEAST) knot[count++] = places[k];
    }
    return count;
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
    const uint32_t before = count / 2;
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
        // Each half has the words of its own block.
        nck_raw_take_words(k < before ? &a->seg : &b->seg, &raw->seg);
        if (k > 0) memcpy(raw->seg.start, start, sizeof raw->seg.start);
        start = raw->seg.end;
    }
    memcpy(a->seg.end, nck_raw_at(self, place->first + 1)->seg.start, sizeof a->seg.end);
    a->seg.length -= shape->d;
    a->onward = NCK_ONWARD_UNKNOWN;
    memcpy(b->seg.start, start, sizeof b->seg.start);
    b->seg.length -= shape->d;
    b->cut = shape->d;
    b->onward = NCK_ONWARD_UNKNOWN;
    b->s = 0.0; // a run of its own: outputs behind it are at its end
    self->raw.head += count;
    assert(self->raw.head - self->raw.tail <= NCK_SMOOTH_ROWS);
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
    if (!a->smooth || !b->smooth || a->seg.stop) return 0.0;
    double by[NCK_AXIS_MAX];
    const double turn = nck_raw_turn(&a->seg, &b->seg, self->terms->axes, by);
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
    return place->end - self->raw.tail + NCK_BLEND_SEGS <= NCK_SMOOTH_ROWS;
}

// The run at the front ends at the corner.
static void end_run_behind(nck_smooth_t *self, uint32_t first) {
    if (!self->run.open || (int32_t)(self->run.end - first) <= 1) return;
    self->run.end = first + 1;
    self->run.closed = 1;
}

static uint32_t insert_blend(nck_smooth_t *self, const nck_blend_t *corner,
                             const place_t *place) {
    double vertex[NCK_AXIS_MAX];
    memcpy(vertex, nck_raw_at(self, place->first)->seg.end, sizeof vertex);
    const shape_t shape = {corner, vertex, corner->d, corner->parking};
    const uint32_t count = insert(self, &shape, place);
    end_run_behind(self, place->first);
    return count;
}

uint32_t nck_blend_corner(nck_smooth_t *self, uint32_t more) {
    place_t place;
    nck_blend_t blend;
    if (!self->terms->limits_jerk || !find_place(self, more, &place)) return 0;
    const nck_raw_t *const a = nck_raw_at(self, place.first);
    const nck_raw_t *const b = nck_raw_at(self, place.last);
    if (!is_line(a) || !is_line(b)) return 0;
    const int rests_behind = !more || !nck_raw_at(self, self->raw.head)->smooth;
    const nck_meet_t meet = {a, b, {a->seg.length, b->seg.length},
                             {!(a->s > 0.0) && !(a->cut > 0.0), (uint8_t)rests_behind}};
    if (!nck_choice_may_blend(self, &meet)) return 0;
    if (!nck_choice_blend(self, &meet, room_of(self, &place), &blend)) return 0;
    return is_free(self, place.first, blend.d) ? insert_blend(self, &blend, &place) : 0;
}
