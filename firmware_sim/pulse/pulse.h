// SPDX-License-Identifier: MIT
// Step and direction from setpoints: one interrupt, so many times a period, says which step lines
// are high. Between two setpoints a motor goes evenly, a period behind the kernel.
//
//     1 ms interrupt:   nck_tick(&nck, &pose, &axes); pulse_period(&pulse, &axes, nck_places(&nck))
//     fast interrupt:   high = pulse_interrupt(&pulse); write pulse.directions, then high
//
// A pulse is as long as the fast interrupt's period, and so is the pause behind it: a motor makes a
// step in every second interrupt at most. No operating system, no heap, no division in the fast
// interrupt. Positions are in parts of a step, 2³¹ of them; what a period leaves undone is in them.
#ifndef PULSE_H
#define PULSE_H

#include "nck/base/limits.h"  // NCK_AXIS_MAX
#include "nck/base/records.h" // nck_axes_t

enum { PULSE_MOTORS = NCK_AXIS_MAX + 1 }; // one axis may have two

// A motor. The direction line is 1 where it goes up, unless it is reversed.
typedef struct pulse_motor_set {
    double steps;          // a mm, or a degree
    double counts;         // of the joint in a mm or a degree: 10⁶, 10⁹
    double backlash;       // lost where it turns round [mm, deg]; 0: none
    double backlash_speed; // by which that is made up for [mm/s, deg/s]
    uint8_t joint;         // that it follows; two motors may follow one
    uint8_t reversed;
} pulse_motor_set_t;

// All motors. Times are rounded up to whole interrupts.
typedef struct pulse_set {
    double period_s;     // of the tick
    double pulse_s;      // the least time that a step line is high, or low
    double setup_s;      // … that a direction line stands before a step
    uint32_t interrupts; // in a period
    uint32_t motors;
    pulse_motor_set_t motor[PULSE_MOTORS];
} pulse_set_t;

// What the fast interrupt adds up for a motor, modulo two steps: where the highest bit changes,
// either way, is a step.
typedef struct pulse_lane {
    uint32_t phase; // parts, half a step ahead
    uint32_t by;    // in an interrupt
} pulse_lane_t;

// A motor at work.
typedef struct pulse_motor {
    double scale;        // parts of a step in a count of the joint
    int64_t zero;        // parts: where the joint's zero is
    int64_t at;          // parts: where it is behind the periods that are planned
    int64_t seen;        // parts: the joint's last setpoint
    int64_t slack;       // parts: made up for of the backlash
    int64_t backlash, slack_most; // parts; the second in a period
    uint8_t joint, reversed, held, down; // down: it went downward last
} pulse_motor_t;

// All of it: one static instance.
typedef struct pulse {
    uint32_t motors, interrupts, setup; // setup: in interrupts
    uint32_t left;       // interrupts of the period; fast interrupt
    uint32_t until;      // … until a motor that turns round sets off
    uint32_t directions; // its lines; fast interrupt
    pulse_lane_t lane[PULSE_MOTORS];

    uint32_t ready;      // 1: a period is planned; the fast interrupt takes it
    uint32_t late;       // periods that came too late, in which nothing moved; fast interrupt
    uint32_t fast;       // 1: a motor was to go faster than it can: make safe
    uint32_t places;     // nck_places of the last period
    uint32_t turned;     // bit m: motor m turns round
    uint32_t next_directions;
    uint32_t next[PULSE_MOTORS]; // by
    pulse_motor_t motor[PULSE_MOTORS];
} pulse_t;

// Begin at rest where the axes are. Returns 1; 0 if a number is out of range, or an interrupt is
// shorter than a pulse. Cost: linear in the motors. Context: any, before the interrupts run.
int pulse_init(pulse_t *self, const pulse_set_t *set, const nck_axes_t *axes, uint32_t places);

// The next period goes to these setpoints. Where the axes were told to stand (another number of
// places) nothing moves by that. Returns 1, or 0 if a motor cannot follow: it is as fast as it can
// be then, and not where it should be. Cost: linear in the motors, a division each. Context: tick,
// once a period.
int pulse_period(pulse_t *self, const nck_axes_t *axes, uint32_t places);

// A motor stays while its joint goes on (1), and goes with it again from there (0): so two motors
// of an axis are squared at two switches. Cost: constant. Context: tick.
void pulse_hold(pulse_t *self, uint32_t motor, uint32_t on);

// One fast interrupt: the step lines that are high from now on; self->directions are to be written
// first. Cost: linear in the motors. Context: the fast interrupt.
uint32_t pulse_interrupt(pulse_t *self);

// What a timer compares with, for a spindle that turns at most_rpm where it is high all of its top.
// Cost: constant. Context: any.
uint32_t pulse_duty(double rpm, double most_rpm, uint32_t top);

#endif
