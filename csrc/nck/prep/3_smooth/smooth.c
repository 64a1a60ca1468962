// SPDX-License-Identifier: MIT
// Room 3, smooth: blocks in, segs and outputs out.
#include "nck/base/arc_math.h"             // nck_arc_bulges nck_plane_axis
#include "nck/base/budget.h"               // NCK_TOLERANCE_MIN
#include "nck/base/real.h" // nck_real_of
#include "nck/prep/3_smooth/divide.h"      // nck_divide_…
#include "nck/prep/3_smooth/metric_math.h" // nck_metric_of
#include "nck/prep/3_smooth/runs.h"        // nck_runs_…
#include "nck/prep/3_smooth/smooth.h"
#include "nck/prep/3_smooth/tuning.h" // NCK_ROUNDING

#include <assert.h> // assert
#include <stddef.h> // offsetof
#include <string.h> // memcpy memset

void nck_smooth_init(nck_smooth_t *self, const nck_terms_t *terms) {
    const nck_machine_t *const machine = terms->machine;
    memset(self, 0, offsetof(nck_smooth_t, divide) + sizeof self->divide);
    nck_clocked_init(NCK_OPTIMAL_AT(self, clocked));
    self->terms = terms;
    memcpy(self->position_nm, machine->start_nm, sizeof self->position_nm);
    for (int x = 0; x < NCK_AXIS_MAX; x++) {
        self->position[x] = nck_real_of(machine->start_nm[x]) / nck_machine_counts(machine, x);
    }
    self->rests = 1;
}

static int waits(const nck_smooth_t *self) { return self->next.has_seg || self->next.has_output; }

int nck_smooth_is_empty(const nck_smooth_t *self) {
    return !nck_runs_is_open(self) && !waits(self)
           && !(self->divide.from < self->divide.seg.length);
}

// Where the block ends, in what is where it begins. Most blocks move few axes: the others need no
// division.
static inline void set_end(const nck_smooth_t *self, const nck_block_t *block, double *end) {
    const nck_machine_t *const machine = self->terms->machine;
    const int axes = self->terms->axes;
    for (int x = 0; x < axes; x++) {
        if (block->target_nm[x] == self->position_nm[x]) continue;
        end[x] = nck_real_of(block->target_nm[x]) / nck_machine_counts(machine, x);
    }
}

static void set_arc(nck_seg_t *seg, const nck_block_t *block) {
    nck_seg_arc_t *const arc = &seg->shape.arc;
    seg->kind = NCK_SEG_ARC;
    arc->axis_u = (uint8_t)nck_plane_axis(block->plane, 0);
    arc->axis_v = (uint8_t)nck_plane_axis(block->plane, 1);
    arc->centre_u = block->centre_mm[0];
    arc->centre_v = block->centre_mm[1];
    arc->sweep = block->sweep_rad;
}

// Wanted path speed [path mm/s]. G94: F along the length it is meant for; G93: the whole seg in 1/F
// min; G95: F a revolution.
static double path_feed(const nck_block_t *block, const nck_seg_t *seg) {
    if (block->feed_mode == NCK_FEED_INVERSE) return block->feed * seg->length / 60.0;
    const double per_minute =
        block->feed_mode == NCK_FEED_PER_REV ? block->feed * block->spindle_rpm : block->feed;
    return per_minute / 60.0 / seg->feed_scale;
}

// Within a tolerance, under the optimal slope.
static int is_within(const nck_smooth_t *self, const nck_block_t *block) {
    return nck_runs_are_clocked(self) && block->kind <= NCK_BLOCK_ARC
           && block->path_mode == NCK_PATH_CONTINUOUS && block->tolerance_mm >= NCK_TOLERANCE_MIN;
}

// The same within one that knots are near enough for.
static int is_smooth(const nck_smooth_t *self, const nck_block_t *block) {
    return is_within(self, block) && block->tolerance_mm - NCK_ROUNDING >= self->terms->knot_p;
}

// How far a move reaches along an axis, in the direction sign.
static double reach_of(const nck_seg_t *seg, int x, double sign) {
    const nck_seg_arc_t *const arc = &seg->shape.arc;
    const double ends = nck_max(sign * seg->start[x], sign * seg->end[x]);
    if (!nck_path_turns(seg, x)) return ends;
    const int u = arc->axis_u, v = arc->axis_v;
    const double from[2] = {seg->start[u] - arc->centre_u, seg->start[v] - arc->centre_v};
    const double to[2] = {seg->end[u] - arc->centre_u, seg->end[v] - arc->centre_v};
    int k = 0;
    if (x == v) k = 1;
    if (sign < 0.0) k += 2;
    if (!(nck_arc_bulges(from, to, arc->sweep) >> k & 1u)) return ends;
    return sign * (x == v ? arc->centre_v : arc->centre_u) + nck_arc_norm(from[0], from[1]);
}

// No axis that the move moves comes nearer to an end of its travel than a curve may stray. What
// begins or ends there goes along the exact path, so that curves keep off.
static int has_room(const nck_smooth_t *self, const nck_seg_t *seg, double stray) {
    const nck_machine_t *const machine = self->terms->machine;
    for (int x = 0; x < self->terms->axes && !machine->roams; x++) {
        if (!(nck_fabs(seg->end[x] - seg->start[x]) > 0.0 || nck_path_turns(seg, x))) continue;
        const double counts = nck_machine_counts(machine, x);
        const double low = nck_real_of(machine->axis[x].min_nm) / counts + stray;
        const double high = nck_real_of(machine->axis[x].max_nm) / counts - stray;
        if (reach_of(seg, x, 1.0) > high || -reach_of(seg, x, -1.0) < low) return 0;
    }
    return 1;
}

// Within a smaller one the axes keep their jerk, too: the path is exact and rests at corners.
static uint8_t keep_of(const nck_smooth_t *self, const nck_block_t *block) {
    const int rests = block->path_mode == NCK_PATH_TURNS || is_within(self, block);
    return rests ? NCK_KEEP_TURNS : NCK_KEEP_NOTHING;
}

static void set_spin(nck_seg_t *seg, const nck_block_t *block) {
    const int follows = block->surface > 0.0;
    seg->spin.speed = follows ? block->surface / (2.0 * NCK_PI) : block->spindle_rpm;
    seg->spin.most = follows ? block->spindle_rpm : 0.0;
    seg->spin.x = block->spindle_x_mm;
}

// NCK_EMPTY if the move has no length.
static nck_status_t make_motion(const nck_smooth_t *self, const nck_block_t *block,
                                nck_seg_t *seg) {
    set_end(self, block, seg->end);
    if (block->kind == NCK_BLOCK_ARC) set_arc(seg, block);
    const nck_metric_t metric = nck_metric_of(seg, self->terms->axes);
    seg->length = metric.length;
    if (!(seg->length > 0.0)) return NCK_EMPTY;
    seg->stop = block->path_mode == NCK_PATH_STOP;
    seg->keeps = keep_of(self, block);
    seg->rapid = block->kind == NCK_BLOCK_RAPID;
    seg->feed_scale = metric.feed_length / metric.length;
    if (seg->rapid) return NCK_OK;
    seg->feed = path_feed(block, seg);
    if (seg->spin.most > 0.0 && block->feed_mode == NCK_FEED_PER_REV) {
        seg->spin.per_rev = block->feed / 60.0 / seg->feed_scale;
    }
    return seg->feed > 0.0 ? NCK_OK : NCK_E_FEED_MISSING;
}

// The exact seg of a block that moves or rests.
static nck_status_t make_seg(const nck_smooth_t *self, const nck_block_t *block, nck_seg_t *seg) {
    seg->line = block->line;
    seg->modes = block->modes;
    seg->feed_scale = 1.0;
    set_spin(seg, block);
    memcpy(seg->start, self->position, sizeof seg->start);
    memcpy(seg->end, self->position, sizeof seg->end);
    if (block->kind <= NCK_BLOCK_ARC) return make_motion(self, block, seg);
    seg->stop = 1;
    if (block->kind == NCK_BLOCK_THREAD) {
        seg->kind = NCK_SEG_THREAD;
        seg->shape.thread = block->thread;
        set_end(self, block, seg->end);
        return NCK_OK;
    }
    if (block->kind == NCK_BLOCK_TAP) {
        seg->kind = NCK_SEG_TAP;
        seg->shape.tap = block->tap;
        return NCK_OK;
    }
    seg->kind = block->kind == NCK_BLOCK_DWELL ? NCK_SEG_DWELL : NCK_SEG_WAIT;
    seg->shape.dwell_s = block->kind == NCK_BLOCK_DWELL ? block->dwell_s : 0.0;
    return NCK_OK;
}

// All of it but start and end, which every move sets; in parts: clearing all at once takes longer.
static inline void clear_seg(nck_seg_t *seg) {
    memset(seg, 0, offsetof(nck_seg_t, start));
    memset(&seg->length, 0, offsetof(nck_seg_t, shape) - offsetof(nck_seg_t, length));
    for (int k = 0; k < 2; k++) memset(seg->shape.inner[k], 0, sizeof seg->shape.inner[k]);
}

// The seg of a block is made: the next one begins where it ends. What rests, or comes back, stays
// where it is, whatever its target says.
static void arrive(nck_smooth_t *self, const nck_block_t *block, const nck_seg_t *seg) {
    if (block->kind > NCK_BLOCK_ARC && block->kind != NCK_BLOCK_THREAD) return;
    memcpy(self->position_nm, block->target_nm, sizeof self->position_nm);
    memcpy(self->position, seg->end, sizeof self->position);
}

// 1 if the block is taken by the clocked run, which it may open; else that is over.
static int goes_clocked(nck_smooth_t *self, const nck_block_t *block) {
    nck_clocked_t *const clocked = nck_runs_of(self);
    if (is_smooth(self, block) && has_room(self, &self->next.seg, block->tolerance_mm)
        && nck_clocked_push(clocked, self->terms, &self->next.seg,
                            block->tolerance_mm - NCK_ROUNDING, self->rests) == NCK_OK) {
        return 1;
    }
    // Outputs, until the program ends.
    const int is_between = self->next.has_output && !self->next.has_seg
                           && block->kind != NCK_BLOCK_END;
    if (clocked->open && is_between && nck_clocked_has_room(clocked)) {
        nck_clocked_push_output(clocked, &self->next.output);
        return 1;
    }
    nck_clocked_close(clocked);
    return 0;
}

nck_status_t nck_smooth_push(nck_smooth_t *self, const nck_block_t *block, uint32_t block_seq) {
    if (!self->hungry) return NCK_FULL;
    assert(!waits(self));
    const int threads = block->kind >= NCK_BLOCK_THREAD;
    const int has_seg = block->kind <= NCK_BLOCK_WAIT || threads;
    nck_seg_t *const seg = &self->next.seg;
    clear_seg(seg);
    seg->block = block_seq;
    self->next.output = block->output;
    self->next.output.line = block->line;
    if (has_seg) {
        const nck_status_t status = make_seg(self, block, seg);
        if (status != NCK_OK) return status == NCK_EMPTY ? NCK_OK : status;
        arrive(self, block, seg);
    }
    if (nck_smooth_is_empty(self)) self->known = self->s;
    self->known += seg->length;
    self->hungry = 0;
    self->next.has_seg = (uint8_t)has_seg;
    self->next.has_output = block->kind >= NCK_BLOCK_WAIT && !threads;
    if (nck_runs_are_clocked(self) && goes_clocked(self, block)) {
        self->next.has_seg = 0;
        self->next.has_output = 0;
    }
    return NCK_OK;
}

// A seg gets its place on the path.
static void give_seg(nck_smooth_t *self, nck_seg_t *seg) {
    seg->seq = self->seq;
    seg->s_begin = self->s;
    self->s += seg->length;
    self->seq++;
    self->rests = seg->stop;
}

nck_status_t nck_smooth_pass(nck_smooth_t *self, const nck_block_t *block, uint32_t block_seq,
                             nck_seg_t *seg_out) {
    const int is_plain = block->kind <= NCK_BLOCK_ARC && !is_smooth(self, block);
    if (!self->hungry || !is_plain || block->surface > 0.0 || !nck_smooth_is_empty(self)) {
        return NCK_FULL;
    }
    clear_seg(seg_out);
    seg_out->block = block_seq;
    const nck_status_t status = make_seg(self, block, seg_out);
    if (status != NCK_OK) return status;
    arrive(self, block, seg_out);
    give_seg(self, seg_out);
    return NCK_OK;
}

void nck_smooth_end(nck_smooth_t *self) {
    self->ended = 1;
    self->hungry = 0;
    if (nck_runs_are_clocked(self)) nck_clocked_close(nck_runs_of(self));
}

void nck_smooth_go_on(nck_smooth_t *self) { self->ended = 0; }

// The output, then the seg, of the block that waits.
static void give_next(nck_smooth_t *self, nck_smooth_item_t *item_out) {
    item_out->is_output = self->next.has_output;
    if (self->next.has_output) {
        item_out->output = self->next.output;
        item_out->output.after_segs = self->seq;
        self->next.has_output = 0;
        return;
    }
    item_out->seg = self->next.seg;
    self->next.has_seg = 0;
}

// The next item of a clocked run. NCK_DONE: it is over.
static nck_status_t pull_clocked(nck_smooth_t *self, nck_smooth_item_t *item_out) {
    const nck_output_t *output = (nck_output_t *)0;
    const nck_status_t status = nck_clocked_pull(nck_runs_of(self), &item_out->seg, &output);
    self->hungry = status == NCK_EMPTY;
    item_out->is_output = output != NULL;
    if (!output) return status;
    item_out->output = *output;
    item_out->output.after_segs = self->seq;
    return status;
}

// The next seg or output, whatever the spindle does along it.
static nck_status_t pull_whole(nck_smooth_t *self, nck_smooth_item_t *item_out) {
    self->hungry = 0;
    if (nck_runs_is_open(self)) {
        const nck_status_t status = pull_clocked(self, item_out);
        if (status != NCK_DONE) return status;
    }
    if (!waits(self)) {
        self->hungry = !self->ended;
        return self->ended ? NCK_DONE : NCK_EMPTY;
    }
    give_next(self, item_out);
    return NCK_OK;
}

nck_status_t nck_smooth_pull(nck_smooth_t *self, nck_smooth_item_t *item_out) {
    if (!(self->divide.from < self->divide.seg.length)) {
        const nck_status_t status = pull_whole(self, item_out);
        if (status != NCK_OK || item_out->is_output) return status;
        if (item_out->seg.kind == NCK_SEG_SPLINE) {
            give_seg(self, &item_out->seg);
            return NCK_OK;
        }
        if (nck_divide_begin(self, &item_out->seg)) nck_divide_next(self, &item_out->seg);
    } else {
        item_out->is_output = 0;
        nck_divide_next(self, &item_out->seg);
    }
    give_seg(self, &item_out->seg);
    return NCK_OK;
}

void nck_smooth_hurry(nck_smooth_t *self) {
    if (!nck_runs_is_open(self) || !self->hungry) return;
    if (nck_stream_hurry(&nck_runs_of(self)->stream)) self->hungry = 0;
}

uint32_t nck_smooth_price(nck_smooth_t *self) {
    return nck_runs_is_open(self) ? nck_stream_price(&nck_runs_of(self)->stream) : 0;
}

int nck_smooth_invariants(const nck_smooth_t *self) {
    const int takes = nck_runs_is_open(self) && !NCK_OPTIMAL_VALUE(self, clocked.closed);
    return (self->next.has_seg || !(self->next.seg.length > 0.0) || !waits(self))
           && !(takes && waits(self)) && !(self->hungry && waits(self));
}
