// SPDX-License-Identifier: MIT
// Moves: straight, arcs, splines, probes, corners, a thread or a tapped hole by itself.
//
// The face of the wing: what other wings call of it. Context of all: prep.
#ifndef NCK_PREP_DECODE_MOTION_MOTION_H
#define NCK_PREP_DECODE_MOTION_MOTION_H

#include "nck/prep/1_decode/state/room.h" // nck_decode_t

// ---- motion.c

// Moves.
nck_status_t nck_decode_motion(nck_decode_t *self, nck_block_t *out);
nck_status_t nck_decode_reference(nck_decode_t *self, nck_block_t *out);
nck_status_t nck_decode_second(nck_decode_t *self, nck_block_t *out);

// The feed of a cut. NCK_E_FEED_MISSING: none was ever said, G93 without F here, G95 at a
// standstill; NCK_EMPTY: the same, and known. Cost: constant.
nck_status_t nck_decode_cutting_feed(nck_decode_t *self, int rotary_alone, double *feed_out);

// Whether a straight move of a kind has the F in force: a printer's G0 is its G1, and F holds for
// it, too, where a control's own planner asks for it. Cost: constant.
static inline int nck_decode_has_feed(const nck_decode_t *self, uint8_t kind) {
    return kind == NCK_BLOCK_LINE || self->tongue == NCK_TONGUE_MARLIN;
}

// A cycle is not for inverse time, nor for radius compensation. NCK_E_UNSUPPORTED, NCK_E_COMP_ON.
// Cost: constant.
nck_status_t nck_decode_cycle_fits(nck_decode_t *self);

// A block of a cycle to the present position; within: as any other move is, exact: its corners are
// not rounded; G61.1, G9 and a tolerance stop at them. feed: of NCK_BLOCK_LINE. Cost: constant.
void nck_decode_give_within(const nck_decode_t *self, nck_block_kind_t kind, double feed,
                            nck_block_t *out);
void nck_decode_give_exact(const nck_decode_t *self, nck_block_kind_t kind, double feed,
                           nck_block_t *out);

// The motion of the line in work to a machine position; pushed: of this block, NULL: of words.
// Cost: constant.
nck_status_t nck_decode_go(nck_decode_t *self, const nck_block_in_t *pushed,
                           const int64_t *target_nm, nck_block_t *out);

// ---- probe.c

// G38.2 … G38.5. NCK_E_PROBE, and as nck_decode_cutting_feed. Cost: linear in the parameters.
nck_status_t nck_decode_probe(nck_decode_t *self, nck_block_t *out);

// ---- spline.c

// G5, G5.1, G5.2, G5.3, G6.2. Cost: constant, of G6.2 linear in its points.
nck_status_t nck_decode_spline(nck_decode_t *self, nck_block_t *out);

// ---- corner.c

// 1 if the language has ,R and ,C; the word of one; of letters that nobody uses those that are a
// corner's on lathes. Cost: constant.
int nck_corner_speaks(const nck_decode_t *self);
void nck_corner_keep(nck_decode_t *self, char letter, unsigned column,
                     const nck_number_t *number, int is_old);
uint32_t nck_corner_letters(nck_decode_t *self, uint32_t letters);

// The line behind a corner, resolved; what a line's steps gave while a corner is in work:
// NCK_EMPTY: the block is held; the corner, and the move behind it; the text ends before it. All:
// NCK_E_CORNER. Cost: constant.
nck_status_t nck_corner_words(nck_decode_t *self);
nck_status_t nck_corner_take(nck_decode_t *self, nck_status_t status, nck_block_t *out);
nck_status_t nck_corner_next(nck_decode_t *self, nck_block_t *out);
nck_status_t nck_corner_missing(nck_decode_t *self);

// ---- polar.c

// @ or ^ of RS274NGC; both become words of X and Y; those of the next hole. NCK_E_VALUE,
// NCK_E_WORD_SHARED, NCK_E_INCREMENTAL, NCK_E_UNSUPPORTED, NCK_E_NUMBER_RANGE; of ,A also
// NCK_E_WORD_UNUSED, NCK_E_LAYOUT_ON. Cost: constant.
nck_status_t nck_polar_read(nck_decode_t *self, const char **at);
nck_status_t nck_polar_resolve(nck_decode_t *self);
void nck_polar_next(nck_decode_t *self);

// ---- slant.c

// On a lathe: A without a comma is ,A if no axis is called so. As nck_slant_keep. Cost: constant.
nck_status_t nck_slant_plain(nck_decode_t *self);

// Fanuc's ,A: the angle that stands in a column, kept until nck_polar_resolve makes it the word of
// an axis of the plane. NCK_E_WORD_TWICE, NCK_E_NUMBER_RANGE. Cost: constant.
nck_status_t nck_slant_keep(nck_decode_t *self, unsigned column, const nck_number_t *number);

// ---- thread.c

// G33, in system A G32. Whether a thread can be cut here: NCK_E_THREAD_SPEED, and as
// nck_decode_cycle_fits. The lead [mm] of a word; F may hold from the thread before. Fanuc's Q: the
// angle at the begin [revolutions]. A pass from where the tool stands; its duration is filled in:
// NCK_E_THREAD_SPEED, NCK_E_THREAD_RUN_IN, NCK_E_TRAVEL. Cost: constant.
nck_status_t nck_decode_single_pass(nck_decode_t *self, nck_block_t *out);
double nck_decode_thread_name(const nck_decode_t *self); // the code in work, as its system says it
nck_status_t nck_decode_thread_fits(nck_decode_t *self);
nck_status_t nck_decode_lead(nck_decode_t *self, char letter, double *lead_out);
nck_status_t nck_decode_start_angle(nck_decode_t *self, float *turn_out);
nck_status_t nck_decode_pass(nck_decode_t *self, const int64_t *end_nm, nck_thread_t *thread,
                             nck_block_t *out);

// ---- tap.c

// G33.1; a tapped hole from where the tool stands, with all in force that it needs.
// NCK_E_THREAD_SPEED, NCK_E_THREAD_RUN_IN. Cost: constant.
nck_status_t nck_decode_single_tap(nck_decode_t *self, nck_block_t *out);
nck_status_t nck_decode_tap(nck_decode_t *self, const int64_t *bottom_nm, double lead,
                            double dwell_s, nck_block_t *out);

#endif
