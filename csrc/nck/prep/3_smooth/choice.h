// SPDX-License-Identifier: MIT
// Inside room 3: what a corner becomes, by the time that it takes: a bend of the spline, or
// a stop.
#ifndef NCK_PREP_CHOICE_H
#define NCK_PREP_CHOICE_H

#include "nck/prep/3_smooth/smooth.h" // nck_smooth_t nck_raw_t

// The bend of the spline at a corner.
typedef struct nck_bend {
    double d;                 // spacing of the knots beside it [path mm]
    double lift;              // of its control point, as a share of turn·d
    double turn[NCK_AXIS_MAX]; // by how much the spline's tangent turns over it
} nck_bend_t;

// Where two blocks meet.
typedef struct nck_meet {
    const nck_raw_t *a; // the block before the corner
    const nck_raw_t *b; // the block behind it
    double length[2];   // how far the path leads to it and on as good as straight [path mm]
    double tolerance;   // the least on these ways [mm]
    uint8_t rests[2];   // 1: it rests at the other ends of these
} nck_meet_t;

// Returns 1 if one of two bends at the corner is faster than the other.
// Cost: as above.
int nck_choice_wide(const nck_smooth_t *self, const nck_meet_t *meet, const nck_bend_t *wide,
                    const nck_bend_t *narrow);

// Returns 0 if a stop is out of the question: the spline's bend turns by more than the corner. The
// lengths of the ways do not matter. Cost: four square roots.
int nck_choice_may_stop(const nck_smooth_t *self, const nck_meet_t *meet, const nck_bend_t *bend);

// Returns 1 if a stop at the corner is faster than the spline's bend. Cost: as above.
int nck_choice_stop(const nck_smooth_t *self, const nck_meet_t *meet, const nck_bend_t *bend);

#endif
