// SPDX-License-Identifier: MIT
// Inside room 5: hops, the stretches between two places that the S-shape passes without
// acceleration. A hop is a piece, or the middle of a seg with the zones beside its corners.
#ifndef NCK_PREP_SSHAPE_HOP_H
#define NCK_PREP_SSHAPE_HOP_H

#include "nck/prep/5_slope/plan.h"         // nck_pieces_t nck_wish_t
#include "nck/prep/5_slope/sshape_piece.h" // nck_sshape_piece_t

enum { NCK_SSHAPE_HOP = 3 }; // pieces of a hop at most: head, middle, tail of a seg

// The pieces under the wishes that a plan is made for.
typedef struct nck_sshape_view {
    const nck_pieces_t *pieces;
    const nck_wish_t *wish;
    uint32_t over; // 1: limits for overrides beyond 100 %
} nck_sshape_view_t;

// Pieces that are passed in one course.
typedef struct nck_sshape_hop {
    nck_sshape_piece_t piece; // what its ramps go by
    double s;       // where it begins, in its seg [path mm]
    double s_end;   // where it ends
    double v_in;    // what its head allows at its start [mm/s]
    double v_out;   // what its tail allows at its end [mm/s]
    uint32_t seg;
    uint32_t first; // number of its first piece
    uint32_t count; // pieces
    uint8_t last;   // 1: it ends its seg
    uint8_t stops;  // 1: the path rests at its end
    uint8_t limit;  // nck_limit_t of its cap
} nck_sshape_hop_t;

// Pieces of the hop that begins with this one; 0: what follows in its seg is not known yet.
// Cost: constant.
uint32_t nck_sshape_hop_pieces(const nck_sshape_view_t *view, uint32_t first);

// The hop of so many pieces. Cost: constant.
void nck_sshape_hop_of(const nck_sshape_view_t *view, uint32_t first, uint32_t count,
                       nck_sshape_hop_t *hop_out);

// The same from a place within it on. Cost: constant.
void nck_sshape_hop_from(nck_sshape_hop_t *hop, double s);

#endif
