// SPDX-License-Identifier: MIT
// Inside room 3: the control points of the spline. They lie off the path where it bends, by what
// the spline would leave it otherwise: so it passes the path on both sides.
#include "nck/prep/3_smooth/control.h"

#include <string.h> // memcpy memmove

#include "nck/base/real.h"                 // nck_min nck_max nck_sqrt
#include "nck/prep/3_smooth/meet.h"        // nck_meet_lift
#include "nck/prep/3_smooth/raw.h"         // nck_raw_…
#include "nck/prep/3_smooth/spline_math.h" // nck_spline_…

// Chords of a curve: of what a control point looks at they span this share at least; the curve
// bulges by this share of the tolerance out of them at least. Points on chords are 2/3 of the bulge
// inside of the curve on average; with a quarter of it added they are half of it from the chords'
// ends and half from their middles, so that the spline is nowhere further off than it need.
#define CHORD (1.0 / 3.0)
#define FLAT 0.1
#define BULGE 0.25
enum {
    SIDE = NCK_SPLINE_SIDE,
    POINTS = 2 * SIDE + 1
};

// Three knots, and what their control point takes of the path.
typedef struct span {
    double xi;     // its place [path mm]
    double h;      // how far it looks to either side [path mm]
    double excess; // of the moment over what h gives, 1 or more
} span_t;

// on_path: a corner's control point stays on it.
static span_t span_of(const double *t, int on_path) {
    span_t span = {nck_spline_greville(t), 0.0, 0.0};
    if (on_path || !(t[0] < t[2])) return span;
    const double moment = 3.0 * nck_spline_moment(t);
    const double within = nck_min(t[2] - span.xi, span.xi - t[0]);
    span.h = nck_min(nck_sqrt(moment), within);
    span.excess = moment / (span.h * span.h);
    return span;
}

// Travel is not left by a lift.
static double inside(const nck_smooth_t *self, int x, double on_path, double lifted) {
    const double least = nck_min(on_path, self->travel[0][x]);
    const double most = nck_max(on_path, self->travel[1][x]);
    return nck_max(least, nck_min(most, lifted));
}

// A corner's, lifted to its outside as its spacing needs.
static void set_corner(nck_smooth_t *self, const double *t, double *c) {
    const double h = nck_min(t[1] - t[0], t[2] - t[1]);
    double p[3][NCK_AXIS_MAX];
    nck_raw_spread(self, t[1] - h, h, 3, p);
    const double weight = nck_spline_vertex_weight(t - 1);
    const double lift = nck_meet_lift(self, nck_raw_find(self, t[1]), h, weight);
    nck_raw_point(self, nck_spline_greville(t), c);
    for (int x = 0; x < self->terms->axes; x++) {
        const double turn = nck_spline_bend(p[0][x], p[1][x], p[2][x]);
        c[x] = inside(self, x, c[x], c[x] - lift * turn);
    }
}

// How the curve bends that a chord was cut from: κ, towards its inside [1/mm]. It bulges by κL²/8
// out of the chord, κL = |Δu|. 0: it is no such chord, for the path does not turn alike at its two
// ends, or ends or has a knot of its own there; or the bulge is next to nothing.
static int curve_of(nck_smooth_t *self, uint32_t at, double *kappa_out) {
    const nck_raw_t *const raw = nck_raw_at(self, at);
    const uint32_t before = nck_raw_before(self, at);
    const uint32_t after = nck_raw_next(self, at);
    const int axes = self->terms->axes;
    double turn[2][NCK_AXIS_MAX];
    if (before == at || after == self->run.end) return 0;
    if (raw->key || nck_raw_at(self, before)->key) return 0;
    const nck_seg_t *const in = &nck_raw_at(self, before)->seg;
    const nck_seg_t *const out = &nck_raw_at(self, after)->seg;
    const double first = nck_raw_turn(in, &raw->seg, axes, turn[0]);
    if (0.125 * first * raw->seg.length < FLAT * raw->tolerance) return 0;
    const double last = nck_raw_turn(&raw->seg, out, axes, turn[1]);
    if (!nck_spline_is_alike(turn[0], first, turn[1], last, axes)) return 0;
    for (int x = 0; x < axes; x++) {
        kappa_out[x] = turn[0][x] / (in->length + raw->seg.length)
                       + turn[1][x] / (raw->seg.length + out->length);
    }
    return 1;
}

// 1 if all that a control point looks at is one block: a straight piece stays one.
static int is_within(const nck_raw_t *raw, const span_t *span) {
    const double least = nck_raw_least(span->xi + span->h);
    return raw->s <= span->xi - span->h + least
           && raw->s + raw->seg.length >= span->xi + span->h - least;
}

// Points of the path, and off its chords towards the curve that they were cut from: a spline of
// points on chords would pass their ends far on the curve's inside. Returns the path's own point in
// the middle.
static void spread(nck_smooth_t *self, const span_t *span, double (*p)[NCK_AXIS_MAX],
                   double *middle_out) {
    const double step = span->h / (double)SIDE;
    double places[POINTS];
    double kappa[NCK_AXIS_MAX];
    uint32_t blocks[POINTS] = {0};
    uint32_t last = self->run.end;
    int bends = 0;
    for (int k = 0; k < POINTS; k++) places[k] = span->xi - span->h + step * (double)k;
    const uint32_t near = nck_raw_find(self, places[0]);
    nck_raw_points(self, near, places, POINTS, p, blocks);
    memcpy(middle_out, p[SIDE], sizeof p[SIDE]);
    if (is_within(nck_raw_at(self, near + blocks[SIDE]), span)) return;
    for (int k = 0; k < POINTS; k++) {
        const uint32_t at = near + blocks[k];
        const nck_raw_t *const raw = nck_raw_at(self, at);
        const double done = places[k] - raw->s;
        const double left = raw->seg.length - done;
        const int is_chord = raw->seg.kind == NCK_SEG_LINE && raw->seg.length >= CHORD * span->h;
        if (!is_chord || !(done > 0.0 && left > 0.0)) continue;
        if (at != last) bends = curve_of(self, at, kappa);
        last = at;
        for (int x = 0; bends && x < self->terms->axes; x++) {
            p[k][x] -= 0.5 * BULGE * done * left * kappa[x];
        }
    }
}

// On the path, or off it by its bends.
static void set_point(nck_smooth_t *self, const span_t *span, double *c) {
    double p[POINTS][NCK_AXIS_MAX];
    double on_path[NCK_AXIS_MAX];
    if (!(span->h > 0.0)) {
        nck_raw_point(self, span->xi, c);
        return;
    }
    spread(self, span, p, on_path);
    for (int x = 0; x < self->terms->axes; x++) {
        const double here = p[SIDE][x];
        double sum = 0.0;
        for (int k = 1; k <= SIDE; k++) {
            const double bend = nck_spline_bend(p[SIDE - k][x], here, p[SIDE + k][x]);
            sum += (self->run.rough ? NCK_SPLINE_MEAN : span->excess * nck_spline_weight(k)) * bend;
        }
        c[x] = inside(self, x, on_path[x], here + sum);
    }
}

void nck_control_begin(nck_smooth_t *self, double s, const double *point) {
    for (int i = 0; i < 8; i++) self->run.t[i] = s;
    for (int i = 0; i < 6; i++) {
        memcpy(self->run.c[i], point, sizeof self->run.c[i]);
        self->run.reach[i][0] = s;
        self->run.reach[i][1] = s;
    }
}

void nck_control_place(nck_smooth_t *self, double t) {
    double *const knot = self->run.t;
    const int corner = t > knot[4] ? self->run.corner : NCK_KEY_NONE;
    for (int i = 5; i < 8; i++) knot[i] = t;
    for (int i = 3; i < 6; i++) {
        const int key = i == 3 ? corner : NCK_KEY_NONE;
        const int lifted = key == NCK_KEY_LIFTED;
        const span_t span = span_of(knot + i, key != NCK_KEY_NONE);
        self->run.reach[i][0] = lifted ? knot[3] : span.xi - span.h;
        self->run.reach[i][1] = lifted ? knot[5] : span.xi + span.h;
        if (lifted) set_corner(self, knot + i, self->run.c[i]);
        else set_point(self, &span, self->run.c[i]);
    }
}

void nck_control_advance(nck_smooth_t *self) {
    memmove(self->run.t, self->run.t + 1, 7 * sizeof *self->run.t);
    memmove(self->run.c, self->run.c + 1, 5 * sizeof *self->run.c);
    memmove(self->run.reach, self->run.reach + 1, 5 * sizeof *self->run.reach);
}
