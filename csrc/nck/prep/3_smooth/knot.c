// SPDX-License-Identifier: MIT
// Inside room 3: where the knots go. As far apart as the tolerance allows; one on each sharp
// corner, with even spacing on either side of it.
#include "nck/prep/3_smooth/knot.h"

#include <string.h> // memmove memset

#include "nck/base/path_math.h"            // nck_path_second
#include "nck/base/real.h"                 // nck_min nck_max
#include "nck/prep/3_smooth/blend.h"       // NCK_BLEND_KEEP_OFF
#include "nck/prep/3_smooth/choice.h"      // nck_choice_stop
#include "nck/prep/3_smooth/raw.h"         // nck_raw_…
#include "nck/prep/3_smooth/spline_math.h" // nck_spline_…

// Shares of the tolerance: what a spacing is chosen for before it is checked, in general and on a
// lone corner, where nothing is left to chance; and what the end of the run may take that could
// follow, so that something is left for the knot that follows instead.
#define AIM 0.7
#define AIM_KEY 0.96
#define AIM_END 0.98
#define GROWTH 1.25      // between two spacings that are looked at for a block's end
#define STEP_GROWTH 1.1  // from one knot interval to the next, where the path is not straight
#define NEIGHBOUR 0.7    // of a spacing: where to begin to look for the next one
#define KEY_LEAST 0.5    // a corner is a key if the spacing that it allows alone is right within …
#define KEY_MOST 1.5     // … these shares, and it is none of a bend
#define ALIKE 0.9         // cosine between the turns of two corners of one bend
#define STRAIGHT 0.1     // |Δu| up to which a path goes on straight, for the time of a stop
#define CROWDED 0.25     // of a spacing: keys that are nearer than that are one
#define SAME 0.9         // tolerances of blocks that differ by no more count as one
#define SURE 0.5         // of √(P/κ): from rest a step on one block that certainly fits
#define NEVER 1e300      // [path mm] no place of a run
enum {
    WAYS = 16,           // blocks on either side that go on straight, at most
    GROWTH_STEPS = 64,   // from 1 µm to beyond any spacing
    BISECT_STEPS = 3,    // the last 25 % to 3 %
    TRIES = 11,          // spacings that are checked before the path has to rest
    TRIES_WANTED = 5,    // of them as parts of the step wanted
    TRIES_CAREFUL = 9    // of them with AIM_END
};

// What the way ahead of t[4] asks for.
typedef struct way {
    double step;  // spacing, as all that is not a goal allows
    double goal;  // place of the next corner, of an output or of the run's end, within two steps
    double half;  // spacing wanted on either side of the goal; 0: any
    uint8_t is_key;   // 1: the goal is a corner
    uint8_t straight; // 1: one line leads to the goal
} way_t;

// 1 if the spline begins at t[4], at rest.
static int is_fresh(const nck_smooth_t *self) { return !(self->run.t[0] < self->run.t[4]); }

static int is_full(const nck_smooth_t *self) {
    return self->raw.head - self->raw.tail == NCK_SMOOTH_SPAN;
}

// How far a spline of even spacing h would leave the path at a knot at s.
static double deviation(nck_smooth_t *self, double s, double h) {
    double before[NCK_AXIS_MAX];
    double here[NCK_AXIS_MAX];
    double behind[NCK_AXIS_MAX];
    double middle[NCK_AXIS_MAX];
    nck_raw_point(self, s - h, before);
    nck_raw_point(self, s, here);
    nck_raw_point(self, s + h, behind);
    for (int x = 0; x < NCK_AXIS_MAX; x++) middle[x] = 0.5 * (before[x] + behind[x]);
    return nck_spline_distance(middle, here) / 3.0;
}

// The largest spacing at s, from a good one on, before the deviation first exceeds the aim.
// NCK_EMPTY if that depends on what is not known yet; NCK_FULL if it does and the ring is full:
// then what is known must do for now.
static nck_status_t grow(nck_smooth_t *self, double s, double aim, double *spacing) {
    const double known = self->run.closed ? s + self->spacing_max : nck_raw_known(self);
    double good = *spacing;
    double bad = good;
    for (int n = 0; n < GROWTH_STEPS && bad == good && good < self->spacing_max; n++) {
        const double next = nck_min(good * GROWTH, self->spacing_max);
        if (s + next > known) {
            *spacing = good;
            return is_full(self) ? NCK_FULL : NCK_EMPTY;
        }
        if (deviation(self, s, next) <= aim) {
            good = next;
            bad = good;
        } else {
            bad = next;
        }
    }
    for (int n = 0; n < BISECT_STEPS && bad > good; n++) {
        const double middle = 0.5 * (good + bad);
        if (deviation(self, s, middle) <= aim) good = middle;
        else bad = middle;
    }
    *spacing = good;
    return NCK_OK;
}

// The block with length before this one; this one if it is not known any more.
static uint32_t raw_before(nck_smooth_t *self, uint32_t count) {
    uint32_t before = count;
    do {
        if (before == self->raw.tail) return count;
    } while (!nck_raw_at(self, --before)->has_seg);
    return before;
}

// Neighbours on a dense path are much alike: begin to grow not far below the one before.
static double begin_growing(nck_smooth_t *self, uint32_t count, double aim, double spacing) {
    const nck_raw_t *const raw = nck_raw_at(self, count);
    const double s = raw->s + raw->seg.length;
    const double likely = NEIGHBOUR * nck_raw_at(self, raw_before(self, count))->spacing;
    if (likely <= spacing || s + likely > nck_raw_known(self)) return spacing;
    return deviation(self, s, likely) <= aim ? likely : spacing;
}

// The spacing that a corner between two blocks allows if it is alone.
static double lone_spacing(const nck_smooth_t *self, const nck_raw_t *raw, const nck_raw_t *next) {
    const double aim = AIM * nck_min(raw->tolerance, next->tolerance);
    double by[NCK_AXIS_MAX];
    const double turn = nck_raw_turn(&raw->seg, &next->seg, by);
    if (!(turn > 0.0)) return self->spacing_max;
    return nck_min(self->spacing_max, nck_spline_vertex_spacing(aim, turn));
}

// How much of the blocks on either side a lone corner may use: half where another one follows.
static nck_status_t room_beside(nck_smooth_t *self, uint32_t count, double *room_out) {
    const nck_raw_t *const raw = nck_raw_at(self, count);
    const uint32_t after = nck_raw_next(self, count);
    const nck_raw_t *const next = nck_raw_at(self, after);
    const uint32_t third = nck_raw_next(self, after);
    double behind = raw->seg.length;
    double before = next->seg.length;
    if (third == self->run.end && !self->run.closed && !is_full(self)) return NCK_EMPTY;
    const uint32_t first = raw_before(self, count);
    if (first != count && nck_raw_at(self, first)->key) behind *= 0.5;
    if (third != self->run.end && lone_spacing(self, next, nck_raw_at(self, third)) < before) {
        before *= 0.5;
    }
    *room_out = nck_min(behind, before);
    return NCK_OK;
}

// 1 if the block behind this one is the run's last and leads into a blend: the spline must be
// straight again there.
static int ends_in_blend(nck_smooth_t *self, uint32_t count) {
    const uint32_t last = nck_raw_next(self, count);
    if (!self->run.closed || nck_raw_next(self, last) != self->run.end) return 0;
    return self->run.end != self->raw.head && nck_raw_at(self, self->run.end)->seg.blend;
}

// 1 if a corner turns as another one does: about as much, and the same way.
static int turns_alike(const double *turn, double size, const nck_seg_t *in,
                       const nck_seg_t *out) {
    double other[NCK_AXIS_MAX];
    const double other_size = nck_raw_turn(in, out, other);
    double along = 0.0;
    for (int x = 0; x < NCK_AXIS_MAX; x++) along += turn[x] * other[x];
    return other_size < 2.0 * size && size < 2.0 * other_size
           && along > ALIKE * size * other_size;
}

// 1 if a corner is one of many that make a bend: the one before or behind it turns alike. Such a
// corner stands for the curve that was cut into chords, and the curve's own bend is what counts.
static int bends_on(nck_smooth_t *self, uint32_t count) {
    const uint32_t after = nck_raw_next(self, count);
    const uint32_t third = nck_raw_next(self, after);
    const nck_seg_t *const in = &nck_raw_at(self, count)->seg;
    const nck_seg_t *const out = &nck_raw_at(self, after)->seg;
    double turn[NCK_AXIS_MAX];
    const double size = nck_raw_turn(in, out, turn);
    uint32_t before = count;
    while (before != self->raw.tail && !nck_raw_at(self, before - 1)->has_seg) before--;
    if (before != self->raw.tail
        && turns_alike(turn, size, &nck_raw_at(self, before - 1)->seg, in)) {
        return 1;
    }
    return third != self->run.end && turns_alike(turn, size, out, &nck_raw_at(self, third)->seg);
}

// 1 if the corner before this one has a knot of its own, and is next to this one: they are one.
static int is_crowded(nck_smooth_t *self, uint32_t count, double spacing) {
    const uint32_t before = raw_before(self, count);
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
    while (raw_before(self, at) != at && far < 2.0 * least) {
        at = raw_before(self, at);
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

// The run at the front ends at rest behind the block at count, and a run of its own begins there.
static void stop_behind(nck_smooth_t *self, uint32_t count) {
    double s = 0.0;
    nck_raw_at(self, count)->seg.stop = 1;
    for (uint32_t k = count + 1; k != self->run.end; k++) {
        nck_raw_t *const raw = nck_raw_at(self, k);
        raw->s = s; // added up as in smooth.c, so that an output is at its block's end to the bit
        if (raw->has_seg) s = raw->s + raw->seg.length;
    }
    self->run.end = count + 1;
    self->run.closed = 1;
}

// 1 if the path goes on as good as straight from one block to the next.
static int goes_on(nck_smooth_t *self, uint32_t in, uint32_t out) {
    double turn[NCK_AXIS_MAX];
    return nck_raw_turn(&nck_raw_at(self, in)->seg, &nck_raw_at(self, out)->seg, turn) < STRAIGHT;
}

// How far the path leads straight to the corner behind a block, and on from it.
static void measure_ways(nck_smooth_t *self, uint32_t count, nck_meet_t *meet) {
    uint32_t at = count;
    uint32_t other = raw_before(self, at);
    for (int n = 0; n < WAYS && other != at && nck_raw_at(self, other)->smooth; n++) {
        if (nck_raw_at(self, other)->seg.stop || !goes_on(self, other, at)) break;
        at = other;
        other = raw_before(self, at);
    }
    const nck_raw_t *const first = nck_raw_at(self, at);
    meet->length[0] = meet->a->s + meet->a->seg.length - first->s;
    meet->rests[0] = !(first->s > 0.0) && !(first->cut > 0.0);
    at = nck_raw_next(self, count);
    other = nck_raw_next(self, at);
    for (int n = 0; n < WAYS && other != self->run.end && goes_on(self, at, other); n++) {
        at = other;
        other = nck_raw_next(self, at);
    }
    const nck_raw_t *const last = nck_raw_at(self, at);
    meet->length[1] = last->s + last->seg.length - meet->b->s;
    meet->rests[1] = self->run.closed && other == self->run.end;
}

// Stop at a corner if that is faster than what the spline makes of it: a bend as wide as its
// spacing, or as the run's ends leave it. A blunt corner is bent, unless a run's end is near.
static void stop_or_bend(nck_smooth_t *self, uint32_t count, int is_sharp) {
    const nck_raw_t *const raw = nck_raw_at(self, count);
    const double s = raw->s + raw->seg.length;
    nck_bend_t bend = {nck_min(raw->spacing, s), {0.0}};
    nck_meet_t meet = {raw, nck_raw_at(self, nck_raw_next(self, count)), {0.0, 0.0}, {0, 0}};
    double before[NCK_AXIS_MAX];
    double here[NCK_AXIS_MAX];
    if (self->run.closed) bend.d = nck_min(bend.d, nck_raw_known(self) - s);
    if (!is_sharp && bend.d >= 0.5 * raw->spacing) return;
    nck_raw_point(self, s - bend.d, before);
    nck_raw_point(self, s, here);
    nck_raw_point(self, s + bend.d, bend.turn);
    for (int x = 0; x < NCK_AXIS_MAX; x++) {
        bend.turn[x] = (before[x] - 2.0 * here[x] + bend.turn[x]) / bend.d;
    }
    measure_ways(self, count, &meet);
    if (nck_choice_stop(self, &meet, &bend)) stop_behind(self, count);
}

// Find the spacing that the end of a block allows, once.
static nck_status_t know_spacing(nck_smooth_t *self, uint32_t count) {
    nck_raw_t *const raw = nck_raw_at(self, count);
    const nck_raw_t *const next = nck_raw_at(self, nck_raw_next(self, count));
    if (raw->spacing > 0.0 && !raw->partial) return NCK_OK;
    const double aim = AIM * nck_min(raw->tolerance, next->tolerance);
    const double alone = lone_spacing(self, raw, next);
    const double nearest = nck_min(nck_min(raw->seg.length, next->seg.length),
                                   nck_min(raw->inside, next->inside));
    const int lines = raw->seg.kind == NCK_SEG_LINE && next->seg.kind == NCK_SEG_LINE;
    double spacing = raw->partial ? raw->spacing : nck_min(alone, nearest);
    double room = nearest;
    int lone = lines && spacing == alone && alone < self->spacing_max;
    nck_status_t status = lone ? room_beside(self, count, &room) : NCK_OK;
    if (status == NCK_EMPTY) return status;
    lone = lone && !bends_on(self, count);
    if (!lone) {
        spacing = begin_growing(self, count, aim, spacing);
        status = grow(self, raw->s + raw->seg.length, aim, &spacing);
    }
    if (status == NCK_EMPTY) return status;
    raw->partial = status == NCK_FULL;
    if (lone) spacing = nck_min(spacing * (AIM_KEY / AIM), nearest);
    if (lone && spacing < nearest) spacing = nck_min(spacing, room);
    const int likely = spacing >= KEY_LEAST * alone && spacing <= KEY_MOST * alone
                       && alone < self->spacing_max;
    raw->key = (lone || (likely && !bends_on(self, count))) && !is_crowded(self, count, spacing);
    if (ends_in_blend(self, count)) {
        spacing = nck_min(spacing, next->seg.length / NCK_BLEND_KEEP_OFF);
    }
    raw->spacing = self->mixed ? keep_off(self, count, spacing) : spacing;
    const int is_sharp = alone < nck_spline_vertex_spacing(aim, NCK_CHOICE_SHARP);
    if (!raw->partial && alone < self->spacing_max) stop_or_bend(self, count, is_sharp);
    return NCK_OK;
}

// The end of the known path, in place of a corner.
static nck_status_t look_at_end(nck_smooth_t *self, double end, way_t *way) {
    if (self->run.closed) {
        way->goal = end;
        way->half = 0.0;
        return NCK_OK;
    }
    if (!is_full(self)) return NCK_EMPTY;
    way->step = nck_min(way->step, 0.5 * (end - self->run.t[4]));
    return NCK_OK;
}

// The largest step that does not grow too fast; any on a line.
static double largest_step(nck_smooth_t *self, const nck_raw_t *raw) {
    const double here = self->run.t[4];
    const double most = STEP_GROWTH * (here - self->run.t[3]);
    const int is_line =
        raw->seg.kind == NCK_SEG_LINE && raw->s + raw->seg.length >= here + most;
    return most > 0.0 && !is_line ? most : self->spacing_max;
}

// Look ahead from t[4]. A spacing at distance d may be half of d smaller: steps may halve.
static nck_status_t look_ahead(nck_smooth_t *self, way_t *way) {
    const double here = self->run.t[4];
    const double growth = is_fresh(self) ? 0.0 : 0.5; // from rest on: even spacings
    uint32_t count = nck_raw_find(self, here);
    uint32_t next = count;
    way->step = largest_step(self, nck_raw_at(self, count));
    way->goal = here + 4.0 * self->spacing_max;
    way->half = 0.0;
    way->is_key = 0;
    way->straight = 0;
    for (;; count = next) {
        const nck_raw_t *const raw = nck_raw_at(self, count);
        const double far = nck_max(0.0, raw->s - here);
        if (far > 2.0 * way->step) return NCK_OK;
        way->step = nck_min(way->step, raw->inside + 0.5 * far);
        const double end = raw->s + raw->seg.length;
        next = nck_raw_next(self, count);
        if (next == self->run.end) {
            way->straight = far == 0.0 && raw->seg.kind == NCK_SEG_LINE;
            return look_at_end(self, end, way);
        }
        if (!(end > here)) continue;
        const nck_status_t status = know_spacing(self, count);
        if (status != NCK_OK) return status;
        if (raw->seg.stop) return look_at_end(self, end, way);
        if (raw->key) {
            way->goal = end;
            way->half = raw->spacing;
            way->is_key = 1;
            way->straight = far == 0.0 && raw->seg.kind == NCK_SEG_LINE;
            return NCK_OK;
        }
        way->step = nck_min(way->step, raw->spacing + growth * (end - here));
        if (nck_raw_at(self, next - 1)->has_output) {
            way->goal = end;
            return NCK_OK;
        }
    }
}

// From the knot of a corner on: as far as before it, so that the control point stays on the corner.
// What is too short for both corners' spacings is shared: half for each that wants more.
static double step_from_key(const nck_smooth_t *self, const way_t *way, double ahead) {
    const double even = self->run.t[4] - self->run.t[3];
    const double step = even > 0.0 ? nck_min(even, way->step) : way->step;
    if (ahead >= step + way->half) return step;
    if (ahead <= step && (ahead <= way->half || !way->is_key)) return ahead;
    return nck_min(step, nck_max(0.5 * ahead, ahead - way->half));
}

// The step from t[4] on that is wanted.
static double wanted_step(const nck_smooth_t *self, const way_t *way) {
    const double ahead = way->goal - self->run.t[4];
    if (self->run.on_key) return step_from_key(self, way, ahead);
    const double gap = ahead - way->half;
    if (gap <= 0.01 * way->half) return ahead;
    if (way->straight) return gap;
    if (gap < 0.5 * way->half) return 0.5 * ahead;
    if (gap <= way->step) return gap;
    return nck_min(way->step, nck_max(0.5 * gap, 0.5 * way->step));
}

// Behind a blend the path is on the move: there the first three control points must lie on its
// line, so that the spline begins without curvature.
static double straight_step(const nck_smooth_t *self) {
    const double *const t = self->run.t;
    if (!(self->run.straight > 0.0) || t[3] > 0.0) return 2.0 * self->spacing_max;
    return t[4] > 0.0 ? nck_max(0.0, 3.0 * self->run.straight - 2.0 * t[4]) : self->run.straight;
}

// Try the knot t[5]: the next seg, and the two behind it if the run had to end there.
static int try_knot(nck_smooth_t *self, double t, double share) {
    double *const knot = self->run.t;
    self->run.tries++;
    for (int i = 5; i < 8; i++) {
        knot[i] = t;
        nck_raw_point(self, nck_spline_greville(knot + i - 2), self->run.c[i - 2]);
    }
    return nck_raw_fits(self, 0, 1.0) && nck_raw_fits(self, 1, share)
           && nck_raw_fits(self, 2, share);
}

// No knot beside the end of a block, nearer than rounding can tell.
static double snap(nck_smooth_t *self, double t) {
    const double least = nck_raw_least(t);
    const nck_raw_t *const raw = nck_raw_at(self, nck_raw_find(self, t - least));
    const double end = raw->s + raw->seg.length;
    return nck_fabs(end - t) <= least ? end : t;
}

// From rest a knot that fits whatever comes behind it: no further than the block, the rest of which
// is its own spline if it is a line; an arc's spline leaves it by less than κh²/12.
static double sure_knot(nck_smooth_t *self, double here) {
    const uint32_t count = nck_raw_find(self, here + nck_raw_least(here));
    const nck_raw_t *const raw = nck_raw_at(self, count);
    const double end = raw->s + raw->seg.length;
    double second[NCK_AXIS_MAX];
    nck_path_second(&raw->seg, 0.0, second);
    const double kappa = nck_spline_norm(second);
    if (!(kappa > 0.0)) return end;
    const double t = here + SURE * nck_sqrt(raw->tolerance / kappa);
    return t < end - nck_raw_least(end) ? t : end;
}

double nck_knot_spacing_inside(const nck_smooth_t *self, const nck_seg_t *seg, double tolerance) {
    double second[NCK_AXIS_MAX];
    nck_path_second(seg, 0.0, second);
    const double kappa = nck_spline_norm(second);
    if (!(kappa > 0.0)) return self->spacing_max;
    return nck_min(self->spacing_max, nck_spline_curve_spacing(AIM * tolerance, kappa));
}

// The n-th step to try: parts of the one wanted, then of the one before, which fitted.
static double shorter_step(const nck_smooth_t *self, double step, int n) {
    static const double of_wanted[TRIES_WANTED] = {1.0, 0.9, 0.8, 0.65, 0.45};
    static const double of_last[TRIES - TRIES_WANTED] = {1.0, 0.6, 0.3, 0.1, 0.03, 0.01};
    const double last = self->run.t[4] - self->run.t[3];
    if (n < TRIES_WANTED) return of_wanted[n] * step;
    return of_last[n - TRIES_WANTED] * (last > 0.0 ? nck_min(last, 0.3 * step) : 0.3 * step);
}

// Nothing that is wanted fits.
static void take_what_fits(nck_smooth_t *self) {
    const double here = self->run.t[4];
    self->run.on_key = 0;
    if (is_fresh(self)) {
        (void)try_knot(self, sure_knot(self, here), 1.0);
        return;
    }
    (void)try_knot(self, here, 1.0); // fits since the knot before was chosen
    self->run.rest = here;
    self->run.kinks++;
}

nck_status_t nck_knot_choose(nck_smooth_t *self) {
    const double here = self->run.t[4];
    way_t way = {0.0, 0.0, 0.0, 0, 0};
    if (here >= self->run.rest || (self->run.closed && here >= nck_raw_known(self))) {
        (void)try_knot(self, here, 1.0); // the end: fits since the knot before was chosen
        return NCK_OK;
    }
    const nck_status_t status = look_ahead(self, &way);
    if (status != NCK_OK) return status;
    const double step = nck_min(wanted_step(self, &way), straight_step(self));
    const int reaches = here + step >= way.goal || step == way.goal - here;
    for (int n = 0; n < TRIES; n++) {
        const int at_goal = n == 0 && reaches;
        const double t = at_goal ? way.goal : snap(self, here + shorter_step(self, step, n));
        if (t - here < nck_raw_least(t)) break;
        if (!try_knot(self, t, n < TRIES_CAREFUL ? AIM_END : 1.0)) continue;
        self->run.on_key = at_goal && way.is_key;
        return NCK_OK;
    }
    take_what_fits(self);
    return NCK_OK;
}

static void begin_at(nck_smooth_t *self, double s, const double *point) {
    for (int i = 0; i < 8; i++) self->run.t[i] = s;
    for (int i = 0; i < 6; i++) memcpy(self->run.c[i], point, sizeof self->run.c[i]);
    memcpy(self->run.position, point, sizeof self->run.position);
    self->run.given = s;
    self->run.rest = NEVER;
    self->run.on_key = 0;
    self->run.chosen = 0;
}

void nck_knot_begin(nck_smooth_t *self) {
    const nck_raw_t *const front = nck_raw_at(self, self->raw.tail);
    self->run.straight = front->cut > 0.0 ? front->seg.length : 0.0;
    begin_at(self, 0.0, front->seg.start);
}

void nck_knot_advance(nck_smooth_t *self) {
    double here[NCK_AXIS_MAX];
    memmove(self->run.t, self->run.t + 1, 7 * sizeof *self->run.t);
    memmove(self->run.c, self->run.c + 1, 5 * sizeof *self->run.c);
    self->run.given = self->run.t[2];
    self->run.chosen = 0;
    if (self->run.t[2] < self->run.rest) return;
    memcpy(here, self->run.position, sizeof here);
    self->run.straight = 0.0;
    begin_at(self, self->run.rest, here);
}

int nck_knot_rests(nck_smooth_t *self, double s) {
    if (s >= self->run.rest) return 1;
    const uint32_t last = self->run.end - 1;
    return self->run.closed && s >= nck_raw_known(self) && nck_raw_at(self, last)->seg.stop;
}
