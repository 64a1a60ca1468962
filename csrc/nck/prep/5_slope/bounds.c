// SPDX-License-Identifier: MIT
// Inside room 5: caps and limits of the cells of a ladder, and whether a hold keeps to them.
#include "nck/prep/5_slope/bounds.h"

#include "nck/base/real.h"              // nck_min nck_max
#include "nck/prep/5_slope/brake.h"     // nck_brake_along nck_brake_relax
#include "nck/prep/5_slope/hull_math.h" // nck_hull_share
#include "nck/prep/5_slope/window.h"    // nck_window_…

// Samples at the seam hold both the constant jerk before a ladder and its jumps of acceleration. So
// a ladder's acceleration all but stays for so many periods (README, section "S-shape").
#define SEAM_PERIODS 0.25
#define SEAM_SHARE 0.02
// A plan made anew with what is left at the speeds tried last: it may be faster by so much.
#define TRIED_ABOVE 1.02
// Room for rounding.
#define CHECK_MARGIN 1e-6

// 1 if this is a hold that takes what bends leave at lower speeds.
static int relaxes(const nck_jerk_t *self) {
    return self->work.reach > 0.0 && !self->work.as_capped;
}

// The larger speed at a cell's ends in the plan tried last, which ends at rest.
static double tried_speed(const nck_jerk_t *self, uint32_t i) {
    const double end = i + 1 < self->work.n ? self->w[i + 1] : 0.0;
    return nck_sqrt(nck_max(self->w[i], end));
}

// Path behind constant jerk.
static double seam_of(const nck_jerk_t *self) {
    return self->profile.q > 0.0 ? 0.0 : SEAM_PERIODS * self->machine->period_s * self->profile.v;
}

// A cell keeps to the limits of every piece that it touches, and its nodes to the caps of the nodes
// that it passes over. Returns the cap inside of it, v².
static double limits_of(const nck_jerk_t *self, const nck_pieces_t *pieces, uint32_t i,
                        nck_brake_limits_t *limits) {
    uint32_t number = self->rung_piece[i];
    const nck_node_t *piece = nck_plan_piece(pieces, number);
    const int over = self->work.over != 0;
    double w_cell = nck_window_cap(self, piece);
    double a = over ? piece->a_over : piece->a;
    double j = over ? piece->j_over : piece->j;
    double left = self->h[i] - (piece->s + piece->length - self->rung_s[i]);
    while (left > nck_window_rounding(piece, self->h[i])) {
        piece = nck_plan_piece(pieces, ++number);
        if (!piece) break;
        w_cell = nck_min(w_cell, nck_window_node_cap(self, piece));
        w_cell = nck_min(w_cell, nck_window_cap(self, piece));
        a = nck_min(a, over ? piece->a_over : piece->a);
        j = nck_min(j, over ? piece->j_over : piece->j);
        left -= piece->length;
    }
    limits->a = a;
    limits->j = j * self->j_scale;
    return w_cell;
}

static void limit_cell(nck_jerk_t *self, const nck_pieces_t *pieces, uint32_t i) {
    const nck_node_t *const piece = nck_plan_piece(pieces, self->rung_piece[i]);
    nck_brake_limits_t limits;
    const double w_cell = limits_of(self, pieces, i, &limits);
    const int begins = self->rung_s[i] == piece->s;
    double w_node = begins ? nck_window_node_cap(self, piece) : NCK_WINDOW_UNCAPPED;
    if (i > 0) w_node = nck_min(w_node, self->work.w_cell);
    if (i == 0) self->work.seam = seam_of(self);
    if (self->work.seam > 0.0) limits.j *= SEAM_SHARE;
    self->work.seam -= self->h[i];
    self->work.w_cell = w_cell;
    self->w_cap[i] = nck_min(w_node, w_cell);
    if (relaxes(self) && self->work.redone > 0) {
        const double v = TRIED_ABOVE * tried_speed(self, i);
        nck_brake_relax(self, pieces, self->rung_piece[i], v, &limits);
    }
    self->a_max[i] = limits.a;
    self->j_max[i] = limits.j;
    if (relaxes(self) && self->work.redone == 0) nck_brake_along(self, pieces, i);
}

// A window or a hold that ends in the cell behind a rest ends at that rest.
static void end_at_rest(nck_jerk_t *self) {
    const uint32_t last = self->work.n - 1;
    const int may_end = !self->next->complete || self->work.reach > 0.0;
    if (!may_end || last == 0 || self->w_cap[last] > 0.0) return;
    self->work.n = last;
    self->next->n = last;
    self->next->end_piece = self->rung_piece[last];
    self->next->end_s = self->rung_s[last];
}

nck_status_t nck_bounds_set(nck_jerk_t *self, const nck_pieces_t *pieces) {
    for (int n = 0; n < NCK_JERK_STEP; n++) {
        if (self->work.i == self->work.n) {
            end_at_rest(self);
            return NCK_DONE;
        }
        limit_cell(self, pieces, self->work.i);
        self->work.i++;
    }
    return NCK_OK;
}


// ---- check

// 1 if a cell of the plan keeps to what its bends leave at the speed that it has in the end.
static int keeps_limits(nck_jerk_t *self, const nck_pieces_t *pieces, uint32_t i) {
    nck_profile_t *const state = &self->profile;
    nck_brake_limits_t limits;
    (void)limits_of(self, pieces, i, &limits);
    nck_brake_relax(self, pieces, self->rung_piece[i], tried_speed(self, i), &limits);
    const double end = i + 1 < self->work.n ? self->w[i + 1] : 0.0;
    const double a = 0.5 * (end - self->w[i]) / self->h[i];
    const double v_sum = nck_sqrt(self->w[i]) + nck_sqrt(end);
    const double share = nck_hull_share(self->h[i], v_sum, nck_window_q_cap(self));
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
    if (!relaxes(self) || self->work.coarse) return NCK_DONE;
    for (int n = 0; n < NCK_JERK_STEP; n++) {
        if (self->work.i == self->work.n) return NCK_DONE;
        if (!keeps_limits(self, pieces, self->work.i)) return NCK_E_STATE;
        self->work.i++;
    }
    return NCK_OK;
}
