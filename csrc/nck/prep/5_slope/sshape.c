// SPDX-License-Identifier: MIT
// Room 5, slope: the classical S-shape over a window of pieces.
#include "nck/prep/5_slope/sshape.h"

#include <string.h> // memset

#include "nck/base/real.h"                 // nck_max
#include "nck/prep/5_slope/sshape_ahead.h" // nck_sshape_look …
#include "nck/prep/5_slope/sshape_math.h"  // nck_sshape_length

enum {
    BRAKE_STEP = 8, // hops in one bounded step of braking
    PART_DRAWN = NCK_SSHAPE_PART - NCK_LEGS // cells of a part, less those of a ramp gone through
};
enum { PHASE_FOLLOW = 0, PHASE_LOOK, PHASE_PART, PHASE_BRAKE, PHASE_CARRY };
enum { STAGE_RISE = 0, STAGE_CRUISE, STAGE_FALL, STAGE_END };

// A part ends when it lasts so long: then the brake behind it has been worth its work.
#define PART_PERIODS 20.0
// The same where it may overlap the end of the plan before.
#define OVERLAP_PERIODS 100.0
// So many times as far from a rest as motions may be that overlap there, all that a plan withholds
// is still ahead.
#define OVERLAP_NEAR 16.0
// A plan joins the speed that it begins with within this share.
#define JOIN_EPSILON 1e-9

void nck_sshape_init(nck_sshape_t *self, const nck_machine_t *machine, nck_link_t *link,
                     const nck_plan_t *now, nck_plan_t *next) {
    if (!NCK_HAS_SSHAPE) return;
    memset(self, 0, sizeof *self);
    self->machine = machine;
    self->link = link;
    self->now = now;
    self->next = next;
    self->at.fresh = 1;
    self->phase = PHASE_LOOK;
}

static void push(nck_sshape_t *self, const nck_cell_t *cell) {
    nck_link_tail_push(self->link, cell);
    self->cells++;
}

// ---- begin

static void look_anew(nck_sshape_t *self, double v_floor) {
    nck_sshape_look_anew(self, v_floor);
    self->phase = PHASE_LOOK;
}

// Where the plan of now is left it may be in the middle of a ramp.
static void begin_follow(nck_sshape_t *self, uint32_t follows) {
    nck_link_tail_begin(self->link);
    self->cells = 0;
    self->i = 0;
    self->follows = follows;
    self->at.piece = self->next->piece;
    self->phase = PHASE_FOLLOW;
}

void nck_sshape_begin(nck_sshape_t *self, const nck_job_t *job) {
    if (!NCK_HAS_SSHAPE) return;
    const int is_brake = job->kind == NCK_JOB_BRAKE;
    nck_link_tail_begin(self->link);
    self->job = *job;
    if (job->anew || (int32_t)(self->next->piece - self->skip) > 0) self->skip = self->next->piece;
    self->cells = 0;
    self->time = 0.0;
    self->checks = job->kind == NCK_JOB_GO_ON && job->anew;
    if (is_brake) self->next->held = job->held;
    self->phase = self->course.set ? PHASE_PART : PHASE_LOOK;
    if (!is_brake && !job->anew) return;
    const nck_sshape_place_t place = {self->next->piece, 0, self->next->s, 0.0};
    self->at = place;
    self->course.set = 0;
    self->legs.count = 0;
    if (job->kind == NCK_JOB_START) look_anew(self, 0.0);
    else begin_follow(self, (uint32_t)is_brake);
}

// ---- follow: the plan of now, up to a place without acceleration

// From a cell's begin to no acceleration, with all the jerk. Returns 0 if the hop ends before.
static int release(nck_sshape_t *self, nck_sshape_place_t *place, const nck_sshape_hop_t *hop,
                   const nck_cell_t *cell) {
    nck_cell_t end;
    nck_sshape_pen_t pen = {&end, 0, cell->seg, cell->s, cell->v};
    const double j = cell->a > 0.0 ? -hop->piece.j : hop->piece.j;
    nck_sshape_draw(&pen, -cell->a / j, cell->a, j);
    if (!(pen.v > 0.0) || !(pen.s < hop->s_end)) return 0;
    place->s = pen.s;
    place->v = pen.v;
    if (self->next->held) end.stop = NCK_STOP_HOLD;
    push(self, &end);
    return 1;
}

// On the way down to a speed a ramp must be gone through; on the way up it may be left.
static int must_go_through(const nck_cell_t *cell) { return cell->a < 0.0 || cell->j < 0.0; }

// A hold rests within the hop if it can, else the jerk-limited planner brakes: it carries
// acceleration across junctions. What is asked of it from then on begins anew.
static void arrive(nck_sshape_t *self, const nck_sshape_hop_t *hop) {
    const double v = self->at.v;
    if (self->job.kind != NCK_JOB_BRAKE) {
        look_anew(self, v);
        return;
    }
    if (nck_sshape_length(v, 0.0, hop->piece.a, hop->piece.j) <= hop->s_end - self->at.s) {
        self->course.set = 1;
        self->course.hop = *hop;
        self->brake = self->at;
        self->phase = PHASE_BRAKE;
        return;
    }
    nck_jerk_init(&self->memory.carry, self->machine, self->link, self->now, self->next);
    nck_jerk_begin(&self->memory.carry, &self->job);
    self->phase = PHASE_CARRY;
}

// One cell of the plan of now. NCK_DONE: there is a place to plan from.
static nck_status_t follow_cell(nck_sshape_t *self, const nck_pieces_t *pieces,
                                const nck_cell_t *source) {
    const nck_sshape_view_t view = nck_sshape_view(self, pieces);
    nck_cell_t cell = *source;
    nck_sshape_hop_t hop;
    self->at.piece = nck_plan_find(pieces, self->at.piece, source);
    self->at.s = source->s;
    self->at.v = source->v;
    const uint32_t count = nck_sshape_hop_pieces(&view, self->at.piece);
    if (count == 0) return NCK_EMPTY;
    nck_sshape_hop_of(&view, self->at.piece, count, &hop);
    const int leaves = self->follows ? !must_go_through(source) : self->i == 0;
    if (source->a == 0.0 || (leaves && release(self, &self->at, &hop, source))) {
        arrive(self, &hop);
        return NCK_DONE;
    }
    cell.limit = NCK_LIMIT_ACCEL;
    if (self->next->held) cell.stop |= NCK_STOP_HOLD;
    push(self, &cell);
    self->i++;
    return NCK_OK;
}

static nck_status_t follow(nck_sshape_t *self, const nck_pieces_t *pieces) {
    for (int n = 0; n < NCK_SSHAPE_STEP; n++) {
        const nck_cell_t *const cell =
            nck_link_tail_cell(self->link, self->next->begin + self->i);
        if (!cell || self->cells == NCK_SSHAPE_PART) return NCK_FULL; // it rests as well
        const nck_status_t status = follow_cell(self, pieces, cell);
        if (status != NCK_OK) return status == NCK_DONE ? NCK_OK : status;
    }
    return NCK_OK;
}

// ---- brake

static void set_end(nck_sshape_t *self, const nck_sshape_place_t *place) {
    self->next->n = self->cells;
    self->next->end_piece = place->piece;
    self->next->end_s = place->fresh ? NCK_PLAN_BEGIN : place->s;
}

static void push_starved(nck_sshape_t *self, nck_cell_t *cell) {
    cell->limit = self->next->held ? NCK_LIMIT_ACCEL : NCK_LIMIT_STARVED;
    if (self->next->held) cell->stop |= NCK_STOP_HOLD;
    push(self, cell);
}

// The ramp in work is left, or gone through to its end.
static void leave_ramp(nck_sshape_t *self) {
    const nck_legs_t *const legs = &self->legs;
    nck_sshape_place_t *const place = &self->brake;
    nck_cell_t cell;
    nck_legs_slices(legs, legs->slices - legs->m, &cell);
    place->fresh = 0;
    place->s = cell.s;
    place->v = cell.v;
    if (cell.a == 0.0) return;
    if (!must_go_through(&cell) && release(self, place, &self->course.hop, &cell)) return;
    push_starved(self, &cell);
    for (uint32_t k = legs->k + 1; k < legs->count; k++) {
        cell = legs->cell[k];
        push_starved(self, &cell);
    }
    place->s = self->course.s;
    place->v = self->course.v;
    if (self->course.stage != STAGE_END) return;
    place->piece = self->course.hop.first + self->course.hop.count;
    place->fresh = 1;
}

static void begin_brake(nck_sshape_t *self) {
    self->next->commit = self->cells;
    self->brake = self->at;
    if (self->legs.count > 0) leave_ramp(self);
    self->phase = PHASE_BRAKE;
}

// Behind the hop.
static void leave_hop(nck_sshape_t *self, const nck_sshape_hop_t *hop, nck_cell_t *end) {
    end->last = hop->last;
    self->brake.piece = hop->first + hop->count;
    self->brake.fresh = 1;
}

// The brake comes to rest in the hop, or at its end if what is left is rounding.
static void come_to_rest(nck_sshape_t *self, const nck_pieces_t *pieces,
                         const nck_sshape_hop_t *hop, const nck_sshape_pen_t *pen) {
    nck_cell_t *const end = &pen->cells[pen->count - 1];
    nck_cell_t behind = *end;
    end->stop = NCK_STOP_REST;
    behind.s = pen->s;
    self->brake.piece = nck_plan_find(pieces, self->next->piece, &behind);
    self->brake.fresh = 0;
    self->brake.s = pen->s;
    if (hop->s_end - pen->s <= NCK_SSHAPE_EPSILON * hop->piece.length) leave_hop(self, hop, end);
}

// Through one hop, as slow as it gets.
static void brake_hop(nck_sshape_t *self, const nck_pieces_t *pieces) {
    const int within = self->course.set && !self->brake.fresh;
    nck_sshape_hop_t hop = self->course.hop;
    if (within) nck_sshape_hop_from(&hop, self->brake.s);
    else hop = nck_sshape_hop_at(self, pieces, &self->brake);
    const double v = self->brake.v;
    const double slowest = nck_sshape_slowest_end(&hop.piece, v, nck_sshape_end_most(self, &hop));
    const double length = nck_sshape_length(v, slowest, hop.piece.a, hop.piece.j);
    const int exact = slowest > 0.0 ? slowest == v : length <= hop.piece.length;
    nck_cell_t cells[NCK_SSHAPE_CELLS];
    nck_sshape_pen_t pen = {cells, 0, hop.seg, hop.s, v};
    nck_sshape_draw_ramp(&pen, &hop.piece, slowest, exact ? 1.0 : hop.piece.length / length);
    if (pen.count == 0) nck_sshape_draw(&pen, hop.piece.length / v, 0.0, 0.0); // too short to brake
    self->brake.v = slowest;
    if (slowest > 0.0) leave_hop(self, &hop, &cells[pen.count - 1]);
    else come_to_rest(self, pieces, &hop, &pen);
    for (uint32_t i = 0; i < pen.count; i++) push_starved(self, &cells[i]);
}

static nck_status_t build_brake(nck_sshape_t *self, const nck_pieces_t *pieces) {
    for (int n = 0; n < BRAKE_STEP && self->brake.v > 0.0; n++) {
        const int fresh = self->brake.fresh != 0; // else its first piece may be gone
        if (fresh && !nck_plan_piece(pieces, self->brake.piece)) return NCK_E_INTERNAL;
        brake_hop(self, pieces);
    }
    if (self->brake.v > 0.0) return NCK_OK;
    if (self->job.kind == NCK_JOB_BRAKE) {
        self->next->commit = self->cells;
        self->next->complete = 1;
    }
    set_end(self, &self->brake);
    return NCK_DONE;
}

// ---- part

static void set_course(nck_sshape_t *self, const nck_pieces_t *pieces) {
    self->course.hop = nck_sshape_hop_at(self, pieces, &self->at);
    const nck_sshape_hop_t *const hop = &self->course.hop;
    self->course.set = 1;
    self->course.stage = STAGE_RISE;
    if (!(hop->piece.length > 0.0)) return;
    const double most = nck_sshape_end_most(self, hop);
    const double v_out = nck_sshape_fastest_end(&hop->piece, self->at.v, most);
    nck_sshape_plan(&hop->piece, self->at.v, v_out, &self->course.way);
}

// The cruise is measured from the hop's end; half of it is never rounding.
static void draw_cruise(const nck_sshape_t *self, nck_sshape_pen_t *pen) {
    const nck_sshape_hop_t *const hop = &self->course.hop;
    const nck_sshape_course_t *const way = &self->course.way;
    const double fall = nck_sshape_length(way->peak, way->v_out, hop->piece.a, hop->piece.j);
    const double left = nck_max(0.5 * way->cruise, hop->s_end - pen->s - fall);
    nck_sshape_draw(pen, left / way->peak, 0.0, 0.0);
    pen->cells[pen->count - 1].limit = hop->limit;
}

// Down to the end's speed. What the horizon alone asks for is told.
static void draw_fall(const nck_sshape_t *self, nck_sshape_pen_t *pen) {
    const nck_sshape_hop_t *const hop = &self->course.hop;
    const nck_sshape_course_t *const way = &self->course.way;
    const int open = (int32_t)(hop->first + hop->count - self->memory.ahead.capped) > 0;
    nck_sshape_draw_ramp(pen, &hop->piece, way->v_out, way->stretch);
    for (uint32_t i = 0; open && i < pen->count; i++) pen->cells[i].limit = NCK_LIMIT_LOOKAHEAD;
}

// Stages without length are left out.
static void go_on(nck_sshape_t *self) {
    const nck_sshape_course_t *const way = &self->course.way;
    uint32_t *const stage = &self->course.stage;
    ++*stage;
    if (*stage == STAGE_CRUISE && !(way->cruise > 0.0)) ++*stage;
    if (*stage == STAGE_FALL && way->peak == way->v_out) ++*stage;
}

static void draw_stage(nck_sshape_t *self, nck_sshape_pen_t *pen) {
    const nck_sshape_hop_t *const hop = &self->course.hop;
    const nck_sshape_course_t *const way = &self->course.way;
    switch (self->course.stage) {
    case STAGE_RISE: nck_sshape_draw_ramp(pen, &hop->piece, way->peak, way->stretch); break;
    case STAGE_CRUISE: draw_cruise(self, pen); break;
    default: draw_fall(self, pen); break;
    }
    go_on(self);
}

// A dwell or a wait.
static void draw_rest(nck_sshape_t *self, const nck_pieces_t *pieces, nck_sshape_pen_t *pen) {
    const nck_node_t *const node = nck_plan_piece(pieces, self->at.piece);
    memset(pen->cells, 0, sizeof *pen->cells);
    pen->cells->seg = node->seg;
    pen->cells->s = node->s;
    pen->cells->duration = node->standstill.dwell_s;
    pen->cells->limit = node->limit_piece;
    pen->count = 1;
    pen->v = 0.0;
    self->course.stage = STAGE_END;
}

// The next stage of the course that draws anything.
static void begin_stage(nck_sshape_t *self, const nck_pieces_t *pieces) {
    const nck_sshape_hop_t *const hop = &self->course.hop;
    const double s = self->at.fresh ? hop->s : self->at.s;
    nck_sshape_pen_t pen = {self->legs.cell, 0, hop->seg, s, self->at.v};
    if (!(hop->piece.length > 0.0)) draw_rest(self, pieces, &pen);
    while (pen.count == 0) draw_stage(self, &pen);
    self->course.s = pen.s;
    self->course.v = pen.v;
    self->legs.count = pen.count;
    nck_legs_begin(&self->legs, self->machine->period_s);
    if (self->course.stage != STAGE_END) return;
    nck_cell_t *const end = &self->legs.cell[pen.count - 1];
    end->last = hop->last;
    if (pen.v > 0.0) return;
    const int holds = nck_sshape_ends_block(self, pieces, hop->first + hop->count - 1);
    self->course.held = holds ? (uint32_t)NCK_HELD_BLOCK : (uint32_t)NCK_HELD_NOT;
    end->stop = (uint8_t)(NCK_STOP_REST | (holds ? NCK_STOP_HOLD : 0));
}

static void draw_slice(nck_sshape_t *self) {
    nck_cell_t cell;
    const int ends = nck_legs_next(&self->legs, self->machine->period_s, &cell);
    push(self, &cell);
    self->time += cell.duration;
    if (!ends) return;
    self->at.fresh = 0;
    self->at.s = self->course.s;
    self->at.v = self->course.v;
    if (self->course.stage != STAGE_END) return;
    self->at.piece = self->course.hop.first + self->course.hop.count;
    self->at.fresh = 1;
    self->course.set = 0;
}

// 1 if the course comes to a rest soon that the next plan may overlap: its end is in one part.
static int nears_overlap(const nck_sshape_t *self, const nck_pieces_t *pieces) {
    const nck_sshape_hop_t *const hop = &self->course.hop;
    const nck_cell_t *const cell = nck_link_built_cell(self->link, self->cells - 1);
    const nck_node_t *const end = nck_plan_piece(pieces, hop->first + hop->count - 1);
    if (!cell || !end || cell->seg != end->seg || self->course.way.v_out > 0.0) return 0;
    const double left = end->s + end->length - (cell->s + cell->length);
    return left < OVERLAP_NEAR * nck_link_seg(self->link, end->seg)->overlap;
}

static int part_is_full(const nck_sshape_t *self, const nck_pieces_t *pieces) {
    const uint32_t count = self->at.piece + NCK_SSHAPE_HOP - self->next->piece;
    if (self->cells >= PART_DRAWN || (int32_t)count > NCK_SSHAPE_PIECES) return 1;
    const int overlaps = self->job.kind == NCK_JOB_START && self->now->withheld > 0;
    const double most = overlaps ? OVERLAP_PERIODS : PART_PERIODS;
    return self->time >= most * self->machine->period_s && !nears_overlap(self, pieces);
}

static nck_status_t build_part(nck_sshape_t *self, const nck_pieces_t *pieces) {
    if (!self->course.set) set_course(self, pieces);
    for (int n = 0; n < NCK_SSHAPE_STEP; n++) {
        if (self->legs.count == 0) begin_stage(self, pieces);
        draw_slice(self);
        const int ends = !self->course.set;
        if (ends && !(self->at.v > 0.0)) {
            self->next->commit = self->cells;
            self->next->complete = 1;
            self->next->held = self->course.held;
            set_end(self, &self->at);
            return NCK_DONE;
        }
        if (part_is_full(self, pieces)) begin_brake(self);
        else if (ends) self->phase = PHASE_LOOK;
        if (self->phase != PHASE_PART) return NCK_OK;
    }
    return NCK_OK;
}

// ---- look

// A ramp gone through may be a part already.
static void enter_part(nck_sshape_t *self, const nck_pieces_t *pieces) {
    if (part_is_full(self, pieces)) begin_brake(self);
    else self->phase = PHASE_PART;
}

// Whether the path can brake for what lies ahead. Else a ramp that has been left is gone through;
// then a block's end that comes too early to rest at is passed.
static nck_status_t join(nck_sshape_t *self, const nck_pieces_t *pieces) {
    const nck_sshape_hop_t hop = nck_sshape_hop_at(self, pieces, &self->at);
    const uint32_t horizon = self->memory.ahead.horizon;
    const double most = nck_sshape_brakeable(&hop.piece, nck_sshape_end_most(self, &hop));
    if (self->at.v <= most * (1.0 + JOIN_EPSILON)) {
        self->checks = 0;
        enter_part(self, pieces);
    } else if (!self->follows) {
        begin_follow(self, 1);
    } else if (nck_sshape_ends_block(self, pieces, horizon - 1)) {
        self->skip = horizon;
        self->memory.ahead.looks = 1;
    } else {
        return NCK_E_STATE;
    }
    return NCK_OK;
}

// Where pieces are missing the part ends. How a path is divided into parts does not change how it
// is passed.
static nck_status_t look(nck_sshape_t *self, const nck_pieces_t *pieces) {
    const nck_status_t status = nck_sshape_look(self, pieces);
    if (status == NCK_DONE && self->checks) return join(self, pieces);
    if (status == NCK_DONE) enter_part(self, pieces);
    if (status != NCK_EMPTY) return NCK_OK;
    if (self->cells == 0 || self->checks) return NCK_EMPTY;
    begin_brake(self);
    return NCK_OK;
}

// ---- step

nck_status_t nck_sshape_step(nck_sshape_t *self, const nck_pieces_t *pieces) {
    if (!NCK_HAS_SSHAPE) return NCK_E_INTERNAL;
    switch (self->phase) {
    case PHASE_FOLLOW: return follow(self, pieces);
    case PHASE_LOOK: return look(self, pieces);
    case PHASE_PART: return build_part(self, pieces);
    case PHASE_BRAKE: return build_brake(self, pieces);
    default: return nck_jerk_step(&self->memory.carry, pieces);
    }
}

void nck_sshape_hurry(nck_sshape_t *self) { self->job.starved = 1; }
