// SPDX-License-Identifier: MIT
// What drives with a position loop want each period, as CiA 402's cyclic synchronous position has
// it: a place, a speed and a torque, in the drive's own counts; and whether they follow.
//
//     1 ms interrupt:   nck_tick(&nck, &pose, &axes);
//                       drive_period(&drive, &axes, nck_places(&nck), target);
//                       faults = drive_follow(&drive, actual);   // behind the bus cycle
//
// The place is the setpoint of the period before, so that speed and acceleration are differences
// about it, and none of a future that is not planned. What is told to stand elsewhere moves
// nothing: another number of nck_places. No operating system, no heap, no fieldbus.
#ifndef DRIVE_H
#define DRIVE_H

#include "nck/base/limits.h"  // NCK_AXIS_MAX
#include "nck/base/records.h" // nck_axes_t

// Sizes.
enum {
    DRIVE_MOTORS = NCK_AXIS_MAX + 1, // one axis may have two
    DRIVE_PAST = 3,                  // setpoints that a difference needs
    DRIVE_LAG_MOST = 8               // periods from a target to what is read back of it
};

// A drive. Torque is in thousandths of the rated one, as CiA 402 counts it.
typedef struct drive_motor_set {
    double counts;      // of the joint in a mm or a degree: 10⁶, 10⁹
    double increments;  // of the drive in a mm or a degree; less than 0: it is reversed
    double inertia;     // torque for an acceleration of 1 mm/s², 1 deg/s²
    double viscous;     // … for a speed of 1 mm/s, 1 deg/s
    double friction;    // … for any speed
    double torque_most; // more is never asked for
    double follow_most; // a fault, if it is further off than that [mm, deg] …
    uint32_t periods;   // … for so many periods in a row
    uint32_t lag;       // periods from a target to the place that is read back for it
    uint8_t joint;      // that it follows; two drives may follow one
} drive_motor_set_t;

// All drives.
typedef struct drive_set {
    double period_s;   // of the tick
    uint32_t motors;
    drive_motor_set_t motor[DRIVE_MOTORS];
} drive_set_t;

// One period's numbers, the drive's signs: objects 607Ah, 60B1h, 60B2h.
typedef struct drive_target {
    int32_t position; // [increments], modulo 2³²
    int32_t velocity; // [increments/s]
    int16_t torque;   // [1/1000 of the rated one]
} drive_target_t;

// A drive at work.
typedef struct drive_motor {
    drive_motor_set_t set;
    double scale;              // increments in a count of the joint
    double zero;               // increments: where the joint's zero is
    double past[DRIVE_PAST];   // increments: the last setpoints, the newest first
    int32_t asked[DRIVE_LAG_MOST + 1]; // positions, the newest first
    int32_t error;             // following error [increments]
    uint32_t beyond;           // periods in a row that it is too much
} drive_motor_t;

// All of it: one static instance.
typedef struct drive {
    double period_s;
    uint32_t motors;
    uint32_t places;   // nck_places of the last period
    uint32_t faults;   // bit m: drive m has not followed; until drive_init
    drive_motor_t motor[DRIVE_MOTORS];
} drive_t;

// Begin at rest: the drives stand at `actual` where the axes are. Returns 1; 0 if a number is out
// of range. Cost: linear in the drives. Context: any, before the tick runs.
int drive_init(drive_t *self, const drive_set_t *set, const nck_axes_t *axes, uint32_t places,
               const int32_t *actual);

// The next period's numbers, one of each drive. Cost: linear in the drives. Context: tick, once a
// period.
void drive_period(drive_t *self, const nck_axes_t *axes, uint32_t places,
                  drive_target_t *target_out);

// What the drives say of where they are [increments], one of each. Returns the faults so far: make
// safe, and stop (nck_stop_at). Cost: linear in the drives. Context: tick, behind drive_period.
uint32_t drive_follow(drive_t *self, const int32_t *actual);

#endif
