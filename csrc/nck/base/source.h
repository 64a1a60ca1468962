// SPDX-License-Identifier: MIT
// Where the text of a program comes from that the kernel reads by itself.
#ifndef NCK_BASE_SOURCE_H
#define NCK_BASE_SOURCE_H

#include <stddef.h> // size_t

// Text that the kernel reads by itself, from any place: what jumps backward need. text or read.
typedef struct nck_source {
    const char *text; // in place, `size` bytes; NULL: read gives them
    size_t size;
    size_t (*read)(void *user, size_t offset, char *out, size_t n); // n bytes from an offset on:
                      // how many there are, fewer at the end of the text, 0 behind it
    void *user;       // handed back in every call
} nck_source_t;

#endif
