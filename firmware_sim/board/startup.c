// SPDX-License-Identifier: MIT
// From reset to main: vector table, floating-point unit, data and bss. A fault ends the run with a
// status of its own, so that a test can tell them apart.
#include "board/board.h" // board_exit board_on_fault

#include <string.h> // memcpy memset

// Of the linker script: only their addresses mean something, that of a size being the size.
extern uint32_t board_stack_top[];
extern uint8_t board_data_load[], board_data_begin[], board_data_size[];
extern uint8_t board_bss_begin[], board_bss_size[];

int main(void);

// Names as in Arm's own start-up files: what a port of an operating system expects.
void Reset_Handler(void);
void NMI_Handler(void);
void HardFault_Handler(void);
void MemManage_Handler(void);
void BusFault_Handler(void);
void UsageFault_Handler(void);
void SVC_Handler(void);
void DebugMon_Handler(void);
void PendSV_Handler(void);
void SysTick_Handler(void);
void board_fault(void);
void board_end_in_fault(void);

__attribute__((weak)) void board_on_fault(void) {}

static uint32_t exception(void) {
    uint32_t number;
    __asm__ volatile("mrs %0, ipsr" : "=r"(number));
    return number;
}

void board_end_in_fault(void) {
    enum { NMI = 2, USAGE_FAULT = 6 };
    const uint32_t number = exception();
    const int known = number >= NMI && number <= USAGE_FAULT;
    board_on_fault();
    board_exit(known ? BOARD_EXIT_NMI + (int)number - NMI : BOARD_EXIT_UNEXPECTED);
}

// errno of Newlib's mathematics, which lies in 1 KB of state of its streams otherwise.
int *__errno(void);
static int error_number = 0;
int *__errno(void) { return &error_number; }

// The stack may be what is broken: begin it anew. Nobody goes back.
__attribute__((naked)) void board_fault(void) {
    __asm__ volatile("ldr r0, =board_stack_top\n"
                     "msr msp, r0\n"
                     "b board_end_in_fault\n");
}

#define FREE_TO_TAKE __attribute__((weak, alias("board_fault")))
FREE_TO_TAKE void NMI_Handler(void);
FREE_TO_TAKE void HardFault_Handler(void);
FREE_TO_TAKE void MemManage_Handler(void);
FREE_TO_TAKE void BusFault_Handler(void);
FREE_TO_TAKE void UsageFault_Handler(void);
FREE_TO_TAKE void SVC_Handler(void);
FREE_TO_TAKE void DebugMon_Handler(void);
FREE_TO_TAKE void PendSV_Handler(void);
FREE_TO_TAKE void SysTick_Handler(void);

typedef struct vectors { // the core reads it
    // cppcheck-suppress unusedStructMember
    uint32_t *stack_top;
    // cppcheck-suppress unusedStructMember
    void (*exception[15])(void); // numbers 1 … 15; no device interrupt is ever enabled
} vectors_t;

__attribute__((section(".vectors"), used)) static const vectors_t vectors = {
    board_stack_top,
    {Reset_Handler, NMI_Handler, HardFault_Handler, MemManage_Handler, BusFault_Handler,
     UsageFault_Handler, 0, 0, 0, 0, SVC_Handler, DebugMon_Handler, 0, PendSV_Handler,
     SysTick_Handler},
};

// Armv7-M Architecture Reference Manual, B3.2: SHCSR, CCR and CPACR.
static void enable_faults(void) {
    volatile uint32_t *const handlers = (volatile uint32_t *)0xe000ed24u;
    volatile uint32_t *const configuration = (volatile uint32_t *)0xe000ed14u;
    *handlers |= 7u << 16;     // usage, bus and memory faults have handlers of their own
    *configuration |= 1u << 4; // division of integers by zero is a fault
}

static void enable_floating_point(void) {
    volatile uint32_t *const coprocessors = (volatile uint32_t *)0xe000ed88u;
    *coprocessors |= 0xfu << 20;
    __asm__ volatile("dsb\n isb" ::: "memory");
}

void Reset_Handler(void) {
    enable_floating_point();
    enable_faults();
    memcpy(board_data_begin, board_data_load, (uintptr_t)board_data_size);
    memset(board_bss_begin, 0, (uintptr_t)board_bss_size);
    board_exit(main());
}
