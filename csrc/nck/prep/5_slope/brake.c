// SPDX-License-Identifier: MIT
// Inside room 5: how a hold brakes.
#include "nck/prep/5_slope/brake.h"

#include "nck/base/real.h"                // nck_min nck_max nck_sqrt
#include "nck/prep/5_slope/hull_math.h"   // nck_hull_share
#include "nck/prep/5_slope/window.h"      // nck_window_…

// Pieces on either side that are looked at, at most; what the filter mixes beyond them relaxes
// nothing.
enum { MIXED_MOST = 64 };

// Share of an axis' acceleration that |p″|v² uses at a spline's cap, at most (budget of room 4).
#define CURVE_SHARE 0.95
// Share of the jerk that 3|p″|v·a may use (budget of room 4).
#define RAMP_SHARE 0.5
// A cap beyond every speed's square.
#define UNCAPPED 1e18

void nck_brake_begin(nck_profile_t *state, double q_cap) {
    state->v_last = state->v;
    state->a_last = state->a;
    state->share = 0.5 * nck_min(state->q, q_cap);
}

double nck_brake_cell(nck_profile_t *state, double h, double a_max, double j, double q_cap) {
    const double v = state->v_last;
    const double share = nck_hull_share(h, 2.0 * v, q_cap);
    const double fall = NCK_BRAKE_SHARE * j * (state->share + share);
    const double a = nck_max(-NCK_BRAKE_SHARE * a_max, state->a_last - fall);
    state->a_last = a;
    state->share = share;
    return nck_max(0.0, v * v + 2.0 * a * h);
}

int nck_brake_rests(const nck_profile_t *state, double j) {
    const double a = state->a_last;
    return a < 0.0 && state->v_last * state->v_last * 4.0 * j * j <= a * a * a * a;
}

// ---- what is left at a lower speed

// The smaller cap of a piece and of the node at its start; a rest at the node is none.
static double cap_of(const nck_jerk_t *self, const nck_node_t *piece) {
    const double inside = self->work.over ? piece->vv_over : piece->vv_piece;
    const double node = self->work.over ? piece->vv_node : piece->vv_cap;
    return node > 0.0 ? nck_min(inside, node) : inside;
}

// The smallest cap within a distance on one side; 0 if it is not known so far.
static double least_cap(const nck_jerk_t *self, const nck_pieces_t *pieces, uint32_t number,
                        double distance, int step) {
    double least = UNCAPPED;
    double left = distance;
    for (int n = 0; n < MIXED_MOST; n++) {
        const nck_node_t *const piece = nck_plan_piece(pieces, number);
        if (!piece) return 0.0;
        if (!(piece->length > 0.0)) return least; // at a rest nothing is mixed
        least = nck_min(least, cap_of(self, piece));
        if (n > 0) left -= piece->length;
        if (!(left > 0.0)) return least;
        number += (uint32_t)step;
    }
    return 0.0;
}

// An axis' limits at standstill, the smallest of all.
static nck_brake_limits_t at_rest(const nck_machine_t *machine) {
    nck_brake_limits_t limits = {machine->path.a_max, machine->path.j_max};
    for (int x = 0; x < NCK_AXIS_MAX; x++) {
        if (!machine->axis[x].present) continue;
        limits.a = nck_min(limits.a, machine->axis[x].a_max);
        limits.j = nck_min(limits.j, machine->axis[x].j_max);
    }
    return limits;
}

// The least quotient of an axis' jerk and acceleration [1/s].
static double least_quotient(const nck_machine_t *machine) {
    double least = UNCAPPED;
    for (int x = 0; x < NCK_AXIS_MAX; x++) {
        const nck_axis_t *const axis = &machine->axis[x];
        if (axis->present) least = nck_min(least, axis->j_max / axis->a_max);
    }
    return least;
}

// With r = v/v_c, a_c and j_c what is left at the cap, and no more known of the bends than the cap:
//   A − |p″|v²  and  a corner's share  ≥  what lies between standstill and the cap, linear in r;
//   3|p″|v·a ≤ (J − |p‴|v³)/2  by  q/(6v),  q = (J − |p‴|v³)/|p″| ≥ q₀ + (6v_c·a_c − q₀)·r³,
//   q₀ = J·v_c²/(0.95 A), since |p″|·v_c² ≤ 0.95 A;
//   and half of the jerk, linear in r, is left to the path.
void nck_brake_relax(const nck_jerk_t *self, const nck_pieces_t *pieces, uint32_t number, double v,
                     nck_brake_limits_t *limits) {
    const nck_machine_t *const machine = self->machine;
    const double mixed = v * (double)NCK_FILTER_TAPS * machine->period_s;
    const double w = nck_min(least_cap(self, pieces, number, mixed, 1),
                             least_cap(self, pieces, number, mixed, -1));
    const double r = v / nck_sqrt(nck_max(w, 1e-12));
    if (!(r < 1.0) || !(v > 0.0)) return;
    const nck_brake_limits_t rest = at_rest(machine);
    const double q_cap = 6.0 * nck_sqrt(w) * limits->a;
    const double q_rest = nck_max(q_cap, least_quotient(machine) * w / CURVE_SHARE);
    const double ramp = (q_rest + (q_cap - q_rest) * r * r * r) / (6.0 * v);
    const double a = nck_min(rest.a + (limits->a - rest.a) * r, ramp);
    const double j_rest = rest.j * self->j_scale;
    limits->a = nck_max(limits->a, a);
    limits->j = nck_max(limits->j, RAMP_SHARE * (j_rest + (limits->j - j_rest) * r));
}

// ---- reach

// A cell of the plan of now under the brake; a long one in parts. Returns 1 when the rest is found.
static int reach_cell(nck_jerk_t *self, const nck_pieces_t *pieces, const nck_cell_t *cell) {
    nck_profile_t *const state = &self->profile;
    const uint32_t parts = (uint32_t)nck_window_parts(self, cell, 1);
    const double h = cell->length / (double)parts;
    nck_cell_t part = *cell;
    part.s += h * (double)self->work.part;
    self->work.piece = nck_plan_find(pieces, self->work.piece, &part);
    const nck_node_t *const piece = nck_plan_piece(pieces, self->work.piece);
    const double v = nck_min(cell->v, NCK_BRAKE_ABOVE * state->v_last);
    nck_brake_limits_t limits = {self->work.over ? piece->a_over : piece->a,
                                 self->j_scale * (self->work.over ? piece->j_over : piece->j)};
    if (!self->work.as_capped) nck_brake_relax(self, pieces, self->work.piece, v, &limits);
    const double j = NCK_BRAKE_SHARE * limits.j;
    const double least = self->work.reach > 0.0 ? nck_min(j, self->work.j_cell) : j;
    state->v_last = nck_sqrt(nck_brake_cell(state, h, limits.a, least, self->q_cap));
    self->work.j_cell = j;
    self->work.reach += h;
    self->work.part++;
    if (self->work.part == parts) {
        self->work.part = 0;
        self->work.i++;
    }
    if (!nck_brake_rests(state, j)) return 0;
    const double ramp = -state->a_last / j;
    self->work.reach += ramp * state->v_last / 3.0 + self->q_cap * self->profile.v;
    return 1;
}

nck_status_t nck_brake_reach(nck_jerk_t *self, const nck_pieces_t *pieces) {
    if (self->work.i == 0 && self->work.part == 0) nck_brake_begin(&self->profile, self->q_cap);
    for (int n = 0; n < NCK_JERK_STEP; n++) {
        const nck_cell_t *const cell =
            nck_link_tail_cell(self->link, self->work.source + self->work.i);
        if (!cell) return NCK_EMPTY;
        if (reach_cell(self, pieces, cell)) return NCK_DONE;
    }
    return NCK_OK;
}
