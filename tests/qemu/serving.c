// SPDX-License-Identifier: MIT
// A machine that speaks grbl's protocol over a board's first UART. Time passes when the second one
// says so, so that a session on the board is to the tick what it is on the host:
//
//     r N       N bytes come on the first UART; answered by how many were taken
//     t N0…N3   so many periods pass; answered by a byte
//     w         what was said goes to the first UART; answered by how many bytes, four of them
//     s         answered by a `state_t`
//     + -       somebody connects, or is gone
//     p BIT ON  an input is pushed or let go
//
// serving MACHINE [INPUTS WIRES]: files of an nck_machine_t, an inputs_set_t and a
// host_switches_t's beginning, as they stand in memory. It ends with the emulator.
#include <string.h> // memcpy

#include "board/board.h" // files, arguments
#include "host_serve.h"  // host_serve_t
#include "nck/nck_tools.h" // nck_invariants
#include "uart.h"        // uart_get uart_put

enum { STEPS = 64, NAME_MAX = 200, BYTE_MOST = 255, BLOCK = 4096 }; // STEPS as Session has them

typedef struct state {
    int64_t joint_nm[3];
    uint64_t moving, hash;
    double v_most;
    uint32_t broken, waiting;
} state_t;

static nck_t nck;
static nck_machine_t machine;
static host_serve_t host;

static void receive(void) {
    char bytes[BYTE_MOST];
    const uint8_t n = uart_get(UART_CLOCK);
    for (uint32_t k = 0; k < n; k++) bytes[k] = (char)uart_get(UART_LINE);
    const uint8_t used = (uint8_t)host_serve_receive(&host, bytes, n);
    uart_put(UART_CLOCK, &used, 1);
}

static void let_pass(void) {
    uint32_t ticks = 0;
    for (uint32_t k = 0; k < 4; k++) ticks |= (uint32_t)uart_get(UART_CLOCK) << 8 * k;
    host_serve_run(&host, ticks, STEPS);
    uart_put(UART_CLOCK, "t", 1);
}

static void say(void) {
    static char bytes[BLOCK];
    const uint32_t n = (uint32_t)host_serve_take(&host, bytes, sizeof bytes);
    uart_put(UART_LINE, bytes, n);
    uart_put(UART_CLOCK, &n, sizeof n);
}

static void tell(void) {
    state_t state = {.moving = host.moving, .hash = host.hash, .v_most = host.v_most,
                     .broken = nck_invariants(&nck), .waiting = host.in_head - host.in_tail};
    memcpy(state.joint_nm, host.axes.joint_nm, sizeof state.joint_nm);
    uart_put(UART_CLOCK, &state, sizeof state);
}

static void push(void) {
    const uint32_t bit = 1u << uart_get(UART_CLOCK);
    host.switches.pushed &= ~bit;
    if (uart_get(UART_CLOCK) != 0) host.switches.pushed |= bit;
}

static void obey(uint8_t command) {
    switch (command) {
    case 'r': receive(); break;
    case 't': let_pass(); break;
    case 'w': say(); break;
    case 's': tell(); break;
    case '+': serve_join(&host.serve); break;
    case '-': host_serve_part(&host); break;
    default: push(); break;
    }
}

static int load(int argument, void *data, size_t n) {
    char name[NAME_MAX];
    if (board_argument(argument, name, sizeof name) < 0) return 0;
    const int file = board_open(name, BOARD_READ);
    return file >= 0 && board_read(file, data, n) == n;
}

int main(void) {
    if (!uart_begin()) return 1;
    if (!load(1, &machine, sizeof machine)) return 1;
    if (host_serve_init(&host, &nck, &machine) != NCK_OK) return 1;
    if (load(2, &host.inputs.set, sizeof host.inputs.set)) {
        if (!load(3, &host.switches, offsetof(host_switches_t, seed))) return 1;
        host_serve_connect(&host);
    }
    for (;;) obey(uart_get(UART_CLOCK));
}
