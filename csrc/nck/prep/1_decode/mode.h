// SPDX-License-Identifier: MIT
// What G64 without P means.
#ifndef NCK_PREP_DECODE_MODE_H
#define NCK_PREP_DECODE_MODE_H

#include "nck/prep/1_decode/decode.h" // nck_decode_t

// The tolerance of a path that no G64 P says one of [mm]. Cost: constant. Context: prep.
static inline double nck_decode_plain_mm(const nck_decode_t *self) {
    const double chosen = self->modal.plain_mm;
    return chosen < 0.0 ? self->machine->path.tolerance : chosen;
}

#endif
