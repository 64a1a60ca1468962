// SPDX-License-Identifier: MIT
// Inside room 6: the mean over the last periods.
#include "nck/tick/6_interpolate/mean.h"

double nck_mean_length(const nck_link_t *link, uint32_t from, uint32_t to) {
    double length = 0.0;
    for (uint32_t seq = from; seq != to; seq++) length += nck_link_seg(link, seq)->length;
    return length;
}

void nck_mean_begin(nck_filter_t *filter, const nck_cell_t *cell) {
    filter->seg = cell->seg;
    filter->ahead = 0.0;
    for (uint32_t n = 0; n < filter->taps; n++) {
        filter->s[n] = cell->s;
        filter->v[n] = 0.0;
    }
}

// The segs from the filter's on that lie behind s; none beyond the seg where the cell ends.
static double walk(nck_filter_t *filter, const nck_link_t *link, const nck_cell_t *cell,
                   double s) {
    const uint32_t last = cell->seg + cell->span;
    while (filter->seg != last && s >= nck_link_seg(link, filter->seg)->length) {
        const double length = nck_link_seg(link, filter->seg)->length;
        s -= length;
        filter->ahead -= length;
        for (uint32_t n = 0; n < filter->taps; n++) filter->s[n] -= length;
        filter->seg++;
    }
    return s;
}

// Summed anew each time: a running sum drifts.
double nck_mean_take(nck_filter_t *filter, const nck_link_t *link, const nck_cell_t *cell, double s,
                     double v, double *v_out) {
    filter->s[filter->at] = s + filter->ahead;
    filter->v[filter->at] = v;
    filter->at = filter->at + 1 < filter->taps ? filter->at + 1 : 0;
    double s_sum = 0.0;
    double v_sum = 0.0;
    for (uint32_t n = 0; n < filter->taps; n++) {
        s_sum += filter->s[n];
        v_sum += filter->v[n];
    }
    const double taps = (double)filter->taps;
    *v_out = v_sum / taps;
    return walk(filter, link, cell, s_sum / taps);
}
