// SPDX-License-Identifier: MIT
// Inside room 5: what a plan is, and what the planners are asked for. Face: slope.h.
#ifndef NCK_PREP_PLAN_H
#define NCK_PREP_PLAN_H

#include "nck/base/budget.h"  // NCK_OVERRIDE_TOP
#include "nck/base/link.h"    // nck_link_t
#include "nck/base/real.h"    // NCK_ONCE nck_min
#include "nck/base/records.h" // nck_node_t nck_cell_t

// Room 4's window of pieces as this room sees it. Pieces have running numbers.
typedef struct nck_pieces {
    nck_node_t *at;       // ring of NCK_NODE_MAX; the linear slope writes the envelope into it
    uint32_t head;        // number of the oldest
    uint32_t fill;        // pieces in the window
    uint32_t barrier;     // pieces from the oldest on up to and with the newest WAIT; 0: none
    uint32_t complete;    // 1: no more come before the path is at rest
} nck_pieces_t;

// Faster than any tool: no limit that the operator sets [mm/s].
#define NCK_WISH_FREE 1e9

// What the operator wants, as of now.
typedef struct nck_wish {
    double feed;           // override, 0 … 2
    double rapid;          // override, 0 … 1
    double tool;           // as fast as the tool may be [mm/s]; NCK_WISH_FREE: no such limit
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

// As a coordinate in a piece: where the piece begins, once it is known.
#define NCK_PLAN_BEGIN (-1.0)

// A place on the path, and a plan from there on.
typedef struct nck_plan {
    uint32_t begin;    // its first cell follows so many final cells (as nck_link_end counts)
    uint32_t n;        // cells
    uint32_t first_piece; // where it begins
    uint32_t piece;    // where the first cell that is not final begins
    double s;          // path coordinate there, in the piece's seg
    uint32_t end_piece; // where it comes to rest
    double end_s;      // path coordinate there; NCK_PLAN_BEGIN or in that piece
    uint32_t complete; // 1: the path rests there, not only the window
    uint32_t held;     // nck_held_t: what must happen before it goes on
    uint32_t commit;   // so many of its cells may become final before the next plan takes over
    uint32_t keep;     // behind this cell it brakes for the window's end only
    uint32_t over;     // 1: an override beyond 100 % has been in force since it was last at rest
    uint32_t wants;    // in work: pieces before this number must be known before it can go on
} nck_plan_t;

// What a plan is made for.
typedef enum nck_job_kind {
    NCK_JOB_START = 0, // from the rest at the end of the plan of now
    NCK_JOB_GO_ON = 1, // from the moving state behind some cells of the plan of now
    NCK_JOB_BRAKE = 2  // from there to rest
} nck_job_kind_t;

// What a planner is asked for.
typedef struct nck_job {
    uint32_t kind;     // nck_job_kind_t
    uint32_t held;     // brake: nck_held_t of the rest
    uint32_t anew;     // 1: not where the plan of now meant to be followed, or other wishes
    uint32_t slower;   // 1: the plan of now is for higher speeds
    uint32_t starved;  // 1: the tick has run out of cells, or is about to: take what is there
    nck_wish_t wish;
    double v;          // speed where it begins [path mm/s]
    double a;          // acceleration at the end of the cell before [path mm/s²]
    double q;          // duration of that cell [s]; 0: from rest
} nck_job_t;

// Room 4's piece of a running number that is there; else it must not be asked for anything.
// Cost: constant.
static NCK_ONCE nck_node_t *nck_plan_there(const nck_pieces_t *pieces, uint32_t number) {
    return &pieces->at[number & (NCK_NODE_MAX - 1)];
}

// The place in the ring behind a piece's. Cost: constant.
static inline nck_node_t *nck_plan_behind(const nck_pieces_t *pieces, nck_node_t *piece) {
    return piece + 1 == &pieces->at[NCK_NODE_MAX] ? pieces->at : piece + 1;
}

// Room 4's piece of a running number; NULL if it is not there (yet). Cost: constant.
static inline nck_node_t *nck_plan_piece(const nck_pieces_t *pieces, uint32_t number) {
    if (number - pieces->head >= pieces->fill) return (nck_node_t *)0;
    return nck_plan_there(pieces, number);
}

// The piece in which a cell begins, from a piece at or before it. Cost: linear in the pieces
// between.
uint32_t nck_plan_find(const nck_pieces_t *pieces, uint32_t number, const nck_cell_t *cell);

// Cap of a piece under overrides, v². over: by the limits for overrides beyond 100 %.
// Cost: constant.
static inline double nck_plan_cap(const nck_node_t *piece, const nck_wish_t *wish, uint32_t over) {
    const double cap = over ? piece->vv_over : piece->vv_piece;
    const double v = piece->feed * wish->feed;
    const double scaled =
        piece->feed > 0.0 ? nck_min(cap, v * v) : cap * wish->rapid * wish->rapid;
    if (wish->tool == NCK_WISH_FREE || !(piece->tool > 0.0f)) return scaled;
    const double most = wish->tool / (double)piece->tool;
    return nck_min(scaled, most * most);
}

// 1 if two wishes ask for different plans; resumes apart. Cost: constant.
int nck_plan_is_other(const nck_wish_t *a, const nck_wish_t *b);

// 1 if every wish is within its range, for tests. Cost: constant.
int nck_plan_is_good(const nck_wish_t *wish);

// 1 if under these wishes every cap is what room 4 has found, to the bit. Cost: constant.
int nck_plan_is_plain(const nck_wish_t *wish, uint32_t over);

// Cap of the node at the start of a piece that is there, v²; but for plain wishes. Cost: constant.
double nck_plan_at(const nck_pieces_t *pieces, uint32_t number, const nck_wish_t *wish,
                   uint32_t over);

// v² at which a piece leaves what its limits say, over or not: the smallest cap of it and of the
// node at its start; a rest at the node is none. Cost: constant.
static inline double nck_plan_limits_at(const nck_node_t *piece, uint32_t over) {
    const double inside = over ? piece->vv_over : piece->vv_piece;
    const double node = over ? piece->vv_node : piece->vv_cap;
    const double cap = node > 0.0 ? nck_min(inside, node) : inside;
    const double v = NCK_OVERRIDE_TOP * piece->feed;
    return over && piece->feed > 0.0 ? nck_min(cap, v * v) : cap;
}

// 1 if a piece is beyond so many blocks, counted from the one that the first piece is of. A look-
// ahead of several blocks sees two segs at least: a spline's may be as long as many blocks, and at
// the end of what is seen the path rests. Cost: constant.
int nck_plan_is_beyond(const nck_link_t *link, const nck_node_t *first, const nck_node_t *piece,
                       uint32_t blocks);

// 1 if the piece of this number, which has one behind it, ends its block. Cost: constant.
int nck_plan_ends_block(const nck_link_t *link, const nck_pieces_t *pieces, uint32_t number);

#endif
