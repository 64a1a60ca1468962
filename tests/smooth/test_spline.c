// SPDX-License-Identifier: MIT
// Room 3: how far a spline leaves a corner, and that it makes use of all that it may.
#include <math.h> // cos sin fabs hypot

#include "check.h"
#include "nck/prep/3_smooth/smooth.h"      // nck_machine_t
#include "nck/prep/3_smooth/spline_math.h" // nck_spline_…
#include "smooth_check.h"                  // line_to hold_promises

// |Δu| of a turn [rad].
static double size_of(double turn) { return 2.0 * sin(0.5 * fabs(turn)); }

// Control points lie on the corner's two ways, Δ before it, on it, and Δ behind it.
static void even_knots_of_the_vertex_spacing_leave_a_corner_by_the_tolerance(check_t *check)
{
    static const double tolerances[] = {0.001, 0.01, 0.1};
    static const double turns[] = {-2.6, -0.3, 1e-3, 1.5707963};
    double weight[4];
    nck_spline_basis(0.0, weight);
    for (int k = 0; k < 12; k++) {
        const double p = tolerances[k % 3];
        const double turn = turns[k / 3];
        const double spacing = nck_spline_vertex_spacing(p, size_of(turn));
        const double x = spacing * (cos(turn) * weight[2] - weight[0]);
        CHECK(check, spacing > 0.0);
        CHECK_NEAR(check, hypot(x, spacing * sin(turn) * weight[2]), p, 1e-9 * p); // rounding
    }
}

// Under the S-shape no corner is lifted: the knots beside it have 0.96 of the tolerance, of which
// 2 nm are kept for rounding. Beside these corners a rest would take longer.
static void a_lone_corner_gets_the_spacing_of_its_tolerance(check_t *check)
{
    static const double turns[] = {0.3, -0.4, 0.5};
    for (int k = 0; k < 3; k++) {
        const double spacing = 0.96 * 6.0 * (0.1 - 2e-6) / size_of(turns[k]);
        int beside = 0;
        begin();
        machine.slope = NCK_SLOPE_SSHAPE;
        line_to(80.0, 0.0, 0.0, 0.1);
        line_to(80.0 + 80.0 * cos(turns[k]), 80.0 * sin(turns[k]), 0.0, 0.1);
        hold_promises(check, "a lone corner");
        for (int n = 0; n < path.segs; n++) {
            const nck_seg_t *const seg = &path.seg[n];
            const double middle = seg->s_begin + 0.5 * seg->length - 80.0;
            if (seg->kind != NCK_SEG_SPLINE || fabs(middle) > 0.75 * spacing) continue;
            CHECK_NEAR(check, seg->length, spacing, 1e-7); // the ends' whole nanometres turn it
            beside++;
        }
        CHECK_INT(check, beside, 2);
    }
}

int main(void)
{
    check_t check = {0};
    CHECK_RUN(&check, even_knots_of_the_vertex_spacing_leave_a_corner_by_the_tolerance);
    CHECK_RUN(&check, a_lone_corner_gets_the_spacing_of_its_tolerance);
    return check_end(&check);
}
