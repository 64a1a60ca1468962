// SPDX-License-Identifier: MIT
// Codes that choose how a control smooths or looks ahead: Fanuc's G5 G5.1 G8, Haas' G103 G187,
// G61.1 G62 G63. The machine's file says what they mean here; what it does not say is noted. And
// G codes that no language but the machine's file has.
#include "nck/prep/1_decode/tongue/parts.h"
#include "nck/prep/1_decode/state/state.h" // nck_decode_fail_code nck_decode_fail_missing …
#include "nck/prep/1_decode/number/number.h" // nck_decode_length_word nck_decode_letter …
#include "nck/base/real.h" // nck_real_of

#include <stddef.h> // NULL

enum { G5 = 50, G5_1 = 51, G8 = 80, G10_9 = 109, G61_1 = 611, G64 = 640, G187 = 1870 };

// 1 if the entry's word stands in the line.
static int is_said(const nck_decode_t *self, const nck_own_g_t *own) {
    int64_t value = -1;
    if (!nck_has_word(self, own->letter)) return 0;
    return nck_number_whole(&self->words.number[own->letter - 'A'], 0, &value)
           && value == (int64_t)own->value;
}

int nck_decode_has_own_g(const nck_decode_t *self, int64_t tenths) {
    if (!NCK_HAS_FOREIGN) return 0;
    const nck_machine_t *const machine = self->machine;
    for (uint32_t k = 0; k < machine->own_g_count; k++) {
        if (machine->own_g[k].code == tenths) return 1;
    }
    return 0;
}

// The machine's entry for the code and a word of the line, else that for the code alone.
static const nck_own_g_t *find(const nck_decode_t *self, uint32_t tenths) {
    const nck_machine_t *const machine = self->machine;
    const nck_own_g_t *plain = NULL;
    for (uint32_t k = 0; k < machine->own_g_count; k++) {
        const nck_own_g_t *const own = &machine->own_g[k];
        if (own->code != tenths) continue;
        if (own->letter == 0) plain = own;
        else if (is_said(self, own)) return own;
    }
    return plain;
}

// The tolerance of a path that no G64 P says one of, from now on.
static void set_tolerance(nck_decode_t *self, double tolerance) {
    self->modal.plain_mm = tolerance;
    if (self->modal.path_mode != NCK_PATH_CONTINUOUS) return;
    self->modal.tolerance_mm = nck_decode_plain_mm(self);
    self->modal.merge_mm = self->modal.tolerance_mm;
}

static void explain(nck_decode_t *self, nck_step_t step, uint32_t tenths, int is_end) {
    const nck_own_g_t *const own = find(self, tenths);
    if (own != NULL && own->action == NCK_G_TOLERANCE) set_tolerance(self, own->tolerance);
    else if (is_end) set_tolerance(self, NCK_PLAIN_OPEN);
    if (own != NULL ? own->action != NCK_G_NOTE : is_end) return;
    // Once for each code: no two of a language share a bit.
    const uint32_t bit = 1u << (tenths + tenths / 2u) % 32u;
    if (self->finding.modes & bit) return;
    self->finding.modes |= bit;
    self->finding.notes &= ~(1u << NCK_NOTE_MODE);
    nck_decode_note_code(self, NCK_NOTE_MODE, step, tenths / 10.0);
}

// E of G187: how far a corner may be rounded.
static nck_status_t read_rounding(nck_decode_t *self) {
    int64_t value_nm = 0;
    const nck_status_t status = nck_decode_length_word(self, 'E', &value_nm);
    if (status != NCK_OK) return status;
    const double value = nck_real_of(value_nm) / (double)NCK_COUNTS_PER_MM;
    if (value_nm < 0) return nck_decode_fail_word(self, NCK_E_NUMBER_RANGE, 'E', value, 0.0);
    set_tolerance(self, value);
    return NCK_EMPTY;
}

// G5 G5.1 G8 G103 G187.
static nck_status_t choose(nck_decode_t *self, uint32_t tenths) {
    // The word by which the code says what it begins, 0: it needs none.
    const int letter = tenths == G5_1 ? 'Q' : tenths == G5 || tenths == G8 ? 'P' : 0;
    int64_t value = 0;
    nck_status_t status = NCK_OK;
    if (tenths == G187 && nck_has_word(self, 'E')) return read_rounding(self);
    if (letter != 0 && !nck_has_word(self, letter)) {
        return nck_decode_fail_missing(self, NCK_STEP_PATH, letter);
    }
    if (letter != 0) {
        status = nck_decode_whole(self, (char)letter, NCK_DECODE_VALUE_MAX, 0, &value);
    }
    if (status != NCK_OK) return status;
    explain(self, NCK_STEP_PATH, tenths, letter != 0 ? value == 0 : !nck_has_word(self, 'P'));
    return NCK_EMPTY;
}

nck_status_t nck_decode_mode(nck_decode_t *self) {
    if (!NCK_HAS_FOREIGN) return nck_decode_fail_code(self, NCK_E_UNSUPPORTED, NCK_STEP_PATH);
    const uint32_t tenths = self->words.code[NCK_STEP_PATH];
    if (tenths >= G61_1 && tenths < G64) {
        // G61.1 G62 G63: they end G61.
        self->modal.path_mode = NCK_PATH_CONTINUOUS;
        set_tolerance(self, self->modal.plain_mm);
        explain(self, NCK_STEP_PATH, tenths, 0);
        return NCK_EMPTY;
    }
    // Axis words beside such a code would be no move on a control, and what they are goes by it.
    for (unsigned axis = 0; axis < NCK_AXIS_MAX; axis++) {
        if (!(self->words.axes >> axis & 1u)) continue;
        return nck_decode_fail_word(self, NCK_E_WORD_UNUSED, nck_decode_letter(axis), 0.0, 0.0);
    }
    return tenths == G10_9 ? NCK_EMPTY : choose(self, tenths); // G10.9 names no axis to switch
}

void nck_decode_own_mode(nck_decode_t *self) {
    if (!NCK_HAS_FOREIGN) return;
    const int printer = self->tongue == NCK_TONGUE_MARLIN;
    if (printer && nck_has_word(self, 'P')) return; // G10 P S: how hot a tool is to be
    explain(self, NCK_STEP_OWN, self->words.code[NCK_STEP_OWN] - NCK_CODE_OWN_G, 0);
}
