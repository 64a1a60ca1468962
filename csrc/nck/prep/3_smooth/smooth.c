// SPDX-License-Identifier: MIT
// Room 3, smooth: exact segs.
#include "nck/prep/3_smooth/smooth.h"

#include <string.h> // memset

#include "nck/prep/3_smooth/metric_math.h" // nck_metric_length nck_metric_feed_length

void nck_smooth_init(nck_smooth_t *self, const nck_machine_t *machine) {
    memset(self, 0, sizeof *self);
    self->machine = machine;
    memcpy(self->position_nm, machine->start_nm, sizeof self->position_nm);
    for (int x = 0; x < NCK_AXIS_MAX; x++) {
        self->position[x] = (double)machine->start_nm[x] / nck_machine_counts(machine, x);
    }
}

// Where the block ends. Most blocks move few axes: the others need no division.
static void set_end(const nck_smooth_t *self, const nck_block_t *block, double *end) {
    memcpy(end, self->position, sizeof self->position);
    for (int x = 0; x < NCK_AXIS_MAX; x++) {
        if (block->target_nm[x] == self->position_nm[x]) continue;
        end[x] = (double)block->target_nm[x] / nck_machine_counts(self->machine, x);
    }
}

static void set_arc(nck_seg_t *seg, const nck_block_t *block) {
    seg->kind = NCK_SEG_ARC;
    seg->axis_u = block->plane == 17 ? NCK_AXIS_X : block->plane == 18 ? NCK_AXIS_Z : NCK_AXIS_Y;
    seg->axis_v = block->plane == 17 ? NCK_AXIS_Y : block->plane == 18 ? NCK_AXIS_X : NCK_AXIS_Z;
    seg->centre_u = block->centre_mm[0];
    seg->centre_v = block->centre_mm[1];
    seg->sweep = block->sweep_rad;
}

// Wanted path speed [path mm/s]. G94: F along the length it is meant for; G93: the whole seg in 1/F
// min; G95: F a revolution.
static double path_feed(const nck_block_t *block, const nck_seg_t *seg) {
    if (block->feed_mode == NCK_FEED_INVERSE) return block->feed * seg->length / 60.0;
    const double per_minute =
        block->feed_mode == NCK_FEED_PER_REV ? block->feed * block->spindle_rpm : block->feed;
    return per_minute / 60.0 / seg->feed_scale;
}

static nck_status_t make_motion(nck_smooth_t *self, const nck_block_t *block, nck_seg_t *seg) {
    if (block->kind == NCK_BLOCK_ARC) set_arc(seg, block);
    seg->length = nck_metric_length(seg);
    memcpy(self->position_nm, block->target_nm, sizeof self->position_nm);
    memcpy(self->position, seg->end, sizeof self->position);
    if (!(seg->length > 0.0)) return NCK_EMPTY;
    seg->stop = block->path_mode == NCK_PATH_STOP;
    seg->rapid = block->kind == NCK_BLOCK_RAPID;
    seg->feed_scale = nck_metric_feed_length(seg) / seg->length;
    if (seg->rapid) return NCK_OK;
    seg->feed = path_feed(block, seg);
    return seg->feed > 0.0 ? NCK_OK : NCK_E_FEED_MISSING;
}

nck_status_t nck_smooth_push(nck_smooth_t *self, const nck_block_t *block, uint32_t block_seq,
                             nck_seg_t *seg_out) {
    const int moves = block->kind <= NCK_BLOCK_ARC;
    memset(seg_out, 0, sizeof *seg_out);
    seg_out->seq = self->seq;
    seg_out->line = block->line;
    seg_out->block = block_seq;
    seg_out->s_begin = self->s;
    seg_out->feed_scale = 1.0;
    memcpy(seg_out->start, self->position, sizeof seg_out->start);
    memcpy(seg_out->end, self->position, sizeof seg_out->end);
    if (moves) {
        set_end(self, block, seg_out->end);
        const nck_status_t status = make_motion(self, block, seg_out);
        if (status != NCK_OK) return status;
    } else {
        seg_out->kind = block->kind == NCK_BLOCK_DWELL ? NCK_SEG_DWELL : NCK_SEG_WAIT;
        seg_out->stop = 1;
        seg_out->dwell_s = block->kind == NCK_BLOCK_DWELL ? block->dwell_s : 0.0;
    }
    self->s += seg_out->length;
    self->seq++;
    return NCK_OK;
}
