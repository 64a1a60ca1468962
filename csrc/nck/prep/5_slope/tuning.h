// SPDX-License-Identifier: MIT
// The numbers of room 5's optimal planner that were found by trying: [unit], reason, and what pays
// for it. What each buys is told by `pycnc lab bench rules`.
#ifndef NCK_PREP_SLOPE_TUNING_H
#define NCK_PREP_SLOPE_TUNING_H

// ---- knots of a clocked path

// So much of ∛(P/J), which is what a corner within P takes [1], for this P [mm] and the highest J.
#define NCK_KNOT_SHARE 0.4
#define NCK_KNOT_TOLERANCE 0.01
// Where they are more of it for a smaller P no curve is sought [1]: corners are rested at. With 1.2
// what is 0.2 µm on a PC, 1 µm in single precision, takes 2.5 times as long, up to 40.
#define NCK_KNOT_SHARE_MOST 1.6
// A window lasts so many stops [1]: with 1, two of 600 machines take 6 and 12 % longer. With few
// knots, in single precision, it lasts longer: each has its share of a core. Knots are raised for
// it by so much at most [1].
#define NCK_KNOT_STOPS 1.5
#define NCK_KNOT_STOPS_SINGLE 3.76
#define NCK_KNOT_RAISE 1.75
// Where nothing is near a knot may take that part of a stop [1/1]: where it takes all of it
// overrides that come down are late by twice as much.
#define NCK_KNOT_PARTS 8.0

// ---- plans

// Before the brake for its window's end, what of a plan does not become final [intervals]: without
// it feeds a revolution lag by 1.3 % behind a spindle that changes its speed, up to 8 %.
#define NCK_OPTIMAL_COMMIT_OFF 4
// Cells behind which another plan is tried where none joined: some two intervals, so a window has
// most of its way left; of a brake besides those that the last try took.
#define NCK_SLOPE_NO_MOTION 4
// Of an axis' jerk, what a cell may be off its plan by [1], and cells of half an interval at most,
// where a slower feed begins: with 4 a jerk is passed by 1.5 % in the worst of 600 programs whose
// overrides come down, with 8 by 0.4 %.
#define NCK_OPTIMAL_CELL_SHARE 0.003
#define NCK_OPTIMAL_PARTS 16

// ---- overrides that come down

// Price of being faster than a lowered cap [halves of the time that this wins by itself]: more than
// all the way before it wins, which then is slower, too. Of 133 overrides 9 in 10 take 1.29 of a
// brake along a line or less; with 2 entries of slower feeds are passed too fast, with 25 a plan
// needs 40 iterations in place of 30.
#define NCK_OPTIMAL_SLOWER_PRICE 5.0
// Of the speed now, what one plan is slowed down to at least [1]: 25 to 40 iterations; the next one
// goes on from there, once that is reached. With 0.05 an override of 1 % takes up to 7 times as
// long as a brake along a line, with 0.02 up to 3.4 times; with 0.01 plans find no end in time.
#define NCK_OPTIMAL_SLOWER_LEAST 0.02
#define NCK_OPTIMAL_SLOWER_NODES 48 // within which lowered caps are looked for: as a brake takes

#endif
