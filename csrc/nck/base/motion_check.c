// SPDX-License-Identifier: MIT
// What a finished motion takes of the limits, also where no row stands.
#include <string.h> // memset

#include "nck/base/motion_math.h" // nck_motion_jerk
#include "nck/base/motion_rows.h" // nck_motion_shape
#include "nck/base/tuning.h"      // NCK_MET

// What is passed between rows by more has a reserve against it.
#define MET NCK_NUM_OF(NCK_MET)

// Places of half a cell that are looked at, an eighth of a cell apart.
enum { SPOTS = 5 };

// The path at x · τ from a node, |x| ≤ 1/2: p₁ + p₂x/2 + δx²/4, p₂ + δx.
static inline nck_motion_ways_t ways_at(const nck_motion_path_t *restrict path, nck_num x, int k) {
    const nck_num turn = path->turn[x < 0][k];
    const nck_num half = NCK_NUM_OF(0.5) * x;
    const nck_motion_ways_t ways = {path->p1[k] + half * (path->p2[k] + half * turn),
                                    path->p2[k] + x * turn, {turn, turn}};
    return ways;
}

// What is taken in a half cell of each lane: of an acceleration at its places, signed; the largest
// shares of limits, of a and j, of v.
typedef struct side {
    nck_motion_lanes_t a[SPOTS];
    nck_motion_lanes_t most, fastest;
} side_t;

// What a path takes at a place, x · τ from a node. The motion has β + αx, γ + βx + αx²/2.
static inline void check_ways(side_t *restrict side, const nck_motion_shape_t *restrict b,
                              nck_motion_ways_t at, const nck_num *restrict ratios, nck_num x,
                              int k) {
    const int spot = (int)(NCK_NUM_OF(8) * NCK_NUM_ABS(x));
    const nck_num half = NCK_NUM_OF(0.5) * x;
    const nck_num slope = b->slope[k] + x * b->bend[0][k];
    const nck_num level = b->level[k] + x * (b->slope[k] + half * b->bend[0][k]);
    const nck_num v = NCK_NUM_SQRT(nck_num_max(level, 0));
    const nck_num jerk = nck_motion_jerk(at.p1 * b->bend[0][k], at.p2 * slope, at.turn[0] * level);
    const nck_num share = NCK_NUM_ABS(ratios[0] * v * jerk);
    side->a[spot][k] = nck_motion_acceleration(at.p1, at.p2, slope, level);
    if (spot + 1 < SPOTS) side->most[k] = nck_num_max(side->most[k], share); // there is a row
    side->fastest[k] = nck_num_max(side->fastest[k], NCK_NUM_ABS(ratios[1] * v * at.p1));
}

// The largest of three values, or of the parabola through them where that has its vertex between.
static inline nck_num most_of_three(nck_num f0, nck_num f1, nck_num f2) {
    const nck_num rise = f2 - f0;
    const nck_num bend = f0 - NCK_NUM_OF(2) * f1 + f2;
    const nck_num ends = nck_num_max(NCK_NUM_ABS(f0), NCK_NUM_ABS(f2));
    const nck_num most = nck_num_max(ends, NCK_NUM_ABS(f1));
    if (!(NCK_NUM_OF(2) * NCK_NUM_ABS(bend) > NCK_NUM_ABS(rise))) return most;
    return nck_num_max(most, NCK_NUM_ABS(f1 - rise * rise / (NCK_NUM_OF(8) * bend)));
}

// An acceleration is a cubic: where b turns sharply it is up to 2.5 % larger than at its places.
static void note_most(side_t *side) {
    for (int n = 0; n + 2 < SPOTS; n += 2) {
        for (int k = 0; k < NCK_MOTION_LANES; k++) {
            const nck_num a = most_of_three(side->a[n][k], side->a[n + 1][k], side->a[n + 2][k]);
            side->most[k] = nck_num_max(side->most[k], a);
        }
    }
}

// From the node on: how far a place is, as a share of a cell; way: −1 before the node, 1 behind it.
static inline nck_num place_of(int spot, int way) {
    return NCK_NUM_OF(0.125) * (nck_num)(way * spot);
}

static void check_axis(const nck_motion_t *self, int chunk, int axis, side_t sides[2]) {
    const nck_num ratios[2] = {self->ratio[axis], self->speed[axis]};
    nck_motion_shape_t shape;
    nck_motion_path_t path;
    nck_motion_shape(&self->b[chunk * NCK_MOTION_LANES + 1], 0, &shape);
    nck_motion_path(self, chunk, axis, 0, &path);
    for (int side = 0; side < 2; side++) {
        for (int spot = 0; spot < SPOTS; spot++) {
            const nck_num x = place_of(spot, 2 * side - 1);
            for (int k = 0; k < NCK_MOTION_LANES; k++) {
                check_ways(&sides[side], &shape, ways_at(&path, x, k), ratios, x, k);
            }
        }
        note_most(&sides[side]);
    }
}

// Of the path, at a distance x from each node: its direction there, not that at the node.
static void check_path_at(const nck_motion_t *self, int chunk, const nck_motion_shape_t *shape,
                          nck_num x, side_t *side) {
    const nck_num ratios[2] = {self->ratio[NCK_MOTION_ALONG], 0};
    nck_motion_dots_t dots[NCK_MOTION_LANES];
    nck_motion_path_t path;
    memset(dots, 0, sizeof dots);
    for (int n = 0; n < self->moving; n++) {
        nck_motion_path(self, chunk, self->axis[n], 0, &path);
        for (int k = 0; k < NCK_MOTION_LANES; k++) {
            nck_motion_add(&dots[k], ways_at(&path, x, k), self->share[self->axis[n]]);
        }
    }
    for (int k = 0; k < NCK_MOTION_LANES; k++) {
        check_ways(side, shape, nck_motion_along(&dots[k]), ratios, x, k);
    }
}

static void check_path(const nck_motion_t *self, int chunk, side_t sides[2]) {
    nck_motion_shape_t shape;
    nck_motion_shape(&self->b[chunk * NCK_MOTION_LANES + 1], 0, &shape);
    for (int side = 0; side < 2; side++) {
        for (int spot = 0; spot < SPOTS; spot++) {
            const nck_num x = place_of(spot, 2 * side - 1);
            check_path_at(self, chunk, &shape, x, &sides[side]);
        }
        note_most(&sides[side]);
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
    if (share > NCK_NUM_OF(1) + MET) *reserve += share - NCK_NUM_OF(1);
    if (speed > NCK_NUM_OF(1) + MET && !(self->wish.ends & NCK_MOTION_SOFT)) {
        self->cap[node + 1] /= speed * speed;
        self->scale[node + 1] = NCK_NUM_OF(1) / self->cap[node + 1];
    }
}

NCK_LANES void nck_motion_check(nck_motion_t *self, int chunk) {
    side_t sides[2];
    memset(sides, 0, sizeof sides);
    for (int n = 0; n < self->moving; n++) check_axis(self, chunk, self->axis[n], sides);
    if (self->limited > self->moving) check_path(self, chunk, sides);
    for (int k = 0; k < NCK_MOTION_LANES; k++) {
        const int node = chunk * NCK_MOTION_LANES + k;
        if (node < self->low || node > self->high) continue;
        const int from = node == 0;
        const int to = node < self->wish.nodes - 1;
        reserve(self, node, nck_num_max(sides[from].most[k], sides[to].most[k]),
                nck_num_max(sides[from].fastest[k], sides[to].fastest[k]));
    }
}

// A speed is beyond its cap from this share of v² on: a plan that slows down has not come to it.
#define BEYOND NCK_NUM_OF(1.01)

// The path of an axis at a node.
static nck_motion_ways_t ways_of(const nck_motion_t *self, int axis, int k) {
    const nck_num *const p2 = &self->p2[axis][k + 1];
    const nck_num before = k > 0 ? p2[0] - p2[-1] : 0;
    const nck_num behind = k + 1 < self->wish.nodes ? p2[1] - p2[0] : 0;
    const nck_motion_ways_t ways = {self->p1[axis][k + 1], p2[0], {behind, before}};
    return ways;
}

// How the motion passes a node.
typedef struct passing {
    nck_num bend, slope, level;
} passing_t;

// Add what an axis, or the path, takes of acceleration and jerk.
static void add_share(nck_num *most, nck_motion_ways_t at, nck_num ratio, const passing_t *b) {
    const nck_num q = ratio * NCK_NUM_SQRT(b->level);
    const nck_num a = NCK_NUM_ABS(nck_motion_acceleration(at.p1, at.p2, b->slope, b->level));
    most[NCK_MOTION_ACCELERATION] = nck_num_max(most[NCK_MOTION_ACCELERATION], a);
    for (int side = 0; side < 2; side++) {
        const nck_num j = q * nck_motion_jerk(at.p1 * b->bend, at.p2 * b->slope,
                                              at.turn[side] * b->level);
        most[NCK_MOTION_JERK] = nck_num_max(most[NCK_MOTION_JERK], NCK_NUM_ABS(j));
    }
}

nck_motion_hold_t nck_motion_hold(const nck_motion_t *self, int k) {
    const nck_num *const b = &self->b[k + 1];
    passing_t passing;
    nck_motion_dots_t dots;
    passing.bend = b[1] - NCK_NUM_OF(2) * b[0] + b[-1];
    passing.slope = NCK_NUM_OF(0.5) * (b[1] - b[-1]);
    passing.level = nck_num_max(b[0] + NCK_NUM_OF(0.125) * passing.bend, 0);
    const nck_num of_cap = b[0] / self->cap[k + 1];
    nck_num most[] = {of_cap < BEYOND ? of_cap : 0, 0, 0};
    memset(&dots, 0, sizeof dots);
    for (int n = 0; n < self->moving; n++) {
        const int axis = self->axis[n];
        const nck_motion_ways_t ways = ways_of(self, axis, k);
        add_share(most, ways, self->ratio[axis], &passing);
        nck_motion_add(&dots, ways, self->share[axis]);
    }
    if (self->limited > self->moving) {
        add_share(most, nck_motion_along(&dots), self->ratio[NCK_MOTION_ALONG], &passing);
    }
    if (most[NCK_MOTION_CAP] >= nck_num_max(most[NCK_MOTION_ACCELERATION], most[NCK_MOTION_JERK])) {
        return NCK_MOTION_CAP;
    }
    return most[NCK_MOTION_ACCELERATION] >= most[NCK_MOTION_JERK] ? NCK_MOTION_ACCELERATION
                                                                  : NCK_MOTION_JERK;
}
