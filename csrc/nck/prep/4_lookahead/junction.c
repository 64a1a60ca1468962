// SPDX-License-Identifier: MIT
// Inside room 4: caps of segs.
#include "nck/prep/4_lookahead/junction.h"

#include "nck/base/budget.h"                  // NCK_UNLIMITED
#include "nck/base/path.h"                    // nck_path_…_part
#include "nck/base/path_math.h"               // nck_path_turns
#include "nck/base/root_math.h"               // nck_root_cube
#include "nck/base/thread.h"                  // nck_thread_rest_s
#include "nck/prep/4_lookahead/budget_math.h" // nck_budget_…
#include "nck/prep/4_lookahead/limit_math.h"  // nck_limit_…

// A spline is parted if |p″|v² changes by more than this share of an axis' acceleration.
#define PART_CHANGE 0.02

static void cap_feed(nck_junction_t *junction, double v, int limit) {
    if (v < junction->v_max) {
        junction->v_max = v;
        junction->limit = (uint8_t)limit;
    }
}

static void cap_speed(nck_junction_t *junction, double v, int limit) {
    cap_feed(junction, v, limit);
    if (v < junction->v_free) {
        junction->v_free = v;
        junction->limit_free = (uint8_t)limit;
    }
}

// Σ u_x v_x.
static double product(const double *u, const double *v, int axes) {
    double sum = 0.0;
    for (int x = 0; x < axes; x++) sum += u[x] * v[x];
    return sum;
}

// Rows of a bend: the axes', and the path's own.
static int bent_rows(const nck_terms_t *terms) {
    return NCK_HAS_OPTIMAL && terms->limits_path ? terms->axes + 1 : terms->axes;
}

// One of them: the limits of acceleration and jerk, and bounds on |p′|, |p″| and |p‴|.
typedef struct bend_row {
    double a, j, first, second, third;
} bend_row_t;

static bend_row_t row_of(const nck_junction_t *junction, const nck_terms_t *terms, int x) {
    const nck_machine_t *const machine = terms->machine;
    const nck_junction_bend_t *const bend = &junction->shape.bend;
    bend_row_t row = {machine->path.a_max, machine->path.j_max, 0.0, (double)bend->along[0],
                      (double)bend->along[1]};
    if (x == terms->axes) {
        row.first = nck_sqrt(product(bend->first, bend->first, terms->axes));
        return row;
    }
    row.a = machine->axis[x].a_max;
    row.j = machine->axis[x].j_max;
    row.first = bend->first[x];
    row.second = bend->second[x];
    row.third = bend->third[x];
    return row;
}

// How much of the path speed an axis sees at most: its direction cosine, on an arc the largest one.
static double largest_cosine(const nck_junction_t *junction, const nck_seg_t *seg, int x,
                             const double *t_in, const double *t_out) {
    if (seg->kind == NCK_SEG_SPLINE) return junction->shape.bend.first[x];
    if (!nck_path_turns(seg, x)) return nck_fabs(t_in[x]);
    const nck_seg_arc_t *const arc = &seg->shape.arc;
    const double cos_lambda = junction->shape.arc.cos_lambda;
    if (nck_fabs(arc->sweep) >= NCK_PI) return cos_lambda;
    const int across = x == arc->axis_u ? arc->axis_v : arc->axis_u;
    return cos_lambda * nck_limit_arc_cos(t_in[x] / cos_lambda, t_in[across] / cos_lambda,
                                          t_out[x] / cos_lambda, t_out[across] / cos_lambda);
}

// is_line: known where it is called, so that a line's loop asks for nothing that lines have not.
static inline void cap_by_axes(nck_junction_t *junction, const nck_seg_t *seg, const double *t_in,
                               const double *t_out, const nck_terms_t *terms, int is_line) {
    const nck_machine_t *const machine = terms->machine;
    double v = NCK_UNLIMITED;
    double a_straight = NCK_UNLIMITED;
    double j = terms->j_max;
    int slowest = NCK_AXIS_X;
    for (int x = 0; x < terms->axes; x++) {
        const nck_axis_t *const axis = &machine->axis[x];
        const double c =
            is_line ? nck_fabs(t_in[x]) : largest_cosine(junction, seg, x, t_in, t_out);
        if (!(c > 0.0)) continue;
        const double v_axis = nck_limit_along(seg->rapid ? axis->rapid : axis->v_max, c);
        if (v_axis < v) slowest = x;
        v = nck_min(v, v_axis);
        j = nck_min(j, nck_limit_along(axis->j_max, c));
        if (!is_line && nck_path_turns(seg, x)) {
            junction->shape.arc.a_plane = nck_min(junction->shape.arc.a_plane, axis->a_max);
            junction->shape.arc.j_plane = nck_min(junction->shape.arc.j_plane, axis->j_max);
        } else {
            a_straight = nck_min(a_straight, nck_limit_along(axis->a_max, c));
        }
    }
    cap_speed(junction, v, seg->rapid ? NCK_LIMIT_RAPID : NCK_LIMIT_AXIS_V + slowest);
    junction->a_most = nck_min(machine->path.a_max, a_straight);
    if (seg->kind != NCK_SEG_SPLINE) junction->shape.arc.a_straight = a_straight;
    junction->j_straight = j;
}

static int is_curved(const nck_junction_t *junction) {
    return junction->kind == NCK_SEG_ARC && junction->shape.arc.kappa > 0.0;
}

static void make_arc(nck_junction_t *junction, const nck_seg_t *seg, const nck_machine_t *machine) {
    const nck_seg_arc_t *const arc = &seg->shape.arc;
    const double ru = seg->start[arc->axis_u] - arc->centre_u;
    const double rv = seg->start[arc->axis_v] - arc->centre_v;
    const double r = nck_sqrt(ru * ru + rv * rv);
    const double cos_lambda = nck_min(1.0, r * nck_fabs(arc->sweep) / seg->length);
    const double v = nck_limit_chord(r, machine->path.chord_error, machine->period_s);
    junction->shape.arc.a_plane = NCK_UNLIMITED; // cap_by_axes finds both
    junction->shape.arc.j_plane = NCK_UNLIMITED;
    junction->shape.arc.cos_lambda = cos_lambda;
    junction->shape.arc.kappa = cos_lambda * cos_lambda / r;
    cap_speed(junction, v / cos_lambda, NCK_LIMIT_CHORD);
}

// The same along the path: of p″ and p‴ what lies in the direction of p′ at both ends, and what a
// direction leaves of their length that turns by so much between them. Where p′ is nothing it is
// all of it.
static void bound_along(nck_junction_bend_t *bend, double (*at)[2][NCK_AXIS_MAX],
                        const double *third, int axes) {
    const double whole[2] = {nck_sqrt(product(bend->second, bend->second, axes)),
                             nck_sqrt(product(bend->third, bend->third, axes))};
    double turn = 1.0;
    double along[2] = {0.0, 0.0};
    double size[2];
    for (int k = 0; k < 2; k++) size[k] = nck_sqrt(product(at[k][0], at[k][0], axes));
    if (size[0] * size[1] > 0.0) {
        const double cosine = product(at[0][0], at[1][0], axes) / (size[0] * size[1]);
        turn = cosine > 0.0 ? nck_sqrt(nck_max(0.0, 2.0 - 2.0 * cosine)) : 1.0;
        for (int k = 0; k < 2; k++) {
            const double second = product(at[k][0], at[k][1], axes) / size[k];
            const double twist = product(at[k][0], third, axes) / size[k];
            along[0] = nck_max(along[0], nck_fabs(second));
            along[1] = nck_max(along[1], nck_fabs(twist));
        }
    }
    bend->along[0] = (float)nck_min(whole[0], along[0] + turn * whole[0]);
    bend->along[1] = (float)nck_min(whole[1], along[1] + turn * whole[1]);
}

// The largest of each axis' derivatives on a spline between two places: |p″| at one of them, |p‴|
// the same everywhere, and |p′|, a parabola, above its chord by no more than |p‴|·h²/8.
static void bound_spline(nck_junction_t *junction, const nck_seg_t *seg, const double span[2],
                         const nck_terms_t *terms) {
    double at[2][2][NCK_AXIS_MAX];
    double third[NCK_AXIS_MAX];
    for (int k = 0; k < 2; k++) {
        nck_path_tangent_part(seg, span[k], terms->axes, at[k][0]);
        nck_path_second_part(seg, span[k], terms->axes, at[k][1]);
    }
    nck_junction_bend_t *const bend = &junction->shape.bend;
    nck_path_third_part(seg, 0.0, terms->axes, third);
    for (int x = 0; x < terms->axes; x++) {
        bend->third[x] = nck_fabs(third[x]);
        const double bulge = bend->third[x] * junction->length * junction->length / 8.0;
        bend->first[x] = nck_max(nck_fabs(at[0][0][x]), nck_fabs(at[1][0][x])) + bulge;
        bend->second[x] = nck_max(nck_fabs(at[0][1][x]), nck_fabs(at[1][1][x]));
    }
    if (bent_rows(terms) > terms->axes) bound_along(bend, at, third, terms->axes);
}

// Speed over a smooth piece: chord error, and what bends cost of every axis' acceleration and jerk.
static void make_spline(nck_junction_t *junction, const nck_terms_t *terms) {
    const nck_machine_t *const machine = terms->machine;
    double bend = 0.0;
    double twist = NCK_UNLIMITED;
    for (int x = 0; x < bent_rows(terms); x++) {
        const bend_row_t row = row_of(junction, terms, x);
        if (x < terms->axes) bend += row.second * row.second;
        if (row.second > 0.0) {
            const double vv = nck_budget_curve(row.a, row.second);
            cap_speed(junction, nck_sqrt(vv), NCK_LIMIT_CURVATURE);
        }
        if (row.third > 0.0) twist = nck_min(twist, nck_budget_twist(row.j, row.third));
    }
    if (bend > 0.0) {
        const double delta = machine->path.chord_error;
        const double v = nck_limit_sag(nck_sqrt(bend), delta, machine->period_s);
        cap_speed(junction, v, NCK_LIMIT_CHORD);
    }
    if (terms->limits_jerk && twist < NCK_UNLIMITED) {
        cap_speed(junction, nck_root_cube(twist), NCK_LIMIT_JERK);
    }
}

// 1 if one of some axes moves straight, the last of them left out.
static inline int moves_of(const nck_seg_t *seg, int first, int last) {
    for (int x = first; x < last && x < NCK_AXIS_MAX; x++) {
        if (seg->start[x] != seg->end[x]) return 1;
    }
    return 0;
}

// 1 if X Y Z U V or W moves.
static inline int moves_linear(const nck_seg_t *seg) {
    return moves_of(seg, NCK_AXIS_X, NCK_AXIS_A) || seg->kind == NCK_SEG_ARC
           || moves_of(seg, NCK_AXIS_U, NCK_AXIS_MAX);
}

// What a junction has of its seg, before any cap. What else a moving junction has of before it is
// settled make_caps sets; its shape, if it is no rest, is another's.
static inline void begin(nck_junction_t *junction, const nck_seg_t *seg) {
    junction->seq = seg->seq;
    junction->kind = seg->kind;
    junction->limit = NCK_LIMIT_FEED;
    junction->limit_free = NCK_LIMIT_FEED;
    junction->end = seg->stop ? NCK_JUNCTION_STOP | NCK_JUNCTION_LAST : NCK_JUNCTION_LAST;
    if (seg->keeps == NCK_KEEP_TURNS) junction->end |= NCK_JUNCTION_TURNS;
    if (seg->keeps == NCK_KEEP_SMOOTH) junction->end |= NCK_JUNCTION_SMOOTH;
    junction->length = seg->length;
    junction->feed = seg->feed;
    junction->tool = moves_linear(seg) ? seg->feed_scale : 0.0;
    junction->v_max = NCK_UNLIMITED;
    junction->v_free = NCK_UNLIMITED;
    junction->load = 0.0;
    for (int k = 0; k < NCK_PACES; k++) {
        junction->pace[k].v_corner = NCK_UNLIMITED;
        junction->pace[k].share = 0.0;
    }
}

// A rest has no cap of its own.
static void make_rest(nck_junction_t *junction, const nck_seg_t *seg) {
    junction->w_near = 0.0;
    junction->j_straight = 0.0;
    junction->a_most = 0.0;
    junction->shape.dwell_s = nck_thread_rest_s(seg);
}

// What accelerates at a has come from a = 0 at rest, what brakes at a has to come to it:
//   v ≥ a²/2j,   a ≤ √(2v·j)
// More than that is never had, and a profile is the nearer to its optimum the less it may have.
static inline void cap_by_jerk(nck_junction_t *junction, double j) {
    const double aa = 2.0 * junction->v_free * j;
    if (junction->a_most * junction->a_most > aa) junction->a_most = nck_sqrt(aa);
}

// An arc by its plane's axes.
static void limit_arc(nck_junction_t *junction, const nck_terms_t *terms) {
    const nck_junction_arc_t *const arc = &junction->shape.arc;
    junction->a_most = nck_min(junction->a_most, arc->a_plane / arc->cos_lambda);
    if (!terms->limits_jerk) return;
    const double cube = nck_limit_arc_cube(arc->j_plane, arc->kappa, arc->cos_lambda);
    cap_speed(junction, nck_root_cube(cube), NCK_LIMIT_JERK);
}

static inline void make_caps(nck_junction_t *junction, const nck_seg_t *seg,
                             const double *tangent_start, const double *tangent_end,
                             const nck_terms_t *terms) {
    const nck_machine_t *const machine = terms->machine;
    if (!seg->rapid) {
        cap_feed(junction, seg->feed, NCK_LIMIT_FEED);
        cap_speed(junction, machine->path.feed_max / seg->feed_scale, NCK_LIMIT_FEED_MAX);
    }
    if (seg->v_most > 0.0) cap_speed(junction, seg->v_most, NCK_LIMIT_SPINDLE);
    if (seg->kind == NCK_SEG_ARC) make_arc(junction, seg, machine);
    if (seg->kind == NCK_SEG_SPLINE) make_spline(junction, terms);
    if (seg->kind == NCK_SEG_LINE) cap_by_axes(junction, seg, tangent_start, tangent_end, terms, 1);
    else cap_by_axes(junction, seg, tangent_start, tangent_end, terms, 0);
    if (is_curved(junction)) limit_arc(junction, terms);
    junction->w_near = junction->v_free * junction->v_free;
    if (terms->limits_jerk) cap_by_jerk(junction, terms->j_max);
}

// A rest to this room; the path goes on, if it is not one.
static void make_clocked(nck_junction_t *junction, const nck_seg_t *seg, const nck_terms_t *terms) {
    const double most = terms->machine->path.feed_max / seg->feed_scale;
    junction->kind = NCK_JUNCTION_CLOCKED;
    if (seg->stop) junction->end |= NCK_JUNCTION_RESTS;
    junction->end |= NCK_JUNCTION_STOP;
    junction->length = 0.0;
    junction->w_near = 0.0;
    junction->j_straight = 0.0;
    junction->a_most = 0.0;
    junction->shape.clocked = seg->length;
    if (!seg->rapid && most < seg->feed) junction->limit = NCK_LIMIT_FEED_MAX;
    if (seg->rapid) junction->limit = NCK_LIMIT_RAPID;
    junction->v_free = seg->rapid ? seg->v_most : most;
}

void nck_junction_make(nck_junction_t *junction, const nck_seg_t *seg, const double span[2],
                       const double *tangent_start, const double *tangent_end,
                    const nck_terms_t *terms) {
    begin(junction, seg);
    if (seg->kind >= NCK_SEG_DWELL) {
        make_rest(junction, seg);
        return;
    }
    if (NCK_HAS_OPTIMAL && seg->keeps == NCK_KEEP_CLOCK) {
        make_clocked(junction, seg, terms);
        return;
    }
    if (seg->kind == NCK_SEG_SPLINE) {
        junction->shape.bend.s = span[0];
        junction->length = span[1] - span[0];
        if (span[1] < seg->length) junction->end &= NCK_JUNCTION_TURNS | NCK_JUNCTION_SMOOTH;
        bound_spline(junction, seg, span, terms);
    }
    make_caps(junction, seg, tangent_start, tangent_end, terms);
}

// Parts no shorter than the reach of what the filter mixes, if the curvature changes so much in the
// seg that they will differ.
int nck_junction_parts(const nck_junction_t *junction, const nck_terms_t *terms) {
    const nck_machine_t *const machine = terms->machine;
    const double mixed = junction->v_free * terms->mix_s;
    double change = 0.0;
    if (!(mixed > 0.0)) return 1;
    for (int x = 0; x < terms->axes; x++) {
        const double third = junction->shape.bend.third[x];
        const nck_axis_t *const axis = &machine->axis[x];
        const double bend = third * junction->length * junction->v_free * junction->v_free;
        const double aa = nck_min(axis->a_max * axis->a_max, junction->v_free * axis->j_max);
        change = nck_max(change, bend * bend / aa);
    }
    if (change < PART_CHANGE * PART_CHANGE || junction->length < 2.0 * mixed) return 1;
    return (int)nck_min((double)NCK_SPLINE_PARTS, nck_floor(junction->length / mixed));
}

double nck_junction_a_any(const nck_machine_t *machine) {
    double sum = 0.0;
    for (int x = 0; x < NCK_AXIS_MAX; x++) {
        if (machine->axis[x].present) sum += machine->axis[x].a_max * machine->axis[x].a_max;
    }
    return nck_min(machine->path.a_max, nck_sqrt(sum));
}

// v² where a speed is v_filter more than planned.
static double raised(double vv, double v_filter) {
    if (!(v_filter > 0.0)) return vv;
    const double v = nck_sqrt(vv) + v_filter;
    return v * v;
}

// The speed that an arc is taken at where the slope's filter adds to it; no more than its jerk lets
// it be.
static double arc_speed(const nck_junction_t *junction, double vv, const nck_terms_t *terms) {
    return nck_min(nck_sqrt(vv) + terms->v_filter, junction->v_free);
}

// What the jerk of an arc's plane leaves of the path's acceleration at speed v.
static double ramp_on_arc(const nck_junction_arc_t *arc, double v) {
    const double twist = nck_limit_arc_twist(v, arc->kappa, arc->cos_lambda);
    return nck_limit_arc_ramp(arc->j_plane, twist, v * arc->kappa);
}

// What it leaves of the path's jerk at v and a.
static double jerk_on_arc(const nck_junction_arc_t *arc, double v, double a) {
    const double twist = nck_limit_arc_twist(v, arc->kappa, arc->cos_lambda);
    return nck_limit_arc_jerk(arc->j_plane, twist, 3.0 * v * arc->kappa * a, arc->cos_lambda);
}

// An arc's curvature caps the speed, and what it uses of the acceleration at the speed allowed is
// lost to the tangential one.
static void limit_on_arc(const nck_junction_t *junction, double beta, const nck_terms_t *terms,
                         nck_piece_limit_t *piece) {
    const nck_junction_arc_t *const arc = &junction->shape.arc;
    const double vv_curve = nck_limit_curve(arc->a_plane, arc->kappa, beta);
    piece->vv_free = nck_min(piece->vv_free, vv_curve);
    if (vv_curve < piece->vv) {
        piece->vv = vv_curve;
        piece->limit = NCK_LIMIT_CURVATURE;
    }
    const double vv = nck_min(vv_curve, raised(piece->vv, terms->v_filter));
    const double a_arc =
        nck_limit_arc_accel((1.0 - beta) * arc->a_plane, vv * arc->kappa, arc->cos_lambda);
    piece->a = nck_min(piece->a, a_arc);
    if (!terms->limits_jerk) return;
    piece->a = nck_min(piece->a, ramp_on_arc(arc, arc_speed(junction, piece->vv, terms)));
}

// The tangential jerk left on an arc at a pace, which is least where no junction takes a share:
// then the speed and, where not the jerk itself limits it, the acceleration are highest.
static void settle_arc(const nck_junction_t *junction, nck_pace_t *at, const nck_terms_t *terms) {
    nck_piece_limit_t piece = {at->v * at->v, 0.0, nck_junction_straight(junction, 0.0), at->j,
                               junction->limit};
    limit_on_arc(junction, 0.0, terms, &piece);
    const double v = arc_speed(junction, piece.vv, terms);
    at->j = nck_min(at->j, jerk_on_arc(&junction->shape.arc, v, piece.a));
}

static double accel_left(const nck_junction_t *junction, double v, const nck_terms_t *terms) {
    double a = junction->a_most;
    for (int x = 0; x < bent_rows(terms); x++) {
        const bend_row_t row = row_of(junction, terms, x);
        if (!(row.first > 0.0)) continue;
        a = nck_min(a, nck_budget_accel(row.a, row.first, row.second, v));
        // At rest a bend costs nothing.
        if (!terms->limits_jerk || !(row.second * v > 0.0)) continue;
        a = nck_min(a, nck_budget_ramp(row.j, row.second, row.third, v));
    }
    return a;
}

double nck_junction_bends(const nck_junction_t *junction, const nck_terms_t *terms) {
    double least = NCK_UNLIMITED;
    if (is_curved(junction)) return junction->shape.arc.j_plane / junction->shape.arc.kappa;
    if (junction->kind != NCK_SEG_SPLINE) return least;
    for (int x = 0; x < bent_rows(terms); x++) {
        const bend_row_t row = row_of(junction, terms, x);
        if (row.second > 0.0) least = nck_min(least, row.j / row.second);
    }
    return least;
}

double nck_junction_left(const nck_junction_t *junction, double w, const nck_terms_t *terms) {
    return accel_left(junction, nck_sqrt(w), terms);
}

// What a spline's bends leave of all axes' acceleration and jerk at speed v.
static void limit_spline(const nck_junction_t *junction, nck_pace_t *at, double v,
                         const nck_terms_t *terms) {
    at->a = accel_left(junction, v, terms);
    at->j = junction->j_straight;
    for (int x = 0; terms->limits_jerk && x < bent_rows(terms); x++) {
        const bend_row_t row = row_of(junction, terms, x);
        if (!(row.first > 0.0)) continue;
        at->j = nck_min(at->j, nck_budget_jerk(row.j, row.first, row.second, row.third, v, at->a));
    }
}

// The least time that a junction takes at a pace, entered at w_in at most: its acceleration gains
// no more.
static double least_time(const nck_junction_t *junction, double w_in, const nck_pace_t *at) {
    const double v_in = nck_sqrt(w_in);
    const double v_out = nck_sqrt(w_in + 2.0 * at->a * junction->length);
    return v_out > v_in && v_out < at->v ? 2.0 * junction->length / (v_in + v_out) : at->time;
}

void nck_junction_settle_more(nck_junction_t *junction, double v_free, double w_in,
                              const nck_terms_t *terms) {
    for (int k = 0; k < NCK_PACES && junction->kind == NCK_SEG_SPLINE; k++) {
        nck_pace_t *const at = &junction->pace[k];
        limit_spline(junction, at, nck_min(at->v + terms->v_filter, v_free), terms);
    }
    for (int k = 0; k < NCK_PACES && terms->limits_jerk && is_curved(junction); k++) {
        settle_arc(junction, &junction->pace[k], terms);
    }
    for (int k = 0; k < NCK_PACES && terms->limits_jerk; k++) {
        junction->pace[k].least = least_time(junction, w_in, &junction->pace[k]);
    }
}

nck_piece_limit_t nck_junction_curved(const nck_junction_t *junction, double beta, int pace,
                                      const nck_terms_t *terms) {
    const nck_pace_t *const at = &junction->pace[pace];
    nck_piece_limit_t piece = {at->v * at->v, junction->v_free * junction->v_free,
                               terms->machine->path.a_max, at->j, junction->limit};
    if (junction->kind == NCK_SEG_SPLINE) {
        piece.vv *= 1.0 - beta;
        piece.vv_free = (1.0 - beta) * junction->w_near;
        piece.a = (1.0 - beta) * at->a;
        return piece;
    }
    piece.a = nck_junction_straight(junction, beta);
    if (is_curved(junction)) limit_on_arc(junction, beta, terms, &piece);
    return piece;
}
