// SPDX-License-Identifier: MIT
// libnck, a session: what a machine with a panel, switches or a sender needs beside nck.h. An error
// refuses its line and no more, axes are homed and probed, soft limits move.
#ifndef NCK_SESSION_H
#define NCK_SESSION_H

#ifdef __cplusplus
extern "C" {
#endif

#include "nck/nck.h"                     // nck_t
#include "nck/prep/1_decode/decode.h"    // nck_decode_t
#include "nck/tick/6_interpolate/halt.h" // nck_halt_t

// What the operator asks for: single words, so that any context may write them.
typedef struct nck_command {
    uint32_t feed_ppm;       // override of programmed feeds, 0 … 2 000 000
    uint32_t rapid_ppm;      // override of rapids, 0 … 1 000 000
    uint32_t speed_um_s;     // as fast as the tool may be [µm/s]; UINT32_MAX: no such limit
    uint32_t hold;           // 1: come to rest on the path and stay
    uint32_t single_block;   // 1: the same at the end of every block
    uint32_t resumes;        // how often to go on was asked for
    uint32_t abort;          // 1: come to rest and drop the rest of the program
} nck_command_t;

// Have an error refuse its line and no more, as whoever types or sends lines expects: nck_prep and
// nck_diagnostic tell it, nothing of the line was done, what was in force before it is in force
// behind it, and the lines that follow are taken. Every line that does more than move straight is
// tried first, which takes its time once more. What radius compensation finds in lines that were
// taken before still ends the path, as in a program. before: memory that the kernel keeps a copy of
// its room 1 in; it must outlive the kernel. Text is pushed: nck_read is refused.
// Returns NCK_OK; NCK_E_STATE if text was pushed or is read. Cost: constant. Context: prep, right
// after nck_init.
nck_status_t nck_begin_session(nck_t *nck, nck_decode_t *before);

// In a session: as nck_begin, and modes stay, too, those of the last line that was taken. A line
// that was not taken to its end was never there. Returns as nck_begin, NCK_E_STATE outside of a
// session. Cost: linear in the capacities. Context: prep; the tick may go on running.
nck_status_t nck_go_on(nck_t *nck);

// In a session: the next line leaves nothing in force but the place that it moves to, as a jog
// must. Returns NCK_OK; NCK_FULL or NCK_E_STATE where a line or a part of one is not taken,
// NCK_E_STATE outside of a session. Cost: constant. Context: prep.
nck_status_t nck_leave_nothing(nck_t *nck);

// From now on (1) lines are read and checked alone: nothing moves, nothing is switched, and what
// they say is in force for the lines behind them. 0, or nck_begin, ends it; after 0 the axes are
// not where the text thinks, so nck_abort and nck_begin are to follow. Cost: constant. Context:
// prep.
void nck_check_only(nck_t *nck, uint32_t on);

// The operator's switches for the lines that nck_prep has not read yet, which is as far ahead of
// the tick as the window looks; they stay over nck_begin. skips: bit 0, every line that begins with
// / is skipped; bits 1 … 9, those that begin with /1 … /9, and a / alone is /1. stops: 1, M1 stops.
// At first they are as the machine's dialect has them. Returns NCK_OK; NCK_E_ARGUMENT if a number
// is out of range, and nothing is changed. Cost: constant. Context: prep.
nck_status_t nck_set_switches(nck_t *nck, uint32_t skips, uint32_t stops);

// What pose, outputs and diagnostics call the next line that is pushed, in place of its number; the
// one behind it is one more. Cost: constant. Context: prep, between two lines.
void nck_name_line(nck_t *nck, uint32_t name);

// The axes stand elsewhere than the kernel took them to, as homing finds out: this is where they
// are, in the machine. Offsets and modes stay. The next tick gives it as its setpoint; nck_prep
// says NCK_FULL until then. position_nm: NCK_AXIS_MAX of them [nm, ndeg]. Returns NCK_OK;
// NCK_E_ARGUMENT if a number is out of range; NCK_E_STATE unless all that was pushed is executed
// (nck_flush) and the axes rest, and while G41 or G42 is in force. Cost: constant. Context: prep;
// the tick may go on running.
nck_status_t nck_set_position(nck_t *nck, const int64_t *position_nm);

// Take over all offsets and tools of a modal state, as nck_modal has told it: G54 … G59.3 and which
// of them is in force, G92, G28, G30, the tool length, T and the tool in the spindle. Its other
// members count for nothing: modes are set by words, the place by nck_set_position. How a work
// system is turned (G10 L2 R) stays. Returns NCK_OK; NCK_E_ARGUMENT if a number is out of range;
// NCK_E_TOOL_UNKNOWN; NCK_E_STATE as nck_set_position. Cost: constant. Context: prep; the tick may
// go on running.
nck_status_t nck_modal_set(nck_t *nck, const nck_modal_t *modal);

// As nck_modal, but for the modes (motion … work_system), which are those at the tool: of the line
// that the last tick gave in its pose. The pose has feed and spindle speed there, too. Where all
// that was pushed is executed the two say the same. With a window below 64 they are, like the line,
// those where a seg begins. Cost: constant. Context: prep.
void nck_modal_executed(const nck_t *nck, nck_modal_t *modal_out);

// A tool of the table, with what G10 has changed in it. Returns NCK_OK, or NCK_E_TOOL_UNKNOWN.
// Cost: linear in tools and parameters. Context: prep.
nck_status_t nck_tool_of(const nck_t *nck, uint32_t number, nck_tool_t *tool_out);

// Put a tool into the table, in place of the one with its number. A tool length in force stays as
// it is, as behind G10 L1. Returns NCK_OK; NCK_E_ARGUMENT if a number is out of range, 0 is the
// tool's or the table is full; NCK_E_STATE as nck_set_position. Cost: linear in tools and
// parameters. Context: prep; the tick may go on running.
nck_status_t nck_tool_set(nck_t *nck, const nck_tool_t *tool);

// From now on lines are held against the travel (1), as behind nck_init, and refused before
// anything of them moves; or (0) they are not. Returns NCK_OK; NCK_E_STATE as nck_set_position.
// Cost: constant. Context: prep.
nck_status_t nck_heed_travel(nck_t *nck, uint32_t on);

// How often nck_set_position has been heard, nck_init counted. Where it is another number behind a
// tick, that tick's setpoint is where the drives stand, and no way for them to go.
// Cost: constant. Context: tick.
uint32_t nck_places(const nck_t *nck);

// An input asks for a stop: a probe touches, an axis is at its switch. Where the axes were told to
// be by the tick before is kept in halt.at, and from the next tick on every axis brakes straight
// on, in a time in which all keep halt.quick times their accelerations and, under a slope that
// knows jerk, their jerks (halt.h has the formula; what the path had of acceleration is gone at
// once). On a straight path that is on the path. The rest is dropped, as by nck_abort: at rest
// nck_prep says NCK_DONE, and nck_begin or nck_go_on goes on from where the axes stand. A stop in
// work is not begun anew. A pass of a thread is lost. halt must stay until then. Cost: constant.
// Context: tick, before nck_tick.
void nck_stop_at(nck_t *nck, nck_halt_t *halt);

// The joints where a stop was asked for. Returns NCK_OK; NCK_EMPTY before the next tick.
// Cost: constant. Context: any.
nck_status_t nck_stopped_at(const nck_t *nck, const nck_halt_t *halt, nck_axes_t *joints_out);

// Behind a probe (G38.2 … G38.5, G31) and nck_go_on: what it has found, which #5061 … #5070 tell
// the lines that follow. halt: where it touched; NULL: nothing was there on its way. A line that
// probes is to be pushed alone: nck_flush, and nothing behind it before it is executed or stopped.
// Returns NCK_OK; NCK_E_STATE outside of a session, and in the middle of a line. Cost: linear in
// the parameters. Context: prep.
nck_status_t nck_probed(nck_t *nck, const nck_halt_t *halt);

// What a WAIT is for is not there yet (1): the spindle's speed behind M3, M4 and S where the
// machine waits for it (spindle_waits), an input behind M66. The tick rests in NCK_TICK_DWELL, and
// nck_resume ends a hold alone. 0: it is there, and the path goes on, unless it is held. Say 1 in
// on_output, when it is told; a WAIT of which nobody says so is the operator's. nck_begin and
// nck_go_on forget it. Cost: constant. Context: any.
void nck_await(nck_t *nck, uint32_t on);

// Behind M66: what it has found, which #5399 tells the lines that follow. A line that may ask is to
// be pushed once M66 is executed (nck_flush). value: 1 or 0; −1: it did not come in time. Returns
// NCK_OK; NCK_E_STATE outside of a session, and in the middle of a line. Cost: linear in the
// parameters. Context: prep.
nck_status_t nck_answered(nck_t *nck, double value);

// What the clocks of the machine say to the lines that are pushed from now on: Fanuc's #3001 #3002
// #3011 #3012. Cost: constant. Context: prep.
void nck_set_clock(nck_t *nck, const nck_wall_clock_t *clock);

// Soft limits of an axis from now on, besides the travel that the program is held against: before
// the path leaves them it comes to rest, as by a hold, as far in front as a brake may take that has
// no more than what its bends leave at their caps. nck_resume goes on once they are wide enough.
// What is within 30 periods (linear slope: ten) and a brake of the limit by now is left as soon as
// it can be, no sooner: the last look at a setpoint is the drive's. They stay until nck_init.
// least_nm ≤ most_nm [nm, ndeg]; INT64_MIN, INT64_MAX: free. Returns NCK_OK, or NCK_E_ARGUMENT.
// Cost: constant. Context: prep.
nck_status_t nck_set_travel(nck_t *nck, uint32_t axis, int64_t least_nm, int64_t most_nm);

// 1 if the path brakes, or rests, before the soft limits that it would leave.
// Cost: constant. Context: any.
int nck_is_at_travel(const nck_t *nck);

// As fast as the tool may be from now on, in feeds and rapids and whatever the overrides say
// [µm/s]. UINT32_MAX: no such limit, as behind nck_init; 0 rests until it is raised. Moves of
// rotary axes alone do not heed it. Cost: constant. Context: any.
void nck_set_speed(nck_t *nck, uint32_t most_um_s);

// 1 if the tick executes a cell, or has one to take. Cost: constant. Context: tick.
int nck_is_moving(const nck_t *nck);

// 1 if a pass of a thread was stopped before its end: by nck_abort; since the axes could not follow
// the spindle's angle, which was 2 ms of its turning beside the tool; or since it hardly turned.
// Then the tick rests in NCK_TICK_HOLD.
// nck_begin forgets it.
// Cost: constant. Context: any.
int nck_is_thread_lost(const nck_t *nck);

// How many bytes of the source are read; behind a jump backward it is less than before.
// Cost: constant. Context: prep.
size_t nck_read_offset(const nck_t *nck);

// Final cells that wait for the tick. Cost: constant. Context: any.
uint32_t nck_queue_cells(const nck_t *nck);

// How many joints the machine has. Cost: constant. Context: any.
uint32_t nck_joint_count(const nck_t *nck);

// The axis that drives a joint, which is less than nck_joint_count. Cost: constant. Context: any.
uint32_t nck_joint_axis(const nck_t *nck, uint32_t joint);

// The machine, with the limits in force. Cost: constant. Context: any.
const nck_machine_t *nck_machine_of(const nck_t *nck);

// What the operator asks for, as of now. Cost: constant. Context: any.
void nck_asked(const nck_t *nck, nck_command_t *command_out);

#ifdef __cplusplus
}
#endif

#endif
