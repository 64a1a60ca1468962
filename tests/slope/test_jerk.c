// SPDX-License-Identifier: MIT
// The jerk-limited slope through the whole kernel, in every capacity: limits of speed, acceleration
// and jerk hold at every tick, the path is kept, nothing is lost, and every run comes to its end.
#include <string.h> // memcmp

#include "motion_check.h"

static motion_t motion;

typedef struct setting {
    const char *name;
    double period, a, j; // [s], times the default machine's limits
    int slow;            // 1: long programs take too long to test
} setting_t;

static const setting_t settings[] = {
    {"T 1 ms", 1e-3, 1.0, 1.0, 0},
    {"T 0.5 ms", 5e-4, 1.0, 1.0, 0},
    {"T 4 ms", 4e-3, 1.0, 1.0, 0},
    {"low a, low j", 1e-3, 0.01, 0.01, 1},
    {"high j", 1e-3, 1.0, 100.0, 0},
    {"low j", 1e-3, 1.0, 0.01, 1},
    {"high a, high j", 1e-3, 100.0, 100.0, 0},
    {"high a", 1e-3, 100.0, 1.0, 0},
    {"low a, high j", 1e-3, 0.01, 100.0, 1},
};
enum { SETTINGS = (int)(sizeof settings / sizeof settings[0]), SHORT_MM = 1 };

// The program of a family on a machine; mixed: with stops, waits, outputs and reversals.
static void begin(int family, int setting, int mixed)
{
    const setting_t *const s = &settings[setting];
    motion_begin(&motion, 11 + (uint64_t)family);
    motion_scale(&motion, s->period, s->a, s->j);
    motion_program(&motion, &motion_family[family], mixed ? 0.1 : 0.0);
}

static int takes_too_long(int family, int setting)
{
    return settings[setting].slow && motion_family[family].length >= (double)SHORT_MM / 2.0;
}

// The run came to its end with everything done; limits held.
static void check_run_of(check_t *check, int over, const char *what)
{
    char name[160];
    const motion_t *const m = &motion;
    snprintf(name, sizeof name, "%s, %d bytes", what, (int)m->size);
    const int good = over && m->error == NCK_OK && m->early == 0;
    if (!CHECK(check, good)) {
        printf("    %s: over %d error %d early %u ticks %llu state %u\n", name, over, m->error,
               m->early, (unsigned long long)m->ticks, m->pose.state);
    }
    motion_holds(check, m, name);
}

static void check_family(check_t *check, int family, int setting, int mixed)
{
    char name[120];
    snprintf(name, sizeof name, "%s, %s, mixed %d", motion_family[family].name,
             settings[setting].name, mixed);
    begin(family, setting, mixed);
    check_run_of(check, motion_run(&motion, NULL), name);
    // In a ring of 16 cells the shortest ones, before a rest, may not last until prep comes again:
    // one stop of 40 periods, and a fiftieth of the time.
    CHECK(check, motion.starved <= (NCK_CELL_MAX < 64 ? 40 + motion.ticks / 50 : 0));
    const nck_seg_t *const last = &motion.seg[motion.segs - 1];
    CHECK(check, motion.peak.s == last->s_begin + last->length);
    for (int x = 0; x < 3; x++) CHECK(check, motion.pose.axis[x] == last->end[x]);
}

static void limits_hold_at_every_tick_on_every_machine(check_t *check)
{
    for (int family = 0; family < MOTION_FAMILIES; family++) {
        for (int setting = 0; setting < SETTINGS; setting++) {
            if (takes_too_long(family, setting)) continue;
            check_family(check, family, setting, 0);
            check_family(check, family, setting, 1);
        }
    }
}

// ---- pace

// Prep steps and pauses at random: from most starved to hardly.
typedef struct pace {
    uint64_t seed;
    uint32_t most;   // steps a tick
    uint32_t pauses; // ticks of a pause, at most
    uint32_t pause;  // ticks left of it
} pace_t;

static uint32_t steps_at_random(void *user, uint64_t tick)
{
    pace_t *const pace = user;
    (void)tick;
    if (pace->pause > 0) {
        pace->pause--;
        return 0;
    }
    if (motion_random(&pace->seed) < 0.01) {
        pace->pause = (uint32_t)(pace->pauses * motion_random(&pace->seed));
    }
    return 1 + (uint32_t)(pace->most * motion_random(&pace->seed));
}

static void starvation_keeps_limits_path_and_end(check_t *check)
{
    const pace_t paces[] = {{77, 1, 0, 0}, {78, 20, 100, 0}, {79, 50, 10, 0}};
    for (int family = 1; family < MOTION_FAMILIES; family++) {
        for (int k = 0; k < 3; k++) {
            const int crawls = k == 0 && motion_family[family].length > (double)SHORT_MM / 2.0;
            if (crawls) continue; // from stop to stop over a long path
            pace_t pace = paces[k];
            const motion_script_t script = {steps_at_random, NULL, &pace};
            begin(family, (family + k) % 3, k > 0);
            check_run_of(check, motion_run(&motion, NULL), motion_family[family].name);
            const nck_axes_t end = motion.axes;
            const uint32_t outputs = motion.outputs;
            check_run_of(check, motion_run(&motion, &script), motion_family[family].name);
            CHECK(check, memcmp(&end, &motion.axes, sizeof end) == 0);
            CHECK_INT(check, motion.outputs, outputs);
        }
    }
}

static uint32_t steps_of(void *user, uint64_t tick)
{
    const uint32_t *const steps = user;
    return tick == 0 ? MOTION_STEPS : *steps;
}

static void setpoints_depend_on_the_program_not_on_the_pace(check_t *check)
{
    uint32_t steps = 400;
    int starved = 0;
    const motion_script_t script = {steps_of, NULL, &steps};
    for (int family = 0; family < MOTION_FAMILIES; family++) {
        begin(family, 0, 1);
        check_run_of(check, motion_run(&motion, NULL), motion_family[family].name);
        const uint64_t hash = motion.hash;
        const uint64_t ticks = motion.ticks;
        check_run_of(check, motion_run(&motion, &script), motion_family[family].name);
        starved += motion.starved > 0;
        if (!CHECK(check, motion.starved > 0 || (motion.hash == hash && motion.ticks == ticks))) {
            printf("    %s\n", motion_family[family].name);
        }
    }
    CHECK(check, starved < MOTION_FAMILIES / 2);
}

static void outputs_come_in_order_behind_their_moves(check_t *check)
{
    begin(1, 0, 0);
    motion.size = 0;
    motion_line(&motion, "G61 G1 F3000");
    for (int k = 0; k < 200; k++) {
        char words[40];
        snprintf(words, sizeof words, "X%.3f S%d", 0.1 * (k + 1), 100 + k);
        motion_line(&motion, words);
    }
    motion_line(&motion, "M2");
    check_run_of(check, motion_run(&motion, NULL), "outputs");
    CHECK_INT(check, motion.outputs, 201);
    for (int k = 0; k < 200; k++) CHECK(check, motion.output[k].value == 100.0 + k);
}

// ---- the operator

// Commands at random ticks, as of a hand without mercy; after `last` ticks everything goes on.
typedef struct operator_hand {
    pace_t pace;
    uint64_t seed;
    double often;  // chance of a command in a tick
    uint64_t last; // tick
} operator_hand_t;

static uint32_t random_percent(uint64_t *seed, double most)
{
    const double chance = motion_random(seed);
    if (chance < 0.1) return 0;
    return chance < 0.3 ? 100 : (uint32_t)((most + 1.0) * motion_random(seed));
}

static void let_go_on(nck_t *nck)
{
    nck_set_override(nck, 100 * NCK_PERCENT, 100 * NCK_PERCENT);
    nck_set_single_block(nck, 0);
    nck_resume(nck);
}

static void command_at_random(void *user, uint64_t tick)
{
    operator_hand_t *const hand = user;
    nck_t *const nck = &motion.nck;
    if (tick == hand->last) let_go_on(nck);
    if (tick >= hand->last || motion_random(&hand->seed) > hand->often) return;
    switch ((int)(10.0 * motion_random(&hand->seed))) {
    case 0: nck_set_single_block(nck, motion_random(&hand->seed) < 0.3); return;
    case 1:
    case 2: nck_hold(nck); return;
    case 3:
    case 4:
    case 5: nck_resume(nck); return;
    default: {
        const uint32_t feed = random_percent(&hand->seed, 200.0);
        nck_set_override(nck, feed * NCK_PERCENT, random_percent(&hand->seed, 100.0) * NCK_PERCENT);
    }
    }
}

static uint32_t steps_of_hand(void *user, uint64_t tick)
{
    operator_hand_t *const hand = user;
    return hand->pace.most ? steps_at_random(&hand->pace, tick) : MOTION_STEPS;
}

static void check_operated(check_t *check, int family, int setting, uint64_t seed)
{
    char name[120];
    snprintf(name, sizeof name, "%s, %s, seed %d", motion_family[family].name,
             settings[setting].name, (int)seed);
    const double often = seed % 3 == 0 ? 0.1 : 0.01;
    const pace_t pace = {seed, seed == 2 ? 50 : 0, 10, 0};
    operator_hand_t hand = {pace, 1000003 * seed + 1, often, 2000};
    const motion_script_t script = {steps_of_hand, command_at_random, &hand};
    begin(family, setting, seed % 2 == 1);
    check_run_of(check, motion_run(&motion, &script), name);
    const nck_seg_t *const last = &motion.seg[motion.segs - 1];
    for (int x = 0; x < 3; x++) CHECK(check, motion.pose.axis[x] == last->end[x]);
}

static void limits_hold_whatever_the_operator_does(check_t *check)
{
    for (uint64_t seed = 1; seed <= 3; seed++) {
        for (int family = 0; family < MOTION_FAMILIES; family++) {
            for (int setting = 0; setting < SETTINGS; setting++) {
                const int drawn = (family + setting + (int)seed) % 4 == 0;
                if (!drawn || takes_too_long(family, setting)) continue;
                check_operated(check, family, setting, seed);
            }
        }
    }
}

static void start_at(uint64_t tick)
{
    motion.status = motion_start(&motion);
    while (motion.ticks < tick && motion_tick(&motion, NULL)) continue;
}

// Goes on until the tick holds at rest. Returns the ticks that took; `most` if it did not come.
static uint64_t ticks_to_rest(uint64_t most)
{
    const uint64_t begin_tick = motion.ticks;
    while (motion.ticks - begin_tick < most) {
        (void)motion_tick(&motion, NULL);
        const double *const s = motion.s;
        const int rests = s[3] == s[2] && s[2] == s[1];
        if (rests && motion.pose.state == NCK_TICK_HOLD) return motion.ticks - begin_tick;
    }
    return most;
}

// The highest acceleration and speed after a hold now: it begins to brake some periods later, and
// the acceleration takes its time to fall to nothing.
static double highest_a(const motion_t *m)
{
    const double period = m->machine.period_s;
    const double a = (m->s[3] - 2.0 * m->s[2] + m->s[1]) / (period * period);
    return fmin(m->machine.path.a_max, fmax(0.0, a) + 15.0 * m->machine.path.j_max * period);
}

static double highest_v(const motion_t *m)
{
    const double period = m->machine.period_s;
    const double a = highest_a(m);
    const double v = (m->s[3] - m->s[2]) / period;
    const double most = v + a * (15.0 * period + 0.5 * a / m->machine.path.j_max);
    return fmin(most, m->machine.path.feed_max);
}

// The longest that a rest may take from the state of now, with a tenth to spare [s].
static double time_to_rest(const motion_t *m)
{
    const double a_max = m->machine.path.a_max;
    const double j_max = m->machine.path.j_max;
    const double v = highest_v(m);
    const double ramps = v * j_max >= a_max * a_max ? v / a_max + a_max / j_max
                                                    : 2.0 * sqrt(v / j_max);
    return 1.1 * (ramps + highest_a(m) / j_max) + 20.0 * m->machine.period_s;
}

// A window of few cells cannot hold a fine ladder down to rest: there the brake is coarse, or the
// window's own stop.
static void hold_rests_within_the_braking_distance(check_t *check)
{
    const double coarse = NCK_PROFILE < 256 ? 4.0 : 1.0;
    for (uint64_t tick = 20; tick < 3000; tick += 130) {
        motion_begin(&motion, 1);
        motion_line(&motion, "G61 G1 X250 F6000");
        motion_line(&motion, "M2");
        start_at(tick);
        const double time = coarse * time_to_rest(&motion);
        const double s = motion.s[3];
        const double v = highest_v(&motion);
        if (motion.is_over) break;
        nck_hold(&motion.nck);
        const double rest = (double)ticks_to_rest(4000) * motion.machine.period_s;
        if (!CHECK(check, rest <= time)) {
            printf("    hold at %d: %g s, at most %g s\n", (int)tick, rest, time);
        }
        CHECK(check, motion.s[3] - s <= v * time);
        motion_holds(check, &motion, "hold");
    }
}

static void held_path_goes_on_to_the_same_end(check_t *check)
{
    for (int family = 0; family < MOTION_FAMILIES; family++) {
        for (uint64_t tick = 15; tick < 900; tick += 210) {
            begin(family, family % 3, 1);
            start_at(tick);
            nck_hold(&motion.nck);
            const int is_over = motion.is_over;
            if (!is_over && !CHECK(check, ticks_to_rest(3000) < 3000)) {
                printf("    %s, hold at %d\n", motion_family[family].name, (int)tick);
            }
            const double s = motion.pose.s;
            for (int k = 0; k < 50 && !is_over; k++) (void)motion_tick(&motion, NULL);
            CHECK(check, motion.pose.s == s);
            nck_resume(&motion.nck);
            while (!motion.is_over && motion_tick(&motion, NULL)) continue;
            check_run_of(check, motion.is_over, motion_family[family].name);
            const nck_seg_t *const last = &motion.seg[motion.segs - 1];
            for (int x = 0; x < 3; x++) CHECK(check, motion.pose.axis[x] == last->end[x]);
        }
    }
}

static void abort_keeps_the_position_and_drops_the_rest(check_t *check)
{
    for (int family = 0; family < MOTION_FAMILIES; family++) {
        for (uint64_t tick = 5; tick < 800; tick += 130) {
            begin(family, family % 3, 1);
            start_at(tick);
            if (motion.is_over) break;
            nck_abort(&motion.nck);
            while (!motion.is_over && motion.ticks < tick + 3000) (void)motion_tick(&motion, NULL);
            check_run_of(check, motion.is_over, motion_family[family].name);
            CHECK_INT(check, motion.status, NCK_DONE);
            const nck_axes_t axes = motion.axes;
            nck_resume(&motion.nck);
            for (int k = 0; k < 50; k++) (void)motion_tick(&motion, NULL);
            CHECK_INT(check, motion.pose.state, NCK_TICK_HOLD);
            CHECK(check, memcmp(&axes, &motion.axes, sizeof axes) == 0);
        }
    }
}

static void single_block_rests_at_the_end_of_every_block(check_t *check)
{
    motion_begin(&motion, 1);
    motion_line(&motion, "G61 G1 F3000 X10");
    for (int k = 1; k < 8; k++) motion_line(&motion, k % 2 ? "G91 X10" : "G91 X7 Y7");
    motion_line(&motion, "M2");
    motion.status = motion_start(&motion);
    nck_set_single_block(&motion.nck, 1);
    for (uint32_t k = 0; k < 8; k++) {
        CHECK(check, ticks_to_rest(4000) < 4000);
        const nck_seg_t *const seg = &motion.seg[k];
        CHECK_NEAR(check, motion.pose.s, seg->s_begin + seg->length, 1e-9);
        nck_resume(&motion.nck);
        (void)motion_tick(&motion, NULL);
        (void)motion_tick(&motion, NULL);
    }
    motion_holds(check, &motion, "single block");
}

// Most of the way nothing changes: a cell lasts two periods there, and is planned as one.
static void at_one_speed_cells_are_long(check_t *check)
{
    motion_begin(&motion, 1);
    motion_line(&motion, "G61 G1 F6000 X500");
    motion_line(&motion, "G3 X500 Y100 J50");
    motion_line(&motion, "M2");
    CHECK(check, motion_run(&motion, NULL));
    motion_holds(check, &motion, "one speed");
    const double ticks = (double)motion.ticks;
    const double share = NCK_PROFILE < 1024 ? 1.1 : 0.6; // a short window has none
    CHECK(check, (double)motion.nck.link.taken < share * ticks + 400.0);
}

int main(void)
{
    check_t check = {0};
    CHECK_RUN(&check, limits_hold_at_every_tick_on_every_machine);
    CHECK_RUN(&check, starvation_keeps_limits_path_and_end);
    CHECK_RUN(&check, setpoints_depend_on_the_program_not_on_the_pace);
    CHECK_RUN(&check, outputs_come_in_order_behind_their_moves);
    CHECK_RUN(&check, limits_hold_whatever_the_operator_does);
    CHECK_RUN(&check, hold_rests_within_the_braking_distance);
    CHECK_RUN(&check, held_path_goes_on_to_the_same_end);
    CHECK_RUN(&check, abort_keeps_the_position_and_drops_the_rest);
    CHECK_RUN(&check, at_one_speed_cells_are_long);
    CHECK_RUN(&check, single_block_rests_at_the_end_of_every_block);
    return check_end(&check);
}
