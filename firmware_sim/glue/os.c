// SPDX-License-Identifier: MIT
// os.h on a Cortex-M with somebody else's kernel: what the app calls, over glue.h. Semaphores and
// mutexes are not here, because the app has none.
//
// It differs from the kernel in ../os in three ways: a task that left its stack is told by the
// fault hook but goes on; os_start does not come back; a queue takes nothing before os_start.
#include "os/os.h"

#include <string.h> // memset

#include "glue/glue.h"

enum { PAINT = 0xa5, GUARD_WORDS = OS_STACK_GUARD / sizeof(os_stack_t), STARTER_BYTES = 3072 };

// Armv7-M Architecture Reference Manual, B3.2.4 and B3.3: ICSR and the current value of SysTick.
#define INTERRUPT_STATE (*(volatile uint32_t *)0xe000ed04u)
#define CLOCK_LEFT (*(volatile uint32_t *)0xe000e018u)
#define TICK_IS_DUE (1u << 26)
static const os_stack_t untouched = 0xa5a5a5a5a5a5a5a5u; // what a kernel paints too, if it does

static struct {
    os_hooks_t hooks;
    volatile uint32_t stopping;  // 1: os_stop was called
    volatile uint32_t time;      // ticks
    uint32_t ready;              // 1: glue_init has done its work
    uint32_t tick_units, overruns;
    uint32_t running;            // priority, OS_PRIORITIES: the starter
    uint64_t switched_at, interrupt_units;
    struct {
        os_stack_t *stack;
        size_t words;
        os_task_report_t report;
    } task[OS_PRIORITIES + 1];
    os_stack_t starter_stack[OS_STACK_WORDS(STARTER_BYTES)];
} state;

uint32_t os_critical_enter(void) {
    uint32_t before = 0;
    __asm__ volatile("mrs %0, primask\n cpsid i" : "=r"(before)::"memory");
    return before;
}

void os_critical_exit(uint32_t before) {
    __asm__ volatile("msr primask, %0" ::"r"(before) : "memory");
}

uint32_t os_time(void) { return state.time; }

uint64_t os_clock(void) {
    const uint32_t before = os_critical_enter();
    uint32_t left = CLOCK_LEFT;
    uint32_t time = state.time;
    if (INTERRUPT_STATE & TICK_IS_DUE) { // it began again and nobody has counted that yet
        left = CLOCK_LEFT;
        time++;
    }
    const uint64_t clock = (uint64_t)time * state.tick_units + (state.tick_units - 1u - left);
    os_critical_exit(before);
    return state.tick_units == 0 ? 0 : clock;
}

void os_spend(uint32_t units) { (void)units; }
uint32_t os_overruns(void) { return state.overruns; }
uint64_t os_interrupt_units(void) { return state.interrupt_units; }

void os_init(const os_hooks_t *hooks) {
    memset(&state, 0, sizeof state);
    if (hooks) state.hooks = *hooks;
    state.running = OS_PRIORITIES;
    state.ready = (uint32_t)glue_init();
}

// Words at the far end of a task's stack that were never touched, most at most.
static size_t untouched_words(uint32_t priority, size_t most) {
    size_t n = 0;
    while (n < most && state.task[priority].stack[n] == untouched) n++;
    return n;
}

static void tell(os_fault_t fault, uint32_t priority) {
    if (state.hooks.fault) state.hooks.fault(state.hooks.user, fault, priority);
}

// Nothing is known to hold any more, so that nobody goes on.
void glue_refused(void) {
    (void)os_critical_enter();
    tell(OS_FAULT_KERNEL, state.running);
    for (;;) continue;
}

static os_status_t status_of(glue_answer_t answer, os_status_t not_now) {
    if (answer == GLUE_REFUSED) glue_refused();
    return answer == GLUE_DONE ? OS_OK : not_now;
}

static int create(uint32_t priority, void (*entry)(void *user), void *user, os_stack_t *stack,
                  size_t words) {
    memset(stack, PAINT, words * sizeof *stack);
    state.task[priority].stack = stack;
    state.task[priority].words = words;
    const uint32_t theirs = priority < OS_PRIORITIES ? priority + GLUE_PRIORITY_TASKS
                                                     : (uint32_t)GLUE_PRIORITY_STARTER;
    return glue_task_create(theirs, entry, user, stack + GUARD_WORDS,
                            (words - GUARD_WORDS) * sizeof *stack);
}

os_status_t os_task_create(uint32_t priority, const char *name, void (*entry)(void *user),
                           void *user, os_stack_t *stack, size_t words) {
    if (priority >= OS_PRIORITY_IDLE || state.task[priority].stack) return OS_E_PRIORITY;
    if (!entry || words <= 2 * GUARD_WORDS) return OS_E_ARGUMENT;
    state.task[priority].report.name = name;
    return create(priority, entry, user, stack, words) ? OS_OK : OS_E_ARGUMENT;
}

// The end is its own to go: whoever calls os_stop may be an interrupt. os_start's caller is out of
// reach: FreeRTOS has set the main stack back to its start, and interrupts have written over it.
static void starter(void *user) {
    (void)user;
    glue_clock_start(state.tick_units);
    while (!state.stopping) (void)os_delay(1);
    (void)os_critical_enter();
    if (state.hooks.over) state.hooks.over(state.hooks.user);
    for (;;) continue;
}

os_status_t os_start(uint32_t tick_units) {
    if (tick_units == 0 || tick_units > 1u << 24) return OS_E_ARGUMENT;
    if (!state.ready || state.tick_units > 0) return OS_E_CONTEXT;
    state.tick_units = tick_units;
    if (!create(OS_PRIORITIES, starter, NULL, state.starter_stack,
                sizeof state.starter_stack / sizeof(os_stack_t))) {
        return OS_E_ARGUMENT;
    }
    glue_start();
    return OS_E_CONTEXT;
}

void os_stop(void) {
    state.stopping = 1;
    const int in_interrupt = (INTERRUPT_STATE & 0x1ffu) != 0;
    while (!in_interrupt) (void)os_delay(1); // a task that stops does not return
}

os_status_t os_delay(uint32_t ticks) {
    return ticks > 0 ? status_of(glue_delay(ticks), OS_OK) : OS_OK;
}

// The handle takes the place of the slots, which the kernel has now.
os_status_t os_queue_create(os_queue_t *queue, void **slots, uint32_t capacity) {
    if (capacity == 0) return OS_E_ARGUMENT;
    queue->capacity = capacity;
    queue->slots = glue_queue_create(slots, capacity);
    return queue->slots ? OS_OK : OS_E_ARGUMENT;
}

os_status_t os_queue_pend(os_queue_t *queue, uint32_t timeout, void **message_out) {
    return status_of(glue_queue_pend(queue->slots, timeout, message_out), OS_TIMED_OUT);
}

os_status_t os_queue_post(os_queue_t *queue, void *message) {
    if (state.tick_units == 0) return OS_E_CONTEXT;
    return status_of(glue_queue_post(queue->slots, message), OS_FULL);
}

os_status_t os_stack_left(uint32_t priority, size_t *bytes_out) {
    if (priority >= OS_PRIORITIES || !state.task[priority].stack) return OS_E_PRIORITY;
    const size_t words = untouched_words(priority, state.task[priority].words);
    *bytes_out = words < GUARD_WORDS ? 0 : (words - GUARD_WORDS) * sizeof(os_stack_t);
    return OS_OK;
}

os_status_t os_task_report(uint32_t priority, os_task_report_t *report_out) {
    if (priority >= OS_PRIORITIES || !state.task[priority].stack) return OS_E_PRIORITY;
    *report_out = state.task[priority].report;
    return OS_OK;
}

static void charge(uint64_t now) {
    state.task[state.running].report.run_units += now - state.switched_at;
    state.switched_at = now;
}

void glue_switch(uint32_t priority) {
    charge(os_clock());
    os_task_report_t *const left = &state.task[state.running].report;
    const int guarded = state.task[state.running].stack && left->fault == OS_FAULT_NONE;
    if (guarded && untouched_words(state.running, GUARD_WORDS) < GUARD_WORDS) {
        left->fault = OS_FAULT_STACK;
        tell(OS_FAULT_STACK, state.running);
    }
    const uint32_t next = priority - GLUE_PRIORITY_TASKS;
    state.running = next < OS_PRIORITIES ? next : OS_PRIORITIES;
    state.task[state.running].report.switches++;
}

void glue_tick(void) {
    state.time++;
    const uint64_t begin = os_clock();
    charge(begin);
    if (state.hooks.tick) state.hooks.tick(state.hooks.user);
    if (INTERRUPT_STATE & TICK_IS_DUE) {
        state.overruns++;
        if (state.overruns == 1) tell(OS_FAULT_OVERRUN, OS_PRIORITIES);
    }
    state.switched_at = os_clock();
    state.interrupt_units += state.switched_at - begin;
}
