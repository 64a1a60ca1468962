// SPDX-License-Identifier: MIT
// Inside room 3: where the knots go. As far apart as the tolerance allows; one on each sharp
// corner, with even spacing on either side of it.
#include "nck/prep/3_smooth/knot.h"

#include <stddef.h> // NULL
#include <string.h> // memcpy

#include "nck/base/real.h"                 // nck_min nck_max
#include "nck/prep/3_smooth/control.h"     // nck_control_…
#include "nck/prep/3_smooth/curve.h"       // nck_curve_inside
#include "nck/prep/3_smooth/raw.h"         // nck_raw_…
#include "nck/prep/3_smooth/spacing.h"     // nck_spacing_know

// A knot is taken only if the spline could also end there. The first tries allow that end this
// share of the tolerance. The rest is left to the knot that will follow instead.
#define AIM_END 0.98
// The knots next to a key's stand so many of its spacings further off at least.
#define GAP_LEAST 0.4
#define STEP_GROWTH 1.1  // from one knot interval to the next, where the path is not straight
#define NEAR_OUTPUT 0.65 // of a step: an output so far off draws a knot
#define SURE 0.5         // of √(P/κ): from rest a step on one block that certainly fits
#define NEVER 1e300      // [path mm] no place of a run
enum {
    TRIES = 11,          // spacings that are checked before the path has to rest
    TRIES_WANTED = 5,    // of them as parts of the step wanted
    TRIES_CAREFUL = 9,   // of them with AIM_END
    PIECES = 3           // of the spline that a knot makes
};

// What the way ahead of t[4] asks for.
typedef struct passage {
    double step;  // spacing, as all that is not a goal allows
    double goal;  // place of the next corner or of the run's end, within two steps
    double half;  // spacing wanted on either side of the goal; 0: any
    double growth;    // of a step with the distance, for what lies ahead: from rest on none
    uint8_t sure;     // 1: no spacing so far may still grow
    uint8_t key;      // whose own knot the goal is: nck_key_t
    uint8_t straight; // 1: one line leads to the goal
} passage_t;

// 1 if the spline begins at t[4], at rest.
static int is_fresh(const nck_smooth_t *self) { return !(self->run.t[0] < self->run.t[4]); }

// The end of the known path, in place of a corner.
static nck_status_t look_at_end(nck_smooth_t *self, const nck_raw_t *raw, passage_t *way) {
    const double end = raw->s + raw->seg.length;
    if (self->run.closed) {
        way->goal = end;
        way->half = 0.0;
        const int is_line = raw->seg.kind == NCK_SEG_LINE;
        const double inside = is_line ? self->spacing_max
                                      : nck_curve_inside(self, &raw->seg, raw->tolerance);
        way->step = nck_min(way->step, inside + 0.5 * (end - self->run.t[4]));
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

// What the end of a block allows: known, or found now. NCK_FULL: one has been found in this call.
static nck_status_t find_spacing(nck_smooth_t *self, uint32_t count, int *found) {
    const nck_raw_t *const raw = nck_raw_at(self, count);
    if (nck_spacing_is_known(raw)) return NCK_OK;
    if (*found) return NCK_FULL;
    const nck_status_t status = nck_spacing_know(self, count);
    *found = nck_spacing_is_known(raw);
    return status;
}

// Where to look ahead from: t[4], or the block where the last call had to leave off.
static uint32_t begin_look(nck_smooth_t *self, passage_t *way) {
    const nck_trial_t *const trial = &self->run.trial;
    const uint32_t count = trial->looks ? trial->count : nck_raw_find(self, self->run.t[4]);
    way->step = trial->looks ? trial->step : largest_step(self, nck_raw_at(self, count));
    way->goal = self->run.t[4] + 4.0 * self->spacing_max;
    way->growth = is_fresh(self) ? 0.0 : 0.5;
    way->sure = 1;
    return count;
}

// If what comes next must be known first, the next call looks on from the block at count. The first
// one may still become longer.
static void keep_place(nck_smooth_t *self, uint32_t count, double step) {
    nck_trial_t *const trial = &self->run.trial;
    trial->looks = nck_raw_at(self, count)->s > self->run.t[4];
    trial->count = count;
    trial->step = step;
}

// Two corners that share their bend want even knots, h apart, about the middle between them: two
// inner ones with control points on the path, h/2 to either side. 1: one of them is the goal.
static int look_at_pair(nck_smooth_t *self, uint32_t count, passage_t *way) {
    const nck_raw_t *const raw = nck_raw_at(self, count);
    const double h = raw->spacing;
    const double between = nck_raw_at(self, nck_raw_next(self, count))->seg.length;
    const double first = raw->s + raw->seg.length + 0.5 * (between - h);
    const int is_inside = self->run.on_key == NCK_KEY_PAIR;
    if (!is_inside && first < self->run.t[4] + 0.5 * h) return 0;
    way->goal = is_inside ? self->run.t[4] + h : first;
    way->half = h;
    way->key = NCK_KEY_PAIR;
    return 1;
}

// What a block's end with a known spacing asks for. 1: it is the goal.
static int look_at_corner(nck_smooth_t *self, uint32_t count, passage_t *way) {
    const nck_raw_t *const raw = nck_raw_at(self, count);
    const double here = self->run.t[4];
    const double end = raw->s + raw->seg.length;
    if (raw->key == NCK_KEY_PAIR && look_at_pair(self, count, way)) return 1;
    if (raw->key && raw->key < NCK_KEY_PAIR) {
        way->goal = end;
        way->half = raw->spacing;
        way->key = raw->key;
        way->straight = raw->s <= here && raw->seg.kind == NCK_SEG_LINE;
        return 1;
    }
    way->sure &= (uint8_t)nck_spacing_is_known(raw);
    way->step = nck_min(way->step, raw->spacing + way->growth * (end - here));
    return 0;
}

// The step that a block allows from here on: its spacing, and half of the distance to it on top;
// along a line, half of the distance from its begin.
static double step_inside(const nck_raw_t *raw, double here) {
    const double from = raw->s - here;
    const double far = raw->seg.kind == NCK_SEG_LINE ? nck_fabs(from) : nck_max(0.0, from);
    return raw->inside + 0.5 * far;
}

// Look ahead from t[4]. A spacing at distance d may be half of d smaller: steps may halve.
static nck_status_t look_ahead(nck_smooth_t *self, passage_t *way) {
    const double here = self->run.t[4];
    uint32_t count = begin_look(self, way);
    int found = 0;
    for (;;) {
        const nck_raw_t *const raw = nck_raw_at(self, count);
        const double far = nck_max(0.0, raw->s - here);
        if (far > 2.0 * way->step) return NCK_OK;
        if (way->sure) keep_place(self, count, way->step);
        way->step = nck_min(way->step, step_inside(raw, here));
        const uint32_t next = nck_raw_next(self, count);
        if (next == self->run.end) {
            way->straight = far == 0.0 && raw->seg.kind == NCK_SEG_LINE;
            return look_at_end(self, raw, way);
        }
        if (raw->s + raw->seg.length > here) {
            const nck_status_t status = find_spacing(self, count, &found);
            if (status != NCK_OK) return status;
            if (raw->seg.stop) return look_at_end(self, raw, way);
            if (look_at_corner(self, count, way)) return NCK_OK;
        }
        count = next;
    }
}

// From the knot of a corner on: as far as before it, so that the control point stays on the corner.
// What is too short for both corners' spacings is shared: half for each that wants more.
static double step_from_key(const nck_smooth_t *self, const passage_t *way, double ahead) {
    const double even = self->run.t[4] - self->run.t[3];
    const double step = even > 0.0 ? nck_min(even, way->step) : way->step;
    if (ahead >= step + way->half) return step;
    if (ahead <= step && (ahead <= way->half || !way->key)) return ahead;
    return nck_min(step, nck_max(0.5 * ahead, ahead - way->half));
}

// The knots next to those of a key bound what is bent beside it: they stand so many of its spacings
// further off at most, and where there is room, so many.
typedef struct gap {
    double most;
    double wide;
} gap_t;

// Even knots leave a step of the curvature least.
static const gap_t *gap_of(uint8_t key) {
    static const gap_t lifted = {2.0, 1.5};
    static const gap_t step = {1.25, 1.0};
    return key == NCK_KEY_LIFTED ? &lifted : key == NCK_KEY_STEP ? &step : NULL;
}

// Up to the knot before the goal, or one more before that.
static double gap_before(const passage_t *way, double gap) {
    const gap_t *const ahead = gap_of(way->key);
    if (!ahead || gap <= ahead->most * way->half) return gap;
    const double middle = gap - ahead->wide * way->half;
    return middle < 0.5 * way->half ? 0.5 * gap : middle;
}

// Along a line up to the knot before the goal: in one step, or with knots that bound what a key
// bends.
static double straight_gap(const nck_smooth_t *self, const passage_t *way, double gap) {
    const gap_t *const behind = gap_of(self->run.past_key);
    const double past = behind ? self->run.t[4] - self->run.t[3] : 0.0;
    if (past > 0.0 && gap > behind->most * past) {
        const double rest = gap - behind->wide * past;
        return rest < GAP_LEAST * nck_max(past, way->half) ? 0.5 * gap : behind->wide * past;
    }
    return gap_before(way, gap);
}

// A step that no corner asks for ends at the last output near its end where the path goes straight
// on: a seg ends there anyhow.
static double step_to_output(nck_smooth_t *self, double step) {
    const double here = self->run.t[4];
    double last = step;
    uint32_t count = nck_raw_find(self, here + NEAR_OUTPUT * step);
    for (; count != self->run.end; count++) {
        const nck_raw_t *const raw = nck_raw_at(self, count);
        if (raw->s > here + step) break;
        if (!raw->has_output || raw->s < here + NEAR_OUTPUT * step) continue;
        const nck_raw_t *const before = nck_raw_at(self, nck_raw_before(self, count));
        if (!(before->spacing < self->spacing_max)) last = raw->s - here;
    }
    return last;
}

// The step from t[4] on that is wanted.
static double wanted_step(nck_smooth_t *self, const passage_t *way) {
    const double ahead = way->goal - self->run.t[4];
    if (self->run.on_key == NCK_KEY_PAIR && way->key == NCK_KEY_PAIR) return ahead;
    if (self->run.on_key) return step_from_key(self, way, ahead);
    const double gap = ahead - way->half;
    if (gap <= 0.01 * way->half) return ahead;
    if (way->key == NCK_KEY_LIFTED && gap < GAP_LEAST * way->half) return 0.5 * ahead;
    if (way->straight) return straight_gap(self, way, gap);
    if (gap < 0.5 * way->half) return 0.5 * ahead;
    const double next = way->key == NCK_KEY_STEP ? gap_before(way, gap) : gap;
    if (next <= way->step) return next;
    const double step = nck_min(way->step, nck_max(0.5 * next, 0.5 * way->step));
    return step_to_output(self, step);
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
    const double kappa = nck_raw_curvature(&raw->seg, self->terms->axes);
    if (!(kappa > 0.0)) return end;
    const double t = here + SURE * nck_sqrt(raw->tolerance / kappa);
    return t < end - nck_raw_least(end) ? t : end;
}

// The n-th step to try: parts of the one wanted, then of the one before, which fitted. No sliver is
// left before a key: its knots would be that near on both sides.
static double shorter_step(const nck_smooth_t *self, double step, int n) {
    static const double of_wanted[2][TRIES_WANTED] = {{1.0, 0.9, 0.8, 0.65, 0.45},
                                                      {1.0, 0.5, 0.4, 0.33, 0.25}};
    static const double of_last[TRIES - TRIES_WANTED] = {1.0, 0.6, 0.3, 0.1, 0.02, 0.002};
    const double last = self->run.t[4] - self->run.t[3];
    if (n < TRIES_WANTED) return of_wanted[self->run.trial.to_key ? 1 : 0][n] * step;
    return of_last[n - TRIES_WANTED] * (last > 0.0 ? nck_min(last, 0.3 * step) : 0.3 * step);
}

// Nothing that is wanted fits.
static void take_what_fits(nck_smooth_t *self) {
    const double here = self->run.t[4];
    self->run.on_key = 0;
    self->run.past_key = 0;
    self->run.rough = self->run.trial.was_rough;
    if (is_fresh(self)) {
        nck_control_place(self, sure_knot(self, here));
        return;
    }
    nck_control_place(self, here); // fits since the knot before was chosen
    self->run.rest = here;
    self->run.kinks++;
}

// The knot at the step of the trial.
static double next_try(nck_smooth_t *self) {
    const nck_trial_t *const trial = &self->run.trial;
    return snap(self, self->run.t[4] + shorter_step(self, trial->step, trial->n));
}

// Place the knot. 0: it would be no step.
static int begin_try(nck_smooth_t *self, double t) {
    nck_trial_t *const trial = &self->run.trial;
    if (t - self->run.t[4] < nck_raw_least(t)) return 0;
    self->run.tries++;
    trial->first = 0;
    self->run.rough = trial->n < TRIES_WANTED ? trial->rough : trial->was_rough;
    const int on_corner = trial->n < TRIES_WANTED && self->run.on_key != NCK_KEY_STEP;
    self->run.corner = on_corner ? self->run.on_key : NCK_KEY_NONE;
    nck_control_place(self, t);
    nck_raw_begin_fit(self, 0);
    return 1;
}

// Begin to try the steps on a way, from the one wanted down. 0: there is none.
static int begin_trial(nck_smooth_t *self, const passage_t *way) {
    nck_trial_t *const trial = &self->run.trial;
    const double here = self->run.t[4];
    trial->step = wanted_step(self, way);
    trial->n = 0;
    trial->was_rough = self->run.rough;
    trial->rough = nck_raw_at(self, nck_raw_find(self, here))->rough;
    const int reaches = here + trial->step >= way->goal || trial->step == way->goal - here;
    trial->to_key = reaches ? way->key : NCK_KEY_NONE;
    return begin_try(self, reaches ? way->goal : next_try(self));
}

// Compare a stretch of one of the pieces that the knot makes. NCK_DONE: all fit, NCK_E_STATE: this
// one does not.
static nck_status_t compare(nck_smooth_t *self) {
    nck_trial_t *const trial = &self->run.trial;
    const int careful = trial->first > 0 && trial->n < TRIES_CAREFUL;
    const nck_status_t status = nck_raw_fit(self, trial->first, careful ? AIM_END : 1.0);
    if (status != NCK_DONE) return status;
    trial->first++;
    if (trial->first == PIECES) return NCK_DONE;
    nck_raw_begin_fit(self, trial->first);
    return NCK_OK;
}

// The knot does not fit: on to a shorter step. 0: there is none.
static int try_shorter(nck_smooth_t *self) {
    nck_trial_t *const trial = &self->run.trial;
    trial->n++;
    return trial->n < TRIES && begin_try(self, next_try(self));
}

// Look for the way ahead. NCK_DONE: the knot needs no trial.
static nck_status_t begin_choice(nck_smooth_t *self) {
    const double here = self->run.t[4];
    passage_t way = {0.0, 0.0, 0.0, 0.0, 0, NCK_KEY_NONE, 0};
    // Outputs fill the ring behind its only seg: no more path comes before they are given.
    self->run.closed |= nck_raw_is_full(self) && self->raw.tail == nck_raw_last(self);
    if (here >= self->run.rest || (self->run.closed && here >= nck_raw_known(self))) {
        nck_control_place(self, here); // the end: fits since the knot before was chosen
        self->run.trial.looks = 0;
        return NCK_DONE;
    }
    const nck_status_t status = look_ahead(self, &way);
    if (status != NCK_OK) return status;
    self->run.trial.looks = 0;
    self->run.trial.on = (uint8_t)begin_trial(self, &way);
    if (self->run.trial.on) return NCK_OK;
    take_what_fits(self);
    return NCK_DONE;
}

// Compare the knot with the path, or go on to a shorter step: NCK_DONE if one is chosen.
static nck_status_t go_on(nck_smooth_t *self) {
    nck_trial_t *const trial = &self->run.trial;
    if (trial->fails) {
        trial->fails = 0;
        if (try_shorter(self)) return NCK_OK;
        take_what_fits(self);
        return NCK_DONE;
    }
    const nck_status_t status = compare(self);
    trial->fails = status == NCK_E_STATE;
    if (status == NCK_DONE) {
        self->run.past_key = gap_of(self->run.on_key) ? self->run.on_key : NCK_KEY_NONE;
        self->run.on_key = trial->n == 0 ? trial->to_key : NCK_KEY_NONE;
    }
    return trial->fails ? NCK_OK : status;
}

nck_status_t nck_knot_choose(nck_smooth_t *self) {
    if (!self->run.trial.on) {
        const nck_status_t status = begin_choice(self);
        if (status == NCK_DONE) return NCK_OK;
        return status == NCK_OK ? NCK_FULL : status;
    }
    if (go_on(self) != NCK_DONE) return NCK_FULL;
    self->run.trial.on = 0;
    return NCK_OK;
}

static void begin_at(nck_smooth_t *self, double s, const double *point) {
    nck_control_begin(self, s, point);
    memcpy(self->run.position, point, sizeof self->run.position);
    self->run.given = s;
    self->run.rest = NEVER;
    self->run.on_key = 0;
    self->run.past_key = 0;
    self->run.chosen = 0;
    self->run.trial.looks = 0;
}

void nck_knot_begin(nck_smooth_t *self) {
    const nck_raw_t *const front = nck_raw_at(self, self->raw.tail);
    self->run.rough = 0;
    begin_at(self, 0.0, front->seg.start);
}

void nck_knot_advance(nck_smooth_t *self) {
    double here[NCK_AXIS_MAX];
    nck_control_advance(self);
    self->run.given = self->run.t[2];
    self->run.chosen = 0;
    if (self->run.t[2] < self->run.rest) return;
    memcpy(here, self->run.position, sizeof here);
    begin_at(self, self->run.rest, here);
}

int nck_knot_rests(nck_smooth_t *self, double s) {
    if (s >= self->run.rest) return 1;
    const uint32_t last = self->run.end - 1;
    return self->run.closed && s >= nck_raw_known(self) && nck_raw_at(self, last)->seg.stop;
}
