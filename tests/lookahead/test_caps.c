// SPDX-License-Identifier: MIT
// Room 4 alone under the jerk-limited slope: what a node allows breaks no axis' limit anywhere.
#include <math.h>   // sqrt fabs cos sin
#include <string.h> // memset

#include "check.h"
#include "nck/base/path.h"                   // nck_path_tangent …
#include "nck/prep/4_lookahead/lookahead.h"  // nck_lookahead_t
#include "nck/prep/5_slope/ladder_math.h"    // nck_ladder_raise
#include "terms_check.h" // terms_of

enum { SEGS = 1200, NODES = 3 * SEGS, SAMPLES = 8 };

#define PERIOD 0.001

static nck_machine_t machine;
static nck_lookahead_t lookahead;
static nck_seg_t segs[SEGS];
static nck_node_t nodes[NODES];
static uint32_t seg_count;
static uint32_t node_count;
static uint64_t seed;

// Xorshift, G. Marsaglia 2003: the same numbers everywhere. 0 … 1.
static double random_real(void)
{
    seed ^= seed << 13;
    seed ^= seed >> 7;
    seed ^= seed << 17;
    return (double)(seed >> 11) / 9007199254740992.0;
}

static void begin(uint64_t first_seed)
{
    nck_machine_default(&machine);
    machine.slope = NCK_SLOPE_JERK;
    machine.axis[1].a_max = 700.0;
    machine.axis[2].j_max = 6000.0;
    seed = first_seed;
    seg_count = 0;
    node_count = 0;
}

static nck_seg_t *next_seg(int kind, double feed)
{
    nck_seg_t *const seg = &segs[seg_count];
    memset(seg, 0, sizeof *seg);
    seg->seq = seg_count;
    seg->kind = (uint8_t)kind;
    seg->feed = feed;
    seg->feed_scale = 1.0;
    if (seg_count > 0) memcpy(seg->start, segs[seg_count - 1].end, sizeof seg->start);
    seg_count++;
    return seg;
}

static void add_line(double dx, double dy, double feed)
{
    nck_seg_t *const seg = next_seg(NCK_SEG_LINE, feed);
    memcpy(seg->end, seg->start, sizeof seg->end);
    seg->end[0] += dx;
    seg->end[1] += dy;
    seg->length = sqrt(dx * dx + dy * dy);
}

// Arcs of a length, each of which goes on where the last one points: they turn by up to `turn`, to
// either side, and rise.
static void add_arcs(int count, double length, double turn, double feed)
{
    double angle = 0.0;
    for (int n = 0; n < count; n++) {
        nck_seg_t *const seg = next_seg(NCK_SEG_ARC, feed);
        nck_seg_arc_t *const arc = &seg->shape.arc;
        const double share = random_real() - 0.5;
        arc->sweep = turn * (share < 0.0 ? fmin(share, -0.05) : fmax(share, 0.05));
        const double radius = length / arc->sweep; // to the left, if it is positive
        arc->axis_v = NCK_AXIS_Y;
        arc->centre_u = seg->start[0] - radius * sin(angle);
        arc->centre_v = seg->start[1] + radius * cos(angle);
        angle += arc->sweep;
        seg->end[0] = arc->centre_u + radius * sin(angle);
        seg->end[1] = arc->centre_v - radius * cos(angle);
        seg->end[2] = seg->start[2];
        seg->length = length;
    }
}

static void take_nodes(void)
{
    const uint32_t count = nck_lookahead_fill(&lookahead);
    for (uint32_t i = 0; i < count; i++) {
        nodes[node_count] = *nck_lookahead_ahead(&lookahead, i);
        node_count++;
    }
    nck_lookahead_drop(&lookahead, count);
}

// Plan all segs. greedy: push as many as go in before a step is made, else as few.
static void plan(check_t *check, int greedy)
{
    uint32_t pushed = 0;
    node_count = 0;
    nck_lookahead_init(&lookahead, terms_of(&machine));
    for (;;) {
        while (greedy && pushed < seg_count
               && nck_lookahead_push(&lookahead, &segs[pushed]) == NCK_OK) {
            pushed++;
        }
        if (pushed == seg_count) nck_lookahead_end(&lookahead);
        const nck_status_t status = nck_lookahead_step(&lookahead);
        CHECK(check, nck_lookahead_invariants(&lookahead));
        if (status == NCK_DONE) break;
        if (status == NCK_FULL) take_nodes();
        if (status == NCK_EMPTY && pushed < seg_count) {
            CHECK_INT(check, nck_lookahead_push(&lookahead, &segs[pushed]), NCK_OK);
            pushed++;
        }
    }
    CHECK(check, nck_lookahead_is_complete(&lookahead));
    take_nodes();
}

// The largest share of an axis' acceleration (0) and jerk (1) that is used on a piece from end to
// end at speed v with the tangential limits a and j.
static void use_of(const nck_node_t *node, double v, double a, double j, double use[2])
{
    const nck_seg_t *const seg = &segs[node->seg];
    use[0] = 0.0;
    use[1] = 0.0;
    for (int n = 0; n <= SAMPLES; n++) {
        const double s = node->s + node->length * n / (double)SAMPLES;
        double d1[NCK_AXIS_MAX];
        double d2[NCK_AXIS_MAX];
        double d3[NCK_AXIS_MAX];
        nck_path_tangent(seg, s, d1);
        nck_path_second(seg, s, d2);
        nck_path_third(seg, s, d3);
        for (int x = 0; x < NCK_AXIS_MAX; x++) {
            const double acc = fabs(d2[x]) * v * v + fabs(d1[x]) * a;
            const double jerk = fabs(d3[x]) * v * v * v + 3.0 * fabs(d2[x]) * v * a
                                + fabs(d1[x]) * j;
            use[0] = fmax(use[0], acc / machine.axis[x].a_max);
            use[1] = fmax(use[1], jerk / machine.axis[x].j_max);
        }
    }
}

// The speed that the slope may have in a piece at a feed override.
static double speed_at(const nck_node_t *node, double override)
{
    const double v = sqrt(node->vv_over);
    return node->feed > 0.0 ? fmin(v, override * node->feed) : v;
}

static void arcs_keep_every_axis(check_t *check)
{
    const double turns[] = {0.01, 0.1, 0.5, 1.5};
    const double spacings[] = {0.3, 0.02, 1.0};
    for (int k = 0; k < 12; k++) {
        begin(1 + (uint64_t)k);
        add_arcs(SEGS / 4, spacings[k % 3], turns[k / 3], 80.0);
        plan(check, 1);
        for (uint32_t i = 0; i < node_count; i++) {
            double use[2];
            use_of(&nodes[i], speed_at(&nodes[i], 1.0), nodes[i].a, nodes[i].j, use);
            CHECK(check, use[0] <= 1.0 + 1e-9 && use[1] <= 1.0 + 1e-9);
            use_of(&nodes[i], speed_at(&nodes[i], 2.0), nodes[i].a_over, nodes[i].j_over, use);
            CHECK(check, use[0] <= 1.0 + 1e-9 && use[1] <= 1.0 + 1e-9);
            CHECK(check, nodes[i].a > 0.0 && nodes[i].j > 0.0 && nodes[i].vv_over > 0.0);
            CHECK(check, nodes[i].a_over > 0.0 && nodes[i].j_over > 0.0);
        }
    }
}

// The speed that a piece can have at all, from one that can be reached at its ends with what the
// pieces between allow.
static double reachable[NODES];

static void find_reachable(void)
{
    double vv = 0.0;
    for (uint32_t i = 0; i < node_count; i++) {
        const double cap = speed_at(&nodes[i], 1.0) * speed_at(&nodes[i], 1.0);
        vv = fmin(fmin(vv, cap) + 2.0 * nodes[i].a * nodes[i].length, cap);
        reachable[i] = vv;
    }
    vv = 0.0;
    for (uint32_t i = node_count; i-- > 0;) {
        vv = fmin(vv + 2.0 * nodes[i].a * nodes[i].length, reachable[i]);
        reachable[i] = sqrt(vv);
    }
}

static void use_is_kept(check_t *check, uint32_t at, uint32_t limits)
{
    double use[2];
    use_of(&nodes[at], reachable[at], nodes[limits].a, nodes[limits].j, use);
    CHECK(check, use[0] <= 1.0 + 1e-9 && use[1] <= 1.0 + 1e-9);
}

// The least time in a piece: a slower one beside it must be left, or come down to, with what the
// piece's acceleration allows.
static double least_time(uint32_t at)
{
    const double v = reachable[at];
    const double a = nodes[at].a;
    double low = at > 0 ? fmin(v, reachable[at - 1]) : 0.0;
    if (at + 1 < node_count) low = fmin(low, reachable[at + 1]);
    const double over = fmin(nodes[at].length, (v * v - low * low) / (2.0 * a));
    return (sqrt(low * low + 2.0 * a * over) - low) / a + (nodes[at].length - over) / v;
}

// The filter mixes what pieces up to half its length away allow.
static void limits_are_good_for_all_that_the_filter_mixes(check_t *check)
{
    begin(5);
    add_line(20.0, 0.0, 80.0);
    add_arcs(SEGS / 4, 0.05, 0.4, 80.0);
    plan(check, 1);
    find_reachable();
    const double reach = PERIOD * NCK_FILTER_TAPS / 2.0;
    for (uint32_t i = 0; i < node_count; i++) {
        double time = 0.0;
        for (uint32_t k = i + 1; k < node_count && time < reach; k++) {
            use_is_kept(check, k, i);
            use_is_kept(check, i, k);
            time += least_time(k);
        }
    }
}

static void nodes_hang_on_counts_not_on_time(check_t *check)
{
    static nck_node_t eager[NODES];
    begin(9);
    add_arcs(SEGS / 4, 0.2, 0.8, 80.0);
    add_line(5.0, 0.0, 80.0);
    add_line(5.0, 1.0, 60.0);
    add_arcs(SEGS / 4, 0.05, 0.8, 60.0);
    plan(check, 1);
    const uint32_t count = node_count;
    memcpy(eager, nodes, sizeof eager);
    plan(check, 0);
    CHECK_INT(check, node_count, count);
    CHECK_INT(check, memcmp(eager, nodes, count * sizeof *nodes), 0);
}

// Arcs that go on into each other turn by rounding far out as well; a true corner costs what it
// costs.
static void rounding_is_no_corner(check_t *check)
{
    begin(4);
    add_arcs(SEGS / 4, 0.01, 0.002, 90.0);
    for (uint32_t i = 0; i < seg_count; i++) {
        for (int k = 0; k < 3; k++) {
            segs[i].start[k] += 900.0;
            segs[i].end[k] += 900.0;
        }
        segs[i].shape.arc.centre_u += 900.0;
        segs[i].shape.arc.centre_v += 900.0;
    }
    plan(check, 1);
    for (uint32_t i = 1; i < node_count; i++) {
        CHECK(check, nodes[i].limit != NCK_LIMIT_CORNER);
        CHECK(check, nodes[i].vv_node >= 0.9 * fmin(nodes[i].vv_over, nodes[i - 1].vv_over));
    }
    begin(4);
    add_line(1.0, 0.0, 90.0);
    add_line(1.0, 0.0, 90.0);
    add_line(0.0, 3.0, 90.0);
    plan(check, 1);
    CHECK_INT(check, nodes[node_count - 1].seg, 2);
    uint32_t corners = 0;
    for (uint32_t i = 1; i < node_count; i++) corners += nodes[i].limit == NCK_LIMIT_CORNER;
    CHECK_INT(check, corners, 1);
}

// Crossed at the node's cap and what the filter adds, a lone corner costs each axis its share, and
// the pieces around leave the rest free.
static void corner_and_pieces_share_the_acceleration(check_t *check)
{
    const double raise =
        nck_ladder_raise(10000.0, NCK_FILTER_TAPS * PERIOD, NCK_LADDER_STRETCH * PERIOD);
    const double angles[] = {0.01, 0.1, 0.5, 1.5, 3.0};
    for (int k = 0; k < 5; k++) {
        begin(1);
        add_line(30.0, 0.0, 45.0);
        add_line(30.0 * cos(angles[k]), 30.0 * sin(angles[k]), 45.0);
        plan(check, 1);
        uint32_t at = 0;
        while (nodes[at].seg == 0) at++;
        const double most[2] = {45.0, 90.0};
        for (int pace = 0; pace < 2; pace++) {
            const double v = fmin(sqrt(nodes[at].vv_node), most[pace]) + raise;
            for (int x = 0; x < 2; x++) {
                const double c0 = x == 0 ? 1.0 : 0.0;
                const double c1 = x == 0 ? cos(angles[k]) : sin(angles[k]);
                const double share = v * fabs(c1 - c0) / PERIOD / machine.axis[x].a_max;
                const double a0 = pace ? nodes[at - 1].a_over : nodes[at - 1].a;
                const double a1 = pace ? nodes[at].a_over : nodes[at].a;
                const double used = fmax(fabs(c0) * a0, fabs(c1) * a1) / machine.axis[x].a_max;
                CHECK(check, share + used <= 1.0 + 1e-9);
            }
        }
        CHECK(check, nodes[at].vv_node > 0.0);
    }
}

// The path's acceleration on a line in a direction.
static double gain_of(double angle)
{
    return fmin(machine.path.a_max, fmin(machine.axis[0].a_max / fabs(cos(angle)),
                                         machine.axis[1].a_max / fabs(sin(angle))));
}

// What a corner costs an axis per speed: of the axis that it costs most of its acceleration.
static double cost_of(double before, double after)
{
    return fmax(fabs(cos(after) - cos(before)) / machine.axis[0].a_max,
                fabs(sin(after) - sin(before)) / machine.axis[1].a_max);
}

// Two corners within a period, under the linear slope: crossed at v, the one costs d·v, the other,
// which is x away and may be crossed faster by a period's gain, d'·(v + A·T − x/T), and both
// together half of an axis' acceleration in a period T.
static void two_corners_in_a_period_share_it(check_t *check)
{
    uint32_t crowds = 0;
    for (uint64_t run = 1; run <= 2000; run++) {
        begin(7919 * run);
        machine.slope = NCK_SLOPE_LINEAR;
        double angle[3] = {6.28 * random_real(), 0.0, 0.0};
        for (int k = 0; k < 2; k++) {
            const double turn = 0.02 + 0.15 * random_real();
            angle[k + 1] = angle[k] + (random_real() < 0.5 ? -turn : turn);
        }
        const double d[2] = {cost_of(angle[0], angle[1]), cost_of(angle[1], angle[2])};
        const double x = random_real() * PERIOD * 0.5 * PERIOD / fmax(d[0], d[1]);
        const double gain =
            PERIOD * fmax(gain_of(angle[0]), fmax(gain_of(angle[1]), gain_of(angle[2])));
        add_line(20.0 * cos(angle[0]), 20.0 * sin(angle[0]), 90.0);
        add_line(x * cos(angle[1]), x * sin(angle[1]), 90.0);
        add_line(20.0 * cos(angle[2]), 20.0 * sin(angle[2]), 90.0);
        plan(check, 1);
        for (uint32_t k = 0, at = 0; k < 2; k++) {
            while (nodes[at].seg == k) at++;
            const double alone = 0.5 * PERIOD / d[k];
            if (x >= (alone + gain) * PERIOD) continue;
            const double other = d[1 - k];
            const double both = (0.5 * PERIOD - other * (gain - x / PERIOD)) / (d[k] + other);
            const double v = fmax(0.0, fmin(alone, both));
            CHECK_NEAR(check, sqrt(nodes[at].vv_node), v, 1e-9 * alone);
            crowds += both < 0.95 * alone && both > 0.0;
        }
    }
    CHECK(check, crowds > 1000);
}

static void pieces_are_there_as_soon_as_they_are_placed(check_t *check)
{
    begin(1);
    add_line(10.0, 0.0, 50.0);
    add_line(10.0, 0.0, 50.0);
    add_line(10.0, 0.0, 50.0);
    nck_seg_t *const wait = next_seg(NCK_SEG_WAIT, 0.0);
    memcpy(wait->end, wait->start, sizeof wait->end);
    wait->stop = 1;
    nck_lookahead_init(&lookahead, terms_of(&machine));
    CHECK_INT(check, nck_lookahead_fill(&lookahead), 0);
    for (uint32_t i = 0; i < 3; i++) nck_lookahead_push(&lookahead, &segs[i]);
    while (nck_lookahead_step(&lookahead) == NCK_OK) { }
    CHECK_INT(check, nck_lookahead_fill(&lookahead), 2);
    CHECK(check, !nck_lookahead_is_complete(&lookahead));
    nck_lookahead_push(&lookahead, &segs[3]);
    while (nck_lookahead_step(&lookahead) == NCK_OK) { }
    CHECK_INT(check, nck_lookahead_fill(&lookahead), 4);
    CHECK(check, nck_lookahead_is_complete(&lookahead));
    nck_lookahead_drop(&lookahead, 1);
    CHECK_INT(check, nck_lookahead_ahead(&lookahead, 0)->seg, 1);
}

// An override meets the caps of the path, and of a rapid it is none.
static void override_moves_the_feed_alone(check_t *check)
{
    begin(1);
    add_line(40.0, 0.0, 30.0);
    add_line(40.0, 0.0, 0.0);
    segs[1].rapid = 1;
    plan(check, 1);
    CHECK(check, nodes[0].feed == 30.0 && nodes[0].vv_piece == 900.0);
    CHECK(check, nodes[0].vv_over == 10000.0);
    CHECK(check, nodes[node_count - 1].feed == 0.0 && nodes[node_count - 1].vv_piece == 10000.0);
}

int main(void)
{
    check_t check = {0};
    CHECK_RUN(&check, arcs_keep_every_axis);
    CHECK_RUN(&check, limits_are_good_for_all_that_the_filter_mixes);
    CHECK_RUN(&check, nodes_hang_on_counts_not_on_time);
    CHECK_RUN(&check, rounding_is_no_corner);
    CHECK_RUN(&check, corner_and_pieces_share_the_acceleration);
    CHECK_RUN(&check, two_corners_in_a_period_share_it);
    CHECK_RUN(&check, pieces_are_there_as_soon_as_they_are_placed);
    CHECK_RUN(&check, override_moves_the_feed_alone);
    return check_end(&check);
}
