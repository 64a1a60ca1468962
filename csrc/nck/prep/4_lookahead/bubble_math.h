// SPDX-License-Identifier: MIT
// The bubble: the largest grades under the preplanned ones that differ by one step at most from
// point to point. Grades are whole numbers, so every form below gives the same ones.
#ifndef NCK_PREP_BUBBLE_MATH_H
#define NCK_PREP_BUBBLE_MATH_H

// One sweep at one point, from the old grades to new ones:
//   g'_i = min(p_i, g_{i−1} + 1, g_{i+1} + 1)
// Gather form of Cao et al. 2014, section 7: every point is written once, from values that nobody
// writes. In the printed form two pairs write one point, and which of them wins is left to chance.
static inline int nck_bubble_sweep(int p, int left, int right) {
    const int low = left < right ? left + 1 : right + 1;
    return low < p ? low : p;
}

// One step of the scan, forward from the point before, then backward from the point behind:
//   g_i = min(p_i, g_{i−1} + 1),  then  g_i = min(g_i, g_{i+1} + 1)
// Together min_j (p_j + |i − j|), where the sweeps end too.
static inline int nck_bubble_scan(int p, int neighbour) {
    return neighbour + 1 < p ? neighbour + 1 : p;
}

#endif
