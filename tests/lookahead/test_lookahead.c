// SPDX-License-Identifier: MIT
// Room 4 alone, fed with segs: what corners leave to the pieces around them.
#include <math.h>   // sqrt fabs
#include <string.h> // memset

#include "check.h"
#include "nck/prep/4_lookahead/lookahead.h"     // nck_lookahead_t
#include "terms_check.h" // terms_of

enum { NODES = 64 };

static nck_machine_t machine;
static nck_lookahead_t lookahead;
static nck_node_t nodes[NODES + 1];
static uint32_t node_count;

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
    const uint32_t n = nck_lookahead_fill(&lookahead);
    for (uint32_t i = 0; i < n; i++) nodes[node_count + i] = *nck_lookahead_ahead(&lookahead, i);
    node_count += n;
    nck_lookahead_drop(&lookahead, n);
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

static void begin(void)
{
    nck_machine_default(&machine);
    machine.slope = NCK_SLOPE_LINEAR;
    node_count = 0;
}

static void lone_corner_keeps_the_transfer_rule(check_t *check)
{
    begin();
    nck_seg_t seg;
    memset(&seg, 0, sizeof seg);
    seg.seq = 0xffffffffu;
    nck_lookahead_init(&lookahead, terms_of(&machine));
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
    begin();
    nck_seg_t seg;
    memset(&seg, 0, sizeof seg);
    seg.seq = 0xffffffffu;
    nck_lookahead_init(&lookahead, terms_of(&machine));
    for (int k = 0; k < 2; k++) {
        seg = line_from(&seg, k ? 0.0 : 50.0, k ? 50.0 : 0.0, 100.0);
        nck_lookahead_push(&lookahead, &seg);
    }
    nck_lookahead_end(&lookahead);
    while (work(check)) { }
    CHECK_INT(check, node_count, 2);
    CHECK(check, nodes[1].vv_cap == 0.0 && nodes[0].a == 1000.0 && nodes[1].a == 1000.0);
    CHECK_INT(check, nodes[0].stop, 0);
}

// A corner that takes much, at one end, lets both ends be cut off: the middle has all.
static void middle_between_two_corners_has_all_of_the_acceleration(check_t *check)
{
    const double angle[] = {0.0, 0.004, 0.0042}; // shares of 0.4 and 0.02 at 100 mm/s
    begin();
    nck_seg_t seg;
    memset(&seg, 0, sizeof seg);
    seg.seq = 0xffffffffu;
    nck_lookahead_init(&lookahead, terms_of(&machine));
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
    CHECK_RUN(&check, lone_corner_keeps_the_transfer_rule);
    CHECK_RUN(&check, sharp_corner_is_stopped_at_and_frees_the_acceleration);
    CHECK_RUN(&check, middle_between_two_corners_has_all_of_the_acceleration);
    return check_end(&check);
}
