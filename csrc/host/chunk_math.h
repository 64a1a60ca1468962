// SPDX-License-Identifier: MIT
// The exact envelope of one part of a path: how far to look beyond its ends, and how to know.
//
//        ◀──────── two chains, from 0 and from the cap
//   ─────┼─────────────┼──────────────────────▶ nodes
//        p     overlap k
//
// The true v² at node k lies between 0 and the cap. Rounded + and min are monotone, so the one at
// p lies between what the two chains bring there; where they meet it is known to the bit. (The
// argument is Keinert et al. 2014, section 4, for their look-ahead buffers; the proof is derived in
// docs/parallel.md.) A chain that reaches the path's end needs no guess.
#ifndef NCK_HOST_CHUNK_MATH_H
#define NCK_HOST_CHUNK_MATH_H

#include "nck/base/envelope_math.h" // nck_envelope_backward nck_envelope_forward
#include "nck/base/real.h"          // nck_real nck_int64 NCK_IN

// How many nodes a chain may look beyond its part. The first try, and the last: where even that
// leaves doubt, the caller plans the whole path serially.
enum { NCK_CHUNK_OVERLAP_MIN = 16, NCK_CHUNK_OVERLAP_MAX = 1024 };

// Is x one of the numbers that an envelope accepts: finite and not negative? limit: the greatest
// finite number.
static inline int nck_chunk_is_good(nck_real x, nck_real limit) { return x >= 0 && x <= limit; }

// Where part k of count begins, of n nodes shared out evenly. 0 <= k <= count.
static inline nck_int64 nck_chunk_begin(nck_int64 n, nck_int64 k, nck_int64 count) {
    return n / count * k + n % count * k / count;
}

// Length of a lane, in nodes: n nodes are cut into tiles of lanes that run side by side. A multiple
// of line nodes (a cache line), an odd one: at powers of two the lanes evict each other. At most
// n / lanes if that is a line or more.
static inline nck_int64 nck_chunk_lane(nck_int64 n, nck_int64 lanes, nck_int64 line) {
    const nck_int64 wanted = 65 * line; // 4 kB and a line: three arrays of 8 lanes stay in cache
    const nck_int64 tiles = (n + lanes * wanted / 2) / (lanes * wanted);
    const nck_int64 lines = n / (lanes * line * (tiles > 0 ? tiles : 1));
    return (lines % 2 == 0 && lines > 0 ? lines - 1 : lines) * line;
}

// v² at node p, backward from node last where it is vv_last:   (algorithms of envelope_math.h)
static inline nck_real nck_chunk_backward(NCK_IN nck_real *vv_cap, NCK_IN nck_real *h, nck_int64 p,
                                          nck_int64 last, nck_real vv_last) {
    nck_real vv = vv_last;
    for (nck_int64 i = last; i-- > p;) vv = nck_envelope_backward(vv_cap[i], vv, h[i]);
    return vv;
}

// v² at node p, forward from node first where it is vv_first. vv_backward[i]: what the backward
// pass left at node i.
static inline nck_real nck_chunk_forward(NCK_IN nck_real *vv_backward, NCK_IN nck_real *h,
                                         nck_int64 first, nck_int64 p, nck_real vv_first) {
    nck_real vv = vv_first;
    for (nck_int64 i = first; i < p; i++) vv = nck_envelope_forward(vv_backward[i + 1], vv, h[i]);
    return vv;
}

// Two chains at once from node k = p + overlap; 1 if they meet at p, with v² there in *vv_out.
static inline int nck_chunk_meets_backward(NCK_IN nck_real *vv_cap, NCK_IN nck_real *h, nck_int64 p,
                                           nck_int64 overlap, nck_real *vv_out) {
    nck_real low = 0;
    nck_real high = vv_cap[p + overlap];
    for (nck_int64 i = p + overlap; i-- > p;) {
        low = nck_envelope_backward(vv_cap[i], low, h[i]);
        high = nck_envelope_backward(vv_cap[i], high, h[i]);
    }
    *vv_out = low;
    return low == high;
}

// Two chains at once from node k = p - overlap; 1 if they meet at p, with v² there in *vv_out.
static inline int nck_chunk_meets_forward(NCK_IN nck_real *vv_backward, NCK_IN nck_real *h,
                                          nck_int64 p, nck_int64 overlap, nck_real *vv_out) {
    nck_real low = 0;
    nck_real high = vv_backward[p - overlap];
    for (nck_int64 i = p - overlap; i < p; i++) {
        low = nck_envelope_forward(vv_backward[i + 1], low, h[i]);
        high = nck_envelope_forward(vv_backward[i + 1], high, h[i]);
    }
    *vv_out = low;
    return low == high;
}

// The backward v² at node p of a path that ends at node last with vv_last, in *vv_out. 1 if it is
// known, 0 if the longest overlap left doubt.
static inline int nck_chunk_behind(NCK_IN nck_real *vv_cap, NCK_IN nck_real *h, nck_int64 p,
                                   nck_int64 last, nck_real vv_last, nck_real *vv_out) {
    for (nck_int64 far = NCK_CHUNK_OVERLAP_MIN; far <= NCK_CHUNK_OVERLAP_MAX; far *= 2) {
        if (p + far >= last) {
            *vv_out = nck_chunk_backward(vv_cap, h, p, last, vv_last);
            return 1;
        }
        if (nck_chunk_meets_backward(vv_cap, h, p, far, vv_out)) return 1;
    }
    return 0;
}

// The final v² at node p, in *vv_out: vv_backward is known from node first on, where that is
// vv_first. 1 if it is known, 0 if the longest overlap left doubt.
static inline int nck_chunk_before(NCK_IN nck_real *vv_backward, NCK_IN nck_real *h,
                                   nck_int64 first, nck_int64 p, nck_real vv_first,
                                   nck_real *vv_out) {
    for (nck_int64 far = NCK_CHUNK_OVERLAP_MIN; far <= NCK_CHUNK_OVERLAP_MAX; far *= 2) {
        if (p - far <= first) {
            *vv_out = nck_chunk_forward(vv_backward, h, first, p, vv_first);
            return 1;
        }
        if (nck_chunk_meets_forward(vv_backward, h, p, far, vv_out)) return 1;
    }
    return 0;
}

// The final v² at node p, the last before a part, of a path that starts at node 0 with vv_start at
// most. *vv: in, the backward v² at node p + 1; out, the final v² at p. scratch: room for
// NCK_CHUNK_OVERLAP_MAX + 1 numbers. 1 if it is known, 0 if the longest overlap left doubt.
static inline int nck_chunk_enter(NCK_IN nck_real *vv_cap, NCK_IN nck_real *h, nck_int64 p,
                                  nck_real vv_start, NCK_OUT nck_real *scratch, nck_real *vv) {
    const nck_real behind = *vv;
    for (nck_int64 far = NCK_CHUNK_OVERLAP_MIN; far <= NCK_CHUNK_OVERLAP_MAX; far *= 2) {
        const nck_int64 length = far < p ? far : p;
        NCK_IN nck_real *const h_part = h + (p - length);
        nck_real vv_next = behind;
        for (nck_int64 i = length + 1; i-- > 0;) {
            vv_next = nck_envelope_backward(vv_cap[p - length + i], vv_next, h_part[i]);
            scratch[i] = vv_next;
        }
        if (length == p) {
            *vv = nck_chunk_forward(scratch, h, 0, p, nck_min(vv_next, vv_start));
            return 1;
        }
        if (nck_chunk_meets_forward(scratch, h_part, length, length, vv)) return 1;
    }
    return 0;
}

// The whole path by the plain recurrence: n >= 1 nodes, n - 1 pieces.
static inline void nck_chunk_whole(NCK_IN nck_real *vv_cap, NCK_IN nck_real *h, nck_int64 n,
                                   nck_real vv_start, nck_real vv_end, NCK_OUT nck_real *vv) {
    vv[n - 1] = nck_min(vv_cap[n - 1], vv_end);
    for (nck_int64 i = n - 1; i-- > 0;) vv[i] = nck_envelope_backward(vv_cap[i], vv[i + 1], h[i]);
    vv[0] = nck_min(vv[0], vv_start);
    for (nck_int64 i = 0; i < n - 1; i++) vv[i + 1] = nck_envelope_forward(vv[i + 1], vv[i], h[i]);
}

#endif
