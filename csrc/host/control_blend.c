// SPDX-License-Identifier: MIT
// LinuxCNC: lines that its naive CAM makes one of, and what stands between two moves: a stop, a
// kink that is small enough, or an arc within the tolerance. Its parabolic blends are left out.
#include "host/control_parts.h"

#include <float.h>  // DBL_MAX
#include <string.h> // memcpy memset

#include "nck/base/real.h" // nck_fabs nck_max nck_min nck_sqrt
#include "nck/base/trig.h" // nck_atan2 nck_sincos

#define PI 3.14159265358979323846
#define NM 1e-6
// Of an axis' acceleration: what a kink may take, what an arc has along and across the path.
#define KINK 0.1
#define ALONG 0.5
#define ACROSS 0.8660254037844386
// Closer to a reversal than 2° a corner is an exact stop: 1 − cos 2°.
#define SHARP 6.1e-4
// A blend takes half of a line; a line of fewer servo periods than this is part of its arc.
#define SHARE 0.5
// Without a tolerance it is this share of a line.
#define BARE 0.25
#define GAP 4.0
// A move lasts so many servo periods at least.
#define CYCLES 1.02
// No arc is shorter [mm].
#define ARC_LEAST 1e-6
// Less than this share of a line is nothing left of it.
#define NOTHING 1e-9

static double value(const nck_host_control_t *self, unsigned which) {
    return self->rule.value[which];
}

static double dot(const double a[3], const double b[3]) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

// How far a point is from the way between two others.
static double distance(const double begin[3], const double end[3], const double point[3]) {
    double way[3];
    double to[3];
    for (unsigned x = 0; x < 3; x++) {
        way[x] = end[x] - begin[x];
        to[x] = point[x] - begin[x];
    }
    const double square = dot(way, way);
    const double t = square > 0.0 ? nck_max(0.0, nck_min(1.0, dot(way, to) / square)) : 0.0;
    for (unsigned x = 0; x < 3; x++) to[x] -= t * way[x];
    return nck_sqrt(dot(to, to));
}

// What a corner takes of the axes: the most of all of them.
static double kink_of(const nck_host_control_t *self, const nck_host_control_line_t *in,
                      const nck_host_control_line_t *out) {
    const double v = nck_min(in->v, out->v);
    const double a = v / value(self, NCK_CONTROL_PERIOD_S) + out->a;
    double most = 0.0;
    for (unsigned x = 0; x < 3; x++) {
        const double step = nck_fabs(out->unit[x] - in->out[x]) * a;
        most = nck_max(most, step / value(self, NCK_CONTROL_A + x));
    }
    return in->round || out->round ? most / ALONG : most;
}

// The limit that all axes have which a corner moves.
static double common(const nck_host_control_t *self, unsigned which,
                     const nck_host_control_line_t *in, const nck_host_control_line_t *out) {
    double least = DBL_MAX;
    for (unsigned x = 0; x < 3; x++) {
        if (in->out[x] != 0.0 || out->unit[x] != 0.0) {
            least = nck_min(least, value(self, which + x));
        }
    }
    return least;
}

// The arc between two lines.
typedef struct blend {
    double v, trim, length, angle, a;
} blend_t;

//  h = T/(1 − sin θ), d = min(h cos θ, half a line), R = d tan θ, v = √(a_n R)
// θ: half of the angle between both lines. So large that the time along it is that of the parabola
// which it stands for, and no larger than T allows.
static blend_t blend_of(const nck_host_control_t *self, const nck_host_control_line_t *in,
                        const nck_host_control_line_t *out, double cosine) {
    const double sine = nck_sqrt(nck_max(0.0, 0.5 * (1.0 + cosine)));  // of θ
    const double across = nck_sqrt(nck_max(0.0, 0.5 * (1.0 - cosine))); // cos θ
    const double tolerance = nck_min(in->tolerance, out->tolerance);
    const double slope = sine / across;
    const double lengths = nck_min(nck_min(in->length, in->whole * SHARE), out->length * SHARE);
    const double way = nck_min(lengths, tolerance * across / (1.0 - sine));
    const double a = common(self, NCK_CONTROL_A, in, out);
    const double goal = nck_min(nck_max(in->v, out->v), common(self, NCK_CONTROL_V, in, out));
    blend_t blend;
    blend.angle = 2.0 * nck_atan2(across, sine);
    blend.v = nck_min(goal, nck_sqrt(a * ACROSS * slope * way));
    const double half = 0.5 * a;
    const double time_s = nck_min(nck_sqrt(2.0 * half * way), blend.v) / half;
    const double like = nck_min(time_s * blend.v / blend.angle, slope * way);
    const double radius = nck_max(blend.v * blend.v / (a * ACROSS), like);
    blend.trim = radius / slope;
    blend.length = radius * blend.angle;
    blend.a = a * ALONG;
    return blend;
}

// A line is final but for its speeds. Returns the cap for what follows: that of a line of which
// blends have left nothing.
static double give(nck_host_control_t *self, nck_host_control_line_t *line) {
    const double least = CYCLES * value(self, NCK_CONTROL_PERIOD_S);
    if (line->length <= NOTHING * line->whole) return line->cap;
    line->a *= line->keeps;
    line->gain = 2.0 * line->a * line->length;
    if (line->v > line->length / least) line->v = line->length / least;
    if (self->has_last) {
        const double v = nck_min(line->v, self->last.v);
        if (line->cap >= v * v) line->limit_cap = line->v < v ? line->limit : self->last.limit;
        line->cap = nck_min(line->cap, v * v);
    }
    nck_control_add(self, line);
    return DBL_MAX;
}

static void take_kink(nck_host_control_line_t *in, nck_host_control_line_t *out, double kink,
                      double v) {
    in->keeps = nck_min(in->keeps, 1.0 - kink);
    out->keeps = nck_min(out->keeps, 1.0 - kink);
    out->cap = v * v;
}

// Where the arc between two lines begins and ends, and how it turns.
static void lay_arc(nck_host_control_line_t *in, nck_host_control_line_t *out,
                    nck_host_control_line_t *arc, const blend_t *blend) {
    const double cosine = dot(in->out, out->unit);
    const double sine = nck_sqrt(nck_max(0.0, 1.0 - cosine * cosine));
    const double less = blend->trim / in->length;
    const double more = blend->trim / out->length;
    double before[3];
    double behind[3];
    nck_control_bend_way(in, 1.0 - less, 1.0, before);
    nck_control_bend_way(out, 0.0, more, behind);
    for (unsigned x = 0; x < 3; x++) {
        arc->end[x] = in->end[x] + behind[x];
        in->end[x] -= before[x];
        arc->unit[x] = in->out[x];
        arc->along[x] = in->out[x];
        arc->inward[x] = sine > 0.0 ? (out->unit[x] - cosine * in->out[x]) / sine : 0.0;
    }
    arc->s = in->s + blend->trim;
    in->s -= blend->trim;
    arc->turn = sine > 0.0 ? blend->angle : 0.0;
    in->turn *= 1.0 - less;
    nck_control_bend_shorten(out, more);
}

// The arc takes its part of both lines, and all of a line that is over too soon.
static void put_arc(nck_host_control_t *self, nck_host_control_line_t *out, const blend_t *blend) {
    nck_host_control_line_t *const in = &self->held;
    nck_host_control_line_t arc = *in;
    const double left = in->length - blend->trim;
    const int is_over = !in->round
                        && left / blend->v < GAP * value(self, NCK_CONTROL_PERIOD_S);
    arc.v_wanted = nck_max(in->v_wanted, out->v_wanted);
    arc.v = nck_min(blend->v, nck_max(in->v, out->v));
    arc.limit = NCK_LIMIT_CORNER;
    arc.angle = blend->angle;
    arc.length = blend->length + (is_over ? left : 0.0);
    arc.a = blend->a;
    arc.keeps = 1.0;
    lay_arc(in, out, &arc, blend);
    in->length = left;
    if (!is_over) {
        arc.cap = give(self, in);
        arc.limit_cap = NCK_LIMIT_CORNER;
    }
    arc.whole = arc.length;
    (void)give(self, &arc);
    out->length -= blend->trim;
    out->cap = DBL_MAX;
}

// Other axes than X Y Z move, which no blend goes with.
static int moves_others(const nck_host_control_line_t *line) {
    for (unsigned x = NCK_AXIS_Z + 1; x < NCK_AXIS_MAX; x++) {
        if (line->unit[x] != 0.0) return 1; // exactly: what stands still
    }
    return 0;
}

// What stands between the line that waits and the next one.
static void join(nck_host_control_t *self, nck_host_control_line_t *out) {
    nck_host_control_line_t *const in = &self->held;
    const double cosine = dot(in->out, out->unit);
    const double v = nck_min(in->v, out->v);
    const double kink = kink_of(self, in, out);
    out->angle = nck_atan2(nck_sqrt(nck_max(0.0, 1.0 - cosine * cosine)), cosine);
    out->cap = 0.0;
    out->limit_cap = NCK_LIMIT_CORNER;
    if (in->stops || cosine < SHARP - 1.0 || moves_others(in) || moves_others(out)) {
        if (in->stops) out->limit_cap = NCK_LIMIT_EXACT_STOP;
        (void)give(self, in);
        return;
    }
    if (kink < KINK) {
        take_kink(in, out, kink, v);
        out->cap = nck_min(out->cap, give(self, in));
        return;
    }
    if (in->tolerance <= 0.0) {
        take_kink(in, out, KINK, 0.0);
        (void)give(self, in);
        return;
    }
    const blend_t blend = blend_of(self, in, out, cosine);
    if (blend.length < ARC_LEAST || blend.v < v * KINK / kink) {
        take_kink(in, out, KINK, v * KINK / kink);
        out->cap = nck_min(out->cap, give(self, in));
        return;
    }
    put_arc(self, out, &blend);
}

static void follow(nck_host_control_t *self, nck_host_control_line_t *line) {
    line->whole = line->length;
    if (line->bare) line->tolerance = BARE * line->length;
    line->keeps = 1.0;
    line->cap = 0.0;
    line->limit_cap = NCK_LIMIT_CORNER;
    if (self->has_held) join(self, line);
    self->held = *line;
    self->has_held = 1;
}

static void straight(nck_host_control_t *self, const nck_host_control_line_t *word,
                     const double target[NCK_AXIS_MAX]) {
    nck_host_control_line_t line = *word;
    double way[NCK_AXIS_MAX];
    double tool = 0.0;
    double all = 0.0;
    for (unsigned x = 0; x < NCK_AXIS_MAX; x++) {
        way[x] = target[x] - self->place[x];
        all += way[x] * way[x];
        if (x <= NCK_AXIS_Z) tool += way[x] * way[x];
    }
    line.length = nck_sqrt(tool > 0.0 ? tool : all);
    if (line.length <= 0.0) return;
    for (unsigned x = 0; x < NCK_AXIS_MAX; x++) line.unit[x] = way[x] / line.length;
    memcpy(line.end, target, sizeof line.end);
    memcpy(line.out, line.unit, sizeof line.out);
    line.v = line.v_wanted;
    nck_control_limit(self, &line);
    follow(self, &line);
    memcpy(self->place, target, sizeof self->place);
}

// The line that a chain comes to.
static void end_chain(nck_host_control_t *self) {
    nck_host_control_chain_t *const chain = &self->chain;
    double target[NCK_AXIS_MAX];
    if (chain->count == 0) return;
    memcpy(target, self->place, sizeof target);
    memcpy(target, chain->points[chain->count - 1], sizeof chain->points[0]);
    chain->count = 0;
    straight(self, &chain->word, target);
}

// How far off the naive CAM may go [mm]; 0: it is off, as without P and Q.
static double merge_of(const nck_host_control_t *self, const nck_block_t *block) {
    const int is_bare = block->merge_mm == value(self, NCK_CONTROL_BARE);
    return block->path_mode == NCK_PATH_CONTINUOUS && !is_bare ? block->merge_mm : 0.0;
}

static int links(const nck_host_control_t *self, const nck_block_t *block, double merge,
                 const double target[NCK_AXIS_MAX]) {
    const nck_host_control_chain_t *const chain = &self->chain;
    int good = merge > 0.0 && chain->count < NCK_HOST_CONTROL_CHAIN;
    good = good && block->feed == chain->feed;
    for (unsigned x = NCK_AXIS_Z + 1; good && x < NCK_AXIS_MAX; x++) {
        good = target[x] == self->place[x]; // exactly: they stand still
    }
    for (uint32_t k = 0; good && k < chain->count; k++) {
        good = distance(self->place, target, chain->points[k]) <= merge;
    }
    return good;
}

// An arc is one move: its limits go by its radius.
static void curve(nck_host_control_t *self, const nck_block_t *block,
                  const nck_host_control_line_t *word, const double target[NCK_AXIS_MAX]) {
    static const uint8_t axes[3][3] = {{0, 1, 2}, {2, 0, 1}, {1, 2, 0}}; // G17, G18, G19
    const uint8_t *const plane = axes[block->plane - 17];
    nck_host_control_line_t line = *word;
    double sin_phi = 0.0;
    double cos_phi = 1.0;
    const double ru = self->target[plane[0]] - block->centre_mm[0];
    const double rv = self->target[plane[1]] - block->centre_mm[1];
    const double radius = nck_sqrt(ru * ru + rv * rv);
    const double flat = radius * nck_fabs(block->sweep_rad);
    const double across = target[plane[2]] - self->place[plane[2]];
    const double turn = block->sweep_rad < 0.0 ? -1.0 : 1.0;
    line.length = nck_sqrt(flat * flat + across * across);
    if (line.length <= 0.0) return;
    nck_sincos(block->sweep_rad, &sin_phi, &cos_phi);
    const double share = flat / line.length;
    const double tu = -turn * rv / radius * share;
    const double tv = turn * ru / radius * share;
    line.unit[plane[0]] = tu;
    line.unit[plane[1]] = tv;
    line.unit[plane[2]] = across / line.length;
    line.out[plane[0]] = tu * cos_phi - tv * sin_phi;
    line.out[plane[1]] = tu * sin_phi + tv * cos_phi;
    line.out[plane[2]] = across / line.length;
    line.along[plane[0]] = tu;
    line.along[plane[1]] = tv;
    line.inward[plane[0]] = -turn * tv;
    line.inward[plane[1]] = turn * tu;
    line.turn = nck_fabs(block->sweep_rad);
    memcpy(line.end, target, sizeof line.end);
    const double u_v = value(self, NCK_CONTROL_V + plane[0]);
    const double a = nck_min(value(self, NCK_CONTROL_A + plane[0]),
                             value(self, NCK_CONTROL_A + plane[1]));
    const double v = nck_min(u_v, value(self, NCK_CONTROL_V + plane[1]));
    const double bend = nck_sqrt(a * ACROSS * radius) / share;
    line.v = nck_min(nck_min(line.v_wanted, v), value(self, NCK_CONTROL_V_PATH));
    if (bend < line.v) {
        line.v = bend;
        line.limit = NCK_LIMIT_CURVATURE;
        line.a = a * ALONG;
    } else {
        const double used = line.v * line.v / (radius * a);
        line.a = a * nck_sqrt(nck_max(0.0, 1.0 - used * used));
    }
    line.round = 1;
    follow(self, &line);
    memcpy(self->place, target, sizeof self->place);
}

void nck_control_blend(nck_host_control_t *self, const nck_block_t *block,
                       const nck_host_control_line_t *word, const double target[NCK_AXIS_MAX]) {
    nck_host_control_chain_t *const chain = &self->chain;
    const int is_cut = block->kind == NCK_BLOCK_LINE;
    const double merge = merge_of(self, block);
    if (chain->count > 0 && !(is_cut && links(self, block, merge, target))) end_chain(self);
    if (block->kind == NCK_BLOCK_ARC) {
        curve(self, block, word, target);
        return;
    }
    if (!is_cut || merge <= 0.0) {
        straight(self, word, target);
        return;
    }
    for (unsigned x = NCK_AXIS_Z + 1; x < NCK_AXIS_MAX; x++) {
        if (target[x] == self->place[x]) continue; // exactly: it stands still
        end_chain(self);
        straight(self, word, target);
        return;
    }
    memcpy(chain->points[chain->count], target, sizeof chain->points[0]);
    chain->count++;
    chain->word = *word;
    chain->feed = block->feed;
}

void nck_control_unblend(nck_host_control_t *self) {
    end_chain(self);
    if (self->has_held) (void)give(self, &self->held);
    self->has_held = 0;
}
