// SPDX-License-Identifier: MIT
// Where a piece of the path is left: at its end, or before it, where it would come nearer to a
// contour that follows than the tool is large. That is where it crosses the piece of that contour
// towards the tool; of two such places in one the later contour counts (Liu et al. 2007).
#include "nck/prep/2_toolcomp/parts.h"

#define ONE_PLACE 1e-6 // [mm] places nearer to one another are one
#define TOWARDS 1e-9   // sine of an angle that turns towards the tool

// The best place so far.
typedef struct search {
    double least;    // where on the piece [mm]
    uint32_t beside; // the contour that the piece ends at; pieces that touch there do not cross
} search_t;

double nck_comp_on_contour(nck_toolcomp_t *self, const nck_comp_piece_t *piece, double along) {
    const nck_comp_entry_t *const entry = nck_comp_at(self, piece->of);
    if (piece->joins) return entry->s;
    return entry->s + entry->contour.length * (along / piece->shape.length);
}

static int turns_towards(const nck_toolcomp_t *self, const nck_comp_piece_t *other,
                         const nck_meeting_t *at) {
    double in[2];
    double out[2];
    nck_shape_tangent(&self->walk.piece.shape, at->on_a, in);
    nck_shape_tangent(&other->shape, at->on_b, out);
    return self->side * (in[0] * out[1] - in[1] * out[0]) > TOWARDS;
}

// Is the path to be left at this place for the other piece?
static int is_cut(nck_toolcomp_t *self, const search_t *search, const nck_comp_piece_t *other,
                  const nck_meeting_t *at) {
    const nck_comp_piece_t *const piece = &self->walk.piece;
    const int neighbours = other->of == search->beside && !other->joins;
    if (!(at->on_a > self->walk.along) || !(at->on_a < search->least + ONE_PLACE)) return 0;
    if (neighbours && piece->shape.length - at->on_a < ONE_PLACE && at->on_b < ONE_PLACE) return 0;
    if (!turns_towards(self, other, at)) return 0;
    return neighbours || nck_comp_relates(self, nck_comp_on_contour(self, piece, at->on_a),
                                          nck_comp_on_contour(self, other, at->on_b));
}

static void look_at(nck_toolcomp_t *self, search_t *search, const nck_comp_piece_t *other) {
    nck_meeting_t at[2];
    const unsigned count = nck_shape_cross(&self->walk.piece.shape, &other->shape, at);
    for (unsigned k = 0; k < count; k++) {
        if (!is_cut(self, search, other, &at[k])) continue;
        search->least = at[k].on_a;
        self->walk.jumps = 1;
        self->walk.until = at[k].on_a;
        self->walk.on_next = at[k].on_b;
        self->walk.next = *other;
    }
}

void nck_comp_find_cut(nck_toolcomp_t *self) {
    const nck_comp_piece_t *const piece = &self->walk.piece;
    const uint32_t first = nck_comp_next(self, piece->of);
    const nck_shape_t *before = &nck_comp_at(self, piece->of)->contour;
    const int rapid = nck_comp_at(self, piece->of)->rapid;
    search_t search = {piece->shape.length, piece->joins ? piece->of : first};
    nck_comp_piece_t other;
    self->walk.jumps = 0;
    self->walk.until = piece->shape.length;
    for (uint32_t m = first; m != self->ring.head; m = nck_comp_next(self, m)) {
        const nck_comp_entry_t *const entry = nck_comp_at(self, m);
        if (m != first && (rapid || entry->rapid)) return;
        double tangent[2];
        nck_shape_tangent(before, before->length, tangent);
        const int attached = m == first && !piece->joins;
        if (!attached && nck_comp_about(self, m, tangent, &other)) look_at(self, &search, &other);
        nck_comp_beside(self, m, &other);
        look_at(self, &search, &other);
        if (entry->rapid) return;
        before = &entry->contour;
    }
}
