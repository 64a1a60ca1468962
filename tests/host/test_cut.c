// SPDX-License-Identifier: MIT
// A program that is cut at its rests: what was in force there goes with each part, and the parts
// add up to the plan of the whole.
#include <math.h>   // sin
#include <stdio.h>  // snprintf
#include <string.h> // strlen

#include "check.h"
#include "host/host.h" // nck_host_…

enum { TEXT = 1 << 17 };

static nck_t nck;
static nck_machine_t machine;
static nck_host_plan_t plan;
static nck_host_cut_t here, next;
static char text[TEXT];

// Micro-segments with rests; offsets, modes, tool and spindle change between them.
static void write_program(int moves)
{
    static const char *const things[] = {"G4 P0.0105\n", "M0\n", "T2 M6\nS900 M4\n", "G92 X5\n",
                                         "G91\nG4 P0.01\n", "G90\nG20\n", "M5\nM1\nG21\n", "G61\n"};
    const int count = (int)(sizeof things / sizeof *things);
    size_t used = (size_t)snprintf(text, TEXT, "G21 G90 G94 G17 G64 P0.02 S500 M3\nF6000\n");
    for (int k = 1; k <= moves; k++) {
        const char *const more = k % 61 == 0 ? things[k / 61 % count] : "";
        used += (size_t)snprintf(text + used, TEXT - used, "%sG1 X%.5f Y%.5f\n", more,
                                 0.001 * (k % 50), sin(k * 0.03));
    }
    snprintf(text + used, TEXT - used, "M2\n");
}

static nck_status_t run_plan(void)
{
    nck_status_t status = NCK_OK;
    while (status == NCK_OK) status = nck_host_plan_run(&plan);
    return status;
}

static nck_host_totals_t whole(check_t *check)
{
    nck_host_plan_init(&plan, &nck, &machine, text, strlen(text));
    CHECK_INT(check, run_plan(), NCK_DONE);
    return plan.totals;
}

static void parts_add_up_to_the_whole(check_t *check)
{
    nck_machine_default(&machine);
    machine.path.tolerance = 0.02;
    write_program(1500);
    if (nck_host_cut_init(&next, &machine, text, strlen(text)) != NCK_OK) {
        CHECK_INT(check, NCK_HAS_CALLS, 0); // nothing is cut in such a build
        return;
    }
    const nck_host_totals_t all = whole(check);
    nck_host_totals_t sum = {0};
    int parts = 0;
    for (nck_status_t found = NCK_OK; found == NCK_OK; parts++) {
        here = next;
        found = nck_host_cut_next(&next, 40);
        const uint64_t blocks = found == NCK_OK ? next.blocks - here.blocks : 0;
        nck_host_plan_init(&plan, &nck, &machine, text, strlen(text));
        CHECK_INT(check, nck_host_plan_part(&plan, &here, blocks), NCK_OK);
        CHECK_INT(check, run_plan(), NCK_DONE);
        sum.ticks += plan.totals.ticks;
        sum.blocks += plan.totals.blocks;
        sum.segs += plan.totals.segs;
        sum.cells += plan.totals.cells;
        sum.tool_changes += plan.totals.tool_changes;
        sum.spindle_starts += plan.totals.spindle_starts;
        sum.length_mm += plan.totals.length_mm;
    }
    CHECK(check, parts > 10);
    CHECK_INT(check, sum.ticks, all.ticks);
    CHECK_INT(check, sum.blocks, all.blocks);
    CHECK_INT(check, sum.segs, all.segs);
    CHECK_INT(check, sum.cells, all.cells);
    CHECK_INT(check, sum.tool_changes, all.tool_changes);
    CHECK_INT(check, sum.spindle_starts, all.spindle_starts);
    CHECK(check, sum.spindle_starts > 3 && sum.tool_changes > 1);
    CHECK(check, fabs(sum.length_mm - all.length_mm) < 1e-9 * all.length_mm);
}

static void an_error_ends_the_search(check_t *check)
{
    nck_machine_default(&machine);
    snprintf(text, TEXT, "G21 G90 G61 F600\nG1 X1\nG4 P0.1\nG1 X2 Q\nG4 P0.1\nM2\n");
    if (nck_host_cut_init(&next, &machine, text, strlen(text)) != NCK_OK) return;
    CHECK_INT(check, nck_host_cut_next(&next, 1), NCK_OK);
    CHECK_INT(check, nck_host_cut_next(&next, 1), NCK_DONE);
}

int main(void)
{
    check_t check = {0};
    CHECK_RUN(&check, parts_add_up_to_the_whole);
    CHECK_RUN(&check, an_error_ends_the_search);
    return check_end(&check);
}
