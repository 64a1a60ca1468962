// SPDX-License-Identifier: MIT
// The linking vector angle at a junction: 0 is tangent-continuous, π a reversal. Directions in a
// plane are given as out[0] = cos, out[1] = sin of the forward angle from the plane's first axis.
#ifndef NCK_HOST_ANGLE_MATH_H
#define NCK_HOST_ANGLE_MATH_H

#include "nck/base/real.h"      // nck_real nck_sqrt nck_fabs
#include "nck/base/records.h"   // NCK_AXIS_MAX
#include "nck/base/trig_math.h" // what nck_atan2 stands for

// Two vectors in space, of any length but 0:
//   cos α = d1·d2 / (|d1||d2|)     (Cao et al. 2014, eq. 1)
// taken as atan2(|d1×d2|, d1·d2): the arc cosine has lost half of its digits near 0 and π.
static inline nck_real nck_angle_space(const nck_real *d1, const nck_real *d2) {
    const nck_real x = d1[1] * d2[2] - d1[2] * d2[1];
    const nck_real y = d1[2] * d2[0] - d1[0] * d2[2];
    const nck_real z = d1[0] * d2[1] - d1[1] * d2[0];
    const nck_real dot = d1[0] * d2[0] + d1[1] * d2[1] + d1[2] * d2[2];
    return nck_atan2(nck_sqrt(x * x + y * y + z * z), dot);
}

// Two unit tangents over all axes:   α = 2 atan2(|t1 − t2|, |t1 + t2|)
// (W. Kahan, How Futile are Mindless Assessments of Roundoff, 2006, section 12). Full precision at
// 0 and π in any number of axes, where a cross product does not exist.
static inline nck_real nck_angle_tangents(const nck_real *t1, const nck_real *t2) {
    nck_real apart = (nck_real)0;
    nck_real along = (nck_real)0;
    for (int x = 0; x < NCK_AXIS_MAX; x++) {
        apart += (t1[x] - t2[x]) * (t1[x] - t2[x]);
        along += (t1[x] + t2[x]) * (t1[x] + t2[x]);
    }
    return (nck_real)2 * nck_atan2(nck_sqrt(apart), nck_sqrt(along));
}

// Forward direction of a line in the plane (u, w), of the length L > 0:
//   cos = (u_i − u_{i−1})/L,  sin = (w_i − w_{i−1})/L     (Cao et al. 2014, eq. 2)
static inline void nck_angle_line(nck_real du, nck_real dw, nck_real *out) {
    const nck_real length = nck_sqrt(du * du + dw * dw);
    out[0] = du / length;
    out[1] = dw / length;
}

// Forward direction of an arc at the point from which the centre lies at (I_u, I_w), R = |I| > 0:
//
//         ▲ forward        anticlockwise (+1)  (cos, sin) = ( I_w, −I_u)/R
//   I     │                clockwise     (−1)  (cos, sin) = (−I_w,  I_u)/R
//  ●◀─────┘                (Cao et al. 2014, eqs. 3 and 4)
//
// At the arc's end the same, with the centre's offset taken from the end point.
static inline void nck_angle_arc(nck_real i_u, nck_real i_w, nck_real turn, nck_real *out) {
    const nck_real r = nck_sqrt(i_u * i_u + i_w * i_w);
    out[0] = turn < (nck_real)0 ? -i_w / r : i_w / r;
    out[1] = turn < (nck_real)0 ? i_u / r : -i_u / r;
}

// The angle between two forward directions of a plane, by the addition theorems:
//   sin = s2·c1 − c2·s1,  cos = c2·c1 + s2·s1,  α = |atan2(sin, cos)|     (Cao et al. 2014, eq. 5)
static inline nck_real nck_angle_plane(const nck_real *in, const nck_real *out) {
    const nck_real sine = out[1] * in[0] - out[0] * in[1];
    const nck_real cosine = out[0] * in[0] + out[1] * in[1];
    return nck_atan2(nck_fabs(sine), cosine);
}

#endif
