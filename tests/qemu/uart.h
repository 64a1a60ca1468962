// SPDX-License-Identifier: MIT
// Two serial lines: on a board its UARTs, on the host the sockets `line` and `clock`.
#ifndef UART_H
#define UART_H

#include <stddef.h> // size_t
#include <stdint.h> // uint8_t

typedef enum uart { UART_LINE = 0, UART_CLOCK = 1 } uart_t;

// Open both. Returns 1, or 0 if there are none.
int uart_begin(void);

// Wait for a byte.
uint8_t uart_get(uart_t uart);

// Send bytes.
void uart_put(uart_t uart, const void *data, size_t n);

#endif
