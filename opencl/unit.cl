// SPDX-License-Identifier: MIT
// Speed inside every planning unit.
#include "host/unit_math.h" // nck_unit_step_count nck_unit_speed

// One work-item: one unit. Global size: count, rounded up. Local size: any. Reads segs, units, the
// rule of every stretch and the stretch of every unit; writes v, n_step and limit of every unit.
// Must equal nck_host_unit_speeds.
__kernel void unit_speed(__global const nck_seg_t *segs, __global const nck_unit_t *units,
                         __global const nck_grade_rule_t *rules, __global const uint *stretch_of,
                         ulong count, __global double *v, __global uint *n_step,
                         __global uchar *limit) {
    const size_t i = get_global_id(0);
    if (i >= count) return;
    __global const nck_grade_rule_t *rule = &rules[stretch_of[i]];
    int reason = 0;
    const int n = nck_unit_step_count(segs, &units[i], rule, &reason);
    v[i] = nck_unit_speed(&units[i], rule->period_s, n);
    n_step[i] = (uint)n;
    limit[i] = (uchar)reason;
}
