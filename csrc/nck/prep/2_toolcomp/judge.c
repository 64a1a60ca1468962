// SPDX-License-Identifier: MIT
// Is the path good: clear of the contours that follow, and what does a cut leave out?
#include "nck/prep/2_toolcomp/parts.h"

#include "nck/base/real.h" // nck_min nck_max

enum { PLACES = 8 }; // of a piece are looked at
#define CLOSE 1e-3 // [mm] a path that comes so much too near is good, and less material is not told
#define CLEAR 1e-5 // [mm] a tool that is nearer does not fit

// How deep the tool is in a contour at worst.
typedef struct depth {
    double most;    // [mm]
    uint32_t of;    // count of the contour beside which it is
    uint32_t other; // and of the one that it is in
} depth_t;

static nck_status_t fail(nck_toolcomp_t *self, const depth_t *depth) {
    return nck_comp_fail(self, NCK_E_COMP_GOUGE, nck_comp_at(self, depth->of)->block.line,
                         depth->most, (double)nck_comp_at(self, depth->other)->block.line);
}

// ---- the path itself

// The tool at a point of the piece in work, so far along.
static void hold_point(nck_toolcomp_t *self, const double *point, double along, depth_t *worst) {
    const uint32_t of = self->walk.piece.of;
    const double s = nck_comp_on_contour(self, &self->walk.piece, along);
    for (uint32_t m = nck_comp_next(self, of); m != self->ring.head; m = nck_comp_next(self, m)) {
        const nck_comp_entry_t *const entry = nck_comp_at(self, m);
        if (entry->rapid) return;
        const double depth = self->radius - nck_shape_distance(&entry->contour, point);
        if (!(depth > nck_max(worst->most, CLOSE))) continue;
        const double nearest = entry->s + nck_shape_along(&entry->contour, point);
        if (!nck_comp_relates(self, s, nck_max(nearest, entry->s))) continue;
        *worst = (depth_t){depth, of, m};
    }
}

nck_status_t nck_comp_hold(nck_toolcomp_t *self) {
    const nck_comp_piece_t *const piece = &self->walk.piece;
    const nck_comp_entry_t *const entry = nck_comp_at(self, piece->of);
    const double until = self->walk.until;
    depth_t worst = {0.0, 0, 0};
    double point[2];
    double end[2];
    if (entry->rapid) return NCK_OK;
    nck_shape_point(&piece->shape, until, end);
    nck_shape_point(&piece->shape, 0.5 * (self->walk.along + until), point);
    if (entry->enters && !piece->joins && !(piece->shape.radius > 0.0)) {
        point[0] = 0.5 * (self->at[0] + end[0]);
        point[1] = 0.5 * (self->at[1] + end[1]);
    }
    hold_point(self, point, 0.5 * (self->walk.along + until), &worst);
    hold_point(self, end, until, &worst);
    return worst.most > CLOSE ? fail(self, &worst) : NCK_OK;
}

// ---- what is left out

// The tool beside contour `of`: how deep is it in the others? Returns 1 if it is in none. deepest:
// neighbours do not count, for at a corner each is in the other.
static int is_clear(nck_toolcomp_t *self, uint32_t of, const double *point, depth_t *deepest) {
    int clear = 1;
    for (uint32_t m = nck_comp_oldest(self); m != self->ring.head; m++) {
        const nck_comp_entry_t *const entry = nck_comp_at(self, m);
        if (m == of || !entry->moves || entry->enters || entry->rapid) continue;
        const double depth = self->radius - nck_shape_distance(&entry->contour, point);
        if (depth > -CLEAR) clear = 0;
        const int neighbours = nck_comp_next(self, m) == of || nck_comp_next(self, of) == m;
        if (depth > deepest->most && !neighbours) *deepest = (depth_t){depth, of, m};
    }
    return clear;
}

// Does the tool fit anywhere on a stretch of the piece beside contour `of` that is left out? Behind
// the first move it may: that one is no contour, and where it leads in the contour is cut short.
static int fits(nck_toolcomp_t *self, uint32_t of, double from, depth_t *deepest) {
    nck_comp_piece_t piece;
    double point[2];
    if (nck_comp_at(self, self->walk.piece.of)->enters) return 0;
    nck_comp_beside(self, of, &piece);
    const double step = (piece.shape.length - from) / (double)PLACES;
    for (int k = 0; k < PLACES; k++) {
        nck_shape_point(&piece.shape, from + step * ((double)k + 0.5), point);
        if (is_clear(self, of, point, deepest)) return 1;
    }
    return 0;
}

// How far a corner of the contour is from the path on both sides of the cut.
static double reach(const nck_shape_t *sides, const double *point) {
    return nck_min(nck_shape_distance(&sides[0], point), nck_shape_distance(&sides[1], point));
}

static void tell(nck_toolcomp_t *self, uint32_t first, uint32_t last, double left) {
    if (left < CLOSE || (self->note.code != 0 && self->note.value > left)) return;
    const uint32_t lines[2] = {nck_comp_at(self, first)->block.line,
                               nck_comp_at(self, last)->block.line};
    self->note = (nck_diagnostic_t){NCK_NOTE_COMP_LEFT, lines[0], 0, 0, left, (double)lines[1]};
}

// The path on both sides of the cut.
static void sides_of(nck_toolcomp_t *self, nck_shape_t *sides_out) {
    const nck_comp_piece_t *const next = &self->walk.next;
    nck_shape_part(&self->walk.piece.shape, self->walk.along, self->walk.until, &sides_out[0]);
    nck_shape_part(&next->shape, self->walk.on_next, next->shape.length, &sides_out[1]);
}

nck_status_t nck_comp_judge(nck_toolcomp_t *self) {
    const nck_comp_piece_t *const piece = &self->walk.piece;
    const uint32_t to = self->walk.next.of;
    const uint32_t first = piece->joins ? piece->of : nck_comp_next(self, piece->of);
    depth_t deepest = {0.0, first, to};
    nck_shape_t sides[2];
    uint32_t last = first;
    double left = 0.0;
    if (first == to) return NCK_OK;
    sides_of(self, sides);
    int fit = !piece->joins && fits(self, piece->of, self->walk.until, &deepest);
    for (uint32_t m = first; m != to && !fit; m = nck_comp_next(self, m)) {
        const nck_shape_t *const contour = &nck_comp_at(self, m)->contour;
        fit = fits(self, m, 0.0, &deepest);
        left = nck_max(left, nck_max(reach(sides, contour->p), reach(sides, contour->q)));
        last = m;
    }
    if (fit) return fail(self, &deepest);
    tell(self, first, last, left - self->radius);
    return NCK_OK;
}
