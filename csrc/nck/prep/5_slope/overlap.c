// SPDX-License-Identifier: MIT
// Inside room 5: stops that overlap with the starts behind them.
#include "nck/prep/5_slope/overlap.h"

#include "nck/base/cell_math.h"    // nck_cell_way nck_cell_speed
#include "nck/base/overlap_math.h" // nck_overlap_…
#include "nck/base/path.h"         // nck_path_tangent nck_path_second
#include "nck/prep/5_slope/jerk.h" // nck_jerk_cell_s
#include "nck/prep/5_slope/ladder_math.h" // NCK_LADDER_STRETCH

enum { HALVINGS = 32 }; // of a cell's duration, for a time in it
// They last so many times what the end takes that is left at the distance in question.
#define WITHHELD_TIMES 2.5
// Along a spline either goes no more than so many times the distance: under one jerk the other is
// at rest then; and some for the steps of a plan.
#define REACH 9.0
// Shorter overlaps are none, in periods.
#define LEAST_PERIODS 1.0
// Sums of jerk may pass an axis' limit by rounding.
#define JERK_EPSILON 1e-9
// Speeds in sum, likewise.
#define SPEED_EPSILON 1e-9
// How often an overlap is made shorter for its speed, and by what share of a period more.
enum { SHORTENINGS = 6 };
#define SHORTER 0.02
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

// A distance next to a rest as time: over cells, one by one away from it.
typedef struct way_beside {
    double left;  // of the distance [path mm]
    double time;  // [s]
    double a;     // the largest acceleration so far, without its sign [path mm/s²]
    uint32_t cells;
} way_beside_t;

static double accel_at(const nck_cell_t *cell, double t) { return cell->a + cell->j * t; }

static double accel_behind(const nck_cell_t *cell) { return accel_at(cell, cell->duration); }

// When a cell has come so far from its begin: halved and halved, for it never turns back.
static double time_at(const nck_cell_t *cell, double way) {
    double low = 0.0;
    double high = cell->duration;
    for (int k = 0; k < HALVINGS; k++) {
        const double middle = 0.5 * (low + high);
        if (nck_cell_way(cell, middle) < way) low = middle;
        else high = middle;
    }
    return high;
}

// One cell further away from the rest, which lies behind it or before it.
static void extend(way_beside_t *stretch, const nck_cell_t *cell, int rests_behind) {
    const double left = stretch->left;
    stretch->cells++;
    if (!(left > 0.0)) return;
    stretch->left = nck_max(0.0, left - cell->length);
    stretch->a = nck_max(nck_fabs(cell->a), nck_fabs(accel_behind(cell)));
    if (stretch->left > 0.0) stretch->time += cell->duration;
    else if (rests_behind) stretch->time += cell->duration - time_at(cell, cell->length - left);
    else stretch->time += time_at(cell, left);
}

uint32_t nck_overlap_withheld(const nck_link_t *link, const nck_pieces_t *pieces,
                              const nck_plan_t *next) {
    way_beside_t stretch = {distance_of(link, pieces, next), 0.0, 0.0, 0};
    double time = 0.0;
    uint32_t count = 0;
    if (!NCK_HAS_OVERLAP || !(stretch.left > 0.0)) return 0;
    const uint32_t seg = nck_link_built_cell(link, next->n - 1)->seg;
    const uint32_t least = next->beside > 0 ? next->beside : 1;
    while (count < NCK_OVERLAP_CELLS && count + least < next->n) {
        const nck_cell_t *const cell = nck_link_built_cell(link, next->n - 1 - count);
        const int is_far = !(stretch.left > 0.0) && time > WITHHELD_TIMES * stretch.time;
        if (is_far || cell->seg != seg) break;
        extend(&stretch, cell, 1);
        time += cell->duration;
        count++;
    }
    return count;
}

// What two plans have next to a corner.
typedef struct beside {
    double distance; // that either may have to it at the same time [path mm]
    double time[2];  // how long they may overlap, by their cells [s]
    const nck_node_t *piece[2]; // beside it
    double furthest[2];         // how far either may be from it, along its seg [path mm]
    double j[2];     // limits of jerk there [path mm/s³]
    double v_most;   // of either, and of both in sum: no feed is exceeded
    double period;   // [s]
    int shares;      // 1: an axis moves in both
    int ordered;     // 1: only the order in time keeps their jerks to an axis' limit in sum
} beside_t;

// Whether acceleration does anything but grow in time in a cell, from that of the one before on.
static int falls(const beside_t *corner, int n, double before, const nck_cell_t *cell) {
    const double least = -TURN_EPSILON * corner->j[n] * corner->period;
    return nck_min(cell->a - before, accel_behind(cell) - cell->a) < least;
}

// Whether a cell of the end of the plan of now may ride, before one that begins with this
// acceleration: it slows down. Where an axis moves in both, it is in the piece beside the corner,
// which leaves some jerk, and if their order in time matters its acceleration only grows.
static int may_ride(const beside_t *corner, const nck_cell_t *cell, double behind) {
    if (!(cell->a < 0.0) || cell->span != 0 || cell->v > corner->v_most) return 0;
    if (cell->s < corner->furthest[0]) return 0;
    if (corner->shares && cell->s < corner->piece[0]->s) return 0;
    if (!corner->ordered) return 1;
    const double grows = behind - accel_behind(cell);
    const double least = -TURN_EPSILON * corner->j[0] * corner->period;
    return grows >= least && !falls(corner, 0, cell->a, cell);
}

// Half of the last cell is left out: its jump at the other end may go the other way (rule R).
static way_beside_t look_back(const nck_link_t *link, const nck_plan_t *now, beside_t *corner) {
    way_beside_t stretch = {corner->distance, 0.0, 0.0, 0};
    double behind = 0.0; // acceleration
    double last = 0.0;   // of the cells' durations
    corner->time[0] = 0.0;
    for (uint32_t i = 0; i < now->withheld; i++) {
        const nck_cell_t *const cell = cell_at(link, now, now->n - 1 - i);
        if (!may_ride(corner, cell, behind)) break;
        extend(&stretch, cell, 1);
        corner->time[0] += cell->duration;
        last = cell->duration;
        behind = cell->a;
    }
    if (corner->ordered) corner->time[0] -= 0.5 * last;
    return stretch;
}

// The same of a cell of the next plan, behind one that ends with this acceleration: it speeds up.
static int may_begin(const beside_t *corner, const nck_cell_t *cell, double before) {
    const nck_node_t *const piece = corner->piece[1];
    if (!(accel_behind(cell) > 0.0) || cell->seg != piece->seg || cell->span != 0) return 0;
    const double end = cell->s + cell->length;
    const double v = nck_cell_speed(cell, cell->duration);
    if (v > corner->v_most || end > corner->furthest[1]) return 0;
    if (corner->shares && end > piece->s + piece->length) return 0;
    return !corner->ordered || !falls(corner, 1, before, cell);
}

// It goes on for some time until another plan may take over.
static way_beside_t look_ahead(const nck_link_t *link, const nck_plan_t *next, beside_t *corner) {
    way_beside_t stretch = {corner->distance, 0.0, 0.0, 0};
    const uint32_t most = next->complete ? next->n : next->commit;
    const double filter = (double)NCK_FILTER_TAPS * corner->period;
    double before = 0.0; // acceleration
    double time = 0.0;
    int goes_on = 1;
    for (uint32_t i = 0; i < most; i++) {
        const nck_cell_t *const cell = nck_link_built_cell(link, i);
        goes_on = goes_on && may_begin(corner, cell, before);
        time += cell->duration;
        if (goes_on) {
            extend(&stretch, cell, 0);
            corner->time[1] = time - (corner->ordered ? 0.5 * cell->duration : 0.0);
        }
        if (time > nck_min(corner->time[0], corner->time[1]) + filter) break;
        before = accel_behind(cell);
    }
    corner->time[1] = nck_min(corner->time[1], time - filter);
    return stretch;
}

// How long the same cells take for another distance.
static double time_again(const nck_link_t *link, const nck_plan_t *now, double distance,
                         const way_beside_t *known, int rests_behind) {
    way_beside_t stretch = {distance, 0.0, 0.0, 0};
    while (stretch.left > 0.0 && stretch.cells < known->cells) {
        const uint32_t i = stretch.cells;
        extend(&stretch, rests_behind ? cell_at(link, now, now->n - 1 - i)
                                      : nck_link_built_cell(link, i), rests_behind);
    }
    return stretch.time;
}

// The output filter puts a sample behind the mean place, by half of its variance in time for an
// acceleration:    a·T²(n² − 1)/24
static double filter_sag(double a, double n, double period) {
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

// The cell of the plan of now in which so much time is left to its rest, and the time in it.
static double place_of(const nck_link_t *link, const nck_plan_t *now, double left,
                       uint32_t *at_out) {
    double t = left;
    uint32_t at = now->n;
    while (at > 0 && t > 0.0) t -= cell_at(link, now, --at)->duration;
    *at_out = at;
    return nck_max(0.0, -t);
}

// What both speeds come to in sum at most: the first only falls, the second only grows.
static double speed_bound(const nck_link_t *link, const nck_plan_t *now, const nck_plan_t *next,
                          double time) {
    uint32_t at = 0;
    uint32_t k = 0;
    const double t = place_of(link, now, time, &at);
    const double first = at < now->n ? nck_cell_speed(cell_at(link, now, at), t) : 0.0;
    double left = time;
    for (; k + 1 < next->n && left > nck_link_built_cell(link, k)->duration; k++) {
        left -= nck_link_built_cell(link, k)->duration;
    }
    return first + nck_cell_speed(nck_link_built_cell(link, k), left);
}

// Both speeds at some time, and what the second gains [path mm/s, path mm/s²].
typedef struct together {
    double v, a;
} together_t;

// The largest sum of both speeds from here on, within a time in which neither cell ends.
static together_t fastest_within(const nck_cell_t *const cell[2], const double t[2], double time) {
    const double a = accel_at(cell[0], t[0]) + accel_at(cell[1], t[1]);
    const double j = cell[0]->j + cell[1]->j;
    const double v = nck_cell_speed(cell[0], t[0]) + nck_cell_speed(cell[1], t[1]);
    together_t most = {v, accel_at(cell[1], t[1])};
    if (a > 0.0 && a < -j * time) most.v -= 0.5 * a * a / j;
    return most;
}

// The same in all the time for which they overlap. Cost: linear in their cells.
static together_t fastest(const nck_link_t *link, const nck_plan_t *now, const nck_plan_t *next,
                          double time) {
    together_t most = {0.0, 0.0};
    double t[2] = {0.0, 0.0};
    uint32_t at[2] = {0, 0};
    t[0] = place_of(link, now, time, &at[0]);
    while (at[0] < now->n && at[1] < next->n) {
        const nck_cell_t *cell[2];
        cell[0] = cell_at(link, now, at[0]);
        cell[1] = nck_link_built_cell(link, at[1]);
        const double step = nck_min(cell[0]->duration - t[0], cell[1]->duration - t[1]);
        const together_t here = fastest_within(cell, t, step);
        if (here.v > most.v) most = here;
        for (int n = 0; n < 2; n++) {
            t[n] += step;
            if (t[n] < cell[n]->duration) continue;
            t[n] = 0.0;
            at[n]++;
        }
    }
    return most;
}

// Steps of two plans are not each other's mirror image: they overlap less where they would pass
// the speed in sum. Returns the time for which they do not, 0 if that is not found.
static double time_within_speed(const nck_link_t *link, const nck_plan_t *now,
                                const nck_plan_t *next, const beside_t *corner, double time) {
    if (speed_bound(link, now, next, time) <= corner->v_most) return time;
    for (int k = 0; k < SHORTENINGS; k++) {
        const together_t most = fastest(link, now, next, time);
        const double over = most.v - corner->v_most * (1.0 + SPEED_EPSILON);
        if (!(over > 0.0)) return time;
        if (!(most.a > 0.0)) return 0.0;
        time -= over / most.a + SHORTER * corner->period;
    }
    return 0.0;
}

// How long both may overlap.
static double time_of(const nck_link_t *link, const nck_plan_t *now, const nck_plan_t *next,
                      beside_t *corner) {
    const way_beside_t end = look_back(link, now, corner);
    const way_beside_t begin = look_ahead(link, next, corner);
    const double most = nck_min(corner->time[0], corner->time[1]);
    const double j = nck_max(corner->j[0], corner->j[1]);
    const double a = nck_max(end.a, begin.a) + corner->period * j;
    corner->distance -= filter_sag(a, (double)NCK_FILTER_TAPS, corner->period);
    if (!(corner->distance > 0.0)) return 0.0;
    const double time = time_again(link, now, corner->distance, &end, 1)
                        + time_again(link, now, corner->distance, &begin, 0);
    return time_within_speed(link, now, next, corner, nck_min(most, time));
}

// How much a spline's tangent turns within the distance at one of its ends: no more than p″, which
// is linear, at either end of that.
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

// How far a motion is straight enough: up to its furthest, along its seg. Returns whether it is.
static int are_straight(const nck_seg_t *in, const nck_seg_t *out, double furthest_out[2]) {
    const double reach = REACH * in->overlap;
    furthest_out[0] = in->kind == NCK_SEG_LINE ? 0.0 : nck_max(0.0, in->length - reach);
    furthest_out[1] = out->kind == NCK_SEG_LINE ? out->length : nck_min(out->length, reach);
    return in->kind != NCK_SEG_ARC && out->kind != NCK_SEG_ARC && out->kind < NCK_SEG_DWELL
           && turn_near(in, in->length, furthest_out[0]) <= NCK_OVERLAP_TURN
           && turn_near(out, 0.0, furthest_out[1]) <= NCK_OVERLAP_TURN;
}

// By how much cells of constant acceleration, which stays for their time, may pass t·j sooner [s].
static double slack_of(const nck_machine_t *machine) {
    return NCK_LADDER_STRETCH * nck_jerk_cell_s(machine);
}

// The motions on both sides of a corner; 0 if they are none that overlap.
static int find_motions(const nck_machine_t *machine, const nck_seg_t *seg[2],
                        const nck_node_t *piece[2], double tangent[2][NCK_AXIS_MAX],
                        nck_overlap_t *motions) {
    nck_path_tangent(seg[0], seg[0]->length, tangent[0]);
    nck_path_tangent(seg[1], 0.0, tangent[1]);
    motions->in = tangent[0];
    motions->out = tangent[1];
    for (int n = 0; n < 2; n++) {
        motions->j[n] = piece[n]->j;
        motions->turn[n] = nck_overlap_turn(seg[n]->kind);
    }
    return nck_overlap_jerk(machine, NCK_AXIS_MAX, motions) <= 1.0 + JERK_EPSILON;
}

// As nck_overlap_join, between two pieces.
static double join(const nck_machine_t *machine, const nck_link_t *link,
                   const nck_node_t *piece[2], const nck_wish_t *wish, const nck_plan_t *now,
                   const nck_plan_t *next) {
    const nck_seg_t *seg[2];
    double tangent[2][NCK_AXIS_MAX];
    nck_overlap_t motions;
    beside_t corner;
    seg[0] = nck_link_seg(link, piece[0]->seg);
    seg[1] = nck_link_seg(link, piece[1]->seg);
    if (!are_straight(seg[0], seg[1], corner.furthest)) return 0.0;
    if (!find_motions(machine, seg, piece, tangent, &motions)) return 0.0;
    const double vv = nck_min(nck_plan_cap(piece[0], wish, next->over),
                              nck_plan_cap(piece[1], wish, next->over));
    corner.distance = seg[0]->overlap;
    for (int n = 0; n < 2; n++) {
        corner.piece[n] = piece[n];
        corner.j[n] = piece[n]->j;
        corner.time[n] = 0.0;
    }
    corner.v_most = nck_sqrt(vv);
    corner.period = machine->period_s;
    corner.shares = nck_overlap_shares(machine, NCK_AXIS_MAX, &motions);
    // At a low speed a spline has more jerk than its piece tells (docs/stops.md, "Hold").
    const int are_lines = seg[0]->kind == NCK_SEG_LINE && seg[1]->kind == NCK_SEG_LINE;
    const double sum = nck_overlap_sum(machine, NCK_AXIS_MAX, &motions);
    corner.ordered = !are_lines || sum > 1.0 + JERK_EPSILON;
    const double most = nck_overlap_most(machine, NCK_AXIS_MAX, &motions) - slack_of(machine);
    return nck_min(most, time_of(link, now, next, &corner));
}

double nck_overlap_join(const nck_machine_t *machine, const nck_link_t *link,
                        const nck_pieces_t *pieces, const nck_wish_t *wish, nck_plan_t *now,
                        nck_plan_t *next) {
    const nck_node_t *piece[2];
    piece[0] = piece_before_rest(pieces, now);
    piece[1] = nck_plan_piece(pieces, next->piece);
    const int are_known = piece[0] && piece[1] && !next->held;
    const double time = are_known ? join(machine, link, piece, wish, now, next) : 0.0;
    if (!(time >= LEAST_PERIODS * machine->period_s)) {
        now->withheld = 0;
        return 0.0;
    }
    const double filter = (double)NCK_FILTER_TAPS * machine->period_s;
    next->beside = cells_beside(link, next, time + filter);
    return time;
}
