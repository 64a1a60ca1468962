// SPDX-License-Identifier: MIT
// What the files of jumps, calls and control words share.
#ifndef NCK_PREP_DECODE_JUMP_H
#define NCK_PREP_DECODE_JUMP_H

#include "nck/prep/1_decode/decode.h" // nck_decode_t

// What stands behind an O word, or in its place.
typedef enum nck_o_word {
    NCK_O_NOT = 0,   // no O word
    NCK_O_NAME, NCK_O_OTHER, // nothing behind it; something that is none of these
    NCK_O_SUB, NCK_O_ENDSUB, NCK_O_CALL, NCK_O_RETURN, NCK_O_IF, NCK_O_ELSEIF, NCK_O_ELSE,
    NCK_O_ENDIF, NCK_O_DO, NCK_O_REPEAT, NCK_O_WHILE, NCK_O_ENDWHILE, NCK_O_ENDREPEAT, NCK_O_BREAK,
    NCK_O_CONTINUE,
    NCK_O_END        // Fanuc's END…
} nck_o_word_t;

// What a line says about itself.
typedef struct nck_sign {
    uint64_t key;    // of its O word, or behind END
    uint64_t number; // its N
    unsigned word;   // nck_o_word_t
    int numbered;    // 1: it has one
} nck_sign_t;

// sign.c: the line in work; lines that cannot be read say nothing. Cost: linear in the line.
void nck_decode_sign(const nck_decode_t *self, nck_sign_t *sign_out);

// sign.c: which word stands there, and where it ends. Cost: linear in the words.
unsigned nck_decode_word(const char *at, const char **behind);

// jump.c: the line's error, and nothing is read behind it.
nck_status_t nck_decode_fail_last(nck_decode_t *self, nck_status_t code, double value,
                                  double limit);

// jump.c: go on at a place. NCK_E_NO_SEEK.
nck_status_t nck_jump(nck_decode_t *self, const nck_text_place_t *place);

// jump.c: the innermost loop of the call in force; the call in force. NULL: none.
nck_frame_t *nck_frame_loop(nck_decode_t *self);
nck_frame_t *nck_frame_call(nck_decode_t *self);

// jump.c: one more frame, for what the line in work begins. NCK_E_DEPTH.
nck_status_t nck_frame_push(nck_decode_t *self, nck_frame_kind_t kind, uint64_t key,
                            uint32_t count);

// jump.c: pass lines over until the target comes.
void nck_seek(nck_decode_t *self, nck_seek_kind_t kind, uint64_t key);

// jump.c: the same for what has been called, and for N…: at once if it is remembered.
nck_status_t nck_seek_called(nck_decode_t *self, nck_seek_kind_t kind, uint64_t key);
nck_status_t nck_seek_number(nck_decode_t *self, uint64_t number);

#endif
