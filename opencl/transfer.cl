// SPDX-License-Identifier: MIT
// Transfer speeds: the cap of every point between two planning units.
#include "nck/prep/4_lookahead/angle_math.h"    // nck_angle_tangents
#include "nck/prep/4_lookahead/transfer_math.h" // nck_transfer_tangent nck_transfer_speed

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
    v_transfer[i] = 0.0;
    angle[i] = 0.0;
    if (i == 0 || i + 1 == count || stretch_of[i - 1] != k || stretch_of[i + 1] != k) return;
    const size_t unit = i - k;
    const uint in = units[unit - 1].seg_end;
    const uint out = units[unit].seg;
    v_transfer[i] = nck_min(v[unit - 1], v[unit]);
    if (in == out) return; // inside of a seg the path is smooth
    double t_in[NCK_AXIS_MAX];
    double t_out[NCK_AXIS_MAX];
    int axis;
    nck_transfer_tangent(&segs[in], 1, t_in);
    nck_transfer_tangent(&segs[out], 0, t_out);
    angle[i] = nck_angle_tangents(t_in, t_out);
    v_transfer[i] = nck_transfer_speed(t_in, t_out, &rules[k], v_transfer[i], &axis);
}
