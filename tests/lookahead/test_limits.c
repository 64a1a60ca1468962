// SPDX-License-Identifier: MIT
// Room 4, one seg alone: how fast it may be run and what is left along it, against limits worked
// out from its shape. Nothing more is allowed, and no less.
#include <math.h>   // sqrt fabs cos sin hypot
#include <string.h> // memset

#include "check.h"
#include "nck/base/path.h"                  // nck_path_tangent
#include "nck/base/path_math.h"             // nck_path_turns
#include "nck/prep/4_lookahead/lookahead.h"  // nck_lookahead_t
#include "terms_check.h" // terms_of

enum { TRIALS = 300, SAMPLES = 4000 };
#define NEAR 1e-6 // of a cosine sampled so often
#define TAU 6.283185307179586

static nck_machine_t machine;
static nck_lookahead_t lookahead;
static nck_seg_t seg;
static nck_node_t node;
static uint64_t seed;
static uint32_t told[NCK_LIMIT_AXIS_V + NCK_AXIS_MAX]; // how often each limit was the one

// What the seg's shape and the machine allow.
typedef struct allowed {
    double v;      // at the programmed feed
    double v_free; // whatever the feed
    double a, j;   // along the path
    int limit;     // that sets v
    double a_come_to; // under a jerk limit: no more is ever had
    double v_turn;    // of an arc: v_free but for the acceleration of its bend
} allowed_t;

// Xorshift, G. Marsaglia 2003: the same numbers everywhere. low … high.
static double random_between(double low, double high)
{
    seed ^= seed << 13;
    seed ^= seed >> 7;
    seed ^= seed << 17;
    return low + (high - low) * (double)(seed >> 11) / 9007199254740992.0;
}

static void begin(uint64_t first_seed, uint32_t slope)
{
    nck_machine_default(&machine);
    machine.slope = slope;
    seed = first_seed;
    memset(told, 0, sizeof told);
}

static void draw_machine(void)
{
    machine.period_s = random_between(1e-3, 8e-3);
    machine.path.feed_max = random_between(40.0, 200.0);
    machine.path.a_max = random_between(300.0, 3000.0);
    machine.path.j_max = random_between(3e3, 3e4);
    machine.path.chord_error = random_between(1e-3, 5e-2);
    for (int x = 0; x < 3; x++) {
        nck_axis_t *const axis = &machine.axis[x];
        axis->v_max = random_between(30.0, 200.0);
        axis->rapid = random_between(0.5, 1.0) * axis->v_max;
        axis->a_max = random_between(300.0, 3000.0);
        axis->j_max = random_between(3e3, 3e4);
    }
}

static void draw_line(void)
{
    memset(&seg, 0, sizeof seg);
    seg.kind = NCK_SEG_LINE;
    for (int x = 0; x < 3; x++) {
        seg.start[x] = random_between(-50.0, 50.0);
        seg.end[x] = seg.start[x] + random_between(-50.0, 50.0);
    }
    if (random_between(0.0, 1.0) < 0.2) seg.end[1] = seg.start[1]; // an axis that stands still
    seg.length = sqrt(pow(seg.end[0] - seg.start[0], 2.0) + pow(seg.end[1] - seg.start[1], 2.0)
                      + pow(seg.end[2] - seg.start[2], 2.0));
}

// An arc or a helix in any plane, from a tenth of a radian to more than a turn.
static void draw_arc(void)
{
    memset(&seg, 0, sizeof seg);
    seg.kind = NCK_SEG_ARC;
    const int plane = (int)random_between(0.0, 3.0);
    seg.shape.arc.axis_u = (uint8_t)plane;
    seg.shape.arc.axis_v = (uint8_t)((plane + 1) % 3);
    const int across = (plane + 2) % 3;
    const double r = random_between(0.3, 30.0);
    const double from = random_between(0.0, TAU);
    seg.shape.arc.sweep = random_between(0.1, 8.0) * (random_between(-1.0, 1.0) < 0.0 ? -1.0 : 1.0);
    seg.shape.arc.centre_u = random_between(-20.0, 20.0);
    seg.shape.arc.centre_v = random_between(-20.0, 20.0);
    seg.start[seg.shape.arc.axis_u] = seg.shape.arc.centre_u + r * cos(from);
    seg.start[seg.shape.arc.axis_v] = seg.shape.arc.centre_v + r * sin(from);
    seg.end[seg.shape.arc.axis_u] = seg.shape.arc.centre_u + r * cos(from + seg.shape.arc.sweep);
    seg.end[seg.shape.arc.axis_v] = seg.shape.arc.centre_v + r * sin(from + seg.shape.arc.sweep);
    if (random_between(0.0, 1.0) < 0.5) seg.end[across] = random_between(-20.0, 20.0);
    seg.length = hypot(r * seg.shape.arc.sweep, seg.end[across]);
}

static void draw_feed(void)
{
    seg.rapid = random_between(0.0, 1.0) < 0.2;
    seg.feed = seg.rapid ? 0.0 : random_between(5.0, 250.0);
    seg.feed_scale = random_between(0.5, 1.0);
}

static void plan(check_t *check)
{
    nck_lookahead_init(&lookahead, terms_of(&machine));
    CHECK_INT(check, nck_lookahead_push(&lookahead, &seg), NCK_OK);
    nck_lookahead_end(&lookahead);
    while (nck_lookahead_step(&lookahead) == NCK_OK) continue;
    CHECK_INT(check, nck_lookahead_fill(&lookahead), 1);
    node = *nck_lookahead_ahead(&lookahead, 0);
    CHECK(check, node.s == 0.0 && node.length == seg.length && node.last == 1 && node.stop == 1);
}

// The largest share of the path's speed that each axis sees somewhere on the seg.
static void find_cosines(double cosine[3])
{
    double tangent[NCK_AXIS_MAX];
    memset(cosine, 0, 3 * sizeof *cosine);
    for (int k = 0; k <= SAMPLES; k++) {
        nck_path_tangent(&seg, seg.length * k / (double)SAMPLES, tangent);
        for (int x = 0; x < 3; x++) cosine[x] = fmax(cosine[x], fabs(tangent[x]));
    }
}

static void cap(allowed_t *allowed, double v, int limit)
{
    allowed->v_free = fmin(allowed->v_free, v);
    if (v >= allowed->v) return;
    allowed->v = v;
    allowed->limit = limit;
}

// How much of the speed lies in an arc's plane, and how much the path bends.
static double arc_cosine(double *radius_out)
{
    const nck_seg_arc_t *const arc = &seg.shape.arc;
    *radius_out = hypot(seg.start[arc->axis_u] - arc->centre_u,
                        seg.start[arc->axis_v] - arc->centre_v);
    return *radius_out * fabs(arc->sweep) / seg.length;
}

static double plane_a(void)
{
    return fmin(machine.axis[seg.shape.arc.axis_u].a_max, machine.axis[seg.shape.arc.axis_v].a_max);
}

static double plane_j(void)
{
    return fmin(machine.axis[seg.shape.arc.axis_u].j_max, machine.axis[seg.shape.arc.axis_v].j_max);
}

// A plan asks for no more jerk along the path than the axes have together, and for no ramp of less
// than two filters (5_slope/README, section "output filter").
static double most_jerk(void)
{
    const nck_axis_t *const axis = machine.axis;
    const double a = hypot(axis[0].a_max, hypot(axis[1].a_max, axis[2].a_max));
    const double j = hypot(axis[0].j_max, hypot(axis[1].j_max, axis[2].j_max));
    const double tau = NCK_FILTER_TAPS * machine.period_s;
    const double along = fmin(machine.path.j_max, j);
    if (machine.slope == NCK_SLOPE_LINEAR) return machine.path.j_max;
    return fmin(along, fmin(machine.path.a_max, a) / (2.0 * tau));
}

// No acceleration is come to, or left, that a speed has no room for:   v ≥ a²/2j
static void cap_by_jerk(allowed_t *allowed)
{
    if (machine.slope == NCK_SLOPE_LINEAR) return;
    allowed->a_come_to = sqrt(2.0 * allowed->v_free * most_jerk());
}

// Chords of one period stay within the chord error; the centripetal acceleration takes 0.8; under a
// jerk limit half of the plane's jerk is for the turn at constant speed, v³/r².
static void cap_arc(allowed_t *allowed)
{
    double r = 0.0;
    const double cosine = arc_cosine(&r);
    const double sagitta = fmin(machine.path.chord_error, r);
    const double chord = 2.0 * sqrt(r * r - (r - sagitta) * (r - sagitta));
    cap(allowed, chord / machine.period_s / cosine, NCK_LIMIT_CHORD);
    if (machine.slope != NCK_SLOPE_LINEAR) {
        cap(allowed, cbrt(0.5 * plane_j() * r * r) / cosine, NCK_LIMIT_JERK);
    }
    cap_by_jerk(allowed);
    allowed->v_turn = allowed->v_free;
    cap(allowed, sqrt(0.8 * plane_a() * r) / cosine, NCK_LIMIT_CURVATURE);
}

static allowed_t find_allowed(void)
{
    double cosine[3];
    allowed_t allowed = {1e30, 1e30, machine.path.a_max, most_jerk(), -1, 1e30, 1e30};
    if (!seg.rapid) {
        cap(&allowed, machine.path.feed_max / seg.feed_scale, NCK_LIMIT_FEED_MAX);
    }
    find_cosines(cosine);
    for (int x = 0; x < 3; x++) {
        const nck_axis_t *const axis = &machine.axis[x];
        const int in_plane = nck_path_turns(&seg, x);
        if (!(cosine[x] > 0.0)) continue;
        cap(&allowed, (seg.rapid ? axis->rapid : axis->v_max) / cosine[x],
            seg.rapid ? NCK_LIMIT_RAPID : NCK_LIMIT_AXIS_V + x);
        allowed.j = fmin(allowed.j, axis->j_max / cosine[x]);
        if (!in_plane) allowed.a = fmin(allowed.a, axis->a_max / cosine[x]);
    }
    if (seg.kind == NCK_SEG_ARC) cap_arc(&allowed);
    else cap_by_jerk(&allowed);
    allowed.a = fmin(allowed.a, allowed.a_come_to);
    if (!seg.rapid && seg.feed < allowed.v) {
        allowed.v = seg.feed;
        allowed.limit = NCK_LIMIT_FEED;
    }
    return allowed;
}

// What an arc's bend at v leaves along the path; the two are at a right angle.
static double a_beside_the_bend(double v)
{
    double r = 0.0;
    const double cosine = arc_cosine(&r);
    const double bend = v * v * cosine * cosine / r;
    return sqrt(fmax(0.0, plane_a() * plane_a() - bend * bend)) / cosine;
}

// What the turn at v leaves along the path: acceleration, for half of the jerk by squares, and jerk
// beside an acceleration; along the tangent and along the normal they are at a right angle.
static double twist_at(double v)
{
    double r = 0.0;
    const double v_plane = v * arc_cosine(&r);
    return v_plane * v_plane * v_plane / (r * r);
}

static double normal_at(double v, double a)
{
    double r = 0.0;
    const double cosine = arc_cosine(&r);
    return 3.0 * v * a * cosine * cosine / r;
}

static double a_beside_the_turn(double v)
{
    const double twist = twist_at(v);
    return sqrt((plane_j() * plane_j() - twist * twist) / 2.0) / normal_at(v, 1.0);
}

static double j_beside_the_turn(double v, double a)
{
    double r = 0.0;
    const double normal = normal_at(v, a);
    return (sqrt(plane_j() * plane_j() - normal * normal) - twist_at(v)) / arc_cosine(&r);
}

static void check_speed(check_t *check, const allowed_t *allowed)
{
    CHECK_NEAR(check, sqrt(node.vv_piece), allowed->v, NEAR * allowed->v);
    CHECK_NEAR(check, sqrt(node.vv_over), allowed->v_free, NEAR * allowed->v_free);
    CHECK_NEAR(check, node.j, allowed->j, NEAR * allowed->j);
    CHECK_INT(check, node.limit_piece, allowed->limit);
    CHECK(check, node.feed == seg.feed);
    told[node.limit_piece]++;
}

static void lines_get_what_every_axis_allows(check_t *check)
{
    for (uint32_t slope = NCK_SLOPE_LINEAR; slope <= NCK_SLOPE_JERK; slope++) {
        begin(1 + slope, slope);
        for (int k = 0; k < TRIALS; k++) {
            draw_machine();
            draw_line();
            draw_feed();
            plan(check);
            const allowed_t allowed = find_allowed();
            check_speed(check, &allowed);
            CHECK_NEAR(check, node.a, allowed.a, NEAR * allowed.a);
            CHECK(check, node.a_over == node.a && node.j_over == node.j);
        }
        for (int x = 0; x < 3; x++) CHECK(check, told[NCK_LIMIT_AXIS_V + x] > 0);
        CHECK(check, told[NCK_LIMIT_FEED] > 0 && told[NCK_LIMIT_FEED_MAX] > 0);
        CHECK(check, told[NCK_LIMIT_RAPID] > 0);
    }
}

static void arcs_get_what_chords_bends_and_axes_allow(check_t *check)
{
    begin(7, NCK_SLOPE_LINEAR);
    for (int k = 0; k < TRIALS; k++) {
        draw_machine();
        draw_arc();
        draw_feed();
        plan(check);
        const allowed_t allowed = find_allowed();
        const double left = fmin(allowed.a, a_beside_the_bend(allowed.v));
        check_speed(check, &allowed);
        CHECK_NEAR(check, node.a, left, 2.0 * NEAR * left);
    }
    CHECK(check, told[NCK_LIMIT_CHORD] > 0 && told[NCK_LIMIT_CURVATURE] > 0);
    CHECK(check, told[NCK_LIMIT_FEED] > 0 && told[NCK_LIMIT_AXIS_V] > 0);
}

// Under a jerk limit the filter may add a little to the speed: the bend at that speed is paid for,
// also where an override raises the feed.
static void arcs_pay_for_what_the_filter_adds(check_t *check)
{
    begin(8, NCK_SLOPE_JERK);
    for (int k = 0; k < TRIALS; k++) {
        draw_machine();
        draw_arc();
        draw_feed();
        plan(check);
        allowed_t allowed = find_allowed();
        const double tau = NCK_FILTER_TAPS * machine.period_s;
        const double q = 1.35 * machine.period_s; // 5_slope/README, section "output"
        const double v_filter = most_jerk() * (tau * tau / 24.0 + q * q / 8.0);
        double r = 0.0;
        const double cosine = arc_cosine(&r);
        const double v_bend = sqrt(0.8 * plane_a() * r) / cosine;
        const double v_top = seg.feed > 0.0 ? fmin(2.0 * seg.feed, allowed.v_free) : allowed.v_free;
        const double v[2] = {allowed.v + v_filter, v_top + v_filter};
        double left[2], jerk[2];
        for (int pace = 0; pace < 2; pace++) {
            const double v_turn = fmin(v[pace], allowed.v_turn);
            left[pace] = fmin(allowed.a, a_beside_the_bend(fmin(v[pace], v_bend)));
            left[pace] = fmin(left[pace], a_beside_the_turn(v_turn));
            jerk[pace] = fmin(allowed.j, j_beside_the_turn(v_turn, left[pace]));
        }
        allowed.j = jerk[0];
        check_speed(check, &allowed);
        CHECK_NEAR(check, node.a, left[0], 1e-5 * left[0]);
        CHECK_NEAR(check, node.a_over, fmin(left[0], left[1]), 1e-5 * left[0]);
        CHECK_NEAR(check, node.j_over, fmin(jerk[0], jerk[1]), NEAR * jerk[0]);
    }
    CHECK(check, told[NCK_LIMIT_JERK] > 0 && told[NCK_LIMIT_CURVATURE] > 0);
}

// A quarter of a circle from 45° to 135°: in the middle X sees all of the speed; what Y sees is
// most at the ends.
static void axes_count_by_what_they_see_of_an_arc(check_t *check)
{
    begin(1, NCK_SLOPE_LINEAR);
    memset(&seg, 0, sizeof seg);
    seg.kind = NCK_SEG_ARC;
    seg.shape.arc.axis_v = NCK_AXIS_Y;
    seg.start[0] = seg.start[1] = seg.end[1] = 40.0 * sqrt(0.5);
    seg.end[0] = -seg.start[0];
    seg.shape.arc.sweep = TAU / 4.0;
    seg.length = 10.0 * TAU;
    seg.feed = 1000.0;
    seg.feed_scale = 1.0;
    machine.path.feed_max = 500.0;
    machine.axis[0].v_max = machine.axis[0].rapid = 50.0;
    plan(check);
    CHECK_NEAR(check, sqrt(node.vv_piece), 50.0, 1e-9);
    CHECK_INT(check, node.limit_piece, NCK_LIMIT_AXIS_V + NCK_AXIS_X);
    machine.axis[0].v_max = machine.axis[0].rapid = 500.0;
    machine.axis[1].v_max = machine.axis[1].rapid = 50.0;
    plan(check);
    CHECK_NEAR(check, sqrt(node.vv_piece), 50.0 / sqrt(0.5), 1e-9);
    CHECK_INT(check, node.limit_piece, NCK_LIMIT_AXIS_V + NCK_AXIS_Y);
}

// Of two limits that are the same it is the program that is told.
static void a_feed_that_is_just_allowed_is_the_limit(check_t *check)
{
    begin(1, NCK_SLOPE_LINEAR);
    draw_line();
    seg.feed = machine.path.feed_max;
    seg.feed_scale = 1.0;
    for (int x = 0; x < 3; x++) machine.axis[x].v_max = 1000.0;
    plan(check);
    CHECK(check, node.vv_piece == seg.feed * seg.feed && node.vv_over == node.vv_piece);
    CHECK_INT(check, node.limit_piece, NCK_LIMIT_FEED);
}

int main(void)
{
    check_t check = {0};
    CHECK_RUN(&check, lines_get_what_every_axis_allows);
    CHECK_RUN(&check, arcs_get_what_chords_bends_and_axes_allow);
    CHECK_RUN(&check, arcs_pay_for_what_the_filter_adds);
    CHECK_RUN(&check, axes_count_by_what_they_see_of_an_arc);
    CHECK_RUN(&check, a_feed_that_is_just_allowed_is_the_limit);
    return check_end(&check);
}
