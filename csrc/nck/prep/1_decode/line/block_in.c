// SPDX-License-Identifier: MIT
// Blocks that come without text: they do what a line of words would do.
#include "nck/prep/1_decode/line/line.h"
#include "nck/prep/1_decode/state/state.h" // nck_decode_fail nck_decode_give_dwell …
#include "nck/prep/1_decode/number/number.h" // nck_decode_letter
#include "nck/prep/1_decode/tongue/tongue.h" // nck_decode_code
#include "nck/prep/1_decode/modal/modal.h" // nck_decode_set_feed nck_decode_set_speed
#include "nck/prep/1_decode/place/place.h" // nck_decode_set_tool
#include "nck/prep/1_decode/motion/motion.h" // nck_decode_go
#include "nck/base/budget.h" // NCK_TOLERANCE_MIN
#include "nck/base/real.h" // nck_fabs nck_floor nck_rounded nck_within nck_real_of

#include <string.h> // memcpy

static const double value_max = NCK_DECODE_VALUE_MAX;
static const double linear_max_mm = NCK_LINEAR_MAX_MM;
static const double dwell_max_s = NCK_DECODE_DWELL_MAX_S;

static int target_good(const nck_block_in_t *block) {
    int good = block->axes < (uint32_t)1 << NCK_AXIS_MAX;
    for (unsigned axis = 0; axis < NCK_AXIS_MAX; axis++) {
        const int counts = (int)(block->axes >> axis & 1u);
        good = good && (!counts || block->target[axis] - block->target[axis] == 0.0);
    }
    return good;
}

static int arc_good(const nck_block_in_t *block) {
    return block->plane >= 17 && block->plane <= 19 && block->turns != 0
           && nck_within((double)block->turns, -NCK_DECODE_TURNS_MAX, NCK_DECODE_TURNS_MAX)
           && nck_within(block->centre[0], -2.0 * linear_max_mm, 2.0 * linear_max_mm)
           && nck_within(block->centre[1], -2.0 * linear_max_mm, 2.0 * linear_max_mm);
}

static int kind_good(const nck_block_in_t *block) {
    const double whole = nck_floor(block->value);
    switch (block->kind) {
    case NCK_IN_SET: return 1;
    case NCK_IN_RAPID:
    case NCK_IN_LINE: return target_good(block);
    case NCK_IN_ARC: return target_good(block) && arc_good(block);
    case NCK_IN_DWELL: return nck_within(block->value, 0.0, dwell_max_s);
    case NCK_IN_S: return nck_within(block->value, 0.0, value_max);
    case NCK_IN_M:
    case NCK_IN_T: return nck_within(block->value, 0.0, value_max) && block->value == whole;
    default: return 0;
    }
}

int nck_decode_block_good(const nck_block_in_t *block) {
    const int feeds = (block->sets & NCK_IN_SETS_FEED) != 0;
    const int paths = (block->sets & NCK_IN_SETS_PATH) != 0;
    const int within_p = block->path_mode == NCK_PATH_CONTINUOUS;
    return block->sets <= (NCK_IN_SETS_FEED | NCK_IN_SETS_PATH) && kind_good(block)
           && (!feeds || (block->feed_mode <= NCK_FEED_PER_REV && block->feed > 0.0
                          && block->feed <= value_max))
           && (!paths || (block->path_mode <= NCK_PATH_TURNS
                          && (!within_p || nck_within(block->tolerance, 0.0, linear_max_mm))));
}

static void set_path(nck_decode_t *self, const nck_block_in_t *block) {
    if (!(block->sets & NCK_IN_SETS_PATH)) return;
    const int within_p = block->path_mode == NCK_PATH_CONTINUOUS;
    if (within_p && block->tolerance < NCK_TOLERANCE_MIN) {
        nck_decode_note_word(self, NCK_NOTE_TOLERANCE, 'P', block->tolerance);
    } else if (within_p && self->machine->slope != NCK_SLOPE_OPTIMAL) {
        nck_decode_note_word(self, NCK_NOTE_TOLERANCE, 'G', 64.0);
    }
    self->modal.path_mode = block->path_mode;
    self->modal.tolerance_mm = within_p ? block->tolerance : 0.0;
    self->modal.merge_mm = self->modal.tolerance_mm;
}

static nck_status_t set_code(nck_decode_t *self, const nck_block_in_t *block) {
    unsigned step = 0;
    uint32_t takes = 0;
    const int64_t tenths = 10 * (int64_t)block->value;
    const nck_status_t status = nck_decode_code(self, 'M', tenths, &step, &takes);
    if (status != NCK_OK) return nck_decode_fail(self, status, 0, 'M', block->value, 0.0);
    self->words.steps = NCK_STEP(step);
    self->words.code[step] = (uint16_t)tenths;
    return NCK_OK;
}

nck_status_t nck_decode_pushed(nck_decode_t *self) {
    const nck_block_in_t *const block = &self->pushed;
    self->words.letters = 0;
    self->words.axes = 0;
    self->words.codes = 0;
    self->words.takes = 0;
    self->words.steps = 0;
    nck_decode_leave(self, NCK_REST_PUSHED);
    self->finding.given |= 1u << NCK_NOTE_NO_END; // geometry has no M2
    if (block->sets & NCK_IN_SETS_FEED) {
        self->modal.feed_mode = block->feed_mode;
        nck_decode_set_feed(self, block->feed, block->feed);
        self->words.letters |= NCK_LETTER('F'); // what inverse time asks for
    }
    set_path(self, block);
    const nck_status_t status = block->kind == NCK_IN_M ? set_code(self, block) : NCK_OK;
    if (status != NCK_OK) return status;
    // What radius compensation has no place for: an arc in another plane, a change of tool.
    const int turns = block->kind == NCK_IN_ARC && block->plane != self->modal.plane;
    const int changes = (self->words.steps & NCK_STEP(NCK_STEP_CHANGE)) != 0;
    if (!self->modal.comp) return NCK_OK;
    if (turns) return nck_decode_fail(self, NCK_E_COMP_ON, 0, 'G', (double)block->plane, 0.0);
    return changes ? nck_decode_fail(self, NCK_E_COMP_ON, 0, 'M', block->value, 0.0) : NCK_OK;
}

// The machine position that the block names.
static nck_status_t read_target(nck_decode_t *self, const nck_block_in_t *block,
                                int64_t *target_nm) {
    memcpy(target_nm, self->place.position_nm, sizeof self->place.position_nm);
    for (unsigned axis = 0; axis < NCK_AXIS_MAX; axis++) {
        if (!(block->axes >> axis & 1u)) continue;
        const int letter = nck_decode_letter(axis);
        const int rotary = (int)(self->place.rotary >> axis & 1u);
        const double counts = rotary ? NCK_COUNTS_PER_DEG : NCK_COUNTS_PER_MM;
        const double limit = rotary ? NCK_ROTARY_MAX_DEG : NCK_LINEAR_MAX_MM;
        if (!(self->place.axes >> axis & 1u)) {
            return nck_decode_fail(self, NCK_E_AXIS_UNKNOWN, 0, letter, 0.0, 0.0);
        }
        const double target = block->target[axis];
        const double origin = nck_real_of(self->place.origin_nm[axis]) / counts;
        if (nck_fabs(target) > limit || nck_fabs(origin + target) > limit) {
            return nck_decode_fail(self, NCK_E_NUMBER_RANGE, 0, letter, target, limit);
        }
        target_nm[axis] = self->place.origin_nm[axis] + nck_rounded(target * counts);
    }
    return NCK_OK;
}

nck_status_t nck_decode_give_pushed(nck_decode_t *self, nck_block_t *out) {
    const nck_block_in_t *const block = &self->pushed;
    switch (block->kind) {
    case NCK_IN_SET: return NCK_EMPTY;
    case NCK_IN_DWELL: return nck_decode_give_dwell(self, block->value, out);
    case NCK_IN_S: return nck_decode_set_speed(self, block->value, out);
    case NCK_IN_T: return nck_decode_set_tool(self, block->value, out);
    default: {
        int64_t target_nm[NCK_AXIS_MAX];
        // G0 … G3 in tenths.
        const uint8_t code = block->kind == NCK_IN_RAPID  ? 0
                             : block->kind == NCK_IN_LINE ? 10
                             : block->turns < 0           ? 20
                                                          : 30;
        self->words.code[NCK_STEP_MOTION] = code;
        self->modal.motion = code;
        self->modal.group = code;
        self->words.axes = block->axes;
        if (block->kind == NCK_IN_ARC) self->modal.plane = block->plane;
        const nck_status_t status = read_target(self, block, target_nm);
        return status == NCK_OK ? nck_decode_go(self, block, target_nm, out) : status;
    }
    }
}
