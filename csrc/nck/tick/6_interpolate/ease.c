// SPDX-License-Identifier: MIT
// Inside room 6: how the tick brakes along a clocked path, and sets off again.
//
// The tool is where the plan is at the time φ, which goes on at the rate k = dφ/dt:
//     x″ = p″k² + p′k′      x‴ = p‴k³ + 3p″kk′ + p′k″      by the plan's time: p′, p″, p‴
// At any constant k ≤ 1 accelerations and jerks are less than the plan's own, which keeps the
// limits. So both can go on from wherever k′ can be taken away again, with k between 0 and 1: that
// is tried along the plan that is known, stretch by stretch. p‴ is the mean of one, as periods show
// it. A path with limits of its own is one more axis: what of all axes has its direction.
#include "nck/tick/6_interpolate/ease.h"

#include <string.h> // memset

#include "nck/base/cell_math.h" // nck_cell_way nck_cell_speed
#include "nck/base/fence.h"     // nck_fence_store
#include "nck/base/path.h"      // nck_path_tangent_part nck_path_second_part
#include "nck/base/real.h"      // nck_min nck_max nck_sqrt nck_fabs

// Of an axis' acceleration and jerk, what is taken where the plan takes less: a sample of jerk
// weighs three periods, so it may pass their means by 0.03, …
#define SHARE_TAKEN 0.97
// … what it counts on further on, where it looks at fewer places than there are periods.
#define SHARE_AHEAD 0.93
// The same of a clock that sets off: it is in no hurry, and what it takes grows with it.
#define OFF_TAKEN 0.9
#define OFF_AHEAD 0.7
// What it takes more than a plan that takes all: a slower rate leaves more, so it grows from there.
#define LEAVE_SHARE 0.01
// Of a period, what is looked at apart. What is shorter weighs 0.055 in a sample of jerk at most.
#define PART_LEAST 0.125
// What one of k″ is to an axis, of its limit [s²]: below it no change of k moves it.
#define ALONG_LEAST 1e-6
// The most of k″T²: what does not move may be slowed down in 7 periods.
#define CHANGE_MOST 0.04
// Of what k″ takes in a period, so slow that the clock may rest …
#define REST_SHARE 0.3
// … and of all that axes have in a period, so near 1 that it may run: the plan may take all of it.
#define RUN_SHARE 0.003

enum {
    TRIALS = 4,      // how hard k may change: even steps from easing off to all there is
    PLACES = 40,     // looked at ahead of the period: 340 periods
    NEAR_PLACES = 8, // stretches grow by 1/8 from there on
    TIME_STEPS = 2   // to a time: each halves the digits that lack
};

// Along the plan that is known.
typedef struct ease_walk {
    const nck_terms_t *terms;
    nck_link_t *link;
    uint32_t word;          // of the link
    const nck_cell_t *cell;
    uint32_t next;          // the cell behind it, as nck_link_ahead counts
    uint32_t ends;          // 1: at the plan's rest
    double t;               // in the cell [s]
} ease_walk_t;

// The derivatives of the plan by its time, at a place.
typedef struct ease_point {
    double first[NCK_AXIS_MAX];
    double second[NCK_AXIS_MAX];
} ease_point_t;

// What an axis does at the ends of a stretch, or the path: what of all axes has its direction.
typedef struct ease_ways {
    double first[2], second[2], third[2];
    double rise; // of the first derivative, from one end to the other
} ease_ways_t;

// A stretch of the plan.
typedef struct ease_stretch {
    double far; // of the plan's time [s]
    ease_point_t from, to;
    ease_ways_t along; // the path, where it has limits of its own
} ease_stretch_t;

// A pace.
typedef struct ease_pace {
    double k;   // dφ/dt
    double dk;  // dk/dt [1/s]
    double way; // -1: it slows down, 1: it sets off
} ease_pace_t;

// What all axes allow of k″ [1/s²].
typedef struct ease_range {
    double low, high;
} ease_range_t;

// How hard k may change in the period, and what comes of it.
typedef enum ease_verdict { EASE_OPEN = 0, EASE_GOOD, EASE_BAD } ease_verdict_t;
typedef struct ease_trial {
    double change;    // k″ in the period [1/s²]
    ease_pace_t pace; // as far as it has been tried
    uint32_t verdict; // ease_verdict_t
} ease_trial_t;

static void look(const ease_walk_t *walk, ease_point_t *out) {
    const int axes = walk->terms->axes;
    const nck_cell_t *const cell = walk->cell;
    const nck_seg_t *const seg = nck_link_seg(walk->link, cell->seg);
    const double way = nck_max(0.0, nck_min(nck_cell_way(cell, walk->t), cell->length));
    const double s = nck_min(cell->s + way, seg->length);
    const double v = nck_max(0.0, nck_cell_speed(cell, walk->t));
    const double a = cell->a + cell->j * walk->t;
    nck_path_tangent_part(seg, s, axes, out->first);
    nck_path_second_part(seg, s, axes, out->second);
    for (int x = 0; x < axes; x++) {
        out->second[x] = out->second[x] * v * v + out->first[x] * a;
        out->first[x] *= v;
    }
}

// On by so much of the plan's time, or to its rest. Returns how far [s].
static double walk_on(ease_walk_t *walk, double far) {
    double gone = 0.0;
    for (uint32_t n = 0; n < NCK_TAIL_MAX; n++) {
        const double left = walk->cell->duration - walk->t;
        if (gone + left >= far) {
            walk->t += far - gone;
            return far;
        }
        gone += left;
        walk->t = walk->cell->duration;
        const nck_cell_t *const next = nck_link_ahead(walk->link, walk->word, walk->next);
        walk->ends = (walk->cell->stop & NCK_STOP_REST) || !next;
        if (walk->ends) return gone;
        walk->cell = next;
        walk->next++;
        walk->t = 0.0;
    }
    return gone;
}

static void ways_of(const ease_stretch_t *on, int x, ease_ways_t *out) {
    const double turn = on->to.second[x] - on->from.second[x];
    out->first[0] = on->from.first[x];
    out->first[1] = on->to.first[x];
    out->second[0] = on->from.second[x];
    out->second[1] = on->to.second[x];
    out->third[0] = on->far > 0.0 ? turn / on->far : 0.0;
    out->third[1] = out->third[0];
    out->rise = on->to.first[x] - on->from.first[x];
}

static void set_along(ease_stretch_t *on, int axes) {
    ease_ways_t *const out = &on->along;
    memset(out, 0, sizeof *out);
    for (int n = 0; n < 2; n++) {
        const ease_point_t *const at = n == 0 ? &on->from : &on->to;
        double square = 0.0;
        for (int x = 0; x < axes; x++) square += at->first[x] * at->first[x];
        out->first[n] = nck_sqrt(square);
        const double per = square > 0.0 ? 1.0 / out->first[n] : 0.0; // 0: it rests there
        for (int x = 0; x < axes; x++) {
            ease_ways_t own;
            const double share = per * at->first[x];
            ways_of(on, x, &own);
            out->second[n] += share * own.second[n];
            out->third[n] += share * own.third[n];
            if (n == 1) out->rise += share * own.rise;
        }
    }
}

// The next stretch.
static void take_stretch(ease_walk_t *walk, double far, ease_stretch_t *stretch) {
    stretch->from = stretch->to;
    stretch->far = walk_on(walk, far);
    look(walk, &stretch->to);
    if (walk->terms->limits_path) set_along(stretch, walk->terms->axes);
}

// How long a pace takes for so much of the plan's time; 0: it stands before.
static double time_for(const ease_pace_t *pace, double change, double far) {
    double time = far / nck_max(pace->k, far);
    for (int n = 0; n < TIME_STEPS; n++) {
        const double dk = pace->dk + change * time / 3.0;
        const double root = pace->k * pace->k + 2.0 * dk * far;
        if (!(root > 0.0)) return 0.0;
        time = 2.0 * far / (pace->k + nck_sqrt(root));
    }
    return time;
}

// |base + per·k″| ≤ most
static void bound(ease_range_t *range, double base, double per, double most) {
    const double size = nck_max(nck_fabs(per), ALONG_LEAST * most);
    const double up = per < 0.0 ? -base : base;
    range->low = nck_max(range->low, (-most - up) / size);
    range->high = nck_min(range->high, (most - up) / size);
}

// What is allowed of jerk on a stretch, times since the pace [s]. Nobody takes less than the plan
// at the same rate, so that it can be followed, and a little more, so that it can be left.
static void bound_jerk(ease_range_t *range, const ease_ways_t *on, double j_max,
                       const ease_pace_t *pace, const double *times) {
    const double third = nck_max(nck_fabs(on->third[0]), nck_fabs(on->third[1]));
    const double plan = third * pace->k * pace->k * pace->k;
    const double most = nck_max(j_max, plan + LEAVE_SHARE * j_max);
    for (int n = 0; n < 2; n++) {
        const double k = nck_max(0.0, pace->k + pace->dk * times[n]);
        bound(range, (on->third[n] * k * k + 3.0 * on->second[n] * pace->dk) * k,
              on->first[n] + 3.0 * on->second[n] * k * times[n], most);
    }
}

// … of acceleration, at the stretch's end and in its mean.
static void bound_accel(ease_range_t *range, const ease_ways_t *on, double a_max, double far,
                        const ease_pace_t *pace, double time) {
    const double k = nck_max(0.0, pace->k + pace->dk * time);
    const double bend = on->second[1] * k * k;
    bound(range, bend + on->first[1] * pace->dk,
          (on->first[1] + on->second[1] * k * time) * time, nck_max(a_max, nck_fabs(bend)));
    if (!(time > 0.0)) return; // the clock stands before
    // What a sample shows is the mean, whatever the plan does within it.
    const double mean = far > 0.0 ? on->rise / far : 0.0;
    bound(range, (on->rise * pace->k + on->first[1] * pace->dk * time) / time,
          0.5 * on->first[1] * time, nck_max(a_max, nck_fabs(mean) * pace->k * pace->k));
}

// Before any axis is asked.
static void bound_nothing(ease_range_t *range, double period) {
    range->high = CHANGE_MOST / (period * period);
    range->low = -range->high;
}

// What all axes and the path are allowed of jerk on a stretch.
static void bound_jerks(ease_range_t *range, const nck_terms_t *terms, const ease_stretch_t *on,
                        const ease_pace_t *pace, const double *times, double share) {
    for (int x = 0; x < terms->axes; x++) {
        const nck_axis_t *const axis = &terms->machine->axis[x];
        ease_ways_t ways;
        ways_of(on, x, &ways);
        if (axis->present) bound_jerk(range, &ways, share * axis->j_max, pace, times);
    }
    if (!terms->limits_path) return;
    bound_jerk(range, &on->along, share * terms->machine->path.j_max, pace, times);
}

// What is allowed on a stretch that takes so long [s].
static void bound_all(ease_range_t *range, const nck_terms_t *terms, const ease_stretch_t *on,
                      const ease_pace_t *pace, double time, double share) {
    const double times[2] = {0.0, time};
    bound_nothing(range, terms->machine->period_s);
    bound_jerks(range, terms, on, pace, times, share);
    for (int x = 0; x < terms->axes; x++) {
        const nck_axis_t *const axis = &terms->machine->axis[x];
        ease_ways_t ways;
        ways_of(on, x, &ways);
        if (axis->present) bound_accel(range, &ways, share * axis->a_max, on->far, pace, time);
    }
    if (!terms->limits_path) return;
    bound_accel(range, &on->along, share * terms->machine->path.a_max, on->far, pace, time);
}

// 1 while k changes the way that it is to, between the clock's rest and its run.
static int is_on_way(const ease_pace_t *pace) {
    return pace->k > 0.0 && pace->k <= 1.0 && pace->way * pace->dk > 0.0;
}

// 1 if k′ is gone within so much of the plan's time, half a period before the clock stands or runs.
static int eases_within(const ease_pace_t *pace, double change, double far, double period) {
    if (!(pace->way * change < 0.0)) return 0;
    const double time = -pace->dk / change;
    const double k = pace->k + 0.5 * pace->dk * (time + period);
    return k >= 0.0 && k <= 1.0 && time * (pace->k + pace->dk * time / 3.0) <= far;
}

// Try to ease off along a stretch.
static void try_stretch(ease_trial_t *trial, const nck_terms_t *terms, const ease_stretch_t *on) {
    ease_pace_t *const pace = &trial->pace;
    const double free = time_for(pace, 0.0, on->far);
    ease_range_t range;
    bound_all(&range, terms, on, pace, free, pace->way < 0.0 ? SHARE_AHEAD : OFF_AHEAD);
    trial->verdict = EASE_BAD;
    if (range.low > range.high) return;
    const double easing = pace->way < 0.0 ? range.high : range.low;
    if (eases_within(pace, easing, on->far, terms->machine->period_s)) {
        trial->verdict = EASE_GOOD;
        return;
    }
    const double time = time_for(pace, easing, on->far);
    if (!(time > 0.0)) return;
    pace->k += (pace->dk + 0.5 * easing * time) * time;
    pace->dk += easing * time;
    if (is_on_way(pace)) trial->verdict = EASE_OPEN;
}

// Whether each trial can ease off, behind the period; what is open at the end cannot. k: about that
// behind the period.
static void try_all(ease_trial_t *trials, ease_walk_t *walk, ease_stretch_t *on, double k) {
    const nck_terms_t *const terms = walk->terms;
    const double least = k * terms->machine->period_s;
    double gone = 0.0;
    int open = 1;
    for (int n = 0; n < PLACES && open && !walk->ends; n++) {
        take_stretch(walk, nck_max(least, gone / (double)NEAR_PLACES), on);
        if (!(on->far > 0.0)) continue;
        gone += on->far;
        open = 0;
        for (int i = 0; i < TRIALS; i++) {
            if (trials[i].verdict != EASE_OPEN) continue;
            try_stretch(&trials[i], terms, on);
            open |= trials[i].verdict == EASE_OPEN;
        }
    }
    for (int i = 0; i < TRIALS && walk->ends; i++) { // the plan rests there
        if (trials[i].verdict == EASE_OPEN) trials[i].verdict = EASE_GOOD;
    }
}

// The hardest k″ in a period that sets off: easing off behind it, k comes to 1 by two thirds of the
// way, so that it never passes it.
static double change_to_run(const ease_pace_t *pace, double period) {
    return (1.0 - pace->k - 2.0 * pace->dk * period) / (1.5 * period * period);
}

// Where no k″ is known behind which k′ can be eased off, easing off at once among them, of a clock
// that sets off: a plan has come that brakes, so that its axes allow less than was counted on. Once
// it takes all that axes allow without the plan (most), k′ is led to be gone when k is 1: the plan
// is never overtaken.
static double change_at_last(const ease_pace_t *pace, double change, double most, double period) {
    const double left = nck_max(1.0 - pace->k, 0.5 * pace->dk * period);
    const double must = 0.5 * pace->dk * pace->dk / left;
    const int is_last = pace->dk > 0.0 && must > most;
    return is_last ? nck_min(change, -must) : change;
}

// The hardest k″ in a period, within its range, behind which k′ can be eased off again; the least
// there is: easing off.
static double choose(const ease_pace_t *pace, const ease_range_t *range, double free,
                     ease_walk_t *walk, ease_stretch_t *on) {
    const double period = walk->terms->machine->period_s;
    const double gone = -pace->dk / period; // … k′ is then
    const double least = gone < 0.0 ? nck_max(gone, range->low) : nck_min(gone, range->high);
    const double most = nck_min(range->high, change_to_run(pace, period));
    const double room = pace->way < 0.0 ? nck_min(0.0, range->low - least)
                                        : nck_max(0.0, most - least);
    const double k = pace->k + (pace->dk + 0.5 * nck_max(0.0, room) * period) * period;
    const int steps = pace->way < 0.0 ? TRIALS : TRIALS - 1; // setting off, the last is easing off
    ease_trial_t trials[TRIALS];
    for (int i = 0; i < TRIALS; i++) {
        const double share = (double)(steps - i) / (double)steps;
        ease_trial_t *const trial = &trials[i];
        trial->change = least + room * share;
        trial->pace.way = pace->way;
        trial->pace.dk = pace->dk + trial->change * period;
        trial->pace.k = pace->k + 0.5 * (pace->dk + trial->pace.dk) * period;
        trial->verdict = !(trial->pace.k > 0.0) || trial->pace.k > 1.0 ? EASE_BAD
                         : is_on_way(&trial->pace) ? EASE_OPEN : EASE_GOOD;
    }
    try_all(trials, walk, on, nck_max(0.0, nck_min(k, 1.0)));
    for (int i = 0; i < TRIALS; i++) {
        if (trials[i].verdict == EASE_GOOD) return trials[i].change;
    }
    return change_at_last(pace, least, free, period);
}

// What k″ may be where the plan itself asks for nothing.
static double free_change(const ease_walk_t *walk, const ease_point_t *at) {
    const double period = walk->terms->machine->period_s;
    double most = CHANGE_MOST / (period * period);
    double square = 0.0;
    for (int x = 0; x < walk->terms->axes; x++) {
        const nck_axis_t *const axis = &walk->terms->machine->axis[x];
        const double size = nck_fabs(at->first[x]);
        const double takes = nck_min(axis->j_max, axis->a_max / period);
        if (axis->present && size * most > takes) most = takes / size;
        square += size * size;
    }
    const nck_machine_t *const machine = walk->terms->machine;
    const double takes = nck_min(machine->path.j_max, machine->path.a_max / period);
    return nck_min(most, takes / nck_max(nck_sqrt(square), ALONG_LEAST));
}

// What is allowed of jerk in the period that begins where the walk does, far along the plan. The
// plan's jerk jumps between its cells, and a sample weighs the begin of a period and its end
// unlike: so it is bounded part by part. The walk stands behind it then.
static void bound_parts(ease_range_t *range, ease_walk_t *walk, const ease_pace_t *pace,
                        double far, double share, ease_stretch_t *on) {
    const nck_terms_t *const terms = walk->terms;
    const double period = terms->machine->period_s;
    const double scale = far > 0.0 ? period / far : 0.0;
    const double least = PART_LEAST * far;
    double gone = 0.0;
    int last = 0;
    bound_nothing(range, period);
    while (!last && !walk->ends) {
        const double part = nck_max(walk->cell->duration - walk->t, least);
        last = gone + part + least >= far;
        take_stretch(walk, last ? far - gone : part, on);
        const double times[2] = {gone * scale, (gone + on->far) * scale};
        gone += on->far;
        bound_jerks(range, terms, on, pace, times, share);
    }
}

// What is allowed in the period: in its mean, and of what makes k′ larger also in its parts. Easing
// off was counted on before.
static void bound_period(ease_range_t *range, ease_walk_t *walk, const ease_pace_t *pace,
                         double far, ease_stretch_t *on) {
    const double share = pace->way < 0.0 ? SHARE_TAKEN : OFF_TAKEN;
    ease_walk_t parts = *walk;
    ease_stretch_t part;
    ease_range_t each;
    part.to = on->to;
    bound_parts(&each, &parts, pace, far, share, &part);
    take_stretch(walk, far, on);
    bound_all(range, walk->terms, on, pace, walk->terms->machine->period_s, share);
    if (pace->way < 0.0) range->low = nck_max(range->low, nck_min(0.0, each.low));
    else range->high = nck_min(range->high, nck_max(0.0, each.high));
}

// k″ in the period that begins where the walk does. Where the plan comes to its rest in it, none:
// that is its own. Never does k′ turn round. *most_out: what all axes allow, of a clock that sets
// off without the plan.
static double change_for(const ease_pace_t *pace, ease_walk_t *walk, double *most_out) {
    const double period = walk->terms->machine->period_s;
    const double k = nck_max(0.5 * pace->k, pace->k + 0.5 * pace->dk * period);
    ease_stretch_t on;
    ease_range_t range;
    look(walk, &on.to);
    bound_period(&range, walk, pace, k * period, &on);
    const double free = free_change(walk, &on.to);
    *most_out = pace->way < 0.0 ? range.high : free;
    if (walk->ends) return 0.0;
    if (range.low <= range.high) return choose(pace, &range, free, walk, &on);
    const double gone = -pace->dk / period;
    const double middle = 0.5 * (range.low + range.high);
    const double change = pace->way < 0.0 ? nck_min(middle, nck_max(0.0, gone))
                                          : nck_max(middle, nck_min(0.0, gone));
    return change_at_last(pace, change, free, period);
}

// The same, where prep may publish another plan at any time: then that counts. It does so once in
// many periods.
static double change_now(const ease_pace_t *pace, const ease_walk_t *here, double *most_out) {
    for (int round = 0; round < 2; round++) {
        ease_walk_t walk = *here;
        walk.word = nck_link_word(walk.link);
        const double change = change_for(pace, &walk, most_out);
        if (nck_link_holds(walk.link, walk.word)) return change;
    }
    return 0.0;
}

void nck_ease_begin(nck_clock_t *clock) {
    if (clock->state == NCK_CLOCK_RUNS) {
        clock->first.rate = 1.0;
        clock->second.gain = 0.0;
    }
    nck_fence_store(&clock->state, NCK_CLOCK_BRAKES);
}

// The clock at a pace that is reached, or at its rest or its run next to it. near: of k [1/s].
static void take_pace(nck_clock_t *clock, const ease_pace_t *pace, double near, double period) {
    const int brakes = pace->way < 0.0;
    const int rests = brakes && !(pace->k > near * period);
    const int is_near = 1.0 - pace->k <= near * period && pace->dk <= near;
    const int is_whole = pace->k >= 1.0; // never beyond
    const int runs = !brakes && (is_near || is_whole);
    clock->first.rate = rests ? 0.0 : runs || is_whole ? 1.0 : pace->k;
    clock->second.gain = rests || runs || is_whole ? 0.0 : pace->dk;
    if (runs) nck_fence_store(&clock->state, NCK_CLOCK_RUNS);
}

double nck_ease_period(nck_clock_t *clock, const nck_terms_t *terms, nck_link_t *link,
                       const nck_cell_t *cell, double t) {
    const double period = terms->machine->period_s;
    const int brakes = clock->state == NCK_CLOCK_BRAKES;
    const ease_pace_t pace = {clock->first.rate, clock->second.gain, brakes ? -1.0 : 1.0};
    const ease_walk_t here = {terms, link, 0, cell, 0, 0, t};
    double most = 0.0;
    if (!brakes && clock->feels > 0) { // a rest may end with a jerk of its own
        clock->feels--;
        return 0.0;
    }
    const double change = change_now(&pace, &here, &most);
    const ease_pace_t next = {pace.k + (pace.dk + 0.5 * change * period) * period,
                              pace.dk + change * period, pace.way};
    take_pace(clock, &next, (brakes ? REST_SHARE : RUN_SHARE) * most * period, period);
    if (!(clock->first.rate > 0.0)) return 0.5 * pace.k * period;
    return (pace.k + (0.5 * pace.dk + change / 6.0 * period) * period) * period;
}

void nck_ease_rest(nck_clock_t *clock, int moves) {
    if (clock->state == NCK_CLOCK_SETS_OFF) {
        if (!moves) nck_fence_store(&clock->state, NCK_CLOCK_RUNS);
        return;
    }
    if (moves && !(clock->first.rate > 0.0)) nck_fence_store(&clock->state, NCK_CLOCK_STANDS);
}
