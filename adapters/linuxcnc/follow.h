// SPDX-License-Identifier: MIT
// Motion whose time is the spindle's angle: threads and rigid taps.
//
// The way is a function of the angle: line behind line, each with a lead of its own. It has kinks:
// where it begins, turns a corner, changes its lead, ends. It is handed out as its mean under a
// triangle of 2n cycles, which makes each kink an S-shaped ramp within the limits. What comes is
// known a little ahead, because the angle is: it is taken n cycles before it is there, so that at
// constant speed the tool is where the angle asks for, to rounding.
//
// Lines may come while it cuts. n stays what it was then, and a kink that is too large for it is
// rounded: the way there is its mean over 2w revolutions more.
#ifndef FOLLOW_H
#define FOLLOW_H

#include <stdint.h> // uint32_t

enum {
    FOLLOW_AXES = 9,
    FOLLOW_LINES = 64, // known at a time, the one behind the tool among them; power of two
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

// What the axes can.
typedef struct follow_limits {
    double v[FOLLOW_AXES]; // [mm/s]; 0: no such axis
    double a[FOLLOW_AXES]; // [mm/s²]
    double j[FOLLOW_AXES]; // [mm/s³]; INFINITY: no limit
} follow_limits_t;

// Where a line ends and the next one begins.
typedef struct follow_node {
    uint32_t move;     // name of the line that ends here
    double u;          // of the way [revolutions]
    double w;          // it is rounded so far to both sides [revolutions]
    double lead;       // of the line that ends here [mm]
    double v_most;     // of that line [revolutions/s]
    double a_most;     // [revolutions/s²]
    double used;       // of what the axes bear, what its kink takes with those before it
    double v_stop;     // from which the means make a stop within the limits [revolutions/s]
    double place[FOLLOW_AXES];
} follow_node_t;

// Lines one behind the other.
typedef struct follow {
    uint32_t phase;    // follow_phase_t
    uint32_t tail;     // the oldest node that is kept
    uint32_t head;     // the last one; the first one of all is 0
    uint32_t n;        // cycles of each of two means
    uint32_t at;       // oldest of the samples
    uint32_t settled;  // samples of the way's end
    uint32_t open;     // 1: more lines may come; the owner writes
    uint32_t taps;     // 1: back at the end, by the spindle
    uint32_t stops;    // 1: an abort
    uint32_t eased;    // cycles that a stop is still in the means
    double stopped;    // of what the means bear, what that stop took
    double cycle_s;
    double rps;        // the most that the spindle is to turn [1/s]
    double share;      // of the axes' acceleration, the least that a line may have
    double begin;      // angle at which it begins [revolutions]; 0: not known yet
    double u;          // of the way, where the sample is [revolutions]
    double step;       // of u in the last cycle
    double asked;      // u as the angle has it
    double v_back;     // where a tap comes out [revolutions/s]
    follow_limits_t limits;
    follow_node_t node[FOLLOW_LINES];
    double first[FOLLOW_HALF][FOLLOW_AXES];  // samples of the way
    double second[FOLLOW_HALF][FOLLOW_AXES]; // means of them
} follow_t;

// Begin a pass at a place, for a spindle of so many revolutions a second: it waits for the index.
// Cost: constant. Context: servo thread, as all below.
void follow_begin(follow_t *self, const double *place, double rps, double cycle_s);

// One more line: to `end`, `lead` > 0 [mm] a revolution; share: of the axes' acceleration that it
// may have. Returns 1; 0 if there is no room now, or the tool is too near for so large a kink.
// Cost: linear in the lines.
int follow_line(follow_t *self, const double *end, double lead, double share, uint32_t move);

// 1 if another line has room. Cost: constant.
int follow_has_room(const follow_t *self);

// The index has passed, from which angles count. Cost: linear in FOLLOW_HALF.
void follow_index(follow_t *self, double rps);

// One cycle: the angle since the index, and how fast it turns. Returns 1, or 0 at rest at the end.
// Cost: linear in FOLLOW_HALF.
int follow_cycle(follow_t *self, double turns, double rps, double *place_out);

// Come to rest where it is. Cost: constant.
void follow_stop(follow_t *self);

// Hundreds of instructions that a cycle takes at most while no line comes. Cost: constant.
uint32_t follow_price(const follow_t *self);

// Where it comes to rest, as far as it is known: a tap where it began. Cost: constant.
const double *follow_end(const follow_t *self);

// The line in work, and how far its end is [mm]. Cost: linear in the lines.
uint32_t follow_move(const follow_t *self, double *to_go_out);

#endif
