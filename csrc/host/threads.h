// SPDX-License-Identifier: MIT
// Threads and the clock: the one place of libnck_host that knows OpenMP. Without it everything
// runs, on one thread.
#ifndef NCK_HOST_THREADS_H
#define NCK_HOST_THREADS_H

#include <stddef.h> // size_t
#include <stdint.h> // int64_t

#ifdef __cplusplus
extern "C" {
#endif

// Threads of one job, at most.
enum { NCK_HOST_THREADS_MAX = 64 };

// 1 if built with OpenMP. Cost: constant. Context: any.
int nck_host_has_threads(void);

// Threads that this machine runs at once, 1 to NCK_HOST_THREADS_MAX; 1 if built without OpenMP.
// OMP_NUM_THREADS is honoured. Cost: constant. Context: any.
int nck_host_threads(void);

// Run task(context, index, thread) for every index from 0 to count − 1, on 1 to
// NCK_HOST_THREADS_MAX threads: whoever is free takes the next index. thread: 0 to threads − 1,
// no two running tasks have the same. Returns when all are done. Context: prep.
void nck_host_threads_run(size_t count, int threads,
                          void (*task)(void *context, size_t index, int thread), void *context);

// Monotonic time since an arbitrary moment [ns]. Cost: constant. Context: any.
int64_t nck_host_clock_ns(void);

#ifdef __cplusplus
}
#endif

#endif
