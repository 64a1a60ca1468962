// SPDX-License-Identifier: MIT
// Heights. What the tool is in, it cuts from its tip upwards: it passes above a contour that lies
// lower, and cuts through one that lies higher. Only in G17 does it stand upright on the plane; in
// G18 and G19 nobody says from which side it comes, and all contours are of one height.
#include "nck/prep/2_toolcomp/parts.h"

#include "nck/base/real.h" // nck_min nck_max nck_real_of

double nck_comp_height(const nck_toolcomp_t *self, const int64_t *place_nm) {
    return self->plane == 17 ? nck_comp_mm(place_nm[NCK_AXIS_Z]) : 0.0;
}

void nck_comp_wall(nck_toolcomp_t *self, uint32_t count, nck_comp_stretch_t *out) {
    const nck_comp_entry_t *const entry = nck_comp_at(self, count);
    out->shape = entry->contour;
    out->height[0] = entry->height;
    out->height[1] = nck_comp_height(self, entry->block.target_nm);
}

// How low is the path at most where it comes to an entry? It comes from the nearest contour before
// that is not left out; before the ring's first one it is where the tool is by now.
static double comes_from(nck_toolcomp_t *self, uint32_t count) {
    double height = nck_comp_at(self, count)->height;
    while (count != self->ring.tail) {
        const nck_comp_entry_t *const entry = nck_comp_at(self, --count);
        if (entry->moves && entry->on[NCK_COMP_BESIDE]) return height;
        if (entry->moves) height = nck_min(height, entry->height);
    }
    return nck_min(height, nck_comp_height(self, self->given_nm));
}

void nck_comp_stretch(nck_toolcomp_t *self, const nck_comp_piece_t *piece,
                      nck_comp_stretch_t *out) {
    const nck_comp_entry_t *const entry = nck_comp_at(self, piece->of);
    const nck_comp_span_t *const span = &entry->path[piece->part];
    const int turns = piece->part == NCK_COMP_ABOUT;
    nck_shape_part(&piece->shape, span->from, span->to, &out->shape);
    out->height[0] = comes_from(self, piece->of);
    out->height[1] = turns ? out->height[0] : nck_comp_height(self, entry->block.target_nm);
}

// The part of a stretch where there is room, which its ends have so much of; an end that is cut off
// keeps its height, which is further out than the part's other one. Returns where on the stretch it
// begins [mm], −1 if there is none.
static double cut(const nck_comp_stretch_t *self, const double *room, nck_comp_stretch_t *out) {
    const int out_of_it[2] = {room[0] < 0.0, room[1] < 0.0};
    *out = *self;
    if (out_of_it[0] && out_of_it[1]) return -1.0;
    if (!out_of_it[0] && !out_of_it[1]) return 0.0;
    const double place = self->shape.length * (room[0] / (room[0] - room[1]));
    const double from = out_of_it[0] ? place : 0.0;
    nck_shape_part(&self->shape, from, out_of_it[0] ? self->shape.length : place, &out->shape);
    return from;
}

double nck_comp_depth(const nck_toolcomp_t *self, const nck_comp_stretch_t *path,
                      const nck_comp_stretch_t *wall, nck_approach_t *at) {
    nck_comp_stretch_t low;
    nck_comp_stretch_t high;
    const double top = nck_max(wall->height[0], wall->height[1]);
    const double roof = top + NCK_COMP_CLOSE;
    const double below[2] = {roof - path->height[0], roof - path->height[1]};
    const double on_path = cut(path, below, &low);
    if (on_path < 0.0) return 0.0;
    const double floor = nck_min(top, nck_min(low.height[0], low.height[1])) - NCK_COMP_CLOSE;
    const double above[2] = {wall->height[0] - floor, wall->height[1] - floor};
    const double on_wall = cut(wall, above, &high); // the wall's top is in it
    nck_shape_approach(&low.shape, &high.shape, at);
    at->on_a += on_path;
    at->on_b += on_wall;
    const double depth = self->radius - at->gap;
    return depth > NCK_COMP_CLOSE ? depth : 0.0;
}
