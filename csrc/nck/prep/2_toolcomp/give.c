// SPDX-License-Identifier: MIT
// The path as blocks.
#include "nck/prep/2_toolcomp/parts.h"

#include <string.h> // memcpy

#include "nck/base/arc_math.h" // nck_arc_…
#include "nck/base/real.h"     // nck_floor nck_rounded nck_real_of

#define PER_MINUTE 60.0 // seconds

// ---- travel

static nck_status_t check_place(nck_toolcomp_t *self, const nck_block_t *block, unsigned k,
                                int64_t place_nm) {
    const unsigned axis = self->axis[k];
    const nck_axis_t *const travel = &self->machine->axis[axis];
    const int64_t at_nm = place_nm + block->tool_nm[axis];
    const int roams = self->machine->roams != 0;
    if (roams || (at_nm >= travel->min_nm && at_nm <= travel->max_nm)) return NCK_OK;
    const int64_t limit_nm = at_nm < travel->min_nm ? travel->min_nm : travel->max_nm;
    const nck_status_t status = nck_comp_fail(self, NCK_E_TRAVEL, block->line,
                                              nck_comp_mm(at_nm),
                                              nck_comp_mm(limit_nm));
    self->error.letter = 'X' + (int)axis;
    return status;
}

// ---- lines and arcs

// An arc of half a turn at most, through both ends as they are rounded, about the point nearest to
// its centre. It is longer than NCK_COMP_SHORT, and cut into a few parts: none is without a length.
static nck_status_t bend(nck_toolcomp_t *self, const nck_shape_t *shape, nck_block_t *out) {
    double from[2];
    double d[2];
    double c[2];
    double to[2];
    for (unsigned k = 0; k < 2; k++) {
        const int64_t given_nm = self->given_nm[self->axis[k]];
        from[k] = nck_comp_mm(given_nm);
        d[k] = nck_comp_mm(out->target_nm[self->axis[k]] - given_nm);
        c[k] = shape->c[k] + self->nose[k] - from[k];
    }
    const double length = nck_arc_norm(d[0], d[1]);
    const double height = nck_arc_height(d[0], d[1], c[0], c[1]);
    out->kind = NCK_BLOCK_ARC;
    out->sweep_rad = nck_arc_sweep(length, height, nck_shape_turn(shape));
    nck_arc_centre(d[0], d[1], height, c);
    for (unsigned k = 0; k < 2; k++) {
        out->centre_mm[k] = from[k] + c[k];
        to[k] = d[k] - c[k];
        from[k] = -c[k];
    }
    const unsigned bulges = nck_arc_bulges(from, to, out->sweep_rad);
    const double radius = nck_arc_norm(c[0], c[1]);
    nck_status_t status = NCK_OK;
    for (unsigned k = 0; k < 4 && status == NCK_OK; k++) {
        if (!(bulges >> k & 1u)) continue;
        const double place = (out->centre_mm[k % 2] + (k < 2 ? radius : -radius)) * 1e6;
        status = check_place(self, out, k % 2, (int64_t)nck_floor(place));
    }
    return status;
}

// An arc about a corner has the feed of the contour behind it: of a rapid, the largest.
static void feed_corner(const nck_toolcomp_t *self, const nck_comp_entry_t *entry, double length,
                        nck_block_t *out) {
    if (entry->rapid) {
        out->feed_mode = NCK_FEED_PER_MINUTE;
        out->feed = self->machine->path.feed_max * PER_MINUTE;
    } else if (out->feed_mode == NCK_FEED_INVERSE) {
        out->feed *= entry->contour.length / length;
    }
}

// Where the stretch ends in the axes outside of the plane: their way is shared evenly among the
// stretches up to the place where the piece is left.
static void share_others(const nck_toolcomp_t *self, const nck_block_t *block, double share,
                         nck_block_t *out) {
    for (unsigned axis = 0; axis < NCK_AXIS_MAX; axis++) {
        const int64_t given_nm = self->given_nm[axis];
        const double way = nck_real_of(block->target_nm[axis] - given_nm) * share;
        out->target_nm[axis] = given_nm + nck_rounded(way);
    }
}

// An arc is given in stretches of half a turn at most.
static double stretch(const nck_shape_t *shape, double along, double until) {
    const double half = NCK_PI * shape->radius;
    const double rest = until - along;
    if (!(rest > half)) return 1.0;
    return 1.0 / (1.0 + nck_floor(rest / half));
}

// Is the block a move?
static int has_length(const nck_toolcomp_t *self, const nck_block_t *out) {
    for (unsigned axis = 0; axis < NCK_AXIS_MAX; axis++) {
        if (out->target_nm[axis] != self->given_nm[axis]) return 1;
    }
    return 0;
}

// A piece that begins elsewhere than the one before ends is led to straight.
static int is_apart(const nck_toolcomp_t *self, const nck_comp_entry_t *entry, double *begin) {
    const nck_comp_piece_t *const piece = &self->walk.piece;
    if (entry->enters || self->walk.along > entry->path[piece->part].from) return 0;
    nck_shape_point(&piece->shape, self->walk.along, begin);
    return nck_arc_norm(begin[0] - self->at[0], begin[1] - self->at[1]) > NCK_COMP_SHORT;
}

static nck_status_t check_places(nck_toolcomp_t *self, const nck_block_t *block) {
    nck_status_t status = NCK_OK;
    for (unsigned k = 0; k < 2 && status == NCK_OK; k++) {
        status = check_place(self, block, k, block->target_nm[self->axis[k]]);
    }
    return status;
}

// The block gets its form: an arc of the piece, or a line.
static nck_status_t form(nck_toolcomp_t *self, const nck_comp_piece_t *piece, int bends,
                         nck_block_t *out) {
    nck_status_t status = NCK_OK;
    if (bends) status = bend(self, &piece->shape, out);
    else if (out->kind == NCK_BLOCK_ARC) out->kind = NCK_BLOCK_LINE;
    return status;
}

nck_status_t nck_comp_give(nck_toolcomp_t *self, nck_block_t *out) {
    const nck_comp_piece_t *const piece = &self->walk.piece;
    const nck_comp_entry_t *const entry = nck_comp_at(self, piece->of);
    const int joins = piece->part == NCK_COMP_ABOUT;
    double begin[2];
    const int apart = is_apart(self, entry, begin);
    const double rest = apart ? 0.0 : self->walk.until - self->walk.along;
    const int bends = piece->shape.radius > 0.0 && rest > NCK_COMP_SHORT;
    const double share = bends ? stretch(&piece->shape, self->walk.along, self->walk.until) : 1.0;
    const double to = share < 1.0 ? self->walk.along + share * rest : self->walk.along + rest;
    if (apart) memcpy(self->at, begin, sizeof begin);
    else nck_shape_point(&piece->shape, to, self->at);
    self->walk.along = to;
    *out = entry->block;
    share_others(self, &entry->block, joins || apart ? 0.0 : share, out);
    // The place of the tool's point in the plane.
    for (unsigned k = 0; k < 2; k++) {
        const double place = (self->at[k] + self->nose[k]) * 1e6;
        out->target_nm[self->axis[k]] = nck_rounded(place);
    }
    if (!has_length(self, out)) return NCK_EMPTY;
    nck_status_t status = form(self, piece, bends, out);
    if (joins) feed_corner(self, entry, piece->shape.length, out);
    if (status == NCK_OK) status = check_places(self, out);
    memcpy(self->given_nm, out->target_nm, sizeof self->given_nm);
    return status;
}

void nck_comp_give_along(nck_toolcomp_t *self, const nck_block_t *block, nck_block_t *out) {
    *out = *block;
    for (unsigned k = 0; k < 2; k++) {
        out->target_nm[self->axis[k]] = self->given_nm[self->axis[k]];
    }
    if (block->kind > NCK_BLOCK_ARC) return;
    memcpy(self->given_nm, out->target_nm, sizeof self->given_nm);
}
