// SPDX-License-Identifier: MIT
// A machine to start from, and the ranges of all its numbers.
#include "nck/base/machine.h"

#include <string.h> // memset

static const int64_t free_below = -INT64_MAX - 1; // INT64_MIN, whose macro some checkers misread

void nck_machine_default(nck_machine_t *machine) {
    memset(machine, 0, sizeof *machine);
    machine->period_s = 1e-3;
    for (unsigned axis = 0; axis < NCK_AXIS_MAX; axis++) {
        nck_axis_t *const a = &machine->axis[axis];
        a->present = axis <= NCK_AXIS_Z;
        a->rotary = axis >= NCK_AXIS_A && axis <= NCK_AXIS_C;
        a->v_max = 100.0;
        a->rapid = 100.0;
        a->a_max = 1000.0;
        a->j_max = 10000.0;
        a->min_nm = free_below;
        a->max_nm = INT64_MAX;
    }
    machine->path.feed_max = 100.0;
    machine->path.a_max = 1000.0;
    machine->path.j_max = 10000.0;
    machine->path.chord_error = 1e-3;
    machine->path.tolerance = 0.01;
    machine->path.arc_radius = 5e-3;
    machine->slope = NCK_SLOPE_LINEAR;
    machine->kinematics = NCK_KINEMATICS_IDENTITY;
    machine->dialect.base = NCK_DIALECT_LINUXCNC;
    machine->dialect.plane = 17;
}

double nck_machine_counts(const nck_machine_t *machine, int axis) {
    return machine->axis[axis].rotary ? NCK_COUNTS_PER_DEG : NCK_COUNTS_PER_MM;
}

// NaN fails every comparison, infinity the upper one.
static int within(double value, double low, double high) {
    return value >= low && value <= high;
}

static int positive(double value) {
    return value > 0.0 && value <= 1e12;
}

static int place_good(const nck_axis_t *axis, int64_t place_nm) {
    const int64_t limit = axis->rotary ? (int64_t)NCK_ROTARY_MAX_DEG * NCK_COUNTS_PER_DEG
                                       : (int64_t)NCK_LINEAR_MAX_MM * NCK_COUNTS_PER_MM;
    return place_nm >= -limit && place_nm <= limit;
}

static int axis_good(const nck_axis_t *axis) {
    return axis->present <= 1 && axis->rotary <= 1 && positive(axis->v_max)
           && positive(axis->rapid) && axis->rapid <= axis->v_max && positive(axis->a_max)
           && positive(axis->j_max) && axis->min_nm <= axis->max_nm
           && (axis->min_nm == free_below || place_good(axis, axis->min_nm))
           && (axis->max_nm == INT64_MAX || place_good(axis, axis->max_nm));
}

// Axes that the machine lacks are not looked at, but for the places that offsets are summed from.
static int axes_good(const nck_machine_t *machine) {
    unsigned present = 0;
    for (unsigned k = 0; k < NCK_AXIS_MAX; k++) {
        const nck_axis_t *const axis = &machine->axis[k];
        if (axis->present && !axis_good(axis)) return 0;
        present += axis->present;
        if (!place_good(axis, machine->start_nm[k])) return 0;
        for (unsigned n = 0; n < 2; n++) {
            if (!place_good(axis, machine->home_nm[n][k])) return 0;
        }
        for (unsigned n = 0; n < NCK_WORK_SYSTEMS; n++) {
            if (!place_good(axis, machine->work_nm[n][k])) return 0;
        }
    }
    if (machine->kinematics == NCK_KINEMATICS_LATHE_XZ) {
        return machine->axis[NCK_AXIS_X].present && machine->axis[NCK_AXIS_Z].present;
    }
    return machine->kinematics == NCK_KINEMATICS_IDENTITY && present > 0;
}

static int path_good(const nck_machine_t *machine) {
    return positive(machine->path.feed_max) && positive(machine->path.a_max)
           && positive(machine->path.j_max) && positive(machine->path.chord_error)
           && within(machine->path.tolerance, 0.0, 1e6) && positive(machine->path.arc_radius)
           && machine->slope <= NCK_SLOPE_SSHAPE && machine->lookahead_blocks <= NCK_WINDOW
           && (machine->lookahead_blocks != 1 || machine->slope == NCK_SLOPE_SSHAPE);
}

static int dialect_good(const nck_machine_t *machine) {
    return machine->dialect.base <= NCK_DIALECT_MARLIN && machine->dialect.diameter <= 1
           && machine->dialect.inch <= 1 && machine->dialect.arc_absolute <= 1
           && machine->dialect.plane >= 17 && machine->dialect.plane <= 19
           && machine->dialect.block_skip <= 1 && machine->dialect.optional_stop <= 1
           && within(machine->dialect.feed_default, 0.0, 1e9)
           && within(machine->spindle.rpm_max, 0.0, 1e9)
           && machine->work_system < NCK_WORK_SYSTEMS;
}

static int tools_good(const nck_machine_t *machine) {
    if (machine->tool_count > NCK_TOOL_MAX) return 0;
    for (uint32_t k = 0; k < machine->tool_count; k++) {
        const nck_tool_t *const tool = &machine->tool[k];
        if (tool->orientation > 9 || !within(tool->radius_mm, 0.0, 1e6)) return 0;
        for (unsigned axis = 0; axis < 3; axis++) {
            if (!place_good(&machine->axis[axis], tool->offset_nm[axis])) return 0;
        }
    }
    return 1;
}

nck_status_t nck_machine_check(const nck_machine_t *machine) {
    const int good = within(machine->period_s, 1e-5, 0.1) && axes_good(machine)
                     && path_good(machine) && dialect_good(machine) && tools_good(machine);
    return good ? NCK_OK : NCK_E_MACHINE;
}
