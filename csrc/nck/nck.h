// SPDX-License-Identifier: MIT
// libnck, the front door: NC text in, axis setpoints out. Memory is the caller's.
//
//     nck_t *const nck = nck_place(memory, sizeof memory);  // or one of nck_memory.h
//     nck_machine_default(&machine);                        // then change what differs
//     nck_init(nck, &machine, NULL);
//     low-priority task:  nck_push text …, nck_end; nck_prep as long as it says NCK_OK
//     1 ms interrupt:     nck_tick(nck, &pose, &axes)
//     after the end:      nck_begin, and more text; or geometry by nck_push_block
//
// nck_session.h has what a machine with a panel, switches or a sender needs beside it, nck_tools.h
// what hosts and tests open.
//
// Units: integers in nm and ndeg, doubles in mm, deg and s, where a name has no other at its end.
// Errors: what can fail returns nck_status_t, NCK_OK or the reason. Over: the tick's state is
// NCK_TICK_IDLE and nck_prep has said NCK_DONE; nck_is_idle tells both in the tick.
//
// Contexts: "prep" is one task or thread, "tick" is one interrupt or thread of higher priority.
// Only the link (base/link.h) crosses between them, and single words of room 6: whether the tick
// waits or is at rest.
#ifndef NCK_H
#define NCK_H

#include <stddef.h> // size_t

#ifdef __cplusplus
extern "C" {
#endif

#include "nck/base/machine.h"           // nck_machine_t
#include "nck/base/records.h"           // nck_output_t … nck_axes_t
#include "nck/base/sized.h"             // NCK_SIZED NCK_VERSION
#include "nck/base/source.h"            // nck_source_t
#include "nck/base/status.h"            // nck_status_t nck_diagnostic_t
#include "nck/prep/1_decode/state/block_in.h" // nck_block_in_t

// The kernel: nck_memory.h has what is in it.
typedef struct nck nck_t;

// What the kernel tells its owner. Every pointer may be NULL.
typedef struct nck_hooks {
    void *user;                                                  // handed back in every call
    void (*on_output)(void *user, const nck_output_t *output);   // S, M, T in order; tick context
    void (*on_node)(void *user, const nck_node_t *node);         // every final node; prep context
    void (*on_seg)(void *user, const nck_seg_t *seg);            // every seg; prep context
} nck_hooks_t;

// How much is under way.
typedef struct nck_queue {
    uint64_t blocks;  // taken from text and pushed blocks since nck_init or nck_begin
    uint64_t executed; // of them, to their ends; those without motion with the motion before them
    uint32_t smooth;  // of them, held back until what follows them is known
    uint32_t segs;    // not executed to their ends
    uint32_t outputs; // not handed over
    uint32_t cells;   // final and not taken by the tick
    uint32_t text;    // 1: a line, a part of one or a pushed block is not taken to its end
} nck_queue_t;

// What is in force where the next line or block begins.
typedef struct nck_modal {
    int32_t motion;       // 0 … 3: G0 … G3; −1: none
    uint8_t plane;        // 17, 18, 19
    uint8_t inch;         // 1: G20
    uint8_t diameter;     // 1: G7
    uint8_t incremental;  // 1: G91
    uint8_t feed_mode;    // nck_feed_mode_t
    uint8_t path_mode;    // nck_path_mode_t
    uint8_t spindle_on;   // 1: M3 or M4
    uint8_t spindle_code; // 3 or 4: the last of them; 0: none yet
    uint8_t coolant;      // bit 0: M7, bit 1: M8
    uint8_t work_system;  // 0: G54 … 8: G59.3, 9: that of G54.1 P
    double tolerance_mm;  // G64 P
    double feed;          // by feed_mode [mm/min, 1/min, mm/rev]; 0: none yet
    double spindle_rpm;   // S; 0: none yet
    double surface;       // S under G96 [mm/min]; 0: G97
    uint32_t tool_next;   // T
    uint32_t tool_in;     // T at the last M6
    int64_t position_nm[NCK_AXIS_MAX]; // programmed, of the machine [nm, ndeg]
    int64_t origin_nm[NCK_AXIS_MAX];   // the program's zero there: work + G92 + tool
    int64_t work_nm[NCK_AXIS_MAX];     // of the work system in force
    int64_t g92_nm[NCK_AXIS_MAX];
    int64_t tool_nm[3];                // G43: X Y Z
    int64_t systems_nm[NCK_WORK_SYSTEMS][NCK_AXIS_MAX]; // G54 … G59.3
    int64_t home_nm[2][NCK_AXIS_MAX];  // G28, G30
} nck_modal_t;

// What nck_selftest returns where arithmetic is as it has to be.
#define NCK_SELFTEST 0xb35bf160u

// Compute formulas of all rooms from fixed numbers. Another number than NCK_SELFTEST: arithmetic
// was compiled or set otherwise (a·b + c rounded once, x87, -ffast-math, no numbers below 2⁻¹⁰²²,
// another rounding), setpoints have other bits than on every other machine and were never tested.
// Then do not move.
// Cost: constant, 10⁴ operations of double; 1 KB of stack. Context: any, before nck_init.
uint32_t nck_selftest(void);

// Bytes that a kernel of this library takes. Cost: constant. Context: any.
size_t nck_size(void);

// The kernel that is to live in memory of the caller, who keeps it there: it points into itself.
// NULL if that is fewer than nck_size() bytes, or not aligned to 8. Who would rather have it
// reserved by the linker declares an nck_t, as nck_memory.h has it, in one file.
// Cost: constant. Context: any, before nck_init.
nck_t *nck_place(void *memory, size_t size);

// For the linker this name has capacities and version in it (sized.h): with others than the
// library's nothing links.
#define nck_init NCK_SIZED(nck_init)

// Make a kernel for a machine (copied). hooks may be NULL.
// Returns NCK_OK; NCK_E_ARGUMENT without a kernel; NCK_E_MACHINE or NCK_E_UNSUPPORTED if
// nck_machine_check refuses the machine. Cost: constant. Context: any, before the tick runs.
nck_status_t nck_init(nck_t *nck, const nck_machine_t *machine, const nck_hooks_t *hooks);

// Hand over program text, in pieces of any size; used_out is how much was taken (0 … n).
// Returns NCK_OK, NCK_FULL if nothing more fits before nck_prep has worked, NCK_E_STATE after
// nck_end.
// Cost: linear in n. Context: prep.
// In pose, outputs and diagnostics `line` is the number of the source line.
nck_status_t nck_push(nck_t *nck, const char *text, size_t n, size_t *used_out);

// Have the kernel read the program itself instead of pushing it: from text in place, or through a
// hook that gives bytes from any offset on. What jumps backward needs it: subprograms, loops, GOTO.
// Call it behind nck_init or nck_begin, before anything is pushed; what the source points to must
// stay until the program has ended. nck_prep never says NCK_EMPTY then, and nck_flush is done at
// the program's end.
// Returns NCK_OK; NCK_E_ARGUMENT if the source has neither text nor read; NCK_E_STATE if the
// program has begun, and with capacities that leave jumps out. Cost: constant. Context: prep.
nck_status_t nck_read(nck_t *nck, const nck_source_t *source);

// Hand over a block without text, in the place of a line: its units are mm, degrees and seconds.
// Text and blocks may alternate; position and modes are one for both. What is wrong with it in the
// program's terms (travel, feed, arc) nck_prep tells, as for a line; `line` is the block's id.
// Returns NCK_OK; NCK_FULL if nothing more fits before nck_prep has worked; NCK_E_ARGUMENT if a
// member is outside of its range; NCK_E_STATE in the middle of a line, after the program's end and
// after nck_end. Cost: constant. Context: prep.
nck_status_t nck_push_block(nck_t *nck, const nck_block_in_t *block);

// Nothing more comes for now: what has been pushed is executed to its end, where the path comes to
// rest; a line without its line feed is complete. More may be pushed afterwards: the path goes on
// from there. Until everything before is planned, pushing says NCK_FULL.
// Cost: constant. Context: prep.
void nck_flush(nck_t *nck);

// Say that the text is complete: what is left is planned to its end.
// Cost: constant. Context: prep.
void nck_end(nck_t *nck);

// Begin another program where the axes are at rest now. Offsets stay as the last block decoded has
// left them (work systems, G92, tool length, and the tools of T and M6); modes are those of the
// machine again, as behind nck_init; overrides and single block stay; a hold or an abort is over.
// Counts (seg, block, line, s) begin at 0. What an abort has dropped stays dropped. Text can be
// pushed at once; nck_prep says NCK_FULL until the next tick (or nck_take).
// Returns NCK_OK; NCK_E_STATE while the tick still moves, before the end of the program is executed
// (nck_abort drops the rest), and after NCK_E_INTERNAL: there only nck_init begins anew.
// Cost: linear in the capacities. Context: prep; the tick may go on running.
nck_status_t nck_begin(nck_t *nck);

// Do one bounded piece of work of the asynchronous rooms.
// Returns NCK_OK (call again), NCK_EMPTY (needs text), NCK_FULL (waits for the tick), NCK_DONE (all
// is handed over), or a program error, once; nck_diagnostic tells it and everything before it is
// executed. NCK_E_INTERNAL, once, and told likewise: an invariant is broken; the tick comes to rest
// on what is final and its stop tail, as after nck_abort.
// Cost: bounded work (one block, or one spline or corner, or 32 nodes, or 32 cells), not time:
// docs/size.md has the longest steps, millions of instructions where doubles are software.
// Context: prep.
nck_status_t nck_prep(nck_t *nck);

// Take the oldest diagnostic. Returns NCK_OK or NCK_EMPTY. Cost: constant. Context: prep.
nck_status_t nck_diagnostic(nck_t *nck, nck_diagnostic_t *diagnostic_out);

// One interpolation period: where the axes are to be now. Never blocks, never fails.
// Returns the state. Cost: bounded by the cells in one period. Context: tick.
nck_tick_state_t nck_tick(nck_t *nck, nck_pose_t *pose_out, nck_axes_t *axes_out);

// Where the axes are: what the last tick has handed out, before the first one the start. Returns
// the tick's state. Cost: constant. Context: tick; prep while the tick is at rest.
nck_tick_state_t nck_position(const nck_t *nck, nck_pose_t *pose_out, nck_axes_t *axes_out);

// 1 if the tick has nothing left to do: at rest, no WAIT, no cell and no output left.
// Cost: constant. Context: tick.
int nck_is_idle(const nck_t *nck);

// Come to rest on the path, within the limits of the slope, and stay until nck_resume. The state is
// NCK_TICK_HOLD from the first cell of the brake on. The brake begins within ten periods, along a
// clocked path at once: there nck_resume on the way to rest sets off again.
// Cost: constant. Context: any.
void nck_hold(nck_t *nck);

// Go on after M0, M1, M6 or M60, after a hold, and at a block's end in single block.
// Cost: constant. Context: any.
void nck_resume(nck_t *nck);

// Come to rest as by a hold and drop what has not been executed: nck_prep says NCK_DONE, the tick
// stays in NCK_TICK_HOLD and is idle there. nck_begin goes on from there with another program.
// Cost: constant. Context: any.
void nck_abort(nck_t *nck);

// Hold at the end of every block (1) or no longer (0); outputs behind it wait, too. Cost: constant.
// Context: any.
void nck_set_single_block(nck_t *nck, uint32_t on);

// Millionths in one per cent, as nck_set_override takes them.
#define NCK_PERCENT 10000u

// Scale the programmed feeds by 0 … 2 000 000 millionths and the rapids by 0 … 1 000 000; what is
// more counts as the most. The other limits stay. 0 rests until it is raised again. Millionths, so
// that a feed may follow what is measured. Cost: constant. Context: any.
void nck_set_override(nck_t *nck, uint32_t feed_ppm, uint32_t rapid_ppm);

// Change limits between blocks: of every axis v_max, rapid, a_max and j_max, of the path feed_max,
// a_max, j_max, chord_error and tolerance (what a bare G64 means from the next one on). The rest of
// `machine` must be valid and counts for nothing. They hold for what is pushed afterwards; the path
// comes to rest between. What waits is flushed first: NCK_FULL until it is executed (call nck_prep,
// then again), since an answer to the operator goes by one set of limits. A change of feed or of
// tolerance alone needs no rest: see nck_block_in_t.
// Returns NCK_OK, NCK_FULL; NCK_E_MACHINE or NCK_E_UNSUPPORTED as nck_init.
// Cost: constant. Context: prep.
nck_status_t nck_set_limits(nck_t *nck, const nck_machine_t *machine);

// The spindle's angle as measured, for the next tick: in revolutions from any begin on, counting up
// whichever way M3 or M4 has it turn, and down while a tap turns it back. Call it before every
// nck_tick; before the first call the kernel takes the spindle to turn as commanded. Passes of
// threads and taps follow it. Cost: constant. Context: tick.
void nck_set_spindle(nck_t *nck, double turns);

// How much is under way. Cost: constant. Context: prep; `cells` from the tick too.
void nck_queue(const nck_t *nck, nck_queue_t *queue_out);

// What is in force, and where the program's zero is, as of the last block decoded.
// Cost: constant. Context: prep.
void nck_modal(const nck_t *nck, nck_modal_t *modal_out);

#ifdef __cplusplus
}
#endif

#endif
