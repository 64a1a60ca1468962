// SPDX-License-Identifier: MIT
// Drives with a position loop: places are the setpoints of a period before, speeds and torques
// belong to them, and one that does not follow is a fault.
//
//     test_drive [COUNT [FIRST]]   so many random programs, from this number on

#include "drive/drive.h"
#include "front_check.h"

enum { MOTORS = 4, TICKS = 3000 };

static front_t front;
static nck_decode_t before;
static drive_t drive;
static drive_set_t set;
static drive_target_t target[MOTORS];
static int32_t actual[MOTORS];
static uint64_t seed;
static uint32_t count = 12, first = 1;

static double draw(double low, double high)
{
    seed = seed * 6364136223846793005u + 1442695040888963407u;
    return low + (high - low) * (double)(seed >> 40) / 16777216.0;
}

static void begin(void)
{
    front_machine(&front, draw(0.0, 1.0) < 0.5 ? NCK_SLOPE_LINEAR : NCK_SLOPE_JERK);
    (void)front_start(&front);
    (void)nck_begin_session(&front.nck, &before);
    set.period_s = front.machine.period_s;
    set.motors = MOTORS;
    for (uint8_t m = 0; m < MOTORS; m++) {
        set.motor[m] = (drive_motor_set_t){.counts = 1e6, .increments = draw(100.0, 20000.0),
                               .inertia = 0.05, .viscous = 0.2, .friction = 7.0,
                               .torque_most = 900.0, .follow_most = 0.5, .periods = 3,
                               .lag = (uint32_t)draw(0.0, 4.0), .joint = m < 3 ? m : 0};
        if (draw(0.0, 1.0) < 0.5) set.motor[m].increments = -set.motor[m].increments;
        actual[m] = (int32_t)draw(-2.0e9, 2.0e9);
    }
}

static int init(void)
{
    return drive_init(&drive, &set, &front.axes, nck_places(&front.nck), actual);
}

static uint32_t period(void)
{
    front_tick(&front);
    drive_period(&drive, &front.axes, nck_places(&front.nck), target);
    return drive_follow(&drive, actual);
}

// How far a drive has been sent since it began, modulo 2³² [increments].
static double sent(uint32_t m, int32_t from)
{
    const uint32_t way = (uint32_t)target[m].position - (uint32_t)from;
    return way <= INT32_MAX ? (double)way : (double)way - 4294967296.0;
}

static void check_motor(check_t *check, uint32_t m, const int32_t *from, const double *past)
{
    const double unit = set.motor[m].increments, period_s = front.machine.period_s;
    const double speed = (past[0] - past[2]) / (2.0 * period_s);
    const double change = (past[0] - 2.0 * past[1] + past[2]) / (period_s * period_s);
    const double sign = speed > 0.0 ? 7.0 : speed < 0.0 ? -7.0 : 0.0;
    const double torque = 0.05 * change + 0.2 * speed + sign;
    const double kept = torque > 900.0 ? 900.0 : torque < -900.0 ? -900.0 : torque;
    CHECK(check, fabs(sent(m, from[m]) - past[1] * unit) <= 0.51);
    CHECK(check, fabs(target[m].velocity - speed * unit) <= 0.51 + 1e-9 * fabs(speed * unit));
    CHECK(check, fabs(target[m].torque - (unit < 0.0 ? -kept : kept)) <= 0.51);
}

// One program. from: where the drives were; past: the ways of the last setpoints [mm]; told: the
// last targets. Each follows at once, and is read back as late as it has said.
static void run(check_t *check, const int32_t *from)
{
    double past[MOTORS][3] = {{0.0}};
    int32_t told[MOTORS][DRIVE_LAG_MOST + 1];
    const nck_axes_t begun = front.axes;
    memset(told, 0, sizeof told);
    for (uint32_t m = 0; m < MOTORS; m++) {
        for (int n = 0; n <= DRIVE_LAG_MOST; n++) told[m][n] = from[m];
    }
    for (int n = 0; n < TICKS; n++) {
        (void)period();
        for (uint32_t m = 0; m < MOTORS; m++) {
            const uint8_t joint = set.motor[m].joint;
            const uint32_t lag = set.motor[m].lag;
            memmove(past[m] + 1, past[m], 2 * sizeof past[m][0]);
            past[m][0] = 1e-6 * (double)(front.axes.joint_nm[joint] - begun.joint_nm[joint]);
            check_motor(check, m, from, past[m]);
            memmove(told[m] + 1, told[m], DRIVE_LAG_MOST * sizeof told[m][0]);
            told[m][0] = target[m].position;
            actual[m] = told[m][lag > 0 ? lag - 1 : 0];
        }
    }
}

static void targets_are_the_setpoints_of_a_period_before(check_t *check)
{
    for (uint32_t k = 0; k < count; k++) {
        int32_t from[MOTORS];
        char text[128];
        seed = first + k;
        begin();
        CHECK(check, init());
        memcpy(from, actual, sizeof from);
        (void)snprintf(text, sizeof text, "G91G1X%.3fY%.3fF3000\nG2X%.3fR20\nG0X-3Z1\n",
                       draw(-9.0, 9.0), draw(-9.0, 9.0), draw(1.0, 30.0));
        front_push(&front, text);
        nck_flush(&front.nck);
        run(check, from);
        CHECK_INT(check, drive.faults, 0);
        CHECK(check, front.moving > 200);
    }
}

static void one_that_stands_still_is_a_fault(check_t *check)
{
    seed = 3;
    begin();
    CHECK(check, init());
    front_push(&front, "G91G1Y30F3000\n");
    nck_flush(&front.nck);
    int n = 0;
    while (period() == 0 && n < TICKS) n++;
    CHECK_INT(check, drive.faults, 1u << 1);
    const double off = drive.motor[1].error / set.motor[1].increments;
    CHECK(check, off > 0.5 && off < 0.5 + 0.05 * (double)(3 + DRIVE_LAG_MOST));
    for (uint32_t m = 0; m < MOTORS; m++) actual[m] = target[m].position;
    CHECK_INT(check, period(), 1u << 1); // it stays
}

static void where_the_axes_are_told_to_stand_moves_nothing(check_t *check)
{
    int64_t place_nm[NCK_AXIS_MAX] = {-7000000, 5000000, 3000000};
    int32_t from[MOTORS];
    seed = 4;
    begin();
    CHECK(check, init());
    memcpy(from, actual, sizeof from);
    (void)period();
    CHECK_INT(check, nck_set_position(&front.nck, place_nm), NCK_OK);
    for (int n = 0; n < 10; n++) {
        CHECK_INT(check, period(), 0);
        for (uint32_t m = 0; m < MOTORS; m++) {
            CHECK_INT(check, target[m].position, from[m]);
            CHECK(check, target[m].velocity == 0 && target[m].torque == 0);
        }
    }
    CHECK_INT(check, front.axes.joint_nm[0], -7000000);
}

static void numbers_out_of_range_are_refused(check_t *check)
{
    seed = 1;
    begin();
    set.motor[2].increments = 0.0;
    CHECK(check, !init());
    begin();
    set.motor[0].lag = DRIVE_LAG_MOST + 1;
    CHECK(check, !init());
    begin();
    set.motor[3].periods = 0;
    CHECK(check, !init());
    begin();
    set.motor[1].torque_most = 40000.0;
    CHECK(check, !init());
    begin();
    set.period_s = 0.0;
    CHECK(check, !init());
    begin();
    set.motors = DRIVE_MOTORS + 1;
    CHECK(check, !init());
}

int main(int argc, char **argv)
{
    check_t check = {0};
    check_seeds(argc, argv, &count, &first);
    CHECK_RUN(&check, targets_are_the_setpoints_of_a_period_before);
    CHECK_RUN(&check, one_that_stands_still_is_a_fault);
    CHECK_RUN(&check, where_the_axes_are_told_to_stand_moves_nothing);
    CHECK_RUN(&check, numbers_out_of_range_are_refused);
    return check_end(&check);
}
