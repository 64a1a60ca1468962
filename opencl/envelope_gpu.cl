// SPDX-License-Identifier: MIT
// The exact envelope of a path on a GPU, in two launches: backward, then forward.
//
//                         ├─ tile of a group ─┤
//   backward              │ run │ run │ … │run│ ◀── overlap ──   a window in local memory
//   forward    ── overlap ──▶ run │ run │ … │run│
//
// One work-group: one tile of neighbouring nodes. One work-item: one run of it. Local size: any.
// Global size: as many groups as tiles of local size · run nodes cover the path. The windows cap,
// back and rise: room for a tile and OVERLAP_ROOM numbers each; an odd run keeps work-items off
// each other's banks there. Every work-item reaches every barrier. Must equal nck_host_envelope to
// the bit where every state is 0; where one is not, vv is not to be used.
#include "lanes_math.h" // nck_real REAL_MAX (of the float or the double folder)

// The chains of the overlap run in local memory.
#undef NCK_IN
#undef NCK_OUT
#define NCK_IN __local const
#define NCK_OUT __local
#include "host/chunk_math.h" // nck_chunk_behind nck_chunk_before nck_chunk_is_good

// State of a tile: bits, as in envelope.cl.
enum { DOUBT_OVERLAP = 1, DOUBT_NUMBER = 2 };

// The longest overlap, and the node where its chains begin.
enum { OVERLAP_ROOM = NCK_CHUNK_OVERLAP_MAX + 1 };

// What one work-item does, in nodes.
typedef struct share {
    long first; // of the tile, counted from the path's begin
    long tile;  // length of a whole tile
    long count; // nodes of this tile: the last one may be shorter
    long begin; // of the run, counted from the tile's begin
    long end;   // behind the run; equals begin where no node is left for it
} share_t;

static long nearer(long a, long b) { return b < a ? b : a; }

static void take_share(long n, int run, share_t *share) {
    share->tile = (long)get_local_size(0) * run;
    share->first = (long)get_group_id(0) * share->tile;
    share->count = nearer(n - share->first, share->tile);
    share->begin = nearer((long)get_local_id(0) * run, share->count);
    share->end = nearer(share->begin + run, share->count);
}

// A negative zero would pass for zero, and its bits would not.
static int is_bad(nck_real x) { return !nck_chunk_is_good(x, REAL_MAX) || signbit(x); }

// Neighbours in the group take neighbours in memory. Returns 1 if a number is no good.
static int load(__global const nck_real *x, long count, __local nck_real *window) {
    int bad = 0;
    for (long k = get_local_id(0); k < count; k += get_local_size(0)) {
        const nck_real number = x[k];
        window[k] = number;
        bad |= is_bad(number);
    }
    return bad;
}

static void store(__local const nck_real *window, long count, __global nck_real *x) {
    for (long k = get_local_id(0); k < count; k += get_local_size(0)) x[k] = window[k];
}

// Reads vv_cap (n), h (n − 1); writes vv_backward (n) and one state per group.
__kernel void backward(__global const nck_real *vv_cap, __global const nck_real *h, long n,
                       nck_real vv_end, int run, __global nck_real *vv_backward,
                       __global int *state_of, __local nck_real *cap, __local nck_real *rise) {
    __local int doubt;
    share_t share;
    take_share(n, run, &share);
    const long last = n - 1 - share.first; // the path's last node, counted from the tile's begin
    const nck_real vv_last = nck_min(vv_cap[n - 1], vv_end);
    if (get_local_id(0) == 0) doubt = 0;
    int bad = load(vv_cap + share.first, nearer(last + 1, share.tile + OVERLAP_ROOM), cap);
    bad |= load(h + share.first, nearer(last, share.tile + OVERLAP_ROOM), rise);
    barrier(CLK_LOCAL_MEM_FENCE);
    const long p = nearer(share.end, last);
    nck_real vv;
    const int known = nck_chunk_behind(cap, rise, p, last, vv_last, &vv);
    if (bad || !known) atomic_or(&doubt, (known ? 0 : DOUBT_OVERLAP) | (bad ? DOUBT_NUMBER : 0));
    barrier(CLK_LOCAL_MEM_FENCE); // caps are overwritten from here on
    if (share.begin <= last && last < share.end) cap[last] = vv_last;
    for (long i = p; i-- > share.begin;) {
        vv = nck_envelope_backward(cap[i], vv, rise[i]);
        cap[i] = vv;
    }
    barrier(CLK_LOCAL_MEM_FENCE);
    store(cap, share.count, vv_backward + share.first);
    if (get_local_id(0) == 0) state_of[get_group_id(0)] = doubt;
}

// Reads vv_backward (n), h (n − 1); writes vv (n), not vv_backward, and adds to the states.
__kernel void forward(__global const nck_real *vv_backward, __global const nck_real *h, long n,
                      nck_real vv_start, int run, __global nck_real *vv, __global int *state_of,
                      __local nck_real *back, __local nck_real *rise) {
    __local int doubt;
    share_t share;
    take_share(n, run, &share);
    const long before = nearer(share.first, OVERLAP_ROOM); // nodes of the window before the tile
    const long origin = share.first - before;              // the window's first node
    const long begin = before + share.begin;
    const nck_real vv_first = nck_min(vv_backward[0], vv_start);
    if (get_local_id(0) == 0) doubt = 0;
    load(vv_backward + origin, before + share.count, back);
    load(h + origin, before + share.count - 1, rise);
    barrier(CLK_LOCAL_MEM_FENCE);
    nck_real state = vv_first;
    if (begin > 0 && !nck_chunk_before(back, rise, -origin, begin - 1, vv_first, &state)) {
        atomic_or(&doubt, DOUBT_OVERLAP);
    }
    barrier(CLK_LOCAL_MEM_FENCE); // back is overwritten from here on
    if (begin == 0) back[0] = vv_first;
    for (long i = begin > 0 ? begin : 1; i < before + share.end; i++) {
        state = nck_envelope_forward(back[i], state, rise[i - 1]);
        back[i] = state;
    }
    barrier(CLK_LOCAL_MEM_FENCE);
    store(back + before, share.count, vv + share.first);
    if (get_local_id(0) == 0) state_of[get_group_id(0)] |= doubt;
}
