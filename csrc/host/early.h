// SPDX-License-Identifier: MIT
// Rooms 3 and 4 of a plan by themselves, so that a second core can work in room 5 meanwhile.
//
//     blocks ─▶ 3_smooth ─▶ 4_lookahead ─▶ batch of path ══▶ nck_host_plan_take ─▶ 5_slope, sums
//
// What these rooms give hangs on the blocks alone. A batch keeps its order, and where the kernel
// would have gone on with room 5 in between: that room finds every time what it finds there.
#ifndef NCK_HOST_EARLY_H
#define NCK_HOST_EARLY_H

#include <stddef.h> // size_t

#include "host/why.h"                       // nck_host_why_seg_t
#include "nck/base/machine.h"               // nck_machine_t
#include "nck/base/records.h"               // nck_block_t nck_seg_t nck_node_t nck_output_t
#include "nck/base/status.h"                // nck_status_t
#include "nck/base/terms.h"                 // nck_terms_t
#include "nck/prep/2_toolcomp/toolcomp.h"   // nck_toolcomp_t
#include "nck/prep/3_smooth/smooth.h"       // nck_smooth_t
#include "nck/prep/4_lookahead/lookahead.h" // nck_lookahead_t

#ifdef __cplusplus
extern "C" {
#endif

// What comes next in a batch.
enum {
    NCK_HOST_BATCH_SEG = 0, NCK_HOST_BATCH_NODE = 1, NCK_HOST_BATCH_OUTPUT = 2,
    NCK_HOST_BATCH_END = 3, // the path ends behind the last node
    NCK_HOST_BATCH_STEP = 4, // room 5 works on what is there
    NCK_HOST_BATCH_MARK = 5  // a line's way ends
};

// Rows of a batch that must be free before a step of these rooms, of each kind.
enum { NCK_HOST_BATCH_ROOM = 64 };

// Of a seg, what a plan without arrays needs.
typedef struct nck_host_batch_seg {
    nck_host_why_seg_t why;
    double length_mm;      // programmed path up to its end
    uint32_t seq, block;   // as in the seg
    uint8_t rapid;         // 1: G0
    uint8_t kind;          // nck_seg_kind_t; a spline is the next of batch.wholes
    uint8_t reserved[6];   // 0
} nck_host_batch_seg_t;

// The path of some blocks. Rows belong to the caller, NCK_HOST_BATCH_ROOM of each at least.
typedef struct nck_host_batch {
    nck_host_batch_seg_t *segs; size_t seg_max, seg_count;
    nck_seg_t *wholes;    size_t whole_max, whole_count;   // segs that room 5 asks for
    nck_node_t *nodes;     size_t node_max, node_count;
    nck_output_t *outputs; size_t output_max, output_count;
    nck_mark_t *marks;     size_t mark_max, mark_count;
    uint8_t *orders;       size_t order_max, order_count; // NCK_HOST_BATCH_…
    uint32_t blocks;       // of the path so far
    int32_t error;         // of the program, that ends the path; NCK_OK: none
} nck_host_batch_t;

// The two rooms under way.
typedef struct nck_host_early {
    nck_machine_t machine;
    nck_terms_t terms;
    nck_toolcomp_t toolcomp; // its offsets alone: radius compensation has made the blocks
    nck_smooth_t smooth;
    nck_lookahead_t lookahead;
    const nck_block_t *blocks; size_t block_count, block_used; // in work
    nck_host_batch_t *batch; // in work
    nck_seg_t seg;         // in work
    double tangent[NCK_AXIS_MAX]; // at its end
    uint32_t block_seq;    // blocks so far
    uint32_t ended;        // 1: smooth has given all
    uint32_t settled;      // 1: and all of it is placed
    uint32_t has_all;      // 1: no more blocks come
    int32_t error;         // as in the batch
} nck_host_early_t;

// Begin for a machine (copied). Once begun it must not move, for it points into itself.
// Returns as nck_init. Cost: linear in the capacities. Context: any.
nck_status_t nck_host_early_init(nck_host_early_t *self, const nck_machine_t *machine);

// The next n blocks of the program, as nck_host_decode gives them; they must stay until they are
// used up. n = 0: there are no more. Cost: constant. Context: any.
void nck_host_early_give(nck_host_early_t *self, const nck_block_t *blocks, size_t n);

// Fill a batch from its start. Returns NCK_OK (it is nearly full: go on with another one);
// NCK_EMPTY (the blocks are used up: give more, and go on with this one, `anew` 0); NCK_DONE (the
// path has ended); NCK_E_STATE (these rooms cannot go on by themselves: let the kernel plan all).
// anew: 1: the batch is empty. Cost: linear in the blocks. Context: any.
nck_status_t nck_host_early_run(nck_host_early_t *self, nck_host_batch_t *batch, int anew);

#ifdef __cplusplus
}
#endif

#endif
