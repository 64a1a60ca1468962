// SPDX-License-Identifier: MIT
// Derivatives of a seg by the path coordinate s, for prep; its points are in path_math.h.
#ifndef NCK_BASE_PATH_H
#define NCK_BASE_PATH_H

#include "nck/base/path_math.h" // nck_path_point
#include "nck/base/real.h"      // nck_num
#include "nck/base/records.h"   // nck_seg_t

#ifdef __cplusplus
extern "C" {
#endif

// dp/ds at s: the unit tangent in the path metric (of a spline: about as long).
// 0 ≤ s ≤ L; L must be positive. Cost: constant. Context: any.
void nck_path_tangent(const nck_seg_t *seg, double s, double *tangent_out);

// d²p/ds² at s [1/mm]: 0 on a line. Requirements, cost and context as above.
void nck_path_second(const nck_seg_t *seg, double s, double *second_out);

// d³p/ds³ at s [1/mm²]: 0 on a line. Requirements, cost and context as above.
void nck_path_third(const nck_seg_t *seg, double s, double *third_out);

// The same: so many components, from X on; an arc turns in two of them.
void nck_path_tangent_part(const nck_seg_t *seg, double s, int axes, double *tangent_out);
void nck_path_second_part(const nck_seg_t *seg, double s, int axes, double *second_out);
void nck_path_third_part(const nck_seg_t *seg, double s, int axes, double *third_out);

// Differences of a spline's points along an axis: short, so a number of the solvers' type holds
// them. Cost: constant. Context: any.
static inline void nck_path_ways(const nck_seg_t *seg, int x, nck_num *way_out) {
    way_out[0] = (nck_num)(seg->shape.inner[0][x] - seg->start[x]);
    way_out[1] = (nck_num)(seg->shape.inner[1][x] - seg->shape.inner[0][x]);
    way_out[2] = (nck_num)(seg->end[x] - seg->shape.inner[1][x]);
}

// L/3 · dp/ds by them at f = s/L. Cost: constant. Context: any.
static inline nck_num nck_path_way_at(const nck_num *way, nck_num f) {
    const nck_num d01 = way[0] + (way[1] - way[0]) * f;
    const nck_num d12 = way[1] + (way[2] - way[1]) * f;
    return d01 + (d12 - d01) * f;
}

// The share of a spline's own length that lies before s, by the trapezoid rule of four parts.
// speed_out: |dp/ds| there. 0 ≤ s ≤ L; L must be positive. Cost: six tangents. Context: any.
double nck_path_share(const nck_seg_t *seg, double s, double *speed_out);

#ifdef __cplusplus
}
#endif

#endif
