// SPDX-License-Identifier: MIT
// The simulation on the host: prep steps and interpolation ticks interleaved in virtual
// time. The same run gives the same bytes; nobody reads a clock.
#ifndef SIM_H
#define SIM_H

#include <stddef.h> // size_t

#include "nck/nck_tools.h" // nck_t and all records

// One row per tick.
typedef struct sim_row {
    double t_s;            // tick number × period, the first tick being number 1
    nck_pose_t pose;
    nck_axes_t axes;
    double spindle_rpm;    // last S word handed over; under G96 what it means at this tick
    double spindle_turns;  // angle of a measured spindle [revolutions]
    uint32_t queue_cells;  // final cells waiting
    uint16_t feed_percent; // override in force
    uint16_t rapid_percent;
} sim_row_t;

// A spindle that is measured: it follows its command late, and turns unevenly.
typedef struct sim_spindle {
    double late_s;         // time constant of its speed [s]; 0: it follows at once
    double ripple;         // share by which its speed swells and falls
    double ripple_turns;   // over so many revolutions
    double rpm;            // without the ripple
    double turns;          // angle [revolutions]
    uint32_t on;           // 1: there is one
} sim_spindle_t;

// What the operator can do.
typedef enum sim_command_kind {
    SIM_HOLD = 0,
    SIM_RESUME = 1,
    SIM_OVERRIDE = 2,      // value: feed [%], rapids [%]
    SIM_SINGLE_BLOCK = 3,  // value: 1 on, 0 off
    SIM_ABORT = 4
} sim_command_kind_t;

// One command of the operator.
typedef struct sim_command {
    uint64_t tick;         // given behind the setpoint of this tick; 0: before the first
    uint32_t kind;         // sim_command_kind_t
    uint32_t value[2];     // see sim_command_kind_t, else 0
    uint32_t reserved;     // 0
} sim_command_t;

// How a run ends.
typedef enum sim_end {
    SIM_END_NOT = 0,
    SIM_END_DONE = 1,         // all is executed, or all before a program error
    SIM_END_HOLD = 2,         // at rest in a hold that no command ends
    SIM_END_SINGLE_BLOCK = 3, // at rest at the end of a block, and no command goes on
    SIM_END_OVERRIDE = 4,     // at rest under an override of 0 that no command raises
    SIM_END_ABORTED = 5,
    SIM_END_STALLED = 6       // neither prep nor the tick goes on: a defect
} sim_end_t;

// The simulation.
typedef struct sim {
    nck_t *nck;
    nck_status_t (*prep)(void *user); // one step of the prep task, as nck_prep
    void *prep_user;       // handed to it; the nck unless sim_prepare_by says otherwise
    const char *text;      // the whole program, fed as fast as the kernel takes it
    size_t text_size, text_used;
    uint32_t begun;           // 1: the kernel has its text, or will be given it piece by piece
    uint32_t reads;           // 1: the kernel reads the text itself
    uint32_t is_blocks;    // 1: the text is rows of nck_block_in_t
    const sim_command_t *commands; // of the operator, in the order of their ticks
    size_t command_count, command_next;
    uint32_t prep_steps;   // prep steps between two ticks, ≥ 1; few of them starve the tick
    uint32_t prefilled;    // 1: prep has run until it had to wait, ticks have begun
    int32_t prep_status;   // last of nck_prep
    uint32_t end;          // sim_end_t
    uint32_t rest_ticks;   // at rest, with nothing to prepare or to wait for, so far
    uint32_t resumed;      // 1: the operator has gone on since the path last moved
    uint32_t steps;        // of prep since the run last got on, those that wait not counted
    uint64_t progress;     // changes as long as it gets on
    uint16_t feed_percent, rapid_percent; // override in force
    int32_t error;         // of the program: returned when all before it is executed; NCK_OK
    uint64_t ticks;        // so far
    uint64_t starved_ticks;
    uint64_t outputs;      // handed over so far
    double spindle_rpm;    // last S word handed over; under G96 what it means now
    uint32_t spindle_follows; // 1: G96
    sim_spindle_t spindle; // set it behind sim_init
} sim_t;

// Set up a run. The kernel is initialised here (hooks are the simulation's); the text must outlive
// the run. prep_steps ≥ 1.
// Returns as nck_init, or NCK_E_ARGUMENT. Cost: constant. Context: any.
nck_status_t sim_init(sim_t *sim, nck_t *nck, const nck_machine_t *machine, const char *text,
                      size_t n, uint32_t prep_steps);

// Let something else than nck_prep fill nck's link: the same statuses, no text. Call it right
// after sim_init. Cost: constant. Context: any.
void sim_prepare_by(sim_t *sim, nck_status_t (*prep)(void *user), void *user);

// What was given as text is rows of nck_block_in_t, each valid. Call it right after sim_init.
// Cost: constant. Context: any.
void sim_feed_blocks(sim_t *sim);

// Let the operator give commands, ordered by tick; the array must outlive the run. Call it right
// after sim_init. Cost: constant. Context: any.
void sim_operate(sim_t *sim, const sim_command_t *commands, size_t count);

// Run until row_max rows are filled (*row_count_out) or the run is over; sim->end says how. M0, M1,
// M6 are resumed at the next tick, a hold in force stays. A run has the ticks that its plan counts:
// one in which nothing but outputs is left is none of them. (A controller has that period too.)
// Returns NCK_OK (call again), NCK_DONE, or the program error after everything before it has been
// executed, or NCK_E_INTERNAL if neither prep nor the tick goes on.
// Cost: linear in the rows and in the text. Context: prep and tick both.
nck_status_t sim_run(sim_t *sim, sim_row_t *rows, size_t row_max, size_t *row_count_out);

#endif
