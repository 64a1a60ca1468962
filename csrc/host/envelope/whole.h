// SPDX-License-Identifier: MIT
// The exact envelope of a whole path in blocks: both passes of a block are done before the next
// one begins, so the path crosses the memory once. What comes behind a block is found by an
// overlap; if that is not certain, the block grows and is planned serially. Threads take chunks of
// blocks in any order, each with overlaps of its own.
//
// The includer gives NCK_REAL, the lanes (one of simd_*.h) and ENVELOPE_VARIANT, the table's name.
#ifndef NCK_HOST_ENVELOPE_WHOLE_H
#define NCK_HOST_ENVELOPE_WHOLE_H

#include "host/envelope/job.h"   // envelope_job_t
#include "host/envelope/lanes.h" // plan_block
#include "host/threads.h"        // nck_host_threads_run

enum {
    CHUNK = 128 * LANE_FULL, // nodes that a thread takes at once
    REACH_MOST = 4096,      // nodes beyond a block's ends, at most
    REACH_FIRST = 64
};

// A job with typed arrays and its two ends resolved.
typedef struct path {
    const nck_real *vv_cap, *h;
    nck_real *vv;
    size_t n;
    nck_real vv_start; // at most, at the first node
    nck_real vv_last;  // exactly, at the last node
} path_t;

static path_t path_of(const envelope_job_t *job) {
    const nck_real *vv_cap = job->vv_cap;
    return (path_t){.vv_cap = vv_cap,
                    .h = job->h,
                    .vv = job->vv,
                    .n = job->n,
                    .vv_start = (nck_real)job->vv_start,
                    .vv_last = nck_min(vv_cap[job->n - 1], (nck_real)job->vv_end)};
}

// 1 if the nodes and pieces of a whole path are good.
static int path_is_good(const path_t *path) {
    return all_good(path->vv_cap, path->n) && all_good(path->h, path->n - 1);
}

// The backward pass' value at node i, by an overlap behind it. 1 if it is certain.
static int certain_backward(const path_t *path, size_t i, nck_real *vv) {
    for (size_t reach = REACH_FIRST; reach <= REACH_MOST; reach *= 2) {
        const int to_end = path->n - 1 - i <= reach;
        size_t k = to_end ? path->n - 1 : i + reach;
        nck_real high = to_end ? path->vv_last : path->vv_cap[k];
        nck_real low = to_end ? path->vv_last : nck_envelope_backward(high, 0, 0);
        while (k-- > i) {
            high = nck_envelope_backward(path->vv_cap[k], high, path->h[k]);
            low = nck_envelope_backward(path->vv_cap[k], low, path->h[k]);
        }
        *vv = low;
        if (low == high) return 1;
    }
    return 0;
}

// The final value at node i > 0, by an overlap before it; vv_back: the backward pass' value at i.
// 1 if it is certain.
static int certain_forward(const path_t *path, size_t i, nck_real vv_back, nck_real *vv) {
    nck_real back[REACH_MOST];
    for (size_t reach = REACH_FIRST; reach <= REACH_MOST; reach *= 2) {
        const size_t m = reach < i ? reach : i;
        backward_serial(path->vv_cap + i - m, path->h + i - m, m, vv_back, back);
        const int to_start = m == i;
        nck_real high = to_start ? nck_min(back[0], path->vv_start) : back[0];
        nck_real low = to_start ? high : nck_envelope_backward(high, 0, 0);
        for (size_t k = 1; k <= m; k++) {
            const nck_real vv_node = k < m ? back[k] : vv_back;
            high = nck_envelope_forward(vv_node, high, path->h[i - m + k - 1]);
            low = nck_envelope_forward(vv_node, low, path->h[i - m + k - 1]);
        }
        *vv = low;
        if (low == high) return 1;
    }
    return 0;
}

static int envelope_serial(const envelope_job_t *job, envelope_count_t *count) {
    const path_t path = path_of(job);
    count->bad = !path_is_good(&path);
    if (count->bad) return 0;
    path.vv[path.n - 1] = path.vv_last;
    backward_serial(path.vv_cap, path.h, path.n - 1, path.vv_last, path.vv);
    path.vv[0] = nck_min(path.vv[0], path.vv_start);
    forward_serial(path.h, path.n - 1, path.vv);
    return 1;
}

// Before the path: nothing comes between, not even for a speed of −0.
#define NO_PIECE ((nck_real)-0.0)

// Where a stretch is cut, and what is known beside the cuts.
typedef struct cut {
    size_t begin, end;  // nodes of the stretch, all with a piece behind them
    nck_real vv_behind; // the backward pass' value at its end
    nck_real vv_before; // the final value before its begin
    nck_real h_before;  // piece in between
} cut_t;

// The end of a block that begins here: as many lanes as there is room for, and further on while
// what comes behind is not certain; then *lane_out is 0. 0: what comes behind is bad.
static int find_end(const path_t *path, const cut_t *left, envelope_count_t *count,
                    size_t *lane_out, stretch_t *block) {
    const size_t most = left->end - left->begin;
    *lane_out = lane_length(most);
    block->n = *lane_out > 0 ? LANES * *lane_out : most;
    while (block->n < most && !certain_backward(path, left->begin + block->n, &block->vv_behind)) {
        count->chunks_refused++;
        if (*lane_out > 0) count->refused++; // once, however far it grows
        *lane_out = 0;
        block->n = block->n < most / 2 ? 2 * block->n : most;
    }
    if (block->n == most) block->vv_behind = left->vv_behind;
    return is_good(block->vv_behind);
}

// One block after the other. 0: a number is bad.
static int plan_stretch(const path_t *path, const cut_t *cut, envelope_count_t *count) {
    cut_t left = *cut;
    overlap_t overlap = overlap_begin(count);
    while (left.begin < left.end) {
        const size_t begin = left.begin;
        stretch_t block = {.vv_cap = path->vv_cap + begin, .h = path->h + begin,
                           .vv = path->vv + begin, .vv_before = left.vv_before,
                           .h_before = left.h_before};
        size_t lane = 0;
        if (!find_end(path, &left, count, &lane, &block)) return 0;
        left.begin += block.n;
        block.more = left.end - left.begin >= block.n;
        if (!plan_block(&block, lane, &overlap)) return 0;
        left.vv_before = path->vv[left.begin - 1];
        left.h_before = path->h[left.begin - 1];
    }
    return 1;
}

// The last node, which has no piece behind it; all before it are final.
static void plan_last(const path_t *path) {
    const size_t last = path->n - 1;
    const nck_real vv_before = last > 0 ? path->vv[last - 1] : path->vv_start;
    const nck_real h_before = last > 0 ? path->h[last - 1] : NO_PIECE;
    path->vv[last] = nck_envelope_forward(path->vv_last, vv_before, h_before);
}

// From the start: what stands before a block is final.
static int envelope_simd(const envelope_job_t *job, envelope_count_t *count) {
    const path_t path = path_of(job);
    const cut_t whole = {0, path.n - 1, path.vv_last, path.vv_start, NO_PIECE};
    count->bad = !is_good(path.vv_cap[path.n - 1]) || !plan_stretch(&path, &whole, count);
    if (!count->bad) plan_last(&path);
    return !count->bad;
}

// What the threads share: every chunk writes its own nodes, every thread its own count.
typedef struct crew {
    path_t path;
    size_t chunk; // nodes of a chunk
    envelope_count_t count[NCK_HOST_THREADS_MAX];
    int uncertain[NCK_HOST_THREADS_MAX]; // 1: an overlap of a chunk did not meet
} crew_t;

// What is known beside a chunk. 1 if it is certain.
static int find_cut(const path_t *path, cut_t *cut) {
    if (cut->end < path->n - 1 && !certain_backward(path, cut->end, &cut->vv_behind)) return 0;
    if (cut->begin == 0) return 1;
    nck_real vv_back = 0;
    cut->h_before = path->h[cut->begin - 1];
    return certain_backward(path, cut->begin - 1, &vv_back)
           && certain_forward(path, cut->begin - 1, vv_back, &cut->vv_before);
}

static void plan_chunk(void *context, size_t index, int thread) {
    crew_t *crew = context;
    const path_t *path = &crew->path;
    envelope_count_t *count = &crew->count[thread];
    const size_t begin = index * crew->chunk;
    const size_t left = path->n - 1 - begin;
    cut_t cut = {begin, begin + (left < crew->chunk ? left : crew->chunk), path->vv_last,
                 path->vv_start, NO_PIECE};
    if (!find_cut(path, &cut)) {
        crew->uncertain[thread] = 1;
        count->chunks_refused++;
    } else if (!plan_stretch(path, &cut, count)) {
        count->bad = 1;
    }
}

// All chunks at once. If one is refused, the path is planned again on one thread.
static int envelope_threads(const envelope_job_t *job, envelope_count_t *count) {
    crew_t crew = {.path = path_of(job)};
    const size_t share = job->n / (size_t)job->threads + 1;
    const size_t chunks = share < CHUNK ? (size_t)job->threads : job->n / CHUNK + 1;
    int uncertain = 0;
    crew.chunk = job->n / chunks + 1;
    const size_t pieces = job->n - 1;
    nck_host_threads_run((pieces + crew.chunk - 1) / crew.chunk, job->threads, plan_chunk, &crew);
    count->bad = !is_good(crew.path.vv_cap[pieces]);
    for (int k = 0; k < job->threads; k++) {
        const envelope_count_t *one = &crew.count[k];
        count->blocks += one->blocks;
        count->overlap = one->overlap > count->overlap ? one->overlap : count->overlap;
        count->bad |= one->bad;
        count->refused += one->refused;
        count->chunks_refused += one->chunks_refused;
        uncertain |= crew.uncertain[k];
    }
    if (uncertain) return envelope_simd(job, count);
    if (!count->bad) plan_last(&crew.path);
    return !count->bad;
}

static size_t envelope_first_bad(const envelope_job_t *job) {
    const path_t path = {.vv_cap = job->vv_cap, .h = job->h, .n = job->n};
    if (path_is_good(&path)) return path.n;
    size_t i = 0;
    while (is_good(path.vv_cap[i]) && (i + 1 == path.n || is_good(path.h[i]))) i++;
    return i;
}

const envelope_variant_t ENVELOPE_VARIANT = {.serial = envelope_serial,
                                             .simd = envelope_simd,
                                             .threads = envelope_threads,
                                             .first_bad = envelope_first_bad};

#endif
