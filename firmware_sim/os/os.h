// SPDX-License-Identifier: MIT
// A small static preemptive kernel in the shape of µC/OS-II: the ready task of the highest priority
// runs, always. Nothing is allocated, nothing waits for ever unless OS_FOREVER is written.
//
// Contexts: "task" is a task's own code, "interrupt" a handler or the tick hook, "before" is before
// os_start. A call from a wrong context returns OS_E_CONTEXT and changes nothing.
#ifndef OS_H
#define OS_H

#include <stddef.h> // size_t
#include <stdint.h> // uint32_t uint64_t

#ifndef OS_STACK_RESERVE
#define OS_STACK_RESERVE 208 // bytes of every stack that are the port's: a Cortex-M's saved
#endif                       // registers; the build of another port says how many

// Bounds of the kernel.
enum {
    OS_PRIORITIES = 16,                   // 0 is the highest; one task, or one ceiling, each
    OS_PRIORITY_IDLE = OS_PRIORITIES - 1, // the kernel's own task
    OS_STACK_GUARD = 256                  // bytes at the stack's far end that nobody may touch
};

#define OS_NO_WAIT 0u           // a timeout: look once
#define OS_FOREVER 0xFFFFFFFFu  // a timeout: wait until it comes

// What a call returns.
typedef enum os_status {
    OS_OK = 0,
    OS_TIMED_OUT = 1,    // it did not come in time
    OS_FULL = 2,         // the queue has no room
    OS_LATE = 3,         // the time has passed already: nobody waited
    OS_E_ARGUMENT = -1,  // an argument outside of its range
    OS_E_PRIORITY = -2,  // the priority is taken, or there is no such task
    OS_E_CONTEXT = -3,   // not from here: an interrupt, a critical section, or before os_start
    OS_E_OWNER = -4,     // the mutex is another's, held already, or not the last one taken
    OS_E_CEILING = -5,   // the caller's priority is above the mutex's ceiling
    OS_E_COUNT = -6      // the semaphore counts no further
} os_status_t;

// What the kernel finds by itself. Told by the fault hook, once for each task and kind.
typedef enum os_fault {
    OS_FAULT_NONE = 0,
    OS_FAULT_STACK = 1,   // the task left its stack or touched the guard: it never runs again
    OS_FAULT_OVERRUN = 2, // a tick came before the tick hook of the last one was done
    OS_FAULT_MUTEX = 3,   // the task ended while it held a mutex, which stays taken
    OS_FAULT_KERNEL = 4   // of ../glue: the kernel refused a call, or a check of its own failed
} os_fault_t;

// A stack is a static array: os_stack_t stack[OS_STACK_WORDS(1024)].
typedef uint64_t os_stack_t;
#define OS_STACK_WORDS(bytes) \
    (((bytes) + OS_STACK_GUARD + OS_STACK_RESERVE + sizeof(os_stack_t) - 1) / sizeof(os_stack_t))

// The application's functions that the kernel calls. Any may be NULL.
typedef struct os_hooks {
    void (*tick)(void *user); // every tick, in the interrupt, before any task is woken
    void (*fault)(void *user, os_fault_t fault, uint32_t priority); // interrupts off; short
    void *user;               // handed to all
    void (*over)(void *user); // after os_stop, when no task and no tick runs any more
} os_hooks_t;

// What a task did so far.
typedef struct os_task_report {
    const char *name;
    os_fault_t fault;      // last one found, or OS_FAULT_NONE
    uint32_t ended;        // 1: it returned, or was stopped for its fault
    uint32_t switches;     // how often it was given the processor
    uint64_t run_units;    // time it ran, in units of os_clock, interrupts not included
} os_task_report_t;

// Fields are the kernel's own.
typedef struct os_sem {
    uint32_t count;
    uint32_t waiting; // a bit for each priority that waits
} os_sem_t;

// Fields are the kernel's own.
typedef struct os_mutex {
    uint32_t ceiling; // the owner runs at this priority, or its own if that is higher
    uint32_t owner;   // the task, OS_PRIORITIES: nobody
    uint32_t before;  // the owner's priority when it came
    uint32_t waiting;
    struct os_mutex *previous; // which the owner took before this one
} os_mutex_t;

// Fields are the kernel's own.
typedef struct os_queue {
    void **slots;
    uint32_t capacity, used, first;
    uint32_t waiting;
} os_queue_t;

// The kernel -------------------------------------------------------------------------------------

// Forget everything and take the hooks (copied; NULL: none). First call of all.
// Cost: constant. Context: before.
void os_init(const os_hooks_t *hooks);

// Create a task: it is named by its priority, 0 … OS_PRIORITY_IDLE − 1, and starts at
// entry(user) as soon as no higher one is ready. Returning from entry ends it. name: static text.
// stack: words of it, static; painted here.
// Returns OS_OK; OS_E_PRIORITY: taken by a task or a ceiling; OS_E_ARGUMENT: no entry, or a stack
// below the guard, the port's reserve and a context; OS_E_CONTEXT. Cost: linear in the stack.
// Context: before, task.
os_status_t os_task_create(uint32_t priority, const char *name, void (*entry)(void *user),
                           void *user, os_stack_t *stack, size_t words);

// Run the tasks. tick_units: length of a tick in units of os_clock (processor cycles on a Cortex-M,
// where it is at most 2^24; virtual units on the host), ≥ 1. Returns OS_OK after os_stop and the
// hook `over`; OS_E_ARGUMENT; OS_E_CONTEXT: it runs already, or ran (os_init comes first). Kernels
// of ../glue have no way back: there the hook is the last that is called. Context: before.
os_status_t os_start(uint32_t tick_units);

// End: no task runs any more, the hook `over` is called and os_start returns. Cost: constant.
// Context: task (it does not return), interrupt (it returns, the end follows after the interrupt).
void os_stop(void);

// Time -------------------------------------------------------------------------------------------

// Ticks since os_start; wraps after 2^32. Cost: constant. Context: any.
uint32_t os_time(void);

// Units since os_start, to measure with; never goes back. Cost: constant. Context: any.
uint64_t os_clock(void);

// Sleep until the ticks-th tick from now, between ticks − 1 and ticks periods; 0: return at once.
// Returns OS_OK, OS_E_CONTEXT. OS_FOREVER sleeps for ever. Cost: constant. Context: task.
os_status_t os_delay(uint32_t ticks);

// Sleep until os_time() is time, which lies less than 2^31 ticks away.
// Returns OS_OK; OS_LATE: that was before now; OS_E_CONTEXT. Cost: constant. Context: task.
os_status_t os_delay_until(uint32_t time);

// Say that a piece of work is done that lasts so many units. On the host virtual time passes and
// ticks may preempt here; on a processor work takes the time it takes and this does nothing.
// Cost: constant, or the ticks that pass. Context: task, interrupt.
void os_spend(uint32_t units);

// How often a tick came while the tick before was at work. Cost: constant. Context: any.
uint32_t os_overruns(void);

// Semaphore: counts; the highest task that waits is served first ----------------------------------

// Returns OS_OK, OS_E_ARGUMENT. Cost: constant. Context: any.
os_status_t os_sem_create(os_sem_t *sem, uint32_t count);

// Take one, or wait at most timeout ticks (counted as by os_delay), OS_NO_WAIT or OS_FOREVER.
// Returns OS_OK, OS_TIMED_OUT, OS_E_ARGUMENT, OS_E_CONTEXT. Cost: constant.
// Context: task; with OS_NO_WAIT any.
os_status_t os_sem_pend(os_sem_t *sem, uint32_t timeout);

// Give one. Returns OS_OK, OS_E_COUNT (2^32 − 1 are there), OS_E_ARGUMENT. Cost: constant.
// Context: any, interrupts too.
os_status_t os_sem_post(os_sem_t *sem);

// Mutex: its owner runs at the ceiling, so that a lower task holds up a higher one for the length
// of one critical region at most ------------------------------------------------------------------

// ceiling: a priority of its own, above all tasks that use the mutex, and no task's.
// Returns OS_OK, OS_E_PRIORITY, OS_E_ARGUMENT, OS_E_CONTEXT. Cost: constant. Context: before, task.
os_status_t os_mutex_create(os_mutex_t *mutex, uint32_t ceiling);

// Take it, or wait at most timeout ticks, OS_NO_WAIT or OS_FOREVER.
// Returns OS_OK; OS_TIMED_OUT; OS_E_OWNER: the caller has it; OS_E_CEILING; OS_E_ARGUMENT;
// OS_E_CONTEXT. Cost: constant. Context: task.
os_status_t os_mutex_pend(os_mutex_t *mutex, uint32_t timeout);

// Give it back; what was taken last goes back first.
// Returns OS_OK, OS_E_OWNER, OS_E_ARGUMENT, OS_E_CONTEXT. Cost: constant. Context: task.
os_status_t os_mutex_post(os_mutex_t *mutex);

// Queue of pointers, first in, first out ----------------------------------------------------------

// slots: static storage for capacity pointers, ≥ 1.
// Returns OS_OK, OS_E_ARGUMENT. Cost: constant. Context: any.
os_status_t os_queue_create(os_queue_t *queue, void **slots, uint32_t capacity);

// Take the oldest message, or wait at most timeout ticks, OS_NO_WAIT or OS_FOREVER.
// Returns OS_OK, OS_TIMED_OUT (*message_out is left alone), OS_E_ARGUMENT, OS_E_CONTEXT.
// Cost: constant. Context: task; with OS_NO_WAIT any.
os_status_t os_queue_pend(os_queue_t *queue, uint32_t timeout, void **message_out);

// Put a message in; never waits. Returns OS_OK, OS_FULL, OS_E_ARGUMENT. Cost: constant.
// Context: any, interrupts too.
os_status_t os_queue_post(os_queue_t *queue, void *message);

// Critical section and checks ---------------------------------------------------------------------

// Keep interrupts out; sections nest. Returns what os_critical_exit needs.
// Cost: constant. Context: any.
uint32_t os_critical_enter(void);

// Let them in again as they were before. Cost: constant. Context: any.
void os_critical_exit(uint32_t before);

// Bytes of a task's stack that were never touched, the guard not counted; 0 if it was.
// Returns OS_OK, OS_E_PRIORITY, OS_E_ARGUMENT. Cost: linear in the stack. Context: any.
os_status_t os_stack_left(uint32_t priority, size_t *bytes_out);

// What a task (OS_PRIORITY_IDLE: the kernel's own) did so far.
// Returns OS_OK, OS_E_PRIORITY, OS_E_ARGUMENT. Cost: constant. Context: any.
os_status_t os_task_report(uint32_t priority, os_task_report_t *report_out);

// Units spent in the tick interrupt so far. Cost: constant. Context: any.
uint64_t os_interrupt_units(void);

#endif
