// SPDX-License-Identifier: MIT
// What the firmware needs of the board besides the processor: four streams, the clock's rate, what
// is switched, a safe state, a watchdog and an end. host.c and board.c are the two of it; files of
// fixed names in the current folder.
#ifndef HAL_H
#define HAL_H

#include <stddef.h> // size_t
#include <stdint.h> // uint32_t

#include "hal/input.h" // hal_input_t

// Streams to and from the world outside.
typedef enum hal_stream {
    HAL_JOB = 0,     // in, "job": what this run is to do
    HAL_PROGRAM = 1, // in, "program": NC text
    HAL_REPORT = 2,  // out, "report": what happened
    HAL_TRACE = 3,   // out, "trace": what the drives got, tick by tick
    HAL_STREAMS = 4
} hal_stream_t;

// What the board switches, setpoints aside. All of it is off at reset.
typedef enum hal_output {
    HAL_DRIVES = 0,  // 1: power on the drives, brakes open
    HAL_SPINDLE = 1, // revolutions a minute, negative: backwards; 0: off
    HAL_COOLANT = 2, // 1: on
    HAL_OUTPUTS = 3
} hal_output_t;

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

// Switch an output; in the safe state it stays off. Cost: constant. Context: tick or task, each
// output from one of them.
void hal_switch(hal_output_t output, int32_t value);

// All inputs as they are now, one bit each: hal_input_t. Cost: constant. Context: tick, before
// nck_tick.
uint32_t hal_inputs(void);

// What an output is switched to. Cost: constant. Context: any.
int32_t hal_switched(hal_output_t output);

// The safe state: drives, spindle and coolant off at once, and off until reset. It needs no kernel,
// waits for nothing and may be called again. Cost: constant. Context: any, a fault's handler too.
void hal_make_safe(void);

// 1: in the safe state. Cost: constant. Context: any.
int hal_is_safe(void);

// Start the watchdog, once: if it is not fed for so many units of os_clock, the board goes to the
// safe state by itself, whatever the processor does. Cost: constant. Context: before os_start.
void hal_watchdog_start(uint32_t units);

// Feed it. Cost: constant. Context: tick.
void hal_watchdog_feed(void);

// Go to the safe state, send what was written and end the run with a status, 0 … 99; 1 instead of 0
// if something could not be written. Does not return. Cost: linear in what waits. Context: any.
void hal_exit(int status);

#endif
