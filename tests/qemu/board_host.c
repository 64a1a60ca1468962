// SPDX-License-Identifier: MIT
// What board.h promises, on the host: a target's program runs here unchanged.
#include "board/board.h"

#include <stdio.h>  // FILE
#include <stdlib.h> // exit

enum { FILE_MAX = 8 };

static FILE *files[FILE_MAX];
static int file_count;

void board_exit(int status) { exit(status); }

int board_open(const char *name, board_mode_t mode) {
    if (file_count == FILE_MAX) return -1;
    files[file_count] = fopen(name, mode == BOARD_READ ? "rb" : "wb");
    return files[file_count] ? file_count++ : -1;
}

size_t board_read(int file, void *data, size_t n) { return fread(data, 1, n, files[file]); }

size_t board_write(int file, const void *data, size_t n) {
    return fwrite(data, 1, n, files[file]);
}

void board_close(int file) { (void)fclose(files[file]); }

void board_print(const char *text) { (void)fputs(text, stderr); }

// The host's stack is not ours to measure.
void board_stack_paint(void) {}
uint32_t board_stack_used(void) { return 0; }

// The command line as Linux keeps it: words that end in a NUL each.
int board_argument(int k, char *text, size_t size) {
    FILE *const line = fopen("/proc/self/cmdline", "rb");
    size_t length = 0;
    int c = 0;
    if (!line) return -1;
    for (int word = 0; word <= k && c != EOF; word++) {
        for (length = 0; (c = getc(line)) > 0; length++) {
            if (length < size) text[length] = (char)c;
        }
    }
    (void)fclose(line);
    if (c == EOF || length == 0 || length >= size) return -1;
    text[length] = '\0';
    return (int)length;
}
