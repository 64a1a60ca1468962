// SPDX-License-Identifier: MIT
// S-shaped ramps: what they reach is what their length says, and no time is better than the least.
#include <math.h> // pow fmin fabs

#include "check.h"
#include "nck/base/scurve_math.h" // nck_scurve_…

static uint32_t state = 1;

static double decades(double low, double high) {
    state = state * 1664525u + 1013904223u;
    return pow(10.0, low + (high - low) * (state >> 8) / 16777216.0);
}

static void a_ramp_reaches_what_its_length_says(check_t *check) {
    for (int n = 0; n < 20000; n++) {
        const nck_scurve_t ramp = {decades(-1.0, 5.0), decades(0.0, 7.0), decades(-1.0, 4.0)};
        const double v = n % 3 == 0 ? 0.0 : fmin(ramp.v_max, decades(-5.0, 4.0));
        const double length = decades(-7.0, 3.0);
        const double v_end = nck_scurve_reach(&ramp, v, length);
        const double taken = nck_scurve_length(&ramp, v, v_end);
        CHECK(check, v_end >= v && v_end <= ramp.v_max);
        if (v_end - v < 1e-6 * v) continue; // too few digits to look at
        CHECK(check, taken <= length * (1.0 + 1e-6) + 1e-9 * v_end);
        if (v_end < ramp.v_max) CHECK(check, taken >= 0.999 * length);
        const double time = nck_scurve_over(&ramp, v, length);
        CHECK(check, time >= length / v_end * (1.0 - 1e-6));
        if (v > 0.0) CHECK(check, time <= length / v * (1.0 + 1e-5) + 1e-9);
        CHECK(check, nck_scurve_reach(&ramp, v, 0.0) == v);
    }
}

int main(void) {
    check_t check = {0};
    CHECK_RUN(&check, a_ramp_reaches_what_its_length_says);
    return check_end(&check);
}
