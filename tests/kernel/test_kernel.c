// SPDX-License-Identifier: MIT
// The whole kernel, text to setpoints, in every capacity: limits hold at every tick, nothing is
// lost, and starvation is a stop on the path.
#include <math.h>   // fabs cos sin
#include <stdio.h>  // snprintf
#include <string.h> // memset strlen

#include "check.h"
#include "host/host.h" // nck_host_plan_…
#include "sim.h"       // sim_run

enum { TEXT_MAX = 200000, ROWS = 512 };

static nck_machine_t machine;
static nck_t nck;
static sim_t sim;
static nck_host_plan_t plan;
static sim_row_t rows[ROWS];
static char text[TEXT_MAX];
static size_t text_size;
static uint64_t seed;

// What a run was like: peaks over their limits, and where it ended.
typedef struct run {
    double v, a;               // largest of all axes, over their limits
    double end[NCK_AXIS_MAX];
    uint64_t ticks, starved, hash;
    nck_status_t status;
} run_t;

// Xorshift, G. Marsaglia 2003: the same numbers everywhere. 0 … 1.
static double random_real(void)
{
    seed ^= seed << 13;
    seed ^= seed >> 7;
    seed ^= seed << 17;
    return (double)(seed >> 11) / 9007199254740992.0;
}

static void begin(uint64_t first_seed)
{
    nck_machine_default(&machine);
    machine.slope = NCK_SLOPE_LINEAR;
    machine.dialect.feed_default = 1000.0;
    text_size = 0;
    seed = first_seed;
}

static void line(const char *words)
{
    const size_t n = strlen(words);
    if (text_size + n + 1 > TEXT_MAX) return;
    memcpy(text + text_size, words, n);
    text_size += n;
    text[text_size] = '\n';
    text_size++;
}

// A random walk of lines and quarter circles: mean length, turn a block, share of arcs.
static void random_program(int blocks, double length, double turn, double arcs)
{
    char words[120];
    double x = 0.0;
    double y = 0.0;
    double angle = 0.0;
    line("G21 G90 G17 G91.1 G1 F6000");
    for (int k = 0; k < blocks; k++) {
        const double l = length * (0.05 + random_real());
        angle += turn * (random_real() - 0.5);
        if (random_real() < arcs) {
            const double i = l * cos(angle);
            const double j = l * sin(angle);
            const int left = random_real() < 0.5;
            x += left ? i - j : i + j;
            y += left ? j + i : j - i;
            snprintf(words, sizeof words, "G%d X%.6f Y%.6f I%.6f J%.6f", left ? 2 : 3, x, y, i, j);
        } else {
            x += l * cos(angle);
            y += l * sin(angle);
            const int rapid = random_real() < 0.02;
            snprintf(words, sizeof words, "G%d X%.6f Y%.6f Z%.6f", rapid ? 0 : 1, x, y,
                     length * random_real());
        }
        line(words);
    }
}

// Differences of the emitted setpoints against the machine's limits.
static void measure(run_t *run, const sim_row_t *row, double p[3][NCK_AXIS_MAX])
{
    const double period = machine.period_s;
    memmove(p[0], p[1], 2 * sizeof p[0]);
    memcpy(p[2], row->pose.axis, sizeof p[2]);
    for (int x = 0; x < NCK_AXIS_MAX; x++) {
        if (!machine.axis[x].present) continue;
        const double v = fabs(p[2][x] - p[1][x]) / period;
        const double a = fabs(p[2][x] - 2.0 * p[1][x] + p[0][x]) / (period * period);
        run->v = fmax(run->v, v / machine.axis[x].v_max);
        run->a = fmax(run->a, a / machine.axis[x].a_max);
        run->hash = (run->hash ^ (uint64_t)row->axes.joint_nm[x]) * 1099511628211u; // FNV-1a
    }
}

static run_t run_text(uint32_t prep_steps)
{
    double p[3][NCK_AXIS_MAX] = {{0.0}};
    size_t count = 0;
    run_t run;
    memset(&run, 0, sizeof run);
    run.status = sim_init(&sim, &nck, &machine, text, text_size, prep_steps);
    while (run.status == NCK_OK) {
        run.status = sim_run(&sim, rows, ROWS, &count);
        for (size_t k = 0; k < count; k++) measure(&run, &rows[k], p);
        if (sim.ticks > 2000000) break;
    }
    memcpy(run.end, p[2], sizeof run.end);
    run.ticks = sim.ticks;
    run.starved = sim.starved_ticks;
    return run;
}

static uint64_t plan_ticks(void)
{
    nck_host_plan_init(&plan, &nck, &machine, text, text_size);
    while (nck_host_plan_run(&plan) == NCK_OK) { }
    return plan.totals.ticks;
}

typedef struct family {
    const char *name;
    double length, turn, arcs;
} family_t;

static const family_t families[] = {
    {"long lines", 20.0, 3.0, 0.0},        {"smooth micro-segments", 0.02, 0.05, 0.0},
    {"rough micro-segments", 0.02, 2.0, 0.0}, {"five micrometres", 0.005, 0.2, 0.0},
    {"lines and arcs", 5.0, 1.0, 0.5},     {"small arcs", 0.1, 1.0, 0.8},
    {"nearly straight", 1.0, 0.001, 0.0},
};
enum { FAMILIES = (int)(sizeof families / sizeof families[0]) };

static void limits_hold_at_every_tick_however_slow_prep_is(check_t *check)
{
    const uint32_t steps[] = {1, 2, 3, 5, 1000};
    for (int f = 0; f < FAMILIES; f++) {
        begin(11 + (uint64_t)f);
        random_program(400, families[f].length, families[f].turn, families[f].arcs);
        double end[2] = {0.0, 0.0};
        for (int k = 0; k < 5; k++) {
            const run_t run = run_text(steps[k]);
            CHECK_INT(check, run.status, NCK_DONE);
            if (!CHECK(check, run.v <= 1.0 + 1e-6 && run.a <= 1.0 + 1e-6)) {
                printf("    %s, %u steps: v %.9f a %.9f\n", families[f].name, steps[k], run.v,
                       run.a);
            }
            if (k == 0) memcpy(end, run.end, sizeof end);
            CHECK(check, run.end[0] == end[0] && run.end[1] == end[1]);
        }
    }
}

static void polyline_to(double *x, double *y, double length, double angle)
{
    char words[80];
    *x += length * cos(angle);
    *y += length * sin(angle);
    snprintf(words, sizeof words, "X%.6f Y%.6f", *x, *y);
    line(words);
}

static void check_peak(check_t *check, const char *what, double value, double *worst)
{
    const run_t run = run_text(1000);
    CHECK_INT(check, run.status, NCK_DONE);
    if (!CHECK(check, run.a <= 1.0 + 1e-6)) printf("    %s %g: a %.9f\n", what, value, run.a);
    *worst = fmax(*worst, run.a);
}

// Every chord's corner counts on the same axis: what a lone corner may use would be broken many
// times.
static void corners_that_share_a_period_share_the_acceleration(check_t *check)
{
    double worst = 0.0;
    for (double chord = 0.003; chord < 0.3; chord *= 1.6) {
        double x = 0.0;
        double y = 0.0;
        begin(1);
        line("G21 G90 G61 G1 F6000");
        for (double angle = 0.0; angle < 8.0; angle += chord / 2.0) {
            polyline_to(&x, &y, chord, angle);
        }
        check_peak(check, "chord", chord, &worst);
    }
    CHECK(check, worst > 0.8); // the budget is used, not only kept
}

// Along the diagonal a corner and full tangential acceleration meet on one axis, at every distance.
static void corner_and_ramp_share_the_acceleration(check_t *check)
{
    double worst = 0.0;
    for (double degrees = 0.1; degrees < 40.0; degrees *= 1.3) {
        double x = 0.0;
        double y = 0.0;
        begin(1);
        line("G21 G90 G61 G1 F6000");
        for (int k = 0; k < 40; k++) {
            const double turn = degrees * 3.14159265358979 / 180.0;
            const double length = 0.05 * (1.0 + k % 13) * (1.0 + k % 3);
            polyline_to(&x, &y, length, 0.785398 + (k % 2 ? turn / 2.0 : -turn / 2.0));
        }
        check_peak(check, "degrees", degrees, &worst);
    }
    CHECK(check, worst > 0.95);
}

static void setpoints_depend_on_the_program_not_on_the_pace(check_t *check)
{
    begin(5);
    random_program(300, 5.0, 1.0, 0.3);
    const run_t fast = run_text(100000);
    const run_t slow = run_text(40);
    CHECK_INT(check, fast.starved, 0);
    CHECK_INT(check, slow.starved, 0);
    CHECK(check, fast.hash == slow.hash && fast.ticks == slow.ticks);
}

static void machining_time_agrees_with_the_run_to_the_tick(check_t *check)
{
    for (int f = 0; f < FAMILIES; f++) {
        begin(90 + (uint64_t)f);
        random_program(200, families[f].length, families[f].turn, families[f].arcs);
        line("G4 P0.0123");
        line("M0");
        line("G61.1 G1 X0 Y0 Z0");
        line("G0 X1");
        line("M2");
        const run_t run = run_text(100000);
        CHECK_INT(check, plan_ticks(), run.ticks);
    }
}

static void end_point_is_met_to_the_nanometre(check_t *check)
{
    begin(1);
    line("G1 X12.345678 Y-0.000001 F3000");
    line("G61.1 G1 Z1.000003");
    line("M30");
    const run_t run = run_text(100);
    CHECK_INT(check, run.status, NCK_DONE);
    CHECK_INT(check, rows[(sim.ticks - 1) % ROWS].axes.joint_nm[0], 12345678);
    CHECK_INT(check, rows[(sim.ticks - 1) % ROWS].axes.joint_nm[1], -1);
    CHECK_INT(check, rows[(sim.ticks - 1) % ROWS].axes.joint_nm[2], 1000003);
}

static void many_incremental_moves_do_not_drift(check_t *check)
{
    begin(1);
    line("G91 G1 F6000");
    for (int k = 0; k < 10000; k++) line(k % 2 ? "X-0.1" : "X0.1");
    const run_t run = run_text(1000);
    CHECK_INT(check, run.status, NCK_DONE);
    CHECK(check, run.end[0] == 0.0);
}

static void everything_before_an_error_is_executed(check_t *check)
{
    begin(1);
    line("G1 X1 F600");
    line("X2");
    line("X3 Q!");
    line("X4");
    const run_t run = run_text(100);
    CHECK(check, run.status < NCK_OK);
    CHECK(check, run.end[0] == 2.0);
    nck_diagnostic_t diagnostic;
    int found = 0;
    while (nck_diagnostic(&nck, &diagnostic) == NCK_OK) found += diagnostic.line == 3;
    CHECK_INT(check, found, 1);
}

static void outputs_come_in_order_and_do_not_slow_the_path(check_t *check)
{
    begin(1);
    line("G1 F3000");
    for (int k = 0; k < 300; k++) {
        char words[40];
        snprintf(words, sizeof words, "X%.3f", 0.1 * (k + 1));
        line(words);
    }
    const uint64_t plain = run_text(1000).ticks;
    text_size = 0;
    line("G1 F3000");
    for (int k = 0; k < 300; k++) {
        char words[40];
        snprintf(words, sizeof words, "X%.3f S%d", 0.1 * (k + 1), 100 + k);
        line(words);
    }
    CHECK_INT(check, run_text(1000).ticks, plain);
    CHECK(check, sim.outputs >= 300 && sim.spindle_rpm == 399.0);
}

// Steps of prep until it needs text, after so much of it.
static unsigned steps_over(check_t *check, const char *words)
{
    size_t used = 0;
    unsigned steps = 0;
    nck_status_t status = nck_push(&nck, words, strlen(words), &used);
    CHECK(check, status == NCK_OK && used == strlen(words));
    for (; status == NCK_OK; steps++) status = nck_prep(&nck);
    CHECK_INT(check, status, NCK_EMPTY);
    return steps;
}

// Where a line's work is done prep says at once that it needs the next one; a small window takes
// steps of its own in between.
static void a_plain_line_takes_less_than_two_steps_of_prep(check_t *check)
{
    char words[40];
    unsigned steps = 0;
    begin(1);
    CHECK_INT(check, nck_init(&nck, &machine, NULL), NCK_OK);
    (void)steps_over(check, "G61 G90 G21 G1 F3000 X0\n");
    for (int k = 0; k < 20; k++) {
        snprintf(words, sizeof words, "X%d Y%d\n", k + 1, 2 * k + 2);
        steps += steps_over(check, words);
    }
    CHECK(check, steps >= 20 && steps < 40);
}

int main(void)
{
    check_t check = {0};
    CHECK_RUN(&check, limits_hold_at_every_tick_however_slow_prep_is);
    CHECK_RUN(&check, corners_that_share_a_period_share_the_acceleration);
    CHECK_RUN(&check, corner_and_ramp_share_the_acceleration);
    CHECK_RUN(&check, setpoints_depend_on_the_program_not_on_the_pace);
    CHECK_RUN(&check, machining_time_agrees_with_the_run_to_the_tick);
    CHECK_RUN(&check, end_point_is_met_to_the_nanometre);
    CHECK_RUN(&check, many_incremental_moves_do_not_drift);
    CHECK_RUN(&check, everything_before_an_error_is_executed);
    CHECK_RUN(&check, outputs_come_in_order_and_do_not_slow_the_path);
    CHECK_RUN(&check, a_plain_line_takes_less_than_two_steps_of_prep);
    return check_end(&check);
}
