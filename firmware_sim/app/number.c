// SPDX-License-Identifier: MIT
// Numbers as words of text.
#include "app/number.h"

#include <string.h> // memcmp strlen

enum { EXPONENT_MIN = -1022, EXPONENT_MAX = 1023, MANTISSA_BITS = 53, EXPONENT_DIGITS = 5 };

int app_word_is(const app_word_t *word, const char *text) {
    return word->length == strlen(text) && memcmp(word->at, text, word->length) == 0;
}

int app_integer(const app_word_t *word, int64_t *value_out) {
    const int negative = word->length > 0 && word->at[0] == '-';
    const uint64_t most = (uint64_t)INT64_MAX + (negative ? 1u : 0u);
    uint64_t value = 0;
    if (word->length == (negative ? 1u : 0u)) return 0;
    for (uint32_t k = negative ? 1 : 0; k < word->length; k++) {
        const char digit = word->at[k];
        if (digit < '0' || digit > '9') return 0;
        const uint64_t units = (uint64_t)(digit - '0');
        if (value > (most - units) / 10) return 0;
        value = value * 10 + units;
    }
    if (!negative) *value_out = (int64_t)value;
    else *value_out = value == most ? INT64_MIN : -(int64_t)value;
    return 1;
}

static int hex_digit(char letter) {
    if (letter >= '0' && letter <= '9') return letter - '0';
    if (letter >= 'a' && letter <= 'f') return letter - 'a' + 10;
    return -1;
}

// The digits of H.H…: their value as an integer, and how many stand behind the point.
// Returns where they end, or 0 if there is none or they are more than a mantissa holds.
static uint32_t read_mantissa(const app_word_t *word, uint32_t k, uint64_t *mantissa_out,
                              int *places_out) {
    int point = 0, digits = 0;
    *mantissa_out = 0;
    *places_out = 0;
    for (; k < word->length && word->at[k] != 'p'; k++) {
        const int digit = hex_digit(word->at[k]);
        if (word->at[k] == '.' && !point) {
            point = 1;
            continue;
        }
        if (digit < 0 || *mantissa_out >> (MANTISSA_BITS - 1)) return 0;
        *mantissa_out = *mantissa_out * 16 + (uint64_t)digit;
        *places_out += point;
        digits++;
    }
    return digits > 0 ? k : 0;
}

// value · 2^exponent, exact for results in the range of normal numbers.
static double scale(double value, int exponent) {
    for (; exponent > 0; exponent--) value *= 2.0;
    for (; exponent < 0; exponent++) value /= 2.0;
    return value;
}

// The power of two that a mantissa's highest bit stands for.
static int highest_bit(uint64_t mantissa) {
    int bit = 0;
    while (mantissa >> (bit + 1)) bit++;
    return bit;
}

static int is_hexadecimal(const app_word_t *word, uint32_t sign) {
    return word->length >= sign + 2 && word->at[sign] == '0' && word->at[sign + 1] == 'x';
}

// The power of two behind the p, where a mantissa has ended at `end`, 0: it has not. Returns 1 if
// it is one.
static int read_power(const app_word_t *word, uint32_t end, int64_t *exponent_out) {
    if (end == 0 || end + 2 > word->length) return 0;
    const uint32_t skip = word->at[end + 1] == '+' ? 2 : 1;
    const app_word_t power = {word->at + end + skip, word->length - end - skip};
    return power.length <= EXPONENT_DIGITS && app_integer(&power, exponent_out);
}

int app_real(const app_word_t *word, double *value_out) {
    int64_t exponent = 0;
    const uint32_t sign = word->length > 0 && word->at[0] == '-' ? 1 : 0;
    if (app_integer(word, &exponent)) {
        *value_out = (double)exponent;
        return 1;
    }
    if (!is_hexadecimal(word, sign)) return 0;
    uint64_t mantissa = 0;
    int places = 0;
    const uint32_t end = read_mantissa(word, sign + 2, &mantissa, &places);
    if (!read_power(word, end, &exponent) || mantissa >> MANTISSA_BITS) return 0;
    const int64_t shift = exponent - 4 * places;
    const int64_t top = shift + highest_bit(mantissa);
    if (mantissa != 0 && (top < EXPONENT_MIN || top > EXPONENT_MAX)) return 0;
    const double value = mantissa ? scale((double)mantissa, (int)shift) : 0.0;
    *value_out = sign ? -value : value;
    return 1;
}
