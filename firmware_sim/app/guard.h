// SPDX-License-Identifier: MIT
// The guard of the travel: the last look at a setpoint before the drives get it.
#ifndef APP_GUARD_H
#define APP_GUARD_H

#include "app/app.h" // app_t

// What the guard says of a setpoint.
typedef enum app_guard {
    APP_GUARD_FAR = 0,
    APP_GUARD_NEAR = 1,  // a joint can only just be stopped before its limit
    APP_GUARD_BEYOND = 2 // the setpoint leaves the travel: it must not be handed over
} app_guard_t;

// Take the travel of every joint from the machine's axes. Cost: constant. Context: before the tick.
void app_guard_init(app_t *app);

// Change a joint's travel. Returns 1, or 0 if there is no such joint or the range is empty.
// Cost: constant. Context: task.
int app_guard_set(app_t *app, int64_t joint, const app_range_t *travel);

// Judge the next setpoint. Cost: linear in the joints. Context: tick.
app_guard_t app_guard_check(const app_t *app, const nck_pose_t *pose, const nck_axes_t *next);

#endif
