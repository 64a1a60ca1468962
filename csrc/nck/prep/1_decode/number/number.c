// SPDX-License-Identifier: MIT
// Decimal numbers: reading, exact fixed point, floating point.
#include "nck/prep/1_decode/number/number.h"
#include "nck/base/real.h" // nck_real_of

enum { POWERS = 19, REAL_POWERS = 23 }; // of ten: the first that is no int64_t, no exact double

enum { PLAIN_DIGITS = 17 }; // of a number that is read at once: any of them fits

// Decimals are kept within these: beyond, a number is 0 or out of every range anyway.
enum { DECIMALS_MIN = -280, DECIMALS_MAX = 32000 };

static const int64_t power_of_ten[POWERS] = {
    1, 10, 100, 1000, 10000, 100000, 1000000, 10000000, 100000000, 1000000000, 10000000000,
    100000000000, 1000000000000, 10000000000000, 100000000000000, 1000000000000000,
    10000000000000000, 100000000000000000, 1000000000000000000
};

// 10^n, 0 ≤ n < REAL_POWERS: exact in binary64, and so are both factors.
static double real_power_of_ten(int n) {
    const int rest = n < POWERS ? 0 : n - (POWERS - 1);
    return nck_real_of(power_of_ten[n - rest]) * nck_real_of(power_of_ten[rest]);
}

static int is_blank(char c) {
    return c == ' ' || c == '\t';
}

static unsigned digit_of(char c) {
    return (unsigned)(unsigned char)c - (unsigned)'0';
}

static const char *skip_blanks(const char *at) {
    while (is_blank(*at)) {
        at++;
    }
    return at;
}

static int16_t bounded_decimals(int decimals) {
    if (decimals < DECIMALS_MIN) return DECIMALS_MIN;
    return decimals > DECIMALS_MAX ? DECIMALS_MAX : (int16_t)decimals;
}

// Digits in a row, behind those of the mantissa; of too many the mantissa is worth nothing.
static const char *read_digits(const char *at, uint64_t *mantissa) {
    for (unsigned digit = digit_of(*at); digit <= 9; digit = digit_of(*++at)) {
        *mantissa = *mantissa * 10 + digit;
    }
    return at;
}

// What nearly all numbers are: few digits in a row, and a point at most. NULL: it is none of them.
static const char *read_plain(const char *at, nck_number_t *out) {
    const char *const first = at;
    uint64_t mantissa = 0;
    at = read_digits(at, &mantissa);
    const char *const point = at;
    const int has_point = *at == '.';
    if (has_point) at = read_digits(at + 1, &mantissa);
    const int decimals = has_point ? (int)(at - point) - 1 : 0;
    const int digits = (int)(point - first) + decimals;
    at = skip_blanks(at);
    if (digits < 1 || digits > PLAIN_DIGITS || digit_of(*at) <= 9 || *at == '.') {
        return (const char *)0;
    }
    out->mantissa = (int64_t)mantissa;
    out->decimals = (int16_t)decimals;
    out->longer = 0;
    return at;
}

// Any number of digits, blanks among them.
static const char *read_any(const char *at, nck_number_t *out) {
    int64_t mantissa = 0;
    int decimals = 0, point = 0, digits = 0, longer = 0;
    for (;; at++) {
        const unsigned digit = digit_of(*at);
        if (digit <= 9 && mantissa < 100000000000000000) {
            mantissa = mantissa * 10 + (int64_t)digit;
            decimals += point;
            digits = 1;
        } else if (digit <= 9) {
            decimals -= 1 - point;
            longer = 1;
        } else if (*at == '.' && !point) {
            point = 1;
        } else if (!is_blank(*at)) {
            break;
        }
    }
    out->mantissa = mantissa;
    out->decimals = bounded_decimals(decimals);
    out->longer = (uint8_t)longer;
    return digits ? at : (const char *)0;
}

const char *nck_number_read(const char *text, const char *at, nck_number_t *out) {
    at = skip_blanks(at);
    out->negative = *at == '-';
    const char *const first = *at == '-' || *at == '+' ? skip_blanks(at + 1) : at;
    const char *next = read_plain(first, out);
    if (!next) next = read_any(first, out);
    out->first = (uint16_t)(first - text);
    out->last = (uint16_t)((next ? next : first) - text);
    return next;
}

// Round (quotient + rest / divisor) half to even; 0 ≤ rest < divisor ≤ 1e18.
static int64_t round_half_even(int64_t quotient, int64_t rest, int64_t divisor) {
    const int64_t twice = 2 * rest;
    return quotient + (twice > divisor || (twice == divisor && (quotient & 1)));
}

// The digits behind the first `power` decimals, times factor, from the last to the first as by
// hand: the carry is what they add to the whole units, the digits left behind decide the rounding.
static int64_t tail_carry(const char *first, const char *last, int64_t factor, int64_t *rest_out) {
    int64_t carry = 0, leading = 0, sticky = 0;
    while (last > first) {
        const unsigned digit = digit_of(*--last);
        if (digit <= 9) {
            const int64_t product = (int64_t)digit * factor + carry;
            sticky |= leading;
            leading = product % 10;
            carry = product / 10;
        }
    }
    *rest_out = 2 * leading + (sticky != 0); // of 20
    return carry;
}

// Any number of digits. Units in front of the tail stay below 1e17, or the number is out of range.
static int fixed_from_text(const char *text, const nck_number_t *number,
                           const nck_scale_t *scale, int64_t *magnitude_out) {
    const char *at = text + number->first, *last = text + number->last;
    const int64_t most = scale->limit / scale->factor + 1;
    int64_t units = 0, rest = 0;
    int places = -1; // decimals taken; −1: before the point
    for (; at < last && places < scale->power; at++) {
        const unsigned digit = digit_of(*at);
        if (digit <= 9) {
            units = units * 10 + (int64_t)digit;
            places += places >= 0;
        }
        if (*at == '.') {
            places = 0;
        }
        if (units > most) return 0;
    }
    for (places = places < 0 ? 0 : places; places < scale->power; places++) {
        units *= 10;
        if (units > most) return 0;
    }
    units = units * scale->factor + tail_carry(at, last, scale->factor, &rest);
    *magnitude_out = round_half_even(units, rest, 20);
    return 1;
}

int nck_number_fixed(const char *text, const nck_number_t *number, const nck_scale_t *scale,
                     int64_t *out) {
    const int shift = scale->power - number->decimals;
    int64_t magnitude;

    if (number->longer || shift <= -POWERS || number->mantissa > INT64_MAX / 1024) {
        if (!fixed_from_text(text, number, scale, &magnitude)) {
            return 0;
        }
    } else if (shift >= 0) {
        const int64_t unit = scale->factor * power_of_ten[shift];
        if (nck_real_of(number->mantissa) * nck_real_of(unit) > 1e17) {
            return 0;
        }
        magnitude = number->mantissa * unit;
    } else {
        const int64_t units = number->mantissa * scale->factor, divisor = power_of_ten[-shift];
        magnitude = round_half_even(units / divisor, units % divisor, divisor);
    }
    if (magnitude > scale->limit) {
        return 0;
    }
    *out = number->negative ? -magnitude : magnitude;
    return 1;
}

double nck_number_real(const nck_number_t *number) {
    double value = nck_real_of(number->mantissa);
    int decimals = number->decimals;
    for (; decimals >= REAL_POWERS; decimals -= REAL_POWERS - 1) {
        value /= real_power_of_ten(REAL_POWERS - 1);
    }
    for (; decimals <= -REAL_POWERS; decimals += REAL_POWERS - 1) {
        value *= real_power_of_ten(REAL_POWERS - 1);
    }
    if (decimals >= 0) {
        value /= real_power_of_ten(decimals);
    } else {
        value *= real_power_of_ten(-decimals);
    }
    return number->negative ? -value : value;
}

void nck_number_tenths(int32_t tenths, nck_number_t *out) {
    const nck_number_t number = {tenths, 1, 0, 0, 0, 0};
    *out = number;
}

int nck_number_whole(const nck_number_t *number, int places, int64_t *out) {
    const int shift = places - number->decimals;
    int64_t magnitude = number->mantissa;

    if (number->longer || shift <= -POWERS || magnitude > 1000000000000000) {
        return 0;
    }
    if (shift >= 0) {
        magnitude *= power_of_ten[shift];
    } else if (magnitude % power_of_ten[-shift] != 0) {
        return 0;
    } else {
        magnitude /= power_of_ten[-shift];
    }
    *out = number->negative ? -magnitude : magnitude;
    return 1;
}
