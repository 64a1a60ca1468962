// SPDX-License-Identifier: MIT
// Where a drilling cycle begins to cut, ends and retracts to, as the files of this wing see it.
#ifndef NCK_PREP_DECODE_CYCLE_HEIGHT_H
#define NCK_PREP_DECODE_CYCLE_HEIGHT_H

#include "nck/prep/1_decode/state/room.h" // nck_decode_t

// The cycle lacks a word, and the lines behind it are none of another motion's.
// NCK_E_WORD_MISSING. Cost: constant.
nck_status_t nck_cycle_missing(nck_decode_t *self, int letter);

// R and the depth that the line says or that hold, and the levels that follow. Returns NCK_OK,
// NCK_E_WORD_MISSING, NCK_E_NUMBER_RANGE, NCK_E_TRAVEL. Cost: constant.
nck_status_t nck_cycle_heights(nck_decode_t *self);

#endif
