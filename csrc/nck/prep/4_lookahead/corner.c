// SPDX-License-Identifier: MIT
// Inside room 4: the speed at a junction, from the tangents on both sides to the cap of its node.
//
//   load ─▶ stop, if that is faster ─▶ share ─▶ speed alone ─▶ speed in a crowd ─▶ share taken
//   meet    (stop.c)                  set_share    decide_pace      decide_crowd        settle
//
// What the pieces on both sides allow comes on top when the node is placed (piece.c).
#include "nck/prep/4_lookahead/corner.h"

#include "nck/prep/4_lookahead/limit_math.h" // nck_corner_…
#include "nck/prep/4_lookahead/stop.h"       // nck_stop_pays
#include "nck/prep/4_lookahead/walk.h"       // nck_walk_…
#include "nck/prep/4_lookahead/zone.h"       // nck_zone_is_alone

// Smooth or straight pieces pass into each other without a corner, but for rounding: 1e-13 mm in
// 1000 mm over a piece of 0.01 mm turns it by 3e-11, which at 100 mm/s, 1 ms and 1000 mm/s² costs
// the share 3e-9.
// A share as small as this one is left out; the nanometre of a setpoint costs more.
#define SHARE_OF_ROUNDING 1e-7
// So much of the axes' acceleration times the load a corner has at least that is no curve's: alone
// it is crossed at 40 times what a period gains, or less.
#define TAME_LOAD 0.02
#define TAME_LEAST 0.25

// Without a jerk limit a junction gets most of the acceleration where the path is an even polygon:
// behind blunt junctions in a row whose lines gain, together, EVEN_LONG times the v² that they are
// passed at, none of them more than EVEN_GAIN times, if the window is long enough to brake from
// there; behind EVEN_LONGER times it gets nearly all. Found by trying: of 200 random polygons with
// low points 10 are slower by more than 0.5 % then, 20 with a row of 4, 27 with 1.6; where sharp
// junctions count, too, random short lines take twice as long. The longer row makes none of 300
// slower; a half of it makes the wavy surface 0.8 % slower, and an eighth 2.5 % and 3 of 300.
#define EVEN_LONG 10.0
#define EVEN_LONGER 320.0
#define EVEN_GAIN 16.0
#define BLUNT_LOAD 0.2
// With the share β a row gains so many times v² at least where (1 − β)·a brakes from β·v along it:
// β²/(2·(1 − β)).
#define EVEN_BRAKE 1.6
#define EVEN_BRAKE_LONGER 4.05

// Where a period gains as much speed as short lines have room for, a crowd of corners would have to
// be passed at next to none: less acceleration on the lines lets it be passed at more. What the
// filter adds to a speed is not worth less, nor without one a share of what a period gains.
static void tame(nck_junction_t *in, nck_junction_t *out, const nck_terms_t *terms) {
    const double period = terms->machine->period_s;
    const int is_sharp = in->load * nck_max(in->a_most, out->a_most) >= TAME_LOAD;
    if (!NCK_HAS_POLYGONS && !(NCK_HAS_JERK && terms->limits_jerk)) return;
    if (!is_sharp || in->kind != NCK_SEG_LINE || out->kind != NCK_SEG_LINE) return;
    const double longer = nck_max(in->length, out->length);
    const double period_gain = nck_min(in->a_most, out->a_most) * period;
    const double least = terms->limits_jerk ? terms->v_filter : TAME_LEAST * period_gain;
    const double gain = nck_max(longer / period, least);
    in->shape.arc.a_straight = nck_min(in->shape.arc.a_straight, gain / period);
    out->shape.arc.a_straight = nck_min(out->shape.arc.a_straight, gain / period);
}

// The load of the junction between two segs: of the axis that it takes most of.
static double load_of(const double *tangent_in, const double *tangent_out,
                      const nck_terms_t *terms) {
    double load = 0.0;
    for (int x = 0; x < terms->axes; x++) {
        if (!(nck_fabs(tangent_in[x] - tangent_out[x]) > 0.0)) continue;
        load = nck_max(load, nck_corner_load(tangent_in[x], tangent_out[x],
                                             terms->machine->axis[x].a_max));
    }
    return load;
}

// The path rests at the end of a junction; lands: the tick does, too.
static void rest(nck_junction_t *junction, int lands) {
    for (int k = 0; k < NCK_PACES; k++) junction->pace[k].v_corner = 0.0;
    if (lands) junction->end |= NCK_JUNCTION_STOP;
}

// Whether a junction, crossed moving, would break the jerk that one of its sides keeps: it must go
// straight on. turns: it does not.
static int breaks_jerk(const nck_junction_t *in, const nck_junction_t *out, int turns) {
    const int either = in->end | out->end;
    const int is_straight = in->kind == NCK_SEG_LINE && out->kind == NCK_SEG_LINE && !turns;
    return (either & NCK_JUNCTION_TURNS) && !is_straight;
}

void nck_corner_meet(nck_junction_t *in, nck_junction_t *out, const double *tangent_in,
                     const double *tangent_out, const nck_terms_t *terms) {
    if (out->kind >= NCK_SEG_DWELL) in->end |= NCK_JUNCTION_STOP;
    if ((in->end & NCK_JUNCTION_STOP) || in->kind >= NCK_SEG_DWELL) return;
    const double load = load_of(tangent_in, tangent_out, terms);
    const double v = nck_min(in->v_free, out->v_free);
    const int turns = load * v > SHARE_OF_ROUNDING * terms->machine->period_s;
    if (terms->limits_jerk && breaks_jerk(in, out, turns)) {
        rest(in, 1);
        return;
    }
    if (!turns) return;
    if (nck_stop_pays(in, out, load, terms)) {
        rest(in, terms->limits_jerk);
        return;
    }
    in->load = load;
    tame(in, out, terms);
}

// A junction that is decided, between two known segs.
typedef struct crossing {
    nck_junction_t *in;        // at the end of this junction …
    const nck_junction_t *out; // … and the next one
    double period;             // [s]
} crossing_t;

// A·T, where A is the largest acceleration on the segs that can share a period with the junction
// when it is crossed at v. begin: a walk that stands at the junction.
static nck_status_t largest_gain(nck_lookahead_t *self, const crossing_t *crossing,
                                 const nck_walk_t *begin, double reach, double *a_t_out) {
    const nck_junction_t *neighbour = crossing->out;
    double a = nck_junction_most(crossing->in);
    double x = 0.0;
    nck_status_t status = NCK_OK;
    nck_walk_t walk = *begin;
    while (status == NCK_OK) {
        a = nck_max(a, nck_junction_most(neighbour)); // the first time, of the seg behind
        status = nck_walk_next(self, &walk, reach, &neighbour, &x);
    }
    *a_t_out = a * crossing->period;
    return status == NCK_DONE ? NCK_OK : status;
}

// The slope's filter crosses the junction up to v_filter faster than v. A junction that even this
// is too fast for is stopped at.
static void settle(const nck_lookahead_t *self, const crossing_t *crossing, int pace, double v,
                   double share) {
    const double most = self->terms->limits_jerk ? NCK_CORNER_SHARE_LONE : self->next.beta;
    nck_junction_t *const junction = crossing->in;
    nck_pace_t *const at = &junction->pace[pace];
    at->v_corner = v;
    at->share = nck_min(most, nck_max(0.0, share));
    if (share > most && v < self->terms->v_filter) junction->end |= NCK_JUNCTION_STOP;
}

// Lines in sight, if all are as long.
static inline double lines_seen(const nck_lookahead_t *self) {
    const uint32_t told = self->terms->machine->lookahead_blocks;
    return (double)(told > 0 ? told : NCK_WINDOW);
}

// Of a junction that is one of an even polygon, as is the line before it, what that gains over v²,
// where 0.8 v is the most that 0.8 a or the line allows; of another one 0. It is one if
// d a ≤ BLUNT_LOAD, a l ≤ EVEN_GAIN v², and n such lines, as many as the window has, can brake from
// there with the rest, a/5: 0.4 a l n ≥ (0.8 v)². No zone is longer than NCK_CORNER_SPAN such
// lines: nck_zone_shares_after comes as far as a junction.
static inline double even_gain(const nck_lookahead_t *self, const nck_junction_t *in,
                               const nck_junction_t *out, double period) {
    const nck_pace_t *const pace = &in->pace[NCK_PACE_OVER];
    if (!(in->load * in->a_most <= BLUNT_LOAD)) return 0.0;
    if (in->kind != NCK_SEG_LINE || out->kind != NCK_SEG_LINE) return 0.0;
    const double least = NCK_ZONE_MARGIN / NCK_CORNER_SPAN * self->zone_s;
    const double v = nck_min(period / in->load, 1.0 / NCK_CORNER_SHARE_DENSE * pace->v);
    const double gain = in->a_most * in->length / (v * v);
    const int is_even =
        gain <= EVEN_GAIN && gain * lines_seen(self) >= EVEN_BRAKE && pace->time >= least;
    return is_even ? gain : 0.0;
}

// The junction is decided: how far the row of even ones is on its way to EVEN_LONGER. It does not
// come to EVEN_LONG before it takes longer than a zone does.
static inline void count_even(nck_lookahead_t *self, const nck_junction_t *in) {
    if (!NCK_HAS_POLYGONS) return;
    const double most = EVEN_LONG / NCK_ZONE_MARGIN / self->zone_s;
    const double time = in->pace[NCK_PACE_OVER].time;
    if (!(self->next.even > 0.0)) self->even = 0.0f;
    else if (!(self->even >= (float)EVEN_LONGER)) {
        self->even += (float)nck_min(self->next.even, most * time);
    }
}

// The largest share of a junction without a jerk limit.
static inline double share_most_linear(const nck_lookahead_t *self, double even) {
    if (!(even > 0.0 && self->even >= (float)EVEN_LONG)) return NCK_CORNER_SHARE_MAX;
    const int is_longer = self->even >= (float)EVEN_LONGER
                          && even * lines_seen(self) >= EVEN_BRAKE_LONGER;
    return is_longer ? NCK_CORNER_SHARE_LONE : NCK_CORNER_SHARE_DENSE;
}

// The same under a jerk limit: the speed is least where the acceleration is small, so that most of
// it can go to the junction, more of it if the junction is alone.
static double share_most_jerk(const nck_lookahead_t *self, const nck_junction_t *in,
                              const nck_junction_t *out) {
    if (!nck_zone_is_alone(in, out, in->load, self->terms)) return NCK_CORNER_SHARE_DENSE;
    return nck_corner_share_lone(nck_max(in->j_straight, out->j_straight),
                                 nck_min(in->a_most, out->a_most), self->zone_s);
}

// What share the next junction may take, and whether it is of an even polygon.
static inline void set_share(nck_lookahead_t *self, const nck_junction_t *in,
                             const nck_junction_t *out, double period) {
    if (self->terms->limits_jerk) {
        self->next.beta = share_most_jerk(self, in, out);
        return;
    }
    if (NCK_HAS_POLYGONS) self->next.even = even_gain(self, in, out, period);
    self->next.beta = share_most_linear(self, self->next.even);
}

// Speed and share of a junction that shares a period with others; alone it is crossed at v.
static nck_status_t decide_crowd(nck_lookahead_t *self, const crossing_t *crossing,
                                 const nck_walk_t *begin, int pace, double v, double a_t) {
    const double period = crossing->period;
    const double d = crossing->in->load;
    double others_d = 0.0;
    double others_dx = 0.0;
    nck_status_t status = NCK_OK;
    nck_walk_t walk = *begin;
    for (;;) {
        const nck_junction_t *neighbour = crossing->in;
        double x = 0.0;
        status = nck_walk_next(self, &walk, (v + a_t) * period, &neighbour, &x);
        if (status != NCK_OK) break;
        others_d += neighbour->load;
        others_dx += neighbour->load * x;
        const double v_crowd = nck_corner_speed(self->next.beta, d + others_d, others_d, others_dx,
                                                a_t, period);
        v = nck_min(v, v_crowd);
    }
    if (status != NCK_DONE) return status;
    v = nck_max(0.0, nck_min(v, walk.cut / period - a_t));
    const double v_true = nck_max(v, self->terms->v_filter);
    settle(self, crossing, pace, v,
           nck_corner_share(v_true, d + others_d, others_d, others_dx, a_t, period));
    return NCK_OK;
}

// Speed and share at a pace of a junction that may share a period with others.
static nck_status_t decide_near(nck_lookahead_t *self, const crossing_t *crossing, int pace,
                                double v, double reach) {
    double a_t = 0.0;
    nck_walk_t walk;
    nck_walk_begin(self, &walk, self->junction.decided);
    const nck_status_t status = largest_gain(self, crossing, &walk, reach, &a_t);
    return status == NCK_OK ? decide_crowd(self, crossing, &walk, pace, v, a_t) : status;
}

// How near a junction that is crossed at v has others with which it can share a period.
static inline double reach_at(const nck_lookahead_t *self, double v, double period) {
    return (v + self->a_any * period) * period;
}

// Speed and share at a pace of a junction with a load.
static inline nck_status_t decide_pace(nck_lookahead_t *self, const crossing_t *crossing,
                                       int pace) {
    const double v = self->next.v[pace];
    const double reach = reach_at(self, v, crossing->period);
    if (!(nck_min(crossing->in->length, crossing->out->length) < reach)) {
        const double v_true = nck_max(v, self->terms->v_filter);
        settle(self, crossing, pace, v,
               nck_corner_share_alone(v_true, crossing->in->load, crossing->period));
        return NCK_OK;
    }
    return decide_near(self, crossing, pace, v, reach);
}

// The next junction, between two known segs, has a load: what it is crossed at alone, at both
// paces. Where a neighbour that hangs on a seg still to come may be nearer no walk so far would
// come to an end, and none is begun.
static void weigh(nck_lookahead_t *self) {
    const uint32_t count = self->junction.decided;
    const nck_junction_t *const in = nck_junction_at(self, count);
    const nck_junction_t *const out = nck_junction_at(self, count + 1);
    const double period = self->terms->machine->period_s;
    set_share(self, in, out, period);
    const double most = nck_corner_speed_alone(self->next.beta, in->load, period);
    for (int k = 0; k < NCK_PACES; k++) {
        self->next.v[k] = nck_min(most, nck_min(in->pace[k].v, out->pace[k].v));
    }
    self->next.is_weighed = 1;
    if (count + 2 != self->junction.head || self->ended) return;
    const double reach = reach_at(self, self->next.v[NCK_PACE_OVER], period);
    if (out->length < reach) self->junction.known = self->junction.head;
}

// A junction between two known segs, at both paces, which mean the same where only the junction
// limits the speed. The faster one reaches further: it tells first whether enough is known. A stop
// takes no share.
static nck_status_t decide_corner(nck_lookahead_t *self, nck_junction_t *junction) {
    if (!self->next.is_weighed) weigh(self);
    if (self->junction.known == self->junction.head && !self->ended) return NCK_EMPTY;
    const nck_junction_t *const out = nck_junction_at(self, self->junction.decided + 1);
    const crossing_t crossing = {junction, out, self->terms->machine->period_s};
    nck_pace_t *const pace = junction->pace;
    nck_status_t status = decide_pace(self, &crossing, NCK_PACE_OVER);
    if (status == NCK_OK && self->next.v[NCK_PACE_FEED] == self->next.v[NCK_PACE_OVER]) {
        pace[NCK_PACE_FEED].v_corner = pace[NCK_PACE_OVER].v_corner;
        pace[NCK_PACE_FEED].share = pace[NCK_PACE_OVER].share;
    } else if (status == NCK_OK) {
        status = decide_pace(self, &crossing, NCK_PACE_FEED);
    }
    if (status != NCK_OK) return status;
    if (!self->terms->limits_jerk) count_even(self, junction);
    for (int k = 0; k < NCK_PACES && (junction->end & NCK_JUNCTION_STOP); k++) {
        pace[k].v_corner = 0.0;
        pace[k].share = 0.0;
    }
    return NCK_OK;
}

nck_status_t nck_corner_decide(nck_lookahead_t *self) {
    nck_junction_t *const junction = nck_junction_at(self, self->junction.decided);
    if (self->junction.decided + 1 == self->junction.head) junction->end |= NCK_JUNCTION_STOP;
    if (junction->load > 0.0) {
        const nck_status_t status = decide_corner(self, junction);
        if (status == NCK_EMPTY) self->junction.known = self->junction.head;
        if (status != NCK_OK) return status;
    } else if (junction->end & NCK_JUNCTION_STOP) {
        self->even = 0.0f;
    }
    self->junction.decided++;
    self->next.is_weighed = 0;
    const int has_out = self->junction.settled - self->junction.decided > 1;
    if (has_out && nck_junction_at(self, self->junction.decided)->load > 0.0) weigh(self);
    return NCK_OK;
}
