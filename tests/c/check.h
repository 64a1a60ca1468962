// SPDX-License-Identifier: MIT
// A test harness in one header, for the host and for a target: no heap, no state but check_t.
//
//     static void line_ends_on_its_target(check_t *check) { CHECK(check, position == target); }
//
//     int main(void)
//     {
//         check_t check = { 0 };
//         CHECK_RUN(&check, line_ends_on_its_target);
//         return check_end(&check);
//     }
#ifndef CHECK_H
#define CHECK_H

#include <math.h>   // fabs
#include <stdint.h> // uint32_t
#include <stdio.h>  // printf
#include <stdlib.h> // strtoul

typedef struct check {
    int tests;  // run so far
    int failed; // tests of them with a broken check
    int broken; // checks broken in the running test
} check_t;

// Note a check. A broken one is told and counted, and the test goes on. Returns the condition.
static inline int check_that(check_t *check, int good, const char *what, const char *file, int line)
{
    if (!good) {
        check->broken++;
        printf("%s:%d: broken: %s\n", file, line, what);
    }
    return good;
}

// As check_that, for whole numbers: tells both.
static inline void check_int(check_t *check, long long got, long long want, const char *what,
                             const char *file, int line)
{
    if (!check_that(check, got == want, what, file, line)) {
        printf("    got %lld, want %lld\n", got, want);
    }
}

// As check_that, for real numbers: |got − want| ≤ tolerance; NaN is never near.
static inline void check_near(check_t *check, double got, double want, double tolerance,
                              const char *file, int line)
{
    if (!check_that(check, fabs(got - want) <= tolerance, "near", file, line)) {
        printf("    got %.17g, want %.17g within %.3g\n", got, want, tolerance);
    }
}

// Run one test and tell how it went.
static inline void check_run(check_t *check, void (*test)(check_t *check), const char *name)
{
    check->broken = 0;
    test(check);
    check->tests++;
    check->failed += check->broken > 0;
    printf("%s %s\n", check->broken > 0 ? "FAILED" : "ok", name);
}

// Print the counts. Returns the program's exit status: 0 if a test ran and none failed.
static inline int check_end(const check_t *check)
{
    printf("%d passed, %d failed\n", check->tests - check->failed, check->failed);
    return check->tests == 0 || check->failed > 0;
}

#define CHECK(check, condition) check_that((check), (condition), #condition, __FILE__, __LINE__)
#define CHECK_INT(check, got, want) \
    check_int((check), (long long)(got), (long long)(want), #got " == " #want, __FILE__, __LINE__)
#define CHECK_NEAR(check, got, want, tolerance) \
    check_near((check), (got), (want), (tolerance), __FILE__, __LINE__)
#define CHECK_RUN(check, test) check_run((check), (test), #test)

// How many cases a search by seed tries, and from which one on, where the command line says them.
static inline void check_seeds(int argc, char **argv, uint32_t *count, uint32_t *first)
{
    if (argc > 1) *count = (uint32_t)strtoul(argv[1], NULL, 10);
    if (argc > 2) *first = (uint32_t)strtoul(argv[2], NULL, 10);
}

#endif
