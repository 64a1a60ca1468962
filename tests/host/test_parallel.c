// SPDX-License-Identifier: MIT
// Bulk planning: the bits of the recurrence by every road, in arrays that end where they must end
// (each has a heap block of its own, so that the address sanitizer sees the first step too far).
#include "check.h"

#include <math.h>   // NAN INFINITY
#include <stdint.h> // uint32_t
#include <stdlib.h> // malloc free
#include <string.h> // memcmp

#include "host/envelope.h"
#include "host/keinert.h"
#include "host/threads.h"

// A fixed sequence of numbers in 0..1, the same on every machine.
static double next_random(uint32_t *state) {
    *state = *state * 1664525u + 1013904223u;
    return (double)(*state >> 8) / 16777216.0;
}

typedef struct family {
    const char *name;
    double share;        // of low caps
    double low, high;    // caps
    double h_from, h_to; // pieces
} family_t;

static const family_t families[] = {
    {"all capped", 1.0, 1e4, 1e4, 1e5, 2e5}, {"never capped", 0.0, 0.0, 1e30, 1.0, 2.0},
    {"surface", 0.1, 1e4, 1e4, 500, 1500},   {"5 um segments", 0.01, 1e4, 1e4, 9.9, 10.1},
    {"50 mm segments", 0.3, 1e4, 1e4, 9e4, 1.1e5},
};
enum { FAMILIES = sizeof families / sizeof families[0] };

static const size_t sizes[] = {1,    2,    3,    64,    65,    511,   512,   513,   1000,
                               2080, 4160, 8319, 16640, 16641, 33280, 33281, 70000, 100003};
enum { SIZES = sizeof sizes / sizeof sizes[0] };

typedef struct path {
    size_t n;
    double *vv_cap, *h, *vv, *want;
    float *vv_cap_float, *h_float, *vv_float, *want_float;
} path_t;

static void *block_of(size_t count, size_t size) {
    void *block = malloc(count * size > 0 ? count * size : 1);
    if (block == NULL) abort();
    return block;
}

static path_t path_of(const family_t *family, size_t n) {
    path_t path = {.n = n};
    uint32_t state = (uint32_t)n;
    path.vv_cap = block_of(n, sizeof(double));
    path.h = block_of(n - 1, sizeof(double));
    path.vv = block_of(n, sizeof(double));
    path.want = block_of(n, sizeof(double));
    path.vv_cap_float = block_of(n, sizeof(float));
    path.h_float = block_of(n - 1, sizeof(float));
    path.vv_float = block_of(n, sizeof(float));
    path.want_float = block_of(n, sizeof(float));
    for (size_t i = 0; i < n; i++) {
        const int is_low = next_random(&state) < family->share;
        const double low = family->low * next_random(&state);
        path.vv_cap[i] = is_low ? low : family->high;
        path.vv_cap_float[i] = (float)path.vv_cap[i];
    }
    for (size_t i = 0; i + 1 < n; i++) {
        path.h[i] = family->h_from + (family->h_to - family->h_from) * next_random(&state);
        path.h_float[i] = (float)path.h[i];
    }
    return path;
}

static void path_free(path_t *path) {
    void *blocks[] = {path->vv_cap,       path->h,       path->vv,       path->want,
                      path->vv_cap_float, path->h_float, path->vv_float, path->want_float};
    for (size_t i = 0; i < sizeof blocks / sizeof blocks[0]; i++) free(blocks[i]);
}

// The definition, in the words of the README of 4_lookahead.
static void expect(path_t *path, double vv_start, double vv_end) {
    const size_t n = path->n;
    double *vv = path->want;
    float *f = path->want_float;
    for (size_t i = 0; i < n; i++) {
        vv[i] = path->vv_cap[i];
        f[i] = path->vv_cap_float[i];
    }
    if (vv_end < vv[n - 1]) vv[n - 1] = vv_end;
    if ((float)vv_end < f[n - 1]) f[n - 1] = (float)vv_end;
    for (size_t i = n - 1; i-- > 0;) {
        if (vv[i + 1] + path->h[i] < vv[i]) vv[i] = vv[i + 1] + path->h[i];
        if (f[i + 1] + path->h_float[i] < f[i]) f[i] = f[i + 1] + path->h_float[i];
    }
    if (vv_start < vv[0]) vv[0] = vv_start;
    if ((float)vv_start < f[0]) f[0] = (float)vv_start;
    for (size_t i = 0; i + 1 < n; i++) {
        if (vv[i] + path->h[i] < vv[i + 1]) vv[i + 1] = vv[i] + path->h[i];
        if (f[i] + path->h_float[i] < f[i + 1]) f[i + 1] = f[i] + path->h_float[i];
    }
}

static nck_host_problem_double_t problem_of(const path_t *path, double vv_start, double vv_end) {
    return (nck_host_problem_double_t){path->vv_cap, path->h, path->n, vv_start, vv_end};
}

// Plan by one road and hold both number types against the definition.
static int is_equal(path_t *path, const nck_host_choice_t *choice, double vv_start, double vv_end) {
    nck_host_envelope_report_t report;
    const nck_host_problem_double_t in_double = problem_of(path, vv_start, vv_end);
    const nck_host_problem_float_t in_float = {path->vv_cap_float, path->h_float, path->n, vv_start,
                                               vv_end};
    const nck_status_t of_double = nck_host_envelope_double(choice, &in_double, path->vv, &report);
    const nck_status_t of_float = nck_host_envelope_float(choice, &in_float, path->vv_float,
                                                          &report);
    return of_double == NCK_OK && of_float == NCK_OK &&
           memcmp(path->vv, path->want, path->n * sizeof(double)) == 0 &&
           memcmp(path->vv_float, path->want_float, path->n * sizeof(float)) == 0;
}

static void check_roads(check_t *check, const family_t *family, size_t n) {
    path_t path = path_of(family, n);
    expect(&path, 77.0, 1e4);
    for (int32_t cpu = 0; cpu <= (int32_t)nck_host_cpu(); cpu++) {
        for (int32_t road = NCK_HOST_SERIAL; road <= NCK_HOST_THREADS; road++) {
            const nck_host_choice_t choice = {.backend = road, .cpu = cpu, .threads = 3};
            if (!CHECK(check, is_equal(&path, &choice, 77.0, 1e4))) {
                printf("    %s, %zu nodes, road %d, processor %d\n", family->name, n, road, cpu);
            }
        }
    }
    path_free(&path);
}

static void every_road_gives_the_bits_of_the_recurrence(check_t *check) {
    for (size_t k = 0; k < FAMILIES; k++) {
        for (size_t i = 0; i < SIZES; i++) check_roads(check, &families[k], sizes[i]);
    }
}

static void a_path_that_cannot_be_split_is_planned_serially_and_says_so(check_t *check) {
    path_t path = path_of(&families[1], 100003);
    expect(&path, 77.0, 1e4);
    const nck_host_problem_double_t problem = problem_of(&path, 77.0, 1e4);
    nck_host_envelope_report_t report;
    for (int32_t road = NCK_HOST_SIMD; road <= NCK_HOST_THREADS; road++) {
        const nck_host_choice_t choice = {.backend = road, .threads = 2};
        CHECK_INT(check, nck_host_envelope_double(&choice, &problem, path.vv, &report), NCK_OK);
        CHECK(check, report.chunks_refused > 0);
        CHECK(check, report.blocks_refused > 0);
        CHECK(check, memcmp(path.vv, path.want, path.n * sizeof(double)) == 0);
    }
    path_free(&path);
}

static void a_bad_number_is_named_and_the_result_is_zero(check_t *check) {
    static const double bad[] = {(double)NAN, (double)INFINITY, -1.0};
    static const size_t places[] = {0, 1, 16640, 69998};
    nck_host_envelope_report_t report;
    for (size_t k = 0; k < 3 * 4 * 3; k++) {
        path_t path = path_of(&families[2], 70000);
        const nck_host_choice_t choice = {.backend = (int32_t)(k % 3), .threads = 2};
        const size_t place = places[k / 3 % 4];
        path.h[place] = bad[k / 12];
        path.vv_cap[69999] = (double)NAN;
        const nck_host_problem_double_t problem = problem_of(&path, 0.0, 0.0);
        CHECK_INT(check, nck_host_envelope_double(&choice, &problem, path.vv, &report),
                  NCK_E_ARGUMENT);
        CHECK_INT(check, report.bad, place);
        double sum = 0.0;
        for (size_t i = 0; i < path.n; i++) sum += fabs(path.vv[i]);
        CHECK(check, sum <= 0.0);
        path_free(&path);
    }
}

static void a_choice_that_is_not_possible_is_refused(check_t *check) {
    const nck_host_choice_t choices[] = {
        {.backend = -1},
        {.backend = NCK_HOST_THREADS + 1},
        {.cpu = -1},
        {.cpu = (int32_t)nck_host_cpu() + 1},
        {.backend = NCK_HOST_THREADS, .threads = 0},
        {.backend = NCK_HOST_THREADS, .threads = NCK_HOST_THREADS_MAX + 1},
    };
    nck_host_envelope_report_t report;
    double vv_cap[2] = {1.0, 1.0}, h[1] = {1.0}, vv[2] = {7.0, 7.0};
    nck_host_problem_double_t problem = {vv_cap, h, 2, 0.0, 0.0};
    for (size_t i = 0; i < sizeof choices / sizeof choices[0]; i++) {
        CHECK_INT(check, nck_host_envelope_double(&choices[i], &problem, vv, &report),
                  NCK_E_ARGUMENT);
        CHECK_INT(check, report.bad, 2);
    }
    const nck_host_choice_t threads = {.backend = NCK_HOST_THREADS, .threads = 2};
    CHECK_INT(check, nck_host_envelope_double(&threads, &problem, vv_cap, &report),
              NCK_E_ARGUMENT); // in place: a chunk would read what another one wrote
    problem.n = 0;
    CHECK_INT(check, nck_host_envelope_double(&threads, &problem, vv, &report), NCK_E_ARGUMENT);
}

static void caps_may_be_replaced_in_place(check_t *check) {
    path_t path = path_of(&families[2], 70000);
    expect(&path, 77.0, 1e4);
    const nck_host_choice_t choice = {.backend = NCK_HOST_SIMD};
    const nck_host_problem_double_t problem = problem_of(&path, 77.0, 1e4);
    nck_host_envelope_report_t report;
    CHECK_INT(check, nck_host_envelope_double(&choice, &problem, path.vv_cap, &report), NCK_OK);
    CHECK(check, memcmp(path.vv_cap, path.want, path.n * sizeof(double)) == 0);
    path_free(&path);
}

// Keinert

static void keinerts_profile_is_never_above_and_equal_where_certain(check_t *check) {
    const nck_host_keinert_settings_t settings = {300, 5, 50, 2};
    for (size_t k = 0; k < FAMILIES; k++) {
        path_t path = path_of(&families[k], 2003);
        expect(&path, 77.0, 1e4);
        const size_t tasks = nck_host_keinert_tasks(&settings, path.n);
        const size_t width = nck_host_keinert_rows(&settings);
        nck_host_keinert_task_t *table = block_of(tasks, sizeof *table);
        nck_host_keinert_row_t *rows = block_of(tasks * width, sizeof *rows);
        double *vv_feed = block_of(path.n - 1, sizeof *vv_feed);
        for (size_t i = 0; i + 1 < path.n; i++) vv_feed[i] = families[k].high;
        const nck_host_problem_double_t problem = problem_of(&path, 77.0, 1e4);
        const nck_host_keinert_tables_t tables = {rows, table};
        size_t bad = 0;
        CHECK_INT(check, nck_host_keinert(&settings, &problem, vv_feed, &tables, path.vv, &bad),
                  NCK_OK);
        for (size_t i = 0; i < path.n; i++) CHECK(check, path.vv[i] <= path.want[i]);
        for (size_t t = 0; t < tasks; t++) {
            const size_t size = table[t].count * sizeof(double);
            const size_t first = (size_t)table[t].first;
            CHECK(check, table[t].dropped > 0 ||
                             memcmp(path.vv + first, path.want + first, size) == 0);
        }
        free(table);
        free(rows);
        free(vv_feed);
        path_free(&path);
    }
}

int main(void) {
    check_t check = {0};
    CHECK_RUN(&check, every_road_gives_the_bits_of_the_recurrence);
    CHECK_RUN(&check, a_path_that_cannot_be_split_is_planned_serially_and_says_so);
    CHECK_RUN(&check, a_bad_number_is_named_and_the_result_is_zero);
    CHECK_RUN(&check, a_choice_that_is_not_possible_is_refused);
    CHECK_RUN(&check, caps_may_be_replaced_in_place);
    CHECK_RUN(&check, keinerts_profile_is_never_above_and_equal_where_certain);
    return check_end(&check);
}
