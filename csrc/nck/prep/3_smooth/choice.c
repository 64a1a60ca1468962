// SPDX-License-Identifier: MIT
// Inside room 3: is a corner faster as a bend of the spline, as a blend of its own, or as a stop?
//
// Within the tolerance a spline takes a sharp corner at a speed that falls with the tolerance, and
// the path slows down to it and speeds up again. A blend is passed at one speed, as wide as the
// lines allow: slowing down is part of its shape. A stop spends no time in a bend, but some periods
// at rest. Each is judged by its time over half of either block, the next corners being alike.
#include "nck/prep/3_smooth/choice.h"

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
enum { HALVINGS = 30 };

// What a corner is like. Speeds in path mm/s.
typedef struct corner {
    double turn;            // |out − in|
    double tolerance;       // [path mm]
    double half[2];         // how much of either block is this corner's [path mm]
    double v_max;           // of both blocks
    double a, j;            // tangential, of the slower block
    double bend_a, bend_j;  // of v²·(shape) and v³·(shape) of a blend: see limits_of
    double plain_a, plain_j; // the same of the spline
    double mix_s;           // that the slope's filter adds to a low point [s]
} corner_t;

// Largest number whose product with every axis' part keeps to that axis' limit.
static double least_of(double so_far, double limit, double part) {
    const double size = nck_fabs(part);
    return size > 0.0 ? nck_min(so_far, limit / size) : so_far;
}

// What the axes allow along the blocks, and of the spline's |p″| and |p‴| in units of 1/d, 1/d².
static void limits_of(const nck_machine_t *machine, const nck_choice_t *choice, corner_t *corner) {
    corner->a = machine->path.a_max;
    corner->j = machine->path.j_max;
    corner->plain_a = corner->plain_j = UNLIMITED;
    for (int x = 0; x < NCK_AXIS_MAX; x++) {
        const double a = machine->axis[x].a_max;
        const double j = machine->axis[x].j_max;
        const double in = choice->in[x];
        const double out = choice->out[x];
        corner->a = least_of(least_of(corner->a, a, in), a, out);
        corner->j = least_of(least_of(corner->j, j, in), j, out);
        corner->plain_a = least_of(corner->plain_a, ACCEL_SHARE * a, out - in);
        corner->plain_j = least_of(corner->plain_j, JERK_SHARE * j, out - in);
    }
    if (machine->slope == NCK_SLOPE_LINEAR) corner->j = corner->plain_j = UNLIMITED;
}

// The same of a blend: d²p″ = hat(D − s)·u2 − hat(s)·u1 is largest where one of the hats is, and
// d²p‴ is a sum of ±u1 and ±u2, their difference only where they overlap by more than d.
// apart = D/d.
static void bend_limits(const nck_machine_t *machine, const nck_choice_t *choice, double apart,
                        corner_t *corner) {
    const double overlap = nck_max(0.0, 1.0 - apart);
    corner->bend_a = corner->bend_j = UNLIMITED;
    for (int x = 0; x < NCK_AXIS_MAX; x++) {
        const double a = ACCEL_SHARE * machine->axis[x].a_max;
        const double j = JERK_SHARE * machine->axis[x].j_max;
        const double in = choice->in[x];
        const double out = choice->out[x];
        corner->bend_a = least_of(corner->bend_a, a, in - overlap * out);
        corner->bend_a = least_of(corner->bend_a, a, out - overlap * in);
        corner->bend_j = least_of(least_of(corner->bend_j, j, in), j, out);
        corner->bend_j = least_of(corner->bend_j, j, in + out);
        if (overlap > 0.0) corner->bend_j = least_of(corner->bend_j, j, in - out);
    }
}

// Time of an S-shaped ramp over a difference of speeds.
static double ramp_time(const corner_t *corner, double dv) {
    const double a = corner->a;
    const double j = corner->j;
    return dv * j <= a * a ? 2.0 * nck_sqrt(dv / j) : dv / a + a / j;
}

// Least time over a length from v on.
static double ramp_over(const corner_t *corner, double v, double length) {
    double low = v;
    double high = corner->v_max;
    for (int n = 0; n < HALVINGS; n++) {
        const double middle = 0.5 * (low + high);
        if (0.5 * (v + middle) * ramp_time(corner, middle - v) <= length) low = middle;
        else high = middle;
    }
    const double t = ramp_time(corner, low - v);
    const double left = length - 0.5 * (v + low) * t;
    return left > 0.0 ? t + left / low : t;
}

// Time of a corner that is passed at v over d of either block, and of what is left of them.
static double time_at(const corner_t *corner, double v, double d, double bend) {
    return bend / v + ramp_over(corner, v, corner->half[0] - d)
           + ramp_over(corner, v, corner->half[1] - d);
}

static double bend_speed(double v_max, double a, double j, double d) {
    return nck_min(v_max, nck_min(nck_root_cube(j * d * d), nck_sqrt(a * d)));
}

// The corner as the spline makes it; 0 if it is so blunt that only its neighbours bound the spline.
static double plain_time(const corner_t *corner) {
    const double d = nck_spline_vertex_spacing(corner->tolerance, corner->turn);
    if (!(d < nck_min(corner->half[0], corner->half[1]))) return 0.0;
    const double v = bend_speed(corner->v_max, corner->plain_a, corner->plain_j, d);
    return v > 0.0 ? time_at(corner, v, d, 2.0 * d) + corner->mix_s : 0.0;
}

static double blend_time(const nck_machine_t *machine, const nck_choice_t *choice,
                         corner_t *corner, double d, double parking) {
    bend_limits(machine, choice, parking / d, corner);
    const double v = bend_speed(corner->v_max, corner->bend_a, corner->bend_j, d);
    return time_at(corner, v, d, 2.0 * d + parking);
}

static double stop_time(const corner_t *corner, const nck_machine_t *machine) {
    return ramp_over(corner, 0.0, corner->half[0]) + ramp_over(corner, 0.0, corner->half[1])
           + REST_PERIODS * machine->period_s + corner->mix_s;
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
                    nck_choice_t *choice, corner_t *corner) {
    nck_path_tangent(&a->seg, a->seg.length, choice->in);
    nck_path_tangent(&b->seg, 0.0, choice->out);
    corner->turn = unit_distance(choice->in, choice->out, -1.0);
    corner->tolerance = TOLERANCE_SHARE * nck_min(a->tolerance, b->tolerance);
    corner->half[0] = nck_min(a->seg.length, HALF * (a->seg.length + a->cut));
    corner->half[1] = HALF * b->seg.length;
    corner->v_max =
        nck_min(speed_of(self, &a->seg, choice->in), speed_of(self, &b->seg, choice->out));
    corner->mix_s = 0.0;
    if (self->machine->slope == NCK_SLOPE_JERK) {
        corner->mix_s = (double)NCK_FILTER_TAPS * self->machine->period_s;
    }
    limits_of(self->machine, choice, corner);
    bend_limits(self->machine, choice, 1.0, corner);
}

// The half-width of a blend as full speed needs it, and its parking. 0: none.
static double width_of(const corner_t *corner, double room, double *parking) {
    const double v = corner->v_max;
    const double enough = nck_max(v * v / corner->bend_a, nck_sqrt(v * v * v / corner->bend_j));
    const double half = nck_min(room, nck_min(corner->half[0], corner->half[1]));
    const double d = nck_min(half, enough);
    if (!(d > 0.0)) return 0.0;
    *parking = nck_blend_parking(d, corner->tolerance, corner->turn);
    return *parking > LEAST ? d : 0.0;
}

void nck_choice_make(const nck_smooth_t *self, const nck_raw_t *a, const nck_raw_t *b, double room,
                     nck_choice_t *choice) {
    corner_t corner;
    choice->kind = NCK_CHOICE_SPLINE;
    measure(self, a, b, choice, &corner);
    if (!(corner.turn > 0.0)) return;
    double least = plain_time(&corner);
    if (!(least > 0.0)) return;
    const int is_reversal = unit_distance(choice->in, choice->out, 1.0) <= REVERSAL;
    const double d = is_reversal ? 0.0 : width_of(&corner, room, &choice->parking);
    const double blend =
        d > 0.0 ? blend_time(self->machine, choice, &corner, d, choice->parking) : UNLIMITED;
    if (blend < least) {
        choice->kind = NCK_CHOICE_BLEND;
        choice->d = d;
        least = blend;
    }
    if (stop_time(&corner, self->machine) < least) choice->kind = NCK_CHOICE_STOP;
}
