// SPDX-License-Identifier: MIT
// The machine: every number that a program meets but does not contain. Filled by the caller, read
// by all rooms.
#ifndef NCK_BASE_MACHINE_H
#define NCK_BASE_MACHINE_H

#include "nck/base/limits.h"  // NCK_AXIS_MAX NCK_TOOL_MAX
#include "nck/base/records.h" // axis order
#include "nck/base/sized.h"   // NCK_SIZED
#include "nck/base/status.h"  // nck_status_t

#ifdef __cplusplus
extern "C" {
#endif

// Counts and ranges that are no machine's to choose.
enum {
    NCK_WORK_SYSTEMS = 9,         // G54 … G59, G59.1 … G59.3
    NCK_WORK_MOST = 300,          // Fanuc's G54.1 P1 … P300
    NCK_LINEAR_MAX_MM = 1000000,  // furthest position, word and offset of X Y Z U V W
    NCK_ROTARY_MAX_DEG = 1000000, // of A B C
    NCK_COUNTS_PER_MM = 1000000,  // fixed point of X Y Z U V W: 1 nm
    NCK_COUNTS_PER_DEG = 1000000000, // fixed point of A B C: 1 ndeg
    NCK_M_MAX = 999,              // largest M code
    NCK_G_MAX = 9999              // largest G code in tenths that a machine may explain
};

// How axes become joints.
typedef enum nck_kinematics {
    NCK_KINEMATICS_IDENTITY = 0, // joint k is the machine's axis k, in the order X Y Z A B C U V W
    NCK_KINEMATICS_LATHE_XZ = 1  // joint 0 is X (radius), joint 1 is Z
} nck_kinematics_t;

// The velocity profile (slope): how speed is built up and taken down.
typedef enum nck_slope_kind {
    NCK_SLOPE_LINEAR = 0, // acceleration-limited
    NCK_SLOPE_JERK = 1,   // jerk-limited, acceleration carried across junctions
    NCK_SLOPE_OPTIMAL = 2 // as NCK_SLOPE_JERK on the exact path; within a tolerance the fastest
                          // motion along the smoothest curve, by convex optimisation (CURVE.md,
                          // OPTIMAL.md). Builds with room for its windows have it
} nck_slope_kind_t;

// How program text is read.
typedef enum nck_dialect {
    NCK_DIALECT_LINUXCNC = 0, NCK_DIALECT_FANUC = 1, NCK_DIALECT_GRBL = 2, NCK_DIALECT_MARLIN = 3,
    NCK_DIALECT_GRBLHAL = 4 // grbl's, with most of LinuxCNC's words
} nck_dialect_t;

// Who speaks so, as bits of a set: dialects; Fanuc is two, since a code of its mills (G70 … G94)
// may mean something else on its lathes.
typedef enum nck_tongue {
    NCK_TONGUE_LINUXCNC = 1,
    NCK_TONGUE_FANUC = 2,   // its mills
    NCK_TONGUE_TURNING = 4, // its lathes
    NCK_TONGUE_GRBL = 8,
    NCK_TONGUE_MARLIN = 16,
    NCK_TONGUES_GRBLHAL = NCK_TONGUE_LINUXCNC | NCK_TONGUE_GRBL
} nck_tongue_t;

// Fanuc's G-code system of a lathe: what G90, G92, G94, G98 and the like mean. Others have none.
typedef enum nck_system {
    NCK_SYSTEM_OPEN = 0, // A, and a note says so
    NCK_SYSTEM_A = 1, NCK_SYSTEM_B = 2, NCK_SYSTEM_C = 3
} nck_system_t;

// What F means before a program says so.
typedef enum nck_feed_start {
    NCK_FEED_START_OPEN = 0,   // per minute; a lathe that speaks Fanuc's language: per revolution,
                               // and a note
    NCK_FEED_START_MINUTE = 1, // G94
    NCK_FEED_START_REV = 2     // G95
} nck_feed_start_t;

// What R of Fanuc's G10 L12 and L13, an offset for D, is.
typedef enum nck_d_offset {
    NCK_D_OPEN = 0, // they are refused
    NCK_D_RADIUS = 1,
    NCK_D_DIAMETER = 2
} nck_d_offset_t;

// How radius compensation begins and ends: what RS274NGC does, or Fanuc's types.
typedef enum nck_comp_start {
    NCK_COMP_START_OPEN = 0, // the dialect's: A of Fanuc's, else RS274NGC's
    NCK_COMP_START_RS274 = 1,
    NCK_COMP_START_A = 2,
    NCK_COMP_START_B = 3
} nck_comp_start_t;

// What Fanuc's lengths, angles and dwells without a point count.
typedef enum nck_integers {
    NCK_INTEGERS_OPEN = 0,      // units, and a note says so
    NCK_INTEGERS_UNITS = 1,     // mm, inches, degrees, seconds, as with a point
    NCK_INTEGERS_INCREMENTS = 2 // least increments (IS-B): 0.001 mm, ° or s, 0.0001 inch
} nck_integers_t;

// What a machine is measured in; each has one range (nck_machine_range).
typedef enum nck_quantity {
    NCK_QUANTITY_PERIOD = 0,       // [s]
    NCK_QUANTITY_SPEED = 1,        // [mm/s, deg/s]
    NCK_QUANTITY_ACCELERATION = 2, // [mm/s², deg/s²]
    NCK_QUANTITY_JERK = 3,         // [mm/s³, deg/s³]
    NCK_QUANTITY_ERROR = 4,        // [mm] how far something may miss
    NCK_QUANTITY_SIZE = 5,         // [mm] 0: none
    NCK_QUANTITY_FEED = 6,         // [mm/min] 0: none
    NCK_QUANTITY_ROTATION = 7,     // [rpm] 0: none
    NCK_QUANTITIES = 8
} nck_quantity_t;

// What a straight probe (G38.2 … G38.5) meets where it is simulated: everywhere but in a session.
typedef enum nck_probe {
    NCK_PROBE_REFUSED = 0, // probing is refused
    NCK_PROBE_MISSES = 1,  // nothing, on all of its way
    NCK_PROBE_TOUCHES = 2  // something where it ends
} nck_probe_t;

// Whose firmware a printer has: what G90 and G91 say of E, among other things.
typedef enum nck_firmware {
    NCK_FIRMWARE_MARLIN = 0,  // E counts as they say, until M82 or M83
    NCK_FIRMWARE_KLIPPER = 1, // in steps behind G91 or behind M83
    NCK_FIRMWARE_REPRAP = 2   // they say nothing of it
} nck_firmware_t;

// What a quantity may be.
typedef struct nck_range {
    double low;  // the least that is good
    double high; // the most
} nck_range_t;

// One axis. Capitals name the quantity whose range holds.
typedef struct nck_axis {
    uint8_t present;  // 1: the machine has this axis
    uint8_t rotary;   // 1: degrees
    uint8_t reserved[6];
    double v_max;     // SPEED: no setpoint is faster
    double rapid;     // SPEED, ≤ v_max: G0
    double a_max;     // ACCELERATION
    double j_max;     // JERK (reported by the linear slope, not limited)
    int64_t min_nm;   // travel [nm, ndeg]; INT64_MIN: free
    int64_t max_nm;   // travel; INT64_MAX: free
} nck_axis_t;

// One tool of the table.
typedef struct nck_tool {
    uint32_t number;      // T and H name it
    uint32_t orientation; // lathe: 0..9
    int64_t offset_nm[3]; // X Y Z (mill: Z = length) [nm]
    double radius_mm;     // SIZE
    double wear_mm;       // of the radius: added to it; its magnitude is a SIZE
} nck_tool_t;

// An M code that the machine has beside those of the language. It is handed over as an output.
typedef struct nck_own_m {
    uint16_t code;       // 0 … NCK_M_MAX; a code that the kernel executes itself stays the kernel's
    uint8_t waits;       // 1: the program waits there until nck_resume, as at M0
    uint8_t stays;       // 1: what it does stays: a program that begins behind it does it, too
} nck_own_m_t;

// What a G code means to the machine that only chooses how a control smooths or looks ahead.
typedef enum nck_g_action {
    NCK_G_NOTE = 0,     // nothing, and a note says so
    NCK_G_IGNORE = 1,   // nothing
    NCK_G_TOLERANCE = 2 // the tolerance of a path that no P says one of
} nck_g_action_t;

// A G code that chooses a mode of the control's (G5.1 Q1), or that the language does not have.
typedef struct nck_own_g {
    double tolerance;    // SIZE: of NCK_G_TOLERANCE
    uint32_t value;      // of its letter's word
    uint16_t code;       // in tenths: 5.1 is 51; up to NCK_G_MAX
    uint8_t letter;      // P or Q: counts with that word alone; 0: whatever stands beside it
    uint8_t action;      // nck_g_action_t
} nck_own_g_t;

// The zero of a work system behind G59.3: G54.1 P1 …
typedef struct nck_work_more {
    int64_t zero_nm[NCK_AXIS_MAX];
    uint32_t number;     // 1 … NCK_WORK_MOST
    uint32_t reserved;
} nck_work_more_t;

// What the machine's clocks say: Fanuc's #3011, #3012, #3001, #3002.
typedef struct nck_wall_clock {
    uint32_t date;  // as 20301231; 0: nobody has said it
    uint32_t time;  // as 235959
    uint32_t on_ms; // since it was switched on
    uint32_t cut_s; // that it has cut
} nck_wall_clock_t;

// Numbers name their quantity in capitals.
typedef struct nck_machine {
    double period_s;         // PERIOD: T, interpolation period
    nck_axis_t axis[NCK_AXIS_MAX];

    struct {
        double feed_max;     // SPEED
        double a_max;        // ACCELERATION, tangential
        double j_max;        // JERK, tangential
        double chord_error;  // ERROR: chord cap on arcs
        double tolerance;    // SIZE: what a bare G64 means
        double arc_radius;   // ERROR: how far an arc's end may miss its circle
    } path;
    uint32_t lookahead_blocks; // blocks in the window, the one in work among them, 2 … NCK_WINDOW;
                             // 0: all of it
    uint32_t slope;          // nck_slope_kind_t
    uint32_t kinematics;     // nck_kinematics_t
    uint8_t roams;           // 1: nothing is held against the travel
    uint8_t firmware;        // nck_firmware_t, of a printer
    uint16_t spindle_waits;  // 1: M3, M4 and another S while it turns are waited at, as M0 is

    struct {
        uint32_t base;       // nck_dialect_t
        uint8_t diameter;    // 1: X words are diameters at start (G7)
        uint8_t inch;        // 1: G20 at start
        uint8_t plane;       // 17, 18, 19 at start
        uint8_t arc_absolute;// 1: G90.1 at start
        uint8_t block_skip;  // 1: lines that begin with / are skipped, whatever its number
        uint8_t optional_stop; // 1: M1 stops
        uint8_t system;      // nck_system_t
        uint8_t feed;        // nck_feed_start_t
        uint8_t d_offset;    // nck_d_offset_t
        uint8_t probe;       // nck_probe_t
        uint8_t integers;    // nck_integers_t
        uint8_t comp_start;  // nck_comp_start_t
        uint32_t skip_switches; // bit k: lines that begin with /k are skipped; a / alone is /1
        uint32_t from_line;  // where programs begin: what stands before is not done; 0: all is
        double feed_default; // FEED: in force before the first F
        double scale_unit;   // what 1 means where a factor of G51 has no point, 0 … 1; 0: open
        double thread_pull;  // leads that a tool pulls out over where no word says it, 0 … 10
    } dialect;

    struct {
        double rpm_max;      // ROTATION; 0: no check
        double a_max_rpm_s;  // ROTATION, a second: how fast it follows under G96; 0: at once
    } spindle;

    struct {
        int64_t height_nm;   // where its axis clears everything; INT64_MAX: its travel's end
        double feed;         // SPEED: of the way in
        uint32_t axis;       // that leaves the work first and goes in last: 1 + axis; 0: Z, of a
                             // lathe X
    } approach;              // to where a program begins in the middle

    int64_t start_nm[NCK_AXIS_MAX];               // position at start, after homing
    int64_t home_nm[NCK_HOMES][NCK_AXIS_MAX];     // G28, G30 (P2), G30 P3, G30 P4
    int64_t work_nm[NCK_WORK_SYSTEMS][NCK_AXIS_MAX]; // G54 … G59.3
    uint32_t work_system;                         // in force at start, 0 = G54
    uint32_t tool_count;
    nck_tool_t tool[NCK_TOOL_MAX];
    uint32_t home_more;                           // bit 0: home_nm has one of P3, bit 1: of P4
    uint32_t own_m_count;
    nck_own_m_t own_m[NCK_OWN_M_MAX];
    uint32_t own_g_count;
    uint32_t work_more_count;
    nck_own_g_t own_g[NCK_OWN_M_MAX];
    nck_work_more_t work_more[NCK_OWN_M_MAX];
    NCK_IF_VARIABLES(nck_wall_clock_t clock;)
} nck_machine_t;

// For the linker these names have capacities and version in them (sized.h).
#define nck_machine_default NCK_SIZED(nck_machine_default)
#define nck_machine_check NCK_SIZED(nck_machine_check)
#define nck_machine_takes_tool NCK_SIZED(nck_machine_takes_tool)

// Fill in a machine that is safe and complete: three axes X Y Z of 100 mm/s, 1000 mm/s², 10 000
// mm/s³ and free travel, T = 1 ms, tolerance 0.01 mm, a way in of
// 100 mm/min: who sees it go wrong has a second for each 2 mm; the best slope that the build has:
// optimal, jerk or linear. The caller changes what differs.
// Cost: constant. Context: any, before nck_init.
void nck_machine_default(nck_machine_t *machine);

// Counts of fixed point in one unit of the axis: NCK_COUNTS_PER_MM, NCK_COUNTS_PER_DEG if rotary.
// Up to the furthest position, a count divided by it, times it and rounded is the count again.
// Cost: constant. Context: any.
static inline double nck_machine_counts(const nck_machine_t *machine, int axis) {
    return machine->axis[axis].rotary ? NCK_COUNTS_PER_DEG : NCK_COUNTS_PER_MM;
}

// The axis of approach. Cost: constant. Context: any.
unsigned nck_machine_approach_axis(const nck_machine_t *machine);

// The height of approach [nm], as a machine position of its axis; INT64_MAX: nobody says one, and
// the axis' travel is free; INT64_MIN: the machine has no such axis. Cost: constant. Context: any.
int64_t nck_machine_approach_nm(const nck_machine_t *machine);

// The range of a quantity, an nck_quantity_t below NCK_QUANTITIES. Limits stay six decades and more
// from where a formula of the rooms would lose its digits (machine.c).
// Cost: constant. Context: any.
void nck_machine_range(uint32_t quantity, nck_range_t *range_out);

// Check every number. Returns NCK_OK; NCK_E_MACHINE at the first that is outside of its range (NaN
// and infinity included; travel may be free); NCK_E_UNSUPPORTED if all are good and the slope is
// left out of the build (limits.h). Cost: constant. Context: any.
nck_status_t nck_machine_check(const nck_machine_t *machine);

// 1 if a tool's numbers are within their ranges. Cost: constant. Context: any.
int nck_machine_takes_tool(const nck_machine_t *machine, const nck_tool_t *tool);

#ifdef __cplusplus
}
#endif

#endif
