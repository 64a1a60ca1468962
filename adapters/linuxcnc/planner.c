// SPDX-License-Identifier: MIT
// Moves in, one place a cycle out: what a host's trajectory planner is asked for.
#include "planner.h"

#include <math.h>   // fabs fmax fmin sqrt
#include <string.h> // memcpy memset

#include "back.h"   // back_begin back_single
#include "feed.h"   // feed_prepare
#include "rates.h"  // rates_measure rates_hear rates_keep_behind
#include "thread.h" // thread_begins thread_cycle

// ---- to and from the kernel

static void on_output(void *user, const nck_output_t *output) {
    planner_t *const self = user;
    move_t *const move = moves_at(&self->moves, output->line);
    if (self->state != PLANNER_READY) return;
    if (move->kind == MOVE_DIGITAL || move->kind == MOVE_ANALOG) move->said = 1;
    if (move->kind == MOVE_DIGITAL) self->hooks.digital(move->index, (char)(move->value > 0.0));
    if (move->kind == MOVE_ANALOG) self->hooks.analog(move->index, move->value);
}

// The host's place stays what it is, whatever the kernel's is.
static void keep_place(planner_t *self) {
    nck_pose_t pose;
    nck_axes_t axes;
    (void)nck_position(&self->nck, &pose, &axes);
    for (int k = 0; k < MOVES_AXES; k++) self->offset[k] = self->told.place[k] - pose.axis[k];
}

// What is in the ring now is all behind the tool.
static void forget(planner_t *self) {
    moves_clear(&self->moves);
    self->flushed = self->moves.next;
    self->first = self->moves.head;
    self->passed = self->count;
    self->empty = 1;
    self->making = self->took = self->windows = 0;
    self->bounds_asked = self->bounds;
    self->told.between = 0;
    self->moved = 0;
    memcpy(self->goal, self->told.place, sizeof self->goal);
}

int planner_init(planner_t *self, const settings_t *settings, const planner_hooks_t *hooks,
                 double cycle_s) {
    const nck_hooks_t listens = {self, on_output, NULL, NULL};
    const double a_path = self->a_path;
    const planner_modal_t modal = self->modal;
    const moves_travel_t travel = self->travel;
    nck_range_t range;
    nck_machine_range(NCK_QUANTITY_PERIOD, &range);
    self->cycle_s = 0.0;
    if (!(cycle_s >= range.low && cycle_s <= range.high)) return 0;
    memset(self, 0, sizeof *self);
    self->settings = *settings;
    self->hooks = *hooks;
    self->cycle_s = cycle_s;
    self->budget = (uint32_t)fmax(SETTINGS_BUDGET * cycle_s * 1e3, 1.0);
    if (settings->budget > 0) self->budget = settings->budget;
    self->a_path = a_path;
    self->modal = modal;
    self->travel = travel;
    self->moves.head = 1; // 0 is no move to the kernel
    self->moves.axes = settings->axes;
    self->done = 1;
    self->bounds.a_share = self->bounds.v_share = 1.0;
    memcpy(self->bounds.j, settings->jerk, sizeof self->bounds.j);
    feed_bounds(self, &self->bounds);
    feed_machine(self, &self->bounds, &self->machine);
    if (nck_init(&self->nck, &self->machine, &listens) != NCK_OK) {
        self->cycle_s = 0.0;
        return 0;
    }
    forget(self);
    return 1;
}

// An abort has come to rest: the kernel begins anew there.
static void begin_anew(planner_t *self) {
    nck_pose_t pose;
    nck_axes_t axes;
    if (nck_begin(&self->nck) != NCK_OK) return;
    (void)nck_tick(&self->nck, &pose, &axes); // it lets go of what was planned
    keep_place(self);
    self->state = PLANNER_READY;
    self->holds = 0;
    self->waits = 0;
    self->at = 0.0;
    self->skipped = 0.0;
    self->done = self->moves.next == self->moves.head;
}

static void stop(planner_t *self, planner_state_t state) {
    nck_abort(&self->nck);
    self->state = state;
}

// ---- moves in

static int can_add(const planner_t *self, uint32_t entries) {
    const moves_t *const moves = &self->moves;
    return self->cycle_s > 0.0 && !self->failed && self->state != PLANNER_STOPS
           && moves->head - moves->tail + entries <= MOVES_MAX;
}

// What the host has told of a move. A cycle under G64 rests where it turns: axes keep their jerk.
static void fill(const planner_t *self, const planner_order_t *order, move_t *move) {
    memset(move, 0, sizeof *move);
    move->id = self->modal.id;
    move->path_mode = (uint8_t)self->modal.path_mode;
    if (order->blends && move->path_mode == NCK_PATH_EXACT) move->path_mode = NCK_PATH_TURNS;
    move->tolerance = self->modal.tolerance > 0.0 ? self->modal.tolerance
                                                  : self->settings.tolerance;
    move->count = self->count + 1;
    move->way = self->way;
    memcpy(move->end, self->goal, sizeof move->end);
    move->motion = order->motion;
    move->enables = order->enables;
    move->vel = order->vel;
    move->spindle = (uint8_t)self->modal.spindle;
}

static void put_word(planner_t *self, const planner_order_t *order, move_kind_t kind, int index) {
    move_t *const move = moves_at(&self->moves, self->moves.head++);
    fill(self, order, move);
    move->kind = (uint8_t)kind;
    move->index = index;
}

int planner_output(planner_t *self, int analog, int index, double value) {
    uint32_t n = 0;
    const planner_output_t output = {index, (uint32_t)analog, value};
    while (n < self->outputs
           && (self->output[n].index != index || self->output[n].analog != (uint32_t)analog)) {
        n++;
    }
    if (n == PLANNER_OUTPUTS) return -1;
    self->output[n] = output;
    if (n == self->outputs) self->outputs++;
    return 1;
}

static void put_before(planner_t *self, const planner_order_t *order) {
    if (order->at_speed) put_word(self, order, MOVE_AT_SPEED, 0);
    if (order->indexer >= 0) put_word(self, order, MOVE_UNLOCK, order->indexer);
    for (uint32_t n = 0; n < self->outputs; n++) {
        const planner_output_t *const output = &self->output[n];
        put_word(self, order, output->analog ? MOVE_ANALOG : MOVE_DIGITAL, output->index);
        moves_at(&self->moves, self->moves.head - 1)->value = output->value;
    }
    self->outputs = 0;
}

// An axis in whose units the speed of a move is told.
static int unit_of(const planner_t *self, const double *end) {
    int linear = 0;
    for (int k = 0; k < MOVES_AXES; k++) {
        const int rotary = k >= NCK_AXIS_A && k <= NCK_AXIS_C;
        linear |= !rotary && end[k] != self->goal[k];
    }
    return linear ? NCK_AXIS_X : NCK_AXIS_A;
}

// Geometry of a move, as the host tells it.
typedef struct shape {
    const double *end;
    const double *centre, *normal; // NULL: straight
    int turn;
    double back;                   // of a tap; 0: none
} shape_t;

// In step with the spindle, whatever speed the host tells.
static int is_thread(const planner_t *self, const shape_t *shape) {
    return self->modal.lead > 0.0 && !self->modal.speed && !shape->centre;
}

static int is_per_rev(const planner_t *self, const planner_order_t *order) {
    return self->modal.lead > 0.0 && self->modal.speed && !order->rapid;
}

// Millimetres or degrees a minute that the move's speed is meant for.
static double feed_of(const planner_t *self, const planner_order_t *order, const double *end) {
    const double most = order->vel * settings_scale(&self->settings, unit_of(self, end)) * 60.0;
    if (order->rapid) return 0.0;
    return is_per_rev(self, order) ? self->modal.lead * 60.0 : most;
}

// Axes that the machine lacks stay where they are. Returns 0 for a place beyond all machines.
static int read_end(const planner_t *self, const double *end, double *end_out) {
    memcpy(end_out, self->goal, MOVES_AXES * sizeof *end_out);
    for (int k = 0; k < MOVES_AXES; k++) {
        if (!self->machine.axis[k].present) continue;
        if (!(fabs(end[k] - self->offset[k]) < (double)NCK_LINEAR_MAX_MM)) return 0;
        end_out[k] = end[k];
    }
    return 1;
}

// A move to a place, as far as itself goes. Returns its length, −1 if there is no such arc.
static double make(const planner_t *self, const planner_order_t *order, const shape_t *shape,
                   const double *place, move_t *move) {
    const double *const centre = shape->centre;
    fill(self, order, move);
    const double length = moves_straight(move, self->goal, place);
    move->kind = order->rapid ? MOVE_RAPID : MOVE_LINE;
    if (shape->back > 0.0) move->kind = MOVE_TAP;
    else if (is_thread(self, shape)) move->kind = MOVE_THREAD;
    move->value = self->modal.lead;
    move->back = shape->back;
    move->per_rev = (uint8_t)is_per_rev(self, order);
    move->feed = order->rapid ? 0.0 : feed_of(self, order, centre ? place : shape->end);
    return centre ? moves_round(move, centre, shape->normal, shape->turn) : length;
}

// Within its tolerance of the line the tool would leave the travel.
static int keep_within(const planner_t *self, const move_t *move) {
    const int within = move->path_mode == NCK_PATH_CONTINUOUS;
    return within && moves_reach(move, &self->travel, move->tolerance);
}

// What the host leaves the move of the axes' limits. A rapid has no speed but theirs.
static void put_bounds(planner_t *self, const planner_order_t *order, move_t *move) {
    const double scale = settings_scale(&self->settings, unit_of(self, move->end));
    const double v = order->rapid ? fmin(order->vel, order->v_most) : order->v_most;
    const bounds_most_t most = {v * scale, order->a_most * scale, order->j_most * scale};
    bounds_t bounds = self->bounds_asked;
    if (!self->settings.jerk_given) bounds_jerk(&bounds, &most, move);
    const int other_jerk = memcmp(bounds.j, self->bounds_asked.j, sizeof bounds.j) != 0;
    feed_bounds(self, &bounds);
    bounds_share(&bounds, &most, move);
    move->cap = 60.0 * bounds_cap(&bounds, &most, move);
    move->a_share = bounds.a_share;
    const int hears = move->kind < MOVE_THREAD || other_jerk;
    if (!hears || bounds_same(&bounds, &self->bounds_asked)) return;
    put_word(self, order, MOVE_LIMITS, 0);
    move_t *const limits = moves_at(&self->moves, self->moves.head - 1);
    limits->a_share = bounds.a_share;
    limits->v_share = bounds.v_share;
    memcpy(limits->start, bounds.j, sizeof bounds.j);
    memcpy(limits->before, self->bounds_asked.j, sizeof bounds.j);
    limits->before[MOVES_AXES] = self->bounds_asked.a_share;
    limits->before[MOVES_AXES + 1] = self->bounds_asked.v_share;
    self->bounds_asked = bounds;
}

// To half of what the kernel counts by: a place is known to that once the tool rests there.
static int is_same(const double *place, const double *goal) {
    static const double rounding = 0.5e-6; // [mm, deg]
    int same = 1;
    for (int k = 0; k < MOVES_AXES; k++) same &= fabs(place[k] - goal[k]) <= rounding;
    return same;
}

// Whether a move has a speed, and where it ends.
static int is_good(planner_t *self, const planner_order_t *order, const shape_t *shape,
                   double *place_out) {
    const int led = shape->back > 0.0 || is_thread(self, shape);
    return read_end(self, shape->end, place_out)
           && (led ? fabs(order->vel) < HUGE_VAL : order->vel > 0.0);
}

// A move, and what comes before it; its end is the goal then.
static int add(planner_t *self, const planner_order_t *order, const shape_t *shape) {
    move_t move;
    double place[MOVES_AXES];
    if (!can_add(self, 5 + PLANNER_OUTPUTS)) return -1;
    if (!is_good(self, order, shape, place)) return -2;
    if (!shape->centre && is_same(place, self->goal)) return 0;
    const double length = make(self, order, shape, place, &move);
    if (length < 0.0) return -2;
    if (shape->centre && moves_reach(&move, &self->travel, -1e-6)) return -3;
    if (keep_within(self, &move)) move.path_mode = NCK_PATH_TURNS;
    put_bounds(self, order, &move);
    put_before(self, order);
    self->way += length;
    move.way = self->way;
    move.length = length;
    *moves_at(&self->moves, self->moves.head++) = move;
    if (!(shape->back > 0.0)) memcpy(self->goal, place, sizeof self->goal);
    if (order->indexer >= 0) put_word(self, order, MOVE_LOCK, order->indexer);
    self->count++;
    self->quiet = 0;
    self->done = 0;
    return 1;
}

int planner_line(planner_t *self, const planner_order_t *order, const double *end) {
    const shape_t shape = {end, NULL, NULL, 0, 0.0};
    return add(self, order, &shape);
}

int planner_tap(planner_t *self, const planner_order_t *order, const double *end, double back) {
    if (!(self->modal.lead > 0.0) || !(back > 0.0)) return -2;
    const shape_t shape = {end, NULL, NULL, 0, back};
    return add(self, order, &shape);
}

int planner_arc(planner_t *self, const planner_order_t *order, const double *end,
                const double *centre, const double *normal, int turn) {
    const shape_t shape = {end, centre, normal, turn, 0.0};
    return add(self, order, &shape);
}

// ---- the operator

void planner_pause(planner_t *self, int pause) { self->paused = (uint32_t)pause; }

void planner_abort(planner_t *self) {
    self->failed = 0;
    self->outputs = 0;
    self->reversed = 0;
    if (self->state == PLANNER_FOLLOWS) thread_stop(self);
    if (self->done || (self->state != PLANNER_READY && self->state != PLANNER_TURNS)) return;
    stop(self, PLANNER_STOPS);
}

void planner_put(planner_t *self, const double *place) {
    const int follows = self->state == PLANNER_FOLLOWS;
    const int led = follows && feed_is_done(self);
    const int rests = led || (self->done && self->state == PLANNER_READY);
    if (follows) self->state = PLANNER_READY;
    memcpy(self->told.place, place, sizeof self->told.place);
    forget(self);
    self->failed = 0;
    self->outputs = 0;
    self->paused = 0;
    self->reversed = 0;
    self->done = 1;
    if (rests) {
        keep_place(self);
    } else {
        self->way = 0.0;
        stop(self, PLANNER_HIDES);
    }
}

int planner_depth(const planner_t *self) {
    return self->done ? 0 : (int)(self->count - self->passed);
}

// What the tool rests for is there.
static int wait_is_over(planner_t *self, const move_t *move) {
    const int unlock = move->kind == MOVE_UNLOCK;
    if (move->kind == MOVE_AT_SPEED) return self->hooks.at_speed();
    if (!self->waits) self->hooks.set_unlock(move->index, unlock);
    self->waits = 1;
    return !self->hooks.is_unlocked(move->index) == !unlock;
}

// Going on ends a wait too, so it is asked for where both are over.
static void hear_holds(planner_t *self, const planner_wish_t *wish) {
    nck_pose_t pose;
    nck_axes_t axes;
    const int waits = nck_position(&self->nck, &pose, &axes) == NCK_TICK_WAIT;
    if (back_single(self, wish->single != 0)) return;
    if (self->paused && !self->holds) {
        nck_hold(&self->nck);
        self->holds = 1;
    }
    if (self->paused) return;
    move_t *const move = moves_at(&self->moves, pose.line);
    if (waits && !wait_is_over(self, move)) return;
    if (waits) move->said = 1;
    if (waits || self->holds || self->owed) {
        nck_resume(&self->nck);
        self->moved = 0;
    }
    self->owed = 0;
    if (waits) self->waits = 0;
    self->holds = 0;
}

// ---- a cycle

// Of X Y Z if any moves, else of U V W, else of A B C.
static double speed(const double *from, const double *to, double cycle_s) {
    static const int first[] = {NCK_AXIS_X, NCK_AXIS_U, NCK_AXIS_A};
    double sum = 0.0;
    for (int group = 0; group < 3 && sum == 0.0; group++) {
        for (int k = first[group]; k < first[group] + 3; k++) {
            sum += (to[k] - from[k]) * (to[k] - from[k]);
        }
    }
    return sqrt(sum) / cycle_s;
}

static void tell_place(planner_t *self, const double *place) {
    planner_told_t *const told = &self->told;
    const double v = speed(told->place, place, self->cycle_s);
    const double a = (v - told->v) / self->cycle_s;
    told->j = (a - told->a) / self->cycle_s;
    for (int k = 0; k < 3; k++) {
        told->along[k] = v > 0.0 ? (place[k] - told->place[k]) / (v * self->cycle_s) : 0.0;
    }
    told->a = a;
    told->v = v;
    memcpy(told->place, place, sizeof told->place);
}

static void tell_motion(planner_t *self, const nck_pose_t *pose) {
    double place[MOVES_AXES];
    for (int k = 0; k < MOVES_AXES; k++) place[k] = pose->axis[k] + self->offset[k];
    tell_place(self, place);
    self->told.limit = pose->limit;
}

// Whether it rests between two moves, where single steps end.
static void tell_between(planner_t *self, const nck_pose_t *pose, const move_t *move, int single) {
    if (self->told.v > 0.0) {
        self->moved = 1;
        self->told.between = 0;
    } else if (single && self->moved && !self->paused && pose->state == NCK_TICK_HOLD) {
        self->told.between = (uint32_t)moves_is_over(&self->moves, move, self->told.place);
        self->owed = !self->told.between; // it rests until it is let go on, between chords it is
    }
}

static void tell_move(planner_t *self, const nck_pose_t *pose, int single) {
    planner_told_t *const told = &self->told;
    const int known = pose->line && moves_ahead(&self->moves, pose->line, self->first) >= 0;
    told->move = known ? pose->line : self->first;
    const move_t *const move = moves_at(&self->moves, told->move);
    tell_between(self, pose, move, single);
    self->at = self->skipped + (self->moves.back ? -pose->s : pose->s);
    told->to_go = fmax(0.0, move->way - self->at);
    if (!single && self->moved && rates_keep_behind(self)) told->between = 1;
    for (int k = 0; k < MOVES_AXES; k++) told->dtg[k] = move->end[k] - told->place[k];
    if (self->state == PLANNER_READY) self->passed = move->count - 1;
    if (known && self->state == PLANNER_READY) moves_pass(&self->moves, pose->line);
}

static void tell_rest(planner_t *self) {
    forget(self);
    self->way = self->at;
    self->done = 1;
    self->paused = 0;
    self->reversed = 0;
    self->told.to_go = 0.0;
    memset(self->told.dtg, 0, sizeof self->told.dtg);
}

// A cycle in which the spindle leads.
static void follow(planner_t *self, const planner_wish_t *wish) {
    double place[MOVES_AXES];
    const int goes_on = thread_cycle(self, wish, place);
    tell_place(self, place);
    thread_tell(self);
    if (self->closed && !self->dropped) feed_ahead(self);
    if (goes_on) return;
    self->state = PLANNER_READY;
    thread_end(self);
    keep_place(self);
    if (self->dropped && !feed_is_done(self)) stop(self, PLANNER_STOPS);
    else if (self->dropped || feed_is_over(self)) tell_rest(self);
}

static void end_stop(planner_t *self) {
    const uint32_t state = self->state;
    const double at = self->at;
    if (!nck_is_idle(&self->nck)) return;
    begin_anew(self);
    if (self->state != PLANNER_READY) return;
    if (state == PLANNER_STOPS) tell_rest(self);
    if (state == PLANNER_TURNS) back_begin(self, at);
}

void planner_cycle(planner_t *self, const planner_wish_t *wish) {
    nck_pose_t pose;
    nck_axes_t axes;
    rates_measure(self, wish);
    if (self->done && self->state == PLANNER_READY) {
        self->told.v = self->told.a = self->told.j = 0.0;
        self->paused = self->reversed = 0;
        self->told.work = 0;
        return;
    }
    self->quiet++;
    if (self->state == PLANNER_FOLLOWS) {
        follow(self, wish);
        return;
    }
    if (self->state == PLANNER_READY) {
        rates_hear(self, wish);
        hear_holds(self, wish);
    }
    feed_prepare(self);
    (void)nck_tick(&self->nck, &pose, &axes);
    if (self->state != PLANNER_HIDES) {
        tell_motion(self, &pose);
        tell_move(self, &pose, wish->single);
    }
    if (self->state != PLANNER_READY) end_stop(self);
    else if (thread_begins(self)) thread_begin(self);
    else if (feed_is_over(self)) tell_rest(self);
    else if (self->failed && nck_is_idle(&self->nck)) stop(self, PLANNER_STOPS);
}
