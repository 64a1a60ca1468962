// SPDX-License-Identifier: MIT
// Serial look-ahead over N segments, and the cells of every segment. The S-shape's rules are
// those of sshape_piece.h; the other ramps have closed forms.
#include "host/sshape.h"

#include <float.h> // DBL_MAX

#include "nck/prep/5_slope/ramp_math.h"    // nck_ramp_length nck_ramp_peak
#include "host/sshape_math.h"  // nck_sshape_whole_reach nck_sshape_jerk
#include "host/sshape_piece.h" // nck_sshape_plan nck_sshape_draw …

// What the ramps of one segment go by.
typedef struct segment {
    nck_sshape_piece_t of;
    double ramp_s;
    uint32_t kind;
    uint32_t index;
} segment_t;

static segment_t segment_of(const nck_host_path_t *path, size_t i) {
    const double j = path->kind == NCK_HOST_RAMP_SSHAPE ? path->j_max[i] : 0.0;
    return (segment_t){{path->length[i], path->v_cap[i], path->a_max[i], j},
                       path->ramp_s, path->kind, (uint32_t)i};
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

// Largest speed that a ramp over the whole segment joins with v, either way.
static double reach(const segment_t *seg, double v) {
    const double share = seg->kind == NCK_HOST_RAMP_LINEAR ? 2.0 : 1.0;
    return nck_sshape_whole_reach(v, share * seg->of.length, seg->of.a);
}

// Largest speed at a segment's start from which some speed in [0, v_end] is met at its end.
static double brakeable(const segment_t *seg, double v_end) {
    if (seg->kind == NCK_HOST_RAMP_SSHAPE) return nck_sshape_brakeable(&seg->of, v_end);
    return reach(seg, v_end);
}

// The cap at a junction: its own, and those of the segments on both sides.
static double cap_at(const nck_host_path_t *path, size_t node) {
    double cap = path->v_node[node];
    if (node > 0) cap = nck_min(cap, path->v_cap[node - 1]);
    if (node < path->n) cap = nck_min(cap, path->v_cap[node]);
    return cap;
}

// The junction that the look-ahead sees up to where the segment before `node` is in work; at the
// path's begin none is.
static size_t horizon_at(const nck_host_path_t *path, size_t node) {
    size_t k = node;
    if (!path->block) {
        return path->n - node <= path->lookahead ? path->n : node + path->lookahead;
    }
    const size_t last = path->block[node > 0 ? node - 1 : 0] + path->lookahead;
    while (k < path->n && path->block[k] <= last) k++;
    return k;
}

// The largest speed at a node from which everything up to the horizon can be braked for.
static double look_ahead(const nck_host_path_t *path, size_t node) {
    const size_t horizon = horizon_at(path, node);
    double v = horizon == path->n ? cap_at(path, path->n) : 0.0;
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
    if (seg->kind == NCK_HOST_RAMP_SSHAPE) return nck_sshape_fastest_end(&seg->of, v, v_most);
    return v_most >= v ? nck_min(v_most, reach(seg, v)) : v_most;
}

// A triangle of acceleration that lasts a given time.
static void draw_triangle(nck_sshape_pen_t *pen, double v, double duration) {
    const double dv = nck_fabs(v - pen->v);
    nck_sshape_draw_s(pen, v, 0.5 * duration, 0.0, nck_sshape_jerk(dv, duration));
}

// One S over the whole segment; from rest to rest one over each half.
static void draw_whole(nck_sshape_pen_t *pen, const segment_t *seg, double v1) {
    const double v0 = pen->v;
    if (v0 + v1 > 0.0) {
        const double duration = nck_ramp_duration(seg->of.length, v0, v1);
        if (v0 == v1) {
            nck_sshape_draw(pen, duration, 0.0, 0.0);
        } else {
            draw_triangle(pen, v1, duration);
        }
        return;
    }
    const double half = 0.5 * seg->of.length;
    const double peak = nck_min(seg->of.v_cap, nck_sshape_whole_reach(0.0, half, seg->of.a));
    draw_triangle(pen, peak, 2.0 * half / peak);
    draw_triangle(pen, 0.0, 2.0 * half / peak);
}

// Ramps from rest to rest that last ramp_s each, with a peak of ramp_s·a/2 at most.
static void draw_fixed(nck_sshape_pen_t *pen, const segment_t *seg) {
    const double most = nck_min(seg->of.v_cap, 0.5 * seg->of.a * seg->ramp_s);
    const double peak = nck_min(most, seg->of.length / seg->ramp_s);
    const double cruise = seg->of.length - peak * seg->ramp_s;
    draw_triangle(pen, peak, seg->ramp_s);
    if (cruise > NCK_SSHAPE_EPSILON * seg->of.length) {
        nck_sshape_draw(pen, cruise / peak, 0.0, 0.0);
    }
    draw_triangle(pen, 0.0, seg->ramp_s);
}

// A ramp of constant acceleration, its time stretched by a factor near 1.
static void draw_line(nck_sshape_pen_t *pen, const segment_t *seg, double v, double stretch) {
    const double duration = stretch * nck_fabs(v - pen->v) / seg->of.a;
    if (duration > 0.0) nck_sshape_draw(pen, duration, (v - pen->v) / duration, 0.0);
    pen->v = v;
}

static void draw_linear(nck_sshape_pen_t *pen, const segment_t *seg, double v1) {
    const double cap = seg->of.v_cap * seg->of.v_cap;
    const double vv[2] = {pen->v * pen->v, v1 * v1};
    const double vv_peak = nck_ramp_peak(seg->of.length, vv[0], vv[1], seg->of.a, cap);
    const double ramps = nck_ramp_length(vv[0], vv_peak, seg->of.a)
                         + nck_ramp_length(vv_peak, vv[1], seg->of.a);
    const double cruise = seg->of.length - ramps;
    const int cruises = cruise > NCK_SSHAPE_EPSILON * seg->of.length;
    const double stretch = cruises ? 1.0 : seg->of.length / ramps;
    const double peak = nck_sqrt(vv_peak);
    draw_line(pen, seg, peak, stretch);
    if (cruises) nck_sshape_draw(pen, cruise / peak, 0.0, 0.0);
    draw_line(pen, seg, v1, stretch);
}

static void draw_sshape(nck_sshape_pen_t *pen, const segment_t *seg, double v1) {
    nck_sshape_course_t course;
    nck_sshape_plan(&seg->of, pen->v, v1, &course);
    nck_sshape_draw_ramp(pen, &seg->of, course.peak, course.stretch);
    if (course.cruise > 0.0) nck_sshape_draw(pen, course.cruise / course.peak, 0.0, 0.0);
    nck_sshape_draw_ramp(pen, &seg->of, v1, course.stretch);
}

// The cells of one segment.
static void draw_segment(nck_sshape_pen_t *pen, const segment_t *seg, double v1) {
    pen->seg = seg->index;
    pen->s = 0.0;
    switch (seg->kind) {
    case NCK_HOST_RAMP_WHOLE: draw_whole(pen, seg, v1); break;
    case NCK_HOST_RAMP_FIXED: draw_fixed(pen, seg); break;
    case NCK_HOST_RAMP_LINEAR: draw_linear(pen, seg, v1); break;
    default: draw_sshape(pen, seg, v1); break;
    }
    pen->cells[pen->count - 1].last = 1;
    pen->cells[pen->count - 1].stop = v1 == 0.0;
    pen->v = v1;
}

nck_status_t nck_host_slope_speeds(const nck_host_path_t *path, double *v_out, size_t *bad_out) {
    *bad_out = first_bad(path);
    if (*bad_out <= path->n) return NCK_E_ARGUMENT;
    const int whole = path->lookahead >= path->n;
    if (whole) look_ahead_whole(path, v_out);
    v_out[0] = path->kind == NCK_HOST_RAMP_FIXED ? 0.0
               : whole                           ? v_out[0]
                                                 : look_ahead(path, 0);
    for (size_t i = 0; i < path->n; i++) {
        const segment_t seg = segment_of(path, i);
        const double most = whole ? v_out[i + 1] : look_ahead(path, i + 1);
        v_out[i + 1] = end_speed(&seg, v_out[i], most);
    }
    return NCK_OK;
}

void nck_host_slope_cells(const nck_host_path_t *path, const double *v, size_t begin, size_t end,
                          nck_cell_t *cells_out, size_t *cell_count_out) {
    nck_sshape_pen_t pen = {cells_out, 0, 0, 0.0, v[begin]};
    for (size_t i = begin; i < end; i++) {
        const segment_t seg = segment_of(path, i);
        draw_segment(&pen, &seg, v[i + 1]);
    }
    *cell_count_out = pen.count;
}

nck_status_t nck_host_slope(const nck_host_path_t *path, double *v_out, nck_cell_t *cells_out,
                            size_t *cell_count_out, size_t *bad_out) {
    const nck_status_t status = nck_host_slope_speeds(path, v_out, bad_out);
    *cell_count_out = 0;
    if (status != NCK_OK) return status;
    nck_host_slope_cells(path, v_out, 0, path->n, cells_out, cell_count_out);
    return NCK_OK;
}

void nck_host_slope_sample(const nck_cell_t *cells, size_t count,
                           const nck_host_samples_t *samples) {
    size_t k = 0;
    double t_begin = 0.0;
    double s_begin = 0.0;
    for (size_t row = 0; row < samples->count; row++) {
        const double t = (double)row * samples->period_s;
        while (k < count && t - t_begin >= cells[k].duration) {
            t_begin += cells[k].duration;
            s_begin += cells[k].length;
            k++;
        }
        const nck_cell_t at_end = {0};
        const nck_cell_t *cell = k < count ? &cells[k] : &at_end;
        const double u = k < count ? t - t_begin : 0.0;
        samples->s[row] = s_begin + u * (cell->v + u * (cell->a / 2.0 + u * cell->j / 6.0));
        samples->v[row] = cell->v + u * (cell->a + u * cell->j / 2.0);
        samples->a[row] = cell->a + u * cell->j;
    }
}
