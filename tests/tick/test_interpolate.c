// SPDX-License-Identifier: MIT
// Room 6: time keeps its last digits however long the tool has not rested, no cell is left at
// either end, and the pose tells what goes on.
#include <math.h>   // fabs
#include <string.h> // memset

#include "check.h"
#include "nck/tick/6_interpolate/interpolate.h" // nck_interpolate_tick
#include "terms_check.h" // terms_of

#define LENGTH 1000.0
#define SPEED 100.0
#define PERIOD 0.01

static nck_machine_t machine;
static nck_link_t link_;
static nck_interpolate_t interpolate;

static void begin(void)
{
    nck_machine_default(&machine);
    machine.slope = NCK_SLOPE_LINEAR; // whose path coordinate no filter delays
    machine.period_s = PERIOD;
    nck_link_init(&link_);
    nck_interpolate_init(&interpolate, terms_of(&machine), &link_);
}

// One way of a shuttle along X, to and fro, at constant speed; it does not rest at its ends.
static void put_way(check_t *check, uint32_t seq, int stop)
{
    nck_seg_t seg;
    nck_cell_t cell;
    memset(&seg, 0, sizeof seg);
    memset(&cell, 0, sizeof cell);
    seg.seq = seq;
    seg.start[0] = seq % 2 ? LENGTH : 0.0;
    seg.end[0] = seq % 2 ? 0.0 : LENGTH;
    seg.length = LENGTH;
    cell.seg = seq;
    cell.last = 1;
    cell.stop = (uint8_t)stop;
    cell.length = LENGTH;
    cell.v = SPEED;
    cell.duration = LENGTH / SPEED;
    CHECK_INT(check, nck_link_push_seg(&link_, &seg), NCK_OK);
    CHECK_INT(check, nck_link_batch_begin(&link_), 0);
    nck_link_push_cell(&link_, &cell);
    CHECK_INT(check, nck_link_publish(&link_), NCK_OK);
}

// Largest second difference of X over one way, its ends left out [mm].
static double unevenness(double *x_out)
{
    const int ticks = (int)(LENGTH / SPEED / PERIOD);
    double before[2] = {0.0, 0.0};
    double most = 0.0;
    for (int k = 0; k < ticks; k++) {
        const double x = nck_interpolate_tick(&interpolate)->axis[0];
        if (k > 2 && k + 1 < ticks) most = fmax(most, fabs(x - 2.0 * before[1] + before[0]));
        before[0] = before[1];
        before[1] = x;
    }
    *x_out = before[1];
    return most;
}

static void speed_is_as_even_after_hours_as_at_first(check_t *check)
{
    const uint32_t ways = 2000;
    double x = 0.0;
    begin();
    put_way(check, 0, 0);
    for (uint32_t n = 0; n + 1 < ways; n++) {
        put_way(check, n + 1, n + 2 == ways);
        CHECK(check, unevenness(&x) <= 4e-12);
    }
    CHECK(check, unevenness(&x) <= 4e-12);
    CHECK(check, x == 0.0);
    CHECK_INT(check, nck_interpolate_tick(&interpolate)->state, NCK_TICK_IDLE);
}

static void put_cell(check_t *check, const nck_cell_t *cell)
{
    CHECK_INT(check, nck_link_batch_begin(&link_), 0);
    nck_link_push_cell(&link_, cell);
    CHECK_INT(check, nck_link_publish(&link_), NCK_OK);
}

// A line of 10 mm along X, behind 90 mm of path.
static void put_line(check_t *check)
{
    nck_seg_t seg;
    memset(&seg, 0, sizeof seg);
    seg.end[0] = 10.0;
    seg.length = 10.0;
    seg.s_begin = 90.0;
    CHECK_INT(check, nck_link_push_seg(&link_, &seg), NCK_OK);
}

// Speed and duration of a cell say 2.8 mm, its length says 2: rounding, made large.
static void no_setpoint_lies_beyond_a_cell(check_t *check)
{
    const nck_cell_t cell = {.stop = NCK_STOP_REST, .s = 1.0, .length = 2.0, .v = 40.0,
                             .duration = 0.07};
    begin();
    put_line(check);
    put_cell(check, &cell);
    for (int k = 1; k < 7; k++) {
        const double x = nck_interpolate_tick(&interpolate)->axis[0];
        CHECK_NEAR(check, x, fmin(1.0 + 0.4 * k, 3.0), 1e-12);
    }
    for (int k = 0; k < 3; k++) CHECK(check, nck_interpolate_tick(&interpolate)->axis[0] == 3.0);
}

static void no_setpoint_lies_before_a_cell(check_t *check)
{
    const nck_cell_t cell = {.stop = NCK_STOP_REST, .s = 1.0, .length = 1.0, .a = -10.0, .j = 1e3,
                             .duration = 0.1};
    begin();
    put_line(check);
    put_cell(check, &cell);
    double before = 1.0;
    for (int k = 1; k <= 12; k++) {
        const nck_pose_t *const pose = nck_interpolate_tick(&interpolate);
        CHECK(check, pose->axis[0] >= before && pose->v >= 0.0);
        before = pose->axis[0];
    }
    CHECK(check, before == 2.0);
}

// No tail, no further cell: prep is not to let that happen, but if it does the tool stays.
static void path_without_a_next_cell_stops_where_the_last_one_ends(check_t *check)
{
    const nck_cell_t first = {.length = 2.0, .v = 40.0, .duration = 0.05};
    const nck_cell_t next = {.stop = NCK_STOP_REST, .s = 2.0, .length = 1.0, .v = 20.0,
                             .duration = 0.05};
    begin();
    put_line(check);
    put_cell(check, &first);
    for (int k = 1; k < 5; k++) {
        CHECK_INT(check, nck_interpolate_tick(&interpolate)->state, NCK_TICK_MOVE);
    }
    for (int k = 0; k < 3; k++) {
        const nck_pose_t *const pose = nck_interpolate_tick(&interpolate);
        CHECK(check, pose->axis[0] == 2.0 && pose->v == 0.0);
        CHECK(check, pose->state == NCK_TICK_STARVED && pose->limit == NCK_LIMIT_STARVED);
    }
    put_cell(check, &next);
    CHECK_NEAR(check, nck_interpolate_tick(&interpolate)->axis[0], 2.2, 1e-12);
    for (int k = 0; k < 4; k++) (void)nck_interpolate_tick(&interpolate);
    CHECK(check, nck_interpolate_tick(&interpolate)->axis[0] == 3.0);
    CHECK_INT(check, nck_interpolate_tick(&interpolate)->state, NCK_TICK_IDLE);
    CHECK_INT(check, nck_interpolate_tick(&interpolate)->limit, NCK_LIMIT_EXACT_STOP);
}

static void brake_of_a_hold_is_told_from_its_first_period_to_the_end(check_t *check)
{
    const nck_cell_t cell = {.stop = NCK_STOP_REST | NCK_STOP_HOLD, .length = 2.0, .v = 80.0,
                             .a = -1600.0, .duration = 0.05};
    begin();
    put_line(check);
    put_cell(check, &cell);
    for (int k = 0; k < 9; k++) {
        CHECK_INT(check, nck_interpolate_tick(&interpolate)->state, NCK_TICK_HOLD);
    }
    CHECK(check, nck_interpolate_tick(&interpolate)->axis[0] == 2.0);
}

static void cells_are_taken_for_planning_but_never_those_of_a_tail(check_t *check)
{
    const nck_cell_t cell = {.stop = NCK_STOP_REST, .last = 1, .length = 10.0, .v = 100.0,
                             .duration = 0.1};
    nck_cell_t taken;
    begin();
    CHECK_INT(check, nck_interpolate_take(&interpolate, &taken), NCK_EMPTY);
    put_line(check);
    (void)nck_link_batch_begin(&link_);
    nck_link_push_cell(&link_, &cell);
    nck_link_tail_begin(&link_);
    nck_link_tail_push(&link_, &cell);
    CHECK_INT(check, nck_link_publish(&link_), NCK_OK);
    CHECK_INT(check, nck_interpolate_take(&interpolate, &taken), NCK_OK);
    CHECK(check, taken.length == 10.0 && taken.duration == 0.1);
    CHECK_INT(check, link_.seg_done, 1); // the cell is the last of its seg
    CHECK_INT(check, nck_interpolate_take(&interpolate, &taken), NCK_EMPTY);
}

static void spans_are_taken_off_time_and_periods_alike(check_t *check)
{
    for (int k = 1; k < 4000; k++) {
        const double t = 0.37 * k * k;
        double rest = t;
        const uint64_t periods = nck_interpolate_rebase(&rest, 1e-3);
        CHECK(check, periods % NCK_INTERPOLATE_SPAN == 0);
        CHECK_NEAR(check, (double)periods * 1e-3 + rest, t, 1e-15 * t);
        CHECK(check, fabs(rest) <= (double)NCK_INTERPOLATE_SPAN * 1e-3);
        CHECK_INT(check, nck_interpolate_rebase(&rest, 1e-3), 0);
    }
}

// Its time is a period's to the bit; less the span that is taken off both, it was rounded away.
static void a_cell_that_begins_at_a_tick_begins_there(check_t *check)
{
    for (int k = NCK_INTERPOLATE_SPAN + 1; k < NCK_INTERPOLATE_SPAN + 200; k++) {
        const double time = k * PERIOD;
        const nck_cell_t first = {.length = 5.0, .v = 5.0 / time, .duration = time};
        const nck_cell_t second = {.stop = NCK_STOP_REST, .last = 1, .s = 5.0, .length = 5.0,
                                   .v = 5.0 / time, .duration = time};
        begin();
        put_line(check);
        put_cell(check, &first);
        put_cell(check, &second);
        for (int n = 1; n < k; n++) (void)nck_interpolate_tick(&interpolate);
        CHECK(check, nck_interpolate_tick(&interpolate)->axis[0] == 5.0);
    }
}

static void landing_is_the_first_period_at_or_after_the_time(check_t *check)
{
    CHECK_INT(check, nck_interpolate_periods(0.0, 1e-3), 1);
    for (int k = 1; k < 100000; k++) {
        const double t = k * 1e-3;
        CHECK_INT(check, nck_interpolate_periods(t, 1e-3), k);
        CHECK_INT(check, nck_interpolate_periods(nextafter(t, 1e9), 1e-3), k + 1);
        CHECK_INT(check, nck_interpolate_periods(nextafter(t, 0.0), 1e-3), k);
    }
}

int main(void)
{
    check_t check = {0};
    CHECK_RUN(&check, speed_is_as_even_after_hours_as_at_first);
    CHECK_RUN(&check, no_setpoint_lies_beyond_a_cell);
    CHECK_RUN(&check, no_setpoint_lies_before_a_cell);
    CHECK_RUN(&check, path_without_a_next_cell_stops_where_the_last_one_ends);
    CHECK_RUN(&check, brake_of_a_hold_is_told_from_its_first_period_to_the_end);
    CHECK_RUN(&check, cells_are_taken_for_planning_but_never_those_of_a_tail);
    CHECK_RUN(&check, spans_are_taken_off_time_and_periods_alike);
    CHECK_RUN(&check, a_cell_that_begins_at_a_tick_begins_there);
    CHECK_RUN(&check, landing_is_the_first_period_at_or_after_the_time);
    return check_end(&check);
}
