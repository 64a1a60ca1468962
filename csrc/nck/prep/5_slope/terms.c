// SPDX-License-Identifier: MIT
// Room 5, slope: what its velocity profile means to the other rooms.
#include "nck/base/limits.h"              // NCK_FILTER_TAPS
#include "nck/base/real.h"                // nck_max nck_min
#include "nck/base/root_math.h"           // nck_root_cube
#include "nck/prep/5_slope/ladder_math.h" // nck_ladder_raise NCK_LADDER_STRETCH
#include "nck/prep/5_slope/slope.h"
#include "nck/prep/5_slope/tuning.h" // NCK_KNOT_SHARE …

#define FILTERS_LEAST 2.0 // that a ramp lasts

// Axes from X on up to the last one that the machine has.
static uint8_t axes_of(const nck_machine_t *machine) {
    uint8_t axes = NCK_AXIS_MAX;
    while (axes > 0 && !machine->axis[axes - 1].present) axes--;
    return axes;
}

// What all axes allow together, squared: along no tangent do they allow more.
typedef struct square_sums {
    double aa; // of accelerations [mm²/s⁴]
    double jj; // of jerks [mm²/s⁶]
} square_sums_t;

static square_sums_t sums_of(const nck_machine_t *machine, uint8_t axes) {
    square_sums_t sums = {0.0, 0.0};
    for (int x = 0; x < axes; x++) {
        const nck_axis_t *const axis = &machine->axis[x];
        if (!axis->present) continue;
        sums.aa += axis->a_max * axis->a_max;
        sums.jj += axis->j_max * axis->j_max;
    }
    return sums;
}

// Jerk along a path, at most. No ramp A/J is shorter than the filter behind it twice over:
// what it takes from low caps (v_filter) grows with the jerk, and soon costs more time than the
// ramps win.
static double jerk_along(const nck_machine_t *machine, uint8_t axes, double filter) {
    const square_sums_t sums = sums_of(machine, axes);
    const double a = nck_min(machine->path.a_max, nck_sqrt(sums.aa));
    const double j = nck_min(machine->path.j_max, nck_sqrt(sums.jj));
    return nck_min(j, a / (FILTERS_LEAST * filter));
}

// How long it takes to stop: the slowest axis, or a straight path [s].
static double stop_of(const nck_machine_t *machine, uint8_t axes) {
    const double a = machine->path.a_max;
    const double j = machine->path.j_max;
    double vv = 0.0;
    double stop = 0.0;
    for (int x = 0; x < axes; x++) {
        const nck_axis_t *const axis = &machine->axis[x];
        if (!axis->present) continue;
        vv += axis->v_max * axis->v_max;
        const double reached = nck_min(axis->a_max, nck_sqrt(axis->v_max * axis->j_max));
        stop = nck_max(stop, axis->v_max / reached + reached / axis->j_max);
    }
    const double v = nck_sqrt(vv);
    return nck_max(stop, v / a + nck_min(a, nck_sqrt(v * j)) / j);
}

// How long an interval of a clocked path lasts by its clock, and for what P that is short enough.
static void set_knot(const nck_machine_t *machine, uint8_t axes, nck_terms_t *terms_out) {
    const double stop = stop_of(machine, axes);
    double a = 0.0;
    double j = 0.0;
    for (int x = 0; x < axes; x++) {
        if (!machine->axis[x].present) continue;
        a = nck_max(a, machine->axis[x].a_max);
        j = nck_max(j, machine->axis[x].j_max);
    }
    const double by_jerk = nck_root_cube(NCK_KNOT_TOLERANCE / j);
    const double wanted = NCK_KNOT_SHARE * nck_max(by_jerk, nck_sqrt(NCK_KNOT_TOLERANCE / a));
    const double stops = NCK_SINGLE ? NCK_KNOT_STOPS_SINGLE : NCK_KNOT_STOPS;
    const double spread = stops * stop / NCK_CLOCKED_WINDOW;
    const double knot = nck_max(wanted, nck_min(spread, NCK_KNOT_RAISE * wanted));
    const double share = knot / NCK_KNOT_SHARE_MOST;
    terms_out->knot_s = knot;
    terms_out->knots_most = nck_max(1.0, stop / (NCK_KNOT_PARTS * knot));
    terms_out->knot_p = nck_min(j * share, a) * share * share;
}

// 1 if the path's own limits hold where no axis' limit does.
static int path_binds(const nck_machine_t *machine, uint8_t axes) {
    const double near = 1.0 - 1e-9; // a root of the sum of squares is rounded
    const square_sums_t sums = sums_of(machine, axes);
    const double a = machine->path.a_max;
    const double j = machine->path.j_max;
    return a * a < near * sums.aa || j * j < near * sums.jj;
}

// Only slopes that limit jerk have a filter, and wait at a rest until it has run out.
void nck_slope_terms(const nck_machine_t *machine, nck_terms_t *terms_out) {
    const double period = machine->period_s;
    const double filter = (double)NCK_FILTER_TAPS * period;
    const uint8_t axes = axes_of(machine);
    const nck_terms_t linear = {machine, 0, 0, 1, axes, machine->path.j_max, 0.0, 0.0, 0.0, 0.0,
                                0.0};
    *terms_out = linear;
    if (!NCK_HAS_JERK || machine->slope == NCK_SLOPE_LINEAR) return;
    terms_out->limits_jerk = 1;
    terms_out->taps = NCK_FILTER_TAPS;
    terms_out->j_max = jerk_along(machine, axes, filter);
    terms_out->mix_s = 0.5 * filter;
    const double cell = nck_max(period, nck_jerk_cell_s(machine));
    terms_out->v_filter =
        nck_ladder_raise(terms_out->j_max, filter, NCK_LADDER_STRETCH * cell);
    if (machine->slope == NCK_SLOPE_OPTIMAL) {
        terms_out->limits_path = (uint8_t)path_binds(machine, axes);
        set_knot(machine, axes, terms_out);
    }
}
