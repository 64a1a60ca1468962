// SPDX-License-Identifier: MIT
// Inside room 6: the plan that is known of a clocked path, stretch by stretch, by its own time.
#ifndef NCK_TICK_STRETCH_H
#define NCK_TICK_STRETCH_H

#include <string.h> // memcmp memcpy

#include "nck/base/limits.h"  // NCK_CLOCKED_AXES
#include "nck/base/link.h"    // nck_link_t
#include "nck/base/real.h"    // nck_num
#include "nck/base/records.h" // nck_cell_t
#include "nck/base/terms.h"   // nck_terms_t

// What is known of a seg: places of a walk share it.
typedef struct nck_stretch_seg {
    const nck_seg_t *seg;
    nck_num per;                   // 1/L
    nck_num ways[NCK_AXIS_MAX][3]; // nck_path_ways
} nck_stretch_seg_t;

// What an axis, or the path, may do: in numbers of the solvers' type, once a tick.
typedef struct nck_stretch_limit {
    nck_num a_max, j_max;
} nck_stretch_limit_t;

// Along the plan that is known.
typedef struct nck_stretch_walk {
    const nck_terms_t *terms;
    const nck_stretch_limit_t *limit; // of each axis; behind them the path's
    nck_link_t *link;
    uint32_t word;          // of the link
    const nck_cell_t *cell;
    uint32_t next;          // the cell behind it, as nck_link_ahead counts
    uint32_t ends;          // 1: at the plan's rest
    nck_num t;              // in the cell [s]
    nck_num period;         // [s]
    nck_stretch_seg_t on;   // where it has looked last; its seg is NULL at first
} nck_stretch_walk_t;

// Where the axes have been at the last ticks [mm]: places of a ring.
enum { NCK_STRETCH_PAST = 3 };
typedef struct nck_stretch_past {
    double at[NCK_STRETCH_PAST][NCK_CLOCKED_AXES];
    uint32_t last; // of them
} nck_stretch_past_t;

// The derivatives of the plan by its time, at a place.
typedef struct nck_stretch_point {
    nck_num first[NCK_AXIS_MAX];
    nck_num second[NCK_AXIS_MAX];
} nck_stretch_point_t;

// What an axis does at the ends of a stretch, or the path: what of all axes has its direction.
typedef struct nck_stretch_ways {
    nck_num first[2], second[2], third[2];
    nck_num rise; // of the first derivative, from one end to the other
    nck_stretch_limit_t limit;
} nck_stretch_ways_t;

// A stretch of the plan.
typedef struct nck_stretch {
    nck_num far; // of the plan's time [s]
    nck_stretch_point_t from, to;
    int count;   // of what moves on it
    nck_stretch_ways_t of[NCK_AXIS_MAX + 1];
} nck_stretch_t;

// The limits of all. limit_out: NCK_AXIS_MAX + 1. Cost: linear in the axes. Context: tick.
void nck_stretch_limits(const nck_terms_t *terms, nck_stretch_limit_t *limit_out);

// The derivatives where the walk is. Cost: linear in the axes; in another seg than the last look's,
// where there are no doubles in hardware, as much again. Context: tick.
void nck_stretch_look(nck_stretch_walk_t *walk, nck_stretch_point_t *out);

// Where the axes are so far behind the time t in the walk's cell, or at the plan's rest [s]: there
// is the walk then. Cost: a point, and the cells on the way. Context: tick.
void nck_stretch_place(nck_stretch_walk_t *walk, double t, double far, double *axis_out);

// One tick on. Cost: linear in the axes. Context: tick.
static inline void nck_stretch_pass(nck_stretch_past_t *past, const double *axis) {
    past->last = past->last > 0 ? past->last - 1 : NCK_STRETCH_PAST - 1;
    memcpy(past->at[past->last], axis, sizeof past->at[0]);
}

// A path begins there: what came to no clocked path's end has rested. Cost and context as above.
static inline void nck_stretch_begin(nck_stretch_past_t *past, const double *axis) {
    if (memcmp(past->at[past->last], axis, sizeof past->at[0]) == 0) return;
    for (int n = 0; n < (int)NCK_STRETCH_PAST; n++) nck_stretch_pass(past, axis);
}

// The next stretch, from the end of the last one on: so long by the plan's time [s], or to its
// rest. Cost: a look, and the cells on the way. Context: tick.
void nck_stretch_take(nck_stretch_walk_t *walk, nck_num far, nck_stretch_t *stretch);

#endif
