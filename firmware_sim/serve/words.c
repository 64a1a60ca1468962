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

// Its axes are no way to go: of the codes in tenths those of offsets, places and tool lengths.
static int has_own_axes(uint32_t code) {
    const uint32_t whole = code / TENTHS;
    return whole == 10 || whole == 28 || whole == 30 || whole == 52 || whole == 92 || code == 431;
}

static void look_at_word(serve_t *self, char letter, const serve_number_t *number) {
    const uint32_t code = tenths_of(number);
    if (letter == 'N') self->line.name = number->whole;
    if (letter == 'M') {
        if (code == 20 || code == 300) self->line.ends = 1;
        if (code == 0 || code == 10 || code == 60 || code == 600) self->line.settles = 1;
    }
    if (letter == 'G' && code >= 382 && code <= 385) {
        self->probe = self->line.probes = (uint8_t)(code - 380);
    }
    if (letter == 'G' && (code < 40 || code == 800)) self->probe = 0;
    if (letter == 'G' && (code == 40 || code == 100 || code == 281 || code == 301)) {
        self->line.settles = 1;
    }
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
    int moves = 0, own = 0;
    const char *at = self->text;
    const char *const behind = at + self->line.size;
    self->text[self->line.size] = '\0';
    while (at < behind) {
        serve_number_t number;
        const char letter = *at++;
        if (letter < 'A' || letter > 'Z') continue;
        if (serve_number(&at, &number)) look_at_word(self, letter, &number);
        own |= letter == 'G' && has_own_axes(tenths_of(&number));
        moves |= is_axis(letter);
    }
    if (moves && !own && self->probe && probes_on(self)) self->line.probes = self->probe;
    if (self->line.probes) self->line.settles = 1;
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
