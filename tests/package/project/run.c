// SPDX-License-Identifier: MIT
// Runs an NC program in the kernel, whichever way it came into this program, and prints the
// setpoints, one line per tick: run PROGRAM.
#include <stdio.h>

#include "nck/nck.h" // nck_t

static nck_machine_t machine;
static nck_t *nck;
static double memory[120000]; // more than any default build takes
static char text[1 << 20];

// One step of prep, fed with text; 0: nothing more to do before the next tick.
static int prepare(size_t size, size_t *fed) {
    const nck_status_t status = nck_prep(nck);
    size_t used = 0;
    if (status == NCK_EMPTY && *fed == size) nck_end(nck);
    if (status == NCK_EMPTY && *fed < size) (void)nck_push(nck, text + *fed, size - *fed, &used);
    *fed += used;
    return status == NCK_OK || status == NCK_EMPTY;
}

static int run(size_t size) {
    size_t fed = 0;
    while (prepare(size, &fed)) continue;
    while (!nck_is_idle(nck)) {
        nck_pose_t pose;
        nck_axes_t axes;
        if (nck_tick(nck, &pose, &axes) == NCK_TICK_WAIT) nck_resume(nck);
        printf("%lld %lld %lld\n", (long long)axes.joint_nm[0], (long long)axes.joint_nm[1],
               (long long)axes.joint_nm[2]);
        while (prepare(size, &fed)) continue;
    }
    return nck_prep(nck) == NCK_DONE ? 0 : 1;
}

int main(int count, char **arguments) {
    if (count != 2) return 2;
    FILE *const file = fopen(arguments[1], "rb");
    if (!file) return 2;
    const size_t size = fread(text, 1, sizeof text, file);
    fclose(file);
    nck_machine_default(&machine);
    machine.slope = NCK_SLOPE_LINEAR; // as in firmware_sim/examples, which have to give the same
    nck = nck_place(memory, sizeof memory);
    if (nck_init(nck, &machine, NULL) != NCK_OK) return 2;
    return run(size);
}
