// SPDX-License-Identifier: MIT
// Room 2, toolcomp: tool offsets, and the door of radius compensation.
#include "nck/prep/2_toolcomp/toolcomp.h"

#include <string.h> // memcpy memset

#include "nck/base/arc_math.h"         // nck_plane_axis
#include "nck/base/real.h"             // nck_fabs nck_real_of
#include "nck/prep/2_toolcomp/parts.h" // nck_comp_…

void nck_toolcomp_init(nck_toolcomp_t *self, const nck_machine_t *machine) {
    memset(self, 0, sizeof *self);
    self->machine = machine;
    self->enters = machine->dialect.from_line != 0;
}

void nck_toolcomp_move(const nck_toolcomp_t *self, nck_block_t *block) {
    if (block->kind > NCK_BLOCK_ARC && block->kind < NCK_BLOCK_THREAD) return;
    for (unsigned k = 0; k < 2 && block->kind == NCK_BLOCK_ARC; k++) {
        block->centre_mm[k] += nck_comp_mm(block->tool_nm[nck_plane_axis(block->plane, k)]);
    }
    for (int x = NCK_AXIS_X; x <= NCK_AXIS_Z; x++) {
        if (self->machine->axis[x].present) block->target_nm[x] += block->tool_nm[x];
        block->tool_nm[x] = 0;
    }
}

// ---- radius compensation

// While the tool is away, moves outside of the plane leave it there; the first one in the plane
// takes it to a programmed point, and must be straight. NCK_EMPTY: that one is taken.
static nck_status_t stay_away(nck_toolcomp_t *self, nck_block_t *block) {
    const int moves = block->kind <= NCK_BLOCK_ARC || block->kind == NCK_BLOCK_ENTRY;
    if (!self->away || !moves) return NCK_OK;
    if (block->kind == NCK_BLOCK_ARC) {
        self->away = 0;
        self->error = (nck_diagnostic_t){NCK_E_COMP_EXIT, block->line, 0, 0, 0.0, 0.0};
        return NCK_E_COMP_EXIT;
    }
    const uint8_t *const axis = self->axis;
    for (unsigned k = 0; k < 2; k++) {
        if (block->target_nm[axis[k]] != self->reached_nm[axis[k]]) self->away = 0;
    }
    if (!self->away) return block->kind == NCK_BLOCK_ENTRY ? NCK_OK : nck_comp_leave(self, block);
    for (unsigned k = 0; k < 2; k++) block->target_nm[axis[k]] = self->given_nm[axis[k]];
    memcpy(self->given_nm, block->target_nm, sizeof self->given_nm);
    return NCK_OK;
}

static void switch_on(nck_toolcomp_t *self, const nck_block_t *block) {
    const double radius = block->output.value;
    for (unsigned k = 0; k < NCK_AXIS_MAX; k++) self->reached_nm[k] = block->target_nm[k];
    if (!self->away) memcpy(self->given_nm, self->reached_nm, sizeof self->given_nm);
    memset(&self->last, 0, sizeof self->last);
    self->last.from = self->ring.head;
    self->phase = NCK_COMP_ENTERS;
    self->away = 0;
    self->start = (uint8_t)block->output.number;
    self->plane = block->plane;
    self->radius = nck_fabs(radius);
    self->side = radius < 0.0 ? -1.0 : 1.0;
    for (unsigned k = 0; k < 2; k++) {
        self->axis[k] = (uint8_t)nck_plane_axis(block->plane, k);
        self->nose[k] = block->centre_mm[k];
        self->at[k] = nck_comp_mm(self->given_nm[self->axis[k]]) - self->nose[k];
    }
}

// G41 or G42 while the tool is beside a contour. What is in force already says nothing, another
// radius on the same side is no change of sides; for a change the contour ends here.
static nck_status_t change_side(nck_toolcomp_t *self, const nck_block_t *block) {
    const double radius = self->side * self->radius;
    if (block->output.value == radius) return NCK_EMPTY;
    if (block->output.value * radius > 0.0) {
        const double code = radius > 0.0 ? 41.0 : 42.0;
        const nck_status_t status = nck_comp_fail(self, NCK_E_COMP_ON, block->line, code, 0.0);
        self->error.letter = 'G';
        return status;
    }
    self->closed = 1;
    return nck_comp_take(self, block);
}

// A block of the tool's path, on its way out of the room. NCK_EMPTY: it is before where the program
// begins.
static nck_status_t leave(nck_toolcomp_t *self, nck_block_t *block) {
    const int enters = self->enters;
    if (block->kind != NCK_BLOCK_ENTRY) return enters ? NCK_EMPTY : NCK_OK;
    self->enters = 0;
    return nck_comp_way_in(self, block);
}

nck_status_t nck_toolcomp_take(nck_toolcomp_t *self, nck_block_t *block) {
    if (!NCK_HAS_COMP) return leave(self, block);
    if (block->kind == NCK_BLOCK_COMP) {
        if (block->output.value == 0.0) self->closed = self->phase != NCK_COMP_OFF;
        else if (NCK_HAS_FOREIGN && self->phase != NCK_COMP_OFF) return change_side(self, block);
        else switch_on(self, block);
        return NCK_EMPTY;
    }
    if (self->phase == NCK_COMP_OFF) {
        const nck_status_t status = stay_away(self, block);
        return status == NCK_OK ? leave(self, block) : status;
    }
    return nck_comp_take(self, block);
}

void nck_toolcomp_end(nck_toolcomp_t *self) {
    self->closed = self->phase != NCK_COMP_OFF;
}

// The entry at the tail: a block without contour is given, the next piece of a contour is opened.
static nck_status_t begin_entry(nck_toolcomp_t *self, nck_block_t *out) {
    nck_comp_entry_t *const entry = nck_comp_at(self, self->ring.tail);
    const unsigned part = self->walk.part;
    if (NCK_HAS_FOREIGN && entry->block.kind == NCK_BLOCK_COMP) {
        // All before the change is given: the tool goes from beside the contour's end to its other
        // side.
        const nck_block_t block = entry->block;
        const double tangent[2] = {self->last.tangent[0], self->last.tangent[1]};
        nck_comp_off(self);
        const int beside = self->away;
        switch_on(self, &block);
        if (beside) nck_comp_cross(self, &block, tangent);
        return NCK_EMPTY;
    }
    if (part == NCK_COMP_PARTS || !entry->moves) {
        self->ring.tail++;
        self->walk.part = 0;
        if (entry->moves) return NCK_EMPTY;
        nck_comp_give_along(self, &entry->block, out);
        return NCK_OK;
    }
    if (entry->crosses && nck_comp_next(self, self->ring.tail) == self->ring.head) {
        entry->on[part] = 0; // no contour follows on the other side
    }
    if (entry->on[part]) {
        nck_comp_piece(self, self->ring.tail, (nck_comp_part_t)part, &self->walk.piece);
        self->walk.along = entry->path[part].from;
        self->walk.until = entry->path[part].to;
        self->walk.open = 1;
        self->walk.planned = entry->leaves;
    }
    self->walk.part++;
    return NCK_EMPTY;
}

// The next entry, or a stretch of the piece in work. NCK_EMPTY: nothing to give yet.
static nck_status_t step(nck_toolcomp_t *self, nck_block_t *out) {
    if (!self->walk.open) return begin_entry(self, out);
    nck_status_t status = NCK_OK;
    if (!self->walk.planned) {
        const int enters = nck_comp_at(self, self->walk.piece.of)->enters;
        self->walk.planned = 1;
        status = nck_comp_hold(self);
        if (status == NCK_OK) status = nck_comp_judge(self);
        if (status == NCK_OK) status = enters ? nck_comp_way_to(self) : nck_comp_keep_off(self);
    }
    if (status == NCK_OK) status = nck_comp_give(self, out);
    if (!(self->walk.along < self->walk.until)) self->walk.open = 0;
    return status;
}

nck_status_t nck_toolcomp_pull(nck_toolcomp_t *self, nck_block_t *block_out) {
    if (!NCK_HAS_COMP) return NCK_EMPTY;
    const uint32_t waiting = self->ring.head - self->ring.tail;
    if (!self->closed && waiting < NCK_COMP_ROWS) return NCK_EMPTY;
    const uint8_t closed = self->closed; // behind a change of sides no more is all there is
    while (self->ring.tail != self->ring.head && self->closed == closed) {
        nck_status_t status = step(self, block_out);
        if (status == NCK_OK) status = leave(self, block_out);
        if (status != NCK_EMPTY) return status;
    }
    if (self->closed) nck_comp_off(self);
    return NCK_EMPTY;
}

nck_status_t nck_toolcomp_diagnostic(nck_toolcomp_t *self, nck_diagnostic_t *diagnostic_out) {
    nck_diagnostic_t *found = &self->error;
    if (self->note.left.code != 0) found = &self->note.left;
    if (self->note.way.code != 0) found = &self->note.way;
    if (found->code == 0) return NCK_EMPTY;
    *diagnostic_out = *found;
    found->code = 0;
    return NCK_OK;
}

int nck_toolcomp_invariants(const nck_toolcomp_t *self) {
    const uint32_t waiting = self->ring.head - self->ring.tail;
    return waiting <= NCK_COMP_ROWS && self->phase <= NCK_COMP_LEAVES
           && (self->phase != NCK_COMP_OFF || (waiting == 0 && !self->walk.open))
           && (self->phase == NCK_COMP_OFF || self->radius > 0.0);
}
