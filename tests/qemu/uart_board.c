// SPDX-License-Identifier: MIT
// The CMSDK APB UARTs of the boards, asked in a loop: Arm, Cortex-M System Design Kit Technical
// Reference Manual, 4.3.
#include "uart.h"

typedef struct registers {
    uint32_t data;
    uint32_t state;   // bit 0: no byte may be written, bit 1: one has come
    uint32_t control; // bit 0: sends, bit 1: receives
    // cppcheck-suppress unusedStructMember
    uint32_t interrupts;
    uint32_t divider; // clocks a bit
} registers_t;

static volatile registers_t *of(uart_t uart) {
    return (volatile registers_t *)(uart == UART_LINE ? 0x40004000u : 0x40005000u);
}

int uart_begin(void) {
    for (uart_t uart = UART_LINE; uart <= UART_CLOCK; uart++) {
        of(uart)->divider = 16;
        of(uart)->control = 3;
    }
    return 1;
}

uint8_t uart_get(uart_t uart) {
    while ((of(uart)->state & 2u) == 0) continue;
    return (uint8_t)of(uart)->data;
}

void uart_put(uart_t uart, const void *data, size_t n) {
    const uint8_t *const bytes = data;
    for (size_t k = 0; k < n; k++) {
        while ((of(uart)->state & 1u) != 0) continue;
        of(uart)->data = bytes[k];
    }
}
