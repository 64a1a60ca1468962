// SPDX-License-Identifier: MIT
// Room 6, interpolate: the tick.
#include "nck/tick/6_interpolate/interpolate.h"

#include <string.h> // memset

#include "nck/base/fence.h"     // nck_fence_load nck_fence_store
#include "nck/base/path_math.h" // nck_path_point
#include "nck/base/real.h"      // nck_floor

void nck_interpolate_init(nck_interpolate_t *self, const nck_machine_t *machine, nck_link_t *link) {
    memset(self, 0, sizeof *self);
    self->machine = machine;
    self->link = link;
    for (int x = 0; x < NCK_AXIS_MAX; x++) {
        self->pose.axis[x] = (double)machine->start_nm[x] / nck_machine_counts(machine, x);
    }
    self->pose.feed_scale = 1.0;
    self->cell.stop = 1;
}

static int fetch(nck_interpolate_t *self) {
    int from_tail = 0;
    if (nck_link_take(self->link, &self->cell, &from_tail) != NCK_OK) return 0;
    self->has_cell = 1;
    self->from_tail = (uint32_t)from_tail;
    nck_link_seg_finish(self->link, self->cell.seg);
    return 1;
}

// Stand at s of the cell's seg.
static void place(nck_interpolate_t *self, double s, double v) {
    const nck_seg_t *const seg = nck_link_seg(self->link, self->cell.seg);
    nck_pose_t *const pose = &self->pose;
    pose->seg = seg->seq;
    pose->line = seg->line;
    pose->block = seg->block;
    pose->kind = seg->kind;
    pose->rapid = seg->rapid;
    pose->limit = self->cell.limit;
    pose->s = seg->s_begin + s;
    pose->v = v;
    pose->feed = seg->feed;
    pose->feed_scale = seg->feed_scale;
    pose->state = self->from_tail ? NCK_TICK_STARVED
                  : seg->kind == NCK_SEG_DWELL ? NCK_TICK_DWELL
                  : seg->kind == NCK_SEG_WAIT ? NCK_TICK_WAIT : NCK_TICK_MOVE;
    if (seg->kind < NCK_SEG_DWELL) nck_path_point(seg, s, pose->axis);
}

static void leave_cell(nck_interpolate_t *self) {
    self->t_cell += self->cell.duration;
    self->has_cell = 0;
    if (self->cell.last) nck_link_seg_finish(self->link, self->cell.seg + 1);
}

// Come to rest at the end of the cell: the count of periods begins anew.
static void land(nck_interpolate_t *self) {
    const nck_seg_t *const seg = nck_link_seg(self->link, self->cell.seg);
    place(self, self->cell.last ? seg->length : self->cell.s + self->cell.length, 0.0);
    self->waits = seg->kind == NCK_SEG_WAIT;
    nck_fence_store(&self->resume, 0);
    leave_cell(self);
    if (self->from_tail) nck_link_tail_rest(self->link);
    self->k = 0;
    self->t_cell = 0.0;
}

// s(t) = s0 + v·t + a·t²/2 + j·t³/6, never beyond the cell; t from the begin of the cell.
static void evaluate(nck_interpolate_t *self, double t) {
    const nck_cell_t *const cell = &self->cell;
    const double ds = (cell->v + (cell->a / 2.0 + cell->j / 6.0 * t) * t) * t;
    const double v = cell->v + (cell->a + cell->j / 2.0 * t) * t;
    place(self, cell->s + nck_max(0.0, nck_min(ds, cell->length)), nck_max(0.0, v));
}

// Nothing to execute: stay. In the middle of the path that is starvation.
static const nck_pose_t *rest(nck_interpolate_t *self) {
    const int on_path = !self->cell.stop || self->from_tail;
    self->k = 0;
    self->t_cell = 0.0;
    self->pose.v = 0.0;
    self->pose.state = on_path ? NCK_TICK_STARVED : NCK_TICK_IDLE;
    self->pose.limit = on_path ? NCK_LIMIT_STARVED : NCK_LIMIT_EXACT_STOP;
    return &self->pose;
}

const nck_pose_t *nck_interpolate_tick(nck_interpolate_t *self) {
    if (self->waits) {
        if (!nck_fence_load(&self->resume)) return &self->pose;
        nck_fence_store(&self->resume, 0);
        self->waits = 0;
    }
    if (!self->has_cell && !fetch(self)) return rest(self);
    const double period = self->machine->period_s;
    self->k++;
    while ((double)self->k * period >= self->t_cell + self->cell.duration) {
        if (self->cell.stop) {
            land(self);
            return &self->pose;
        }
        leave_cell(self);
        self->k -= nck_interpolate_rebase(&self->t_cell, period);
        const double end = self->cell.s + self->cell.length;
        if (!fetch(self)) {
            place(self, end, 0.0);
            return rest(self);
        }
    }
    evaluate(self, (double)self->k * period - self->t_cell);
    return &self->pose;
}

nck_status_t nck_interpolate_take(nck_interpolate_t *self, nck_cell_t *cell_out) {
    if (nck_link_waiting(self->link) == 0 || !fetch(self)) return NCK_EMPTY;
    leave_cell(self);
    *cell_out = self->cell;
    return NCK_OK;
}

void nck_interpolate_resume(nck_interpolate_t *self) { nck_fence_store(&self->resume, 1); }

uint64_t nck_interpolate_periods(double t, double period) {
    uint64_t k = (uint64_t)(t / period);
    while ((double)k * period < t) k++;
    while (k > 0 && (double)(k - 1) * period >= t) k--;
    return k > 0 ? k : 1;
}

uint64_t nck_interpolate_rebase(double *t, double period) {
    const double span = (double)NCK_INTERPOLATE_SPAN * period;
    if (*t < span) return 0;
    const double spans = nck_floor(*t / span);
    *t -= spans * span;
    return (uint64_t)spans * NCK_INTERPOLATE_SPAN;
}
