// SPDX-License-Identifier: MIT
// One build of the kernel as what plans whole programs and runs them. Another library with other
// capacities fills in the same record, so that its calls are made with records of this one.
#ifndef SIM_BUILD_H
#define SIM_BUILD_H

#include <stddef.h> // size_t

#include "host/host.h" // nck_host_plan_t
#include "sim.h"       // sim_t

// Calls as in host.h, sim.h and nck.h, and sizes [bytes]. Builds that serve one another have the
// last four in common, and a plan's record in the larger one has room for the smaller one's.
typedef struct sim_build {
    nck_status_t (*plan_init)(nck_host_plan_t *plan, nck_t *nck, const nck_machine_t *machine,
                              const char *text, size_t n);
    void (*plan_blocks)(nck_host_plan_t *plan);
    void (*plan_threads)(nck_host_plan_t *plan);
    nck_status_t (*plan_part)(nck_host_plan_t *plan, const nck_host_cut_t *from, uint64_t blocks);
    nck_status_t (*plan_run)(nck_host_plan_t *plan);
    nck_status_t (*sim_init)(sim_t *sim, nck_t *nck, const nck_machine_t *machine,
                             const char *text, size_t n, uint32_t prep_steps);
    void (*sim_feed_blocks)(sim_t *sim);
    nck_status_t (*sim_run)(sim_t *sim, sim_row_t *rows, size_t row_max, size_t *row_count_out);
    nck_tick_state_t (*position)(const nck_t *nck, nck_pose_t *pose, nck_axes_t *axes);
    void (*queue)(const nck_t *nck, nck_queue_t *queue);
    int (*is_thread_lost)(const nck_t *nck);
    size_t kernel_size;  // of nck_t
    size_t plan_size;    // of nck_host_plan_t
    size_t machine_size; // of nck_machine_t
    size_t cut_size;     // of nck_host_cut_t
    size_t told_size;    // of what a caller reads of nck_host_plan_t, from its begin
    size_t sim_size;     // of sim_t
} sim_build_t;

#endif
