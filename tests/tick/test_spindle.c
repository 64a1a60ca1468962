// SPDX-License-Identifier: MIT
// Spindles that fail, at random moments of threads and taps: the tool is in step, or the thread is
// lost, told and at rest soon, within the limits of the axes; hold and abort are heard.
//
//     test_spindle [COUNT [FIRST]]   so many cases, from this number on; one alone is told in full
#include <math.h>   // NAN INFINITY fabs floor fmax hypot
#include <stdio.h>  // printf snprintf
#include <stdlib.h> // strtoul
#include <string.h> // strlen

#include "check.h"
#include "nck/nck_tools.h" // nck_t

enum { COUNT = 400, STEPS = 100000, TEXT = 400 };

typedef enum family {
    HEALTHY, STALLS, STOPS, JUMPS, NO_NUMBER, RUNS_BACK, TURNS_ROUND, JITTERS, STEPS_COARSELY,
    NEVER_STARTS, OVERRIDDEN, IGNORES, SPEEDS_UP, FAMILIES
} family_t;

static const char *const names[FAMILIES] = {
    "healthy", "stalls", "stops", "jumps", "no number", "runs back", "turns round", "jitters",
    "coarse", "never starts", "overridden", "ignores its command", "speeds up"};

typedef enum hand { NOBODY, HOLDS, ABORTS, HANDS } hand_t;

// A case, and how it goes.
typedef struct trial {
    uint64_t seed;
    family_t family;
    hand_t hand;
    uint64_t fault_at, hand_at; // ticks since the first one of the pass
    int taps;
    double lead, rpm, way_z;
    char text[TEXT];
    // the spindle
    double late_s, ripple, size, lasts_s;
    double speed, turns, told; // [1/min, revolutions]
    uint64_t ignored_rpm;
    // the run
    uint64_t tick, pass_ticks, first, lost_at, rest_at;
    int waits; // ticks of the pass in which nothing moved yet
    int over, lost;
    double axis[3][NCK_AXIS_MAX];
    double v;
    double a_most, v_off, helix_most;
    nck_pose_t pose;
    const char *why;
} trial_t;

static nck_machine_t machine;
static nck_t nck;
static trial_t trial;
static uint64_t cases = COUNT;
static uint64_t first_case = 1;

static double draw(void)
{
    trial.seed = trial.seed * 6364136223846793005u + 1442695040888963407u;
    return (double)(trial.seed >> 11) * 0x1p-53;
}

static int pick(int n) { return (int)(draw() * (double)n); }

static double between(double low, double high) { return low + draw() * (high - low); }

static void fail(const char *why)
{
    if (!trial.why) trial.why = why;
}

static void draw_program(void)
{
    static const double leads[] = {0.5, 1.0, 1.5, 2.0};
    const int kind = pick(6);
    const double depth = floor(between(-60.0, -25.0));
    const double taper = kind == 1 ? floor(between(-6.0, 6.0)) : 0.0;
    const char *const turn = kind == 4 ? "M4" : "M3";
    char line[TEXT / 2];
    trial.lead = leads[pick(4)];
    trial.rpm = floor(between(60.0, 1200.0));
    trial.taps = kind >= 3;
    trial.way_z = fabs(depth - 5.0) / hypot(depth - 5.0, taper);
    switch (kind) {
    case 2:
        (void)snprintf(line, sizeof line, "G76 P%g Z%.3f I-3 J0.9 K0.9 R1 Q0 E4 L%d", trial.lead,
                       depth, 1 + pick(3));
        break;
    case 3:
        (void)snprintf(line, sizeof line, "G33.1 Z%.3f K%g", depth, trial.lead);
        break;
    case 4:
    case 5:
        (void)snprintf(line, sizeof line, "F%g\n%s X20 Z%.3f R5 P%g", trial.lead * trial.rpm,
                       kind == 4 ? "G74" : "G84", depth, pick(2) ? 0.3 : 0.0);
        break;
    default:
        (void)snprintf(line, sizeof line, "G33 X%.3f Z%.3f K%g", 20.0 + taper, depth, trial.lead);
        break;
    }
    (void)snprintf(trial.text, TEXT, "G21 %s G90 G61 G8\n%s S%g\nG0 X20 Z5\n%s\nG0 X30\nM2\n",
                   trial.taps ? "G17 G98" : "G18", turn, trial.rpm, line);
}

static void draw_spindle(void)
{
    static const double periods[] = {2.5e-4, 5e-4, 1e-3, 1e-3, 2e-3, 4e-3, 1e-2};
    static const double lates[] = {0.0, 0.0, 0.02, 0.1, 0.3};
    static const double rates[] = {0.02, 0.3, 0.5, 0.9, 1.03, 1.2, 1.6};
    static const double jumps[] = {0.02, 0.2, 1.0, 3.0, 1e6};
    nck_machine_default(&machine);
    machine.path.tolerance = 0.0;
    machine.axis[NCK_AXIS_Z].min_nm = -75000000;
    machine.period_s = periods[pick(7)];
    machine.slope = (uint32_t)pick(3);
    trial.late_s = lates[pick(5)];
    trial.ripple = pick(2) ? 0.0 : 0.02;
    trial.lasts_s = between(0.02, 2.0);
    trial.size = draw();
    if (trial.family == OVERRIDDEN) trial.size = rates[pick(7)];
    if (trial.family == JUMPS) trial.size = (pick(2) ? 1.0 : -1.0) * jumps[pick(5)];
}

// ---- the spindle

// How fast the spindle wants to turn at the time t behind the fault [1/min].
static double wanted_speed(double command, double t)
{
    const double share = fmin(1.0, fmax(0.0, t / trial.lasts_s));
    switch (trial.family) {
    case STOPS: return command * (1.0 - share);
    case TURNS_ROUND: return command * (1.0 - 2.0 * share);
    case RUNS_BACK: return t >= 0.0 ? -command : command;
    case NEVER_STARTS: return 0.0;
    case OVERRIDDEN: return command * trial.size;
    case IGNORES: return t >= 0.0 ? trial.speed : command;
    case SPEEDS_UP: return command * (1.0 + share);
    default: return command;
    }
}

// What is told of the angle.
static double told_angle(double t)
{
    static const double none[] = {(double)NAN, (double)INFINITY, -(double)INFINITY, 1e300};
    const int lasts = trial.size < 0.6 || t < 0.002;
    switch (trial.family) {
    case STALLS: return t >= 0.0 ? trial.told : trial.turns;
    case JUMPS: return t >= 0.0 ? trial.turns + trial.size : trial.turns;
    case NO_NUMBER: return t >= 0.0 && lasts ? none[pick(4)] : trial.turns;
    case JITTERS: // by up to half a millisecond of the spindle's way
        return trial.turns + trial.size * between(-5e-4, 5e-4) * trial.rpm / 60.0;
    case STEPS_COARSELY: { // by a millisecond of it
        const double step = (0.2 + 0.8 * trial.size) * 1e-3 * trial.rpm / 60.0;
        return floor(trial.turns / step) * step;
    }
    default: return trial.turns;
    }
}

static double since(uint64_t at)
{
    const double ticks = (double)trial.pass_ticks - (double)at;
    return trial.first ? ticks * machine.period_s : -1.0;
}

static void turn_spindle(void)
{
    const double period = machine.period_s;
    const double t = since(trial.fault_at);
    const double command = trial.tick ? trial.pose.spindle_rpm : 0.0;
    const double share = trial.late_s > period ? period / trial.late_s : 1.0;
    const double uneven = trial.ripple * sin(9.0 * trial.turns);
    const int at_once = trial.family == RUNS_BACK && t >= 0.0;
    trial.speed += (at_once ? 1.0 : share) * (wanted_speed(command, t) - trial.speed);
    trial.turns += trial.speed / 60.0 * (1.0 + uneven) * period;
    const double angle = told_angle(t);
    nck_set_spindle(&nck, angle);
    if (angle - angle == 0.0 && fabs(angle) < 1e12) trial.told = angle;
}

// ---- the judge

static int is_of_spindle(void) { return trial.pose.kind >= NCK_SEG_THREAD; }

static void judge_motion(void)
{
    const double period = machine.period_s;
    const nck_pose_t *const pose = &trial.pose;
    for (int x = 0; x < NCK_AXIS_MAX; x++) {
        trial.axis[2][x] = trial.axis[1][x];
        trial.axis[1][x] = trial.axis[0][x];
        trial.axis[0][x] = pose->axis[x];
        const double d = trial.axis[0][x] - 2.0 * trial.axis[1][x] + trial.axis[2][x];
        const double most = machine.axis[x].a_max * period * period;
        if (trial.first && trial.pass_ticks > 2) trial.a_most = fmax(trial.a_most, fabs(d) / most);
    }
    if (!trial.first || trial.pass_ticks < 3 || !is_of_spindle()) return;
    const double moved = fabs(trial.axis[0][2] - trial.axis[1][2]) / period;
    const double mean = 0.5 * (pose->v + trial.v) * trial.way_z;
    trial.v_off = fmax(trial.v_off, fabs(moved - mean) / (machine.axis[2].a_max * period));
    if (pose->state != NCK_TICK_MOVE) return;
    const double z = (pose->axis[2] - 5.0) / trial.way_z;
    if (z > -4.0 || z < -18.0) return; // where every pass is in its full thread
    const double leads = z / trial.lead + trial.told;
    trial.helix_most = fmax(trial.helix_most, fabs(leads - floor(leads + 0.5)) * trial.lead);
}

// What the operator does, and whether he is heard while nothing is cut yet.
static void operate(int waits)
{
    if (!trial.first || trial.pass_ticks != trial.hand_at) return;
    if (trial.hand == ABORTS) nck_abort(&nck);
    if (trial.hand != HOLDS) return;
    nck_hold(&nck);
    if (!waits) return;
    nck_axes_t axes;
    for (int k = 0; k < 50; k++) {
        turn_spindle();
        const nck_tick_state_t state = nck_tick(&nck, &trial.pose, &axes);
        trial.tick++;
        trial.pass_ticks++;
        if (state != NCK_TICK_HOLD || trial.pose.v != 0.0) fail("a hold is not heard");
        judge_motion();
    }
}

static void tick(void)
{
    nck_axes_t axes;
    turn_spindle();
    const double z = trial.pose.axis[2];
    const nck_tick_state_t state = nck_tick(&nck, &trial.pose, &axes);
    trial.tick++;
    if (is_of_spindle() && !trial.first) trial.first = trial.tick;
    if (trial.first) trial.pass_ticks++;
    judge_motion();
    trial.v = trial.pose.v;
    if (trial.pose.v < 0.0) fail("a speed below zero");
    if (state == NCK_TICK_WAIT) nck_resume(&nck);
    if (nck_is_thread_lost(&nck) && !trial.lost_at) trial.lost_at = trial.pass_ticks;
    if (trial.rest_at && trial.pose.axis[2] != z) fail("it moves again");
    if (trial.lost_at && !trial.rest_at && nck_is_idle(&nck)) {
        trial.rest_at = trial.pass_ticks;
    }
    const int waits = trial.first && is_of_spindle() && state == NCK_TICK_DWELL;
    operate(waits);
}

static nck_status_t prepare(void)
{
    nck_status_t status = NCK_OK;
    for (int k = 0; k < STEPS && status == NCK_OK; k++) status = nck_prep(&nck);
    return status;
}

// Run for so many seconds of the pass at most. Returns 0 for a program that is none.
static int run(double most_s)
{
    const nck_source_t source = {trial.text, strlen(trial.text), NULL, NULL};
    if (nck_init(&nck, &machine, NULL) != NCK_OK) return 0;
    if (nck_read(&nck, &source) != NCK_OK) return 0;
    nck_status_t status = prepare();
    if (status < NCK_OK) return 0;
    const double limit = most_s / machine.period_s;
    while (!trial.over && (double)trial.pass_ticks < limit && trial.tick < 1u << 22) {
        tick();
        if (status != NCK_DONE || trial.hand != NOBODY) status = prepare();
        if (status < NCK_OK) return 0;
        const int held = trial.hand == HOLDS && trial.first && trial.pass_ticks > trial.hand_at;
        if (held && trial.pass_ticks % 64 == 0) nck_resume(&nck);
        trial.over = status == NCK_DONE && nck_is_idle(&nck);
    }
    trial.lost = nck_is_thread_lost(&nck);
    return trial.first > 0;
}

static void begin(uint64_t number)
{
    memset(&trial, 0, sizeof trial);
    trial.seed = number * 0x9e3779b97f4a7c15u + 1u;
    (void)draw();
    trial.family = (family_t)(number % FAMILIES);
    draw_program();
    draw_spindle();
}

// How long the pass of a healthy spindle lasts [s].
static double healthy_s(uint64_t number)
{
    begin(number);
    trial.family = HEALTHY;
    if (!run(1e4) || !trial.over) return 0.0;
    return (double)trial.pass_ticks * machine.period_s;
}

// ---- the promises

static void check_lost(void)
{
    nck_pose_t pose;
    nck_axes_t axes;
    const double z = trial.pose.axis[2];
    // a spindle that goes on turning takes a tap along: it is in the hole
    if (trial.taps && trial.family == IGNORES && !trial.rest_at) return;
    if (trial.pose.state != NCK_TICK_HOLD || trial.pose.v != 0.0) fail("lost, and not at rest");
    for (int k = 0; k < 20; k++) {
        turn_spindle();
        if (nck_tick(&nck, &pose, &axes) != NCK_TICK_HOLD) fail("lost, and not held");
        if (pose.axis[2] != z) fail("it moves behind its rest");
    }
    if (nck_begin(&nck) != NCK_OK) fail("nothing can follow");
    (void)nck_tick(&nck, &pose, &axes);
    if (nck_is_thread_lost(&nck)) fail("nck_begin has not forgotten");
}

// Behind the fault: an encoder's noise is not told within a period, a turn takes its time.
static void check_told_soon(void)
{
    static const int at_once[FAMILIES] = {[STALLS] = 1, [RUNS_BACK] = 1};
    const uint64_t from = trial.fault_at;
    if (!at_once[trial.family] || trial.taps || trial.hand != NOBODY || !trial.lost) return;
    const double took = ((double)trial.lost_at - (double)from) * machine.period_s;
    if (trial.lost_at > from && took > 0.021 + 3.0 * machine.period_s) fail("told late");
}

static void check_all(void)
{
    const int waits_for_ever = !trial.over && !trial.lost && trial.pose.v == 0.0
                               && trial.pose.state == NCK_TICK_DWELL;
    const int noisy = trial.family == JITTERS || trial.family == STEPS_COARSELY;
    const double slack = (2e-3 * 1.06 + (noisy ? 1e-3 : 0.0)) * trial.lead * trial.rpm / 60.0;
    if (trial.a_most > (noisy ? 1.02 : 1.0 + 1e-6)) fail("more than an axis' acceleration");
    if (trial.v_off > 2.0) fail("pose.v is not true");
    if (trial.helix_most > slack) fail("beside the angle, and not lost");
    if (trial.family == HEALTHY && trial.hand != ABORTS) {
        if (trial.lost) fail("a healthy spindle loses its thread");
        if (trial.helix_most > 1e-6) fail("not in step with a healthy spindle");
    }
    if (trial.lost) check_lost();
    check_told_soon();
    if (trial.over || waits_for_ever || (trial.taps && trial.family == IGNORES)) return;
    if (trial.family != OVERRIDDEN || trial.size > 0.2) fail("it does not end");
}

static int try_case(uint64_t number, int tells)
{
    const double lasts_s = healthy_s(number);
    if (lasts_s <= 0.0) return 0;
    begin(number);
    const double ticks = lasts_s / machine.period_s;
    trial.hand = pick(3) ? NOBODY : (hand_t)(1 + pick(HANDS - 1));
    trial.fault_at = (uint64_t)(ticks * between(0.0, 1.05) * (pick(4) ? 1.0 : 0.02));
    trial.hand_at = 1 + (uint64_t)(ticks * between(0.0, 1.0) * (pick(3) ? 1.0 : 0.02));
    (void)run(4.0 * lasts_s + 12.0);
    check_all();
    if (trial.why || tells) {
        printf("case %llu: %s\n  %s, T %g s, slope %u, late %g s, ripple %g, size %g, lasts %g s\n"
               "  fault at %llu, hand %d at %llu, of %g ticks; lost at %llu, rest at %llu, state %u"
               ", tick %llu\n  a %g, v off %g, beside %g mm\n%s",
               (unsigned long long)number, trial.why ? trial.why : "good", names[trial.family],
               machine.period_s, machine.slope, trial.late_s, trial.ripple, trial.size,
               trial.lasts_s, (unsigned long long)trial.fault_at, (int)trial.hand,
               (unsigned long long)trial.hand_at, ticks, (unsigned long long)trial.lost_at,
               (unsigned long long)trial.rest_at, trial.pose.state,
               (unsigned long long)trial.pass_ticks, trial.a_most, trial.v_off, trial.helix_most,
               trial.text);
    }
    return trial.why ? -1 : 1;
}

static void spindles_that_fail_lose_the_thread_and_nothing_else(check_t *check)
{
    uint64_t tried = 0;
    uint64_t bad = 0;
    for (uint64_t k = 0; k < cases; k++) {
        const int found = try_case(first_case + k, cases == 1);
        tried += found != 0;
        bad += found < 0;
    }
    CHECK(check, bad == 0 && 2 * tried >= cases);
    printf("%llu cases, %llu of them bad\n", (unsigned long long)tried, (unsigned long long)bad);
}

// A build without cycles has no threads: nothing of theirs is read.
static void without_cycles_no_thread_is_read(check_t *check)
{
    static nck_t kernel;
    static nck_machine_t plain;
    static const char text[] = "G33 Z-1 K1\n";
    size_t used = 0;
    nck_diagnostic_t found;
    nck_machine_default(&plain);
    CHECK_INT(check, nck_init(&kernel, &plain, NULL), NCK_OK);
    CHECK_INT(check, nck_push(&kernel, text, sizeof text - 1, &used), NCK_OK);
    while (nck_prep(&kernel) == NCK_OK) continue;
    CHECK_INT(check, nck_diagnostic(&kernel, &found), NCK_OK);
    CHECK_INT(check, found.code, NCK_E_UNSUPPORTED);
}

int main(int argc, char **argv)
{
    check_t check = {0};
    if (!NCK_HAS_CYCLES) {
        CHECK_RUN(&check, without_cycles_no_thread_is_read);
        return check_end(&check);
    }
    if (argc > 1) cases = strtoul(argv[1], NULL, 10);
    if (argc > 2) first_case = strtoul(argv[2], NULL, 10);
    CHECK_RUN(&check, spindles_that_fail_lose_the_thread_and_nothing_else);
    return check_end(&check);
}
