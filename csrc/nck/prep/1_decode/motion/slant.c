// SPDX-License-Identifier: MIT
// Fanuc's ,A: the angle of a line in its plane, from the plane's first axis [deg]. One axis of the
// plane is said, and what the other one would be becomes its word.
#include "nck/prep/1_decode/motion/parts.h"
#include "nck/prep/1_decode/state/state.h" // nck_decode_fail
#include "nck/prep/1_decode/number/number.h" // nck_decode_axis_word nck_decode_write …
#include "nck/prep/1_decode/place/place.h" // nck_plane_axes
#include "nck/base/real.h" // nck_fabs nck_sincos nck_rounded

static const double degree = 3.14159265358979323846 / 180.0;
static const double angle_most = 360.0;

static nck_status_t fail(nck_decode_t *self, nck_status_t code, double value, double limit) {
    return nck_decode_fail(self, code, self->words.polar_column, ',', value, limit);
}

nck_status_t nck_slant_keep(nck_decode_t *self, unsigned column, const nck_number_t *number) {
    nck_words_t *const words = &self->words;
    const double angle = nck_number_real(number);
    const int again = words->polars != 0;
    words->polar_column = (uint16_t)column;
    words->polars = NCK_POLAR_SLANT;
    words->polar_step[1] = angle;
    if (again) return fail(self, NCK_E_WORD_TWICE, 0.0, 0.0);
    if (angle >= -angle_most && angle <= angle_most) return NCK_OK;
    return fail(self, NCK_E_NUMBER_RANGE, angle, angle_most);
}

// G1 is said, or in force: nothing else has a direction.
static int is_line(const nck_decode_t *self) {
    const nck_words_t *const words = &self->words;
    const int says = (words->codes & NCK_STEP(NCK_STEP_MOTION)) != 0;
    return (says ? words->code[NCK_STEP_MOTION] : self->modal.motion) == 10;
}

static int is_said(const nck_decode_t *self, unsigned axis) {
    return (self->words.letters & NCK_LETTER(nck_decode_letter(axis))) != 0;
}

// The way of the axis that is said [nm] makes that of the other.
static nck_status_t write_other(nck_decode_t *self, unsigned said, unsigned other, int is_first) {
    nck_words_t *const words = &self->words;
    const unsigned place = (unsigned)(nck_decode_letter(other) - 'A');
    const int adds = nck_motion_adds(self);
    int64_t to_nm = 0;
    double sine, cosine;
    const nck_status_t status = nck_decode_axis_word(self, said, &to_nm);
    if (status != NCK_OK) return status;
    const int64_t from_nm = self->place.position_nm[said] - self->place.origin_nm[said];
    const double way = (double)(adds ? to_nm : to_nm - from_nm);
    nck_sincos(words->polar_step[1] * degree, &sine, &cosine);
    const double up = is_first ? way * sine : way * cosine;
    const double along = is_first ? cosine : sine;
    const double most = (double)NCK_LINEAR_MAX_MM * (double)NCK_COUNTS_PER_MM;
    if (!(nck_fabs(up) < most * nck_fabs(along))) {
        return fail(self, NCK_E_NUMBER_RANGE, words->polar_step[1], angle_most);
    }
    int64_t value_nm = nck_rounded(up / along);
    if (!adds) value_nm += self->place.position_nm[other] - self->place.origin_nm[other];
    nck_decode_write(self, other, value_nm, &words->number[place]);
    words->column[place] = words->polar_column;
    words->letters |= NCK_LETTER(nck_decode_letter(other));
    return NCK_OK;
}

nck_status_t nck_slant_resolve(nck_decode_t *self) {
    unsigned axes[2];
    nck_plane_axes(self, &axes[0], &axes[1]);
    const int first = is_said(self, axes[0]);
    const int second = is_said(self, axes[1]);
    if (!is_line(self)) return fail(self, NCK_E_WORD_UNUSED, 0.0, 0.0);
    if (self->words.codes & NCK_MOVES_ZERO) return fail(self, NCK_E_INCREMENTAL, 0.0, 0.0);
    if (self->layout.on != 0) return fail(self, NCK_E_LAYOUT_ON, 0.0, 0.0);
    if (first && second) return fail(self, NCK_E_WORD_SHARED, 0.0, 0.0);
    if (!first && !second) return fail(self, NCK_E_UNSUPPORTED, 0.0, 0.0);
    return write_other(self, axes[first ? 0 : 1], axes[first ? 1 : 0], first);
}
