// SPDX-License-Identifier: MIT
// An override at speed is met as soon as the jerk lets it, and no limit breaks on the way.
#include <math.h>   // fabs fmax sqrt
#include <string.h> // strlen

#include "motion_check.h"

static const char text[] = "G21 G90 G61 G1 X400 F6000\nM2\n";

static nck_t nck;

// Run the program; at tick 1000 the override changes. Returns the ticks until the new speed is met,
// and the largest acceleration and jerk over their limits.
static int ticks_to_meet(uint32_t percent, double *peak_out)
{
    nck_machine_t machine;
    nck_pose_t pose;
    nck_axes_t axes;
    size_t used = 0;
    double s[4] = {0.0, 0.0, 0.0, 0.0};
    int met = 0;
    nck_machine_default(&machine);
    machine.slope = NCK_SLOPE_JERK;
    machine.axis[0].v_max = 200.0;
    machine.path.feed_max = 200.0;
    *peak_out = 0.0;
    (void)nck_init(&nck, &machine, NULL);
    (void)nck_push(&nck, text, strlen(text), &used);
    nck_end(&nck);
    for (int tick = 1; tick < 3000; tick++) {
        while (nck_prep(&nck) == NCK_OK) continue;
        if (tick == 1000) nck_set_override(&nck, percent * NCK_PERCENT, 100 * NCK_PERCENT);
        (void)nck_tick(&nck, &pose, &axes);
        memmove(s, s + 1, 3 * sizeof *s);
        s[3] = pose.s;
        const double a = fabs(s[3] - 2.0 * s[2] + s[1]) / 1e-6;
        const double j = fabs(s[3] - 3.0 * s[2] + 3.0 * s[1] - s[0]) / 1e-9;
        *peak_out = fmax(*peak_out, fmax(a / machine.path.a_max, j / machine.path.j_max));
        if (tick > 1000 && !met && fabs(pose.v - (double)percent) < 0.5) met = tick - 1000;
    }
    return met;
}

static void an_override_is_met_as_soon_as_the_jerk_lets_it(check_t *check)
{
    static const uint32_t percent[] = {1, 10, 50, 90, 99, 110, 150, 200};
    const double a = 1000.0;
    const double j = 10000.0;
    for (int k = 0; k < 8; k++) {
        double peak = 0.0;
        const int met = ticks_to_meet(percent[k], &peak);
        const double dv = fabs((double)percent[k] - 100.0);
        const double ramp = dv * j <= a * a ? 2.0 * sqrt(dv / j) : dv / a + a / j;
        CHECK(check, peak <= 1.0 + 1e-6);
        if (NCK_PROFILE < 256) continue; // a short window never gets to that speed
        if (!CHECK(check, met > 0 && met <= (int)(1150.0 * ramp) + 20)) {
            printf("    %u %%: %d ticks, the ramp takes %.0f\n", percent[k], met, 1000.0 * ramp);
        }
    }
}

static motion_t motion;

// Above 100 % an arc leaves less acceleration along the path. It does so until the speed has come
// down, also if the plan of what follows the next rest was begun meanwhile.
static void an_override_lowered_twice_keeps_the_acceleration_on_an_arc(check_t *check)
{
    for (uint64_t tick = 300; tick < 500; tick += 20) {
        motion_begin(&motion, 1);
        motion_scale(&motion, 1e-3, 1.0, 20.0);
        motion_line(&motion, "G21 G90 G17 G61 G2 I5 F1900");
        motion_line(&motion, "G4 P0.1");
        motion_line(&motion, "G1 Y5");
        motion_line(&motion, "M2");
        motion.status = motion_start(&motion);
        nck_set_override(&motion.nck, 200 * NCK_PERCENT, 100 * NCK_PERCENT);
        while (motion.ticks < tick) (void)motion_tick(&motion, NULL);
        nck_set_override(&motion.nck, 95 * NCK_PERCENT, 100 * NCK_PERCENT);
        while (motion.ticks < tick + 12) (void)motion_tick(&motion, NULL);
        nck_set_override(&motion.nck, 30 * NCK_PERCENT, 100 * NCK_PERCENT);
        while (motion_tick(&motion, NULL)) continue;
        CHECK(check, motion.is_over);
        motion_holds(check, &motion, "an override lowered twice");
    }
}

// What a change finds on the way to a sharp corner can brake to rest there but for rounding, which
// is no speed to pass the corner at.
static void an_override_on_the_way_to_a_corner_rests_at_it_under_the_linear_slope(check_t *check)
{
    for (uint64_t tick = 800; tick < 1540; tick += 3) {
        motion_begin(&motion, 1);
        motion.machine.slope = NCK_SLOPE_LINEAR;
        motion_scale(&motion, 1e-3, 0.1, 1e6); // jerk is not limited
        motion.machine.path.a_max = 1e3;       // nor the path, but the axes
        motion_line(&motion, "G21 G90 G61 G1 X60 F6000");
        motion_line(&motion, "X3 Y-23");
        motion_line(&motion, "M2");
        motion.status = motion_start(&motion);
        while (motion.ticks < tick) (void)motion_tick(&motion, NULL);
        (void)nck_set_override(&motion.nck, 120 * NCK_PERCENT, 100 * NCK_PERCENT);
        while (motion_tick(&motion, NULL)) continue;
        CHECK(check, motion.is_over);
        motion_holds(check, &motion, "an override before a corner");
    }
}

// The envelope of the speeds before it is none of those behind it, in no block.
static void a_lowered_override_is_kept_in_every_block_under_the_linear_slope(check_t *check)
{
    double v_most = 0.0;
    motion_begin(&motion, 1);
    motion.machine.slope = NCK_SLOPE_LINEAR;
    motion_line(&motion, "G21 G90 G61 G1 X10 F3000");
    for (int k = 2; k <= 9; k++) {
        char words[40];
        snprintf(words, sizeof words, "X%d", 10 * k);
        motion_line(&motion, words);
    }
    motion_line(&motion, "M2");
    motion.status = motion_start(&motion);
    motion_to(&motion, 5.0);
    (void)nck_set_override(&motion.nck, 40 * NCK_PERCENT, 100 * NCK_PERCENT);
    motion_to(&motion, 9.0);
    while (motion_tick(&motion, NULL)) v_most = fmax(v_most, motion.s[3] - motion.s[2]);
    CHECK(check, motion.is_over);
    CHECK_NEAR(check, v_most, 20e-3, 1e-9);
}

// A speed of the tool that the operator allows holds in feeds and rapids, from 2 s on, and at any
// override; under a mixed move the tool has it, and the path is faster.
static void the_tool_is_no_faster_than_the_operator_allows(check_t *check)
{
    for (uint32_t slope = NCK_SLOPE_LINEAR; slope <= NCK_SLOPE_JERK; slope++) {
        double v_most = 0.0, rapid_most = 0.0;
        motion_begin(&motion, 1);
        motion.machine.slope = slope;
        if (slope == NCK_SLOPE_LINEAR) motion_scale(&motion, 1e-3, 1.0, 1e6);
        motion_line(&motion, "G21 G90 G61 G1 X100 F3000");
        motion_line(&motion, "G0 X0");
        motion_line(&motion, "M2");
        motion.status = motion_start(&motion);
        nck_set_override(&motion.nck, 1999000, 995000);
        while (motion.ticks < 500) (void)motion_tick(&motion, NULL);
        nck_set_speed(&motion.nck, 30500);
        while (motion.ticks < 1000) (void)motion_tick(&motion, NULL);
        while (motion_tick(&motion, NULL)) {
            double *const most = motion.pose.rapid ? &rapid_most : &v_most;
            *most = fmax(*most, motion.pose.v);
        }
        CHECK(check, motion.is_over);
        motion_holds(check, &motion, "a speed that the operator allows");
        CHECK(check, v_most <= 30.5 + 1e-6 && rapid_most <= 30.5 + 1e-6);
        if (NCK_PROFILE < 256) continue; // a short window never gets to that speed
        CHECK_NEAR(check, v_most, 30.5, 0.01);
        CHECK_NEAR(check, rapid_most, 30.5, 0.01);
    }
}

// An override counts in millionths; what is more than 200 and 100 % is the most.
static void an_override_counts_in_millionths(check_t *check)
{
    nck_command_t asked;
    double v_most = 0.0;
    motion_begin(&motion, 1);
    motion.machine.slope = NCK_SLOPE_LINEAR;
    motion_line(&motion, "G21 G90 G61 G1 X100 F3000");
    motion_line(&motion, "M2");
    motion.status = motion_start(&motion);
    nck_set_override(&motion.nck, 777123, 1000000);
    while (motion_tick(&motion, NULL)) v_most = fmax(v_most, motion.pose.v);
    CHECK_NEAR(check, v_most, 0.777123 * 50.0, 1e-6);
    for (uint32_t unit = 0; unit < 2; unit++) {
        if (unit == 0) nck_set_override(&motion.nck, UINT32_MAX, UINT32_MAX);
        if (unit == 1) nck_set_override(&motion.nck, 2000001, 1000001);
        nck_asked(&motion.nck, &asked);
        CHECK(check, asked.feed_ppm == 2000000 && asked.rapid_ppm == 1000000);
        nck_set_override(&motion.nck, 100 * NCK_PERCENT, 100 * NCK_PERCENT);
    }
}

// A dwell between a rapid and a feed, in which the operator stops one of both. Returns where the
// tool is after more ticks than all of the rest takes.
static double stopped_between(uint8_t slope, int rapid_first, int stops_rapid, int into)
{
    enum { ENOUGH = 1500 };
    int since = 0;
    motion_begin(&motion, 1);
    motion.machine.slope = slope;
    motion_line(&motion, rapid_first ? "G21 G90 G61 G0 X10" : "G21 G90 G61 G1 X10 F3000");
    motion_line(&motion, "G4 P0.2");
    motion_line(&motion, rapid_first ? "G1 X20 F3000" : "G0 X20");
    motion_line(&motion, "M2");
    motion.status = motion_start(&motion);
    while (motion_tick(&motion, NULL) && since < ENOUGH) {
        since += motion.pose.s >= 10.0;
        if (since != into) continue;
        if (stops_rapid) nck_set_override(&motion.nck, 100 * NCK_PERCENT, 0);
        else nck_set_override(&motion.nck, 0, 100 * NCK_PERCENT);
    }
    return motion.pose.s;
}

// Feeds at 0 % stop no rapid, rapids at 0 % no feed: of a path that rests the next motion counts.
static void what_is_stopped_is_the_motion_that_comes_next(check_t *check)
{
    static const uint8_t slope[] = {NCK_SLOPE_LINEAR, NCK_SLOPE_JERK};
    uint64_t seed = 91;
    for (int n = 0; n < 64; n++) {
        const int first = n & 1, stops = n >> 1 & 1, k = n >> 2 & 1;
        const int into = 1 + (int)(motion_random(&seed) * 150.0);
        const double s = stopped_between(slope[k], first, stops, into);
        CHECK_NEAR(check, s, first == stops ? 20.0 : 10.0, 1e-9);
    }
}

enum { STEPS_A_TICK = 48, // with so little prep a plan takes up to 30 ticks
       FOLLOWED = 150 };  // ticks: three such plans, and a ramp of 5 mm/s

// Ticks until the tool has its feed [mm/s], from the last one of overrides that go up.
static int ticks_to_follow(double feed, int apart)
{
    static const uint32_t ppm[] = {20000, 450000, 900000, 1000000};
    const int begin = 60;
    char words[40];
    motion_begin(&motion, 1);
    snprintf(words, sizeof words, "G21 G90 G61 G1 X50 F%.0f", 60.0 * feed);
    motion_line(&motion, words);
    motion_line(&motion, "M2");
    motion.status = motion_start(&motion);
    for (int tick = 0; tick < begin + 2 * apart + 1000; tick++) {
        const int k = tick < begin ? 0 : 1 + (tick - begin) / apart;
        nck_set_override(&motion.nck, ppm[k < 3 ? k : 3], 1000000);
        for (int n = 0; n < STEPS_A_TICK && motion_prep(&motion); n++) continue;
        (void)nck_tick(&motion.nck, &motion.pose, &motion.axes);
        const double v = motion.pose.v * motion.pose.feed_scale;
        if (v > 0.97 * feed) return tick - (begin + 2 * apart);
    }
    return 1000;
}

// A ladder for far lower speeds is passed in no time. As many cells of another one last up to a
// second, which no answer waits for.
static void overrides_that_go_up_in_steps_are_followed_at_once(check_t *check)
{
    static const double feed[] = {0.3, 1.0, 5.0};
    for (int k = 0; k < 3; k++) {
        for (int apart = 10; apart <= 60; apart += 5) {
            const int met = ticks_to_follow(feed[k], apart);
            if (CHECK(check, met <= FOLLOWED)) continue;
            printf("    %.1f mm/s, %d apart: %d ticks\n", feed[k], apart, met);
        }
    }
}

#if NCK_AXIS_MAX > 3
// Degrees are no millimetres: a table that turns alone does not heed the tool's speed.
static void a_rotary_axis_alone_does_not_heed_the_speed_of_the_tool(check_t *check)
{
    double v_most[2] = {0.0, 0.0};
    motion_begin(&motion, 1);
    motion.machine.axis[NCK_AXIS_A].present = 1;
    motion_line(&motion, "G21 G90 G61 G1 A60 F3000");
    motion_line(&motion, "X40 A120 F1200");
    motion_line(&motion, "M2");
    motion.status = motion_start(&motion);
    nck_set_speed(&motion.nck, 10000);
    while (motion_tick(&motion, NULL)) {
        double *const most = &v_most[motion.pose.line == 2];
        *most = fmax(*most, motion.pose.v * motion.pose.feed_scale);
    }
    CHECK(check, motion.is_over);
    CHECK_NEAR(check, v_most[0], 50.0, 1e-6);
    CHECK_NEAR(check, v_most[1], 10.0, 1e-4);
}
#endif

int main(void)
{
    check_t check = {0};
    CHECK_RUN(&check, an_override_is_met_as_soon_as_the_jerk_lets_it);
    CHECK_RUN(&check, an_override_lowered_twice_keeps_the_acceleration_on_an_arc);
    CHECK_RUN(&check, an_override_on_the_way_to_a_corner_rests_at_it_under_the_linear_slope);
    CHECK_RUN(&check, a_lowered_override_is_kept_in_every_block_under_the_linear_slope);
    CHECK_RUN(&check, the_tool_is_no_faster_than_the_operator_allows);
    CHECK_RUN(&check, overrides_that_go_up_in_steps_are_followed_at_once);
    CHECK_RUN(&check, an_override_counts_in_millionths);
    CHECK_RUN(&check, what_is_stopped_is_the_motion_that_comes_next);
#if NCK_AXIS_MAX > 3
    CHECK_RUN(&check, a_rotary_axis_alone_does_not_heed_the_speed_of_the_tool);
#endif
    return check_end(&check);
}
