// SPDX-License-Identifier: MIT
// The certificate of the parts of an envelope, and the cutting into parts, tiles and lanes.
#include "check.h"
#include "host/bubble_math.h"
#include "host/chunk_math.h"

enum { NODES = 6000 };

typedef struct path {
    double vv_cap[NODES], h[NODES], vv_backward[NODES], vv[NODES];
} path_t;

static uint32_t next_random(uint32_t *state) {
    *state = *state * 1664525u + 1013904223u;
    return *state >> 8;
}

// Caps up to 100 and now and then a low one; pieces of about h.
static void fill(path_t *path, double h) {
    uint32_t state = 7;
    for (int i = 0; i < NODES; i++) {
        const double share = (double)next_random(&state) / 16777216.0;
        path->vv_cap[i] = next_random(&state) % 50 == 0 ? share : 50.0 + 50.0 * share;
        path->h[i] = h * (0.5 + share);
    }
    nck_chunk_whole(path->vv_cap, path->h, NODES, 3.0, 2.0, path->vv);
    double vv = nck_min(path->vv_cap[NODES - 1], 2.0);
    path->vv_backward[NODES - 1] = vv;
    for (int i = NODES - 1; i-- > 0;) {
        vv = nck_envelope_backward(path->vv_cap[i], vv, path->h[i]);
        path->vv_backward[i] = vv;
    }
}

static int is_same(double a, double b) { return !(a < b) && !(a > b); }

static void what_is_certain_has_the_bits_of_the_whole_path(check_t *check) {
    static path_t path;
    static double scratch[NCK_CHUNK_OVERLAP_MAX + 1];
    fill(&path, 1.0);
    for (int p = 0; p < NODES; p += 7) {
        double vv = -1.0;
        CHECK(check, nck_chunk_behind(path.vv_cap, path.h, p, NODES - 1,
                                      path.vv_backward[NODES - 1], &vv));
        CHECK(check, is_same(vv, path.vv_backward[p]));
        CHECK(check, nck_chunk_before(path.vv_backward, path.h, 0, p, path.vv[0], &vv));
        CHECK(check, is_same(vv, path.vv[p]));
        if (p + 1 == NODES) continue;
        vv = path.vv_backward[p + 1];
        CHECK(check, nck_chunk_enter(path.vv_cap, path.h, p, 3.0, scratch, &vv));
        CHECK(check, is_same(vv, path.vv[p]));
    }
}

static void doubt_is_told_where_pieces_are_too_short(check_t *check) {
    static path_t path;
    static double scratch[NCK_CHUNK_OVERLAP_MAX + 1];
    volatile nck_int64 middle = NODES / 2; // gcc 12 warns of loops that it would never enter
    const nck_int64 p = middle;
    fill(&path, 1e-4);
    for (int i = 0; i < NODES; i++) path.vv_cap[i] = 1e6;
    double vv = 1e5;
    CHECK(check, !nck_chunk_behind(path.vv_cap, path.h, p, NODES - 1, 2.0, &vv));
    vv = 1e5;
    CHECK(check, !nck_chunk_enter(path.vv_cap, path.h, p, 3.0, scratch, &vv));
    CHECK(check, !nck_chunk_before(path.vv_cap, path.h, 0, p, 3.0, &vv));
}

static void parts_cover_the_path_once(check_t *check) {
    for (nck_int64 count = 1; count < 40; count++) {
        for (nck_int64 n = count; n < 5000; n += 37) {
            CHECK_INT(check, nck_chunk_begin(n, 0, count), 0);
            CHECK_INT(check, nck_chunk_begin(n, count, count), n);
            for (nck_int64 k = 0; k < count; k++) {
                const nck_int64 begin = nck_chunk_begin(n, k, count);
                const nck_int64 length = nck_chunk_begin(n, k + 1, count) - begin;
                CHECK(check, length >= n / count && length <= n / count + 1);
            }
        }
    }
}

static void lanes_are_odd_lines_that_fit(check_t *check) {
    for (nck_int64 n = 1; n < 100000; n += 11) {
        const nck_int64 lane = nck_chunk_lane(n, 8, 16);
        CHECK(check, lane % 16 == 0 && 8 * lane <= n);
        CHECK(check, n < 8 * 16 ? lane == 0 : lane / 16 % 2 == 1);
    }
}

static void a_grade_alone_is_that_of_both_scans(check_t *check) {
    static int p[NODES], behind[NODES], g[NODES];
    uint32_t state = 3;
    for (int i = 0; i < NODES; i++) {
        p[i] = next_random(&state) % 30 == 0 ? (int)(next_random(&state) % 60) : 300;
    }
    for (int i = NODES; i-- > 0;) {
        behind[i] = i + 1 < NODES ? nck_bubble_scan(p[i], behind[i + 1]) : p[i];
    }
    for (int i = 0; i < NODES; i++) {
        g[i] = i > 0 ? nck_bubble_scan(behind[i], g[i - 1]) : behind[i];
        CHECK_INT(check, nck_bubble_behind(p, i, NODES), behind[i]);
        CHECK_INT(check, nck_bubble_grade(p, i, NODES), g[i]);
    }
}

int main(void) {
    check_t check = {0};
    CHECK_RUN(&check, what_is_certain_has_the_bits_of_the_whole_path);
    CHECK_RUN(&check, doubt_is_told_where_pieces_are_too_short);
    CHECK_RUN(&check, parts_cover_the_path_once);
    CHECK_RUN(&check, lanes_are_odd_lines_that_fit);
    CHECK_RUN(&check, a_grade_alone_is_that_of_both_scans);
    return check_end(&check);
}
