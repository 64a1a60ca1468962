// SPDX-License-Identifier: MIT
// A stage for the tests of the small kernel, on the host and on a target: tasks note what happens,
// and the test looks at it after the kernel has stopped. No task prints: its stack is small.
#ifndef OS_CHECK_H
#define OS_CHECK_H

#include <string.h> // memset strcmp

#include "check.h"
#include "os/kernel.h" // os_kernel: invariants, and the time before it wraps

enum { TICK_UNITS = 1000, TASK_BYTES = 1024, TRACE_MAX = 120, LIMIT_TICKS = 3000 };

typedef struct stage {
    char trace[TRACE_MAX + 1];
    size_t traced;
    uint32_t ticks;            // seen by the hook
    uint32_t broken;           // invariants found broken, at ticks
    void (*on_tick)(void);     // NULL: none
    os_fault_t fault;          // the last one told
    uint32_t faulty;           // whose
    uint32_t faults;           // how many
} stage_t;

static stage_t stage;
static os_stack_t stacks[OS_PRIORITY_IDLE][OS_STACK_WORDS(TASK_BYTES)];

// Add a letter to the trace.
static inline void note(char letter)
{
    const uint32_t before = os_critical_enter();
    if (stage.traced < TRACE_MAX) stage.trace[stage.traced++] = letter;
    os_critical_exit(before);
}

// Whoever runs is ready, the ready are where they should be, and who waits is not ready.
static inline int kernel_is_sound(void)
{
    int good = 1;
    for (uint32_t k = 0; k < OS_PRIORITIES; k++) {
        const os_task_t *const task = &os_kernel.task[k];
        const int ready = (os_kernel.ready & os_bit(task->priority)) != 0;
        if (!task->entry) continue;
        good &= os_kernel.at[task->priority] == task && task->priority <= task->name;
        good &= !(ready && (task->timed || task->waiting));
        good &= !task->waiting || (*task->waiting & os_bit(task->priority)) != 0;
        good &= !(ready && task->report.ended);
    }
    return good;
}

static inline void tick_hook(void *user)
{
    (void)user;
    stage.ticks++;
    const uint32_t before = os_critical_enter();
    stage.broken += !kernel_is_sound();
    os_critical_exit(before);
    if (stage.on_tick) stage.on_tick();
    if (stage.ticks >= LIMIT_TICKS) os_stop();
}

static inline void fault_hook(void *user, os_fault_t fault, uint32_t priority)
{
    (void)user;
    stage.fault = fault;
    stage.faulty = priority;
    stage.faults++;
}

static inline void begin(void)
{
    memset(&stage, 0, sizeof stage);
    const os_hooks_t hooks = {.tick = tick_hook, .fault = fault_hook};
    os_init(&hooks);
}

static inline os_status_t add(uint32_t priority, void (*entry)(void *user))
{
    return os_task_create(priority, "task", entry, NULL, stacks[priority],
                          sizeof stacks[priority] / sizeof stacks[priority][0]);
}

// Run until somebody stops; a test that nobody stops is broken.
static inline void run_by(check_t *check, uint32_t tick_units)
{
    CHECK_INT(check, os_start(tick_units), OS_OK);
    CHECK(check, stage.ticks < LIMIT_TICKS);
    CHECK_INT(check, stage.broken, 0);
}

static inline void run(check_t *check) { run_by(check, TICK_UNITS); }

// Compute for so many ticks, without a wait.
static inline void be_busy(uint32_t ticks)
{
    const uint32_t begun = os_time();
    while (os_time() - begun < ticks) os_spend(20);
}

#define CHECK_TRACE(check, want) \
    if (!CHECK((check), strcmp(stage.trace, (want)) == 0)) \
        printf("    got \"%s\", want \"%s\"\n", stage.trace, (want))

#endif
