// SPDX-License-Identifier: MIT
// The jerk-limited slope: pieces of path become plans, each from the moving state where the last
// one is left to rest, and plans become final cells bit by bit. Hold, override and single block are
// plans like any other. README, section "Jerk".
//
//     pieces ─▶ lay ─▶ cap ─▶ plan ─▶ draw ─▶ install        next: the plan in work
//                ▲                      │         │
//                └──── load ◀───────────┴─────────┤
//                                                 └─▶ now: published; its first cells are final
#ifndef NCK_PREP_JERK_H
#define NCK_PREP_JERK_H

#include "nck/base/limits.h"           // NCK_PROFILE
#include "nck/base/link.h"             // nck_link_t
#include "nck/base/machine.h"          // nck_machine_t
#include "nck/base/records.h"          // nck_node_t
#include "nck/base/status.h"           // nck_status_t
#include "nck/prep/5_slope/profile.h"  // nck_profile_t

// Room 4's window of pieces as this room sees it. Pieces have running numbers.
typedef struct nck_pieces {
    const nck_node_t *at; // ring of NCK_WINDOW
    uint32_t head;        // number of the oldest
    uint32_t fill;        // pieces in the window
} nck_pieces_t;

// What the operator wants, as of now.
typedef struct nck_wish {
    double feed;           // override, 0 … 2
    double rapid;          // override, 0 … 1
    uint32_t hold;         // 1: rest, and stay
    uint32_t single_block; // 1: rest at the end of every block, and stay
    uint32_t resumes;      // counts up when the operator wants to go on
} nck_wish_t;

// What keeps the path at rest behind a plan.
typedef enum nck_held {
    NCK_HELD_NOT = 0,
    NCK_HELD_RESUME = 1,  // until the operator wants to go on
    NCK_HELD_OVERRIDE = 2, // until the override is no longer zero
    NCK_HELD_BLOCK = 3    // at a block's end, until the operator wants to go on
} nck_held_t;

// A place on the path, and a plan from there on.
typedef struct nck_jerk_plan {
    uint32_t begin;    // its first cell follows so many final cells (as nck_link_end counts)
    uint32_t n;        // cells
    uint32_t first_piece; // where it begins
    uint32_t piece;    // where the first cell that is not final begins
    double s;          // path coordinate there, in the piece's seg
    uint32_t end_piece; // where it comes to rest
    double end_s;      // path coordinate there; negative: where that piece begins
    uint32_t complete; // 1: the path rests there, not only the window
    uint32_t held;     // nck_held_t: what must happen before it goes on
    uint32_t commit;   // so many of its cells may become final before the next plan takes over
    uint32_t keep;     // behind this cell it brakes for the window's end only
    uint32_t over;     // 1: an override beyond 100 % has been in force since it was last at rest
} nck_jerk_plan_t;

typedef struct nck_jerk {
    const nck_machine_t *machine;
    nck_link_t *link;     // producer's side
    nck_wish_t wish;
    double step_s;        // D, what a cell lasts about [s]
    double q_cap;         // longest duration that counts in rule R [s]
    double j_scale;       // share of a piece's jerk that rule R plans with
    double lead_s;        // duration of the cells that are final ahead of the tick [s]
    nck_jerk_plan_t now;
    nck_jerk_plan_t next;
    struct {
        uint32_t phase;
        uint32_t i;        // next cell to load, cap or draw
        uint32_t source;   // load: first cell; from the built tail or the published plan
        uint32_t from_built;
        uint32_t all;      // load: 1: every cell of the plan of now, not only up to its `keep`
        uint32_t coarse;   // 1: the plan in work only tells how to divide the ladder
        uint32_t n;        // cells of the ladder
        uint32_t loaded;   // of them, those that an earlier plan had
        uint32_t piece;    // ladder's end
        double s;
        double pending;    // length of short pieces that wait to share a cell
        uint32_t pending_piece;
        double pending_s;
        double reach;      // rest within this length, for a hold; 0: no hold
        double length;     // of the ladder so far
        double step;       // D of this plan: a hold's ladder has to fit [s]
        double time;       // duration of the cells drawn so far [s]
        uint32_t base;     // lay: pieces from this one on …
        uint32_t pieces;   // … so many: what room 4 can hold whatever the tick has done
        double w_entry;    // lay: about the largest v² at the piece's start
        double far;        // lay: how near its ends the ladder is finer [mm]
        uint32_t must_rest; // 1: at the ladder's end it cannot go on: a stop, an override of zero
        uint32_t passes;   // block ends that came too early to rest at
        uint32_t to_pass;  // lay: of them, those still ahead
        uint32_t over;     // 1: limits for overrides beyond 100 %
        double w_cell;     // cap of the cell before
        uint32_t anew;     // 1: the whole ladder is laid anew, over the path of the plan of now
        uint32_t planned_cell; // brake: cell of that plan …
        double planned_at; // … so much path behind the ladder's begin [mm]
        double braked;     // path that the brake has gone through [mm]
        nck_wish_t wish;   // that the plan is made for
    } work;
    struct {
        uint32_t pending;  // 1: the plan in work answers the operator
        uint32_t slower;   // 1: an override has come down
        uint32_t reserve;  // cells that are to pass until it takes over, at least
    } answer;
    uint32_t resumes;      // as counted when the plan of now was installed
    uint32_t taken;        // cells that the tick had taken when the plan in work was begun
    uint32_t spent;        // cells that it took while the last plan was made
    uint32_t in_tail;      // 1: the tick has been seen in the stop tail
    uint32_t failures;     // plans that did not join, since nck_jerk_init
    nck_profile_t profile;
    uint32_t rung_piece[NCK_PROFILE]; // where every cell begins
    double rung_s[NCK_PROFILE];
    double h[NCK_PROFILE], w_cap[NCK_PROFILE], a_max[NCK_PROFILE], j_max[NCK_PROFILE];
    double w[NCK_PROFILE], s[NCK_PROFILE], up[NCK_PROFILE], down[NCK_PROFILE];
    double e[NCK_PROFILE], z[NCK_PROFILE];
    uint32_t stack[NCK_PROFILE];
} nck_jerk_t;

// Cost: constant. Context: any, before the tick runs.
void nck_jerk_init(nck_jerk_t *self, const nck_machine_t *machine, nck_link_t *link);

// One bounded piece of work. Returns NCK_OK (call again), NCK_EMPTY (needs pieces), NCK_FULL (waits
// for the tick, or is held), NCK_E_INTERNAL (a broken plan, see nck_link_publish).
// Cost: 32 nodes of a pass, or 32 cells. Context: prep.
nck_status_t nck_jerk_step(nck_jerk_t *self, const nck_pieces_t *pieces, const nck_wish_t *wish);

// The number of the oldest piece that is still needed. Cost: constant. Context: prep.
uint32_t nck_jerk_needs(const nck_jerk_t *self);

// 1 if every plan is final and has come to rest by a hold. Cost: constant. Context: prep.
int nck_jerk_is_held(const nck_jerk_t *self);

#endif
