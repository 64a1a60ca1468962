// SPDX-License-Identifier: MIT
// The velocity profile of a whole path with N look-ahead segments, as Cao et al. 2014, section 8,
// plan it: linear or S-shaped acceleration, for the papers' experiments. Caller owns every array.
#ifndef NCK_HOST_SSHAPE_H
#define NCK_HOST_SSHAPE_H

#include <stddef.h> // size_t
#include <stdint.h> // uint32_t

#include "nck/base/records.h" // nck_cell_t
#include "nck/base/status.h"  // nck_status_t
#include "host/sshape_piece.h" // NCK_SSHAPE_CELLS

#ifdef __cplusplus
extern "C" {
#endif

// How speed changes.
typedef enum nck_host_ramp {
    NCK_HOST_RAMP_LINEAR = 0, // acceleration −a, 0 or a
    NCK_HOST_RAMP_SSHAPE = 1, // jerk within j, acceleration zero at the ends of every segment
    NCK_HOST_RAMP_WHOLE = 2,  // one symmetric S over the whole segment, peak a at most
    NCK_HOST_RAMP_FIXED = 3   // every ramp lasts ramp_s, whatever its size; look-ahead 0 only
} nck_host_ramp_t;

enum { NCK_HOST_SLOPE_CELLS = NCK_SSHAPE_CELLS }; // cells of a segment at most

// A path of segments, as the caller steps its limits.
typedef struct nck_host_path {
    const double *length; // n: of every segment [mm], positive
    const double *v_cap;  // n: cap inside of every segment [mm/s], positive
    const double *a_max;  // n: tangential acceleration [mm/s²], positive
    const double *j_max;  // n: jerk [mm/s³], positive; for NCK_HOST_RAMP_SSHAPE, else unread
    const double *v_node; // n + 1: cap at every junction, both ends included [mm/s], ≥ 0
    size_t n;             // segments, at least 1
    size_t lookahead;     // blocks seen behind the one in work; rest is assumed beyond
    uint32_t kind;        // nck_host_ramp_t
    double ramp_s;        // NCK_HOST_RAMP_FIXED: duration of every ramp [s], positive; else ignored
    const uint32_t *block; // n: number of every segment's block, up by 0 or 1; NULL: each is one
} nck_host_path_t;

// The speeds of a path, v_out: n + 1 at the junctions [mm/s]. Linear in n when lookahead ≥ n (one
// backward pass sees all), else n·(segments seen).
// Returns NCK_OK, or NCK_E_ARGUMENT and in *bad_out the index of the first segment (n: the last
// junction, or the settings) whose number is NaN, infinite or outside of its range. Context: any.
nck_status_t nck_host_slope_speeds(const nck_host_path_t *path, double *v_out, size_t *bad_out);

// The cells of segments begin … end − 1 of a path with these speeds v. cells_out: room for
// NCK_HOST_SLOPE_CELLS for each, *cell_count_out of them are filled; cell.seg is the segment's
// index. Cost: linear in them. Context: any.
void nck_host_slope_cells(const nck_host_path_t *path, const double *v, size_t begin, size_t end,
                          nck_cell_t *cells_out, size_t *cell_count_out);

// Both: all of a path's speeds and cells. Returns as nck_host_slope_speeds. Context: any.
nck_status_t nck_host_slope(const nck_host_path_t *path, double *v_out, nck_cell_t *cells_out,
                            size_t *cell_count_out, size_t *bad_out);

// Samples of a profile at t = k·period_s, k = 0 … count − 1.
typedef struct nck_host_samples {
    double period_s; // between two samples [s]
    size_t count;
    double *s;       // count: path coordinate [mm]; filled
    double *v;       // count: speed [mm/s]; filled
    double *a;       // count: acceleration [mm/s²], the later value where it steps; filled
} nck_host_samples_t;

// Where a profile of `count` cells stands at the times of the samples; behind the end it stands at
// the end. Linear in cells and samples. Context: any.
void nck_host_slope_sample(const nck_cell_t *cells, size_t count,
                           const nck_host_samples_t *samples);

#ifdef __cplusplus
}
#endif

#endif
