// SPDX-License-Identifier: MIT
// Inside room 3: what a spacing of knots would do to the path around a block's end.
#ifndef NCK_PREP_ESTIMATE_H
#define NCK_PREP_ESTIMATE_H

#include "nck/prep/3_smooth/smooth.h" // nck_smooth_t

// How far a spline of even spacing h would leave the path at a knot at a block's end [mm], if its
// control points were made of second differences over h alone.
// On a curve they are p − δ²p/6, p̃ − p = −δ⁴p/36;
// in noise p + 5δ²p/24, p̃ − p = (11 δ²p + 5/4·(δ²p before + δ²p behind))/36.
// Cost: four points of the path, one where they are known.
double nck_estimate_plain(nck_smooth_t *self, uint32_t count, double h, int rough);

// A spacing that was found right with the plain estimate, made smaller until the spline keeps to
// the aim [mm] with control points of nine points (spline_math.h), too.
// Cost: 18 points of the path.
double nck_estimate_shrink(nck_smooth_t *self, uint32_t count, double aim, double spacing);

// Σ |δ²p|² of five places around a block's end, h apart [mm²]; NCK_UNLIMITED if the first of them
// alone exceeds `most`. Cost: seven points of the path.
double nck_estimate_unevenness(nck_smooth_t *self, uint32_t count, double h, double most);

// 1 if the path up to a place is known from now on: the newest block may yet change, and what is
// behind it is not known. Cost: constant.
static inline int nck_estimate_is_known(const nck_smooth_t *self, double s) {
    return s <= self->raw.at[(self->run.end - 1) & (NCK_SMOOTH_ROWS - 1)].s;
}

// Forget what is known of the path from estimates before: a corner may be moved. Cost: constant.
static inline void nck_estimate_forget(nck_smooth_t *self) {
    for (int k = 0; k < 2; k++) self->run.looks.at[k].h = 0.0;
    self->run.looks.wait = 0.0;
    self->run.looked.known = 0;
}

// Blocks from the block's end that was looked at last to about n/4 of its spacing behind it, or
// before it where n is negative: modulo 2³². Cost: constant.
static inline uint32_t nck_estimate_off(const nck_smooth_t *self, int n) {
    const int16_t *const off = self->run.looked.off;
    return (uint32_t)(n < 0 ? -n * off[0] / 8 : n * off[2] / 8);
}

#endif
