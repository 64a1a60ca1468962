// SPDX-License-Identifier: MIT
// Inside room 5: the trapezoid of speed over a piece of path, with ±a and a cruise between.
#ifndef NCK_PREP_TRAPEZOID_H
#define NCK_PREP_TRAPEZOID_H

#include "nck/base/records.h" // nck_node_t nck_cell_t

enum { NCK_TRAPEZOID_LEGS = 3 }; // accelerate, cruise, decelerate

// What is left of a piece, and how it is passed. v² in [path mm²/s²].
typedef struct nck_span {
    double s;       // where it begins in the piece's seg [path mm]
    double length;  // to the piece's end [path mm]
    double vv_in;   // v² at its begin
    double vv_out;  // v² at its end
    double vv_peak; // cap between
    double a;       // acceleration limit [path mm/s²], positive
} nck_span_t;

// The legs of a span, in legs_out[3]. Returns how many, 1 to 3. Entered faster than its cap, it
// slows down to it first. A span that lasts no longer than four periods gets one constant
// acceleration, (vv_out − vv_in)/(2·length) (Cao et al. 2014, eq. 15). Cost: constant. Context:
// any.
int nck_trapezoid_legs(const nck_node_t *piece, const nck_span_t *span, double period,
                       nck_cell_t *legs_out);

// Brake through a span with all of a; vv_out = 0: it rests at the end at the latest. Returns 1 if
// the cell comes to rest. v² at its end is vv_in − 2·a·length. Cost: constant. Context: any.
int nck_trapezoid_brake(const nck_node_t *piece, const nck_span_t *span, nck_cell_t *cell_out);

#endif
