// SPDX-License-Identifier: MIT
// The boards under QEMU: files of the host by semihosting, buffered, because each call halts the
// board.
#include "hal/hal.h"

#include <string.h> // memcpy

#include "board/board.h" // board_open board_read board_write board_exit

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

int hal_init(void) {
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

void hal_exit(int status) {
    flush(HAL_REPORT);
    flush(HAL_TRACE);
    const int failed = streams[HAL_REPORT].failed || streams[HAL_TRACE].failed;
    for (int k = 0; k < HAL_STREAMS; k++) board_close(streams[k].file);
    board_exit(status == 0 && failed ? 1 : status);
}
