// SPDX-License-Identifier: MIT
// Profiles with N look-ahead segments: the ramps' formulas against each other, every limit on
// random paths, exact lengths, and the first bad number told. The arrays have no spare row.
#include <math.h>   // fabs sqrt NAN INFINITY
#include <stddef.h> // NULL
#include <stdint.h> // uint64_t

#include "check.h"
#include "host/sshape.h"                  // nck_host_slope
#include "host/sshape_math.h" // nck_sshape_…
#include "host/sshape_piece.h" // nck_sshape_draw_ramp

enum { SEGMENTS = 40, PATHS = 3000 };

static double random_number(uint64_t *state, double low, double high)
{
    *state = *state * 6364136223846793005u + 1442695040888963407u;
    return low + (high - low) * (double)(*state >> 11) / 9007199254740992.0;
}

static void what_a_ramp_reaches_takes_the_whole_length(check_t *check)
{
    uint64_t state = 7;
    for (int k = 0; k < 20000; k++) {
        const double v = random_number(&state, 0.0, 20.0);
        const double length = pow(10.0, random_number(&state, -2.0, 2.0));
        const double a = random_number(&state, 1.0, 1000.0);
        const double j = pow(10.0, random_number(&state, 1.0, 5.0));
        const double reached = nck_sshape_reach(v, length, a, j);
        CHECK(check, reached > v);
        CHECK_NEAR(check, nck_sshape_length(v, reached, a, j) / length, 1.0, 1e-6);
    }
}

static void a_ramp_at_the_border_of_both_shapes_is_the_same_in_both(check_t *check)
{
    const double a = 50.0;
    const double j = 400.0;
    const double dv = a * a / j;
    CHECK_NEAR(check, nck_sshape_duration(dv, a, j), 2.0 * sqrt(dv / j), 1e-12);
    CHECK_NEAR(check, nck_sshape_peak(dv, a, j), a, 1e-12);
    CHECK_NEAR(check, nck_sshape_jerk(dv, 2.0 * sqrt(dv / j)), j, 1e-9);
}

// Its cells lead from speed to speed without a jump, and take the stretched time.
static void a_stretched_ramp_reaches_its_speed(check_t *check)
{
    const nck_sshape_piece_t piece = {10.0, 100.0, 500.0, 9000.0};
    const double speeds[][2] = {{3.0, 40.0}, {40.0, 3.0}, {5.0, 9.0}, {9.0, 5.0}};
    for (int k = 0; k < 4; k++) {
        for (double stretch = 1.0; stretch < 3.0; stretch += 0.7) {
            nck_cell_t cells[NCK_SSHAPE_CELLS];
            nck_sshape_pen_t pen = {cells, 0, 0, 0.0, speeds[k][0]};
            double v = speeds[k][0];
            double a = 0.0;
            double time = 0.0;
            nck_sshape_draw_ramp(&pen, &piece, speeds[k][1], stretch);
            CHECK_INT(check, pen.count, k < 2 ? 3 : 2); // the longer ones hold the acceleration
            for (uint32_t i = 0; i < pen.count; i++) {
                CHECK_NEAR(check, cells[i].v, v, 1e-9);
                CHECK_NEAR(check, cells[i].a, a, 1e-9);
                v += cells[i].duration * (cells[i].a + cells[i].duration * cells[i].j / 2.0);
                a += cells[i].duration * cells[i].j;
                time += cells[i].duration;
            }
            const double dv = fabs(speeds[k][1] - speeds[k][0]);
            CHECK_NEAR(check, v, speeds[k][1], 1e-9);
            CHECK_NEAR(check, a, 0.0, 1e-9);
            CHECK_NEAR(check, time, stretch * nck_sshape_duration(dv, 500.0, 9000.0), 1e-12);
        }
    }
}

// A path of n segments, n from 1 to SEGMENTS.
typedef struct path {
    double length[SEGMENTS], v_cap[SEGMENTS], a[SEGMENTS], j[SEGMENTS], v_node[SEGMENTS + 1];
    nck_host_path_t given;
} path_t;

static void make_path(path_t *path, uint64_t *state, uint32_t kind, size_t lookahead)
{
    const size_t n = 1 + (size_t)random_number(state, 0.0, SEGMENTS);
    for (size_t i = 0; i < n; i++) {
        path->length[i] = pow(10.0, random_number(state, -3.0, 1.0));
        path->v_cap[i] = random_number(state, 0.1, 20.0);
        path->a[i] = random_number(state, 10.0, 100.0);
        path->j[i] = pow(10.0, random_number(state, 1.0, 4.0));
    }
    for (size_t i = 0; i <= n; i++) {
        const double v = random_number(state, -5.0, 20.0);
        path->v_node[i] = v > 0.01 ? v : 0.0;
    }
    path->given = (nck_host_path_t){path->length, path->v_cap, path->a,  path->j, path->v_node,
                                    n,            lookahead,   kind,     0.0, NULL};
}

static void check_cells(check_t *check, const path_t *path, const double *v,
                        const nck_cell_t *cells, size_t count)
{
    double length = 0.0;
    double speed = v[0];
    for (size_t k = 0; k < count; k++) {
        const nck_cell_t *cell = &cells[k];
        const size_t i = cell->seg;
        const double a_end = cell->a + cell->j * cell->duration;
        CHECK_NEAR(check, cell->v, speed, 1e-7);
        speed = cell->v + cell->duration * (cell->a + cell->duration * cell->j / 2.0);
        CHECK(check, fabs(cell->a) <= path->a[i] * (1.0 + 1e-5));
        CHECK(check, fabs(a_end) <= path->a[i] * (1.0 + 1e-5) + 1e-9);
        CHECK(check, cell->v <= path->v_cap[i] * (1.0 + 1e-9));
        length += cell->length;
        if (!cell->last) continue;
        CHECK_NEAR(check, length / path->length[i], 1.0, 1e-9);
        CHECK_NEAR(check, speed, v[i + 1], 1e-7);
        CHECK(check, cell->stop == (v[i + 1] == 0.0));
        length = 0.0;
    }
}

static void every_profile_keeps_its_limits_and_lengths(check_t *check)
{
    static const size_t lookaheads[] = {0, 1, 2, 5, SEGMENTS};
    static path_t path;
    uint64_t state = 2014;
    double v[SEGMENTS + 1];
    nck_cell_t cells[NCK_HOST_SLOPE_CELLS * SEGMENTS];
    for (int k = 0; k < PATHS; k++) {
        size_t count = 0;
        size_t bad = 0;
        make_path(&path, &state, (uint32_t)(k % 3), lookaheads[k % 5]);
        CHECK_INT(check, nck_host_slope(&path.given, v, cells, &count, &bad), NCK_OK);
        CHECK(check, count >= path.given.n && count <= NCK_HOST_SLOPE_CELLS * path.given.n);
        for (size_t i = 0; i <= path.given.n; i++) CHECK(check, v[i] <= path.v_node[i]);
        check_cells(check, &path, v, cells, count);
    }
}

static void the_first_bad_number_is_told(check_t *check)
{
    static const double wrong[] = {(double)NAN, (double)INFINITY, -1.0, 0.0};
    static path_t path;
    uint64_t state = 1;
    double v[SEGMENTS + 1];
    nck_cell_t cells[NCK_HOST_SLOPE_CELLS * SEGMENTS];
    for (size_t k = 0; k < 16; k++) {
        size_t count = 1;
        size_t bad = 0;
        do make_path(&path, &state, NCK_HOST_RAMP_SSHAPE, 2);
        while (path.given.n < 5);
        double *arrays[] = {path.length, path.v_cap, path.a, path.j};
        arrays[k / 4][3] = wrong[k % 4];
        arrays[k / 4][4] = wrong[k % 4];
        CHECK_INT(check, nck_host_slope(&path.given, v, cells, &count, &bad), NCK_E_ARGUMENT);
        CHECK_INT(check, bad, 3);
        CHECK_INT(check, count, 0);
    }
}

static void a_sample_behind_the_end_stands_there(check_t *check)
{
    const double length[] = {4.0};
    const double one[] = {10.0};
    const double v_node[] = {0.0, 0.0};
    const nck_host_path_t path = {length, one, one, one, v_node, 1, 1, NCK_HOST_RAMP_LINEAR, 0.0,
                                  NULL};
    double v[2], s[5], speed[5], a[5];
    nck_cell_t cells[NCK_HOST_SLOPE_CELLS];
    size_t count = 0;
    size_t bad = 0;
    CHECK_INT(check, nck_host_slope(&path, v, cells, &count, &bad), NCK_OK);
    const nck_host_samples_t samples = {0.5, 5, s, speed, a};
    nck_host_slope_sample(cells, count, &samples);
    CHECK_NEAR(check, s[1], 0.5 * 10.0 * 0.25, 1e-12);
    CHECK_NEAR(check, speed[1], 5.0, 1e-12);
    CHECK_NEAR(check, s[4], 4.0, 1e-12);
    CHECK_NEAR(check, speed[4], 0.0, 0.0);
    CHECK_NEAR(check, a[4], 0.0, 0.0);
}

int main(void)
{
    check_t check = {0};
    CHECK_RUN(&check, what_a_ramp_reaches_takes_the_whole_length);
    CHECK_RUN(&check, a_ramp_at_the_border_of_both_shapes_is_the_same_in_both);
    CHECK_RUN(&check, a_stretched_ramp_reaches_its_speed);
    CHECK_RUN(&check, every_profile_keeps_its_limits_and_lengths);
    CHECK_RUN(&check, the_first_bad_number_is_told);
    CHECK_RUN(&check, a_sample_behind_the_end_stands_there);
    return check_end(&check);
}
