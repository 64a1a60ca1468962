// SPDX-License-Identifier: MIT
// Inside room 3: what a spacing of knots would do to the path around a block's end, by a few points
// of it.
#include "nck/prep/3_smooth/estimate.h"

#include <stddef.h> // NULL

#include "nck/base/budget.h"               // NCK_UNLIMITED
#include "nck/prep/3_smooth/raw.h"         // nck_raw_…
#include "nck/prep/3_smooth/spline_math.h" // nck_spline_…

#define CURVED 0.3
#define SHARP 0.4
enum { POINTS = 7 }; // of the path that tell a curve from noise

// What of the path around a block's end, a spacing h to either side, is known from now on. The
// newest block may yet change, and what is behind it is not known.
static const nck_look_t *look_around(nck_smooth_t *self, uint32_t count, double h) {
    for (int k = 0; k < 2; k++) {
        const nck_look_t *const known = &self->run.look[k];
        const int is_that = known->h == h && known->count == count;
        if (is_that && known->tail == self->raw.tail) return known;
    }
    const nck_raw_t *const raw = nck_raw_at(self, count);
    const double *const here = raw->seg.end;
    const double s = raw->s + raw->seg.length;
    const double before = s - 2.0 * h;
    const double places[3] = {before, before + h, s + h};
    double p[3][NCK_AXIS_MAX];
    nck_look_t *const look = &self->run.look[self->run.looks++ % 2];
    nck_raw_points(self, count, places, 3, p, NULL);
    for (int x = 0; x < self->terms->axes; x++) {
        look->before[x] = nck_spline_bend(p[0][x], p[1][x], here[x]);
        look->middle[x] = nck_spline_bend(p[1][x], here[x], p[2][x]);
        look->behind[x] = p[2][x];
    }
    look->count = count;
    look->tail = self->raw.tail;
    look->h = places[2] <= nck_raw_at(self, self->run.end - 1)->s ? h : 0.0;
    return look;
}

double nck_estimate_plain(nck_smooth_t *self, uint32_t count, double h, int rough) {
    const nck_raw_t *const raw = nck_raw_at(self, count);
    const double *const here = raw->seg.end;
    const double furthest = raw->s + raw->seg.length + h + h;
    double p[1][NCK_AXIS_MAX];
    double off[NCK_AXIS_MAX];
    const int axes = self->terms->axes;
    const double at_side = rough ? 1.25 : -1.0;
    const double at_middle = rough ? 11.0 : 2.0;
    const nck_look_t *const look = look_around(self, count, h);
    nck_raw_points(self, count, &furthest, 1, p, NULL);
    for (int x = 0; x < axes; x++) {
        const double sides = look->before[x] + nck_spline_bend(here[x], look->behind[x], p[0][x]);
        off[x] = at_middle * look->middle[x] + at_side * sides;
    }
    return nck_spline_norm(off, axes) / 36.0;
}

// δ²p over h/2 is a quarter of that over h on a curve, and half of it at a corner.
static int power_of(double half, double whole) {
    const double ratio = half / whole;
    if (ratio < CURVED) return 4;
    return ratio < SHARP ? 2 : 1;
}

nck_estimate_t nck_estimate_nine(nck_smooth_t *self, uint32_t count, double h) {
    const nck_raw_t *const raw = nck_raw_at(self, count);
    const double *const here = raw->seg.end;
    const double s = raw->s + raw->seg.length;
    const double places[3] = {s - 0.5 * h, s + 0.5 * h, s + h + h};
    double p[3][NCK_AXIS_MAX];
    double off[NCK_AXIS_MAX];
    double half[NCK_AXIS_MAX];
    const int axes = self->terms->axes;
    const nck_look_t *const look = look_around(self, count, h);
    nck_raw_points(self, count, places, 3, p, NULL);
    for (int x = 0; x < axes; x++) {
        half[x] = nck_spline_bend(p[0][x], here[x], p[1][x]);
        const double sides = look->before[x] + nck_spline_bend(here[x], look->behind[x], p[2][x]);
        off[x] = 11.5 * half[x] - 0.875 * look->middle[x] - sides;
    }
    const nck_estimate_t estimate = {
        nck_spline_norm(off, axes) / 36.0,
        power_of(nck_spline_norm(half, axes), nck_spline_norm(look->middle, axes))};
    return estimate;
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
    const double s = raw->s + raw->seg.length;
    double p[POINTS][NCK_AXIS_MAX];
    double places[POINTS];
    for (int k = 0; k < POINTS; k++) places[k] = s - 3.0 * h + h * (double)k;
    nck_raw_points(self, count, places, 3, p, NULL);
    if (bends_of(self, p, 1) > most) return NCK_UNLIMITED;
    nck_raw_points(self, count, places + 3, POINTS - 3, p + 3, NULL);
    return bends_of(self, p, POINTS - 2);
}
