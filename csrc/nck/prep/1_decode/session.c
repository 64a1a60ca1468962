// SPDX-License-Identifier: MIT
// A session: how it begins, what it is told between lines, and what of it is dropped. decode.c has
// what it makes of a line.
#include "nck/prep/1_decode/decode.h"
#include "nck/prep/1_decode/parts.h"
#include "nck/prep/1_decode/state/state.h" // nck_spline_break
#include "nck/prep/1_decode/macro/macro.h" // nck_parameter_set_probe

#include <string.h> // memcpy memset

void nck_session_go_back(nck_decode_t *self) {
    const uint8_t complete = self->text.complete; // may have come meanwhile
    if (self->session.phase == NCK_SESSION_NOT) return;
    *self = *self->session.before;
    self->text.complete = complete;
}

nck_status_t nck_decode_lend(nck_decode_t *self, nck_decode_t *before) {
    const int begun = self->line.number > 0 || self->text.begun || !nck_decode_is_empty(self);
    if (begun || self->macro.reads) return NCK_E_STATE;
    self->session.before = before;
    return NCK_OK;
}

nck_status_t nck_decode_leave_nothing(nck_decode_t *self) {
    if (!self->session.before || !nck_decode_is_empty(self)) return NCK_E_STATE;
    self->session.passes = 1;
    self->text.quick = 0; // its modes are to be kept
    return NCK_OK;
}

nck_status_t nck_decode_probed(nck_decode_t *self, const int64_t *at_nm) {
    int64_t stands_nm[NCK_AXIS_MAX];
    if (!NCK_HAS_CYCLES) return NCK_E_UNSUPPORTED;
    memcpy(stands_nm, self->place.position_nm, sizeof stands_nm);
    if (at_nm) memcpy(self->place.position_nm, at_nm, sizeof stands_nm);
    const nck_status_t status = nck_parameter_set_probe(self, at_nm != NULL);
    memcpy(self->place.position_nm, stands_nm, sizeof stands_nm);
    return status;
}

void nck_decode_name_line(nck_decode_t *self, uint32_t name) { self->line.number = name - 1; }

void nck_decode_drop(nck_decode_t *self) {
    nck_session_go_back(self);
    memset(&self->line, 0, sizeof self->line);
    self->words.steps = 0;
    nck_spline_break(self);
    self->session.phase = NCK_SESSION_NOT;
    self->session.passes = 0;
    self->held.contour.mode = NCK_CONTOUR_NOT;
    self->macro.seek.kind = NCK_SEEK_NOT;
    self->finding.count = 0;
    self->text.complete = 0;
    self->text.closed = NCK_CLOSED_NOT;
    self->text.over = 0;
    self->text.watch = 0;
    self->text.quick = 0;
}
