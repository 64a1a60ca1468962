// SPDX-License-Identifier: MIT
// The path, led along one contour after another: each is joined to the path so far where it crosses
// it towards the tool. What an inside corner cuts off is taken back, the newest first, but never
// all of a contour that is longer than the tool's radius.
#include "nck/prep/2_toolcomp/parts.h"

#include <string.h> // memcpy

#include "nck/base/arc_math.h"  // nck_arc_outer
#include "nck/base/real.h"      // nck_min nck_max
#include "nck/base/trig_math.h" // NCK_PI nck_sincos

#define ONE_PLACE 1e-6 // [mm] places nearer to one another are one
#define TOWARDS 1e-9   // sine of an angle that turns towards the tool
#define LEVEL 1e-4     // [mm] dipping in less deep than this the tool may go straight on
#define ANYWHERE 1e12  // [mm]

double nck_comp_dip(const nck_toolcomp_t *self, double turn) {
    double sine;
    double cosine;
    nck_sincos(nck_max(-0.5 * NCK_PI, nck_min(turn, 0.0)), &sine, &cosine);
    return self->radius * (1.0 - cosine);
}

static int turns_towards(const nck_toolcomp_t *self, const nck_comp_piece_t *from,
                         const nck_comp_piece_t *to, const nck_meeting_t *at) {
    double in[2];
    double out[2];
    nck_shape_tangent(&from->shape, at->on_a, in);
    nck_shape_tangent(&to->shape, at->on_b, out);
    return self->side * nck_arc_outer(in, out) > TOWARDS;
}

// Does the path cross the new piece on this one? Then it leaves this one there. reach: so little of
// either may be cut off [mm].
static int leaves(nck_toolcomp_t *self, uint32_t count, nck_comp_part_t part,
                  const nck_comp_piece_t *to, double reach) {
    nck_comp_entry_t *const entry = nck_comp_at(self, count);
    nck_comp_entry_t *const next = nck_comp_at(self, to->of);
    nck_comp_span_t *const span = &entry->path[part];
    nck_comp_piece_t piece;
    nck_meeting_t at[2];
    if (!entry->on[part]) return 0;
    nck_comp_piece(self, count, part, &piece);
    const unsigned crossings = nck_shape_cross(&piece.shape, &to->shape, at);
    for (unsigned k = 0; k < crossings; k++) {
        const int within = at[k].on_a > span->from && at[k].on_a < span->to + ONE_PLACE
                           && at[k].on_b < to->shape.length;
        const int near = span->to - at[k].on_a < reach && at[k].on_b < reach;
        if (!within || !near || !turns_towards(self, &piece, to, &at[k])) continue;
        span->to = nck_min(at[k].on_a, span->to);
        next->path[to->part] = (nck_comp_span_t){nck_max(at[k].on_b, 0.0), to->shape.length};
        next->on[to->part] = 1;
        return 1;
    }
    return 0;
}

// Of the contours behind a piece nothing is on the path any more.
static void take_back(nck_toolcomp_t *self, uint32_t count, nck_comp_part_t part, uint32_t until) {
    if (part == NCK_COMP_ABOUT) nck_comp_at(self, count)->on[NCK_COMP_BESIDE] = 0;
    for (uint32_t m = count + 1; m != until; m++) {
        nck_comp_entry_t *const entry = nck_comp_at(self, m);
        entry->on[NCK_COMP_ABOUT] = 0;
        entry->on[NCK_COMP_BESIDE] = 0;
    }
}

// Where does the path so far cross a new piece, the newest place first? neighbour: the contour
// before. Beyond a rapid nothing is held against anything.
static int crosses(nck_toolcomp_t *self, uint32_t neighbour, const nck_comp_piece_t *to) {
    const int rapid = nck_comp_at(self, to->of)->rapid;
    for (uint32_t m = neighbour + 1; m-- != self->ring.tail;) {
        const nck_comp_entry_t *const entry = nck_comp_at(self, m);
        if (!entry->moves) continue;
        for (int part = NCK_COMP_BESIDE; part >= 0; part--) {
            if (leaves(self, m, (nck_comp_part_t)part, to, ANYWHERE)) {
                take_back(self, m, (nck_comp_part_t)part, to->of);
                return 1;
            }
            if (part == NCK_COMP_BESIDE && entry->contour.length > self->radius) return 0;
        }
        if (rapid || entry->rapid) return 0;
    }
    return 0;
}

static void lead(nck_toolcomp_t *self, const nck_comp_piece_t *piece) {
    nck_comp_entry_t *const entry = nck_comp_at(self, piece->of);
    entry->path[piece->part] = (nck_comp_span_t){0.0, piece->shape.length};
    entry->on[piece->part] = 1;
}

// Towards the tool: the parallels cross. At an angle so small that nobody can tell they do so close
// to the corner, by R·angle/2 before it on straight lines, or the tool goes straight on. Rapids cut
// nothing.
static void join_inside(nck_toolcomp_t *self, const nck_comp_piece_t *beside, int follows,
                        double turn) {
    const uint32_t before = self->last.count;
    const int waits = before - self->ring.tail < beside->of - self->ring.tail;
    const int rapid = self->last.rapid || nck_comp_at(self, beside->of)->rapid;
    const int level = follows && nck_comp_dip(self, turn) < LEVEL;
    const double reach = level ? ONE_PLACE - 2.0 * self->radius * turn : ANYWHERE;
    if (waits && leaves(self, before, NCK_COMP_BESIDE, beside, reach)) return;
    if (level || (follows && rapid)) lead(self, beside);
    else if (waits) (void)crosses(self, before, beside);
}

// The first move, if it is still to be given, by type A, at a corner towards the tool by type B,
// too, ends beside the beginning of the contour behind it, as the way to its other side does.
// Returns 0 if it does not.
static int leads_in(nck_toolcomp_t *self, const double *ahead, double turn) {
    nck_comp_entry_t *const entry = nck_comp_at(self, self->last.count);
    const int upright = self->start == NCK_COMP_START_A
                        || (self->start == NCK_COMP_START_B && turn < 0.0);
    nck_comp_piece_t way;
    if (nck_comp_is_given(self, self->last.count)) return 0;
    if (!entry->enters || !(upright || entry->crosses)) return 0;
    memcpy(entry->tangent, ahead, sizeof entry->tangent);
    nck_comp_piece(self, self->last.count, NCK_COMP_BESIDE, &way);
    lead(self, &way);
    return 1;
}

void nck_comp_join(nck_toolcomp_t *self, uint32_t count, int follows) {
    const nck_comp_entry_t *const entry = nck_comp_at(self, count);
    nck_comp_piece_t about;
    nck_comp_piece_t beside;
    double ahead[2];
    nck_comp_piece(self, count, NCK_COMP_BESIDE, &beside);
    if (entry->enters) {
        lead(self, &beside);
        return;
    }
    nck_shape_tangent(&entry->contour, 0.0, ahead);
    const double turn = nck_comp_turn(self, entry->tangent, ahead);
    if (leads_in(self, ahead, turn)) {
        lead(self, &beside);
        return;
    }
    if (turn < 0.0) {
        join_inside(self, &beside, follows, turn);
        return;
    }
    const int rounds = self->radius * turn > NCK_COMP_SHORT;
    if (rounds) nck_comp_piece(self, count, NCK_COMP_ABOUT, &about);
    if (follows && rounds) lead(self, &about);
    if (follows || (rounds && crosses(self, self->last.count, &about))) lead(self, &beside);
    else (void)crosses(self, self->last.count, &beside);
}
