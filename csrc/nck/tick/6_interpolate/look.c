// SPDX-License-Identifier: MIT
// Inside room 6: what a brake of the tick looks at.
#include "nck/tick/6_interpolate/look.h"

#include <stddef.h> // NULL
#include <string.h> // memset

#include "nck/base/fence.h" // nck_fence_load
#include "nck/base/path.h"  // nck_path_tangent nck_path_second nck_path_third
#include "nck/base/real.h"  // nck_min nck_max nck_fabs

// Of an axis' jerk, what braking in a bend may take: the rest is left to change the braking …
#define BEND_SHARE 0.8
// … and what it takes at least: at lower speeds bends leave more.
#define BEND_LEAST 0.04
// Of the jerk that a line has to make braking weaker, what is left of it before a bend.
#define BEND_BACK 0.5
// Places where a brake looks for bends, as far as BEND_TIMES of what it takes to become weaker by
// half.
enum { BEND_PLACES = 4 };
#define BEND_TIMES 3.0
// Corners of a period and the next one that a brake looks at: that bounds the work of a tick.
enum { CORNERS = 16 };

void nck_look_geometry(const nck_seg_t *seg, double s, nck_look_geometry_t *out) {
    nck_path_tangent(seg, s, out->first);
    nck_path_second(seg, s, out->second);
    nck_path_third(seg, s, out->third);
}

// The seg behind one whose end the path goes over without a rest; NULL: none is known.
static const nck_seg_t *onward(const nck_look_place_t *place, const nck_seg_t *seg) {
    const nck_link_t *const link = place->link;
    if (seg->stop || nck_fence_load(&link->seg_head) - seg->seq <= 1) return NULL;
    const nck_seg_t *const next = nck_link_seg(link, seg->seq + 1);
    return next->length > 0.0 ? next : NULL;
}

// What a corner adds, upward and downward apart: curves go on, zigzags do not.
static void add_jump(const nck_seg_t *seg, const nck_seg_t *next, double share, double *up,
                     double *down) {
    double before[NCK_AXIS_MAX];
    double behind[NCK_AXIS_MAX];
    nck_path_tangent(seg, seg->length, before);
    nck_path_tangent(next, 0.0, behind);
    for (int x = 0; x < NCK_AXIS_MAX; x++) {
        const double jump = share * (behind[x] - before[x]);
        up[x] += nck_max(0.0, jump);
        down[x] += nck_max(0.0, -jump);
    }
}

void nck_look_corners(const nck_look_place_t *place, double v, double period, double *jump_out) {
    double down[NCK_AXIS_MAX];
    double time = nck_max(0.0, place->seg->length - place->s) / v;
    double share = 1.0;
    const nck_seg_t *seg = place->seg;
    const nck_seg_t *next = place->behind;
    memset(jump_out, 0, sizeof down);
    memset(down, 0, sizeof down);
    for (int n = 0; n < (int)CORNERS && next && share > 0.0; n++) {
        add_jump(seg, next, share, jump_out, down);
        time += next->length / v;
        share = 1.0 - nck_fabs(time - period) / period;
        seg = next;
        next = onward(place, seg);
    }
    for (int x = 0; x < NCK_AXIS_MAX; x++) jump_out[x] = nck_max(jump_out[x], down[x]);
}

// What a bend leaves to braking, of every axis:  |p‴v³ − 3p″v|a|| ≤ J
static double accel_in_bend(const nck_terms_t *terms, const nck_seg_t *seg, double s, double v,
                            double most) {
    double accel = most;
    nck_look_geometry_t at;
    if (seg->kind == NCK_SEG_LINE) return accel;
    nck_look_geometry(seg, s, &at);
    for (int x = 0; x < terms->axes; x++) {
        const nck_axis_t *const axis = &terms->machine->axis[x];
        const double bend = 3.0 * nck_fabs(at.second[x]) * v;
        const double turn = (at.second[x] < 0.0 ? -1.0 : 1.0) * at.third[x] * v * v * v;
        const double takes = nck_max(BEND_LEAST * axis->j_max, BEND_SHARE * axis->j_max + turn);
        if (axis->present && bend * accel > takes) accel = takes / bend;
    }
    return accel;
}

// Where the path is so far behind a place [of its seg's coordinate]: the seg there, or the last one
// that is known on this side of a rest.
static const nck_seg_t *seek_ahead(const nck_look_place_t *place, double way, double *s_out) {
    const nck_link_t *const link = place->link;
    const uint32_t head = nck_fence_load(&link->seg_head);
    const nck_seg_t *seg = place->seg;
    double s = place->s + way;
    while (s > seg->length && !seg->stop && head - seg->seq > 1) {
        const nck_seg_t *const next = nck_link_seg(link, seg->seq + 1);
        if (!(next->length > 0.0)) break;
        s -= seg->length;
        seg = next;
    }
    *s_out = nck_min(s, seg->length);
    return seg;
}

double nck_look_bends(const nck_terms_t *terms, const nck_look_place_t *place,
                      const nck_look_tool_t *tool) {
    const double back = BEND_BACK * tool->j;
    double a_low = -tool->most;
    const double half = 0.5 * nck_fabs(tool->a) / back + terms->machine->period_s;
    for (int n = 0; n < (int)BEND_PLACES; n++) {
        const double time = BEND_TIMES * half * (double)n / (double)(BEND_PLACES - 1);
        double s = 0.0;
        const nck_seg_t *const seg = seek_ahead(place, tool->v * time, &s);
        const double v_there = nck_max(0.0, tool->v + 0.5 * tool->a * time);
        const double there = accel_in_bend(terms, seg, s, v_there, tool->most);
        a_low = nck_max(a_low, -there - back * time);
    }
    if (!place->behind) return a_low;
    const double there = accel_in_bend(terms, place->behind, 0.0, tool->v, tool->most);
    return nck_max(a_low, -there - back * tool->end_s);
}
