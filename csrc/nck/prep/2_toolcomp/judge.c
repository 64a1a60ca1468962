// SPDX-License-Identifier: MIT
// What does the path leave out between two of its pieces? The radius of an inside corner may stay,
// with elements in it that are no longer than the tool's radius; nothing that the tool could touch.
#include "nck/prep/2_toolcomp/parts.h"

#include <string.h> // memset

#include "nck/base/arc_math.h" // nck_arc_norm
#include "nck/base/real.h"     // nck_min nck_max

enum { PLACES = 8 }; // of a piece are looked at
#define CLEAR 1e-5 // [mm] a tool that is nearer does not fit

// What is between two pieces of the path.
typedef struct apart {
    const nck_comp_piece_t *from;
    const nck_comp_piece_t *to;
    nck_shape_t side[2]; // what the path has of them
    double left;         // most of the material that stays [mm]
    double length;       // contour that is left out [mm]
    uint32_t first;      // count of the first one of them
    uint32_t last;
    uint32_t elements;   // how many
    double depth;        // the tool beside what is left out is so deep in another contour [mm]
    uint32_t of;         // count of the contour beside which it is
    uint32_t other;      // and of the one that it is in
} apart_t;

// The tool beside contour `of`: how deep is it in the others? Returns 1 if it is in none.
// Neighbours have no depth, for at a corner each is in the other.
static int is_clear(nck_toolcomp_t *self, apart_t *gap, uint32_t of, const double *point) {
    int clear = 1;
    for (uint32_t m = gap->from->of; m != gap->to->of + 1; m++) {
        const nck_comp_entry_t *const entry = nck_comp_at(self, m);
        if (m == of || !entry->moves || entry->enters || entry->rapid) continue;
        const double depth = self->radius - nck_shape_distance(&entry->contour, point);
        if (depth > -CLEAR) clear = 0;
        const int neighbours = nck_comp_next(self, m) == of || nck_comp_next(self, of) == m;
        if (depth <= gap->depth || neighbours) continue;
        gap->depth = depth;
        gap->of = of;
        gap->other = m;
    }
    return clear;
}

// Does the tool fit anywhere on a stretch of the piece beside contour `of`? Behind the first move,
// which is no contour, it may: where that leads in, the contour is cut short.
static int fits(nck_toolcomp_t *self, apart_t *gap, uint32_t of, const double *stretch) {
    nck_comp_piece_t piece;
    double point[2];
    nck_comp_piece(self, of, NCK_COMP_BESIDE, &piece);
    const double step = (stretch[1] - stretch[0]) / (double)PLACES;
    if (!(step > 0.0) || nck_comp_at(self, gap->from->of)->enters) return 0;
    for (int k = 0; k < PLACES; k++) {
        nck_shape_point(&piece.shape, stretch[0] + step * ((double)k + 0.5), point);
        if (is_clear(self, gap, of, point)) return 1;
    }
    return 0;
}

// The ends of both pieces that are cut off. Beside a rapid nothing is cut.
static int ends_fit(nck_toolcomp_t *self, apart_t *gap) {
    const nck_comp_piece_t *const from = gap->from;
    const nck_comp_piece_t *const to = gap->to;
    const nck_comp_entry_t *const entry = nck_comp_at(self, from->of);
    if (entry->rapid || nck_comp_at(self, to->of)->rapid) return 0;
    const double behind[2] = {entry->path[from->part].to, from->shape.length};
    const double before[2] = {0.0, nck_comp_at(self, to->of)->path[to->part].from};
    return (from->part == NCK_COMP_BESIDE && fits(self, gap, from->of, behind))
           || (to->part == NCK_COMP_BESIDE && fits(self, gap, to->of, before));
}

// How far a corner of the contour is from the path on both sides of the gap.
static double reach(const apart_t *gap, const double *point) {
    return nck_min(nck_shape_distance(&gap->side[0], point),
                   nck_shape_distance(&gap->side[1], point));
}

static nck_status_t fail(nck_toolcomp_t *self, apart_t *gap) {
    double end[2];
    if (!(gap->depth > 0.0)) { // in no other: then where the piece before would end
        nck_shape_point(&gap->from->shape, gap->from->shape.length, end);
        (void)is_clear(self, gap, gap->from->of, end);
    }
    if (!(gap->depth > 0.0) && gap->elements > 0) {
        const nck_shape_t *const contour = &nck_comp_at(self, gap->first)->contour;
        gap->depth = nck_max(self->radius - nck_shape_distance(contour, end), 0.0);
        gap->of = gap->from->of;
        gap->other = gap->first;
    }
    return nck_comp_fail(self, NCK_E_COMP_GOUGE, nck_comp_at(self, gap->of)->block.line,
                         gap->depth, (double)nck_comp_at(self, gap->other)->block.line);
}

static void tell(nck_toolcomp_t *self, const apart_t *gap) {
    const int told = self->note.left.code != 0 && self->note.left.value > gap->left;
    if (gap->elements == 0 || gap->left < NCK_COMP_CLOSE || told) return;
    const uint32_t lines[2] = {nck_comp_at(self, gap->first)->block.line,
                               nck_comp_at(self, gap->last)->block.line};
    self->note.left = (nck_diagnostic_t){NCK_NOTE_COMP_LEFT, lines[0], 0, 0, gap->left,
                                         (double)lines[1]};
}

// The path ends here for good: is it closed, and does the tool cut into where it began?
static nck_status_t judge_end(nck_toolcomp_t *self) {
    const nck_comp_entry_t *const entry = nck_comp_at(self, self->walk.piece.of);
    const nck_shape_t *const contour = &entry->contour;
    const double gap = nck_arc_norm(contour->q[0] - self->last.first[0],
                                    contour->q[1] - self->last.first[1]);
    const double above = nck_comp_height(self, entry->block.target_nm) - self->last.height;
    const int apart = gap > NCK_COMP_CLOSE || above > NCK_COMP_CLOSE;
    if (entry->enters || entry->rapid || apart) return NCK_OK;
    const double dip = nck_comp_dip(self, nck_comp_turn(self, self->last.tangent,
                                                        self->last.ahead));
    if (!(dip > NCK_COMP_CLOSE)) return NCK_OK;
    return nck_comp_fail(self, NCK_E_COMP_GOUGE, entry->block.line, dip, (double)self->last.begins);
}

// The elements from entry `of` up to `end` of which nothing is on the path. Returns 1 at one that
// the tool could touch.
static int leave_out(nck_toolcomp_t *self, apart_t *gap, uint32_t of, uint32_t end) {
    for (uint32_t m = of; m != end; m++) {
        const nck_comp_entry_t *const entry = nck_comp_at(self, m);
        const nck_shape_t *const contour = &entry->contour;
        nck_comp_piece_t piece;
        if (!entry->moves || entry->on[NCK_COMP_BESIDE]) continue;
        nck_comp_piece(self, m, NCK_COMP_BESIDE, &piece);
        const double all[2] = {0.0, piece.shape.length};
        const double far = nck_max(reach(gap, contour->p), reach(gap, contour->q));
        if (gap->elements == 0) gap->first = m;
        gap->last = m;
        gap->elements++;
        gap->left = nck_max(gap->left, far - self->radius);
        gap->length += contour->length;
        if (fits(self, gap, m, all)) return 1;
    }
    return 0;
}

nck_status_t nck_comp_judge(nck_toolcomp_t *self) {
    const nck_comp_piece_t *const piece = &self->walk.piece;
    const uint32_t behind = nck_comp_next(self, piece->of);
    const uint32_t first = piece->part == NCK_COMP_ABOUT ? piece->of : behind;
    nck_comp_piece_t next;
    const int lost = !nck_comp_following(self, piece, &next);
    if (lost) {
        if (first == self->ring.head) return self->closed ? judge_end(self) : NCK_OK;
        nck_comp_piece(self, self->last.count, NCK_COMP_BESIDE, &next);
    }
    apart_t gap;
    memset(&gap, 0, sizeof gap);
    gap.from = piece;
    gap.to = &next;
    gap.of = first;
    gap.other = first;
    nck_comp_on_path(self, piece, &gap.side[0]);
    nck_comp_on_path(self, &next, &gap.side[1]);
    const int ends = ends_fit(self, &gap);
    const uint32_t end = next.part == NCK_COMP_ABOUT && !lost ? next.of : next.of + 1;
    const int fit = ends || leave_out(self, &gap, piece->of, end);
    const int deep = nck_min(gap.left, gap.length) > self->radius;
    if (fit || deep || lost) return fail(self, &gap);
    tell(self, &gap);
    return NCK_OK;
}
