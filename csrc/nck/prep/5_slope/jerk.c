// SPDX-License-Identifier: MIT
// Room 5, slope: the jerk-limited slope, plan after plan.
#include "nck/prep/5_slope/jerk.h"

#include <string.h> // memset

#include "nck/base/real.h"                // nck_min nck_max
#include "nck/prep/5_slope/ladder_math.h" // nck_ladder_excess
#include "nck/prep/5_slope/window.h"      // nck_window_…

enum {
    PHASE_IDLE = 0, PHASE_REACH, PHASE_LOAD, PHASE_LAY, PHASE_LIMIT, PHASE_BRAKE, PHASE_PLAN,
    PHASE_DRAW, PHASE_INSTALL
};

// Of a plan's cells at most one in three, at least one in ten become final before the next one
// takes over; and so many cells less than where it begins to brake for the window's end.
enum { COMMIT_MOST = 3, COMMIT_LEAST = 10, KEEP_OFF = 4 };

// The window is to see this many times the time that a ramp from full speed to rest takes.
#define RAMPS_SEEN 3.0
// Cells last half a period at least: finer ladders gain next to nothing (README).
#define STEP_LEAST 0.5
// Periods that are final ahead of the tick.
#define LEAD_PERIODS 5.0
// Room for rounding below every jerk limit.
#define JERK_MARGIN 1e-5
// A hold begins to brake so many periods behind them.
#define HOLD_PERIODS 2.0
// A plan that answers the operator is put off while so many periods are still final: the tick must
// not run into the tail, where nobody is heard.
#define LEAD_LEAST 2.0
// It gets so many times the cells that have passed in vain.
#define PATIENCE 4
// A hold that cannot be met gets so much more length.
#define REACH_GROWTH 1.05

void nck_jerk_init(nck_jerk_t *self, const nck_machine_t *machine, nck_link_t *link) {
    memset(self, 0, sizeof *self);
    self->machine = machine;
    self->link = link;
    const double period = machine->period_s;
    const double ramp = machine->path.feed_max / machine->path.a_max
                        + machine->path.a_max / machine->path.j_max;
    const double most = nck_max(1.0, 0.25 * (double)NCK_FILTER_TAPS) * period;
    self->step_s = nck_max(STEP_LEAST * period,
                           nck_min(most, RAMPS_SEEN * ramp / (double)NCK_PROFILE));
    self->q_cap = NCK_LADDER_STRETCH * self->step_s;
    self->j_scale = (1.0 - JERK_MARGIN)
                    / (1.0 + nck_ladder_excess(self->q_cap, period, NCK_FILTER_TAPS));
    self->lead_s = LEAD_PERIODS * period;
    self->now.complete = 1;
    self->now.end_s = -1.0;
    self->wish.feed = 1.0;
    self->wish.rapid = 1.0;
    nck_profile_t *const p = &self->profile;
    p->h = self->h;
    p->w_cap = self->w_cap;
    p->a_max = self->a_max;
    p->j_max = self->j_max;
    p->w = self->w;
    p->s = self->s;
    p->up = self->up;
    p->down = self->down;
    p->e = self->e;
    p->z = self->z;
    p->stack = self->stack;
}

static void enter(nck_jerk_t *self, uint32_t phase) {
    self->work.phase = phase;
    self->work.i = 0;
    self->work.w_cell = 0.0;
}

// A plan from rest or from a moving state, under the wishes of now. over: 1: that state may be one
// of an override beyond 100 %.
static void begin(nck_jerk_t *self, uint32_t count, uint32_t over) {
    memset(&self->next, 0, sizeof self->next);
    memset(&self->work, 0, sizeof self->work);
    self->next.begin = count & NCK_LINK_COUNT_MASK;
    self->taken = nck_link_taken(self->link);
    self->work.step = self->step_s;
    self->work.wish = self->wish;
    self->next.over = over || self->wish.feed > 1.0;
    self->work.over = self->next.over;
    self->profile.v = 0.0;
    self->profile.a = 0.0;
    self->profile.q = 0.0;
}

static int is_released(const nck_jerk_t *self) {
    if (self->wish.hold) return 0;
    const int waits = self->now.held == NCK_HELD_RESUME || self->now.held == NCK_HELD_BLOCK;
    return !waits || self->wish.resumes != self->resumes;
}

// From the rest at the end of the plan of now.
static nck_status_t begin_at_rest(nck_jerk_t *self, const nck_pieces_t *pieces) {
    const nck_node_t *const piece = nck_window_piece(pieces, self->now.end_piece);
    if (!is_released(self)) return NCK_FULL;
    if (!piece) return NCK_EMPTY;
    begin(self, self->now.begin + self->now.n, 0);
    if (piece->length > 0.0 && !(nck_window_cap(self, piece) > 0.0)) return NCK_FULL;
    self->work.coarse = 1;
    self->work.far = NCK_JERK_UNKNOWN;
    self->work.base = self->now.end_piece;
    self->work.pieces = NCK_JERK_PIECES / 2;
    self->next.piece = self->now.end_piece;
    self->next.s = self->now.end_s < 0.0 ? piece->s : self->now.end_s;
    self->work.piece = self->next.piece;
    self->work.s = self->next.s;
    enter(self, PHASE_LAY);
    return NCK_OK;
}

// From the moving state behind the plan's first `first` cells. A stop at a block's end is laid
// anew, because the cells of now may run past it.
static void begin_moving(nck_jerk_t *self, const nck_pieces_t *pieces, uint32_t first) {
    const uint32_t count = (self->now.begin + first) & NCK_LINK_COUNT_MASK;
    const nck_cell_t *const cell = nck_link_tail_cell(self->link, count);
    const nck_cell_t *const before =
        nck_link_tail_cell(self->link, (count - 1) & NCK_LINK_COUNT_MASK);
    const int anew = self->wish.single_block || !(self->wish.feed > 0.0 && self->wish.rapid > 0.0);
    begin(self, count, self->now.over);
    self->profile.v = cell->v;
    if (cell->v > 0.0) self->profile.a = before->a;
    if (cell->v > 0.0) self->profile.q = before->duration;
    self->next.piece = nck_window_find(pieces, self->now.piece, cell);
    self->next.s = cell->s;
    self->work.piece = self->next.piece;
    self->work.s = self->next.s;
    self->work.base = self->now.first_piece;
    self->work.pieces = NCK_JERK_PIECES;
    self->work.w_entry = cell->v * cell->v;
    self->work.far = NCK_JERK_UNKNOWN;
    self->work.source = count;
    self->work.coarse = (uint32_t)anew;
    self->work.anew = (uint32_t)anew;
    enter(self, anew ? PHASE_LAY : PHASE_LOAD);
}

// The ladder of now up to where the path is to rest; it was made for other speeds, so it is divided
// anew. An override of zero brakes, it is no cap.
static void begin_hold(nck_jerk_t *self, double reach) {
    if (!(self->work.wish.feed > 0.0)) self->work.wish.feed = 1.0;
    if (!(self->work.wish.rapid > 0.0)) self->work.wish.rapid = 1.0;
    self->work.reach = reach;
    self->work.piece = self->next.piece;
    self->work.coarse = 1;
    enter(self, PHASE_LOAD);
}

// Cells of the plan of now that are final.
static uint32_t final_count(const nck_jerk_t *self) {
    int entered = 0;
    return (nck_link_end(self->link, &entered) - self->now.begin) & NCK_LINK_COUNT_MASK;
}

// Cells of it that may become final.
static uint32_t final_limit(const nck_jerk_t *self) {
    return self->now.complete ? self->now.n : self->now.commit;
}

// The plan of now stays, to its end.
static void keep_plan(nck_jerk_t *self, uint32_t held) {
    self->now.complete = 1;
    memset(&self->answer, 0, sizeof self->answer);
    if (held) {
        self->now.held = held;
        self->resumes = self->wish.resumes;
    }
    enter(self, PHASE_IDLE);
}

// Cells that pass until a plan begun now is made: twice as many as for the last one, because it is
// made twice. A hold's is short. What was put off gets more.
static uint32_t reserve_of(const nck_jerk_t *self) {
    const double periods = self->wish.hold ? HOLD_PERIODS : LEAD_PERIODS;
    const double least = periods * self->machine->period_s / self->q_cap;
    const double spent = self->wish.hold ? 0.0 : 2.0 * (double)self->spent;
    return (uint32_t)nck_max(nck_max(least, spent), (double)self->answer.reserve);
}

// Cells that the tick has taken since the plan in work was begun.
static uint32_t passed_meanwhile(const nck_jerk_t *self) {
    return (nck_link_taken(self->link) - self->taken) & NCK_LINK_COUNT_MASK;
}

// Brake, and stay as told.
static void begin_brake(nck_jerk_t *self, const nck_pieces_t *pieces, uint32_t first,
                        uint32_t held) {
    begin_moving(self, pieces, first);
    self->next.held = held;
    enter(self, PHASE_REACH);
}

// The plan that follows the first cells of now: a brake, if the operator wants it or has taken the
// speed away.
static void begin_from(nck_jerk_t *self, const nck_pieces_t *pieces, uint32_t first) {
    begin_moving(self, pieces, first);
    const nck_node_t *const piece = nck_window_piece(pieces, self->next.piece);
    const int moves = nck_window_cap(self, piece) > 0.0;
    if (self->wish.hold) {
        begin_brake(self, pieces, first, NCK_HELD_RESUME);
    } else if (!moves) {
        begin_brake(self, pieces, first, NCK_HELD_OVERRIDE);
    }
}

// Other wishes: plan anew from a few cells behind the final ones, unless the path rests by then.
static void replan(nck_jerk_t *self, const nck_pieces_t *pieces) {
    uint32_t first = final_count(self) + reserve_of(self);
    enter(self, PHASE_IDLE);
    if (self->now.held == NCK_HELD_RESUME) return; // brakes already
    const nck_cell_t *const cell =
        nck_link_tail_cell(self->link, (self->now.begin + first) & NCK_LINK_COUNT_MASK);
    if (cell && !(cell->v > 0.0)) first++; // a corner passed at no speed is no state to brake from
    if (first >= self->now.n) {
        if (self->wish.hold) keep_plan(self, NCK_HELD_RESUME);
        return;
    }
    self->now.complete = 0;
    self->now.commit = first;
    self->answer.pending = 1;
    begin_from(self, pieces, first);
    if (self->answer.slower) self->work.coarse = 1; // the ladder of now is for higher speeds
}

// The answer to the operator is not made in time: the plan of now goes on, and another answer is
// made from further on. Only answers may wait for time; other plans depend on counts alone.
static void put_off(nck_jerk_t *self, const nck_pieces_t *pieces) {
    self->answer.reserve = PATIENCE * (1 + passed_meanwhile(self));
    replan(self, pieces);
    if (self->work.phase == PHASE_IDLE) keep_plan(self, NCK_HELD_NOT);
}

static int is_late(nck_jerk_t *self) {
    const double least = LEAD_LEAST * self->machine->period_s;
    const int makes = self->work.phase != PHASE_IDLE && self->work.phase != PHASE_INSTALL;
    return self->answer.pending && makes && nck_link_lead(self->link) < least;
}

// The tick has run into the tail: the path comes to rest where the plan of now does.
static void fall_into_tail(nck_jerk_t *self) {
    int entered = 0;
    self->now.begin = nck_link_end(self->link, &entered);
    self->now.n = 0;
    self->now.piece = self->now.end_piece;
    self->now.first_piece = self->now.end_piece;
    self->in_tail = 1;
    keep_plan(self, self->wish.hold ? (uint32_t)NCK_HELD_RESUME : (uint32_t)NCK_HELD_NOT);
}

// Whether the plan of now runs past the place where the next one rests.
static int runs_past(const nck_jerk_t *self, const nck_pieces_t *pieces) {
    const nck_node_t *const behind = nck_window_piece(pieces, self->next.end_piece);
    const int32_t further = (int32_t)(self->now.end_piece - self->next.end_piece);
    return further > 0 || (further == 0 && behind && self->now.end_s > behind->s);
}

// The plan does not join. A hold gets more length. Is the plan of now on its way past the place, it
// is too late to rest there: a stop at a block's end waits for a later block, an override of zero
// rests further on. If it rests there or before, it is as good.
// Else the ladder of now is taken over as it is: where short pieces share cells in another way,
// caps may differ. If that does not help either, the plan of now goes on and the next one begins
// later.
static void give_way(nck_jerk_t *self, const nck_pieces_t *pieces) {
    const uint32_t held = self->next.held;
    const uint32_t first = (self->next.begin - self->now.begin) & NCK_LINK_COUNT_MASK;
    const double reach = self->work.reach;
    const uint32_t passes = self->work.passes + 1;
    self->failures++;
    if (reach > 0.0) {
        begin_moving(self, pieces, first);
        self->next.held = held;
        begin_hold(self, REACH_GROWTH * reach);
        return;
    }
    const int is_past = self->next.complete && runs_past(self, pieces);
    if (is_past && self->work.must_rest) {
        begin_brake(self, pieces, first, NCK_HELD_OVERRIDE);
        return;
    }
    if (self->wish.single_block && is_past && passes < NCK_JERK_PIECES) {
        begin_moving(self, pieces, first);
        self->work.passes = passes;
        self->work.to_pass = passes;
        return;
    }
    if (!self->work.all && !self->wish.single_block) {
        begin_moving(self, pieces, first);
        self->work.all = 1;
        return;
    }
    enter(self, PHASE_IDLE);
    self->now.commit += 1 + NCK_PROFILE / 8;
    if (self->now.commit >= self->now.n) keep_plan(self, NCK_HELD_NOT);
}

static void finish_load(nck_jerk_t *self, const nck_pieces_t *pieces) {
    if (self->work.from_built) {
        const int all = !nck_link_built_cell(self->link, self->work.i);
        if (!all && self->work.reach > 0.0) {
            keep_plan(self, self->next.held); // no room for a ladder to the rest
            return;
        }
        if (!all) {
            self->next.complete = 0;
            self->next.held = NCK_HELD_NOT;
            self->next.end_piece = self->work.piece;
            self->next.end_s = self->work.s;
        }
        self->next.n = self->work.n;
        enter(self, PHASE_LIMIT);
        return;
    }
    if (!(self->work.reach > 0.0) && !nck_window_rests(self, pieces)) {
        enter(self, PHASE_LAY);
        return;
    }
    if (self->work.length < self->work.reach) {
        keep_plan(self, self->next.held); // it rests sooner than the hold would
        return;
    }
    self->next.complete = 1;
    self->next.n = self->work.n;
    self->next.end_piece = self->work.piece;
    self->next.end_s = self->work.s;
    enter(self, PHASE_LIMIT);
}

static int is_rest(const nck_jerk_t *self) {
    return self->work.n == 1 && !(self->h[0] > 0.0);
}

static void finish_brake(nck_jerk_t *self) {
    nck_profile_t *const p = &self->profile;
    p->n = self->work.n;
    p->q_cap = nck_window_q_cap(self);
    nck_profile_begin(p);
    enter(self, PHASE_PLAN);
}

static void finish_plan(nck_jerk_t *self, const nck_pieces_t *pieces) {
    const int checks = !self->work.coarse || self->work.reach > 0.0;
    if (checks && !nck_profile_joins(&self->profile)) {
        give_way(self, pieces);
        return;
    }
    nck_link_tail_begin(self->link);
    enter(self, PHASE_DRAW);
}

// Where the next plan takes over: a third on, but not where this one already brakes for the
// window's end, if that leaves something.
static uint32_t commit_of(const nck_jerk_plan_t *plan) {
    const uint32_t most = plan->n / COMMIT_MOST + 1;
    const uint32_t least = plan->n / COMMIT_LEAST + 1;
    const uint32_t keep = plan->keep > KEEP_OFF ? plan->keep - KEEP_OFF : 0;
    return keep > most ? most : keep < least ? least : keep;
}

// A coarse plan only tells how to divide the ladder.
static void finish_draw(nck_jerk_t *self) {
    if (self->work.coarse && !is_rest(self)) {
        const double spare = (double)(NCK_JERK_CELLS - self->work.n);
        const double fits = self->work.time / nck_max(1.0, spare);
        if (self->work.reach > 0.0) self->work.step = nck_max(self->step_s, fits);
        self->work.coarse = 0;
        self->work.anew = 0;
        self->work.from_built = 1;
        self->work.n = 0;
        self->work.length = 0.0;
        self->work.piece = self->next.piece;
        enter(self, PHASE_LOAD);
        return;
    }
    self->next.commit = commit_of(&self->next);
    if (self->next.commit >= self->next.n) self->next.complete = 1; // nothing to take over from
    const int counts = self->profile.v > 0.0 && !(self->work.reach > 0.0);
    if (counts) self->spent = passed_meanwhile(self);
    enter(self, PHASE_INSTALL);
}

static nck_status_t install(nck_jerk_t *self) {
    int entered = 0;
    const uint32_t most = self->next.complete ? self->next.n : self->next.commit;
    if (nck_link_end(self->link, &entered) != self->next.begin) return NCK_FULL;
    const nck_status_t status = nck_link_install(self->link, self->lead_s, most);
    if (status != NCK_OK) return status == NCK_E_STATE ? NCK_OK : status;
    const int same_block = self->now.held == NCK_HELD_BLOCK && self->next.held == NCK_HELD_BLOCK;
    const int on_the_way = same_block && self->now.end_piece == self->next.end_piece;
    if (!on_the_way) self->resumes = self->wish.resumes;
    self->now = self->next;
    self->now.first_piece = self->next.piece;
    self->in_tail = 0;
    memset(&self->answer, 0, sizeof self->answer);
    enter(self, PHASE_IDLE);
    return NCK_OK;
}

static nck_status_t begin_next(nck_jerk_t *self, const nck_pieces_t *pieces) {
    if (self->now.complete) return begin_at_rest(self, pieces);
    begin_from(self, pieces, self->now.commit);
    return NCK_OK;
}

// One step of the plan in work.
static nck_status_t work(nck_jerk_t *self, const nck_pieces_t *pieces) {
    nck_status_t status = NCK_OK;
    switch (self->work.phase) {
    case PHASE_IDLE: return begin_next(self, pieces);
    case PHASE_REACH:
        status = nck_window_reach(self, pieces);
        if (status == NCK_EMPTY) keep_plan(self, self->next.held);
        if (status == NCK_DONE) begin_hold(self, self->work.reach);
        return NCK_OK;
    case PHASE_LOAD:
        if (nck_window_load(self, pieces) == NCK_DONE) finish_load(self, pieces);
        return NCK_OK;
    case PHASE_LAY:
        status = nck_window_lay(self, pieces);
        if (status != NCK_DONE) return status;
        enter(self, is_rest(self) ? PHASE_PLAN : PHASE_LIMIT);
        return NCK_OK;
    case PHASE_LIMIT:
        if (nck_window_limit(self, pieces) == NCK_DONE) enter(self, PHASE_BRAKE);
        return NCK_OK;
    case PHASE_BRAKE:
        if (nck_window_brake(self) == NCK_DONE) finish_brake(self);
        return NCK_OK;
    case PHASE_PLAN:
        if (is_rest(self) || nck_profile_step(&self->profile, NCK_JERK_STEP) == NCK_DONE) {
            finish_plan(self, pieces);
        }
        return NCK_OK;
    case PHASE_DRAW:
        if (nck_window_draw(self, pieces) == NCK_DONE) finish_draw(self);
        return NCK_OK;
    default: return install(self);
    }
}

static int is_other(const nck_wish_t *a, const nck_wish_t *b) {
    return a->hold != b->hold || a->feed != b->feed || a->rapid != b->rapid
           || a->single_block != b->single_block;
}

// Single block switched off on the way to a block's end is a resume in advance, in case it is too
// late to pass that end. At rest there it takes a resume.
static void hear_single_block(nck_jerk_t *self) {
    const int moves = final_count(self) < self->now.n;
    if (self->now.held != NCK_HELD_BLOCK || !moves) return;
    self->resumes = self->wish.resumes - (self->wish.single_block ? 0u : 1u);
}

// The oldest piece in use moves on with the final cells.
static void follow(nck_jerk_t *self, const nck_pieces_t *pieces) {
    int entered = 0;
    const nck_cell_t *const cell =
        nck_link_tail_cell(self->link, nck_link_end(self->link, &entered));
    const int within = final_count(self) < self->now.n;
    if (within && cell) self->now.piece = nck_window_find(pieces, self->now.piece, cell);
    if (!within && self->now.complete) self->now.piece = self->now.end_piece;
}

nck_status_t nck_jerk_step(nck_jerk_t *self, const nck_pieces_t *pieces, const nck_wish_t *wish) {
    int entered = 0;
    (void)nck_link_end(self->link, &entered);
    if (entered && !self->in_tail) fall_into_tail(self);
    const int other = is_other(&self->wish, wish);
    const int slower = wish->feed < self->wish.feed || wish->rapid < self->wish.rapid;
    const int switched = wish->single_block != self->wish.single_block;
    self->wish = *wish;
    if (switched) hear_single_block(self);
    if (other) {
        self->answer.slower |= (uint32_t)slower;
        replan(self, pieces);
    }
    const uint32_t done = final_count(self);
    const uint32_t limit = final_limit(self);
    if (done == limit && is_late(self)) {
        put_off(self, pieces);
        return NCK_OK;
    }
    if (done < limit && nck_link_advance(self->link, self->lead_s, limit - done) == NCK_OK) {
        follow(self, pieces);
        return NCK_OK;
    }
    follow(self, pieces);
    const nck_status_t status = work(self, pieces);
    return status == NCK_EMPTY && final_count(self) < final_limit(self) ? NCK_FULL : status;
}

uint32_t nck_jerk_needs(const nck_jerk_t *self) { return self->now.piece; }

int nck_jerk_is_held(const nck_jerk_t *self) {
    return self->now.held && final_count(self) >= self->now.n;
}
