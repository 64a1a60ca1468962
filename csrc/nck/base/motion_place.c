// SPDX-License-Identifier: MIT
// Where rows stand: nodes and the middles of cells, and how their sums reach the Newton system.
#include <string.h> // memset

#include "nck/base/motion_math.h" // nck_num_max
#include "nck/base/motion_rows.h"

// Keeps 1/γ finite in lanes where nothing stands; b is a million times more wherever it is at work.
#define LEVEL_MIN NCK_NUM_OF(1e-14)

// At the nodes: α = right − left, β their mean, γ = b + α/8 for differences left and right.
static void shape_of_nodes(const nck_num *restrict b, nck_motion_shape_t *restrict shape) {
    for (int k = 0; k < NCK_MOTION_LANES; k++) {
        const nck_num left = b[k] - b[k - 1];
        const nck_num right = b[k + 1] - b[k];
        const nck_num bend = right - left;
        shape->bend[0][k] = bend;
        shape->bend[1][k] = bend;
        shape->slope[k] = NCK_NUM_OF(0.5) * (left + right);
        shape->level[k] = b[k] + NCK_NUM_OF(0.125) * bend;
    }
}

// In the middles of the cells: α of the node before, of the node behind; β, γ of the cell.
static void shape_of_middles(const nck_num *restrict b, nck_motion_shape_t *restrict shape) {
    for (int k = 0; k < NCK_MOTION_LANES; k++) {
        const nck_num slope = b[k + 1] - b[k];
        shape->bend[0][k] = slope - (b[k] - b[k - 1]);
        shape->bend[1][k] = b[k + 2] - b[k + 1] - slope;
        shape->slope[k] = slope;
        shape->level[k] = NCK_NUM_OF(0.5) * (b[k] + b[k + 1]);
    }
}

NCK_LANES void nck_motion_shape(const nck_num *line, int kind, nck_motion_shape_t *shape_out) {
    if (kind == 0) shape_of_nodes(line, shape_out);
    if (kind != 0) shape_of_middles(line, shape_out);
}

// Rows of acceleration and of the jerk behind a middle belong to the node before it, those of the
// jerk before it to the node behind it.
static void mark_rows(const nck_num *restrict node, const nck_num *restrict cell,
                      nck_motion_place_t *restrict place) {
    const int is_middle = place->kind != 0;
    const nck_num *restrict next = node + is_middle;
    for (int k = 0; k < NCK_MOTION_LANES; k++) {
        const nck_num is_there = is_middle ? cell[k] : NCK_NUM_OF(1);
        place->on[k] = node[k] * is_there;
        place->on[NCK_MOTION_LANES + k] = place->on[k];
        place->on[2 * NCK_MOTION_LANES + k] = next[k] * is_there;
    }
}

NCK_LANES void nck_motion_place(const nck_motion_t *self, int chunk, int kind,
                      nck_motion_place_t *place_out) {
    const int first = chunk * NCK_MOTION_LANES;
    place_out->kind = kind;
    mark_rows(&self->on_node[first + 1], &self->on_cell[first + 1], place_out);
    nck_motion_shape(&self->b[first + 1], kind, &place_out->b);
    for (int k = 0; k < NCK_MOTION_LANES; k++) {
        const nck_num level = place_out->b.level[k];
        const nck_num safe = nck_num_max(level, LEVEL_MIN);
        place_out->root[k] = NCK_NUM_SQRT(safe);
        place_out->tangent[k] = NCK_NUM_OF(0.5) / safe;
    }
}

// Where more than at the rows is taken between them (nck_motion_check) the limits are less by that:
// what the axes do is more.
static void path_at_nodes(const nck_num *restrict p1, const nck_num *restrict p2,
                          const nck_num *restrict reserve, nck_motion_path_t *restrict path) {
    for (int k = 0; k < NCK_MOTION_LANES; k++) {
        const nck_num share = NCK_NUM_OF(1) + reserve[k];
        path->p1[k] = share * p1[k];
        path->p2[k] = share * p2[k];
        path->turn[0][k] = share * (p2[k + 1] - p2[k]);
        path->turn[1][k] = share * (p2[k] - p2[k - 1]);
    }
}

// p′ is a parabola over the cell: in its middle it is off the mean of its ends by τ²p‴/8.
static void path_in_middles(const nck_num *restrict p1, const nck_num *restrict p2,
                            const nck_num *restrict reserve, nck_motion_path_t *restrict path) {
    for (int k = 0; k < NCK_MOTION_LANES; k++) {
        const nck_num share = NCK_NUM_OF(1) + nck_num_max(reserve[k], reserve[k + 1]);
        const nck_num turn = p2[k + 1] - p2[k];
        const nck_num mean = NCK_NUM_OF(0.5) * (p1[k] + p1[k + 1]);
        path->p1[k] = share * (mean - NCK_NUM_OF(0.0625) * turn);
        path->p2[k] = share * (NCK_NUM_OF(0.5) * (p2[k] + p2[k + 1]));
        path->turn[0][k] = share * turn;
        path->turn[1][k] = share * turn;
    }
}

static void path_of_axis(const nck_motion_t *self, int chunk, int axis, int kind,
                         nck_motion_path_t *path_out) {
    const nck_num *const p1 = &self->p1[axis][chunk * NCK_MOTION_LANES + 1];
    const nck_num *const p2 = &self->p2[axis][chunk * NCK_MOTION_LANES + 1];
    const nck_num *const reserve = &self->reserve[chunk * NCK_MOTION_LANES + 1];
    if (kind == 0) path_at_nodes(p1, p2, reserve, path_out);
    if (kind != 0) path_in_middles(p1, p2, reserve, path_out);
}

static nck_motion_ways_t lane_of(const nck_motion_path_t *path, int k) {
    const nck_motion_ways_t ways = {path->p1[k], path->p2[k], {path->turn[0][k], path->turn[1][k]}};
    return ways;
}

NCK_LANES void nck_motion_path(const nck_motion_t *self, int chunk, int axis, int kind,
                     nck_motion_path_t *path_out) {
    nck_motion_dots_t dots[NCK_MOTION_LANES];
    if (axis != NCK_MOTION_ALONG) {
        path_of_axis(self, chunk, axis, kind, path_out);
        return;
    }
    memset(dots, 0, sizeof dots);
    for (int n = 0; n < self->moving; n++) {
        path_of_axis(self, chunk, self->axis[n], kind, path_out);
        for (int k = 0; k < NCK_MOTION_LANES; k++) {
            nck_motion_add(&dots[k], lane_of(path_out, k), self->share[self->axis[n]]);
        }
    }
    for (int k = 0; k < NCK_MOTION_LANES; k++) {
        const nck_motion_ways_t along = nck_motion_along(&dots[k]);
        path_out->p1[k] = along.p1;
        path_out->p2[k] = along.p2;
        path_out->turn[0][k] = along.turn[0];
        path_out->turn[1][k] = along.turn[1];
    }
}

// Add lanes to a line.
static void add(nck_num *restrict line, const nck_num *restrict lanes) {
    for (int k = 0; k < NCK_MOTION_LANES; k++) line[k] += lanes[k];
}

// The matrix over α, β, γ of a node becomes one over b of it and its neighbours: Tᵀ M T with the
// rows α = (1, −2, 1), β = (−1, 0, 1)/2, γ = (1, 6, 1)/8 of T.
static void scatter_node_matrix(nck_motion_t *self, int first, const nck_motion_system_t *m) {
    nck_motion_lanes_t before, cross, far, here, next, behind;
    for (int k = 0; k < NCK_MOTION_LANES; k++) {
        const nck_num aa = m->bend_bend[0][k] + m->bend_bend[1][k];
        const nck_num ab = NCK_NUM_OF(0.5) * (m->bend_slope[0][k] + m->bend_slope[1][k]);
        const nck_num ac = NCK_NUM_OF(0.125) * (m->bend_level[0][k] + m->bend_level[1][k]);
        const nck_num bb = NCK_NUM_OF(0.25) * m->slope_slope[k];
        const nck_num bc = NCK_NUM_OF(0.0625) * m->slope_level[k];
        const nck_num cc = NCK_NUM_OF(0.015625) * m->level_level[k];
        const nck_num even = aa + bb + NCK_NUM_OF(2) * ac + cc;
        const nck_num odd = NCK_NUM_OF(2) * (ab + bc);
        const nck_num to_here = NCK_NUM_OF(6) * cc - NCK_NUM_OF(2) * aa + NCK_NUM_OF(4) * ac;
        const nck_num skew = NCK_NUM_OF(2) * ab - NCK_NUM_OF(6) * bc;
        before[k] = even - odd;
        behind[k] = even + odd;
        far[k] = aa - bb + NCK_NUM_OF(2) * ac + cc;
        cross[k] = to_here + skew;
        next[k] = to_here - skew;
        here[k] = NCK_NUM_OF(4) * aa - NCK_NUM_OF(24) * ac + NCK_NUM_OF(36) * cc;
    }
    add(&self->work->h0[first], before);
    add(&self->work->h1[first], cross);
    add(&self->work->h2[first], far);
    add(&self->work->h0[first + 1], here);
    add(&self->work->h1[first + 1], next);
    add(&self->work->h0[first + 2], behind);
}

// The same of a gradient over α, β, γ.
static void scatter_node_gradient(nck_num *line, const nck_motion_shape_t *g) {
    nck_motion_lanes_t before, here, behind;
    for (int k = 0; k < NCK_MOTION_LANES; k++) {
        const nck_num bend = g->bend[0][k] + g->bend[1][k];
        const nck_num even = bend + NCK_NUM_OF(0.125) * g->level[k];
        const nck_num odd = NCK_NUM_OF(0.5) * g->slope[k];
        before[k] = even - odd;
        behind[k] = even + odd;
        here[k] = NCK_NUM_OF(0.75) * g->level[k] - NCK_NUM_OF(2) * bend;
    }
    add(line - 1, before);
    add(line, here);
    add(line + 1, behind);
}

// A middle of nodes 0 and 1: its bend before is that of node 0, (1, −2, 1) over nodes −1, 0, 1, the
// one behind that of node 1; slope (−1, 1), level (1, 1)/2 over nodes 0, 1.
static void scatter_middle_matrix(nck_motion_t *self, int first, const nck_motion_system_t *m) {
    nck_motion_lanes_t far0, far1, far2, here0, here1, here2, next0, next1, last0;
    for (int k = 0; k < NCK_MOTION_LANES; k++) {
        const nck_num aa = m->bend_bend[0][k];
        const nck_num ab = m->bend_slope[0][k];
        const nck_num ac = NCK_NUM_OF(0.5) * m->bend_level[0][k];
        const nck_num zz = m->bend_bend[1][k];
        const nck_num zb = m->bend_slope[1][k];
        const nck_num zc = NCK_NUM_OF(0.5) * m->bend_level[1][k];
        const nck_num bb = m->slope_slope[k];
        const nck_num bc = m->slope_level[k];
        const nck_num cc = NCK_NUM_OF(0.25) * m->level_level[k];
        const nck_num two = NCK_NUM_OF(2);
        const nck_num four = NCK_NUM_OF(4);
        far0[k] = aa;
        far1[k] = ac - ab - two * aa;
        far2[k] = aa + ab + ac;
        here0[k] = four * (aa + ab - ac) + (zz - two * (zb - zc)) + (bb - bc + cc);
        here1[k] = NCK_NUM_OF(3) * (zb - ab) - two * (aa + zz) - (ac + zc) + (cc - bb);
        here2[k] = zz - zb + zc;
        next0[k] = aa + two * (ab + ac) + four * (zz - zb - zc) + (bb + bc + cc);
        next1[k] = zb + zc - two * zz;
        last0[k] = zz;
    }
    add(&self->work->h0[first], far0);
    add(&self->work->h1[first], far1);
    add(&self->work->h2[first], far2);
    add(&self->work->h0[first + 1], here0);
    add(&self->work->h1[first + 1], here1);
    add(&self->work->h2[first + 1], here2);
    add(&self->work->h0[first + 2], next0);
    add(&self->work->h1[first + 2], next1);
    add(&self->work->h0[first + 3], last0);
}

// The gradient of a middle.
static void scatter_middle_gradient(nck_num *line, const nck_motion_shape_t *g) {
    nck_motion_lanes_t here, behind;
    for (int k = 0; k < NCK_MOTION_LANES; k++) {
        const nck_num level = NCK_NUM_OF(0.5) * g->level[k];
        here[k] = level - g->slope[k] - NCK_NUM_OF(2) * g->bend[0][k] + g->bend[1][k];
        behind[k] = level + g->slope[k] + g->bend[0][k] - NCK_NUM_OF(2) * g->bend[1][k];
    }
    add(line - 1, g->bend[0]);
    add(line, here);
    add(line + 1, behind);
    add(line + 2, g->bend[1]);
}

NCK_LANES void nck_motion_scatter(nck_motion_t *self, int chunk, int kind,
                        const nck_motion_system_t *system) {
    const int first = chunk * NCK_MOTION_LANES; // node −1 of the chunk's line
    if (kind == 0) {
        scatter_node_matrix(self, first, system);
        scatter_node_gradient(&self->work->g[first + 1], &system->force);
        return;
    }
    scatter_middle_matrix(self, first, system);
    scatter_middle_gradient(&self->work->g[first + 1], &system->force);
}
