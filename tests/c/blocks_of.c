// SPDX-License-Identifier: MIT
// What rooms 1 and 2 make of programs, as text: blocks_of MACHINE PROGRAM …
//
// MACHINE is an nck_machine_t of this build as it lies in memory. Every block is a line, and every
// finding; numbers are written so that equal text is equal bits.
#include <stdio.h>
#include <stdlib.h> // EXIT_FAILURE
#include <string.h> // memset

#include "host/host.h" // nck_host_decode
#include "nck/nck_tools.h"   // nck_machine_t

enum { TEXT_MAX = 1 << 20, ROWS = 64 };

static nck_machine_t machine;
static nck_decode_t decode;
static nck_toolcomp_t toolcomp;
static nck_block_t blocks[ROWS];
static nck_diagnostic_t diagnostics[ROWS];
static char text[TEXT_MAX];

// Read a file of at most `most` bytes. Returns its size; 0 if it cannot be read.
static size_t read_file(const char *name, void *into, size_t most) {
    FILE *const file = fopen(name, "rb");
    if (!file) return 0;
    const size_t size = fread(into, 1, most, file);
    fclose(file);
    return size;
}

static void print_block(const nck_block_t *block) {
    printf("%u %d %d %d %d", block->line, block->kind, block->path_mode, block->feed_mode,
           block->plane);
    for (int k = 0; k < NCK_AXIS_MAX; k++) printf(" %lld", (long long)block->target_nm[k]);
    for (int k = 0; k < 3; k++) printf(" %lld", (long long)block->tool_nm[k]);
    printf(" %a %a %a %a %a %a %a %a %a %a", block->centre_mm[0], block->centre_mm[1],
           block->sweep_rad, block->feed, block->spindle_rpm, block->surface, block->spindle_x_mm,
           block->tolerance_mm, block->merge_mm, block->dwell_s);
    const nck_thread_t *const thread = &block->thread;
    printf(" %a %a %a %a %a %a %a %a", thread->length, thread->lead, thread->enter, thread->leave,
           (double)thread->entry, (double)thread->exit, (double)thread->turn,
           (double)thread->duration);
    const nck_tap_t *const tap = &block->tap;
    printf(" %a %a %a %a %a %a", tap->way[0], tap->way[1], tap->way[2], tap->lead,
           (double)tap->dwell, (double)tap->duration);
    printf(" %d %u %a\n", block->output.kind, block->output.number, block->output.value);
}

static void print_rows(const nck_host_decoding_t *rows) {
    for (size_t k = 0; k < rows->block_count; k++) print_block(&blocks[k]);
    for (size_t k = 0; k < rows->diagnostic_count; k++) {
        printf("found %d %u %u\n", diagnostics[k].code, diagnostics[k].line,
               diagnostics[k].column);
    }
}

static void print_program(size_t size) {
    nck_host_decoding_t rows;
    memset(&rows, 0, sizeof rows);
    rows.text = text;
    rows.text_size = size;
    rows.blocks = blocks;
    rows.block_max = ROWS;
    rows.diagnostics = diagnostics;
    rows.diagnostic_max = ROWS;
    nck_decode_init(&decode, &machine);
    nck_toolcomp_init(&toolcomp, &machine);
    nck_status_t status = NCK_OK;
    while (status == NCK_OK) {
        status = nck_host_decode(&decode, &toolcomp, &rows);
        print_rows(&rows);
    }
    printf("ends %d\n", (int)status);
}

int main(int argc, char **argv) {
    if (argc < 2 || read_file(argv[1], &machine, sizeof machine) != sizeof machine) {
        fprintf(stderr, "blocks_of: no machine of %zu bytes\n", sizeof machine);
        return EXIT_FAILURE;
    }
    for (int k = 2; k < argc; k++) {
        const size_t size = read_file(argv[k], text, TEXT_MAX);
        if (size == 0) return EXIT_FAILURE;
        print_program(size);
    }
    return EXIT_SUCCESS;
}
