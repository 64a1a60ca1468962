// SPDX-License-Identifier: MIT
// What a line is, as far as it matters before the kernel reads it; and the kernel's errors as
// grbl's.
#include <string.h> // memcpy memmove memset

#include "serve/parts.h"

enum { TENTHS = 10, WHOLE_MOST = 99999999, PROBES = 38 };

static const char jog_prefix[] = "G1G94"; // in place of $J=

int serve_number(const char **at, serve_number_t *out) {
    const char *from = *at;
    uint32_t unit = 0; // of the next digit behind the point, 0: none was there
    int digits = 0;
    memset(out, 0, sizeof *out);
    out->negative = *from == '-';
    if (*from == '-' || *from == '+') from++;
    for (;; from++) {
        const uint32_t digit = (uint32_t)(unsigned char)*from - '0';
        if (digit > 9) {
            if (*from != '.' || unit != 0) break;
            unit = 1000;
            continue;
        }
        digits = 1;
        if (unit == 0) out->whole = out->whole < WHOLE_MOST ? out->whole * 10 + digit : WHOLE_MOST;
        else out->thousandths += digit * (unit /= 10);
    }
    *at = from;
    return digits;
}

static uint32_t tenths_of(const serve_number_t *number) {
    return number->whole * TENTHS + number->thousandths / 100;
}

// What codes from the least to the most of them, in tenths, do; those of M are 2000 more.
typedef struct row {
    uint16_t least, most;
    uint8_t does; // serve_does_t
} row_t;

static const row_t rows[] = {
    {0, 39, SERVE_MOVES}, {40, 40, SERVE_LATE},
    {100, 109, SERVE_LATE | SERVE_SHIFTS | SERVE_HAS_AXES}, {280, 280, SERVE_HAS_AXES},
    {281, 281, SERVE_LATE | SERVE_HAS_AXES}, {300, 300, SERVE_HAS_AXES},
    {301, 301, SERVE_LATE | SERVE_HAS_AXES}, {430, 430, SERVE_SHIFTS},
    {431, 431, SERVE_SHIFTS | SERVE_HAS_AXES}, {490, 490, SERVE_SHIFTS},
    {520, 520, SERVE_SHIFTS | SERVE_HAS_AXES}, {540, 593, SERVE_SHIFTS}, {800, 800, SERVE_MOVES},
    {920, 923, SERVE_SHIFTS | SERVE_HAS_AXES}, {2000, 2010, SERVE_LATE},
    {2020, 2020, SERVE_ENDS}, {2060, 2060, SERVE_LATE}, {2300, 2300, SERVE_ENDS},
    {2600, 2600, SERVE_LATE}
};

static void look_at_word(serve_t *self, char letter, const serve_number_t *number) {
    enum { M = 2000 };
    const uint32_t code = tenths_of(number) + (letter == 'M' ? M : 0);
    if (letter == 'N') self->line.name = number->whole;
    if (letter != 'G' && letter != 'M') return;
    for (uint32_t k = 0; k < sizeof rows / sizeof *rows; k++) {
        if (code >= rows[k].least && code <= rows[k].most) self->line.does |= rows[k].does;
    }
    if (code == M + 660) self->line.probes = SERVE_ASKS;
    if (code >= 382 && code <= 385) self->probe = self->line.probes = (uint8_t)(code - 380);
}

// Axes alone probe where the line before has.
static int probes_on(const serve_t *self) {
    nck_modal_t modal;
    nck_modal(self->nck, &modal);
    return modal.motion == PROBES;
}

static int is_axis(char letter) {
    return (letter >= 'A' && letter <= 'C') || (letter >= 'U' && letter <= 'Z');
}

void serve_look(serve_t *self) {
    int moves = 0;
    const char *at = self->text;
    self->text[self->line.size] = '\0';
    while (*at != '\0') {
        serve_number_t number;
        const char letter = *at++;
        if (letter < 'A' || letter > 'Z') continue;
        if (serve_number(&at, &number)) look_at_word(self, letter, &number);
        moves |= is_axis(letter);
    }
    if (self->line.does & SERVE_MOVES) self->probe = 0;
    if (moves && !(self->line.does & SERVE_HAS_AXES) && self->probe && probes_on(self)) {
        self->line.probes = self->probe;
    }
    if (self->line.probes) self->line.does |= SERVE_LATE;
}

static int is_jog_code(const serve_number_t *number) {
    const uint32_t code = tenths_of(number);
    return code == 200 || code == 210 || code == 900 || code == 910 || code == 530;
}

uint8_t serve_look_jog(serve_t *self) {
    enum { BEFORE = 3, PREFIX = sizeof jog_prefix - 1 };
    char *const text = self->text;
    const char *at = text + BEFORE;
    int feeds = 0, moves = 0;
    text[self->line.size] = '\0';
    while (*at != '\0') {
        serve_number_t number;
        const char letter = *at++;
        if (!serve_number(&at, &number)) return SERVE_E_JOG;
        const int is_code = letter == 'G' && is_jog_code(&number);
        feeds |= letter == 'F';
        moves |= is_axis(letter);
        if (!is_axis(letter) && letter != 'F' && letter != 'N' && !is_code) return SERVE_E_JOG;
    }
    if (!moves) return SERVE_E_JOG;
    if (!feeds) return SERVE_E_FEED;
    memmove(text + PREFIX, text + BEFORE, self->line.size - BEFORE);
    memcpy(text, jog_prefix, PREFIX);
    self->line.size += PREFIX - BEFORE;
    return 0;
}

uint8_t serve_error_of(int32_t status) {
    static const struct {
        int8_t status;
        uint8_t error;
    } table[] = {
        {NCK_E_CHARACTER, 1}, {NCK_E_NUMBER, 2}, {NCK_E_NUMBER_RANGE, 2}, {NCK_E_LINE_LENGTH, 11},
        {NCK_E_WORD_TWICE, 25}, {NCK_E_WORD_UNUSED, 36}, {NCK_E_WORD_MISSING, 28},
        {NCK_E_MODAL_GROUP, 21}, {NCK_E_FEED_MISSING, 22}, {NCK_E_ARC_RADIUS, 34},
        {NCK_E_ARC_CENTRE, 35}, {NCK_E_ARC_CHORD, 34}, {NCK_E_ARC_MODE, 34},
        {NCK_E_TRAVEL, SERVE_E_TRAVEL}, {NCK_E_TOOL_UNKNOWN, 38}, {NCK_E_NO_MOTION, 31},
        {NCK_E_WORD_SHARED, 24}, {NCK_E_INCREMENTAL, 30}
    };
    for (uint32_t k = 0; k < sizeof table / sizeof *table; k++) {
        if (table[k].status == status) return table[k].error;
    }
    return SERVE_E_CODE;
}
