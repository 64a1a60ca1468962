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
    SERVE_RESUME = 5, SERVE_MODES = 6, SERVE_FLOOD = 7, SERVE_MIST = 8,
    SERVE_OVERRIDE = 9 // and above: 0x90 …
} serve_signal_t;

// A number as it is written.
typedef struct serve_number {
    uint32_t whole, thousandths; // of its size
    uint32_t negative;
} serve_number_t;

// words.c: a number at *at, which moves behind it. Returns 0 if there is none. Cost: linear.
int serve_number(const char **at, serve_number_t *out);

// dollar.c: a line that begins with $, but for a jog's. Returns 0, or its error.
uint8_t serve_command(serve_t *self);

// report.c: say a text, in which \n ends a line; the same, whose @ stand for whole numbers, and %
// for those in thousandths; begin the next report anew.
void serve_say(serve_t *self, const char *text);
void serve_say_form(serve_t *self, const char *form, const int32_t *values);
void serve_forget(serve_t *self);

// report.c: the letters whose bits are set, from the lowest on; a text before them, if any is.
void serve_say_letters(serve_t *self, const char *before, const char *letters, uint32_t bits);

// report.c: the modes at the tool, as 0x83 asks for them.
void serve_say_executed(serve_t *self);

// report.c: the whole status; modes; the parameters of $#. The last two return 0.
void serve_say_status(serve_t *self);
uint8_t serve_say_modes(serve_t *self);
uint8_t serve_say_offsets(serve_t *self);

// report.c: where the axes are, counted from a zero, or from the machine's where that is NULL;
// without a place, the zero.
void serve_say_axes(serve_t *self, const char *before, const double *at, const int64_t *zero_nm);

// report.c: lines of $$, of whole numbers and of others.
void serve_say_setting(serve_t *self, int32_t number, int32_t value);
void serve_say_measure(serve_t *self, int32_t number, double value);

// serve.c: the line in work is over. Hold as by !, or by a door. Cost: constant.
void serve_answer(serve_t *self);
void serve_hold(serve_t *self, int door);

// serve.c: ask who knows the switches. Cost: that of the answer.
int serve_beside(serve_t *self, uint32_t event);

// serve.c: what the last tick has left. Cost: constant.
const serve_seen_t *serve_seen(const serve_t *self);

// serve.c: come to rest, drop the rest, then do that. Cost: constant.
void serve_brake(serve_t *self, serve_then_t then);

#endif
