// SPDX-License-Identifier: MIT
// Powers, logarithm, remainder.
#include "nck/prep/1_decode/number/number.h"
#include "nck/base/limits.h" // NCK_HAS_VARIABLES
#include "nck/base/real.h" // nck_fabs nck_floor

#include <string.h> // memcpy

enum { DIGITS_MOST = 2100 }; // from the smallest number to the largest

static const double ln2_high = 6.93147180369123816490e-01; // 33 bits: n · ln2_high is exact
static const double ln2_low = 1.90821492927058770002e-10;

// 2^n for −1022 ≤ n ≤ 1023.
static double two_to(int n) {
    const uint64_t bits = (uint64_t)(n + 1023) << 52;
    double value;
    memcpy(&value, &bits, sizeof value);
    return value;
}

double nck_exp(double x) {
    if (!NCK_HAS_VARIABLES) return 0.0;
    if (x > 709.78) return two_to(1023) * 2.0;
    if (x < -708.0) return 0.0;
    const double n = nck_floor(x * 1.44269504088896340736 + 0.5);
    const double r = (x - n * ln2_high) - n * ln2_low;
    double sum = 1.0;
    for (int k = 14; k >= 1; k--) sum = 1.0 + sum * r / (double)k; // Taylor: |r|¹⁵/15! < 1e-19
    return sum * two_to((int)n - 1) * 2.0;
}

// x = m·2^e with √½ ≤ m < √2; ln m = 2 atanh s = 2 (s + s³/3 + s⁵/5 + …), s = (m − 1)/(m + 1).
double nck_log(double x) {
    if (!NCK_HAS_VARIABLES) return 0.0;
    uint64_t bits;
    memcpy(&bits, &x, sizeof bits);
    int e = (int)(bits >> 52) - 1023;
    bits = (bits & 0xfffffffffffffULL) | 0x3ff0000000000000ULL;
    double m;
    memcpy(&m, &bits, sizeof m);
    if (m > 1.41421356237309504880) {
        m *= 0.5;
        e++;
    }
    const double s = (m - 1.0) / (m + 1.0);
    double sum = 0.0;
    for (int k = 23; k >= 3; k -= 2) sum = (sum + 1.0 / (double)k) * (s * s); // rest < 1e-19
    return (double)e * ln2_high + (2.0 * s + (2.0 * s * sum + (double)e * ln2_low));
}

static double whole_power(double base, double exponent) {
    double power = 1.0, square = base;
    for (unsigned n = (unsigned)nck_fabs(exponent); n != 0; n >>= 1) {
        if (n & 1u) power *= square;
        square *= square;
    }
    return exponent < 0.0 ? 1.0 / power : power;
}

double nck_power(double base, double exponent) {
    if (!NCK_HAS_VARIABLES) return 0.0;
    const int whole = nck_floor(exponent) >= exponent;
    if (whole && nck_fabs(exponent) <= 1024.0) return whole_power(base, exponent);
    if (!(nck_fabs(base) > 0.0)) return 0.0;
    const double power = nck_exp(exponent * nck_log(nck_fabs(base)));
    const int odd = nck_floor(0.5 * exponent) < 0.5 * exponent;
    return base < 0.0 && odd ? -power : power;
}

double nck_rest(double a, double b) {
    if (!NCK_HAS_VARIABLES) return 0.0;
    const double divisor = nck_fabs(b);
    double rest = nck_fabs(a), part = divisor;
    int digits = 1; // of the quotient
    for (; digits < DIGITS_MOST && part <= 0.5 * rest; digits++) part *= 2.0;
    for (; digits > 0; digits--) {
        if (rest >= part) rest -= part;
        part *= 0.5;
    }
    return a < 0.0 ? -rest : rest;
}
