// SPDX-License-Identifier: MIT
// Looking for the rests of a program, without planning it.
#include "host/cut.h"

#include <string.h> // memset

#include "nck/prep/4_lookahead/zone.h" // nck_zone_s nck_zone_rests
#include "nck/prep/5_slope/slope.h"    // nck_slope_terms

nck_status_t nck_host_cut_init(nck_host_cut_t *cut, const nck_machine_t *machine, const char *text,
                               size_t n) {
    const nck_source_t source = {text, n, NULL, NULL};
    nck_terms_t terms;
    memset(cut, 0, sizeof *cut);
    nck_decode_init(&cut->decode, machine);
    nck_toolcomp_init(&cut->toolcomp, machine);
    nck_host_share_init(&cut->outputs, machine);
    nck_slope_terms(machine, &terms);
    cut->zone_s = nck_zone_s(&terms);
    return nck_decode_source(&cut->decode, &source) == NCK_OK ? NCK_OK : NCK_E_STATE;
}

// One block of the path, as the kernel takes it. NCK_EMPTY: a step towards it.
static nck_status_t next_block(nck_host_cut_t *cut, nck_block_t *block) {
    nck_status_t status = nck_toolcomp_pull(&cut->toolcomp, block);
    if (status != NCK_EMPTY) return status;
    status = nck_decode_pull(&cut->decode, block);
    return status == NCK_OK ? nck_toolcomp_push(&cut->toolcomp, block) : status;
}

// The path rests behind the block, and nothing of what is before it waits in room 2.
static int is_rest(const nck_host_cut_t *cut, const nck_block_t *block) {
    const int rests = block->kind == NCK_BLOCK_WAIT
                      || (block->kind == NCK_BLOCK_DWELL
                          && nck_zone_rests(block->dwell_s, cut->zone_s));
    const int enters = cut->decode.entry.waits != NCK_ENTRY_NOT; // the axes are elsewhere
    return rests && !enters && !nck_toolcomp_is_on(&cut->toolcomp) && !cut->toolcomp.away;
}

nck_status_t nck_host_cut_next(nck_host_cut_t *cut, uint64_t least) {
    const uint64_t wanted = cut->blocks + least;
    nck_status_t status = NCK_OK;
    nck_block_t block;
    while (status == NCK_OK || status == NCK_EMPTY) {
        status = next_block(cut, &block);
        if (status != NCK_OK) continue;
        cut->blocks++;
        if (block.kind == NCK_BLOCK_OUTPUT || block.kind == NCK_BLOCK_WAIT) {
            nck_host_share_output(&cut->outputs, &block.output);
        }
        if (cut->blocks >= wanted && is_rest(cut, &block)) return NCK_OK;
    }
    return NCK_DONE;
}
