// SPDX-License-Identifier: MIT
// Passes in step with the spindle: when one begins, what it tells, and what comes behind it.
#ifndef THREAD_H
#define THREAD_H

#include "planner.h" // planner_t

// 1 if the next entry of the ring begins a pass and the kernel rests; what comes behind joins in.
// Cost: constant. Context: servo thread, as all below.
int thread_begins(const planner_t *self);

// Begin it: the spindle is asked for its index. Cost: linear in its lines.
void thread_begin(planner_t *self);

// One cycle. Returns 1, or 0 at rest at its end. Cost: that of follow_cycle.
int thread_cycle(planner_t *self, const planner_wish_t *wish, double *place_out);

// Which of its lines is in work. Cost: linear in its lines.
void thread_tell(planner_t *self);

// Come to rest and drop the rest. Cost: constant.
void thread_stop(planner_t *self);

// It is behind the tool. Cost: constant.
void thread_end(planner_t *self);

#endif
