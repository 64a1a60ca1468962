// SPDX-License-Identifier: MIT
// The words of the axes: their letters and numbers, the target they name, the travel.
#include "nck/prep/1_decode/parts.h"

#include <string.h> // memcpy

int nck_decode_letter(unsigned axis) {
    static const char letters[] = "XYZABCUVW";
    return letters[axis];
}

// [mm] or [deg]
static double shown(const nck_decode_t *self, unsigned axis, int64_t value_nm) {
    const int rotary = (self->place.rotary >> axis & 1u) != 0;
    return (double)value_nm / (rotary ? NCK_COUNTS_PER_DEG : NCK_COUNTS_PER_MM);
}

static const nck_scale_t *scale_of(const nck_decode_t *self, unsigned axis) {
    if (axis == NCK_AXIS_X) return &self->place.scale[1];
    return &self->place.scale[self->place.rotary >> axis & 1u ? 2 : 0];
}

static unsigned column_of_axis(const nck_decode_t *self, unsigned axis) {
    const int letter = nck_decode_letter(axis);
    const int said = (self->words.letters & NCK_LETTER(letter)) != 0;
    return said ? self->words.column[letter - 'A'] : 0;
}

nck_status_t nck_decode_axis_word(nck_decode_t *self, unsigned axis, int64_t *value_out) {
    const int letter = nck_decode_letter(axis);
    const nck_number_t *const word = &self->words.number[letter - 'A'];
    const nck_scale_t *const scale = scale_of(self, axis);
    if (nck_number_fixed(self->line.text, word, scale, value_out)) return NCK_OK;
    return nck_decode_fail_word(self, NCK_E_NUMBER_RANGE, letter, nck_number_real(word),
                                shown(self, axis, scale->limit));
}

const nck_scale_t *nck_decode_scale_of(const nck_decode_t *self, unsigned axis) {
    return scale_of(self, axis);
}

nck_status_t nck_decode_length_word(nck_decode_t *self, char letter, int64_t *value_out) {
    const nck_number_t *const word = &self->words.number[letter - 'A'];
    if (nck_number_fixed(self->line.text, word, &self->place.scale[0], value_out)) return NCK_OK;
    return nck_decode_fail_word(self, NCK_E_NUMBER_RANGE, letter, nck_number_real(word),
                                NCK_LINEAR_MAX_MM);
}

nck_status_t nck_decode_steps(nck_decode_t *self, unsigned axis, int64_t step_nm, int64_t count,
                              int64_t *at_nm) {
    const int64_t limit_nm = scale_of(self, axis)->limit;
    const double end_nm = (double)*at_nm + (double)step_nm * (double)count;
    if (end_nm >= -(double)limit_nm && end_nm <= (double)limit_nm) {
        *at_nm += step_nm * count;
        return NCK_OK;
    }
    return nck_decode_fail(self, NCK_E_NUMBER_RANGE, column_of_axis(self, axis),
                           nck_decode_letter(axis), end_nm / 1e6, shown(self, axis, limit_nm));
}

nck_status_t nck_decode_travel(nck_decode_t *self, unsigned axis, int64_t position_nm) {
    const nck_axis_t *const travel = &self->machine->axis[axis];
    if (position_nm >= travel->min_nm && position_nm <= travel->max_nm) return NCK_OK;
    const int64_t limit_nm = position_nm < travel->min_nm ? travel->min_nm : travel->max_nm;
    return nck_decode_fail(self, NCK_E_TRAVEL, column_of_axis(self, axis), nck_decode_letter(axis),
                           shown(self, axis, position_nm), shown(self, axis, limit_nm));
}

nck_status_t nck_decode_target(nck_decode_t *self, int absolute, int64_t *target_nm) {
    memcpy(target_nm, self->place.position_nm, sizeof self->place.position_nm);
    uint32_t axes = self->words.axes;
    for (unsigned axis = 0; axes != 0; axis++, axes >>= 1) {
        int64_t value = 0;
        if (!(axes & 1u)) continue;
        const nck_status_t status = nck_decode_axis_word(self, axis, &value);
        if (status != NCK_OK) return status;
        if (!absolute) {
            value += self->modal.incremental ? self->place.position_nm[axis]
                                             : self->place.origin_nm[axis];
        }
        const int64_t limit = scale_of(self, axis)->limit;
        if (value < -limit || value > limit) {
            return nck_decode_fail_word(self, NCK_E_NUMBER_RANGE, nck_decode_letter(axis),
                                        shown(self, axis, value), shown(self, axis, limit));
        }
        target_nm[axis] = value;
    }
    return NCK_OK;
}
