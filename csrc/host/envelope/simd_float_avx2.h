// SPDX-License-Identifier: MIT
// Eight numbers of float in AVX2.
// One of three twins (simd_float_avx2.h simd_double_avx2.h simd_plain.h) with the same interface:
//
//   vector_t  WIDTH numbers, one of each of as many stretches of the path that advance together
//   tile      TILE consecutive numbers of every stretch: vector_t t[TILE], t[i] the i-th of each
//   stride    distance of the stretches' first numbers in memory, in numbers
//   GROUPS    vectors that advance together: with two, one works while the other waits
//   doubt_t   set by numbers that may be NaN, infinite or negative, as doubt_float in serial.h
#ifndef NCK_HOST_SIMD_H
#define NCK_HOST_SIMD_H

#include <immintrin.h> // __m256
#include <stddef.h>    // size_t

#include "nck/base/real.h" // nck_real

enum { WIDTH = 8, TILE = 8, GROUPS = 2 };
typedef __m256 vector_t;
typedef __m256i doubt_t;

static inline vector_t vector_load(const nck_real *x) { return _mm256_loadu_ps(x); }
static inline void vector_store(vector_t a, nck_real *x) { _mm256_storeu_ps(x, a); }

// min(vv_cap, vv + h): the instruction takes its first operand where that is smaller, as the
// formula.
static inline vector_t vector_step(vector_t vv_cap, vector_t vv, vector_t h) {
    return _mm256_min_ps(_mm256_add_ps(vv, h), vv_cap);
}

static inline doubt_t doubt_none(void) { return _mm256_setzero_si256(); }

// The largest bits as numbers without a sign: a sign or a full exponent makes them large.
static inline doubt_t doubt_add(doubt_t doubt, vector_t a, vector_t b) {
    const __m256i more = _mm256_max_epu32(_mm256_castps_si256(a), _mm256_castps_si256(b));
    return _mm256_max_epu32(doubt, more);
}

static inline int doubt_any(doubt_t doubt) {
    const __m256i full = _mm256_add_epi32(doubt, _mm256_set1_epi32(1 << 23));
    return _mm256_movemask_ps(_mm256_castsi256_ps(_mm256_or_si256(doubt, full))) != 0;
}

// Four quarters of the tile: in each half of the registers a matrix of 4 × 4 is turned.
static inline void tile_turn(vector_t *t) {
    const vector_t low_a = _mm256_unpacklo_ps(t[0], t[1]);
    const vector_t high_a = _mm256_unpackhi_ps(t[0], t[1]);
    const vector_t low_b = _mm256_unpacklo_ps(t[2], t[3]);
    const vector_t high_b = _mm256_unpackhi_ps(t[2], t[3]);
    t[0] = _mm256_shuffle_ps(low_a, low_b, _MM_SHUFFLE(1, 0, 1, 0));
    t[1] = _mm256_shuffle_ps(low_a, low_b, _MM_SHUFFLE(3, 2, 3, 2));
    t[2] = _mm256_shuffle_ps(high_a, high_b, _MM_SHUFFLE(1, 0, 1, 0));
    t[3] = _mm256_shuffle_ps(high_a, high_b, _MM_SHUFFLE(3, 2, 3, 2));
}

static inline vector_t half_load(const nck_real *x, size_t stride) {
    const __m256 low = _mm256_castps128_ps256(_mm_loadu_ps(x));
    return _mm256_insertf128_ps(low, _mm_loadu_ps(x + 4 * stride), 1);
}

static inline void tile_load(const nck_real *x, size_t stride, vector_t *t) {
    for (size_t k = 0; k < 4; k++) {
        t[k] = half_load(x + k * stride, stride);
        t[k + 4] = half_load(x + k * stride + 4, stride);
    }
    tile_turn(t);
    tile_turn(t + 4);
}

static inline void half_store(vector_t a, size_t stride, nck_real *x) {
    _mm_storeu_ps(x, _mm256_castps256_ps128(a));
    _mm_storeu_ps(x + 4 * stride, _mm256_extractf128_ps(a, 1));
}

static inline void tile_store(vector_t *t, size_t stride, nck_real *x) {
    tile_turn(t);
    tile_turn(t + 4);
    for (size_t k = 0; k < 4; k++) {
        half_store(t[k], stride, x + k * stride);
        half_store(t[k + 4], stride, x + k * stride + 4);
    }
}

#endif
