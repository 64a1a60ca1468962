// SPDX-License-Identifier: MIT
// What the room holds, as every wing sees it: the findings, the block that is given, what is left
// of the line, the parameters that were set.
//
// The face of the wing: what other wings call of it. Context of all: prep.
#ifndef NCK_PREP_DECODE_STATE_STATE_H
#define NCK_PREP_DECODE_STATE_STATE_H

#include "nck/prep/1_decode/state/room.h" // nck_decode_t

// ---- what a line and the machine say

// Does the line have a word of this letter, A to Z? Cost: constant.
static inline int nck_has_word(const nck_decode_t *self, int letter) {
    return (self->words.letters & NCK_LETTER(letter)) != 0;
}

// Is Fanuc's language in force? Cost: constant.
static inline int nck_is_fanuc(const nck_decode_t *self) {
    return self->machine->dialect.base == NCK_DIALECT_FANUC;
}

// A unit of length in force [mm]. Cost: constant.
static inline double nck_unit_mm(const nck_decode_t *self) {
    return self->modal.inch ? 25.4 : 1.0;
}

// ---- finding.c

// Note the line's error, the last one counts. column: 1-based, 0 for the whole line; letter: upper
// case or 0. Returns code. Cost: constant.
nck_status_t nck_decode_fail(nck_decode_t *self, nck_status_t code, unsigned column, int letter,
                             double value, double limit);

// The same at a place of the line's text; for a word of the line: its column and letter.
nck_status_t nck_decode_fail_at(nck_decode_t *self, nck_status_t code, const char *at, int letter,
                                double value, double limit);
nck_status_t nck_decode_fail_word(nck_decode_t *self, nck_status_t code, int letter, double value,
                                  double limit);
// The same at the code of a step, if the line has one; for that code itself.
nck_status_t nck_decode_fail_step(nck_decode_t *self, nck_status_t code, nck_step_t step,
                                  int letter, double value, double limit);
nck_status_t nck_decode_fail_code(nck_decode_t *self, nck_status_t code, nck_step_t step);
// The code of a step cannot do without a word: NCK_E_WORD_MISSING.
nck_status_t nck_decode_fail_missing(nck_decode_t *self, nck_step_t step, int letter);

// Is the text at a place in the language that is read? whose: bits of nck_tongue_t.
// NCK_E_OTHER_BASE. Cost: constant.
nck_status_t nck_decode_only(nck_decode_t *self, const char *at, uint32_t whose);

// Queue a finding. Cost: constant.
void nck_decode_find(nck_decode_t *self, const nck_diagnostic_t *finding);

// Give a note if the program leaves it to the machine. Cost: constant.
void nck_decode_assume(nck_decode_t *self, nck_note_t note);
// The notes on what places need: the units, and what they count from.
void nck_decode_assume_places(nck_decode_t *self);

// Give a note of these numbers, once in a program. Cost: constant.
void nck_decode_note(nck_decode_t *self, const nck_diagnostic_t *finding);

// Give a note, once in a program, about what a word asks for. Cost: constant.
void nck_decode_note_word(nck_decode_t *self, nck_note_t note, char letter, double value);
// The same about a G code.
void nck_decode_note_code(nck_decode_t *self, nck_note_t note, nck_step_t step, double code);

// ---- output.c

// The most under G96 [rpm], 0: none; 1 if the spindle turns. Cost: constant.
double nck_decode_speed_most(const nck_decode_t *self);
int nck_decode_turns(const nck_decode_t *self);

// A block that hands something over.
nck_status_t nck_decode_give_output(const nck_decode_t *self, nck_block_kind_t block,
                                    nck_output_kind_t kind, double value, nck_block_t *out);

// An M code as an output; a dwell. Cost: constant.
nck_status_t nck_decode_give_m(const nck_decode_t *self, double code, nck_block_t *out);
nck_status_t nck_decode_give_dwell(const nck_decode_t *self, double dwell_s, nck_block_t *out);

// Fill a block with all that is modal; the target is the present position. Cost: constant.
void nck_decode_block(const nck_decode_t *self, nck_block_kind_t kind, nck_block_t *out);

// A tool of the table, NULL if it has none of that number. Cost: linear in the tools.
const nck_tool_t *nck_decode_find_tool(const nck_decode_t *self, uint32_t number);

// ---- rest.c

// At a /: is what stands behind it skipped? *at: one past it, its number. Cost: constant.
int nck_decode_skips(const nck_decode_t *self, const char **at);

// Something is left of the line. Cost: constant.
void nck_decode_leave(nck_decode_t *self, nck_rest_t rest);

// The line begins a spline whose end is another line; 1 if one is not ended; what a step that moves
// does meanwhile; a line of it was refused, and its others are no mistakes; the program ends:
// NCK_E_SPLINE. Cost: constant.
void nck_spline_begins(nck_decode_t *self);
int nck_spline_waits(const nck_decode_t *self);
nck_status_t nck_spline_refuses(nck_decode_t *self, nck_step_t step);
void nck_spline_break(nck_decode_t *self);
nck_status_t nck_spline_missing(nck_decode_t *self);

// ---- variables.c

// 1 if it is a value; 1 if it is one and not 0, so that a condition holds; 1 if it is nearly the
// number of a parameter. Cost: constant.
int nck_value_is(double value);
int nck_value_holds(double value);
int nck_value_index(double value, uint32_t *index_out);

// The key of a name; a parameter that was set, NULL: it was not.
uint64_t nck_variable_name(const char *at, const char *end);
const double *nck_variable_find(const nck_decode_t *self, uint64_t key);

// A value that counts from the end of the line on; all of them count now, or none if the line is
// wrong (its status, handed back); one more of the call in force. NCK_E_VARIABLES. Cost: linear in
// the parameters.
nck_status_t nck_variable_wait(nck_decode_t *self, uint64_t key, double value);
nck_status_t nck_variable_commit(nck_decode_t *self, nck_status_t line);
nck_status_t nck_variable_add(nck_decode_t *self, uint64_t key, double value);

// A parameter that counts at once. NCK_E_VARIABLES. Cost: linear in the parameters.
nck_status_t nck_variable_set(nck_decode_t *self, uint64_t key, double value);

// The key of what G10 has changed in a tool, and in the zero of G54.1 P; a program begins: only
// these stay. Cost: linear in the parameters.
uint64_t nck_variable_work(uint32_t number, unsigned axis);
uint64_t nck_variable_tool(uint32_t number, unsigned field);
void nck_variable_restart(nck_decode_t *self);

// What must hold between two lines. Cost: constant.
int nck_variable_invariants(const nck_decode_t *self);

// Arguments that are kept for the next call (modal: of G66): the key of one; forget those of the
// call in force; copy those of the caller, whose rows begin at `from`.
uint64_t nck_variable_kept(uint64_t number, int modal);
void nck_variable_drop_kept(nck_decode_t *self, int modal);
nck_status_t nck_variable_copy_kept(nck_decode_t *self, uint32_t from, int modal);

#endif
