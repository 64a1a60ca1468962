// SPDX-License-Identifier: MIT
// Inside room 4: caps of segs.
#include "nck/prep/4_lookahead/junction.h"

#include "nck/base/budget.h"                  // NCK_UNLIMITED
#include "nck/base/path.h"                    // nck_path_…_part
#include "nck/base/path_math.h"               // nck_path_turns
#include "nck/base/root_math.h"               // nck_root_cube
#include "nck/base/thread.h"                  // nck_thread_rest_s
#include "nck/prep/4_lookahead/limit_math.h"  // nck_limit_…

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

// How much of the path speed an axis sees at most: its direction cosine, on an arc the largest one.
static double largest_cosine(const nck_junction_t *junction, const nck_seg_t *seg, int x,
                             const double *t_in, const double *t_out) {
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
    junction->shape.arc.a_straight = a_straight;
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
    junction->end = seg->stop ? NCK_JUNCTION_STOP : 0;
    if (seg->keeps == NCK_KEEP_TURNS) junction->end |= NCK_JUNCTION_TURNS;
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
    if (seg->kind == NCK_SEG_LINE) cap_by_axes(junction, seg, tangent_start, tangent_end, terms, 1);
    else cap_by_axes(junction, seg, tangent_start, tangent_end, terms, 0);
    if (is_curved(junction)) limit_arc(junction, terms);
    if (terms->limits_jerk) cap_by_jerk(junction, terms->j_max);
}

// A rest to this room; the path goes on, if it is not one.
static void make_clocked(nck_junction_t *junction, const nck_seg_t *seg, const nck_terms_t *terms) {
    const double most = terms->machine->path.feed_max / seg->feed_scale;
    junction->kind = NCK_JUNCTION_CLOCKED;
    if (seg->stop) junction->end |= NCK_JUNCTION_RESTS;
    junction->end |= NCK_JUNCTION_STOP;
    junction->length = 0.0;
    junction->j_straight = 0.0;
    junction->a_most = 0.0;
    junction->shape.clocked = seg->length;
    if (!seg->rapid && most < seg->feed) junction->limit = NCK_LIMIT_FEED_MAX;
    if (seg->rapid) junction->limit = NCK_LIMIT_RAPID;
    junction->v_free = seg->rapid ? seg->v_most : most;
}

void nck_junction_make(nck_junction_t *junction, const nck_seg_t *seg, const double *tangent_start,
                       const double *tangent_end, const nck_terms_t *terms) {
    begin(junction, seg);
    if (seg->kind >= NCK_SEG_DWELL) { // a rest has no cap of its own
        junction->j_straight = 0.0;
        junction->a_most = 0.0;
        junction->shape.dwell_s = nck_thread_rest_s(seg);
        return;
    }
    if (NCK_HAS_OPTIMAL && seg->kind == NCK_SEG_SPLINE) {
        make_clocked(junction, seg, terms);
        return;
    }
    make_caps(junction, seg, tangent_start, tangent_end, terms);
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
static void limit_on_arc(const nck_junction_t *junction, double left, const nck_terms_t *terms,
                         nck_piece_limit_t *piece) {
    const nck_junction_arc_t *const arc = &junction->shape.arc;
    const double vv_curve = nck_limit_curve(arc->a_plane, arc->kappa, left);
    piece->vv_free = nck_min(piece->vv_free, vv_curve);
    if (vv_curve < piece->vv) {
        piece->vv = vv_curve;
        piece->limit = NCK_LIMIT_CURVATURE;
    }
    const double vv = nck_min(vv_curve, raised(piece->vv, terms->v_filter));
    const double a_arc = nck_limit_arc_accel(left * arc->a_plane, vv * arc->kappa, arc->cos_lambda);
    piece->a = nck_min(piece->a, a_arc);
    if (!terms->limits_jerk) return;
    piece->a = nck_min(piece->a, ramp_on_arc(arc, arc_speed(junction, piece->vv, terms)));
}

// The tangential jerk left on an arc at a pace, which is least where no junction takes a share:
// then the speed and, where not the jerk itself limits it, the acceleration are highest.
static void settle_arc(const nck_junction_t *junction, nck_pace_t *at, const nck_terms_t *terms) {
    nck_piece_limit_t piece = {at->v * at->v, 0.0, nck_junction_straight(junction, 1.0), at->j,
                               junction->limit};
    limit_on_arc(junction, 1.0, terms, &piece);
    const double v = arc_speed(junction, piece.vv, terms);
    at->j = nck_min(at->j, jerk_on_arc(&junction->shape.arc, v, piece.a));
}

double nck_junction_bends(const nck_junction_t *junction) {
    if (!is_curved(junction)) return NCK_UNLIMITED;
    return junction->shape.arc.j_plane / junction->shape.arc.kappa;
}

// The least time that a junction takes at a pace, entered at vv_in at most: its acceleration gains
// no more.
static double least_time(const nck_junction_t *junction, double vv_in, const nck_pace_t *at) {
    const double v_in = nck_sqrt(vv_in);
    const double v_out = nck_sqrt(vv_in + 2.0 * at->a * junction->length);
    return v_out > v_in && v_out < at->v ? 2.0 * junction->length / (v_in + v_out) : at->time;
}

void nck_junction_settle_more(nck_junction_t *junction, double vv_in, const nck_terms_t *terms) {
    for (int k = 0; k < NCK_PACES && is_curved(junction); k++) {
        settle_arc(junction, &junction->pace[k], terms);
    }
    for (int k = 0; k < NCK_PACES; k++) {
        junction->pace[k].least = least_time(junction, vv_in, &junction->pace[k]);
    }
}

nck_piece_limit_t nck_junction_curved(const nck_junction_t *junction, double left, int pace,
                                      const nck_terms_t *terms) {
    const nck_pace_t *const at = &junction->pace[pace];
    nck_piece_limit_t piece = {at->v * at->v, junction->v_free * junction->v_free,
                               nck_junction_straight(junction, left), at->j, junction->limit};
    if (is_curved(junction)) limit_on_arc(junction, left, terms, &piece);
    return piece;
}
