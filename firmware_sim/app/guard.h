// SPDX-License-Identifier: MIT
// The guard of the travel: the last look at a setpoint before the drives get it.
#ifndef APP_GUARD_H
#define APP_GUARD_H

#include "app/app.h" // app_t

// Take the travel of every joint from the machine's axes. Cost: constant. Context: before the tick.
void app_guard_init(app_t *app);

// Change a joint's travel. Returns 1, or 0 if there is no such joint or the range is empty.
// Cost: constant. Context: task.
int app_guard_set(app_t *app, int64_t joint, const app_range_t *travel);

// Tell the kernel of the joints whose travel has changed: it holds before the path leaves it.
// Cost: linear in the joints. Context: prep.
void app_guard_tell(app_t *app);

// 1 if the drives may have the next setpoint, 0 if a joint would leave its travel.
// Cost: linear in the joints. Context: tick.
int app_guard_lets(const app_t *app, const nck_axes_t *next);

#endif
