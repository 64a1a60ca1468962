// SPDX-License-Identifier: MIT
// How fast: overrides, caps, feeds a revolution.
#include "rates.h"

#include <math.h>   // fabs floor fmax fmin HUGE_VAL
#include <stddef.h> // NULL

#include "feed.h" // feed_is_done

enum {
    PPM = 1000000,
    CALM = 20,      // [ms] between two overrides: each is a plan of its own, …
    PATIENCE = 200, // … and one that is being made is waited for, so long at most
    TREND = 32,     // [ms] of the faster of two means of the spindle's speed; the other: twice
    SETTLES = 15,   // [ms] from an answer in force until the tool has its speed, seen
    PACES = 8,      // of them that their mean is of: one that is late does not step
    PACE_MOST = 60  // [ms] between two overrides that are told as soon as they can be, seen
};

static const double part_share = 5e-3; // of the radius, by which a part of a line under G96 goes
static const double part_least = 0.05; // [mm] a part is no shorter, …
static const double part_s = 0.02;     // … or lasts so long: more than the kernel takes for it
static const double there = 0.02; // of an override, by which a spindle may be off what it is told
static const double fine = 5e-4; // of an override, by which a spindle's is not told anew: a tenth
                                 // of what a feed a revolution may be off

// ---- what is wanted

static uint32_t ppm(double share, double most) {
    return (uint32_t)(fmin(fmax(share, 0.0), most) * PPM + 0.5);
}

// Faster than this no tool can be: no limit then, which is cheaper to plan.
static uint32_t speed_um_s(const planner_t *self, double v_most) {
    double sum = 0.0;
    for (int k = 0; k < MOVES_AXES; k++) {
        const nck_axis_t *const axis = &self->machine.axis[k];
        if (axis->present) sum += axis->v_max * axis->v_max;
    }
    if (v_most * v_most >= sum || v_most > 4e6) return UINT32_MAX;
    return (uint32_t)(fmax(v_most, 0.0) * 1e3);
}

// How fast the spindle is to turn where X is there: as it is commanded; 0: nobody says.
static double told_at(const planner_wish_t *wish, double x) {
    const double radius = fmax(fabs(x - wish->axis_x), 1e-9);
    return wish->surface > 0.0 ? fmin(wish->surface / radius, wish->rps_most) : wish->rps_most;
}

void rates_measure(planner_t *self, const planner_wish_t *wish) {
    self->wish = *wish;
    self->rps = fmax(wish->rps, told_at(wish, self->told.place[NCK_AXIS_X]));
    self->wanted = ppm(wish->feed, 2.0);
    if (self->done) self->calm = planner_cycles(self, PATIENCE);
}

// ---- what the kernel's override has to be

// Behind the last entry of which the kernel has something.
static uint32_t fed_up_to(const planner_t *self) {
    const moves_t *const moves = &self->moves;
    return moves->part > 0 ? moves_on(moves, moves->next) : moves->next;
}

// The spindle's speed that a move's feed is told for, where X is there: as commanded when the tool
// last rested; if it turned faster, as it did; where nobody says, as fast as the axes can follow.
static double base_at(const planner_t *self, const move_t *move, double x) {
    const planner_wish_t *const began = &self->began;
    const double told = told_at(began, x);
    const double most = 60.0 * bounds_along(self->bounds.v, move) / move->feed;
    const double turns = began->surface > 0.0 ? told : fmax(told, began->rps);
    return told > 0.0 ? fmin(turns, most) : most;
}

// What an override of 1 means to a move that follows the spindle: a line is told for every place.
static double base_of(const planner_t *self, const move_t *move) {
    if (move->kind == MOVE_LINE) return base_at(self, move, self->told.place[NCK_AXIS_X]);
    return move->given / move->feed;
}

// Cycles until the tool has heard of an override, and half of the time that it is in force: an
// answer takes as long as it is until the next one.
static double late(const planner_t *self) {
    return planner_cycles(self, SETTLES) + 1.5 * self->pace;
}

// What a number will be when the tool has heard of it, if it is `now` and changes as it did: by
// the difference of two means.
static double foreseen(const planner_t *self, trend_t *trend, double now) {
    const double cycles = planner_cycles(self, TREND);
    trend->fast += (now - trend->fast) / cycles;
    trend->slow += (now - trend->slow) / (2.0 * cycles);
    return fmax(now + (trend->fast - trend->slow) * (late(self) / cycles), 0.0);
}

// On its way to `end` it does not go beyond.
static double up_to(double now, double then, double end) {
    if (then > now) return end < now * (1.0 - there) ? then : fmin(then, fmax(end, now));
    return end > now * (1.0 + there) ? then : fmax(then, fmin(end, now));
}

static int is_fed_line(const planner_t *self, uint32_t count) {
    const move_t *const move = moves_at((moves_t *)&self->moves, count);
    return count != self->moves.head && move->kind == MOVE_LINE && move->per_rev;
}

// The line that the tool is on when it has heard of an override, and X there. It is known as far as
// lines fed by the revolution follow each other.
static const move_t *line_then(const planner_t *self, double *x_out) {
    uint32_t n = planner_current(self);
    double left = self->told.v * late(self) * self->cycle_s;
    double way = self->told.to_go;
    *x_out = self->told.place[NCK_AXIS_X];
    for (; left > way && is_fed_line(self, n + 1); n++) {
        const move_t *const next = moves_at((moves_t *)&self->moves, n + 1);
        *x_out = next->start[NCK_AXIS_X];
        left -= way;
        way = bounds_length(next);
    }
    const move_t *const line = moves_at((moves_t *)&self->moves, n);
    if (way > 0.0) *x_out += fmin(left / way, 1.0) * (line->end[NCK_AXIS_X] - *x_out);
    return line;
}

// The override by which a move is to follow the spindle when the tool has heard of it. A spindle
// that turns as it is told does so at every place; one that is on its way there changes its speed
// by itself, and what the feed is told for is known ahead.
static double follows(planner_t *self, const move_t *move) {
    const double base = base_of(self, move);
    const double now = self->wish.rps / base;
    const double end = told_at(&self->wish, self->told.place[NCK_AXIS_X]) / base;
    const double then = foreseen(self, &self->override, now);
    const double rps = foreseen(self, &self->spins, self->wish.rps);
    const int lags = fabs(now - end) > there * end;
    if (!lags || move->kind != MOVE_LINE) return up_to(now, then, end);
    double x;
    const move_t *const line = line_then(self, &x);
    return up_to(self->wish.rps, rps, told_at(&self->wish, x)) / base_at(self, line, x);
}

// The move in work, or the first one that will be: words have no feed. NULL: the kernel has none.
static const move_t *fed_now(const planner_t *self) {
    const moves_t *const moves = &self->moves;
    const uint32_t end = fed_up_to(self);
    uint32_t n = planner_current(self);
    for (; moves_ahead(moves, end, n) > 0; n = moves_on(moves, n)) {
        const move_t *const move = moves_at((moves_t *)&self->moves, n);
        if (move->given > 0.0) return move;
    }
    return NULL;
}

// The override by which it follows the spindle.
static void measure(planner_t *self) {
    const move_t *const move = fed_now(self);
    if (!self->by_turns || !move || !move->per_rev) return;
    self->turned = self->wish.feed * follows(self, move);
}

// With it no move that the kernel has is faster than its cap, or than the host wants [ppm]. What
// follows the spindle has the override by which the move in work does.
static uint32_t override_of(const planner_t *self, uint32_t end) {
    double least = HUGE_VAL;
    const moves_t *const moves = &self->moves;
    uint32_t n = planner_current(self);
    for (; moves_ahead(moves, end, n) > 0; n = moves_on(moves, n)) {
        const move_t *const move = moves_at((moves_t *)moves, n);
        if (!(move->given > 0.0)) continue;
        const double wanted = (double)self->wanted / PPM * move->feed;
        const double asked = move->per_rev ? self->turned * move->given : wanted;
        least = fmin(least, fmin(asked, move->cap > 0.0 ? move->cap : HUGE_VAL) / move->given);
    }
    return least < HUGE_VAL ? ppm(least, 2.0) : self->wanted;
}

// A move ahead of the tool has a cap, or a feed a revolution, and the kernel has it.
static int is_bound(const planner_t *self) {
    return moves_ahead(&self->moves, self->bound, planner_current(self)) >= 0;
}

static int is_same(const planner_t *self, uint32_t one, uint32_t other) {
    const double off = fabs((double)one - (double)other);
    return off <= (self->by_turns && is_bound(self) ? fine * (double)other : 0.0);
}

// The feeds that are asked for stand still.
static int stands(const planner_t *self, int bound) {
    return self->by_turns && bound ? self->turned <= 0.0 : self->wanted == 0;
}

// Whether one of two comes to rest.
static int is_turned(uint32_t one, uint32_t other) { return (one == 0) != (other == 0); }

static int is_asked(const planner_t *self, const nck_command_t *asked, uint32_t feed,
                    uint32_t rapid, uint32_t speed) {
    return is_same(self, asked->feed_ppm, feed) && asked->rapid_ppm == rapid
           && asked->speed_um_s == speed && !is_turned(asked->feed_ppm, feed);
}

// A change is heard at once if it comes to rest or leaves it.
void rates_hear(planner_t *self, const planner_wish_t *wish) {
    nck_command_t asked;
    const uint32_t rapid = ppm(wish->rapid, 1.0);
    const uint32_t speed = speed_um_s(self, wish->v_most);
    const int bound = is_bound(self);
    measure(self);
    nck_asked(&self->nck, &asked);
    const int rests = (asked.feed_ppm == 0) != stands(self, bound)
                      || is_turned(asked.rapid_ppm, rapid) || is_turned(asked.speed_um_s, speed);
    self->calm++;
    const uint32_t calm = planner_cycles(self, nck_is_answering(&self->nck) ? PATIENCE : CALM);
    if (!rests && self->calm < calm) return;
    const uint32_t feed = bound ? override_of(self, fed_up_to(self)) : self->wanted;
    const int same = is_asked(self, &asked, feed, rapid, speed);
    const double calm_most = planner_cycles(self, PACE_MOST);
    if (!same) self->pace += (fmin(self->calm, calm_most) - self->pace) / PACES;
    if (!same || bound) self->calm = 0;
    if (same) return;
    nck_set_override(&self->nck, feed, rapid);
    nck_set_speed(&self->nck, speed);
}

int rates_keep_behind(const planner_t *self) {
    static const double rounding = 1e-5; // [mm]
    const planner_told_t *const told = &self->told;
    const int none = !(self->wish.feed > 0.0) || !(self->wish.rapid > 0.0);
    return none && !self->paused && !(told->v > 0.0) && told->to_go < rounding;
}

// ---- moves on their way to the kernel

static int has_feed(const move_t *move) { return move->kind <= MOVE_CHORDS && move->feed > 0.0; }

// The kernel has a move with a feed that is not behind the tool.
static int feeds(const planner_t *self) {
    return moves_ahead(&self->moves, self->fed, planner_current(self)) >= 0 && !feed_is_done(self);
}

int rates_wait(const planner_t *self) {
    const move_t *const move = moves_at((moves_t *)&self->moves, self->moves.next);
    return has_feed(move) && move->per_rev != self->by_turns && feeds(self);
}

void rates_part(planner_t *self) {
    moves_t *const moves = &self->moves;
    const move_t *const move = moves_at(moves, moves->next);
    const double way = fabs(move->end[NCK_AXIS_X] - move->start[NCK_AXIS_X]);
    const double x = move->start[NCK_AXIS_X]
                     + moves->from * (move->end[NCK_AXIS_X] - move->start[NCK_AXIS_X]);
    const planner_wish_t *const began = feeds(self) ? &self->began : &self->wish;
    const double least = began->surface / fmax(began->rps_most, 1e-9);
    const double radius = fmax(fabs(x - began->axis_x), least);
    moves->to = 1.0;
    if (!move->per_rev || move->kind != MOVE_LINE || !(began->surface > 0.0 && way > 0.0)) return;
    const double v = told_at(began, x) * move->feed / 60.0;
    const double part = fmax(part_share * radius, fmin(part_least, part_s * v));
    const double to = moves->from + part / way;
    if (to < 1.0 - 0.5 * (to - moves->from)) moves->to = to;
}

// The feed of the part in the middle of it; of an arc where the spindle is to turn fastest.
static double feed_by_turns(planner_t *self, const move_t *move) {
    const double start = move->start[NCK_AXIS_X], end = move->end[NCK_AXIS_X];
    const double middle = 0.5 * (self->moves.from + self->moves.to);
    const double line = base_at(self, move, start + middle * (end - start));
    const double arc = fmax(base_at(self, move, start), base_at(self, move, end));
    return move->feed * (move->kind == MOVE_LINE ? line : arc);
}

void rates_bound(planner_t *self, nck_block_in_t *block) {
    move_t *const move = moves_at(&self->moves, self->moves.next);
    nck_command_t asked;
    if (!has_feed(move)) return;
    nck_asked(&self->nck, &asked);
    const int begins = !feeds(self);
    if (begins) self->began = self->wish;
    self->fed = self->moves.next;
    self->by_turns = move->per_rev;
    if (move->per_rev) {
        block->feed = feed_by_turns(self, move);
    } else if (move->cap > 0.0) {
        // with the override that is in force, or is wanted and will be, it is within its cap
        const double most = fmax(fmax(self->wanted, asked.feed_ppm), PPM);
        block->feed = fmin(block->feed, move->cap * PPM / most);
    }
    if (move->per_rev || move->cap > 0.0) self->bound = self->moves.next;
    move->given = fmax(move->given, block->feed);
    if (!begins) return;
    if (move->per_rev) self->turned = self->wish.feed * self->wish.rps / base_of(self, move);
    self->pace = planner_cycles(self, CALM);
    self->override = (trend_t){self->turned, self->turned};
    self->spins = (trend_t){self->wish.rps, self->wish.rps};
    const uint32_t end = moves_on(&self->moves, self->moves.next);
    nck_set_override(&self->nck, override_of(self, end), asked.rapid_ppm);
}
