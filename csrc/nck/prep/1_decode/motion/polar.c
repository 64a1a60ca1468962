// SPDX-License-Identifier: MIT
// RS274NGC's polar words: @ is the distance from the program's zero, ^ the angle from X [deg]. They
// become words of X and Y.
#include "nck/prep/1_decode/motion/parts.h"
#include "nck/prep/1_decode/state/state.h" // nck_decode_fail nck_decode_fail_at nck_decode_only
#include "nck/prep/1_decode/number/number.h" // nck_decode_write nck_number_read nck_number_real
#include "nck/prep/1_decode/place/place.h" // nck_turned_place
#include "nck/prep/1_decode/macro/macro.h" // nck_decode_skip nck_decode_value
#include "nck/base/real.h" // nck_sincos nck_atan2 nck_sqrt nck_rounded

#include <stddef.h> // NULL

enum { DISTANCE = 1, ANGLE = 2, FLAT_PLANE = 17 };

static const double degree = 3.14159265358979323846 / 180.0;
static const double value_most = NCK_DECODE_VALUE_MAX;
static const double least_mm = 1e-6; // nearer to the zero there is no angle: a nanometre

nck_status_t nck_polar_read(nck_decode_t *self, const char **at) {
    nck_words_t *const words = &self->words;
    const char *const first = *at;
    const unsigned bit = *first == '@' ? DISTANCE : ANGLE;
    nck_number_t number;
    double value = 0.0;
    const nck_status_t speaks = nck_decode_only(self, first, NCK_TONGUE_LINUXCNC);
    if (speaks != NCK_OK) return speaks;
    if (words->polars & bit) {
        return nck_decode_fail_at(self, NCK_E_WORD_TWICE, first, *first, 0.0, 0.0);
    }
    const char *const behind = nck_number_read(self->line.text, first + 1, &number);
    *at = behind != NULL ? behind : nck_decode_skip(first + 1);
    if (behind != NULL) value = nck_number_real(&number);
    else {
        const nck_status_t status = nck_decode_value(self, at, 0, &value);
        if (status != NCK_OK) return status;
    }
    if (!(value >= -value_most && value <= value_most)) {
        return nck_decode_fail_at(self, NCK_E_NUMBER_RANGE, first, *first, value, value_most);
    }
    if (words->polars == 0) words->polar_column = (uint16_t)(first - self->line.text + 1);
    words->polars |= (uint8_t)bit;
    words->polar_step[bit - 1] = value;
    return NCK_OK;
}

static nck_status_t fail(nck_decode_t *self, nck_status_t code) {
    const unsigned column = self->words.polar_column;
    return nck_decode_fail(self, code, column, self->line.text[column - 1], 0.0, 0.0);
}

// The words of X and Y that lead to the place.
static void write_words(nck_decode_t *self) {
    nck_words_t *const words = &self->words;
    const unsigned first = (unsigned)('X' - 'A');
    double way[2];
    nck_sincos(words->polar_at[1] * degree, &way[1], &way[0]);
    for (unsigned axis = 0; axis < 2; axis++) {
        const double place_nm = words->polar_at[0] * way[axis] * (double)NCK_COUNTS_PER_MM;
        int64_t value_nm = nck_rounded(place_nm);
        if (nck_motion_adds(self)) value_nm -= nck_turned_place(self, axis);
        nck_decode_write(self, axis, value_nm, &words->number[first + axis]);
        words->column[first + axis] = words->polar_column;
    }
}

// What is not said stays; steps are added to where the tool stands.
static nck_status_t find_place(nck_decode_t *self) {
    nck_words_t *const words = &self->words;
    const double x = (double)nck_turned_place(self, 0) / (double)NCK_COUNTS_PER_MM;
    const double y = (double)nck_turned_place(self, 1) / (double)NCK_COUNTS_PER_MM;
    const double distance = nck_sqrt(x * x + y * y);
    const int adds = nck_motion_adds(self);
    if (!(words->polars & DISTANCE)) words->polar_step[0] = 0.0;
    if (!(words->polars & ANGLE)) words->polar_step[1] = 0.0;
    words->polar_step[0] *= self->modal.inch ? 25.4 : 1.0;
    words->polar_at[0] = words->polar_step[0];
    words->polar_at[1] = words->polar_step[1];
    if (adds && distance < least_mm) return fail(self, NCK_E_VALUE);
    if (adds || !(words->polars & DISTANCE)) words->polar_at[0] += distance;
    if (adds || !(words->polars & ANGLE)) words->polar_at[1] += nck_atan2(y, x) / degree;
    const double most = NCK_LINEAR_MAX_MM;
    const int is_near = words->polar_at[0] >= -most && words->polar_at[0] <= most;
    return is_near ? NCK_OK : fail(self, NCK_E_NUMBER_RANGE);
}

nck_status_t nck_polar_resolve(nck_decode_t *self) {
    if (!NCK_HAS_LAYOUTS) return NCK_E_UNSUPPORTED;
    nck_words_t *const words = &self->words;
    const uint32_t letters = NCK_LETTER('X') | NCK_LETTER('Y');
    if (words->polars & NCK_POLAR_SLANT) return nck_slant_resolve(self);
    if (words->letters & letters) return fail(self, NCK_E_WORD_SHARED);
    if (words->codes & NCK_MOVES_ZERO) return fail(self, NCK_E_INCREMENTAL);
    if (self->modal.plane != FLAT_PLANE) return fail(self, NCK_E_UNSUPPORTED);
    const nck_status_t status = find_place(self);
    if (status != NCK_OK) return status;
    write_words(self);
    words->letters |= letters;
    return NCK_OK;
}

void nck_polar_next(nck_decode_t *self) {
    if (!NCK_HAS_LAYOUTS) return;
    nck_words_t *const words = &self->words;
    words->polar_at[0] += words->polar_step[0];
    words->polar_at[1] += words->polar_step[1];
    write_words(self);
}
