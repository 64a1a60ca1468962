// SPDX-License-Identifier: MIT
// A line, or a block in its place, becomes words and steps.
//
// The face of the wing: what other wings call of it. Context of all: prep.
#ifndef NCK_PREP_DECODE_LINE_LINE_H
#define NCK_PREP_DECODE_LINE_LINE_H

#include "nck/prep/1_decode/state/room.h" // nck_decode_t

// ---- words.c

// The line from `at` on as words. Cost: linear in the line.
nck_status_t nck_decode_words(nck_decode_t *self, const char *at);

// The line in work is refused. If it says a feed, a speed or the first motion, that one is missing
// behind it is no mistake of its own. Cost: linear in the line.
void nck_decode_excuse(nck_decode_t *self);

// ---- resolve.c

// Do words and codes of the line fit, and who gets the axis words? Cost: constant.
nck_status_t nck_decode_resolve(nck_decode_t *self);

// ---- block_in.c

// 1 if every member is within its range. Cost: constant.
int nck_decode_block_good(const nck_block_in_t *block);

// The pushed block becomes the line in work: its settings count, its steps are set. Cost: constant.
nck_status_t nck_decode_pushed(nck_decode_t *self);

// What the pushed block does.
nck_status_t nck_decode_give_pushed(nck_decode_t *self, nck_block_t *out);

// ---- quick.c

// The block of a line that only moves X Y Z straight, in a program that has begun. Returns 1, or 0
// with nothing done: the line says more, or is wrong. Cost: linear in the line.
int nck_decode_quick(nck_decode_t *self, nck_block_t *out);

// ---- remark.c

// LinuxCNC's remarks from `first` on: one in another one is NCK_E_COMMENT, letter (; where the last
// one says (abort, …) the program ends before the line. Cost: linear in the line.
nck_status_t nck_decode_remarks(nck_decode_t *self, const char *first);

#endif
