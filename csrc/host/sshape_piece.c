// SPDX-License-Identifier: MIT
// One piece of path under the classical S-shape.
//
// With an S-shape a ramp to a speed in the middle may need more length than one to zero: its length
// (v0 + v1)/2 · duration(v0 − v1) rises with v1 near 0 before it falls. So "can still be braked"
// asks for the better of the two, and the good speeds at a junction stay an interval from 0.
#include "host/sshape_piece.h"

#include <string.h> // memset

#include "nck/base/real.h"                // nck_min nck_max nck_fabs
#include "host/sshape_math.h" // nck_sshape_length …

enum { HALVINGS = 60 }; // a double has 53 bits

static double reach(const nck_sshape_piece_t *piece, double v) {
    return nck_sshape_reach(v, piece->length, piece->a, piece->j);
}

static double ramp_length(const nck_sshape_piece_t *piece, double v0, double v1) {
    return v0 == v1 ? 0.0 : nck_sshape_length(v0, v1, piece->a, piece->j);
}

// From v_in over a peak to v_out.
static double ramps_by(const nck_sshape_piece_t *piece, double v_in, double peak, double v_out) {
    return ramp_length(piece, v_in, peak) + ramp_length(piece, peak, v_out);
}

double nck_sshape_brakeable(const nck_sshape_piece_t *piece, double v_out) {
    return nck_max(reach(piece, v_out), reach(piece, 0.0));
}

// Rounding has missed one of the two speeds that v was brakeable for: this one.
static double nearer_end(const nck_sshape_piece_t *piece, double v, double v_most) {
    return ramps_by(piece, v, v_most, v_most) <= ramps_by(piece, v, 0.0, 0.0) ? v_most : 0.0;
}

// The speed nearest to one that does not fit, from one that does on: reached from v_in within the
// piece and, if v_out is not negative, left for v_out there.
static double last_fit(const nck_sshape_piece_t *piece, double v_in, double v_out, double fits,
                       double fails) {
    for (int k = 0; k < HALVINGS; k++) {
        const double middle = 0.5 * (fits + fails);
        const double end = v_out < 0.0 ? middle : v_out;
        if (ramps_by(piece, v_in, middle, end) <= piece->length) {
            fits = middle;
        } else {
            fails = middle;
        }
    }
    return fits;
}

// Some speed below v_most is reached, because v is brakeable; from 0 on up to a limit all are.
double nck_sshape_fastest_end(const nck_sshape_piece_t *piece, double v, double v_most) {
    if (v_most >= v) return nck_min(v_most, reach(piece, v));
    if (v <= reach(piece, v_most)) return v_most;
    const double v_end = last_fit(piece, v, -1.0, 0.0, v_most);
    return v_end > 0.0 ? v_end : nearer_end(piece, v, v_most);
}

// Too short to come to rest: then, from v down to a limit, all speeds are reached.
double nck_sshape_slowest_end(const nck_sshape_piece_t *piece, double v, double v_most) {
    if (ramps_by(piece, v, 0.0, 0.0) <= piece->length) return 0.0;
    const double v_end = last_fit(piece, v, -1.0, v, 0.0);
    return v_end <= v_most ? v_end : nearer_end(piece, v, v_most);
}

// At least the larger of both ends.
static double peak_speed(const nck_sshape_piece_t *piece, double v_in, double v_out) {
    const double cap = piece->v_cap;
    if (ramps_by(piece, v_in, cap, v_out) <= piece->length) return cap;
    return last_fit(piece, v_in, v_out, nck_max(v_in, v_out), cap);
}

void nck_sshape_plan(const nck_sshape_piece_t *piece, double v_in, double v_out,
                     nck_sshape_course_t *course_out) {
    const double peak = peak_speed(piece, v_in, v_out);
    const double ramps = ramps_by(piece, v_in, peak, v_out);
    const double left = piece->length - ramps;
    const int cruises = left > NCK_SSHAPE_EPSILON * piece->length;
    course_out->peak = peak;
    course_out->v_out = v_out;
    course_out->cruise = cruises ? left : 0.0;
    course_out->stretch = cruises ? 1.0 : piece->length / ramps;
}

void nck_sshape_draw(nck_sshape_pen_t *pen, double duration, double a, double j) {
    if (duration <= 0.0) return; // what is no number is drawn, and refused by the link
    nck_cell_t *const cell = &pen->cells[pen->count];
    memset(cell, 0, sizeof *cell);
    cell->seg = pen->seg;
    cell->limit = j != 0.0 ? NCK_LIMIT_JERK : NCK_LIMIT_ACCEL;
    cell->s = pen->s;
    cell->v = pen->v;
    cell->a = a;
    cell->j = j;
    cell->duration = duration;
    cell->length = duration * (pen->v + duration * (a / 2.0 + duration * j / 6.0));
    pen->s += cell->length;
    pen->v += duration * (a + duration * j / 2.0);
    pen->count++;
}

void nck_sshape_draw_s(nck_sshape_pen_t *pen, double v, double rise, double hold, double j) {
    const double signed_j = v > pen->v ? j : -j;
    nck_sshape_draw(pen, rise, 0.0, signed_j);
    nck_sshape_draw(pen, hold, signed_j * rise, 0.0);
    nck_sshape_draw(pen, rise, signed_j * rise, -signed_j);
    pen->v = v;
}

void nck_sshape_draw_ramp(nck_sshape_pen_t *pen, const nck_sshape_piece_t *piece, double v,
                          double stretch) {
    const double dv = nck_fabs(v - pen->v);
    if (dv == 0.0) return;
    const double rise = nck_sshape_peak(dv, piece->a, piece->j) / piece->j;
    const double hold = nck_sshape_duration(dv, piece->a, piece->j) - 2.0 * rise;
    const double j = piece->j / (stretch * stretch);
    const int holds = hold > NCK_SSHAPE_EPSILON * rise;
    nck_sshape_draw_s(pen, v, stretch * rise, holds ? stretch * hold : 0.0, j);
}
