// SPDX-License-Identifier: MIT
// Inside room 3: sharp corners between two lines, as two overlapping stops and starts.
#ifndef NCK_PREP_BLEND_H
#define NCK_PREP_BLEND_H

#include <stdint.h> // uint32_t

#include "nck/prep/3_smooth/smooth.h" // nck_smooth_t

// Segs of a blend, at most.
enum { NCK_BLEND_SEGS = 6 };

// How far a blend keeps from the next corner, in spacings of the spline there.
#define NCK_BLEND_KEEP_OFF 3.0

// The corner in front of the newest block with a seg, which nothing will be joined to any more: if
// it is one between two lines of a run, the slope limits jerk, and a blend of its own is fastest
// (choice.h), put that blend between the two, as exact pieces; the lines get shorter, and the run
// ends before it. Outputs between the two come in the blend's middle. `more` blocks behind the
// ring's head (0 or 1) move along. Returns by how many blocks.
// Cost: some 100 square roots; linear in outputs in a row.
uint32_t nck_blend_corner(nck_smooth_t *self, uint32_t more);

#endif
