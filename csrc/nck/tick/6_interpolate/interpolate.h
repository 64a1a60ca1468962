// SPDX-License-Identifier: MIT
// Room 6, interpolate: cell + seg → pose. Where the tool is at tick k.
#ifndef NCK_TICK_INTERPOLATE_H
#define NCK_TICK_INTERPOLATE_H

#include "nck/base/link.h"    // nck_link_t
#include "nck/base/machine.h" // nck_machine_t
#include "nck/base/records.h" // nck_cell_t nck_pose_t
#include "nck/base/status.h"  // nck_status_t
#include "nck/base/terms.h"   // nck_terms_t
#include "nck/tick/6_interpolate/clock.h" // nck_clock_t
#include "nck/tick/6_interpolate/mean.h"  // nck_filter_t
#include "nck/tick/6_interpolate/halt.h"  // nck_halt_t
#include "nck/tick/6_interpolate/stretch.h" // nck_stretch_past_t
#include "nck/tick/6_interpolate/sync.h"  // nck_sync_t
#include "nck/tick/6_interpolate/watch.h" // nck_watch_t

// Periods of a span. Time counts from the last rest or, if that is longer ago, from a whole number
// of spans after it.
enum { NCK_INTERPOLATE_SPAN = 1024 };

// The room's state.
typedef struct nck_interpolate {
    const nck_machine_t *machine;
    const nck_terms_t *terms;
    nck_link_t *link;       // consumer's side
    nck_cell_t cell;        // being executed
    double a_before;        // of the cell before, behind a rest 0 [path mm/s²]
    uint32_t has_cell;      // 1: cell is valid; any reads it
    uint32_t from_tail;     // 1: it came from the stop tail
    uint32_t rests;         // 1: the last cell came to rest and the tick has landed
    uint32_t waits;         // 1: until resume; any reads it
    uint32_t resume;        // any context asks to go on
    uint32_t awaits;        // 1: … which counts once this is 0; any writes it
    nck_filter_t filter;
    nck_sync_t sync;      // the spindle, and the pass of a thread in work
    nck_clock_t clock;
    nck_stretch_past_t past; // along a clocked path
    nck_watch_t watch;      // over prep
    uint32_t brakes;        // as what a tick is told that has to brake, an nck_tick_state_t; 0: not
    uint32_t stands;        // 1: it has, and rests; any reads it
    uint32_t kept;          // 1: its clock, if it stands, waits for a plan; prep says so
    nck_halt_t *halt;       // of the axes beside the path, in work or at its rest; NULL: none
    uint64_t k;             // periods since time began to count
    double t_cell;          // when the cell begins [s]
    uint32_t told;          // bit 0: the axes stand at the machine's start position: prep says so;
                            // above it, how often that was
    uint32_t modes;         // in force there (in_force.h); any reads it
    nck_pose_t pose;        // of the last tick
} nck_interpolate_t;

// At rest at the machine's start position. Cost: constant. Context: any, before the tick runs.
void nck_interpolate_init(nck_interpolate_t *self, const nck_terms_t *terms, nck_link_t *link);

// One period on. Returns the pose; it stays valid and unchanged until the next call.
// Cost: linear in the cells that end in this period. Context: tick.
const nck_pose_t *nck_interpolate_tick(nck_interpolate_t *self);

// Take a cell as the tick would, without executing it: its segs count as finished.
// Returns NCK_OK or NCK_EMPTY; never a cell of the tail. Cost: constant. Context: tick.
nck_status_t nck_interpolate_take(nck_interpolate_t *self, nck_cell_t *cell_out);

// The spindle's angle at the tick that comes, in revolutions from any begin on, counting up however
// it turns. Until it is told for the first time, the spindle is taken to turn as commanded.
// Cost: constant. Context: tick.
void nck_interpolate_measure(nck_interpolate_t *self, double turns);

// Stop a pass of a thread in work by itself, and begin none; the tick waits then. Cost: constant.
// Context: any.
void nck_interpolate_stop_thread(nck_interpolate_t *self);

// 1: begin no pass of a thread, one in work goes on; 0: as before. Cost: constant. Context: any.
void nck_interpolate_hold_thread(nck_interpolate_t *self, uint32_t on);

// Stop the axes in the next tick: see nck_stop_at. Cost: constant. Context: tick.
void nck_interpolate_stop(nck_interpolate_t *self, nck_halt_t *halt);

// What is known of prep before a tick: 1 if somebody asks for rest; 1 if the plan in force brings
// it; prep's steps so far, 0 if it has nothing left to do. The tick brakes by itself, and comes to
// rest as soon as the axes can, where the rest has no plan in time or takes too long, and on the
// tail where prep is not seen any more; it sets off again when that is over. A pass of a thread
// and a rest end as they would. Cost: constant. Context: tick.
void nck_interpolate_watch(nck_interpolate_t *self, int asks, int planned, uint32_t steps);

// 1: an answer to the operator is made while the clock stands, which waits for it, 250 periods at
// most; 0: there is none. Cost: constant. Context: prep.
void nck_interpolate_keep(nck_interpolate_t *self, uint32_t on);

// What the clock does, an nck_clock_state_t; it runs where there is no plan. Cost: constant.
// Context: any.
uint32_t nck_interpolate_clock(const nck_interpolate_t *self);

// 1 if it has come to rest by that in the middle of a plan. Cost: constant. Context: any.
int nck_interpolate_stands(const nck_interpolate_t *self);

// 1 at a WAIT that nobody has ended. Cost: constant. Context: any.
int nck_interpolate_is_waiting(const nck_interpolate_t *self);

// 1 if a rapid is in work, or comes next where the path rests. Cost: constant. Context: tick.
int nck_interpolate_is_rapid(nck_interpolate_t *self);

// 1 if the tick has nothing left to execute, or waits. Cost: constant. Context: any; another than
// the tick's: as long as nothing is published.
int nck_interpolate_is_at_rest(const nck_interpolate_t *self);

// Go on after a WAIT. Cost: constant. Context: any.
void nck_interpolate_resume(nck_interpolate_t *self);

// 1: what a WAIT is for is not there yet, whoever asks to go on; 0: it is. Cost: constant. Context:
// any.
void nck_interpolate_await(nck_interpolate_t *self, uint32_t on);

// Periods from a rest to the landing after the time t: the smallest k ≥ 1 with k·T ≥ t, in the
// arithmetic of the tick. A filter adds its taps less one, if the path moved.
// Cost: constant. Context: any.
uint64_t nck_interpolate_periods(double t, double period);

// Let time begin to count later by as many whole spans as *t holds: a double resolves the time
// within a cell much better if it need not hold the hours before. Returns the periods of the spans
// taken off *t. Cost: constant. Context: any.
uint64_t nck_interpolate_rebase(double *t, double period);

// Every invariant of the room, for tests: 1 if all hold. Cost: constant. Context: as the tick's.
int nck_interpolate_invariants(const nck_interpolate_t *self);

#endif
