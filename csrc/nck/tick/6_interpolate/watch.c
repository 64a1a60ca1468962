// SPDX-License-Identifier: MIT
// Inside room 6: whether prep brings the rest that is asked for, and is there at all.
#include "nck/tick/6_interpolate/watch.h"

#include "nck/base/real.h" // nck_min nck_sqrt

// Periods that prep has to plan a rest that is asked for, and to be seen at all while the tick is
// on the tail, before the tick brakes by itself.
enum { ANSWER_PERIODS = 10, GONE_PERIODS = 50 };

// A plan takes over between the knots of a clocked path: so many of them are a reason to wait.
#define ANSWER_KNOTS 2.5

// A planned rest at the caps of bends takes so many times what one along a line does, at most.
#define PLANNED_MOST 3.0

// Periods within which it has to be planned.
static uint32_t answer_periods(const nck_terms_t *terms) {
    const double knots = ANSWER_KNOTS * terms->knot_s / terms->machine->period_s;
    return knots > (double)ANSWER_PERIODS ? (uint32_t)knots : (uint32_t)ANSWER_PERIODS;
}

// Periods within which a planned rest has come.
static uint32_t rest_periods(const nck_terms_t *terms, double v) {
    const nck_machine_t *const machine = terms->machine;
    double a = machine->path.a_max;
    double j = machine->path.j_max;
    for (int x = 0; x < terms->axes; x++) {
        if (!machine->axis[x].present) continue;
        a = nck_min(a, machine->axis[x].a_max);
        j = nck_min(j, machine->axis[x].j_max);
    }
    const double ramps = v > a * a / j ? v / a + a / j : 2.0 * nck_sqrt(v / j);
    const double s = PLANNED_MOST * (terms->limits_jerk ? ramps : v / a);
    const double most = (double)UINT32_MAX / 2.0;
    return answer_periods(terms) + (uint32_t)nck_min(s / machine->period_s, most);
}

static uint32_t one_more(uint32_t periods) {
    return periods < UINT32_MAX ? periods + 1 : periods;
}

// 1 if prep is not seen any more while the tick is on the tail. Once it is back the tail is
// followed to its rest: there prep can go on.
static int is_gone(nck_watch_t *self, int on_tail) {
    if (!on_tail) {
        self->gone = 0;
        self->back = 0;
        return 0;
    }
    const int unseen = self->unseen > GONE_PERIODS;
    if (self->gone && !unseen) self->back = 1;
    self->gone = unseen && !self->back;
    return self->gone;
}

// 1 if the rest that is asked for has no plan in time, or takes too long.
static int is_late(nck_watch_t *self, const nck_terms_t *terms, const nck_watched_t *seen) {
    self->asked = seen->asks ? one_more(self->asked) : 0;
    if (self->asked == 1) self->most = rest_periods(terms, seen->v);
    const int unplanned = self->asked > answer_periods(terms) && !seen->planned;
    const int late = unplanned || self->asked > self->most;
    self->stops = seen->asks && (late || seen->slow || self->stops);
    return self->stops;
}

nck_tick_state_t nck_watch_tick(nck_watch_t *self, const nck_terms_t *terms,
                                const nck_watched_t *seen) {
    const int is_seen = seen->steps != self->steps || seen->steps == 0;
    self->unseen = is_seen ? 0 : one_more(self->unseen);
    self->steps = seen->steps;
    const int asks = seen->asks || self->asked > 0;
    const int late = asks && is_late(self, terms, seen);
    const int gone = is_gone(self, seen->on_tail);
    return late ? NCK_TICK_HOLD : gone ? NCK_TICK_STARVED : NCK_TICK_IDLE;
}
