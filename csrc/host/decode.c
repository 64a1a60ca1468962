// SPDX-License-Identifier: MIT
// libnck_host: decode a program in bulk.
#include "host.h"

static size_t take_findings(nck_decode_t *decode, nck_diagnostic_t *diagnostics, size_t max) {
    size_t count = 0;
    while (count < max && nck_decode_diagnostic(decode, &diagnostics[count]) == NCK_OK) count++;
    return count;
}

nck_status_t nck_host_decode(nck_decode_t *decode, const char *text, size_t n, int ended,
                             size_t *used_out, nck_block_t *blocks, size_t block_max,
                             size_t *block_count_out, nck_diagnostic_t *diagnostics,
                             size_t diagnostic_max, size_t *diagnostic_count_out) {
    if (block_max == 0 || diagnostic_max < NCK_DECODE_FINDINGS) return NCK_E_ARGUMENT;
    size_t found = 0;
    size_t count = 0;
    nck_status_t status = NCK_OK;
    *used_out = 0;
    while (count < block_max && found + NCK_DECODE_FINDINGS <= diagnostic_max) {
        status = nck_decode_pull(decode, &blocks[count]);
        if (status == NCK_OK) count++;
        found += take_findings(decode, &diagnostics[found], diagnostic_max - found);
        if (status == NCK_DONE) break;
        if (status != NCK_EMPTY) continue;
        size_t used = 0;
        if (*used_out == n && !ended) break;
        if (*used_out == n) nck_decode_end(decode);
        else nck_decode_push(decode, text + *used_out, n - *used_out, &used);
        *used_out += used;
    }
    *block_count_out = count;
    *diagnostic_count_out = found;
    return status == NCK_DONE || status == NCK_EMPTY ? status : NCK_OK;
}
