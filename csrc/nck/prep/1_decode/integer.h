// SPDX-License-Identifier: MIT
// Numbers without a point, which Fanuc's controls read in more than one way.
#ifndef NCK_PREP_DECODE_INTEGER_H
#define NCK_PREP_DECODE_INTEGER_H

#include "nck/prep/1_decode/decode.h" // nck_decode_t

// 1 if the number of a word stands in the line, with a point. Cost: linear in its digits.
int nck_decode_says_point(const nck_decode_t *self, int letter);

// 1 if a whole number may count something else than units: the control says least increments, or it
// leaves that open and the program's first is not noted yet. Cost: constant.
int nck_decode_asks_integers(const nck_decode_t *self);

// A number without decimals that stands in the line, in fixed point. 0: it is beyond the scale's
// limit. Cost: linear in its digits.
int nck_decode_integer(nck_decode_t *self, const nck_number_t *word, const nck_scale_t *scale,
                       int64_t *out);

// A number that stands in the line, in fixed point. 0: it is beyond the scale's limit. Most have
// decimals, and are asked no more. Cost: linear in its digits.
static inline int nck_decode_fixed(nck_decode_t *self, const nck_number_t *word,
                                   const nck_scale_t *scale, int64_t *out) {
    if (word->decimals == 0) return nck_decode_integer(self, word, scale, out);
    return nck_number_fixed(self->line.text, word, scale, out);
}

// A word that always counts least increments, as a length [nm]. 0: it is not whole, or beyond the
// range. Cost: constant.
int nck_decode_increments(const nck_decode_t *self, int letter, int64_t *out);

// A word in degrees or seconds, whose least increments are thousandths. Cost: linear in its digits.
double nck_decode_real_word(nck_decode_t *self, int letter);

// 1 if a word of Fanuc's has no point, and the machine does not say what it counts: where its maker
// reads least increments whatever other words do, nobody should guess. Cost: linear in the word.
int nck_decode_asks_unit(const nck_decode_t *self, int letter);

// How much larger a number is than what it means: 1000 or 10 000 where it counts least increments,
// else 1. The number as the program says it. Cost: linear in the digits.
double nck_decode_counts_of(const nck_decode_t *self, const nck_number_t *word);
double nck_decode_counts(const nck_decode_t *self, int letter);
double nck_decode_said(const nck_decode_t *self, int letter);

// A word that is no length, as a factor. Without a point what 1 means goes by the control:
// NCK_E_SCALE_UNIT. Cost: linear in its digits.
nck_status_t nck_decode_plain_word(nck_decode_t *self, int letter, double *value_out);

#endif
