// SPDX-License-Identifier: MIT
// The exact two-pass envelope over whole arrays, four stretches of the path at a time.
//
// A pass is one chain of additions and comparisons, each of which waits for the one before. So a
// block is cut into four lanes, all of which advance together:
//
//      lane 0       lane 1       lane 2       lane 3
//   ├────────────┼────────────┼────────────┼────────────┤
//            ◀────        ◀────        ◀────        ◀────  w at the block's end, known
//
// Lanes 0 to 2 begin from a guess, the cap. It is never below the true w, and rounded + and min are
// monotone, so min with what the true w gives repairs a value; where that changes nothing, nothing
// changes beyond. The bits are those of the plain recurrence, in any case.
#include "host/host.h"

#include <float.h> // DBL_MAX

#include "nck/prep/4_lookahead/envelope_math.h" // nck_envelope_backward nck_envelope_forward

enum {
    LANES = 4,
    LANE = 512,           // nodes of a lane: a block of four fits into the first cache
    BLOCK = LANES * LANE
};

static int is_good(double x) { return x >= 0.0 && x <= DBL_MAX; }

// 1 if all of n numbers are good.
static int all_good(const double *x, size_t n) {
    int good = 1;
    for (size_t i = 0; i < n; i++) good &= is_good(x[i]);
    return good;
}

// The first node the cap of which, or the piece behind which, is no good number.
static size_t first_bad(const double *w_cap, const double *h, size_t n) {
    size_t i = 0;
    while (i < n && is_good(w_cap[i]) && (i + 1 == n || is_good(h[i]))) i++;
    return i;
}

// Backward over n nodes; w_next: w at the node behind them. Returns w at the first one.
static double backward(const double *w_cap, const double *h, size_t n, double w_next, double *w) {
    for (size_t i = n; i-- > 0;) {
        w_next = nck_envelope_backward(w_cap[i], w_next, h[i]);
        w[i] = w_next;
    }
    return w_next;
}

// Lower the end of a lane to what the true w behind it gives.
static void repair_backward(const double *h, size_t n, double w_next, double *w) {
    for (size_t i = n; i-- > 0;) {
        const double before = w[i];
        w_next = nck_envelope_backward(before, w_next, h[i]);
        if (w_next == before) return;
        w[i] = w_next;
    }
}

static void backward_block(const double *w_cap, const double *h, double w_next, double *w) {
    double a = w_cap[LANE];
    double b = w_cap[2 * LANE];
    double c = w_cap[3 * LANE];
    double d = w_next;
    for (size_t i = LANE; i-- > 0;) {
        a = nck_envelope_backward(w_cap[i], a, h[i]);
        b = nck_envelope_backward(w_cap[i + LANE], b, h[i + LANE]);
        c = nck_envelope_backward(w_cap[i + 2 * LANE], c, h[i + 2 * LANE]);
        d = nck_envelope_backward(w_cap[i + 3 * LANE], d, h[i + 3 * LANE]);
        w[i] = a;
        w[i + LANE] = b;
        w[i + 2 * LANE] = c;
        w[i + 3 * LANE] = d;
    }
    for (size_t k = LANES - 1; k-- > 0;) {
        repair_backward(h + k * LANE, LANE, w[(k + 1) * LANE], w + k * LANE);
    }
}

// Forward over n pieces. w: n + 1 nodes, the first of them settled.
static void forward(const double *h, size_t n, double *w) {
    double w_before = w[0];
    for (size_t i = 0; i < n; i++) {
        w_before = nck_envelope_forward(w[i + 1], w_before, h[i]);
        w[i + 1] = w_before;
    }
}

// Forward over n pieces, until the true w at the first node makes no difference.
static void repair_forward(const double *h, size_t n, double *w) {
    double w_before = w[0];
    for (size_t i = 0; i < n; i++) {
        const double before = w[i + 1];
        w_before = nck_envelope_forward(before, w_before, h[i]);
        if (w_before == before) return;
        w[i + 1] = w_before;
    }
}

static void forward_block(const double *h, double *w) {
    double a = w[0];
    double b = w[LANE];
    double c = w[2 * LANE];
    double d = w[3 * LANE];
    for (size_t i = 0; i < LANE; i++) {
        a = nck_envelope_forward(w[i + 1], a, h[i]);
        b = nck_envelope_forward(w[i + LANE + 1], b, h[i + LANE]);
        c = nck_envelope_forward(w[i + 2 * LANE + 1], c, h[i + 2 * LANE]);
        d = nck_envelope_forward(w[i + 3 * LANE + 1], d, h[i + 3 * LANE]);
        w[i + 1] = a;
        w[i + LANE + 1] = b;
        w[i + 2 * LANE + 1] = c;
        w[i + 3 * LANE + 1] = d;
    }
    for (size_t k = 1; k < LANES; k++) repair_forward(h + k * LANE, LANE, w + k * LANE);
}

// 1, or 0 if a number is bad; what stands before its block is untouched then.
static int backward_pass(const double *w_cap, const double *h, size_t n, double *w) {
    double w_next = w[n];
    size_t end = n;
    for (; end >= BLOCK; end -= BLOCK) {
        const size_t begin = end - BLOCK;
        if (!all_good(w_cap + begin, BLOCK) || !all_good(h + begin, BLOCK)) return 0;
        backward_block(w_cap + begin, h + begin, w_next, w + begin);
        w_next = w[begin];
    }
    if (!all_good(w_cap, end) || !all_good(h, end)) return 0;
    backward(w_cap, h, end, w_next, w);
    return 1;
}

static void forward_pass(const double *h, size_t n, double *w) {
    size_t begin = 0;
    for (; n - begin >= BLOCK; begin += BLOCK) forward_block(h + begin, w + begin);
    forward(h + begin, n - begin, w + begin);
}

nck_status_t nck_host_envelope(const double *w_cap, const double *h, size_t n, double w_start,
                               double w_end, double *w_out, size_t *bad_out) {
    *bad_out = 0;
    if (n == 0 || !is_good(w_start)) return NCK_E_ARGUMENT;
    const int last_good = is_good(w_cap[n - 1]) && is_good(w_end);
    const double w_last = nck_min(w_cap[n - 1], w_end);
    if (last_good) w_out[n - 1] = w_last;
    if (!last_good || !backward_pass(w_cap, h, n - 1, w_out)) {
        const size_t bad = first_bad(w_cap, h, n);
        *bad_out = bad < n ? bad : n - 1;
        return NCK_E_ARGUMENT;
    }
    w_out[0] = nck_min(w_out[0], w_start);
    forward_pass(h, n - 1, w_out);
    return NCK_OK;
}
