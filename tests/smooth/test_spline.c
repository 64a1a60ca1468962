// SPDX-License-Identifier: MIT
// Room 3: how far a spline leaves a corner.
#include <math.h> // cos sin fabs hypot

#include "check.h"
#include "nck/prep/3_smooth/spline_math.h" // nck_spline_…

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

int main(void)
{
    check_t check = {0};
    CHECK_RUN(&check, even_knots_of_the_vertex_spacing_leave_a_corner_by_the_tolerance);
    return check_end(&check);
}
