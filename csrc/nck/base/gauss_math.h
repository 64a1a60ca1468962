// SPDX-License-Identifier: MIT
// Gauss' rule of three places: a mean over 0 … 1 that is exact for polynomials up to the fifth
// degree (Abramowitz and Stegun 1964, 25.4.30).
#ifndef NCK_BASE_GAUSS_MATH_H
#define NCK_BASE_GAUSS_MATH_H

// How many places there are.
enum { NCK_GAUSS_PLACES = 3 };

// Place i. Cost: constant. Context: any.
static inline double nck_gauss_place(int i) {
    const double low = 0.1127016653792583; // (1 − √(3/5))/2
    if (i == 1) return 0.5;
    return i == 0 ? low : 1.0 - low;
}

// Its weight. Cost: constant. Context: any.
static inline double nck_gauss_weight(int i) { return (i == 1 ? 8.0 : 5.0) / 18.0; }

#endif
