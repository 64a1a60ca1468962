// SPDX-License-Identifier: MIT
// Both passes of a block in lanes: it is cut into LANES equal stretches that advance together, so
// that no addition waits for the one before in its own stretch alone.
//
//      lane 0       lane 1       lane 2       lane 3
//   ├────────────┼────────────┼────────────┼────────────┤
//            ◀──~~~       ◀──~~~       ◀──~~~       ◀───  v² behind the block, known
//   ───▶      ~~~───▶      ~~~───▶      ~~~───▶           v² before the block, known
//
// What a lane begins with is found by an overlap (~~~): m nodes of the lane beside it, passed
// once from the least value that is possible there and once from the largest. Rounded addition
// and min are monotone, so the true value lies between the two; where they meet it is known to
// the bit (Keinert et al. 2014, section 4, for the overlap; the certificate is derived in
// docs/parallel.md). A block whose overlaps do not meet within a lane is refused, and planned
// serially.
//
//   vv_cap h ─▶ turned ─▶ backward ─▶ desk: lanes of vv and h ─▶ forward ─▶ turned back ─▶ vv
//
// Numbers are turned once on their way in and once on their way out; in between they stay in the
// nearest caches. Numbers are looked at on their way in, before anything is written to vv.
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
    LANE_LEAST = 4 * TILE,                   // shorter lanes do not pay
    LINE = 64 / (int)sizeof(nck_real),       // numbers of a cache line
    TRY_SHORTER = 16,        // blocks between two attempts with half of the overlap
    PATIENCE_MOST = 64       // blocks planned serially between two attempts, at most
};

// A stretch of a path, each node with the piece behind it, and what is known beside it.
typedef struct stretch {
    const nck_real *vv_cap, *h;
    nck_real *vv;
    size_t n;             // nodes
    nck_real vv_behind;   // the backward pass' value at the node behind it
    nck_real vv_before;   // the final value at the node before it
    nck_real h_before;    // piece between that and the first node
    int more;             // 1: as many nodes follow; they are brought near meanwhile
} stretch_t;

// What lies between the two passes of a block: number i of WIDTH lanes side by side.
typedef struct desk {
    vector_t vv[GROUPS][LANE_FULL]; // the backward pass' values
    vector_t h[GROUPS][LANE_FULL];
} desk_t;

// The experience of a path's blocks: where the next one begins to try.
typedef struct overlap {
    size_t back, fore; // nodes, multiples of TILE
    size_t patience; // blocks to plan serially after a refusal; doubled by the next one
    size_t wait;     // of them still to come
    envelope_count_t *count;
} overlap_t;

static overlap_t overlap_begin(envelope_count_t *count) {
    return (overlap_t){.back = TILE, .fore = TILE, .patience = 1, .wait = 0, .count = count};
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
static void overlap_backward(const nck_real *vv_cap, const nck_real *h, size_t lane, size_t m,
                             nck_real *low_out, nck_real *high_out) {
    vector_t high = gather(vv_cap + m - 1, lane); // at the node behind, as good as infinite
    vector_t low = zeros();
    vector_t cap[TILE], piece[TILE];
    for (size_t i = m; i > 0; i -= TILE) {
        tile_load(vv_cap + i - TILE, lane, cap);
        tile_load(h + i - TILE, lane, piece);
        for (size_t t = TILE; t-- > 0;) {
            high = vector_step(cap[t], high, piece[t]);
            low = vector_step(cap[t], low, piece[t]);
        }
    }
    vector_store(low, low_out);
    vector_store(high, high_out);
}

// Pass the last m nodes of every lane forwards, over what the backward pass has left.
static void overlap_forward(const desk_t *desk, size_t lane, size_t m, nck_real *low_out,
                            nck_real *high_out) {
    for (size_t g = 0; g < GROUPS; g++) {
        const vector_t *const vv = desk->vv[g];
        const vector_t *const h = desk->h[g];
        vector_t high = vv[lane - m];
        vector_t low = vector_step(high, zeros(), zeros());
        for (size_t i = lane - m + 1; i < lane; i++) {
            high = vector_step(vv[i], high, h[i - 1]);
            low = vector_step(vv[i], low, h[i - 1]);
        }
        vector_store(low, low_out + g * WIDTH);
        vector_store(high, high_out + g * WIDTH);
    }
}

// How long an overlap to try after one of m nodes failed; 0: give up.
static size_t overlap_next(size_t m, size_t lane) {
    if (m >= lane) return 0;
    return 2 * m < lane ? 2 * m : lane;
}

// A block was refused.
static void overlap_refuse(overlap_t *overlap) {
    overlap->count->refused++;
    overlap->wait = overlap->patience;
    if (overlap->patience < PATIENCE_MOST) overlap->patience *= 2;
}

// A block was certain in both directions. Now and then a shorter overlap is tried again; if it
// fails, that costs half as much once more.
static void overlap_learn(overlap_t *overlap) {
    const size_t longer = overlap->back > overlap->fore ? overlap->back : overlap->fore;
    overlap->count->blocks++;
    overlap->patience = 1;
    if (longer > overlap->count->overlap) overlap->count->overlap = longer;
    if (overlap->count->blocks % TRY_SHORTER != 0) return;
    if (overlap->back >= 2 * TILE) overlap->back = overlap->back / 2 / TILE * TILE;
    if (overlap->fore >= 2 * TILE) overlap->fore = overlap->fore / 2 / TILE * TILE;
}

// 1 and in vv_next[k] what lane k begins with, or 0 if the block is to be planned serially.
static int backward_entry(const stretch_t *block, size_t lane, overlap_t *overlap,
                          nck_real *vv_next) {
    const nck_real *const vv_cap = block->vv_cap;
    const nck_real *const h = block->h;
    nck_real low[LANES], high[LANES];
    vv_next[LANES - 1] = block->vv_behind;
    for (size_t m = overlap->back < lane ? overlap->back : lane; m > 0;
         m = overlap_next(m, lane)) {
        for (size_t k = 0; k < LANES; k += WIDTH) {
            overlap_backward(vv_cap + k * lane, h + k * lane, lane, m, low + k, high + k);
        }
        // What lane k begins with is the value at the first node of lane k + 1.
        if (memcmp(low + 1, high + 1, sizeof low - sizeof low[0]) != 0) continue;
        memcpy(vv_next, low + 1, sizeof low - sizeof low[0]);
        overlap->back = m;
        return 1;
    }
    return 0;
}

// As backward_entry, of the nodes before the lanes.
static int forward_entry(const stretch_t *block, const desk_t *desk, size_t lane,
                         overlap_t *overlap, nck_real *vv_before) {
    nck_real low[LANES], high[LANES];
    vv_before[0] = block->vv_before;
    for (size_t m = overlap->fore < lane ? overlap->fore : lane; m > 0;
         m = overlap_next(m, lane)) {
        overlap_forward(desk, lane, m, low, high);
        if (memcmp(low, high, sizeof low - sizeof low[0]) != 0) continue;
        memcpy(vv_before + 1, low, sizeof low - sizeof low[0]);
        overlap->fore = m;
        return 1;
    }
    return 0;
}

// Ask for as much of the next block as one turn of the lanes takes of this one.
static inline void bring_near(const nck_real *vv_cap, const nck_real *h) {
    for (size_t k = 0; k < LANES * TILE; k += LINE) {
        __builtin_prefetch(vv_cap + k);
        __builtin_prefetch(h + k);
    }
}

// Backward into the desk. Returns 1 if a number may be bad.
static inline int backward_lanes(const stretch_t *block, size_t lane, const nck_real *vv_next,
                                 desk_t *desk) {
    const nck_real *const vv_cap = block->vv_cap;
    const nck_real *const h = block->h;
    const int more = block->more;
    vector_t cap[TILE], piece[TILE], before[GROUPS];
    doubt_t doubt = doubt_none();
    for (size_t g = 0; g < GROUPS; g++) before[g] = vector_load(vv_next + g * WIDTH);
    size_t i = lane;
    do { // every lane has nodes
        const size_t next = LANES * (2 * lane - i);
        if (more) bring_near(vv_cap + next, h + next);
        for (size_t g = 0; g < GROUPS; g++) {
            const size_t first = g * WIDTH * lane + i - TILE;
            tile_load(vv_cap + first, lane, cap);
            tile_load(h + first, lane, piece);
            for (size_t t = TILE; t-- > 0;) {
                doubt = doubt_add(doubt, cap[t], piece[t]);
                before[g] = vector_step(cap[t], before[g], piece[t]);
                desk->vv[g][i - TILE + t] = before[g];
                desk->h[g][i - TILE + t] = piece[t];
            }
        }
        i -= TILE;
    } while (i > 0);
    return doubt_any(doubt);
}

// Forward from the desk to the path.
static inline void forward_lanes(const desk_t *desk, size_t lane, const nck_real *vv_before,
                                 const nck_real *h_before, nck_real *vv) {
    vector_t out[TILE], before[GROUPS], piece[GROUPS];
    for (size_t g = 0; g < GROUPS; g++) {
        before[g] = vector_load(vv_before + g * WIDTH);
        piece[g] = vector_load(h_before + g * WIDTH);
    }
    for (size_t i = 0; i < lane; i += TILE) {
        for (size_t g = 0; g < GROUPS; g++) {
            for (size_t t = 0; t < TILE; t++) {
                before[g] = vector_step(desk->vv[g][i + t], before[g], piece[g]);
                piece[g] = desk->h[g][i + t];
                out[t] = before[g];
            }
            tile_store(out, lane, vv + g * WIDTH * lane + i);
        }
    }
}

// Both passes one node after the other. 0: a number is bad, and nothing is written.
static int plan_serial(const stretch_t *block) {
    if (!all_good(block->vv_cap, block->n) || !all_good(block->h, block->n)) return 0;
    backward_serial(block->vv_cap, block->h, block->n, block->vv_behind, block->vv);
    block->vv[0] = nck_envelope_forward(block->vv[0], block->vv_before, block->h_before);
    forward_serial(block->h, block->n - 1, block->vv);
    return 1;
}

// Both passes of a block of LANES lanes. 0: a number is bad, and nothing is written.
static inline int plan_lanes(const stretch_t *block, size_t lane, overlap_t *overlap) {
    desk_t desk;
    nck_real vv_next[LANES], vv_before[LANES], h_before[LANES];
    if (!backward_entry(block, lane, overlap, vv_next)) {
        overlap_refuse(overlap);
        return plan_serial(block);
    }
    if (backward_lanes(block, lane, vv_next, &desk)
        && (!all_good(block->vv_cap, block->n) || !all_good(block->h, block->n))) {
        return 0;
    }
    if (!forward_entry(block, &desk, lane, overlap, vv_before)) {
        overlap_refuse(overlap);
        return plan_serial(block);
    }
    h_before[0] = block->h_before;
    for (size_t k = 1; k < LANES; k++) h_before[k] = block->h[k * lane - 1];
    forward_lanes(&desk, lane, vv_before, h_before, block->vv);
    overlap_learn(overlap);
    return 1;
}

// Both passes of a block: in lanes, if it has any. 0: a number is bad, and nothing is written.
static int plan_block(const stretch_t *block, size_t lane, overlap_t *overlap) {
    if (lane == 0) return plan_serial(block);
    if (overlap->wait > 0) {
        overlap->wait--;
        return plan_serial(block);
    }
    if (lane == LANE_FULL) return plan_lanes(block, LANE_FULL, overlap); // the compiler knows it
    return plan_lanes(block, lane, overlap);
}

#endif
