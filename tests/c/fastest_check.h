// SPDX-License-Identifier: MIT
// The fastest motion over a clock (base/motion.h): a path whose least time is known, limits by
// arithmetic of its own, what stays, what is told, how long a step is; for either type of number.
#ifndef FASTEST_CHECK_H
#define FASTEST_CHECK_H

#include <math.h>   // cbrt fmax
#include <string.h> // memset

#include "check.h"
#include "nck/base/motion.h"

enum { AXES = 2, NODES = 88, KNOTS = NODES + 2, STEPS_MOST = 100000 };
static const double tau = 0.004;
// How far a limit may be broken: motion.c's for either type of number.
static const double met = sizeof(nck_num) == 4 ? 1.1e-3 : 2e-4;

static nck_motion_t motion;
static nck_motion_work_t work;
static nck_motion_wish_t wish;
static double knots[KNOTS][AXES]; // control points of a uniform cubic B-spline
static double guess[NODES], cap[NODES];

// A window of all nodes: from a rest of the path to a rest of the path.
static void begin(void) {
    memset(&wish, 0, sizeof wish);
    wish.tau = tau;
    for (int x = 0; x < AXES; x++) {
        wish.a[x] = 1000.0;
        wish.j[x] = 10000.0;
        wish.v[x] = 100.0;
    }
    wish.axes = AXES;
    wish.nodes = NODES;
    wish.ends = NCK_MOTION_FREE_END;
    wish.most = 100;
    wish.gap = 1e-3;
    wish.room = 0.3;
    for (int k = 0; k < NODES; k++) {
        guess[k] = 0.6;
        cap[k] = 1e6;
    }
}

// p′ and p″ of an axis at a node.
static double first_of(int k, int x) { return (knots[k + 2][x] - knots[k][x]) / (2.0 * tau); }

static double second_of(int k, int x) {
    return (knots[k + 2][x] - 2.0 * knots[k + 1][x] + knots[k][x]) / (tau * tau);
}

// Solve. Returns the number of steps.
static int plan(check_t *check) {
    int steps = 1;
    CHECK_INT(check, nck_motion_begin(&motion, &work, &wish), NCK_OK);
    for (int k = 0; k < wish.nodes; k++) {
        const nck_num p1[AXES] = {(nck_num)first_of(k, 0), (nck_num)first_of(k, 1)};
        const nck_num p2[AXES] = {(nck_num)second_of(k, 0), (nck_num)second_of(k, 1)};
        const nck_num cap_and_b[2] = {(nck_num)cap[k], (nck_num)guess[k]};
        nck_motion_node(&motion, k, p1, p2, cap_and_b);
    }
    while (nck_motion_step(&motion) == NCK_OK && steps < STEPS_MOST) steps++;
    CHECK_INT(check, nck_motion_step(&motion), NCK_DONE);
    return steps;
}

static nck_motion_told_t told(void) {
    nck_motion_told_t told;
    nck_motion_told(&motion, &told);
    return told;
}

// Caps that keep axes to their speeds.
static void cap_speeds(void) {
    for (int k = 0; k < NODES; k++) {
        for (int x = 0; x < AXES; x++) {
            const double p1 = first_of(k, x);
            cap[k] = fmin(cap[k], wish.v[x] * wish.v[x] / fmax(p1 * p1, 1e-12));
        }
    }
}

// What of the axes' acceleration and jerk lies along the path, of its limits.
static double taken_along(double (*of)[3]) {
    const double size = sqrt(of[0][0] * of[0][0] + of[1][0] * of[1][0]);
    const double a = (of[0][0] * of[0][1] + of[1][0] * of[1][1]) / fmax(size, 1e-12);
    const double j = (of[0][0] * of[0][2] + of[1][0] * of[1][2]) / fmax(size, 1e-12);
    return wish.along[0] > 0.0 ? fmax(fabs(a) / wish.along[0], fabs(j) / wish.along[1]) : 0.0;
}

// The most of a limit that any axis takes anywhere, or the path: b is the quadratic B-spline of its
// nodes, even about the path's ends; p between nodes by Taylor's series.
static double taken(int low, int high) {
    double most = 0.0;
    double of[AXES][3];
    for (int k = low; k <= high; k++) {
        const double here = (double)nck_motion_b(&motion, k);
        const double before = (double)nck_motion_b(&motion, k > 0 ? k - 1 : 1);
        const double behind = (double)nck_motion_b(&motion, k < wish.nodes - 1 ? k + 1 : k - 1);
        for (int t = -16; t <= 16; t++) {
            const double u = tau * t / 32.0;
            const int next = t < 0 ? k - 1 : k + 1;
            if (next < 0 || next >= wish.nodes) continue;
            const double a0 = (behind - before) / (4.0 * tau);
            const double a1 = (behind - 2.0 * here + before) / (2.0 * tau * tau);
            const double b = (before + 6.0 * here + behind) / 8.0 + 2.0 * a0 * u + a1 * u * u;
            for (int x = 0; x < AXES; x++) {
                const double p2 = second_of(k, x);
                const double p3 = (second_of(next, x) - p2) / (t < 0 ? -tau : tau);
                const double q1 = first_of(k, x) + p2 * u + p3 * u * u / 2.0;
                const double q2 = p2 + p3 * u;
                const double a = q1 * (a0 + a1 * u) + q2 * b;
                const double j = sqrt(b) * (p3 * b + 3.0 * q2 * (a0 + a1 * u) + q1 * a1);
                most = fmax(most, fabs(a) / wish.a[x]);
                most = fmax(most, fabs(j) / wish.j[x]);
                if (wish.v[x] > 0.0) most = fmax(most, fabs(q1) * sqrt(b) / wish.v[x]);
                of[x][0] = q1;
                of[x][1] = a;
                of[x][2] = j;
            }
            most = fmax(most, taken_along(of));
        }
    }
    return most;
}

// A line from rest to rest over a clock that runs about right: s = 10w³ − 15w⁴ + 6w⁵. Its control
// points are s − h²s″/6 (blossoms of a cubic), three equal ones at a rest.
static void lay_line(double length, double slant) {
    const double h = 1.0 / (double)(KNOTS - 3);
    for (int k = 0; k < KNOTS; k++) {
        double w = h * (k - 1.0);
        w = w < 0.0 ? 0.0 : w > 1.0 ? 1.0 : w;
        const double s = w * w * w * (10.0 - 15.0 * w + 6.0 * w * w);
        const double second = w * (60.0 - 180.0 * w + 120.0 * w * w);
        const double place = length * (s - h * h / 6.0 * second);
        const double at = k < 3 ? 0.0 : k >= KNOTS - 3 ? length : place;
        knots[k][0] = at;
        knots[k][1] = slant * at;
    }
}

// A path that bends everywhere, from rest to rest, by sums of waves.
static void lay_waves(unsigned seed) {
    lay_line(8.0, 0.3);
    for (int k = 3; k < KNOTS - 3; k++) {
        const double w = (k - 1.0) / (double)(KNOTS - 3);
        const double calm = w * w * w * (1.0 - w) * (1.0 - w) * (1.0 - w) * 64.0;
        for (int x = 0; x < AXES; x++) {
            const double turns = 4.0 + (double)((seed + 3u * (unsigned)x) % 7u);
            knots[k][x] += 0.4 * calm * sin(turns * 3.0 * w + (double)(seed * (unsigned)(x + 1)));
        }
    }
}

// Jerk alone limits 5 mm: four equal parts, s = 2jt³.
static void a_line_takes_its_least_time(check_t *check) {
    const double least = 4.0 * cbrt(5.0 / (2.0 * 10000.0));
    begin();
    lay_line(5.0, 0.5);
    wish.gap = 1e-5;
    plan(check);
    CHECK(check, told().least >= -met);
    CHECK(check, told().time > 0.999 * least);
    CHECK(check, told().time < 1.015 * least);
    CHECK(check, told().gap <= wish.gap);
}

static void limits_hold_everywhere(check_t *check) {
    for (unsigned seed = 1; seed <= 12; seed++) {
        begin();
        lay_waves(seed);
        cap_speeds();
        plan(check);
        const double most = taken(0, NODES - 1);
        CHECK(check, told().least >= -met);
        CHECK(check, most <= 1.001 + met);
        CHECK(check, most > 0.99);
        CHECK_NEAR(check, fmax(told().share, 0.999), most, 1.5e-3);
    }
}

// How often a limit is the one that holds a node.
static int held_by(nck_motion_hold_t hold) {
    int count = 0;
    for (int k = 1; k < wish.nodes - 1; k++) count += nck_motion_hold(&motion, k) == hold;
    return count;
}

// Along a line the path is an axis: one with such limits alone takes as long.
static void a_limit_along_a_line_is_an_axis(check_t *check) {
    const double slant = sqrt(1.25);
    begin();
    lay_line(5.0, 0.5);
    wish.gap = 1e-5;
    wish.a[0] = 300.0 / slant;
    wish.j[0] = 4000.0 / slant;
    plan(check);
    const double axis = told().time;
    begin();
    wish.gap = 1e-5;
    wish.along[0] = 300.0;
    wish.along[1] = 4000.0;
    plan(check);
    CHECK_NEAR(check, told().time / axis, 1.0, 1e-3);
    CHECK(check, held_by(NCK_MOTION_ACCELERATION) > 0 && held_by(NCK_MOTION_JERK) > NODES / 2);
}

static void limits_along_the_path_hold_everywhere(check_t *check) {
    for (unsigned seed = 1; seed <= 12; seed++) {
        begin();
        lay_waves(seed);
        cap_speeds();
        plan(check);
        const double before = told().time;
        wish.along[0] = 1000.0 / (double)(seed % 4 + 1);
        wish.along[1] = 10000.0 / (double)(seed % 3 + 1);
        plan(check);
        const double most = taken(0, NODES - 1);
        CHECK(check, told().least >= -met);
        CHECK(check, most <= 1.001 + met);
        CHECK(check, most > 0.99);
        CHECK(check, told().time > before);
    }
}

// Caps hold where they are, and are met.
static void caps_hold(check_t *check) {
    double nearest = 1.0;
    begin();
    lay_line(5.0, 0.5);
    for (int k = 0; k < NODES; k++) cap[k] = 0.7;
    plan(check);
    for (int k = 0; k < NODES; k++) {
        const double room = 1.0 - (double)nck_motion_b(&motion, k) / cap[k];
        nearest = fmin(nearest, room);
    }
    CHECK(check, nearest >= 0.0);
    CHECK(check, nearest < 0.01);
}

// On a line by jerk alone, or through a long ramp by acceleration, or at the cap.
static void what_holds_is_told(check_t *check) {
    begin();
    lay_line(5.0, 0.5);
    plan(check);
    CHECK(check, held_by(NCK_MOTION_JERK) >= NODES - 12);
    CHECK_INT(check, held_by(NCK_MOTION_CAP), 0);
    wish.a[0] = 150.0;
    plan(check);
    CHECK(check, held_by(NCK_MOTION_ACCELERATION) > NODES / 3);
    CHECK_INT(check, held_by(NCK_MOTION_CAP), 0);
    wish.a[0] = 1000.0;
    for (int k = NODES / 2 - 8; k <= NODES / 2 + 8; k++) cap[k] = 0.1;
    plan(check);
    for (int k = NODES / 2 - 1; k <= NODES / 2 + 1; k++) {
        CHECK_INT(check, nck_motion_hold(&motion, k), NCK_MOTION_CAP);
    }
    CHECK(check, held_by(NCK_MOTION_CAP) < 20);
}

static void a_mirrored_path_has_the_same_bits(check_t *check) {
    nck_num kept[NODES];
    begin();
    lay_waves(3);
    plan(check);
    for (int k = 0; k < NODES; k++) kept[k] = nck_motion_b(&motion, k);
    for (int k = 0; k < KNOTS; k++) knots[k][0] = -knots[k][0];
    plan(check);
    for (int k = 0; k < NODES; k++) CHECK(check, kept[k] == nck_motion_b(&motion, k));
}

// A window amid the path: its first two nodes stay as the last plan had them, its last one is a
// rest. The plan of the whole brakes for it in time, whatever it was guessed from.
static void what_is_fixed_stays(check_t *check) {
    nck_num kept[2];
    begin();
    lay_waves(5);
    cap_speeds();
    plan(check);
    for (int k = 0; k < 2; k++) kept[k] = nck_motion_b(&motion, k + 20);
    memmove(knots[0], knots[20], (KNOTS - 20) * sizeof knots[0]);
    wish.nodes = NODES - 20;
    wish.fixed = 2;
    wish.ends = NCK_MOTION_INSIDE;
    for (int k = 0; k < 2; k++) guess[k] = (double)kept[k];
    guess[wish.nodes - 1] = 0.0;
    plan(check);
    CHECK(check, nck_motion_b(&motion, 0) == kept[0]);
    CHECK(check, nck_motion_b(&motion, 1) == kept[1]);
    CHECK(check, nck_motion_b(&motion, wish.nodes - 1) == 0);
    CHECK(check, told().least >= -met);
    CHECK(check, taken(1, wish.nodes - 3) <= 1.001 + met);
}

// An open end is free: it is no slower than a rest would be, and no row stands there.
static void an_open_end_does_not_brake(check_t *check) {
    begin();
    lay_waves(7);
    cap_speeds();
    wish.nodes = 48;
    guess[47] = 0.0;
    wish.ends = 0;
    plan(check);
    const double rest = told().time;
    const nck_num slow = nck_motion_b(&motion, 46);
    guess[47] = 0.6;
    wish.ends = NCK_MOTION_OPEN_END;
    plan(check);
    CHECK(check, told().time < 0.9 * rest);
    CHECK(check, told().least >= -met);
    CHECK(check, nck_motion_b(&motion, 46) > NCK_NUM_OF(5) * slow);
}

// From a running plan under caps that have fallen to half, on axes that can do three times as much:
// the limits hold, and the caps are kept as soon as they can be.
static void caps_at_a_price_break_no_limit(check_t *check) {
    begin();
    lay_line(10.0, 0.2);
    plan(check);
    const int last = wish.nodes - 30;
    for (int x = 0; x < AXES; x++) {
        wish.a[x] *= 3.0;
        wish.j[x] *= 9.0;
    }
    memmove(knots[0], knots[29], (size_t)(last + 3) * sizeof knots[0]);
    for (int k = 0; k <= last; k++) {
        guess[k] = (double)nck_motion_b(&motion, k + 29);
        cap[k] = 0.5 * guess[k];
    }
    wish.nodes = last + 1;
    wish.fixed = 2;
    wish.ends = NCK_MOTION_INSIDE | NCK_MOTION_SOFT | NCK_MOTION_FREE_END;
    wish.room = 0.005;
    wish.price = 100.0;
    plan(check);
    CHECK(check, told().iterations < wish.most);
    CHECK(check, told().least >= -met);
    CHECK(check, taken(1, last) <= 1.001 + met);
    CHECK(check, (double)nck_motion_b(&motion, 2) > 1.5 * cap[2]); // not at once
    CHECK(check, (double)nck_motion_b(&motion, last - 8) <= 1.001 * cap[last - 8]);
}

// The end of a path, of few nodes down to two cells: from the plan of all of it on to its rest, or
// from a rest of its own.
static void few_nodes_keep_the_limits(check_t *check) {
    static double all[KNOTS][AXES];
    nck_num b[NODES];
    begin();
    lay_waves(11);
    cap_speeds();
    plan(check);
    for (int k = 0; k < NODES; k++) b[k] = nck_motion_b(&motion, k);
    memcpy(all, knots, sizeof all);
    for (int fixed = 0; fixed <= 2; fixed += 2) {
        for (int nodes = fixed + 2; nodes < 12; nodes++) {
            const int from = NODES - nodes;
            begin();
            memcpy(knots, all[from], (size_t)(nodes + 2) * sizeof knots[0]);
            cap_speeds();
            wish.nodes = nodes;
            wish.fixed = fixed;
            for (int k = 0; k < nodes; k++) guess[k] = 0.9 * (double)b[from + k];
            for (int k = 0; k < fixed; k++) guess[k] = (double)b[from + k];
            if (fixed > 0) wish.ends |= NCK_MOTION_INSIDE;
            plan(check);
            CHECK(check, told().time > 0.0 && told().time < 1.0);
            CHECK(check, told().least >= -met);
            CHECK(check, fixed > 0 || told().share <= 1.001 + met);
            for (int k = 0; k < fixed; k++) {
                CHECK(check, nck_motion_b(&motion, k) == (nck_num)guess[k]);
            }
        }
    }
}

// Where the plan rests and the path goes on, the cap before that has no price.
static void a_firm_end_has_no_price(check_t *check) {
    begin();
    lay_line(10.0, 0.2);
    plan(check);
    wish.nodes = 40;
    wish.fixed = 2;
    for (int k = 0; k < wish.nodes; k++) {
        guess[k] = (double)nck_motion_b(&motion, k);
        cap[k] = 1e-3 * guess[k];
    }
    wish.ends = NCK_MOTION_SOFT;
    wish.price = 1e-3; // next to nothing: all caps are broken
    guess[39] = 0.0;
    plan(check);
    CHECK(check, (double)nck_motion_b(&motion, 38) > 1.5 * cap[38]);
    wish.ends |= NCK_MOTION_FIRM_END;
    plan(check);
    CHECK(check, (double)nck_motion_b(&motion, 38) <= (1.0 + met) * cap[38]);
    CHECK(check, (double)nck_motion_b(&motion, 30) > 1.5 * cap[30]);
    CHECK(check, told().least >= -met);
}

// No way to a rest within five cells: told, after as many iterations as are allowed, and finite.
static void what_cannot_be_is_told(check_t *check) {
    begin();
    lay_line(20.0, 0.2);
    memmove(knots[0], knots[40], (KNOTS - 40) * sizeof knots[0]);
    wish.nodes = 10;
    wish.fixed = 2;
    wish.ends = NCK_MOTION_INSIDE;
    wish.most = 25;
    guess[0] = guess[1] = 1.0;
    guess[9] = 0.0;
    plan(check);
    CHECK_INT(check, told().iterations, 25);
    CHECK(check, told().least < -0.1);
    CHECK(check, isfinite(told().time) && isfinite(told().share) && told().share > 1.1);
    for (int k = 0; k < 10; k++) CHECK(check, isfinite((double)nck_motion_b(&motion, k)));
}

// Rows in the middles alone tell the time within a few percent, here where the clock is a poor one,
// and what is taken between them is told.
static void a_rough_motion_tells_the_time(check_t *check) {
    for (unsigned seed = 1; seed <= 4; seed++) {
        begin();
        lay_waves(seed);
        cap_speeds();
        plan(check);
        const double time = told().time;
        wish.ends |= NCK_MOTION_COARSE;
        plan(check);
        CHECK(check, told().least >= -met);
        CHECK_NEAR(check, told().time, time, 0.04 * time);
        CHECK(check, told().time < time);
        CHECK(check, told().share > 1.001);
    }
}

// A step is a chunk or a pass: so many of them are a window, to the step.
static void a_window_has_so_many_steps(check_t *check) {
    const int chunks = (NODES + NCK_MOTION_LANES - 1) / NCK_MOTION_LANES;
    begin();
    lay_waves(2);
    wish.ends |= NCK_MOTION_COARSE;
    const int steps = plan(check);
    const int rounds = told().iterations;
    CHECK(check, rounds > 3 && rounds < 40);
    CHECK_INT(check, steps, 1 + chunks + rounds * (2 * chunks + 2) + chunks + 1 + chunks);
}

static void what_is_out_of_range_is_refused(check_t *check) {
    begin();
    wish.nodes = NCK_MOTION_NODES + 1;
    CHECK_INT(check, nck_motion_begin(&motion, &work, &wish), NCK_E_ARGUMENT);
    begin();
    wish.axes = NCK_AXIS_MAX + 1;
    CHECK_INT(check, nck_motion_begin(&motion, &work, &wish), NCK_E_ARGUMENT);
    begin();
    wish.fixed = NODES - 1;
    CHECK_INT(check, nck_motion_begin(&motion, &work, &wish), NCK_E_ARGUMENT);
    begin();
    wish.gap = 0.0;
    CHECK_INT(check, nck_motion_begin(&motion, &work, &wish), NCK_E_ARGUMENT);
    begin();
    wish.room = 0.0;
    CHECK_INT(check, nck_motion_begin(&motion, &work, &wish), NCK_E_ARGUMENT);
}

// Run them all. Returns the exit status.
static inline int fastest_check(void) {
    check_t check = {0};
    CHECK_RUN(&check, a_line_takes_its_least_time);
    CHECK_RUN(&check, limits_hold_everywhere);
    CHECK_RUN(&check, a_limit_along_a_line_is_an_axis);
    CHECK_RUN(&check, limits_along_the_path_hold_everywhere);
    CHECK_RUN(&check, caps_hold);
    CHECK_RUN(&check, what_holds_is_told);
    CHECK_RUN(&check, a_mirrored_path_has_the_same_bits);
    CHECK_RUN(&check, what_is_fixed_stays);
    CHECK_RUN(&check, an_open_end_does_not_brake);
    CHECK_RUN(&check, caps_at_a_price_break_no_limit);
    CHECK_RUN(&check, few_nodes_keep_the_limits);
    CHECK_RUN(&check, a_firm_end_has_no_price);
    CHECK_RUN(&check, what_cannot_be_is_told);
    CHECK_RUN(&check, a_rough_motion_tells_the_time);
    CHECK_RUN(&check, a_window_has_so_many_steps);
    CHECK_RUN(&check, what_is_out_of_range_is_refused);
    return check_end(&check);
}

#endif
