// SPDX-License-Identifier: MIT
// The small kernel's tasks, ticks, time and stacks, the same on the host and on a target.
#include "os_check.h"

#include <stdint.h> // UINT32_MAX

// Who runs ---------------------------------------------------------------------------------------

static void note_1(void *user) { (void)user; note('1'); }
static void note_3(void *user) { (void)user; note('3'); }
static void note_5_and_stop(void *user) { (void)user; note('5'); os_stop(); note('!'); }

static void the_highest_ready_task_runs_first(check_t *check)
{
    begin();
    CHECK_INT(check, add(5, note_5_and_stop), OS_OK);
    CHECK_INT(check, add(3, note_3), OS_OK);
    CHECK_INT(check, add(1, note_1), OS_OK);
    run(check);
    CHECK_TRACE(check, "135");
}

static void create_others(void *user)
{
    (void)user;
    note('a');
    (void)add(1, note_1);
    note('b');
    (void)add(5, note_5_and_stop);
    note('c');
}

static void a_created_task_preempts_if_it_is_higher(check_t *check)
{
    begin();
    (void)add(3, create_others);
    run(check);
    CHECK_TRACE(check, "a1bc5");
}

static uint32_t low_steps, low_steps_before, low_steps_after;

static void step_for_ever(void *user)
{
    (void)user;
    for (;;) {
        low_steps++;
        os_spend(10);
    }
}

static void watch_the_low_task(void *user)
{
    (void)user;
    os_delay(3);
    low_steps_before = low_steps;
    be_busy(5);
    low_steps_after = low_steps;
    os_stop();
}

static void a_lower_task_waits_while_a_higher_one_is_busy(check_t *check)
{
    begin();
    low_steps = 0;
    (void)add(2, watch_the_low_task);
    (void)add(9, step_for_ever);
    run(check);
    CHECK(check, low_steps_before > 0);
    CHECK_INT(check, low_steps_after, low_steps_before);
}

static uint32_t woken[8];

static void wake_at_every_tick(void *user)
{
    (void)user;
    for (uint32_t k = 0; k < 8; k++) {
        os_delay(1);
        woken[k] = os_time();
    }
    os_stop();
}

static void a_tick_preempts_a_task_that_never_waits(check_t *check)
{
    begin();
    low_steps = 0;
    (void)add(2, wake_at_every_tick);
    (void)add(9, step_for_ever);
    run(check);
    for (uint32_t k = 0; k < 8; k++) CHECK_INT(check, woken[k], k + 1);
    CHECK(check, low_steps > 8);
}

static void wake_at_5(char letter)
{
    os_delay_until(5);
    note(letter);
    if (letter == 'd') os_stop();
}

static void wake_at_5_a(void *user) { (void)user; wake_at_5('a'); }
static void wake_at_5_b(void *user) { (void)user; wake_at_5('b'); }
static void wake_at_5_c(void *user) { (void)user; wake_at_5('c'); }
static void wake_at_5_d(void *user) { (void)user; wake_at_5('d'); }

static void tasks_of_one_tick_run_by_priority(check_t *check)
{
    begin();
    (void)add(7, wake_at_5_c);
    (void)add(14, wake_at_5_d);
    (void)add(0, wake_at_5_a);
    (void)add(3, wake_at_5_b);
    run(check);
    CHECK_TRACE(check, "abcd");
}

// Time -------------------------------------------------------------------------------------------

static const uint32_t delays[] = {1, 2, 7, 100, 0, 3};
enum { DELAYS = sizeof delays / sizeof delays[0] };
static uint32_t slept[DELAYS];
static os_status_t statuses[8];

static void sleep_by_the_list(void *user)
{
    (void)user;
    os_delay(1);
    for (uint32_t k = 0; k < DELAYS; k++) {
        const uint32_t from = os_time();
        statuses[k] = os_delay(delays[k]);
        slept[k] = os_time() - from;
    }
    os_stop();
}

static void check_delays(check_t *check)
{
    run(check);
    for (uint32_t k = 0; k < DELAYS; k++) {
        CHECK_INT(check, statuses[k], OS_OK);
        CHECK_INT(check, slept[k], delays[k]);
    }
}

static void a_delay_lasts_its_ticks(check_t *check)
{
    begin();
    (void)add(4, sleep_by_the_list);
    check_delays(check);
}

static void a_delay_lasts_its_ticks_when_time_wraps(check_t *check)
{
    begin();
    os_kernel.time = UINT32_MAX - 5;
    (void)add(4, sleep_by_the_list);
    check_delays(check);
    CHECK(check, os_time() < 200);
}

static void keep_a_period_of_3(void *user)
{
    (void)user;
    for (uint32_t k = 0; k < 8; k++) {
        be_busy(k % 3); // up to the last tick of the period
        statuses[k] = os_delay_until(3 * (k + 1));
        woken[k] = os_time();
    }
    note('p');
}

static void stop_at_tick_30(void)
{
    if (stage.ticks == 30) os_stop();
}

static void a_period_does_not_drift(check_t *check)
{
    begin();
    stage.on_tick = stop_at_tick_30;
    (void)add(4, keep_a_period_of_3);
    run(check);
    CHECK_TRACE(check, "p");
    for (uint32_t k = 0; k < 8; k++) {
        CHECK_INT(check, statuses[k], OS_OK);
        CHECK_INT(check, woken[k], 3 * (k + 1));
    }
}

static void come_late(void *user)
{
    (void)user;
    os_delay(10);
    statuses[0] = os_delay_until(9);
    woken[0] = os_time();
    statuses[1] = os_delay_until(10);
    woken[1] = os_time();
    statuses[2] = os_delay_until(11);
    woken[2] = os_time();
    os_stop();
}

static void a_time_that_has_passed_is_told(check_t *check)
{
    begin();
    (void)add(4, come_late);
    run(check);
    CHECK_INT(check, statuses[0], OS_LATE);
    CHECK_INT(check, woken[0], 10);
    CHECK_INT(check, statuses[1], OS_OK);
    CHECK_INT(check, woken[1], 10);
    CHECK_INT(check, statuses[2], OS_OK);
    CHECK_INT(check, woken[2], 11);
}

enum { SWITCHES = 64 };
static uint64_t seen[2][SWITCHES];

// Once for each of two runs: when, to the unit, this task came to run again.
static void note_the_schedule(void *user)
{
    uint64_t *const row = user;
    for (uint32_t k = 0; k < SWITCHES; k++) {
        row[k] = os_clock();
        os_spend(k);
        os_delay(k % 3);
    }
    os_stop();
}

static void the_same_run_has_the_same_schedule(check_t *check)
{
    for (uint32_t k = 0; k < 2; k++) {
        begin();
        (void)os_task_create(4, "notes", note_the_schedule, seen[k], stacks[4],
                             sizeof stacks[4] / sizeof stacks[4][0]);
        (void)add(3, keep_a_period_of_3);
        (void)add(9, step_for_ever);
        run(check);
    }
    CHECK_INT(check, memcmp(seen[0], seen[1], sizeof seen[0]), 0);
    CHECK(check, seen[0][SWITCHES - 1] > (uint64_t)SWITCHES / 2 * TICK_UNITS);
}

static uint32_t clock_went_back, clock_left_its_tick;

static void read_the_clock(void *user)
{
    (void)user;
    uint64_t last = os_clock();
    for (uint32_t k = 0; k < 20000; k++) {
        const uint32_t before = os_critical_enter();
        const uint64_t now = os_clock();
        const uint64_t ticks = now / TICK_UNITS;
        const uint32_t time = os_time();
        os_critical_exit(before);
        clock_went_back += now < last;
        clock_left_its_tick += ticks != time && ticks != time + 1; // one may be due
        last = now;
    }
    os_stop();
}

static void the_clock_agrees_with_the_ticks(check_t *check)
{
    begin();
    clock_went_back = clock_left_its_tick = 0;
    (void)add(4, read_the_clock);
    run(check);
    CHECK_INT(check, clock_went_back, 0);
    CHECK_INT(check, clock_left_its_tick, 0);
    CHECK(check, stage.ticks > 10);
}

// Work -------------------------------------------------------------------------------------------

static void work_3_of_10_ticks(void *user)
{
    (void)user;
    for (uint32_t k = 0; k < 20; k++) {
        be_busy(3);
        os_delay_until(10 * (k + 1));
    }
    os_stop();
}

static void the_work_of_each_task_is_measured(check_t *check)
{
    begin();
    (void)add(4, work_3_of_10_ticks);
    run(check);
    os_task_report_t report, idle;
    CHECK_INT(check, os_task_report(4, &report), OS_OK);
    CHECK_INT(check, os_task_report(OS_PRIORITY_IDLE, &idle), OS_OK);
    const double all = 200.0 * (double)TICK_UNITS;
    const double interrupts = (double)os_interrupt_units();
    const double tasks = (double)(report.run_units + idle.run_units);
    CHECK_NEAR(check, (double)report.run_units / (all - interrupts), 0.3, 0.01);
    CHECK_NEAR(check, (tasks + interrupts) / all, 1.0, 0.005);
    CHECK_INT(check, report.switches, 21);
}

static void overrun_at_tick_7(void)
{
    if (stage.ticks != 7) return;
    const uint64_t begun = os_clock();
    while (os_clock() - begun < TICK_UNITS + TICK_UNITS / 5) os_spend(20);
}

static void a_tick_that_overruns_is_told(check_t *check)
{
    begin();
    stage.on_tick = overrun_at_tick_7;
    (void)add(4, work_3_of_10_ticks);
    run(check);
    CHECK_INT(check, os_overruns(), 1);
    CHECK_INT(check, stage.fault, OS_FAULT_OVERRUN);
    CHECK_INT(check, stage.faulty, OS_PRIORITIES);
    CHECK_INT(check, stage.faults, 1);
}

static uint64_t worked, clock_after;

// Three ticks come meanwhile: one is due at the end, two are lost.
static void work_for_three_ticks(void)
{
    if (stage.ticks != 7) return;
    const uint64_t begun = os_clock();
    for (uint64_t last = begun, now; worked < 3 * TICK_UNITS; last = now) {
        os_spend(20);
        now = os_clock();
        clock_went_back += now < last;
        worked = now - begun;
    }
}

static void note_the_clock(void *user)
{
    (void)user;
    os_delay_until(20);
    clock_after = os_clock();
    os_stop();
}

static void the_clock_goes_on_when_ticks_are_lost(check_t *check)
{
    begin();
    clock_went_back = 0;
    worked = 0;
    stage.on_tick = work_for_three_ticks;
    (void)add(4, note_the_clock);
    run(check);
    CHECK_INT(check, clock_went_back, 0);
    CHECK(check, worked < 3 * TICK_UNITS + TICK_UNITS / 5);
    CHECK_INT(check, clock_after / TICK_UNITS, 22);
    CHECK_INT(check, os_overruns(), 1);
}

static void stop_at_tick_4(void)
{
    if (stage.ticks == 4) os_stop();
}

static void an_interrupt_can_stop_the_kernel(check_t *check)
{
    begin();
    stage.on_tick = stop_at_tick_4;
    (void)add(9, step_for_ever);
    run(check);
    CHECK_INT(check, os_time(), 4);
    CHECK_INT(check, os_start(TICK_UNITS), OS_E_CONTEXT);
}

static void an_idle_kernel_can_be_stopped(check_t *check)
{
    begin();
    stage.on_tick = stop_at_tick_4;
    run(check);
    CHECK_INT(check, os_time(), 4);
}

int main(void)
{
    check_t check = {0};
    CHECK_RUN(&check, the_highest_ready_task_runs_first);
    CHECK_RUN(&check, a_created_task_preempts_if_it_is_higher);
    CHECK_RUN(&check, a_lower_task_waits_while_a_higher_one_is_busy);
    CHECK_RUN(&check, a_tick_preempts_a_task_that_never_waits);
    CHECK_RUN(&check, tasks_of_one_tick_run_by_priority);
    CHECK_RUN(&check, a_delay_lasts_its_ticks);
    CHECK_RUN(&check, a_delay_lasts_its_ticks_when_time_wraps);
    CHECK_RUN(&check, a_period_does_not_drift);
    CHECK_RUN(&check, a_time_that_has_passed_is_told);
    CHECK_RUN(&check, the_same_run_has_the_same_schedule);
    CHECK_RUN(&check, the_clock_agrees_with_the_ticks);
    CHECK_RUN(&check, the_work_of_each_task_is_measured);
    CHECK_RUN(&check, a_tick_that_overruns_is_told);
    CHECK_RUN(&check, the_clock_goes_on_when_ticks_are_lost);
    CHECK_RUN(&check, an_interrupt_can_stop_the_kernel);
    CHECK_RUN(&check, an_idle_kernel_can_be_stopped);
    return check_end(&check);
}
