// SPDX-License-Identifier: MIT
// A pass of a thread: the tool runs in, follows the spindle, and runs out; in time of a spindle
// that turns as commanded. Behind the run-in it is where it would be had it started at full speed.
#ifndef NCK_BASE_THREAD_H
#define NCK_BASE_THREAD_H

#include "nck/base/machine.h" // nck_machine_t
#include "nck/base/records.h" // nck_seg_t nck_thread_t NCK_AXIS_MAX

// Speed from rest to v: jerk j for t_jerk, none for t_even, −j for t_jerk. j = 0: a alone.
typedef struct nck_ramp {
    double v;      // [mm/s]
    double a;      // [mm/s²]
    double j;      // [mm/s³]
    double t_jerk; // [s]
    double t_even; // [s]
    double time;   // all of it [s]
    double length; // [mm]
} nck_ramp_t;

// What a pass is like. Lengths are along its leading measure.
typedef struct nck_pass {
    double way[NCK_AXIS_MAX]; // of an axis, a length of 1
    nck_ramp_t ramp;  // the run-in; the run-out is its mirror image
    double length;    // [mm]
    double cruise;    // at full speed [s]
    double enter;     // X goes in by so much [mm]
    double enter_s;   // within the first so many seconds; 0: it does not
    double leave;     // X goes out by so much [mm]
    double leave_at;  // from here on [s]
    double leave_s;   // in so many seconds; 0: it does not
    double change[2]; // of the spindle's speed over the commanded one, that X can follow while it
                      // goes in and out [1/s]
    double total;     // [s]
} nck_pass_t;

// A moment of a pass.
typedef struct nck_moment {
    double s; // [mm]
    double v; // [mm/s]
    double a; // [mm/s²]
} nck_moment_t;

// How long planning takes a seg that does not move to last [s]: a dwell, a wait; a pass of a thread
// and a tap as the spindle turns when it is as commanded, with half a turn until its angle comes.
// Cost: constant. Context: any.
static inline double nck_thread_rest_s(const nck_seg_t *seg) {
    if (seg->kind == NCK_SEG_THREAD) return (double)seg->shape.thread.duration;
    if (seg->kind == NCK_SEG_TAP) return (double)seg->shape.tap.duration;
    return seg->shape.dwell_s;
}

// How fast a pass may be, along its leading measure [mm/s]. start, end: of the seg.
// Cost: constant. Context: any.
double nck_thread_speed_most(const nck_machine_t *machine, const double *start, const double *end,
                             const nck_thread_t *thread);

// Plan a pass at a speed of the spindle. Its length may be less than both ramps need: then it
// cannot be made, and cruise is negative. Cost: constant. Context: any.
void nck_thread_plan(const nck_machine_t *machine, const double *start, const double *end,
                     const nck_thread_t *thread, double rpm, nck_pass_t *pass_out);

// How fast a tap may be, along its way [mm/s]. Cost: constant. Context: any.
double nck_tap_speed_most(const nck_machine_t *machine, const nck_tap_t *tap);

// Plan a tap at a speed of the spindle, which brakes to a stop at the bottom: *back_out, whose
// mirror image leads out again. leave_at of the pass is where it begins to brake [mm]. Of a hole
// that is too short cruise is negative. Cost: constant. Context: any.
void nck_tap_plan(const nck_machine_t *machine, const nck_tap_t *tap, double rpm,
                  nck_pass_t *pass_out, nck_ramp_t *back_out);

// A ramp from rest to v. Cost: constant. Context: any.
void nck_thread_ramp(double v, double a, double j, nck_ramp_t *ramp_out);

// Where a ramp is t after its begin, 0 ≤ t ≤ ramp->time. Cost: constant. Context: any.
void nck_thread_on_ramp(const nck_ramp_t *ramp, double t, nck_moment_t *moment_out);

// Where a pass is t after its begin, t ≥ 0. Cost: constant. Context: any.
void nck_thread_at(const nck_pass_t *pass, double t, nck_moment_t *moment_out);

// Of X: how much it is beside its place at the begin, without the way along the pass, when s and
// the time are these. Cost: constant. Context: any.
double nck_thread_beside(const nck_pass_t *pass, double t);

#endif
