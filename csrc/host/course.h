// SPDX-License-Identifier: MIT
// Where the moves of a program run: lines, arcs and helices, from its blocks alone. Nothing of the
// planner's is used, so that the planner can be judged by it. Coordinates are the machine's, with
// the tool offset in them: where the axes are.
#ifndef NCK_HOST_COURSE_H
#define NCK_HOST_COURSE_H

#include <stddef.h> // size_t

#include "nck/base/machine.h" // nck_machine_t
#include "nck/base/records.h" // nck_block_t
#include "nck/base/status.h"  // nck_status_t

#ifdef __cplusplus
extern "C" {
#endif

// A block as a move. Of a block that moves nothing both ends are where the axes rest.
typedef struct nck_host_move {
    double start[NCK_AXIS_MAX]; // [mm, deg]
    double end[NCK_AXIS_MAX];   // [mm, deg]
    double begin_s, end_s;      // path coordinates [path mm]; a thread's pass has no length
    double tolerance;           // in force [mm]; 0: the exact path
    double centre[2];           // of an arc, along the axes of its plane [mm]
    double sweep;               // signed angle [rad]
    double angle;               // of its start about the centre [rad]
    double radius;              // at its start [mm]
    uint32_t is_arc;            // 1: arc or helix
    uint8_t axis_u, axis_v;     // of its plane
    uint8_t reserved[2];
} nck_host_move_t;

// A walk along the blocks of a program, which come in pieces.
typedef struct nck_host_course {
    const nck_block_t *blocks;  // piece in work, of the caller; NULL: none
    size_t count, used;         // its blocks; those that are walked along
    uint32_t ended;             // 1: no piece follows
    uint32_t reserved;
    int64_t position_nm[NCK_AXIS_MAX]; // where the last move ends [nm, ndeg]
    double counts[NCK_AXIS_MAX];// of fixed point in a unit of each axis
    double s;                   // path coordinate there [path mm]
} nck_host_course_t;

// Begin at the machine's start. Cost: constant. Context: any.
void nck_host_course_init(nck_host_course_t *self, const nck_machine_t *machine);

// Hand over the next piece of blocks, which must stay until it is used up; count 0: there is none.
// Cost: constant. Context: any.
void nck_host_course_give(nck_host_course_t *self, const nck_block_t *blocks, size_t count);

// Take the next move. Returns NCK_OK; NCK_EMPTY: give the next piece first; NCK_DONE: the program
// has ended. Cost: constant. Context: any.
nck_status_t nck_host_course_next(nck_host_course_t *self, nck_host_move_t *move_out);

// The point of a move where a share q of it is done, 0 … 1 [mm, deg]; NCK_AXIS_MAX numbers.
// Cost: constant. Context: any.
void nck_host_course_point(const nck_host_move_t *move, double q, double *point_out);

// How far a point [mm, deg] is from a move [path mm].
// Cost: constant. Context: any.
double nck_host_course_distance(const nck_host_move_t *move, const double *point);

// How far two points are apart [path mm]. Cost: constant. Context: any.
double nck_host_course_apart(const double *a, const double *b);

#ifdef __cplusplus
}
#endif

#endif
