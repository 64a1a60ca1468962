// SPDX-License-Identifier: MIT
// From the ring of moves into the kernel: limits, moves, and when what is there counts as all.
#ifndef FEED_H
#define FEED_H

#include "planner.h" // planner_t

// The host's limits of now; shares stay. Cost: constant.
void feed_bounds(const planner_t *self, bounds_t *bounds);

// The kernel's machine, by the settings and the bounds. Cost: constant.
void feed_machine(const planner_t *self, const bounds_t *bounds, nck_machine_t *machine_out);

// Of limits in the ring: those of what comes before them. Cost: constant.
void feed_before(const move_t *move, bounds_t *bounds_out);

// What the kernel takes next has the shares and jerks of the bounds, and the host's limits of now,
// which are told back. 0: not yet, what is before it has to be planned. Cost: constant.
int feed_limits(planner_t *self, bounds_t *bounds);

// 1 if the kernel has executed all that it was given, and was told that it is all. Cost: constant.
int feed_is_done(const planner_t *self);

// 1 if all that was handed over is executed. Cost: constant.
int feed_is_over(const planner_t *self);

// Preparation for what `budget` leaves beside the tick, one step at least. Cost: they.
void feed_prepare(planner_t *self);

// The same for what comes behind a pass, while the spindle leads and the kernel rests. What hangs
// on the spindle's speed, or on limits of then, waits until the pass is over. Cost: they.
void feed_ahead(planner_t *self);

#endif
