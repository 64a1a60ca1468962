// SPDX-License-Identifier: MIT
// Inside room 6: whether prep brings the rest that is asked for, and is there at all.
#include "nck/tick/6_interpolate/watch.h"

#include "nck/base/real.h" // nck_min nck_sqrt

// Periods that prep has to plan a rest that is asked for, and to be seen at all while the tick is
// on the tail, before the tick brakes by itself. Along a clocked path it does so at once.
enum { ANSWER_PERIODS = 10, GONE_PERIODS = 50 };

// A rest may take so many times what one along a line does, with LINE_PERIODS to hear of it. Later
// than the tick itself could come to rest by then, it waits for no plan.
#define REST_MOST 1.2
enum { LINE_PERIODS = 20 };

// Of an axis' jerk, what a brake of the tick begins and ends with: see clock.c.
#define BRAKE_SHARE 0.9

// Periods that a rest along a line takes, from a speed and what it has gained in a period, by a
// share of all jerk.
static double line_periods(const nck_terms_t *terms, double v, double gain, double share) {
    const nck_machine_t *const machine = terms->machine;
    const double period = machine->period_s;
    double a = machine->path.a_max;
    double j = machine->path.j_max;
    for (int x = 0; x < terms->axes; x++) {
        if (!machine->axis[x].present) continue;
        a = nck_min(a, machine->axis[x].a_max);
        j = nck_min(j, machine->axis[x].j_max);
    }
    const double most = (double)(UINT32_MAX / 4u);
    if (!terms->limits_jerk) return nck_min(v / a / period, most);
    j *= share;
    const double back = nck_max(0.0, nck_min(gain / period, a)) / j; // until it gains no more
    const double top = v + 0.5 * j * back * back;
    const double ramps = top > a * a / j ? top / a + a / j : 2.0 * nck_sqrt(top / j);
    return nck_min((back + ramps) / period, most);
}

// Periods that the tick takes to brake there: the filter rests behind it.
static double brake_periods(const nck_terms_t *terms, double v, double gain) {
    return line_periods(terms, v, gain, BRAKE_SHARE) + (double)terms->taps - 1.0;
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
    if (!seen->asks) {
        self->asked = 0;
        self->stops = 0;
        return 0;
    }
    self->asked = one_more(self->asked);
    const double gain = seen->v - self->v;
    if (self->asked == 1) {
        const double line = line_periods(terms, seen->v, gain, 1.0);
        self->most = (uint32_t)(REST_MOST * (line + (double)LINE_PERIODS));
    }
    const int unplanned = self->asked > ANSWER_PERIODS && !seen->planned;
    const double brake = brake_periods(terms, seen->ahead_v, seen->ahead_gain);
    const double last = (double)self->asked + brake;
    const int late = unplanned || last > (double)self->most;
    self->stops = late || seen->at_once || self->stops;
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
    self->v = seen->v;
    return late ? NCK_TICK_HOLD : gone ? NCK_TICK_STARVED : NCK_TICK_IDLE;
}
