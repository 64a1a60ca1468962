// SPDX-License-Identifier: MIT
// The exact envelope of a path, backward and forward in one launch.
//
// One work-item plans one contiguous part of the path, tile after tile. Global size: the number of
// parts. Local size: 1. Reads w_cap (n), h (n − 1); writes w (n) and one state per part. Must equal
// nck_host_envelope to the bit where every state is 0; where one is not, w is not to be used.
#include "tile_math.h"       // tile_backward tile_forward
#include "host/chunk_math.h" // nck_chunk_behind nck_chunk_before nck_chunk_enter

// State of a part: bits.
enum { DOUBT_OVERLAP = 1, DOUBT_NUMBER = 2 };

// A part has this many nodes at least: room for the scratch of nck_chunk_enter.
enum { PART_MIN = 2 * NCK_CHUNK_OVERLAP_MAX };

// Nodes before the first tile, one at a time: a cache line of them, so that tiles begin with one.
enum { HEAD = 64 / sizeof(nck_real) };

// A path, as all work-items see it.
typedef struct path {
    __global const nck_real *w_cap;
    __global const nck_real *h;
    __global nck_real *w;
    long last;      // its last node
    nck_real w_last; // w there, backward
    nck_real w_start;
} path_t;

// One tile from node first on, of lanes of length nodes. *carry: the final w at node first − 1, and
// then at the tile's last node.
static int plan_tile(const path_t *path, long first, long length, nck_real *carry) {
    nck_real state[LANES];
    const int bad = tile_has_bad(path->w_cap + first, path->h + first, length, path->w + first);
    int known = 1;
    for (int lane = 0; lane < LANES; lane++) {
        known &= nck_chunk_behind(path->w_cap, path->h, first + (lane + 1) * length, path->last,
                                  path->w_last, &state[lane]);
    }
    tile_backward(path->w_cap + first, path->h + first, length, lanes_of(state), path->w + first);
    state[0] = *carry;
    const nck_real w_first = nck_envelope_forward(path->w[first], *carry, path->h[first - 1]);
    for (int lane = 1; lane < LANES; lane++) {
        known &= nck_chunk_before(path->w, path->h, first, first + lane * length - 1, w_first,
                                  &state[lane]);
    }
    tile_forward(path->h + first - 1, length, lanes_of(state), path->w + first);
    *carry = path->w[first + LANES * length - 1];
    return (known ? 0 : DOUBT_OVERLAP) | (bad ? DOUBT_NUMBER : 0);
}

// The final w at the node before a part, which is not the path's first.
static int enter_part(const path_t *path, long begin, nck_real *carry) {
    int known = nck_chunk_behind(path->w_cap, path->h, begin, path->last, path->w_last, carry);
    known = known && nck_chunk_enter(path->w_cap, path->h, begin - 1, path->w_start,
                                     path->w + begin, carry);
    return known ? 0 : DOUBT_OVERLAP;
}

// All tiles of a part, nodes begin to end: those of full length, and one of what is left.
static int plan_part(const path_t *path, long begin, long end, nck_real carry) {
    const long length = nck_chunk_lane(end - begin, LANES, HEAD);
    const long tile = LANES * length;
    int state = 0;
    long first = begin;
    for (; length > 0 && end - first >= tile; first += tile) {
        state |= plan_tile(path, first, length, &carry);
    }
    const long rest = (end - first + LANES * LANES - 1) / (LANES * LANES) * LANES;
    if (rest > 0) {
        first = end - LANES * rest;
        carry = first > begin ? path->w[first - 1] : carry;
        state |= plan_tile(path, first, rest, &carry);
    }
    return state;
}

// A path too short to be cut: the plain recurrence, and every number looked at.
static int plan_whole(const path_t *path, nck_real w_end) {
    int good = nck_chunk_is_good(path->w_cap[path->last], REAL_MAX);
    for (long i = 0; i < path->last; i++) {
        good &= nck_chunk_is_good(path->w_cap[i], REAL_MAX);
        good &= nck_chunk_is_good(path->h[i], REAL_MAX);
    }
    nck_chunk_whole(path->w_cap, path->h, path->last + 1, path->w_start, w_end, path->w);
    return good ? 0 : DOUBT_NUMBER;
}

// The nodes before the first tile: their final w, and that of the last of them in *carry.
static int plan_head(const path_t *path, nck_real *carry) {
    const int known = nck_chunk_behind(path->w_cap, path->h, HEAD, path->last, path->w_last, carry);
    int good = nck_chunk_is_good(path->w_cap[path->last], REAL_MAX);
    for (long i = HEAD; i-- > 0;) {
        good &= nck_chunk_is_good(path->w_cap[i], REAL_MAX);
        good &= nck_chunk_is_good(path->h[i], REAL_MAX);
        *carry = nck_envelope_backward(path->w_cap[i], *carry, path->h[i]);
        path->w[i] = *carry;
    }
    *carry = nck_min(*carry, path->w_start);
    path->w[0] = *carry;
    for (long i = 1; i < HEAD; i++) {
        *carry = nck_envelope_forward(path->w[i], *carry, path->h[i - 1]);
        path->w[i] = *carry;
    }
    return (known ? 0 : DOUBT_OVERLAP) | (good ? 0 : DOUBT_NUMBER);
}

// The first node of a part: the nodes between the head and the last one, shared out in whole lines.
static long part_begin(long n, long part, long parts) {
    const long lines = (n - 1 - HEAD) / HEAD;
    return part == parts ? n - 1 : HEAD + HEAD * nck_chunk_begin(lines, part, parts);
}

__kernel __attribute__((reqd_work_group_size(1, 1, 1)))
void envelope(__global const nck_real *w_cap, __global const nck_real *h, long n, nck_real w_start,
              nck_real w_end, __global nck_real *w, __global int *state_of) {
    const long part = get_global_id(0);
    const long parts = get_global_size(0);
    const path_t path = {w_cap, h, w, n - 1, nck_min(w_cap[n - 1], w_end), w_start};
    if (n < parts * PART_MIN) {
        state_of[part] = part == 0 ? plan_whole(&path, w_end) : 0;
        return;
    }
    const long begin = part_begin(n, part, parts);
    const long end = part_begin(n, part + 1, parts);
    nck_real carry;
    int state = part == 0 ? plan_head(&path, &carry) : enter_part(&path, begin, &carry);
    state |= plan_part(&path, begin, end, carry);
    if (part == parts - 1) w[n - 1] = nck_envelope_forward(path.w_last, w[n - 2], h[n - 2]);
    state_of[part] = state;
}
