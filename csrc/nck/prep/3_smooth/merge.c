// SPDX-License-Identifier: MIT
// Inside room 3: lines that are nearly one.
#include "nck/prep/3_smooth/merge.h"

#include <string.h> // memcpy

#include "nck/base/real.h"         // nck_min nck_max nck_sqrt
#include "nck/prep/3_smooth/raw.h" // nck_raw_at

#define SHARE 0.05 // of the tolerance that merging may use: it is lost to the spline

// May the newest block still change, and does the line continue it in all but direction?
static int is_alike(const nck_smooth_t *self, const nck_raw_t *raw, const nck_block_t *block,
                    const nck_seg_t *seg) {
    const int is_line = block->kind == NCK_BLOCK_LINE && raw->seg.kind == NCK_SEG_LINE;
    const int in_run = self->run.open && self->run.end == self->raw.head;
    const int unused = !in_run || self->run.t[4] <= raw->s;
    return is_line && raw->smooth && !raw->seg.rapid && unused
           && (int)self->merge.count < NCK_SMOOTH_MERGE
           && self->merge.tolerance == block->tolerance_mm && raw->seg.feed == seg->feed
           && raw->seg.feed_scale == seg->feed_scale && !nck_raw_spins_differ(&raw->seg, seg);
}

// How far the vertices between are from one line over the same path coordinate. Between vertices
// both are straight, so nothing is further.
static double leaves_by(const nck_smooth_t *self, const double *start, const double *end,
                        double length) {
    const int axes = self->terms->axes;
    double worst = 0.0;
    for (uint32_t i = 0; i <= self->merge.count; i++) {
        const double f = self->merge.s[i] / length;
        double sum = 0.0;
        for (int x = 0; x < axes; x++) {
            const double off = start[x] + (end[x] - start[x]) * f - self->merge.vertex[i][x];
            sum += off * off;
        }
        worst = nck_max(worst, sum);
    }
    return nck_sqrt(worst);
}

// 1 if the line leads back along the newest block: its tip is a corner, however near it is.
static int turns_back(const nck_seg_t *in, const nck_seg_t *out, int axes) {
    double along = 0.0;
    for (int x = 0; x < axes; x++) {
        along += (in->end[x] - in->start[x]) * (out->end[x] - out->start[x]);
    }
    return along <= 0.0;
}

int nck_merge_line(nck_smooth_t *self, const nck_block_t *block, const nck_seg_t *seg) {
    if (self->raw.head == self->raw.tail || !(block->merge_mm > 0.0)) return 0;
    nck_raw_t *const raw = nck_raw_at(self, self->raw.head - 1);
    if (raw->moved[0] != 0.0f || !is_alike(self, raw, block, seg)) return 0;
    if (nck_raw_is_long(self, &raw->seg) || nck_raw_is_long(self, seg)) return 0;
    if (turns_back(&raw->seg, seg, self->terms->axes)) return 0;
    const uint32_t count = self->merge.count;
    const double length = raw->seg.length + seg->length;
    memcpy(self->merge.vertex[count], raw->seg.end, sizeof self->merge.vertex[count]);
    self->merge.s[count] = raw->seg.length;
    const double error = leaves_by(self, raw->seg.start, seg->end, length);
    if (error > nck_min(block->merge_mm, SHARE * block->tolerance_mm)) return 0;
    memcpy(raw->seg.end, seg->end, sizeof raw->seg.end);
    raw->seg.length = length;
    raw->onward = NCK_ONWARD_UNKNOWN;
    raw->tolerance = self->merge.within - error;
    self->merge.count++;
    return 1;
}

void nck_merge_begin(nck_smooth_t *self, const nck_block_t *block) {
    self->merge.count = 0;
    self->merge.tolerance = block->tolerance_mm;
    self->merge.within = nck_raw_at(self, self->raw.head - 1)->tolerance;
}
