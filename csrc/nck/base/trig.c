// SPDX-License-Identifier: MIT
// Inlined, a sine and cosine takes 470 bytes of flash wherever an arc is looked at.
#include "nck/base/bits.h" // no fused operations

#include "nck/base/trig.h"

#include "nck/base/trig_math.h" // nck_trig_sincos nck_trig_atan2

void nck_sincos(double x, double *sin_out, double *cos_out) {
    nck_trig_sincos(x, sin_out, cos_out);
}

double nck_atan2(double y, double x) {
    return nck_trig_atan2(y, x);
}
