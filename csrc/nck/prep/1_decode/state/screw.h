// SPDX-License-Identifier: MIT
// Threads: a pass alone, and the cycles that make many of them.
#ifndef NCK_PREP_DECODE_STATE_SCREW_H
#define NCK_PREP_DECODE_STATE_SCREW_H

#include <stdint.h> // int64_t

#include "nck/base/limits.h" // NCK_CYCLE_STATE

// Motions in tenths: G33 (Fanuc's system A: G32), G33.1, G76, and the thread cycle as system B
// names it; the cycles that tap (G88: of lathes).
enum {
    NCK_MOTION_PASS = 330, NCK_MOTION_TAP = 331, NCK_MOTION_SCREW = 760, NCK_MOTION_THREAD = 780,
    NCK_MOTION_TAP_LEFT = 740, NCK_MOTION_TAP_RIGHT = 840, NCK_MOTION_TAP_SIDE = 880
};

// Whether a motion in tenths cuts threads.
static inline int nck_motion_cuts_threads(int32_t motion) {
    return motion == NCK_MOTION_PASS || motion == NCK_MOTION_TAP || motion == NCK_MOTION_SCREW
           || motion == NCK_MOTION_THREAD;
}

// A threading cycle. Lengths in mm, X as radius; [0]: X, [1]: Z.
typedef NCK_CYCLE_STATE nck_screw {
    double lead;          // F as last said for a thread; 0: never
    // what the first of Fanuc's two G76 lines says, for every cycle behind it
    uint32_t springs;     // passes at full depth
    uint8_t set;          // 1: it was said
    uint8_t pull;         // leads that the tool pulls out over, in tenths
    uint8_t angle;        // of the thread [deg]
    double least;         // least step in depth
    double allowance;     // left for the first pass at full depth
    // the cycle in work
    int64_t start_nm[2];  // where it begins; machine positions
    int64_t end_nm[2];    // Z: of the last pass; X: the thread's crest there, of one pass its own
    double taper;         // how far beside that X the crest begins
    double in;            // which way X goes in: 1 or −1
    double depth;         // of the pass in work
    double full;          // depth
    double first;         // depth of the first pass
    double power;         // the depth of the pass n is first·n^power
    double slope;         // by how much a depth of 1 moves the pass along Z
    double step_least;    // as `least` holds for it
    double rough;         // full less allowance
    float turn;           // angle at its begin [rev]
    double entry;         // of the taper at the begin; 0: none
    double exit;          // over which it pulls out; 0: it does not
    uint32_t pass;        // number of the pass in work
    uint32_t left;        // passes left behind it, at full depth
    uint8_t phase;        // of it; 0: no cycle in work
    uint8_t goes_back;    // 1: the cycle ends where it began, else at the end of its way
} nck_screw_t;

#endif
