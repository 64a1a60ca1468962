// SPDX-License-Identifier: MIT
// Room 1: arcs pass through both of their ends, whatever the words' rounding, and keep within the
// travel.
#include <math.h>  // cos sin hypot
#include <stdio.h> // snprintf

#include "check.h"
#include "decode_check.h"
#include "nck/base/arc_math.h" // nck_arc_bulges

static decode_case_t self;
static const double pi = 3.14159265358979323846;

// Independent of the room: turn the start radius by the sweep and look where it ends.
static void ends_on_its_target(check_t *check, const nck_block_t *from, const nck_block_t *arc) {
    static const int axes[3][2] = {{0, 1}, {2, 0}, {1, 2}};
    const int u = axes[arc->plane - 17][0], v = axes[arc->plane - 17][1];
    const double ru = (double)from->target_nm[u] / 1e6 - arc->centre_mm[0];
    const double rv = (double)from->target_nm[v] / 1e6 - arc->centre_mm[1];
    const double c = cos(arc->sweep_rad), s = sin(arc->sweep_rad);
    CHECK_INT(check, arc->kind, NCK_BLOCK_ARC);
    CHECK_NEAR(check, arc->centre_mm[0] + ru * c - rv * s, (double)arc->target_nm[u] / 1e6, 2e-9);
    CHECK_NEAR(check, arc->centre_mm[1] + ru * s + rv * c, (double)arc->target_nm[v] / 1e6, 2e-9);
}

static void is_arc(check_t *check, int k, double cu, double cv, double sweep) {
    CHECK_INT(check, self.errors, 0);
    CHECK_NEAR(check, self.block[k].centre_mm[0], cu, 1e-9);
    CHECK_NEAR(check, self.block[k].centre_mm[1], cv, 1e-9);
    CHECK_NEAR(check, self.block[k].sweep_rad, sweep, 1e-12);
    ends_on_its_target(check, &self.block[k - 1], &self.block[k]);
}

static void quarters_and_their_long_ways(check_t *check) {
    case_begin(&self);
    case_decode(&self, "F100 G0 X10\nG3 X0 Y10 I-10\nG2 X10 Y0 J-10\nG2 X0 Y10 I-10 J0\n"
                       "G3 X10 Y0 J-10\nM2\n");
    is_arc(check, 1, 0, 0, pi / 2);
    is_arc(check, 2, 0, 0, -pi / 2);
    is_arc(check, 3, 0, 0, -1.5 * pi);
    is_arc(check, 4, 0, 0, 1.5 * pi);
}

static void radius_words_choose_the_way(check_t *check) {
    case_begin(&self);
    case_decode(&self, "F100 G0 X10\nG3 X0 Y10 R10\nG0 X10 Y0\nG3 X0 Y10 R-10\nG0 X10 Y0\n"
                       "G2 X0 Y10 R10\nG2 X10 Y0 R-10\nG2 X0 R5\nM2\n");
    is_arc(check, 1, 0, 0, pi / 2);
    is_arc(check, 3, 10, 10, 1.5 * pi);
    is_arc(check, 5, 10, 10, -pi / 2);
    is_arc(check, 6, 10, 10, -1.5 * pi);
    is_arc(check, 7, 5, 0, -pi);
}

// Two circles through the middle need a middle that is neither end.
static void an_arc_of_a_nanometre_is_no_more_than_that(check_t *check) {
    case_begin(&self);
    self.machine.path.chord_error = 1e-9;
    case_decode(&self, "F100 G0 X0\nG2 X-0.000001 Y0.000001 I-0.000001 J0.000001\n"
                       "G3 X0 Y0 I0.000001 J-0.000001\nM2\n");
    CHECK_INT(check, self.errors, 0);
    ends_on_its_target(check, &self.block[0], &self.block[1]);
    ends_on_its_target(check, &self.block[1], &self.block[2]);
}

static void planes_turn_their_own_way(check_t *check) {
    case_begin(&self);
    case_decode(&self, "F100 G18 G0 Z10\nG3 Z0 X10 K-10\nG19 G0 X0 Y10 Z0\nG2 Y0 Z10 J-10 K0 X3\n"
                       "M2\n");
    is_arc(check, 1, 0, 0, pi / 2);
    CHECK_INT(check, self.block[1].plane, 18);
    is_arc(check, 3, 0, 0, -1.5 * pi);
    CHECK_INT(check, self.block[3].plane, 19);
    CHECK_INT(check, self.block[3].target_nm[0], 3000000);
}

static void full_circles_and_turns(check_t *check) {
    case_begin(&self);
    case_decode(&self, "F100 G0 X10\nG3 I-10\nG2 X10 Y0 Z5 I-10 P3\nG3 X0 Y10 I-10 P2\nI0 J-10\n"
                       "M2\n");
    is_arc(check, 1, 0, 0, 2 * pi);
    is_arc(check, 2, 0, 0, -6 * pi);
    is_arc(check, 3, 0, 0, 2.5 * pi);
    is_arc(check, 4, 0, 0, 2 * pi);
}

static void centres_may_be_absolute(check_t *check) {
    case_begin(&self);
    self.machine.work_nm[0][0] = 100000000;
    case_decode(&self, "F100 G90.1 G0 X10\nG3 X0 Y10 I0 J0\nG92 X50\nG2 X60 Y0 I50 J0\nM2\n");
    is_arc(check, 1, 100, 0, pi / 2);
    is_arc(check, 2, 100, 0, -pi / 2);
    check_error(check, &self, "F1 G90.1 G0 X10\nG3 X0 Y10 I0\nM2\n", NCK_E_WORD_MISSING, 2, 0);
    CHECK_INT(check, self.first.letter, 'J');
}

static void the_tool_moves_centre_and_target_alike(check_t *check) {
    case_begin(&self);
    self.machine.tool_count = 1;
    self.machine.tool[0].number = 1;
    self.machine.tool[0].offset_nm[0] = 3000000;
    case_decode(&self, "F100 G43 H1\nG0 X10\nG3 X0 Y10 I-10\nM2\n");
    is_arc(check, 1, 0, 0, pi / 2);
}

static void diameter_halves_the_end_and_not_the_centre(check_t *check) {
    case_begin(&self);
    self.machine.dialect.plane = 18;
    case_decode(&self, "F100 G7 G0 X20 Z0\nG3 X0 Z-10 I-10\nM2\n");
    is_arc(check, 1, 0, 0, pi / 2);
}

static void mistakes_of_arcs_are_told(check_t *check) {
    case_begin(&self);
    check_error(check, &self, "F1 G2 X1\nM2\n", NCK_E_ARC_CENTRE, 1, 4);
    check_error(check, &self, "F1 G2 X1 I0\nM2\n", NCK_E_ARC_CENTRE, 1, 4);
    check_error(check, &self, "F1 G2 X0 R1\nM2\n", NCK_E_ARC_CENTRE, 1, 10);
    check_error(check, &self, "F1 G2 X1 R0\nM2\n", NCK_E_ARC_CENTRE, 1, 10);
    check_error(check, &self, "F1 G2 X10 R4.9\nM2\n", NCK_E_ARC_CHORD, 1, 11);
    CHECK_NEAR(check, self.first.limit, 5.0, 0.0);
    check_error(check, &self, "F1 G2 X10 R4.996\nM2\n", NCK_OK, 0, 0);
    check_error(check, &self, "F1 G2 X1 R1 I1\nM2\n", NCK_E_WORD_UNUSED, 1, 13);
    check_error(check, &self, "F1 G2 X1 I.5 K0\nM2\n", NCK_E_WORD_UNUSED, 1, 14);
    check_error(check, &self, "F1 G2 X1 I.5 P0\nM2\n", NCK_E_NUMBER_RANGE, 1, 14);
    check_error(check, &self, "F1 G2 X1 I.5 P1.5\nM2\n", NCK_E_NUMBER_RANGE, 1, 14);
    check_error(check, &self, "G2 X1 I.5\nM2\n", NCK_E_FEED_MISSING, 1, 0);
    check_error(check, &self, "F1 G0 X10\nG2 X5 Y0 I-10\nX0 Y0 R9\nM2\n", NCK_E_ARC_RADIUS, 2, 1);
    CHECK_NEAR(check, self.first.value, 5.0, 0.0);
    CHECK_NEAR(check, self.first.limit, 10.0, 0.0);
    self.machine.axis[1].present = 0;
    check_error(check, &self, "F1 G0 X10\nG2 X0 I-5\nM2\n", NCK_E_AXIS_UNKNOWN, 2, 1);
}

// The rule: the tolerance, or a thousandth of the radius up to a hundred tolerances.
static void radii_may_differ_within_the_rule(check_t *check) {
    case_begin(&self);
    check_error(check, &self, "F1 G2 X2.0049 I1\nM2\n", NCK_OK, 0, 0);
    check_error(check, &self, "F1 G2 X2.0051 I1\nM2\n", NCK_E_ARC_RADIUS, 1, 4);
    check_error(check, &self, "F1 G2 X200.0999 I100\nM2\n", NCK_OK, 0, 0);
    check_error(check, &self, "F1 G2 X200.101 I100\nM2\n", NCK_E_ARC_RADIUS, 1, 4);
    check_error(check, &self, "F1 G2 X2000.501 I1000\nM2\n", NCK_E_ARC_RADIUS, 1, 4);
}

static void the_whole_sweep_must_be_in_the_travel(check_t *check) {
    case_begin(&self);
    self.machine.axis[1].max_nm = 10000000;
    self.machine.axis[0].min_nm = -10000000;
    check_error(check, &self, "F1 G0 X-10\nG2 X10 I10\nG3 X-10 I-10\nM2\n", NCK_OK, 0, 0);
    check_error(check, &self, "F1 G0 X-10\nG2 X10.1 I10.05\nM2\n", NCK_E_TRAVEL, 2, 0);
    CHECK_INT(check, self.first.letter, 'Y');
    CHECK_NEAR(check, self.first.value, 10.05, 1e-9);
    CHECK_NEAR(check, self.first.limit, 10.0, 0.0);
    check_error(check, &self, "F1 G0 X-8\nG3 X8 I8\nG3 I-8\nM2\n", NCK_OK, 0, 0);
    check_error(check, &self, "F1 G0 X0\nG3 I-5.1\nM2\n", NCK_E_TRAVEL, 2, 0);
    CHECK_INT(check, self.first.letter, 'X');
}

// Sampling decides where a random arc really goes; the check must agree with it.
static void where_an_arc_turns_back_agrees_with_sampling(check_t *check) {
    int wrong = 0;
    for (int k = 0; k < 3000; k++) {
        const double begin = 0.01 + k * 0.7548776662, sweep = 0.02 + fmod(k * 0.5698402910, 6.24);
        const double a[2] = {cos(begin), sin(begin)};
        const double b[2] = {cos(begin + sweep), sin(begin + sweep)};
        for (unsigned q = 0; q < 4; q++) {
            const double ahead = fmod(q * pi / 2 - begin + 4000 * pi, 2 * pi);
            if (fabs(ahead - sweep) < 1e-6 || ahead < 1e-6 || ahead > 2 * pi - 1e-6) continue;
            wrong += (nck_arc_bulges(a, b, sweep) >> q & 1u) != (ahead < sweep);
            wrong += (nck_arc_bulges(b, a, -sweep) >> q & 1u) != (ahead < sweep);
        }
        wrong += nck_arc_bulges(a, a, k % 2 ? 2 * pi : -2 * pi) != 15u;
    }
    CHECK_INT(check, wrong, 0);
}

// A circle that does not quite close: the arc through both ends would be another circle.
static void almost_closed_circles_stay_where_they_are(check_t *check) {
    static const char *const ends[] = {"X10.0005 Y0", "X9.9995 Y0", "X10.0003 Y-0.001",
                                       "X9.9997 Y-0.0175"};
    case_begin(&self);
    for (unsigned k = 0; k < sizeof ends / sizeof ends[0]; k++) {
        char text[80];
        (void)snprintf(text, sizeof text, "F100 G0 X10\nG3 %s Z8 I-10\nM2\n", ends[k]);
        case_decode(&self, text);
        CHECK_INT(check, self.errors, 0);
        CHECK_INT(check, self.blocks, 4);
        double sweep = 0.0;
        for (int n = 1; n <= 2; n++) {
            const nck_block_t *const arc = &self.block[n];
            ends_on_its_target(check, &self.block[n - 1], arc);
            CHECK_NEAR(check, hypot(arc->centre_mm[0], arc->centre_mm[1]), 0.0, 6e-4);
            sweep += arc->sweep_rad;
        }
        CHECK_NEAR(check, sweep, 2 * pi, 0.002);
        CHECK_NEAR(check, (double)self.block[1].target_nm[2] / 1e6, 4.0, 1e-3);
        CHECK_INT(check, self.block[2].target_nm[2], 8000000);
    }
}

static void random_arcs_in_four_decimals_end_on_their_targets(check_t *check) {
    case_begin(&self);
    for (int k = 0; k < 2000; k++) {
        char text[160];
        const double r = 0.05 + fmod(k * 7.31, 400.0), t0 = k * 2.399963;
        const double t1 = t0 + 0.001 + fmod(k * 0.7548776662, 2 * pi - 0.002);
        const double ci = -r * cos(t0), cj = -r * sin(t0);
        (void)snprintf(text, sizeof text, "G91 F100 G0 X%.4f\nG%d X%.4f Y%.4f I%.4f J%.4f\nM2\n",
                       r, k % 2 ? 3 : 2, ci + r * cos(t1), cj + r * sin(t1), ci, cj);
        case_decode(&self, text);
        CHECK_INT(check, self.errors, 0);
        for (int n = 1; n < self.blocks - 1; n++) {
            ends_on_its_target(check, &self.block[n - 1], &self.block[n]);
            CHECK(check, (self.block[n].sweep_rad > 0.0) == (k % 2 == 1));
        }
    }
}

int main(void) {
    check_t check = {0};
    CHECK_RUN(&check, quarters_and_their_long_ways);
    CHECK_RUN(&check, radius_words_choose_the_way);
    CHECK_RUN(&check, an_arc_of_a_nanometre_is_no_more_than_that);
    CHECK_RUN(&check, planes_turn_their_own_way);
    CHECK_RUN(&check, full_circles_and_turns);
    CHECK_RUN(&check, centres_may_be_absolute);
    CHECK_RUN(&check, the_tool_moves_centre_and_target_alike);
    CHECK_RUN(&check, diameter_halves_the_end_and_not_the_centre);
    CHECK_RUN(&check, mistakes_of_arcs_are_told);
    CHECK_RUN(&check, radii_may_differ_within_the_rule);
    CHECK_RUN(&check, the_whole_sweep_must_be_in_the_travel);
    CHECK_RUN(&check, where_an_arc_turns_back_agrees_with_sampling);
    CHECK_RUN(&check, almost_closed_circles_stay_where_they_are);
    CHECK_RUN(&check, random_arcs_in_four_decimals_end_on_their_targets);
    return check_end(&check);
}
