// SPDX-License-Identifier: MIT
// Prep and tick as two threads, for the thread sanitizer:
//
//     link_threads CELLS WAY
//
// WAY is a traffic_way_t.
#include <pthread.h> // pthread_create
#include <stdio.h>   // printf
#include <stdlib.h>  // strtoul

#include "traffic.h" // traffic_prepare traffic_consume

static nck_link_t link_;
static traffic_prep_t prep;
static traffic_tick_t tick;
static uint32_t cells_wanted, is_over, is_stopped;

// The tick goes on after the last cell that counts, so that prep never waits in vain.
static void *run_tick(void *user) {
    while (!nck_fence_load(&is_stopped)) {
        traffic_consume(&link_, &tick);
        if (tick.cells >= cells_wanted || tick.fault) nck_fence_store(&is_over, 1);
    }
    return user;
}

int main(int count, char **words) {
    pthread_t thread;
    if (count != 3) return 2;
    cells_wanted = (uint32_t)strtoul(words[1], NULL, 10);
    prep.way = tick.way = (uint32_t)strtoul(words[2], NULL, 10);
    nck_link_init(&link_);
    if (pthread_create(&thread, NULL, run_tick, NULL) != 0) return 2;
    while (!nck_fence_load(&is_over) && !prep.fault) traffic_prepare(&link_, &prep);
    nck_fence_store(&is_stopped, 1);
    (void)pthread_join(thread, NULL);
    const char *const fault = prep.fault ? prep.fault : tick.fault;
    printf("%u batches, %u lost, %u cells, %u tails, %u outputs\n", prep.batches, prep.losses,
           tick.cells, tick.tails, tick.outputs);
    if (fault) printf("broken: %s\n", fault);
    return fault ? 1 : 0;
}
