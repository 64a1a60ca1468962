// SPDX-License-Identifier: MIT
// Other controls: the lines that they make of a move.
#include "host/control_parts.h"

#include <float.h>  // DBL_MAX
#include <string.h> // memcpy memset

#include "host/control_math.h" // NCK_CONTROL_E
#include "nck/base/real.h" // nck_fabs nck_floor nck_max nck_min nck_sqrt
#include "nck/base/trig.h" // nck_sincos

// Marlin keeps a move that is shorter than so many steps for the next one.
#define STEPS_LEAST 6.0
// Marlin's arcs: chords of a whole circle at least, and the shortest one [mm].
#define CIRCLE_CHORDS 72.0
#define CHORD_LEAST_MM 0.1
#define PI 3.14159265358979323846
#define NM 1e-6
#define NDEG 1e-9

// Of a printer's length: all axes but U, its extruder, and what lies beside it.
enum { PRINTER_AXES = NCK_AXIS_MAX > 6 ? 6 : NCK_AXIS_MAX };

// Plane of an arc, and the axis across it.
typedef struct plane {
    uint8_t u, v, across;
} plane_t;

static plane_t plane_of(const nck_block_t *block) {
    const plane_t xy = {NCK_AXIS_X, NCK_AXIS_Y, NCK_AXIS_Z};
    const plane_t zx = {NCK_AXIS_Z, NCK_AXIS_X, NCK_AXIS_Y};
    const plane_t yz = {NCK_AXIS_Y, NCK_AXIS_Z, NCK_AXIS_X};
    if (block->plane == 18) return zx;
    return block->plane == 19 ? yz : xy;
}

static int prints(const nck_host_control_t *self) {
    return self->rule.kind == NCK_HOST_CONTROL_KLIPPER
           || self->rule.kind == NCK_HOST_CONTROL_MARLIN;
}

static void targets_of(const nck_block_t *block, double target[NCK_AXIS_MAX]) {
    for (unsigned x = 0; x < NCK_AXIS_MAX; x++) {
        const int64_t tool = x <= NCK_AXIS_Z ? block->tool_nm[x] : 0;
        const double unit = x >= NCK_AXIS_A && x <= NCK_AXIS_C ? NDEG : NM;
        target[x] = (double)(block->target_nm[x] + tool) * unit;
    }
}

// Half a step goes away from zero.
static double in_steps(double place, double steps) {
    if (steps <= 0.0) return place;
    const double count = nck_floor(nck_fabs(place) * steps + 0.5);
    return (place < 0.0 ? -count : count) / steps;
}

// The way to the target; of all steps the most that an axis makes.
static double way_to(const nck_host_control_t *self, const double target[NCK_AXIS_MAX],
                     double way[NCK_AXIS_MAX]) {
    double most = 0.0;
    for (unsigned x = 0; x < NCK_AXIS_MAX; x++) {
        const double steps = self->rule.value[NCK_CONTROL_STEPS + x];
        way[x] = in_steps(target[x], steps) - self->place[x];
        most = nck_max(most, nck_fabs(way[x]) * steps);
    }
    return most;
}

// A printer's length is that of X Y Z; of filament alone its own.
static double length_of(const nck_host_control_t *self, const double way[NCK_AXIS_MAX],
                        nck_host_control_line_t *line) {
    const unsigned axes = prints(self) ? PRINTER_AXES : NCK_AXIS_MAX;
    const double least = 1e-9; // mm: what rounding leaves of nothing
    double square = 0.0;
    for (unsigned x = 0; x < axes; x++) square += way[x] * way[x];
    if (square > least * least) return nck_sqrt(square);
    line->lone = prints(self) && nck_fabs(way[NCK_CONTROL_E]) > least;
    return line->lone ? nck_fabs(way[NCK_CONTROL_E]) : 0.0;
}

// Marlin: while its ring fills, lines that are over soon are made slower.
static void slow_down(const nck_host_control_t *self, nck_host_control_line_t *line) {
    const uint32_t half = 7, few = 2; // lines that wait: from few to half of its 16 blocks, less 1
    const double least = self->rule.value[NCK_CONTROL_SEGMENT_S];
    const double duration = line->length / line->v_wanted;
    if (self->rule.kind != NCK_HOST_CONTROL_MARLIN || self->queued < few || self->queued > half) {
        return;
    }
    if (duration >= least) return;
    line->v = line->length / (duration + 2.0 * (least - duration) / self->queued);
    line->limit = NCK_LIMIT_LOOKAHEAD;
}

static int counts_steps(const nck_host_control_t *self) {
    int some = 0;
    for (unsigned x = 0; x < NCK_AXIS_MAX; x++) {
        some |= self->rule.value[NCK_CONTROL_STEPS + x] > 0.0;
    }
    return some;
}

static void go(nck_host_control_t *self, const double target[NCK_AXIS_MAX],
               const nck_host_control_line_t *word) {
    nck_host_control_line_t line = *word;
    double way[NCK_AXIS_MAX];
    const double steps = way_to(self, target, way);
    const int waits = self->rule.kind == NCK_HOST_CONTROL_MARLIN && counts_steps(self);
    if (waits && steps < STEPS_LEAST) return;
    line.length = length_of(self, way, &line);
    if (line.length <= 0.0) return;
    for (unsigned x = 0; x < NCK_AXIS_MAX; x++) {
        line.unit[x] = way[x] / line.length;
        self->place[x] = in_steps(target[x], self->rule.value[NCK_CONTROL_STEPS + x]);
        line.end[x] = self->place[x];
    }
    line.v = line.v_wanted;
    slow_down(self, &line);
    nck_control_limit(self, &line);
    line.steps = steps;
    nck_control_corner(self, &line);
    nck_control_add(self, &line);
}

// Chords of an arc, by the control's own rule.
static double chords_of(const nck_host_control_t *self, double radius, double sweep,
                        double across) {
    const double chord = self->rule.value[NCK_CONTROL_CHORD];
    const double flat = radius * nck_fabs(sweep);
    if (self->rule.kind == NCK_HOST_CONTROL_GRBL) {
        const double square = chord * (2.0 * radius - chord);
        return square > 0.0 ? nck_floor(0.5 * flat / nck_sqrt(square)) : 0.0;
    }
    if (self->rule.kind == NCK_HOST_CONTROL_KLIPPER) {
        return nck_floor(nck_sqrt(flat * flat + across * across) / chord);
    }
    const double least = -nck_floor(-CIRCLE_CHORDS * nck_fabs(sweep) / (2.0 * PI));
    const double count = nck_max(nck_floor(flat / chord), least);
    return flat / count < CHORD_LEAST_MM ? nck_floor(flat / CHORD_LEAST_MM) : count;
}

// An arc about its centre, in mm.
typedef struct circle {
    plane_t plane;
    double cu, cv, ru, rv; // its centre; from there to its start
    double radius, across; // across: along the axis beside the plane
    double chords;
} circle_t;

static circle_t circle_of(const nck_host_control_t *self, const nck_block_t *block,
                          const double target[NCK_AXIS_MAX]) {
    const double most = 1e6; // chords of one arc: more are no arc
    circle_t round;
    round.plane = plane_of(block);
    const unsigned u = round.plane.u;
    const unsigned v = round.plane.v;
    round.cu = block->centre_mm[0] + (target[u] - (double)block->target_nm[u] * NM);
    round.cv = block->centre_mm[1] + (target[v] - (double)block->target_nm[v] * NM);
    round.ru = self->target[u] - round.cu;
    round.rv = self->target[v] - round.cv;
    round.radius = nck_sqrt(round.ru * round.ru + round.rv * round.rv);
    round.across = target[round.plane.across] - self->target[round.plane.across];
    round.chords = chords_of(self, round.radius, block->sweep_rad, round.across);
    round.chords = nck_min(most, round.chords);
    return round;
}

static void go_round(nck_host_control_t *self, const nck_block_t *block,
                     const double target[NCK_AXIS_MAX], nck_host_control_line_t *word) {
    const circle_t round = circle_of(self, block, target);
    double begin[NCK_AXIS_MAX];
    double at[NCK_AXIS_MAX];
    memcpy(begin, self->target, sizeof begin);
    if (block->feed_mode == NCK_FEED_INVERSE) {
        const double flat = round.radius * block->sweep_rad;
        const double square = flat * flat + round.across * round.across;
        word->v_wanted = block->feed * nck_sqrt(square) / 60.0;
    }
    const nck_host_move_t *const move = &self->trace.move;
    for (double k = 1.0; k < round.chords; k += 1.0) {
        double sin_phi = 0.0;
        double cos_phi = 1.0;
        for (unsigned x = 0; x < NCK_AXIS_MAX; x++) {
            at[x] = begin[x] + (target[x] - begin[x]) * (k / round.chords);
        }
        nck_sincos(block->sweep_rad * (k / round.chords), &sin_phi, &cos_phi);
        at[round.plane.u] = round.cu + (round.ru * cos_phi - round.rv * sin_phi);
        at[round.plane.v] = round.cv + (round.ru * sin_phi + round.rv * cos_phi);
        word->s = move->begin_s + (move->end_s - move->begin_s) * (k / round.chords);
        go(self, at, word);
    }
    word->s = move->end_s;
    go(self, target, word);
}

void nck_control_reach(nck_host_control_t *self, const nck_block_t *block) {
    targets_of(block, self->target);
    memcpy(self->place, self->target, sizeof self->place);
}

size_t nck_control_lines_of(const nck_host_control_t *self, const nck_block_t *block) {
    double target[NCK_AXIS_MAX];
    if (block->kind != NCK_BLOCK_ARC || self->rule.kind == NCK_HOST_CONTROL_LINUXCNC) return 1;
    targets_of(block, target);
    return 1 + (size_t)nck_max(0.0, circle_of(self, block, target).chords);
}

// The speed that the program asks for [mm/s].
static double wanted(const nck_host_control_t *self, const nck_block_t *block,
                     const double target[NCK_AXIS_MAX]) {
    const int any = block->kind == NCK_BLOCK_RAPID && !(prints(self) && block->feed > 0.0);
    double square = 0.0;
    if (any) return DBL_MAX;
    if (block->feed_mode == NCK_FEED_PER_REV) return block->feed * block->spindle_rpm / 60.0;
    if (block->feed_mode != NCK_FEED_INVERSE) return block->feed / 60.0;
    for (unsigned x = 0; x < NCK_AXIS_MAX; x++) {
        const double way = target[x] - self->target[x];
        square += way * way;
    }
    return block->feed * nck_sqrt(square) / 60.0;
}

void nck_control_move(nck_host_control_t *self, const nck_block_t *block) {
    nck_host_control_line_t word;
    double target[NCK_AXIS_MAX];
    memset(&word, 0, sizeof word);
    targets_of(block, target);
    word.line = block->line;
    word.number = self->block;
    word.rapid = block->kind == NCK_BLOCK_RAPID;
    word.limit = word.rapid ? NCK_LIMIT_RAPID : NCK_LIMIT_FEED;
    word.v_wanted = wanted(self, block, target);
    word.tolerance = block->path_mode == NCK_PATH_CONTINUOUS ? block->tolerance_mm : 0.0;
    word.bare = word.tolerance > 0.0 && word.tolerance == self->rule.value[NCK_CONTROL_BARE];
    word.stops = block->path_mode == NCK_PATH_STOP;
    word.arc = block->kind == NCK_BLOCK_ARC;
    word.tool = self->shares.tool;
    word.s = self->trace.move.end_s;
    word.spindle_rpm = block->spindle_rpm;
    if (self->rule.kind == NCK_HOST_CONTROL_LINUXCNC) nck_control_blend(self, block, &word, target);
    else if (block->kind == NCK_BLOCK_ARC) go_round(self, block, target, &word);
    else go(self, target, &word);
    memcpy(self->target, target, sizeof self->target);
}
