// SPDX-License-Identifier: MIT
// The words of the axes: their letters, scales and numbers, where they count from, the travel.
#include "nck/prep/1_decode/number/number.h"
#include "nck/prep/1_decode/state/state.h" // nck_decode_fail nck_decode_fail_word
#include "nck/base/real.h" // nck_real_of

enum { DECIMALS = 9, PLACES = 10000 }; // 10^(DECIMALS − 5)

int nck_decode_letter(unsigned axis) {
    static const char letters[] = "XYZABCUVW";
    return letters[axis];
}

// A value as it is told [mm] or [deg].
static double shown(const nck_decode_t *self, unsigned axis, int64_t value_nm) {
    const int rotary = (self->place.rotary >> axis & 1u) != 0;
    return nck_real_of(value_nm) / (rotary ? NCK_COUNTS_PER_DEG : NCK_COUNTS_PER_MM);
}

double nck_decode_as_word(const nck_scale_t *scale, double value_nm) {
    double unit = (double)scale->factor;
    for (int32_t k = 0; k < scale->power; k++) unit *= 10.0;
    return value_nm / unit;
}

static unsigned column_of_axis(const nck_decode_t *self, unsigned axis) {
    const int letter = nck_decode_letter(axis);
    const int said = (self->words.letters & NCK_LETTER(letter)) != 0;
    return said ? self->words.column[letter - 'A'] : 0;
}

static nck_status_t read_word(nck_decode_t *self, int letter, const nck_scale_t *scale,
                              int64_t *value_out) {
    const nck_number_t *const word = &self->words.number[letter - 'A'];
    if (nck_decode_fixed(self, word, scale, value_out)) return NCK_OK;
    const double limit = nck_decode_as_word(scale, nck_real_of(scale->limit));
    return nck_decode_fail_range(self, letter, limit * nck_decode_counts(self, letter));
}

nck_status_t nck_decode_axis_word(nck_decode_t *self, unsigned axis, int64_t *value_out) {
    return read_word(self, nck_decode_letter(axis), nck_decode_scale_of(self, axis), value_out);
}

void nck_decode_write(const nck_decode_t *self, unsigned axis, int64_t value_nm,
                      nck_number_t *out) {
    const int64_t size_nm = value_nm < 0 ? -value_nm : value_nm;
    const int32_t factor = nck_decode_scale_of(self, axis)->factor;
    *out = (nck_number_t){0};
    out->mantissa = (size_nm * PLACES + factor / 2) / factor;
    out->decimals = DECIMALS;
    out->negative = value_nm < 0;
}

nck_status_t nck_decode_length_word(nck_decode_t *self, char letter, int64_t *value_out) {
    return read_word(self, letter, &self->place.scale[0], value_out);
}

nck_status_t nck_decode_beyond(nck_decode_t *self, unsigned axis, double at_nm, double times) {
    const nck_scale_t *const scale = nck_decode_scale_of(self, axis);
    const int letter = nck_decode_letter(axis);
    const int said = (self->words.letters & NCK_LETTER(letter)) != 0;
    const double most_nm = at_nm < 0.0 ? -nck_real_of(scale->limit) : nck_real_of(scale->limit);
    const double at = nck_decode_as_word(scale, at_nm), most = nck_decode_as_word(scale, most_nm);
    const double counts = nck_decode_counts(self, letter);
    const double word = nck_word_real(self, letter);
    if (!said) return nck_decode_fail_word(self, NCK_E_NUMBER_RANGE, letter, at, most);
    return nck_decode_fail_word(self, NCK_E_NUMBER_RANGE, letter, word,
                                word - (at - most) * counts / times);
}

nck_status_t nck_decode_steps(nck_decode_t *self, unsigned axis, int64_t step_nm, int64_t count,
                              int64_t *at_nm) {
    const double limit_nm = nck_real_of(nck_decode_scale_of(self, axis)->limit);
    const double end_nm = nck_real_of(*at_nm) + nck_real_of(step_nm) * nck_real_of(count);
    if (!(end_nm >= -limit_nm && end_nm <= limit_nm)) {
        return nck_decode_beyond(self, axis, end_nm, nck_real_of(count) + 1.0);
    }
    *at_nm += step_nm * count;
    return NCK_OK;
}

nck_status_t nck_decode_travel(nck_decode_t *self, unsigned axis, int64_t position_nm) {
    const nck_axis_t *const travel = &self->machine->axis[axis];
    if (position_nm >= travel->min_nm && position_nm <= travel->max_nm) return NCK_OK;
    if (self->machine->roams || self->modal.roams) return NCK_OK;
    const int64_t limit_nm = position_nm < travel->min_nm ? travel->min_nm : travel->max_nm;
    return nck_decode_fail(self, NCK_E_TRAVEL, column_of_axis(self, axis), nck_decode_letter(axis),
                           shown(self, axis, position_nm), shown(self, axis, limit_nm));
}

void nck_decode_note_end(nck_decode_t *self, unsigned axis, int64_t place_nm, int64_t end_nm) {
    const nck_diagnostic_t finding = {
        NCK_NOTE_CLAMPED, self->line.tag, column_of_axis(self, axis), nck_decode_letter(axis),
        shown(self, axis, place_nm), shown(self, axis, end_nm)
    };
    nck_decode_note(self, &finding);
}

void nck_decode_scale(nck_decode_t *self) {
    nck_scale_t *const scale = self->place.scale;
    const int32_t per_mm = self->modal.inch ? 254 : 10;
    const int64_t linear_max = (int64_t)NCK_LINEAR_MAX_MM * NCK_COUNTS_PER_MM;
    const int64_t rotary_max = (int64_t)NCK_ROTARY_MAX_DEG * NCK_COUNTS_PER_DEG;

    scale[0] = (nck_scale_t){per_mm, 5, linear_max};
    scale[1] = (nck_scale_t){self->modal.diameter ? per_mm / 2 : per_mm, 5, linear_max};
    scale[2] = (nck_scale_t){NCK_COUNTS_PER_DEG / 1000000, 6, rotary_max};
}
