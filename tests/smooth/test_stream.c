// SPDX-License-Identifier: MIT
// Room 3: one curve within P, window by window.
#include <math.h>   // hypot sqrt sin cos
#include <string.h> // memcmp memcpy memset

#include "check.h"
#include "nck/base/path.h"            // nck_path_point
#include "nck/prep/3_smooth/stream.h" // nck_stream_…

enum { WIDE = 20, SEGS = 400, PIECES = 4000, PER_PIECE = 16 };

static nck_stream_t stream;
static nck_stream_wish_t wish;
static nck_seg_t seg[SEGS];
static int segs;
static double places[SEGS + 1]; // where each begins
static nck_stream_piece_t piece[PIECES], other[PIECES];
static int pieces;
static uint32_t state;

static double any(void)
{
    state = state * 1664525u + 1013904223u;
    return (double)(state >> 8) / 8388608.0 - 1.0;
}

static void begin(void)
{
    memset(&wish, 0, sizeof wish);
    wish.terms.axes = 2;
    wish.terms.tau = 0.004;
    for (int x = 0; x < NCK_AXIS_MAX; x++) {
        wish.terms.v[x] = 100.0;
        wish.terms.a[x] = 1000.0;
        wish.terms.j[x] = wish.terms.smooth[x] = 10000.0;
    }
    wish.terms.a_least = 1000.0;
    wish.terms.j_least = wish.terms.smooth_least = 10000.0;
    wish.terms.longest = 6.0;
    wish.terms.v_most = 100.0;
    wish.rounds = 3;
    wish.gap = 0.1;
    wish.most = 10;
    segs = 0;
    state = 1;
}

// A seg from the last one's end.
static nck_seg_t *add(double x, double y)
{
    nck_seg_t *const next = &seg[segs];
    memset(next, 0, sizeof *next);
    if (segs > 0) memcpy(next->start, seg[segs - 1].end, sizeof next->start);
    next->end[0] = x;
    next->end[1] = y;
    next->length = hypot(x - next->start[0], y - next->start[1]);
    next->feed = 100.0;
    next->line = next->block = (uint32_t)segs + 1;
    places[segs + 1] = places[segs] + next->length;
    segs++;
    return next;
}

// A quarter of a circle to the left or right of the way along X, or back to it.
static void quarter(double x, double y, double radius, double turn, int from_x)
{
    nck_seg_t *const arc = add(x, y);
    arc->kind = NCK_SEG_ARC;
    arc->shape.arc.axis_v = 1;
    arc->shape.arc.sweep = turn * 2.0 * atan(1.0);
    arc->shape.arc.centre_u = arc->start[0] + (from_x ? 0.0 : radius);
    arc->shape.arc.centre_v = arc->start[1] + (from_x ? turn * radius : 0.0);
    arc->length = radius * 2.0 * atan(1.0);
    places[segs] = places[segs - 1] + arc->length;
}

static nck_status_t run(double tolerance)
{
    int next = 0;
    pieces = 0;
    nck_stream_begin(&stream, &wish);
    for (;;) {
        const nck_status_t status = nck_stream_step(&stream);
        if (status == NCK_DONE || status < 0 || pieces == PIECES) return status;
        if (status == NCK_FULL) nck_stream_take(&stream, &piece[pieces++]);
        if (status != NCK_EMPTY) continue;
        if (next == segs) nck_stream_close(&stream);
        else if (nck_stream_push(&stream, &seg[next++], tolerance) != NCK_OK) return NCK_E_STATE;
    }
}

static void curve_point(const nck_stream_piece_t *of, double w, double *point)
{
    const double m = 1.0 - w;
    const double weight[4] = {m * m * m / 6.0, (3.0 * w * w * w - 6.0 * w * w + 4.0) / 6.0,
                              (3.0 * m * m * m - 6.0 * m * m + 4.0) / 6.0, w * w * w / 6.0};
    for (int x = 0; x < 2; x++) {
        point[x] = 0.0;
        for (int p = 0; p < 4; p++) point[x] += weight[p] * of->point[p][x];
    }
}

// The program at s.
static void program_point(double s, double *point)
{
    double all[NCK_AXIS_MAX];
    int k = 0;
    while (k + 1 < segs && s > places[k + 1]) k++;
    nck_path_point(&seg[k], s - places[k], all);
    memcpy(point, all, 2 * sizeof *point);
}

// From a point to the nearest of a line.
static double distance(const double *at, const double *from, const double *to)
{
    const double u = to[0] - from[0], v = to[1] - from[1], square = u * u + v * v;
    double f = square > 0.0 ? ((at[0] - from[0]) * u + (at[1] - from[1]) * v) / square : 0.0;
    f = f < 0.0 ? 0.0 : f > 1.0 ? 1.0 : f;
    return hypot(at[0] - from[0] - f * u, at[1] - from[1] - f * v);
}

// The most that the curve is off the program, by the nearest of many points of it near the same s.
static double worst_off(void)
{
    double worst = 0.0;
    for (int i = 0; i < pieces; i++) {
        for (int k = 0; k < PER_PIECE; k++) {
            double at[2], from[2], to[2], best = 1e9;
            curve_point(&piece[i], (k + 0.5) / (double)PER_PIECE, at);
            const double way = (piece[i].s[1] - piece[i].s[0]) / 40.0;
            program_point(piece[i].s[0] - 21.0 * way, from);
            for (int n = -20; n <= 60; n++) {
                program_point(piece[i].s[0] + way * n, to);
                const double off = distance(at, from, to);
                best = off < best ? off : best;
                memcpy(from, to, sizeof from);
            }
            worst = best > worst ? best : worst;
        }
    }
    return worst;
}

static void zigzag(void)
{
    begin();
    for (int k = 1; k <= 10; k++) add(0.8 * k, k % 2 ? 0.8 : 0.0);
}

static void dense_wave(void)
{
    begin();
    for (int k = 1; k < SEGS; k++) {
        add(0.05 * k, sin(0.05 * k) + 0.001 * any());
    }
}

static void lines_and_arcs(void)
{
    begin();
    add(3.0, 0.0);
    quarter(4.0, 1.0, 1.0, 1.0, 1);
    add(4.0, 3.0);
    quarter(5.0, 4.0, 1.0, -1.0, 0);
    add(8.0, 4.0);
}

static void (*const programs[])(void) = {zigzag, dense_wave, lines_and_arcs};
static const double tolerances[] = {0.002, 0.01, 0.05};

static void the_curve_is_within_the_tolerance_everywhere(check_t *check)
{
    for (int k = 0; k < 9; k++) {
        programs[k / 3]();
        const double tolerance = tolerances[k % 3];
        CHECK_INT(check, run(tolerance), NCK_DONE);
        CHECK_INT(check, stream.told.missed, 0);
        CHECK(check, stream.told.most <= 1.0);
        const double off = worst_off();
        if (!CHECK(check, off <= tolerance)) printf("    %d: %g of %g\n", k, off, tolerance);
        CHECK(check, off > 0.01 * tolerance); // it makes use of it
    }
}

// Far wider than an interval's jerk can go: the rows hold next to nothing, in any precision.
static void a_wide_tolerance_has_a_curve_too(check_t *check)
{
    for (uint32_t k = 0; k < WIDE; k++) {
        begin();
        state = 77u + k;
        const double tolerance = 0.2 * (double)(1u << k % 4u) * (1.5 + any());
        const nck_num jerk = NCK_NUM_OF(2000.0) * (nck_num)(1u << k % 5u);
        for (int x = 0; x < NCK_AXIS_MAX; x++) wish.terms.j[x] = wish.terms.smooth[x] = jerk;
        wish.terms.j_least = wish.terms.smooth_least = jerk;
        for (int n = 0; n < 8; n++) add(12.0 * any(), 12.0 * any());
        CHECK_INT(check, run(tolerance), NCK_DONE);
        CHECK_INT(check, stream.told.missed, 0);
        const double off = worst_off();
        if (!CHECK(check, off <= tolerance)) printf("    %u: %g of %g\n", k, off, tolerance);
    }
}

static void pieces_are_one_curve_from_rest_to_rest(check_t *check)
{
    for (int k = 0; k < 3; k++) {
        programs[k]();
        run(0.01);
        CHECK_INT(check, piece[0].rests, 1);
        CHECK_INT(check, piece[pieces - 1].rests, 2);
        for (int x = 0; x < 2; x++) {
            for (int p = 0; p < 3; p++) {
                CHECK_NEAR(check, piece[0].point[p][x], 0.0, 0.0);
                const double end = piece[pieces - 1].point[p + 1][x];
                CHECK_NEAR(check, end, seg[segs - 1].end[x], 0.0);
            }
        }
        for (int i = 1; i < pieces; i++) {
            CHECK_INT(check, piece[i].rests, i + 1 == pieces ? 2 : 0);
            CHECK_NEAR(check, piece[i].s[0], piece[i - 1].s[1], 0.0);
            CHECK(check, memcmp(piece[i].point, piece[i - 1].point[1], 3 * sizeof piece->point[0])
                             == 0);
        }
        CHECK_NEAR(check, piece[pieces - 1].s[1], places[segs], 1e-9);
    }
}

static void every_piece_tells_the_line_it_begins_in(check_t *check)
{
    for (int k = 0; k < 3; k++) {
        programs[k]();
        run(0.01);
        for (int i = 0; i < pieces; i++) {
            CHECK(check, piece[i].s[1] > piece[i].s[0]);
            CHECK(check, places[piece[i].line - 1] <= piece[i].s[0] + 1e-9);
        }
    }
}

static void the_same_program_gives_the_same_bits(check_t *check)
{
    dense_wave();
    run(0.01);
    const int count = pieces;
    memcpy(other, piece, sizeof piece);
    memset(&stream, 0x55, sizeof stream); // whatever was there before
    run(0.01);
    CHECK_INT(check, pieces, count);
    for (int i = 0; i < count; i++) {
        CHECK(check, memcmp(piece[i].point, other[i].point, sizeof piece->point) == 0);
        CHECK(check, memcmp(piece[i].s, other[i].s, sizeof piece->s) == 0);
    }
}

static void a_run_without_length_gives_nothing(check_t *check)
{
    begin();
    CHECK_INT(check, run(0.01), NCK_DONE);
    CHECK_INT(check, pieces, 0);
}

static void the_shortest_run_is_a_curve_too(check_t *check)
{
    static const double lengths[] = {1e-5, 1e-3, 0.1};
    for (int k = 0; k < 3; k++) {
        begin();
        add(lengths[k], 0.0);
        CHECK_INT(check, run(0.01), NCK_DONE);
        CHECK(check, pieces >= 7);
        CHECK_NEAR(check, piece[pieces - 1].point[3][0], lengths[k], 0.0);
    }
}

int main(void)
{
    check_t check = {0};
    CHECK_RUN(&check, the_curve_is_within_the_tolerance_everywhere);
    CHECK_RUN(&check, a_wide_tolerance_has_a_curve_too);
    CHECK_RUN(&check, pieces_are_one_curve_from_rest_to_rest);
    CHECK_RUN(&check, every_piece_tells_the_line_it_begins_in);
    CHECK_RUN(&check, the_same_program_gives_the_same_bits);
    CHECK_RUN(&check, a_run_without_length_gives_nothing);
    CHECK_RUN(&check, the_shortest_run_is_a_curve_too);
    return check_end(&check);
}
