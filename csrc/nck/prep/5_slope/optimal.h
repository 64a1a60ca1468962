// SPDX-License-Identifier: MIT
// The jerk-limited planner on a clocked path: the fastest motion that every axis allows along it,
// by convex optimisation (base/motion.h), window after window. README, section "Optimal".
//
//     pieces ─▶ lay: nodes, their derivatives and caps ─▶ solve ─▶ draw: two cells an interval
//
// A clocked path is a chain of splines, each of which lasts a knot of the clock
// (nck_terms_t.knot_s) and goes on into the next one with both derivatives by it. A plan goes over
// from the one before in the middle of an interval, where both have the same speed and
// acceleration.
#ifndef NCK_PREP_OPTIMAL_H
#define NCK_PREP_OPTIMAL_H

#include "nck/base/link.h"         // nck_link_t
#include "nck/base/motion.h"       // nck_motion_t NCK_MOTION_NODES
#include "nck/base/status.h"       // nck_status_t
#include "nck/base/terms.h"        // nck_terms_t
#include "nck/prep/5_slope/plan.h" // nck_plan_t nck_job_t nck_pieces_t

// The pace of the clock at the nodes of a plan: b = (du/dt)².
typedef struct nck_optimal_pace {
    uint32_t begin;  // of the plan, as nck_plan_t.begin
    uint32_t first;  // the piece that node 0 is the begin of
    uint32_t n;      // intervals
    uint32_t ends;   // 1: the path rests at the last node
    uint32_t top;    // behind this node it brakes for the window's end
    uint32_t drawn;  // 1: all of it is known
    double b[NCK_MOTION_NODES];
    float along[NCK_MOTION_NODES]; // |p′|² [(mm/s)²]
} nck_optimal_pace_t;

// Intervals about a node that are looked at, and places of each: quarters.
enum { NCK_OPTIMAL_LOOKS = 6, NCK_OPTIMAL_PLACES = 5 };

// How fast the path goes by its clock in an interval.
typedef struct nck_optimal_look {
    uint32_t number;  // of the piece
    uint32_t known;   // 1: by this plan
    nck_num along[NCK_OPTIMAL_PLACES]; // |p′|² [(mm/s)²]
} nck_optimal_look_t;

// The planner: a window in work, and the pace of the plan before.
typedef struct nck_optimal {
    const nck_terms_t *terms;
    nck_link_t *link;      // producer's side
    const nck_plan_t *now; // published
    nck_plan_t *next;      // in work
    nck_job_t job;         // that it is made for
    uint32_t phase;
    uint32_t i;            // the node filled next, or the interval drawn next
    uint32_t drawn;        // which of the two paces is that of the plan of now
    uint32_t cells;        // drawn so far
    uint32_t seam;         // the cell that the next plan begins with …
    uint32_t at_rest;      // 1: the path rests where the window begins
    uint32_t takes_over;   // … the second half of this interval
    double j_least;        // of any axis' jerk [mm/s³]
    double slower;         // the share that caps are lowered to of the speed now
    double vv_most;        // the most v² that is about to be
    uint8_t held_by[NCK_MOTION_NODES]; // nck_limit_t that caps a node
    nck_optimal_look_t looked[NCK_OPTIMAL_LOOKS];
    nck_optimal_pace_t pace[2];
    nck_motion_t *motion;  // of the window in work; each plan begins it
} nck_optimal_t;

// now, next: the slope's plans, published and in work; motion: what the planner works in from the
// begin of a plan to its end. Cost: constant. Context: any, before the tick runs.
void nck_optimal_init(nck_optimal_t *self, const nck_terms_t *terms, nck_link_t *link,
                      const nck_plan_t *now, nck_plan_t *next, nck_motion_t *motion);

// Begin to plan. Cost: linear in the nodes of a window. Context: prep.
void nck_optimal_begin(nck_optimal_t *self, const nck_job_t *job);

// One bounded piece of work. Returns NCK_OK (call again), NCK_EMPTY (needs pieces), NCK_DONE (the
// plan stands in the link's built tail), NCK_E_STATE (no plan joins here). Cost: a step of
// nck_motion_step, 4 nodes or up to 39 cells. Context: prep.
nck_status_t nck_optimal_step(nck_optimal_t *self, const nck_pieces_t *pieces);

// What the next step takes at most, in hundreds of a PC's instructions; 0: it may wait for pieces.
// Cost: constant. Context: prep.
uint32_t nck_optimal_price(const nck_optimal_t *self);

// Intervals of the plan in work that are known, while it waits for more. Cost: constant.
// Context: prep.
uint32_t nck_optimal_laid(const nck_optimal_t *self);

// The plan in work takes what is known: nothing more comes before the tick needs it.
// Cost: constant. Context: prep.
void nck_optimal_hurry(nck_optimal_t *self);

// The first cell of the plan of now, from this one on, that begins where another plan can take
// over. Cost: constant. Context: prep.
uint32_t nck_optimal_seam(const nck_optimal_t *self, uint32_t cell);

#endif
