// SPDX-License-Identifier: MIT
// The jerk-limited profile over a window of cells, from a moving start to rest: hull – forward and
// backward – hull (README, section "Jerk"). Every array is the caller's; work comes in bounded
// steps, so that a window in firmware and a whole program on a host are planned by the same lines.
#ifndef NCK_PREP_PROFILE_H
#define NCK_PREP_PROFILE_H

#include <stdint.h> // uint32_t

#include "nck/base/status.h" // nck_status_t

// A profile in work: arrays of the caller, and where its passes stand.
typedef struct nck_profile {
    // the problem; set before nck_profile_begin
    uint32_t n;     // cells, 1 at least; nodes 0 … n
    double *h;      // n: length of every cell, positive [mm]
    double *vv_cap; // n + 1: cap at every node, v²; 0: rest. The last is taken as 0
    double *a_max;  // n: acceleration [mm/s²], positive
    double *j_max;  // n: jerk [mm/s³], positive
    double q_cap;   // longest duration of a cell that counts in rule R [s], positive
    uint32_t count; // nodes that are worth the best, if the build has it (NCK_HAS_BEST)
    double v;      // speed at node 0 [mm/s]
    double a;      // acceleration of the cell before node 0 [mm/s²]
    double q;      // its duration [s]; 0 if the path rested there

    // the answer
    double *vv;     // n + 1: v² at every node

    // work
    double *s;     // n + 1: path coordinate
    double *up;    // n: bound on acceleration
    double *down;  // n: bound on deceleration
    double *e;     // n + 1: envelope
    double *z;     // n + 1: envelope plus what its slope may fall
    double *j;     // n + 1: jerk at every node, the smaller of both cells'; 0 at the ends
    uint32_t *stack; // n + 1: corners of the hull

    // the pass in work; what one pass carries does not stand side by side: a compiler would pack it
    double v_last; // speed at the node done last
    uint32_t phase;
    uint32_t i;    // next node or cell of the pass
    double sigma;  // sum of what the slope may fall so far
    double a_last; // acceleration of the cell done last
    uint32_t top;  // corners on the stack, or the edge in use
    uint32_t last;  // cell where the limit of acceleration steps last; UINT32_MAX: it does not
    uint32_t first; // node that its ramps change first; n + 1: none
    uint32_t fresh;  // 1: node i has not been looked at yet
    double share;  // of the cell done last
    uint32_t broken; // 1: the entry speed comes to nothing within the jerk: no plan from here
    uint32_t sharp;  // 1: the last hull takes much off
    uint32_t slows;  // 1: the jerk has kept the acceleration negative from the entry on
    double fall;   // what the slope may fall so far, summed over length
} nck_profile_t;

// Begin to plan. Cost: constant. Context: any one context.
void nck_profile_begin(nck_profile_t *self);

// Do at most `budget` units of work, a node of a pass each. Returns NCK_OK (call again) or NCK_DONE
// (vv is the plan). The whole takes 17 passes, 24·n units at most. Context: any one context.
nck_status_t nck_profile_step(nck_profile_t *self, uint32_t budget);

// 1 if the plan goes on from the entry state within rule R: speed met, no change of acceleration
// beyond the jerk. Cost: constant. Context: any one context.
int nck_profile_joins(const nck_profile_t *self);

#endif
