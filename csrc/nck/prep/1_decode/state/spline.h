// SPDX-License-Identifier: MIT
// Splines of RS274NGC: G5, G5.1, G5.2 … G5.3; of Fanuc: G6.2. They are given as chords.
#ifndef NCK_PREP_DECODE_STATE_SPLINE_H
#define NCK_PREP_DECODE_STATE_SPLINE_H

#include <stdint.h> // int64_t uint32_t

#include "nck/base/limits.h" // NCK_CYCLE_STATE
#include "nck/prep/1_decode/state/motions.h" // NCK_MOTION_CUBIC …

enum { NCK_SPLINE_ORDER_MOST = 8 }; // the largest L of G5.2

// What G6.2 keeps beside a place: which of centre_mm.
enum { NCK_SPLINE_Z = 0, NCK_SPLINE_KNOT = 1 }; // Z [nm], exact; a knot, also behind the last point

// Its control points are in the contour's elements: to_nm is their place, sweep_rad their weight.
typedef NCK_CYCLE_STATE nck_spline {
    uint32_t points;  // 0: none
    uint32_t line, column; // where it begins, of G5.2 and G6.2
    uint32_t order;   // of the spline
    uint32_t knots;   // of G6.2, said so far; 0: they are 0 … 0 1 2 … m … m, and Z stays
    uint32_t axes;    // of G6.2: those of its points
    uint32_t works;   // 1: chords of it are left
    uint32_t follows; // 1: the line before was a G5, and tangent_nm is of its end
    int64_t tangent_nm[2]; // I J of a G5 that goes on
    double at, step;  // parameter of the last chord's end; how far a chord reached
    double feed;      // as a block has it
} nck_spline_t;

#endif
