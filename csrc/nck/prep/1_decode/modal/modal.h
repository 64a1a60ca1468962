// SPDX-License-Identifier: MIT
// Settings that stay in force, and outputs: units, feed, spindle, coolant, path, ports.
//
// The face of the wing: what other wings call of it. Context of all: prep.
#ifndef NCK_PREP_DECODE_MODAL_MODAL_H
#define NCK_PREP_DECODE_MODAL_MODAL_H

#include "nck/prep/1_decode/state/room.h" // nck_decode_t

// ---- modal.c

// Settings and outputs.
nck_status_t nck_decode_units(nck_decode_t *self, nck_block_t *out);
nck_status_t nck_decode_feed_mode(nck_decode_t *self, nck_block_t *out);
nck_status_t nck_decode_feed(nck_decode_t *self, nck_block_t *out);
nck_status_t nck_decode_change(nck_decode_t *self, nck_block_t *out);
nck_status_t nck_decode_spindle(nck_decode_t *self, nck_block_t *out);
nck_status_t nck_decode_mist(nck_decode_t *self, nck_block_t *out);
nck_status_t nck_decode_flood(nck_decode_t *self, nck_block_t *out);
nck_status_t nck_decode_override(nck_decode_t *self, nck_block_t *out);
nck_status_t nck_decode_own(nck_decode_t *self, nck_block_t *out);
nck_status_t nck_decode_dwell(nck_decode_t *self, nck_block_t *out);
nck_status_t nck_decode_plane(nck_decode_t *self, nck_block_t *out);
nck_status_t nck_decode_diameter(nck_decode_t *self, nck_block_t *out);
nck_status_t nck_decode_path(nck_decode_t *self, nck_block_t *out);
nck_status_t nck_decode_distance(nck_decode_t *self, nck_block_t *out);
nck_status_t nck_decode_centre(nck_decode_t *self, nck_block_t *out);
nck_status_t nck_decode_stop(nck_decode_t *self, nck_block_t *out);
nck_status_t nck_decode_retract(nck_decode_t *self, nck_block_t *out);

// A feed [mm/min, mm/rev or 1/min], and as written; the word of a dwell. Cost: constant.
void nck_decode_set_feed(nck_decode_t *self, double feed, double word);
nck_status_t nck_decode_dwell_word(nck_decode_t *self, char letter, double *dwell_out);

// ---- spindle.c

// G96, G97; S; the S of Fanuc's G92 (system A: G50).
nck_status_t nck_decode_speed_mode(nck_decode_t *self, nck_block_t *out);
nck_status_t nck_decode_speed(nck_decode_t *self, nck_block_t *out);
nck_status_t nck_decode_speed_limit(nck_decode_t *self);

// A speed [rpm], which ends G96. Cost: constant.
nck_status_t nck_decode_set_speed(nck_decode_t *self, double value, nck_block_t *out);

// ---- port.c

// M62 … M68. Cost: constant.
nck_status_t nck_decode_port(nck_decode_t *self, nck_block_t *out);

#endif
