// SPDX-License-Identifier: MIT
// The ladder of the jerk-limited slope: nodes are laid on the pieces, capped, and drawn as cells.
// Inside of the room.
#ifndef NCK_PREP_WINDOW_H
#define NCK_PREP_WINDOW_H

#include "nck/prep/5_slope/jerk.h" // nck_jerk_t nck_pieces_t

// How much one step and one plan take on.
enum {
    NCK_JERK_STEP = NCK_PROFILE > 2048 ? 128 : 32, // units of work in one bounded step
    // 1: steps take much the same, as short servo cycles want it.
    NCK_JERK_EVEN = NCK_PROFILE > 1024 && NCK_PROFILE <= 2048,
    NCK_JERK_NODES = NCK_JERK_EVEN ? 96 : NCK_JERK_STEP, // of a pass over the profile in a step
    NCK_JERK_LOADED = NCK_JERK_EVEN ? NCK_JERK_STEP : NCK_PROFILE_ROWS, // and of those taken over
    NCK_JERK_PIECES = NCK_WINDOW - 8,              // pieces of room 4 that plans may use
    NCK_JERK_CELLS = NCK_PROFILE_ROWS - 1
};

// A length beyond every ladder's.
#define NCK_JERK_UNKNOWN 1e6
// A cap beyond every speed's square.
#define NCK_WINDOW_UNCAPPED 1e18
// A part of a piece is rounding if it is shorter than this share of a cell, or of the coordinate
// in its seg.
#define NCK_WINDOW_LENGTH_EPSILON 1e-9
#define NCK_WINDOW_PLACE_EPSILON 1e-14

// Longest duration of a cell that counts in rule R; none while the ladder is coarse.
double nck_window_q_cap(const nck_jerk_t *self);

// Cap of a piece under the overrides that the plan is made for, v². Cost: constant.
static inline double nck_window_cap(const nck_jerk_t *self, const nck_node_t *piece) {
    return nck_plan_cap(piece, &self->job.wish, self->work.over);
}

// Cap of the node at a piece's start, v². Cost: constant.
static inline double nck_window_node_cap(const nck_jerk_t *self, const nck_node_t *piece) {
    return self->work.over ? piece->vv_node : piece->vv_cap;
}

// What is only rounding beside a length of path that ends in or with a piece. Cost: constant.
static inline double nck_window_rounding(const nck_node_t *piece, double length) {
    const double end = piece->s + piece->length;
    return NCK_WINDOW_LENGTH_EPSILON * length + NCK_WINDOW_PLACE_EPSILON * end;
}

// 1 if the speed in a cell stays what it is, but for rounding. Cost: constant.
static inline int nck_window_is_even(const nck_cell_t *cell) {
    return nck_fabs(cell->a) * cell->duration <= NCK_WINDOW_LENGTH_EPSILON * cell->v;
}

// In how many parts a cell of an earlier plan is taken over; a hold's ladder is divided later.
// Cost: constant.
int nck_window_parts(const nck_jerk_t *self, const nck_cell_t *cell, int is_hold);

// Take over cells of an earlier plan, the long ones divided. NCK_OK: call again; NCK_DONE.
// Cost: bounded.
nck_status_t nck_window_load(nck_jerk_t *self, const nck_pieces_t *pieces);

// 1 if the path rests where the cells taken over end. Cost: constant.
int nck_window_rests(const nck_jerk_t *self, const nck_pieces_t *pieces);

// Lay more cells behind them. NCK_OK: call again; NCK_EMPTY: needs pieces; NCK_DONE. Cost: bounded.
nck_status_t nck_window_lay(nck_jerk_t *self, const nck_pieces_t *pieces);

#endif
