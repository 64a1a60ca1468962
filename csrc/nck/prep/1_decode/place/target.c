// SPDX-License-Identifier: MIT
// Where the axis words of a line lead.
#include "nck/prep/1_decode/place/parts.h"
#include "nck/prep/1_decode/number/number.h" // nck_decode_axis_word nck_decode_beyond …
#include "nck/base/real.h" // nck_real_of

#include <string.h> // memcpy

nck_status_t nck_decode_target(nck_decode_t *self, int absolute, int64_t *target_nm) {
    memcpy(target_nm, self->place.position_nm, sizeof self->place.position_nm);
    uint32_t axes = self->words.axes;
    if (self->layout.on != 0 && !absolute) {
        const nck_status_t status = nck_layout_target(self, target_nm);
        if (status != NCK_OK) return status;
        axes &= ~(uint32_t)7;
    }
    for (unsigned axis = 0; axes != 0; axis++, axes >>= 1) {
        int64_t value = 0;
        if (!(axes & 1u)) continue;
        const nck_status_t status = nck_decode_axis_word(self, axis, &value);
        if (status != NCK_OK) return status;
        if (!absolute) {
            value += self->modal.incremental ? self->place.position_nm[axis]
                                             : self->place.origin_nm[axis];
        }
        const int64_t limit = nck_decode_scale_of(self, axis)->limit;
        if (value < -limit || value > limit) {
            return nck_decode_beyond(self, axis, nck_real_of(value), 1.0);
        }
        target_nm[axis] = value;
    }
    return NCK_OK;
}
