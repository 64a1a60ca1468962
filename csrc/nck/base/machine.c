// SPDX-License-Identifier: MIT
// A machine to start from, and the ranges of all its numbers.
#include "nck/base/machine.h"

#include <stddef.h> // offsetof
#include <string.h> // memcpy memset

#include "nck/base/real.h" // nck_within

#define AT(member) offsetof(nck_machine_t, member)

enum { SWITCHES = 10 }; // of /1 … /9

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
    machine->slope = NCK_HAS_OPTIMAL ? NCK_SLOPE_OPTIMAL
                     : NCK_HAS_JERK  ? NCK_SLOPE_JERK
                                     : NCK_SLOPE_LINEAR;
    machine->kinematics = NCK_KINEMATICS_IDENTITY;
    machine->dialect.base = NCK_DIALECT_LINUXCNC;
    machine->dialect.plane = 17;
    machine->dialect.thread_pull = 1.0;
    machine->approach.height_nm = INT64_MAX;
    machine->approach.feed = 100.0 / 60.0;
}

unsigned nck_machine_approach_axis(const nck_machine_t *machine) {
    if (machine->approach.axis != 0) return machine->approach.axis - 1;
    return machine->kinematics == NCK_KINEMATICS_LATHE_XZ ? NCK_AXIS_X : NCK_AXIS_Z;
}

int64_t nck_machine_approach_nm(const nck_machine_t *machine) {
    const nck_axis_t *const axis = &machine->axis[nck_machine_approach_axis(machine)];
    const int64_t height_nm = machine->approach.height_nm;
    if (!axis->present) return free_below;
    return height_nm < INT64_MAX ? height_nm : axis->max_nm;
}

// In the order of nck_quantity_t. With lengths from 1e-7 to 1e7 mm the formulas of the rooms then
// keep their digits: v² and a·l stay within 1e-12 … 1e16, and the cube root's j²·l
// (nck_ladder_cbrt) within 1e-13 … 1e31 (good to 2 %).
static const nck_range_t ranges[NCK_QUANTITIES] = {
    {1e-5, 0.1}, {1e-6, 1e6}, {1e-3, 1e9}, {1e-3, 1e12}, {1e-9, 1e6}, {0.0, 1e6}, {0.0, 1e9},
    {0.0, 1e9}};

void nck_machine_range(uint32_t quantity, nck_range_t *range_out) {
    *range_out = ranges[quantity];
}

static int good(nck_quantity_t quantity, double value) {
    return nck_within(value, ranges[quantity].low, ranges[quantity].high);
}

// A number and its place.
typedef struct number {
    uint16_t at;
    uint8_t quantity; // nck_quantity_t
} number_t;

// Is each of them within the range of its quantity?
static int all_good(const char *self, const number_t *row, unsigned count) {
    int all = 1;
    for (unsigned k = 0; all && k < count; k++) {
        double value;
        memcpy(&value, &self[row[k].at], sizeof value);
        all = good((nck_quantity_t)row[k].quantity, value);
    }
    return all;
}

static int place_good(const nck_axis_t *axis, int64_t place_nm) {
    const int64_t limit = axis->rotary ? (int64_t)NCK_ROTARY_MAX_DEG * NCK_COUNTS_PER_DEG
                                       : (int64_t)NCK_LINEAR_MAX_MM * NCK_COUNTS_PER_MM;
    return place_nm >= -limit && place_nm <= limit;
}

static int axis_good(const nck_axis_t *axis) {
    static const number_t numbers[] = {{offsetof(nck_axis_t, v_max), NCK_QUANTITY_SPEED},
                                       {offsetof(nck_axis_t, rapid), NCK_QUANTITY_SPEED},
                                       {offsetof(nck_axis_t, a_max), NCK_QUANTITY_ACCELERATION},
                                       {offsetof(nck_axis_t, j_max), NCK_QUANTITY_JERK}};
    return axis->present <= 1 && axis->rotary <= 1 && all_good((const char *)axis, numbers, 4)
           && axis->rapid <= axis->v_max && axis->min_nm <= axis->max_nm
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
        for (unsigned n = 0; n < NCK_HOMES; n++) {
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

static int numbers_good(const nck_machine_t *machine) {
    static const number_t numbers[] = {
        {AT(period_s), NCK_QUANTITY_PERIOD}, {AT(path.feed_max), NCK_QUANTITY_SPEED},
        {AT(path.a_max), NCK_QUANTITY_ACCELERATION}, {AT(path.j_max), NCK_QUANTITY_JERK},
        {AT(path.chord_error), NCK_QUANTITY_ERROR}, {AT(path.tolerance), NCK_QUANTITY_SIZE},
        {AT(path.arc_radius), NCK_QUANTITY_ERROR}, {AT(dialect.feed_default), NCK_QUANTITY_FEED},
        {AT(spindle.rpm_max), NCK_QUANTITY_ROTATION},
        {AT(spindle.a_max_rpm_s), NCK_QUANTITY_ROTATION}
    };
    return all_good((const char *)machine, numbers, sizeof numbers / sizeof numbers[0])
           && nck_within(machine->dialect.thread_pull, 0.0, 10.0)
           && nck_within(machine->dialect.scale_unit, 0.0, 1.0);
}

// Choices of one byte: none is beyond its last.
static int bytes_good(const nck_machine_t *machine) {
    static const struct {
        uint16_t at;
        uint8_t last;
    } bytes[] = {
        {AT(roams), 1}, {AT(firmware), NCK_FIRMWARE_REPRAP}, {AT(dialect.diameter), 1},
        {AT(dialect.inch), 1}, {AT(dialect.arc_absolute), 1}, {AT(dialect.block_skip), 1},
        {AT(dialect.optional_stop), 1}, {AT(dialect.system), NCK_SYSTEM_C},
        {AT(dialect.feed), NCK_FEED_START_REV}, {AT(dialect.d_offset), NCK_D_DIAMETER},
        {AT(dialect.probe), NCK_PROBE_TOUCHES}, {AT(dialect.integers), NCK_INTEGERS_INCREMENTS},
        {AT(dialect.comp_start), NCK_COMP_START_B}
    };
    unsigned k = 0;
    while (k < sizeof bytes / sizeof bytes[0]
           && ((const uint8_t *)machine)[bytes[k].at] <= bytes[k].last) {
        k++;
    }
    return k == sizeof bytes / sizeof bytes[0];
}

static int choices_good(const nck_machine_t *machine) {
    return machine->slope <= NCK_SLOPE_OPTIMAL && machine->lookahead_blocks <= NCK_WINDOW
           && machine->lookahead_blocks != 1 && machine->dialect.base <= NCK_DIALECT_GRBLHAL
           && machine->dialect.plane >= 17 && machine->dialect.plane <= 19
           && machine->dialect.skip_switches >> SWITCHES == 0
           && !(machine->dialect.skip_switches & 1u) && machine->work_system < NCK_WORK_SYSTEMS
           && machine->home_more >> (NCK_HOMES - 2) == 0 && machine->spindle_waits <= 1;
}

static int is_slope_built(const nck_machine_t *machine) {
    return machine->slope == NCK_SLOPE_LINEAR || (machine->slope == NCK_SLOPE_JERK && NCK_HAS_JERK)
           || (machine->slope == NCK_SLOPE_OPTIMAL && NCK_HAS_OPTIMAL);
}

static int approach_good(const nck_machine_t *machine) {
    if (machine->approach.axis > NCK_AXIS_MAX) return 0;
    const nck_axis_t *const axis = &machine->axis[nck_machine_approach_axis(machine)];
    const int64_t height_nm = machine->approach.height_nm;
    const int in_travel = height_nm >= axis->min_nm && height_nm <= axis->max_nm;
    return good(NCK_QUANTITY_SPEED, machine->approach.feed) && !axis->rotary
           && (height_nm == INT64_MAX || (place_good(axis, height_nm) && in_travel));
}

int nck_machine_takes_tool(const nck_machine_t *machine, const nck_tool_t *tool) {
    const double wear = tool->wear_mm < 0.0 ? -tool->wear_mm : tool->wear_mm;
    if (tool->orientation > 9 || !good(NCK_QUANTITY_SIZE, tool->radius_mm)) return 0;
    if (!good(NCK_QUANTITY_SIZE, wear)) return 0;
    for (unsigned axis = 0; axis < 3; axis++) {
        if (!place_good(&machine->axis[axis], tool->offset_nm[axis])) return 0;
    }
    return 1;
}

static int tools_good(const nck_machine_t *machine) {
    int all = machine->tool_count <= NCK_TOOL_MAX;
    for (uint32_t k = 0; all && k < machine->tool_count; k++) {
        all = nck_machine_takes_tool(machine, &machine->tool[k]);
    }
    return all;
}

static int own_good(const nck_machine_t *machine) {
    int all = machine->own_m_count <= NCK_OWN_M_MAX;
    for (uint32_t k = 0; all && k < machine->own_m_count; k++) {
        all = machine->own_m[k].code <= NCK_M_MAX && machine->own_m[k].waits <= 1
              && machine->own_m[k].stays <= 1;
    }
    return all;
}

static int own_g_good(const nck_own_g_t *own) {
    return own->code <= NCK_G_MAX && own->action <= NCK_G_TOLERANCE
           && (own->letter == 0 || own->letter == 'P' || own->letter == 'Q')
           && good(NCK_QUANTITY_SIZE, own->tolerance);
}

static int more_good(const nck_machine_t *machine, const nck_work_more_t *work) {
    int all = work->number >= 1 && work->number <= NCK_WORK_MOST;
    for (unsigned k = 0; all && k < NCK_AXIS_MAX; k++) {
        all = place_good(&machine->axis[k], work->zero_nm[k]);
    }
    return all;
}

// Further G codes and work systems.
static int further_good(const nck_machine_t *machine) {
    int all = machine->own_g_count <= NCK_OWN_M_MAX && machine->work_more_count <= NCK_OWN_M_MAX;
    for (uint32_t k = 0; all && k < machine->own_g_count; k++) {
        all = own_g_good(&machine->own_g[k]);
    }
    for (uint32_t k = 0; all && k < machine->work_more_count; k++) {
        all = more_good(machine, &machine->work_more[k]);
    }
    return all;
}

nck_status_t nck_machine_check(const nck_machine_t *machine) {
    const int all = numbers_good(machine) && axes_good(machine) && bytes_good(machine)
                    && choices_good(machine) && tools_good(machine) && own_good(machine)
                    && further_good(machine) && approach_good(machine);
    if (!all) return NCK_E_MACHINE;
    return is_slope_built(machine) ? NCK_OK : NCK_E_UNSUPPORTED;
}
