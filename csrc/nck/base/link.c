// SPDX-License-Identifier: MIT
// The link between the asynchronous and the synchronous rooms.
#include "nck/base/link.h"

#include <assert.h> // assert
#include <stddef.h> // offsetof
#include <string.h> // memset

#include "nck/base/real.h"      // NCK_APART nck_max

enum {
    ENTERED = NCK_LINK_ENTERED, PARITY = NCK_LINK_PARITY, HAS_TAIL = 4,
    END_SHIFT = NCK_LINK_END_SHIFT, END_MASK = NCK_LINK_COUNT_MASK
};

static uint32_t end_of(uint32_t word) { return word >> END_SHIFT; }

static uint32_t cells_between(uint32_t taken, uint32_t end) { return (end - taken) & END_MASK; }

void nck_link_init(nck_link_t *self) {
    nck_link_renew(self);
    self->owner = NCK_LINK_BOTH;
}

void nck_link_ask(nck_link_t *self) { nck_fence_store(&self->owner, NCK_LINK_ASKED); }

// What lies in the rings counts for nothing.
void nck_link_renew(nck_link_t *self) {
    memset(&self->word, 0, offsetof(nck_link_t, cell) - offsetof(nck_link_t, word));
    self->marks.head = 0;
    self->marks.tail = 0;
}

void nck_link_give_back(nck_link_t *self) { nck_fence_store(&self->owner, NCK_LINK_BOTH); }

void nck_link_yield(nck_link_t *self) { nck_fence_store(&self->owner, NCK_LINK_PREP); }

int nck_link_is_spent(const nck_link_t *self) {
    const uint32_t word = nck_fence_load(&self->word);
    const int rested = nck_fence_load(&self->tail_rested) == end_of(word) + 1;
    return cells_between(nck_fence_load(&self->taken), end_of(word)) == 0
           && (!(word & HAS_TAIL) || ((word & ENTERED) && rested));
}

uint32_t nck_link_cell_room(const nck_link_t *self) {
    const uint32_t end = end_of(nck_fence_load(&self->word));
    const uint32_t used = cells_between(nck_fence_load(&self->taken), end) + self->batch;
    return NCK_CELL_MAX - used;
}

// What the seg ring has written over is done, however far the tick is: marks depend on the path
// alone.
void nck_link_push_mark(nck_link_t *self, const nck_mark_t *mark) {
    const int goes_round = self->seg_head >= NCK_SEG_MAX;
    nck_marks_push(&self->marks, goes_round ? nck_link_seg_place(self)->marks.from : 0, mark);
}

nck_status_t nck_link_push_seg(nck_link_t *self, const nck_seg_t *seg) {
    if (self->seg_head - nck_fence_load(&self->seg_done) >= NCK_SEG_MAX) return NCK_FULL;
    nck_seg_t *const place = nck_link_seg_place(self);
    *place = *seg;
    nck_link_seg_placed(self, place);
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

void nck_link_break(nck_link_t *self, const nck_cell_t *cell) {
    if (self->broken) return;
    self->broken = 1;
    self->broken_line = nck_link_seg(self, cell->seg)->line;
}

void nck_link_push_cell(nck_link_t *self, const nck_cell_t *cell) {
    assert(nck_link_cell_room(self) > 0);
    nck_link_inspect(self, cell);
    self->cell[(end_of(self->base) + self->batch) & (NCK_CELL_MAX - 1)] = *cell;
    self->batch++;
}

// The tail in use belongs to the other parity, so this one is prep's alone.
static uint32_t next_parity(const nck_link_t *self) { return 1u - nck_link_parity(self->base); }

void nck_link_tail_begin(nck_link_t *self) {
    const uint32_t parity = next_parity(self);
    self->tail_fill = 0;
    self->tail_at = self->tail[parity].cell;
    self->tail_entered = nck_fence_load(&self->word) & ENTERED;
    self->tail_origin[parity] = (end_of(self->base) + self->batch) & END_MASK;
}

void nck_link_tail_grow(nck_link_t *self, uint32_t count) {
    const nck_cell_t *const cell = nck_link_tail_room(self);
    assert(count <= NCK_TAIL_MAX - self->tail_fill);
    for (uint32_t i = 0; i < count; i++) nck_link_inspect(self, &cell[i]);
    self->tail_fill += count;
    self->tail_at += count;
}

void nck_link_tail_push(nck_link_t *self, const nck_cell_t *cell) {
    nck_cell_t *const room = nck_link_tail_room(self);
    *room = *cell;
    nck_link_tail_placed(self, room);
}

NCK_APART nck_link_spare_t *nck_link_spare(nck_link_t *self) {
    return &self->tail[next_parity(self)].spare;
}

nck_status_t nck_link_publish(nck_link_t *self) {
    const uint32_t parity = next_parity(self);
    const uint32_t end = end_of(self->base);
    if (self->broken) return NCK_E_INTERNAL;
    if ((self->base & ENTERED) && nck_fence_load(&self->tail_rested) != end + 1) return NCK_FULL;
    self->tail_count[parity] = self->tail_fill;
    const uint32_t word = ((end + self->batch) & END_MASK) << END_SHIFT
                          | (self->tail_fill ? HAS_TAIL : 0u) | parity * PARITY;
    if (!nck_fence_exchange(&self->word, self->base, word)) return NCK_E_STATE;
    (void)nck_link_batch_begin(self);
    return NCK_OK;
}

// The time of cells that the tick has taken no longer counts. When all are taken nothing is left of
// it, neither by rounding nor of an exchange that failed: the tick was in the tail then. Cells go
// only to places that were free before: what stood there is counted.
static double lead_of(nck_link_t *self) {
    const uint32_t taken = nck_fence_load(&self->taken);
    double lead_s = self->lead_s;
    for (uint32_t seen = self->lead_seen; seen != taken; seen = (seen + 1) & END_MASK) {
        lead_s -= self->cell[seen & (NCK_CELL_MAX - 1)].duration;
    }
    self->lead_seen = taken;
    self->lead_s = taken == end_of(nck_fence_load(&self->word)) ? 0.0 : lead_s;
    return self->lead_s;
}

// Copy the cells from place `first` of a tail on behind the batch, as far as room, lead and most
// allow. Returns how many.
static uint32_t copy_ahead(nck_link_t *self, uint32_t parity, uint32_t first, uint32_t room,
                           double lead, uint32_t most) {
    const uint32_t left = self->tail_count[parity] - first;
    const uint32_t fits = room < left ? room : left;
    const uint32_t limit = fits < most ? fits : most;
    const nck_cell_t *const cell = &self->tail[parity].cell[first];
    const uint32_t begin = end_of(self->base) + self->batch;
    double lead_s = self->lead_s;
    uint32_t count = 0;
    for (; count < limit && lead_s < lead; count++) {
        lead_s += cell[count].duration;
        self->cell[(begin + count) & (NCK_CELL_MAX - 1)] = cell[count];
    }
    self->lead_s = lead_s;
    self->batch += count;
    return count;
}

double nck_link_lead(nck_link_t *self) { return lead_of(self); }

nck_status_t nck_link_install(nck_link_t *self, double lead, uint32_t most) {
    const uint32_t parity = next_parity(self);
    const uint32_t fill = self->tail_fill;
    if (self->broken) return NCK_E_INTERNAL;
    (void)nck_link_batch_begin(self);
    const uint32_t end = end_of(self->base);
    self->tail_fill = fill;
    // A plan made before the tick entered the tail begins where the path no longer passes.
    if ((self->base & ENTERED) != self->tail_entered) return NCK_E_STATE;
    const int entered = self->tail_entered != 0;
    if (entered && nck_fence_load(&self->tail_rested) != end + 1) return NCK_FULL;
    const uint32_t room = nck_link_cell_room(self);
    self->tail_count[parity] = fill;
    self->tail_origin[parity] = end;
    const double least = lead_of(self) + self->tail[parity].cell[0].duration;
    const uint32_t count = copy_ahead(self, parity, 0, room, nck_max(lead, least), most);
    if (count == 0) return NCK_FULL;
    const uint32_t word = ((end + count) & END_MASK) << END_SHIFT
                          | (count < fill ? HAS_TAIL : 0u) | parity * PARITY;
    const int done = nck_fence_exchange(&self->word, self->base, word);
    (void)nck_link_batch_begin(self);
    return done ? NCK_OK : NCK_E_STATE;
}

nck_status_t nck_link_advance(nck_link_t *self, double lead, uint32_t most) {
    const uint32_t fill = self->tail_fill;
    const int entered = nck_link_batch_begin(self);
    const uint32_t room = nck_link_cell_room(self);
    (void)lead_of(self);
    self->tail_fill = fill;
    if (self->lead_s >= lead) return entered ? NCK_E_STATE : NCK_FULL;
    const uint32_t parity = nck_link_parity(self->base);
    const uint32_t end = end_of(self->base);
    const uint32_t first = cells_between(self->tail_origin[parity], end);
    const int copies = !entered && (self->base & HAS_TAIL);
    const uint32_t count = copies ? copy_ahead(self, parity, first, room, lead, most) : 0;
    const uint32_t left = self->tail_count[parity] - first;
    const uint32_t word = ((end + count) & END_MASK) << END_SHIFT
                          | (count < left ? HAS_TAIL : 0u) | parity * PARITY;
    nck_status_t status = entered ? NCK_E_STATE : NCK_FULL;
    if (count > 0) {
        status = nck_fence_exchange(&self->word, self->base, word) ? NCK_OK : NCK_E_STATE;
    }
    (void)nck_link_batch_begin(self);
    self->tail_fill = fill;
    return status;
}

uint32_t nck_link_broken_line(const nck_link_t *self) { return self->broken_line; }

uint32_t nck_link_finished(const nck_link_t *self) { return nck_fence_load(&self->seg_done); }

const nck_cell_t *nck_link_tail_cell(const nck_link_t *self, uint32_t count) {
    const uint32_t parity = nck_link_parity(nck_fence_load(&self->word));
    const uint32_t place = cells_between(self->tail_origin[parity], count);
    if (place >= self->tail_count[parity]) return (const nck_cell_t *)0;
    return &self->tail[parity].cell[place];
}

const nck_cell_t *nck_link_built_cell(const nck_link_t *self, uint32_t i) {
    return i < self->tail_fill ? &self->tail[next_parity(self)].cell[i] : (const nck_cell_t *)0;
}

const nck_cell_t *nck_link_tail_end(const nck_link_t *self, uint32_t *count_out) {
    const uint32_t word = nck_fence_load(&self->word);
    const uint32_t parity = nck_link_parity(word);
    *count_out = (word & HAS_TAIL) ? self->tail_count[parity] : 0;
    return *count_out ? &self->tail[parity].cell[*count_out - 1] : (const nck_cell_t *)0;
}

static nck_status_t take_from_tail(nck_link_t *self, uint32_t word, nck_cell_t *cell_out) {
    const uint32_t parity = nck_link_parity(word);
    // At rest: prep may be writing both tails.
    if (self->tail_rested == end_of(word) + 1) return NCK_EMPTY;
    if (self->tail_taken >= self->tail_count[parity]) return NCK_EMPTY;
    *cell_out = self->tail[parity].cell[self->tail_taken];
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
            nck_link_take_final(self, cell_out);
            return NCK_OK;
        }
        if (!(word & HAS_TAIL)) return NCK_EMPTY;
        *from_tail_out = 1;
        if (word & ENTERED) return take_from_tail(self, word, cell_out);
        if (nck_fence_exchange(&self->word, word, word | ENTERED)) {
            const uint32_t origin = self->tail_origin[nck_link_parity(word)];
            self->tail_taken = cells_between(origin, end_of(word));
            return take_from_tail(self, word | ENTERED, cell_out);
        }
    }
    return NCK_EMPTY;
}

const nck_cell_t *nck_link_ahead(const nck_link_t *self, uint32_t word, uint32_t n) {
    const uint32_t parity = nck_link_parity(word);
    const uint32_t waiting = cells_between(self->taken, end_of(word));
    if (n < waiting) return &self->cell[(self->taken + n) & (NCK_CELL_MAX - 1)];
    const uint32_t first = word & ENTERED ? self->tail_taken
                                          : cells_between(self->tail_origin[parity], end_of(word));
    const uint32_t place = first + n - waiting;
    if (!(word & HAS_TAIL) || place >= self->tail_count[parity]) return (const nck_cell_t *)0;
    return &self->tail[parity].cell[place];
}

void nck_link_tail_rest(nck_link_t *self) {
    const uint32_t end = end_of(nck_fence_load(&self->word));
    nck_fence_store(&self->tail_rested, end + 1);
}

NCK_APART const nck_seg_t *nck_link_seg(const nck_link_t *self, uint32_t seq) {
    return &self->seg[seq & (NCK_SEG_MAX - 1)];
}

nck_status_t nck_link_take_output(nck_link_t *self, nck_output_t *output_out) {
    if (!nck_link_has_output(self)) return NCK_EMPTY;
    *output_out = self->output[self->output_taken & (NCK_OUTPUT_MAX - 1)];
    nck_fence_store(&self->output_taken, self->output_taken + 1);
    return NCK_OK;
}

int nck_link_is_empty(const nck_link_t *self) {
    return nck_link_waiting(self) == 0 && nck_fence_load(&self->output_head) == self->output_taken;
}
