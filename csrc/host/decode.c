// SPDX-License-Identifier: MIT
// Decoding in bulk: text → rows of blocks and of findings.
#include "host/host.h"

// Where findings go.
typedef struct findings {
    nck_diagnostic_t *at;
    size_t max, count;
} findings_t;

// Take what fits; the rest waits in the decoder.
static void take_findings(nck_decode_t *decode, findings_t *findings) {
    while (findings->count < findings->max
           && nck_decode_diagnostic(decode, &findings->at[findings->count]) == NCK_OK) {
        findings->count++;
    }
}

// Nothing to pull: hand over the next line, or the end. NCK_OK: pull again; NCK_EMPTY: all used.
static nck_status_t feed(nck_decode_t *decode, const char *text, size_t n, size_t *used) {
    if (*used == n) return NCK_EMPTY;
    size_t taken = 0;
    const nck_status_t status = nck_decode_push(decode, text + *used, n - *used, &taken);
    *used += taken;
    return status == NCK_FULL ? NCK_OK : status;
}

nck_status_t nck_host_decode_blocks(nck_decode_t *decode, nck_host_blocks_t *blocks) {
    blocks->out_count = 0;
    while (blocks->out_count < blocks->out_max) {
        const nck_status_t pulled = nck_decode_pull(decode, &blocks->out[blocks->out_count]);
        blocks->out_count += pulled == NCK_OK;
        if (pulled == NCK_DONE || pulled < NCK_OK) return pulled;
        if (pulled != NCK_EMPTY) continue;
        if (blocks->in_used == blocks->in_count) {
            nck_decode_end(decode);
            continue;
        }
        const nck_status_t pushed = nck_decode_push_block(decode, &blocks->in[blocks->in_used]);
        if (pushed < NCK_OK) return pushed;
        blocks->in_used++;
    }
    return NCK_OK;
}

nck_status_t nck_host_decode(nck_decode_t *decode, const char *text, size_t n, int ended,
                             size_t *used_out, nck_block_t *blocks, size_t block_max,
                             size_t *block_count_out, nck_diagnostic_t *diagnostics,
                             size_t diagnostic_max, size_t *diagnostic_count_out) {
    findings_t findings = {diagnostics, diagnostic_max, 0};
    nck_status_t status = NCK_OK;
    *used_out = 0;
    *block_count_out = 0;
    if (block_max == 0 || diagnostic_max == 0) return NCK_E_ARGUMENT;
    take_findings(decode, &findings);
    while (*block_count_out < block_max && findings.count < findings.max) {
        const nck_status_t pulled = nck_decode_pull(decode, &blocks[*block_count_out]);
        *block_count_out += pulled == NCK_OK;
        if (pulled == NCK_EMPTY || pulled == NCK_DONE) {
            status = feed(decode, text, n, used_out);
            if (status == NCK_EMPTY && pulled == NCK_DONE) status = NCK_DONE;
            if (status == NCK_EMPTY && ended) {
                nck_decode_end(decode);
                ended = 0;
                status = NCK_OK;
            }
        }
        take_findings(decode, &findings);
        if (status != NCK_OK) break;
    }
    *diagnostic_count_out = findings.count;
    return status;
}
