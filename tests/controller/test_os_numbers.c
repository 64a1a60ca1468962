// SPDX-License-Identifier: MIT
// Floating-point registers belong to the task that computes with them: two tasks and the tick
// interrupt compute at once, preempting each other, and each gets the bits that it gets alone.
#include "os_check.h"

#include <stdint.h> // uint32_t

enum { VALUES = 12, STEPS = 300, TICK_STEPS = 3, TURNS = 150 };

// Numbers that forget nothing: a wrong bit in any of them at any time is seen at the end. There are
// enough for the compiler to keep them in the registers that a call and a switch preserve.
typedef struct numbers {
    float single[VALUES];
    double real[VALUES];
} numbers_t;

static void seed(numbers_t *numbers, double first)
{
    for (int k = 0; k < VALUES; k++) {
        numbers->real[k] = first + 0.05 * (double)k;
        numbers->single[k] = (float)numbers->real[k];
    }
}

// The logistic map is chaotic at 3.9 and stays within 0 … 1.
static void compute_single(float *x, int steps)
{
    float a = x[0], b = x[1], c = x[2], d = x[3], e = x[4], f = x[5];
    float g = x[6], h = x[7], i = x[8], j = x[9], k = x[10], l = x[11];
    for (int step = 0; step < steps; step++) {
        a = 3.9f * a * (1.0f - a); b = 3.9f * b * (1.0f - b);
        c = 3.9f * c * (1.0f - c); d = 3.9f * d * (1.0f - d);
        e = 3.9f * e * (1.0f - e); f = 3.9f * f * (1.0f - f);
        g = 3.9f * g * (1.0f - g); h = 3.9f * h * (1.0f - h);
        i = 3.9f * i * (1.0f - i); j = 3.9f * j * (1.0f - j);
        k = 3.9f * k * (1.0f - k); l = 3.9f * l * (1.0f - l);
    }
    x[0] = a; x[1] = b; x[2] = c; x[3] = d; x[4] = e; x[5] = f;
    x[6] = g; x[7] = h; x[8] = i; x[9] = j; x[10] = k; x[11] = l;
}

static void compute_real(double *x, int steps)
{
    double a = x[0], b = x[1], c = x[2], d = x[3], e = x[4], f = x[5];
    double g = x[6], h = x[7], i = x[8], j = x[9], k = x[10], l = x[11];
    for (int step = 0; step < steps; step++) {
        a = 3.9 * a * (1.0 - a); b = 3.9 * b * (1.0 - b);
        c = 3.9 * c * (1.0 - c); d = 3.9 * d * (1.0 - d);
        e = 3.9 * e * (1.0 - e); f = 3.9 * f * (1.0 - f);
        g = 3.9 * g * (1.0 - g); h = 3.9 * h * (1.0 - h);
        i = 3.9 * i * (1.0 - i); j = 3.9 * j * (1.0 - j);
        k = 3.9 * k * (1.0 - k); l = 3.9 * l * (1.0 - l);
    }
    x[0] = a; x[1] = b; x[2] = c; x[3] = d; x[4] = e; x[5] = f;
    x[6] = g; x[7] = h; x[8] = i; x[9] = j; x[10] = k; x[11] = l;
}

static void compute(numbers_t *numbers, int steps)
{
    compute_single(numbers->single, steps);
    compute_real(numbers->real, steps);
    os_spend(40);
}

static numbers_t low, high, ticks;
static uint32_t low_rounds, high_turns, ticks_computed;

static void compute_without_a_wait(void *user)
{
    (void)user;
    for (;;) {
        if (high_turns < TURNS) {
            compute(&low, STEPS);
            low_rounds++;
        } else {
            os_stop();
        }
    }
}

static void compute_at_every_tick(void *user)
{
    (void)user;
    for (high_turns = 0; high_turns < TURNS; high_turns++) {
        compute(&high, TICK_STEPS);
        os_delay(1);
    }
    os_delay(OS_FOREVER);
}

// Does without floating point: its frame has no such registers, whoever it preempts.
static void count_only(void *user)
{
    (void)user;
    for (;;) os_delay(1);
}

static void compute_in_the_tick(void)
{
    compute(&ticks, TICK_STEPS);
    ticks_computed++;
}

static void check_numbers(check_t *check, const numbers_t *got, uint32_t times, int steps,
                          double first)
{
    numbers_t want;
    seed(&want, first);
    for (uint32_t k = 0; k < times; k++) compute(&want, steps);
    CHECK(check, times > 0);
    CHECK_INT(check, memcmp(got->single, want.single, sizeof want.single), 0);
    CHECK_INT(check, memcmp(got->real, want.real, sizeof want.real), 0);
}

static void floating_point_survives_preemption(check_t *check)
{
    begin();
    seed(&low, 0.11);
    seed(&high, 0.23);
    seed(&ticks, 0.37);
    low_rounds = high_turns = ticks_computed = 0;
    stage.on_tick = compute_in_the_tick;
    (void)add(2, count_only);
    (void)add(4, compute_at_every_tick);
    (void)add(9, compute_without_a_wait);
    run_by(check, 8 * TICK_UNITS);
    os_task_report_t report;
    CHECK_INT(check, os_task_report(9, &report), OS_OK);
    CHECK(check, report.switches >= TURNS - 1);
    check_numbers(check, &low, low_rounds, STEPS, 0.11);
    check_numbers(check, &high, TURNS, TICK_STEPS, 0.23);
    check_numbers(check, &ticks, ticks_computed, TICK_STEPS, 0.37);
}

// Every processor here has registers for these.
static void compute_single_for_ever(void *user)
{
    (void)user;
    for (;;) {
        compute_single(low.single, STEPS);
        os_spend(40);
    }
}

// In the middle of that.
static void stop_at_tick_100(void)
{
    if (stage.ticks == 100) os_stop();
}

static volatile float real_source = 0.25f;
static volatile uint32_t whole_source = 12345;

// What os_start's caller keeps in the registers that a call preserves is there when it returns.
static void the_caller_gets_its_own_registers_back(check_t *check)
{
    begin();
    seed(&low, 0.11);
    stage.on_tick = stop_at_tick_100;
    (void)add(9, compute_single_for_ever);
    const float a = real_source * 3.0f, b = real_source * 5.0f, c = real_source * 7.0f;
    const float d = real_source * 11.0f, e = real_source * 13.0f, f = real_source * 17.0f;
    const uint32_t i = whole_source * 3, j = whole_source * 5, k = whole_source * 7;
    const uint32_t l = whole_source * 11, m = whole_source * 13;
    const os_status_t status = os_start(8 * TICK_UNITS);
    const float reals = a + 2.0f * b + 3.0f * c + 4.0f * d + 5.0f * e + 6.0f * f;
    const uint32_t wholes = i + 2 * j + 3 * k + 4 * l + 5 * m;
    CHECK_INT(check, status, OS_OK);
    CHECK(check, reals == 0.25f * 245.0f); // exact: few bits each
    CHECK_INT(check, wholes, 12345u * 143u);
}

int main(void)
{
    check_t check = {0};
    CHECK_RUN(&check, floating_point_survives_preemption);
    CHECK_RUN(&check, the_caller_gets_its_own_registers_back);
    return check_end(&check);
}
