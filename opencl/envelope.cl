// SPDX-License-Identifier: MIT
// The exact envelope of a path, backward and forward in one launch.
//
// One work-item plans one contiguous part of the path, tile after tile. Global size: the number of
// parts. Local size: 1. Reads vv_cap (n), h (n − 1); writes vv (n) and one state per part. Equals
// nck_host_envelope to the bit where every state is 0; where one is not, vv is not to be used.
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
    __global const nck_real *vv_cap;
    __global const nck_real *h;
    __global nck_real *vv;
    long last;      // its last node
    nck_real vv_last; // vv there, backward
    nck_real vv_start;
} path_t;

// One tile from node first on, of lanes of length nodes. *carry: the final v² at node first − 1,
// then at the tile's last node.
static int plan_tile(const path_t *path, long first, long length, nck_real *carry) {
    nck_real state[LANES];
    const int bad = tile_has_bad(path->vv_cap + first, path->h + first, length, path->vv + first);
    int known = 1;
    for (int lane = 0; lane < LANES; lane++) {
        known &= nck_chunk_behind(path->vv_cap, path->h, first + (lane + 1) * length, path->last,
                                  path->vv_last, &state[lane]);
    }
    tile_backward(path->vv_cap + first, path->h + first, length, lanes_of(state), path->vv + first);
    state[0] = *carry;
    const nck_real vv_first = nck_envelope_forward(path->vv[first], *carry, path->h[first - 1]);
    for (int lane = 1; lane < LANES; lane++) {
        known &= nck_chunk_before(path->vv, path->h, first, first + lane * length - 1, vv_first,
                                  &state[lane]);
    }
    tile_forward(path->h + first - 1, length, lanes_of(state), path->vv + first);
    *carry = path->vv[first + LANES * length - 1];
    return (known ? 0 : DOUBT_OVERLAP) | (bad ? DOUBT_NUMBER : 0);
}

// The final v² at the node before a part, which is not the path's first.
static int enter_part(const path_t *path, long begin, nck_real *carry) {
    int known = nck_chunk_behind(path->vv_cap, path->h, begin, path->last, path->vv_last, carry);
    known = known && nck_chunk_enter(path->vv_cap, path->h, begin - 1, path->vv_start,
                                     path->vv + begin, carry);
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
        carry = first > begin ? path->vv[first - 1] : carry;
        state |= plan_tile(path, first, rest, &carry);
    }
    return state;
}

// A path too short to be cut: the plain recurrence, and every number looked at.
static int plan_whole(const path_t *path, nck_real vv_end) {
    int good = nck_chunk_is_good(path->vv_cap[path->last], REAL_MAX);
    for (long i = 0; i < path->last; i++) {
        good &= nck_chunk_is_good(path->vv_cap[i], REAL_MAX);
        good &= nck_chunk_is_good(path->h[i], REAL_MAX);
    }
    nck_chunk_whole(path->vv_cap, path->h, path->last + 1, path->vv_start, vv_end, path->vv);
    return good ? 0 : DOUBT_NUMBER;
}

// The nodes before the first tile: their final v², and that of the last of them in *carry.
static int plan_head(const path_t *path, nck_real *carry) {
    const int known = nck_chunk_behind(path->vv_cap, path->h, HEAD, path->last, path->vv_last,
                                       carry);
    int good = nck_chunk_is_good(path->vv_cap[path->last], REAL_MAX);
    for (long i = HEAD; i-- > 0;) {
        good &= nck_chunk_is_good(path->vv_cap[i], REAL_MAX);
        good &= nck_chunk_is_good(path->h[i], REAL_MAX);
        *carry = nck_envelope_backward(path->vv_cap[i], *carry, path->h[i]);
        path->vv[i] = *carry;
    }
    *carry = nck_min(*carry, path->vv_start);
    path->vv[0] = *carry;
    for (long i = 1; i < HEAD; i++) {
        *carry = nck_envelope_forward(path->vv[i], *carry, path->h[i - 1]);
        path->vv[i] = *carry;
    }
    return (known ? 0 : DOUBT_OVERLAP) | (good ? 0 : DOUBT_NUMBER);
}

// The first node of a part: the nodes between the head and the last one, shared out in whole lines.
static long part_begin(long n, long part, long parts) {
    const long lines = (n - 1 - HEAD) / HEAD;
    return part == parts ? n - 1 : HEAD + HEAD * nck_chunk_begin(lines, part, parts);
}

__kernel __attribute__((reqd_work_group_size(1, 1, 1)))
void envelope(__global const nck_real *vv_cap, __global const nck_real *h, long n,
              nck_real vv_start, nck_real vv_end, __global nck_real *vv,
              __global int *state_of) {
    const long part = get_global_id(0);
    const long parts = get_global_size(0);
    const path_t path = {vv_cap, h, vv, n - 1, nck_min(vv_cap[n - 1], vv_end), vv_start};
    if (n < parts * PART_MIN) {
        state_of[part] = part == 0 ? plan_whole(&path, vv_end) : 0;
        return;
    }
    const long begin = part_begin(n, part, parts);
    const long end = part_begin(n, part + 1, parts);
    nck_real carry;
    int state = part == 0 ? plan_head(&path, &carry) : enter_part(&path, begin, &carry);
    state |= plan_part(&path, begin, end, carry);
    if (part == parts - 1) vv[n - 1] = nck_envelope_forward(path.vv_last, vv[n - 2], h[n - 2]);
    state_of[part] = state;
}
