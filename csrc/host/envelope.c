// SPDX-License-Identifier: MIT
// The door of the exact envelope: arguments, the variant for this processor, the report.
#include "host/envelope.h"

#include <string.h> // memset

#include "host/envelope/job.h" // envelope_job_t
#include "host/threads.h"      // NCK_HOST_THREADS_MAX

// variant[nck_host_cpu_t], for as many as are built
static const envelope_variant_t *const of_float[] = {
    &nck_host_envelope_float_plain,
#ifdef NCK_HOST_AVX2
    &nck_host_envelope_float_avx2,
#endif
};
static const envelope_variant_t *const of_double[] = {
    &nck_host_envelope_double_plain,
#ifdef NCK_HOST_AVX2
    &nck_host_envelope_double_avx2,
#endif
};

nck_host_cpu_t nck_host_cpu(void) {
#ifdef NCK_HOST_AVX2
    if (__builtin_cpu_supports("avx2")) return NCK_HOST_CPU_AVX2;
#endif
    return NCK_HOST_CPU_PLAIN;
}

static int is_possible(const nck_host_choice_t *choice, const envelope_job_t *job) {
    if (choice->cpu < 0 || choice->cpu > (int32_t)nck_host_cpu()) return 0;
    if (choice->backend != NCK_HOST_THREADS) {
        return choice->backend == NCK_HOST_SERIAL || choice->backend == NCK_HOST_SIMD;
    }
    return choice->threads >= 1 && choice->threads <= NCK_HOST_THREADS_MAX
           && job->vv != job->vv_cap;
}

static int run(const envelope_variant_t *variant, int32_t backend, const envelope_job_t *job,
               envelope_count_t *count) {
    if (backend == NCK_HOST_SERIAL) return variant->serial(job, count);
    if (backend == NCK_HOST_SIMD) return variant->simd(job, count);
    return variant->threads(job, count);
}

static int is_good(double vv) { return vv >= 0 && vv - vv == 0; }

// The first index with a bad number, among the ends too; n if there is none.
static size_t first_bad(const envelope_variant_t *variant, const envelope_job_t *job) {
    if (!is_good(job->vv_start)) return 0;
    const size_t bad = variant->first_bad(job);
    return bad == job->n && !is_good(job->vv_end) ? job->n - 1 : bad;
}

static nck_status_t plan(const envelope_variant_t *const *variants, size_t size,
                         const nck_host_choice_t *choice, const envelope_job_t *job,
                         nck_host_envelope_report_t *report) {
    envelope_count_t count = {0};
    *report = (nck_host_envelope_report_t){.bad = job->n};
    if (job->n == 0 || !is_possible(choice, job)) return NCK_E_ARGUMENT;
    const envelope_variant_t *variant = variants[choice->cpu];
    if (!is_good(job->vv_start) || !is_good(job->vv_end) ||
        !run(variant, choice->backend, job, &count)) {
        report->bad = first_bad(variant, job);
        memset(job->vv, 0, job->n * size);
        return NCK_E_ARGUMENT;
    }
    report->blocks = count.blocks;
    report->blocks_refused = count.refused;
    report->chunks_refused = count.chunks_refused;
    report->overlap = count.overlap;
    return NCK_OK;
}

static envelope_job_t job_in_double(const nck_host_problem_double_t *of) {
    return (envelope_job_t){.vv_cap = of->vv_cap, .h = of->h, .n = of->n,
                            .vv_start = of->vv_start, .vv_end = of->vv_end};
}

static envelope_job_t job_in_float(const nck_host_problem_float_t *of) {
    return (envelope_job_t){.vv_cap = of->vv_cap, .h = of->h, .n = of->n,
                            .vv_start = (double)(float)of->vv_start,
                            .vv_end = (double)(float)of->vv_end};
}

nck_status_t nck_host_envelope_double(const nck_host_choice_t *choice,
                                      const nck_host_problem_double_t *problem, double *vv_out,
                                      nck_host_envelope_report_t *report_out) {
    envelope_job_t job = job_in_double(problem);
    job.vv = vv_out;
    job.threads = choice->threads;
    return plan(of_double, sizeof *vv_out, choice, &job, report_out);
}

nck_status_t nck_host_envelope_float(const nck_host_choice_t *choice,
                                     const nck_host_problem_float_t *problem, float *vv_out,
                                     nck_host_envelope_report_t *report_out) {
    envelope_job_t job = job_in_float(problem);
    job.vv = vv_out;
    job.threads = choice->threads;
    return plan(of_float, sizeof *vv_out, choice, &job, report_out);
}

size_t nck_host_envelope_bad_double(const nck_host_problem_double_t *problem) {
    const envelope_job_t job = job_in_double(problem);
    return job.n == 0 ? 0 : first_bad(of_double[NCK_HOST_CPU_PLAIN], &job);
}

size_t nck_host_envelope_bad_float(const nck_host_problem_float_t *problem) {
    const envelope_job_t job = job_in_float(problem);
    return job.n == 0 ? 0 : first_bad(of_float[NCK_HOST_CPU_PLAIN], &job);
}
