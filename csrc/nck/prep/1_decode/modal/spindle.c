// SPDX-License-Identifier: MIT
// The spindle's speed: in revolutions (G97) or as a surface speed (G96), and its most.
#include "nck/prep/1_decode/modal/modal.h"
#include "nck/prep/1_decode/state/state.h" // nck_decode_fail_step nck_decode_fail_word …
#include "nck/prep/1_decode/number/number.h" // nck_word_real
#include "nck/base/trig_math.h" // NCK_PI
#include "nck/base/spin_math.h" // nck_spin_rpm
#include "nck/base/real.h" // nck_real_of

#define MM_PER_M 1000.0
#define MM_PER_FOOT 304.8

static const double value_max = NCK_DECODE_VALUE_MAX;

static nck_status_t give_speed(nck_decode_t *self, double rpm, nck_block_t *out) {
    self->modal.speed = rpm;
    self->modal.excused &= (uint8_t)~NCK_EXCUSED_SPEED;
    return nck_decode_give_output(self, NCK_BLOCK_OUTPUT, NCK_OUTPUT_SPINDLE_SPEED, rpm, out);
}

static nck_status_t give_surface(nck_decode_t *self, double mm_min, nck_block_t *out) {
    self->modal.surface = mm_min;
    self->modal.excused &= (uint8_t)~NCK_EXCUSED_SPEED;
    return nck_decode_give_output(self, NCK_BLOCK_OUTPUT, NCK_OUTPUT_SURFACE_SPEED, mm_min, out);
}

nck_status_t nck_decode_set_speed(nck_decode_t *self, double word, nck_block_t *out) {
    const double rpm_max = self->machine->spindle.rpm_max;
    const double limit = rpm_max > 0.0 ? rpm_max : value_max;
    // grbl turns as fast as its spindle can, whatever more is asked for.
    const int clipped = word > limit && word <= value_max && (self->tongue & NCK_TONGUE_GRBL) != 0;
    const double value = clipped ? limit : word;
    const int same = !self->modal.surface_on && self->modal.speed == value;
    if (clipped) nck_decode_note_word(self, NCK_NOTE_CLIPPED, 'S', word);
    if (value < 0.0 || value > limit) {
        return nck_decode_fail_word(self, NCK_E_NUMBER_RANGE, 'S', value, limit);
    }
    self->modal.surface_on = 0;
    return same ? NCK_EMPTY : give_speed(self, value, out);
}

// Under G96 S is in m/min, with inches in feet a minute.
nck_status_t nck_decode_speed(nck_decode_t *self, nck_block_t *out) {
    const double word = nck_word_real(self, 'S');
    if (!self->modal.surface_on) return nck_decode_set_speed(self, word, out);
    const double unit = self->modal.inch ? MM_PER_FOOT : MM_PER_M;
    if (word < 0.0 || word * unit > value_max) {
        return nck_decode_fail_range(self, 'S', value_max / unit);
    }
    if (self->modal.surface == word * unit) return NCK_EMPTY;
    return give_surface(self, word * unit, out);
}

// A most of the spindle's speed: a word above what the machine has is no mistake.
static nck_status_t read_most(nck_decode_t *self, char letter) {
    const double word = nck_word_real(self, letter);
    if (!(word > 0.0 && word <= value_max)) return nck_decode_fail_range(self, letter, value_max);
    self->modal.speed_most = word;
    return NCK_EMPTY;
}

nck_status_t nck_decode_speed_limit(nck_decode_t *self) { return read_most(self, 'S'); }

static nck_status_t fail_mode(nck_decode_t *self, nck_status_t code, int letter) {
    return nck_decode_fail_step(self, code, NCK_STEP_SPEED_MODE, letter, 96.0, 0.0);
}

// D, which is RS274NGC's: of G96 alone. Without it there is no most but the machine's.
static nck_status_t check_most(nck_decode_t *self, int fanuc) {
    const int shared = (self->words.codes & NCK_STEP(NCK_STEP_RADIUS_COMP)) != 0;
    if (!fanuc) self->modal.speed_most = 0.0;
    if (!nck_has_word(self, 'D')) return NCK_EMPTY;
    if (!fanuc && !shared) return read_most(self, 'D');
    return nck_decode_fail_word(self, fanuc ? NCK_E_WORD_UNUSED : NCK_E_WORD_SHARED, 'D', 0.0, 0.0);
}

// What G96 needs: a most, since on the axis the speed would have no bound, and a surface speed.
// RS274NGC says the most beside it, as D; Fanuc's G92 or G50 has said it before, and S stays known.
static nck_status_t check_surface(nck_decode_t *self) {
    const int fanuc = nck_is_fanuc(self);
    const nck_status_t status = check_most(self, fanuc);
    if (status != NCK_EMPTY) return status;
    if (nck_decode_speed_most(self) <= 0.0) {
        return fail_mode(self, NCK_E_SPEED_LIMIT, fanuc ? 'S' : 'D');
    }
    const int known = fanuc && self->modal.surface > 0.0;
    return known || nck_has_word(self, 'S') ? NCK_EMPTY : fail_mode(self, NCK_E_WORD_MISSING, 'S');
}

// The speed that the surface speed means where the tool stands.
static double speed_here(const nck_decode_t *self) {
    const int64_t x_nm = self->place.position_nm[NCK_AXIS_X] - self->place.origin_nm[NCK_AXIS_X];
    const double speed = self->modal.surface / (2.0 * NCK_PI);
    const nck_spin_t spin = {speed, nck_decode_speed_most(self), 0.0, 0.0};
    return nck_spin_rpm(&spin, nck_real_of(x_nm) / (double)NCK_COUNTS_PER_MM);
}

// G97 without S: the speed stays what it is at this place, as Fanuc's controls have it.
nck_status_t nck_decode_speed_mode(nck_decode_t *self, nck_block_t *out) {
    const uint8_t on = self->words.code[NCK_STEP_SPEED_MODE] == 960;
    const uint8_t before = self->modal.surface_on;
    if (!NCK_HAS_LATHE) return on ? fail_mode(self, NCK_E_UNSUPPORTED, 0) : NCK_EMPTY;
    const nck_status_t status = on ? check_surface(self) : NCK_EMPTY;
    if (status != NCK_EMPTY) return status;
    self->modal.surface_on = on;
    if (on == before) return NCK_EMPTY;
    if (on && !nck_has_word(self, 'S')) return give_surface(self, self->modal.surface, out);
    if (!on && !nck_has_word(self, 'S')) return give_speed(self, speed_here(self), out);
    self->modal.speed = -1.0; // the S word is told, whatever was in force before
    if (on) self->modal.surface = 0.0;
    return NCK_EMPTY;
}
