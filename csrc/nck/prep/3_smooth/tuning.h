// SPDX-License-Identifier: MIT
// The numbers of room 3 that were found by trying: [unit], reason, and what pays for it. What each
// buys is told by `pycnc lab bench rules`.
#ifndef NCK_PREP_SMOOTH_TUNING_H
#define NCK_PREP_SMOOTH_TUNING_H

#include "nck/base/real.h" // nck_num

// ---- the program

// How long joining makes a line [knots at the feed]: nothing looks closer. Chords that come one by
// one, joined to twice of it, take 2 % more, up to 20 %.
#define NCK_TRACK_JOINED 0.5
// Where a feed is even it is so by so much more a mm [1]: knots grow there (lathes).
#define NCK_TRACK_EVENS 40.0
// Kept of P [mm]: setpoints are whole nanometres.
#define NCK_ROUNDING 2e-6

// ---- the clock

// How far the guess looks [knots at the feed]: what bends further apart ask for its passes know.
#define NCK_TIMING_REACH 15.0
// Of A, what it builds up speed with [1].
#define NCK_TIMING_ASK NCK_NUM_OF(0.7)
// Of J, what it leaves a rest with [1]: with 0.7 first curves fail (coarse chords: 8 %).
#define NCK_TIMING_LEAVE 0.4
// A knot on a line lasts τ, or so much of the way to the line's next end [1]: without it four times
// as many soft machines take 1 % longer than with stops. Knots grow no faster than √(so much J/v) a
// second [1]: what the clock has of jerk, v(ṁ/m)², the motion takes away again (zigzags).
#define NCK_TIMING_GROWS NCK_NUM_OF(0.04)
#define NCK_TIMING_SWINGS NCK_NUM_OF(0.1)
// By what a feed a revolution changes from knot to knot at most [1] (lathes).
#define NCK_TIMING_TURNS NCK_NUM_OF(0.001)
// Each of two means [knots]: about as long as acceleration takes to change.
#define NCK_TIMING_BLUR 4.0
// Of A, what kept places give way to alone [1].
#define NCK_TIMING_KEEP_ASK NCK_NUM_OF(1.5)
// By what a plan may speed the clock up at once [1].
#define NCK_TIMING_FASTEST NCK_NUM_OF(1.5)

// ---- the curve

// Of P, what samples may use [1]: the solver is done when it is near.
#define NCK_STREAM_SHARE 0.98
// Of an interval, what s may change by from the clock's [1]: more is a seam off the line.
#define NCK_REFERENCE_FOLLOWS 0.05
// What the fourth power of a share of jerk counts beside its square [1] (noise, polygons).
#define NCK_STREAM_EVEN NCK_NUM_OF(4)
// What being off its samples counts [1]: without it a third more iterations; and at least so many
// ε scale², below which a wide P's matrix has no inverse.
#define NCK_STREAM_STAY NCK_NUM_OF(0.03)
#define NCK_STREAM_FIRM NCK_NUM_OF(16)
// How near the best it is [1], and so many times that along the guess: 5.5 iterations for 8.9.
#define NCK_STREAM_GAP 0.1
#define NCK_STREAM_FIRST_GAP NCK_NUM_OF(10)
// What a slack may be off at the end [P² a gap]; a cost that is as good as none [1 a row].
#define NCK_FAIR_SOUND NCK_NUM_OF(0.02)
#define NCK_FAIR_SMALL NCK_NUM_OF(0.02)
// By which a sample is worse before a row changes to it [P²]: less, and they take turns (noise).
#define NCK_FAIR_BETTER NCK_NUM_OF(0.02)

// ---- windows

// Clocks [1]: a fifth wins nothing, a third one alone 1 % less in corners.
#define NCK_STREAM_ROUNDS 4
// Over which a plan comes into the clock behind what is given [knots].
#define NCK_STREAM_BLEND 40
// What of a plan knows too little of what follows, and what of a clock matters to what is given
// [knots]: without it a lathe's facing falls to 0.88 of its feed.
#define NCK_STREAM_OPEN 12
// Looked at behind a seam, where to put it [knots]: with one it comes to lie in a bend (zigzags). A
// seam further ahead holds less than so much of the next [1].
#define NCK_STREAM_NEXT 8
#define NCK_STREAM_RELAXED NCK_NUM_OF(0.5)
// Curves that may miss P, half of them along plans' clocks: a slow enough one always has one.
#define NCK_STREAM_TRIES 20
// Of a stretch, where its bound is not within P: with 4 loops smaller than P take 1.5 % more.
#define NCK_SAMPLE_PARTS 8
#define NCK_SAMPLE_REST 6 // in which a curve comes to rest behind a seam [intervals]

#endif
