// SPDX-License-Identifier: MIT
// Inside room 3: what a spacing of knots would do to the path around a block's end, by a few points
// of it.
#include "nck/prep/3_smooth/estimate.h"

#include <stddef.h> // NULL

#include "nck/base/budget.h"               // NCK_UNLIMITED
#include "nck/base/real.h"                 // nck_max nck_sqrt
#include "nck/prep/3_smooth/raw.h"         // nck_raw_…
#include "nck/prep/3_smooth/spline_math.h" // nck_spline_…

#define CURVED 0.3
#define SHARP 0.4
#define SHRINK 0.98      // to be within the aim, and not just there
#define SHRINK_MOST 0.4  // at once
enum {
    POINTS = 7,      // of the path that tell a curve from noise
    SHRINK_STEPS = 3 // the plain estimate is 2.4 times too small at most
};

// How far a spline would leave the path, and with which power of its spacing that grows about
// there: 4 on a curve, 1 at a corner, 2 between them.
typedef struct estimate {
    double off; // [mm]
    int power;
} estimate_t;

// What is known so far is of this block's end, or nothing.
static void turn_to(nck_smooth_t *self, uint32_t count) {
    nck_looks_t *const looks = &self->run.looks;
    if (looks->count == count && looks->tail == self->raw.tail) return;
    nck_estimate_forget(self);
    looks->count = count;
    looks->tail = self->raw.tail;
}

// The path around a block's end, a spacing h to either side, is looked for.
static const nck_look_t *look_anew(nck_smooth_t *self, uint32_t count, double h) {
    nck_looked_t *const looked = &self->run.looked;
    const nck_raw_t *const raw = nck_raw_at(self, count);
    const double s = nck_raw_end(raw);
    const double before = s - 2.0 * h;
    const double places[3] = {before, before + h, s + h};
    uint32_t off[3] = {(uint32_t)looked->off[0], (uint32_t)(looked->off[0] / 2),
                       (uint32_t)looked->off[1]};
    double p[3][NCK_AXIS_MAX];
    looked->newest ^= 1u;
    nck_look_t *const look = &self->run.looks.at[looked->newest];
    const double *const here = raw->seg.end;
    nck_raw_points(self, count, places, 3, p, off);
    for (int x = 0; x < self->terms->axes; x++) {
        look->before[x] = nck_spline_bend(p[0][x], p[1][x], here[x]);
        look->middle[x] = nck_spline_bend(p[1][x], here[x], p[2][x]);
        look->behind[x] = p[2][x];
    }
    look->h = nck_estimate_is_known(self, places[2]) ? h : 0.0;
    looked->off[0] = (int16_t)off[0];
    looked->off[1] = (int16_t)off[2];
    return look;
}

// The same: what of it is known from now on is not looked for again; and the point two spacings
// behind it.
static inline const nck_look_t *look_around(nck_smooth_t *self, uint32_t count, double h,
                                            double *beyond_out) {
    const nck_looks_t *const looks = &self->run.looks;
    const double s = nck_raw_end(nck_raw_at(self, count));
    uint32_t at = (uint32_t)self->run.looked.off[2];
    turn_to(self, count);
    nck_raw_ahead(self, count, s + h + h, beyond_out, &at);
    for (int k = 0; k < 2; k++) {
        if (looks->at[k].h == h) return &looks->at[k];
    }
    self->run.looked.off[2] = (int16_t)at;
    return look_anew(self, count, h);
}

double nck_estimate_plain(nck_smooth_t *self, uint32_t count, double h, int rough) {
    const double *const here = nck_raw_at(self, count)->seg.end;
    const double at_side = rough ? 1.25 : -1.0;
    const double at_middle = rough ? 11.0 : 2.0;
    double beyond[NCK_AXIS_MAX];
    const nck_look_t *const look = look_around(self, count, h, beyond);
    double sum = 0.0;
    for (int x = 0; x < self->terms->axes; x++) {
        const double bend = nck_spline_bend(here[x], look->behind[x], beyond[x]);
        const double off = at_middle * look->middle[x] + at_side * (look->before[x] + bend);
        sum += off * off;
    }
    return nck_sqrt(sum) / 36.0;
}

// δ²p over h/2 is a quarter of that over h on a curve, and half of it at a corner.
static int power_of(double half, double whole) {
    if (!(whole > 0.0)) return 1; // nothing bends
    const double ratio = half / whole;
    if (ratio < CURVED) return 4;
    return ratio < SHARP ? 2 : 1;
}

// As nck_estimate_plain on a curve, with control points of nine points. What those add up of second
// differences is told by two of them, exact on a curve, where δ²p over h is four times that over
// h/2, and at a corner, where it is twice that:
//   p̃ − p = (23/2 δ²p(h/2) − 7/8 δ²p(h) − δ²p before − δ²p behind)/36
// So a corner is left by 0.135·|Δu|·h, where the plain estimate tells 0.056·|Δu|·h.
static estimate_t estimate_nine(nck_smooth_t *self, uint32_t count, double h) {
    const nck_raw_t *const raw = nck_raw_at(self, count);
    const double *const here = raw->seg.end;
    const double s = nck_raw_end(raw);
    const double places[2] = {s - 0.5 * h, s + 0.5 * h};
    double p[2][NCK_AXIS_MAX];
    double beyond[NCK_AXIS_MAX];
    double off[NCK_AXIS_MAX];
    double half[NCK_AXIS_MAX];
    const int axes = self->terms->axes;
    const nck_look_t *const look = look_around(self, count, h, beyond);
    uint32_t at[2] = {nck_estimate_off(self, -2), nck_estimate_off(self, 2)};
    nck_raw_points(self, count, places, 2, p, at);
    for (int x = 0; x < axes; x++) {
        half[x] = nck_spline_bend(p[0][x], here[x], p[1][x]);
        const double bend = nck_spline_bend(here[x], look->behind[x], beyond[x]);
        const double sides = look->before[x] + bend;
        off[x] = 11.5 * half[x] - 0.875 * look->middle[x] - sides;
    }
    const estimate_t estimate = {
        nck_spline_norm(off, axes) / 36.0,
        power_of(nck_spline_norm(half, axes), nck_spline_norm(look->middle, axes))};
    return estimate;
}

double nck_estimate_shrink(nck_smooth_t *self, uint32_t count, double aim, double spacing) {
    double good = spacing;
    for (int n = 0; n < SHRINK_STEPS; n++) {
        const estimate_t estimate = estimate_nine(self, count, good);
        if (estimate.off <= aim) break;
        double share = aim / estimate.off;
        if (estimate.power >= 2) share = nck_sqrt(share);
        if (estimate.power == 4) share = nck_sqrt(share);
        good *= nck_max(SHRINK_MOST, SHRINK * share);
    }
    return good;
}

// Σ |δ²p|² of so many places, h apart: of their points, and one more on either side.
static double bends_of(const nck_smooth_t *self, double (*p)[NCK_AXIS_MAX], int count) {
    const int axes = self->terms->axes;
    double sum = 0.0;
    for (int k = 1; k <= count; k++) {
        for (int x = 0; x < axes; x++) {
            const double bend = nck_spline_bend(p[k - 1][x], p[k][x], p[k + 1][x]);
            sum += bend * bend;
        }
    }
    return sum;
}

double nck_estimate_unevenness(nck_smooth_t *self, uint32_t count, double h, double most) {
    const nck_raw_t *const raw = nck_raw_at(self, count);
    const double s = nck_raw_end(raw);
    double p[POINTS][NCK_AXIS_MAX];
    double places[POINTS];
    uint32_t off[POINTS];
    for (int k = 0; k < POINTS; k++) places[k] = s - 3.0 * h + h * (double)k;
    const int bounded = most < NCK_UNLIMITED;
    const uint32_t before = nck_estimate_off(self, bounded ? -4 : -2);
    const uint32_t behind = nck_estimate_off(self, bounded ? 4 : 2);
    for (uint32_t k = 0; k < POINTS; k++) off[k] = k < 3 ? (3 - k) * before : (k - 3) * behind;
    nck_raw_points(self, count, places, 3, p, off);
    if (bounded && bends_of(self, p, 1) > most) return NCK_UNLIMITED;
    nck_raw_points(self, count, places + 3, POINTS - 3, p + 3, off + 3);
    return bends_of(self, p, POINTS - 2);
}
