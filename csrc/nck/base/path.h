// SPDX-License-Identifier: MIT
// Derivatives of a seg by the path coordinate s, for prep; its points are in path_math.h.
#ifndef NCK_BASE_PATH_H
#define NCK_BASE_PATH_H

#include "nck/base/path_math.h" // nck_path_point
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

// The share of a spline's own length that lies before s, by the trapezoid rule of four parts.
// speed_out: |dp/ds| there. 0 ≤ s ≤ L; L must be positive. Cost: six tangents. Context: any.
double nck_path_share(const nck_seg_t *seg, double s, double *speed_out);

#ifdef __cplusplus
}
#endif

#endif
