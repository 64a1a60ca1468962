// SPDX-License-Identifier: MIT
// A plan by grades becomes cells.
#include "host/grade.h"

#include <string.h> // memset

#include "host/grade_math.h"            // nck_grade_of nck_grade_vv
#include "nck/base/thread.h"            // nck_thread_rest_s
#include "nck/prep/5_slope/ramp_math.h" // nck_ramp_…

// What is left of a length below this share of it is rounding.
#define LENGTH_EPSILON 1e-12

static int moves(const nck_seg_t *seg) { return seg->kind < NCK_SEG_DWELL; }

static void add_phase(nck_host_grade_cursor_t *cursor, double length, double vv0, double vv1) {
    if (!(length > 0.0)) return;
    cursor->lengths[cursor->phases] = length;
    cursor->ends[cursor->phases][0] = vv0;
    cursor->ends[cursor->phases][1] = vv1;
    cursor->phases++;
}

// The phases of the cursor's unit: one ramp (15). From rest to rest (15) would never arrive: there
// it is up, along and down, within the unit's own speed.
static void begin_unit(const nck_host_grades_t *self, nck_host_grade_cursor_t *cursor) {
    const nck_host_stretch_t *const stretch = &self->stretches[cursor->stretch];
    const nck_grade_rule_t *const rule = &stretch->rule;
    const nck_unit_t *const unit = &self->units[cursor->unit];
    const int32_t *const grade = self->grade + cursor->unit + cursor->stretch;
    const double vv0 = nck_grade_vv(rule, grade[0]);
    const double vv1 = nck_grade_vv(rule, grade[1]);
    cursor->seg = unit->seg;
    cursor->s = unit->s;
    cursor->phase = 0;
    cursor->phases = 0;
    cursor->done = 0.0;
    if (vv0 > 0.0 || vv1 > 0.0) {
        add_phase(cursor, unit->length, vv0, vv1);
        return;
    }
    const double v = self->v[cursor->unit];
    const double peak = nck_ramp_peak(unit->length, 0.0, 0.0, rule->a, v * v);
    const double ramp = nck_min(unit->length / 2.0, nck_ramp_length(0.0, peak, rule->a));
    add_phase(cursor, ramp, 0.0, peak);
    add_phase(cursor, unit->length - 2.0 * ramp, peak, peak);
    add_phase(cursor, ramp, peak, 0.0);
}

// What holds the speed in the unit: acceleration while it changes; the unit itself or a junction at
// one of its ends while it does not.
static uint8_t held_by(const nck_host_grades_t *self, const nck_host_grade_cursor_t *cursor,
                       double a) {
    const nck_host_stretch_t *const stretch = &self->stretches[cursor->stretch];
    const size_t point = cursor->unit + cursor->stretch;
    const double v = self->v[cursor->unit];
    const int32_t g = self->grade[point];
    if (a != 0.0) return NCK_LIMIT_ACCEL;
    if (cursor->phases > 1 || g >= nck_grade_of(&stretch->rule, v * v)) {
        return self->unit_limit[cursor->unit];
    }
    const int at_junction = self->preplanned[point] == g || self->preplanned[point + 1] == g;
    return at_junction ? NCK_LIMIT_CORNER : NCK_LIMIT_ACCEL;
}

// v² at the length `at` of the phase under way.
static double vv_at(const nck_host_grade_cursor_t *cursor, double at) {
    const double *const ends = cursor->ends[cursor->phase];
    const double length = cursor->lengths[cursor->phase];
    return at < length ? ends[0] + (ends[1] - ends[0]) * (at / length) : ends[1];
}

// Behind what is made: the unit's next seg, the next phase.
static void move_on(nck_host_grade_cursor_t *cursor, int leaves, int ends_unit, int finishes) {
    if (leaves && !ends_unit) {
        cursor->seg++;
        cursor->s = 0.0;
    }
    if (finishes) {
        cursor->phase++;
        cursor->done = 0.0;
    }
}

// The phase as far as its seg goes, or the rest of it. 0 if rounding alone is left of either.
static int make_cell(const nck_host_grades_t *self, nck_host_grade_cursor_t *cursor,
                     nck_cell_t *cell) {
    const nck_unit_t *const unit = &self->units[cursor->unit];
    const nck_seg_t *const seg = &self->segs[cursor->seg];
    const int ends_unit = cursor->seg == unit->seg_end;
    const int last_phase = cursor->phase + 1 == cursor->phases;
    const double whole = cursor->lengths[cursor->phase];
    const double room = (ends_unit ? unit->s_end : seg->length) - cursor->s;
    const double left = whole - cursor->done;
    const int leaves = last_phase || left > room + whole * LENGTH_EPSILON; // the seg, or the unit
    const int finishes = leaves ? ends_unit && last_phase : 1;             // the phase
    const double length = leaves ? room : nck_min(left, room);
    const double vv0 = vv_at(cursor, cursor->done);
    const double vv1 = finishes ? cursor->ends[cursor->phase][1]
                               : vv_at(cursor, cursor->done + length);
    memset(cell, 0, sizeof *cell);
    cell->seg = seg->seq;
    cell->s = cursor->s;
    cell->length = length;
    cell->v = nck_sqrt(vv0);
    cell->last = (uint8_t)(leaves && (!ends_unit || unit->s_end >= seg->length));
    cursor->s += length;
    cursor->done += length;
    move_on(cursor, leaves, ends_unit, finishes);
    const int made = length > 0.0 && vv0 + vv1 > 0.0;
    cell->a = made ? nck_ramp_accel(length, vv0, vv1) : 0.0;
    cell->duration = made ? nck_ramp_duration(length, cell->v, nck_sqrt(vv1)) : 0.0;
    cell->limit = held_by(self, cursor, cell->a);
    return made;
}

static void make_rest(const nck_seg_t *seg, nck_cell_t *cell) {
    memset(cell, 0, sizeof *cell);
    cell->seg = seg->seq;
    cell->duration = nck_thread_rest_s(seg);
    cell->limit = seg->kind == NCK_SEG_DWELL    ? NCK_LIMIT_DWELL
                  : seg->kind >= NCK_SEG_THREAD ? NCK_LIMIT_THREAD
                                                : NCK_LIMIT_WAIT;
    cell->last = 1;
    cell->stop = 1;
}

// The unit is over: the next one, or the end of the stretch, at rest.
static void end_unit(const nck_host_grades_t *self, nck_host_grade_cursor_t *cursor,
                     nck_cell_t *cell) {
    const nck_host_stretch_t *const stretch = &self->stretches[cursor->stretch];
    const double v_end = nck_sqrt(nck_grade_vv(&stretch->rule,
                                               self->grade[cursor->unit + cursor->stretch + 1]));
    cursor->unit++;
    cursor->phases = 0;
    cursor->phase = 0;
    cell->stop = (uint8_t)!(v_end > 0.0);
    if (cursor->unit < stretch->unit_end) return;
    cursor->seg = stretch->seg_end;
    cursor->stretch++;
}

int nck_host_grade_next(void *user, nck_cell_t *cell_out) {
    nck_host_grade_cursor_t *const cursor = user;
    const nck_host_grades_t *const self = cursor->grades;
    for (;;) {
        if (cursor->phase == cursor->phases) {
            if (cursor->seg == self->seg_count) return 0;
            if (!moves(&self->segs[cursor->seg])) {
                make_rest(&self->segs[cursor->seg], cell_out);
                cursor->seg++;
                return 1;
            }
            begin_unit(self, cursor);
        }
        const int made = make_cell(self, cursor, cell_out);
        if (cursor->phase == cursor->phases) end_unit(self, cursor, cell_out);
        if (made || cell_out->stop) return 1;
    }
}
