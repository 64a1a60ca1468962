// SPDX-License-Identifier: MIT
// Four numbers in plain C, for every processor.
// One of three twins (simd_float_avx2.h simd_double_avx2.h simd_plain.h) with the same interface:
//
//   vector_t  WIDTH numbers, one of each of as many stretches of the path that advance together
//   tile      TILE consecutive numbers of every stretch: vector_t t[TILE], t[i] the i-th of each
//   stride    distance of the stretches' first numbers in memory, in numbers
//   GROUPS    vectors that advance together: with two, one works while the other waits
//   doubt_t   set by numbers that may be NaN, infinite or negative, as in serial.h
#ifndef NCK_HOST_SIMD_H
#define NCK_HOST_SIMD_H

#include <stddef.h> // size_t

#include "nck/base/envelope_math.h" // nck_envelope_backward

// Plain C: the stretches break the chain of waits, and a compiler may put them into one register.
enum { WIDTH = 4, TILE = 4, GROUPS = 1 };

typedef struct vector {
    nck_real x[WIDTH];
} vector_t;

// A look at each number here would cost more than all_good, which becomes vectors: always doubt.
typedef int doubt_t;

static inline vector_t vector_load(const nck_real *x) {
    vector_t a;
    for (size_t k = 0; k < WIDTH; k++) a.x[k] = x[k];
    return a;
}

static inline void vector_store(vector_t a, nck_real *x) {
    for (size_t k = 0; k < WIDTH; k++) x[k] = a.x[k];
}

static inline vector_t vector_step(vector_t vv_cap, vector_t vv, vector_t h) {
    vector_t a;
    for (size_t k = 0; k < WIDTH; k++) {
        a.x[k] = nck_envelope_backward(vv_cap.x[k], vv.x[k], h.x[k]);
    }
    return a;
}

static inline doubt_t doubt_none(void) { return 1; }

static inline doubt_t doubt_add(doubt_t doubt, vector_t a, vector_t b) {
    (void)a;
    (void)b;
    return doubt;
}

static inline int doubt_any(doubt_t doubt) { return doubt; }

static inline void tile_load(const nck_real *x, size_t stride, vector_t *t) {
    for (size_t i = 0; i < TILE; i++) {
        for (size_t k = 0; k < WIDTH; k++) t[i].x[k] = x[i + k * stride];
    }
}

static inline void tile_store(vector_t *t, size_t stride, nck_real *x) {
    for (size_t i = 0; i < TILE; i++) {
        for (size_t k = 0; k < WIDTH; k++) x[i + k * stride] = t[i].x[k];
    }
}

#endif
