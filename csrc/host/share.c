// SPDX-License-Identifier: MIT
// Shares of a plan's time by line, section or tool.
#include "host/share.h"

#include <string.h> // memset

enum { M_CLOCKWISE = 3, M_ANTICLOCKWISE = 4, M_STOP = 5, M_TOOL = 6, M_END = 2, M_END_TAPE = 30 };

void nck_host_share_init(nck_host_shares_t *self, const nck_machine_t *machine) {
    memset(self, 0, sizeof *self);
    self->turret = machine->dialect.base == NCK_DIALECT_FANUC
                   && machine->kinematics == NCK_KINEMATICS_LATHE_XZ;
}

// The row of a tool: its own, or another one as long as there is room.
static nck_host_share_t *row_of_tool(nck_host_shares_t *self, uint32_t tool) {
    for (size_t i = 0; i < self->count; i++) {
        if (self->rows[i].key == tool) return &self->rows[i];
    }
    if (self->count < self->max) {
        self->rows[self->count].key = tool;
        self->count++;
    }
    return &self->rows[self->count - 1];
}

// NULL: nobody asked, or the line is none of the program's.
static nck_host_share_t *row_of(nck_host_shares_t *self, uint32_t line) {
    nck_host_share_t *row = NULL;
    if (!self->rows || self->max == 0) return NULL;
    if (!self->row_of_line) {
        row = row_of_tool(self, self->tool);
    } else if (line <= self->line_max && self->row_of_line[line] < self->max) {
        row = &self->rows[self->row_of_line[line]];
    } else {
        return NULL;
    }
    if (row->line == 0) row->line = line;
    return row;
}

static void change_tool(nck_host_shares_t *self, uint32_t line) {
    self->tool = self->tool_next;
    self->tool_changes++;
    nck_host_share_t *const row = row_of(self, line);
    if (row) row->tool_changes++;
}

// A start from rest, and a reversal, which comes to rest in between.
static void turn(nck_host_shares_t *self, uint32_t line, uint32_t code) {
    if (self->turns == code) return;
    self->turns = code;
    self->spindle_starts++;
    nck_host_share_t *const row = row_of(self, line);
    if (row) row->spindle_starts++;
}

void nck_host_share_output(nck_host_shares_t *self, const nck_output_t *output) {
    if (output->kind == NCK_OUTPUT_TOOL) {
        const uint32_t before = self->tool;
        self->tool_next = (uint32_t)output->value;
        if (self->turret && self->tool_next != before) change_tool(self, output->line);
        return;
    }
    if (output->kind != NCK_OUTPUT_M) return;
    switch ((uint32_t)output->value) {
    case M_CLOCKWISE:
    case M_ANTICLOCKWISE:
        turn(self, output->line, (uint32_t)output->value);
        break;
    case M_TOOL:
        if (!self->turret) change_tool(self, output->line);
        break;
    case M_STOP:
    case M_END:
    case M_END_TAPE:
        self->turns = 0;
        break;
    default:
        break;
    }
}

void nck_host_share_add(nck_host_shares_t *self, uint32_t line, nck_host_share_kind_t kind,
                        double time_s) {
    nck_host_share_t *const row = row_of(self, line);
    if (!row) return;
    double *const sums[] = {&row->cut_s, &row->rapid_s, &row->dwell_s};
    *sums[kind] += time_s;
}
