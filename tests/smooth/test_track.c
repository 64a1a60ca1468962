// SPDX-License-Identifier: MIT
// Room 3: the program as elements, and how short lines become one while they are read.
#include <math.h>   // hypot sqrt
#include <string.h> // memcpy

#include "check.h"
#include "nck/base/path.h" // nck_path_point
#include "track_check.h"   // line_to

#define TAU 0.004    // [s]
#define FEED 100.0   // [mm/s]
#define P 0.01       // [mm]

enum { LINES = 6000 };

static double points[LINES + 1][2], places[LINES + 1];
static uint32_t state;

static double any(void)
{
    state = state * 1664525u + 1013904223u;
    return (double)(state >> 8) / 8388608.0 - 1.0;
}

static void begin(void)
{
    state = 1;
    begin_lines(TAU, FEED);
}

// Chords of so many mm, with noise beside and along them, as many as fit. Returns them.
static int fill_with_noise(double chord, double noise)
{
    int count = 0;
    begin();
    points[0][0] = points[0][1] = places[0] = 0.0;
    while (count < LINES) {
        const double x = chord * (count + 1) + noise * any();
        const double y = 0.05 * chord * (count + 1) + noise * any();
        if (line_to(x, y, P) == NCK_FULL) break;
        count++;
        points[count][0] = x;
        points[count][1] = y;
        places[count] = places[count - 1] + seg.length;
    }
    nck_track_seal(&track);
    return count;
}

static void joined_lines_leave_their_points_by_what_is_taken_off_the_tolerance(check_t *check)
{
    static const double chords[] = {0.001, 0.005, 0.02, 0.1};
    for (int n = 0; n < 4; n++) {
        const int count = fill_with_noise(chords[n], 0.15 * P);
        uint32_t near = 0;
        for (int k = 0; k < count; k++) {
            double point[NCK_AXIS_MAX];
            near = nck_track_find(&track, near, places[k]);
            nck_track_point(&track, near, places[k], point);
            const double off = hypot(point[0] - points[k][0], point[1] - points[k][1]);
            const double left = (double)nck_track_at(&track, near)->tolerance;
            CHECK(check, off <= P - left + 1e-9); // a float's rounding
            CHECK(check, left >= 0.5 * P - 1e-9);
        }
        CHECK(check, n == 3 || track.head - track.tail < (uint32_t)count);
    }
}

static void an_element_tells_the_line_it_begins_with(check_t *check)
{
    fill_with_noise(0.005, 0.001);
    for (uint32_t k = track.tail; k != track.head; k++) {
        const nck_track_element_t *const element = nck_track_at(&track, k);
        CHECK_NEAR(check, element->s, places[element->line - 1], 1e-9);
    }
}

// 2 µm of noise on chords of 20 µm: one of them an element would be all that the ring holds.
static void noise_is_seen_through_as_the_ring_fills(check_t *check)
{
    const int count = fill_with_noise(0.02, 0.002);
    CHECK(check, count == LINES || places[count] > 2.0 * 0.02 * (double)NCK_TRACK_SPAN);
    const int short_lines = fill_with_noise(0.0005, 0.0);
    const double least = 0.4 * TAU * FEED * (double)NCK_TRACK_SPAN;
    CHECK(check, short_lines == LINES || places[short_lines] > least);
}

static void no_line_is_longer_by_joining_than_half_a_knot(check_t *check)
{
    fill_with_noise(0.001, 0.0);
    for (uint32_t k = track.tail; k != track.head; k++) {
        CHECK(check, nck_track_at(&track, k)->length <= 0.5 * TAU * FEED + 1e-12);
    }
}

static void what_a_line_says_otherwise_begins_an_element(check_t *check)
{
    begin();
    line_to(0.01, 0.0, P);
    line_to(0.02, 0.0, P);
    CHECK_INT(check, track.head, 1);
    line_to(0.03, 0.0, 2.0 * P);
    CHECK_INT(check, track.head, 2);
    memcpy(seg.start, seg.end, sizeof seg.start);
    seg.feed = 0.5 * FEED;
    seg.end[0] = 0.04;
    seg.length = 0.01;
    nck_track_push(&track, &seg, 2.0 * P);
    CHECK_INT(check, track.head, 3);
    nck_track_seal(&track);
    line_to(0.05, 0.0, 2.0 * P);
    CHECK_INT(check, track.head, 4);
}

static void the_newest_line_is_not_known_before_it_is_whole(check_t *check)
{
    begin();
    line_to(0.01, 0.0, P);
    CHECK_NEAR(check, nck_track_known(&track), 0.0, 0.0);
    line_to(5.01, 0.0, P); // too long to be joined
    CHECK_NEAR(check, nck_track_known(&track), 0.01, 1e-15);
    nck_track_seal(&track);
    CHECK_NEAR(check, nck_track_known(&track), 5.01, 1e-15);
}

static void an_arc_stays_an_arc_and_goes_on_straight(check_t *check)
{
    double point[NCK_AXIS_MAX], tangent[NCK_AXIS_MAX], wanted[NCK_AXIS_MAX];
    begin();
    seg.kind = NCK_SEG_ARC;
    seg.end[0] = seg.end[1] = 2.0;
    seg.shape.arc.centre_v = 2.0;
    seg.shape.arc.sweep = 2.0 * atan(1.0);
    seg.shape.arc.axis_v = 1;
    seg.length = 2.0 * seg.shape.arc.sweep;
    seg.feed = FEED;
    nck_track_push(&track, &seg, P);
    for (int k = 0; k <= 10; k++) {
        const double s = 0.1 * k * seg.length;
        nck_path_point(&seg, s, wanted);
        nck_track_point(&track, 0, s, point);
        for (int x = 0; x < 2; x++) CHECK_NEAR(check, point[x], wanted[x], 0.0);
    }
    nck_path_tangent(&seg, seg.length, tangent);
    nck_track_point(&track, 0, seg.length + 0.5, point);
    for (int x = 0; x < 2; x++) {
        CHECK_NEAR(check, point[x], seg.end[x] + 0.5 * tangent[x], 1e-12);
    }
}

static void what_is_passed_makes_room(check_t *check)
{
    const int count = fill_with_noise(0.3, 0.0);
    CHECK_INT(check, count, NCK_TRACK_SPAN);
    CHECK(check, nck_track_is_full(&track));
    nck_track_drop(&track, 12.5 * 0.3, 2.0 * 0.3);
    CHECK_INT(check, track.tail, 10);
    CHECK_INT(check, nck_track_find(&track, 0, 0.0), 10);
    CHECK_INT(check, nck_track_find(&track, 0, 12.4 * 0.3), 12);
    CHECK_INT(check, nck_track_find(&track, 5000, 1e9), NCK_TRACK_SPAN - 1);
    nck_track_drop(&track, 0.3 * (double)NCK_TRACK_SPAN, 1e9);
    CHECK_INT(check, track.tail, NCK_TRACK_SPAN - 1 - NCK_TRACK_SPAN / 4);
    nck_track_drop(&track, 1e9, 0.0);
    CHECK_INT(check, track.tail, NCK_TRACK_SPAN - 1);
}

int main(void)
{
    check_t check = {0};
    CHECK_RUN(&check, joined_lines_leave_their_points_by_what_is_taken_off_the_tolerance);
    CHECK_RUN(&check, an_element_tells_the_line_it_begins_with);
    CHECK_RUN(&check, noise_is_seen_through_as_the_ring_fills);
    CHECK_RUN(&check, no_line_is_longer_by_joining_than_half_a_knot);
    CHECK_RUN(&check, what_a_line_says_otherwise_begins_an_element);
    CHECK_RUN(&check, the_newest_line_is_not_known_before_it_is_whole);
    CHECK_RUN(&check, an_arc_stays_an_arc_and_goes_on_straight);
    CHECK_RUN(&check, what_is_passed_makes_room);
    return check_end(&check);
}
