// SPDX-License-Identifier: MIT
// Nothing takes longer than it must: the time of motion along a straight line, against the shortest
// that speed, acceleration and jerk allow.
#include "motion_check.h"

enum { LINES = 60, BLOCKS = 8 };

static motion_t motion;
static uint64_t seed;

static void begin(uint32_t slope, int k)
{
    motion_begin(&motion, 1);
    motion.machine.slope = slope;
    motion_scale(&motion, 2.5e-4 * (double)(1 << k % 5), motion_random_decades(&seed, 0.3, 10.0),
                 motion_random_decades(&seed, 0.3, 30.0));
    motion_line(&motion, "G21 G90 G61");
}

static void put_block(double x, double v)
{
    char words[80];
    snprintf(words, sizeof words, "G1 X%.6f F%.6f", x, 60.0 * v);
    motion_line(&motion, words);
}

// Ticks of the program, which ends with a rest at x.
static double run(check_t *check, double x)
{
    motion_line(&motion, "M2");
    CHECK(check, motion_run(&motion, NULL) && motion.pose.axis[0] == x);
    return (double)motion.ticks;
}

// From rest to v [s]: the acceleration rises, stays if it may, and falls.
static double ramp(double v)
{
    const double a = motion.machine.path.a_max;
    const double j = motion.machine.path.j_max;
    return v * j <= a * a ? 2.0 * sqrt(v / j) : v / a + a / j;
}

// From rest to rest over a length within speed, acceleration and jerk [s]: the classical seven
// pieces; ramps are symmetric, so that one takes half of its end speed on average.
static double shortest_under_jerk(double length, double v)
{
    double low = 0.0;
    double high = v;
    if (v * ramp(v) <= length) return 2.0 * ramp(v) + (length - v * ramp(v)) / v;
    for (int n = 0; n < 200; n++) {
        const double middle = 0.5 * (low + high);
        if (middle * ramp(middle) <= length) low = middle;
        else high = middle;
    }
    return 2.0 * ramp(low);
}

static double draw_length(void) { return floor(motion_random_decades(&seed, 1e4, 5e7)) / 1e6; }
static double draw_speed(void) { return motion_random_decades(&seed, 5.0, 100.0); }

// The filter takes its taps on top, and again where no ramp is shorter than two of it; the nodes of
// the profile take a little at each end.
static void a_line_under_jerk_takes_little_more_than_the_shortest_time(check_t *check)
{
    seed = 4;
    for (int k = 0; k < LINES; k++) {
        begin(NCK_SLOPE_JERK, k);
        const double length = draw_length();
        const double v = draw_speed();
        put_block(length, v);
        const double shortest = shortest_under_jerk(length, v) / motion.machine.period_s;
        const double ticks = run(check, length);
        CHECK(check, ticks >= shortest - 1e-3);
        if (NCK_PROFILE < 256) continue; // a short window brakes early
        CHECK(check, ticks <= 1.1 * shortest + 2.0 * NCK_FILTER_TAPS + 4.0);
    }
}

// Under the acceleration alone, blocks of one line and several feeds: v² as high as the caps, and
// 2·a·length from any neighbour's. A period with a top or a valley inside costs a part of itself.
static double shortest_over(const double *length, const double *v, double a)
{
    double vv[BLOCKS + 1];
    double time = 0.0;
    vv[0] = vv[BLOCKS] = 0.0;
    for (int k = 1; k < BLOCKS; k++) vv[k] = fmin(v[k - 1] * v[k - 1], v[k] * v[k]);
    for (int k = 1; k <= BLOCKS; k++) vv[k] = fmin(vv[k], vv[k - 1] + 2.0 * a * length[k - 1]);
    for (int k = BLOCKS; k-- > 0;) vv[k] = fmin(vv[k], vv[k + 1] + 2.0 * a * length[k]);
    for (int k = 0; k < BLOCKS; k++) {
        const double top = fmin(v[k] * v[k], 0.5 * (vv[k] + vv[k + 1]) + a * length[k]);
        const double ramps = (2.0 * top - vv[k] - vv[k + 1]) / (2.0 * a);
        time += (2.0 * sqrt(top) - sqrt(vv[k]) - sqrt(vv[k + 1])) / a
                + (length[k] - ramps) / sqrt(top);
    }
    return time;
}

static void feeds_change_as_late_and_as_early_as_they_may(check_t *check)
{
    seed = 5;
    for (int k = 0; k < LINES; k++) {
        double length[BLOCKS];
        double v[BLOCKS];
        double x = 0.0;
        int64_t x_nm = 0;
        begin(NCK_SLOPE_LINEAR, k);
        for (int n = 0; n < BLOCKS; n++) {
            const int64_t nm = (int64_t)motion_random_decades(&seed, 1e4, 1e7);
            length[n] = (double)nm * 1e-6;
            v[n] = draw_speed();
            x_nm += nm;
            x = (double)x_nm / 1e6;
            put_block(x, v[n]);
        }
        const double a = motion.machine.path.a_max;
        const double shortest = shortest_over(length, v, a) / motion.machine.period_s;
        const double ticks = run(check, x);
        CHECK(check, ticks >= shortest - 1e-3 && ticks <= shortest + 3.0);
    }
}

// A stop costs what a rest costs: the line before it and the one behind are alone.
static void stops_between_lines_add_nothing_but_themselves(check_t *check)
{
    seed = 6;
    for (uint32_t slope = NCK_SLOPE_LINEAR; slope <= NCK_SLOPE_JERK; slope++) {
        for (int k = 0; k < 10; k++) {
            begin(slope, k);
            put_block(7.0, 20.0);
            const double alone = run(check, 7.0);
            motion.size = 0;
            motion_line(&motion, "G21 G90 G61.1");
            for (int n = 1; n <= 5; n++) put_block(7.0 * n, 20.0);
            CHECK_NEAR(check, run(check, 35.0), 5.0 * alone, 5.0);
        }
    }
}

int main(void)
{
    check_t check = {0};
    CHECK_RUN(&check, a_line_under_jerk_takes_little_more_than_the_shortest_time);
    CHECK_RUN(&check, feeds_change_as_late_and_as_early_as_they_may);
    CHECK_RUN(&check, stops_between_lines_add_nothing_but_themselves);
    return check_end(&check);
}
