// SPDX-License-Identifier: MIT
// Calls: M97, M98, M99, G65, G66, G67, and how every call begins and ends.
#include "nck/prep/1_decode/macro/parts.h"
#include "nck/prep/1_decode/state/state.h" // nck_decode_assume nck_decode_fail_code …
#include "nck/prep/1_decode/number/number.h" // nck_decode_whole

#include <stddef.h> // NULL

enum { COUNT_MOST = 1000000, PROGRAM_MOST = 99999999 };

static nck_status_t begin_locals(nck_decode_t *self, nck_frame_kind_t kind, int modal) {
    nck_macro_t *const macro = &self->macro;
    const uint32_t from = macro->base;
    if (kind == NCK_FRAME_PROGRAM) return NCK_OK;
    macro->base = macro->locals;
    return kind == NCK_FRAME_MACRO ? nck_variable_copy_kept(self, from, modal) : NCK_OK;
}

// M97: its lines stand in the caller's program.
static int is_of_lines(const nck_frame_t *frame) {
    return frame->kind == NCK_FRAME_PROGRAM && frame->key > NCK_LINE_KEY;
}

nck_status_t nck_call(nck_decode_t *self, nck_frame_kind_t kind, uint64_t key, uint32_t count) {
    if (!NCK_HAS_CALLS) return NCK_E_UNSUPPORTED;
    const int modal = self->words.code[NCK_STEP_CALL] == 661;
    nck_status_t status = NCK_OK;
    if (!self->macro.reads) return nck_decode_fail_last(self, NCK_E_NO_SEEK, 0.0, 0.0);
    status = nck_frame_push(self, kind, key, count);
    if (status == NCK_OK) status = begin_locals(self, kind, modal);
    if (status != NCK_OK) return status;
    if (is_of_lines(nck_frame_call(self))) return nck_seek_number(self, key - NCK_LINE_KEY);
    return nck_seek_called(self, kind == NCK_FRAME_SUB ? NCK_SEEK_SUB : NCK_SEEK_PROGRAM, key);
}

nck_status_t nck_call_return(nck_decode_t *self) {
    if (!NCK_HAS_CALLS) return NCK_E_UNSUPPORTED;
    nck_macro_t *const macro = &self->macro;
    nck_frame_t *const frame = nck_frame_call(self);
    if (frame == NULL) return nck_decode_fail_last(self, NCK_E_FLOW, 0.0, 0.0);
    nck_state_return(self, nck_call_level(self));
    macro->depth = (uint32_t)(frame - macro->frame);
    if (frame->kind == NCK_FRAME_SUB || frame->kind == NCK_FRAME_MACRO) {
        macro->locals = macro->base;
        macro->base = frame->base;
    }
    if (frame->count > 1) {
        macro->depth++;
        frame->count--;
        if (is_of_lines(frame)) return nck_seek_number(self, frame->key - NCK_LINE_KEY);
        const nck_status_t status = begin_locals(self, (nck_frame_kind_t)frame->kind, 0);
        return status == NCK_OK ? nck_jump(self, &frame->begin) : status;
    }
    if (frame->kind == NCK_FRAME_MACRO) nck_variable_drop_kept(self, 0);
    return nck_jump(self, &frame->place);
}

// ---- words

enum { LINES = 970 }; // M97 P: the lines from N… on

// M99: the call is over; with P it returns to the line of that number, in the main program too.
static nck_status_t end_program(nck_decode_t *self) {
    const nck_frame_t *const frame = nck_frame_call(self);
    int64_t number = -1;
    nck_status_t status = nck_decode_whole(self, 'P', PROGRAM_MOST, -1, &number);
    if (status != NCK_OK) return status;
    if (frame == NULL && number < 0) {
        // In the main program it has it begin again: it is done once, and that is told.
        nck_decode_assume(self, NCK_NOTE_REPEATS);
        self->words.steps |= NCK_STEP(NCK_STEP_STOP);
        self->words.code[NCK_STEP_STOP] = 300;
        return NCK_OK;
    }
    if (frame != NULL && frame->kind == NCK_FRAME_SUB) {
        return nck_decode_fail_code(self, NCK_E_UNSUPPORTED, NCK_STEP_CALL);
    }
    if (frame != NULL) status = nck_call_return(self);
    if (status != NCK_OK || number < 0) return status;
    return nck_seek_number(self, (uint64_t)number);
}

void nck_decode_call_behind(nck_decode_t *self) {
    nck_words_t *const words = &self->words;
    if (self->macro.base != self->macro.modal_base) return;
    if (words->steps & NCK_STEP(NCK_STEP_CALL)) return;
    words->steps |= NCK_STEP(NCK_STEP_CALL);
    words->code[NCK_STEP_CALL] = 661; // the call behind a move
}

// P: the program; L: how often. Fanuc writes both into P, where no program has such a name
// (jump.c).
static nck_status_t call_program(nck_decode_t *self, uint16_t code) {
    nck_macro_t *const macro = &self->macro;
    int64_t program = 0, count = 0;
    nck_status_t status = nck_decode_whole(self, 'P', PROGRAM_MOST, -1, &program);
    if (status == NCK_OK) status = nck_decode_whole(self, 'L', COUNT_MOST, 1, &count);
    if (status != NCK_OK) return status;
    if (program <= 0) return nck_decode_fail_missing(self, NCK_STEP_CALL, 'P');
    const int shares = code == 980 || code == LINES;
    if (!shares) status = nck_argument_all(self);
    if (status != NCK_OK) return status;
    if (code == 660) {
        macro->modal = (uint64_t)program;
        macro->modal_base = macro->base;
        return NCK_OK;
    }
    const nck_frame_kind_t kind = shares ? NCK_FRAME_PROGRAM : NCK_FRAME_MACRO;
    const uint64_t key = (uint64_t)program + (code == LINES ? NCK_LINE_KEY : 0);
    return count > 0 ? nck_call(self, kind, key, (uint32_t)count) : NCK_OK;
}

nck_status_t nck_decode_call(nck_decode_t *self, nck_block_t *out) {
    nck_macro_t *const macro = &self->macro;
    const uint16_t code = self->words.code[NCK_STEP_CALL];
    nck_status_t status = NCK_OK;
    if (!NCK_HAS_CALLS) {
        return nck_decode_fail_step(self, NCK_E_UNSUPPORTED, NCK_STEP_CALL, 0, code / 10.0, 0.0);
    }
    if (code == 1) return nck_state_give(self, NCK_STEP_CALL, out);
    if (code == 990) {
        status = end_program(self);
    } else if (code == 661) {
        status = nck_call(self, NCK_FRAME_MACRO, macro->modal, 1);
    } else if (code == 670) {
        macro->modal = 0;
        if (macro->base == macro->modal_base) nck_variable_drop_kept(self, 1);
    } else {
        status = call_program(self, code);
    }
    return status == NCK_OK ? NCK_EMPTY : status;
}
