// SPDX-License-Identifier: MIT
// The build that this library is.
#include "sim_build.h"

#include <stddef.h> // offsetof

#include "sim_door.h"

void sim_build_tell(void *build) {
    sim_build_t *const self = build;
    self->plan_init = nck_host_plan_init;
    self->plan_blocks = nck_host_plan_blocks;
    self->plan_threads = nck_host_plan_threads;
    self->plan_part = nck_host_plan_part;
    self->plan_run = nck_host_plan_run;
    self->sim_init = sim_init;
    self->sim_feed_blocks = sim_feed_blocks;
    self->sim_run = sim_run;
    self->position = nck_position;
    self->queue = nck_queue;
    self->is_thread_lost = nck_is_thread_lost;
    self->kernel_size = sizeof(nck_t);
    self->plan_size = sizeof(nck_host_plan_t);
    self->machine_size = sizeof(nck_machine_t);
    self->cut_size = sizeof(nck_host_cut_t);
    self->told_size = offsetof(nck_host_plan_t, why) + offsetof(nck_host_why_t, segs);
    self->sim_size = sizeof(sim_t);
}
