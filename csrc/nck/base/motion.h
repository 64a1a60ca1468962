// SPDX-License-Identifier: MIT
// The fastest motion along a path that is given over a clock, within the limits of every axis'
// acceleration and jerk: a window's convex problem, by an interior point method in small steps.
//
// The clock u is a guessed time, nodes 0 … n are τ of it apart, p(u) is a cubic between them.
// Unknown is the motion b(u) = (du/dt)², near 1 where the guess is good: the quadratic B-spline of
// the b_k, so that a = b′/2 = d²u/dt² is continuous, and linear between the middles of cells. Time
// is
//
//     Σ 2τ/(√b_k + √b_{k+1})                          convex in b (Verscheure et al. 2009)
//
// and at a place, a node or the middle of a cell, b is known by three numbers that are linear in
// it:
//
//     bend   α = b_{k−1} − 2b_k + b_{k+1}                τ²b″: of the node that is half a cell away
//     slope  β = (b_{k+1} − b_{k−1})/2, b_{k+1} − b_k    τb′ at a node, in a middle
//     level  γ = b_k + α/8, (b_k + b_{k+1})/2            b
//
// With p₁ = p′/(2τA), p₂ = p″/A and δ = τp‴/A (the rise of p₂ over its cell) an axis takes of its
// limits, by the chain rule,
//
//     acceleration  x = p₁β + p₂γ                        p̈ = p′a + p″b
//     jerk          x = √γ·A/(Jτ)·(p₁α + 3/2 p₂β + δγ)   p⃛ = √b (p′a′ + 3p″a + p‴b)
//
// Where the path has limits of its own it is one more axis: its p′, p″ and p‴ are those that the
// path's direction p′/|p′| has of all axes (nck_motion_along).
//
// Rows |x| ≤ 1: at each node acceleration, jerk left and right of it; in each middle acceleration,
// jerk with the α of the node before and with that of the node behind. The jerk's row is |g(b)| ≤
// J/√b with g linear. 1/√b is convex, so its tangent at the last iterate lies below it: the row
// with the tangent, x/√γ held, x·(1/γ̄)·½ less, is linear and stricter, and at the solution it is
// the row itself (convex-concave procedure: Lipp and Boyd 2016; Consolini et al. use the like for a
// discretised jerk). Beyond a path's ends b is even.
//
// Each |x| ≤ 1 is one row φ(x) ≤ 0 (motion_math.h), with a multiplier z and without a stored slack;
// Newton's method for s z = μ (Boyd and Vandenberghe 2004, 11.7) is one symmetric system of five
// diagonals, since every row reaches three nodes: O(n). A step is gone to 0.97 of the way to the
// nearest limit that holds; a multiplier falls by a factor of ten at most, each for itself.
//
// Between its rows an axis' jerk is a parabola times √b, and may pass its limit where b is steep:
// the check looks there, takes what is beyond as a reserve of that node, and a few more rounds
// follow (a twentieth of all windows; 1 % of rounds, 0.002 % of time, to within 0.1 % of the
// limit).
//
// Bits: sums, products, quotients and square roots in an order that NCK_MOTION_LANES fixes, so
// every IEEE machine has the same, vectors or not. Floats do: b is near 1, bends are made of
// differences.
//
// Found by trying, on 2 275 windows: two rows a limit with stored slacks take 26 rounds where these
// take 19, with twice the work and memory in each; max(room, μ/z) as the slack of rows that hold
// takes 27, one relaxation for all rows 29, equal first multipliers 22. Mehrotra's corrector saves
// 10 to 25 % of the rounds and costs half of one. A motion without the rows at nodes passes limits
// by half, reserves or not; where only its time is asked for, it is as good (ROUGH).
#ifndef NCK_BASE_MOTION_H
#define NCK_BASE_MOTION_H

#include "nck/base/limits.h" // NCK_AXIS_MAX NCK_MOTION_LANES NCK_MOTION_NODES
#include "nck/base/real.h"   // nck_num
#include "nck/base/status.h" // nck_status_t

#ifdef __cplusplus
extern "C" {
#endif

// What a window has at its ends, or'ed. Without any of them it begins with rows of its own and ends
// where its last node has been set: at rest.
#define NCK_MOTION_INSIDE 1u   // the path goes on before node 0: no row stands at node 0
#define NCK_MOTION_OPEN_END 2u // the path goes on behind the last node: it is free, without rows
#define NCK_MOTION_FREE_END 4u // the last node is free: the path itself comes to rest there
#define NCK_MOTION_SOFT 8u     // caps may be broken at a price: no start is infeasible
#define NCK_MOTION_FIRM_END 32u // … but the cap of the last node but one
#define NCK_MOTION_COARSE 16u  // for the time of it: rows in the middles of cells alone, half the
                               // work; what is taken between them is told, not mended

// What is asked for.
typedef struct nck_motion_wish {
    double tau;             // from node to node of the clock [s]
    double a[NCK_AXIS_MAX]; // of each axis: limit of acceleration [mm/s²]
    double j[NCK_AXIS_MAX]; // the same of jerk [mm/s³]
    double v[NCK_AXIS_MAX]; // the same of speed [mm/s], for the check alone: caps hold it; 0: none
    double along[2];        // the most acceleration [mm/s²] and jerk [mm/s³] along the path: what
                            // of the axes' has its direction; 0: none
    int axes;               // 1 … NCK_AXIS_MAX
    int nodes;              // 2 … NCK_MOTION_NODES
    int fixed;              // the first so many nodes stay as they are set: 0 … nodes − 2
    unsigned ends;          // NCK_MOTION_…
    int most;               // iterations at most
    double gap;             // how much of the time may be lost, as a share: 1e-7 … 1
    double room;            // what a broken row's slack begins with
    double price;           // SOFT: of being beyond a cap, in halves of the time that it wins
} nck_motion_wish_t;

// What has come out.
typedef struct nck_motion_told {
    int iterations;
    double time;  // Σ 2τ/(√b_k + √b_{k+1}) [s]
    double least; // the smallest room of a row, as a share of its limit; negative: one is broken
    double gap;   // the complementarity gap as a share of the time: so much may be lost at most
    double share; // the most that any axis takes of v, a or j anywhere, between nodes, too
} nck_motion_told_t;

// Which of its limits a motion takes most of.
typedef enum nck_motion_hold {
    NCK_MOTION_CAP = 0, NCK_MOTION_ACCELERATION, NCK_MOTION_JERK
} nck_motion_hold_t;

// Of n nodes in lanes, with what stands before and behind them.
#define NCK_MOTION_CHUNKS ((NCK_MOTION_NODES + NCK_MOTION_LANES - 1) / NCK_MOTION_LANES)
#define NCK_MOTION_LINE (NCK_MOTION_CHUNKS * NCK_MOTION_LANES + 4)
// Rows of an axis at a place: its acceleration, its jerk on either side.
#define NCK_MOTION_ROWS 3
// Places of a node: the node, the middle of the cell behind it.
#define NCK_MOTION_PLACES 2
// Rows of an axis at a place, for all lanes.
#define NCK_MOTION_BATCH (NCK_MOTION_ROWS * NCK_MOTION_LANES)

// Rows of the path, behind those of the axes.
#define NCK_MOTION_ALONG NCK_AXIS_MAX

// One number a lane.
typedef nck_num nck_motion_lanes_t[NCK_MOTION_LANES];

// A line: one number a node; node k is at k + 1.
typedef nck_num nck_motion_line_t[NCK_MOTION_LINE];

// The rows that bind a chunk of lanes, as they are found.
typedef struct nck_motion_sums {
    nck_motion_lanes_t gone; // Σ slack · multiplier
    nck_motion_lanes_t most; // the largest share of a limit
    nck_motion_lanes_t time; // Σ of the cells' durations
    nck_motion_lanes_t paid; // Σ of prices for what is beyond caps
    nck_motion_lanes_t up;   // 1/(step to the nearest limit)
    nck_motion_lanes_t back; // by how much a multiplier would turn negative
} nck_motion_sums_t;

// Memory of a window that is needed until it is solved.
typedef struct nck_motion_work {
    nck_motion_line_t step_b;             // the motion's Newton step
    nck_motion_line_t h0, h1, h2;         // the Newton matrix' diagonals, then its factors
    nck_motion_line_t g;                  // gradient
    nck_motion_line_t cap_z;              // of a cap, its multiplier
    nck_motion_line_t cap_y;              // SOFT: price less cap_z
    nck_motion_line_t excess, step_excess; // SOFT: how far beyond the cap, and its step
    nck_motion_line_t slack, step_slack;  // SOFT: of the cap with its excess, and its step
    // multipliers
    nck_num z[NCK_MOTION_CHUNKS][NCK_AXIS_MAX + 1][NCK_MOTION_PLACES][NCK_MOTION_BATCH];
} nck_motion_work_t;

// All else of it; its caller owns both and touches no member.
typedef struct nck_motion {
    nck_motion_wish_t wish;
    nck_motion_work_t *work;
    int low, high;             // rows stand at these nodes
    int cap_low;               // caps from this node on
    int free_end;              // nodes fixed … free_end − 1 are free
    int phase, chunk;          // what the next step does
    int iteration;             // so many Newton steps are done
    int rows;                  // how many there are
    int moving;                // axes that move, of axis[]
    int limited;               // the same, and the path if its limits may hold
    uint8_t axis[NCK_AXIS_MAX + 1];
    nck_num mu;                // slack · multiplier that the next step aims at
    nck_num mu_was, slack_per; // what the last one aimed at, and 1/it: slacks of broken rows
    nck_num step;              // of the last Newton step this share was gone
    nck_num tau, gap, room, price; // of wish
    nck_num time, paid, gone, most; // of the last iterate
    nck_num found;             // see nck_motion_told_t: share
    nck_num ratio[NCK_AXIS_MAX + 1]; // A/(Jτ)
    nck_num speed[NCK_AXIS_MAX + 1]; // 2τA/V
    nck_num share[NCK_AXIS_MAX];     // A of an axis over that of the path
    nck_motion_line_t b;                  // the motion
    nck_motion_sums_t sums;
    nck_motion_line_t cap, scale;         // cap, 1/(its unit)
    nck_motion_line_t on_node, on_cell;   // 1 where rows stand, where a cell begins; else 0
    nck_motion_line_t reserve;            // so much more than at its rows is taken about a node
    nck_motion_line_t p1[NCK_AXIS_MAX], p2[NCK_AXIS_MAX]; // p′/(2τA), p″/A
} nck_motion_t;

// Begin a window: nck_motion_node then sets every node 0 … nodes − 1.
// work: its memory until nck_motion_step says NCK_DONE.
// NCK_OK, or NCK_E_ARGUMENT: something is out of the range that nck_motion_wish_t has.
// Cost: the size of both. Context: prep only.
nck_status_t nck_motion_begin(nck_motion_t *self, nck_motion_work_t *work,
                              const nck_motion_wish_t *wish);

// Set node k: p′ [mm/s] and p″ [mm/s²] of each axis over the clock, the cap of b (> 0; it holds
// feed and axis speeds), and a guess of b (> 0, or 0 at a last node that is a rest), which may
// break limits by far. Cost: linear in axes. Context: prep only.
void nck_motion_node(nck_motion_t *self, int k, const nck_num *p1, const nck_num *p2,
                     const nck_num *cap_and_b);

// Do a slice of an iteration: a chunk of NCK_MOTION_LANES nodes, or one pass over all of them that
// is as cheap. NCK_OK: call again; NCK_DONE: nck_motion_b and nck_motion_told have the answer.
// Cost: at most 6500 instructions an axis and 40 a node of the window, without vectors.
// Context: prep only.
nck_status_t nck_motion_step(nck_motion_t *self);

// What the next step takes at most, in hundreds of a PC's instructions without vectors.
// Cost: constant. Context: prep only.
uint32_t nck_motion_price(const nck_motion_t *self);

// b at node k. Cost: constant. Context: prep only.
nck_num nck_motion_b(const nck_motion_t *self, int k);

// Which limit the finished motion takes most of at node k: its cap, or an axis' acceleration or
// jerk. What is beyond its cap is not held by it. Cost: linear in axes. Context: prep only.
nck_motion_hold_t nck_motion_hold(const nck_motion_t *self, int k);

// What has come out. Cost: constant. Context: prep only.
void nck_motion_told(const nck_motion_t *self, nck_motion_told_t *told_out);

#ifdef __cplusplus
}
#endif

#endif
