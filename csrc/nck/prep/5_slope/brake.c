// SPDX-License-Identifier: MIT
// Inside room 5: how a hold brakes.
#include "nck/prep/5_slope/brake.h"

#include <string.h> // memcpy

#include "nck/base/budget.h"              // NCK_UNLIMITED
#include "nck/base/real.h"                // nck_min nck_max nck_sqrt
#include "nck/prep/5_slope/hull_math.h"   // nck_hull_share
#include "nck/prep/5_slope/window.h"      // nck_window_…

// Pieces on either side that are looked at, at most; what the filter mixes beyond them relaxes
// nothing.
enum { MIXED_MOST = 64 };
// To ask for a place is so much more work than a piece.
enum { ASK_WORK = 8 };
// Room for rounding in the sum of their lengths [mm].
#define ROUNDING 1e-9

// Share of the jerk that |p‴|v³ leaves which 3|p″|v·a may use; the rest is for p′·j.
#define RAMP_SHARE 0.5
// A cap is met within this share of the speed.
#define MET_EPSILON 1e-6
// The plan above a brake is at most so many times as fast.
#define PLAN_ABOVE 1.1

void nck_brake_begin(nck_profile_t *state, double q_cap) {
    state->v_last = state->v;
    state->a_last = state->a;
    state->share = 0.5 * nck_min(state->q, q_cap);
}

double nck_brake_cell(nck_profile_t *state, double h, double a_max, double j, double q_cap) {
    const double v = state->v_last;
    const double share = nck_hull_share(h, 2.0 * v, 0.5 * q_cap);
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

// Whether nothing is mixed beyond a piece: the path, or the plan, rests there.
static int ends_at(const nck_jerk_t *self, const nck_node_t *piece, uint32_t number, int step) {
    const uint32_t end = self->next->end_piece;
    const int begins = self->job.kind == NCK_JOB_START && number == self->next->piece;
    if (step < 0) return begins;
    return piece->stop || number == end
           || (number + 1 == end && self->next->end_s == NCK_PLAN_BEGIN);
}

// Whether the tick has passed a piece of the plan of now makes no difference, and older ones count
// as unknown, whether or not they are still there. But a hold comes at a time, so it may ask.
static int is_first_known(const nck_jerk_t *self, uint32_t number) {
    return self->job.kind != NCK_JOB_BRAKE && number == self->now->first_piece;
}

// nck_node_t.q_rest: the upper half of a float's bits.
static double quotient_of(const nck_node_t *piece) {
    const uint32_t bits = (uint32_t)piece->q_rest << 16;
    float quotient;
    memcpy(&quotient, &bits, sizeof quotient);
    return (double)quotient;
}

static void mix(nck_brake_mixed_t *mixed, const nck_node_t *piece) {
    mixed->work++;
    mixed->a_rest = nck_min(mixed->a_rest, (double)piece->standstill.left.a);
    mixed->j_rest = nck_min(mixed->j_rest, (double)piece->standstill.left.j);
    mixed->q_rest = nck_min(mixed->q_rest, quotient_of(piece));
}

// What is found holds for distances between these two.
static void narrow(nck_brake_mixed_t *mixed, double least, double most) {
    mixed->least = nck_max(mixed->least, least + ROUNDING);
    mixed->most = nck_min(mixed->most, most - ROUNDING);
}

// Whether the path rests before a piece; first: it is the one that is asked for.
static int rests_before(const nck_node_t *piece, int step, int first) {
    return !(piece->length > 0.0) || (step < 0 && !first && piece->stop);
}

// The smallest cap within a distance on one side; 0 if it is not known so far.
static double least_cap(const nck_jerk_t *self, const nck_pieces_t *pieces, double distance,
                        int step, nck_brake_mixed_t *mixed) {
    double least = NCK_WINDOW_UNCAPPED;
    double left = distance;
    uint32_t number = mixed->number;
    const nck_node_t *piece = nck_plan_piece(pieces, number);
    for (int n = 0; piece && n < MIXED_MOST; n++) {
        const double before = left;
        const int is_rest = rests_before(piece, step, n == 0);
        if (!is_rest) {
            least = nck_min(least, nck_plan_limits_at(piece, self->work.over));
            mix(mixed, piece);
            if (n > 0) left -= piece->length;
        }
        if (!(left > 0.0)) {
            narrow(mixed, distance - before, distance - left);
            return least;
        }
        if (is_rest || ends_at(self, piece, number, step)) {
            narrow(mixed, distance - left, NCK_UNLIMITED);
            return least;
        }
        if (step < 0 && is_first_known(self, number)) break;
        number += (uint32_t)step;
        piece = nck_plan_piece(pieces, number);
    }
    narrow(mixed, distance - left, NCK_UNLIMITED);
    return 0.0;
}

// What is mixed around a piece at speed v. Returns r = v/v_c, 1 and more where nothing is known;
// v_c², the smallest cap, is mixed->vv.
static double mix_around(const nck_jerk_t *self, const nck_pieces_t *pieces, uint32_t number,
                         double v, nck_brake_mixed_t *mixed) {
    const double length = v * (double)NCK_FILTER_TAPS * self->machine->period_s;
    const int same = mixed->number == number && length > mixed->least && length < mixed->most;
    mixed->work += ASK_WORK;
    if (!same) {
        const nck_brake_mixed_t anew = {number, mixed->work, 0.0, NCK_UNLIMITED, 0.0,
                                        NCK_UNLIMITED, NCK_UNLIMITED, NCK_UNLIMITED};
        *mixed = anew;
        const double ahead = least_cap(self, pieces, length, 1, mixed);
        mixed->vv = nck_min(ahead, least_cap(self, pieces, length, -1, mixed));
    }
    return v / nck_sqrt(nck_max(mixed->vv, 1e-12));
}

// What lies between standstill and the cap, linear in r.
static double linear_of(double a, const nck_brake_mixed_t *mixed, double r) {
    return mixed->a_rest + (a - mixed->a_rest) * r;
}

// With r = v/v_c, a_c and j_c what is left at the cap:
//   (A − |p″|v²)/|p′|  and  a corner's share  ≥  what lies between standstill and the cap, linear
//   in r;
//   3|p″|v·a ≤ (J − |p‴|v³)/2  by  q/(6v),  q = (J − |p‴|v³)/|p″| ≥ q₀ + (6v_c·a_c − q₀)·r³,
//   q₀ = J/|p″|.
// a: a_c [path mm/s²].
static double accel_left(double a, const nck_brake_mixed_t *mixed, double v, double r) {
    const double q_cap = 6.0 * nck_sqrt(mixed->vv) * a;
    const double q_rest = nck_max(q_cap, mixed->q_rest);
    const double ramp = (q_rest + (q_cap - q_rest) * r * r * r) / (6.0 * v);
    return nck_max(a, nck_min(linear_of(a, mixed, r), ramp));
}

// The jerk that goes with it. What an axis asks for is linear in v³, va and j: so what is left at
// the cap by r³, and half of what is left at standstill by the rest, hold together with it.
// at_cap: the former.
static double jerk_left(const nck_jerk_t *self, double j, double at_cap,
                        const nck_brake_mixed_t *mixed, double r) {
    const double rrr = r * r * r;
    const double j_rest = nck_max(j, mixed->j_rest * self->j_scale);
    return RAMP_SHARE * j_rest * (1.0 - rrr) + at_cap * rrr;
}

// A piece that leaves more jerk at its cap keeps that (docs/stops.md, "Known not to hold").
void nck_brake_relax(const nck_jerk_t *self, const nck_pieces_t *pieces, uint32_t number, double v,
                     nck_brake_mixed_t *mixed, nck_brake_limits_t *limits) {
    const double r = mix_around(self, pieces, number, v, mixed);
    if (!(r < 1.0) || !(v > 0.0)) return;
    limits->a = accel_left(limits->a, mixed, v, r);
    limits->j = nck_max(limits->j, jerk_left(self, limits->j, limits->j, mixed, r));
}

// ---- reach

// A cell of the plan of now under the brake; a long one in parts. Returns 1 when the rest is found.
static int reach_cell(nck_jerk_t *self, const nck_pieces_t *pieces, const nck_cell_t *cell,
                      nck_brake_mixed_t *mixed) {
    nck_profile_t *const state = &self->profile;
    const uint32_t parts = (uint32_t)nck_window_parts(self, cell, 1);
    const double h = cell->length / (double)parts;
    nck_cell_t part = *cell;
    part.s += h * (double)self->work.part;
    self->work.piece = nck_plan_find(pieces, self->work.piece, &part);
    const nck_node_t *const piece = nck_plan_piece(pieces, self->work.piece);
    const double v = nck_min(cell->v, PLAN_ABOVE * state->v_last);
    nck_brake_limits_t limits = {self->work.over ? piece->a_over : piece->a,
                                 self->j_scale * (self->work.over ? piece->j_over : piece->j)};
    nck_brake_relax(self, pieces, self->work.piece, v, mixed, &limits);
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
    nck_brake_mixed_t mixed = {0};
    if (self->work.i == 0 && self->work.part == 0) nck_brake_begin(&self->profile, self->q_cap);
    for (int n = 0; n < NCK_JERK_STEP; n++) {
        const nck_cell_t *const cell =
            nck_link_tail_cell(self->link, self->work.source + self->work.i);
        if (!cell) return NCK_EMPTY;
        if (reach_cell(self, pieces, cell, &mixed)) return NCK_DONE;
    }
    return NCK_OK;
}

// ---- along a ladder

// The smaller jerk limit of a cell and of the one before: rule R.
static double j_of_both(const nck_jerk_t *self, uint32_t i) {
    const uint32_t before = i > 0 ? i - 1 : i;
    return nck_min(self->j_max[before], self->j_max[i]);
}

void nck_brake_along(nck_jerk_t *self, const nck_pieces_t *pieces, uint32_t i, double tried,
                     nck_brake_mixed_t *mixed) {
    nck_profile_t *const state = &self->profile;
    const double q_cap = nck_window_q_cap(self);
    if (i == 0) nck_brake_begin(state, q_cap);
    const double above = nck_min(nck_sqrt(self->vv_cap[i]), PLAN_ABOVE * state->v_last);
    const double v = nck_max(above, tried);
    if (state->v_last > 0.0) self->vv_cap[i] = v * v;
    nck_brake_limits_t limits = {self->a_max[i], self->j_max[i]};
    nck_brake_relax(self, pieces, self->rung_piece[i], v, mixed, &limits);
    self->a_max[i] = limits.a;
    self->j_max[i] = limits.j;
    if (nck_brake_rests(state, NCK_BRAKE_SHARE * limits.j)) return; // what is left rounds the end
    const double j = j_of_both(self, i);
    state->v_last = nck_sqrt(nck_brake_cell(state, self->h[i], limits.a, j, q_cap));
}

// ---- raise

// The deceleration must be gone when the cap is met. By rule R it gives way along a line through
// the middles of the cells, whatever their durations; the mean of a cell is its middle's, so from a
// cell's begin on it lowers the speed by B²/2J at most, B = |a| + Jq/2 the line's value there:
//     v − v_cap ≥ (|a| + Jq/2)²/2J.
// What a cell can do with no more than Jq/2 it does: the next one may be level, or rise. Near the
// cap the brake gives way, and vv becomes more. Where the cap of an override is met the brake goes
// on, so that what is below later caps raises none; a hold's caps are those of its brake.
static double land_cell(const nck_jerk_t *self, nck_profile_t *state, uint32_t i, double vv) {
    const double v = state->v_last;
    const double h = self->h[i];
    const double above = nck_max(0.0, v - nck_sqrt(self->vv_cap[i + 1]));
    if (!(self->work.reach > 0.0) && above <= MET_EPSILON * v) return vv;
    const double half = NCK_BRAKE_SHARE * j_of_both(self, i + 1) * state->share; // Jq/2
    const double at_once = above * v / h;
    const double line = nck_sqrt(4.0 * half * at_once) - half; // J = 2·half/q, q = h/v
    const double least = -(at_once <= half ? at_once : line);
    if (state->a_last >= least) return vv;
    state->a_last = least;
    return nck_max(0.0, v * v + 2.0 * least * h);
}

// Cells of the ladder over the path of the plan of now.
static uint32_t known_cells(const nck_jerk_t *self) {
    return self->work.anew ? self->work.n : self->work.loaded;
}

// Half of a cell's duration, about: at the speeds of the plan of now, or of the coarse one, or at
// the one that the plan begins with.
static double share_about(const nck_jerk_t *self, uint32_t i) {
    const double known = nck_sqrt(self->vv[i]) + nck_sqrt(self->vv[i + 1]);
    const double v_sum = self->work.anew ? 2.0 * self->profile.v : known;
    return nck_hull_share(self->h[i], v_sum, 0.5 * nck_window_q_cap(self));
}

nck_status_t nck_brake_ease(nck_jerk_t *self) {
    double *const most = nck_link_spare(self->link)->ladder.number[0];
    const uint32_t known = known_cells(self);
    for (int n = 0; n < NCK_JERK_STEP; n++) {
        if (self->work.i + 1 >= known) return NCK_DONE;
        const uint32_t i = known - 2 - self->work.i;
        if (self->work.i == 0) most[i + 1] = self->a_max[i + 1];
        const double shares = share_about(self, i) + share_about(self, i + 1);
        const double rise = NCK_BRAKE_SHARE * j_of_both(self, i + 1) * shares;
        most[i] = nck_min(self->a_max[i], most[i + 1] + rise);
        self->work.i++;
    }
    return NCK_OK;
}

// v² of the plan of now at the ladder's next node, both counted from where the ladder begins. On a
// ladder taken over from it, it came along. Returns −1 while the cell of the plan is still looked
// for.
static double planned(nck_jerk_t *self) {
    const uint32_t i = self->work.i;
    if (!self->work.from_built && i + 1 < self->work.loaded) return self->vv[i + 1];
    const nck_cell_t *const cell =
        nck_link_tail_cell(self->link, self->work.source + self->work.planned_cell);
    if (!cell) return 0.0;
    const double x = self->work.braked + self->h[i] - self->work.planned_at;
    if (x <= cell->length) return nck_max(0.0, cell->v * cell->v + 2.0 * cell->a * x);
    self->work.planned_at += cell->length;
    self->work.planned_cell++;
    return -1.0;
}

// Whether a brake may raise a cap: it stays below the speeds of the plan of now, so it does not
// where these came along and no cap is below one of them.
static int may_raise(const nck_jerk_t *self) {
    return self->work.anew || self->work.from_built || self->work.lowered;
}

// Where the brake leaves a cap that rises, its deceleration is not gone: caps are lowered to how it
// gives way, until what is left of it lets the next cell rise as it likes. Else a plan would slow
// down sooner, and not join. vv: of the brake where cell i ends.
static void turn_up(nck_jerk_t *self, uint32_t i, double vv) {
    nck_jerk_turn_t *const turn = &self->work.turn;
    const nck_profile_t *const state = &self->profile;
    const double h = self->h[i];
    const double j = NCK_BRAKE_SHARE * j_of_both(self, i);
    if (vv >= self->vv_cap[i + 1]) {
        *turn = (nck_jerk_turn_t){nck_sqrt(vv), state->a_last, state->share};
        return;
    }
    if (!(-turn->a > j * turn->share)) return;
    const double share = nck_hull_share(h, 2.0 * turn->v, 0.5 * nck_window_q_cap(self));
    turn->a += j * (turn->share + share);
    turn->share = share;
    const double vv_turn = turn->v * turn->v + 2.0 * turn->a * h;
    if (!(vv_turn > vv)) { // it comes to nothing, as the brake does
        turn->a = 0.0;
        return;
    }
    turn->v = nck_sqrt(vv_turn);
    self->vv_cap[i + 1] = nck_min(self->vv_cap[i + 1], vv_turn);
}

nck_status_t nck_brake_raise(nck_jerk_t *self) {
    nck_profile_t *const state = &self->profile;
    const double *const eased = nck_link_spare(self->link)->ladder.number[0];
    const double q_cap = nck_window_q_cap(self);
    if (self->work.i == 0) {
        nck_brake_begin(state, q_cap);
        self->work.turn.a = 0.0;
        if (state->v > 0.0) self->vv_cap[0] = nck_max(self->vv_cap[0], state->v * state->v);
        if (!may_raise(self)) return NCK_DONE;
    }
    for (int n = 0; n < NCK_JERK_STEP; n++) {
        const uint32_t i = self->work.i;
        if (i + 1 >= known_cells(self) || !(state->v_last > 0.0)) return NCK_DONE;
        const double vv_planned = planned(self);
        if (vv_planned < 0.0) continue;
        const double a_max = self->work.eases ? eased[i] : self->a_max[i];
        const double j = j_of_both(self, i);
        const double vv = nck_brake_cell(state, self->h[i], a_max, j, q_cap);
        const double landed = land_cell(self, state, i, vv);
        const double floor = nck_min(landed, vv_planned);
        if (floor < landed) { // the plan of now brakes harder
            state->a_last = 0.5 * (floor - state->v_last * state->v_last) / self->h[i];
        }
        turn_up(self, i, floor);
        self->vv_cap[i + 1] = nck_max(self->vv_cap[i + 1], floor);
        state->v_last = nck_sqrt(floor);
        self->work.braked += self->h[i];
        self->work.i++;
    }
    return NCK_OK;
}
