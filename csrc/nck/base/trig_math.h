// SPDX-License-Identifier: MIT
// Sine, cosine and the angle of a vector, made of + − × ÷ √ alone: the same bits on every target.
// Formulas call them by nck_sincos and nck_atan2 (real.h).
#ifndef NCK_BASE_TRIG_MATH_H
#define NCK_BASE_TRIG_MATH_H

#include "nck/base/real.h" // nck_real nck_sqrt nck_floor

// π and π/2, rounded.
#define NCK_PI 3.14159265358979323846
#define NCK_HALF_PI 1.57079632679489661923

// sin r for |r| ≤ π/4:  r − r³/3! + r⁵/5! − … + r¹⁷/17!
// (Taylor; the first term left out, (π/4)¹⁹/19! = 8e-20, is below half an ulp.)
static inline nck_real nck_sin_core(nck_real r) {
    const nck_real rr = r * r;
    nck_real p = 1.0 / 355687428096000.0;
    p = p * rr - 1.0 / 1307674368000.0;
    p = p * rr + 1.0 / 6227020800.0;
    p = p * rr - 1.0 / 39916800.0;
    p = p * rr + 1.0 / 362880.0;
    p = p * rr - 1.0 / 5040.0;
    p = p * rr + 1.0 / 120.0;
    p = p * rr - 1.0 / 6.0;
    return r + r * (rr * p);
}

// cos r for |r| ≤ π/4:  1 − r²/2! + r⁴/4! − … − r¹⁸/18!
// (Taylor; the first term left out is below 1e-20.)
static inline nck_real nck_cos_core(nck_real r) {
    const nck_real rr = r * r;
    nck_real p = -1.0 / 6402373705728000.0;
    p = p * rr + 1.0 / 20922789888000.0;
    p = p * rr - 1.0 / 87178291200.0;
    p = p * rr + 1.0 / 479001600.0;
    p = p * rr - 1.0 / 3628800.0;
    p = p * rr + 1.0 / 40320.0;
    p = p * rr - 1.0 / 720.0;
    p = p * rr + 1.0 / 24.0;
    return 1.0 - (0.5 * rr - rr * rr * p);
}

// (sin x, cos x). x in rad, |x| ≤ 1e6; error ≤ 2 ulp of 1.
// Reduction by quarter turns, x = n·π/2 + r, with π/2 in three parts of 33 bits each, so that
// n·part is exact for n < 2²⁰ (W. J. Cody, W. Waite, Software Manual for the Elementary
// Functions, 1980).
static inline void nck_trig_sincos(nck_real x, nck_real *sin_out, nck_real *cos_out) {
    const nck_real n = nck_floor(x * (1.0 / NCK_HALF_PI) + 0.5);
    const nck_real r = ((x - n * 1.57079632673412561417e+00) - n * 6.07710050630396597660e-11)
                       - n * 2.02226624879595063154e-21;
    const nck_real s = nck_sin_core(r);
    const nck_real c = nck_cos_core(r);
    const int quarter = (int)(n - 4.0 * nck_floor(n * 0.25));
    *sin_out = quarter == 0 ? s : quarter == 1 ? c : quarter == 2 ? -s : -c;
    *cos_out = quarter == 0 ? c : quarter == 1 ? -s : quarter == 2 ? -c : s;
}

// atan t for 0 ≤ t ≤ 1. The half-angle formula  atan t = 2 atan(t / (1 + √(1 + t²)))  twice brings
// t to 0.199 or less; there  t − t³/3 + t⁵/5 − … + t²³/23  (Taylor; the rest is below 1e-18).
static inline nck_real nck_atan_core(nck_real t) {
    const nck_real once = t / (1.0 + nck_sqrt(1.0 + t * t));
    const nck_real q = once / (1.0 + nck_sqrt(1.0 + once * once));
    const nck_real qq = q * q;
    nck_real p = -1.0 / 23.0;
    p = p * qq + 1.0 / 21.0;
    p = p * qq - 1.0 / 19.0;
    p = p * qq + 1.0 / 17.0;
    p = p * qq - 1.0 / 15.0;
    p = p * qq + 1.0 / 13.0;
    p = p * qq - 1.0 / 11.0;
    p = p * qq + 1.0 / 9.0;
    p = p * qq - 1.0 / 7.0;
    p = p * qq + 1.0 / 5.0;
    p = p * qq - 1.0 / 3.0;
    return 4.0 * (q + q * (qq * p));
}

// The angle of the vector (x, y) from the x axis, −π < angle ≤ π [rad]; 0 for the zero vector.
// Relative error ≤ 4 ulp.
static inline nck_real nck_trig_atan2(nck_real y, nck_real x) {
    const nck_real ax = nck_fabs(x);
    const nck_real ay = nck_fabs(y);
    if (ax == 0.0 && ay == 0.0) return 0.0;
    const nck_real core = nck_atan_core(ay <= ax ? ay / ax : ax / ay);
    nck_real angle = ay <= ax ? core : NCK_HALF_PI - core;
    if (x < 0.0) angle = NCK_PI - angle;
    return y < 0.0 ? -angle : angle;
}

#endif
