// SPDX-License-Identifier: MIT
// A part for firmware_sim/moving on a PC, in virtual time: it counts edges of the step lines, and
// its home switches close where a motor is. Its UART is standard input and output: the next line
// comes when the one before is answered. Arguments: periods until the spindle has its speed, and
// steps from where each motor stands at first to its switch.
#include <stdio.h>
#include <stdlib.h>

#include "hal/input.h"
#include "moving/moving.h"
#include "serve/serve.h"

enum { MOTORS = 3, STEPS_OF_PREP = 40, QUIET = 300, LONG = 2000000 };

int part_main(void);
nck_status_t __real_serve_step(serve_t *self);
nck_status_t __wrap_serve_step(serve_t *self);

static long slow_until, home_at;
static long period, quiet, moved; // moved: the first period with a step
static long steps[MOTORS];
static uint32_t lines_high;
static int waits;                 // for an answer
static char last[2];              // bytes that were sent: o k, or r r of an error
static uint32_t done;             // calls of this period

void part_begin(void) {}
void part_drives(uint32_t on) {
    if (!on) fprintf(stderr, "drives off in period %ld\n", period);
}

void part_step(uint32_t directions, uint32_t high) {
    const uint32_t rise = high & ~lines_high;
    for (uint32_t k = 0; k < MOTORS; k++) {
        if ((rise >> k & 1u) != 0) steps[k] += (directions >> k & 1u) != 0 ? 1 : -1;
    }
    if (rise != 0 && moved == 0) moved = period;
    if (rise != 0) quiet = 0;
    lines_high = high;
}

uint32_t part_inputs(void) {
    uint32_t pins = 0;
    for (uint32_t k = 0; k < MOTORS; k++) {
        const uint32_t closed = steps[k] >= home_at;
        pins |= closed << (HAL_IN_HOME + k) | closed << (HAL_IN_LIMIT + k);
    }
    return pins | (uint32_t)(period < slow_until) << HAL_IN_SLOW;
}

void part_send(uint8_t byte) {
    putchar(byte);
    if ((last[0] == 'o' && byte == 'k') || (last[0] == 'r' && last[1] == 'r')) waits = 0;
    last[0] = last[1] == 'r' && byte == 'r' ? 'r' : (char)byte;
    last[1] = (char)byte;
}

static void listen(void) {
    int byte;
    while (!waits && (byte = getchar()) != EOF) {
        moving_receive((uint8_t)byte);
        waits = byte == '\n';
        quiet = 0;
    }
}

// When all is said and nothing has moved for a while, it ends, and tells where the motors are.
static void pass(void) {
    const uint32_t fast = MOVING_FAST_HZ / MOVING_PERIOD_HZ;
    for (uint32_t k = 0; k < fast; k++) moving_fast();
    moving_period();
    listen();
    period++;
    const int lasts = waits || ++quiet < QUIET || period < slow_until + QUIET;
    if (lasts && period < LONG) return;
    printf("\nsteps %ld %ld %ld, first in period %ld\n", steps[0], steps[1], steps[2], moved);
    exit(waits);
}

nck_status_t __wrap_serve_step(serve_t *self) {
    const nck_status_t status = __real_serve_step(self);
    if (status == NCK_OK && ++done < STEPS_OF_PREP) return status;
    done = 0;
    pass();
    return status;
}

int main(int argc, char **argv) {
    if (argc != 3) return 2;
    slow_until = atol(argv[1]);
    home_at = atol(argv[2]);
    return part_main();
}
