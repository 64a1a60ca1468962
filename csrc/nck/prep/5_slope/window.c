// SPDX-License-Identifier: MIT
// Room 5, slope: the ladder of the jerk-limited slope.
#include "nck/prep/5_slope/window.h"

#include <assert.h> // assert

#include "nck/base/real.h"                // NCK_APART nck_min nck_max
#include "nck/base/scurve_math.h"         // nck_scurve_length
#include "nck/prep/5_slope/ladder_math.h" // nck_ladder_…

// From rest to rest a path takes REST_PARTS cells, PARTS_LEAST if there is no room for more.
enum { PARTS_MOST = 256, SPAN_MOST = 200, REST_PARTS = 4, PARTS_LEAST = 2 };
// Why the path rests at a piece's end: single block does, or it cannot go on.
enum { BLOCK_END = 1, MUST_REST = 2 };

// A hull rounds a ramp's end over so many steps of the ladder.
#define HULL_STEPS 2.0
// A piece has so many long cells, or none.
#define LONG_LEAST 3.0

// A cell of constant speed lasts so many periods at most, or 1.35 times that: an answer waits for
// its end. A long one at its cap lasts two.
#define CELL_PERIODS 4.0

// While the ladder is coarse no cell's duration is capped in rule R [s].
#define UNCAPPED_S 1e6

NCK_APART double nck_window_q_cap(const nck_jerk_t *self) {
    return self->work.coarse ? UNCAPPED_S : self->q_cap;
}

static double end_of(const nck_node_t *piece) { return piece->s + piece->length; }

// From the place (piece, s) on by a length; a dwell or a wait on the way is not passed.
static void walk(const nck_pieces_t *pieces, uint32_t *number, double *s, double length) {
    const nck_node_t *piece = nck_plan_piece(pieces, *number);
    double left = length;
    while (left >= end_of(piece) - *s - nck_window_rounding(piece, left)) {
        const nck_node_t *const next = nck_plan_piece(pieces, *number + 1);
        if (!next) break;
        left -= end_of(piece) - *s;
        if (left <= nck_window_rounding(piece, length)) left = 0.0; // on the next piece to the bit
        piece = next;
        *s = piece->s;
        ++*number;
        if (!(piece->length > 0.0)) return;
    }
    *s += left;
}

static void push(nck_jerk_t *self, uint32_t piece, double s, double h, double vv) {
    const uint32_t n = self->work.n;
    assert(n < NCK_PROFILE_ROWS && h >= 0.0 && vv >= 0.0);
    self->rung_piece[n] = piece;
    self->rung_s[n] = s;
    self->h[n] = h;
    self->vv[n] = vv;
    self->work.length += h;
    self->work.n++;
}

// ---- load

// A cell of the plan of now that lasts less than this share of a period is rounding: no speed that
// changes within it means anything.
#define GONE_EPSILON 1e-6

static const nck_cell_t *source(const nck_jerk_t *self, uint32_t i) {
    if (self->work.from_built) return nck_link_built_cell(self->link, i);
    return nck_link_tail_cell(self->link, self->work.source + i);
}

static int is_cruise(const nck_cell_t *cell) { return cell && nck_window_is_even(cell); }

// A long cell of constant speed stays one where nothing near it changes its speed. (A plan that has
// other wishes may, and so may a hold.)
static int stays_long(const nck_jerk_t *self, const nck_cell_t *cell, int is_hold) {
    if (is_hold || !is_cruise(cell)) return 0;
    if (!self->work.from_built) return !self->job.anew;
    const uint32_t i = self->work.i;
    const nck_cell_t *const before = i > 0 ? source(self, i - 1) : cell;
    return is_cruise(before) && is_cruise(source(self, i + 1));
}

int nck_window_parts(const nck_jerk_t *self, const nck_cell_t *cell, int is_hold) {
    const double step = is_hold ? self->hold_s : self->work.step;
    return nck_ladder_parts(cell->duration, step, PARTS_MOST);
}

// A cell as it is, which begins in this piece. Returns 0 if the window is full.
static int load_whole(nck_jerk_t *self, const nck_pieces_t *pieces, const nck_cell_t *cell,
                      uint32_t piece) {
    if (self->work.n == NCK_JERK_CELLS) return 0;
    self->work.piece = piece;
    self->work.s = cell->s;
    push(self, piece, cell->s, cell->length, cell->v * cell->v);
    walk(pieces, &self->work.piece, &self->work.s, cell->length);
    return 1;
}

// A cell that was long at full speed lasts many times that behind a lowered override, and nothing
// takes over within it: it is divided into long ones of this speed.
static int long_parts(const nck_jerk_t *self, const nck_cell_t *cell) {
    const double most = CELL_PERIODS * self->machine->period_s;
    return nck_ladder_parts(cell->duration, most, PARTS_MOST);
}

// Into how many parts a cell of the plan of now is loaded. From no speed on a hold has to move
// before it rests.
static int parts_loaded(const nck_jerk_t *self, const nck_cell_t *cell, int is_hold) {
    const int parts = nck_window_parts(self, cell, is_hold);
    if (parts > 1 && stays_long(self, cell, is_hold)) return long_parts(self, cell);
    return is_hold && !(cell->v > 0.0) ? 2 * parts : parts;
}

// A cell in parts of equal time; coarser for a hold, whose ladder is divided later. Returns 0 if
// the window is full, or the rest asked for is reached.
static int load_cell(nck_jerk_t *self, const nck_pieces_t *pieces, const nck_cell_t *cell) {
    const int is_hold = self->work.reach > 0.0 && !self->work.from_built;
    const int parts = parts_loaded(self, cell, is_hold);
    uint32_t piece = nck_plan_find(pieces, self->work.piece, cell);
    double s = cell->s;
    double begin = 0.0;
    self->work.vv_entry = cell->v * cell->v;
    if (parts == 1 && !is_hold) return load_whole(self, pieces, cell, piece);
    for (int k = 1; k <= parts; k++) {
        if (self->work.n == NCK_JERK_CELLS) return 0;
        const double t = cell->duration * (double)k / (double)parts;
        const double end = k < parts ? t * (cell->v + 0.5 * cell->a * t) : cell->length;
        const double rise = cell->a * cell->duration * (double)(k - 1) / (double)parts;
        const double v = cell->v + rise;
        double h = end - begin;
        const double room = self->work.reach - self->work.length;
        const int rests = is_hold && room <= h + NCK_WINDOW_LENGTH_EPSILON * self->work.reach;
        if (rests) h = room;
        push(self, piece, s, h, v * v);
        walk(pieces, &piece, &s, h);
        self->work.piece = piece;
        self->work.s = s;
        begin = end;
        if (!rests) continue;
        self->work.length = self->work.reach; // to the bit: finish_load compares
        return 0;
    }
    return 1;
}

// Returns 0 if the ladder ends before that cell, or in it.
static int load(nck_jerk_t *self, const nck_pieces_t *pieces, const nck_cell_t *cell) {
    if (!cell) return 0;
    if (cell->duration < GONE_EPSILON * self->machine->period_s) return 1;
    return load_cell(self, pieces, cell);
}

nck_status_t nck_window_load(nck_jerk_t *self, const nck_pieces_t *pieces) {
    const uint32_t laid = self->work.n; // a cell becomes several
    for (int n = 0; n < NCK_JERK_STEP && self->work.n - laid < NCK_JERK_LOADED; n++) {
        const nck_cell_t *const cell = source(self, self->work.i);
        const int wanted = self->work.from_built || self->work.all || self->work.reach > 0.0
                           || self->work.source + self->work.i - self->now->begin < self->now->keep;
        if (!wanted || !load(self, pieces, cell)) {
            self->work.loaded = self->work.n;
            return NCK_DONE;
        }
        self->work.i++;
    }
    return NCK_OK;
}

// ---- lay

// A piece and the two behind it; NULL: it is not known.
typedef struct piece_view {
    uint32_t number; // of the first
    const nck_node_t *piece;
    const nck_node_t *next;
    const nck_node_t *second;
} piece_view_t;

static inline piece_view_t view_of(const nck_pieces_t *pieces, uint32_t number) {
    const piece_view_t view = {number, nck_plan_piece(pieces, number),
                               nck_plan_piece(pieces, number + 1),
                               nck_plan_piece(pieces, number + 2)};
    return view;
}

// 1 if the ladder over a piece may be laid: the piece behind it is known, and the one after that,
// whose cap says how fast the path may leave (exit_cap). Without it the ladder would be as fine as
// for a rest, and fill the window.
static inline int knows_exit(const piece_view_t *view) {
    if (view->piece->stop) return 1;
    if (!view->next) return 0;
    return view->next->stop || !(view->next->length > 0.0) || view->second;
}

// BLOCK_END or MUST_REST if the path rests at the end of the piece, which is its last or has one
// behind it.
static int rests_behind(const nck_jerk_t *self, const nck_pieces_t *pieces,
                        const piece_view_t *view) {
    if (view->piece->stop) return MUST_REST;
    if (!view->next) return 0; // the window ends
    if (!(nck_window_cap(self, view->next) > 0.0)) return MUST_REST;
    if (!self->job.wish.single_block) return 0;
    return nck_plan_ends_block(self->link, pieces, view->number) ? BLOCK_END : 0;
}

int nck_window_rests(const nck_jerk_t *self, const nck_pieces_t *pieces) {
    const nck_node_t *const piece = nck_plan_piece(pieces, self->work.piece);
    if (self->work.n == 0 || !piece || self->work.s != piece->s) return 0;
    const piece_view_t view = view_of(pieces, self->work.piece - 1);
    if (!view.piece) return 0;
    return rests_behind(self, pieces, &view);
}

// 1 if the path rests where the next cell begins.
static int begins_at_rest(const nck_jerk_t *self, const nck_node_t *piece, double s) {
    if (self->work.n == 0) return !(self->profile.v > 0.0);
    return s == piece->s && !(nck_window_node_cap(self, piece) > 0.0);
}

// A cell that ends a piece. From a rest it comes in parts, because it may end at another one.
static void push_end(nck_jerk_t *self, const nck_pieces_t *pieces, uint32_t number, double s,
                     double h) {
    const int splits = begins_at_rest(self, nck_plan_piece(pieces, number), s);
    const int has_room = self->work.n + 2 * REST_PARTS <= NCK_JERK_CELLS;
    const int parts = !splits ? 1 : has_room ? REST_PARTS : PARTS_LEAST;
    for (int k = 0; k < parts; k++) {
        if (k > 0) walk(pieces, &number, &s, h / (double)parts);
        push(self, number, s, h / (double)parts, NCK_WINDOW_UNCAPPED);
    }
}

static void close_pending(nck_jerk_t *self, const nck_pieces_t *pieces) {
    if (!(self->work.pending > 0.0)) return;
    push_end(self, pieces, self->work.pending_piece, self->work.pending_s, self->work.pending);
    self->work.pending = 0.0;
}

// At a piece's end the path may be faster than at its start, if the next one's lets it.
static inline void gain_entry(nck_jerk_t *self, const piece_view_t *view) {
    const nck_node_t *const piece = view->piece;
    if (view->next && self->work.vv_entry >= nck_window_node_cap(self, view->next)) return;
    self->work.vv_entry += nck_ladder_gain(piece->length, piece->a, piece->j * self->j_scale);
}

// The ladder has come to the end of a piece.
static nck_status_t end_piece(nck_jerk_t *self, const nck_pieces_t *pieces,
                              const piece_view_t *view, int rests) {
    gain_entry(self, view);
    self->work.piece++;
    self->work.s = NCK_PLAN_BEGIN;
    if (!rests) return NCK_OK;
    self->work.must_rest = rests == MUST_REST;
    if (self->work.to_pass > 0 && rests == BLOCK_END) {
        self->work.to_pass--;
        return NCK_OK;
    }
    close_pending(self, pieces);
    self->next->complete = 1;
    if (self->job.wish.single_block) self->next->held = NCK_HELD_BLOCK;
    return NCK_DONE;
}

// Short pieces share a cell as long as it stays within a step.
static int joins_pending(const nck_jerk_t *self, const nck_node_t *piece, double step) {
    return self->work.pending > 0.0 && self->work.pending + piece->length <= step
           && nck_window_node_cap(self, piece) > 0.0
           && self->work.piece - self->work.pending_piece < SPAN_MOST;
}

// About the largest v² at a piece's start, by what the piece and the node behind it allow. Zones of
// corners make pieces of their own, so the corner itself may be one further on.
static inline double exit_cap(const nck_jerk_t *self, const piece_view_t *view) {
    const nck_node_t *const next = view->next;
    const nck_node_t *const second = view->second;
    const double vv_end = next->stop || !second ? 0.0 : nck_window_node_cap(self, second);
    const double cap = nck_window_node_cap(self, next);
    if (vv_end >= cap) return cap;
    const double gain = nck_ladder_gain(next->length, next->a, next->j * self->j_scale);
    return nck_min(cap, vv_end + gain);
}

// How near the ends of a piece the speed may change at all: a ramp, and what hulls round. Where no
// more is left between than a few long cells, they are not worth it.
static double find_even(const nck_jerk_t *self, const nck_ladder_piece_t *rungs, double left) {
    const double least_s = LONG_LEAST * self->long_steps * self->step_s;
    if (!(self->long_steps > 1.0) || left * left < least_s * least_s * rungs->vv) {
        return NCK_JERK_UNKNOWN;
    }
    const double v = nck_sqrt(rungs->vv);
    const nck_scurve_t ramp = {rungs->a, rungs->j, v};
    const double length = nck_scurve_length(&ramp, nck_sqrt(nck_min(rungs->vv0, rungs->vv1)), v);
    const double even = length + HULL_STEPS * self->step_s * v;
    return left - 2.0 * even > least_s * v ? even : NCK_JERK_UNKNOWN;
}

// How near the ends of a piece, or of what is left of it, the ladder is finer than far from them.
static void find_far(nck_jerk_t *self, const nck_ladder_piece_t *rungs, double x, double left) {
    const double vv_low = nck_min(rungs->vv0, rungs->vv1);
    self->work.far = nck_ladder_far(rungs->vv - vv_low, rungs->a, rungs->j);
    self->work.far_s = x;
    self->work.even = find_even(self, rungs, left);
}

// Far from both ends of a piece, x behind the nearer end and y before the last one, nothing speeds
// up or slows down: a cell is as long as the next plan may wait for its end, but does not reach
// what is near the piece's end.
static double far_step(const nck_jerk_t *self, double step, double x, double y) {
    if (!(x >= self->work.even)) return step;
    if (y - self->work.even > (self->long_steps + 2.0) * step) return step * self->long_steps;
    const double fit = nck_floor((y - self->work.even) / step);
    return step * nck_max(1.0, nck_min(self->long_steps, fit));
}

// The piece at the ladder's end, as long as nothing else is known of the path.
typedef struct ground {
    piece_view_t view;             // no piece: it has not been looked at
    int rests;               // what rests_behind says
    double end;              // of the piece, in its seg [mm]
    double rounding;         // beside that
    nck_ladder_piece_t rungs;
    int begun;               // 1: what follows is known
    int alone;               // 1: the piece goes from rest to rest: several cells are wanted
    double step;             // of the ladder at its cap [mm]
    double joined;           // no step is less, and with it the piece shares a cell; 0: it may not
} ground_t;

static void look(const nck_jerk_t *self, const nck_pieces_t *pieces, ground_t *ground) {
    const piece_view_t *const view = &ground->view;
    const nck_node_t *const piece = view->piece;
    const int rests = rests_behind(self, pieces, view);
    const double vv = nck_window_cap(self, piece);
    const double vv1 = rests || !view->next ? 0.0 : nck_min(vv, exit_cap(self, view));
    const nck_ladder_piece_t rungs = {0.0, vv1, vv, piece->a, piece->j * self->j_scale};
    ground->rests = rests;
    ground->end = end_of(piece);
    ground->rounding = nck_window_rounding(piece, 0.0);
    ground->rungs = rungs;
    ground->begun = 0;
}

// The first cell that is laid here; that of the piece notes the speed that it begins with.
static void begin_ground(nck_jerk_t *self, ground_t *ground, double x, double left) {
    nck_ladder_piece_t *const rungs = &ground->rungs;
    if (x == 0.0) {
        const double vv_node = nck_min(rungs->vv, nck_window_node_cap(self, ground->view.piece));
        self->work.vv_entry = nck_min(vv_node, self->work.vv_entry);
    }
    rungs->vv0 = self->work.vv_entry;
    const double least = nck_min(rungs->vv, nck_min(rungs->vv0, rungs->vv1));
    const double slowest = self->work.pending > 0.0 ? self->step_s * nck_sqrt(least) : 0.0;
    ground->joined = x == 0.0 && joins_pending(self, ground->view.piece, slowest) ? slowest : 0.0;
    ground->alone = rungs->vv0 == 0.0 && rungs->vv1 == 0.0;
    if (ground->joined > 0.0) return;
    if (x == 0.0 || self->work.far == NCK_JERK_UNKNOWN) find_far(self, rungs, x, left);
    ground->step = self->step_s * nck_sqrt(rungs->vv);
    ground->begun = 1;
}

// How long the next cell is to be, as the ladder has it; short pieces share it [mm].
static double next_step(const nck_jerk_t *self, const ground_t *ground, double x, double left) {
    const double off = nck_min(x - self->work.far_s, left);
    if (ground->joined > 0.0) return ground->joined;
    return off > self->work.far ? far_step(self, ground->step, off, left)
                                : nck_ladder_step(&ground->rungs, x, left, self->step_s);
}

// Lay what is left of a piece, or one cell of it.
static nck_status_t lay_some(nck_jerk_t *self, const nck_pieces_t *pieces, ground_t *ground) {
    const piece_view_t *const view = &ground->view;
    const nck_node_t *const piece = view->piece;
    const int rests = ground->rests;
    const double x = self->work.s - piece->s;
    const double left = piece->length - x;
    if (!ground->begun) begin_ground(self, ground, x, left);
    const double step = next_step(self, ground, x, left);
    const double h = ground->alone ? nck_min(step, 0.25 * piece->length) : step;
    if (joins_pending(self, piece, step) && x == 0.0 && !ground->alone) {
        self->work.pending += left;
        return end_piece(self, pieces, view, rests);
    }
    close_pending(self, pieces);
    if (left >= 1.5 * h) {
        push(self, self->work.piece, self->work.s, h, NCK_WINDOW_UNCAPPED);
        self->work.s += h;
        return NCK_OK;
    }
    if (left < 0.5 * h && x == 0.0 && !rests) {
        self->work.pending = left;
        self->work.pending_piece = self->work.piece;
        self->work.pending_s = self->work.s;
        return end_piece(self, pieces, view, rests);
    }
    push_end(self, pieces, self->work.piece, self->work.s, left);
    return end_piece(self, pieces, view, rests);
}

// A dwell or a wait is a plan of its own.
static nck_status_t lay_rest(nck_jerk_t *self, const nck_pieces_t *pieces,
                             const nck_node_t *piece) {
    close_pending(self, pieces);
    self->next->complete = 1;
    if (self->work.n > 0) return NCK_DONE;
    push(self, self->work.piece, piece->s, 0.0, 0.0);
    self->work.piece++;
    self->work.s = NCK_PLAN_BEGIN;
    return NCK_DONE;
}

// No more pieces are known. It waits for them, unless the tick waits for it.
static nck_status_t ends_here(nck_jerk_t *self, const nck_pieces_t *pieces) {
    const int begun = self->work.n > 0 || self->work.pending > 0.0;
    if (!self->job.starved || !begun) return NCK_EMPTY;
    close_pending(self, pieces);
    return NCK_DONE;
}

// 1 if the ladder has room for what is laid at a piece's end.
static int takes_cells(const nck_jerk_t *self) {
    return self->work.n + 2 * PARTS_LEAST <= self->work.room;
}

// 1 if no more of the path fits into the ladder.
static int is_full(const nck_jerk_t *self, const nck_pieces_t *pieces, const nck_node_t *piece) {
    const uint32_t blocks = self->machine->lookahead_blocks;
    if (!takes_cells(self)) return 1;
    if (self->work.piece - self->work.base >= self->work.pieces) return 1;
    const nck_node_t *const first = nck_plan_piece(pieces, self->next->piece);
    return blocks > 0 && nck_plan_is_beyond(self->link, first, piece, blocks);
}

// The ladder comes to a piece: NCK_OK if it may be laid over it.
static nck_status_t enter_piece(nck_jerk_t *self, const nck_pieces_t *pieces, ground_t *ground) {
    ground->view = view_of(pieces, self->work.piece);
    const nck_node_t *const piece = ground->view.piece;
    if (!piece) return ends_here(self, pieces);
    if (self->work.s == NCK_PLAN_BEGIN) self->work.s = piece->s;
    if (!(piece->length > 0.0)) return lay_rest(self, pieces, piece);
    if (is_full(self, pieces, piece)) {
        close_pending(self, pieces);
        return NCK_DONE;
    }
    if (!knows_exit(&ground->view) && !self->job.starved) return NCK_EMPTY;
    look(self, pieces, ground);
    return NCK_OK;
}

static nck_status_t lay_one(nck_jerk_t *self, const nck_pieces_t *pieces, ground_t *ground) {
    const int is_new = !ground->view.piece || self->work.piece != ground->view.number;
    if (is_new || !takes_cells(self)) {
        const nck_status_t status = enter_piece(self, pieces, ground);
        if (status != NCK_OK) return status;
    }
    const int is_over = ground->end - self->work.s <= ground->rounding;
    if (is_over && self->work.n > 0) return end_piece(self, pieces, &ground->view, ground->rests);
    return lay_some(self, pieces, ground);
}

nck_status_t nck_window_lay(nck_jerk_t *self, const nck_pieces_t *pieces) {
    ground_t ground = {0};
    for (int n = 0; n < NCK_JERK_STEP; n++) {
        const nck_status_t status = lay_one(self, pieces, &ground);
        if (status == NCK_OK) continue;
        if (status == NCK_DONE) {
            self->next->n = self->work.n;
            self->next->end_piece = self->work.piece;
            self->next->end_s = self->work.s;
        }
        return status;
    }
    return NCK_OK;
}
