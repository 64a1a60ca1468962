// SPDX-License-Identifier: MIT
// Parts of host/control.h, for each other alone.
#ifndef NCK_HOST_CONTROL_PARTS_H
#define NCK_HOST_CONTROL_PARTS_H

#include "host/control.h" // nck_host_control_t

#ifdef __cplusplus
extern "C" {
#endif

// The lines of a move: arcs in chords, ends in whole steps. Cost: linear in them.
void nck_control_move(nck_host_control_t *self, const nck_block_t *block);

// A pass of a thread ends here: what follows goes on from its target. Cost: constant.
void nck_control_reach(nck_host_control_t *self, const nck_block_t *block);

// How many lines a block becomes at most. Cost: constant.
size_t nck_control_lines_of(const nck_host_control_t *self, const nck_block_t *block);

// Limits of a line along its direction: a, v, limit. Cost: constant.
void nck_control_limit(const nck_host_control_t *self, nck_host_control_line_t *line);

// The cap at the start of a line, behind the last one. Cost: constant.
void nck_control_corner(const nck_host_control_t *self, nck_host_control_line_t *line);

// LinuxCNC: the next move, as its naive CAM and its blends have it. word: what the program says of
// it; target: its end [mm]. Cost: the lines that the naive CAM has, and those planned together.
void nck_control_blend(nck_host_control_t *self, const nck_block_t *block,
                       const nck_host_control_line_t *word, const double target[NCK_AXIS_MAX]);

// LinuxCNC: nothing more comes before a rest. Cost: as above.
void nck_control_unblend(nck_host_control_t *self);

// A line joins those that are planned; what is final leaves. Cost: the lines planned together.
void nck_control_add(nck_host_control_t *self, const nck_host_control_line_t *line);

// All that waits is planned to a rest. limit: what it rests for; line: where. Cost: as above.
void nck_control_rest(nck_host_control_t *self, uint32_t limit, uint32_t line);

// A junction or a rest where the path is slow. Cost: constant.
void nck_control_low(nck_host_control_t *self, const nck_host_low_t *low);

// A line is final: it ends at vv_end, v². Cost: constant.
void nck_control_spend(nck_host_control_t *self, const nck_host_control_line_t *line,
                       double vv_end);

// How a line's time is made up.
typedef struct nck_control_times {
    double up_s, top_s, down_s; // [s]
    double up_mm, down_mm;      // [mm]
    double v_top;               // [mm/s]
} nck_control_times_t;

// The same line step by step, as Marlin's stepper makes it. ends: v² there. Cost: linear in those
// of its steps that are slow.
nck_control_times_t nck_control_step(const nck_host_control_line_t *line, const double ends[2]);

// Rows from their start again. Cost: constant.
void nck_control_trace_again(nck_host_control_t *self);

// A line of such times is final: it begins at v² = vv[0], ends at vv[1]; top holds its top speed.
// Stretches are asked for. Cost: linear in the chords of its bend.
void nck_control_trace_line(nck_host_control_t *self, const nck_host_control_line_t *line,
                            const nck_control_times_t *times, const double vv[2], uint32_t top);

// Time at rest; stretches are asked for. Cost: constant.
void nck_control_trace_rest(nck_host_control_t *self, uint32_t line, double time_s);

// What the last low point has lost is known; stretches are asked for. Cost: constant.
void nck_control_trace_settle(nck_host_control_t *self);

// There is another low point here; stretches are asked for. Cost: constant.
void nck_control_trace_low(nck_host_control_t *self);

// The way between two shares of a line's length, of X Y Z [mm]. Cost: constant.
void nck_control_bend_way(const nck_host_control_line_t *line, double from, double to,
                          double way_out[3]);

// A bend loses this share of its length at its start. Cost: constant.
void nck_control_bend_shorten(nck_host_control_line_t *line, double share);

// Time at rest. Cost: constant.
void nck_control_dwell(nck_host_control_t *self, uint32_t line, double dwell_s);

#ifdef __cplusplus
}
#endif

#endif
