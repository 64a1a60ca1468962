// SPDX-License-Identifier: MIT
// Inside room 3: where the knots go. As far apart as the tolerance allows; one on each sharp
// corner, with even spacing on either side of it.
#include "nck/prep/3_smooth/knot.h"

#include <string.h> // memmove memset

#include "nck/base/path.h"                 // nck_path_second
#include "nck/base/real.h"                 // nck_min nck_max
#include "nck/prep/3_smooth/raw.h"         // nck_raw_…
#include "nck/prep/3_smooth/spacing.h"     // nck_spacing_know
#include "nck/prep/3_smooth/spline_math.h" // nck_spline_…

// A knot is taken only if the spline could also end there. The first tries allow that end this
// share of the tolerance. The rest is left to the knot that will follow instead.
#define AIM_END 0.98
#define STEP_GROWTH 1.1  // from one knot interval to the next, where the path is not straight
#define SURE 0.5         // of √(P/κ): from rest a step on one block that certainly fits
#define NEVER 1e300      // [path mm] no place of a run
enum {
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

// The end of the known path, in place of a corner.
static nck_status_t look_at_end(nck_smooth_t *self, double end, way_t *way) {
    if (self->run.closed) {
        way->goal = end;
        way->half = 0.0;
        return NCK_OK;
    }
    if (!nck_raw_is_full(self)) return NCK_EMPTY;
    way->straight = 0; // as far as is known, not as far as a line may go
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
        const nck_status_t status = nck_spacing_know(self, count);
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
    const double kappa = nck_spline_norm(second, self->terms->axes);
    if (!(kappa > 0.0)) return end;
    const double t = here + SURE * nck_sqrt(raw->tolerance / kappa);
    return t < end - nck_raw_least(end) ? t : end;
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

// Try the steps on a way, from the one wanted down. 1 if the knot at one of them fits.
static int take_step(nck_smooth_t *self, const way_t *way) {
    const double here = self->run.t[4];
    const double step = nck_min(wanted_step(self, way), straight_step(self));
    const int reaches = here + step >= way->goal || step == way->goal - here;
    for (int n = 0; n < TRIES; n++) {
        const int at_goal = n == 0 && reaches;
        const double t = at_goal ? way->goal : snap(self, here + shorter_step(self, step, n));
        if (t - here < nck_raw_least(t)) return 0;
        if (!try_knot(self, t, n < TRIES_CAREFUL ? AIM_END : 1.0)) continue;
        self->run.on_key = at_goal && way->is_key;
        return 1;
    }
    return 0;
}

nck_status_t nck_knot_choose(nck_smooth_t *self) {
    const double here = self->run.t[4];
    way_t way = {0.0, 0.0, 0.0, 0, 0};
    // Outputs fill the ring behind its only seg: no more path comes before they are given.
    self->run.closed |= nck_raw_is_full(self) && self->raw.tail == nck_raw_last(self);
    if (here >= self->run.rest || (self->run.closed && here >= nck_raw_known(self))) {
        (void)try_knot(self, here, 1.0); // the end: fits since the knot before was chosen
        return NCK_OK;
    }
    const nck_status_t status = look_ahead(self, &way);
    if (status != NCK_OK) return status;
    if (!take_step(self, &way)) take_what_fits(self);
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
