// SPDX-License-Identifier: MIT
// What the tests of the front door share: a kernel with a prep task and a tick in one loop, and
// what comes out of it.
#ifndef FRONT_CHECK_H
#define FRONT_CHECK_H

#include <math.h>   // fabs fmax pow
#include <string.h> // memset strlen

#include "check.h"
#include "nck/nck_tools.h" // nck_t

enum { FRONT_OUTPUTS = 64, FRONT_LINES = 1024, FRONT_TICKS = 200000 };

typedef struct front {
    nck_machine_t machine;
    nck_t nck;
    nck_output_t output[FRONT_OUTPUTS];
    uint32_t outputs;
    uint32_t line[FRONT_LINES]; // as the pose has told them, one after the other
    uint32_t lines, last;       // so many; the last of them
    nck_status_t status, error; // of prep: the last; the last that was an error
    nck_tick_state_t state;
    nck_pose_t pose;
    nck_axes_t axes;
    uint64_t ticks, moving, hash; // moving: ticks that the position changed in
    double v_most;                // of any axis, since it was set to 0 [mm/s]
    double step_most;             // the same, of the machine's limit
} front_t;

static inline void front_keep_output(void *user, const nck_output_t *output)
{
    front_t *const self = user;
    if (self->outputs < FRONT_OUTPUTS) self->output[self->outputs] = *output;
    self->outputs++;
}

// The default machine with one slope, on the exact path, a feed in force.
static inline void front_machine(front_t *self, uint32_t slope)
{
    nck_machine_default(&self->machine);
    self->machine.slope = slope;
    self->machine.path.tolerance = 0.0;
    self->machine.dialect.feed_default = 600.0;
}

static inline nck_status_t front_start(front_t *self)
{
    const nck_hooks_t hooks = {self, front_keep_output, NULL, NULL};
    const nck_machine_t machine = self->machine;
    memset(self, 0, sizeof *self);
    self->machine = machine;
    const nck_status_t status = nck_init(&self->nck, &self->machine, &hooks);
    (void)nck_position(&self->nck, &self->pose, &self->axes);
    return status;
}

// The same limits for all axes [mm/s, mm/s², mm/s³], and twice as much for the path.
static inline void front_limit(front_t *self, double v, double a, double j)
{
    for (int x = 0; x < NCK_AXIS_MAX; x++) {
        nck_axis_t *const axis = &self->machine.axis[x];
        axis->v_max = axis->rapid = v;
        axis->a_max = a;
        axis->j_max = j;
    }
    self->machine.path.a_max = 2.0 * a;
    self->machine.path.j_max = 2.0 * j;
}

// 1 if all that has been pushed is done.
static inline int front_is_done(const front_t *self)
{
    nck_queue_t queue;
    nck_queue(&self->nck, &queue);
    return nck_is_idle(&self->nck)
           && queue.text + queue.smooth + queue.segs + queue.outputs == 0;
}

// Spread over decades, by the linear congruence of MMIX (D. E. Knuth).
static inline double front_draw(uint64_t *seed, double low, double high)
{
    *seed = *seed * 6364136223846793005u + 1442695040888963407u;
    return low * pow(high / low, (double)(*seed >> 11) * 0x1p-53);
}

// The seed of a session: those of neighbours begin unlike.
static inline uint64_t front_seed(uint32_t number)
{
    uint64_t seed = 2654435761u * (number + 1u);
    for (int n = 0; n < 8; n++) (void)front_draw(&seed, 1.0, 2.0);
    return seed;
}

// Prep until it has nothing to do.
static inline void front_prep(front_t *self)
{
    do {
        self->status = nck_prep(&self->nck);
        if (self->status < NCK_OK) self->error = self->status;
    } while (self->status == NCK_OK || self->status < NCK_OK);
}

static inline void front_note(front_t *self, const nck_axes_t *before)
{
    int moved = 0;
    for (uint32_t k = 0; k < nck_joint_count(&self->nck); k++) {
        const int64_t step = self->axes.joint_nm[k] - before->joint_nm[k];
        const double v = fabs((double)step) * 1e-6 / self->machine.period_s;
        const nck_axis_t *const axis = &self->machine.axis[nck_joint_axis(&self->nck, k)];
        self->v_most = fmax(self->v_most, v);
        self->step_most = fmax(self->step_most, v / axis->v_max);
        moved |= step != 0;
        if (moved) self->hash = (self->hash ^ (uint64_t)self->axes.joint_nm[k]) * 1099511628211u;
    }
    self->moving += (uint64_t)moved;
    if (self->last == self->pose.line) return;
    self->last = self->pose.line;
    if (self->last == 0) return;
    if (self->lines < FRONT_LINES) self->line[self->lines] = self->pose.line;
    self->lines++;
}

static inline void front_tick(front_t *self)
{
    const nck_axes_t before = self->axes;
    front_prep(self);
    self->state = nck_tick(&self->nck, &self->pose, &self->axes);
    self->ticks++;
    front_note(self, &before);
}

// Ticks until nothing more happens by itself: at rest, and prep waits for text or is done.
static inline void front_rest(front_t *self)
{
    uint64_t still = 0;
    for (uint64_t n = 0; n < FRONT_TICKS && still < 100; n++) {
        const uint64_t moving = self->moving;
        front_tick(self);
        still = self->moving == moving && self->state != NCK_TICK_DWELL ? still + 1 : 0;
    }
}

// Text as fast as the kernel takes it.
static inline void front_push(front_t *self, const char *text)
{
    size_t used = 0, n = strlen(text);
    for (int tries = 0; n > 0 && tries < FRONT_TICKS; tries++) {
        const nck_status_t status = nck_push(&self->nck, text, n, &used);
        text += used;
        n -= used;
        if (status < NCK_OK) return;
        if (n > 0 && used == 0) front_tick(self);
    }
}

static inline nck_status_t front_push_block(front_t *self, const nck_block_in_t *block)
{
    nck_status_t status = nck_push_block(&self->nck, block);
    for (int tries = 0; status == NCK_FULL && tries < FRONT_TICKS; tries++) {
        front_tick(self);
        status = nck_push_block(&self->nck, block);
    }
    return status;
}

// ---- blocks

static inline nck_block_in_t front_to(uint32_t id, nck_in_kind_t kind, double x, double y)
{
    nck_block_in_t block;
    memset(&block, 0, sizeof block);
    block.id = id;
    block.kind = (uint8_t)kind;
    block.axes = 3;
    block.target[NCK_AXIS_X] = x;
    block.target[NCK_AXIS_Y] = y;
    return block;
}

static inline nck_block_in_t front_arc(uint32_t id, const double end[2], const double centre[2],
                                       int32_t turns)
{
    nck_block_in_t block = front_to(id, NCK_IN_ARC, end[0], end[1]);
    block.centre[0] = centre[0];
    block.centre[1] = centre[1];
    block.turns = turns;
    block.plane = 17;
    return block;
}

static inline nck_block_in_t front_word(uint32_t id, nck_in_kind_t kind, double value)
{
    nck_block_in_t block;
    memset(&block, 0, sizeof block);
    block.id = id;
    block.kind = (uint8_t)kind;
    block.value = value;
    return block;
}

static inline double front_x(const front_t *self)
{
    return (double)self->axes.joint_nm[0] * 1e-6;
}

static inline double front_y(const front_t *self)
{
    return (double)self->axes.joint_nm[1] * 1e-6;
}

#endif
