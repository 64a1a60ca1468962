// SPDX-License-Identifier: MIT
// Inside room 3: samples of a window, and the proof of |r − p| ≤ P between them.
#include "nck/prep/3_smooth/sample.h"

#include <string.h> // memcpy

#include "nck/base/path.h" // nck_path_second_part
#include "nck/base/real.h" // nck_fabs nck_max nck_min nck_sqrt

#define PLENTY 8      // bins of the window may have as many samples as this one without its choice
#define PARTS 8       // of a stretch, where its bound is not within P
#define REST_BINS 16  // of an interval on the way to a rest, over which s is as good as straight
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

// c: four control points.
static void set_cubic(int axes, const double *const *c, cubic_t *cubic_out) {
    for (int x = 0; x < axes; x++) {
        cubic_out->of[x][0] = (c[0][x] + 4.0 * c[1][x] + c[2][x]) / 6.0;
        cubic_out->of[x][1] = (c[2][x] - c[0][x]) / 2.0;
        cubic_out->of[x][2] = (c[0][x] - 2.0 * c[1][x] + c[2][x]) / 2.0;
        cubic_out->of[x][3] = (c[3][x] - c[0][x] + 3.0 * (c[1][x] - c[2][x])) / 6.0;
    }
}

static void set_interval(const nck_stream_t *self, int i, cubic_t *cubic_out) {
    const double *const c[4] = {self->point[i], self->point[i + 1], self->point[i + 2],
                                self->point[i + 3]};
    set_cubic(self->track.axes, c, cubic_out);
}

static double curve_at(const cubic_t *cubic, int x, double w) {
    const double *const of = cubic->of[x];
    return of[0] + w * (of[1] + w * (of[2] + w * of[3]));
}

// How far the curve is from the point, over `unit`. Returns the distance's square.
static double set_off(const nck_stream_t *self, const cubic_t *cubic, double w, const double *point,
                      double *off_out) {
    double sum = 0.0;
    for (int x = 0; x < self->track.axes; x++) {
        off_out[x] = (curve_at(cubic, x, w) - point[x]) / self->unit;
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

// Elements and tolerance of a bin whose ends are known.
static void set_elements(nck_stream_t *self, bin_t *bin_out) {
    const nck_track_t *const track = &self->track;
    const double *const s = bin_out->s;
    bin_out->first = nck_track_find(track, self->near, s[0]);
    self->near = bin_out->first;
    bin_out->last = nck_track_find(track, self->near, s[1]);
    bin_out->tolerance = 1e9;
    for (uint32_t n = bin_out->first; n != bin_out->last + 1; n++) {
        bin_out->tolerance = nck_min(bin_out->tolerance, (double)nck_track_at(track, n)->tolerance);
    }
}

static void set_bin(nck_stream_t *self, int i, int k, bin_t *bin_out) {
    memcpy(bin_out->s, &self->clock.s[4 * i + k], sizeof bin_out->s);
    bin_out->w[0] = 0.25 * k;
    bin_out->w[1] = 0.25 * (k + 1);
    set_elements(self, bin_out);
}

// Where in the interval the program comes to s.
static double place_of(const bin_t *bin, double s) {
    const double way = bin->s[1] - bin->s[0];
    const double share = way > 0.0 ? nck_min(nck_max((s - bin->s[0]) / way, 0.0), 1.0) : 0.0;
    return bin->w[0] + share * (bin->w[1] - bin->w[0]);
}

// Of the tolerance what the curve may be off at samples: less by what may lie between them [mm].
static double room_of(const nck_stream_t *self, double tolerance) {
    const double quarter = 0.25 * self->wish.terms.tau;
    const double lies_between = self->wish.terms.a_most * quarter * quarter / 8.0;
    return nck_max(tolerance - ROUNDING - lies_between, 0.5 * tolerance);
}

// s in the middle of a bin, as its neighbours let expect: straight between its ends it would be off
// by a tenth of a micrometre, at full acceleration.
static double middle_of(const nck_timing_t *clock, int bin) {
    const double *const s = &clock->s[bin];
    const double middle = bin > 0 ? (9.0 * (s[0] + s[1]) - s[-1] - s[2]) / 16.0
                                  : (3.0 * s[0] + 6.0 * s[1] - s[2]) / 8.0;
    return nck_min(nck_max(middle, s[0]), s[1]);
}

static void add_point(nck_stream_t *self, const cubic_t *cubic, double w, const double *point) {
    double off[NCK_AXIS_MAX];
    (void)set_off(self, cubic, w, point, off);
    for (int n = 0; n < self->moving; n++) off[n] = off[self->axis[n]]; // axes go up
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
static void fill_bin(nck_stream_t *self, const cubic_t *cubic, const bin_t *bin, double middle) {
    double point[NCK_AXIS_MAX];
    find_point(self, middle, point);
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
    nck_fair_close_bin(&self->work.fair,
                       self->share * room_of(self, bin->tolerance) / self->unit);
}

void nck_sample_interval(nck_stream_t *self, int i) {
    const nck_timing_terms_t *const terms = &self->wish.terms;
    const double per = 1.0 / (terms->j_least * terms->tau * terms->tau * terms->tau);
    cubic_t cubic;
    double jerk[NCK_AXIS_MAX];
    set_interval(self, i, &cubic);
    for (int n = 0; n < self->moving; n++) jerk[n] = 6.0 * cubic.of[self->axis[n]][3] * per;
    nck_fair_set_jerk(&self->work.fair, i, jerk);
    for (int k = 0; k < NCK_FAIR_BINS; k++) {
        bin_t bin;
        set_bin(self, i, k, &bin);
        fill_bin(self, &cubic, &bin, middle_of(&self->clock, NCK_FAIR_BINS * i + k));
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

// A stretch of an interval with no vertex in it.
typedef struct reach {
    uint32_t element;
    double s[2]; // of the program
    double w[2]; // of the interval
} reach_t;

// The most |r − p| along it, s straight over w [mm].
static double most_along(const nck_stream_t *self, const cubic_t *cubic, const reach_t *on) {
    const double way = on->w[1] - on->w[0];
    const double rate = way > 0.0 ? (on->s[1] - on->s[0]) / way : 0.0;
    stand_t from = {.w = on->w[0]};
    stand_t to = {.w = on->w[1]};
    set_stand(self, cubic, on->element, on->s[0], rate, &from);
    set_stand(self, cubic, on->element, on->s[1], rate, &to);
    return most_between(&from, &to, self->track.axes);
}

// s of the program that is next to a point, near another s in the element n.
static double nearest(const nck_stream_t *self, uint32_t n, double s, const double *point) {
    nck_seg_t seg;
    double here[NCK_AXIS_MAX];
    double tangent[NCK_AXIS_MAX];
    double along = 0.0;
    nck_track_point(&self->track, n, s, here);
    nck_track_seg(&self->track, n, &seg);
    nck_path_tangent_part(&seg, s - nck_track_at(&self->track, n)->s, self->track.axes, tangent);
    for (int x = 0; x < self->track.axes; x++) along += (point[x] - here[x]) * tangent[x];
    return s + along;
}

// The same, s as it is best at places within: any s does that never goes back.
static double most_along_parts(const nck_stream_t *self, const cubic_t *cubic,
                               const reach_t *on) {
    double most = 0.0;
    double point[NCK_AXIS_MAX];
    reach_t part = *on;
    for (int k = 1; k <= PARTS; k++) {
        const double share = (double)k / PARTS;
        const double s = on->s[0] + (on->s[1] - on->s[0]) * share;
        part.w[1] = on->w[0] + (on->w[1] - on->w[0]) * share;
        for (int x = 0; x < self->track.axes; x++) point[x] = curve_at(cubic, x, part.w[1]);
        part.s[1] = k < PARTS ? nearest(self, on->element, s, point) : on->s[1];
        part.s[1] = nck_min(nck_max(part.s[1], part.s[0]), on->s[1]);
        most = nck_max(most, most_along(self, cubic, &part));
        part.s[0] = part.s[1];
        part.w[0] = part.w[1];
    }
    return most;
}

// The most |r − p|/P in a bin.
static double bin_miss(const nck_stream_t *self, const cubic_t *cubic, const bin_t *bin) {
    double most = 0.0;
    reach_t on = {.w = {bin->w[0], 0.0}};
    for (uint32_t n = bin->first; n != bin->last + 1; n++) {
        const nck_track_element_t *const element = nck_track_at(&self->track, n);
        const double room = (double)element->tolerance - ROUNDING;
        on.element = n;
        on.s[0] = nck_max(bin->s[0], element->s);
        on.s[1] = n == bin->last ? bin->s[1] : element->s + element->length;
        on.w[1] = n == bin->last ? bin->w[1] : place_of(bin, on.s[1]);
        double off = most_along(self, cubic, &on);
        if (off > room) off = nck_min(off, most_along_parts(self, cubic, &on));
        most = nck_max(most, (off + ROUNDING) / (double)element->tolerance);
        on.w[0] = on.w[1];
    }
    return most;
}

double nck_sample_miss(nck_stream_t *self, int i) {
    double most = 0.0;
    cubic_t cubic;
    set_interval(self, i, &cubic);
    for (int k = 0; k < NCK_FAIR_BINS; k++) {
        bin_t bin;
        set_bin(self, i, k, &bin);
        most = nck_max(most, bin_miss(self, &cubic, &bin));
    }
    return most;
}

// The uniform cubic B-spline of four coefficients.
static double spline_of(const double *c, double w) {
    const double v = 1.0 - w;
    const double second = (4.0 + w * w * (3.0 * w - 6.0)) / 6.0;
    const double third = (4.0 + v * v * (3.0 * v - 6.0)) / 6.0;
    return (c[0] * v * v * v + c[3] * w * w * w) / 6.0 + c[1] * second + c[2] * third;
}

// s of the program on the way to a rest behind the joint, as coefficients of a spline: as near to
// the control points as can be, between knots; then ways that halve.
static void set_places(nck_stream_t *self, const double *s, nck_sample_rest_t *rest) {
    double *const place = rest->place;
    for (int n = 1; n < 3; n++) {
        self->near = nck_track_find(&self->track, self->near, s[n - 1]);
        const double here = nearest(self, self->near, s[n - 1], rest->point[n]);
        place[n] = nck_min(nck_max(here, n == 1 ? s[0] : place[1]), s[n]);
    }
    place[0] = nck_min(6.0 * s[0] - 4.0 * place[1] - place[2], place[1]);
    double way = place[2] - place[1];
    for (int n = 3; n < NCK_SAMPLE_REST + 1; n++) {
        way *= 0.5;
        place[n] = place[n - 1] + way;
    }
    place[NCK_SAMPLE_REST + 1] = place[NCK_SAMPLE_REST];
    place[NCK_SAMPLE_REST + 2] = place[NCK_SAMPLE_REST];
}

// A control point next to three points of the program: as far outside of the middle one as keeps
// the curve on them, a sixth of what that is off the others' chord.
static void set_outside(int axes, const double *before, const double *behind, double *point) {
    double along = 0.0;
    double square = 0.0;
    for (int x = 0; x < axes; x++) {
        const double chord = behind[x] - before[x];
        along += (before[x] + behind[x] - 2.0 * point[x]) * chord;
        square += chord * chord;
    }
    const double share = square > 0.0 ? along / square : 0.0;
    for (int x = 0; x < axes; x++) {
        const double chord = behind[x] - before[x];
        point[x] -= (before[x] + behind[x] - 2.0 * point[x] - share * chord) / 6.0;
    }
}

void nck_sample_rest(nck_stream_t *self, const double *s, nck_sample_rest_t *rest) {
    double way[3][NCK_AXIS_MAX];
    set_places(self, s, rest);
    for (int n = 2; n < 4; n++) find_point(self, rest->place[n], way[n - 1]);
    for (int n = 3; n < NCK_SAMPLE_REST + 3; n++) {
        memcpy(way[0], way[1], sizeof way[0]);
        memcpy(way[1], way[2], sizeof way[1]);
        memcpy(rest->point[n], rest->point[2], sizeof rest->point[n]); // axes that never move
        memcpy(rest->point[n], way[1], (size_t)self->track.axes * sizeof way[1][0]);
        if (n >= NCK_SAMPLE_REST) continue;
        find_point(self, rest->place[n + 1], way[2]);
        set_outside(self->track.axes, way[0], way[2], rest->point[n]);
    }
}

double nck_sample_rest_miss(nck_stream_t *self, const nck_sample_rest_t *rest, int i) {
    const double *const c[4] = {rest->point[i], rest->point[i + 1], rest->point[i + 2],
                                rest->point[i + 3]};
    double most = 0.0;
    cubic_t cubic;
    set_cubic(self->track.axes, c, &cubic);
    for (int n = 0; n < REST_BINS; n++) {
        bin_t bin = {.w = {(double)n / REST_BINS, (double)(n + 1) / REST_BINS}};
        bin.s[0] = spline_of(&rest->place[i], bin.w[0]);
        bin.s[1] = nck_max(spline_of(&rest->place[i], bin.w[1]), bin.s[0]);
        set_elements(self, &bin);
        most = nck_max(most, bin_miss(self, &cubic, &bin));
    }
    return most;
}
