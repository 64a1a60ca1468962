// SPDX-License-Identifier: MIT
// Inside room 3: the programmed path of a run, as far as it is known.
#ifndef NCK_PREP_RAW_H
#define NCK_PREP_RAW_H

#include "nck/prep/3_smooth/smooth.h" // nck_smooth_t nck_raw_t

// What is only rounding beside a place of the run: nearer places are one [path mm].
double nck_raw_least(double s);

// The block with this count. Cost: constant.
static inline nck_raw_t *nck_raw_at(nck_smooth_t *self, uint32_t count) {
    return &self->raw.at[count & (NCK_SMOOTH_ROWS - 1)];
}

// 1 if the ring has no room. Cost: constant.
static inline int nck_raw_is_full(const nck_smooth_t *self) {
    return self->raw.head - self->raw.tail == NCK_SMOOTH_ROWS;
}

// Where a block ends in its run [path mm]. Cost: constant.
static inline double nck_raw_end(const nck_raw_t *raw) { return raw->s + raw->seg.length; }

// The first block of the run that has length and ends at s or behind it; the run's last one if none
// does. Cost: logarithmic in NCK_SMOOTH_SPAN, and linear in outputs in a row.
uint32_t nck_raw_find(nck_smooth_t *self, double s);

// The next block with length behind this one; run.end if there is none. Cost: linear in outputs.
static inline uint32_t nck_raw_next(nck_smooth_t *self, uint32_t count) {
    uint32_t next = count + 1;
    while (next != self->run.end && !nck_raw_at(self, next)->has_seg) next++;
    return next;
}

// The block with length before this one; this one if it is not known any more. Cost: linear in
// outputs between them.
static inline uint32_t nck_raw_before(nck_smooth_t *self, uint32_t count) {
    uint32_t before = count;
    do {
        if (before == self->raw.tail) return count;
    } while (!nck_raw_at(self, --before)->has_seg);
    return before;
}

// The last seg of the run. Cost: linear in the outputs behind it.
static inline uint32_t nck_raw_last(nck_smooth_t *self) {
    uint32_t count = self->run.end - 1;
    while (!nck_raw_at(self, count)->has_seg) count--;
    return count;
}

// 1 if a block takes so long that an operator who goes block by block rests at its end: it stays a
// piece of its own, even on one line with others. Cost: constant.
int nck_raw_is_long(const nck_smooth_t *self, const nck_seg_t *seg);

// Where the known part of the run ends [path mm]. Cost: linear in outputs at its end.
static inline double nck_raw_known(nck_smooth_t *self) {
    return nck_raw_end(nck_raw_at(self, nck_raw_last(self)));
}

// The point of the programmed path at s, of it the coordinates that may change; beyond what is
// known, straight on along the tangent.
// Cost: as nck_raw_find.
void nck_raw_point(nck_smooth_t *self, double s, double *point_out);

// So many points of it, at places that go up. near: a block of the run. off: how many blocks behind
// it to look for each; told anew, so that the next look at places alike is quick. 0: not known.
// Cost: as so many of nck_raw_find at most.
void nck_raw_points(nck_smooth_t *self, uint32_t near, const double *places, int count,
                    double (*points_out)[NCK_AXIS_MAX], uint32_t *off);

// One of them, which mostly is behind what is known. off: as above, of it alone. Cost: as
// nck_raw_find.
void nck_raw_ahead(nck_smooth_t *self, uint32_t near, double s, double *point_out, uint32_t *off);

// So many of them, a step apart from s on: NCK_RAW_SPREAD points at most.
enum { NCK_RAW_SPREAD = 9 };
void nck_raw_spread(nck_smooth_t *self, double s, double step, int count,
                    double (*points_out)[NCK_AXIS_MAX]);

// How sharply the path turns from one seg to the next: Δu of the unit tangents, so many axes of it;
// returns |Δu|. Cost: constant.
double nck_raw_turn(const nck_seg_t *in, const nck_seg_t *out, int axes, double *turn_out);

// |dp/ds| along a line the ends of which may have been moved. Cost: constant.
double nck_raw_stretch(const nck_raw_t *raw, int axes);

// The curvature |p″| of an exact seg, the same all along it [1/mm], over so many axes; 0 of a line.
// Cost: constant.
double nck_raw_curvature(const nck_seg_t *seg, int axes);

// What the program says of a motion, from one seg to another. Cost: constant.
static inline void nck_raw_take_words(const nck_seg_t *from, nck_seg_t *seg) {
    seg->line = from->line;
    seg->modes = from->modes;
    seg->block = from->block;
    seg->rapid = from->rapid;
    seg->keeps = from->keeps;
    seg->feed = from->feed;
    seg->feed_scale = from->feed_scale;
    seg->spin = from->spin;
}

// 1 if the spindle means different things to two segs.
static inline int nck_raw_spins_differ(const nck_seg_t *a, const nck_seg_t *b) {
    return a->spin.speed != b->spin.speed || a->spin.most != b->spin.most
           || a->spin.per_rev != b->spin.per_rev || a->spin.x != b->spin.x;
}

// The run's spline between t[first + 2] and t[first + 3], as a seg without words; a line where the
// path is straight. Cost: as nck_raw_find.
void nck_raw_spline(nck_smooth_t *self, int first, nck_seg_t *seg_out);

// Begin to compare that spline with the path. Cost: as nck_raw_find.
void nck_raw_begin_fit(nck_smooth_t *self, int first);

// Whether it keeps to a share of the tolerance, or has no length. Returns NCK_OK (call again),
// NCK_DONE (it does), NCK_E_STATE (it does not).
// Cost: two points for each of 8 blocks, and 9.
nck_status_t nck_raw_fit(nck_smooth_t *self, int first, double share);

#endif
