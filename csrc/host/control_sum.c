// SPDX-License-Identifier: MIT
// Other controls: what a plan adds up to, and what its time goes to.
#include "host/control_parts.h"

#include <string.h> // memset

#include "host/control_math.h" // nck_control_top
#include "nck/base/real.h"     // nck_max nck_sqrt

// A speed is held below the line's own from this share of it on.
#define SLOWER 0.999999

static void add_time(nck_host_control_t *self, uint32_t limit, double time_s) {
    self->totals.limit_s[limit] += time_s;
}

void nck_control_low(nck_host_control_t *self, const nck_host_low_t *low) {
    if (self->is_begun) {
        nck_host_cause_add(self->causes, &self->low);
        if (self->trace.stretches) nck_control_trace_settle(self);
    }
    if (self->trace.stretches) nck_control_trace_low(self);
    self->low = *low;
    self->low.lost_s = self->fall.lost_s;
    add_time(self, low->limit, self->fall.time_s);
    self->is_begun = 1;
    memset(&self->fall, 0, sizeof self->fall);
}

// What a line loses to its own limits, or to Klipper's minimum cruise ratio.
static void lose_here(nck_host_control_t *self, const nck_host_control_line_t *line,
                      uint32_t limit, double lost_s) {
    nck_host_low_t low;
    if (lost_s <= 0.0) return;
    memset(&low, 0, sizeof low);
    low.limit = limit;
    low.seg = line->number;
    low.line = line->line;
    low.axis = limit >= NCK_LIMIT_AXIS_V ? limit - NCK_LIMIT_AXIS_V : NCK_AXIS_MAX;
    low.angle = limit == NCK_LIMIT_CORNER ? line->angle : 0.0;
    low.lost_s = lost_s;
    nck_host_cause_add(self->causes, &low);
}

// A ramp up belongs to the low point before it, a ramp down to the one behind it.
static void ramp_up(nck_host_control_t *self, double lost_s, double time_s) {
    if (self->fall.time_s > 0.0) {
        self->fall.lost_s += lost_s;
        self->fall.time_s += time_s;
        return;
    }
    self->low.lost_s += lost_s;
    add_time(self, self->low.limit, time_s);
}

static nck_control_times_t trapezoid(const nck_host_control_line_t *line, const double vv[2],
                                     double most) {
    nck_control_times_t t;
    const double a = line->a;
    const double vv_top = nck_control_top(line->length, a, vv, most);
    t.v_top = nck_sqrt(vv_top);
    t.up_s = (t.v_top - nck_sqrt(vv[0])) / a;
    t.down_s = (t.v_top - nck_sqrt(vv[1])) / a;
    t.up_mm = (vv_top - vv[0]) / (2.0 * a);
    t.down_mm = (vv_top - vv[1]) / (2.0 * a);
    t.top_s = nck_max(0.0, line->length - t.up_mm - t.down_mm) / t.v_top;
    return t;
}

static nck_control_times_t times_of(const nck_host_control_t *self,
                                    const nck_host_control_line_t *line, double vv_end) {
    const double ends[2] = {self->vv, vv_end};
    const int is_klipper = self->rule.kind == NCK_HOST_CONTROL_KLIPPER;
    if (self->rule.kind == NCK_HOST_CONTROL_MARLIN && line->steps > 0.0) {
        return nck_control_step(line, ends);
    }
    return trapezoid(line, ends, is_klipper ? line->cruise : line->v * line->v);
}

void nck_control_spend(nck_host_control_t *self, const nck_host_control_line_t *line,
                       double vv_end) {
    const nck_control_times_t t = times_of(self, line, vv_end);
    const double time_s = t.up_s + t.top_s + t.down_s;
    const double ideal_s = line->length / line->v_wanted;
    const double top_mm = nck_max(0.0, line->length - t.up_mm - t.down_mm);
    const uint32_t top = t.v_top < SLOWER * line->v ? (uint32_t)NCK_LIMIT_ACCEL : line->limit;
    nck_host_totals_t *const totals = &self->totals;
    ramp_up(self, t.up_s - t.up_mm / line->v, t.up_s);
    lose_here(self, line, line->limit, line->length / line->v - ideal_s);
    lose_here(self, line, NCK_LIMIT_ACCEL, t.top_s - top_mm / line->v);
    add_time(self, top, t.top_s);
    if (self->trace.stretches) {
        const double ends[2] = {self->vv, vv_end};
        nck_control_trace_line(self, line, &t, ends, top);
    }
    self->fall.lost_s += t.down_s - t.down_mm / line->v;
    self->fall.time_s += t.down_s;
    totals->accelerate_s += t.up_s;
    totals->cruise_s += t.top_s;
    totals->decelerate_s += t.down_s;
    *(line->rapid ? &totals->rapid_s : &totals->cut_s) += time_s;
    nck_host_cause_sum(line->rapid ? &self->rapid_s : &self->cut_s, ideal_s);
    nck_host_cause_sum(&self->time_s, time_s);
    nck_host_share_add(&self->shares, line->line,
                       line->rapid ? NCK_HOST_SHARE_RAPID : NCK_HOST_SHARE_CUT, time_s);
    totals->length_mm += line->length;
    totals->segs++;
    totals->nodes++;
    totals->cells += (uint64_t)((t.up_s > 0.0) + (t.top_s > 0.0) + (t.down_s > 0.0));
    self->vv = vv_end;
}

void nck_control_dwell(nck_host_control_t *self, uint32_t line, double dwell_s) {
    self->totals.dwell_s += dwell_s;
    add_time(self, NCK_LIMIT_DWELL, dwell_s);
    nck_host_cause_sum(&self->dwell_s, dwell_s);
    nck_host_cause_sum(&self->time_s, dwell_s);
    nck_host_share_add(&self->shares, line, NCK_HOST_SHARE_DWELL, dwell_s);
    if (self->trace.stretches) nck_control_trace_rest(self, line, dwell_s);
}
