// SPDX-License-Identifier: MIT
// Inside room 5: stops that overlap with the starts behind them.
#include "nck/prep/5_slope/overlap.h"

#include "nck/base/overlap_math.h" // nck_overlap_…
#include "nck/base/path.h"         // nck_path_tangent

// Cells of a plan that are withheld, at most: the ring has room for others, too.
enum { WITHHELD_MOST = NCK_CELL_MAX / 2 };
// They last so many times what the end takes that is left at the distance in question.
#define WITHHELD_TIMES 2.5
// Under one jerk the other motion is at rest when one has so many times the distance to go, or has
// come so far; and some for the steps of a plan.
#define REACH 9.0
// Shorter overlaps are none, in periods.
#define LEAST_PERIODS 1.0

// Sums of jerk may pass an axis' limit by rounding.
#define JERK_EPSILON 1e-9
// A change of acceleration to the other side is rounding below this share of the jerk in a period.
#define TURN_EPSILON 1e-9

static const nck_cell_t *cell_at(const nck_link_t *link, const nck_plan_t *plan, uint32_t i) {
    return nck_link_tail_cell(link, (plan->begin + i) & NCK_LINK_COUNT_MASK);
}

// The piece that a plan comes to rest behind; NULL if that is no end of a piece.
static const nck_node_t *piece_before_rest(const nck_pieces_t *pieces, const nck_plan_t *plan) {
    const nck_node_t *const behind = nck_plan_piece(pieces, plan->end_piece);
    const int ends = plan->end_s == NCK_PLAN_BEGIN || (behind && plan->end_s == behind->s);
    return ends ? nck_plan_piece(pieces, plan->end_piece - 1) : (const nck_node_t *)0;
}

// How far the path may still have to go when the next motion has come as far; 0: to its rest.
static double distance_of(const nck_link_t *link, const nck_pieces_t *pieces,
                          const nck_plan_t *plan) {
    const nck_node_t *const piece = piece_before_rest(pieces, plan);
    if (!plan->complete || plan->held || !piece || !piece->stop || !piece->last) return 0.0;
    return nck_link_seg(link, piece->seg)->overlap;
}

// A distance next to a rest as time: over cells of constant acceleration, one by one away from it.
typedef struct stretch {
    double left;  // of the distance [path mm]
    double time;  // [s]
    double a;     // acceleration where it ends, without its sign [path mm/s²]
} stretch_t;

// One cell further away from the rest: v at its end next to it, gain: by how much v² grows a length,
// halved. r = v·t + gain·t²/2
static void extend(stretch_t *stretch, const nck_cell_t *cell, double v, double gain) {
    if (!(stretch->left > 0.0)) return;
    stretch->a = nck_fabs(gain);
    if (cell->length < stretch->left) {
        stretch->left -= cell->length;
        stretch->time += cell->duration;
        return;
    }
    const double r = stretch->left;
    const double end = nck_sqrt(nck_max(0.0, v * v + 2.0 * gain * r));
    stretch->time += v + end > 0.0 ? 2.0 * r / (v + end) : cell->duration;
    stretch->left = 0.0;
}

static double speed_behind(const nck_cell_t *cell) {
    return nck_max(0.0, cell->v + cell->a * cell->duration);
}

uint32_t nck_overlap_withheld(const nck_link_t *link, const nck_pieces_t *pieces,
                              const nck_plan_t *now) {
    stretch_t stretch = {distance_of(link, pieces, now), 0.0, 0.0};
    double time = 0.0;
    uint32_t count = 0;
    if (!(stretch.left > 0.0)) return 0;
    const uint32_t seg = cell_at(link, now, now->n - 1)->seg;
    while (count < WITHHELD_MOST && count + 1 < now->n) {
        const nck_cell_t *const cell = cell_at(link, now, now->n - 1 - count);
        const int is_far = !(stretch.left > 0.0) && time > WITHHELD_TIMES * stretch.time;
        if (is_far || cell->seg != seg) break;
        extend(&stretch, cell, speed_behind(cell), -cell->a);
        time += cell->duration;
        count++;
    }
    return count;
}

// What two plans have next to a corner.
typedef struct corner {
    double distance; // that either may have to it at the same time [path mm]
    double time[2];  // how long they may overlap, by their cells [s]
    const nck_node_t *piece[2]; // beside it
    double j[2];     // limits of jerk there [path mm/s³]
    int shares;      // 1: an axis moves in both
    int opposes;     // 1: opposite ways, or may
} corner_t;

// The end of the plan of now: as far from its rest as it slows down. Where an axis moves in both, as
// its acceleration only grows in time, and in the piece beside the corner, which leaves some jerk.
// Where it moves opposite ways what builds up pulls as the other motion does: the filter has to be
// behind that.
static stretch_t look_back(const nck_link_t *link, const nck_plan_t *now, double period,
                           corner_t *corner) {
    stretch_t stretch = {corner->distance, 0.0, 0.0};
    const double least = -TURN_EPSILON * corner->j[0] * period;
    double behind = 0.0; // acceleration
    corner->time[0] = 0.0;
    for (uint32_t i = 0; i <= now->withheld; i++) {
        const nck_cell_t *const cell = cell_at(link, now, now->n - 1 - i);
        const int builds_up = !(cell->a < 0.0) || behind - cell->a < least;
        if (corner->opposes && builds_up) corner->time[0] -= (double)NCK_FILTER_TAPS * period;
        if (!(cell->a < 0.0) || cell->span != 0 || i == now->withheld) break;
        if (corner->shares && (builds_up || cell->s < corner->piece[0]->s)) break;
        extend(&stretch, cell, speed_behind(cell), -cell->a);
        corner->time[0] += cell->duration;
        behind = cell->a;
    }
    return stretch;
}

// The begin of the next one, the same way, as long as it is straight. It goes on for some time until
// another plan may take over.
static stretch_t look_ahead(const nck_link_t *link, const nck_plan_t *next, double period,
                            corner_t *corner) {
    stretch_t stretch = {corner->distance, 0.0, 0.0};
    const double least = -TURN_EPSILON * corner->j[1] * period;
    const uint32_t most = next->complete ? next->n : next->commit;
    const uint32_t seg = nck_link_built_cell(link, 0)->seg;
    const double filter = (double)NCK_FILTER_TAPS * period;
    const double end = corner->piece[1]->s + corner->piece[1]->length;
    double before = 0.0;
    double time = 0.0;
    int goes_on = 1;
    for (uint32_t i = 0; i < most; i++) {
        const nck_cell_t *const cell = nck_link_built_cell(link, i);
        const int is_other = cell->a - before < least || cell->s + cell->length > end;
        goes_on = goes_on && cell->a > 0.0 && cell->seg == seg && cell->span == 0
                  && !(corner->shares && is_other);
        time += cell->duration;
        if (goes_on) {
            extend(&stretch, cell, cell->v, cell->a);
            corner->time[1] = time;
        }
        if (time > nck_min(corner->time[0], corner->time[1]) + filter) break;
        before = cell->a;
    }
    corner->time[1] = nck_min(corner->time[1], time - filter);
    return stretch;
}

// The output filter puts a sample behind the mean place, by half of its variance in time for an
// acceleration:    a·T²(n² − 1)/24
static double filter_sag(double a, double period) {
    const double n = (double)NCK_FILTER_TAPS;
    return a * period * period * (n * n - 1.0) / 24.0;
}

// So many cells of the next plan begin within that time, and the filter's behind it.
static uint32_t cells_beside(const nck_link_t *link, const nck_plan_t *next, double time) {
    uint32_t count = 0;
    for (double left = time; left > 0.0 && count < next->n; count++) {
        left -= nck_link_built_cell(link, count)->duration;
    }
    return count;
}

// How long both may overlap.
static double time_of(const nck_link_t *link, const nck_machine_t *machine, const nck_plan_t *now,
                      const nck_plan_t *next, corner_t *corner) {
    const double period = machine->period_s;
    const double distance = corner->distance;
    stretch_t end = look_back(link, now, period, corner);
    stretch_t begin = look_ahead(link, next, period, corner);
    const double most = nck_min(corner->time[0], corner->time[1]);
    const double a = nck_max(end.a, begin.a) + period * nck_max(corner->j[0], corner->j[1]);
    corner->distance = distance - filter_sag(a, period);
    if (!(corner->distance > 0.0)) return 0.0;
    end = look_back(link, now, period, corner);
    begin = look_ahead(link, next, period, corner);
    return nck_min(most, end.time + begin.time);
}

// How much a spline's tangent turns within the distance at one of its ends: no more than p″, which is
// linear, at either end of that.
static double turn_near(const nck_seg_t *seg, double end, double other) {
    double second[2][NCK_AXIS_MAX];
    double square[2] = {0.0, 0.0};
    if (seg->kind == NCK_SEG_LINE) return 0.0;
    nck_path_second(seg, end, second[0]);
    nck_path_second(seg, other, second[1]);
    for (int x = 0; x < NCK_AXIS_MAX; x++) {
        square[0] += second[0][x] * second[0][x];
        square[1] += second[1][x] * second[1][x];
    }
    return nck_sqrt(nck_max(square[0], square[1])) * nck_fabs(end - other);
}

// Both motions are straight enough, as far as they may reach: eight times the distance.
static int are_straight(const nck_seg_t *in, const nck_seg_t *out) {
    const double reach = REACH * in->overlap;
    return in->kind != NCK_SEG_ARC && out->kind != NCK_SEG_ARC && out->kind < NCK_SEG_DWELL
           && turn_near(in, in->length, nck_max(0.0, in->length - reach)) <= NCK_OVERLAP_TURN
           && turn_near(out, 0.0, nck_min(out->length, reach)) <= NCK_OVERLAP_TURN;
}

double nck_overlap_join(const nck_machine_t *machine, const nck_link_t *link, double step_s,
                        const nck_pieces_t *pieces, const nck_plan_t *now, nck_plan_t *next) {
    const nck_node_t *const before = piece_before_rest(pieces, now);
    const nck_node_t *const behind = nck_plan_piece(pieces, next->piece);
    if (!before || !behind || next->held) return 0.0;
    double in[NCK_AXIS_MAX];
    double out[NCK_AXIS_MAX];
    const nck_seg_t *const seg = nck_link_seg(link, before->seg);
    const nck_seg_t *const following = nck_link_seg(link, behind->seg);
    if (!are_straight(seg, following)) return 0.0;
    nck_path_tangent(seg, seg->length, in);
    nck_path_tangent(following, 0.0, out);
    const nck_overlap_t motions = {in, out, {before->j, behind->j},
                                   {nck_overlap_turn(seg->kind), nck_overlap_turn(following->kind)}};
    if (nck_overlap_jerk(machine, NCK_AXIS_MAX, &motions) > 1.0 + JERK_EPSILON) return 0.0;
    const double most = nck_overlap_most(machine, NCK_AXIS_MAX, &motions);
    corner_t corner = {seg->overlap, {0.0, 0.0}, {before, behind}, {before->j, behind->j},
                       nck_overlap_shares(machine, NCK_AXIS_MAX, &motions),
                       most < NCK_OVERLAP_FREE};
    const double time = nck_min(most - step_s, time_of(link, machine, now, next, &corner));
    if (!(time >= LEAST_PERIODS * machine->period_s)) return 0.0;
    next->beside = cells_beside(link, next, time + (double)NCK_FILTER_TAPS * machine->period_s);
    return time;
}
