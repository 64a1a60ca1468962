// SPDX-License-Identifier: MIT
// How fast: the overrides that the host wants, caps of moves, and feeds a revolution, which follow
// the spindle as it turns now. The kernel knows one override for all the feeds it has.
#ifndef RATES_H
#define RATES_H

#include "planner.h" // planner_t planner_wish_t

// What is wanted, and how fast the spindle turns. Cost: constant. Context: servo thread, as all
// below; once a cycle.
void rates_measure(planner_t *self, const planner_wish_t *wish);

// Tell the kernel what is wanted of it. Cost: linear in the moves that it has.
void rates_hear(planner_t *self, const planner_wish_t *wish);

// 1 if an override of none keeps the tool at the end of the move in work: the next one's is its own
// (M49). Cost: constant.
int rates_keep_behind(const planner_t *self);

// 1 if the entry that the kernel is to take next has a feed of the other sort than those it has, by
// the minute and by the revolution: those are executed before. Cost: constant.
int rates_wait(const planner_t *self);

// The part of the entry that the kernel is to take next: under G96 a line is fed in parts, each as
// the spindle will turn there. Cost: constant.
void rates_part(planner_t *self);

// The feed of the block that the entry to be taken next has become; what it asks of the override is
// told at once where the tool rests. Cost: linear in the moves that the kernel has.
void rates_bound(planner_t *self, nck_block_in_t *block);

#endif
