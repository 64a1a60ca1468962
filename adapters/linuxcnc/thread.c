// SPDX-License-Identifier: MIT
// Passes in step with the spindle.
#include "thread.h"

#include <math.h>   // fabs fmax INFINITY
#include <string.h> // memcpy memset

#include "feed.h" // feed_is_done feed_bounds

// Lines of a pass that are taken over in one cycle, at most; behind the index each has its price.
enum { LINES = 8 };

static const move_t *next_of(const planner_t *self) {
    const moves_t *const moves = &self->moves;
    return moves->next == moves->head ? NULL : moves_at((moves_t *)moves, moves->next);
}

int thread_begins(const planner_t *self) {
    const move_t *const next = next_of(self);
    if (!next || next->kind < MOVE_THREAD || self->paused || self->moves.back) return 0;
    return feed_is_done(self) && self->hooks.at_speed();
}

// What the axes can now.
static void find_limits(const planner_t *self, follow_limits_t *limits_out) {
    bounds_t bounds;
    feed_bounds(self, &bounds);
    for (int k = 0; k < FOLLOW_AXES; k++) {
        const int there = (int)(self->settings.axes >> k & 1u);
        const int linear = self->settings.slope == NCK_SLOPE_LINEAR || !(self->bounds.j[k] > 0.0);
        limits_out->v[k] = there ? bounds.v[k] : 0.0;
        limits_out->a[k] = bounds.a[k];
        limits_out->j[k] = linear ? INFINITY : self->bounds.j[k];
    }
}

// One more line of the pass. 0: it has no room.
static int take_line(planner_t *self) {
    const move_t *const move = next_of(self);
    const uint32_t name = self->moves.next;
    if (!follow_line(&self->follow, move->end, move->value, move->a_share, name)) return 0;
    self->moves.next++;
    return 1;
}

static int is_word(const move_t *move) {
    return move->kind == MOVE_DIGITAL || move->kind == MOVE_ANALOG;
}

// The lines of the pass that have come: threads one behind the other, whatever their leads; words
// between them are said where the tool is. A tap is one line.
static void take(planner_t *self) {
    const move_t *next = next_of(self);
    const int most = self->follow.phase == FOLLOW_INDEX ? LINES : 1;
    for (int n = 0; n < most && next; n++) {
        if (is_word(next)) self->moves.next++;
        else if (next->kind != MOVE_THREAD || !take_line(self)) break;
        next = next_of(self);
    }
    self->follow.open = !next || next->kind == MOVE_THREAD || is_word(next);
}

// Where what comes behind has come, the pass has all its lines: it can be planned from where they
// end. The kernel rests where the pass began, and knows no place but that.
static void end_lines(planner_t *self) {
    const move_t *const next = next_of(self);
    if (!next || (!self->follow.taps && next->kind >= MOVE_DIGITAL)) return;
    nck_pose_t pose;
    nck_axes_t axes;
    const double *const end = follow_end(&self->follow);
    (void)nck_position(&self->nck, &pose, &axes);
    for (int k = 0; k < MOVES_AXES; k++) self->offset[k] = end[k] - pose.axis[k];
    self->flushed = self->moves.next;
    self->closed = 1;
}

// Words of the entries before one.
static void say(planner_t *self, uint32_t end) {
    for (; self->cut != end; self->cut++) {
        const move_t *const move = moves_at(&self->moves, self->cut);
        if (move->kind == MOVE_DIGITAL) self->hooks.digital(move->index, (char)(move->value > 0.0));
        if (move->kind == MOVE_ANALOG) self->hooks.analog(move->index, move->value);
    }
}

void thread_begin(planner_t *self) {
    follow_t *const follow = &self->follow;
    const move_t *const first = next_of(self);
    find_limits(self, &follow->limits);
    follow_begin(follow, self->told.place, self->rps * fmax(first->back, 1.0), self->cycle_s);
    self->cut = self->moves.next;
    (void)take_line(self);
    follow->taps = first->kind == MOVE_TAP;
    if (!follow->taps) take(self);
    (void)self->hooks.index(1);
    for (int n = 0; n < PLANNER_STEPS; n++) self->steps[n] = self->wish.rps * self->cycle_s;
    self->turns = self->wish.turns;
    self->dropped = self->closed = 0;
    self->led = self->moves.next;
    self->state = PLANNER_FOLLOWS;
}

// The spindle's speed [1/s], + as it turned when the pass began, by its angle: an encoder's counts
// are coarse, so over some cycles. At its index the angle jumps.
static double measure(planner_t *self, double turns) {
    double sum = 0.0;
    const double step = turns - self->turns;
    self->turns = turns;
    if (fabs(step) < 0.5) {
        self->steps[self->step] = step;
        self->step = (self->step + 1) % PLANNER_STEPS;
    }
    for (int n = 0; n < PLANNER_STEPS; n++) sum += self->steps[n];
    return sum / (PLANNER_STEPS * self->cycle_s);
}

// Lines of the pass that have come since, and where they end.
static void take_lines(planner_t *self) {
    if (!self->dropped && !self->follow.taps && !self->closed) take(self);
    if (self->closed) return;
    self->led = self->moves.next;
    if (!self->dropped) end_lines(self);
}

int thread_cycle(planner_t *self, const planner_wish_t *wish, double *place_out) {
    follow_t *const follow = &self->follow;
    const uint32_t before = follow->phase;
    const double back = moves_at(&self->moves, self->cut)->back;
    const double rps = measure(self, wish->turns);
    memcpy(place_out, self->told.place, sizeof self->told.place);
    if (before == FOLLOW_NOT) return 0;
    take_lines(self);
    if (before == FOLLOW_INDEX) {
        if (self->hooks.index(0)) follow_index(follow, wish->rps > 0.0 ? wish->rps : rps);
        return 1;
    }
    const int goes_on = follow_cycle(follow, wish->turns, rps, place_out);
    if (before == FOLLOW_CUTS && follow->phase == FOLLOW_RETURNS) self->hooks.turn(-back);
    if (before == FOLLOW_RETURNS && follow->phase != before) self->hooks.turn(-1.0 / back);
    return goes_on;
}

void thread_tell(planner_t *self) {
    planner_told_t *const told = &self->told;
    told->move = follow_move(&self->follow, &told->to_go);
    const move_t *const move = moves_at(&self->moves, told->move);
    self->passed = move->count - 1;
    told->between = 0;
    for (int k = 0; k < MOVES_AXES; k++) told->dtg[k] = move->end[k] - told->place[k];
    if (!self->follow.taps) say(self, told->move);
    moves_pass(&self->moves, told->move);
}

void thread_stop(planner_t *self) {
    if (self->follow.phase == FOLLOW_RETURNS) {
        self->hooks.turn(-1.0 / moves_at(&self->moves, self->cut)->back);
    }
    follow_stop(&self->follow);
    self->dropped = 1;
}

void thread_end(planner_t *self) {
    const double way = moves_at(&self->moves, self->led - 1)->way;
    if (!self->dropped) say(self, self->led);
    self->skipped += way - self->at;
    self->at = way;
    if (!self->closed) self->flushed = self->led;
    self->first = self->led;
    self->moves.tail = self->led;
    memset(self->told.dtg, 0, sizeof self->told.dtg);
}
