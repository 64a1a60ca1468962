// SPDX-License-Identifier: MIT
// Turning and facing cycles: a rectangle, or a cut along a taper, that ends where it begins.
//
//     turning        4 ──▶ start      facing       2 ◀── 1        1, 4 rapid, 2 the cut, 3 at feed
//              end  ▲      │ 1                     │     ▲
//                 3 └◀── ── ┘ 2               end ▼ 3    start … 4
#include "nck/prep/1_decode/lathe/parts.h"
#include "nck/prep/1_decode/state/state.h" // nck_decode_assume nck_decode_fail_step …
#include "nck/prep/1_decode/number/number.h" // nck_decode_as_word nck_decode_axis_word …
#include "nck/prep/1_decode/tongue/tongue.h" // nck_lathe_is_a
#include "nck/prep/1_decode/macro/macro.h" // nck_decode_moved
#include "nck/prep/1_decode/motion/motion.h" // nck_decode_cutting_feed nck_decode_cycle_fits …
#include "nck/base/real.h" // nck_real_of

#include <stddef.h> // NULL

enum { MOVES = 4 };

static int is_turning(const nck_decode_t *self) {
    return self->words.code[NCK_STEP_MOTION] == NCK_MOTION_TURN;
}

static nck_status_t fail_missing(nck_decode_t *self, int letter) {
    const double code = is_turning(self) ? 90.0 : 94.0;
    self->modal.motion = NCK_MOTION_REFUSED;
    return nck_decode_fail_step(self, NCK_E_WORD_MISSING, NCK_STEP_MOTION, letter,
                                nck_lathe_is_a(self) ? code : 0.0, 0.0);
}

// X and Z: where the cut ends. They hold as places, with G91 too.
static nck_status_t read_end(nck_decode_t *self) {
    nck_turn_t *const turn = &self->held.turn;
    for (unsigned k = 0; k < 2; k++) {
        const unsigned axis = nck_lathe_axis(k);
        const int64_t at_nm = self->place.position_nm[axis] - self->place.origin_nm[axis];
        if (!(self->words.axes >> axis & 1u)) continue;
        const nck_status_t status = nck_decode_axis_word(self, axis, &turn->end_nm[k]);
        if (status != NCK_OK) return status;
        if (self->modal.incremental) turn->end_nm[k] += at_nm;
        turn->said |= (uint8_t)(1u << k);
    }
    if (!(turn->said & 1u)) return fail_missing(self, 'X');
    return turn->said & 2u ? NCK_OK : fail_missing(self, 'Z');
}

// The word of the taper: R; on older controls I of turning, K of facing.
static char taper_letter(const nck_decode_t *self) {
    const char other = is_turning(self) ? 'I' : 'K';
    return (self->words.letters & NCK_LETTER(other)) ? other : 'R';
}

static nck_status_t read_taper(nck_decode_t *self) {
    const char other = is_turning(self) ? 'I' : 'K';
    const uint32_t both = NCK_LETTER('R') | NCK_LETTER(other);
    const uint32_t said = self->words.letters & both;
    if (said == both) return nck_decode_fail_word(self, NCK_E_WORD_SHARED, other, 0.0, 0.0);
    if (said == 0) return NCK_OK;
    return nck_decode_length_word(self, taper_letter(self), &self->held.turn.taper_nm);
}

static nck_status_t check_corner(nck_decode_t *self, int64_t *corner_nm) {
    nck_status_t status = NCK_OK;
    for (unsigned k = 0; k < 2 && status == NCK_OK; k++) {
        status = nck_decode_steps(self, nck_lathe_axis(k), 0, 0, &corner_nm[k]);
        if (status == NCK_OK) status = nck_decode_travel(self, nck_lathe_axis(k), corner_nm[k]);
    }
    return status;
}

// The corners that are not the start's.
static nck_status_t place_corners(nck_decode_t *self) {
    nck_turn_t *const turn = &self->held.turn;
    const unsigned in = is_turning(self) ? 0 : 1;
    for (unsigned k = 0; k < 2; k++) {
        const int64_t end_nm = turn->end_nm[k] + self->place.origin_nm[nck_lathe_axis(k)];
        turn->start_nm[k] = self->place.position_nm[nck_lathe_axis(k)];
        turn->corner_nm[0][k] = k == in ? end_nm + turn->taper_nm : turn->start_nm[k];
        turn->corner_nm[1][k] = end_nm;
        turn->corner_nm[2][k] = k == in ? turn->start_nm[k] : end_nm;
    }
    const nck_status_t status = check_corner(self, turn->corner_nm[1]);
    return status == NCK_OK ? check_corner(self, turn->corner_nm[0]) : status;
}

// The infeed, X of turning and Z of facing, must not lead away from the end of the cut, and a taper
// needs a length.
static nck_status_t check_taper(nck_decode_t *self) {
    const nck_turn_t *const turn = &self->held.turn;
    const unsigned in = is_turning(self) ? 0 : 1;
    const int64_t depth_nm = turn->corner_nm[1][in] - turn->start_nm[in];
    const int64_t begin_nm = turn->corner_nm[0][in] - turn->start_nm[in];
    const int away = (depth_nm > 0 && begin_nm < 0) || (depth_nm < 0 && begin_nm > 0);
    const int flat = turn->corner_nm[1][1 - in] == turn->start_nm[1 - in];
    if (!away && !(flat && turn->taper_nm != 0)) return NCK_OK;
    const nck_scale_t *const scale = &self->place.scale[0];
    return nck_decode_fail_word(self, NCK_E_NUMBER_RANGE, taper_letter(self),
                                nck_decode_as_word(scale, nck_real_of(turn->taper_nm)),
                                nck_decode_as_word(scale, nck_real_of(-depth_nm)));
}

static nck_status_t begin(nck_decode_t *self) {
    nck_turn_t *const turn = &self->held.turn;
    const int32_t before = self->modal.motion;
    self->modal.motion = self->words.code[NCK_STEP_MOTION];
    if (self->modal.motion != before) {
        turn->said = 0;
        turn->taper_nm = 0;
    }
    const int says_taper = nck_has_word(self, 'R');
    if (self->words.axes == 0) return says_taper ? fail_missing(self, 'X') : NCK_OK;
    nck_decode_assume(self, NCK_NOTE_UNITS);
    if (self->machine->dialect.system == NCK_SYSTEM_OPEN) nck_decode_assume(self, NCK_NOTE_SYSTEM);
    nck_status_t status = nck_decode_cycle_fits(self);
    if (status == NCK_OK) status = read_end(self);
    if (status == NCK_OK) status = read_taper(self);
    if (status == NCK_OK) status = place_corners(self);
    if (status == NCK_OK) status = check_taper(self);
    if (status == NCK_OK) status = nck_decode_cutting_feed(self, 0, &turn->feed);
    if (status != NCK_OK) return status;
    nck_decode_moved(self);
    turn->left = MOVES;
    return NCK_OK;
}

// The next move. A rapid that goes nowhere is left out.
static nck_status_t go(nck_decode_t *self, nck_block_t *out) {
    nck_turn_t *const turn = &self->held.turn;
    const int rapid = turn->left == MOVES || turn->left == 1;
    const int64_t *const to_nm = turn->left == 1 ? turn->start_nm
                                                 : turn->corner_nm[MOVES - turn->left];
    int moves = !rapid;
    turn->left--;
    for (unsigned k = 0; k < 2; k++) {
        int64_t *const at_nm = &self->place.position_nm[nck_lathe_axis(k)];
        moves = moves || *at_nm != to_nm[k];
        *at_nm = to_nm[k];
    }
    if (!moves) return NCK_EMPTY;
    nck_decode_give_exact(self, rapid ? NCK_BLOCK_RAPID : NCK_BLOCK_LINE, turn->feed, out);
    return NCK_OK;
}

nck_status_t nck_decode_turn(nck_decode_t *self, nck_block_t *out) {
    if (!NCK_HAS_CYCLES) return NCK_E_UNSUPPORTED;
    nck_status_t status = self->held.turn.left == 0 ? begin(self) : NCK_OK;
    if (status == NCK_OK) status = NCK_EMPTY;
    while (status == NCK_EMPTY && self->held.turn.left > 0) status = go(self, out);
    if (self->held.turn.left > 0) nck_decode_leave(self, NCK_REST_CYCLE);
    return status;
}
