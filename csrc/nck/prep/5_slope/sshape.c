// SPDX-License-Identifier: MIT
// Room 5, slope: the classical S-shape over a window of pieces.
#include "nck/prep/5_slope/sshape.h"

#include <string.h> // memset

#include "nck/base/real.h"                // nck_min nck_max nck_sqrt
#include "nck/prep/5_slope/ladder_math.h" // nck_ladder_cbrt
#include "nck/prep/5_slope/sshape_math.h" // nck_sshape_length


enum {
    LOOK_STEP = 32, // pieces in one bounded step of looking
    BRAKE_STEP = 8, // runs in one bounded step of braking
    // a part goes through so many pieces, and a tail holds it and at most three cells for every
    // piece of the brake behind it
    PART_PIECES = NCK_WINDOW / 8,
    PART_CELLS = NCK_TAIL_MAX / 8 > NCK_SSHAPE_CELLS ? NCK_TAIL_MAX / 8 : NCK_SSHAPE_CELLS,
    PIECES_BY_TAIL = (NCK_TAIL_MAX - PART_CELLS) / 3,
    PIECES_BY_WINDOW = NCK_WINDOW - 8 - PART_PIECES,
    PIECES_MOST = PIECES_BY_TAIL < PIECES_BY_WINDOW ? PIECES_BY_TAIL : PIECES_BY_WINDOW,
};
enum { PHASE_LOOK = 0, PHASE_SPEEDS, PHASE_PART, PHASE_BRAKE, PHASE_INSTALL };
enum { STAGE_RISE = 0, STAGE_CRUISE, STAGE_FALL, STAGE_END };

// Periods that are final ahead of the tick, and that a stretch of cruise lasts: a hold begins to
// brake within about both.
#define LEAD_PERIODS 20.0
// A run keeps to the least jerk of its pieces: a zone that has less than this share of its middle's
// is a run of its own.
#define RUN_JERK 0.6
// nck_ladder_cbrt is good to 1 %.
#define CBRT_ROOM 1.02

void nck_sshape_init(nck_sshape_t *self, const nck_machine_t *machine, nck_link_t *link) {
    memset(self, 0, sizeof *self);
    self->machine = machine;
    self->link = link;
    self->at.fresh = 1;
    self->done = self->at;
}

static double lead_of(const nck_sshape_t *self) { return LEAD_PERIODS * self->machine->period_s; }

static double *speed_at(nck_sshape_t *self, uint32_t number) {
    return &self->ahead.v[number & (NCK_WINDOW - 1)];
}

static uint8_t *pieces_at(nck_sshape_t *self, uint32_t number) {
    return &self->ahead.pieces[number & (NCK_WINDOW - 1)];
}

// ---- runs

// The run that a place lies in, from the place on.
typedef struct run {
    nck_sshape_piece_t piece;
    const nck_node_t *first;
    const nck_node_t *end; // its last piece
    double s;        // where the place is, in the run's seg
    double v_in;     // what its head allows at its start [mm/s]
    double v_out;    // what its tail allows at its end [mm/s]
    uint32_t count;  // pieces
    uint8_t stops;   // 1: the path rests at the run's end
    uint8_t limit;   // nck_limit_t of its cap
} run_t;

// Within the distance z of a place without acceleration the S-shape's is at most (6·z·j²)^(1/3):
// that is where it gets from rest, x = j·t³/6 and a = j·t. So v² changes by 2·a·z at most there.
static double gain_in(const nck_node_t *zone, double j) {
    const double a = CBRT_ROOM * nck_ladder_cbrt(6.0 * zone->length * j * j);
    return 2.0 * nck_min(a, zone->a) * zone->length;
}

// Whether a zone next to a junction may share a run with the middle of its seg: its limit of
// acceleration must be out of reach there, and its cap be kept by one at the junction.
static int joins(const nck_node_t *zone, const nck_node_t *middle) {
    const double j = nck_min(zone->j, middle->j);
    const int slow = zone->a >= middle->a
                     || zone->a * zone->a * zone->a >= 6.0 * zone->length * j * j;
    const int open = zone->vv_piece >= middle->vv_piece;
    const int brisk = zone->j >= RUN_JERK * middle->j;
    return brisk && slow && (open || 0.5 * zone->vv_piece >= gain_in(zone, j));
}

// The speed at the junction next to a zone that keeps its cap throughout.
static double v_beside(const nck_node_t *zone, const nck_node_t *middle, double j) {
    if (zone->vv_piece >= middle->vv_piece) return nck_sqrt(middle->vv_piece);
    return nck_sqrt(zone->vv_piece - gain_in(zone, j));
}

// Pieces of the run that begins with this one; 0: what follows in its seg is not known yet. The
// middle of a seg is longer than its zones; of two parts of a length the second is taken for it.
static uint32_t run_pieces(const nck_pieces_t *pieces, uint32_t number) {
    const nck_node_t *const first = nck_plan_piece(pieces, number);
    if (first->last) return 1;
    const nck_node_t *const second = nck_plan_piece(pieces, number + 1);
    if (!second) return 0;
    if (first->length > second->length) return joins(second, first) ? 2 : 1;
    if (!joins(first, second)) return 1;
    if (second->last) return 2;
    const nck_node_t *const third = nck_plan_piece(pieces, number + 2);
    if (!third) return 0;
    return third->length <= second->length && joins(third, second) ? NCK_SSHAPE_RUN : 2;
}

// The middle of a run, the one that run_pieces has joined the others to.
static const nck_node_t *middle_of(const nck_pieces_t *pieces, uint32_t number, uint32_t count) {
    const nck_node_t *const first = nck_plan_piece(pieces, number);
    if (count == 1) return first;
    const nck_node_t *const second = nck_plan_piece(pieces, number + 1);
    return first->length > second->length ? first : second;
}

static run_t run_of(nck_sshape_t *self, const nck_pieces_t *pieces,
                    const nck_sshape_place_t *place) {
    run_t run;
    memset(&run, 0, sizeof run);
    run.count = *pieces_at(self, place->piece);
    run.first = nck_plan_piece(pieces, place->piece);
    run.end = nck_plan_piece(pieces, place->piece + run.count - 1);
    run.s = place->fresh ? run.first->s : place->s;
    const nck_node_t *const middle = middle_of(pieces, place->piece, run.count);
    double j = middle->j;
    for (uint32_t i = 0; i < run.count; i++) {
        j = nck_min(j, nck_plan_piece(pieces, place->piece + i)->j);
    }
    run.piece.length = run.end->s + run.end->length - run.s;
    run.piece.v_cap = nck_sqrt(middle->vv_piece);
    run.piece.a = middle->a;
    run.piece.j = j;
    run.v_in = v_beside(run.first, middle, j);
    run.v_out = v_beside(run.end, middle, j);
    run.stops = run.end->stop || !(run.end->length > 0.0);
    run.limit = middle->limit_piece;
    return run;
}

// The largest speed at a run's end that what lies behind it allows.
static double end_most(nck_sshape_t *self, const run_t *run, uint32_t number) {
    if (run->stops) return 0.0;
    return nck_min(run->v_out, *speed_at(self, number + run->count));
}

// ---- look

// Whether the horizon has come as far as it may: a stop, or all that the look-ahead may see.
static int is_far(const nck_sshape_t *self, const nck_pieces_t *pieces) {
    const uint32_t blocks = self->machine->lookahead_blocks;
    const uint32_t count = self->ahead.horizon - self->at.piece;
    if (count == 0) return 0;
    const nck_node_t *const first = nck_plan_piece(pieces, self->at.piece);
    const nck_node_t *const last = nck_plan_piece(pieces, self->ahead.horizon - 1);
    const int stops = last->stop || !(last->length > 0.0);
    const int seen = blocks > 0 && last->last && last->seg - first->seg + 1 >= blocks;
    return stops || seen || count + NCK_SSHAPE_RUN > PIECES_MOST;
}

// Whether to look further at all. N blocks are counted anew at every run; what the window holds
// only when half of it is left, so that a run costs two speeds, not as many as a ramp has runs.
static int is_far_enough(nck_sshape_t *self) {
    const uint32_t count = self->ahead.horizon - self->at.piece;
    if (self->machine->lookahead_blocks > 0 || count < PIECES_MOST / 2) self->ahead.looks = 1;
    return !self->ahead.looks;
}

static void begin_speeds(nck_sshape_t *self, const nck_pieces_t *pieces) {
    const nck_node_t *const last = nck_plan_piece(pieces, self->ahead.horizon - 1);
    if (last->stop || !(last->length > 0.0)) self->ahead.capped = self->ahead.horizon;
    *speed_at(self, self->ahead.horizon) = 0.0;
    self->ahead.i = self->ahead.horizon - 1;
    self->phase = PHASE_SPEEDS;
}

// NCK_EMPTY if the next run is not known yet.
static nck_status_t add_run(nck_sshape_t *self, const nck_pieces_t *pieces) {
    const uint32_t next = self->ahead.horizon;
    const uint32_t count = nck_plan_piece(pieces, next) ? run_pieces(pieces, next) : 0;
    for (uint32_t i = 0; i < count; i++) *pieces_at(self, next + i) = 0;
    *pieces_at(self, next) = (uint8_t)count;
    self->ahead.horizon += count;
    return count > 0 ? NCK_OK : NCK_EMPTY;
}

static void begin_brake(nck_sshape_t *self) {
    self->brake = self->at;
    self->phase = PHASE_BRAKE;
}

// Pieces are missing: the part ends here. How a path is divided into parts does not change how it
// is passed.
static nck_status_t look_in_vain(nck_sshape_t *self) {
    if (self->part.built == 0) return NCK_EMPTY;
    begin_brake(self);
    return NCK_OK;
}

static nck_status_t look(nck_sshape_t *self, const nck_pieces_t *pieces) {
    if ((int32_t)(self->ahead.horizon - self->at.piece) < 0) {
        self->ahead.horizon = self->at.piece;
        self->ahead.was = self->at.piece;
        self->ahead.capped = self->at.piece;
    }
    if (is_far_enough(self)) {
        self->phase = PHASE_PART;
        return NCK_OK;
    }
    for (int n = 0; n < LOOK_STEP; n++) {
        if (is_far(self, pieces)) {
            self->ahead.looks = 0;
            begin_speeds(self, pieces);
            return NCK_OK;
        }
        if (add_run(self, pieces) != NCK_OK) return look_in_vain(self);
    }
    return NCK_OK;
}

// ---- speeds

// One piece; returns 1 if the speeds before it stay as they are.
static int speed_piece(nck_sshape_t *self, const nck_pieces_t *pieces) {
    const uint32_t i = self->ahead.i;
    if ((int32_t)(i - self->at.piece) <= 0 || self->ahead.horizon == self->ahead.was) return 1;
    self->ahead.i--;
    if (*pieces_at(self, i) == 0) return 0;
    const nck_sshape_place_t start = {i, 1, 0.0, 0.0};
    const run_t run = run_of(self, pieces, &start);
    const double cap = nck_min(run.v_in, nck_sqrt(run.first->vv_cap));
    const double v = nck_min(cap, nck_sshape_brakeable(&run.piece, end_most(self, &run, i)));
    const int known = (int32_t)(i - self->ahead.was) <= 0;
    const int same = known && v == *speed_at(self, i);
    if (v == cap && (int32_t)(i - self->ahead.capped) > 0) self->ahead.capped = i;
    *speed_at(self, i) = v;
    return same;
}

static nck_status_t look_back(nck_sshape_t *self, const nck_pieces_t *pieces) {
    for (int n = 0; n < LOOK_STEP; n++) {
        if (!speed_piece(self, pieces)) continue;
        self->ahead.was = self->ahead.horizon;
        self->phase = PHASE_PART;
        return NCK_OK;
    }
    return NCK_OK;
}

// ---- part

static void set_course(nck_sshape_t *self, const run_t *run) {
    const double most = end_most(self, run, self->at.piece);
    const double v_out = nck_sshape_fastest_end(&run->piece, self->at.v, most);
    nck_sshape_plan(&run->piece, self->at.v, v_out, &self->course.way);
    self->course.set = 1;
    self->course.stage = STAGE_RISE;
}

// A stretch of the cruise, or all that is left of it. That is measured from the run's end, or the
// roundings of many stretches would add up; half of it is never rounding.
static void draw_cruise(nck_sshape_t *self, const run_t *run, nck_sshape_pen_t *pen) {
    nck_sshape_course_t *const way = &self->course.way;
    const double fall = nck_sshape_length(way->peak, way->v_out, run->piece.a, run->piece.j);
    const double left = nck_max(0.5 * way->cruise, run->piece.length - fall);
    const double stretch = way->peak * lead_of(self);
    const int whole = left < 1.5 * stretch;
    nck_sshape_draw(pen, (whole ? left : stretch) / way->peak, 0.0, 0.0);
    pen->cells[pen->count - 1].limit = run->limit;
    way->cruise = whole ? 0.0 : left - stretch;
}

// Down to the end's speed. What the horizon alone asks for is told.
static void draw_fall(nck_sshape_t *self, const run_t *run, nck_sshape_pen_t *pen) {
    const nck_sshape_course_t *const way = &self->course.way;
    const int open = (int32_t)(self->at.piece + run->count - self->ahead.capped) > 0;
    const uint32_t count = pen->count;
    nck_sshape_draw_ramp(pen, &run->piece, way->v_out, way->stretch);
    for (uint32_t i = count; open && i < pen->count; i++) {
        pen->cells[i].limit = NCK_LIMIT_LOOKAHEAD;
    }
}

// Stages without length are left out.
static void go_on(nck_sshape_t *self) {
    const nck_sshape_course_t *const way = &self->course.way;
    uint32_t *const stage = &self->course.stage;
    if (*stage != STAGE_CRUISE || !(way->cruise > 0.0)) ++*stage;
    if (*stage == STAGE_CRUISE && !(way->cruise > 0.0)) ++*stage;
    if (*stage == STAGE_FALL && way->peak == way->v_out) ++*stage;
}

static void draw_stage(nck_sshape_t *self, const run_t *run, nck_sshape_pen_t *pen) {
    const nck_sshape_course_t *const way = &self->course.way;
    switch (self->course.stage) {
    case STAGE_RISE: nck_sshape_draw_ramp(pen, &run->piece, way->peak, way->stretch); break;
    case STAGE_CRUISE: draw_cruise(self, run, pen); break;
    default: draw_fall(self, run, pen); break;
    }
    go_on(self);
}

// The next stage of the course that draws anything, and with it what is left behind the cruise.
static nck_sshape_place_t draw_run(nck_sshape_t *self, const run_t *run, nck_sshape_pen_t *pen) {
    if (!self->course.set) set_course(self, run);
    do draw_stage(self, run, pen);
    while (self->course.stage == STAGE_FALL || pen->count == 0);
    const int ends = self->course.stage == STAGE_END;
    const nck_sshape_place_t within = {self->at.piece, 0, pen->s, pen->v};
    const nck_sshape_place_t behind = {self->at.piece + run->count, 1, 0.0,
                                       self->course.way.v_out};
    pen->cells[pen->count - 1].last = ends && run->end->last;
    self->course.set = !ends;
    return ends ? behind : within;
}

// A dwell or a wait.
static nck_sshape_place_t draw_rest(const nck_sshape_t *self, const nck_node_t *node,
                                    nck_sshape_pen_t *pen) {
    const nck_sshape_place_t behind = {self->at.piece + 1, 1, 0.0, 0.0};
    nck_cell_t *const cell = &pen->cells[pen->count++];
    memset(cell, 0, sizeof *cell);
    cell->seg = node->seg;
    cell->s = node->s;
    cell->duration = node->dwell_s;
    cell->limit = node->limit_piece;
    cell->last = 1;
    return behind;
}

static void add_to_part(nck_sshape_t *self, const nck_sshape_pen_t *pen) {
    if (self->part.built == 0) nck_link_tail_begin(self->link);
    for (uint32_t i = 0; i < pen->count; i++) {
        nck_link_tail_push(self->link, &pen->cells[i]);
        self->part.time += pen->cells[i].duration;
    }
    self->part.built += pen->count;
}

static int part_is_full(const nck_sshape_t *self) {
    return !(self->at.v > 0.0) || self->part.time >= lead_of(self)
           || self->part.built + NCK_SSHAPE_CELLS > PART_CELLS
           || self->at.piece + NCK_SSHAPE_RUN - self->done.piece > PART_PIECES;
}

static nck_status_t build_part(nck_sshape_t *self, const nck_pieces_t *pieces) {
    const run_t run = run_of(self, pieces, &self->at);
    nck_cell_t cells[NCK_SSHAPE_CELLS];
    nck_sshape_pen_t pen = {cells, 0, run.first->seg, run.s, self->at.v};
    self->at = run.piece.length > 0.0 ? draw_run(self, &run, &pen)
                                      : draw_rest(self, run.first, &pen);
    if (!(self->at.v > 0.0)) pen.cells[pen.count - 1].stop = NCK_STOP_REST;
    add_to_part(self, &pen);
    if (part_is_full(self)) {
        begin_brake(self);
    } else {
        self->phase = self->course.set ? PHASE_PART : PHASE_LOOK;
    }
    return NCK_OK;
}

// ---- brake

// Behind the run.
static void leave_run(nck_sshape_t *self, const run_t *run, nck_cell_t *end) {
    end->last = run->end->last;
    self->brake.piece += run->count;
    self->brake.fresh = 1;
}

// The brake comes to rest in the run, or at its end if what is left is rounding.
static void come_to_rest(nck_sshape_t *self, const run_t *run, const nck_sshape_pen_t *pen) {
    nck_cell_t *const end = &pen->cells[pen->count - 1];
    end->stop = NCK_STOP_REST;
    self->brake.fresh = 0;
    self->brake.s = pen->s;
    const double left = run->s + run->piece.length - pen->s;
    if (left <= NCK_SSHAPE_EPSILON * run->piece.length) leave_run(self, run, end);
}

// Through one run, as slow as it gets.
static void brake_run(nck_sshape_t *self, const nck_pieces_t *pieces) {
    const run_t run = run_of(self, pieces, &self->brake);
    const double v = self->brake.v;
    const double most = end_most(self, &run, self->brake.piece);
    const double slowest = nck_sshape_slowest_end(&run.piece, v, most);
    const double length = nck_sshape_length(v, slowest, run.piece.a, run.piece.j);
    const int exact = slowest > 0.0 ? slowest == v : length <= run.piece.length;
    nck_cell_t cells[NCK_SSHAPE_CELLS];
    nck_sshape_pen_t pen = {cells, 0, run.first->seg, run.s, v};
    nck_sshape_draw_ramp(&pen, &run.piece, slowest, exact ? 1.0 : run.piece.length / length);
    if (pen.count == 0) nck_sshape_draw(&pen, run.piece.length / v, 0.0, 0.0); // too short to brake
    self->brake.v = slowest;
    if (slowest > 0.0) {
        leave_run(self, &run, &cells[pen.count - 1]);
    } else {
        come_to_rest(self, &run, &pen);
    }
    for (uint32_t i = 0; i < pen.count; i++) {
        cells[i].limit = NCK_LIMIT_STARVED;
        nck_link_tail_push(self->link, &cells[i]);
    }
}

static nck_status_t build_brake(nck_sshape_t *self, const nck_pieces_t *pieces) {
    for (int n = 0; n < BRAKE_STEP && self->brake.v > 0.0; n++) {
        if (!nck_plan_piece(pieces, self->brake.piece)) return NCK_E_INTERNAL;
        brake_run(self, pieces);
    }
    if (!(self->brake.v > 0.0)) self->phase = PHASE_INSTALL;
    return NCK_OK;
}

// ---- install

static uint32_t final_count(const nck_sshape_t *self) {
    int entered = 0;
    return (nck_link_end(self->link, &entered) - self->part.begin) & NCK_LINK_COUNT_MASK;
}

static nck_status_t install(nck_sshape_t *self) {
    int entered = 0;
    const uint32_t begin = nck_link_end(self->link, &entered);
    const int early = nck_link_lead(self->link) >= lead_of(self);
    if (early || final_count(self) < self->part.cells) return NCK_FULL;
    const nck_status_t status = nck_link_install(self->link, lead_of(self), self->part.built);
    if (status != NCK_OK) return status == NCK_E_STATE ? NCK_OK : status;
    self->part.begin = begin;
    self->part.cells = self->part.built;
    self->part.built = 0;
    self->part.time = 0.0;
    self->done = self->at;
    self->rest = self->brake;
    self->in_tail = 0;
    self->phase = self->course.set ? PHASE_PART : PHASE_LOOK;
    return NCK_OK;
}

// The tick has run into the tail: the path comes to rest where the published plan does.
static void fall_into_tail(nck_sshape_t *self) {
    int entered = 0;
    memset(&self->part, 0, sizeof self->part);
    self->part.begin = nck_link_end(self->link, &entered);
    self->course.set = 0;
    self->at = self->rest;
    self->done = self->rest;
    self->in_tail = 1;
    self->phase = PHASE_LOOK;
}

static nck_status_t work(nck_sshape_t *self, const nck_pieces_t *pieces) {
    switch (self->phase) {
    case PHASE_LOOK: return look(self, pieces);
    case PHASE_SPEEDS: return look_back(self, pieces);
    case PHASE_PART: return build_part(self, pieces);
    case PHASE_BRAKE: return build_brake(self, pieces);
    default: return install(self);
    }
}

nck_status_t nck_sshape_step(nck_sshape_t *self, const nck_pieces_t *pieces, uint32_t hold) {
    int entered = 0;
    (void)nck_link_end(self->link, &entered);
    if (entered && !self->in_tail) fall_into_tail(self);
    if (hold) return NCK_FULL;
    const uint32_t done = final_count(self);
    const uint32_t left = done < self->part.cells ? self->part.cells - done : 0;
    if (left > 0 && nck_link_advance(self->link, lead_of(self), left) == NCK_OK) return NCK_OK;
    const nck_status_t status = work(self, pieces);
    return status == NCK_EMPTY && left > 0 ? NCK_FULL : status;
}

uint32_t nck_sshape_needs(const nck_sshape_t *self) { return self->done.piece; }
