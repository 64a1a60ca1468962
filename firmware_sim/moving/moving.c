// SPDX-License-Identifier: MIT
// The kernel, the protocol, switches and pulses, joined. Change the numbers in machine().
#include "moving/moving.h"

#include "inputs/inputs.h"
#include "nck/nck_memory.h" // nck_t
#include "pulse/pulse.h"
#include "serve/serve.h"

enum { MOTORS = 3 };

static nck_t nck;
static nck_decode_t room;
static nck_machine_t mill;
static serve_t serve;
static inputs_t inputs;
static pulse_t pulse;
static pulse_set_t motors;

static void machine(pulse_set_t *set) {
    nck_machine_default(&mill);
    mill.slope = NCK_SLOPE_JERK;
    mill.dialect.base = NCK_DIALECT_GRBL;
    mill.dialect.probe = NCK_PROBE_MISSES; // a session asks the probe
    mill.spindle_waits = 1; // M3, M4 and another S rest until HAL_IN_SLOW reads 0
    mill.period_s = 1.0 / MOVING_PERIOD_HZ;
    set->period_s = mill.period_s;
    set->interrupts = MOVING_FAST_HZ / MOVING_PERIOD_HZ;
    set->pulse_s = 2e-6;
    set->setup_s = 5e-6;
    set->motors = MOTORS;
    for (uint8_t k = 0; k < MOTORS; k++) {
        mill.axis[k].min_nm = 0;
        mill.axis[k].max_nm = 200000000; // [nm]
        mill.axis[k].v_max = mill.axis[k].rapid = 50.0;
        mill.axis[k].a_max = 300.0;
        mill.axis[k].j_max = 3000.0;
        set->motor[k].joint = k;
        set->motor[k].steps = 200.0;
        set->motor[k].counts = 1e6;
    }
}

// What the program switches: the protocol tells it, and the path waits for the spindle.
static void output(void *user, const nck_output_t *what) {
    serve_output(user, what);
    inputs_output(&inputs, what);
}

static void write(void *user, const char *bytes, uint32_t n) {
    (void)user;
    for (uint32_t k = 0; k < n; k++) part_send((uint8_t)bytes[k]);
}

void moving_fast(void) {
    const uint32_t high = pulse_interrupt(&pulse);
    part_step(pulse.directions, high);
}

void moving_period(void) {
    nck_pose_t pose;
    nck_axes_t axes;
    if (inputs_tick(&inputs, part_inputs()) || pulse.fast) part_drives(0);
    (void)nck_tick(&nck, &pose, &axes);
    (void)pulse_period(&pulse, &axes, nck_places(&nck));
    serve_tick(&serve, &pose);
}

void moving_receive(uint8_t byte) { serve_receive(&serve, byte); }

int main(void) {
    const nck_hooks_t hooks = {&serve, output, NULL, NULL};
    const serve_port_t port = {NULL, write};
    nck_pose_t pose;
    nck_axes_t axes;
    if (nck_selftest() != NCK_SELFTEST) return 1;
    machine(&motors);
    if (nck_init(&nck, &mill, &hooks) != NCK_OK) return 1;
    (void)nck_position(&nck, &pose, &axes);
    if (!pulse_init(&pulse, &motors, &axes, nck_places(&nck))) return 1;
    inputs_init(&inputs, &nck);
    inputs.set.homes = inputs.set.limits = 1;
    (void)serve_init(&serve, &nck, &room, &port);
    serve_switches(&serve, &inputs);
    part_begin();
    part_drives(1);
    for (;;) (void)serve_step(&serve);
}
