// SPDX-License-Identifier: MIT
// The small kernel's checks: stacks that overflow, calls from wrong places, arguments out of range.
#include "os_check.h"

static void note_1(void *user) { (void)user; note('1'); }

// Stacks -----------------------------------------------------------------------------------------

enum { SINK_BYTES = 400 };

static void use_the_stack(void *user)
{
    (void)user;
    volatile uint8_t sink[SINK_BYTES];
    for (uint32_t k = 0; k < SINK_BYTES; k++) sink[k] = 1;
    os_delay(sink[SINK_BYTES / 2]);
    os_delay(1);
    os_stop();
}

static void the_untouched_part_of_a_stack_is_known(check_t *check)
{
    size_t left = 0, idle_left = 0;
    begin();
    (void)add(4, use_the_stack);
    CHECK_INT(check, os_stack_left(4, &left), OS_OK);
    CHECK(check, left >= TASK_BYTES);
    CHECK(check, left < TASK_BYTES + OS_STACK_RESERVE + sizeof(os_stack_t));
    run(check);
    CHECK_INT(check, os_stack_left(4, &left), OS_OK);
    CHECK(check, left > 0);
    CHECK(check, left <= TASK_BYTES + OS_STACK_RESERVE - SINK_BYTES);
    CHECK_INT(check, os_stack_left(OS_PRIORITY_IDLE, &idle_left), OS_OK);
    CHECK(check, idle_left > 0);
    CHECK_INT(check, stage.faults, 0);
}

// As a call that went too deep and came back: the stack pointer is good again, the guard is not.
static void touch_the_guard(void *user)
{
    (void)user;
    os_delay(3);
    note('a');
    volatile os_stack_t *const guard = stacks[4];
    guard[OS_STACK_GUARD / sizeof(os_stack_t) - 1] = 1;
    for (;;) os_spend(10);
}

static void stop_later(void *user)
{
    (void)user;
    os_delay(10);
    note('b');
    os_stop();
}

static void check_the_fault(check_t *check)
{
    os_task_report_t report;
    CHECK_TRACE(check, "ab");
    CHECK_INT(check, stage.fault, OS_FAULT_STACK);
    CHECK_INT(check, stage.faulty, 4);
    CHECK_INT(check, stage.faults, 1);
    CHECK_INT(check, os_task_report(4, &report), OS_OK);
    CHECK_INT(check, report.fault, OS_FAULT_STACK);
    CHECK_INT(check, report.ended, 1);
}

static void a_touched_guard_is_a_stack_fault(check_t *check)
{
    begin();
    (void)add(4, touch_the_guard);
    (void)add(9, stop_later);
    run(check);
    size_t left = 1;
    CHECK_INT(check, os_stack_left(4, &left), OS_OK);
    CHECK_INT(check, left, 0);
    check_the_fault(check);
}

// The stack that overflows stands above another that may be overwritten.
static os_stack_t field[2][OS_STACK_WORDS(TASK_BYTES)];

// As a call whose locals reach beyond the guard and leave it as it was.
static void wait_too_deep(void *user)
{
    (void)user;
    note('a');
    volatile uint8_t sink[sizeof field[1]];
    sink[sizeof sink - 1] = 1;
    os_delay(sink[sizeof sink - 1]);
    note('!');
}

static void a_stack_pointer_beyond_the_guard_is_a_stack_fault(check_t *check)
{
    begin();
    (void)os_task_create(4, "deep", wait_too_deep, NULL, field[1],
                         sizeof field[1] / sizeof field[1][0]);
    (void)add(9, stop_later);
    run(check);
    check_the_fault(check);
}

// Doors ------------------------------------------------------------------------------------------

static os_status_t in_interrupt[4];

static void call_what_is_for_tasks(void)
{
    in_interrupt[0] = add(7, note_1);
    in_interrupt[1] = os_delay(1);
    in_interrupt[2] = os_delay_until(100);
    in_interrupt[3] = os_start(TICK_UNITS);
    os_stop();
}

static os_status_t in_section;

static void wait_in_a_critical_section(void *user)
{
    (void)user;
    const uint32_t before = os_critical_enter();
    in_section = os_delay(1);
    os_critical_exit(before);
    os_delay(5);
}

static void a_call_from_a_wrong_place_is_refused(check_t *check)
{
    begin();
    CHECK_INT(check, os_delay(1), OS_E_CONTEXT);
    (void)add(4, wait_in_a_critical_section);
    stage.on_tick = call_what_is_for_tasks;
    run(check);
    for (uint32_t k = 0; k < 4; k++) CHECK_INT(check, in_interrupt[k], OS_E_CONTEXT);
    CHECK_INT(check, in_section, OS_E_CONTEXT);
    CHECK_INT(check, os_delay(1), OS_E_CONTEXT);
}

static void a_task_needs_a_free_priority_a_stack_and_an_entry(check_t *check)
{
    const size_t words = sizeof stacks[2] / sizeof stacks[2][0];
    const size_t few = (OS_STACK_GUARD + OS_STACK_RESERVE) / sizeof(os_stack_t);
    os_task_report_t report;
    size_t left;
    begin();
    CHECK_INT(check, add(3, note_1), OS_OK);
    CHECK_INT(check, add(3, note_1), OS_E_PRIORITY);
    CHECK_INT(check, os_task_create(OS_PRIORITY_IDLE, "", note_1, NULL, stacks[2], words),
              OS_E_PRIORITY);
    CHECK_INT(check, os_task_create(2, "", NULL, NULL, stacks[2], words), OS_E_ARGUMENT);
    CHECK_INT(check, os_task_create(2, "", note_1, NULL, NULL, words), OS_E_ARGUMENT);
    CHECK_INT(check, os_task_create(2, "", note_1, NULL, stacks[2], few), OS_E_ARGUMENT);
    CHECK_INT(check, os_task_report(2, &report), OS_E_PRIORITY);
    CHECK_INT(check, os_stack_left(2, &left), OS_E_PRIORITY);
    CHECK_INT(check, os_task_report(3, NULL), OS_E_ARGUMENT);
    CHECK_INT(check, os_stack_left(3, NULL), OS_E_ARGUMENT);
    CHECK_INT(check, add(2, note_1), OS_OK);
    CHECK_INT(check, os_start(0), OS_E_ARGUMENT);
}

int main(void)
{
    check_t check = {0};
    CHECK_RUN(&check, the_untouched_part_of_a_stack_is_known);
    CHECK_RUN(&check, a_touched_guard_is_a_stack_fault);
    CHECK_RUN(&check, a_stack_pointer_beyond_the_guard_is_a_stack_fault);
    CHECK_RUN(&check, a_call_from_a_wrong_place_is_refused);
    CHECK_RUN(&check, a_task_needs_a_free_priority_a_stack_and_an_entry);
    return check_end(&check);
}
