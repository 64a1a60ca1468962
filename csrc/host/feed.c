// SPDX-License-Identifier: MIT
// Cells of a whole program's plan, their sums, and the way to the tick.
#include "host/feed.h"

#include <string.h> // memset

#include "nck/prep/5_slope/slope.h" // nck_slope_terms

void nck_host_feed_cells(nck_host_feed_t *self, nck_cell_t *cells_out, size_t max,
                         size_t *count_out) {
    size_t count = 0;
    while (count < max && self->next(self->walk, &cells_out[count])) count++;
    *count_out = count;
}

void nck_host_feed_totals(nck_host_feed_t *self, nck_host_totals_t *totals_out) {
    const uint32_t first = self->seg_count > 0 ? self->segs[0].seq : 0;
    nck_terms_t terms;
    nck_cell_t cell;
    double since_stop_s = 0.0;
    nck_slope_terms(self->machine, &terms);
    memset(totals_out, 0, sizeof *totals_out);
    totals_out->segs = self->seg_count;
    while (self->next(self->walk, &cell)) {
        const nck_seg_t *const seg = &self->segs[cell.seg - first];
        const double extra_s = nck_host_totals_add(totals_out, &since_stop_s, &cell, seg->rapid,
                                                   self->machine->period_s, terms.taps - 1u);
        totals_out->limit_s[cell.limit] += cell.duration + extra_s;
        totals_out->length_mm = seg->s_begin + seg->length;
    }
}

// Segs and outputs, in order, as long as there is room for them.
static void push_path(nck_host_feed_t *self) {
    nck_link_t *const link = nck_link_of(self->nck);
    while (nck_link_has_room(link)) {
        const nck_output_t *const output = &self->outputs[self->outputs_pushed];
        const int more = self->outputs_pushed < self->output_count;
        if (more && output->after_segs <= self->segs_pushed) {
            (void)nck_link_push_output(link, output);
            self->outputs_pushed++;
            continue;
        }
        if (self->segs_pushed == self->seg_count) return;
        (void)nck_link_push_seg(link, &self->segs[self->segs_pushed]);
        self->segs_pushed++;
    }
}

// Cells of segs that have been pushed. Returns how many.
static uint32_t push_cells(nck_host_feed_t *self) {
    nck_link_t *const link = nck_link_of(self->nck);
    uint32_t count = 0;
    while (nck_link_cell_room(link) > 0) {
        if (!self->has_cell) {
            self->has_cell = (uint32_t)self->next(self->walk, &self->cell);
            self->ended = !self->has_cell;
        }
        if (!self->has_cell || self->cell.seg >= self->segs_pushed) return count;
        nck_link_push_cell(link, &self->cell);
        self->has_cell = 0;
        count++;
    }
    return count;
}

nck_status_t nck_host_feed_prep(void *user) {
    nck_host_feed_t *const self = user;
    nck_link_t *const link = nck_link_of(self->nck);
    push_path(self);
    (void)nck_link_batch_begin(link);
    nck_link_tail_begin(link);
    const uint32_t count = push_cells(self);
    if (count > 0 && nck_link_publish(link) != NCK_OK) return NCK_E_INTERNAL;
    const int path_done = self->segs_pushed == self->seg_count
                          && self->outputs_pushed == self->output_count;
    if (self->ended && path_done) return NCK_DONE;
    return count > 0 ? NCK_OK : NCK_FULL;
}
