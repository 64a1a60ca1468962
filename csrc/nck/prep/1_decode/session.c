// SPDX-License-Identifier: MIT
// A session: how it begins, what it is told between lines, and what of it is dropped. decode.c has
// what it makes of a line.
#include "nck/base/in_force.h" // NCK_FORCE_…
#include "nck/prep/1_decode/decode.h"
#include "nck/prep/1_decode/parts.h"
#include "nck/prep/1_decode/state/state.h" // nck_spline_break
#include "nck/prep/1_decode/macro/macro.h" // nck_parameter_set_probe
#include "nck/prep/1_decode/place/place.h" // nck_decode_origin nck_table_find …

#include <string.h> // memcpy memset

void nck_session_go_back(nck_decode_t *self) {
    const uint8_t complete = self->text.complete; // may have come meanwhile
    if (self->session.phase == NCK_SESSION_NOT) return;
    *self = *self->session.before;
    self->text.complete = complete;
    self->text.quick = 0; // what was told since counts for nothing
}

nck_status_t nck_decode_lend(nck_decode_t *self, nck_decode_t *before) {
    const int begun = self->line.number > 0 || self->text.begun || !nck_decode_is_empty(self);
    if (begun || self->macro.reads) return NCK_E_STATE;
    self->session.before = before;
    return NCK_OK;
}

nck_status_t nck_decode_leave_nothing(nck_decode_t *self) {
    if (!self->session.before || !nck_decode_is_empty(self)) return NCK_E_STATE;
    self->session.passes = 1;
    self->text.quick = 0; // its modes are to be kept
    return NCK_OK;
}

nck_status_t nck_decode_probed(nck_decode_t *self, const int64_t *at_nm) {
    int64_t stands_nm[NCK_AXIS_MAX];
    if (!NCK_HAS_CYCLES) return NCK_E_UNSUPPORTED;
    memcpy(stands_nm, self->place.position_nm, sizeof stands_nm);
    if (at_nm) memcpy(self->place.position_nm, at_nm, sizeof stands_nm);
    const nck_status_t status = nck_parameter_set_probe(self, at_nm != NULL);
    memcpy(self->place.position_nm, stands_nm, sizeof stands_nm);
    return status;
}

nck_status_t nck_decode_answered(nck_decode_t *self, double value) {
    return nck_parameter_set_answer(self, value);
}

nck_status_t nck_decode_set_offsets(nck_decode_t *self, const nck_offsets_t *offsets) {
    const int known = nck_tool_is_known(self, offsets->tool_next)
                      && nck_tool_is_known(self, offsets->tool_in);
    if (offsets->system >= NCK_WORK_SYSTEMS) return NCK_E_ARGUMENT;
    if (!known) return NCK_E_TOOL_UNKNOWN;
    memcpy(self->place.work_nm, offsets->systems_nm,
           NCK_WORK_SYSTEMS * sizeof self->place.work_nm[0]);
    memcpy(self->place.home_nm, offsets->home_nm, sizeof self->place.home_nm);
    memcpy(self->place.g92_nm, offsets->g92_nm, sizeof self->place.g92_nm);
    memcpy(self->place.g92_kept_nm, offsets->g92_nm, sizeof self->place.g92_kept_nm);
    memcpy(self->place.tool_nm, offsets->tool_nm, sizeof self->place.tool_nm);
    self->place.is_local = 0;
    self->place.work_system = offsets->system;
    self->modal.tool_next = offsets->tool_next;
    self->modal.tool_in = offsets->tool_in;
    self->text.quick = 0; // it goes by another origin
    nck_decode_origin(self);
    return NCK_OK;
}

int nck_decode_tool_of(const nck_decode_t *self, uint32_t number, nck_tool_t *tool_out) {
    return nck_table_find(self, number, tool_out);
}

void nck_decode_forget_tool(nck_decode_t *self, uint32_t number) {
    nck_table_forget(self, number);
}

void nck_decode_name_line(nck_decode_t *self, uint32_t name) { self->line.number = name - 1; }

void nck_decode_drop(nck_decode_t *self) {
    nck_session_go_back(self);
    memset(&self->line, 0, sizeof self->line);
    self->words.steps = 0;
    nck_spline_break(self);
    self->session.phase = NCK_SESSION_NOT;
    self->session.passes = 0;
    self->held.contour.mode = NCK_CONTOUR_NOT;
    self->macro.seek.kind = NCK_SEEK_NOT;
    self->finding.count = 0;
    self->text.complete = 0;
    self->text.closed = NCK_CLOSED_NOT;
    self->text.over = 0;
    self->text.watch = 0;
    self->text.quick = 0;
}

uint32_t nck_decode_modes(const nck_decode_t *self) {
    const nck_modes_t *const modal = &self->modal;
    uint32_t modes = 1u << NCK_FORCE_KNOWN | self->place.work_system << NCK_FORCE_SYSTEM;
    modes |= (uint32_t)(modal->plane - 17) << NCK_FORCE_PLANE;
    modes |= (uint32_t)modal->feed_mode << NCK_FORCE_FEED_MODE;
    modes |= (uint32_t)modal->path_mode << NCK_FORCE_PATH_MODE;
    modes |= (uint32_t)modal->spindle_code << NCK_FORCE_SPINDLE_CODE;
    modes |= (uint32_t)modal->coolant << NCK_FORCE_COOLANT;
    modes |= (uint32_t)modal->inch << NCK_FORCE_INCH;
    modes |= (uint32_t)modal->diameter << NCK_FORCE_DIAMETER;
    modes |= (uint32_t)modal->spindle_on << NCK_FORCE_SPINDLE_ON;
    return nck_decode_moves(self, modes);
}
