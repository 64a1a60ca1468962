// SPDX-License-Identifier: MIT
// Takes a program from its text to cells, or to setpoints, for who counts the instructions of the
// kernel's doors: text_to_cells MACHINE PROGRAM [tick]. MACHINE: the bytes of an nck_machine_t.
#include <stdio.h>
#include <stdlib.h> // calloc

#include "nck/nck_tools.h" // nck_t

static nck_machine_t machine;
static nck_t nck;

// All bytes of a file, and how many; NULL: it cannot be read.
static char *read_all(const char *name, size_t *size_out) {
    FILE *const file = fopen(name, "rb");
    if (!file) return NULL;
    (void)fseek(file, 0, SEEK_END);
    const long size = ftell(file);
    rewind(file);
    char *const text = calloc((size_t)size + 1, 1);
    *size_out = text ? fread(text, 1, (size_t)size, file) : 0;
    (void)fclose(file);
    return text;
}

// The tick's side, as far as something is final: its cells at once, or one setpoint. Returns cells.
static unsigned consume(int ticks) {
    nck_pose_t pose;
    nck_axes_t axes;
    nck_cell_t cell;
    unsigned cells = 0;
    if (ticks) {
        (void)nck_tick(&nck, &pose, &axes);
        return 0;
    }
    while (nck_take(&nck, &cell) == NCK_OK) cells++;
    return cells;
}

// The next text, or its end.
static void feed(const char *text, size_t size, size_t *used) {
    size_t taken = 0;
    if (*used == size) nck_end(&nck);
    else (void)nck_push(&nck, text + *used, size - *used, &taken);
    *used += taken;
}

int main(int argc, char **argv) {
    size_t size = 0;
    size_t bytes = 0;
    if (argc < 3) return 2;
    const char *const told = read_all(argv[1], &bytes);
    const char *const text = read_all(argv[2], &size);
    if (!told || !text || bytes != sizeof machine) return 2;
    for (size_t k = 0; k < sizeof machine; k++) ((char *)&machine)[k] = told[k];
    if (nck_init(&nck, &machine, NULL) != NCK_OK) return 3;
    size_t used = 0;
    unsigned cells = 0;
    nck_status_t status = NCK_OK;
    while (status != NCK_DONE && status >= NCK_OK) {
        status = nck_prep(&nck);
        if (status == NCK_EMPTY) feed(text, size, &used);
        else if (status == NCK_FULL) cells += consume(argc > 3);
    }
    while (status == NCK_DONE && nck_is_moving(&nck)) cells += consume(argc > 3);
    (void)printf("%u\n", cells);
    return status == NCK_DONE ? 0 : 1;
}
