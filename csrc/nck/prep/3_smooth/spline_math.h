// SPDX-License-Identifier: MIT
// Cubic B-splines over any knots t_0 ≤ … ≤ t_5, with control points taken from the programmed path.
#ifndef NCK_PREP_SPLINE_MATH_H
#define NCK_PREP_SPLINE_MATH_H

#include "nck/base/real.h"    // nck_real nck_sqrt nck_min nck_max
#include "nck/base/records.h" // nck_seg_t NCK_AXIS_MAX

// Greville abscissa of the control point that the knots at t[0] t[1] t[2] enclose:
//   ξ = (t_0 + t_1 + t_2)/3
// A triple knot gives itself, to the bit.
// (M. J. Marsden, I. J. Schoenberg, On Variation Diminishing Spline Approximation Methods, 1966.)
static inline nck_real nck_spline_greville(const nck_real *t) {
    return t[0] < t[2] ? (t[0] + t[1] + t[2]) / 3.0 : t[0];
}

// The Bernstein points of the piece over t_2 … t_3, t_2 < t_3, from its four control points:
//
//       c1 ──●──●── c2        inner points: where the leg c1 c2 is over t_2 + Δ/3 and t_3 − Δ/3
//      ╱                ╲     ends: between neighbouring pieces' inner points, over t_2 and t_3
//    c0                  c3
//
// (W. Boehm, Inserting New Knots into B-spline Curves, 1980: each knot inserted three times.)
// Fills start, inner and end of the seg, of them the coordinates that may change, axes from X on. A
// triple knot at t_3 gives end = c3, at t_2 start = c0, to the bit.
static inline void nck_spline_bernstein(const nck_real *t, nck_real (*c)[NCK_AXIS_MAX], int axes,
                                        nck_seg_t *seg_out) {
    const nck_real before = (t[2] - t[0]) / (t[3] - t[0]);
    const nck_real first = (t[2] - t[1]) / (t[4] - t[1]);
    const nck_real second = (t[3] - t[1]) / (t[4] - t[1]);
    const nck_real behind = (t[3] - t[2]) / (t[5] - t[2]);
    const nck_real at_start = (t[2] - t[1]) / (t[3] - t[1]);
    const nck_real at_end = (t[3] - t[2]) / (t[4] - t[2]);
    for (int x = 0; x < axes; x++) {
        const nck_real last = c[0][x] + (c[1][x] - c[0][x]) * before;
        const nck_real b1 = c[1][x] + (c[2][x] - c[1][x]) * first;
        const nck_real b2 = c[1][x] + (c[2][x] - c[1][x]) * second;
        const nck_real next = c[2][x] + (c[3][x] - c[2][x]) * behind;
        seg_out->shape.inner[0][x] = b1;
        seg_out->shape.inner[1][x] = b2;
        seg_out->start[x] = t[0] < t[2] ? last + (b1 - last) * at_start : c[0][x];
        seg_out->end[x] = t[3] < t[5] ? b2 + (next - b2) * at_end : c[3][x];
    }
}

// The blossom of a cubic with the Bernstein points b at u, v, w (shares of its length): symmetric,
// and the cubic itself where all three are the same (P. de Casteljau, Formes à pôles, 1985).
static inline nck_real nck_spline_blossom(const nck_real *b, nck_real u, nck_real v, nck_real w) {
    const nck_real c0 = b[0] + (b[1] - b[0]) * u;
    const nck_real c1 = b[1] + (b[2] - b[1]) * u;
    const nck_real c2 = b[2] + (b[3] - b[2]) * u;
    const nck_real d0 = c0 + (c1 - c0) * v;
    const nck_real d1 = c1 + (c2 - c1) * v;
    return d0 + (d1 - d0) * w;
}

// The part of a spline or a line from x0 to x1 of its length: its Bernstein points are the blossom
// at x0 x0 x0, x0 x0 x1, x0 x1 x1, x1 x1 x1. An end of the whole that is kept stays to the bit.
// axes: as above.
static inline void nck_spline_part(nck_seg_t *seg, nck_real x0, nck_real x1, int axes) {
    const nck_real u = x0 / seg->length;
    const nck_real v = x1 / seg->length;
    const int begins = !(x0 > 0.0);
    const int ends = !(x1 < seg->length);
    if (begins && ends) return;
    for (int x = 0; x < axes; x++) {
        const nck_real start = seg->start[x];
        const nck_real way = seg->end[x] - start;
        const nck_real b[4] = {start, seg->shape.inner[0][x], seg->shape.inner[1][x], seg->end[x]};
        const int cubic = seg->kind == NCK_SEG_SPLINE;
        if (cubic) {
            seg->shape.inner[0][x] = nck_spline_blossom(b, u, u, v);
            seg->shape.inner[1][x] = nck_spline_blossom(b, u, v, v);
        }
        if (!begins) seg->start[x] = cubic ? nck_spline_blossom(b, u, u, u) : start + way * u;
        if (!ends) seg->end[x] = cubic ? nck_spline_blossom(b, v, v, v) : start + way * v;
    }
    seg->length = x1 - x0;
}

// Second moment of three knots about their Greville abscissa: with control points on the path the
// spline of a parabola leaves it by   p̃ − p = g·p″/2,
//   g = ((t_1 − t_0)² + (t_2 − t_1)² + (t_2 − t_0)²)/18,   Δ²/3 between even knots.
static inline nck_real nck_spline_moment(const nck_real *t) {
    const nck_real first = t[1] - t[0];
    const nck_real second = t[2] - t[1];
    const nck_real both = t[2] - t[0];
    return (first * first + second * second + both * both) / 18.0;
}

// Weights of four control points of a cubic B-spline with even knots, at a share u of an interval.
static inline void nck_spline_basis(nck_real u, nck_real *weight_out) {
    const nck_real w = 1.0 - u;
    weight_out[0] = w * w * w / 6.0;
    weight_out[1] = (3.0 * u * u * u - 6.0 * u * u + 4.0) / 6.0;
    weight_out[2] = (3.0 * w * w * w - 6.0 * w * w + 4.0) / 6.0;
    weight_out[3] = u * u * u / 6.0;
}

// Second difference of three points evenly apart, of one axis:   δ²p = p_− − 2p + p_+
static inline nck_real nck_spline_bend(nck_real before, nck_real here, nck_real behind) {
    return (before - here) + (behind - here);
}

// Points of the path on either side of its place that a control point is made of.
enum { NCK_SPLINE_SIDE = 4 };

// A control point on a curve is p + Σ w_k·(p(ξ − kh/4) − 2p(ξ) + p(ξ + kh/4)), k = 1 … 4. Of all
// weights of the nine points with Σ w = 1 and Σ w·(kh/4)² = −h²/3, for which the spline of a
// parabola is the parabola, those with the least Σ w²:
//   w_k = (257 − 27k²)/693
// (Quasi-interpolation: C. de Boor, G. J. Fix, Spline Approximation by Quasiinterpolants, 1973.
// Least squares of noise: A. Savitzky, M. J. E. Golay, 1964.)
static inline nck_real nck_spline_weight(int k) {
    return (257.0 - 27.0 * (nck_real)(k * k)) / 693.0;
}

// The same where the path is noise: their mean,   w_k = 1/9
#define NCK_SPLINE_MEAN (1.0 / 9.0)

// How far a cubic can leave its chord between two points of it that are h apart:   |p″|·h²/8
// where second is the largest |p″| (the error of linear interpolation).
static inline nck_real nck_spline_sag(nck_real second, nck_real h) { return second * h * h / 8.0; }

// Spacing of knots at which a spline of evenly spaced knots leaves a vertex by ε:  ε = |Δu|·Δ/6
// (derived in README, section "how far it leaves the path"). turn = |Δu| > 0.
static inline nck_real nck_spline_vertex_spacing(nck_real tolerance, nck_real turn) {
    return 6.0 * tolerance / turn;
}

// A corner's control point may lie off it, ℓ·|Δu|·Δ to its outside. Then the spline leaves the
// vertex by ε = |Δu|·Δ·(1/6 − w·ℓ) to the inside, w the weight of the control point there, and
// beside it the lines to the outside, by less up to this lift, whatever knots follow.
#define NCK_SPLINE_LIFT 0.165
// About the weight of its control point there.
#define NCK_SPLINE_WEIGHT 0.6
// So a corner's spacing may be wider, by so much.
#define NCK_SPLINE_WIDE 2.1
// Then it is chosen for this share of the tolerance: what lies between the points that are looked
// at sags more.
#define NCK_SPLINE_WIDE_SHARE 0.94

// Weight at t[2] of the control point with the knots t[1] t[2] t[3] if the spline ends at t[3]:
//   w = 1 − (t_3 − t_2)²/((t_3 − t_1)(t_3 − t_0)) − (t_2 − t_1)²/(t_3 − t_1)²
// It is larger with any other knots behind t[3].
static inline nck_real nck_spline_vertex_weight(const nck_real *t) {
    const nck_real both = t[3] - t[1];
    const nck_real before = t[2] - t[1];
    const nck_real behind = t[3] - t[2];
    return 1.0 - behind * behind / (both * (t[3] - t[0])) - before * before / (both * both);
}

// The least lift with which a spacing leaves a vertex by no more than a tolerance.
static inline nck_real nck_spline_lift(nck_real tolerance, nck_real turn, nck_real spacing,
                                       nck_real weight) {
    const nck_real lift = (1.0 / 6.0 - tolerance / (turn * spacing)) / weight;
    return nck_max(0.0, nck_min(NCK_SPLINE_LIFT, lift));
}

// What such a lift makes of the largest |p″|, else |Δu|/Δ, and of the largest |p‴|, else |Δu|/Δ².
static inline nck_real nck_spline_lifted_second(nck_real lift) { return 1.0 + 2.0 * lift; }
static inline nck_real nck_spline_lifted_third(nck_real lift) { return 1.0 + 3.0 * lift; }

// Cosine between two turns of one bend, at least.
#define NCK_SPLINE_ALIKE 0.9

// 1 if a path turns twice about as much, and the same way, as a curve's chords do: Δu and |Δu| of
// both, so many axes of them.
static inline int nck_spline_is_alike(const nck_real *a, nck_real size_a, const nck_real *b,
                                      nck_real size_b, int axes) {
    nck_real along = 0.0;
    for (int x = 0; x < axes; x++) along += a[x] * b[x];
    return size_b < 2.0 * size_a && size_a < 2.0 * size_b
           && along > NCK_SPLINE_ALIKE * size_a * size_b;
}

// Where the path goes on straight but its curvature steps by |Δp″| > 0, from a line to an arc, at a
// knot with even knots beside it: control points that reproduce parabolas make a spline that leaves
// the path by  ε = 0.0332·|Δp″|·Δ²,  once to either side, with  |p‴| = 7/12·|Δp″|/Δ.
// (Of all curves within ε the smoothest has 0.84 of that |p‴|: a linear program over fine knots.)
static inline nck_real nck_spline_step_spacing(nck_real tolerance, nck_real step) {
    return nck_sqrt(tolerance / (0.0332 * step));
}

// With control points on the path a curve is left by   ε = κ·Δ²/6,  κ > 0
static inline nck_real nck_spline_curve_spacing(nck_real tolerance, nck_real kappa) {
    return nck_sqrt(6.0 * tolerance / kappa);
}

// Inside of an arc they leave it by   ε = |p⁗|·Δ⁴/36,  |p⁗| = κ·ω²,
// ω the angle that a unit of path turns by, as long as a step turns by no more than 0.8. A small
// arc, which the tolerance spans, is any curve.
static inline nck_real nck_spline_arc_spacing(nck_real tolerance, nck_real kappa, nck_real omega) {
    const nck_real square = nck_sqrt(36.0 * tolerance / (kappa * omega * omega));
    const nck_real along = nck_min(0.8 / omega, nck_sqrt(square));
    return nck_max(along, nck_spline_curve_spacing(tolerance, kappa));
}

// Spacing that crosses a reversal, |Δu| = 2, at speed v within half of acceleration and jerk:
//   |p″|·v² = 2v²/Δ ≤ a/2,   |p‴|·v³ = 2v³/Δ² ≤ j/2
// No turn of any path gains from a wider one.
static inline nck_real nck_spline_spacing_max(nck_real v, nck_real a, nck_real j) {
    return nck_max(4.0 * v * v / a, 2.0 * nck_sqrt(v * v * v / j));
}

// Length of a vector in the path metric; axes: its components that need not be 0.
static inline nck_real nck_spline_norm(const nck_real *d, int axes) {
    nck_real sum = 0.0;
    for (int x = 0; x < axes; x++) sum += d[x] * d[x];
    return nck_sqrt(sum);
}

// Distance of two points in the path metric; axes: the coordinates in which they may differ.
static inline nck_real nck_spline_distance(const nck_real *p, const nck_real *q, int axes) {
    nck_real sum = 0.0;
    for (int x = 0; x < axes; x++) sum += (p[x] - q[x]) * (p[x] - q[x]);
    return nck_sqrt(sum);
}

#endif
