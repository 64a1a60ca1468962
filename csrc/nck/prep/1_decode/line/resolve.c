// SPDX-License-Identifier: MIT
// Do the words and codes of a line fit together, and who gets the axis words?
#include "nck/prep/1_decode/line/line.h"
#include "nck/prep/1_decode/state/state.h" // nck_decode_fail_code nck_decode_fail_word
#include "nck/prep/1_decode/number/number.h" // nck_decode_letter
#include "nck/prep/1_decode/tongue/tongue.h" // nck_decode_follows nck_decode_motion_takes …
#include "nck/prep/1_decode/place/place.h" // nck_decode_comp_refuses nck_layout_refuses …
#include "nck/prep/1_decode/motion/motion.h" // nck_corner_letters nck_polar_resolve

enum { AXIS_C = 5 };

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

// C of a lathe that speaks Fanuc's language and has no such axis: a corner's.
static uint32_t corner_letter(const nck_decode_t *self) {
    const int has_axis = NCK_AXIS_MAX > AXIS_C && (self->place.axes >> AXIS_C & 1u);
    return self->lathe && !has_axis ? self->words.letters & NCK_LETTER('C') : 0;
}

// The axis words that no dwell has.
static uint32_t axis_letters(const nck_decode_t *self) {
    const uint32_t letters = self->words.letters & NCK_LETTERS_AXES & ~corner_letter(self);
    const int dwells = has(&self->words, NCK_STEP_DWELL);
    const int moves = self->lathe && has(&self->words, NCK_STEP_MOTION);
    const int32_t motion = self->words.code[NCK_STEP_MOTION];
    if (moves && nck_decode_follows(self, motion)) return 0; // U and W are what the contour keeps
    if (moves && motion == NCK_MOTION_SCREW) return letters & ~NCK_LETTER('A'); // its angle
    if (!dwells || !nck_is_fanuc(self)) return letters;
    return letters & ~(NCK_LETTER('X') | NCK_LETTER('U'));
}

// The axes that have a word to move or to set them. NCK_E_AXIS_UNKNOWN for one that is missing.
static nck_status_t claim_axes(nck_decode_t *self) {
    nck_words_t *const words = &self->words;
    uint32_t letters = axis_letters(self);
    uint32_t strangers = 0;
    for (unsigned axis = 0; letters != 0; axis++) {
        const uint32_t letter = letters & NCK_LETTER(nck_decode_letter(axis));
        const uint32_t bit = (uint32_t)1 << axis;
        letters &= ~letter;
        if (letter != 0) words->axes |= bit;
        if (letter != 0 && !(self->place.axes & bit)) strangers |= letter;
    }
    if (strangers == 0) return NCK_OK;
    const nck_status_t status = nck_lathe_steps(self, strangers);
    if (status != NCK_EMPTY) return status;
    return nck_decode_fail_word(self, NCK_E_AXIS_UNKNOWN, leftmost(words, strangers), 0.0, 0.0);
}

// No motion that could use the axis words is in force.
static nck_status_t no_motion(nck_decode_t *self) {
    if (self->modal.motion == NCK_MOTION_REFUSED) {
        self->words.takes = ~(uint32_t)0; // whatever it would have been
        return NCK_OK;
    }
    const int letter = leftmost(&self->words, self->words.letters & NCK_LETTERS_AXES);
    return nck_decode_fail_word(self, NCK_E_NO_MOTION, letter, 0.0, 0.0);
}

// What moves without an axis word: an arc by its centre, in Fanuc's language a cycle by its R; the
// last knots of a spline.
static int goes_without_axes(const nck_decode_t *self, int32_t modal) {
    const int fanuc = nck_is_fanuc(self);
    const int knots = modal == NCK_MOTION_KNOTS || modal == NCK_MOTION_REFUSED;
    if (fanuc && knots && (self->words.letters & NCK_LETTER('K'))) return 1;
    if (nck_motion_is_cycle(modal)) return fanuc && (self->words.letters & NCK_LETTER('R'));
    return modal >= 20 && (self->words.letters & NCK_LETTERS_CENTRE);
}

// Axis words go to G10, G28, G30 or G92 if there is one, else to the motion: the block's or the
// modal one.
static nck_status_t claim_motion(nck_decode_t *self) {
    nck_words_t *const words = &self->words;
    const int32_t modal = self->modal.motion;
    const int taken = (words->codes & NCK_STEPS_AXES) && nck_words_set_axes(words);

    if (has(words, NCK_STEP_MOTION)) {
        // Fanuc's G0 G28 Z0: the motion code sets the mode, G28 has the words.
        const int second = taken && words->code[NCK_STEP_MOTION] != 800;
        if (second && !nck_is_fanuc(self)) {
            const int offset = has(words, NCK_STEP_OFFSET) && words->code[NCK_STEP_OFFSET] <= 920;
            return nck_decode_fail_code(self, NCK_E_MODAL_GROUP,
                                        offset ? NCK_STEP_OFFSET : NCK_STEP_LENGTH);
        }
        return NCK_OK;
    }
    if (taken || (words->axes == 0 && !goes_without_axes(self, modal))) return NCK_OK;
    if (modal < 0) return no_motion(self);
    words->steps |= NCK_STEP(NCK_STEP_MOTION);
    words->code[NCK_STEP_MOTION] = (uint16_t)modal;
    words->takes |= nck_decode_motion_takes(self, modal);
    return NCK_OK;
}

// G53 needs a straight move, and a position that counts from the machine's zero.
static nck_status_t check_machine(nck_decode_t *self) {
    const nck_words_t *const words = &self->words;
    const int straight = (words->steps & NCK_STEP(NCK_STEP_MOTION))
                         && words->code[NCK_STEP_MOTION] <= 10;
    if (!straight) return nck_decode_fail_code(self, NCK_E_WORD_MISSING, NCK_STEP_MACHINE);
    const int incremental = has(words, NCK_STEP_DISTANCE) ? words->code[NCK_STEP_DISTANCE] == 910
                                                          : self->modal.incremental;
    return incremental ? nck_decode_fail_code(self, NCK_E_INCREMENTAL, NCK_STEP_MACHINE) : NCK_OK;
}

// Whether the code of a step is there and takes P.
static int takes_p(const nck_decode_t *self, nck_step_t step) {
    const nck_words_t *const words = &self->words;
    if (!has(words, step)) return 0;
    return (nck_decode_motion_takes(self, words->code[step]) & NCK_LETTER('P')) != 0;
}

// P is a dwell's, a tolerance, a work system, a point, a program, an arc's turns or a cycle's: of
// one.
// (rs274 refuses G4 with G2 alone and lets the others share.)
static nck_status_t check_shared(nck_decode_t *self) {
    const nck_words_t *const words = &self->words;
    const uint32_t of_motion = nck_decode_motion_takes(self, words->code[NCK_STEP_MOTION]);
    const int moves = (words->steps & NCK_STEP(NCK_STEP_MOTION)) && (of_motion & NCK_LETTER('P'));
    const int work = has(words, NCK_STEP_OFFSET) && (words->code[NCK_STEP_OFFSET] == 100
                                                     || words->code[NCK_STEP_OFFSET] == 300);
    const int path = takes_p(self, NCK_STEP_PATH);
    const int zero = takes_p(self, NCK_STEP_WORK);
    const int scale = has(words, NCK_STEP_LAYOUT)
                      && (words->code[NCK_STEP_LAYOUT] & NCK_LAYOUT_G51);
    const int others = has(words, NCK_STEP_DWELL) + has(words, NCK_STEP_CALL) + scale
                       + has(words, NCK_STEP_PORT);
    if (moves + work + path + zero + others <= 1) return NCK_OK;
    return nck_decode_fail_word(self, NCK_E_WORD_SHARED, 'P', 0.0, 0.0);
}

// On Fanuc's controls the S beside G92, in system A G50, is no speed but the most under G96.
static nck_status_t check_limit(nck_decode_t *self) {
    nck_words_t *const words = &self->words;
    const int limits = words->code[NCK_STEP_OFFSET] == 920 && (words->letters & NCK_LETTER('S'));
    if (limits && self->lathe) words->steps &= ~NCK_STEP(NCK_STEP_SPEED);
    if (!limits || self->lathe || words->axes != 0) return NCK_OK;
    return nck_decode_fail_code(self, NCK_E_UNSUPPORTED, NCK_STEP_OFFSET);
}

// What cannot be done while something else is in force.
static nck_status_t check_in_force(nck_decode_t *self) {
    const uint32_t on = self->layout.on;
    nck_status_t status = NCK_OK;
    if (on & NCK_LAYOUT_SYSTEM) status = nck_turned_refuses(self);
    else if (on != 0) status = nck_layout_refuses(self);
    return status == NCK_OK && self->modal.comp ? nck_decode_comp_refuses(self) : status;
}

// What else cannot stand in one block.
static nck_status_t check_codes(nck_decode_t *self) {
    const nck_words_t *const words = &self->words;
    if (has(words, NCK_STEP_MIST) && has(words, NCK_STEP_FLOOD)
        && words->code[NCK_STEP_FLOOD] == 90) {
        return nck_decode_fail_code(self, NCK_E_MODAL_GROUP, NCK_STEP_FLOOD);
    }
    nck_status_t status = NCK_OK;
    if (words->letters & NCK_LETTER('P')) status = check_shared(self);
    if (status == NCK_OK && has(words, NCK_STEP_OFFSET)) status = check_limit(self);
    if (status == NCK_OK && has(words, NCK_STEP_MACHINE)) status = check_machine(self);
    return status == NCK_OK ? check_in_force(self) : status;
}

static nck_status_t resolve_words(nck_decode_t *self) {
    nck_words_t *const words = &self->words;
    const uint32_t always = NCK_LETTER('F') | NCK_LETTER('N') | NCK_LETTER('S') | NCK_LETTER('T');
    const int plain = !(words->codes & ~NCK_STEP(NCK_STEP_MOTION));
    if (words->letters & ~words->takes & NCK_LETTER('E')) {
        return nck_decode_fail_word(self, NCK_E_WORD_UNKNOWN, 'E', 0.0, 0.0);
    }
    if (words->letters & NCK_LETTER('F')) words->steps |= NCK_STEP(NCK_STEP_FEED);
    if (words->letters & NCK_LETTER('S')) words->steps |= NCK_STEP(NCK_STEP_SPEED);
    if (words->letters & NCK_LETTER('T')) words->steps |= NCK_STEP(NCK_STEP_TOOL);
    if (!plain) claim_dwell(self);
    nck_status_t status = claim_axes(self);
    if (status == NCK_OK) status = claim_motion(self);
    if (status != NCK_OK) return status;
    uint32_t unused = (words->letters & ~(words->takes | always)) | corner_letter(self);
    if (unused != 0) unused &= ~nck_corner_letters(self, unused);
    if (unused != 0) {
        const int letter = leftmost(words, unused);
        return nck_decode_fail_word(self, NCK_E_WORD_UNUSED, letter, 0.0, 0.0);
    }
    return plain ? NCK_OK : check_codes(self);
}

// A G code that only the machine's file has, or of a printer: it stands alone.
static nck_status_t resolve_own(nck_decode_t *self) {
    nck_words_t *const words = &self->words;
    const uint32_t unused = words->letters & ~(words->takes | NCK_LETTER('N'));
    words->steps = NCK_STEP(NCK_STEP_OWN);
    if (words->codes != words->steps) {
        return nck_decode_fail_code(self, NCK_E_MODAL_GROUP, NCK_STEP_OWN);
    }
    if (unused == 0) return NCK_OK;
    return nck_decode_fail_word(self, NCK_E_WORD_UNUSED, leftmost(words, unused), 0.0, 0.0);
}

static nck_status_t resolve_printer(nck_decode_t *self) {
    if (nck_printer_speaks(self)) return nck_printer_resolve(self);
    const nck_status_t status = nck_printer_extrude(self);
    return status == NCK_OK ? resolve_words(self) : status;
}

nck_status_t nck_decode_resolve(nck_decode_t *self) {
    const int calls = has(&self->words, NCK_STEP_CALL);
    if (calls && nck_words_are_arguments(&self->words)) {
        // G65 and G66: all words are the called program's.
        nck_words_t *const words = &self->words;
        words->steps = NCK_STEP(NCK_STEP_CALL);
        if (words->codes == words->steps) return NCK_OK;
        return nck_decode_fail_code(self, NCK_E_MODAL_GROUP, NCK_STEP_CALL);
    }
    const int own = has(&self->words, NCK_STEP_OWN);
    if (own && self->words.code[NCK_STEP_OWN] >= NCK_CODE_OWN_G) return resolve_own(self);
    if (self->machine->dialect.base == NCK_DIALECT_MARLIN) return resolve_printer(self);
    nck_status_t status = self->lathe ? nck_slant_plain(self) : NCK_OK;
    if (status == NCK_OK && self->words.polars != 0) status = nck_polar_resolve(self);
    return status == NCK_OK ? resolve_words(self) : status;
}
