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

// … in a period in which the plan's jerk jumps.
typedef struct nck_allow_parts {
    nck_allow_t each; // by jerk in each of its parts
    nck_allow_t ends; // by what the samples show that weigh its begin more than its end, and less
} nck_allow_parts_t;

// What is allowed on a stretch that takes so long [s], of so much of the limits.
// Cost: 4 bounds for each axis that moves. Context: tick.
void nck_allow_all(nck_allow_t *range, const nck_stretch_walk_t *walk, const nck_stretch_t *on,
                   const nck_allow_pace_t *pace, nck_num time, nck_num share);

// Where all axes allow nothing together: so that both are passed by the same share. One that hardly
// hears of k″ has no say. Cost: constant. Context: tick.
nck_num nck_allow_between(const nck_allow_t *range);

// What is allowed of jerk in the period that begins where the walk does, far along the plan. The
// plan's jerk jumps between its cells, and a sample weighs the begin of a period and its end
// unlike. The walk stands behind it then. on: its end is where the walk is.
// Cost: 8 parts at most, each with two bounds for each axis that moves. Context: tick.
void nck_allow_parts(nck_allow_parts_t *parts, nck_stretch_walk_t *walk,
                     const nck_allow_pace_t *pace, nck_num far, nck_num share, nck_stretch_t *on);

// What k″ may be where the plan itself asks for nothing. Cost: linear in the axes. Context: tick.
nck_num nck_allow_free(const nck_stretch_walk_t *walk, const nck_stretch_point_t *at);

#endif
