// SPDX-License-Identifier: MIT
// From the ring of moves into the kernel: limits, moves, and when what is there counts as all.
#ifndef FEED_H
#define FEED_H

#include "planner.h" // planner_t

// The kernel's machine, by the settings and by the limits of now. Cost: constant.
void feed_machine(const planner_t *self, nck_machine_t *machine_out);

// 1 if the limits of now are others than the ones that were set last. Cost: constant.
int feed_limits_changed(const planner_t *self);

// 1 if the kernel has executed all that it was given, and was told that it is all. Cost: constant.
int feed_is_done(const planner_t *self);

// At most settings.budget steps of preparation. Cost: they.
void feed_prepare(planner_t *self);

#endif
