// SPDX-License-Identifier: MIT
// The caps of room 4 as setpoints show them: within a tolerance no axis leaves its speed,
// acceleration or jerk at any tick, whatever the overrides do.
#include <math.h>   // fabs sin cos
#include <stdint.h> // uint64_t
#include <string.h> // memmove memset

#include "check.h"
#include "sim.h" // sim_t nck_t

enum { TEXT_MAX = 40000, ROWS = 97, TICKS_MAX = 200000 };

#define PERIOD 0.001
// Third differences of doubles: 100 mm · 2⁻⁵² · 8 / (1 ms)³ is 2e-7 of a jerk of 1e4.
#define ROUNDING 1e-6

static nck_t nck;
static sim_t sim;
static sim_row_t rows[ROWS];
static char text[TEXT_MAX];
static size_t text_size;
static uint64_t seed;

typedef struct peaks {
    double v, a, j; // largest share of an axis' limit
    long ticks;
} peaks_t;

// Xorshift, G. Marsaglia 2003: the same numbers everywhere.
static uint32_t random_below(uint32_t n)
{
    seed ^= seed << 13;
    seed ^= seed >> 7;
    seed ^= seed << 17;
    return (uint32_t)((seed >> 11) % n);
}

static void begin_text(const char *head)
{
    text_size = (size_t)snprintf(text, sizeof text, "%s", head);
}

static void add_move(double x, double y, double z)
{
    text_size += (size_t)snprintf(text + text_size, sizeof text - text_size,
                                  "G1 X%.4f Y%.4f Z%.4f\n", x, y, z);
}

// Micro-segments of a wavy ring, then a staircase of right angles.
static void add_path(int segments, int stairs)
{
    for (int k = 1; k <= segments; k++) {
        const double t = 0.004 * k;
        const double r = 12.0 + sin(7.0 * t);
        add_move(r * cos(t), r * sin(t), sin(5.0 * t));
    }
    const double x = 12.0 * cos(0.004 * segments);
    const double y = 12.0 * sin(0.004 * segments);
    for (int k = 0; k < stairs; k++) {
        add_move(x + 2.0 * (k / 2 + 1), y + 2.0 * ((k + 1) / 2), 0.0);
    }
}

static nck_machine_t machine_of(double j)
{
    nck_machine_t machine;
    nck_machine_default(&machine);
    machine.slope = NCK_SLOPE_JERK;
    machine.path.j_max = j;
    machine.path.a_max = 1500.0;
    for (int x = 0; x < 3; x++) machine.axis[x].j_max = j;
    machine.axis[1].a_max = 600.0;
    machine.axis[1].j_max = 0.5 * j;
    machine.axis[2].v_max = 20.0;
    machine.axis[2].rapid = 20.0;
    return machine;
}

static void look_at(const nck_machine_t *machine, double p[4][3], const nck_pose_t *pose,
                    peaks_t *peaks)
{
    memmove(p[1], p[0], 3 * sizeof p[0]);
    for (int x = 0; x < 3; x++) {
        const nck_axis_t *const axis = &machine->axis[x];
        p[0][x] = pose->axis[x];
        const double v = p[0][x] - p[1][x];
        const double a = v - (p[1][x] - p[2][x]);
        const double j = a - (p[1][x] - 2.0 * p[2][x] + p[3][x]);
        peaks->v = fmax(peaks->v, fabs(v) / PERIOD / axis->v_max);
        peaks->a = fmax(peaks->a, fabs(a) / (PERIOD * PERIOD) / axis->a_max);
        peaks->j = fmax(peaks->j, fabs(j) / (PERIOD * PERIOD * PERIOD) / axis->j_max);
    }
    peaks->ticks++;
}

// Run the text; spread: overrides between 100 % and this far to both sides change at random.
static peaks_t run(check_t *check, const nck_machine_t *machine, uint32_t spread)
{
    peaks_t peaks = {0.0, 0.0, 0.0, 0};
    double p[4][3];
    memset(p, 0, sizeof p);
    seed = 88172645463325252u;
    CHECK_INT(check, sim_init(&sim, &nck, machine, text, text_size, 400), NCK_OK);
    nck_status_t status = NCK_OK;
    while (status == NCK_OK && peaks.ticks < TICKS_MAX) {
        size_t count = 0;
        if (spread > 0) {
            const uint32_t percent = 100 - spread + random_below(2 * spread + 1);
            nck_set_override(&nck, percent * NCK_PERCENT, 100 * NCK_PERCENT);
        }
        status = sim_run(&sim, rows, ROWS, &count);
        for (size_t i = 0; i < count; i++) look_at(machine, p, &rows[i].pose, &peaks);
    }
    CHECK_INT(check, status, NCK_DONE);
    return peaks;
}

// In exact path corners cost jerk without limit, but speed and acceleration hold.
static void exact_path_keeps_speed_and_acceleration(check_t *check)
{
    const double jerks[] = {1e4, 1e5, 1e6};
    begin_text("G21 G17 G90 G61\nF3000\nG1 X12\n");
    add_path(500, 20);
    for (int k = 0; k < 3; k++) {
        const nck_machine_t machine = machine_of(jerks[k]);
        const peaks_t peaks = run(check, &machine, 90);
        CHECK(check, peaks.v <= 1.0 + ROUNDING);
        CHECK(check, peaks.a <= 1.0 + ROUNDING);
        CHECK(check, peaks.a >= 0.7);
    }
}

int main(void)
{
    check_t check = {0};
    CHECK_RUN(&check, exact_path_keeps_speed_and_acceleration);
    return check_end(&check);
}
