// SPDX-License-Identifier: MIT
// The protocol's inner doors. Context of all: prep.
#ifndef SERVE_PARTS_H
#define SERVE_PARTS_H

#include "serve/serve.h" // serve_t

// Numbers of grbl's errors.
typedef enum serve_error {
    SERVE_E_STATEMENT = 3, SERVE_E_NEGATIVE = 4, SERVE_E_DISABLED = 5, SERVE_E_BUSY = 8,
    SERVE_E_LOCKED = 9, SERVE_E_LENGTH = 11, SERVE_E_DOOR = 13, SERVE_E_TRAVEL = 15,
    SERVE_E_JOG = 16, SERVE_E_CODE = 20, SERVE_E_FEED = 22
} serve_error_t;

// Whatever the kernel finds wrong is one of them. Cost: constant.
uint8_t serve_error_of(int32_t status);

// words.c: what a line is that is no command: its N word, whether it settles or ends. Cost: linear
// in the line.
void serve_look(serve_t *self);

// words.c: the same of a jog's words, behind the =; makes a line of them. Returns 0 or its error.
uint8_t serve_look_jog(serve_t *self);

// Of a line that probes: it is M66.
enum { SERVE_ASKS = 66 };

// Real-time bytes; those that stop come first.
typedef enum serve_signal {
    SERVE_HOLD = 0, SERVE_DOOR = 1, SERVE_CANCEL = 2, SERVE_RESET = 3, SERVE_REPORT = 4,
    SERVE_RESUME = 5, SERVE_MODES = 6, SERVE_MIST = 7, SERVE_FLOOD = 8,
    SERVE_OVERRIDE = 9 // and above: 0x90 …
} serve_signal_t;

// A number as it is written.
typedef struct serve_number {
    uint32_t whole, thousandths; // of its size
    uint32_t negative;
    uint32_t said;               // 0: there is no digit
} serve_number_t;

// words.c: the number at a place. Returns the place behind it. Cost: linear.
const char *serve_number(const char *at, serve_number_t *out);

// What is behind the $. Those of one letter, or none, stand first; those from SETTINGS on need
// rest, but for HELP.
typedef enum serve_command {
    SERVE_DOLLAR_MODES, SERVE_DOLLAR_CHECK, SERVE_DOLLAR_UNLOCK, SERVE_DOLLAR_SETTINGS,
    SERVE_DOLLAR_OFFSETS, SERVE_DOLLAR_HOME, SERVE_DOLLAR_HELP, SERVE_DOLLAR_BUILD,
    SERVE_DOLLAR_LINES, SERVE_DOLLAR_SLEEP, SERVE_DOLLAR_RESTORE, SERVE_DOLLAR_SETS
} serve_command_t;

enum { SERVE_RESTORE = 4 }; // RST=

// words.c: which one it is. Cost: linear.
serve_command_t serve_command_of(const char *name);

// words.c: a length or angle [mm, deg]. Cost: constant.
double serve_measure(const nck_machine_t *machine, int axis, int64_t nm);

// dollar.c: a line that begins with $, but for a jog's; its error is the line's.
void serve_command(serve_t *self);

// What is said, by its place in the table of report.c. There @ is a whole number, % one in
// thousandths, \n ends a line.
typedef enum serve_text {
    SERVE_SAY_OK, SERVE_SAY_BANNER, SERVE_SAY_ENDED, SERVE_SAY_ERROR, SERVE_SAY_ALARM,
    SERVE_SAY_LOCKED, SERVE_SAY_UNLOCKED, SERVE_SAY_CHECKS, SERVE_SAY_CHECKS_NOT,
    SERVE_SAY_RESTORED, SERVE_SAY_HELP, SERVE_SAY_BUILD, SERVE_SAY_LINES, SERVE_SAY_SLEEPS,
    SERVE_SAY_SETTING, SERVE_SAY_MEASURE,
    SERVE_SAY_STATES, // and ten more
    SERVE_SAY_BEGIN = SERVE_SAY_STATES + 11,
    SERVE_SAY_PLACE, SERVE_SAY_MACHINE_PLACE, SERVE_SAY_ROOM, SERVE_SAY_LINE, SERVE_SAY_SPEED,
    SERVE_SAY_ZERO, SERVE_SAY_OVERRIDES, SERVE_SAY_ACCESSORIES, SERVE_SAY_ACCESSORY_LETTERS,
    SERVE_SAY_END, SERVE_SAY_PINS, SERVE_SAY_PIN_LETTERS, SERVE_SAY_COMMA, SERVE_SAY_MODES,
    SERVE_SAY_TENTH, SERVE_SAY_MORE_MODES, SERVE_SAY_MIST, SERVE_SAY_FLOOD, SERVE_SAY_DRY,
    SERVE_SAY_LAST_MODES, SERVE_SAY_SYSTEM, SERVE_SAY_COLON, SERVE_SAY_CLOSE, SERVE_SAY_LENGTH,
    SERVE_SAY_PROBE, SERVE_SAY_MISSED, SERVE_SAY_TOUCHED
} serve_text_t;

// report.c: say a text; one with numbers; begin the next report anew.
void serve_say(serve_t *self, uint32_t text);
void serve_say_form(serve_t *self, uint32_t text, const int32_t *values);
static inline void serve_forget(serve_t *self) { self->wco_in = self->ov_in = 0; }

// report.c: the letters whose bits are set, those of the text behind before, from the lowest on;
// before them that, if any is.
void serve_say_letters(serve_t *self, uint32_t before, uint32_t bits);

// report.c: the whole status; modes, or (1) those at the tool; the parameters of $#.
void serve_say_status(serve_t *self);
void serve_say_modes(serve_t *self, int at_tool);
void serve_say_offsets(serve_t *self);

// report.c: where the axes are, counted from a zero, or from the machine's where that is NULL;
// without a place, the zero.
void serve_say_axes(serve_t *self, uint32_t before, const double *at, const int64_t *zero_nm);

// report.c: lines of $$, of whole numbers and of others.
void serve_say_setting(serve_t *self, int32_t number, int32_t value);
void serve_say_measure(serve_t *self, int32_t number, double value);

// serve.c: the line in work is over. Hold as by !, or by a door. Cost: constant.
void serve_answer(serve_t *self);
void serve_hold(serve_t *self, int door);

// serve.c: the overrides in force. Cost: constant.
void serve_override(serve_t *self);

// serve.c: ask who knows the switches. Cost: that of the answer.
int serve_beside(serve_t *self, uint32_t event);

// serve.c: what the last tick has left. Cost: constant.
const serve_seen_t *serve_seen(const serve_t *self);

// serve.c: come to rest, drop the rest, then do that. Cost: constant.
void serve_brake(serve_t *self, serve_then_t then);

#endif
