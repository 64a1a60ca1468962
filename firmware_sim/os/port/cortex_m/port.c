// SPDX-License-Identifier: MIT
// The port for Cortex-M4F and M7: SysTick is the tick, PendSV, of the lowest priority, switches.
// Registers: Armv7-M Architecture Reference Manual, B1.4, B3.2 and B3.3.
//
// A task that is put aside has on its stack, from the top down: the core's own frame (with s0 – s15
// and FPSCR if it used the floating-point unit), then s16 – s31 if so, then lr, r11 … r4. Bit 4 of
// lr (EXC_RETURN) is 0 for a task that used the unit: the others do not pay for it.
#include "os/port.h"

typedef struct systick {
    uint32_t control; // bit 0 counts, bit 1 interrupts, bit 2 clock of the core
    uint32_t reload;  // one less than the clocks of a period
    uint32_t value;   // counts down; a write sets it to 0
} systick_t;

enum {
    FRAME_WORDS = 17,     // r4 – r11, lr; r0 – r3, r12, lr, pc, xPSR
    FRAME_LR = 8,
    FRAME_PC = 15,
    FRAME_XPSR = 16,
    SCRATCH_WORDS = 64,
    SYSTICK_MAX = 1 << 24
};

static volatile systick_t *const systick = (volatile systick_t *)0xE000E010u;
static volatile uint32_t *const interrupt_control = (volatile uint32_t *)0xE000ED04u;
static volatile uint32_t *const system_priorities = (volatile uint32_t *)0xE000ED20u;

static const uint32_t pend_switch = 1u << 28;
static const uint32_t tick_pending = 1u << 26;
static const uint32_t clear_tick = 1u << 25;
static const uint32_t return_to_task = 0xFFFFFFFDu; // thread mode, process stack, no FPU frame
static const uint32_t thumb = 1u << 24;             // in xPSR

// Names as in Arm's own start-up files.
void PendSV_Handler(void);
void SysTick_Handler(void);
void *os_port_switch(void *stack_pointer);
void os_port_enter(os_stack_t *process_stack);
void os_port_return(void);

static uint64_t clock_base; // units up to the last tick that was counted
static uint64_t clock_last;
static uint32_t tick_units;
// The process stack on the way into the first task and out of the last one.
static os_stack_t scratch[SCRATCH_WORDS];
uint32_t *os_port_main_stack;

// A core's frame, as if the task had been interrupted before its first instruction.
static void *frame(os_stack_t *stack, size_t words, void (*entry)(void))
{
    uint32_t *const top = (uint32_t *)(void *)(stack + words);
    uint32_t *const context = top - FRAME_WORDS;
    for (int k = 0; k < FRAME_WORDS; k++) context[k] = 0;
    context[FRAME_LR] = return_to_task;
    context[FRAME_PC] = (uint32_t)(uintptr_t)entry & ~1u;
    context[FRAME_XPSR] = thumb;
    return context;
}

void *os_port_context(os_stack_t *stack, size_t words, void (*entry)(void))
{
    if (words * sizeof *stack <= OS_STACK_RESERVE) return NULL;
    return frame(stack, words, entry);
}

int os_port_can_count(uint32_t units) { return units >= 2 && units <= SYSTICK_MAX; }

// Save the caller's registers on the main stack, run on the process stack, and switch. It is
// os_port_return that returns to the caller.
__attribute__((naked)) void os_port_enter(os_stack_t *process_stack)
{
    (void)process_stack;
    __asm__ volatile(
        "push {r4-r11, lr}\n"
        "vpush {s16-s31}\n"
        "ldr r1, =os_port_main_stack\n"
        "str sp, [r1]\n"
        "msr psp, r0\n"
        "movs r0, #2\n" // thread mode uses the process stack
        "msr control, r0\n"
        "isb\n"
        "ldr r0, =0xE000ED04\n"
        "ldr r1, =0x10000000\n"
        "str r1, [r0]\n" // PendSV
        "cpsie i\n"
        "isb\n"
        "b .\n");
}

__attribute__((naked)) void os_port_return(void)
{
    __asm__ volatile(
        "movs r0, #0\n"
        "msr control, r0\n"
        "isb\n"
        "ldr r1, =os_port_main_stack\n"
        "ldr r1, [r1]\n"
        "mov sp, r1\n"
        "vpop {s16-s31}\n"
        "pop {r4-r11, pc}\n");
}

// SysTick keeps the highest priority, PendSV gets the lowest.
void os_port_start(uint32_t units)
{
    const uint32_t before = os_critical_enter();
    *system_priorities = (*system_priorities & 0x0000FFFFu) | (0xFFu << 16);
    clock_base = clock_last = 0;
    tick_units = units;
    systick->control = 0;
    systick->reload = units - 1;
    systick->value = 0;
    systick->control = 7;
    os_port_enter(scratch + SCRATCH_WORDS);
    os_critical_exit(before);
}

// On the scratch stack, as a task that was switched to.
static void leave(void)
{
    (void)os_critical_enter();
    systick->control = 0;
    *interrupt_control = clear_tick;
    os_port_return();
}

void *os_port_caller(void) { return frame(scratch, SCRATCH_WORDS, leave); }

__attribute__((naked)) void PendSV_Handler(void)
{
    __asm__ volatile(
        "mrs r0, psp\n"
        "isb\n"
        "tst lr, #0x10\n"
        "it eq\n"
        "vstmdbeq r0!, {s16-s31}\n"
        "stmdb r0!, {r4-r11, lr}\n"
        "cpsid i\n"
        "bl os_port_switch\n"
        "cpsie i\n"
        "ldmia r0!, {r4-r11, lr}\n"
        "tst lr, #0x10\n"
        "it eq\n"
        "vldmiaeq r0!, {s16-s31}\n"
        "msr psp, r0\n"
        "isb\n"
        "bx lr\n");
}

void *os_port_switch(void *stack_pointer) { return os_switch(stack_pointer, stack_pointer); }

void SysTick_Handler(void)
{
    clock_base += tick_units;
    os_tick();
}

void os_port_pend_switch(void) { *interrupt_control = pend_switch; }

static uint32_t exception(void)
{
    uint32_t number;
    __asm__ volatile("mrs %0, ipsr" : "=r"(number));
    return number;
}

static uint32_t kept_out(void)
{
    uint32_t mask;
    __asm__ volatile("mrs %0, primask" : "=r"(mask));
    return mask;
}

int os_port_may_wait(void) { return exception() == 0 && kept_out() == 0; }

int os_port_in_interrupt(void) { return exception() != 0; }

int os_port_tick_is_due(void) { return (*interrupt_control & tick_pending) != 0; }

// The counter reads 0 for the first clock of a period, then the period less one, and so on down.
static uint32_t phase(void)
{
    const uint32_t value = systick->value;
    return value == 0 ? 0 : tick_units - value;
}

// A tick that is due is not counted yet; if it became due after the counter was read, read again.
// SysTick keeps one tick in mind: a second one that comes while interrupts are kept out shows by
// the clock going back, and is put in, so that who works on and on still sees time pass.
uint64_t os_port_clock(void)
{
    uint32_t units = phase();
    const int due = os_port_tick_is_due();
    if (due) units = phase();
    uint64_t now = clock_base + units + (due ? tick_units : 0u);
    if (now < clock_last) {
        clock_base += tick_units;
        now += tick_units;
    }
    clock_last = now;
    return now;
}

void os_port_idle(void) { __asm__ volatile("dsb\n wfi" ::: "memory"); }

void os_spend(uint32_t units) { (void)units; }

uint32_t os_critical_enter(void)
{
    const uint32_t before = kept_out();
    __asm__ volatile("cpsid i" ::: "memory");
    return before;
}

// The barrier lets a switch that is pending happen before the next instruction.
void os_critical_exit(uint32_t before)
{
    __asm__ volatile("msr primask, %0\n isb" : : "r"(before) : "memory");
}
