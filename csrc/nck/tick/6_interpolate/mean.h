// SPDX-License-Identifier: MIT
// Inside room 6: the mean over the last periods.
// Face: interpolate.h.
#ifndef NCK_TICK_MEAN_H
#define NCK_TICK_MEAN_H

#include <assert.h> // assert

#include "nck/base/cell_math.h" // nck_cell_way nck_cell_speed
#include "nck/base/link.h"      // nck_link_t
#include "nck/base/real.h"      // nck_min nck_max
#include "nck/base/records.h"   // nck_cell_t

// The filter at the output of the jerk-limited slope: the path coordinate handed out is the mean
// over the last taps of what the cells say. It filters the path coordinate, never the position, so
// it costs no accuracy on the path. One tap: no filter.
typedef struct nck_filter {
    uint32_t taps;          // n, periods
    uint32_t at;            // oldest tap
    uint32_t settle;        // periods left until the mean rests where the cells rest
    uint32_t seg;           // seq of the seg that the mean lies in
    double ahead;           // from that seg's start to that of the cell's seg [path mm]
    double s[NCK_FILTER_TAPS]; // from that seg's start [path mm]
    double v[NCK_FILTER_TAPS]; // [path mm/s]
} nck_filter_t;

// From the start of one seg to that of a later one [path mm].
// Cost: linear in the segs. Context: tick.
double nck_mean_length(const nck_link_t *link, uint32_t from, uint32_t to);

// Behind a rest: all taps are where the first cell begins. Cost: linear in the taps. Context: tick.
void nck_mean_begin(nck_filter_t *filter, const nck_cell_t *cell);

// One more sample, the cell's at s from the start of its seg [path mm] with the speed v; *v_out:
// the mean of the speeds. Returns where the mean of the places lies in the filter's seg, which goes
// on with it. Cost: linear in the taps and in the segs passed. Context: tick.
double nck_mean_take(nck_filter_t *filter, const nck_link_t *link, const nck_cell_t *cell, double s,
                     double v, double *v_out);

// Where a cell is at the time t ≥ 0 from its begin, never beyond it, from the start of its seg:
//        s(t) = s0 + v·t + a·t²/2 + j·t³/6
// *v_out: the speed. Cost: constant. Context: tick.
static inline double nck_mean_place(const nck_cell_t *cell, double t, double *v_out) {
    assert(t >= 0.0);
    *v_out = nck_max(0.0, nck_cell_speed(cell, t));
    return cell->s + nck_max(0.0, nck_min(nck_cell_way(cell, t), cell->length));
}

#endif
