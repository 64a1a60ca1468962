// SPDX-License-Identifier: MIT
// Passes in step with the spindle.
#include "thread.h"

#include <math.h>   // fabs fmax
#include <string.h> // memcpy memset

#include "feed.h" // feed_is_done

enum { PATIENCE = 10 }; // cycles without a move until a pass counts as known to its end

static int is_thread(const planner_t *self, uint32_t count) {
    return count != self->moves.head
           && moves_at((moves_t *)&self->moves, count)->kind >= MOVE_THREAD;
}

// Where its lines end: a tap is one, threads of one lead go on.
static uint32_t end_of(const planner_t *self) {
    const move_t *const first = moves_at((moves_t *)&self->moves, self->moves.next);
    uint32_t count = self->moves.next;
    if (first->kind == MOVE_TAP) return count + 1;
    while (is_thread(self, count) && count - self->moves.next < FOLLOW_LINES) {
        const move_t *const move = moves_at((moves_t *)&self->moves, count);
        if (move->kind != MOVE_THREAD || move->value != first->value) break;
        count++;
    }
    return count;
}

int thread_begins(const planner_t *self) {
    if (!is_thread(self, self->moves.next) || self->paused) return 0;
    const int open = end_of(self) == self->moves.head;
    return feed_is_done(self) && (!open || self->quiet >= PATIENCE);
}

void thread_begin(planner_t *self) {
    const uint32_t end = end_of(self);
    const move_t *const first = moves_at(&self->moves, self->moves.next);
    follow_begin(&self->follow, self->told.place, first->value, self->cycle_s);
    for (uint32_t n = self->moves.next; n != end; n++) {
        (void)follow_line(&self->follow, moves_at(&self->moves, n)->end);
    }
    self->follow.taps = first->kind == MOVE_TAP;
    follow_prepare(&self->follow, &self->machine, self->rps * fmax(first->back, 1.0));
    (void)self->hooks.index(1);
    for (int n = 0; n < PLANNER_STEPS; n++) self->steps[n] = self->rps * self->cycle_s;
    self->dropped = 0;
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

int thread_cycle(planner_t *self, const planner_wish_t *wish, double *place_out) {
    follow_t *const follow = &self->follow;
    const uint32_t before = follow->phase;
    const double back = moves_at(&self->moves, self->moves.next)->back;
    const double rps = measure(self, wish->turns);
    memcpy(place_out, self->told.place, sizeof self->told.place);
    if (before == FOLLOW_NOT) return 0;
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
    told->move = self->moves.next + follow_at(&self->follow);
    const move_t *const move = moves_at(&self->moves, told->move);
    const double reached = self->follow.s < 0.0 ? 0.0 : self->follow.s;
    self->passed = move->count - 1;
    told->between = 0;
    told->to_go = fmax(0.0, move->way - self->at - reached);
    for (int k = 0; k < MOVES_AXES; k++) told->dtg[k] = move->end[k] - told->place[k];
}

void thread_stop(planner_t *self) {
    if (self->follow.phase == FOLLOW_RETURNS) {
        self->hooks.turn(-1.0 / moves_at(&self->moves, self->moves.next)->back);
    }
    follow_stop(&self->follow);
    self->dropped = 1;
}

void thread_end(planner_t *self) {
    const double length = self->follow.end[self->follow.lines];
    const uint32_t lines = self->follow.lines;
    self->skipped += length;
    self->at += length;
    self->moves.next += lines;
    self->flushed = self->moves.next;
    self->first = self->moves.next;
    self->moves.tail = self->moves.next;
    memset(self->told.dtg, 0, sizeof self->told.dtg);
}
