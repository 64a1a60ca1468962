// SPDX-License-Identifier: MIT
// The limits of speed along a path, one equation each. T: interpolation period [s].
#ifndef NCK_PREP_LIMIT_MATH_H
#define NCK_PREP_LIMIT_MATH_H

#include "nck/base/real.h" // nck_real nck_sqrt nck_fabs nck_min

// Share of every axis' acceleration that a junction may use at most; README, "the budget".
#define NCK_CORNER_SHARE_MAX 0.5
// The same of junctions close to each other: under a jerk limit, and on an even polygon (corner.c).
#define NCK_CORNER_SHARE_DENSE 0.8
// The same under a jerk limit, of one alone, and on a long even polygon.
#define NCK_CORNER_SHARE_LONE 0.9
// Share that centripetal acceleration may use of what the corner leaves; the tangential one gets at
// least √(1 − 0.8²) = 0.6 of it, for the two are perpendicular.
#define NCK_CURVE_SHARE 0.8
// Share of the jerk of an arc's plane that the speed alone may use. From rest to rest 0.2, 0.3 and
// 0.4 are fastest over a quarter, a half and a whole turn, 0.85 over five; less of it leaves more
// to speed up with, and walks of lines and arcs of 5 mm take 34.3 s with 0.5, 44.2 s with 0.85.
#define NCK_ARC_TWIST_SHARE 0.5

// Limit of the path quantity when an axis has the limit x_lim and the direction cosine c ≠ 0:
//   path ≤ x_lim / |c|      (speed, acceleration and jerk alike)
static inline nck_real nck_limit_along(nck_real x_lim, nck_real c) { return x_lim / nck_fabs(c); }

// The largest |cos| of the direction angle between the in-plane tangents t_in and t_out of an arc
// of less than half a turn:   1 if the perpendicular component changes its sign in between, else
// the larger of the two ends'. (A turn by less than π passes a given axis at most once.) in, out:
// component along the axis; in_n, out_n: across it; all divided by the in-plane speed.
static inline nck_real nck_limit_arc_cos(nck_real in, nck_real in_n, nck_real out, nck_real out_n) {
    if (in_n * out_n <= 0.0) return 1.0;
    const nck_real a = nck_fabs(in);
    const nck_real b = nck_fabs(out);
    return a > b ? a : b;
}

// Chord error δ on an arc of radius R > 0, chords of one period:   v ≤ (2/T)·√(2Rδ − δ²)
// (Cao et al. 2014, section 5, closed form). δ ≥ R: half a turn a period, v ≤ 2R/T.
static inline nck_real nck_limit_chord(nck_real r, nck_real delta, nck_real period) {
    const nck_real d = nck_min(delta, r);
    return 2.0 / period * nck_sqrt(2.0 * r * d - d * d);
}

// Centripetal acceleration on curvature κ > 0 with the axes' a; left: what the corner leaves of it:
//   v² ≤ 0.8·(1 − β)·a/κ
static inline nck_real nck_limit_curve(nck_real a, nck_real kappa, nck_real left) {
    return NCK_CURVE_SHARE * left * a / kappa;
}

// An arc whose in-plane acceleration is v²κ at the path speed v (κ = cos²λ/r, λ: pitch angle of a
// helix) takes, of the jerk of its plane, v³κ²/cos λ against the tangent and 3vκ·a along the normal
// (Frenet's equations differentiated twice: p⃛ = (j − κ²v³)·t + 3κva·n). The two are at a right
// angle, so an axis of the plane sees, at most,
//   (cos λ·j + v³κ²/cos λ)² + (3vκa)² ≤ J²
static inline nck_real nck_limit_arc_twist(nck_real v, nck_real kappa, nck_real cos_lambda) {
    return v * v * v * kappa * kappa / cos_lambda;
}

// v³ at which that takes the share β of J, κ > 0:   v³ ≤ β·J·cos λ/κ²     (a circle: β·J·r²)
// The rest of J is for speeding up and braking at that speed.
static inline nck_real nck_limit_arc_cube(nck_real j, nck_real kappa, nck_real cos_lambda) {
    return NCK_ARC_TWIST_SHARE * j * cos_lambda / (kappa * kappa);
}

// The path's acceleration that takes half, by squares, of what is left:
//   3vκ·a ≤ √((J² − twist²)/2)     twist ≤ J, vκ > 0
static inline nck_real nck_limit_arc_ramp(nck_real j, nck_real twist, nck_real v_kappa) {
    return nck_sqrt(0.5 * (j * j - twist * twist)) / (3.0 * v_kappa);
}

// The path's jerk that is left then:   cos λ·j ≤ √(J² − normal²) − twist
// normal: 3vκa; normal² + twist² ≤ J².
static inline nck_real nck_limit_arc_jerk(nck_real j, nck_real twist, nck_real normal,
                                          nck_real cos_lambda) {
    return (nck_sqrt(j * j - normal * normal) - twist) / cos_lambda;
}

// Tangential acceleration left on an arc: of τ·a, τ = 1 − β, the centripetal part v²κ is spent at a
// right angle:   a_t ≤ √((τa)² − (v²κ)²) / cos λ     (λ: pitch angle of a helix). v²κ ≤ τ·a.
static inline nck_real nck_limit_arc_accel(nck_real tau_a, nck_real vv_kappa, nck_real cos_lambda) {
    return nck_sqrt(tau_a * tau_a - vv_kappa * vv_kappa) / cos_lambda;
}

// Load of a junction on one axis: the jump of the direction cosine over the axis' acceleration,
//   d = |c_in − c_out| / a      [s²/mm]
// so that crossing it at v costs, sampled every T, the share d·v/T of that axis' acceleration
// (Cao et al. 2014, eq. 14: v = a·T/|c1 − c2| for the whole of it).
static inline nck_real nck_corner_load(nck_real c_in, nck_real c_out, nck_real a) {
    return nck_fabs(c_in - c_out) / a;
}

// The largest share of a junction that is alone, so that next to it the acceleration can still grow
// by twice what the jerk allows there:   β = 1 − 2·j·zone/a,   0.5 ≤ β ≤ 0.9
static inline nck_real nck_corner_share_lone(nck_real j, nck_real a, nck_real zone) {
    const nck_real share = 1.0 - 2.0 * j * zone / a;
    return nck_max(NCK_CORNER_SHARE_MAX, nck_min(NCK_CORNER_SHARE_LONE, share));
}

// A corner so sharp that its transfer speed β_max·T/d is less than the speed gained in one period,
// A·T, is better stopped at: then both neighbours may accelerate with all of a.
static inline int nck_corner_sharp(nck_real load, nck_real a) {
    return load * a > NCK_CORNER_SHARE_MAX;
}

// Transfer speed where several junctions share a period. v at junction j satisfies
//   d_j·v + Σ_i d_i·(v + A·T − |s_i − s_j|/T) = β·T        (i: all with |s_i − s_j| < (v + A·T)·T)
// derived in README, section "many junctions in one period". sum_d = d_j + Σ d_i,
// others_d = Σ d_i, others_dx = Σ d_i·|s_i − s_j|. May be negative: then v = 0.
static inline nck_real nck_corner_speed(nck_real beta, nck_real sum_d, nck_real others_d,
                                        nck_real others_dx, nck_real a_t, nck_real period) {
    return (beta * period + others_dx / period - a_t * others_d) / sum_d;
}

// The same of a junction that is alone (Cao et al. 2014, eq. 14, with βa for a):   v = β·T/d
static inline nck_real nck_corner_speed_alone(nck_real beta, nck_real d, nck_real period) {
    return beta * period / d;
}

// The share β that the speed v costs at a junction that is alone.
static inline nck_real nck_corner_share_alone(nck_real v, nck_real d, nck_real period) {
    return v * d / period;
}

// The same equation solved for the share β that the speed v costs, with its neighbours.
static inline nck_real nck_corner_share(nck_real v, nck_real sum_d, nck_real others_d,
                                        nck_real others_dx, nck_real a_t, nck_real period) {
    return (v * sum_d + a_t * others_d - others_dx / period) / period;
}

#endif
