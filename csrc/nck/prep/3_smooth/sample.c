// SPDX-License-Identifier: MIT
// Inside room 3: samples of a window, and the proof of |r − p| ≤ P between them.
#include "nck/prep/3_smooth/sample.h"

#include <string.h> // memcpy

#include "nck/base/path.h" // nck_path_second_part
#include "nck/base/real.h" // nck_fabs nck_max nck_min nck_sqrt

#define PLENTY 8      // bins of the window may have as many samples as this one without its choice
#define ROUNDING 2e-6 // [mm] kept of the tolerance: setpoints are whole nanometres

// The program's point at s.
static void find_point(nck_stream_t *self, double s, double *point_out) {
    self->near = nck_track_find(&self->track, self->near, s);
    nck_track_point(&self->track, self->near, s, point_out);
}

void nck_sample_reference(nck_stream_t *self, int k) {
    const nck_timing_t *const clock = &self->clock;
    double *const point = self->point[k];
    memcpy(point, self->joint[k < 3 ? k : 2], sizeof self->point[k]); // axes that never move
    if (k < 3) return;
    if (clock->ends && k >= clock->knots) memcpy(point, self->track.end, sizeof self->point[k]);
    else find_point(self, clock->s[4 * (k - 1)], point);
}

// The curve in an interval: coefficients of w, w = 0 … 1, an axis a row.
typedef struct cubic {
    double of[NCK_AXIS_MAX][4];
} cubic_t;

static void set_cubic(const nck_stream_t *self, int i, cubic_t *cubic_out) {
    const double (*const c)[NCK_AXIS_MAX] = &self->point[i];
    for (int x = 0; x < self->track.axes; x++) {
        cubic_out->of[x][0] = (c[0][x] + 4.0 * c[1][x] + c[2][x]) / 6.0;
        cubic_out->of[x][1] = (c[2][x] - c[0][x]) / 2.0;
        cubic_out->of[x][2] = (c[0][x] - 2.0 * c[1][x] + c[2][x]) / 2.0;
        cubic_out->of[x][3] = (c[3][x] - c[0][x] + 3.0 * (c[1][x] - c[2][x])) / 6.0;
    }
}

// How far the curve is from the point, over `unit`. Returns the distance's square.
static double set_off(const nck_stream_t *self, const cubic_t *cubic, double w, const double *point,
                      double *off_out) {
    double sum = 0.0;
    for (int x = 0; x < self->track.axes; x++) {
        const double *const of = cubic->of[x];
        off_out[x] = (of[0] + w * (of[1] + w * (of[2] + w * of[3])) - point[x]) / self->unit;
        sum += off_out[x] * off_out[x];
    }
    return sum;
}

// A bin while its samples are chosen.
typedef struct bin {
    double s[2];    // of the program
    double w[2];    // of the interval
    uint32_t first; // element at its begin
    uint32_t last;  // and at its end
    double tolerance; // the least of them [mm]
} bin_t;

static void set_bin(nck_stream_t *self, int i, int k, bin_t *bin_out) {
    const double *const s = &self->clock.s[4 * i + k];
    const nck_track_t *const track = &self->track;
    bin_out->s[0] = s[0];
    bin_out->s[1] = s[1];
    bin_out->w[0] = 0.25 * k;
    bin_out->w[1] = 0.25 * (k + 1);
    bin_out->first = nck_track_find(track, self->near, s[0]);
    self->near = bin_out->first;
    bin_out->last = nck_track_find(track, self->near, s[1]);
    bin_out->tolerance = 1e9;
    for (uint32_t n = bin_out->first; n != bin_out->last + 1; n++) {
        bin_out->tolerance = nck_min(bin_out->tolerance, (double)nck_track_at(track, n)->tolerance);
    }
}

// Where in the interval the program comes to s.
static double place_of(const bin_t *bin, double s) {
    const double way = bin->s[1] - bin->s[0];
    return bin->w[0] + 0.25 * (way > 0.0 ? nck_min(nck_max((s - bin->s[0]) / way, 0.0), 1.0) : 0.0);
}

static void add_point(nck_stream_t *self, const cubic_t *cubic, double w, const double *point) {
    double off[NCK_AXIS_MAX];
    (void)set_off(self, cubic, w, point, off);
    nck_fair_add_sample(&self->work.fair, w, off);
}

// Add the begin of an element as a sample: it is within the bin.
static void add_vertex(nck_stream_t *self, const cubic_t *cubic, const bin_t *bin, uint32_t n) {
    const nck_track_element_t *const element = nck_track_at(&self->track, n);
    add_point(self, cubic, place_of(bin, element->s), element->start);
}

// How far the begin of an element is off the bin's chord, as a vector; its square.
static double aside(const nck_stream_t *self, const bin_t *bin, const double *from,
                    const double *to, uint32_t n, double *aside_out) {
    const nck_track_element_t *const element = nck_track_at(&self->track, n);
    const double f = 4.0 * (place_of(bin, element->s) - bin->w[0]);
    double sum = 0.0;
    for (int x = 0; x < self->track.axes; x++) {
        aside_out[x] = element->start[x] - (from[x] + (to[x] - from[x]) * f);
        sum += aside_out[x] * aside_out[x];
    }
    return sum;
}

// Of many vertices in a bin, over which the curve is as good as straight: the one that is furthest
// aside, and the one that is furthest to its other side.
static void add_extremes(nck_stream_t *self, const cubic_t *cubic, const bin_t *bin) {
    double ends[2][NCK_AXIS_MAX];
    double here[NCK_AXIS_MAX];
    double most[NCK_AXIS_MAX];
    nck_track_point(&self->track, bin->first, bin->s[0], ends[0]);
    nck_track_point(&self->track, bin->last, bin->s[1], ends[1]);
    uint32_t best[2] = {bin->first + 1, bin->first + 1};
    double top = -1.0;
    for (uint32_t n = bin->first + 1; n != bin->last + 1; n++) {
        const double square = aside(self, bin, ends[0], ends[1], n, here);
        if (!(square > top)) continue;
        top = square;
        best[0] = n;
        memcpy(most, here, sizeof most);
    }
    double other = 0.0;
    for (uint32_t n = bin->first + 1; n != bin->last + 1; n++) {
        (void)aside(self, bin, ends[0], ends[1], n, here);
        double along = 0.0;
        for (int x = 0; x < self->track.axes; x++) along += here[x] * most[x];
        if (!(along < other) && other < 0.0) continue;
        other = along;
        best[1] = n;
    }
    add_vertex(self, cubic, bin, best[0]);
    if (best[1] != best[0]) add_vertex(self, cubic, bin, best[1]);
}

// Add the middle of what an arc has in the bin: it is furthest from the chord of its ends.
static void add_arc(nck_stream_t *self, const cubic_t *cubic, const bin_t *bin, uint32_t n) {
    const nck_track_element_t *const element = nck_track_at(&self->track, n);
    double point[NCK_AXIS_MAX];
    if (element->kind != NCK_SEG_ARC || nck_fair_room(&self->work.fair) <= 0) return;
    const double begin = nck_max(bin->s[0], element->s);
    const double middle = 0.5 * (begin + nck_min(bin->s[1], element->s + element->length));
    nck_track_point(&self->track, n, middle, point);
    add_point(self, cubic, place_of(bin, middle), point);
}

// The samples of a bin: its middle, vertices, and arcs among them.
static void fill_bin(nck_stream_t *self, const cubic_t *cubic, const bin_t *bin) {
    double point[NCK_AXIS_MAX];
    find_point(self, 0.5 * (bin->s[0] + bin->s[1]), point);
    add_point(self, cubic, 0.5 * (bin->w[0] + bin->w[1]), point);
    const uint32_t vertices = bin->last - bin->first;
    if (vertices > 2 && (int)vertices > nck_fair_room(&self->work.fair) / PLENTY) {
        add_extremes(self, cubic, bin);
    } else {
        for (uint32_t n = 1; n <= vertices; n++) add_vertex(self, cubic, bin, bin->first + n);
    }
    for (uint32_t n = bin->first; vertices > 0 && n != bin->last + 1; n++) {
        add_arc(self, cubic, bin, n);
    }
    const double quarter = 0.25 * self->wish.terms.tau;
    const double lies_between = self->wish.terms.a_most * quarter * quarter / 8.0;
    const double room = bin->tolerance - ROUNDING - lies_between;
    nck_fair_close_bin(&self->work.fair,
                       self->share * nck_max(room, 0.5 * bin->tolerance) / self->unit);
}

void nck_sample_interval(nck_stream_t *self, int i) {
    const nck_timing_terms_t *const terms = &self->wish.terms;
    const double per = 1.0 / (terms->j_least * terms->tau * terms->tau * terms->tau);
    cubic_t cubic;
    double jerk[NCK_AXIS_MAX];
    set_cubic(self, i, &cubic);
    for (int x = 0; x < terms->axes; x++) jerk[x] = 6.0 * cubic.of[x][3] * per;
    nck_fair_set_jerk(&self->work.fair, i, jerk);
    for (int k = 0; k < NCK_FAIR_BINS; k++) {
        bin_t bin;
        set_bin(self, i, k, &bin);
        fill_bin(self, &cubic, &bin);
    }
}

// A place where the curve is held against the program.
typedef struct stand {
    double w;                  // of the interval
    double off;                // |r − p| [mm]
    double bend[NCK_AXIS_MAX]; // r″ − p″ over w [mm]
    double drift;              // most |p‴| over w: how that changes apart from r‴ [mm]
} stand_t;

// Hold them against each other at s of the element n; rate: ds/dw there.
static void set_stand(const nck_stream_t *self, const cubic_t *cubic, uint32_t n, double s,
                      double rate, stand_t *stand) {
    const int axes = self->track.axes;
    const nck_track_element_t *const element = nck_track_at(&self->track, n);
    double point[NCK_AXIS_MAX];
    double off[NCK_AXIS_MAX];
    nck_track_point(&self->track, n, s, point);
    stand->off = self->unit * nck_sqrt(set_off(self, cubic, stand->w, point, off));
    for (int x = 0; x < axes; x++) {
        stand->bend[x] = 2.0 * cubic->of[x][2] + 6.0 * cubic->of[x][3] * stand->w;
    }
    stand->drift = 0.0;
    if (element->kind != NCK_SEG_ARC) return;
    nck_seg_t seg;
    nck_track_seg(&self->track, n, &seg);
    nck_path_second_part(&seg, nck_max(s - element->s, 0.0), axes, off);
    double square = 0.0;
    for (int x = 0; x < axes; x++) {
        stand->bend[x] -= off[x] * rate * rate;
        square += off[x] * off[x];
    }
    const double turn = nck_fabs(element->arc.sweep) / element->length;
    stand->drift = nck_sqrt(square) * turn * rate * rate * rate;
}

static double size_of(const double *vector, int axes) {
    double sum = 0.0;
    for (int x = 0; x < axes; x++) sum += vector[x] * vector[x];
    return nck_sqrt(sum);
}

// The most |r − p| from one place to another with no vertex between. A function whose second
// derivative is no more than c leaves its chord by no more than c h²/8.
static double most_between(const stand_t *a, const stand_t *b, int axes) {
    const double h = b->w - a->w;
    const double bend = nck_max(size_of(a->bend, axes), size_of(b->bend, axes));
    return nck_max(a->off, b->off) + (bend + 0.5 * h * nck_max(a->drift, b->drift)) * h * h / 8.0;
}

// The most |r − p|/P in a bin.
static double bin_miss(const nck_stream_t *self, const cubic_t *cubic, const bin_t *bin) {
    const double rate = 4.0 * (bin->s[1] - bin->s[0]);
    double most = 0.0;
    stand_t from = {.w = bin->w[0]};
    for (uint32_t n = bin->first; n != bin->last + 1; n++) {
        const nck_track_element_t *const element = nck_track_at(&self->track, n);
        const double begin = nck_max(bin->s[0], element->s);
        const double end = n == bin->last ? bin->s[1] : element->s + element->length;
        stand_t to = {.w = n == bin->last ? bin->w[1] : place_of(bin, end)};
        set_stand(self, cubic, n, begin, rate, &from);
        set_stand(self, cubic, n, end, rate, &to);
        const double off = most_between(&from, &to, self->track.axes) + ROUNDING;
        most = nck_max(most, off / (double)element->tolerance);
        from.w = to.w;
    }
    return most;
}

double nck_sample_miss(nck_stream_t *self, int i) {
    double most = 0.0;
    cubic_t cubic;
    set_cubic(self, i, &cubic);
    for (int k = 0; k < NCK_FAIR_BINS; k++) {
        bin_t bin;
        set_bin(self, i, k, &bin);
        most = nck_max(most, bin_miss(self, &cubic, &bin));
    }
    return most;
}
