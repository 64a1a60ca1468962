// SPDX-License-Identifier: MIT
// What the files of this wing call of each other, and nobody else. Context of all: prep.
#ifndef NCK_PREP_DECODE_MOTION_PARTS_H
#define NCK_PREP_DECODE_MOTION_PARTS_H

#include "nck/prep/1_decode/motion/motion.h"
#include "nck/prep/1_decode/state/state.h" // nck_decode_fail_step
#include "nck/base/thread.h" // nck_thread_ramp

// As nck_decode_fail_step at the line's motion. Cost: constant.
static inline nck_status_t nck_motion_fail(nck_decode_t *self, nck_status_t code, int letter,
                                           double value, double limit) {
    return nck_decode_fail_step(self, code, NCK_STEP_MOTION, letter, value, limit);
}

// NCK_E_THREAD_RUN_IN: a pass of no length, or a hole of no depth, at the speed v [mm/s]; letter:
// the word that says so. Cost: constant.
static inline nck_status_t nck_motion_fail_empty(nck_decode_t *self, double v, char letter) {
    nck_ramp_t ramp;
    nck_thread_ramp(v, self->machine->path.a_max, self->machine->path.j_max, &ramp);
    return nck_motion_fail(self, NCK_E_THREAD_RUN_IN, letter, 2.0 * ramp.length, 0.0);
}

// ---- arc.c

// The arc to a machine position; a second part of it goes to self->second. pushed: the block that
// says centre and turns, NULL: words do. Cost: constant.
nck_status_t nck_decode_arc(nck_decode_t *self, const nck_block_in_t *pushed,
                            const int64_t *target_nm, nck_block_t *out);

// ---- motion.c

// Straight on to a machine place, as G0 or G1, taken as reached. NCK_E_TRAVEL, and as
// nck_decode_cutting_feed. Cost: constant.
nck_status_t nck_decode_straight(nck_decode_t *self, nck_block_kind_t kind,
                                 const int64_t *target_nm, nck_block_t *out);

// ---- knots.c

// A line of G6.2: a knot, and a point or not. NCK_OK; NCK_DONE: it was the last one; NCK_E_SPLINE,
// NCK_E_CONTOUR_FULL, NCK_E_SCALE_UNIT, and as nck_decode_cycle_fits. Cost: linear in the points.
nck_status_t nck_decode_knots(nck_decode_t *self);

// ---- polar.c and slant.c: words that are made of others

// What else in the line moves the zero, or the units that the words are written in.
#define NCK_MOVES_ZERO                                                                            \
    (NCK_STEP(NCK_STEP_UNITS) | NCK_STEP(NCK_STEP_DIAMETER) | NCK_STEP(NCK_STEP_STATE)             \
     | NCK_STEP(NCK_STEP_LENGTH) | NCK_STEP(NCK_STEP_WORK) | NCK_STEP(NCK_STEP_OFFSET)             \
     | NCK_STEP(NCK_STEP_MACHINE) | NCK_STEP(NCK_STEP_PLANE) | NCK_STEP(NCK_STEP_LAYOUT))

// 1 if the words of the line add to where it begins: by its own G91, or by that in force.
// Cost: constant.
static inline int nck_motion_adds(const nck_decode_t *self) {
    const int own = (self->words.codes & NCK_STEP(NCK_STEP_DISTANCE)) != 0;
    return own ? self->words.code[NCK_STEP_DISTANCE] == 910 : self->modal.incremental;
}

// ---- corner.c

// A line of which ,A alone is said [rad] ends where it meets the next one; 1: the line that waits
// is such a one; 1, once: there would be one, but for an error; the angle of the line behind it.
// Cost: constant.
void nck_corner_open(nck_decode_t *self, unsigned column, double angle);
int nck_corner_is_open(const nck_decode_t *self);
int nck_corner_excuses(nck_decode_t *self);
void nck_corner_close(nck_decode_t *self, double angle);

// ---- slant.c

// The angle of ,A and the axis that is said become the word of the other axis of the plane; without
// an axis the next line says where this one ends.
// NCK_E_WORD_UNUSED, NCK_E_INCREMENTAL, NCK_E_LAYOUT_ON, NCK_E_WORD_SHARED, NCK_E_UNSUPPORTED (the
// line before has an angle alone, and not both axes are said), NCK_E_NUMBER_RANGE. Cost: constant.
nck_status_t nck_slant_resolve(nck_decode_t *self);

#endif
