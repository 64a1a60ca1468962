// SPDX-License-Identifier: MIT
// How far points are from a seg, by its geometry alone.
#ifndef NCK_HOST_SEG_DISTANCE_H
#define NCK_HOST_SEG_DISTANCE_H

#include "nck/base/records.h" // nck_seg_t

#ifdef __cplusplus
extern "C" {
#endif

// The point of a seg where a share f of it is done, 0 … 1 [mm, deg]; NCK_AXIS_MAX numbers.
// Cost: constant. Context: any.
void nck_host_seg_point(const nck_seg_t *seg, double f, double *point_out);

// How far a point [mm, deg] is from a seg [path mm], if that is less than `most`; else `most`, or
// more. Of a curve: searched on a grid of 32 parts, then from its best point on to either side by
// chords of a sixteenth of a part. Cost: constant. Context: any.
double nck_host_seg_distance(const nck_seg_t *seg, const double *point, double most);

#ifdef __cplusplus
}
#endif

#endif
