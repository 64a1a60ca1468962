// SPDX-License-Identifier: MIT
// The points of a plan: they add up to its time and to its limits, stand on the path, and lose no
// low point, however few rows the caller has.
#include <math.h>   // fabs hypot
#include <stdio.h>  // snprintf
#include <string.h> // strlen

#include "check.h"
#include "host/host.h" // nck_host_…

enum { ROWS = 4 * NCK_HOST_TRAIL_ROOM, MOST = 1 << 17, TEXT = 1 << 16 };

static nck_t nck;
static nck_machine_t machine;
static nck_host_plan_t plan;
static char text[TEXT];
static nck_host_point_t rows[ROWS], points[MOST];
static nck_host_foot_t foot_rows[ROWS], feet[MOST];
static size_t point_count, foot_count;

// Plan the text with so many rows a call. Returns how the plan ends.
static nck_status_t follow(size_t max)
{
    nck_status_t status = nck_host_plan_init(&plan, &nck, &machine, text, strlen(text));
    plan.why.trail.points = rows;
    plan.why.trail.feet = foot_rows;
    plan.why.trail.point_max = plan.why.trail.foot_max = max;
    point_count = foot_count = 0;
    while (status == NCK_OK) {
        status = nck_host_plan_run(&plan);
        const nck_host_trail_t *const trail = &plan.why.trail;
        memcpy(points + point_count, rows, trail->point_count * sizeof *rows);
        memcpy(feet + foot_count, foot_rows, trail->foot_count * sizeof *foot_rows);
        point_count += trail->point_count;
        foot_count += trail->foot_count;
    }
    return status;
}

// Corners, an arc of two turns, a dwell, a rapid, a change of feed.
static void write_program(int laps)
{
    size_t used = (size_t)snprintf(text, TEXT, "G21 G90 G94 G17 G61\nF3000\n");
    for (int k = 0; k < laps; k++) {
        used += (size_t)snprintf(text + used, TEXT - used,
                                 "G1 Y%d F3000\nX5\nX10 F900\nY10 F3000\n"
                                 "G2 X10 Y10 I-5 J0 P2 Z-1 F2000\n"
                                 "G4 P0.05\nG1 X0.3\nX0.2 Y0.1\nX0.1 Y0.3\nG0 X0 Y0 Z0\n", k % 3);
    }
    snprintf(text + used, TEXT - used, "M2\n");
}

static void begin(uint32_t slope, int laps)
{
    nck_machine_default(&machine);
    machine.slope = slope;
    write_program(laps);
}

// The limit of a stretch: of a ramp, that of its low point.
static uint32_t limit_of(size_t i, size_t *foot)
{
    while (*foot + 1 < foot_count && feet[*foot + 1].first <= i) (*foot)++;
    const uint32_t own = points[i].limit;
    return own == NCK_LIMIT_ACCEL || own == NCK_LIMIT_JERK ? feet[*foot].low.limit : own;
}

static void check_sums(check_t *check)
{
    double limit_s[NCK_LIMIT_AXIS_V + NCK_AXIS_MAX] = {0.0};
    size_t foot = 0;
    for (size_t i = 1; i < point_count; i++) {
        CHECK(check, points[i].t >= points[i - 1].t);
        limit_s[limit_of(i, &foot)] += points[i].t - points[i - 1].t;
    }
    CHECK_NEAR(check, points[point_count - 1].t, plan.totals.time_s, 1e-9);
    for (int k = 0; k < NCK_LIMIT_AXIS_V + NCK_AXIS_MAX; k++) {
        CHECK_NEAR(check, limit_s[k], plan.totals.limit_s[k], 1e-9);
    }
}

static void points_add_up_to_the_time_and_the_limits(check_t *check)
{
    for (uint32_t slope = NCK_SLOPE_LINEAR; slope <= NCK_SLOPE_JERK; slope++) {
        begin(slope, 5);
        CHECK_INT(check, follow(ROWS), NCK_DONE);
        check_sums(check);
    }
}

static void few_rows_give_the_same_points(check_t *check)
{
    begin(NCK_SLOPE_JERK, 40);
    CHECK_INT(check, follow(ROWS), NCK_DONE);
    const size_t count = point_count;
    const size_t lows = foot_count;
    const nck_host_point_t middle = points[count / 2];
    const nck_host_foot_t low = feet[lows / 2];
    CHECK_INT(check, follow(NCK_HOST_TRAIL_ROOM + 1), NCK_DONE);
    CHECK_INT(check, point_count, count);
    CHECK_INT(check, foot_count, lows);
    CHECK(check, memcmp(&points[count / 2], &middle, sizeof middle) == 0);
    CHECK(check, feet[lows / 2].at == low.at && feet[lows / 2].low.line == low.low.line);
    CHECK_INT(check, follow(NCK_HOST_TRAIL_ROOM), NCK_E_ARGUMENT);
}

static void an_arc_is_followed_to_a_few_micrometres(check_t *check)
{
    begin(NCK_SLOPE_JERK, 1);
    CHECK_INT(check, follow(ROWS), NCK_DONE);
    int on_arc = 0;
    for (size_t i = 1; i < point_count; i++) {
        if (points[i].line != 7 || points[i - 1].line != 7) continue;
        const double *const a = points[i - 1].xyz;
        const double *const b = points[i].xyz;
        const double u = 0.5 * (a[0] + b[0]) - 5.0;
        const double v = 0.5 * (a[1] + b[1]) - 10.0;
        CHECK_NEAR(check, hypot(b[0] - 5.0, b[1] - 10.0), 5.0, 1e-9);
        CHECK(check, hypot(u, v) > 5.0 - 0.0051);
        on_arc++;
    }
    CHECK(check, on_arc > 90);
}

static void a_low_point_is_the_point_where_its_corner_is(check_t *check)
{
    begin(NCK_SLOPE_JERK, 3);
    CHECK_INT(check, follow(ROWS), NCK_DONE);
    int corners = 0;
    int feeds = 0;
    for (size_t k = 0; k < foot_count; k++) {
        const nck_host_foot_t *const foot = &feet[k];
        CHECK(check, foot->at < point_count && foot->first <= foot->at + 1);
        CHECK(check, k == 0 || foot->first >= feet[k - 1].first);
        if (foot->at + 1 == point_count) continue;
        if (foot->low.limit == NCK_LIMIT_CORNER) {
            CHECK(check, points[foot->at].line != points[foot->at + 1].line);
        }
        corners += foot->low.limit == NCK_LIMIT_CORNER;
        feeds += foot->low.limit == NCK_LIMIT_FEED;
    }
    CHECK(check, corners >= 3);
    CHECK(check, feeds >= 3 || NCK_WINDOW < 256); // a short view stops there
}

static void speed_between_two_points_is_as_good_as_straight(check_t *check)
{
    begin(NCK_SLOPE_JERK, 2);
    CHECK_INT(check, follow(ROWS), NCK_DONE);
    double length = 0.0;
    for (size_t i = 1; i < point_count; i++) {
        length += 0.5 * (points[i].v + points[i - 1].v) * (points[i].t - points[i - 1].t);
    }
    CHECK_NEAR(check, length, plan.totals.length_mm, 2e-3 * plan.totals.length_mm);
}

int main(void)
{
    check_t check = {0};
    CHECK_RUN(&check, points_add_up_to_the_time_and_the_limits);
    CHECK_RUN(&check, few_rows_give_the_same_points);
    CHECK_RUN(&check, an_arc_is_followed_to_a_few_micrometres);
    CHECK_RUN(&check, a_low_point_is_the_point_where_its_corner_is);
    CHECK_RUN(&check, speed_between_two_points_is_as_good_as_straight);
    return check_end(&check);
}
