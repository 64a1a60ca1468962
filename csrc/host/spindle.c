// SPDX-License-Identifier: MIT
// The spindle's angle beside a plan.
#include "host/spindle.h"

#include <string.h> // memset

#include "nck/prep/5_slope/slope.h" // nck_slope_terms

void nck_host_spindle_init(nck_host_spindle_t *self, const nck_machine_t *machine) {
    memset(self, 0, sizeof *self);
    nck_slope_terms(machine, &self->terms);
    nck_link_init(&self->link);
    nck_interpolate_init(&self->interpolate, &self->terms, &self->link);
    self->on = 1;
    self->rests = 1;
}

// The segs of a cell, as the tick must find them.
static void take_segs(nck_host_spindle_t *self, const nck_link_t *from, const nck_cell_t *cell) {
    const uint32_t end = cell->seg + cell->span + 1;
    while ((int32_t)(end - self->link.seg_head) > 0) {
        const nck_seg_t *const seg = nck_link_seg(from, self->link.seg_head);
        if (nck_link_push_seg(&self->link, seg) == NCK_OK) continue;
        self->broken = 1;
        return;
    }
}

static void take_cell(nck_host_spindle_t *self, const nck_cell_t *cell) {
    if (nck_link_cell_room(&self->link) == 0) {
        self->broken = 1;
        return;
    }
    (void)nck_link_batch_begin(&self->link);
    nck_link_tail_begin(&self->link);
    nck_link_push_cell(&self->link, cell);
    if (nck_link_publish(&self->link) != NCK_OK) self->broken = 1;
    self->known_s += cell->duration;
    self->rests = (cell->stop & NCK_STOP_REST) != 0;
}

// 1 if the next tick needs no cell that is not known. Two periods: one is the tick's, one covers
// that times are added up here in another order.
static int may_tick(const nck_host_spindle_t *self) {
    const nck_interpolate_t *const interpolate = &self->interpolate;
    const double period = interpolate->machine->period_s;
    if (!self->rests) return ((double)self->ticks + 2.0) * period < self->known_s;
    return !interpolate->rests || nck_link_waiting(&self->link) > 0;
}

// M0 and M6 are resumed at once, as in the simulation.
static uint64_t tick(nck_host_spindle_t *self) {
    uint64_t ticks = 0;
    for (; may_tick(self); ticks++) {
        const nck_pose_t *const pose = nck_interpolate_tick(&self->interpolate);
        if (pose->state == NCK_TICK_WAIT) nck_interpolate_resume(&self->interpolate);
        self->ticks++;
    }
    if (!self->rests) return ticks;
    self->ticks = 0;
    self->known_s = 0.0;
    return ticks;
}

void nck_host_spindle_cell(nck_host_spindle_t *self, const nck_link_t *from, nck_cell_t *cell) {
    if (!self->on || self->broken) return;
    take_segs(self, from, cell);
    take_cell(self, cell);
    if (self->broken) return;
    const uint64_t ticks = tick(self);
    if (nck_link_seg(from, cell->seg)->kind < NCK_SEG_THREAD || cell->length > 0.0) return;
    cell->duration = (double)ticks * self->interpolate.machine->period_s;
}
