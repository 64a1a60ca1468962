// SPDX-License-Identifier: MIT
// What `pycnc time` tells of the text on stdin [s], with the capacities of this build, on the
// machine of the comparison with LinuxCNC; the argument is its slope, nck_slope_kind_t.
#include <stdio.h>  // fread printf
#include <stdlib.h> // atoi

#include "host/host.h"

enum { TEXT = 1 << 20 };

static nck_t nck;
static nck_host_plan_t plan;
static char text[TEXT];

int main(int argc, char **argv) {
    const size_t n = fread(text, 1, sizeof text, stdin);
    nck_status_t status = NCK_OK;
    nck_machine_t machine;
    if (argc != 2) return 3;
    nck_machine_default(&machine);
    machine.period_s = 1e-3;
    machine.slope = (uint32_t)atoi(argv[1]);
    machine.path.tolerance = 0.0;
    machine.path.feed_max = 300.0; // beyond what the axes can
    machine.path.a_max = 3e3;
    machine.path.j_max = 3e4;
    for (int x = 0; x < NCK_AXIS_MAX; x++) {
        nck_axis_t *const axis = &machine.axis[x];
        axis->present = x < 3;
        axis->v_max = axis->rapid = 100.0;
        axis->a_max = 1e3;
        axis->j_max = 1e4;
    }
    if (nck_host_plan_init(&plan, &nck, &machine, text, n) != NCK_OK) return 1;
    while (status == NCK_OK) status = nck_host_plan_run(&plan);
    printf("%.6f\n", plan.totals.time_s);
    return status == NCK_DONE ? 0 : 2;
}
