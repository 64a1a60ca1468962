// SPDX-License-Identifier: MIT
// Passes of threads: their ramps, and X that goes in and out beside them.
#include "nck/base/thread.h"

#include <string.h> // memset

#include "nck/base/real.h"      // nck_sqrt nck_min nck_max nck_fabs
#include "nck/base/root_math.h" // nck_root_cube

// The axes follow a spindle that turns up to 5 % faster than commanded within their limits.
#define FASTER 1.05
// Where the way along the pass and X's own motion meet in X, each has half.
#define HALF 0.5
// Of X's acceleration in motions of its own: the rest is for a spindle that turns unevenly.
#define EVEN 0.8
#define UNLIMITED 1e30

// The way of a pass a length of 1, X's own motions left out.
static void find_way(const double *start, const double *end, const nck_thread_t *thread,
                     double *way) {
    for (int x = 0; x < NCK_AXIS_MAX; x++) {
        double d = end[x] - start[x];
        if (x == NCK_AXIS_X) d -= thread->enter + thread->leave;
        way[x] = d / thread->length;
    }
}

static double norm(const double *way) {
    double sum = 0.0;
    for (int x = 0; x < NCK_AXIS_MAX; x++) sum += way[x] * way[x];
    return nck_sqrt(sum);
}

static double norm3(const double *way) {
    return nck_sqrt(way[0] * way[0] + way[1] * way[1] + way[2] * way[2]);
}

double nck_thread_speed_most(const nck_machine_t *machine, const double *start, const double *end,
                             const nck_thread_t *thread) {
    double way[NCK_AXIS_MAX];
    double most = UNLIMITED;
    find_way(start, end, thread, way);
    for (int x = 0; x < NCK_AXIS_MAX; x++) {
        if (way[x] != 0.0) most = nck_min(most, machine->axis[x].v_max / nck_fabs(way[x]));
    }
    return most / FASTER;
}

void nck_thread_ramp(double v, double a, double j, nck_ramp_t *ramp_out) {
    nck_ramp_t *const ramp = ramp_out;
    memset(ramp, 0, sizeof *ramp);
    ramp->v = v;
    ramp->a = a;
    ramp->j = j;
    if (j > 0.0) ramp->t_jerk = v * j <= a * a ? nck_sqrt(v / j) : a / j;
    ramp->t_even = nck_max(0.0, v / a - ramp->t_jerk);
    ramp->time = 2.0 * ramp->t_jerk + ramp->t_even;
    ramp->length = 0.5 * v * ramp->time;
}

// s = jt³/6, then with a constant a, then the mirror image of the first part.
void nck_thread_on_ramp(const nck_ramp_t *ramp, double t, nck_moment_t *moment_out) {
    const double j = ramp->j;
    const double t1 = ramp->t_jerk;
    const double rest = ramp->time - t;
    nck_moment_t *const at = moment_out;
    if (t < t1) {
        *at = (nck_moment_t){j * t * t * t / 6.0, j * t * t / 2.0, j * t};
    } else if (rest < t1) {
        *at = (nck_moment_t){ramp->length - ramp->v * rest + j * rest * rest * rest / 6.0,
                             ramp->v - j * rest * rest / 2.0, j * rest};
    } else {
        const double a = j > 0.0 ? j * t1 : ramp->a;
        const double x = t - t1;
        const double v1 = 0.5 * j * t1 * t1;
        *at = (nck_moment_t){j * t1 * t1 * t1 / 6.0 + (v1 + 0.5 * a * x) * x, v1 + a * x, a};
    }
}

// From rest to rest over a distance, the jerk j, −j, −j, j for a quarter of the time each:
//   d = j·T³/32    most speed 2d/T    most acceleration 8d/T²
static double swing_time(const nck_machine_t *machine, double d, double share) {
    const nck_axis_t *const axis = &machine->axis[NCK_AXIS_X];
    const double f = FASTER;
    if (d == 0.0) return 0.0;
    double t = nck_max(2.0 * d * f / (share * axis->v_max),
                       nck_sqrt(8.0 * d * f * f / (EVEN * share * axis->a_max)));
    if (machine->slope == NCK_SLOPE_LINEAR) return t;
    return nck_max(t, nck_root_cube(32.0 * d * f * f * f / (share * axis->j_max)));
}

// The share of that way after the share x of the time.
static double swing(double x) {
    if (x <= 0.0) return 0.0;
    if (x >= 1.0) return 1.0;
    if (x < 0.25) return 16.0 / 3.0 * x * x * x;
    if (x > 0.75) return 1.0 - 16.0 / 3.0 * (1.0 - x) * (1.0 - x) * (1.0 - x);
    const double y = x - 0.25;
    return 1.0 / 12.0 + (1.0 + (4.0 - 16.0 / 3.0 * y) * y) * y;
}

// What change of pace is left of X's share while it goes so far in so long: it is no faster than
// 2d/T, and takes no more acceleration than 8d/T².
static double change_left(const nck_machine_t *machine, double d, double t, double share) {
    if (t == 0.0) return UNLIMITED;
    const double a = 8.0 * nck_fabs(d) / (t * t) * FASTER * FASTER;
    const double left = share * machine->axis[NCK_AXIS_X].a_max - a;
    return nck_max(0.0, left) * t / (2.0 * nck_fabs(d));
}

// When the pass is so far along, at full speed.
static double time_at(const nck_pass_t *pass, double s) {
    return pass->ramp.time + (s - pass->ramp.length) / pass->ramp.v;
}

// X goes in from the begin on, and is in after `entry` or as soon as it can be. It goes out from
// `exit` before the end on, but when the run-out begins at the latest.
static void plan_beside(const nck_machine_t *machine, const nck_thread_t *thread, double share,
                        nck_pass_t *pass) {
    const double run_out = pass->ramp.time + pass->cruise;
    pass->enter = thread->enter;
    pass->leave = thread->leave;
    pass->enter_s = swing_time(machine, nck_fabs(thread->enter), share);
    pass->leave_s = swing_time(machine, nck_fabs(thread->leave), share);
    if (pass->enter_s > 0.0 && (double)thread->entry > pass->ramp.length) {
        pass->enter_s = nck_max(pass->enter_s, time_at(pass, (double)thread->entry));
    }
    pass->leave_at = nck_max(pass->ramp.time, time_at(pass, pass->length - (double)thread->exit));
    pass->leave_at = nck_min(run_out, pass->leave_at);
    if (pass->leave_s > 0.0) {
        pass->leave_s = nck_max(pass->leave_s, (double)thread->exit / pass->ramp.v);
    }
    pass->change[0] = change_left(machine, pass->enter, pass->enter_s, share);
    pass->change[1] = change_left(machine, pass->leave, pass->leave_s, share);
    pass->total = run_out + pass->ramp.time;
    pass->total = nck_max(pass->total, pass->enter_s);
    if (pass->leave_s > 0.0) pass->total = nck_max(pass->total, pass->leave_at + pass->leave_s);
}

// The run-in along the way of the pass. share: of what X can do.
static void plan_ramp(const nck_machine_t *machine, double share, double v, nck_pass_t *pass) {
    const double along = norm(pass->way);
    double a = machine->path.a_max / along;
    double j = machine->path.j_max / along;
    for (int x = 0; x < NCK_AXIS_MAX; x++) {
        const double c = nck_fabs(pass->way[x]);
        const double part = x == NCK_AXIS_X ? share : 1.0;
        if (c == 0.0) continue;
        a = nck_min(a, part * machine->axis[x].a_max / c);
        j = nck_min(j, part * machine->axis[x].j_max / c);
    }
    if (machine->slope == NCK_SLOPE_LINEAR) j = 0.0;
    nck_thread_ramp(v, a / (FASTER * FASTER), j / (FASTER * FASTER * FASTER), &pass->ramp);
}

double nck_tap_speed_most(const nck_machine_t *machine, const nck_tap_t *tap) {
    const double length = norm3(tap->way);
    double most = UNLIMITED;
    for (int x = 0; x < 3; x++) {
        const double c = nck_fabs(tap->way[x]) / length;
        if (c != 0.0) most = nck_min(most, machine->axis[x].v_max / c);
    }
    return most / FASTER;
}

void nck_tap_plan(const nck_machine_t *machine, const nck_tap_t *tap, double rpm,
                  nck_pass_t *pass_out, nck_ramp_t *back_out) {
    nck_pass_t *const pass = pass_out;
    const double v = tap->lead * rpm / 60.0;
    const double drive = machine->spindle.a_max_rpm_s * tap->lead / 60.0;
    memset(pass, 0, sizeof *pass);
    pass->length = norm3(tap->way);
    for (int x = 0; x < 3; x++) pass->way[x] = tap->way[x] / pass->length;
    plan_ramp(machine, 1.0, v, pass);
    const double a = drive > 0.0 ? nck_min(drive, pass->ramp.a) : pass->ramp.a;
    nck_thread_ramp(v, a, pass->ramp.j, back_out);
    pass->leave_at = pass->length - back_out->length;
    pass->cruise = (pass->leave_at - pass->ramp.length) / v;
    pass->total = 2.0 * (pass->ramp.time + pass->cruise + back_out->time) + (double)tap->dwell;
}

void nck_thread_plan(const nck_machine_t *machine, const double *start, const double *end,
                     const nck_thread_t *thread, double rpm, nck_pass_t *pass_out) {
    nck_pass_t *const pass = pass_out;
    const double v = thread->lead * rpm / 60.0;
    memset(pass, 0, sizeof *pass);
    find_way(start, end, thread, pass->way);
    const int swings = thread->enter != 0.0 || thread->leave != 0.0;
    const int meets = swings && pass->way[NCK_AXIS_X] != 0.0;
    plan_ramp(machine, meets ? HALF : 1.0, v, pass);
    pass->length = thread->length;
    pass->cruise = (thread->length - 2.0 * pass->ramp.length) / v;
    plan_beside(machine, thread, meets ? HALF : 1.0, pass);
}

void nck_thread_at(const nck_pass_t *pass, double t, nck_moment_t *moment_out) {
    const nck_ramp_t *const ramp = &pass->ramp;
    const double out = t - (ramp->time + pass->cruise);
    if (t < ramp->time) {
        nck_thread_on_ramp(ramp, t, moment_out);
    } else if (out < 0.0) {
        *moment_out = (nck_moment_t){ramp->length + ramp->v * (t - ramp->time), ramp->v, 0.0};
    } else {
        nck_thread_on_ramp(ramp, nck_max(0.0, ramp->time - out), moment_out);
        moment_out->s = pass->length - moment_out->s;
        moment_out->a = -moment_out->a;
    }
}

double nck_thread_beside(const nck_pass_t *pass, double t) {
    double beside = 0.0;
    if (pass->enter_s > 0.0) beside += pass->enter * swing(t / pass->enter_s);
    if (pass->leave_s > 0.0) beside += pass->leave * swing((t - pass->leave_at) / pass->leave_s);
    return beside;
}
