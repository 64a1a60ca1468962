// SPDX-License-Identifier: MIT
// What a finished motion takes of the limits, also where no row stands.
#include <string.h> // memset

#include "nck/base/motion_math.h" // nck_motion_jerk
#include "nck/base/motion_rows.h" // nck_motion_shape

enum { SPOTS = 3 };

// The path and the motion at x · τ from a node, |x| ≤ 1/2: p₁ + p₂x/2 + δx²/4, p₂ + δx;
// β + αx, γ + βx + αx²/2.
typedef struct spot {
    nck_num p1, p2, slope, level;
} spot_t;

static inline spot_t spot_at(const nck_motion_shape_t *restrict b,
                             const nck_motion_path_t *restrict path, nck_num x, int k) {
    const nck_num turn = path->turn[x < 0][k];
    const nck_num half = NCK_NUM_OF(0.5) * x;
    spot_t spot;
    spot.p1 = path->p1[k] + half * (path->p2[k] + half * turn);
    spot.p2 = path->p2[k] + x * turn;
    spot.slope = b->slope[k] + x * b->bend[0][k];
    spot.level = b->level[k] + x * (b->slope[k] + half * b->bend[0][k]);
    return spot;
}

// The largest shares of an axis' limits at a distance x from each node: of a and j, of v.
static void check_at(nck_num *restrict most, nck_num *restrict fastest,
                     const nck_motion_shape_t *restrict b, const nck_motion_path_t *restrict path,
                     const nck_num *restrict ratios, nck_num x) {
    for (int k = 0; k < NCK_MOTION_LANES; k++) {
        const spot_t at = spot_at(b, path, x, k);
        const nck_num turn = path->turn[x < 0][k];
        const nck_num v = NCK_NUM_SQRT(nck_num_max(at.level, 0));
        const nck_num jerk = nck_motion_jerk(at.p1 * b->bend[0][k], at.p2 * at.slope,
                                             turn * at.level);
        const nck_num a = nck_motion_acceleration(at.p1, at.p2, at.slope, at.level);
        const nck_num share = nck_num_max(NCK_NUM_ABS(a), NCK_NUM_ABS(ratios[0] * v * jerk));
        most[k] = nck_num_max(most[k], share);
        fastest[k] = nck_num_max(fastest[k], NCK_NUM_ABS(ratios[1] * v * at.p1));
    }
}

// The most about each node: in the half cell before it, in the one behind it.
typedef struct sides {
    nck_motion_lanes_t most[2], fastest[2];
} sides_t;

// The node and three spots in either half cell: an extreme of the jerk, a parabola but for the
// root, is no more than 1/16 of a cell from one of them or from a row.
static void check_axis(const nck_motion_t *self, int chunk, int axis, sides_t *sides) {
    const nck_num ratios[2] = {self->ratio[axis], self->speed[axis]};
    nck_motion_shape_t shape;
    nck_motion_path_t path;
    nck_motion_shape(&self->b[chunk * NCK_MOTION_LANES + 1], 0, &shape);
    nck_motion_path(self, chunk, axis, 0, &path);
    for (int spot = 0; spot <= SPOTS; spot++) {
        const nck_num x = NCK_NUM_OF(0.125) * (nck_num)spot;
        check_at(sides->most[0], sides->fastest[0], &shape, &path, ratios, -x);
        check_at(sides->most[1], sides->fastest[1], &shape, &path, ratios, x);
    }
}

// What is beyond the limits about a node becomes its reserve, besides the one that it has, and
// lowers its cap: shares are those of the path times 1 + reserve. Not beside nodes that are fixed:
// they were good enough for the last plan, and there may be no other way on.
static void reserve(nck_motion_t *self, int node, nck_num most, nck_num fastest) {
    nck_num *const reserve = &self->reserve[node + 1];
    const nck_num share = most / (NCK_NUM_OF(1) + *reserve);
    const nck_num speed = fastest / (NCK_NUM_OF(1) + *reserve);
    nck_num *const lane = &self->sums.most[node % NCK_MOTION_LANES];
    *lane = nck_num_max(*lane, nck_num_max(share, speed));
    if (node > 0 && node <= self->wish.fixed) return;
    if (share > NCK_NUM_OF(1)) *reserve += share - NCK_NUM_OF(1) + NCK_MOTION_MARGIN;
    if (speed > NCK_NUM_OF(1) && !(self->wish.ends & NCK_MOTION_SOFT)) {
        self->cap[node + 1] /= (speed + NCK_MOTION_MARGIN) * (speed + NCK_MOTION_MARGIN);
        self->scale[node + 1] = NCK_NUM_OF(1) / self->cap[node + 1];
    }
}

void nck_motion_check(nck_motion_t *self, int chunk) {
    sides_t sides;
    memset(&sides, 0, sizeof sides);
    for (int n = 0; n < self->moving; n++) check_axis(self, chunk, self->axis[n], &sides);
    for (int k = 0; k < NCK_MOTION_LANES; k++) {
        const int node = chunk * NCK_MOTION_LANES + k;
        if (node < self->low || node > self->high) continue;
        const int from = node == 0;
        const int to = node < self->wish.nodes - 1;
        reserve(self, node, nck_num_max(sides.most[from][k], sides.most[to][k]),
                nck_num_max(sides.fastest[from][k], sides.fastest[to][k]));
    }
}

// A speed is beyond its cap from this share of v² on: a plan that slows down has not come to it.
#define BEYOND NCK_NUM_OF(1.01)

nck_motion_hold_t nck_motion_hold(const nck_motion_t *self, int k) {
    const nck_num *const b = &self->b[k + 1];
    const nck_num bend = b[1] - NCK_NUM_OF(2) * b[0] + b[-1];
    const nck_num slope = NCK_NUM_OF(0.5) * (b[1] - b[-1]);
    const nck_num level = nck_num_max(b[0] + NCK_NUM_OF(0.125) * bend, 0);
    const nck_num of_cap = b[0] / self->cap[k + 1];
    nck_num most[] = {of_cap < BEYOND ? of_cap : 0, 0, 0};
    for (int n = 0; n < self->moving; n++) {
        const int axis = self->axis[n];
        const nck_num p1 = self->p1[axis][k + 1];
        const nck_num *const p2 = &self->p2[axis][k + 1];
        const nck_num q = self->ratio[axis] * NCK_NUM_SQRT(level);
        const nck_num a = nck_motion_acceleration(p1, p2[0], slope, level);
        most[NCK_MOTION_ACCELERATION] = nck_num_max(most[NCK_MOTION_ACCELERATION],
                                                       NCK_NUM_ABS(a));
        const nck_num before = k > 0 ? p2[0] - p2[-1] : 0;
        const nck_num behind = k + 1 < self->wish.nodes ? p2[1] - p2[0] : 0;
        const nck_num j0 = q * nck_motion_jerk(p1 * bend, p2[0] * slope, before * level);
        const nck_num j1 = q * nck_motion_jerk(p1 * bend, p2[0] * slope, behind * level);
        const nck_num j = nck_num_max(NCK_NUM_ABS(j0), NCK_NUM_ABS(j1));
        most[NCK_MOTION_JERK] = nck_num_max(most[NCK_MOTION_JERK], j);
    }
    if (most[NCK_MOTION_CAP] >= nck_num_max(most[NCK_MOTION_ACCELERATION],
                                               most[NCK_MOTION_JERK])) {
        return NCK_MOTION_CAP;
    }
    return most[NCK_MOTION_ACCELERATION] >= most[NCK_MOTION_JERK] ? NCK_MOTION_ACCELERATION
                                                                  : NCK_MOTION_JERK;
}
