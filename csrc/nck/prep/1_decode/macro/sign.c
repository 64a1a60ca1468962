// SPDX-License-Identifier: MIT
// Words and names of control lines, and what a line says about itself before it is read.
#include "nck/prep/1_decode/macro/parts.h"
#include "nck/prep/1_decode/state/state.h" // nck_variable_name

#include <stddef.h> // NULL

const char *nck_decode_skip(const char *at) {
    while (*at == ' ' || *at == '\t' || *at == '(') {
        const char *end = at + 1;
        while (*at == '(' && *end != ')' && *end != '\n') end++;
        if (*end == '\n' && *at == '(') return at;
        at = *at == '(' ? end + 1 : end;
    }
    return at;
}

static char capital(char c) { return c >= 'a' && c <= 'z' ? (char)(c - 'a' + 'A') : c; }

const char *nck_decode_spells(const char *at, const char *word) {
    for (; *word != '\0'; at++, word++) {
        if (capital(*at) != *word) return NULL;
    }
    return at;
}

// One past a letter of a word; of an O word past the blanks behind it, too, which count nowhere.
static const char *behind_letter(const char *at, int is_o_word) {
    at++;
    while (is_o_word && (*at == ' ' || *at == '\t')) at++;
    return at;
}

static unsigned listed(const char *at, const char *words, int is_o_word, const char **behind) {
    unsigned place = 1;
    while (*words != '\0') {
        const char *end = at;
        for (; *words != ' ' && capital(*end) == *words; words++) {
            end = behind_letter(end, is_o_word && words[1] != ' ');
        }
        *behind = end;
        if (*words == ' ') return place;
        while (*words != ' ') words++;
        words++;
        place++;
    }
    return 0;
}

unsigned nck_decode_listed(const char *at, const char *words, const char **behind) {
    return listed(at, words, 0, behind);
}

const char *nck_decode_name_end(const char *at) {
    const char *const first = at;
    while (*at != '>' && *at != '\n') at++;
    return *at == '>' && at > first + 1 ? at + 1 : NULL;
}

const char *nck_decode_name_key(const char *at, uint64_t *key_out) {
    if (*at == '<') {
        const char *const end = nck_decode_name_end(at);
        if (end != NULL) *key_out = nck_variable_name(at + 1, end - 1);
        return end;
    }
    uint64_t number = 0;
    if (!nck_is_digit(*at)) return NULL;
    for (; nck_is_digit(*at) && number <= NCK_LABEL_MOST; at++) {
        number = 10 * number + (uint64_t)(*at - '0');
    }
    *key_out = number;
    return number <= NCK_LABEL_MOST ? at : NULL;
}

// ---- what a line says about itself

unsigned nck_decode_word(const char *at, const char **behind) {
    static const char words[] = "SUB ENDSUB CALL RETURN IF ELSEIF ELSE ENDIF DO REPEAT "
                                "WHILE ENDWHILE ENDREPEAT BREAK CONTINUE ";
    const char *end = at;
    *behind = at;
    if (*at == '\n' || *at == ';') return NCK_O_NAME;
    const unsigned k = listed(at, words, 1, &end);
    if (k == 0 || nck_is_letter(*end)) return NCK_O_OTHER;
    *behind = end;
    return NCK_O_SUB + k - 1;
}

void nck_decode_sign(const nck_decode_t *self, nck_sign_t *sign_out) {
    if (!NCK_HAS_CALLS) return;
    const char *at = nck_decode_skip(self->line.text);
    const char *behind;
    *sign_out = (nck_sign_t){0, 0, NCK_O_NOT, 0};
    if (*at == '/') at = nck_decode_skip(at + 1);
    if (*at == 'N' || *at == 'n') {
        at = nck_decode_name_key(nck_decode_skip(at + 1), &sign_out->number);
        if (at == NULL) return;
        sign_out->numbered = 1;
        at = nck_decode_skip(at);
    }
    const char *const end = nck_decode_spells(at, "END");
    if (end != NULL && nck_is_digit(*nck_decode_skip(end))) {
        (void)nck_decode_name_key(nck_decode_skip(end), &sign_out->key);
        sign_out->word = NCK_O_END;
    } else if ((*at & ~0x20) == 'O' || *at == ':') {
        at = nck_decode_name_key(nck_decode_skip(at + 1), &sign_out->key);
        if (at != NULL) sign_out->word = nck_decode_word(nck_decode_skip(at), &behind);
    }
}
