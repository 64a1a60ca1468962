// SPDX-License-Identifier: MIT
// G70 and G71 of Haas' mills: the cycle in force at holes on a circle about the place that the line
// names, or where the tool stands.
//
//     G81 Z-5. R2. F90. L0        L0: no hole here
//     G70 I20. J15. L6            radius, angle of the first hole, how many on the whole circle
//     G71 I20. J15. K30. L4       angle from hole to hole
#include "nck/prep/1_decode/cycle/ring.h"
#include "nck/prep/1_decode/state/state.h" // nck_decode_fail_step nck_decode_fail_word …
#include "nck/prep/1_decode/number/number.h" // nck_decode_length_word nck_decode_travel …
#include "nck/base/trig_math.h" // nck_sincos NCK_PI
#include "nck/base/real.h" // nck_real_of

#include <string.h> // memcpy

enum { WHOLE = 700, PART = 710, HOLES_MOST = 1000 };

static const double angle_most = 3600.0;

static nck_status_t read_angle(nck_decode_t *self, char letter, double *angle_out) {
    *angle_out = nck_has_word(self, letter) ? nck_decode_real_word(self, letter) : 0.0;
    if (*angle_out >= -angle_most && *angle_out <= angle_most) return NCK_OK;
    return nck_decode_fail_range(self, letter, angle_most);
}

static nck_status_t read_words(nck_decode_t *self, int whole, int64_t *count_out) {
    nck_cycle_t *const cycle = &self->held.cycle;
    nck_status_t status = nck_decode_length_word(self, 'I', &cycle->ring_nm);
    if (status == NCK_OK && cycle->ring_nm <= 0) {
        status = nck_decode_fail_range(self, 'I', 0.0);
    }
    if (status == NCK_OK) status = nck_decode_whole(self, 'L', HOLES_MOST, 0, count_out);
    if (status == NCK_OK) status = read_angle(self, 'J', &cycle->ring_angle);
    if (status == NCK_OK) status = read_angle(self, 'K', &cycle->ring_step);
    if (whole && *count_out > 0) cycle->ring_step = 360.0 / (double)*count_out;
    return status;
}

static nck_status_t read_ring(nck_decode_t *self, int whole, int64_t *count_out) {
    const int32_t before = self->modal.motion;
    const double code = whole ? 70.0 : 71.0;
    const char *const needs = whole ? "IL" : "IKL";
    const int drills = nck_motion_is_cycle(before) && before != NCK_MOTION_SKIP;
    const nck_status_t status = !drills                     ? NCK_E_NO_MOTION
                                : self->layout.on != 0      ? NCK_E_LAYOUT_ON
                                : self->modal.plane != 17   ? NCK_E_UNSUPPORTED
                                                            : NCK_OK;
    if (status != NCK_OK) {
        return nck_decode_fail_step(self, status, NCK_STEP_MOTION, 'G', code, 0.0);
    }
    if (whole && nck_has_word(self, 'K')) {
        return nck_decode_fail_word(self, NCK_E_WORD_UNUSED, 'K', 0.0, 0.0);
    }
    for (const char *letter = needs; *letter != '\0'; letter++) {
        if (nck_has_word(self, *letter)) continue;
        return nck_decode_fail_step(self, NCK_E_WORD_MISSING, NCK_STEP_MOTION, *letter, code, 0.0);
    }
    return read_words(self, whole, count_out);
}

nck_status_t nck_ring_begin(nck_decode_t *self, int64_t *count_out) {
    if (!NCK_HAS_CYCLES) return NCK_E_UNSUPPORTED;
    const int32_t code = self->words.code[NCK_STEP_MOTION];
    const int rings = self->tongue == NCK_TONGUE_FANUC && (code == WHOLE || code == PART);
    self->held.cycle.circles = rings ? NCK_CIRCLES_RING : 0;
    if (!rings) return NCK_OK;
    if (self->modal.motion == NCK_MOTION_REFUSED) return NCK_EMPTY; // its cycle's mistake is told
    const nck_status_t status = read_ring(self, code == WHOLE, count_out);
    self->words.code[NCK_STEP_MOTION] = (uint16_t)self->modal.motion; // the cycle drills them
    return status;
}

// Hole k: the centre is a place of the axes, and stands in the first two steps.
static void put_hole(nck_decode_t *self, uint32_t k) {
    nck_cycle_t *const cycle = &self->held.cycle;
    const double degrees = cycle->ring_angle + (double)k * cycle->ring_step;
    const double whole = 360.0 * nck_floor(degrees / 360.0);
    double sine, cosine;
    nck_sincos((degrees - whole) * NCK_PI / 180.0, &sine, &cosine);
    cycle->hole_nm[0] = cycle->step_nm[0] + nck_rounded(nck_real_of(cycle->ring_nm) * cosine);
    cycle->hole_nm[1] = cycle->step_nm[1] + nck_rounded(nck_real_of(cycle->ring_nm) * sine);
}

nck_status_t nck_ring_place(nck_decode_t *self, int64_t count, int64_t *last_nm) {
    if (!NCK_HAS_CYCLES) return NCK_E_UNSUPPORTED;
    nck_cycle_t *const cycle = &self->held.cycle;
    nck_status_t status = NCK_OK;
    for (unsigned axis = 0; axis < 2; axis++) cycle->step_nm[axis] = cycle->hole_nm[axis];
    for (uint32_t k = 0; k < (uint32_t)count && status == NCK_OK; k++) {
        put_hole(self, k);
        for (unsigned axis = 0; axis < 2 && status == NCK_OK; axis++) {
            status = nck_decode_travel(self, axis, cycle->hole_nm[axis]);
        }
    }
    memcpy(last_nm, cycle->hole_nm, sizeof cycle->hole_nm);
    cycle->ring_at = 0;
    put_hole(self, 0);
    return status;
}

void nck_ring_next(nck_decode_t *self) {
    if (!NCK_HAS_CYCLES) return;
    nck_cycle_t *const cycle = &self->held.cycle;
    put_hole(self, ++cycle->ring_at);
}
