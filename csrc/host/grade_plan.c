// SPDX-License-Identifier: MIT
// Planning by grades, second half: speeds, transfers, bubble, accelerations.
#include "host/grade.h"

#include "host/bubble_math.h"   // nck_bubble_sweep nck_bubble_scan
#include "host/grade_math.h"    // nck_grade_of nck_grade_vv
#include "host/turn_math.h"     // nck_turn_angle nck_turn_transfer
#include "host/transfer_math.h" // nck_transfer_reach
#include "host/unit_math.h"     // nck_unit_step_count nck_unit_speed
#include "nck/prep/5_slope/ramp_math.h"         // nck_ramp_accel

// How far a rounded speed may be off, relative.
#define SPEED_EPSILON 1e-9

void nck_host_unit_speeds(nck_host_grades_t *self, size_t k) {
    const nck_host_stretch_t *const stretch = &self->stretches[k];
    for (size_t i = stretch->unit_begin; i < stretch->unit_end; i++) {
        const nck_unit_t *const unit = &self->units[i];
        int limit = 0;
        const int n = nck_unit_step_count(self->segs, unit, &stretch->rule, &limit);
        self->v[i] = nck_unit_speed(unit, stretch->rule.period_s, n);
        self->n_step[i] = (uint32_t)n;
        self->unit_limit[i] = (uint8_t)limit;
    }
}

double nck_host_link_angle(const nck_seg_t *in, const nck_seg_t *out) {
    return nck_turn_angle(in, out);
}

void nck_host_transfers(nck_host_grades_t *self, size_t k) {
    const nck_host_stretch_t *const stretch = &self->stretches[k];
    const nck_grade_rule_t *const rule = &stretch->rule;
    for (size_t i = stretch->unit_begin; i <= stretch->unit_end; i++) {
        const int inside = i > stretch->unit_begin && i < stretch->unit_end;
        const size_t point = i + k;
        double v = 0.0;
        self->angle[point] = 0.0;
        if (inside) {
            const double v_free = nck_min(self->v[i - 1], self->v[i]);
            v = nck_turn_transfer(self->segs, &self->units[i - 1], rule, v_free,
                                  &self->angle[point]);
        }
        self->v_transfer[point] = v;
        self->preplanned[point] = inside ? nck_grade_of(rule, v * v) : 0;
    }
}

// NCK_OK if all grades can be counted up from; else *bad_out is the first that cannot.
static nck_status_t check_grades(const int32_t *p, size_t n, size_t *bad_out) {
    size_t i = 0;
    while (i < n && p[i] >= 0 && p[i] < INT32_MAX) i++;
    *bad_out = i;
    return i < n ? NCK_E_ARGUMENT : NCK_OK;
}

// One sweep from the grades g to next. 1 if anything changed. The neighbour that an end lacks
// never limits.
static int sweep(const int32_t *p, size_t n, const int32_t *g, int32_t *next) {
    int changed = 0;
    for (size_t i = 0; i < n; i++) {
        const int32_t left = i > 0 ? g[i - 1] : p[i];
        const int32_t right = i + 1 < n ? g[i + 1] : p[i];
        next[i] = nck_bubble_sweep(p[i], left, right);
        changed |= next[i] != g[i];
    }
    return changed;
}

nck_status_t nck_host_bubble_sweeps(const int32_t *p, size_t n, int32_t *g_out, int32_t *other,
                                    size_t *sweeps_out, size_t *bad_out) {
    const nck_status_t status = check_grades(p, n, bad_out);
    *sweeps_out = 0;
    if (status != NCK_OK) return status;
    for (size_t i = 0; i < n; i++) g_out[i] = p[i];
    for (;;) {
        const int changed = sweep(p, n, g_out, other);
        for (size_t i = 0; i < n; i++) g_out[i] = other[i];
        ++*sweeps_out;
        if (!changed) return NCK_OK;
    }
}

static void scan(const int32_t *p, size_t n, int32_t *g) {
    for (size_t i = 0; i < n; i++) g[i] = i > 0 ? nck_bubble_scan(p[i], g[i - 1]) : p[i];
    for (size_t i = n; i-- > 1;) g[i - 1] = nck_bubble_scan(g[i - 1], g[i]);
}

nck_status_t nck_host_bubble_scan(const int32_t *p, size_t n, int32_t *g_out, size_t *bad_out) {
    const nck_status_t status = check_grades(p, n, bad_out);
    if (status == NCK_OK) scan(p, n, g_out);
    return status;
}

// The three conditions of Cao et al. 2014, section 7, for every pair (i, i + 1), as printed. The
// third one is not strict: a pair that is in order writes its point all the same, and may so undo
// what the pair on the other side had to take from it.
int nck_host_bubble_printed(const int32_t *g, size_t n, const uint32_t *order, int32_t *next_out) {
    int changed = 0;
    for (size_t i = 0; i < n; i++) next_out[i] = g[i];
    for (size_t k = 0; k + 1 < n; k++) {
        const size_t i = order[k];
        if (g[i] > g[i + 1] + 1) {
            next_out[i] = g[i + 1] + 1;
        } else if (g[i] < g[i + 1]) {
            next_out[i + 1] = g[i] + 1;
        }
    }
    for (size_t i = 0; i < n; i++) changed |= next_out[i] != g[i];
    return changed;
}

// (15): a = (v_e² − v_s²)/(2L)     (Cao et al. 2014)
static void accelerations(const nck_unit_t *units, size_t count, const nck_grade_rule_t *rule,
                          const int32_t *grade, double *a_out) {
    for (size_t i = 0; i < count; i++) {
        a_out[i] = nck_ramp_accel(units[i].length, nck_grade_vv(rule, grade[i]),
                                  nck_grade_vv(rule, grade[i + 1]));
    }
}

nck_status_t nck_host_grade_plan(nck_host_grades_t *self) {
    for (size_t k = 0; k < self->stretch_count; k++) {
        const nck_host_stretch_t *const stretch = &self->stretches[k];
        const nck_grade_rule_t *const rule = &stretch->rule;
        const size_t begin = stretch->unit_begin;
        const size_t point = begin + k;
        const size_t count = stretch->unit_end - begin;
        const nck_unit_t *const units = self->units + begin;
        nck_host_unit_speeds(self, k);
        nck_host_transfers(self, k);
        scan(self->preplanned + point, count + 1, self->grade + point);
        accelerations(units, count, rule, self->grade + point, self->a + begin);
    }
    return NCK_OK;
}

// Criteria 1 and 2 of Cao et al. 2014, section 7, and (13) from both sides of a unit.
static int unit_holds(const nck_grade_rule_t *rule, const nck_unit_t *unit, double v,
                      const int32_t *grade, const int32_t *preplanned) {
    const double more = 1.0 + SPEED_EPSILON;
    const double vv_begin = nck_grade_vv(rule, grade[0]);
    const double vv_end = nck_grade_vv(rule, grade[1]);
    int good = grade[0] - grade[1] <= 1 && grade[1] - grade[0] <= 1;
    good &= grade[0] >= 0 && grade[0] <= preplanned[0] && grade[1] <= preplanned[1];
    good &= vv_end <= nck_transfer_reach(vv_begin, rule->a, unit->length) * more;
    good &= vv_begin <= nck_transfer_reach(vv_end, rule->a, unit->length) * more;
    good &= v <= unit->v_command && vv_begin <= v * v * more && vv_end <= v * v * more;
    return good;
}

int nck_host_grade_invariants(const nck_host_grades_t *self) {
    int good = 1;
    for (size_t k = 0; k < self->stretch_count; k++) {
        const nck_host_stretch_t *const stretch = &self->stretches[k];
        double length = 0.0;
        double path = 0.0;
        for (size_t i = stretch->unit_begin; i < stretch->unit_end; i++) {
            good &= unit_holds(&stretch->rule, &self->units[i], self->v[i], self->grade + i + k,
                               self->preplanned + i + k);
            length += self->units[i].length;
        }
        for (size_t i = stretch->seg_begin; i < stretch->seg_end; i++) path += self->segs[i].length;
        good &= nck_fabs(length - path) <= path * SPEED_EPSILON;
        good &= self->grade[stretch->unit_begin + k] == 0;
        good &= self->grade[stretch->unit_end + k] == 0;
    }
    return good;
}
