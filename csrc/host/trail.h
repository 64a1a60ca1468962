// SPDX-License-Identifier: MIT
// The path of a plan as points, for a picture: where, when, how fast, held by what. Positions and
// times are those of the cells, in closed form. Cells that a straight line of the same speed law
// stands for are one stretch; a low point always ends one, so it is never lost.
//
//     stretch of a cell ─▶ open stretch, as long as it goes on like this ─▶ point at its end
#ifndef NCK_HOST_TRAIL_H
#define NCK_HOST_TRAIL_H

#include <stddef.h> // size_t

#include "host/cause.h"       // nck_host_low_t nck_host_sum_t
#include "nck/base/machine.h" // nck_machine_t
#include "nck/base/records.h" // nck_seg_t nck_cell_t

#ifdef __cplusplus
extern "C" {
#endif

// Rows that must be free before a cell: the pieces that it may pass, and the points of their arcs.
enum { NCK_HOST_TRAIL_ROOM = 4096 };

// A place of the path, and the stretch that ends there.
typedef struct nck_host_point {
    double t;                   // from the start of the program on [s]
    double v;                   // speed there [path mm/s]
    double feed;                // programmed in the stretch [path mm/s]; of a rapid its cap
    double xyz[3];              // of the linear axes [mm]
    double abc[3];              // of the rotary axes [deg]
    uint32_t line;              // source line
    uint32_t tool;              // in the spindle
    uint8_t limit;              // of the stretch, as the ticks call it: nck_limit_t
    uint8_t rapid;              // 1: G0
    uint8_t rests;              // 1: nothing moves
    uint8_t reserved[5];
} nck_host_point_t;

// A low point and its ramps: all points from `first` on, up to the next one's.
typedef struct nck_host_foot {
    uint64_t first;             // number of the first point on the ramp down to it
    uint64_t at;                // number of the point where it is
    nck_host_low_t low;
} nck_host_foot_t;

// What goes on like this.
typedef struct nck_host_stride {
    const nck_seg_t *seg;
    const nck_cell_t *cell;
    double s;                   // where in the seg the cell begins; before the seg: < 0 [path mm]
    double from, to;            // of the cell's time [s]
    double feed;                // programmed [path mm/s]
    uint32_t tool;              // in the spindle
    uint32_t falls;             // 1: behind the fastest point since the last low point; 2: and
                                // behind the slowest one since then
    uint32_t line;              // source line
} nck_host_stride_t;

// All of it. Rows belong to the caller; NULL: nobody asks.
typedef struct nck_host_trail {
    nck_host_point_t *points; size_t point_max, point_count; // rows of this call
    nck_host_foot_t *feet; size_t foot_max, foot_count;      // rows of this call
    uint64_t before;            // points of the calls before
    uint64_t fastest;           // points up to the fastest one since the last low point
    uint64_t slowest;           // number of the slowest one behind it
    uint32_t broken;            // 1: a row had no room
    // the stretch in work
    uint32_t is_open;           // 1: open is one
    uint32_t seg, falls;        // of it
    nck_host_point_t open;
    double length;              // of it so far [path mm]
    double duration, v_begin, a_begin; // of it so far [s]; where it began [path mm/s, mm/s²]
    double a_like;              // accelerations within so much go on alike [path mm/s²]
    nck_host_sum_t t;           // so far [s]
    nck_host_foot_t foot;       // the last low point
} nck_host_trail_t;

// The speed of the path at a time of a cell within a seg [path mm/s]: along a clocked path, whose
// coordinate is the program's, that of the curve. Cost: constant. Context: any.
double nck_host_trail_speed(const nck_seg_t *seg, const nck_cell_t *cell, double t);

// Rows from their start again. Cost: constant. Context: any.
void nck_host_trail_again(nck_host_trail_t *self, const nck_machine_t *machine);

// 1 if a cell can be taken. Cost: constant. Context: any.
int nck_host_trail_has_room(const nck_host_trail_t *self);

// The next stretch that moves, of one seg; points are asked for. Cost: linear in the
// points of its arc. Context: any.
void nck_host_trail_move(nck_host_trail_t *self, const nck_host_stride_t *stretch);

// At rest for some time [s], where the path has come to; points are asked for. Cost: constant.
// Context: any.
void nck_host_trail_rest(nck_host_trail_t *self, const nck_host_stride_t *stretch, double time);

// All so far leads up from the last low point. Cost: constant. Context: any.
void nck_host_trail_fastest(nck_host_trail_t *self);

// Behind the fastest point nothing was slower than this place. Cost: constant. Context: any.
void nck_host_trail_slowest(nck_host_trail_t *self);

// The path is at a low point. Cost: constant. Context: any.
void nck_host_trail_low(nck_host_trail_t *self);

// The slowest place was a low point. Cost: constant. Context: any.
void nck_host_trail_was_low(nck_host_trail_t *self);

// What the last low point has lost is known. Cost: constant. Context: any.
void nck_host_trail_settle(nck_host_trail_t *self, const nck_host_low_t *low);

#ifdef __cplusplus
}
#endif

#endif
