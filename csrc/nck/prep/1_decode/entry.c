// SPDX-License-Identifier: MIT
// Beginning at a line in the middle: what stands before it is decoded; of its blocks only those of
// the path are handed over, for 2_toolcomp follows the tool's centre along it. Then the way in, and
// on it the tool, the spindle, the coolant and all else that has been put out and stays.
#include "nck/prep/1_decode/decode.h"
#include "nck/prep/1_decode/parts.h"
#include "nck/prep/1_decode/state/state.h" // nck_decode_block nck_decode_fail nck_decode_give_m …
#include "nck/prep/1_decode/number/number.h" // nck_decode_letter
#include "nck/prep/1_decode/tongue/tongue.h" // nck_decode_own_m
#include "nck/prep/1_decode/place/place.h" // nck_decode_origin
#include "nck/prep/1_decode/macro/macro.h" // nck_call_level

#include <string.h> // memcmp memcpy

#define SECONDS_PER_MINUTE 60.0

enum {
    PHASE_AWAY, PHASE_TOOL, PHASE_REST, PHASE_CHANGE, PHASE_NEXT, PHASE_ACROSS, PHASE_SPEED,
    PHASE_SPINDLE, PHASE_MIST, PHASE_FLOOD, PHASE_KEPT, PHASE_OWN = PHASE_KEPT + NCK_KEPT,
    PHASE_IN = PHASE_OWN + NCK_OWN_M_MAX, PHASES
};

enum { MIST = 1, FLOOD = 2 }; // bits of modal.coolant

// Where values are kept, among all that is put out and stays.
enum { KEPT_ANALOGUE = NCK_KEPT_DIGITAL, KEPT_SETTING = KEPT_ANALOGUE + NCK_KEPT_ANALOGUE };

// What a printer is set to: heaters, whose second code waits, the fan, and percent of speed and
// flow.
static const struct {
    uint8_t sets, waits;
} settings[NCK_KEPT_SETTINGS] = {{104, 109}, {140, 190}, {141, 191}, {106, 0}, {220, 0}, {221, 0}};

enum { FAN = 3, M_FAN_OFF = 107 };

// ---- where

void nck_entry_begin(nck_decode_t *self) {
    if (self->entry.waits != NCK_ENTRY_BEGINS) return;
    self->entry.waits = NCK_ENTRY_SEEKS;
    self->entry.tool_in = self->modal.tool_in;
    memcpy(self->entry.at_nm, self->place.position_nm, sizeof self->entry.at_nm);
}

// Is the line that waits the one, or has the program passed that over? In a loop a later pass may
// come to the one, and to one of a subprogram that was passed over a call. Loops are those with
// words of their own: a jump backward is known only when it comes.
static int is_reached(nck_decode_t *self) {
    const uint32_t line = self->machine->dialect.from_line;
    if (self->line.state != NCK_LINE_WAITING) return 0;
    if (self->line.number == line) self->entry.is_passed = 0;
    if (self->line.number == line) return 1;
    if (self->line.number < line || self->entry.is_called) return 0;
    if (!NCK_HAS_CALLS || self->macro.depth == 0) return 1;
    if (nck_call_level(self) == 0) self->entry.is_passed = 1;
    return 0;
}

// A move with a corner behind it waits for the line that says where it ends: it is none of what the
// program begins with.
static int holds_move(const nck_decode_t *self) {
    const uint32_t mode = self->held.contour.mode;
    if (!NCK_HAS_CYCLES || (mode & NCK_CONTOUR_READS) != 0) return 0;
    return (mode & NCK_CONTOUR_CORNER) != 0 && self->held.corner.phase != NCK_CORNER_JOINS;
}

int nck_entry_is_here(nck_decode_t *self) {
    const int seeks = self->entry.waits == NCK_ENTRY_SEEKS;
    if (seeks && is_reached(self)) self->entry.waits = NCK_ENTRY_REACHED;
    return self->entry.waits == NCK_ENTRY_REACHED && !holds_move(self);
}

// A subprogram that stands before its call is entered in the call, with its last line too. Where
// another jump ends the program has come to that line: endif, the end of a loop, O… that is called.
void nck_entry_leave_out(nck_decode_t *self, nck_seek_kind_t kind) {
    const int seeks = self->entry.waits == NCK_ENTRY_SEEKS;
    if (!seeks || self->line.number != self->machine->dialect.from_line) return;
    if (kind == NCK_SEEK_ENDSUB) {
        self->entry.is_called = 1;
    } else if (self->macro.seek.kind == NCK_SEEK_NOT) {
        self->entry.waits = NCK_ENTRY_REACHED;
        self->entry.is_passed = 0;
    }
}

// ---- before it

// The program never comes to the line.
static nck_status_t fail_reach(nck_decode_t *self) {
    const double line = (double)self->machine->dialect.from_line;
    self->text.over = 1;
    return nck_decode_fail(self, NCK_E_LABEL, 0, 'N', line, 0.0);
}

// The place of what is put out; NCK_KEPT: nothing of it stays that others do not keep.
static unsigned place_of(const nck_decode_t *self, const nck_output_t *put) {
    const int is_off = put->kind == NCK_OUTPUT_M && put->value == (double)M_FAN_OFF;
    unsigned k = 0;
    if (put->kind == NCK_OUTPUT_DIGITAL) return put->number;
    if (put->kind == NCK_OUTPUT_ANALOGUE) return KEPT_ANALOGUE + put->number;
    if (is_off && self->tongue == NCK_TONGUE_MARLIN) return KEPT_SETTING + FAN;
    if (put->kind != NCK_OUTPUT_SETTING) return NCK_KEPT;
    while (k < NCK_KEPT_SETTINGS && settings[k].sets != put->number
           && settings[k].waits != put->number) {
        k++;
    }
    return KEPT_SETTING + k;
}

// An M code of the machine's own: those that stay are done again, each as it was done last.
static void keep_own(nck_decode_t *self, const nck_own_m_t *own) {
    nck_kept_t *const kept = NCK_KEPT_AT(self, entry.kept);
    const uint8_t row = (uint8_t)(own - self->machine->own_m);
    unsigned count = 0;
    if (!own->stays) {
        nck_decode_note(self, &(nck_diagnostic_t){NCK_NOTE_OWN_LEFT, self->line.tag, 0, 'M',
                                                  own->code, 0.0});
        return;
    }
    for (unsigned k = 0; k < kept->owns; k++) {
        if (kept->own[k] != row) kept->own[count++] = kept->own[k];
    }
    kept->own[count] = row;
    kept->owns = (uint8_t)(count + 1);
}

static void keep(nck_decode_t *self, const nck_output_t *put, int waits) {
    nck_kept_t *const kept = NCK_KEPT_AT(self, entry.kept);
    const unsigned place = place_of(self, put);
    const uint32_t bit = (uint32_t)1 << place % 32;
    if (!NCK_HAS_KEPT) return;
    const nck_own_m_t *const own = put->kind == NCK_OUTPUT_M
                                       ? nck_decode_own_m(self, (int64_t)put->value) : NULL;
    if (own != NULL) keep_own(self, own);
    if (place >= NCK_KEPT) return;
    kept->told[place / 32] |= bit;
    if (place < NCK_KEPT_DIGITAL) {
        kept->on[place / 32] = put->value > 0.0 ? kept->on[place / 32] | bit
                                                : kept->on[place / 32] & ~bit;
        return;
    }
    kept->value[place - NCK_KEPT_DIGITAL] = put->kind == NCK_OUTPUT_M ? 0.0 : put->value;
    if (waits && place >= KEPT_SETTING) kept->waits |= (uint32_t)1 << (place - KEPT_SETTING);
}

nck_status_t nck_entry_pass(nck_decode_t *self, const nck_block_t *block) {
    const int waits = block->kind == NCK_BLOCK_WAIT;
    if (block->kind == NCK_BLOCK_END) return fail_reach(self);
    if (waits || block->kind == NCK_BLOCK_OUTPUT) keep(self, &block->output, waits);
    if (block->kind == NCK_BLOCK_COMP) return NCK_OK;
    if (block->kind > NCK_BLOCK_ARC && block->kind != NCK_BLOCK_THREAD) return NCK_EMPTY;
    for (unsigned axis = 0; axis < NCK_AXIS_MAX; axis++) {
        const int64_t tool = axis < 3 ? block->tool_nm[axis] : 0;
        self->entry.at_nm[axis] = block->target_nm[axis] + tool;
    }
    return NCK_OK;
}

// ---- what is in force

static nck_status_t give_tool(nck_decode_t *self, uint8_t phase, nck_block_t *out) {
    const uint32_t in = self->modal.tool_in, next = self->modal.tool_next;
    const int turret = self->lathe && self->modal.offset_in >= 0;
    if (phase == PHASE_NEXT) {
        if (next == in) return NCK_EMPTY;
        return nck_decode_give_output(self, NCK_BLOCK_OUTPUT, NCK_OUTPUT_TOOL, next, out);
    }
    if (in == self->entry.tool_in || (phase != PHASE_TOOL && turret)) return NCK_EMPTY;
    if (phase == PHASE_REST) return nck_decode_give_m(self, 5.0, out);
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
    if (!(self->modal.coolant & bit)) return NCK_EMPTY;
    return nck_decode_give_m(self, bit == MIST ? 7.0 : 8.0, out);
}

// What has been put out there and stays; a printer's heater is waited for if the program has.
static nck_status_t give_kept(nck_decode_t *self, unsigned place, nck_block_t *out) {
    const nck_kept_t *const kept = NCK_KEPT_AT(self, entry.kept);
    const uint32_t bit = (uint32_t)1 << place % 32;
    if (!NCK_HAS_KEPT || !(kept->told[place / 32] & bit)) return NCK_EMPTY;
    if (place < NCK_KEPT_DIGITAL) {
        const double value = (kept->on[place / 32] & bit) != 0 ? 1.0 : 0.0;
        (void)nck_decode_give_output(self, NCK_BLOCK_OUTPUT, NCK_OUTPUT_DIGITAL, value, out);
        out->output.number = place;
        return NCK_OK;
    }
    const int sets = place >= KEPT_SETTING;
    const unsigned k = sets ? place - KEPT_SETTING : 0;
    const int waits = sets && (kept->waits >> k & 1u);
    (void)nck_decode_give_output(self, waits ? NCK_BLOCK_WAIT : NCK_BLOCK_OUTPUT,
                                 sets ? NCK_OUTPUT_SETTING : NCK_OUTPUT_ANALOGUE,
                                 kept->value[place - NCK_KEPT_DIGITAL], out);
    out->output.number = place - KEPT_ANALOGUE;
    if (sets) out->output.number = waits ? settings[k].waits : settings[k].sets;
    return NCK_OK;
}

static nck_status_t give_own(nck_decode_t *self, unsigned k, nck_block_t *out) {
    const nck_kept_t *const kept = NCK_KEPT_AT(self, entry.kept);
    if (!NCK_HAS_KEPT || k >= kept->owns) return NCK_EMPTY;
    const nck_own_m_t *const own = &self->machine->own_m[kept->own[k]];
    return nck_decode_give_output(self, own->waits ? NCK_BLOCK_WAIT : NCK_BLOCK_OUTPUT,
                                  NCK_OUTPUT_M, own->code, out);
}

// ---- the way in

// A part of it: each ends at a stop, and the spindle turns from the last one on.
static nck_status_t give_way(nck_decode_t *self, nck_way_t part, nck_block_t *out) {
    nck_decode_block(self, NCK_BLOCK_ENTRY, out);
    out->path_mode = NCK_PATH_STOP;
    out->tolerance_mm = 0.0;
    out->merge_mm = 0.0;
    out->feed_mode = NCK_FEED_PER_MINUTE;
    out->output.number = (uint32_t)part;
    if (part == NCK_WAY_IN) {
        out->feed = self->machine->approach.feed * SECONDS_PER_MINUTE;
        return NCK_OK;
    }
    out->spindle_rpm = 0.0;
    out->surface = 0.0;
    return NCK_OK;
}

static nck_status_t give(nck_decode_t *self, uint8_t phase, nck_block_t *out) {
    if (phase >= PHASE_OWN && phase < PHASE_IN) return give_own(self, phase - PHASE_OWN, out);
    if (phase >= PHASE_KEPT && phase < PHASE_OWN) return give_kept(self, phase - PHASE_KEPT, out);
    switch (phase) {
    case PHASE_AWAY: return give_way(self, NCK_WAY_AWAY, out);
    case PHASE_ACROSS: return give_way(self, NCK_WAY_ACROSS, out);
    case PHASE_IN: return give_way(self, NCK_WAY_IN, out);
    case PHASE_SPEED:
    case PHASE_SPINDLE: return give_spindle(self, phase, out);
    case PHASE_MIST:
    case PHASE_FLOOD: return give_coolant(self, phase, out);
    default: return give_tool(self, phase, out);
    }
}

// What a printer has put out is put out: where the extruder stands has the name that the program
// has for it there, as behind G92.
static void name_extruder(nck_decode_t *self) {
    const unsigned axis = NCK_AXIS_U;
    if (axis >= NCK_AXIS_MAX || self->machine->dialect.base != NCK_DIALECT_MARLIN) return;
    const int64_t by_nm = self->machine->start_nm[axis] - self->entry.at_nm[axis];
    self->entry.at_nm[axis] += by_nm;
    self->place.position_nm[axis] += by_nm;
    self->place.g92_nm[axis] += by_nm;
    nck_decode_origin(self);
}

// Is a way needed, and known?
static nck_status_t check_way(nck_decode_t *self) {
    const unsigned axis = nck_machine_approach_axis(self->machine);
    const int is_there = !memcmp(self->entry.at_nm, self->machine->start_nm,
                                 sizeof self->entry.at_nm);
    const int stays = is_there && self->modal.comp != NCK_COMPENSATES;
    if (stays || nck_machine_approach_nm(self->machine) < INT64_MAX) return NCK_OK;
    return nck_decode_fail(self, NCK_E_APPROACH, 1, nck_decode_letter(axis),
                           (double)self->machine->dialect.from_line, 0.0);
}

nck_status_t nck_entry_next(nck_decode_t *self, nck_block_t *out) {
    nck_status_t status = NCK_EMPTY;
    self->line.tag = self->line.number;
    if (self->entry.is_passed) return fail_reach(self);
    if (self->entry.phase == 0) {
        name_extruder(self);
        const nck_status_t way = check_way(self);
        if (way != NCK_OK) return way;
    }
    while (status == NCK_EMPTY && self->entry.phase < PHASES) {
        status = give(self, self->entry.phase, out);
        self->entry.phase++;
    }
    if (status != NCK_OK) {
        self->entry.waits = NCK_ENTRY_NOT;
        return status;
    }
    memcpy(out->target_nm, self->entry.at_nm, sizeof out->target_nm); // where the tool would be
    for (unsigned axis = 0; axis < 3; axis++) out->target_nm[axis] -= out->tool_nm[axis];
    return NCK_OK;
}
