// SPDX-License-Identifier: MIT
// The host port: a processor with virtual time. Tasks are coroutines on their own stacks; nobody
// reads a clock, so that the same run has the same schedule.
//
// Time passes in three places: os_spend, one unit whenever a task enters a critical section, so
// that every call of the kernel is a place where a tick may preempt, and the idle task, which goes
// to the next tick at once. Handlers take the time that they spend, and none else.
#define _XOPEN_SOURCE 700 // ucontext

#include "os/port.h"

#include <string.h>   // memset
#include <ucontext.h> // getcontext makecontext swapcontext

typedef struct host {
    ucontext_t caller;     // of os_port_start
    ucontext_t *running;
    uint64_t clock, next_tick;
    uint32_t tick_units;   // 0: not started
    uint32_t kept_out;     // 1: interrupts are
    uint32_t in_interrupt;
    uint32_t tick_pending, switch_pending;
} host_t;

static host_t host;

// On its own, because getcontext might return twice: here nobody goes back to it.
static void fill(ucontext_t *context) { (void)getcontext(context); }

void *os_port_context(os_stack_t *stack, size_t words, void (*entry)(void))
{
    const size_t bytes = words * sizeof *stack;
    if (bytes <= OS_STACK_RESERVE) return NULL;
    // The context stands at the near end, the coroutine's stack is the rest.
    const size_t rest = (bytes - sizeof(ucontext_t)) & ~(size_t)63;
    ucontext_t *const context = (ucontext_t *)(void *)((char *)stack + rest);
    fill(context);
    context->uc_stack.ss_sp = stack;
    context->uc_stack.ss_size = rest;
    context->uc_link = NULL;
    makecontext(context, entry, 0);
    return context;
}

int os_port_can_count(uint32_t tick_units) { return tick_units >= 1; }

static void switch_over(void)
{
    ucontext_t *const from = host.running;
    host.kept_out = 1;
    ucontext_t *const to = os_switch(from, __builtin_frame_address(0));
    host.kept_out = 0;
    host.switch_pending = 0;
    if (to == from) return;
    host.running = to;
    (void)swapcontext(from, to);
}

// What waited for interrupts to be let in: the tick first, the switch last, as in hardware.
static void take_interrupts(void)
{
    while (host.tick_pending || host.switch_pending) {
        if (host.tick_pending) {
            host.tick_pending = 0;
            host.in_interrupt = 1;
            os_tick();
            host.in_interrupt = 0;
        } else {
            switch_over();
        }
    }
}

// A tick that comes while one is pending is lost, as with a timer's pending bit.
static void pass(uint64_t units)
{
    while (units > 0) {
        const uint64_t left = host.next_tick - host.clock;
        const uint64_t step = units < left ? units : left;
        host.clock += step;
        units -= step;
        if (host.clock == host.next_tick) {
            host.next_tick += host.tick_units;
            host.tick_pending = 1;
        }
        if (!host.kept_out && !host.in_interrupt) take_interrupts();
    }
}

void os_port_start(uint32_t tick_units)
{
    memset(&host, 0, sizeof host);
    host.tick_units = tick_units;
    host.next_tick = tick_units;
    host.running = os_switch(NULL, NULL);
    (void)swapcontext(&host.caller, host.running);
    host.tick_units = 0;
}

void *os_port_caller(void) { return &host.caller; }

void os_port_pend_switch(void) { host.switch_pending = 1; }

int os_port_may_wait(void) { return !host.kept_out && !host.in_interrupt; }

int os_port_in_interrupt(void) { return host.in_interrupt != 0; }

int os_port_tick_is_due(void) { return host.tick_pending != 0; }

uint64_t os_port_clock(void) { return host.clock; }

void os_port_idle(void) { pass(host.next_tick - host.clock); }

void os_spend(uint32_t units)
{
    if (host.tick_units > 0) pass(units);
}

uint32_t os_critical_enter(void)
{
    const uint32_t before = host.kept_out;
    if (!before && !host.in_interrupt) os_spend(1);
    host.kept_out = 1;
    return before;
}

void os_critical_exit(uint32_t before)
{
    host.kept_out = before;
    if (!before && !host.in_interrupt && host.tick_units > 0) take_interrupts();
}
