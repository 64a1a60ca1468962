// SPDX-License-Identifier: MIT
// Stop watches for the benches: loops in C, so that a caller's own cost stays outside.
#ifndef NCK_HOST_MEASURE_H
#define NCK_HOST_MEASURE_H

#include <stddef.h> // size_t
#include <stdint.h> // int64_t

#include "host/envelope.h" // nck_host_choice_t nck_host_problem_…
#include "host/jerk.h"     // nck_host_jerk_t

#ifdef __cplusplus
extern "C" {
#endif

// The least time of some runs of nck_host_envelope_double. Problem and arrays as there; runs: 1 at
// least.
// Returns nanoseconds, or the negative status of a run that failed. Cost: runs × linear. Context:
// any.
int64_t nck_host_measure_double(const nck_host_choice_t *choice,
                                const nck_host_problem_double_t *problem, double *vv_out, int runs);

// As nck_host_measure_double, of nck_host_envelope_float.
int64_t nck_host_measure_float(const nck_host_choice_t *choice,
                               const nck_host_problem_float_t *problem, float *vv_out, int runs);

// The least time of some runs of nck_host_triad [ns]. Arrays as there. Context: any.
int64_t nck_host_measure_triad(const float *b, const float *c, size_t n, int threads, float *a_out,
                               int runs);

// The least time of some runs of nck_host_jerk; runs: 1 at least.
// Returns nanoseconds, or NCK_E_ARGUMENT if a run fails (too few nodes among it).
// Cost: runs × linear. Context: any.
int64_t nck_host_measure_jerk(const nck_host_path_t *path, const nck_host_jerk_t *how,
                              const nck_host_jerk_area_t *area, int runs);

#ifdef __cplusplus
}
#endif

#endif
