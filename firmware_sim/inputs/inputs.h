// SPDX-License-Identifier: MIT
// The inputs of a machine around one nck_t: what stops it in the very period, and homing.
//
//     inputs_init(&inputs, &nck);             // then change what differs in inputs.set
//     1 ms interrupt:  inputs_tick(&inputs, hal_inputs()); nck_tick(&nck, &pose, &axes)
//     prep:            inputs_home; inputs_step beside nck_prep, as long as it says INPUTS_GOES
//
// It needs a session (nck_begin_session). No operating system, no heap.
#ifndef INPUTS_H
#define INPUTS_H

#include "hal/input.h" // hal_input_t
#include "nck/nck_session.h" // nck_t

// What a machine has. Read by prep; the tick reads inverted alone.
typedef struct inputs_set {
    uint32_t inverted;   // inputs that read 0 where hal_input_t says 1
    uint32_t limits;     // 1: a limit switch stops the axes
    uint32_t homes;      // 1: there is homing
    uint32_t reverse;    // bit k: axis k has its home switch at the least end, else at the most
    uint32_t order;      // axes in the order of homing, four bits each, lowest first: axis + 1
    uint32_t debounce;   // ticks in which a switch does not change, before it is believed open
    uint32_t pair;       // the axis that two motors drive, + 1, the second one's home switch being
                         // HAL_IN_SECOND; 0: none
    double skew;         // by which one of them may go on alone [mm]
    double feed, seek;   // slow and fast approach [mm/min, deg/min]
    double pull_off;     // from the switch [mm, deg]
} inputs_set_t;

// What homing has come to.
typedef enum inputs_result {
    INPUTS_NOT = 0,    // no homing is in work
    INPUTS_GOES = 1,
    INPUTS_DONE = 2,   // the axes stand pull_off in front of their ends
    INPUTS_STUCK = 3,  // a switch has not opened
    INPUTS_MISSED = 4, // no switch was found
    INPUTS_RACKED = 5  // the second switch of a pair was not found
} inputs_result_t;

// A leg of an axis' homing, in their order.
typedef enum inputs_leg {
    INPUTS_CLEAR = 0,  // off a switch that is closed
    INPUTS_SEEK = 1,   // to it, fast
    INPUTS_AGAIN = 2,  // as far once more
    INPUTS_BACK = 3,   // off it
    INPUTS_FURTHER = 4, // … once more: it was seen late, as it bounced
    INPUTS_LOCATE = 5, // to it, slowly
    INPUTS_LEAVE = 6   // to where homing ends
} inputs_leg_t;

// What the program waits for, by the machine's inputs.
typedef enum inputs_wait {
    INPUTS_NOTHING = 0,
    INPUTS_SPEED = 1,
    INPUTS_RISES = 2,  // M66 L1 … L4
    INPUTS_FALLS = 3,
    INPUTS_HIGH = 4,
    INPUTS_LOW = 5
} inputs_wait_t;

// How far a leg is.
typedef enum inputs_phase {
    INPUTS_PLACES = 0, // the axes are told where they stand
    INPUTS_GIVES = 1,  // the move is to be pushed
    INPUTS_MOVES = 2,
    INPUTS_WAITS = 3   // until the switch does not bounce
} inputs_phase_t;

// All of it: one static instance.
typedef struct inputs {
    nck_t *nck;
    inputs_set_t set;
    nck_halt_t halt;       // the last stop

    uint32_t watched;      // inputs that stop when they are 1; prep writes
    uint32_t opened;       // … when they are 0
    uint32_t pins;         // of the last tick, inverted ones turned; the tick writes
    uint32_t steady;       // ticks since one of them changed
    uint32_t tripped;      // inputs that have stopped the axes; prep takes them back at rest

    uint32_t squares;      // 1: the axis of the pair goes to its switches; prep
    uint32_t held;         // bit 0: the pair's first motor stays, at its switch, bit 1: the second;
                           // for pulse_hold; the tick writes
    uint32_t racked;       // 1: one has gone on alone too far; the tick writes
    double alone_from;     // where the other one has come to its switch; tick

    struct {               // what a WAIT of the program is for; tick
        uint32_t kind;     // inputs_wait_t
        uint32_t input;    // of M66
        uint32_t ticks;    // so far
        uint32_t most;     // ticks until M66 gives up
        int32_t answer;    // of the last M66: 1, 0, −1: it did not come; prep reads it
    } wait;

    uint32_t probed;       // 1: the last probe has touched, …
    double probe_at[NCK_AXIS_MAX]; // there, or it has ended there [mm, deg]; prep

    struct {               // prep
        uint8_t result;    // inputs_result_t
        uint8_t leg, phase;
        uint8_t at;        // how many axes are home
        int64_t over_nm;   // by which the axis went on beyond its switch
    } home;
} inputs_t;

// Nothing is inverted, limits and homing are off. Cost: constant. Context: any, before the tick.
void inputs_init(inputs_t *self, nck_t *nck);

// One period: an input that is watched stops the axes now (nck_stop_at). Returns 1 while the
// emergency stop is pushed: then make safe. Cost: constant. Context: tick, before nck_tick.
int inputs_tick(inputs_t *self, uint32_t pins);

// What the program switches is told, as on_output is: the path waits for the spindle's speed where
// the machine does (spindle_waits), and for the input that M66 asks for; ports above 7 read 0, and
// nobody waits for them.
// Cost: constant. Context: tick.
void inputs_output(inputs_t *self, const nck_output_t *output);

// One period of that wait, inputs_tick does it. Cost: constant. Context: tick.
void inputs_wait(inputs_t *self);

// From now on these stop when they close, or open; beside the limits, if those are on.
// Cost: constant. Context: prep.
void inputs_watch(inputs_t *self, uint32_t closing, uint32_t opening);

// The stop is over and understood: go on. Returns NCK_OK; NCK_E_STATE until the axes rest.
// Cost: as nck_go_on's. Context: prep.
nck_status_t inputs_go_on(inputs_t *self);

// Begin to home, with everything at rest. Returns NCK_OK; NCK_E_ARGUMENT where an axis of the order
// is none, has no travel, or five times pull_off do not fit into it. Cost: constant. Context: prep.
nck_status_t inputs_home(inputs_t *self);

// Behind each nck_prep while homing: rests is 1 where all that was pushed is executed and the axes
// stand. Returns inputs_result_t; the last four once. Cost: constant. Context: prep.
inputs_result_t inputs_step(inputs_t *self, int rests);

// End homing: what is under way is stopped by who asks for it. Cost: constant. Context: prep.
void inputs_give_up(inputs_t *self);

#endif
