// SPDX-License-Identifier: MIT
// The lines of a board on the host: sockets that somebody listens at. Whose other end is gone ends
// the program.
#define _POSIX_C_SOURCE 200809L
#include "uart.h"

#include <stdlib.h>     // exit
#include <string.h>     // strcpy
#include <sys/socket.h> // socket
#include <sys/un.h>     // sockaddr_un
#include <unistd.h>     // read write

static int lines[2];

int uart_begin(void) {
    static const char *const names[] = {"line", "clock"};
    for (int k = 0; k < 2; k++) {
        struct sockaddr_un at = {.sun_family = AF_UNIX};
        strcpy(at.sun_path, names[k]);
        lines[k] = socket(AF_UNIX, SOCK_STREAM, 0);
        if (connect(lines[k], (const struct sockaddr *)&at, sizeof at) != 0) return 0;
    }
    return 1;
}

uint8_t uart_get(uart_t uart) {
    uint8_t byte;
    if (read(lines[uart], &byte, 1) != 1) exit(0);
    return byte;
}

void uart_put(uart_t uart, const void *data, size_t n) {
    if (write(lines[uart], data, n) != (ssize_t)n) exit(1);
}
