// SPDX-License-Identifier: MIT
// Room 3: within a tolerance the path is smooth, and never outside of it.
#include <math.h> // cos sin floor fabs sqrt cbrt llround

#include "check.h"
#include "nck/base/path.h"            // nck_path_second nck_path_third
#include "nck/prep/3_smooth/smooth.h" // nck_machine_t
#include "smooth_check.h"             // line_to arc_about hold_promises

enum { RESTING_SEED = 5032 }; // of reversals: the first whose path has to rest on its way

static void corners_of_lines_and_arcs_stay_within_the_tolerance(check_t *check)
{
    static const double tolerance[] = {1e-4, 0.01, 0.3, 2.0};
    for (int k = 0; k < 4; k++) {
        const double p = tolerance[k];
        begin();
        line_to(10.0, 0.0, 0.0, p);
        line_to(10.0, 5.0, 0.0, p);
        line_to(0.0, 5.0, 0.1, p);
        line_to(5.0, 5.0, 0.1, p);               // a reversal
        arc_about(5.0, 7.0, 2.0, 0.0, p);        // tangent, then not
        line_to(20.0, 10.0, -3.0, p);
        arc_about(22.0, 10.0, -4.0, 2.0, p);
        arc_about(21.0, 12.0, 5.0, -1.0, p);
        arc_about(21.5, 12.5, 20.0, 3.0, p);     // a helix of three turns
        line_to(0.0, 0.0, 0.0, p);
        hold_promises(check, "lines and arcs");
    }
}

// Chords of a curve, rounded to digits: from 0.05 mm down.
static void add_micro_segments(double chord, double rounding, double tolerance)
{
    for (int k = 1; k < BLOCK_MAX - 1; k++) {
        const double t = chord * k / 50.0;
        const double r = 50.0 + 3.0 * sin(9.0 * t);
        line_to(rounding * floor(r * cos(t) / rounding + 0.5),
                rounding * floor(r * sin(t) / rounding + 0.5),
                rounding * floor(2.0 * sin(5.0 * t) / rounding + 0.5), tolerance);
    }
}

static void micro_segments_stay_within_the_tolerance(check_t *check)
{
    static const double chord[] = {0.002, 0.01, 0.055, 0.3};
    static const double tolerance[] = {0.001, 0.01, 0.1};
    for (int k = 0; k < 12; k++) {
        begin();
        machine.start_nm[0] = 50000000;
        add_micro_segments(chord[k / 3], k % 2 ? 1e-3 : 1e-4, tolerance[k % 3]);
        hold_promises(check, "micro-segments");
        for (int n = 0; n < blocks; n++) block[n].merge_mm = tolerance[k % 3];
        hold_promises(check, "merged micro-segments");
    }
}

// Everything at random: lengths over four decades, tolerances that change, all axes.
static void add_random_block(void)
{
    if (blocks > 0 && random_between(0.0, 1.0) < 0.15) {
        nck_block_t *const output = add(NCK_BLOCK_OUTPUT, 0.0);
        output->output.value = blocks;
        return;
    }
    static const double tolerances[] = {0.001, 0.01, 0.05, 0.5};
    const double p = tolerances[(int)random_between(0.0, 3.999)];
    const double reach = pow(10.0, random_between(-2.0, 1.5));
    const double x = blocks ? 1e-6 * (double)block[blocks - 1].target_nm[0] : 0.0;
    const double y = blocks ? 1e-6 * (double)block[blocks - 1].target_nm[1] : 0.0;
    if (blocks > 0 && random_between(0.0, 1.0) < 0.3) {
        const double angle = random_between(0.0, 6.28);
        arc_about(x + reach * cos(angle), y + reach * sin(angle), random_between(-7.0, 7.0),
                  random_between(-1.0, 1.0), p);
        return;
    }
    line_to(x + random_between(-reach, reach), y + random_between(-reach, reach), 0.0, p);
    nck_block_t *const last = &block[blocks - 1];
    last->merge_mm = random_between(0.0, p);
    last->kind = random_between(0.0, 1.0) < 0.1 ? NCK_BLOCK_RAPID : NCK_BLOCK_LINE;
    for (int axis = 2; axis < NCK_AXIS_MAX; axis++) {
        const double counts = nck_machine_counts(&machine, axis);
        last->target_nm[axis] = llround(counts * random_between(-reach, reach));
    }
}

static void random_paths_of_all_axes_stay_within_the_tolerance(check_t *check)
{
    for (uint32_t seed = 1; seed <= 40; seed++) {
        begin();
        random_state = seed;
        for (int k = 0; k < 250; k++) add_random_block();
        hold_promises(check, "random");
    }
}

static void a_corner_uses_most_of_its_tolerance(check_t *check)
{
    begin();
    machine.slope = NCK_SLOPE_LINEAR; // under a jerk limit it is faster to stop
    line_to(10.0, 0.0, 0.0, 0.1);
    line_to(10.0, 10.0, 0.0, 0.1);
    hold_promises(check, "a corner");
    CHECK(check, worst_share() > 0.9);
    const nck_seg_t *const last = &path.seg[path.segs - 1];
    CHECK(check, path.seg[0].kind == NCK_SEG_LINE && last->kind == NCK_SEG_LINE);
    CHECK(check, path.seg[0].length > 5.0 && last->length > 5.0);
}

// A kink where a line becomes an arc has its part of what the step of the curvature may use there,
// 0.9 of the tolerance (AIM_STEP of curve.c); the step has the rest.
static void a_kink_before_an_arc_shares_its_tolerance(check_t *check)
{
    const double radius = 5.0;
    const double p = 0.001;
    for (int side = -1; side <= 1; side += 2) {
        const double kink = 0.00136 * side; // [rad] half of what makes it a corner like any other
        begin();
        line_to(100.0, 0.0, 0.0, p);
        arc_about(100.0 - radius * sin(kink), radius * cos(kink), 2.5, 0.0, p);
        for (int n = 0; n < blocks; n++) block[n].feed = 12000.0;
        hold_promises(check, "a kink before an arc");
        const double share = worst_share();
        if (!CHECK(check, share > 0.8 && share <= 0.9)) printf("    %g rad: %g\n", kink, share);
    }
}

// |p″| and |p‴| of the smoothest path within a looser tolerance, as the time they cost.
static double time_of(void)
{
    double time = 0.0;
    for (int k = 0; k < path.segs; k++) {
        const nck_seg_t *const seg = &path.seg[k];
        double second[2][NCK_AXIS_MAX];
        double third[NCK_AXIS_MAX];
        nck_path_second(seg, 0.0, second[0]);
        nck_path_second(seg, seg->length, second[1]);
        nck_path_third(seg, 0.0, third);
        double v = 100.0;
        for (int x = 0; x < NCK_AXIS_MAX; x++) {
            const double bend = fmax(fabs(second[0][x]), fabs(second[1][x]));
            if (bend > 0.0) v = fmin(v, sqrt(1000.0 / bend));
            if (third[x] != 0.0) v = fmin(v, cbrt(10000.0 / fabs(third[x])));
        }
        time += seg->length / v;
    }
    return time;
}

static void a_looser_tolerance_is_not_slower(check_t *check)
{
    static const double tolerance[] = {0.003, 0.01, 0.03, 0.1, 0.3, 1.0};
    double least = 1e9;
    for (int k = 0; k < 6; k++) {
        begin();
        machine.start_nm[0] = 50000000;
        add_micro_segments(0.055, 1e-4, tolerance[k]);
        CHECK(check, run(&path, 0));
        const double time = time_of();
        if (!CHECK(check, time <= 1.02 * least)) {
            printf("    P%g takes %.4f s, not %.4f\n", tolerance[k], time, least);
        }
        least = fmin(least, time);
    }
}

// A spike, corners of all angles, an exact reversal: the tip is no further from the path than P.
static void programmed_corners_are_within_the_tolerance_of_the_path(check_t *check)
{
    static const double angle[] = {0.026, 0.5, 0.785, 1.571, 2.0, 2.6, 3.0, 3.1414, 3.1415926535};
    static const double tolerance[] = {0.001, 0.01, 0.1, 1.0};
    for (int k = 0; k < 36; k++) {
        const double turn = angle[k / 4];
        const double p = tolerance[k % 4];
        begin();
        line_to(80.0, 0.0, 0.0, p);
        line_to(80.0 + 80.0 * cos(turn), 80.0 * sin(turn), 0.0, p);
        for (int n = 0; n < blocks; n++) block[n].feed = 12000.0;
        hold_promises(check, "a corner of any angle");
        double least = 1e9;
        for (int n = 0; n < path.segs; n++) {
            for (double s = 0.0; s <= 1.0; s += 1e-4) {
                double at[NCK_AXIS_MAX];
                nck_path_point(&path.seg[n], s * path.seg[n].length, at);
                least = fmin(least, hypot(at[0] - 80.0, at[1]));
            }
        }
        if (!CHECK(check, least <= p)) printf("    %g rad, P%g: %g\n", turn, p, least);
    }
}

// Lengths over eight decades, arcs, reversals and tolerances at random.
static void add_wild_blocks(uint32_t seed)
{
    begin();
    random_state = seed * 7919u;
    const double least = seed % 4 < 2 ? -6.0 : -3.0;
    const double most = seed % 2 ? 1.5 : -2.0;
    for (int k = 0; k < 40; k++) {
        const double reach = pow(10.0, random_between(least, 2.0));
        const double x = k ? 1e-6 * (double)block[k - 1].target_nm[0] : 0.0;
        const double y = k ? 1e-6 * (double)block[k - 1].target_nm[1] : 0.0;
        const double p = pow(10.0, random_between(-3.9, most));
        if (k > 0 && random_between(0.0, 1.0) < 0.4) {
            const double angle = random_between(0.0, 6.28);
            const double rise = random_between(-1.0, 1.0);
            const double turn = random_between(-7.0, 7.0);
            arc_about(x + reach * cos(angle), y + reach * sin(angle), turn, rise, p);
        } else {
            const double aside = random_between(-reach, reach);
            const double to = random_between(0.0, 1.0) < 0.3 ? -x : x + reach;
            line_to(to, y + aside, 0.0, p);
        }
        block[k].merge_mm = random_between(-0.01, 0.01);
    }
}

// Lines of a micrometre to three millimetres, back and forth, each with another tolerance.
static void add_reversals(uint32_t seed)
{
    double x = 0.0;
    double y = 0.0;
    double angle = 0.0;
    begin();
    random_state = seed * 7919u + 3u;
    for (int k = 0; k < 60; k++) {
        const double length = pow(10.0, random_between(-3.0, 0.5));
        const double p = pow(10.0, random_between(-3.9, 0.5));
        const int turns_back = random_between(0.0, 1.0) < 0.5;
        angle += turns_back ? 3.14159 + random_between(-0.2, 0.2) : random_between(-1.6, 1.6);
        x += length * cos(angle);
        y += length * sin(angle);
        line_to(x, y, 0.0, p);
        block[k].merge_mm = 0.0;
    }
}

// A circle of 10 mm in chords as coarse as three quarters of the tolerance: the path is rounder
// than they are, passes them on both sides, and the tool keeps to the feed where that is longer.
static void chords_are_seen_as_the_curve_that_they_came_from(check_t *check)
{
    const double radius = 10.0;
    const double turn = 2.0 * acos(1.0 - 0.0075 / radius);
    double least = radius;
    double most = 0.0;
    double fastest = 0.0;
    begin();
    for (int k = 0; k < 200; k++) {
        line_to(radius * sin(turn * k), radius * (1.0 - cos(turn * k)), 0.0, 0.01);
    }
    hold_promises(check, "chords of a circle");
    for (int k = path.segs / 4; k < path.segs * 3 / 4; k++) {
        const nck_seg_t *const seg = &path.seg[k];
        for (int n = 0; n <= 16; n++) {
            double p[NCK_AXIS_MAX];
            double tangent[NCK_AXIS_MAX];
            nck_path_point(seg, seg->length * n / 16.0, p);
            nck_path_tangent(seg, seg->length * n / 16.0, tangent);
            least = fmin(least, hypot(p[0], p[1] - radius));
            most = fmax(most, hypot(p[0], p[1] - radius));
            fastest = fmax(fastest, hypot(tangent[0], tangent[1]) * seg->feed);
        }
    }
    CHECK(check, path.segs < blocks / 2 || NCK_SMOOTH_SPAN < 128);
    CHECK(check, most - least < 0.3 * 0.0075);
    CHECK(check, least > radius - 0.0075 && most < radius);
    CHECK(check, fastest <= 100.0 * (1.0 + 1e-12) && fastest > 99.0);
}

// Nothing that is wanted fits: the path rests, and goes on.
static void a_spline_that_cannot_go_on_rests(check_t *check)
{
    begin();
    line_to(39.518791, -1.077110, -0.765224, 0.0);
    line_to(39.518979, -1.078910, -0.766503, 0.006760);
    line_to(39.518621, -1.075471, -0.764060, 0.006760);
    line_to(48.184718, -84.190473, -59.811348, 0.006760);
    for (int k = 1; k < blocks; k++) block[k].merge_mm = 0.059633;
    hold_promises(check, "reversals shorter than the tolerance");
    for (uint32_t seed = 1; seed <= 300; seed++) {
        add_wild_blocks(seed);
        hold_promises(check, "wild blocks");
    }
    add_reversals(RESTING_SEED);
    hold_promises(check, "a path that has to rest");
    CHECK(check, smooth.run.kinks == 1 || NCK_SMOOTH_SPAN < 128);
}

int main(void)
{
    check_t check = {0};
    CHECK_RUN(&check, corners_of_lines_and_arcs_stay_within_the_tolerance);
    CHECK_RUN(&check, micro_segments_stay_within_the_tolerance);
    CHECK_RUN(&check, random_paths_of_all_axes_stay_within_the_tolerance);
    CHECK_RUN(&check, a_corner_uses_most_of_its_tolerance);
    CHECK_RUN(&check, a_kink_before_an_arc_shares_its_tolerance);
    CHECK_RUN(&check, a_looser_tolerance_is_not_slower);
    CHECK_RUN(&check, programmed_corners_are_within_the_tolerance_of_the_path);
    CHECK_RUN(&check, chords_are_seen_as_the_curve_that_they_came_from);
    CHECK_RUN(&check, a_spline_that_cannot_go_on_rests);
    return check_end(&check);
}
