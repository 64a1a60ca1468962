// SPDX-License-Identifier: MIT
// base/trig_math.h and base/root_math.h against libm, which they must equal to rounding.
#include <math.h> // sin cos atan2 cbrtl: the oracle

#include "check.h"
#include "nck/base/root_math.h" // nck_root_cube
#include "nck/base/trig_math.h" // NCK_PI NCK_HALF_PI

static void sine_and_cosine_are_within_two_ulp_of_one(check_t *check)
{
    double worst = 0.0;
    for (int k = -400000; k <= 400000; k++) {
        const double x = k < 0 ? k * 1e-5 : k * 2.5;
        double s = 0.0;
        double c = 0.0;
        nck_sincos(x, &s, &c);
        worst = fmax(worst, fmax(fabs(s - sin(x)), fabs(c - cos(x))));
    }
    CHECK_NEAR(check, worst, 0.0, 4.5e-16);
}

static void quarter_turns_are_exact_to_their_own_rounding(check_t *check)
{
    double s = 1.0;
    double c = 0.0;
    nck_sincos(0.0, &s, &c);
    CHECK(check, s == 0.0 && c == 1.0);
    for (int n = -1000; n <= 1000; n++) {
        nck_sincos(n * NCK_HALF_PI, &s, &c);
        CHECK_NEAR(check, s, sin(n * NCK_HALF_PI), 2.3e-16);
    }
}

static void angle_of_a_vector_is_within_four_ulp(check_t *check)
{
    double worst = 0.0;
    for (int k = 1; k < 200000; k++) {
        const double size = pow(10.0, (k % 17) - 8);
        const double x = size * cos(k * 0.37);
        const double y = sin(k * 0.37) * pow(10.0, (k / 17 % 13) - 6);
        const double want = atan2(y, x);
        worst = fmax(worst, fabs(nck_atan2(y, x) - want) / fabs(want));
    }
    CHECK_NEAR(check, worst, 0.0, 4.0 * 2.22e-16);
}

static void angle_on_the_axes_is_right(check_t *check)
{
    CHECK(check, nck_atan2(0.0, 0.0) == 0.0);
    CHECK(check, nck_atan2(0.0, 3.0) == 0.0);
    CHECK(check, nck_atan2(0.0, -3.0) == NCK_PI);
    CHECK(check, nck_atan2(2.0, 0.0) == NCK_HALF_PI);
    CHECK(check, nck_atan2(-2.0, 0.0) == -NCK_HALF_PI);
}

// The oracle is of more digits: cbrt itself may be off by more than what is promised here.
static void cube_root_is_within_two_ulp_over_sixty_decades(check_t *check)
{
    double worst = 0.0;
    for (int k = 0; k <= 60000; k++) {
        const double x = pow(10.0, k * 1e-3 - 30.0);
        const long double want = cbrtl((long double)x);
        const double ulp = nextafter((double)want, HUGE_VAL) - (double)want;
        worst = fmax(worst, (double)fabsl((long double)nck_root_cube(x) - want) / ulp);
    }
    CHECK(check, worst <= 2.0);
    CHECK(check, nck_root_cube(1.0) == 1.0);
}

int main(void)
{
    check_t check = {0};
    CHECK_RUN(&check, sine_and_cosine_are_within_two_ulp_of_one);
    CHECK_RUN(&check, quarter_turns_are_exact_to_their_own_rounding);
    CHECK_RUN(&check, angle_of_a_vector_is_within_four_ulp);
    CHECK_RUN(&check, angle_on_the_axes_is_right);
    CHECK_RUN(&check, cube_root_is_within_two_ulp_over_sixty_decades);
    return check_end(&check);
}
