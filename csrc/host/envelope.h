// SPDX-License-Identifier: MIT
// The exact two-pass envelope of a whole path in v², in float and double, by several roads that
// give the same bits. What it computes: prep/4_lookahead/README.md; how: docs/parallel.md.
#ifndef NCK_HOST_ENVELOPE_H
#define NCK_HOST_ENVELOPE_H

#include <stddef.h> // size_t
#include <stdint.h> // int32_t

#include "nck/base/status.h" // nck_status_t

#ifdef __cplusplus
extern "C" {
#endif

// How an envelope is planned; the bits are the same.
typedef enum nck_host_backend {
    NCK_HOST_SERIAL = 0, // one node after the other: the definition
    NCK_HOST_SIMD = 1,   // overlapped stretches in the lanes of a vector, one thread
    NCK_HOST_THREADS = 2 // overlapped chunks on threads, lanes inside
} nck_host_backend_t;

// Which processor the code is for.
typedef enum nck_host_cpu {
    NCK_HOST_CPU_PLAIN = 0, // C that any processor runs
    NCK_HOST_CPU_AVX2 = 1
} nck_host_cpu_t;

// What to use.
typedef struct nck_host_choice {
    int32_t backend; // nck_host_backend_t
    int32_t cpu;     // nck_host_cpu_t, at most what nck_host_cpu returns
    int32_t threads; // NCK_HOST_THREADS: 1 to NCK_HOST_THREADS_MAX
} nck_host_choice_t;

// What an envelope is found for, in double: all numbers finite and not negative.
typedef struct nck_host_problem_double {
    const double *vv_cap;    // n nodes: cap of v² [mm²/s²]
    const double *h;         // n − 1 pieces: 2·a·length [mm²/s²]
    size_t n;                // nodes, at least 1
    double vv_start, vv_end; // v² at the first and at the last node, at most [mm²/s²]
} nck_host_problem_double_t;

// As nck_host_problem_double_t, in float; vv_start and vv_end are rounded to float first.
typedef struct nck_host_problem_float {
    const float *vv_cap;
    const float *h;
    size_t n;
    double vv_start, vv_end;
} nck_host_problem_float_t;

// What happened.
typedef struct nck_host_envelope_report {
    size_t bad;            // first index whose number is NaN, infinite or negative; else n
    size_t blocks;         // planned in lanes
    size_t blocks_refused; // planned serially, because no overlap within a lane was certain
    size_t chunks_refused; // so often no overlap beyond a block was certain: it grew, and was
                           // planned serially; with threads, of a chunk: one thread planned all
    size_t overlap;        // longest overlap of a lane [nodes]
} nck_host_envelope_report_t;

// The best that this processor runs. Cost: constant. Context: any.
nck_host_cpu_t nck_host_cpu(void);

// The exact two-pass envelope of a whole path in double.
// choice: the road to take. vv_out: n nodes; it may be the problem's vv_cap unless the road is
// NCK_HOST_THREADS. *report_out is filled in any case.
// Returns NCK_OK; NCK_E_ARGUMENT if n is 0, the choice is not possible (bad = n), or a number is
// NaN, infinite or negative (its index in bad; vv_start: 0, vv_end: n − 1): vv_out is all 0 then.
// Cost: linear, two passes. Context: any.
nck_status_t nck_host_envelope_double(const nck_host_choice_t *choice,
                                      const nck_host_problem_double_t *problem, double *vv_out,
                                      nck_host_envelope_report_t *report_out);

// As nck_host_envelope_double, in float.
nck_status_t nck_host_envelope_float(const nck_host_choice_t *choice,
                                     const nck_host_problem_float_t *problem, float *vv_out,
                                     nck_host_envelope_report_t *report_out);

// The first index whose cap or piece is NaN, infinite or negative (vv_start: 0, vv_end: n − 1); n
// if all are good. Cost: linear. Context: any.
size_t nck_host_envelope_bad_double(const nck_host_problem_double_t *problem);

// As nck_host_envelope_bad_double, in float.
size_t nck_host_envelope_bad_float(const nck_host_problem_float_t *problem);

#ifdef __cplusplus
}
#endif

#endif
