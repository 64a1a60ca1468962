// SPDX-License-Identifier: MIT
// From the program to the run: how far the path misses the programmed points. These are the corners
// of the program and points on its arcs; the path is that of the segs, in closed form.
//
//     blocks ─▶ moves ─▶ marks, in a ring ─┐
//     segs as they come, in a ring ────────┴─▶ distance of every mark from the segs about it
//
// Of the path only the part counts that stands for the program about such a point, half the way to
// the next one at most or as far as the tolerance: what comes by there later does not. Fixed
// memory: where a ring is too short for that part, what it holds of it counts, a quarter of the
// ring on either side at least.
#ifndef NCK_HOST_PATH_MISS_H
#define NCK_HOST_PATH_MISS_H

#include "host/course.h" // nck_host_course_t

#ifdef __cplusplus
extern "C" {
#endif

// A point of the program that the path is to come near to.
typedef struct nck_host_mark {
    double s;                   // path coordinate [path mm]
    double low, high;           // from where to where the path is to be near [path mm]
    double judged;              // how far the path must be known to judge it and all before it
    double tolerance;           // in force there [mm]; 0: none
    double point[NCK_AXIS_MAX]; // [mm, deg]
} nck_host_mark_t;

// All of it. Rows belong to the caller.
typedef struct nck_host_path_miss {
    nck_host_course_t course;
    nck_host_mark_t *marks; size_t mark_max; // ring, 1 at least
    nck_seg_t *segs; size_t seg_max;         // ring, 8 at least
    uint64_t mark_first, mark_end;           // numbers of the oldest, and behind the newest one
    uint64_t seg_first, seg_end;
    nck_host_move_t move;       // whose marks come next
    uint32_t step, steps;       // its marks: those that are made; all
    uint32_t has_held;          // 1: held is one
    uint32_t all_read;          // 1: no mark follows
    nck_host_mark_t held;       // what follows it is not known
    double before;              // path coordinate of the mark before it
    double judged;              // of the newest mark
    double tolerance_most;      // the largest one in the program [mm]
    double largest;             // distance so far [path mm]
    double missed;              // the same as a share of the tolerance; 0 where there is none
} nck_host_path_miss_t;

// Begin; the rings are set before: marks, mark_max, segs, seg_max. tolerance_most: the largest one
// in the program [mm]. Cost: constant. Context: any.
void nck_host_path_miss_init(nck_host_path_miss_t *self, const nck_machine_t *machine,
                             double tolerance_most);

// Take the next segs of the path; used_out: how many.
// Returns NCK_OK: all; NCK_EMPTY: give `course` its next piece, then go on with the rest.
// Cost: linear in the segs, and in those about a mark that may be the worst. Context: any.
nck_status_t nck_host_path_miss_add(nck_host_path_miss_t *self, const nck_seg_t *segs,
                                    size_t count, size_t *used_out);

// There are no more segs: measure what is left of the program, as far as the path goes.
// Returns NCK_OK; NCK_EMPTY: as above. Cost: as above. Context: any.
nck_status_t nck_host_path_miss_end(nck_host_path_miss_t *self);

#ifdef __cplusplus
}
#endif

#endif
