// SPDX-License-Identifier: MIT
// Decimal numbers as a program writes them: kept exact, turned into fixed point or floating point
// when the unit is known.
#ifndef NCK_PREP_DECODE_NUMBER_H
#define NCK_PREP_DECODE_NUMBER_H

#include <stdint.h> // int64_t

// value = ±mantissa × 10^(−decimals), as far as the mantissa reaches; the text holds the rest.
typedef struct nck_number {
    int64_t mantissa;  // first 18 significant digits, without sign and point
    int16_t decimals;  // of the mantissa; negative: digits before the point are left out
    uint16_t first;    // offset in the line of the first digit or point
    uint16_t last;     // offset one past the last character
    uint8_t negative;  // 1: minus
    uint8_t longer;    // 1: there are digits beyond the mantissa
} nck_number_t;

// The unit of a fixed-point number: value × factor × 10^power units, e.g. 254 and 5 for inches in
// nanometres.
typedef struct nck_scale {
    int32_t factor; // 1 … 1000
    int32_t power;  // 0 … 9
    int64_t limit;  // largest magnitude, ≤ 1e16
} nck_scale_t;

// Read a number: blanks, sign, digits and one point, blanks between them included (as RS274NGC
// does). text: the line, ended by a line feed; at: where the number is to begin. Returns one past
// the number and the blanks after it, or a null pointer if there is no digit. Cost: linear in the
// characters. Context: prep.
const char *nck_number_read(const char *text, const char *at, nck_number_t *out);

// The number in fixed point, rounded half to even from all of its digits. Returns 1, or 0 if its
// magnitude is above scale->limit (*out is untouched). Cost: constant, or linear in the digits of a
// long number. Context: prep.
int nck_number_fixed(const char *text, const nck_number_t *number, const nck_scale_t *scale,
                     int64_t *out);

// The number in floating point: the nearest one up to 15 significant digits, at most 2 ulp away
// beyond. Cost: constant, or linear in the digits of a long number. Context: prep.
double nck_number_real(const nck_number_t *number);

// A number of so many tenths, which stands nowhere in the line. Cost: constant. Context: prep.
void nck_number_tenths(int32_t tenths, nck_number_t *out);

// The number times 10^places if that is whole. Returns 1, or 0 if it is not whole or above 1e15;
// places: 0 or 1. Cost: constant. Context: prep.
int nck_number_whole(const nck_number_t *number, int places, int64_t *out);

#endif
