// SPDX-License-Identifier: MIT
// Three motors at up to 201 kHz that turn round now and then. Exit status: 0 if they have counted
// where the setpoints lead.
#include "mark.h"
#include "pulse/pulse.h"

enum { MOTORS = 3, INTERRUPTS = 410, PERIODS = 400, TURN = 50 };

static pulse_t pulse;

static int counted[MOTORS];

static void count_edges(uint32_t high) {
    for (uint32_t m = 0; m < MOTORS; m++) {
        if (high >> m & 1u) counted[m] += (pulse.directions >> m & 1u) ? 1 : -1;
    }
}

int main(void) {
    static const int fastest[MOTORS] = {201000, 150000, 7};
    pulse_set_t set = {.period_s = 1e-3, .pulse_s = 2e-6, .setup_s = 5e-6,
                       .interrupts = INTERRUPTS, .motors = MOTORS};
    nck_axes_t axes = {{0}};
    for (uint8_t m = 0; m < MOTORS; m++) {
        set.motor[m] = (pulse_motor_set_t){.steps = 1000.0, .counts = 1e6, .joint = m};
    }
    if (!pulse_init(&pulse, &set, &axes, 1)) return 1;
    for (int n = 0; n < PERIODS; n++) {
        const int way = n % TURN == 0 ? 0 : n / TURN % 2 == 0 ? 1 : -1;
        for (int m = 0; m < MOTORS; m++) axes.joint_nm[m] += way * fastest[m];
        mark_prep_begin();
        const int fits = pulse_period(&pulse, &axes, 1);
        mark_prep_end();
        if (!fits) return 1;
        for (int k = 0; k < INTERRUPTS; k++) {
            mark_tick_begin();
            const uint32_t high = pulse_interrupt(&pulse);
            mark_tick_end();
            count_edges(high);
        }
    }
    return counted[0] == 0 && counted[1] == 0 && counted[2] == 0 ? 0 : 2;
}
