// SPDX-License-Identifier: MIT
// What the files of this wing call of each other, and nobody else. Context of all: prep.
#ifndef NCK_PREP_DECODE_MACRO_PARTS_H
#define NCK_PREP_DECODE_MACRO_PARTS_H

#include "nck/prep/1_decode/macro/macro.h"

// ---- argument.c

// All arguments of the line in work are kept for the call. NCK_E_VARIABLES. Cost: linear in them.
nck_status_t nck_argument_all(nck_decode_t *self);

// ---- jump.c

// What stands behind an O word, or in its place.
typedef enum nck_o_word {
    NCK_O_NOT = 0,   // no O word
    NCK_O_NAME, NCK_O_OTHER, // nothing behind it; something that is none of these
    NCK_O_SUB, NCK_O_ENDSUB, NCK_O_CALL, NCK_O_RETURN, NCK_O_IF, NCK_O_ELSEIF, NCK_O_ELSE,
    NCK_O_ENDIF, NCK_O_DO, NCK_O_REPEAT, NCK_O_WHILE, NCK_O_ENDWHILE, NCK_O_ENDREPEAT, NCK_O_BREAK,
    NCK_O_CONTINUE,
    NCK_O_END        // Fanuc's END…
} nck_o_word_t;

// Go on at a place. NCK_E_NO_SEEK.
nck_status_t nck_jump(nck_decode_t *self, const nck_text_place_t *place);

// The innermost loop of the call in force. NULL: none. Cost: linear in the frames.
nck_frame_t *nck_frame_loop(nck_decode_t *self);

// Pass lines over until the target comes.
void nck_seek(nck_decode_t *self, nck_seek_kind_t kind, uint64_t key);

// Pass lines over until what has been called comes: at once if it is remembered.
nck_status_t nck_seek_called(nck_decode_t *self, nck_seek_kind_t kind, uint64_t key);

// ---- system.c

// The value of a parameter; 1 if the control keeps it itself. NCK_E_UNSUPPORTED, NCK_E_OTHER_BASE,
// NCK_E_NUMBER_RANGE, NCK_E_COMP_ON, NCK_E_UNSET. Cost: linear in the parameters.
nck_status_t nck_parameter_number(nck_decode_t *self, uint32_t number, double *value_out);
nck_status_t nck_parameter_name(nck_decode_t *self, const char *at, const char *end,
                                double *value_out);
int nck_parameter_is_own(const nck_decode_t *self, uint32_t number);

// 1 if a parameter may be set and changes nothing of the path: Fanuc's #3001 … #3004, RS274NGC's
// #5599. Cost: constant.
int nck_parameter_is_switch(const nck_decode_t *self, uint32_t number);

// Set it: #3001 and #3002 count on from there. NCK_E_VARIABLES. Cost: linear in the parameters.
nck_status_t nck_parameter_set_switch(nck_decode_t *self, uint32_t number, double value);

// 1 if the control keeps a parameter itself and the program may set it to what it then is: Fanuc's
// #3003 #3004, RS274NGC's #5061 … #5070. Cost: constant.
int nck_parameter_is_free(const nck_decode_t *self, uint32_t number);

// The limit of the finding that one of these statuses becomes. Cost: constant.
double nck_parameter_limit(nck_status_t status);

// Set one of Fanuc's work offsets, #5221 …, or its external one, #5201 …, in the units in force.
// NCK_E_UNSUPPORTED: it is none; NCK_E_COMP_ON, NCK_E_LAYOUT_ON, NCK_E_VALUE. Cost: constant.
nck_status_t nck_parameter_set_work(nck_decode_t *self, uint32_t number, double value);

// ---- sign.c

// The first of a list that the text spells, from 1, and one past it, 0: none; one past a name's >,
// NULL: none. at: its <. Each word of a list ends with a blank. Cost: linear in the text.
unsigned nck_decode_listed(const char *at, const char *words, const char **behind);
const char *nck_decode_name_end(const char *at);

// One past a number or a name in < >, and its key; NULL: neither.
const char *nck_decode_name_key(const char *at, uint64_t *key_out);

// What a line says about itself.
typedef struct nck_sign {
    uint64_t key;    // of its O word, or behind END
    uint64_t number; // its N
    unsigned word;   // nck_o_word_t
    int numbered;    // 1: it has one
} nck_sign_t;

// The line in work; lines that cannot be read say nothing. Cost: linear in the line.
void nck_decode_sign(const nck_decode_t *self, nck_sign_t *sign_out);

// Which word stands there, and where it ends. Cost: linear in the words.
unsigned nck_decode_word(const char *at, const char **behind);

// ---- keep.c

// A call of that level is over; an output of a restored state, NCK_EMPTY: it owes none.
// NCK_E_COMP_ON. Cost: constant.
void nck_state_return(nck_decode_t *self, uint32_t level);
nck_status_t nck_state_give(nck_decode_t *self, nck_step_t step, nck_block_t *out);

#endif
