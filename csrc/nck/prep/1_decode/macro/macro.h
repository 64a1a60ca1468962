// SPDX-License-Identifier: MIT
// Parameters, expressions, control words, calls and jumps.
//
// The face of the wing: what other wings call of it. Context of all: prep.
#ifndef NCK_PREP_DECODE_MACRO_MACRO_H
#define NCK_PREP_DECODE_MACRO_MACRO_H

#include "nck/prep/1_decode/state/room.h" // nck_decode_t

// ---- argument.c

// Of an I, J or K of G65 or G66: which one in the row of them it is, from 1, and its number, which
// is kept for the call. NCK_E_WORD_TWICE, NCK_E_UNSUPPORTED: in an order that leaves open which;
// NCK_E_VARIABLES. Cost: linear in the arguments.
nck_status_t nck_argument_place(nck_decode_t *self, const char *at, unsigned *place_out);
nck_status_t nck_argument_keep(nck_decode_t *self, const char *at, unsigned place,
                               const nck_number_t *number);

// ---- call.c

// M98, M99, G65, G66, G67.
nck_status_t nck_decode_call(nck_decode_t *self, nck_block_t *out);

// A move is done: while G66 is in force its call stands behind it. Plain lines ask no more.
void nck_decode_call_behind(nck_decode_t *self);
static inline void nck_decode_moved(nck_decode_t *self) {
    if (NCK_HAS_CALLS && self->macro.modal != 0) nck_decode_call_behind(self);
}

// The innermost call is over: it returns, or is done again. NCK_E_FLOW: there is none. Cost: linear
// in the parameters. Context: prep.
nck_status_t nck_call_return(nck_decode_t *self);

// Call what the key names, so many times. kind: of its frame. NCK_E_NO_SEEK, NCK_E_DEPTH,
// NCK_E_VARIABLES. Cost: linear in the parameters. Context: prep.
nck_status_t nck_call(nck_decode_t *self, nck_frame_kind_t kind, uint64_t key, uint32_t count);

// ---- control.c

// # … =: waits for the end of the line. Cost: linear in the line.
nck_status_t nck_decode_assign(nck_decode_t *self, const char **at);

// IF, GOTO, WHILE, DO, END. NCK_EMPTY: it is none of them. Cost: linear in the line.
nck_status_t nck_decode_control(nck_decode_t *self, const char **at);

// ---- expression.c

// A value that begins with #, [, a sign, a function or a digit; bare: operators may stand outside
// of brackets. May be NCK_NO_VALUE. Cost: linear in the text.
nck_status_t nck_decode_value(nck_decode_t *self, const char **at, int bare, double *value_out);

// A value as a number of the program.
void nck_decode_number(double value, nck_number_t *out);

// ---- jump.c

// The line in work while something is looked for: NCK_OK: it is to be read, NCK_EMPTY: it is passed
// over. The end of the text while something is looked for. The calls in force, behind an error.
nck_status_t nck_seek_pass(nck_decode_t *self);
nck_status_t nck_seek_wrap(nck_decode_t *self);
void nck_decode_tell_calls(nck_decode_t *self);

// How many calls are in force. Cost: linear in the frames.
uint32_t nck_call_level(const nck_decode_t *self);

// The line's error, and nothing is read behind it.
nck_status_t nck_decode_fail_last(nck_decode_t *self, nck_status_t code, double value,
                                  double limit);

// The call in force. NULL: none. Cost: linear in the frames.
nck_frame_t *nck_frame_call(nck_decode_t *self);

// One more frame, for what the line in work begins. NCK_E_DEPTH.
nck_status_t nck_frame_push(nck_decode_t *self, nck_frame_kind_t kind, uint64_t key,
                            uint32_t count);

// Pass lines over until N… comes: at once if it is remembered.
nck_status_t nck_seek_number(nck_decode_t *self, uint64_t number);

// ---- oword.c

// An O word. Cost: linear in the line.
nck_status_t nck_decode_o_word(nck_decode_t *self, const char **at);

// ---- system.c

// A probe has ended where the axes stand: #5061 … #5070. NCK_E_VARIABLES. Cost: linear in the
// parameters.
nck_status_t nck_parameter_set_probe(nck_decode_t *self, int touched);

// M66 has found that: #5399. NCK_E_VARIABLES. Cost: linear in the parameters.
nck_status_t nck_parameter_set_answer(nck_decode_t *self, double value);

// ---- sign.c

// One past blanks and remarks; one past the word (upper case) if the text spells it, in either
// case, else NULL. Cost: linear in the text.
const char *nck_decode_skip(const char *at);
const char *nck_decode_spells(const char *at, const char *word);

// ---- keep.c

// M70 … M73. NCK_E_DEPTH, NCK_E_FLOW, NCK_E_COMP_ON. Cost: constant.
nck_status_t nck_decode_state(nck_decode_t *self, nck_block_t *out);

#endif
