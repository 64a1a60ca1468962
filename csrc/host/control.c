// SPDX-License-Identifier: MIT
// Other controls: the blocks of a program, and where they rest.
#include "host/control_parts.h"

#include <float.h>  // DBL_MAX
#include <string.h> // memset

enum { LINES_LEAST = 1024 };
enum {
    M_CLOCKWISE = 3, M_ANTICLOCKWISE = 4, M_SPINDLE_STOP = 5, M_MIST = 7, M_FLOOD = 8, M_DRY = 9
};

static int is_good(const nck_host_control_t *self) {
    const nck_host_control_rule_t *const rule = &self->rule;
    int good = rule->kind >= NCK_HOST_CONTROL_KLIPPER && rule->kind <= NCK_HOST_CONTROL_LINUXCNC;
    good &= self->line_max >= LINES_LEAST && self->line_max / 2 >= rule->ahead;
    good &= rule->kind == NCK_HOST_CONTROL_KLIPPER || rule->ahead >= 2;
    for (unsigned k = 0; k < NCK_CONTROL_VALUES; k++) {
        good &= rule->value[k] >= 0.0 && rule->value[k] <= DBL_MAX;
    }
    return good;
}

nck_status_t nck_host_control_init(nck_host_control_t *self, const nck_host_control_rule_t *rule,
                                   const nck_machine_t *machine) {
    const nck_host_low_t begin = {NCK_LIMIT_EXACT_STOP, 1, 0, 0, NCK_AXIS_MAX, 0, 0.0, 0.0};
    self->rule = *rule;
    if (!is_good(self)) return NCK_E_ARGUMENT;
    nck_host_share_init(&self->shares, machine);
    for (unsigned x = 0; x < NCK_AXIS_MAX; x++) {
        const double unit = machine->axis[x].rotary ? 1e-9 : 1e-6;
        self->target[x] = (double)machine->start_nm[x] * unit;
        self->place[x] = self->target[x];
        self->trace.place[x] = self->target[x];
    }
    nck_host_course_init(&self->trace.course, machine);
    self->at_rest = 1;
    nck_control_low(self, &begin);
    return NCK_OK;
}

static void change_settings(nck_host_control_t *self, uint32_t line) {
    while (self->change_used < self->change_count
           && self->changes[self->change_used].line <= line) {
        const nck_host_control_change_t *const change = &self->changes[self->change_used];
        self->rule.value[change->value] = change->to;
        self->change_used++;
    }
}

// grbl rests where the spindle's or the coolant's state changes, and where S does while it turns;
// with a laser not for an S on a move.
static void settle_speed(nck_host_control_t *self, const nck_block_t *next) {
    const int moves = next != NULL && next->line == self->speed_line
                      && next->kind <= NCK_BLOCK_ARC;
    if (self->speed_line == 0) return;
    if (!(moves && self->rule.laser)) {
        nck_control_rest(self, NCK_LIMIT_SPINDLE, self->speed_line);
    }
    self->speed_line = 0;
}

static void take_code(nck_host_control_t *self, const nck_block_t *block) {
    const uint32_t code = (uint32_t)block->output.value;
    const int spins = code >= M_CLOCKWISE && code <= M_SPINDLE_STOP;
    const int cools = code >= M_MIST && code <= M_DRY;
    uint32_t *const state = spins ? &self->spins : &self->cools;
    if (!spins && !cools) return;
    if (*state != code && !(*state == 0 && (code == M_SPINDLE_STOP || code == M_DRY))) {
        nck_control_rest(self, NCK_LIMIT_WAIT, block->line);
    }
    *state = code == M_SPINDLE_STOP || code == M_DRY ? 0 : code;
}

static void take_output(nck_host_control_t *self, const nck_block_t *block) {
    const nck_output_t *const output = &block->output;
    nck_host_share_output(&self->shares, output);
    if (self->rule.kind != NCK_HOST_CONTROL_GRBL) return;
    if (output->kind == NCK_OUTPUT_M) take_code(self, block);
    if (output->kind != NCK_OUTPUT_SPINDLE_SPEED || output->value == self->speed) return;
    self->speed = output->value;
    if (self->spins != 0) self->speed_line = block->line;
}

static void take_rest(nck_host_control_t *self, const nck_block_t *block) {
    const int dwells = block->kind == NCK_BLOCK_DWELL;
    double time_s = dwells ? block->dwell_s : 0.0;
    if (block->kind == NCK_BLOCK_THREAD) time_s = (double)block->thread.duration;
    if (block->kind == NCK_BLOCK_TAP) time_s = (double)block->tap.duration;
    if (block->kind == NCK_BLOCK_WAIT) nck_host_share_output(&self->shares, &block->output);
    nck_control_rest(self, dwells ? NCK_LIMIT_DWELL : NCK_LIMIT_WAIT, block->line);
    if (block->kind == NCK_BLOCK_THREAD) nck_control_reach(self, block);
    if (time_s > 0.0) nck_control_dwell(self, block->line, time_s);
}

static void take(nck_host_control_t *self, const nck_block_t *block) {
    change_settings(self, block->line);
    settle_speed(self, block);
    self->block++;
    if (self->trace.stretches) {
        nck_host_course_give(&self->trace.course, block, 1);
        (void)nck_host_course_next(&self->trace.course, &self->trace.move);
    }
    switch (block->kind) {
    case NCK_BLOCK_RAPID:
    case NCK_BLOCK_LINE:
    case NCK_BLOCK_ARC:
        nck_control_move(self, block);
        break;
    case NCK_BLOCK_OUTPUT:
        take_output(self, block);
        break;
    case NCK_BLOCK_END:
        break;
    default:
        take_rest(self, block);
        break;
    }
}

static int has_room(const nck_host_control_t *self, const nck_block_t *block) {
    const nck_host_control_trace_t *const trace = &self->trace;
    return !trace->stretches
           || trace->stretch_max - trace->stretch_count >= nck_host_control_room(self, block);
}

size_t nck_host_control_take(nck_host_control_t *self, const nck_block_t *blocks, size_t count) {
    size_t taken = 0;
    nck_control_trace_again(self);
    while (taken < count && has_room(self, &blocks[taken])) {
        take(self, &blocks[taken]);
        taken++;
    }
    return taken;
}

void nck_host_control_end(nck_host_control_t *self) {
    nck_control_trace_again(self);
    settle_speed(self, NULL);
    const int moved = self->has_last != 0;
    nck_control_rest(self, NCK_LIMIT_EXACT_STOP, self->last.line);
    if (moved) self->low.ends = 1;
    nck_host_cause_add(self->causes, &self->low);
    if (self->trace.stretches) nck_control_trace_settle(self);
    nck_host_cause_end(self->causes);
    self->totals.time_s = self->time_s.sum + self->time_s.rest;
    self->totals.blocks = self->block;
    self->totals.tool_changes = self->shares.tool_changes;
    self->totals.spindle_starts = self->shares.spindle_starts;
}
