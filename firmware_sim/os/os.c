// SPDX-License-Identifier: MIT
// Tasks, the ready set, ticks and time.
#include "os/os.h"

#include "os/kernel.h" // os_kernel_t
#include "os/port.h"   // os_port_…

#include <string.h> // memset

enum { GUARD_WORDS = OS_STACK_GUARD / sizeof(os_stack_t), GUARD_STEP = 4, IDLE_BYTES = 256 };

static const os_stack_t paint = 0xA5C35A3CA5C35A3Cu;

os_kernel_t os_kernel;
static os_stack_t idle_stack[OS_STACK_WORDS(IDLE_BYTES)];

// Isolate the lowest bit and halve the field until it is found: no loop over the priorities.
os_task_t *os_highest(uint32_t set)
{
    const uint32_t lowest = set & (0u - set);
    uint32_t priority = 0;
    if (lowest & 0xFF00u) priority += 8;
    if (lowest & 0xF0F0u) priority += 4;
    if (lowest & 0xCCCCu) priority += 2;
    if (lowest & 0xAAAAu) priority += 1;
    return os_kernel.at[priority];
}

void os_schedule(void)
{
    if (os_kernel.phase != OS_PHASE_RUNNING) return;
    if (os_highest(os_kernel.ready) != os_kernel.running) os_port_pend_switch();
}

void os_wait(uint32_t *waiting, uint32_t timeout)
{
    os_task_t *const task = os_kernel.running;
    task->waiting = waiting;
    if (waiting) *waiting |= os_bit(task->priority);
    task->timed = timeout != OS_FOREVER;
    task->wake = os_kernel.time + timeout;
    os_kernel.ready &= ~os_bit(task->priority);
    os_port_pend_switch();
}

void os_wake(os_task_t *task, os_status_t result)
{
    if (task->waiting) *task->waiting &= ~os_bit(task->priority);
    task->waiting = NULL;
    task->timed = 0;
    task->result = result;
    os_kernel.ready |= os_bit(task->priority);
    os_schedule();
}

void os_move(os_task_t *task, uint32_t priority)
{
    os_kernel.at[task->priority] = NULL;
    os_kernel.ready &= ~os_bit(task->priority);
    task->priority = priority;
    os_kernel.at[priority] = task;
    os_kernel.ready |= os_bit(priority);
    os_schedule();
}

void os_fault(os_task_t *task, os_fault_t fault)
{
    if (task) task->report.fault = fault;
    if (os_kernel.hooks.fault) {
        os_kernel.hooks.fault(os_kernel.hooks.user, fault, task ? task->name : OS_PRIORITIES);
    }
}

// It does not run again, whatever it waited for.
static void end(os_task_t *task)
{
    task->report.ended = 1;
    os_wake(task, OS_OK);
    os_kernel.ready &= ~os_bit(task->priority);
    os_port_pend_switch();
    if (task->mutex) os_fault(task, OS_FAULT_MUTEX);
}

// A task's frames are nobody else's business to an address sanitizer; here they are.
#define LOOKS_INTO_STACKS __attribute__((no_sanitize("address")))

LOOKS_INTO_STACKS static void paint_stack(os_stack_t *stack, size_t words)
{
    for (size_t k = 0; k < words; k++) stack[k] = paint;
}

// Words at the far end that were never touched, words_max at most.
LOOKS_INTO_STACKS static size_t untouched_words(const os_stack_t *stack, size_t words_max)
{
    size_t k = 0;
    while (k < words_max && stack[k] == paint) k++;
    return k;
}

// Every fourth word, the nearest first: the registers that an interrupt or a call saves stand side
// by side and leave no gap of that size.
LOOKS_INTO_STACKS static int guard_is_whole(const os_stack_t *stack)
{
    for (size_t k = GUARD_WORDS; k > 0; k -= GUARD_STEP) {
        if (stack[k - 1] != paint) return 0;
    }
    return 1;
}

static void check_stack(os_task_t *task, const void *stack_pointer)
{
    if (task->report.ended) return;
    const uintptr_t limit = (uintptr_t)(task->stack + GUARD_WORDS);
    const int inside = !stack_pointer || (uintptr_t)stack_pointer >= limit;
    if (inside && guard_is_whole(task->stack)) return;
    os_fault(task, OS_FAULT_STACK);
    end(task);
}

static void charge(uint64_t *account)
{
    const uint64_t now = os_port_clock();
    *account += now - os_kernel.switched_at;
    os_kernel.switched_at = now;
}

void *os_switch(void *context, const void *stack_pointer)
{
    os_task_t *const left = os_kernel.running;
    if (left) {
        left->context = context;
        charge(&left->report.run_units);
        check_stack(left, stack_pointer);
    }
    if (os_kernel.phase == OS_PHASE_STOPPING) {
        os_kernel.running = NULL;
        return os_port_caller();
    }
    os_task_t *const next = os_highest(os_kernel.ready);
    next->report.switches += next != left;
    os_kernel.running = next;
    return next->context;
}

static void wake_the_due(void)
{
    for (uint32_t k = 0; k < OS_PRIORITIES; k++) {
        os_task_t *const task = &os_kernel.task[k];
        if (!task->timed || task->wake != os_kernel.time) continue;
        os_wake(task, task->waiting ? OS_TIMED_OUT : OS_OK);
    }
}

static void check_overrun(void)
{
    if (!os_port_tick_is_due()) return;
    os_kernel.overruns++;
    if (os_kernel.overruns == 1) os_fault(NULL, OS_FAULT_OVERRUN);
}

void os_tick(void)
{
    if (!os_kernel.running) return; // on the way in or out
    uint32_t before = os_critical_enter();
    charge(&os_kernel.running->report.run_units);
    os_kernel.time++;
    os_critical_exit(before);
    if (os_kernel.hooks.tick) os_kernel.hooks.tick(os_kernel.hooks.user);
    before = os_critical_enter();
    wake_the_due();
    check_stack(os_kernel.running, NULL);
    check_overrun();
    charge(&os_kernel.interrupt_units);
    os_critical_exit(before);
}

// Where every task starts, and ends.
static void run(void)
{
    os_task_t *const task = os_kernel.running;
    task->entry(task->user);
    const uint32_t before = os_critical_enter();
    end(task);
    os_critical_exit(before);
    for (;;) continue; // not reached: the task was switched away
}

static void idle(void *user)
{
    (void)user;
    for (;;) os_port_idle();
}

static void add(uint32_t priority, const char *name, void (*entry)(void *user), void *user)
{
    os_task_t *const task = &os_kernel.task[priority];
    task->entry = entry;
    task->user = user;
    task->name = priority;
    task->priority = priority;
    task->report.name = name;
    os_kernel.at[priority] = task;
}

// Paint the stack and make the task ready. Returns OS_E_ARGUMENT if the stack is too small.
static os_status_t furnish(uint32_t priority, os_stack_t *stack, size_t words)
{
    if (words <= GUARD_WORDS) return OS_E_ARGUMENT;
    paint_stack(stack, words);
    void *const context = os_port_context(stack + GUARD_WORDS, words - GUARD_WORDS, run);
    if (!context) return OS_E_ARGUMENT;
    os_task_t *const task = &os_kernel.task[priority];
    task->stack = stack;
    task->words = words;
    task->context = context;
    return OS_OK;
}

void os_init(const os_hooks_t *hooks)
{
    memset(&os_kernel, 0, sizeof os_kernel);
    if (hooks) os_kernel.hooks = *hooks;
    add(OS_PRIORITY_IDLE, "idle", idle, NULL);
    (void)furnish(OS_PRIORITY_IDLE, idle_stack, sizeof idle_stack / sizeof idle_stack[0]);
    os_kernel.ready = os_bit(OS_PRIORITY_IDLE);
}

os_status_t os_task_create(uint32_t priority, const char *name, void (*entry)(void *user),
                           void *user, os_stack_t *stack, size_t words)
{
    if (os_port_in_interrupt()) return OS_E_CONTEXT;
    if (priority >= OS_PRIORITY_IDLE) return OS_E_PRIORITY;
    if (!entry || !stack) return OS_E_ARGUMENT;
    const uint32_t before = os_critical_enter();
    const int taken = os_kernel.task[priority].entry || (os_kernel.ceilings & os_bit(priority));
    if (!taken) add(priority, name, entry, user);
    os_critical_exit(before);
    if (taken) return OS_E_PRIORITY;
    // The name is reserved: the stack can be painted with interrupts let in.
    const os_status_t status = furnish(priority, stack, words);
    const uint32_t again = os_critical_enter();
    if (status == OS_OK) os_kernel.ready |= os_bit(priority);
    else os_kernel.task[priority].entry = NULL;
    os_schedule();
    os_critical_exit(again);
    return status;
}

os_status_t os_start(uint32_t tick_units)
{
    if (!os_port_can_count(tick_units)) return OS_E_ARGUMENT;
    if (os_kernel.phase != OS_PHASE_BEFORE || os_port_in_interrupt()) return OS_E_CONTEXT;
    os_kernel.phase = OS_PHASE_RUNNING;
    os_port_start(tick_units);
    os_kernel.phase = OS_PHASE_OVER;
    if (os_kernel.hooks.over) os_kernel.hooks.over(os_kernel.hooks.user);
    return OS_OK;
}

void os_stop(void)
{
    const uint32_t before = os_critical_enter();
    if (os_kernel.phase == OS_PHASE_RUNNING) {
        os_kernel.phase = OS_PHASE_STOPPING;
        os_port_pend_switch();
    }
    os_critical_exit(before);
}

uint32_t os_time(void)
{
    const uint32_t before = os_critical_enter();
    const uint32_t time = os_kernel.time;
    os_critical_exit(before);
    return time;
}

uint64_t os_clock(void)
{
    const uint32_t before = os_critical_enter();
    const uint64_t clock = os_port_clock();
    os_critical_exit(before);
    return clock;
}

os_status_t os_delay(uint32_t ticks)
{
    if (!os_may_wait()) return OS_E_CONTEXT;
    if (ticks == 0) return OS_OK;
    const uint32_t before = os_critical_enter();
    os_wait(NULL, ticks);
    os_critical_exit(before);
    return OS_OK;
}

os_status_t os_delay_until(uint32_t time)
{
    if (!os_may_wait()) return OS_E_CONTEXT;
    const uint32_t before = os_critical_enter();
    const uint32_t ticks = time - os_kernel.time;
    const int late = ticks >= 1u << 31;
    if (!late && ticks > 0) os_wait(NULL, ticks);
    os_critical_exit(before);
    return late ? OS_LATE : OS_OK;
}

uint32_t os_overruns(void)
{
    const uint32_t before = os_critical_enter();
    const uint32_t overruns = os_kernel.overruns;
    os_critical_exit(before);
    return overruns;
}

uint64_t os_interrupt_units(void)
{
    const uint32_t before = os_critical_enter();
    const uint64_t units = os_kernel.interrupt_units;
    os_critical_exit(before);
    return units;
}

os_status_t os_stack_left(uint32_t priority, size_t *bytes_out)
{
    if (!bytes_out) return OS_E_ARGUMENT;
    if (priority >= OS_PRIORITIES || !os_kernel.task[priority].stack) return OS_E_PRIORITY;
    const os_task_t *const task = &os_kernel.task[priority];
    const size_t untouched = untouched_words(task->stack, task->words);
    *bytes_out = untouched > GUARD_WORDS ? (untouched - GUARD_WORDS) * sizeof(os_stack_t) : 0;
    return OS_OK;
}

os_status_t os_task_report(uint32_t priority, os_task_report_t *report_out)
{
    if (!report_out) return OS_E_ARGUMENT;
    if (priority >= OS_PRIORITIES || !os_kernel.task[priority].stack) return OS_E_PRIORITY;
    const uint32_t before = os_critical_enter();
    os_task_t *const task = &os_kernel.task[priority];
    if (task == os_kernel.running && !os_port_in_interrupt()) charge(&task->report.run_units);
    *report_out = task->report;
    os_critical_exit(before);
    return OS_OK;
}
