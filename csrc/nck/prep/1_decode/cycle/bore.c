// SPDX-License-Identifier: MIT
// G76 and G87 of Fanuc's mills: boring with a tool that steps aside before it comes out or goes in.
//
//     G76  over ▶ R ▶ cut to Z ▶ rest ▶ spindle at its angle ▶ aside ▶ out ▶ back ▶ spindle on
//     G87  over ▶ at its angle ▶ aside ▶ in to R ▶ back ▶ spindle on ▶ cut up to Z ▶ rest ▶
//          at its angle ▶ aside ▶ out ▶ back ▶ spindle on
#include "nck/prep/1_decode/cycle/bore.h"
#include "nck/prep/1_decode/cycle/cycle.h"
#include "nck/prep/1_decode/cycle/height.h"
#include "nck/prep/1_decode/state/state.h" // nck_decode_fail_word nck_decode_give_dwell …
#include "nck/prep/1_decode/number/number.h" // nck_decode_length_word nck_decode_travel
#include "nck/prep/1_decode/motion/motion.h" // nck_decode_give_exact
#include "nck/base/arc_math.h" // nck_plane_axis

#include <string.h> // memcpy

enum { STOP_CODE = 5, ANGLE_CODE = 19 }; // M5, M19

typedef enum part {
    PART_END, PART_RISE, PART_OVER, PART_IN, PART_CUT, PART_REST, PART_STOP, PART_ANGLE, PART_ASIDE,
    PART_OUT, PART_START
} part_t;

static const uint8_t fine[] = {PART_RISE, PART_OVER, PART_IN, PART_CUT, PART_REST, PART_STOP,
                               PART_ANGLE, PART_ASIDE, PART_OUT, PART_OVER, PART_START, PART_END};

static const uint8_t from_below[] = {PART_OVER, PART_STOP, PART_ANGLE, PART_ASIDE, PART_IN,
                                     PART_OVER, PART_START, PART_CUT, PART_REST, PART_STOP,
                                     PART_ANGLE, PART_ASIDE, PART_OUT, PART_OVER, PART_START,
                                     PART_END};

int nck_bore_has(const nck_decode_t *self, int32_t motion) {
    return NCK_HAS_CYCLES && self->tongue == NCK_TONGUE_FANUC
           && (motion == NCK_MOTION_SCREW || motion == NCK_MOTION_BORE_BACK);
}

nck_status_t nck_bore_shift(nck_decode_t *self) {
    nck_cycle_t *const cycle = &self->held.cycle;
    const uint32_t both = NCK_LETTER('I') | NCK_LETTER('J');
    nck_status_t status = NCK_OK;
    if (nck_has_word(self, 'Q')) {
        cycle->said &= ~both;
        cycle->shift_nm[0] = cycle->peck_nm;
        cycle->shift_nm[1] = 0;
    }
    if ((self->words.letters & both) && cycle->circles != NCK_CIRCLES_RING) {
        if (self->modal.plane != 17) {
            const char letter = nck_has_word(self, 'I') ? 'I' : 'J';
            return nck_decode_fail_word(self, NCK_E_WORD_UNUSED, letter, 0.0, 0.0);
        }
        cycle->said |= both;
        for (unsigned k = 0; k < 2 && status == NCK_OK; k++) {
            cycle->shift_nm[k] = 0;
            const char letter = (char)('I' + k);
            if (!nck_has_word(self, letter)) continue;
            status = nck_decode_length_word(self, letter, &cycle->shift_nm[k]);
        }
    }
    if (status != NCK_OK || (cycle->said & (both | NCK_LETTER('Q')))) return status;
    return nck_cycle_missing(self, 'Q');
}

nck_status_t nck_bore_fits(nck_decode_t *self, const int64_t *last_nm) {
    const nck_cycle_t *const cycle = &self->held.cycle;
    const int bores = nck_bore_has(self, self->modal.motion);
    nck_status_t status = NCK_OK;
    for (unsigned k = 0; k < 2 && status == NCK_OK; k++) {
        const unsigned axis = nck_plane_axis(self->modal.plane, k);
        if (!bores || cycle->shift_nm[k] == 0) continue;
        status = nck_decode_travel(self, axis, cycle->hole_nm[axis] + cycle->shift_nm[k]);
        if (status != NCK_OK) continue;
        status = nck_decode_travel(self, axis, last_nm[axis] + cycle->shift_nm[k]);
    }
    return status;
}

// To a place. Nothing to do where the axes stand there.
static nck_status_t go(nck_decode_t *self, nck_block_kind_t kind, const int64_t *to_nm,
                       nck_block_t *out) {
    int64_t *const at_nm = self->place.position_nm;
    if (kind == NCK_BLOCK_RAPID && memcmp(at_nm, to_nm, sizeof self->place.position_nm) == 0) {
        return NCK_EMPTY;
    }
    memcpy(at_nm, to_nm, sizeof self->place.position_nm);
    nck_decode_give_exact(self, kind, self->held.cycle.feed, out);
    return NCK_OK;
}

static nck_status_t give_spindle(nck_decode_t *self, double code, int on, nck_block_t *out) {
    self->modal.spindle_on = (uint8_t)on;
    return nck_decode_give_m(self, code, out);
}

static nck_status_t move(nck_decode_t *self, part_t part, nck_block_t *out) {
    const nck_cycle_t *const cycle = &self->held.cycle;
    const int64_t *const level_nm = cycle->level_nm;
    const int shifts = part == PART_ASIDE;
    int64_t to_nm[NCK_AXIS_MAX];
    memcpy(to_nm, self->place.position_nm, sizeof to_nm);
    int64_t *const drill_nm = &to_nm[cycle->drill];
    if (part == PART_OVER || shifts) {
        const int64_t height_nm = *drill_nm;
        memcpy(to_nm, cycle->hole_nm, sizeof to_nm);
        to_nm[cycle->drill] = height_nm;
        for (unsigned k = 0; k < 2 && shifts; k++) {
            to_nm[nck_plane_axis(self->modal.plane, k)] += cycle->shift_nm[k];
        }
    }
    if (part == PART_RISE && *drill_nm < level_nm[NCK_LEVEL_R]) *drill_nm = level_nm[NCK_LEVEL_R];
    if (part == PART_IN) *drill_nm = level_nm[NCK_LEVEL_R];
    if (part == PART_CUT) *drill_nm = level_nm[NCK_LEVEL_BOTTOM];
    if (part == PART_OUT) *drill_nm = level_nm[NCK_LEVEL_CLEAR];
    return go(self, part == PART_CUT ? NCK_BLOCK_LINE : NCK_BLOCK_RAPID, to_nm, out);
}

int nck_bore_step(nck_decode_t *self, nck_status_t *status_out, nck_block_t *out) {
    nck_cycle_t *const cycle = &self->held.cycle;
    const int below = self->modal.motion == NCK_MOTION_BORE_BACK;
    const part_t part = (part_t)(below ? from_below : fine)[cycle->phase];
    cycle->phase++;
    *status_out = NCK_EMPTY;
    switch (part) {
    case PART_END: cycle->phase = 0; return 1;
    case PART_STOP: *status_out = give_spindle(self, STOP_CODE, 0, out); break;
    case PART_ANGLE: *status_out = give_spindle(self, ANGLE_CODE, 0, out); break;
    case PART_START: *status_out = give_spindle(self, self->modal.spindle_code, 1, out); break;
    case PART_REST:
        if (cycle->dwell_s > 0.0) *status_out = nck_decode_give_dwell(self, cycle->dwell_s, out);
        break;
    default: *status_out = move(self, part, out); break;
    }
    return 0;
}
