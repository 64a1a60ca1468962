// SPDX-License-Identifier: MIT
// Inside room 6: what every axis allows of k″. A path with limits of its own is one more axis.
#include "nck/tick/6_interpolate/allow.h"

#include <string.h> // memset

// What it takes more than a plan that takes nearly all: a slower rate leaves more, so it grows from
// there. With 0.01 a run that starves passed a jerk by 0.2 %.
#define LEAVE_SHARE NCK_NUM_OF(0.005)
// What one of k″ is to an axis, of its limit [s²]: below it no change of k moves it.
#define ALONG_LEAST NCK_NUM_OF(1e-6)
// Of a period along the plan, what a chord counts besides: at rest it has no direction of its own.
#define REST_SHARE NCK_NUM_OF(1e-3)
// The most of k″T²: what does not move may be slowed down in 7 periods.
#define CHANGE_MOST NCK_NUM_OF(0.04)

// No less than low and no more than high says who hears so much of k″.
static void narrow(nck_allow_t *range, nck_num low, nck_num high, nck_num is) {
    if (low > range->low) {
        range->low = low;
        range->low_is = is;
    }
    if (high < range->high) {
        range->high = high;
        range->high_is = is;
    }
}

// |base + per·k″| ≤ most
static void bound(nck_allow_t *range, nck_num base, nck_num per, nck_num most) {
    const nck_num size = nck_num_max(NCK_NUM_ABS(per), ALONG_LEAST * most);
    const nck_num up = per < 0 ? -base : base;
    const nck_num low = (-most - up) / size;
    const nck_num high = (most - up) / size;
    narrow(range, low, high, size / most);
}

nck_num nck_allow_between(const nck_allow_t *range) {
    const nck_num weight = range->low_is + range->high_is;
    return (range->low * range->low_is + range->high * range->high_is) / weight;
}

// What is allowed: nobody takes less than the plan at the same rate, so that it can be followed,
// and a little more, so that it can be left.
static nck_num most_of(nck_num all, nck_num plan, nck_num share) {
    const nck_num size = NCK_NUM_ABS(plan);
    const nck_num left = nck_num_min(all, size + LEAVE_SHARE * all);
    return nck_num_max(nck_num_max(share * all, left), size);
}

// What is allowed of jerk on a stretch, times since the pace [s].
static void bound_jerk(nck_allow_t *range, const nck_stretch_ways_t *on,
                       const nck_allow_pace_t *pace, const nck_num *times, nck_num share) {
    const nck_num third = nck_num_max(NCK_NUM_ABS(on->third[0]), NCK_NUM_ABS(on->third[1]));
    const nck_num most = most_of(on->limit.j_max, third * pace->k * pace->k * pace->k, share);
    for (int n = 0; n < 2; n++) {
        const nck_num k = nck_num_max(0, pace->k + pace->dk * times[n]);
        bound(range, (on->third[n] * k * k + 3 * on->second[n] * pace->dk) * k,
              on->first[n] + 3 * on->second[n] * k * times[n], most);
    }
}

// … of acceleration, at the stretch's end and in its mean.
static void bound_accel(nck_allow_t *range, const nck_stretch_ways_t *on, nck_num far,
                        const nck_allow_pace_t *pace, nck_num time, nck_num share) {
    const nck_num a_max = share * on->limit.a_max;
    const nck_num k = nck_num_max(0, pace->k + pace->dk * time);
    const nck_num bend = on->second[1] * k * k;
    bound(range, bend + on->first[1] * pace->dk,
          (on->first[1] + on->second[1] * k * time) * time, nck_num_max(a_max, NCK_NUM_ABS(bend)));
    if (!(time > 0)) return; // the clock stands before
    // What a sample shows is the mean, whatever the plan does within it.
    const nck_num mean = far > 0 ? on->rise / far : 0;
    bound(range, (on->rise * pace->k + on->first[1] * pace->dk * time) / time,
          NCK_NUM_OF(0.5) * on->first[1] * time,
          nck_num_max(a_max, NCK_NUM_ABS(mean) * pace->k * pace->k));
}

// Before any axis is asked.
static void bound_nothing(nck_allow_t *range, nck_num period) {
    range->high = CHANGE_MOST / (period * period);
    range->low = -range->high;
    range->low_is = 1 / range->high;
    range->high_is = range->low_is;
}

void nck_allow_all(nck_allow_t *range, const nck_stretch_walk_t *walk, const nck_stretch_t *on,
                   const nck_allow_pace_t *pace, nck_num time, nck_num share) {
    const nck_num times[2] = {0, time};
    bound_nothing(range, walk->period);
    for (int n = 0; n < on->count; n++) {
        bound_jerk(range, &on->of[n], pace, times, share);
        bound_accel(range, &on->of[n], on->far, pace, time, share);
    }
}

nck_num nck_allow_free(const nck_stretch_walk_t *walk, const nck_stretch_point_t *at) {
    const nck_num per = 1 / walk->period;
    const nck_stretch_limit_t *const path = &walk->limit[NCK_AXIS_MAX];
    nck_num most = CHANGE_MOST * per * per;
    nck_num square = 0;
    for (int x = 0; x < walk->terms->axes; x++) {
        const nck_num size = NCK_NUM_ABS(at->first[x]);
        const nck_num takes = nck_num_min(walk->limit[x].j_max, walk->limit[x].a_max * per);
        if (walk->terms->machine->axis[x].present && size * most > takes) most = takes / size;
        square += size * size;
    }
    const nck_num takes = nck_num_min(path->j_max, path->a_max * per);
    return nck_num_min(most, takes / nck_num_max(NCK_NUM_SQRT(square), ALONG_LEAST));
}

void nck_allow_look(nck_allow_sample_t *samples, const nck_stretch_walk_t *walk,
                    const nck_allow_period_t *period, const nck_stretch_point_t *at,
                    const nck_allow_pace_t *pace) {
    const nck_stretch_past_t *const past = period->past;
    const nck_num half = NCK_NUM_OF(0.5) * walk->period * walk->period * walk->period;
    const nck_num rest = REST_SHARE * walk->period;
    const double per = 1.0 / (double)walk->period;
    double axis[NCK_AXIS_MAX];
    nck_stretch_walk_t on = *walk;
    nck_stretch_point_t there;
    nck_stretch_place(&on, period->t, period->far, axis);
    nck_stretch_look(&on, &there);
    const double *const was[] = {past->at[past->last],
                                 past->at[(past->last + 1) % NCK_STRETCH_PAST],
                                 past->at[(past->last + 2) % NCK_STRETCH_PAST]};
    for (int x = 0; x < walk->terms->axes; x++) {
        nck_allow_sample_t *const of = &samples[x];
        const double way = was[0][x] - was[1][x];
        const double gain = axis[x] - was[0][x] - way;
        const double turn = gain - (way - (was[1][x] - was[2][x]));
        of->is[0] = (nck_num)(gain * per * per);
        of->is[1] = (nck_num)(turn * per * per * per);
        of->per = there.first[x];
        of->bend = half * there.second[x];
        of->plan[0] = of->is[0] - at->first[x] * pace->dk;
        of->plan[1] = of->is[1] - 3 * at->second[x] * pace->k * pace->dk;
        of->way[0] = (nck_num)(axis[x] - was[1][x]) + rest * of->per;
        of->way[1] = (nck_num)(axis[x] - was[2][x]) + rest * of->per;
    }
}

// |base + (per + bend·k″)·k″| ≤ most, by one step from where it is straight.
static void bound_bent(nck_allow_t *range, nck_num base, const nck_allow_sample_t *of,
                       nck_num scale, nck_num most) {
    const nck_num sign = of->per < 0 ? -scale : scale;
    const nck_num size = nck_num_max(sign * of->per, ALONG_LEAST * most);
    const nck_num up = of->per < 0 ? -base : base;
    const nck_num bend = sign * of->bend / size;
    const nck_num low = (-most - up) / size;
    const nck_num high = (most - up) / size;
    const nck_num least = NCK_NUM_OF(0.5);
    const nck_num lower = low / nck_num_max(least, 1 + bend * low);
    const nck_num higher = high / nck_num_max(least, 1 + bend * high);
    narrow(range, lower, higher, size / most);
}

// What a sample of acceleration (0) or of jerk (1) allows of an axis, or of the path.
static void bound_sample(nck_allow_t *range, const nck_allow_sample_t *of, int order,
                         nck_num period, const nck_stretch_limit_t *limit, nck_num share) {
    const nck_num most = most_of(order ? limit->j_max : limit->a_max, of->plan[order], share);
    bound_bent(range, of->is[order], of, order ? 1 : period, most);
}

// What of the samples of acceleration (0) or of jerk (1) lies along the path: along their chord.
static void add_along(nck_allow_sample_t *path, const nck_allow_sample_t *all, int axes, int n) {
    nck_num square = 0;
    memset(path, 0, sizeof *path);
    for (int x = 0; x < axes; x++) square += all[x].way[n] * all[x].way[n];
    const nck_num size = square > 0 ? 1 / NCK_NUM_SQRT(square) : 0;
    for (int x = 0; x < axes; x++) {
        const nck_num share = size * all[x].way[n];
        path->is[n] += share * all[x].is[n];
        path->plan[n] += share * all[x].plan[n];
        path->per += share * all[x].per;
        path->bend += share * all[x].bend;
    }
}

void nck_allow_now(nck_allow_t *range, const nck_stretch_walk_t *walk,
                   const nck_allow_sample_t *samples, nck_num share) {
    nck_allow_sample_t path;
    bound_nothing(range, walk->period);
    for (int order = 0; order < 2; order++) {
        for (int x = 0; x < walk->terms->axes; x++) {
            if (!walk->terms->machine->axis[x].present) continue;
            bound_sample(range, &samples[x], order, walk->period, &walk->limit[x], share);
        }
        if (!walk->terms->limits_path) continue;
        add_along(&path, samples, walk->terms->axes, order);
        bound_sample(range, &path, order, walk->period, &walk->limit[NCK_AXIS_MAX], share);
    }
}
