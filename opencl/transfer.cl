// SPDX-License-Identifier: MIT
// Transfer speeds: the cap of every point between two planning units.
#include "host/turn_math.h" // nck_turn_transfer

// One work-item: one point; those of stretch k begin at its first unit + k. Global size: count,
// rounded up. Local size: any. Reads segs, units, their speeds v, the rule of every stretch and the
// stretch of every point; writes cap and linking angle of every point, 0 at both ends of a stretch.
// Must equal nck_host_transfers.
__kernel void transfer(__global const nck_seg_t *segs, __global const nck_unit_t *units,
                       __global const double *v, __global const nck_grade_rule_t *rules,
                       __global const uint *stretch_of, ulong count, __global double *v_transfer,
                       __global double *angle) {
    const size_t i = get_global_id(0);
    if (i >= count) return;
    const uint k = stretch_of[i];
    double cap = 0.0;
    double turn = 0.0;
    if (i > 0 && i + 1 < count && stretch_of[i - 1] == k && stretch_of[i + 1] == k) {
        const size_t in = i - k - 1; // the unit that ends here
        cap = nck_turn_transfer(segs, &units[in], &rules[k], nck_min(v[in], v[in + 1]), &turn);
    }
    v_transfer[i] = cap;
    angle[i] = turn;
}
