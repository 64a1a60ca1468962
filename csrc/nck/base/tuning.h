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

// What is asked of the last digits: a limit is met, or passed between rows, by so much of itself
// [1]. Setpoints' jerk is known no better.
#define NCK_MET 1e-3

// Iterations of a curve or of a motion at most: 40 are as many for curves, and windows of random
// polygons take 14 to 44, one that slows down up to 47.
#define NCK_ITERATIONS 60

// Intervals of what follows that what becomes final has to know: a quarter of a second.
#define NCK_FURTHER 64

// Of the time, what a plan may be away from the fastest, and in the mean from its clock [1]: 20
// iterations; 0.05 saves two of them and costs 0.4 %.
#define NCK_GAP 0.02

// Of the clock's pace, of the last plan's and of limits, what a clock and a motion begin to be
// sought with [1]. Too slow a start is dear: a Newton step raises b by two thirds at most.
#define NCK_START 0.8

#endif
