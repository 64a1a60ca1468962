// SPDX-License-Identifier: MIT
// The exact envelope one node after the other: the definition that all other passes must equal to
// the bit. A pass is one chain of additions and comparisons, each of which waits for the one
// before.
#ifndef NCK_HOST_ENVELOPE_SERIAL_H
#define NCK_HOST_ENVELOPE_SERIAL_H

#include <stddef.h> // size_t
#include <stdint.h> // uint32_t uint64_t
#include <string.h> // memcpy

#include "nck/base/envelope_math.h" // nck_envelope_backward nck_envelope_forward

static int is_good(nck_real x) {
    return x >= 0 && x - x == 0; // infinity − infinity is NaN
}

// The sign bit of what these return is set if one of n numbers is NaN, infinite or negative (−0
// too): the exponent of the first two is all ones, so that one more carries into the sign.
static uint32_t doubt_float(const void *x, size_t n) {
    uint32_t doubt = 0;
    for (size_t i = 0; i < n; i++) {
        uint32_t bits;
        memcpy(&bits, (const char *)x + i * sizeof bits, sizeof bits);
        doubt |= bits | (bits + (1u << 23));
    }
    return doubt;
}

static uint64_t doubt_double(const void *x, size_t n) {
    uint64_t doubt = 0;
    for (size_t i = 0; i < n; i++) {
        uint64_t bits;
        memcpy(&bits, (const char *)x + i * sizeof bits, sizeof bits);
        doubt |= bits | (bits + ((uint64_t)1 << 52));
    }
    return doubt;
}

// 1 if all of n numbers are good. The loops above become vectors; where they doubt, one by one.
static int all_good(const nck_real *x, size_t n) {
    const int doubt = sizeof *x == sizeof(float) ? doubt_float(x, n) >> 31 != 0
                                                 : doubt_double(x, n) >> 63 != 0;
    if (!doubt) return 1;
    size_t i = 0;
    while (i < n && is_good(x[i])) i++;
    return i == n;
}

// Backward over n nodes; vv_next: vv at the node behind them. Returns vv at the first one.
static nck_real backward_serial(const nck_real *vv_cap, const nck_real *h, size_t n,
                                nck_real vv_next, nck_real *vv) {
    for (size_t i = n; i-- > 0;) {
        vv_next = nck_envelope_backward(vv_cap[i], vv_next, h[i]);
        vv[i] = vv_next;
    }
    return vv_next;
}

// Forward over n pieces. vv: n + 1 nodes, the first of them final.
static void forward_serial(const nck_real *h, size_t n, nck_real *vv) {
    nck_real vv_before = vv[0];
    for (size_t i = 0; i < n; i++) {
        vv_before = nck_envelope_forward(vv[i + 1], vv_before, h[i]);
        vv[i + 1] = vv_before;
    }
}

#endif
