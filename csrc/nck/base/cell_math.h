// SPDX-License-Identifier: MIT
// A cell in parts.
#ifndef NCK_BASE_CELL_MATH_H
#define NCK_BASE_CELL_MATH_H

#include "nck/base/records.h" // nck_cell_t

// The path that a cell has left behind at a time from its begin [path mm]:
//        s = v·t + a·t²/2 + j·t³/6
static inline double nck_cell_way(const nck_cell_t *cell, double t) {
    return (cell->v + (0.5 * cell->a + cell->j / 6.0 * t) * t) * t;
}

// Its speed there [path mm/s]:
//        v = v0 + a·t + j·t²/2
static inline double nck_cell_speed(const nck_cell_t *cell, double t) {
    return cell->v + (cell->a + 0.5 * cell->j * t) * t;
}

// What of a cell lies between two times from its begin; only what ends with it has its end.
// The cell spans no seg but its own. Cost: constant.
static inline void nck_cell_part(const nck_cell_t *cell, double t0, double t1,
                                 nck_cell_t *part_out) {
    const int is_last = !(t1 < cell->duration);
    const double s0 = nck_cell_way(cell, t0);
    const double s1 = is_last ? cell->length : nck_cell_way(cell, t1);
    *part_out = *cell;
    part_out->s = cell->s + s0;
    part_out->length = s1 - s0;
    part_out->v = nck_cell_speed(cell, t0);
    part_out->a = cell->a + cell->j * t0;
    part_out->duration = t1 - t0;
    if (is_last) return;
    part_out->last = 0;
    part_out->stop = 0;
}

#endif
