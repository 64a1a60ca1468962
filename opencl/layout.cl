// SPDX-License-Identifier: MIT
// How this device lays out the records that the kernels read: a test compares it with C.
#include "host/unit.h"        // nck_unit_t nck_grade_rule_t
#include "nck/base/records.h" // nck_seg_t

#define OFFSET(record, field) (ulong)&((__global record *)0)->field

// One work-item. Writes, for every record, the offset of each field in order and then its size.
__kernel void layout(__global ulong *seg, __global ulong *unit, __global ulong *rule) {
    const ulong of_seg[] = {
        OFFSET(nck_seg_t, seq), OFFSET(nck_seg_t, line), OFFSET(nck_seg_t, block),
        OFFSET(nck_seg_t, kind), OFFSET(nck_seg_t, rapid), OFFSET(nck_seg_t, stop),
        OFFSET(nck_seg_t, keeps), OFFSET(nck_seg_t, modes), OFFSET(nck_seg_t, marks),
        OFFSET(nck_seg_t, start), OFFSET(nck_seg_t, end),
        OFFSET(nck_seg_t, length), OFFSET(nck_seg_t, s_begin),
        OFFSET(nck_seg_t, feed), OFFSET(nck_seg_t, feed_scale), OFFSET(nck_seg_t, v_most),
        OFFSET(nck_seg_t, spin), OFFSET(nck_seg_t, shape), sizeof(nck_seg_t),
    };
    const ulong of_unit[] = {
        OFFSET(nck_unit_t, seg), OFFSET(nck_unit_t, seg_end), OFFSET(nck_unit_t, limit),
        OFFSET(nck_unit_t, reserved), OFFSET(nck_unit_t, s), OFFSET(nck_unit_t, s_end),
        OFFSET(nck_unit_t, length), OFFSET(nck_unit_t, v_command), sizeof(nck_unit_t),
    };
    const ulong of_rule[] = {
        OFFSET(nck_grade_rule_t, period_s), OFFSET(nck_grade_rule_t, v_max),
        OFFSET(nck_grade_rule_t, v_min), OFFSET(nck_grade_rule_t, a),
        OFFSET(nck_grade_rule_t, length), OFFSET(nck_grade_rule_t, length_error),
        OFFSET(nck_grade_rule_t, chord_error), OFFSET(nck_grade_rule_t, a_axis),
        OFFSET(nck_grade_rule_t, steps), OFFSET(nck_grade_rule_t, count),
        sizeof(nck_grade_rule_t),
    };
    for (int k = 0; k < sizeof(of_seg) / sizeof(ulong); k++) seg[k] = of_seg[k];
    for (int k = 0; k < sizeof(of_unit) / sizeof(ulong); k++) unit[k] = of_unit[k];
    for (int k = 0; k < sizeof(of_rule) / sizeof(ulong); k++) rule[k] = of_rule[k];
}
