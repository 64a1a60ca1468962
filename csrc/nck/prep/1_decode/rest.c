// SPDX-License-Identifier: MIT
// What is left: of a line when a block of it has been given, of a spline that is not ended.
#include "nck/prep/1_decode/parts.h"

void nck_decode_leave(nck_decode_t *self, nck_rest_t rest) {
    self->words.rest = (uint8_t)rest;
    self->words.steps |= NCK_STEP(NCK_STEP_REST);
}

nck_status_t nck_spline_refuses(nck_decode_t *self, int32_t code) {
    nck_spline_t *const spline = &self->held.spline;
    const int said = (self->words.codes & NCK_STEP(NCK_STEP_MOTION)) != 0;
    const int goes_on = code == NCK_MOTION_NURBS || code == NCK_MOTION_NURBS_END
                        || (code == NCK_MOTION_KNOTS && !said);
    if (code != NCK_MOTION_CUBIC) spline->follows = 0;
    if (!NCK_HAS_CONTOUR || spline->points == 0 || goes_on) return NCK_OK;
    spline->points = 0;
    return nck_decode_fail(self, NCK_E_SPLINE, said ? self->words.code_column[NCK_STEP_MOTION] : 0,
                           'G', self->modal.motion / 10.0, 0.0);
}
