// SPDX-License-Identifier: MIT
// Inside room 3: the control points of the spline. They lie off the path where it bends, by what
// the spline would leave it otherwise: so it passes the path on both sides.
#include "nck/prep/3_smooth/control.h"

#include <string.h> // memcpy memmove

#include "nck/base/real.h"                 // nck_min nck_max nck_sqrt
#include "nck/prep/3_smooth/meet.h"        // nck_meet_lift
#include "nck/prep/3_smooth/raw.h"         // nck_raw_…
#include "nck/prep/3_smooth/spline_math.h" // nck_spline_…

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

// On the path, or off it by its bends.
static void set_point(nck_smooth_t *self, const span_t *span, double *c) {
    double p[POINTS][NCK_AXIS_MAX];
    if (!(span->h > 0.0)) {
        nck_raw_point(self, span->xi, c);
        return;
    }
    nck_raw_spread(self, span->xi - span->h, span->h / (double)SIDE, POINTS, p);
    for (int x = 0; x < self->terms->axes; x++) {
        const double here = p[SIDE][x];
        double sum = 0.0;
        for (int k = 1; k <= SIDE; k++) {
            const double bend = nck_spline_bend(p[SIDE - k][x], here, p[SIDE + k][x]);
            sum += (self->run.rough ? NCK_SPLINE_MEAN : span->excess * nck_spline_weight(k)) * bend;
        }
        c[x] = inside(self, x, here, here + sum);
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
