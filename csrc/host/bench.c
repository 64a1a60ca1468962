// SPDX-License-Identifier: MIT
// Ticks and the window, timed.
#include "host/bench.h"

#include "host/threads.h"           // nck_host_clock_ns
#include "nck/prep/5_slope/slope.h" // nck_slope_terms

// A program on its way through prep.
typedef struct feed {
    nck_t *nck;
    const char *text;
    size_t n, used;
    nck_status_t status, error;
} feed_t;

// Prep until it waits for the tick or is done.
static void prep(feed_t *self) {
    while (self->status != NCK_DONE) {
        self->status = nck_prep(self->nck);
        if (self->status < NCK_OK) self->error = self->status;
        if (self->status == NCK_FULL) return;
        if (self->status != NCK_EMPTY) continue;
        size_t taken = 0;
        if (self->used == self->n) nck_end(self->nck);
        else (void)nck_push(self->nck, self->text + self->used, self->n - self->used, &taken);
        self->used += taken;
    }
}

nck_status_t nck_host_bench_ticks(nck_t *nck, const nck_machine_t *machine, const char *text,
                                  size_t n, nck_host_times_t *times) {
    const nck_source_t source = {text, n, (void *)0, (void *)0};
    feed_t feed = {nck, text, n, 0, NCK_OK, NCK_OK};
    nck_pose_t pose;
    nck_axes_t axes;
    times->count = 0;
    const nck_status_t status = nck_init(nck, machine, (const nck_hooks_t *)0);
    if (status != NCK_OK) return status;
    (void)nck_read(nck, &source);
    for (prep(&feed); times->count < times->max && !nck_is_idle(nck); prep(&feed)) {
        const int64_t begun = nck_host_clock_ns();
        const nck_tick_state_t state = nck_tick(nck, &pose, &axes);
        times->ns[times->count] = (uint32_t)(nck_host_clock_ns() - begun);
        times->count++;
        if (state == NCK_TICK_WAIT) nck_resume(nck);
    }
    return feed.error;
}

int64_t nck_host_bench_clock(void) {
    int64_t least = INT64_MAX;
    for (int k = 0; k < 1000; k++) {
        const int64_t begun = nck_host_clock_ns();
        const int64_t ns = nck_host_clock_ns() - begun;
        if (ns < least) least = ns;
    }
    return least;
}

static size_t take_pieces(nck_lookahead_t *lookahead) {
    const uint32_t count = nck_lookahead_fill(lookahead);
    if (count > 0) nck_lookahead_drop(lookahead, count);
    return count;
}

int64_t nck_host_bench_window(nck_lookahead_t *lookahead, const nck_machine_t *machine,
                              const nck_seg_t *segs, size_t n, size_t *pieces_out) {
    size_t pushed = 0;
    nck_terms_t terms;
    nck_slope_terms(machine, &terms);
    nck_lookahead_init(lookahead, &terms);
    *pieces_out = 0;
    const int64_t begun = nck_host_clock_ns();
    for (nck_status_t status = NCK_OK; status != NCK_DONE;) {
        status = nck_lookahead_step(lookahead);
        if (status == NCK_OK) continue;
        *pieces_out += take_pieces(lookahead);
        if (status != NCK_EMPTY) continue;
        while (pushed < n && nck_lookahead_push(lookahead, &segs[pushed]) == NCK_OK) pushed++;
        if (pushed == n) nck_lookahead_end(lookahead);
    }
    return nck_host_clock_ns() - begun;
}
