// SPDX-License-Identifier: MIT
// What two motions that overlap at a corner ask of the axes, by numbers made by hand; and a cell in
// parts.
#include <string.h> // memset

#include "check.h"
#include "nck/base/cell_math.h"    // nck_cell_part
#include "nck/base/overlap_math.h" // nck_overlap_…

static nck_machine_t machine;

static const double x_on[NCK_AXIS_MAX] = {1.0};
static const double x_back[NCK_AXIS_MAX] = {-1.0};
static const double y_on[NCK_AXIS_MAX] = {0.0, 1.0};
static const double slanted[NCK_AXIS_MAX] = {0.6, 0.8};

static void begin(void)
{
    nck_machine_default(&machine);
    for (int x = 0; x < NCK_AXIS_MAX; x++) {
        machine.axis[x].present = x < 3;
        machine.axis[x].a_max = 100.0;
        machine.axis[x].j_max = 1000.0;
    }
}

static nck_overlap_t motions_of(const double *in, const double *out, double turn_in,
                                double turn_out)
{
    const nck_overlap_t motions = {in, out, {400.0, 300.0}, {turn_in, turn_out}};
    return motions;
}

static double jerk_of(const nck_overlap_t *motions)
{
    return nck_overlap_jerk(&machine, NCK_AXIS_MAX, motions);
}

static double most_of(const nck_overlap_t *motions)
{
    return nck_overlap_most(&machine, NCK_AXIS_MAX, motions);
}

static double sum_of(const nck_overlap_t *motions)
{
    return nck_overlap_sum(&machine, NCK_AXIS_MAX, motions);
}

static double load_of(const nck_overlap_t *motions)
{
    return nck_overlap_load(&machine, NCK_AXIS_MAX, motions);
}

static void same_way_jerks_add_up(check_t *check)
{
    const nck_overlap_t straight = motions_of(x_on, x_on, 0.0, 0.0);
    const nck_overlap_t slant = motions_of(x_on, slanted, 0.0, 0.0);
    begin();
    CHECK_NEAR(check, jerk_of(&straight), 0.7, 1e-15);
    CHECK_NEAR(check, jerk_of(&slant), 0.4 + 0.18, 1e-15);
    CHECK_NEAR(check, sum_of(&slant), 0.4 + 0.18, 1e-15);
    CHECK(check, most_of(&slant) == NCK_OVERLAP_FREE); // accelerations are of either sign
}

static void opposite_ways_accelerations_add_up(check_t *check)
{
    const nck_overlap_t motions = motions_of(x_on, x_back, 0.0, 0.0);
    begin();
    CHECK_NEAR(check, jerk_of(&motions), 0.4, 1e-15);
    CHECK_NEAR(check, sum_of(&motions), 0.7, 1e-15);
    CHECK_NEAR(check, most_of(&motions), 100.0 / 400.0, 1e-15);
}

// Any order in time where an axis that has its own motion gets a tenth more by it at most.
static void a_little_of_another_motion_may_come_at_any_time(check_t *check)
{
    static const double up[NCK_AXIS_MAX] = {-0.1, 1.0};
    static const double on[NCK_AXIS_MAX] = {1.0, 0.0};
    nck_overlap_t motions = motions_of(on, up, 0.0, 0.0);
    begin();
    motions.j[0] = 1000.0;
    motions.j[1] = 1000.0;
    CHECK_NEAR(check, sum_of(&motions), 1.1, 1e-15);
    CHECK_NEAR(check, load_of(&motions), 1.1, 1e-15);
    motions.j[1] = 1001.0;
    CHECK_NEAR(check, sum_of(&motions), 1.1001, 1e-15);
    CHECK_NEAR(check, load_of(&motions), 1.001, 1e-15); // opposite ways the larger one counts
}

static void at_a_right_angle_each_has_its_axis(check_t *check)
{
    const nck_overlap_t motions = motions_of(x_on, y_on, 0.0, 0.0);
    begin();
    CHECK_NEAR(check, jerk_of(&motions), 0.4, 1e-15);
    machine.axis[1].j_max = 500.0;
    CHECK_NEAR(check, jerk_of(&motions), 0.6, 1e-15);
    CHECK_NEAR(check, sum_of(&motions), 0.6, 1e-15);
    CHECK(check, most_of(&motions) == NCK_OVERLAP_FREE);
}

// The first motion may turn onto Y and Z by a tenth.
static void what_turns_may_move_every_axis(check_t *check)
{
    const nck_overlap_t motions = motions_of(x_on, y_on, 0.1, 0.0);
    begin();
    CHECK_NEAR(check, jerk_of(&motions), 0.44, 1e-15); // X has no other
    machine.axis[1].j_max = 500.0;
    CHECK_NEAR(check, jerk_of(&motions), (40.0 + 300.0) / 500.0, 1e-15);
    CHECK_NEAR(check, sum_of(&motions), (40.0 + 300.0) / 500.0, 1e-15);
    CHECK_NEAR(check, most_of(&motions), 100.0 / 300.0, 1e-15);
    machine.axis[1].present = 0;
    CHECK_NEAR(check, most_of(&motions), 100.0 / 40.0, 1e-15);
    machine.axis[2].present = 0;
    CHECK_NEAR(check, sum_of(&motions), 0.44, 1e-15);
    CHECK(check, nck_overlap_turn(NCK_SEG_LINE) == 0.0);
    CHECK(check, nck_overlap_turn(NCK_SEG_SPLINE) == NCK_OVERLAP_TURN);
}

// Halfway both are as far from the corner, and the place is off it by the tolerance.
static void halfway_the_corner_is_cut_by_the_tolerance(check_t *check)
{
    const double tolerance = 0.01;
    const double j = 400.0;
    const double turn = sqrt(0.4 * 0.4 + 0.8 * 0.8);
    const double d = nck_overlap_distance(tolerance, 0.0, turn, turn);
    const double half = nck_overlap_time(d, j);
    const double gone = j * half * half * half / 6.0;
    CHECK_NEAR(check, gone, d, 1e-15);
    CHECK_NEAR(check, hypot(gone * (slanted[0] - 1.0), gone * slanted[1]), tolerance, 1e-15);
    CHECK_NEAR(check, nck_overlap_time(8.0, 6.0), 2.0, 1e-14);
}

// Outside of the corner the first motion would rest; halfway both are as far inside.
static void outside_of_the_corner_halfway_is_further(check_t *check)
{
    const double n[2] = {0.8, -0.6};
    const double w[2] = {-1.1, 0.7};
    const double turn = hypot(w[0], w[1]);
    const double along = -(n[0] * w[0] + n[1] * w[1]);
    const double d = nck_overlap_distance(0.01, 0.007, along, turn);
    CHECK_NEAR(check, hypot(0.007 * n[0] + d * w[0], 0.007 * n[1] + d * w[1]), 0.01, 1e-15);
    CHECK(check, d > nck_overlap_distance(0.01, 0.0, turn, turn));
    CHECK_NEAR(check, nck_overlap_distance(0.01, 0.01, turn, turn), 0.02 / turn, 1e-15);
}

// ---- a cell in parts

static nck_cell_t long_cell(void)
{
    nck_cell_t cell;
    memset(&cell, 0, sizeof cell);
    cell.seg = 7;
    cell.limit = NCK_LIMIT_JERK;
    cell.stop = NCK_STOP_REST;
    cell.last = 1;
    cell.s = 3.0;
    cell.v = 20.0;
    cell.a = -30.0;
    cell.j = 40.0;
    cell.duration = 0.5;
    cell.length = nck_cell_way(&cell, 0.5);
    return cell;
}

static void all_of_a_cell_is_the_cell(check_t *check)
{
    nck_cell_t cell = long_cell();
    nck_cell_t part;
    cell.length += 1e-9; // rounding, made large: the end stays where the cell has it
    nck_cell_part(&cell, 0.0, cell.duration, &part);
    CHECK(check, part.s == cell.s && part.length == cell.length && part.v == cell.v);
    CHECK(check, part.a == cell.a && part.j == cell.j && part.duration == cell.duration);
    CHECK(check, part.stop == cell.stop && part.last == cell.last && part.seg == cell.seg);
}

static void parts_add_up_to_their_cell(check_t *check)
{
    const double at[] = {0.0, 0.1, 0.125, 0.4999999, 0.5};
    const nck_cell_t cell = long_cell();
    double length = 0.0;
    double duration = 0.0;
    for (int k = 0; k < 4; k++) {
        nck_cell_t part;
        const int is_last = k == 3;
        nck_cell_part(&cell, at[k], at[k + 1], &part);
        CHECK_NEAR(check, part.s, cell.s + length, 1e-14);
        CHECK_NEAR(check, part.v, 20.0 - 30.0 * at[k] + 20.0 * at[k] * at[k], 1e-13);
        CHECK_NEAR(check, part.a, -30.0 + 40.0 * at[k], 1e-13);
        CHECK_NEAR(check, nck_cell_way(&part, part.duration), part.length, 1e-14);
        CHECK(check, part.j == cell.j && part.limit == NCK_LIMIT_JERK && part.seg == 7);
        CHECK_INT(check, part.stop, is_last ? NCK_STOP_REST : 0);
        CHECK_INT(check, part.last, is_last);
        length += part.length;
        duration += part.duration;
    }
    CHECK_NEAR(check, length, cell.length, 1e-14);
    CHECK_NEAR(check, duration, cell.duration, 1e-15);
}

int main(void)
{
    check_t check = {0};
    CHECK_RUN(&check, same_way_jerks_add_up);
    CHECK_RUN(&check, opposite_ways_accelerations_add_up);
    CHECK_RUN(&check, a_little_of_another_motion_may_come_at_any_time);
    CHECK_RUN(&check, at_a_right_angle_each_has_its_axis);
    CHECK_RUN(&check, what_turns_may_move_every_axis);
    CHECK_RUN(&check, halfway_the_corner_is_cut_by_the_tolerance);
    CHECK_RUN(&check, outside_of_the_corner_halfway_is_further);
    CHECK_RUN(&check, all_of_a_cell_is_the_cell);
    CHECK_RUN(&check, parts_add_up_to_their_cell);
    return check_end(&check);
}
