// SPDX-License-Identifier: MIT
// The cube root, of sums, products, quotients and square roots alone: the same bits everywhere.
#ifndef NCK_BASE_ROOT_MATH_H
#define NCK_BASE_ROOT_MATH_H

#include "nck/base/real.h" // nck_real nck_sqrt

// Cube root of x > 0: y ← ⁴√(x·y) divides the error's logarithm by 4 each time, then Newton's
// method, which doubles the digits. Exact to 2 ulp for 1e-30 … 1e30.
static inline nck_real nck_root_cube(nck_real x) {
    nck_real y = nck_sqrt(x);
    for (int k = 0; k < 6; k++) y = nck_sqrt(nck_sqrt(x * y));
    for (int k = 0; k < 3; k++) y -= (y * y * y - x) / ((nck_real)3 * y * y);
    return y;
}

#endif
