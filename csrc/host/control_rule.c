// SPDX-License-Identifier: MIT
// Other controls: limits along a line, and the cap at a corner.
#include "host/control_parts.h"

#include <float.h> // DBL_MAX

#include "host/control_math.h" // nck_control_…
#include "nck/base/real.h"     // nck_fabs nck_max nck_min nck_sqrt
#include "nck/base/trig.h"     // nck_atan2

// Marlin: small segments are below this length [mm], and turn by less than 45°: cos 45°.
#define SMALL_MM 1.0
#define SMALL_COS 0.7071067812
// Marlin: no corner is passed slower [mm/s].
#define V_LEAST 0.05
// Marlin: where safe speeds at both sides reach this share of the common one, they count.
#define SAFE_SHARE 0.99
// Klipper: what limits nothing [mm/s²].
#define A_FREE 99999999.9

static double value(const nck_host_control_t *self, unsigned which) {
    return self->rule.value[which];
}

// The least of a limit by axis over a direction's share in it; *axis_out: whose it is.
static double by_axis(const nck_host_control_t *self, unsigned which, const double *unit,
                      unsigned *axis_out) {
    double least = DBL_MAX;
    for (unsigned x = 0; x < NCK_AXIS_MAX; x++) {
        const double share = nck_fabs(unit[x]);
        const double most = value(self, which + x);
        if (share * least <= most) continue;
        least = most / share;
        *axis_out = x;
    }
    return least;
}

static void limit_v(nck_host_control_line_t *line, double most, uint8_t limit) {
    if (line->v <= most) return;
    line->v = most;
    line->limit = limit;
}

static void limit_klipper(const nck_host_control_t *self, nck_host_control_line_t *line) {
    const double share = nck_fabs(line->unit[NCK_AXIS_Z]);
    const int still = line->unit[NCK_AXIS_X] == 0.0 && line->unit[NCK_AXIS_Y] == 0.0; // exactly 0
    const double e = line->unit[NCK_CONTROL_E];
    const double slow = value(self, NCK_CONTROL_CRUISE_RATIO);
    line->a = line->lone ? A_FREE : value(self, NCK_CONTROL_A_PATH);
    if (!line->lone) limit_v(line, value(self, NCK_CONTROL_V_PATH), NCK_LIMIT_FEED_MAX);
    if (share > 0.0) {
        limit_v(line, value(self, NCK_CONTROL_V + NCK_AXIS_Z) / share,
                NCK_LIMIT_AXIS_V + NCK_AXIS_Z);
        line->a = nck_min(line->a, value(self, NCK_CONTROL_A + NCK_AXIS_Z) / share);
    }
    if ((still && e != 0.0) || e < 0.0) {
        limit_v(line, value(self, NCK_CONTROL_V_EXTRUDE) / nck_fabs(e),
                NCK_LIMIT_AXIS_V + NCK_CONTROL_E);
        line->a = nck_min(line->a, value(self, NCK_CONTROL_A_EXTRUDE) / nck_fabs(e));
    }
    line->gain = 2.0 * line->a * line->length;
    line->bend = line->a * nck_control_square_corner(value(self, NCK_CONTROL_CORNER),
                                                     value(self, NCK_CONTROL_A_PATH));
    line->smooth_gain = nck_min(line->gain, 2.0 * line->length * (1.0 - slow)
                                            * value(self, NCK_CONTROL_A_PATH));
}

static void limit_marlin(const nck_host_control_t *self, nck_host_control_line_t *line) {
    unsigned axis = 0;
    const int extrudes = line->unit[NCK_CONTROL_E] != 0.0;
    const unsigned which = extrudes ? NCK_CONTROL_A_PATH : NCK_CONTROL_A_TRAVEL;
    line->a = value(self, line->lone ? NCK_CONTROL_A_RETRACT : which);
    if (!line->lone) line->a = nck_min(line->a, by_axis(self, NCK_CONTROL_A, line->unit, &axis));
    const double most = by_axis(self, NCK_CONTROL_V, line->unit, &axis);
    limit_v(line, most, (uint8_t)(NCK_LIMIT_AXIS_V + axis));
    line->gain = 2.0 * line->a * line->length;
}

static void limit_others(const nck_host_control_t *self, nck_host_control_line_t *line) {
    unsigned axis = 0;
    line->a = nck_min(by_axis(self, NCK_CONTROL_A, line->unit, &axis),
                      value(self, NCK_CONTROL_A_PATH));
    const double most = by_axis(self, NCK_CONTROL_V, line->unit, &axis);
    if (!line->rapid) limit_v(line, most, (uint8_t)(NCK_LIMIT_AXIS_V + axis));
    line->v = nck_min(line->v, most);
    limit_v(line, value(self, NCK_CONTROL_V_PATH), NCK_LIMIT_FEED_MAX);
    line->gain = 2.0 * line->a * line->length;
}

void nck_control_limit(const nck_host_control_t *self, nck_host_control_line_t *line) {
    if (self->rule.kind == NCK_HOST_CONTROL_KLIPPER) limit_klipper(self, line);
    else if (self->rule.kind == NCK_HOST_CONTROL_MARLIN) limit_marlin(self, line);
    else limit_others(self, line);
    // Of a rapid its own speed is what the program asks for.
    if (line->v_wanted == DBL_MAX) line->v_wanted = line->v;
}

// −u·w
static double cosine(const double *in, const double *out) {
    double c = 0.0;
    for (unsigned x = 0; x < NCK_AXIS_MAX; x++) c -= in[x] * out[x];
    return c;
}

static void unify(double *vector) {
    const double size = nck_sqrt(-cosine(vector, vector));
    for (unsigned x = 0; size > 0.0 && x < NCK_AXIS_MAX; x++) vector[x] /= size;
}

// The acceleration along the bisector of a corner.
static double across(const nck_host_control_t *self, const double *in, const double *out) {
    double way[NCK_AXIS_MAX];
    unsigned axis = 0;
    for (unsigned x = 0; x < NCK_AXIS_MAX; x++) way[x] = out[x] - in[x];
    unify(way);
    return by_axis(self, NCK_CONTROL_A, way, &axis);
}

// The directions X Y Z alone.
static double cosine_of_tool(const nck_host_control_line_t *in,
                             const nck_host_control_line_t *out) {
    double c = 0.0;
    for (unsigned x = 0; x <= NCK_AXIS_Z; x++) c -= in->unit[x] * out->unit[x];
    return c;
}

static double cap_klipper(const nck_host_control_t *self, const nck_host_control_line_t *in,
                          const nck_host_control_line_t *out) {
    const double change = out->unit[NCK_CONTROL_E] - in->unit[NCK_CONTROL_E];
    double cap = DBL_MAX;
    if (in->lone || out->lone) return 0.0;
    if (change != 0.0) { // exactly 0: E as before
        const double step = value(self, NCK_CONTROL_CORNER_E) / change;
        cap = step * step;
    }
    const double c = cosine_of_tool(in, out);
    if (1.0 - nck_control_half(1.0 - c) <= 0.0 || nck_control_half(1.0 + c) <= 0.0) return cap;
    cap = nck_min(cap, nck_control_deviation(c, nck_min(in->bend, out->bend), 1.0));
    return nck_min(cap, nck_control_mid_line(c, nck_min(in->gain, out->gain)));
}

static double cap_grbl(const nck_host_control_t *self, const nck_host_control_line_t *in,
                       const nck_host_control_line_t *out) {
    const double c = cosine(in->unit, out->unit);
    if (c > NCK_CONTROL_STRAIGHT) return 0.0;
    if (c < -NCK_CONTROL_STRAIGHT) return DBL_MAX;
    const double a = nck_min(across(self, in->unit, out->unit), value(self, NCK_CONTROL_A_PATH));
    return nck_control_deviation(c, a, value(self, NCK_CONTROL_DEVIATION));
}

// The extruder's share counts where it feeds.
static void direction(const nck_host_control_line_t *line, double unit[NCK_AXIS_MAX]) {
    for (unsigned x = 0; x < NCK_AXIS_MAX; x++) unit[x] = line->unit[x];
    if (unit[NCK_CONTROL_E] != 0.0) unify(unit);
}

static double cap_marlin(const nck_host_control_t *self, const nck_host_control_line_t *in,
                         const nck_host_control_line_t *out) {
    double u[NCK_AXIS_MAX];
    double w[NCK_AXIS_MAX];
    direction(in, u);
    direction(out, w);
    const double c = nck_max(cosine(u, w), -NCK_CONTROL_STRAIGHT);
    if (c > NCK_CONTROL_STRAIGHT) return V_LEAST * V_LEAST;
    const double a = nck_min(across(self, u, w), out->a);
    const double cap = nck_control_deviation(c, a, value(self, NCK_CONTROL_DEVIATION));
    if (out->length >= SMALL_MM || c >= -SMALL_COS) return cap;
    return nck_min(cap, out->length * a / nck_atan2(nck_sqrt(1.0 - c * c), -c));
}

// As fast as a line may begin from rest, or end at one: no axis steps by more than its jerk.
static double safe_speed(const nck_host_control_t *self, const nck_host_control_line_t *line) {
    unsigned axis = 0;
    return nck_min(line->v, by_axis(self, NCK_CONTROL_JERK, line->unit, &axis));
}

// By how much an axis steps: where it reverses, the larger side, not the sum.
static double step_of(double from, double to) {
    if ((from > 0.0 && to < 0.0) || (from < 0.0 && to > 0.0)) {
        return nck_max(nck_fabs(from), nck_fabs(to));
    }
    return nck_fabs(to - from);
}

static double cap_classic(const nck_host_control_t *self, const nck_host_control_line_t *in,
                          const nck_host_control_line_t *out) {
    const double v = nck_min(in->v, out->v);
    double factor = 1.0;
    for (unsigned x = 0; x < NCK_AXIS_MAX; x++) {
        const double step = factor * step_of(in->unit[x] * v, out->unit[x] * out->v);
        const double most = value(self, NCK_CONTROL_JERK + x);
        if (step > most) factor *= most / step;
    }
    const double common = v * factor;
    const double safe = safe_speed(self, out);
    const int both = safe_speed(self, in) > SAFE_SHARE * common && safe > SAFE_SHARE * common;
    return both ? safe * safe : common * common;
}

static double cap_of(const nck_host_control_t *self, const nck_host_control_line_t *in,
                     const nck_host_control_line_t *out) {
    if (self->rule.kind == NCK_HOST_CONTROL_KLIPPER) return cap_klipper(self, in, out);
    if (self->rule.kind == NCK_HOST_CONTROL_GRBL) return cap_grbl(self, in, out);
    if (self->rule.kind == NCK_HOST_CONTROL_LINUXCNC) return 0.0;
    return self->rule.classic ? cap_classic(self, in, out) : cap_marlin(self, in, out);
}

// From a rest on: only classic jerk begins with a speed.
static double cap_of_rest(const nck_host_control_t *self, const nck_host_control_line_t *out) {
    if (self->rule.kind != NCK_HOST_CONTROL_MARLIN || !self->rule.classic) return 0.0;
    const double safe = safe_speed(self, out);
    return safe * safe;
}

void nck_control_corner(const nck_host_control_t *self, nck_host_control_line_t *line) {
    const nck_host_control_line_t *const last = &self->last;
    line->limit_cap = NCK_LIMIT_CORNER;
    line->smooth_cap = 0.0;
    line->reach = 0.0;
    line->cap = cap_of_rest(self, line);
    if (!self->has_last) return;
    const double c = -cosine_of_tool(last, line);
    const double corner = cap_of(self, last, line);
    const double least = nck_min(line->v, last->v);
    line->angle = nck_atan2(nck_sqrt(nck_max(0.0, 1.0 - c * c)), c);
    line->cap = nck_min(corner, least * least);
    if (line->cap < corner) line->limit_cap = line->v < last->v ? line->limit : last->limit;
    if (line->lone != last->lone) line->limit_cap = NCK_LIMIT_EXACT_STOP;
    line->reach = nck_min(line->cap, last->reach + last->gain);
    line->smooth_cap = nck_min(line->reach, last->smooth_cap + last->smooth_gain);
}
