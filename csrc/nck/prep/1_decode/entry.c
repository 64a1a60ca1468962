// SPDX-License-Identifier: MIT
// Beginning at a line in the middle: what stands before it is decoded and not handed over. Then the
// tool, the spindle and the coolant that are in force there, and the way to where the tool is.
#include "nck/prep/1_decode/parts.h"

enum {
    PHASE_TOOL, PHASE_CHANGE, PHASE_NEXT, PHASE_SPEED, PHASE_SPINDLE, PHASE_MIST, PHASE_FLOOD,
    PHASE_ACROSS, PHASE_DOWN, PHASES
};

enum { MIST = 1, FLOOD = 2 };

// The axis that goes to the work last: the drill of a mill, X of a lathe.
static unsigned last_axis(const nck_decode_t *self) {
    return self->machine->kinematics == NCK_KINEMATICS_LATHE_XZ ? NCK_AXIS_X : NCK_AXIS_Z;
}

void nck_entry_begin(nck_decode_t *self) {
    if (self->entry.waits != 1) return;
    self->entry.waits = 2;
    self->entry.last_nm = self->place.position_nm[last_axis(self)];
}

int nck_entry_is_here(const nck_decode_t *self) {
    const uint32_t line = self->machine->dialect.from_line;
    const int calls = NCK_HAS_CALLS && self->macro.depth > 0;
    if (self->line.state != NCK_LINE_WAITING || self->macro.seek.kind != NCK_SEEK_NOT) return 0;
    return self->line.number == line || (self->line.number > line && !calls);
}

static void watch_coolant(nck_decode_t *self, const nck_output_t *output) {
    if (output->kind != NCK_OUTPUT_M) return;
    if (output->value == 7.0) self->entry.coolant |= MIST;
    if (output->value == 8.0) self->entry.coolant |= FLOOD;
    if (output->value == 9.0) self->entry.coolant = 0;
}

nck_status_t nck_entry_pass(nck_decode_t *self, const nck_block_t *block) {
    const double line = (double)self->machine->dialect.from_line;
    if (block->kind == NCK_BLOCK_END) {
        self->text.over = 1;
        return nck_decode_fail(self, NCK_E_LABEL, 0, 'N', line, 0.0);
    }
    if (block->kind == NCK_BLOCK_OUTPUT) watch_coolant(self, &block->output);
    return NCK_EMPTY;
}

// ---- what is in force

static nck_status_t give_tool(nck_decode_t *self, uint8_t phase, nck_block_t *out) {
    const uint32_t in = self->modal.tool_in, next = self->modal.tool_next;
    const int turret = self->lathe && self->modal.offset_in >= 0;
    if (phase == PHASE_NEXT) {
        if (next == in) return NCK_EMPTY;
        return nck_decode_give_output(self, NCK_BLOCK_OUTPUT, NCK_OUTPUT_TOOL, next, out);
    }
    if (in == 0 || (phase == PHASE_CHANGE && turret)) return NCK_EMPTY;
    if (phase == PHASE_CHANGE) {
        return nck_decode_give_output(self, NCK_BLOCK_WAIT, NCK_OUTPUT_M, 6.0, out);
    }
    return nck_decode_give_output(self, turret ? NCK_BLOCK_WAIT : NCK_BLOCK_OUTPUT,
                                  NCK_OUTPUT_TOOL, in, out);
}

static nck_status_t give_spindle(nck_decode_t *self, uint8_t phase, nck_block_t *out) {
    const int surface = self->modal.surface_on;
    const double speed = surface ? self->modal.surface : self->modal.speed;
    if (phase == PHASE_SPINDLE) {
        return self->modal.spindle_on ? nck_decode_give_m(self, self->modal.spindle_code, out)
                                      : NCK_EMPTY;
    }
    if (!(speed > 0.0)) return NCK_EMPTY;
    return nck_decode_give_output(self, NCK_BLOCK_OUTPUT,
                                  surface ? NCK_OUTPUT_SURFACE_SPEED : NCK_OUTPUT_SPINDLE_SPEED,
                                  speed, out);
}

static nck_status_t give_coolant(nck_decode_t *self, uint8_t phase, nck_block_t *out) {
    const int bit = phase == PHASE_MIST ? MIST : FLOOD;
    if (!(self->entry.coolant & bit)) return NCK_EMPTY;
    return nck_decode_give_m(self, bit == MIST ? 7.0 : 8.0, out);
}

static nck_status_t give_way(nck_decode_t *self, uint8_t phase, nck_block_t *out) {
    int64_t *const at_nm = &self->place.position_nm[last_axis(self)];
    const int64_t to_nm = *at_nm;
    if (phase == PHASE_ACROSS) *at_nm = self->entry.last_nm;
    nck_decode_give_exact(self, NCK_BLOCK_RAPID, 0.0, out);
    *at_nm = to_nm;
    return NCK_OK;
}

nck_status_t nck_entry_next(nck_decode_t *self, nck_block_t *out) {
    nck_status_t status = NCK_EMPTY;
    self->line.tag = self->line.number;
    if (self->held.contour.mode & NCK_CONTOUR_CORNER) return nck_corner_missing(self);
    if (self->modal.comp) {
        return nck_decode_fail(self, NCK_E_COMP_ON, 0, 'N', (double)self->line.number, 0.0);
    }
    while (status == NCK_EMPTY && self->entry.phase < PHASES) {
        const uint8_t phase = self->entry.phase++;
        if (phase <= PHASE_NEXT) status = give_tool(self, phase, out);
        else if (phase <= PHASE_SPINDLE) status = give_spindle(self, phase, out);
        else if (phase <= PHASE_FLOOD) status = give_coolant(self, phase, out);
        else status = give_way(self, phase, out);
    }
    if (status == NCK_EMPTY) self->entry.waits = 0;
    return status;
}
