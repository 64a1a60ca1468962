// SPDX-License-Identifier: MIT
// A track and the lines that are pushed to it, for the tests of room 3.
#ifndef TRACK_CHECK_H
#define TRACK_CHECK_H

#include <math.h>   // hypot
#include <string.h> // memcpy memset

#include "nck/prep/3_smooth/track.h" // nck_track_…

static nck_track_t track;
static nck_seg_t seg;

// Lines begin at the origin, with this feed [mm/s].
static inline void begin_lines(double tau, double feed)
{
    memset(&seg, 0, sizeof seg);
    seg.feed = feed;
    nck_track_begin(&track, 2, tau, 0.0);
}

static inline nck_status_t line_to(double x, double y, double tolerance)
{
    memcpy(seg.start, seg.end, sizeof seg.start);
    seg.kind = NCK_SEG_LINE;
    seg.end[0] = x;
    seg.end[1] = y;
    seg.length = hypot(x - seg.start[0], y - seg.start[1]);
    seg.line++;
    seg.block = seg.line;
    return nck_track_push(&track, &seg, tolerance);
}

#endif
