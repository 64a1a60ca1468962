// SPDX-License-Identifier: MIT
// Decimal numbers as a program writes them: kept exact, turned into fixed point or floating point
// when the unit is known.
#ifndef NCK_PREP_DECODE_STATE_NUMBER_H
#define NCK_PREP_DECODE_STATE_NUMBER_H

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

#endif
