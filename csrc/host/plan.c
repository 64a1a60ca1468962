// SPDX-License-Identifier: MIT
// Planning a whole text without executing it: cells are taken in place of the tick.
#include "host/host.h"

#include <string.h> // memcpy memset

static void keep_seg(void *user, const nck_seg_t *seg) {
    nck_host_plan_t *const plan = user;
    plan->totals.segs++;
    plan->totals.length_mm = seg->s_program + seg->program;
    if (plan->segs) plan->segs[plan->seg_count++] = *seg;
}

static void keep_node(void *user, const nck_node_t *node) {
    nck_host_plan_t *const plan = user;
    plan->totals.nodes++;
    if (plan->nodes) plan->nodes[plan->node_count++] = *node;
}

static void keep_output(void *user, const nck_output_t *output) {
    nck_host_plan_t *const plan = user;
    if (plan->outputs) plan->outputs[plan->output_count++] = *output;
}

nck_status_t nck_host_plan_init(nck_host_plan_t *plan, nck_t *nck, const nck_machine_t *machine,
                                const char *text, size_t n) {
    const nck_hooks_t hooks = {plan, keep_output, keep_node, keep_seg};
    memset(plan, 0, sizeof *plan);
    plan->nck = nck;
    plan->text = text;
    plan->text_size = n;
    return nck_init(nck, machine, &hooks);
}

// Time of a part of the plan, to every sum it belongs to.
static void add_time(nck_host_totals_t *totals, const nck_cell_t *cell, int rapid, double time) {
    totals->limit_s[cell->limit] += time;
    if (!(cell->length > 0.0)) {
        totals->dwell_s += time;
        return;
    }
    const double a_mean = cell->a + 0.5 * cell->j * cell->duration;
    double *const kind = rapid ? &totals->rapid_s : &totals->cut_s;
    double *const slowing = a_mean < 0.0 ? &totals->decelerate_s : &totals->cruise_s;
    double *const phase = a_mean > 0.0 ? &totals->accelerate_s : slowing;
    *kind += time;
    *phase += time;
}

void nck_host_totals_add(nck_host_totals_t *totals, double *since_stop_s, const nck_cell_t *cell,
                         int rapid, double period_s, uint32_t settle) {
    totals->cells++;
    add_time(totals, cell, rapid, cell->duration);
    *since_stop_s += cell->duration;
    if (!(cell->stop & NCK_STOP_REST)) {
        totals->ticks += nck_interpolate_rebase(since_stop_s, period_s);
        return;
    }
    const uint64_t periods = nck_interpolate_periods(*since_stop_s, period_s)
                             + (cell->length > 0.0 ? settle : 0);
    add_time(totals, cell, rapid, (double)periods * period_s - *since_stop_s);
    totals->ticks += periods;
    totals->time_s = (double)totals->ticks * period_s;
    *since_stop_s = 0.0;
}

// Take all final cells. Returns how many.
static uint32_t take_cells(nck_host_plan_t *plan) {
    const nck_machine_t *const machine = nck_machine_of(plan->nck);
    nck_terms_t terms;
    nck_slope_terms(machine, &terms);
    const uint32_t settle = terms.taps - 1u;
    nck_cell_t cell;
    uint32_t count = 0;
    while (nck_take(plan->nck, &cell) == NCK_OK) {
        const int rapid = nck_link_seg(nck_link_of(plan->nck), cell.seg)->rapid;
        nck_host_totals_add(&plan->totals, &plan->since_stop_s, &cell, rapid,
                            machine->period_s, settle);
        if (plan->cells) plan->cells[plan->cell_count++] = cell;
        count++;
    }
    return count;
}

void nck_host_plan_blocks(nck_host_plan_t *plan) { plan->is_blocks = 1; }

static void feed_block(nck_host_plan_t *plan) {
    nck_block_in_t block;
    memcpy(&block, plan->text + plan->text_used, sizeof block);
    if (nck_push_block(plan->nck, &block) == NCK_FULL) return;
    plan->text_used += sizeof block;
}

// The kernel reads the text itself, if its capacities let it jump.
static void begin(nck_host_plan_t *plan) {
    const nck_source_t source = {plan->text, plan->text_size, NULL, NULL};
    plan->begun = 1;
    plan->reads = !plan->is_blocks && nck_read(plan->nck, &source) == NCK_OK;
}

static void feed(nck_host_plan_t *plan) {
    if (plan->text_used == plan->text_size) {
        nck_end(plan->nck);
        return;
    }
    if (plan->is_blocks) {
        feed_block(plan);
        return;
    }
    size_t used = 0;
    (void)nck_push(plan->nck, plan->text + plan->text_used, plan->text_size - plan->text_used,
                   &used);
    plan->text_used += used;
}

// One prep step gives one seg, or the nodes of one batch: no more of them than cells.
static int has_room(const nck_host_plan_t *plan) {
    return (!plan->segs || plan->seg_max - plan->seg_count > 1)
           && (!plan->nodes || plan->node_max - plan->node_count > NCK_CELL_MAX)
           && (!plan->cells || plan->cell_max - plan->cell_count > NCK_CELL_MAX)
           && (!plan->outputs || plan->output_max - plan->output_count > NCK_OUTPUT_MAX);
}

static int arrays_are_large(const nck_host_plan_t *plan) {
    const size_t least = (size_t)4 * NCK_WINDOW;
    return (!plan->segs || plan->seg_max >= least) && (!plan->nodes || plan->node_max >= least)
           && (!plan->cells || plan->cell_max >= least)
           && (!plan->outputs || plan->output_max >= least);
}

// A kernel that is full although nothing waits for the tick would never go on.
static nck_status_t step(nck_host_plan_t *plan) {
    const int was_full = plan->status == NCK_FULL;
    if (!plan->begun) begin(plan);
    plan->status = nck_prep(plan->nck);
    if (plan->reads) plan->text_used = nck_read_offset(plan->nck);
    if (plan->status < NCK_OK) plan->error = plan->status;
    if (plan->status == NCK_EMPTY) feed(plan);
    if (plan->status == NCK_DONE) take_cells(plan);
    if (plan->status == NCK_FULL && take_cells(plan) == 0 && was_full) return NCK_E_INTERNAL;
    return plan->status == NCK_DONE ? NCK_DONE : NCK_OK;
}

nck_status_t nck_host_plan_run(nck_host_plan_t *plan) {
    const uint64_t cells_before = plan->totals.cells;
    nck_status_t status = NCK_OK;
    if (!arrays_are_large(plan)) return NCK_E_ARGUMENT;
    plan->seg_count = 0;
    plan->node_count = 0;
    plan->cell_count = 0;
    plan->output_count = 0;
    while (status == NCK_OK && has_room(plan) && plan->totals.cells - cells_before < NCK_WINDOW) {
        status = step(plan);
    }
    nck_queue_t queue;
    nck_queue(plan->nck, &queue);
    plan->totals.blocks = queue.blocks;
    return status == NCK_DONE && plan->error < NCK_OK ? (nck_status_t)plan->error : status;
}
