// SPDX-License-Identifier: MIT
// Threads under the tick: the full thread is on its helix, a stop is within the limits wherever it
// comes, and nothing follows a thread that is lost.
#include <math.h>   // fabs floor
#include <string.h> // strlen

#include "check.h"
#include "sim.h" // sim_run

enum { ROWS_MAX = 20000, WAITS = 10 };

static const double lead = 1.5;
static const char text[] = "G21 G18 G90 G61\nM3 S1200\nG0 X20 Z5\nG33 Z-20 K1.5\nG0 X30\nM2\n";
static const char taper[] = "G21 G18 G90 G61 G8\nM3 S800\nG0 X15 Z5\n"
                            "G76 P1.5 Z-20 I-3 J0.5 K0.9 R2 Q29.5 E3 L3\nM2\n";

static nck_machine_t machine;
static nck_t nck;
static sim_t sim;
static sim_row_t rows[ROWS_MAX];
static size_t count;

static void prepare(uint32_t slope)
{
    nck_machine_default(&machine);
    machine.slope = slope;
    machine.path.tolerance = 0.0;
    machine.dialect.plane = 18;
}

// Run a program; a command at a tick, none at 0.
static void run(const char *program, const sim_spindle_t *spindle, uint32_t kind, uint64_t tick)
{
    const sim_command_t commands[2] = {{tick, kind, {100, 100}, 0},
                                       {tick + 4000, SIM_RESUME, {0, 0}, 0}};
    (void)sim_init(&sim, &nck, &machine, program, strlen(program), 4);
    if (spindle) sim.spindle = *spindle;
    if (tick > 0) sim_operate(&sim, commands, 2);
    count = 0;
    (void)sim_run(&sim, rows, ROWS_MAX, &count);
}

// The first tick of the first pass.
static size_t first_of_pass(void)
{
    size_t k = 0;
    while (k < count && rows[k].pose.kind != NCK_SEG_THREAD) k++;
    return k;
}

// Acceleration of Z and X over their limits, the most from a row on.
static double most_acceleration(size_t from)
{
    double most = 0.0;
    for (size_t k = from; k + 2 < count; k++) {
        for (int x = NCK_AXIS_X; x <= NCK_AXIS_Z; x += NCK_AXIS_Z) {
            const double d = rows[k + 2].pose.axis[x] - 2.0 * rows[k + 1].pose.axis[x]
                             + rows[k].pose.axis[x];
            most = fmax(most, fabs(d) / (machine.period_s * machine.period_s));
        }
    }
    return most / machine.axis[NCK_AXIS_Z].a_max;
}

static void the_full_thread_is_on_its_helix(check_t *check)
{
    const sim_spindle_t spindles[] = {{0.0, 0.0, 1.0, 0.0, 0.0, 1}, {0.3, 0.02, 0.7, 0.0, 0.0, 1}};
    for (uint32_t slope = NCK_SLOPE_LINEAR; slope <= NCK_SLOPE_JERK; slope++) {
        for (int n = 0; n < 2; n++) {
            double worst = 0.0;
            prepare(slope);
            run(text, &spindles[n], 0, 0);
            for (size_t k = first_of_pass(); k < count; k++) {
                const nck_pose_t *const pose = &rows[k].pose;
                if (pose->kind != NCK_SEG_THREAD || pose->v == 0.0) continue; // waits
                if (pose->axis[NCK_AXIS_Z] > 2.0 || pose->axis[NCK_AXIS_Z] < -17.0) continue;
                const double turns = (pose->axis[NCK_AXIS_Z] - 5.0) / lead + rows[k].spindle_turns;
                worst = fmax(worst, fabs(turns - floor(turns + 0.5)) * lead);
            }
            CHECK(check, worst < 1e-9);
            CHECK(check, sim.end == SIM_END_DONE && !nck_is_thread_lost(&nck));
        }
    }
}

static void an_abort_stops_within_the_limits(check_t *check)
{
    const sim_spindle_t standing = {0.0, 0.0, 1.0, 0.0, 0.0, 1};
    for (uint32_t slope = NCK_SLOPE_LINEAR; slope <= NCK_SLOPE_JERK; slope++) {
        prepare(slope);
        run(text, NULL, 0, 0);
        const size_t begin = first_of_pass();
        for (size_t after = 1; after < 800; after += after < 200 ? 7 : 60) {
            run(text, after % 2 ? &standing : NULL, SIM_ABORT, begin + after);
            CHECK(check, sim.end == SIM_END_ABORTED);
            CHECK(check, most_acceleration(begin + 3) <= 1.0 + 1e-9);
            CHECK(check, rows[count - 1].pose.state == NCK_TICK_HOLD);
        }
    }
}

static void tapers_and_their_aborts_keep_the_limits(check_t *check)
{
    prepare(NCK_SLOPE_JERK);
    run(taper, NULL, 0, 0);
    CHECK(check, sim.end == SIM_END_DONE);
    const size_t begin = first_of_pass();
    size_t end = begin;
    while (rows[end].pose.kind == NCK_SEG_THREAD) end++;
    for (size_t at = begin + WAITS; at < end; at += 13) {
        run(taper, NULL, SIM_ABORT, at);
        CHECK(check, sim.end == SIM_END_ABORTED);
        CHECK(check, most_acceleration(begin) <= 1.0 + 1e-9);
    }
}

static void a_spindle_that_runs_away_loses_the_thread(check_t *check)
{
    const sim_spindle_t away = {0.0, 0.5, 500.0, 0.0, 0.0, 1};
    nck_pose_t pose;
    nck_axes_t axes;
    prepare(NCK_SLOPE_JERK);
    run(text, &away, SIM_RESUME, 8000);
    CHECK(check, nck_is_thread_lost(&nck) && sim.end == SIM_END_ABORTED);
    CHECK(check, most_acceleration(first_of_pass()) <= 1.0 + 1e-9);
    CHECK_INT(check, nck_begin(&nck), NCK_OK);
    (void)nck_tick(&nck, &pose, &axes);
    CHECK_INT(check, nck_is_thread_lost(&nck), 0);
}

static const char tap[] = "G21 G17 G90 G61\nM3 S600\nG0 Z5\nG33.1 Z-20 K1.5\nG0 X1\nM2\n";

static size_t ticks_in_tap(size_t *first)
{
    size_t end = 0;
    while (end < count && rows[end].pose.kind != NCK_SEG_TAP) end++;
    *first = end;
    while (end < count && rows[end].pose.kind == NCK_SEG_TAP) end++;
    return end - *first;
}

// In to the bottom and out to where it began; a hold waits for that, an abort does not.
static void a_tap_goes_in_and_out_whatever_the_operator_does(check_t *check)
{
    static const uint32_t kinds[] = {SIM_HOLD, SIM_ABORT};
    size_t first = 0;
    prepare(NCK_SLOPE_JERK);
    machine.dialect.plane = 17;
    run(tap, NULL, 0, 0);
    const size_t ticks = ticks_in_tap(&first);
    double bottom = 0.0;
    for (size_t k = first; k < first + ticks; k++) bottom = fmin(bottom, rows[k].pose.axis[2]);
    CHECK(check, sim.end == SIM_END_DONE && ticks > 100 && fabs(bottom + 20.0) < 1e-6);
    CHECK_NEAR(check, rows[first + ticks - 1].pose.axis[2], 5.0, 0.01);
    for (size_t after = 1; after < ticks; after += 97) {
        for (int n = 0; n < 2; n++) {
            run(tap, NULL, kinds[n], first + after);
            CHECK(check, most_acceleration(first) <= 1.0 + 1e-9);
            CHECK(check, sim.end == (n ? SIM_END_ABORTED : SIM_END_DONE));
        }
    }
}

static void capacities_say_whether_there_are_threads(check_t *check)
{
    prepare(NCK_SLOPE_JERK);
    run(text, NULL, 0, 0);
    const int passes = first_of_pass() < count;
    CHECK_INT(check, passes, NCK_HAS_CYCLES);
}

int main(void)
{
    check_t check = {0};
    CHECK_RUN(&check, capacities_say_whether_there_are_threads);
    if (!NCK_HAS_CYCLES) return check_end(&check);
    CHECK_RUN(&check, the_full_thread_is_on_its_helix);
    CHECK_RUN(&check, an_abort_stops_within_the_limits);
    CHECK_RUN(&check, tapers_and_their_aborts_keep_the_limits);
    CHECK_RUN(&check, a_tap_goes_in_and_out_whatever_the_operator_does);
    CHECK_RUN(&check, a_spindle_that_runs_away_loses_the_thread);
    return check_end(&check);
}
