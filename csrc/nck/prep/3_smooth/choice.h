// SPDX-License-Identifier: MIT
// Inside room 3: what a corner becomes, by the time that it takes: a bend of the spline, a blend of
// its own, or a stop.
#ifndef NCK_PREP_CHOICE_H
#define NCK_PREP_CHOICE_H

#include "nck/prep/3_smooth/smooth.h" // nck_smooth_t nck_raw_t

// The blend of a corner (README, section "Corners").
typedef struct nck_blend {
    double d, parking;        // half-width d, length D in between [path mm]
    double in[NCK_AXIS_MAX];  // dp/ds of both blocks where they meet
    double out[NCK_AXIS_MAX];
} nck_blend_t;

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
    uint8_t rests[2];   // 1: it rests at the other ends of these
} nck_meet_t;

// Returns 0 if a blend is out of the question at a corner between two lines: it is none, an exact
// reversal, or so blunt that only its neighbours bound the spline. Cost: four square roots.
int nck_choice_may_blend(const nck_smooth_t *self, const nck_meet_t *meet);

// Choose for a corner where one may be. A blend may reach `room` into either line.
// Returns 1 and the blend if it is faster than the spline and than a stop.
// Cost: some 100 square roots.
int nck_choice_blend(const nck_smooth_t *self, const nck_meet_t *meet, double room,
                     nck_blend_t *blend);

// Returns 1 if one of two bends at the corner is faster than the other.
// Cost: as above.
int nck_choice_wide(const nck_smooth_t *self, const nck_meet_t *meet, const nck_bend_t *wide,
                    const nck_bend_t *narrow);

// Returns 0 if a stop is out of the question: the spline's bend turns by more than the corner. The
// lengths of the ways do not matter. Cost: four square roots.
int nck_choice_may_stop(const nck_smooth_t *self, const nck_meet_t *meet, const nck_bend_t *bend);

// Returns 1 if a stop at the corner is faster than the spline's bend. *overlap_out: the distance at
// which the motions beside it may overlap (nck_seg_t.overlap). Cost: as above.
int nck_choice_stop(const nck_smooth_t *self, const nck_meet_t *meet, const nck_bend_t *bend,
                    double *overlap_out);

#endif
