// SPDX-License-Identifier: MIT
// Inside room 4: whether the path is faster with a stop at a junction.
#ifndef NCK_PREP_STOP_H
#define NCK_PREP_STOP_H

#include "nck/prep/4_lookahead/joint.h" // nck_joint_t nck_terms_t

// 1 if the path better stops at the junction of this load [s²/mm] between two segs. Under a jerk
// limit: if it is alone, and even what little acceleration can be reached next to a standstill is
// worth more than its speed. Cost: constant.
int nck_stop_pays(const nck_joint_t *in, const nck_joint_t *out, double load,
                  const nck_terms_t *terms);

#endif
