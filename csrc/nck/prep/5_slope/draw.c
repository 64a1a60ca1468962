// SPDX-License-Identifier: MIT
// Room 5, slope: a plan over the ladder as cells of a tail.
#include "nck/prep/5_slope/draw.h"

#include <stddef.h> // size_t
#include <string.h> // memset

#include "nck/base/real.h"                // nck_min nck_max nck_fabs nck_sqrt
#include "nck/prep/5_slope/ladder_math.h" // nck_ladder_cbrt
#include "nck/prep/5_slope/window.h"      // nck_window_cap

// A speed is at its cap within this share of v².
#define CAP_EPSILON 1e-4
// Of the speed that a cell reaches from rest, v³ = J·h².
#define CREEP 0.1
// At its cap a long cell lasts longer than so many of the others may.
#define LONG_SHARE 1.2
// An acceleration is at its limit above this share of it.
#define ACCEL_SHARE 0.999

// What drawing keeps from cell to cell of a step.
typedef struct draw {
    nck_cell_t *cells;       // of the whole plan
    const nck_node_t *piece; // in which the next cell begins
    const nck_node_t *capped; // the piece …
    double cap;              // … whose cap this is, v²
    double v;                // where the next cell begins [mm/s]
    uint32_t n;              // cells of the plan
    uint32_t keep;           // as the plan's
    uint8_t held;            // NCK_STOP_HOLD, or none
    double time, keep_time;  // nck_jerk_t.work
    double sure_time;
    uint32_t sure;
} draw_t;

static uint8_t limit_of(const nck_jerk_t *self, draw_t *draw, size_t i, double a) {
    const nck_node_t *const piece = draw->piece;
    const double vv0 = self->vv[i];
    const double vv1 = self->vv[i + 1];
    const double near = 1.0 - CAP_EPSILON;
    if (nck_fabs(a) >= ACCEL_SHARE * self->a_max[i]) return NCK_LIMIT_ACCEL;
    if (draw->capped != piece) draw->cap = nck_window_cap(self, piece);
    draw->capped = piece;
    const double cap = draw->cap;
    if (nck_min(vv0, vv1) >= near * cap) {
        return cap < near * piece->vv_piece ? (uint8_t)NCK_LIMIT_FEED : piece->limit_piece;
    }
    const int at_node = vv0 >= near * self->vv_cap[i] && self->rung_s[i] == piece->s;
    if (at_node && vv0 > 0.0) return piece->limit;
    return NCK_LIMIT_JERK;
}

// 1 if the next cell begins further on in the same piece.
static inline int goes_on(const nck_jerk_t *self, const draw_t *draw, size_t i) {
    return i + 1 < draw->n && self->rung_piece[i + 1] == self->rung_piece[i]
           && self->rung_s[i + 1] != draw->piece->s;
}

// How many segs further on a cell's end lies, and whether it is a seg's end. Returns the piece that
// begins there, or goes on; NULL if it is not known.
static const nck_node_t *end_cell(const nck_jerk_t *self, const nck_pieces_t *pieces, size_t i,
                                  const draw_t *draw, nck_cell_t *cell) {
    const int is_end = i + 1 == draw->n;
    cell->span = 0;
    cell->last = 0;
    if (goes_on(self, draw, i)) return draw->piece;
    const uint32_t number = is_end ? self->next->end_piece : self->rung_piece[i + 1];
    const double s = is_end ? self->next->end_s : self->rung_s[i + 1];
    const nck_node_t *const at = nck_plan_piece(pieces, number);
    // At a piece's start the one before ends.
    const int behind = s == NCK_PLAN_BEGIN || (at && s == at->s);
    const nck_node_t *const piece = behind ? nck_plan_piece(pieces, number - 1) : at;
    cell->span = (uint8_t)(piece->seg - cell->seg);
    cell->last = behind && piece->last;
    return at;
}

// Between two nodes at no speed a cell would last for ever. Where a plan is broken there may be
// such (a coarse one is not asked, and from rest there is no other): the node behind cell i creeps.
static void keep_moving(nck_jerk_t *self, size_t i, uint32_t n) {
    const size_t node = i + 1;
    if (node == n || !(self->vv_cap[node] > 0.0)) return;
    if (self->vv[i] > 0.0 && self->vv[node + 1] > 0.0) return;
    const double h = nck_min(self->h[i], self->h[node]);
    const double v = CREEP * nck_ladder_cbrt(nck_min(self->j_max[i], self->j_max[node]) * h * h);
    self->vv[node] = nck_min(self->vv_cap[node], v * v);
}

// Whether cell i is a long one, however slowly the path passes it.
static int is_long(const nck_jerk_t *self, size_t i, const nck_cell_t *drawn) {
    const double longer = LONG_SHARE * NCK_LADDER_STRETCH * self->work.step;
    if (!(drawn->duration > longer)) return 0;
    const double end = i + 1 < self->work.n ? self->vv_cap[i + 1] : 0.0;
    return drawn->length > longer * nck_sqrt(nck_max(self->vv_cap[i], end));
}

// A long cell is drawn in which the speed changes. What brakes for the window's end does not count:
// it does not become final.
static void note_uneven(nck_jerk_t *self, size_t i, const nck_cell_t *drawn) {
    if (is_long(self, i, drawn) && !nck_window_is_even(drawn)) self->work.brakes_long = 1;
    if (drawn->a >= 0.0) self->work.uneven |= self->work.brakes_long;
}

// How far the plan is sure once cell i is drawn. Two steps a cell catch up with any stretch of
// braking in the middle of the path.
static inline void note_sure(const nck_jerk_t *self, draw_t *draw, size_t i) {
    const double until = draw->keep_time - self->margin_s;
    for (int n = 0; n < 2 && draw->sure <= i; n++) {
        const double end = draw->sure_time + draw->cells[draw->sure].duration;
        if (end > until) return;
        draw->sure_time = end;
        draw->sure++;
    }
}

// What of a cell the ladder of the next plan is divided by.
static inline void draw_motion(nck_jerk_t *self, draw_t *draw, size_t i) {
    nck_cell_t *const cell = &draw->cells[i];
    if (!(self->vv[i + 1] > 0.0)) keep_moving(self, i, draw->n);
    const double v = draw->v;
    const double h = self->h[i];
    const double end = self->vv[i + 1];
    const double a = (end - self->vv[i]) / (2.0 * h);
    draw->v = nck_sqrt(end);
    const double duration = 2.0 * h / (v + draw->v);
    draw->time += duration;
    cell->seg = draw->piece->seg;
    cell->s = self->rung_s[i];
    cell->length = h;
    cell->v = v;
    cell->a = a;
    cell->j = 0.0;
    cell->duration = duration;
    if (!(a >= 0.0)) return;
    draw->keep = (uint32_t)i + 1;
    draw->keep_time = draw->time;
}

// A plan that only tells how to divide the ladder needs no more.
static void draw_cell(nck_jerk_t *self, const nck_pieces_t *pieces, draw_t *draw, size_t i) {
    nck_cell_t *const cell = &draw->cells[i];
    draw_motion(self, draw, i);
    if (self->work.coarse) {
        if (i + 1 < draw->n) draw->piece = nck_plan_piece(pieces, self->rung_piece[i + 1]);
        return;
    }
    cell->limit = limit_of(self, draw, i, cell->a);
    cell->stop = draw->held | (uint8_t)(i + 1 == draw->n ? NCK_STOP_REST : 0);
    draw->piece = end_cell(self, pieces, i, draw, cell);
    note_uneven(self, i, cell);
    note_sure(self, draw, i);
}

static draw_t begin_step(nck_jerk_t *self, const nck_pieces_t *pieces) {
    const uint32_t i = self->work.i;
    draw_t draw;
    draw.cells = nck_link_tail_room(self->link) - i;
    draw.piece = nck_plan_piece(pieces, self->rung_piece[i]);
    draw.capped = (const nck_node_t *)0;
    draw.cap = 0.0;
    draw.v = nck_sqrt(self->vv[i]);
    draw.n = self->work.n;
    draw.keep = self->next->keep;
    draw.held = self->next->held ? NCK_STOP_HOLD : 0;
    draw.time = self->work.time;
    draw.keep_time = self->work.keep_time;
    draw.sure_time = self->work.sure_time;
    draw.sure = self->work.sure;
    return draw;
}

static void end_step(nck_jerk_t *self, const draw_t *draw, uint32_t end) {
    nck_link_tail_grow(self->link, end - self->work.i);
    self->work.i = end;
    self->next->keep = draw->keep;
    self->work.time = draw->time;
    self->work.keep_time = draw->keep_time;
    self->work.sure_time = draw->sure_time;
    self->work.sure = draw->sure;
}

static void draw_rest(nck_jerk_t *self, const nck_pieces_t *pieces) {
    const nck_node_t *const piece = nck_plan_piece(pieces, self->rung_piece[0]);
    nck_cell_t cell;
    memset(&cell, 0, sizeof cell);
    cell.seg = piece->seg;
    cell.s = piece->s;
    cell.duration = piece->standstill.dwell_s;
    cell.limit = piece->limit_piece;
    cell.stop = NCK_STOP_REST;
    cell.last = 1;
    nck_link_tail_push(self->link, &cell);
}

nck_status_t nck_draw_cells(nck_jerk_t *self, const nck_pieces_t *pieces) {
    if (self->work.n == 1 && !(self->h[0] > 0.0)) {
        draw_rest(self, pieces);
        return NCK_DONE;
    }
    const uint32_t begin = self->work.i;
    const uint32_t left = self->work.n - begin;
    const uint32_t end = begin + (left < NCK_JERK_STEP ? left : NCK_JERK_STEP);
    draw_t draw = begin_step(self, pieces);
    for (size_t i = begin; i < end; i++) draw_cell(self, pieces, &draw, i);
    end_step(self, &draw, end);
    return left < NCK_JERK_STEP ? NCK_DONE : NCK_OK;
}
