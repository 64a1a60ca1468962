// SPDX-License-Identifier: MIT
// Inside room 5: the motion along a clocked path becomes cells.
#include "nck/base/real.h" // nck_fabs nck_min nck_max nck_sqrt
#include "nck/prep/5_slope/optimal_draw.h"
#include "nck/prep/5_slope/optimal_pace.h" // nck_optimal_work …
#include "nck/prep/5_slope/tuning.h" // NCK_OPTIMAL_PARTS

#include <string.h> // memset

// Acceleration b′/2 in the middle of interval k. Beyond the ends b is even, as in base/motion.h.
static double middle_accel(const nck_optimal_pace_t *pace, double knot, uint32_t k) {
    return (pace->b[k + 1] - pace->b[k]) / (2.0 * knot);
}

// … at node k.
static double node_accel(const nck_optimal_pace_t *pace, double knot, uint32_t k) {
    if (k == 0 || k == pace->n) return 0.0;
    return 0.5 * (middle_accel(pace, knot, k - 1) + middle_accel(pace, knot, k));
}

// b at node k, on its parabola.
static double pace_at(const nck_optimal_pace_t *pace, uint32_t k) {
    const double before = pace->b[k > 0 ? k - 1 : k + 1];
    const double behind = pace->b[k < pace->n ? k + 1 : k - 1];
    return pace->b[k] + 0.125 * (before - 2.0 * pace->b[k] + behind);
}

// The time over a way h of the clock, along which b′/2 goes evenly from a0 to a1:   ∫ du/√b
// by Gauss' three places (Abramowitz and Stegun 1964, 25.4.30; the error is below 1e-9 while b
// changes by a third). By how much √b at the outer ones is off that in the middle is a small number
// of any type: 1/√(1 + x) = 1 − x/(r + r²), r = √(1 + x).
static double time_over(double b0, double a0, double a1, double h) {
    static const nck_num place = NCK_NUM_OF(0.1127016653792583); // (1 − √(3/5))/2
    const double b = b0 + (a0 + 0.25 * (a1 - a0)) * h;
    const nck_num way = (nck_num)(h / b);
    const nck_num low = (nck_num)a0;
    const nck_num turn = (nck_num)(a1 - a0);
    nck_num more = 0;
    for (int i = 0; i < 2; i++) {
        const nck_num at = i == 0 ? place : 1 - place;
        const nck_num half = at - NCK_NUM_OF(0.5); // b less that in the middle, over h
        const nck_num x = way * half * (2 * low + turn * (at + NCK_NUM_OF(0.5)));
        const nck_num root = NCK_NUM_SQRT(1 + x);
        more -= x / (root + root * root);
    }
    return h / nck_sqrt(b) * (1.0 + (double)(NCK_NUM_OF(5.0 / 18.0) * more));
}

// What holds the path about node k. Behind its top a plan brakes for what it does not know.
static uint8_t limit_at(const nck_optimal_t *self, const nck_optimal_pace_t *work, uint32_t k) {
    if (!work->ends && k > work->top) return NCK_LIMIT_LOOKAHEAD;
    switch (nck_motion_hold(self->motion, (int)k)) {
    case NCK_MOTION_ACCELERATION: return NCK_LIMIT_ACCEL;
    case NCK_MOTION_JERK: return NCK_LIMIT_JERK;
    default: return self->held_by[k];
    }
}

// A stretch of the clock within half an interval, along which b′/2 goes evenly from a0 to a1.
typedef struct portion {
    uint8_t limit; // nck_limit_t that holds it
    double u;      // where it begins in the interval [s]
    double h;      // its way [s]
    double b0, b1; // at its ends
    double a0, a1; // at its ends [1/s]
} portion_t;

// It as a cell: the cubic of time that has its length and the speeds at both ends. Where b all but
// vanishes three places tell little of the time: it never goes back, nor is it slower than at both
// ends where it only brakes, or only speeds up.
static void put_cell(nck_optimal_t *self, const nck_node_t *piece, const portion_t *on, int last) {
    const double knot = self->terms->knot_s;
    const double scale = piece->length / knot;
    const double v0 = scale * nck_sqrt(on->b0);
    const double v1 = scale * nck_sqrt(on->b1);
    nck_cell_t cell;
    memset(&cell, 0, sizeof cell);
    cell.seg = piece->seg;
    cell.limit = on->limit;
    cell.last = (uint8_t)last;
    cell.stop = last && self->i + 1 == nck_optimal_work(self)->n ? NCK_STOP_REST : 0;
    if (self->job.kind == NCK_JOB_START && !self->at_rest && self->cells == 0) {
        cell.stop |= NCK_STOP_SETS_OFF;
    }
    cell.s = piece->length * (on->u / knot); // a half is exact
    cell.length = last ? piece->length - cell.s : scale * on->h;
    cell.v = v0;
    cell.duration = on->b1 > 0.0 ? time_over(on->b0, on->a0, on->a1, on->h)
                                 : 2.0 * on->h / nck_sqrt(on->b0);
    const double least = on->a0 * on->a1 < 0.0 ? nck_sqrt(v0 * v1) : -nck_min(v0, v1);
    cell.duration = nck_min(cell.duration, 3.0 * cell.length / (v0 + v1 - least));
    const double per = 1.0 / cell.duration;
    const double mean = 6.0 * cell.length * per; // six times the speed
    cell.a = (mean - (4.0 * v0 + 2.0 * v1)) * per;
    cell.j = (6.0 * (v0 + v1) - 2.0 * mean) * per * per;
    nck_link_tail_push(self->link, &cell);
}

// Such a cell's acceleration is off by Δa·Δv/6v at its ends, which in m parts is less by m². One
// sample of jerk feels it whole.
static int parts_of(nck_optimal_t *self, const nck_node_t *piece, const portion_t *on) {
    const double scale = piece->length / self->terms->knot_s;
    const double most = NCK_OPTIMAL_CELL_SHARE * self->j_least * self->terms->machine->period_s;
    const double v0 = nck_sqrt(on->b0);
    const double v1 = nck_sqrt(on->b1);
    const double turn = nck_fabs((on->a1 - on->a0) * (v1 - v0)) * scale;
    const double off = turn / (6.0 * nck_max(nck_min(v0, v1), 0.25 * nck_max(v0, v1)));
    // Each half that is yet to come has one, and this interval may have two of the halves.
    const int left = 2 * (int)(nck_optimal_work(self)->n - self->i) + 1;
    const int room = (int)NCK_TAIL_MAX - (int)self->cells - left;
    const int parts_most = room < NCK_OPTIMAL_PARTS ? room : (int)NCK_OPTIMAL_PARTS;
    int parts = 1;
    while (parts < parts_most && off > most * (double)(parts * parts)) parts++;
    return parts;
}

// Half an interval in cells.
static void put_half(nck_optimal_t *self, const nck_node_t *piece, const portion_t *on, int last) {
    const int parts = on->b1 > 0.0 ? parts_of(self, piece, on) : 1;
    portion_t part = *on;
    part.h = on->h / (double)parts;
    for (int n = 1; n <= parts; n++) {
        const double share = (double)n / (double)parts;
        const double way = share * on->h;
        const int ends = n == parts;
        part.a1 = ends ? on->a1 : on->a0 + (on->a1 - on->a0) * share;
        part.b1 = ends ? on->b1 : on->b0 + (2.0 * on->a0 + (on->a1 - on->a0) * share) * way;
        put_cell(self, piece, &part, last && ends);
        self->cells++;
        part.u += part.h;
        part.a0 = part.a1;
        part.b0 = part.b1;
    }
}

// A plan that goes on begins in the middle of its first interval. At a window's end, where the path
// itself does not rest, the last cell brakes evenly.
static void draw_interval(nck_optimal_t *self, const nck_node_t *piece, uint32_t k) {
    const nck_optimal_pace_t *const work = nck_optimal_work(self);
    const double knot = self->terms->knot_s;
    const double half = 0.5 * knot;
    const double b = 0.5 * (work->b[k] + work->b[k + 1]);
    const double a = middle_accel(work, knot, k);
    if (k > 0 || !nck_optimal_goes_on(self)) {
        const portion_t first = {limit_at(self, work, k), 0.0, half, pace_at(work, k), b,
                                 node_accel(work, knot, k), a};
        put_half(self, piece, &first, 0);
    }
    if (k == self->takes_over) self->seam = self->cells;
    const int rests = k + 1 == work->n && !work->ends;
    const double a1 = node_accel(work, knot, k + 1);
    const portion_t second = {limit_at(self, work, k + 1), half, half, b,
                              rests ? 0.0 : pace_at(work, k + 1), a, a1};
    put_half(self, piece, &second, 1);
}

static void finish(nck_optimal_t *self) {
    nck_optimal_pace_t *const work = nck_optimal_work(self);
    nck_plan_t *const next = self->next;
    work->drawn = 1;
    next->end_piece = work->first + work->n;
    next->end_s = NCK_PLAN_BEGIN;
    next->complete = work->ends;
    next->n = self->cells;
    next->commit = self->seam;
}

nck_status_t nck_optimal_draw(nck_optimal_t *self, const nck_pieces_t *pieces) {
    if (!NCK_HAS_OPTIMAL) return NCK_E_INTERNAL;
    const nck_optimal_pace_t *const work = nck_optimal_work(self);
    const uint32_t most = self->cells + NCK_OPTIMAL_DRAW;
    while (self->i < work->n && self->cells < most) {
        draw_interval(self, nck_plan_there(pieces, work->first + self->i), self->i);
        self->i++;
    }
    if (self->i < work->n) return NCK_OK;
    finish(self);
    return NCK_DONE;
}
