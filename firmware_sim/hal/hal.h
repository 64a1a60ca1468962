// SPDX-License-Identifier: MIT
// What the firmware needs of the board besides the processor: four streams, the clock's rate and an
// end. host.c and board.c are the two of it; files of fixed names in the current folder.
#ifndef HAL_H
#define HAL_H

#include <stddef.h> // size_t
#include <stdint.h> // uint32_t

typedef enum hal_stream {
    HAL_JOB = 0,     // in, "job": what this run is to do
    HAL_PROGRAM = 1, // in, "program": NC text
    HAL_REPORT = 2,  // out, "report": what happened
    HAL_TRACE = 3,   // out, "trace": what the drives got, tick by tick
    HAL_STREAMS = 4
} hal_stream_t;

// Open the streams; those that go out are emptied. Returns 1, or 0 if one cannot be opened.
// Cost: constant. Context: before the tick runs.
int hal_init(void);

// Read up to n bytes. Returns how many; 0 at the end. Cost: linear in n. Context: any, one each
// stream.
size_t hal_read(hal_stream_t stream, void *data, size_t n);

// Write n bytes, 4096 at most; they are on their way when enough have come together, or at the end.
// Cost: linear in n, now and then a block of 4096. Context: any, one each stream.
void hal_write(hal_stream_t stream, const void *data, size_t n);

// Units of os_clock in a second. Cost: constant. Context: any.
uint32_t hal_clock_hz(void);

// Send what was written and end the run with a status, 0 … 99; 1 instead of 0 if something could
// not be written. Does not return. Cost: linear in what waits. Context: any.
void hal_exit(int status);

#endif
