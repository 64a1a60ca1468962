// SPDX-License-Identifier: MIT
// How much of the axes' limits a host leaves to a move.
#include "bounds.h"

#include <math.h> // fabs fmin sqrt

static const double rounding = 1e-6; // of a limit: what two ways to reckon it may differ by
static const double enough = 0.5;    // of what is asked, in place of a rest
static const double room = 0.7;

static int is_arc(const move_t *move) {
    return move->kind == MOVE_ARC || move->kind == MOVE_CHORDS;
}

// Of X Y Z if any moves, else of U V W, else of A B C: what a feed is told along.
static double length_of(const double *way) {
    static const int first[] = {NCK_AXIS_X, NCK_AXIS_U, NCK_AXIS_A};
    double sum = 0.0;
    for (int group = 0; group < 3 && sum == 0.0; group++) {
        for (int k = first[group]; k < first[group] + 3; k++) sum += way[k] * way[k];
    }
    return sqrt(sum);
}

double bounds_length(const move_t *move) {
    double way[MOVES_AXES];
    for (int k = 0; k < MOVES_AXES; k++) way[k] = move->end[k] - move->start[k];
    return length_of(way);
}

double bounds_along(const double *limit, const move_t *move) {
    const int round = is_arc(move);
    double way[MOVES_AXES];
    double least = HUGE_VAL;
    for (int k = 0; k < MOVES_AXES; k++) way[k] = fabs(move->end[k] - move->start[k]);
    const double length = round ? arc_length(&move->arc) : length_of(way);
    for (int k = 0; k < MOVES_AXES; k++) {
        if (!(limit[k] > 0.0)) continue;
        if (round && k <= NCK_AXIS_Z) least = fmin(least, limit[k]);
        else if (way[k] > 0.0) least = fmin(least, limit[k] * length / way[k]);
    }
    return least;
}

// Directions differ in their shares where the host asks for one acceleration in all of them: the
// last share stays if it is not much too small, and a smaller one leaves room for those to come.
static double share(double most, double own, double last) {
    const double found = most > 0.0 && most < own ? most / own : 1.0;
    const int serves = found < 1.0 && last < found && last > enough * found;
    if (serves || fabs(found - last) <= rounding * last) return last;
    return found < last && last < 1.0 ? room * found : found;
}

void bounds_share(bounds_t *bounds, const bounds_most_t *most, const move_t *move) {
    bounds->a_share = share(most->a, bounds_along(bounds->a, move), bounds->a_share);
    if (move->kind != MOVE_RAPID) return;
    bounds->v_share = share(most->v, bounds_along(bounds->v, move), bounds->v_share);
}

// Of what a move has along its path, an axis' part; 0: it does not move.
static double part_of(const move_t *move, int k) {
    const int round = is_arc(move);
    const double way = fabs(move->end[k] - move->start[k]);
    const double length = round ? arc_length(&move->arc) : bounds_length(move);
    return round && k <= NCK_AXIS_Z ? 1.0 : way / length;
}

void bounds_jerk(bounds_t *bounds, const bounds_most_t *most, const move_t *move) {
    const double along = bounds_along(bounds->j, move);
    if (!(most->j > 0.0) || fabs(most->j - along) <= rounding * most->j) return;
    for (int k = 0; k < MOVES_AXES; k++) {
        const double part = part_of(move, k);
        const double least = most->j * part;
        const int has = bounds->j[k] > 0.0;
        if (!(bounds->v[k] > 0.0) || !(part > 0.0)) continue;
        if (!has || (most->j > along && bounds->j[k] < least)) bounds->j[k] = least;
        else if (most->j < along) bounds->j[k] *= most->j / along;
    }
}

double bounds_cap(const bounds_t *bounds, const bounds_most_t *most, const move_t *move) {
    if (move->kind == MOVE_RAPID || !(most->v > 0.0)) return 0.0;
    if (is_arc(move)) return most->v;
    return most->v < bounds_along(bounds->v, move) * (1.0 - rounding) ? most->v : 0.0;
}

int bounds_same(const bounds_t *one, const bounds_t *other) {
    int same = one->a_path == other->a_path && one->a_share == other->a_share
               && one->v_share == other->v_share;
    for (int k = 0; k < MOVES_AXES; k++) {
        same = same && one->v[k] == other->v[k] && one->a[k] == other->a[k]
               && one->j[k] == other->j[k];
    }
    return same;
}
