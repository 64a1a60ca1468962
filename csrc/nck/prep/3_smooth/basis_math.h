// SPDX-License-Identifier: MIT
// The uniform cubic B-spline: an interval of it, over the place w = 0 … 1, has four control points.
// (C. de Boor, A Practical Guide to Splines, 1978, chapter IX.) In the solvers' number.
#ifndef NCK_PREP_BASIS_MATH_H
#define NCK_PREP_BASIS_MATH_H

#include "nck/base/real.h" // nck_num

// The control points' weights at w:
//   (1 − w)³/6,  (3w³ − 6w² + 4)/6,  the same of 1 − w,  w³/6
static inline void nck_basis_weights(nck_num w, nck_num *weight_out) {
    const nck_num m = 1 - w;
    const nck_num sixth = (nck_num)1 / 6;
    const nck_num ww = w * w;
    const nck_num mm = m * m;
    weight_out[0] = mm * m * sixth;
    weight_out[1] = ((3 * w - 6) * ww + 4) * sixth;
    weight_out[2] = ((3 * m - 6) * mm + 4) * sixth;
    weight_out[3] = ww * w * sixth;
}

// The same as coefficients of 1, w, w², w³; control points `step` apart in the array.
static inline void nck_basis_cubic(const nck_num *c, int step, nck_num *cubic_out) {
    const nck_num sixth = (nck_num)1 / 6;
    const nck_num c0 = c[0];
    const nck_num c1 = c[step];
    const nck_num c2 = c[2 * step];
    const nck_num c3 = c[3 * step];
    cubic_out[0] = (c0 + 4 * c1 + c2) * sixth;
    cubic_out[1] = (c2 - c0) / 2;
    cubic_out[2] = (c0 - 2 * c1 + c2) / 2;
    cubic_out[3] = (c3 - c0 + 3 * (c1 - c2)) * sixth;
}

// Its value at w.
static inline nck_num nck_basis_value(const nck_num *cubic, nck_num w) {
    return cubic[0] + w * (cubic[1] + w * (cubic[2] + w * cubic[3]));
}

#endif
