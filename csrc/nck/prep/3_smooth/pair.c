// SPDX-License-Identifier: MIT
// Inside room 3: two sharp corners that are nearer to each other than their bends are wide.
//
//     ──────●─────●──┐      knots ● are even about the middle m of the short block:
//                    m      m ± h/2, m ± 3h/2 …, their control points on the path
//     ──────●─────●──┘
#include "nck/prep/3_smooth/pair.h"

#include "nck/base/real.h"                 // nck_min nck_max
#include "nck/prep/3_smooth/raw.h"         // nck_raw_…
#include "nck/prep/3_smooth/spline_math.h" // nck_spline_…

#define TURN_LEAST 0.5 // |Δu| of either corner, 29°: a curve's chords turn by less
#define AGAINST 0.25   // cosine of two turns that do not yet cancel each other
#define OTHERS 0.25    // of a corner's turn that the path beside both may make
#define LEAST 0.6      // of the corner's own spacing: where to begin to look
#define GROWTH 1.25    // between two spacings that are looked at
enum {
    GROWTH_STEPS = 5,
    BISECT_STEPS = 4   // the last 25 % to 1.5 %
};

// Both corners.
typedef struct couple {
    double s;             // the middle of the block between them [path mm]
    double length;        // of that block
    const double *end[2]; // its ends
    double turn;          // |Δu| of the first
    int axes;
} couple_t;

// How far the spline would leave the path at the middle and at the corners [mm].
static double off_by(nck_smooth_t *self, const couple_t *couple, double h) {
    double p[4][NCK_AXIS_MAX];
    double off[3][NCK_AXIS_MAX];
    double weight[4];
    nck_raw_spread(self, couple->s - 1.5 * h, h, 4, p);
    nck_spline_basis(0.5 - 0.5 * couple->length / h, weight);
    for (int x = 0; x < couple->axes; x++) {
        const double first = couple->end[0][x];
        const double last = couple->end[1][x];
        off[0][x] = -first;
        off[1][x] = -last;
        for (int k = 0; k < 4; k++) {
            off[0][x] += weight[k] * p[k][x];
            off[1][x] += weight[3 - k] * p[k][x];
        }
        off[2][x] = (p[0][x] + 23.0 * (p[1][x] + p[2][x]) + p[3][x]) / 48.0
                    - 0.5 * (first + last);
    }
    double worst = 0.0;
    for (int k = 0; k < 3; k++) worst = nck_max(worst, nck_spline_norm(off[k], couple->axes));
    return worst;
}

// The largest spacing within the aim, from a least one on; 0: not even that.
static double widest(nck_smooth_t *self, const couple_t *couple, double aim, double least) {
    double good = nck_max(couple->length, least);
    if (off_by(self, couple, good) > aim) return 0.0;
    double bad = good;
    for (int n = 0; n < GROWTH_STEPS && bad == good && good < self->spacing_max; n++) {
        bad = good * GROWTH;
        if (off_by(self, couple, bad) <= aim) good = bad;
    }
    for (int n = 0; n < BISECT_STEPS && bad > good; n++) {
        const double middle = 0.5 * (good + bad);
        if (off_by(self, couple, middle) <= aim) good = middle;
        else bad = middle;
    }
    return nck_min(good, self->spacing_max);
}

// 1 if the path beside both corners is known for 3h/2, and as good as straight there.
static int is_straight_beside(nck_smooth_t *self, const couple_t *couple, double h) {
    if (couple->s < 1.5 * h || couple->s + 1.5 * h > nck_raw_known(self)) return 0;
    for (int n = 0; n < 2; n++) {
        double p[3][NCK_AXIS_MAX];
        double by[NCK_AXIS_MAX];
        nck_raw_spread(self, couple->s + (n == 0 ? -2.5 : 0.5) * h, h, 3, p);
        for (int x = 0; x < couple->axes; x++) {
            by[x] = nck_spline_bend(p[0][x], p[1][x], p[2][x]);
        }
        if (nck_spline_norm(by, couple->axes) > OTHERS * couple->turn * h) return 0;
    }
    return 1;
}

int nck_pair_find(nck_smooth_t *self, uint32_t count, double aim, double *spacing_out) {
    const nck_raw_t *const raw = nck_raw_at(self, count);
    const uint32_t after = nck_raw_next(self, count);
    const uint32_t third = nck_raw_next(self, after);
    const nck_seg_t *const next = &nck_raw_at(self, after)->seg;
    const int axes = self->terms->axes;
    double turn[2][NCK_AXIS_MAX];
    double along = 0.0;
    if (third == self->run.end || !(next->length < 2.0 * *spacing_out)) return 0;
    const double first = nck_raw_turn(&raw->seg, next, axes, turn[0]);
    const double last = nck_raw_turn(next, &nck_raw_at(self, third)->seg, axes, turn[1]);
    for (int x = 0; x < axes; x++) along += turn[0][x] * turn[1][x];
    if (nck_min(first, last) < TURN_LEAST || along < -AGAINST * first * last) return 0;
    const couple_t couple = {raw->s + raw->seg.length + 0.5 * next->length, next->length,
                             {next->start, next->end}, first, axes};
    const double h = widest(self, &couple, aim, LEAST * *spacing_out);
    if (!(h > 0.0) || !is_straight_beside(self, &couple, h)) return 0;
    *spacing_out = h;
    return 1;
}
