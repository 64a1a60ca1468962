// SPDX-License-Identifier: MIT
// Room 5, slope: legs of constant jerk as cells.
#include "nck/prep/5_slope/legs.h"

#include "nck/base/real.h" // nck_min nck_floor

// Cells are divided so that none lasts longer: a hold begins behind those that are final.
#define SLICE_PERIODS 1.5
// Of a leg, at most: after days its slices are longer.
#define SLICES_MOST 1e9
// Slices last a whole number of such parts of a second, so that their sum is the leg to the bit but
// for the carry of an exponent.
#define GRAINS 16777216.0

static void begin_leg(nck_legs_t *self, double period) {
    const nck_cell_t *const leg = &self->cell[self->k];
    const double most = SLICE_PERIODS * period;
    const int moves = leg->length > 0.0 && leg->duration > most;
    self->slices = moves ? 1 + (uint32_t)nck_min(SLICES_MOST, leg->duration / most) : 1;
    self->m = 0;
}

void nck_legs_begin(nck_legs_t *self, double period) {
    self->k = 0;
    begin_leg(self, period);
}

// The leg between its slices m0 and m1.
static nck_cell_t between(const nck_legs_t *self, uint32_t m0, uint32_t m1) {
    const nck_cell_t *const leg = &self->cell[self->k];
    nck_cell_t cell = *leg;
    if (self->slices == 1) return cell;
    const double q = nck_floor(GRAINS * leg->duration / (double)self->slices) / GRAINS;
    const int is_last = m1 == self->slices;
    const double t0 = q * (double)m0;
    const double t1 = is_last ? leg->duration : q * (double)m1;
    const double s0 = (leg->v + (0.5 * leg->a + leg->j / 6.0 * t0) * t0) * t0;
    const double s1 = (leg->v + (0.5 * leg->a + leg->j / 6.0 * t1) * t1) * t1;
    cell.s = leg->s + s0;
    cell.length = (is_last ? leg->length : s1) - s0;
    cell.v = leg->v + (leg->a + 0.5 * leg->j * t0) * t0;
    cell.a = leg->a + leg->j * t0;
    cell.duration = t1 - t0;
    if (is_last) return cell;
    cell.last = 0;
    cell.stop = 0;
    return cell;
}

int nck_legs_next(nck_legs_t *self, double period, nck_cell_t *cell_out) {
    *cell_out = between(self, self->m, self->m + 1);
    self->m++;
    if (self->m < self->slices) return 0;
    self->k++;
    if (self->k < self->count) {
        begin_leg(self, period);
        return 0;
    }
    self->count = 0;
    return 1;
}

void nck_legs_rest(const nck_legs_t *self, nck_cell_t *cell_out) {
    *cell_out = between(self, self->m, self->slices);
}
