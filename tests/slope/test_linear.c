// SPDX-License-Identifier: MIT
// The linear slope over room 4's pieces: its envelope is the whole path's, to the bit.
#include <math.h>   // sqrt fabs
#include <string.h> // memset

#include "check.h"
#include "nck/base/envelope_math.h"             // nck_envelope_…
#include "nck/prep/4_lookahead/lookahead.h" // nck_lookahead_t
#include "nck/prep/5_slope/slope.h"         // nck_slope_t
#include "terms_check.h" // terms_of

enum { SEGS = 6000, NODES = 3 * SEGS };

static nck_machine_t machine;
static nck_lookahead_t lookahead;
static nck_link_t link;
static nck_slope_t slope;
static double end_of_cells; // v where the last cell ends
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

// Pieces that the slope needs no longer.
static void drop_pieces(void)
{
    const uint32_t count = nck_slope_needs(&slope) - lookahead.window.head;
    for (uint32_t i = 0; i < count; i++) {
        nodes[node_count] = *nck_lookahead_ahead(&lookahead, i);
        open_count += nodes[node_count].open;
        node_count++;
    }
    if (count > 0) nck_lookahead_drop(&lookahead, count);
}

static nck_status_t step_slope(void)
{
    const nck_pieces_t pieces = {lookahead.window.at, lookahead.window.head, lookahead.window.fill,
                                 lookahead.window.barrier,
                                 (uint32_t)nck_lookahead_is_complete(&lookahead)};
    const nck_wish_t wish = {1.0, 1.0, NCK_WISH_FREE, 0, 0, 0};
    const nck_status_t status = nck_slope_step(&slope, &pieces, &wish);
    drop_pieces();
    return status;
}

// Every final cell, as the tick would take them. Returns how many.
static int take_cells(check_t *check)
{
    int count = 0;
    for (; nck_link_waiting(&link) > 0; count++) {
        nck_cell_t cell;
        int from_tail = 0;
        CHECK_INT(check, nck_link_take(&link, &cell, &from_tail), NCK_OK);
        CHECK_NEAR(check, cell.v, end_of_cells, 1e-6);
        end_of_cells = cell.stop ? 0.0 : cell.v + cell.a * cell.duration;
    }
    return count;
}

// Work until room 4 wants segs (1) or all is done (0).
static int work(check_t *check)
{
    for (;;) {
        const nck_status_t slope_says = step_slope();
        if (slope_says == NCK_OK || take_cells(check) > 0) continue;
        const nck_status_t status = nck_lookahead_step(&lookahead);
        if (status == NCK_OK) continue;
        CHECK(check, nck_lookahead_invariants(&lookahead));
        if (status == NCK_EMPTY) return 1;
        if (status == NCK_DONE && nck_lookahead_fill(&lookahead) == 0) return 0;
    }
}

static void begin(uint64_t first_seed)
{
    nck_machine_default(&machine);
    machine.slope = NCK_SLOPE_LINEAR;
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
    nck_lookahead_init(&lookahead, terms_of(&machine));
    nck_link_init(&link);
    nck_slope_init(&slope, terms_of(&machine), &link);
    end_of_cells = 0.0;
    for (int k = 0; k < count; k++) {
        const double l = length * (0.1 + random_real());
        angle += turn * (random_real() - 0.5);
        seg = line_from(&seg, l * cos(angle), l * sin(angle), 5.0 + 95.0 * random_real());
        while (nck_lookahead_push(&lookahead, &seg) != NCK_OK) work(check);
        link.seg[seg.seq & (NCK_SEG_MAX - 1)].block = seg.seq; // a block is a seg
    }
    nck_lookahead_end(&lookahead);
    while (work(check)) { }
}

// The exact two passes over all nodes at once.
static void envelope(void)
{
    double vv = 0.0;
    for (uint32_t i = node_count; i-- > 0;) {
        const double h = nck_envelope_h(nodes[i].a, nodes[i].length);
        vv = nck_envelope_backward(nodes[i].vv_cap, vv, h);
        whole[i] = vv;
    }
    vv = 0.0;
    for (uint32_t i = 0; i < node_count; i++) {
        whole[i] = nck_envelope_forward(whole[i], vv, 0.0);
        vv = whole[i] + nck_envelope_h(nodes[i].a, nodes[i].length);
    }
}

static void window_gives_the_bits_of_the_whole_path(check_t *check)
{
    // Three fifths of the window, at three pieces a seg, must hold the longest braking distance:
    // 100²/2/500 = 10 mm. Segs are 0.6 of the mean long.
    const double length = 120.0 / NCK_WINDOW;
    const double turns[] = {0.0, 0.02, 0.3, 3.0};
    for (int k = 0; k < 4; k++) {
        begin(1 + (uint64_t)k);
        plan(check, SEGS / 2, length, turns[k]);
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

int main(void)
{
    check_t check = {0};
    CHECK_RUN(&check, window_gives_the_bits_of_the_whole_path);
    CHECK_RUN(&check, short_window_is_slower_but_never_faster);
    CHECK_RUN(&check, every_piece_can_be_braked);
    return check_end(&check);
}
