// SPDX-License-Identifier: MIT
// Decoding in bulk: text, or pushed blocks → rows of blocks and of findings.
#include "host/host.h"

#include <string.h> // memcpy

// Take what fits; the rest waits in the rooms.
static void take_findings(nck_decode_t *decode, nck_toolcomp_t *toolcomp,
                          nck_host_decoding_t *self) {
    while (self->diagnostic_count < self->diagnostic_max) {
        nck_diagnostic_t *const next = &self->diagnostics[self->diagnostic_count];
        if (nck_toolcomp_diagnostic(toolcomp, next) != NCK_OK
            && nck_decode_diagnostic(decode, next) != NCK_OK) return;
        self->diagnostic_count++;
    }
}

static nck_status_t feed_block(nck_decode_t *decode, nck_host_decoding_t *self) {
    nck_block_in_t block;
    memcpy(&block, self->text + self->text_used, sizeof block);
    const nck_status_t status = nck_decode_push_block(decode, &block);
    if (status == NCK_OK) self->text_used += sizeof block;
    return status;
}

static nck_status_t feed_text(nck_decode_t *decode, nck_host_decoding_t *self) {
    size_t taken = 0;
    const nck_status_t status = nck_decode_push(decode, self->text + self->text_used,
                                                self->text_size - self->text_used, &taken);
    self->text_used += taken;
    return status;
}

// Nothing to pull: hand over the next line or block, or the end. Behind the program's end text is
// still read, for what was meant to be executed; blocks are not.
static nck_status_t feed(nck_decode_t *decode, nck_host_decoding_t *self, int is_over) {
    const int all_used = self->text_used == self->text_size;
    if (is_over && (all_used || self->is_blocks)) return NCK_DONE;
    if (all_used) {
        nck_decode_end(decode);
        return NCK_OK;
    }
    return self->is_blocks ? feed_block(decode, self) : feed_text(decode, self);
}

// The decoder reads the text itself, if its capacities let it jump.
static void begin(nck_decode_t *decode, const nck_host_decoding_t *self) {
    const nck_source_t source = {self->text, self->text_size, NULL, NULL};
    if (!self->is_blocks && self->text_used == 0) (void)nck_decode_source(decode, &source);
}

// What pull has left to do.
static nck_status_t go_on(nck_decode_t *decode, nck_host_decoding_t *self, nck_status_t pulled) {
    if (!decode->macro.reads) {
        const int needs = pulled == NCK_EMPTY || pulled == NCK_DONE;
        return needs ? feed(decode, self, pulled == NCK_DONE) : NCK_OK;
    }
    self->text_used = pulled == NCK_DONE ? self->text_size : nck_decode_used(decode);
    return pulled == NCK_DONE ? NCK_DONE : NCK_OK;
}

// One block of the path, or a step towards it. NCK_DONE: there is none left.
static nck_status_t step(nck_decode_t *decode, nck_toolcomp_t *toolcomp,
                         nck_host_decoding_t *self) {
    nck_block_t *const block = &self->blocks[self->block_count];
    nck_status_t status = nck_toolcomp_pull(toolcomp, block);
    self->block_count += status == NCK_OK;
    if (status != NCK_EMPTY) return NCK_OK;
    const nck_status_t pulled = nck_decode_pull(decode, block);
    if (pulled == NCK_OK) status = nck_toolcomp_push(toolcomp, block);
    self->block_count += status == NCK_OK;
    if (pulled == NCK_DONE && nck_toolcomp_is_on(toolcomp)) {
        nck_toolcomp_end(toolcomp);
        return NCK_OK;
    }
    return go_on(decode, self, pulled);
}

nck_status_t nck_host_decode(nck_decode_t *decode, nck_toolcomp_t *toolcomp,
                             nck_host_decoding_t *self) {
    nck_status_t status = NCK_OK;
    self->block_count = 0;
    self->diagnostic_count = 0;
    if (self->block_max == 0 || self->diagnostic_max == 0) return NCK_E_ARGUMENT;
    begin(decode, self);
    take_findings(decode, toolcomp, self);
    while (status == NCK_OK && self->block_count < self->block_max
           && self->diagnostic_count < self->diagnostic_max) {
        status = step(decode, toolcomp, self);
        take_findings(decode, toolcomp, self);
    }
    return status;
}
