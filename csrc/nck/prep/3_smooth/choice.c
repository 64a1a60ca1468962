// SPDX-License-Identifier: MIT
// Inside room 3: is a corner faster as a bend of the spline, as a blend of its own, or as a stop?
//
// Within the tolerance a spline takes a sharp corner at a speed that falls with the tolerance, and
// the path slows down to it and speeds up again. A blend is passed at one speed, as wide as the
// lines allow: slowing down is part of its shape. A stop spends no time in a bend, but some periods
// at rest. Each is judged by its time over half of either block, the next corners being alike.
#include "nck/prep/3_smooth/choice.h"

#include <string.h> // memcpy

#include "nck/base/path_math.h"            // nck_path_tangent
#include "nck/base/real.h"                 // nck_min nck_max
#include "nck/base/root_math.h"            // nck_root_cube
#include "nck/prep/3_smooth/blend_math.h"  // nck_blend_parking
#include "nck/prep/3_smooth/spline_math.h" // nck_spline_…

#define HALF 0.495           // of a block, for the corner at one of its ends
#define TOLERANCE_SHARE 0.98 // of P: rounding of setpoints is the rest
#define JERK_SHARE 0.85      // of what room 4 lets the bend use of an axis' jerk
#define ACCEL_SHARE 0.95     // the same of its acceleration
#define LEAST 1e-9           // [path mm]: a parking shorter than that is none
#define REVERSAL 1e-6        // |in + out| up to which a corner is an exact reversal
#define REST_PERIODS 3.0     // that a stop costs besides its ramps and the filter
#define UNLIMITED 1e30       // jerk of the linear slope
#define OWN 0.7              // of the spline's turn that a corner has to make for a stop to help
enum { HALVINGS = 30 };

// What a corner is like. Speeds in path mm/s.
typedef struct corner {
    double in[NCK_AXIS_MAX];  // dp/ds of both blocks where they meet
    double out[NCK_AXIS_MAX];
    double turn;              // |out − in| of the unit tangents
    double tolerance;         // [path mm]
    double half[2];           // how much of either block is this corner's [path mm]
    double v_max;             // of both blocks
    double a, j;              // tangential, of the slower block
    double mix_s;             // that the slope's filter adds to a low point [s]
} corner_t;

// What axes allow of a shape's |p″|·d·v² and |p‴|·d²·v³, by how long each of its axes' parts is.
typedef struct shape_limit {
    double a, j;
} shape_limit_t;

// Largest number whose product with every axis' part keeps to that axis' limit.
static double least_of(double so_far, double limit, double part) {
    const double size = nck_fabs(part);
    return size > 0.0 ? nck_min(so_far, limit / size) : so_far;
}

// What the axes allow along the blocks.
static void limit_along(const nck_machine_t *machine, corner_t *corner) {
    const int limits_jerk = machine->slope != NCK_SLOPE_LINEAR;
    corner->a = machine->path.a_max;
    corner->j = limits_jerk ? machine->path.j_max : UNLIMITED;
    for (int x = 0; x < NCK_AXIS_MAX; x++) {
        const double a = machine->axis[x].a_max;
        const double j = limits_jerk ? machine->axis[x].j_max : UNLIMITED;
        corner->a = least_of(least_of(corner->a, a, corner->in[x]), a, corner->out[x]);
        corner->j = least_of(least_of(corner->j, j, corner->in[x]), j, corner->out[x]);
    }
}

// The spline's p″ is the turn over d, its p‴ the turn over d².
static shape_limit_t limit_plain(const nck_machine_t *machine, const double *turn) {
    const int limits_jerk = machine->slope != NCK_SLOPE_LINEAR;
    shape_limit_t limit = {UNLIMITED, UNLIMITED};
    for (int x = 0; x < NCK_AXIS_MAX; x++) {
        limit.a = least_of(limit.a, ACCEL_SHARE * machine->axis[x].a_max, turn[x]);
        if (!limits_jerk) continue;
        limit.j = least_of(limit.j, JERK_SHARE * machine->axis[x].j_max, turn[x]);
    }
    return limit;
}

// A blend's d·p″ = hat(D − s)·u2 − hat(s)·u1 is largest where one of the hats is; d²p‴ is a sum of
// ±u1 and ±u2, their difference only where they overlap by more than d. apart = D/d.
static shape_limit_t limit_blend(const nck_machine_t *machine, const corner_t *corner,
                                 double apart) {
    const double overlap = nck_max(0.0, 1.0 - apart);
    shape_limit_t limit = {UNLIMITED, UNLIMITED};
    for (int x = 0; x < NCK_AXIS_MAX; x++) {
        const double a = ACCEL_SHARE * machine->axis[x].a_max;
        const double j = JERK_SHARE * machine->axis[x].j_max;
        const double in = corner->in[x];
        const double out = corner->out[x];
        limit.a = least_of(least_of(limit.a, a, in - overlap * out), a, out - overlap * in);
        limit.j = least_of(least_of(least_of(limit.j, j, in), j, out), j, in + out);
        if (overlap > 0.0) limit.j = least_of(limit.j, j, in - out);
    }
    return limit;
}

// Time of an S-shaped ramp over a difference of speeds.
static double ramp_time(const corner_t *corner, double dv) {
    const double a = corner->a;
    const double j = corner->j;
    return dv * j <= a * a ? 2.0 * nck_sqrt(dv / j) : dv / a + a / j;
}

// Least time over a length from v on, and the speed at its end.
static double ramp_over(const corner_t *corner, double v, double length, double *v_end) {
    double low = v;
    double high = corner->v_max;
    for (int n = 0; n < HALVINGS; n++) {
        const double middle = 0.5 * (low + high);
        if (0.5 * (v + middle) * ramp_time(corner, middle - v) <= length) low = middle;
        else high = middle;
    }
    const double t = ramp_time(corner, low - v);
    const double left = length - 0.5 * (v + low) * t;
    *v_end = low;
    return left > 0.0 ? t + left / low : t;
}

// Time of a corner that is passed at v over d of either block, and of what is left of them.
static double time_at(const corner_t *corner, double v, double d, double bend) {
    double time = bend / v;
    double v_end = v;
    for (int n = 0; n < 2; n++) {
        const double left = corner->half[n] - d;
        if (left > 0.0) time += ramp_over(corner, v, left, &v_end);
    }
    return time;
}

// Time of a stop, over d of either block at least: where a block is shorter the path goes on as
// fast as it has become.
static double stop_time(const corner_t *corner, double d, const nck_machine_t *machine) {
    double time = REST_PERIODS * machine->period_s + corner->mix_s;
    for (int n = 0; n < 2; n++) {
        double v_end = 0.0;
        time += ramp_over(corner, 0.0, corner->half[n], &v_end);
        if (corner->half[n] < d) time += (d - corner->half[n]) / v_end;
    }
    return time;
}

static double bend_speed(const corner_t *corner, const shape_limit_t *limit, double d) {
    const double v = nck_min(nck_root_cube(limit->j * d * d), nck_sqrt(limit->a * d));
    return nck_min(corner->v_max, v);
}

// Room 4 keeps the limits of a bend for half a filter on either side, over what may be gained in
// that time: a bend shorter than that costs as much.
static double plain_time(const corner_t *corner, const nck_bend_t *bend,
                         const nck_machine_t *machine) {
    const shape_limit_t limit = limit_plain(machine, bend->turn);
    const double v = bend_speed(corner, &limit, bend->d);
    const double d = bend->d + 0.125 * corner->a * corner->mix_s * corner->mix_s;
    return time_at(corner, v, d, 2.0 * d) + corner->mix_s;
}

static double blend_time(const corner_t *corner, const nck_blend_t *blend,
                         const nck_machine_t *machine) {
    const shape_limit_t limit = limit_blend(machine, corner, blend->parking / blend->d);
    const double v = bend_speed(corner, &limit, blend->d);
    return time_at(corner, v, blend->d, 2.0 * blend->d + blend->parking);
}

static double speed_of(const nck_smooth_t *self, const nck_seg_t *seg, const double *tangent) {
    double v = nck_min(self->machine->path.feed_max, seg->rapid ? 1e9 : seg->feed);
    for (int x = 0; x < NCK_AXIS_MAX; x++) {
        const nck_axis_t *const axis = &self->machine->axis[x];
        v = least_of(v, seg->rapid ? axis->rapid : axis->v_max, tangent[x]);
    }
    return v;
}

// Length of the sum (sign 1) or the difference (sign −1) of two tangents as unit vectors: a merged
// line's path coordinate may be longer than the line.
static double unit_distance(const double *in, const double *out, double sign) {
    const double size_in = nck_spline_norm(in);
    const double size_out = nck_spline_norm(out);
    double sum[NCK_AXIS_MAX];
    if (!(size_in > 0.0) || !(size_out > 0.0)) return 0.0;
    for (int x = 0; x < NCK_AXIS_MAX; x++) sum[x] = out[x] / size_out + sign * in[x] / size_in;
    return nck_spline_norm(sum);
}

static void measure(const nck_smooth_t *self, const nck_raw_t *a, const nck_raw_t *b,
                    corner_t *corner) {
    const nck_machine_t *const machine = self->machine;
    nck_path_tangent(&a->seg, a->seg.length, corner->in);
    nck_path_tangent(&b->seg, 0.0, corner->out);
    corner->turn = unit_distance(corner->in, corner->out, -1.0);
    corner->tolerance = TOLERANCE_SHARE * nck_min(a->tolerance, b->tolerance);
    corner->half[0] = nck_min(a->seg.length, HALF * (a->seg.length + a->cut));
    corner->half[1] = HALF * b->seg.length;
    corner->v_max =
        nck_min(speed_of(self, &a->seg, corner->in), speed_of(self, &b->seg, corner->out));
    corner->mix_s = machine->slope == NCK_SLOPE_LINEAR ? 0.0 : NCK_FILTER_TAPS * machine->period_s;
    limit_along(machine, corner);
}

// The half-width of a blend as full speed needs it, and its parking. 0: none.
static double width_of(const corner_t *corner, double room, const nck_machine_t *machine,
                       double *parking) {
    const double v = corner->v_max;
    const shape_limit_t limit = limit_blend(machine, corner, 1.0);
    const double enough = nck_max(v * v / limit.a, nck_sqrt(v * v * v / limit.j));
    const double half = nck_min(room, nck_min(corner->half[0], corner->half[1]));
    const double d = nck_min(half, enough);
    if (!(d > 0.0)) return 0.0;
    *parking = nck_blend_parking(d, corner->tolerance, corner->turn);
    return *parking > LEAST ? d : 0.0;
}

// A lone corner's bend; 0 if it is so blunt that only its neighbours bound the spline.
static int lone_bend(const corner_t *corner, nck_bend_t *bend) {
    bend->d = nck_spline_vertex_spacing(corner->tolerance, corner->turn);
    for (int x = 0; x < NCK_AXIS_MAX; x++) bend->turn[x] = corner->out[x] - corner->in[x];
    return bend->d < nck_min(corner->half[0], corner->half[1]);
}

int nck_choice_blend(const nck_smooth_t *self, const nck_raw_t *a, const nck_raw_t *b, double room,
                     nck_blend_t *blend) {
    const nck_machine_t *const machine = self->machine;
    corner_t corner;
    nck_bend_t bend;
    measure(self, a, b, &corner);
    if (!(corner.turn > 0.0) || !lone_bend(&corner, &bend)) return 0;
    if (unit_distance(corner.in, corner.out, 1.0) <= REVERSAL) return 0;
    blend->d = width_of(&corner, room, machine, &blend->parking);
    if (!(blend->d > 0.0)) return 0;
    memcpy(blend->in, corner.in, sizeof blend->in);
    memcpy(blend->out, corner.out, sizeof blend->out);
    const double time = blend_time(&corner, blend, machine);
    return time < plain_time(&corner, &bend, machine) && time < stop_time(&corner, 0.0, machine);
}

int nck_choice_stop(const nck_smooth_t *self, const nck_raw_t *a, const nck_raw_t *b,
                    const nck_bend_t *bend) {
    corner_t corner;
    measure(self, a, b, &corner);
    if (corner.turn < OWN * nck_spline_norm(bend->turn)) return 0;
    return stop_time(&corner, bend->d, self->machine) < plain_time(&corner, bend, self->machine);
}
