// SPDX-License-Identifier: MIT
// Whose language is this? Asked only for lines that are no RS274NGC, so that no good program trips
// over it.
#include "nck/prep/1_decode/tongue/tongue.h"

static char upper(char c) {
    return c >= 'a' && c <= 'z' ? (char)(c - 'a' + 'A') : c;
}

// One past the word if the text begins with it, in upper or lower case; else a null pointer.
static const char *after(const char *at, const char *word) {
    while (*word != '\0') {
        if (upper(*at) != *word) return (const char *)0;
        at++;
        word++;
    }
    return at;
}

static int begins_with_one_of(const char *at, const char *const *words) {
    for (; *words != (const char *)0; words++) {
        if (after(at, *words) != (const char *)0) return 1;
    }
    return 0;
}

static int contains(const char *at, const char *word) {
    for (; *at != '\n'; at++) {
        if (after(at, word) != (const char *)0) return 1;
    }
    return 0;
}

static int is_letter(char c) {
    return c >= 'A' && c <= 'Z';
}

// A remark behind ', a name behind &, or a command of two characters, such as MX,20 or J2,0,0.
static int is_shopbot(const char *at) {
    if (*at == '\'' || (*at == '&' && is_letter(upper(at[1])))) return 1;
    const char first = upper(*at);
    if (!is_letter(first)) return 0;
    const int moves = (first == 'M' || first == 'J') && at[1] >= '2' && at[1] <= '5';
    return (is_letter(upper(at[1])) || moves) && *nck_skip_blanks(at + 2) == ',';
}

int nck_decode_foreign(const char *line) {
    static const char *const sinumerik[] = {
        "%_N_", "DEF REAL ", "DEF INT ", "DEF BOOL ", "DEF STRING", "DEF CHAR ", "DEF FRAME ",
        "DEF AXIS ", "PROC ", "EXTERN ", "CYCLE", "MCALL",
        "T=\"", "MSG(", "WORKPIECE(", (const char *)0
    };
    const char *at = nck_skip_blanks(line);
    if (*at == '$' && (contains(at, ".MIN") || contains(at, ".SSB") || contains(at, ".LIB"))) {
        return NCK_HINT_OKUMA;
    }
    if (is_shopbot(at)) return NCK_HINT_SHOPBOT;
    if (*at == 'N' || *at == 'n') at++;
    while (*at >= '0' && *at <= '9') at++;
    at = nck_skip_blanks(at);
    if (after(at, "BEGIN PGM ") != (const char *)0) return NCK_HINT_HEIDENHAIN;
    return begins_with_one_of(at, sinumerik) ? NCK_HINT_SINUMERIK : 0;
}
