// SPDX-License-Identifier: MIT
// Problems for the smoothest curve, and what its answer promises, in either number type.
#ifndef FAIR_CHECK_H
#define FAIR_CHECK_H

#include <string.h> // memcmp memset

#include "check.h"
#include "nck/prep/3_smooth/fair.h" // nck_fair_…

enum { FAIR_KNOTS = 40, FAIR_PER_BIN = 2 };

// A number from −1 to 1 (G. Marsaglia, Xorshift RNGs, 2003).
static double any(uint32_t *state)
{
    *state ^= *state << 13;
    *state ^= *state >> 17;
    *state ^= *state << 5;
    return (double)*state / 2147483648.0 - 1.0;
}

// What a problem is made of: a reference of jerk, and samples off it.
typedef struct fair_case {
    const char *name;
    int axes;
    int ends;
    double scale; // P/(J τ³)
    double bend;  // what the reference jerks by at two places [J]
    double noise; // of the samples [P]
    double even;  // what fourth powers count
} fair_case_t;

static const fair_case_t fair_cases[] = {
    {"two corners", 2, 0, 15.0, 12.0, 0.0, 0.0},
    {"noise", 2, 0, 15.0, 0.0, 0.5, 0.0},
    {"corners and noise", 3, 1, 15.0, 6.0, 0.3, 0.0},
    {"a wide tolerance", 3, 0, 45.0, 20.0, 0.1, 0.0},
    {"a narrow one", 2, 1, 0.3, 3.0, 0.2, 0.0},
    {"two corners, even", 2, 0, 15.0, 12.0, 0.0, 16.0},
    {"corners and noise, even", 3, 1, 15.0, 6.0, 0.3, 16.0},
    {"a narrow one, even", 2, 1, 0.3, 3.0, 0.2, 16.0},
};
enum { FAIR_CASES = sizeof fair_cases / sizeof *fair_cases };

// Samples of an interval's bins.
static void fair_fill(nck_fair_t *fair, const fair_case_t *about, uint32_t *state)
{
    for (int n = 0; n < NCK_FAIR_BINS * FAIR_PER_BIN; n++) {
        const int k = n / FAIR_PER_BIN;
        const double place = (k + 0.3 + 0.4 * (n % FAIR_PER_BIN)) / (double)NCK_FAIR_BINS;
        nck_num off[NCK_AXIS_MAX];
        for (int a = 0; a < about->axes; a++) off[a] = (nck_num)(about->noise * any(state));
        nck_fair_add_sample(fair, (nck_num)place, off);
        if (n % FAIR_PER_BIN == FAIR_PER_BIN - 1) nck_fair_close_bin(fair, (nck_num)0.98);
    }
}

static void fair_begin(nck_fair_t *fair, const fair_case_t *about)
{
    nck_fair_task_t task = {FAIR_KNOTS, about->axes, about->ends, 40, (nck_num)0.05,
                            (nck_num)about->even, (nck_num)about->scale, (nck_num)0.03,
                            {1}};
    uint32_t state = 2463534242u;
    for (int a = 0; a < about->axes; a++) task.share[a] = (nck_num)(a == 1 ? 0.7 : 1.0);
    nck_fair_begin(fair, &task);
    for (int i = 0; i < FAIR_KNOTS; i++) {
        nck_num jerk[NCK_AXIS_MAX];
        for (int a = 0; a < about->axes; a++) {
            const int turns = i == 10 + 3 * a || i == 25;
            jerk[a] = (nck_num)(turns ? about->bend
                                      : i == 11 + 3 * a ? -about->bend : 0.1 * any(&state));
        }
        nck_fair_set_jerk(fair, i, jerk);
        fair_fill(fair, about, &state);
    }
}

// Work to the end. Returns the calls it takes.
static int fair_finish(nck_fair_t *fair)
{
    int calls = 1;
    while (nck_fair_step(fair) == NCK_OK) calls++;
    return calls;
}

// |e|² at a sample, by weights in double.
static double fair_off(const nck_fair_t *fair, const double *y, int k, int i)
{
    const int axes = fair->task.axes;
    const double w = (double)fair->place[k];
    const double m = 1.0 - w;
    const double weight[4] = {m * m * m / 6.0, (3.0 * w * w * w - 6.0 * w * w + 4.0) / 6.0,
                              (3.0 * m * m * m - 6.0 * m * m + 4.0) / 6.0, w * w * w / 6.0};
    double sum = 0.0;
    for (int a = 0; a < axes; a++) {
        double e = (double)fair->off[k * axes + a];
        for (int p = 0; p < 4; p++) e += weight[p] * y[(i + p) * axes + a];
        sum += e * e;
    }
    return sum;
}

// The most |e|² of any sample; and what is to be least, the part of the rows kept apart.
static double fair_worst(const nck_fair_t *fair, const double *y, double *objective_out)
{
    const int axes = fair->task.axes;
    double worst = 0.0, sum = 0.0;
    for (int i = 0; i < FAIR_KNOTS; i++) {
        for (int a = 0; a < axes; a++) {
            const double *const c = &y[i * axes + a];
            const double third = c[3 * axes] - 3.0 * c[2 * axes] + 3.0 * c[axes] - c[0];
            const double jerk =
                (double)fair->jerk[i * axes + a] + (double)fair->task.scale * third;
            const double x = fabs((double)fair->task.share[a] * jerk);
            const double low = fmin(x, 1.0), even = (double)fair->task.even;
            const double slope = 2.0 * low + 4.0 * even * low * low * low;
            const double bend = 2.0 + 12.0 * even * low * low;
            sum += low * low + even * low * low * low * low + slope * (x - low)
                   + 0.5 * bend * (x - low) * (x - low);
        }
        for (int b = NCK_FAIR_BINS * i; b < NCK_FAIR_BINS * (i + 1); b++) {
            sum += 0.03 * fair_off(fair, y, fair->kept[b], i);
            for (int k = fair->first[b]; k < fair->first[b + 1]; k++) {
                const double off = fair_off(fair, y, k, i);
                worst = off > worst ? off : worst;
            }
        }
    }
    *objective_out = sum;
    return worst;
}

static nck_fair_t fair, again;
static double fair_y[NCK_FAIR_POINTS * NCK_AXIS_MAX], fair_tried[NCK_FAIR_POINTS * NCK_AXIS_MAX];

static int fair_solve(int number)
{
    fair_begin(&fair, &fair_cases[number]);
    const int calls = fair_finish(&fair);
    for (int k = 0; k < (FAIR_KNOTS + 3) * fair.task.axes; k++) fair_y[k] = (double)fair.y[k];
    return calls;
}

static void no_sample_is_further_than_the_limit(check_t *check)
{
    for (int n = 0; n < FAIR_CASES; n++) {
        double objective = 0.0;
        fair_solve(n);
        const double worst = fair_worst(&fair, fair_y, &objective);
        const int good = CHECK(check, worst <= 0.98 * 0.98 + 0.023); // a row's sample, and SOUND
        if (!good) printf("    %s: %.4f after %d\n", fair_cases[n].name, worst, fair.iterations);
        CHECK(check, fair.iterations < 40);
    }
}

// Whatever else is within the limits, or no further off than the answer: hats of every width.
static void nothing_within_the_limits_is_smoother(check_t *check)
{
    for (int n = 0; n < FAIR_CASES; n++) {
        double least = 0.0, other = 0.0;
        uint32_t state = 88172645u;
        int within = 0;
        fair_solve(n);
        const double most = fmax(0.98 * 0.98, fair_worst(&fair, fair_y, &least));
        const int points = 3 + fair.unknown, axes = fair.task.axes;
        for (int trial = 0; trial < 3000; trial++) {
            const int width = 1 + trial % 9;
            const int middle = 3 + (int)((any(&state) + 1.0) / 2.0 * (points - 3));
            const double height = any(&state) / (double)(1 << trial % 7);
            memcpy(fair_tried, fair_y, sizeof fair_tried);
            for (int p = 3; p < points; p++) {
                const double near = 1.0 - fabs((double)(p - middle)) / width;
                if (near > 0.0) fair_tried[p * axes + trial % axes] += height * near;
            }
            if (fair_worst(&fair, fair_tried, &other) > most) continue;
            within++;
            const double rows = (double)FAIR_KNOTS * (double)NCK_FAIR_BINS;
            CHECK(check, other >= 0.95 * least - 0.05 * 0.02 * rows);
        }
        CHECK(check, within > 100);
    }
}

static void the_ends_stay(check_t *check)
{
    for (int n = 0; n < FAIR_CASES; n++) {
        fair_solve(n);
        const int axes = fair.task.axes;
        for (int k = 0; k < 3 * axes; k++) CHECK(check, !(fabs(fair_y[k]) > 0.0));
        if (!fair.task.ends) continue;
        for (int k = 0; k < 3 * axes; k++) {
            CHECK(check, !(fabs(fair_y[FAIR_KNOTS * axes + k]) > 0.0));
        }
    }
}

static void slices_of_any_size_give_the_same_bits(check_t *check)
{
    for (int n = 0; n < FAIR_CASES; n++) {
        const int calls = fair_solve(n);
        fair_begin(&again, &fair_cases[n]);
        again.slice = 1;
        CHECK(check, fair_finish(&again) > calls);
        CHECK_INT(check, again.iterations, fair.iterations);
        CHECK(check, memcmp(again.y, fair.y, sizeof fair.y) == 0);
    }
}

static void a_full_problem_leaves_samples_out_and_has_one_in_every_bin(check_t *check)
{
    const nck_fair_task_t task = {FAIR_KNOTS, 2, 0, 40, (nck_num)0.05, 0, 15, (nck_num)0.03,
                                  {1, 1}};
    nck_fair_begin(&fair, &task);
    const nck_num off[2] = {(nck_num)0.1, 0}, none[2] = {0, 0};
    for (int i = 0; i < FAIR_KNOTS; i++) {
        nck_fair_set_jerk(&fair, i, none);
        for (int k = 0; k < NCK_FAIR_BINS; k++) {
            for (int n = 0; n < NCK_FAIR_SAMPLES; n++) {
                nck_fair_add_sample(&fair, (nck_num)(0.25 * k), off);
            }
            nck_fair_close_bin(&fair, (nck_num)0.98);
        }
    }
    CHECK_INT(check, fair.bins, NCK_FAIR_BINS * FAIR_KNOTS);
    CHECK_INT(check, fair.first[fair.bins], NCK_FAIR_SAMPLES);
    for (int b = 0; b < fair.bins; b++) CHECK(check, fair.first[b + 1] > fair.first[b]);
}

static int fair_tests(void)
{
    check_t check = {0};
    CHECK_RUN(&check, no_sample_is_further_than_the_limit);
    CHECK_RUN(&check, nothing_within_the_limits_is_smoother);
    CHECK_RUN(&check, the_ends_stay);
    CHECK_RUN(&check, slices_of_any_size_give_the_same_bits);
    CHECK_RUN(&check, a_full_problem_leaves_samples_out_and_has_one_in_every_bin);
    return check_end(&check);
}

#endif
