// SPDX-License-Identifier: MIT
// The room's inner doors: what its files call of each other. Nobody outside of 2_toolcomp includes
// this. Context of all: prep.
#ifndef NCK_PREP_TOOLCOMP_PARTS_H
#define NCK_PREP_TOOLCOMP_PARTS_H

#include "nck/prep/2_toolcomp/toolcomp.h" // nck_toolcomp_t

#define NCK_COMP_SHORT 1e-4 // [mm] shorter arcs are straight: they bend by less than is rounded
#define NCK_COMP_CLOSE 1e-3 // [mm] less is neither too near nor worth a word

// A line or an arc, and how high its ends are [mm], as nck_comp_height has it.
typedef struct nck_comp_stretch {
    nck_shape_t shape;
    double height[2];
} nck_comp_stretch_t;

// ring.c: the entry with this count. Cost: constant.
nck_comp_entry_t *nck_comp_at(nck_toolcomp_t *self, uint32_t count);

// ring.c: compensation ends: what waits is dropped. Cost: constant.
void nck_comp_off(nck_toolcomp_t *self);

// ring.c: note an error and end compensation. line: of the finding. Returns code. Cost:
// constant.
nck_status_t nck_comp_fail(nck_toolcomp_t *self, nck_status_t code, uint32_t line, double value,
                           double limit);

// ring.c: nanometres in millimetres. Cost: constant.
double nck_comp_mm(int64_t nm);

// ring.c: 1 if the path beside the contour of an entry is given, to its end or in part. Cost:
// constant.
int nck_comp_is_given(const nck_toolcomp_t *self, uint32_t count);

// entry.c: a part of the way in becomes a move, from the machine's start. NCK_EMPTY: there is none
// to go. Cost: constant.
nck_status_t nck_comp_way_in(const nck_toolcomp_t *self, nck_block_t *block);

// ring.c: the next entry with a contour behind this one, or ring.head. Cost: linear in the ring.
uint32_t nck_comp_next(nck_toolcomp_t *self, uint32_t count);

// pieces.c: a piece as it is on the path. Cost: constant.
void nck_comp_on_path(nck_toolcomp_t *self, const nck_comp_piece_t *piece, nck_shape_t *out);

// pieces.c: the piece of the path behind this one. 0: there is none yet. Cost: linear in the ring.
int nck_comp_following(nck_toolcomp_t *self, const nck_comp_piece_t *piece, nck_comp_piece_t *out);

// contour.c: put a block into the ring, which has room. NCK_EMPTY, NCK_E_COMP_ENTRY,
// NCK_E_COMP_RADIUS, NCK_E_COMP_GOUGE. Cost: linear in the ring.
nck_status_t nck_comp_take(nck_toolcomp_t *self, const nck_block_t *block);

// contour.c: put the way to the contour's other side into the ring, which is empty: by the block of
// G41 or G42, from a contour that ended in a direction. Cost: constant.
void nck_comp_cross(nck_toolcomp_t *self, const nck_block_t *block, const double *tangent);

// contour.c: the tool goes from the contour to the programmed end of a move. By type B it rounds
// the contour's end before, if the corner there turns away from it: then the move is taken.
// Returns NCK_OK: it passes; NCK_EMPTY: it is taken; NCK_E_COMP_GOUGE. Cost: quadratic in the
// ring.
nck_status_t nck_comp_leave(nck_toolcomp_t *self, const nck_block_t *block);

// pieces.c: the piece of the first contour, as RS274NGC has it; 0: there is none. Cost: constant.
int nck_comp_enter(const nck_toolcomp_t *self, const nck_shape_t *contour, nck_shape_t *out);

// pieces.c: by how much one direction of the contour turns away from the tool to the next,
// −π … π; right back is π [rad]. Cost: constant.
double nck_comp_turn(const nck_toolcomp_t *self, const double *before, const double *behind);

// pieces.c: the piece beside the contour of an entry, or about the corner before it. Cost:
// constant.
void nck_comp_piece(nck_toolcomp_t *self, uint32_t count, nck_comp_part_t part,
                    nck_comp_piece_t *out);

// join.c: how deep a tool that goes straight on at a corner cuts into the contour behind it [mm].
// turn: as nck_comp_turn has it. Cost: constant.
double nck_comp_dip(const nck_toolcomp_t *self, double turn);

// join.c: lead the path along the newest contour, as far as it comes to it: what that leaves out is
// no longer part of the path. follows: 1: the piece before ends at the corner. Cost: linear in the
// ring.
void nck_comp_join(nck_toolcomp_t *self, uint32_t count, int follows);

// judge.c: what the path leaves out between the piece in work and the one behind it: a note on the
// material left. NCK_OK; NCK_E_COMP_GOUGE: that is more than the radius of an inside corner. Cost:
// quadratic in the ring.
nck_status_t nck_comp_judge(nck_toolcomp_t *self);

// clear.c: does the contour of an entry come back to itself, or to one before it? Cost: linear in
// the ring.
int nck_comp_is_anew(nck_toolcomp_t *self, uint32_t count);

// clear.c: does a contour behind that of an entry come back to it? Cost: linear in the ring.
int nck_comp_is_met(nck_toolcomp_t *self, uint32_t count);

// clear.c: does the path cross the piece in work further on, where the contour does not cross
// itself? NCK_E_COMP_GOUGE. Cost: linear in the ring, quadratic where it does.
nck_status_t nck_comp_hold(nck_toolcomp_t *self);

// clear.c: is the piece in work nearer to a contour than the tool's radius, where the contour does
// not begin anew between them? NCK_E_COMP_GOUGE. Cost: linear in the ring.
nck_status_t nck_comp_keep_off(nck_toolcomp_t *self);

// level.c: how high a place is [mm]; 0 where the tool does not stand upright on the plane. Cost:
// constant.
double nck_comp_height(const nck_toolcomp_t *self, const int64_t *place_nm);

// level.c: the contour of an entry, and a piece as it is on the path, with their heights. Cost:
// constant, but for what is left out before the piece.
void nck_comp_wall(nck_toolcomp_t *self, uint32_t count, nck_comp_stretch_t *out);
void nck_comp_stretch(nck_toolcomp_t *self, const nck_comp_piece_t *piece, nck_comp_stretch_t *out);

// level.c: how deep is the tool, on a stretch of the path, in a contour [mm]? 0: no deeper than
// NCK_COMP_CLOSE. at: where. Cost: constant.
double nck_comp_depth(const nck_toolcomp_t *self, const nck_comp_stretch_t *path,
                      const nck_comp_stretch_t *wall, nck_approach_t *at);

// way.c: is the first move, the piece in work, in the contour? A note, or NCK_E_COMP_GOUGE. Cost:
// linear in the ring.
nck_status_t nck_comp_way_to(nck_toolcomp_t *self);

// way.c: is the move behind G40, in one part or two, in the contour? A note, or NCK_E_COMP_GOUGE.
// Cost: quadratic in the ring.
nck_status_t nck_comp_way_from(nck_toolcomp_t *self, const nck_block_t *block,
                               const nck_comp_stretch_t *way, unsigned parts);

// give.c: the block for the next stretch of the piece in work. NCK_OK, NCK_EMPTY (it has no
// length), NCK_E_TRAVEL. Cost: constant.
nck_status_t nck_comp_give(nck_toolcomp_t *self, nck_block_t *out);

// give.c: a block without a contour, where the path is by now. Cost: constant.
void nck_comp_give_along(nck_toolcomp_t *self, const nck_block_t *block, nck_block_t *out);

#endif
