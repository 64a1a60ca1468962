// SPDX-License-Identifier: MIT
// Planning by grades: angles, units, steps, grades and the bubble against oracles that share no
// code.
#include <math.h>   // sqrt fabs atan2 acos ceil nextafter HUGE_VAL NAN
#include <string.h> // memset

#include "check.h"
#include "host/grade.h"
#include "nck/base/envelope_math.h" // nck_envelope_h
#include "nck/base/path.h"      // nck_path_tangent
#include "host/angle_math.h"    // nck_angle_…
#include "host/grade_math.h"    // nck_grade_…
#include "host/transfer_math.h" // nck_transfer_tangent
#include "host/unit_math.h"     // nck_unit_…

enum { SEGS = 400, UNITS = 120000, POINTS = UNITS + SEGS };

static nck_machine_t machine;
static nck_seg_t segs[SEGS];
static double v_command[SEGS];
static uint8_t limits[SEGS];
static nck_host_stretch_t stretches[SEGS];
static nck_unit_t units[UNITS];
static double v[UNITS], a[UNITS], v_transfer[POINTS], angle[POINTS];
static uint32_t n_step[UNITS];
static uint8_t unit_limit[UNITS];
static int32_t preplanned[POINTS], grade[POINTS], other[POINTS];
static uint64_t seed;

// Xorshift, G. Marsaglia 2003: the same numbers everywhere. 0 … 1.
static double random_real(void)
{
    seed ^= seed << 13;
    seed ^= seed >> 7;
    seed ^= seed << 17;
    return (double)(seed >> 11) / 9007199254740992.0;
}

static uint32_t random_below(uint32_t n) { return (uint32_t)(random_real() * n); }

static nck_host_grades_t begin(size_t count, uint32_t steps)
{
    nck_host_grades_t plan;
    memset(&plan, 0, sizeof plan);
    plan.machine = &machine;
    plan.steps = steps;
    plan.segs = segs;
    plan.seg_count = count;
    plan.v_command = v_command;
    plan.limit = limits;
    plan.stretches = stretches;
    plan.stretch_max = SEGS;
    plan.units = units;
    plan.unit_max = UNITS;
    plan.v = v;
    plan.n_step = n_step;
    plan.unit_limit = unit_limit;
    plan.a = a;
    plan.v_transfer = v_transfer;
    plan.angle = angle;
    plan.preplanned = preplanned;
    plan.grade = grade;
    return plan;
}

static nck_status_t plan_all(nck_host_grades_t *plan)
{
    nck_status_t status = nck_host_grade_command(plan);
    if (status == NCK_OK) status = nck_host_grade_stretches(plan);
    if (status == NCK_OK) status = nck_host_grade_divide(plan);
    return status == NCK_OK ? nck_host_grade_plan(plan) : status;
}

static nck_seg_t *next_seg(size_t i, double feed)
{
    nck_seg_t *const seg = &segs[i];
    memset(seg, 0, sizeof *seg);
    seg->seq = (uint32_t)i;
    seg->feed = feed;
    seg->feed_scale = 1.0;
    if (i > 0) memcpy(seg->start, segs[i - 1].end, sizeof seg->start);
    memcpy(seg->end, seg->start, sizeof seg->end);
    if (i > 0) seg->s_begin = segs[i - 1].s_begin + segs[i - 1].length;
    return seg;
}

static void add_line(size_t i, double feed, double dx, double dy, double dz)
{
    nck_seg_t *const seg = next_seg(i, feed);
    seg->end[0] += dx;
    seg->end[1] += dy;
    seg->end[2] += dz;
    seg->length = sqrt(dx * dx + dy * dy + dz * dz);
}

// An arc of radius r in the plane (u, w) that begins at the angle phi of its circle; helix: rise.
static void add_arc(size_t i, double feed, int u, int w, const double shape[4])
{
    nck_seg_t *const seg = next_seg(i, feed);
    const double r = shape[0], phi = shape[1], sweep = shape[2], rise = shape[3];
    seg->kind = NCK_SEG_ARC;
    seg->shape.arc.axis_u = (uint8_t)u;
    seg->shape.arc.axis_v = (uint8_t)w;
    seg->shape.arc.sweep = sweep;
    seg->shape.arc.centre_u = seg->start[u] - r * cos(phi);
    seg->shape.arc.centre_v = seg->start[w] - r * sin(phi);
    seg->end[u] = seg->shape.arc.centre_u + r * cos(phi + sweep);
    seg->end[w] = seg->shape.arc.centre_v + r * sin(phi + sweep);
    seg->end[3 - u - w] += rise;
    seg->length = sqrt(r * r * sweep * sweep + rise * rise);
}

static void add_random(size_t i, double feed, double size)
{
    const double x = random_real() - 0.5, y = random_real() - 0.5, z = random_real() - 0.5;
    const double sweep = (random_real() < 0.5 ? -1.0 : 1.0) * (0.1 + 3.0 * random_real());
    const double shape[4] = {size * (0.1 + random_real()), 6.28 * random_real(), sweep,
                             random_real() < 0.3 ? size * z : 0.0};
    const int plane = (int)random_below(3);
    if (random_real() < 0.5) {
        add_line(i, feed, size * x, size * y, size * z);
    } else {
        add_arc(i, feed, plane, (plane + 1) % 3, shape);
    }
}

static void angle_of_every_joint_is_that_of_its_tangents(check_t *check)
{
    seed = 7;
    for (size_t i = 0; i < SEGS; i++) add_random(i, 20.0, 3.0);
    for (size_t i = 0; i + 1 < SEGS; i++) {
        double in[NCK_AXIS_MAX], out[NCK_AXIS_MAX], ours[NCK_AXIS_MAX], dot = 0.0;
        nck_path_tangent(&segs[i], segs[i].length, in);
        nck_path_tangent(&segs[i + 1], 0.0, out);
        nck_transfer_tangent(&segs[i], 1, ours);
        for (int x = 0; x < NCK_AXIS_MAX; x++) {
            dot += in[x] * out[x];
            CHECK_NEAR(check, ours[x], in[x], 1e-12);
        }
        const double got = nck_host_link_angle(&segs[i], &segs[i + 1]);
        CHECK_NEAR(check, got, nck_angle_tangents(in, out), 1e-7);
        CHECK_NEAR(check, cos(got), dot, 1e-9);
    }
}

static void angle_of_plane_joints_keeps_its_digits(check_t *check)
{
    const double quarter[4] = {5.0, -1.5707963267948966, 1.5707963267948966, 0.0};
    const double small = 1e-9;
    memset(&segs[0], 0, sizeof segs[0]);
    add_line(0, 10.0, 4.0, 0.0, 0.0);
    add_arc(1, 10.0, 0, 1, quarter); // begins along +x
    add_line(2, 10.0, 0.0, 2.0, 0.0);
    add_line(3, 10.0, 2.0 * small, 2.0, 0.0);
    add_line(4, 10.0, 0.0, -3.0, 0.0);
    CHECK_NEAR(check, nck_host_link_angle(&segs[0], &segs[1]), 0.0, 1e-15);
    CHECK_NEAR(check, nck_host_link_angle(&segs[1], &segs[2]), 0.0, 1e-15);
    CHECK_NEAR(check, nck_host_link_angle(&segs[2], &segs[3]), small, 1e-15); // acos gives 0
    CHECK_NEAR(check, nck_host_link_angle(&segs[2], &segs[4]), 3.14159265358979323846, 0.0);
    CHECK_NEAR(check, nck_host_link_angle(&segs[4], &segs[1]), 1.57079632679489661923, 1e-15);
}

static void every_grade_of_the_table_is_its_own(check_t *check)
{
    seed = 11;
    for (int run = 0; run < 300; run++) {
        nck_grade_rule_t rule;
        const double v_c = 1.0 + 500.0 * random_real();
        const double v_min = random_real() < 0.5 ? 0.0 : 0.5 * v_c * random_real();
        const double accel = 20.0 + 5000.0 * random_real();
        const uint32_t n = 1 + random_below(5);
        CHECK_INT(check, nck_host_grade_rule(&machine, v_c, v_min, accel, n, &rule), NCK_OK);
        const double step = 2.0 * accel * rule.steps * v_c * machine.period_s;
        CHECK_NEAR(check, ceil((v_c * v_c - v_min * v_min) / step) + 1.0, rule.count, 1.0);
        double next = v_min;
        for (int k = 0; k + 1 < (int)rule.count; k++) {
            const double vv = nck_grade_vv(&rule, k);
            CHECK_NEAR(check, sqrt(vv), next, 1e-9 * v_c);
            CHECK_INT(check, nck_grade_of(&rule, vv), k);
            if (k > 0) CHECK_INT(check, nck_grade_of(&rule, nextafter(vv, 0.0)), k - 1);
            next = sqrt(next * next + nck_envelope_h(rule.a, rule.length));
        }
        CHECK_INT(check, nck_grade_of(&rule, v_c * v_c), rule.count - 1);
        CHECK_INT(check, nck_grade_of(&rule, 0.0), 0);
        const double vv = v_c * v_c * random_real();
        const int g = nck_grade_of(&rule, vv);
        CHECK(check, g == 0 || nck_grade_vv(&rule, g) <= vv);
        CHECK(check, g + 1 == (int)rule.count || nck_grade_vv(&rule, g + 1) > vv);
    }
}

static void units_are_as_long_as_they_must_be(check_t *check)
{
    seed = 5;
    for (int run = 0; run < 40; run++) {
        const double size = run % 2 ? 0.05 : 4.0;
        for (size_t i = 0; i < SEGS; i++) {
            add_random(i, 30.0, random_real() < 0.2 ? 4.0 : size);
            segs[i].stop = random_real() < 0.02;
        }
        nck_host_grades_t plan = begin(SEGS, 1 + random_below(4));
        CHECK_INT(check, plan_all(&plan), NCK_OK);
        CHECK(check, nck_host_grade_invariants(&plan));
        for (size_t k = 0; k < plan.stretch_count; k++) {
            const nck_host_stretch_t *const stretch = &stretches[k];
            const double least = stretch->rule.length * (1.0 - 1e-8);
            const int alone = stretch->unit_end == stretch->unit_begin + 1;
            for (size_t i = stretch->unit_begin; i < stretch->unit_end; i++) {
                CHECK(check, units[i].length >= least || alone);
                CHECK(check, units[i].length < 3.0 * stretch->rule.length);
                if (i == stretch->unit_begin) continue;
                const nck_unit_t *const before = &units[i - 1];
                const int same = units[i].seg == before->seg_end && units[i].s == before->s_end;
                const int next = units[i].seg == before->seg_end + 1 && units[i].s == 0.0
                                 && before->s_end == segs[before->seg_end].length;
                CHECK(check, same || next);
            }
        }
    }
}

// Cao et al. 2014, section 5, word for word: one more step until all three hold.
static int count_one_by_one(const nck_unit_t *unit, const nck_grade_rule_t *rule)
{
    int n = nck_unit_steps_least(unit, rule);
    double ratio[2] = {0.0, 0.0};
    for (;;) {
        nck_unit_ratios(segs, unit, rule, n, ratio);
        if (ratio[0] <= 1.0 + 1e-9 && ratio[1] <= 1.0 + 1e-9) return n;
        n++;
    }
}

static void steps_on_arcs_are_those_of_the_closed_forms(check_t *check)
{
    seed = 3;
    for (int run = 0; run < 200; run++) {
        const double r = 0.2 + 20.0 * random_real();
        const double turn[4] = {r, 6.28 * random_real(), 6.2831853, 0.0};
        nck_unit_t unit;
        nck_grade_rule_t rule;
        int limit = 0;
        memset(&unit, 0, sizeof unit);
        memset(&segs[0], 0, sizeof segs[0]);
        add_arc(0, 400.0, 0, 1, turn);
        (void)nck_host_grade_rule(&machine, 400.0, 0.0, 1000.0, 4, &rule);
        unit.length = segs[0].length;
        unit.s_end = segs[0].length;
        unit.v_command = 400.0;
        if (run % 2) {
            memset(rule.a_axis, 0, sizeof rule.a_axis);
        } else {
            rule.chord_error = 1e3;
        }
        const int n = nck_unit_step_count(segs, &unit, &rule, &limit);
        const double speed = nck_unit_speed(&unit, rule.period_s, n);
        const double delta = rule.chord_error;
        const double chord = 2.0 / rule.period_s * sqrt(2.0 * r * delta - delta * delta);
        const double want = run % 2 ? chord : sqrt(rule.a_axis[0] * r);
        CHECK_INT(check, n, count_one_by_one(&unit, &rule));
        if (want > 400.0) continue;
        CHECK_INT(check, limit, run % 2 ? NCK_LIMIT_CHORD : NCK_LIMIT_CURVATURE);
        CHECK_NEAR(check, speed, want, 0.02 * want);
    }
}

// What is just allowed is allowed: a limit that ten steps meet to the bit takes ten.
static void a_limit_met_to_the_bit_takes_no_step_more(check_t *check)
{
    const double half[4] = {5.0, 0.3, 3.0, 0.0};
    nck_unit_t unit;
    nck_grade_rule_t rule;
    double ratio[2];
    int limit = 0;
    memset(&unit, 0, sizeof unit);
    memset(&segs[0], 0, sizeof segs[0]);
    add_arc(0, 400.0, 0, 1, half);
    (void)nck_host_grade_rule(&machine, 400.0, 0.0, 1000.0, 4, &rule);
    memset(rule.a_axis, 0, sizeof rule.a_axis);
    unit.length = unit.s_end = segs[0].length;
    unit.v_command = unit.length / (4.0 * rule.period_s);
    rule.chord_error = 1.0;
    nck_unit_ratios(segs, &unit, &rule, 10, ratio);
    rule.chord_error = ratio[0];
    CHECK_INT(check, nck_unit_step_count(segs, &unit, &rule, &limit), 10);
    CHECK_INT(check, limit, NCK_LIMIT_CHORD);
    rule.chord_error = ratio[0] * (1.0 - 1e-6);
    CHECK_INT(check, nck_unit_step_count(segs, &unit, &rule, &limit), 11);
}

static void steps_hold_both_limits_on_merged_lines(check_t *check)
{
    seed = 17;
    for (size_t i = 0; i < SEGS; i++) {
        const double phi = 0.3 * random_real();
        add_line(i, 40.0, 0.02 * cos(phi), 0.02 * sin(phi), 0.0);
    }
    nck_host_grades_t plan = begin(SEGS, 4);
    CHECK_INT(check, plan_all(&plan), NCK_OK);
    const nck_grade_rule_t *const rule = &stretches[0].rule;
    int slower = 0;
    for (size_t i = 0; i < plan.unit_count; i++) {
        double ratio[2];
        nck_unit_ratios(segs, &units[i], rule, (int)n_step[i], ratio);
        const int at_most = (int)n_step[i] >= nck_unit_steps_most(&units[i], rule);
        CHECK(check, at_most || (ratio[0] <= 1.0 + 1e-8 && ratio[1] <= 1.0 + 1e-8));
        slower += unit_limit[i] == NCK_LIMIT_CURVATURE;
        CHECK(check, v[i] <= units[i].length / (n_step[i] * rule->period_s) * (1.0 + 1e-12));
    }
    CHECK(check, slower > 0);
}

static void transfer_speed_is_that_of_the_worst_axis(check_t *check)
{
    add_line(0, 400.0, 100.0, 0.0, 0.0);
    add_line(1, 400.0, 0.0, 100.0, 0.0);
    add_line(2, 400.0, 0.0, -100.0, 0.0);
    add_line(3, 400.0, 0.0, -100.0, 0.0);
    machine.axis[0].a_max = 40000.0;
    machine.axis[1].a_max = 30000.0;
    nck_host_grades_t plan = begin(4, 4);
    CHECK_INT(check, plan_all(&plan), NCK_OK);
    double cap[3] = {0.0, 0.0, 0.0};
    for (size_t i = 0; i + 1 < plan.unit_count; i++) {
        if (units[i].seg_end != units[i + 1].seg) cap[units[i].seg_end] = v_transfer[i + 1];
    }
    CHECK_NEAR(check, cap[0], 30000.0 * 0.001, 1e-9);
    CHECK_NEAR(check, cap[1], 30000.0 * 0.001 / 2.0, 1e-9);
    CHECK(check, cap[2] > 90.0); // straight on: the units' own speed
    nck_machine_default(&machine);
}

static void bubble_gives_the_worked_example(check_t *check)
{
    const int32_t p[6] = {1, 5, 2, 5, 3, 1};
    const int32_t want[6] = {1, 2, 2, 3, 2, 1};
    const int32_t after_one[6] = {1, 3, 2, 4, 2, 1}; // figure 11
    const uint32_t forth[5] = {0, 1, 2, 3, 4};
    int32_t g[6], next[6];
    size_t sweeps = 0, bad = 0;
    CHECK_INT(check, nck_host_bubble_sweeps(p, 6, g, other, &sweeps, &bad), NCK_OK);
    CHECK_INT(check, memcmp(g, want, sizeof want), 0);
    CHECK_INT(check, sweeps, 2);
    CHECK_INT(check, nck_host_bubble_scan(p, 6, g, &bad), NCK_OK);
    CHECK_INT(check, memcmp(g, want, sizeof want), 0);
    CHECK(check, nck_host_bubble_printed(p, 6, forth, g));
    CHECK_INT(check, memcmp(g, after_one, sizeof want), 0);
    CHECK(check, nck_host_bubble_printed(g, 6, forth, next));
    CHECK_INT(check, memcmp(next, want, sizeof want), 0);
    CHECK(check, !nck_host_bubble_printed(next, 6, forth, g));
}

static void sweeps_and_scan_are_the_least_over_all_points(check_t *check)
{
    seed = 23;
    for (int run = 0; run < 300; run++) {
        const size_t n = random_below(60);
        const uint32_t top = 1 + random_below(40);
        int32_t scanned[64], swept[64];
        size_t sweeps = 0, bad = 0;
        for (size_t i = 0; i < n; i++) preplanned[i] = (int32_t)random_below(top);
        CHECK_INT(check, nck_host_bubble_scan(preplanned, n, scanned, &bad), NCK_OK);
        CHECK_INT(check, nck_host_bubble_sweeps(preplanned, n, swept, other, &sweeps, &bad),
                  NCK_OK);
        CHECK(check, sweeps <= top + 1);
        for (size_t i = 0; i < n; i++) {
            int32_t least = INT32_MAX;
            for (size_t j = 0; j < n; j++) {
                const int32_t far = (int32_t)(i > j ? i - j : j - i);
                if (preplanned[j] + far < least) least = preplanned[j] + far;
            }
            CHECK_INT(check, scanned[i], least);
            CHECK_INT(check, swept[i], least);
        }
    }
}

static void printed_bubble_stops_at_a_wrong_result(check_t *check)
{
    // Point 1 lies between 2 and 0, so it may be 1 at most. Where the left pair writes last it
    // writes 3, each time anew, and the step ends as it began.
    const int32_t p[3] = {2, 3, 0};
    const uint32_t back[2] = {1, 0};
    int32_t g[3], right[3];
    size_t bad = 0;
    CHECK(check, !nck_host_bubble_printed(p, 3, back, g));
    CHECK_INT(check, nck_host_bubble_scan(p, 3, right, &bad), NCK_OK);
    CHECK_INT(check, right[1], 1);
    CHECK_INT(check, g[1], 3);
    CHECK(check, g[1] - g[2] > 1); // criterion 1 is broken
}

static void cells_run_along_the_whole_path_without_a_jump(check_t *check)
{
    seed = 29;
    for (size_t i = 0; i < SEGS; i++) add_random(i, i % 50 < 25 ? 30.0 : 8.0, i % 3 ? 0.04 : 2.0);
    nck_host_grades_t plan = begin(SEGS, 2);
    CHECK_INT(check, plan_all(&plan), NCK_OK);
    nck_host_grade_cursor_t cursor;
    memset(&cursor, 0, sizeof cursor);
    cursor.grades = &plan;
    nck_cell_t cell;
    uint32_t seg = 0;
    double s = 0.0, speed = 0.0;
    while (nck_host_grade_next(&cursor, &cell)) {
        if (cell.seg != seg) {
            CHECK_NEAR(check, s, segs[seg].length, 1e-9);
            CHECK_INT(check, cell.seg, seg + 1);
            seg = cell.seg;
            s = 0.0;
        }
        CHECK_NEAR(check, cell.s, s, 1e-9);
        CHECK_NEAR(check, cell.v, speed, 1e-5);
        CHECK(check, fabs(cell.a) <= stretches[0].rule.a * (1.0 + 1e-6));
        s = cell.s + cell.length;
        speed = cell.v + cell.a * cell.duration;
        if (cell.stop) CHECK_NEAR(check, speed, 0.0, 1e-5);
    }
    CHECK_INT(check, seg, SEGS - 1);
    CHECK_INT(check, cell.last && cell.stop, 1);
    CHECK_NEAR(check, s, segs[SEGS - 1].length, 0.0);
}

static void bad_numbers_are_named_and_nothing_is_planned(check_t *check)
{
    const double bad[4] = {(double)NAN, HUGE_VAL, -1.0, 0.0};
    for (size_t i = 0; i < 10; i++) add_line(i, 20.0, 1.0, 0.0, 0.0);
    for (int k = 0; k < 4; k++) {
        nck_host_grades_t plan = begin(10, 4);
        segs[6].length = bad[k];
        CHECK_INT(check, plan_all(&plan), NCK_E_ARGUMENT);
        CHECK_INT(check, plan.bad, 6);
        CHECK_INT(check, plan.unit_count, 0);
        segs[6].length = 1.0;
        segs[3].feed = bad[k];
        CHECK_INT(check, plan_all(&plan), NCK_E_ARGUMENT);
        CHECK_INT(check, plan.bad, 3);
        segs[3].feed = 20.0;
        nck_grade_rule_t rule;
        CHECK(check, nck_host_grade_rule(&machine, bad[k], 0.0, 10.0, 4, &rule) != NCK_OK);
        CHECK(check, nck_host_grade_rule(&machine, 10.0, 0.0, bad[k], 4, &rule) != NCK_OK);
        CHECK(check, nck_host_grade_rule(&machine, 10.0, bad[k] + 20.0, 9.0, 4, &rule) != NCK_OK);
    }
    const int32_t p[4] = {2, 1, -1, INT32_MAX};
    int32_t g[4] = {7, 7, 7, 7};
    size_t at = 0;
    CHECK_INT(check, nck_host_bubble_scan(p, 4, g, &at), NCK_E_ARGUMENT);
    CHECK_INT(check, at, 2);
    CHECK_INT(check, g[0], 7);
}

static void too_little_memory_is_told_with_what_is_needed(check_t *check)
{
    for (size_t i = 0; i < 10; i++) add_line(i, 20.0, 10.0, 0.0, 0.0);
    nck_host_grades_t plan = begin(10, 4);
    CHECK_INT(check, plan_all(&plan), NCK_OK);
    const size_t needed = plan.unit_count;
    plan.unit_max = 5;
    CHECK_INT(check, nck_host_grade_divide(&plan), NCK_FULL);
    CHECK_INT(check, plan.unit_count, needed);
    plan.stretch_max = 0;
    CHECK_INT(check, nck_host_grade_stretches(&plan), NCK_FULL);
    CHECK_INT(check, plan.stretch_count, 1);
}

int main(void)
{
    check_t check = {0, 0, 0};
    nck_machine_default(&machine);
    CHECK_RUN(&check, angle_of_every_joint_is_that_of_its_tangents);
    CHECK_RUN(&check, angle_of_plane_joints_keeps_its_digits);
    CHECK_RUN(&check, every_grade_of_the_table_is_its_own);
    CHECK_RUN(&check, units_are_as_long_as_they_must_be);
    CHECK_RUN(&check, steps_on_arcs_are_those_of_the_closed_forms);
    CHECK_RUN(&check, a_limit_met_to_the_bit_takes_no_step_more);
    CHECK_RUN(&check, steps_hold_both_limits_on_merged_lines);
    CHECK_RUN(&check, transfer_speed_is_that_of_the_worst_axis);
    CHECK_RUN(&check, bubble_gives_the_worked_example);
    CHECK_RUN(&check, sweeps_and_scan_are_the_least_over_all_points);
    CHECK_RUN(&check, printed_bubble_stops_at_a_wrong_result);
    CHECK_RUN(&check, cells_run_along_the_whole_path_without_a_jump);
    CHECK_RUN(&check, bad_numbers_are_named_and_nothing_is_planned);
    CHECK_RUN(&check, too_little_memory_is_told_with_what_is_needed);
    return check_end(&check);
}
