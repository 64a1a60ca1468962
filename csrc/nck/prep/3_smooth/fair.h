// SPDX-License-Identifier: MIT
// Inside room 3: the smoothest uniform cubic B-spline within a tolerance of given points.
//
// Unknown are the control points' offsets y from those of a reference, in units of the tolerance P.
// Interval i has control points i … i + 3. The first three stay, and the last three where the path
// ends. Wanted is the least
//
//     Σ_i Σ_a x² + even x⁴  +  stay Σ_b |e_b|²      x = share_a (jerk_ia + scale·Δ³y_ia)
//                                                   |e| ≤ limit
//
// jerk: of the reference, over an axis' limit. What a motion takes goes by its largest jerk, to
// which a fourth power is nearer than a square: x⁴ evens jerk out. Beyond the limit, |x| > 1, the
// cost goes on as the parabola that it has there, for Newton's step takes all of a parabola and but
// a third of a fourth power, and the reference begins far off (10 iterations for 14).
// e: how far the curve is from a sample, over P. A bin is a quarter of an interval. It has one row,
// that of its worst sample, so the problem's size does not depend on the program. Primal-dual
// interior point method (S. Boyd and L. Vandenberghe, Convex Optimization, 2004, section 11.7),
// Newton steps by a banded L D Lᵀ.
#ifndef NCK_PREP_FAIR_H
#define NCK_PREP_FAIR_H

#include <stdint.h> // uint8_t uint16_t

#include "nck/base/limits.h" // NCK_AXIS_MAX NCK_CLOCKED_…
#include "nck/base/real.h"   // nck_num
#include "nck/base/status.h" // nck_status_t

// Sizes of a problem.
enum {
    NCK_FAIR_WINDOW = NCK_CLOCKED_WINDOW,   // intervals of a window
    NCK_FAIR_KNOTS = NCK_FAIR_WINDOW + 2, // of the last one at most
    NCK_FAIR_POINTS = NCK_FAIR_KNOTS + 3,
    NCK_FAIR_BINS = 4,                   // of an interval
    NCK_FAIR_ROWS = NCK_FAIR_KNOTS * NCK_FAIR_BINS,
    NCK_FAIR_SAMPLES = 2 * NCK_FAIR_ROWS // one a bin, and as many more where they are needed
};

// What is asked.
typedef struct nck_fair_task {
    int knots;        // intervals, 4 … NCK_FAIR_KNOTS
    int axes;         // 1 … NCK_AXIS_MAX
    int ends;         // 1: the last three control points stay, too; then 7 intervals at least
    int most;         // iterations at most
    nck_num gap;    // it is done when the answer is within this share of the best
    nck_num even;   // what the fourth power of a share of jerk counts beside its square
    nck_num scale;  // P/(J τ³), J: the least jerk of an axis
    nck_num stay;   // what a curve off its samples counts where jerk is far below its limit
    nck_num share[NCK_AXIS_MAX]; // J / jerk of the axis
} nck_fair_task_t;

// What a slice of work does.
typedef enum nck_fair_phase {
    NCK_FAIR_LOOK = 0, // take the last step, look at all rows: forward
    NCK_FAIR_SOLVE,    // build the Newton matrix, eliminate: forward
    NCK_FAIR_BACK,     // substitute, find how the rows change: backward
    NCK_FAIR_DONE
} nck_fair_phase_t;

// The problem and its answer. Arrays of so many axes a place are packed.
typedef struct nck_fair {
    nck_fair_task_t task;
    nck_fair_phase_t phase;
    int at;           // interval in work
    int slice;        // intervals a call
    int unknown;      // control points that may move
    int bins;         // filled so far
    int iterations;
    uint8_t sound;    // 1: y is the answer; 0: it is not found, or no curve is within the limits
    struct {
        nck_num mu;         // what s·z is led to
        nck_num objective;
        nck_num complement; // Σ s·z
        nck_num primal;     // most that a slack is off its row
        nck_num shrink;     // most by which a full step would shrink a slack, and a price, as a
        nck_num cheapen;    // share of it
        nck_num step;       // of the unknown and slacks, and of prices
        nck_num step_price;
    } sum;
    uint16_t first[NCK_FAIR_ROWS + 1]; // samples of a bin: first[b] … first[b + 1] − 1
    uint16_t kept[NCK_FAIR_ROWS];      // the sample that a row stands for
    nck_num place[NCK_FAIR_SAMPLES]; // of a sample in its interval, 0 … 1
    nck_num off[NCK_FAIR_SAMPLES * NCK_AXIS_MAX];     // the reference there, from the sample
    nck_num jerk[NCK_FAIR_KNOTS * NCK_AXIS_MAX];      // of the reference
    nck_num y[NCK_FAIR_POINTS * NCK_AXIS_MAX];        // the answer
    nck_num dy[NCK_FAIR_POINTS * NCK_AXIS_MAX];       // Newton's step
    nck_num limit[NCK_FAIR_ROWS];                     // most |e|² of a row
    nck_num slack[NCK_FAIR_ROWS];                     // s of a row, its price z,
    nck_num price[NCK_FAIR_ROWS];
    nck_num d_slack[NCK_FAIR_ROWS];                   // how s changes
    nck_num e[NCK_FAIR_ROWS * NCK_AXIS_MAX];          // off the kept sample
    nck_num band[NCK_FAIR_KNOTS * NCK_AXIS_MAX * 4 * NCK_AXIS_MAX]; // the matrix
} nck_fair_t;

// Begin a problem. Its intervals are then filled in order, each with its jerk and four bins.
// Cost: constant, and all of y. Context: prep.
void nck_fair_begin(nck_fair_t *self, const nck_fair_task_t *task);

// The reference's jerk in interval i, so many axes. Cost: constant. Context: prep.
void nck_fair_set_jerk(nck_fair_t *self, int i, const nck_num *jerk);

// Add a sample to the bin that is filled: its place in the interval, and how far the reference is
// off it, over P. What has no room is left out. Cost: constant. Context: prep.
void nck_fair_add_sample(nck_fair_t *self, nck_num place, const nck_num *off);

// Close the bin. limit: of |e|. It must have a sample. Cost: constant. Context: prep.
void nck_fair_close_bin(nck_fair_t *self, nck_num limit);

// So many samples still have room beside one for each bin to come. Cost: constant. Context: prep.
int nck_fair_room(const nck_fair_t *self);

// What a step takes at most, in hundreds of a PC's instructions without vectors. The last look of
// an iteration goes on with the next phase. Cost: constant. Context: prep.
static inline uint32_t nck_fair_price(const nck_fair_t *self) {
    static const uint8_t each[][3] = {{5, 16, 5}, {6, 21, 5}, {8, 42, 7}}; // an interval
    const int axes = self->task.axes < 3 ? self->task.axes : 3;
    const int solves = self->phase == NCK_FAIR_LOOK && self->at + self->slice > self->task.knots;
    return (uint32_t)self->slice * each[axes - 1][solves ? NCK_FAIR_SOLVE : self->phase];
}

// What holds the curve back in so many intervals from the i-th on: the prices of their rows.
// Cost: linear in them. Context: prep.
nck_num nck_fair_tightness(const nck_fair_t *self, int i, int intervals);

// Work on it: a slice of an iteration. Returns NCK_OK (call again); NCK_DONE: y is the answer.
// Cost: 8 000 operations or one interval. Context: prep.
nck_status_t nck_fair_step(nck_fair_t *self);

#endif
