// SPDX-License-Identifier: MIT
// Arcs by chord and height: the circle through both ends, and the way along it.
//
//            centre C            d = end − start, L = |d|, M = d/2 the middle of the chord,
//              +                 n = d turned by +90°, of length 1.
//             /|\                h = (C − M)·n: height of the centre above the chord.
//          r / |h\ r             g = (C − M)·d/L: how far C stands beside the bisector; a circle
//           /  |  \              through both ends has g = 0.
//   start  S---M---E  end        All points relative to the start; u, v: axes of the plane.
//                                An arc is anticlockwise if it turns from u towards v.
#ifndef NCK_BASE_ARC_MATH_H
#define NCK_BASE_ARC_MATH_H

#include "nck/base/real.h"      // nck_real nck_sqrt
#include "nck/base/trig_math.h" // NCK_PI, what nck_atan2 stands for

// X Y Z follow one another in a circle: of the plane G17 … G19 axis 0 turns into axis 1, and axis 2
// stands on it.
static inline unsigned nck_plane_axis(unsigned plane, unsigned k) {
    static const unsigned char axes[3][4] = {{0, 1, 2, 0}, {2, 0, 1, 0}, {1, 2, 0, 0}};
    return axes[plane - 17u][k];
}

// a·b and a × b in the plane.
static inline nck_real nck_arc_inner(NCK_IN nck_real *a, NCK_IN nck_real *b) {
    return a[0] * b[0] + a[1] * b[1];
}
static inline nck_real nck_arc_outer(NCK_IN nck_real *a, NCK_IN nck_real *b) {
    return a[0] * b[1] - a[1] * b[0];
}

// |(u, v)| [mm]
static inline nck_real nck_arc_norm(nck_real u, nck_real v) {
    return nck_sqrt(u * u + v * v);
}

//  h = (C − M)·n = (d × C)/L                                    [mm], L > 0
static inline nck_real nck_arc_height(nck_real du, nck_real dv, nck_real cu, nck_real cv) {
    return (du * cv - dv * cu) / nck_arc_norm(du, dv);
}

//  g = (C − M)·d/L = (r_start² − r_end²)/(2L)                   [mm], L > 0
static inline nck_real nck_arc_aside(nck_real du, nck_real dv, nck_real cu, nck_real cv) {
    return ((cu - 0.5 * du) * du + (cv - 0.5 * dv) * dv) / nck_arc_norm(du, dv);
}

//  h = ±√(R² − (L/2)²)                                          [mm]
// R > 0: the shorter of the two arcs, R < 0: the longer one; turn = +1 anticlockwise, −1 clockwise.
// The centre of a short anticlockwise arc is on the left of the chord, h > 0. A radius below L/2
// (the caller allows what is within tolerance) gives the half circle.
static inline nck_real nck_arc_radius_height(nck_real length, nck_real radius, nck_real turn) {
    const nck_real rest = (radius - 0.5 * length) * (radius + 0.5 * length);
    const nck_real height = rest > 0.0 ? nck_sqrt(rest) : 0.0;
    return (radius < 0.0 ? -height : height) * turn;
}

//  sweep = turn · 2 atan2(L/2, turn·h)                          [rad], 0 < |sweep| < 2π for L > 0
// Half of the angle that the chord subtends has the tangent (L/2)/h; below the chord (the long way)
// h is negative and atan2 goes on beyond π/2. No case distinction, no cancellation, and never 0 or
// 2π.
static inline nck_real nck_arc_sweep(nck_real length, nck_real height, nck_real turn) {
    return turn * (2.0 * nck_atan2(0.5 * length, turn * height));
}

//  C = M + h n                                                  [mm], L > 0
static inline void nck_arc_centre(nck_real du, nck_real dv, nck_real height, nck_real *centre_out) {
    const nck_real per_length = height / nck_arc_norm(du, dv);
    centre_out[0] = 0.5 * du - per_length * dv;
    centre_out[1] = 0.5 * dv + per_length * du;
}

//  angle from −C (to the start) to d − C (to the end), in the sense of turn
//                                                               [rad], 0 < |angle| ≤ 2π
// For a centre off the bisector. The cross product decides what is behind and what ahead; ends on
// one ray are a whole turn.
static inline nck_real nck_arc_angle(nck_real du, nck_real dv, nck_real cu, nck_real cv,
                                     nck_real turn) {
    const nck_real cross = turn * (cv * du - cu * dv);
    const nck_real dot = cu * (cu - du) + cv * (cv - dv);
    const nck_real angle = nck_atan2(cross, dot);
    return turn * (angle > 0.0 ? angle : angle + 2.0 * NCK_PI);
}

//  P = C − ρ·rot(φ)·C/|C|                                       [mm]
// The point that a radius of length rho points to after it has turned by phi from the start. |C| >
// 0.
static inline void nck_arc_point(nck_real cu, nck_real cv, nck_real rho, nck_real phi,
                                 nck_real *point_out) {
    const nck_real scale = rho / nck_arc_norm(cu, cv);
    nck_real sin_phi = 0.0;
    nck_real cos_phi = 1.0;
    nck_sincos(phi, &sin_phi, &cos_phi);
    point_out[0] = cu - scale * (cu * cos_phi - cv * sin_phi);
    point_out[1] = cv - scale * (cu * sin_phi + cv * cos_phi);
}

// Which of +u +v −u −v, bits 0 … 3, are left of a direction or along it.
static inline unsigned nck_arc_left(nck_real u, nck_real v) {
    unsigned left = 0;
    if (v <= 0.0) left |= 1u;
    if (u >= 0.0) left |= 2u;
    if (v >= 0.0) left |= 4u;
    if (u <= 0.0) left |= 8u;
    return left;
}

// Which of these an arc passes: there it turns back along an axis, a radius from the centre.
// from, to: its ends, from the centre. Anticlockwise from a to b:
//  short way (a × b ≥ 0): what is left of a and right of b;
//  long way: what is not strictly between b and a.
// Half turns with a × b = 0 count as the short way. So near to a turn as 1e-9 rad the ends do not
// tell it from none.
static inline unsigned nck_arc_bulges(NCK_IN nck_real *from, NCK_IN nck_real *to, nck_real sweep) {
    NCK_IN nck_real *const a = sweep > 0.0 ? from : to;
    NCK_IN nck_real *const b = sweep > 0.0 ? to : from;
    const unsigned left = nck_arc_left(a[0], a[1]);
    const unsigned right = nck_arc_left(-b[0], -b[1]);
    if (nck_fabs(sweep) >= 2.0 * NCK_PI - 1e-9) return 15u;
    return nck_arc_outer(a, b) < 0.0 ? left | right : left & right;
}

#endif
