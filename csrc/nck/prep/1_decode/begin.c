// SPDX-License-Identifier: MIT
// A program's beginning: what is in force before its first line, and where the axes stand.
#include "nck/prep/1_decode/decode.h"
#include "nck/prep/1_decode/state/state.h" // nck_variable_restart
#include "nck/prep/1_decode/number/number.h" // nck_decode_scale
#include "nck/prep/1_decode/tongue/tongue.h" // nck_lathe_is_a nck_lathe_speaks_fanuc
#include "nck/prep/1_decode/place/place.h" // nck_decode_origin

#include <string.h> // memcpy memset

static void begin_modes(nck_decode_t *self) {
    const nck_machine_t *const machine = self->machine;
    memset(&self->modal, 0, sizeof self->modal);
    self->modal.motion = machine->dialect.base == NCK_DIALECT_LINUXCNC ? NCK_MOTION_NONE : 0;
    self->modal.plane = machine->dialect.plane;
    self->modal.inch = machine->dialect.inch;
    self->modal.diameter = machine->dialect.diameter;
    self->modal.centre_absolute = machine->dialect.arc_absolute;
    self->modal.path_mode = NCK_PATH_CONTINUOUS;
    // Fanuc's lathes begin with feed per revolution, unless a parameter says otherwise.
    const int open = machine->dialect.feed == NCK_FEED_START_OPEN && self->lathe;
    if (open || machine->dialect.feed == NCK_FEED_START_REV) {
        self->modal.feed_mode = NCK_FEED_PER_REV;
    }
    self->modal.tolerance_mm = machine->path.tolerance;
    self->modal.merge_mm = machine->path.tolerance;
    self->modal.plain_mm = NCK_PLAIN_OPEN;
    self->modal.feed = machine->dialect.feed_default;
    self->modal.feed_word = machine->dialect.feed_default;
    self->modal.speed = -1.0;
    self->entry.waits = machine->dialect.from_line != 0 ? NCK_ENTRY_BEGINS : NCK_ENTRY_NOT;
    // What a language has no word for: G90.1, an end other than the text's, G90 in system A.
    const uint32_t centre = self->tongue != NCK_TONGUE_LINUXCNC;
    const uint32_t end = self->tongue == NCK_TONGUE_MARLIN;
    const uint32_t distance = (uint32_t)nck_lathe_is_a(self);
    self->finding.given = centre << NCK_NOTE_ARC_CENTRE | end << NCK_NOTE_NO_END
                          | distance << NCK_NOTE_DISTANCE;
    if (NCK_HAS_CYCLES) {
        self->held.rough.retract_nm = NCK_ROUGH_RETRACT_NM;
        self->held.peck.back_nm = NCK_ROUGH_RETRACT_NM;
        self->held.cycle.to_r = machine->dialect.base != NCK_DIALECT_FANUC;
    }
    nck_decode_scale(self);
}

void nck_decode_begin(nck_decode_t *self) {
    const uint32_t tool_next = self->modal.tool_next;
    const uint32_t tool_in = self->modal.tool_in;
    const int32_t offset_in = self->modal.offset_in;
    memset(&self->line, 0, sizeof self->line);
    memset(&self->finding, 0, sizeof self->finding);
    memset(&self->text, 0, sizeof self->text);
    nck_variable_restart(self);
    memset(&self->layout, 0, sizeof self->layout);
    memset(&self->states, 0, sizeof self->states);
    memset(&self->held, 0, sizeof self->held);
    memset(&self->entry, 0, sizeof self->entry);
    self->session.phase = NCK_SESSION_NOT;
    self->session.passes = 0;
    self->words.steps = 0;
    begin_modes(self);
    self->modal.tool_next = tool_next;
    self->modal.tool_in = tool_in;
    self->modal.offset_in = offset_in;
    nck_decode_origin(self);
}

void nck_decode_stand(nck_decode_t *self) {
    memcpy(self->place.position_nm, self->machine->start_nm, sizeof self->place.position_nm);
}

static uint16_t tongue_of(const nck_decode_t *self) {
    if (self->lathe) return NCK_TONGUE_TURNING;
    switch (self->machine->dialect.base) {
    case NCK_DIALECT_FANUC: return NCK_TONGUE_FANUC;
    case NCK_DIALECT_GRBL: return NCK_TONGUE_GRBL;
    case NCK_DIALECT_MARLIN: return NCK_TONGUE_MARLIN;
    case NCK_DIALECT_GRBLHAL: return NCK_TONGUES_GRBLHAL;
    default: return NCK_TONGUE_LINUXCNC;
    }
}

void nck_decode_init(nck_decode_t *self, const nck_machine_t *machine) {
    memset(self, 0, sizeof *self);
    self->machine = machine;
    self->lathe = (uint16_t)nck_lathe_speaks_fanuc(self);
    self->tongue = tongue_of(self);
    begin_modes(self);
    self->modal.offset_in = -1;
    for (unsigned axis = 0; axis < NCK_AXIS_MAX; axis++) {
        const uint32_t bit = (uint32_t)1 << axis;
        if (machine->axis[axis].present) self->place.axes |= bit;
        if (machine->axis[axis].rotary) self->place.rotary |= bit;
    }
    nck_decode_stand(self);
    memcpy(self->place.work_nm, machine->work_nm, sizeof machine->work_nm);
    memcpy(self->place.home_nm, machine->home_nm, sizeof self->place.home_nm);
    self->place.work_system = machine->work_system;
    nck_decode_origin(self);
}
