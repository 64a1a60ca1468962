// SPDX-License-Identifier: MIT
// Which source line the path is of, place by place.
#include "nck/base/marks.h"

// Places are sums of the same lengths in another order: nearer ones are one [path mm, a share].
#define LEAST 1e-9
#define LEAST_SHARE 1e-13

static double least(double s) { return LEAST + LEAST_SHARE * s; }

static uint32_t place_of(uint32_t count) { return count & (NCK_MARK_MAX - 1); }

void nck_marks_push(nck_marks_t *self, uint32_t oldest, uint32_t line, double s) {
    if (self->head - oldest >= NCK_MARK_MAX) return;
    self->at[place_of(self->head)].s = s;
    self->at[place_of(self->head)].line = line;
    self->head++;
}

void nck_marks_tell(nck_marks_t *self, nck_seg_t *seg) {
    const double end = seg->s_begin + seg->length;
    const double begin = seg->s_begin + least(seg->s_begin);
    uint32_t last = 0;
    while (self->tail != self->head && self->at[place_of(self->tail)].s <= begin) self->tail++;
    seg->mark = self->tail;
    seg->marks = 0;
    if (self->tail == self->head || !(seg->length > 0.0)) return;
    seg->line = self->at[place_of(self->tail)].line;
    last = self->tail;
    while (last + 1 != self->head && self->at[place_of(last)].s < end - least(end)) last++;
    seg->marks = last - self->tail;
}

uint32_t nck_marks_line(const nck_marks_t *self, const nck_seg_t *seg, double s) {
    const double place = seg->s_begin + s;
    uint32_t low = 0;
    uint32_t high = seg->marks; // the way at `place` ends at this mark or before
    if (high == 0u) return seg->line;
    while (low < high) {
        const uint32_t middle = (low + high) / 2u;
        if (self->at[place_of(seg->mark + middle)].s < place) low = middle + 1u;
        else high = middle;
    }
    return self->at[place_of(seg->mark + low)].line;
}
