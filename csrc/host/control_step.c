// SPDX-License-Identifier: MIT
// Marlin's stepper. The interval before a step is that of the rate at the step before it, and the
// first two of a line are those of the rate that it begins with. So a line of few steps, and one
// that begins slowly, lasts longer than its trapezoid; rates are whole numbers.
#include "host/control_parts.h"

#include "nck/base/real.h" // nck_floor nck_max nck_min nck_sqrt

// Its timer is no slower [1/s].
#define RATE_LEAST 120.0
// Beyond so many √a the rate hardly changes from step to step, and sums are integrals.
#define SMOOTH 14.0

// Rates of a line [1/s], a [1/s²], and its steps.
typedef struct rates {
    double begin, end, most, a;
    double up, top, down;
} rates_t;

static double up_to_whole(double x) { return -nck_floor(-x); }

static rates_t rates_of(const nck_host_control_line_t *line, const double ends[2]) {
    const double per_mm = line->steps / line->length;
    rates_t r;
    r.a = up_to_whole(line->a * per_mm);
    r.most = nck_max(RATE_LEAST, up_to_whole(line->v * per_mm));
    r.begin = nck_max(RATE_LEAST, up_to_whole(nck_sqrt(ends[0]) * per_mm));
    r.end = nck_max(RATE_LEAST, up_to_whole(nck_sqrt(ends[1]) * per_mm));
    r.begin = nck_min(r.begin, r.most);
    r.end = nck_min(r.end, r.most);
    r.up = up_to_whole((r.most * r.most - r.begin * r.begin) / (2.0 * r.a));
    r.down = nck_floor((r.most * r.most - r.end * r.end) / (2.0 * r.a));
    if (r.up + r.down > line->steps) {
        const double half = (r.end * r.end - r.begin * r.begin) / (4.0 * r.a);
        r.up = nck_max(0.0, nck_min(line->steps, up_to_whole(0.5 * line->steps + half)));
        r.down = line->steps - r.up;
    }
    r.top = line->steps - r.up - r.down;
    return r;
}

// Intervals of steps at a growing rate; *rate: at first, and that of the last of them.
static double ramp_up(const rates_t *r, double steps, double *rate) {
    const double smooth = SMOOTH * nck_sqrt(r->a);
    double time_s = 0.0;
    double next = *rate;
    while (steps >= 1.0 && next < smooth && next < r->most) {
        *rate = next;
        time_s += 1.0 / next;
        next = nck_min(r->most, next + r->a / next);
        steps -= 1.0;
    }
    if (steps < 1.0) return time_s;
    const double reach = nck_sqrt(next * next + 2.0 * r->a * steps);
    const double end = nck_min(r->most, reach);
    const double ramp = (end * end - next * next) / (2.0 * r->a);
    *rate = reach > r->most ? end : end - r->a / end;
    return time_s + (end - next) / r->a + 0.5 * (1.0 / next - 1.0 / end) + (steps - ramp) / end;
}

// The same at a falling one.
static double ramp_down(const rates_t *r, double steps, double rate) {
    const double smooth = SMOOTH * nck_sqrt(r->a);
    double time_s = 0.0;
    if (rate > smooth) {
        const double all = (rate * rate - smooth * smooth) / (2.0 * r->a);
        const double some = nck_min(steps, nck_floor(all));
        const double end = nck_sqrt(rate * rate - 2.0 * r->a * some);
        time_s = (rate - end) / r->a - 0.5 * (1.0 / end - 1.0 / rate);
        rate = end;
        steps -= some;
    }
    while (steps >= 1.0 && rate > r->end) {
        time_s += 1.0 / rate;
        rate = nck_max(r->end, rate - r->a / rate);
        steps -= 1.0;
    }
    return time_s + steps / rate;
}

nck_control_times_t nck_control_step(const nck_host_control_line_t *line, const double ends[2]) {
    const rates_t r = rates_of(line, ends);
    const double per_mm = line->steps / line->length;
    nck_control_times_t t;
    double rate = r.begin;
    // The first interval counts for no ramp: one step of those that follow is over by then.
    double left = line->steps - 1.0;
    const double up = nck_min(left, r.up);
    t.up_s = 1.0 / r.begin + ramp_up(&r, up, &rate);
    left -= up;
    const double top = nck_min(left, r.top);
    if (top > 0.0) rate = r.most;
    t.top_s = top / r.most;
    left -= top;
    t.down_s = ramp_down(&r, left, rate);
    t.v_top = rate / per_mm;
    t.up_mm = nck_min(line->steps, up + 1.0) / per_mm;
    t.down_mm = left / per_mm;
    return t;
}
