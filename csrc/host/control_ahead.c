// SPDX-License-Identifier: MIT
// Other controls: how far they look ahead, and what they make of it.
//
// A ring: when a line begins, those that fit into the ring behind it are known, and the last of
// them ends at rest. Klipper: all are known; where the array is full, what is certain leaves.
#include "host/control_parts.h"

#include <string.h> // memmove memset

#include "nck/base/real.h" // nck_min

// Marlin ends no slower [mm²/s²].
#define END_MARLIN 0.0025
// Two numbers are the same within this share.
#define SAME 1e-9

static size_t waiting(const nck_host_control_t *self) { return self->line_end - self->line_begin; }

static double vv_end_of(const nck_host_control_t *self) {
    return self->rule.kind == NCK_HOST_CONTROL_MARLIN ? END_MARLIN : 0.0;
}

static void tell_low(nck_host_control_t *self, const nck_host_control_line_t *line,
                     uint32_t limit) {
    nck_host_low_t low;
    memset(&low, 0, sizeof low);
    low.limit = limit;
    low.seg = line->number;
    low.line = line->line;
    low.axis = limit >= NCK_LIMIT_AXIS_V ? limit - NCK_LIMIT_AXIS_V : NCK_AXIS_MAX;
    low.angle = limit == NCK_LIMIT_CORNER ? line->angle : 0.0;
    nck_control_low(self, &low);
}

// The first line that waits is final. is_end: the path rests behind the last one.
static void give_first(nck_host_control_t *self, int is_end) {
    const nck_host_control_line_t *const first = &self->lines[self->line_begin];
    const nck_host_control_line_t *const next = first + 1;
    const size_t count = waiting(self);
    const double v = first[count - 1].v;
    double vv = nck_min(vv_end_of(self), v * v);
    int sees_end = 1;
    for (size_t k = count - 1; k > 0; k--) {
        const nck_host_control_line_t *const line = &first[k];
        vv += line->gain;
        sees_end = sees_end && vv < line->cap;
        vv = nck_min(vv, line->cap);
    }
    if (self->at_rest) self->vv = nck_min(first->cap, vv + first->gain);
    self->at_rest = 0;
    vv = nck_min(vv, self->vv + first->gain);
    nck_control_spend(self, first, vv);
    self->line_begin++;
    if (count == 1) return;
    if (vv >= next->cap * (1.0 - SAME)) tell_low(self, next, next->limit_cap);
    else if (sees_end && !is_end) tell_low(self, next, NCK_LIMIT_LOOKAHEAD);
}

// Klipper's pass from the last line to the first, once under the acceleration and once under what
// the minimum cruise ratio leaves of it. How fast a line may be in between is decided at the top:
// where the second speed can both be reached and be left. What comes before a top waits for it.
typedef struct klipper_pass {
    double start, smooth;      // v² at the start of the line behind
    double peak;               // at the top behind, v²; 0: none yet
    size_t certain;            // lines before this one are certain
    size_t delayed;            // one past the last line that waits for a top
    uint32_t waits;            // 1: there are such
} klipper_pass_t;

static void plan_line(nck_host_control_line_t *line, double start, double reach, double peak) {
    line->cruise = nck_min(nck_min(0.5 * (start + reach), line->v * line->v), peak);
    line->start = nck_min(start, line->cruise);
}

// The lines that waited for a top go up to it and no further.
static void plan_delayed(nck_host_control_t *self, size_t begin, size_t end, double peak) {
    double most = peak;
    for (size_t k = begin; k < end; k++) {
        nck_host_control_line_t *const line = &self->lines[k];
        most = nck_min(most, line->start);
        line->cruise = most;
        line->start = most;
    }
}

static void pass_line(nck_host_control_t *self, klipper_pass_t *pass, size_t k) {
    nck_host_control_line_t *const line = &self->lines[k];
    const double reach = pass->start + line->gain;
    const double start = nck_min(line->reach, reach);
    const double smooth_reach = pass->smooth + line->smooth_gain;
    const double smooth = nck_min(line->smooth_cap, smooth_reach);
    if (smooth < smooth_reach) { // it may go faster in between
        if (smooth + line->smooth_gain > pass->smooth || pass->waits) {
            if (pass->certain == 0 && pass->peak > 0.0) pass->certain = k;
            pass->peak = nck_min(line->v * line->v, 0.5 * (smooth + smooth_reach));
            if (pass->waits) plan_delayed(self, k + 1, pass->delayed, pass->peak);
            pass->waits = 0;
        }
        plan_line(line, start, reach, pass->peak);
    } else {
        if (!pass->waits) pass->delayed = k + 1;
        pass->waits = 1;
        line->start = start;
    }
    pass->start = start;
    pass->smooth = smooth;
}

// Plans all that wait; of them it gives the first ones: all at a rest, else those that are certain,
// or, where none are, half of them.
static void give_klipper(nck_host_control_t *self, int is_end) {
    const size_t begin = self->line_begin;
    const size_t end = self->line_end;
    klipper_pass_t pass;
    memset(&pass, 0, sizeof pass);
    for (size_t k = end; k > begin; k--) pass_line(self, &pass, k - 1);
    size_t last = end;
    if (!is_end) last = pass.certain > begin ? pass.certain : begin + (end - begin) / 2;
    for (size_t k = begin; k < last; k++) {
        const nck_host_control_line_t *const line = &self->lines[k];
        const nck_host_control_line_t *const next = line + 1;
        const int more = k + 1 < end;
        self->vv = line->start;
        const double vv = more ? nck_min(next->start, line->cruise) : 0.0;
        nck_control_spend(self, line, vv);
        if (more && vv >= next->cap * (1.0 - SAME)) tell_low(self, next, next->limit_cap);
    }
    self->line_begin = last;
}

static int sees_all(const nck_host_control_t *self) {
    return self->rule.kind == NCK_HOST_CONTROL_KLIPPER;
}

// Room for one more at the end.
static void make_room(nck_host_control_t *self) {
    if (self->line_end < self->line_max) return;
    if (sees_all(self)) give_klipper(self, 0);
    const size_t count = waiting(self);
    memmove(self->lines, &self->lines[self->line_begin], count * sizeof self->lines[0]);
    self->line_begin = 0;
    self->line_end = count;
}

void nck_control_add(nck_host_control_t *self, const nck_host_control_line_t *line) {
    make_room(self);
    if (self->low.line == 0) self->low.line = line->line; // the program's begin
    self->lines[self->line_end] = *line;
    self->line_end++;
    self->last = *line;
    self->has_last = 1;
    self->queued++;
    if (!sees_all(self) && waiting(self) == self->rule.ahead) give_first(self, 0);
}

void nck_control_rest(nck_host_control_t *self, uint32_t limit, uint32_t line) {
    nck_host_low_t low;
    nck_control_unblend(self);
    if (sees_all(self)) give_klipper(self, 1);
    while (waiting(self) > 0) give_first(self, 1);
    if (!self->has_last) return;
    memset(&low, 0, sizeof low);
    low.limit = limit;
    low.seg = self->block;
    low.line = line;
    low.axis = NCK_AXIS_MAX;
    nck_control_low(self, &low);
    self->vv = 0.0;
    self->at_rest = 1;
    self->has_last = 0;
    self->queued = 0;
}
