// SPDX-License-Identifier: MIT
// Bulk calls and the simulation, in the capacities of this build: nothing is lost at the
// end of an array, a plan takes as long as its run, and however few steps prep gets, a run comes to
// its end within the limits.
#include <math.h>   // fabs
#include <stdio.h>  // snprintf
#include <string.h> // strlen

#include "check.h"
#include "host/host.h" // nck_host_…
#include "sim.h"       // sim_t

enum { ROWS = 4 * NCK_WINDOW, TEXT = 1 << 18, TICKS = 512 };

static nck_t nck;
static nck_machine_t machine;
static nck_decode_t decode;
static nck_toolcomp_t toolcomp;
static nck_host_plan_t plan;
static sim_t sim;
static char text[TEXT];
static nck_block_t blocks[64];
static nck_diagnostic_t findings[64];
static nck_seg_t segs[ROWS];
static nck_node_t nodes[ROWS];
static nck_cell_t cells[ROWS];
static sim_row_t rows[TICKS];

// A wave of short moves in X and Y, with outputs, dwells and stops on the way.
static void write_wave(int moves)
{
    size_t used = (size_t)snprintf(text, TEXT, "G21 G90 G94 G17 G61\nF6000\n");
    for (int k = 1; k <= moves; k++) {
        const double x = k * 0.01;
        const double y = sin(x * 3.0);
        const char *const more = k % 331 == 0 ? "G4 P0.0105\n"
                                 : k % 97 == 0 ? "M8 S500\n" : k % 507 == 0 ? "M0\n" : "";
        used += (size_t)snprintf(text + used, TEXT - used, "%sG1 X%.5f Y%.5f\n", more, x, y);
    }
    snprintf(text + used, TEXT - used, "G0 X0 Y0\nM2\n");
}

static void begin(int moves)
{
    nck_machine_default(&machine);
    machine.path.a_max = 900.0;
    write_wave(moves);
}

// Decode a program from its begin, with arrays of so many rows.
static nck_host_decoding_t decoding_of(const void *program, size_t size, size_t block_rows,
                                       size_t finding_rows)
{
    nck_decode_init(&decode, &machine);
    nck_toolcomp_init(&toolcomp, &machine);
    return (nck_host_decoding_t){.text = program, .text_size = size,
                                 .blocks = blocks, .block_max = block_rows,
                                 .diagnostics = findings, .diagnostic_max = finding_rows};
}

// Go on to the end. Returns the sum over lines and targets.
static int64_t decoded_rest(check_t *check, nck_host_decoding_t *decoding, size_t *found)
{
    int64_t sum = 0;
    *found = 0;
    for (nck_status_t status = NCK_OK; status == NCK_OK;) {
        status = nck_host_decode(&decode, &toolcomp, decoding);
        CHECK(check, status == NCK_OK || status == NCK_DONE);
        for (size_t k = 0; k < decoding->block_count; k++) {
            sum += blocks[k].line + blocks[k].target_nm[0];
        }
        for (size_t k = 0; k < decoding->diagnostic_count; k++) sum += findings[k].line;
        *found += decoding->diagnostic_count;
    }
    CHECK_INT(check, decoding->text_used, decoding->text_size);
    return sum;
}

static int64_t decoded(check_t *check, const char *program, size_t block_rows, size_t finding_rows,
                       size_t *found)
{
    nck_host_decoding_t decoding =
        decoding_of(program, strlen(program), block_rows, finding_rows);
    return decoded_rest(check, &decoding, found);
}

static void decoding_in_small_pieces_finds_the_same(check_t *check)
{
    static const char bad[] = "G1 X1\nG1 QQ\nX2 F100\nU1\nG33\n\nM9\nX3\nM2\nX4\n";
    size_t found = 0;
    size_t pieces = 0;
    begin(200);
    const int64_t sum = decoded(check, text, 64, 64, &found);
    CHECK_INT(check, decoded(check, text, 1, 1, &pieces), sum);
    CHECK_INT(check, pieces, found);
    const int64_t bad_sum = decoded(check, bad, 64, 64, &found);
    CHECK_INT(check, decoded(check, bad, 2, 1, &pieces), bad_sum);
    CHECK_INT(check, pieces, found);
    CHECK(check, found >= 4);
}

static void pushed_blocks_in_small_pieces_give_the_same(check_t *check)
{
    enum { MOVES = 100 };
    static nck_block_in_t moves[MOVES];
    int64_t sums[2];
    size_t found[2];
    begin(1);
    memset(moves, 0, sizeof moves);
    for (uint32_t k = 0; k < MOVES; k++) {
        const double x = k % 7 == 3 ? 1e7 : k; // some are outside of the travel
        moves[k] = (nck_block_in_t){.id = k + 1, .kind = NCK_IN_LINE, .axes = 1, .target = {x},
                                    .sets = NCK_IN_SETS_FEED, .feed = 600.0};
    }
    for (size_t k = 0; k < 2; k++) {
        nck_host_decoding_t decoding = decoding_of(moves, sizeof moves, k ? 1 : 64, k ? 1 : 64);
        decoding.is_blocks = 1;
        sums[k] = decoded_rest(check, &decoding, &found[k]);
    }
    CHECK_INT(check, sums[1], sums[0]);
    CHECK_INT(check, found[0], MOVES / 7);
    CHECK_INT(check, found[1], found[0]);
}

static void decoding_stops_at_a_block_outside_of_its_range(check_t *check)
{
    nck_block_in_t moves[2] = {{.kind = NCK_IN_LINE, .axes = 1, .target = {1.0}},
                               {.kind = NCK_IN_LINE, .axes = 1, .target = {(double)NAN}}};
    begin(1);
    nck_host_decoding_t decoding = decoding_of(moves, sizeof moves, 64, 64);
    decoding.is_blocks = 1;
    CHECK_INT(check, nck_host_decode(&decode, &toolcomp, &decoding), NCK_E_ARGUMENT);
    CHECK_INT(check, decoding.text_used, sizeof moves[0]);
}

static void decoding_without_rows_is_refused(check_t *check)
{
    begin(1);
    for (size_t row = 0; row < 2; row++) {
        nck_host_decoding_t decoding = decoding_of(text, 5, row, 1 - row);
        CHECK_INT(check, nck_host_decode(&decode, &toolcomp, &decoding), NCK_E_ARGUMENT);
    }
}

static nck_status_t run_plan(int keep)
{
    nck_host_plan_init(&plan, &nck, &machine, text, strlen(text));
    if (keep) {
        plan.segs = segs;
        plan.nodes = nodes;
        plan.cells = cells;
        plan.seg_max = ROWS;
        plan.node_max = ROWS;
        plan.cell_max = ROWS;
    }
    uint64_t kept = 0;
    nck_status_t status = NCK_OK;
    while (status == NCK_OK) {
        status = nck_host_plan_run(&plan);
        kept += plan.seg_count + plan.node_count + plan.cell_count;
    }
    return keep && kept != plan.totals.segs + plan.totals.nodes + plan.totals.cells
               ? NCK_E_INTERNAL : status;
}

static void keeping_rows_changes_nothing_of_a_plan(check_t *check)
{
    begin(3000);
    CHECK_INT(check, run_plan(0), NCK_DONE);
    const nck_host_totals_t totals = plan.totals;
    CHECK_INT(check, run_plan(1), NCK_DONE);
    CHECK(check, memcmp(&totals, &plan.totals, sizeof totals) == 0);
    plan.seg_max = ROWS - 1;
    CHECK_INT(check, nck_host_plan_run(&plan), NCK_E_ARGUMENT);
}

// Run under the eyes of finite differences. Returns the ticks.
static uint64_t watched_run(check_t *check, uint32_t prep_steps, nck_status_t end)
{
    double before[2][2] = {{0.0, 0.0}, {0.0, 0.0}};
    const double most = 1000.0 * (1.0 + 1e-6) * 1e-6;
    CHECK_INT(check, sim_init(&sim, &nck, &machine, text, strlen(text), prep_steps), NCK_OK);
    nck_status_t status = NCK_OK;
    int good = 1;
    while (status == NCK_OK && sim.ticks < 1000000) {
        size_t count = 0;
        status = sim_run(&sim, rows, TICKS, &count);
        for (size_t k = 0; k < count; k++) {
            for (int x = 0; x < 2; x++) {
                const double p = rows[k].pose.axis[x];
                good = good && fabs(p - 2.0 * before[1][x] + before[0][x]) <= most;
                before[0][x] = before[1][x];
                before[1][x] = p;
            }
        }
    }
    CHECK(check, good);
    CHECK_INT(check, status, end);
    return sim.ticks;
}

static void plan_takes_as_long_as_its_run(check_t *check)
{
    begin(3000);
    for (machine.slope = NCK_SLOPE_LINEAR; machine.slope <= NCK_SLOPE_JERK; machine.slope++) {
        CHECK_INT(check, run_plan(0), NCK_DONE);
        CHECK_INT(check, watched_run(check, 1000, NCK_DONE), plan.totals.ticks);
        CHECK_INT(check, sim.starved_ticks, 0);
        CHECK(check, rows[0].feed_percent == 100 && rows[0].rapid_percent == 100);
        CHECK(check, sim.spindle_rpm == 500.0);
    }
}

static void starved_run_comes_to_its_end_within_the_limits(check_t *check)
{
    begin(3000);
    for (machine.slope = NCK_SLOPE_LINEAR; machine.slope <= NCK_SLOPE_JERK; machine.slope++) {
        for (uint32_t steps = 1; steps <= 5; steps++) {
            watched_run(check, steps, NCK_DONE);
            CHECK(check, steps > 1 || sim.starved_ticks > 0);
        }
    }
    CHECK_INT(check, sim_init(&sim, &nck, &machine, text, strlen(text), 0), NCK_E_ARGUMENT);
}

static void everything_before_an_error_is_executed(check_t *check)
{
    begin(1);
    machine.slope = NCK_SLOPE_LINEAR; // one step a tick is enough for it
    strcpy(text, "G21 G90 G94 G17\nG1 X1 F600\nX2\nG1 QQ\nX9\n");
    CHECK_INT(check, run_plan(0), NCK_E_NUMBER);
    const uint64_t ticks = plan.totals.ticks;
    CHECK_INT(check, watched_run(check, 1, NCK_E_NUMBER), ticks);
    size_t count = 0;
    CHECK_INT(check, sim_run(&sim, rows, TICKS, &count), NCK_E_NUMBER);
    CHECK_INT(check, count, 0);
    CHECK(check, nck.interpolate.pose.axis[0] == 2.0);
}

// Three hundred exact stops of a tick each, then a long move.
static void a_run_ends_when_the_kernel_says_so(check_t *check)
{
    begin(1);
    size_t used = (size_t)snprintf(text, TEXT, "G21 G90 G94 G17 G61.1 F3000\n");
    for (int k = 1; k <= 300; k++) {
        used += (size_t)snprintf(text + used, TEXT - used, "G1 X%.6f\n", k * 1e-4);
    }
    snprintf(text + used, TEXT - used, "X20\nM2\n");
    CHECK_INT(check, run_plan(0), NCK_DONE);
    CHECK_INT(check, watched_run(check, 1000, NCK_DONE), plan.totals.ticks);
    CHECK_INT(check, sim.end, SIM_END_DONE);
    CHECK(check, nck.interpolate.pose.axis[0] == 20.0);
}

static nck_status_t prep_that_says(void *user) { return *(const nck_status_t *)user; }

static void a_kernel_that_does_not_go_on_is_a_defect(check_t *check)
{
    static nck_status_t said[] = {NCK_OK, NCK_EMPTY, NCK_FULL};
    begin(1);
    for (int k = 0; k < 3; k++) {
        size_t count = 0;
        CHECK_INT(check, sim_init(&sim, &nck, &machine, text, strlen(text), 10), NCK_OK);
        sim_prepare_by(&sim, prep_that_says, &said[k]);
        CHECK_INT(check, sim_run(&sim, rows, TICKS, &count), NCK_E_INTERNAL);
        CHECK_INT(check, sim.end, SIM_END_STALLED);
        CHECK(check, count < TICKS);
    }
}

int main(void)
{
    check_t check = {0};
    CHECK_RUN(&check, decoding_in_small_pieces_finds_the_same);
    CHECK_RUN(&check, pushed_blocks_in_small_pieces_give_the_same);
    CHECK_RUN(&check, decoding_stops_at_a_block_outside_of_its_range);
    CHECK_RUN(&check, decoding_without_rows_is_refused);
    CHECK_RUN(&check, keeping_rows_changes_nothing_of_a_plan);
    CHECK_RUN(&check, plan_takes_as_long_as_its_run);
    CHECK_RUN(&check, starved_run_comes_to_its_end_within_the_limits);
    CHECK_RUN(&check, everything_before_an_error_is_executed);
    CHECK_RUN(&check, a_run_ends_when_the_kernel_says_so);
    CHECK_RUN(&check, a_kernel_that_does_not_go_on_is_a_defect);
    return check_end(&check);
}
