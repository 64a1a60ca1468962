// SPDX-License-Identifier: MIT
// Inputs in the tick, and what of them is watched.
#include "inputs/inputs.h"

#include <string.h> // memset

#include "nck/base/fence.h" // nck_fence_load nck_fence_store

enum { LIMITS = (1 << NCK_AXIS_MAX) - 1 };

void inputs_init(inputs_t *self, nck_t *nck) {
    memset(self, 0, sizeof *self);
    self->nck = nck;
    self->halt.quick = 1.0;
    self->set.order = 0x213; // Z, X, Y
    self->set.debounce = 25;
    self->set.feed = 25.0;
    self->set.seek = 500.0;
    self->set.pull_off = 1.0;
    self->set.skew = 5.0;
}

void inputs_watch(inputs_t *self, uint32_t closing, uint32_t opening) {
    const uint32_t limits = self->set.limits ? (uint32_t)LIMITS : 0u;
    nck_fence_store(&self->watched, closing | limits);
    nck_fence_store(&self->opened, opening);
}

// A motor of a pair that is at its switch stays until the other one is at its own. Then both go on,
// and come to rest as far behind their switches. Returns what stops the axes.
static uint32_t square(inputs_t *self, uint32_t now, uint32_t hit) {
    const uint32_t axis = self->set.pair - 1;
    const uint32_t home = 1u << (HAL_IN_HOME + axis);
    const uint32_t at = (now >> (HAL_IN_HOME + axis) & 1u) | (now >> HAL_IN_SECOND & 1u) << 1;
    const uint32_t before = self->held;
    const uint32_t held = before | at; // a switch may bounce
    nck_pose_t pose;
    nck_axes_t axes;
    if (held == 0) return hit & ~home;
    (void)nck_position(self->nck, &pose, &axes);
    if (before == 0) self->alone_from = pose.axis[axis];
    const double alone = pose.axis[axis] - self->alone_from;
    const int racks = alone > self->set.skew || -alone > self->set.skew;
    const int stops = held == 3 || racks;
    nck_fence_store(&self->racked, held != 3 && racks);
    nck_fence_store(&self->held, stops ? 0 : held);
    return stops ? hit | home : hit & ~home;
}

int inputs_tick(inputs_t *self, uint32_t pins) {
    const uint32_t now = pins ^ self->set.inverted;
    const uint32_t always = 1u << HAL_IN_EMERGENCY;
    uint32_t hit = (now & (nck_fence_load(&self->watched) | always))
                   | (~now & nck_fence_load(&self->opened));
    if (nck_fence_load(&self->squares) && self->tripped == 0) hit = square(self, now, hit);
    nck_fence_store(&self->steady, now == self->pins ? self->steady + 1 : 0);
    nck_fence_store(&self->pins, now);
    if (self->wait.kind != INPUTS_NOTHING) inputs_wait(self);
    if (hit != 0 && self->tripped == 0) {
        nck_stop_at(self->nck, &self->halt);
        nck_fence_store(&self->tripped, hit);
    }
    return (now >> HAL_IN_EMERGENCY & 1u) != 0;
}

// The switch that has stopped the axes may stay closed: what is watched then is the caller's to
// say.
nck_status_t inputs_go_on(inputs_t *self) {
    nck_command_t asked;
    nck_asked(self->nck, &asked);
    const int gone = !asked.abort; // somebody else has begun anew
    const nck_status_t status = gone ? NCK_OK : nck_go_on(self->nck);
    if (status != NCK_OK) return status;
    nck_fence_store(&self->watched, 0);
    nck_fence_store(&self->opened, 0);
    nck_fence_store(&self->squares, 0);
    nck_fence_store(&self->held, 0);
    nck_fence_store(&self->tripped, 0);
    return NCK_OK;
}
