// SPDX-License-Identifier: MIT
// A pass of a thread: can it be made, and its block. G33 and G32.
#include "nck/prep/1_decode/motion/parts.h"
#include "nck/prep/1_decode/state/state.h" // nck_decode_assume_places nck_decode_block …
#include "nck/prep/1_decode/number/number.h" // nck_decode_travel nck_word_real
#include "nck/prep/1_decode/tongue/tongue.h" // nck_lathe_is_a
#include "nck/prep/1_decode/place/place.h" // nck_decode_target
#include "nck/base/real.h" // nck_fabs nck_max nck_sqrt nck_real_of
#include "nck/base/thread.h" // nck_thread_…

#include <string.h> // memcpy

#define SECONDS 60.0
#define Q_TURN 360000.0 // Fanuc: Q in thousandths of a degree
#define RPM_LEAST 0.001 // a spindle as good as stands if it turns slower [1/min]

double nck_decode_thread_name(const nck_decode_t *self) {
    const uint16_t code = self->words.code[NCK_STEP_MOTION];
    const int c = self->machine->dialect.system == NCK_SYSTEM_C;
    if (code == NCK_MOTION_TAP) return 33.1;
    if (code == NCK_MOTION_PASS) return nck_lathe_is_a(self) ? 32.0 : 33.0;
    if (code == NCK_MOTION_SCREW) return c && self->lathe ? 78.0 : 76.0;
    return nck_lathe_is_a(self) ? 92.0 : c ? 21.0 : 78.0;
}

static void machine_mm(const nck_decode_t *self, const int64_t *at_nm, double *at) {
    for (int x = 0; x < NCK_AXIS_MAX; x++) {
        at[x] = nck_real_of(at_nm[x]) / nck_machine_counts(self->machine, x);
    }
}

nck_status_t nck_decode_thread_fits(nck_decode_t *self) {
    const nck_status_t status = nck_decode_cycle_fits(self);
    if (status != NCK_OK) return status;
    if (self->modal.surface_on) return nck_motion_fail(self, NCK_E_THREAD_SPEED, 'G', 96.0, 0.0);
    if (nck_decode_turns(self) && self->modal.speed >= RPM_LEAST) return NCK_OK;
    return nck_motion_fail(self, NCK_E_THREAD_SPEED, 'S', 0.0, 0.0);
}

// Does the spindle's speed leave the axes their limits, and is there room to run in and out?
static nck_status_t check_pass(nck_decode_t *self, const double *start, const double *end,
                               nck_thread_t *thread) {
    const double rpm = self->modal.speed;
    const double v = thread->lead * rpm / SECONDS;
    if (!(thread->length > 0.0)) return nck_motion_fail_empty(self, v, 'Z');
    const double most = nck_thread_speed_most(self->machine, start, end, thread);
    nck_pass_t pass;
    if (v > most) return nck_motion_fail(self, NCK_E_THREAD_SPEED, 'F', v, most);
    nck_thread_plan(self->machine, start, end, thread, rpm, &pass);
    if (pass.cruise < 0.0) {
        return nck_motion_fail(self, NCK_E_THREAD_RUN_IN, 'Z', 2.0 * pass.ramp.length,
                               thread->length);
    }
    thread->duration = (float)(pass.total + 0.5 * SECONDS / rpm);
    return NCK_OK;
}

// Both ends, and where X is in beside the straight way. Where it goes out from, it is by then, or
// the line has named it.
static nck_status_t check_travel(nck_decode_t *self, const int64_t *end_nm,
                                 const nck_thread_t *thread) {
    const int64_t x_nm = self->place.position_nm[NCK_AXIS_X];
    const int64_t in_nm = x_nm + (int64_t)(thread->enter * (double)NCK_COUNTS_PER_MM);
    nck_status_t status = NCK_OK;
    for (unsigned axis = 0; axis < NCK_AXIS_MAX && status == NCK_OK; axis++) {
        const int moves = end_nm[axis] != self->place.position_nm[axis];
        if (moves) status = nck_decode_travel(self, axis, end_nm[axis]);
    }
    if (status != NCK_OK || thread->enter == 0.0) return status;
    return nck_decode_travel(self, NCK_AXIS_X, in_nm);
}

nck_status_t nck_decode_pass(nck_decode_t *self, const int64_t *end_nm, nck_thread_t *thread,
                             nck_block_t *out) {
    if (!NCK_HAS_THREADS) return NCK_E_UNSUPPORTED;
    double start[NCK_AXIS_MAX];
    double end[NCK_AXIS_MAX];
    machine_mm(self, self->place.position_nm, start);
    machine_mm(self, end_nm, end);
    nck_status_t status = check_travel(self, end_nm, thread);
    if (status == NCK_OK) status = check_pass(self, start, end, thread);
    memcpy(self->place.position_nm, end_nm, sizeof self->place.position_nm);
    if (status != NCK_OK) return status;
    nck_decode_block(self, NCK_BLOCK_THREAD, out);
    out->thread = *thread;
    return NCK_OK;
}

nck_status_t nck_decode_lead(nck_decode_t *self, char letter, double *lead_out) {
    const double unit = self->modal.inch ? 25.4 : 1.0;
    const double word = nck_word_real(self, letter);
    const int said = nck_has_word(self, letter);
    if (!said && letter == 'F' && self->held.screw.lead > 0.0) {
        *lead_out = self->held.screw.lead;
        return NCK_OK;
    }
    if (!said) {
        return nck_motion_fail(self, NCK_E_WORD_MISSING, letter, nck_decode_thread_name(self), 0.0);
    }
    *lead_out = word * unit;
    self->held.screw.lead = *lead_out;
    if (word > 0.0 && *lead_out <= (double)NCK_LINEAR_MAX_MM) return NCK_OK;
    return nck_decode_fail_word(self, NCK_E_NUMBER_RANGE, letter, word,
                                (double)NCK_LINEAR_MAX_MM / unit);
}

nck_status_t nck_decode_start_angle(nck_decode_t *self, float *turn_out) {
    const double word = nck_word_real(self, 'Q');
    if (!(self->words.letters & NCK_LETTER('Q'))) return NCK_OK;
    if (!(word >= 0.0 && word <= Q_TURN)) {
        return nck_decode_fail_word(self, NCK_E_NUMBER_RANGE, 'Q', word, Q_TURN);
    }
    *turn_out = word < Q_TURN ? (float)(word / Q_TURN) : 0.0f;
    return NCK_OK;
}

nck_status_t nck_decode_single_pass(nck_decode_t *self, nck_block_t *out) {
    if (!NCK_HAS_THREADS) return NCK_E_UNSUPPORTED;
    nck_thread_t thread = {0};
    int64_t end_nm[NCK_AXIS_MAX];
    self->modal.motion = NCK_MOTION_PASS;
    if (self->words.axes == 0) return NCK_EMPTY;
    nck_decode_assume_places(self);
    nck_status_t status = nck_decode_lead(self, self->lathe ? 'F' : 'K', &thread.lead);
    if (status == NCK_OK) status = nck_decode_thread_fits(self);
    if (status == NCK_OK && self->lathe) status = nck_decode_start_angle(self, &thread.turn);
    if (status == NCK_OK) status = nck_decode_target(self, 0, end_nm);
    if (status != NCK_OK) {
        self->modal.motion = NCK_MOTION_REFUSED; // one mistake, one finding
        return status;
    }
    // The lead counts along the path; in Fanuc's language along the axis that moves further.
    double sum = 0.0;
    double most = 0.0;
    for (int x = 0; x < NCK_AXIS_MAX; x++) {
        const double d = nck_real_of(end_nm[x] - self->place.position_nm[x]) * 1e-6;
        sum += d * d;
        most = nck_max(most, nck_fabs(d));
    }
    thread.length = self->lathe ? most : nck_sqrt(sum);
    if (!(thread.length > 0.0)) return NCK_EMPTY;
    return nck_decode_pass(self, end_nm, &thread, out);
}
