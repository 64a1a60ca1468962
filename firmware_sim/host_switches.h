// SPDX-License-Identifier: MIT
// A machine's switches on the host: they close where the real axes are, which only homing knows,
// and bounce; a plate for the probe; wires that break.
#ifndef HOST_SWITCHES_H
#define HOST_SWITCHES_H

#include "hal/input.h" // hal_input_t
#include "nck/nck_session.h" // nck_t

// All of it. Change what differs behind host_switches_init.
typedef struct host_switches {
    uint32_t wired;              // bit k: axis k has a switch, for home and limit
    uint32_t homes_only;         // bit k: … for home alone
    uint32_t far;                // bit k: axis k has a limit switch at its other end
    uint32_t least;              // bit k: it closes below its place, else above
    int64_t place_nm[NCK_AXIS_MAX]; // of the switch, of the real axis
    int64_t far_nm[NCK_AXIS_MAX];   // of the one at the other end
    uint32_t pair;               // the axis that two motors drive, + 1; 0: none
    int64_t second_nm;           // of the switch of its second motor
    int64_t plate_nm;            // the probe touches at this Z and below
    uint32_t bounce;             // ticks for which a switch that changes reads at random
    uint32_t broken;             // inputs whose wire is broken
    uint32_t pushed;             // inputs that somebody holds: door, emergency stop, ports
    double rpm_tick;             // by which the spindle's speed can change in a tick; 0: at once
    double rpm_wanted, rpm;      // of it: commanded, and as it turns; M4 is below 0
    uint64_t seed;
    uint32_t closed;             // as they are, without bounce
    uint32_t since[32];          // ticks that an input has not changed
    uint32_t places;             // nck_places behind the last tick
    int64_t real_nm[NCK_AXIS_MAX]; // where the axes are; of a pair the first motor
    int64_t mate_nm;             // and the second one
    int64_t told_nm[NCK_AXIS_MAX]; // and their setpoints
} host_switches_t;

// No switches; the real axes are where the kernel believes them. Cost: constant. Context: any.
void host_switches_init(host_switches_t *self, const nck_t *nck);

// The spindle turns a tick towards what is wanted. Cost: constant. Context: tick.
void host_switches_turn(host_switches_t *self, double wanted);

// What the inputs read. Once a tick. Cost: linear in the inputs. Context: tick, before nck_tick.
uint32_t host_switches_read(host_switches_t *self);

// The axes go where the tick has told, but for motors of the pair that are held (inputs_t). Cost:
// linear in the axes. Context: tick.
void host_switches_move(host_switches_t *self, const nck_t *nck, const nck_axes_t *axes,
                        uint32_t held);

#endif
