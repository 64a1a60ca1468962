// SPDX-License-Identifier: MIT
// Blocks with all that is modal: what every one of them has, and those that hand something over.
#include "nck/prep/1_decode/state/state.h"
#include "nck/base/real.h" // NCK_APART nck_mm_of

#include <stddef.h> // NULL
#include <string.h> // memcpy memset

const nck_tool_t *nck_decode_find_tool(const nck_decode_t *self, uint32_t number) {
    for (uint32_t k = 0; k < self->machine->tool_count; k++) {
        if (self->machine->tool[k].number == number) return &self->machine->tool[k];
    }
    return NULL;
}

// The most under G96: the program's or the machine's, whichever is less; 0: neither says one.
double nck_decode_speed_most(const nck_decode_t *self) {
    const double machine = self->machine->spindle.rpm_max;
    const double said = self->modal.speed_most;
    return said > 0.0 && (machine <= 0.0 || said < machine) ? said : machine;
}

int nck_decode_turns(const nck_decode_t *self) {
    return self->modal.spindle_on
           && (self->modal.surface_on ? self->modal.surface : self->modal.speed) > 0.0;
}

// What only some blocks have; member by member, for one clearing of all of it takes longer.
static inline void clear(nck_block_t *out) {
    out->centre_mm[0] = 0.0;
    out->centre_mm[1] = 0.0;
    out->sweep_rad = 0.0;
    out->feed = 0.0;
    out->spindle_rpm = 0.0;
    out->surface = 0.0;
    out->spindle_x_mm = 0.0;
    out->dwell_s = 0.0;
    memset(&out->thread, 0, sizeof out->thread);
    memset(&out->tap, 0, sizeof out->tap);
    memset(&out->output, 0, sizeof out->output);
}

// Kind and plane come last: a compiler would take some pains to store four bytes in a row at once.
void nck_decode_block(const nck_decode_t *self, nck_block_kind_t kind, nck_block_t *out) {
    out->line = self->line.tag;
    out->modes = 0; // whoever hands blocks on says them
    out->reserved = 0;
    out->path_mode = self->modal.path_mode;
    out->feed_mode = self->modal.feed_mode;
    memcpy(out->target_nm, self->place.position_nm, sizeof out->target_nm);
    memcpy(out->tool_nm, self->place.tool_nm, sizeof out->tool_nm);
    for (unsigned axis = 0; axis < 3; axis++) out->target_nm[axis] -= out->tool_nm[axis];
    clear(out);
    if (nck_decode_turns(self)) {
        out->spindle_rpm = self->modal.surface_on ? nck_decode_speed_most(self) : self->modal.speed;
        out->surface = self->modal.surface_on ? self->modal.surface : 0.0;
        out->spindle_x_mm = nck_mm_of(self->place.origin_nm[NCK_AXIS_X]);
    }
    out->kind = (uint8_t)kind;
    out->plane = self->modal.plane;
    out->tolerance_mm = self->modal.tolerance_mm;
    out->merge_mm = self->modal.merge_mm;
    out->output.line = self->line.tag;
}

// The spindle is to turn, or to turn at another speed.
static int changes_speed(const nck_decode_t *self, nck_output_kind_t kind, double value) {
    if (kind == NCK_OUTPUT_SPINDLE_SPEED) return self->modal.spindle_on;
    return kind == NCK_OUTPUT_M && (value == 3.0 || value == 4.0);
}

nck_status_t nck_decode_give_output(const nck_decode_t *self, nck_block_kind_t block,
                                    nck_output_kind_t kind, double value, nck_block_t *out) {
    const int waits = self->machine->spindle_waits && changes_speed(self, kind, value);
    nck_decode_block(self, waits ? NCK_BLOCK_WAIT : block, out);
    out->output.kind = kind;
    out->output.value = value;
    return NCK_OK;
}

nck_status_t nck_decode_give_m(const nck_decode_t *self, double code, nck_block_t *out) {
    return nck_decode_give_output(self, NCK_BLOCK_OUTPUT, NCK_OUTPUT_M, code, out);
}

NCK_APART nck_status_t nck_decode_give_dwell(const nck_decode_t *self, double dwell_s,
                                             nck_block_t *out) {
    nck_decode_block(self, NCK_BLOCK_DWELL, out);
    out->dwell_s = dwell_s;
    return NCK_OK;
}
