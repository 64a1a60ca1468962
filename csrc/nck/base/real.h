// SPDX-License-Identifier: MIT
// The one place that knows the number type and which language a formula header is compiled as.
#ifndef NCK_BASE_REAL_H
#define NCK_BASE_REAL_H

#include "nck/base/limits.h" // NCK_SINGLE

// The number type: double, or float for bulk planning in float (never for positions).
#ifndef NCK_REAL
#define NCK_REAL double
#endif

// The number type of the solvers' arrays (base/motion.h): double, or float for a processor that has
// no other in hardware.
#ifndef NCK_NUM
#if NCK_SINGLE
#define NCK_NUM float
#else
#define NCK_NUM double
#endif
#endif

// What a build may put before the solvers' loops: a PC's module has them for AVX2, too, with the
// same bits (cmake/host_variants.cmake).
#ifndef NCK_LANES
#define NCK_LANES
#endif

#ifdef __OPENCL_VERSION__
#pragma OPENCL FP_CONTRACT OFF
// The same words in both languages: arguments read and written, the number, its functions.
#define NCK_IN __global const
#define NCK_OUT __global
typedef NCK_REAL nck_real;
typedef NCK_REAL nck_num; // a device plans in the type that it has
typedef long nck_int64;
#define nck_sqrt(x) sqrt(x)
#define nck_fabs(x) fabs(x)
#define nck_floor(x) floor(x)
#define nck_sincos(x, sin_out, cos_out) nck_trig_sincos(x, sin_out, cos_out) // trig_math.h
#define nck_atan2(y, x) nck_trig_atan2(y, x)
#define NCK_NUM_SQRT(x) sqrt(x)
#define NCK_NUM_ABS(x) fabs(x)
#else
#include <math.h>   // sqrt fabs floor: exact in IEEE 754, no other function of libm is used
#include <stdint.h> // int64_t uint32_t

#include "nck/base/trig.h" // nck_sincos nck_atan2

// As above.
#define NCK_IN const
#define NCK_OUT
typedef NCK_REAL nck_real;
typedef NCK_NUM nck_num;
typedef int64_t nck_int64;
#define nck_sqrt(x) sqrt(x)
#define nck_fabs(x) fabs(x)
#define nck_floor(x) floor(x)
#define NCK_NUM_SQRT(x) \
    (sizeof(nck_num) == 4 ? (nck_num)sqrtf((float)(x)) : (nck_num)sqrt((double)(x)))
#define NCK_NUM_ABS(x) \
    (sizeof(nck_num) == 4 ? (nck_num)fabsf((float)(x)) : (nck_num)fabs((double)(x)))

// What many call and is longer than its call: a compiler for size takes it for shorter.
#ifdef __GNUC__
#define NCK_APART __attribute__((noinline))
#else
#define NCK_APART
#endif
// The same of a small one, which every other compiler takes for shorter in its place.
#if defined(__GNUC__) && defined(__OPTIMIZE_SIZE__)
#define NCK_ONCE NCK_APART __attribute__((unused))
#else
#define NCK_ONCE inline
#endif

// A whole number as a real one. A processor with doubles in hardware has no instruction for it:
// each half is exact, so their sum rounds as the whole would, and no soft double is linked.
#if defined(__ARM_FP) && (__ARM_FP & 8)
static NCK_APART __attribute__((unused)) double nck_real_of(int64_t n) {
    return (double)(int32_t)((uint64_t)n >> 32) * 4294967296.0 + (double)(uint32_t)n;
}
#else
static inline double nck_real_of(int64_t n) { return (double)n; }
#endif

// The whole number next to x, of two the larger one.
static inline int64_t nck_rounded(double x) { return (int64_t)nck_floor(x + 0.5); }

// Millimetres in nanometres.
static inline int64_t nck_nm_of(double mm) { return nck_rounded(mm * 1e6); }

// Nanometres in millimetres.
static inline double nck_mm_of(int64_t nm) { return nck_real_of(nm) / 1e6; }

// Is a value in a range? NaN is in none.
static NCK_ONCE int nck_within(double value, double low, double high) {
    return value >= low && value <= high;
}

// The larger one of two counts.
static inline uint32_t nck_larger(uint32_t one, uint32_t other) {
    return one > other ? one : other;
}
#endif

// A literal of the solvers' type.
#define NCK_NUM_OF(x) ((nck_num)(x))
// What its numbers next to 1 are apart.
#define NCK_NUM_EPSILON ((nck_num)(sizeof(nck_num) == 4 ? 0x1p-23 : 0x1p-52))

// Ternaries on purpose: fmin in a dependent chain costs 2.5 times more, and NaN rules stay visible.
static inline nck_real nck_min(nck_real a, nck_real b) { return b < a ? b : a; }
static inline nck_real nck_max(nck_real a, nck_real b) { return b > a ? b : a; }

// The same of the solvers' type.
static inline nck_num nck_num_min(nck_num a, nck_num b) { return b < a ? b : a; }
static inline nck_num nck_num_max(nck_num a, nck_num b) { return b > a ? b : a; }

#endif
