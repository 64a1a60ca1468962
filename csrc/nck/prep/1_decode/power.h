// SPDX-License-Identifier: MIT
// Powers, logarithm and remainder of expressions, made of + − × ÷ and exponents alone: the same
// bits on every target.
#ifndef NCK_PREP_DECODE_POWER_H
#define NCK_PREP_DECODE_POWER_H

// e^x; relative error ≤ 4 ulp; infinity beyond the largest number, 0 below the smallest one.
// Cost: constant. Context: any.
double nck_exp(double x);

// The natural logarithm of x > 0 (normal); relative error ≤ 4 ulp beside 1. Cost: constant.
// Context: any.
double nck_log(double x);

// base^exponent; base < 0 only with a whole exponent, 0 only with a positive one or 0. Whole ones
// up to 1024 by products. Cost: constant. Context: any.
double nck_power(double base, double exponent);

// The rest of a / b, exact, with the sign of a; b is not 0. Cost: linear in the binary digits of
// the quotient, 2100 at most. Context: any.
double nck_rest(double a, double b);

#endif
