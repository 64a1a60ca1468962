// SPDX-License-Identifier: MIT
// Numbers as words of text, read exactly: decimal integers, and reals in C's %a notation.
#ifndef APP_NUMBER_H
#define APP_NUMBER_H

#include <stdint.h> // int64_t

// A word of text, not ended by a NUL.
typedef struct app_word {
    const char *at;
    uint32_t length;
} app_word_t;

// 1 if the word is text. Cost: linear. Context: any.
int app_word_is(const app_word_t *word, const char *text);

// Read an integer, -2⁶³ … 2⁶³ − 1. Returns 1 if the whole word is one.
// Cost: linear. Context: any.
int app_integer(const app_word_t *word, int64_t *value_out);

// Read a real: an integer, or [-]0xH.H…p±D with at most 53 significant bits and a result that is
// zero or of 2⁻¹⁰²² … 2¹⁰²³. Returns 1 if the whole word is one, and 0 as well if bits would be
// lost.
// Cost: linear in the length and in the exponent. Context: any.
int app_real(const app_word_t *word, double *value_out);

#endif
