// SPDX-License-Identifier: MIT
// The ring of blocks that wait, and the path through them.
#include "nck/prep/2_toolcomp/parts.h"

#include "nck/base/real.h" // NCK_APART nck_real_of

NCK_APART nck_comp_entry_t *nck_comp_at(nck_toolcomp_t *self, uint32_t count) {
    return &self->ring.at[count & (NCK_COMP_ROWS - 1)];
}

// The tool stays where it is until a move of the plane takes it to a programmed point.
void nck_comp_off(nck_toolcomp_t *self) {
    self->away = self->phase == NCK_COMP_ON;
    self->phase = NCK_COMP_OFF;
    self->closed = 0;
    self->walk.open = 0;
    self->walk.part = 0;
    self->ring.tail = self->ring.head;
}

NCK_APART double nck_comp_mm(int64_t nm) { return nck_real_of(nm) * 1e-6; }

NCK_APART nck_status_t nck_comp_fail(nck_toolcomp_t *self, nck_status_t code, uint32_t line,
                                     double value, double limit) {
    self->error = (nck_diagnostic_t){code, line, 0, 0, value, limit};
    self->last.from = self->ring.head;
    nck_comp_off(self);
    return code;
}

int nck_comp_is_given(const nck_toolcomp_t *self, uint32_t count) {
    if (count - self->ring.tail >= self->ring.head - self->ring.tail) return 1;
    return count == self->ring.tail && self->walk.part == NCK_COMP_PARTS;
}

uint32_t nck_comp_next(nck_toolcomp_t *self, uint32_t count) {
    do count++; while (count != self->ring.head && !nck_comp_at(self, count)->moves);
    return count;
}
