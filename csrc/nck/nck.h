// SPDX-License-Identifier: MIT
// libnck, the front door: NC text in, axis setpoints out. One struct, owned by the caller.
//
//     static nck_t nck;
//     nck_machine_default(&nck_machine);            // then change what differs
//     nck_init(&nck, &nck_machine, NULL);
//     low-priority task:  nck_push text …, nck_end; nck_prep as long as it says NCK_OK
//     1 ms interrupt:     nck_tick(&nck, &pose, &axes)
//     after the end:      nck_begin, and more text; or geometry by nck_push_block
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

#include "nck/base/link.h"                      // nck_link_t
#include "nck/base/machine.h"                   // nck_machine_t
#include "nck/base/records.h"                   // nck_block_t … nck_axes_t
#include "nck/base/sized.h"                     // NCK_SIZED NCK_VERSION
#include "nck/base/status.h"                    // nck_status_t nck_diagnostic_t
#include "nck/base/terms.h"                     // nck_terms_t
#include "nck/prep/1_decode/decode.h"           // nck_decode_t
#include "nck/prep/2_toolcomp/toolcomp.h"       // nck_toolcomp_t
#include "nck/prep/3_smooth/smooth.h"           // nck_smooth_t
#include "nck/prep/4_lookahead/lookahead.h"     // nck_lookahead_t
#include "nck/prep/5_slope/slope.h"             // nck_slope_t
#include "nck/prep/5_slope/travel.h"            // nck_travel_t
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
    uint32_t feed_ppm;       // override of programmed feeds, 0 … 2 000 000
    uint32_t rapid_ppm;      // override of rapids, 0 … 1 000 000
    uint32_t speed_um_s;     // as fast as the tool may be [µm/s]; UINT32_MAX: no such limit
    uint32_t hold;           // 1: come to rest on the path and stay
    uint32_t single_block;   // 1: the same at the end of every block
    uint32_t resumes;        // how often to go on was asked for
    uint32_t abort;          // 1: come to rest and drop the rest of the program
} nck_command_t;

// How far a flush has come.
typedef enum nck_flush_state {
    NCK_FLUSH_NOT = 0,
    NCK_FLUSH_ASKED = 1,  // decode still has blocks
    NCK_FLUSH_SMOOTH = 2, // smooth gives what it held back
    NCK_FLUSH_AHEAD = 3   // look-ahead places what it held back
} nck_flush_state_t;

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

// The kernel. The order of the members is the order of the flow. They are its own: the functions
// below tell what others need. Once initialised it must not move, for it points into itself.
typedef struct nck {
    nck_machine_t machine;
    nck_terms_t terms;
    nck_hooks_t hooks;
    nck_command_t command;
    nck_decode_t decode;
    nck_toolcomp_t toolcomp;
    nck_smooth_t smooth;
    nck_lookahead_t lookahead;
    nck_travel_t travel;
    nck_slope_t slope;
    nck_link_t link;
    nck_interpolate_t interpolate;
    nck_transform_t transform;
    struct {
        nck_block_t block;      // on its way from 2_toolcomp to 3_smooth
        nck_command_t heard;    // by 5_slope in its last step; hold: 1 at soft limits, too
        uint8_t last;           // 1: toolcomp has the last blocks
        uint8_t ended;          // 1: no more blocks: END, end of text or a program error
        uint8_t given_up;       // 1: after NCK_E_INTERNAL
        uint8_t flush;          // nck_flush_state_t
        uint8_t checks;         // 1: blocks are dropped behind decode
        uint32_t blocks;        // blocks so far, of all kinds
        nck_diagnostic_t diagnostic; // of a room behind 1_decode; code 0: none
        uint32_t steps;         // of nck_prep, 0 when it is done; any reads
    } wire;
} nck_t;

// What nck_selftest returns where arithmetic is as it has to be.
#define NCK_SELFTEST 0x268f1eb2u

// Compute formulas of all rooms from fixed numbers. Another number than NCK_SELFTEST: arithmetic
// was compiled or set otherwise (a·b + c rounded once, x87, -ffast-math, no numbers below 2⁻¹⁰²²,
// another rounding), setpoints have other bits than on every other machine and were never tested.
// Then do not move.
// Cost: constant, 10⁴ operations of double; 1 KB of stack. Context: any, before nck_init.
uint32_t nck_selftest(void);

// For the linker this name has capacities and version in it (sized.h): with others than the
// library's nothing links.
#define nck_init NCK_SIZED(nck_init)

// Make a kernel for a machine (copied). hooks may be NULL.
// Returns NCK_OK; NCK_E_MACHINE or NCK_E_UNSUPPORTED if nck_machine_check refuses the machine.
// Cost: constant. Context: any, before the tick runs.
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

// How many bytes of the source are read; behind a jump backward it is less than before.
// Cost: constant. Context: prep.
size_t nck_read_offset(const nck_t *nck);

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

// Read a text from its middle on, right after nck_init with the machine standing there: rooms 1 and
// 2 as they were elsewhere behind so many blocks of the same text, which is at `text` here.
// Cost: constant. Context: prep, before the tick runs.
void nck_enter(nck_t *nck, const nck_decode_t *decode, const nck_toolcomp_t *toolcomp,
               uint32_t blocks, const char *text);

// The program ends once so many blocks have been taken, the ones before nck_enter counted: call it
// behind every prep step. Cost: constant. Context: prep.
void nck_leave_at(nck_t *nck, uint32_t blocks);

// Hand over a piece of path in the place of text, with its caps as room 4 of another kernel for the
// same machine has found them: rooms 1 to 4 of this one stay empty. Its seg is in the link by then,
// the outputs before that too. Behind each piece, or the few that became known together, nck_prep
// goes on until it says NCK_EMPTY, unless nck_lacks_pieces.
// Returns NCK_OK; NCK_FULL if nothing more fits before the tick has taken cells; NCK_E_STATE once
// the path has ended, be it because rings full of outputs had it rest where it was known to.
// Cost: constant. Context: prep.
nck_status_t nck_push_piece(nck_t *nck, const nck_node_t *piece);

// 1 if nck_prep would do nothing, since the path needs more pieces than are known. While the
// operator asks for nothing else, more may be handed over at once. Cost: constant. Context: prep.
int nck_lacks_pieces(nck_t *nck);

// The path that was handed over in pieces ends here; blocks: that it was made of.
// Returns NCK_OK, or NCK_E_STATE as nck_push_piece. Cost: constant. Context: prep.
nck_status_t nck_end_pieces(nck_t *nck, uint32_t blocks);

// Nothing more is there to push for now, and more may come: a plan that begins at rest, or takes
// over within so many periods, takes what is known of the path. By itself nck_prep does so two
// periods ahead, which is soon enough where it is called as long as it says NCK_OK; a caller with a
// budget names the periods that a plan takes to be made, 1 at least. Speeds that hang on pieces not
// known yet are settled without them. Behind NCK_EMPTY.
// Cost: linear in periods. Context: prep.
void nck_hurry(nck_t *nck, uint32_t periods);

// Begin another program where the axes are at rest now. Offsets stay as the last block decoded has
// left them (work systems, G92, tool length, and the tools of T and M6); modes are those of the
// machine again, as behind nck_init; overrides and single block stay; a hold or an abort is over.
// Counts (seg, block, line, s) begin at 0. What an abort has dropped stays dropped. Text can be
// pushed at once; nck_prep says NCK_FULL until the next tick (or nck_take).
// Returns NCK_OK; NCK_E_STATE while the tick still moves, before the end of the program is executed
// (nck_abort drops the rest), and after NCK_E_INTERNAL: there only nck_init begins anew.
// Cost: linear in the capacities. Context: prep; the tick may go on running.
nck_status_t nck_begin(nck_t *nck);

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

// How often nck_set_position has been heard, nck_init counted. Where it is another number behind a
// tick, that tick's setpoint is where the drives stand, and no way for them to go.
// Cost: constant. Context: tick.
uint32_t nck_places(const nck_t *nck);

// Change limits between blocks: of every axis v_max, rapid, a_max and j_max, of the path feed_max,
// a_max, j_max, chord_error and tolerance (what a bare G64 means from the next one on). The rest of
// `machine` must be valid and counts for nothing. They hold for what is pushed afterwards; the path
// comes to rest between. What waits is flushed first: NCK_FULL until it is planned (call nck_prep,
// then again). A change of feed or of tolerance alone needs no rest: see nck_block_in_t.
// Returns NCK_OK, NCK_FULL; NCK_E_MACHINE or NCK_E_UNSUPPORTED as nck_init.
// Cost: constant. Context: prep.
nck_status_t nck_set_limits(nck_t *nck, const nck_machine_t *machine);

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
// NCK_TICK_HOLD from the first cell of the brake on. The brake begins within ten periods: if prep
// has not made its short plan by then, the tick brakes by itself. Cost: constant. Context: any.
void nck_hold(nck_t *nck);

// Hold at the end of every block (1) or no longer (0). Cost: constant. Context: any.
void nck_set_single_block(nck_t *nck, uint32_t on);

// Scale the programmed feeds by 0 … 200 % and the rapids by 0 … 100 %; what is more counts as the
// most. The other limits stay. 0 rests until it is raised again. Cost: constant. Context: any.
void nck_set_override(nck_t *nck, uint32_t feed_percent, uint32_t rapid_percent);

// The same in per mille: feeds 0 … 2000, rapids 0 … 1000. Cost: constant. Context: any.
void nck_set_override_permille(nck_t *nck, uint32_t feed_permille, uint32_t rapid_permille);

// The same in millionths: feeds 0 … 2 000 000, rapids 0 … 1 000 000; for a feed that follows what
// is measured. Cost: constant. Context: any.
void nck_set_override_ppm(nck_t *nck, uint32_t feed_ppm, uint32_t rapid_ppm);

// As fast as the tool may be from now on, in feeds and rapids and whatever the overrides say
// [µm/s]. UINT32_MAX: no such limit, as behind nck_init; 0 rests until it is raised. Moves of
// rotary axes alone do not heed it. Cost: constant. Context: any.
void nck_set_speed(nck_t *nck, uint32_t most_um_s);

// Come to rest as by a hold and drop what has not been executed: nck_prep says NCK_DONE, the tick
// stays in NCK_TICK_HOLD and is idle there. nck_begin goes on from there with another program.
// Cost: constant. Context: any.
void nck_abort(nck_t *nck);

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

// 1 if the tick has nothing left to do: at rest, no WAIT, no cell and no output left.
// Cost: constant. Context: tick.
int nck_is_idle(const nck_t *nck);

// 1 if the tick executes a cell, or has one to take. Cost: constant. Context: tick.
int nck_is_moving(const nck_t *nck);

// Take the next final cell in place of the tick: for planning without executing (machining time,
// pictures). Outputs are handed over as in the tick. Returns NCK_OK or NCK_EMPTY. Cost: constant.
// Context: tick.
nck_status_t nck_take(nck_t *nck, nck_cell_t *cell_out);

// The spindle's angle as measured, for the next tick: in revolutions from any begin on, counting up
// whichever way M3 or M4 has it turn, and down while a tap turns it back. Call it before every
// nck_tick; before the first call the kernel takes the spindle to turn as commanded. Passes of
// threads and taps follow it. Cost: constant. Context: tick.
void nck_set_spindle(nck_t *nck, double turns);

// 1 if a pass of a thread was stopped before its end: by nck_abort; since the axes could not follow
// the spindle's angle, which was 2 ms of its turning beside the tool; or since it hardly turned.
// Then the tick rests in NCK_TICK_HOLD.
// nck_begin forgets it.
// Cost: constant. Context: any.
int nck_is_thread_lost(const nck_t *nck);

// Where the axes are: what the last tick has handed out, before the first one the start. Returns
// the tick's state. Cost: constant. Context: tick; prep while the tick is at rest.
nck_tick_state_t nck_position(const nck_t *nck, nck_pose_t *pose_out, nck_axes_t *axes_out);

// How many joints the machine has, and the axis that drives joint k < nck_joint_count.
// Cost: constant. Context: any.
uint32_t nck_joint_count(const nck_t *nck);
uint32_t nck_joint_axis(const nck_t *nck, uint32_t joint);

// How much is under way. Cost: constant. Context: prep; `cells` from the tick too.
void nck_queue(const nck_t *nck, nck_queue_t *queue_out);

// Final cells that wait for the tick. Cost: constant. Context: any.
uint32_t nck_queue_cells(const nck_t *nck);

// What is in force, and where the program's zero is, as of the last block decoded.
// Cost: constant. Context: prep.
void nck_modal(const nck_t *nck, nck_modal_t *modal_out);

// The machine, with the limits in force. Cost: constant. Context: any.
const nck_machine_t *nck_machine_of(const nck_t *nck);

// The i-th of the pieces of path that are placed and that on_node has not told yet; its caps are
// final, its envelope may not be. NULL: not known yet. Cost: constant. Context: prep.
const nck_node_t *nck_piece(const nck_t *nck, uint32_t i);

// 1 while a plan is made that answers the operator: who asks for something else now, and again and
// again, has it begin anew each time. Cost: constant. Context: prep.
int nck_is_answering(const nck_t *nck);

// What the operator asks for, as of now. Cost: constant. Context: any.
void nck_asked(const nck_t *nck, nck_command_t *command_out);

// Every invariant of the kernel, for tests: 0 if all hold, else a bit (1 << k) for each room k that
// one of them is broken in; bit 0 is the link's. Cost: linear in the capacities. Context: prep,
// while the tick is not within a call.
uint32_t nck_invariants(const nck_t *nck);

// The link, for a planner that fills it in nck_prep's place. Cost: constant. Context: any.
nck_link_t *nck_link_of(nck_t *nck);

#ifdef __cplusplus
}
#endif

#endif
