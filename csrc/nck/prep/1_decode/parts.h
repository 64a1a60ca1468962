// SPDX-License-Identifier: MIT
// What the files of this room's door call of each other, and nobody else. Context of all: prep.
#ifndef NCK_PREP_DECODE_PARTS_H
#define NCK_PREP_DECODE_PARTS_H

#include "nck/prep/1_decode/decode.h" // nck_decode_t

// ---- entry.c

// Where the axes stand before a program that begins in the middle; 1 if it begins here, with the
// line in work or the one that waits; a jump of that kind has met a line; a block before it:
// NCK_OK: it is of the path, NCK_EMPTY: it is not handed over; the next block of what is in force
// there, NCK_EMPTY behind the last one. NCK_E_LABEL: the program never comes to it; NCK_E_APPROACH.
// Cost: constant.
void nck_entry_begin(nck_decode_t *self);
int nck_entry_is_here(nck_decode_t *self);
void nck_entry_leave_out(nck_decode_t *self, nck_seek_kind_t kind);
nck_status_t nck_entry_pass(nck_decode_t *self, const nck_block_t *block);
nck_status_t nck_entry_next(nck_decode_t *self, nck_block_t *out);

// ---- session.c

// The line in work, if there is one, has not begun. Cost: a copy of the room. Context: prep.
void nck_session_go_back(struct nck_decode *self);

// ---- source.c

// The next line of the source, or the end of the text; what follows the program's end.
void nck_decode_fetch(nck_decode_t *self);
void nck_decode_watch(nck_decode_t *self);

#endif
