// SPDX-License-Identifier: MIT
// What newlib's printf needs, for a test program on a board: a way out and a little memory.
#include <stddef.h> // ptrdiff_t size_t
#include <string.h> // memcpy

#include "board/board.h" // board_print

int _write(int file, const char *text, int n);
void *_sbrk(ptrdiff_t n);

static char memory[8192];
static size_t used;

int _write(int file, const char *text, int n)
{
    char piece[81];
    (void)file;
    for (int at = 0; at < n;) {
        const int length = n - at < 80 ? n - at : 80;
        memcpy(piece, text + at, (size_t)length);
        piece[length] = '\0';
        board_print(piece);
        at += length;
    }
    return n;
}

void *_sbrk(ptrdiff_t n)
{
    void *const at = memory + used;
    if (n < 0 || used + (size_t)n > sizeof memory) return (void *)-1;
    used += (size_t)n;
    return at;
}
