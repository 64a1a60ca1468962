// SPDX-License-Identifier: MIT
// Inside room 3: a window's reference, the program at knots as a spline.
#include "nck/base/real.h" // nck_fabs nck_max
#include "nck/prep/3_smooth/reference.h"
#include "nck/prep/3_smooth/tuning.h" // NCK_REFERENCE_FOLLOWS

#include <string.h> // memcpy

void nck_reference_point(nck_stream_t *self, double s, double *point_out) {
    self->near = nck_track_find(&self->track, self->near, s);
    nck_track_point(&self->track, self->near, s, point_out);
}

// s at a knot; along a line the coefficient of a spline that has it there.
static double coefficient_of(nck_stream_t *self, int knot) {
    const double *const s = &self->clock.s[4 * knot];
    self->near = nck_track_find(&self->track, self->near, s[0]);
    const nck_track_element_t *const element = nck_track_at(&self->track, self->near);
    const int is_inside = s[-4] >= element->s && s[4] <= element->s + element->length;
    if (element->plane || !is_inside) return s[0];
    return s[0] - (s[-4] - 2.0 * s[0] + s[4]) / 6.0;
}

void nck_reference_set(nck_stream_t *self, int k) {
    const nck_timing_t *const clock = &self->clock;
    double *const point = self->point[k];
    memcpy(point, self->seam[k < 3 ? k : 2], sizeof self->point[k]); // axes that never move
    if (k < 3) return;
    if (clock->ends && k >= clock->knots) memcpy(point, self->track.end, sizeof self->point[k]);
    else nck_reference_point(self, coefficient_of(self, k - 1), point);
}

// s of a point along a line.
static double place_along(const nck_stream_t *self, const nck_track_element_t *line,
                          const double *point) {
    double way = 0.0;
    for (int x = 0; x < self->track.axes; x++) {
        way += (point[x] - line->start[x]) * (double)line->shape.way[x];
    }
    return line->s + way / line->length;
}

void nck_reference_follow(nck_stream_t *self, int i) {
    const nck_track_element_t *const line = nck_track_at(&self->track, self->near);
    double *const s = &self->clock.s[NCK_FAIR_BINS * i];
    const double *const before = i < 2 ? self->clock.s : s - 2 * NCK_FAIR_BINS;
    const double *const behind = i + 3 > self->clock.knots ? s : s + 3 * NCK_FAIR_BINS;
    double at[4];
    if (line->plane || *before < line->s || behind == s || *behind > line->s + line->length) return;
    for (int k = 0; k < 4; k++) at[k] = place_along(self, line, self->point[i + k]);
    const double c[4] = {(at[0] + 4.0 * at[1] + at[2]) / 6.0, (at[2] - at[0]) / 2.0,
                         (at[0] - 2.0 * at[1] + at[2]) / 2.0,
                         (at[3] - at[0] + 3.0 * (at[1] - at[2])) / 6.0};
    const double off = nck_max(nck_fabs(c[0] - s[0]),
                               nck_fabs(c[0] + c[1] + c[2] + c[3] - s[NCK_FAIR_BINS]));
    if (off > NCK_REFERENCE_FOLLOWS * (s[NCK_FAIR_BINS] - s[0])) return;
    const int first = i == 0; // a window's first s stays
    for (int k = first; k <= NCK_FAIR_BINS; k++) {
        const double w = 0.25 * (double)k;
        s[k] = c[0] + w * (c[1] + w * (c[2] + w * c[3]));
    }
}
