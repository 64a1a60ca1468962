// SPDX-License-Identifier: MIT
// What the tests of room 1 share: decode a text, keep its blocks and findings.
#ifndef DECODE_CHECK_H
#define DECODE_CHECK_H

#include <string.h> // memset strlen

#include "check.h"
#include "nck/prep/1_decode/decode.h" // nck_decode_t

enum { CASE_BLOCKS = 64, CASE_FINDINGS = 32 };

typedef struct decode_case {
    nck_machine_t machine;
    nck_decode_t decode;
    nck_block_t block[CASE_BLOCKS];
    int blocks;
    nck_diagnostic_t finding[CASE_FINDINGS]; // errors and notes in the order in which they came
    int findings;
    nck_diagnostic_t first; // error; code 0: none
    int errors;
    int returned; // errors that pull returned
} decode_case_t;

// A case on the default machine, which has a value for everything that a program may leave out.
static inline void case_begin(decode_case_t *self) {
    memset(self, 0, sizeof *self);
    nck_machine_default(&self->machine);
}

static inline void case_take(decode_case_t *self, nck_status_t status, const nck_block_t *block) {
    nck_diagnostic_t finding;
    self->returned += status < 0;
    if (status == NCK_OK && self->blocks < CASE_BLOCKS) self->block[self->blocks++] = *block;
    while (nck_decode_diagnostic(&self->decode, &finding) == NCK_OK) {
        if (finding.code < 0 && self->errors++ == 0) self->first = finding;
        if (self->findings < CASE_FINDINGS) self->finding[self->findings++] = finding;
    }
}

// Decode n bytes, pushed in pieces of at most `piece` bytes, to their end.
static inline void case_decode_bytes(decode_case_t *self, const char *text, size_t n,
                                     size_t piece) {
    nck_block_t block;
    nck_status_t status = NCK_EMPTY;
    size_t at = 0;
    self->blocks = self->findings = self->errors = self->returned = 0;
    memset(&self->first, 0, sizeof self->first);
    nck_decode_init(&self->decode, &self->machine);
    while (status != NCK_DONE || at < n) {
        size_t used = 0;
        const size_t left = n - at;
        if (left > 0) {
            (void)nck_decode_push(&self->decode, text + at, left < piece ? left : piece, &used);
        } else {
            nck_decode_end(&self->decode);
        }
        at += used;
        do {
            status = nck_decode_pull(&self->decode, &block);
            case_take(self, status, &block);
        } while (status != NCK_EMPTY && status != NCK_DONE);
    }
}

// Decode a text on the machine of the case.
static inline void case_decode(decode_case_t *self, const char *text) {
    case_decode_bytes(self, text, strlen(text), strlen(text) + 1);
}

// Was the note given?
static inline int case_noted(const decode_case_t *self, nck_note_t note) {
    int count = 0;
    for (int k = 0; k < self->findings; k++) count += self->finding[k].code == (int32_t)note;
    return count;
}

// The text has one error at most: what it is and where; code NCK_OK: it has none.
static inline void check_error(check_t *check, decode_case_t *self, const char *text,
                               nck_status_t code, unsigned line, unsigned column) {
    case_decode(self, text);
    const int good = self->first.code == (int32_t)code && self->errors == (code < 0)
                     && self->returned == self->errors
                     && (code == NCK_OK || self->first.line == line)
                     && (code == NCK_OK || self->first.column == column);
    if (!check_that(check, good, text, __FILE__, __LINE__)) {
        printf("    %d errors, first %s at %u:%u, want %s at %u:%u\n", self->errors,
               nck_status_id(self->first.code), (unsigned)self->first.line,
               (unsigned)self->first.column, nck_status_id(code), line, column);
    }
}

#endif
