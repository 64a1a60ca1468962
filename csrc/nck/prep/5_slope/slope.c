// SPDX-License-Identifier: MIT
// Room 5, slope: plan after plan, and what the operator wants of them.
#include "nck/base/fence.h"           // nck_fence_store
#include "nck/base/real.h"            // nck_max
#include "nck/prep/5_slope/planner.h" // nck_planner_…
#include "nck/prep/5_slope/slope.h"
#include "nck/prep/5_slope/tuning.h" // NCK_SLOPE_NO_MOTION

#include <assert.h> // assert
#include <stddef.h> // offsetof
#include <string.h> // memset

enum { PHASE_IDLE = 0, PHASE_MAKE, PHASE_INSTALL };

// Periods that are final ahead of the tick.
#define LEAD_PERIODS 5.0
#define ALL_S 1e9
// A plan begins so many periods behind them at least; a hold's is made sooner.
#define PLAN_PERIODS 3.5
#define HOLD_PERIODS 1.0
// A plan that answers the operator is put off while so many periods are still final: the tick must
// not run into the tail, where nobody is heard.
#define LEAD_LEAST 2.0
// It gets so many times the time that has passed in vain.
#define PATIENCE 4
// Cells that pass until another plan is tried where none joined: time enough to make it.
#define NO_WAY (1 + (NCK_PROFILE > 128 ? NCK_PROFILE / 16 : 8))

void nck_slope_init(nck_slope_t *self, const nck_terms_t *terms, nck_link_t *link) {
    const nck_machine_t *const machine = terms->machine;
    memset(self, 0, offsetof(nck_slope_t, planner)); // the planners begin for themselves
    self->terms = terms;
    self->machine = machine;
    self->link = link;
    self->lead_s = LEAD_PERIODS * machine->period_s;
    self->now.complete = 1;
    self->now.end_s = NCK_PLAN_BEGIN;
    self->wish.feed = 1.0;
    self->wish.rapid = 1.0;
    self->wish.tool = NCK_WISH_FREE;
    nck_planner_init(self);
}

static void note_begun(nck_slope_t *self) {
    int entered = 0;
    self->begun.taken = nck_link_taken(self->link);
    self->begun.end = nck_link_end(self->link, &entered);
    self->begun.lead_s = nck_link_lead(self->link);
}

// A plan from rest or from a moving state, under the wishes of now. over: 1: that state may be one
// of an override beyond 100 %.
static void begin(nck_slope_t *self, nck_job_t *job, uint32_t count, uint32_t over) {
    memset(&self->next, 0, sizeof self->next);
    memset(job, 0, sizeof *job);
    self->next.begin = count & NCK_LINK_COUNT_MASK;
    self->next.wants = self->now.end_piece;
    self->next.over = over || self->wish.feed > 1.0;
    note_begun(self);
    self->hurried = 0;
    self->awaits_tail = 0;
    job->wish = self->wish;
    job->anew = self->anew;
    job->starved = self->in_tail;
}

static void make(nck_slope_t *self, const nck_job_t *job) {
    self->kind = job->kind;
    self->phase = PHASE_MAKE;
    nck_planner_begin(self, job);
}

static int is_released(const nck_slope_t *self) {
    if (self->wish.hold) return 0;
    const int waits = self->now.held == NCK_HELD_RESUME || self->now.held == NCK_HELD_BLOCK;
    return !waits || self->wish.resumes != self->resumes;
}

// From the rest at the end of the plan of now.
static nck_status_t start(nck_slope_t *self, const nck_pieces_t *pieces) {
    const nck_node_t *const piece = nck_plan_piece(pieces, self->now.end_piece);
    nck_job_t job;
    if (!is_released(self)) return NCK_FULL;
    if (!piece) return NCK_EMPTY;
    nck_planner_choose(self, piece);
    begin(self, &job, self->now.begin + self->now.n, 0);
    const double cap = nck_plan_cap(piece, &self->wish, self->next.over);
    if (piece->length > 0.0 && !(cap > 0.0)) return NCK_FULL;
    job.kind = NCK_JOB_START;
    self->next.piece = self->now.end_piece;
    self->next.s = self->now.end_s == NCK_PLAN_BEGIN ? piece->s : self->now.end_s;
    make(self, &job);
    return NCK_OK;
}

// The plan that follows the first cells of now: a brake, if the operator wants it or has taken the
// speed away. Along a clocked path that is the tick's.
static void go_on(nck_slope_t *self, const nck_pieces_t *pieces, uint32_t first) {
    const uint32_t count = (self->now.begin + first) & NCK_LINK_COUNT_MASK;
    const nck_cell_t *const cell = nck_link_tail_cell(self->link, count);
    const nck_cell_t *const before =
        nck_link_tail_cell(self->link, (count - 1) & NCK_LINK_COUNT_MASK);
    nck_job_t job;
    assert(cell && before); // within the plan of now
    begin(self, &job, count, self->now.over);
    job.v = cell->v;
    if (cell->v > 0.0) job.a = before->a + before->j * before->duration;
    if (cell->v > 0.0) job.q = before->duration;
    job.slower = self->answer.slower;
    self->next.piece = nck_plan_find(pieces, self->now.piece, cell);
    self->next.s = cell->s;
    const nck_node_t *const piece = nck_plan_piece(pieces, self->next.piece);
    assert(piece); // nck_slope_needs keeps it
    const int rests =
        self->wish.hold || !(nck_plan_cap(piece, &self->wish, self->next.over) > 0.0);
    const int by_tick = nck_planner_kind(self) == NCK_SLOPE_OPTIMAL;
    job.kind = rests && !by_tick ? NCK_JOB_BRAKE : NCK_JOB_GO_ON;
    job.held = self->wish.hold ? NCK_HELD_RESUME : NCK_HELD_OVERRIDE;
    make(self, &job);
}

// Cells of the plan of now that are final.
static uint32_t final_count(const nck_slope_t *self) {
    int entered = 0;
    return (nck_link_end(self->link, &entered) - self->now.begin) & NCK_LINK_COUNT_MASK;
}

// Cells of it that may become final.
static uint32_t final_limit(const nck_slope_t *self) {
    return self->now.complete ? self->now.n : self->now.commit;
}

// Nothing keeps the path yet where the plan of now comes to rest, but single block does: it is a
// block's end.
static int waits_behind(const nck_slope_t *self, const nck_pieces_t *pieces) {
    const uint32_t end = self->now.end_piece;
    const int moves = final_count(self) < self->now.n;
    const int known = nck_plan_piece(pieces, end) && nck_plan_piece(pieces, end - 1);
    const int asks = self->wish.single_block && !self->now.held && moves;
    if (!asks || !known || self->now.end_s != NCK_PLAN_BEGIN) return 0;
    return nck_plan_ends_block(self->link, pieces, end - 1);
}

// Cells that were not made for a rest at a block's end do not tell it. In the tail nobody is heard.
static void tell(nck_slope_t *self) {
    const int brakes = self->now.held == NCK_HELD_RESUME || self->now.held == NCK_HELD_OVERRIDE;
    nck_fence_store(&self->waits, self->now.held == NCK_HELD_BLOCK);
    nck_fence_store(&self->brakes, brakes && !self->in_tail);
}

// The plan of now stays, to its end.
static void keep_plan(nck_slope_t *self, const nck_pieces_t *pieces, uint32_t wanted) {
    const int waits = !wanted && waits_behind(self, pieces);
    const uint32_t held = waits ? (uint32_t)NCK_HELD_BLOCK : wanted;
    self->now.complete = 1;
    memset(&self->answer, 0, sizeof self->answer);
    self->anew = 1;
    if (held) {
        self->now.held = held;
        self->resumes = self->wish.resumes;
    }
    tell(self);
    self->phase = PHASE_IDLE;
}

// The first cell of now, from `first` on, that begins so many seconds behind that one, or `most`
// cells.
static uint32_t cell_after(const nck_slope_t *self, uint32_t first, double time, uint32_t most) {
    double left = time;
    uint32_t i = first;
    while (left > 0.0 && i - first < most) {
        const nck_cell_t *const cell =
            nck_link_tail_cell(self->link, (self->now.begin + i) & NCK_LINK_COUNT_MASK);
        if (!cell) break;
        left -= cell->duration;
        i++;
    }
    return i;
}

// Where a plan begun now takes over: as long on as the last one took, twice, because it may be made
// twice. A hold's is short, and a clock that stands waits. What was put off gets more.
static uint32_t takeover(nck_slope_t *self) {
    const double periods = self->wish.hold ? HOLD_PERIODS : PLAN_PERIODS;
    const double least_s = periods * self->machine->period_s;
    const double twice_s = self->wish.hold || self->stands ? 0.0 : 2.0 * self->spent_s;
    const double time = nck_max(nck_max(least_s, twice_s), self->answer.reserve_s);
    return nck_planner_seam(self, cell_after(self, final_count(self), time, self->now.n));
}

// How long they lasted [s]: a ladder for far lower speeds is passed in no time, and cells at an
// even speed last several periods, so their count tells nothing of it.
static double passed_s(nck_slope_t *self) {
    int entered = 0;
    const uint32_t end = nck_link_end(self->link, &entered);
    double time = self->begun.lead_s - nck_link_lead(self->link);
    for (uint32_t i = self->begun.end; i != end; i = (i + 1) & NCK_LINK_COUNT_MASK) {
        const nck_cell_t *const cell = nck_link_tail_cell(self->link, i);
        if (!cell) break; // the tick has run into the tail
        time += cell->duration;
    }
    return nck_max(time, 0.0);
}

// Other wishes: plan anew from a few cells behind the final ones, unless the path rests by then.
static void replan(nck_slope_t *self, const nck_pieces_t *pieces) {
    nck_planner_choose(self, nck_plan_piece(pieces, self->now.piece)); // a start may have another
    uint32_t first = takeover(self);
    self->phase = PHASE_IDLE;
    if (self->now.held == NCK_HELD_RESUME) return; // it brakes already
    const nck_cell_t *const cell =
        nck_link_tail_cell(self->link, (self->now.begin + first) & NCK_LINK_COUNT_MASK);
    if (cell && !(cell->v > 0.0)) first++; // a corner passed at no speed is no state to brake from
    self->anew = 1;
    if (first >= self->now.n) {
        if (self->wish.hold) keep_plan(self, pieces, NCK_HELD_RESUME);
        else if (self->now.complete) keep_plan(self, pieces, NCK_HELD_NOT);
        return;
    }
    self->now.complete = 0;
    self->now.commit = first;
    self->answer.pending = 1;
    go_on(self, pieces, first);
}

// The answer to the operator is not made in time: the plan of now goes on, and another answer is
// made from further on. Only answers may wait for time; other plans depend on counts alone.
static void put_off(nck_slope_t *self, const nck_pieces_t *pieces) {
    self->answer.reserve_s = PATIENCE * (self->machine->period_s + passed_s(self));
    replan(self, pieces);
    if (self->phase == PHASE_IDLE) keep_plan(self, pieces, NCK_HELD_NOT);
}

// Nothing is drawn that would come in time.
static int is_late(nck_slope_t *self) {
    const double least = LEAD_LEAST * self->machine->period_s;
    return nck_link_lead(self->link) < least;
}

// 1 if the answer to the operator is put off.
static int waits_no_longer(nck_slope_t *self, const nck_pieces_t *pieces) {
    if (!self->answer.pending || self->phase != PHASE_MAKE || !is_late(self)) return 0;
    put_off(self, pieces);
    return 1;
}

// The tick has run into the tail: the path rests where the plan of now does.
static void fall_into_tail(nck_slope_t *self, const nck_pieces_t *pieces) {
    int entered = 0;
    self->now.begin = nck_link_end(self->link, &entered);
    self->now.n = 0;
    self->now.piece = self->now.end_piece;
    self->now.first_piece = self->now.end_piece;
    self->in_tail = 1;
    keep_plan(self, pieces, self->wish.hold ? (uint32_t)NCK_HELD_RESUME : (uint32_t)NCK_HELD_NOT);
}

// The plan is drawn.
static void finish(nck_slope_t *self) {
    nck_plan_t *const next = &self->next;
    if (next->commit >= next->n) next->complete = 1; // nothing to take over from
    if (self->kind == NCK_JOB_GO_ON) self->spent_s = passed_s(self);
    self->phase = PHASE_INSTALL;
}

// No plan joins: the plan of now goes on, and the next one begins later.
static void give_up(nck_slope_t *self, const nck_pieces_t *pieces) {
    const int brakes = self->kind == NCK_JOB_BRAKE;
    const int is_short = nck_planner_kind(self) == NCK_SLOPE_OPTIMAL;
    const uint32_t held = brakes ? self->next.held : (uint32_t)NCK_HELD_NOT;
    const uint32_t passed = nck_link_taken(self->link) - self->begun.taken;
    self->phase = PHASE_IDLE;
    self->awaits_tail = self->hurried; // a rest that nobody asked for is told as starvation
    if (self->hurried) return;
    self->anew = 1;
    self->now.commit += brakes     ? NCK_SLOPE_NO_MOTION + (passed & NCK_LINK_COUNT_MASK)
                        : is_short ? (uint32_t)NCK_SLOPE_NO_MOTION
                                   : (uint32_t)NO_WAY;
    self->now.commit = nck_planner_seam(self, self->now.commit);
    if (self->now.commit >= self->now.n) keep_plan(self, pieces, held);
}

// The plan in work is published: it is the plan of now.
static void take_over(nck_slope_t *self) {
    const int same_block = self->now.held == NCK_HELD_BLOCK && self->next.held == NCK_HELD_BLOCK;
    const int on_the_way = same_block && self->now.end_piece == self->next.end_piece;
    if (!on_the_way) self->resumes = self->wish.resumes;
    self->now = self->next;
    self->clocked = (uint32_t)(nck_planner_kind(self) == NCK_SLOPE_OPTIMAL);
    self->now.first_piece = self->next.piece;
    self->in_tail = 0;
    tell(self);
    self->anew = self->kind == NCK_JOB_BRAKE;
    memset(&self->answer, 0, sizeof self->answer);
    self->phase = PHASE_IDLE;
}

static nck_status_t install(nck_slope_t *self) {
    const nck_plan_t *const next = &self->next;
    int entered = 0;
    if (nck_link_end(self->link, &entered) != next->begin) return NCK_FULL;
    const uint32_t most = next->complete ? next->n : next->commit;
    const nck_status_t status = nck_link_install(self->link, self->lead_s, most);
    if (status == NCK_OK) take_over(self);
    return status == NCK_E_STATE ? NCK_OK : status;
}

static nck_status_t begin_next(nck_slope_t *self, const nck_pieces_t *pieces) {
    if (self->now.complete) return start(self, pieces);
    if (self->awaits_tail) return NCK_FULL;
    go_on(self, pieces, self->now.commit);
    return NCK_OK;
}

// One step of the plan in work.
static nck_status_t work(nck_slope_t *self, const nck_pieces_t *pieces) {
    if (self->phase == PHASE_IDLE) return begin_next(self, pieces);
    if (self->phase == PHASE_INSTALL) return install(self);
    const nck_status_t status = nck_planner_step(self, pieces);
    switch (status) {
    case NCK_DONE: finish(self); return NCK_OK;
    case NCK_FULL: keep_plan(self, pieces, self->next.held); return NCK_OK;
    case NCK_E_STATE: give_up(self, pieces); return NCK_OK;
    default: return status;
    }
}

// Single block switched off on the way to a block's end is a resume in advance, in case it is too
// late to pass that end. At rest there it takes a resume.
static void hear_single_block(nck_slope_t *self) {
    const int moves = final_count(self) < self->now.n;
    if (self->now.held != NCK_HELD_BLOCK || !moves) return;
    self->resumes = self->wish.resumes - (self->wish.single_block ? 0u : 1u);
}

// The oldest piece in use moves on with the final cells, which end here.
static void follow(nck_slope_t *self, const nck_pieces_t *pieces) {
    int entered = 0;
    const uint32_t end = nck_link_end(self->link, &entered);
    const int within = ((end - self->now.begin) & NCK_LINK_COUNT_MASK) < self->now.n;
    if (!within) {
        if (self->now.complete) self->now.piece = self->now.end_piece;
        return;
    }
    const nck_cell_t *const cell = nck_link_tail_cell(self->link, end);
    if (cell) self->now.piece = nck_plan_find(pieces, self->now.piece, cell);
}

static void hear_other(nck_slope_t *self, const nck_pieces_t *pieces, const nck_wish_t *wish) {
    const int slower = wish->feed < self->wish.feed || wish->rapid < self->wish.rapid
                       || wish->tool < self->wish.tool;
    const int switched = wish->single_block != self->wish.single_block;
    self->wish = *wish;
    if (switched) hear_single_block(self);
    self->answer.slower |= (uint32_t)slower;
    replan(self, pieces);
}

// Returns 1 if the operator wants something else.
static int hear(nck_slope_t *self, const nck_pieces_t *pieces, const nck_wish_t *wish) {
    const int resumes = self->wish.resumes != wish->resumes;
    self->wish.resumes = wish->resumes;
    if (!nck_plan_is_other(&self->wish, wish)) return resumes;
    hear_other(self, pieces, wish);
    return 1;
}

// Pieces are lacking, or what the tick takes beyond self->idle.taken. A plan that is drawn lacks no
// pieces. An answer to the operator waits for time, too: it is asked about every time.
static void note_idle(nck_slope_t *self, const nck_pieces_t *pieces, nck_status_t status) {
    const uint32_t end = pieces->head + pieces->fill;
    const int32_t lacks = (int32_t)(self->next.wants - end);
    self->idle.status = self->answer.pending ? (uint32_t)NCK_OK : (uint32_t)status;
    self->idle.barrier = nck_slope_barrier(pieces);
    self->idle.complete = pieces->complete;
    self->idle.wants = self->phase == PHASE_MAKE && lacks > 0 ? self->next.wants : end + 1;
    if (self->phase == PHASE_INSTALL) self->idle.wants = pieces->head + NCK_NODE_MAX + 1;
}

// What the plan in work says, and what it lacks if it cannot go on.
static nck_status_t note_work(nck_slope_t *self, const nck_pieces_t *pieces, nck_status_t status) {
    if (status != NCK_EMPTY && status != NCK_FULL) return status;
    const int waits = final_count(self) < final_limit(self);
    const nck_status_t told = waits ? NCK_FULL : status;
    if (waits || told == NCK_EMPTY) note_idle(self, pieces, told);
    return told;
}

// What became final was all that could be done, if nothing else has been asked for.
static nck_status_t note_final(nck_slope_t *self, const nck_pieces_t *pieces, int lacks) {
    follow(self, pieces);
    if (lacks && final_count(self) < final_limit(self)) self->idle.status = NCK_FULL;
    return NCK_OK;
}

// How long what is final lasts at least [s]. While the clock stands all before an answer is final
// once that is drawn: so it is in force when the clock sets off.
static double lead(const nck_slope_t *self) {
    const int drawn = self->stands && self->answer.pending && self->phase == PHASE_INSTALL;
    return drawn ? ALL_S : self->lead_s;
}

nck_status_t nck_slope_step(nck_slope_t *self, const nck_pieces_t *pieces, const nck_wish_t *wish) {
    int entered = 0;
    (void)nck_link_end(self->link, &entered);
    const int lacks = nck_slope_lacks_pieces(self, pieces);
    const int was_idle = self->phase == PHASE_IDLE;
    self->idle.status = NCK_OK;
    self->idle.taken = nck_link_taken(self->link); // before it is looked at
    if (entered && !self->in_tail) fall_into_tail(self, pieces);
    const int same = !hear(self, pieces, wish);
    const uint32_t done = final_count(self);
    const uint32_t limit = final_limit(self);
    if (done == limit && waits_no_longer(self, pieces)) return NCK_OK;
    if (done < limit && nck_link_advance(self->link, lead(self), limit - done) == NCK_OK) {
        return note_final(self, pieces, lacks && same && !entered);
    }
    // While a plan is made, only what becomes final moves on.
    if (was_idle || self->phase == PHASE_IDLE) follow(self, pieces);
    return note_work(self, pieces, work(self, pieces));
}

double nck_slope_known_s(const nck_slope_t *self) {
    if (self->phase != PHASE_MAKE || self->kind != NCK_JOB_START) return 0.0;
    return (double)nck_planner_laid(self) * self->terms->knot_s;
}

// The plan in work takes over within so many periods from the tick.
static int takes_over_within(nck_slope_t *self, uint32_t periods) {
    const double time = (double)periods * self->machine->period_s - nck_link_lead(self->link);
    return time > 0.0
           && cell_after(self, final_count(self), time, self->now.n) >= final_limit(self);
}

// The plan in work would take what is there now. late: the tick waits for it.
static int takes_what_is_there(nck_slope_t *self, uint32_t periods, int late) {
    if (self->kind == NCK_JOB_START) return periods > 0;
    return self->kind == NCK_JOB_GO_ON && (late || takes_over_within(self, periods));
}

int nck_slope_hurry(nck_slope_t *self, uint32_t periods) {
    const int goes_on = self->kind == NCK_JOB_GO_ON;
    const int late = goes_on && final_count(self) == final_limit(self) && is_late(self);
    if (self->phase == PHASE_IDLE) return periods > 0 && final_count(self) == self->now.n;
    if (self->phase != PHASE_MAKE || !takes_what_is_there(self, periods, late)) return 0;
    self->idle.status = NCK_OK;
    self->hurried = (uint32_t)late; // what does not join early is tried again
    nck_planner_hurry(self);
    return 1;
}

// A jerk-limited plan looks at pieces of the plan of now that the tick has passed, whether or not
// it has: setpoints must not hang on time. An optimal one looks at none before its own.
uint32_t nck_slope_needs(const nck_slope_t *self) {
    const int looks_back = nck_planner_kind(self) == NCK_SLOPE_JERK;
    return looks_back && final_count(self) < self->now.n ? self->now.first_piece : self->now.piece;
}

uint32_t nck_slope_price(const nck_slope_t *self) {
    return self->phase == PHASE_MAKE ? nck_planner_price(self) : 0;
}

int nck_slope_is_held(const nck_slope_t *self) {
    return self->now.held && final_count(self) >= self->now.n;
}

int nck_slope_invariants(const nck_slope_t *self) {
    const nck_plan_t *const now = &self->now;
    return self->phase <= PHASE_INSTALL && self->kind <= NCK_JOB_BRAKE
           && now->held <= NCK_HELD_BLOCK && (int32_t)(now->end_piece - now->piece) >= 0
           && (now->end_s == NCK_PLAN_BEGIN || now->end_s >= 0.0)
           && (now->complete || now->commit < now->n)
           && final_count(self) <= now->n
           && nck_plan_is_good(&self->wish);
}
