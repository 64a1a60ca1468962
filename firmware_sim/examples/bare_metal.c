// SPDX-License-Identifier: MIT
// libnck on bare metal: the main loop is the prep context, the SysTick interrupt the tick context.
//
//     bare_metal PROGRAM SETPOINTS     files, where a machine has a serial line and drives
//
// SETPOINTS gets nck_axes_t as it lies in memory, one for every period.
#include "board/board.h"
#include "nck/nck_memory.h" // nck_t

enum { CORE_HZ = 25000000, LOG_PERIODS = 200000, CHUNK_BYTES = 512 };

static nck_machine_t machine;
static nck_t nck;

// The program's text: what was read and not yet taken.
static struct {
    int file;
    size_t first, count;
    char text[CHUNK_BYTES];
} program;

// In place of the drives: a log, because a file would hold up the interrupt.
static nck_axes_t drives[LOG_PERIODS] __attribute__((section(".bulk")));

// Written by the interrupt, read by the main loop.
static volatile uint32_t periods;
static volatile uint32_t is_idle;
static volatile uint32_t is_late;

void SysTick_Handler(void);

void SysTick_Handler(void) {
    nck_pose_t pose;
    is_idle = nck_is_idle(&nck) != 0;
    if (is_idle || periods == LOG_PERIODS) return;
    const nck_tick_state_t state = nck_tick(&nck, &pose, &drives[periods]);
    periods = periods + 1;
    if (state == NCK_TICK_WAIT) nck_resume(&nck); // a machine waits for its operator here
    if (board_tick_is_due()) {
        board_tick_stop(); // the period is too short for this core: no setpoint comes in time
        is_late = 1;
    }
}

// Hand over what the kernel has room for. Text that it leaves is offered again.
static void feed(void) {
    size_t used = 0;
    if (program.first == program.count) {
        program.first = 0;
        program.count = board_read(program.file, program.text, sizeof program.text);
    }
    if (program.count == 0) {
        nck_end(&nck);
        return;
    }
    (void)nck_push(&nck, program.text + program.first, program.count - program.first, &used);
    program.first += used;
}

// Plan until the tick must go first, or nothing is left to plan. Returns nck_prep's last status.
static nck_status_t plan(void) {
    for (;;) {
        const nck_status_t status = nck_prep(&nck);
        if (status == NCK_EMPTY) feed();
        if (status == NCK_FULL || status == NCK_DONE) return status;
        if (status < NCK_OK) board_print("program error: what comes before it is executed\n");
    }
}

static void run(void) {
    (void)plan(); // a full look-ahead first, so that the path begins at full speed
    board_tick_start((uint32_t)(machine.period_s * (double)CORE_HZ + 0.5));
    while (plan() != NCK_DONE && !is_late) __asm__ volatile("wfi");
    is_idle = 0;
    while (!is_idle && !is_late && periods < LOG_PERIODS) __asm__ volatile("wfi");
    board_tick_stop();
}

int main(void) {
    char name[256];
    if (board_argument(1, name, sizeof name) < 0) return 2;
    program.file = board_open(name, BOARD_READ);
    if (board_argument(2, name, sizeof name) < 0) return 2;
    const int log = board_open(name, BOARD_WRITE);
    if (program.file < 0 || log < 0) return 2;
    if (nck_selftest() != NCK_SELFTEST) return 2; // arithmetic is not as it has to be
    nck_machine_default(&machine); // then change what differs
    machine.slope = NCK_SLOPE_LINEAR; // doubles are software on an M4F: jerk would starve there
    if (nck_init(&nck, &machine, NULL) != NCK_OK) return 2;
    run();
    const size_t size = periods * sizeof drives[0];
    const int is_whole = board_write(log, drives, size) == size && periods < LOG_PERIODS;
    if (is_late) return BOARD_EXIT_OVERRUN;
    return is_whole ? 0 : 1;
}
