// SPDX-License-Identifier: MIT
// The jerk rule and the two steps that keep it, in v² over the path coordinate. Derived in
// README, section "Jerk".
#ifndef NCK_PREP_HULL_MATH_H
#define NCK_PREP_HULL_MATH_H

#include "nck/base/real.h" // nck_real nck_sqrt nck_min NCK_IN

enum { NCK_RISE_STEPS = 16 }; // Newton's steps at most; 3 to 5 are the rule, 11 from rest

// A cell of the ladder under rule R.
typedef struct nck_hull_cell {
    nck_real h;     // length [mm]
    nck_real a_max; // [mm/s²]
    nck_real j;     // [mm/s³]
    nck_real most;  // half of the longest duration that counts [s]
} nck_hull_cell_t;

// What one cell adds to the change of acceleration that rule R allows at either of its ends: half
// of its duration, or of the longest duration that counts.
//        q = 2h/(v0 + v1)        share = min(q, q_cap)/2        most = q_cap/2
// v0 + v1 = 0 (a cell between two rests) counts as the longest.
static inline nck_real nck_hull_share(nck_real h, nck_real v_sum, nck_real most) {
    return h < v_sum * most ? h / v_sum : most;
}

// The largest speed at the end of a cell that is entered at v, under rule R and a ≤ a_max, and no
// more than v_cap. b is the acceleration that the rule allows apart from the cell's own share:
// a_before + J·q/2.
//
//     a ≤ b + J·min(q, q_cap)/2,   q = 2h/(v + v1),   v1² = v² + 2ah.
//     With x = v + v1:   f(x) = x³ − 2v·x² − 2hb·x − 2Jh² ≤ 0   up to the largest root,
//
// found by Newton from above: f is convex to the right of its largest root, so the steps come down
// to it and never pass it. Where f(v + v_cap) ≤ 0 the cap itself can be met.
// Returns −1 if the speed would come to nothing within the cell.
static inline nck_real nck_hull_rise(NCK_IN nck_hull_cell_t *cell, nck_real v, nck_real b,
                                     nck_real v_cap) {
    const nck_real h = cell->h;
    const nck_real j = cell->j;
    const nck_real a_long = nck_min(cell->a_max, b + j * cell->most);
    const nck_real vv = v * v + 2.0 * a_long * h;
    if (vv < 0.0) return -1.0;
    const nck_real hb = 2.0 * h * b;
    const nck_real jhh = 2.0 * j * h * h;
    const int capped = v_cap * v_cap < vv;
    nck_real x = v + (capped ? v_cap : nck_sqrt(vv));
    for (int n = 0; n < NCK_RISE_STEPS; n++) {
        const nck_real f = ((x - 2.0 * v) * x - hb) * x - jhh;
        const nck_real slope = (3.0 * x - 4.0 * v) * x - hb;
        const nck_real next = f > 0.0 && slope > 0.0 ? x - f / slope : x;
        if (!(next < x)) break;
        x = next;
    }
    return x < v ? -1.0 : x - v;
}

// 1 if that is v_cap, and no root is needed to know so: nothing speeds up, and nothing must slow
// down. Below half of v its last digits are not those of v + v_cap.
static inline int nck_hull_stays(nck_real v, nck_real b, nck_real v_cap) {
    return v_cap <= v && v <= 2.0 * v_cap && b >= 0.0;
}

// Where the middle of three points of growing abscissa lies: > 0 above the chord of the others.
static inline nck_real nck_hull_above(nck_real s0, nck_real z0, nck_real s1, nck_real z1,
                                      nck_real s2, nck_real z2) {
    return (z1 - z0) * (s2 - s0) - (z2 - z0) * (s1 - s0);
}

#endif
