// SPDX-License-Identifier: MIT
// Inside room 3: how far apart the knots may be at the end of each block, and whether it is faster
// to rest there.
#include "nck/prep/3_smooth/spacing.h"

#include "nck/base/budget.h"               // NCK_UNLIMITED
#include "nck/base/real.h"                 // nck_min nck_max
#include "nck/prep/3_smooth/curve.h"       // nck_curve_… NCK_CURVE_AIM
#include "nck/prep/3_smooth/estimate.h"    // nck_estimate_…
#include "nck/prep/3_smooth/meet.h"        // nck_meet_choose
#include "nck/prep/3_smooth/pair.h"        // nck_pair_find
#include "nck/prep/3_smooth/raw.h"         // nck_raw_…
#include "nck/prep/3_smooth/spline_math.h" // nck_spline_…

// NCK_CURVE_AIM of a lone corner, where nothing is left to chance.
#define AIM_KEY 0.96
#define GROWTH 1.5       // between two spacings that are looked at for a block's end
#define NEIGHBOUR 0.7    // of a spacing: where to begin to look for the next one
#define KEY_LEAST 0.5    // a corner is a key if the spacing that it allows alone is right by …
#define KEY_MOST 1.5     // … these shares, and it is none of a bend
// … whose chords are shorter than so many of its corners' spacings: half of the bulge, L·|Δu|/16,
// is within 0.7 P then; a spacing is 6·0.7·P/|Δu|
#define CHORD (8.0 / 3.0)
#define NO_GAP 1e-6      // of a spacing: what two corners leave of a line, by rounding
#define FEW_GAPS 0.408   // of a line, for the corner at one of its ends: so much is left between
#define CROWDED 0.25     // of a spacing: keys that are nearer than that are one
#define OTHERS 0.25      // of a key's turn that other corners within its spacing may make
// Growth of a path's squared bends with twice the spacing: 16 on a curve, 4 at a corner, 2 on a
// random walk, 1 in noise. Below the first it gets noise, below the second it stays noise.
#define GETS_ROUGH 1.25
#define STAYS_ROUGH 2.0
#define SAME 0.9         // tolerances of blocks that differ by no more count as one
#define SMALL 0.125      // of a spacing: such a block has the one before it
#define BLUNT 1.25       // of the spacing before it: so much its corner allows alone
enum {
    LOOKED_AT = 4,       // of so many small blocks one
    GROWTH_STEPS = 40,   // from 1 µm to beyond any spacing
    BISECT_STEPS = 3     // the last 25 % to 3 %
};

// How sharply the path turns at a corner.
typedef struct turn {
    double by[NCK_AXIS_MAX]; // Δu
    double size;             // |Δu|
    int axes;                // of Δu
} turn_t;

// The corner at a block's end, while its spacing is chosen.
typedef struct vertex {
    turn_t bend;    // of the path there
    double aim;     // how far the spline may leave it [mm]
    double alone;   // spacing that it allows if nothing else bounds it [path mm]
    double nearest; // spacing that the blocks beside it allow [path mm]
    double room;    // spacing that the corners beside it allow, if it is alone [path mm]
    int lines;      // 1: between two lines
    int lone;       // 1: nothing but itself bounds its spacing
    int grown;      // 1: the largest spacing is known to be …
    double range[2]; // … between the good one and the bad one here [path mm]
} vertex_t;

// How far the spline may leave the corner between two blocks, before it is checked [mm].
static double aim_between(const nck_raw_t *raw, const nck_raw_t *next) {
    return NCK_CURVE_AIM * nck_min(raw->tolerance, next->tolerance);
}

// 1 if a block's end waits for more blocks, and what is found of it still counts.
static int is_waiting(const nck_smooth_t *self, uint32_t count) {
    const nck_looks_t *const looks = &self->run.looks;
    return looks->wait > 0.0 && looks->count == count && looks->tail == self->raw.tail;
}

// 1 if it does, and this spacing is good whatever comes.
static int knows_wait(const nck_smooth_t *self, uint32_t count, double spacing) {
    return self->run.looked.known && self->run.looks.wait == spacing && is_waiting(self, count);
}

// 1 if what an estimate looks at, of a spacing at a block's end at s, is known from now on.
static int is_settled(const nck_smooth_t *self, double s, double spacing) {
    return nck_estimate_is_known(self, s + spacing + spacing);
}

// What a line's speed can ask for; arcs are told apart by their curvature.
static double widest_on(const nck_smooth_t *self, const nck_raw_t *raw) {
    return raw->seg.kind == NCK_SEG_LINE ? raw->inside : self->spacing_max;
}

// From a good spacing on to the first one that is bad; or as far as any may be, twice.
// NCK_EMPTY if that depends on what is not known yet; NCK_FULL if it does and the ring is full.
static nck_status_t reach(nck_smooth_t *self, uint32_t count, double aim, int rough,
                          double range[2]) {
    const nck_raw_t *const raw = nck_raw_at(self, count);
    const double s = nck_raw_end(raw);
    const nck_raw_t *const behind = nck_raw_at(self, nck_raw_next(self, count));
    const double most = nck_min(widest_on(self, raw), widest_on(self, behind));
    const double known = self->run.closed ? s + most : nck_raw_known(self);
    range[1] = range[0];
    for (int n = 0; n < GROWTH_STEPS && range[0] < most; n++) {
        const double next = nck_min(range[0] * GROWTH, most);
        if (s + next > known) return nck_raw_is_full(self) ? NCK_FULL : NCK_EMPTY;
        range[1] = next;
        if (!(nck_estimate_plain(self, count, next, rough) <= aim)) return NCK_OK;
        const int follows = !rough && knows_wait(self, count, range[0]);
        if (follows && is_settled(self, s, next)) self->run.looks.wait = next;
        range[0] = next;
    }
    return NCK_OK;
}

// The largest spacing at a block's end, from a good one on, before the deviation first exceeds the
// aim. NCK_EMPTY as above; NCK_FULL: what is known must do for now.
static nck_status_t grow(nck_smooth_t *self, uint32_t count, vertex_t *corner, int rough,
                         double *spacing) {
    const double aim = corner->aim;
    double range[2] = {*spacing, corner->range[1]};
    const nck_status_t status =
        corner->grown ? NCK_OK : reach(self, count, aim, rough, range);
    corner->grown = 0;
    *spacing = range[0];
    if (status != NCK_OK) return status;
    for (int n = 0; n < BISECT_STEPS && range[1] > range[0]; n++) {
        const double middle = 0.5 * (range[0] + range[1]);
        range[nck_estimate_plain(self, count, middle, rough) <= aim ? 0 : 1] = middle;
    }
    *spacing = rough ? range[0] : nck_estimate_shrink(self, count, aim, range[0]);
    return NCK_OK;
}

// 1 if a block's end is known to wait for more blocks: what was good there still is, and whether a
// wider spacing is depends on them. Else what it has found so is in corner->range, if it is grown.
static int waits(nck_smooth_t *self, uint32_t count, vertex_t *corner) {
    nck_looks_t *const looks = &self->run.looks;
    const nck_raw_t *const raw = nck_raw_at(self, count);
    corner->grown = 0;
    corner->range[0] = looks->wait;
    corner->range[1] = looks->wait;
    if (raw->lacks || !is_waiting(self, count)) return 0;
    const nck_raw_t *const next = nck_raw_at(self, nck_raw_next(self, count));
    const double aim = aim_between(raw, next);
    if (!self->run.looked.known) {
        if (!(nck_estimate_plain(self, count, looks->wait, 0) <= aim)) return 0;
        self->run.looked.known = (uint8_t)is_settled(self, nck_raw_end(raw), looks->wait);
    }
    const nck_status_t status = reach(self, count, aim, 0, corner->range);
    corner->grown = status == NCK_OK;
    return status == NCK_EMPTY;
}

// The spacing that a corner between two blocks allows if it is alone; and how it turns.
static double lone_spacing(const nck_smooth_t *self, const nck_raw_t *raw, const nck_raw_t *next,
                           turn_t *turn) {
    const double aim = aim_between(raw, next);
    turn->axes = self->terms->axes;
    turn->size = nck_raw_turn(&raw->seg, &next->seg, turn->axes, turn->by);
    if (!(turn->size > 0.0)) return self->spacing_max;
    return nck_min(self->spacing_max, nck_spline_vertex_spacing(aim, turn->size));
}

// How much of the blocks on either side a lone corner may use: half where another one follows.
static nck_status_t room_beside(nck_smooth_t *self, uint32_t count, double *room_out) {
    const nck_raw_t *const raw = nck_raw_at(self, count);
    const uint32_t after = nck_raw_next(self, count);
    const nck_raw_t *const next = nck_raw_at(self, after);
    const uint32_t third = nck_raw_next(self, after);
    double behind = raw->seg.length;
    double before = next->seg.length;
    if (third == self->run.end && !self->run.closed && !nck_raw_is_full(self)) return NCK_EMPTY;
    const uint32_t first = nck_raw_before(self, count);
    if (first != count && nck_raw_at(self, first)->key) behind *= 0.5;
    turn_t turn;
    if (third != self->run.end
        && lone_spacing(self, next, nck_raw_at(self, third), &turn) < before) {
        before *= 0.5;
    }
    *room_out = nck_min(behind, before);
    return NCK_OK;
}

// 1 if a corner turns as another one does: about as much, and the same way.
static int turns_alike(const turn_t *turn, const nck_seg_t *in, const nck_seg_t *out) {
    double other[NCK_AXIS_MAX];
    const double size = nck_raw_turn(in, out, turn->axes, other);
    return nck_spline_is_alike(turn->by, turn->size, other, size, turn->axes);
}

// 1 if a corner is one of many that make a bend: the one before or behind it turns alike. Such a
// corner stands for the curve that was cut into chords, and the curve's own bend is what counts.
static int bends_on(nck_smooth_t *self, uint32_t count, const vertex_t *corner) {
    const uint32_t after = nck_raw_next(self, count);
    const uint32_t third = nck_raw_next(self, after);
    const nck_seg_t *const in = &nck_raw_at(self, count)->seg;
    const nck_seg_t *const out = &nck_raw_at(self, after)->seg;
    const turn_t *const turn = &corner->bend;
    const double chord = CHORD * corner->alone;
    const uint32_t before = nck_raw_before(self, count);
    if (before != count && in->length < chord
        && turns_alike(turn, &nck_raw_at(self, before)->seg, in)) {
        return 1;
    }
    return third != self->run.end && out->length < chord
           && turns_alike(turn, out, &nck_raw_at(self, third)->seg);
}

// 1 if the corner before this one has a knot of its own, and is next to this one: they are one.
static int is_crowded(nck_smooth_t *self, uint32_t count, double spacing) {
    const uint32_t before = nck_raw_before(self, count);
    return before != count && nck_raw_at(self, before)->key
           && nck_raw_at(self, count)->seg.length < CROWDED * spacing;
}

// A spacing beside a block that is `far` off and has such a share of the tolerance.
static double stay_within(double spacing, double far, double share) {
    return share < SAME ? nck_min(spacing, nck_max(0.5 * far, share * spacing)) : spacing;
}

// Where the tolerance changes: a spacing h bends the path over 2h on either side, so it must not
// reach into blocks with a smaller tolerance, unless it keeps to that as well.
static double keep_off(nck_smooth_t *self, uint32_t count, double spacing) {
    const double own = nck_min(nck_raw_at(self, count)->tolerance,
                               nck_raw_at(self, nck_raw_next(self, count))->tolerance);
    double least = spacing;
    double far = nck_raw_at(self, count)->seg.length;
    uint32_t at = count;
    while (nck_raw_before(self, at) != at && far < 2.0 * least) {
        at = nck_raw_before(self, at);
        const nck_raw_t *const raw = nck_raw_at(self, at);
        if (!raw->smooth) break;
        least = stay_within(least, far, raw->tolerance / own);
        far += raw->seg.length;
    }
    at = nck_raw_next(self, count);
    far = nck_raw_at(self, at)->seg.length;
    while ((at = nck_raw_next(self, at)) != self->run.end && far < 2.0 * least) {
        least = stay_within(least, far, nck_raw_at(self, at)->tolerance / own);
        far += nck_raw_at(self, at)->seg.length;
    }
    return least;
}

static void look_at(nck_smooth_t *self, uint32_t count, vertex_t *corner) {
    const nck_raw_t *const raw = nck_raw_at(self, count);
    const nck_raw_t *const next = nck_raw_at(self, nck_raw_next(self, count));
    corner->aim = aim_between(raw, next);
    corner->alone = lone_spacing(self, raw, next, &corner->bend);
    corner->nearest = nck_min(nck_min(raw->seg.length, next->seg.length),
                             nck_min(raw->inside, next->inside));
    corner->room = corner->nearest;
    corner->lines = raw->seg.kind == NCK_SEG_LINE && next->seg.kind == NCK_SEG_LINE;
    corner->lone = 0;
}

// Neighbours on a dense path are much alike: begin to grow not far below the one before. If it has
// to wait, then for blocks further off than what has led here: a lone corner may yet be one of a
// bend.
static double begin_growing(nck_smooth_t *self, uint32_t count, const vertex_t *corner,
                            double spacing) {
    const nck_raw_t *const raw = nck_raw_at(self, count);
    const double s = nck_raw_end(raw);
    const double likely = NEIGHBOUR * nck_raw_at(self, nck_raw_before(self, count))->spacing;
    nck_looks_t *const looks = &self->run.looks;
    if (corner->grown) return corner->range[0];
    if (likely <= spacing || s + likely > nck_raw_known(self)) return spacing;
    if (!(nck_estimate_plain(self, count, likely, 0) <= corner->aim)) return spacing;
    const nck_raw_t *const next = nck_raw_at(self, nck_raw_next(self, count));
    const int stays = spacing < corner->alone
                      && nck_estimate_is_known(self, next->s + next->seg.length);
    looks->wait = stays ? likely : 0.0;
    self->run.looked.known = (uint8_t)is_settled(self, s, likely);
    return likely;
}

// Bends of a curve grow with the square of the spacing at which it is looked at, those of noise
// stay as they are.
static nck_status_t grow_as_curve_or_noise(nck_smooth_t *self, uint32_t count, vertex_t *corner,
                                           double *spacing) {
    nck_raw_t *const raw = nck_raw_at(self, count);
    const nck_status_t status = grow(self, count, corner, 0, spacing);
    if (status == NCK_EMPTY) return status;
    const int was_rough = nck_raw_at(self, nck_raw_before(self, count))->rough;
    const double fine = nck_estimate_unevenness(self, count, 0.5 * *spacing, NCK_UNLIMITED);
    const double most = (was_rough ? STAYS_ROUGH : GETS_ROUGH) * fine;
    raw->rough = nck_estimate_unevenness(self, count, *spacing, most) < most;
    return raw->rough ? grow(self, count, corner, 1, spacing) : status;
}

// 1 if a block is a small part of what the spacing before it spans, and as blunt: then its spacing
// is the same. One block of four is looked at all the same.
static int is_like_before(nck_smooth_t *self, uint32_t count, const vertex_t *corner) {
    const uint32_t before = nck_raw_before(self, count);
    const nck_raw_t *const last = nck_raw_at(self, before);
    const nck_seg_t *const seg = &nck_raw_at(self, count)->seg;
    if (before == count || seg->block % LOOKED_AT == 0 || last->lacks || last->key) return 0;
    return seg->length < SMALL * last->spacing
           && corner->alone > BLUNT * last->spacing;
}

// The spacing at a corner, before other corners and tolerances have their say; and whether the
// corner is alone. NCK_EMPTY if more blocks must be known, NCK_FULL if the full ring ends the view.
static nck_status_t choose(nck_smooth_t *self, uint32_t count, vertex_t *corner,
                           double *spacing_out) {
    const nck_raw_t *const raw = nck_raw_at(self, count);
    const int bounded = corner->alone < self->spacing_max;
    nck_status_t status = NCK_OK;
    *spacing_out = raw->lacks ? raw->spacing : nck_min(corner->alone, corner->nearest);
    corner->lone = corner->lines && *spacing_out == corner->alone && bounded;
    if (corner->lone) status = room_beside(self, count, &corner->room);
    if (status == NCK_EMPTY) return status;
    corner->lone = corner->lone && !bends_on(self, count, corner);
    if (is_like_before(self, count, corner)) {
        const nck_raw_t *const last = nck_raw_at(self, nck_raw_before(self, count));
        *spacing_out = last->spacing;
        nck_raw_at(self, count)->rough = last->rough;
    } else if (corner->lines && !bounded) {
        *spacing_out = corner->alone; // other corners bound the way
    } else if (!corner->lone) {
        *spacing_out = begin_growing(self, count, corner, *spacing_out);
        status = grow_as_curve_or_noise(self, count, corner, spacing_out);
    }
    return status;
}

// 1 if next to nothing but the corner turns the path within a spacing of it.
static int is_alone(nck_smooth_t *self, uint32_t count, const turn_t *turn, double spacing) {
    const nck_raw_t *const raw = nck_raw_at(self, count);
    double p[3][NCK_AXIS_MAX];
    double others[NCK_AXIS_MAX];
    nck_raw_spread(self, nck_raw_end(raw) - spacing, spacing, 3, p);
    for (int x = 0; x < turn->axes; x++) {
        others[x] = turn->by[x] - nck_spline_bend(p[0][x], p[1][x], p[2][x]) / spacing;
    }
    return nck_spline_norm(others, turn->axes) <= OTHERS * turn->size;
}

// 1 if the corner turns as much as its spacing allows. Beside the rest that a run begins at a knot
// of its own would be narrow.
static int is_sharp(nck_smooth_t *self, uint32_t count, const vertex_t *corner, double spacing) {
    const nck_raw_t *const raw = nck_raw_at(self, count);
    return spacing >= KEY_LEAST * corner->alone && spacing <= KEY_MOST * corner->alone
           && corner->alone < self->spacing_max && spacing <= nck_raw_end(raw)
           && !bends_on(self, count, corner);
}

// A lone corner's spacing on a line: with a lift it bends two of them on either side. Two corners
// that are alike share a knot in the line's middle, or leave a gap that is no steep one.
static double fit_line(double wide, double length) {
    if (wide * (2.0 + NO_GAP) >= length) return nck_min(wide, 0.5 * length);
    return nck_min(wide, FEW_GAPS * length);
}

// The spacing of a lone corner without a lift, which allows so much.
static double plain_spacing(const vertex_t *corner, double narrow) {
    const double spacing = nck_min(narrow, corner->nearest);
    return spacing < corner->nearest ? nck_min(spacing, corner->room) : spacing;
}

// With a lift, if that is more. It makes six pieces of a corner for four: a short window sees less
// then.
static double widen(nck_smooth_t *self, uint32_t count, double narrow, double plain) {
    if (NCK_WINDOW < NCK_CURVE_WINDOW) return plain;
    const double in = nck_raw_at(self, count)->seg.length;
    const double out = nck_raw_at(self, nck_raw_next(self, count))->seg.length;
    const nck_raw_t *const raw = nck_raw_at(self, count);
    const nck_raw_t *const next = nck_raw_at(self, nck_raw_next(self, count));
    const double wide = nck_min(nck_min(raw->inside, next->inside),
                                NCK_SPLINE_WIDE * (NCK_SPLINE_WIDE_SHARE / AIM_KEY) * narrow);
    return nck_max(plain, fit_line(fit_line(wide, nck_min(in, out)), nck_max(in, out)));
}

// Whether a corner is a key, or shares its bend with the next or the one before; then it has the
// spacing of both.
static void choose_knots(nck_smooth_t *self, uint32_t count, const vertex_t *corner, int lifted,
                         double *spacing) {
    nck_raw_t *const raw = nck_raw_at(self, count);
    const nck_raw_t *const before = nck_raw_at(self, nck_raw_before(self, count));
    const int is_second = before->key == NCK_KEY_PAIR;
    const double aim = corner->aim * (AIM_KEY / NCK_CURVE_AIM);
    raw->key = is_second ? NCK_KEY_SECOND : NCK_KEY_NONE;
    if (is_second) {
        *spacing = before->spacing;
        return;
    }
    const int sharp = is_sharp(self, count, corner, *spacing);
    if (corner->lone || (sharp && is_alone(self, count, &corner->bend, *spacing))) {
        if (is_crowded(self, count, *spacing)) return;
        raw->key = corner->lone && lifted ? NCK_KEY_LIFTED : NCK_KEY_ON_PATH;
    } else if (sharp && nck_pair_find(self, count, aim, spacing)) {
        raw->key = NCK_KEY_PAIR;
    }
}

// The spacing at a corner, and whether it is a key. NCK_EMPTY if more blocks must be known.
static nck_status_t find_at_corner(nck_smooth_t *self, uint32_t count, vertex_t *corner,
                                   double *spacing_out) {
    nck_raw_t *const raw = nck_raw_at(self, count);
    const nck_status_t status = choose(self, count, corner, spacing_out);
    if (status == NCK_EMPTY) return status;
    raw->lacks = status == NCK_FULL ? NCK_LACKS_BLOCKS : NCK_LACKS_NOTHING;
    double plain = *spacing_out;
    if (corner->lone) {
        const double narrow = plain * (AIM_KEY / NCK_CURVE_AIM);
        plain = plain_spacing(corner, narrow);
        *spacing_out = widen(self, count, narrow, plain);
    }
    choose_knots(self, count, corner, *spacing_out > plain, spacing_out);
    return NCK_OK;
}

// As nck_spacing_know, but for the stop.
static nck_status_t find(nck_smooth_t *self, uint32_t count, vertex_t *corner_out) {
    nck_raw_t *const raw = nck_raw_at(self, count);
    nck_raw_t *const next = nck_raw_at(self, nck_raw_next(self, count));
    look_at(self, count, corner_out);
    double spacing = nck_curve_step(self, count, corner_out->aim, corner_out->alone);
    if (spacing > 0.0) {
        raw->lacks = NCK_LACKS_NOTHING;
        raw->key = NCK_KEY_STEP;
        raw->inside = nck_curve_along(self, raw);
        next->inside = nck_curve_along(self, next);
    } else {
        if (raw->seg.kind != NCK_SEG_LINE) {
            raw->inside = nck_curve_inside(self, &raw->seg, raw->tolerance);
        }
        const nck_status_t status = find_at_corner(self, count, corner_out, &spacing);
        if (status == NCK_EMPTY) return status;
    }
    raw->spacing = self->mixed ? keep_off(self, count, spacing) : spacing;
    return NCK_OK;
}

// Every point of an arc takes a sine and a cosine, and two corners are looked at together: then the
// stop is timed in the next call.
nck_status_t nck_spacing_know(nck_smooth_t *self, uint32_t count) {
    nck_raw_t *const raw = nck_raw_at(self, count);
    vertex_t corner;
    if (waits(self, count, &corner)) return NCK_EMPTY;
    if (raw->lacks != NCK_LACKS_TIME) {
        const nck_status_t status = find(self, count, &corner);
        if (status != NCK_OK || raw->lacks || !(corner.alone < self->spacing_max)) return status;
        if (raw->key == NCK_KEY_STEP) return NCK_OK;   // next to no corner
        if (raw->key == NCK_KEY_SECOND) return NCK_OK; // the first has chosen for both
        if (!corner.lines || raw->key == NCK_KEY_PAIR) {
            raw->lacks = NCK_LACKS_TIME;
            return NCK_FULL;
        }
    }
    raw->lacks = NCK_LACKS_NOTHING;
    nck_estimate_forget(self); // the corner may be moved
    nck_meet_choose(self, count);
    return NCK_OK;
}
