// SPDX-License-Identifier: MIT
// Sine, cosine and the angle of a vector for C: the formulas of trig_math.h, once in flash.
#ifndef NCK_BASE_TRIG_H
#define NCK_BASE_TRIG_H

#ifdef __cplusplus
extern "C" {
#endif

// Sine and cosine of x [rad], |x| ≤ 1e6; error ≤ 2 ulp of 1. Cost: constant. Context: any.
void nck_sincos(double x, double *sin_out, double *cos_out);

// The angle of the vector (x, y) from the x axis, −π < angle ≤ π [rad]; 0 for the zero vector.
// Relative error ≤ 4 ulp. Cost: constant. Context: any.
double nck_atan2(double y, double x);

#ifdef __cplusplus
}
#endif

#endif
