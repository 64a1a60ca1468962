// SPDX-License-Identifier: MIT
// Eight lanes of float, side by side in one register: the words of lanes that depend on the type.
#ifndef OPENCL_LANES_MATH_H
#define OPENCL_LANES_MATH_H

#define NCK_REAL float
#include "nck/base/real.h" // nck_real

enum { LANES = 8 };
#define REAL_MAX FLT_MAX
typedef float8 lanes_t;
typedef int8 lanes_bits_t;
// A lane begins anywhere: a load that asks for no more than the alignment of one number.
typedef float8 __attribute__((aligned(4))) lanes_packed_t;

static inline lanes_bits_t lanes_bits(lanes_t x) { return as_int8(x); }

// All bits of a negative number or of one that is not finite: the sign bit of the result is set.
static inline lanes_bits_t lanes_doubt(lanes_bits_t bits) { return bits | (0x7f7fffff - bits); }

static inline int lanes_any_sign(lanes_bits_t x) {
    const int4 fold = x.lo | x.hi;
    const int2 fold_again = fold.lo | fold.hi;
    return (fold_again.x | fold_again.y) < 0;
}

static inline lanes_t lanes_of(const nck_real *x) {
    return (lanes_t)(x[0], x[1], x[2], x[3], x[4], x[5], x[6], x[7]);
}

static inline lanes_t low_pairs(lanes_t a, lanes_t b) {
    return (lanes_t)(a.s0, b.s0, a.s1, b.s1, a.s4, b.s4, a.s5, b.s5);
}

static inline lanes_t high_pairs(lanes_t a, lanes_t b) {
    return (lanes_t)(a.s2, b.s2, a.s3, b.s3, a.s6, b.s6, a.s7, b.s7);
}

static inline lanes_t low_fours(lanes_t a, lanes_t b) {
    return (lanes_t)(a.s01, b.s01, a.s45, b.s45);
}

static inline lanes_t high_fours(lanes_t a, lanes_t b) {
    return (lanes_t)(a.s23, b.s23, a.s67, b.s67);
}

// Rows become columns, in place: numbers in a row of one lane, lanes side by side, and back.
static inline void lanes_transpose(lanes_t *row) {
    const lanes_t a0 = low_pairs(row[0], row[1]), a1 = high_pairs(row[0], row[1]);
    const lanes_t a2 = low_pairs(row[2], row[3]), a3 = high_pairs(row[2], row[3]);
    const lanes_t a4 = low_pairs(row[4], row[5]), a5 = high_pairs(row[4], row[5]);
    const lanes_t a6 = low_pairs(row[6], row[7]), a7 = high_pairs(row[6], row[7]);
    const lanes_t b0 = low_fours(a0, a2), b1 = high_fours(a0, a2);
    const lanes_t b2 = low_fours(a1, a3), b3 = high_fours(a1, a3);
    const lanes_t b4 = low_fours(a4, a6), b5 = high_fours(a4, a6);
    const lanes_t b6 = low_fours(a5, a7), b7 = high_fours(a5, a7);
    row[0] = (lanes_t)(b0.lo, b4.lo);
    row[1] = (lanes_t)(b1.lo, b5.lo);
    row[2] = (lanes_t)(b2.lo, b6.lo);
    row[3] = (lanes_t)(b3.lo, b7.lo);
    row[4] = (lanes_t)(b0.hi, b4.hi);
    row[5] = (lanes_t)(b1.hi, b5.hi);
    row[6] = (lanes_t)(b2.hi, b6.hi);
    row[7] = (lanes_t)(b3.hi, b7.hi);
}

#endif
