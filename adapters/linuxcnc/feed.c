// SPDX-License-Identifier: MIT
// From the ring of moves into the kernel.
#include "feed.h"

#include <math.h>   // fabs fmax fmin sqrt
#include <stdio.h>  // snprintf
#include <string.h> // memcpy

#include "rates.h" // rates_wait rates_bound

enum {
    PATIENCE_AT_REST = 10, // [ms] without a move until what is there counts as all
    WAIT_AT_REST = 30,     // [ms] that the kernel may wait there for a whole window, …
    WAIT_FOR_CURVE = 400,  // … of a curve, whose next window is long in the making
    PATIENCE = 40,         // the same while the tool moves, and is near the end of what is known
    PATIENCE_FAR = 100,    // the same wherever it is: chords may be known and not be a path yet
    WAY_UNDER_WAY = 60,    // [ms] at full speed that a plan takes to be made, at most
    PLAN = 8000,           // [1000 instructions] of a plan along a curve
    PARTS = 10,            // the kernel tells hundreds of instructions
    BRAKE = 60,            // [1000 instructions] a tick of more brakes, or sets off, by itself
    BESIDE_BRAKE = 8       // of a step beside it
};

// Limits further out than the kernel takes are none.
static double within(uint32_t quantity, double value) {
    nck_range_t range;
    nck_machine_range(quantity, &range);
    return fmin(fmax(value, range.low), range.high);
}

void feed_bounds(const planner_t *self, bounds_t *bounds) {
    for (int k = 0; k < MOVES_AXES; k++) {
        const double scale = settings_scale(&self->settings, k);
        const double v = self->hooks.v_max(k) * scale;
        const double a = self->hooks.a_max(k) * scale;
        bounds->v[k] = v > 0.0 ? v : self->settings.v_max[k];
        bounds->a[k] = a > 0.0 ? a : self->settings.a_max[k];
    }
    bounds->a_path = self->a_path;
}

// Without a limit an axis turns all of its acceleration round within a cycle.
static double jerk_of(const planner_t *self, const bounds_t *bounds, int axis) {
    const double turn = 2.0 * bounds->a[axis] / self->cycle_s;
    return bounds->j[axis] > 0.0 ? bounds->j[axis] : turn;
}

void feed_machine(const planner_t *self, const bounds_t *bounds, nck_machine_t *machine_out) {
    nck_machine_t *const machine = machine_out;
    double j_most = 1.0;
    double v_most = 1.0;
    double a_most = 1.0;
    nck_machine_default(machine);
    machine->period_s = self->cycle_s;
    machine->slope = self->settings.slope;
    machine->path.tolerance = self->settings.tolerance;
    for (int k = 0; k < MOVES_AXES; k++) {
        nck_axis_t *const axis = &machine->axis[k];
        axis->present = (uint8_t)(self->settings.axes >> k & 1u);
        if (!axis->present) continue;
        axis->v_max = within(NCK_QUANTITY_SPEED, bounds->v[k]);
        axis->a_max = within(NCK_QUANTITY_ACCELERATION, bounds->a[k] * bounds->a_share);
        axis->rapid = within(NCK_QUANTITY_SPEED, bounds->v[k] * bounds->v_share);
        axis->j_max = within(NCK_QUANTITY_JERK, jerk_of(self, bounds, k));
        v_most += axis->v_max;
        a_most += axis->a_max;
        j_most += axis->j_max;
    }
    machine->path.feed_max = within(NCK_QUANTITY_SPEED, v_most); // the host's own limit is a wish
    machine->path.a_max =
        within(NCK_QUANTITY_ACCELERATION, bounds->a_path > 0.0 ? bounds->a_path : a_most);
    machine->path.j_max = within(NCK_QUANTITY_JERK, j_most);
    machine->own_m_count = 2;
    machine->own_m[0].code = MOVES_M_PASS;
    machine->own_m[1].code = MOVES_M_WAIT;
    machine->own_m[1].waits = 1;
}

void feed_before(const move_t *move, bounds_t *bounds_out) {
    memcpy(bounds_out->j, move->before, sizeof bounds_out->j);
    bounds_out->a_share = move->before[MOVES_AXES];
    bounds_out->v_share = move->before[MOVES_AXES + 1];
}

int feed_limits(planner_t *self, bounds_t *bounds) {
    nck_machine_t machine;
    feed_bounds(self, bounds);
    feed_machine(self, bounds, &machine);
    if (nck_set_limits(&self->nck, &machine) == NCK_FULL) return 0;
    self->bounds = *bounds;
    self->machine = machine;
    return 1;
}

// What follows has the limits of now. 0: not yet, what is before it has to be planned.
static int set_limits(planner_t *self) {
    const move_t *const move = moves_at(&self->moves, self->moves.next);
    bounds_t bounds = {.a_share = move->a_share, .v_share = move->v_share};
    memcpy(bounds.j, move->start, sizeof bounds.j);
    if (self->moves.back) feed_before(move, &bounds);
    return feed_limits(self, &bounds);
}

// A word that has been said, or is not to be: none is on the way back.
static int is_quiet(const planner_t *self) {
    const move_t *const move = moves_at((moves_t *)&self->moves, self->moves.next);
    const int word = move->kind >= MOVE_DIGITAL && move->kind < MOVE_LIMITS;
    return word && (self->moves.back || move->said);
}

// What the kernel has is executed to its end: the spindle leads then. Returns 1 for a flush.
static int finish(planner_t *self) {
    if (self->flushed == self->moves.next) return 0;
    nck_flush(&self->nck);
    self->flushed = self->moves.next;
    return 1;
}

// What any move of the machine may have: the most speed, the least acceleration and jerk.
typedef struct extremes {
    double v, a, j; // [mm/s, mm/s², mm/s³]
} extremes_t;

static extremes_t extremes_of(const planner_t *self) {
    extremes_t found = {0.0, 1e12, 1e12};
    for (int k = 0; k < MOVES_AXES; k++) {
        const nck_axis_t *const axis = &self->machine.axis[k];
        if (!axis->present) continue;
        found.v = fmax(found.v, axis->v_max);
        found.a = fmin(found.a, axis->a_max);
        found.j = fmin(found.j, axis->j_max);
    }
    return found;
}

static void push_block(planner_t *self) {
    moves_t *const moves = &self->moves;
    const uint32_t name = moves->next;
    nck_block_in_t block;
    rates_part(self);
    const int last = moves_block(moves, self->offset, &block);
    rates_bound(self, &block);
    const nck_status_t status = nck_push_block(&self->nck, &block);
    if (status == NCK_FULL) return;
    if (status != NCK_OK) self->failed = 1;
    moves->part = last ? 0 : moves->part + 1;
    moves->from = last ? 0.0 : moves->to;
    if (last) moves->next = moves_on(moves, name);
    if (last && moves_at(moves, name)->kind <= MOVE_CHORDS) moves->anew = 0;
    self->flushed = moves->back ? moves->next + 1 : moves->next - 1; // where it has been
    self->empty = 0;
}

// Returns 1 if there is work for prep.
static int push(planner_t *self) {
    moves_t *const moves = &self->moves;
    const move_t *const move = moves_at(moves, moves->next);
    const int limits = move->kind == MOVE_LIMITS;
    const int follows = self->state == PLANNER_FOLLOWS;
    if (follows && (limits || move->per_rev)) return 0;
    if (!follows) self->spindle = move->spindle;
    if (move->kind >= MOVE_THREAD || rates_wait(self)) return finish(self);
    if (limits ? set_limits(self) : is_quiet(self)) moves->next = moves_on(moves, moves->next);
    else if (!limits) push_block(self);
    return 1;
}

// More way is known than a brake takes and a plan to make: more may still come in time.
static int is_far(const planner_t *self) {
    nck_queue_t queue;
    if (!(self->told.v > 0.0)) return 0;
    const extremes_t most = extremes_of(self);
    nck_queue(&self->nck, &queue);
    const uint32_t held = queue.smooth + 1; // their ends are not planned
    const uint32_t ends = self->moves.back ? self->moves.next + held : self->moves.next - held;
    const move_t *const known = moves_at((moves_t *)&self->moves, ends);
    const double brake = 0.5 * most.v * (most.v / most.a + most.a / most.j);
    return fabs(known->way - self->at) > brake + WAY_UNDER_WAY * 1e-3 * most.v;
}

// Nothing more has come for a while: what is there is all, as far as anybody knows.
static int flush(planner_t *self) {
    const uint32_t near = self->told.v > 0.0 ? PATIENCE : PATIENCE_AT_REST;
    const uint32_t patience = self->state == PLANNER_FOLLOWS ? PATIENCE_FAR : near;
    if (self->flushed == self->moves.next || self->quiet < planner_cycles(self, patience)) return 0;
    if (self->quiet < planner_cycles(self, PATIENCE_FAR) && is_far(self)) return 0;
    nck_flush(&self->nck);
    self->flushed = self->moves.next;
    return 1;
}

static void fail(planner_t *self) {
    char text[128];
    nck_diagnostic_t found;
    while (nck_diagnostic(&self->nck, &found) == NCK_OK) {
        if (found.code >= NCK_OK) continue;
        (void)snprintf(text, sizeof text, "move %d: %s",
                       (int)moves_at(&self->moves, found.line)->id, nck_diagnostic_id(found.code));
        self->hooks.message(text);
    }
    self->failed = 1;
}

// What the kernel was given last is planned as a curve.
static int is_curve(const planner_t *self) {
    const move_t *const last = moves_at((moves_t *)&self->moves, self->moves.next - 1);
    return self->settings.slope == NCK_SLOPE_OPTIMAL && last->path_mode == NCK_PATH_CONTINUOUS;
}

// Nothing more is there, and the path is not to end here: plan with what is known, in time.
static void hurry(planner_t *self) {
    const int moves = self->told.v > 0.0;
    const uint32_t wait = is_curve(self) ? WAIT_FOR_CURVE : WAIT_AT_REST;
    if (self->state == PLANNER_FOLLOWS) return;
    self->idle = moves ? 0 : self->idle + 1;
    if (!moves && self->idle <= planner_cycles(self, wait)) return;
    nck_hurry(&self->nck, planner_cycles(self, WAY_UNDER_WAY));
}

// How long the next window of a curve is in the making, and the plan along it [cycles]: as long as
// the last one. The first one has no clock to begin with, and tells little: twice as long.
static double next_window(planner_t *self, double known, int works) {
    const uint32_t grows = known > self->known;
    self->making += (uint32_t)works;
    if (grows && !self->grows) {
        self->took = self->windows > 0 ? self->making : 2 * self->making;
        self->windows++;
        self->making = 0;
    }
    self->known = known;
    self->grows = grows;
    return self->took + PLAN / (double)self->budget;
}

// The kernel rests, and what is known of the curve lasts: before it brakes for the end of that, the
// next window is there. So it sets off. works: it has not waited for moves in this cycle.
static void set_off(planner_t *self, int works) {
    double v;
    const double known = nck_known_s(&self->nck, &v);
    const double next = self->cycle_s * next_window(self, known, works);
    if (!(known > 0.0) || self->grows) return;
    const extremes_t most = extremes_of(self);
    const double a = fmin(most.a, sqrt(v * most.j));
    const double brake = v > 0.0 ? v / a + a / most.j : 0.0;
    if (known > brake + next) nck_hurry(&self->nck, 1);
}

// The kernel needs input.
static int give(planner_t *self) {
    if (!moves_has_next(&self->moves)) return flush(self);
    return push(self);
}

int feed_is_done(const planner_t *self) {
    nck_queue_t queue;
    if (!self->empty) return 0;
    nck_queue(&self->nck, &queue);
    return queue.segs == 0 && queue.outputs == 0 && nck_is_idle(&self->nck);
}

int feed_is_over(const planner_t *self) {
    return !self->moves.back && self->moves.next == self->moves.head && feed_is_done(self);
}

// A step of preparation. Returns 1 if there is more to do.
static int step(planner_t *self) {
    const nck_status_t status = nck_prep(&self->nck);
    if (status == NCK_OK) return 1;
    self->empty = status == NCK_EMPTY && self->flushed == self->moves.next;
    if (status == NCK_EMPTY && !self->failed && give(self)) return 1;
    if (status == NCK_EMPTY) hurry(self);
    if (status < NCK_OK) fail(self);
    return 0;
}

// Steps for what the budget leaves beside what is done already [100 instructions]. Returns 1 if
// there is more to do.
static int spend(planner_t *self, uint32_t done) {
    const uint32_t most = PARTS * self->budget;
    uint32_t price = nck_price(&self->nck);
    // A step each cycle, whatever it takes; beside a brake of more than the budget a small one.
    int more = done <= most || done <= PARTS * BRAKE || price <= PARTS * BESIDE_BRAKE;
    while (more) {
        done += price;
        more = step(self);
        price = nck_price(&self->nck);
        if (done + price > most) break;
    }
    self->told.work = done / PARTS;
    return more;
}

void feed_prepare(planner_t *self) {
    const int more = spend(self, nck_tick_price(&self->nck));
    if (!(self->told.v > 0.0)) set_off(self, more);
    else self->making = 0;
    if (more && self->told.v > 0.0) hurry(self); // a plan of less than its window comes in time
}

void feed_ahead(planner_t *self) {
    double v;
    const int more = spend(self, follow_price(&self->follow));
    (void)next_window(self, nck_known_s(&self->nck, &v), more);
}
