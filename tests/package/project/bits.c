// SPDX-License-Identifier: MIT
// What the arithmetic of a machine makes of programs: first the kernel's own test of it, then for
// every program and every slope the hash of all setpoints: bits PROGRAM …
#include <stdio.h>

#include "nck/nck.h" // nck_t

enum { SLOPES = 2 };

static nck_machine_t machine;
static nck_t *nck;
static double memory[120000]; // more than any default build takes
static char text[1 << 16];

// One step of prep, fed with text; 0: nothing more to do before the next tick.
static int prepare(size_t size, size_t *fed) {
    const nck_status_t status = nck_prep(nck);
    size_t used = 0;
    if (status == NCK_EMPTY && *fed == size) nck_end(nck);
    if (status == NCK_EMPTY && *fed < size) (void)nck_push(nck, text + *fed, size - *fed, &used);
    *fed += used;
    return status == NCK_OK || status == NCK_EMPTY;
}

// FNV-1a over words of 64 bits (Fowler, Noll, Vo, Eastlake: The FNV Non-Cryptographic Hash
// Algorithm, 2012), with its constants.
static uint64_t run(size_t size, unsigned long *ticks_out) {
    uint64_t hash = 0xcbf29ce484222325u;
    size_t fed = 0;
    while (prepare(size, &fed)) continue;
    while (!nck_is_idle(nck)) {
        nck_pose_t pose;
        nck_axes_t axes;
        if (nck_tick(nck, &pose, &axes) == NCK_TICK_WAIT) nck_resume(nck);
        for (int k = 0; k < 3; k++) hash = (hash ^ (uint64_t)axes.joint_nm[k]) * 0x100000001b3u;
        ++*ticks_out;
        while (prepare(size, &fed)) continue;
    }
    return hash;
}

static size_t read_file(const char *name) {
    FILE *const file = fopen(name, "rb");
    if (!file) return 0;
    const size_t size = fread(text, 1, sizeof text, file);
    fclose(file);
    return size;
}

int main(int count, char **arguments) {
    const uint8_t slopes[SLOPES] = {NCK_SLOPE_LINEAR, NCK_SLOPE_JERK};
    nck = nck_place(memory, sizeof memory);
    printf("%d\n", nck_selftest() == NCK_SELFTEST);
    for (int k = 1; k < count; k++) {
        const size_t size = read_file(arguments[k]);
        for (int n = 0; n < SLOPES; n++) {
            unsigned long ticks = 0;
            nck_machine_default(&machine);
            machine.slope = slopes[n];
            if (nck_init(nck, &machine, NULL) != NCK_OK) return 2;
            const uint64_t hash = run(size, &ticks);
            printf("%08lx%08lx %lu\n", (unsigned long)(hash >> 32),
                   (unsigned long)(hash & 0xffffffffu), ticks);
        }
    }
    return 0;
}
