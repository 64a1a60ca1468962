// SPDX-License-Identifier: MIT
// Inside room 3: the programmed path of a run, as far as it is known.
#ifndef NCK_PREP_RAW_H
#define NCK_PREP_RAW_H

#include "nck/prep/3_smooth/smooth.h" // nck_smooth_t nck_raw_t

// What is only rounding beside a place of the run: nearer places are one [path mm].
double nck_raw_least(double s);

// The block with this count. Cost: constant.
static inline nck_raw_t *nck_raw_at(nck_smooth_t *self, uint32_t count) {
    return &self->raw.at[count & (NCK_SMOOTH_SPAN - 1)];
}

// 1 if the ring has no room. Cost: constant.
int nck_raw_is_full(const nck_smooth_t *self);

// The first block of the run that has length and ends at s or behind it; the run's last one if none
// does. Cost: logarithmic in NCK_SMOOTH_SPAN, and linear in outputs in a row.
uint32_t nck_raw_find(nck_smooth_t *self, double s);

// The next block with length behind this one; run.end if there is none. Cost: linear in outputs.
uint32_t nck_raw_next(nck_smooth_t *self, uint32_t count);

// The last seg of the run. Cost: linear in the outputs behind it.
uint32_t nck_raw_last(nck_smooth_t *self);

// Where the known part of the run ends [path mm]. Cost: linear in outputs at its end.
double nck_raw_known(nck_smooth_t *self);

// The point of the programmed path at s, of it the coordinates that may change; beyond what is
// known, straight on along the tangent.
// Cost: as nck_raw_find.
void nck_raw_point(nck_smooth_t *self, double s, double *point_out);

// How sharply the path turns from one seg to the next: Δu of the unit tangents, so many axes of it;
// returns |Δu|. Cost: constant.
double nck_raw_turn(const nck_seg_t *in, const nck_seg_t *out, int axes, double *turn_out);

// The run's spline between t[first + 2] and t[first + 3], as a seg without words; a line where the
// path is straight. Cost: as nck_raw_find.
void nck_raw_spline(nck_smooth_t *self, int first, nck_seg_t *seg_out);

// 1 if that spline keeps to a share of the tolerance, or has no length.
// Cost: a point for each block there, and 16.
int nck_raw_fits(nck_smooth_t *self, int first, double share);

#endif
