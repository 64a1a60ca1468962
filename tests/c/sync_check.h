// SPDX-License-Identifier: MIT
// What the tests of passes and taps share: room 6 alone, a spindle, and its ticks.
#ifndef SYNC_CHECK_H
#define SYNC_CHECK_H

#include <math.h>   // floor
#include <string.h> // memcpy memset

#include "check.h"
#include "nck/tick/6_interpolate/sync.h" // nck_sync_tick

#define PERIOD 1e-3
#define NEAR 1e-9 // [mm] of sums over some thousand ticks

static nck_machine_t machine;
static nck_sync_t sync;
static nck_seg_t seg;
static nck_pose_t pose;
static double turns; // of the spindle, as measured
static double rpm;   // at which it turns

// 25 mm along Z at a lead of 1.5 mm and 1200 rpm, 30 mm/s: in the ninth part of a revolution from
// where the spindle is.
static inline void begin(uint32_t slope) {
    nck_machine_default(&machine);
    machine.slope = slope;
    machine.period_s = PERIOD;
    memset(&sync, 0, sizeof sync);
    memset(&seg, 0, sizeof seg);
    memset(&pose, 0, sizeof pose);
    seg.kind = NCK_SEG_THREAD;
    seg.start[NCK_AXIS_X] = 10.0;
    seg.end[NCK_AXIS_X] = 10.0;
    seg.start[NCK_AXIS_Z] = 5.0;
    seg.end[NCK_AXIS_Z] = -20.0;
    seg.spin.speed = 1200.0;
    seg.shape.thread.length = 25.0;
    seg.shape.thread.lead = 1.5;
    seg.shape.thread.turn = 0.25f;
    turns = 7.1;
    rpm = 1200.0;
}

// A hole of 30 mm at 600 rpm and 1.5 mm: 15 mm/s.
static inline void begin_tap(uint32_t slope) {
    begin(slope);
    memcpy(seg.end, seg.start, sizeof seg.end);
    seg.kind = NCK_SEG_TAP;
    seg.spin.speed = 600.0;
    rpm = 600.0;
    memset(&seg.shape, 0, sizeof seg.shape);
    seg.shape.tap.way[2] = -30.0;
    seg.shape.tap.lead = 1.5;
}

static inline uint32_t tick(void) {
    turns += rpm / 60.0 * PERIOD;
    nck_sync_measure(&sync, turns);
    return nck_sync_tick(&sync, &machine, &seg, &pose);
}

static inline double fraction(double x) { return x - floor(x); }

// Tick until the pass runs. Returns how many ticks it has waited.
static inline int wait_for_begin(check_t *check) {
    int ticks = 0;
    while (tick() == NCK_SYNC_WAITS && ticks < 1000) {
        CHECK_INT(check, pose.state, NCK_TICK_DWELL);
        ticks++;
    }
    CHECK_INT(check, sync.state, NCK_SYNC_RUNS);
    CHECK_INT(check, pose.state, NCK_TICK_MOVE);
    return ticks;
}

// Behind the begin: the pass is at t, with a spindle that turns evenly at a rate of its command.
static inline void jump(double t, double rate) {
    const double commanded = seg.spin.speed;
    sync.t = t;
    sync.rate = rate;
    sync.was = 0.0;
    sync.slow = 0.0;
    sync.seen = turns;
    sync.begin = turns - t * commanded / 60.0;
    rpm = rate * commanded;
}

static inline void tick_for(int ticks) {
    for (int k = 0; k < ticks; k++) (void)tick();
}

// How far it is along Z.
static inline double gone(void) { return seg.start[NCK_AXIS_Z] - pose.axis[NCK_AXIS_Z]; }

// Tick until the end. Returns the ticks; the state is `state` until then.
static inline int run_out(check_t *check, uint32_t state) {
    int ticks = 1;
    while (tick() != NCK_SYNC_ENDS && ticks < 100000) {
        if (sync.state != state) CHECK_INT(check, sync.state, state);
        ticks++;
    }
    CHECK_INT(check, sync.state, NCK_SYNC_NOT);
    return ticks;
}

#endif
