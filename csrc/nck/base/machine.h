// SPDX-License-Identifier: MIT
// The machine: every number that a program meets but does not contain. Filled by the caller, read
// by all rooms.
#ifndef NCK_BASE_MACHINE_H
#define NCK_BASE_MACHINE_H

#include "nck/base/limits.h"  // NCK_AXIS_MAX NCK_TOOL_MAX
#include "nck/base/records.h" // axis order
#include "nck/base/status.h"  // nck_status_t

enum {
    NCK_WORK_SYSTEMS = 9,         // G54 … G59, G59.1 … G59.3
    NCK_LINEAR_MAX_MM = 1000000,  // furthest position, word and offset of X Y Z U V W
    NCK_ROTARY_MAX_DEG = 1000000, // of A B C
    NCK_COUNTS_PER_MM = 1000000,  // fixed point of X Y Z U V W: 1 nm
    NCK_COUNTS_PER_DEG = 1000000000 // fixed point of A B C: 1 ndeg
};

typedef enum nck_kinematics {
    NCK_KINEMATICS_IDENTITY = 0, // joint k is the machine's axis k, in the order X Y Z A B C U V W
    NCK_KINEMATICS_LATHE_XZ = 1  // joint 0 is X (radius), joint 1 is Z
} nck_kinematics_t;

typedef enum nck_slope_kind {
    NCK_SLOPE_LINEAR = 0, // acceleration-limited
    NCK_SLOPE_JERK = 1,   // jerk-limited, acceleration carried across junctions
    NCK_SLOPE_SSHAPE = 2  // jerk-limited, no acceleration at junctions (classical S-shape)
} nck_slope_kind_t;

typedef enum nck_dialect {
    NCK_DIALECT_LINUXCNC = 0, NCK_DIALECT_FANUC = 1, NCK_DIALECT_GRBL = 2, NCK_DIALECT_MARLIN = 3
} nck_dialect_t;

typedef struct nck_axis {
    uint8_t present;  // 1: the machine has this axis
    uint8_t rotary;   // 1: degrees
    uint8_t reserved[6];
    double v_max;     // [mm/s, deg/s] > 0: no setpoint is faster
    double rapid;     // [mm/s, deg/s] > 0, ≤ v_max: G0
    double a_max;     // [mm/s², deg/s²] > 0
    double j_max;     // [mm/s³, deg/s³] > 0 (reported by the linear slope, not limited)
    int64_t min_nm;   // travel [nm, ndeg]; INT64_MIN: free
    int64_t max_nm;   // travel; INT64_MAX: free
} nck_axis_t;

typedef struct nck_tool {
    uint32_t number;      // T and H name it
    uint32_t orientation; // lathe: 0..9
    int64_t offset_nm[3]; // X Y Z (mill: Z = length) [nm]
    double radius_mm;
} nck_tool_t;

typedef struct nck_machine {
    double period_s;         // T, interpolation period, 1e-5 … 0.1
    nck_axis_t axis[NCK_AXIS_MAX];

    struct {
        double feed_max;     // [mm/s] > 0
        double a_max;        // tangential [mm/s²] > 0
        double j_max;        // tangential [mm/s³] > 0
        double chord_error;  // [mm] > 0: chord cap on arcs
        double tolerance;    // [mm] ≥ 0: what a bare G64 means
        double arc_radius;   // [mm] > 0: how far an arc's end may miss its circle
    } path;
    uint32_t lookahead_blocks; // blocks in the window, the one in work among them, 2 … NCK_WINDOW
                             // (NCK_SLOPE_SSHAPE: from 1 on); 0: all of it
    uint32_t slope;          // nck_slope_kind_t
    uint32_t kinematics;     // nck_kinematics_t

    struct {
        uint32_t base;       // nck_dialect_t
        uint8_t diameter;    // 1: X words are diameters at start (G7)
        uint8_t inch;        // 1: G20 at start
        uint8_t plane;       // 17, 18, 19 at start
        uint8_t arc_absolute;// 1: G90.1 at start
        uint8_t block_skip;  // 1: lines that begin with / are skipped
        uint8_t optional_stop; // 1: M1 stops
        uint8_t reserved[6];
        double feed_default; // [mm/min] in force before the first F; 0: none
    } dialect;

    struct {
        double rpm_max;      // 0: no check
    } spindle;

    int64_t start_nm[NCK_AXIS_MAX];               // position at start, after homing
    int64_t home_nm[2][NCK_AXIS_MAX];             // G28, G30
    int64_t work_nm[NCK_WORK_SYSTEMS][NCK_AXIS_MAX]; // G54 … G59.3
    uint32_t work_system;                         // in force at start, 0 = G54
    uint32_t tool_count;
    nck_tool_t tool[NCK_TOOL_MAX];
} nck_machine_t;

// Fill in a machine that is safe and complete: three axes X Y Z of 100 mm/s, 1000 mm/s², 10 000
// mm/s³ and free travel, T = 1 ms, linear slope. The caller changes what differs.
// Cost: constant. Context: any, before nck_init.
void nck_machine_default(nck_machine_t *machine);

// Counts of fixed point in one unit of the axis: NCK_COUNTS_PER_MM, NCK_COUNTS_PER_DEG if rotary.
// Up to the furthest position, a count divided by it, times it and rounded is the count again.
// Cost: constant. Context: any.
double nck_machine_counts(const nck_machine_t *machine, int axis);

// Check every number. Returns NCK_OK, or NCK_E_MACHINE at the first that is outside of its range
// (NaN and infinity included; travel may be free). Cost: constant. Context: any.
nck_status_t nck_machine_check(const nck_machine_t *machine);

#endif
