// SPDX-License-Identifier: MIT
// The classical S-shape through the whole kernel, in every capacity: limits of speed, acceleration
// and jerk hold at every tick, acceleration is zero at junctions, a run depends on the program and
// not on the pace, a hold comes to rest soon, and N blocks of look-ahead are N blocks.
#include <string.h> // memcmp

#include "host/sshape.h" // nck_host_slope
#include "motion_check.h"

enum { LINES = 40 };

static motion_t motion;

typedef struct setting {
    const char *name;
    double period, a, j; // [s], times the default machine's limits
    uint32_t blocks;     // of look-ahead
    double longest;      // mean length of moves: longer ones take too long to test [mm]
} setting_t;

static const setting_t settings[] = {
    {"T 1 ms", 1e-3, 1.0, 1.0, 0, 100.0},
    {"T 4 ms", 4e-3, 1.0, 1.0, 0, 100.0},
    {"one block", 1e-3, 1.0, 1.0, 1, 100.0},
    {"five blocks", 5e-4, 1.0, 1.0, 5, 100.0},
    {"high j", 1e-3, 1.0, 100.0, 0, 100.0},
    {"low j", 1e-3, 1.0, 0.01, 0, 0.1},
    {"high a", 1e-3, 100.0, 1.0, 0, 100.0},
    {"low a, high j", 1e-3, 0.01, 100.0, 8, 0.1},
};
enum { SETTINGS = (int)(sizeof settings / sizeof settings[0]) };

static void begin(int family, int setting, double mixed)
{
    const setting_t *const s = &settings[setting];
    motion_begin(&motion, 11 + (uint64_t)family);
    motion.machine.slope = NCK_SLOPE_SSHAPE;
    motion.machine.lookahead_blocks = s->blocks;
    motion_scale(&motion, s->period, s->a, s->j);
    motion_program(&motion, &motion_family[family], mixed);
}

static int takes_too_long(int family, int setting)
{
    return motion_family[family].length > settings[setting].longest;
}

static void check_run_of(check_t *check, int over, const char *what)
{
    const motion_t *const m = &motion;
    if (!CHECK(check, over && m->error == NCK_OK && m->early == 0)) {
        printf("    %s: over %d error %d early %u ticks %llu state %u\n", what, over, m->error,
               m->early, (unsigned long long)m->ticks, m->pose.state);
    }
    motion_holds(check, m, what);
}

static void limits_hold_at_every_tick_on_every_machine(check_t *check)
{
    for (int k = 0; k < MOTION_FAMILIES * SETTINGS * 2; k++) {
        const int family = k / 2 % MOTION_FAMILIES;
        const int setting = k / 2 / MOTION_FAMILIES;
        char name[120];
        if (takes_too_long(family, setting)) continue;
        snprintf(name, sizeof name, "%s, %s, mixed %d", motion_family[family].name,
                 settings[setting].name, k % 2);
        begin(family, setting, k % 2 ? 0.1 : 0.0);
        check_run_of(check, motion_run(&motion, NULL), name);
        CHECK_INT(check, motion.starved, 0);
        const nck_seg_t *const last = &motion.seg[motion.segs - 1];
        CHECK_NEAR(check, motion.peak.s, last->s_begin + last->length, 1e-12);
        for (int x = 0; x < 3; x++) CHECK(check, motion.pose.axis[x] == last->end[x]);
    }
}

// ---- pace

static uint32_t few_steps(void *user, uint64_t tick)
{
    (void)tick;
    return (uint32_t)(*(const double *)user * motion_random(&motion.seed));
}

static uint32_t enough_steps(void *user, uint64_t tick)
{
    return tick == 0 ? MOTION_STEPS : *(const uint32_t *)user;
}

static void starvation_keeps_limits_path_and_end(check_t *check)
{
    double most[] = {3.0, 12.0, 60.0};
    for (int k = 0; k < 3 * MOTION_FAMILIES; k++) {
        const int family = k % MOTION_FAMILIES;
        const motion_script_t script = {few_steps, NULL, &most[k / MOTION_FAMILIES]};
        begin(family, k % 4, 0.1);
        check_run_of(check, motion_run(&motion, NULL), motion_family[family].name);
        const nck_axes_t end = motion.axes;
        const uint32_t outputs = motion.outputs;
        check_run_of(check, motion_run(&motion, &script), motion_family[family].name);
        CHECK(check, memcmp(&end, &motion.axes, sizeof end) == 0);
        CHECK_INT(check, motion.outputs, outputs);
    }
}

static void setpoints_depend_on_the_program_not_on_the_pace(check_t *check)
{
    uint32_t steps[] = {150, 600};
    int starved = 0;
    for (int k = 0; k < 2 * MOTION_FAMILIES; k++) {
        const int family = k % MOTION_FAMILIES;
        const motion_script_t script = {enough_steps, NULL, &steps[k / MOTION_FAMILIES]};
        begin(family, k % 4, 0.0);
        check_run_of(check, motion_run(&motion, NULL), motion_family[family].name);
        const uint64_t hash = motion.hash;
        check_run_of(check, motion_run(&motion, &script), motion_family[family].name);
        starved += motion.starved > 0;
        if (!CHECK(check, motion.starved > 0 || motion.hash == hash)) {
            printf("    %s\n", motion_family[family].name);
        }
    }
    CHECK(check, starved < MOTION_FAMILIES);
}

// ---- the operator

typedef struct hand {
    uint64_t seed;
    uint64_t held_at; // tick; 0: not held
    uint64_t longest; // ticks from a hold to rest
} hand_t;

// Hold, see it come to rest, go on.
static void hold_at_random(void *user, uint64_t tick)
{
    hand_t *const hand = user;
    const int rests = motion.pose.v == 0.0 && motion.s[3] == motion.s[2];
    if (hand->held_at > 0 && rests && motion.pose.state == NCK_TICK_HOLD) {
        if (tick - hand->held_at > hand->longest) hand->longest = tick - hand->held_at;
        hand->held_at = 0;
        nck_resume(&motion.nck);
        return;
    }
    if (hand->held_at > 0 || motion_random(&hand->seed) > 0.02) return;
    hand->held_at = tick;
    nck_hold(&motion.nck);
}

// The default machine: a ramp takes 0.2 s, a cell of it 0.1 s at most. Before the brake come what
// is final, 20 periods and a cell, and the part in work, 50 periods and a ramp.
static void a_hold_comes_to_rest_soon_and_the_program_to_its_end(check_t *check)
{
    const uint64_t soon = 20 + 100 + 50 + 200 + 200;
    for (int family = 0; family < MOTION_FAMILIES; family++) {
        hand_t hand = {99, 0, 0};
        const motion_script_t script = {NULL, hold_at_random, &hand};
        begin(family, 0, 0.0);
        check_run_of(check, motion_run(&motion, NULL), motion_family[family].name);
        const nck_axes_t end = motion.axes;
        check_run_of(check, motion_run(&motion, &script), motion_family[family].name);
        CHECK(check, memcmp(&end, &motion.axes, sizeof end) == 0);
        if (family == 0 && !CHECK(check, hand.longest > 100 && hand.longest <= soon)) {
            printf("    longest %llu\n", (unsigned long long)hand.longest);
        }
    }
}

static void abort_in_the_middle(void *user, uint64_t tick)
{
    if (tick == *(const uint64_t *)user) nck_abort(&motion.nck);
}

static void an_abort_comes_to_rest_and_drops_the_rest(check_t *check)
{
    for (int family = 0; family < MOTION_FAMILIES; family++) {
        uint64_t when = 150;
        const motion_script_t script = {NULL, abort_in_the_middle, &when};
        begin(family, 0, 0.0);
        check_run_of(check, motion_run(&motion, &script), motion_family[family].name);
        (void)motion_tick(&motion, &script);
        CHECK_INT(check, motion.pose.state, NCK_TICK_HOLD);
        CHECK(check, motion.pose.v == 0.0 && motion.ticks < 1200);
    }
}

// ---- look-ahead

static double length[LINES], v_cap[LINES], a_max[LINES], j_max[LINES], v_node[LINES + 1];
static double v_out[LINES + 1];
static nck_cell_t cells[NCK_HOST_SLOPE_CELLS * LINES];

// Collinear moves of random feeds: no junction costs anything, so both plan the same numbers.
static void make_lines(uint64_t seed)
{
    double x = 0.0;
    motion_begin(&motion, seed);
    motion.machine.slope = NCK_SLOPE_SSHAPE;
    motion_line(&motion, "G21 G90 G61");
    for (int i = 0; i < LINES; i++) {
        char words[60];
        const double step = floor(1e3 * motion_random_decades(&motion.seed, 0.05, 8.0)) / 1e3;
        const double feed = floor(motion_random_decades(&motion.seed, 300.0, 6000.0));
        x += step;
        snprintf(words, sizeof words, "G1 X%.3f F%.0f", x, feed);
        motion_line(&motion, words);
        length[i] = step;
        v_cap[i] = feed / 60.0;
        a_max[i] = motion.machine.path.a_max;
        j_max[i] = motion.machine.path.j_max;
        v_node[i] = i == 0 ? 0.0 : fmin(v_cap[i - 1], v_cap[i]);
    }
    v_node[LINES] = 0.0;
    motion_line(&motion, "M2");
}

// Rests cost up to a period each. Speeds at caps are lower by what the caps leave to a filter.
static void n_blocks_of_look_ahead_are_those_of_whole_programs(check_t *check)
{
    for (int k = 0; k < 60; k++) {
        const uint32_t n = (uint32_t)(k % 12);
        size_t count = 0;
        size_t bad = 0;
        double time = 0.0;
        int rests = 0;
        make_lines(1000 + (uint64_t)k);
        motion.machine.lookahead_blocks = n + 1;
        const nck_host_path_t path = {length, v_cap, a_max, j_max, v_node, LINES, n,
                                      NCK_HOST_RAMP_SSHAPE, 0.0, NULL};
        CHECK_INT(check, nck_host_slope(&path, v_out, cells, &count, &bad), NCK_OK);
        for (size_t i = 0; i < count; i++) {
            time += cells[i].duration;
            rests += cells[i].stop != 0;
        }
        check_run_of(check, motion_run(&motion, NULL), "collinear lines");
        const double ticks = (double)motion.ticks * motion.machine.period_s;
        const double more = ticks - time;
        const double most = ((double)rests + 1.0) * motion.machine.period_s + 1e-3 * time;
        if (!CHECK(check, more >= -1e-3 && more <= most)) {
            printf("    N %u: %.4f s, whole %.4f s, rests %d\n", n, ticks, time, rests);
        }
    }
}

static void hold_twice(void *user, uint64_t tick)
{
    (void)user;
    if (tick == 2000 || tick == 6000) nck_hold(&motion.nck);
    if (tick == 4000 || tick == 8000) nck_resume(&motion.nck);
}

// Hundreds of stretches of cruise, drawn one after the other: their roundings once added up to a
// step of path at the run's end, 1e-4 of the jerk.
static void a_long_cruise_ends_where_its_run_does(check_t *check)
{
    const motion_script_t script = {NULL, hold_twice, NULL};
    motion_begin(&motion, 1);
    motion.machine.slope = NCK_SLOPE_SSHAPE;
    motion_scale(&motion, 5e-4, 1.0, 0.01);
    motion_line(&motion, "G21 G90 G61 G1 X426.1 F2961");
    motion_line(&motion, "X431.1 F100");
    motion_line(&motion, "M2");
    check_run_of(check, motion_run(&motion, &script), "a long cruise");
}

int main(void)
{
    check_t check = {0};
    CHECK_RUN(&check, limits_hold_at_every_tick_on_every_machine);
    CHECK_RUN(&check, starvation_keeps_limits_path_and_end);
    CHECK_RUN(&check, setpoints_depend_on_the_program_not_on_the_pace);
    CHECK_RUN(&check, a_hold_comes_to_rest_soon_and_the_program_to_its_end);
    CHECK_RUN(&check, an_abort_comes_to_rest_and_drops_the_rest);
    CHECK_RUN(&check, n_blocks_of_look_ahead_are_those_of_whole_programs);
    CHECK_RUN(&check, a_long_cruise_ends_where_its_run_does);
    return check_end(&check);
}
