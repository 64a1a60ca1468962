// SPDX-License-Identifier: MIT
// The jerk-limited planner: a ladder of nodes over the pieces, its profile, its cells.
// README, section "Jerk".
//
//     pieces ─▶ lay ─▶ cap ─▶ brake ─▶ profile ─▶ cells of a tail
//                ▲
//     load ──────┘  the ladder of the plan of now
#ifndef NCK_PREP_JERK_H
#define NCK_PREP_JERK_H

#include "nck/base/limits.h"           // NCK_PROFILE_ROWS NCK_JERK_STATE
#include "nck/base/link.h"             // nck_link_t
#include "nck/base/machine.h"          // nck_machine_t
#include "nck/base/status.h"           // nck_status_t
#include "nck/prep/5_slope/plan.h"     // nck_plan_t nck_job_t nck_pieces_t
#include "nck/prep/5_slope/profile.h"  // nck_profile_t

// How a brake gives way behind the last cap that it has met: in the cell done last.
typedef struct nck_jerk_turn {
    double v;     // where that ends [mm/s]
    double a;     // [mm/s²]; what lets the next cell rise is none any more
    double share; // half of its duration [s]
} nck_jerk_turn_t;

// The jerk-limited planner: the plan in work, and the ladder that it stands on.
typedef NCK_JERK_STATE nck_jerk {
    const nck_machine_t *machine;
    nck_link_t *link;     // producer's side
    const nck_plan_t *now; // published
    nck_plan_t *next;     // in work
    nck_job_t job;        // that it is made for
    double step_s;        // D, what a cell lasts about [s]
    double hold_s;        // what cells of the plan of now last about in a hold's ladder [s]
    double margin_s;      // so near to the braking for the window's end a plan may still change [s]
    double long_steps;    // a cell at constant speed lasts so many D at most
    double q_cap;         // longest duration that counts in rule R [s]
    double j_scale;       // share of a piece's jerk that rule R plans with
    struct {
        uint32_t phase;
        uint32_t i;        // next cell to load, cap or draw
        uint32_t source;   // load: first cell; from the built tail or the published plan
        uint32_t from_built;
        uint32_t all;      // load: 1: every cell of the plan of now, not only up to its `keep`
        uint32_t coarse;   // 1: the plan in work only tells how to divide the ladder
        uint32_t n;        // cells of the ladder
        uint32_t room;     // lay: it may have so many
        uint32_t loaded;   // of them, those that an earlier plan had
        uint32_t piece;    // ladder's end
        double s;
        double pending;    // length of short pieces that wait to share a cell
        uint32_t pending_piece;
        double pending_s;
        double reach;      // rest within this length, for a hold; 0: no hold
        uint32_t part;     // reach: of the next cell
        uint32_t tries;    // of a hold, in vain
        uint32_t eases;    // brake: 1: it gives way in front of steps of the limits
        uint32_t redone;   // of a hold, on one ladder
        double j_cell;     // reach, check: jerk limit of the cell before
        double length;     // of the ladder so far
        double step;       // D of this plan: a hold's ladder has to fit [s]
        double time;       // duration of the cells drawn so far [s]
        double keep_time;  // the same up to where it brakes for the window's end [s]
        uint32_t sure;     // cells drawn that end further before that than margin_s …
        double sure_time;  // … and their duration [s]
        uint32_t base;     // lay: pieces from this one on …
        uint32_t pieces;   // … so many: what room 4 can hold whatever the tick has done
        double vv_entry;   // lay: about the largest v² at the piece's start
        double far;        // lay: how near its ends the ladder is finer [mm] …
        double far_s;      // … the first of which is so far behind its start
        double even;       // lay: the speed changes so near its ends at most [mm]
        uint32_t brakes_long; // draw: 1: in a long cell, for the ladder's end so far
        uint32_t uneven;   // 1: in a long cell that may become final the speed changes
        uint32_t divided;  // 1: such cells have been divided
        uint32_t must_rest; // 1: at the ladder's end it cannot go on: a stop, an override of zero
        uint32_t passes;   // block ends that came too early to rest at
        uint32_t to_pass;  // lay: of them, those still ahead
        uint32_t over;     // 1: limits for overrides beyond 100 %
        double vv_cell;    // cap of the cell before
        uint32_t lowered;  // limit: 1: a cap is below the speed that was taken over with its node
        uint32_t anew;     // 1: the whole ladder is laid anew, over the path of the plan of now
        uint32_t planned_cell; // brake: cell of that plan …
        double planned_at; // … so much path behind the ladder's begin [mm]
        double braked;     // path that the brake has gone through [mm]
        nck_jerk_turn_t turn; // brake: where it comes below caps
    } work;
    nck_profile_t profile;
    uint32_t rung_piece[NCK_PROFILE_ROWS]; // where every cell begins
    double rung_s[NCK_PROFILE_ROWS];
    double h[NCK_PROFILE_ROWS], vv_cap[NCK_PROFILE_ROWS];
    double a_max[NCK_PROFILE_ROWS], j_max[NCK_PROFILE_ROWS];
    double vv[NCK_PROFILE_ROWS];
} nck_jerk_t;

// What a cell of the ladder lasts about: D [s]. Cost: constant. Context: any.
double nck_jerk_cell_s(const nck_machine_t *machine);

// now, next: the slope's plans; next's begin, piece, s and over are set before a plan is begun.
// Cost: constant. Context: any, before the tick runs.
void nck_jerk_init(nck_jerk_t *self, const nck_machine_t *machine, nck_link_t *link,
                   const nck_plan_t *now, nck_plan_t *next);

// Begin to plan. Cost: constant. Context: prep.
void nck_jerk_begin(nck_jerk_t *self, const nck_job_t *job);

// One bounded piece of work. Returns NCK_OK (call again), NCK_EMPTY (needs pieces), NCK_DONE (the
// plan stands in the link's built tail), NCK_FULL (the plan of now rests as well as this one
// would), NCK_E_STATE (no plan joins here). Cost: NCK_JERK_STEP nodes of a pass, or cells.
// Context: prep.
nck_status_t nck_jerk_step(nck_jerk_t *self, const nck_pieces_t *pieces);

// The plan in work takes what is known: nothing more comes before the tick needs it.
// Cost: constant. Context: prep.
void nck_jerk_hurry(nck_jerk_t *self);

#endif
