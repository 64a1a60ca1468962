// SPDX-License-Identifier: MIT
// M70 M71 M72 M73: what is in force is kept, forgotten, restored; M73 has it restored when its call
// is over. The motion, tools and radius compensation stay as they are.
#include "nck/prep/1_decode/macro/parts.h"
#include "nck/prep/1_decode/state/state.h" // nck_decode_fail_step nck_decode_give_m …
#include "nck/prep/1_decode/number/number.h" // nck_decode_scale
#include "nck/prep/1_decode/place/place.h" // nck_decode_origin

#include <stddef.h> // NULL
#include <string.h> // memcpy

// Outputs that a restored state owes, in this order.
enum { SPEED = 1, SPINDLE = 2, OFF = 4, MIST = 8, FLOOD = 16 };
enum { GIVES = 1 }; // code of M72 behind its first output

static uint32_t level_of(const nck_decode_t *self) { return nck_call_level(self) + 1; }

static nck_state_t *find(nck_decode_t *self, uint32_t level) {
    for (unsigned k = 0; k < NCK_STATE_ROWS; k++) {
        if (self->states.kept[k].level == level) return &self->states.kept[k];
    }
    return NULL;
}

static nck_status_t fail(nck_decode_t *self, nck_status_t code, double value, double limit) {
    return nck_decode_fail_step(self, code, NCK_STEP_STATE, 'M', value, limit);
}

static nck_status_t keep(nck_decode_t *self, int returns) {
    const uint32_t level = level_of(self);
    nck_state_t *state = find(self, level);
    if (state == NULL) state = find(self, 0);
    if (state == NULL) return fail(self, NCK_E_DEPTH, NCK_STATE_ROWS, NCK_STATE_ROWS);
    state->modal = self->modal;
    memcpy(state->tool_nm, self->place.tool_nm, sizeof state->tool_nm);
    state->work_system = self->place.work_system;
    state->to_r = NCK_HAS_CYCLES ? self->held.cycle.to_r : 0;
    state->level = level;
    state->returns = (uint8_t)returns;
    return NCK_OK;
}

static int differ(double a, double b) { return a < b || a > b; }

// Is there a speed that is another one?
static int speeds(const nck_modes_t *now, const nck_modes_t *then) {
    const int said = then->surface_on ? then->surface > 0.0 : then->speed >= 0.0;
    return said && (now->surface_on != then->surface_on || differ(now->speed, then->speed)
                    || differ(now->surface, then->surface));
}

static void restore(nck_decode_t *self, const nck_state_t *state) {
    const nck_modes_t now = self->modal;
    const int turns = now.spindle_on != state->modal.spindle_on
                      || (state->modal.spindle_on && now.spindle_code != state->modal.spindle_code);
    uint32_t bits = speeds(&now, &state->modal) ? SPEED : 0u;
    if (turns) bits |= SPINDLE;
    if (now.coolant & (uint32_t)~state->modal.coolant) bits |= OFF;
    const uint32_t on = bits & OFF ? state->modal.coolant
                                   : state->modal.coolant & (uint32_t)~now.coolant;
    self->states.pending = bits | (on & 1u ? MIST : 0u) | (on & 2u ? FLOOD : 0u);
    self->modal = state->modal;
    self->modal.motion = now.motion;
    self->modal.tool_next = now.tool_next;
    self->modal.tool_in = now.tool_in;
    self->modal.offset_in = now.offset_in;
    self->modal.excused = now.excused;
    memcpy(self->place.tool_nm, state->tool_nm, sizeof state->tool_nm);
    self->place.work_system = state->work_system;
    if (NCK_HAS_CYCLES) self->held.cycle.to_r = state->to_r;
    nck_decode_scale(self);
    nck_decode_origin(self);
}

nck_status_t nck_state_give(nck_decode_t *self, nck_step_t step, nck_block_t *out) {
    if (!NCK_HAS_FOREIGN) return NCK_EMPTY;
    const nck_modes_t *const modal = &self->modal;
    const uint32_t all = self->states.pending;
    const uint32_t first = all & (0u - all);
    if (first == 0) return NCK_EMPTY;
    self->states.pending = all & ~first;
    self->words.code[step] = GIVES;
    if (self->states.pending != 0) self->words.steps |= NCK_STEP(step);
    switch (first) {
    case SPEED:
        return nck_decode_give_output(self, NCK_BLOCK_OUTPUT,
                                      modal->surface_on ? NCK_OUTPUT_SURFACE_SPEED
                                                        : NCK_OUTPUT_SPINDLE_SPEED,
                                      modal->surface_on ? modal->surface : modal->speed, out);
    case SPINDLE: return nck_decode_give_m(self, modal->spindle_on ? modal->spindle_code : 5, out);
    case OFF: return nck_decode_give_m(self, 9.0, out);
    case MIST: return nck_decode_give_m(self, 7.0, out);
    default: return nck_decode_give_m(self, 8.0, out);
    }
}

void nck_state_return(nck_decode_t *self, uint32_t level) {
    if (!NCK_HAS_FOREIGN) return;
    nck_state_t *const state = find(self, level + 1);
    if (state == NULL) return;
    state->level = 0;
    if (!state->returns || state->modal.comp != self->modal.comp) return;
    restore(self, state);
    if (self->states.pending == 0) return;
    self->words.steps |= NCK_STEP(NCK_STEP_CALL);
    self->words.code[NCK_STEP_CALL] = GIVES;
}

nck_status_t nck_decode_state(nck_decode_t *self, nck_block_t *out) {
    if (!NCK_HAS_FOREIGN) return fail(self, NCK_E_UNSUPPORTED, 0.0, 0.0);
    const uint16_t code = self->words.code[NCK_STEP_STATE];
    if (code == GIVES) return nck_state_give(self, NCK_STEP_STATE, out);
    if (code == 700 || code == 730) {
        const nck_status_t kept = keep(self, code == 730);
        return kept == NCK_OK ? NCK_EMPTY : kept;
    }
    nck_state_t *const state = find(self, level_of(self));
    if (code == 710) {
        if (state != NULL) state->level = 0;
        return NCK_EMPTY;
    }
    if (state == NULL) return fail(self, NCK_E_FLOW, 72.0, 0.0);
    if (state->modal.comp != self->modal.comp) return fail(self, NCK_E_COMP_ON, 72.0, 0.0);
    restore(self, state);
    return nck_state_give(self, NCK_STEP_STATE, out);
}
