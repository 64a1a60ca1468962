// SPDX-License-Identifier: MIT
// What the files of G70 … G73 ask of a recorded contour. a and d: see nck_rough_t.
#ifndef NCK_PREP_DECODE_LATHE_LEVEL_H
#define NCK_PREP_DECODE_LATHE_LEVEL_H

#include "nck/prep/1_decode/state/room.h" // nck_decode_t

// +1 if an arc's sweep turns from a towards d, else −1. Cost: constant.
double nck_level_turn(const nck_decode_t *self, double sweep);

// A slant of an element, from 1: a part that rises or falls all along; 0 … 4 of an arc. Returns 0:
// there is none. Cost: constant.
int nck_level_slant(const nck_decode_t *self, uint32_t element, unsigned part, nck_slant_t *out);

// Where a slant is at a height between its ends. Cost: constant.
double nck_level_at(const nck_slant_t *slant, double d);

// The first stretch at a height, from *begin on, that keeps its distance from the contour. Returns
// 0: there is none. Cost: quadratic in the contour at worst.
int nck_level_clear(const nck_decode_t *self, double height, double *begin, double *end);

// 1 if the way from a place to another one keeps its distance at that height. Cost: as above.
int nck_level_passes(const nck_decode_t *self, double height, double from, double to);

// The direction of an element's begin (end 0) or end (1), of length 1. Cost: constant.
void nck_level_heading(const nck_decode_t *self, uint32_t element, unsigned end, double *out);

// Where an element ends. Cost: constant.
void nck_level_place(const nck_decode_t *self, uint32_t element, double *out);

#endif
