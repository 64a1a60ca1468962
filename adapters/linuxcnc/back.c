// SPDX-License-Identifier: MIT
// Beginning anew, along the moves that are kept.
#include "back.h"

#include <math.h>   // HUGE_VAL sqrt
#include <string.h> // memcpy

#include "feed.h" // feed_limits

enum { NEAR = 16 }; // entries on either side of the move in work that the tool may be at

static const double same = 1e-6; // [mm] so much nearer another move has to be

int planner_reverse(planner_t *self, int reverse) {
    if (reverse == (int)self->reversed) return 1;
    if (self->told.v > 0.0 || self->done || self->state != PLANNER_READY) return 0;
    if (!moves_is_open(moves_at(&self->moves, planner_current(self)))) return -1;
    self->reversed = (uint32_t)reverse;
    self->state = PLANNER_TURNS;
    nck_abort(&self->nck);
    return 1;
}

int back_single(planner_t *self, uint32_t single) {
    nck_set_single_block(&self->nck, single);
    if (self->single && !single) self->owed = 1;
    self->single = single;
    moves_t *const moves = &self->moves;
    const move_t *const move = moves_at(moves, planner_current(self));
    if (self->settings.slope != NCK_SLOPE_OPTIMAL || single == moves->exact) return 0;
    const int goes_on = self->paused || self->told.v > 0.0;
    if (single ? move->path_mode != NCK_PATH_CONTINUOUS : goes_on) return 0;
    if (!moves_is_open(move)) return 0;
    moves->exact = single;
    self->state = PLANNER_TURNS;
    nck_abort(&self->nck);
    return 1;
}

// Where the tool is.
typedef struct find {
    uint32_t count; // of the entry
    double share;   // of its way
    double away;    // [mm]
} find_t;

// Look from the move in work on: ahead, or behind it. Of places equally near the first one counts.
static void look(const planner_t *self, double at, uint32_t step, find_t *find) {
    moves_t *const moves = (moves_t *)&self->moves;
    uint32_t count = planner_current(self);
    for (int n = 0; n < NEAR; n++, count += step) {
        const int kept = count - moves->tail < moves->head - moves->tail;
        if (!kept || !moves_is_open(moves_at(moves, count))) return;
        const move_t *const move = moves_at(moves, count);
        if (move->kind > MOVE_CHORDS) continue;
        const double guess = (at - move->way + move->length) / move->length;
        double share;
        const double away =
            sqrt(moves_distance(move, self->told.place, fmin(fmax(guess, 0.0), 1.0), &share));
        if (!(away + same < find->away)) continue;
        *find = (find_t){count, share, away};
    }
}

// The limits that the entry to be taken next has: the next change of them knows what was before.
static void find_limits(const planner_t *self, bounds_t *bounds_out) {
    moves_t *const moves = (moves_t *)&self->moves;
    *bounds_out = self->bounds_asked;
    for (uint32_t n = moves->next + moves->back; n != moves->head; n++) {
        const move_t *const move = moves_at(moves, n);
        if (move->kind != MOVE_LIMITS) continue;
        feed_before(move, bounds_out);
        return;
    }
}

void back_begin(planner_t *self, double at) {
    moves_t *const moves = &self->moves;
    find_t find = {planner_current(self), 0.0, HUGE_VAL};
    bounds_t bounds;
    look(self, at, 1, &find);
    look(self, at, (uint32_t)-1, &find);
    moves->back = self->reversed;
    moves_resume(moves, find.count, find.share, find.away);
    find_limits(self, &bounds);
    feed_bounds(self, &bounds);
    // the kernel has nothing that it would wait for
    if (!bounds_same(&bounds, &self->bounds)) (void)feed_limits(self, &bounds);
    const move_t *const move = moves_at(moves, find.count);
    self->at = self->skipped = move->way - (1.0 - find.share) * move->length;
    self->first = moves_ahead(moves, moves->next, find.count) < 0 ? moves->next : find.count;
    self->told.move = self->first;
    self->told.between = 0;
    self->fed = self->bound = moves->back ? self->first + 1 : self->first - 1;
    self->flushed = moves->next;
    self->empty = 1;
    self->done = 0;
}
