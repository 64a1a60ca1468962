// SPDX-License-Identifier: MIT
// How long the kernel's own steps take: loops with a clock around what is measured, nothing else.
#ifndef NCK_HOST_BENCH_H
#define NCK_HOST_BENCH_H

#include <stddef.h> // size_t
#include <stdint.h> // uint32_t int64_t

#include "nck/nck_tools.h" // nck_t nck_lookahead_t

#ifdef __cplusplus
extern "C" {
#endif

// Times of ticks, in an array of the caller.
typedef struct nck_host_times {
    uint32_t *ns;  // of each [ns], the clock's own not taken off
    size_t max;    // rows of ns
    size_t count;  // rows filled
} nck_host_times_t;

// Run a whole text with prep always ahead, and time every tick, times->max of them at most.
// nck: memory to work in, initialised here. times: fewer rows are filled if the program is shorter.
// Returns NCK_OK, or the error of nck_init or of the program. Cost: linear. Context: prep and tick.
nck_status_t nck_host_bench_ticks(nck_t *nck, const nck_machine_t *machine, const char *text,
                                  size_t n, nck_host_times_t *times);

// The time that reading the clock takes: the least of many pairs [ns].
// Cost: constant. Context: any.
int64_t nck_host_bench_clock(void);

// Room 4 alone: segs into its window, pieces out of it whenever it wants no more.
// lookahead: memory to work in, initialised here. *pieces_out: how many came out.
// Returns the time of all [ns]. Cost: linear. Context: prep.
int64_t nck_host_bench_window(nck_lookahead_t *lookahead, const nck_machine_t *machine,
                              const nck_seg_t *segs, size_t n, size_t *pieces_out);

#ifdef __cplusplus
}
#endif

#endif
