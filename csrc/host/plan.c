// SPDX-License-Identifier: MIT
// libnck_host: plan a whole program without executing it.
#include <string.h> // memset

#include "host.h"

enum { ROOM = 4 * NCK_WINDOW }; // rows that one turn of prep and take can add to an array

static void keep_seg(void *user, const nck_seg_t *seg) {
    nck_host_plan_t *const plan = user;
    plan->totals.segs++;
    plan->totals.length_mm += seg->length;
    if (!plan->segs) return;
    plan->segs[plan->seg_count] = *seg;
    plan->seg_count++;
}

static void keep_node(void *user, const nck_node_t *node) {
    nck_host_plan_t *const plan = user;
    plan->totals.nodes++;
    if (!plan->nodes) return;
    plan->nodes[plan->node_count] = *node;
    plan->node_count++;
}

nck_status_t nck_host_plan_init(nck_host_plan_t *plan, nck_t *nck, const nck_machine_t *machine,
                                const char *text, size_t n) {
    const nck_hooks_t hooks = {plan, NULL, keep_node, keep_seg};
    memset(plan, 0, sizeof *plan);
    plan->nck = nck;
    plan->text = text;
    plan->text_size = n;
    return nck_init(nck, machine, &hooks);
}

// Time from rest to rest counts in whole periods, as the tick does (6_interpolate).
static void count_time(nck_host_plan_t *plan, const nck_cell_t *cell) {
    const double period = plan->nck->machine.period_s;
    plan->since_stop_s += cell->duration;
    if (!cell->stop) return;
    plan->totals.ticks += nck_interpolate_periods(plan->since_stop_s, period);
    plan->totals.time_s = (double)plan->totals.ticks * period;
    plan->since_stop_s = 0.0;
}

static void sum_cell(nck_host_plan_t *plan, const nck_cell_t *cell) {
    nck_host_totals_t *const totals = &plan->totals;
    totals->cells++;
    totals->limit_s[cell->limit] += cell->duration;
    count_time(plan, cell);
    if (cell->kind >= NCK_SEG_DWELL) {
        totals->dwell_s += cell->duration;
        return;
    }
    if (nck_link_seg(&plan->nck->link, cell->seg)->rapid) totals->rapid_s += cell->duration;
    else totals->cut_s += cell->duration;
    if (cell->a > 0.0) totals->accelerate_s += cell->duration;
    else if (cell->a < 0.0) totals->decelerate_s += cell->duration;
    else totals->cruise_s += cell->duration;
}

static void take_cells(nck_host_plan_t *plan) {
    nck_cell_t cell;
    while (nck_take(plan->nck, &cell) == NCK_OK) {
        sum_cell(plan, &cell);
        if (!plan->cells) continue;
        plan->cells[plan->cell_count] = cell;
        plan->cell_count++;
    }
}

static void push_text(nck_host_plan_t *plan) {
    const size_t left = plan->text_size - plan->text_used;
    size_t used = 0;
    if (left > 0) nck_push(plan->nck, plan->text + plan->text_used, left, &used);
    else nck_end(plan->nck);
    plan->text_used += used;
}

static int has_room(const nck_host_plan_t *plan) {
    return (!plan->segs || plan->seg_count + ROOM <= plan->seg_max)
           && (!plan->nodes || plan->node_count + ROOM <= plan->node_max)
           && (!plan->cells || plan->cell_count + ROOM <= plan->cell_max);
}

nck_status_t nck_host_plan_run(nck_host_plan_t *plan) {
    nck_status_t status = NCK_OK;
    plan->seg_count = 0;
    plan->node_count = 0;
    plan->cell_count = 0;
    while (has_room(plan)) {
        status = nck_prep(plan->nck);
        if (status == NCK_OK) continue;
        take_cells(plan);
        plan->totals.blocks = plan->nck->wire.blocks;
        if (status == NCK_DONE || status < NCK_OK) return status;
        if (status == NCK_EMPTY) push_text(plan);
    }
    return NCK_OK;
}
