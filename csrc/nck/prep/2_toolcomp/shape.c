// SPDX-License-Identifier: MIT
// Lines and arcs in a plane, and how they meet.
#include "nck/prep/2_toolcomp/shape.h"

#include <string.h> // memcpy memset

#include "nck/base/arc_math.h" // nck_arc_inner nck_arc_norm NCK_PI …
#include "nck/base/real.h"     // NCK_APART nck_sqrt nck_fabs nck_min nck_floor

#define ROUNDING 1e-6  // [mm] a place so little before the beginning, or behind the end, is on it
#define PARALLEL 1e-12 // sine of the angle between lines that do not cross
#define SMALLEST 1e-6  // [mm] radius of an arc

static double way(const double *from, const double *to, double *out) {
    out[0] = to[0] - from[0];
    out[1] = to[1] - from[1];
    return nck_arc_norm(out[0], out[1]);
}

NCK_APART double nck_shape_turn(const nck_shape_t *self) {
    return self->sweep < 0.0 ? -1.0 : 1.0;
}

void nck_shape_line(const double *p, const double *q, nck_shape_t *out) {
    double along[2];
    memset(out, 0, sizeof *out);
    memcpy(out->p, p, sizeof out->p);
    memcpy(out->q, q, sizeof out->q);
    out->length = way(p, q, along);
}

void nck_shape_arc(const double *p, const double *q, const double *c, double sweep,
                   nck_shape_t *out) {
    double from[2];
    nck_shape_line(p, q, out);
    out->c[0] = c[0];
    out->c[1] = c[1];
    out->radius = way(c, p, from);
    out->sweep = sweep;
    out->length = out->radius * nck_fabs(sweep);
}

void nck_shape_point(const nck_shape_t *self, double along, double *out) {
    double arm[2];
    if (!(self->radius > 0.0)) {
        const double share = self->length > 0.0 ? along / self->length : 0.0;
        for (unsigned k = 0; k < 2; k++) out[k] = self->p[k] + share * (self->q[k] - self->p[k]);
        return;
    }
    (void)way(self->c, self->p, arm);
    double sine, cosine;
    nck_sincos(nck_shape_turn(self) * along / self->radius, &sine, &cosine);
    out[0] = self->c[0] + arm[0] * cosine - arm[1] * sine;
    out[1] = self->c[1] + arm[0] * sine + arm[1] * cosine;
}

void nck_shape_tangent(const nck_shape_t *self, double along, double *out) {
    if (!(self->radius > 0.0)) {
        const double length = way(self->p, self->q, out);
        out[0] /= length;
        out[1] /= length;
        return;
    }
    double point[2];
    double arm[2];
    nck_shape_point(self, along, point);
    const double per_radius = nck_shape_turn(self) / way(self->c, point, arm);
    out[0] = -arm[1] * per_radius;
    out[1] = arm[0] * per_radius;
}

// How far along an arc's circle a point in the direction of the arm is, from 0 up to a turn; a
// little before the beginning is less than 0.
static double along_arc(const nck_shape_t *self, const double *arm) {
    double from[2];
    (void)way(self->c, self->p, from);
    const double turn = nck_shape_turn(self);
    double angle = nck_atan2(turn * nck_arc_outer(from, arm), nck_arc_inner(from, arm));
    if (angle < 0.0) angle += 2.0 * NCK_PI;
    const double along = angle * self->radius;
    const double before = along - 2.0 * NCK_PI * self->radius;
    return along > self->length + ROUNDING && before > -ROUNDING ? before : along;
}

double nck_shape_distance(const nck_shape_t *self, const double *point) {
    double from[2];
    double to[2];
    const double ends = nck_min(way(self->p, point, from), way(self->q, point, to));
    if (self->radius > 0.0) {
        double arm[2];
        const double reach = way(self->c, point, arm);
        return along_arc(self, arm) <= self->length ? nck_fabs(reach - self->radius) : ends;
    }
    double along[2];
    const double length = way(self->p, self->q, along);
    const double foot = nck_arc_inner(from, along);
    if (!(foot > 0.0 && foot < length * length)) return ends;
    return nck_fabs(nck_arc_outer(along, from)) / length;
}

double nck_shape_along(const nck_shape_t *self, const double *point) {
    double arm[2];
    if (!(self->radius > 0.0)) {
        double along[2];
        const double length = way(self->p, self->q, along);
        (void)way(self->p, point, arm);
        return length > 0.0 ? nck_arc_inner(arm, along) / length : 0.0;
    }
    (void)way(self->c, point, arm);
    return along_arc(self, arm);
}

void nck_shape_part(const nck_shape_t *self, double from, double to, nck_shape_t *out) {
    double p[2];
    double q[2];
    nck_shape_point(self, from, p);
    nck_shape_point(self, to, q);
    if (!(self->radius > 0.0)) {
        nck_shape_line(p, q, out);
        return;
    }
    nck_shape_arc(p, q, self->c, self->sweep * ((to - from) / self->length), out);
}

int nck_shape_parallel(const nck_shape_t *self, double left, nck_shape_t *out) {
    const double ends[2] = {0.0, self->length};
    double point[2][2];
    for (unsigned k = 0; k < 2; k++) {
        double tangent[2];
        nck_shape_tangent(self, ends[k], tangent);
        const double *const end = k == 0 ? self->p : self->q;
        point[k][0] = end[0] - left * tangent[1];
        point[k][1] = end[1] + left * tangent[0];
    }
    if (!(self->radius > 0.0)) {
        nck_shape_line(point[0], point[1], out);
        return 1;
    }
    nck_shape_arc(point[0], point[1], self->c, self->sweep, out);
    return self->radius - nck_shape_turn(self) * left > SMALLEST;
}

static int is_on(const nck_shape_t *self, double along) {
    return along >= -ROUNDING && along <= self->length + ROUNDING;
}

// Add a point of both circles or lines, if it is on both shapes.
static unsigned add(const nck_shape_t *a, const nck_shape_t *b, const double *point,
                    nck_meeting_t *out) {
    double on_a = nck_shape_along(a, point);
    double on_b = nck_shape_along(b, point);
    if (!is_on(a, on_a) || !is_on(b, on_b)) return 0;
    if (a->radius > 0.0) {
        const double turn = 2.0 * NCK_PI * a->radius;
        on_a += turn * nck_floor((a->length + ROUNDING - on_a) / turn);
    }
    const double turn = 2.0 * NCK_PI * b->radius; // of a line 0
    if (on_b - turn > -ROUNDING) on_b -= turn;
    *out = (nck_meeting_t){on_a, on_b};
    return 1;
}

static unsigned line_with_line(const nck_shape_t *a, const nck_shape_t *b, nck_meeting_t *out) {
    double u[2];
    double v[2];
    double between[2];
    const double lengths = way(a->p, a->q, u) * way(b->p, b->q, v);
    const double sine = nck_arc_outer(u, v);
    if (!(nck_fabs(sine) > PARALLEL * lengths)) return 0;
    (void)way(a->p, b->p, between);
    const double share = nck_arc_outer(between, v) / sine;
    const double point[2] = {a->p[0] + share * u[0], a->p[1] + share * u[1]};
    return add(a, b, point, out);
}

// base: the foot of a centre on the line that both points lie on; along: its direction.
static unsigned both_sides(const nck_shape_t *a, const nck_shape_t *b, const double *base,
                           const double *along, nck_meeting_t *out) {
    static const double side[2] = {-1.0, 1.0};
    unsigned count = 0;
    for (unsigned k = 0; k < 2; k++) {
        const double point[2] = {base[0] + side[k] * along[0], base[1] + side[k] * along[1]};
        count += add(a, b, point, out + count);
    }
    return count;
}

// swapped: a is the arc.
static unsigned line_with_arc(const nck_shape_t *a, const nck_shape_t *b, int swapped,
                              nck_meeting_t *out) {
    const nck_shape_t *const line = swapped ? b : a;
    const nck_shape_t *const arc = swapped ? a : b;
    double along[2];
    double to[2];
    const double length = way(line->p, line->q, along);
    if (!(length > 0.0)) return 0;
    (void)way(line->p, arc->c, to);
    const double aside = nck_arc_outer(along, to) / length;
    const double rest = (arc->radius - aside) * (arc->radius + aside);
    if (!(rest > 0.0)) return 0;
    const double foot = nck_arc_inner(along, to) / (length * length);
    const double half = nck_sqrt(rest) / length;
    const double base[2] = {line->p[0] + foot * along[0], line->p[1] + foot * along[1]};
    const double step[2] = {half * along[0], half * along[1]};
    return both_sides(a, b, base, step, out);
}

static unsigned arc_with_arc(const nck_shape_t *a, const nck_shape_t *b, nck_meeting_t *out) {
    double between[2];
    const double gap = way(a->c, b->c, between);
    if (!(gap > SMALLEST)) return 0;
    const double squares = (a->radius - b->radius) * (a->radius + b->radius);
    const double foot = 0.5 * (gap + squares / gap);
    const double rest = (a->radius - foot) * (a->radius + foot);
    if (!(rest > 0.0)) return 0;
    const double half = nck_sqrt(rest) / gap;
    const double base[2] = {a->c[0] + foot / gap * between[0], a->c[1] + foot / gap * between[1]};
    const double step[2] = {-half * between[1], half * between[0]};
    return both_sides(a, b, base, step, out);
}

unsigned nck_shape_cross(const nck_shape_t *a, const nck_shape_t *b, nck_meeting_t *out) {
    const int a_bends = a->radius > 0.0;
    const int b_bends = b->radius > 0.0;
    if (a_bends && b_bends) return arc_with_arc(a, b, out);
    if (a_bends || b_bends) return line_with_arc(a, b, a_bends, out);
    return line_with_line(a, b, out);
}

// The middle of a circle about a shape. Returns its radius.
static double circle_about(const nck_shape_t *self, double *middle) {
    const int bends = self->radius > 0.0;
    for (unsigned k = 0; k < 2; k++) {
        middle[k] = bends ? self->c[k] : 0.5 * (self->p[k] + self->q[k]);
    }
    return bends ? self->radius : 0.5 * self->length;
}

int nck_shape_are_far(const nck_shape_t *a, const nck_shape_t *b, double distance) {
    double middle[2][2];
    const double reach = circle_about(a, middle[0]) + circle_about(b, middle[1]) + distance;
    const double between[2] = {middle[1][0] - middle[0][0], middle[1][1] - middle[0][1]};
    return nck_arc_inner(between, between) > reach * reach;
}

// How far along the shape's nearest point to this one is.
static double nearest(const nck_shape_t *self, const double *point) {
    const double along = nck_shape_along(self, point);
    double arm[2];
    if (along >= 0.0 && along <= self->length) return along;
    return way(self->p, point, arm) < way(self->q, point, arm) ? 0.0 : self->length;
}

// From a place of one shape to the other one.
static nck_approach_t approach_at(const nck_shape_t *a, double on_a, const nck_shape_t *b) {
    double point[2];
    nck_shape_point(a, on_a, point);
    return (nck_approach_t){nck_shape_distance(b, point), on_a, nearest(b, point)};
}

// From the ends of one shape, and from its point nearest to an arc's centre, to the other one: two
// circles that do not cross are nearest on the line through their centres.
static void approach_from(const nck_shape_t *a, const nck_shape_t *b, nck_approach_t *out) {
    const double further[2] = {a->length, b->radius > 0.0 ? nearest(a, b->c) : a->length};
    *out = approach_at(a, 0.0, b);
    for (unsigned k = 0; k < 2; k++) {
        const nck_approach_t at = approach_at(a, further[k], b);
        if (at.gap < out->gap) *out = at;
    }
}

void nck_shape_approach(const nck_shape_t *a, const nck_shape_t *b, nck_approach_t *out) {
    nck_meeting_t at[2];
    nck_approach_t back;
    approach_from(a, b, out);
    approach_from(b, a, &back);
    if (back.gap < out->gap) *out = (nck_approach_t){back.gap, back.on_b, back.on_a};
    if (nck_shape_cross(a, b, at) > 0) *out = (nck_approach_t){0.0, at[0].on_a, at[0].on_b};
}
