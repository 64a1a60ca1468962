// SPDX-License-Identifier: MIT
// Inside room 6: a tap.
#include "nck/tick/6_interpolate/tap.h"

#include <string.h> // memcpy

#include "nck/base/fence.h" // nck_fence_load nck_fence_store
#include "nck/base/real.h"  // nck_fabs nck_max nck_min nck_real_of
#include "nck/tick/6_interpolate/follow.h" // nck_follow …

#define SECONDS 60.0
#define STANDS 1e-3   // of the commanded speed: a spindle that turns less has stopped
#define SETTLED 5e-3  // of it, on average over
#define STEADY 0.5    // so long [s]: an encoder's step of 2 ms to and fro is less
#define ANSWER 1.0    // [s] in which a spindle turns round, once it is told
#define UNLIMITED 1e30

// How far the tool may go along the pass: to the bottom and beyond, if the spindle is late, but not
// out of the travel [mm].
static double way_most(const nck_pass_t *pass, const nck_machine_t *machine, const double *start) {
    double most = UNLIMITED;
    for (int x = 0; x < 3; x++) {
        const nck_axis_t *const axis = &machine->axis[x];
        const double way = pass->way[x];
        const double counts = nck_machine_counts(machine, x);
        const double limit = nck_real_of(way < 0.0 ? axis->min_nm : axis->max_nm) / counts;
        if (way != 0.0) most = nck_min(most, (limit - start[x]) / way);
    }
    return nck_max(most, pass->length);
}

void nck_tap_begin(nck_sync_t *self, const nck_machine_t *machine, const nck_seg_t *seg) {
    nck_pass_t *const pass = &self->pass;
    nck_tap_plan(machine, &seg->shape.tap, seg->spin.speed, pass, &self->stop.ramp);
    self->stop.rate = 0.0;
    self->stop.s = pass->leave_at;
    const double most = way_most(pass, machine, seg->start);
    pass->enter_s = pass->ramp.time + (most - pass->ramp.length) / pass->ramp.v;
}

// How far the tool is when the spindle has turned for t at its full speed.
static void find_moment(const nck_sync_t *self, double t, nck_moment_t *at) {
    const nck_ramp_t *const ramp = &self->pass.ramp;
    if (t < ramp->time) {
        nck_thread_on_ramp(ramp, nck_max(0.0, t), at);
    } else {
        *at = (nck_moment_t){ramp->length + ramp->v * (t - ramp->time), ramp->v, 0.0};
    }
}

// Where it is then.
static void stand(const nck_sync_t *self, const nck_seg_t *seg, nck_moment_t *at,
                  nck_pose_t *pose) {
    find_moment(self, self->t, at);
    for (int x = 0; x < NCK_AXIS_MAX; x++) {
        pose->axis[x] = seg->start[x] + self->pass.way[x] * at->s;
    }
    pose->feed = self->pass.ramp.v;
    pose->v = at->v * nck_fabs(self->rate);
}

// What the command has led to since the spindle began to brake [mm]: to the bottom, a rest, and out
// again. Of a stop: from its speed to rest, whichever way it turned.
static double commanded(const nck_sync_t *self, double dwell, double t) {
    const nck_ramp_t *const ramp = &self->stop.ramp;
    const double behind = t - ramp->time;
    const double out = behind - dwell;
    nck_moment_t at;
    if (t < 0.0) return ramp->v * t;
    if (behind < 0.0) {
        nck_thread_on_ramp(ramp, -behind, &at);
        return ramp->length - at.s;
    }
    if (out <= 0.0 || self->state == NCK_SYNC_STOPS) return ramp->length;
    nck_thread_on_ramp(ramp, nck_min(out, ramp->time), &at);
    return ramp->length - at.s - ramp->v * nck_max(0.0, out - ramp->time);
}

// The mean speed until the next tick becomes the spindle's [rpm].
static void command(nck_sync_t *self, double period, const nck_tap_t *tap, double s,
                    nck_pose_t *pose) {
    const double v = self->pass.ramp.v;
    const double dwell = (double)tap->dwell;
    if (self->stop.rate == 0.0 && s + v * period > self->stop.s) {
        self->stop.rate = 1.0;
        self->stop.t = (s - self->stop.s) / v;
    }
    if (self->stop.rate == 0.0) return;
    const double way = commanded(self, dwell, self->stop.t + period)
                       - commanded(self, dwell, self->stop.t);
    pose->spindle_rpm = self->stop.rate * way / period / tap->lead * 60.0;
    self->stop.t += period;
}

// The spindle brakes from the speed that it was told last; the tool stays in step until it stands.
static void begin_stop(nck_sync_t *self, const nck_tap_t *tap) {
    const nck_ramp_t back = self->stop.ramp;
    const double v = self->rpm * tap->lead / 60.0;
    nck_thread_ramp(nck_fabs(v), back.a, back.j, &self->stop.ramp);
    self->stop.rate = v < 0.0 ? -1.0 : 1.0;
    self->stop.t = 0.0;
    self->slow = 1.0;
    self->stop.size = 1.0;
    self->state = NCK_SYNC_STOPS;
    nck_fence_store(&self->lost, 1);
}

static uint32_t end(nck_sync_t *self, nck_pose_t *pose) {
    pose->v = 0.0;
    self->state = NCK_SYNC_NOT;
    return NCK_SYNC_ENDS;
}

// t and rate of this tick: within the tap, and no further than the axes may go. Returns by how much
// the spindle is beside that [s]. Of a stop it is in step whatever came before.
static double take_turns(nck_sync_t *self, double rpm, double period) {
    const double before = self->t;
    const double step = NCK_FOLLOW_FASTER * period;
    nck_follow_room_t room;
    room.least = -NCK_FOLLOW_FASTER;
    room.most = self->pass.enter_s;
    room.change = UNLIMITED;
    room.rpm = rpm;
    room.period = period;
    find_moment(self, before, &room.at);
    find_moment(self, self->rate < 0.0 ? before - step : before + step, &room.far);
    double beside = nck_follow(self, &room);
    const double t = nck_max(0.0, nck_min(self->pass.enter_s, self->t));
    beside += self->t - t;
    self->t = t;
    self->rate = (t - before) / period;
    if (self->state == NCK_SYNC_STOPS) self->begin = self->turns - t * rpm / SECONDS;
    return beside;
}

// A spindle that hardly turns as it is told to. It may take its time to turn round.
static int is_slow(nck_sync_t *self, const nck_tap_t *tap, double period) {
    const double turned = 2.0 * self->stop.ramp.time + (double)tap->dwell + ANSWER;
    if (self->stop.rate == 0.0) return nck_follow_is_slow(self, 1.0, period);
    return self->stop.t > turned && nck_follow_is_slow(self, -1.0, period);
}

// 1 if the spindle stands, whatever small steps its encoder takes to and fro.
static int stands(nck_sync_t *self, double period) {
    const double share = nck_min(1.0, period / STEADY);
    self->slow += (self->rate - self->slow) * share;
    self->stop.size += (nck_fabs(self->slow) - self->stop.size) * share;
    const double rate = nck_min(nck_fabs(self->rate), self->stop.size * STANDS / SETTLED);
    return self->stop.t > self->stop.ramp.time && rate < STANDS;
}

uint32_t nck_tap_tick(nck_sync_t *self, const nck_machine_t *machine, const nck_seg_t *seg,
                      nck_pose_t *pose) {
    const nck_tap_t *const tap = &seg->shape.tap;
    const double period = machine->period_s;
    nck_moment_t at;
    const double beside = take_turns(self, seg->spin.speed, period);
    const int returns = self->stop.rate != 0.0 && self->state == NCK_SYNC_RUNS;
    if (returns && self->t <= 0.0) {
        memcpy(pose->axis, seg->end, sizeof pose->axis);
        return end(self, pose);
    }
    const int asked = (int)nck_fence_load(&self->asked);
    if (self->state == NCK_SYNC_RUNS) {
        const int slow = is_slow(self, tap, period);
        const int lost = nck_fabs(beside) > NCK_FOLLOW_SLACK || slow;
        if (asked || lost) begin_stop(self, tap);
    }
    stand(self, seg, &at, pose);
    command(self, period, tap, at.s, pose);
    if (self->state == NCK_SYNC_RUNS) return NCK_SYNC_RUNS;
    pose->state = NCK_TICK_HOLD;
    return stands(self, period) ? end(self, pose) : NCK_SYNC_STOPS;
}
