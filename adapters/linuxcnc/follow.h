// SPDX-License-Identifier: MIT
// Motion whose time is the spindle's angle: threads and rigid taps.
//
// The way that the angle asks for has kinks: where it begins, turns a corner, ends. It is handed
// out as its mean under a triangle of 2n cycles, which makes each kink an S-shaped ramp within the
// limits. What comes is known a little ahead, because the angle is: it is taken n cycles before it
// is there, so that at constant speed the tool is where the angle asks for, to rounding.
#ifndef FOLLOW_H
#define FOLLOW_H

#include <stdint.h> // uint32_t

#include "nck/nck.h" // nck_machine_t

enum {
    FOLLOW_AXES = 9,
    FOLLOW_LINES = 64, // lines of one pass
    FOLLOW_HALF = 512  // n is no more [cycles]
};

// How far a pass is.
typedef enum follow_phase {
    FOLLOW_NOT = 0,
    FOLLOW_INDEX = 1,  // waits for the spindle's index
    FOLLOW_CUTS = 2,
    FOLLOW_RETURNS = 3,// a tap: the spindle is to turn the other way, the tool goes back
    FOLLOW_SETTLES = 4 // the way is done, or an abort wants rest: the mean gets there
} follow_phase_t;

// Lines one behind the other.
typedef struct follow {
    uint32_t phase;    // follow_phase_t
    uint32_t lines;
    uint32_t n;        // cycles of each of two means
    uint32_t at;       // oldest of the samples
    uint32_t settled;  // samples of the way's end
    uint32_t taps;     // 1: back at the end, by the spindle
    double lead;       // [mm] a revolution
    double cycle_s;
    double begin;      // angle at which it begins [revolutions]
    double s;          // of the way [mm]
    double step;       // of s in the last cycle
    double asked;      // s as the angle has it
    double v_most;     // of s [mm/s]
    double v_back;     // where a tap comes out
    double a_most;     // of s [mm/s²]
    double reached;    // furthest s
    double end[FOLLOW_LINES + 1]; // s at the lines' ends; [0]: 0
    double point[FOLLOW_LINES + 1][FOLLOW_AXES];
    double first[FOLLOW_HALF][FOLLOW_AXES];  // samples of the way
    double second[FOLLOW_HALF][FOLLOW_AXES]; // means of them
} follow_t;

// Begin a pass at a place; lead > 0 [mm]. Cost: constant. Context: servo thread, as all below.
void follow_begin(follow_t *self, const double *place, double lead, double cycle_s);

// One more line to a place. Returns 1, or 0 if there are FOLLOW_LINES. Cost: constant.
int follow_line(follow_t *self, const double *end);

// All lines are there: how smooth it has to be for a spindle of so many revolutions a second.
// Cost: linear in the lines.
void follow_prepare(follow_t *self, const nck_machine_t *machine, double rps);

// The index has passed, from which angles count. Cost: linear in FOLLOW_HALF.
void follow_index(follow_t *self, double rps);

// One cycle: the angle since the index, and how fast it turns. Returns 1, or 0 at rest at the end.
// Cost: linear in the lines.
int follow_cycle(follow_t *self, double turns, double rps, double *place_out);

// Come to rest where it is. Cost: constant.
void follow_stop(follow_t *self);

// The line in work, from 0. Cost: linear in the lines.
uint32_t follow_at(const follow_t *self);

#endif
