// SPDX-License-Identifier: MIT
// Inside room 6: passes of threads, whose time is the spindle's angle.
#include "nck/tick/6_interpolate/sync.h"

#include <string.h> // memcpy

#include "nck/base/fence.h" // nck_fence_load nck_fence_store
#include "nck/base/real.h"  // nck_fabs nck_floor nck_max nck_min nck_sqrt
#include "nck/tick/6_interpolate/follow.h" // nck_follow …
#include "nck/tick/6_interpolate/tap.h"    // nck_tap_begin nck_tap_tick

#define SECONDS 60.0
#define UNLIMITED 1e30
#define TURNS_MOST 1e12 // beyond, a double has less than a thousandth of a turn

void nck_sync_measure(nck_sync_t *self, double turns) {
    self->measured = 1;
    if (turns > -TURNS_MOST && turns < TURNS_MOST) self->turns = turns;
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
    self->seen = self->turns;
    self->slow = 0.0;
    self->t = 0.0;
    self->was = 0.0;
    self->state = NCK_SYNC_WAITS;
}

// s along the pass and X beside it become the place. at->v: as fast as the tool is.
static void stand(const nck_sync_t *self, const nck_seg_t *seg, const nck_moment_t *at,
                  nck_pose_t *pose) {
    for (int x = 0; x < NCK_AXIS_MAX; x++) {
        pose->axis[x] = seg->start[x] + self->pass.way[x] * at->s;
    }
    pose->axis[NCK_AXIS_X] += nck_thread_beside(&self->pass, self->t);
    pose->v = at->v;
    pose->feed = self->pass.ramp.v;
}

// The pass is at t, at its rate.
static void find_moment(const nck_sync_t *self, nck_moment_t *at) {
    nck_thread_at(&self->pass, self->t, at);
    at->v *= nck_max(0.0, self->rate);
}

// How long X takes to let its pace of now go, as 1 − 3y² + 2y³. In a swing of d in T it is no
// faster than v = 2·d/T at the rate 1.
//   a ≥ 3/2·v·r/t      j ≥ 6·v·r/t²
static double fade_time(const nck_pass_t *pass, const nck_machine_t *machine, double rate) {
    const nck_axis_t *const axis = &machine->axis[NCK_AXIS_X];
    double v = 0.0;
    if (pass->enter_s > 0.0) v = 2.0 * nck_fabs(pass->enter) / pass->enter_s;
    if (pass->leave_s > 0.0) v = nck_max(v, 2.0 * nck_fabs(pass->leave) / pass->leave_s);
    return nck_max(1.5 * v * rate / axis->a_max, nck_sqrt(6.0 * v * rate / axis->j_max));
}

// In the run-out a ramp of its own would be a step of acceleration, unless the spindle is so slow
// that its jerk is within the limit.
static int runs_out(const nck_sync_t *self, double period) {
    const nck_pass_t *const pass = &self->pass;
    if (self->t < pass->ramp.time + pass->cruise) return 0;
    return pass->ramp.a * self->rate * self->rate > pass->ramp.j * period;
}

// Stop by itself: first the acceleration of now goes, then a ramp leads to rest. In the run-out, or
// so near to it that there is no room for more, the pass ends as planned, at the rate of now. X
// ends what it has begun, if the spindle is not about to stand.
static void begin_stop(nck_sync_t *self, const nck_machine_t *machine) {
    nck_moment_t at;
    const nck_pass_t *const pass = &self->pass;
    const double rate = nck_max(0.0, self->rate);
    find_moment(self, &at);
    at.a = nck_max(0.0, at.a) * rate * rate;
    const double j = pass->ramp.j;
    const double ease = j > 0.0 ? at.a / j : 0.0;
    const double v = at.v + 0.5 * at.a * ease;
    self->stop.rate = rate;
    self->stop.fade = rate < NCK_FOLLOW_SLOWEST ? fade_time(pass, machine, rate) : -1.0;
    self->stop.t = 0.0;
    self->stop.ease = ease;
    self->stop.from = at;
    self->stop.s = (at.v + (at.a / 2.0 - j * ease / 6.0) * ease) * ease;
    nck_thread_ramp(v, pass->ramp.a, j, &self->stop.ramp);
    const double needs = self->stop.s + self->stop.ramp.length;
    if (runs_out(self, machine->period_s) || pass->length - at.s <= needs) self->stop.ease = -1.0;
    self->state = NCK_SYNC_STOPS;
    nck_fence_store(&self->lost, 1);
}

// At which rate X goes on.
static double find_pace(const nck_sync_t *self) {
    const double x = self->stop.t;
    const double fade = self->stop.fade;
    if (fade < 0.0) return self->stop.rate;
    if (x >= fade) return 0.0;
    const double y = x / fade;
    return self->stop.rate * (1.0 - (3.0 - 2.0 * y) * y * y);
}

// The way while stopping, as it was laid down when the stop began. X ends what it has begun.
static int find_stop(nck_sync_t *self, double period, nck_moment_t *at) {
    const nck_moment_t *const from = &self->stop.from;
    const double ease = self->stop.ease;
    const double left = self->pass.leave_at;
    const int leaves = self->t > left;
    self->stop.t += period;
    if (ease < 0.0) {
        self->t += self->stop.rate * period;
        find_moment(self, at);
        return self->t < self->pass.total;
    }
    const double pace = find_pace(self);
    const double t = self->t + pace * period;
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
    return rest > 0.0 || (pace > 0.0 && self->t < nck_min(swings, self->pass.total));
}

static uint32_t stopping(nck_sync_t *self, const nck_machine_t *machine, const nck_seg_t *seg,
                         nck_pose_t *pose) {
    nck_moment_t at;
    const int goes_on = find_stop(self, machine->period_s, &at);
    stand(self, seg, &at, pose);
    pose->state = NCK_TICK_HOLD;
    if (goes_on) return NCK_SYNC_STOPS;
    self->state = NCK_SYNC_NOT;
    return NCK_SYNC_ENDS;
}

// The tool goes on with the spindle, never back. Returns by how much the spindle is ahead [s].
static double follow(nck_sync_t *self, double rpm, double period) {
    const nck_pass_t *const pass = &self->pass;
    const double t = self->t;
    const double far = t + NCK_FOLLOW_FASTER * period;
    nck_follow_room_t room;
    room.least = 0.0;
    room.most = UNLIMITED;
    room.change = UNLIMITED;
    room.rpm = rpm;
    room.period = period;
    nck_thread_at(pass, t, &room.at);
    nck_thread_at(pass, far, &room.far);
    if (t < pass->enter_s) room.change = pass->change[0];
    if (far > pass->leave_at && t < pass->leave_at + pass->leave_s) {
        room.change = nck_min(room.change, pass->change[1]);
    }
    return nck_follow(self, &room);
}

// With the spindle, from its angle on.
static uint32_t running(nck_sync_t *self, const nck_machine_t *machine, const nck_seg_t *seg,
                        nck_pose_t *pose) {
    nck_moment_t at;
    const double period = machine->period_s;
    const double ahead = follow(self, seg->spin.speed, period);
    const int slow = nck_follow_is_slow(self, 1.0, period);
    const int lost = nck_fabs(ahead) > NCK_FOLLOW_SLACK || slow;
    if (nck_fence_load(&self->asked) || lost) begin_stop(self, machine);
    if (self->t >= self->pass.total) {
        memcpy(pose->axis, seg->end, sizeof pose->axis);
        self->state = NCK_SYNC_NOT;
        return NCK_SYNC_ENDS;
    }
    find_moment(self, &at);
    stand(self, seg, &at, pose);
    if (self->state == NCK_SYNC_STOPS) pose->state = NCK_TICK_HOLD;
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
    const double rpm = seg->spin.speed;
    add_turns(self, machine);
    if (self->state == NCK_SYNC_NOT) begin(self, machine, seg);
    nck_follow_look(self, rpm, machine->period_s);
    if (self->state >= NCK_SYNC_RUNS) return go_on(self, machine, seg, pose);
    if (nck_fence_load(&self->asked)) { // nothing is cut yet
        self->state = NCK_SYNC_NOT;
        pose->state = NCK_TICK_HOLD;
        return NCK_SYNC_ENDS;
    }
    const int held = (int)nck_fence_load(&self->held);
    pose->state = held ? NCK_TICK_HOLD : NCK_TICK_DWELL;
    if (held) nck_follow_aim(self);
    if (held || !nck_follow_begins(self, rpm, machine->period_s)) return NCK_SYNC_WAITS;
    self->state = NCK_SYNC_RUNS;
    pose->state = NCK_TICK_MOVE;
    return go_on(self, machine, seg, pose);
}
