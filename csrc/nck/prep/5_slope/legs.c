// SPDX-License-Identifier: MIT
// Room 5, slope: legs of constant acceleration as cells.
#include "nck/prep/5_slope/legs.h"

#include "nck/base/cell_math.h" // nck_cell_part
#include "nck/base/real.h"      // nck_min nck_floor

// Of a leg, at most: after days its slices are longer.
#define SLICES_MOST 1e9
// Slices last a whole number of such parts of a second, so that their sum is the leg to the bit but
// for the carry of an exponent.
#define GRAINS 16777216.0

void nck_legs_divide(nck_legs_t *self, double most) {
    const nck_cell_t *const leg = &self->cell[self->k];
    self->slices = 1 + (uint32_t)nck_min(SLICES_MOST, leg->duration / most);
    if (self->slices == 1) return;
    self->slice_s = nck_floor(GRAINS * leg->duration / (double)self->slices) / GRAINS;
}

// The next one of the leg in work, which has several.
static void slice(const nck_legs_t *self, nck_cell_t *cell_out) {
    const nck_cell_t *const leg = &self->cell[self->k];
    const int is_last = self->m + 1 == self->slices;
    const double t0 = self->slice_s * (double)self->m;
    const double t1 = is_last ? leg->duration : self->slice_s * (double)(self->m + 1);
    nck_cell_part(leg, t0, t1, cell_out);
}

int nck_legs_part(nck_legs_t *self, double period, nck_cell_t *cell_out) {
    if (self->slices > 1) slice(self, cell_out);
    else *cell_out = self->cell[self->k];
    self->m++;
    if (self->m < self->slices) return 0;
    self->k++;
    if (self->k < self->count) {
        nck_legs_begin_leg(self, period);
        return 0;
    }
    self->count = 0;
    return 1;
}
