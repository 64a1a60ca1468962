// SPDX-License-Identifier: MIT
// The simulated controller on the host: prep steps and interpolation ticks interleaved in virtual time.
// The same run gives the same bytes; nobody reads a clock.
#ifndef SIM_H
#define SIM_H

#include <stddef.h> // size_t

#include "nck/nck.h" // nck_t and all records

// One row per tick.
typedef struct sim_row {
    double t_s;            // tick number × period; the first tick is number 1, at 0 the machine rests
    nck_pose_t pose;
    nck_axes_t axes;
    double spindle_rpm;    // last S word handed over
    uint32_t queue_cells;  // final cells waiting
    uint32_t reserved;     // 0
} sim_row_t;

typedef struct sim {
    nck_t *nck;
    const char *text;      // the whole program, fed as fast as the kernel takes it
    size_t text_size, text_used;
    uint32_t prep_steps;   // prep steps between two ticks, ≥ 1; few of them starve the tick
    uint32_t prepared;     // 1: prep has handed everything over
    int32_t error;         // program error, NCK_OK if none
    uint64_t ticks;        // so far
    uint64_t starved_ticks;
    uint64_t outputs;      // handed over so far
    double spindle_rpm;    // last S word handed over
} sim_t;

// Set up a run. The kernel is initialised here (hooks are the simulation's). prep_steps ≥ 1.
// Returns as nck_init, or NCK_E_ARGUMENT.
nck_status_t sim_init(sim_t *sim, nck_t *nck, const nck_machine_t *machine, const char *text, size_t n,
                      uint32_t prep_steps);

// Run until row_max rows are filled (*row_count_out) or the program is over. M0, M1, M6 are resumed at the next tick.
// Returns NCK_OK (call again), NCK_DONE, or the program error after everything before it has been executed.
nck_status_t sim_run(sim_t *sim, sim_row_t *rows, size_t row_max, size_t *row_count_out);

#endif
