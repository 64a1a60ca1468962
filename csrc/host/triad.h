// SPDX-License-Identifier: MIT
// How fast memory is: the bound that a bulk planner is measured against.
#ifndef NCK_HOST_TRIAD_H
#define NCK_HOST_TRIAD_H

#include <stddef.h> // size_t

#ifdef __cplusplus
extern "C" {
#endif

// a_out[i] = b[i] + s·c[i] for n numbers: two streams in and one out, 12 bytes a number, as an
// envelope in float has. threads: 1 to NCK_HOST_THREADS_MAX. Cost: linear. Context: any.
void nck_host_triad(const float *b, const float *c, float s, size_t n, int threads, float *a_out);

#ifdef __cplusplus
}
#endif

#endif
