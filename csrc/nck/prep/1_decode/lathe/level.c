// SPDX-License-Identifier: MIT
// What of a straight cut lies clear of a contour: the geometry of roughing.
//
//      d │        ╭─ contour        The tool comes from above. A place is taken if a point of the
//        │  h ────┤·········        contour lies above it, or nearer than the distance to keep: of
//        └────────────────▶ a       every part that rises or falls all along it is one stretch.
#include "nck/prep/1_decode/lathe/level.h"
#include "nck/prep/1_decode/lathe/lathe.h"
#include "nck/base/arc_math.h" // nck_arc_inner nck_arc_norm nck_arc_outer
#include "nck/base/real.h" // nck_sqrt …
#include "nck/base/trig.h" // nck_atan2

static const double tiny = 5e-7;   // [mm] half of what a position can tell
static const double short_cut = 1e-3; // [mm] not worth a pass
static const double far_off = 1e9;

// The place of a machine position: [0] along a, [1] along d.
static void place_of(const nck_decode_t *self, const int64_t *at_nm, double *out) {
    static const uint8_t axes[2] = {NCK_AXIS_X, NCK_AXIS_Z};
    const nck_rough_t *const rough = &self->held.rough;
    for (unsigned k = 0; k < 2; k++) {
        const unsigned axis = k == 0 ? rough->along : 1u - rough->along;
        const int64_t way_nm = at_nm[axis] - self->held.contour.start_nm[axes[axis]];
        out[k] = (double)rough->sign[k] * (nck_real_of(way_nm) / 1e6 + rough->shift_mm[axis]);
    }
}

// The same of an arc's centre.
static void centre_of(const nck_decode_t *self, const nck_element_t *element, double *out) {
    static const uint8_t axes[2] = {NCK_AXIS_X, NCK_AXIS_Z};
    const nck_rough_t *const rough = &self->held.rough;
    for (unsigned k = 0; k < 2; k++) {
        const unsigned axis = k == 0 ? rough->along : 1u - rough->along;
        const double start_mm = nck_real_of(self->held.contour.start_nm[axes[axis]]) / 1e6;
        out[k] = (double)rough->sign[k]
                 * (element->centre_mm[axis] - start_mm + rough->shift_mm[axis]);
    }
}

double nck_level_turn(const nck_decode_t *self, double sweep) {
    const nck_rough_t *const rough = &self->held.rough;
    const int same = rough->sign[0] == rough->sign[1];
    return (sweep > 0.0) == (same == (rough->along == 1)) ? 1.0 : -1.0;
}

// The angle from a vector to another one in the sense of turn, 0 … 2π.
static double angle_to(const double *from, const double *to, double turn) {
    const double angle = turn * nck_atan2(nck_arc_outer(from, to), nck_arc_inner(from, to));
    return angle < 0.0 ? angle + 2.0 * NCK_PI : angle;
}

// The direction of the circle's next extreme behind a vector; k more quarters on.
static void extreme(const double *from, double turn, unsigned k, double *out) {
    static const int8_t quarter[4][2] = {{1, 0}, {0, 1}, {-1, 0}, {0, -1}};
    const double u = from[0], v = turn * from[1];
    unsigned next = 0;
    if (u > 0.0 && v >= 0.0) next = 1;
    else if (u <= 0.0 && v > 0.0) next = 2;
    else if (u < 0.0) next = 3;
    out[0] = quarter[(next + k) % 4][0];
    out[1] = turn * quarter[(next + k) % 4][1];
}

// Where part k of an arc begins: 0 its start, behind it one extreme after the other, then the end.
// Returns 0 if there is no such place.
static int border(const nck_slant_t *arc, double sweep, unsigned k, double *out) {
    const double from[2] = {arc->a[0] - arc->ca, arc->d[0] - arc->cd};
    const double most = nck_fabs(sweep) - 1e-9;
    double way[2];
    out[0] = arc->a[0];
    out[1] = arc->d[0];
    if (k == 0) return 1;
    extreme(from, arc->turn, 0, way);
    const double first = angle_to(from, way, arc->turn);
    if (first + 0.5 * NCK_PI * (double)(k - 1) < most) {
        extreme(from, arc->turn, k - 1, way);
        out[0] = arc->ca + arc->r * way[0];
        out[1] = arc->cd + arc->r * way[1];
        return 1;
    }
    out[0] = arc->a[1];
    out[1] = arc->d[1];
    return k == 1 || first + 0.5 * NCK_PI * (double)(k - 2) < most;
}

int nck_level_slant(const nck_decode_t *self, uint32_t element, unsigned part, nck_slant_t *out) {
    if (!NCK_HAS_CONTOUR) return 0;
    const nck_element_t *const now = &self->held.contour.element[element];
    double from[2], to[2];
    place_of(self, self->held.contour.element[element - 1].to_nm, from);
    place_of(self, now->to_nm, to);
    *out = (nck_slant_t){{from[0], to[0]}, {from[1], to[1]}, 0.0, 0.0, 0.0, 1.0};
    if (now->sweep_rad == 0.0) return part == 0;
    double centre[2];
    centre_of(self, now, centre);
    out->ca = centre[0];
    out->cd = centre[1];
    out->r = nck_arc_norm(from[0] - centre[0], from[1] - centre[1]);
    out->turn = nck_level_turn(self, now->sweep_rad);
    double ends[2][2];
    const int has = border(out, now->sweep_rad, part, ends[0])
                    && border(out, now->sweep_rad, part + 1, ends[1]);
    for (unsigned k = 0; k < 2; k++) {
        out->a[k] = ends[k][0];
        out->d[k] = ends[k][1];
    }
    return has;
}

double nck_level_at(const nck_slant_t *slant, double d) {
    const double low = nck_min(slant->a[0], slant->a[1]), high = nck_max(slant->a[0], slant->a[1]);
    const double rise = slant->d[1] - slant->d[0];
    double a = slant->a[0];
    if (slant->r > 0.0) {
        const double side = slant->a[0] + slant->a[1] >= 2.0 * slant->ca ? 1.0 : -1.0;
        const double under = slant->r * slant->r - (d - slant->cd) * (d - slant->cd);
        a = slant->ca + side * nck_sqrt(nck_max(under, 0.0));
    } else if (rise != 0.0) {
        a += (d - slant->d[0]) / rise * (slant->a[1] - slant->a[0]);
    }
    return nck_min(nck_max(a, low), high);
}

// A point of the contour takes what is nearer than `spare` to it, at a height.
static void take_point(double a, double d, double height, double spare, double *stretch) {
    const double under = nck_max(height - d, 0.0);
    if (under > spare + tiny) return;
    const double wide = nck_sqrt(nck_max(spare * spare - under * under, 0.0));
    stretch[0] = nck_min(stretch[0], a - wide);
    stretch[1] = nck_max(stretch[1], a + wide);
}

// The stretch of a height that a slant takes; 0: none. Its ends come from the slant's own ends,
// from where the slant crosses the height or leaves its reach, or from where the line to the place
// stands upright on the slant.
static int taken(const nck_slant_t *slant, double height, double spare, double *stretch) {
    const double low = nck_min(slant->d[0], slant->d[1]), high = nck_max(slant->d[0], slant->d[1]);
    double at[4] = {height, height - spare, height, height};
    stretch[0] = far_off;
    stretch[1] = -far_off;
    if (high + spare <= height + tiny) return 0;
    if (slant->r > 0.0) {
        const double above = height - slant->cd, inner = slant->r - spare;
        at[2] = slant->cd + above * slant->r / (slant->r + spare);
        if (nck_fabs(inner) > tiny) at[3] = slant->cd + above * slant->r / inner;
    } else {
        const double along = slant->a[1] - slant->a[0], rise = slant->d[1] - slant->d[0];
        const double length = nck_arc_norm(along, rise);
        if (length > 0.0) at[2] = height - spare * nck_fabs(along) / length;
    }
    take_point(slant->a[0], slant->d[0], height, spare, stretch);
    take_point(slant->a[1], slant->d[1], height, spare, stretch);
    for (unsigned k = 0; k < 4; k++) {
        if (at[k] <= low || at[k] >= high) continue;
        take_point(nck_level_at(slant, at[k]), at[k], height, spare, stretch);
    }
    return stretch[0] <= stretch[1];
}

// Below the contour's first point the cut cannot come from the side: what lies before it is none of
// the contour's.
static double first_place(const nck_decode_t *self, double height) {
    double begin[2];
    place_of(self, self->held.contour.element[0].to_nm, begin);
    return height < begin[1] + self->held.rough.spare - tiny ? nck_max(begin[0], 0.0) : 0.0;
}

// From a place on, the first one that nothing takes.
static double clear_place(const nck_decode_t *self, double height, double from) {
    nck_slant_t slant;
    double stretch[2];
    int moved = 1;
    while (moved) {
        moved = 0;
        for (uint32_t k = 1; k < self->held.contour.count; k++) {
            for (unsigned part = 0; nck_level_slant(self, k, part, &slant); part++) {
                if (!taken(&slant, height, self->held.rough.spare, stretch)) continue;
                if (stretch[0] > from + tiny || stretch[1] <= from + tiny) continue;
                from = stretch[1];
                moved = 1;
            }
        }
    }
    return from;
}

// From a clear place on, where the next stretch begins that is taken.
static double next_taken(const nck_decode_t *self, double height, double from) {
    nck_slant_t slant;
    double stretch[2], end = far_off;
    for (uint32_t k = 1; k < self->held.contour.count; k++) {
        for (unsigned part = 0; nck_level_slant(self, k, part, &slant); part++) {
            if (!taken(&slant, height, self->held.rough.spare, stretch)) continue;
            if (stretch[1] > from + tiny && stretch[0] < end) end = stretch[0];
        }
    }
    return end;
}

int nck_level_clear(const nck_decode_t *self, double height, double *begin, double *end) {
    if (!NCK_HAS_CONTOUR) return 0;
    const double reach = self->held.rough.reach;
    double from = nck_max(*begin, first_place(self, height));
    for (;;) { // every turn passes at least one slant
        from = clear_place(self, height, from);
        if (from > reach - short_cut) return 0;
        const double to = nck_min(next_taken(self, height, from), reach);
        if (to - from >= short_cut) {
            *begin = from;
            *end = to;
            return 1;
        }
        from = to + 2.0 * tiny;
    }
}

int nck_level_passes(const nck_decode_t *self, double height, double from, double to) {
    if (!NCK_HAS_CONTOUR) return 0;
    const double begin = nck_min(from, to), end = nck_max(from, to);
    if (clear_place(self, height, begin) > begin + 2.0 * tiny) return 0;
    return next_taken(self, height, begin + tiny) >= end - 2.0 * tiny;
}

void nck_level_place(const nck_decode_t *self, uint32_t element, double *out) {
    place_of(self, self->held.contour.element[element].to_nm, out);
}

void nck_level_heading(const nck_decode_t *self, uint32_t element, unsigned end, double *out) {
    if (!NCK_HAS_CONTOUR) return;
    nck_slant_t slant, next;
    (void)nck_level_slant(self, element, 0, &slant);
    for (unsigned k = 1; end == 1 && nck_level_slant(self, element, k, &next); k++) slant = next;
    out[0] = slant.a[1] - slant.a[0];
    out[1] = slant.d[1] - slant.d[0];
    if (slant.r > 0.0) {
        out[0] = -slant.turn * (slant.d[end] - slant.cd);
        out[1] = slant.turn * (slant.a[end] - slant.ca);
    }
    const double length = nck_arc_norm(out[0], out[1]);
    for (unsigned k = 0; k < 2 && length > 0.0; k++) out[k] /= length;
}
