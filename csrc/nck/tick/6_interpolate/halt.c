// SPDX-License-Identifier: MIT
// Inside room 6: a stop that an input asks for.
#include "nck/tick/6_interpolate/halt.h"

#include "nck/base/fence.h" // nck_fence_store
#include "nck/base/real.h"  // nck_fabs nck_max nck_sqrt

void nck_halt_plan(nck_halt_t *self, const nck_terms_t *terms, const nck_pose_t *pose) {
    const nck_machine_t *const machine = terms->machine;
    double first = 0.0, second = 0.0; // the most that V has of an axis' acceleration, and jerk
    for (int x = 0; x < NCK_AXIS_MAX; x++) {
        self->way[x] = (pose->axis[x] - self->at[x]) / machine->period_s;
        if (!machine->axis[x].present) continue;
        const double v = nck_fabs(self->way[x]);
        first = nck_max(first, v / machine->axis[x].a_max);
        second = nck_max(second, v / machine->axis[x].j_max);
    }
    self->duration = 1.5 * first / self->quick;
    if (terms->limits_jerk) {
        self->duration = nck_max(self->duration, nck_sqrt(6.0 * second / self->quick));
    }
    for (int x = 0; x < NCK_AXIS_MAX; x++) self->way[x] *= self->duration;
    self->speed = pose->v;
}

int nck_halt_tick(nck_halt_t *self, double period, nck_pose_t *pose) {
    const double t = (double)(self->periods + 1) * period;
    const int rests = t >= self->duration;
    const double share = rests ? 1.0 : t / self->duration;
    const double square = share * share;
    const double gone = share - square * share * (1.0 - 0.5 * share);
    for (int x = 0; x < NCK_AXIS_MAX; x++) {
        pose->axis[x] = self->at[x] + self->way[x] * gone;
    }
    pose->v = self->speed * (1.0 - square * (3.0 - 2.0 * share));
    if (rests) pose->v = 0.0;
    pose->state = NCK_TICK_HOLD;
    pose->spindle_rpm = pose->kind == NCK_SEG_TAP ? 0.0 : pose->spindle_rpm;
    if (!rests || self->periods == 0) nck_fence_store(&self->periods, self->periods + 1);
    return rests;
}
