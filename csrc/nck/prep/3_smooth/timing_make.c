// SPDX-License-Identifier: MIT
// Inside room 3: the next clock, of what is kept of a plan and of the guess behind it. Slice by
// slice: each phase is a walk over places or quarters.
#include "nck/base/real.h"                 // nck_max nck_min
#include "nck/prep/3_smooth/timing.h"
#include "nck/prep/3_smooth/timing_math.h" // nck_timing_reach_speed …
#include "nck/prep/3_smooth/tuning.h" // NCK_TIMING_BLUR …

#define SLOW_MOST ((nck_num)1e-9) // [mm/s] of a cell that stands
#define SHORTEST (NCK_FAIR_WINDOW / 2) // knots of a window behind which the run goes on: where less
                     // is known than they last the clock goes slower
#define BEHIND 1     // knot behind the window, up to which s is found
#define LEAST 7      // knots of a window: three control points at both ends stay

// The next phase, from its begin.
static void go(nck_timing_t *self, nck_timing_phase_t phase) {
    self->phase = phase;
    self->at = 0;
}

// The end of a slice that begins where the walk is; `all`: of the walk.
static int slice_end(const nck_timing_t *self, int all) {
    return self->at + NCK_TIMING_SLICE < all ? self->at + NCK_TIMING_SLICE : all;
}

// ---- places

// Where a plan is kept the guess goes on as fast as that ends, and comes down to itself over some
// knots: a step would be a bend in the clock. Places are half a knot apart.
static nck_num raise_at(nck_timing_t *self, const nck_timing_list_t *list, nck_num v) {
    const nck_num way = (nck_num)(list->count - list->kept) / (nck_num)(2 * NCK_STREAM_BLEND);
    if (list->count == list->kept && list->kept > 0) {
        const nck_num ends = nck_num_min(list->at[list->kept - 1].v, NCK_TIMING_FASTEST * v);
        self->make.raise = v > 0 ? nck_num_max(ends / v - 1, 0) : 0;
    }
    if (list->kept == 0 || !(way < 1)) return v;
    return v + v * self->make.raise * (1 - way * way * (3 - 2 * way));
}

// The guess behind what is kept; where that is a rest, as slow as it leaves one.
static void add_guess(nck_timing_t *self, nck_timing_list_t *list, double end) {
    const double from = list->kept > 0 ? list->at[list->kept - 1].s + 1e-7 : -1.0;
    const int all = (int)(self->guess.head - self->guess.tail);
    const int to = slice_end(self, all);
    for (; self->at < to; self->at++) {
        nck_place_t place = *nck_timing_place(self, self->guess.tail + (uint32_t)self->at);
        if (place.s <= from) continue;
        place.v = raise_at(self, list, place.v);
        if (self->even) place.wide = 0;
        if (self->begins && list->count > 0) {
            const double way = place.s - list->at[0].s;
            place.v = nck_timing_near_rest(self->terms, way, place.v);
        }
        if (self->closed || self->brakes) {
            place.v = nck_timing_near_rest(self->terms, end - place.s, place.v);
        }
        list->at[list->count++] = place;
    }
    if (to == all) go(self, NCK_TIMING_FORWARD);
}

// The speed that is reached is carried from place to place: where it was read back from the list
// gcc 12 made vectors of floats of it at -O3, and each place saw the old speed of the one before.
static void pass_forward(nck_timing_t *self, nck_timing_list_t *list) {
    const int first = list->kept > 0 ? list->kept - 1 : 0;
    const int all = list->count - 1 - first;
    const int to = slice_end(self, all);
    nck_num v = list->at[first + self->at].v;
    for (; self->at < to; self->at++) {
        nck_place_t *const at = &list->at[first + self->at];
        const double way = at[1].s - at->s;
        v = nck_num_min(at[1].v, nck_timing_reach_speed(self->terms, NCK_TIMING_ASK, v, way));
        at[1].v = v;
    }
    if (to >= all) go(self, NCK_TIMING_BACKWARD);
}

// The walk goes from the last place but one to the second.
static void pass_backward(nck_timing_t *self, nck_timing_list_t *list) {
    const int all = list->count - 2;
    const int to = slice_end(self, all);
    nck_num v = list->at[all - self->at + 1].v;
    for (; self->at < to; self->at++) {
        const int k = all - self->at;
        nck_place_t *const at = &list->at[k];
        const nck_num wish = k >= list->kept ? NCK_TIMING_ASK : NCK_TIMING_KEEP_ASK;
        v = nck_num_min(at->v, nck_timing_reach_speed(self->terms, wish, v, at[1].s - at->s));
        at->v = v;
    }
    if (to >= all) {
        go(self, NCK_TIMING_CUT);
        self->make.all = 0.0;
    }
}

// The clock's speed at a place.
static nck_num rate_at(const nck_timing_t *self, const nck_place_t *at) {
    return nck_timing_rate(self->terms, at->v, at->wide);
}

// Both speeds of a cell, which does not last for ever.
static nck_num speeds_of(const nck_timing_t *self, const nck_place_t *at) {
    return nck_num_max(rate_at(self, at) + rate_at(self, at + 1), SLOW_MOST);
}

// How long it takes by the clock from a place to the next one, at even acceleration.
static nck_num time_of(const nck_timing_t *self, const nck_place_t *at) {
    return 2 * (nck_num)(at[1].s - at[0].s) / speeds_of(self, at);
}

// Where in such a cell it is at the share w of its time.
static double within(const nck_timing_t *self, const nck_place_t *at, nck_num w) {
    const nck_num begin = rate_at(self, at);
    const nck_num change = rate_at(self, at + 1) - begin;
    const nck_num way = (2 * begin + change * w) * w / speeds_of(self, at);
    if (!(way < 1)) return at[1].s;
    return at[0].s + (double)((nck_num)(at[1].s - at[0].s) * way);
}

// ---- s at even times

// The next cell, of a list whose time is stretched smoothly: t + more·w²(3 − 2w), w = t/all.
static void go_to(nck_timing_t *self, nck_num time) {
    const nck_num all = (nck_num)self->make.all;
    const nck_num w0 = nck_num_min(self->make.t / all, 1);
    self->make.t += time;
    self->make.cell = time;
    if (!(self->make.more > 0.0)) return;
    const nck_num w1 = nck_num_min(self->make.t / all, 1);
    const nck_num rise = 3 * (w0 + w1) - 2 * (w0 * w0 + w0 * w1 + w1 * w1);
    self->make.cell += (nck_num)self->make.more * (w1 - w0) * rise;
}

// Begin to find s at count + 1 times, `step` apart, of a list whose time is made.all and grows by
// `more`.
static void begin_sampling(nck_timing_t *self, const nck_timing_list_t *list, int count,
                           double step, double more) {
    self->make.count = count;
    self->make.step = step;
    self->make.more = more;
    self->make.place = 0;
    self->make.t = 0;
    self->make.past = 0;
    go_to(self, time_of(self, list->at));
}

// A slice of it; behind the list's end straight on. Returns 1 once all are found.
static int sample(nck_timing_t *self, const nck_timing_list_t *list) {
    const int last = list->count - 1;
    const int all = self->make.count + 1;
    const nck_num step = (nck_num)self->make.step;
    int work = NCK_TIMING_SLICE; // places passed count as quarters found do
    for (; self->at < all && work > 0; work--) {
        const nck_place_t *const at = &list->at[self->make.place];
        const nck_num late = self->make.past - self->make.cell;
        if (late > 0 && self->make.place + 1 < last) {
            self->make.place++;
            self->make.past = late;
            go_to(self, time_of(self, at + 1));
            continue;
        }
        const nck_place_t *const end_of = &list->at[last];
        self->s[self->at++] = late > 0 ? end_of->s + (double)(late * rate_at(self, end_of))
                                       : within(self, at, self->make.past / self->make.cell);
        self->make.past += step;
    }
    return self->at == all;
}

// ---- the means

// Cut the list behind the window, and begin to blur what is left.
static void cut(nck_timing_t *self, nck_timing_list_t *list) {
    const double most = self->terms->tau * (NCK_FAIR_WINDOW + NCK_TIMING_AHEAD);
    const double quarter = 0.25 * self->terms->tau;
    const int to = slice_end(self, list->count - 1);
    while (self->at < to && self->make.all < most) {
        self->make.all += (double)time_of(self, &list->at[self->at++]);
    }
    if (self->at == to && to < list->count - 1 && self->make.all < most) return;
    list->count = self->at + 1;
    self->make.last_v = rate_at(self, &list->at[self->at]);
    if (list->kept >= list->count) {
        list->kept = list->count;
        go(self, NCK_TIMING_SUM);
        return;
    }
    int count = (int)nck_min(self->make.all / quarter + 1.0, NCK_TIMING_CELLS);
    if (count < LEAST) count = LEAST; // from rest to rest something has to move between
    begin_sampling(self, list, count, nck_min(self->make.all / count, quarter), 0.0);
    go(self, NCK_TIMING_SAMPLE);
}

// Where the list has room for sums: behind what is kept.
static int kept_of(const nck_timing_list_t *list) { return list->kept > 0 ? list->kept : 1; }

// Sums of s before each quarter, for means.
static void add_up(nck_timing_t *self, nck_timing_list_t *list) {
    nck_place_t *const sum = &list->at[kept_of(list)];
    const int all = self->make.count + 1;
    const int to = slice_end(self, all);
    if (self->at == 0) sum[0].s = 0.0;
    for (; self->at < to; self->at++) sum[self->at + 1].s = sum[self->at].s + self->s[self->at];
    if (to == all) go(self, self->phase == NCK_TIMING_ADD_UP ? NCK_TIMING_MEAN
                                                             : NCK_TIMING_MEAN_AGAIN);
}

// A mean over up to 2 `half` + 1 quarters, less where it would pass the ends.
static void take_mean(nck_timing_t *self, nck_timing_list_t *list) {
    const nck_place_t *const sum = &list->at[kept_of(list)];
    const double blur = NCK_TIMING_BLUR * self->terms->tau;
    const double wide = 0.5 * blur / self->make.step + 0.5; // steps may be of next to no time
    const int half = wide < self->make.count ? (int)wide : self->make.count;
    const int all = self->make.count + 1;
    const int to = slice_end(self, all);
    const double per = 1.0 / (2 * half + 1);
    for (; self->at < to; self->at++) {
        const int k = self->at;
        const int end = k < self->make.count - k ? k : self->make.count - k;
        const int n = end < half ? end : half;
        self->s[k] = (sum[k + n + 1].s - sum[k - n].s) * (end < half ? 1.0 / (2 * end + 1) : per);
    }
    if (to < all) return;
    if (self->phase == NCK_TIMING_MEAN) {
        go(self, NCK_TIMING_ADD_UP_AGAIN);
        return;
    }
    go(self, NCK_TIMING_LIST_ANEW);
    list->count = kept_of(list);
}

// The list anew: behind what is kept, from the means.
static void list_anew(nck_timing_t *self, nck_timing_list_t *list) {
    const int all = self->make.count;
    const int to = slice_end(self, all);
    for (; self->at < to; self->at++) {
        const int k = self->at + 1;
        if (!(self->s[k] > list->at[list->count - 1].s + 1e-9)) continue;
        nck_place_t *const place = &list->at[list->count++];
        place->s = self->s[k];
        const nck_num steps = 2 * (nck_num)self->make.step;
        place->v = k < all ? (nck_num)(self->s[k + 1] - self->s[k - 1]) / steps
                           : self->make.last_v;
        place->wide = 0;
    }
    if (to == all) go(self, NCK_TIMING_SUM);
}

// ---- the window

// How many knots the window has, and begin to find s at its quarters.
static void set_window(nck_timing_t *self, const nck_timing_list_t *list, double end) {
    const double tau = self->terms->tau;
    const double all = self->make.all;
    const int is_whole = self->looked && list->at[list->count - 1].s >= end - 1e-9;
    double more = 0.0;
    self->ends = is_whole && all <= (NCK_FAIR_WINDOW + 2) * tau;
    if (self->ends) {
        const int knots = (int)(all / tau);
        self->knots = knots + (knots * tau < all);
        if (self->knots < LEAST) self->knots = LEAST;
        more = self->knots * tau - all;
    } else {
        self->knots = (int)nck_min(all / tau - BEHIND, NCK_FAIR_WINDOW);
        if (self->knots < SHORTEST) self->knots = SHORTEST;
        more = nck_max(0.0, (SHORTEST + BEHIND) * tau - all);
    }
    begin_sampling(self, list, 4 * (self->knots + BEHIND), 0.25 * tau, more);
    go(self, NCK_TIMING_SET);
}

// The list's time.
static void sum_up(nck_timing_t *self, const nck_timing_list_t *list, double end) {
    const int all = list->count - 1;
    const int to = slice_end(self, all);
    if (self->at == 0) self->make.all = 0.0;
    for (; self->at < to; self->at++) self->make.all += (double)time_of(self, &list->at[self->at]);
    if (to >= all) set_window(self, list, end);
}

// A slice of what rounds steps of acceleration.
static void round_steps(nck_timing_t *self, nck_timing_list_t *list) {
    switch (self->phase) {
    case NCK_TIMING_CUT: cut(self, list); break;
    case NCK_TIMING_SAMPLE:
        if (sample(self, list)) go(self, NCK_TIMING_ADD_UP);
        break;
    case NCK_TIMING_ADD_UP: case NCK_TIMING_ADD_UP_AGAIN: add_up(self, list); break;
    case NCK_TIMING_MEAN: case NCK_TIMING_MEAN_AGAIN: take_mean(self, list); break;
    default: list_anew(self, list); break;
    }
}

nck_status_t nck_timing_make(nck_timing_t *self, nck_timing_list_t *list,
                             const nck_track_t *track) {
    const double end = nck_track_known(track);
    switch (self->phase) {
    case NCK_TIMING_ADD: add_guess(self, list, end); break;
    case NCK_TIMING_FORWARD: pass_forward(self, list); break;
    case NCK_TIMING_BACKWARD: pass_backward(self, list); break;
    case NCK_TIMING_SUM: sum_up(self, list, end); break;
    case NCK_TIMING_SET: return sample(self, list) ? NCK_DONE : NCK_OK;
    default: round_steps(self, list); break;
    }
    return NCK_OK;
}
