// SPDX-License-Identifier: MIT
// Inside room 6: a tap. The tool's place is a function of the spindle's angle alone, in and out;
// the kernel commands the spindle's speed.
#ifndef NCK_TICK_TAP_H
#define NCK_TICK_TAP_H

#include "nck/tick/6_interpolate/sync.h" // nck_sync_t

// Its plan, when the tick comes to it. Cost: constant. Context: tick.
void nck_tap_begin(nck_sync_t *self, const nck_machine_t *machine, const nck_seg_t *seg);

// One tick of a tap, from the angle of its begin on: place, speed and state of the pose, and the
// spindle's speed until the next one. Returns nck_sync_state_t; ENDS once. Cost: constant.
// Context: tick.
uint32_t nck_tap_tick(nck_sync_t *self, const nck_machine_t *machine, const nck_seg_t *seg,
                      nck_pose_t *pose);

#endif
