// SPDX-License-Identifier: MIT
// The records that travel between the rooms, in the order of the flow: block, seg, node, cell,
// pose, axes. Plain data for C, OpenCL and Python alike. Inside: mm (deg for rotary axes), s; path
// units are mm of the path metric: the Euclidean length over all axes, one degree counted as one
// millimetre.
#ifndef NCK_BASE_RECORDS_H
#define NCK_BASE_RECORDS_H

#include "nck/base/limits.h" // NCK_AXIS_MAX

#ifndef __OPENCL_VERSION__
#include <stdint.h> // int64_t uint32_t uint8_t
#else
// OpenCL C has these types by other names.
typedef uchar uint8_t;
typedef ushort uint16_t;
typedef uint uint32_t;
typedef long int64_t;
#endif

// Axes by their place in every array.
enum {
    NCK_AXIS_X = 0, NCK_AXIS_Y, NCK_AXIS_Z, NCK_AXIS_A, NCK_AXIS_B, NCK_AXIS_C,
    NCK_AXIS_U, NCK_AXIS_V, NCK_AXIS_W
};

// What a block asks for.
typedef enum nck_block_kind {
    NCK_BLOCK_RAPID = 0, // G0: straight, as fast as the axes allow
    NCK_BLOCK_LINE = 1,  // G1
    NCK_BLOCK_ARC = 2,   // G2, G3, helix included; straight along every axis outside of the plane
    NCK_BLOCK_DWELL = 3, // G4: stop, wait dwell_s
    NCK_BLOCK_WAIT = 4,  // M0, M1, M6, M60: stop, hand over the output, wait for nck_resume
    NCK_BLOCK_OUTPUT = 5,// S, F-less M, T…: handed over in order, no stop
    NCK_BLOCK_END = 6,   // M2, M30 or end of text: stop
    NCK_BLOCK_COMP = 7,  // G40, G41, G42 for 2_toolcomp, where it ends: output.value is the tool's
                         // radius [mm], + left of the contour, − right of it, 0: off; centre_mm:
                         // from the centre of its nose to its point; output.number: its
                         // nck_comp_start_t, 0: RS274NGC's; feed: of the way to the other side
    NCK_BLOCK_THREAD = 8, // G33, G32, a pass of G76 or G92: straight, with the spindle
    NCK_BLOCK_TAP = 9,   // G33.1, a hole of G84 or G74: with the spindle, from the target and back
    NCK_BLOCK_ENTRY = 10 // a part of the way to where a program begins in the middle, for
                         // 2_toolcomp, where it ends: output.number is its nck_way_t
} nck_block_kind_t;

// The parts of the way in.
typedef enum nck_way {
    NCK_WAY_AWAY = 0,   // one axis, away from the work
    NCK_WAY_ACROSS = 1, // all the others
    NCK_WAY_IN = 2      // that axis again, at a feed
} nck_way_t;

// How the path meets the program.
typedef enum nck_path_mode {
    NCK_PATH_EXACT = 0,     // G61: on the path, junctions crossed by the transfer rule
    NCK_PATH_STOP = 1,      // G61.1, G9: a stop at the end of every move
    NCK_PATH_CONTINUOUS = 2, // G64 P Q: within the tolerance
    NCK_PATH_TURNS = 3 // a cycle's move under G64 P: on the path, a stop where it turns, so that
                       // the axes keep their jerk there, too
} nck_path_mode_t;

// What F means.
typedef enum nck_feed_mode {
    NCK_FEED_PER_MINUTE = 0, // G94: feed in mm/min (deg/min for a move of rotary axes alone)
    NCK_FEED_INVERSE = 1,    // G93: feed in 1/min: the move takes 1/feed minutes
    NCK_FEED_PER_REV = 2     // G95: feed in mm/rev of the commanded spindle speed
} nck_feed_mode_t;

// What an output hands over.
typedef enum nck_output_kind {
    NCK_OUTPUT_SPINDLE_SPEED = 0, // S: value [rpm]
    NCK_OUTPUT_M = 1,             // value = the M code
    NCK_OUTPUT_TOOL = 2,          // T: value = tool number
    NCK_OUTPUT_SURFACE_SPEED = 3, // S under G96: value [mm/min]; the speed follows the position
    NCK_OUTPUT_SETTING = 4,       // M104 S and its kin: number = the M code, value = S
    NCK_OUTPUT_DIGITAL = 5,       // M62 … M65: number = port, value = 1 or 0
    NCK_OUTPUT_ANALOGUE = 6,      // M67, M68: number = port, value
    NCK_OUTPUT_INPUT = 7          // M66: number = port + 100·L, + 1000: an analogue one; value: how
                                  // long to wait for it at most [s]
} nck_output_kind_t;

// What is not motion: travels beside the segs, in order, and reaches the firmware in one callback.
typedef struct nck_output {
    uint32_t after_segs; // fires when this many segs are finished (set by the wires)
    uint32_t line;       // source line
    uint32_t kind;       // nck_output_kind_t
    uint32_t number;     // see nck_output_kind_t
    double value;        // see nck_output_kind_t
} nck_output_t;

// A pass of a thread. Its leading measure is what the lead is told along: the path, or an axis.
typedef NCK_THREAD_STATE nck_thread {
    double length;       // of the pass along that measure [mm]
    double lead;         // along it, a revolution [mm]
    double enter;        // X still goes in by so much [mm], beside the straight way
    double leave;        // X goes out by so much [mm]
    float entry;         // it goes in over this length, or as soon as it can [mm]
    float exit;          // it goes out from so far before the end on [mm]
    float turn;          // angle at which a tool at full speed would start [revolutions], 0 … 1
    float duration;      // of the pass, and half a turn before it [s]
} nck_thread_t;

// A hole that is tapped: in with the spindle, and out as it turns back.
typedef NCK_THREAD_STATE nck_tap {
    double way[3];       // from the start to the bottom, X Y Z [mm]
    double lead;         // along it, a revolution [mm]
    float dwell;         // how long the spindle stands at the bottom [s]
    float duration;      // of all of it, and half a turn before it [s]
} nck_tap_t;

// 1_decode → 2_toolcomp → 3_smooth: one move or one thing to do.
typedef struct nck_block {
    uint32_t line;        // 1-based source line
    uint8_t kind;         // nck_block_kind_t
    uint8_t path_mode;    // nck_path_mode_t
    uint8_t feed_mode;    // nck_feed_mode_t
    uint8_t plane;        // 17, 18, 19 (of an arc)
    uint32_t modes;       // that are in force (in_force.h)
    uint32_t reserved;    // 0
    int64_t target_nm[NCK_AXIS_MAX]; // end point, machine coordinates of the tool tip [nm, ndeg]
    int64_t tool_nm[3];   // tool offset X Y Z in force: 2_toolcomp adds it to the target [nm]
    double centre_mm[2];  // arc: centre along the plane's axes (G17 XY, G18 ZX, G19 YZ),
                          // tip coordinates, already moved onto the chord's bisector
    double sweep_rad;     // arc: signed angle, full turns included, + anticlockwise
    double feed;          // in force, unit by feed_mode; 0 for a rapid but a printer's
    double spindle_rpm;   // in force (for feed per revolution), 0 if stopped; under G96 the most
    double surface;       // surface speed in force [mm/min]; 0: G97
    double spindle_x_mm;  // X of the spindle's axis, where the program's X is 0
    double tolerance_mm;  // G64 P in force, 0: none
    double merge_mm;      // G64 Q in force, 0: none; no room asks, the models of csrc/host do
    double dwell_s;       // NCK_BLOCK_DWELL
    nck_thread_t thread;  // NCK_BLOCK_THREAD
    nck_tap_t tap;        // NCK_BLOCK_TAP
    nck_output_t output;  // NCK_BLOCK_OUTPUT, NCK_BLOCK_WAIT, NCK_BLOCK_END (kind M)
} nck_block_t;

// Where a seg's axes keep to their jerk beside what its own straight ways and arcs ask for; of a
// rest, whether anybody asked for it.
typedef enum nck_keep {
    NCK_KEEP_NOTHING = 0, // exact path: junctions are crossed by the transfer rule
    NCK_KEEP_TURNS = 1,   // of a block of NCK_PATH_TURNS, or of a tolerance too small for a curve
    NCK_KEEP_REST = 2     // a rest of no time that no block asks for: smoothing begins behind it
} nck_keep_t;

// The marks of a seg (marks.h).
typedef NCK_MARK_STATE nck_seg_marks {
    uint32_t from;  // the first of them
    uint32_t count; // so many more lines begin in it
    uint32_t reserved; // 0: a seg has no gaps
} nck_seg_marks;

// The geometry of a seg.
typedef enum nck_seg_kind {
    NCK_SEG_LINE = 0,
    NCK_SEG_ARC = 1,
    NCK_SEG_SPLINE = 2, // an interval of a clocked path, whose s goes by time: cubic of Bernstein
                        // points start, inner[0], inner[1], end
    NCK_SEG_DWELL = 3,  // at rest for dwell_s
    NCK_SEG_WAIT = 4,   // at rest until nck_resume
    NCK_SEG_THREAD = 5, // for planning at rest for its duration: the tick runs it with the spindle
    NCK_SEG_TAP = 6     // the same
} nck_seg_kind_t;

// An arc in the plane of two axes.
typedef struct nck_seg_arc {
    double centre_u;     // along the plane's first axis [mm]
    double centre_v;
    double sweep;        // signed angle, + from u towards v [rad]
    uint8_t axis_u;      // index of the plane's first axis
    uint8_t axis_v;      // and of its second one
    uint8_t reserved[6]; // 0
} nck_seg_arc_t;

// What only some kinds of seg have.
typedef union nck_seg_shape {
    double inner[2][NCK_AXIS_MAX]; // spline: its inner Bernstein points [mm, deg]
    nck_seg_arc_t arc;
    double dwell_s;      // dwell [s]; wait: 0
    nck_thread_t thread; // from start to end
    nck_tap_t tap;       // from start to start
} nck_seg_shape_t;

// How the spindle turns along a seg.
typedef struct nck_spin {
    double speed;        // [rpm]; under G96 surface speed / 2π [mm·rpm]
    double most;         // under G96 the most [rpm]; 0: the speed is constant
    double x;            // of the spindle's axis [mm]
    double per_rev;      // feed per revolution under G96 [path mm/s / rpm]; 0: the feed is constant
} nck_spin_t;

// 3_smooth → 4_lookahead, and by its own ring → 6_interpolate: a piece of path with its geometry.
typedef struct nck_seg {
    uint32_t seq;        // running number, the name of the seg for nodes and cells
    uint32_t line;       // source line where it begins
    uint32_t block;      // running number of the block it came from
    uint8_t kind;        // nck_seg_kind_t
    uint8_t rapid;       // 1: G0
    uint8_t stop;        // 1: exact stop at the end
    uint8_t keeps;       // nck_keep_t
    uint32_t modes;      // in force where it begins (in_force.h); 0: its first mark says them
    nck_seg_marks marks;
    double start[NCK_AXIS_MAX]; // pose at s = 0 [mm, deg]
    double end[NCK_AXIS_MAX];   // pose at s = length [mm, deg]
    double length;       // range of s [path mm]: path length (spline: that of the programmed path
                         // it stands for, never less than its own); 0 for dwell and wait
    double s_begin;      // length of all segs before [path mm], for reports
    double feed;         // wanted path speed [path mm/s]; rapid: 0
    double feed_scale;   // speed that the program means / path speed (1 unless rotary axes join in)
    double v_most;       // as fast as the spindle can follow [path mm/s]; 0: no such limit
    nck_spin_t spin;
    nck_seg_shape_t shape; // by kind; of a line 0
} nck_seg_t;

// Which limit holds the speed. The names of limit_time_s and of the trace column "limit".
typedef enum nck_limit {
    NCK_LIMIT_FEED = 0, NCK_LIMIT_RAPID, NCK_LIMIT_CORNER, NCK_LIMIT_CURVATURE, NCK_LIMIT_CHORD,
    NCK_LIMIT_ACCEL, NCK_LIMIT_JERK, NCK_LIMIT_EXACT_STOP, NCK_LIMIT_DWELL, NCK_LIMIT_WAIT,
    NCK_LIMIT_LOOKAHEAD, NCK_LIMIT_STARVED, NCK_LIMIT_FEED_MAX, NCK_LIMIT_SPINDLE, NCK_LIMIT_THREAD,
    NCK_LIMIT_MODE, // a stop where smoothing begins or ends, as csrc/host tells it
    NCK_LIMIT_AXIS_V = 16 // + axis index
} nck_limit_t;

// What the axes leave a moving piece at standstill: tangential acceleration [mm/s²], jerk [mm/s³].
typedef struct nck_left {
    float a, j;
} nck_left_t;

// That, or how long a rest lasts (length 0) [s].
typedef union nck_standstill {
    double dwell_s;
    nck_left_t left;
} nck_standstill_t;

// 4_lookahead → 5_slope: a point of the path and the piece that follows it.
typedef struct nck_node {
    uint32_t seg;        // seq of the piece's seg
    uint8_t limit;       // nck_limit_t that set vv_cap
    uint8_t limit_piece; // nck_limit_t that set vv_piece
    uint8_t stop;        // 1: the path rests at the piece's end and the tick lands there
    uint8_t last;        // 1: the piece ends its seg
    uint8_t kind;        // nck_seg_kind_t of the seg
    uint8_t open;        // 1: vv was held down by the window's end, not by the path
    uint16_t q_rest;     // least quotient of an axis' jerk and |p″| [mm²/s³]: the
                         // upper half of a float's bits
    float tool;          // speed of the tool / path speed; 0: rotary axes move alone
    double s;            // where in its seg the piece begins [path mm]
    double length;       // of the piece [path mm]
    double a;            // tangential acceleration limit in the piece [mm/s²]
    double a_over;       // the same at a feed override beyond 100 %; ≤ a
    double j;            // tangential jerk limit in the piece [mm/s³]
    double j_over;       // the same at a feed override beyond 100 %; ≤ j
    double feed;         // programmed speed in the piece [path mm/s]; 0: a rapid
    double vv_piece;     // cap inside the piece at an override of 100 % [mm²/s²]
    double vv_over;      // cap inside the piece by everything but the feed; ≥ vv_piece
    nck_standstill_t standstill;
    double vv_cap;       // cap at the node at an override of 100 %, v²
    double vv_node;      // cap at the node by its junction alone, v²; feeds come on top
    double vv;           // envelope at the node, v² (exact two-pass)
} nck_node_t;

// How a cell ends, bit by bit.
typedef enum nck_stop {
    NCK_STOP_REST = 1, // comes to rest at its end, the tick lands there
    NCK_STOP_HOLD = 2, // of a hold: braking for a rest from which only nck_resume goes on
    NCK_STOP_SETS_OFF = 4 // the path does not rest before it, the tool does: the tick's clock
                          // starts from nothing
} nck_stop_t;

// 5_slope ══ring══▶ 6_interpolate: a stretch of constant jerk (0 for the linear slope).
typedef struct nck_cell {
    uint32_t seg;       // seq of the seg that it begins in
    uint8_t limit;      // nck_limit_t
    uint8_t stop;       // of nck_stop_t
    uint8_t last;       // 1: ends the seg that it ends in
    uint8_t span;       // so many segs further on it ends (short segs share a cell)
    double s;           // path coordinate in the seg at t = 0 [path mm]
    double length;      // [path mm]; 0: at rest (dwell, wait)
    double v;           // speed at t = 0 [path mm/s]
    double a;           // acceleration at t = 0 [path mm/s²]
    double j;           // jerk [path mm/s³]
    double duration;    // [s]
} nck_cell_t;

// 6_interpolate → 7_transform: where the tool is at this tick.
typedef struct nck_pose {
    uint32_t seg;        // seq
    uint32_t line;       // source line, 0 before the first seg
    uint32_t block;      // running number of the block
    uint8_t kind;        // nck_seg_kind_t
    uint8_t rapid;       // 1: G0
    uint8_t limit;       // nck_limit_t
    uint8_t state;       // nck_tick_state_t
    double s;            // path coordinate from the program's start [path mm]
    double v;            // path speed [path mm/s]
    double feed;         // commanded path speed [path mm/s]
    double feed_scale;   // as in the seg
    double spindle_rpm;  // commanded speed here; 0: it stands; < 0: on a tap's way back, against
                         // what M3 or M4 said
    double axis[NCK_AXIS_MAX]; // [mm, deg]
} nck_pose_t;

// What a tick finds the path doing.
typedef enum nck_tick_state {
    NCK_TICK_IDLE = 0,    // at rest, nothing to do
    NCK_TICK_MOVE = 1,    // on the path
    NCK_TICK_DWELL = 2,   // G4, and a WAIT that is not the operator's (nck_await)
    NCK_TICK_WAIT = 3,    // M0, M1, M6: until nck_resume
    NCK_TICK_STARVED = 4, // on the stop tail, or at rest in the middle of the path
    NCK_TICK_HOLD = 5     // feed hold, single block or abort: braking, or at rest until nck_resume
} nck_tick_state_t;

// 7_transform → drives: setpoints.
typedef struct nck_axes {
    int64_t joint_nm[NCK_AXIS_MAX]; // [nm, ndeg]
} nck_axes_t;

#endif
