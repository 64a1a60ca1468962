// SPDX-License-Identifier: MIT
// Numbers that the curve (3_smooth) and the motion along it (5_slope, motion.h) have in common.
#ifndef NCK_BASE_TUNING_H
#define NCK_BASE_TUNING_H

#include "nck/base/real.h" // NCK_NUM_OF

// Of the way to the nearest limit of an interior point method, what a step goes [1]: 0.95 to 0.99
// are alike.
#define NCK_WAY NCK_NUM_OF(0.97)
// What the slack of a row that is broken begins with, as a share of its limit [1]: 0.1 and 1 are
// alike in time; with 1 curves take 4 % more work.
#define NCK_ROOM 0.3
// Of the complement of slacks and prices, what a step leads to, and of itself what a multiplier
// falls to at least [1]: 0.15 and 0.3 are alike; with 0.3 a line may run 0.3 % below its feed.
#define NCK_FALL NCK_NUM_OF(0.2)
// Of a gap, what the last steps aim at [1]: with all of it curves take twice the work.
#define NCK_AIM NCK_NUM_OF(0.4)
// What is asked of the last digits: a limit is met, or passed between rows, by so much of itself
// [1]. Setpoints' jerk is known no better.
#define NCK_MET 1e-3
// Iterations of a curve or of a motion at most: windows of random polygons take 14 to 44.
#define NCK_ITERATIONS 60
#define NCK_FURTHER 64 // intervals of what follows that what becomes final has to know: 0.25 s
// Of the time, what a plan may be away from the fastest, and in the mean from its clock [1]: 20
// iterations; 0.05 saves two of them and costs 0.4 %.
#define NCK_GAP 0.02
// Of the clock's pace, of the last plan's and of limits, what a clock and a motion begin to be
// sought with [1]. Too slow a start is dear: a Newton step raises b by two thirds at most.
#define NCK_START 0.8
// μ of a motion's first multipliers, as a share of its time [1]: larger ones are slow, smaller ones
// let the first steps run into a corner of the limits. The share that it stays at while a limit is
// broken by all of itself: rows that come late find others with no slack to give way.
#define NCK_MOTION_FIRST NCK_NUM_OF(2)
#define NCK_MOTION_BROKEN NCK_NUM_OF(0.3)
// What of the price for excess is time that a gap is a share of [1]: all of it would leave the rest
// of the motion to chance, none asks for the last digits.
#define NCK_MOTION_PAID NCK_NUM_OF(0.1)
// A last step of so much was a Newton step nearly whole [1]: the gradient is no more than rounding.
#define NCK_MOTION_WHOLE NCK_NUM_OF(0.9)

#endif
