// SPDX-License-Identifier: MIT
// Inside room 6: how the tick brakes along a clocked path, and sets off again.
//
// The tool is where the plan is at the time φ, which goes on at the rate k = dφ/dt:
//     x″ = p″k² + p′k′      x‴ = p‴k³ + 3p″kk′ + p′k″      by the plan's time: p′, p″, p‴
// At any constant k ≤ 1 accelerations and jerks are less than the plan's own, which keeps the
// limits. So both can go on from wherever k′ can be taken away again, with k between 0 and 1: that
// is tried along the plan that is known, stretch by stretch. p‴ is the mean of one, as periods show
// it. A path with limits of its own is one more axis: what of all axes has its direction.
//
// What is seen of a period is its samples: differences of places over two periods and three. So the
// clock chooses those of φ, one after the other. k″ is the third difference of φ over T³, in the
// middle of the three periods; k and k′ are where the period begins, so that φ goes on by
// (k + k′T/2)·T with those behind k″. Where the axes have been is known, where they come to without
// k″ as well, so what a sample takes is no estimate, whatever the plan does within a period.
#include "nck/tick/6_interpolate/ease.h"

#include <stddef.h> // NULL

#include "nck/base/fence.h"                 // nck_fence_store
#include "nck/base/real.h"                  // nck_num
#include "nck/tick/6_interpolate/allow.h"   // nck_allow_…
#include "nck/tick/6_interpolate/stretch.h" // nck_stretch_…

// Of an axis' acceleration and jerk, what a sample may take where the plan takes less: all, but for
// what single precision leaves, …
#define SHARE_TAKEN NCK_NUM_OF(0.99999)
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
// Of all that axes have in a period, so slow that the clock may rest …
#define REST_SHARE NCK_NUM_OF(0.98)
// … and so near 1 that it may run: the plan may take all of it.
#define RUN_SHARE NCK_NUM_OF(0.001)

// Of k′ that a released clock eases off, what rounding leaves (6e-8 in single precision) and more.
#define GONE_EPSILON 1e-6

// Of the range of k″, what is tried at least; of a clock that sets off, where the plan takes nearly
// all: with 0.25 one along a helix by all of its jerk crept.
#define SHARE_LEAST NCK_NUM_OF(0.25)
#define OFF_LEAST NCK_NUM_OF(0.01)

// Numbers of the solvers' type are enough for how fast and how hard: the clock itself is kept in
// double precision. Where a processor has no doubles in hardware they take a tenth of the time.
enum {
    TRIALS = 2,      // how hard k may change
    PLACES = 36,     // looked at ahead: 340 periods. With 24 over 347 a starved run took 1.024 of
                     // an axis' jerk
    NEAR_PLACES = 7, // stretches grow by 1/7 from there on
    TIME_STEPS = 2   // to a time: each halves the digits that lack
};

// What all axes allow of k″, and how it may be chosen in a period [1/s²].
typedef struct ease_range {
    nck_allow_t all;
    nck_num last;  // what eases off where nothing else can: of who sets off, by all that there is
    nck_num least; // what eases off
    nck_num room;  // from there to the hardest
    int lasts;     // 1: it sets off, and is to run soon
} ease_range_t;

// What is known before of a period's k″.
typedef struct ease_wish {
    nck_num share; // of the range, that may last: the next period's then
    nck_num goal;  // by which the clock rests, or runs, from this period on [1/s²]
    nck_num left;  // … then k″ of the next one
    nck_num free;  // what all axes allow without the plan [1/s²]
    int reached;   // 1: it does
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

// What k″ must be for k′ to be gone when k is 1.
static nck_num change_by_run(const nck_allow_pace_t *pace, const ease_wish_t *wish,
                             nck_num period) {
    const nck_num soon = NCK_NUM_OF(0.5) * pace->dk / period;
    return -NCK_NUM_OF(0.5) * pace->dk / period * pace->dk / period
           / nck_num_max(wish->left, soon);
}

// Where no k″ is known behind which k′ can be eased off, easing off at once among them, of a clock
// that sets off: a plan has come that brakes, so that its axes allow less than was counted on. Once
// it takes so much of what they allow without the plan, k′ is led to be gone when k is 1: the plan
// is never overtaken.
static int is_last(const nck_allow_pace_t *pace, const ease_wish_t *wish, nck_num share,
                   nck_num period) {
    return pace->way > 0 && pace->dk > 0
           && -change_by_run(pace, wish, period) > share * wish->free;
}

static nck_num change_at_last(const nck_allow_pace_t *pace, nck_num change,
                              const ease_wish_t *wish, nck_num period) {
    if (!is_last(pace, wish, 1, period)) return change;
    return nck_num_min(change, change_by_run(pace, wish, period));
}

static ease_trial_t trial_of(const nck_allow_pace_t *pace, nck_num change, nck_num period) {
    ease_trial_t trial;
    trial.change = change;
    trial.share = pace->way < 0 ? SHARE_AHEAD : OFF_AHEAD;
    trial.verdict = EASE_GOOD;
    trial.pace.way = pace->way;
    trial.pace.dk = pace->dk + change * period;
    trial.pace.k = pace->k + NCK_NUM_OF(0.5) * (pace->dk + trial.pace.dk) * period;
    const nck_num rate = trial.pace.k + NCK_NUM_OF(0.5) * trial.pace.dk * period;
    if (!(rate > 0) || rate > 1) trial.verdict = EASE_BAD;
    else if (is_on_way(&trial.pace)) trial.verdict = EASE_OPEN;
    return trial;
}

// What is tried in a period, the hardest first: the share of the range that may have lasted before,
// and of a brake half of it; of who is released none. Who is to run soon eases off, by what is kept
// for that. Returns how many.
static int set_trials(ease_trial_t *trials, const nck_allow_pace_t *pace, const ease_range_t *range,
                      nck_num share, nck_num period) {
    const nck_num hard = range->room * share;
    if (pace->way < 0 && !(share > 0)) return 0;
    trials[0] = trial_of(pace, range->lasts ? range->last : range->least + hard, period);
    if (range->lasts) trials[0].share = OFF_LAST;
    if (pace->way > 0) return 1;
    trials[1] = trial_of(pace, range->least + NCK_NUM_OF(0.5) * hard, period);
    return TRIALS;
}

// The hardest k″ in a period of what is tried, behind which k′ can be eased off again; else what
// eases off. Whether that can be done is asked where something else may be.
static nck_num choose(const nck_allow_pace_t *pace, ease_range_t *range, ease_wish_t *wish,
                      nck_stretch_walk_t *walk, nck_stretch_t *on) {
    const nck_num half = NCK_NUM_OF(0.5);
    const nck_num period = walk->period;
    const int brakes = pace->way < 0;
    const nck_num gone = -pace->dk / period; // … k′ is then
    // Of who sets off: with the k′ behind it 1 is not passed in the next period.
    const nck_num most = nck_num_min(range->all.high, half * (wish->goal + gone));
    range->least =
        gone < 0 ? nck_num_max(gone, range->all.low) : nck_num_min(gone, range->all.high);
    range->room = brakes ? nck_num_min(0, range->all.low - range->least)
                         : nck_num_max(0, most - range->least);
    range->lasts = is_last(pace, wish, LAST_SHARE, period);
    range->last = brakes ? range->least : nck_num_max(gone, nck_num_min(range->least, range->last));
    const nck_num gains = half * nck_num_max(0, range->room) * period;
    const nck_num k = pace->k + (pace->dk + gains) * period;
    ease_trial_t trials[TRIALS];
    const int count = set_trials(trials, pace, range, wish->share, period);
    const ease_trial_t *const found =
        try_all(trials, count, walk, on, nck_num_max(0, nck_num_min(k, 1)));
    const nck_num grows = brakes ? 2 : NCK_NUM_OF(1.5); // what sets off is in no hurry
    const nck_num least = brakes ? SHARE_LEAST : OFF_LEAST;
    if (found == &trials[0]) wish->share = nck_num_min(1, grows * wish->share);
    else if (!brakes || !found) wish->share = nck_num_max(least, half * wish->share);
    return found ? found->change : change_at_last(pace, range->last, wish, period);
}

// What is allowed in the period.
static void bound_period(ease_range_t *range, const nck_stretch_walk_t *walk, nck_num way,
                         const nck_allow_sample_t *samples, nck_num from) {
    nck_allow_now(&range->all, walk, samples, way < 0 ? SHARE_TAKEN : OFF_TAKEN);
    range->all.low += from;
    range->all.high += from;
    range->last = range->all.low;
    if (way < 0) return;
    nck_allow_t last;
    nck_allow_now(&last, walk, samples, SHARE_TAKEN);
    range->last = last.low;
    if (range->all.low > range->all.high) range->all = last;
}

// k″ in the period that begins where the walk does. Where the plan comes to its rest in it, none:
// that is its own. Never does k′ turn round.
static nck_num change_for(const nck_allow_pace_t *pace, nck_stretch_walk_t *walk,
                          const nck_allow_period_t *now, ease_wish_t *wish) {
    const nck_num period = walk->period;
    nck_allow_sample_t samples[NCK_AXIS_MAX];
    nck_stretch_t on;
    ease_range_t range;
    nck_stretch_look(walk, &on.to);
    nck_allow_look(samples, walk, now, &on.to, pace);
    bound_period(&range, walk, pace->way, samples, now->change);
    wish->free = nck_allow_free(walk, &on.to);
    const nck_num left = (pace->way < 0 ? REST_SHARE : RUN_SHARE) * wish->free;
    wish->reached =
        wish->left <= left && wish->goal >= range.last && wish->goal <= range.all.high;
    if (wish->reached) return wish->goal;
    if (range.all.low <= range.all.high) return choose(pace, &range, wish, walk, &on);
    const nck_num gone = -pace->dk / period;
    const nck_num between = nck_allow_between(&range.all);
    const nck_num change = pace->way < 0 ? nck_num_min(between, nck_num_max(0, gone))
                                         : nck_num_max(between, nck_num_min(0, gone));
    return change_at_last(pace, change, wish, period);
}

// The same, where prep may publish another plan at any time: then that counts. It does so once in
// many periods.
static nck_num change_now(const nck_allow_pace_t *pace, const nck_stretch_walk_t *here,
                          const nck_allow_period_t *now, ease_wish_t *wish) {
    for (int round = 0; round < 2; round++) {
        nck_stretch_walk_t walk = *here;
        walk.word = nck_link_word(walk.link);
        const nck_num change = change_for(pace, &walk, now, wish);
        if (nck_link_holds(walk.link, walk.word)) return change;
    }
    wish->reached = 0;
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

// The clock at the pace that is reached, or at its rest or its run. The rate of the period is
// k + k′T/2: they are those of one before.
static void take_pace(nck_clock_t *clock, int brakes, int reached, double period) {
    const double rate = clock->first.rate + 0.5 * clock->second.gain * period;
    const int is_whole = rate >= 1.0; // never beyond
    const int rests = brakes && (reached || !(rate > 0.0));
    const int runs = !brakes && (reached || is_whole);
    if (rests || runs || is_whole) {
        clock->first.rate = rests ? 0.0 : 1.0;
        clock->second.gain = 0.0;
    }
    if (runs) nck_fence_store(&clock->state, NCK_CLOCK_RUNS);
    if (rests && clock->state == NCK_CLOCK_SETS_OFF) nck_clock_go_on(clock);
}

double nck_ease_period(nck_clock_t *clock, const nck_terms_t *terms, nck_link_t *link,
                       const nck_cell_t *cell, double t, const nck_stretch_past_t *past) {
    const double period = terms->machine->period_s;
    const double k = clock->first.rate;
    const double dk = clock->second.gain;
    const int released = clock->state == NCK_CLOCK_SETS_OFF && dk < 0.0;
    const int brakes = clock->state == NCK_CLOCK_BRAKES || released;
    const nck_allow_pace_t pace = {(nck_num)k, (nck_num)dk, brakes ? -1 : 1};
    nck_stretch_limit_t limit[NCK_AXIS_MAX + 1];
    const nck_stretch_walk_t here = {.terms = terms, .limit = limit, .link = link, .cell = cell,
                                     .t = (nck_num)t, .period = (nck_num)period};
    const double rate = k + 0.5 * dk * period;
    const double goal = brakes ? 0.0 : 1.0;
    const double per = 1.0 / (period * period);
    const double next = nck_max(0.0, rate + dk * period);
    const nck_allow_period_t now = {past, t, next * period,
                                    (nck_num)((next - rate - dk * period) * per)};
    ease_wish_t wish = {released ? 0 : clock->share, (nck_num)((goal - rate - dk * period) * per),
                        (nck_num)(nck_fabs(goal - rate) * per), 0, 0};
    if (!brakes && clock->feels > 0) { // a rest may end with a jerk of its own
        clock->feels--;
        return 0.0;
    }
    nck_stretch_limits(terms, limit);
    const double change = (double)change_now(&pace, &here, &now, &wish);
    clock->share = released ? 1 : wish.share;
    clock->first.rate = k + (dk + 0.5 * change * period) * period;
    const double gain = dk + change * period;
    clock->second.gain = released && gain > GONE_EPSILON * dk ? 0.0 : gain;
    take_pace(clock, brakes, wish.reached, period);
    return (clock->first.rate + 0.5 * clock->second.gain * period) * period;
}

void nck_ease_rest(nck_clock_t *clock, int moves) {
    if (clock->state == NCK_CLOCK_SETS_OFF) {
        if (!moves) nck_fence_store(&clock->state, NCK_CLOCK_RUNS);
        return;
    }
    if (moves && !(clock->first.rate > 0.0)) nck_fence_store(&clock->state, NCK_CLOCK_STANDS);
}
