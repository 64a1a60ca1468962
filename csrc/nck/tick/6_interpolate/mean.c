// SPDX-License-Identifier: MIT
// Inside room 6: the mean over the last periods, and a motion that ends beside the next one.
#include "nck/tick/6_interpolate/mean.h"

#include "nck/base/path_math.h" // nck_path_point

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

// Add what is left of the motion that rides: the mean is at s of the filter's seg.
static void add_left(const nck_rider_t *rider, const nck_link_t *link, double s, double v,
                     nck_pose_t *pose) {
    const nck_cell_t *const cell = &rider->cell;
    const nck_seg_t *const seg = nck_link_seg(link, rider->filter.seg);
    const nck_seg_t *const last = nck_link_seg(link, cell->seg + cell->span);
    const double left = (last->s_begin + last->length) - (seg->s_begin + s);
    double at[NCK_AXIS_MAX];
    nck_path_point(seg, s, at);
    for (int x = 0; x < NCK_AXIS_MAX; x++) pose->axis[x] += at[x] - last->end[x];
    pose->s -= left;
    pose->v += v;
    pose->left = left;
}

// Its mean rests when every tap is there.
int nck_mean_ride(nck_rider_t *rider, nck_link_t *link, double t, nck_pose_t *pose) {
    nck_filter_t *const filter = &rider->filter;
    while (t >= rider->t_cell + rider->cell.duration && filter->settle == 0) {
        if (rider->cell.stop & NCK_STOP_REST) {
            filter->settle = filter->taps;
            break;
        }
        const uint32_t seg_before = rider->cell.seg;
        rider->t_cell += rider->cell.duration;
        if (nck_link_take_rider(link, &rider->cell) != NCK_OK) break;
        filter->ahead += nck_mean_length(link, seg_before, rider->cell.seg);
    }
    double v = 0.0;
    double s = rider->cell.s + rider->cell.length;
    if (filter->settle == 0) s = nck_mean_place(&rider->cell, t - rider->t_cell, &v);
    const double s_mean = nck_mean_take(filter, link, &rider->cell, s, v, &v);
    if (filter->settle == 1) return 1;
    if (filter->settle > 0) filter->settle--;
    add_left(rider, link, s_mean, v, pose);
    return 0;
}
