// SPDX-License-Identifier: MIT
// Inside room 4: a junction becomes the nodes of its pieces, each with its caps.
#ifndef NCK_PREP_PIECE_H
#define NCK_PREP_PIECE_H

#include "nck/prep/4_lookahead/lookahead.h" // nck_lookahead_t

// Turn the oldest junction into nodes: head, middle and tail where a seg is worth that, else one.
// The cap of a node is the least of its junction's and of the pieces' on both sides. share_after:
// what nck_zone_shares_after says of the junction. NCK_OK, or NCK_EMPTY: what follows the junction
// is not known yet. Cost: 2·NCK_CORNER_SPAN neighbours at most.
nck_status_t nck_piece_place(nck_lookahead_t *self, const double share_after[NCK_PACES]);

#endif
