// SPDX-License-Identifier: MIT
// The rows of a motion (motion.h): one limit of one axis at one place, as an interior point method
// has it.
#ifndef NCK_BASE_MOTION_MATH_H
#define NCK_BASE_MOTION_MATH_H

#include "nck/base/real.h"   // nck_num
#include "nck/base/tuning.h" // NCK_FALL

// A smaller room is none: sums of nck_num cannot tell it from a limit that is broken.
#define NCK_MOTION_ROOM_MIN NCK_NUM_OF(sizeof(nck_num) == 4 ? 1e-6 : 1e-10)
// Seconds for one whole limit: what no limit of a feasible window is worth. Keeps others finite.
#define NCK_MOTION_Z_MOST NCK_NUM_OF(1e8)

// A path rests where |p′/2τ|² is no more than so many times |τp‴|²: a cell from a rest it is 1/16.
#define NCK_MOTION_REST NCK_NUM_OF(1e-6)

// A row at an iterate.
typedef struct nck_motion_row {
    nck_num pull;   // φ′
    nck_num room;   // −φ
    nck_num held;   // 1: its slack is its room
    nck_num broken; // 1: its slack is μ/z
    nck_num per;    // 1/slack
} nck_motion_row_t;

// What a row adds to the Newton system.
typedef struct nck_motion_load {
    nck_num curve;  // over its gradient twice: z φ″ + z φ′²/s
    nck_num cross;  // over its gradient and its tangent: z φ′/s
    nck_num weight; // over its tangent twice: z/s
    nck_num force;  // along its gradient and its tangent: μ/s, and z − z·room/s where broken
} nck_motion_load_t;

// `on` where x > 0, 0 where x = 0, without a branch that would keep loops from becoming vectors. x
// is a difference of numbers near 1e-10 or above: a positive one is more than 1e-20.
static inline nck_num nck_motion_where(nck_num x, nck_num on) {
    return nck_num_min(NCK_NUM_OF(1e20) * x, on);
}

// x, no further from 0 than 1.
static inline nck_num nck_motion_clip(nck_num x) {
    const nck_num one = NCK_NUM_OF(1);
    return NCK_NUM_OF(0.5) * (NCK_NUM_ABS(x + one) - NCK_NUM_ABS(x - one));
}

// Share of the acceleration: x = p₁β + p₂γ.
static inline nck_num nck_motion_acceleration(nck_num p1, nck_num p2, nck_num slope,
                                              nck_num level) {
    return p1 * slope + p2 * level;
}

// Share of the jerk over √γ·A/(Jτ): p₁α + 3/2 p₂β + δγ (p′a′ + 3p″a + p‴b by the chain rule).
static inline nck_num nck_motion_jerk(nck_num p1_bend, nck_num p2_slope, nck_num turn_level) {
    return p1_bend + (NCK_NUM_OF(1.5) * p2_slope + turn_level);
}

// The path of an axis at a place (nck_motion_path_t), of one lane.
typedef struct nck_motion_ways {
    nck_num p1, p2;  // p′/(2τA), p″/A
    nck_num turn[2]; // δ on either side
} nck_motion_ways_t;

// Products of p′, p″ and δ, summed over axes.
typedef struct nck_motion_dots {
    nck_num one_one, one_two, one_turn[2], turn_turn, two_turn;
} nck_motion_dots_t;

// Add an axis; share: its A over that of the path.
static inline void nck_motion_add(nck_motion_dots_t *dots, nck_motion_ways_t ways, nck_num share) {
    const nck_num weight = share * share;
    dots->one_one += weight * ways.p1 * ways.p1;
    dots->one_two += weight * ways.p1 * ways.p2;
    dots->one_turn[0] += weight * ways.p1 * ways.turn[0];
    dots->one_turn[1] += weight * ways.p1 * ways.turn[1];
    dots->turn_turn += weight * ways.turn[0] * ways.turn[0];
    dots->two_turn += weight * ways.p2 * ways.turn[0];
}

// What of all axes has the direction p′/|p′| of the path; where it rests, p‴/|p‴|.
static inline nck_motion_ways_t nck_motion_along(const nck_motion_dots_t *dots) {
    const int rests = !(dots->one_one > NCK_MOTION_REST * dots->turn_turn);
    const nck_num square = rests ? dots->turn_turn : dots->one_one;
    const nck_num size = NCK_NUM_SQRT(square);
    const nck_num per = size > 0 ? 1 / size : 0;
    nck_motion_ways_t ways;
    ways.p1 = rests ? 0 : size;
    ways.p2 = per * (rests ? dots->two_turn : dots->one_two);
    ways.turn[0] = rests ? size : per * dots->one_turn[0];
    ways.turn[1] = rests ? size : per * dots->one_turn[1];
    return ways;
}

// A limit |x| ≤ 1 as one row φ(x) ≤ 0:
//
//     φ = (x² − 1)/2  for |x| ≤ 1,   |x| − 1 beyond      (φ′ = x, at most 1 either way)
//
// convex and smooth. Inside −μ ln(−φ) is the barrier of the two rows x ≤ 1 and −x ≤ 1; far outside
// Newton's method finds its way back as straight as with those. The slack is the room where that is
// more than `least`; else it is μ/z, which a multiplier that grows makes small: no slack is stored.
static inline nck_motion_row_t nck_motion_row(nck_num x, nck_num z, nck_num on, nck_num least,
                                              nck_num slack_per) {
    nck_motion_row_t row;
    row.pull = nck_motion_clip(x);
    row.room = NCK_NUM_OF(0.5) + row.pull * (NCK_NUM_OF(0.5) * row.pull - x);
    const nck_num room = nck_num_max(row.room, least);
    row.held = nck_motion_where(room - least, on);
    row.broken = on - row.held;
    row.per = row.held / room + row.broken * (z * slack_per);
    return row;
}

// Newton's method for s z = μ, s = −φ (Boyd and Vandenberghe 2004, 11.7.1, slacks eliminated).
static inline nck_motion_load_t nck_motion_load(nck_motion_row_t row, nck_num z, nck_num mu) {
    nck_motion_load_t load;
    load.weight = z * row.per;
    load.cross = load.weight * row.pull;
    load.curve = row.held * z + load.cross * row.pull;
    load.force = mu * row.per + row.broken * (z - load.weight * row.room);
    return load;
}

// s z of a row: how far it is from complementary; mu: of the slack of a broken one.
static inline nck_num nck_motion_gone(nck_motion_row_t row, nck_num z, nck_num mu) {
    return row.held * row.room * z + row.broken * mu;
}

// The multiplier at the end of a whole step in which φ rises by `rise`: (μ + z·rise)/s, for a row
// that is not held z more and z·room/s less.
static inline nck_num nck_motion_multiplier(nck_motion_row_t row, nck_num z, nck_num rise,
                                            nck_num mu) {
    return (mu + z * (rise - row.broken * row.room)) * row.per + row.broken * z;
}

// The same, kept within what a multiplier may be.
static inline nck_num nck_motion_renewed(nck_num now, nck_num z) {
    return nck_num_min(nck_num_max(now, NCK_FALL * z), NCK_MOTION_Z_MOST);
}

// 1/(share of the step that ends at the limit) of a row that is held: the larger one of
// (dx + t)/(1 − x) and (t − dx)/(1 + x), where the step takes t off the limit.
static inline nck_num nck_motion_up(nck_motion_row_t row, nck_num x, nck_num dx, nck_num t) {
    const nck_num even = t + x * dx;
    const nck_num odd = dx + x * t;
    return NCK_NUM_OF(0.5) * row.held * row.per * (even + NCK_NUM_ABS(odd));
}

#endif
