// SPDX-License-Identifier: MIT
// Circles, helices and spirals about any axis of space.
#include "arc.h"

#include <math.h> // acos atan2 cos fabs floor fmax fmin sin sqrt

static const double pi = 3.14159265358979323846;
static const double same_angle = 1e-6; // [rad] ends so near to each other are one

static double dot(const double *a, const double *b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

// Take the part along n off a. Returns that part.
static double flatten(double *a, const double *n) {
    const double along = dot(a, n);
    for (int k = 0; k < 3; k++) a[k] -= along * n[k];
    return along;
}

static double sweep(double angle, int32_t turn) {
    const double sign = turn < 0 ? -1.0 : 1.0;
    const double more = turn < 0 ? -1.0 - (double)turn : (double)turn;
    double once = sign * angle;
    if (once <= same_angle) once += 2.0 * pi;
    return sign * (once + 2.0 * pi * more);
}

int arc_make(const double *start, const double *end, const double *centre, const double *normal,
             int32_t turn, arc_t *arc_out) {
    arc_t *const arc = arc_out;
    double to[3];
    const double size = sqrt(dot(normal, normal));
    if (!(size > 0.0)) return 0;
    for (int k = 0; k < 3; k++) {
        arc->n[k] = normal[k] / size;
        arc->u[k] = start[k] - centre[k];
        to[k] = end[k] - centre[k];
    }
    const double low = flatten(arc->u, arc->n);
    arc->height = flatten(to, arc->n) - low;
    arc->radius[0] = sqrt(dot(arc->u, arc->u));
    arc->radius[1] = sqrt(dot(to, to));
    if (!(arc->radius[0] > 0.0)) return 0;
    for (int k = 0; k < 3; k++) {
        arc->u[k] /= arc->radius[0];
        arc->centre[k] = centre[k] + low * arc->n[k];
    }
    for (int k = 0; k < 3; k++) {
        const int a = (k + 1) % 3, b = (k + 2) % 3;
        arc->v[k] = arc->n[a] * arc->u[b] - arc->n[b] * arc->u[a];
    }
    arc->angle = sweep(atan2(dot(to, arc->v), dot(to, arc->u)), turn);
    return 1;
}

void arc_point(const arc_t *arc, double share, double *point_out) {
    const double radius = arc->radius[0] + share * (arc->radius[1] - arc->radius[0]);
    const double along_u = radius * cos(share * arc->angle);
    const double along_v = radius * sin(share * arc->angle);
    for (int k = 0; k < 3; k++) {
        point_out[k] = arc->centre[k] + along_u * arc->u[k] + along_v * arc->v[k]
                       + share * arc->height * arc->n[k];
    }
}

double arc_share(const arc_t *arc, const double *point, double guess) {
    double out[3];
    const double sweep = fabs(arc->angle);
    for (int k = 0; k < 3; k++) out[k] = point[k] - arc->centre[k];
    const double across = arc->angle < 0.0 ? -dot(out, arc->v) : dot(out, arc->v);
    const double at = atan2(across, dot(out, arc->u));
    const double whole = 2.0 * pi * floor((guess * sweep - at) / (2.0 * pi) + 0.5);
    return fmin(fmax((at + whole) / sweep, 0.0), 1.0);
}

void arc_reverse(arc_t *arc) {
    const double c = cos(arc->angle), s = sin(arc->angle), radius = arc->radius[0];
    for (int k = 0; k < 3; k++) {
        const double u = arc->u[k], v = arc->v[k];
        arc->u[k] = c * u + s * v;
        arc->v[k] = c * v - s * u;
        arc->centre[k] += arc->height * arc->n[k];
    }
    arc->radius[0] = arc->radius[1];
    arc->radius[1] = radius;
    arc->height = -arc->height;
    arc->angle = -arc->angle;
}

double arc_length(const arc_t *arc) {
    const double round = 0.5 * (arc->radius[0] + arc->radius[1]) * arc->angle;
    const double out = arc->radius[1] - arc->radius[0];
    return sqrt(round * round + arc->height * arc->height + out * out);
}

uint32_t arc_chords(const arc_t *arc, double error) {
    const double radius = fmax(arc->radius[0], arc->radius[1]);
    const double step = 2.0 * acos(fmax(0.0, 1.0 - error / radius));
    return 1u + (uint32_t)(fabs(arc->angle) / step);
}

// It turns back along an axis where the way is across it, once a turn on each side.
double arc_reach(const arc_t *arc, int axis, double side) {
    static const double turn = 6.283185307179586;
    const double sweep = fabs(arc->angle), along = arc->angle < 0.0 ? -arc->v[axis] : arc->v[axis];
    double at = atan2(side * along, side * arc->u[axis]);
    if (at < 0.0) at += turn;
    const double last = at + turn * floor((sweep - at) / turn);
    const double shares[4] = {0.0, 1.0, at / sweep, last / sweep};
    double point[3], most = -HUGE_VAL;
    for (int n = 0; n < (at <= sweep ? 4 : 2); n++) {
        arc_point(arc, shares[n], point);
        most = fmax(most, side * point[axis]);
    }
    return side * most;
}
