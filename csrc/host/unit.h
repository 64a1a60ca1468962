// SPDX-License-Identifier: MIT
// The records of planning by grades, for C and for the kernels of OpenCL.
#ifndef NCK_HOST_UNIT_H
#define NCK_HOST_UNIT_H

#include "nck/base/records.h" // NCK_AXIS_MAX

// A piece of path of the length L or a little more (Cao et al. 2014,
// section 4). Segs are named by their place in the caller's array.
typedef struct nck_unit {
    uint32_t seg;        // where the unit begins
    uint32_t seg_end;    // where it ends; the same or a later one
    uint8_t limit;       // nck_limit_t that set v_command
    uint8_t reserved[7]; // 0
    double s;            // path coordinate in seg [path mm]
    double s_end;        // path coordinate in seg_end [path mm]
    double length;       // [path mm]
    double v_command;    // the smallest speed that its segs are commanded to have [path mm/s]
} nck_unit_t;

// The numbers of one planning by grades; filled in by nck_host_grade_rule.
typedef struct nck_grade_rule {
    double period_s;     // T [s]
    double v_max;        // v_c, the command velocity and highest grade [path mm/s]
    double v_min;        // the speed of grade 0 [path mm/s]; 0 where paths begin at rest
    double a;            // tangential acceleration [path mm/s²]
    double length;       // L of a unit, eq. 10 [path mm]
    double length_error; // how far the steps may miss the unit's end [path mm]
    double chord_error;  // δ [mm]
    double a_axis[NCK_AXIS_MAX]; // of every axis [mm/s², deg/s²]; 0: no limit
    uint32_t steps;      // n, steps of a unit at command velocity
    uint32_t count;      // N, grades, eq. 11
} nck_grade_rule_t;

#endif
