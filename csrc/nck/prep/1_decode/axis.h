// SPDX-License-Identifier: MIT
// The scales of axis words.
#ifndef NCK_PREP_DECODE_AXIS_H
#define NCK_PREP_DECODE_AXIS_H

#include "nck/prep/1_decode/decode.h" // nck_decode_t

// The scale of an axis' words. Cost: constant.
static inline const nck_scale_t *nck_decode_scale_of(const nck_decode_t *self, unsigned axis) {
    if (axis == NCK_AXIS_X) return &self->place.scale[1];
    return &self->place.scale[self->place.rotary >> axis & 1u ? 2 : 0];
}

#endif
