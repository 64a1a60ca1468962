// SPDX-License-Identifier: MIT
// Lines that begin with $: settings, and what a sender asks for.
#include <string.h> // memcmp memset strlen

#include "serve/parts.h"

enum {
    MASK = 10, INCHES = 13, SOFT_LIMITS = 20, HOMING = 22, // settings that all axes share
    RATE = 110, ACCELERATION = 120, TRAVEL = 130,          // the first axis' of each kind
    KIND = 10, MASK_MOST = 3
};

// The machine's axis that is the n-th of those it has, or −1.
static int axis_of(const nck_machine_t *machine, uint32_t n) {
    uint32_t left = n;
    for (int axis = 0; axis < NCK_AXIS_MAX; axis++) {
        if (machine->axis[axis].present && left-- == 0) return axis;
    }
    return -1;
}

// What a setting of an axis is.
static double value_of(const nck_machine_t *machine, int axis, uint32_t kind) {
    const nck_axis_t *const each = &machine->axis[axis];
    if (kind == RATE) return each->v_max * 60.0;
    if (kind == ACCELERATION) return each->a_max;
    return ((double)each->max_nm - (double)each->min_nm) / nck_machine_counts(machine, axis);
}

static uint8_t say_settings(serve_t *self) {
    const nck_machine_t *const machine = nck_machine_of(self->nck);
    serve_say_setting(self, MASK, self->mask);
    serve_say_setting(self, INCHES, self->inches);
    serve_say_setting(self, SOFT_LIMITS, !machine->roams);
    if (!serve_beside(self, SERVE_AT_LIST)) serve_say_setting(self, HOMING, 0);
    for (uint32_t number = RATE; number < TRAVEL + KIND; number++) {
        const uint32_t n = number % KIND;
        const int axis = axis_of(machine, n);
        if (axis < 0) continue;
        serve_say_measure(self, (int32_t)number, value_of(machine, axis, number - n));
    }
    return 0;
}

static uint8_t set_axis(serve_t *self, uint32_t number) {
    nck_machine_t machine = *nck_machine_of(self->nck);
    const int axis = axis_of(&machine, number % KIND);
    const double value = self->set;
    if (axis < 0 || number >= TRAVEL) return SERVE_E_STATEMENT;
    if (!(value > 0.0)) return SERVE_E_NEGATIVE;
    if (number < ACCELERATION) machine.axis[axis].v_max = machine.axis[axis].rapid = value / 60.0;
    else machine.axis[axis].a_max = value;
    return nck_set_limits(self->nck, &machine) == NCK_OK ? 0 : SERVE_E_STATEMENT;
}

static uint8_t set(serve_t *self) {
    const char *at = self->text + 1;
    serve_number_t name, value;
    if (!serve_number(&at, &name) || *at++ != '=') return SERVE_E_STATEMENT;
    if (!serve_number(&at, &value) || *at != '\0') return SERVE_E_STATEMENT;
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
    serve_say(self, self->checks ? "[MSG:Enabled]\n" : "[MSG:Disabled]\nok\n");
    if (!self->checks) serve_brake(self, SERVE_THEN_BANNER);
    return 0;
}

static uint8_t unlock(serve_t *self) {
    if (!self->locked) return 0;
    if (serve_beside(self, SERVE_AT_RESUME)) return SERVE_E_DOOR;
    serve_say(self, "[MSG:Caution: Unlocked]\n");
    self->locked = 0;
    return 0;
}

static uint8_t sleep(serve_t *self) {
    self->sleeps = 1;
    serve_say(self, "[MSG:Sleeping]\n");
    return 0;
}

// $RST=# has offsets none, and the places of G28 and G30 the machine's zero; $RST=$ settings,
// $RST=* both.
static uint8_t restore(serve_t *self) {
    enum { WHAT = 5 };
    const char what = self->text[WHAT];
    nck_modal_t modal;
    nck_modal(self->nck, &modal);
    memset(modal.systems_nm, 0, sizeof modal.systems_nm);
    memset(modal.home_nm, 0, sizeof modal.home_nm);
    memset(modal.g92_nm, 0, sizeof modal.g92_nm);
    if (what != '$' && nck_modal_set(self->nck, &modal) != NCK_OK) return SERVE_E_BUSY;
    if (what != '#') {
        self->mask = MASK_MOST;
        self->inches = 0;
    }
    serve_forget(self);
    serve_say(self, "[MSG:Restoring defaults]\n");
    return 0;
}

static uint8_t say_build(serve_t *self) {
    static const int32_t sizes[] = {NCK_SEG_MAX, SERVE_RING - 1};
    serve_say_form(self, "[VER:1.1f.nck:]\n[OPT:VNM,@,@]\n", sizes);
    return 0;
}

static uint8_t say_lines(serve_t *self) {
    serve_say(self, "$N0=\n$N1=\n");
    return 0;
}

static uint8_t help(serve_t *self) {
    serve_say(self, "[HLP:$$ $# $G $I $N $x=val $J=line $SLP $C $X $H ~ ! ? ctrl-x]\n");
    return 0;
}

static uint8_t home(serve_t *self) {
    if (!self->beside) return SERVE_E_DISABLED;
    if (serve_beside(self, SERVE_AT_RESUME)) return SERVE_E_DOOR;
    return (uint8_t)serve_beside(self, SERVE_AT_HOME);
}

typedef struct command {
    char name[6]; // behind the $
    uint8_t rests; // 1: at rest alone
    uint8_t (*act)(serve_t *self);
} command_t;

uint8_t serve_command(serve_t *self) {
    static const command_t commands[] = {
        {"", 0, help}, {"G", 0, serve_say_modes}, {"C", 0, check}, {"X", 0, unlock},
        {"$", 1, say_settings}, {"#", 1, serve_say_offsets}, {"I", 1, say_build},
        {"N", 1, say_lines}, {"H", 1, home}, {"SLP", 1, sleep}, {"RST=$", 1, restore},
        {"RST=#", 1, restore}, {"RST=*", 1, restore}
    };
    const char *const name = self->text + 1;
    const int busy = !self->idle || self->held;
    for (uint32_t k = 0; k < sizeof commands / sizeof *commands; k++) {
        const command_t *const each = &commands[k];
        if (memcmp(name, each->name, strlen(each->name) + 1) != 0) continue;
        return each->rests && busy ? SERVE_E_BUSY : each->act(self);
    }
    return busy ? SERVE_E_BUSY : set(self);
}
