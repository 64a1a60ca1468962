// SPDX-License-Identifier: MIT
// Room 5, slope: node → cell. The speed profile over each piece, and the way to stop from any of
// them.
#ifndef NCK_PREP_SLOPE_H
#define NCK_PREP_SLOPE_H

#include "nck/base/machine.h" // nck_machine_t
#include "nck/base/records.h" // nck_node_t nck_cell_t
#include "nck/base/status.h"  // nck_status_t

enum { NCK_SLOPE_CELLS = 3 }; // cells of a piece at most: accelerate, cruise, decelerate

typedef struct nck_slope {
    const nck_machine_t *machine;
    double vv_brake; // v² at the end of the brake so far
} nck_slope_t;

// Cost: constant. Context: any, before the tick runs.
void nck_slope_init(nck_slope_t *self, const nck_machine_t *machine);

// The cells of a piece whose envelope is node->vv at its start and vv_end at its end, in
// cells_out[3].
// Returns how many, 1 to 3. Linear slope: acceleration is −a, 0 or a in the piece; a piece that
// lasts no longer than four periods gets one constant acceleration. Cost: constant. Context: prep.
int nck_slope_push(const nck_slope_t *self, const nck_node_t *node, double vv_end,
                   nck_cell_t *cells_out);

// Begin the stop tail at a node that is passed at vv_begin. Cost: constant. Context: prep.
void nck_slope_brake_begin(nck_slope_t *self, double vv_begin);

// Go on braking through the next piece with all of its acceleration; vv_cap_end is the cap at its
// end (0 at the window's end), which only rounding can exceed. Returns NCK_OK (and the cell), or
// NCK_DONE with the last cell, which comes to rest, or NCK_EMPTY if the brake had come to rest
// before.
// Cost: constant. Context: prep.
nck_status_t nck_slope_brake(nck_slope_t *self, const nck_node_t *node, double vv_cap_end,
                             nck_cell_t *cell_out);

#endif
