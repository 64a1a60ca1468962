// SPDX-License-Identifier: MIT
// Inside room 4: what neighbouring segs have to do with a seg's speed and limits.
#include "nck/prep/4_lookahead/near.h"

#include "nck/base/budget.h"                  // NCK_BUDGET_… NCK_UNLIMITED
#include "nck/base/scurve_math.h"             // nck_scurve_reach

// A cap comes down only if that frees more than this share of the acceleration left.
#define BENDS_SHARE 0.95

// Where caps may be levelled across: splines that pass into each other without a stop.
static int is_chain(const nck_junction_t *junction) {
    return junction->kind == NCK_SEG_SPLINE && !(junction->end & NCK_JUNCTION_STOP);
}

// What a junction's cap is levelled with: a neighbour, or a rest.
typedef struct neighbour {
    double w;      // v² there [path mm²/s²]
    double apart;  // between the middle of the junction and that of the neighbour [path mm]
    uint8_t limit; // nck_limit_t of w
} neighbour_t;

static neighbour_t beside(const nck_junction_t *junction, const nck_junction_t *neighbour) {
    const neighbour_t side = {neighbour->w_near, 0.5 * (junction->length + neighbour->length),
                              neighbour->limit_free};
    return side;
}

static neighbour_t at_rest(const nck_junction_t *junction) {
    const neighbour_t side = {0.0, 0.5 * junction->length, NCK_LIMIT_EXACT_STOP};
    return side;
}

// A neighbour that is too short from a rest on to reach its cap.
static neighbour_t gained_before(const nck_junction_t *junction, const nck_junction_t *before) {
    const neighbour_t side = {before->w_out, 0.5 * junction->length, NCK_LIMIT_EXACT_STOP};
    return side;
}

// A rest at the other end of a line: what the line gains before the filter mixes it with the
// junction.
static neighbour_t beyond_line(const nck_junction_t *junction, const nck_junction_t *line,
                               const nck_terms_t *terms) {
    const double v = nck_sqrt(junction->w_near);
    const double zone = nck_min(line->length, v * terms->mix_s);
    const nck_scurve_t ramp = {line->a_most, terms->limits_jerk ? line->j_straight : NCK_UNLIMITED,
                               line->v_free};
    const double v_line = nck_scurve_reach(&ramp, 0.0, line->length - zone);
    const neighbour_t side = {v_line * v_line, zone + 0.5 * junction->length, NCK_LIMIT_EXACT_STOP};
    return side;
}

// v² next to a neighbour's, with the acceleration that the junction's own bends leave at w:
//   g(w) = w_n + 2σ·a_left(w)·l
static double reach(const nck_junction_t *junction, const neighbour_t *side, double w,
                    const nck_terms_t *terms) {
    const double left = nck_max(0.0, nck_junction_left(junction, w, terms));
    return side->w + 2.0 * NCK_BUDGET_STEEP_SHARE * left * side->apart;
}

// The largest v² that a junction can come down from to its neighbour's: about the root of w = g(w).
// As g falls, the root lies between g(high) and any high that is not below it; a secant makes the
// gap small. It need not be exact: what is allowed at a speed is worked out when the speed is
// settled.
static double leveled(const nck_junction_t *junction, const neighbour_t *side,
                      const nck_terms_t *terms) {
    const double high = nck_min(junction->w_near, reach(junction, side, side->w, terms));
    const double low = reach(junction, side, high, terms);
    if (!(low < high)) return high;
    const double above = reach(junction, side, low, terms) - low;
    const double below = high - low;
    const double w = low + (high - low) * above / (above + below);
    return nck_min(w, reach(junction, side, w, terms));
}

// A cap much above its neighbour's is of no use, but would cost acceleration and jerk; where the
// junction hardly bends it costs none. Returns 1 if the cap came down.
static int level(nck_junction_t *junction, const neighbour_t *side, const nck_terms_t *terms) {
    if (!(side->w < junction->w_near)) return 0;
    const double w = leveled(junction, side, terms);
    if (!(w < junction->w_near)) return 0;
    const double left = nck_junction_left(junction, junction->w_near, terms);
    if (left >= BENDS_SHARE * nck_junction_left(junction, w, terms)) return 0;
    junction->w_near = w;
    junction->limit_free = side->limit;
    return 1;
}

// Level what lies before a junction whose cap came down, `most` junctions before the newest at
// most. What is settled stays.
static void level_before(nck_lookahead_t *self, uint32_t at, uint32_t most) {
    while (at > self->junction.settled && self->junction.head - at <= most) {
        nck_junction_t *const before = nck_junction_at(self, at - 1);
        const neighbour_t side = beside(before, nck_junction_at(self, at));
        if (!is_chain(before) || !level(before, &side, self->terms)) return;
        at--;
    }
}

// A line that ends a chain of splines: where it ends at rest the chain comes down to it.
static int ends_chain(nck_lookahead_t *self, uint32_t at) {
    return at > 0 && nck_junction_at(self, at)->kind == NCK_SEG_LINE
           && is_chain(nck_junction_at(self, at - 1));
}

// Where the first junctions are that a later one may level. A chain stays open behind its end until
// it is known whether the line there ends at rest.
static void close_chains(nck_lookahead_t *self, uint32_t at) {
    if (at > 0 && !is_chain(nck_junction_at(self, at - 1))) self->junction.broken = at;
    if (!is_chain(nck_junction_at(self, at)) && !ends_chain(self, at)) {
        self->junction.broken = at + 1;
    }
}

// The path rests behind a junction: it comes down to that, and so does what lies before it.
static void level_to_rest(nck_lookahead_t *self, uint32_t at, uint32_t most) {
    const int by_line = ends_chain(self, at);
    const uint32_t last = by_line ? at - 1 : at;
    nck_junction_t *const junction = nck_junction_at(self, last);
    if (junction->kind != NCK_SEG_SPLINE || last < self->junction.settled) return;
    const neighbour_t side =
        by_line ? beyond_line(junction, nck_junction_at(self, at), self->terms) : at_rest(junction);
    if (level(junction, &side, self->terms)) level_before(self, last, most);
}

// What a spline is levelled with before it: 0 if with nothing.
static int side_before(nck_lookahead_t *self, uint32_t at, neighbour_t *side_out) {
    const nck_junction_t *const junction = nck_junction_at(self, at);
    const nck_junction_t *const before =
        at > 0 ? nck_junction_at(self, at - 1) : (nck_junction_t *)0;
    if (nck_near_rests(before)) {
        *side_out = at_rest(junction);
        return 1;
    }
    if (is_chain(before)) {
        *side_out = beside(junction, before);
        if (before->w_out < before->w_near) *side_out = gained_before(junction, before);
        return 1;
    }
    if (before->kind != NCK_SEG_LINE) return 0;
    if (at > 1 && !nck_near_rests(nck_junction_at(self, at - 2))) return 0;
    *side_out = beyond_line(junction, before, self->terms);
    return 1;
}

void nck_near_level_newest(nck_lookahead_t *self) {
    const uint32_t at = self->junction.head - 1;
    nck_junction_t *const junction = nck_junction_at(self, at);
    neighbour_t side;
    close_chains(self, at);
    // Whether the junction before stops is known by now.
    if (at > 0 && (nck_junction_at(self, at - 1)->end & NCK_JUNCTION_STOP)) {
        level_to_rest(self, at - 1, NCK_NEAR_SPAN);
    }
    if (junction->kind == NCK_SEG_SPLINE && side_before(self, at, &side)) {
        (void)level(junction, &side, self->terms);
        if (at > 0 && is_chain(nck_junction_at(self, at - 1))) {
            level_before(self, at, NCK_NEAR_SPAN);
        }
    }
    nck_near_set_out(junction, nck_near_entered_at(self, at));
    if (junction->end & NCK_JUNCTION_STOP) level_to_rest(self, at, NCK_NEAR_SPAN);
}

// No junction is pushed: what the newest one had left to be settled may be, or not, as time would
// have it. It stays.
void nck_near_end(nck_lookahead_t *self) {
    const uint32_t head = self->junction.head;
    if (!self->ended && head > 0) level_to_rest(self, head - 1, NCK_NEAR_SPAN - 1);
}

// Its caps stay as if the path went on as it is: levelled to a rest at the newest junction's end
// they would be slow for good: 1500 chords, one a period, took 2.93 s in place of 2.05.
void nck_near_hurry(nck_lookahead_t *self) { self->junction.hurried = self->junction.head; }

static void include(nck_near_t *near, const nck_junction_t *junction, double a, int pace) {
    near->a = nck_min(near->a, a);
    near->j = nck_min(near->j, junction->pace[pace].j);
}

void nck_near_before(nck_lookahead_t *self, uint32_t count, int pace, double beta,
                     nck_near_t *near_out) {
    const nck_near_t unlimited = {NCK_UNLIMITED, NCK_UNLIMITED, 1.0};
    double time = 0.0;
    double least = 0.0;
    *near_out = unlimited;
    for (int n = 0; n < NCK_NEAR_SPAN; n++) {
        if (count == 0) return;
        count--;
        const nck_junction_t *const junction = nck_junction_at(self, count);
        if ((junction->end & NCK_JUNCTION_STOP) || junction->kind >= NCK_SEG_DWELL) return;
        include(near_out, junction, nck_junction_accel(junction, beta, pace, self->terms), pace);
        time += junction->pace[pace].time;
        least += junction->pace[pace].least;
        if (least >= self->terms->mix_s) return;
    }
    near_out->slow = time / self->terms->mix_s;
}

nck_status_t nck_near_after(nck_lookahead_t *self, uint32_t count, int pace, double beta,
                            nck_near_t *near_out) {
    const nck_near_t unlimited = {NCK_UNLIMITED, NCK_UNLIMITED, 1.0};
    double time = 0.0;
    double least = 0.0;
    *near_out = unlimited;
    for (int n = 0; n < NCK_NEAR_SPAN; n++) {
        if (nck_junction_at(self, count)->end & NCK_JUNCTION_STOP) return NCK_OK;
        count++;
        if (count == self->junction.head && self->ended) return NCK_OK;
        if (count >= self->junction.settled) return NCK_EMPTY;
        const nck_junction_t *const junction = nck_junction_at(self, count);
        if (junction->kind >= NCK_SEG_DWELL) return NCK_OK;
        include(near_out, junction, nck_junction_accel(junction, beta, pace, self->terms), pace);
        time += junction->pace[pace].time;
        least += junction->pace[pace].least;
        if (least >= self->terms->mix_s) return NCK_OK;
    }
    near_out->slow = time / self->terms->mix_s;
    return NCK_OK;
}
