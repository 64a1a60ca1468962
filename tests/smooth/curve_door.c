// SPDX-License-Identifier: MIT
// A door to the curve within P for Python: a polygon in, control points and s at knots out.
#include <math.h>   // fmin sqrt
#include <string.h> // memcpy memset

#include "nck/base/tuning.h"          // NCK_ITERATIONS
#include "nck/prep/3_smooth/stream.h" // nck_stream_…

// What is asked, and what has come of it.
typedef struct curve_run {
    int points, axes, rounds, room; // room: pieces that fit
    double tau, longest, tolerance, feed, v, a, j;
    int pieces;
    double told[8]; // windows, iterations, iterations of plans, again, missed, most |r − p|/P,
                    // rests for want of a curve, seams with no rest behind them
} curve_run_t;

static nck_stream_t stream;

static void begin(const curve_run_t *run)
{
    nck_stream_wish_t wish;
    const double smooth = fmin(run->j, run->a / run->tau);
    memset(&wish, 0, sizeof wish);
    wish.terms.axes = run->axes;
    wish.terms.tau = run->tau;
    for (int x = 0; x < run->axes; x++) {
        wish.terms.v[x] = (nck_num)run->v;
        wish.terms.a[x] = (nck_num)run->a;
        wish.terms.j[x] = (nck_num)run->j;
        wish.terms.smooth[x] = (nck_num)smooth;
    }
    wish.terms.v_most = (nck_num)run->v;
    wish.terms.a_least = (nck_num)run->a;
    wish.terms.j_least = (nck_num)run->j;
    wish.terms.smooth_least = (nck_num)smooth;
    wish.terms.longest = (nck_num)run->longest;
    wish.rounds = run->rounds;
    wish.gap = 0.1;
    wish.most = NCK_ITERATIONS;
    nck_stream_begin(&stream, &wish);
}

// The next line with length, from where the last one ended; NCK_DONE: there is none.
static nck_status_t push(const curve_run_t *run, const double *points, nck_seg_t *seg)
{
    while ((int)++seg->line < run->points) {
        double square = 0.0;
        memcpy(seg->start, seg->end, sizeof seg->start);
        for (int x = 0; x < run->axes; x++) {
            seg->end[x] = points[(int)seg->line * run->axes + x];
            square += (seg->end[x] - seg->start[x]) * (seg->end[x] - seg->start[x]);
        }
        seg->length = sqrt(square);
        seg->block = seg->line;
        if (seg->length > 0.0) return nck_stream_push(&stream, seg, run->tolerance);
    }
    return NCK_DONE;
}

static void take(curve_run_t *run, double *control_out, double *s_out)
{
    nck_stream_piece_t piece;
    nck_stream_take(&stream, &piece);
    for (int p = 0; p < 4; p++) {
        double *const point = &control_out[(run->pieces + p) * run->axes];
        memcpy(point, piece.point[p], (size_t)run->axes * sizeof *point);
    }
    s_out[run->pieces++] = piece.s[0];
    s_out[run->pieces] = piece.s[1];
}

int curve_run(curve_run_t *run, const double *points, double *control_out, double *s_out);

int curve_run(curve_run_t *run, const double *points, double *control_out, double *s_out)
{
    nck_seg_t seg;
    nck_status_t status = NCK_OK;
    memset(&seg, 0, sizeof seg);
    memcpy(seg.end, points, (size_t)run->axes * sizeof *points);
    seg.feed = run->feed;
    begin(run);
    while (status != NCK_DONE && status >= 0 && run->pieces < run->room) {
        status = nck_stream_step(&stream);
        if (status == NCK_FULL) take(run, control_out, s_out);
        if (status != NCK_EMPTY) continue;
        status = push(run, points, &seg);
        if (status != NCK_DONE) continue;
        nck_stream_close(&stream);
        status = NCK_OK;
    }
    const nck_stream_told_t *const told = &stream.told;
    const double all[8] = {told->windows, told->iterations, told->plans, told->again,
                           told->missed,  told->most,       told->rests, told->restless};
    memcpy(run->told, all, sizeof all);
    return (int)status;
}
