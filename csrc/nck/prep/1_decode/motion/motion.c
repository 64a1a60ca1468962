// SPDX-License-Identifier: MIT
// Moves: targets in machine coordinates, travel, feed, and the way to the reference points.
#include "nck/prep/1_decode/motion/parts.h"
#include "nck/prep/1_decode/state/state.h" // nck_decode_assume nck_decode_block nck_decode_fail …
#include "nck/prep/1_decode/number/number.h" // nck_decode_fail_range nck_decode_travel …
#include "nck/prep/1_decode/tongue/tongue.h" // nck_words_set_axes
#include "nck/prep/1_decode/place/place.h" // nck_decode_target
#include "nck/prep/1_decode/macro/macro.h" // nck_decode_moved
#include "nck/base/budget.h" // NCK_TOLERANCE_MIN
#include "nck/base/real.h" // nck_real_of

#include <stddef.h> // NULL
#include <string.h> // memcpy

enum { POINT_MOST = 4 }; // of G30 P

static int axis_bit(uint32_t axes, unsigned axis) {
    return (int)((axes >> axis) & 1u);
}

static nck_status_t check_targets(nck_decode_t *self, uint32_t axes, const int64_t *target_nm) {
    for (unsigned axis = 0; axes != 0; axis++, axes >>= 1) {
        const nck_status_t status = axes & 1u ? nck_decode_travel(self, axis, target_nm[axis])
                                              : NCK_OK;
        if (status != NCK_OK) return status;
    }
    return NCK_OK;
}

// In a session an axis may stand outside of its travel. A straight way may take it nearer: no place
// of that is further out than where it begins.
static int comes_nearer(const nck_decode_t *self, unsigned axis, int64_t target_nm) {
    const nck_axis_t *const travel = &self->machine->axis[axis];
    const int64_t from_nm = self->place.position_nm[axis];
    if (from_nm > travel->max_nm) return target_nm >= travel->min_nm && target_nm <= from_nm;
    return from_nm < travel->min_nm && target_nm <= travel->max_nm && target_nm >= from_nm;
}

// Degrees per minute are what F means if nothing but rotary axes moves, in inches too.
static int only_rotary_moves(const nck_decode_t *self, const int64_t *target_nm) {
    if (!(self->words.axes & self->place.rotary)) return 0;
    for (unsigned axis = 0; axis < NCK_AXIS_MAX; axis++) {
        const int moves = target_nm[axis] != self->place.position_nm[axis];
        if (moves && !axis_bit(self->place.rotary, axis)) return 0;
    }
    return 1;
}

// What is missing is told once, not on every line: NCK_EMPTY from then on.
static nck_status_t fail_feed(nck_decode_t *self, int letter) {
    const uint8_t bit = letter == 'F' ? NCK_EXCUSED_FEED : NCK_EXCUSED_SPEED;
    if (self->modal.excused & bit) return NCK_EMPTY;
    self->modal.excused |= bit;
    return nck_decode_fail(self, NCK_E_FEED_MISSING, 0, letter, 0.0, 0.0);
}

nck_status_t nck_decode_cutting_feed(nck_decode_t *self, int rotary_alone, double *feed_out) {
    const int said = nck_has_word(self, 'F');
    if (self->modal.feed <= 0.0) return fail_feed(self, 'F');
    if (self->modal.feed_mode == NCK_FEED_INVERSE && !said) return fail_feed(self, 'F');
    const int per_rev = self->modal.feed_mode == NCK_FEED_PER_REV;
    if (per_rev && !nck_decode_turns(self)) return fail_feed(self, 'S');
    *feed_out = rotary_alone ? self->modal.feed_word : self->modal.feed;
    return NCK_OK;
}

static void arrive(nck_decode_t *self, const int64_t *target_nm) {
    memcpy(self->place.position_nm, target_nm, sizeof self->place.position_nm);
}

nck_status_t nck_decode_straight(nck_decode_t *self, nck_block_kind_t kind,
                                 const int64_t *target_nm, nck_block_t *out) {
    double feed = 0.0;
    uint32_t axes = self->words.axes;
    for (unsigned axis = 0; self->session.before && axis < NCK_AXIS_MAX; axis++) {
        if (comes_nearer(self, axis, target_nm[axis])) axes &= ~((uint32_t)1 << axis);
    }
    nck_status_t status = check_targets(self, axes, target_nm);
    if (status == NCK_OK && kind == NCK_BLOCK_LINE) {
        status = nck_decode_cutting_feed(self, only_rotary_moves(self, target_nm), &feed);
    }
    // Also after an error the next line counts from here: one mistake, one finding.
    arrive(self, target_nm);
    nck_decode_block(self, kind, out);
    out->feed = feed;
    return status;
}

// G9: this move alone ends in an exact stop.
static void stop_exactly(const nck_decode_t *self, nck_block_t *out) {
    if (self->words.codes & NCK_STEP(NCK_STEP_EXACT)) out->path_mode = NCK_PATH_STOP;
}

// Marlin's ends in software: an axis that would leave its travel stays at its end.
static nck_status_t straight_within(nck_decode_t *self, nck_block_kind_t kind,
                                    const int64_t *target_nm, nck_block_t *out) {
    int64_t end_nm[NCK_AXIS_MAX];
    memcpy(end_nm, target_nm, sizeof end_nm);
    for (unsigned axis = NCK_AXIS_X; axis <= NCK_AXIS_Z && !self->machine->roams; axis++) {
        const nck_axis_t *const travel = &self->machine->axis[axis];
        const int64_t low_nm = travel->min_nm, high_nm = travel->max_nm, to_nm = end_nm[axis];
        if (!axis_bit(self->words.axes, axis) || (to_nm >= low_nm && to_nm <= high_nm)) continue;
        end_nm[axis] = to_nm < low_nm ? low_nm : high_nm;
        nck_decode_note_end(self, axis, to_nm, end_nm[axis]);
    }
    return nck_decode_straight(self, kind, end_nm, out);
}

nck_status_t nck_decode_go(nck_decode_t *self, const nck_block_in_t *pushed,
                           const int64_t *target_nm, nck_block_t *out) {
    const int32_t code = self->words.code[NCK_STEP_MOTION];
    nck_status_t status = NCK_OK;
    if (code >= 20) {
        double feed = 0.0;
        status = check_targets(self, self->words.axes, target_nm);
        if (status == NCK_OK) status = nck_decode_cutting_feed(self, 0, &feed);
        if (status == NCK_OK) status = nck_decode_arc(self, pushed, target_nm, out);
        arrive(self, target_nm);
        out->feed = feed;
        self->second.feed = feed;
    } else {
        const nck_block_kind_t kind = code == 0 ? NCK_BLOCK_RAPID : NCK_BLOCK_LINE;
        const int prints = NCK_HAS_FOREIGN && pushed == NULL && self->tongue == NCK_TONGUE_MARLIN;
        status = prints && !self->modal.roams ? straight_within(self, kind, target_nm, out)
                        : nck_decode_straight(self, kind, target_nm, out);
    }
    if (code == 0 && nck_decode_has_feed(self, NCK_BLOCK_RAPID)) out->feed = self->modal.feed;
    stop_exactly(self, out);
    return status;
}

// G80, or a cycle; where another code has the axis words it only sets the mode.
static nck_status_t other_motion(nck_decode_t *self, int taken) {
    const int32_t code = self->words.code[NCK_STEP_MOTION];
    if (code != 800 && !taken) {
        nck_decode_leave(self, NCK_REST_CYCLE);
        return NCK_EMPTY;
    }
    self->modal.motion = code == 800 ? NCK_MOTION_NONE : code;
    return NCK_EMPTY;
}

// What a move needs and the program has not said.
static void note_assumed(nck_decode_t *self, int turns) {
    const uint32_t plane = (uint32_t)turns << NCK_NOTE_PLANE;
    const uint32_t assumed = 1u << NCK_NOTE_UNITS | 1u << NCK_NOTE_DISTANCE | plane;
    if (!(~(self->finding.given | self->finding.notes) & assumed)) return;
    nck_decode_assume_places(self);
    if (plane != 0) nck_decode_assume(self, NCK_NOTE_PLANE);
}

nck_status_t nck_decode_motion(nck_decode_t *self, nck_block_t *out) {
    // G80 on Fanuc's mills: cycles are a group of their own there, and the motion of the other
    // group, which was in force before them, goes on.
    const int ends = self->words.code[NCK_STEP_MOTION] == 800 && self->tongue == NCK_TONGUE_FANUC;
    const int32_t code = ends ? self->modal.group : self->words.code[NCK_STEP_MOTION];
    const int taken = (self->words.codes & NCK_STEPS_AXES) && nck_words_set_axes(&self->words);
    int64_t target_nm[NCK_AXIS_MAX];

    if (nck_motion_is_spline(self->modal.motion)) {
        const nck_status_t status = nck_spline_refuses(self, NCK_STEP_MOTION);
        if (status != NCK_OK) return status;
    }
    if (code > 30) return other_motion(self, taken);
    self->words.code[NCK_STEP_MOTION] = (uint16_t)code;
    self->modal.motion = code;
    self->modal.group = (uint8_t)code;
    if (taken || (self->words.axes == 0 && (ends || code < 20))) return NCK_EMPTY;
    note_assumed(self, code >= 20);
    const int absolute = (self->words.codes & NCK_STEP(NCK_STEP_MACHINE)) != 0;
    const nck_status_t status = nck_decode_target(self, absolute, target_nm);
    if (status != NCK_OK) return status;
    nck_decode_moved(self);
    return nck_decode_go(self, NULL, target_nm, out);
}

// G28: the first reference point, G30: the second, or the one that P names, if the machine has it.
static nck_status_t find_home(nck_decode_t *self, const int64_t **home_out) {
    const nck_number_t *const word = &self->words.number['P' - 'A'];
    const int first = self->words.code[NCK_STEP_OFFSET] == 280;
    int64_t point = 2;
    const int said = !first && nck_has_word(self, 'P');
    if (first) point = 1;
    if (said && (!nck_number_whole(word, 0, &point) || point < 2 || point > POINT_MOST)) {
        return nck_decode_fail_range(self, 'P', POINT_MOST);
    }
    if (point > 2 && !(self->machine->home_more >> (point - 3) & 1u)) {
        return nck_decode_fail_word(self, NCK_E_UNSUPPORTED, 'P', nck_real_of(point), 0.0);
    }
    *home_out = point <= 2 ? self->place.home_nm[point - 1] : self->machine->home_nm[point - 1];
    return NCK_OK;
}

// G28, G30: by way of the point that the words name to the reference point, on the axes named, on
// all if none is. Marlin's G28 has no such point: its words only name axes.
nck_status_t nck_decode_reference(nck_decode_t *self, nck_block_t *out) {
    const int64_t *home = NULL;
    int64_t target_nm[NCK_AXIS_MAX];
    const uint32_t axes = self->words.axes != 0 ? self->words.axes : self->place.axes;

    nck_status_t status = nck_spline_refuses(self, NCK_STEP_OFFSET);
    if (status == NCK_OK) status = find_home(self, &home);
    if (status != NCK_OK) return status;
    memcpy(target_nm, self->place.position_nm, sizeof target_nm);
    if (self->machine->dialect.base != NCK_DIALECT_MARLIN && self->words.axes != 0) {
        nck_decode_assume_places(self);
        status = nck_decode_target(self, 0, target_nm);
        if (status != NCK_OK) return status;
    }
    status = nck_decode_straight(self, NCK_BLOCK_RAPID, target_nm, out);
    for (unsigned axis = 0; axis < NCK_AXIS_MAX; axis++) {
        if (axis_bit(axes, axis)) target_nm[axis] = home[axis];
    }
    if (status == NCK_OK) status = check_targets(self, axes, target_nm);
    arrive(self, target_nm);
    nck_decode_block(self, NCK_BLOCK_RAPID, &self->second);
    nck_decode_leave(self, NCK_REST_SECOND);
    return status;
}

nck_status_t nck_decode_cycle_fits(nck_decode_t *self) {
    if (self->modal.feed_mode == NCK_FEED_INVERSE) {
        return nck_decode_fail(self, NCK_E_UNSUPPORTED, 0, 'G', 93.0, 0.0);
    }
    if (!self->modal.comp) return NCK_OK;
    return nck_decode_fail(self, NCK_E_COMP_ON, 0, 'G',
                           self->words.code[NCK_STEP_MOTION] / 10.0, 0.0);
}

void nck_decode_give_within(const nck_decode_t *self, nck_block_kind_t kind, double feed,
                            nck_block_t *out) {
    nck_decode_block(self, kind, out);
    out->feed = kind == NCK_BLOCK_RAPID ? 0.0 : feed;
    stop_exactly(self, out);
}

void nck_decode_give_exact(const nck_decode_t *self, nck_block_kind_t kind, double feed,
                           nck_block_t *out) {
    nck_decode_give_within(self, kind, feed, out);
    if (out->path_mode == NCK_PATH_CONTINUOUS) {
        const int is_within = out->tolerance_mm >= NCK_TOLERANCE_MIN;
        out->path_mode = is_within ? NCK_PATH_TURNS : NCK_PATH_EXACT;
    }
    out->tolerance_mm = 0.0;
    out->merge_mm = 0.0;
}

nck_status_t nck_decode_second(nck_decode_t *self, nck_block_t *out) {
    *out = self->second;
    stop_exactly(self, out);
    return NCK_OK;
}
