// SPDX-License-Identifier: MIT
// The least time of some runs.
#include "host/measure.h"

#include "host/threads.h" // nck_host_clock_ns
#include "host/triad.h"   // nck_host_triad

static int64_t lesser(int64_t a, int64_t b) { return a < b ? a : b; }

int64_t nck_host_measure_double(const nck_host_choice_t *choice,
                                const nck_host_problem_double_t *problem, double *vv_out,
                                int runs) {
    nck_host_envelope_report_t report;
    int64_t least = INT64_MAX;
    for (int k = 0; k < runs; k++) {
        const int64_t begin = nck_host_clock_ns();
        const nck_status_t status = nck_host_envelope_double(choice, problem, vv_out, &report);
        least = lesser(least, nck_host_clock_ns() - begin);
        if (status < 0) return status;
    }
    return least;
}

int64_t nck_host_measure_float(const nck_host_choice_t *choice,
                               const nck_host_problem_float_t *problem, float *vv_out, int runs) {
    nck_host_envelope_report_t report;
    int64_t least = INT64_MAX;
    for (int k = 0; k < runs; k++) {
        const int64_t begin = nck_host_clock_ns();
        const nck_status_t status = nck_host_envelope_float(choice, problem, vv_out, &report);
        least = lesser(least, nck_host_clock_ns() - begin);
        if (status < 0) return status;
    }
    return least;
}

int64_t nck_host_measure_triad(const float *b, const float *c, size_t n, int threads, float *a_out,
                               int runs) {
    int64_t least = INT64_MAX;
    for (int k = 0; k < runs; k++) {
        const int64_t begin = nck_host_clock_ns();
        nck_host_triad(b, c, 3.0f, n, threads, a_out);
        least = lesser(least, nck_host_clock_ns() - begin);
    }
    return least;
}

int64_t nck_host_measure_jerk(const nck_host_path_t *path, const nck_host_jerk_t *how,
                              const nck_host_jerk_area_t *area, int runs) {
    size_t count = 0;
    size_t bad = 0;
    int64_t least = INT64_MAX;
    for (int k = 0; k < runs; k++) {
        const int64_t begin = nck_host_clock_ns();
        const nck_status_t status = nck_host_jerk(path, how, area, &count, &bad);
        least = lesser(least, nck_host_clock_ns() - begin);
        if (status != NCK_OK) return NCK_E_ARGUMENT;
    }
    return least;
}
