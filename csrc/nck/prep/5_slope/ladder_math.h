// SPDX-License-Identifier: MIT
// The ladder: where the nodes of a jerk-limited profile stand inside a piece of path, so that its
// cells last about a step D each; and how the filter at the output and that step bound the jerk.
#ifndef NCK_PREP_LADDER_MATH_H
#define NCK_PREP_LADDER_MATH_H

#include "nck/base/real.h" // nck_real nck_sqrt nck_min NCK_IN

// Cells of a plan last no longer than this many steps, else they are divided.
#define NCK_LADDER_STRETCH 1.35

// A cube root is by far the larger one above so many times an acceleration.
#define NCK_LADDER_CLEAR 0.763

// ∛x for x ≥ 0, to 1 % for 1e-24 ≤ x ≤ 1e24: x^(1/4 + 1/16 + 1/64) by square roots, then two of
// Newton's steps. Ladders need no more.
static inline nck_real nck_ladder_cbrt(nck_real x) {
    if (!(x > 0.0)) return 0.0;
    const nck_real r4 = nck_sqrt(nck_sqrt(x));
    const nck_real r16 = nck_sqrt(nck_sqrt(r4));
    const nck_real r64 = nck_sqrt(nck_sqrt(r16));
    nck_real y = r4 * r16 * r64;
    y = (2.0 * y + x / (y * y)) / 3.0;
    return (2.0 * y + x / (y * y)) / 3.0;
}

// v² at a distance x behind a point that is passed at vv0 with no acceleration: from rest under the
// jerk J, x = J·t³/6 and v = J·t²/2, so v² = (81/4)^(1/3)·(J·x²)^(2/3) = 2.726·x·(J²·x)^(1/3);
// under the acceleration A it is 2·A·x.
//        vv(x) ≈ vv0 + x·min(2A, 2.726·(J²·x)^(1/3))
// Where the acceleration bounds it by far, no root is needed to know so.
static inline nck_real nck_ladder_gain(nck_real x, nck_real a, nck_real j) {
    const nck_real jjx = j * j * x;
    const nck_real root = NCK_LADDER_CLEAR * a; // 2a/2.726, and 4 % more
    if (jjx > root * root * root) return x * (2.0 * a);
    return x * nck_min(2.0 * a, 2.726 * nck_ladder_cbrt(jjx));
}

// A piece of path that a ladder is laid over: caps of v² and limits.
typedef struct nck_ladder_piece {
    nck_real vv0; // at its start [mm²/s²]
    nck_real vv1; // at its end
    nck_real vv;  // between
    nck_real a;   // [mm/s²]
    nck_real j;   // [mm/s³]
} nck_ladder_piece_t;

// The length of the next cell at a distance x behind a piece's start and y before its end: D·v a
// little further on (J·D³/6, what one step from rest makes).
static inline nck_real nck_ladder_step(NCK_IN nck_ladder_piece_t *piece, nck_real x, nck_real y,
                                       nck_real step) {
    const nck_real a = piece->a;
    const nck_real j = piece->j;
    const nck_real first = j * step * step * step / 6.0;
    nck_real vv = piece->vv;
    if (piece->vv0 < vv) vv = nck_min(vv, piece->vv0 + nck_ladder_gain(x + first, a, j));
    if (piece->vv1 < vv) vv = nck_min(vv, piece->vv1 + nck_ladder_gain(y + first, a, j));
    return step * nck_sqrt(vv);
}

// The distance over which the gain reaches dw: beyond it a node's cap no longer matters.
//        x = max(dw/2A, (dw/2.726)^(3/4)/√J)
static inline nck_real nck_ladder_far(nck_real dw, nck_real a, nck_real j) {
    if (!(dw > 0.0)) return 0.0;
    const nck_real r = dw / 2.726;
    return nck_max(dw / (2.0 * a), nck_sqrt(r * nck_sqrt(r) / j));
}

// How many cells a cell of the duration q becomes.
static inline int nck_ladder_parts(nck_real q, nck_real step, int most) {
    if (!(q > NCK_LADDER_STRETCH * step)) return 1;
    const nck_real parts = nck_floor(q / step) + 1.0;
    return parts < (nck_real)most ? (int)parts : most;
}

// By how much the sampled jerk may exceed the J of rule R, as a share of it. A sample is the mean
// of the jumps of acceleration under the kernel K: the quadratic B-spline of the period T, summed
// over the n taps of the filter. Rule R allows a jump J·(q0 + q1)/2 at a node, so the sum is at
// most J times the trapezoidal sum of K over nodes no more than q apart. Its excess over ∫K = 1 was
// computed by dynamic programming over all ladders (README):
//        q²/(6·n·T²) for q ≤ T (exact),   at most q²/(5·n·T²) beyond, and never more than q/(n·T).
static inline nck_real nck_ladder_excess(nck_real q, nck_real period, int taps) {
    const nck_real r = q / period;
    const nck_real bound = r * r / (r <= 1.0 ? 6.0 : 5.0);
    return nck_min(bound, r) / (nck_real)taps;
}

// By how much the filter of the duration tau and the cells of the duration q may raise the speed at
// a node over the plan's:   J·(τ²/24 + q²/8)
static inline nck_real nck_ladder_raise(nck_real j, nck_real tau, nck_real q) {
    return j * (tau * tau / 24.0 + q * q / 8.0);
}

#endif
