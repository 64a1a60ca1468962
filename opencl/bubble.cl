// SPDX-License-Identifier: MIT
// The bubble by sweeps: grades sink until neighbours differ by one at most. Launch until a sweep
// changes nothing; the grades are those of scan.cl then. Grades lie in 0 … NO_LIMIT − 1.
#include "host/bubble_math.h" // nck_bubble_sweep

// Beyond the ends nothing limits.
enum { NO_LIMIT = 0x3fffffff };

// One sweep, from before to after: the faithful, race-free form. One work-item: one point. Global
// size: n, rounded up. Local size: any. *changed becomes 1 if a grade changed: whoever writes it
// writes the same.
__kernel void bubble_sweep(__global const int *p, __global const int *before, long n,
                           __global int *after, __global int *changed) {
    const long i = get_global_id(0);
    if (i >= n) return;
    const int left = i > 0 ? before[i - 1] : NO_LIMIT;
    const int right = i < n - 1 ? before[i + 1] : NO_LIMIT;
    const int g = nck_bubble_sweep(p[i], left, right);
    after[i] = g;
    if (g != before[i]) *changed = 1;
}

// FUSED_SWEEPS sweeps in one launch. One work-item: FUSED_POINTS points, and as many more on either
// side as there are sweeps, since every sweep spoils one of them. Local size: 1.
enum { FUSED_SWEEPS = 16, FUSED_POINTS = 1024, FUSED_ROOM = FUSED_POINTS + 2 * FUSED_SWEEPS };

__kernel __attribute__((reqd_work_group_size(1, 1, 1)))
void bubble_fused(__global const int *p, __global const int *before, long n, __global int *after,
                  __global int *changed) {
    __local int limit[FUSED_ROOM];
    __local int one[FUSED_ROOM];
    __local int other[FUSED_ROOM];
    const long first = (long)get_global_id(0) * FUSED_POINTS - FUSED_SWEEPS;
    for (int k = 0; k < FUSED_ROOM; k++) {
        const long i = first + k;
        const int inside = i >= 0 && i < n;
        limit[k] = inside ? p[i] : NO_LIMIT;
        one[k] = inside ? before[i] : NO_LIMIT;
        other[k] = one[k];
    }
    for (int sweep = 0; sweep < FUSED_SWEEPS; sweep += 2) {
        for (int k = 1; k < FUSED_ROOM - 1; k++) {
            other[k] = nck_bubble_sweep(limit[k], one[k - 1], one[k + 1]);
        }
        for (int k = 1; k < FUSED_ROOM - 1; k++) {
            one[k] = nck_bubble_sweep(limit[k], other[k - 1], other[k + 1]);
        }
    }
    int difference = 0;
    for (int k = FUSED_SWEEPS; k < FUSED_SWEEPS + FUSED_POINTS && first + k < n; k++) {
        difference |= one[k] ^ before[first + k];
        after[first + k] = one[k];
    }
    if (difference) *changed = 1;
}
