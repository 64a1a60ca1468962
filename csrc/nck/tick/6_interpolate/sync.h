// SPDX-License-Identifier: MIT
// Inside room 6: passes of threads, whose time is the spindle's angle.
#ifndef NCK_TICK_SYNC_H
#define NCK_TICK_SYNC_H

#include "nck/base/machine.h" // nck_machine_t
#include "nck/base/records.h" // nck_seg_t nck_pose_t
#include "nck/base/thread.h"  // nck_pass_t

// How far a pass is.
typedef enum nck_sync_state {
    NCK_SYNC_NOT = 0,   // none in work
    NCK_SYNC_WAITS = 1, // for the angle at which it begins
    NCK_SYNC_RUNS = 2,  // with the spindle
    NCK_SYNC_STOPS = 3, // by itself: the thread is lost
    NCK_SYNC_ENDS = 4   // at its end, or where a stop has ended
} nck_sync_state_t;

// The spindle and the pass in work.
typedef struct nck_sync {
    double turns;      // of the spindle, as told or as commanded [revolutions]
    uint32_t measured; // 1: they are told
    uint32_t untold;   // ticks that turns do not hold yet, all of them at rpm
    double rpm;        // commanded [1/min]
    uint32_t asked;    // 1: to stop; any writes it
    uint32_t held;     // 1: no pass begins; any writes it
    uint32_t lost;     // 1: a pass was stopped before its end; any reads it
    uint32_t state;    // nck_sync_state_t
    double seen;       // turns at the tick before [revolutions]
    double spin;       // speed of the spindle over the commanded one, of the last period
    double slow;       // by how much it has been too slow [s]
    double begin;      // angle at which the pass begins [revolutions]
    double t;          // of the pass: the spindle's turns since then at the commanded speed [s]
    double rate;       // by which t has grown in the last period, a second
    double was;        // acceleration of the pass where that began, at the rate 1 [mm/s²]
    nck_pass_t pass;

    // Braking by itself: the pass time runs on at its last rate for X, the way has its own ramp.
    // Of a tap: the spindle's ramp to rest and back, from s on; rate: 0 not yet, else which way.
    struct {
        double rate;   // pass time a second
        double fade;   // within which it goes to 0, of a spindle that hardly turns; 0: it stays [s]
        double size;   // of a tap: of its mean rate, on average, which passes 0 as it turns round
        double t;      // since it began [s]
        double ease;   // until the acceleration of then is gone [s]
        nck_moment_t from;
        double s;      // behind that [mm]
        nck_ramp_t ramp; // downward
    } stop;
} nck_sync_t;

// The angle as measured, for this tick; one that is no number, or beyond 10¹² revolutions either
// way, is none: the spindle seems to stand. Cost: constant. Context: tick.
void nck_sync_measure(nck_sync_t *self, double turns);

// A tick has passed: unless the angle is measured, the spindle turns as commanded.
// Cost: constant. Context: tick.
void nck_sync_turn(nck_sync_t *self, const nck_machine_t *machine, double rpm);

// One tick of a pass: place, speed and state of the pose. Returns nck_sync_state_t; ENDS once.
// Cost: constant. Context: tick.
uint32_t nck_sync_tick(nck_sync_t *self, const nck_machine_t *machine, const nck_seg_t *seg,
                         nck_pose_t *pose);

#endif
