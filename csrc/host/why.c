// SPDX-License-Identifier: MIT
// Pieces of a plan with their time, and to what it is lost.
#include "host/why.h"

#include <stddef.h> // offsetof
#include <string.h> // memcpy memset

#include "nck/base/cell_math.h" // nck_cell_way nck_cell_speed
#include "nck/base/path.h"      // nck_path_tangent_part
#include "nck/base/real.h"      // nck_sqrt nck_fabs nck_min nck_max
#include "nck/base/trig.h"      // nck_atan2

// A speed is held by a cap from this share of it on.
#define HELD 0.995
// Two speeds are the same within this share.
#define SAME 1e-3
// A clocked path has a low point where the speed is lower by this share than before and behind it:
// less is what its plan may be away from the fastest motion (5_slope/optimal.c).
#define LOW 0.02
// Two places of the path are the same within so much [path mm].
#define NEAR 1e-9
// A corner is one from this angle on [rad]: less is rounding.
#define LEAST_ANGLE 1e-6
// Newton's method doubles the digits of a start that is good to one.
#define NEWTON_ROUNDS 12

// The corner between the tangents a and b at a seg's start.
static void meet(nck_host_why_seg_t *row, const double *a, const double *b,
                 const nck_terms_t *terms) {
    const nck_axis_t *const axis = terms->machine->axis;
    double load = 0.0; // of the axis whose acceleration the jump takes most of
    for (int x = 0; x < terms->axes; x++) {
        const double of_axis = axis[x].present ? nck_fabs(a[x] - b[x]) / axis[x].a_max : 0.0;
        row->less += (a[x] - b[x]) * (a[x] - b[x]);
        row->more += (a[x] + b[x]) * (a[x] + b[x]);
        if (of_axis > load) {
            load = of_axis;
            row->axis = (uint16_t)x;
        }
    }
}

// The angle between the unit vectors a and b at a seg's start: 2·atan2(|a − b|, |a + b|).
static double angle_of(const nck_host_why_seg_t *seg) {
    return 2.0 * nck_atan2(nck_sqrt(seg->less), nck_sqrt(seg->more));
}

static nck_host_why_seg_t *seg_at(nck_host_why_t *self, uint32_t seq) {
    return &self->segs[seq & (NCK_HOST_WHY_SEGS - 1)];
}

nck_host_why_seg_t *nck_host_why_at(nck_host_why_t *self, uint32_t seq) {
    return seg_at(self, seq);
}

void nck_host_why_init(nck_host_why_t *self, nck_t *nck) {
    memset(self, 0, offsetof(nck_host_why_t, segs));
    self->nck = nck;
    self->link = nck_link_of(nck);
}

void nck_host_why_row(nck_host_why_seg_t *row, double tangent[NCK_AXIS_MAX], const nck_seg_t *seg,
                      const nck_terms_t *terms) {
    const int moves = seg->length > 0.0;
    double here[NCK_AXIS_MAX] = {0.0};
    memset(row, 0, sizeof *row);
    row->line = seg->line;
    row->s_begin = seg->s_begin;
    row->stop = seg->stop;
    row->clocked = seg->kind == NCK_SEG_SPLINE || seg->keeps == NCK_KEEP_REST;
    row->axis = NCK_AXIS_MAX;
    if (moves) nck_path_tangent_part(seg, 0.0, terms->axes, here);
    if (moves && seg->seq > 0) meet(row, tangent, here, terms);
    if (moves && seg->kind != NCK_SEG_LINE) {
        nck_path_tangent_part(seg, seg->length, terms->axes, here);
    }
    memcpy(tangent, here, sizeof here);
}

// What a node says of itself and the piece behind it.
static void fill_piece(nck_host_why_t *self, nck_host_why_piece_t *row, const nck_node_t *node) {
    memset(row, 0, sizeof *row);
    row->seg = node->seg;
    row->limit = node->limit;
    row->limit_piece = node->limit_piece;
    row->kind = node->kind;
    row->rapid = !(node->feed > 0.0);
    row->s_end = seg_at(self, node->seg)->s_begin + node->s + node->length;
    row->v_node = nck_sqrt(node->vv_cap);
    row->v_cap = nck_sqrt(node->vv_piece);
    row->v_feed = row->rapid ? row->v_cap : nck_max(node->feed, row->v_cap);
}

static nck_host_why_piece_t *piece_at(nck_host_why_t *self, uint32_t number) {
    return &self->pieces[number & (NCK_HOST_WHY_PIECES - 1)];
}

void nck_host_why_node(nck_host_why_t *self, const nck_node_t *node) {
    const int is_taken = (int32_t)(self->taken - self->told) > 0;
    if (!is_taken && self->told - self->taken == NCK_HOST_WHY_PIECES) self->broken = 1;
    if (!is_taken) fill_piece(self, piece_at(self, self->told), node);
    self->told++;
}

// ---- low points

// Behind its two ramps a low point is done with.
static void settle_low(nck_host_why_t *self) {
    self->low.lost_s += self->up.lost_s;
    nck_host_trail_settle(&self->trail, &self->low);
    nck_host_cause_sum(&self->limit_s[self->low.limit], self->up.limit_s);
    nck_host_cause_add(self->causes, &self->low);
}

static void settle_cap(nck_host_why_t *self) {
    if (self->cap.lost_s != 0.0) nck_host_cause_add(self->causes, &self->cap);
    self->cap.lost_s = 0.0;
}

// The ramps before a low point are parted between it and the last one.
static void end_ramps(nck_host_why_t *self, const nck_host_low_t *low) {
    if (self->has_low) {
        settle_low(self);
    } else {
        self->down.lost_s += self->up.lost_s;
        self->down.limit_s += self->up.limit_s;
    }
    self->low = *low;
    self->low.lost_s = self->down.lost_s;
    nck_host_cause_sum(&self->limit_s[low->limit], self->down.limit_s);
    memset(&self->up, 0, sizeof self->up);
    memset(&self->down, 0, sizeof self->down);
    self->has_low = 1;
    self->slow.is = 0;
    self->v_most = self->v;
}

// The path is at a low point.
static void take_low(nck_host_why_t *self, const nck_host_low_t *low) {
    end_ramps(self, low);
    nck_host_trail_low(&self->trail);
}

// The source line at a place of the piece in work.
static uint32_t line_at(const nck_host_why_t *self, double s) {
    const nck_seg_t *const seg = nck_link_seg(self->link, self->piece.seg);
    return nck_marks_line(&self->link->marks, seg, s - seg->s_begin, &(uint32_t){0});
}

static int is_rest(uint32_t kind) { return kind == NCK_SEG_DWELL || kind == NCK_SEG_WAIT; }

// What holds the path between two pieces: at a stop what that is for, a rest of the program, a
// thread, smoothing that begins or ends; else the piece's own limit.
static uint32_t reason_of(nck_host_why_t *self, const nck_host_why_piece_t *before) {
    const nck_host_why_piece_t *const piece = &self->piece;
    const nck_host_why_piece_t *const rest = is_rest(piece->kind) ? piece : before;
    const int is_clocked = seg_at(self, rest->seg)->clocked;
    if (is_rest(rest->kind) && is_clocked) return NCK_LIMIT_MODE;
    if (is_rest(rest->kind)) return rest->kind == NCK_SEG_WAIT ? NCK_LIMIT_WAIT : NCK_LIMIT_DWELL;
    if (piece->limit != NCK_LIMIT_EXACT_STOP) return piece->limit;
    if (piece->kind >= NCK_SEG_THREAD || before->kind >= NCK_SEG_THREAD) return NCK_LIMIT_THREAD;
    return is_clocked && !seg_at(self, piece->seg)->clocked ? NCK_LIMIT_MODE : piece->limit;
}

// 1 if the path rests at the start of the piece in work for its corner alone: nothing asks for it.
static int is_stopped_at(nck_host_why_t *self, const nck_host_why_piece_t *before, uint32_t limit) {
    const nck_host_why_piece_t *const piece = &self->piece;
    return limit == NCK_LIMIT_EXACT_STOP && !(piece->v_node > 0.0)
           && piece->seg != before->seg && !seg_at(self, before->seg)->stop
           && angle_of(seg_at(self, piece->seg)) > LEAST_ANGLE;
}

// What holds the path at the start of the piece in work, behind the one before.
static nck_host_low_t low_of(nck_host_why_t *self, const nck_host_why_piece_t *before) {
    const nck_host_why_piece_t *const piece = &self->piece;
    // Of two pieces the slower one holds; a corner lies before the second.
    const int is_before = piece->limit != NCK_LIMIT_CORNER && before->v_cap < piece->v_cap
                          && piece->v_node > 0.0 && !is_rest(before->kind) && self->begun;
    const nck_host_why_seg_t *const own = seg_at(self, piece->seg);
    nck_host_low_t low = {piece->limit, 0, is_before ? before->seg : piece->seg, 0,
                          NCK_AXIS_MAX, 0, 0.0, 0.0};
    low.line = is_before ? self->line : line_at(self, self->begun ? before->s_end : own->s_begin);
    low.ends = self->begun == 0;
    if (low.ends) return low;
    low.limit = reason_of(self, before);
    if (low.limit == NCK_LIMIT_CORNER || is_stopped_at(self, before, low.limit)) {
        low.limit = NCK_LIMIT_CORNER;
        low.axis = own->axis;
        low.angle = angle_of(own);
    } else if (low.limit >= NCK_LIMIT_AXIS_V) {
        low.axis = low.limit - NCK_LIMIT_AXIS_V;
    }
    return low;
}

// 1 if the path is held at the start of the piece in work.
static int is_held(const nck_host_why_t *self, const nck_host_why_piece_t *before) {
    const nck_host_why_piece_t *const piece = &self->piece;
    const int is_pace = piece->limit == NCK_LIMIT_FEED || piece->limit == NCK_LIMIT_RAPID;
    if (!self->begun || is_rest(piece->kind) || is_rest(before->kind)) return 1;
    if (self->v < HELD * piece->v_node) return 0;
    // Where the feed does not change there is nothing that holds.
    return !is_pace || nck_fabs(before->v_cap - piece->v_cap) > SAME * piece->v_cap;
}

// The next piece: one that is dropped, or the kernel still has it. 0: there is none.
static int read_piece(nck_host_why_t *self) {
    if ((int32_t)(self->told - self->taken) > 0) {
        self->piece = *piece_at(self, self->taken);
    } else {
        const nck_node_t *const node = nck_piece(self->nck, self->taken - self->told);
        if (!node) return 0;
        fill_piece(self, &self->piece, node);
    }
    self->taken++;
    return 1;
}

// Go on to the next piece. 0: there is none, which breaks an invariant before the first.
static int next_piece(nck_host_why_t *self) {
    const nck_host_why_piece_t before = self->piece;
    if (!read_piece(self)) {
        self->broken = !self->begun;
        return 0;
    }
    if (is_held(self, &before)) {
        const nck_host_low_t low = low_of(self, &before);
        take_low(self, &low);
    }
    if (self->cap.limit != self->piece.limit_piece || self->cap.seg != self->piece.seg) {
        settle_cap(self);
    }
    self->begun = 1;
    return 1;
}

// ---- time

static double speed_at(const nck_host_why_t *self, const nck_cell_t *cell, double t) {
    return nck_host_trail_speed(nck_link_seg(self->link, self->piece.seg), cell, t);
}

// When the cell has come so far: s = v·t + a·t²/2 + j·t³/6, by Newton's method from a time before.
static double time_at(const nck_cell_t *cell, double s, double t) {
    for (int k = 0; k < NEWTON_ROUNDS; k++) {
        const double v = nck_cell_speed(cell, t);
        const double miss = s - nck_cell_way(cell, t);
        if (!(v > 0.0)) {
            t = nck_min(cell->duration, t + 0.5 * (cell->duration - t));
            continue;
        }
        const double step = miss / v;
        t = nck_min(cell->duration, nck_max(0.0, t + step));
        if (nck_fabs(step) <= 1e-13 * cell->duration) break;
    }
    return t;
}

static void share(nck_host_why_t *self, const nck_cell_t *cell, uint32_t line, double time) {
    const int rests = !(cell->length > 0.0);
    const nck_host_share_kind_t moves = self->piece.rapid ? NCK_HOST_SHARE_RAPID
                                                          : NCK_HOST_SHARE_CUT;
    nck_host_share_add(&self->shares, line, rests ? NCK_HOST_SHARE_DWELL : moves, time);
}

// Time of a cell, by the limit that its label names, or by the low point that its ramp serves.
static void add_limit(nck_host_why_t *self, uint32_t limit, double time) {
    if (limit == NCK_LIMIT_ACCEL || limit == NCK_LIMIT_JERK) {
        self->down.limit_s += time;
        return;
    }
    // A rest that nobody asked for is none of the program's dwells.
    const int is_own = is_rest(self->piece.kind) && seg_at(self, self->piece.seg)->clocked;
    nck_host_cause_sum(&self->limit_s[is_own ? (uint32_t)NCK_LIMIT_MODE : limit], time);
}

// What the piece's own cap costs over the feed, and the ramp over the cap.
static void add_lost(nck_host_why_t *self, double ideal, double at_cap, double time) {
    const double over = at_cap - ideal;
    if (over > 0.0) {
        self->cap.limit = self->piece.limit_piece;
        self->cap.seg = self->piece.seg;
        self->cap.line = seg_at(self, self->piece.seg)->line;
        self->cap.axis = self->cap.limit >= NCK_LIMIT_AXIS_V ? self->cap.limit - NCK_LIMIT_AXIS_V
                                                             : NCK_AXIS_MAX;
        self->cap.lost_s += over;
    }
    self->down.lost_s += time - (over > 0.0 ? at_cap : ideal);
}

// The stretch of a cell from one time to another, as the trail takes it. s_cell: path before it.
static void follow_line(nck_host_why_t *self, const nck_cell_t *cell, double s_cell, uint32_t line,
                        double from, double to) {
    if (!self->trail.points) return;
    const nck_seg_t *const seg = nck_link_seg(self->link, self->piece.seg);
    const double v = speed_at(self, cell, to);
    const uint32_t rises = self->slow.is && v > self->slow.v;
    const nck_host_stride_t stretch = {seg, cell, s_cell - seg->s_begin, from, to,
                                        self->piece.v_feed, self->shares.tool,
                                        v < self->v_most ? 1 + rises : 0, line};
    nck_host_trail_move(&self->trail, &stretch);
}

// A stretch of a cell that belongs to one line.
static void take_line(nck_host_why_t *self, const nck_cell_t *cell, double s_cell, uint32_t line,
                      double from, double to) {
    follow_line(self, cell, s_cell, line, from, to);
    self->line = line;
    share(self, cell, line, to - from);
}

// The stretch of a cell from one time to another, line by line. s_cell: path before the cell.
static void follow(nck_host_why_t *self, const nck_cell_t *cell, double s_cell, double from,
                   double to) {
    const nck_seg_t *const seg = nck_link_seg(self->link, self->piece.seg);
    const double s_end = nck_cell_way(cell, to);
    double at = from;
    uint32_t line = line_at(self, s_cell + nck_cell_way(cell, from));
    for (uint32_t k = seg->marks.from; k - seg->marks.from != seg->marks.count; k++) {
        const double s = nck_marks_end(&self->link->marks, k) - s_cell;
        if (s >= s_end) break;
        if (s <= nck_cell_way(cell, at)) continue;
        const double t = time_at(cell, s, at);
        take_line(self, cell, s_cell, line, at, t);
        line = nck_marks_after(&self->link->marks, k);
        at = t;
    }
    take_line(self, cell, s_cell, line, at, to);
}

// ---- low points of a clocked path

// The axis that takes most of its limit of acceleration or jerk at a time of a cell.
static uint32_t axis_at(const nck_seg_t *seg, const nck_cell_t *cell, double t,
                        const nck_machine_t *machine) {
    const double v = nck_cell_speed(cell, t);
    const double a = cell->a + cell->j * t;
    const double s = nck_min(seg->length, cell->s + nck_cell_way(cell, t));
    double first[NCK_AXIS_MAX], second[NCK_AXIS_MAX], begin[NCK_AXIS_MAX], end[NCK_AXIS_MAX];
    uint32_t axis = NCK_AXIS_MAX;
    double most = 0.0;
    nck_path_tangent(seg, s, first);
    nck_path_second(seg, s, second);
    nck_path_second(seg, 0.0, begin);
    nck_path_second(seg, seg->length, end);
    for (uint32_t x = 0; x < NCK_AXIS_MAX; x++) {
        const double third = (end[x] - begin[x]) / seg->length;
        const double share_a = (first[x] * a + second[x] * v * v) / machine->axis[x].a_max;
        const double share_j = (first[x] * cell->j + (3.0 * second[x] * a + third * v * v) * v)
                               / machine->axis[x].j_max;
        const double taken = nck_fabs(cell->limit == NCK_LIMIT_ACCEL ? share_a : share_j);
        if (!machine->axis[x].present || taken <= most) continue;
        most = taken;
        axis = x;
    }
    return axis;
}

// A time of a cell as a low point: where the path is slow its acceleration is that of its bends.
static void note_slow(nck_host_why_t *self, const nck_cell_t *cell, double t, double v) {
    const uint32_t limit = cell->limit == NCK_LIMIT_ACCEL ? (uint32_t)NCK_LIMIT_CURVATURE
                                                          : cell->limit;
    const double s = seg_at(self, cell->seg)->s_begin + cell->s + nck_cell_way(cell, t);
    const nck_host_low_t low = {limit, 0, self->piece.seg, line_at(self, s),
                                NCK_AXIS_MAX, 0, 0.0, 0.0};
    self->slow.is = 1;
    self->slow.v = v;
    self->slow.down = self->down;
    self->slow.low = low;
    if (limit >= NCK_LIMIT_AXIS_V) self->slow.low.axis = limit - NCK_LIMIT_AXIS_V;
    if (limit == NCK_LIMIT_CURVATURE || limit == NCK_LIMIT_JERK) {
        self->slow.low.axis = axis_at(nck_link_seg(self->link, self->piece.seg), cell, t,
                                      nck_machine_of(self->nck));
    }
    nck_host_trail_slowest(&self->trail);
}

// Behind the fastest point: is this the slowest place, or is the path faster again than there?
static void watch_slow(nck_host_why_t *self, const nck_cell_t *cell, double t, double v) {
    nck_host_why_slow_t *const slow = &self->slow;
    if (!slow->is || v < slow->v) note_slow(self, cell, t, v);
    if (v * (1.0 - LOW) <= slow->v || self->v_most * (1.0 - LOW) <= slow->v) return;
    const nck_host_why_ramp_t behind = {self->down.lost_s - slow->down.lost_s,
                                        self->down.limit_s - slow->down.limit_s};
    self->down = slow->down;
    end_ramps(self, &slow->low);
    nck_host_trail_was_low(&self->trail);
    nck_host_trail_fastest(&self->trail);
    self->up = behind;
}

// A stretch of the piece in work: its length, its time, when and how fast the path is at its end.
static void pass(nck_host_why_t *self, const nck_cell_t *cell, double s, double time, double to) {
    const double v = speed_at(self, cell, to);
    const nck_host_why_piece_t *const piece = &self->piece;
    const int may_pace = piece->v_feed > 0.0 && piece->v_cap > 0.0;
    const double ideal = may_pace ? s / piece->v_feed : time;
    nck_host_cause_sum(piece->rapid ? &self->rapid_s : &self->cut_s, ideal);
    add_limit(self, cell->limit, time);
    add_lost(self, ideal, may_pace ? s / piece->v_cap : time, time);
    self->v = v;
    if (v < self->v_most) {
        if (seg_at(self, piece->seg)->clocked) watch_slow(self, cell, to, v);
        return;
    }
    self->slow.is = 0;
    self->v_most = v;
    nck_host_trail_fastest(&self->trail);
    self->up.lost_s += self->down.lost_s;
    self->up.limit_s += self->down.limit_s;
    memset(&self->down, 0, sizeof self->down);
}

// The line at a cell's end, or that of its rest.
static uint32_t rests_on(nck_host_why_t *self, const nck_cell_t *cell) {
    return cell->length > 0.0 ? self->line : seg_at(self, self->piece.seg)->line;
}

// The path rests for some time, where the piece in work does not move or at its end.
static void follow_rest(nck_host_why_t *self, const nck_cell_t *cell, double time) {
    if (!self->trail.points) return;
    const nck_host_stride_t stretch = {nck_link_seg(self->link, self->piece.seg), cell, 0.0, 0.0,
                                        0.0, self->piece.v_feed, self->shares.tool, 0,
                                        rests_on(self, cell)};
    nck_host_trail_rest(&self->trail, &stretch, time);
}

// Behind a cell: the time until the next begins.
static void end_cell(nck_host_why_t *self, const nck_cell_t *cell, double extra_s) {
    if (!(cell->stop & NCK_STOP_REST)) return;
    share(self, cell, rests_on(self, cell), extra_s);
    add_limit(self, cell->limit, extra_s);
    follow_rest(self, cell, extra_s);
    if (cell->length > 0.0) {
        self->down.lost_s += extra_s;
        self->v = 0.0;
    } else {
        nck_host_cause_sum(&self->dwell_s, extra_s);
    }
}

// At rest: the time is programmed.
static void pass_rest(nck_host_why_t *self, const nck_cell_t *cell) {
    while (!self->begun || self->piece.seg != cell->seg) {
        if (!next_piece(self)) return;
    }
    self->v = 0.0;
    share(self, cell, seg_at(self, self->piece.seg)->line, cell->duration);
    add_limit(self, cell->limit, cell->duration);
    follow_rest(self, cell, cell->duration);
    nck_host_cause_sum(&self->dwell_s, cell->duration);
}

// 1 if the piece in work ends at a place, or before.
static int is_behind(const nck_host_why_t *self, double s) {
    return !self->begun || is_rest(self->piece.kind) || self->piece.s_end <= s + NEAR;
}

// All pieces that a moving cell passes.
static void pass_cell(nck_host_why_t *self, const nck_cell_t *cell) {
    const double s_begin = seg_at(self, cell->seg)->s_begin + cell->s;
    const double s_end = s_begin + cell->length;
    double s = s_begin;
    double at = 0.0;
    int is_last = 0; // what is left of the path is rounding
    self->v = nck_host_trail_speed(nck_link_seg(self->link, cell->seg), cell, 0.0);
    for (;;) {
        while (is_behind(self, s) && !is_last) is_last = !next_piece(self);
        if (!self->begun) return;
        if (is_last || self->piece.s_end >= s_end - NEAR) break;
        const double t = time_at(cell, self->piece.s_end - s_begin, at);
        follow(self, cell, s_begin, at, t);
        pass(self, cell, self->piece.s_end - s, t - at, t);
        s = self->piece.s_end;
        at = t;
    }
    follow(self, cell, s_begin, at, cell->duration);
    pass(self, cell, s_end - s, cell->duration - at, cell->duration);
}

void nck_host_why_cell(nck_host_why_t *self, const nck_cell_t *cell, double extra_s) {
    if (cell->length > 0.0) {
        pass_cell(self, cell);
    } else {
        pass_rest(self, cell);
    }
    end_cell(self, cell, extra_s);
}

void nck_host_why_end(nck_host_why_t *self) {
    if (self->begun) {
        const nck_host_low_t end = {NCK_LIMIT_EXACT_STOP, 1, self->piece.seg,
                                    seg_at(self, self->piece.seg)->line, NCK_AXIS_MAX, 0, 0.0, 0.0};
        take_low(self, &end);
        settle_low(self);
    }
    settle_cap(self);
    nck_host_cause_end(self->causes);
}
