// SPDX-License-Identifier: MIT
// G74 and G75 of Fanuc's lathes (system C: G76, G77): pecks along Z or along X, row beside row.
//
//     start ─1▶ cut ─2▶ back ─1▶ … end of the row ─3▶ out ─4▶ next row … last row ─3▶ out ─5▶ start
#include "nck/prep/1_decode/lathe/parts.h"
#include "nck/prep/1_decode/state/state.h" // nck_decode_assume nck_decode_fail …
#include "nck/prep/1_decode/number/number.h" // nck_decode_increments nck_decode_length_word …
#include "nck/prep/1_decode/place/place.h" // nck_decode_target
#include "nck/prep/1_decode/macro/macro.h" // nck_decode_moved
#include "nck/prep/1_decode/motion/motion.h" // nck_decode_cutting_feed nck_decode_cycle_fits …

enum { PHASE_CUT = 1, PHASE_BACK, PHASE_OUT, PHASE_NEXT };

static nck_status_t fail_missing(nck_decode_t *self, int letter) {
    return nck_decode_fail_step(self, NCK_E_WORD_MISSING, NCK_STEP_MOTION, letter,
                                self->words.code[NCK_STEP_MOTION] / 10.0, 0.0);
}

// A step along X (P, in one line I) or Z (Q, K), without a sign. P and Q without a point count
// least increments; 0: that is no whole number of them.
static nck_status_t read_step(nck_decode_t *self, unsigned k, int64_t *step_out) {
    const char letter = k == 0 ? 'P' : 'Q';
    const char other = k == 0 ? 'I' : 'K';
    const char said = nck_has_word(self, other) ? other : letter;
    if (nck_has_word(self, letter) && nck_has_word(self, other)) {
        return nck_decode_fail_word(self, NCK_E_WORD_SHARED, other, 0.0, 0.0);
    }
    if (!nck_has_word(self, said)) return fail_missing(self, letter);
    nck_status_t status = NCK_OK;
    if (said == other || nck_decode_says_point(self, said)) {
        status = nck_decode_length_word(self, said, step_out);
    } else if (!nck_decode_increments(self, said, step_out)) {
        *step_out = 0;
    }
    if (status != NCK_OK || *step_out > 0) return status;
    return nck_decode_fail_range(self, said, 0.0);
}

// X and Z; what is not said stays: one row, or in it nothing to cut.
static nck_status_t read_end(nck_decode_t *self) {
    nck_peck_t *const peck = &self->held.peck;
    int64_t target_nm[NCK_AXIS_MAX];
    nck_status_t status = nck_decode_target(self, 0, target_nm);
    for (unsigned k = 0; k < 2 && status == NCK_OK; k++) {
        peck->start_nm[k] = self->place.position_nm[nck_lathe_axis(k)];
        peck->end_nm[k] = target_nm[nck_lathe_axis(k)];
        status = nck_decode_travel(self, nck_lathe_axis(k), peck->end_nm[k]);
    }
    return status;
}

// The steps that are needed. A distance to the side at the end of a row (R beside X and Z) would
// lead into the wall of the first one.
static nck_status_t read_steps(nck_decode_t *self) {
    nck_peck_t *const peck = &self->held.peck;
    const nck_number_t *const relief = &self->words.number['R' - 'A'];
    const unsigned rows = 1u - peck->along;
    if (nck_has_word(self, 'R') && relief->mantissa != 0) {
        return nck_decode_fail(self, NCK_E_UNSUPPORTED, self->words.column['R' - 'A'], 'G',
                               self->words.code[NCK_STEP_MOTION] / 10.0, 0.0);
    }
    const nck_status_t status = read_step(self, peck->along, &peck->step_nm[peck->along]);
    if (status != NCK_OK || peck->end_nm[rows] == peck->start_nm[rows]) return status;
    return read_step(self, rows, &peck->step_nm[rows]);
}

// The first of two lines: how far a peck goes back.
static nck_status_t keep_back(nck_decode_t *self) {
    int64_t back_nm = 0;
    if (!nck_has_word(self, 'R')) return fail_missing(self, 'R');
    const nck_status_t status = nck_decode_length_word(self, 'R', &back_nm);
    if (status == NCK_OK && back_nm < 0) return nck_decode_fail_range(self, 'R', 0.0);
    if (status == NCK_OK) self->held.peck.back_nm = back_nm;
    return status;
}

static nck_status_t begin(nck_decode_t *self) {
    nck_peck_t *const peck = &self->held.peck;
    const uint32_t cuts = NCK_LETTER('P') | NCK_LETTER('Q') | NCK_LETTER('I') | NCK_LETTER('K');
    peck->along = self->words.code[NCK_STEP_MOTION] == NCK_MOTION_PECK_Z;
    if (self->words.axes == 0 && !(self->words.letters & cuts)) return keep_back(self);
    if (!(self->words.axes >> nck_lathe_axis(peck->along) & 1u)) {
        return fail_missing(self, nck_decode_letter(nck_lathe_axis(peck->along)));
    }
    nck_decode_assume(self, NCK_NOTE_UNITS);
    nck_status_t status = nck_decode_cycle_fits(self);
    if (status == NCK_OK) status = read_end(self);
    if (status == NCK_OK) status = read_steps(self);
    if (status == NCK_OK) status = nck_decode_cutting_feed(self, 0, &peck->feed);
    if (status != NCK_OK) return status;
    nck_decode_moved(self);
    peck->cut_nm = peck->start_nm[peck->along];
    peck->phase = PHASE_CUT;
    return NCK_OK;
}

// From a place towards another one by a step, no further.
static int64_t towards(int64_t at_nm, int64_t to_nm, int64_t step_nm) {
    const int64_t way_nm = to_nm - at_nm;
    if (way_nm > step_nm) return at_nm + step_nm;
    return way_nm < -step_nm ? at_nm - step_nm : to_nm;
}

// Where the next move leads along the pecks, the phase behind it.
static int64_t along(nck_peck_t *peck) {
    const unsigned a = peck->along;
    const int64_t start_nm = peck->start_nm[a];
    if (peck->phase == PHASE_CUT) {
        peck->cut_nm = towards(peck->cut_nm, peck->end_nm[a], peck->step_nm[a]);
        peck->phase = peck->cut_nm == peck->end_nm[a] ? PHASE_OUT : PHASE_BACK;
        return peck->cut_nm;
    }
    peck->phase = peck->phase == PHASE_BACK ? PHASE_CUT : PHASE_NEXT;
    return peck->phase == PHASE_CUT ? towards(peck->cut_nm, start_nm, peck->back_nm) : start_nm;
}

// The same across them: the next row, or behind the last one the start.
static int64_t across(nck_peck_t *peck, int64_t at_nm) {
    const unsigned a = 1u - peck->along;
    if (at_nm == peck->end_nm[a]) {
        peck->phase = 0;
        return peck->start_nm[a];
    }
    peck->cut_nm = peck->start_nm[peck->along];
    peck->phase = PHASE_CUT;
    return towards(at_nm, peck->end_nm[a], peck->step_nm[a]);
}

// The next move, NCK_EMPTY: it goes nowhere.
static nck_status_t go(nck_decode_t *self, nck_block_t *out) {
    nck_peck_t *const peck = &self->held.peck;
    const int cuts = peck->phase == PHASE_CUT;
    const int is_across = peck->phase == PHASE_NEXT;
    const unsigned k = is_across ? 1u - peck->along : peck->along;
    int64_t *const at_nm = &self->place.position_nm[nck_lathe_axis(k)];
    const int64_t to_nm = is_across ? across(peck, *at_nm) : along(peck);
    if (to_nm == *at_nm) return NCK_EMPTY;
    *at_nm = to_nm;
    nck_decode_give_exact(self, cuts ? NCK_BLOCK_LINE : NCK_BLOCK_RAPID, peck->feed, out);
    return NCK_OK;
}

nck_status_t nck_decode_peck(nck_decode_t *self, nck_block_t *out) {
    if (!NCK_HAS_CYCLES) return NCK_E_UNSUPPORTED;
    nck_status_t status = self->held.peck.phase == 0 ? begin(self) : NCK_OK;
    if (status == NCK_OK) status = NCK_EMPTY;
    while (status == NCK_EMPTY && self->held.peck.phase != 0) status = go(self, out);
    if (self->held.peck.phase != 0) nck_decode_leave(self, NCK_REST_CYCLE);
    return status;
}
