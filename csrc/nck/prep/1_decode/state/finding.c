// SPDX-License-Identifier: MIT
// What is found in the text: the error of a line, and the queue of what is to be told.
#include "nck/prep/1_decode/state/state.h"

#include "nck/base/real.h" // NCK_APART

NCK_APART nck_status_t nck_decode_fail(nck_decode_t *self, nck_status_t code, unsigned column,
                                       int letter, double value, double limit) {
    self->finding.error = (nck_diagnostic_t){code, self->line.tag, column, letter, value, limit};
    return code;
}

nck_status_t nck_decode_fail_at(nck_decode_t *self, nck_status_t code, const char *at, int letter,
                                double value, double limit) {
    const unsigned column = (unsigned)(at - self->line.text) + 1;
    return nck_decode_fail(self, code, column, letter, value, limit);
}

nck_status_t nck_decode_fail_word(nck_decode_t *self, nck_status_t code, int letter, double value,
                                  double limit) {
    const int said = nck_has_word(self, letter); // not by a pushed block
    const unsigned column = said ? self->words.column[letter - 'A'] : 0;
    const int written = column > 0 ? self->line.text[column - 1] & ~0x20 : letter; // U may be X
    return nck_decode_fail(self, code, column, written, value, limit);
}

nck_status_t nck_decode_fail_step(nck_decode_t *self, nck_status_t code, nck_step_t step,
                                  int letter, double value, double limit) {
    const int said = (self->words.codes & NCK_STEP(step)) != 0;
    return nck_decode_fail(self, code, said ? self->words.code_column[step] : 0, letter, value,
                           limit);
}

nck_status_t nck_decode_fail_code(nck_decode_t *self, nck_status_t code, nck_step_t step) {
    const uint32_t m = NCK_STEP(NCK_STEP_PORT) | NCK_STEP(NCK_STEP_CHANGE)
                       | NCK_STEP(NCK_STEP_SPINDLE) | NCK_STEP(NCK_STEP_STATE)
                       | NCK_STEP(NCK_STEP_MIST) | NCK_STEP(NCK_STEP_FLOOD)
                       | NCK_STEP(NCK_STEP_OVERRIDE) | NCK_STEP(NCK_STEP_OWN)
                       | NCK_STEP(NCK_STEP_CALL) | NCK_STEP(NCK_STEP_STOP);
    const uint16_t tenths = self->words.code[step];
    const int own_g = step == NCK_STEP_OWN && tenths >= NCK_CODE_OWN_G;
    const int is_g = own_g || (step == NCK_STEP_CALL && tenths < 970); // G65 G66 G67; M97 …
    return nck_decode_fail_step(self, code, step, !is_g && (m & NCK_STEP(step)) ? 'M' : 'G',
                                (own_g ? tenths - NCK_CODE_OWN_G : tenths) / 10.0, 0.0);
}

nck_status_t nck_decode_fail_missing(nck_decode_t *self, nck_step_t step, int letter) {
    return nck_decode_fail_step(self, NCK_E_WORD_MISSING, step, letter, 0.0, 0.0);
}

nck_status_t nck_decode_only(nck_decode_t *self, const char *at, uint32_t whose) {
    if (self->tongue & whose) return NCK_OK;
    return nck_decode_fail_at(self, NCK_E_OTHER_BASE, at, 0, 0.0, (double)whose);
}

void nck_decode_find(nck_decode_t *self, const nck_diagnostic_t *finding) {
    if (self->finding.count >= NCK_DECODE_FINDINGS) {
        self->finding.lost++;
        return;
    }
    self->finding.queue[self->finding.count++] = *finding;
}

void nck_decode_note(nck_decode_t *self, const nck_diagnostic_t *finding) {
    const uint32_t note = 1u << finding->code;
    if ((self->finding.given | self->finding.notes) & note) return;
    self->finding.notes |= note;
    nck_decode_find(self, finding);
}

void nck_decode_assume(nck_decode_t *self, nck_note_t note) {
    const nck_diagnostic_t finding = {(int32_t)note, self->line.tag, 0, 0, 0.0, 0.0};
    nck_decode_note(self, &finding);
}

void nck_decode_assume_places(nck_decode_t *self) {
    nck_decode_assume(self, NCK_NOTE_UNITS);
    nck_decode_assume(self, NCK_NOTE_DISTANCE);
}

void nck_decode_note_word(nck_decode_t *self, nck_note_t note, char letter, double value) {
    const int said = nck_has_word(self, letter);
    const unsigned column = said ? self->words.column[letter - 'A'] : 0;
    const nck_diagnostic_t finding = {(int32_t)note, self->line.tag, column, letter, value, 0.0};
    nck_decode_note(self, &finding);
}

void nck_decode_note_code(nck_decode_t *self, nck_note_t note, nck_step_t step, double code) {
    const unsigned column = self->words.code_column[step];
    const nck_diagnostic_t finding = {(int32_t)note, self->line.tag, column, 'G', code, 0.0};
    nck_decode_note(self, &finding);
}
