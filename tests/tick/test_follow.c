// SPDX-License-Identifier: MIT
// Room 6 alone: how the tool follows the spindle's angle, one tick at a time, against what follows
// by hand. At 60 rpm, from the angle 0 on, an angle is a time.
#include <math.h>   // sqrt
#include <string.h> // memset

#include "check.h"
#include "nck/tick/6_interpolate/follow.h" // nck_follow …

#define T 1e-3      // period [s]
#define F 1.05     // how much faster the spindle may turn
#define A 1000.0   // of the axes at that [mm/s²]
#define HALF 0.67625 // of r² + F², where r is 0.5
#define C (0.5 * A / (F * F) / 10.0) // half of what the axes have, as a change of the rate [1/s]
#define NEAR 1e-12

static nck_sync_t sync;
static nck_follow_room_t room;

// The tool is 0.1 s far, at half of its pace and 10 mm/s at the whole one: ±1000/10 a second.
static void begin(void) {
    memset(&sync, 0, sizeof sync);
    memset(&room, 0, sizeof room);
    sync.measured = 1;
    sync.state = NCK_SYNC_RUNS;
    sync.pass.ramp.a = A / (F * F);
    sync.t = 0.1;
    sync.rate = 0.5;
    sync.spin = 2.0; // none that the axes can follow
    room.least = -F;
    room.most = 10.0;
    room.change = 1e30;
    room.rpm = 60.0;
    room.period = T;
    room.at.v = 10.0;
}

// The spindle is so much further than the tool [s].
static double follow(double left) {
    sync.turns = sync.t + left;
    return nck_follow(&sync, &room);
}

// Which rate the tool has, and where it is.
static void check_rate(check_t *check, double left, double rate) {
    const double t = sync.t;
    const double beside = follow(left);
    CHECK_NEAR(check, sync.rate, rate, NEAR);
    CHECK_NEAR(check, sync.t, t + rate * T, NEAR);
    CHECK_NEAR(check, beside, left - rate * T, NEAR);
    CHECK_NEAR(check, sync.was, room.at.a, 0.0);
}

// Of accelerations of the pass before, now and at its furthest: how much the rate may grow and
// shrink in a tick, s″·r² behind the worst of them: of what speeds up at (r² + F²)/2 upward, of
// what slows down at that downward.
static const double changes[][5] = {
    {0.0, 0.0, 0.0, 1000.0, 1000.0},
    {300.0, 400.0, 500.0, A - 500.0 * HALF, A + 0.5 * 300.0 * 0.25},
    {500.0, 300.0, 400.0, A - 500.0 * HALF, A + 0.5 * 300.0 * 0.25},
    {400.0, 500.0, 300.0, A - 500.0 * HALF, A + 0.5 * 300.0 * 0.25},
    {-300.0, -400.0, -500.0, A + 300.0 * 0.25, A - 500.0 * HALF},
    {-500.0, -300.0, -400.0, A + 300.0 * 0.25, A - 500.0 * HALF},
    {-400.0, -500.0, -300.0, A + 300.0 * 0.25, A - 500.0 * HALF},
    {-300.0, 0.0, 300.0, A - 300.0 * HALF, A - 300.0 * HALF},
    {0.9, 0.9, 0.9, A - 0.9 * HALF, A + 0.5 * 0.9 * 0.25},
    {-0.9, -0.9, -0.9, A + 0.9 * 0.25, A - 0.9 * HALF},
    {2000.0, 2000.0, 2000.0, 0.0, A + 0.5 * 2000.0 * 0.25},
    {-2000.0, -2000.0, -2000.0, A + 2000.0 * 0.25, 0.0}};

static void the_rate_changes_as_the_axes_can(check_t *check) {
    for (unsigned k = 0; k < sizeof changes / sizeof *changes; k++) {
        for (int way = 0; way < 2; way++) {
            begin();
            sync.was = changes[k][0];
            room.at.a = changes[k][1];
            room.far.a = changes[k][2];
            const double change = (way ? -changes[k][4] : changes[k][3]) / 10.0 * T;
            check_rate(check, way ? -1.0 : 1.0, 0.5 + change);
        }
    }
}

static void the_rate_stays_within_its_bounds(check_t *check) {
    begin();
    room.change = 20.0; // what X can follow
    check_rate(check, 1.0, 0.52);
    begin();
    room.change = 20.0;
    check_rate(check, -1.0, 0.48);
    begin();
    sync.rate = 1.04;
    check_rate(check, 1.0, F);
    begin();
    sync.rate = -1.04;
    sync.spin = -2.0;
    check_rate(check, -1.0, -F);
    begin();
    sync.rate = 0.01;
    room.least = 0.0;
    check_rate(check, -1.0, 0.0);
    begin();
    room.at.v = 0.0; // a tool that stands takes any pace
    check_rate(check, 1.0, F);
    begin();
    room.at.v = 0.0;
    check_rate(check, -1.0, -F);
}

// What makes up for e with the change c: r·T + r²/2c + r·T/2 = e, no more than e/T.
static double make_up(double e, double c) {
    const double x = c * T;
    return fmin(e / T, sqrt(0.25 * x * x + 2.0 * c * e) - 0.5 * x);
}

// 8/9 of what the axes have, for they take 9/8 of it in the end.
static void it_brakes_before_the_furthest_place(check_t *check) {
    const double c = 8.0 / 9.0 * 100.0;
    begin();
    sync.rate = 0.35;
    room.most = sync.t + 1e-3;
    check_rate(check, 1.0, make_up(1e-3, c));
    begin();
    room.most = sync.t + 1e-3; // faster than it should be: what it can
    check_rate(check, 1.0, 0.4);
    begin();
    sync.rate = 0.005;
    room.most = sync.t + 1e-5; // a tick is enough for what is left
    check_rate(check, 1.0, 0.01);
    begin();
    sync.rate = 0.05;
    room.most = sync.t;
    check_rate(check, 1.0, 0.0);
}

// What a tick makes good is made good; a billionth more, too.
static void an_angle_within_reach_is_followed(check_t *check) {
    static const double rates[] = {0.4, 0.45, 0.5, 0.55, 0.6};
    for (int k = 0; k < 5; k++) {
        for (double more = -5e-10; more < 1e-9; more += 5e-10) {
            begin();
            const double t = sync.t;
            CHECK_NEAR(check, follow((rates[k] + more) * T), 0.0, 0.0);
            CHECK_NEAR(check, sync.t, t + (rates[k] + more) * T, 1e-15);
            CHECK_NEAR(check, sync.rate, rates[k] + more, 1e-12);
        }
    }
    for (int way = -1; way <= 1; way += 2) { // no tool can: it makes up for it
        const double e = 0.1 + 2e-9;
        begin();
        check_rate(check, (0.5 + way * e) * T, 0.5 + way * make_up(e * T, C));
    }
}

// Beside the angle the tool goes as fast as the spindle turns, if it can, and makes up for what is
// left with half of what the axes have.
static void what_is_beside_is_made_up_for(check_t *check) {
    begin();
    sync.spin = 0.42;
    check_rate(check, 0.42 * T + 1.9e-4, 0.42 + make_up(1.9e-4, C));
    begin();
    sync.spin = 0.58;
    check_rate(check, 0.58 * T - 1.9e-4, 0.58 - make_up(1.9e-4, C));
    begin();
    sync.spin = 0.9; // none that it can follow: from its own pace on
    check_rate(check, 0.5 * T + 1.1e-4, 0.5 + make_up(1.1e-4, C));
    begin();
    sync.spin = 0.1;
    check_rate(check, 0.5 * T - 1.1e-4, 0.5 - make_up(1.1e-4, C));
    begin();
    sync.rate = 0.05; // both bounds are of the range
    sync.spin = 0.0;
    room.least = 0.0;
    check_rate(check, 2e-4, make_up(2e-4, C));
    begin();
    sync.rate = 1.0;
    sync.spin = F;
    check_rate(check, F * T - 1.6e-4, F - make_up(1.6e-4, C));
    begin();
    sync.spin = 0.49;
    room.change = 20.0; // half of it
    check_rate(check, 0.49 * T + 4e-5, 0.49 + make_up(4e-5, 10.0));
}

static void a_spindle_that_seems_to_stand_is_waited_for(check_t *check) {
    static const double spins[] = {0.0, -0.3};
    for (int k = 0; k < 2; k++) {
        begin();
        sync.spin = spins[k];
        check_rate(check, 0.0, 0.5);
    }
    begin();
    sync.rate = 0.0;
    sync.spin = 0.5;
    check_rate(check, 3e-4, 0.0);
    begin();
    sync.rate = -0.5;
    sync.spin = 0.3;
    check_rate(check, 0.0, -0.5);
}

// The command counts.
static void a_stop_goes_on_as_the_spindle_is_told(check_t *check) {
    begin();
    sync.state = NCK_SYNC_STOPS;
    sync.rpm = 33.0;
    check_rate(check, 1.0, 0.55);
    begin();
    sync.state = NCK_SYNC_STOPS;
    sync.rpm = -33.0;
    check_rate(check, 1.0, 0.4);
}

static void without_an_encoder_it_follows_at_once(check_t *check) {
    static const double rates[][2] = {{0.9, 0.9}, {-0.9, -0.9}, {1.2, F}, {-1.2, -F}};
    for (int k = 0; k < 4; k++) {
        begin();
        sync.measured = 0;
        check_rate(check, rates[k][0] * T, rates[k][1]);
    }
}

// In the first tick, as far as the spindle is behind its angle.
static void it_begins_between_two_ticks(check_t *check) {
    static const double begins[][2] = {{5e-4, 5e-4}, {1.05e-3, 1.05e-3}, {3e-3, 1.05e-3},
                                       {-1e-3, 0.0}};
    for (int k = 0; k < 4; k++) {
        begin();
        sync.t = 0.0;
        CHECK_NEAR(check, follow(begins[k][0]), begins[k][0] - begins[k][1], 1e-18);
        CHECK_NEAR(check, sync.t, begins[k][1], 1e-18);
        CHECK_NEAR(check, sync.rate, 0.5, 0.0);
    }
}

// At 120 rpm, from the angle 3 on: the angle, the spindle's speed, whether it begins, at which
// rate, and which angle is waited for behind that.
static void a_pass_begins_as_its_angle_comes(check_t *check) {
    static const double rows[][5] = {
        {3.0, 1.0, 1, 1.0, 3.0},     {3.0, 0.1, 1, 0.1, 3.0},    {3.0, 0.09, 0, 0.5, 3.0},
        {3.006, 1.2, 1, F, 3.0},     {3.0062, 1.0, 0, 0.5, 4.0}, {2.999, 1.0, 0, 0.5, 3.0},
        {2.0, 1.0, 0, 0.5, 3.0},     {1.75, 1.0, 0, 0.5, 2.0},   {3.25, 1.0, 0, 0.5, 4.0},
        {4.001, 1.0, 0, 0.5, 5.0},   {-7.5, -1.0, 0, 0.5, -7.0}};
    for (unsigned k = 0; k < sizeof rows / sizeof *rows; k++) {
        begin();
        sync.begin = 3.0;
        sync.turns = rows[k][0];
        sync.spin = rows[k][1];
        CHECK_INT(check, nck_follow_begins(&sync, 120.0, T), (int)rows[k][2]);
        CHECK_NEAR(check, sync.rate, rows[k][3], 0.0);
        CHECK_NEAR(check, sync.begin, rows[k][4], NEAR);
    }
    begin(); // a tick, and what it may be beside, to the bit
    sync.turns = NCK_FOLLOW_FASTER * T + NCK_FOLLOW_SLACK;
    sync.spin = 1.0;
    CHECK_INT(check, nck_follow_begins(&sync, 60.0, T), 1);
    begin();
    sync.measured = 0; // as commanded, whatever else
    sync.begin = 3.0;
    sync.spin = 0.0;
    for (int k = -1; k < 9; k++) {
        sync.turns = 3.0 + k;
        CHECK_INT(check, nck_follow_begins(&sync, 120.0, T), k >= 0);
        CHECK_NEAR(check, sync.begin, 3.0, 0.0);
    }
}

static void the_speed_is_what_has_turned_in_a_tick(check_t *check) {
    begin();
    sync.seen = 5.0;
    sync.turns = 5.001;
    nck_follow_look(&sync, 120.0, T); // 2 a second are commanded
    CHECK_NEAR(check, sync.spin, 0.5, 1e-9);
    CHECK_NEAR(check, sync.seen, 5.001, 0.0);
    nck_follow_look(&sync, 120.0, T);
    CHECK_NEAR(check, sync.spin, 0.0, 0.0);
}

// A tenth is asked for: of one that stands 2 ms are 20 ticks, whatever was before.
static void a_spindle_is_slow_below_a_tenth(check_t *check) {
    for (int way = -1; way <= 1; way += 2) {
        begin();
        sync.spin = 1.0 * way;
        for (int k = 0; k < 100; k++) CHECK(check, !nck_follow_is_slow(&sync, way, T));
        sync.spin = 0.0;
        int ticks = 1;
        while (!nck_follow_is_slow(&sync, way, T) && ticks < 100) ticks++;
        CHECK_NEAR(check, ticks, 21.0, 1.0);
        sync.spin = -0.4 * way; // half of it the wrong way: 4 ticks
        sync.slow = 0.0;
        for (ticks = 1; !nck_follow_is_slow(&sync, way, T) && ticks < 100;) ticks++;
        CHECK_NEAR(check, ticks, 5.0, 1.0);
        sync.measured = 0;
        CHECK(check, !nck_follow_is_slow(&sync, way, T));
        CHECK_NEAR(check, sync.slow, 0.0, 0.0);
    }
}

int main(void) {
    check_t check = {0};
    if (!NCK_HAS_CYCLES) return 0;
    CHECK_RUN(&check, the_rate_changes_as_the_axes_can);
    CHECK_RUN(&check, the_rate_stays_within_its_bounds);
    CHECK_RUN(&check, it_brakes_before_the_furthest_place);
    CHECK_RUN(&check, an_angle_within_reach_is_followed);
    CHECK_RUN(&check, what_is_beside_is_made_up_for);
    CHECK_RUN(&check, a_spindle_that_seems_to_stand_is_waited_for);
    CHECK_RUN(&check, a_stop_goes_on_as_the_spindle_is_told);
    CHECK_RUN(&check, without_an_encoder_it_follows_at_once);
    CHECK_RUN(&check, it_begins_between_two_ticks);
    CHECK_RUN(&check, a_pass_begins_as_its_angle_comes);
    CHECK_RUN(&check, the_speed_is_what_has_turned_in_a_tick);
    CHECK_RUN(&check, a_spindle_is_slow_below_a_tenth);
    return check_end(&check);
}
