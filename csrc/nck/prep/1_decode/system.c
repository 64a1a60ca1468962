// SPDX-License-Identifier: MIT
// Parameters that the kernel keeps itself: positions, offsets, modes. Fanuc's work offsets can be
// set, the others are read only.
#include "nck/prep/1_decode/axis.h" // nck_decode_scale_of
#include "nck/prep/1_decode/parts.h"

#include <stddef.h> // NULL

#include "nck/base/real.h" // nck_floor nck_fabs

enum {
    SYSTEM_ROW = 20,           // numbers from one work system to the next
    FANUC_OWN = 1000,          // Fanuc: the first number that the control keeps
    FANUC_WORK = 5221, FANUC_SYSTEMS = 6,
    LINUXCNC_OWN = 5061, LINUXCNC_LAST = 5602,
    PROBED = 5061, PROBE_TOUCHED = 5070 // where a probe has ended; did it meet anything?
};

// What may be asked for.
typedef enum ask {
    ASK_NOTHING, ASK_PROGRAM, ASK_MACHINE, ASK_WORK, ASK_FEED, ASK_SPEED, ASK_TOOL, ASK_NEXT_TOOL,
    ASK_SYSTEM, ASK_MOTION, ASK_PLANE, ASK_DISTANCE, ASK_INCREMENTAL, ASK_INCH, ASK_METRIC,
    ASK_UNITS, ASK_FEED_MODE, ASK_DIAMETER, ASK_CENTRE, ASK_SPINDLE, ASK_LEVEL, ASK_RETURNED,
    ASK_HAS_RETURNED, ASK_ZERO
} ask_t;

// Counts of an axis in the units in force.
static double shown(const nck_decode_t *self, unsigned axis, int64_t counts) {
    if (self->place.rotary >> axis & 1u) return (double)counts / (double)NCK_COUNTS_PER_DEG;
    const double mm = (double)counts / (double)NCK_COUNTS_PER_MM;
    const int fanuc = self->machine->dialect.base == NCK_DIALECT_FANUC;
    const double factor = fanuc && axis == NCK_AXIS_X && self->modal.diameter ? 2.0 : 1.0;
    return factor * (self->modal.inch ? mm / 25.4 : mm);
}

// One unit of what `shown` tells, in counts.
static double counts_of(const nck_decode_t *self, unsigned axis) {
    if (self->place.rotary >> axis & 1u) return (double)NCK_COUNTS_PER_DEG;
    const double mm = self->modal.inch ? 25.4 : 1.0;
    const double halves = axis == NCK_AXIS_X && self->modal.diameter ? 0.5 : 1.0;
    return halves * mm * (double)NCK_COUNTS_PER_MM;
}

// index: of the axis; of ASK_WORK: work system × SYSTEM_ROW + axis.
static double place(const nck_decode_t *self, ask_t ask, unsigned index) {
    const unsigned axis = index % SYSTEM_ROW;
    if (axis >= NCK_AXIS_MAX) return 0.0;
    const int64_t at = self->place.position_nm[axis];
    if (ask == ASK_MACHINE) return shown(self, axis, at);
    if (ask == ASK_WORK) return shown(self, axis, self->place.work_nm[index / SYSTEM_ROW][axis]);
    return shown(self, axis, at - self->place.origin_nm[axis]);
}

static double feed_group(const nck_decode_t *self) {
    static const double codes[] = {94.0, 93.0, 95.0};
    return codes[self->modal.feed_mode];
}

static double motion(const nck_decode_t *self) {
    return self->modal.motion < 0 ? 80.0 : self->modal.motion / 10.0;
}

static double setting(const nck_decode_t *self, ask_t ask) {
    switch (ask) {
    case ASK_MOTION: return motion(self);
    case ASK_PLANE: return self->modal.plane;
    case ASK_DISTANCE: return 90.0 + self->modal.incremental;
    case ASK_INCREMENTAL: return self->modal.incremental;
    case ASK_INCH: return self->modal.inch;
    case ASK_METRIC: return 1.0 - self->modal.inch;
    case ASK_UNITS: return 21.0 - self->modal.inch;
    case ASK_FEED_MODE: return feed_group(self);
    case ASK_DIAMETER: return self->modal.diameter;
    case ASK_CENTRE: return self->modal.centre_absolute;
    default: return self->modal.spindle_on;
    }
}

static double number_in_force(const nck_decode_t *self, ask_t ask) {
    const int per_minute = self->modal.feed_mode == NCK_FEED_INVERSE;
    switch (ask) {
    case ASK_FEED: return self->modal.feed / (self->modal.inch && !per_minute ? 25.4 : 1.0);
    case ASK_SPEED: return self->modal.speed > 0.0 ? self->modal.speed : 0.0;
    case ASK_TOOL: return self->modal.tool_in;
    case ASK_NEXT_TOOL: return self->modal.tool_next;
    case ASK_SYSTEM: return self->place.work_system + 1.0;
    case ASK_RETURNED: return self->macro.returned;
    case ASK_HAS_RETURNED: return self->macro.has_returned;
    case ASK_LEVEL: return self->macro.depth;
    default: return 0.0;
    }
}

static double answer(const nck_decode_t *self, ask_t ask, unsigned index) {
    if (ask <= ASK_WORK) return place(self, ask, index);
    const int sets = ask >= ASK_MOTION && ask <= ASK_SPINDLE;
    return sets ? setting(self, ask) : number_in_force(self, ask);
}

// What a range of numbers asks for; present: the k-th is of the k-th axis that the machine has.
typedef struct row {
    uint16_t first, count;
    uint8_t ask, present;
} row_t;

static const row_t linuxcnc_rows[] = {
    {PROBED, 10, ASK_ZERO, 0},
    {5220, 1, ASK_SYSTEM, 0}, {5221, 9 * SYSTEM_ROW, ASK_WORK, 0}, {5400, 1, ASK_TOOL, 0},
    {5420, 9, ASK_PROGRAM, 0}, {0, 0, 0, 0}
};

// #5401 … #5500 are Haas's: how long each tool has cut. Here all are new.
static const row_t fanuc_rows[] = {
    {5001, 9, ASK_PROGRAM, 1}, {5021, 9, ASK_MACHINE, 1}, {5041, 9, ASK_PROGRAM, 1},
    {FANUC_WORK, FANUC_SYSTEMS * SYSTEM_ROW, ASK_WORK, 1}, {5401, 100, ASK_ZERO, 0},
    {4001, 1, ASK_MOTION, 0},
    {4002, 1, ASK_PLANE, 0}, {4003, 1, ASK_DISTANCE, 0}, {4005, 1, ASK_FEED_MODE, 0},
    {4006, 1, ASK_UNITS, 0}, {4109, 1, ASK_FEED, 0}, {4119, 1, ASK_SPEED, 0},
    {4120, 1, ASK_NEXT_TOOL, 0}, {0, 0, 0, 0}
};

// The axis that is the k-th of the machine, from 0.
static unsigned present_axis(const nck_decode_t *self, unsigned k) {
    unsigned axis = 0;
    for (; axis < NCK_AXIS_MAX; axis++) {
        if (!(self->place.axes >> axis & 1u)) continue;
        if (k == 0) break;
        k--;
    }
    return axis;
}

int nck_parameter_is_own(const nck_decode_t *self, uint32_t number) {
    if (!NCK_HAS_VARIABLES) return 0;
    if (self->machine->dialect.base == NCK_DIALECT_FANUC) return number >= FANUC_OWN;
    return number >= LINUXCNC_OWN && number <= LINUXCNC_LAST;
}

nck_status_t nck_parameter_number(nck_decode_t *self, uint32_t number, double *value_out) {
    if (!NCK_HAS_VARIABLES) return NCK_E_UNSUPPORTED;
    const int fanuc = self->machine->dialect.base == NCK_DIALECT_FANUC;
    const double *const known = nck_variable_find(self, number);
    *value_out = known != NULL ? *known : fanuc ? NCK_NO_VALUE : 0.0;
    if (known != NULL || !nck_parameter_is_own(self, number)) return NCK_OK;
    const row_t *row = fanuc ? fanuc_rows : linuxcnc_rows;
    for (; row->count != 0; row++) {
        const uint32_t index = number - row->first;
        if (index >= row->count) continue;
        const unsigned k = index % SYSTEM_ROW;
        const unsigned axis = row->present ? present_axis(self, k) : k;
        *value_out = answer(self, (ask_t)row->ask, index - k + axis);
        return NCK_OK;
    }
    return NCK_E_UNSUPPORTED;
}

nck_status_t nck_parameter_set_probe(nck_decode_t *self, int touched) {
    if (!NCK_HAS_VARIABLES) return NCK_OK;
    nck_status_t status = NCK_OK;
    for (unsigned axis = 0; axis < NCK_AXIS_MAX && status == NCK_OK; axis++) {
        if (!(self->place.axes >> axis & 1u)) continue;
        status = nck_variable_set(self, PROBED + axis, place(self, ASK_PROGRAM, axis));
    }
    return status == NCK_OK ? nck_variable_set(self, PROBE_TOUCHED, touched) : status;
}

nck_status_t nck_parameter_set_work(nck_decode_t *self, uint32_t number, double value) {
    if (!NCK_HAS_VARIABLES) return NCK_E_UNSUPPORTED;
    const uint32_t index = number - FANUC_WORK;
    const unsigned axis = present_axis(self, index % SYSTEM_ROW);
    const int fanuc = self->machine->dialect.base == NCK_DIALECT_FANUC;
    if (!fanuc || index >= FANUC_SYSTEMS * SYSTEM_ROW || axis >= NCK_AXIS_MAX) {
        return NCK_E_UNSUPPORTED;
    }
    if (self->modal.comp) return NCK_E_COMP_ON;
    if (self->layout.on) return NCK_E_LAYOUT_ON;
    const double counts = nck_floor(value * counts_of(self, axis) + 0.5);
    if (!(nck_fabs(counts) <= (double)nck_decode_scale_of(self, axis)->limit)) return NCK_E_VALUE;
    self->place.work_nm[index / SYSTEM_ROW][axis] = (int64_t)counts;
    nck_decode_origin(self);
    return NCK_OK;
}

// ---- names

// Where one begins as another one does, the longer one is the first.
static const char names[] =
    "_FEED _RPM _METRIC _IMPERIAL _ABSOLUTE _INCREMENTAL _PLANE _MOTION_MODE "
    "_COORD_SYSTEM _CURRENT_TOOL _SELECTED_TOOL _LATHE_DIAMETER_MODE _IJK_ABSOLUTE_MODE "
    "_SPINDLE_ON _VALUE_RETURNED _VALUE _TASK ";

static const uint8_t asks[] = {
    ASK_FEED, ASK_SPEED, ASK_METRIC, ASK_INCH, ASK_DISTANCE, ASK_INCREMENTAL, ASK_PLANE, ASK_MOTION,
    ASK_SYSTEM, ASK_TOOL, ASK_NEXT_TOOL, ASK_DIAMETER, ASK_CENTRE, ASK_SPINDLE, ASK_HAS_RETURNED,
    ASK_RETURNED, ASK_ZERO
};

// As LinuxCNC says it: codes in tenths, G54 as 540.
static double named_answer(const nck_decode_t *self, ask_t ask) {
    const uint32_t system = self->place.work_system;
    const double value = answer(self, ask, 0);
    switch (ask) {
    case ASK_DISTANCE: return !self->modal.incremental;
    case ASK_PLANE:
    case ASK_MOTION: return 10.0 * value;
    case ASK_SYSTEM: return system < 6 ? 540.0 + 10.0 * system : 585.0 + system;
    default: return value;
    }
}

nck_status_t nck_parameter_name(nck_decode_t *self, const char *at, const char *end,
                                double *value_out) {
    if (!NCK_HAS_VARIABLES) return NCK_E_UNSUPPORTED;
    const uint64_t key = nck_variable_name(at, end);
    const double *const known = nck_variable_find(self, key);
    *value_out = known != NULL ? *known : 0.0;
    if (known != NULL) return NCK_OK;
    if (*at != '_') return NCK_E_UNSET;
    const char *behind = NULL;
    const unsigned number = nck_decode_listed(at, names, &behind);
    if (number != 0 && behind == end) {
        *value_out = named_answer(self, (ask_t)asks[number - 1]);
        return NCK_OK;
    }
    for (unsigned axis = 0; axis < NCK_AXIS_MAX && end == at + 2; axis++) {
        if ((at[1] & ~0x20) != nck_decode_letter(axis)) continue;
        *value_out = place(self, ASK_PROGRAM, axis);
        return NCK_OK;
    }
    return NCK_E_UNSET;
}
