// SPDX-License-Identifier: MIT
// Do the words and codes of a line fit together, and who gets the axis words?
#include "nck/prep/1_decode/parts.h"

static const char axis_letter[] = "XYZABCUVW";

int nck_decode_letter(unsigned axis) {
    return axis_letter[axis];
}

static int has(const nck_words_t *words, nck_step_t step) {
    return (words->codes & NCK_STEP(step)) != 0;
}

// The leftmost word of a set of letters; letters must not be empty.
static int leftmost(const nck_words_t *words, uint32_t letters) {
    int found = 0;
    for (int letter = 'A'; letter <= 'Z'; letter++) {
        if (!(letters & NCK_LETTER(letter))) continue;
        if (found == 0 || words->column[letter - 'A'] < words->column[found - 'A']) found = letter;
    }
    return found;
}

static nck_status_t fail_code(nck_decode_t *self, nck_status_t code, nck_step_t step) {
    const int letter = step == NCK_STEP_MIST || step == NCK_STEP_FLOOD ? 'M' : 'G';
    return nck_decode_fail(self, code, self->words.code_column[step], letter,
                           self->words.code[step] / 10.0, 0.0);
}

// Words that time a dwell are the dwell's: P, in some dialects X, U or S.
static void claim_dwell(nck_decode_t *self) {
    nck_words_t *const words = &self->words;
    const uint32_t base = self->machine->dialect.base;
    if (!has(words, NCK_STEP_DWELL)) return;
    if (base == NCK_DIALECT_FANUC) words->takes |= NCK_LETTER('X') | NCK_LETTER('U');
    if (base == NCK_DIALECT_MARLIN) {
        words->takes |= NCK_LETTER('S');
        words->steps &= ~NCK_STEP(NCK_STEP_SPEED);
    }
}

// The axes that have a word to move or to set them. NCK_E_AXIS_UNKNOWN for one that is missing.
static nck_status_t claim_axes(nck_decode_t *self) {
    nck_words_t *const words = &self->words;
    uint32_t letters = words->letters & NCK_LETTERS_AXES;
    uint32_t strangers = 0;
    if (has(words, NCK_STEP_DWELL) && self->machine->dialect.base == NCK_DIALECT_FANUC) {
        letters &= ~(NCK_LETTER('X') | NCK_LETTER('U'));
    }
    for (unsigned axis = 0; letters != 0; axis++) {
        const uint32_t letter = letters & NCK_LETTER(axis_letter[axis]);
        const uint32_t bit = (uint32_t)1 << axis;
        letters &= ~letter;
        if (letter != 0) words->axes |= bit;
        if (letter != 0 && !(self->place.axes & bit)) strangers |= letter;
    }
    if (strangers == 0) return NCK_OK;
    return nck_decode_fail_word(self, NCK_E_AXIS_UNKNOWN, leftmost(words, strangers), 0.0, 0.0);
}

// Axis words go to G10, G28, G30 or G92 if there is one, else to the motion: the block's or the
// modal one.
static nck_status_t claim_motion(nck_decode_t *self) {
    nck_words_t *const words = &self->words;
    const int32_t modal = self->modal.motion;
    const int centre = modal >= 20 && (words->letters & NCK_LETTERS_CENTRE);
    const int taken = has(words, NCK_STEP_OFFSET) && words->code[NCK_STEP_OFFSET] <= 920;

    if (has(words, NCK_STEP_MOTION)) {
        // Fanuc's G0 G28 Z0: the motion code sets the mode, G28 has the words.
        if (taken && self->machine->dialect.base != NCK_DIALECT_FANUC) {
            return fail_code(self, NCK_E_MODAL_GROUP, NCK_STEP_OFFSET);
        }
        return NCK_OK;
    }
    if (taken || (words->axes == 0 && !centre)) return NCK_OK;
    if (modal < 0) {
        return nck_decode_fail_word(self, NCK_E_NO_MOTION,
                                    leftmost(words, words->letters & NCK_LETTERS_AXES), 0.0, 0.0);
    }
    words->steps |= NCK_STEP(NCK_STEP_MOTION);
    words->code[NCK_STEP_MOTION] = (uint16_t)modal;
    words->takes |= nck_decode_motion_takes(modal);
    return NCK_OK;
}

nck_status_t nck_decode_resolve(nck_decode_t *self) {
    nck_words_t *const words = &self->words;
    const uint32_t always = NCK_LETTER('F') | NCK_LETTER('N') | NCK_LETTER('S') | NCK_LETTER('T');

    if (words->letters & NCK_LETTER('E')) {
        return nck_decode_fail_word(self, NCK_E_WORD_UNKNOWN, 'E', 0.0, 0.0);
    }
    if (words->letters & NCK_LETTER('F')) words->steps |= NCK_STEP(NCK_STEP_FEED);
    if (words->letters & NCK_LETTER('S')) words->steps |= NCK_STEP(NCK_STEP_SPEED);
    if (words->letters & NCK_LETTER('T')) words->steps |= NCK_STEP(NCK_STEP_TOOL);
    claim_dwell(self);
    nck_status_t status = claim_axes(self);
    if (status == NCK_OK) status = claim_motion(self);
    if (status != NCK_OK) return status;
    if (words->letters & ~(words->takes | always)) {
        const int letter = leftmost(words, words->letters & ~(words->takes | always));
        return nck_decode_fail_word(self, NCK_E_WORD_UNUSED, letter, 0.0, 0.0);
    }
    if (has(words, NCK_STEP_MIST) && has(words, NCK_STEP_FLOOD)
        && words->code[NCK_STEP_FLOOD] == 90) {
        return fail_code(self, NCK_E_MODAL_GROUP, NCK_STEP_FLOOD);
    }
    const int straight = (words->steps & NCK_STEP(NCK_STEP_MOTION))
                         && words->code[NCK_STEP_MOTION] <= 10;
    if (has(words, NCK_STEP_MACHINE) && !straight) {
        return fail_code(self, NCK_E_WORD_MISSING, NCK_STEP_MACHINE);
    }
    return NCK_OK;
}
