// SPDX-License-Identifier: MIT
// Inside room 3: the programmed path, and how short lines become one while they are read.
#include "nck/prep/3_smooth/track.h"

#include <string.h> // memcpy memset

#include "nck/base/path.h" // nck_path_part nck_path_tangent_part
#include "nck/base/real.h" // nck_fabs nck_max nck_min nck_sqrt
#include "nck/base/spin_math.h" // nck_spin_…

// What joining may cost of P. More than the least is taken as the ring fills alone: where chords
// are so short that it would not hold what a window has to see.
static const double costs[NCK_TRACK_LEVELS] = {1.0 / 32.0, 1.0 / 8.0, 1.0 / 4.0, 1.0 / 2.0};
#define EVEN 1e9 // [path mm] is beyond any path
#define EVENS 40.0 // where a feed is even it is said to be so by so much more a mm: knots grow there
#define SPAN 0.5 // how long joining makes a line, in knots at the feed: nothing looks closer

void nck_track_begin(nck_track_t *self, int axes, double knot_s, double spin_a) {
    self->axes = axes;
    self->knot_s = knot_s;
    self->spin_a = spin_a;
    self->head = 0;
    self->tail = 0;
    self->grows = 0;
}

static nck_track_element_t *newest(nck_track_t *self) {
    return &self->at[(self->head - 1) & (NCK_TRACK_SPAN - 1)];
}

// The newest line's slope g = (end − start)/length has to pass what is its end now: there it may be
// |start + g s − end| ≤ ε off, at the same s. For every axis that is an interval.
static void narrow(nck_track_t *self, const nck_track_element_t *line) {
    const double root = nck_sqrt((double)self->axes);
    for (int x = 0; x < self->axes; x++) {
        const double slope = (self->end[x] - line->start[x]) / line->length;
        for (int k = 0; k < NCK_TRACK_LEVELS; k++) {
            const double room = costs[k] * self->join.tolerance / (root * line->length);
            self->join.low[k][x] = nck_max(self->join.low[k][x], slope - room);
            self->join.high[k][x] = nck_min(self->join.high[k][x], slope + room);
        }
    }
}

// The least level at which a line to this end passes all points between; NCK_TRACK_LEVELS: none.
static int level_of(const nck_track_t *self, const nck_track_element_t *line, const double *end,
                    double length) {
    int level = 0;
    for (int x = 0; x < self->axes; x++) {
        const double slope = (end[x] - line->start[x]) / length;
        while (level < NCK_TRACK_LEVELS
               && (slope < self->join.low[level][x] || slope > self->join.high[level][x])) {
            level++;
        }
    }
    return level;
}

static void set_words(nck_track_words_t *words, const nck_seg_t *seg) {
    memset(words, 0, sizeof *words);
    words->feed = seg->feed;
    words->feed_scale = seg->feed_scale;
    words->spin = seg->spin;
    words->rapid = seg->rapid;
}

// 1 if a seg has these words.
static int is_same(const nck_track_words_t *words, const nck_seg_t *seg) {
    const nck_spin_t *const spin = &words->spin;
    const int turns = spin->speed == seg->spin.speed && spin->most == seg->spin.most
                      && spin->x == seg->spin.x && spin->per_rev == seg->spin.per_rev;
    return turns && words->feed == seg->feed && words->feed_scale == seg->feed_scale
           && words->rapid == seg->rapid;
}

static void set_way(const nck_track_t *self, nck_track_element_t *line, const double *end) {
    for (int x = 0; x < self->axes; x++) line->shape.way[x] = (nck_num)(end[x] - line->start[x]);
}

// Join the line to the newest element. Returns 1, or 0: it cannot be.
static int join(nck_track_t *self, const nck_seg_t *seg, double tolerance) {
    nck_track_element_t *const line = newest(self);
    const double length = line->length + seg->length;
    if (seg->kind != NCK_SEG_LINE || seg->rapid || self->join.tolerance != tolerance
        || !is_same(&line->words, seg) || length > SPAN * self->knot_s * seg->feed) {
        return 0;
    }
    narrow(self, line);
    const int level = level_of(self, line, seg->end, length);
    const int fill = (int)(self->head - self->tail) * NCK_TRACK_LEVELS;
    if (level == NCK_TRACK_LEVELS || level * NCK_TRACK_SPAN > fill) return 0;
    line->length = length;
    set_way(self, line, seg->end);
    line->tolerance = (float)((1.0 - costs[level]) * tolerance);
    line->line[1] = seg->line;
    line->block[1] = seg->block;
    memcpy(self->end, seg->end, sizeof self->end);
    return 1;
}

// From here on lines may be joined to the newest element, whatever its slope.
static void begin_join(nck_track_t *self, double tolerance) {
    self->join.tolerance = tolerance;
    for (int k = 0; k < NCK_TRACK_LEVELS; k++) {
        for (int x = 0; x < self->axes; x++) {
            self->join.low[k][x] = -2.0; // no slope is beyond 1
            self->join.high[k][x] = 2.0;
        }
    }
}

nck_status_t nck_track_push(nck_track_t *self, const nck_seg_t *seg, double tolerance) {
    if (self->grows && join(self, seg, tolerance)) return NCK_OK;
    if (nck_track_is_full(self)) return NCK_FULL;
    const double s = self->head > 0 ? newest(self)->s + newest(self)->length : 0.0;
    self->head++;
    nck_track_element_t *const element = newest(self);
    memset(element, 0, sizeof *element);
    element->s = s;
    element->length = seg->length;
    memcpy(element->start, seg->start, sizeof element->start);
    set_words(&element->words, seg);
    element->kind = seg->kind;
    if (seg->kind == NCK_SEG_ARC) element->shape.arc = seg->shape.arc;
    else set_way(self, element, seg->end);
    element->tolerance = (float)tolerance;
    element->line[0] = seg->line;
    element->line[1] = seg->line;
    element->block[0] = seg->block;
    element->block[1] = seg->block;
    memcpy(self->end, seg->end, sizeof self->end);
    self->grows = seg->kind == NCK_SEG_LINE && !seg->rapid;
    begin_join(self, tolerance);
    return NCK_OK;
}

void nck_track_seal(nck_track_t *self) { self->grows = 0; }

// Behind the last element that is whole.
static uint32_t known_end(const nck_track_t *self) {
    return self->head - (self->grows ? 1U : 0U);
}

double nck_track_known(const nck_track_t *self) {
    const uint32_t end = known_end(self);
    if (end == self->tail) return 0.0;
    const nck_track_element_t *const last = nck_track_at(self, end - 1);
    return last->s + last->length;
}

uint32_t nck_track_find(const nck_track_t *self, uint32_t near, double s) {
    const uint32_t last = known_end(self) - 1;
    uint32_t count = near - self->tail > last - self->tail ? self->tail : near;
    while (count != self->tail && s < nck_track_at(self, count)->s) count--;
    while (count != last && s >= nck_track_at(self, count + 1)->s) count++;
    return count;
}

const double *nck_track_end(const nck_track_t *self, uint32_t count) {
    return count + 1 == self->head ? self->end : nck_track_at(self, count + 1)->start;
}

void nck_track_seg(const nck_track_t *self, uint32_t count, nck_seg_t *seg_out) {
    const nck_track_element_t *const element = nck_track_at(self, count);
    memset(seg_out, 0, sizeof *seg_out);
    seg_out->kind = element->kind;
    seg_out->length = element->length;
    memcpy(seg_out->start, element->start, sizeof seg_out->start);
    memcpy(seg_out->end, nck_track_end(self, count), sizeof seg_out->end);
    if (element->kind == NCK_SEG_ARC) seg_out->shape.arc = element->shape.arc;
}

// The point of an arc at f mm from its start; beyond it straight on.
static void arc_point(const nck_track_t *self, uint32_t count, double f, double *point_out) {
    nck_seg_t seg;
    nck_track_seg(self, count, &seg);
    const double inside = nck_min(nck_max(f, 0.0), seg.length);
    nck_path_part(&seg, inside, self->axes, point_out);
    if (inside == f) return;
    double tangent[NCK_AXIS_MAX];
    nck_path_tangent_part(&seg, inside, self->axes, tangent);
    for (int x = 0; x < self->axes; x++) point_out[x] += tangent[x] * (f - inside);
}

void nck_track_point(const nck_track_t *self, uint32_t count, double s, double *point_out) {
    const nck_track_element_t *const element = nck_track_at(self, count);
    if (element->kind == NCK_SEG_ARC) {
        arc_point(self, count, s - element->s, point_out);
        return;
    }
    const double *const end = nck_track_end(self, count);
    const double f = (s - element->s) / element->length;
    for (int x = 0; x < self->axes; x++) {
        point_out[x] = element->start[x] + (end[x] - element->start[x]) * f;
    }
}

void nck_track_view(const nck_track_t *self, uint32_t count, double s,
                    nck_track_view_t *view_out) {
    view_out->count = count;
    view_out->s = s;
    nck_track_point(self, count, s, view_out->point);
}

// What s is of an element past its point that is next to the view; `near_out`: that point.
static double way_from(const nck_track_t *self, const nck_track_view_t *from, uint32_t count,
                       double s, const double **near_out) {
    const nck_track_element_t *const element = nck_track_at(self, count);
    if (count == from->count) {
        *near_out = from->point;
        return s - from->s;
    }
    const int is_before = count - self->tail < from->count - self->tail;
    *near_out = is_before ? nck_track_end(self, count) : element->start;
    return s - (is_before ? element->s + element->length : element->s);
}

void nck_track_offset(const nck_track_t *self, const nck_track_view_t *from, uint32_t count,
                      double s, nck_num *offset_out) {
    const nck_track_element_t *const element = nck_track_at(self, count);
    if (element->kind == NCK_SEG_ARC) {
        double point[NCK_AXIS_MAX];
        arc_point(self, count, s - element->s, point);
        for (int x = 0; x < self->axes; x++) offset_out[x] = (nck_num)(point[x] - from->point[x]);
        return;
    }
    const double *near = from->point;
    const nck_num way = (nck_num)way_from(self, from, count, s, &near);
    const nck_num f = way / (nck_num)element->length;
    for (int x = 0; x < self->axes; x++) {
        const nck_num before = near == from->point ? 0 : (nck_num)(near[x] - from->point[x]);
        offset_out[x] = before + element->shape.way[x] * f;
    }
}

void nck_track_tangent(const nck_track_t *self, uint32_t count, double s, nck_num *tangent_out) {
    const nck_track_element_t *const element = nck_track_at(self, count);
    if (element->kind != NCK_SEG_ARC) {
        for (int x = 0; x < self->axes; x++) {
            tangent_out[x] = element->shape.way[x] / (nck_num)element->length;
        }
        return;
    }
    nck_seg_t seg;
    double tangent[NCK_AXIS_MAX];
    nck_track_seg(self, count, &seg);
    nck_path_tangent_part(&seg, s - element->s, self->axes, tangent);
    for (int x = 0; x < self->axes; x++) tangent_out[x] = (nck_num)tangent[x];
}

// Where an element is under G96 at s.
typedef struct turning {
    double x;     // [mm]
    double r;     // from the spindle's axis [mm]
    double flat;  // nearer to it the speed does not change [mm]
    double slant; // |dr/ds|
} turning_t;

static void find_turning(const nck_track_t *self, uint32_t count, double s, turning_t *out) {
    const nck_spin_t *const spin = &nck_track_at(self, count)->words.spin;
    double point[NCK_AXIS_MAX];
    nck_num tangent[NCK_AXIS_MAX];
    nck_track_point(self, count, s, point);
    nck_track_tangent(self, count, s, tangent);
    out->x = point[NCK_AXIS_X];
    out->r = nck_fabs(out->x - spin->x);
    out->flat = nck_spin_flat(spin);
    out->slant = nck_fabs((double)tangent[NCK_AXIS_X]);
}

double nck_track_feed(const nck_track_t *self, uint32_t count, double s) {
    const nck_track_words_t *const words = &nck_track_at(self, count)->words;
    const nck_spin_t *const spin = &words->spin;
    if (!NCK_HAS_LATHE || !(spin->most > 0.0)) return words->feed;
    turning_t there;
    find_turning(self, count, s, &there);
    const double feed = nck_spin_feed(spin, words->feed, there.x);
    const double most = nck_spin_follow(spin, there.r, self->spin_a);
    const int follows = self->spin_a > 0.0 && there.r > there.flat;
    return follows && there.slant * feed > most ? most / there.slant : feed;
}

double nck_track_even(const nck_track_t *self, uint32_t count, double s) {
    const nck_spin_t *const spin = &nck_track_at(self, count)->words.spin;
    turning_t there = {0.0, 0.0, 0.0, 0.0};
    if (!NCK_HAS_LATHE || !(spin->per_rev > 0.0)) return EVEN;
    find_turning(self, count, s, &there);
    const double inside = nck_max(0.0, there.flat - there.r);
    return there.slant > 0.0 ? (there.r + (1.0 + EVENS) * inside) / there.slant : EVEN;
}

void nck_track_words(const nck_track_t *self, uint32_t count, double s, double x,
                     nck_track_words_t *words_out) {
    *words_out = nck_track_at(self, count)->words;
    words_out->feed = nck_spin_feed(&words_out->spin, words_out->feed, x);
    for (uint32_t n = count + 1; n != self->head; n++) {
        const nck_track_element_t *const element = nck_track_at(self, n);
        if (!(element->s < s)) return;
        const double feed = nck_spin_feed(&element->words.spin, element->words.feed, x);
        if (!(feed < words_out->feed)) continue;
        words_out->feed = feed;
        words_out->feed_scale = element->words.feed_scale;
        words_out->rapid = element->words.rapid;
    }
}

void nck_track_drop(nck_track_t *self, double s, double back) {
    const uint32_t last = nck_track_find(self, self->tail, s);
    while (self->tail != last
           && (nck_track_at(self, self->tail + 1)->s <= s - back
               || last - self->tail > NCK_TRACK_SPAN / 4)) {
        self->tail++;
    }
}
