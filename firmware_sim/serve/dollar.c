// SPDX-License-Identifier: MIT
// Lines that begin with $: settings, and what a sender asks for.
#include <string.h> // memcmp memset strlen

#include "serve/parts.h"

enum {
    MASK = 10, INCHES = 13, SOFT_LIMITS = 20, HOMING = 22, // settings that all axes share
    RATE = 110, ACCELERATION = 120, TRAVEL = 130,          // the first axis' of each kind
    KIND = 10, MASK_MOST = 3
};

void serve_say_setting(serve_t *self, uint32_t number, int32_t value, uint32_t places) {
    serve_say_two(self, "$#=", (int32_t)number, 0);
    serve_say_number(self, value, places);
    serve_say(self, "\r\n");
}

// What a setting of an axis is.
static double value_of(const nck_axis_t *axis, uint32_t kind, double counts) {
    if (kind == RATE) return axis->v_max * 60.0;
    if (kind == ACCELERATION) return axis->a_max;
    return ((double)axis->max_nm - (double)axis->min_nm) / counts;
}

static void say_axes(serve_t *self, uint32_t kind) {
    const nck_machine_t *const machine = nck_machine_of(self->nck);
    uint32_t number = kind;
    for (int axis = 0; axis < NCK_AXIS_MAX; axis++) {
        if (!machine->axis[axis].present) continue;
        const double counts = nck_machine_counts(machine, axis);
        const double value = value_of(&machine->axis[axis], kind, counts);
        serve_say_setting(self, number++, serve_round(value * 1e3), 3);
    }
}

static uint8_t say_settings(serve_t *self) {
    serve_say_setting(self, MASK, self->mask, 0);
    serve_say_setting(self, INCHES, self->inches, 0);
    serve_say_setting(self, SOFT_LIMITS, !nck_machine_of(self->nck)->roams, 0);
    if (!serve_beside(self, SERVE_AT_LIST, 0.0)) serve_say_setting(self, HOMING, 0, 0);
    for (uint32_t kind = RATE; kind <= TRAVEL; kind += KIND) say_axes(self, kind);
    return 0;
}

// The machine's axis that is the n-th of those it has, or −1.
static int axis_of(const nck_machine_t *machine, uint32_t n) {
    uint32_t left = n;
    for (int axis = 0; axis < NCK_AXIS_MAX; axis++) {
        if (machine->axis[axis].present && left-- == 0) return axis;
    }
    return -1;
}

static uint8_t set_axis(serve_t *self, uint32_t number, double value) {
    nck_machine_t machine = *nck_machine_of(self->nck);
    const int axis = axis_of(&machine, number % KIND);
    const uint32_t kind = number - number % KIND;
    if (axis < 0 || (kind != RATE && kind != ACCELERATION)) return SERVE_E_STATEMENT;
    if (!(value > 0.0)) return SERVE_E_NEGATIVE;
    if (kind == RATE) machine.axis[axis].v_max = machine.axis[axis].rapid = value / 60.0;
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
    switch (name.whole) {
    case INCHES: self->inches = value.whole != 0; return 0;
    case MASK: self->mask = (uint8_t)value.whole & MASK_MOST; return 0;
    case SOFT_LIMITS: return nck_heed_travel(self->nck, value.whole) ? SERVE_E_BUSY : 0;
    default: break;
    }
    const double number = value.whole + value.thousandths / 1e3;
    if (name.whole < RATE && serve_beside(self, SERVE_AT_SET + name.whole, number)) return 0;
    if (name.whole < RATE || name.whole >= TRAVEL) return SERVE_E_STATEMENT;
    return set_axis(self, name.whole, number);
}

// Behind its end nothing moves and nothing is checked: as behind a reset.
static uint8_t check(serve_t *self) {
    if (!self->checks && !serve_is_idle(self)) return SERVE_E_BUSY;
    self->checks = !self->checks;
    serve_say(self, self->checks ? "[MSG:Enabled]\r\n" : "[MSG:Disabled]\r\nok\r\n");
    if (!self->checks) serve_brake(self, SERVE_THEN_BANNER);
    return 0;
}

static uint8_t unlock(serve_t *self) {
    if (self->locked) serve_say(self, "[MSG:Caution: Unlocked]\r\n");
    self->locked = 0;
    return 0;
}

static uint8_t sleep(serve_t *self) {
    self->sleeps = 1;
    serve_say(self, "[MSG:Sleeping]\r\n");
    return 0;
}

static uint8_t restore(serve_t *self) {
    self->mask = MASK_MOST;
    self->inches = 0;
    serve_forget(self);
    serve_say(self, "[MSG:Restoring defaults]\r\n");
    return 0;
}

// Offsets are none, and the places of G28 and G30 the machine's zero.
static uint8_t erase(serve_t *self) {
    nck_modal_t modal;
    nck_modal(self->nck, &modal);
    memset(modal.systems_nm, 0, sizeof modal.systems_nm);
    memset(modal.home_nm, 0, sizeof modal.home_nm);
    memset(modal.g92_nm, 0, sizeof modal.g92_nm);
    if (nck_modal_set(self->nck, &modal) != NCK_OK) return SERVE_E_BUSY;
    return restore(self);
}

static uint8_t say_build(serve_t *self) {
    serve_say_two(self, "[VER:1.1f.nck:]\r\n[OPT:VNM,#,#]\r\n", NCK_SEG_MAX, SERVE_RING - 1);
    return 0;
}

static uint8_t say_lines(serve_t *self) {
    serve_say(self, "$N0=\r\n$N1=\r\n");
    return 0;
}

static uint8_t help(serve_t *self) {
    serve_say(self, "[HLP:$$ $# $G $I $N $x=val $J=line $SLP $C $X $H ~ ! ? ctrl-x]\r\n");
    return 0;
}

static uint8_t home(serve_t *self) {
    if (!self->beside) return SERVE_E_DISABLED;
    return (uint8_t)serve_beside(self, SERVE_AT_HOME, 0.0);
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
        {"RST=#", 1, erase}
    };
    const char *const name = self->text + 1;
    const int busy = !serve_is_idle(self) || self->held;
    for (uint32_t k = 0; k < sizeof commands / sizeof *commands; k++) {
        const command_t *const each = &commands[k];
        if (memcmp(name, each->name, strlen(each->name) + 1) != 0) continue;
        return each->rests && busy ? SERVE_E_BUSY : each->act(self);
    }
    return busy ? SERVE_E_BUSY : set(self);
}
