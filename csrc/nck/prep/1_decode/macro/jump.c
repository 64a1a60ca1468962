// SPDX-License-Identifier: MIT
// Jumps: the frames of calls and loops, and lines passed over until what is looked for comes.
#include "nck/prep/1_decode/macro/parts.h"
#include "nck/prep/1_decode/state/state.h" // nck_decode_fail nck_decode_find
#include "nck/base/real.h" // nck_min

#include <stddef.h> // NULL
#include <string.h> // memset

enum { PROGRAMS = 10000 }; // Fanuc's names of programs have four digits

static const nck_text_place_t beginning = {0, 0, 0};
static const double count_most = 1e6;

nck_status_t nck_decode_fail_last(nck_decode_t *self, nck_status_t code, double value,
                                  double limit) {
    self->text.over = 1;
    self->macro.seek.kind = NCK_SEEK_NOT;
    return nck_decode_fail(self, code, 0, 0, value, limit);
}

nck_status_t nck_jump(nck_decode_t *self, const nck_text_place_t *place) {
    if (!NCK_HAS_CALLS) return NCK_E_UNSUPPORTED;
    nck_macro_t *const macro = &self->macro;
    if (!macro->reads) return nck_decode_fail_last(self, NCK_E_NO_SEEK, 0.0, 0.0);
    macro->back += place->offset <= macro->line.offset;
    if (macro->back > NCK_DECODE_JUMPS_MOST) {
        const double most = NCK_DECODE_JUMPS_MOST;
        self->text.over = 1;
        macro->seek.kind = NCK_SEEK_NOT;
        return nck_decode_fail(self, NCK_E_ENDLESS, 0, 'J', most, most);
    }
    macro->place = *place;
    macro->jumped = 1;
    self->text.complete = 0;
    return NCK_OK;
}

// ---- frames

nck_frame_t *nck_frame_loop(nck_decode_t *self) {
    if (!NCK_HAS_CALLS) return NULL;
    nck_macro_t *const macro = &self->macro;
    if (macro->depth == 0) return NULL;
    nck_frame_t *const frame = &macro->frame[macro->depth - 1];
    return frame->kind >= NCK_FRAME_WHILE ? frame : NULL;
}

nck_frame_t *nck_frame_call(nck_decode_t *self) {
    if (!NCK_HAS_CALLS) return NULL;
    nck_macro_t *const macro = &self->macro;
    for (uint32_t k = macro->depth; k > 0; k--) {
        if (macro->frame[k - 1].kind < NCK_FRAME_WHILE) return &macro->frame[k - 1];
    }
    return NULL;
}

uint32_t nck_call_level(const nck_decode_t *self) {
    const nck_macro_t *const macro = &self->macro;
    uint32_t k = NCK_HAS_CALLS ? macro->depth : 0;
    while (k > 0 && macro->frame[k - 1].kind >= NCK_FRAME_WHILE) k--;
    return k;
}

nck_status_t nck_frame_push(nck_decode_t *self, nck_frame_kind_t kind, uint64_t key,
                            uint32_t count) {
    if (!NCK_HAS_CALLS) return NCK_E_UNSUPPORTED;
    nck_macro_t *const macro = &self->macro;
    const nck_frame_t *const caller = nck_frame_call(self);
    if (macro->depth + 1 > NCK_CALL_DEPTH) {
        return nck_decode_fail_last(self, NCK_E_DEPTH, NCK_CALL_DEPTH, NCK_CALL_DEPTH);
    }
    nck_frame_t *const frame = &macro->frame[macro->depth];
    memset(frame, 0, sizeof *frame);
    frame->key = key;
    if (caller != NULL) frame->begin = caller->begin; // M97 stays in its caller's program
    frame->kind = kind;
    frame->count = count;
    frame->line = self->line.tag;
    frame->base = macro->base;
    frame->place = kind == NCK_FRAME_WHILE ? macro->line : macro->place;
    macro->depth++;
    macro->jumped = 1;
    return NCK_OK;
}

// Loops that a jump backward leaves: those that begin behind its target.
static void leave_loops(nck_decode_t *self, size_t offset) {
    const nck_frame_t *loop = nck_frame_loop(self);
    while (loop != NULL && loop->place.offset > offset) {
        self->macro.depth--;
        loop = nck_frame_loop(self);
    }
}

void nck_decode_tell_calls(nck_decode_t *self) {
    if (!NCK_HAS_CALLS) return;
    nck_macro_t *const macro = &self->macro;
    for (uint32_t k = macro->depth; k > 0; k--) {
        const nck_frame_t *const frame = &macro->frame[k - 1];
        const nck_diagnostic_t called = {NCK_NOTE_CALLED, frame->line, 0, 0, 0.0, 0.0};
        if (frame->kind < NCK_FRAME_WHILE) nck_decode_find(self, &called);
    }
}

// ---- labels

static void remember(nck_decode_t *self, nck_seek_kind_t kind, uint64_t key,
                     const nck_text_place_t *place) {
    nck_macro_t *const macro = &self->macro;
    nck_label_t *const label = &macro->label[macro->labels % NCK_DECODE_LABELS];
    *label = (nck_label_t){key, *place, kind};
    macro->labels++;
}

static const nck_label_t *known(const nck_macro_t *macro, nck_seek_kind_t kind, uint64_t key) {
    for (unsigned k = 0; k < NCK_DECODE_LABELS; k++) {
        if (macro->label[k].kind == (uint32_t)kind && macro->label[k].key == key) {
            return &macro->label[k];
        }
    }
    return NULL;
}

// ---- seeking

void nck_seek(nck_decode_t *self, nck_seek_kind_t kind, uint64_t key) {
    if (!NCK_HAS_CALLS) return;
    nck_macro_t *const macro = &self->macro;
    macro->seek.kind = kind;
    macro->seek.key = key;
    macro->seek.begin = macro->place.offset;
    macro->seek.wrapped = 0;
    macro->seek.decides = 0;
    macro->seek.from = self->line.tag;
    macro->jumped = 1;
}

static nck_status_t seek_named(nck_decode_t *self, nck_seek_kind_t kind, uint64_t key) {
    const nck_label_t *const label = known(&self->macro, kind, key);
    if (label != NULL) {
        // What was called begins here.
        const nck_text_place_t *const place = &label->place;
        nck_frame_t *const frame = nck_frame_call(self);
        if (frame != NULL) frame->begin = *place;
        return nck_jump(self, place);
    }
    nck_seek(self, kind, key);
    return NCK_OK;
}

// Fanuc's P of a call says how often, too, where no program has all of it for its name: 31235 is
// three times 1235.
static nck_status_t seek_split(nck_decode_t *self, uint64_t key) {
    nck_frame_t *const frame = nck_frame_call(self);
    const uint64_t count = frame->count > 0 ? frame->count : 1;
    self->macro.absent = key;
    frame->key = key % PROGRAMS;
    frame->count = (uint32_t)nck_min((double)(count * (key / PROGRAMS)), count_most);
    return seek_named(self, NCK_SEEK_PROGRAM, frame->key);
}

static int splits(const nck_decode_t *self, nck_seek_kind_t kind, uint64_t key) {
    return kind == NCK_SEEK_PROGRAM && nck_is_fanuc(self) && key >= PROGRAMS && key % PROGRAMS != 0;
}

nck_status_t nck_seek_called(nck_decode_t *self, nck_seek_kind_t kind, uint64_t key) {
    if (!NCK_HAS_CALLS) return NCK_E_UNSUPPORTED;
    if (splits(self, kind, key) && self->macro.absent == key) return seek_split(self, key);
    return seek_named(self, kind, key);
}

// A place of the same program that has been read.
static int is_behind(nck_decode_t *self, size_t offset) {
    const nck_frame_t *const frame = nck_frame_call(self);
    return offset < self->macro.place.offset && (frame == NULL || offset >= frame->begin.offset);
}

nck_status_t nck_seek_number(nck_decode_t *self, uint64_t number) {
    if (!NCK_HAS_CALLS) return NCK_E_UNSUPPORTED;
    const nck_label_t *const label = known(&self->macro, NCK_SEEK_NUMBER, number);
    if (label != NULL && self->macro.reads && is_behind(self, label->place.offset)) {
        leave_loops(self, label->place.offset);
        return nck_jump(self, &label->place);
    }
    nck_seek(self, NCK_SEEK_NUMBER, number);
    return NCK_OK;
}

// What is looked for is nowhere. NCK_OK: something else is looked for.
static nck_status_t fail_seek(nck_decode_t *self) {
    const uint32_t kind = self->macro.seek.kind, from = self->macro.seek.from;
    const uint64_t key = self->macro.seek.key;
    if (splits(self, (nck_seek_kind_t)kind, key)) {
        self->macro.seek.kind = NCK_SEEK_NOT;
        const nck_status_t status = seek_split(self, key);
        self->macro.seek.from = from;
        return status;
    }
    const int label = kind <= NCK_SEEK_NUMBER;
    const int backward = label && !self->macro.reads;
    self->line.tag = self->macro.seek.from;
    return nck_decode_fail_last(self, backward ? NCK_E_NO_SEEK : label ? NCK_E_LABEL : NCK_E_FLOW,
                                key < 1000000000u ? (double)key : 0.0, 0.0);
}

// From the end of the text to where the program begins, or the one that was called.
nck_status_t nck_seek_wrap(nck_decode_t *self) {
    if (!NCK_HAS_CALLS) return NCK_E_UNSUPPORTED;
    nck_macro_t *const macro = &self->macro;
    const nck_frame_t *const frame = nck_frame_call(self);
    const int own = macro->seek.kind == NCK_SEEK_NUMBER && frame != NULL;
    if (!macro->reads || macro->seek.wrapped || macro->seek.kind > NCK_SEEK_NUMBER) {
        const nck_status_t status = fail_seek(self);
        if (status != NCK_OK || macro->seek.kind == NCK_SEEK_NOT) return status;
    }
    macro->seek.wrapped = 1;
    return nck_jump(self, own ? &frame->begin : &beginning);
}

// Whether the line is what is looked for.
static int is_found(const nck_decode_t *self, const nck_sign_t *sign) {
    static const uint8_t words[][2] = { // from, to: by nck_seek_kind_t
        {1, 0}, {NCK_O_SUB, NCK_O_SUB}, {NCK_O_NAME, NCK_O_NAME}, {1, 0},
        {NCK_O_ENDSUB, NCK_O_ENDSUB}, {NCK_O_ELSEIF, NCK_O_ENDIF}, {NCK_O_ENDIF, NCK_O_ENDIF},
        {NCK_O_WHILE, NCK_O_ENDREPEAT}, {NCK_O_WHILE, NCK_O_ENDREPEAT}, {NCK_O_END, NCK_O_END}
    };
    const uint32_t kind = self->macro.seek.kind;
    const uint64_t key = self->macro.seek.key;
    if (kind == NCK_SEEK_NUMBER) return sign->numbered && sign->number == key;
    return sign->key == key && sign->word >= words[kind][0] && sign->word <= words[kind][1];
}

// The target has come. NCK_OK: its line is done, NCK_EMPTY: what follows it is.
static nck_status_t found(nck_decode_t *self, const nck_sign_t *sign) {
    nck_macro_t *const macro = &self->macro;
    const nck_seek_kind_t kind = (nck_seek_kind_t)macro->seek.kind;
    const int decides = kind == NCK_SEEK_ELSE && sign->word == NCK_O_ELSEIF;
    macro->seek.kind = NCK_SEEK_NOT;
    macro->seek.decides = (uint32_t)decides;
    if (kind == NCK_SEEK_NUMBER) {
        remember(self, kind, sign->number, &macro->line);
        if (macro->seek.wrapped) leave_loops(self, macro->line.offset);
        return NCK_OK;
    }
    if (kind <= NCK_SEEK_PROGRAM) {
        nck_frame_t *const frame = nck_frame_call(self);
        remember(self, kind, sign->key, &macro->place);
        if (frame != NULL) frame->begin = macro->place;
    }
    return decides || kind == NCK_SEEK_LOOP_TAIL ? NCK_OK : NCK_EMPTY;
}

// A line on the way to N…: the way may lead out of a loop, and ends where another program begins.
static nck_status_t pass_on(nck_decode_t *self, const nck_sign_t *sign) {
    const nck_frame_t *const loop = nck_frame_loop(self);
    if (sign->word == NCK_O_END && loop != NULL && loop->key == sign->key) self->macro.depth--;
    if (sign->word != NCK_O_NAME || !self->macro.reads) return NCK_EMPTY;
    const nck_status_t status = nck_seek_wrap(self);
    return status == NCK_OK ? NCK_EMPTY : status;
}

nck_status_t nck_seek_pass(nck_decode_t *self) {
    if (!NCK_HAS_CALLS) return NCK_E_UNSUPPORTED;
    nck_macro_t *const macro = &self->macro;
    nck_sign_t sign;
    nck_decode_sign(self, &sign);
    if (is_found(self, &sign)) return found(self, &sign);
    if (macro->seek.wrapped) {
        if (macro->line.offset < macro->seek.begin) return NCK_EMPTY;
        const nck_status_t status = fail_seek(self);
        return status == NCK_OK ? NCK_EMPTY : status;
    }
    return macro->seek.kind == NCK_SEEK_NUMBER ? pass_on(self, &sign) : NCK_EMPTY;
}
