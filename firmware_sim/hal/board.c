// SPDX-License-Identifier: MIT
// The boards under QEMU: files of the host by semihosting, buffered, because each call halts the
// board; the watchdog is the board's own, which raises the exception that nothing can keep out.
#include "hal/hal.h"

#include <string.h> // memcpy

#include "board/board.h"  // board_open board_read board_write board_exit
#include "hal/switches.h" // hal_change_t

enum { BLOCK = 4096 };

static const struct {
    const char *name;
    board_mode_t mode;
} files[HAL_STREAMS] = {
    {"job", BOARD_READ}, {"program", BOARD_READ}, {"report", BOARD_WRITE}, {"trace", BOARD_WRITE}};

static struct {
    int file;
    uint32_t failed; // 1: something could not be written
    uint32_t used;   // bytes that wait
    uint8_t waiting[BLOCK];
} streams[HAL_STREAMS];

// CMSDK APB watchdog: Arm, Cortex-M System Design Kit Technical Reference Manual, 4.4.
typedef struct watchdog {
    uint32_t load;
    uint32_t value;     // counts down with the clock of SysTick
    uint32_t control;   // bit 0: counts and raises the exception
    uint32_t clear;     // a write clears the exception and loads the counter
    uint32_t is_raised; // bit 0
} watchdog_t;

static volatile watchdog_t *const watchdog = (volatile watchdog_t *)0x40008000u;
static int outputs_file = -1;

int hal_init(void) {
    outputs_file = board_open("outputs", BOARD_WRITE);
    if (outputs_file < 0) return 0;
    for (int k = 0; k < HAL_STREAMS; k++) {
        streams[k].file = board_open(files[k].name, files[k].mode);
        if (streams[k].file < 0) return 0;
    }
    return 1;
}

size_t hal_read(hal_stream_t stream, void *data, size_t n) {
    return board_read(streams[stream].file, data, n);
}

static void flush(hal_stream_t stream) {
    const size_t n = streams[stream].used;
    if (n == 0) return;
    if (board_write(streams[stream].file, streams[stream].waiting, n) != n) {
        streams[stream].failed = 1;
    }
    streams[stream].used = 0;
}

void hal_write(hal_stream_t stream, const void *data, size_t n) {
    if (n > BLOCK) {
        streams[stream].failed = 1;
        return;
    }
    if (streams[stream].used + n > BLOCK) flush(stream);
    memcpy(streams[stream].waiting + streams[stream].used, data, n);
    streams[stream].used += (uint32_t)n;
}

uint32_t hal_clock_hz(void) { return 25000000; }

void hal_write_change(const hal_change_t *change) {
    (void)board_write(outputs_file, change, sizeof *change);
}

void hal_watchdog_start(uint32_t units) {
    watchdog->load = units;
    watchdog->control = 1;
}

void hal_watchdog_feed(void) { watchdog->clear = 1; }

// It has begun anew when the exception is there.
uint32_t hal_unfed(void) {
    if (watchdog->control == 0) return 0;
    const uint32_t since = watchdog->load - watchdog->value;
    return (watchdog->is_raised & 1u) != 0 ? since + watchdog->load : since;
}

// Every exception that is a fault: whoever was at work is not to be relied on.
void board_on_fault(void) { hal_make_safe(); }

void NMI_Handler(void);

// In the safe state there is nothing left for the watchdog to do.
void NMI_Handler(void) {
    const int barked = (watchdog->is_raised & 1u) != 0;
    if (barked && hal_is_safe()) {
        watchdog->clear = 1;
        return;
    }
    hal_make_safe();
    board_exit(barked ? BOARD_EXIT_WATCHDOG : BOARD_EXIT_NMI);
}

uint32_t hal_inputs(void) { return 0; } // nothing is wired

void hal_exit(int status) {
    hal_make_safe();
    flush(HAL_REPORT);
    flush(HAL_TRACE);
    const int failed = streams[HAL_REPORT].failed || streams[HAL_TRACE].failed;
    for (int k = 0; k < HAL_STREAMS; k++) board_close(streams[k].file);
    board_exit(status == 0 && failed ? 1 : status);
}
