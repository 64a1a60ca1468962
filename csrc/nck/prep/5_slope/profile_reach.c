// SPDX-License-Identifier: MIT
// The first passes of a profile: how fast by acceleration alone, and its ramps.
#include "nck/prep/5_slope/profile_reach.h"

#include <stddef.h> // size_t

#include "nck/base/real.h"              // nck_min nck_sqrt
#include "nck/prep/5_slope/hull_math.h" // nck_hull_share

uint32_t nck_profile_reach_back(nck_profile_t *self, uint32_t budget) {
    const uint32_t count = nck_profile_left_back(self, budget);
    const double *const vv_cap = self->vv_cap;
    const double *const a_max = self->a_max;
    const double *const h = self->h;
    double *const vv = self->vv;
    uint32_t i = self->i;
    const int begins = i == self->n;
    double reach = begins ? vv_cap[i] : vv[i + 1];
    if (begins) vv[i--] = reach;
    for (uint32_t n = begins ? 1 : 0; n < count; n++, i--) {
        reach = nck_min(vv_cap[i], reach + 2.0 * a_max[i] * h[i]);
        vv[i] = reach;
    }
    self->i = i;
    return count;
}

static void reach_first(nck_profile_t *self) {
    self->vv[0] = nck_min(self->vv[0], self->v * self->v);
    self->e[0] = self->vv[0];
    self->s[0] = 0.0;
    self->v_last = nck_sqrt(self->vv[0]);
    self->last = UINT32_MAX;
    self->first = self->n + 1;
    self->j[self->n] = 0.0;
}

// The limit of a cell, approached from a bound in the one beside it as fast as the jerk lets it.
// behind: the one of both that lies behind the other.
static inline double approach(const nck_profile_t *self, size_t behind, double bound, double a) {
    const double shares = self->z[behind - 1] + self->z[behind];
    return nck_min(a, bound + self->j[behind] * shares);
}

uint32_t nck_profile_reach_forth(nck_profile_t *self, uint32_t budget) {
    const uint32_t count = nck_profile_left_forth(self, budget);
    const double *const a_max = self->a_max;
    const double *const j_max = self->j_max;
    const double *const h = self->h;
    double *const vv = self->vv;
    const double most = 0.5 * self->q_cap;
    const size_t end = self->i + count;
    if (self->i == 0) reach_first(self);
    const size_t begin = self->i > 0 ? self->i : 1;
    double bound = begin > 1 ? self->down[begin - 2] : a_max[0];
    double reach = vv[begin - 1];
    double s = self->s[begin - 1];
    double v_last = self->v_last;
    double j_last = begin > 1 ? j_max[begin - 2] : 0.0;
    for (size_t i = begin; i < end; i++) {
        const size_t cell = i - 1;
        const double a = a_max[cell];
        self->j[cell] = nck_min(j_last, j_max[cell]);
        j_last = j_max[cell];
        reach = nck_min(vv[i], reach + 2.0 * a * h[cell]);
        s += h[cell];
        const double v = nck_sqrt(reach);
        vv[i] = reach;
        self->e[i] = reach;
        self->s[i] = s;
        self->z[cell] = nck_hull_share(h[cell], v_last + v, most);
        v_last = v;
        if (a != bound) {
            self->last = (uint32_t)cell;
            bound = a > bound ? approach(self, cell, bound, a) : a;
        }
        self->down[cell] = bound;
        self->up[cell] = a;
    }
    self->v_last = v_last;
    self->i = (uint32_t)end;
    return count;
}

uint32_t nck_profile_ramp_back(nck_profile_t *self, uint32_t budget) {
    const uint32_t count = nck_profile_left_back(self, budget);
    const double *const a_max = self->a_max;
    const double *const h = self->h;
    const double *const down = self->down;
    double *const e = self->e;
    size_t i = self->i;
    double bound = i + 1 < self->n ? self->up[i + 1] : a_max[self->n - 1];
    for (uint32_t n = 0; n < count; n++, i--) {
        const double a = a_max[i];
        if (a > bound) {
            bound = approach(self, i + 1, bound, a);
            self->up[i] = bound;
            self->first = (uint32_t)i + 1;
        } else {
            bound = a;
        }
        const double reach = e[i + 1] + 2.0 * down[i] * h[i];
        if (reach < e[i]) {
            e[i] = reach;
            self->first = (uint32_t)i;
        }
    }
    self->i = (uint32_t)i;
    return count;
}

uint32_t nck_profile_ramp_forth(nck_profile_t *self, uint32_t budget) {
    const uint32_t count = nck_profile_left_forth(self, budget);
    const double *const e = self->e;
    const double *const up = self->up;
    const double *const h = self->h;
    double *const vv = self->vv;
    const uint32_t end = self->i + count;
    if (self->i == 0) vv[0] = e[0];
    for (uint32_t i = self->i > 0 ? self->i : 1; i < end; i++) {
        vv[i] = nck_min(e[i], vv[i - 1] + 2.0 * up[i - 1] * h[i - 1]);
    }
    self->i = end;
    return count;
}
