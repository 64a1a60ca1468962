// SPDX-License-Identifier: MIT
// Planning by grades, first half: commanded speeds, stretches, units.
#include "host/grade.h"

#include <float.h>  // DBL_MAX
#include <string.h> // memset

#include "host/grade_math.h"               // nck_grade_…
#include "nck/base/envelope_math.h"        // nck_envelope_h
#include "nck/base/path_math.h"            // nck_path_turns
#include "nck/prep/4_lookahead/junction.h" // nck_junction_make
#include "nck/prep/5_slope/slope.h"        // nck_slope_terms

// A length within this share of a border is at it.
#define LENGTH_EPSILON 1e-9
#define COUNT_MAX 2147483647.0

static int is_finite(double x) { return x >= -DBL_MAX && x <= DBL_MAX; }

static int is_positive(double x) { return x > 0.0 && x <= DBL_MAX; }

nck_status_t nck_host_grade_rule(const nck_machine_t *machine, double v_command, double v_min,
                                 double a, uint32_t steps, nck_grade_rule_t *rule_out) {
    nck_grade_rule_t rule;
    memset(&rule, 0, sizeof rule);
    if (!is_positive(v_command) || !is_positive(a) || steps == 0) return NCK_E_ARGUMENT;
    if (!(v_min >= 0.0 && v_min < v_command)) return NCK_E_ARGUMENT;
    rule.period_s = machine->period_s;
    rule.v_max = v_command;
    rule.v_min = v_min;
    rule.a = a;
    rule.length = nck_grade_length(steps, v_command, machine->period_s);
    rule.length_error = machine->path.chord_error;
    rule.chord_error = machine->path.chord_error;
    rule.steps = steps;
    for (int x = 0; x < NCK_AXIS_MAX; x++) {
        if (machine->axis[x].present) rule.a_axis[x] = machine->axis[x].a_max;
    }
    const double count = nck_grade_count(v_command, v_min, nck_envelope_h(a, rule.length));
    if (!(count < COUNT_MAX)) return NCK_E_ARGUMENT;
    rule.count = (uint32_t)count;
    *rule_out = rule;
    return NCK_OK;
}

static int moves(const nck_seg_t *seg) { return seg->kind < NCK_SEG_DWELL; }

static int is_good_seg(const nck_seg_t *seg) {
    if (!moves(seg)) return seg->shape.dwell_s >= 0.0 && seg->shape.dwell_s <= DBL_MAX;
    int good = is_positive(seg->length) && is_positive(seg->feed_scale);
    good &= seg->rapid ? is_finite(seg->feed) : is_positive(seg->feed);
    for (int x = 0; x < NCK_AXIS_MAX; x++) {
        good &= is_finite(seg->start[x]) && is_finite(seg->end[x]);
    }
    if (seg->kind != NCK_SEG_ARC) return good;
    const nck_seg_arc_t *const arc = &seg->shape.arc;
    good &= arc->axis_u < NCK_AXIS_MAX && arc->axis_v < NCK_AXIS_MAX;
    return good && is_finite(arc->centre_u) && is_finite(arc->centre_v) && is_finite(arc->sweep);
}

// The chord error is left to the steps inside a unit, so it must not cut a stretch here.
nck_status_t nck_host_grade_command(nck_host_grades_t *self) {
    nck_machine_t machine = *self->machine;
    machine.path.chord_error = DBL_MAX;
    nck_terms_t terms;
    nck_slope_terms(&machine, &terms);
    for (size_t i = 0; i < self->seg_count; i++) {
        const nck_seg_t *const seg = &self->segs[i];
        nck_junction_t junction;
        double start[NCK_AXIS_MAX];
        double end[NCK_AXIS_MAX];
        self->bad = i;
        if (!is_good_seg(seg)) return NCK_E_ARGUMENT;
        const double *const begin = nck_junction_tangents(seg, terms.axes, start, end);
        nck_junction_make(&junction, seg, begin, end, &terms);
        self->v_command[i] = junction.v_max;
        self->limit[i] = junction.limit;
    }
    return NCK_OK;
}

// The smallest acceleration limit of the path and of the axes that the program moves.
static double common_accel(const nck_host_grades_t *self) {
    const nck_machine_t *const machine = self->machine;
    uint32_t moved = 0;
    for (size_t i = 0; i < self->seg_count; i++) {
        const nck_seg_t *const seg = &self->segs[i];
        for (int x = 0; x < NCK_AXIS_MAX; x++) {
            if (nck_path_turns(seg, x) || seg->start[x] != seg->end[x]) moved |= 1u << x;
        }
    }
    double a = machine->path.a_max;
    for (int x = 0; x < NCK_AXIS_MAX; x++) {
        if (moved >> x & 1u) a = nck_min(a, machine->axis[x].a_max);
    }
    return a;
}

// The commanded speeds of a stretch under way.
typedef struct speeds {
    double least, most;
} speeds_t;

// 1 if one table serves all of them: they are equal, or the slowest is still a good grade of the
// fastest.
static int share_a_table(const nck_host_grades_t *self, double a, const speeds_t *speeds) {
    nck_grade_rule_t rule;
    if (speeds->least == speeds->most) return 1;
    return nck_host_grade_rule(self->machine, speeds->most, 0.0, a, self->steps, &rule) == NCK_OK
           && nck_grade_of(&rule, speeds->least * speeds->least) >= NCK_HOST_GRADE_LEAST;
}

// Where the stretch that begins at seg begin ends; its speeds.
static size_t stretch_end(const nck_host_grades_t *self, size_t begin, double a,
                          speeds_t *speeds_out) {
    speeds_t speeds = {DBL_MAX, 0.0};
    size_t end = begin;
    while (end < self->seg_count && moves(&self->segs[end])) {
        const double v = self->v_command[end];
        const speeds_t with = {nck_min(speeds.least, v), nck_max(speeds.most, v)};
        if (!share_a_table(self, a, &with)) break;
        speeds = with;
        end++;
        if (self->segs[end - 1].stop) break;
    }
    *speeds_out = speeds;
    return end;
}

nck_status_t nck_host_grade_stretches(nck_host_grades_t *self) {
    const double a = common_accel(self);
    size_t i = 0;
    self->stretch_count = 0;
    for (size_t k = 0; k < self->seg_count; k++) {
        self->bad = k;
        if (moves(&self->segs[k]) && !is_positive(self->v_command[k])) return NCK_E_ARGUMENT;
    }
    while (i < self->seg_count) {
        nck_host_stretch_t stretch;
        speeds_t speeds;
        memset(&stretch, 0, sizeof stretch);
        self->bad = i;
        stretch.seg_begin = i;
        i++;
        if (!moves(&self->segs[stretch.seg_begin])) continue;
        i = stretch_end(self, stretch.seg_begin, a, &speeds);
        stretch.seg_end = i;
        const nck_status_t status = nck_host_grade_rule(self->machine, speeds.most, 0.0, a,
                                                        self->steps, &stretch.rule);
        if (status != NCK_OK) return status;
        if (self->stretch_count < self->stretch_max) {
            self->stretches[self->stretch_count] = stretch;
        }
        self->stretch_count++;
    }
    return self->stretch_count > self->stretch_max ? NCK_FULL : NCK_OK;
}

// Segs first … last, to be cut into units.
typedef struct group {
    size_t first, last;
    double length;
    size_t unit_begin; // count of units before them
} group_t;

static void put_unit(nck_host_grades_t *self, const nck_unit_t *unit) {
    nck_unit_t *const at = &self->units[self->unit_count];
    self->unit_count++;
    *at = *unit;
    at->v_command = DBL_MAX;
    for (uint32_t k = unit->seg; k <= unit->seg_end; k++) {
        if (self->v_command[k] >= at->v_command) continue;
        at->v_command = self->v_command[k];
        at->limit = self->limit[k];
    }
}

static double part_count(double length, double unit_length) {
    return nck_max(1.0, nck_floor(length / unit_length * (1.0 + LENGTH_EPSILON)));
}

// Cut a group into equal units; where they find no room, they are counted only. A cut next to the
// end of a seg falls on it.
static void cut(nck_host_grades_t *self, const group_t *group, double parts) {
    if ((double)self->unit_count + parts > (double)self->unit_max) {
        self->unit_count += (size_t)parts;
        return;
    }
    nck_unit_t unit;
    memset(&unit, 0, sizeof unit);
    double before = 0.0; // path from the group's begin to the seg's start
    uint32_t seg = (uint32_t)group->first;
    unit.length = group->length / parts;
    unit.seg = seg;
    for (double k = 1.0; k < parts; k += 1.0) {
        const double slack = unit.length * LENGTH_EPSILON;
        while (unit.length * k - before > self->segs[seg].length + slack) {
            before += self->segs[seg].length;
            seg++;
        }
        const int at_end = unit.length * k - before >= self->segs[seg].length - slack;
        unit.seg_end = seg;
        unit.s_end = at_end ? self->segs[seg].length : unit.length * k - before;
        put_unit(self, &unit);
        if (at_end) before += self->segs[seg].length;
        seg += at_end ? 1u : 0u;
        unit.seg = seg;
        unit.s = at_end ? 0.0 : unit.s_end;
    }
    unit.seg_end = (uint32_t)group->last;
    unit.s_end = self->segs[group->last].length;
    put_unit(self, &unit);
}

static nck_status_t divide_stretch(nck_host_grades_t *self, const nck_host_stretch_t *stretch) {
    const double unit_length = stretch->rule.length;
    group_t group = {stretch->seg_begin, stretch->seg_begin, 0.0, self->unit_count};
    group_t done = group;
    for (size_t i = stretch->seg_begin; i < stretch->seg_end; i++) {
        self->bad = i;
        if (!is_positive(self->segs[i].length)) return NCK_E_ARGUMENT;
        group.last = i;
        group.length += self->segs[i].length;
        if (group.length < unit_length * (1.0 - LENGTH_EPSILON)) continue;
        const double parts = part_count(group.length, unit_length);
        self->bad = self->seg_count;
        if ((double)self->unit_count + parts >= COUNT_MAX) return NCK_E_ARGUMENT;
        cut(self, &group, parts);
        done = group;
        group = (group_t){i + 1, i, 0.0, self->unit_count};
    }
    if (group.first > group.last) return NCK_OK;
    if (done.unit_begin < self->unit_count) {
        group.first = done.first;
        group.length += done.length;
        self->unit_count = done.unit_begin;
    }
    cut(self, &group, part_count(group.length, unit_length));
    return NCK_OK;
}

nck_status_t nck_host_grade_divide(nck_host_grades_t *self) {
    self->unit_count = 0;
    for (size_t k = 0; k < self->stretch_count; k++) {
        nck_host_stretch_t *const stretch = &self->stretches[k];
        stretch->unit_begin = self->unit_count;
        const nck_status_t status = divide_stretch(self, stretch);
        if (status != NCK_OK) return status;
        stretch->unit_end = self->unit_count;
    }
    return self->unit_count > self->unit_max ? NCK_FULL : NCK_OK;
}
