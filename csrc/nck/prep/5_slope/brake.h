// SPDX-License-Identifier: MIT
// Inside room 5: how a hold brakes along the ladder of the jerk-limited slope.
#ifndef NCK_PREP_BRAKE_H
#define NCK_PREP_BRAKE_H

#include "nck/prep/5_slope/jerk.h" // nck_jerk_t nck_pieces_t nck_profile_t

// The brake keeps off the limits by so much, so that the plan above it finds room.
#define NCK_BRAKE_SHARE 0.98

// What a piece leaves to the path. j counts in rule R: a share of the piece's own.
typedef struct nck_brake_limits {
    double a; // [path mm/s²]
    double j; // [path mm/s³]
} nck_brake_limits_t;

// What the output filter mixes around a place, kept for the cells that follow, where mostly it is
// the same. All zero: nothing yet. It holds within one step.
typedef struct nck_brake_mixed {
    uint32_t number;               // of the piece
    uint32_t work;                 // done so far: pieces that were looked at, and so on
    double least, most;            // it holds for distances between them [mm]
    double vv;                     // the smallest cap, v²; 0: not known so far
    double a_rest, j_rest, q_rest; // what the pieces leave at standstill (nck_node_t), at least
} nck_brake_mixed_t;

// Brake from the profile's entry state; v_last, a_last and share of the profile are the brake's.
// Cost: constant.
void nck_brake_begin(nck_profile_t *state, double q_cap);

// v² after a cell of length h under rising deceleration. Cost: constant.
double nck_brake_cell(nck_profile_t *state, double h, double a_max, double j, double q_cap);

// Under full deceleration from here on the speed would be gone: by then the acceleration must be
// back at zero, over  |a|³/(6J²)  of path from the speed  a²/(2J). Cost: constant.
int nck_brake_rests(const nck_profile_t *state, double j);

// A piece's limits hold at its cap; raise them to what they are at speed v at least. README,
// section "Hold". Cost: linear in the pieces that the output filter mixes at v.
void nck_brake_relax(const nck_jerk_t *self, const nck_pieces_t *pieces, uint32_t number, double v,
                     nck_brake_mixed_t *mixed, nck_brake_limits_t *limits);

// How far a hold brakes: work.reach. NCK_OK: call again; NCK_EMPTY: the plan of now rests before;
// NCK_DONE. Cost: bounded.
nck_status_t nck_brake_reach(nck_jerk_t *self, const nck_pieces_t *pieces);

// A hold brakes with what bends leave at the speed that it has by then, and keeps below that speed:
// limits and cap of cell i of the ladder. Cells in their order. tried: the speed that the plan made
// before it has there, which may be more; 0: there was none. Cost: that of nck_brake_relax.
void nck_brake_along(nck_jerk_t *self, const nck_pieces_t *pieces, uint32_t i, double tried,
                     nck_brake_mixed_t *mixed);

// Where limits step down, a brake has to give way in front of the step: what it may take of every
// cell's acceleration, in the link's spare memory, for nck_brake_raise. NCK_OK: call again;
// NCK_DONE. Cost: bounded.
nck_status_t nck_brake_ease(nck_jerk_t *self);

// Raise the caps to where the path can brake to from its entry speed: an override may have lowered
// them below that. NCK_OK: call again; NCK_DONE. Cost: bounded.
nck_status_t nck_brake_raise(nck_jerk_t *self);

#endif
