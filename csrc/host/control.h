// SPDX-License-Identifier: MIT
// How long a program takes on another control: its own planner's rules, in passes over v².
//
//     blocks ─▶ lines of the control ─▶ caps at corners ─▶ look-ahead ─▶ trapezoids ─▶ sums, causes
//               chords, whole steps                        ring or all
//
// None of these controls limits jerk. Rules and sources: docs/controls.md. Everything is streamed:
// the caller owns the array of lines that are planned together.
#ifndef NCK_HOST_CONTROL_H
#define NCK_HOST_CONTROL_H

#include <stddef.h> // size_t

#include "host/cause.h" // nck_host_cause_t nck_host_low_t
#include "host/course.h" // nck_host_course_t
#include "host/host.h"  // nck_host_totals_t and all records
#include "host/share.h" // nck_host_shares_t
#include "host/trail.h" // nck_host_point_t nck_host_foot_t

#ifdef __cplusplus
extern "C" {
#endif

// Whose rules.
typedef enum nck_host_control_kind {
    NCK_HOST_CONTROL_KLIPPER = 1, // one acceleration along the path, square corner velocity
    NCK_HOST_CONTROL_GRBL = 2,    // grbl, grblHAL, FluidNC: junction deviation
    NCK_HOST_CONTROL_MARLIN = 3,  // junction deviation with small segments, or classic jerk
    NCK_HOST_CONTROL_LINUXCNC = 4 // trapezoid to trapezoid, blended
} nck_host_control_kind_t;

enum { NCK_HOST_CONTROL_CHAIN = 101 }; // lines that LinuxCNC makes one of at most

// Settings that are numbers, by their place in nck_host_control_rule_t. The first four are one for
// each axis; the extruder is U.
typedef enum nck_host_control_value {
    NCK_CONTROL_V = 0,                         // highest speed [mm/s]
    NCK_CONTROL_A = NCK_AXIS_MAX,              // highest acceleration [mm/s²]
    NCK_CONTROL_JERK = 2 * NCK_AXIS_MAX,       // Marlin's: step of speed that is allowed [mm/s]
    NCK_CONTROL_STEPS = 3 * NCK_AXIS_MAX,      // [1/mm]; 0: positions are not rounded
    NCK_CONTROL_V_PATH = 4 * NCK_AXIS_MAX,     // highest speed along the path [mm/s]
    NCK_CONTROL_A_PATH,        // acceleration along the path; Marlin: of moves that extrude
    NCK_CONTROL_A_TRAVEL,      // Marlin: of moves that do not extrude [mm/s²]
    NCK_CONTROL_A_RETRACT,     // Marlin: of filament alone [mm/s²]
    NCK_CONTROL_DEVIATION,     // junction deviation [mm]
    NCK_CONTROL_CORNER,        // Klipper: square corner velocity [mm/s]
    NCK_CONTROL_CRUISE_RATIO,  // Klipper: minimum cruise ratio, 0 … 1
    NCK_CONTROL_CORNER_E,      // Klipper: instantaneous corner velocity of the extruder [mm/s]
    NCK_CONTROL_V_EXTRUDE,     // Klipper: filament alone, speed [mm/s]
    NCK_CONTROL_A_EXTRUDE,     // Klipper: filament alone, acceleration [mm/s²]
    NCK_CONTROL_CHORD,         // of arcs: grbl's tolerance, the others' length [mm]
    NCK_CONTROL_SEGMENT_S,     // Marlin: shorter lines are slower while its ring fills [s]
    NCK_CONTROL_PERIOD_S,      // LinuxCNC: of its servo [s]
    NCK_CONTROL_BARE,          // LinuxCNC: a block's tolerance that stands for G64 without P
                               // [mm]; 0: none does
    NCK_CONTROL_VALUES
} nck_host_control_value_t;

// All settings of a control.
typedef struct nck_host_control_rule {
    uint32_t kind;             // nck_host_control_kind_t
    uint32_t ahead;            // lines that are planned together, the one in work among them; 0:
                               // all that there are
    uint32_t laser;            // grbl: 1: an S on a move is no rest
    uint32_t classic;          // Marlin: 1: classic jerk, no junction deviation
    double value[NCK_CONTROL_VALUES];
} nck_host_control_rule_t;

// A setting that a line of the program changes.
typedef struct nck_host_control_change {
    uint32_t line;             // from this source line on
    uint32_t value;            // nck_host_control_value_t
    double to;
} nck_host_control_change_t;

// A line as the control has it.
typedef struct nck_host_control_line {
    double unit[NCK_AXIS_MAX]; // direction
    double length;             // [mm]
    double a;                  // [mm/s²]
    double v_wanted;           // as programmed [mm/s]
    double v;                  // that its limits leave of it [mm/s]
    double steps;              // that its first axis makes; 0: nobody asks
    double tolerance;          // LinuxCNC: of G64 P [mm]; 0: the exact path; by length without P
    double cap;                // at its start by the corner, v²
    double gain;               // 2 a L: what v² gains at most
    double smooth_cap, smooth_gain; // Klipper: the same under the minimum cruise ratio
    double reach;              // Klipper: cap of all before it, too, v²
    double start, cruise;      // Klipper: planned, v²
    double bend;               // Klipper: δ a, by the limits that held as it came [mm²/s²]
    double angle;              // of the corner at its start [rad]
    double out[3];             // LinuxCNC: direction of the tool at its end
    double end[NCK_AXIS_MAX];  // where it ends [mm, deg]
    double along[3], inward[3]; // LinuxCNC: of a bend at its start: the part of unit that turns,
                               // and where to it turns, as long
    double turn;               // LinuxCNC: by which it turns [rad]; 0: it is straight
    double spindle_rpm;        // in force
    double s;                  // of its end, along the program [path mm]; nobody asks: 0
    double whole;              // LinuxCNC: length before blends [mm]
    double keeps;              // LinuxCNC: share of a that its kinks leave
    uint32_t number;           // running number of its block
    uint32_t line;             // source line
    uint32_t tool;             // in the spindle
    uint8_t limit;             // nck_limit_t that holds v
    uint8_t limit_cap;         // nck_limit_t that holds cap
    uint8_t rapid;             // 1: G0
    uint8_t lone;              // 1: filament alone
    uint8_t round;             // 1: LinuxCNC: an arc
    uint8_t bare;              // 1: LinuxCNC: under G64 without P
    uint8_t stops;             // 1: LinuxCNC: G61.1, G9: an exact stop at its end
    uint8_t arc;               // 1: of an arc of the program
} nck_host_control_line_t;

// Time lost, and all time, by one low point.
typedef struct nck_host_control_ramp {
    double lost_s, time_s;
} nck_host_control_ramp_t;

// Lines of LinuxCNC that its naive CAM may make one of.
typedef struct nck_host_control_chain {
    double points[NCK_HOST_CONTROL_CHAIN][3]; // their ends [mm]
    double feed;               // of all of them
    nck_host_control_line_t word; // of the last one
    uint32_t count;
    uint32_t reserved;
} nck_host_control_chain_t;

// A straight stretch of constant acceleration, or a rest: where it ends, and what is told of it.
typedef struct nck_host_control_stretch {
    nck_host_point_t end;
    double uvw[3];             // of the other linear axes there [mm]
    double duration;           // [s]
    double v_begin;            // [mm/s]; end.v is the speed at its end
    double spindle_rpm;        // in force
    double s;                  // of its end, along the program [path mm]
    uint32_t block;            // running number
    uint32_t kind;             // nck_seg_kind_t: line, of an arc, dwell
} nck_host_control_stretch_t;

// All stretches in order, and the low points between them. Rows belong to the caller; NULL: nobody
// asks.
typedef struct nck_host_control_trace {
    nck_host_control_stretch_t *stretches; size_t stretch_max, stretch_count; // rows of this call
    nck_host_foot_t *feet; size_t foot_count; // as many rows; first and at count stretches
    uint64_t before;           // stretches of the calls before
    uint64_t fastest;          // stretches up to the fastest place since the last low point
    nck_host_foot_t foot;      // the last low point
    nck_host_sum_t t;          // so far [s]
    double place[NCK_AXIS_MAX]; // where the path has come to [mm, deg]
    double v;                  // how fast it is there [mm/s]
    double s;                  // along the program [path mm]
    nck_host_course_t course;  // the program as it comes
    nck_host_move_t move;      // the move that has come last
} nck_host_control_trace_t;

// A plan under way.
typedef struct nck_host_control {
    nck_host_control_rule_t rule;
    const nck_host_control_change_t *changes; // by growing line
    size_t change_count, change_used;
    nck_host_control_line_t *lines; // planned together; the caller's
    size_t line_max, line_begin, line_end;
    double place[NCK_AXIS_MAX];  // where the last line ended, whole steps [mm]
    double target[NCK_AXIS_MAX]; // where the program is [mm]
    double vv;                 // at the start of the first line that waits, v²
    uint32_t at_rest;          // 1: that line begins at a rest
    nck_host_control_line_t last; // the last line that came
    uint32_t has_last;         // 1: no rest since
    uint32_t queued;           // lines since the last rest
    uint32_t block;            // running number
    uint32_t spins, cools;     // M3 to M5, M7 to M9 in force
    double speed;              // S in force
    nck_host_control_chain_t chain;
    nck_host_control_line_t held; // LinuxCNC: waits for the blend at its end
    uint32_t has_held;
    uint32_t speed_line;       // of an S that waits for what its line does besides; 0: none
    // what it comes to
    nck_host_totals_t totals;
    nck_host_sum_t cut_s, rapid_s, dwell_s; // at the programmed speeds
    nck_host_sum_t time_s;
    nck_host_cause_t causes[NCK_HOST_CAUSES];
    nck_host_shares_t shares;  // may be asked for at the start
    nck_host_low_t low;        // the last low point
    nck_host_control_ramp_t fall; // down from the fastest place behind it
    uint32_t is_begun;         // 1: there is a low point
    nck_host_control_trace_t trace; // may be asked for at the start
} nck_host_control_t;

// Begin. rule is copied; changes and lines must stay. line_max: 2 × ahead at least, and 1024.
// Returns NCK_OK, or NCK_E_ARGUMENT (kind, line_max, a number that is NaN, negative or infinite).
// Cost: constant. Context: any.
nck_status_t nck_host_control_init(nck_host_control_t *self, const nck_host_control_rule_t *rule,
                                   const nck_machine_t *machine);

// The next blocks of the program, as nck_host_decode gives them. Returns how many it has taken:
// where stretches are asked for, fewer than count if the rows that are left have no room for the
// next one. The counts of rows start from 0 at every call. Cost: linear in the blocks and their
// chords, times the lines that are planned together. Context: any.
size_t nck_host_control_take(nck_host_control_t *self, const nck_block_t *blocks, size_t count);

// Rows of stretches that the next block may need; NULL: that the end may. Cost: constant.
// Context: any.
size_t nck_host_control_room(const nck_host_control_t *self, const nck_block_t *next);

// The program has ended: sums and causes are complete, and the last stretches are in their rows, of
// which the counts start from 0. Cost: linear in what waits. Context: any.
void nck_host_control_end(nck_host_control_t *self);

#ifdef __cplusplus
}
#endif

#endif
