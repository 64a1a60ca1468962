// SPDX-License-Identifier: MIT
// Room 5, slope: the acceleration-limited planner.
#include "nck/prep/5_slope/linear.h"

#include <string.h> // memset

#include "nck/base/envelope_math.h" // nck_envelope_…
#include "nck/base/real.h"          // nck_max
#include "nck/prep/5_slope/linear_left.h" // nck_linear_left
#include "nck/prep/5_slope/trapezoid.h" // nck_trapezoid_legs nck_trapezoid_brake

enum {
    PASS_STEP = 32, // nodes, or cells, in one bounded step
    PHASE_VIEW = 0, PHASE_FLOOR, PHASE_BACKWARD, PHASE_FORWARD, PHASE_PART, PHASE_BRAKE
};

// An envelope joins the speed that it is entered with within this share.
#define JOIN_EPSILON 1e-9
// Where braking leaves less than this share of v², it ends at rest but for rounding.
#define FLOOR_EPSILON (0.1 * JOIN_EPSILON)

void nck_linear_init(nck_linear_t *self, const nck_machine_t *machine, nck_link_t *link,
                     nck_plan_t *next) {
    memset(self, 0, sizeof *self);
    self->machine = machine;
    self->link = link;
    self->next = next;
    self->at.fresh = 1;
}

// ---- what a piece allows under the wishes

static inline double cap_inside(const nck_linear_t *self, const nck_node_t *piece) {
    if (self->is_plain) return piece->vv_piece;
    return nck_plan_cap(piece, &self->job.wish, self->next->over);
}

// At the start of a piece that is there.
static double cap_at(const nck_linear_t *self, const nck_pieces_t *pieces, uint32_t number,
                     const nck_node_t *piece) {
    if (self->is_plain) return piece->vv_cap;
    return nck_plan_at(pieces, number, &self->job.wish, self->next->over);
}

static double accel_of(const nck_linear_t *self, const nck_node_t *piece) {
    return !self->is_plain && self->next->over ? piece->a_over : piece->a;
}

static double end_of(const nck_node_t *piece) { return piece->s + piece->length; }

static double s_of(const nck_node_t *piece, const nck_linear_place_t *place) {
    return place->fresh ? piece->s : place->s;
}

// What a place leaves of its piece.
static double length_left(const nck_node_t *piece, const nck_linear_place_t *place) {
    return place->fresh ? piece->length : end_of(piece) - place->s;
}

// What the acceleration changes v² by over a piece that is there; over the first one, from where
// the plan begins.
static double gain_over(const nck_linear_t *self, uint32_t number, const nck_node_t *piece) {
    const int is_first = number == self->at.piece;
    const double length = is_first ? length_left(piece, &self->at) : piece->length;
    return nck_envelope_h(accel_of(self, piece), length);
}

// ---- begin

static void enter_part(nck_linear_t *self) {
    nck_link_tail_begin(self->link);
    self->part = 0;
    self->phase = PHASE_PART;
}

static void enter_brake(nck_linear_t *self) {
    self->brake = self->at;
    self->phase = PHASE_BRAKE;
}

void nck_linear_begin(nck_linear_t *self, const nck_job_t *job) {
    self->job = *job;
    self->is_plain = (uint8_t)nck_plan_is_plain(&job->wish, self->next->over);
    self->part = 0;
    self->skip = self->next->piece;
    // Where the last part ended v² is known to the bit.
    const int goes_on = !job->anew && self->at.piece == self->next->piece
                        && (self->at.fresh || self->at.s == self->next->s);
    if (!goes_on) {
        self->at.piece = self->next->piece;
        self->at.fresh = 0;
        self->at.s = self->next->s;
        self->at.vv = job->v * job->v;
        self->final = self->at.piece;
        self->legs.count = 0;
    }
    if (job->kind == NCK_JOB_BRAKE) {
        self->next->held = job->held;
        nck_link_tail_begin(self->link);
        enter_brake(self);
    } else if (self->at.piece != self->final) {
        enter_part(self);
    } else {
        self->phase = PHASE_VIEW;
    }
}

// ---- the envelope: v² at every node

// The first piece that the look-ahead does not see. Returns 1 if that is as far as it may.
static int find_end(nck_linear_t *self, const nck_pieces_t *pieces) {
    const uint32_t blocks = self->machine->lookahead_blocks;
    const uint32_t first = self->at.piece;
    const uint32_t known = pieces->head + pieces->fill - first;
    self->end = first + (known < NCK_LINEAR_VIEW ? known : NCK_LINEAR_VIEW);
    if (blocks > 0) {
        const nck_node_t *const begin = nck_plan_piece(pieces, first);
        uint32_t i = first;
        while (i != self->end
               && !nck_plan_is_beyond(self->link, begin, nck_plan_piece(pieces, i), blocks)) {
            i++;
        }
        if (i != self->end) {
            self->end = i;
            return 1;
        }
    }
    return self->end - first == NCK_LINEAR_VIEW;
}

// Pieces that stay in the stop tail, so that a path that has starved says so. From rest: none.
static uint32_t keeps(const nck_linear_t *self) { return self->job.kind == NCK_JOB_GO_ON; }

// How many pieces become final by this envelope. Depends on counts alone, never on time, so that
// equal capacities give equal setpoints; but for what comes too late. 0: more must come first.
static uint32_t find_final(const nck_linear_t *self, const nck_pieces_t *pieces, int is_far) {
    const uint32_t seen = self->end - self->at.piece;
    const uint32_t barrier = pieces->head + pieces->barrier - self->at.piece;
    const int has_barrier = pieces->barrier > 0 && (int32_t)barrier > 0 && barrier <= seen;
    if (pieces->complete && self->end == pieces->head + pieces->fill) return seen;
    const int takes = is_far || (self->job.starved && seen > keeps(self));
    const uint32_t some = takes ? 1 + (seen - 1) / NCK_LINEAR_FINAL : 0;
    return has_barrier && barrier > some ? barrier : some;
}

// 1 if an envelope is all by the caps of room 4.
static int is_by_caps(const nck_linear_t *self) {
    return self->is_plain && !self->job.wish.single_block;
}

// Up to which node the last envelope still holds from the next one on: what it has found there by
// the caps alone, this one would find again.
static uint32_t known_end(const nck_linear_t *self) {
    const int is_known = is_by_caps(self) && !self->job.anew
                         && (int32_t)(self->at.piece + 1 - self->known.begin) >= 0;
    return is_known ? self->known.end : self->at.piece;
}

static nck_status_t begin_pass(nck_linear_t *self, const nck_pieces_t *pieces) {
    if (!nck_plan_piece(pieces, self->at.piece)) return NCK_EMPTY;
    const int is_far = find_end(self, pieces);
    const uint32_t final = find_final(self, pieces, is_far);
    if (final == 0) {
        const int takes_any = self->machine->lookahead_blocks > 0 || self->job.starved;
        if (!takes_any) self->next->wants = self->at.piece + NCK_LINEAR_VIEW;
        return NCK_EMPTY;
    }
    self->final = self->at.piece + final;
    self->held = NCK_HELD_NOT;
    self->pass.i = self->at.piece + 1;
    self->pass.floor = self->pass.i;
    self->pass.vv = self->at.vv;
    self->pass.known = known_end(self);
    self->known.end = self->known.begin;
    self->phase = PHASE_FLOOR;
    return NCK_OK;
}

// Under other wishes the path may be faster than its caps allow: it brakes with all of a, as the
// plan of now can.
static void raise_floor(nck_linear_t *self, const nck_pieces_t *pieces) {
    const int raises = self->job.anew && self->job.kind == NCK_JOB_GO_ON;
    for (int n = 0; raises && n < PASS_STEP; n++) {
        if (self->pass.i == self->end || !(self->pass.vv > 0.0)) break;
        const uint32_t number = self->pass.i - 1;
        const nck_node_t *const piece = nck_plan_piece(pieces, number);
        const double s = number == self->at.piece ? s_of(piece, &self->at) : piece->s;
        const double loss = nck_envelope_h(piece->a, end_of(piece) - s);
        const double left = self->pass.vv - loss;
        self->pass.vv = left > FLOOR_EPSILON * self->at.vv ? left : 0.0;
        nck_plan_piece(pieces, self->pass.i)->vv = self->pass.vv;
        self->pass.i++;
    }
    if (raises && self->pass.i != self->end && self->pass.vv > 0.0) return;
    self->pass.floor = self->pass.i;
    self->pass.i = self->end;
    self->pass.vv = 0.0;
    self->pass.open = !nck_plan_piece(pieces, self->end - 1)->stop;
    self->phase = PHASE_BACKWARD;
}

// Single block rests at the end of the piece before this node.
static int rests_at(const nck_linear_t *self, const nck_pieces_t *pieces, uint32_t number) {
    if (!self->job.wish.single_block || (int32_t)(number - self->skip) <= 0) return 0;
    return nck_plan_ends_block(self->link, pieces, number - 1);
}

// vv_i = min(vv_cap,i, vv_{i+1} + h_i) from the view's end, where the path must be able to rest.
// Returns 1 where the last envelope, which comes to rest sooner, is met at a cap: what is before it
// is as it was.
static int backward_node(nck_linear_t *self, const nck_pieces_t *pieces, uint32_t number) {
    nck_node_t *const node = nck_plan_there(pieces, number);
    const int is_known = (int32_t)(self->pass.known - number) > 0 && !node->open;
    const double h = nck_envelope_h(accel_of(self, node), node->length);
    double cap = cap_at(self, pieces, number, node);
    if ((int32_t)(self->pass.floor - number) > 0) cap = nck_max(cap, node->vv);
    if (!(self->pass.vv + h < cap)) self->pass.open = 0;
    self->pass.vv = nck_envelope_backward(cap, self->pass.vv, h);
    if (is_known && !self->pass.open && self->pass.vv == node->vv) return 1;
    node->open = (uint8_t)self->pass.open;
    if (rests_at(self, pieces, number)) {
        self->pass.vv = 0.0;
        self->final = number;
        self->held = NCK_HELD_BLOCK;
        self->pass.open = 0;
    }
    node->vv = self->pass.vv;
    return 0;
}

// The envelope has come to where the plan begins: it must be as high as the path is fast. A block's
// end that comes too early to rest at is passed.
static nck_status_t join(nck_linear_t *self, const nck_pieces_t *pieces) {
    nck_node_t *const node = nck_plan_there(pieces, self->at.piece);
    const double reach = self->pass.vv + gain_over(self, self->at.piece, node);
    const int open = self->pass.open && reach < cap_at(self, pieces, self->at.piece, node);
    node->open = (uint8_t)open;
    self->pass.i = self->at.piece;
    self->pass.vv = self->at.vv;
    self->phase = PHASE_FORWARD;
    if (self->at.vv <= reach * (1.0 + JOIN_EPSILON)) return NCK_OK;
    if (self->held != NCK_HELD_BLOCK) return NCK_E_STATE;
    self->skip = self->final;
    self->phase = PHASE_VIEW;
    return NCK_OK;
}

static nck_status_t pass_backward(nck_linear_t *self, const nck_pieces_t *pieces) {
    const uint32_t first = self->at.piece + 1;
    for (int n = 0; n < PASS_STEP; n++) {
        if (self->pass.i == first) return join(self, pieces);
        self->pass.i--;
        if (!backward_node(self, pieces, self->pass.i)) continue;
        self->pass.i = first;
        self->pass.vv = nck_plan_piece(pieces, first)->vv;
    }
    return NCK_OK;
}

// What is behind the final pieces holds for the next envelope, too, if it is by the caps.
static void end_envelope(nck_linear_t *self) {
    const int is_known = is_by_caps(self);
    self->known.begin = self->final + 1;
    self->known.end = is_known && self->pass.floor == self->at.piece + 1 ? self->end : self->final;
}

// vv_{i+1} = min(vv_{i+1}, vv_i + h_i) over the pieces that become final.
static void pass_forward(nck_linear_t *self, const nck_pieces_t *pieces) {
    const uint32_t last = self->final == self->end ? self->end - 1 : self->final;
    uint32_t number = self->pass.i;
    double vv = self->pass.vv;
    nck_node_t *next = nck_plan_there(pieces, number);
    for (int n = 0; n < PASS_STEP && number != last; n++) {
        const double gain = gain_over(self, number, next);
        next = nck_plan_behind(pieces, next);
        vv = nck_envelope_forward(next->vv, vv, gain);
        next->vv = vv;
        number++;
    }
    self->pass.i = number;
    self->pass.vv = vv;
    if (number != last) return;
    end_envelope(self);
    enter_part(self);
}

// ---- the part that may become final

static inline nck_span_t span_of(const nck_linear_t *self, const nck_node_t *piece,
                          const nck_linear_place_t *place) {
    const nck_span_t span = {s_of(piece, place), length_left(piece, place), place->vv, 0.0,
                             cap_inside(self, piece), accel_of(self, piece)};
    return span;
}

static void begin_piece(nck_linear_t *self, const nck_pieces_t *pieces, nck_node_t *piece) {
    nck_span_t span = span_of(self, piece, &self->at);
    const uint32_t behind = self->at.piece + 1;
    const int rests = behind == self->end || (behind == self->final && self->held);
    span.vv_out = rests ? 0.0 : nck_plan_behind(pieces, piece)->vv;
    self->vv_out = span.vv_out;
    const double period = self->machine->period_s;
    self->legs.count = (uint32_t)nck_trapezoid_legs(piece, &span, period, self->legs.cell);
    nck_legs_begin(&self->legs, period);
}

// How the path rests behind the piece in work, but for a stop of its own.
static uint8_t stop_behind(const nck_linear_t *self) {
    const uint32_t behind = self->at.piece + 1;
    if (self->held && behind == self->final) return NCK_STOP_REST | NCK_STOP_HOLD;
    return behind == self->end ? NCK_STOP_REST : 0;
}

// Returns 1 if the piece is drawn, and left at once.
static int draw_slice(nck_linear_t *self) {
    nck_cell_t *const cell = nck_link_tail_room(self->link);
    const int ends = nck_legs_next(&self->legs, self->machine->period_s, cell);
    if (ends) {
        cell->stop |= stop_behind(self);
    } else {
        const int begins = self->legs.m == 0; // where a leg ends, the next one knows better
        const double v_end = cell->v + cell->a * cell->duration;
        const double v = begins ? self->legs.cell[self->legs.k].v : v_end;
        self->at.fresh = 0;
        self->at.s = cell->s + cell->length;
        self->at.vv = v * v;
    }
    nck_link_tail_placed(self->link, cell);
    self->part++;
    return ends;
}

static void set_end(nck_linear_t *self, const nck_linear_place_t *place) {
    self->next->end_piece = place->piece;
    self->next->end_s = place->fresh ? NCK_PLAN_BEGIN : place->s;
}

// The part ends at rest. Single block holds it there only behind the last final piece.
static nck_status_t finish_at_rest(nck_linear_t *self) {
    const uint32_t held = self->at.piece == self->final ? self->held : (uint32_t)NCK_HELD_NOT;
    self->next->n = self->part;
    self->next->commit = self->part;
    self->next->complete = 1;
    self->next->held = held;
    self->at.vv = 0.0;
    set_end(self, &self->at);
    return NCK_DONE;
}

// The part ends where the brake begins.
static nck_status_t end_part(nck_linear_t *self) {
    if (!(self->at.vv > 0.0)) return finish_at_rest(self);
    enter_brake(self);
    return NCK_OK;
}

// One more cell. at: the piece that it is of, or behind it.
static inline nck_status_t draw_one(nck_linear_t *self, const nck_pieces_t *pieces,
                                    nck_node_t **at) {
    nck_node_t *const piece = *at;
    if (self->part == NCK_LINEAR_PART) return end_part(self);
    if (self->legs.count == 0) {
        if (self->at.piece == self->final) return end_part(self);
        begin_piece(self, pieces, piece);
    }
    if (!draw_slice(self)) return NCK_EMPTY;
    *at = nck_plan_behind(pieces, piece);
    self->at.piece++;
    self->at.fresh = 1;
    self->at.vv = self->vv_out; // its envelope to the bit
    const int rests = piece->stop || !(piece->length > 0.0);
    return rests ? finish_at_rest(self) : NCK_EMPTY; // a tail has one rest, at its end
}

static nck_status_t draw_part(nck_linear_t *self, const nck_pieces_t *pieces) {
    nck_node_t *piece = nck_plan_there(pieces, self->at.piece);
    for (int n = 0; n < PASS_STEP; n++) {
        const nck_status_t status = draw_one(self, pieces, &piece);
        if (status != NCK_EMPTY) return status;
    }
    return NCK_OK;
}

// ---- the brake behind it

// A hold brakes with what is left at the speed that it has by then.
static nck_status_t brake_piece(nck_linear_t *self, const nck_pieces_t *pieces) {
    nck_linear_place_t *const place = &self->brake;
    const nck_node_t *const piece = nck_plan_piece(pieces, place->piece);
    const nck_node_t *const behind = nck_plan_piece(pieces, place->piece + 1);
    nck_span_t span = span_of(self, piece, place);
    span.vv_out = behind ? behind->vv_cap : 0.0;
    if (NCK_HAS_POLYGONS && self->next->held) {
        const double period = self->machine->period_s;
        span.a = nck_linear_left(pieces, place->piece, place->vv, self->next->over, period);
    }
    nck_cell_t cell;
    const int rests = nck_trapezoid_brake(piece, &span, &cell);
    const int is_whole = !(cell.length < span.length);
    if (self->next->held) {
        cell.stop |= NCK_STOP_HOLD;
        cell.limit = NCK_LIMIT_ACCEL;
    }
    nck_link_tail_push(self->link, &cell);
    self->next->n++;
    place->vv = rests ? 0.0 : nck_max(0.0, span.vv_in - 2.0 * span.a * span.length);
    place->fresh = (uint32_t)is_whole;
    place->s = span.s + cell.length;
    if (is_whole) place->piece++;
    return rests ? NCK_DONE : NCK_EMPTY;
}

static nck_status_t draw_brake(nck_linear_t *self, const nck_pieces_t *pieces) {
    for (int n = 0; n < PASS_STEP; n++) {
        if (brake_piece(self, pieces) != NCK_DONE) continue;
        const int is_hold = self->job.kind == NCK_JOB_BRAKE;
        self->next->commit = self->part;
        self->next->n += self->part;
        self->next->complete = (uint32_t)is_hold;
        if (is_hold) self->next->commit = self->next->n;
        set_end(self, &self->brake);
        return NCK_DONE;
    }
    return NCK_OK;
}

nck_status_t nck_linear_step(nck_linear_t *self, const nck_pieces_t *pieces) {
    switch (self->phase) {
    case PHASE_VIEW: return begin_pass(self, pieces);
    case PHASE_FLOOR: raise_floor(self, pieces); return NCK_OK;
    case PHASE_BACKWARD: return pass_backward(self, pieces);
    case PHASE_FORWARD: pass_forward(self, pieces); return NCK_OK;
    case PHASE_PART: return draw_part(self, pieces);
    default: return draw_brake(self, pieces);
    }
}

void nck_linear_hurry(nck_linear_t *self) { self->job.starved = 1; }
