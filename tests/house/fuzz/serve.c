// SPDX-License-Identifier: MIT
// Fuzz target of the byte door: whatever is sent, invariants hold, no axis is too fast, what is
// said are lines of text, and behind a reset the machine answers as ever.
//
//     slope, switches │ bytes that are sent; FE n: so many ticks, FD b: inputs, FC: the cable
#include "host_serve.h"
#include "nck/nck_tools.h" // nck_t nck_invariants

#include <math.h>   // isfinite
#include <stdlib.h> // abort
#include <string.h> // memcmp memset strlen

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

enum {
    TICKS = 0xfe, INPUTS = 0xfd, CABLE = 0xfc,
    STEPS = 24,          // of prep between two ticks
    SAID_MOST = 200000,
    TICKS_MOST = 4000,   // of an input
    REST_MOST = 60000    // ticks until a reset is over, and a line is answered
};

static nck_t nck;
static host_serve_t host;
static char said[SAID_MOST];
static size_t count;

// What is checked by abort has a name in the trace.
static void require(int condition) {
    if (!condition) abort();
}

static void listen(void) {
    if (count > SAID_MOST / 2) count = 0;
    const size_t from = count;
    count += host_serve_take(&host, said + count, SAID_MOST - count);
    for (size_t k = from; k < count; k++) {
        const char c = said[k];
        require(c == '\r' || c == '\n' || (c >= ' ' && c <= '~'));
    }
}

static void let_pass(uint32_t ticks) {
    host_serve_run(&host, ticks, STEPS);
    listen();
    require(nck_invariants(&nck) == 0);
    require(isfinite(host.v_most) && host.v_most <= 1.0 + 1e-6);
    require(host.out_lost == 0 && host.serve.line.size <= SERVE_LINE_MAX + 1);
}

static int ends_with(const char *text) {
    const size_t n = strlen(text);
    return count >= n && memcmp(said + count - n, text, n) == 0;
}

static void ask(const char *bytes, const char *answer) {
    count = 0;
    (void)host_serve_receive(&host, bytes, strlen(bytes));
    for (uint32_t k = 0; k < REST_MOST && !ends_with(answer); k += 20) let_pass(20);
    require(ends_with(answer));
}

static void begin(uint8_t kind) {
    nck_machine_t machine;
    nck_machine_default(&machine);
    machine.slope = kind & 1u;
    machine.dialect.base = NCK_DIALECT_GRBL;
    for (int x = 0; x < 3; x++) {
        machine.axis[x].min_nm = -50000000;
        machine.axis[x].max_nm = 50000000;
    }
    require(host_serve_init(&host, &nck, &machine) == NCK_OK);
    count = 0;
    if (!(kind & 2u)) return;
    host.inputs.set.homes = kind >> 2 & 1u;
    host.inputs.set.limits = kind >> 3 & 1u;
    host.inputs.set.reverse = kind >> 4 & 7u;
    host.inputs.set.seek = 3000.0;
    host.inputs.set.feed = 100.0;
    host.switches.wired = 7;
    host.switches.least = kind >> 4 & 7u;
    host.switches.bounce = kind >> 7;
    for (int x = 0; x < 3; x++) {
        host.switches.place_nm[x] = (host.switches.least >> x & 1u) ? -49000000 : 49000000;
    }
    host.switches.plate_nm = -5000000;
    host_serve_connect(&host);
}

// One byte, or an order. Returns how many bytes it took.
static size_t operate(const uint8_t *data, size_t size) {
    const uint8_t next = size > 1 ? data[1] : 0;
    switch (data[0]) {
    case TICKS: let_pass(next); return 2;
    case INPUTS: host.switches.pushed = (uint32_t)next << HAL_IN_PROBE; return 2;
    case CABLE:
        host_serve_part(&host);
        serve_join(&host.serve);
        return 1;
    default: (void)host_serve_receive(&host, (const char *)data, 1); return 1;
    }
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    size_t used = 1;
    if (size == 0) return 0;
    begin(data[0]);
    while (used < size && host.ticks < TICKS_MOST) used += operate(data + used, size - used);
    let_pass(50);
    host.switches.pushed = 0;
    host.inputs.set.limits = 0;
    let_pass(60);
    ask("\x18", "Grbl 1.1f ['$' for help]\r\n");
    let_pass(60);
    ask("$X\n", "ok\r\n");
    ask("$20=0\n", "ok\r\n");
    ask("G21G91G94G1X0.125F900\n", "ok\r\n");
    return 0;
}
