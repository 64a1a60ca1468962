// SPDX-License-Identifier: MIT
// What the program waits for: the spindle's speed, and an input of M66.
#include "inputs/inputs.h"

enum { PORTS = 8, PER_KIND = 100, PER_ANALOGUE = 1000, NEVER_CAME = -1 };

static const double ticks_most = 4e9;

static uint32_t is_on(const inputs_t *self, uint32_t input) { return self->pins >> input & 1u; }

// M66 asks for a port: how it is now, or until when it is waited for.
static void ask(inputs_t *self, const nck_output_t *output) {
    const double ticks = output->value / nck_machine_of(self->nck)->period_s;
    const uint32_t port = output->number % PER_KIND;
    const uint32_t kind = output->number % PER_ANALOGUE / PER_KIND;
    const int known = output->number < PER_ANALOGUE && port < PORTS;
    self->wait.input = HAL_IN_PORT + port % PORTS;
    self->wait.most = ticks < ticks_most ? (uint32_t)ticks : (uint32_t)ticks_most;
    self->wait.answer = known ? (int32_t)is_on(self, self->wait.input) : 0;
    if (kind == 0) return;
    self->wait.kind = INPUTS_SPEED + kind;
    if (!known) self->wait.most = 0;
}

void inputs_output(inputs_t *self, const nck_output_t *output) {
    const double code = output->kind == NCK_OUTPUT_M ? output->value : 0.0;
    const int speed = output->kind == NCK_OUTPUT_SPINDLE_SPEED || code == 3.0 || code == 4.0;
    self->wait.ticks = 0;
    self->wait.kind = INPUTS_NOTHING;
    if (speed && nck_machine_of(self->nck)->spindle_waits) self->wait.kind = INPUTS_SPEED;
    if (output->kind == NCK_OUTPUT_INPUT) ask(self, output);
    nck_await(self->nck, self->wait.kind != INPUTS_NOTHING);
}

// What is waited for is there. An input that is to change has been the other way before.
static int has_come(inputs_t *self) {
    const uint32_t now = is_on(self, self->wait.input);
    switch (self->wait.kind) {
    case INPUTS_SPEED: return self->wait.ticks > self->set.debounce && !is_on(self, HAL_IN_SLOW);
    case INPUTS_RISES: if (!now) self->wait.kind = INPUTS_HIGH; return 0;
    case INPUTS_FALLS: if (now) self->wait.kind = INPUTS_LOW; return 0;
    default: return now == (self->wait.kind == INPUTS_HIGH);
    }
}

void inputs_wait(inputs_t *self) {
    const int comes = has_come(self);
    const int asks = self->wait.kind != INPUTS_SPEED;
    const int late = asks && self->wait.ticks >= self->wait.most;
    self->wait.ticks++;
    if (!comes && !late) return;
    if (asks) self->wait.answer = comes ? self->wait.kind == INPUTS_HIGH : NEVER_CAME;
    self->wait.kind = INPUTS_NOTHING;
    nck_await(self->nck, 0);
}
