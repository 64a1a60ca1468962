// SPDX-License-Identifier: MIT
// Inside room 6: passes of threads, whose time is the spindle's angle.
#include "nck/tick/6_interpolate/sync.h"

#include <string.h> // memcpy

#include "nck/base/fence.h" // nck_fence_load nck_fence_store
#include "nck/base/real.h"  // nck_floor nck_max nck_min
#include "nck/tick/6_interpolate/tap.h" // nck_tap_begin nck_tap_tick

#define SECONDS 60.0

void nck_sync_measure(nck_sync_t *self, double turns) {
    self->measured = 1;
    self->turns = turns;
}

// The ticks at one speed are added up when it changes, or somebody asks: arithmetic is dear.
static void add_turns(nck_sync_t *self, const nck_machine_t *machine) {
    const double time = machine->period_s * (double)self->untold;
    if (!self->measured) self->turns += self->rpm / SECONDS * time;
    self->untold = 0;
}

void nck_sync_turn(nck_sync_t *self, const nck_machine_t *machine, double rpm) {
    if (rpm != self->rpm) {
        add_turns(self, machine);
        self->rpm = rpm;
    }
    self->untold++;
}

static double fraction(double x) { return x - nck_floor(x); }

// The angle at which the pass begins. Running in, the tool lags behind one that had started at full
// speed by v·t − s, of a symmetric ramp its length: so it starts that much earlier.
//   begin ≡ turn − (v·t − s) / lead      the next such angle
static void begin(nck_sync_t *self, const nck_machine_t *machine, const nck_seg_t *seg) {
    const nck_thread_t *const thread = &seg->shape.thread;
    if (seg->kind == NCK_SEG_TAP) nck_tap_begin(self, machine, seg);
    else nck_thread_plan(machine, seg->start, seg->end, thread, seg->spin.speed, &self->pass);
    const nck_ramp_t *const ramp = &self->pass.ramp;
    const double lag = ramp->v * ramp->time - ramp->length;
    const int taps = seg->kind == NCK_SEG_TAP;
    const double turn = taps ? 0.0 : (double)thread->turn;
    const double angle = fraction(turn - lag / (taps ? seg->shape.tap.lead : thread->lead));
    self->begin = self->turns + fraction(angle - fraction(self->turns));
    self->t = 0.0;
    self->before = 0.0;
    self->state = NCK_SYNC_WAITS;
}

// s along the pass and X beside it become the place.
static void stand(const nck_sync_t *self, const nck_seg_t *seg, const nck_moment_t *at,
                  nck_pose_t *pose) {
    for (int x = 0; x < NCK_AXIS_MAX; x++) {
        pose->axis[x] = seg->start[x] + self->pass.way[x] * at->s;
    }
    pose->axis[NCK_AXIS_X] += nck_thread_beside(&self->pass, self->t);
    pose->v = at->v;
    pose->feed = self->pass.ramp.v;
}

// The turns of the spindle since the begin as time, which never runs back, nor faster than the axes
// can follow. Returns by how much the spindle is ahead [s].
static double take_turns(nck_sync_t *self, double rpm, double period) {
    const double wanted = (self->turns - self->begin) * SECONDS / rpm;
    self->before = self->t;
    self->t = nck_max(self->t, nck_min(wanted, self->t + NCK_SYNC_FASTER * period));
    return wanted - self->t;
}

// Stop by itself: first the acceleration of now goes, then a ramp leads to rest. In the run-out, or
// so near to it that there is no room for more, the pass ends as planned, at the rate of now.
static void begin_stop(nck_sync_t *self, double period) {
    nck_moment_t at;
    const nck_pass_t *const pass = &self->pass;
    const double rate = (self->t - self->before) / period;
    nck_thread_at(pass, self->t, &at);
    at.v *= rate;
    at.a = nck_max(0.0, at.a) * rate * rate;
    const double j = pass->ramp.j;
    const double ease = j > 0.0 ? at.a / j : 0.0;
    const double v = at.v + 0.5 * at.a * ease;
    self->stop.rate = rate;
    self->stop.t = 0.0;
    self->stop.ease = ease;
    self->stop.from = at;
    self->stop.s = (at.v + (at.a / 2.0 - j * ease / 6.0) * ease) * ease;
    nck_thread_ramp(v, pass->ramp.a, j, &self->stop.ramp);
    const double needs = self->stop.s + self->stop.ramp.length;
    const double room_s = pass->ramp.time + pass->cruise - self->t;
    const double room = pass->length - at.s - needs;
    if (nck_min(room_s, room) <= 0.0) self->stop.ease = -1.0;
    self->state = NCK_SYNC_STOPS;
    nck_fence_store(&self->lost, 1);
}

// The way while stopping, as it was laid down when the stop began. X ends what it has begun.
static int find_stop(nck_sync_t *self, double period, nck_moment_t *at) {
    const nck_moment_t *const from = &self->stop.from;
    const double ease = self->stop.ease;
    const double left = self->pass.leave_at;
    const int leaves = self->t > left;
    const double t = self->t + self->stop.rate * period;
    self->stop.t += period;
    if (ease < 0.0) {
        self->t = t;
        nck_thread_at(&self->pass, t, at);
        return self->stop.rate > 0.0 && t < self->pass.total;
    }
    self->t = leaves ? t : nck_min(t, left);
    const double swings = leaves ? left + self->pass.leave_s : self->pass.enter_s;
    const double x = self->stop.t;
    if (x < ease) {
        const double j = self->pass.ramp.j;
        at->s = from->s + (from->v + (from->a / 2.0 - j * x / 6.0) * x) * x;
        at->v = from->v + (from->a - j * x / 2.0) * x;
        return 1;
    }
    const double rest = nck_max(0.0, self->stop.ramp.time - (x - ease));
    nck_thread_on_ramp(&self->stop.ramp, rest, at);
    at->s = from->s + self->stop.s + self->stop.ramp.length - at->s;
    return rest > 0.0 || (self->stop.rate > 0.0 && self->t < nck_min(swings, self->pass.total));
}

static uint32_t stopping(nck_sync_t *self, const nck_machine_t *machine, const nck_seg_t *seg,
                         nck_pose_t *pose) {
    nck_moment_t at = {0.0, 0.0, 0.0};
    const int goes_on = find_stop(self, machine->period_s, &at);
    stand(self, seg, &at, pose);
    pose->state = NCK_TICK_HOLD;
    if (goes_on) return NCK_SYNC_STOPS;
    pose->v = 0.0;
    self->state = NCK_SYNC_NOT;
    return NCK_SYNC_ENDS;
}

// With the spindle, from its angle on.
static uint32_t running(nck_sync_t *self, const nck_machine_t *machine, const nck_seg_t *seg,
                        nck_pose_t *pose) {
    nck_moment_t at;
    const double ahead = take_turns(self, seg->spin.speed, machine->period_s);
    if (nck_fence_load(&self->asked) || ahead > NCK_SYNC_SLACK) begin_stop(self, machine->period_s);
    if (self->t >= self->pass.total) {
        memcpy(pose->axis, seg->end, sizeof pose->axis);
        self->state = NCK_SYNC_NOT;
        return NCK_SYNC_ENDS;
    }
    nck_thread_at(&self->pass, self->t, &at);
    stand(self, seg, &at, pose);
    return self->state;
}

// With the spindle, or braking.
static uint32_t go_on(nck_sync_t *self, const nck_machine_t *machine, const nck_seg_t *seg,
                      nck_pose_t *pose) {
    if (seg->kind == NCK_SEG_TAP) return nck_tap_tick(self, machine, seg, pose);
    return self->state == NCK_SYNC_STOPS ? stopping(self, machine, seg, pose)
                                         : running(self, machine, seg, pose);
}

uint32_t nck_sync_tick(nck_sync_t *self, const nck_machine_t *machine, const nck_seg_t *seg,
                         nck_pose_t *pose) {
    add_turns(self, machine);
    if (self->state == NCK_SYNC_NOT) begin(self, machine, seg);
    if (self->state >= NCK_SYNC_RUNS) return go_on(self, machine, seg, pose);
    if (nck_fence_load(&self->asked)) { // nothing is cut yet
        self->state = NCK_SYNC_NOT;
        pose->state = NCK_TICK_HOLD;
        return NCK_SYNC_ENDS;
    }
    pose->state = NCK_TICK_DWELL;
    if (self->turns < self->begin) return NCK_SYNC_WAITS;
    self->state = NCK_SYNC_RUNS;
    pose->state = NCK_TICK_MOVE;
    return go_on(self, machine, seg, pose);
}
