// SPDX-License-Identifier: MIT
// In place of the pins: what is switched is written down at once, one record a change, in the file
// "outputs". Here is what the two boards have in common.
#ifndef HAL_SWITCHES_H
#define HAL_SWITCHES_H

#include "hal/hal.h" // hal_output_t

// One record of the file.
typedef struct hal_change {
    uint32_t output;   // hal_output_t
    int32_t value;
    uint32_t unfed;    // units since the watchdog was fed last; 0: it was not started yet
} hal_change_t;

// Of the board: write one record, at once. Cost: a halt for the host. Context: any.
void hal_write_change(const hal_change_t *change);

// Of the board: units since the watchdog was fed last. Cost: constant. Context: any.
uint32_t hal_unfed(void);

#endif
