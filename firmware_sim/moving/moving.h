// SPDX-License-Identifier: MIT
// A stepper machine behind a UART: what is the same on every part. docs/moving.md.
#ifndef MOVING_H
#define MOVING_H

#include <stdint.h> // uint32_t

#define MOVING_FAST_HZ 100000u // fast interrupts a second: half as many steps at most
#define MOVING_PERIOD_HZ 1000u // setpoints a second

// Of the part. Pins: bit m is motor m; inputs as in hal/input.h. Cost: constant.
void part_begin(void);                                // clocks, pins, UART, interrupts
void part_step(uint32_t directions, uint32_t high);   // write the lines, directions first
uint32_t part_inputs(void);
void part_drives(uint32_t on);
void part_send(uint8_t byte);                         // waits until there is room

// Called by the part: once a fast interrupt; once a period, at a lower priority; with each byte of
// the UART, at the lowest. Context: these interrupts.
void moving_fast(void);
void moving_period(void);
void moving_receive(uint8_t byte);

#endif
