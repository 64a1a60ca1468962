// SPDX-License-Identifier: MIT
// A plan whose rooms work apart from each other has the bits of the kernel's own.
#include <math.h>   // sin
#include <stdio.h>  // snprintf
#include <string.h> // memcmp strlen

#include "check.h"
#include "host/host.h" // nck_host_…

enum { TEXT = 1 << 17, BLOCKS = 37, ROWS = 3 * NCK_HOST_BATCH_ROOM, PROGRAMS = 40 };

static nck_t nck, other;
static nck_machine_t machine;
static nck_host_plan_t plan, late;
static nck_host_early_t early;
static nck_decode_t decode;
static nck_toolcomp_t toolcomp;
static nck_block_t blocks[BLOCKS];
static nck_diagnostic_t findings[8];
static nck_host_batch_seg_t segs[ROWS];
static nck_seg_t wholes[ROWS];
static nck_node_t nodes[ROWS];
static nck_output_t outputs[ROWS];
static nck_mark_t marks[ROWS];
static uint8_t orders[8 * ROWS];
static char text[TEXT];
static nck_host_batch_t batch = {segs, ROWS, 0, wholes, ROWS, 0, nodes, ROWS, 0, outputs, ROWS, 0,
                                 marks, ROWS, 0, orders, 8 * ROWS, 0, 0, 0};

static nck_status_t run(nck_host_plan_t *self)
{
    nck_status_t status = NCK_OK;
    while (status == NCK_OK) status = nck_host_plan_run(self);
    return status;
}

// All batches that the blocks fill are planned. Returns what the later rooms said last.
static nck_status_t feed(const nck_block_t *from, size_t n, int *anew)
{
    nck_status_t said = NCK_EMPTY;
    nck_host_early_give(&early, from, n);
    while (said == NCK_EMPTY) {
        const nck_status_t status = nck_host_early_run(&early, &batch, *anew);
        *anew = status == NCK_OK;
        if (status < NCK_OK) return status;
        if (status == NCK_EMPTY) return NCK_EMPTY;
        nck_host_plan_take(&late, &batch);
        said = run(&late);
    }
    return said;
}

static nck_status_t plan_apart(void)
{
    nck_host_decoding_t decoding = {text, strlen(text), 0, 0, blocks, BLOCKS, 0, findings, 8, 0};
    nck_status_t read = NCK_OK;
    nck_status_t status = NCK_EMPTY;
    int anew = 1;
    nck_decode_init(&decode, &machine);
    nck_toolcomp_init(&toolcomp, &machine);
    (void)nck_host_early_init(&early, &machine);
    (void)nck_host_plan_init(&late, &other, &machine, text, 0);
    while (read == NCK_OK && status == NCK_EMPTY) {
        read = nck_host_decode(&decode, &toolcomp, &decoding);
        status = feed(blocks, decoding.block_count, &anew);
    }
    return status == NCK_EMPTY ? feed(blocks, 0, &anew) : status;
}

static void both_are_equal(check_t *check, nck_status_t expected)
{
    (void)nck_host_plan_init(&plan, &nck, &machine, text, strlen(text));
    CHECK_INT(check, run(&plan), expected);
    CHECK_INT(check, plan_apart(), expected);
    CHECK_INT(check, memcmp(&plan.totals, &late.totals, sizeof plan.totals), 0);
    CHECK_INT(check, memcmp(plan.why.causes, late.why.causes, sizeof plan.why.causes), 0);
    CHECK_INT(check, plan.why.shares.tool, late.why.shares.tool);
}

static void add(size_t *used, const char *words)
{
    *used += (size_t)snprintf(text + *used, TEXT - *used, "%s", words);
}

// Micro-segments, corners and rests; outputs, modes, tools and offsets change among them.
static void write_program(int moves, const char *mode)
{
    static const char *const things[] = {
        "G4 P0.01\n", "M0\n", "T1 M6\nG43 H1\n", "M8\n", "G61.1\nX0 Y0\n", "M3 S500\n",
        "G91 G2 X1 Y1 I1 J0\nG90\n", "G0 Z1\nG1 Z0\n", "G64 P0.05\n", "G91\nX0.5\nG90\n",
        "F300\n", "G61\n", "M9\n"};
    const int count = (int)(sizeof things / sizeof *things);
    size_t used = 0;
    add(&used, "G21 G90 G94 G17 F3000\n");
    add(&used, mode);
    for (int k = 1; k <= moves; k++) {
        if (k % 41 == 0) add(&used, things[k / 41 % count]);
        used += (size_t)snprintf(text + used, TEXT - used, "G1 X%.4f Y%.4f\n",
                                 0.03 * (k % 70), 0.5 * sin(k * 0.07));
    }
    add(&used, "M2\nG1 X5\n");
}

static void take_machine(uint32_t slope)
{
    nck_machine_default(&machine);
    machine.slope = slope;
    machine.tool[0].number = 1;
    machine.tool[0].offset_nm[2] = 1000000;
    machine.tool_count = 1;
}

static void rooms_apart_give_the_bits_of_the_kernel(check_t *check)
{
    static const char *const modes[] = {"G61\n", "G64 P0.02\n", "G61.1\n"};
    for (uint32_t slope = NCK_SLOPE_LINEAR; slope <= NCK_SLOPE_JERK; slope++) {
        take_machine(slope);
        if (nck_machine_check(&machine) != NCK_OK) continue; // the build has no such slope
        for (int k = 0; k < 3; k++) {
            write_program(2500, modes[k]);
            both_are_equal(check, NCK_DONE);
        }
    }
}

// Xorshift, G. Marsaglia 2003: the same numbers everywhere.
static uint32_t random_below(uint64_t *seed, uint32_t n)
{
    *seed ^= *seed << 13;
    *seed ^= *seed >> 7;
    *seed ^= *seed << 17;
    return (uint32_t)(*seed >> 33) % n;
}

// Runs of moves of one length, straight or winding, and what comes between runs.
static void write_random(uint64_t seed, uint32_t doublings)
{
    static const char *const things[] = {
        "G4 P0.002\n", "G4 P0.1\n", "M0\n", "M8\n", "G61\n", "G64 P0.02\n", "G64 P0.5\n",
        "G61.1\n", "F200\n", "F6000\n", "G2 X0.5 Y0.5 I0.5 J0\n", "G3 X0 Y0.2 I0 J0.1\n",
        "G0 X3 Z1\n", "M62 P1\n", "S100 M4\n", "T1 M6\n"};
    const uint32_t count = (uint32_t)(sizeof things / sizeof *things);
    size_t used = 0;
    double angle = 0.0;
    add(&used, "G21 G91 G94 G17 F3000\n");
    for (int run_of = 0; run_of < 25; run_of++) {
        const double length = 0.002 * (double)(1u << random_below(&seed, doublings));
        const double turn = random_below(&seed, 3) * random_below(&seed, 100) * 0.002;
        add(&used, things[random_below(&seed, count)]);
        for (uint32_t k = random_below(&seed, 80); k > 0; k--) {
            angle += turn * (random_below(&seed, 4) == 0 ? -1.0 : 1.0);
            used += (size_t)snprintf(text + used, TEXT - used, "G1 X%.4f Y%.4f\n",
                                     length * cos(angle), length * sin(angle));
        }
    }
    add(&used, "M2\n");
}

static void random_programs_have_the_bits_of_the_kernel(check_t *check)
{
    for (uint64_t seed = 1; seed <= PROGRAMS; seed++) {
        take_machine((uint32_t)(seed % 3));
        machine.lookahead_blocks = seed % 7 == 0 ? 10 : 0;
        if (nck_machine_check(&machine) != NCK_OK) continue; // the build has no such slope
        // A curve costs by what it lasts: a way as long would be minutes.
        write_random(seed * 0x9E3779B97F4A7C15u, machine.slope == NCK_SLOPE_OPTIMAL ? 7 : 12);
        both_are_equal(check, NCK_DONE);
        if (check->broken) {
            printf("program %d, slope %d\n", (int)seed, (int)machine.slope);
            return;
        }
    }
}

// Only blocks that no text makes are wrong for a later room alone.
static void an_error_of_a_later_room_ends_the_path(check_t *check)
{
    int anew = 1;
    take_machine(NCK_SLOPE_LINEAR);
    snprintf(text, TEXT, "G21 G90 G61 F600\nG1 X1\nX2\nX3\nM2\n");
    (void)plan_apart();
    blocks[2].feed = 0.0;
    (void)nck_host_early_init(&early, &machine);
    (void)nck_host_plan_init(&late, &other, &machine, text, 0);
    CHECK_INT(check, feed(blocks, 4, &anew), NCK_E_FEED_MISSING);
    CHECK_INT(check, late.totals.segs, 2);
    CHECK_NEAR(check, late.totals.length_mm, 2.0, 0.0);
}

static void a_program_is_planned_to_its_end(check_t *check)
{
    take_machine(NCK_SLOPE_LINEAR);
    snprintf(text, TEXT, "G21 G90 G61 F600\nG1 X1\nX2");
    both_are_equal(check, NCK_DONE);
    snprintf(text, TEXT, "G21 G90 G61 F600\nG1 X1\nM0\nG1 X2\nM2\n");
    both_are_equal(check, NCK_DONE);
}

// The kernel rests before its ring of outputs runs over, and where hangs on how full its rings are.
static void rings_full_of_outputs_are_left_to_the_kernel(check_t *check)
{
    size_t used = 0;
    take_machine(NCK_SLOPE_LINEAR);
    add(&used, "G21 G90 G61 F600\nG1 X1\n");
    for (int k = 0; k <= NCK_OUTPUT_MAX / 2; k++) add(&used, "M8\nM9\n");
    add(&used, "G1 X2\nM2\n");
    (void)nck_host_plan_init(&plan, &nck, &machine, text, strlen(text));
    CHECK_INT(check, run(&plan), NCK_DONE);
    CHECK_INT(check, plan_apart(), NCK_E_STATE);
}

int main(void)
{
    check_t check = {0};
    CHECK_RUN(&check, rooms_apart_give_the_bits_of_the_kernel);
    CHECK_RUN(&check, random_programs_have_the_bits_of_the_kernel);
    CHECK_RUN(&check, an_error_of_a_later_room_ends_the_path);
    CHECK_RUN(&check, a_program_is_planned_to_its_end);
    CHECK_RUN(&check, rings_full_of_outputs_are_left_to_the_kernel);
    return check_end(&check);
}
