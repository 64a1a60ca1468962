// SPDX-License-Identifier: MIT
// Parameters that the kernel keeps itself: positions, offsets, modes. Fanuc's work offsets can be
// set, the others are read only.
#include "nck/prep/1_decode/macro/parts.h"
#include "nck/prep/1_decode/state/state.h" // nck_variable_find nck_variable_name nck_variable_set
#include "nck/prep/1_decode/number/number.h" // nck_decode_letter nck_decode_scale_of
#include "nck/prep/1_decode/tongue/tongue.h" // nck_lathe_is_a
#include "nck/prep/1_decode/place/place.h" // nck_decode_origin nck_turned_by nck_turned_place
#include "nck/base/real.h" // nck_floor nck_fabs nck_real_of

#include <stddef.h> // NULL size_t

enum {
    SYSTEM_ROW = 20,           // numbers from one work system to the next
    FANUC_NONE = 34,           // Fanuc: behind a call's own, up to #100, it has none
    FANUC_SHARED = 100, FANUC_OWN = 1000, // from here on the control keeps them
    FANUC_OUTER = 5201, FANUC_WORK = 5221, FANUC_SYSTEMS = 6,
    LINUXCNC_OWN = 5001, LINUXCNC_KEPT = 5061, LINUXCNC_LAST = 5601,
    LAST_OF_GROUP = 30,        // G3, in tenths
    TIMER = 3001, HOURS = 3002, BLOCKS = 3003, OPERATING = 3004, // Fanuc: what counts on, switches
    MIRROR = 3007, // Fanuc: axes that a switch mirrors; behind it, whether a program is begun again
    DATE = 3011, OLD_DATE = 20000101, // where nobody has said which day it is
    SHOWN = 5599, // LinuxCNC: whether (DEBUG, …) is shown
    PROBED = 5061, PROBE_TOUCHED = 5070, // where a probe has ended; did it meet anything?
    ANSWERED = 5399                      // what M66 has found
};

// What may be asked for.
typedef enum ask {
    ASK_NOTHING, ASK_PROGRAM, ASK_NOSE, ASK_MACHINE, ASK_OUTER, ASK_WORK, ASK_FEED, ASK_SPEED,
    ASK_TOOL, ASK_NEXT_TOOL, ASK_TURRET, ASK_SYSTEM, ASK_MOTION, ASK_PLANE, ASK_DISTANCE,
    ASK_INCREMENTAL, ASK_INCH, ASK_METRIC, ASK_UNITS, ASK_FEED_MODE, ASK_DIAMETER, ASK_CENTRE,
    ASK_SPINDLE, ASK_SURFACE, ASK_RETRACT, ASK_SYSTEM_CODE, ASK_LEVEL, ASK_RETURNED,
    ASK_HAS_RETURNED, ASK_DATE, ASK_TIME, ASK_ZERO
} ask_t;

// Counts of an axis in the units in force.
static double shown(const nck_decode_t *self, unsigned axis, int64_t counts) {
    if (self->place.rotary >> axis & 1u) return (double)counts / (double)NCK_COUNTS_PER_DEG;
    const double mm = (double)counts / (double)NCK_COUNTS_PER_MM;
    const int fanuc = nck_is_fanuc(self);
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

// index: of the axis; of ASK_WORK: work system × SYSTEM_ROW + axis. ASK_NOSE: in the work system,
// the tool's offset included, as Fanuc tells where an axis is now.
static double place(const nck_decode_t *self, ask_t ask, unsigned index) {
    const unsigned axis = index % SYSTEM_ROW;
    const int linuxcnc = self->tongue == NCK_TONGUE_LINUXCNC;
    if (linuxcnc && ask == ASK_WORK && axis == NCK_AXIS_MAX) { // R, behind the axes
        return nck_turned_by(self, index / SYSTEM_ROW);
    }
    if (axis >= NCK_AXIS_MAX) return 0.0;
    const int64_t at = self->place.position_nm[axis];
    const int64_t tool = ask == ASK_NOSE && axis < 3 ? self->place.tool_nm[axis] : 0;
    if (ask == ASK_MACHINE) return shown(self, axis, at);
    if (ask == ASK_OUTER) return shown(self, axis, self->place.outer_nm[axis]);
    if (ask == ASK_WORK) return shown(self, axis, self->place.work_nm[index / SYSTEM_ROW][axis]);
    if (linuxcnc) return shown(self, axis, nck_turned_place(self, axis));
    return shown(self, axis, at - self->place.origin_nm[axis] + tool);
}

static double feed_group(const nck_decode_t *self) {
    static const double codes[] = {94.0, 93.0, 95.0}, codes_a[] = {98.0, 93.0, 99.0};
    return nck_lathe_is_a(self) ? codes_a[self->modal.feed_mode] : codes[self->modal.feed_mode];
}

// G20 G21; on Fanuc's lathes of system C G70 G71.
static double units_group(const nck_decode_t *self) {
    const int c = self->lathe && self->machine->dialect.system == NCK_SYSTEM_C;
    return (c ? 71.0 : 21.0) - self->modal.inch;
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
    case ASK_UNITS: return units_group(self);
    case ASK_FEED_MODE: return feed_group(self);
    case ASK_DIAMETER: return self->modal.diameter;
    case ASK_CENTRE: return self->modal.centre_absolute;
    case ASK_SURFACE: return 97.0 - self->modal.surface_on;
    default: return self->modal.spindle_on;
    }
}

// Fanuc's lathes: the tool and its offset, as T says both.
static double turret(const nck_decode_t *self) {
    const int32_t offset = self->modal.offset_in;
    if (offset < 0 || !self->lathe) return self->modal.tool_next;
    return (double)self->modal.tool_in * (double)NCK_LATHE_TOOLS + offset;
}

static double feed_in_force(const nck_decode_t *self) {
    const int is_inverse = self->modal.feed_mode == NCK_FEED_INVERSE;
    return self->modal.feed / (self->modal.inch && !is_inverse ? 25.4 : 1.0);
}

static int is_day_said(const nck_decode_t *self) {
    const nck_wall_clock_t *const clock = NCK_CLOCK_AT(self->machine);
    (void)self;
    return NCK_HAS_VARIABLES && clock->date != 0;
}

static double calendar(const nck_decode_t *self, ask_t ask) {
    const nck_wall_clock_t *const clock = NCK_CLOCK_AT(self->machine);
    if (ask == ASK_TIME && NCK_HAS_VARIABLES) return clock->time;
    if (ask != ASK_DATE || !NCK_HAS_VARIABLES) return 0.0;
    return is_day_said(self) ? clock->date : OLD_DATE;
}

static double number_in_force(const nck_decode_t *self, ask_t ask) {
    switch (ask) {
    case ASK_FEED: return feed_in_force(self);
    case ASK_SPEED: return self->modal.speed > 0.0 ? self->modal.speed : 0.0;
    case ASK_TOOL: return self->modal.tool_in;
    case ASK_NEXT_TOOL: return self->modal.tool_next;
    case ASK_TURRET: return turret(self);
    case ASK_SYSTEM: return self->place.work_system + 1.0;
    case ASK_RETURNED: return self->macro.returned;
    case ASK_HAS_RETURNED: return self->macro.has_returned;
    case ASK_LEVEL: return self->macro.depth;
    default: return calendar(self, ask);
    }
}

static double answer(const nck_decode_t *self, ask_t ask, unsigned index) {
    if (ask <= ASK_WORK) return place(self, ask, index);
    const int sets = ask >= ASK_MOTION && ask <= ASK_SURFACE;
    // What is in force of the other groups: G98 G99; G54 … G59, G54.1.
    if (ask == ASK_RETRACT || ask == ASK_SYSTEM_CODE) {
        const uint32_t system = self->place.work_system;
        if (ask == ASK_RETRACT) return 98.0 + self->held.cycle.to_r;
        return system == NCK_WORK_SYSTEMS ? 54.1 : 54.0 + system;
    }
    return sets ? setting(self, ask) : number_in_force(self, ask);
}

// What a range of numbers asks for, and whose it is: bits of nck_tongue_t. What no row gives to a
// language is a parameter of the program's own, or refused (nck_parameter_is_own).
typedef struct row {
    uint16_t first;
    uint8_t count, ask, whose;
    uint8_t present; // 1: the k-th is of the k-th axis that the machine has
} row_t;

enum { L = NCK_TONGUE_LINUXCNC, F = NCK_TONGUE_FANUC, T = NCK_TONGUE_TURNING };

// #5401 … #5500 are Haas's: how long each tool has cut. Here all are new.
static const row_t rows[] = {
    {5400, 1, ASK_TOOL, L, 0}, // before the zeros, whose last row ends there
    {PROBED, 10, ASK_ZERO, L, 0}, {PROBED, 9, ASK_ZERO, F | T, 1}, {5220, 1, ASK_SYSTEM, L, 0},
    {5221, 9 * SYSTEM_ROW, ASK_WORK, L, 0}, {5420, 9, ASK_PROGRAM, L, 0},
    {5001, 9, ASK_PROGRAM, F | T, 1}, {5021, 9, ASK_MACHINE, F | T, 1},
    {5041, 9, ASK_NOSE, F | T, 1}, {FANUC_OUTER, SYSTEM_ROW, ASK_OUTER, F | T, 1},
    {FANUC_WORK, FANUC_SYSTEMS * SYSTEM_ROW, ASK_WORK, F | T, 1},
    {5401, 100, ASK_ZERO, F | T, 0}, {4001, 1, ASK_MOTION, F | T, 0}, {4002, 1, ASK_PLANE, F, 0},
    {4002, 1, ASK_SURFACE, T, 0}, {4003, 1, ASK_DISTANCE, F | T, 0},
    {4005, 1, ASK_FEED_MODE, F | T, 0}, {4006, 1, ASK_UNITS, F | T, 0},
    {4016, 1, ASK_PLANE, T, 0}, {4109, 1, ASK_FEED, F | T, 0}, {4119, 1, ASK_SPEED, F | T, 0},
    {4120, 1, ASK_NEXT_TOOL, F, 0}, {4120, 1, ASK_TURRET, T, 0}, {BLOCKS, 2, ASK_ZERO, F | T, 0},
    {MIRROR, 2, ASK_ZERO, F | T, 0}, {4010, 1, ASK_RETRACT, F, 0},
    {4014, 1, ASK_SYSTEM_CODE, F | T, 0}, {DATE, 1, ASK_DATE, F | T, 0},
    {DATE + 1, 1, ASK_TIME, F | T, 0}
};

static const row_t *find(const nck_decode_t *self, uint32_t number) {
    for (size_t k = 0; k < sizeof rows / sizeof rows[0]; k++) {
        if (number - rows[k].first < rows[k].count && (rows[k].whose & self->tongue)) {
            return &rows[k];
        }
    }
    return NULL;
}

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
    if (self->tongue == NCK_TONGUE_LINUXCNC) return number >= LINUXCNC_OWN;
    return number >= FANUC_OWN || (number >= FANUC_NONE && number < FANUC_SHARED);
}

// Why a parameter of the control's own cannot be reached.
static nck_status_t refuse(const nck_decode_t *self, uint32_t number) {
    const int linuxcnc = self->tongue == NCK_TONGUE_LINUXCNC;
    if (linuxcnc && number < LINUXCNC_KEPT) return NCK_E_OTHER_BASE;
    return linuxcnc && number > LINUXCNC_LAST ? NCK_E_NUMBER_RANGE : NCK_E_UNSUPPORTED;
}

int nck_parameter_is_switch(const nck_decode_t *self, uint32_t number) {
    if (self->tongue == NCK_TONGUE_LINUXCNC) return number == SHOWN;
    return (self->tongue & NCK_TONGUES_FANUC) && number >= TIMER && number <= OPERATING;
}

int nck_parameter_is_free(const nck_decode_t *self, uint32_t number) {
    if (!NCK_HAS_VARIABLES) return 0;
    const int linuxcnc = self->tongue == NCK_TONGUE_LINUXCNC;
    const uint32_t first = linuxcnc ? PROBED : BLOCKS, last = linuxcnc ? PROBE_TOUCHED : OPERATING;
    return number >= first && number <= last;
}

double nck_parameter_limit(nck_status_t status) {
    if (status == NCK_E_OTHER_BASE) return NCK_TONGUES_FANUC;
    return status == NCK_E_NUMBER_RANGE ? (double)LINUXCNC_LAST : 0.0;
}

// What a row cannot tell: Fanuc's group 01 behind a cycle of another group, a distance mode that
// system A has not, and where an axis is while its tool goes beside the contour.
static nck_status_t check_row(const nck_decode_t *self, const row_t *row) {
    const int fanuc = (row->whose & NCK_TONGUES_FANUC) != 0;
    const int cycle = row->ask == ASK_MOTION && (uint32_t)self->modal.motion > LAST_OF_GROUP;
    const int distance = row->ask == ASK_DISTANCE && nck_lathe_is_a(self);
    const int where = row->ask == ASK_NOSE || row->ask == ASK_MACHINE;
    if (fanuc && (cycle || distance)) return NCK_E_UNSUPPORTED;
    return where && self->modal.comp == NCK_COMPENSATES ? NCK_E_COMP_ON : NCK_OK;
}

// ---- what counts on

static void note(nck_decode_t *self, nck_note_t note, uint32_t number) {
    const nck_diagnostic_t finding = {(int32_t)note, self->line.tag, 0, '#', number, 0.0};
    nck_decode_note(self, &finding);
}

// What the machine says of it.
static double timer(const nck_decode_t *self, uint32_t number) {
    const nck_wall_clock_t *const clock = NCK_CLOCK_AT(self->machine);
    (void)self;
    if (!NCK_HAS_VARIABLES) return 0.0;
    return number == TIMER ? clock->on_ms : clock->cut_s / 3600.0;
}

nck_status_t nck_parameter_set_switch(nck_decode_t *self, uint32_t number, double value) {
    if (number > HOURS) return NCK_OK;
    const double from = timer(self, number);
    return nck_variable_wait(self, number, nck_value_is(value) ? value - from : -from);
}

// A parameter that the control keeps itself.
static nck_status_t read_own(nck_decode_t *self, uint32_t number, double *value_out) {
    const row_t *const row = find(self, number);
    if (row == NULL) return refuse(self, number);
    const uint32_t index = number - row->first;
    const unsigned k = index % SYSTEM_ROW;
    const unsigned axis = row->present ? present_axis(self, k) : k;
    if (row->present && axis >= NCK_AXIS_MAX) return NCK_E_UNSUPPORTED;
    *value_out = answer(self, (ask_t)row->ask, index - k + axis);
    const int asks_day = row->ask == ASK_DATE || row->ask == ASK_TIME;
    if (asks_day && !is_day_said(self)) note(self, NCK_NOTE_CLOCK, number);
    return check_row(self, row);
}

nck_status_t nck_parameter_number(nck_decode_t *self, uint32_t number, double *value_out) {
    if (!NCK_HAS_VARIABLES) return NCK_E_UNSUPPORTED;
    const int fanuc = (self->tongue & NCK_TONGUES_FANUC) != 0;
    if (fanuc && number - TIMER < 2) {
        // Each question takes a millisecond, so that what waits for a time comes to an end.
        const double *const set = nck_variable_find(self, number);
        *value_out = timer(self, number) + (set != NULL ? *set : 0.0);
        note(self, NCK_NOTE_TIMER, number);
        return number == TIMER ? nck_parameter_set_switch(self, number, *value_out + 1.0) : NCK_OK;
    }
    const double *const known = nck_variable_find(self, number);
    *value_out = known != NULL ? *known : fanuc ? NCK_NO_VALUE : 0.0;
    if (known != NULL || !nck_parameter_is_own(self, number)) return NCK_OK;
    return read_own(self, number, value_out);
}

nck_status_t nck_parameter_set_probe(nck_decode_t *self, int touched) {
    if (!NCK_HAS_VARIABLES) return NCK_OK;
    const int fanuc = (self->tongue & NCK_TONGUES_FANUC) != 0;
    nck_status_t status = NCK_OK;
    unsigned present = 0;
    for (unsigned axis = 0; axis < NCK_AXIS_MAX && status == NCK_OK; axis++) {
        if (!(self->place.axes >> axis & 1u)) continue;
        const unsigned index = fanuc ? present++ : axis;
        const double at = place(self, fanuc ? ASK_NOSE : ASK_PROGRAM, axis);
        status = nck_variable_set(self, PROBED + index, at);
    }
    if (fanuc) return status; // which does not tell whether something was met
    return status == NCK_OK ? nck_variable_set(self, PROBE_TOUCHED, touched) : status;
}

nck_status_t nck_parameter_set_answer(nck_decode_t *self, double value) {
    if (!NCK_HAS_VARIABLES) return NCK_OK;
    return nck_variable_set(self, ANSWERED, value);
}

nck_status_t nck_parameter_set_work(nck_decode_t *self, uint32_t number, double value) {
    if (!NCK_HAS_VARIABLES) return NCK_E_UNSUPPORTED;
    const row_t *const row = find(self, number);
    const int zero = row != NULL && (row->whose & NCK_TONGUES_FANUC)
                     && (row->ask == ASK_WORK || row->ask == ASK_OUTER);
    if (!zero) return refuse(self, number);
    const uint32_t index = number - row->first;
    const unsigned axis = present_axis(self, index % SYSTEM_ROW);
    if (axis >= NCK_AXIS_MAX) return NCK_E_UNSUPPORTED;
    if (self->modal.comp) return NCK_E_COMP_ON;
    if (self->layout.on) return NCK_E_LAYOUT_ON;
    const double counts = nck_floor(value * counts_of(self, axis) + 0.5);
    const double most = nck_real_of(nck_decode_scale_of(self, axis)->limit);
    if (!(nck_fabs(counts) <= most)) return NCK_E_VALUE;
    int64_t *const zeros = row->ask == ASK_OUTER ? self->place.outer_nm
                                                 : self->place.work_nm[index / SYSTEM_ROW];
    zeros[axis] = (int64_t)counts;
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
