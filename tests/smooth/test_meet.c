// SPDX-License-Identifier: MIT
// Room 3: the way to the outside of a corner has the machine's axes, and no more is written.
#include "nck/prep/3_smooth/meet.c"

#include <string.h> // memset

#include "check.h"

#define BEHIND 7.0 // stands behind the axes, in an array that has a place more

// A line whose tangent is the same on every axis but the last one; there it is
// opposite, if it turns.
static void line_of(nck_seg_t *seg, int axes, int turns)
{
    memset(seg, 0, sizeof *seg);
    seg->kind = NCK_SEG_LINE;
    seg->length = nck_sqrt((double)axes);
    for (int x = 0; x < axes; x++) seg->end[x] = turns && x == axes - 1 ? -1.0 : 1.0;
}

static void the_way_out_of_a_corner_is_a_unit_on_the_axes_alone(check_t *check)
{
    for (int axes = 1; axes <= NCK_AXIS_MAX; axes++) {
        nck_seg_t in;
        nck_seg_t out;
        double way[NCK_AXIS_MAX + 1];
        line_of(&in, axes, 0);
        line_of(&out, axes, 1);
        for (int x = 0; x <= NCK_AXIS_MAX; x++) way[x] = BEHIND;
        CHECK_NEAR(check, outward(&in, &out, axes, way), 2.0 / nck_sqrt((double)axes), 1e-12);
        for (int x = 0; x <= NCK_AXIS_MAX; x++) {
            CHECK_NEAR(check, way[x], x >= axes ? BEHIND : x == axes - 1 ? 1.0 : 0.0, 1e-12);
        }
    }
}

int main(void)
{
    check_t check = {0};
    CHECK_RUN(&check, the_way_out_of_a_corner_is_a_unit_on_the_axes_alone);
    return check_end(&check);
}
