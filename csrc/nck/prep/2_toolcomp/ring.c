// SPDX-License-Identifier: MIT
// The ring of blocks that wait, and what is known of them all.
#include "nck/prep/2_toolcomp/parts.h"

#include <stddef.h> // NULL

#include "nck/base/real.h" // nck_fabs nck_min

#define NEAR 4.0 // radii of contour: what lies so close together is always one contour

nck_comp_entry_t *nck_comp_at(nck_toolcomp_t *self, uint32_t count) {
    return &self->ring.at[count & (NCK_COMP_ROWS - 1)];
}

uint32_t nck_comp_oldest(const nck_toolcomp_t *self) {
    const uint32_t taken = self->ring.head - self->ring.first;
    return taken > NCK_COMP_ROWS ? self->ring.head - NCK_COMP_ROWS : self->ring.first;
}

// The tool stays where it is until a move of the plane takes it to a programmed point.
void nck_comp_off(nck_toolcomp_t *self) {
    self->away = self->phase == NCK_COMP_ON;
    self->phase = NCK_COMP_OFF;
    self->closed = 0;
    self->walk.open = 0;
    self->walk.corner = 0;
    self->ring.tail = self->ring.head;
}

nck_status_t nck_comp_fail(nck_toolcomp_t *self, nck_status_t code, uint32_t line, double value,
                           double limit) {
    self->error = (nck_diagnostic_t){code, line, 0, 0, value, limit};
    nck_comp_off(self);
    return code;
}

uint32_t nck_comp_next(nck_toolcomp_t *self, uint32_t count) {
    do count++; while (count != self->ring.head && !nck_comp_at(self, count)->moves);
    return count;
}

// The place where the contour meets itself nearest to another; NULL: nowhere.
static const nck_comp_entry_t *nearest_meeting(nck_toolcomp_t *self, double s) {
    const nck_comp_entry_t *found = NULL;
    for (uint32_t count = nck_comp_oldest(self); count != self->ring.head; count++) {
        const nck_comp_entry_t *const entry = nck_comp_at(self, count);
        if (!entry->moves || entry->met < 0.0) continue;
        if (found == NULL || nck_fabs(s - entry->met_at) < nck_fabs(s - found->met_at)) {
            found = entry;
        }
    }
    return found;
}

// Is there a meeting between two places that are not near to one another?
static int parts(const nck_toolcomp_t *self, const nck_comp_entry_t *entry, double s_from,
                 double s_to) {
    const int far = s_to - s_from > NEAR * self->radius;
    return far && entry->met_at > s_from && entry->met_at <= s_to;
}

int nck_comp_relates(nck_toolcomp_t *self, double s_from, double s_to) {
    const nck_comp_entry_t *const from = nearest_meeting(self, s_from);
    if (from == NULL) return 1;
    const double gap = nck_fabs(s_from - from->met_at);
    for (uint32_t count = nck_comp_oldest(self); count != self->ring.head; count++) {
        const nck_comp_entry_t *const entry = nck_comp_at(self, count);
        if (!entry->moves || entry->met < 0.0) continue;
        const double direct = nck_fabs(s_from - entry->met);
        const double other = nck_min(direct, gap + nck_fabs(from->met - entry->met));
        const double around = other + nck_fabs(s_to - entry->met_at);
        if (parts(self, entry, s_from, s_to) || 2.0 * around < s_to - s_from) return 0;
    }
    return 1;
}
