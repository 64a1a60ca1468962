// SPDX-License-Identifier: MIT
// The rows of a chunk, lane by lane: their first multipliers, what they add to the Newton system,
// where a step takes them. motion_math.h has what a row is.
#include "nck/base/motion_rows.h"

#include <string.h> // memcpy memset

#include "nck/base/motion_math.h" // nck_motion_row

// Where a row's numbers stand in a batch.
enum { ACCELERATION = 0, JERK_0 = NCK_MOTION_LANES, JERK_1 = 2 * NCK_MOTION_LANES };

// What is the same in all lanes.
typedef struct same {
    nck_num ratio;     // A/(Jτ) of the axis
    nck_num least;     // a slack may be no smaller room
    nck_num slack_per; // 1/μ that slacks of broken rows are made with
    nck_num mu_was;    // that μ
    nck_num mu;        // of the step
} same_t;

// x of the three rows of a lane.
typedef struct shares {
    nck_num a, j0, j1;
} shares_t;

static same_t same_of(const nck_motion_t *self, int axis) {
    same_t same;
    same.ratio = self->ratio[axis];
    same.least = self->iteration > 0 ? NCK_MOTION_ROOM_MIN : self->room;
    same.slack_per = self->slack_per;
    same.mu_was = self->mu_was;
    same.mu = self->mu;
    return same;
}

// The gradients of a lane's rows are p₁, p₂ over slope and level, and q (p₁, 3/2 p₂, δ) over bend,
// slope and level; q = √γ A/(Jτ).
static inline shares_t shares_of(const nck_motion_shape_t *restrict shape,
                                 const nck_motion_path_t *restrict path, nck_num q, int k) {
    const nck_num p1 = path->p1[k];
    const nck_num p2_slope = path->p2[k] * shape->slope[k];
    const nck_num level = shape->level[k];
    const nck_num j0 = nck_motion_jerk(p1 * shape->bend[0][k], p2_slope, path->turn[0][k] * level);
    const nck_num j1 = nck_motion_jerk(p1 * shape->bend[1][k], p2_slope, path->turn[1][k] * level);
    shares_t x;
    x.a = nck_motion_acceleration(p1, path->p2[k], shape->slope[k], level);
    x.j0 = q * j0;
    x.j1 = q * j1;
    return x;
}

// The same of the rows that are there.
static inline shares_t shares_on(const nck_motion_shape_t *restrict shape,
                                 const nck_motion_path_t *restrict path,
                                 const nck_num *restrict on, nck_num q, int k) {
    shares_t x = shares_of(shape, path, q, k);
    x.a *= on[ACCELERATION + k];
    x.j0 *= on[JERK_0 + k];
    x.j1 *= on[JERK_1 + k];
    return x;
}

// A row, its numbers at i of a batch.
static inline nck_motion_row_t row_of(nck_num x, const nck_num *restrict z,
                                      const nck_num *restrict on, const same_t *restrict same,
                                      int i) {
    return nck_motion_row(x, z[i], on[i], same->least, same->slack_per);
}

static inline nck_num largest_of(nck_num a, nck_num b, nck_num c) {
    return nck_num_max(nck_num_max(a, b), c);
}

static void seed_axis(nck_num *restrict z, const nck_motion_place_t *restrict place,
                      const nck_motion_path_t *restrict path, const same_t *restrict same) {
    for (int k = 0; k < NCK_MOTION_LANES; k++) {
        const shares_t x = shares_of(&place->b, path, same->ratio * place->root[k], k);
        z[ACCELERATION + k] = x.a;
        z[JERK_0 + k] = x.j0;
        z[JERK_1 + k] = x.j1;
    }
    for (int k = 0; k < NCK_MOTION_BATCH; k++) {
        const nck_num room = nck_motion_row(z[k], 0, 0, same->least, 0).room;
        z[k] = place->on[k] * (same->mu_was / nck_num_max(room, same->least));
    }
}

// What a lane adds to the Newton system of its place.
typedef struct lane_sum {
    nck_num slope_slope, slope_level, level_level;
    nck_num slope, level; // gradient
} lane_sum_t;

static inline lane_sum_t acceleration_of(nck_motion_row_t row, nck_motion_load_t load, nck_num p1,
                                     nck_num p2) {
    const nck_num along = load.curve * p1;
    const nck_num force = row.pull * load.force;
    lane_sum_t sum;
    sum.slope_slope = along * p1;
    sum.slope_level = along * p2;
    sum.level_level = load.curve * p2 * p2;
    sum.slope = force * p1;
    sum.level = force * p2;
    return sum;
}

// What a row of jerk adds, its bend apart.
typedef struct bend_sum {
    nck_num bend_bend, bend_slope, bend_level, bend;
} bend_sum_t;

// The gradient of a row of jerk over α, β, γ, and of its tangent over γ.
typedef struct row_gradient {
    nck_num bend, slope, level, tangent;
} row_gradient_t;

static inline bend_sum_t jerk_of(nck_motion_row_t row, nck_motion_load_t load, row_gradient_t to,
                                 lane_sum_t *sum) {
    const nck_num slope = load.curve * to.slope;
    const nck_num tangent = load.cross * to.tangent;
    const nck_num level = load.curve * to.level + tangent;
    const nck_num force = row.pull * load.force;
    const bend_sum_t bend = {load.curve * to.bend * to.bend, slope * to.bend, level * to.bend,
                             force * to.bend};
    sum->slope_slope += slope * to.slope;
    sum->slope_level += level * to.slope;
    sum->level_level += (level + tangent) * to.level + load.weight * to.tangent * to.tangent;
    sum->slope += force * to.slope;
    sum->level += force * to.level + load.force * to.tangent;
    return bend;
}

static inline void add_bend(nck_motion_system_t *restrict m, int side, bend_sum_t bend, int k) {
    m->bend_bend[side][k] += bend.bend_bend;
    m->bend_slope[side][k] += bend.bend_slope;
    m->bend_level[side][k] += bend.bend_level;
    m->force.bend[side][k] += bend.bend;
}

static inline void add_lane(nck_motion_system_t *restrict m, lane_sum_t sum, int k) {
    m->slope_slope[k] += sum.slope_slope;
    m->slope_level[k] += sum.slope_level;
    m->level_level[k] += sum.level_level;
    m->force.slope[k] += sum.slope;
    m->force.level[k] += sum.level;
}

static void assemble_axis(nck_motion_system_t *restrict m, nck_motion_sums_t *restrict sums,
                          const nck_num *restrict z, const nck_motion_place_t *restrict place,
                          const nck_motion_path_t *restrict path, const same_t *restrict same) {
    const nck_num *restrict on = place->on;
    for (int k = 0; k < NCK_MOTION_LANES; k++) {
        const nck_num q = same->ratio * place->root[k];
        const nck_num za = z[ACCELERATION + k];
        const nck_num z0 = z[JERK_0 + k];
        const nck_num z1 = z[JERK_1 + k];
        const shares_t x = shares_on(&place->b, path, on, q, k);
        const nck_motion_row_t a = row_of(x.a, z, on, same, ACCELERATION + k);
        const nck_motion_row_t j0 = row_of(x.j0, z, on, same, JERK_0 + k);
        const nck_motion_row_t j1 = row_of(x.j1, z, on, same, JERK_1 + k);
        row_gradient_t to = {q * path->p1[k], q * NCK_NUM_OF(1.5) * path->p2[k],
                             q * path->turn[0][k], place->tangent[k]};
        const nck_motion_load_t of_a = nck_motion_load(a, za, same->mu);
        lane_sum_t sum = acceleration_of(a, of_a, path->p1[k], path->p2[k]);
        add_bend(m, 0, jerk_of(j0, nck_motion_load(j0, z0, same->mu), to, &sum), k);
        to.level = q * path->turn[1][k];
        add_bend(m, 1, jerk_of(j1, nck_motion_load(j1, z1, same->mu), to, &sum), k);
        add_lane(m, sum, k);
        sums->gone[k] += nck_motion_gone(a, za, same->mu_was)
                         + nck_motion_gone(j0, z0, same->mu_was)
                         + nck_motion_gone(j1, z1, same->mu_was);
        const nck_num most = largest_of(NCK_NUM_ABS(x.a), NCK_NUM_ABS(x.j0), NCK_NUM_ABS(x.j1));
        sums->most[k] = nck_num_max(sums->most[k], most);
    }
}

static void direct_axis(nck_num *restrict z, nck_motion_sums_t *restrict sums,
                        const nck_motion_place_t *restrict place,
                        const nck_motion_shape_t *restrict step,
                        const nck_motion_path_t *restrict path, const same_t *restrict same) {
    const nck_num *restrict on = place->on;
    for (int k = 0; k < NCK_MOTION_LANES; k++) {
        const nck_num q = same->ratio * place->root[k];
        const shares_t x = shares_on(&place->b, path, on, q, k);
        const shares_t dx = shares_of(step, path, q, k);
        const nck_num less = place->tangent[k] * step->level[k];
        const nck_motion_row_t a = row_of(x.a, z, on, same, ACCELERATION + k);
        const nck_motion_row_t j0 = row_of(x.j0, z, on, same, JERK_0 + k);
        const nck_motion_row_t j1 = row_of(x.j1, z, on, same, JERK_1 + k);
        const nck_num was_a = z[ACCELERATION + k];
        const nck_num was_0 = z[JERK_0 + k];
        const nck_num was_1 = z[JERK_1 + k];
        const nck_num za = nck_motion_multiplier(a, was_a, a.pull * dx.a, same->mu);
        const nck_num z0 = nck_motion_multiplier(j0, was_0, j0.pull * dx.j0 + less, same->mu);
        const nck_num z1 = nck_motion_multiplier(j1, was_1, j1.pull * dx.j1 + less, same->mu);
        const nck_num up = largest_of(nck_motion_up(a, x.a, dx.a, 0),
                                   nck_motion_up(j0, x.j0, dx.j0, less),
                                   nck_motion_up(j1, x.j1, dx.j1, less));
        const nck_num back = largest_of(-za - was_a, -z0 - was_0, -z1 - was_1);
        z[ACCELERATION + k] = nck_motion_renewed(za, was_a);
        z[JERK_0 + k] = nck_motion_renewed(z0, was_0);
        z[JERK_1 + k] = nck_motion_renewed(z1, was_1);
        sums->up[k] = nck_num_max(sums->up[k], up);
        sums->back[k] = nck_num_max(sums->back[k], back);
    }
}

// A rough motion has rows in the middles alone.
static int first_kind(const nck_motion_t *self) {
    return (self->wish.ends & NCK_MOTION_COARSE) != 0;
}

NCK_LANES void nck_motion_seed(nck_motion_t *self, int chunk) {
    nck_motion_place_t place;
    nck_motion_path_t path;
    for (int kind = first_kind(self); kind < NCK_MOTION_PLACES; kind++) {
        nck_motion_place(self, chunk, kind, &place);
        for (int n = 0; n < self->limited; n++) {
            const int axis = self->axis[n];
            const same_t same = same_of(self, axis);
            nck_motion_path(self, chunk, axis, kind, &path);
            seed_axis(self->work->z[chunk][axis][kind], &place, &path, &same);
        }
    }
}

NCK_LANES void nck_motion_assemble(nck_motion_t *self, int chunk) {
    nck_motion_place_t place;
    nck_motion_path_t path;
    nck_motion_system_t system;
    for (int kind = first_kind(self); kind < NCK_MOTION_PLACES; kind++) {
        nck_motion_place(self, chunk, kind, &place);
        memset(&system, 0, sizeof system);
        for (int n = 0; n < self->limited; n++) {
            const int axis = self->axis[n];
            const same_t same = same_of(self, axis);
            nck_motion_path(self, chunk, axis, kind, &path);
            assemble_axis(&system, &self->sums, self->work->z[chunk][axis][kind], &place, &path,
                          &same);
        }
        nck_motion_scatter(self, chunk, kind, &system);
    }
}

NCK_LANES void nck_motion_direct(nck_motion_t *self, int chunk) {
    nck_motion_place_t place;
    nck_motion_shape_t step;
    nck_motion_path_t path;
    nck_motion_sums_t sums; // so that a compiler sees them apart from z
    memcpy(&sums, &self->sums, sizeof sums);
    for (int kind = first_kind(self); kind < NCK_MOTION_PLACES; kind++) {
        nck_motion_place(self, chunk, kind, &place);
        nck_motion_shape(&self->work->step_b[chunk * NCK_MOTION_LANES + 1], kind, &step);
        for (int n = 0; n < self->limited; n++) {
            const int axis = self->axis[n];
            const same_t same = same_of(self, axis);
            nck_motion_path(self, chunk, axis, kind, &path);
            direct_axis(self->work->z[chunk][axis][kind], &sums, &place, &step, &path, &same);
        }
    }
    memcpy(&self->sums, &sums, sizeof sums);
}
