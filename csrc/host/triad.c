// SPDX-License-Identifier: MIT
// The triad, in chunks on threads.
#include "host/triad.h"

#include "host/threads.h" // nck_host_threads_run

// Numbers of a chunk: many more than a thread's start costs, few enough to share out evenly.
#define CHUNK ((size_t)1 << 16)

typedef struct triad {
    const float *b, *c;
    float s;
    size_t n;
    float *a;
} triad_t;

static void run_chunk(void *context, size_t index, int thread) {
    const triad_t *self = context;
    const size_t begin = index * CHUNK;
    const size_t end = self->n - begin < CHUNK ? self->n : begin + CHUNK;
    (void)thread;
    float *restrict a = self->a;
    const float s = self->s;
    for (size_t i = begin; i < end; i++) a[i] = self->b[i] + s * self->c[i];
}

void nck_host_triad(const float *b, const float *c, float s, size_t n, int threads, float *a_out) {
    triad_t self = {b, c, s, n, a_out};
    nck_host_threads_run((n + CHUNK - 1) / CHUNK, threads, run_chunk, &self);
}
