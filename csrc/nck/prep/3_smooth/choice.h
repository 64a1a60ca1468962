// SPDX-License-Identifier: MIT
// Inside room 3: what a corner becomes, by the time that it takes: a bend of the spline, a blend of
// its own, or a stop.
#ifndef NCK_PREP_CHOICE_H
#define NCK_PREP_CHOICE_H

#include "nck/prep/3_smooth/smooth.h" // nck_smooth_t nck_raw_t

typedef enum nck_choice_kind {
    NCK_CHOICE_SPLINE = 0,
    NCK_CHOICE_BLEND, // README, section "Corners"
    NCK_CHOICE_STOP   // at the corner itself
} nck_choice_kind_t;

// What a corner becomes, and what it is like.
typedef struct nck_choice {
    uint32_t kind;            // nck_choice_kind_t
    double d, parking;        // of a blend: half-width d, length D in between [path mm]
    double in[NCK_AXIS_MAX];  // dp/ds of both blocks where they meet
    double out[NCK_AXIS_MAX];
} nck_choice_t;

// Choose for the corner where b follows a. A blend may reach `room` into either [path mm]; 0: none
// is wanted.
// Cost: some 100 square roots at a sharp corner, constant elsewhere.
void nck_choice_make(const nck_smooth_t *self, const nck_raw_t *a, const nck_raw_t *b, double room,
                     nck_choice_t *choice);

#endif
