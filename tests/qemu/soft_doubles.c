// SPDX-License-Identifier: MIT
// On a core without doubles: what the compiler calls gives the library's bits, whatever the
// operands. Exit status: 0; 1 a quotient, 2 a root, 3 a comparison that differs.
#include <math.h>   // sqrt
#include <stdint.h> // uint64_t
#include <string.h> // memcpy

enum { ROUNDS = 100000 };

// The library's own, which firmware_sim/soft_double is put before.
uint64_t library_divide(uint64_t a, uint64_t b) __asm__("__real___aeabi_ddiv");
double library_sqrt(double a) __asm__("__real_sqrt");
int library_less(uint64_t a, uint64_t b) __asm__("__real___aeabi_dcmplt");
int library_more(uint64_t a, uint64_t b) __asm__("__real___aeabi_dcmpgt");
int library_most(uint64_t a, uint64_t b) __asm__("__real___aeabi_dcmple");
int library_least(uint64_t a, uint64_t b) __asm__("__real___aeabi_dcmpge");
int library_same(uint64_t a, uint64_t b) __asm__("__real___aeabi_dcmpeq");

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

static const uint64_t strange[] = {
    0x0000000000000000u, 0x8000000000000000u, // zeros
    0x0000000000000001u, 0x800fffffffffffffu, 0x0010000000000000u, // subnormal, and the first above
    0x3ff0000000000000u, 0xbff0000000000001u, 0x7fefffffffffffffu, // 1, below −1, the largest
    0x7ff0000000000000u, 0xfff0000000000000u, // infinities
    0x7ff8000000000000u, 0xfff8000000000123u, 0x7ff0000000000001u, // NaN, a signalling one
};
enum { STRANGE = sizeof strange / sizeof *strange };

// xorshift64 (Marsaglia 2003); every eighth number is a strange one.
static uint64_t pick(uint64_t *state) {
    *state ^= *state << 13;
    *state ^= *state >> 7;
    *state ^= *state << 17;
    return *state >> 61 == 0 ? strange[*state % STRANGE] : *state;
}

static int try(uint64_t a, uint64_t b) {
    const double x = number_of(a);
    const double y = number_of(b);
    if (bits_of(x / y) != library_divide(a, b)) return 1;
    if (bits_of(sqrt(x)) != bits_of(library_sqrt(x))) return 2;
    const int agrees = (x < y) == library_less(a, b) && (x > y) == library_more(a, b)
                       && (x <= y) == library_most(a, b) && (x >= y) == library_least(a, b)
                       && (x == y) == library_same(a, b);
    return agrees ? 0 : 3;
}

int main(void) {
    int status = 0;
    for (unsigned k = 0; k < STRANGE * STRANGE && status == 0; k++) {
        status = try(strange[k / STRANGE], strange[k % STRANGE]);
    }
    uint64_t state = 88172645463325252u;
    for (int k = 0; k < ROUNDS && status == 0; k++) {
        const uint64_t a = pick(&state);
        status = try(a, pick(&state));
    }
    return status;
}
