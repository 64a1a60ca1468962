// SPDX-License-Identifier: MIT
// The ring of moves, and what of them the kernel takes.
#include "moves.h"

#include <math.h>   // fabs fmax fmin sqrt
#include <string.h> // memcpy memset

static const double chord_error = 1e-4;    // [mm] of arcs about other axes
static const double chord_tolerance = 2e-3;// [mm] of them where the path is to be exact
static const double arc_error = 5e-3;      // [mm] by which an arc's radii may differ
static const double upright = 1.0 - 1e-9;  // of an axis that is X, Y or Z

int moves_has_next(const moves_t *self) {
    if (!self->back) return self->next != self->head;
    const int kept = (int32_t)(self->next - self->tail) >= 0;
    return kept && moves_is_open(moves_at((moves_t *)self, self->next));
}

int moves_full(const moves_t *self) { return self->head - self->tail >= MOVES_MAX - MOVES_MARGIN; }

void moves_clear(moves_t *self) {
    self->next = self->head;
    self->tail = self->head;
    self->back = 0;
    self->part = self->anew = 0;
    self->from = 0.0;
    self->to = 1.0;
}

void moves_pass(moves_t *self, uint32_t count) {
    if ((int32_t)(count - MOVES_KEPT - self->tail) > 0) self->tail = count - MOVES_KEPT;
}

double moves_straight(move_t *move, const double *start, const double *end) {
    double sum = 0.0;
    memcpy(move->start, start, sizeof move->start);
    memcpy(move->end, end, sizeof move->end);
    for (int k = 0; k < MOVES_AXES; k++) sum += (end[k] - start[k]) * (end[k] - start[k]);
    return sqrt(sum);
}

// Of the axis that the arc's is, + or −: its number; −1: it is none.
static int main_axis(const arc_t *arc) {
    int k = 2;
    while (k >= 0 && fabs(arc->n[k]) < upright) k--;
    return k;
}

static void make_chords(move_t *move) {
    move->kind = MOVE_CHORDS;
    move->chords = arc_chords(&move->arc, chord_error);
    if (move->path_mode != NCK_PATH_CONTINUOUS) move->tolerance = chord_tolerance;
    move->path_mode = NCK_PATH_CONTINUOUS;
}

double moves_round(move_t *move, const double *centre, const double *normal, int32_t turn) {
    static const uint8_t planes[3] = {19, 18, 17};
    double sum = 0.0;
    if (!arc_make(move->start, move->end, centre, normal, turn, &move->arc)) return -1.0;
    const int along = main_axis(&move->arc);
    const int spirals = fabs(move->arc.radius[1] - move->arc.radius[0]) > arc_error;
    move->kind = along < 0 || spirals ? MOVE_CHORDS : MOVE_ARC;
    if (move->kind == MOVE_CHORDS) {
        make_chords(move);
    } else {
        const int32_t passes = turn < 0 ? turn : turn + 1;
        move->plane = planes[along];
        move->turns = move->arc.n[along] > 0.0 ? passes : -passes;
    }
    for (int k = 3; k < MOVES_AXES; k++) {
        sum += (move->end[k] - move->start[k]) * (move->end[k] - move->start[k]);
    }
    const double length = arc_length(&move->arc);
    return sqrt(sum + length * length);
}

// End of the chord `part`, from 0.
static void chord_end(const move_t *move, uint32_t part, double *end_out) {
    const double share = (double)(part + 1) / (double)move->chords;
    if (part + 1 == move->chords) {
        memcpy(end_out, move->end, MOVES_AXES * sizeof *end_out);
        return;
    }
    arc_point(&move->arc, share, end_out);
    for (int k = 3; k < MOVES_AXES; k++) {
        end_out[k] = move->start[k] + share * (move->end[k] - move->start[k]);
    }
}

// A place on a line.
static void line_end(const move_t *move, double share, double *end_out) {
    for (int k = 0; k < MOVES_AXES; k++) {
        end_out[k] = move->start[k] + share * (move->end[k] - move->start[k]);
    }
}

void moves_reverse(move_t *move) {
    double start[MOVES_AXES];
    memcpy(start, move->start, sizeof start);
    memcpy(move->start, move->end, sizeof start);
    memcpy(move->end, start, sizeof start);
    move->turns = -move->turns;
    arc_reverse(&move->arc);
}

static int is_round(const move_t *move) {
    return move->kind == MOVE_ARC || move->kind == MOVE_CHORDS;
}

static double share_of_line(const move_t *move, const double *place) {
    double along = 0.0, sum = 0.0;
    for (int k = 0; k < MOVES_AXES; k++) {
        const double way = move->end[k] - move->start[k];
        along += way * (place[k] - move->start[k]);
        sum += way * way;
    }
    return sum > 0.0 ? fmin(fmax(along / sum, 0.0), 1.0) : 1.0;
}

double moves_distance(const move_t *move, const double *place, double guess, double *share_out) {
    const int round = is_round(move);
    const double share =
        round ? arc_share(&move->arc, place, guess) : share_of_line(move, place);
    double at[MOVES_AXES], sum = 0.0;
    line_end(move, share, at);
    if (round) arc_point(&move->arc, share, at);
    for (int k = 0; k < MOVES_AXES; k++) sum += (place[k] - at[k]) * (place[k] - at[k]);
    *share_out = share;
    return sum;
}

int moves_is_over(const moves_t *self, const move_t *move, const double *place) {
    static const double rounding = 1e-5; // [mm]
    const double *const end = self->back ? move->start : move->end;
    const int within = move->path_mode == NCK_PATH_CONTINUOUS;
    const double most = rounding + (within ? move->tolerance : 0.0);
    double sum = 0.0;
    for (int k = 0; k < MOVES_AXES; k++) sum += (place[k] - end[k]) * (place[k] - end[k]);
    return !is_round(move) || sum <= most * most;
}

int moves_reach(const move_t *move, const moves_travel_t *travel, double room) {
    for (int k = 0; k < 3; k++) {
        const double most = fmax(travel->most[k], move->start[k]) - room;
        const double least = fmin(travel->least[k], move->start[k]) + room;
        const int round = is_round(move);
        const double high = round ? arc_reach(&move->arc, k, 1.0) : move->end[k];
        const double low = round ? arc_reach(&move->arc, k, -1.0) : move->end[k];
        if (high > most || low < least) return 1;
    }
    return 0;
}

// An entry that is executed where the next one begins.
static int is_word(const move_t *move) {
    return move->kind > MOVE_CHORDS && move->kind < MOVE_THREAD;
}

// From where the tool is arcs are chords: it is as far off as the path, and what is left of the
// tolerance is all that may be added.
static void as_it_runs(const moves_t *self, move_t *move_out) {
    static const double least = 0.1; // of the tolerance
    *move_out = *moves_at((moves_t *)self, self->next);
    if (self->back) moves_reverse(move_out);
    if (!self->anew) return;
    if (move_out->kind == MOVE_ARC) make_chords(move_out);
    move_out->tolerance -= fmin(self->away, (1.0 - least) * move_out->tolerance);
}

void moves_resume(moves_t *self, uint32_t count, double share, double away) {
    static const double rounding = 0.5e-6; // [mm]
    const double length = moves_at(self, count)->length;
    double from = self->back ? 1.0 - share : share;
    if (from * length <= rounding) from = 0.0;
    if ((1.0 - from) * length <= rounding) {
        count = moves_on(self, count);
        from = 0.0;
    } else if (!(from > 0.0) && !self->back) {
        while (count != self->tail && is_word(moves_at(self, count - 1))) count--;
    }
    self->next = count;
    self->from = from;
    self->part = 0;
    self->anew = 1;
    self->away = away;
    if (!(from > 0.0)) return;
    move_t move;
    as_it_runs(self, &move);
    if (move.kind == MOVE_CHORDS) self->part = (uint32_t)(from * move.chords);
}

// A chord of an arc leaves this axis, though it may come back to where it was.
static int swings(const move_t *move, int k) {
    return move->kind == MOVE_CHORDS && k < 3
           && (move->arc.u[k] != 0.0 || move->arc.v[k] != 0.0);
}

// What a block has whose entry has a way.
static void fill_way(const moves_t *self, const move_t *move, const double *offset,
                     nck_block_in_t *block) {
    static const uint8_t kinds[] = {NCK_IN_RAPID, NCK_IN_LINE, NCK_IN_ARC, NCK_IN_LINE};
    static const uint8_t first[3] = {NCK_AXIS_X, NCK_AXIS_Z, NCK_AXIS_Y};
    double end[MOVES_AXES];
    memcpy(end, move->end, sizeof end);
    if (move->kind == MOVE_CHORDS) chord_end(move, self->part, end);
    else if (self->to < 1.0) line_end(move, self->to, end);
    block->kind = kinds[move->kind];
    block->sets = NCK_IN_SETS_PATH;
    const int curve = move->path_mode == NCK_PATH_CONTINUOUS;
    block->path_mode = self->exact && curve ? (uint8_t)NCK_PATH_TURNS : move->path_mode;
    block->tolerance = move->tolerance;
    if (move->feed > 0.0) block->sets |= NCK_IN_SETS_FEED;
    block->feed = move->feed;
    for (int k = 0; k < MOVES_AXES; k++) {
        const int round = swings(move, k);
        const int off = self->anew && (self->axes >> k & 1u);
        if (end[k] == move->start[k] && !round && !off) continue;
        block->axes |= 1u << k;
        block->target[k] = end[k] - offset[k];
    }
    if (move->kind != MOVE_ARC) return;
    const int u = first[move->plane - 17];
    const int v = (u + 1) % 3;
    block->axes |= 1u << u | 1u << v;
    block->target[u] = end[u] - offset[u];
    block->target[v] = end[v] - offset[v];
    block->plane = move->plane;
    block->turns = move->turns;
    block->centre[0] = move->arc.centre[u] - offset[u];
    block->centre[1] = move->arc.centre[v] - offset[v];
}

int moves_block(const moves_t *self, const double *offset, nck_block_in_t *block_out) {
    move_t move;
    memset(block_out, 0, sizeof *block_out);
    block_out->id = self->next;
    as_it_runs(self, &move);
    if (move.kind <= MOVE_CHORDS) {
        const int chords = move.kind == MOVE_CHORDS;
        fill_way(self, &move, offset, block_out);
        return chords ? self->part + 1 == move.chords : !(self->to < 1.0);
    }
    block_out->kind = NCK_IN_M;
    block_out->value = move.kind >= MOVE_AT_SPEED ? MOVES_M_WAIT : MOVES_M_PASS;
    return 1;
}
