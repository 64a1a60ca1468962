// SPDX-License-Identifier: MIT
// Inside room 3: the programmed path, and how short lines become one while they are read.
#include "nck/base/arc_math.h" // nck_plane_axis
#include "nck/base/path.h" // nck_path_part nck_path_tangent_part
#include "nck/base/real.h" // NCK_APART nck_fabs nck_max nck_min nck_sqrt
#include "nck/base/spin_math.h" // nck_spin_…
#include "nck/prep/3_smooth/track.h"
#include "nck/prep/3_smooth/tuning.h" // NCK_TRACK_JOINED …

#include <string.h> // memcpy memset

// What joining may cost of P. More than the least is taken as the ring fills alone: where chords
// are so short that it would not hold what a window has to see.
static const double costs[NCK_TRACK_LEVELS] = {1.0 / 32.0, 1.0 / 8.0, 1.0 / 4.0, 1.0 / 2.0};
#define EVEN 1e9 // [path mm] is beyond any path

void nck_track_begin(nck_track_t *self, int axes, double knot_s, double spin_a) {
    self->axes = axes;
    self->knot_s = knot_s;
    self->spin_a = spin_a;
    self->head = 0;
    self->tail = 0;
    self->grows = 0;
    self->words.head = 0;
    self->words.lacks = 0;
}

static NCK_APART nck_track_element_t *newest(nck_track_t *self) {
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

// The set of words with this number.
static const nck_track_shared_t *shared_at(const nck_track_t *self, uint32_t number) {
    return &self->words.at[number & (NCK_TRACK_WORDS - 1)];
}

// 1 if the newest set of words is a seg's.
static int is_shared(const nck_track_t *self, const nck_seg_t *seg) {
    const nck_track_shared_t *const words = shared_at(self, self->words.head - 1);
    const nck_spin_t *const spin = &seg->spin;
    return self->words.head > 0 && words->most == spin->most && words->x == spin->x
           && words->per_rev == spin->per_rev && words->feed_scale == seg->feed_scale;
}

// 1 if the newest line's words are a seg's.
static int is_same(const nck_track_t *self, const nck_track_element_t *line, const nck_seg_t *seg) {
    return line->feed == seg->feed && line->speed == seg->spin.speed
           && line->rapid == seg->rapid && is_shared(self, seg);
}

// Take a seg's words. Returns 0: there is no room for them.
static int take_words(nck_track_t *self, const nck_seg_t *seg) {
    if (is_shared(self, seg)) return 1;
    const uint16_t oldest = nck_track_at(self, self->tail)->words;
    const uint32_t used = self->head == self->tail ? 0 : (uint16_t)(self->words.head - oldest);
    self->words.lacks = used == NCK_TRACK_WORDS;
    if (self->words.lacks) return 0;
    const nck_track_shared_t words = {seg->feed_scale, seg->spin.most, seg->spin.x,
                                      seg->spin.per_rev};
    self->words.at[self->words.head & (NCK_TRACK_WORDS - 1)] = words;
    self->words.head++;
    return 1;
}

static void words_of(const nck_track_t *self, uint32_t count, nck_track_words_t *words_out) {
    const nck_track_element_t *const element = nck_track_at(self, count);
    const nck_track_shared_t *const shared = shared_at(self, element->words);
    memset(words_out, 0, sizeof *words_out);
    words_out->feed = element->feed;
    words_out->feed_scale = shared->feed_scale;
    words_out->spin.speed = element->speed;
    words_out->spin.most = shared->most;
    words_out->spin.x = shared->x;
    words_out->spin.per_rev = shared->per_rev;
    words_out->rapid = element->rapid;
}

static void set_way(const nck_track_t *self, nck_track_element_t *line, const double *end) {
    for (int x = 0; x < self->axes; x++) line->shape.way[x] = (nck_num)(end[x] - line->start[x]);
}

static void set_arc(nck_track_element_t *element, const nck_seg_arc_t *arc) {
    const nck_track_arc_t as_kept = {arc->centre_u, arc->centre_v, arc->sweep};
    element->shape.arc = as_kept;
    element->plane = 17;
    while (nck_plane_axis(element->plane, 0) != arc->axis_u) element->plane++;
}

// Join the line to the newest element. Returns 1, or 0: it cannot be.
static int join(nck_track_t *self, const nck_seg_t *seg, double tolerance) {
    nck_track_element_t *const line = newest(self);
    const double length = line->length + seg->length;
    if (seg->kind != NCK_SEG_LINE || seg->rapid || self->join.tolerance != tolerance
        || !is_same(self, line, seg) || length > NCK_TRACK_JOINED * self->knot_s * seg->feed) {
        return 0;
    }
    narrow(self, line);
    const int level = level_of(self, line, seg->end, length);
    const int fill = (int)(self->head - self->tail) * NCK_TRACK_LEVELS;
    if (level == NCK_TRACK_LEVELS || level * NCK_TRACK_SPAN > fill) return 0;
    line->length = length;
    set_way(self, line, seg->end);
    line->tolerance = (float)((1.0 - costs[level]) * tolerance);
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
    if (self->head - self->tail == NCK_TRACK_SPAN || !take_words(self, seg)) return NCK_FULL;
    const double s = self->head > 0 ? newest(self)->s + newest(self)->length : 0.0;
    self->head++;
    nck_track_element_t *const element = newest(self);
    memset(element, 0, sizeof *element);
    element->s = s;
    element->length = seg->length;
    memcpy(element->start, seg->start, sizeof element->start);
    element->feed = seg->feed;
    element->speed = seg->spin.speed;
    element->rapid = seg->rapid;
    element->words = (uint16_t)(self->words.head - 1);
    if (seg->kind == NCK_SEG_ARC) set_arc(element, &seg->shape.arc);
    else set_way(self, element, seg->end);
    element->tolerance = (float)tolerance;
    element->line = seg->line;
    element->block = seg->block;
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

// What goes up from zero on as a double does, and is below zero with it: a core without doubles
// compares words in three instructions.
static int64_t order_of(double s) {
    int64_t bits;
    memcpy(&bits, &s, sizeof bits);
    return bits;
}

uint32_t nck_track_find(const nck_track_t *self, uint32_t near, double s) {
    const int64_t at = order_of(s);
    const uint32_t last = known_end(self) - 1;
    uint32_t count = near - self->tail > last - self->tail ? self->tail : near;
    while (count != self->tail && at < order_of(nck_track_at(self, count)->s)) count--;
    while (count != last && at >= order_of(nck_track_at(self, count + 1)->s)) count++;
    return count;
}

const double *nck_track_end(const nck_track_t *self, uint32_t count) {
    return count + 1 == self->head ? self->end : nck_track_at(self, count + 1)->start;
}

void nck_track_seg(const nck_track_t *self, uint32_t count, nck_seg_t *seg_out) {
    const nck_track_element_t *const element = nck_track_at(self, count);
    memset(seg_out, 0, sizeof *seg_out);
    seg_out->kind = element->plane ? NCK_SEG_ARC : NCK_SEG_LINE;
    seg_out->length = element->length;
    memcpy(seg_out->start, element->start, sizeof seg_out->start);
    memcpy(seg_out->end, nck_track_end(self, count), sizeof seg_out->end);
    if (!element->plane) return;
    nck_seg_arc_t *const arc = &seg_out->shape.arc;
    arc->centre_u = element->shape.arc.centre_u;
    arc->centre_v = element->shape.arc.centre_v;
    arc->sweep = element->shape.arc.sweep;
    arc->axis_u = (uint8_t)nck_plane_axis(element->plane, 0);
    arc->axis_v = (uint8_t)nck_plane_axis(element->plane, 1);
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
    if (element->plane) {
        arc_point(self, count, s - element->s, point_out);
        return;
    }
    const double *const end = nck_track_end(self, count);
    const double f = (s - element->s) / element->length;
    for (int x = 0; x < self->axes; x++) {
        point_out[x] = element->start[x] + (end[x] - element->start[x]) * f;
    }
}

void nck_track_view(const nck_track_t *self, uint32_t count, double s, nck_track_view_t *view_out) {
    view_out->count = count;
    view_out->s = s;
    view_out->seen[0].count = count;
    view_out->seen[1].count = count;
    nck_track_point(self, count, s, view_out->point);
}

// An element of the view's sides, from its end that is next to the view on.
static const nck_track_seen_t *see(const nck_track_t *self, nck_track_view_t *from,
                                   uint32_t count) {
    const nck_track_element_t *const element = nck_track_at(self, count);
    const int is_before = count - self->tail < from->count - self->tail;
    nck_track_seen_t *const seen = &from->seen[is_before];
    if (seen->count == count) return seen;
    const double *const near = is_before ? nck_track_end(self, count) : element->start;
    seen->count = count;
    seen->s = is_before ? element->s + element->length : element->s;
    for (int x = 0; x < self->axes; x++) seen->off[x] = (nck_num)(near[x] - from->point[x]);
    return seen;
}

void nck_track_offset(const nck_track_t *self, nck_track_view_t *from, uint32_t count, double s,
                      nck_num *offset_out) {
    const nck_track_element_t *const element = nck_track_at(self, count);
    if (element->plane) {
        double point[NCK_AXIS_MAX];
        arc_point(self, count, s - element->s, point);
        for (int x = 0; x < self->axes; x++) offset_out[x] = (nck_num)(point[x] - from->point[x]);
        return;
    }
    const nck_num length = (nck_num)element->length;
    if (count == from->count) {
        const nck_num f = (nck_num)(s - from->s) / length;
        for (int x = 0; x < self->axes; x++) offset_out[x] = element->shape.way[x] * f;
        return;
    }
    const nck_track_seen_t *const seen = see(self, from, count);
    const nck_num f = (nck_num)(s - seen->s) / length;
    for (int x = 0; x < self->axes; x++) offset_out[x] = seen->off[x] + element->shape.way[x] * f;
}

void nck_track_tangent(const nck_track_t *self, uint32_t count, double s, nck_num *tangent_out) {
    const nck_track_element_t *const element = nck_track_at(self, count);
    if (!element->plane) {
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

static void find_turning(const nck_track_t *self, uint32_t count, const nck_spin_t *spin, double s,
                         turning_t *out) {
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
    const nck_track_element_t *const element = nck_track_at(self, count);
    nck_track_words_t words;
    turning_t there;
    if (!NCK_HAS_LATHE || !(shared_at(self, element->words)->most > 0.0)) return element->feed;
    words_of(self, count, &words);
    find_turning(self, count, &words.spin, s, &there);
    const double feed = nck_spin_feed(&words.spin, words.feed, there.x);
    const double most = nck_spin_follow(&words.spin, there.r, self->spin_a);
    const int follows = self->spin_a > 0.0 && there.r > there.flat;
    return follows && there.slant * feed > most ? most / there.slant : feed;
}

double nck_track_even(const nck_track_t *self, uint32_t count, double s) {
    const nck_track_element_t *const element = nck_track_at(self, count);
    nck_track_words_t words;
    turning_t there;
    if (!NCK_HAS_LATHE || !(shared_at(self, element->words)->per_rev > 0.0)) return EVEN;
    words_of(self, count, &words);
    find_turning(self, count, &words.spin, s, &there);
    const double inside = nck_max(0.0, there.flat - there.r);
    return there.slant > 0.0 ? (there.r + (1.0 + NCK_TRACK_EVENS) * inside) / there.slant : EVEN;
}

void nck_track_words(const nck_track_t *self, uint32_t count, double s, double x,
                     nck_track_words_t *words_out) {
    words_of(self, count, words_out);
    words_out->feed = nck_spin_feed(&words_out->spin, words_out->feed, x);
    for (uint32_t n = count + 1; n != self->head; n++) {
        nck_track_words_t words;
        if (!(nck_track_at(self, n)->s < s)) return;
        words_of(self, n, &words);
        const double feed = nck_spin_feed(&words.spin, words.feed, x);
        if (!(feed < words_out->feed)) continue;
        words_out->feed = feed;
        words_out->feed_scale = words.feed_scale;
        words_out->rapid = words.rapid;
    }
}

// 1 if what stands before an element takes more than a quarter of a ring.
static int is_much(const nck_track_t *self, uint32_t last) {
    const uint16_t oldest = nck_track_at(self, self->tail)->words;
    const uint16_t newest_words = nck_track_at(self, last)->words;
    return last - self->tail > NCK_TRACK_SPAN / 4
           || (uint16_t)(newest_words - oldest) > NCK_TRACK_WORDS / 4;
}

void nck_track_drop(nck_track_t *self, double s, double back) {
    const uint32_t last = nck_track_find(self, self->tail, s);
    self->words.lacks = 0;
    while (self->tail != last
           && (nck_track_at(self, self->tail + 1)->s <= s - back || is_much(self, last))) {
        self->tail++;
    }
}
