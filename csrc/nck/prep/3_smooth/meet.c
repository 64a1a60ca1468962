// SPDX-License-Identifier: MIT
// Inside room 3: what a corner between two blocks becomes where the spline comes by: a bend, its
// control point on the path or off it, or a stop.
#include "nck/prep/3_smooth/meet.h"

#include "nck/base/real.h"                 // nck_min
#include "nck/prep/3_smooth/choice.h"      // nck_choice_…
#include "nck/prep/3_smooth/estimate.h"    // nck_estimate_off
#include "nck/prep/3_smooth/raw.h"         // nck_raw_…
#include "nck/prep/3_smooth/spline_math.h" // nck_spline_…

#define STRAIGHT 0.1     // |Δu| up to which a path goes on straight, for the time of a stop
#define AT_REST 0.02     // of a way: a rest so near to its end is there, for the time of a stop
enum { WAYS = 16 };      // blocks on either side that go on straight, at most

double nck_meet_lift(nck_smooth_t *self, uint32_t count, double h, double weight) {
    const nck_raw_t *const raw = nck_raw_at(self, count);
    const nck_raw_t *const next = nck_raw_at(self, nck_raw_next(self, count));
    double by[NCK_AXIS_MAX];
    const double turn = nck_raw_turn(&raw->seg, &next->seg, self->terms->axes, by);
    if (!(turn > 0.0) || !(h > 0.0)) return 0.0;
    const double aim = NCK_SPLINE_WIDE_SHARE * nck_min(raw->tolerance, next->tolerance);
    return nck_spline_lift(aim, turn, h, weight);
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

// 1 if the path goes on as good as straight from one block to the next. Every corner in reach asks.
static int goes_on(nck_smooth_t *self, uint32_t in, uint32_t out) {
    nck_raw_t *const next = nck_raw_at(self, out);
    if (next->onward == NCK_ONWARD_UNKNOWN) {
        double turn[NCK_AXIS_MAX];
        const nck_seg_t *const seg = &nck_raw_at(self, in)->seg;
        const int goes = nck_raw_turn(seg, &next->seg, self->terms->axes, turn) < STRAIGHT;
        next->onward = (uint8_t)(goes ? NCK_ONWARD_STRAIGHT : NCK_ONWARD_BENT);
    }
    return next->onward == NCK_ONWARD_STRAIGHT;
}

// How far the path leads straight to the corner behind a block, and on from it.
static void measure_ways(nck_smooth_t *self, uint32_t count, nck_meet_t *meet) {
    uint32_t at = count;
    uint32_t other = nck_raw_before(self, at);
    for (int n = 0; n < WAYS && other != at && nck_raw_at(self, other)->smooth; n++) {
        if (nck_raw_at(self, other)->seg.stop || !goes_on(self, other, at)) break;
        at = other;
        other = nck_raw_before(self, at);
        meet->tolerance = nck_min(meet->tolerance, nck_raw_at(self, at)->tolerance);
    }
    const nck_raw_t *const first = nck_raw_at(self, at);
    meet->length[0] = meet->a->s + meet->a->seg.length - first->s;
    meet->rests[0] = first->s <= AT_REST * meet->length[0];
    at = nck_raw_next(self, count);
    other = nck_raw_next(self, at);
    for (int n = 0; n < WAYS && other != self->run.end && goes_on(self, at, other); n++) {
        at = other;
        other = nck_raw_next(self, at);
        meet->tolerance = nck_min(meet->tolerance, nck_raw_at(self, at)->tolerance);
    }
    const nck_raw_t *const last = nck_raw_at(self, at);
    meet->length[1] = last->s + last->seg.length - meet->b->s;
    const double behind = nck_raw_known(self) - (last->s + last->seg.length);
    meet->rests[1] = self->run.closed && behind <= AT_REST * meet->length[1];
}

// The bend of two corners: from the first one back to where it begins. Its |p‴| is that of one of
// the two inner control points.
static void bend_of_pair(nck_smooth_t *self, const nck_meet_t *meet, nck_bend_t *bend) {
    const double h = meet->a->spacing;
    double p[3][NCK_AXIS_MAX];
    nck_raw_spread(self, meet->b->s + 0.5 * meet->b->seg.length - 1.5 * h, h, 3, p);
    bend->d = 1.5 * h - 0.5 * meet->b->seg.length;
    const double share = bend->d * bend->d / (h * h * h);
    for (int x = 0; x < self->terms->axes; x++) {
        bend->turn[x] = share * nck_spline_bend(p[0][x], p[1][x], p[2][x]);
    }
    bend->lift = 0.0;
}

// The bend that a spacing makes of the corner at a block's end, as the run's ends leave it.
static void bend_of(nck_smooth_t *self, uint32_t count, double spacing, nck_bend_t *bend) {
    const nck_raw_t *const raw = nck_raw_at(self, count);
    const double s = raw->s + raw->seg.length;
    double p[2][NCK_AXIS_MAX];
    bend->d = nck_min(spacing, s);
    if (self->run.closed) bend->d = nck_min(bend->d, nck_raw_known(self) - s);
    const double places[2] = {s - bend->d, s + bend->d};
    uint32_t at[2] = {nck_estimate_off(self, -4), nck_estimate_off(self, 4)};
    nck_raw_points(self, count, places, 2, p, at);
    for (int x = 0; x < self->terms->axes; x++) {
        bend->turn[x] = nck_spline_bend(p[0][x], raw->seg.end[x], p[1][x]) / bend->d;
    }
    const int lifted = raw->key == NCK_KEY_LIFTED;
    bend->lift = lifted ? nck_meet_lift(self, count, bend->d, NCK_SPLINE_WEIGHT) : 0.0;
}

// A corner with a lift goes without, if that is faster. Then it stops, if that is.
void nck_meet_choose(nck_smooth_t *self, uint32_t count) {
    nck_raw_t *const raw = nck_raw_at(self, count);
    nck_raw_t *const next = nck_raw_at(self, nck_raw_next(self, count));
    const double tolerance = nck_min(raw->tolerance, next->tolerance);
    nck_meet_t meet = {raw, next, {0.0, 0.0}, tolerance, {0, 0}};
    nck_bend_t bend;
    if (raw->key == NCK_KEY_PAIR) bend_of_pair(self, &meet, &bend);
    else bend_of(self, count, raw->spacing, &bend);
    if (raw->key != NCK_KEY_LIFTED && !nck_choice_may_stop(self, &meet, &bend)) return;
    measure_ways(self, count, &meet);
    if (raw->key == NCK_KEY_LIFTED) {
        const double turn = nck_spline_norm(bend.turn, self->terms->axes);
        const double narrow = nck_spline_vertex_spacing(NCK_SPLINE_WIDE_SHARE * tolerance, turn);
        nck_bend_t plain;
        bend_of(self, count, narrow, &plain);
        if (!nck_choice_wide(self, &meet, &bend, &plain)) {
            raw->key = NCK_KEY_ON_PATH;
            raw->spacing = plain.d;
            bend = plain;
        }
    }
    if (!nck_choice_stop(self, &meet, &bend)) return;
    if (raw->key == NCK_KEY_PAIR) raw->key = NCK_KEY_NONE; // the next one is alone
    stop_behind(self, count);
}
