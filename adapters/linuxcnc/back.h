// SPDX-License-Identifier: MIT
// The kernel begins anew where the tool rests, with the moves that are kept: the other way, for
// running in reverse, or as exact ones, for single block. So its limits hold, and the path is
// within the tolerance of what is programmed.
#ifndef BACK_H
#define BACK_H

#include "planner.h" // planner_t

// The kernel has begun anew: it goes the way that the operator wants, from the tool's place on. at:
// of that, the programmed path up to the tool [mm].
// Cost: linear in the moves. Context: servo thread.
void back_begin(planner_t *self, double at);

// Hear of single block. Along a curve within a tolerance moves have no ends: what runs is begun
// anew, as exact moves, and at rest behind it as what they are. Returns 1 if the kernel lets go of
// what it has. Cost: constant. Context: servo thread.
int back_single(planner_t *self, uint32_t single);

#endif
