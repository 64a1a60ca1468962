// SPDX-License-Identifier: MIT
// Between os.c, which is os.h on a Cortex-M with somebody else's kernel, and one file for each such
// kernel. No type of either side passes through here, so that their names cannot meet.
//
// Priorities are os.h's plus GLUE_PRIORITY_TASKS: 0 is the highest, below it stands the starter.
#ifndef GLUE_H
#define GLUE_H

#include <stddef.h> // size_t
#include <stdint.h> // uint32_t

enum {
    GLUE_PRIORITY_STARTER = 1, // above all tasks: starts the clock and looks for the end
    GLUE_PRIORITY_TASKS = 2,   // os.h's priority 0
    GLUE_TASKS = 17,           // at most, the starter included
    GLUE_QUEUES = 4            // at most
};

// What came of a call.
typedef enum glue_answer {
    GLUE_DONE = 0,
    GLUE_NOT_NOW = 1, // the time is up, the queue is full or empty
    GLUE_REFUSED = 2  // the kernel found the call wrong: it should never say so
} glue_answer_t;

#define GLUE_FOREVER 0xFFFFFFFFu // a timeout: wait until it comes; 0: look once

// Of the kernel's file ----------------------------------------------------------------------------

// Get the kernel ready. Returns 1 if done. Context: before.
int glue_init(void);

// Create a task on a stack of so many bytes, a multiple of 8, which the kernel may not clear.
// Returns 1 if done. Context: before.
int glue_task_create(uint32_t priority, void (*entry)(void *user), void *user, void *stack,
                     size_t bytes);

// Start the scheduler; returns only if the kernel refuses to. The caller's frame may be lost: some
// kernels give the main stack to interrupts from here on. Context: before.
void glue_start(void);

// Start the tick: an interrupt every so many cycles. Context: the starter.
void glue_clock_start(uint32_t cycles);

// Sleep until the ticks-th tick from now, ticks ≥ 1. Context: task.
glue_answer_t glue_delay(uint32_t ticks);

// Make a queue of pointers on slots. Returns the kernel's queue, NULL: none left. Context: before.
void *glue_queue_create(void **slots, uint32_t capacity);

// Take the oldest pointer, waiting so many ticks at most. Context: task.
glue_answer_t glue_queue_pend(void *queue, uint32_t timeout, void **message_out);

// Put a pointer in. Context: task, interrupt.
glue_answer_t glue_queue_post(void *queue, void *message);

// Of the board's vector table: the kernel takes them.
void SVC_Handler(void);
void PendSV_Handler(void);
void SysTick_Handler(void);

// Of os.c -----------------------------------------------------------------------------------------

// The kernel's tick hook calls this, in the interrupt, before any task is woken.
void glue_tick(void);

// The kernel's own check failed: tells the fault hook, and does not return. Context: any.
void glue_refused(void);

// The kernel's switch hook calls this with the priority that goes on, interrupts kept out.
void glue_switch(uint32_t priority);

#endif
