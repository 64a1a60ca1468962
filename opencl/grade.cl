// SPDX-License-Identifier: MIT
// Grades: of the caps before the bubble, and the accelerations that follow from those after it.
#include "host/grade_math.h"            // nck_grade_of nck_grade_vv
#include "nck/prep/5_slope/ramp_math.h" // nck_ramp_accel

// One work-item: one point. Global size: count, rounded up. Local size: any. Reads the rule of
// every stretch, the stretch of every point and its cap; writes its grade. Must equal
// nck_host_transfers.
__kernel void grade(__global const nck_grade_rule_t *rules, __global const uint *stretch_of,
                    __global const double *v_transfer, ulong count, __global int *preplanned) {
    const size_t i = get_global_id(0);
    if (i >= count) return;
    preplanned[i] = nck_grade_of(&rules[stretch_of[i]], v_transfer[i] * v_transfer[i]);
}

// One work-item: one unit. Sizes as above. Reads rules, units, the stretch of every unit and the
// grade of every point; writes the acceleration of every unit. Must equal nck_host_grade_plan.
__kernel void acceleration(__global const nck_grade_rule_t *rules,
                           __global const nck_unit_t *units, __global const uint *stretch_of,
                           __global const int *grade_of, ulong count, __global double *a) {
    const size_t i = get_global_id(0);
    if (i >= count) return;
    const uint k = stretch_of[i];
    const double vv_begin = nck_grade_vv(&rules[k], grade_of[i + k]);
    const double vv_end = nck_grade_vv(&rules[k], grade_of[i + k + 1]);
    a[i] = nck_ramp_accel(units[i].length, vv_begin, vv_end);
}
