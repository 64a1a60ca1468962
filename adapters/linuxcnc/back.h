// SPDX-License-Identifier: MIT
// Running in reverse: the kernel begins anew where the tool rests, with the moves that are kept,
// the other way. So its limits hold, and the path is within the tolerance of what is programmed.
#ifndef BACK_H
#define BACK_H

#include "planner.h" // planner_t

// The kernel has begun anew: it goes the way that the operator wants, from the tool's place on. at:
// of that, the programmed path up to the tool [mm].
// Cost: linear in the moves. Context: servo thread.
void back_begin(planner_t *self, double at);

#endif
