// SPDX-License-Identifier: MIT
// Four lanes of double, side by side in one register: the words of lanes that depend on the type.
#ifndef OPENCL_LANES_MATH_H
#define OPENCL_LANES_MATH_H

#define NCK_REAL double
#include "nck/base/real.h" // nck_real

enum { LANES = 4 };
#define REAL_MAX DBL_MAX
typedef double4 lanes_t;
typedef long4 lanes_bits_t;
// A lane begins anywhere: a load that asks for no more than the alignment of one number.
typedef double4 __attribute__((aligned(8))) lanes_packed_t;

static inline lanes_bits_t lanes_bits(lanes_t x) { return as_long4(x); }

// All bits of a negative number or of one that is not finite: the sign bit of the result is set.
static inline lanes_bits_t lanes_doubt(lanes_bits_t bits) {
    return bits | (0x7fefffffffffffff - bits);
}

static inline int lanes_any_sign(lanes_bits_t x) {
    const long2 fold = x.lo | x.hi;
    return (fold.x | fold.y) < 0;
}

static inline lanes_t lanes_of(const nck_real *x) { return (lanes_t)(x[0], x[1], x[2], x[3]); }

// Rows become columns, in place: numbers in a row of one lane, lanes side by side, and back.
static inline void lanes_transpose(lanes_t *row) {
    const lanes_t a0 = (lanes_t)(row[0].s0, row[1].s0, row[0].s2, row[1].s2);
    const lanes_t a1 = (lanes_t)(row[0].s1, row[1].s1, row[0].s3, row[1].s3);
    const lanes_t a2 = (lanes_t)(row[2].s0, row[3].s0, row[2].s2, row[3].s2);
    const lanes_t a3 = (lanes_t)(row[2].s1, row[3].s1, row[2].s3, row[3].s3);
    row[0] = (lanes_t)(a0.lo, a2.lo);
    row[1] = (lanes_t)(a1.lo, a3.lo);
    row[2] = (lanes_t)(a0.hi, a2.hi);
    row[3] = (lanes_t)(a1.hi, a3.hi);
}

#endif
