// SPDX-License-Identifier: MIT
// The simulated controller on the host.
#include "sim.h"

#include <string.h> // memset

static void keep_output(void *user, const nck_output_t *output) {
    sim_t *const sim = user;
    if (output->kind == NCK_OUTPUT_SPINDLE_SPEED) sim->spindle_rpm = output->value;
    sim->outputs++;
}

nck_status_t sim_init(sim_t *sim, nck_t *nck, const nck_machine_t *machine, const char *text,
                      size_t n, uint32_t prep_steps) {
    const nck_hooks_t hooks = {sim, keep_output, NULL, NULL};
    memset(sim, 0, sizeof *sim);
    if (prep_steps == 0) return NCK_E_ARGUMENT;
    sim->nck = nck;
    sim->text = text;
    sim->text_size = n;
    sim->prep_steps = prep_steps;
    return nck_init(nck, machine, &hooks);
}

static void push_text(sim_t *sim) {
    const size_t left = sim->text_size - sim->text_used;
    size_t used = 0;
    if (left > 0) nck_push(sim->nck, sim->text + sim->text_used, left, &used);
    else nck_end(sim->nck);
    sim->text_used += used;
}

// One prep step. 1: there is more to do before the next tick.
static int prep(sim_t *sim) {
    const nck_status_t status = nck_prep(sim->nck);
    if (status == NCK_EMPTY) push_text(sim);
    if (status < NCK_OK && sim->error == NCK_OK) sim->error = status;
    sim->prepared = status == NCK_DONE;
    return status != NCK_FULL && status != NCK_DONE;
}

// Before the first tick prep runs until it has to wait; later it has its steps.
static void prep_between_ticks(sim_t *sim) {
    uint32_t steps = 0;
    while ((steps < sim->prep_steps || sim->ticks == 0) && prep(sim)) steps++;
}

static void tick(sim_t *sim, sim_row_t *row) {
    memset(row, 0, sizeof *row);
    row->queue_cells = nck_link_waiting(&sim->nck->link);
    const nck_tick_state_t state = nck_tick(sim->nck, &row->pose, &row->axes);
    sim->ticks++;
    row->t_s = (double)sim->ticks * sim->nck->machine.period_s;
    row->spindle_rpm = sim->spindle_rpm;
    if (state == NCK_TICK_STARVED) sim->starved_ticks++;
    if (state == NCK_TICK_WAIT) nck_resume(sim->nck);
}

static int is_over(const sim_t *sim) { return sim->prepared && nck_is_idle(sim->nck); }

nck_status_t sim_run(sim_t *sim, sim_row_t *rows, size_t row_max, size_t *row_count_out) {
    size_t count = 0;
    while (count < row_max) {
        prep_between_ticks(sim);
        if (is_over(sim)) break;
        tick(sim, &rows[count]);
        count++;
    }
    *row_count_out = count;
    if (!is_over(sim)) return NCK_OK;
    return sim->error < NCK_OK ? sim->error : NCK_DONE;
}
