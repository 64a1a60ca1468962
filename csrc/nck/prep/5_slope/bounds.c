// SPDX-License-Identifier: MIT
// Inside room 5: caps and limits of the cells of a ladder, and whether a hold keeps to them.
#include "nck/prep/5_slope/bounds.h"

#include <stddef.h> // NULL

#include "nck/base/real.h"              // nck_min nck_max
#include "nck/prep/5_slope/brake.h"     // nck_brake_along nck_brake_relax
#include "nck/prep/5_slope/hull_math.h" // nck_hull_share
#include "nck/prep/5_slope/window.h"    // nck_window_…

// Room for rounding.
#define CHECK_MARGIN 1e-6
// Long ladders are worth the code that treats many cells of a piece at once.
enum { MANY_CELLS = NCK_PROFILE > 128 };

// A hold takes what bends leave at lower speeds.
static int is_hold(const nck_jerk_t *self) { return self->work.reach > 0.0; }

// The larger speed at a cell's ends in the plan tried last, which ends at rest.
static double tried_speed(const nck_jerk_t *self, size_t i) {
    const double end = i + 1 < self->work.n ? self->vv[i + 1] : 0.0;
    return nck_sqrt(nck_max(self->vv[i], end));
}

// What a piece leaves to the cells inside of it.
typedef struct inside {
    const nck_node_t *piece; // NULL: none has been looked at
    uint32_t number;
    double vv; // cap, v²
    double a;  // [path mm/s²]
    double j;  // [path mm/s³]
} inside_t;

// Of a piece that is there.
static inside_t inside_of(const nck_jerk_t *self, const nck_pieces_t *pieces, uint32_t number) {
    const int over = self->work.over != 0;
    const nck_node_t *const piece = nck_plan_piece(pieces, number);
    const inside_t inside = {piece, number, nck_window_cap(self, piece),
                             over ? piece->a_over : piece->a, over ? piece->j_over : piece->j};
    return inside;
}

// So much of a cell, which begins in this piece, lies behind it [mm].
static inline double length_behind(const nck_jerk_t *self, const nck_node_t *piece, size_t i) {
    return self->h[i] - (piece->s + piece->length - self->rung_s[i]);
}

// A cell keeps to the limits of every piece that it touches, and its nodes to the caps of the nodes
// that it passes over. inside: of the piece that it begins in. Returns the cap inside of it, v².
static double limits_of(const nck_jerk_t *self, const nck_pieces_t *pieces, size_t i,
                        const inside_t *inside, nck_brake_limits_t *limits) {
    const double h = self->h[i];
    const nck_node_t *piece = inside->piece;
    uint32_t number = inside->number;
    inside_t least = *inside;
    double left = length_behind(self, piece, i);
    while (left > nck_window_rounding(piece, h)) {
        piece = nck_plan_piece(pieces, ++number);
        if (!piece) break;
        const inside_t next = inside_of(self, pieces, number);
        least.vv = nck_min(least.vv, nck_window_node_cap(self, piece));
        least.vv = nck_min(least.vv, next.vv);
        least.a = nck_min(least.a, next.a);
        least.j = nck_min(least.j, next.j);
        left -= piece->length;
    }
    limits->a = least.a;
    limits->j = least.j * self->j_scale;
    return least.vv;
}

// 1 if the cell behind cell i begins in this piece too: then cell i lies in it.
static inline int is_within(const nck_jerk_t *self, size_t i, uint32_t number) {
    return i + 1 < self->work.n && self->rung_piece[i + 1] == number;
}

// The same as limits_of. inside: of the piece that the cell before began in; this one's when it is
// done.
static inline double limits_at(const nck_jerk_t *self, const nck_pieces_t *pieces, size_t i,
                               inside_t *inside, nck_brake_limits_t *limits) {
    if (!inside->piece || self->rung_piece[i] != inside->number) {
        *inside = inside_of(self, pieces, self->rung_piece[i]);
    }
    const nck_node_t *const piece = inside->piece;
    if (!is_within(self, i, inside->number)
        && length_behind(self, piece, i) > nck_window_rounding(piece, self->h[i])) {
        return limits_of(self, pieces, i, inside, limits);
    }
    limits->a = inside->a;
    limits->j = inside->j * self->j_scale;
    return inside->vv;
}

static void limit_cell(nck_jerk_t *self, const nck_pieces_t *pieces, size_t i, inside_t *inside) {
    nck_brake_limits_t limits;
    const double vv_cell = limits_at(self, pieces, i, inside, &limits);
    const nck_node_t *const piece = inside->piece;
    double vv_node = i > 0 ? self->work.vv_cell : NCK_WINDOW_UNCAPPED;
    if (self->rung_s[i] == piece->s) vv_node = nck_min(vv_node, nck_window_node_cap(self, piece));
    self->work.vv_cell = vv_cell;
    self->vv_cap[i] = nck_min(vv_node, vv_cell);
    self->a_max[i] = limits.a;
    self->j_max[i] = limits.j;
}

// The path has been faster there.
static int is_lowered(const nck_jerk_t *self, size_t i) {
    return i < self->work.loaded && self->vv[i] > self->vv_cap[i];
}

// A window or a hold that ends in the cell behind a rest ends at that rest.
static void end_at_rest(nck_jerk_t *self) {
    const uint32_t last = self->work.n - 1;
    const int may_end = !self->next->complete || is_hold(self);
    if (!may_end || last == 0 || self->vv_cap[last] > 0.0) return;
    self->work.n = last;
    self->next->n = last;
    self->next->end_piece = self->rung_piece[last];
    self->next->end_s = self->rung_s[last];
}

// The same of cells from i on, as long as they lie in the piece of the cell before and do not begin
// it: there is but one answer to all. Returns the first one that is another's.
static size_t limit_alike(nck_jerk_t *self, size_t i, size_t end, const inside_t *inside) {
    const double begin = inside->piece->s;
    const double vv = inside->vv;
    const double j = inside->j * self->j_scale;
    size_t k = i;
    while (k < end && is_within(self, k, inside->number) && self->rung_s[k] != begin) {
        self->vv_cap[k] = vv;
        self->a_max[k] = inside->a;
        self->j_max[k] = j;
        if (is_lowered(self, k)) self->work.lowered = 1;
        k++;
    }
    return k;
}

nck_status_t nck_bounds_set(nck_jerk_t *self, const nck_pieces_t *pieces) {
    const uint32_t begin = self->work.i;
    const uint32_t left = self->work.n - begin;
    const size_t end = begin + (left < NCK_JERK_STEP ? left : NCK_JERK_STEP);
    const int holds = is_hold(self);
    inside_t inside = {(const nck_node_t *)0, 0, 0.0, 0.0, 0.0};
    nck_brake_mixed_t mixed = {0};
    size_t i = begin;
    while (i < end) {
        limit_cell(self, pieces, i, &inside);
        if (holds) {
            const double tried = self->work.redone > 0 ? tried_speed(self, i) : 0.0;
            nck_brake_along(self, pieces, (uint32_t)i, tried, &mixed);
        }
        if (is_lowered(self, i)) self->work.lowered = 1;
        i++;
        const int alike = MANY_CELLS && !holds;
        if (alike && is_within(self, i, inside.number)) i = limit_alike(self, i, end, &inside);
    }
    self->work.i = (uint32_t)end;
    if (left >= NCK_JERK_STEP) return NCK_OK;
    end_at_rest(self);
    return NCK_DONE;
}

// Cells and what is asked about them (nck_brake_mixed_t) in a step.
enum { LOOK_MOST = 8 * NCK_JERK_STEP };

// ---- check

// 1 if a cell of the plan keeps to what its bends leave at the speed that it has in the end.
static int keeps_limits(nck_jerk_t *self, const nck_pieces_t *pieces, size_t i,
                        inside_t *inside, nck_brake_mixed_t *mixed) {
    nck_profile_t *const state = &self->profile;
    nck_brake_limits_t limits;
    (void)limits_at(self, pieces, i, inside, &limits);
    nck_brake_relax(self, pieces, self->rung_piece[i], tried_speed(self, i), mixed, &limits);
    const double end = i + 1 < self->work.n ? self->vv[i + 1] : 0.0;
    const double a = 0.5 * (end - self->vv[i]) / self->h[i];
    const double v_sum = nck_sqrt(self->vv[i]) + nck_sqrt(end);
    const double share = nck_hull_share(self->h[i], v_sum, 0.5 * nck_window_q_cap(self));
    const double j = i > 0 ? nck_min(limits.j, self->work.j_cell) : limits.j;
    const double rise = nck_fabs(a - state->a_last);
    const int keeps = nck_fabs(a) <= (1.0 + CHECK_MARGIN) * limits.a
                      && (i == 0 || rise <= (1.0 + CHECK_MARGIN) * j * (state->share + share));
    state->a_last = a;
    state->share = share;
    self->work.j_cell = limits.j;
    return keeps;
}

nck_status_t nck_bounds_check(nck_jerk_t *self, const nck_pieces_t *pieces) {
    if (self->work.coarse || !is_hold(self)) return NCK_DONE;
    inside_t inside = {(const nck_node_t *)0, 0, 0.0, 0.0, 0.0};
    nck_brake_mixed_t mixed = {0};
    for (int n = 0; n < NCK_JERK_STEP && mixed.work < LOOK_MOST; n++) {
        const size_t i = self->work.i;
        if (i >= self->work.n) return NCK_DONE;
        if (!keeps_limits(self, pieces, i, &inside, &mixed)) return NCK_E_STATE;
        self->work.i++;
    }
    return NCK_OK;
}
