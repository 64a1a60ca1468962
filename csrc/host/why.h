// SPDX-License-Identifier: MIT
// Why a plan takes its time: every moment belongs to one limit, every ramp to the low point that it
// serves.
//
//     segs, nodes, cells as they become final ─▶ pieces of path with their time ─▶ ideal, causes
//
// The ideal is the time at the programmed feed, or at the speed of rapids, and of the programmed
// rests. What is more is lost: over a slower cap of the piece itself (an arc) to that cap, over a
// ramp to the low point at its foot. Between two low points the ramp up from the first ends where
// the path is fastest, and the ramp down to the second begins. Low points are nodes that hold the
// path; along a clocked path, which has no cap but the feed, the places where it is slowest.
#ifndef NCK_HOST_WHY_H
#define NCK_HOST_WHY_H

#include "host/cause.h"      // nck_host_cause_t
#include "host/share.h"      // nck_host_shares_t
#include "host/trail.h"      // nck_host_trail_t
#include "nck/base/limits.h" // NCK_WINDOW
#include "nck/base/terms.h"  // nck_terms_t
#include "nck/nck_tools.h"         // nck_t

#ifdef __cplusplus
extern "C" {
#endif

// Rows that are kept, powers of two: segs that are not executed, and pieces that the kernel has
// dropped before their cells were taken.
enum {
    NCK_HOST_WHY_SEGS = 4 * NCK_WINDOW, NCK_HOST_WHY_PIECES = 2 * NCK_WINDOW
};

// Of a seg, what its nodes and cells need.
typedef struct nck_host_why_seg {
    uint32_t line;
    uint16_t axis;              // that has the most of the corner at its start
    uint8_t stop;               // 1: exact stop at its end
    uint8_t clocked;            // 1: an interval of a clocked path, or the rest before the first
    double s_begin;             // path before it [path mm]
    double less, more;          // |a − b|² and |a + b|² of the tangents a, b at its start
} nck_host_why_seg_t;

// A node and the piece behind it.
typedef struct nck_host_why_piece {
    uint32_t seg;
    uint8_t limit, limit_piece; // as in the node
    uint8_t kind;               // nck_seg_kind_t
    uint8_t rapid;              // 1: G0
    double s_end;               // path to its end [path mm]
    double v_node;              // cap at its start [path mm/s]
    double v_cap;               // cap inside [path mm/s]
    double v_feed;              // programmed [path mm/s]; of a rapid its cap
} nck_host_why_piece_t;

// What ramps cost.
typedef struct nck_host_why_ramp {
    double lost_s;              // over the piece's cap
    double limit_s;             // time in cells that no cap holds
} nck_host_why_ramp_t;

// The slowest place of a clocked path behind its fastest one.
typedef struct nck_host_why_slow {
    uint32_t is;                // 1: there is one
    uint32_t reserved;
    double v;                   // speed there [path mm/s]
    nck_host_why_ramp_t down;   // the ramp to it
    nck_host_low_t low;         // it as a low point
} nck_host_why_slow_t;

// All of it. Times in s.
typedef struct nck_host_why {
    nck_host_sum_t cut_s, rapid_s, dwell_s; // the ideal; together with the causes: all time
    nck_host_sum_t limit_s[NCK_LIMIT_AXIS_V + NCK_AXIS_MAX]; // by nck_limit_t; together: all time
    nck_host_cause_t causes[NCK_HOST_CAUSES];
    nck_host_shares_t shares;
    nck_host_trail_t trail;     // rows may be asked for at the start
    uint32_t broken;            // 1: a piece was not there in time, and nothing here is right
    // where it stands
    uint32_t begun;             // 1: piece is one
    uint32_t has_low;           // 1: low is one
    uint32_t told;              // pieces that the kernel has dropped
    uint32_t taken;             // pieces so far, the one in work among them
    uint32_t line;              // source line of the stretch before
    const nck_t *nck;           // has the pieces behind them
    const nck_link_t *link;     // has the segs
    double v;                   // speed so far [path mm/s]
    double v_most;              // the largest one behind low
    nck_host_why_ramp_t up, down; // behind low: ramps to the fastest point, and behind that
    nck_host_why_slow_t slow;   // behind the fastest point
    nck_host_why_piece_t piece; // in work
    nck_host_low_t low;         // the last low point
    nck_host_low_t cap;         // what the cap of the piece in work has lost
    nck_host_why_seg_t segs[NCK_HOST_WHY_SEGS];       // by seq; not before their segs come
    nck_host_why_piece_t pieces[NCK_HOST_WHY_PIECES]; // by number; not before they are dropped
} nck_host_why_t;

// Begin; nck: planned beside it. Cost: constant. Context: any.
void nck_host_why_init(nck_host_why_t *self, nck_t *nck);

// What is kept of the next seg, in order. tangent: at the end of the seg before it, then of this
// one; 0 before the first. Cost: constant. Context: any.
void nck_host_why_row(nck_host_why_seg_t *row, double tangent[NCK_AXIS_MAX], const nck_seg_t *seg,
                      const nck_terms_t *terms);

// Where the row of a seg is kept, by its seq. Cost: constant. Context: any.
nck_host_why_seg_t *nck_host_why_at(nck_host_why_t *self, uint32_t seq);

// The next node that the kernel drops, in order. Cost: constant. Context: prep.
void nck_host_why_node(nck_host_why_t *self, const nck_node_t *node);

// The next cell, in order; extra_s: at rest behind it. Cost: linear in the pieces that it passes.
// Context: prep.
void nck_host_why_cell(nck_host_why_t *self, const nck_cell_t *cell, double extra_s);

// The path has ended. Cost: constant. Context: any.
void nck_host_why_end(nck_host_why_t *self);

#ifdef __cplusplus
}
#endif

#endif
