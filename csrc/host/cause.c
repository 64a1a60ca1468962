// SPDX-License-Identifier: MIT
// Causes of lost time, and their worst places.
#include "host/cause.h"

#include <string.h> // memmove memset

#include "nck/base/real.h" // nck_fabs nck_max nck_min

// What loses less is no place to be told of [s].
#define LEAST_S 1e-6
#define RAD_PER_DEG 0.017453292519943295

void nck_host_cause_sum(nck_host_sum_t *self, double value) {
    const double sum = self->sum + value;
    const int is_larger = nck_fabs(self->sum) >= nck_fabs(value);
    self->rest += is_larger ? (self->sum - sum) + value : (value - sum) + self->sum;
    self->sum = sum;
}

// Corners of about the same angle belong together.
static uint32_t class_of(double angle) {
    static const double most_deg[NCK_HOST_ANGLES - 1] = {
        0.5, 1.0, 2.0, 5.0, 10.0, 20.0, 40.0, 70.0, 100.0, 140.0, 175.0
    };
    uint32_t k = 0;
    while (k < NCK_HOST_ANGLES - 1 && angle > most_deg[k] * RAD_PER_DEG) k++;
    return k;
}

static uint32_t row_of(const nck_host_low_t *low) {
    const uint32_t limits = NCK_LIMIT_AXIS_V + NCK_AXIS_MAX;
    if (low->ends) return limits + NCK_HOST_ANGLES;
    if (low->limit == NCK_LIMIT_CORNER) return limits + class_of(low->angle);
    return low->limit;
}

static void close_place(nck_host_cause_t *self) {
    const nck_host_place_t place = self->open;
    uint32_t k = self->place_count;
    if (place.count == 0) return;
    self->open.count = 0;
    while (k > 0 && self->places[k - 1].lost_s < place.lost_s) k--;
    if (k == NCK_HOST_PLACES) return;
    if (self->place_count < NCK_HOST_PLACES) self->place_count++;
    const size_t behind = self->place_count - 1 - k;
    memmove(&self->places[k + 1], &self->places[k], behind * sizeof place);
    self->places[k] = place;
}

static int is_near(const nck_host_place_t *place, uint32_t line) {
    return line + NCK_HOST_LINE_GAP >= place->line_first
           && line <= place->line_last + NCK_HOST_LINE_GAP;
}

static void extend_place(nck_host_cause_t *self, const nck_host_low_t *low, uint32_t counts) {
    nck_host_place_t *const place = &self->open;
    if (place->count > 0 && !is_near(place, low->line)) close_place(self);
    if (place->count == 0) {
        memset(place, 0, sizeof *place);
        place->line_first = low->line;
        place->line_last = low->line;
        counts = 1;
    }
    if (low->line < place->line_first) place->line_first = low->line;
    if (low->line > place->line_last) place->line_last = low->line;
    place->count += counts;
    place->lost_s += low->lost_s;
    if (low->lost_s <= place->worst_s) return;
    place->worst_s = low->lost_s;
    place->line_worst = low->line;
    place->axis = low->axis;
    place->angle = low->angle;
}

void nck_host_cause_add(nck_host_cause_t *causes, const nck_host_low_t *low) {
    nck_host_cause_t *const cause = &causes[row_of(low)];
    const int is_first = cause->count == 0;
    cause->limit = low->limit;
    cause->ends = low->ends;
    nck_host_cause_sum(&cause->lost_s, low->lost_s);
    cause->axis_s[low->axis] += low->lost_s;
    if (low->lost_s < LEAST_S) return;
    const uint32_t counts = is_first || cause->seg != low->seg;
    cause->seg = low->seg;
    cause->count += counts;
    cause->angle_least = is_first ? low->angle : nck_min(cause->angle_least, low->angle);
    cause->angle_most = is_first ? low->angle : nck_max(cause->angle_most, low->angle);
    extend_place(cause, low, counts);
}

void nck_host_cause_end(nck_host_cause_t *causes) {
    for (uint32_t k = 0; k < NCK_HOST_CAUSES; k++) close_place(&causes[k]);
}
