// SPDX-License-Identifier: MIT
// Four numbers of double in AVX2.
// One of three twins (simd_float_avx2.h simd_double_avx2.h simd_plain.h) with the same interface:
//
//   vector_t  WIDTH numbers, one of each of as many stretches of the path that advance together
//   tile      TILE consecutive numbers of every stretch: vector_t t[TILE], t[i] the i-th of each
//   stride    distance of the stretches' first numbers in memory, in numbers
//   GROUPS    vectors that advance together: with two, one works while the other waits
//   doubt_t   set by numbers that may be NaN, infinite or negative, as doubt_double in serial.h
#ifndef NCK_HOST_SIMD_H
#define NCK_HOST_SIMD_H

#include <immintrin.h> // __m256d
#include <stddef.h>    // size_t
#include <stdint.h>    // int64_t

#include "nck/base/real.h" // nck_real

enum { WIDTH = 4, TILE = 4, GROUPS = 2 };
typedef __m256d vector_t;
typedef __m256i doubt_t;

static inline vector_t vector_load(const nck_real *x) { return _mm256_loadu_pd(x); }
static inline void vector_store(vector_t a, nck_real *x) { _mm256_storeu_pd(x, a); }

static inline vector_t vector_step(vector_t vv_cap, vector_t vv, vector_t h) {
    return _mm256_min_pd(_mm256_add_pd(vv, h), vv_cap);
}

static inline doubt_t doubt_none(void) { return _mm256_setzero_si256(); }

// The largest halves of the bits as numbers without a sign: a sign or a full exponent makes the
// upper one large.
static inline doubt_t doubt_add(doubt_t doubt, vector_t a, vector_t b) {
    const __m256i more = _mm256_max_epu32(_mm256_castpd_si256(a), _mm256_castpd_si256(b));
    return _mm256_max_epu32(doubt, more);
}

static inline int doubt_any(doubt_t doubt) {
    const __m256i full = _mm256_add_epi64(doubt, _mm256_set1_epi64x((int64_t)1 << 52));
    return _mm256_movemask_pd(_mm256_castsi256_pd(_mm256_or_si256(doubt, full))) != 0;
}

static inline vector_t half_load(const nck_real *x, size_t stride) {
    const __m256d low = _mm256_castpd128_pd256(_mm_loadu_pd(x));
    return _mm256_insertf128_pd(low, _mm_loadu_pd(x + 2 * stride), 1);
}

// Two halves of the tile: in each half of the registers a matrix of 2 × 2 is turned.
static inline void tile_load(const nck_real *x, size_t stride, vector_t *t) {
    for (size_t i = 0; i < 4; i += 2) {
        const vector_t even = half_load(x + i, stride);
        const vector_t odd = half_load(x + i + stride, stride);
        t[i] = _mm256_unpacklo_pd(even, odd);
        t[i + 1] = _mm256_unpackhi_pd(even, odd);
    }
}

static inline void half_store(vector_t a, size_t stride, nck_real *x) {
    _mm_storeu_pd(x, _mm256_castpd256_pd128(a));
    _mm_storeu_pd(x + 2 * stride, _mm256_extractf128_pd(a, 1));
}

static inline void tile_store(vector_t *t, size_t stride, nck_real *x) {
    for (size_t i = 0; i < 4; i += 2) {
        half_store(_mm256_unpacklo_pd(t[i], t[i + 1]), stride, x + i);
        half_store(_mm256_unpackhi_pd(t[i], t[i + 1]), stride, x + i + stride);
    }
}

#endif
