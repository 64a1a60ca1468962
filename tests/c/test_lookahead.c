// SPDX-License-Identifier: MIT
// Room 4 alone, fed with segs: the window's envelope is the whole path's, to the bit.
#include <math.h>   // sqrt fabs
#include <string.h> // memset

#include "check.h"
#include "nck/base/envelope_math.h" // nck_envelope_…
#include "nck/prep/4_lookahead/lookahead.h"     // nck_lookahead_t

enum { SEGS = 6000, NODES = 3 * SEGS };

static nck_machine_t machine;
static nck_lookahead_t lookahead;
static nck_node_t nodes[NODES + 1];
static double whole[NODES + 1];
static uint32_t node_count;
static uint32_t open_count;
static uint64_t seed;

// Xorshift, G. Marsaglia 2003: the same numbers everywhere. 0 … 1.
static double random_real(void)
{
    seed ^= seed << 13;
    seed ^= seed >> 7;
    seed ^= seed << 17;
    return (double)(seed >> 11) / 9007199254740992.0;
}

static nck_seg_t line_from(const nck_seg_t *before, double dx, double dy, double feed)
{
    nck_seg_t seg;
    memset(&seg, 0, sizeof seg);
    seg.seq = before->seq + 1;
    seg.feed = feed;
    seg.feed_scale = 1.0;
    memcpy(seg.start, before->end, sizeof seg.start);
    memcpy(seg.end, before->end, sizeof seg.end);
    seg.end[0] += dx;
    seg.end[1] += dy;
    const double x = seg.end[0] - seg.start[0];
    const double y = seg.end[1] - seg.start[1];
    seg.length = sqrt(x * x + y * y);
    return seg;
}

static void take_pieces(void)
{
    const nck_node_t *node = NULL;
    double vv_end = 0.0;
    uint32_t n = 0;
    while (nck_lookahead_piece(&lookahead, n, &node, &vv_end) == NCK_OK) {
        nodes[node_count] = *node;
        open_count += node->open;
        node_count++;
        n++;
    }
    if (n > 0) nck_lookahead_drop(&lookahead, n);
}

// Work until the room wants segs (1) or is done (0).
static int work(check_t *check)
{
    for (;;) {
        const nck_status_t status = nck_lookahead_step(&lookahead);
        if (status == NCK_OK) continue;
        CHECK(check, nck_lookahead_invariants(&lookahead));
        take_pieces();
        if (status == NCK_EMPTY) return 1;
        if (status == NCK_DONE) return 0;
    }
}

static void begin(uint64_t first_seed)
{
    nck_machine_default(&machine);
    seed = first_seed;
    node_count = 0;
    open_count = 0;
}

// Plan a random polyline: mean length and turn of a seg, feed up to 100 mm/s.
static void plan(check_t *check, int count, double length, double turn)
{
    nck_seg_t seg;
    memset(&seg, 0, sizeof seg);
    seg.seq = 0xffffffffu;
    double angle = 0.0;
    nck_lookahead_init(&lookahead, &machine);
    for (int k = 0; k < count; k++) {
        const double l = length * (0.1 + random_real());
        angle += turn * (random_real() - 0.5);
        seg = line_from(&seg, l * cos(angle), l * sin(angle), 5.0 + 95.0 * random_real());
        while (nck_lookahead_push(&lookahead, &seg) != NCK_OK) work(check);
    }
    nck_lookahead_end(&lookahead);
    while (work(check)) { }
}

// The exact two passes over all nodes at once.
static void envelope(void)
{
    double w = 0.0;
    for (uint32_t i = node_count; i-- > 0;) {
        w = nck_envelope_backward(nodes[i].vv_cap, w, nck_envelope_h(nodes[i].a, nodes[i].length));
        whole[i] = w;
    }
    w = 0.0;
    for (uint32_t i = 0; i < node_count; i++) {
        whole[i] = nck_envelope_forward(whole[i], w, 0.0);
        w = whole[i] + nck_envelope_h(nodes[i].a, nodes[i].length);
    }
}

static void window_gives_the_bits_of_the_whole_path(check_t *check)
{
    // The shortest window must hold the longest braking distance: 100²/2/500 = 10 mm.
    const double length = 40.0 / NCK_WINDOW;
    const double turns[] = {0.0, 0.02, 0.3, 3.0};
    for (int k = 0; k < 4; k++) {
        begin(1 + (uint64_t)k);
        plan(check, SEGS / 2, length < 0.3 ? 0.3 : length * 4.0, turns[k]);
        envelope();
        CHECK_INT(check, open_count, 0);
        uint32_t different = 0;
        for (uint32_t i = 0; i < node_count; i++) different += nodes[i].vv != whole[i];
        CHECK_INT(check, different, 0);
    }
}

static void short_window_is_slower_but_never_faster(check_t *check)
{
    begin(7);
    machine.lookahead_blocks = 8;
    plan(check, SEGS / 2, 0.05, 0.01);
    envelope();
    CHECK(check, open_count > 0);
    for (uint32_t i = 0; i < node_count; i++) CHECK(check, nodes[i].vv <= whole[i]);
}

static void every_piece_can_be_braked(check_t *check)
{
    begin(3);
    plan(check, SEGS, 0.02, 0.5);
    for (uint32_t i = 0; i + 1 < node_count; i++) {
        const double h = nck_envelope_h(nodes[i].a, nodes[i].length);
        CHECK(check, fabs(nodes[i + 1].vv - nodes[i].vv) <= h * (1.0 + 1e-9) + 1e-12);
    }
    CHECK(check, nodes[node_count - 1].stop == 1 && nodes[0].vv == 0.0);
}

static void lone_corner_keeps_the_transfer_rule(check_t *check)
{
    begin(1);
    nck_seg_t seg;
    memset(&seg, 0, sizeof seg);
    seg.seq = 0xffffffffu;
    nck_lookahead_init(&lookahead, &machine);
    for (int k = 0; k < 2; k++) {
        seg = line_from(&seg, 50.0, k * 10.0, 100.0);
        nck_lookahead_push(&lookahead, &seg);
    }
    nck_lookahead_end(&lookahead);
    while (work(check)) { }
    // |Δc_y| = 10/√2600; v = ½·a·T/|Δc|  (Cao et al. 2014, eq. 14, with the corner's share)
    const double v = 0.5 * 1000.0 * 0.001 / (10.0 / sqrt(2600.0));
    double v_corner = 0.0;
    for (uint32_t i = 0; i < node_count; i++) {
        if (nodes[i].seg == 1 && nodes[i].s == 0.0) v_corner = sqrt(nodes[i].vv_cap);
    }
    CHECK_NEAR(check, v_corner, v, 1e-12);
}

static void sharp_corner_is_stopped_at_and_frees_the_acceleration(check_t *check)
{
    begin(1);
    nck_seg_t seg;
    memset(&seg, 0, sizeof seg);
    seg.seq = 0xffffffffu;
    nck_lookahead_init(&lookahead, &machine);
    for (int k = 0; k < 2; k++) {
        seg = line_from(&seg, k ? 0.0 : 50.0, k ? 50.0 : 0.0, 100.0);
        nck_lookahead_push(&lookahead, &seg);
    }
    nck_lookahead_end(&lookahead);
    while (work(check)) { }
    CHECK_INT(check, node_count, 2);
    CHECK(check, nodes[1].vv == 0.0 && nodes[0].a == 1000.0 && nodes[1].a == 1000.0);
    CHECK_INT(check, nodes[0].stop, 0);
}

// A corner that takes much, at one end, lets both ends be cut off: the middle has all.
static void middle_between_two_corners_has_all_of_the_acceleration(check_t *check)
{
    const double angle[] = {0.0, 0.004, 0.0042}; // shares of 0.4 and 0.02 at 100 mm/s
    begin(1);
    nck_seg_t seg;
    memset(&seg, 0, sizeof seg);
    seg.seq = 0xffffffffu;
    nck_lookahead_init(&lookahead, &machine);
    for (int k = 0; k < 3; k++) {
        seg = line_from(&seg, 50.0 * cos(angle[k]), 50.0 * sin(angle[k]), 100.0);
        nck_lookahead_push(&lookahead, &seg);
    }
    nck_lookahead_end(&lookahead);
    while (work(check)) { }
    double most = 0.0;
    double least = 1e9;
    for (uint32_t i = 0; i < node_count; i++) {
        if (nodes[i].seg != 1) continue;
        most = fmax(most, nodes[i].a);
        least = fmin(least, nodes[i].a);
    }
    CHECK_NEAR(check, most, 1000.0, 1e-9);
    CHECK_NEAR(check, least, 600.0, 1.0);
}

int main(void)
{
    check_t check = {0};
    CHECK_RUN(&check, window_gives_the_bits_of_the_whole_path);
    CHECK_RUN(&check, short_window_is_slower_but_never_faster);
    CHECK_RUN(&check, every_piece_can_be_braked);
    CHECK_RUN(&check, lone_corner_keeps_the_transfer_rule);
    CHECK_RUN(&check, sharp_corner_is_stopped_at_and_frees_the_acceleration);
    CHECK_RUN(&check, middle_between_two_corners_has_all_of_the_acceleration);
    return check_end(&check);
}
