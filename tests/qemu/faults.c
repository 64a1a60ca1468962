// SPDX-License-Identifier: MIT
// Every way in which a board ends a run that its program does not end: faults KIND.
#include <string.h> // strcmp

#include "board/board.h" // board_argument board_exit

enum { WORD_MAX = 16, PERIOD = 1000 };

void SysTick_Handler(void);

// A tick that takes longer than its period.
void SysTick_Handler(void) {
    while (!board_tick_is_due()) continue;
    board_exit(BOARD_EXIT_OVERRUN);
}

static volatile uint32_t *const nowhere = (volatile uint32_t *)0xf0000000u;
static volatile uint32_t *const fault_handlers = (volatile uint32_t *)0xe000ed24u; // SHCSR

// Before the end every fault gives the program a chance.
void board_on_fault(void) { board_print("switched off\n"); }

static int divide(volatile int zero) { return WORD_MAX / zero; }

int main(void) {
    char kind[WORD_MAX];
    if (board_argument(1, kind, sizeof kind) < 0) return 1;
    if (strcmp(kind, "bus") == 0) *nowhere = 1;
    if (strcmp(kind, "division") == 0) return divide(0);
    if (strcmp(kind, "undefined") == 0) __asm__ volatile("udf #0");
    if (strcmp(kind, "unexpected") == 0) __asm__ volatile("svc 0");
    if (strcmp(kind, "hard") == 0) {
        *fault_handlers = 0; // without a handler of its own a fault becomes a hard one
        __asm__ volatile("dsb\n udf #0");
    }
    if (strcmp(kind, "stack") == 0) {
        __asm__ volatile("msr msp, %0\n isb\n udf #0" ::"r"(nowhere));
    }
    if (strcmp(kind, "overrun") == 0) {
        board_tick_start(PERIOD);
        for (;;) continue;
    }
    return strcmp(kind, "none") == 0 ? 0 : 1;
}
