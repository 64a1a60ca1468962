// SPDX-License-Identifier: MIT
// What the door (envelope.c) and the variants of the exact envelope say to each other.
#ifndef NCK_HOST_ENVELOPE_JOB_H
#define NCK_HOST_ENVELOPE_JOB_H

#include <stddef.h> // size_t

// A whole path. The arrays are of the variant's number type; vv may be vv_cap except for threads.
typedef struct envelope_job {
    const void *vv_cap; // n nodes [mm²/s²]
    const void *h;      // n − 1 pieces [mm²/s²]
    void *vv;           // n nodes
    size_t n;           // 1 at least
    double vv_start, vv_end; // exact in the number type
    int threads;       // for threads: 1 at least
} envelope_job_t;

// What happened on the way, for the report. Sums of whole runs.
typedef struct envelope_count {
    size_t blocks; // blocks planned in lanes
    size_t refused; // blocks whose overlaps did not meet: planned serially
    size_t chunks_refused; // blocks and chunks beyond whose ends overlaps did not meet
    size_t overlap; // longest overlap of a block [nodes]
    int bad;        // 1: a number is NaN, infinite or negative
} envelope_count_t;

// One variant: an element type and a processor. All return 0 if a number is bad.
typedef struct envelope_variant {
    int (*serial)(const envelope_job_t *job, envelope_count_t *count);
    int (*simd)(const envelope_job_t *job, envelope_count_t *count);
    int (*threads)(const envelope_job_t *job, envelope_count_t *count);
    size_t (*first_bad)(const envelope_job_t *job); // n if none
} envelope_variant_t;

extern const envelope_variant_t nck_host_envelope_float_plain;
extern const envelope_variant_t nck_host_envelope_double_plain;
extern const envelope_variant_t nck_host_envelope_float_avx2;
extern const envelope_variant_t nck_host_envelope_double_avx2;

#endif
