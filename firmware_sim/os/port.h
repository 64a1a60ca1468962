// SPDX-License-Identifier: MIT
// What the kernel needs from a processor, and what it gives to its handlers. A port is one folder
// that implements this page, and os_critical_enter, os_critical_exit and os_spend of os.h.
#ifndef OS_PORT_H
#define OS_PORT_H

#include "os/os.h"

// Of the port -----------------------------------------------------------------------------------

// Build a context at the top of a stack that starts at entry when it is first switched to; entry
// never returns. Returns the context, NULL if the stack is too small. Context: before, task.
void *os_port_context(os_stack_t *stack, size_t words, void (*entry)(void));

// 1: tick_units is a tick's length that the timer can count.
int os_port_can_count(uint32_t tick_units);

// Start the clock at 0, switch to what os_switch returns, and come back when that is
// os_port_caller(). Context: before.
void os_port_start(uint32_t tick_units);

// The context of os_port_start's caller. Context: from os_switch.
void *os_port_caller(void);

// Have os_switch called as soon as no interrupt runs and none is kept out.
void os_port_pend_switch(void);

// 1 if a task is running and interrupts are let in: it may wait.
int os_port_may_wait(void);

// 1 if an interrupt handler is running.
int os_port_in_interrupt(void);

// 1 if the next tick is due already.
int os_port_tick_is_due(void);

// Units since os_port_start. Interrupts are kept out.
uint64_t os_port_clock(void);

// Wait for an interrupt. Context: the idle task.
void os_port_idle(void);

// Of the kernel ---------------------------------------------------------------------------------

// The tick interrupt's work.
void os_tick(void);

// The running task was put aside: its context and its stack pointer (NULL: there was none).
// Returns the context to go on with. Interrupts are kept out.
void *os_switch(void *context, const void *stack_pointer);

#endif
