// SPDX-License-Identifier: MIT
// Inside room 3: is a corner faster as a bend of the spline, or as a stop?
//
// Within the tolerance a spline takes a sharp corner at a speed that falls with the tolerance, and
// the path slows down to it and speeds up again. A stop spends no time in a bend, but some periods
// at rest. Each is judged by its time over half of either block, the next corners being alike.
#include "nck/prep/3_smooth/choice.h"

#include <string.h> // memcpy

#include "nck/base/budget.h"               // NCK_BUDGET_… NCK_UNLIMITED
#include "nck/base/path.h"                 // nck_path_tangent_part nck_path_slope
#include "nck/base/real.h"                 // nck_min nck_max
#include "nck/base/scurve_math.h"          // nck_scurve_…
#include "nck/base/root_math.h"            // nck_root_cube
#include "nck/prep/3_smooth/spline_math.h" // nck_spline_…

#define HALF 0.495           // of a block, for the corner at one of its ends
#define ZONES_CUT 1.3        // see SPLIT_ZONES of room 4
#define STANDSTILL 1e-3
#define ALIKE 0.01           // of a bend's half-width: a shorter block is a part of the corner
#define OWN 0.7              // of the spline's turn that a corner has to make for a stop to help
#define FREE 1.6              // times the speed beside it: a bend that allows so much has that one
#define TURNS_ON 1.02         // of a corner's turn is the bend's: other corners in it turn alike
// Of a bend's half-width: corners that are nearer to each other are many, and further few.
#define MANY 0.1
#define FEW 0.3
#define UNEVEN 2.5            // times as much costs the turn of such a bend, whose knots are uneven
// So many times the turn of two corners' bend counts that are one, and less by their distance in
// spacings.
#define BACK 3.5
#define BACK_APART 3.0
enum { HALVINGS = 12 };      // of a speed that is sought: to 1e-3 of it

// What a corner is like. Speeds in path mm/s.
typedef struct corner {
    double in[NCK_AXIS_MAX];  // dp/ds of both blocks where they meet
    double out[NCK_AXIS_MAX];
    double turn;              // |out − in| of the unit tangents
    double length[2];         // of either block [path mm]
    double half[2];           // how much of it is this corner's [path mm]
    uint8_t rests[2];         // 1: the path rests at the block's other end
    nck_scurve_t ramp[2];     // along either block
    double v_max;             // of both [path mm/s]
    const nck_terms_t *terms; // of the slope
} corner_t;

// What axes allow of a shape's |p″|·d·v² and |p‴|·d²·v³, by how long each of its axes' parts is,
// and what the chord error of one period allows of the former.
typedef struct shape_limit {
    double a, j, sag;
} shape_limit_t;

// Largest number whose product with every axis' part keeps to that axis' limit.
static double least_of(double so_far, double limit, double part) {
    const double size = nck_fabs(part);
    return size > 0.0 ? nck_min(so_far, limit / size) : so_far;
}

// What the axes allow along a block.
static nck_scurve_t limit_along(const nck_terms_t *terms, const double *tangent, double v) {
    const nck_machine_t *const machine = terms->machine;
    const int limits_jerk = terms->limits_jerk;
    const double j = limits_jerk ? terms->j_max : NCK_UNLIMITED;
    nck_scurve_t ramp = {machine->path.a_max, j, v};
    for (int x = 0; x < terms->axes; x++) {
        ramp.a = least_of(ramp.a, machine->axis[x].a_max, tangent[x]);
        if (limits_jerk) ramp.j = least_of(ramp.j, machine->axis[x].j_max, tangent[x]);
    }
    return ramp;
}

// A chord of one period may leave a bend by so much: κ·(vT)²/8 ≤ δ (room 4), as v²·κ.
static double sag_of(const nck_machine_t *machine) {
    return 8.0 * machine->path.chord_error / (machine->period_s * machine->period_s);
}

// The spline's p″ is the turn over d, its p‴ the turn over d², and more with a lift.
static shape_limit_t limit_plain(const nck_terms_t *terms, const nck_bend_t *bend) {
    const double *const turn = bend->turn;
    const double second = nck_spline_lifted_second(bend->lift);
    const double third = nck_spline_lifted_third(bend->lift);
    const nck_machine_t *const machine = terms->machine;
    const double size = nck_spline_norm(turn, terms->axes);
    const double sag = least_of(NCK_UNLIMITED, sag_of(machine), second * size);
    shape_limit_t limit = {NCK_UNLIMITED, NCK_UNLIMITED, sag};
    for (int x = 0; x < terms->axes; x++) {
        limit.a = least_of(limit.a, NCK_BUDGET_CURVE_SHARE * machine->axis[x].a_max,
                           second * turn[x]);
        if (!terms->limits_jerk) continue;
        limit.j = least_of(limit.j, NCK_BUDGET_TWIST_SHARE * machine->axis[x].j_max,
                           third * turn[x]);
    }
    return limit;
}

// What a bend of half-width d, passed at v, leaves of the limits along a block, as room 4 does it.
static nck_scurve_t left_by(const nck_scurve_t *ramp, const shape_limit_t *limit, double d,
                            double v) {
    const double bent = NCK_BUDGET_CURVE_SHARE * v * v / (limit->a * d);
    const double jerk = limit->j * d * d / NCK_BUDGET_TWIST_SHARE; // that |p‴| = 1/d² may use
    const double untwisted = 1.0 - v * v * v / jerk;
    const double steepest = NCK_BUDGET_RAMP_SHARE * untwisted * jerk / (3.0 * v * d);
    nck_scurve_t left = {nck_min((1.0 - bent) * ramp->a, steepest), ramp->j, v};
    left.j *= untwisted - 3.0 * v * left.a * d / jerk;
    return left;
}

// How much of a block the bend's limits hold in, behind the bend: the slope's filter mixes, for
// half its length, and a piece that is too short is not cut there.
static double bound_by(const corner_t *corner, double v, double a, double left) {
    const double time = corner->terms->mix_s;
    const double zone = (v + corner->terms->v_filter) * time + 0.5 * a * time * time;
    return left < ZONES_CUT * zone ? left : zone;
}

// A block from a rest to the middle of a bend.
typedef struct approach {
    double free;       // its part beyond the bend's limits [path mm]
    double bound;      // the rest of it, half of the bend included [path mm]
    double v_free;     // reached in the free part, the bend's speed at most [path mm/s]
    nck_scurve_t left; // what holds in the other one; its v_max is what is reached there
} approach_t;

// Where the free part is too short, room 4 lowers the bend's cap until the acceleration that the
// bend leaves then is enough to reach it: v² ≤ v_free² + 2·0.8·a(v)·l.
static double leveled(const nck_scurve_t *ramp, const shape_limit_t *limit, const approach_t *way,
                      double d) {
    const double apart = way->bound - 0.5 * d;
    double low = way->v_free;
    double high = way->left.v_max;
    for (int k = 0; k < HALVINGS; k++) {
        const double v = 0.5 * (low + high);
        const nck_scurve_t left = left_by(ramp, limit, d, v);
        const double a = NCK_BUDGET_STEEP_SHARE * left.a;
        const double vv = way->v_free * way->v_free + 2.0 * a * apart;
        if (v * v <= vv) low = v;
        else high = v;
    }
    return high;
}

static approach_t way_from_rest(const corner_t *corner, const shape_limit_t *limit, int n,
                                double v, double d) {
    const nck_scurve_t *const ramp = &corner->ramp[n];
    approach_t way = {0.0, 0.0, 0.0, left_by(ramp, limit, d, v)};
    const double beside = nck_max(0.0, corner->length[n] - d);
    way.free = beside - bound_by(corner, v, way.left.a, beside);
    way.bound = beside - way.free + d;
    way.v_free = nck_min(v, nck_scurve_reach(ramp, 0.0, way.free));
    if (way.v_free >= v) return way;
    way.left = left_by(ramp, limit, d, leveled(ramp, limit, &way, d));
    way.left.v_max = nck_scurve_reach(&way.left, way.v_free, way.bound);
    return way;
}

// The speed of a bend that takes d of either block, as what is left beside a rest lets it be.
static double reachable(const corner_t *corner, const shape_limit_t *limit, double v, double d) {
    double least = v;
    for (int n = 0; n < 2; n++) {
        if (!corner->rests[n]) continue;
        const approach_t way = way_from_rest(corner, limit, n, v, d);
        least = nck_min(least, way.left.v_max);
    }
    return nck_max(least, STANDSTILL * v);
}

// Time of one block up to the middle of a bend that is passed at v and takes d of it: half of the
// block if another corner follows, all of it if a rest does.
static double side_time(const corner_t *corner, const shape_limit_t *limit, int n, double v,
                        double d) {
    const nck_scurve_t *const ramp = &corner->ramp[n];
    if (!corner->rests[n]) {
        const nck_scurve_t left = left_by(ramp, limit, d, v);
        const double beside = nck_max(0.0, corner->half[n] - d);
        const double bound = bound_by(corner, v, left.a, beside);
        return (d + bound) / v + nck_scurve_over(ramp, v, beside - bound);
    }
    approach_t way = way_from_rest(corner, limit, n, v, d);
    if (way.v_free >= v) return way.bound / v + nck_scurve_to_rest(ramp, v, way.free);
    way.left.v_max = v;
    return nck_scurve_over(ramp, 0.0, way.free)
           + nck_scurve_over(&way.left, way.v_free, way.bound);
}

// Time from a stop at a block's other end over what of d is beyond that.
static double again_time(const corner_t *corner, int n, double d) {
    return nck_scurve_over(&corner->ramp[n], 0.0, nck_max(0.0, d - corner->length[n]));
}

// Time of a stop, over d of either block at least: where a block is shorter the path goes on as
// fast as it has become. That is less than stops at all the corners there would take, if they are
// alike. Under a jerk limit a block that is much shorter is a part of this corner: then the next
// corner's stop is the bound.
static double stop_time(const corner_t *corner, double d) {
    double time = 0.0;
    for (int n = 0; n < 2; n++) {
        const nck_scurve_t *const ramp = &corner->ramp[n];
        const double half = nck_scurve_over(ramp, 0.0, corner->half[n]);
        const double beyond = nck_max(0.0, d - corner->half[n]);
        double on = beyond / nck_scurve_reach(ramp, 0.0, corner->half[n]);
        if (corner->terms->limits_jerk) on = nck_min(on, half + again_time(corner, n, d));
        const int is_apart = !corner->terms->limits_jerk || corner->half[n] >= ALIKE * d;
        if (corner->rests[n]) time += 2.0 * half;
        else time += half + (is_apart ? on : nck_min(half, on));
    }
    return time + corner->terms->rest_s;
}

// What a bend allows. One that is left next to nothing is a standstill.
static double bend_speed(const corner_t *corner, const shape_limit_t *limit, double d) {
    const double vv = nck_min(limit->a, limit->sag) * d;
    const double v = nck_min(nck_root_cube(limit->j * d * d), nck_sqrt(vv));
    return nck_max(v - corner->terms->v_filter, STANDSTILL * v);
}

// Time of both blocks if nothing bends between the rest at the n-th one's other end and half of the
// other one, or the rest there.
static double straight_time(const corner_t *corner, const nck_scurve_t *ramp, int n) {
    const int m = 1 - n;
    if (!corner->rests[m]) return nck_scurve_over(ramp, 0.0, corner->length[n] + corner->half[m]);
    return 2.0 * nck_scurve_over(ramp, 0.0, 0.5 * (corner->length[0] + corner->length[1]));
}

// Time of both blocks if the bend is near a rest: the path is still speeding up in it, or comes to
// rest. From rest over x with the jerk κj:   v³ = 4.5x²κj,   v·a = 3xκj.   So the bend leaves that
//   |p‴|v³ + 3|p″|v·a + κj ≤ j:   1/κ = 1 + 4.5|p‴|x² + 9|p″|x   in units of what an axis has.
static double rising_time(const corner_t *corner, const shape_limit_t *limit, int n, double v_bend,
                          double d) {
    const nck_scurve_t *const ramps = corner->ramp;
    const nck_scurve_t ramp = {nck_min(ramps[0].a, ramps[1].a), nck_min(ramps[0].j, ramps[1].j),
                               corner->v_max};
    const double way = corner->length[n] + d;
    const double third = NCK_BUDGET_TWIST_SHARE / (limit->j * d * d);
    const double share = 1.0 / (1.0 + ramp.j * third * (4.5 * way * way + 9.0 * way * d));
    const nck_scurve_t slow = {ramp.a, share * ramp.j, ramp.v_max};
    if (nck_scurve_reach(&slow, 0.0, way) > v_bend) return NCK_UNLIMITED;
    return straight_time(corner, &ramp, n) + nck_scurve_over(&slow, 0.0, way)
           - nck_scurve_over(&ramp, 0.0, way);
}

// Time of both blocks and the bend between them.
static double plain_time(const corner_t *corner, const nck_bend_t *bend) {
    const shape_limit_t limit = limit_plain(corner->terms, bend);
    const double v_free = bend_speed(corner, &limit, bend->d);
    const double v_bend = nck_min(corner->v_max, v_free);
    const double v = reachable(corner, &limit, v_bend, bend->d);
    if (v_free > FREE * corner->v_max && !(v < corner->v_max)) return 0.0; // costs nothing
    double time = side_time(corner, &limit, 0, v, bend->d)
                  + side_time(corner, &limit, 1, v, bend->d);
    for (int n = 0; n < 2; n++) {
        if (!corner->rests[n]) continue;
        time = nck_min(time, rising_time(corner, &limit, n, v_bend, bend->d));
    }
    return time;
}

static double speed_of(const nck_smooth_t *self, const nck_seg_t *seg, const double *tangent) {
    double v = nck_min(self->terms->machine->path.feed_max, seg->rapid ? 1e9 : seg->feed);
    for (int x = 0; x < self->terms->axes; x++) {
        const nck_axis_t *const axis = &self->terms->machine->axis[x];
        v = least_of(v, seg->rapid ? axis->rapid : axis->v_max, tangent[x]);
    }
    return v;
}

// dp/ds of both blocks where they meet.
static void take_tangents(const nck_meet_t *meet, int axes, double *in_out, double *out_out) {
    const nck_seg_t *const in = &meet->a->seg;
    const nck_seg_t *const out = &meet->b->seg;
    if (in->kind != NCK_SEG_LINE || out->kind != NCK_SEG_LINE) {
        nck_path_tangent_part(in, in->length, axes, in_out);
        nck_path_tangent_part(out, 0.0, axes, out_out);
        return;
    }
    for (int x = 0; x < axes; x++) {
        in_out[x] = nck_path_slope(in, x);
        out_out[x] = nck_path_slope(out, x);
    }
}

// Length of the difference of both tangents as unit vectors: a merged line's path coordinate may be
// longer than the line.
static double turn_of(const double *in, const double *out, int axes) {
    const double size_in = nck_spline_norm(in, axes);
    const double size_out = nck_spline_norm(out, axes);
    double sum = 0.0;
    if (!(size_in > 0.0) || !(size_out > 0.0)) return 0.0;
    for (int x = 0; x < axes; x++) {
        const double apart = out[x] / size_out - in[x] / size_in;
        sum += apart * apart;
    }
    return nck_sqrt(sum);
}

// Where the corner is and how sharp.
static void measure_turn(const nck_smooth_t *self, const nck_meet_t *meet, corner_t *corner) {
    take_tangents(meet, self->terms->axes, corner->in, corner->out);
    corner->terms = self->terms;
    corner->turn = turn_of(corner->in, corner->out, self->terms->axes);
    memcpy(corner->length, meet->length, sizeof corner->length);
    memcpy(corner->rests, meet->rests, sizeof corner->rests);
    corner->half[0] = HALF * meet->length[0];
    corner->half[1] = HALF * meet->length[1];
}

// And what the machine allows beside it.
static void measure_ramps(const nck_smooth_t *self, const nck_meet_t *meet, corner_t *corner) {
    const double v_in = speed_of(self, &meet->a->seg, corner->in);
    const double v_out = speed_of(self, &meet->b->seg, corner->out);
    corner->ramp[0] = limit_along(self->terms, corner->in, v_in);
    corner->ramp[1] = limit_along(self->terms, corner->out, v_out);
    corner->v_max = nck_min(v_in, v_out);
}

int nck_choice_wide(const nck_smooth_t *self, const nck_meet_t *meet, const nck_bend_t *wide,
                    const nck_bend_t *narrow) {
    corner_t corner;
    measure_turn(self, meet, &corner);
    measure_ramps(self, meet, &corner);
    return plain_time(&corner, wide) < plain_time(&corner, narrow);
}

// 1 if the bend of a corner which turns by so much is its own, not that of a curve which it is a
// part of.
static int is_own(double turn, const nck_bend_t *bend, int axes) {
    return !(turn < OWN * nck_spline_norm(bend->turn, axes));
}

// 1 if the bend reaches to a few other corners, and they turn on: then its knots are uneven, and
// nearer to each other than is reckoned.
static int is_shared(const corner_t *corner, const nck_bend_t *bend) {
    const double turn = nck_spline_norm(bend->turn, corner->terms->axes);
    double room[2];
    for (int n = 0; n < 2; n++) {
        room[n] = (corner->rests[n] ? corner->length[n] : corner->half[n]) / bend->d;
    }
    const double least = nck_min(room[0], room[1]);
    return least > MANY && least < FEW && turn > TURNS_ON * corner->turn;
}

// How many times the bend's turn counts. The nearer two corners that share it are to each other,
// the more it is a way back: there an axis has to stop in the bend, too.
static double turn_counts(const corner_t *corner, const nck_meet_t *meet,
                          const nck_bend_t *bend) {
    if (meet->a->key != NCK_KEY_PAIR) return is_shared(corner, bend) ? UNEVEN : 1.0;
    return nck_max(1.0, BACK - BACK_APART * (meet->b->seg.length / meet->a->spacing));
}

int nck_choice_may_stop(const nck_smooth_t *self, const nck_meet_t *meet, const nck_bend_t *bend) {
    const int axes = self->terms->axes;
    double in[NCK_AXIS_MAX];
    double out[NCK_AXIS_MAX];
    take_tangents(meet, axes, in, out);
    return is_own(turn_of(in, out, axes), bend, axes);
}

int nck_choice_stop(const nck_smooth_t *self, const nck_meet_t *meet, const nck_bend_t *bend) {
    corner_t corner;
    measure_turn(self, meet, &corner);
    if (!is_own(corner.turn, bend, self->terms->axes)) return 0;
    measure_ramps(self, meet, &corner);
    nck_bend_t steep = *bend;
    const double times = turn_counts(&corner, meet, bend);
    for (int x = 0; x < self->terms->axes; x++) steep.turn[x] *= times;
    return stop_time(&corner, bend->d) < plain_time(&corner, &steep);
}
