// SPDX-License-Identifier: MIT
// What rooms agree about: the least tolerance, the largest override, a number for what nothing
// limits.
#ifndef NCK_BASE_BUDGET_H
#define NCK_BASE_BUDGET_H

// Beyond every speed, acceleration, jerk and length.
#define NCK_UNLIMITED 1e30

// The least tolerance that a path is smoothed within [mm]: a smaller one, a hundred of a setpoint's
// nanometres and less, means the exact path.
#define NCK_TOLERANCE_MIN 1e-4

// Largest feed override.
#define NCK_OVERRIDE_TOP 2.0

#endif
