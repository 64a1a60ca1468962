// SPDX-License-Identifier: MIT
// Room 5: legs keep the limits of their span and join without a jump; the brake comes to rest.
#include <math.h>   // fabs sqrt
#include <string.h> // memset

#include "check.h"
#include "nck/prep/5_slope/trapezoid.h" // nck_trapezoid_…

#define PERIOD 0.001

static nck_node_t piece(double length, double vv, double vv_piece)
{
    nck_node_t node;
    memset(&node, 0, sizeof node);
    node.length = length;
    node.a = 1000.0;
    node.vv = vv;
    node.vv_cap = vv;
    node.vv_piece = vv_piece;
    node.last = 1;
    return node;
}

static nck_span_t span(const nck_node_t *node, double vv_out)
{
    const nck_span_t all = {node->s, node->length, node->vv, vv_out, node->vv_piece, node->a};
    return all;
}

static double end_speed(const nck_cell_t *cell) { return cell->v + cell->a * cell->duration; }

static void cells_join_and_keep_the_limits(check_t *check)
{
    for (int k = 0; k < 5000; k++) {
        const double length = pow(10.0, -3.0 + k % 61 / 10.0);
        const double vv_piece = 1.0 + k % 97 * 100.0;
        const double vv0 = vv_piece * (k % 7) / 7.0;
        const double rise = fmin(vv_piece - vv0, 2000.0 * length);
        const double fall = fmin(vv0, 2000.0 * length);
        const double vv1 = k % 3 == 0 ? vv0 + rise : k % 3 == 1 ? vv0 - fall : vv0;
        const nck_node_t node = piece(length, vv0, vv_piece);
        nck_cell_t cells[NCK_TRAPEZOID_LEGS];
        const nck_span_t all = span(&node, vv1);
        const int count = nck_trapezoid_legs(&node, &all, PERIOD, cells);
        double s = 0.0;
        double v = sqrt(vv0);
        for (int n = 0; n < count; n++) {
            CHECK_NEAR(check, cells[n].v, v, 1e-9);
            CHECK_NEAR(check, cells[n].s, s, 1e-12 * length);
            CHECK(check, fabs(cells[n].a) <= 1000.0 * (1.0 + 1e-9));
            CHECK(check, cells[n].v * cells[n].v <= vv_piece * (1.0 + 1e-12));
            v = end_speed(&cells[n]);
            s += cells[n].length;
        }
        CHECK_NEAR(check, s, length, 1e-12 * length);
        CHECK_NEAR(check, v, sqrt(vv1), 1e-6);
        CHECK_INT(check, cells[count - 1].last, 1);
    }
}

static void long_piece_from_rest_to_rest_is_a_trapezoid(check_t *check)
{
    const nck_node_t node = piece(100.0, 0.0, 2500.0);
    nck_cell_t cells[NCK_TRAPEZOID_LEGS];
    const nck_span_t all = span(&node, 0.0);
    CHECK_INT(check, nck_trapezoid_legs(&node, &all, PERIOD, cells), 3);
    CHECK_NEAR(check, cells[0].duration, 0.05, 1e-15);
    CHECK_NEAR(check, cells[1].duration, (100.0 - 2.5) / 50.0, 1e-14);
    CHECK_NEAR(check, cells[2].duration, 0.05, 1e-15);
}

// Braked through pieces of a length until at rest; returns how many.
static int brake(check_t *check, const nck_node_t *node, double vv, double *length_out)
{
    int count = 0;
    int rests = 0;
    nck_span_t all = span(node, 1.0);
    all.vv_in = vv;
    *length_out = 0.0;
    while (!rests && count < 100) {
        nck_cell_t cell;
        rests = nck_trapezoid_brake(node, &all, &cell);
        *length_out += cell.length;
        all.vv_in = fmax(0.0, all.vv_in - 2.0 * all.a * all.length);
        count++;
        CHECK(check, cell.a >= -1000.0 * (1.0 + 1e-9));
        CHECK_INT(check, cell.stop, rests);
        CHECK_INT(check, cell.last, cell.length == all.length);
    }
    return count;
}

static void a_brake_comes_to_rest_on_the_path(check_t *check)
{
    double length = 0.0;
    const nck_node_t node = piece(0.7, 0.0, 10000.0);
    CHECK_INT(check, brake(check, &node, 10000.0, &length), 8);
    CHECK_NEAR(check, length, 5.0, 1e-12);
}

// Whether v² is used up at a piece's end is told in two ways, which round differently.
static void a_brake_that_ends_with_its_piece_comes_to_rest(check_t *check)
{
    for (int k = 0; k < 20000; k++) {
        const double length = 0.12 + k % 401 * 0.3e-15 - k % 997 * 1e-5;
        const nck_node_t node = piece(length, 0.0, 10000.0);
        double vv = 2000.0 * length;
        double braked = 0.0;
        for (int n = 0; n < k % 5; n++) vv = nextafter(vv, k % 2 ? 0.0 : 1e9);
        CHECK(check, brake(check, &node, vv, &braked) < 3);
    }
}

// A rest behind the piece is met, whatever is left of v².
static void a_brake_does_not_pass_a_rest(check_t *check)
{
    const nck_node_t node = piece(0.7, 0.0, 10000.0);
    nck_span_t all = span(&node, 0.0);
    all.vv_in = 2000.0 * 0.7 * (1.0 + 1e-12);
    nck_cell_t cell;
    CHECK_INT(check, nck_trapezoid_brake(&node, &all, &cell), 1);
    CHECK_INT(check, cell.stop, 1);
}

// An override has lowered the cap: down to it with all of a, along it, and on to the end.
static void what_is_too_fast_slows_down_first(check_t *check)
{
    nck_node_t node = piece(100.0, 10000.0, 2500.0);
    const nck_span_t all = span(&node, 0.0);
    nck_cell_t cells[NCK_TRAPEZOID_LEGS];
    CHECK_INT(check, nck_trapezoid_legs(&node, &all, PERIOD, cells), 3);
    CHECK_NEAR(check, cells[0].length, 3.75, 1e-12);
    CHECK_NEAR(check, cells[0].a, -1000.0, 1e-9);
    CHECK_NEAR(check, cells[1].v, 50.0, 1e-12);
    CHECK(check, cells[1].a == 0.0);
    CHECK_NEAR(check, end_speed(&cells[2]), 0.0, 1e-9);
}

static void dwell_is_a_rest_of_its_length(check_t *check)
{
    nck_node_t node = piece(0.0, 0.0, 0.0);
    node.kind = NCK_SEG_DWELL;
    node.stop = 1;
    node.standstill.dwell_s = 0.25;
    nck_cell_t cells[NCK_TRAPEZOID_LEGS];
    const nck_span_t all = span(&node, 0.0);
    CHECK_INT(check, nck_trapezoid_legs(&node, &all, PERIOD, cells), 1);
    CHECK(check, cells[0].duration == 0.25 && cells[0].length == 0.0 && cells[0].stop == 1);
}

int main(void)
{
    check_t check = {0};
    CHECK_RUN(&check, cells_join_and_keep_the_limits);
    CHECK_RUN(&check, long_piece_from_rest_to_rest_is_a_trapezoid);
    CHECK_RUN(&check, a_brake_comes_to_rest_on_the_path);
    CHECK_RUN(&check, a_brake_that_ends_with_its_piece_comes_to_rest);
    CHECK_RUN(&check, a_brake_does_not_pass_a_rest);
    CHECK_RUN(&check, what_is_too_fast_slows_down_first);
    CHECK_RUN(&check, dwell_is_a_rest_of_its_length);
    return check_end(&check);
}
