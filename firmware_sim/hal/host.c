// SPDX-License-Identifier: MIT
// The board of the native build: files of the C library, and the clock of the boards under QEMU.
#include "hal/hal.h"

#include <stdio.h>  // fopen fread fwrite
#include <stdlib.h> // exit

static const struct {
    const char *name, *mode;
} files[HAL_STREAMS] = {{"job", "rb"}, {"program", "rb"}, {"report", "wb"}, {"trace", "wb"}};

static FILE *open_files[HAL_STREAMS];

int hal_init(void) {
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

void hal_exit(int status) {
    int failed = 0;
    for (int k = 0; k < HAL_STREAMS; k++) {
        if (!open_files[k]) continue;
        failed |= ferror(open_files[k]) != 0;
        failed |= fclose(open_files[k]) != 0;
    }
    exit(status == 0 && failed ? 1 : status);
}
