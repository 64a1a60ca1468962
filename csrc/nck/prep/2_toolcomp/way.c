// SPDX-License-Identifier: MIT
// The ways to the contour and from it are as their type says, and nothing leads them around it:
// they are held against the contour, up to where it comes back to itself.
//
//              E                  E is beside V, where the contour begins, at R. Even if it goes
//            / |                  straight on there, the way is nearer to V than R before it
//     P ----/--V=======           is at E: by R(1 − L/√(L² + R²)), L = PV.
#include "nck/prep/2_toolcomp/parts.h"

#include "nck/base/arc_math.h" // nck_arc_norm

// How deep the tool is in the contour at worst: elsewhere, and about the place that the way is of.
typedef struct trespass {
    double reach;     // less far from it is about it [mm]
    double most[2];   // [mm]
    uint32_t line[2]; // of the contour
} trespass_t;

// A way and one of the contours. at: the place of the contour that it goes to or comes from.
static void look(nck_toolcomp_t *self, const nck_comp_stretch_t *way, const double *at,
                 uint32_t count, trespass_t *out) {
    const nck_comp_entry_t *const entry = nck_comp_at(self, count);
    nck_comp_stretch_t wall;
    nck_approach_t near;
    double point[2];
    if (nck_shape_are_far(&way->shape, &entry->contour, self->radius)) return;
    nck_comp_wall(self, count, &wall);
    const double depth = nck_comp_depth(self, way, &wall, &near);
    if (!(depth > 0.0)) return;
    nck_shape_point(&wall.shape, near.on_b, point);
    const int about = nck_arc_norm(point[0] - at[0], point[1] - at[1]) < out->reach;
    if (!(depth > out->most[about])) return;
    out->most[about] = depth;
    out->line[about] = entry->block.line;
}

// What the tool covers where it stands beside the place is the type's to say, and the control cuts
// it: a warning. The rest of the contour nobody meant to cut.
static nck_status_t tell(nck_toolcomp_t *self, uint32_t line, const trespass_t *found) {
    if (found->most[0] > 0.0) {
        const nck_status_t status = nck_comp_fail(self, NCK_E_COMP_GOUGE, line, found->most[0],
                                                  (double)found->line[0]);
        self->error.letter = 'G';
        return status;
    }
    if (found->most[1] > 0.0) {
        self->note.way = (nck_diagnostic_t){NCK_NOTE_COMP_WAY, line, 0, 0, found->most[1],
                                            (double)found->line[1]};
    }
    return NCK_OK;
}

nck_status_t nck_comp_way_to(nck_toolcomp_t *self) {
    const nck_comp_piece_t *const piece = &self->walk.piece;
    const nck_comp_entry_t *const entry = nck_comp_at(self, piece->of);
    nck_comp_stretch_t way;
    const double more = entry->crosses ? NCK_COMP_CLOSE : 0.0; // it begins as far away as R
    trespass_t found = {self->radius + more, {0.0, 0.0}, {0, 0}};
    double to[2];
    if (entry->rapid) return NCK_OK;
    nck_shape_point(&piece->shape, self->walk.until, to);
    if (piece->shape.radius > 0.0) nck_shape_part(&piece->shape, 0.0, self->walk.until, &way.shape);
    else nck_shape_line(self->at, to, &way.shape);
    way.height[0] = nck_comp_height(self, self->given_nm);
    way.height[1] = nck_comp_height(self, entry->block.target_nm);
    int ends = 0;
    for (uint32_t m = nck_comp_next(self, piece->of); m != self->ring.head && !ends;
         m = nck_comp_next(self, m)) {
        ends = nck_comp_at(self, m)->rapid;
        if (ends) continue;
        look(self, &way, self->last.first, m, &found);
        ends = nck_comp_at(self, m)->anew;
    }
    return tell(self, entry->block.line, &found);
}

nck_status_t nck_comp_way_from(nck_toolcomp_t *self, const nck_block_t *block,
                               const nck_comp_stretch_t *way, unsigned parts) {
    const uint32_t head = self->ring.head;
    const uint32_t taken = head - self->last.from;
    const uint32_t kept = taken < NCK_COMP_ROWS ? taken : NCK_COMP_ROWS - 1;
    const uint32_t last = self->last.count;
    trespass_t found = {self->radius, {0.0, 0.0}, {0, 0}};
    if (block->kind == NCK_BLOCK_RAPID || head - last > kept) return NCK_OK;
    const double *const at = nck_comp_at(self, last)->contour.q;
    for (uint32_t m = head; m != head - kept;) {
        const nck_comp_entry_t *const entry = nck_comp_at(self, --m);
        if (entry->rapid) break;
        if (!entry->moves || entry->enters) continue;
        for (unsigned k = 0; k < parts; k++) look(self, &way[k], at, m, &found);
        if (nck_comp_is_met(self, m)) break;
    }
    return tell(self, block->line, &found);
}
