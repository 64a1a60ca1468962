// SPDX-License-Identifier: MIT
// Step and direction against a model that counts edges: within one step of where the setpoints lead
// at every time, through holds, overrides and stops; lines keep their times.
//
//     test_pulse [COUNT [FIRST]]   so many random machines, from this number on

#include "front_check.h"
#include "pulse/pulse.h"

enum { INTERRUPTS_MOST = 500, TICKS = 3000 };

static front_t front;
static nck_decode_t before;
static nck_halt_t halt;
static pulse_t pulse;
static pulse_set_t set;
static uint64_t seed;
static uint32_t count = 25, first;

static uint32_t pick(uint32_t n)
{
    seed = seed * 6364136223846793005u + 1442695040888963407u;
    return (uint32_t)((seed >> 33) % n);
}

// What a drive counts, and how long its lines have stood.
typedef struct drive {
    int64_t steps[PULSE_MOTORS];
    uint32_t stood[PULSE_MOTORS]; // interrupts since the direction changed
    uint32_t directions, high;
    double worst;                 // beside the model [steps]
    uint32_t short_setups, short_pauses;
} drive_t;

static drive_t drive;

static void interrupt(void)
{
    const uint32_t high = pulse_interrupt(&pulse);
    drive.short_pauses += (high & drive.high) != 0;
    for (uint32_t m = 0; m < set.motors; m++) {
        const uint32_t bit = 1u << m;
        const int changes = ((drive.directions ^ pulse.directions) & bit) != 0;
        drive.stood[m] = changes ? 0 : drive.stood[m] + 1;
        if (!(high & bit)) continue;
        drive.short_setups += drive.stood[m] < pulse.setup;
        const int up = ((pulse.directions & bit) != 0) != (set.motor[m].reversed != 0);
        drive.steps[m] += up ? 1 : -1;
    }
    drive.directions = pulse.directions;
    drive.high = high;
}

static double steps_of(uint32_t m, const nck_axes_t *axes)
{
    const pulse_motor_set_t *const motor = &set.motor[m];
    return (double)axes->joint_nm[motor->joint] / motor->counts * motor->steps;
}

// The period from one setpoint to the next, as the drives have it.
static void period(const nck_axes_t *from, const nck_axes_t *to, const int64_t *zero)
{
    for (uint32_t i = 1; i <= set.interrupts; i++) {
        interrupt();
        const double share = (double)i / set.interrupts;
        for (uint32_t m = 0; m < set.motors; m++) {
            const double a = steps_of(m, from), b = steps_of(m, to);
            const double at = (double)(drive.steps[m] - zero[m]);
            drive.worst = fmax(drive.worst, fabs(a + (b - a) * share - at));
        }
    }
}

static void begin(uint32_t slope)
{
    front_machine(&front, slope);
    for (int x = 0; x < 3; x++) {
        front.machine.axis[x].v_max = front.machine.axis[x].rapid = 250.0;
        front.machine.axis[x].a_max = 300.0 + pick(5000);
    }
    (void)front_start(&front);
    (void)nck_begin_session(&front.nck, &before);
    memset(&set, 0, sizeof set);
    memset(&drive, 0, sizeof drive);
    set.period_s = front.machine.period_s;
    set.motors = 3;
    for (uint32_t m = 0; m < set.motors; m++) {
        set.motor[m].joint = (uint8_t)m;
        set.motor[m].counts = 1e6;
        set.motor[m].steps = 10.0 + pick(390) + 0.1 * pick(10);
        set.motor[m].reversed = (uint8_t)pick(2);
    }
    set.interrupts = 220 + pick(INTERRUPTS_MOST - 219);
    set.pulse_s = 1e-6;
    set.setup_s = 1e-6 * pick(12);
}

static void start(check_t *check)
{
    CHECK(check, pulse_init(&pulse, &set, &front.axes, nck_places(&front.nck)));
    drive.directions = pulse.directions;
    interrupt();                           // a period without a setpoint: nothing moves
    while (pulse.left > 0) interrupt();
}

static void wander(void)
{
    char text[64];
    for (int k = 0; k < 4; k++) {
        (void)snprintf(text, sizeof text, "G1 X%d.%u Y%d Z%d F%u\n", (int)pick(80) - 40, pick(999),
                       (int)pick(80) - 40, (int)pick(20) - 10, 200 + pick(14800));
        front_push(&front, text);
    }
    nck_flush(&front.nck);
}

static void operate(void)
{
    switch (pick(400)) {
    case 0: nck_hold(&front.nck); break;
    case 1:
    case 2: nck_resume(&front.nck); break;
    case 3: nck_set_override(&front.nck, pick(200) * NCK_PERCENT, 100 * NCK_PERCENT); break;
    case 4: halt.quick = 1.0; nck_stop_at(&front.nck, &halt); break;
    default: break;
    }
    if (nck_go_on(&front.nck) == NCK_OK) wander();
}

static void check_machine(check_t *check, uint32_t number)
{
    static const int64_t zero[PULSE_MOTORS];
    seed = number;
    begin(pick(2) ? NCK_SLOPE_JERK : NCK_SLOPE_LINEAR);
    start(check);
    wander();
    for (int n = 0; n < TICKS; n++) {
        const nck_axes_t was = front.axes;
        operate();
        front_tick(&front);
        CHECK(check, pulse_period(&pulse, &front.axes, nck_places(&front.nck)));
        period(&was, &front.axes, zero);
    }
    // a direction line takes its time, when a motor is slow
    if (!CHECK(check, drive.worst <= 1.0)) printf("machine %u: %.3f\n", number, drive.worst);
    CHECK_INT(check, drive.short_setups + drive.short_pauses, 0);
    CHECK_INT(check, pulse.late, 1);
    for (uint32_t m = 0; m < set.motors; m++) {
        CHECK_NEAR(check, (double)drive.steps[m], steps_of(m, &front.axes), 0.51);
    }
}

static void steps_are_where_the_setpoints_lead(check_t *check)
{
    for (uint32_t k = 0; k < count; k++) check_machine(check, first + k);
}

// 201 000 steps a second, 20 000 periods there and back: no drift, and hardly beside the line.
static void the_fastest_motor_does_not_drift(check_t *check)
{
    static const int64_t zero[PULSE_MOTORS];
    nck_axes_t from = {{0}}, to = {{0}};
    begin(NCK_SLOPE_LINEAR);
    set.motors = 1;
    set.motor[0].steps = 1000.0;
    set.interrupts = 403;
    set.setup_s = 0.0;
    start(check);
    for (int n = 0; n < 20000; n++) {
        to.joint_nm[0] = from.joint_nm[0] + (n < 10000 ? 201000 : -201000);
        CHECK(check, pulse_period(&pulse, &to, 1));
        period(&from, &to, zero);
        from = to;
    }
    CHECK(check, drive.worst <= 0.52);
    CHECK_INT(check, drive.steps[0], 0);
    CHECK_INT(check, drive.short_pauses, 0);
    printf("    201 kHz: %.3f steps beside the line\n", drive.worst);
    to.joint_nm[0] += 202000;
    CHECK_INT(check, pulse_period(&pulse, &to, 1), 0);
    CHECK_INT(check, pulse.fast, 1);
}

// Told to stand elsewhere no motor steps; and from there it goes on.
static void a_place_that_is_told_is_no_way(check_t *check)
{
    nck_axes_t from = {{0}}, to = {{0}};
    begin(NCK_SLOPE_LINEAR);
    start(check);
    for (uint32_t places = 2; places < 50; places++) {
        for (int k = 0; k < 3; k++) to.joint_nm[k] = (int64_t)pick(900000000) - 450000000;
        CHECK(check, pulse_period(&pulse, &to, places));
        const int64_t stood = drive.steps[0];
        for (uint32_t i = 0; i < set.interrupts; i++) interrupt();
        CHECK_INT(check, drive.steps[0], stood);
        from = to;
        for (int k = 0; k < 3; k++) to.joint_nm[k] += (int64_t)pick(200000) - 100000;
        CHECK(check, pulse_period(&pulse, &to, places));
        const int64_t before_steps = drive.steps[0];
        for (uint32_t i = 0; i < set.interrupts; i++) interrupt();
        const double way = steps_of(0, &to) - steps_of(0, &from);
        CHECK_NEAR(check, (double)(drive.steps[0] - before_steps), way, 1.01);
    }
}

// What is lost where a motor turns round is given beside the way, no faster than it may.
static void backlash_is_made_up_for_slowly(check_t *check)
{
    nck_axes_t to = {{0}};
    begin(NCK_SLOPE_LINEAR);
    set.motors = 1;
    set.motor[0].steps = 100.0;
    set.motor[0].backlash = 0.2;
    set.motor[0].backlash_speed = 5.0;
    start(check);
    int64_t was = 0;
    for (int n = 0; n < 400; n++) {
        to.joint_nm[0] += n < 100 ? 0 : n < 200 ? 10000 : n < 300 ? 0 : -10000;
        CHECK(check, pulse_period(&pulse, &to, 1));
        for (uint32_t i = 0; i < set.interrupts; i++) interrupt();
        CHECK(check, llabs(drive.steps[0] - was) <= 3);
        was = drive.steps[0];
        if (n == 99) CHECK_INT(check, was, 0);
        if (n == 250) CHECK_INT(check, was, 120);
    }
    CHECK_INT(check, drive.steps[0], 0);
}

// One of two motors waits at its switch while the axis goes on: squared, they keep their distance.
static void two_motors_are_squared(check_t *check)
{
    nck_axes_t to = {{0}};
    begin(NCK_SLOPE_LINEAR);
    set.motors = 2;
    set.motor[0] = set.motor[1];
    start(check);
    for (int n = 0; n < 300; n++) {
        to.joint_nm[1] += n < 200 ? 20000 : -20000;
        if (n == 100) pulse_hold(&pulse, 1, 1);
        if (n == 150) pulse_hold(&pulse, 1, 0);
        CHECK(check, pulse_period(&pulse, &to, 1));
        for (uint32_t i = 0; i < set.interrupts; i++) interrupt();
        const double apart = (double)(drive.steps[0] - drive.steps[1]) / set.motor[0].steps;
        const double want = n < 100 ? 0.0 : n < 150 ? 0.02 * (n - 99) : 1.0;
        CHECK_NEAR(check, apart, want, 2.0 / set.motor[0].steps);
    }
}

static void numbers_out_of_range_are_refused(check_t *check)
{
    const nck_axes_t axes = {{0}};
    begin(NCK_SLOPE_LINEAR);
    const pulse_set_t good = set;
    CHECK(check, pulse_init(&pulse, &set, &axes, 1));
    set.motor[1].steps = 0.0;
    CHECK(check, !pulse_init(&pulse, &set, &axes, 1));
    set = good;
    set.motor[0].joint = NCK_AXIS_MAX;
    CHECK(check, !pulse_init(&pulse, &set, &axes, 1));
    set = good;
    set.motors = PULSE_MOTORS + 1;
    CHECK(check, !pulse_init(&pulse, &set, &axes, 1));
    set = good;
    set.pulse_s = 1e-4;
    CHECK(check, !pulse_init(&pulse, &set, &axes, 1));
    set = good;
    set.setup_s = set.period_s;
    CHECK(check, !pulse_init(&pulse, &set, &axes, 1));
    set = good;
    set.motor[2].backlash = 0.1;
    CHECK(check, !pulse_init(&pulse, &set, &axes, 1));
    CHECK_INT(check, pulse_duty(-5000.0, 10000.0, 999), 500);
    CHECK_INT(check, pulse_duty(1e9, 10000.0, 999), 999);
    CHECK_INT(check, pulse_duty(1.0, 0.0, 999), 999);
}

int main(int argc, char **argv)
{
    check_t check = {0};
    check_seeds(argc, argv, &count, &first);
    CHECK_RUN(&check, steps_are_where_the_setpoints_lead);
    CHECK_RUN(&check, the_fastest_motor_does_not_drift);
    CHECK_RUN(&check, a_place_that_is_told_is_no_way);
    CHECK_RUN(&check, backlash_is_made_up_for_slowly);
    CHECK_RUN(&check, two_motors_are_squared);
    CHECK_RUN(&check, numbers_out_of_range_are_refused);
    return check_end(&check);
}
