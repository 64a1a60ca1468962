// SPDX-License-Identifier: MIT
// G70 … G73: their words, in Fanuc's two lines or in one, and in RS274NGC's way.
#include "nck/prep/1_decode/lathe/parts.h"
#include "nck/prep/1_decode/lathe/rough.h"
#include "nck/prep/1_decode/state/state.h" // nck_decode_assume nck_decode_fail …
#include "nck/prep/1_decode/number/number.h" // nck_decode_fail_range nck_decode_length_word …
#include "nck/prep/1_decode/place/place.h" // nck_decode_target
#include "nck/prep/1_decode/macro/macro.h" // nck_call nck_decode_fail_last nck_frame_call …
#include "nck/prep/1_decode/motion/motion.h" // nck_decode_cutting_feed nck_decode_cycle_fits
#include "nck/base/real.h" // nck_real_of

#include <stddef.h> // NULL
#include <string.h> // memcpy

enum { PASSES_MOST = 1000, DEPTH_NM = 1000000 };

static const int64_t any_nm = -2000000000000000; // less than every length

static uint32_t code_of(const nck_decode_t *self) { return self->words.code[NCK_STEP_MOTION]; }

static nck_status_t fail_missing(nck_decode_t *self, int letter) {
    return nck_decode_fail_missing(self, NCK_STEP_MOTION, letter);
}

// A length with a sign, or one that has none: more than 0, or 0 too. It stays if it is not said.
static nck_status_t read_length(nck_decode_t *self, char letter, int64_t least_nm, int64_t *out) {
    if (!nck_has_word(self, letter)) return NCK_OK;
    const nck_status_t status = nck_decode_length_word(self, letter, out);
    if (status != NCK_OK || *out >= least_nm) return status;
    return nck_decode_fail_range(self, letter, 0.0);
}

// ---- Fanuc's first line: what holds for the cycles behind it

// U W R; in one line I K D. count: of the first line, 0 if nothing has said it.
static nck_status_t read_pattern(nck_decode_t *self, const char *letters, int64_t *count) {
    nck_rough_t *const rough = &self->held.rough;
    *count = (int64_t)rough->patterns;
    nck_status_t status = read_length(self, letters[0], any_nm, &rough->pattern_nm[0]);
    if (status == NCK_OK) status = read_length(self, letters[1], any_nm, &rough->pattern_nm[1]);
    if (status == NCK_OK) status = nck_decode_whole(self, letters[2], PASSES_MOST, *count, count);
    if (status != NCK_OK || *count >= 2 || !nck_has_word(self, letters[2])) return status;
    return nck_decode_fail_range(self, letters[2], 2.0);
}

static nck_status_t keep_depth(nck_decode_t *self) {
    nck_rough_t *const rough = &self->held.rough;
    const char deep = code_of(self) == NCK_MOTION_ROUGH ? 'U' : 'W';
    const char other = deep == 'U' ? 'W' : 'U';
    if (nck_has_word(self, other)) {
        return nck_decode_fail_word(self, NCK_E_WORD_UNUSED, other, 0.0, 0.0);
    }
    nck_status_t status = read_length(self, deep, 1, &rough->depth_nm);
    if (status == NCK_OK) status = read_length(self, 'R', 0, &rough->retract_nm);
    return status;
}

static nck_status_t keep_words(nck_decode_t *self) {
    static const char others[] = "DIK";
    for (unsigned k = 0; k < 3; k++) {
        if (nck_has_word(self, others[k])) return fail_missing(self, 'P');
    }
    if (code_of(self) == NCK_MOTION_FINISH) return fail_missing(self, 'P');
    nck_status_t status = NCK_OK;
    if (code_of(self) == NCK_MOTION_PATTERN) {
        int64_t count = 0;
        status = read_pattern(self, "UWR", &count);
        if (status == NCK_OK) self->held.rough.patterns = (uint32_t)count;
    } else {
        status = keep_depth(self);
    }
    return status == NCK_OK ? NCK_EMPTY : status;
}

// ---- Fanuc's second line, or the only one

static nck_status_t read_lines(nck_decode_t *self) {
    int64_t first = 0, last = 0;
    nck_status_t status = nck_decode_whole(self, 'P', NCK_LABEL_MOST, 0, &first);
    if (status == NCK_OK) status = nck_decode_whole(self, 'Q', NCK_LABEL_MOST, 0, &last);
    if (status != NCK_OK) return status;
    if (!nck_has_word(self, 'P')) return fail_missing(self, 'P');
    if (!nck_has_word(self, 'Q')) return fail_missing(self, 'Q');
    if (first == last) return nck_decode_fail_range(self, 'Q', (double)first);
    self->held.contour.first = (uint64_t)first;
    self->held.contour.last = (uint64_t)last;
    return NCK_OK;
}

static nck_status_t read_levels(nck_decode_t *self) {
    nck_rough_t *const rough = &self->held.rough;
    int64_t depth_nm = rough->depth_nm;
    static const char others[] = "IKR";
    for (unsigned k = 0; k < 3; k++) {
        if (!nck_has_word(self, others[k])) continue;
        return nck_decode_fail_word(self, NCK_E_WORD_UNUSED, others[k], 0.0, 0.0);
    }
    // Fanuc's D counts least increments where it has no point, and who wrote it may have meant
    // lengths.
    if (nck_has_word(self, 'D') && !nck_decode_says_point(self, 'D')) {
        return nck_decode_fail_word(self, NCK_E_CONTOUR, 'D', nck_word_real(self, 'D'), 0.0);
    }
    const nck_status_t status = read_length(self, 'D', 1, &depth_nm);
    if (status != NCK_OK) return status;
    if (depth_nm <= 0) return fail_missing(self, code_of(self) == NCK_MOTION_ROUGH ? 'U' : 'W');
    rough->depth = nck_real_of(depth_nm) / 1e6;
    rough->retract = nck_real_of(rough->retract_nm) / 1e6;
    rough->is_first = 1;
    rough->is_pocket = 1;
    rough->passes = 1;
    return NCK_OK;
}

static nck_status_t read_patterns(nck_decode_t *self) {
    int64_t count = 0;
    if (nck_has_word(self, 'R')) {
        return nck_decode_fail_word(self, NCK_E_WORD_UNUSED, 'R', 0.0, 0.0);
    }
    const nck_status_t status = read_pattern(self, "IKD", &count);
    if (status != NCK_OK) return status;
    if (count < 2) return fail_missing(self, 'R');
    self->held.rough.passes = (uint32_t)count;
    return NCK_OK;
}

static void start_here(nck_decode_t *self) {
    nck_contour_t *const contour = &self->held.contour;
    memcpy(contour->start_nm, self->place.position_nm, sizeof contour->start_nm);
}

// G70: the lines are done; they stand anywhere in the program.
static nck_status_t run_lines(nck_decode_t *self) {
    if (!NCK_HAS_CALLS || !self->macro.reads) {
        return nck_decode_fail_last(self, NCK_E_NO_SEEK, 0.0, 0.0);
    }
    start_here(self);
    const nck_frame_t *const outer = nck_frame_call(self);
    const nck_text_place_t begin = outer != NULL ? outer->begin : (nck_text_place_t){0, 0, 0};
    nck_status_t status = nck_frame_push(self, NCK_FRAME_CONTOUR, self->held.contour.last, 1);
    if (status != NCK_OK) return status;
    self->macro.frame[self->macro.depth - 1].begin = begin;
    nck_contour_begin(self, NCK_CONTOUR_RUNS, NCK_MOTION_FINISH);
    status = nck_seek_number(self, self->held.contour.first);
    return status == NCK_OK ? NCK_EMPTY : status;
}

static nck_status_t read_numbers(nck_decode_t *self) {
    const uint32_t code = code_of(self);
    const uint32_t others = NCK_LETTERS_LINEAR | NCK_LETTERS_CENTRE | NCK_LETTER('D')
                            | NCK_LETTER('R');
    nck_status_t status = read_lines(self);
    if (status != NCK_OK) return status;
    if (code == NCK_MOTION_FINISH) {
        if (!(self->words.letters & others)) return run_lines(self);
        for (char letter = 'D'; letter <= 'W'; letter++) {
            if (!(self->words.letters & others & NCK_LETTER(letter))) continue;
            return nck_decode_fail_word(self, NCK_E_WORD_UNUSED, letter, 0.0, 0.0);
        }
    }
    // U is a diameter where X is one.
    nck_rough_t *const rough = &self->held.rough;
    int64_t u_nm = 0, w_nm = 0;
    status = read_length(self, 'U', any_nm, &u_nm);
    if (status == NCK_OK) status = read_length(self, 'W', any_nm, &w_nm);
    rough->shift_mm[0] = nck_real_of(u_nm) / (self->modal.diameter ? 2e6 : 1e6);
    rough->shift_mm[1] = nck_real_of(w_nm) / 1e6;
    rough->spare = 0.0;
    rough->spare_step = 0.0;
    if (status == NCK_OK) {
        status = code == NCK_MOTION_PATTERN ? read_patterns(self) : read_levels(self);
    }
    if (status != NCK_OK) return status;
    start_here(self);
    nck_contour_begin(self, NCK_CONTOUR_READS, code);
    return NCK_EMPTY;
}

// ---- RS274NGC: the contour is a subprogram

// How far from the contour: D of roughing, D … E in P passes of G70.
static nck_status_t read_distance(nck_decode_t *self) {
    nck_rough_t *const rough = &self->held.rough;
    const int finishes = code_of(self) == NCK_MOTION_FINISH;
    int64_t from_nm = 0, to_nm = 0, passes = 1;
    nck_status_t status = read_length(self, 'D', 0, &from_nm);
    if (status == NCK_OK && finishes) status = read_length(self, 'E', 0, &to_nm);
    if (status == NCK_OK && finishes) status = nck_decode_whole(self, 'P', PASSES_MOST, 1, &passes);
    if (status != NCK_OK) return status;
    if (passes < 1) return nck_decode_fail_range(self, 'P', 1.0);
    rough->passes = (uint32_t)passes;
    rough->spare = nck_real_of(from_nm) / 1e6;
    rough->spare_step = finishes ? nck_real_of(to_nm - from_nm) / 1e6 / (double)passes : 0.0;
    if (finishes) rough->spare += rough->spare_step;
    rough->shift_mm[0] = 0.0;
    rough->shift_mm[1] = 0.0;
    return NCK_OK;
}

// I and R. RS274NGC takes I for 1 if it is not said, which in inches nobody means.
static nck_status_t read_cuts(nck_decode_t *self) {
    nck_rough_t *const rough = &self->held.rough;
    const uint32_t code = code_of(self);
    int64_t depth_nm = DEPTH_NM, retract_nm = NCK_ROUGH_RETRACT_NM;
    if (self->modal.inch && !nck_has_word(self, 'I')) return fail_missing(self, 'I');
    nck_status_t status = read_length(self, 'I', 1, &depth_nm);
    if (status == NCK_OK) status = read_length(self, 'R', 0, &retract_nm);
    rough->depth = nck_real_of(depth_nm) / 1e6;
    rough->retract = nck_real_of(retract_nm) / 1e6;
    rough->is_first = code % 10 != 2;
    rough->is_pocket = code % 10 != 1;
    return status;
}

// X and Z: where the cycle begins.
static nck_status_t read_start(nck_decode_t *self) {
    const nck_status_t status = nck_decode_target(self, 0, self->held.contour.start_nm);
    if (status != NCK_OK) return status;
    const int64_t *const start_nm = self->held.contour.start_nm;
    const nck_status_t x = nck_decode_travel(self, NCK_AXIS_X, start_nm[NCK_AXIS_X]);
    return x == NCK_OK ? nck_decode_travel(self, NCK_AXIS_Z, start_nm[NCK_AXIS_Z]) : x;
}

static nck_status_t call_contour(nck_decode_t *self) {
    int64_t name = 0;
    if (!nck_has_word(self, 'Q')) return fail_missing(self, 'Q');
    nck_status_t status = nck_decode_whole(self, 'Q', NCK_LABEL_MOST, 0, &name);
    if (status == NCK_OK) status = read_distance(self);
    if (status == NCK_OK && code_of(self) != NCK_MOTION_FINISH) status = read_cuts(self);
    if (status == NCK_OK) status = read_start(self);
    if (status == NCK_OK && self->held.rough.spare > 0.0 && !NCK_HAS_COMP) {
        status = nck_decode_fail_word(self, NCK_E_UNSUPPORTED, 'D', nck_word_real(self, 'D'), 0.0);
    }
    if (status != NCK_OK) return status;
    self->held.contour.first = (uint64_t)name;
    self->held.contour.last = (uint64_t)name;
    const uint32_t code = code_of(self);
    status = nck_call(self, NCK_FRAME_SUB, (uint64_t)name, 1);
    if (status != NCK_OK) return status;
    nck_contour_begin(self, NCK_CONTOUR_READS, code);
    self->held.contour.called = self->macro.depth;
    return NCK_EMPTY;
}

// ---- all of them

static nck_status_t check_modes(nck_decode_t *self) {
    const uint32_t behind = NCK_STEP(NCK_STEP_CALL) | NCK_STEP(NCK_STEP_STOP);
    if (self->modal.plane != 18) {
        return nck_decode_fail(self, NCK_E_CONTOUR, 0, 'G', (double)self->modal.plane, 0.0);
    }
    if (self->macro.modal != 0) {
        return nck_decode_fail(self, NCK_E_CONTOUR, 0, 'G', 66.0, 0.0);
    }
    for (unsigned step = NCK_STEP_CALL; step < NCK_STEP_COUNT; step++) {
        if (!(self->words.codes & behind & NCK_STEP(step))) continue;
        return nck_decode_fail_code(self, NCK_E_MODAL_GROUP, (nck_step_t)step);
    }
    return nck_decode_cycle_fits(self);
}

nck_status_t nck_decode_contour_cycle(nck_decode_t *self, nck_block_t *out) {
    if (!NCK_HAS_CONTOUR) return NCK_E_UNSUPPORTED;
    if (self->held.rough.phase != 0) return nck_rough_next(self, out);
    nck_rough_t *const rough = &self->held.rough;
    const uint32_t code = code_of(self);
    nck_status_t status = check_modes(self);
    if (status != NCK_OK) return status;
    if (self->lathe && !nck_has_word(self, 'P') && !nck_has_word(self, 'Q')) {
        return keep_words(self);
    }
    nck_decode_assume(self, NCK_NOTE_UNITS);
    if (!self->lathe) nck_decode_assume(self, NCK_NOTE_DISTANCE);
    if (code != NCK_MOTION_FINISH || !self->lathe) {
        status = nck_decode_cutting_feed(self, 0, &rough->feed);
        if (status != NCK_OK) return status;
    }
    rough->along = code / 10 != NCK_MOTION_FACE_ROUGH / 10;
    rough->sign[0] = 0;
    rough->sign[1] = 0;
    return self->lathe ? read_numbers(self) : call_contour(self);
}
