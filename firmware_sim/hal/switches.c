// SPDX-License-Identifier: MIT
// Outputs and the latch behind them. A machine has the latch in hardware: a line that takes the
// power away, whatever the pins say.
#include "hal/switches.h"

static volatile int32_t values[HAL_OUTPUTS];
static volatile uint32_t latched; // 1: the safe state

static void put(hal_output_t output, int32_t value) {
    if (values[output] == value) return;
    values[output] = value;
    const hal_change_t change = {(uint32_t)output, value, hal_unfed()};
    hal_write_change(&change);
}

// The latch is looked at behind the pin: a handler may have come between.
void hal_switch(hal_output_t output, int32_t value) {
    if (latched) return;
    put(output, value);
    if (latched) put(output, 0);
}

int32_t hal_switched(hal_output_t output) { return values[output]; }

int hal_is_safe(void) { return latched != 0; }

void hal_make_safe(void) {
    latched = 1;
    for (int k = 0; k < HAL_OUTPUTS; k++) put((hal_output_t)k, 0);
}
