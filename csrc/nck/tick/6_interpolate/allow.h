// SPDX-License-Identifier: MIT
// Inside room 6: what every axis allows of k″, where the clock goes along a plan at the pace k, k′.
#ifndef NCK_TICK_ALLOW_H
#define NCK_TICK_ALLOW_H

#include "nck/base/real.h"                  // nck_num
#include "nck/tick/6_interpolate/stretch.h" // nck_stretch_…

// A pace.
typedef struct nck_allow_pace {
    nck_num k;   // dφ/dt
    nck_num dk;  // dk/dt [1/s]
    nck_num way; // -1: it slows down, 1: it sets off
} nck_allow_pace_t;

// What all axes allow of k″ [1/s²].
typedef struct nck_allow {
    nck_num low, high;
    nck_num low_is, high_is; // what one of k″ is to the axis that says so, of its limit
} nck_allow_t;

// The samples of an axis by k″, from what a period has anyway: jerk + (per + bend·k″)·k″, of
// acceleration a period's. Pairs are of acceleration [mm/s²] and of jerk [mm/s³].
typedef struct nck_allow_sample {
    nck_num is[2];
    nck_num plan[2]; // what of them the plan asks for at the same rate
    nck_num way[2];  // from their first place to their last, at rest as the plan goes [mm]
    nck_num per, bend;
} nck_allow_sample_t;

// A period.
typedef struct nck_allow_period {
    const nck_stretch_past_t *past; // up to its begin
    double t;                       // which is there in the walk's cell [s]
    double far;                     // along the plan, by the k″ that it has anyway [s]
    nck_num change;                 // 0, or by which it does not go back [1/s²]
} nck_allow_period_t;

// What is allowed on a stretch that takes so long [s], of so much of the limits.
// Cost: 4 bounds for each axis that moves. Context: tick.
void nck_allow_all(nck_allow_t *range, const nck_stretch_walk_t *walk, const nck_stretch_t *on,
                   const nck_allow_pace_t *pace, nck_num time, nck_num share);

// Where all axes allow nothing together: so that both are passed by the same share. One that hardly
// hears of k″ has no say. Cost: constant. Context: tick.
nck_num nck_allow_between(const nck_allow_t *range);

// The samples of each axis. at: where the walk is, at its begin. Cost: a point and a look.
// Context: tick.
void nck_allow_look(nck_allow_sample_t *samples, const nck_stretch_walk_t *walk,
                    const nck_allow_period_t *period, const nck_stretch_point_t *at,
                    const nck_allow_pace_t *pace);

// What of k″ they allow beyond what the period has anyway, of so much of the limits.
// Cost: two bounds for each axis. Context: tick.
void nck_allow_now(nck_allow_t *range, const nck_stretch_walk_t *walk,
                   const nck_allow_sample_t *samples, nck_num share);

// What k″ may be where the plan itself asks for nothing. Cost: linear in the axes. Context: tick.
nck_num nck_allow_free(const nck_stretch_walk_t *walk, const nck_stretch_point_t *at);

#endif
