// SPDX-License-Identifier: MIT
// Other controls: the path in stretches of constant acceleration, and where it is slow.
//
//     line, times ─▶ up, top, down; of a bend chord by chord ─▶ rows of the caller
#include "host/control_parts.h"

#include <string.h> // memcpy memset

#include "nck/base/real.h" // nck_fabs nck_floor nck_max nck_min nck_sqrt
#include "nck/base/trig.h" // nck_sincos

// A chord of a bend is so far from it at most [mm], and turns so far at most [rad].
#define CHORD 0.005
#define TURN 0.18
// Speeds that differ by less are one [mm/s].
#define SAME_V 1e-6
#define CHORDS_MOST 256.0

// Rows of a line: up, top and down, and one where its speed begins with a step; of a bend its
// chords, too.
enum { ROWS = 4, ROWS_BENT = 260 };
// Lines that a block of LinuxCNC's makes final beside its own: a chain, what is held, their arcs.
enum { JOINED = 8 };

size_t nck_host_control_room(const nck_host_control_t *self, const nck_block_t *next) {
    const size_t each = self->rule.kind == NCK_HOST_CONTROL_LINUXCNC ? ROWS_BENT : ROWS;
    const size_t more = next ? nck_control_lines_of(self, next) : 0;
    return (self->line_end - self->line_begin + more + JOINED) * each;
}

void nck_control_trace_again(nck_host_control_t *self) {
    self->trace.before += self->trace.stretch_count;
    self->trace.stretch_count = 0;
    self->trace.foot_count = 0;
}

static uint64_t told(const nck_host_control_trace_t *trace) {
    return trace->before + trace->stretch_count;
}

static void put_place(nck_host_control_stretch_t *stretch, const double place[NCK_AXIS_MAX]) {
    for (unsigned x = 0; x < NCK_AXIS_MAX; x++) {
        if (x < NCK_AXIS_A) stretch->end.xyz[x] = place[x];
        else if (x <= NCK_AXIS_C) stretch->end.abc[x - NCK_AXIS_A] = place[x];
        else stretch->uvw[x - NCK_AXIS_U] = place[x];
    }
}

// The path goes on to a place, within so much time, and is so fast there. The stretch has all else
// that is to be told.
static void give(nck_host_control_t *self, nck_host_control_stretch_t *stretch,
                 const double place[NCK_AXIS_MAX], double time_s, double v) {
    nck_host_control_trace_t *const trace = &self->trace;
    stretch->duration = time_s;
    stretch->v_begin = trace->v;
    stretch->end.v = v;
    nck_host_cause_sum(&trace->t, time_s);
    stretch->end.t = trace->t.sum + trace->t.rest;
    put_place(stretch, place);
    trace->stretches[trace->stretch_count] = *stretch;
    trace->stretch_count++;
    memcpy(trace->place, place, sizeof trace->place);
    trace->v = v;
    trace->s = stretch->s;
}

// The path begins, or its speed steps to v.
static void begin(nck_host_control_t *self, nck_host_control_stretch_t *stretch, double v) {
    nck_host_control_trace_t *const trace = &self->trace;
    if (told(trace) > 0 && nck_fabs(v - trace->v) <= SAME_V) return;
    double place[NCK_AXIS_MAX];
    memcpy(place, trace->place, sizeof place);
    trace->v = v;
    stretch->s = trace->s;
    give(self, stretch, place, 0.0, v);
}

void nck_control_bend_way(const nck_host_control_line_t *line, double from, double to,
                          double way_out[3]) {
    for (int x = 0; x < 3; x++) {
        way_out[x] = (to - from) * line->length * (line->unit[x] - line->along[x]);
    }
    if (!(line->turn > 0.0)) return;
    double sin_from = 0.0;
    double cos_from = 1.0;
    double sin_to = 0.0;
    double cos_to = 1.0;
    nck_sincos(line->turn * from, &sin_from, &cos_from);
    nck_sincos(line->turn * to, &sin_to, &cos_to);
    const double radius = line->length / line->turn;
    for (int x = 0; x < 3; x++) {
        way_out[x] += radius * ((sin_to - sin_from) * line->along[x]
                                + (cos_from - cos_to) * line->inward[x]);
    }
}

void nck_control_bend_shorten(nck_host_control_line_t *line, double share) {
    double sin_phi = 0.0;
    double cos_phi = 1.0;
    nck_sincos(line->turn * share, &sin_phi, &cos_phi);
    for (int x = 0; x < 3; x++) {
        const double along = line->along[x];
        const double inward = line->inward[x];
        line->along[x] = cos_phi * along + sin_phi * inward;
        line->inward[x] = cos_phi * inward - sin_phi * along;
        line->unit[x] += line->along[x] - along;
    }
    line->turn *= 1.0 - share;
}

// Where a line is, from its begin on: share 0 … 1 of its length. A bend ends where the line does.
static void place_on(const nck_host_control_line_t *line, const double begin_at[NCK_AXIS_MAX],
                     double share, double place_out[NCK_AXIS_MAX]) {
    double here[3];
    double all[3];
    for (unsigned x = 0; x < NCK_AXIS_MAX; x++) {
        place_out[x] = begin_at[x] + share * (line->end[x] - begin_at[x]);
    }
    if (!(line->turn > 0.0)) return;
    nck_control_bend_way(line, 0.0, share, here);
    nck_control_bend_way(line, 0.0, 1.0, all);
    for (int x = 0; x < 3; x++) place_out[x] += here[x] - share * all[x];
}

static void name_line(nck_host_control_stretch_t *stretch, const nck_host_control_line_t *line) {
    memset(stretch, 0, sizeof *stretch);
    stretch->end.feed = line->v_wanted;
    stretch->end.line = line->line;
    stretch->end.tool = line->tool;
    stretch->end.rapid = line->rapid;
    stretch->spindle_rpm = line->spindle_rpm;
    stretch->block = line->number;
    stretch->kind = line->arc ? NCK_SEG_ARC : NCK_SEG_LINE;
}

// How many chords of a bend a part of its length is.
static double chords_of(const nck_host_control_line_t *line, double share) {
    if (!(line->turn > 0.0) || !(share > 0.0)) return 1.0;
    const double radius = line->length / line->turn;
    const double angle = nck_min(TURN, nck_sqrt(8.0 * CHORD / radius));
    const double all = nck_min(CHORDS_MOST, line->turn / angle);
    return nck_max(1.0, -nck_floor(-all * share));
}

// A part of a line at constant acceleration.
typedef struct phase {
    double time_s, v_begin, v_end;
    double from, to; // shares of the line's length
    double s;        // where the line begins, along the program [path mm]
} phase_t;

//  s(k) = k/n, v² = v₀² + (v₁² − v₀²) s, t = s (v₀ + v₁)/(v₀ + v)         [of the phase]
static void give_phase(nck_host_control_t *self, const nck_host_control_line_t *line,
                       nck_host_control_stretch_t *stretch, const phase_t *phase,
                       const double begin_at[NCK_AXIS_MAX]) {
    const double count = chords_of(line, phase->to - phase->from);
    const double vv = phase->v_begin * phase->v_begin;
    const double more = phase->v_end * phase->v_end - vv;
    const double sum = phase->v_begin + phase->v_end;
    double place[NCK_AXIS_MAX];
    double t = 0.0;
    for (double k = 1.0; k < count; k += 1.0) {
        const double s = k / count;
        const double v = nck_sqrt(vv + more * s);
        const double t_next = phase->time_s * (s * sum / (phase->v_begin + v));
        const double share = phase->from + s * (phase->to - phase->from);
        place_on(line, begin_at, share, place);
        stretch->s = phase->s + share * (line->s - phase->s);
        give(self, stretch, place, t_next - t, v);
        t = t_next;
    }
    place_on(line, begin_at, phase->to, place);
    stretch->s = phase->s + phase->to * (line->s - phase->s);
    give(self, stretch, place, phase->time_s - t, phase->v_end);
}

void nck_control_trace_line(nck_host_control_t *self, const nck_host_control_line_t *line,
                            const nck_control_times_t *times, const double vv[2], uint32_t top) {
    const double top_mm = nck_max(0.0, line->length - times->up_mm - times->down_mm);
    const double all_mm = times->up_mm + top_mm + times->down_mm;
    const double begin_v = nck_sqrt(vv[0]);
    const double end_v = nck_sqrt(vv[1]);
    const double up = times->up_mm / all_mm;
    const double down = 1.0 - times->down_mm / all_mm;
    const double s = self->trace.s;
    const phase_t phases[3] = {
        {times->up_s, begin_v, times->v_top, 0.0, up, s},
        {times->top_s, times->v_top, times->v_top, up, down, s},
        {times->down_s, times->v_top, end_v, down, 1.0, s}
    };
    nck_host_control_stretch_t stretch;
    double begin_at[NCK_AXIS_MAX];
    name_line(&stretch, line);
    memcpy(begin_at, self->trace.place, sizeof begin_at);
    for (int k = 0; k < 3; k++) {
        stretch.end.limit = k == 1 ? (uint8_t)top : (uint8_t)NCK_LIMIT_ACCEL;
        if (k == 0) begin(self, &stretch, begin_v);
        if (k == 2 && !(self->fall.time_s > 0.0)) self->trace.fastest = told(&self->trace);
        if (phases[k].time_s > 0.0) give_phase(self, line, &stretch, &phases[k], begin_at);
    }
    memcpy(self->trace.place, line->end, sizeof self->trace.place);
    self->trace.s = line->s;
}

void nck_control_trace_rest(nck_host_control_t *self, uint32_t line, double time_s) {
    nck_host_control_stretch_t stretch;
    memset(&stretch, 0, sizeof stretch);
    stretch.end.line = line;
    stretch.end.tool = self->shares.tool;
    stretch.end.limit = NCK_LIMIT_DWELL;
    stretch.end.rests = 1;
    stretch.spindle_rpm = self->speed;
    stretch.block = self->block;
    stretch.kind = NCK_SEG_DWELL;
    begin(self, &stretch, 0.0);
    stretch.s = self->trace.move.end_s;
    give(self, &stretch, self->place, time_s, 0.0);
}

void nck_control_trace_settle(nck_host_control_t *self) {
    nck_host_control_trace_t *const trace = &self->trace;
    trace->feet[trace->foot_count] = trace->foot;
    trace->feet[trace->foot_count].low = self->low;
    trace->foot_count++;
}

void nck_control_trace_low(nck_host_control_t *self) {
    nck_host_control_trace_t *const trace = &self->trace;
    const uint64_t count = told(trace);
    trace->foot.first = self->fall.time_s > 0.0 ? trace->fastest : count;
    trace->foot.at = count > 0 ? count - 1 : 0;
}
