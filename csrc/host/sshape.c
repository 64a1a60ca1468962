// SPDX-License-Identifier: MIT
// Serial look-ahead over N segments, and the cells of every segment.
//
// With an S-shape a ramp to a speed in the middle may need more length than one to zero: its length
// (v0 + v1)/2 · duration(v0 − v1) rises with v1 near 0 before it falls. So "can still be braked"
// asks for the better of the two, and the good speeds at a junction stay an interval from 0.
#include "host/sshape.h"

#include <float.h>  // DBL_MAX
#include <string.h> // memset

#include "nck/prep/5_slope/ramp_math.h"   // nck_ramp_length nck_ramp_peak
#include "nck/prep/5_slope/sshape_math.h" // nck_sshape_…

enum { HALVINGS = 60 }; // a double has 53 bits

// A part of a segment shorter than this share of it is rounding.
#define LENGTH_EPSILON 1e-12

// What the ramps of one segment go by.
typedef struct segment {
    double length, v_cap, a, j, ramp_s;
    uint32_t kind;
    uint32_t index;
} segment_t;

static segment_t segment_of(const nck_host_path_t *path, size_t i) {
    const double j = path->kind == NCK_HOST_RAMP_SSHAPE ? path->j_max[i] : 0.0;
    return (segment_t){path->length[i], path->v_cap[i], path->a_max[i], j,
                       path->ramp_s,    path->kind,     (uint32_t)i};
}

static int is_positive(double x) { return x > 0.0 && x <= DBL_MAX; }

static int is_cap(double x) { return x >= 0.0 && x <= DBL_MAX; }

static int segment_is_good(const nck_host_path_t *path, size_t i) {
    const int jerk = path->kind != NCK_HOST_RAMP_SSHAPE || is_positive(path->j_max[i]);
    return is_positive(path->length[i]) && is_positive(path->v_cap[i]) &&
           is_positive(path->a_max[i]) && jerk && is_cap(path->v_node[i]);
}

// Index of the first bad number, n + 1 if all are good.
static size_t first_bad(const nck_host_path_t *path) {
    const int fixed = path->kind == NCK_HOST_RAMP_FIXED;
    if (path->kind > NCK_HOST_RAMP_FIXED) return path->n;
    if (fixed && (path->lookahead > 0 || !is_positive(path->ramp_s))) return path->n;
    for (size_t i = 0; i < path->n; i++) {
        if (!segment_is_good(path, i)) return i;
    }
    return path->n > 0 && is_cap(path->v_node[path->n]) ? path->n + 1 : path->n;
}

// Length of a ramp between two speeds.
static double ramp_length(const segment_t *seg, double v0, double v1) {
    if (v0 == v1) return 0.0;
    if (seg->kind == NCK_HOST_RAMP_LINEAR) return nck_ramp_length(v0 * v0, v1 * v1, seg->a);
    if (seg->kind == NCK_HOST_RAMP_FIXED) return 0.5 * (v0 + v1) * seg->ramp_s;
    return nck_sshape_length(v0, v1, seg->a, seg->j);
}

// Largest speed that a ramp over the whole segment joins with v, either way.
static double reach(const segment_t *seg, double v) {
    if (seg->kind == NCK_HOST_RAMP_LINEAR) return nck_sqrt(v * v + 2.0 * seg->a * seg->length);
    if (seg->kind == NCK_HOST_RAMP_SSHAPE) return nck_sshape_reach(v, seg->length, seg->a, seg->j);
    return nck_sshape_whole_reach(v, seg->length, seg->a);
}

// Largest speed at a segment's start from which some speed in [0, v_end] is met at its end.
static double brakeable(const segment_t *seg, double v_end) {
    return nck_max(reach(seg, v_end), reach(seg, 0.0));
}

// The cap at a junction: its own, and those of the segments on both sides.
static double cap_at(const nck_host_path_t *path, size_t node) {
    double cap = path->v_node[node];
    if (node > 0) cap = nck_min(cap, path->v_cap[node - 1]);
    if (node < path->n) cap = nck_min(cap, path->v_cap[node]);
    return cap;
}

// The largest speed at a node from which everything up to the horizon can be braked for.
static double look_ahead(const nck_host_path_t *path, size_t node) {
    const size_t left = path->n - node;
    const int sees_end = left <= path->lookahead;
    const size_t horizon = sees_end ? path->n : node + path->lookahead;
    double v = sees_end ? cap_at(path, path->n) : 0.0;
    for (size_t k = horizon; k-- > node;) {
        const segment_t seg = segment_of(path, k);
        v = nck_min(cap_at(path, k), brakeable(&seg, v));
    }
    return v;
}

// All of it at once where the look-ahead sees the whole path: one backward pass into v.
static void look_ahead_whole(const nck_host_path_t *path, double *v) {
    v[path->n] = cap_at(path, path->n);
    for (size_t k = path->n; k-- > 0;) {
        const segment_t seg = segment_of(path, k);
        v[k] = nck_min(cap_at(path, k), brakeable(&seg, v[k + 1]));
    }
}

// The largest end speed, v_most at most, that a segment entered at v reaches. Some speed below
// v_most is reached, because v was looked ahead for.
static double end_speed(const segment_t *seg, double v, double v_most) {
    if (seg->kind == NCK_HOST_RAMP_FIXED) return 0.0;
    if (v_most >= v) return nck_min(v_most, reach(seg, v));
    if (seg->kind != NCK_HOST_RAMP_SSHAPE) return v_most;
    if (v <= reach(seg, v_most)) return v_most;
    double low = 0.0;
    double high = v_most;
    for (int k = 0; k < HALVINGS; k++) {
        const double middle = 0.5 * (low + high);
        if (ramp_length(seg, v, middle) <= seg->length) {
            low = middle;
        } else {
            high = middle;
        }
    }
    return low;
}

// Peak of the fastest profile of a segment from v0 to v1; at least the larger of the two.
static double peak_speed(const segment_t *seg, double v0, double v1) {
    if (seg->kind == NCK_HOST_RAMP_LINEAR) {
        const double cap = seg->v_cap * seg->v_cap;
        return nck_sqrt(nck_ramp_peak(seg->length, v0 * v0, v1 * v1, seg->a, cap));
    }
    double low = nck_max(v0, v1);
    double high = seg->v_cap;
    if (seg->kind == NCK_HOST_RAMP_FIXED) high = nck_min(high, 0.5 * seg->a * seg->ramp_s);
    if (ramp_length(seg, v0, high) + ramp_length(seg, high, v1) <= seg->length) return high;
    for (int k = 0; k < HALVINGS; k++) {
        const double middle = 0.5 * (low + high);
        if (ramp_length(seg, v0, middle) + ramp_length(seg, middle, v1) <= seg->length) {
            low = middle;
        } else {
            high = middle;
        }
    }
    return low;
}

// Cells under construction: where the next one begins.
typedef struct pen {
    nck_cell_t *cells;
    size_t count;
    uint32_t seg;
    double s, v;
} pen_t;

// A cell of constant jerk from where the pen stands.
static void draw(pen_t *pen, double duration, double a, double j) {
    if (!(duration > 0.0)) return;
    nck_cell_t *cell = &pen->cells[pen->count];
    memset(cell, 0, sizeof *cell);
    cell->seg = pen->seg;
    cell->s = pen->s;
    cell->v = pen->v;
    cell->a = a;
    cell->j = j;
    cell->duration = duration;
    cell->length = duration * (pen->v + duration * (a / 2.0 + duration * j / 6.0));
    pen->s += cell->length;
    pen->v += duration * (a + duration * j / 2.0);
    pen->count++;
}

// An S from the pen's speed to v: jerk up, acceleration constant for `hold`, jerk down.
static void draw_s(pen_t *pen, double v, double rise, double hold, double j) {
    const double sign = v > pen->v ? 1.0 : -1.0;
    draw(pen, rise, 0.0, sign * j);
    draw(pen, hold, sign * j * rise, 0.0);
    draw(pen, rise, sign * j * rise, -sign * j);
    pen->v = v;
}

// A triangle of acceleration that lasts a given time.
static void draw_triangle(pen_t *pen, double v, double duration) {
    const double dv = nck_fabs(v - pen->v);
    draw_s(pen, v, 0.5 * duration, 0.0, nck_sshape_jerk(dv, duration));
}

// A ramp from the pen's speed to v, its time stretched by a factor near 1.
static void draw_ramp(pen_t *pen, const segment_t *seg, double v, double stretch) {
    const double dv = nck_fabs(v - pen->v);
    if (dv == 0.0) return;
    if (seg->kind == NCK_HOST_RAMP_LINEAR) {
        const double duration = stretch * dv / seg->a;
        draw(pen, duration, (v - pen->v) / duration, 0.0);
        pen->v = v;
        return;
    }
    if (seg->kind == NCK_HOST_RAMP_FIXED) {
        draw_triangle(pen, v, stretch * seg->ramp_s);
        return;
    }
    const double rise = nck_sshape_peak(dv, seg->a, seg->j) / seg->j;
    const double hold = nck_sshape_duration(dv, seg->a, seg->j) - 2.0 * rise;
    const double j = seg->j / (stretch * stretch);
    draw_s(pen, v, stretch * rise, hold > LENGTH_EPSILON * rise ? stretch * hold : 0.0, j);
}

// One S over the whole segment; from rest to rest one over each half.
static void draw_whole(pen_t *pen, const segment_t *seg, double v1) {
    const double v0 = pen->v;
    if (v0 + v1 > 0.0) {
        const double duration = 2.0 * seg->length / (v0 + v1);
        if (v0 == v1) {
            draw(pen, duration, 0.0, 0.0);
        } else {
            draw_triangle(pen, v1, duration);
        }
        return;
    }
    const double half = 0.5 * seg->length;
    const double peak = nck_min(seg->v_cap, nck_sshape_whole_reach(0.0, half, seg->a));
    draw_triangle(pen, peak, 2.0 * half / peak);
    draw_triangle(pen, 0.0, 2.0 * half / peak);
}

// The cells of one segment: up, cruise, down.
static void draw_segment(pen_t *pen, const segment_t *seg, double v1) {
    pen->seg = seg->index;
    pen->s = 0.0;
    if (seg->kind == NCK_HOST_RAMP_WHOLE) {
        draw_whole(pen, seg, v1);
    } else {
        const double peak = peak_speed(seg, pen->v, v1);
        const double ramps = ramp_length(seg, pen->v, peak) + ramp_length(seg, peak, v1);
        const double cruise = seg->length - ramps;
        const int cruises = cruise > LENGTH_EPSILON * seg->length;
        const double stretch = cruises ? 1.0 : seg->length / ramps; // 1 but for rounding
        draw_ramp(pen, seg, peak, stretch);
        if (cruises) draw(pen, cruise / peak, 0.0, 0.0);
        draw_ramp(pen, seg, v1, stretch);
    }
    pen->cells[pen->count - 1].last = 1;
    pen->cells[pen->count - 1].stop = v1 == 0.0;
    pen->v = v1;
}

nck_status_t nck_host_slope(const nck_host_path_t *path, double *v_out, nck_cell_t *cells_out,
                            size_t *cell_count_out, size_t *bad_out) {
    *cell_count_out = 0;
    *bad_out = first_bad(path);
    if (*bad_out <= path->n) return NCK_E_ARGUMENT;
    const int whole = path->lookahead >= path->n;
    if (whole) look_ahead_whole(path, v_out);
    v_out[0] = path->kind == NCK_HOST_RAMP_FIXED ? 0.0
               : whole                           ? v_out[0]
                                                 : look_ahead(path, 0);
    pen_t pen = {cells_out, 0, 0, 0.0, v_out[0]};
    for (size_t i = 0; i < path->n; i++) {
        const segment_t seg = segment_of(path, i);
        const double most = whole ? v_out[i + 1] : look_ahead(path, i + 1);
        v_out[i + 1] = end_speed(&seg, v_out[i], most);
        draw_segment(&pen, &seg, v_out[i + 1]);
    }
    *cell_count_out = pen.count;
    return NCK_OK;
}

void nck_host_slope_sample(const nck_cell_t *cells, size_t count, double period_s, size_t rows,
                           double *s_out, double *v_out, double *a_out) {
    size_t k = 0;
    double t_begin = 0.0;
    double s_begin = 0.0;
    for (size_t row = 0; row < rows; row++) {
        const double t = (double)row * period_s;
        while (k < count && t - t_begin >= cells[k].duration) {
            t_begin += cells[k].duration;
            s_begin += cells[k].length;
            k++;
        }
        const nck_cell_t at_end = {0};
        const nck_cell_t *cell = k < count ? &cells[k] : &at_end;
        const double u = k < count ? t - t_begin : 0.0;
        s_out[row] = s_begin + u * (cell->v + u * (cell->a / 2.0 + u * cell->j / 6.0));
        v_out[row] = cell->v + u * (cell->a + u * cell->j / 2.0);
        a_out[row] = cell->a + u * cell->j;
    }
}
