// SPDX-License-Identifier: MIT
// Switches of a machine that is not there.
#include "host_switches.h"

#include <math.h>   // copysign fabs
#include <string.h> // memset

enum { INPUTS = 32, LONG = 1 << 30 };

static const int64_t nowhere_nm = -1000000000000;

void host_switches_init(host_switches_t *self, const nck_t *nck) {
    nck_pose_t pose;
    nck_axes_t axes;
    memset(self, 0, sizeof *self);
    self->plate_nm = nowhere_nm;
    self->seed = 1;
    for (int k = 0; k < INPUTS; k++) self->since[k] = LONG;
    (void)nck_position(nck, &pose, &axes);
    host_switches_move(self, nck, &axes, 0);
    memset(self->real_nm, 0, sizeof self->real_nm);
    for (uint32_t k = 0; k < nck_joint_count(nck); k++) {
        self->real_nm[nck_joint_axis(nck, k)] = axes.joint_nm[k];
    }
}

// An axis is where a switch is closed, at its place or beyond.
static int is_beyond(int64_t at_nm, int64_t place_nm, int below) {
    return below ? at_nm <= place_nm : at_nm >= place_nm;
}

static uint32_t closed_now(const host_switches_t *self) {
    uint32_t closed = self->pushed;
    for (uint32_t x = 0; x < NCK_AXIS_MAX; x++) {
        const int back = (self->least >> x & 1u) != 0;
        const uint32_t limit = 1u << (HAL_IN_LIMIT + x);
        const uint32_t home = 1u << (HAL_IN_HOME + x);
        const int is_home = is_beyond(self->real_nm[x], self->place_nm[x], back);
        const int is_far = is_beyond(self->real_nm[x], self->far_nm[x], !back);
        if ((self->wired >> x & 1u) != 0 && is_home) {
            closed |= (self->homes_only >> x & 1u) ? home : home | limit;
        }
        if ((self->far >> x & 1u) != 0 && is_far) closed |= limit;
    }
    if (self->pair != 0) {
        const int back = (self->least >> (self->pair - 1) & 1u) != 0;
        const uint32_t is_home = (uint32_t)is_beyond(self->mate_nm, self->second_nm, back);
        closed |= is_home << HAL_IN_SECOND;
    }
    if (self->real_nm[NCK_AXIS_Z] <= self->plate_nm) closed |= 1u << HAL_IN_PROBE;
    if (self->rpm != self->rpm_wanted) closed |= 1u << HAL_IN_SLOW;
    return closed;
}

void host_switches_turn(host_switches_t *self, double wanted) {
    const double way = wanted - self->rpm;
    const int at_once = self->rpm_tick == 0.0 || fabs(way) <= self->rpm_tick;
    self->rpm_wanted = wanted;
    self->rpm = at_once ? wanted : self->rpm + copysign(self->rpm_tick, way);
}

static uint32_t coin(host_switches_t *self) {
    self->seed = self->seed * 6364136223846793005u + 1442695040888963407u;
    return (uint32_t)(self->seed >> 40) & 1u;
}

uint32_t host_switches_read(host_switches_t *self) {
    const uint32_t closed = closed_now(self);
    const uint32_t changed = closed ^ self->closed;
    uint32_t read = closed;
    self->closed = closed;
    for (uint32_t k = 0; k < INPUTS; k++) {
        if (changed >> k & 1u) self->since[k] = 0;
        else if (self->since[k] < LONG) self->since[k]++;
        if (self->since[k] < self->bounce && coin(self)) read ^= 1u << k;
    }
    return read | self->broken;
}

void host_switches_move(host_switches_t *self, const nck_t *nck, const nck_axes_t *axes,
                        uint32_t held) {
    const int told = nck_places(nck) != self->places;
    for (uint32_t k = 0; k < nck_joint_count(nck); k++) {
        const uint32_t x = nck_joint_axis(nck, k);
        const int64_t way_nm = told ? 0 : axes->joint_nm[k] - self->told_nm[x];
        const uint32_t stays = self->pair == x + 1 ? held : 0u;
        if ((stays & 1u) == 0) self->real_nm[x] += way_nm;
        if (self->pair == x + 1 && (stays & 2u) == 0) self->mate_nm += way_nm;
        self->told_nm[x] = axes->joint_nm[k];
    }
    self->places = nck_places(nck);
}
