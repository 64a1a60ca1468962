// SPDX-License-Identifier: MIT
// The timed loops do the whole work, and only that.
#include <string.h> // strlen

#include "check.h"
#include "host/bench.h" // nck_host_bench_…
#include "host/host.h"  // nck_host_plan_t

enum { MOST = 4000, SEGS = 3 };

static const char text[] = "G21 G90 G94 G17\nG1 X1 F3000\nX2 Y1\nM0\nX0 Y0\nM2\n";
static nck_t nck;
static nck_machine_t machine;
static nck_host_plan_t plan;
static uint32_t ns[MOST];

static uint64_t planned_ticks(check_t *check)
{
    CHECK_INT(check, nck_host_plan_init(&plan, &nck, &machine, text, strlen(text)), NCK_OK);
    nck_status_t status = NCK_OK;
    while (status == NCK_OK) status = nck_host_plan_run(&plan);
    CHECK_INT(check, status, NCK_DONE);
    return plan.totals.ticks;
}

static void every_tick_of_a_program_is_timed(check_t *check)
{
    nck_host_times_t times = {ns, MOST, 0};
    nck_machine_default(&machine);
    const uint64_t ticks = planned_ticks(check);
    CHECK_INT(check, nck_host_bench_ticks(&nck, &machine, text, strlen(text), &times), NCK_OK);
    CHECK_INT(check, times.count, ticks);
    times.max = 10;
    CHECK_INT(check, nck_host_bench_ticks(&nck, &machine, text, strlen(text), &times), NCK_OK);
    CHECK_INT(check, times.count, 10);
    CHECK(check, nck_host_bench_clock() >= 0);
}

static void program_error_is_told(check_t *check)
{
    const char *const bad = "G21 G90 G94 G17\nG1 X1 F3000\nG1 QQ\n";
    nck_host_times_t times = {ns, MOST, 0};
    nck_machine_default(&machine);
    CHECK_INT(check, nck_host_bench_ticks(&nck, &machine, bad, strlen(bad), &times), NCK_E_NUMBER);
    CHECK(check, times.count > 0);
}

static void window_gives_every_piece_of_the_path(check_t *check)
{
    nck_seg_t segs[SEGS];
    size_t pieces = 0;
    memset(segs, 0, sizeof segs);
    nck_machine_default(&machine);
    machine.slope = NCK_SLOPE_LINEAR; // whose pieces come from the window
    for (uint32_t k = 0; k < SEGS; k++) {
        segs[k].seq = k;
        segs[k].start[0] = k;
        segs[k].end[0] = k + 1;
        segs[k].length = 1.0;
        segs[k].feed = 10.0;
        segs[k].feed_scale = 1.0;
    }
    CHECK(check, nck_host_bench_window(&nck.lookahead, &machine, segs, SEGS, &pieces) > 0);
    CHECK_INT(check, pieces, SEGS);
}

int main(void)
{
    check_t check = {0};
    CHECK_RUN(&check, every_tick_of_a_program_is_timed);
    CHECK_RUN(&check, program_error_is_told);
    CHECK_RUN(&check, window_gives_every_piece_of_the_path);
    return check_end(&check);
}
