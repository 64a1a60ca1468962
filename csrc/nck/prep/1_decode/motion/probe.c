// SPDX-License-Identifier: MIT
// Straight probes, G38.2 … G38.5, and Fanuc's G31: from rest to rest to the place that the words
// name. In a program they are simulated: the machine file says whether they meet something there.
// In a session whoever watches the probe stops them (nck_stop_at) and tells where.
#include "nck/prep/1_decode/motion/parts.h"
#include "nck/prep/1_decode/state/state.h" // nck_decode_assume_places
#include "nck/prep/1_decode/place/place.h" // nck_decode_target
#include "nck/prep/1_decode/macro/macro.h" // nck_parameter_set_probe

#include <string.h> // memcmp

// G38.2 and G38.4 must meet what they are sent for, and so must have a way to go.
static nck_status_t check_contact(nck_decode_t *self, const int64_t *target_nm, int touches) {
    const int32_t code = self->words.code[NCK_STEP_MOTION];
    if ((code & 1) != 0 || code == NCK_MOTION_SKIP) return NCK_OK;
    if (memcmp(target_nm, self->place.position_nm, sizeof self->place.position_nm) == 0) {
        return nck_motion_fail(self, NCK_E_PROBE, 'X', code / 10.0, 0.0);
    }
    if (touches || self->session.before) return NCK_OK;
    return nck_motion_fail(self, NCK_E_PROBE, 'G', code / 10.0, 0.0);
}

static nck_status_t go(nck_decode_t *self, int touches, nck_block_t *out) {
    int64_t target_nm[NCK_AXIS_MAX];
    if (self->words.axes == 0) {
        const double code = self->words.code[NCK_STEP_MOTION] / 10.0;
        return nck_motion_fail(self, NCK_E_WORD_MISSING, 'X', code, 0.0);
    }
    nck_decode_assume_places(self);
    if (self->modal.feed_mode == NCK_FEED_PER_REV) {
        return nck_motion_fail(self, NCK_E_PROBE, 'G', 95.0, 0.0);
    }
    nck_status_t status = nck_decode_cycle_fits(self);
    if (status == NCK_OK) status = nck_decode_target(self, 0, target_nm);
    if (status != NCK_OK) return status;
    const nck_status_t contact = check_contact(self, target_nm, touches);
    status = nck_decode_straight(self, NCK_BLOCK_LINE, target_nm, out);
    out->path_mode = NCK_PATH_STOP;
    return status == NCK_OK ? contact : status;
}

nck_status_t nck_decode_probe(nck_decode_t *self, nck_block_t *out) {
    const int touches = self->machine->dialect.probe == NCK_PROBE_TOUCHES;
    if (!NCK_HAS_CYCLES) return NCK_E_UNSUPPORTED;
    const int32_t before = self->modal.motion, code = self->words.code[NCK_STEP_MOTION];
    self->modal.motion = code;
    nck_status_t status = go(self, touches, out);
    if (status == NCK_OK) status = nck_parameter_set_probe(self, touches);
    if (status < NCK_OK) self->modal.motion = NCK_MOTION_REFUSED; // one mistake, one finding
    else if (code == NCK_MOTION_SKIP) self->modal.motion = before;
    return status;
}
