// SPDX-License-Identifier: MIT
// Plans three nodes in bulk, on threads, and prints what the middle one may be passed at.
#include <stdio.h>

#include "host/envelope.h" // nck_host_envelope_double

int main(void) {
    const nck_host_choice_t choice = {NCK_HOST_THREADS, NCK_HOST_CPU_PLAIN, 2};
    const double vv_cap[3] = {100.0, 100.0, 100.0};
    const double h[2] = {50.0, 60.0};
    const nck_host_problem_double_t problem = {vv_cap, h, 3, 0.0, 0.0};
    double vv[3];
    nck_host_envelope_report_t report;
    if (nck_host_envelope_double(&choice, &problem, vv, &report) != NCK_OK) return 1;
    printf("%g %g %g\n", vv[0], vv[1], vv[2]);
    return 0;
}
