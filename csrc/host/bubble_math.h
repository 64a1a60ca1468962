// SPDX-License-Identifier: MIT
// The bubble: the largest grades under the preplanned ones that differ by one step at most from
// point to point. Grades are whole numbers, so every form below gives the same ones.
#ifndef NCK_HOST_BUBBLE_MATH_H
#define NCK_HOST_BUBBLE_MATH_H

#include "nck/base/real.h" // NCK_IN nck_int64

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

// What the points from i on allow at point i, of n:   min_j (p_j + j − i), j ≥ i
// The backward scan of one point alone. It looks no further than p_i points: no grade is negative.
static inline int nck_bubble_behind(NCK_IN int *p, nck_int64 i, nck_int64 n) {
    int low = p[i];
    for (int k = 1; k < low && k < n - i; k++) {
        if (p[i + k] + k < low) low = p[i + k] + k;
    }
    return low;
}

// The final grade of point i alone, of n:   min_j (p_j + |i − j|)
static inline int nck_bubble_grade(NCK_IN int *p, nck_int64 i, nck_int64 n) {
    int low = nck_bubble_behind(p, i, n);
    for (int k = 1; k < low && k <= i; k++) {
        if (p[i - k] + k < low) low = p[i - k] + k;
    }
    return low;
}

#endif
