// SPDX-License-Identifier: MIT
// Inside room 3: runs of blocks within a tolerance as clocked paths.
#include "nck/base/path_math.h"        // nck_path_slope
#include "nck/base/real.h"             // nck_fabs nck_max nck_min
#include "nck/base/tuning.h"           // NCK_ITERATIONS
#include "nck/prep/3_smooth/clocked.h"
#include "nck/prep/3_smooth/smooth.h"  // NCK_HAS_OPTIMAL
#include "nck/prep/3_smooth/tuning.h" // NCK_STREAM_ROUNDS …

#include <stddef.h> // offsetof
#include <string.h> // memcpy memset

#define LENGTH_LEAST 1e-9 // [path mm] of an interval beside a rest; one without length is a rest

static double most_feed(const nck_machine_t *machine, const nck_seg_t *seg, int axes) {
    double slowness = 0.0;
    for (int x = 0; x < axes; x++) {
        if (!machine->axis[x].present) continue;
        const double along = seg->kind == NCK_SEG_ARC ? 1.0 : nck_fabs(nck_path_slope(seg, x));
        slowness = nck_max(slowness, along / machine->axis[x].rapid);
    }
    return 1.0 / slowness;
}

// The axes that the machine lacks never move: any limit will do.
static void set_terms(nck_timing_terms_t *out, const nck_terms_t *terms) {
    const nck_machine_t *const machine = terms->machine;
    memset(out, 0, sizeof *out);
    out->axes = terms->axes;
    out->tau = terms->knot_s;
    out->spin_a = machine->spindle.a_max_rpm_s;
    if (terms->limits_path) {
        out->along[0] = machine->path.a_max;
        out->along[1] = machine->path.j_max;
    }
    const nck_num per = (nck_num)(1.0 / out->tau);
    out->a_least = (nck_num)machine->path.a_max;
    out->j_least = (nck_num)machine->path.j_max;
    out->smooth_least = nck_num_min(out->j_least, out->a_least * per);
    out->longest = (nck_num)terms->knots_most;
    for (int x = 0; x < terms->axes; x++) {
        const nck_axis_t *const axis = &machine->axis[x];
        out->v[x] = axis->present ? (nck_num)axis->v_max : 1;
        out->a[x] = axis->present ? (nck_num)axis->a_max : 1;
        out->j[x] = axis->present ? (nck_num)axis->j_max : 1;
        out->smooth[x] = nck_num_min(out->j[x], out->a[x] * per);
        if (!axis->present) continue;
        out->smooth_least = nck_num_min(out->smooth_least, out->smooth[x]);
        out->v_most = nck_num_max(out->v_most, out->v[x]);
        out->a_least = nck_num_min(out->a_least, out->a[x]);
        out->j_least = nck_num_min(out->j_least, out->j[x]);
    }
}

static void open_run(nck_clocked_t *self, const nck_terms_t *terms, const nck_seg_t *seg,
                     int rests) {
    nck_stream_wish_t wish;
    set_terms(&wish.terms, terms);
    wish.rounds = NCK_STREAM_ROUNDS;
    wish.gap = NCK_STREAM_GAP;
    wish.most = NCK_ITERATIONS;
    self->open = 1;
    self->closed = 0;
    self->rests = rests ? 0 : 1;
    self->s = 0.0;
    self->out.head = 0;
    self->out.tail = 0;
    memcpy(self->position, seg->start, sizeof self->position);
    nck_stream_begin(&self->stream, &wish);
}

void nck_clocked_init(nck_clocked_t *self) {
    if (NCK_HAS_OPTIMAL) memset(self, 0, offsetof(nck_clocked_t, stream)); // which each run begins
}

nck_status_t nck_clocked_push(nck_clocked_t *self, const nck_terms_t *terms, const nck_seg_t *seg,
                              double tolerance, int rests) {
    if (!NCK_HAS_OPTIMAL) return NCK_FULL;
    nck_seg_t way = *seg;
    if (!self->open) open_run(self, terms, seg, rests);
    const double most = terms->machine->path.feed_max / seg->feed_scale;
    if (seg->rapid) way.feed = most_feed(terms->machine, seg, terms->axes);
    else way.feed = nck_min(seg->feed, most);
    const nck_status_t status = nck_stream_push(&self->stream, &way, tolerance);
    if (status == NCK_OK) self->s += seg->length;
    return status;
}

void nck_clocked_push_output(nck_clocked_t *self, const nck_output_t *output) {
    const uint32_t k = self->out.head & (NCK_CLOCKED_OUTPUTS - 1);
    self->out.at[k].s = self->s;
    self->out.at[k].output = *output;
    self->out.head++;
}

void nck_clocked_close(nck_clocked_t *self) {
    if (!NCK_HAS_OPTIMAL || !self->open || self->closed) return;
    self->closed = 1;
    nck_stream_close(&self->stream);
}

// The next output, if its place is before s.
static const nck_output_t *due_output(nck_clocked_t *self, double s) {
    const uint32_t k = self->out.tail & (NCK_CLOCKED_OUTPUTS - 1);
    if (self->out.tail == self->out.head || self->out.at[k].s > s) return (nck_output_t *)0;
    self->out.tail++;
    return &self->out.at[k].output;
}

// Bernstein points of an interval, from where the last one ends. At a rest they are the point
// itself, to the bit.
static void set_points(nck_clocked_t *self, const nck_stream_piece_t *piece, nck_seg_t *seg) {
    const double (*const c)[NCK_AXIS_MAX] = piece->point;
    const int ends = (piece->rests & 2) != 0;
    memcpy(seg->start, self->position, sizeof seg->start);
    memcpy(seg->end, c[2], sizeof seg->end);
    for (int x = 0; x < self->stream.track.axes; x++) {
        seg->shape.inner[0][x] = (2.0 * c[1][x] + c[2][x]) / 3.0;
        seg->shape.inner[1][x] = (c[1][x] + 2.0 * c[2][x]) / 3.0;
        if (!ends) seg->end[x] = (c[1][x] + 4.0 * c[2][x] + c[3][x]) / 6.0;
    }
    const int axes = self->stream.track.axes;
    const size_t rest = (size_t)(NCK_AXIS_MAX - axes) * sizeof seg->start[0];
    memcpy(&seg->shape.inner[0][axes], &seg->start[axes], rest);
    memcpy(&seg->shape.inner[1][axes], &seg->start[axes], rest);
    memcpy(&seg->end[axes], &seg->start[axes], rest);
    memcpy(self->position, seg->end, sizeof self->position);
}

static void take_piece(nck_clocked_t *self, nck_seg_t *seg) {
    nck_stream_piece_t piece;
    nck_stream_take(&self->stream, &piece);
    memset(seg, 0, sizeof *seg);
    seg->kind = NCK_SEG_SPLINE;
    set_points(self, &piece, seg);
    seg->length = nck_max(piece.s[1] - piece.s[0], LENGTH_LEAST);
    seg->stop = (piece.rests & 2) != 0;
    seg->line = piece.line;
    seg->block = piece.block;
    seg->rapid = piece.words.rapid;
    seg->feed = seg->rapid ? 0.0 : piece.words.feed;
    seg->v_most = seg->rapid ? piece.words.feed : 0.0;
    seg->feed_scale = piece.words.feed_scale;
    seg->spin = piece.words.spin;
}

// A rest of no time, before the run begins.
static void rest_first(nck_clocked_t *self, nck_seg_t *seg) {
    const nck_track_element_t *const first = nck_track_at(&self->stream.track, 0);
    nck_track_words_t words;
    nck_track_words(&self->stream.track, 0, 0.0, self->position[NCK_AXIS_X], &words);
    memset(seg, 0, sizeof *seg);
    seg->kind = NCK_SEG_DWELL;
    seg->stop = 1;
    seg->keeps = NCK_KEEP_REST;
    seg->line = first->line;
    seg->block = first->block;
    seg->feed_scale = 1.0;
    seg->spin = words.spin;
    memcpy(seg->start, self->position, sizeof seg->start);
    memcpy(seg->end, self->position, sizeof seg->end);
    self->rests = 0;
}

nck_status_t nck_clocked_pull(nck_clocked_t *self, nck_seg_t *seg_out,
                              const nck_output_t **output_out) {
    *output_out = (nck_output_t *)0;
    if (!NCK_HAS_OPTIMAL) return NCK_DONE;
    if (self->rests) {
        rest_first(self, seg_out);
        return NCK_OK;
    }
    const nck_status_t status = nck_stream_step(&self->stream);
    if (status == NCK_OK) return NCK_FULL;
    if (status == NCK_FULL) {
        *output_out = due_output(self, nck_stream_place(&self->stream));
        if (!*output_out) take_piece(self, seg_out);
        return NCK_OK;
    }
    if (status != NCK_DONE) return status;
    *output_out = due_output(self, self->s);
    if (*output_out) return NCK_OK;
    self->open = 0;
    return NCK_DONE;
}
