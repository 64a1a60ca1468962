// SPDX-License-Identifier: MIT
// Room 3: the clock, from the program's shape and from a plan.
#include <math.h>   // cos sin sqrt cbrt
#include <string.h> // memcpy memset

#include "check.h"
#include "nck/prep/3_smooth/timing.h" // nck_timing_…
#include "track_check.h"              // line_to

#define P 0.01 // [mm]
// A line that one window holds from rest to rest, its feed reached.
#define LINE (NCK_FAIR_WINDOW > 100 ? 20.0 : 1.0) // [mm]
#define FEED (NCK_FAIR_WINDOW > 100 ? 80.0 : 15.0) // [mm/s]

static nck_timing_t clock_;
static nck_timing_list_t list;
static nck_timing_terms_t terms;
static nck_num plan[NCK_FAIR_KNOTS + 1];

static void keep(int from, int to, int blend)
{
    const int span[3] = {from, to, blend};
    nck_timing_begin_keep(&clock_, &list, &track, span);
    while (nck_timing_keep(&clock_, &list, &track, plan) == NCK_OK) continue;
}

static void begin(void)
{
    memset(&terms, 0, sizeof terms);
    terms.axes = 2;
    terms.tau = 0.004;
    for (int x = 0; x < 2; x++) {
        terms.v[x] = 100.0;
        terms.a[x] = 1000.0;
        terms.j[x] = terms.smooth[x] = 10000.0;
    }
    terms.a_least = 1000.0;
    terms.j_least = terms.smooth_least = 10000.0;
    terms.longest = 1.0;
    terms.v_most = 100.0;
    begin_lines(terms.tau, FEED);
    nck_timing_begin(&clock_, &terms);
    keep(0, 0, 0);
}

static void close_run(void)
{
    nck_track_seal(&track);
    clock_.closed = 1;
}

static nck_status_t make(void)
{
    nck_status_t status;
    do status = nck_timing_look(&clock_, &track);
    while (status == NCK_OK);
    if (status != NCK_DONE) return status;
    do status = nck_timing_make(&clock_, &list, &track);
    while (status == NCK_OK);
    return status;
}

// ds/du at the middle of a quarter.
static double speed(int k) { return (clock_.s[k + 1] - clock_.s[k]) / (0.25 * terms.tau); }

static void a_lone_line_is_left_and_met_at_rest_and_run_at_its_feed(check_t *check)
{
    begin();
    line_to(LINE, 0.0, P);
    close_run();
    CHECK_INT(check, make(), NCK_DONE);
    CHECK(check, clock_.begins && clock_.ends);
    const int last = 4 * clock_.knots;
    CHECK_NEAR(check, clock_.s[0], 0.0, 0.0);
    CHECK_NEAR(check, clock_.s[last], LINE, 1e-9);
    double most = 0.0;
    for (int k = 0; k < last; k++) {
        CHECK(check, clock_.s[k + 1] >= clock_.s[k]);
        most = speed(k) > most ? speed(k) : most;
    }
    CHECK_NEAR(check, most, FEED, (NCK_FAIR_WINDOW > 100 ? 0.03 : 0.1) * FEED); // of few knots
    CHECK(check, speed(0) < 1.0);
    CHECK(check, speed(last - 1) < 1.0);
}

// From rest, x behind it, no more than four tenths of the jerk: v³ = 4.5 · 0.4 J x².
static void a_rest_is_left_by_a_share_of_the_jerk(check_t *check)
{
    begin();
    line_to(LINE, 0.0, P);
    close_run();
    make();
    for (uint32_t k = clock_.guess.tail; k != clock_.guess.head; k++) {
        const nck_place_t *const place = &clock_.guess.at[k % NCK_TIMING_PLACES];
        const double x = place->s < 0.5 * LINE ? place->s : LINE - place->s;
        const double most = cbrt(4.5 * 4000.0 * x * x) * (1.0 + (double)NCK_NUM_EPSILON);
        CHECK(check, (double)place->v <= most + 1e-9);
    }
}

static void places_are_half_a_knot_apart_at_the_speed_there(check_t *check)
{
    begin();
    line_to(LINE, 0.0, P);
    close_run();
    make();
    const int places = (int)(clock_.guess.head - clock_.guess.tail);
    CHECK(check, 2 * places > 3 * clock_.knots);
    CHECK(check, places < 3 * clock_.knots);
}

// A corner, however long its lines are: v² ≤ 0.8² A·8P·2, each of three points P off.
static void a_corner_is_seen(check_t *check)
{
    begin();
    line_to(0.5 * LINE, 0.0, P);
    line_to(0.5 * LINE, 0.5 * LINE, P);
    close_run();
    make();
    double least = 100.0;
    for (int k = 0; k < 4 * clock_.knots; k++) {
        if (fabs(clock_.s[k] / LINE - 0.5) < 0.1 && speed(k) < least) least = speed(k);
    }
    CHECK(check, least < 0.8 * sqrt(1000.0 * 16.0 * P) * 1.1); // it is looked at near it
    CHECK(check, least > 3.0);
}

static void a_circle_of_chords_is_run_as_the_circle(check_t *check)
{
    static const double radii[] = {0.5, 1.0, 2.0};
    for (int n = 0; n < 3; n++) {
        const double r = radii[n];
        const double chord = 2.0 * sqrt(2.0 * r * 0.0005); // half a µm off
        nck_status_t status = NCK_OK;
        begin();
        for (int k = 1; status == NCK_OK && k * chord < 60.0; k++) {
            status = line_to(r * sin(k * chord / r), r - r * cos(k * chord / r), P);
        }
        make();
        if (clock_.knots < 110) continue; // so small a ring has no room to get there
        double sum = 0.0;
        for (int k = 300; k < 400; k++) sum += speed(k) / 100.0;
        const double wanted = sqrt(1000.0 * r) < cbrt(10000.0 * r * r) ? sqrt(1000.0 * r)
                                                                       : cbrt(10000.0 * r * r);
        CHECK(check, sum > 0.75 * wanted);
        CHECK(check, sum < 1.05 * wanted);
    }
}

static void more_is_asked_for_until_enough_is_known(check_t *check)
{
    begin();
    CHECK_INT(check, make(), NCK_EMPTY);
    line_to(0.5 * LINE, 0.0, P);
    line_to(LINE, 0.0, P);
    CHECK_INT(check, make(), NCK_EMPTY);
    close_run();
    CHECK_INT(check, make(), NCK_DONE);
}

static void a_plan_at_the_clocks_own_speed_leaves_it_as_it_is(check_t *check)
{
    static double before[NCK_TIMING_CELLS + 1];
    begin();
    line_to(0.5 * LINE, 0.0, P);
    line_to(0.5 * LINE, 0.5 * LINE, P);
    close_run();
    make();
    const int knots = clock_.knots;
    memcpy(before, clock_.s, sizeof before);
    for (int k = 0; k <= knots; k++) plan[k] = 1;
    keep(0, knots, 0);
    CHECK_INT(check, make(), NCK_DONE);
    CHECK_NEAR(check, clock_.knots, knots, 1.0); // the means round a corner of speed once more
    for (int k = 0; k <= 4 * knots; k++) CHECK_NEAR(check, clock_.s[k], before[k], 0.03);
}

static void a_plan_at_half_speed_takes_twice_as_long(check_t *check)
{
    begin();
    line_to(0.2 * LINE, 0.0, P);
    close_run();
    make();
    const int knots = clock_.knots;
    for (int k = 0; k <= knots; k++) plan[k] = (nck_num)0.25;
    keep(0, knots, 0);
    make();
    if (clock_.ends) CHECK(check, clock_.knots > 1.9 * knots && clock_.knots < 2.1 * knots);
    const int middle = knots < clock_.knots ? knots : clock_.knots;
    CHECK(check, fabs(clock_.s[4 * middle] - 0.1 * LINE) < 0.1);
}

static void a_window_goes_on_where_the_last_one_is_given(check_t *check)
{
    begin();
    line_to(60.0, 0.0, P);
    close_run();
    make();
    const int knots = clock_.knots, given = knots / 2;
    CHECK(check, !clock_.ends);
    const double s = clock_.s[4 * given], v = speed(4 * given);
    for (int k = 0; k <= knots; k++) plan[k] = 1;
    keep(given, knots - 12, 40);
    nck_timing_drop(&clock_, s);
    nck_track_drop(&track, s, 0.0);
    CHECK_INT(check, make(), NCK_DONE);
    CHECK(check, !clock_.begins);
    CHECK_NEAR(check, clock_.s[0], s, 0.0);
    CHECK_NEAR(check, speed(0), v, 0.02 * v);
}

int main(void)
{
    check_t check = {0};
    CHECK_RUN(&check, a_lone_line_is_left_and_met_at_rest_and_run_at_its_feed);
    CHECK_RUN(&check, a_rest_is_left_by_a_share_of_the_jerk);
    CHECK_RUN(&check, places_are_half_a_knot_apart_at_the_speed_there);
    CHECK_RUN(&check, a_corner_is_seen);
    CHECK_RUN(&check, a_circle_of_chords_is_run_as_the_circle);
    CHECK_RUN(&check, more_is_asked_for_until_enough_is_known);
    CHECK_RUN(&check, a_plan_at_the_clocks_own_speed_leaves_it_as_it_is);
    CHECK_RUN(&check, a_plan_at_half_speed_takes_twice_as_long);
    CHECK_RUN(&check, a_window_goes_on_where_the_last_one_is_given);
    return check_end(&check);
}
