// SPDX-License-Identifier: MIT
// A stop that an input asks for: where the axes were is kept, they brake at once within their
// limits, what is left is dropped, and everything goes on from there.
//
//     test_stop [COUNT [FIRST]]   so many random paths, from this number on

#include "front_check.h"

enum { TEXT_BYTES = 4096, LINES = 12 };

static front_t front;
static nck_decode_t before;
static nck_halt_t halt;
static uint64_t seed;
static uint32_t count = 60, first;

static uint32_t pick(uint32_t n)
{
    seed = seed * 6364136223846793005u + 1442695040888963407u;
    return (uint32_t)((seed >> 33) % n);
}

static void begin(uint32_t slope)
{
    front_machine(&front, slope);
    front.machine.dialect.probe = NCK_PROBE_MISSES;
    (void)front_start(&front);
    (void)nck_begin_session(&front.nck, &before);
    memset(&halt, 0, sizeof halt);
    halt.quick = 1.0;
}

static void until_x(double x)
{
    for (int n = 0; n < 20000 && front_x(&front) < x; n++) front_tick(&front);
}

static void wander(int arcs)
{
    char text[TEXT_BYTES];
    int n = snprintf(text, sizeof text, "G21 G90 G64 P0.0%u\n", pick(3));
    for (int k = 0; k < LINES; k++) {
        const int bends = arcs && pick(3) == 0;
        const char *const code = bends ? "G2 R99" : pick(4) ? "G1" : "G0";
        n += snprintf(text + n, sizeof text - (size_t)n, "%s X%u Y%u Z%u F%u\n", code, pick(70),
                      pick(70), bends ? 0 : pick(9), 300 + pick(9000));
    }
    front_push(&front, text);
    nck_flush(&front.nck);
}

// What an axis feels of one tick after the other.
typedef struct felt {
    double v[NCK_AXIS_MAX];
    double a[NCK_AXIS_MAX];
} felt_t;

static void feel(felt_t *felt, const nck_axes_t *was)
{
    const double period = front.machine.period_s;
    for (uint32_t k = 0; k < nck_joint_count(&front.nck); k++) {
        const double way = (double)(front.axes.joint_nm[k] - was->joint_nm[k]) * 1e-6;
        felt->a[k] = (way / period - felt->v[k]) / period;
        felt->v[k] = way / period;
    }
}

// Two halves of a nanometre, felt in a period.
static double noise(void) { return 4e-6 / front.machine.period_s / front.machine.period_s; }

// Every axis of the machine within so many times its acceleration.
static int keeps(const felt_t *felt, double times)
{
    int within = 1;
    for (uint32_t k = 0; k < nck_joint_count(&front.nck); k++) {
        const nck_axis_t *const axis = &front.machine.axis[nck_joint_axis(&front.nck, k)];
        within = within && fabs(felt->a[k]) <= axis->a_max * times * 1.02 + noise();
    }
    return within;
}

// The axes brake straight on: every one has gone the same share of its way. Returns the ticks.
static int brake(check_t *check, const felt_t *at_first)
{
    felt_t felt = *at_first;
    int ticks = 0;
    for (; ticks < 20000 && !(ticks > 0 && nck_is_idle(&front.nck)); ticks++) {
        const nck_axes_t was = front.axes;
        front_tick(&front);
        feel(&felt, &was);
        // what the path had of acceleration goes at once, beside what the stop begins with
        CHECK(check, keeps(&felt, ticks == 0 ? halt.quick + 1.0 : halt.quick));
        CHECK_INT(check, front.state, NCK_TICK_HOLD);
    }
    return ticks;
}

static void check_stop(check_t *check, uint32_t number)
{
    felt_t felt = {{0}, {0}};
    nck_axes_t latched, was;
    seed = number;
    begin(pick(2) ? NCK_SLOPE_JERK : NCK_SLOPE_LINEAR);
    halt.quick = 1.0 + pick(3);
    wander(1);
    for (uint32_t n = 2 + pick(6000); n > 0; n--) {
        was = front.axes;
        front_tick(&front);
        feel(&felt, &was);
    }
    was = front.axes;
    nck_stop_at(&front.nck, &halt);
    CHECK_INT(check, nck_stopped_at(&front.nck, &halt, &latched), NCK_EMPTY);
    CHECK(check, brake(check, &felt) < 2000);
    CHECK_INT(check, nck_stopped_at(&front.nck, &halt, &latched), NCK_OK);
    CHECK(check, memcmp(&latched, &was, sizeof latched) == 0);
    const nck_axes_t rest = front.axes;
    front_rest(&front);
    CHECK(check, memcmp(&rest, &front.axes, sizeof rest) == 0);
    CHECK_INT(check, nck_go_on(&front.nck), NCK_OK);
    front_push(&front, "G91 G1 X1 F600\n");
    nck_flush(&front.nck);
    front_rest(&front);
    CHECK_INT(check, front.axes.joint_nm[0], rest.joint_nm[0] + 1000000);
    CHECK_INT(check, front.axes.joint_nm[1], rest.joint_nm[1]);
    CHECK_INT(check, nck_invariants(&front.nck), 0);
}

static void the_axes_brake_from_wherever_they_are(check_t *check)
{
    for (uint32_t k = 0; k < count; k++) {
        const int failed = check->broken;
        check_stop(check, first + k);
        if (check->broken > failed) printf("path %u\n", first + k);
    }
}

// A line at a constant speed: the way from the formula, and twice as quick it is half as long.
static void a_line_takes_the_way_of_the_formula(check_t *check)
{
    for (uint32_t quick = 1; quick <= 4; quick *= 2) {
        begin(NCK_SLOPE_LINEAR);
        halt.quick = quick;
        front_push(&front, "G1 X200 Y150 F6000\n");
        nck_flush(&front.nck);
        until_x(50.0);
        const double from = front_x(&front);
        const double a = front.machine.axis[0].a_max;
        nck_stop_at(&front.nck, &halt);
        front_rest(&front);
        CHECK_NEAR(check, front_x(&front) - from, 0.75 * 80.0 * 80.0 / a / quick, 1e-5);
        CHECK_NEAR(check, front.pose.axis[1], 0.75 * front.pose.axis[0], 1e-6);
    }
}

// Nothing moves: the stop is over in the next tick, and again.
static void a_stop_at_rest_is_none(check_t *check)
{
    begin(NCK_SLOPE_JERK);
    for (int n = 0; n < 3; n++) {
        front_push(&front, "G91 G1 X3 F900\n");
        nck_flush(&front.nck);
        front_rest(&front);
        const nck_axes_t rest = front.axes;
        nck_stop_at(&front.nck, &halt);
        front_tick(&front);
        CHECK(check, nck_is_idle(&front.nck));
        CHECK(check, memcmp(&rest, &front.axes, sizeof rest) == 0);
        front_rest(&front);
        CHECK_INT(check, nck_go_on(&front.nck), NCK_OK);
    }
    CHECK_NEAR(check, front_x(&front), 9.0, 1e-6);
}

// The first contact counts, however often a switch bounces.
static void a_stop_in_work_is_not_begun_anew(check_t *check)
{
    nck_axes_t latched, was;
    begin(NCK_SLOPE_JERK);
    front_push(&front, "G1 X200 F6000\n");
    nck_flush(&front.nck);
    until_x(50.0);
    was = front.axes;
    for (int n = 0; n < 30; n++) {
        nck_stop_at(&front.nck, &halt);
        front_tick(&front);
    }
    front_rest(&front);
    CHECK_INT(check, nck_stopped_at(&front.nck, &halt, &latched), NCK_OK);
    CHECK_INT(check, latched.joint_nm[0], was.joint_nm[0]);
    CHECK_INT(check, nck_go_on(&front.nck), NCK_OK);
}

// At a wait, in a dwell and while nobody prepares.
static void it_stops_what_does_not_move(check_t *check)
{
    static const char *const text[] = {"M0\nG1 X5\n", "G4 P9\nG1 X5\n"};
    for (int k = 0; k < 2; k++) {
        begin(NCK_SLOPE_JERK);
        front_push(&front, text[k]);
        nck_flush(&front.nck);
        for (int n = 0; n < 50; n++) front_tick(&front);
        nck_stop_at(&front.nck, &halt);
        front_rest(&front);
        CHECK(check, nck_is_idle(&front.nck));
        CHECK_INT(check, nck_go_on(&front.nck), NCK_OK);
        front_push(&front, "G1 X1 F600\n");
        nck_flush(&front.nck);
        front_rest(&front);
        CHECK_NEAR(check, front_x(&front), 1.0, 1e-6);
    }
}

// The axes are told where they stand, and an input stops them in the period that hears of it.
static void a_stop_while_the_place_is_told(check_t *check)
{
    const int64_t place_nm[NCK_AXIS_MAX] = {70000000, -30000000};
    for (int late = 0; late < 3; late++) {
        begin(NCK_SLOPE_JERK);
        front_push(&front, "G91 G1 X3 F900\n");
        nck_flush(&front.nck);
        front_rest(&front);
        CHECK_INT(check, nck_set_position(&front.nck, place_nm), NCK_OK);
        for (int n = 0; n < late; n++) front_tick(&front);
        nck_stop_at(&front.nck, &halt);
        for (int n = 0; n < 50; n++) {
            front_tick(&front);
            CHECK_INT(check, front.axes.joint_nm[0], 70000000);
            CHECK_INT(check, front.axes.joint_nm[1], -30000000);
        }
        CHECK(check, nck_is_idle(&front.nck) && nck_fence_load(&halt.periods) == 1);
        CHECK_INT(check, nck_go_on(&front.nck), NCK_OK);
        front_push(&front, "G1 X1\n");
        nck_flush(&front.nck);
        front_rest(&front);
        CHECK_INT(check, front.axes.joint_nm[0], 71000000);
        CHECK_INT(check, nck_invariants(&front.nck), 0);
    }
}

// What a probe has found is told to the lines behind it, in the program's coordinates.
static void a_probe_tells_where_it_touched(check_t *check)
{
    if (!NCK_HAS_CYCLES || !NCK_HAS_VARIABLES) return;
    begin(NCK_SLOPE_JERK);
    CHECK_INT(check, nck_probed(&front.nck, NULL), NCK_OK);
    front_push(&front, "G10 L2 P1 Z-3\nG90 G38.2 Z-20 F600\n");
    nck_flush(&front.nck);
    for (int n = 0; n < 20000 && front.axes.joint_nm[2] > -5000000; n++) front_tick(&front);
    const double touched = (double)front.axes.joint_nm[2] * 1e-6;
    nck_stop_at(&front.nck, &halt);
    front_rest(&front);
    CHECK(check, front.pose.axis[2] < touched);
    CHECK_INT(check, nck_go_on(&front.nck), NCK_OK);
    CHECK_INT(check, nck_probed(&front.nck, &halt), NCK_OK);
    front_push(&front, "G0 X[#5063+9] Y#5070\n");
    nck_flush(&front.nck);
    front_rest(&front);
    CHECK_INT(check, front.error, NCK_OK);
    CHECK_NEAR(check, front_x(&front), touched + 12.0, 2e-6);
    CHECK_NEAR(check, front.pose.axis[1], 1.0, 1e-6);
    front_push(&front, "G38.3 X5 F900\nG0 Y[#5070+7]\n");
    nck_flush(&front.nck);
    front_rest(&front);
    CHECK_NEAR(check, front.pose.axis[1], 7.0, 1e-6);
}

static void a_probe_is_asked_in_a_session_alone(check_t *check)
{
    front_machine(&front, NCK_SLOPE_JERK);
    front.machine.dialect.probe = NCK_PROBE_MISSES;
    (void)front_start(&front);
    CHECK_INT(check, nck_probed(&front.nck, NULL), NCK_E_STATE);
    front_push(&front, "G90 G38.2 Z-20 F600\n");
    nck_flush(&front.nck);
    front_rest(&front);
    CHECK(check, front.error < NCK_OK);
}

int main(int argc, char **argv)
{
    check_t check = {0};
    check_seeds(argc, argv, &count, &first);
    CHECK_RUN(&check, the_axes_brake_from_wherever_they_are);
    CHECK_RUN(&check, a_line_takes_the_way_of_the_formula);
    CHECK_RUN(&check, a_stop_at_rest_is_none);
    CHECK_RUN(&check, a_stop_in_work_is_not_begun_anew);
    CHECK_RUN(&check, it_stops_what_does_not_move);
    CHECK_RUN(&check, a_stop_while_the_place_is_told);
    CHECK_RUN(&check, a_probe_tells_where_it_touched);
    CHECK_RUN(&check, a_probe_is_asked_in_a_session_alone);
    return check_end(&check);
}
