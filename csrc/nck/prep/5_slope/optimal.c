// SPDX-License-Identifier: MIT
// Room 5, slope: the jerk-limited planner on a clocked path.
#include "nck/base/real.h"                  // nck_max nck_sqrt
#include "nck/base/tuning.h"                // NCK_ITERATIONS …
#include "nck/prep/5_slope/optimal.h"
#include "nck/prep/5_slope/optimal_draw.h"  // nck_optimal_draw
#include "nck/prep/5_slope/optimal_nodes.h" // nck_optimal_fill …
#include "nck/prep/5_slope/optimal_pace.h"  // nck_optimal_work …
#include "nck/prep/5_slope/tuning.h" // NCK_OPTIMAL_SLOWER_PRICE …

#include <string.h> // memset

enum { PHASE_LAY = 0, PHASE_FILL, PHASE_SOLVE, PHASE_DRAW };

enum {
    INTERVALS_MOST = NCK_MOTION_NODES - 1,
    HALF = INTERVALS_MOST / 2,
    // So many become final before the next plan: of a short one half …
    COMMIT_MOST = INTERVALS_MOST - NCK_FURTHER > HALF ? INTERVALS_MOST - NCK_FURTHER : HALF,
    COMMIT_LEAST = INTERVALS_MOST / 8 // … at least so many: every plan costs as much
};
// What takes more of a limit is no plan, nor is what takes longer [s], or no number.
#define LOST 1e6

void nck_optimal_init(nck_optimal_t *self, const nck_terms_t *terms, nck_link_t *link,
                      const nck_plan_t *now, nck_plan_t *next, nck_motion_t *motion) {
    if (!NCK_HAS_OPTIMAL) return;
    memset(self, 0, sizeof *self);
    self->terms = terms;
    self->link = link;
    self->now = now;
    self->next = next;
    self->motion = motion;
}

// The plan drawn last may have been published, or not.
static void note_published(nck_optimal_t *self) {
    const nck_optimal_pace_t *const work = nck_optimal_work(self);
    if (work->drawn && work->begin == self->now->begin) self->drawn = 1 - self->drawn;
}

void nck_optimal_begin(nck_optimal_t *self, const nck_job_t *job) {
    if (!NCK_HAS_OPTIMAL) return;
    note_published(self);
    nck_optimal_pace_t *const work = nck_optimal_work(self);
    self->job = *job;
    self->next->n = 0;
    self->next->complete = 0;
    self->next->held = NCK_HELD_NOT;
    self->phase = PHASE_LAY;
    work->begin = self->next->begin;
    work->first = self->next->piece;
    work->n = 0;
    work->ends = 0;
    work->drawn = 0;
}

// ---- laying

// Caps have come down below what the last plan is about to do: the least share of its speed that
// they are for one plan.
static void look_slower(nck_optimal_t *self, const nck_pieces_t *pieces) {
    const nck_optimal_pace_t *const now = nck_optimal_now(self);
    const nck_optimal_pace_t *const work = nck_optimal_work(self);
    const uint32_t off = now->ends ? 0 : NCK_OPTIMAL_COMMIT_OFF;
    double share = 1.0;
    self->vv_most = 0.0;
    for (uint32_t k = 1; nck_optimal_goes_on(self) && k < NCK_OPTIMAL_SLOWER_NODES; k++) {
        const uint32_t at = work->first - now->first + k;
        const nck_node_t *const piece = nck_plan_piece(pieces, work->first + k);
        if (at + off > now->top || !piece) break;
        const double vv = (double)now->along[at] * now->b[at];
        const double cap = nck_optimal_wanted(self, piece);
        self->vv_most = nck_max(self->vv_most, vv);
        if (cap < share * share * vv) share = nck_sqrt(cap / vv);
    }
    self->slower = nck_max(share, NCK_OPTIMAL_SLOWER_LEAST);
}

// Intervals of the window at most: a plan that slows the last one down ends where that does, since
// it is sought from there.
static uint32_t most_intervals(nck_optimal_t *self) {
    const nck_optimal_pace_t *const now = nck_optimal_now(self);
    if (!nck_optimal_slows(self)) return INTERVALS_MOST;
    return now->first + now->n - nck_optimal_work(self)->first;
}

// Count the intervals of the window.
static nck_status_t count_intervals(nck_optimal_t *self, const nck_pieces_t *pieces) {
    nck_optimal_pace_t *const work = nck_optimal_work(self);
    const uint32_t least = nck_optimal_goes_on(self) ? NCK_OPTIMAL_GIVEN + 1 : 1;
    const uint32_t most = most_intervals(self);
    while (work->n < most && !work->ends) {
        const nck_node_t *const piece = nck_plan_piece(pieces, work->first + work->n);
        if (!piece) break;
        work->ends = piece->stop;
        work->n++;
    }
    if (work->ends || work->n == most) return work->n < least ? NCK_E_STATE : NCK_DONE;
    if (self->job.starved && work->n >= least) return NCK_DONE;
    self->next->wants = work->first + work->n + 1;
    return NCK_EMPTY;
}

static nck_status_t set_wish(nck_optimal_t *self) {
    const nck_optimal_pace_t *const work = nck_optimal_work(self);
    nck_motion_wish_t asked;
    memset(&asked, 0, sizeof asked);
    asked.tau = self->terms->knot_s;
    asked.axes = self->terms->axes;
    asked.nodes = (int)work->n + 1;
    asked.fixed = nck_optimal_goes_on(self) ? (int)NCK_OPTIMAL_GIVEN : 0;
    asked.ends = (work->ends ? NCK_MOTION_FREE_END : 0u);
    asked.most = NCK_ITERATIONS;
    asked.gap = NCK_GAP;
    asked.room = NCK_ROOM;
    if (nck_optimal_slows(self)) {
        asked.ends |= NCK_MOTION_SOFT | (work->ends ? 0u : NCK_MOTION_FIRM_END);
        asked.price = NCK_OPTIMAL_SLOWER_PRICE;
    }
    nck_optimal_set_limits(self, &asked);
    return nck_motion_begin(self->motion, NCK_OPTIMAL_AT(nck_link_spare(self->link), motion),
                            &asked);
}

static nck_status_t lay_window(nck_optimal_t *self, const nck_pieces_t *pieces) {
    if (nck_optimal_work(self)->n == 0) look_slower(self, pieces);
    const nck_status_t status = count_intervals(self, pieces);
    if (status != NCK_DONE) return status;
    self->i = 0;
    memset(self->looked, 0, sizeof self->looked);
    self->phase = PHASE_FILL;
    return set_wish(self);
}

static nck_status_t fill_nodes(nck_optimal_t *self, const nck_pieces_t *pieces) {
    const nck_optimal_pace_t *const work = nck_optimal_work(self);
    for (int n = 0; n < NCK_OPTIMAL_FILL && self->i <= work->n; n++) {
        nck_optimal_fill(self, pieces, self->i++);
    }
    if (self->i > work->n) self->phase = PHASE_SOLVE;
    return NCK_OK;
}

// ---- solving

// What the pace b is to be multiplied by, so that the plan keeps its limits: 1 where it does; less
// where it begins at rest, since accelerations go down as b and jerks as b^(3/2). 0: there is none,
// the plan before goes on to its rest.
static double factor_of(const nck_optimal_t *self) {
    nck_motion_told_t told;
    nck_motion_told(self->motion, &told);
    if (!(told.time < LOST)) return 0.0;
    if (told.share <= 1.0 + NCK_MET) return 1.0;
    return nck_optimal_goes_on(self) || !(told.share < LOST) ? 0.0 : 1.0 / told.share;
}

// A plan that goes on creeps: over what the plan of now knows it takes longer than that one and,
// behind it, the caps as far as a plan slows down below them. A window's end so near that there is
// no room for another brake leaves the solver at its least b, of which no cells can be made: hours
// a seg.
static int creeps(nck_optimal_t *self, const nck_pieces_t *pieces) {
    const nck_optimal_pace_t *const now = nck_optimal_now(self);
    const nck_optimal_pace_t *const work = nck_optimal_work(self);
    const uint32_t at = work->first - now->first;
    double more = 0.0;
    if (!nck_optimal_goes_on(self)) return 0;
    for (uint32_t k = 0; k < work->n && at + k < now->n; k++) {
        const nck_node_t *const piece = nck_plan_there(pieces, work->first + k);
        const double cap = nck_optimal_wanted(self, piece);
        const double known = 2.0 / (nck_sqrt(now->b[at + k]) + nck_sqrt(now->b[at + k + 1]));
        const double takes = 2.0 / (nck_sqrt(work->b[k]) + nck_sqrt(work->b[k + 1]));
        more += takes - known;
        if (!(cap > 0.0)) return 0;
        more -= piece->length / (NCK_OPTIMAL_SLOWER_LEAST * self->terms->knot_s * nck_sqrt(cap));
    }
    return more > 0.0;
}

// The place of most speed before a plan brakes for its window's end.
static uint32_t find_top(const nck_optimal_pace_t *work, uint32_t least) {
    if (work->ends) return work->n;
    for (uint32_t k = work->n - 1; k > least; k--) {
        const double before = (double)work->along[k - 1] * work->b[k - 1];
        const double here = (double)work->along[k] * work->b[k];
        const double behind = (double)work->along[k + 1] * work->b[k + 1];
        if (here >= behind && here >= before) return k;
    }
    return work->n;
}

// Where a plan has slowed down, as far as it does.
static uint32_t slowed_at(const nck_optimal_t *self, const nck_optimal_pace_t *work,
                          uint32_t step) {
    const int least = self->slower <= NCK_OPTIMAL_SLOWER_LEAST;
    for (uint32_t k = least ? NCK_OPTIMAL_GIVEN : COMMIT_LEAST; k < step; k++) {
        const double here = (double)work->along[k] * work->b[k];
        if ((double)work->along[k + 1] * work->b[k + 1] > here) return k;
    }
    return step;
}

// Where the next plan takes over, in the middle of an interval: behind so many of them. One that
// slows down is followed where it is slow: it has not slowed down to what is asked for, or it has
// paid for being faster further on.
static uint32_t commit_of(const nck_optimal_t *self, const nck_optimal_pace_t *work) {
    const uint32_t off = work->ends ? 0 : NCK_OPTIMAL_COMMIT_OFF;
    uint32_t step = work->top > off + COMMIT_LEAST ? work->top - off : COMMIT_LEAST;
    if (step > COMMIT_MOST) step = COMMIT_MOST;
    if (nck_optimal_slows(self)) step = slowed_at(self, work, step);
    if (step + NCK_OPTIMAL_GIVEN <= work->n) return step;
    return work->n > NCK_OPTIMAL_GIVEN ? work->n - NCK_OPTIMAL_GIVEN : 1;
}

static nck_status_t solve_motion(nck_optimal_t *self, const nck_pieces_t *pieces) {
    const nck_status_t status = nck_motion_step(self->motion);
    nck_optimal_pace_t *const work = nck_optimal_work(self);
    if (status != NCK_DONE) return status;
    const double factor = factor_of(self);
    if (!(factor > 0.0)) return NCK_E_STATE;
    for (uint32_t k = 0; k <= work->n; k++) {
        work->b[k] = factor * (double)nck_motion_b(self->motion, (int)k);
    }
    const nck_optimal_pace_t *const now = nck_optimal_now(self);
    for (uint32_t k = 0; nck_optimal_goes_on(self) && k < NCK_OPTIMAL_GIVEN; k++) {
        work->b[k] = now->b[work->first - now->first + k]; // to the bit
    }
    if (creeps(self, pieces)) return NCK_E_STATE;
    work->top = find_top(work, NCK_OPTIMAL_GIVEN + 1);
    self->takes_over = commit_of(self, work) - (nck_optimal_goes_on(self) ? 0 : 1);
    self->i = 0;
    self->cells = 0;
    self->seam = 0;
    nck_link_tail_begin(self->link);
    self->phase = PHASE_DRAW;
    return NCK_OK;
}

nck_status_t nck_optimal_step(nck_optimal_t *self, const nck_pieces_t *pieces) {
    if (!NCK_HAS_OPTIMAL) return NCK_E_INTERNAL;
    switch (self->phase) {
    case PHASE_LAY: return lay_window(self, pieces);
    case PHASE_FILL: return fill_nodes(self, pieces);
    case PHASE_SOLVE: return solve_motion(self, pieces);
    default: return nck_optimal_draw(self, pieces);
    }
}

uint32_t nck_optimal_price(const nck_optimal_t *self) {
    switch (NCK_HAS_OPTIMAL ? self->phase : (uint32_t)PHASE_LAY) {
    case PHASE_LAY: return 0;
    case PHASE_FILL: return 98;
    case PHASE_SOLVE: return nck_motion_price(self->motion);
    default: return 80;
    }
}

uint32_t nck_optimal_laid(const nck_optimal_t *self) {
    if (!NCK_HAS_OPTIMAL || self->phase != PHASE_LAY) return 0;
    return self->pace[1 - self->drawn].n;
}

void nck_optimal_hurry(nck_optimal_t *self) {
    if (NCK_HAS_OPTIMAL) self->job.starved = 1;
}

// A cell that begins in the middle of its seg. In the last interval there is no seam.
uint32_t nck_optimal_seam(const nck_optimal_t *self, uint32_t cell) {
    if (!NCK_HAS_OPTIMAL) return cell;
    uint32_t i = cell;
    for (; i < self->now->n; i++) {
        const nck_cell_t *const at =
            nck_link_tail_cell(self->link, (self->now->begin + i) & NCK_LINK_COUNT_MASK);
        if (!at || at->s == 0.5 * nck_link_seg(self->link, at->seg)->length) break;
    }
    return i;
}
