// SPDX-License-Identifier: MIT
// The board of the native build: files of the C library, the clock of the boards under QEMU, and
// their exit statuses after a fault. Time is virtual: that the watchdog was not fed in time is
// noticed when it is fed the next time, and counts from when it was due.
#include "hal/hal.h"

#include <signal.h> // signal
#include <stdio.h>  // fopen fread fwrite
#include <stdlib.h> // exit _Exit

#include "board/board.h"  // BOARD_EXIT_…
#include "hal/switches.h" // hal_change_t
#include "os/port.h"      // os_port_clock

static const struct {
    const char *name, *mode;
} files[HAL_STREAMS] = {{"job", "rb"}, {"program", "rb"}, {"report", "wb"}, {"trace", "wb"}};

static FILE *open_files[HAL_STREAMS];

static FILE *outputs_file;
static uint64_t fed;             // the clock when the watchdog was fed last
static uint32_t watchdog_units;  // 0: it was not started

// What a processor's exceptions are here.
static const struct {
    int number, status;
} faults[] = {{SIGSEGV, BOARD_EXIT_MEM_FAULT},
              {SIGILL, BOARD_EXIT_USAGE_FAULT},
              {SIGFPE, BOARD_EXIT_USAGE_FAULT},
              {SIGABRT, BOARD_EXIT_HARD_FAULT}};

static void end_in_fault(int number) {
    int status = BOARD_EXIT_UNEXPECTED;
    for (size_t k = 0; k < sizeof faults / sizeof faults[0]; k++) {
        if (faults[k].number == number) status = faults[k].status;
    }
    hal_make_safe();
    _Exit(status);
}

static void take_faults(void) {
    for (size_t k = 0; k < sizeof faults / sizeof faults[0]; k++) {
        (void)signal(faults[k].number, end_in_fault);
    }
}

int hal_init(void) {
    outputs_file = fopen("outputs", "wb");
    if (!outputs_file) return 0;
    (void)setvbuf(outputs_file, NULL, _IONBF, 0);
    take_faults();
    for (int k = 0; k < HAL_STREAMS; k++) {
        open_files[k] = fopen(files[k].name, files[k].mode);
        if (!open_files[k]) return 0;
    }
    return 1;
}

size_t hal_read(hal_stream_t stream, void *data, size_t n) {
    return fread(data, 1, n, open_files[stream]);
}

void hal_write(hal_stream_t stream, const void *data, size_t n) {
    (void)fwrite(data, 1, n, open_files[stream]); // a failure stays in ferror until the end
}

uint32_t hal_clock_hz(void) { return 25000000; }

void hal_write_change(const hal_change_t *change) {
    (void)fwrite(change, sizeof *change, 1, outputs_file);
}

void hal_watchdog_start(uint32_t units) { watchdog_units = units; }

uint32_t hal_unfed(void) {
    const uint64_t since = os_port_clock() - fed;
    if (watchdog_units == 0) return 0;
    return since < watchdog_units ? (uint32_t)since : watchdog_units;
}

void hal_watchdog_feed(void) {
    const int barked = watchdog_units > 0 && hal_unfed() == watchdog_units;
    if (barked && !hal_is_safe()) {
        hal_make_safe();
        _Exit(BOARD_EXIT_WATCHDOG);
    }
    fed = os_port_clock();
}

uint32_t hal_inputs(void) { return 0; } // nothing is wired

void hal_exit(int status) {
    hal_make_safe();
    int failed = 0;
    for (int k = 0; k < HAL_STREAMS; k++) {
        if (!open_files[k]) continue;
        failed |= ferror(open_files[k]) != 0;
        failed |= fclose(open_files[k]) != 0;
    }
    exit(status == 0 && failed ? 1 : status);
}
