// SPDX-License-Identifier: MIT
// The classical S-shaped planner: acceleration is zero at every junction.
// README, section "S-shape".
//
//     [follow] ─▶ look ─▶ speeds ─▶ part ─▶ brake        a hold: follow ─▶ brake within the hop,
//                  ▲                 │                            else the jerk-limited planner's
//                  └─────────────────┘ (a hop at a time)
#ifndef NCK_PREP_SSHAPE_H
#define NCK_PREP_SSHAPE_H

#include "nck/base/limits.h"               // NCK_WINDOW NCK_SSHAPE_STATE
#include "nck/base/link.h"                 // nck_link_t
#include "nck/base/machine.h"              // nck_machine_t
#include "nck/base/status.h"               // nck_status_t
#include "nck/prep/5_slope/jerk.h"         // nck_jerk_t
#include "nck/prep/5_slope/legs.h"         // nck_legs_t
#include "nck/prep/5_slope/plan.h"         // nck_plan_t nck_job_t nck_pieces_t
#include "nck/prep/5_slope/sshape_piece.h" // nck_sshape_course_t
#include "nck/prep/5_slope/sshape_hop.h"   // nck_sshape_hop_t

// A place on the path that is passed without acceleration, or in the middle of a leg.
typedef struct nck_sshape_place {
    uint32_t piece; // running number of the hop's first piece
    uint32_t fresh; // 1: where that piece begins; s is not set
    double s;       // path coordinate in the hop's seg [path mm]
    double v;       // speed there [path mm/s]
} nck_sshape_place_t;

// The look-ahead, in pieces.
typedef NCK_SSHAPE_STATE nck_sshape_ahead {
    uint32_t horizon;    // it sees the pieces before this one, and assumes rest there
    uint32_t looks;      // 1: it is being moved on
    uint32_t back;       // 1: the speeds up to it are being found
    uint32_t was;        // horizon that the speeds were last computed for
    uint32_t i;          // backward: the next node
    uint32_t capped;     // the last node known whose own cap holds it; lower ones behind are held
                         // by the horizon
    uint32_t raised;     // nodes up to this one are raised to what the path can brake to
    double v_floor;      // that speed at the horizon [mm/s]
    double v[NCK_WINDOW]; // speed at a hop's start from which the horizon's rest is possible
    double floor[NCK_WINDOW]; // speed that a node is raised to
    uint8_t pieces[NCK_WINDOW]; // of the hop that begins with a piece; 0: within a hop
} nck_sshape_ahead_t;

// The planner of the classical S-shape.
typedef NCK_SSHAPE_STATE nck_sshape {
    const nck_machine_t *machine;
    nck_link_t *link;       // producer's side
    const nck_plan_t *now;  // published
    nck_plan_t *next;       // in work
    nck_job_t job;          // that it is made for
    uint32_t phase;
    uint32_t i;             // follow: next cell of the plan of now
    uint32_t follows;       // 1: a ramp in work is followed to its end
    uint32_t checks;        // 1: the plan must join the speed that it begins with
    uint32_t skip;          // block ends up to this piece come too early to rest at
    uint32_t cells;         // of the plan so far
    double time;            // that those of its part last [s]
    nck_sshape_place_t at;  // how far the part is drawn
    nck_sshape_place_t brake; // how far the brake behind it is drawn
    struct {
        uint32_t set;       // 1: known for the hop at `at`
        uint32_t stage;     // what comes next: rise, cruise or fall
        uint32_t held;      // nck_held_t of the rest at its end
        nck_sshape_hop_t hop;
        nck_sshape_course_t way;
        double s;           // where the stage in work ends …
        double v;           // … and how fast
    } course;
    nck_legs_t legs;        // of the stage in work
    union {
        nck_sshape_ahead_t ahead;
        nck_jerk_t carry;   // a hold across junctions carries acceleration; what follows looks anew
    } memory;
} nck_sshape_t;

// now, next: the slope's plans; next's begin, piece, s and over are set before a plan is begun.
// Cost: constant. Context: any, before the tick hops.
void nck_sshape_init(nck_sshape_t *self, const nck_machine_t *machine, nck_link_t *link,
                     const nck_plan_t *now, nck_plan_t *next);

// Begin to plan. Cost: constant. Context: prep.
void nck_sshape_begin(nck_sshape_t *self, const nck_job_t *job);

// One bounded piece of work. Returns NCK_OK (call again), NCK_EMPTY (needs pieces), NCK_DONE (the
// plan stands in the link's built tail), NCK_FULL (the plan of now rests as well as this one
// would), NCK_E_STATE (no plan joins here), NCK_E_INTERNAL (a broken plan). Cost: 32 pieces looked
// at or their speeds found, or 32 cells of one hop, or eight hops braked through; a hold across
// junctions as nck_jerk_step. Context: prep.
nck_status_t nck_sshape_step(nck_sshape_t *self, const nck_pieces_t *pieces);

// The plan in work takes what is known: nothing more comes before the tick needs it.
// Cost: constant. Context: prep.
void nck_sshape_hurry(nck_sshape_t *self);

#endif
