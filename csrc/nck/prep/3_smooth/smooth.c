// SPDX-License-Identifier: MIT
// Room 3, smooth: blocks in, segs and outputs out.
#include "nck/prep/3_smooth/smooth.h"

#include <assert.h> // assert
#include <stddef.h> // offsetof
#include <string.h> // memcpy memset

#include "nck/base/budget.h"               // NCK_TOLERANCE_MIN
#include "nck/base/real.h"                 // nck_min nck_max
#include "nck/prep/3_smooth/curve.h"       // nck_curve_…
#include "nck/prep/3_smooth/divide.h"      // nck_divide_…
#include "nck/prep/3_smooth/knot.h"        // nck_knot_…
#include "nck/prep/3_smooth/merge.h"       // nck_merge_…
#include "nck/prep/3_smooth/metric_math.h" // nck_metric_of
#include "nck/prep/3_smooth/part.h"        // nck_part_…
#include "nck/prep/3_smooth/raw.h"         // nck_raw_…
#include "nck/prep/3_smooth/runs.h"        // nck_runs_…
#include "nck/prep/3_smooth/spline_math.h" // nck_spline_…

#define ROUNDING 2e-6 // [mm] kept of the tolerance: setpoints are whole nanometres

// Nothing moves faster.
static double fastest(const nck_machine_t *machine) {
    double vv = 0.0;
    for (int x = 0; x < NCK_AXIS_MAX; x++) {
        const nck_axis_t *const axis = &machine->axis[x];
        if (axis->present) vv += axis->v_max * axis->v_max;
    }
    return nck_sqrt(vv);
}

void nck_smooth_init(nck_smooth_t *self, const nck_terms_t *terms) {
    const nck_machine_t *const machine = terms->machine;
    memset(self, 0, offsetof(nck_smooth_t, raw.at)); // what the ring holds is read once written
    memset(&self->divide, 0,
           offsetof(nck_smooth_t, run) + sizeof self->run - offsetof(nck_smooth_t, divide));
    nck_clocked_init(NCK_OPTIMAL_AT(self, clocked));
    self->terms = terms;
    memcpy(self->position_nm, machine->start_nm, sizeof self->position_nm);
    for (int x = 0; x < NCK_AXIS_MAX; x++) {
        self->position[x] = (double)machine->start_nm[x] / nck_machine_counts(machine, x);
    }
    self->rests = 1;
    nck_smooth_adapt(self);
}

void nck_smooth_adapt(nck_smooth_t *self) {
    const nck_machine_t *const machine = self->terms->machine;
    if (NCK_HAS_SMOOTH) self->spacing_max = nck_curve_widest(self, fastest(machine));
    for (int x = 0; x < NCK_AXIS_MAX; x++) {
        const double counts = nck_machine_counts(machine, x);
        self->travel[0][x] = (double)machine->axis[x].min_nm / counts;
        self->travel[1][x] = (double)machine->axis[x].max_nm / counts;
    }
}

int nck_smooth_is_empty(const nck_smooth_t *self) {
    return !nck_runs_is_open(self) && self->raw.head == self->raw.tail
           && !(self->divide.from < self->divide.seg.length);
}

// Where the block ends, in what is where it begins. Most blocks move few axes: the others need no
// division.
static inline void set_end(const nck_smooth_t *self, const nck_block_t *block, double *end) {
    const nck_machine_t *const machine = self->terms->machine;
    const int axes = self->terms->axes;
    for (int x = 0; x < axes; x++) {
        if (block->target_nm[x] == self->position_nm[x]) continue;
        end[x] = (double)block->target_nm[x] / nck_machine_counts(machine, x);
    }
}

static void set_arc(nck_seg_t *seg, const nck_block_t *block) {
    nck_seg_arc_t *const arc = &seg->shape.arc;
    seg->kind = NCK_SEG_ARC;
    arc->axis_u = block->plane == 17 ? NCK_AXIS_X : block->plane == 18 ? NCK_AXIS_Z : NCK_AXIS_Y;
    arc->axis_v = block->plane == 17 ? NCK_AXIS_Y : block->plane == 18 ? NCK_AXIS_X : NCK_AXIS_Z;
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

static int is_smooth(const nck_block_t *block) {
    return NCK_HAS_SMOOTH && block->kind <= NCK_BLOCK_ARC
           && block->path_mode == NCK_PATH_CONTINUOUS && block->tolerance_mm >= NCK_TOLERANCE_MIN;
}

static uint8_t keep_of(const nck_block_t *block) {
    if (is_smooth(block)) return NCK_KEEP_SMOOTH;
    return block->path_mode == NCK_PATH_TURNS ? NCK_KEEP_TURNS : NCK_KEEP_NOTHING;
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
    seg->keeps = keep_of(block);
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

// Outputs, until the program ends: what comes next decides about the corner before them.
static int is_between(const nck_raw_t *raw) {
    return raw->has_output && !raw->has_seg && !raw->ends;
}

// Is the block at count part of a run?
static int joins(nck_smooth_t *self, uint32_t count) {
    const nck_raw_t *const raw = nck_raw_at(self, count);
    return raw->smooth || is_between(raw);
}

// Let blocks join the run at the front, up to a stop.
static void extend_run(nck_smooth_t *self) {
    if (!NCK_HAS_SMOOTH) return;
    while (self->run.open && !self->run.closed && self->run.end != self->raw.head) {
        const int begins = self->run.end == self->raw.tail;
        const int rests = !begins && nck_raw_at(self, self->run.end - 1)->seg.stop;
        if (!rests && joins(self, self->run.end)) self->run.end++;
        else self->run.closed = 1;
    }
    if (self->ended) self->run.closed = 1;
}

// Where the newest block of a run begins in it: where the run's block before it ends.
static double place_in_run(nck_smooth_t *self) {
    uint32_t count = self->raw.head;
    while (count != self->raw.tail && joins(self, count - 1)) {
        const nck_raw_t *const raw = nck_raw_at(self, count - 1);
        if (raw->smooth) return raw->seg.stop ? 0.0 : raw->s + raw->seg.length;
        count--;
    }
    return 0.0;
}

// All of it but start and end, which every move sets; in parts: clearing all at once takes longer.
static inline void clear_seg(nck_seg_t *seg) {
    memset(seg, 0, offsetof(nck_seg_t, start));
    memset(&seg->length, 0, offsetof(nck_seg_t, shape) - offsetof(nck_seg_t, length));
    for (int k = 0; k < 2; k++) memset(seg->shape.inner[k], 0, sizeof seg->shape.inner[k]);
}

static void begin_raw(nck_raw_t *raw, const nck_block_t *block, uint32_t block_seq) {
    const int threads = block->kind >= NCK_BLOCK_THREAD;
    clear_seg(&raw->seg);
    memset(&raw->s, 0, sizeof *raw - offsetof(nck_raw_t, s));
    raw->has_output = block->kind >= NCK_BLOCK_WAIT && !threads;
    raw->has_seg = block->kind <= NCK_BLOCK_WAIT || threads;
    raw->ends = block->kind == NCK_BLOCK_END;
    raw->smooth = (uint8_t)is_smooth(block);
    raw->tolerance = raw->smooth ? block->tolerance_mm - ROUNDING : 0.0;
    raw->seg.block = block_seq;
    raw->output = block->output;
    raw->output.line = block->line;
}

// The block at the head of the ring becomes part of it.
static void take_raw(nck_smooth_t *self, const nck_block_t *block) {
    if (!NCK_HAS_SMOOTH) {
        self->raw.head++;
        return;
    }
    nck_raw_t *const raw = nck_raw_at(self, self->raw.head);
    raw->s = place_in_run(self);
    if (raw->smooth) {
        raw->inside = nck_curve_inside(self, &raw->seg, raw->tolerance);
        self->mixed |= self->tolerance > 0.0 && self->tolerance != raw->tolerance;
        self->tolerance = raw->tolerance;
    }
    self->raw.head++;
    assert(self->raw.head - self->raw.tail <= NCK_SMOOTH_ROWS);
    nck_merge_begin(self, block);
    extend_run(self);
}

// Outputs wait for the path ahead: the newest one's row is that of the block behind it, too. So a
// line with an output takes no more of the ring than one without.
static void join_output(nck_smooth_t *self, nck_raw_t *raw) {
    const int is_closed = self->run.open && self->run.closed;
    if (self->raw.head == self->raw.tail || is_closed) return;
    nck_raw_t *const last = nck_raw_at(self, self->raw.head - 1);
    if (!is_between(last)) return;
    raw->output = last->output;
    raw->has_output = 1;
    *last = *raw;
    self->raw.head--;
}

// The seg of a block is made: the next one begins where it ends. What rests, or comes back, stays
// where it is, whatever its target says.
static void arrive(nck_smooth_t *self, const nck_block_t *block, const nck_seg_t *seg) {
    if (block->kind > NCK_BLOCK_ARC && block->kind != NCK_BLOCK_THREAD) return;
    memcpy(self->position_nm, block->target_nm, sizeof self->position_nm);
    memcpy(self->position, seg->end, sizeof self->position);
}

// 1 if the block is taken by the clocked run, which it may open; else that is over. A run of the
// other kind goes on to its rest.
static int goes_clocked(nck_smooth_t *self, const nck_raw_t *raw) {
    nck_clocked_t *const clocked = nck_runs_of(self);
    const int is_free = !self->run.open && self->raw.tail == self->raw.head;
    const int may_join = raw->smooth && is_free && raw->tolerance >= self->terms->knot_p;
    if (may_join && nck_clocked_push(clocked, self->terms, &raw->seg, raw->tolerance,
                                     self->rests) == NCK_OK) {
        return 1;
    }
    if (clocked->open && is_between(raw) && nck_clocked_has_room(clocked)) {
        nck_clocked_push_output(clocked, &raw->output);
        return 1;
    }
    nck_clocked_close(clocked);
    return 0;
}

nck_status_t nck_smooth_push(nck_smooth_t *self, const nck_block_t *block, uint32_t block_seq) {
    if (!self->hungry) return NCK_FULL;
    nck_raw_t *const raw = nck_raw_at(self, self->raw.head);
    begin_raw(raw, block, block_seq);
    if (raw->has_seg) {
        const nck_status_t status = make_seg(self, block, &raw->seg);
        if (status != NCK_OK) return status == NCK_EMPTY ? NCK_OK : status;
        arrive(self, block, &raw->seg);
    }
    if (nck_smooth_is_empty(self)) self->known = self->s;
    self->known += raw->seg.length;
    self->hungry = 0;
    if (nck_runs_are_clocked(self) && goes_clocked(self, raw)) return NCK_OK;
    const int is_smoothed = NCK_HAS_SMOOTH && raw->smooth;
    if (is_smoothed && nck_merge_line(self, block, &raw->seg)) return NCK_OK;
    if (is_smoothed) join_output(self, raw);
    take_raw(self, block);
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
    const int waits = self->run.open || !nck_smooth_is_empty(self);
    const int is_plain = block->kind <= NCK_BLOCK_ARC && !is_smooth(block);
    if (!self->hungry || waits || !is_plain || block->surface > 0.0) return NCK_FULL;
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
    extend_run(self);
}

void nck_smooth_go_on(nck_smooth_t *self) { self->ended = 0; }

static nck_status_t give_output(nck_smooth_t *self, nck_raw_t *raw, nck_smooth_item_t *item_out) {
    item_out->is_output = 1;
    item_out->output = raw->output;
    item_out->output.after_segs = self->seq;
    raw->has_output = 0;
    return NCK_OK;
}

// The next output of the run up to the place s.
static nck_raw_t *due_output(nck_smooth_t *self, double s) {
    const double beyond = s + nck_part_least(self);
    for (uint32_t count = self->raw.tail; count != self->run.end; count++) {
        nck_raw_t *const raw = nck_raw_at(self, count);
        if (raw->s >= beyond) return NULL;
        if (raw->has_output) return raw;
    }
    return NULL;
}

// Forget what the run has passed, but for its last seg: there it goes on, whatever outputs follow.
static void drop_passed(nck_smooth_t *self, double s) {
    const uint32_t last = nck_raw_last(self);
    while (self->raw.tail != last) {
        const nck_raw_t *const raw = nck_raw_at(self, self->raw.tail);
        if (raw->has_output || raw->s + raw->seg.length > s) return;
        self->raw.tail++;
    }
}

// Where the spline is longer than the program's path, |dp/ds| > 1, the tool keeps to the feed.
static void keep_feed(nck_seg_t *seg, double stretch) {
    if (stretch <= 1.0) return;
    seg->feed /= stretch;
    seg->feed_scale *= stretch;
    seg->spin.per_rev /= stretch;
}

static nck_status_t give_spline(nck_smooth_t *self, nck_smooth_item_t *item_out) {
    const double *const t = self->run.t;
    nck_seg_t *const seg = &item_out->seg;
    double stretch = 1.0;
    double end = nck_part_end(self);
    nck_raw_spline(self, 0, seg);
    if (seg->kind == NCK_SEG_SPLINE) end = nck_part_even(self, seg, end, &stretch);
    nck_spline_part(seg, self->run.given - t[2], end - t[2], self->terms->axes);
    memcpy(seg->start, self->run.position, sizeof seg->start);
    memcpy(self->run.position, seg->end, sizeof seg->end);
    const nck_raw_t *const raw = nck_part_raw(self, end);
    if (seg->kind == NCK_SEG_LINE) stretch = nck_raw_stretch(raw, self->terms->axes);
    nck_raw_take_words(&raw->seg, seg);
    keep_feed(seg, stretch);
    seg->stop = (uint8_t)nck_knot_rests(self, end);
    self->run.given = end;
    if (end >= t[3]) nck_knot_advance(self);
    drop_passed(self, end);
    item_out->is_output = 0;
    return NCK_OK;
}

static int run_is_over(nck_smooth_t *self) {
    return self->run.closed && self->run.t[2] >= nck_raw_known(self);
}

// The next item of the run at the front. NCK_DONE: the run is over.
static nck_status_t pull_run(nck_smooth_t *self, nck_smooth_item_t *item_out) {
    while (!run_is_over(self)) {
        if (!self->run.chosen) {
            const nck_status_t status = nck_knot_choose(self);
            if (status != NCK_OK) return status;
            self->run.chosen = 1;
        }
        nck_raw_t *const raw = due_output(self, self->run.given);
        if (raw) return give_output(self, raw, item_out);
        if (self->run.t[3] > self->run.t[2]) return give_spline(self, item_out);
        nck_knot_advance(self);
    }
    nck_raw_t *const raw = due_output(self, self->run.given);
    return raw ? give_output(self, raw, item_out) : NCK_DONE;
}

// The next item of the exact path. NCK_EMPTY: none at the front.
static nck_status_t pull_exact(nck_smooth_t *self, nck_smooth_item_t *item_out) {
    nck_raw_t *const raw = nck_raw_at(self, self->raw.tail);
    if (raw->has_output) {
        if (!raw->has_seg) self->raw.tail++;
        return give_output(self, raw, item_out);
    }
    self->raw.tail++;
    item_out->seg = raw->seg;
    item_out->is_output = 0;
    return NCK_OK;
}

static void open_run(nck_smooth_t *self) {
    self->run.open = 1;
    self->run.closed = 0;
    self->run.end = self->raw.tail;
    extend_run(self);
    nck_knot_begin(self);
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
    self->run.tries = 0;
    if (nck_runs_is_open(self)) {
        const nck_status_t status = pull_clocked(self, item_out);
        if (status != NCK_DONE) return status;
    }
    if (NCK_HAS_SMOOTH && self->run.open) {
        const nck_status_t status = pull_run(self, item_out);
        self->hungry = status == NCK_EMPTY;
        if (status != NCK_DONE) return status;
        self->run.open = 0;
        self->raw.tail = self->run.end;
    }
    if (self->raw.tail == self->raw.head) {
        self->hungry = !self->ended;
        return self->ended ? NCK_DONE : NCK_EMPTY;
    }
    const int is_exact = !NCK_HAS_SMOOTH || !nck_raw_at(self, self->raw.tail)->smooth;
    if (is_exact) return pull_exact(self, item_out);
    open_run(self);
    const nck_status_t status = pull_run(self, item_out);
    self->hungry = status == NCK_EMPTY;
    return status;
}

nck_status_t nck_smooth_pull(nck_smooth_t *self, nck_smooth_item_t *item_out) {
    if (!(self->divide.from < self->divide.seg.length)) {
        const nck_status_t status = pull_whole(self, item_out);
        if (status != NCK_OK || item_out->is_output) return status;
        if (item_out->seg.keeps == NCK_KEEP_CLOCK) {
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

int nck_smooth_invariants(const nck_smooth_t *self) {
    int good = self->raw.head - self->raw.tail <= NCK_SMOOTH_ROWS;
    for (uint32_t k = self->raw.tail; good && k != self->raw.head; k++) {
        const nck_raw_t *const raw = &self->raw.at[k & (NCK_SMOOTH_ROWS - 1)];
        good = raw->has_seg || !(raw->seg.length > 0.0);
    }
    if (!NCK_HAS_SMOOTH || !self->run.open) return good;
    good = good && self->run.end - self->raw.tail <= self->raw.head - self->raw.tail;
    for (int i = 0; i < 5; i++) good = good && self->run.t[i] <= self->run.t[i + 1];
    return good;
}
