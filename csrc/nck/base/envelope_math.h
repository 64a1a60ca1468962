// SPDX-License-Identifier: MIT
// The exact two-pass envelope in w = v², one step each way: what every backend computes.
#ifndef NCK_BASE_ENVELOPE_MATH_H
#define NCK_BASE_ENVELOPE_MATH_H

#include "nck/base/real.h" // nck_real

// What acceleration a changes v² by over a length:   h = 2·a·length
// (Cao et al. 2014, eq. 6). This order of the product is part of the contract of equal bits.
static inline nck_real nck_envelope_h(nck_real a, nck_real length) {
    return (nck_real)2 * a * length;
}

// One step of the exact two-pass envelope in w = v²; the order of the operations is the definition.
//   backward  w_i = min(w_cap,i, w_{i+1} + h_i)        forward  w_{i+1} = min(w_{i+1}, w_i + h_i)
// (Cao et al. 2014, eq. 13 in both directions.)
static inline nck_real nck_envelope_backward(nck_real w_cap, nck_real w_next, nck_real h) {
    const nck_real reach = w_next + h;
    return reach < w_cap ? reach : w_cap;
}

// The forward step: see above.
static inline nck_real nck_envelope_forward(nck_real w, nck_real w_before, nck_real h) {
    const nck_real reach = w_before + h;
    return reach < w ? reach : w;
}

#endif
