// SPDX-License-Identifier: MIT
// libnck_host: the exact envelope of a whole path, serial. The oracle of every other way to compute it.
#include "host.h"
#include "nck/prep/4_lookahead/limit_math.h" // nck_envelope_backward nck_envelope_forward

// NaN is not ≥ 0 and infinity is not ≤ the largest number.
static int is_length(double x) { return x >= 0.0 && x <= 1.7976931348623157e308; }

static int all_lengths(const double *x, size_t n, size_t *bad_out) {
    for (size_t i = 0; i < n; i++) {
        if (is_length(x[i])) continue;
        *bad_out = i;
        return 0;
    }
    return 1;
}

nck_status_t nck_host_envelope(const double *w_cap, const double *h, size_t n, double w_start,
                               double w_end, double *w_out, size_t *bad_out) {
    *bad_out = 0;
    if (n == 0) return NCK_OK;
    if (!is_length(w_start) || !is_length(w_end)) return NCK_E_ARGUMENT;
    if (!all_lengths(w_cap, n, bad_out) || !all_lengths(h, n - 1, bad_out)) return NCK_E_ARGUMENT;
    double w = nck_envelope_backward(w_cap[n - 1], w_end, 0.0);
    w_out[n - 1] = w;
    for (size_t i = n - 1; i-- > 0;) {
        w = nck_envelope_backward(w_cap[i], w, h[i]);
        w_out[i] = w;
    }
    w = w_start < w ? w_start : w;
    w_out[0] = w;
    for (size_t i = 1; i < n; i++) {
        w = nck_envelope_forward(w_out[i], w, h[i - 1]);
        w_out[i] = w;
    }
    return NCK_OK;
}
