// SPDX-License-Identifier: MIT
// Numbers and words: what a number of the line means, in counts of its axis.
//
// The face of the wing: what other wings call of it. Context of all: prep.
#ifndef NCK_PREP_DECODE_NUMBER_NUMBER_H
#define NCK_PREP_DECODE_NUMBER_NUMBER_H

#include "nck/prep/1_decode/state/room.h" // nck_decode_t

// ---- number.c

// Read a number: blanks, sign, digits and one point, blanks between them included (as RS274NGC
// does). text: the line, ended by a line feed; at: where the number is to begin. Returns one past
// the number and the blanks after it, or a null pointer if there is no digit. Cost: linear in the
// characters. Context: prep.
const char *nck_number_read(const char *text, const char *at, nck_number_t *out);

// The number in fixed point, rounded half to even from all of its digits. Returns 1, or 0 if its
// magnitude is above scale->limit (*out is untouched). Cost: constant, or linear in the digits of a
// long number. Context: prep.
int nck_number_fixed(const char *text, const nck_number_t *number, const nck_scale_t *scale,
                     int64_t *out);

// The number in floating point: the nearest one up to 15 significant digits, at most 2 ulp away
// beyond. Cost: constant, or linear in the digits of a long number. Context: prep.
double nck_number_real(const nck_number_t *number);

// The same of a word of the line. Cost: as that.
static inline double nck_word_real(const nck_decode_t *self, int letter) {
    return nck_number_real(&self->words.number[letter - 'A']);
}

// A number of so many tenths, which stands nowhere in the line. Cost: constant. Context: prep.
void nck_number_tenths(int32_t tenths, nck_number_t *out);

// The number times 10^places if that is whole. Returns 1, or 0 if it is not whole or above 1e15;
// places: 0 or 1. Cost: constant. Context: prep.
int nck_number_whole(const nck_number_t *number, int places, int64_t *out);

// ---- integer.c

// A whole number of a word within 0 … most; without the word `otherwise`. NCK_E_NUMBER_RANGE.
nck_status_t nck_decode_whole(nck_decode_t *self, char letter, int64_t most, int64_t otherwise,
                              int64_t *out);

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
// else 1. Cost: linear in the digits.
double nck_decode_counts_of(const nck_decode_t *self, const nck_number_t *word);
double nck_decode_counts(const nck_decode_t *self, int letter);

// What a word says is beyond a limit: NCK_E_NUMBER_RANGE, noted. Cost: as nck_number_real.
nck_status_t nck_decode_fail_range(nck_decode_t *self, int letter, double limit);

// A word that is no length, as a factor. Without a point what 1 means goes by the control:
// NCK_E_SCALE_UNIT. Cost: linear in its digits.
nck_status_t nck_decode_plain_word(nck_decode_t *self, int letter, double *value_out);

// ---- bits.c

// The bits of a whole number 0 … 2^32 − 1. Returns 0 if it is none. Cost: constant. Context: any.
int nck_bits(double value, uint32_t *bits_out);

// 0 … 99999999 as BCD (15 → 21), and back; −1: it cannot be. Cost: constant. Context: any.
double nck_to_bcd(double value);
double nck_from_bcd(double value);

// ---- power.c

// e^x; relative error ≤ 4 ulp; infinity beyond the largest number, 0 below the smallest one. Cost:
// constant. Context: any.
double nck_exp(double x);

// The natural logarithm of x > 0 (normal); relative error ≤ 4 ulp beside 1. Cost: constant.
// Context: any.
double nck_log(double x);

// base^exponent; base < 0 only with a whole exponent, 0 only with a positive one or 0. Whole ones
// up to 1024 by products. Cost: constant. Context: any.
double nck_power(double base, double exponent);

// The rest of a / b, exact, with the sign of a; b is not 0. Cost: linear in the binary digits of
// the quotient, 2100 at most. Context: any.
double nck_rest(double a, double b);

// ---- axis.c

// The letter of axis 0 … 8: X Y Z A B C U V W. Cost: constant.
int nck_decode_letter(unsigned axis);

// The word of an axis, [nm] or [ndeg]; NCK_E_NUMBER_RANGE. Cost: constant.
nck_status_t nck_decode_axis_word(nck_decode_t *self, unsigned axis, int64_t *value_out);

// A place or a way of a linear axis as a word: nine decimals name every nanometre, in inches too.
// Cost: constant.
void nck_decode_write(const nck_decode_t *self, unsigned axis, int64_t value_nm, nck_number_t *out);

// A length [nm] that stands in the line, whatever its letter. NCK_E_NUMBER_RANGE.
nck_status_t nck_decode_length_word(nck_decode_t *self, char letter, int64_t *value_out);

// A value of so many counts as a word of that scale says it. Cost: constant.
double nck_decode_as_word(const nck_scale_t *scale, double value_nm);

// A place of an axis is beyond what it may be, its word counting so many times in it. Told is the
// word, and the largest that is within; without a word the place. NCK_E_NUMBER_RANGE.
nck_status_t nck_decode_beyond(nck_decode_t *self, unsigned axis, double at_nm, double times);

// Count steps on from a machine position of an axis. NCK_E_NUMBER_RANGE. Cost: constant.
nck_status_t nck_decode_steps(nck_decode_t *self, unsigned axis, int64_t step_nm, int64_t count,
                              int64_t *at_nm);

// Tells once that an axis stays at an end of its travel, and where it was to go. Cost: constant.
void nck_decode_note_end(nck_decode_t *self, unsigned axis, int64_t place_nm, int64_t end_nm);

// Is a machine position within the travel of its axis? NCK_E_TRAVEL. Cost: constant.
nck_status_t nck_decode_travel(nck_decode_t *self, unsigned axis, int64_t position_nm);

// The scales of axis words, after a change of units or of diameter mode. Cost: constant.
void nck_decode_scale(nck_decode_t *self);

// The scale of an axis' words. Cost: constant.
static inline const nck_scale_t *nck_decode_scale_of(const nck_decode_t *self, unsigned axis) {
    if (axis == NCK_AXIS_X) return &self->place.scale[1];
    return &self->place.scale[self->place.rotary >> axis & 1u ? 2 : 0];
}

#endif
