// SPDX-License-Identifier: MIT
// Beside a rest, or where one would do: a program that may take its corners as it likes is no
// slower than with a stop at each of them. Cases where what little a corner leaves of acceleration
// and jerk was taken for all of it, or was spread over the lines beside it.
#include "motion_check.h"

enum { LINES = 4 };
#define SLOWER 1.05       // more than with stops, and …
#define SLOWER_PERIODS 4  // … so many periods of a stop and of the filter

typedef struct corners {
    const char *name;
    double period;     // [s]
    double v;          // of axes and path [mm/s]
    double a, j[2];    // of X and Y, of Z: limits [mm/s², mm/s³]
    uint32_t slope;    // the first one that it is for
    const char *mode;
    const char *line[LINES];
} corners_t;

static const corners_t cases[] = {
    {"a bend from rest to rest", 1e-3, 2000.0, 28.0, {10000.0, 10000.0}, 0, "G61",
     {"X-0.158 Y0.000012", "Z-0.0975"}},
    {"a chain of long lines all but straight", 1e-2, 485.0, 11300.0, {146000.0, 146000.0}, 0,
     "G61", {"X-232.7 Y-1.552 Z-1.255", "X-232.7 Y-2.334 Z-2.094",
                       "X-232.6 Y-3.290 Z-2.729", "X-232.6 Y-4.345 Z-2.279"}},
    {"a zone of little jerk beside a long line", 1e-3, 180.0, 900.0, {42000.0, 2400.0}, 1,
     "G61", {"Z-0.026", "X-0.29 Y-0.33 Z-0.82"}},
    {"two lines that are as short as the filter", 1e-3, 250.0, 2500.0, {50000.0, 50000.0}, 0,
     "G61", {"X-0.0015 Y-0.0011 Z0.0027", "Z0.0017"}},
    {"a corner close behind a stop", 1e-3, 100.0, 1000.0, {1e5, 1e5}, 1, "G61",
     {"G61.1 X0.3", "G61 X0.002", "X0.002 Y0.0004"}},
    {"a corner that takes half of short lines' acceleration", 2.5e-4, 100.0, 100.0, {1e4, 1e4}, 0,
     "G61", {"X0.01", "X0.0017 Y0.0008", "X0.0033"}},
    {"a bend whose filter is wider than its lines", 1e-2, 6.5, 17.0, {9000.0, 900.0}, 0,
     "G61", {"X-0.0378 Y-0.0011", "Z0.0378"}},
};

static motion_t motion;

static uint64_t ticks_of(const corners_t *corners, uint32_t slope, int stops)
{
    motion_begin(&motion, 1);
    motion.machine.slope = slope;
    motion.machine.period_s = corners->period;
    motion.machine.path.feed_max = corners->v;
    motion.machine.path.a_max = 10.0 * corners->a;
    motion.machine.path.j_max = 10.0 * corners->j[0];
    for (int x = 0; x < 3; x++) {
        nck_axis_t *const axis = &motion.machine.axis[x];
        axis->v_max = axis->rapid = corners->v;
        axis->a_max = corners->a;
        axis->j_max = corners->j[x == 2];
    }
    motion_line(&motion, "G21 G91 G1 F30000");
    motion_line(&motion, stops ? "G61.1" : corners->mode);
    for (int k = 0; k < LINES && corners->line[k]; k++) {
        const char *const words = strstr(corners->line[k], "X");
        motion_line(&motion, stops && words ? words : corners->line[k]);
    }
    motion_line(&motion, "M2");
    return motion_run(&motion, NULL) ? motion.ticks : UINT64_MAX;
}

static void nothing_is_slower_than_with_a_stop_at_every_corner(check_t *check)
{
    for (size_t k = 0; k < sizeof cases / sizeof cases[0]; k++) {
        for (uint32_t slope = cases[k].slope; slope <= NCK_SLOPE_JERK; slope++) {
            const uint64_t ticks = ticks_of(&cases[k], slope, 0);
            const uint64_t stops = ticks_of(&cases[k], slope, 1);
            const double most = SLOWER * (double)stops + SLOWER_PERIODS;
            if (CHECK(check, (double)ticks <= most)) continue;
            printf("    %s, slope %u: %llu ticks, %llu with stops\n", cases[k].name, slope,
                   (unsigned long long)ticks, (unsigned long long)stops);
        }
    }
}

int main(void)
{
    check_t check = {0};
    CHECK_RUN(&check, nothing_is_slower_than_with_a_stop_at_every_corner);
    return check_end(&check);
}
