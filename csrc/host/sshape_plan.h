// SPDX-License-Identifier: MIT
// The classical S-shape over a whole program (Cao et al. 2014, section 8): the pieces of path and
// caps are those of the kernel's rooms 1 to 4 under the jerk-limited slope, the motion along them
// is at rest in acceleration at every junction. Theory and choices: docs/papers.md.
//
//   segs, nodes ─▶ hops ─▶ speeds at their ends (host/sshape.h) ─▶ cells
//
// A hop is a piece, or the middle of a seg with the zones beside its corners. Its limits hold in
// all of its pieces: within a length z of a place without acceleration the S-shape comes to
// (6·z·j²)^(1/3) at most, so a zone whose own limit is beyond that needs no ramp of its own.
#ifndef NCK_HOST_SSHAPE_PLAN_H
#define NCK_HOST_SSHAPE_PLAN_H

#include <stddef.h> // size_t

#include "host/sshape.h"      // NCK_HOST_SLOPE_CELLS
#include "nck/base/records.h" // nck_node_t nck_cell_t
#include "nck/base/status.h"  // nck_status_t

#ifdef __cplusplus
extern "C" {
#endif

// What is passed from one place without acceleration to the next.
typedef struct nck_host_hop {
    uint32_t seg;   // seq of its seg
    uint32_t count; // nodes, 1 to 3
    double s;       // where it begins, in its seg [path mm]
    uint8_t last;   // 1: it ends its seg
    uint8_t limit;  // nck_limit_t of its cap
} nck_host_hop_t;

// A whole program: what is given, and arrays of the caller's that are filled, each with room for
// node_count but where more is said.
typedef struct nck_host_sshape {
    const nck_seg_t *segs;   // from nck_host_plan, their seq one after the other
    size_t seg_count;
    const nck_node_t *nodes; // from nck_host_plan
    size_t node_count;
    size_t lookahead;        // blocks with motion seen behind the one in work; rest is assumed
                             // beyond
    nck_host_hop_t *hops;
    size_t hop_count;        // filled rows of hops and of all below
    double *length, *v_cap, *a_max, *j_max; // of each hop, as nck_host_path_t has them
    double *v_node;          // node_count + 1: caps at its ends [path mm/s]
    double *v;               // node_count + 1: speeds there [path mm/s]
    uint32_t *block;         // of each hop: number of its block, those without motion left out
    size_t bad;              // first hop that is no path when nck_host_sshape_plan refuses
} nck_host_sshape_t;

// Plan it: hops, caps, speeds. Returns NCK_OK, or NCK_E_ARGUMENT (a number of a node is none).
// Cost: linear in the nodes; with a look-ahead n·(hops seen). Context: any.
nck_status_t nck_host_sshape_plan(nck_host_sshape_t *self);

// Where the making of cells stands; all zero at the begin but the plan.
typedef struct nck_host_sshape_walk {
    const nck_host_sshape_t *plan; // a finished one
    size_t node, hop;              // next
    nck_cell_t cells[NCK_HOST_SLOPE_CELLS]; // of the hop, or the rest, under way
    size_t count, at;              // of them, and those given
} nck_host_sshape_walk_t;

// The next cell of a plan (user: a nck_host_sshape_walk_t), for a nck_host_feed_t; 0: there is
// none. Cost: bounded (60 halvings). Context: prep.
int nck_host_sshape_next(void *user, nck_cell_t *cell_out);

#ifdef __cplusplus
}
#endif

#endif
