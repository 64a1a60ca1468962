// SPDX-License-Identifier: MIT
// Inside room 3: windows and rounds, from segs to pieces of one curve.
#include "nck/base/budget.h"          // NCK_UNLIMITED
#include "nck/base/real.h"            // nck_fabs nck_max nck_min
#include "nck/base/tuning.h"          // NCK_ITERATIONS …
#include "nck/prep/3_smooth/best.h"      // nck_best_…
#include "nck/prep/3_smooth/reference.h" // nck_reference_set
#include "nck/prep/3_smooth/sample.h" // nck_sample_…
#include "nck/prep/3_smooth/stream.h"
#include "nck/prep/3_smooth/tuning.h" // NCK_STREAM_SHARE …

#include <string.h> // memcpy memset

#define LOST 100.0 // [P²] what has come of it is no curve
#define FASTEST ((nck_num)1e6) // [1] b where a curve stands still: it is no limit there
#define POINTS 8   // reference points and nodes a call

static nck_status_t go(nck_stream_t *self, nck_stream_phase_t phase) {
    self->phase = phase;
    self->at = 0;
    self->leg = 0;
    return NCK_OK;
}

static void begin_rounds(nck_stream_t *self) {
    self->round = 0;
    self->tries = 0;
    self->commit = 0;
    self->halts = 0;
    self->best.knots = 0;
    self->share = NCK_STREAM_SHARE;
}

void nck_stream_begin(nck_stream_t *self, const nck_stream_wish_t *wish) {
    self->wish = *wish;
    (void)go(self, NCK_STREAM_GUESS);
    begin_rounds(self);
    self->unit = 0.0;
    self->miss = 0.0;
    self->near = 0;
    memset(&self->told, 0, sizeof self->told);
    memset(self->seam, 0, sizeof self->seam);
    nck_track_begin(&self->track, wish->terms.axes, wish->terms.tau, wish->terms.spin_a);
    nck_timing_begin(&self->clock, &self->wish.terms);
    self->work.list.count = 0;
    self->work.list.kept = 0;
}

nck_status_t nck_stream_push(nck_stream_t *self, const nck_seg_t *seg, double tolerance) {
    if (self->track.head == 0) {
        for (int k = 0; k < 3; k++) memcpy(self->seam[k], seg->start, sizeof self->seam[k]);
    }
    return nck_track_push(&self->track, seg, tolerance);
}

void nck_stream_close(nck_stream_t *self) {
    nck_track_seal(&self->track);
    self->clock.closed = 1;
}

static nck_status_t guess(nck_stream_t *self) {
    const nck_status_t status = nck_timing_look(&self->clock, &self->track);
    if (status != NCK_DONE) {
        self->told.places += status == NCK_OK;
        return status;
    }
    self->clock.hurries = 0;
    if (self->track.head == 0) return go(self, NCK_STREAM_OVER);
    return go(self, NCK_STREAM_CLOCK);
}

static nck_status_t make_clock(nck_stream_t *self) {
    if (nck_timing_make(&self->clock, &self->work.list, &self->track) == NCK_OK) return NCK_OK;
    self->near = self->track.tail;
    const uint32_t first = nck_track_find(&self->track, self->near, self->clock.s[0]);
    const double end = self->clock.s[4 * self->clock.knots];
    const uint32_t last = nck_track_find(&self->track, first, end);
    self->unit = (double)nck_track_at(&self->track, last)->tolerance;
    for (uint32_t n = first; n != last; n++) {
        self->unit = nck_min(self->unit, (double)nck_track_at(&self->track, n)->tolerance);
    }
    return go(self, NCK_STREAM_REFERENCE);
}

// 1 if the curve that comes of this clock is to be given.
static int is_last_round(const nck_stream_t *self) { return self->round + 1 >= self->wish.rounds; }

// 1 if an axis moves in the window: what stands needs no curve.
static int is_moving(const nck_stream_t *self, int x) {
    const nck_track_t *const track = &self->track;
    for (int k = 1; k < self->clock.knots + 3; k++) {
        if (self->point[k][x] != self->point[0][x]) return 1;
    }
    const double end = self->clock.s[4 * self->clock.knots];
    for (uint32_t n = track->tail; n != track->head; n++) {
        const nck_track_element_t *const element = nck_track_at(track, n);
        if (element->s > end) break;
        if (element->start[x] != self->point[0][x]) return 1;
        if (element->plane && x < 3) return 1;
    }
    return 0;
}

static void find_axes(nck_stream_t *self) {
    self->moving = 0;
    for (int x = 0; x < self->wish.terms.axes; x++) {
        if (is_moving(self, x)) self->axis[self->moving++] = (uint8_t)x;
    }
    if (self->moving > 0) return;
    self->moving = 1;
    self->axis[0] = 0;
}

static void begin_fair(nck_stream_t *self) {
    const nck_timing_terms_t *const terms = &self->wish.terms;
    const double tau = terms->tau;
    nck_fair_task_t task;
    find_axes(self);
    memset(&task, 0, sizeof task);
    task.knots = self->clock.knots;
    task.axes = self->moving;
    // The first clock is a guess, too fast in corners; where a curve has failed squares are surer.
    task.even = self->round > 0 && self->tries == 0 ? NCK_STREAM_EVEN : 0;
    task.ends = self->clock.ends;
    task.most = NCK_ITERATIONS;
    task.gap = (nck_num)self->wish.gap * (self->round == 0 ? NCK_STREAM_FIRST_GAP : 1);
    task.scale = (nck_num)(self->unit / ((double)terms->smooth_least * tau * tau * tau));
    const nck_num firm = NCK_STREAM_FIRM * NCK_NUM_EPSILON;
    task.stay = nck_num_max(NCK_STREAM_STAY, firm * task.scale * task.scale);
    for (int n = 0; n < self->moving; n++) {
        task.share[n] = terms->smooth_least / terms->smooth[self->axis[n]];
    }
    nck_fair_begin(&self->work.fair, &task);
}

static nck_status_t set_reference(nck_stream_t *self) {
    const int points = self->clock.knots + 3;
    for (int k = 0; k < POINTS && self->at < points; k++) nck_reference_set(self, self->at++);
    if (self->at < points) return NCK_OK;
    begin_fair(self);
    self->near = self->track.tail;
    return go(self, NCK_STREAM_SAMPLES);
}

static nck_status_t set_samples(nck_stream_t *self) {
    nck_sample_interval(self, self->at++);
    return self->at < self->clock.knots ? NCK_OK : go(self, NCK_STREAM_FAIR);
}

// The reference becomes the curve.
static void take_curve(nck_stream_t *self) {
    for (int k = 0; k < self->clock.knots + 3; k++) {
        const nck_num *const y = &self->work.fair.y[k * self->moving];
        for (int n = 0; n < self->moving; n++) {
            self->point[k][self->axis[n]] += self->unit * (double)y[n];
        }
    }
}

// How much of the window is given: what knows enough of what follows, half of a short window, up
// to where the next one's begin is least held. In a corner another clock may have no curve at all.
static int to_commit(const nck_stream_t *self) {
    const int knots = self->clock.knots;
    if (self->clock.ends) return knots;
    int best = knots > 2 * NCK_FURTHER ? knots - NCK_FURTHER : knots / 2;
    nck_num least = nck_fair_tightness(&self->work.fair, best, NCK_STREAM_NEXT);
    for (int k = best - 1; k >= best / 2; k--) {
        const nck_num here = nck_fair_tightness(&self->work.fair, k, NCK_STREAM_NEXT);
        if (!(here < NCK_STREAM_RELAXED * least)) continue;
        least = here;
        best = k;
    }
    return best;
}

// The clock takes twice as long behind what is given: knots were too far apart for any curve.
static nck_status_t slow_down(nck_stream_t *self) {
    for (int k = 0; k <= self->clock.knots; k++) self->b[k] = (nck_num)0.25;
    self->clock.even = 1;
    const int span[3] = {0, self->clock.knots, self->clock.begins ? 0 : NCK_STREAM_BLEND};
    nck_timing_begin_keep(&self->clock, &self->work.list, &self->track, span);
    return go(self, NCK_STREAM_KEEP);
}

// What has come of it is no curve: rows are far off, or single precision has run over.
static int is_lost(const nck_stream_t *self) {
    const nck_fair_t *const fair = &self->work.fair;
    nck_num sum = 0;
    for (int k = 0; k < (self->clock.knots + 3) * self->moving; k++) sum += fair->y[k];
    return !(fair->sum.primal < (nck_num)LOST) || sum - sum != 0;
}

// The last clock has no curve, or a slower one: the fastest so far is given.
static nck_status_t take_best(nck_stream_t *self) {
    nck_best_take(self);
    self->sound = 1;
    self->planned = 1;
    self->near = self->track.tail;
    return go(self, NCK_STREAM_PROVE);
}

static nck_status_t make_fair(nck_stream_t *self) {
    if (nck_fair_step(&self->work.fair) == NCK_OK) return NCK_OK;
    self->told.windows++;
    self->planned = 0;
    self->told.iterations += (uint32_t)self->work.fair.iterations;
    self->sound = self->work.fair.sound;
    if (!self->sound && self->best.knots > 0 && is_last_round(self)) return take_best(self);
    const int lost = is_lost(self);
    if (lost && self->tries < NCK_STREAM_TRIES) {
        self->tries++;
        return slow_down(self);
    }
    if (!lost) take_curve(self);
    self->near = self->track.tail;
    self->given = to_commit(self);
    return go(self, is_last_round(self) && !self->sound ? NCK_STREAM_PROVE : NCK_STREAM_NODES);
}

// A curve that is off is made again: on the next clock, which its plan makes slower; where that is
// the answer, with less of P.
static nck_status_t try_again(nck_stream_t *self, double found) {
    self->tries++;
    self->told.again++;
    if (self->tries >= NCK_STREAM_TRIES / 2) return slow_down(self);
    if (!self->sound || !self->planned) return go(self, NCK_STREAM_NODES);
    self->share *= nck_max(0.5, NCK_STREAM_SHARE / found);
    return go(self, NCK_STREAM_REFERENCE);
}

// No curve of this window is within P: the last one comes to rest behind its seam instead.
static nck_status_t halt(nck_stream_t *self) {
    nck_sample_rest_t rest;
    self->told.rests++;
    self->halts = 1;
    memcpy(rest.point, self->seam, sizeof self->seam);
    nck_sample_rest(self, self->knot_s, &rest);
    memcpy(self->point, rest.point, sizeof rest.point);
    for (int k = 1; k <= NCK_SAMPLE_REST; k++) {
        const double *const place = &rest.place[k];
        self->clock.s[4 * k] = (place[0] + 4.0 * place[1] + place[2]) / 6.0;
    }
    self->commit = NCK_SAMPLE_REST;
    return go(self, NCK_STREAM_GIVE);
}

// The window has no curve that will do: another one, or the rest that the last one has.
static nck_status_t fail(nck_stream_t *self, double found) {
    if (self->tries < NCK_STREAM_TRIES) return try_again(self, found);
    if (!self->clock.begins) return halt(self);
    self->told.missed++;
    self->commit = self->given;
    return go(self, self->clock.ends ? NCK_STREAM_GIVE : NCK_STREAM_NODES);
}

// Hold an interval against the program.
static nck_status_t prove(nck_stream_t *self) {
    const double miss = nck_sample_miss(self, self->at++);
    self->miss = miss - miss != 0.0 ? NCK_UNLIMITED : nck_max(self->miss, miss); // no number
    if (self->at < self->given) return NCK_OK;
    const double found = self->miss;
    self->miss = 0.0;
    if (!(found <= 1.0)) return fail(self, found);
    self->told.most = nck_max(self->told.most, found);
    if (!self->clock.ends) return go(self, NCK_STREAM_REST);
    self->commit = self->given;
    return go(self, NCK_STREAM_GIVE);
}

// s of the program at a knot and the two behind it.
static void set_knots(const nck_stream_t *self, int knot, double *s_out) {
    for (int k = 0; k < 3; k++) s_out[k] = self->clock.s[4 * (knot + k)];
}

// The seam is where the curve could rest within P, as late as may be: so the next window may fail.
static nck_status_t find_rest(nck_stream_t *self) {
    const int here = self->given - self->at;
    nck_sample_rest_t rest;
    double knot_s[3];
    if (here < 1) {
        self->told.restless++;
        self->sound = 0;
        return fail(self, NCK_UNLIMITED);
    }
    set_knots(self, here, knot_s);
    memcpy(rest.point, &self->point[here], sizeof self->seam);
    nck_sample_rest(self, knot_s, &rest);
    if (!(nck_sample_rest_miss(self, &rest, self->leg) <= 1.0)) {
        self->at++;
        self->leg = 0;
        return NCK_OK;
    }
    self->leg++;
    if (self->leg < NCK_SAMPLE_REST) return NCK_OK;
    self->given = here;
    self->commit = here;
    return go(self, self->planned ? NCK_STREAM_GIVE : NCK_STREAM_NODES);
}

static nck_status_t begin_motion(nck_stream_t *self) {
    const nck_timing_terms_t *const terms = &self->wish.terms;
    nck_motion_wish_t wish;
    memset(&wish, 0, sizeof wish);
    wish.tau = terms->tau;
    for (int x = 0; x < terms->axes; x++) {
        wish.a[x] = (double)terms->a[x];
        wish.j[x] = (double)terms->j[x];
    }
    memcpy(wish.along, terms->along, sizeof wish.along);
    wish.axes = terms->axes;
    wish.nodes = self->clock.knots + 1;
    wish.ends = (self->clock.ends ? NCK_MOTION_FREE_END : NCK_MOTION_OPEN_END)
               | (self->clock.begins ? 0U : NCK_MOTION_INSIDE) | NCK_MOTION_COARSE;
    wish.most = self->wish.most;
    wish.gap = self->wish.gap;
    wish.room = NCK_ROOM;
    return nck_motion_begin(&self->work.plan.motion, &self->work.plan.work, &wish);
}

// One node: r′ and r″ over the clock, and the cap of b by feed and axis speeds.
static void set_node(nck_stream_t *self, int k) {
    const nck_timing_terms_t *const terms = &self->wish.terms;
    double (*const c)[NCK_AXIS_MAX] = &self->point[k];
    const nck_num per = (nck_num)(1.0 / terms->tau);
    nck_num p1[NCK_AXIS_MAX];
    nck_num p2[NCK_AXIS_MAX];
    nck_num slowness = 0;
    nck_num square = 0;
    for (int x = 0; x < terms->axes; x++) {
        const nck_num before = (nck_num)(c[1][x] - c[0][x]);
        const nck_num behind = (nck_num)(c[2][x] - c[1][x]);
        p1[x] = per * (before + behind) / 2;
        p2[x] = per * per * (behind - before);
        slowness = nck_num_max(slowness, NCK_NUM_ABS(p1[x]) / terms->v[x]);
        square += p1[x] * p1[x];
    }
    const double s = self->clock.s[4 * k];
    self->near = nck_track_find(&self->track, self->near, s);
    const nck_num feed = (nck_num)nck_track_feed(&self->track, self->near, s);
    nck_num least = nck_num_max(1 / FASTEST, slowness * slowness);
    if (feed > 0) least = nck_num_max(least, square / (feed * feed));
    const double pace = NCK_START
                        * nck_timing_pace(&self->clock, &self->track, &self->near, k);
    const nck_num cap_and_b[2] = {1 / least, (nck_num)pace};
    nck_motion_node(&self->work.plan.motion, k, p1, p2, cap_and_b);
}

static nck_status_t set_nodes(nck_stream_t *self) {
    if (self->at == 0 && begin_motion(self) != NCK_OK) return NCK_E_INTERNAL;
    const int nodes = self->clock.knots + 1;
    for (int k = 0; k < POINTS && self->at < nodes; k++) set_node(self, self->at++);
    return self->at < nodes ? NCK_OK : go(self, NCK_STREAM_MOTION);
}

// What comes of the window: another round, or pieces. Where the next clock begins.
static nck_status_t turn(nck_stream_t *self, int from) {
    const int knots = self->clock.knots;
    const int known = knots - NCK_STREAM_OPEN > from + 2 ? knots - NCK_STREAM_OPEN : from + 2;
    const int to = self->clock.ends || known > knots ? knots : known;
    const int span[3] = {from, to, self->clock.begins && from == 0 ? 0 : (int)NCK_STREAM_BLEND};
    nck_timing_begin_keep(&self->clock, &self->work.list, &self->track, span);
    return go(self, NCK_STREAM_KEEP);
}

// Where the plan along the curve is its clock another round would change nothing.
static nck_status_t compare(nck_stream_t *self) {
    const int all = self->given + NCK_STREAM_OPEN;
    const int to = self->clock.knots < all ? self->clock.knots : all;
    for (int k = 0; k < POINTS && self->at <= to; k++, self->at++) {
        const nck_num now = nck_timing_factor(&self->clock, &self->track, &self->near, self->at,
                                              self->b[self->at]);
        self->off += NCK_NUM_ABS(now - 1);
    }
    if (self->at <= to) return NCK_OK;
    self->planned = self->off <= (nck_num)NCK_GAP * (nck_num)(to + 1);
    const int slower = !self->planned && nck_best_is_faster(self);
    if (slower && is_last_round(self)) return take_best(self);
    if (is_last_round(self)) self->planned = 1;
    if (self->planned) return go(self, NCK_STREAM_PROVE);
    if (!slower) nck_best_keep(self);
    self->round++;
    return turn(self, 0);
}

static nck_status_t make_motion(nck_stream_t *self) {
    if (nck_motion_step(&self->work.plan.motion) == NCK_OK) return NCK_OK;
    nck_motion_told_t told;
    nck_motion_told(&self->work.plan.motion, &told);
    self->told.plans += (uint32_t)told.iterations;
    int good = 1;
    for (int k = 0; k <= self->clock.knots; k++) {
        self->b[k] = nck_motion_b(&self->work.plan.motion, k);
        good = good && self->b[k] >= 0 && self->b[k] < (nck_num)1e9;
    }
    for (int k = 0; k <= self->clock.knots && !good; k++) self->b[k] = (nck_num)NCK_START;
    if (self->commit > 0) return go(self, NCK_STREAM_GIVE);
    self->near = self->track.tail;
    self->off = 0;
    if (good && self->sound) return go(self, NCK_STREAM_COMPARE);
    self->round++;
    return turn(self, 0);
}

// The next window begins at the seam.
static nck_status_t begin_window(nck_stream_t *self) {
    const double s = self->clock.s[4 * self->commit];
    nck_timing_drop(&self->clock, s);
    nck_track_drop(&self->track, s, nck_timing_reach(&self->clock, &self->track));
    begin_rounds(self);
    self->clock.even = 0;
    return go(self, NCK_STREAM_GUESS);
}

// All of the window's pieces are taken: the next one begins where they end.
static nck_status_t next_window(nck_stream_t *self) {
    if (self->clock.ends && !self->halts) return go(self, NCK_STREAM_OVER);
    memcpy(self->seam, &self->point[self->commit], sizeof self->seam);
    set_knots(self, self->commit, self->knot_s);
    if (!self->halts) return turn(self, self->commit);
    nck_timing_rest(&self->clock, &self->work.list, self->clock.s[4 * self->commit]);
    return begin_window(self);
}

static nck_status_t keep_clock(nck_stream_t *self) {
    nck_timing_list_t *const list = &self->work.list;
    if (nck_timing_keep(&self->clock, list, &self->track, self->b) == NCK_OK) return NCK_OK;
    return self->commit > 0 ? begin_window(self) : go(self, NCK_STREAM_CLOCK);
}

static nck_status_t give(nck_stream_t *self) {
    if (self->phase == NCK_STREAM_OVER) return NCK_DONE;
    return self->at < self->commit ? NCK_FULL : next_window(self);
}

nck_status_t nck_stream_step(nck_stream_t *self) {
    switch (self->phase) {
    case NCK_STREAM_GUESS:
        return guess(self);
    case NCK_STREAM_KEEP:
        return keep_clock(self);
    case NCK_STREAM_CLOCK:
        return make_clock(self);
    case NCK_STREAM_REFERENCE:
        return set_reference(self);
    case NCK_STREAM_SAMPLES:
        return set_samples(self);
    case NCK_STREAM_FAIR:
        return make_fair(self);
    case NCK_STREAM_NODES:
        return set_nodes(self);
    case NCK_STREAM_MOTION:
        return make_motion(self);
    case NCK_STREAM_COMPARE:
        return compare(self);
    case NCK_STREAM_PROVE:
        return prove(self);
    case NCK_STREAM_REST:
        return find_rest(self);
    default:
        return give(self);
    }
}

int nck_stream_hurry(nck_stream_t *self) {
    return self->phase == NCK_STREAM_GUESS && nck_timing_hurry(&self->clock);
}

double nck_stream_place(const nck_stream_t *self) { return self->clock.s[4 * self->at]; }

void nck_stream_take(nck_stream_t *self, nck_stream_piece_t *piece_out) {
    const int i = self->at++;
    memcpy(piece_out->point, &self->point[i], sizeof piece_out->point);
    piece_out->s[0] = self->clock.s[4 * i];
    piece_out->s[1] = self->clock.s[4 * (i + 1)];
    self->near = nck_track_find(&self->track, self->near, piece_out->s[0]);
    const nck_track_element_t *const element = nck_track_at(&self->track, self->near);
    piece_out->line = element->line;
    piece_out->block = element->block;
    const double x = 0.5 * (self->point[i + 1][NCK_AXIS_X] + self->point[i + 2][NCK_AXIS_X]);
    nck_track_words(&self->track, self->near, piece_out->s[1], x, &piece_out->words);
    const int ends = (self->clock.ends || self->halts) && i + 1 == self->commit;
    piece_out->rests = (uint8_t)((self->clock.begins && i == 0) | (ends << 1));
}
