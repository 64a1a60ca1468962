// SPDX-License-Identifier: MIT
// What always holds of the link.
#include "nck/base/link_invariants.h"

#include "nck/base/cell_math.h" // nck_cell_speed
#include "nck/base/real.h"      // nck_fabs

// Speeds of neighbouring cells are the same but for rounding, of 1 mm/s and more.
#define SEAM 1e-9

// What the cells so far have come to.
typedef struct chain {
    uint32_t cells; // 0: nothing is known of what was before
    double v;       // at the end of the last one [path mm/s], of a clocked path per seg [1/s]
    int rests;      // 1: the path does there
} chain_t;

static int is_clocked(const nck_link_t *self, const nck_cell_t *cell) {
    return NCK_HAS_OPTIMAL && nck_link_seg(self, cell->seg)->kind == NCK_SEG_SPLINE;
}

// Whether a cell goes on from those before it. Behind a rest a clocked path may begin at any pace:
// its clock goes there, its place does not.
static int follows(const nck_link_t *self, chain_t *chain, const nck_cell_t *cell) {
    // What its speed counts in: the coordinate of a clocked seg is its own.
    const double unit = is_clocked(self, cell) ? nck_link_seg(self, cell->seg)->length : 1.0;
    const double scale = 1.0 + cell->v;
    const int begins = chain->rests && !(cell->s > 0.0) && is_clocked(self, cell);
    const int good = chain->cells == 0 || begins
                     || nck_fabs(cell->v - chain->v * unit) <= SEAM * scale;
    chain->cells++;
    chain->v = nck_cell_speed(cell, cell->duration) / unit;
    chain->rests = (cell->stop & NCK_STOP_REST) != 0;
    if (chain->rests) chain->v = 0.0;
    return good && chain->v >= -SEAM * scale;
}

// Whether what is left of the published tail goes on from the final cells and ends at rest.
static int tail_rests(const nck_link_t *self, uint32_t end, chain_t *chain) {
    uint32_t count = 0;
    const nck_cell_t *cell = nck_link_tail_cell(self, end);
    (void)nck_link_tail_end(self, &count);
    if (count == 0) return 1;
    while (cell && follows(self, chain, cell)) {
        end = (end + 1) & NCK_LINK_COUNT_MASK;
        cell = nck_link_tail_cell(self, end);
    }
    return !cell && nck_fabs(chain->v) <= SEAM;
}

static int are_within_capacities(const nck_link_t *self, uint32_t waiting) {
    return waiting + self->batch <= NCK_CELL_MAX && self->tail_fill <= NCK_TAIL_MAX
           && self->tail_count[0] <= NCK_TAIL_MAX && self->tail_count[1] <= NCK_TAIL_MAX
           && self->seg_head - self->seg_done <= NCK_SEG_MAX
           && self->output_head - self->output_taken <= NCK_OUTPUT_MAX;
}

int nck_link_invariants(const nck_link_t *self) {
    int entered = 0;
    const uint32_t end = nck_link_end(self, &entered);
    const uint32_t waiting = (end - self->taken) & NCK_LINK_COUNT_MASK;
    chain_t chain = {0, 0.0, 0};
    int good = are_within_capacities(self, waiting) && self->owner <= NCK_LINK_PREP
               && !self->broken;
    for (uint32_t i = 0; good && i < waiting; i++) {
        const nck_cell_t *const cell = &self->cell[(self->taken + i) & (NCK_CELL_MAX - 1)];
        good = follows(self, &chain, cell) && self->seg_head - cell->seg <= NCK_SEG_MAX;
    }
    return good && (entered || tail_rests(self, end, &chain));
}
