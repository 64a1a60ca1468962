// SPDX-License-Identifier: MIT
// How the rooms share an axis' acceleration and jerk among the terms of a bend, the largest
// override that they are shared for, and a number for what nothing limits. README of 4_lookahead,
// section "smooth pieces".
#ifndef NCK_BASE_BUDGET_H
#define NCK_BASE_BUDGET_H

// Beyond every speed, acceleration, jerk and length.
#define NCK_UNLIMITED 1e30

// The least tolerance that a path is smoothed within [mm]: a smaller one, a hundred of a setpoint's
// nanometres and less, means the exact path.
#define NCK_TOLERANCE_MIN 1e-4

// Largest feed override.
#define NCK_OVERRIDE_TOP 2.0

// Shares that the speed alone may use: of acceleration |p″|v² ≤ γ·a_x, of jerk |p‴|v³ ≤ β·j_x.
#define NCK_BUDGET_CURVE_SHARE 0.95
#define NCK_BUDGET_TWIST_SHARE 0.85
// Share of the jerk that |p‴|v³ leaves which 3|p″|v·a may use; the rest is for p′·j.
#define NCK_BUDGET_RAMP_SHARE 0.5
// How steep the caps of neighbouring pieces may be: this share of the acceleration that is left.
#define NCK_BUDGET_STEEP_SHARE 0.8

#endif
