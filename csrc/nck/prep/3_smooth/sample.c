// SPDX-License-Identifier: MIT
// Inside room 3: samples of a window, and the proof of |r − p| ≤ P between them.
#include "nck/base/path.h" // nck_path_second_part
#include "nck/base/real.h" // nck_num_max nck_num_min …
#include "nck/prep/3_smooth/reference.h" // nck_reference_follow nck_reference_point
#include "nck/prep/3_smooth/sample.h"
#include "nck/prep/3_smooth/tuning.h" // NCK_ROUNDING

#include <string.h> // memcpy

#define LOSS (8 * NCK_NUM_EPSILON) // what eight sums lose of the largest number in them

// The curve in an interval, from a point of the program near it: coefficients of w, w = 0 … 1, an
// axis a row [mm].
typedef struct cubic {
    nck_track_view_t from;
    nck_num of[NCK_AXIS_MAX][4];
    nck_num loss; // what rounding may take of a distance from it [mm]
} cubic_t;

// c: four control points.
static void set_cubic(int axes, const double *const *c, cubic_t *cubic_out) {
    nck_num most = 0;
    for (int x = 0; x < axes; x++) {
        nck_num *const of = cubic_out->of[x];
        nck_num at[4];
        for (int k = 0; k < 4; k++) {
            at[k] = (nck_num)(c[k][x] - cubic_out->from.point[x]);
            most = nck_num_max(most, NCK_NUM_ABS(at[k]));
        }
        of[0] = (at[0] + 4 * at[1] + at[2]) / 6;
        of[1] = (at[2] - at[0]) / 2;
        of[2] = (at[0] - 2 * at[1] + at[2]) / 2;
        of[3] = (at[3] - at[0] + 3 * (at[1] - at[2])) / 6;
    }
    cubic_out->loss = LOSS * most;
}

static void set_interval(nck_stream_t *self, int i, cubic_t *cubic_out) {
    const double *const c[4] = {self->point[i], self->point[i + 1], self->point[i + 2],
                                self->point[i + 3]};
    const double s = self->clock.s[NCK_FAIR_BINS * i];
    self->near = nck_track_find(&self->track, self->near, s);
    nck_track_view(&self->track, self->near, s, &cubic_out->from);
    set_cubic(self->track.axes, c, cubic_out);
}

static nck_num curve_at(const cubic_t *cubic, int x, nck_num w) {
    const nck_num *const of = cubic->of[x];
    return of[0] + w * (of[1] + w * (of[2] + w * of[3]));
}

// How far the curve is from a point of the program [mm]. Returns the distance's square.
static nck_num set_off(const nck_stream_t *self, const cubic_t *cubic, nck_num w,
                       const nck_num *point, nck_num *off_out) {
    nck_num sum = 0;
    for (int x = 0; x < self->track.axes; x++) {
        off_out[x] = curve_at(cubic, x, w) - point[x];
        sum += off_out[x] * off_out[x];
    }
    return sum;
}

// A bin while its samples are chosen.
typedef struct bin {
    double s[2];       // of the program
    nck_num w[2];      // of the interval
    uint32_t first;    // element at its begin
    uint32_t last;     // and at its end
    nck_num tolerance; // the least of them [mm]
} bin_t;

// Elements and tolerance of a bin whose ends are known.
static void set_elements(nck_stream_t *self, bin_t *bin_out) {
    const nck_track_t *const track = &self->track;
    const double *const s = bin_out->s;
    bin_out->first = nck_track_find(track, self->near, s[0]);
    self->near = bin_out->first;
    bin_out->last = nck_track_find(track, self->near, s[1]);
    bin_out->tolerance = (nck_num)nck_track_at(track, bin_out->first)->tolerance;
    for (uint32_t n = bin_out->first + 1; n != bin_out->last + 1; n++) {
        const nck_num tolerance = (nck_num)nck_track_at(track, n)->tolerance;
        bin_out->tolerance = nck_num_min(bin_out->tolerance, tolerance);
    }
}

static void set_bin(nck_stream_t *self, int i, int k, bin_t *bin_out) {
    memcpy(bin_out->s, &self->clock.s[NCK_FAIR_BINS * i + k], sizeof bin_out->s);
    bin_out->w[0] = (nck_num)0.25 * (nck_num)k;
    bin_out->w[1] = (nck_num)0.25 * (nck_num)(k + 1);
    set_elements(self, bin_out);
}

// Where in the interval the program comes to s.
static nck_num place_of(const bin_t *bin, double s) {
    const nck_num way = (nck_num)(bin->s[1] - bin->s[0]);
    const nck_num share = way > 0 ? (nck_num)(s - bin->s[0]) / way : 0;
    if (!(share > 0)) return bin->w[0];
    return share < 1 ? bin->w[0] + share * (bin->w[1] - bin->w[0]) : bin->w[1];
}

static nck_num size_of(const nck_num *vector, int axes) {
    nck_num sum = 0;
    for (int x = 0; x < axes; x++) sum += vector[x] * vector[x];
    return NCK_NUM_SQRT(sum);
}

// r″ over w [mm].
static void set_bend(const cubic_t *cubic, int axes, nck_num w, nck_num *bend_out) {
    for (int x = 0; x < axes; x++) bend_out[x] = 2 * cubic->of[x][2] + 6 * cubic->of[x][3] * w;
}

// What may lie between two samples, as the last curve bends in the interval [mm].
static nck_num lies_between(const nck_stream_t *self, const cubic_t *cubic) {
    nck_num most = 0;
    for (int k = 0; k < 2 && self->round > 0; k++) {
        nck_num bend[NCK_AXIS_MAX] = {0};
        set_bend(cubic, self->track.axes, (nck_num)k, bend);
        most = nck_num_max(most, size_of(bend, self->track.axes));
    }
    return most / 128;
}

// s in the middle of a bin, as its neighbours let expect: straight between its ends it would be off
// by a tenth of a micrometre, at full acceleration.
static double middle_of(const nck_timing_t *clock, int bin) {
    const double *const s = &clock->s[bin];
    const nck_num way = (nck_num)(s[1] - s[0]);
    const nck_num behind = (nck_num)(s[2] - s[1]);
    nck_num part = (5 * way - behind) / 8;
    if (bin > 0) part = (8 * way + (nck_num)(s[0] - s[-1]) - behind) / 16;
    if (!(part > 0)) return s[0];
    return part < way ? s[0] + (double)part : s[1];
}

static void add_point(nck_stream_t *self, const cubic_t *cubic, nck_num w, const nck_num *point) {
    const nck_num per = 1 / (nck_num)self->unit;
    nck_num off[NCK_AXIS_MAX];
    (void)set_off(self, cubic, w, point, off);
    for (int n = 0; n < self->moving; n++) off[n] = per * off[self->axis[n]]; // axes go up
    nck_fair_add_sample(&self->work.fair, w, off);
}

// Add the begin of an element as a sample: it is within the bin.
static void add_vertex(nck_stream_t *self, cubic_t *cubic, const bin_t *bin, uint32_t n) {
    const double s = nck_track_at(&self->track, n)->s;
    nck_num point[NCK_AXIS_MAX];
    nck_track_offset(&self->track, &cubic->from, n, s, point);
    add_point(self, cubic, place_of(bin, s), point);
}

// A bin's chord: its begin, and from there to its end [mm].
typedef struct chord {
    nck_num begin[NCK_AXIS_MAX];
    nck_num way[NCK_AXIS_MAX];
} chord_t;

// How far the begin of an element is off the bin's chord, as a vector; its square.
static nck_num aside(const nck_stream_t *self, cubic_t *cubic, const bin_t *bin,
                     const chord_t *chord, uint32_t n, nck_num *aside_out) {
    const double s = nck_track_at(&self->track, n)->s;
    const nck_num f = (nck_num)NCK_FAIR_BINS * (place_of(bin, s) - bin->w[0]);
    nck_num sum = 0;
    nck_track_offset(&self->track, &cubic->from, n, s, aside_out);
    for (int x = 0; x < self->track.axes; x++) {
        aside_out[x] -= chord->begin[x] + chord->way[x] * f;
        sum += aside_out[x] * aside_out[x];
    }
    return sum;
}

static void set_chord(const nck_stream_t *self, cubic_t *cubic, const bin_t *bin,
                      chord_t *chord_out) {
    nck_track_offset(&self->track, &cubic->from, bin->first, bin->s[0], chord_out->begin);
    nck_track_offset(&self->track, &cubic->from, bin->last, bin->s[1], chord_out->way);
    for (int x = 0; x < self->track.axes; x++) chord_out->way[x] -= chord_out->begin[x];
}

// Of many vertices in a bin, over which the curve is as good as straight: the one that is furthest
// aside, and the one that is furthest to its other side.
static void add_extremes(nck_stream_t *self, cubic_t *cubic, const bin_t *bin) {
    chord_t chord;
    nck_num here[NCK_AXIS_MAX];
    nck_num most[NCK_AXIS_MAX];
    uint32_t best[2] = {bin->first + 1, bin->first + 1};
    nck_num top = -1;
    set_chord(self, cubic, bin, &chord);
    for (uint32_t n = bin->first + 1; n != bin->last + 1; n++) {
        const nck_num square = aside(self, cubic, bin, &chord, n, here);
        if (!(square > top)) continue;
        top = square;
        best[0] = n;
        memcpy(most, here, sizeof most);
    }
    nck_num other = 0;
    for (uint32_t n = bin->first + 1; n != bin->last + 1; n++) {
        (void)aside(self, cubic, bin, &chord, n, here);
        nck_num along = 0;
        for (int x = 0; x < self->track.axes; x++) along += here[x] * most[x];
        if (!(along < other) && other < 0) continue;
        other = along;
        best[1] = n;
    }
    add_vertex(self, cubic, bin, best[0]);
    if (best[1] != best[0]) add_vertex(self, cubic, bin, best[1]);
}

// Add the middle of what an arc has in the bin: it is furthest from the chord of its ends.
static void add_arc(nck_stream_t *self, cubic_t *cubic, const bin_t *bin, uint32_t n) {
    const nck_track_element_t *const element = nck_track_at(&self->track, n);
    nck_num point[NCK_AXIS_MAX];
    if (!element->plane || nck_fair_room(&self->work.fair) <= 0) return;
    const double begin = nck_max(bin->s[0], element->s);
    const double middle = 0.5 * (begin + nck_min(bin->s[1], element->s + element->length));
    nck_track_offset(&self->track, &cubic->from, n, middle, point);
    add_point(self, cubic, place_of(bin, middle), point);
}

// The samples of a bin: its middle, vertices, and arcs among them.
static void fill_bin(nck_stream_t *self, cubic_t *cubic, const bin_t *bin, double middle) {
    nck_num point[NCK_AXIS_MAX];
    self->near = nck_track_find(&self->track, self->near, middle);
    nck_track_offset(&self->track, &cubic->from, self->near, middle, point);
    add_point(self, cubic, (bin->w[0] + bin->w[1]) / 2, point);
    const uint32_t vertices = bin->last - bin->first;
    if (vertices > 2 && (int)vertices > nck_fair_room(&self->work.fair)) {
        add_extremes(self, cubic, bin);
    } else {
        for (uint32_t n = 1; n <= vertices; n++) add_vertex(self, cubic, bin, bin->first + n);
    }
    for (uint32_t n = bin->first; vertices > 0 && n != bin->last + 1; n++) {
        add_arc(self, cubic, bin, n);
    }
}

void nck_sample_interval(nck_stream_t *self, int i) {
    const nck_timing_terms_t *const terms = &self->wish.terms;
    double per = 6.0 / ((double)terms->smooth_least * terms->tau * terms->tau * terms->tau);
    cubic_t cubic;
    nck_num jerk[NCK_AXIS_MAX];
    set_interval(self, i, &cubic);
    const int held = i < 3 && !self->clock.begins; // by control points of the last window
    const nck_num share = held ? NCK_NUM_OF(NCK_STREAM_SHARE) : (nck_num)self->share;
    const nck_num kept = (nck_num)NCK_ROUNDING + (held ? 0 : lies_between(self, &cubic));
    nck_reference_follow(self, i);
    if (nck_timing_is_wide(&self->clock, &self->track, &self->near, i)) per = 0.0;
    for (int n = 0; n < self->moving; n++) jerk[n] = (nck_num)per * cubic.of[self->axis[n]][3];
    nck_fair_set_jerk(&self->work.fair, i, jerk);
    for (int k = 0; k < NCK_FAIR_BINS; k++) {
        bin_t bin;
        set_bin(self, i, k, &bin);
        fill_bin(self, &cubic, &bin, middle_of(&self->clock, NCK_FAIR_BINS * i + k));
        const nck_num room = nck_num_max(bin.tolerance - kept, bin.tolerance / 2);
        nck_fair_close_bin(&self->work.fair, share * room / (nck_num)self->unit);
    }
}

// A place where the curve is held against the program.
typedef struct stand {
    nck_num w;                  // of the interval
    nck_num off;                // |r − p| [mm]
    nck_num bend[NCK_AXIS_MAX]; // r″ − p″ over w [mm]
    nck_num drift;              // most |p‴| over w: how that changes apart from r‴ [mm]
} stand_t;

// What an arc bends beside the curve there.
static void set_arc_bend(const nck_stream_t *self, uint32_t n, double s, nck_num rate,
                         stand_t *stand) {
    const nck_track_element_t *const element = nck_track_at(&self->track, n);
    double second[NCK_AXIS_MAX];
    nck_seg_t seg;
    nck_num square = 0;
    nck_track_seg(&self->track, n, &seg);
    nck_path_second_part(&seg, nck_max(s - element->s, 0.0), self->track.axes, second);
    for (int x = 0; x < self->track.axes; x++) {
        stand->bend[x] -= (nck_num)second[x] * rate * rate;
        square += (nck_num)second[x] * (nck_num)second[x];
    }
    const nck_num turn = (nck_num)(nck_fabs(element->shape.arc.sweep) / element->length);
    stand->drift = NCK_NUM_SQRT(square) * turn * rate * rate * rate;
}

// Hold them against each other at s of the element n; rate: ds/dw there.
static void set_stand(const nck_stream_t *self, cubic_t *cubic, uint32_t n, double s,
                      nck_num rate, stand_t *stand) {
    nck_num point[NCK_AXIS_MAX];
    nck_num off[NCK_AXIS_MAX];
    nck_track_offset(&self->track, &cubic->from, n, s, point);
    stand->off = NCK_NUM_SQRT(set_off(self, cubic, stand->w, point, off));
    set_bend(cubic, self->track.axes, stand->w, stand->bend);
    stand->drift = 0;
    if (nck_track_at(&self->track, n)->plane) set_arc_bend(self, n, s, rate, stand);
}

// The most |r − p| from one place to another with no vertex between. A function whose second
// derivative is no more than c leaves its chord by no more than c h²/8.
static nck_num most_between(const stand_t *a, const stand_t *b, int axes) {
    const nck_num h = b->w - a->w;
    const nck_num bend = nck_num_max(size_of(a->bend, axes), size_of(b->bend, axes));
    const nck_num drift = nck_num_max(a->drift, b->drift);
    return nck_num_max(a->off, b->off) + (bend + h * drift / 2) * h * h / 8;
}

// A stretch of an interval with no vertex in it.
typedef struct reach {
    uint32_t element;
    double s[2];  // of the program
    nck_num w[2]; // of the interval
} reach_t;

// The most |r − p| along it, s straight over w [mm].
static nck_num most_along(const nck_stream_t *self, cubic_t *cubic, const reach_t *on) {
    const nck_num way = on->w[1] - on->w[0];
    const nck_num rate = way > 0 ? (nck_num)(on->s[1] - on->s[0]) / way : 0;
    stand_t from = {.w = on->w[0]};
    stand_t to = {.w = on->w[1]};
    set_stand(self, cubic, on->element, on->s[0], rate, &from);
    set_stand(self, cubic, on->element, on->s[1], rate, &to);
    return most_between(&from, &to, self->track.axes);
}

// s of the program that is next to a point, which is `off` its point at another s in the element n.
static double nearest(const nck_stream_t *self, uint32_t n, double s, const nck_num *off) {
    nck_num tangent[NCK_AXIS_MAX];
    nck_num along = 0;
    nck_track_tangent(&self->track, n, s, tangent);
    for (int x = 0; x < self->track.axes; x++) along += off[x] * tangent[x];
    return s + (double)along;
}

// The same in parts. Any s does at places within that never goes back: it is straight, or that
// which is next to the curve (of a circle as small as P its tangent knows nothing).
static nck_num most_along_parts(const nck_stream_t *self, cubic_t *cubic, const reach_t *on,
                                int is_straight) {
    nck_num most = 0;
    nck_num point[NCK_AXIS_MAX];
    nck_num off[NCK_AXIS_MAX];
    reach_t part = *on;
    for (int k = 1; k <= NCK_SAMPLE_PARTS; k++) {
        const nck_num share = (nck_num)k / (nck_num)NCK_SAMPLE_PARTS;
        const double s = on->s[0] + (on->s[1] - on->s[0]) * (double)share;
        part.w[1] = on->w[0] + (on->w[1] - on->w[0]) * share;
        nck_track_offset(&self->track, &cubic->from, on->element, s, point);
        (void)set_off(self, cubic, part.w[1], point, off);
        part.s[1] = is_straight ? s : nearest(self, on->element, s, off);
        part.s[1] = nck_min(nck_max(part.s[1], part.s[0]), on->s[1]);
        if (k == NCK_SAMPLE_PARTS) part.s[1] = on->s[1];
        most = nck_num_max(most, most_along(self, cubic, &part));
        part.s[0] = part.s[1];
        part.w[0] = part.w[1];
    }
    return most;
}

// The most |r − p|/P in a bin.
static nck_num bin_miss(const nck_stream_t *self, cubic_t *cubic, const bin_t *bin) {
    const nck_num kept = (nck_num)NCK_ROUNDING + cubic->loss;
    nck_num most = 0;
    reach_t on = {.w = {bin->w[0], 0}};
    for (uint32_t n = bin->first; n != bin->last + 1; n++) {
        const nck_track_element_t *const element = nck_track_at(&self->track, n);
        const nck_num room = (nck_num)element->tolerance - kept;
        on.element = n;
        on.s[0] = nck_max(bin->s[0], element->s);
        on.s[1] = n == bin->last ? bin->s[1] : element->s + element->length;
        on.w[1] = n == bin->last ? bin->w[1] : place_of(bin, on.s[1]);
        nck_num off = most_along(self, cubic, &on);
        for (int k = 0; k < 2 && off > room; k++) {
            off = nck_num_min(off, most_along_parts(self, cubic, &on, k));
        }
        most = nck_num_max(most, (off + kept) / (nck_num)element->tolerance);
        on.w[0] = on.w[1];
    }
    return most;
}

double nck_sample_miss(nck_stream_t *self, int i) {
    nck_num most = 0;
    cubic_t cubic;
    set_interval(self, i, &cubic);
    for (int k = 0; k < NCK_FAIR_BINS; k++) {
        bin_t bin;
        set_bin(self, i, k, &bin);
        most = nck_num_max(most, bin_miss(self, &cubic, &bin));
    }
    return (double)most;
}

// The uniform cubic B-spline of four coefficients, near the second one.
static double spline_of(const double *c, nck_num w) {
    const nck_num v = 1 - w;
    const nck_num first = (nck_num)(c[0] - c[1]);
    const nck_num third = (nck_num)(c[2] - c[1]);
    const nck_num fourth = (nck_num)(c[3] - c[1]);
    const nck_num share = (4 + v * v * (3 * v - 6)) / 6;
    return c[1] + (double)((first * v * v * v + fourth * w * w * w) / 6 + third * share);
}

// s of the program next to a control point, from an s near it.
static double next_to(nck_stream_t *self, double s, const double *point) {
    nck_track_view_t view;
    nck_num off[NCK_AXIS_MAX];
    self->near = nck_track_find(&self->track, self->near, s);
    nck_track_view(&self->track, self->near, s, &view);
    for (int x = 0; x < self->track.axes; x++) off[x] = (nck_num)(point[x] - view.point[x]);
    return nearest(self, self->near, s, off);
}

// s of the program on the way to a rest behind the seam, as coefficients of a spline: as near to
// the control points as can be, between knots; then ways that halve.
static void set_places(nck_stream_t *self, const double *s, nck_sample_rest_t *rest) {
    double *const place = rest->place;
    for (int n = 1; n < 3; n++) {
        const double here = next_to(self, s[n - 1], rest->point[n]);
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
    for (int n = 2; n < 4; n++) nck_reference_point(self, rest->place[n], way[n - 1]);
    for (int n = 3; n < NCK_SAMPLE_REST + 3; n++) {
        memcpy(way[0], way[1], sizeof way[0]);
        memcpy(way[1], way[2], sizeof way[1]);
        memcpy(rest->point[n], rest->point[2], sizeof rest->point[n]); // axes that never move
        memcpy(rest->point[n], way[1], (size_t)self->track.axes * sizeof way[1][0]);
        if (n >= NCK_SAMPLE_REST) continue;
        nck_reference_point(self, rest->place[n + 1], way[2]);
        set_outside(self->track.axes, way[0], way[2], rest->point[n]);
    }
}

double nck_sample_rest_miss(nck_stream_t *self, const nck_sample_rest_t *rest, int i) {
    const double *const c[4] = {rest->point[i], rest->point[i + 1], rest->point[i + 2],
                                rest->point[i + 3]};
    const double s = rest->place[i + 1];
    nck_num most = 0;
    cubic_t cubic;
    self->near = nck_track_find(&self->track, self->near, s);
    nck_track_view(&self->track, self->near, s, &cubic.from);
    set_cubic(self->track.axes, c, &cubic);
    for (int n = 0; n < NCK_FAIR_BINS; n++) {
        const nck_num share = 1 / (nck_num)NCK_FAIR_BINS;
        bin_t bin = {.w = {share * (nck_num)n, share * (nck_num)(n + 1)}};
        bin.s[0] = spline_of(&rest->place[i], bin.w[0]);
        bin.s[1] = nck_max(spline_of(&rest->place[i], bin.w[1]), bin.s[0]);
        set_elements(self, &bin);
        most = nck_num_max(most, bin_miss(self, &cubic, &bin));
    }
    return (double)most;
}
