// SPDX-License-Identifier: MIT
// The contour: blocks as lines and arcs of the plane, in a ring, and where they meet themselves.
#include "nck/prep/2_toolcomp/parts.h"

#include <assert.h> // assert
#include <stddef.h> // NULL
#include <string.h> // memcpy

#include "nck/base/arc_math.h" // nck_arc_norm
#include "nck/base/real.h"     // nck_fabs

#define TOUCH 1e-3 // [mm] the contour meets itself

// Does a new contour end on an older one? Where that meets an older one still, that one counts.
static int ends_on(const nck_comp_entry_t *old, nck_comp_entry_t *entry) {
    if (!(nck_shape_distance(&old->contour, entry->contour.q) < TOUCH)) return 0;
    const double place = old->s + nck_shape_along(&old->contour, entry->contour.q);
    const int again = old->met >= 0.0 && nck_fabs(place - old->met_at) < TOUCH;
    entry->met = again ? old->met : place;
    entry->met_at = entry->s + entry->contour.length;
    return 1;
}

// A whole turn.
static int ends_on_itself(nck_comp_entry_t *entry) {
    const nck_shape_t *const contour = &entry->contour;
    const double way[2] = {contour->q[0] - contour->p[0], contour->q[1] - contour->p[1]};
    if (!(contour->radius > 0.0) || !(nck_arc_norm(way[0], way[1]) < TOUCH)) return 0;
    entry->met = entry->s;
    entry->met_at = entry->s + contour->length;
    return 1;
}

static int crosses(const nck_comp_entry_t *old, nck_comp_entry_t *entry) {
    nck_meeting_t crossing[2];
    if (nck_shape_cross(&old->contour, &entry->contour, crossing) == 0) return 0;
    entry->met = old->s + crossing[0].on_a;
    entry->met_at = entry->s + crossing[0].on_b;
    return 1;
}

// Look for an older contour that the new one meets. The one just before it meets it anyway.
static int meets_any(nck_toolcomp_t *self, nck_comp_entry_t *entry,
                     int (*meets)(const nck_comp_entry_t *old, nck_comp_entry_t *entry)) {
    const nck_comp_entry_t *before = NULL;
    for (uint32_t count = self->ring.tail; count != self->ring.head; count++) {
        const nck_comp_entry_t *const old = nck_comp_at(self, count);
        if (!old->moves) continue;
        if (before != NULL && meets(before, entry)) return 1;
        before = old;
    }
    return 0;
}

// An end counts before a crossing: where the contour is run through again, every end is on it.
static void find_meeting(nck_toolcomp_t *self, nck_comp_entry_t *entry) {
    if (meets_any(self, entry, ends_on) || ends_on_itself(entry)) return;
    (void)meets_any(self, entry, crosses);
}

// What the first contour, and an arc, must be. 1: it is good.
static nck_status_t check(nck_toolcomp_t *self, const nck_comp_entry_t *entry) {
    const nck_shape_t *const contour = &entry->contour;
    const uint32_t line = entry->block.line;
    nck_comp_piece_t piece;
    nck_shape_t beside;
    if (!entry->enters) {
        if (nck_shape_parallel(contour, self->side * self->radius, &beside)) return NCK_EMPTY;
        return nck_comp_fail(self, NCK_E_COMP_RADIUS, line, self->radius, contour->radius);
    }
    const double size = contour->radius > 0.0 ? contour->radius : contour->length;
    if (size > self->radius && nck_comp_enter(self, contour, &piece.shape)) return NCK_EMPTY;
    return nck_comp_fail(self, NCK_E_COMP_ENTRY, line, size, self->radius);
}

static void read_contour(nck_toolcomp_t *self, nck_comp_entry_t *entry) {
    const nck_block_t *const block = &entry->block;
    double p[2];
    double q[2];
    for (unsigned k = 0; k < 2; k++) {
        p[k] = (double)self->reached_nm[self->axis[k]] * 1e-6;
        q[k] = (double)block->target_nm[self->axis[k]] * 1e-6;
    }
    if (block->kind == NCK_BLOCK_ARC) {
        nck_shape_arc(p, q, block->centre_mm, block->sweep_rad, &entry->contour);
    } else {
        nck_shape_line(p, q, &entry->contour);
    }
    memcpy(self->reached_nm, block->target_nm, sizeof self->reached_nm);
}

nck_status_t nck_comp_take(nck_toolcomp_t *self, const nck_block_t *block) {
    nck_comp_entry_t *const entry = nck_comp_at(self, self->ring.head);
    nck_status_t status = NCK_EMPTY;
    entry->block = *block;
    entry->s = self->s;
    entry->met = -1.0;
    entry->rapid = block->kind == NCK_BLOCK_RAPID;
    entry->contour.length = 0.0;
    if (block->kind <= NCK_BLOCK_ARC) read_contour(self, entry);
    entry->moves = entry->contour.length > 0.0;
    entry->enters = entry->moves && self->phase == NCK_COMP_ENTERS;
    if (entry->moves) {
        status = check(self, entry);
        if (status != NCK_EMPTY) return status;
        self->phase = NCK_COMP_ON;
        self->s += entry->contour.length;
        find_meeting(self, entry);
    }
    self->ring.head++;
    assert(self->ring.head - self->ring.tail <= NCK_COMP_ROWS);
    return status;
}
