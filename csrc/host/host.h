// SPDX-License-Identifier: MIT
// libnck_host: the kernel in bulk, arrays in and arrays out, for Python and for planning whole
// programs. Never in firmware. No heap here either: the caller owns every array.
#ifndef NCK_HOST_H
#define NCK_HOST_H

#include <stddef.h> // size_t

#include "host/cut.h" // nck_host_cut_t
#include "host/early.h" // nck_host_batch_t
#include "host/spindle.h" // nck_host_spindle_t
#include "host/why.h" // nck_host_why_t
#include "nck/nck_tools.h"  // nck_t and all records

#ifdef __cplusplus
extern "C" {
#endif

// A decoding under way: input cursor, and where rows go (each array holds at least 1).
typedef struct nck_host_decoding {
    const char *text;           // whole, to the program's end
    size_t text_size, text_used;
    uint32_t is_blocks;         // 1: the text is rows of nck_block_in_t
    nck_block_t *blocks; size_t block_max, block_count; // rows of this call
    nck_diagnostic_t *diagnostics; size_t diagnostic_max, diagnostic_count;
} nck_host_decoding_t;

// Decode text, or pushed blocks, until an array is full or the program has ended. Call again with
// the same cursor: it goes on where it was; the counts start from 0 at every call. All findings go
// to diagnostics; decoding goes on after an error with the next line or block.
// decode, toolcomp: begun by nck_decode_init and nck_toolcomp_init; blocks are the path of the
// tool, where G41 or G42 is in force too. Returns NCK_OK (more to come), NCK_DONE (the program has
// ended; text behind its end is used up, too), NCK_E_ARGUMENT (an array without rows, or the block
// at text_used is outside of its range: nothing goes on from there).
// Cost: linear in the text. Context: prep.
nck_status_t nck_host_decode(nck_decode_t *decode, nck_toolcomp_t *toolcomp,
                             nck_host_decoding_t *self);

// What a plan adds up to. Times in s. cut, rapid and dwell add up to time, and so do the limits, a
// ramp to the limit of the low point that it serves (host/why.h); accelerate, cruise and decelerate
// to cut and rapid.
typedef struct nck_host_totals {
    double time_s;              // whole periods, as the tick counts them
    double cut_s, rapid_s, dwell_s;
    double accelerate_s, cruise_s, decelerate_s;
    double limit_s[NCK_LIMIT_AXIS_V + NCK_AXIS_MAX]; // by nck_limit_t
    double length_mm;           // path metric
    uint64_t ticks, blocks, segs, nodes, cells;
    uint64_t tool_changes, spindle_starts; // their time is not in any of the sums
} nck_host_totals_t;

// Add a cell, rapid or not, to all sums but the limits'. since_stop_s: time since the last rest, 0
// before the first cell; at a stop the tick waits for its next period, and `settle` more until its
// filter (taps less one) has settled, and that time belongs to the cell too.
// Returns that time [s]. Cost: constant. Context: any.
double nck_host_totals_add(nck_host_totals_t *totals, double *since_stop_s, const nck_cell_t *cell,
                           int rapid, double period_s, uint32_t settle);

// A plan under way: kernel, input cursor, sums, and where single records go (any array may be
// NULL).
typedef struct nck_host_plan {
    nck_t *nck;                 // initialised by nck_host_plan_init
    const char *text;
    size_t text_size, text_used;
    uint32_t is_blocks;         // 1: the text is rows of nck_block_in_t
    uint32_t begun;             // 1: the kernel has its text, or will be given it piece by piece
    uint32_t reads;             // 1: the kernel reads the text itself
    const nck_host_batch_t *batch; // in work, in the place of text; NULL: the text is planned
    struct { size_t seg, whole, node, output, mark, order; } used; // rows of it
    nck_seg_t *segs;   size_t seg_max, seg_count;     // rows of this call
    nck_node_t *nodes; size_t node_max, node_count;
    nck_cell_t *cells; size_t cell_max, cell_count;
    nck_output_t *outputs; size_t output_max, output_count;
    nck_host_totals_t totals;   // of the whole plan so far
    uint64_t block_last;        // of a part: blocks before its end; 0: it ends with the program
    uint64_t blocks_before;     // of a part: those of the program before it
    double since_stop_s;        // time since the last rest, not yet counted in whole periods
    nck_terms_t terms;          // of the machine's slope
    int32_t error;              // of the program: returned when all before it is planned; NCK_OK
    int32_t status;             // last of nck_prep
    double tangent[NCK_AXIS_MAX]; // at the end of the newest seg
    nck_host_why_t why;         // what the time goes to; shares and a trail may be asked for
    nck_host_spindle_t spindle; // for the waits of threads; off unless it is asked for
} nck_host_plan_t;

// Begin to plan a whole text (which must outlive the plan). Installs its own hooks in nck.
// Returns as nck_init. Context: prep.
nck_status_t nck_host_plan_init(nck_host_plan_t *plan, nck_t *nck, const nck_machine_t *machine,
                                const char *text, size_t n);

// What was given as text is rows of nck_block_in_t, each valid. Call it right after
// nck_host_plan_init. Cost: constant. Context: prep.
void nck_host_plan_blocks(nck_host_plan_t *plan);

// The program has threads or taps: plan the waits for the spindle's angle, too; without it each is
// half a turn. The spindle turns as commanded. Not of a part, nor from batches. Call it right after
// nck_host_plan_init. Cost: then also linear in the periods of the plan. Context: prep.
void nck_host_plan_threads(nck_host_plan_t *plan);

// Plan only a part: from a cut of the same text on, so many blocks to the next one (0: to the end).
// The path rests at cuts, so each part is a plan of its own; its sums are those of the part alone,
// and parts that are cut alike add up to the same, whoever plans them. Call it right after
// nck_host_plan_init. Returns as nck_init. Cost: constant. Context: prep.
nck_status_t nck_host_plan_part(nck_host_plan_t *plan, const nck_host_cut_t *from,
                                uint64_t blocks);

// Plan from batches of path in the place of text: the first one, or the next one behind
// NCK_EMPTY. It must stay until the plan asks for the next one. Call it first right after
// nck_host_plan_init, which was given no text. Cost: constant. Context: prep.
void nck_host_plan_take(nck_host_plan_t *plan, const nck_host_batch_t *batch);

// Go on until an array is nearly full or the plan is done; the counts start from 0 at every call.
// An array that is given must hold at least 4 × NCK_WINDOW rows. Without arrays it goes on for
// NCK_WINDOW cells, so that the caller can show progress.
// Returns NCK_OK (call again), NCK_DONE, or the program error, as nck_prep; NCK_E_ARGUMENT if an
// array is too small (those of a trail: no more than NCK_HOST_TRAIL_ROOM). From batches besides:
// NCK_EMPTY (it needs the next one), NCK_E_STATE (where the path rests hangs on how full the rings
// are: nothing of the plan counts, plan the text).
// Cost: linear in the text. Context: prep and tick both.
nck_status_t nck_host_plan_run(nck_host_plan_t *plan);

#ifdef __cplusplus
}
#endif

#endif
