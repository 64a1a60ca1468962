// SPDX-License-Identifier: MIT
// The link between the asynchronous and the synchronous rooms.
#include "nck/base/link.h"

#include <string.h> // memset

enum { ENTERED = 1, PARITY = 2, HAS_TAIL = 4, END_SHIFT = 3, END_MASK = 0x1fffffff };

static uint32_t end_of(uint32_t word) { return word >> END_SHIFT; }

static uint32_t parity_of(uint32_t word) { return (word & PARITY) ? 1u : 0u; }

// Counters of cells run modulo 2²⁹, the width of the end in the word.
static uint32_t cells_between(uint32_t taken, uint32_t end) { return (end - taken) & END_MASK; }

void nck_link_init(nck_link_t *self) { memset(self, 0, sizeof *self); }

uint32_t nck_link_cell_room(const nck_link_t *self) {
    const uint32_t end = end_of(nck_fence_load(&self->word));
    const uint32_t used = cells_between(nck_fence_load(&self->taken), end) + self->batch;
    return NCK_CELL_MAX - used;
}

int nck_link_has_room(const nck_link_t *self) {
    return self->seg_head - nck_fence_load(&self->seg_done) < NCK_SEG_MAX
           && self->output_head - nck_fence_load(&self->output_taken) < NCK_OUTPUT_MAX;
}

nck_status_t nck_link_push_seg(nck_link_t *self, const nck_seg_t *seg) {
    if (self->seg_head - nck_fence_load(&self->seg_done) >= NCK_SEG_MAX) return NCK_FULL;
    self->seg[self->seg_head & (NCK_SEG_MAX - 1)] = *seg;
    nck_fence_store(&self->seg_head, self->seg_head + 1);
    return NCK_OK;
}

nck_status_t nck_link_push_output(nck_link_t *self, const nck_output_t *output) {
    if (self->output_head - nck_fence_load(&self->output_taken) >= NCK_OUTPUT_MAX) return NCK_FULL;
    self->output[self->output_head & (NCK_OUTPUT_MAX - 1)] = *output;
    nck_fence_store(&self->output_head, self->output_head + 1);
    return NCK_OK;
}

int nck_link_batch_begin(nck_link_t *self) {
    self->base = nck_fence_load(&self->word);
    self->batch = 0;
    self->tail_fill = 0;
    return (self->base & ENTERED) != 0;
}

void nck_link_push_cell(nck_link_t *self, const nck_cell_t *cell) {
    self->cell[(end_of(self->base) + self->batch) & (NCK_CELL_MAX - 1)] = *cell;
    self->batch++;
}

// The tail in use belongs to the other parity, so this one is prep's alone.
static uint32_t next_parity(const nck_link_t *self) { return 1u - parity_of(self->base); }

void nck_link_tail_begin(nck_link_t *self) { self->tail_fill = 0; }

void nck_link_tail_push(nck_link_t *self, const nck_cell_t *cell) {
    self->tail[next_parity(self)][self->tail_fill] = *cell;
    self->tail_fill++;
}

nck_status_t nck_link_publish(nck_link_t *self) {
    const uint32_t parity = next_parity(self);
    const uint32_t end = end_of(self->base);
    if ((self->base & ENTERED) && nck_fence_load(&self->tail_rested) != end + 1) return NCK_FULL;
    self->tail_count[parity] = self->tail_fill;
    const uint32_t word = ((end + self->batch) & END_MASK) << END_SHIFT
                          | (self->tail_fill ? HAS_TAIL : 0u) | parity * PARITY;
    if (!nck_fence_exchange(&self->word, self->base, word)) return NCK_E_STATE;
    (void)nck_link_batch_begin(self);
    return NCK_OK;
}

const nck_cell_t *nck_link_tail_end(const nck_link_t *self, uint32_t *count_out) {
    const uint32_t word = nck_fence_load(&self->word);
    const uint32_t parity = parity_of(word);
    *count_out = (word & HAS_TAIL) ? self->tail_count[parity] : 0;
    return *count_out ? &self->tail[parity][*count_out - 1] : (const nck_cell_t *)0;
}

static nck_status_t take_from_tail(nck_link_t *self, uint32_t word, nck_cell_t *cell_out) {
    const uint32_t parity = parity_of(word);
    if (self->tail_taken >= self->tail_count[parity]) return NCK_EMPTY;
    *cell_out = self->tail[parity][self->tail_taken];
    self->tail_taken++;
    return NCK_OK;
}

// Two rounds are enough: the word can change under the tick only by a publication, and then there
// are final cells to take.
nck_status_t nck_link_take(nck_link_t *self, nck_cell_t *cell_out, int *from_tail_out) {
    for (int round = 0; round < 2; round++) {
        const uint32_t word = nck_fence_load(&self->word);
        *from_tail_out = 0;
        if (cells_between(self->taken, end_of(word)) > 0) {
            *cell_out = self->cell[self->taken & (NCK_CELL_MAX - 1)];
            self->tail_taken = 0;
            nck_fence_store(&self->taken, (self->taken + 1) & END_MASK);
            return NCK_OK;
        }
        if (!(word & HAS_TAIL)) return NCK_EMPTY;
        *from_tail_out = 1;
        if (word & ENTERED) return take_from_tail(self, word, cell_out);
        if (nck_fence_exchange(&self->word, word, word | ENTERED)) {
            self->tail_taken = 0;
            return take_from_tail(self, word | ENTERED, cell_out);
        }
    }
    return NCK_EMPTY;
}

void nck_link_tail_rest(nck_link_t *self) {
    const uint32_t end = end_of(nck_fence_load(&self->word));
    nck_fence_store(&self->tail_rested, end + 1);
}

void nck_link_seg_finish(nck_link_t *self, uint32_t seq) {
    if (seq != self->seg_done) nck_fence_store(&self->seg_done, seq);
}

const nck_seg_t *nck_link_seg(const nck_link_t *self, uint32_t seq) {
    return &self->seg[seq & (NCK_SEG_MAX - 1)];
}

nck_status_t nck_link_take_output(nck_link_t *self, nck_output_t *output_out) {
    const uint32_t head = nck_fence_load(&self->output_head);
    if (self->output_taken == head) return NCK_EMPTY;
    const nck_output_t *const output = &self->output[self->output_taken & (NCK_OUTPUT_MAX - 1)];
    if ((int32_t)(self->seg_done - output->after_segs) < 0) return NCK_EMPTY;
    *output_out = *output;
    nck_fence_store(&self->output_taken, self->output_taken + 1);
    return NCK_OK;
}

uint32_t nck_link_waiting(const nck_link_t *self) {
    return cells_between(self->taken, end_of(nck_fence_load(&self->word)));
}

int nck_link_is_empty(const nck_link_t *self) {
    return nck_link_waiting(self) == 0 && nck_fence_load(&self->output_head) == self->output_taken;
}
