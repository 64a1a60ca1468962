// SPDX-License-Identifier: MIT
// A canned cycle of drilling or boring: what holds from line to line, and the holes still to do.
#ifndef NCK_PREP_DECODE_STATE_CYCLE_H
#define NCK_PREP_DECODE_STATE_CYCLE_H

#include <stdint.h> // int64_t

#include "nck/base/limits.h"  // NCK_AXIS_MAX
#include "nck/base/records.h" // NCK_AXIS_X NCK_AXIS_Z

// G87 of mills; G76 has the number of threads: NCK_MOTION_SCREW.
enum { NCK_MOTION_BORE_BACK = 870 };

enum { NCK_CIRCLES_RING = 2 }; // of circles, below

// Places in level_nm.
enum { NCK_LEVEL_R, NCK_LEVEL_BOTTOM, NCK_LEVEL_CLEAR, NCK_LEVEL_CUT };

// All of it.
typedef NCK_CYCLE_STATE nck_cycle {
    uint32_t said;       // letters of words that hold: R Q P, Z for the depth whatever its axis
    uint8_t to_r;        // 1: G99
    uint8_t does;        // what the cycle has, cycle.c
    uint8_t phase;       // of the hole in work, cycle.c
    uint8_t circles;     // 1: steps lead from hole to hole on a circle; 2: holes of a ring
    uint8_t turns;       // 3, 4: of M3 or M4 that comes first; 0: the spindle turns
    double lead;         // of a tap [mm]
    int64_t r_nm;        // R as said; Fanuc: the level, program coordinates
    int64_t depth_nm;    // of the bottom: the same
    int64_t peck_nm;     // Q
    int64_t initial_nm;  // where the drill stood when the first cycle began, program coordinates
    int64_t shift_nm[2]; // Q, or I and J: how far a boring tool steps aside in the plane
    double dwell_s;      // P

    uint32_t holes;      // left, the one in work included; 0: none in work
    uint32_t drill;      // the axis
    int64_t level_nm[4]; // of the drill: R, bottom, where it retracts to, how deep it has cut;
                         // machine positions
    int64_t hole_nm[NCK_AXIS_MAX]; // machine position of the hole; the drill does not count
    int64_t step_nm[NCK_AXIS_MAX]; // from a hole to the next
    double feed;         // as a block has it
    int64_t ring_nm;     // of a ring: its radius; the centre stands in step_nm
    double ring_angle;   // of its first hole [deg]
    double ring_step;    // from hole to hole [deg]
    uint32_t ring_at;    // the hole in work, from 0 on
} nck_cycle_t;

// Whether a motion in tenths is a canned cycle.
static inline int nck_motion_is_cycle(int32_t motion) { return motion > 30 && motion != 800; }

// The axis that a cycle of lathes drills along: from G87 on X.
static inline unsigned nck_motion_drill_of_lathe(int32_t motion) {
    return motion >= NCK_MOTION_BORE_BACK ? NCK_AXIS_X : NCK_AXIS_Z;
}

#endif
