// SPDX-License-Identifier: MIT
// The exact two-pass envelope in v², one step each way: what every backend computes.
#ifndef NCK_BASE_ENVELOPE_MATH_H
#define NCK_BASE_ENVELOPE_MATH_H

#include "nck/base/real.h" // nck_real

// What acceleration a changes v² by over a length:   h = 2·a·length
// (Cao et al. 2014, eq. 6). This order of the product is part of the contract of equal bits.
static inline nck_real nck_envelope_h(nck_real a, nck_real length) {
    return (nck_real)2 * a * length;
}

// One step of the exact two-pass envelope, vv = v²; the order of the operations is the definition.
//   backward  vv_i = min(vv_cap,i, vv_{i+1} + h_i)    forward  vv_{i+1} = min(vv_{i+1}, vv_i + h_i)
// (Cao et al. 2014, eq. 13 in both directions.)
static inline nck_real nck_envelope_backward(nck_real vv_cap, nck_real vv_next, nck_real h) {
    const nck_real reach = vv_next + h;
    return reach < vv_cap ? reach : vv_cap;
}

// The forward step: see above.
static inline nck_real nck_envelope_forward(nck_real vv, nck_real vv_before, nck_real h) {
    const nck_real reach = vv_before + h;
    return reach < vv ? reach : vv;
}

#endif
