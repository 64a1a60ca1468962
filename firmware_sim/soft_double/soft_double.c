// SPDX-License-Identifier: MIT
// What a compiler for a core without doubles calls for a/b, √a and a < b, faster than its library
// does it: soft_double.cmake puts these between. The rest, and what is not normal, stays with the
// library, whose bits these are.
#include "soft_double/soft_double.h"

#include <string.h> // memcpy

// The run-time ABI for the Arm architecture passes doubles in pairs of core registers, as it does
// words of 64 bits; √a comes in a register of the floating-point unit. The linker's --wrap makes
// the names: of the library, and of what it takes in its place.
#define LIBRARY(name) __asm__("__real_" #name)
#define IN_PLACE_OF(name) __asm__("__wrap_" #name)

uint64_t soft_double_divide_there(uint64_t a, uint64_t b) LIBRARY(__aeabi_ddiv);
uint64_t soft_double_divide(uint64_t a, uint64_t b) IN_PLACE_OF(__aeabi_ddiv);
double soft_double_sqrt_there(double a) LIBRARY(sqrt);
double soft_double_sqrt(double a) IN_PLACE_OF(sqrt);
int soft_double_less_there(uint64_t a, uint64_t b) LIBRARY(__aeabi_dcmplt);
int soft_double_less(uint64_t a, uint64_t b) IN_PLACE_OF(__aeabi_dcmplt);
int soft_double_more_there(uint64_t a, uint64_t b) LIBRARY(__aeabi_dcmpgt);
int soft_double_more(uint64_t a, uint64_t b) IN_PLACE_OF(__aeabi_dcmpgt);
int soft_double_most_there(uint64_t a, uint64_t b) LIBRARY(__aeabi_dcmple);
int soft_double_most(uint64_t a, uint64_t b) IN_PLACE_OF(__aeabi_dcmple);
int soft_double_least_there(uint64_t a, uint64_t b) LIBRARY(__aeabi_dcmpge);
int soft_double_least(uint64_t a, uint64_t b) IN_PLACE_OF(__aeabi_dcmpge);
int soft_double_same_there(uint64_t a, uint64_t b) LIBRARY(__aeabi_dcmpeq);
int soft_double_same(uint64_t a, uint64_t b) IN_PLACE_OF(__aeabi_dcmpeq);

uint64_t soft_double_divide(uint64_t a, uint64_t b) {
    if (!soft_double_divides(a, b)) return soft_double_divide_there(a, b);
    return soft_double_quotient(a, b);
}

double soft_double_sqrt(double a) {
    uint64_t bits;
    memcpy(&bits, &a, sizeof bits);
    if (!soft_double_is_plain(bits)) return soft_double_sqrt_there(a);
    bits = soft_double_root(bits);
    memcpy(&a, &bits, sizeof bits);
    return a;
}

int soft_double_less(uint64_t a, uint64_t b) {
    return soft_double_compares(a, b) ? a < b : soft_double_less_there(a, b);
}

int soft_double_more(uint64_t a, uint64_t b) {
    return soft_double_compares(a, b) ? a > b : soft_double_more_there(a, b);
}

int soft_double_most(uint64_t a, uint64_t b) {
    return soft_double_compares(a, b) ? a <= b : soft_double_most_there(a, b);
}

int soft_double_least(uint64_t a, uint64_t b) {
    return soft_double_compares(a, b) ? a >= b : soft_double_least_there(a, b);
}

int soft_double_same(uint64_t a, uint64_t b) {
    return soft_double_compares(a, b) ? a == b : soft_double_same_there(a, b);
}
