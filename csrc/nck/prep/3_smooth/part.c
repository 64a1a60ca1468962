// SPDX-License-Identifier: MIT
// Inside room 3: parts of the spline between two knots, at the ends of which words change.
#include "nck/prep/3_smooth/part.h"

#include "nck/base/path.h"                 // nck_path_…
#include "nck/base/real.h"                 // nck_min nck_max
#include "nck/prep/3_smooth/raw.h"         // nck_raw_…
#include "nck/prep/3_smooth/spline_math.h" // nck_spline_…

#define MUCH 0.5            // of a knot interval, for a block's end to be a seg's end
// No part of a spline is shorter than this share of its interval, or than this [path mm]: the third
// difference of its points would be their rounding, and cap the speed as if it were a bend.
#define PART_SHARE (1.0 / 64.0)
#define PART_LONG 1e-3
enum { STRETCH_PARTS = 8 }; // of a spline, to find where it is fastest
// A part of a spline whose fastest place exceeds its mean by more is halved, so often at most, and
// into parts that last so many periods at least.
#define UNEVEN 1.05
#define UNEVEN_PERIODS 4.0
enum { HALVINGS = 3 };

// 1 if two blocks mean different motions on the same path.
static int words_differ(const nck_seg_t *a, const nck_seg_t *b) {
    return a->rapid != b->rapid || a->feed != b->feed || a->feed_scale != b->feed_scale
           || nck_raw_spins_differ(a, b);
}

// 1 if a block's end is a seg's end: what the program says changes there, or something is output.
static int parts_at(nck_smooth_t *self, uint32_t count, uint32_t next) {
    const int outputs = nck_raw_at(self, next)->has_output
                        || (next - 1 != count && nck_raw_at(self, next - 1)->has_output);
    return outputs || words_differ(&nck_raw_at(self, count)->seg, &nck_raw_at(self, next)->seg);
}

double nck_part_least(const nck_smooth_t *self) {
    const double to = self->run.t[3];
    const double share = PART_SHARE * (to - self->run.t[2]);
    return nck_max(nck_raw_least(to), nck_min(PART_LONG, share));
}

// Shorter blocks than what makes much of the interval are executed together, unless they are long.
double nck_part_end(nck_smooth_t *self) {
    const double to = self->run.t[3];
    const double least = nck_part_least(self);
    const double much = MUCH * (to - self->run.t[2]);
    uint32_t count = nck_raw_find(self, self->run.given + least);
    for (;;) {
        const nck_raw_t *const raw = nck_raw_at(self, count);
        const uint32_t next = nck_raw_next(self, count);
        const double end = raw->s + raw->seg.length;
        if (next == self->run.end || end > to - least) return to;
        const int rests = raw->seg.length > much || nck_raw_is_long(self, &raw->seg);
        if (rests || parts_at(self, count, next)) return end;
        count = next;
    }
}

const nck_raw_t *nck_part_raw(nck_smooth_t *self, double end) {
    return nck_raw_at(self, nck_raw_find(self, end - nck_part_least(self)));
}

// |dp/ds| of a spline between two places: the largest, and the mean of what divides the feed.
// dp/ds is a parabola: between places h apart it is larger than at them by |p‴|·h²/8 at most.
typedef struct stretch {
    double most, mean;
} stretch_t;

static stretch_t stretch_of(const nck_seg_t *seg, double from, double to, int axes) {
    const double h = (to - from) / (double)STRETCH_PARTS;
    stretch_t stretch = {0.0, 0.0};
    double third[NCK_AXIS_MAX];
    for (int k = 0; k <= STRETCH_PARTS; k++) {
        double tangent[NCK_AXIS_MAX];
        nck_path_tangent_part(seg, from + h * (double)k, axes, tangent);
        const double speed = nck_spline_norm(tangent, axes);
        stretch.most = nck_max(stretch.most, speed);
        stretch.mean += nck_max(1.0, speed);
    }
    stretch.mean *= 1.0 / (double)(STRETCH_PARTS + 1);
    nck_path_third_part(seg, 0.0, axes, third);
    stretch.most += nck_spline_sag(nck_spline_norm(third, axes), h);
    return stretch;
}

// A part is halved as long as the tool, which keeps to the feed where it is fastest, would be
// slower on average by more than UNEVEN, and for some periods.
double nck_part_even(nck_smooth_t *self, const nck_seg_t *spline, double end,
                     double *stretch_out) {
    const double begin = self->run.t[2];
    const double given = self->run.given;
    const nck_seg_t *const words = &nck_part_raw(self, end)->seg;
    const double least = UNEVEN_PERIODS * words->feed * self->terms->machine->period_s;
    int halvings = HALVINGS;
    double to = end;
    for (;;) {
        const stretch_t stretch =
            stretch_of(spline, given - begin, to - begin, self->terms->axes);
        const double half = 0.5 * (to - given);
        const int is_even = stretch.most <= UNEVEN * stretch.mean || stretch.most <= 1.0;
        *stretch_out = stretch.most;
        if (is_even || words->rapid || halvings == 0 || half < least) return to;
        halvings--;
        to = given + half;
    }
}
