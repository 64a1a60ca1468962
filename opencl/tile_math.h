// SPDX-License-Identifier: MIT
// The two passes of the envelope over one tile: lanes side by side, each a stretch of the path.
//
//   vv_cap, h, vv ──▶ │ lane 0      │ lane 1      │ …
//                   ├─────────────┼─────────────┼──
//                   first         first + length
#ifndef OPENCL_TILE_MATH_H
#define OPENCL_TILE_MATH_H

#include "lanes_math.h"                         // LANES lanes_t (of the float or the double folder)
#include "nck/base/envelope_math.h" // nck_envelope_backward for one number

// The same formulas once more, for lanes: the text of the header is the only definition.
#undef NCK_BASE_ENVELOPE_MATH_H
#define nck_real lanes_t
#define nck_envelope_h lanes_envelope_h
#define nck_envelope_backward lanes_envelope_backward
#define nck_envelope_forward lanes_envelope_forward
#include "nck/base/envelope_math.h"
#undef nck_real
#undef nck_envelope_h
#undef nck_envelope_backward
#undef nck_envelope_forward

static inline lanes_t tile_load(__global const nck_real *x) {
    return *(__global const lanes_packed_t *)x;
}

static inline void tile_store(__global nck_real *x, lanes_t lanes) {
    *(__global lanes_packed_t *)x = lanes;
}

// Look at every number of a tile: 1 if one is no good. This also brings the tile into the cache, vv
// too: in order, which memory serves faster than the ends of many lanes in turn (measured: twice as
// fast at 10⁷ nodes).
static inline int tile_has_bad(__global const nck_real *vv_cap, __global const nck_real *h,
                               long length, __global nck_real *vv) {
    lanes_bits_t doubt = 0;
    for (long i = 0; i < LANES * length; i += LANES) {
        (void)*(volatile __global nck_real *)(vv + i);
        doubt |= lanes_doubt(lanes_bits(tile_load(vv_cap + i)));
        doubt |= lanes_doubt(lanes_bits(tile_load(h + i)));
    }
    return lanes_any_sign(doubt);
}

// Backward over lanes of length nodes; vv_next: vv behind the end of every lane. The pointers stand
// at the tile's first node.
static inline void tile_backward(__global const nck_real *vv_cap, __global const nck_real *h,
                                 long length, lanes_t vv_next, __global nck_real *vv) {
    for (long i = length - LANES; i >= 0; i -= LANES) {
        lanes_t cap[LANES];
        lanes_t rise[LANES];
        for (int lane = 0; lane < LANES; lane++) {
            cap[lane] = tile_load(vv_cap + lane * length + i);
            rise[lane] = tile_load(h + lane * length + i);
        }
        lanes_transpose(cap);
        lanes_transpose(rise);
        for (int k = LANES - 1; k >= 0; k--) {
            vv_next = lanes_envelope_backward(cap[k], vv_next, rise[k]);
            cap[k] = vv_next;
        }
        lanes_transpose(cap);
        for (int lane = 0; lane < LANES; lane++) tile_store(vv + lane * length + i, cap[lane]);
    }
}

// Forward over lanes of length nodes, in place; vv_before: the final vv at the node before every
// lane. h stands at the piece before the tile's first node.
static inline void tile_forward(__global const nck_real *h, long length, lanes_t vv_before,
                                __global nck_real *vv) {
    for (long i = 0; i < length; i += LANES) {
        lanes_t back[LANES];
        lanes_t rise[LANES];
        for (int lane = 0; lane < LANES; lane++) {
            back[lane] = tile_load(vv + lane * length + i);
            rise[lane] = tile_load(h + lane * length + i);
        }
        lanes_transpose(back);
        lanes_transpose(rise);
        for (int k = 0; k < LANES; k++) {
            vv_before = lanes_envelope_forward(back[k], vv_before, rise[k]);
            back[k] = vv_before;
        }
        lanes_transpose(back);
        for (int lane = 0; lane < LANES; lane++) tile_store(vv + lane * length + i, back[lane]);
    }
}

#endif
