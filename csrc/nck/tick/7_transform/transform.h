// SPDX-License-Identifier: MIT
// Room 7, transform: pose → axes. From the tool to the joints.
#ifndef NCK_TICK_TRANSFORM_H
#define NCK_TICK_TRANSFORM_H

#include "nck/base/machine.h" // nck_machine_t
#include "nck/base/records.h" // nck_pose_t nck_axes_t

// The room's state: filled by nck_transform_init, const from then on.
typedef struct nck_transform {
    uint32_t joints;             // how many
    double counts[NCK_AXIS_MAX]; // of joint k in one mm or degree
    uint8_t axis[NCK_AXIS_MAX];  // which axis drives joint k
} nck_transform_t;

// Cost: constant. Context: any, before the tick runs.
void nck_transform_init(nck_transform_t *self, const nck_machine_t *machine);

// Setpoints of all joints, rounded half to even to the nanometre (nanodegree); unused joints are 0.
// Cost: constant. Context: tick.
void nck_transform_tick(const nck_transform_t *self, const nck_pose_t *pose, nck_axes_t *axes_out);

#endif
