// SPDX-License-Identifier: MIT
// Inside room 5: legs of constant acceleration come as cells that are short enough to be left soon.
#ifndef NCK_PREP_LEGS_H
#define NCK_PREP_LEGS_H

#include "nck/base/records.h" // nck_cell_t

enum { NCK_LEGS = 3 }; // of a stretch at most

// Cells are divided so that none lasts longer: a hold begins behind those that are final.
#define NCK_SLICE_PERIODS 1.5

// A stretch of path. Set cell and count, then begin.
typedef struct nck_legs {
    uint32_t count;  // legs of the stretch in work; 0: none in work
    uint32_t k;      // the leg in work
    uint32_t slices; // that it is divided into
    uint32_t m;      // of them, drawn
    double slice_s;  // how long one lasts; the last of them lasts till the leg's end [s]
    nck_cell_t cell[NCK_LEGS];
} nck_legs_t;

// Divide the leg in work into slices that last so long at most [s]. Cost: constant.
void nck_legs_divide(nck_legs_t *self, double most);

// Begin with the leg k. Cost: constant.
static inline void nck_legs_begin_leg(nck_legs_t *self, double period) {
    const nck_cell_t *const leg = &self->cell[self->k];
    const double most = NCK_SLICE_PERIODS * period;
    self->slices = 1;
    self->m = 0;
    if (leg->length > 0.0 && leg->duration > most) nck_legs_divide(self, most);
}

// Begin with the first leg. Cost: constant.
static inline void nck_legs_begin(nck_legs_t *self, double period) {
    self->k = 0;
    nck_legs_begin_leg(self, period);
}

// The next cell of a stretch that has more than one.
int nck_legs_part(nck_legs_t *self, double period, nck_cell_t *cell_out);

// The next cell of the stretch. Returns 1 if it is the last one: none is in work any more.
// Cost: constant.
static inline int nck_legs_next(nck_legs_t *self, double period, nck_cell_t *cell_out) {
    if (self->count > 1 || self->slices > 1) return nck_legs_part(self, period, cell_out);
    *cell_out = self->cell[0];
    self->count = 0;
    return 1;
}

#endif
