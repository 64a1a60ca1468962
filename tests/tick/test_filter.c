// SPDX-License-Identifier: MIT
// The filter of tick/6_interpolate under the jerk-limited slope: it lands exactly on every stop,
// adds no contour error, is settled before a dwell begins, and the plan counts its ticks as the run
// does.
#include <string.h> // memcmp

#include "host/host.h" // nck_host_plan_…
#include "motion_check.h"

static motion_t motion;
static nck_t nck;
static nck_host_plan_t plan;

static void begin(int family, double period)
{
    motion_begin(&motion, 50 + (uint64_t)family);
    motion_scale(&motion, period, 1.0, 1.0);
    motion_program(&motion, &motion_family[family], 0.15);
}

static uint64_t plan_ticks(void)
{
    nck_host_plan_init(&plan, &nck, &motion.machine, motion.text, motion.size);
    while (nck_host_plan_run(&plan) == NCK_OK) continue;
    return plan.totals.ticks;
}

static void plan_counts_the_ticks_of_the_run(check_t *check)
{
    const double periods[] = {1e-3, 5e-4, 4e-3};
    for (int family = 0; family < MOTION_FAMILIES; family++) {
        begin(family, periods[family % 3]);
        CHECK(check, motion_run(&motion, NULL));
        CHECK_INT(check, plan_ticks(), motion.ticks);
    }
}

static int stands_at_end_of(const nck_seg_t *seg)
{
    for (int x = 0; x < NCK_AXIS_MAX; x++) {
        if (motion.pose.axis[x] != seg->end[x]) return 0;
    }
    return motion.pose.v == 0.0;
}

// Every stop of the program is stood on at some tick, to the bit and to the nanometre.
static void every_stop_is_landed_on_exactly(check_t *check)
{
    for (int family = 0; family < MOTION_FAMILIES; family++) {
        uint32_t stop = 0; // next seg that may have to be landed on
        begin(family, 1e-3);
        motion.status = motion_start(&motion);
        int goes_on = 1;
        while (goes_on) {
            goes_on = motion_tick(&motion, NULL);
            while (stop < motion.segs && !motion.seg[stop].stop) stop++;
            if (stop < motion.segs && stands_at_end_of(&motion.seg[stop])) stop++;
        }
        while (stop < motion.segs && !motion.seg[stop].stop) stop++;
        CHECK_INT(check, stop, motion.segs);
        const nck_seg_t *const last = &motion.seg[motion.segs - 1];
        for (int x = 0; x < 3; x++) {
            const double counts = last->end[x] * (double)NCK_COUNTS_PER_MM;
            CHECK_INT(check, motion.axes.joint_nm[x], (int64_t)floor(counts + 0.5));
        }
    }
}

static void filter_adds_no_contour_error(check_t *check)
{
    for (int family = 0; family < MOTION_FAMILIES; family++) {
        begin(family, 1e-3);
        (void)motion_run(&motion, NULL);
        CHECK(check, motion.peak.off <= 1e-12 * (1.0 + motion.peak.s));
        CHECK(check, motion.peak.back == 0.0);
    }
}

// A dwell of 20 periods keeps the axes still for 20 ticks, and no more than the filter's longer.
static void dwell_begins_when_the_path_rests(check_t *check)
{
    motion_begin(&motion, 1);
    motion_line(&motion, "G61 G1 F3000 X5");
    motion_line(&motion, "G4 P0.02");
    motion_line(&motion, "X9");
    motion_line(&motion, "M2");
    motion.status = motion_start(&motion);
    int still = 0;
    int dwells = 0;
    while (motion_tick(&motion, NULL)) {
        still += motion.pose.axis[0] == 5.0;
        dwells += motion.pose.state == NCK_TICK_DWELL;
        CHECK(check, motion.pose.state != NCK_TICK_DWELL || motion.pose.axis[0] == 5.0);
    }
    CHECK_INT(check, dwells, 20);
    CHECK(check, still >= 20 && still <= 20 + NCK_FILTER_TAPS);
}

// Where the cells cruise, the mean moves as they do: the filter delays, it does not slow down.
static void cruise_keeps_its_speed(check_t *check)
{
    motion_begin(&motion, 1);
    motion_line(&motion, "G61 G1 F3000 X40");
    motion_line(&motion, "M2");
    motion.status = motion_start(&motion);
    int cruises = 0;
    while (motion_tick(&motion, NULL)) {
        const double v = (motion.s[3] - motion.s[2]) / motion.machine.period_s;
        if (motion.pose.s < 15.0 || motion.pose.s > 25.0) continue;
        CHECK(check, v <= 50.0 * (1.0 + 1e-9));
        cruises += fabs(v - 50.0) <= 1e-6;
    }
    CHECK(check, NCK_PROFILE < 256 || cruises >= 199);
}

int main(void)
{
    check_t check = {0};
    CHECK_RUN(&check, plan_counts_the_ticks_of_the_run);
    CHECK_RUN(&check, every_stop_is_landed_on_exactly);
    CHECK_RUN(&check, filter_adds_no_contour_error);
    CHECK_RUN(&check, dwell_begins_when_the_path_rests);
    CHECK_RUN(&check, cruise_keeps_its_speed);
    return check_end(&check);
}
