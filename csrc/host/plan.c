// SPDX-License-Identifier: MIT
// Planning a whole text without executing it: cells are taken in place of the tick.
#include "host/host.h"

#include <stddef.h> // offsetof
#include <string.h> // memcpy memset

#include "nck/base/real.h" // nck_fabs

// The speed along a clocked path wavers by the gap of its solver. It is steady while it changes by
// less than this share of the path's acceleration: half or twice as much moves 0.5 % of a part.
#define STEADY (1.0 / 128.0)

static void keep_seg(void *user, const nck_seg_t *seg) {
    nck_host_plan_t *const plan = user;
    plan->totals.segs++;
    plan->totals.length_mm = seg->s_begin + seg->length;
    nck_host_why_row(nck_host_why_at(&plan->why, seg->seq), plan->tangent, seg, &plan->terms);
    if (plan->segs) plan->segs[plan->seg_count++] = *seg;
}

static void keep_node(void *user, const nck_node_t *node) {
    nck_host_plan_t *const plan = user;
    plan->totals.nodes++;
    nck_host_why_node(&plan->why, node);
    if (plan->nodes) plan->nodes[plan->node_count++] = *node;
}

static void keep_output(void *user, const nck_output_t *output) {
    nck_host_plan_t *const plan = user;
    nck_host_share_output(&plan->why.shares, output);
    if (plan->outputs) plan->outputs[plan->output_count++] = *output;
}

nck_status_t nck_host_plan_init(nck_host_plan_t *plan, nck_t *nck, const nck_machine_t *machine,
                                const char *text, size_t n) {
    const nck_hooks_t hooks = {plan, keep_output, keep_node, keep_seg};
    memset(plan, 0, offsetof(nck_host_plan_t, why));
    nck_host_why_init(&plan->why, nck);
    nck_host_share_init(&plan->why.shares, machine);
    plan->spindle.on = 0;
    plan->nck = nck;
    plan->text = text;
    plan->text_size = n;
    const nck_status_t status = nck_init(nck, machine, &hooks);
    if (status == NCK_OK) nck_slope_terms(nck_machine_of(nck), &plan->terms);
    return status;
}

// Time of a part of the plan, to every sum it belongs to.
static void add_time(nck_host_totals_t *totals, const nck_cell_t *cell, int rapid, double time) {
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

double nck_host_totals_add(nck_host_totals_t *totals, double *since_stop_s, const nck_cell_t *cell,
                           int rapid, double period_s, uint32_t settle) {
    totals->cells++;
    add_time(totals, cell, rapid, cell->duration);
    *since_stop_s += cell->duration;
    if (!(cell->stop & NCK_STOP_REST)) {
        totals->ticks += nck_interpolate_rebase(since_stop_s, period_s);
        return 0.0;
    }
    const uint64_t periods = nck_interpolate_periods(*since_stop_s, period_s)
                             + (cell->length > 0.0 ? settle : 0);
    const double extra_s = (double)periods * period_s - *since_stop_s;
    add_time(totals, cell, rapid, extra_s);
    totals->ticks += periods;
    totals->time_s = (double)totals->ticks * period_s;
    *since_stop_s = 0.0;
    return extra_s;
}

// A cell as its speed changes along the path: a clocked path's own is the clock's, and its speed is
// never quite even. Less of the path's acceleration than STEADY is none.
static nck_cell_t along_path(const nck_machine_t *machine, const nck_seg_t *seg,
                             const nck_cell_t *cell) {
    nck_cell_t told = *cell;
    if (seg->kind != NCK_SEG_SPLINE || !(cell->duration > 0.0)) return told;
    const double v_end = nck_host_trail_speed(seg, cell, cell->duration);
    const double a = (v_end - nck_host_trail_speed(seg, cell, 0.0)) / cell->duration;
    told.a = nck_fabs(a) > STEADY * machine->path.a_max ? a : 0.0;
    told.j = 0.0;
    return told;
}

// Take all final cells, as long as there is room for their points. Returns how many.
static uint32_t take_cells(nck_host_plan_t *plan) {
    const nck_machine_t *const machine = nck_machine_of(plan->nck);
    nck_cell_t cell;
    uint32_t count = 0;
    while (nck_host_trail_has_room(&plan->why.trail) && nck_take(plan->nck, &cell) == NCK_OK) {
        const nck_link_t *const link = nck_link_of(plan->nck);
        const nck_seg_t *const seg = nck_link_seg(link, cell.seg);
        // Along a clocked path the tick takes no mean.
        const uint32_t settle = seg->kind == NCK_SEG_SPLINE ? 0u : plan->terms.taps - 1u;
        const int rapid = seg->rapid;
        nck_host_spindle_cell(&plan->spindle, link, &cell);
        const nck_cell_t told = along_path(machine, seg, &cell);
        const double extra_s = nck_host_totals_add(&plan->totals, &plan->since_stop_s, &told,
                                                   rapid, machine->period_s, settle);
        nck_host_why_cell(&plan->why, &cell, extra_s);
        if (plan->cells) plan->cells[plan->cell_count++] = cell;
        count++;
    }
    return count;
}

void nck_host_plan_blocks(nck_host_plan_t *plan) { plan->is_blocks = 1; }

void nck_host_plan_threads(nck_host_plan_t *plan) {
    nck_host_spindle_init(&plan->spindle, nck_machine_of(plan->nck));
}

nck_status_t nck_host_plan_part(nck_host_plan_t *plan, const nck_host_cut_t *from,
                                uint64_t blocks) {
    nck_t *const nck = plan->nck;
    nck_machine_t machine = *nck_machine_of(nck);
    memcpy(machine.start_nm, from->decode.place.position_nm, sizeof machine.start_nm);
    const nck_status_t status = nck_host_plan_init(plan, nck, &machine, plan->text,
                                                   plan->text_size);
    if (status != NCK_OK) return status;
    nck_enter(nck, &from->decode, &from->toolcomp, (uint32_t)from->blocks, plan->text);
    plan->why.shares.tool = from->outputs.tool;
    plan->why.shares.tool_next = from->outputs.tool_next;
    plan->why.shares.turns = from->outputs.turns;
    plan->blocks_before = from->blocks;
    plan->block_last = blocks > 0 ? from->blocks + blocks : 0;
    plan->begun = 1;
    plan->reads = 1;
    return NCK_OK;
}

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

void nck_host_plan_take(nck_host_plan_t *plan, const nck_host_batch_t *batch) {
    plan->batch = batch;
    plan->begun = 1;
    memset(&plan->used, 0, sizeof plan->used);
}

// Of a seg the link gets what room 5 and the sums ask for.
static void take_seg(nck_host_plan_t *plan, const nck_host_batch_seg_t *row) {
    nck_link_t *const link = nck_link_of(plan->nck);
    nck_seg_t *const seg = nck_link_seg_place(link);
    if (row->kind == NCK_SEG_SPLINE) {
        *seg = plan->batch->wholes[plan->used.whole++];
    } else {
        seg->kind = row->kind;
        seg->s_begin = row->why.s_begin;
        seg->length = row->length_mm - row->why.s_begin;
        seg->keeps = NCK_KEEP_NOTHING;
    }
    seg->line = row->why.line;
    seg->block = row->block;
    seg->rapid = row->rapid;
    nck_link_seg_placed(link, seg);
    nck_host_why_seg_t *const why = nck_host_why_at(&plan->why, row->seq);
    *why = row->why;
    why->line = seg->line;
    plan->totals.segs++;
    plan->totals.length_mm = row->length_mm;
}

// What is next in the batch goes to the kernel. NCK_FULL: not before the tick has taken cells.
static nck_status_t feed_item(nck_host_plan_t *plan, uint8_t what) {
    const nck_host_batch_t *const batch = plan->batch;
    nck_link_t *const link = nck_link_of(plan->nck);
    if (what == NCK_HOST_BATCH_STEP) return NCK_OK;
    if (what == NCK_HOST_BATCH_END) {
        if (batch->error < NCK_OK) plan->error = batch->error;
        return nck_end_pieces(plan->nck, batch->blocks);
    }
    if (what == NCK_HOST_BATCH_NODE) {
        const nck_status_t status = nck_push_piece(plan->nck, &batch->nodes[plan->used.node]);
        plan->used.node += status == NCK_OK;
        return status;
    }
    if (what == NCK_HOST_BATCH_MARK) {
        const nck_mark_t *const mark = &batch->marks[plan->used.mark++];
        nck_link_push_mark(link, mark);
        return NCK_OK;
    }
    if (!nck_link_has_room(link)) return NCK_FULL;
    if (what == NCK_HOST_BATCH_OUTPUT) {
        return nck_link_push_output(link, &batch->outputs[plan->used.output++]);
    }
    take_seg(plan, &batch->segs[plan->used.seg++]);
    return NCK_OK;
}

// All of the batch up to where the kernel goes on with room 5. NCK_EMPTY: nothing is left of it.
static nck_status_t feed_step(nck_host_plan_t *plan) {
    const nck_host_batch_t *const batch = plan->batch;
    while (plan->used.order < batch->order_count) {
        const uint8_t what = batch->orders[plan->used.order];
        const nck_status_t status = feed_item(plan, what);
        if (status != NCK_OK) return status;
        plan->used.order++;
        if (what == NCK_HOST_BATCH_STEP) return NCK_OK;
    }
    return NCK_EMPTY;
}

// The same again, as long as room 5 only waits for more. Behind the last step, which may be that of
// the end, it is asked.
static nck_status_t feed_steps(nck_host_plan_t *plan) {
    nck_status_t status = feed_step(plan);
    while (status == NCK_OK && plan->used.order < plan->batch->order_count
           && nck_lacks_pieces(plan->nck)) {
        status = feed_step(plan);
    }
    return status;
}

// One prep step gives one seg, or the nodes of one batch: no more of them than cells.
static int has_room(const nck_host_plan_t *plan) {
    return (!plan->segs || plan->seg_max - plan->seg_count > 1)
           && (!plan->nodes || plan->node_max - plan->node_count > NCK_CELL_MAX)
           && (!plan->cells || plan->cell_max - plan->cell_count > NCK_CELL_MAX)
           && (!plan->outputs || plan->output_max - plan->output_count > NCK_OUTPUT_MAX)
           && nck_host_trail_has_room(&plan->why.trail);
}

static int arrays_are_large(const nck_host_plan_t *plan) {
    const size_t least = (size_t)4 * NCK_WINDOW;
    return (!plan->segs || plan->seg_max >= least) && (!plan->nodes || plan->node_max >= least)
           && (!plan->cells || plan->cell_max >= least)
           && (!plan->outputs || plan->output_max >= least);
}

// A step of the kernel, and what it tells of its text.
static void prepare(nck_host_plan_t *plan) {
    if (!plan->begun) begin(plan);
    plan->status = nck_prep(plan->nck);
    if (plan->block_last > 0) nck_leave_at(plan->nck, (uint32_t)plan->block_last);
    if (plan->reads) plan->text_used = nck_read_offset(plan->nck);
    if (plan->status < NCK_OK) plan->error = plan->status;
}

// A kernel that is full although nothing waits for the tick would never go on.
static nck_status_t step(nck_host_plan_t *plan) {
    const int was_full = plan->status == NCK_FULL;
    prepare(plan);
    if (plan->status == NCK_EMPTY && plan->batch) {
        const nck_status_t fed = feed_steps(plan);
        if (fed != NCK_FULL) return fed;
        plan->status = NCK_FULL;
    }
    if (plan->status == NCK_EMPTY) feed(plan);
    if (plan->status == NCK_DONE) take_cells(plan);
    if (plan->status == NCK_FULL && take_cells(plan) == 0 && was_full) {
        return plan->batch ? NCK_E_STATE : NCK_E_INTERNAL;
    }
    const int is_done = plan->status == NCK_DONE && nck_host_trail_has_room(&plan->why.trail);
    return is_done ? NCK_DONE : NCK_OK;
}

// What others than cells know of the sums.
static void complete_totals(nck_host_plan_t *plan) {
    const nck_host_why_t *const why = &plan->why;
    nck_queue_t queue;
    nck_queue(plan->nck, &queue);
    plan->totals.blocks = queue.blocks - plan->blocks_before;
    plan->totals.tool_changes = why->shares.tool_changes;
    plan->totals.spindle_starts = why->shares.spindle_starts;
    for (uint32_t k = 0; k < NCK_LIMIT_AXIS_V + NCK_AXIS_MAX; k++) {
        plan->totals.limit_s[k] = why->limit_s[k].sum + why->limit_s[k].rest;
    }
}

// What is told of the plan does not add up.
static int is_broken(const nck_host_plan_t *plan) {
    return plan->why.broken || plan->why.trail.broken || (plan->spindle.on && plan->spindle.broken);
}

nck_status_t nck_host_plan_run(nck_host_plan_t *plan) {
    const uint64_t cells_before = plan->totals.cells;
    nck_status_t status = NCK_OK;
    if (!arrays_are_large(plan)) return NCK_E_ARGUMENT;
    plan->seg_count = 0;
    plan->node_count = 0;
    plan->cell_count = 0;
    plan->output_count = 0;
    nck_host_trail_again(&plan->why.trail, nck_machine_of(plan->nck));
    if (!nck_host_trail_has_room(&plan->why.trail)) return NCK_E_ARGUMENT;
    while (status == NCK_OK && has_room(plan) && plan->totals.cells - cells_before < NCK_WINDOW) {
        status = step(plan);
    }
    if (status == NCK_DONE) nck_host_why_end(&plan->why);
    if (is_broken(plan)) return NCK_E_INTERNAL;
    complete_totals(plan);
    return status == NCK_DONE && plan->error < NCK_OK ? (nck_status_t)plan->error : status;
}
