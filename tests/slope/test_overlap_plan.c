// SPDX-License-Identifier: MIT
// Room 5 in the kernel: at a sharp corner within the tolerance the stop and the start behind it
// overlap, under every limit, whatever the operator does meanwhile; without a next plan in time the
// path rests.
#include "motion_check.h"

#define TOLERANCE 0.01
enum { PAUSE = 150, STALL = 300, // ticks
       FEW = NCK_CELL_MAX < 64 }; // 1: few cells are withheld, motions overlap for a shorter time

typedef struct corner {
    const char *mode, *line; // words before X10, and the line behind it
    double end[2];
} corner_t;

static const corner_t right_angle = {"G64 P0.01", "Y10", {10.0, 10.0}};

static motion_t motion;
static uint64_t at;      // the operator does something at this tick
static uint32_t percent; // override that he sets then; 0: he holds the path, for some ticks
static uint64_t stall;   // from this tick on prep does nothing for some ticks; 0: it works
static uint64_t pace;    // 1 and more: state of random numbers, prep takes 0 … 2 steps a tick
static double worst;     // distance from the nearer of both lines [mm]

static void begin(const corner_t *corner)
{
    motion_begin(&motion, 1);
    motion_line(&motion, "G21 G90");
    motion_line(&motion, corner->mode);
    motion_line(&motion, "G1 X10 F6000");
    motion_line(&motion, corner->line);
}

// Distance from a line between two points of the XY plane.
static double off_line(const double *p, const double a[2], const double b[2])
{
    const double d[2] = {b[0] - a[0], b[1] - a[1]};
    const double along = (p[0] - a[0]) * d[0] + (p[1] - a[1]) * d[1];
    const double share = fmin(1.0, fmax(0.0, along / (d[0] * d[0] + d[1] * d[1])));
    return hypot(p[0] - a[0] - share * d[0], p[1] - a[1] - share * d[1]);
}

static void operate(void *user, uint64_t tick)
{
    (void)user;
    if (at == 0) return;
    const uint32_t ppm = percent * NCK_PERCENT;
    if (tick == at && percent > 0) nck_set_override(&motion.nck, ppm, 100 * NCK_PERCENT);
    if (tick == at && percent == 0) nck_hold(&motion.nck);
    if (tick == at + PAUSE) nck_resume(&motion.nck);
}

static uint32_t steps_of(void *user, uint64_t tick)
{
    (void)user;
    if (pace > 0) return (uint32_t)(3.0 * motion_random(&pace));
    return stall > 0 && tick >= stall && tick < stall + STALL ? 0 : MOTION_STEPS;
}

// All of a program, as the operator and prep let it. Returns the ticks that it takes.
static uint64_t run(check_t *check, const corner_t *corner)
{
    static const double from[2] = {0.0, 0.0};
    static const double middle[2] = {10.0, 0.0};
    const motion_script_t script = {steps_of, operate, NULL};
    motion_line(&motion, "M2");
    (void)motion_start(&motion);
    worst = 0.0;
    while (motion_tick(&motion, &script)) {
        const double *const p = motion.pose.axis;
        const double off = fmin(off_line(p, from, middle), off_line(p, middle, corner->end));
        worst = fmax(worst, off);
        CHECK(check, motion.pose.left == 0.0 || motion.pose.left <= 1.0);
    }
    CHECK_INT(check, motion.is_over, 1);
    CHECK_INT(check, motion.error, NCK_OK);
    CHECK(check, motion.starved == 0 || stall > 0);
    CHECK_INT(check, nck_invariants(&motion.nck), 0);
    CHECK_INT(check, motion.axes.joint_nm[0], llround(corner->end[0] * 1e6));
    CHECK_INT(check, motion.axes.joint_nm[1], llround(corner->end[1] * 1e6));
    CHECK(check, worst <= TOLERANCE);
    (void)motion_holds(check, &motion, corner->line);
    return motion.ticks;
}

// Less time than with a rest, by at least as many periods.
static void overlap_saves(check_t *check, const corner_t *corner, uint64_t periods)
{
    corner_t exact = *corner;
    exact.mode = "G61.1";
    at = 0;
    begin(&exact);
    const uint64_t rests = run(check, &exact);
    CHECK_INT(check, motion.beside, 0);
    begin(corner);
    const uint64_t overlaps = run(check, corner);
    if (!CHECK(check, motion.beside > 0 && overlaps + periods <= rests)) {
        printf("    %s: %d ticks, %d with a rest\n", corner->line, (int)overlaps, (int)rests);
    }
}

static void a_stop_and_the_start_behind_it_overlap(check_t *check)
{
    static const corner_t slant = {"G64 P0.01", "X16 Y8", {16.0, 8.0}};
    static const corner_t back = {"G64 P0.01", "X2 Y6", {2.0, 6.0}};
    static const corner_t reversal = {"G64 P0.01", "X2", {2.0, 0.0}};
    overlap_saves(check, &right_angle, FEW ? 15 : 30);
    if (!FEW) overlap_saves(check, &slant, 15);
    overlap_saves(check, &back, FEW ? 15 : 25);
    overlap_saves(check, &reversal, 15);
    CHECK(check, worst <= 1e-12); // no more than along X
}

// The corner is cut as far as it may be, nearly.
static void the_tolerance_is_made_use_of(check_t *check)
{
    at = 0;
    begin(&right_angle);
    (void)run(check, &right_angle);
    CHECK(check, FEW || worst > 0.6 * TOLERANCE); // of the lines; of the corner √2 times as much
}

static void the_linear_slope_rests_there(check_t *check)
{
    at = 0;
    for (uint32_t slope = NCK_SLOPE_LINEAR; slope <= NCK_SLOPE_JERK; slope++) {
        begin(&right_angle);
        motion.machine.slope = slope;
        motion_line(&motion, "M2");
        CHECK_INT(check, motion_run(&motion, NULL), 1);
        CHECK_INT(check, motion.beside > 0, slope != NCK_SLOPE_LINEAR);
    }
}

// Held, and slowed down or sped up, at every tick around the corner.
static void limits_hold_whatever_the_operator_does(check_t *check)
{
    static const uint32_t percents[] = {0, 37, 150, 200};
    uint64_t first = 0;
    at = 0;
    begin(&right_angle);
    motion_line(&motion, "M2");
    (void)motion_start(&motion);
    while (motion.beside == 0 && motion_tick(&motion, NULL)) first = motion.ticks;
    for (int k = 0; k < 4; k++) {
        percent = percents[k];
        for (at = first - 40; at < first + 60 && !check->broken; at++) {
            begin(&right_angle);
            (void)run(check, &right_angle);
        }
        if (check->broken) printf("    at tick %d, %u %%\n", (int)at - 1, percent);
    }
    at = 0;
}


// There and back, or nearly so: what slows the first motion down pulls the same way as what speeds
// the second one up, and the filter mixes them. Short lines brake as soon as they overlap.
static void an_axis_that_moves_in_both_keeps_its_jerk(check_t *check)
{
    static const char *const backs[] = {"X-5", "X-4.33 Y2.5", "X-2.5 Y4.33", "X5 Y5"};
    uint32_t overlaps = 0;
    for (double length = 0.1; length < 0.5; length *= 1.02) {
        for (int k = 0; k < 4; k++) {
            char words[80];
            motion_begin(&motion, 1);
            snprintf(words, sizeof words, "G21 G91 G64 P0.01 Q0 G1 X%.6f F6000", length);
            motion_line(&motion, words);
            motion_line(&motion, backs[k]);
            motion_line(&motion, "M2");
            CHECK_INT(check, motion_run(&motion, NULL), 1);
            (void)motion_holds(check, &motion, words);
            overlaps += motion.beside > 0;
        }
    }
    CHECK(check, overlaps > 250);
}

// Nothing is known of what follows the second line: the path rests before it, as it would exactly,
// and nobody calls it starved.
static void a_path_that_is_not_known_further_rests(check_t *check)
{
    begin(&right_angle);
    motion_line(&motion, "X0");
    motion_line(&motion, "Y0");
    (void)motion_start(&motion);
    size_t used = 0;
    for (size_t n = 0; n < motion.size; n += used) {
        CHECK_INT(check, nck_push(&motion.nck, motion.text + n, motion.size - n, &used), NCK_OK);
        while (nck_prep(&motion.nck) == NCK_OK) continue;
    }
    nck_tick_state_t state = NCK_TICK_MOVE;
    uint64_t ticks = 0;
    int withheld = 0;
    for (; state == NCK_TICK_MOVE; ticks++) {
        while (nck_prep(&motion.nck) == NCK_OK) continue;
        withheld |= motion.nck.slope.now.withheld > 0;
        state = nck_tick(&motion.nck, &motion.pose, &motion.axes);
        CHECK(check, motion.pose.left == 0.0 && fabs(motion.pose.axis[1]) <= TOLERANCE);
    }
    CHECK(check, withheld && ticks > 100);
    CHECK_INT(check, state, NCK_TICK_IDLE);
    CHECK(check, fabs(motion.pose.axis[0] - 10.0) <= TOLERANCE); // at the corner, or outside of it
    nck_flush(&motion.nck);
    for (int k = 0; k < 4000; k++) {
        while (nck_prep(&motion.nck) == NCK_OK) continue;
        (void)nck_tick(&motion.nck, &motion.pose, &motion.axes);
    }
    CHECK(check, motion.pose.axis[0] == 0.0 && motion.pose.axis[1] == 0.0);
}

// Whenever prep does nothing for some time, what is final goes on to a rest within every limit: in
// the middle of both motions it is that of the second one.
static void a_late_prep_leaves_a_rest(check_t *check)
{
    uint32_t rests = 0;
    at = 0;
    for (stall = 20; stall < 400 && !check->broken; stall += 3) {
        begin(&right_angle);
        (void)run(check, &right_angle);
        rests += motion.starved > 0;
    }
    if (check->broken) printf("    from tick %d on\n", (int)stall - 3);
    CHECK(check, rests > 50);
    stall = 0;
}

// Prep that can hardly follow: the path rests again and again, short plans begin in its middle, and
// all of it is executed.
static void a_slow_prep_comes_to_the_end(check_t *check)
{
    const motion_script_t script = {steps_of, NULL, NULL};
    uint32_t rests = 0;
    at = 0;
    for (uint64_t seed = 1; seed <= 200 && !check->broken; seed++) {
        motion_begin(&motion, seed * 0x9e3779b97f4a7c15u);
        motion_line(&motion, "G21 G91 G64 P0.01 Q0 G1 F6000");
        for (int k = 0; k < 6; k++) {
            char words[80];
            const double length = motion_random_decades(&motion.seed, 0.05, 3.0);
            const double angle = 6.28 * motion_random(&motion.seed);
            snprintf(words, sizeof words, "X%.6f Y%.6f", length * cos(angle), length * sin(angle));
            motion_line(&motion, words);
        }
        motion_line(&motion, "M2");
        pace = motion.seed;
        (void)motion_start(&motion);
        while (motion_tick(&motion, &script) && motion.ticks < 20000) {
            CHECK_INT(check, nck_invariants(&motion.nck), 0);
        }
        CHECK_INT(check, motion.is_over, 1);
        (void)motion_holds(check, &motion, "slow");
        rests += motion.starved > 0;
        if (check->broken) printf("    seed %d\n", (int)seed);
    }
    CHECK(check, rests > 100);
    pace = 0;
}

int main(void)
{
    check_t check = {0};
    CHECK_RUN(&check, a_stop_and_the_start_behind_it_overlap);
    CHECK_RUN(&check, the_tolerance_is_made_use_of);
    CHECK_RUN(&check, the_linear_slope_rests_there);
    CHECK_RUN(&check, limits_hold_whatever_the_operator_does);
    CHECK_RUN(&check, an_axis_that_moves_in_both_keeps_its_jerk);
    CHECK_RUN(&check, a_path_that_is_not_known_further_rests);
    CHECK_RUN(&check, a_late_prep_leaves_a_rest);
    CHECK_RUN(&check, a_slow_prep_comes_to_the_end);
    return check_end(&check);
}
