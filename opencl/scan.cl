// SPDX-License-Identifier: MIT
// The bubble's grades at once: one scan backward and one forward, exact on all data.
#include "lanes_math.h"       // lanes_t lanes_transpose (of the float folder)
#include "host/bubble_math.h" // nck_bubble_behind nck_bubble_grade nck_bubble_scan
#include "host/chunk_math.h"  // nck_chunk_begin nck_chunk_lane

// Beyond the ends nothing limits. Grades lie in 0 … NO_LIMIT − 1.
enum { NO_LIMIT = 0x3fffffff };

// A cache line of grades; the points of the smallest tile, which no part goes below.
enum { LINE = 64 / sizeof(int), PART_MIN = LANES * LINE };

typedef int lane_grades_t __attribute__((ext_vector_type(8)));
typedef lane_grades_t __attribute__((aligned(4))) packed_grades_t;

// nck_bubble_scan for lanes.
static inline lane_grades_t scan_lanes(lane_grades_t p, lane_grades_t neighbour) {
    return neighbour + 1 < p ? neighbour + 1 : p;
}

// Next to LANES points of every lane; lanes lie length points apart. A transposition moves bits
// and computes nothing, so grades may pass as floats.
static inline void load_lanes(__global const int *g, long length, lanes_t *row) {
    for (int lane = 0; lane < LANES; lane++) {
        row[lane] = as_float8(*(__global const packed_grades_t *)(g + lane * length));
    }
    lanes_transpose(row);
}

static inline void store_lanes(__global int *g, long length, lanes_t *row) {
    lanes_transpose(row);
    for (int lane = 0; lane < LANES; lane++) {
        *(__global packed_grades_t *)(g + lane * length) = as_int8(row[lane]);
    }
}

static lane_grades_t lanes_of_grades(const int *x) {
    return (lane_grades_t)(x[0], x[1], x[2], x[3], x[4], x[5], x[6], x[7]);
}

// Bring count points into the cache, in order: memory serves that faster than many lanes in turn.
static void touch(__global const int *g, long count) {
    for (long i = 0; i < count; i += LINE) (void)*(volatile __global const int *)(g + i);
}

// The grades of LANES · length points from point first on.
static void scan_tile(__global const int *p, long n, long first, long length, __global int *g) {
    int behind[LANES];
    int before[LANES];
    touch(p + first, LANES * length);
    touch(g + first, LANES * length);
    for (int lane = 0; lane < LANES; lane++) {
        const long begin = first + lane * length;
        behind[lane] = begin + length < n ? nck_bubble_behind(p, begin + length, n) : NO_LIMIT;
        before[lane] = begin > 0 ? nck_bubble_grade(p, begin - 1, n) : NO_LIMIT;
    }
    lanes_t row[LANES];
    lane_grades_t state = lanes_of_grades(behind);
    for (long i = length - LANES; i >= 0; i -= LANES) {
        load_lanes(p + first + i, length, row);
        for (int k = LANES - 1; k >= 0; k--) {
            state = scan_lanes(as_int8(row[k]), state);
            row[k] = as_float8(state);
        }
        store_lanes(g + first + i, length, row);
    }
    state = lanes_of_grades(before);
    for (long i = 0; i < length; i += LANES) {
        load_lanes(g + first + i, length, row);
        for (int k = 0; k < LANES; k++) {
            state = scan_lanes(as_int8(row[k]), state);
            row[k] = as_float8(state);
        }
        store_lanes(g + first + i, length, row);
    }
}

// Few points, one after the other.
static void scan_points(__global const int *p, long n, __global int *g) {
    int state = NO_LIMIT;
    for (long i = n; i-- > 0;) g[i] = state = nck_bubble_scan(p[i], state);
    for (long i = 0; i < n; i++) g[i] = state = nck_bubble_scan(g[i], i > 0 ? state : NO_LIMIT);
}

// One work-item: one contiguous part of the points, tile after tile. Global size: the number of
// parts. Local size: 1. Reads p (n), writes g (n). Must equal nck_host_bubble_scan.
__kernel __attribute__((reqd_work_group_size(1, 1, 1)))
void scan(__global const int *p, long n, __global int *g) {
    const long part = get_global_id(0);
    const long parts = get_global_size(0);
    if (n < parts * PART_MIN) {
        if (part == 0) scan_points(p, n, g);
        return;
    }
    const long begin = nck_chunk_begin(n, part, parts);
    const long end = nck_chunk_begin(n, part + 1, parts);
    const long length = nck_chunk_lane(end - begin, LANES, LINE);
    const long tile = LANES * length;
    long first = begin;
    for (; length > 0 && end - first >= tile; first += tile) scan_tile(p, n, first, length, g);
    const long rest = (end - first + LANES * LANES - 1) / (LANES * LANES) * LANES;
    if (rest > 0) scan_tile(p, n, end - LANES * rest, rest, g);
}
