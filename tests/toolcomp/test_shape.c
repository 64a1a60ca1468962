// SPDX-License-Identifier: MIT
// Inside room 2: lines and arcs, and how they meet, against many points of them.
#include <math.h>   // cos fabs fmax fmin hypot sin
#include <stdint.h> // uint64_t

#include "check.h"
#include "nck/base/trig_math.h"        // NCK_PI
#include "nck/prep/2_toolcomp/shape.h" // nck_shape_…

enum { PAIRS = 400, PLACES = 200, HALVINGS = 60 };

#define SMALL 0.03     // a size: less than half a millimetre
#define NEAR 1e-9      // [mm] numbers of the order of 10
#define TURN (2.0 * NCK_PI)
#define ON 1e-6        // [mm] so far beyond an end a place is still on a shape

static uint64_t seed;

static double draw(double low, double high) {
    seed = seed * 6364136223846793005u + 1442695040888963407u;
    return low + (double)(seed >> 11) * 0x1p-53 * (high - low);
}

static void line(double px, double py, double qx, double qy, nck_shape_t *out) {
    const double p[2] = {px, py}, q[2] = {qx, qy};
    nck_shape_line(p, q, out);
}

// About c, from the angle `from` on.
static void arc(double cx, double cy, double radius, double from, double sweep, nck_shape_t *out) {
    const double c[2] = {cx, cy};
    const double p[2] = {cx + radius * cos(from), cy + radius * sin(from)};
    const double q[2] = {cx + radius * cos(from + sweep), cy + radius * sin(from + sweep)};
    nck_shape_arc(p, q, c, sweep, out);
}

// Every third one is a line; an arc is of `turns` at most. size: 1, or less for small ones.
static void draw_sized(double turns, double size, nck_shape_t *out) {
    if (draw(0.0, 3.0) < 1.0) {
        const double x = draw(-9.0, 9.0), y = draw(-9.0, 9.0);
        line(x, y, x + size * (draw(-9.0, 9.0) - x), y + size * (draw(-9.0, 9.0) - y), out);
        return;
    }
    const double sweep = draw(0.05, turns) * TURN;
    arc(draw(-5.0, 5.0), draw(-5.0, 5.0), size * draw(0.5, 6.0), draw(0.0, TURN),
        draw(0.0, 2.0) < 1.0 ? sweep : -sweep, out);
}

static void draw_shape(double turns, nck_shape_t *out) { draw_sized(turns, 1.0, out); }

static double apart(const double *a, const double *b) { return hypot(a[0] - b[0], a[1] - b[1]); }

static double from_point(const nck_shape_t *shape, double along, const double *point) {
    double at[2];
    nck_shape_point(shape, along, at);
    return apart(at, point);
}

static double from_shape(const nck_shape_t *a, double along, const nck_shape_t *b) {
    double at[2];
    nck_shape_point(a, along, at);
    return nck_shape_distance(b, at);
}

// So many of PLACES parts of its length.
static double share(const nck_shape_t *shape, double parts) {
    return shape->length * parts / (double)PLACES;
}

// The least of many places of a shape, made finer: from a point, or from another shape.
static double least_of(const nck_shape_t *a, const double *point, const nck_shape_t *b) {
    double best = 0.0, least = 1e9, step = share(a, 1.0);
    for (int n = 0; n < HALVINGS; n++) {
        const double middle = best;
        const int reach = n == 0 ? PLACES : 2;
        for (int k = n == 0 ? 0 : -2; k <= reach; k++) {
            const double along = fmin(a->length, fmax(0.0, middle + k * step));
            const double gap = point ? from_point(a, along, point) : from_shape(a, along, b);
            if (gap < least) {
                least = gap;
                best = along;
            }
        }
        step *= n == 0 ? 1.0 : 0.7;
    }
    return least;
}

static void places_are_on_the_shape(check_t *check) {
    for (int n = 0; n < PAIRS; n++) {
        nck_shape_t shape;
        double point[2], on[2], back[2], tangent[2];
        draw_shape(2.5, &shape);
        CHECK_NEAR(check, from_point(&shape, 0.0, shape.p), 0.0, NEAR);
        CHECK_NEAR(check, from_point(&shape, shape.length, shape.q), 0.0, NEAR);
        const double along = draw(0.0, shape.length), h = 1e-4;
        nck_shape_point(&shape, along, point);
        nck_shape_point(&shape, along + h, on);
        nck_shape_point(&shape, along - h, back);
        nck_shape_tangent(&shape, along, tangent);
        CHECK_NEAR(check, hypot(tangent[0], tangent[1]), 1.0, NEAR);
        CHECK_NEAR(check, (on[0] - back[0]) / (2.0 * h), tangent[0], 1e-7);
        CHECK_NEAR(check, (on[1] - back[1]) / (2.0 * h), tangent[1], 1e-7);
        const double turn = TURN * shape.radius;
        const double rest = shape.radius > 0.0 ? along - turn * floor(along / turn) : along;
        const double told = nck_shape_along(&shape, point);
        CHECK(check, fabs(told - rest) < NEAR || fabs(told + turn - rest) < NEAR);
        CHECK_NEAR(check, nck_shape_distance(&shape, point), 0.0, NEAR);
    }
}

static void a_distance_is_the_least_of_all_places(check_t *check) {
    for (int n = 0; n < PAIRS; n++) {
        nck_shape_t shape;
        double point[2] = {draw(-9.0, 9.0), draw(-9.0, 9.0)};
        draw_sized(1.2, n % 3 == 0 ? SMALL : 1.0, &shape);
        if (n % 4 == 0) nck_shape_point(&shape, draw(-4.0, shape.length + 4.0), point);
        CHECK_NEAR(check, nck_shape_distance(&shape, point), least_of(&shape, point, NULL), 1e-7);
    }
    nck_shape_t none;
    const double beside[2] = {3.0, 4.0};
    line(0.0, 0.0, 0.0, 0.0, &none); // a place: no direction is asked for
    CHECK_NEAR(check, nck_shape_distance(&none, beside), 5.0, 0.0);
    CHECK_NEAR(check, from_point(&none, 0.0, beside), 5.0, 0.0);
    nck_shape_t circle;
    nck_approach_t near;
    arc(3.0, 4.0, 2.0, 0.0, TURN, &circle);
    nck_shape_approach(&none, &circle, &near);
    CHECK_NEAR(check, near.gap, 3.0, NEAR);
    CHECK_NEAR(check, near.on_a, 0.0, 0.0);
    CHECK_NEAR(check, nck_shape_along(&none, beside), 0.0, 0.0);
}

static void two_shapes_are_nearest_where_they_say(check_t *check) {
    for (int n = 0; n < PAIRS; n++) {
        nck_shape_t a, b;
        nck_approach_t at;
        double on_a[2], on_b[2];
        draw_sized(0.9, n % 3 == 0 ? SMALL : 1.0, &a);
        draw_sized(0.9, n % 5 == 0 ? SMALL : 1.0, &b);
        nck_shape_approach(&a, &b, &at);
        const double least = fmin(least_of(&a, NULL, &b), least_of(&b, NULL, &a));
        CHECK_NEAR(check, at.gap, least, 1e-6);
        nck_shape_point(&a, at.on_a, on_a);
        nck_shape_point(&b, at.on_b, on_b);
        CHECK_NEAR(check, apart(on_a, on_b), at.gap, NEAR);
        CHECK(check, at.on_a >= -ON && at.on_a <= a.length + ON);
        CHECK(check, at.on_b >= -ON && at.on_b <= b.length + ON);
        for (double far = 0.0; far < 4.0; far += 0.5) {
            if (nck_shape_are_far(&a, &b, far)) CHECK(check, at.gap > far);
        }
    }
}

// Circles about a line and about an arc are the least that hold them for certain.
static void what_is_far_is_told_by_circles(check_t *check) {
    nck_shape_t a, b;
    line(0.0, 0.0, 6.0, 8.0, &a); // 5 about 3, 4
    arc(15.0, 9.0, 2.0, 1.0, 1.0, &b);
    CHECK_INT(check, nck_shape_are_far(&a, &b, 5.999), 1);
    CHECK_INT(check, nck_shape_are_far(&b, &a, 5.999), 1);
    CHECK_INT(check, nck_shape_are_far(&a, &b, 6.001), 0);
    CHECK_INT(check, nck_shape_are_far(&b, &a, 6.001), 0);
    arc(3.0, -8.0, 1.0, 1.0, 1.0, &b);
    CHECK_INT(check, nck_shape_are_far(&a, &b, 5.999), 1);
    CHECK_INT(check, nck_shape_are_far(&a, &b, 6.001), 0);
    arc(3.0, -8.0, 0.5, 1.0, 1.0, &b); // of less than a millimetre
    CHECK_INT(check, nck_shape_are_far(&a, &b, 6.499), 1);
    CHECK_INT(check, nck_shape_are_far(&a, &b, 6.501), 0);
}

// Do the chords of two shapes cross, away from all ends? 1: yes, −1: nobody can say.
static int chords_cross(const nck_shape_t *a, int k, const nck_shape_t *b, int n) {
    double p[2], q[2], u[2], v[2];
    nck_shape_point(a, share(a, k), p);
    nck_shape_point(a, share(a, k + 1), q);
    nck_shape_point(b, share(b, n), u);
    nck_shape_point(b, share(b, n + 1), v);
    const double sine = (q[0] - p[0]) * (v[1] - u[1]) - (q[1] - p[1]) * (v[0] - u[0]);
    const double sizes = apart(p, q) * apart(u, v);
    const double on_a = ((u[0] - p[0]) * (v[1] - u[1]) - (u[1] - p[1]) * (v[0] - u[0])) / sine;
    const double on_b = ((u[0] - p[0]) * (q[1] - p[1]) - (u[1] - p[1]) * (q[0] - p[0])) / sine;
    const double edge = fmin(fmin(on_a, 1.0 - on_a), fmin(on_b, 1.0 - on_b));
    if (fabs(sine) < 0.3 * sizes) return edge > -3.0 ? -1 : 0;
    return fabs(edge) < 0.02 ? -1 : edge > 0.0;
}

// How often two shapes cross; −1: they nearly touch, or a chord's end is near.
static int crossings_of(const nck_shape_t *a, const nck_shape_t *b) {
    int count = 0;
    for (int k = 0; k < PLACES; k++) {
        double at[2];
        nck_shape_point(a, share(a, k + 0.5), at);
        if (nck_shape_distance(b, at) > share(a, 1.0) + share(b, 1.0)) continue;
        for (int n = 0; n < PLACES; n++) {
            const int found = chords_cross(a, k, b, n);
            if (found < 0) return -1;
            count += found;
        }
    }
    return count;
}

static void check_meetings(check_t *check, const nck_shape_t *a, const nck_shape_t *b, int count,
                           const nck_meeting_t *at) {
    for (int k = 0; k < count; k++) {
        double on_a[2], on_b[2];
        nck_shape_point(a, at[k].on_a, on_a);
        nck_shape_point(b, at[k].on_b, on_b);
        CHECK_NEAR(check, apart(on_a, on_b), 0.0, NEAR);
        CHECK(check, at[k].on_a >= -ON && at[k].on_a <= a->length + ON);
        CHECK(check, at[k].on_b >= -ON && at[k].on_b <= b->length + ON);
        if (a->radius > 0.0) CHECK(check, at[k].on_a > a->length - TURN * a->radius - ON);
        if (b->radius > 0.0) CHECK(check, at[k].on_b < TURN * b->radius - 0.5 * ON);
    }
    if (count == 2) CHECK(check, fabs(at[0].on_a - at[1].on_a) > NEAR);
}

static void shapes_cross_as_often_as_their_chords(check_t *check) {
    int tried = 0;
    for (int n = 0; n < PAIRS; n++) {
        nck_shape_t a, b;
        nck_meeting_t at[2];
        draw_shape(0.95, &a);
        draw_shape(0.95, &b);
        const unsigned count = nck_shape_cross(&a, &b, at);
        check_meetings(check, &a, &b, (int)count, at);
        const int chords = crossings_of(&a, &b);
        if (chords < 0) continue;
        CHECK_INT(check, count, chords);
        tried += chords > 0;
        draw_shape(3.5, &a); // of more than a turn: a's last one, b's first one
        draw_shape(3.5, &b);
        check_meetings(check, &a, &b, (int)nck_shape_cross(&a, &b, at), at);
    }
    CHECK(check, tried > PAIRS / 8);
}

// Half of ON before its beginning, or behind its end, a place is on a shape; at twice of it not.
static void an_end_belongs_to_its_shape(check_t *check) {
    for (int k = 0; k < 16; k++) {
        const double beyond = (k & 1 ? 0.5 : 2.0) * ON, v = (k & 2 ? 1.0 : -1.0) * (3.0 + beyond);
        const int want = k & 1;
        nck_shape_t a, b;
        nck_meeting_t at[2];
        if (k & 4) line(-3.0, 0.0, 3.0, 0.0, &a);
        else arc(0.0, 0.0, 3.0, k & 8 ? 0.0 : NCK_PI, k & 8 ? NCK_PI : -NCK_PI, &a);
        if (k & 4) line(v, -1.0, v, 1.0, &b);
        else line(k & 2 ? 2.0 : -2.0, -beyond, k & 2 ? 4.0 : -4.0, -beyond, &b);
        CHECK_INT(check, nck_shape_cross(&a, &b, at), want);
        CHECK_INT(check, nck_shape_cross(&b, &a, at), want);
    }
}

// A turn ends where it begins: met about there it is met at its beginning, however it is rounded.
static void a_turn_is_met_where_it_begins(check_t *check) {
    for (int k = 0; k < 16; k++) {
        const double sweep = k & 1 ? TURN : -TURN, y = (k & 2 ? 0.3 : -0.3) * ON;
        const double size = k & 8 ? 0.1 : 1.0; // larger and smaller than a millimetre
        nck_shape_t a, b;
        nck_meeting_t at[2];
        arc(0.0, 0.0, 3.0 * size, 0.0, sweep, &b);
        if (k & 4) line(2.0 * size, y, 4.0 * size, y, &a);
        else arc(0.0, 4.0 * size, 5.0 * size, -1.0, 0.6, &a); // through (3, 0)
        CHECK_INT(check, nck_shape_cross(&a, &b, at), 1);
        CHECK_NEAR(check, at[0].on_b, 0.0, ON);
    }
}

static void what_is_parallel_or_touches_does_not_cross(check_t *check) {
    nck_shape_t a, b;
    nck_meeting_t at[2];
    line(0.0, 0.0, 9.0, 3.0, &a);
    line(0.0, 0.0, 9.0, 3.0, &b);
    CHECK_INT(check, nck_shape_cross(&a, &b, at), 0);
    line(0.0, 1.0, 9.0, 4.0, &b);
    CHECK_INT(check, nck_shape_cross(&a, &b, at), 0);
    line(0.0, -1e-7, 1e-3, 1e-3, &b); // however short: it crosses
    line(-1.0, 0.0, 1e-3, 0.0, &a);
    CHECK_INT(check, nck_shape_cross(&a, &b, at), 1);
    arc(0.0, 0.0, 3.0, 0.0, TURN, &a);
    arc(0.0, 0.0, 3.0, 1.0, TURN, &b);
    CHECK_INT(check, nck_shape_cross(&a, &b, at), 0);
    arc(0.0, 0.0, 2.0, 1.0, TURN, &b);
    CHECK_INT(check, nck_shape_cross(&a, &b, at), 0);
    arc(5.0, 0.0, 2.0, 1.0, TURN, &b);
    CHECK_INT(check, nck_shape_cross(&a, &b, at), 0);
    arc(5.1, 0.0, 2.0, 1.0, TURN, &b);
    CHECK_INT(check, nck_shape_cross(&a, &b, at), 0);
    arc(4.999, 0.0, 2.0, 1.0, TURN, &b);
    CHECK_INT(check, nck_shape_cross(&a, &b, at), 2);
    line(3.0, -5.0, 3.0, 5.0, &b);
    CHECK_INT(check, nck_shape_cross(&a, &b, at), 0);
    line(3.1, -5.0, 3.1, 5.0, &b);
    CHECK_INT(check, nck_shape_cross(&a, &b, at), 0);
    line(2.999, -5.0, 2.999, 5.0, &b);
    CHECK_INT(check, nck_shape_cross(&a, &b, at), 2);
    arc(0.3, 0.0, 0.4, 0.0, TURN, &a); // less than a millimetre
    arc(0.0, 0.0, 0.4, 0.0, TURN, &b);
    CHECK_INT(check, nck_shape_cross(&a, &b, at), 2);
    line(0.3, -0.45, 0.3, 0.45, &b);
    CHECK_INT(check, nck_shape_cross(&a, &b, at), 2);
    CHECK_INT(check, nck_shape_cross(&b, &a, at), 2);
}

static void parts_and_parallels_are_of_their_shape(check_t *check) {
    for (int n = 0; n < PAIRS; n++) {
        nck_shape_t shape, part, beside;
        double point[2], tangent[2], off[2];
        draw_shape(2.0, &shape);
        const double from = draw(0.0, shape.length), to = draw(from, shape.length);
        nck_shape_part(&shape, from, to, &part);
        CHECK_NEAR(check, part.length, to - from, NEAR);
        nck_shape_point(&shape, 0.5 * (from + to), point);
        CHECK_NEAR(check, from_point(&part, 0.5 * part.length, point), 0.0, NEAR);
        const double left = draw(-4.0, 4.0), inward = shape.sweep < 0.0 ? -left : left;
        const int is_one = nck_shape_parallel(&shape, left, &beside);
        CHECK_INT(check, is_one, !(shape.radius > 0.0) || shape.radius > inward);
        if (!is_one) continue;
        nck_shape_point(&shape, 0.3 * shape.length, point);
        nck_shape_tangent(&shape, 0.3 * shape.length, tangent);
        off[0] = point[0] - left * tangent[1];
        off[1] = point[1] + left * tangent[0];
        CHECK_NEAR(check, from_point(&beside, 0.3 * beside.length, off), 0.0, NEAR);
    }
}

int main(void) {
    check_t check = {0};
    CHECK_RUN(&check, places_are_on_the_shape);
    CHECK_RUN(&check, a_distance_is_the_least_of_all_places);
    CHECK_RUN(&check, two_shapes_are_nearest_where_they_say);
    CHECK_RUN(&check, what_is_far_is_told_by_circles);
    CHECK_RUN(&check, shapes_cross_as_often_as_their_chords);
    CHECK_RUN(&check, an_end_belongs_to_its_shape);
    CHECK_RUN(&check, a_turn_is_met_where_it_begins);
    CHECK_RUN(&check, what_is_parallel_or_touches_does_not_cross);
    CHECK_RUN(&check, parts_and_parallels_are_of_their_shape);
    return check_end(&check);
}
