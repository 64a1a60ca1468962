// SPDX-License-Identifier: MIT
// Inside room 6: what every axis allows of k″. A path with limits of its own is one more axis.
#include "nck/tick/6_interpolate/allow.h"

#include <string.h> // memset

// What it takes more than a plan that takes nearly all: a slower rate leaves more, so it grows from
// there. With 0.01 a run that starves passed a jerk by 0.2 %.
#define LEAVE_SHARE NCK_NUM_OF(0.005)
// Of a period, what is looked at apart. What is shorter weighs 0.055 in a sample of jerk at most.
#define PART_LEAST NCK_NUM_OF(0.125)
// What the ends of a period may take of an axis' jerk, each a sixth of a sample whose middle takes
// 0.97: so that no sample takes more than all.
#define ENDS_SHARE NCK_NUM_OF(1.06)
// What one of k″ is to an axis, of its limit [s²]: below it no change of k moves it.
#define ALONG_LEAST NCK_NUM_OF(1e-6)
// The most of k″T²: what does not move may be slowed down in 7 periods.
#define CHANGE_MOST NCK_NUM_OF(0.04)

// Of an axis, in a period: jerk is base + per·k″, as the first sample that weighs it shows it, and
// as the last one does.
typedef struct allow_ends {
    nck_num base[2];
    nck_num per[2];
    nck_num j_max; // 0: it stands
} allow_ends_t;

// |base + per·k″| ≤ most
static void bound(nck_allow_t *range, nck_num base, nck_num per, nck_num most) {
    const nck_num size = nck_num_max(NCK_NUM_ABS(per), ALONG_LEAST * most);
    const nck_num up = per < 0 ? -base : base;
    const nck_num low = (-most - up) / size;
    const nck_num high = (most - up) / size;
    if (low > range->low) {
        range->low = low;
        range->low_is = size / most;
    }
    if (high < range->high) {
        range->high = high;
        range->high_is = size / most;
    }
}

nck_num nck_allow_between(const nck_allow_t *range) {
    const nck_num weight = range->low_is + range->high_is;
    return (range->low * range->low_is + range->high * range->high_is) / weight;
}

// What is allowed of jerk on a stretch, times since the pace [s]. Nobody takes less than the plan
// at the same rate, so that it can be followed, and a little more, so that it can be left.
static void bound_jerk(nck_allow_t *range, const nck_stretch_ways_t *on,
                       const nck_allow_pace_t *pace, const nck_num *times, nck_num share) {
    const nck_num j_max = share * on->j_max;
    const nck_num third = nck_num_max(NCK_NUM_ABS(on->third[0]), NCK_NUM_ABS(on->third[1]));
    const nck_num plan = third * pace->k * pace->k * pace->k;
    const nck_num most = nck_num_max(j_max, plan + LEAVE_SHARE * j_max);
    for (int n = 0; n < 2; n++) {
        const nck_num k = nck_num_max(0, pace->k + pace->dk * times[n]);
        bound(range, (on->third[n] * k * k + 3 * on->second[n] * pace->dk) * k,
              on->first[n] + 3 * on->second[n] * k * times[n], most);
    }
}

// … of acceleration, at the stretch's end and in its mean.
static void bound_accel(nck_allow_t *range, const nck_stretch_ways_t *on, nck_num far,
                        const nck_allow_pace_t *pace, nck_num time, nck_num share) {
    const nck_num a_max = share * on->a_max;
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
    const nck_num period = walk->period;
    nck_num most = CHANGE_MOST / (period * period);
    nck_num square = 0;
    for (int x = 0; x < walk->terms->axes; x++) {
        const nck_axis_t *const axis = &walk->terms->machine->axis[x];
        const nck_num size = NCK_NUM_ABS(at->first[x]);
        const nck_num takes = nck_num_min((nck_num)axis->j_max, (nck_num)axis->a_max / period);
        if (axis->present && size * most > takes) most = takes / size;
        square += size * size;
    }
    const nck_machine_t *const machine = walk->terms->machine;
    const nck_num takes =
        nck_num_min((nck_num)machine->path.j_max, (nck_num)machine->path.a_max / period);
    return nck_num_min(most, takes / nck_num_max(NCK_NUM_SQRT(square), ALONG_LEAST));
}

// A sample of jerk is a mean over three periods. It weighs what is τ periods behind the begin of
// the last one by (1 − τ)²/2, of the first one by τ²/2.
static void add_part(allow_ends_t *ends, const nck_stretch_ways_t *on, const nck_allow_pace_t *pace,
                     const nck_num *times, nck_num period) {
    const nck_num half = NCK_NUM_OF(0.5);
    const nck_num middle = half * (times[0] + times[1]);
    const nck_num k = nck_num_max(0, pace->k + pace->dk * middle);
    const nck_num second = half * (on->second[0] + on->second[1]);
    const nck_num base = (on->third[0] * k * k + 3 * second * pace->dk) * k;
    const nck_num per = half * (on->first[0] + on->first[1]) + 3 * second * k * middle;
    const nck_num begin = times[0] / period;
    const nck_num end = times[1] / period;
    const nck_num left[2] = {1 - begin, 1 - end};
    const nck_num share[2] = {
        left[0] * left[0] * left[0] - left[1] * left[1] * left[1],
        end * end * end - begin * begin * begin,
    };
    for (int n = 0; n < 2; n++) {
        ends->base[n] += share[n] * base;
        ends->per[n] += share[n] * per;
    }
    ends->j_max = on->j_max;
}

static void bound_ends(nck_allow_t *range, const allow_ends_t *ends, nck_num period) {
    bound_nothing(range, period);
    for (int x = 0; x <= NCK_AXIS_MAX; x++) {
        const nck_num most = ENDS_SHARE * ends[x].j_max;
        for (int n = 0; n < 2 && most > 0; n++) {
            bound(range, ends[x].base[n], ends[x].per[n], most);
        }
    }
}

void nck_allow_parts(nck_allow_parts_t *parts, nck_stretch_walk_t *walk,
                     const nck_allow_pace_t *pace, nck_num far, nck_num share, nck_stretch_t *on) {
    const nck_num period = walk->period;
    const nck_num scale = far > 0 ? period / far : 0;
    const nck_num least = PART_LEAST * far;
    allow_ends_t ends[NCK_AXIS_MAX + 1];
    nck_num gone = 0;
    int last = 0;
    memset(ends, 0, sizeof ends);
    bound_nothing(&parts->each, period);
    while (!last && !walk->ends) {
        const nck_num part = nck_num_max((nck_num)walk->cell->duration - walk->t, least);
        last = gone + part + least >= far;
        nck_stretch_take(walk, last ? far - gone : part, on);
        const nck_num times[2] = {gone * scale, (gone + on->far) * scale};
        gone += on->far;
        for (int n = 0; n < on->count; n++) {
            bound_jerk(&parts->each, &on->of[n], pace, times, share);
            add_part(&ends[on->of[n].axis], &on->of[n], pace, times, period);
        }
    }
    bound_ends(&parts->ends, ends, period);
}
