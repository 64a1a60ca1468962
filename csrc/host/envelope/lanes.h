// SPDX-License-Identifier: MIT
// The two passes in lanes: a block of the path is cut into LANES equal stretches that advance
// together, so that no addition waits for the one before in its own stretch alone.
//
//      lane 0       lane 1       lane 2       lane 3
//   ├────────────┼────────────┼────────────┼────────────┤
//            ◀──~~~       ◀──~~~       ◀──~~~       ◀───  w behind the block, known
//
// What a lane begins with is found by an overlap (~~~): m nodes of the lane behind it, passed
// once from the least value that is possible there and once from the largest. Rounded addition
// and min are monotone, so the true value lies between the two; where they meet it is known to
// the bit (Keinert et al. 2014, section 4, for the overlap; the certificate is derived in
// docs/parallel.md). A block whose overlaps do not meet within a lane is refused, and planned
// serially.
#ifndef NCK_HOST_ENVELOPE_LANES_H
#define NCK_HOST_ENVELOPE_LANES_H

#include "host/envelope/job.h"    // envelope_count_t
#include "host/envelope/serial.h" // backward_serial forward_serial

#include <string.h> // memcmp memcpy

enum {
    LANES = GROUPS * WIDTH,
    // Bytes of a full lane: an odd multiple of a cache line, so that the lanes do not share its
    // sets.
    LANE_BYTES = 65 * 64,
    LANE_FULL = LANE_BYTES / (int)sizeof(nck_real),
    LANE_LEAST = 4 * TILE,   // shorter lanes do not pay
    TRY_SHORTER = 16,        // blocks between two attempts with half of the overlap
    PATIENCE_MOST = 64       // blocks planned serially between two attempts, at most
};

// The experience of a pass: where the next block begins to try.
typedef struct overlap {
    size_t m;        // nodes, a multiple of TILE
    size_t patience; // blocks to plan serially after a refusal; doubled by the next one
    size_t wait;     // of them still to come
    envelope_count_t *count;
} overlap_t;

static overlap_t overlap_begin(envelope_count_t *count) {
    return (overlap_t){.m = TILE, .patience = 1, .wait = 0, .count = count};
}

// Nodes of a lane if a block is taken out of n nodes; 0 if they are too few.
static size_t lane_length(size_t n) {
    const size_t most = n / LANES / TILE * TILE;
    if (most < LANE_LEAST) return 0;
    return most < LANE_FULL ? most : LANE_FULL;
}

static vector_t zeros(void) {
    const nck_real each[WIDTH] = {0};
    return vector_load(each);
}

// One number of each of WIDTH stretches.
static vector_t gather(const nck_real *x, size_t stride) {
    nck_real each[WIDTH];
    for (size_t k = 0; k < WIDTH; k++) each[k] = x[k * stride];
    return vector_load(each);
}

// Pass the first m nodes of WIDTH lanes backwards, from the least and the largest value.
static void overlap_backward(const nck_real *w_cap, const nck_real *h, size_t lane, size_t m,
                             nck_real *low_out, nck_real *high_out) {
    vector_t high = gather(w_cap + m - 1, lane); // at the node behind, as good as infinite
    vector_t low = zeros();
    vector_t cap[TILE], piece[TILE];
    for (size_t i = m; i > 0; i -= TILE) {
        tile_load(w_cap + i - TILE, lane, cap);
        tile_load(h + i - TILE, lane, piece);
        for (size_t t = TILE; t-- > 0;) {
            high = vector_step(cap[t], high, piece[t]);
            low = vector_step(cap[t], low, piece[t]);
        }
    }
    vector_store(low, low_out);
    vector_store(high, high_out);
}

// Pass the last m pieces of WIDTH lanes forwards. w_back: from the backward pass.
static void overlap_forward(const nck_real *h, const nck_real *w_back, size_t lane, size_t m,
                            nck_real *low_out, nck_real *high_out) {
    vector_t high = gather(w_back + lane - m, lane);
    vector_t low = vector_step(high, zeros(), zeros());
    vector_t cap[TILE], piece[TILE];
    for (size_t i = lane - m; i < lane; i += TILE) {
        tile_load(w_back + i + 1, lane, cap);
        tile_load(h + i, lane, piece);
        for (size_t t = 0; t < TILE; t++) {
            high = vector_step(cap[t], high, piece[t]);
            low = vector_step(cap[t], low, piece[t]);
        }
    }
    vector_store(low, low_out);
    vector_store(high, high_out);
}

// How long an overlap to try after one of m nodes failed; 0: give up.
static size_t overlap_next(size_t m, size_t lane) {
    if (m >= lane) return 0;
    return 2 * m < lane ? 2 * m : lane;
}

// Learn from a block: it was certain with m nodes, or (m = 0) refused.
static void overlap_learn(overlap_t *overlap, size_t m) {
    if (m == 0) {
        overlap->count->refused++;
        overlap->wait = overlap->patience;
        if (overlap->patience < PATIENCE_MOST) overlap->patience *= 2;
        return;
    }
    overlap->count->blocks++;
    overlap->patience = 1;
    if (m > overlap->count->overlap) overlap->count->overlap = m;
    overlap->m = m;
    // Now and then a shorter one is tried again; if it fails, that costs half as much once more.
    if (overlap->count->blocks % TRY_SHORTER == 0 && m >= 2 * TILE) {
        overlap->m = m / 2 / TILE * TILE;
    }
}

// 1 and in w_next[k] what lane k begins with, or 0 if the block is to be planned serially.
// w_next[LANES - 1] is given: what stands behind the block.
static int backward_entry(const nck_real *w_cap, const nck_real *h, size_t lane,
                          overlap_t *overlap, nck_real *w_next) {
    nck_real low[LANES], high[LANES];
    for (size_t m = overlap->m < lane ? overlap->m : lane; m > 0; m = overlap_next(m, lane)) {
        for (size_t k = 0; k < LANES; k += WIDTH) {
            overlap_backward(w_cap + k * lane, h + k * lane, lane, m, low + k, high + k);
        }
        // What lane k begins with is the value at the first node of lane k + 1.
        if (memcmp(low + 1, high + 1, sizeof low - sizeof low[0]) != 0) continue;
        memcpy(w_next, low + 1, sizeof low - sizeof low[0]);
        overlap_learn(overlap, m);
        return 1;
    }
    overlap_learn(overlap, 0);
    return 0;
}

// As backward_entry. w_before[0] is given: what stands at the block's first node.
static int forward_entry(const nck_real *h, const nck_real *w_back, size_t lane,
                         overlap_t *overlap, nck_real *w_before) {
    nck_real low[LANES], high[LANES];
    for (size_t m = overlap->m < lane ? overlap->m : lane; m > 0; m = overlap_next(m, lane)) {
        for (size_t k = 0; k < LANES; k += WIDTH) {
            overlap_forward(h + k * lane, w_back + k * lane, lane, m, low + k, high + k);
        }
        if (memcmp(low, high, sizeof low - sizeof low[0]) != 0) continue;
        memcpy(w_before + 1, low, sizeof low - sizeof low[0]);
        overlap_learn(overlap, m);
        return 1;
    }
    overlap_learn(overlap, 0);
    return 0;
}

static inline void backward_lanes(const nck_real *w_cap, const nck_real *h, size_t lane,
                                  const nck_real *w_next, nck_real *w) {
    vector_t cap[TILE], piece[TILE], before[GROUPS];
    for (size_t g = 0; g < GROUPS; g++) before[g] = vector_load(w_next + g * WIDTH);
    for (size_t i = lane; i > 0; i -= TILE) {
        for (size_t g = 0; g < GROUPS; g++) {
            const size_t first = g * WIDTH * lane + i - TILE;
            tile_load(w_cap + first, lane, cap);
            tile_load(h + first, lane, piece);
            for (size_t t = TILE; t-- > 0;) {
                before[g] = vector_step(cap[t], before[g], piece[t]);
                cap[t] = before[g];
            }
            tile_store(cap, lane, w + first);
        }
    }
}

static inline void forward_lanes(const nck_real *h, size_t lane, const nck_real *w_before,
                                 nck_real *w) {
    vector_t cap[TILE], piece[TILE], before[GROUPS];
    for (size_t g = 0; g < GROUPS; g++) before[g] = vector_load(w_before + g * WIDTH);
    for (size_t i = 0; i < lane; i += TILE) {
        for (size_t g = 0; g < GROUPS; g++) {
            const size_t first = g * WIDTH * lane + i;
            tile_load(w + first + 1, lane, cap);
            tile_load(h + first, lane, piece);
            for (size_t t = 0; t < TILE; t++) {
                before[g] = vector_step(cap[t], before[g], piece[t]);
                cap[t] = before[g];
            }
            tile_store(cap, lane, w + first + 1);
        }
    }
}

// Backward over a block; as backward_serial.
static void backward_block(const nck_real *w_cap, const nck_real *h, size_t lane, nck_real w_behind,
                           overlap_t *overlap, nck_real *w) {
    nck_real w_next[LANES];
    w_next[LANES - 1] = w_behind;
    if (overlap->wait > 0) {
        overlap->wait--;
    } else if (backward_entry(w_cap, h, lane, overlap, w_next)) {
        if (lane == LANE_FULL) { // distances that the compiler knows
            backward_lanes(w_cap, h, LANE_FULL, w_next, w);
        } else {
            backward_lanes(w_cap, h, lane, w_next, w);
        }
        return;
    }
    backward_serial(w_cap, h, LANES * lane, w_behind, w);
}

// Forward over a block; as forward_serial.
static void forward_block(const nck_real *h, size_t lane, overlap_t *overlap, nck_real *w) {
    nck_real w_before[LANES];
    w_before[0] = w[0];
    if (overlap->wait > 0) {
        overlap->wait--;
    } else if (forward_entry(h, w, lane, overlap, w_before)) {
        if (lane == LANE_FULL) {
            forward_lanes(h, LANE_FULL, w_before, w);
        } else {
            forward_lanes(h, lane, w_before, w);
        }
        return;
    }
    forward_serial(h, LANES * lane, w);
}

// Backward over n nodes in blocks, from the last one; as backward_serial.
static void backward_pass(const nck_real *w_cap, const nck_real *h, size_t n, nck_real w_behind,
                          overlap_t *overlap, nck_real *w) {
    size_t end = n;
    for (size_t lane = lane_length(end); lane > 0; lane = lane_length(end)) {
        end -= LANES * lane;
        backward_block(w_cap + end, h + end, lane, w_behind, overlap, w + end);
        w_behind = w[end];
    }
    backward_serial(w_cap, h, end, w_behind, w);
}

// Forward over n pieces in blocks; as forward_serial.
static void forward_pass(const nck_real *h, size_t n, overlap_t *overlap, nck_real *w) {
    size_t begin = 0;
    for (size_t lane = lane_length(n); lane > 0; lane = lane_length(n - begin)) {
        forward_block(h + begin, lane, overlap, w + begin);
        begin += LANES * lane;
    }
    forward_serial(h + begin, n - begin, w + begin);
}

#endif
