// SPDX-License-Identifier: MIT
// Fanuc's ,A: the angle of a line in its plane, from the plane's first axis [deg]. One axis of the
// plane is said, and what the other one would be becomes its word. Or none is: then the line ends
// where the next one begins, of which the angle and both axes of its end are said.
#include "nck/prep/1_decode/motion/parts.h"
#include "nck/prep/1_decode/state/state.h" // nck_decode_fail
#include "nck/prep/1_decode/number/number.h" // nck_decode_axis_word nck_decode_write …
#include "nck/prep/1_decode/tongue/tongue.h" // nck_lathe_is_a nck_lathe_steps
#include "nck/prep/1_decode/place/place.h" // nck_plane_axes
#include "nck/base/real.h" // nck_fabs nck_sincos nck_rounded nck_real_of

enum { AXIS_A = 3 };

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

nck_status_t nck_slant_plain(nck_decode_t *self) {
    nck_words_t *const words = &self->words;
    const uint32_t others = ~(NCK_STEP(NCK_STEP_MOTION) | NCK_STEP(NCK_STEP_FEED_MODE)
                              | NCK_STEP(NCK_STEP_DISTANCE) | NCK_STEP(NCK_STEP_EXACT));
    const int is_axis = (self->place.axes >> AXIS_A & 1u) != 0;
    const int says = (words->letters & NCK_LETTER('A')) != 0 && words->polars == 0;
    if (!NCK_HAS_LAYOUTS || !says || is_axis) return NCK_OK;
    if (!is_line(self) || (words->codes & others) != 0) return NCK_OK;
    words->letters &= ~NCK_LETTER('A');
    return nck_slant_keep(self, words->column[0], &words->number[0]);
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
    const double way = nck_real_of(adds ? to_nm : to_nm - from_nm);
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

// No axis is said: the line goes nowhere yet, and is held until the next one is known.
static nck_status_t leave_open(nck_decode_t *self, unsigned axis) {
    nck_words_t *const words = &self->words;
    const unsigned place = (unsigned)(nck_decode_letter(axis) - 'A');
    const int64_t here_nm = self->place.position_nm[axis] - self->place.origin_nm[axis];
    nck_decode_write(self, axis, nck_motion_adds(self) ? 0 : here_nm, &words->number[place]);
    words->column[place] = words->polar_column;
    words->letters |= NCK_LETTER(nck_decode_letter(axis));
    nck_corner_open(self, words->polar_column, words->polar_step[1] * degree);
    return NCK_OK;
}

// The line before is open: this one says by its angle where it begins.
static nck_status_t close(nck_decode_t *self, int both, int steps) {
    if (!both) return fail(self, NCK_E_UNSUPPORTED, 0.0, 0.0);
    if (steps || nck_motion_adds(self)) return fail(self, NCK_E_INCREMENTAL, 0.0, 0.0);
    nck_corner_close(self, self->words.polar_step[1] * degree);
    return NCK_OK;
}

// U, V and W of lathes become X, Y and Z. Returns 1 if there are any.
static int has_steps(nck_decode_t *self, nck_status_t *status_out) {
    const uint32_t own = NCK_LETTER('U') | NCK_LETTER('V') | NCK_LETTER('W');
    const uint32_t steps = nck_lathe_is_a(self) ? self->words.letters & own : 0;
    const nck_status_t status = steps != 0 ? nck_lathe_steps(self, steps) : NCK_OK;
    *status_out = status < NCK_OK ? status : NCK_OK;
    return steps != 0;
}

// What cannot stand beside the angle.
static nck_status_t check(nck_decode_t *self) {
    if (!is_line(self)) return fail(self, NCK_E_WORD_UNUSED, 0.0, 0.0);
    if (self->words.codes & NCK_MOVES_ZERO) return fail(self, NCK_E_INCREMENTAL, 0.0, 0.0);
    return self->layout.on != 0 ? fail(self, NCK_E_LAYOUT_ON, 0.0, 0.0) : NCK_OK;
}

nck_status_t nck_slant_resolve(nck_decode_t *self) {
    unsigned axes[2];
    nck_status_t status = check(self);
    if (status != NCK_OK) return status;
    nck_plane_axes(self, &axes[0], &axes[1]);
    const int steps = has_steps(self, &status);
    if (status != NCK_OK) return status;
    const int first = is_said(self, axes[0]);
    const int second = is_said(self, axes[1]);
    if (nck_corner_is_open(self)) return close(self, first && second, steps);
    if (first && second) {
        return nck_corner_excuses(self) ? NCK_OK : fail(self, NCK_E_WORD_SHARED, 0.0, 0.0);
    }
    if (!first && !second) return leave_open(self, axes[0]);
    return write_other(self, axes[first ? 0 : 1], axes[first ? 1 : 0], first);
}
