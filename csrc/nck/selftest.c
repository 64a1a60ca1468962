// SPDX-License-Identifier: MIT
// Formulas of the rooms computed from fixed numbers, and a hash of the bits that come out.
#include "nck/base/bits.h" // what may not be compiled at all

#include "nck/nck_tools.h"

#include <string.h> // memcpy memset

#include "nck/base/envelope_math.h"           // nck_envelope_h nck_envelope_backward
#include "nck/base/fence.h"                   // nck_fence_load
#include "nck/base/path.h"                    // nck_path_tangent_part and its kin
#include "nck/base/path_math.h"               // nck_path_part
#include "nck/base/root_math.h"               // nck_root_cube
#include "nck/base/scurve_math.h"             // nck_scurve_reach
#include "nck/prep/4_lookahead/limit_math.h"  // nck_limit_chord nck_corner_speed
#include "nck/prep/5_slope/hull_math.h"       // nck_hull_rise
#include "nck/prep/5_slope/ladder_math.h"     // nck_ladder_step

enum {
    ROUNDS = 16, // a fused operation differs in one of four results: never equal in so many
    AXES = 3     // that every build has
};

#define COUNT(of) ((int)(sizeof(of) / sizeof *(of)))

typedef struct selftest {
    uint64_t hash;
    uint32_t seed; // read through the fence, so that no compiler computes ahead what follows
} selftest_t;

// FNV-1a over words of 64 bits (Fowler, Noll, Vo, Eastlake: The FNV Non-Cryptographic Hash
// Algorithm, 2012), with its constants.
static void take(selftest_t *self, const double *value, int count) {
    for (int n = 0; n < count; n++) {
        uint64_t bits;
        memcpy(&bits, &value[n], sizeof bits);
        self->hash = (self->hash ^ bits) * 0x100000001b3u;
    }
}

// 32 bits of a linear congruential generator (D. E. Knuth, The Art of Computer Programming, volume
// 2, 1997, section 3.3.4, table 1, line 16).
static double draw_bits(selftest_t *self) {
    self->seed = nck_fence_load(&self->seed) * 1664525u + 1013904223u;
    return (double)self->seed;
}

// A number in 1 … 2 with all its digits.
static double draw(selftest_t *self) {
    const double high = draw_bits(self);
    return 1.0 + (high + draw_bits(self) / 4294967296.0) / 4294967296.0;
}

// Every rounding by itself, in the order that is written: sums, products and quotients that another
// order, a fused operation or a reciprocal gives other last digits.
static void take_arithmetic(selftest_t *self) {
    const double a = draw(self);
    const double b = draw(self);
    const double c = draw(self);
    const double found[] = {a * b - c, a * b + c * c, (a + b) - a, a / c, b / c, a * 3.0 / 7.0,
                            ((a + b) + c) + a, nck_sqrt(a), 1.0 / nck_sqrt(b),
                            nck_floor(a * 1e6 + 0.5)};
    take(self, found, COUNT(found));
}

// Numbers below 2⁻¹⁰²² are not flushed to 0.
static void take_small(selftest_t *self) {
    const double tiny = draw(self) * DBL_MIN;
    const double below = tiny / 1024.0;
    const double found[] = {below, below * 1024.0};
    take(self, found, COUNT(found));
}

static void take_trig(selftest_t *self) {
    double s, c;
    nck_sincos(100.0 * draw(self), &s, &c);
    const double y = draw(self);
    const double x = draw(self);
    const double found[] = {s, c, nck_atan2(y, x), nck_atan2(-y, 1e-3 * x),
                            nck_root_cube(1e3 * draw(self))};
    take(self, found, COUNT(found));
}

// A point of the seg, and what it turns by there.
static void take_path(selftest_t *self, const nck_seg_t *seg) {
    double found[4 * AXES];
    const double s = 0.4 * draw(self) * seg->length;
    nck_path_part(seg, s, AXES, found);
    nck_path_tangent_part(seg, s, AXES, found + AXES);
    nck_path_second_part(seg, s, AXES, found + 2 * AXES);
    nck_path_third_part(seg, s, AXES, found + 3 * AXES);
    take(self, found, COUNT(found));
}

static void take_arc(selftest_t *self, nck_seg_t *seg) {
    memset(seg, 0, sizeof *seg);
    seg->kind = NCK_SEG_ARC;
    for (int x = 0; x < AXES; x++) seg->start[x] = 10.0 * draw(self);
    for (int x = 0; x < AXES; x++) seg->end[x] = 10.0 * draw(self);
    seg->shape.arc.axis_v = 1;
    seg->shape.arc.sweep = draw(self);
    seg->length = 10.0 * draw(self);
    take_path(self, seg);
}

static void take_spline(selftest_t *self, nck_seg_t *seg) {
    memset(seg, 0, sizeof *seg);
    seg->kind = NCK_SEG_SPLINE;
    for (int x = 0; x < AXES; x++) {
        seg->start[x] = draw(self);
        seg->shape.inner[0][x] = 10.0 * draw(self);
        seg->shape.inner[1][x] = 20.0 * draw(self);
        seg->end[x] = 30.0 * draw(self);
    }
    seg->length = draw(self);
    take_path(self, seg);
}

// What speeds are made of.
static void take_slope(selftest_t *self) {
    const double a = 1e3 * draw(self);
    const double j = 1e4 * draw(self);
    const double v = 10.0 * draw(self);
    const double way = 5.0 * draw(self);
    const double load = 1e-4 * draw(self);
    const nck_scurve_t ramp = {a, j, 200.0};
    const nck_hull_cell_t cell = {0.02 * way, a, j, 0.01};
    const nck_ladder_piece_t piece = {0.1 * v, 0.1 * way, 1e4, a, j};
    const double gain = nck_envelope_h(a, way);
    const double rise = 100.0 * draw(self);
    const double step = draw(self);
    const double chord = 1e-3 * draw(self);
    const double found[] = {nck_envelope_backward(1e9, v * v, gain),
                            nck_scurve_reach(&ramp, v, way), nck_scurve_over(&ramp, v, way),
                            nck_hull_rise(&cell, v, rise, 200.0),
                            nck_ladder_step(&piece, way, step, 1e-3),
                            nck_limit_chord(v, chord, 1e-3),
                            nck_corner_speed(0.5, load, 0.1 * load, load * v, a, 1e-3)};
    take(self, found, COUNT(found));
}

uint32_t nck_selftest(void) {
    selftest_t self = {0xcbf29ce484222325u, 1};
    nck_seg_t seg;
    for (int n = 0; n < ROUNDS; n++) {
        take_arithmetic(&self);
        take_small(&self);
        take_trig(&self);
        take_arc(&self, &seg);
        take_spline(&self, &seg);
        take_slope(&self);
    }
    return (uint32_t)(self.hash >> 32) ^ (uint32_t)self.hash;
}
