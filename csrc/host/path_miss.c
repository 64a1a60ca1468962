// SPDX-License-Identifier: MIT
// Marks of a program against the segs about them.
#include "host/path_miss.h"

#include "host/seg_distance.h"  // nck_host_seg_distance
#include "nck/base/real.h"      // nck_fabs nck_floor nck_min nck_max
#include "nck/base/trig_math.h" // NCK_PI

#define ON_PATH_MM 1e-9          // nearer needs no better
#define ARC_STEP (NCK_PI / 12.0) // from one mark of an arc to the next, at most [rad]
#define MARKS_MOST 1e6           // of one arc

void nck_host_path_miss_init(nck_host_path_miss_t *self, const nck_machine_t *machine,
                             double tolerance_most) {
    nck_host_course_init(&self->course, machine);
    self->mark_first = 0;
    self->mark_end = 0;
    self->seg_first = 0;
    self->seg_end = 0;
    self->step = 0;
    self->steps = 0;
    self->has_held = 0;
    self->all_read = 0;
    self->before = 0.0;
    self->judged = 0.0;
    self->tolerance_most = tolerance_most;
    self->largest = 0.0;
    self->missed = 0.0;
}

static nck_host_mark_t *mark_of(const nck_host_path_miss_t *self, uint64_t number) {
    return &self->marks[number % self->mark_max];
}

static nck_seg_t *seg_of(const nck_host_path_miss_t *self, uint64_t number) {
    return &self->segs[number % self->seg_max];
}

// The number of the last seg that begins at or before a path coordinate (`before`: only before);
// the oldest one if there is none.
static uint64_t seg_at(const nck_host_path_miss_t *self, double s, int before) {
    uint64_t low = self->seg_first;
    uint64_t high = self->seg_end;
    while (high - low > 1u) {
        const uint64_t middle = low + (high - low) / 2u;
        const double begin = seg_of(self, middle)->s_begin;
        if (begin < s || (!before && begin <= s)) {
            low = middle;
        } else {
            high = middle;
        }
    }
    return low;
}

// 1 if a mark that far from the path is the worst so far.
static int is_worse(const nck_host_path_miss_t *self, const nck_host_mark_t *mark, double apart) {
    return apart > self->largest
           || (mark->tolerance > 0.0 && apart > self->missed * mark->tolerance);
}

// How far a mark is from the path about it, `most` at most; more than that if it is not the worst.
static double nearest(const nck_host_path_miss_t *self, const nck_host_mark_t *mark, uint64_t own,
                      double most) {
    uint64_t first = seg_at(self, mark->low, 0);
    uint64_t last = seg_at(self, mark->high, 1);
    double best = nck_host_seg_distance(seg_of(self, own), mark->point, most);
    best = nck_min(best, most);
    if (last < first) last = first;
    for (uint64_t k = first; k <= last && is_worse(self, mark, best); k++) {
        best = nck_min(best, nck_host_seg_distance(seg_of(self, k), mark->point, best));
    }
    return best;
}

// Measure the oldest mark, and drop it.
static void judge(nck_host_path_miss_t *self) {
    const nck_host_mark_t *const mark = mark_of(self, self->mark_first);
    double point[NCK_AXIS_MAX];
    self->mark_first++;
    if (self->seg_end == self->seg_first) return;
    const uint64_t own = seg_at(self, mark->s, 0);
    const nck_seg_t *const seg = seg_of(self, own);
    const double done = mark->s - seg->s_begin;
    const double share = seg->length > 0.0 ? done / seg->length : 0.0;
    nck_host_seg_point(seg, nck_min(1.0, nck_max(0.0, share)), point);
    const double most = nck_host_course_apart(point, mark->point);
    if (most <= ON_PATH_MM || !is_worse(self, mark, most)) return;
    const double apart = nearest(self, mark, own, most);
    self->largest = nck_max(self->largest, apart);
    if (mark->tolerance > 0.0) self->missed = nck_max(self->missed, apart / mark->tolerance);
}

// The next mark of the program into `held`. Returns as nck_host_course_next.
static nck_status_t read_mark(nck_host_path_miss_t *self) {
    nck_host_move_t *const move = &self->move;
    nck_status_t status = NCK_OK;
    while (status == NCK_OK && self->step == self->steps) {
        status = nck_host_course_next(&self->course, move);
        if (status != NCK_OK) return status;
        const double turn = move->is_arc ? nck_fabs(move->sweep) : 0.0;
        const double parts = -nck_floor(-turn / ARC_STEP);
        self->steps = (uint32_t)nck_min(MARKS_MOST, nck_max(1.0, parts));
        self->step = move->end_s > move->begin_s ? 0 : self->steps;
    }
    self->step++;
    const double share = (double)self->step / (double)self->steps;
    self->held.s = move->begin_s + share * (move->end_s - move->begin_s);
    self->held.tolerance = move->tolerance;
    nck_host_course_point(move, share, self->held.point);
    return NCK_OK;
}

// What follows a mark is known: it may be judged.
static void add_mark(nck_host_path_miss_t *self, nck_host_mark_t *mark, double tolerance_next,
                     double way_next) {
    if (self->mark_end - self->mark_first == self->mark_max) judge(self);
    mark->tolerance = nck_min(mark->tolerance, tolerance_next);
    mark->low = mark->s - nck_max(mark->tolerance, 0.5 * (mark->s - self->before));
    mark->high = mark->s + nck_max(mark->tolerance, 0.5 * way_next);
    self->judged = nck_max(self->judged, mark->high);
    mark->judged = self->judged;
    self->before = mark->s;
    *mark_of(self, self->mark_end) = *mark;
    self->mark_end++;
}

// Read on by a mark. Returns NCK_OK, NCK_EMPTY.
static nck_status_t read_on(nck_host_path_miss_t *self) {
    nck_host_mark_t mark = self->held;
    const nck_status_t status = read_mark(self);
    if (status == NCK_EMPTY) return NCK_EMPTY;
    self->all_read = status == NCK_DONE;
    if (self->has_held) {
        const double way = self->all_read ? 0.0 : self->held.s - mark.s;
        add_mark(self, &mark, self->all_read ? mark.tolerance : self->held.tolerance, way);
    }
    self->has_held = 1;
    return NCK_OK;
}

// Read on until a mark lies behind a path coordinate. Returns NCK_OK, NCK_EMPTY.
static nck_status_t reach(nck_host_path_miss_t *self, double s) {
    nck_status_t status = NCK_OK;
    while (status == NCK_OK && !self->all_read
           && !(self->mark_end > self->mark_first && mark_of(self, self->mark_end - 1u)->s > s)) {
        status = read_on(self);
    }
    return status;
}

// From where on the path is needed for the marks that are left [path mm].
static double needed_from(const nck_host_path_miss_t *self) {
    double least = self->before - self->tolerance_most;
    for (uint64_t k = self->mark_first; k < self->mark_end; k++) {
        least = nck_min(least, mark_of(self, k)->low);
    }
    return least;
}

// Drop the segs that no mark needs any more.
static void drop_segs(nck_host_path_miss_t *self) {
    self->seg_first = seg_at(self, needed_from(self), 0);
}

// A ring full of segs that are needed: judge what has half of it ahead, drop its oldest quarter.
static void judge_early(nck_host_path_miss_t *self) {
    const double middle = seg_of(self, self->seg_first + self->seg_max / 2u)->s_begin;
    while (self->mark_end > self->mark_first && mark_of(self, self->mark_first)->s <= middle) {
        judge(self);
    }
    self->seg_first += self->seg_max / 4u;
}

static void keep_seg(nck_host_path_miss_t *self, const nck_seg_t *seg) {
    if (self->seg_end - self->seg_first == self->seg_max) {
        drop_segs(self);
        if (self->seg_end - self->seg_first > self->seg_max - self->seg_max / 8u) {
            judge_early(self);
        }
    }
    *seg_of(self, self->seg_end) = *seg;
    self->seg_end++;
}

nck_status_t nck_host_path_miss_add(nck_host_path_miss_t *self, const nck_seg_t *segs,
                                    size_t count, size_t *used_out) {
    nck_status_t status = NCK_OK;
    size_t k = 0;
    while (k < count && status == NCK_OK) {
        const nck_seg_t *const seg = &segs[k];
        const int moves = seg->length > 0.0;
        if (moves) status = reach(self, seg->s_begin);
        if (status == NCK_OK) k++;
        if (!moves || status != NCK_OK) continue;
        keep_seg(self, seg);
        while (self->mark_end > self->mark_first
               && mark_of(self, self->mark_first)->judged < seg->s_begin) {
            judge(self);
        }
    }
    *used_out = k;
    return status;
}

nck_status_t nck_host_path_miss_end(nck_host_path_miss_t *self) {
    if (self->seg_end == self->seg_first) return NCK_OK;
    const nck_seg_t *const last = seg_of(self, self->seg_end - 1u);
    const double reached = last->s_begin + last->length + ON_PATH_MM;
    const nck_status_t status = reach(self, reached);
    while (status == NCK_OK && self->mark_end > self->mark_first
           && mark_of(self, self->mark_first)->s < reached) {
        judge(self);
    }
    return status;
}
