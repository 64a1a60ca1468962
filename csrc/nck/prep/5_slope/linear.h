// SPDX-License-Identifier: MIT
// The acceleration-limited planner: the exact two-pass envelope over a view of the window, a
// trapezoid over each piece, and a brake behind the part that may become final.
// README, section "Linear".
//
//     pieces ─▶ [floor] ─▶ backward ─▶ forward ─▶ part ─▶ brake
//                                                   ▲        │
//                                                   └────────┘ (the envelope serves many parts)
#ifndef NCK_PREP_LINEAR_H
#define NCK_PREP_LINEAR_H

#include "nck/base/limits.h"         // NCK_WINDOW NCK_TAIL_MAX
#include "nck/base/link.h"           // nck_link_t
#include "nck/base/machine.h"        // nck_machine_t
#include "nck/base/status.h"         // nck_status_t
#include "nck/prep/5_slope/legs.h"   // nck_legs_t
#include "nck/prep/5_slope/plan.h"   // nck_plan_t nck_job_t nck_pieces_t

// How much one plan takes on.
enum {
    NCK_LINEAR_VIEW = 4 * (NCK_WINDOW - 8) / 5, // pieces that an envelope is computed for at most
    NCK_LINEAR_FINAL = 4, // of them, one in so many become final; their room is kept till then
    NCK_LINEAR_PART = NCK_TAIL_MAX - NCK_LINEAR_VIEW - 4 // cells of a part at most
};

// A place on the path, and how fast it is passed.
typedef struct nck_linear_place {
    uint32_t piece; // running number
    uint32_t fresh; // 1: where that piece begins; s is not set
    double s;       // path coordinate in the piece's seg [path mm]
    double vv;      // v² there
} nck_linear_place_t;

// The linear planner: an envelope in work, and the parts of it that are drawn.
typedef struct nck_linear {
    const nck_machine_t *machine;
    nck_link_t *link;      // producer's side
    nck_plan_t *next;      // in work
    nck_job_t job;         // that it is made for
    uint8_t phase;
    uint8_t is_plain;      // 1: under its wishes all caps are as room 4 has found them
    uint8_t held;          // nck_held_t of the rest behind the final pieces
    uint8_t reserved;      // 0
    uint32_t final;        // the envelope holds for the pieces before this number …
    uint32_t end;          // … and comes to rest before this one
    uint32_t skip;         // block ends up to this piece come too early to rest at
    uint32_t part;         // cells of the part so far
    nck_linear_place_t at;    // how far the part is drawn
    nck_linear_place_t brake; // how far the brake behind it is drawn

    struct {
        uint32_t begin;    // from this node on the last backward pass …
        uint32_t end;      // … holds up to this one
    } known;

    struct {
        uint32_t i;        // next node
        uint32_t floor;    // nodes before this one are raised to what the path can brake to
        uint32_t known;    // nodes before this one have what the last backward pass has found
        uint32_t open;     // 1: no cap met yet on the way from the view's end
        double vv;         // v² at the node last done
    } pass;

    nck_legs_t legs;       // of the piece in work
    double vv_out;         // v² at its end
} nck_linear_t;

// next: the slope's plan in work; its begin, piece, s and over are set before a plan is begun.
// Cost: constant. Context: any, before the tick runs.
void nck_linear_init(nck_linear_t *self, const nck_machine_t *machine, nck_link_t *link,
                     nck_plan_t *next);

// Begin to plan. Cost: constant. Context: prep.
void nck_linear_begin(nck_linear_t *self, const nck_job_t *job);

// One bounded piece of work. Returns NCK_OK (call again), NCK_EMPTY (needs pieces), NCK_DONE (the
// plan stands in the link's built tail), NCK_E_STATE (no plan joins here). Cost: 32 nodes of a
// pass, or 32 cells; with lookahead_blocks, the pieces of so many blocks. Context: prep.
nck_status_t nck_linear_step(nck_linear_t *self, const nck_pieces_t *pieces);

// The plan in work takes what is known: nothing more comes before the tick needs it.
// Cost: constant. Context: prep.
void nck_linear_hurry(nck_linear_t *self);

#endif
