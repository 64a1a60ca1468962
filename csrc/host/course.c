// SPDX-License-Identifier: MIT
// Lines, arcs and helices of decoded blocks.
#include "host/course.h"

#include "nck/base/real.h"      // nck_sqrt nck_fabs nck_floor nck_min nck_max nck_sincos
#include "nck/base/trig_math.h" // NCK_PI

// From a start within 1e-3 of the helix: the third step is below rounding.
#define NEWTON_STEPS 3
#define WHOLE_TURN (2.0 * NCK_PI)

void nck_host_course_init(nck_host_course_t *self, const nck_machine_t *machine) {
    self->blocks = NULL;
    self->count = 0;
    self->used = 0;
    self->ended = 0;
    self->s = 0.0;
    for (int x = 0; x < NCK_AXIS_MAX; x++) {
        self->position_nm[x] = machine->start_nm[x];
        self->counts[x] = machine->axis[x].rotary ? (double)NCK_COUNTS_PER_DEG
                                                  : (double)NCK_COUNTS_PER_MM;
    }
}

void nck_host_course_give(nck_host_course_t *self, const nck_block_t *blocks, size_t count) {
    self->blocks = blocks;
    self->count = count;
    self->used = 0;
    self->ended = count == 0;
}

static double dot(const double *a, const double *b) {
    double sum = 0.0;
    for (int x = 0; x < NCK_AXIS_MAX; x++) sum += a[x] * b[x];
    return sum;
}

double nck_host_course_apart(const double *a, const double *b) {
    double way[NCK_AXIS_MAX];
    for (int x = 0; x < NCK_AXIS_MAX; x++) way[x] = a[x] - b[x];
    return nck_sqrt(dot(way, way));
}

static int is_move(const nck_block_t *block) {
    return block->kind == NCK_BLOCK_RAPID || block->kind == NCK_BLOCK_LINE
           || block->kind == NCK_BLOCK_ARC || block->kind == NCK_BLOCK_THREAD;
}

// The axes of G17, G18, G19.
static const uint8_t planes[3][2] = {
    {NCK_AXIS_X, NCK_AXIS_Y}, {NCK_AXIS_Z, NCK_AXIS_X}, {NCK_AXIS_Y, NCK_AXIS_Z}};

// The arc's centre in the machine, and where it begins about it.
static void turn_about(nck_host_move_t *move, const nck_block_t *block) {
    const int plane = block->plane == 18 ? 1 : block->plane == 19 ? 2 : 0;
    move->axis_u = planes[plane][0];
    move->axis_v = planes[plane][1];
    move->centre[0] = block->centre_mm[0]
                      + (double)block->tool_nm[move->axis_u] / (double)NCK_COUNTS_PER_MM;
    move->centre[1] = block->centre_mm[1]
                      + (double)block->tool_nm[move->axis_v] / (double)NCK_COUNTS_PER_MM;
    move->sweep = block->sweep_rad;
    const double u = move->start[move->axis_u] - move->centre[0];
    const double v = move->start[move->axis_v] - move->centre[1];
    move->angle = nck_atan2(v, u);
    move->radius = nck_sqrt(u * u + v * v);
}

// From start to end; of an arc outside of its plane only.
static void straight_of(const nck_host_move_t *move, double *straight_out) {
    for (int x = 0; x < NCK_AXIS_MAX; x++) straight_out[x] = move->end[x] - move->start[x];
    if (!move->is_arc) return;
    straight_out[move->axis_u] = 0.0;
    straight_out[move->axis_v] = 0.0;
}

static double length_of(const nck_host_move_t *move) {
    double straight[NCK_AXIS_MAX];
    straight_of(move, straight);
    const double turned = move->is_arc ? move->radius * move->sweep : 0.0;
    return nck_sqrt(dot(straight, straight) + turned * turned);
}

static void go_along(nck_host_course_t *self, const nck_block_t *block, nck_host_move_t *move) {
    const int moves = is_move(block);
    for (int x = 0; x < NCK_AXIS_MAX; x++) {
        const int64_t tool_nm = x < 3 ? block->tool_nm[x] : 0;
        move->start[x] = (double)self->position_nm[x] / self->counts[x];
        if (moves) self->position_nm[x] = block->target_nm[x] + tool_nm;
        move->end[x] = (double)self->position_nm[x] / self->counts[x];
    }
    move->is_arc = block->kind == NCK_BLOCK_ARC;
    if (move->is_arc) turn_about(move, block);
    move->tolerance = block->path_mode == NCK_PATH_CONTINUOUS ? block->tolerance_mm : 0.0;
    move->begin_s = self->s;
    // A thread's pass is no path: it is in step with the spindle.
    if (block->kind != NCK_BLOCK_THREAD) self->s += length_of(move);
    move->end_s = self->s;
}

nck_status_t nck_host_course_next(nck_host_course_t *self, nck_host_move_t *move_out) {
    if (self->used == self->count) return self->ended ? NCK_DONE : NCK_EMPTY;
    go_along(self, &self->blocks[self->used], move_out);
    self->used++;
    return NCK_OK;
}

void nck_host_course_point(const nck_host_move_t *move, double q, double *point_out) {
    for (int x = 0; x < NCK_AXIS_MAX; x++) {
        point_out[x] = move->start[x] + q * (move->end[x] - move->start[x]);
    }
    if (!move->is_arc) return;
    double sin_phi = 0.0;
    double cos_phi = 1.0;
    nck_sincos(move->angle + q * move->sweep, &sin_phi, &cos_phi);
    point_out[move->axis_u] = move->centre[0] + cos_phi * move->radius;
    point_out[move->axis_v] = move->centre[1] + sin_phi * move->radius;
}

// dp/dq.
static void tangent_of(const nck_host_move_t *move, double q, double *tangent_out) {
    double sin_phi = 0.0;
    double cos_phi = 1.0;
    straight_of(move, tangent_out);
    nck_sincos(move->angle + q * move->sweep, &sin_phi, &cos_phi);
    tangent_out[move->axis_u] = -sin_phi * move->radius * move->sweep;
    tangent_out[move->axis_v] = cos_phi * move->radius * move->sweep;
}

// Where on a straight way a point is, as a share of it; `middle` if it has no length.
static double share_along(const double *from_start, const double *straight, double middle) {
    const double square = dot(straight, straight);
    return square > 0.0 ? dot(from_start, straight) / square : middle;
}

// The angle from the start to a point, on the turn of the helix that is level with it. Of a flat
// arc: the angle that is nearest to its middle.
static double turn_to(const nck_host_move_t *move, const double *point) {
    double straight[NCK_AXIS_MAX];
    double from_start[NCK_AXIS_MAX];
    straight_of(move, straight);
    for (int x = 0; x < NCK_AXIS_MAX; x++) from_start[x] = point[x] - move->start[x];
    const double level = nck_min(1.0, nck_max(0.0, share_along(from_start, straight, 0.5)));
    const double angle = nck_atan2(point[move->axis_v] - move->centre[1],
                                   point[move->axis_u] - move->centre[0])
                         - move->angle;
    return angle + WHOLE_TURN * nck_floor((level * move->sweep - angle) / WHOLE_TURN + 0.5);
}

// From a point to the helix about an angle from its start.
static double distance_about(const nck_host_move_t *move, const double *point, double turned) {
    double on[NCK_AXIS_MAX];
    double along[NCK_AXIS_MAX];
    double away[NCK_AXIS_MAX];
    double q = turned / move->sweep;
    for (int step = 0; step < NEWTON_STEPS; step++) {
        tangent_of(move, q, along);
        nck_host_course_point(move, q, on);
        for (int x = 0; x < NCK_AXIS_MAX; x++) away[x] = point[x] - on[x];
        q += share_along(away, along, 0.0);
    }
    nck_host_course_point(move, nck_min(1.0, nck_max(0.0, q)), on);
    return nck_host_course_apart(point, on);
}

// From a point to a helix: where its turns are as near to each other as to the point, to the turns
// before and behind the level one, too.
static double distance_of_helix(const nck_host_move_t *move, const double *point) {
    double straight[NCK_AXIS_MAX];
    const double turned = turn_to(move, point);
    double best = distance_about(move, point, turned);
    straight_of(move, straight);
    const double pitch = nck_sqrt(dot(straight, straight)) * WHOLE_TURN / nck_fabs(move->sweep);
    if (pitch > 0.0 && 4.0 * best > nck_min(pitch, WHOLE_TURN * move->radius)) {
        best = nck_min(best, distance_about(move, point, turned - WHOLE_TURN));
        best = nck_min(best, distance_about(move, point, turned + WHOLE_TURN));
    }
    return best;
}

static double share_of_line(const nck_host_move_t *move, const double *point) {
    double straight[NCK_AXIS_MAX];
    double from_start[NCK_AXIS_MAX];
    for (int x = 0; x < NCK_AXIS_MAX; x++) {
        straight[x] = move->end[x] - move->start[x];
        from_start[x] = point[x] - move->start[x];
    }
    return share_along(from_start, straight, 0.0);
}

double nck_host_course_distance(const nck_host_move_t *move, const double *point) {
    double on[NCK_AXIS_MAX];
    if (move->is_arc && nck_fabs(move->sweep) > 0.0) return distance_of_helix(move, point);
    nck_host_course_point(move, nck_min(1.0, nck_max(0.0, share_of_line(move, point))), on);
    return nck_host_course_apart(point, on);
}
