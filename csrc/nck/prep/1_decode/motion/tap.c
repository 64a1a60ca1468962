// SPDX-License-Identifier: MIT
// A tapped hole: can it be made, and its block. G33.1, and the holes of G84 and G74.
#include "nck/prep/1_decode/motion/parts.h"
#include "nck/prep/1_decode/state/state.h" // nck_decode_assume_places nck_decode_block …
#include "nck/prep/1_decode/number/number.h" // nck_decode_travel
#include "nck/prep/1_decode/place/place.h" // nck_decode_target
#include "nck/base/real.h" // nck_fabs nck_real_of
#include "nck/base/thread.h" // nck_tap_plan …

#define SECONDS 60.0

nck_status_t nck_decode_tap(nck_decode_t *self, const int64_t *bottom_nm, double lead,
                            double dwell_s, nck_block_t *out) {
    const double rpm = self->modal.speed;
    const double v = lead * rpm / SECONDS;
    nck_tap_t tap = {.lead = lead};
    nck_pass_t pass;
    nck_ramp_t back;
    if (!NCK_HAS_THREADS) return NCK_E_UNSUPPORTED;
    tap.dwell = (float)dwell_s;
    for (unsigned axis = 0; axis < 3; axis++) {
        tap.way[axis] = nck_real_of(bottom_nm[axis] - self->place.position_nm[axis]) * 1e-6;
    }
    const double way = nck_fabs(tap.way[0]) + nck_fabs(tap.way[1]) + nck_fabs(tap.way[2]);
    const int is_empty = !(way > 0.0);
    if (is_empty) return nck_motion_fail_empty(self, v, 'R');
    const double most = nck_tap_speed_most(self->machine, &tap);
    if (v > most) return nck_motion_fail(self, NCK_E_THREAD_SPEED, 'F', v, most);
    nck_tap_plan(self->machine, &tap, rpm, &pass, &back);
    if (pass.cruise < 0.0) {
        return nck_motion_fail(self, NCK_E_THREAD_RUN_IN, 'R', pass.ramp.length + back.length,
                               pass.length);
    }
    tap.duration = (float)(pass.total + 0.5 * SECONDS / rpm);
    nck_decode_block(self, NCK_BLOCK_TAP, out);
    out->tap = tap;
    return NCK_OK;
}

// G33.1: to the place that the words name and back.
nck_status_t nck_decode_single_tap(nck_decode_t *self, nck_block_t *out) {
    if (!NCK_HAS_THREADS) return NCK_E_UNSUPPORTED;
    int64_t bottom_nm[NCK_AXIS_MAX];
    double lead = 0.0;
    int moves = 0;
    self->modal.motion = NCK_MOTION_TAP;
    if (self->words.axes == 0) return nck_motion_fail(self, NCK_E_WORD_MISSING, 'Z', 33.1, 0.0);
    nck_decode_assume_places(self);
    nck_status_t status = nck_decode_lead(self, 'K', &lead);
    if (status == NCK_OK) status = nck_decode_thread_fits(self);
    if (status == NCK_OK) status = nck_decode_target(self, 0, bottom_nm);
    for (unsigned axis = 0; axis < 3 && status == NCK_OK; axis++) {
        moves = moves || bottom_nm[axis] != self->place.position_nm[axis];
        status = nck_decode_travel(self, axis, bottom_nm[axis]);
    }
    if (status == NCK_OK && moves) status = nck_decode_tap(self, bottom_nm, lead, 0.0, out);
    else if (status == NCK_OK) status = NCK_EMPTY;
    if (status < NCK_OK) self->modal.motion = NCK_MOTION_REFUSED; // one mistake, one finding
    return status;
}
