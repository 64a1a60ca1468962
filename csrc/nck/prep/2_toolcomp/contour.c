// SPDX-License-Identifier: MIT
// The contour: blocks as lines and arcs of the plane, in a ring.
#include "nck/prep/2_toolcomp/parts.h"

#include <assert.h> // assert
#include <string.h> // memcpy memset

// What the first move, and an arc, must be. NCK_EMPTY: it is good.
static nck_status_t check(nck_toolcomp_t *self, const nck_comp_entry_t *entry) {
    const nck_shape_t *const contour = &entry->contour;
    const int bends = contour->radius > 0.0;
    nck_shape_t beside;
    if (!entry->enters) {
        if (nck_shape_parallel(contour, self->side * self->radius, &beside)) return NCK_EMPTY;
        return nck_comp_fail(self, NCK_E_COMP_RADIUS, entry->block.line, self->radius,
                             contour->radius);
    }
    const double size = bends ? contour->radius : contour->length;
    const int is_fanuc = self->start > NCK_COMP_START_RS274; // straight, as short as it may be
    const int fits = is_fanuc ? !bends
                              : size > self->radius && nck_comp_enter(self, contour, &beside);
    if (fits) return NCK_EMPTY;
    (void)nck_comp_fail(self, NCK_E_COMP_ENTRY, entry->block.line, size, self->radius);
    if (is_fanuc) self->error.letter = 'G';
    return NCK_E_COMP_ENTRY;
}

// The path is led along the newest contour. What is done with cannot be cut short for it any more.
static nck_status_t follow(nck_toolcomp_t *self, nck_comp_entry_t *entry) {
    const int done = nck_comp_is_given(self, self->last.count);
    // Does it go on from where the contour before ends? What is done with does, and what is on the
    // path, which only a contour behind it cuts short; before the first move nothing is led.
    const int follows = !entry->enters
                        && (done || nck_comp_at(self, self->last.count)->on[NCK_COMP_BESIDE]);
    memcpy(entry->tangent, self->last.tangent, sizeof entry->tangent);
    if (entry->enters) nck_shape_tangent(&entry->contour, entry->contour.length, entry->tangent);
    if (!entry->enters && done && !entry->rapid && !self->last.rapid) {
        double ahead[2];
        nck_shape_tangent(&entry->contour, 0.0, ahead);
        const double dip = nck_comp_dip(self, nck_comp_turn(self, entry->tangent, ahead));
        const uint32_t line = self->last.line;
        if (dip > NCK_COMP_CLOSE) {
            return nck_comp_fail(self, NCK_E_COMP_GOUGE, line, dip, (double)entry->block.line);
        }
    }
    nck_comp_join(self, self->ring.head, follows);
    const nck_shape_t *const contour = &entry->contour;
    const int first = !entry->enters && self->last.begins == 0;
    entry->clear = first && self->last.rapid;
    if (first) {
        self->last.begins = entry->block.line;
        memcpy(self->last.first, contour->p, sizeof self->last.first);
        self->last.height = entry->height;
        nck_shape_tangent(contour, 0.0, self->last.ahead);
    }
    nck_shape_tangent(contour, contour->length, self->last.tangent);
    self->last.count = self->ring.head;
    self->last.line = entry->block.line;
    self->last.rapid = entry->rapid;
    return NCK_EMPTY;
}

// The block as an entry of the ring's head.
static nck_comp_entry_t *read_entry(nck_toolcomp_t *self, const nck_block_t *block) {
    nck_comp_entry_t *const entry = nck_comp_at(self, self->ring.head);
    memset(entry, 0, sizeof *entry);
    entry->block = *block;
    entry->s = self->s;
    entry->rapid = block->kind == NCK_BLOCK_RAPID;
    if (block->kind > NCK_BLOCK_ARC) return entry;
    double p[2];
    double q[2];
    for (unsigned k = 0; k < 2; k++) {
        p[k] = nck_comp_mm(self->reached_nm[self->axis[k]]);
        q[k] = nck_comp_mm(block->target_nm[self->axis[k]]);
    }
    if (block->kind == NCK_BLOCK_ARC) {
        nck_shape_arc(p, q, block->centre_mm, block->sweep_rad, &entry->contour);
    } else {
        nck_shape_line(p, q, &entry->contour);
    }
    entry->height = nck_comp_height(self, self->reached_nm);
    entry->moves = entry->contour.length > 0.0;
    memcpy(self->reached_nm, block->target_nm, sizeof self->reached_nm);
    return entry;
}

// The move behind G40 goes straight from where the tool stands.
static nck_status_t go_straight(nck_toolcomp_t *self, const nck_block_t *block) {
    nck_comp_stretch_t way;
    double to[2];
    for (unsigned k = 0; k < 2; k++) {
        to[k] = nck_comp_mm(block->target_nm[self->axis[k]]) - self->nose[k];
    }
    nck_shape_line(self->at, to, &way.shape);
    way.height[0] = nck_comp_height(self, self->given_nm);
    way.height[1] = nck_comp_height(self, block->target_nm);
    return nck_comp_way_from(self, block, &way, 1);
}

nck_status_t nck_comp_leave(nck_toolcomp_t *self, const nck_block_t *block) {
    if (self->start != NCK_COMP_START_B) return go_straight(self, block);
    nck_comp_entry_t *const entry = read_entry(self, block);
    double onward[2];
    entry->height = nck_comp_height(self, self->given_nm); // there may be moves along Z between
    nck_shape_tangent(&entry->contour, 0.0, onward);
    const double turn = nck_comp_turn(self, self->last.tangent, onward);
    if (!(self->radius * turn > NCK_COMP_SHORT)) return go_straight(self, block);
    memcpy(entry->tangent, self->last.tangent, sizeof entry->tangent);
    // Or by way of an arc about the contour's end.
    nck_comp_stretch_t way[NCK_COMP_PARTS];
    entry->leaves = 1;
    for (int part = 0; part < NCK_COMP_PARTS; part++) {
        nck_comp_piece_t piece;
        nck_comp_piece(self, self->ring.head, (nck_comp_part_t)part, &piece);
        entry->path[part] = (nck_comp_span_t){0.0, piece.shape.length};
        entry->on[part] = 1;
        nck_comp_stretch(self, &piece, &way[part]);
    }
    const nck_status_t status = nck_comp_way_from(self, &entry->block, way, NCK_COMP_PARTS);
    if (status != NCK_OK) return status;
    self->ring.head++;
    self->phase = NCK_COMP_LEAVES;
    self->closed = 1;
    return NCK_EMPTY;
}

void nck_comp_cross(nck_toolcomp_t *self, const nck_block_t *block, const double *tangent) {
    nck_block_t move = *block;
    move.kind = block->feed > 0.0 ? NCK_BLOCK_LINE : NCK_BLOCK_RAPID;
    nck_comp_entry_t *const entry = read_entry(self, &move);
    entry->moves = 1;
    entry->enters = 1;
    entry->crosses = 1;
    memcpy(entry->tangent, tangent, sizeof entry->tangent);
    memcpy(self->last.tangent, tangent, sizeof self->last.tangent);
    nck_comp_join(self, self->ring.head, 0);
    self->last.count = self->ring.head;
    self->last.line = block->line;
    self->last.rapid = entry->rapid;
    self->phase = NCK_COMP_ON;
    self->ring.head++;
}

nck_status_t nck_comp_take(nck_toolcomp_t *self, const nck_block_t *block) {
    nck_comp_entry_t *const entry = read_entry(self, block);
    nck_status_t status = NCK_EMPTY;
    entry->enters = entry->moves && self->phase == NCK_COMP_ENTERS;
    if (entry->moves) {
        status = check(self, entry);
        if (status == NCK_EMPTY) status = follow(self, entry);
        if (status != NCK_EMPTY) return status;
        self->phase = NCK_COMP_ON;
        self->s += entry->contour.length;
        entry->anew = (uint8_t)nck_comp_is_anew(self, self->ring.head);
    }
    self->ring.head++;
    assert(self->ring.head - self->ring.tail <= NCK_COMP_ROWS);
    return status;
}
