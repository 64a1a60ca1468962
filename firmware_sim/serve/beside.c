// SPDX-License-Identifier: MIT
// The machine's switches in the protocol: homing, probing, limits, the door. A session that has
// none does not link this file.
#include <stddef.h> // NULL
#include <string.h> // memcpy

#include "inputs/inputs.h"
#include "nck/base/fence.h" // nck_fence_load nck_fence_store
#include "serve/parts.h"

// Numbers of grbl's alarms; the last two are grblHAL's.
typedef enum alarm {
    ALARM_LIMIT = 1, ALARM_PROBE_BEFORE = 4, ALARM_PROBE_MISSED = 5, ALARM_BROKEN_OFF = 6,
    ALARM_STUCK = 8, ALARM_NO_SWITCH = 9, ALARM_EMERGENCY = 10, ALARM_RACKED = 15
} alarm_t;

enum {
    LIMITS_ON = 21, HOMING_ON = 22, HOMING_SIDES = 23, FEED = 24, SEEK = 25, DEBOUNCE = 26,
    PULL_OFF = 27, // settings
    PROBE_MUST = 1 // bit 0 of n in G38.n: it need not meet anything
};

static uint32_t is_on(const inputs_t *inputs, uint32_t input) {
    return nck_fence_load(&inputs->pins) >> input & 1u;
}

static void alarm(serve_t *self, alarm_t code) {
    const int32_t number = (int32_t)code;
    if (self->locked != code) serve_say_form(self, SERVE_SAY_ALARM, &number);
    self->locked = (uint8_t)code;
}

// ---- probing

static uint8_t waits_open(const serve_t *self) { return self->line.probes >= 4; }

static int begin_probe(serve_t *self) {
    inputs_t *const inputs = self->inputs;
    const uint32_t probe = 1u << HAL_IN_PROBE;
    if (!self->idle) {
        nck_flush(self->nck);
        return 0;
    }
    if (self->line.probes == SERVE_ASKS) return 1;
    if (is_on(inputs, HAL_IN_PROBE) != waits_open(self)) {
        alarm(self, ALARM_PROBE_BEFORE);
        serve_answer(self);
        return 0;
    }
    inputs->halt.periods = 0;
    inputs_watch(inputs, waits_open(self) ? 0 : probe, waits_open(self) ? probe : 0);
    return 1;
}

static int say_probe(serve_t *self) {
    const inputs_t *const inputs = self->inputs;
    const int found = inputs->probed != 0;
    serve_say_axes(self, SERVE_SAY_PROBE, inputs->probe_at, NULL);
    serve_say(self, SERVE_SAY_MISSED + (uint32_t)found);
    return 1;
}

static void end_probe(serve_t *self) {
    inputs_t *const inputs = self->inputs;
    if (self->line.probes == SERVE_ASKS) {
        (void)nck_answered(self->nck, inputs->wait.answer);
        return;
    }
    const int found = inputs->halt.periods > 0;
    self->probe = self->line.probes;
    inputs->probed = (uint32_t)found;
    memcpy(inputs->probe_at, found ? inputs->halt.at : serve_seen(self)->pose.axis,
           sizeof inputs->probe_at);
    inputs_watch(inputs, 0, 0);
    (void)nck_probed(self->nck, found ? &inputs->halt : NULL);
    (void)say_probe(self);
    if (!found && (self->line.probes & PROBE_MUST) == 0) alarm(self, ALARM_PROBE_MISSED);
}

// ---- homing

static int begin_home(serve_t *self) {
    inputs_t *const inputs = self->inputs;
    if (!inputs->set.homes) return SERVE_E_DISABLED;
    if (inputs_home(inputs) != NCK_OK) return SERVE_E_STATEMENT;
    nck_set_override(self->nck, 100 * NCK_PERCENT, 100 * NCK_PERCENT);
    self->phase = SERVE_HOMES;
    return 0;
}

static void go_home(serve_t *self) {
    const inputs_result_t result = inputs_step(self->inputs, self->idle);
    if (result == INPUTS_GOES) return;
    static const uint8_t alarms[] = {[INPUTS_STUCK] = ALARM_STUCK,
                                     [INPUTS_MISSED] = ALARM_NO_SWITCH,
                                     [INPUTS_RACKED] = ALARM_RACKED};
    if (result == INPUTS_DONE) self->locked = 0;
    else alarm(self, (alarm_t)alarms[result]);
    serve_override(self);
    serve_answer(self);
}

static void break_off(serve_t *self) {
    inputs_give_up(self->inputs);
    alarm(self, ALARM_BROKEN_OFF);
}

// ---- in every step

// The axes have been stopped by an input.
static void heed_stop(serve_t *self) {
    inputs_t *const inputs = self->inputs;
    const uint32_t probe = 1u << HAL_IN_PROBE;
    const int probes = self->line.probes != 0 && (inputs->tripped & ~probe) == 0;
    const int emergency = (inputs->tripped >> HAL_IN_EMERGENCY & 1u) != 0;
    if (!probes) alarm(self, emergency ? ALARM_EMERGENCY : ALARM_LIMIT);
    if (nck_fence_load(&inputs->halt.periods) == 0 || inputs_go_on(inputs) != NCK_OK) return;
    self->flushed = 1;
    if (probes) return;
    self->held = self->door = self->jogging = 0;
    self->line.error = SERVE_E_LOCKED;
    if (self->phase == SERVE_OWNS) return;
    if (self->phase != SERVE_READS) serve_answer(self);
    self->line.own = 1;
    self->phase = SERVE_OWNS; // M5, M9
}

static void heed_door(serve_t *self) {
    if (!is_on(self->inputs, HAL_IN_DOOR) || self->door) return;
    if (self->phase == SERVE_BRAKES) return;
    serve_hold(self, 1);
}

// Limits are heeded again once all switches have opened, and do not bounce.
static void rearm(serve_t *self) {
    inputs_t *const inputs = self->inputs;
    const uint32_t limits = (1u << NCK_AXIS_MAX) - 1;
    if (self->phase != SERVE_READS || (nck_fence_load(&inputs->pins) & limits) != 0) return;
    if (nck_fence_load(&inputs->steady) >= inputs->set.debounce) inputs_watch(inputs, 0, 0);
}

static int step(serve_t *self) {
    inputs_t *const inputs = self->inputs;
    if (is_on(inputs, HAL_IN_EMERGENCY)) {
        alarm(self, ALARM_EMERGENCY);
        nck_fence_store(&self->tick.turns, 0); // nothing is executed that would switch them
        nck_fence_store(&self->tick.coolant, 0);
        if (self->phase == SERVE_HOMES) {
            inputs_give_up(inputs);
            self->line.error = SERVE_E_LOCKED;
            serve_answer(self);
        }
    }
    heed_door(self);
    if (self->phase == SERVE_HOMES) {
        go_home(self);
        return 1;
    }
    if (nck_fence_load(&inputs->tripped) != 0 && self->phase != SERVE_BRAKES) {
        heed_stop(self);
        return 1;
    }
    rearm(self);
    return 0;
}

// ---- what is said and set

static int say_pins(serve_t *self) {
    enum { AXES = (1u << NCK_AXIS_MAX) - 1u, DOOR = 10, EMERGENCY = 11 };
    const inputs_t *const inputs = self->inputs;
    const uint32_t pins = nck_fence_load(&inputs->pins);
    const uint32_t axes = (pins >> HAL_IN_LIMIT | pins >> HAL_IN_HOME) & AXES;
    serve_say_letters(self, SERVE_SAY_PINS,
                      is_on(inputs, HAL_IN_PROBE) | axes << 1 | is_on(inputs, HAL_IN_DOOR) << DOOR
                          | is_on(inputs, HAL_IN_EMERGENCY) << EMERGENCY);
    return 0;
}

static int list(serve_t *self) {
    const inputs_set_t *const set = &self->inputs->set;
    serve_say_setting(self, LIMITS_ON, (int32_t)set->limits);
    serve_say_setting(self, HOMING_ON, (int32_t)set->homes);
    serve_say_setting(self, HOMING_SIDES, (int32_t)set->reverse);
    serve_say_measure(self, FEED, set->feed);
    serve_say_measure(self, SEEK, set->seek);
    serve_say_setting(self, DEBOUNCE, (int32_t)set->debounce);
    serve_say_measure(self, PULL_OFF, set->pull_off);
    return 1;
}

// Speeds and ways must be more than nothing.
static int change(serve_t *self, uint32_t number, double value) {
    inputs_set_t *const set = &self->inputs->set;
    const uint32_t whole = value < 1e6 ? (uint32_t)value : 0;
    const int positive = value > 0.0;
    switch (number) {
    case LIMITS_ON: set->limits = whole != 0; return 1;
    case HOMING_ON: set->homes = whole != 0; return 1;
    case HOMING_SIDES: set->reverse = whole; return 1;
    case FEED: if (positive) set->feed = value; return positive;
    case SEEK: if (positive) set->seek = value; return positive;
    case DEBOUNCE: set->debounce = whole; return 1;
    case PULL_OFF: if (positive) set->pull_off = value; return positive;
    default: return 0;
    }
}

static int beside(serve_t *self, uint32_t event) {
    switch (event) {
    case SERVE_AT_STEP: return step(self);
    case SERVE_AT_PROBE: return begin_probe(self);
    case SERVE_AT_PROBED: end_probe(self); return 0;
    case SERVE_AT_HOME: return begin_home(self);
    case SERVE_AT_BREAK: break_off(self); return 0;
    case SERVE_AT_RESUME: return (int)is_on(self->inputs, HAL_IN_DOOR);
    case SERVE_AT_STATUS: return say_pins(self);
    case SERVE_AT_OFFSETS: return say_probe(self);
    case SERVE_AT_LIST: return list(self);
    default: return change(self, event - SERVE_AT_SET, self->set);
    }
}

void serve_switches(serve_t *self, inputs_t *inputs) {
    self->inputs = inputs;
    self->beside = beside;
    inputs_watch(inputs, 0, 0);
    if (!inputs->set.homes) return;
    self->locked = SERVE_NOT_HOMED;
    serve_say(self, SERVE_SAY_LOCKED);
}
