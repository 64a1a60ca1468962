// SPDX-License-Identifier: MIT
// Inside room 6: a stop that an input asks for. Where the axes are is kept, and each brakes
// straight on, whatever the path does there.
//
//        p(t) = p₀ + V·(t − D·(τ³ − τ⁴/2))      τ = t/D      v(t) = V·(1 − 3τ² + 2τ³)
//
// D is the shortest time in which every axis keeps its acceleration, 1.5·V/D, and under a slope
// that knows jerk its jerk, 6·V/D². V is the mean speed of the period in which it begins.
#ifndef NCK_TICK_HALT_H
#define NCK_TICK_HALT_H

#include "nck/base/limits.h"  // NCK_AXIS_MAX
#include "nck/base/records.h" // nck_pose_t
#include "nck/base/terms.h"   // nck_terms_t

// One stop: the caller's memory.
typedef struct nck_halt {
    double quick;             // in: so many times an axis' acceleration and jerk are for it, > 0
    double at[NCK_AXIS_MAX];  // out: where the axes were when it was asked for [mm, deg]
    double way[NCK_AXIS_MAX]; // twice what an axis goes on from there [mm, deg]
    double speed;             // of the path when it began [path mm/s]
    double duration;          // D [s]
    uint32_t periods;         // out: since it has begun; 0: it has not; any reads it
} nck_halt_t;

// From at on, where the path was a period before the pose. Cost: linear in the axes.
// Context: tick.
void nck_halt_plan(nck_halt_t *self, const nck_terms_t *terms, const nck_pose_t *pose);

// One period on: place, speed and state of the pose. Returns 1 at rest. Cost: linear in the axes.
// Context: tick.
int nck_halt_tick(nck_halt_t *self, double period, nck_pose_t *pose);

#endif
