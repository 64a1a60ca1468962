// SPDX-License-Identifier: MIT
// R, the depth and the levels of drilling cycles.
#include "nck/prep/1_decode/cycle/height.h"
#include "nck/prep/1_decode/state/state.h" // nck_decode_fail_missing nck_decode_fail_word
#include "nck/prep/1_decode/number/number.h" // nck_decode_as_word nck_decode_travel …
#include "nck/prep/1_decode/tongue/tongue.h" // nck_lathe_is_a
#include "nck/base/real.h" // NCK_APART nck_real_of

nck_status_t nck_cycle_missing(nck_decode_t *self, int letter) {
    self->modal.motion = NCK_MOTION_REFUSED;
    return nck_decode_fail_missing(self, NCK_STEP_MOTION, letter);
}

// R. In system A it is a step from where the drill stood: what leads away from the work there is
// a place of another control's. On lathes without R the cut begins where the drill stood.
static nck_status_t read_r(nck_decode_t *self, int steps) {
    nck_cycle_t *const cycle = &self->held.cycle;
    const int away = nck_lathe_is_a(self);
    if (!(self->words.letters & NCK_LETTER('R'))) {
        if (self->lathe && !(cycle->said & NCK_LETTER('R'))) cycle->r_nm = cycle->initial_nm;
        return NCK_OK;
    }
    const nck_status_t status = nck_decode_length_word(self, 'R', &cycle->r_nm);
    if (status == NCK_OK && away && cycle->r_nm > 0) return nck_decode_fail_range(self, 'R', 0.0);
    if (steps || away) cycle->r_nm += cycle->initial_nm;
    cycle->said |= NCK_LETTER('R');
    return status;
}

// R and the depth as words. Fanuc's are places once they are said, RS274NGC's stay words: what they
// mean goes by the distance mode of each line.
static nck_status_t read_heights(nck_decode_t *self) {
    nck_cycle_t *const cycle = &self->held.cycle;
    const int steps = nck_is_fanuc(self) && self->modal.incremental;
    nck_status_t status = read_r(self, steps);
    if (status == NCK_OK && (self->words.axes >> cycle->drill & 1u)) {
        status = nck_decode_axis_word(self, cycle->drill, &cycle->depth_nm);
        if (steps) cycle->depth_nm += cycle->r_nm;
        cycle->said |= NCK_LETTER('Z');
    }
    if (status != NCK_OK) return status;
    if (!self->lathe && !(cycle->said & NCK_LETTER('R'))) return nck_cycle_missing(self, 'R');
    if (cycle->said & NCK_LETTER('Z')) return NCK_OK;
    return nck_cycle_missing(self, nck_decode_letter(cycle->drill));
}

// Whether it is G87 of mills, which cuts from R up to the depth.
static NCK_APART int cuts_up(const nck_decode_t *self) {
    return self->modal.motion == NCK_MOTION_BORE_BACK && !self->lathe;
}

// What the drill comes out to.
static int64_t clear_nm(const nck_decode_t *self, int64_t r_nm) {
    const nck_cycle_t *const cycle = &self->held.cycle;
    const int64_t high_nm = cycle->initial_nm > r_nm ? cycle->initial_nm : r_nm;
    return cycle->to_r && !cuts_up(self) ? r_nm : high_nm;
}

nck_status_t nck_cycle_heights(nck_decode_t *self) {
    nck_status_t status = read_heights(self);
    if (status != NCK_OK) return status;
    nck_cycle_t *const cycle = &self->held.cycle;
    const int64_t origin_nm = self->place.origin_nm[cycle->drill];
    const int steps = !nck_is_fanuc(self) && self->modal.incremental;
    const int64_t r_nm = cycle->r_nm + (steps ? cycle->initial_nm : 0);
    const int64_t bottom_nm = cycle->depth_nm + (steps ? r_nm : 0);
    // R lies on the wrong side of the bottom.
    if (cuts_up(self) ? r_nm > bottom_nm : r_nm < bottom_nm) {
        const nck_scale_t *const scale = nck_decode_scale_of(self, cycle->drill);
        const double most_nm = nck_real_of(bottom_nm - (r_nm - cycle->r_nm));
        return nck_decode_fail_word(self, NCK_E_NUMBER_RANGE, 'R',
                                    nck_decode_as_word(scale, nck_real_of(cycle->r_nm)),
                                    nck_decode_as_word(scale, most_nm));
    }
    cycle->level_nm[NCK_LEVEL_R] = r_nm + origin_nm;
    cycle->level_nm[NCK_LEVEL_BOTTOM] = bottom_nm + origin_nm;
    cycle->level_nm[NCK_LEVEL_CLEAR] = clear_nm(self, r_nm) + origin_nm;
    cycle->level_nm[NCK_LEVEL_CUT] = cycle->level_nm[NCK_LEVEL_R];
    for (unsigned k = NCK_LEVEL_R; k <= NCK_LEVEL_CLEAR && status == NCK_OK; k++) {
        status = nck_decode_steps(self, cycle->drill, 0, 0, &cycle->level_nm[k]);
        if (status == NCK_OK) {
            status = nck_decode_travel(self, cycle->drill, cycle->level_nm[k]);
        }
    }
    return status;
}
