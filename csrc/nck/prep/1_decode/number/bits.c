// SPDX-License-Identifier: MIT
// Values as bits and as BCD.
#include "nck/prep/1_decode/number/number.h"
#include "nck/base/limits.h" // NCK_HAS_VARIABLES
#include "nck/base/real.h" // nck_floor nck_fabs

enum { DIGITS = 8 };

static const double bits_most = 4294967295.0;
static const double near_whole = 1e-6; // what arithmetic leaves of a whole number

int nck_bits(double value, uint32_t *bits_out) {
    const double whole = nck_floor(value + 0.5);
    if (!NCK_HAS_VARIABLES) return 0;
    if (!(whole >= 0.0 && whole <= bits_most) || nck_fabs(value - whole) > near_whole) return 0;
    *bits_out = (uint32_t)whole;
    return 1;
}

// Digits of one base become those of another.
static double recoded(double value, uint32_t from, uint32_t to) {
    uint32_t left = 0, code = 0, place = 1;
    if (!nck_bits(value, &left)) return -1.0;
    for (unsigned k = 0; k < DIGITS; k++) {
        const uint32_t digit = left % from;
        if (digit > 9) return -1.0;
        code += digit * place;
        place *= to;
        left /= from;
    }
    return left == 0 ? (double)code : -1.0;
}

double nck_to_bcd(double value) { return recoded(value, 10, 16); }

double nck_from_bcd(double value) { return recoded(value, 16, 10); }
