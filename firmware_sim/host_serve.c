// SPDX-License-Identifier: MIT
// The machine: one loop in place of a task, a timer's interrupt and a UART's.
#include "host_serve.h"

#include <math.h>   // fabs fmax
#include <string.h> // memcpy memmove memset

static void write_out(void *user, const char *bytes, uint32_t n) {
    host_serve_t *const self = user;
    const size_t room = HOST_OUT - self->out_count;
    const size_t fits = n < room ? n : room;
    memcpy(self->out + self->out_count, bytes, fits);
    self->out_count += fits;
    self->out_lost += n - fits;
}

static void on_output(void *user, const nck_output_t *output) {
    host_serve_t *const self = user;
    serve_output(&self->serve, output);
    if (self->serve.beside) inputs_output(&self->inputs, output);
}

nck_status_t host_serve_init(host_serve_t *self, nck_t *nck, const nck_machine_t *machine) {
    const nck_hooks_t hooks = {self, on_output, NULL, NULL};
    const serve_port_t port = {self, write_out};
    memset(self, 0, sizeof *self);
    self->nck = nck;
    host_serve_lend(self, self->own, HOST_IN);
    self->hash = 14695981039346656037u;
    const nck_status_t status = nck_init(nck, machine, &hooks);
    if (status != NCK_OK) return status;
    (void)nck_position(nck, &self->pose, &self->axes);
    inputs_init(&self->inputs, nck);
    host_switches_init(&self->switches, nck);
    return serve_init(&self->serve, nck, &self->room, &port);
}

void host_serve_lend(host_serve_t *self, char *bytes, uint32_t size) {
    self->in = bytes;
    self->in_size = size;
}

void host_serve_connect(host_serve_t *self) { serve_switches(&self->serve, &self->inputs); }

nck_status_t host_serve_restore(host_serve_t *self, const nck_modal_t *modal, int moved) {
    static const char told[] = "[MSG:Power has failed: '$H'|'$X' to unlock]\r\n";
    nck_status_t status = nck_modal_set(self->nck, modal);
    if (status == NCK_OK) status = nck_set_position(self->nck, modal->position_nm);
    if (status != NCK_OK) return status;
    memcpy(self->switches.real_nm, modal->position_nm, sizeof self->switches.real_nm);
    if (self->switches.pair) {
        self->switches.mate_nm = modal->position_nm[self->switches.pair - 1];
    }
    if (!moved) return NCK_OK;
    self->serve.locked = SERVE_NOT_HOMED;
    write_out(self, told, sizeof told - 1);
    return NCK_OK;
}

// What waits outside goes in.
static void let_in(host_serve_t *self) {
    while (self->in_tail != self->in_head && serve_has_room(&self->serve)) {
        serve_put(&self->serve, (uint8_t)self->in[self->in_tail++ & (self->in_size - 1)]);
    }
}

size_t host_serve_receive(host_serve_t *self, const char *bytes, size_t n) {
    enum { RESET = 0x18 };
    size_t used = 0;
    for (; used < n && self->in_head - self->in_tail < self->in_size; used++) {
        if (bytes[used] == RESET) self->in_tail = self->in_head; // what was before is dropped
        if (serve_hear(&self->serve, (uint8_t)bytes[used])) continue;
        self->in[self->in_head++ & (self->in_size - 1)] = bytes[used];
    }
    let_in(self);
    return used;
}

void host_serve_part(host_serve_t *self) {
    self->in_tail = self->in_head;
    serve_part(&self->serve);
}

// What the drives feel of a period.
static void note(host_serve_t *self, const nck_axes_t *before) {
    const nck_machine_t *const machine = nck_machine_of(self->nck);
    const int told = nck_places(self->nck) != self->switches.places;
    int moved = 0;
    host_switches_move(&self->switches, self->nck, &self->axes, self->inputs.held);
    if (told) return;
    for (uint32_t k = 0; k < nck_joint_count(self->nck); k++) {
        const uint32_t axis = nck_joint_axis(self->nck, k);
        const int64_t step = self->axes.joint_nm[k] - before->joint_nm[k];
        const double counts = nck_machine_counts(machine, (int)axis);
        const double way = fmax(fabs((double)step) - 1.0, 0.0) / counts; // both are rounded
        const double share = way / machine->period_s / machine->axis[axis].v_max;
        self->v_most = fmax(self->v_most, share);
        moved |= step != 0;
    }
    if (!moved) return;
    self->moving++;
    for (uint32_t k = 0; k < nck_joint_count(self->nck); k++) {
        self->hash = (self->hash ^ (uint64_t)self->axes.joint_nm[k]) * 1099511628211u;
    }
}

// The spindle as commanded, by the operator's override, too.
static void turn(host_serve_t *self) {
    const double rpm = self->serve.tick.rpm * serve_spindle(&self->serve) / 100.0;
    const uint32_t turns = self->serve.tick.turns;
    host_switches_turn(&self->switches, turns == 0 ? 0.0 : turns == 1 ? rpm : -rpm);
}

static void prepare(host_serve_t *self, uint32_t steps) {
    self->status = NCK_OK;
    for (uint32_t k = 0; k < steps && self->status == NCK_OK; k++) {
        self->status = serve_step(&self->serve);
    }
}

void host_serve_run(host_serve_t *self, uint32_t ticks, uint32_t steps) {
    for (uint32_t k = 0; k < ticks; k++) {
        const nck_axes_t before = self->axes;
        let_in(self);
        prepare(self, steps);
        turn(self);
        (void)inputs_tick(&self->inputs, host_switches_read(&self->switches));
        (void)nck_tick(self->nck, &self->pose, &self->axes);
        serve_tick(&self->serve, &self->pose);
        note(self, &before);
        self->ticks++;
    }
    prepare(self, steps);
}

size_t host_serve_take(host_serve_t *self, char *bytes, size_t n) {
    const size_t taken = n < self->out_count ? n : self->out_count;
    memcpy(bytes, self->out, taken);
    self->out_count -= taken;
    memmove(self->out, self->out + taken, self->out_count);
    return taken;
}
