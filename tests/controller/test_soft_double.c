// SPDX-License-Identifier: MIT
// The quotient, the root and the comparisons of firmware_sim/soft_double have the bits that this
// computer's floating-point unit has.
#include "soft_double/soft_double.h"

#include <math.h>   // sqrt
#include <string.h> // memcpy

#include "check.h"

enum { PAIRS = 3000000, NOT_SIGN = 0x7ff, KINDS = 8 };

static uint64_t bits_of(double x) {
    uint64_t bits;
    memcpy(&bits, &x, sizeof bits);
    return bits;
}

static double number_of(uint64_t bits) {
    double x;
    memcpy(&x, &bits, sizeof x);
    return x;
}

// xorshift64 (Marsaglia 2003).
static uint64_t next(uint64_t *state) {
    *state ^= *state << 13;
    *state ^= *state >> 7;
    *state ^= *state << 17;
    return *state;
}

// A number of any kind: few bits at the top, few at the bottom, about a power of two; its exponent
// anything, infinite and subnormal ones included, or near that of 1.
static uint64_t pick(uint64_t *state) {
    const uint64_t kind = next(state) % KINDS;
    uint64_t mantissa = next(state);
    if (kind == 0) mantissa &= 0xfffff00000000u;
    if (kind == 1) mantissa &= 0xffu;
    if (kind == 2) mantissa = next(state) % 8u - 4u;
    if (kind == 3) mantissa |= 0xffffffff00000u;
    const uint64_t draw = next(state);
    const uint64_t exponent = draw % 4u == 0 ? draw >> 8 : SOFT_DOUBLE_BIAS - 100u + draw % 200u;
    const uint64_t sign = next(state) << 63;
    return sign | (exponent & NOT_SIGN) << 52 | (mantissa & 0xfffffffffffffu);
}

static void a_quotient_has_the_bits_of_the_unit(check_t *check) {
    uint64_t state = 88172645463325252u;
    int own = 0;
    for (int k = 0; k < PAIRS && check->broken == 0; k++) {
        const uint64_t b = pick(&state);
        uint64_t a = pick(&state);
        if (k % 16 == 0) a = bits_of(number_of(a) * number_of(b)); // it comes out even
        if (!soft_double_divides(a, b)) continue;
        own++;
        const uint64_t want = bits_of(number_of(a) / number_of(b));
        if (!CHECK(check, soft_double_quotient(a, b) == want)) {
            printf("    %a / %a\n", number_of(a), number_of(b));
        }
    }
    CHECK(check, own > PAIRS / 2);
}

static void a_root_has_the_bits_of_the_unit(check_t *check) {
    uint64_t state = 1181783497276652981u;
    int own = 0;
    for (int k = 0; k < PAIRS && check->broken == 0; k++) {
        uint64_t a = pick(&state) & 0x7fffffffffffffffu;
        if (k % 8 == 0) a = bits_of(number_of(a) * number_of(a)); // it comes out even
        if (!soft_double_is_plain(a)) continue;
        own++;
        const uint64_t want = bits_of(sqrt(number_of(a)));
        if (!CHECK(check, soft_double_root(a) == want)) printf("    root %a\n", number_of(a));
    }
    CHECK(check, own > PAIRS / 2);
}

static void what_is_not_normal_is_left_to_the_library(check_t *check) {
    static const double strange[] = {
        0.0, -0.0, 4.9e-324, 2.2e-308, HUGE_VAL, -HUGE_VAL, (double)NAN,
    };
    const uint64_t one = bits_of(1.0);
    for (unsigned k = 0; k < sizeof strange / sizeof *strange; k++) {
        const uint64_t bits = bits_of(strange[k]);
        CHECK(check, !soft_double_divides(bits, one) && !soft_double_divides(one, bits));
        CHECK(check, !soft_double_is_plain(bits));
    }
    CHECK(check, !soft_double_is_plain(bits_of(-4.0)));
    CHECK(check, !soft_double_divides(bits_of(1e-300), bits_of(1e300)));
    CHECK(check, !soft_double_divides(bits_of(1e300), bits_of(1e-300)));
    CHECK(check, soft_double_divides(bits_of(-1e300), bits_of(3.0)));
    CHECK(check, soft_double_is_plain(bits_of(2.3e-308)));
}

static void what_compares_as_bits_compares_as_numbers(check_t *check) {
    uint64_t state = 2463534242u;
    for (int k = 0; k < PAIRS / 10 && check->broken == 0; k++) {
        const uint64_t a = pick(&state);
        const uint64_t b = k % 3 == 0 ? a : pick(&state);
        const double x = number_of(a);
        const double y = number_of(b);
        if (!soft_double_compares(a, b)) continue;
        CHECK(check, (a < b) == (x < y) && (a > b) == (x > y) && (a == b) == (x == y));
    }
    CHECK(check, !soft_double_compares(bits_of(-0.0), bits_of(0.0)));
    CHECK(check, !soft_double_compares(bits_of((double)NAN), bits_of(1.0)));
    CHECK(check, soft_double_compares(bits_of(0.0), bits_of(4.9e-324)));
}

int main(void) {
    check_t check = {0};
    CHECK_RUN(&check, a_quotient_has_the_bits_of_the_unit);
    CHECK_RUN(&check, a_root_has_the_bits_of_the_unit);
    CHECK_RUN(&check, what_is_not_normal_is_left_to_the_library);
    CHECK_RUN(&check, what_compares_as_bits_compares_as_numbers);
    return check_end(&check);
}
