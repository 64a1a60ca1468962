// SPDX-License-Identifier: MIT
// A whole program that the host has planned: its cells come one by one, add up, or go to the tick
// by the kernel's link, in place of rooms 1 to 5.
//
//     planner's next() ─▶ cells ─▶ totals
//                              └──▶ link ─▶ tick
#ifndef NCK_HOST_FEED_H
#define NCK_HOST_FEED_H

#include <stddef.h> // size_t

#include "host/host.h" // nck_host_totals_t and all records

#ifdef __cplusplus
extern "C" {
#endif

// A finished plan, gone through once from its first cell on: all zero but the first group.
typedef struct nck_host_feed {
    const nck_machine_t *machine;
    const nck_seg_t *segs;        // of the whole program, from nck_host_plan
    size_t seg_count;             // less than 2³²
    const nck_output_t *outputs;  // in order; read by nck_host_feed_prep alone
    size_t output_count;
    int (*next)(void *walk, nck_cell_t *cell_out); // the next cell of the plan; 0: there is none
    void *walk;                   // where that stands
    nck_t *nck;                   // initialised by nck_init; nck_host_feed_prep fills its link

    nck_cell_t cell;              // made and not yet pushed
    uint32_t has_cell;
    uint32_t ended;               // 1: no more cells
    size_t segs_pushed, outputs_pushed;
} nck_host_feed_t;

// The next cells, at most max; *count_out = 0: that was all. Cost: linear. Context: prep.
void nck_host_feed_cells(nck_host_feed_t *self, nck_cell_t *cells_out, size_t max,
                         size_t *count_out);

// Time and counts of the plan, as nck_host_plan tells them; nodes, blocks, tool changes and spindle
// starts are left 0. Cost: linear. Context: prep.
void nck_host_feed_totals(nck_host_feed_t *self, nck_host_totals_t *totals_out);

// Fill the link as far as it goes, in the shape of nck_prep (user: a nck_host_feed_t). Returns
// NCK_OK, NCK_FULL (waits for the tick), NCK_DONE, or NCK_E_INTERNAL (a cell without numbers).
// Everything is final, so there is no stop tail: call it between any two ticks, and a period must
// not use up all cells. Cost: linear in the capacities. Context: prep.
nck_status_t nck_host_feed_prep(void *user);

#ifdef __cplusplus
}
#endif

#endif
