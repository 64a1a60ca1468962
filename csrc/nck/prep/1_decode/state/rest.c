// SPDX-License-Identifier: MIT
// What is left: of a line when a block of it has been given, of a spline that is not ended.
#include "nck/prep/1_decode/state/state.h"
#include "nck/base/real.h" // NCK_APART

NCK_APART void nck_decode_leave(nck_decode_t *self, nck_rest_t rest) {
    self->words.rest = (uint8_t)rest;
    self->words.steps |= NCK_STEP(NCK_STEP_REST);
}

void nck_spline_begins(nck_decode_t *self) {
    self->held.spline.line = self->line.tag;
    self->held.spline.column = self->words.code_column[NCK_STEP_MOTION];
}

int nck_spline_waits(const nck_decode_t *self) {
    return NCK_HAS_CONTOUR && self->held.spline.points != 0 && !self->held.spline.works;
}

NCK_APART nck_status_t nck_spline_refuses(nck_decode_t *self, nck_step_t step) {
    if (!NCK_HAS_CONTOUR) return NCK_OK;
    const int32_t code = self->words.code[step];
    const int said = (self->words.codes & NCK_STEP(NCK_STEP_MOTION)) != 0;
    const int goes_on = code == NCK_MOTION_NURBS || code == NCK_MOTION_NURBS_END
                        || (code == NCK_MOTION_KNOTS && !said);
    if (code != NCK_MOTION_CUBIC) self->held.spline.follows = 0;
    if (!nck_spline_waits(self) || goes_on) return NCK_OK;
    return nck_decode_fail_step(self, NCK_E_SPLINE, step, 'G', self->modal.motion / 10.0, 0.0);
}

void nck_spline_break(nck_decode_t *self) {
    if (!nck_spline_waits(self)) return;
    self->held.spline.points = 0;
    self->modal.motion = NCK_MOTION_REFUSED;
}

nck_status_t nck_spline_missing(nck_decode_t *self) {
    const nck_spline_t *const spline = &self->held.spline;
    self->text.over = 1;
    self->line.tag = spline->line;
    return nck_decode_fail(self, NCK_E_SPLINE, spline->column, 'M', self->modal.motion / 10.0, 0.0);
}

int nck_decode_skips(const nck_decode_t *self, const char **at) {
    unsigned number = 1; // of a / alone
    do ++*at; while (**at == ' ' || **at == '\t');
    if (**at >= '1' && **at <= '9') {
        number = (unsigned)(**at - '0');
        ++*at;
    }
    const uint32_t on = self->machine->dialect.skip_switches;
    return self->machine->dialect.block_skip || (on >> number & 1u);
}
