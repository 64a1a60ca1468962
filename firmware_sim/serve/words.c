// SPDX-License-Identifier: MIT
// What a line is, as far as it matters before the kernel reads it; and the kernel's errors as
// grbl's.
#include <stddef.h> // NULL
#include <string.h> // memchr memcmp memcpy memmove

#include "serve/parts.h"

enum { TENTHS = 10, WHOLE_MOST = 99999999, PROBES = 38, NO_POINT = 2 };

static const char jog_prefix[] = "G1G94"; // in place of $J=

const char *serve_number(const char *at, serve_number_t *out) {
    const char *from = at;
    uint32_t unit = NO_POINT; // of the last digit behind the point; 0: too small
    out->whole = out->thousandths = out->said = 0;
    out->negative = *from == '-';
    if (*from == '-' || *from == '+') from++;
    for (;; from++) {
        const uint32_t digit = (uint32_t)(unsigned char)*from - '0';
        if (digit > 9) {
            if (*from != '.' || unit != NO_POINT) break;
            unit = 1000;
            continue;
        }
        out->said = 1;
        if (unit != NO_POINT) out->thousandths += digit * (unit /= 10);
        else out->whole = out->whole < WHOLE_MOST ? out->whole * 10 + digit : WHOLE_MOST;
    }
    return from;
}

double serve_measure(const nck_machine_t *machine, int axis, int64_t nm) {
    return (double)nm / nck_machine_counts(machine, axis);
}

// What codes from the least on, so many tenths more, do; those of M are 2000 more.
typedef struct row {
    uint16_t least;
    uint8_t more;
    uint8_t does; // serve_does_t
} row_t;

static const row_t rows[] = {
    {0, 39, SERVE_HAS_AXES}, {800, 99, SERVE_HAS_AXES}, {40, 0, SERVE_LATE},
    {100, 9, SERVE_LATE | SERVE_SHIFTS | SERVE_HAS_AXES}, {200, 10, SERVE_JOGS},
    {280, 0, SERVE_HAS_AXES}, {281, 0, SERVE_LATE | SERVE_HAS_AXES},
    {300, 0, SERVE_HAS_AXES}, {301, 0, SERVE_LATE | SERVE_HAS_AXES}, {430, 0, SERVE_SHIFTS},
    {431, 0, SERVE_SHIFTS | SERVE_HAS_AXES}, {490, 0, SERVE_SHIFTS},
    {520, 0, SERVE_SHIFTS | SERVE_HAS_AXES}, {530, 0, SERVE_JOGS}, {540, 53, SERVE_SHIFTS},
    {900, 0, SERVE_JOGS}, {910, 0, SERVE_JOGS}, {920, 3, SERVE_SHIFTS | SERVE_HAS_AXES},
    {2000, 10, SERVE_LATE}, {2020, 0, SERVE_ENDS}, {2060, 0, SERVE_LATE}, {2300, 0, SERVE_ENDS},
    {2600, 0, SERVE_LATE}
};

// What is found in a line.
enum { AXES = 1, FEED = 2, ODD = 4 }; // ODD: no jog has it

// A code; it may be one that jogs have.
static uint32_t look_at_code(serve_t *self, uint32_t code) {
    enum { M66 = 2660, PROBE = 382, PROBE_LAST = 385, PROBES_LESS = 380 };
    uint32_t does = 0;
    for (uint32_t k = 0; k < sizeof rows / sizeof *rows; k++) {
        if (code - rows[k].least <= rows[k].more) does |= rows[k].does;
    }
    self->line.does |= (uint8_t)does;
    if (code == M66) self->line.probes = SERVE_ASKS;
    if (code >= PROBE && code <= PROBE_LAST) {
        self->line.probes = (uint8_t)(code - PROBES_LESS);
    }
    return does & SERVE_JOGS ? 0 : ODD;
}

static uint32_t look_at_word(serve_t *self, char letter, const serve_number_t *number) {
    enum { M = 2000 };
    const uint32_t tenths = number->whole * TENTHS + number->thousandths / 100;
    if (letter == 'F') return FEED;
    if (letter == 'N') {
        self->line.name = number->whole;
        return 0;
    }
    if (letter != 'G' && letter != 'M') return ODD;
    return look_at_code(self, letter == 'M' ? tenths + M : tenths);
}

// A B C, U … Z.
static uint32_t is_axis(char letter) {
    const uint32_t n = (uint32_t)letter - 'A';
    return n < 26 ? 0x3f00007u >> n & 1u : 0;
}

static uint32_t look(serve_t *self, const char *from) {
    uint32_t found = 0;
    const char *at = from;
    while (*at != '\0') {
        serve_number_t number;
        const char letter = *at++;
        const uint32_t axis = is_axis(letter); // the first bit is AXES
        at = serve_number(at, &number);
        found |= axis;
        if (!number.said) found |= ODD;
        else if (!axis) found |= look_at_word(self, letter, &number);
    }
    return found;
}

// Axes alone probe where the line before has.
static int probes_on(const serve_t *self) {
    nck_modal_t modal;
    nck_modal(self->nck, &modal);
    return modal.motion == PROBES;
}

void serve_look(serve_t *self) {
    const uint32_t found = look(self, self->text);
    const int goes = (found & AXES) && !(self->line.does & SERVE_HAS_AXES);
    if (goes && !self->line.probes && self->probe && probes_on(self)) {
        self->line.probes = self->probe;
    }
    if (self->line.probes) self->line.does |= SERVE_LATE;
}

uint8_t serve_look_jog(serve_t *self) {
    enum { BEFORE = 3, PREFIX = sizeof jog_prefix - 1 };
    char *const text = self->text;
    const uint32_t found = look(self, text + BEFORE);
    if ((found & (ODD | AXES)) != AXES) return SERVE_E_JOG;
    if (!(found & FEED)) return SERVE_E_FEED;
    memmove(text + PREFIX, text + BEFORE, self->line.size - BEFORE);
    memcpy(text, jog_prefix, PREFIX);
    self->line.size += PREFIX - BEFORE;
    return 0;
}

serve_command_t serve_command_of(const char *name) {
    static const char letters[] = {'G', 'C', 'X', '$', '#', 'H', '\0', 'I', 'N'};
    const char *const at = memchr(letters, *name, sizeof letters);
    if (at != NULL && (*name == '\0' || name[1] == '\0')) return (serve_command_t)(at - letters);
    if (memcmp(name, "SLP", sizeof "SLP") == 0) return SERVE_DOLLAR_SLEEP;
    if (memcmp(name, "RST=", SERVE_RESTORE) != 0) return SERVE_DOLLAR_SETS;
    return name[SERVE_RESTORE + 1] == '\0' ? SERVE_DOLLAR_RESTORE : SERVE_DOLLAR_SETS;
}

uint8_t serve_error_of(int32_t status) {
    static const int8_t found[] = {
        NCK_E_CHARACTER, NCK_E_NUMBER, NCK_E_NUMBER_RANGE, NCK_E_LINE_LENGTH, NCK_E_WORD_TWICE,
        NCK_E_WORD_UNUSED, NCK_E_WORD_MISSING, NCK_E_MODAL_GROUP, NCK_E_FEED_MISSING,
        NCK_E_ARC_RADIUS, NCK_E_ARC_CENTRE, NCK_E_ARC_CHORD, NCK_E_ARC_MODE, NCK_E_TRAVEL,
        NCK_E_TOOL_UNKNOWN, NCK_E_NO_MOTION, NCK_E_WORD_SHARED, NCK_E_INCREMENTAL
    };
    static const uint8_t errors[] = {1, 2, 2, 11, 25, 36, 28, 21, 22, 34, 35, 34, 34,
                                     SERVE_E_TRAVEL, 38, 31, 24, 30};
    const int8_t *const at = memchr(found, (uint8_t)status, sizeof found);
    return at != NULL ? errors[at - found] : SERVE_E_CODE;
}
