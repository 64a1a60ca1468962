// SPDX-License-Identifier: MIT
// Lines that begin with $: settings, and what a sender asks for.
#include <stddef.h> // offsetof
#include <string.h> // memset

#include "serve/parts.h"

enum {
    MASK = 10, INCHES = 13, SOFT_LIMITS = 20, HOMING = 22, // settings that all axes share
    RATE = 110, ACCELERATION = 120, TRAVEL = 130,          // the first axis' of each kind
    KIND = 10, MASK_MOST = 3
};

// What a setting of an axis is: a kind's first number and the axis, of those that the machine has.
static double value_of(const nck_machine_t *machine, int axis, uint32_t kind) {
    const nck_axis_t *const each = &machine->axis[axis];
    if (kind == RATE) return each->v_max * 60.0;
    if (kind == ACCELERATION) return each->a_max;
    return serve_measure(machine, axis, each->max_nm) - serve_measure(machine, axis, each->min_nm);
}

static void say_settings(serve_t *self) {
    const nck_machine_t *const machine = nck_machine_of(self->nck);
    serve_say_setting(self, MASK, self->mask);
    serve_say_setting(self, INCHES, self->inches);
    serve_say_setting(self, SOFT_LIMITS, !machine->roams);
    if (!serve_beside(self, SERVE_AT_LIST)) serve_say_setting(self, HOMING, 0);
    for (uint32_t kind = RATE; kind <= TRAVEL; kind += KIND) {
        uint32_t number = kind;
        for (int axis = 0; axis < NCK_AXIS_MAX; axis++) {
            if (!machine->axis[axis].present) continue;
            serve_say_measure(self, (int32_t)number++, value_of(machine, axis, kind));
        }
    }
}

static uint8_t set_axis(serve_t *self, uint32_t number) {
    nck_machine_t machine = *nck_machine_of(self->nck);
    const double value = self->set;
    uint32_t left = number % KIND;
    nck_axis_t *axis = machine.axis;
    for (; axis < machine.axis + NCK_AXIS_MAX; axis++) {
        if (axis->present && left-- == 0) break;
    }
    if (axis == machine.axis + NCK_AXIS_MAX || number >= TRAVEL) return SERVE_E_STATEMENT;
    if (!(value > 0.0)) return SERVE_E_NEGATIVE;
    if (number < ACCELERATION) axis->v_max = axis->rapid = value / 60.0;
    else axis->a_max = value;
    return nck_set_limits(self->nck, &machine) == NCK_OK ? 0 : SERVE_E_STATEMENT;
}

static uint8_t set(serve_t *self) {
    serve_number_t name, value;
    const char *const equals = serve_number(self->text + 1, &name);
    const char *const end = serve_number(equals + 1, &value);
    if (!name.said || *equals != '=' || !value.said || *end != '\0') return SERVE_E_STATEMENT;
    if (value.negative) return SERVE_E_NEGATIVE;
    serve_forget(self);
    self->set = value.whole + value.thousandths / 1e3;
    switch (name.whole) {
    case INCHES: self->inches = value.whole != 0; return 0;
    case MASK: self->mask = (uint8_t)value.whole & MASK_MOST; return 0;
    case SOFT_LIMITS: return nck_heed_travel(self->nck, value.whole) ? SERVE_E_BUSY : 0;
    default: break;
    }
    if (name.whole >= RATE) return set_axis(self, name.whole);
    return serve_beside(self, SERVE_AT_SET + name.whole) ? 0 : SERVE_E_STATEMENT;
}

// Behind its end nothing moves and nothing is checked: as behind a reset.
static uint8_t check(serve_t *self) {
    if (!self->checks && !self->idle) return SERVE_E_BUSY;
    self->checks = !self->checks;
    serve_say(self, SERVE_SAY_CHECKS + !self->checks);
    if (!self->checks) serve_brake(self, SERVE_THEN_BANNER);
    return 0;
}

// $X and $H wait for a door that is open.
static uint8_t free_axes(serve_t *self, int homes) {
    if (!homes && !self->locked) return 0;
    if (serve_beside(self, SERVE_AT_RESUME)) return SERVE_E_DOOR;
    if (homes) return self->beside ? (uint8_t)self->beside(self, SERVE_AT_HOME) : SERVE_E_DISABLED;
    serve_say(self, SERVE_SAY_UNLOCKED);
    self->locked = 0;
    return 0;
}

// $RST=# has offsets none, and the places of G28 and G30 the machine's zero; $RST=$ settings,
// $RST=* both.
static uint8_t restore(serve_t *self, char what) {
    enum { SYSTEMS = offsetof(nck_modal_t, systems_nm) };
    nck_modal_t modal;
    if (what != '$' && what != '#' && what != '*') return SERVE_E_STATEMENT;
    nck_modal(self->nck, &modal);
    memset((char *)&modal + SYSTEMS, 0, sizeof modal - SYSTEMS); // G28 and G30 are behind them
    memset(modal.g92_nm, 0, sizeof modal.g92_nm);
    if (what != '$' && nck_modal_set(self->nck, &modal) != NCK_OK) return SERVE_E_BUSY;
    if (what != '#') {
        self->mask = MASK_MOST;
        self->inches = 0;
    }
    serve_forget(self);
    serve_say(self, SERVE_SAY_RESTORED);
    return 0;
}

// Commands that say a text.
static void say(serve_t *self, serve_command_t command) {
    static const int32_t sizes[] = {NCK_SEG_MAX, SERVE_RING - 1};
    serve_say_form(self, SERVE_SAY_HELP + (uint32_t)command - SERVE_DOLLAR_HELP, sizes);
}

// Returns its error, or 0.
static uint8_t obey(serve_t *self, serve_command_t command, char what) {
    switch (command) {
    case SERVE_DOLLAR_MODES: serve_say_modes(self, 0); break;
    case SERVE_DOLLAR_CHECK: return check(self);
    case SERVE_DOLLAR_UNLOCK:
    case SERVE_DOLLAR_HOME: return free_axes(self, command == SERVE_DOLLAR_HOME);
    case SERVE_DOLLAR_SETTINGS: say_settings(self); break;
    case SERVE_DOLLAR_OFFSETS: serve_say_offsets(self); break;
    case SERVE_DOLLAR_RESTORE: return restore(self, what);
    case SERVE_DOLLAR_SETS: return set(self);
    case SERVE_DOLLAR_SLEEP:
        self->sleeps = 1;
        self->phase = SERVE_OWNS; // M5, M9
        say(self, command);
        break;
    default: say(self, command);
    }
    return 0;
}

void serve_command(serve_t *self) {
    const char *const name = self->text + 1;
    const serve_command_t command = serve_command_of(name);
    const int needs_rest = command >= SERVE_DOLLAR_SETTINGS && command != SERVE_DOLLAR_HELP;
    const int busy = needs_rest && (!self->idle || self->held);
    self->line.error = busy ? SERVE_E_BUSY : obey(self, command, name[SERVE_RESTORE]);
}
