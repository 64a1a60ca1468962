// SPDX-License-Identifier: MIT
// The kernel's inside, for its own files: tasks, the ready set, and waiting. All of it is called
// with interrupts kept out.
#ifndef OS_KERNEL_H
#define OS_KERNEL_H

#include "os/os.h"
#include "os/port.h" // os_port_may_wait

// A task, as the kernel keeps it.
typedef struct os_task {
    void *context;               // of the port, while the task does not run
    void (*entry)(void *user);   // NULL: there is no such task
    void *user;
    os_stack_t *stack;           // its far end; it grows towards it
    size_t words;
    uint32_t name;               // its priority when it was created
    uint32_t priority;           // now: name, or the ceiling of a mutex
    uint32_t timed;              // 1: wakes when time is wake
    uint32_t wake;
    uint32_t *waiting;           // the set of an object that it waits for, or NULL
    os_status_t result;          // of the wait
    void *message;               // that a queue gave it
    os_mutex_t *mutex;           // taken last, or NULL
    os_task_report_t report;
} os_task_t;

// How far the kernel is.
typedef enum os_phase {
    OS_PHASE_BEFORE = 0,
    OS_PHASE_RUNNING = 1,
    OS_PHASE_STOPPING = 2,
    OS_PHASE_OVER = 3
} os_phase_t;

// All that the kernel knows.
typedef struct os_kernel {
    os_hooks_t hooks;
    os_phase_t phase;
    uint32_t time;
    uint32_t overruns;
    uint32_t ready;                     // a bit for each priority
    uint32_t ceilings;                  // priorities that are mutexes'
    os_task_t *running;
    os_task_t *at[OS_PRIORITIES];       // who has this priority now
    os_task_t task[OS_PRIORITIES];      // by name
    uint64_t switched_at;               // time is charged to the running task from here on
    uint64_t interrupt_units;
} os_kernel_t;

// An interrupt has no argument, so the kernel is the one thing here that stands at file scope.
extern os_kernel_t os_kernel;

// The bit of a priority in a set.
static inline uint32_t os_bit(uint32_t priority) { return 1u << priority; }

// 1 if the caller is a task that may wait here.
static inline int os_may_wait(void) { return os_kernel.running && os_port_may_wait(); }

// The task of the highest priority in a set that is not empty. Cost: constant.
os_task_t *os_highest(uint32_t set);

// Have the running task give way if a higher one is ready. Cost: constant.
void os_schedule(void);

// Put the running task into the set of an object (NULL: none) for at most timeout ticks. It is
// switched away when interrupts are let in again. Cost: constant.
void os_wait(uint32_t *waiting, uint32_t timeout);

// Make a task that waits ready; its wait returns result. Cost: constant.
void os_wake(os_task_t *task, os_status_t result);

// Give a task that does not wait another priority. Cost: constant.
void os_move(os_task_t *task, uint32_t priority);

// Tell a fault of a task (NULL: of nobody) by the hook. Cost: the hook's.
void os_fault(os_task_t *task, os_fault_t fault);

#endif
