// SPDX-License-Identifier: MIT
// Motions of splines and probes, in tenths.
#ifndef NCK_PREP_DECODE_STATE_MOTIONS_H
#define NCK_PREP_DECODE_STATE_MOTIONS_H

#include <stdint.h> // int32_t

// G5, G5.1, G5.2, G5.3; Fanuc's G6.2.
enum {
    NCK_MOTION_CUBIC = 50, NCK_MOTION_QUADRATIC = 51, NCK_MOTION_NURBS = 52,
    NCK_MOTION_NURBS_END = 53, NCK_MOTION_KNOTS = 62
};

// G38.2 … G38.5: towards something, away from it; even ones must meet (leave) it.
enum { NCK_MOTION_PROBE = 382, NCK_MOTION_PROBE_LAST = 385 };

// Fanuc's G31: it need not meet anything, and the motion before it stays in force.
enum { NCK_MOTION_SKIP = 310 };

// Whether a motion in tenths is a straight probe.
static inline int nck_motion_probes(int32_t motion) {
    return (motion >= NCK_MOTION_PROBE && motion <= NCK_MOTION_PROBE_LAST)
           || motion == NCK_MOTION_SKIP;
}

// Whether a motion in tenths is of a spline.
static inline int nck_motion_is_spline(int32_t motion) {
    return (motion >= NCK_MOTION_CUBIC && motion <= NCK_MOTION_NURBS_END)
           || motion == NCK_MOTION_KNOTS;
}

#endif
