// SPDX-License-Identifier: MIT
// Work systems that are turned about their zero, as others of the room see them.
#ifndef NCK_PREP_DECODE_TURNED_H
#define NCK_PREP_DECODE_TURNED_H

#include "nck/prep/1_decode/decode.h" // nck_decode_t

// By how much a work system, from 0, is turned [deg]. Cost: constant.
double nck_turned_by(const nck_decode_t *self, uint32_t system);

// Turn it. What is in force changes with nck_decode_origin. Cost: constant.
void nck_turned_set(nck_decode_t *self, uint32_t system, double degrees);

// Where an axis is in the program, counts. Cost: constant.
int64_t nck_turned_place(const nck_decode_t *self, unsigned axis);

// layout.c: what the program calls the place where the axes stand; the same, kept for the next
// move. Cost of both: constant.
void nck_layout_where(const nck_decode_t *self, int64_t *at_nm);
void nck_layout_name(nck_decode_t *self);

// What cannot be done while the work system in force is turned: NCK_E_LAYOUT_ON. Cost: constant.
nck_status_t nck_turned_refuses(nck_decode_t *self);

#endif
