// SPDX-License-Identifier: MIT
// Room 6, interpolate: what others tell it and ask, how periods are counted, and its invariants.
#include "nck/tick/6_interpolate/interpolate.h"

#include <stddef.h> // NULL

#include "nck/base/cell_math.h" // nck_cell_speed
#include "nck/base/fence.h"     // nck_fence_load nck_fence_store
#include "nck/base/real.h"      // nck_floor nck_real_of

int nck_interpolate_stands(const nck_interpolate_t *self) {
    return nck_fence_load(&self->stands) != 0;
}

void nck_interpolate_keep(nck_interpolate_t *self, uint32_t on) {
    nck_fence_store(&self->kept, on);
}

uint32_t nck_interpolate_clock(const nck_interpolate_t *self) {
    if (!nck_fence_load(&self->has_cell)) return NCK_CLOCK_RUNS;
    return nck_fence_load(&self->clock.state);
}

int nck_interpolate_is_waiting(const nck_interpolate_t *self) {
    if (!nck_fence_load(&self->waits)) return 0;
    return !nck_fence_load(&self->resume) || nck_fence_load(&self->awaits);
}

int nck_interpolate_is_at_rest(const nck_interpolate_t *self) {
    if (nck_fence_load(&self->waits)) return 1;
    return nck_link_is_spent(self->link) && !nck_fence_load(&self->has_cell);
}

// Of the motion in work, or of the next one where the path rests: NULL, none is known.
static const nck_seg_t *seg_in_work(nck_interpolate_t *self) {
    if (self->has_cell && self->cell.length > 0.0) return nck_link_seg(self->link, self->cell.seg);
    const uint32_t word = nck_link_word(self->link);
    const nck_cell_t *const next = nck_link_ahead(self->link, word, 0);
    if (!next) return NULL;
    const uint32_t seg = next->seg;
    if (!nck_link_holds(self->link, word)) return NULL;
    return nck_link_seg(self->link, seg);
}

int nck_interpolate_is_rapid(nck_interpolate_t *self) {
    if (self->has_cell && self->cell.length > 0.0) return self->pose.rapid;
    const nck_seg_t *const seg = seg_in_work(self);
    return seg ? seg->rapid : self->pose.rapid;
}

void nck_interpolate_measure(nck_interpolate_t *self, double turns) {
    nck_sync_measure(&self->sync, turns);
}

void nck_interpolate_stop_thread(nck_interpolate_t *self) {
    nck_fence_store(&self->sync.asked, 1);
}

void nck_interpolate_hold_thread(nck_interpolate_t *self, uint32_t on) {
    nck_fence_store(&self->sync.held, on);
}

void nck_interpolate_stop(nck_interpolate_t *self, nck_halt_t *halt) {
    if (self->halt) return;
    halt->periods = 0;
    self->halt = halt;
}

void nck_interpolate_resume(nck_interpolate_t *self) { nck_fence_store(&self->resume, 1); }

void nck_interpolate_await(nck_interpolate_t *self, uint32_t on) {
    nck_fence_store(&self->awaits, on);
    if (!on) nck_interpolate_resume(self);
}

// Up to 2⁵² periods the quotient is never too large by one, however it is rounded.
uint64_t nck_interpolate_periods(double t, double period) {
    uint64_t k = (uint64_t)(t / period);
    while ((double)k * period < t) k++;
    return k > 0 ? k : 1;
}

uint64_t nck_interpolate_rebase(double *t, double period) {
    const double span = (double)NCK_INTERPOLATE_SPAN * period;
    if (*t < span) return 0;
    const double spans = nck_floor(*t / span);
    *t -= spans * span;
    return (uint64_t)spans * NCK_INTERPOLATE_SPAN;
}

// A filter of one tap is not looked at, and keeps its place.
static int is_filter(const nck_filter_t *filter) {
    return filter->taps >= 1 && filter->taps <= NCK_FILTER_TAPS && filter->settle <= filter->taps
           && (filter->at < filter->taps || filter->taps == 1);
}

int nck_interpolate_invariants(const nck_interpolate_t *self) {
    const nck_pose_t *const pose = &self->pose;
    double sum = pose->s + pose->feed;
    for (int x = 0; x < NCK_AXIS_MAX; x++) sum += pose->axis[x];
    return sum - sum == 0.0 && pose->v >= 0.0 && pose->state <= NCK_TICK_HOLD
           && is_filter(&self->filter) && self->t_cell >= 0.0
           && self->t_cell < (double)NCK_INTERPOLATE_SPAN * self->machine->period_s
           && (!self->has_cell || self->cell.duration >= 0.0);
}

// The speed that the cells have and what they gain in a period, which the filter shows later.
static void see_ahead(const nck_interpolate_t *self, nck_watched_t *seen) {
    const nck_cell_t *const cell = &self->cell;
    const double now = nck_real_of((int64_t)self->k) * self->machine->period_s - self->clock.late;
    seen->ahead_v = self->pose.v;
    seen->ahead_gain = self->pose.v - self->watch.v;
    if (self->clock.state != NCK_CLOCK_RUNS || !self->has_cell) return;
    seen->ahead_v = nck_cell_speed(cell, now - self->t_cell);
    seen->ahead_gain = (cell->a + cell->j * (now - self->t_cell)) * self->machine->period_s;
}

// Along a clocked path no plan brings a rest that is asked for.
static int is_clocked(nck_interpolate_t *self) {
    const nck_seg_t *const seg = seg_in_work(self);
    return seg && nck_look_is_clocked(seg);
}

void nck_interpolate_watch(nck_interpolate_t *self, int asks, int planned, uint32_t steps) {
    const int stands = self->clock.state == NCK_CLOCK_STANDS; // a rest that is asked for is here
    const int at_once = asks && (stands || (NCK_HAS_OPTIMAL && is_clocked(self)));
    nck_watched_t seen = {asks, planned, at_once, steps, (int)self->from_tail, self->pose.v, 0.0,
                          0.0};
    if (asks) see_ahead(self, &seen);
    self->brakes = (uint32_t)nck_watch_tick(&self->watch, self->terms, &seen);
}
