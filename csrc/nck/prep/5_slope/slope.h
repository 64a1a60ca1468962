// SPDX-License-Identifier: MIT
// Room 5, slope: pieces of path become plans, and plans become final cells bit by bit.
//
//     pieces ─▶ planner of the slope in force ─▶ next: the plan in work
//                                                  │ install
//                                                  ▼
//                         hold, resume ─▶ now: published; its first cells are final
//
// Planners of one shape (begin, step): linear, jerk and optimal. A plan goes on from the
// moving state where the last one is left, and ends at rest. Hold, override, single block and abort
// are plans like any other.
#ifndef NCK_PREP_SLOPE_H
#define NCK_PREP_SLOPE_H

#include "nck/base/fence.h"           // nck_fence_load
#include "nck/base/link.h"            // nck_link_t
#include "nck/base/machine.h"         // nck_machine_t
#include "nck/base/status.h"          // nck_status_t
#include "nck/base/terms.h"           // nck_terms_t
#include "nck/prep/5_slope/jerk.h"    // nck_jerk_t
#include "nck/prep/5_slope/linear.h"  // nck_linear_t
#include "nck/prep/5_slope/optimal.h" // nck_optimal_t
#include "nck/prep/5_slope/plan.h"    // nck_plan_t nck_pieces_t nck_wish_t

// The room's state: plan after plan, and what the operator wants of them.
typedef struct nck_slope {
    const nck_machine_t *machine;
    const nck_terms_t *terms;
    nck_link_t *link;      // producer's side
    nck_wish_t wish;
    double lead_s;         // duration of the cells that are final ahead of the tick [s]
    uint32_t phase;        // of the plan in work
    uint32_t kind;         // nck_job_kind_t of it
    nck_plan_t now;        // published
    nck_plan_t next;       // in work
    struct {
        uint32_t pending;  // 1: the plan in work answers the operator
        uint32_t slower;   // 1: an override has come down
        double reserve_s;  // that are to pass until it takes over, at least [s]
    } answer;
    uint32_t anew;         // 1: the next plan does not begin where the plan of now meant it to
    uint32_t resumes;      // as counted when the plan of now was installed
    struct {
        uint32_t taken;    // cells that the tick had taken when the plan in work was begun
        uint32_t end;      // cells that were final then
        double lead_s;     // how long those lasted that the tick had not taken [s]
    } begun;
    double spent_s;        // that passed while the last plan was made [s]
    uint32_t waits;        // 1: single block keeps the path behind now; any context reads
    uint32_t brakes;       // 1: the plan of now brings the rest asked for; any context reads
    uint32_t in_tail;      // 1: the tick has been seen in the stop tail
    uint32_t stands;       // 1: its clock stands, amid a clocked path
    uint32_t clocked;      // 1: the plan of now is along such a one, whatever comes behind it
    struct {
        uint32_t status;   // what the last step said, which lacked pieces; NCK_FULL: or what the
                           // tick takes; NCK_OK: none such. As things were then:
        uint32_t taken;    // the cells that the tick had taken, …
        uint32_t barrier;  // … the piece behind the window's barrier; 0: it had none …
        uint32_t complete; // … and whether it was complete; it can do nothing …
        uint32_t wants;    // … before all pieces up to this number are known
    } idle;
    uint32_t hurried;      // 1: the plan in work takes what is known …
    uint32_t awaits_tail;  // … 1: and did not join: the path starves
    uint32_t kind_in_force; // nck_slope_kind_t of the planner in force
    union {                // of the plan in work, by it
        nck_linear_t linear;
        nck_jerk_t jerk;
        NCK_OPTIMAL_MEMBER(nck_motion_t, motion) // of `optimal`
    } planner;
    NCK_OPTIMAL_MEMBER(nck_optimal_t, optimal) // what it keeps from plan to plan
} nck_slope_t;

// Fill in what the machine's slope means to the other rooms. Once more after a change of limits.
// Cost: constant. Context: prep.
void nck_slope_terms(const nck_machine_t *machine, nck_terms_t *terms_out);

// At rest where the link ends. Cost: linear in the capacities. Context: any, before the tick runs.
void nck_slope_init(nck_slope_t *self, const nck_terms_t *terms, nck_link_t *link);

// One bounded piece of work. Returns NCK_OK (call again), NCK_EMPTY (needs pieces), NCK_FULL (waits
// for the tick, or is held), NCK_E_INTERNAL (a broken plan, see nck_link_publish).
// Cost: a step of the planner in force. Context: prep.
nck_status_t nck_slope_step(nck_slope_t *self, const nck_pieces_t *pieces, const nck_wish_t *wish);

// The piece behind the newest WAIT; 0: there is none. Cost: constant.
static inline uint32_t nck_slope_barrier(const nck_pieces_t *pieces) {
    return pieces->barrier > 0 ? pieces->head + pieces->barrier : 0;
}

// 1 if the last step needed pieces, and these bring nothing that it lacked. Cost: constant.
// Context: prep.
static inline int nck_slope_lacks_pieces(const nck_slope_t *self, const nck_pieces_t *pieces) {
    return self->idle.status != NCK_OK
           && (int32_t)(self->idle.wants - pieces->head - pieces->fill) > 0
           && pieces->complete == self->idle.complete
           && nck_slope_barrier(pieces) == self->idle.barrier;
}

// The same, and the tick brings nothing either: under the same wish a step would say `idle.status`
// again. Cost: constant. Context: prep.
static inline int nck_slope_lacks(const nck_slope_t *self, const nck_pieces_t *pieces) {
    int entered = 0;
    (void)nck_link_end(self->link, &entered);
    return nck_slope_lacks_pieces(self, pieces) && (!entered || self->in_tail)
           && (self->idle.status == NCK_EMPTY || nck_link_taken(self->link) == self->idle.taken);
}

// How long the path lasts, by its clock and to where it is known, that a plan from rest waits for
// more of [s]; 0: none does, or the path has no clock. Cost: constant. Context: prep.
double nck_slope_known_s(const nck_slope_t *self);

// Nothing more is known of the path. If the tick is about to run out of final cells, the plan in
// work takes what is there; so it does where it takes over within so many periods, or begins at
// rest and periods is not 0. Returns 1 if it would take more of the path than is known.
// Cost: linear in periods. Context: prep.
int nck_slope_hurry(nck_slope_t *self, uint32_t periods);

// The number of the oldest piece that is still needed. Cost: constant. Context: prep.
uint32_t nck_slope_needs(const nck_slope_t *self);

// 1 if every plan is final and has come to rest by a hold. Cost: constant. Context: prep.
int nck_slope_is_held(const nck_slope_t *self);

// 1 if the plan in work answers the operator: other wishes would have it begin anew.
// Cost: constant. Context: prep.
static inline int nck_slope_is_answering(const nck_slope_t *self) {
    return self->answer.pending != 0;
}

// What the next step takes at most, in hundreds of a PC's instructions; 0: other rooms may have
// their turn. Cost: constant. Context: prep.
uint32_t nck_slope_price(const nck_slope_t *self);

// 1 if the plan in work is along a clocked path. Cost: constant. Context: prep.
static inline int nck_slope_plans_clocked(const nck_slope_t *self) {
    return self->kind_in_force == NCK_SLOPE_OPTIMAL;
}

// 1 if the plan of now is. Cost: constant. Context: prep.
static inline int nck_slope_is_clocked(const nck_slope_t *self) {
    return self->clocked != 0;
}

// 1 if the plan in force brings the rest that a hold or an override of 0 asks for. Cost: constant.
// Context: any.
static inline int nck_slope_brakes(const nck_slope_t *self) {
    return nck_fence_load(&self->brakes) != 0;
}

// 1 if single block keeps the path where the plan of now rests. Cost: constant. Context: any.
static inline int nck_slope_waits(const nck_slope_t *self) {
    return nck_fence_load(&self->waits) != 0;
}

// Every invariant of the room, for tests: 1 if all hold. Cost: constant. Context: prep.
int nck_slope_invariants(const nck_slope_t *self);

#endif
