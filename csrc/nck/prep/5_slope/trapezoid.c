// SPDX-License-Identifier: MIT
// Room 5, slope: the trapezoid over a piece, and braking through it.
#include "nck/prep/5_slope/trapezoid.h"

#include <string.h> // memset

#include "nck/base/real.h"              // nck_min nck_max nck_sqrt nck_fabs
#include "nck/prep/5_slope/ramp_math.h" // nck_ramp_…

// Shorter spans get one acceleration: a ramp up and down within a few periods would gain nothing
// and shake the machine.
#define SHORT_PERIODS 4.0
// A leg that is shorter than this share of its span is rounding.
#define LENGTH_EPSILON 1e-12
// A rest this near to a piece's end, as a share of what is left of the piece, is at that end.
#define REST_EPSILON 1e-9
// A ramp counts as limited by acceleration above this share of it.
#define ACCEL_EPSILON 1e-6

// What holds a ramp back: the window's end, the acceleration, or the caps at its ends.
static uint8_t ramp_limit(const nck_node_t *piece, double a) {
    if (piece->open && a < 0.0) return NCK_LIMIT_LOOKAHEAD;
    if (nck_fabs(a) >= piece->a * (1.0 - ACCEL_EPSILON)) return NCK_LIMIT_ACCEL;
    return piece->vv < piece->vv_cap ? NCK_LIMIT_ACCEL : piece->limit;
}

// A stretch of constant acceleration, from path coordinate s on, between vv[0] and vv[1]; v: their
// roots.
static inline void set_leg(nck_cell_t *cell, const nck_node_t *piece, double s, double length,
                           const double vv[2], const double v[2]) {
    cell->seg = piece->seg;
    cell->stop = 0;
    cell->last = 0;
    cell->span = 0;
    cell->s = s;
    cell->length = length;
    cell->v = v[0];
    cell->a = nck_ramp_accel(length, vv[0], vv[1]);
    cell->j = 0.0;
    cell->duration = nck_ramp_duration(length, v[0], v[1]);
    cell->limit = vv[0] == vv[1] && vv[0] == piece->vv_piece ? piece->limit_piece
                                                          : ramp_limit(piece, cell->a);
}

static void set_cell(nck_cell_t *cell, const nck_node_t *piece, double s, double length,
                     const double vv[2]) {
    const double v[2] = {nck_sqrt(vv[0]), nck_sqrt(vv[1])};
    set_leg(cell, piece, s, length, vv, v);
}

static void set_rest(const nck_node_t *piece, nck_cell_t *cell) {
    memset(cell, 0, sizeof *cell);
    cell->seg = piece->seg;
    cell->s = piece->s;
    cell->duration = piece->standstill.dwell_s;
    cell->limit = piece->limit_piece;
}

static int set_legs(const nck_node_t *piece, const nck_span_t *span, nck_cell_t *legs) {
    const double least = nck_max(span->vv_peak, span->vv_out);
    const int slows = span->vv_in > least;
    const double peak = slows ? least : nck_ramp_peak(span->length, span->vv_in, span->vv_out,
                                                      span->a, span->vv_peak);
    const double up = nck_min(span->length, nck_ramp_length(span->vv_in, peak, span->a));
    const double down = nck_min(span->length - up, nck_ramp_length(peak, span->vv_out, span->a));
    const double parts[NCK_TRAPEZOID_LEGS] = {up, span->length - up - down, down};
    const double ends[NCK_TRAPEZOID_LEGS][2] = {
        {span->vv_in, peak}, {peak, peak}, {peak, span->vv_out}};
    double s = span->s;
    int count = 0;
    for (int k = 0; k < NCK_TRAPEZOID_LEGS; k++) {
        if (!(parts[k] > LENGTH_EPSILON * span->length)) continue;
        set_cell(&legs[count], piece, s, parts[k], ends[k]);
        count++;
        s += parts[k];
    }
    return count;
}

int nck_trapezoid_legs(const nck_node_t *piece, const nck_span_t *span, double period,
                       nck_cell_t *legs_out) {
    int count = 1;
    const double vv[2] = {span->vv_in, span->vv_out};
    const double v[2] = {nck_sqrt(vv[0]), nck_sqrt(vv[1])};
    if (!(piece->length > 0.0)) {
        set_rest(piece, legs_out);
    } else if (2.0 * span->length <= (v[0] + v[1]) * SHORT_PERIODS * period) {
        set_leg(legs_out, piece, span->s, span->length, vv, v);
    } else {
        count = set_legs(piece, span, legs_out);
    }
    legs_out[count - 1].last = piece->last;
    legs_out[count - 1].stop = piece->stop;
    return count;
}

int nck_trapezoid_brake(const nck_node_t *piece, const nck_span_t *span, nck_cell_t *cell_out) {
    const double reach = nck_ramp_length(span->vv_in, 0.0, span->a);
    const double vv_end = nck_max(0.0, span->vv_in - 2.0 * span->a * span->length);
    const int is_all = reach >= span->length * (1.0 - REST_EPSILON);
    const int is_end = is_all && reach <= span->length * (1.0 + REST_EPSILON);
    const int rests = !is_all || is_end || vv_end == 0.0 || span->vv_out == 0.0;
    const double length = is_all ? span->length : reach;
    const double vv[2] = {span->vv_in, rests ? 0.0 : vv_end};
    set_cell(cell_out, piece, span->s, length, vv);
    cell_out->limit = NCK_LIMIT_STARVED;
    cell_out->last = length < span->length ? 0 : piece->last;
    cell_out->stop = (uint8_t)rests;
    return rests;
}
