// SPDX-License-Identifier: MIT
// The pieces of the centre's path.
//
//          _____J_____            the contour goes right of the path (G41); E: parallel to a line
//         /     |     \           or an arc, at R; J: about a corner that turns away from the tool
//    E   |      +------|---       At a corner that turns towards the tool two E cross.
//        |      |         E
#include "nck/prep/2_toolcomp/parts.h"

#include "nck/base/arc_math.h" // nck_arc_angle nck_arc_inner nck_arc_outer
#include "nck/base/real.h"     // nck_fabs nck_atan2

#define STRAIGHT 1e-9 // sine of the angle of a corner that turns nowhere, or right back

// The first move: a line has its parallel, which is only where it is left from; an arc goes from
// where the tool is to where its parallel ends, in the direction in which that ends.
int nck_comp_enter(const nck_toolcomp_t *self, const nck_shape_t *contour, nck_shape_t *out) {
    nck_shape_t beside;
    double tangent[2];
    const int any = nck_shape_parallel(contour, self->side * self->radius, &beside);
    if (!(contour->radius > 0.0)) {
        *out = beside;
        return any;
    }
    nck_shape_tangent(contour, contour->length, tangent);
    const double turn = nck_shape_turn(contour);
    const double to[2] = {self->at[0] - beside.q[0], self->at[1] - beside.q[1]};
    const double aside = turn * nck_arc_outer(tangent, to);
    if (!any || !(aside > 0.0)) return 0;
    const double radius = 0.5 * nck_arc_inner(to, to) / aside;
    const double arm[2] = {-turn * radius * tangent[1], turn * radius * tangent[0]};
    const double c[2] = {beside.q[0] + arm[0], beside.q[1] + arm[1]};
    const double angle = nck_arc_angle(-to[0], -to[1], arm[0] - to[0], arm[1] - to[1], turn);
    nck_shape_arc(self->at, beside.q, c, angle, out);
    return 1;
}

double nck_comp_turn(const nck_toolcomp_t *self, const double *before, const double *behind) {
    const double away = self->side * (before[1] * behind[0] - before[0] * behind[1]);
    const double ahead = before[0] * behind[0] + before[1] * behind[1];
    const double angle = nck_atan2(nck_fabs(away), ahead);
    return away < (ahead < 0.0 ? -STRAIGHT : 0.0) ? -angle : angle;
}

// The place beside a point of the contour that goes in a direction there.
static void stand_beside(const nck_toolcomp_t *self, const double *point, const double *tangent,
                         double *out) {
    const double left = self->side * self->radius;
    out[0] = point[0] - left * tangent[1];
    out[1] = point[1] + left * tangent[0];
}

static void about(const nck_toolcomp_t *self, const nck_comp_entry_t *entry, nck_shape_t *out) {
    const nck_shape_t *const contour = &entry->contour;
    double behind[2];
    double end[2][2];
    nck_shape_tangent(contour, 0.0, behind);
    stand_beside(self, contour->p, entry->tangent, end[0]);
    stand_beside(self, contour->p, behind, end[1]);
    const double turn = nck_comp_turn(self, entry->tangent, behind);
    nck_shape_arc(end[0], end[1], contour->p, -self->side * turn, out);
}

// The first move, and the one behind G40: straight between the programmed point and a place beside
// the contour.
static void way(const nck_toolcomp_t *self, const nck_comp_entry_t *entry, nck_shape_t *out) {
    const nck_shape_t *const contour = &entry->contour;
    double ahead[2];
    double ends[2][2];
    nck_shape_tangent(contour, 0.0, ahead);
    for (unsigned k = 0; k < 2; k++) {
        ends[0][k] = contour->p[k] - self->nose[k];
        ends[1][k] = contour->q[k] - self->nose[k];
    }
    if (entry->leaves) stand_beside(self, contour->p, ahead, ends[0]);
    else stand_beside(self, contour->q, entry->tangent, ends[1]);
    nck_shape_line(ends[0], ends[1], out);
}

void nck_comp_piece(nck_toolcomp_t *self, uint32_t count, nck_comp_part_t part,
                    nck_comp_piece_t *out) {
    const nck_comp_entry_t *const entry = nck_comp_at(self, count);
    out->of = count;
    out->part = (uint8_t)part;
    const int upright = entry->crosses || (entry->enters && self->start > NCK_COMP_START_RS274);
    if (part == NCK_COMP_ABOUT) about(self, entry, &out->shape);
    else if (upright || entry->leaves) way(self, entry, &out->shape);
    else if (entry->enters) (void)nck_comp_enter(self, &entry->contour, &out->shape);
    else (void)nck_shape_parallel(&entry->contour, self->side * self->radius, &out->shape);
}

void nck_comp_on_path(nck_toolcomp_t *self, const nck_comp_piece_t *piece, nck_shape_t *out) {
    const nck_comp_span_t *const span = &nck_comp_at(self, piece->of)->path[piece->part];
    nck_shape_part(&piece->shape, span->from, span->to, out);
}

int nck_comp_following(nck_toolcomp_t *self, const nck_comp_piece_t *piece, nck_comp_piece_t *out) {
    uint32_t count = piece->of;
    int part = piece->part + 1;
    while (count != self->ring.head) {
        const nck_comp_entry_t *const entry = nck_comp_at(self, count);
        for (; part < NCK_COMP_PARTS; part++) {
            if (!entry->on[part]) continue;
            nck_comp_piece(self, count, (nck_comp_part_t)part, out);
            return 1;
        }
        count = nck_comp_next(self, count);
        part = 0;
    }
    return 0;
}
