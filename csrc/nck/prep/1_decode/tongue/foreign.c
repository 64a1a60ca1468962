// SPDX-License-Identifier: MIT
// Whose language is this? Asked only for lines that are no RS274NGC, so that no good program trips
// over it.
#include "nck/prep/1_decode/tongue/tongue.h"

// One past the word if the text begins with it, in upper or lower case; else a null pointer.
static const char *after(const char *at, const char *word) {
    while (*word != '\0') {
        const char c = *at >= 'a' && *at <= 'z' ? (char)(*at - 'a' + 'A') : *at;
        if (c != *word) return (const char *)0;
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
    if (*at == 'N' || *at == 'n') at++;
    while (*at >= '0' && *at <= '9') at++;
    at = nck_skip_blanks(at);
    if (after(at, "BEGIN PGM ") != (const char *)0) return NCK_HINT_HEIDENHAIN;
    return begins_with_one_of(at, sinumerik) ? NCK_HINT_SINUMERIK : 0;
}
