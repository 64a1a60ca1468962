// SPDX-License-Identifier: MIT
// Room 6, interpolate: what others tell it and ask, how periods are counted, and its invariants.
#include "nck/tick/6_interpolate/interpolate.h"

#include "nck/base/fence.h" // nck_fence_load nck_fence_store
#include "nck/base/real.h"  // nck_floor

int nck_interpolate_stands(const nck_interpolate_t *self) {
    return nck_fence_load(&self->stands) != 0;
}

int nck_interpolate_is_waiting(const nck_interpolate_t *self) {
    return nck_fence_load(&self->waits) && !nck_fence_load(&self->resume);
}

int nck_interpolate_is_at_rest(const nck_interpolate_t *self) {
    if (nck_fence_load(&self->waits)) return 1;
    return nck_link_is_spent(self->link) && !nck_fence_load(&self->has_cell);
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

int nck_interpolate_invariants(const nck_interpolate_t *self) {
    const nck_filter_t *const filter = &self->filter;
    const nck_pose_t *const pose = &self->pose;
    double sum = pose->s + pose->left + pose->feed;
    for (int x = 0; x < NCK_AXIS_MAX; x++) sum += pose->axis[x];
    return sum - sum == 0.0 && pose->v >= 0.0 && pose->state <= NCK_TICK_HOLD
           && filter->taps >= 1 && filter->taps <= NCK_FILTER_TAPS && filter->at < filter->taps
           && filter->settle <= filter->taps && self->t_cell >= 0.0
           && self->t_cell < (double)NCK_INTERPOLATE_SPAN * self->machine->period_s
           && (!self->has_cell || self->cell.duration >= 0.0);
}
