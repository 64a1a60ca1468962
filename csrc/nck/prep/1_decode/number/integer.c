// SPDX-License-Identifier: MIT
// Whole numbers, and those without a point in Fanuc's language: units, or least increments (IS-B).
//
//     X100.  100 mm           X100  100 mm, or 0.1 mm; of 0 nobody asks
#include "nck/prep/1_decode/number/number.h"
#include "nck/prep/1_decode/state/state.h" // nck_decode_assume nck_decode_fail_word
#include "nck/base/real.h" // nck_real_of

enum { DECIMALS = 3, DECIMALS_INCH = 4 }; // of mm, degrees and seconds; of inches

static const nck_number_t *word_of(const nck_decode_t *self, int letter) {
    return &self->words.number[letter - 'A'];
}

static int has_point(const nck_decode_t *self, const nck_number_t *word) {
    for (unsigned k = word->first; k < word->last; k++) {
        if (self->line.text[k] == '.') return 1;
    }
    return 0;
}

// 1 if a number is written as a whole one, but 0.
static int is_integer(const nck_decode_t *self, const nck_number_t *word) {
    return word->last > word->first && word->mantissa != 0 && !has_point(self, word);
}

int nck_decode_says_point(const nck_decode_t *self, int letter) {
    return has_point(self, word_of(self, letter));
}

int nck_decode_asks_integers(const nck_decode_t *self) {
    const uint32_t integers = self->machine->dialect.integers;
    const int noted = (self->finding.notes & 1u << NCK_NOTE_INTEGERS) != 0;
    if (!nck_is_fanuc(self)) return 0;
    return integers == NCK_INTEGERS_INCREMENTS || (integers == NCK_INTEGERS_OPEN && !noted);
}

int nck_decode_asks_unit(const nck_decode_t *self, int letter) {
    return nck_is_fanuc(self)
           && self->machine->dialect.integers == NCK_INTEGERS_OPEN
           && is_integer(self, word_of(self, letter));
}

double nck_decode_counts_of(const nck_decode_t *self, const nck_number_t *word) {
    const int counts = nck_is_fanuc(self)
                       && self->machine->dialect.integers == NCK_INTEGERS_INCREMENTS;
    if (!counts || word->decimals != 0 || !is_integer(self, word)) return 1.0;
    return self->modal.inch ? 1e4 : 1e3;
}

double nck_decode_counts(const nck_decode_t *self, int letter) {
    return nck_decode_counts_of(self, word_of(self, letter));
}

nck_status_t nck_decode_fail_range(nck_decode_t *self, int letter, double limit) {
    const double value = nck_number_real(word_of(self, letter));
    return nck_decode_fail_word(self, NCK_E_NUMBER_RANGE, letter, value, limit);
}

// 1 if a number counts least increments. Where the control leaves it open it does not, and a note
// says so.
static int counts_increments(nck_decode_t *self, const nck_number_t *word) {
    if (!nck_decode_asks_integers(self) || !is_integer(self, word)) return 0;
    if (self->machine->dialect.integers == NCK_INTEGERS_INCREMENTS) return 1;
    nck_decode_assume(self, NCK_NOTE_INTEGERS);
    return 0;
}

// A least increment is the last decimal of a number.
static int read_increments(const nck_decode_t *self, const nck_number_t *word,
                           const nck_scale_t *scale, int64_t *out) {
    const int inches = self->modal.inch && scale != &self->place.scale[2];
    nck_number_t shifted = *word;
    shifted.decimals = (int16_t)(word->decimals + (inches ? DECIMALS_INCH : DECIMALS));
    return nck_number_fixed(self->line.text, &shifted, scale, out);
}

int nck_decode_integer(nck_decode_t *self, const nck_number_t *word, const nck_scale_t *scale,
                       int64_t *out) {
    if (counts_increments(self, word)) return read_increments(self, word, scale, out);
    return nck_number_fixed(self->line.text, word, scale, out);
}

int nck_decode_increments(const nck_decode_t *self, int letter, int64_t *out) {
    const nck_number_t *const word = word_of(self, letter);
    int64_t count = 0;
    return nck_number_whole(word, 0, &count)
           && read_increments(self, word, &self->place.scale[0], out);
}

double nck_decode_real_word(nck_decode_t *self, int letter) {
    const nck_number_t *const word = word_of(self, letter);
    const double value = nck_number_real(word);
    return word->decimals == 0 && counts_increments(self, word) ? value / 1000.0 : value;
}

nck_status_t nck_decode_plain_word(nck_decode_t *self, int letter, double *value_out) {
    const double value = nck_number_real(word_of(self, letter));
    const double unit = self->machine->dialect.scale_unit;
    const int whole = is_integer(self, word_of(self, letter));
    *value_out = whole ? value * unit : value;
    if (!whole || unit > 0.0) return NCK_OK;
    return nck_decode_fail_word(self, NCK_E_SCALE_UNIT, letter, value, 0.0);
}

nck_status_t nck_decode_whole(nck_decode_t *self, char letter, int64_t most, int64_t otherwise,
                              int64_t *out) {
    const nck_number_t *const word = &self->words.number[letter - 'A'];
    *out = otherwise;
    if (!(self->words.letters & NCK_LETTER(letter))) return NCK_OK;
    if (nck_number_whole(word, 0, out) && *out >= 0 && *out <= most) return NCK_OK;
    return nck_decode_fail_range(self, letter, nck_real_of(most));
}
