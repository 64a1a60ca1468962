// SPDX-License-Identifier: MIT
// Which source line the path is of, place by place.
#include "nck/base/marks.h"

// Places are sums of the same lengths in another order: nearer ones are one [path mm, a share].
#define LEAST 1e-9
#define LEAST_SHARE 1e-13

static double least(double s) { return LEAST + LEAST_SHARE * s; }

static uint32_t place_of(uint32_t count) { return count & (NCK_MARK_MAX - 1); }

void nck_marks_push(nck_marks_t *self, uint32_t oldest, const nck_mark_t *mark) {
    if (self->head - oldest >= NCK_MARK_MAX) return;
    self->at[place_of(self->head)] = *mark;
    self->head++;
}

// A seg of a path that is known by its marks alone: they are those of the mark ahead, or of the
// last one.
static uint32_t modes_near(const nck_marks_t *self) {
    return self->at[place_of(self->tail == self->head ? self->tail - 1 : self->tail)].modes;
}

void nck_marks_tell(nck_marks_t *self, nck_seg_t *seg) {
    uint32_t last = 0;
    while (self->tail != self->head
           && self->at[place_of(self->tail)].s <= seg->s_begin + least(seg->s_begin)) {
        self->tail++;
    }
    seg->marks.from = self->tail;
    seg->marks.count = 0;
    if (seg->modes == 0) seg->modes = modes_near(self);
    if (self->tail == self->head || !(seg->length > 0.0)) return;
    const double end = seg->s_begin + seg->length;
    seg->line = self->at[place_of(self->tail)].line;
    seg->modes = self->at[place_of(self->tail)].modes;
    last = self->tail;
    while (last + 1 != self->head && self->at[place_of(last)].s < end - least(end)) last++;
    seg->marks.count = last - self->tail;
}

uint32_t nck_marks_line(const nck_marks_t *self, const nck_seg_t *seg, double s,
                        uint32_t *modes_out) {
    const double place = seg->s_begin + s;
    uint32_t low = 0;
    uint32_t high = seg->marks.count; // the way at `place` ends at this mark or before
    *modes_out = seg->modes;
    if (high == 0u) return seg->line;
    while (low < high) {
        const uint32_t middle = (low + high) / 2u;
        if (self->at[place_of(seg->marks.from + middle)].s < place) low = middle + 1u;
        else high = middle;
    }
    const nck_mark_t *const mark = &self->at[place_of(seg->marks.from + low)];
    *modes_out = mark->modes;
    return mark->line;
}
