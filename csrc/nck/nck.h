// SPDX-License-Identifier: MIT
// libnck, the front door: NC text in, axis setpoints out. One struct, owned by the caller.
//
//     static nck_t nck;
//     nck_machine_default(&nck_machine);            // then change what differs
//     nck_init(&nck, &nck_machine, NULL);
//     low-priority task:  nck_push text …, nck_end; nck_prep as long as it says NCK_OK
//     1 ms interrupt:     nck_tick(&nck, &pose, &axes)
//
// Contexts: "prep" is one task or thread, "tick" is one interrupt or thread of higher priority.
// Only the link (base/link.h) crosses between them.
#ifndef NCK_H
#define NCK_H

#include <stddef.h> // size_t

#ifdef __cplusplus
extern "C" {
#endif

#include "nck/base/link.h"                      // nck_link_t
#include "nck/base/machine.h"                   // nck_machine_t
#include "nck/base/records.h"                   // nck_block_t … nck_axes_t
#include "nck/base/status.h"                    // nck_status_t nck_diagnostic_t
#include "nck/prep/1_decode/decode.h"           // nck_decode_t
#include "nck/prep/2_toolcomp/toolcomp.h"       // nck_toolcomp_t
#include "nck/prep/3_smooth/smooth.h"           // nck_smooth_t
#include "nck/prep/4_lookahead/lookahead.h"     // nck_lookahead_t
#include "nck/prep/5_slope/slope.h"             // nck_slope_t
#include "nck/tick/6_interpolate/interpolate.h" // nck_interpolate_t
#include "nck/tick/7_transform/transform.h"     // nck_transform_t

// What the kernel tells its owner. Every pointer may be NULL.
typedef struct nck_hooks {
    void *user;                                                  // handed back in every call
    void (*on_output)(void *user, const nck_output_t *output);   // S, M, T in order; tick context
    void (*on_node)(void *user, const nck_node_t *node);         // every final node; prep context
    void (*on_seg)(void *user, const nck_seg_t *seg);            // every seg; prep context
} nck_hooks_t;

// What the operator asks for: single words, so that any context may write them.
typedef struct nck_command {
    uint32_t feed_percent;  // override of programmed feeds, 0 … 200
    uint32_t rapid_percent; // override of rapids, 0 … 100
    uint32_t hold;          // 1: come to rest on the path and stay
    uint32_t single_block;  // 1: the same at the end of every block
    uint32_t resumes;       // how often to go on was asked for
    uint32_t abort;         // 1: come to rest and drop the rest of the program
} nck_command_t;

// The kernel. The order of the members is the order of the flow. Once made it must be neither moved
// nor copied, for its rooms point to its machine and to one another.
typedef struct nck {
    nck_machine_t machine;
    nck_hooks_t hooks;
    nck_command_t command;
    nck_decode_t decode;
    nck_toolcomp_t toolcomp;
    nck_smooth_t smooth;
    nck_lookahead_t lookahead;
    nck_slope_t slope;
    nck_link_t link;
    nck_interpolate_t interpolate;
    nck_transform_t transform;
    struct {
        nck_block_t block;      // on its way from 2_toolcomp to 3_smooth
        uint8_t ended;          // 1: no more blocks: END, end of text or a program error
        uint8_t given_up;       // 1: after NCK_E_INTERNAL
        uint8_t hungry;         // 1: text has been asked for and has not come
        uint32_t blocks;        // blocks so far, of all kinds
        nck_diagnostic_t diagnostic; // of a room behind 1_decode; code 0: none
    } wire;
} nck_t;

// Make a kernel for a machine (copied). hooks may be NULL.
// Returns NCK_OK, or NCK_E_MACHINE if nck_machine_check refuses the machine.
// Cost: constant. Context: any, before the tick runs.
nck_status_t nck_init(nck_t *nck, const nck_machine_t *machine, const nck_hooks_t *hooks);

// Hand over program text, in pieces of any size; used_out is how much was taken (0 … n).
// Returns NCK_OK, NCK_FULL if nothing more fits before nck_prep has worked, NCK_E_STATE after
// nck_end.
// Cost: linear in n. Context: prep.
nck_status_t nck_push(nck_t *nck, const char *text, size_t n, size_t *used_out);

// Say that the text is complete: what is left is planned to its end.
// Cost: constant. Context: prep.
void nck_end(nck_t *nck);

// Do one bounded piece of work of the asynchronous rooms.
// Returns NCK_OK (call again), NCK_EMPTY (needs text), NCK_FULL (waits for the tick), NCK_DONE (all
// is handed over), or a program error, once; nck_diagnostic tells it and everything before it is
// executed. NCK_E_INTERNAL, once, and told likewise: an invariant is broken; the tick comes to rest
// on what is final and its stop tail, as after nck_abort.
// Cost: bounded work (one block, or one spline or corner, or 32 nodes, or 32 cells), not time: the
// README's table has the longest steps, millions of instructions where doubles are software.
// Context: prep.
nck_status_t nck_prep(nck_t *nck);

// Take the oldest diagnostic. Returns NCK_OK or NCK_EMPTY. Cost: constant. Context: prep.
nck_status_t nck_diagnostic(nck_t *nck, nck_diagnostic_t *diagnostic_out);

// One interpolation period: where the axes are to be now. Never blocks, never fails.
// Returns the state. Cost: bounded by the cells in one period. Context: tick.
nck_tick_state_t nck_tick(nck_t *nck, nck_pose_t *pose_out, nck_axes_t *axes_out);

// Go on after M0, M1, M6 or M60, after a hold, and at a block's end in single block.
// Cost: constant. Context: any.
void nck_resume(nck_t *nck);

// Come to rest on the path, within the limits of the slope, and stay until nck_resume. The state is
// NCK_TICK_HOLD from the first cell of the brake on. The brake begins within ten periods if prep
// makes one short plan, a bounded number of steps, in five of them, else that much later; classical
// S-shape: within 70 periods, a ramp and one of its cells.
// Cost: constant. Context: any.
void nck_hold(nck_t *nck);

// Hold at the end of every block (1) or no longer (0). Returns NCK_OK, or NCK_E_STATE under the
// classical S-shape. Cost: constant. Context: any.
nck_status_t nck_set_single_block(nck_t *nck, uint32_t on);

// Scale the programmed feeds by 0 … 200 % and the rapids by 0 … 100 %; what is more counts as the
// most. The other limits stay. 0 rests until it is raised again. Returns NCK_OK, or NCK_E_STATE
// under the classical S-shape. Cost: constant. Context: any.
nck_status_t nck_set_override(nck_t *nck, uint32_t feed_percent, uint32_t rapid_percent);

// Come to rest as by a hold and drop what has not been executed: nck_prep says NCK_DONE, the tick
// stays in NCK_TICK_HOLD and is idle there. Only nck_init begins anew (machine.start_nm: where the
// axes stand). Cost: constant. Context: any.
void nck_abort(nck_t *nck);

// 1 if the tick has nothing left to do: at rest, no WAIT, no cell and no output left.
// Cost: constant. Context: tick.
int nck_is_idle(const nck_t *nck);

// Take the next final cell in place of the tick: for planning without executing (machining time,
// pictures). Outputs are handed over as in the tick. Returns NCK_OK or NCK_EMPTY. Cost: constant.
// Context: tick.
nck_status_t nck_take(nck_t *nck, nck_cell_t *cell_out);

#ifdef __cplusplus
}
#endif

#endif
