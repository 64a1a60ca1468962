// SPDX-License-Identifier: MIT
// The room's inner doors: what its files call of each other. Nobody outside of 2_toolcomp includes
// this. Context of all: prep.
#ifndef NCK_PREP_TOOLCOMP_PARTS_H
#define NCK_PREP_TOOLCOMP_PARTS_H

#include "nck/prep/2_toolcomp/toolcomp.h" // nck_toolcomp_t

// ring.c: the entry with this count. Cost: constant.
nck_comp_entry_t *nck_comp_at(nck_toolcomp_t *self, uint32_t count);

// Of the blocks in the ring so many may be done with: what follows is held against them, too.
enum { NCK_COMP_KEPT = NCK_COMP_ROWS / 4 };

// ring.c: the oldest entry that is kept. Cost: constant.
uint32_t nck_comp_oldest(const nck_toolcomp_t *self);

// ring.c: compensation ends: what waits is dropped. Cost: constant.
void nck_comp_off(nck_toolcomp_t *self);

// ring.c: note an error and end compensation. line: of the finding. Returns code. Cost:
// constant.
nck_status_t nck_comp_fail(nck_toolcomp_t *self, nck_status_t code, uint32_t line, double value,
                           double limit);

// entry.c: a part of the way in becomes a move, from the machine's start. NCK_EMPTY: there is none
// to go. Cost: constant.
nck_status_t nck_comp_way_in(const nck_toolcomp_t *self, nck_block_t *block);

// contour.c: put a block into the ring, which has room. NCK_EMPTY, NCK_E_COMP_ENTRY,
// NCK_E_COMP_RADIUS. Cost: linear in the ring.
nck_status_t nck_comp_take(nck_toolcomp_t *self, const nck_block_t *block);

// ring.c: the next entry with a contour behind this one, or ring.head. Cost: linear in the ring.
uint32_t nck_comp_next(nck_toolcomp_t *self, uint32_t count);

// ring.c: 1 if two places of the contour are to be held against each other. Where the contour meets
// itself it begins anew (laps, what leads in and out), so they are not if it does between them, or
// if the way from one to the other is much shorter by way of such a place. s_from < s_to [mm].
// Cost: linear in the ring.
int nck_comp_relates(nck_toolcomp_t *self, double s_from, double s_to);

// pieces.c: the piece of the first contour; 0: there is none. Cost: constant.
int nck_comp_enter(const nck_toolcomp_t *self, const nck_shape_t *contour, nck_shape_t *out);

// pieces.c: the piece parallel to a contour, and the one about the corner before it, from where a
// contour ends in a direction; 0: no arc is needed there. Cost: constant.
void nck_comp_beside(nck_toolcomp_t *self, uint32_t count, nck_comp_piece_t *out);
int nck_comp_about(nck_toolcomp_t *self, uint32_t count, const double *tangent,
                   nck_comp_piece_t *out);

// cut.c: the place of a point of a piece on the contour [mm]. Cost: constant.
double nck_comp_on_contour(nck_toolcomp_t *self, const nck_comp_piece_t *piece, double along);

// cut.c: where does the path leave the piece in work? Fills walk.jumps, until, on_next and next.
// Cost: linear in the ring.
void nck_comp_find_cut(nck_toolcomp_t *self);

// judge.c: what the cut leaves out: a note on the material left. NCK_OK, or NCK_E_COMP_GOUGE: the
// tool would fit there, but does not come in. Cost: quadratic in the ring.
nck_status_t nck_comp_judge(nck_toolcomp_t *self);

// judge.c: is the piece in work, from walk.along to walk.until, clear of the contours that follow?
// NCK_E_COMP_GOUGE. Cost: linear in the ring.
nck_status_t nck_comp_hold(nck_toolcomp_t *self);

// give.c: the block for the next stretch of the piece in work; closes the piece at its end.
// NCK_OK, NCK_EMPTY (it has no length), NCK_E_TRAVEL. Cost: constant.
nck_status_t nck_comp_give(nck_toolcomp_t *self, nck_block_t *out);

// give.c: a block without a contour, where the path is by now. Cost: constant.
void nck_comp_give_along(nck_toolcomp_t *self, const nck_block_t *block, nck_block_t *out);

#endif
