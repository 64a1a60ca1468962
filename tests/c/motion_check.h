// SPDX-License-Identifier: MIT
// What the tests of jerk-limited motion share: programs, a run with an operator and a prep task of
// any pace, and a judge of every tick that knows nothing of the planner.
#ifndef MOTION_CHECK_H
#define MOTION_CHECK_H

#include <math.h>   // fabs fmax hypot
#include <stdio.h>  // snprintf
#include <string.h> // memset strlen

#include "check.h"
#include "nck/nck_tools.h"       // nck_t

enum { MOTION_TEXT = 400000, MOTION_SEGS = 8192, MOTION_OUTPUTS = 512, MOTION_MOVES = 12,
       MOTION_STEPS = 100000 /* prep does all that it can */ };

// What happens between two ticks. steps: prep steps, 0 and more.
typedef struct motion_script {
    uint32_t (*steps)(void *user, uint64_t tick);
    void (*command)(void *user, uint64_t tick);
    void *user;
} motion_script_t;

// Largest values of a run, and where it stands. Differences of pose.s, not what the pose says.
typedef struct motion_peak {
    double v, a, j;       // of the path coordinate [mm/s, mm/s², mm/s³]; v not in rapids
    double v_axis, a_axis; // of the axes, over their limits
    double back;          // path run backwards [mm]
    double off;           // distance from the seg that the pose names [mm]
    double s;             // largest coordinate [mm]
} motion_peak_t;

typedef struct motion {
    nck_machine_t machine;
    nck_t nck;
    char text[MOTION_TEXT];
    size_t size, used;
    uint64_t seed;
    nck_seg_t seg[MOTION_SEGS];
    uint32_t segs;
    nck_output_t output[MOTION_OUTPUTS];
    uint32_t outputs;
    uint32_t early;        // outputs handed over before their segs were finished
    nck_status_t status;   // of prep
    nck_status_t error;    // of the program
    uint64_t ticks, starved, tick_most;
    uint64_t hash;
    double s[4];           // of the last ticks
    double axis[3][NCK_AXIS_MAX];
    nck_pose_t pose;
    nck_axes_t axes;
    motion_peak_t peak;
    int was_rapid;         // 1: at the last tick
    int braked;            // 1: the tick has braked by itself, along a staircase of cells
    int is_over;
} motion_t;

// Xorshift, G. Marsaglia 2003: the same numbers everywhere. 0 … 1.
static inline double motion_random(uint64_t *seed)
{
    *seed ^= *seed << 13;
    *seed ^= *seed >> 7;
    *seed ^= *seed << 17;
    return (double)(*seed >> 11) / 9007199254740992.0;
}

// Spread over decades: exp of an even distribution.
static inline double motion_random_decades(uint64_t *seed, double low, double high)
{
    return low * pow(high / low, motion_random(seed));
}

// An empty program for the default machine with jerk-limited slope, in exact-path mode.
static inline void motion_begin(motion_t *self, uint64_t seed)
{
    nck_machine_default(&self->machine);
    self->machine.slope = NCK_SLOPE_JERK;
    self->machine.dialect.feed_default = 1000.0;
    self->size = 0;
    self->seed = seed;
}

// Limits of acceleration and jerk of the path and every axis, times a and j.
static inline void motion_scale(motion_t *self, double period, double a, double j)
{
    self->machine.period_s = period;
    self->machine.path.a_max *= a;
    self->machine.path.j_max *= j;
    for (int x = 0; x < NCK_AXIS_MAX; x++) {
        self->machine.axis[x].a_max *= a;
        self->machine.axis[x].j_max *= j;
    }
}

static inline void motion_line(motion_t *self, const char *words)
{
    const size_t n = strlen(words);
    if (self->size + n + 1 > MOTION_TEXT) return;
    memcpy(self->text + self->size, words, n);
    self->size += n;
    self->text[self->size] = '\n';
    self->size++;
}

static inline void motion_keep_seg(void *user, const nck_seg_t *seg)
{
    motion_t *const self = user;
    if (self->segs < MOTION_SEGS) self->seg[self->segs] = *seg;
    self->segs++;
}

static inline void motion_keep_output(void *user, const nck_output_t *output)
{
    motion_t *const self = user;
    const uint32_t segs = output->after_segs;
    if (self->outputs < MOTION_OUTPUTS) self->output[self->outputs] = *output;
    self->outputs++;
    if (segs == 0 || segs > MOTION_SEGS) return;
    const nck_seg_t *const seg = &self->seg[segs - 1];
    const double s = self->nck.interpolate.pose.s;
    self->early += s < seg->s_begin + seg->length - 1e-9;
}

// Initialise the kernel for a run of the program as it is now.
static inline nck_status_t motion_start(motion_t *self)
{
    const nck_hooks_t hooks = {self, motion_keep_output, NULL, motion_keep_seg};
    self->used = 0;
    self->was_rapid = 0;
    self->segs = self->outputs = self->early = 0;
    self->ticks = self->starved = 0;
    self->status = NCK_OK;
    self->error = NCK_OK;
    self->hash = 0;
    self->is_over = 0;
    self->tick_most = 800000;
    memset(self->s, 0, sizeof self->s);
    memset(self->axis, 0, sizeof self->axis);
    memset(&self->peak, 0, sizeof self->peak);
    return nck_init(&self->nck, &self->machine, &hooks);
}

// One step of the prep task. Returns 1 if another one has something to do.
static inline int motion_prep(motion_t *self)
{
    size_t used = 0;
    if (self->status == NCK_DONE) return 0;
    self->status = nck_prep(&self->nck);
    if (self->status < NCK_OK) self->error = self->status;
    if (self->status == NCK_EMPTY && self->used == self->size) {
        nck_end(&self->nck);
    } else if (self->status == NCK_EMPTY) {
        (void)nck_push(&self->nck, self->text + self->used, self->size - self->used, &used);
        self->used += used;
    }
    return self->status != NCK_FULL && self->status != NCK_DONE;
}

// Distance of a point from a seg: a line, or an arc with whatever goes straight along it.
static inline double motion_off(const nck_seg_t *seg, double s, const double *axis)
{
    double sum = 0.0;
    const double share = seg->length > 0.0 ? s / seg->length : 0.0;
    const int is_arc = seg->kind == NCK_SEG_ARC;
    for (int x = 0; x < NCK_AXIS_MAX; x++) {
        if (is_arc && (x == seg->shape.arc.axis_u || x == seg->shape.arc.axis_v)) continue;
        const double off = axis[x] - (seg->start[x] + (seg->end[x] - seg->start[x]) * share);
        sum += off * off;
    }
    if (is_arc) {
        const nck_seg_arc_t *const arc = &seg->shape.arc;
        const int u = arc->axis_u;
        const int v = arc->axis_v;
        const double radius = hypot(seg->start[u] - arc->centre_u, seg->start[v] - arc->centre_v);
        const double off = hypot(axis[u] - arc->centre_u, axis[v] - arc->centre_v) - radius;
        sum += off * off;
    }
    return sqrt(sum);
}

static inline void motion_judge_axes(motion_t *self)
{
    const double period = self->machine.period_s;
    double (*const p)[NCK_AXIS_MAX] = self->axis;
    memmove(p, p + 1, 2 * sizeof p[0]);
    memcpy(p[2], self->pose.axis, sizeof p[2]);
    for (int x = 0; x < NCK_AXIS_MAX; x++) {
        const nck_axis_t *const limit = &self->machine.axis[x];
        if (!limit->present) continue;
        const double v = fabs(p[2][x] - p[1][x]) / period;
        const double a = fabs(p[2][x] - 2.0 * p[1][x] + p[0][x]) / (period * period);
        self->peak.v_axis = fmax(self->peak.v_axis, v / limit->v_max);
        self->peak.a_axis = fmax(self->peak.a_axis, a / limit->a_max);
        self->hash = (self->hash ^ (uint64_t)self->axes.joint_nm[x]) * 1099511628211u; // FNV-1a
    }
}

static inline void motion_judge(motion_t *self)
{
    const double period = self->machine.period_s;
    const nck_pose_t *const pose = &self->pose;
    motion_peak_t *const peak = &self->peak;
    double *const s = self->s;
    memmove(s, s + 1, 3 * sizeof s[0]);
    s[3] = pose->s;
    const double rounding = 8.0 * 2.2204460492503131e-16 * fmax(1e-9, s[3]);
    if (!pose->rapid && !self->was_rapid) {
        peak->v = fmax(peak->v, (s[3] - s[2] - rounding) / period);
    }
    self->was_rapid = pose->rapid;
    peak->a = fmax(peak->a, (fabs(s[3] - 2.0 * s[2] + s[1]) - rounding) / (period * period));
    peak->j = fmax(peak->j, (fabs(s[3] - 3.0 * s[2] + 3.0 * s[1] - s[0]) - rounding)
                                / (period * period * period));
    peak->back = fmax(peak->back, s[2] - s[3] - rounding);
    peak->s = fmax(peak->s, s[3]);
    motion_judge_axes(self);
    if (pose->line == 0 || pose->seg >= MOTION_SEGS) return;
    const nck_seg_t *const seg = &self->seg[pose->seg];
    if (seg->kind <= NCK_SEG_ARC) {
        peak->off = fmax(peak->off, motion_off(seg, pose->s - seg->s_begin, pose->axis));
    }
}

// One tick with what comes before it. A WAIT is resumed. Returns 1 as long as the run goes on.
static inline int motion_tick(motion_t *self, const motion_script_t *script)
{
    const uint32_t steps =
        script && script->steps ? script->steps(script->user, self->ticks) : MOTION_STEPS;
    for (uint32_t n = 0; n < steps && motion_prep(self); n++) continue;
    if (script && script->command) script->command(script->user, self->ticks);
    const nck_tick_state_t state = nck_tick(&self->nck, &self->pose, &self->axes);
    if (state == NCK_TICK_WAIT) nck_resume(&self->nck);
    self->starved += state == NCK_TICK_STARVED;
    self->ticks++;
    self->braked |= self->nck.interpolate.clock.state == NCK_CLOCK_BRAKES;
    motion_judge(self);
    self->is_over = self->status == NCK_DONE && nck_is_idle(&self->nck);
    return !self->is_over && self->ticks < self->tick_most;
}

// Until the path is at s [mm]; a program that never gets there ends, or has tick_most.
static inline void motion_to(motion_t *self, double s)
{
    while (motion_tick(self, NULL) && self->pose.s < s) continue;
}

// The whole program. Returns 1 if it came to its end within tick_most.
static inline int motion_run(motion_t *self, const motion_script_t *script)
{
    self->status = motion_start(self);
    while (motion_tick(self, script)) continue;
    return self->is_over;
}

// Limits of the path and of every axis, at every tick so far; the path kept, nothing run backwards.
// Jerk: of rounding, 1e-6 of the limit. Once the tick has braked by itself, as tests/stop_gate.py
// has it: 5 %.
static inline int motion_holds(check_t *check, const motion_t *self, const char *what)
{
    const motion_peak_t *const peak = &self->peak;
    const double a = peak->a / self->machine.path.a_max;
    const double j = peak->j / self->machine.path.j_max;
    const double most = self->braked ? 1.05 : 1.0 + 1e-6;
    const int good = peak->v <= self->machine.path.feed_max * (1.0 + 1e-9) && a <= most
                     && j <= most && peak->v_axis <= 1.0 + 1e-6
                     && peak->a_axis <= most && peak->back <= 0.0 && peak->off <= 1e-9;
    if (!CHECK(check, good)) {
        printf("    %s: v %.6g a %.7f j %.7f axes v %.7f a %.7f back %.3g off %.3g\n", what,
               peak->v, a, j, peak->v_axis, peak->a_axis, peak->back, peak->off);
    }
    return good;
}

// ---- programs

// A random walk of lines and arcs: mean length [mm], turn a block [rad], share of arcs.
typedef struct motion_family {
    const char *name;
    double length, turn, arcs, feed; // feed [mm/min]
    int blocks;
} motion_family_t;

static const motion_family_t motion_family[] = {
    {"long lines", 20.0, 3.0, 0.0, 6000.0, 60},
    {"smooth micro-segments", 0.02, 0.05, 0.0, 6000.0, 600},
    {"rough micro-segments", 0.02, 2.0, 0.0, 6000.0, 300},
    {"five micrometres", 0.005, 0.2, 0.0, 6000.0, 600},
    {"ten nanometres", 1e-5, 0.2, 0.0, 6000.0, 400},
    {"lines and arcs", 5.0, 1.0, 0.5, 6000.0, 120},
    {"small arcs", 0.1, 1.0, 0.8, 3000.0, 200},
    {"nearly straight", 1.0, 0.001, 0.0, 1e6, 200},
    {"zigzag", 0.5, 6.0, 0.0, 6000.0, 120},
    {"creep", 0.01, 0.5, 0.2, 3.0, 40},
};
enum { MOTION_FAMILIES = (int)(sizeof motion_family / sizeof motion_family[0]) };

static inline void motion_walk_block(motion_t *self, const motion_family_t *family, double *at)
{
    char words[120];
    const double l = family->length * (0.05 + motion_random(&self->seed));
    at[2] += family->turn * (motion_random(&self->seed) - 0.5);
    const double i = l * cos(at[2]);
    const double j = l * sin(at[2]);
    if (motion_random(&self->seed) < family->arcs) {
        const int left = motion_random(&self->seed) < 0.5;
        at[0] += left ? i - j : i + j;
        at[1] += left ? j + i : j - i;
        snprintf(words, sizeof words, "G%d X%.6f Y%.6f I%.6f J%.6f", left ? 2 : 3, at[0], at[1],
                 i, j);
    } else {
        const int rapid = motion_random(&self->seed) < 0.02;
        at[0] += i;
        at[1] += j;
        snprintf(words, sizeof words, "G%d X%.6f Y%.6f Z%.6f", rapid ? 0 : 1, at[0], at[1],
                 family->length * motion_random(&self->seed));
    }
    motion_line(self, words);
}

// Words between moves: dwell, wait, output, or a move there and back with a stop, a reversal or
// another feed. The case is drawn.
static inline void motion_walk_between(motion_t *self, const double *at)
{
    char words[80];
    switch ((int)(motion_random(&self->seed) * (double)MOTION_MOVES)) {
    case 0: motion_line(self, "G4 P0.0123"); return;
    case 1: motion_line(self, "M0"); return;
    case 2: motion_line(self, "M8"); return;
    case 3: motion_line(self, "G91 G9 G1 X0.00001"); break;
    case 4: motion_line(self, "G91 G1 X-0.3 Y0.2"); break;
    case 5: motion_line(self, "S1234.5"); return;
    case 6:
        snprintf(words, sizeof words, "G91 G1 X0.00001 F%.3f",
                 motion_random_decades(&self->seed, 300.0, 6000.0));
        motion_line(self, words);
        break;
    default: return;
    }
    snprintf(words, sizeof words, "G90 G1 X%.6f Y%.6f", at[0], at[1]);
    motion_line(self, words);
}

// A program of a family. mixed: share of blocks that something else follows.
static inline void motion_program(motion_t *self, const motion_family_t *family, double mixed)
{
    char words[80];
    double at[3] = {0.0, 0.0, 0.0};
    snprintf(words, sizeof words, "G21 G90 G17 G91.1 G61 G1 F%.3f", family->feed);
    motion_line(self, words);
    for (int k = 0; k < family->blocks; k++) {
        motion_walk_block(self, family, at);
        if (motion_random(&self->seed) < mixed) motion_walk_between(self, at);
    }
    snprintf(words, sizeof words, "G1 X%.6f Y%.6f", at[0] + 0.001, at[1]);
    motion_line(self, words);
    motion_line(self, "M2");
}

#endif
