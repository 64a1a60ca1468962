// SPDX-License-Identifier: MIT
// From the run to the program: how far the setpoints are from the programmed moves.
//
//     blocks ─▶ moves about the place of the run, in a ring ─▶ distance of every setpoint
//
// Moves are looked at from the setpoint's own one outwards, as far along the path as the nearest
// point may be. Fixed memory: moves that are further away than half of the ring do not count.
#ifndef NCK_HOST_PATH_ERROR_H
#define NCK_HOST_PATH_ERROR_H

#include "host/course.h" // nck_host_course_t

#ifdef __cplusplus
extern "C" {
#endif

// All of it. Rows belong to the caller.
typedef struct nck_host_path_error {
    nck_host_course_t course;
    nck_host_move_t *moves; size_t move_max; // ring, 2 at least
    uint64_t first, end;        // numbers of the oldest move, and behind the newest one
    uint64_t at;                // of the move where the run is
    uint32_t all_read;          // 1: no move follows
    uint32_t reserved;
    double largest;             // so far [path mm]
} nck_host_path_error_t;

// Begin; the ring is set before: moves, move_max. Cost: constant. Context: any.
void nck_host_path_error_init(nck_host_path_error_t *self, const nck_machine_t *machine);

// Measure the next setpoints of a run; used_out: how many of them. What is before the first line,
// or led by the spindle (a thread, a tap), does not count.
// Returns NCK_OK: all; NCK_EMPTY: give `course` its next piece, then go on with the rest.
// Cost: linear in the setpoints, and in the moves that are as near as the program is far.
// Context: any.
nck_status_t nck_host_path_error_add(nck_host_path_error_t *self, const nck_pose_t *poses,
                                     size_t count, size_t *used_out);

#ifdef __cplusplus
}
#endif

#endif
