// SPDX-License-Identifier: MIT
// Two motions that overlap at a corner: the end of one, from rest backward, and the begin of the
// next. Both are all but straight there, and the place is their sum.
#ifndef NCK_BASE_OVERLAP_MATH_H
#define NCK_BASE_OVERLAP_MATH_H

#include "nck/base/limits.h"    // NCK_HAS_OPTIMAL
#include "nck/base/machine.h"   // nck_machine_t NCK_SLOPE_OPTIMAL
#include "nck/base/real.h"      // nck_fabs nck_min nck_max nck_sqrt
#include "nck/base/records.h"   // NCK_SEG_LINE
#include "nck/base/root_math.h" // nck_root_cube

// Where they overlap a spline's tangent differs from that at the corner by so much at most.
#define NCK_OVERLAP_TURN 0.015

// An axis that one of them hardly moves takes so much of its jerk at most, where its own is 1.
#define NCK_OVERLAP_LITTLE 1.1

// How long motions may overlap where no axis moves opposite ways, or may [s].
#define NCK_OVERLAP_FREE 1e9

// The two motions.
typedef struct nck_overlap {
    const double *in, *out; // dp/ds at the corner, before and behind it
    double j[2];            // along either path [path mm/s³]
    double turn[2];         // by how much either dp/ds may differ near to it
} nck_overlap_t;

// By how much a motion along a seg of this kind may turn there. Cost: constant.
static inline double nck_overlap_turn(uint8_t kind) {
    return kind == NCK_SEG_LINE ? 0.0 : NCK_OVERLAP_TURN;
}

// While the first motion has the distance δ left to go and the second has come as far, the path is
//        e·n + δ·w,     w = out − in
// off the corner, further to its inside than at any other time: `in` and `out` are the tangents, n
// leads to its outside, and there, `outside` = e ≤ tolerance off it, the first would rest. With
// along = −n·w and turn = |w| > 0 that distance keeps to the tolerance. Returns δ, (P + e)/turn
// where n and w are opposite. Cost: a division and a root.
static inline double nck_overlap_distance(double tolerance, double outside, double along,
                                          double turn) {
    const double by = outside * along;
    const double within = tolerance * tolerance - outside * outside;
    return (by + nck_sqrt(by * by + turn * turn * within)) / (turn * turn);
}

// How long either motion takes for the distance d next to the corner: d = j·t³/6.
static inline double nck_overlap_time(double d, double j) { return nck_root_cube(6.0 * d / j); }

// What both do on an axis: its share of their jerk, as large as it may be near to the corner.
// Returns > 0 if they move it the same way, or may; < 0: opposite ways; 0: one does not move it.
static inline double nck_overlap_axis(const nck_overlap_t *self, int x, double part_out[2]) {
    const double sign = self->in[x] * self->out[x];
    const int turns = (self->turn[0] > 0.0 && nck_fabs(self->in[x]) <= self->turn[0])
                      || (self->turn[1] > 0.0 && nck_fabs(self->out[x]) <= self->turn[1]);
    part_out[0] = (nck_fabs(self->in[x]) + self->turn[0]) * self->j[0];
    part_out[1] = (nck_fabs(self->out[x]) + self->turn[1]) * self->j[1];
    return turns ? 1.0 : sign;
}

// 1 if both together keep to the path's own limits, too: under the optimal slope these are the
// tool's, under the jerk-limited one each motion's.
static inline int nck_overlap_keeps_path(const nck_machine_t *machine) {
    return NCK_HAS_OPTIMAL && machine->slope == NCK_SLOPE_OPTIMAL;
}

// in·out. Cost: linear in the axes.
static inline double nck_overlap_dot(const nck_machine_t *machine, int axes,
                                     const nck_overlap_t *self) {
    double dot = 0.0;
    for (int x = 0; x < axes; x++) {
        if (machine->axis[x].present) dot += self->in[x] * self->out[x];
    }
    return dot;
}

// The square of the jerk along the path of both at once, to the same side in time or, where it is
// more, in any order. Cost: linear in the axes.
static inline double nck_overlap_both(const nck_machine_t *machine, int axes,
                                      const nck_overlap_t *self, int ordered) {
    const double dot = nck_overlap_dot(machine, axes, self);
    double jj[2] = {0.0, 0.0};
    for (int x = 0; x < axes; x++) {
        if (!machine->axis[x].present) continue;
        for (int n = 0; n < 2; n++) {
            const double part = self->j[n] * (n ? self->out[x] : self->in[x]);
            jj[n] += part * part;
        }
    }
    const double both = 2.0 * self->j[0] * self->j[1] * (ordered ? dot : nck_fabs(dot));
    return nck_max(jj[0] + jj[1] + both, nck_max(jj[0], jj[1]));
}

// The largest share that both take in sum of an axis' jerk, or of the path's own, in their order
// in time or in any. Cost: linear in the axes.
static inline double nck_overlap_taken(const nck_machine_t *machine, int axes,
                                       const nck_overlap_t *self, int ordered) {
    double most = 0.0;
    if (nck_overlap_keeps_path(machine)) {
        const double both = nck_sqrt(nck_overlap_both(machine, axes, self, ordered));
        const double turn = self->turn[0] * self->j[0] + self->turn[1] * self->j[1];
        most = (both + turn) / machine->path.j_max;
    }
    for (int x = 0; x < axes; x++) {
        double part[2];
        if (!machine->axis[x].present) continue;
        const int adds = nck_overlap_axis(self, x, part) > 0.0 || !ordered;
        const double sum = adds ? part[0] + part[1] : nck_max(part[0], part[1]);
        most = nck_max(most, sum / machine->axis[x].j_max);
    }
    return most;
}

// Both motions have their jerk to the same side in time: the deceleration of the one goes, the
// acceleration of the other comes. On an axis that both move along the same way it adds up; where
// they move opposite ways only the larger counts. Returns the sum's largest share of an axis' jerk.
// Cost: linear in the axes.
static inline double nck_overlap_jerk(const nck_machine_t *machine, int axes,
                                      const nck_overlap_t *self) {
    return nck_overlap_taken(machine, axes, self, 1);
}

// 1 if an axis moves in both. Cost: linear in the axes.
static inline int nck_overlap_shares(const nck_machine_t *machine, int axes,
                                     const nck_overlap_t *self) {
    for (int x = 0; x < axes; x++) {
        double part[2];
        if (machine->axis[x].present && nck_overlap_axis(self, x, part) != 0.0) return 1;
    }
    return 0;
}

// What both do on an axis adds up at most, whichever way and in whatever order: the sum's largest
// share of an axis' jerk. Up to 1 the order in time does not matter. Cost: linear in the axes.
static inline double nck_overlap_sum(const nck_machine_t *machine, int axes,
                                     const nck_overlap_t *self) {
    return nck_overlap_taken(machine, axes, self, 0);
}

// What both keep to a share 1/load of their jerk for: any order, if that costs next to nothing.
// Cost: linear in the axes.
static inline double nck_overlap_load(const nck_machine_t *machine, int axes,
                                      const nck_overlap_t *self) {
    const double sum = nck_overlap_sum(machine, axes, self);
    return sum <= NCK_OVERLAP_LITTLE ? sum : nck_overlap_jerk(machine, axes, self);
}

// Where they move opposite ways their accelerations add up, to no more than t·j at any time.
// So do those along the path, where it turns back. Returns how long the motions may overlap by that
// [s]. Cost: linear in the axes.
static inline double nck_overlap_most(const nck_machine_t *machine, int axes,
                                      const nck_overlap_t *self) {
    double most = NCK_OVERLAP_FREE;
    if (nck_overlap_keeps_path(machine)) {
        if (nck_overlap_dot(machine, axes, self) < self->turn[0] + self->turn[1]) {
            most = machine->path.a_max / nck_max(self->j[0], self->j[1]);
        }
    }
    for (int x = 0; x < axes; x++) {
        double part[2];
        if (!machine->axis[x].present) continue;
        const double sign = nck_overlap_axis(self, x, part);
        if (sign == 0.0 || (sign > 0.0 && !(self->turn[0] + self->turn[1] > 0.0))) continue;
        most = nck_min(most, machine->axis[x].a_max / nck_max(part[0], part[1]));
    }
    return most;
}

#endif
