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

// 1 if the nodes and pieces of a whole path are good.
static int path_is_good(const path_t *path) {
    return all_good(path->w_cap, path->n) && all_good(path->h, path->n - 1);
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

static int envelope_serial(const envelope_job_t *job, envelope_count_t *count) {
    const path_t path = path_of(job);
    count->bad = !path_is_good(&path);
    if (count->bad) return 0;
    path.w[path.n - 1] = path.w_last;
    backward_serial(path.w_cap, path.h, path.n - 1, path.w_last, path.w);
    path.w[0] = nck_min(path.w[0], path.w_start);
    forward_serial(path.h, path.n - 1, path.w);
    return 1;
}

// Before the path: nothing comes between, not even for a speed of −0.
#define NO_PIECE ((nck_real)-0.0)

// Where a stretch is cut, and what is known beside the cuts.
typedef struct cut {
    size_t begin, end;  // nodes of the stretch, all with a piece behind them
    nck_real w_behind;  // the backward pass' value at its end
    nck_real w_before;  // the final value before its begin
    nck_real h_before;  // piece in between
} cut_t;

// The end of a block that begins here: as many lanes as there is room for, and further on while
// what comes behind is not certain; then *lane_out is 0. 0: what comes behind is bad.
static int find_end(const path_t *path, const cut_t *left, envelope_count_t *count,
                    size_t *lane_out, stretch_t *block) {
    const size_t most = left->end - left->begin;
    *lane_out = lane_length(most);
    block->n = *lane_out > 0 ? LANES * *lane_out : most;
    while (block->n < most && !certain_backward(path, left->begin + block->n, &block->w_behind)) {
        count->chunks_refused++;
        if (*lane_out > 0) count->refused++; // once, however far it grows
        *lane_out = 0;
        block->n = block->n < most / 2 ? 2 * block->n : most;
    }
    if (block->n == most) block->w_behind = left->w_behind;
    return is_good(block->w_behind);
}

// One block after the other. 0: a number is bad.
static int plan_stretch(const path_t *path, const cut_t *cut, envelope_count_t *count) {
    cut_t left = *cut;
    overlap_t overlap = overlap_begin(count);
    while (left.begin < left.end) {
        const size_t begin = left.begin;
        stretch_t block = {.w_cap = path->w_cap + begin, .h = path->h + begin,
                           .w = path->w + begin, .w_before = left.w_before,
                           .h_before = left.h_before};
        size_t lane = 0;
        if (!find_end(path, &left, count, &lane, &block)) return 0;
        left.begin += block.n;
        block.more = left.end - left.begin >= block.n;
        if (!plan_block(&block, lane, &overlap)) return 0;
        left.w_before = path->w[left.begin - 1];
        left.h_before = path->h[left.begin - 1];
    }
    return 1;
}

// The last node, which has no piece behind it; all before it are final.
static void plan_last(const path_t *path) {
    const size_t last = path->n - 1;
    const nck_real w_before = last > 0 ? path->w[last - 1] : path->w_start;
    const nck_real h_before = last > 0 ? path->h[last - 1] : NO_PIECE;
    path->w[last] = nck_envelope_forward(path->w_last, w_before, h_before);
}

// From the start: what stands before a block is final.
static int envelope_simd(const envelope_job_t *job, envelope_count_t *count) {
    const path_t path = path_of(job);
    const cut_t whole = {0, path.n - 1, path.w_last, path.w_start, NO_PIECE};
    count->bad = !is_good(path.w_cap[path.n - 1]) || !plan_stretch(&path, &whole, count);
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
    if (cut->end < path->n - 1 && !certain_backward(path, cut->end, &cut->w_behind)) return 0;
    if (cut->begin == 0) return 1;
    nck_real w_back = 0;
    cut->h_before = path->h[cut->begin - 1];
    return certain_backward(path, cut->begin - 1, &w_back)
           && certain_forward(path, cut->begin - 1, w_back, &cut->w_before);
}

static void plan_chunk(void *context, size_t index, int thread) {
    crew_t *crew = context;
    const path_t *path = &crew->path;
    envelope_count_t *count = &crew->count[thread];
    const size_t begin = index * crew->chunk;
    const size_t left = path->n - 1 - begin;
    cut_t cut = {begin, begin + (left < crew->chunk ? left : crew->chunk), path->w_last,
                 path->w_start, NO_PIECE};
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
    count->bad = !is_good(crew.path.w_cap[pieces]);
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
    const path_t path = {.w_cap = job->w_cap, .h = job->h, .n = job->n};
    if (path_is_good(&path)) return path.n;
    size_t i = 0;
    while (is_good(path.w_cap[i]) && (i + 1 == path.n || is_good(path.h[i]))) i++;
    return i;
}

const envelope_variant_t ENVELOPE_VARIANT = {.serial = envelope_serial,
                                             .simd = envelope_simd,
                                             .threads = envelope_threads,
                                             .first_bad = envelope_first_bad};

#endif
