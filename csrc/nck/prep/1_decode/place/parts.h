// SPDX-License-Identifier: MIT
// What the files of this wing call of each other, and nobody else. Context of all: prep.
#ifndef NCK_PREP_DECODE_PLACE_PARTS_H
#define NCK_PREP_DECODE_PLACE_PARTS_H

#include "nck/prep/1_decode/place/place.h"

enum { NCK_LIST_WORK = 2, NCK_LIST_WORK_HERE = 20 }; // lists of G10

// ---- layout.c

// Where the words of X Y Z lead while a layout is in force. NCK_E_LAYOUT_ON, NCK_E_NUMBER_RANGE.
// Cost: constant.
nck_status_t nck_layout_target(nck_decode_t *self, int64_t *target_nm);

// What the program calls the place where the axes stand; the same, kept for the next move. Cost of
// both: constant.
void nck_layout_where(const nck_decode_t *self, int64_t *at_nm);
void nck_layout_name(nck_decode_t *self);

// ---- turned.c

// Turn a work system, from 0. What is in force changes with nck_decode_origin. Cost: constant.
void nck_turned_set(nck_decode_t *self, uint32_t system, double degrees);

// ---- table.c

// G10 with another list than L2 and L20: NCK_E_UNSUPPORTED, NCK_E_TOOL_UNKNOWN, NCK_E_NUMBER_RANGE,
// NCK_E_WORD_UNUSED, NCK_E_WORD_MISSING, NCK_E_VARIABLES. Cost: linear in tools and parameters.
nck_status_t nck_table_set(nck_decode_t *self, int64_t list);

// Does the language have this list of G10? NCK_E_UNSUPPORTED. Cost: constant.
nck_status_t nck_table_lists(nck_decode_t *self, int64_t list);

#endif
