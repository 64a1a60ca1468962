// SPDX-License-Identifier: MIT
// Room 5, slope: the linear slope.
#include "nck/prep/5_slope/slope.h"

#include <string.h> // memset

#include "nck/prep/5_slope/ramp_math.h" // nck_ramp_…

// Shorter pieces get one acceleration: a ramp up and down within a few periods would gain nothing
// and shake the machine.
#define SHORT_PERIODS 4.0
// A part of a piece that is shorter than this share of it is rounding.
#define LENGTH_EPSILON 1e-12
// A ramp counts as limited by acceleration above this share of it.
#define ACCEL_EPSILON 1e-6

void nck_slope_init(nck_slope_t *self, const nck_machine_t *machine) {
    memset(self, 0, sizeof *self);
    self->machine = machine;
}

// What holds a ramp back: the window's end, the acceleration, or the caps at its ends.
static uint8_t ramp_limit(const nck_node_t *node, double a) {
    if (node->open && a < 0.0) return NCK_LIMIT_LOOKAHEAD;
    if (nck_fabs(a) >= node->a * (1.0 - ACCEL_EPSILON)) return NCK_LIMIT_ACCEL;
    return node->vv < node->vv_cap ? NCK_LIMIT_ACCEL : node->limit;
}

// A part of the piece, from path coordinate s on, between w0 and w1.
static void set_cell(nck_cell_t *cell, const nck_node_t *node, double s, double length,
                     const double w[2]) {
    const double v0 = nck_sqrt(w[0]);
    const double v1 = nck_sqrt(w[1]);
    memset(cell, 0, sizeof *cell);
    cell->seg = node->seg;
    cell->s = s;
    cell->length = length;
    cell->v = v0;
    cell->a = nck_ramp_accel(length, w[0], w[1]);
    cell->duration = nck_ramp_duration(length, v0, v1);
    cell->limit = w[0] == w[1] && w[0] == node->vv_piece ? node->limit_piece
                                                         : ramp_limit(node, cell->a);
}

static int push_rest(const nck_node_t *node, nck_cell_t *cell) {
    memset(cell, 0, sizeof *cell);
    cell->seg = node->seg;
    cell->s = node->s;
    cell->duration = node->dwell_s;
    cell->limit = node->limit_piece;
    return 1;
}

static int push_short(const nck_node_t *node, double vv_end, nck_cell_t *cell) {
    const double w[2] = {node->vv, vv_end};
    set_cell(cell, node, node->s, node->length, w);
    return 1;
}

static int push_trapezoid(const nck_node_t *node, double vv_end, nck_cell_t *cells) {
    const double length = node->length;
    const double peak = nck_ramp_peak(length, node->vv, vv_end, node->a, node->vv_piece);
    const double up = nck_min(length, nck_ramp_length(node->vv, peak, node->a));
    const double down = nck_min(length - up, nck_ramp_length(peak, vv_end, node->a));
    const double cruise = length - up - down;
    const double parts[NCK_SLOPE_CELLS] = {up, cruise, down};
    const double ends[NCK_SLOPE_CELLS][2] = {{node->vv, peak}, {peak, peak}, {peak, vv_end}};
    double s = node->s;
    int count = 0;
    for (int k = 0; k < NCK_SLOPE_CELLS; k++) {
        if (!(parts[k] > LENGTH_EPSILON * length)) continue;
        set_cell(&cells[count], node, s, parts[k], ends[k]);
        count++;
        s += parts[k];
    }
    return count;
}

int nck_slope_push(const nck_slope_t *self, const nck_node_t *node, double vv_end,
                   nck_cell_t *cells_out) {
    int count = 0;
    const double v_sum = nck_sqrt(node->vv) + nck_sqrt(vv_end);
    if (!(node->length > 0.0)) {
        count = push_rest(node, cells_out);
    } else if (2.0 * node->length <= v_sum * SHORT_PERIODS * self->machine->period_s) {
        count = push_short(node, vv_end, cells_out);
    } else {
        count = push_trapezoid(node, vv_end, cells_out);
    }
    cells_out[count - 1].last = node->last;
    cells_out[count - 1].stop = node->stop;
    return count;
}

void nck_slope_brake_begin(nck_slope_t *self, double vv_begin) { self->vv_brake = vv_begin; }

nck_status_t nck_slope_brake(nck_slope_t *self, const nck_node_t *node, double vv_cap_end,
                             nck_cell_t *cell_out) {
    const double vv = self->vv_brake;
    if (!(vv > 0.0)) return NCK_EMPTY;
    const double reach = nck_ramp_length(vv, 0.0, node->a);
    const double length = nck_min(reach, node->length);
    const double vv_end = nck_max(0.0, vv - 2.0 * node->a * node->length);
    const int rests = reach <= node->length || vv_end == 0.0 || vv_cap_end == 0.0;
    const double w[2] = {vv, rests ? 0.0 : nck_min(vv_end, vv_cap_end)};
    set_cell(cell_out, node, node->s, length, w);
    cell_out->limit = NCK_LIMIT_STARVED;
    cell_out->last = !rests && node->last;
    cell_out->stop = (uint8_t)rests;
    self->vv_brake = w[1];
    return rests ? NCK_DONE : NCK_OK;
}
