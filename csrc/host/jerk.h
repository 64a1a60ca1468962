// SPDX-License-Identifier: MIT
// The jerk-limited profile of a whole path at once: the kernel's planner (5_slope/profile.h)
// without its window and without the tick's filter, which would mix the limits of neighbours: the
// third differences of s itself, sampled every period, keep the jerk (ladder_math.h, one tap).
// Caller owns every array.
#ifndef NCK_HOST_JERK_H
#define NCK_HOST_JERK_H

#include <stddef.h> // size_t

#include "host/sshape.h"      // nck_host_path_t
#include "nck/base/records.h" // nck_cell_t
#include "nck/base/status.h"  // nck_status_t

#ifdef __cplusplus
extern "C" {
#endif

// Nodes that a ladder has at most: 4.6 hours of motion at a period of 1 ms.
enum { NCK_HOST_JERK_NODES = 1 << 25 };

// How the profile is made and played.
typedef struct nck_host_jerk {
    double period_s;  // T, between two samples of s [s], positive
    double step_s;    // D, what a cell lasts about [s], positive, at most 4 T
    uint32_t rounds;  // how often the ladder is made again from the plan, 2 suffice
    double j_scale;   // rule R plans with j_scale·J, 0 … 1; 0: with what holds J at every sample
} nck_host_jerk_t;

// Where a profile is made, and left.
typedef struct nck_host_jerk_area {
    size_t nodes;      // of the ladder, at most
    void *work;        // nck_host_jerk_bytes(nodes), aligned as malloc does
    double *v_node;    // n + 1: speeds at the junctions [mm/s]; filled
    nck_cell_t *cells; // nodes: of constant acceleration; filled as far as they go
} nck_host_jerk_area_t;

// Bytes of work memory for up to `nodes` nodes. Cost: constant. Context: any.
size_t nck_host_jerk_bytes(size_t nodes);

// Plan a path (kind, lookahead and ramp_s are unread) from rest to rest; a cap of 0 at an inner
// junction is a stop. *cell_count_out of the area's cells are filled; cell.seg is the segment's
// index, cell.stop marks the cells that end at rest. Linear in the nodes.
// Returns NCK_OK; NCK_FULL if the area's nodes are too few: *cell_count_out are needed at least,
// and more than NCK_HOST_JERK_NODES are too many; NCK_E_ARGUMENT and in *bad_out the index of the
// first segment (n: the last junction, or the settings) whose number is NaN, infinite or outside
// of its range; NCK_E_STATE and in *bad_out the first segment that would never be passed: next to
// the whole path its steps are lost in rounding.
// Context: any.
nck_status_t nck_host_jerk(const nck_host_path_t *path, const nck_host_jerk_t *how,
                           const nck_host_jerk_area_t *area, size_t *cell_count_out,
                           size_t *bad_out);

#ifdef __cplusplus
}
#endif

#endif
