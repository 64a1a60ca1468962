// SPDX-License-Identifier: MIT
// How far the S-shape sees, and what it may pass junctions at. Inside of the room.
#ifndef NCK_PREP_SSHAPE_AHEAD_H
#define NCK_PREP_SSHAPE_AHEAD_H

#include "nck/prep/5_slope/sshape.h" // nck_sshape_t nck_sshape_hop_t

// How much one step and one part take on.
enum {
    NCK_SSHAPE_STEP = 32, // pieces, or cells, in one bounded step
    // A tail holds a part, its last ramp and at most three cells for every piece of the brake.
    NCK_SSHAPE_PART = NCK_TAIL_MAX > 80 ? NCK_TAIL_MAX / 8 : 10, // cells of a part at most
    // The window holds a published part, one in work and what lies ahead of it.
    NCK_SSHAPE_PIECES = NCK_WINDOW > 48 ? NCK_WINDOW / 16 : NCK_SSHAPE_HOP // of a part at most
};

// The pieces under the wishes of the plan in work. Cost: constant.
nck_sshape_view_t nck_sshape_view(const nck_sshape_t *self, const nck_pieces_t *pieces);

// 1 if single block rests at the end of this piece. Cost: constant.
int nck_sshape_ends_block(const nck_sshape_t *self, const nck_pieces_t *pieces, uint32_t number);

// Look ahead anew from where the plan begins. v_floor: the caps are raised to what the path can
// brake to from that speed on; 0: they are not. Cost: constant.
void nck_sshape_look_anew(nck_sshape_t *self, double v_floor);

// Look ahead. NCK_OK: call again; NCK_EMPTY: needs pieces; NCK_DONE: the junctions' speeds are
// known. Cost: 32 pieces.
nck_status_t nck_sshape_look(nck_sshape_t *self, const nck_pieces_t *pieces);

// The hop that a place lies in, from the place on, as far as it has been looked at. Cost: constant.
nck_sshape_hop_t nck_sshape_hop_at(nck_sshape_t *self, const nck_pieces_t *pieces,
                                   const nck_sshape_place_t *place);

// The largest speed at a hop's end that what lies behind it allows. Cost: constant.
double nck_sshape_end_most(nck_sshape_t *self, const nck_sshape_hop_t *hop);

#endif
