// SPDX-License-Identifier: MIT
// Stretches of a plan joined, and the points where they end.
#include "host/trail.h"

#include <string.h> // memset

#include "nck/base/cell_math.h" // nck_cell_way nck_cell_speed
#include "nck/base/path.h"      // nck_path_part nck_path_second
#include "nck/base/real.h"      // nck_sqrt nck_fabs nck_min

// A chord of a bend is so far from it at most [mm], and turns so far at most [rad].
#define CHORD 0.005
#define TURN 0.18
#define TURN_DEG 5.0 // of rotary axes, which bend the path as the part sees it
// Accelerations within this share of the machine's, speeds within this share of the feed go on
// alike.
#define LIKE_A (1.0 / 64.0)
#define LIKE_V (1.0 / 512.0)
#define CHORDS_MOST 256.0

// Behind the last rotary axis that the build has.
enum { ROTARY_END = NCK_AXIS_MAX <= NCK_AXIS_C ? NCK_AXIS_MAX : NCK_AXIS_C + 1 };

void nck_host_trail_again(nck_host_trail_t *self, const nck_machine_t *machine) {
    self->before += self->point_count;
    self->point_count = 0;
    self->foot_count = 0;
    self->a_like = LIKE_A * machine->path.a_max;
}

int nck_host_trail_has_room(const nck_host_trail_t *self) {
    return !self->points
           || (self->point_max - self->point_count > NCK_HOST_TRAIL_ROOM
               && self->foot_max - self->foot_count > NCK_HOST_TRAIL_ROOM);
}

static uint64_t told(const nck_host_trail_t *self) { return self->before + self->point_count; }

static void give(nck_host_trail_t *self, const nck_host_point_t *point) {
    if (self->point_count == self->point_max) {
        self->broken = 1;
        return;
    }
    self->points[self->point_count] = *point;
    self->point_count++;
}

static void close_stretch(nck_host_trail_t *self) {
    if (self->is_open) give(self, &self->open);
    self->is_open = 0;
}

static void pass_time(nck_host_trail_t *self, double time) {
    nck_host_cause_sum(&self->t, time);
    self->open.t = self->t.sum + self->t.rest;
    self->duration += time;
}

static void begin(nck_host_trail_t *self, const nck_host_stride_t *stretch, double v) {
    nck_host_point_t *const open = &self->open;
    open->feed = stretch->feed;
    open->line = stretch->line;
    open->tool = stretch->tool;
    open->limit = stretch->cell->limit;
    open->rapid = stretch->seg->rapid;
    open->rests = 0;
    self->seg = stretch->seg->seq;
    self->falls = stretch->falls;
    self->v_begin = v;
    self->length = 0.0;
    self->duration = 0.0;
}

static void put_place(nck_host_point_t *point, const nck_seg_t *seg, double s) {
    double place[NCK_AXIS_C + 1] = {0.0};
    nck_path_part(seg, s, ROTARY_END, place);
    memcpy(point->xyz, place, sizeof point->xyz);
    memcpy(point->abc, &place[NCK_AXIS_A], sizeof point->abc);
}

// The first point: where the path begins.
static void give_start(nck_host_trail_t *self, const nck_host_stride_t *stretch) {
    if (told(self) > 0) return;
    memset(&self->open, 0, sizeof self->open);
    begin(self, stretch, 0.0);
    put_place(&self->open, stretch->seg, 0.0);
    give(self, &self->open);
}

// How far the path may run while the rotary axes turn by so much [path mm]; 0: they do not turn.
static double turned_chord(const nck_seg_t *seg, double s) {
    double square = 0.0;
    for (int x = NCK_AXIS_A; x < ROTARY_END; x++) {
        const double change = seg->end[x] - seg->start[x];
        square += change * change;
    }
    if (!(square > 0.0) || !(seg->length > 0.0)) return 0.0;
    double tangent[NCK_AXIS_MAX];
    nck_path_tangent(seg, s, tangent);
    square = 0.0;
    for (int x = NCK_AXIS_A; x < ROTARY_END; x++) square += tangent[x] * tangent[x];
    return square > 0.0 ? TURN_DEG / nck_sqrt(square) : 0.0;
}

// How long a chord of the path may be at a place [path mm]; 0: there is no bend.
static double chord_at(const nck_seg_t *seg, double s) {
    const double at = nck_min(seg->length, nck_max(0.0, s));
    const double turned = turned_chord(seg, at);
    double second[NCK_AXIS_MAX];
    double square = 0.0;
    if (seg->kind != NCK_SEG_ARC && seg->kind != NCK_SEG_SPLINE) return turned;
    nck_path_second(seg, at, second);
    for (int x = 0; x < NCK_AXIS_MAX; x++) square += second[x] * second[x];
    const double bend = nck_sqrt(square);
    if (!(bend > 0.0)) return turned;
    const double chord = nck_min(nck_sqrt(8.0 * CHORD / bend), TURN / bend);
    return turned > 0.0 ? nck_min(chord, turned) : chord;
}

// 1 if a stretch with such an acceleration, so long and so fast at its end, goes on as the open one
// does.
static int goes_on(const nck_host_trail_t *self, const nck_host_stride_t *stretch, double a,
                   double v, double time) {
    const nck_host_point_t *const open = &self->open;
    const double v_straight = self->v_begin + self->a_begin * (self->duration + time);
    return self->is_open && self->seg == stretch->seg->seq && open->line == stretch->line
           && self->falls == stretch->falls
           && open->limit == stretch->cell->limit && !(open->feed < stretch->feed)
           && !(open->feed > stretch->feed) && nck_fabs(a - self->a_begin) <= self->a_like
           && nck_fabs(v - v_straight) <= LIKE_V * stretch->feed;
}

double nck_host_trail_speed(const nck_seg_t *seg, const nck_cell_t *cell, double t) {
    const double v = nck_max(0.0, nck_cell_speed(cell, t));
    if (seg->kind != NCK_SEG_SPLINE) return v;
    double tangent[NCK_AXIS_MAX];
    double square = 0.0;
    nck_path_tangent(seg, nck_min(seg->length, cell->s + nck_cell_way(cell, t)), tangent);
    for (int x = 0; x < NCK_AXIS_MAX; x++) square += tangent[x] * tangent[x];
    return v * nck_sqrt(square);
}

// A part of a stretch, no longer than a chord may be.
static void step(nck_host_trail_t *self, const nck_host_stride_t *stretch, double from,
                 double to, double chord) {
    const nck_cell_t *const cell = stretch->cell;
    const double time = to - from;
    const double v = nck_host_trail_speed(stretch->seg, cell, to);
    const double a = time > 0.0 ? (v - nck_host_trail_speed(stretch->seg, cell, from)) / time : 0.0;
    const double s = nck_cell_way(cell, to);
    const double length = s - nck_cell_way(cell, from);
    const int is_bent = chord > 0.0 && self->length + length > chord;
    if (is_bent || !goes_on(self, stretch, a, v, time)) {
        close_stretch(self);
        begin(self, stretch, nck_host_trail_speed(stretch->seg, cell, from));
        self->a_begin = a;
        self->is_open = 1;
    }
    self->length += length;
    self->open.v = v;
    put_place(&self->open, stretch->seg, stretch->s + s);
    pass_time(self, time);
}

void nck_host_trail_move(nck_host_trail_t *self, const nck_host_stride_t *stretch) {
    give_start(self, stretch);
    const double time = stretch->to - stretch->from;
    const double s = nck_cell_way(stretch->cell, stretch->from);
    const double length = nck_cell_way(stretch->cell, stretch->to) - s;
    const double chord = chord_at(stretch->seg, stretch->s + s);
    const size_t room = self->point_max - self->point_count;
    const int is_bent = chord > 0.0 && room > NCK_HOST_TRAIL_ROOM / 2;
    const double parts = is_bent ? nck_min(CHORDS_MOST, length / chord) : 0.0;
    double from = stretch->from;
    for (int k = 1; (double)k < parts; k++) {
        const double to = stretch->from + time * (double)k / parts;
        step(self, stretch, from, to, chord);
        from = to;
    }
    step(self, stretch, from, stretch->to, chord);
}

void nck_host_trail_rest(nck_host_trail_t *self, const nck_host_stride_t *stretch, double time) {
    if (!(time > 0.0)) return;
    give_start(self, stretch);
    close_stretch(self);
    begin(self, stretch, 0.0);
    self->open.v = 0.0;
    self->open.rests = 1;
    pass_time(self, time);
    give(self, &self->open);
}

void nck_host_trail_fastest(nck_host_trail_t *self) { self->fastest = told(self) + self->is_open; }

// The number of the last point, which may be in work.
static uint64_t last(const nck_host_trail_t *self) {
    const uint64_t count = told(self) + self->is_open;
    return count > 0 ? count - 1 : 0;
}

void nck_host_trail_slowest(nck_host_trail_t *self) { self->slowest = last(self); }

void nck_host_trail_was_low(nck_host_trail_t *self) {
    if (!self->points) return;
    self->foot.first = self->fastest;
    self->foot.at = self->slowest;
    self->fastest = self->slowest + 1;
}

void nck_host_trail_low(nck_host_trail_t *self) {
    if (!self->points) return;
    close_stretch(self);
    nck_host_trail_slowest(self);
    nck_host_trail_was_low(self);
    self->fastest = told(self);
}

void nck_host_trail_settle(nck_host_trail_t *self, const nck_host_low_t *low) {
    if (!self->points) return;
    if (self->foot_count == self->foot_max) {
        self->broken = 1;
        return;
    }
    self->foot.low = *low;
    self->feet[self->foot_count] = self->foot;
    self->foot_count++;
}
