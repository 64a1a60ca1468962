// SPDX-License-Identifier: MIT
// Quotient and square root of doubles by integers and a float: for a core whose unit knows float
// alone (Cortex-M4F). Correctly rounded, to even from halfway: the bits of IEEE 754.
//
// A float gives 23 bits of the inverse, one step of Newton's method by words of 32 bits all of them
// (derived in README.md). Two digits of 27 bits follow, each with the exact remainder, which also
// decides how to round. The steps are the schoolbook's; a digit is never too large.
//
// Numbers come and go as their bits. What is not normal the caller leaves to the library.
#ifndef SOFT_DOUBLE_SOFT_DOUBLE_H
#define SOFT_DOUBLE_SOFT_DOUBLE_H

#include <math.h>   // sqrtf: one instruction
#include <stdint.h> // uint64_t

// Of the format, and of the digits that it is worked out in.
enum {
    SOFT_DOUBLE_BIAS = 1023,    // of an exponent
    SOFT_DOUBLE_MOST = 0x7fe,   // the largest exponent of a number
    SOFT_DOUBLE_DIGIT = 27,     // bits of a digit
    SOFT_DOUBLE_SLACK = 5,      // an inverse's last digits that may be too large
    SOFT_DOUBLE_ROOT_SLACK = 8, // likewise of a root's inverse
};

// The upper word of a product.
static inline uint32_t soft_double_upper(uint32_t a, uint32_t b) {
    return (uint32_t)(((uint64_t)a * b) >> 32);
}

// The product of a digit and a mantissa, modulo 2^64.
static inline uint64_t soft_double_times(uint32_t digit, uint64_t mantissa) {
    const uint64_t low = (uint64_t)digit * (uint32_t)mantissa;
    return low + ((uint64_t)(digit * (uint32_t)(mantissa >> 32)) << 32);
}

// The sign and the exponent of a number's bits.
static inline uint32_t soft_double_head(uint64_t bits) { return (uint32_t)(bits >> 52); }

// The mantissa of a normal number, its leading one included.
static inline uint64_t soft_double_mantissa(uint64_t bits) {
    return (bits & 0xfffffffffffffu) | 0x10000000000000u;
}

// 1 if bits are a positive normal number.
static inline int soft_double_is_plain(uint64_t bits) {
    return soft_double_head(bits) - 1u < SOFT_DOUBLE_MOST;
}

// 1 if both are neither negative nor infinite nor NaN: then they compare as their bits do.
static inline int soft_double_compares(uint64_t a, uint64_t b) {
    return (uint32_t)(a >> 32) < 0x7ff00000u && (uint32_t)(b >> 32) < 0x7ff00000u;
}

// 1 if a, b and a/b are normal numbers, whichever their signs.
static inline int soft_double_divides(uint64_t a, uint64_t b) {
    const uint32_t of_a = soft_double_head(a) & 0x7ffu;
    const uint32_t of_b = soft_double_head(b) & 0x7ffu;
    return of_a - 1u < SOFT_DOUBLE_MOST && of_b - 1u < SOFT_DOUBLE_MOST
           && of_a - of_b + (SOFT_DOUBLE_BIAS - 2u) < SOFT_DOUBLE_MOST - 3u;
}

// Step an inverse of 32 bits on by the error that it leaves, `slack` below what comes of it. At its
// largest it is past 2^32 before: it has gone round to zero then.
static inline uint32_t soft_double_step(uint32_t inverse, int32_t error, uint32_t slack) {
    const int64_t change = (int64_t)(int32_t)(inverse >> 1) * error;
    const uint32_t next = inverse + (uint32_t)(change >> 30) - slack;
    return next < 0x7fffff00u ? 0u - 1u - slack : next;
}

// 2^63/d of the d ≥ 2^31, never more than that.
static inline uint32_t soft_double_inverse(uint32_t d) {
    const uint32_t seed = (uint32_t)(0x1.fffffep62f / (float)d); // below 2^32
    const uint32_t error = 0x80000000u - soft_double_upper(seed, d);
    return soft_double_step(seed, (int32_t)error, SOFT_DOUBLE_SLACK);
}

// 2^47/√h of the h ≥ 2^30, never more than that.
static inline uint32_t soft_double_inverse_root(uint32_t h) {
    const uint32_t seed = (uint32_t)(0x1.fffffep46f / sqrtf((float)h)); // below 2^32
    const uint32_t square = soft_double_upper(seed, seed);
    const uint32_t error = 0x40000000u - soft_double_upper(square, h);
    return soft_double_step(seed, (int32_t)error, SOFT_DOUBLE_ROOT_SLACK);
}

// 54 bits to 53, by the last one and what is beyond: to the nearest, to the even one of two.
static inline uint64_t soft_double_round(uint64_t digits, int has_rest) {
    const uint64_t half = digits >> 1;
    return half + ((digits & 1u) & ((half & 1u) | (uint64_t)has_rest));
}

// a/b where soft_double_divides.
static inline uint64_t soft_double_quotient(uint64_t a, uint64_t b) {
    const uint64_t divisor = soft_double_mantissa(b);
    uint64_t rest = soft_double_mantissa(a);
    const uint32_t is_below = rest < divisor;
    const uint32_t exponent = (soft_double_head(a) & 0x7ffu) - (soft_double_head(b) & 0x7ffu)
                              + (SOFT_DOUBLE_BIAS - 1u) - is_below; // a mantissa's one adds to it
    rest <<= is_below;
    const uint32_t inverse = soft_double_inverse((uint32_t)(divisor >> 21));
    const uint32_t first = soft_double_upper((uint32_t)(rest >> 22), inverse) >> 4;
    rest = (rest << 26) - soft_double_times(first, divisor);
    uint32_t second = soft_double_upper((uint32_t)(rest >> 22), inverse) >> 3;
    rest = (rest << SOFT_DOUBLE_DIGIT) - soft_double_times(second, divisor);
    while (rest >= divisor) { // once or twice
        rest -= divisor;
        second++;
    }
    const uint64_t digits = ((uint64_t)first << SOFT_DOUBLE_DIGIT) + second;
    const uint64_t sign = (a ^ b) & 0x8000000000000000u;
    return (sign | (uint64_t)exponent << 52) + soft_double_round(digits, rest != 0);
}

// √a where soft_double_is_plain.
static inline uint64_t soft_double_root(uint64_t a) {
    const uint32_t exponent = soft_double_head(a);
    const uint64_t mantissa = soft_double_mantissa(a) << ((exponent & 1u) ^ 1u);
    const uint32_t high = (uint32_t)(mantissa >> 22);
    const uint32_t inverse = soft_double_inverse_root(high);
    const uint32_t first = soft_double_upper(high, inverse) >> 4; // of 27 bits
    const uint32_t left = (uint32_t)(mantissa - (uint64_t)first * first);
    const uint32_t second = soft_double_upper(left, inverse);
    uint64_t root = ((uint64_t)first << SOFT_DOUBLE_DIGIT) + second;
    int64_t rest = (int64_t)(((uint64_t)left << 54) - ((uint64_t)second * first << 28)
                             - (uint64_t)second * second);
    while (rest < 0) {
        root--;
        rest += (int64_t)(2u * root + 1u);
    }
    while (rest > (int64_t)(2u * root)) {
        rest -= (int64_t)(2u * root + 1u);
        root++;
    }
    const uint64_t head = (exponent + SOFT_DOUBLE_BIAS) / 2u - 1u;
    return (head << 52) + soft_double_round(root, rest != 0);
}

#endif
