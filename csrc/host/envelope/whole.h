// SPDX-License-Identifier: MIT
// The exact envelope of a whole path in chunks that fit into the second cache: both passes of a
// chunk run while it is there, so the path crosses the memory once. Chunks may be planned in any
// order and by any thread, each with overlaps of its own; a chunk whose overlaps are not certain
// is refused.
//
// The includer gives NCK_REAL, the lanes (one of simd_*.h) and ENVELOPE_VARIANT, the table's name.
#ifndef NCK_HOST_ENVELOPE_WHOLE_H
#define NCK_HOST_ENVELOPE_WHOLE_H

#include "host/envelope/job.h"   // envelope_job_t
#include "host/envelope/lanes.h" // backward_pass forward_pass
#include "host/threads.h"        // nck_host_threads_run

enum {
    CHUNK = 32 * LANE_FULL, // nodes: 400 kB in three arrays
    REACH_MOST = 4096,      // nodes beyond a chunk's ends, at most
    REACH_FIRST = 64,
    LINE = 64 / (int)sizeof(nck_real),             // numbers of a cache line
    FAR_NODES = (24 << 20) / 3 / (int)sizeof(nck_real) // three arrays of 24 MB in all
};

// A job with typed arrays and its two ends resolved.
typedef struct path {
    const nck_real *w_cap, *h;
    nck_real *w;
    size_t n;
    nck_real w_start; // at most, at the first node
    nck_real w_last;  // exactly, at the last node
} path_t;

static path_t path_of(const envelope_job_t *job) {
    const nck_real *w_cap = job->w_cap;
    return (path_t){.w_cap = w_cap,
                    .h = job->h,
                    .w = job->w,
                    .n = job->n,
                    .w_start = (nck_real)job->w_start,
                    .w_last = nck_min(w_cap[job->n - 1], (nck_real)job->w_end)};
}

// 1 if nodes begin to end, end not included, and the pieces behind them, are good.
static int part_is_good(const path_t *path, size_t begin, size_t end) {
    const size_t pieces = (end < path->n ? end : path->n - 1) - begin;
    return all_good(path->w_cap + begin, end - begin) && all_good(path->h + begin, pieces);
}

// The backward pass' value at node i, by an overlap behind it. 1 if it is certain.
static int certain_backward(const path_t *path, size_t i, nck_real *w) {
    for (size_t reach = REACH_FIRST; reach <= REACH_MOST; reach *= 2) {
        const int to_end = path->n - 1 - i <= reach;
        size_t k = to_end ? path->n - 1 : i + reach;
        nck_real high = to_end ? path->w_last : path->w_cap[k];
        nck_real low = to_end ? path->w_last : nck_envelope_backward(high, 0, 0);
        while (k-- > i) {
            high = nck_envelope_backward(path->w_cap[k], high, path->h[k]);
            low = nck_envelope_backward(path->w_cap[k], low, path->h[k]);
        }
        *w = low;
        if (low == high) return 1;
    }
    return 0;
}

// The final value at node i > 0, by an overlap before it; w_back: the backward pass' value at i.
// 1 if it is certain.
static int certain_forward(const path_t *path, size_t i, nck_real w_back, nck_real *w) {
    nck_real back[REACH_MOST];
    for (size_t reach = REACH_FIRST; reach <= REACH_MOST; reach *= 2) {
        const size_t m = reach < i ? reach : i;
        backward_serial(path->w_cap + i - m, path->h + i - m, m, w_back, back);
        const int to_start = m == i;
        nck_real high = to_start ? nck_min(back[0], path->w_start) : back[0];
        nck_real low = to_start ? high : nck_envelope_backward(high, 0, 0);
        for (size_t k = 1; k <= m; k++) {
            const nck_real w_node = k < m ? back[k] : w_back;
            high = nck_envelope_forward(w_node, high, path->h[i - m + k - 1]);
            low = nck_envelope_forward(w_node, low, path->h[i - m + k - 1]);
        }
        *w = low;
        if (low == high) return 1;
    }
    return 0;
}

// Bring the lines of a chunk's result into the cache in their order: the lanes would ask for them
// in many places at once, and wait for each. Nothing to gain where the path fits into the last
// cache.
static void touch(const path_t *path, size_t begin, size_t end) {
    if (path->n < FAR_NODES || path->w == path->w_cap) return;
    volatile nck_real *w = path->w;
    for (size_t i = begin; i < end; i += LINE) w[i] = 0;
}

// The backward pass over nodes begin to end, given its value behind them (the last node has it).
static void chunk_backward(const path_t *path, size_t begin, size_t end, nck_real w_next,
                           overlap_t *overlap) {
    const size_t pieces = (end < path->n ? end : path->n - 1) - begin;
    touch(path, begin, end);
    if (end == path->n) path->w[end - 1] = path->w_last;
    backward_pass(path->w_cap + begin, path->h + begin, pieces, w_next, overlap, path->w + begin);
}

static int envelope_serial(const envelope_job_t *job, envelope_count_t *count) {
    const path_t path = path_of(job);
    count->bad = !part_is_good(&path, 0, path.n);
    if (count->bad) return 0;
    path.w[path.n - 1] = path.w_last;
    backward_serial(path.w_cap, path.h, path.n - 1, path.w_last, path.w);
    path.w[0] = nck_min(path.w[0], path.w_start);
    forward_serial(path.h, path.n - 1, path.w);
    return 1;
}

// One chunk after the other, from the start: what stands before a chunk is final, what comes
// behind it is found by an overlap. If that is not certain, the rest of the path is one chunk.
static int envelope_simd(const envelope_job_t *job, envelope_count_t *count) {
    const path_t path = path_of(job);
    overlap_t back = overlap_begin(count);
    overlap_t fore = overlap_begin(count);
    for (size_t begin = 0, end = 0; begin < path.n; begin = end) {
        nck_real w_next = path.w_last;
        // One more at first, so that both passes take whole blocks.
        const size_t wanted = begin == 0 ? CHUNK + 1 : CHUNK;
        end = path.n - begin < 2 * wanted ? path.n : begin + wanted;
        if (end < path.n && !certain_backward(&path, end, &w_next)) {
            count->chunks_refused++;
            end = path.n;
            w_next = path.w_last;
        }
        count->bad = !part_is_good(&path, begin, end);
        if (count->bad) return 0;
        chunk_backward(&path, begin, end, w_next, &back);
        if (begin == 0) path.w[0] = nck_min(path.w[0], path.w_start);
        const size_t from = begin == 0 ? 0 : begin - 1;
        forward_pass(path.h + from, end - from - 1, &fore, path.w + from);
    }
    return 1;
}

// What the threads share: every chunk writes its own nodes, every thread its own count.
typedef struct crew {
    path_t path;
    size_t chunk; // nodes of a chunk
    envelope_count_t count[NCK_HOST_THREADS_MAX];
} crew_t;

static void plan_chunk(void *context, size_t index, int thread) {
    crew_t *crew = context;
    const path_t *path = &crew->path;
    envelope_count_t *count = &crew->count[thread];
    const size_t begin = index * crew->chunk;
    const size_t end = path->n - begin < crew->chunk ? path->n : begin + crew->chunk;
    nck_real w_next = path->w_last;
    if (!part_is_good(path, begin, end)) {
        count->bad = 1;
        return;
    }
    if (end < path->n && !certain_backward(path, end, &w_next)) {
        count->chunks_refused++;
        return;
    }
    overlap_t back = overlap_begin(count);
    overlap_t fore = overlap_begin(count);
    chunk_backward(path, begin, end, w_next, &back);
    if (begin == 0) {
        path->w[0] = nck_min(path->w[0], path->w_start);
    } else if (!certain_forward(path, begin, path->w[begin], &path->w[begin])) {
        count->chunks_refused++;
        return;
    }
    forward_pass(path->h + begin, end - begin - 1, &fore, path->w + begin);
}

// All chunks at once. If one is refused, the path is planned again on one thread.
static int envelope_threads(const envelope_job_t *job, envelope_count_t *count) {
    crew_t crew = {.path = path_of(job)};
    const size_t share = job->n / (size_t)job->threads + 1;
    const size_t chunks = share < CHUNK ? (size_t)job->threads : job->n / CHUNK + 1;
    crew.chunk = job->n / chunks + 1;
    nck_host_threads_run((job->n + crew.chunk - 1) / crew.chunk, job->threads, plan_chunk, &crew);
    for (int k = 0; k < job->threads; k++) {
        const envelope_count_t *one = &crew.count[k];
        count->blocks += one->blocks;
        count->overlap = one->overlap > count->overlap ? one->overlap : count->overlap;
        count->bad |= one->bad;
        count->refused += one->refused;
        count->chunks_refused += one->chunks_refused;
    }
    if (count->bad) return 0;
    return count->chunks_refused == 0 || envelope_simd(job, count);
}

static size_t envelope_first_bad(const envelope_job_t *job) {
    const path_t path = {.w_cap = job->w_cap, .h = job->h, .n = job->n};
    if (part_is_good(&path, 0, path.n)) return path.n;
    size_t i = 0;
    while (is_good(path.w_cap[i]) && (i + 1 == path.n || is_good(path.h[i]))) i++;
    return i;
}

const envelope_variant_t ENVELOPE_VARIANT = {.serial = envelope_serial,
                                             .simd = envelope_simd,
                                             .threads = envelope_threads,
                                             .first_bad = envelope_first_bad};

#endif
