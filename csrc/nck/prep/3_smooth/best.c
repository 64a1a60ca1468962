// SPDX-License-Identifier: MIT
// Inside room 3: the fastest curve of a window's rounds.
#include "nck/prep/3_smooth/best.h"

#include "nck/base/limits.h" // NCK_HAS_FASTEST
#include "nck/base/real.h"   // nck_min nck_num_min NCK_NUM_SQRT

#include <string.h> // memcpy

void nck_best_keep(nck_stream_t *self) {
    nck_stream_best_t *const best = &self->best;
    if (!NCK_HAS_FASTEST) return;
    best->knots = self->clock.knots;
    best->given = self->given;
    best->ends = self->clock.ends;
    memcpy(best->b, self->b, sizeof best->b);
    memcpy(best->s, self->clock.s, sizeof best->s);
    memcpy(best->point, self->point, sizeof best->point);
}

void nck_best_take(nck_stream_t *self) {
    nck_stream_best_t *const best = &self->best;
    self->clock.knots = best->knots;
    self->given = best->given;
    self->clock.ends = best->ends;
    memcpy(self->b, best->b, sizeof best->b);
    memcpy(self->clock.s, best->s, sizeof best->s);
    memcpy(self->point, best->point, sizeof best->point);
    best->knots = 0;
}

// How long a plan takes from the window's begin to s [knots].
static nck_num knots_to(const double *clock_s, const nck_num *b, double s) {
    nck_num sum = 0;
    for (const double *at = clock_s; *at < s; at += 4, b++) {
        const nck_num share = (nck_num)(s - at[0]) / (nck_num)(at[4] - at[0]);
        sum += nck_num_min(share, 1) / (NCK_NUM_SQRT(b[0]) + NCK_NUM_SQRT(b[1]));
    }
    return 2 * sum;
}

int nck_best_is_faster(const nck_stream_t *self) {
    const nck_stream_best_t *const best = &self->best;
    if (!NCK_HAS_FASTEST || best->knots == 0) return 0;
    const double s = nck_min(self->clock.s[4 * self->clock.knots], best->s[4 * best->knots]);
    return knots_to(self->clock.s, self->b, s) > knots_to(best->s, best->b, s);
}
