// SPDX-License-Identifier: MIT
// Soft limits: the path rests before it leaves them, within the limits of acceleration, not sooner
// than a brake needs, and goes on when they are wide enough.
#include "front_check.h"

enum { SLOPES = 2 };

static front_t front;
static double a_most; // of any axis at any tick [mm/s²]

static nck_axes_t before[2];
static const char *text; // what is left of the program

static void tick(void)
{
    const double period = front.machine.period_s;
    for (size_t used = 1; used > 0; text += used) {
        (void)nck_push(&front.nck, text, strlen(text), &used);
        front_prep(&front);
    }
    if (*text == 0) nck_end(&front.nck);
    front_tick(&front);
    for (uint32_t k = 0; k < nck_joint_count(&front.nck); k++) {
        const int64_t twice = front.axes.joint_nm[k] - 2 * before[0].joint_nm[k]
                              + before[1].joint_nm[k];
        a_most = fmax(a_most, fabs((double)twice) * 1e-6 / (period * period));
    }
    before[1] = before[0];
    before[0] = front.axes;
}

static void begin(uint32_t slope, double tolerance, const char *program)
{
    front_machine(&front, slope);
    front.machine.path.tolerance = tolerance;
    (void)front_start(&front);
    before[0] = before[1] = front.axes;
    a_most = 0.0;
    text = program;
}

static void ticks(int count)
{
    for (int n = 0; n < count; n++) tick();
}

static void until_rest(void)
{
    uint64_t still = 0;
    for (int n = 0; n < FRONT_TICKS && still < 100; n++) {
        const uint64_t moving = front.moving;
        tick();
        still = front.moving == moving ? still + 1 : 0;
    }
}

static nck_status_t limit(double least, double most)
{
    return nck_set_travel(&front.nck, NCK_AXIS_X, (int64_t)(least * 1e6), (int64_t)(most * 1e6));
}

static const char *const line = "G1 X1000 F6000\nM2\n";

// A brake from 100 mm/s, and ten periods until it begins: what is lost in front of the limit.
static const double least_way[] = {5.0, 10.0};

static void a_line_is_left_as_late_as_it_can_be(check_t *check)
{
    for (uint32_t slope = 0; slope < SLOPES; slope++) {
        begin(slope, 0.0, line);
        ticks(1000);
        CHECK_INT(check, limit(-10.0, 300.0), NCK_OK);
        until_rest();
        CHECK(check, front_x(&front) <= 300.0);
        CHECK(check, front_x(&front) > 300.0 - 1.2 * least_way[slope] - 3.0);
        CHECK_INT(check, front.state, NCK_TICK_HOLD);
        CHECK(check, nck_is_at_travel(&front.nck));
        CHECK(check, a_most <= 1000.0 + 10.0); // setpoints are whole nanometres
        nck_resume(&front.nck);
        until_rest();
        CHECK_INT(check, front.state, NCK_TICK_HOLD); // not wide enough so far
        CHECK_INT(check, limit(-10.0, 1000.0), NCK_OK);
        CHECK(check, !nck_is_at_travel(&front.nck));
        nck_resume(&front.nck);
        until_rest();
        CHECK_NEAR(check, front_x(&front), 1000.0, 1e-9);
        CHECK_INT(check, front.status, NCK_DONE);
    }
}

// What the path never reaches holds nobody, and no setpoint is another.
static void a_path_inside_is_left_alone(check_t *check)
{
    const char *const program = "G1 F3000 X10\nG3 X10 Y40 J20\nG1 X0\nG2 X0 Y0 J-20\nM2\n";
    for (uint32_t slope = 0; slope < SLOPES; slope++) {
        begin(slope, 0.01, program);
        until_rest();
        const uint64_t hash = front.hash;
        begin(slope, 0.01, program);
        CHECK_INT(check, limit(-20.001, 30.001), NCK_OK);
        until_rest();
        CHECK(check, front.hash == hash && front.status == NCK_DONE);
    }
}

// Circles, corners within a tolerance, blocks of 0.1 mm, at limits all along the way.
static void no_path_leaves_and_no_limit_breaks(check_t *check)
{
    static char micro[16384];
    size_t n = (size_t)snprintf(micro, sizeof micro, "G1 F3000 X0.1\n");
    for (int k = 2; k <= 600; k++) {
        const double x = 0.1 * k;
        n += (size_t)snprintf(micro + n, sizeof micro - n, "X%.3f Y%.3f\n", x, sin(x / 2.0));
    }
    const char *const programs[] = {
        "G1 F4000 X20\nG3 X20 Y40 J20\nG1 X0\nM2\n",
        "G1 F6000 X10\nY5\nX20\nY0\nX30\nY5\nX40\nY0\nX50\nM2\n", micro,
    };
    const double place[] = {9.0, 23.7, 39.3};
    for (uint32_t trial = 0; trial < 9 * SLOPES; trial++) {
        const double most = place[trial / SLOPES / 3];
        begin(trial % SLOPES, 0.01, programs[trial / SLOPES % 3]);
        CHECK_INT(check, limit(-1.0, most), NCK_OK);
        until_rest();
        CHECK(check, front_x(&front) <= most);
        CHECK(check, front.state == NCK_TICK_HOLD && nck_is_at_travel(&front.nck));
        CHECK(check, a_most <= 1000.0 * 1.01);
        const double rest = front_x(&front);
        CHECK_INT(check, limit(-1.0, 70.0), NCK_OK);
        nck_resume(&front.nck);
        until_rest();
        CHECK(check, front.status == NCK_DONE && front_x(&front) != rest);
        CHECK(check, a_most <= 1000.0 * 1.01);
    }
}

// Outside already, or nearer than a brake: it rests as soon as it can.
static void too_late_is_as_a_hold(check_t *check)
{
    for (uint32_t slope = 0; slope < SLOPES; slope++) {
        begin(slope, 0.0, line);
        ticks(1000);
        const double x = front_x(&front);
        CHECK_INT(check, limit(0.0, x - 1.0), NCK_OK);
        until_rest();
        CHECK_INT(check, front.state, NCK_TICK_HOLD);
        CHECK(check, front_x(&front) < x + 2.5 * least_way[slope]);
        CHECK(check, a_most <= 1000.0 + 10.0);
    }
}

// Behind the end of one program the limits hold for the next, from where the axes are.
static void they_stay(check_t *check)
{
    begin(NCK_SLOPE_JERK, 0.0, "G1 X5\nM2\n");
    CHECK_INT(check, limit(0.0, 6.0), NCK_OK);
    until_rest();
    CHECK_INT(check, nck_begin(&front.nck), NCK_OK);
    text = "G1 X-3\nM2\n";
    until_rest();
    CHECK(check, nck_is_at_travel(&front.nck) && front_x(&front) >= 0.0);
    nck_abort(&front.nck);
    until_rest();
    CHECK_INT(check, nck_begin(&front.nck), NCK_OK);
    CHECK(check, !nck_is_at_travel(&front.nck));
    text = "G1 X5.5\nM2\n";
    until_rest();
    CHECK_NEAR(check, front_x(&front), 5.5, 1e-9);
}

static void what_makes_no_sense_is_refused(check_t *check)
{
    begin(NCK_SLOPE_JERK, 0.0, line);
    CHECK_INT(check, nck_set_travel(&front.nck, NCK_AXIS_MAX, 0, 1), NCK_E_ARGUMENT);
    CHECK_INT(check, nck_set_travel(&front.nck, 0, 1, 0), NCK_E_ARGUMENT);
    CHECK_INT(check, nck_set_travel(&front.nck, 0, INT64_MIN, INT64_MAX), NCK_OK);
    until_rest();
    CHECK_NEAR(check, front_x(&front), 1000.0, 1e-9);
}

int main(void)
{
    check_t check = {0};
    CHECK_RUN(&check, a_line_is_left_as_late_as_it_can_be);
    CHECK_RUN(&check, a_path_inside_is_left_alone);
    CHECK_RUN(&check, no_path_leaves_and_no_limit_breaks);
    CHECK_RUN(&check, too_late_is_as_a_hold);
    CHECK_RUN(&check, they_stay);
    CHECK_RUN(&check, what_makes_no_sense_is_refused);
    return check_end(&check);
}
