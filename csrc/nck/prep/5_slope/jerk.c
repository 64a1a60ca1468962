// SPDX-License-Identifier: MIT
// Room 5, slope: the jerk-limited planner.
#include "nck/prep/5_slope/jerk.h"

#include <stddef.h> // offsetof
#include <string.h> // memset

#include "nck/base/real.h"                // nck_min nck_max
#include "nck/prep/5_slope/bounds.h"      // nck_bounds_…
#include "nck/prep/5_slope/brake.h"       // nck_brake_…
#include "nck/prep/5_slope/draw.h"        // nck_draw_cells
#include "nck/prep/5_slope/ladder_math.h" // nck_ladder_excess
#include "nck/prep/5_slope/window.h"      // nck_window_…

enum {
    PHASE_REACH = 0, PHASE_LOAD, PHASE_LAY, PHASE_LIMIT, PHASE_EASE, PHASE_BRAKE,
    PHASE_PLAN, PHASE_CHECK, PHASE_DRAW
};

// Of a plan's cells one in three becomes final before the next one takes over, and one in ten at
// least; and so many cells less than where it begins to brake for the window's end.
enum { COMMIT_SURE = 3, COMMIT_LEAST = 10, KEEP_OFF = 4 };
// More of them become final up to so many ramps before that braking: what is further away from the
// window's end than a ramp from full speed to rest is what it would be if more were known.
#define COMMIT_RAMPS 1.5

// The window is to see this many times the time that a ramp from full speed to rest takes.
#define RAMPS_SEEN 3.4
// From rest a ladder has this share of the cells, unless so many ramps take more.
enum { SHARE_AT_REST = 4 };
#define RAMPS_AT_REST 8.0
// Cells last half a period at least: finer ladders gain next to nothing (README).
#define STEP_LEAST 0.5
// At constant speed a cell lasts up to so many periods: a plan takes over at a cell's end only. But
// not where that is less than so many steps of the ladder: then the window is short, and sees
// further than what is done in time.
#define LONG_PERIODS 2.0
#define LONG_STEPS 3.0
// Room for rounding below every jerk limit.
#define JERK_MARGIN 1e-5
// A hold that cannot be met gets more length: so much of the share by which its speed is missed,
// and so much at least, …
#define REACH_SHARE 0.5
#define REACH_GROWTH 0.05
// … and after so many tries in vain it is to begin further on.
enum { TRIES_MOST = 4 };
// A hold is made anew so many times on one ladder.
#define REDONE_MOST 3

// What a ramp from full speed to rest takes [s]: no more acceleration is come to than √(v·j).
static double ramp_s(const nck_machine_t *machine) {
    const double v = machine->path.feed_max;
    const double j = machine->path.j_max;
    const double a = nck_min(machine->path.a_max, nck_sqrt(v * j));
    return v / a + a / j;
}

double nck_jerk_cell_s(const nck_machine_t *machine) {
    const double period = machine->period_s;
    const double ramp = ramp_s(machine);
    const double most = nck_max(1.0, 0.25 * (double)NCK_FILTER_TAPS) * period;
    return nck_max(STEP_LEAST * period,
                   nck_min(most, RAMPS_SEEN * ramp / (double)NCK_PROFILE_ROWS));
}

void nck_jerk_init(nck_jerk_t *self, const nck_machine_t *machine, nck_link_t *link,
                   const nck_plan_t *now, nck_plan_t *next) {
    if (!NCK_HAS_JERK) return;
    memset(self, 0, offsetof(nck_jerk_t, rung_piece)); // each plan lays its ladder anew
    self->machine = machine;
    self->link = link;
    self->now = now;
    self->next = next;
    self->step_s = nck_jerk_cell_s(machine);
    const double long_steps = LONG_PERIODS * machine->period_s / self->step_s;
    self->long_steps = long_steps < LONG_STEPS ? 1.0 : long_steps;
    self->hold_s = self->long_steps > 1.0 ? self->step_s : NCK_JERK_UNKNOWN;
    self->margin_s = COMMIT_RAMPS * ramp_s(machine);
    self->q_cap = NCK_LADDER_STRETCH * self->step_s;
    const double excess = nck_ladder_excess(self->q_cap, machine->period_s, NCK_FILTER_TAPS);
    self->j_scale = (1.0 - JERK_MARGIN) / (1.0 + excess);
    nck_profile_t *const p = &self->profile;
    p->h = self->h;
    p->vv_cap = self->vv_cap;
    p->a_max = self->a_max;
    p->j_max = self->j_max;
    p->vv = self->vv;
}

static void enter(nck_jerk_t *self, uint32_t phase) {
    self->work.phase = phase;
    self->work.i = 0;
    self->work.vv_cell = 0.0;
    self->work.planned_cell = 0;
    self->work.planned_at = 0.0;
    self->work.braked = 0.0;
    if (phase == PHASE_LIMIT) self->work.lowered = 0;
}

// The job from its start, whatever has been tried.
static void restart(nck_jerk_t *self) {
    nck_plan_t *const next = self->next;
    next->n = 0;
    next->complete = 0;
    next->held = NCK_HELD_NOT;
    next->keep = 0;
    next->commit = 0;
    memset(&self->work, 0, sizeof self->work);
    self->work.step = self->step_s;
    self->work.room = NCK_JERK_CELLS;
    self->work.over = next->over;
    self->work.piece = next->piece;
    self->work.s = next->s;
    self->work.far = NCK_JERK_UNKNOWN;
    self->profile.v = self->job.v;
    self->profile.a = self->job.a;
    self->profile.q = nck_min(self->job.q, self->q_cap); // on a coarse ladder, too: else none joins
}

// From rest every cell is planned twice, so that ladder is short, but long enough to be sure of
// most of it.
static uint32_t room_at_rest(const nck_jerk_t *self) {
    const double seen = RAMPS_AT_REST * ramp_s(self->machine) / self->step_s;
    const double least = (double)NCK_JERK_CELLS / (double)SHARE_AT_REST;
    return (uint32_t)nck_min((double)NCK_JERK_CELLS, nck_max(least, seen));
}

static void begin_at_rest(nck_jerk_t *self) {
    self->work.coarse = 1;
    self->work.room = room_at_rest(self);
    self->work.base = self->next->piece;
    self->work.pieces = NCK_JERK_PIECES / 2;
    enter(self, PHASE_LAY);
}

// A stop at a block's end is laid anew, because the cells of now may run past it.
static void begin_moving(nck_jerk_t *self) {
    const nck_wish_t *const wish = &self->job.wish;
    const int moves = wish->feed > 0.0 && wish->rapid > 0.0 && wish->tool > 0.0;
    const int anew = wish->single_block || !moves;
    self->work.base = self->now->first_piece;
    self->work.pieces = NCK_JERK_PIECES;
    self->work.vv_entry = self->job.v * self->job.v;
    self->work.source = self->next->begin;
    self->work.coarse = (uint32_t)anew | self->job.slower; // that ladder is for higher speeds
    self->work.anew = (uint32_t)anew;
    enter(self, anew ? PHASE_LAY : PHASE_LOAD);
}

static void begin_brake(nck_jerk_t *self, uint32_t held) {
    self->job.kind = NCK_JOB_BRAKE;
    self->job.held = held;
    begin_moving(self);
    self->next->held = held;
    enter(self, PHASE_REACH);
}

void nck_jerk_begin(nck_jerk_t *self, const nck_job_t *job) {
    if (!NCK_HAS_JERK) return;
    self->job = *job;
    restart(self);
    switch (job->kind) {
    case NCK_JOB_START: begin_at_rest(self); break;
    case NCK_JOB_GO_ON: begin_moving(self); break;
    default: begin_brake(self, job->held); break;
    }
}

// The ladder of now up to where the path is to rest; it was made for other speeds, so it is divided
// anew. An override of zero brakes, it is no cap.
static void begin_hold(nck_jerk_t *self, double reach) {
    if (!(self->job.wish.feed > 0.0)) self->job.wish.feed = 1.0;
    if (!(self->job.wish.rapid > 0.0)) self->job.wish.rapid = 1.0;
    if (!(self->job.wish.tool > 0.0)) self->job.wish.tool = NCK_WISH_FREE;
    self->work.reach = reach;
    self->work.piece = self->next->piece;
    self->work.coarse = 1;
    enter(self, PHASE_LOAD);
}

// Whether the plan of now runs past the place where the next one rests.
static int runs_past(const nck_jerk_t *self, const nck_pieces_t *pieces) {
    const nck_node_t *const behind = nck_plan_piece(pieces, self->next->end_piece);
    const int32_t further = (int32_t)(self->now->end_piece - self->next->end_piece);
    return further > 0 || (further == 0 && behind && self->now->end_s > behind->s);
}

// The way of a brake grows a little less than the speed that it is made from.
static double growth_of(const nck_jerk_t *self) {
    const double met = nck_sqrt(nck_max(self->vv[0], 1e-12));
    return nck_max(REACH_GROWTH, nck_min(1.0, REACH_SHARE * (self->profile.v / met - 1.0)));
}

// The plan does not join. A hold gets more length. Is the plan of now on its way past the place, it
// is too late to rest there: a stop at a block's end waits for a later block, an override of zero
// rests further on. If it rests there or before, it is as good.
// Else the ladder of now is taken over as it is: where short pieces share cells in another way,
// caps may differ. NCK_E_STATE if that does not help either.
static nck_status_t give_way(nck_jerk_t *self, const nck_pieces_t *pieces) {
    const double reach = self->work.reach;
    const double longer = reach * (1.0 + growth_of(self));
    const uint32_t tries = self->work.tries + 1;
    const uint32_t passes = self->work.passes + 1;
    const int is_past = self->next->complete && runs_past(self, pieces);
    const int must_rest = self->work.must_rest != 0;
    const int was_all = self->work.all != 0;
    const int single_block = self->job.wish.single_block != 0;
    self->job.slower = 0;
    restart(self);
    if (reach > 0.0) {
        begin_brake(self, self->job.held);
        if (tries == TRIES_MOST) return NCK_E_STATE;
        self->work.tries = tries;
        begin_hold(self, longer);
    } else if (is_past && must_rest) {
        begin_brake(self, NCK_HELD_OVERRIDE);
    } else if (single_block && passes < NCK_JERK_PIECES) {
        begin_moving(self);
        self->work.passes = is_past ? passes : NCK_JERK_PIECES;
        self->work.to_pass = self->work.passes;
    } else if (!was_all && !single_block) {
        begin_moving(self);
        self->work.all = 1;
    } else {
        return NCK_E_STATE;
    }
    return NCK_OK;
}

static nck_status_t finish_load(nck_jerk_t *self, const nck_pieces_t *pieces) {
    nck_plan_t *const next = self->next;
    if (self->work.from_built) {
        const int all = !nck_link_built_cell(self->link, self->work.i);
        if (!all && self->work.reach > 0.0) return NCK_FULL; // no room for a ladder to the rest
        if (!all) {
            next->complete = 0;
            next->held = NCK_HELD_NOT;
            next->end_piece = self->work.piece;
            next->end_s = self->work.s;
        }
        next->n = self->work.n;
        enter(self, PHASE_LIMIT);
        return NCK_OK;
    }
    if (!(self->work.reach > 0.0) && !nck_window_rests(self, pieces)) {
        enter(self, PHASE_LAY);
        return NCK_OK;
    }
    if (self->work.length < self->work.reach) return NCK_FULL; // it rests sooner than the hold
    next->complete = 1;
    next->n = self->work.n;
    next->end_piece = self->work.piece;
    next->end_s = self->work.s;
    enter(self, PHASE_LIMIT);
    return NCK_OK;
}

static int is_rest(const nck_jerk_t *self) {
    return self->work.n == 1 && !(self->h[0] > 0.0);
}

// Caps that fell are raised to a brake.
static void finish_limit(nck_jerk_t *self) {
    self->work.eases = self->job.kind == NCK_JOB_GO_ON && self->job.anew;
    enter(self, self->work.eases ? PHASE_EASE : PHASE_BRAKE);
}

// Nodes of the plan that are worth the best: none of one that only divides the ladder, nor of a
// hold, which is compared with its length. What is in the window's second half another plan
// follows. A short window has its processor busy enough.
static uint32_t worth_the_best(const nck_jerk_t *self) {
    const uint32_t n = self->work.n;
    const int is_short = !NCK_HAS_BEST || !(self->long_steps > 1.0);
    if (self->work.coarse || self->work.reach > 0.0 || is_short) return 0;
    return self->next->complete ? n : n / 2;
}

// The profile is worked out where its cells will be drawn.
static void begin_plan(nck_jerk_t *self) {
    nck_profile_t *const p = &self->profile;
    nck_link_spare_t *const spare = nck_link_spare(self->link);
    p->s = spare->ladder.number[0];
    p->up = spare->ladder.number[1];
    p->down = spare->ladder.number[2];
    p->e = spare->ladder.number[3];
    p->z = spare->ladder.number[4];
    p->j = spare->ladder.number[5];
    p->stack = spare->ladder.index;
    p->n = self->work.n;
    p->q_cap = nck_window_q_cap(self);
    p->count = worth_the_best(self);
    nck_profile_begin(p);
    enter(self, PHASE_PLAN);
}

static nck_status_t finish_plan(nck_jerk_t *self, const nck_pieces_t *pieces) {
    const int checks = !self->work.coarse || self->work.reach > 0.0;
    if (checks && !nck_profile_joins(&self->profile)) return give_way(self, pieces);
    enter(self, PHASE_CHECK);
    return NCK_OK;
}

// A hold that does not keep to what is left is made anew with what is left at the speeds that it
// had, on the same ladder.
static nck_status_t check(nck_jerk_t *self, const nck_pieces_t *pieces) {
    const nck_status_t status = nck_bounds_check(self, pieces);
    if (status == NCK_DONE) {
        nck_link_tail_begin(self->link);
        self->work.time = 0.0;
        self->work.keep_time = 0.0;
        self->work.sure = 0;
        self->work.sure_time = 0.0;
        self->work.brakes_long = 0;
        self->work.uneven = 0;
        enter(self, PHASE_DRAW);
    } else if (status == NCK_E_STATE) {
        if (self->work.redone == REDONE_MOST) return give_way(self, pieces);
        self->work.redone++;
        enter(self, PHASE_LIMIT);
    }
    return NCK_OK;
}

// Where the next plan takes over: a third on, or further where the window's end does not matter,
// but not where this one already brakes for that end, if that leaves something. The window keeps
// the pieces of the plan of now, so a plan over many of them stays with a third: else the next one
// would see less.
static uint32_t commit_of(const nck_jerk_t *self) {
    const nck_plan_t *const next = self->next;
    const uint32_t third = next->n / COMMIT_SURE + 1;
    const int is_short = next->end_piece - next->piece <= NCK_JERK_PIECES / COMMIT_SURE;
    const uint32_t most = is_short && self->work.sure > third ? self->work.sure : third;
    const uint32_t least = next->n / COMMIT_LEAST + 1;
    const uint32_t keep = next->keep > KEEP_OFF ? next->keep - KEEP_OFF : 0;
    return keep > most ? most : keep < least ? least : keep;
}

// A coarse plan only tells how to divide the ladder, and so does one that changes its speed in a
// long cell. It is slower than the next: where it keeps to its caps, that one does, too.
static nck_status_t finish_draw(nck_jerk_t *self) {
    const uint32_t brakes = self->next->complete ? self->work.brakes_long : 0;
    const int is_uneven = (self->work.uneven | brakes) && !self->work.divided;
    if ((self->work.coarse || is_uneven) && !is_rest(self)) {
        const double spare = (double)(NCK_JERK_CELLS - self->work.n);
        const double fits = self->work.time / nck_max(1.0, spare);
        if (self->work.reach > 0.0) self->work.step = nck_max(self->step_s, fits);
        self->work.divided = !self->work.coarse;
        self->work.coarse = 0;
        self->work.anew = 0;
        self->work.from_built = 1;
        self->work.n = 0;
        self->work.length = 0.0;
        self->work.piece = self->next->piece;
        enter(self, PHASE_LOAD);
        return NCK_OK;
    }
    self->next->commit = commit_of(self);
    return NCK_DONE;
}

static nck_status_t lay(nck_jerk_t *self, const nck_pieces_t *pieces) {
    const nck_status_t status = nck_window_lay(self, pieces);
    if (status != NCK_DONE) return status;
    enter(self, is_rest(self) ? PHASE_PLAN : PHASE_LIMIT);
    return NCK_OK;
}

static nck_status_t find_reach(nck_jerk_t *self, const nck_pieces_t *pieces) {
    const nck_status_t status = nck_brake_reach(self, pieces);
    if (status == NCK_EMPTY) return NCK_FULL; // the plan of now rests before
    if (status == NCK_DONE) begin_hold(self, self->work.reach);
    return NCK_OK;
}

static nck_status_t load(nck_jerk_t *self, const nck_pieces_t *pieces) {
    return nck_window_load(self, pieces) == NCK_DONE ? finish_load(self, pieces) : NCK_OK;
}

static nck_status_t limit(nck_jerk_t *self, const nck_pieces_t *pieces) {
    if (nck_bounds_set(self, pieces) == NCK_DONE) finish_limit(self);
    return NCK_OK;
}

static nck_status_t ease(nck_jerk_t *self) {
    if (nck_brake_ease(self) == NCK_DONE) enter(self, PHASE_BRAKE);
    return NCK_OK;
}

static nck_status_t brake(nck_jerk_t *self) {
    if (nck_brake_raise(self) == NCK_DONE) begin_plan(self);
    return NCK_OK;
}

static nck_status_t plan(nck_jerk_t *self, const nck_pieces_t *pieces) {
    if (is_rest(self)) return finish_plan(self, pieces);
    const nck_status_t status = nck_profile_step(&self->profile, NCK_JERK_NODES);
    return status == NCK_DONE ? finish_plan(self, pieces) : NCK_OK;
}

static nck_status_t draw(nck_jerk_t *self, const nck_pieces_t *pieces) {
    return nck_draw_cells(self, pieces) == NCK_DONE ? finish_draw(self) : NCK_OK;
}

nck_status_t nck_jerk_step(nck_jerk_t *self, const nck_pieces_t *pieces) {
    if (!NCK_HAS_JERK) return NCK_E_INTERNAL;
    switch (self->work.phase) {
    case PHASE_REACH: return find_reach(self, pieces);
    case PHASE_LOAD: return load(self, pieces);
    case PHASE_LAY: return lay(self, pieces);
    case PHASE_LIMIT: return limit(self, pieces);
    case PHASE_EASE: return ease(self);
    case PHASE_BRAKE: return brake(self);
    case PHASE_PLAN: return plan(self, pieces);
    case PHASE_CHECK: return check(self, pieces);
    default: return draw(self, pieces);
    }
}

void nck_jerk_hurry(nck_jerk_t *self) { self->job.starved = 1; }
