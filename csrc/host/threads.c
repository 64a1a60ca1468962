// SPDX-License-Identifier: MIT
// Threads by OpenMP where the compiler has it, and the monotonic clock of POSIX.
#define _POSIX_C_SOURCE 199309L // clock_gettime

#include "host/threads.h"

#include <time.h> // clock_gettime

#ifdef _OPENMP
#include <omp.h> // omp_get_max_threads omp_get_thread_num
#endif

int nck_host_has_threads(void) {
#ifdef _OPENMP
    return 1;
#else
    return 0;
#endif
}

int nck_host_threads(void) {
#ifdef _OPENMP
    const int threads = omp_get_max_threads();
    return threads < NCK_HOST_THREADS_MAX ? threads : NCK_HOST_THREADS_MAX;
#else
    return 1;
#endif
}

void nck_host_threads_run(size_t count, int threads,
                          void (*task)(void *context, size_t index, int thread), void *context) {
#ifdef _OPENMP
#pragma omp parallel for schedule(dynamic, 1) num_threads(threads)
    for (size_t index = 0; index < count; index++) task(context, index, omp_get_thread_num());
#else
    (void)threads;
    for (size_t index = 0; index < count; index++) task(context, index, 0);
#endif
}

int64_t nck_host_clock_ns(void) {
    struct timespec now;
    if (clock_gettime(CLOCK_MONOTONIC, &now) != 0) return 0;
    return (int64_t)now.tv_sec * 1000000000 + now.tv_nsec;
}
