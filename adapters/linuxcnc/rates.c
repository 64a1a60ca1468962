// SPDX-License-Identifier: MIT
// How fast: overrides, caps, feeds a revolution.
#include "rates.h"

#include <math.h> // fabs floor fmax fmin HUGE_VAL

#include "feed.h" // feed_is_done

enum {
    PPM = 1000000,
    CALM = 20,      // cycles between two overrides: each is a plan of its own, …
    PATIENCE = 200, // … and one that is being made is waited for, so long at most
    TREND = 32,     // cycles of the faster of two means of the spindle's speed; the other: twice
    LATE = 60       // cycles until the tool has the speed that an override asks for, seen
};

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

// How fast the spindle will turn when the tool has heard of it: where it gets faster or slower, by
// the difference of two means of its speed; not beyond what it is told to turn.
static double foreseen(planner_t *self, const planner_wish_t *wish) {
    const double now = wish->rps, most = wish->rps_most;
    const int follows = wish->rps_asked < most; // G96: what it is told changes all the while
    self->fast += (now - self->fast) / TREND;
    self->slow += (now - self->slow) / (2 * TREND);
    const double then = now + (self->fast - self->slow) * ((double)LATE / TREND);
    if (then > now && now < most) return fmin(then, most);
    return then < now && (follows || now > most) ? fmax(then, follows ? 0.0 : most) : now;
}

void rates_measure(planner_t *self, const planner_wish_t *wish) {
    self->rps = fmax(wish->rps, wish->rps_asked);
    self->wanted = ppm(wish->feed, 2.0);
    self->turned = wish->feed * foreseen(self, wish);
    if (self->done) self->calm = PATIENCE;
}

// ---- what the kernel's override has to be

// The move in work, or the first one that will be.
static uint32_t current(const planner_t *self) {
    return (int32_t)(self->told.move - self->first) >= 0 ? self->told.move : self->first;
}

// The speed that a move is to have [mm/min].
static double asked_of(const planner_t *self, const move_t *move) {
    const double most = move->cap > 0.0 ? move->cap : HUGE_VAL;
    return fmin(move->feed * (move->per_rev ? self->turned : (double)self->wanted / PPM), most);
}

// With it no move that the kernel has is faster than its cap, or than the host wants [ppm].
static uint32_t override_of(const planner_t *self, uint32_t end) {
    double least = HUGE_VAL;
    for (uint32_t n = current(self); n != end; n++) {
        const move_t *const move = moves_at((moves_t *)&self->moves, n);
        if (move->given > 0.0) least = fmin(least, asked_of(self, move) / move->given);
    }
    return least < HUGE_VAL ? ppm(least, 2.0) : self->wanted;
}

// A move ahead of the tool has a cap, or a feed a revolution, and the kernel has it.
static int is_bound(const planner_t *self) {
    return (int32_t)(self->bound - current(self)) >= 0;
}

static int is_same(const planner_t *self, uint32_t one, uint32_t other) {
    const double off = fabs((double)one - (double)other);
    return off <= (self->base > 0.0 && is_bound(self) ? fine * (double)other : 0.0);
}

// A change is heard at once if it comes to rest or leaves it.
void rates_hear(planner_t *self, const planner_wish_t *wish) {
    nck_command_t asked;
    const uint32_t rapid = ppm(wish->rapid, 1.0);
    const uint32_t speed = speed_um_s(self, wish->v_most);
    const int bound = is_bound(self);
    nck_asked(&self->nck, &asked);
    const int stands = self->base > 0.0 && bound ? self->turned <= 0.0 : self->wanted == 0;
    const int rests = (asked.feed_ppm == 0) != stands || (asked.rapid_ppm == 0) != (rapid == 0);
    self->calm++;
    const uint32_t calm = nck_is_answering(&self->nck) ? PATIENCE : CALM;
    if (!rests && self->calm < calm) return;
    const uint32_t end = self->moves.next + (self->moves.part > 0);
    const uint32_t feed = bound ? override_of(self, end) : self->wanted;
    const int same = is_same(self, asked.feed_ppm, feed) && asked.rapid_ppm == rapid
                     && asked.speed_um_s == speed && (asked.feed_ppm == 0) == (feed == 0);
    if (!same || bound) self->calm = 0;
    if (same) return;
    nck_set_override_ppm(&self->nck, feed, rapid);
    nck_set_speed(&self->nck, speed);
}

// ---- moves on their way to the kernel

static int has_feed(const move_t *move) { return move->kind <= MOVE_CHORDS && move->feed > 0.0; }

int rates_wait(const planner_t *self) {
    const move_t *const move = moves_at((moves_t *)&self->moves, self->moves.next);
    if (!has_feed(move) || move->per_rev == (self->base > 0.0)) return 0;
    return !feed_is_done(self);
}

// How fast the spindle may turn while the kernel has moves with a feed a revolution: an override
// goes up to twice that, and down with ease. Where nobody tells how fast, it is the axes' speed
// that ends it.
static double base_of(const planner_t *self, const planner_wish_t *wish, const move_t *move) {
    const double axes = 60.0 * bounds_along(self->bounds.v, move) / move->feed;
    const double told = fmax(wish->rps_most, wish->rps);
    return told > 0.0 ? fmin(told, axes) : axes;
}

void rates_bound(planner_t *self, nck_block_in_t *block) {
    move_t *const move = moves_at(&self->moves, self->moves.next);
    nck_command_t asked;
    if (!has_feed(move)) return;
    nck_asked(&self->nck, &asked);
    const int first = move->per_rev != (self->base > 0.0);
    if (move->per_rev && (first || feed_is_done(self))) self->base = base_of(self, &self->wish, move);
    if (!move->per_rev) self->base = 0.0;
    if (move->per_rev) {
        block->feed = move->feed * self->base;
    } else if (move->cap > 0.0) {
        // with the override that is in force, or is wanted and will be, it is within its cap
        const double most = fmax(fmax(self->wanted, asked.feed_ppm), PPM);
        block->feed = fmin(block->feed, move->cap * PPM / most);
    }
    if (move->per_rev || move->cap > 0.0) self->bound = self->moves.next;
    move->given = fmax(move->given, block->feed);
    if (!first && !feed_is_done(self)) return;
    nck_set_override_ppm(&self->nck, override_of(self, self->moves.next + 1), asked.rapid_ppm);
}
