// SPDX-License-Identifier: MIT
// Rooms 3 and 4 of a plan by themselves: the wires of the kernel up to its window of nodes.
#include "host/early.h"

#include <string.h> // memset

#include "nck/prep/5_slope/slope.h" // nck_slope_terms

enum {
    STEPS_PER_BLOCK = 2 // of the look-ahead, as in the kernel
};

nck_status_t nck_host_early_init(nck_host_early_t *self, const nck_machine_t *machine) {
    const nck_status_t status = nck_machine_check(machine);
    if (status != NCK_OK) return status;
    memset(self, 0, sizeof *self);
    self->machine = *machine;
    nck_slope_terms(&self->machine, &self->terms);
    nck_toolcomp_init(&self->toolcomp, &self->machine);
    nck_smooth_init(&self->smooth, &self->terms);
    nck_lookahead_init(&self->lookahead, &self->terms);
    return NCK_OK;
}

void nck_host_early_give(nck_host_early_t *self, const nck_block_t *blocks, size_t n) {
    self->blocks = blocks;
    self->block_count = n;
    self->block_used = 0;
    self->has_all = n == 0;
}

static void note(nck_host_batch_t *batch, uint8_t what) {
    batch->orders[batch->order_count] = what;
    batch->order_count++;
}

// One step of the look-ahead; the nodes that it has placed leave the window at once.
static nck_status_t look_ahead(nck_host_early_t *self) {
    nck_lookahead_t *const lookahead = &self->lookahead;
    nck_host_batch_t *const batch = self->batch;
    const nck_status_t status = nck_lookahead_step(lookahead);
    const uint32_t fill = nck_lookahead_fill(lookahead);
    for (uint32_t i = 0; i < fill; i++) {
        batch->nodes[batch->node_count] = *nck_lookahead_ahead(lookahead, i);
        batch->node_count++;
        note(batch, NCK_HOST_BATCH_NODE);
    }
    nck_lookahead_drop(lookahead, fill);
    return status;
}

static nck_status_t push_seg(nck_host_early_t *self, const nck_seg_t *seg) {
    nck_host_batch_t *const batch = self->batch;
    nck_host_batch_seg_t *const row = &batch->segs[batch->seg_count];
    if (nck_lookahead_push(&self->lookahead, seg) != NCK_OK) return NCK_E_STATE;
    nck_host_why_row(&row->why, self->tangent, seg, &self->terms);
    row->length_mm = seg->s_begin + seg->length;
    row->seq = seg->seq;
    row->block = seg->block;
    row->rapid = seg->rapid;
    row->kind = seg->kind;
    if (row->kind == NCK_SEG_SPLINE) {
        batch->wholes[batch->whole_count] = *seg;
        batch->whole_count++;
    }
    batch->seg_count++;
    note(batch, NCK_HOST_BATCH_SEG);
    return NCK_OK;
}

static nck_status_t push_item(nck_host_early_t *self, const nck_smooth_item_t *item) {
    nck_host_batch_t *const batch = self->batch;
    if (item->is_output) {
        batch->outputs[batch->output_count] = item->output;
        batch->output_count++;
        note(batch, NCK_HOST_BATCH_OUTPUT);
        return NCK_OK;
    }
    return push_seg(self, &item->seg);
}

// One item out of smooth, or a step towards it. NCK_EMPTY: it needs a block.
static nck_status_t carry_item(nck_host_early_t *self) {
    nck_smooth_item_t item;
    if (!nck_lookahead_has_room(&self->lookahead)) return NCK_E_STATE;
    if (nck_smooth_is_hungry(&self->smooth)) return NCK_EMPTY;
    const nck_status_t status = nck_smooth_pull(&self->smooth, &item);
    if (status == NCK_OK) return push_item(self, &item);
    if (status == NCK_DONE) {
        self->ended = 1;
        nck_lookahead_end(&self->lookahead);
    }
    return status == NCK_FULL || status == NCK_DONE ? NCK_OK : status;
}

// A block that waits in smooth: the path marks its line.
static nck_status_t push_block(nck_host_early_t *self, const nck_block_t *block) {
    nck_host_batch_t *const batch = self->batch;
    const double before = self->smooth.known;
    const nck_status_t status = nck_smooth_push(&self->smooth, block, self->block_seq);
    if (!(self->smooth.known > before)) return status;
    const nck_mark_t mark = {self->smooth.known, block->line, block->modes};
    batch->marks[batch->mark_count] = mark;
    batch->mark_count++;
    note(batch, NCK_HOST_BATCH_MARK);
    return status;
}

static nck_status_t smooth_block(nck_host_early_t *self, const nck_block_t *block) {
    const nck_status_t status = nck_smooth_pass(&self->smooth, block, self->block_seq, &self->seg);
    if (status == NCK_FULL) return push_block(self, block);
    if (status == NCK_EMPTY) return NCK_OK;
    return status == NCK_OK ? push_seg(self, &self->seg) : status;
}

// One block into smooth, and the first item of it. A program error ends the path where it stands.
static nck_status_t carry_block(nck_host_early_t *self) {
    nck_block_t block = self->blocks[self->block_used];
    self->block_used++;
    nck_toolcomp_place(&self->toolcomp, &block);
    const nck_status_t status = smooth_block(self, &block);
    self->block_seq++;
    if (status == NCK_E_STATE) return status;
    if (status < NCK_OK) self->error = status;
    if (status < NCK_OK || block.kind == NCK_BLOCK_END) nck_smooth_end(&self->smooth);
    if (status < NCK_OK || nck_smooth_is_hungry(&self->smooth)) return NCK_OK;
    const nck_status_t first = carry_item(self);
    return first < NCK_OK ? first : NCK_OK;
}

// … ─▶ smooth ─▶ lookahead, one item, or one block and the first item of it.
static nck_status_t take_input(nck_host_early_t *self) {
    if (self->ended) return NCK_DONE;
    const nck_status_t carried = carry_item(self);
    if (carried != NCK_EMPTY) return carried;
    if (self->block_used < self->block_count) return carry_block(self);
    if (!self->has_all) return NCK_EMPTY;
    nck_smooth_end(&self->smooth);
    return NCK_OK;
}

// What the kernel does in one step, where room 5 has nothing to do.
static nck_status_t step(nck_host_early_t *self) {
    if (!nck_lookahead_is_idle(&self->lookahead) && look_ahead(self) == NCK_OK) return NCK_OK;
    const nck_status_t status = take_input(self);
    if (status != NCK_OK) return status;
    for (int n = 0; n < STEPS_PER_BLOCK; n++) {
        (void)look_ahead(self);
        if (nck_lookahead_is_idle(&self->lookahead)) break;
    }
    return NCK_OK;
}

// The path may end in a step: room 5 is told as soon as the last node is placed.
static nck_status_t step_and_note(nck_host_early_t *self) {
    const nck_status_t status = step(self);
    if (status != NCK_OK) return status;
    if (self->ended && !self->settled && nck_lookahead_is_settled(&self->lookahead)) {
        self->settled = 1;
        note(self->batch, NCK_HOST_BATCH_END);
    }
    note(self->batch, NCK_HOST_BATCH_STEP);
    return NCK_OK;
}

static int has_room(const nck_host_batch_t *batch) {
    return batch->seg_max - batch->seg_count >= NCK_HOST_BATCH_ROOM
           && batch->whole_max - batch->whole_count >= NCK_HOST_BATCH_ROOM
           && batch->node_max - batch->node_count >= NCK_HOST_BATCH_ROOM
           && batch->output_max - batch->output_count >= NCK_HOST_BATCH_ROOM
           && batch->mark_max - batch->mark_count >= NCK_HOST_BATCH_ROOM
           && batch->order_max - batch->order_count >= NCK_HOST_BATCH_ROOM;
}

static void begin(nck_host_batch_t *batch) {
    batch->seg_count = 0;
    batch->whole_count = 0;
    batch->node_count = 0;
    batch->output_count = 0;
    batch->mark_count = 0;
    batch->order_count = 0;
}

nck_status_t nck_host_early_run(nck_host_early_t *self, nck_host_batch_t *batch, int anew) {
    nck_status_t status = NCK_OK;
    if (anew) begin(batch);
    self->batch = batch;
    while (status == NCK_OK && has_room(batch)) status = step_and_note(self);
    batch->blocks = self->block_seq;
    batch->error = self->error;
    return status;
}
