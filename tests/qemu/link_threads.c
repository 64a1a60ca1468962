// SPDX-License-Identifier: MIT
// Prep and tick as two threads, for the thread sanitizer:
//
//     link_threads CELLS PLANS
//
// PLANS as in link_sweep.c.
#include <pthread.h> // pthread_create
#include <stdio.h>   // printf
#include <stdlib.h>  // strtoul

#include "traffic.h" // traffic_prepare traffic_consume

static nck_link_t link_;
static traffic_prep_t prep;
static traffic_tick_t tick;
static uint32_t cells_wanted, is_over;

static void *run_tick(void *user) {
    while (tick.cells < cells_wanted && !tick.fault) traffic_consume(&link_, &tick);
    // A tail that is not at rest would keep prep waiting.
    nck_link_tail_rest(&link_);
    nck_fence_store(&is_over, 1);
    return user;
}

int main(int count, char **words) {
    pthread_t thread;
    if (count != 3) return 2;
    prep.plans = tick.plans = words[2][0] == '1';
    cells_wanted = (uint32_t)strtoul(words[1], NULL, 10);
    nck_link_init(&link_);
    if (pthread_create(&thread, NULL, run_tick, NULL) != 0) return 2;
    while (!nck_fence_load(&is_over) && !prep.fault) traffic_prepare(&link_, &prep);
    if (prep.fault) cells_wanted = 0;
    (void)pthread_join(thread, NULL);
    const char *const fault = prep.fault ? prep.fault : tick.fault;
    printf("%u batches, %u lost, %u cells, %u tails, %u outputs\n", prep.batches, prep.losses,
           tick.cells, tick.tails, tick.outputs);
    if (fault) printf("broken: %s\n", fault);
    return fault ? 1 : 0;
}
