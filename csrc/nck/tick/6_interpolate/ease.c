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

#include <stddef.h> // NULL

#include "nck/base/fence.h"                 // nck_fence_store
#include "nck/base/real.h"                  // nck_num
#include "nck/tick/6_interpolate/allow.h"   // nck_allow_…
#include "nck/tick/6_interpolate/stretch.h" // nck_stretch_…

// Of an axis' acceleration and jerk, what is taken where the plan takes less: a sample of jerk
// weighs three periods, so it may pass their means by 0.03, …
#define SHARE_TAKEN NCK_NUM_OF(0.97)
// … what it counts on further on, where it looks at fewer places than there are periods.
#define SHARE_AHEAD NCK_NUM_OF(0.93)
// The same of a clock that sets off: it is in no hurry, and what it takes grows with it.
#define OFF_TAKEN NCK_NUM_OF(0.9)
#define OFF_AHEAD NCK_NUM_OF(0.7)
// … and what is kept for easing off wherever nothing else is known to lead on: the edge of what can
// be done is met again and again, and is found by places that differ.
#define OFF_LAST NCK_NUM_OF(0.97)
// Of all that axes allow without the plan, what takes k′ away until k is 1, from where on it is no
// longer hurried: a plan may come that brakes sooner, and leaves none of an axis' jerk until then.
#define LAST_SHARE NCK_NUM_OF(0.5)
// Of what k″ takes in a period, so slow that the clock may rest …
#define REST_SHARE NCK_NUM_OF(0.3)
// … and of all that axes have in a period, so near 1 that it may run: the plan may take all of it.
#define RUN_SHARE NCK_NUM_OF(0.003)

// Of k′ that a released clock eases off, what rounding leaves (6e-8 in single precision) and more.
#define GONE_EPSILON 1e-6

// Of the range of k″, what is tried at least.
#define SHARE_LEAST NCK_NUM_OF(0.25)

// Numbers of the solvers' type are enough for how fast and how hard: the clock itself is kept in
// double precision. Where a processor has no doubles in hardware they take a tenth of the time.
enum {
    TRIALS = 2,      // how hard k may change
    PLACES = 40,     // looked at ahead of the period: 340 periods. With 24 over 347 a starved run
                     // took 1.024 of an axis' jerk
    NEAR_PLACES = 8, // stretches grow by 1/8 from there on
    TIME_STEPS = 2   // to a time: each halves the digits that lack
};

// What all axes allow of k″ [1/s²].
typedef struct ease_range {
    nck_allow_t all;
    nck_num soft;   // of a period that slows down: as it eases off where each part of it may
    nck_num last;   // low of who sets off, where no other way is known: by what is kept for it
    nck_num gentle; // what eases off, by what samples show, too
} ease_range_t;

// How k″ may be chosen in a period [1/s²].
typedef struct ease_reach {
    nck_num least; // what eases off
    nck_num room;  // from there to the hardest
    nck_num soft;  // what is not passed, if that can go on
    nck_num last;   // what eases off where nothing else can
    nck_num gentle; // … as softly as samples want it
    int lasts;      // 1: it sets off, and is to run soon
} ease_reach_t;

// What is known before of a period's k″.
typedef struct ease_wish {
    nck_num share; // of the range, that may last: the next period's then
    nck_num free;  // what all axes allow without the plan [1/s²]
    nck_num most;  // … of a brake with it [1/s²]
} ease_wish_t;

// How hard k may change in the period, and what comes of it.
typedef enum ease_verdict { EASE_OPEN = 0, EASE_GOOD, EASE_BAD } ease_verdict_t;
typedef struct ease_trial {
    nck_num change;    // k″ in the period [1/s²]
    nck_num share;     // of the limits, that it counts on behind it
    nck_allow_pace_t pace; // as far as it has been tried
    uint32_t verdict; // ease_verdict_t
} ease_trial_t;

// How long a pace takes for so much of the plan's time; 0: it stands before.
static nck_num time_for(const nck_allow_pace_t *pace, nck_num change, nck_num far) {
    nck_num time = far / nck_num_max(pace->k, far);
    for (int n = 0; n < TIME_STEPS; n++) {
        const nck_num dk = pace->dk + change * time / 3;
        const nck_num root = pace->k * pace->k + 2 * dk * far;
        if (!(root > 0)) return 0;
        time = 2 * far / (pace->k + NCK_NUM_SQRT(root));
    }
    return time;
}

// 1 while k changes the way that it is to, between the clock's rest and its run.
static int is_on_way(const nck_allow_pace_t *pace) {
    return pace->k > 0 && pace->k <= 1 && pace->way * pace->dk > 0;
}

// 1 if k′ is gone within so much of the plan's time, half a period before the clock stands or runs.
static int eases_within(const nck_allow_pace_t *pace, nck_num change, nck_num far, nck_num period) {
    if (!(pace->way * change < 0)) return 0;
    const nck_num time = -pace->dk / change;
    const nck_num k = pace->k + NCK_NUM_OF(0.5) * pace->dk * (time + period);
    return k >= 0 && k <= 1 && time * (pace->k + pace->dk * time / 3) <= far;
}

// Try to ease off along a stretch.
static void try_stretch(ease_trial_t *trial, const nck_stretch_walk_t *walk,
                        const nck_stretch_t *on) {
    nck_allow_pace_t *const pace = &trial->pace;
    const nck_num free = time_for(pace, 0, on->far);
    nck_allow_t range;
    nck_allow_all(&range, walk, on, pace, free, trial->share);
    trial->verdict = EASE_BAD;
    if (range.low > range.high) return;
    const nck_num easing = pace->way < 0 ? range.high : range.low;
    if (eases_within(pace, easing, on->far, walk->period)) {
        trial->verdict = EASE_GOOD;
        return;
    }
    const nck_num time = time_for(pace, easing, on->far);
    if (!(time > 0)) return;
    pace->k += (pace->dk + NCK_NUM_OF(0.5) * easing * time) * time;
    pace->dk += easing * time;
    if (is_on_way(pace)) trial->verdict = EASE_OPEN;
}

// Which trial is the first that is not known to be bad.
static int first_of(const ease_trial_t *trials, int count) {
    int i = 0;
    while (i < count && trials[i].verdict == EASE_BAD) i++;
    return i;
}

// Try to ease off along a stretch, from a trial on. Those behind one that can are asked nothing.
// Returns how many are left.
static int try_each(ease_trial_t *trials, int first, int count, const nck_stretch_walk_t *walk,
                    const nck_stretch_t *on) {
    for (int i = first; i < count && on->far > 0; i++) {
        if (trials[i].verdict == EASE_OPEN) try_stretch(&trials[i], walk, on);
        if (trials[i].verdict == EASE_GOOD) return i + 1;
    }
    return count;
}

// The first trial, from the hardest on, that can ease off behind the period; NULL: none. What is
// open at the end cannot. k: about that behind the period.
static const ease_trial_t *try_all(ease_trial_t *trials, int count, nck_stretch_walk_t *walk,
                                   nck_stretch_t *on, nck_num k) {
    const nck_num least = k * walk->period;
    nck_num gone = 0;
    int left = count;
    int first = first_of(trials, left);
    for (int n = 0; n < PLACES && first < left && !walk->ends; n++) {
        if (trials[first].verdict == EASE_GOOD) return &trials[first];
        nck_stretch_take(walk, nck_num_max(least, gone / (nck_num)NEAR_PLACES), on);
        gone += on->far;
        left = try_each(trials, first, left, walk, on);
        first = first_of(trials, left);
    }
    const int rests = walk->ends != 0; // the plan does
    while (first < left && trials[first].verdict != EASE_GOOD && !rests) first++;
    return first < left ? &trials[first] : NULL;
}

// 1 where k′ is to be taken away upwards: it slows down, or is about to.
static int is_slowing(const nck_allow_pace_t *pace) {
    return pace->dk < 0 || (pace->way < 0 && !(pace->dk > 0));
}

// The hardest k″ in a period that sets off: easing off behind it, k comes to 1 by two thirds of the
// way, so that it never passes it.
static nck_num change_to_run(const nck_allow_pace_t *pace, nck_num period) {
    return (1 - pace->k - 2 * pace->dk * period) / (NCK_NUM_OF(1.5) * period * period);
}

// What k″ must be for k′ to be gone when k is 1.
static nck_num change_by_run(const nck_allow_pace_t *pace, nck_num period) {
    const nck_num left = nck_num_max(1 - pace->k, NCK_NUM_OF(0.5) * pace->dk * period);
    return -NCK_NUM_OF(0.5) * pace->dk * pace->dk / left;
}

// Where no k″ is known behind which k′ can be eased off, easing off at once among them, of a clock
// that sets off: a plan has come that brakes, so that its axes allow less than was counted on. Once
// it takes all that axes allow without the plan (most), k′ is led to be gone when k is 1: the plan
// is never overtaken.
static int is_last(const nck_allow_pace_t *pace, nck_num most, nck_num period) {
    return pace->way > 0 && pace->dk > 0 && -change_by_run(pace, period) > most;
}

static nck_num change_at_last(const nck_allow_pace_t *pace, nck_num change, nck_num most,
                              nck_num period) {
    if (!is_last(pace, most, period)) return change;
    return nck_num_min(change, change_by_run(pace, period));
}

static ease_trial_t trial_of(const nck_allow_pace_t *pace, nck_num change, nck_num period) {
    ease_trial_t trial;
    trial.change = change;
    trial.share = pace->way < 0 ? SHARE_AHEAD : OFF_AHEAD;
    trial.verdict = EASE_GOOD;
    trial.pace.way = pace->way;
    trial.pace.dk = pace->dk + change * period;
    trial.pace.k = pace->k + NCK_NUM_OF(0.5) * (pace->dk + trial.pace.dk) * period;
    if (!(trial.pace.k > 0) || trial.pace.k > 1) trial.verdict = EASE_BAD;
    else if (is_on_way(&trial.pace)) trial.verdict = EASE_OPEN;
    return trial;
}

// Who sets off may count on more to ease off.
static void set_last(ease_trial_t *trial, const nck_allow_pace_t *pace, nck_num change,
                     nck_num period) {
    *trial = trial_of(pace, change, period);
    trial->share = OFF_LAST;
}

// What is tried in a period, the hardest first: the share of the range that may have lasted before,
// of a brake also half of it, and both as softly as every part of the period wants it; of who is
// released that alone, or as softly as samples want it. So does who sets off; where it is to run
// soon instead of speeding up, and by what is kept for it. Returns how many.
static int set_trials(ease_trial_t *trials, const nck_allow_pace_t *pace, const ease_reach_t *reach,
                      nck_num share, nck_num period) {
    const nck_num hard = reach->room * share;
    const nck_num softer = NCK_NUM_OF(0.5) * hard;
    trials[0] = trial_of(pace, nck_num_min(reach->soft, reach->least + hard), period);
    trials[1] = trial_of(pace, nck_num_min(reach->soft, reach->least + softer), period);
    if (pace->way < 0 && share > 0) return TRIALS;
    if (pace->way < 0) {
        trials[1] = trial_of(pace, reach->gentle, period);
        return reach->soft < reach->least ? TRIALS : 0;
    }
    const int is_gentle = reach->gentle > reach->last;
    if (!reach->lasts && !is_gentle) return 1;
    set_last(&trials[reach->lasts ? 0 : 1], pace, reach->gentle, period);
    if (reach->lasts && !is_gentle) return 1;
    if (reach->lasts) set_last(&trials[1], pace, reach->last, period);
    return TRIALS;
}

// The hardest k″ in a period of what is tried, behind which k′ can be eased off again; else what
// eases off. Whether that can be done is asked where something else may be.
static nck_num choose(const nck_allow_pace_t *pace, const ease_range_t *range, ease_wish_t *wish,
                      nck_stretch_walk_t *walk, nck_stretch_t *on) {
    const nck_num period = walk->period;
    const int brakes = pace->way < 0;
    const nck_num gone = -pace->dk / period; // … k′ is then
    const nck_num most = nck_num_min(range->all.high, change_to_run(pace, period));
    ease_reach_t reach;
    reach.least =
        gone < 0 ? nck_num_max(gone, range->all.low) : nck_num_min(gone, range->all.high);
    reach.room = brakes ? nck_num_min(0, range->all.low - reach.least)
                        : nck_num_max(0, most - reach.least);
    reach.soft = brakes ? range->soft : reach.least + reach.room;
    reach.lasts = is_last(pace, LAST_SHARE * wish->free, period);
    reach.last = brakes ? reach.least : nck_num_max(gone, nck_num_min(reach.least, range->last));
    reach.gentle = brakes ? nck_num_min(reach.least, range->gentle)
                          : nck_num_max(reach.last, nck_num_min(range->gentle, 0));
    const nck_num half = NCK_NUM_OF(0.5);
    const nck_num gains = half * nck_num_max(0, reach.room) * period;
    const nck_num k = pace->k + (pace->dk + gains) * period;
    ease_trial_t trials[TRIALS];
    const int count = set_trials(trials, pace, &reach, wish->share, period);
    const ease_trial_t *const found =
        try_all(trials, count, walk, on, nck_num_max(0, nck_num_min(k, 1)));
    const nck_num grows = brakes ? 2 : NCK_NUM_OF(1.5); // what sets off is in no hurry
    if (found == &trials[0]) wish->share = nck_num_min(1, grows * wish->share);
    else if (!brakes || !found) wish->share = nck_num_max(SHARE_LEAST, half * wish->share);
    return found ? found->change : change_at_last(pace, reach.last, wish->free, period);
}

// What is allowed in a period in which the plan's jerk jumps: in its parts, as far as its mean
// allows that, and what is counted on of easing off (ahead). What samples show only softens k″: an
// axis that turns round hardly hears of it, and would ask for any. Easing off is softened so only
// where that can go on, or, of a brake whose k still grows, where twice what it needs is left.
static void bound_jumps(ease_range_t *range, const nck_allow_pace_t *pace, nck_num period,
                        const nck_allow_parts_t *parts, const nck_allow_t *ahead) {
    const nck_allow_t mean = range->all;
    nck_allow_t *const all = &range->all;
    const int slows = is_slowing(pace);
    const nck_num low = slows ? mean.high : nck_num_max(mean.low, ahead->low);
    const nck_num high = slows ? nck_num_min(mean.high, ahead->high) : mean.low;
    const nck_num ends_low = nck_num_min(parts->ends.low, 0);
    const nck_num ends_high = nck_num_max(parts->ends.high, 0);
    all->low = nck_num_max(mean.low, nck_num_min(parts->each.low, low));
    all->high = nck_num_min(mean.high, nck_num_max(parts->each.high, high));
    range->soft = nck_num_max(all->low, nck_num_min(all->high, parts->each.high));
    if (pace->way > 0 && !slows) {
        all->high = nck_num_min(all->high, nck_num_max(ends_high, all->low));
        range->gentle = nck_num_max(range->last, nck_num_min(ends_low, mean.high));
        return;
    }
    const nck_num needs = slows ? 0 : 2 * change_by_run(pace, period);
    const nck_num most = nck_num_min(all->high, needs);
    all->low = nck_num_max(all->low, nck_num_min(ends_low, most));
    if (!slows) return;
    range->gentle = nck_num_max(all->low, ends_high);
    range->soft = nck_num_max(all->low, nck_num_min(range->soft, ends_high));
}

// What is allowed in the period: in its mean, and, where the plan's jerk jumps in it, beyond that.
static void bound_period(ease_range_t *range, nck_stretch_walk_t *walk,
                         const nck_allow_pace_t *pace, nck_num far, nck_stretch_t *on) {
    const nck_num period = walk->period;
    const nck_num share = pace->way < 0 ? SHARE_TAKEN : OFF_TAKEN;
    const nck_num counts_on = is_slowing(pace) ? SHARE_AHEAD : OFF_AHEAD;
    const int jumps = walk->t + far > (nck_num)walk->cell->duration;
    nck_stretch_walk_t again = *walk;
    nck_stretch_t part;
    nck_allow_t ahead;
    nck_allow_parts_t parts;
    part.to = on->to;
    nck_stretch_take(walk, far, on);
    nck_allow_all(&range->all, walk, on, pace, period, share);
    range->soft = range->all.high;
    range->last = range->all.low;
    range->gentle = pace->way < 0 ? range->soft : range->last;
    if (range->all.low > range->all.high || (!jumps && pace->way < 0)) return;
    nck_allow_all(&ahead, walk, on, pace, period, jumps ? counts_on : OFF_LAST);
    if (!jumps) {
        range->last = ahead.low;
        range->gentle = ahead.low;
        return;
    }
    nck_allow_parts(&parts, &again, pace, far, share, &part);
    bound_jumps(range, pace, period, &parts, &ahead);
}

// k″ in the period that begins where the walk does. Where the plan comes to its rest in it, none:
// that is its own. Never does k′ turn round.
static nck_num change_for(const nck_allow_pace_t *pace, nck_stretch_walk_t *walk,
                          ease_wish_t *wish) {
    const nck_num period = walk->period;
    const nck_num half = NCK_NUM_OF(0.5);
    const nck_num k = nck_num_max(half * pace->k, pace->k + half * pace->dk * period);
    nck_stretch_t on;
    ease_range_t range;
    nck_stretch_look(walk, &on.to);
    bound_period(&range, walk, pace, k * period, &on);
    wish->free = nck_allow_free(walk, &on.to);
    wish->most = pace->way < 0 ? range.all.high : wish->free;
    if (walk->ends) return 0;
    if (range.all.low <= range.all.high) return choose(pace, &range, wish, walk, &on);
    const nck_num gone = -pace->dk / period;
    const nck_num between = nck_allow_between(&range.all);
    const nck_num change = pace->way < 0 ? nck_num_min(between, nck_num_max(0, gone))
                                         : nck_num_max(between, nck_num_min(0, gone));
    return change_at_last(pace, change, wish->free, period);
}

// The same, where prep may publish another plan at any time: then that counts. It does so once in
// many periods.
static nck_num change_now(const nck_allow_pace_t *pace, const nck_stretch_walk_t *here,
                          ease_wish_t *wish) {
    for (int round = 0; round < 2; round++) {
        nck_stretch_walk_t walk = *here;
        walk.word = nck_link_word(walk.link);
        const nck_num change = change_for(pace, &walk, wish);
        if (nck_link_holds(walk.link, walk.word)) return change;
    }
    return 0;
}

void nck_ease_begin(nck_clock_t *clock) {
    if (clock->state == NCK_CLOCK_RUNS) {
        clock->first.rate = 1.0;
        clock->second.gain = 0.0;
    }
    clock->share = 1;
    nck_fence_store(&clock->state, NCK_CLOCK_BRAKES);
}

void nck_ease_release(nck_clock_t *clock) {
    if (clock->state == NCK_CLOCK_BRAKES) nck_fence_store(&clock->state, NCK_CLOCK_SETS_OFF);
}

// The clock at a pace that is reached, or at its rest or its run next to it. near: of k [1/s].
static void take_pace(nck_clock_t *clock, int brakes, double near, double period) {
    const double k = clock->first.rate;
    const int rests = brakes && !(k > near * period);
    const int is_near = 1.0 - k <= near * period && clock->second.gain <= near;
    const int is_whole = k >= 1.0; // never beyond
    const int runs = !brakes && (is_near || is_whole);
    if (rests || runs || is_whole) {
        clock->first.rate = rests ? 0.0 : 1.0;
        clock->second.gain = 0.0;
    }
    if (runs) nck_fence_store(&clock->state, NCK_CLOCK_RUNS);
    if (rests && clock->state == NCK_CLOCK_SETS_OFF) nck_clock_go_on(clock);
}

double nck_ease_period(nck_clock_t *clock, const nck_terms_t *terms, nck_link_t *link,
                       const nck_cell_t *cell, double t) {
    const double period = terms->machine->period_s;
    const double k = clock->first.rate;
    const double dk = clock->second.gain;
    const int released = clock->state == NCK_CLOCK_SETS_OFF && dk < 0.0;
    const int brakes = clock->state == NCK_CLOCK_BRAKES || released;
    const nck_allow_pace_t pace = {(nck_num)k, (nck_num)dk, brakes ? -1 : 1};
    const nck_stretch_walk_t here = {.terms = terms, .link = link, .cell = cell, .t = (nck_num)t,
                                     .period = (nck_num)period};
    ease_wish_t wish = {released ? 0 : clock->share, 0, 0};
    if (!brakes && clock->feels > 0) { // a rest may end with a jerk of its own
        clock->feels--;
        return 0.0;
    }
    const double change = (double)change_now(&pace, &here, &wish);
    clock->share = released ? 1 : wish.share;
    clock->first.rate = k + (dk + 0.5 * change * period) * period;
    const double gain = dk + change * period;
    clock->second.gain = released && gain > GONE_EPSILON * dk ? 0.0 : gain;
    const nck_num near = (brakes ? REST_SHARE : RUN_SHARE) * wish.most;
    take_pace(clock, brakes, (double)near * period, period);
    if (!(clock->first.rate > 0.0)) return 0.5 * k * period;
    return (k + (0.5 * dk + change / 6.0 * period) * period) * period;
}

void nck_ease_rest(nck_clock_t *clock, int moves) {
    if (clock->state == NCK_CLOCK_SETS_OFF) {
        if (!moves) nck_fence_store(&clock->state, NCK_CLOCK_RUNS);
        return;
    }
    if (moves && !(clock->first.rate > 0.0)) nck_fence_store(&clock->state, NCK_CLOCK_STANDS);
}
