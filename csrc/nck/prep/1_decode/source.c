// SPDX-License-Identifier: MIT
// Text becomes lines: what is pushed, and what the room reads itself, also from another place.
#include "nck/prep/1_decode/decode.h"
#include "nck/prep/1_decode/parts.h"
#include "nck/prep/1_decode/state/state.h" // nck_decode_assume

#include <assert.h> // assert
#include <string.h> // memchr memcpy

enum { PIECE = 64 };
enum { WATCH = 1, IN_BRACKETS = 2, TO_LINE_END = 3 }; // of text.watch

// Whether a byte behind the program's end is a remark's, which nobody meant to be read.
static int is_remark(nck_decode_t *self, char c) {
    const unsigned before = self->text.watch;
    unsigned watch = before;
    if (c == '\n' || c == '\r' || (c == ')' && before == IN_BRACKETS)) watch = WATCH;
    else if (before == WATCH && c == '(') watch = IN_BRACKETS;
    else if (before == WATCH && c == ';') watch = TO_LINE_END;
    self->text.watch = (uint8_t)watch;
    return before != WATCH || watch != WATCH;
}

// Behind the program's end: does anything stand there that somebody may have meant to be read?
static void watch_rest(nck_decode_t *self, const char *text, size_t n) {
    for (size_t k = 0; k < n && self->text.watch; k++) {
        const char c = text[k];
        if (c == '\r' || (c == '\n' && !self->line.after_cr)) self->line.number++;
        self->line.after_cr = c == '\r';
        if (is_remark(self, c) || (unsigned char)c <= ' ' || c == '%') continue;
        self->text.watch = 0;
        self->line.tag = self->line.number + 1;
        nck_decode_assume(self, NCK_NOTE_AFTER_END);
    }
}

// More bytes than the line has room for: what does not fit is dropped, and the line is known to be
// too long. Who reads the line sees a NUL byte in it, but for one that is dropped.
static void overflow(nck_decode_t *self, const char *text, size_t n) {
    memcpy(self->line.text + self->line.size, text, NCK_LINE_MAX - self->line.size);
    self->line.size = NCK_LINE_MAX;
    self->line.overflow = 1;
    if (memchr(text, '\0', n) != NULL) self->line.binary = 1;
}

static inline void collect(nck_decode_t *self, const char *text, size_t n) {
    assert(self->line.size <= NCK_LINE_MAX);
    if (n > NCK_LINE_MAX - self->line.size) {
        overflow(self, text, n);
        return;
    }
    memcpy(self->line.text + self->line.size, text, n);
    self->line.size += (uint32_t)n;
}

static void close_line(nck_decode_t *self) {
    self->line.text[self->line.size] = '\n';
    self->line.number++;
    self->line.state = NCK_LINE_WAITING;
}

static int is_begun(const nck_decode_t *self) { return self->line.size > 0; }

// A piece of text for the line, up to its end. Returns how much of it was taken.
static inline size_t take(nck_decode_t *self, const char *text, size_t n) {
    const size_t begin = self->line.after_cr && text[0] == '\n';
    size_t span = n - begin < NCK_LINE_MAX ? n - begin : NCK_LINE_MAX;
    const char *const first = text + begin;
    const char *end = memchr(first, '\n', span);
    if (end != NULL) span = (size_t)(end - first);
    const char *const back = memchr(first, '\r', span);
    if (back != NULL) {
        span = (size_t)(back - first);
        end = back;
    }
    self->line.after_cr = back != NULL;
    collect(self, first, span);
    if (end == NULL) return begin + span;
    close_line(self);
    return begin + span + 1;
}

nck_status_t nck_decode_push(nck_decode_t *self, const char *text, size_t n, size_t *used_out) {
    *used_out = 0;
    if (self->text.complete) return NCK_E_STATE;
    if (self->text.over) {
        watch_rest(self, text, n);
        *used_out = n;
        return NCK_OK;
    }
    if (self->macro.reads) return NCK_E_STATE;
    if (self->line.state != NCK_LINE_OPEN) return NCK_FULL;
    if (n > 0) *used_out = take(self, text, n);
    return NCK_OK;
}

void nck_decode_flush(nck_decode_t *self) {
    if (!self->text.over && self->line.state == NCK_LINE_OPEN && is_begun(self)) close_line(self);
}

int nck_decode_is_empty(const nck_decode_t *self) {
    return self->line.state == NCK_LINE_OPEN && !is_begun(self) && !nck_decode_reads(self);
}

void nck_decode_end(nck_decode_t *self) {
    nck_decode_flush(self);
    self->text.complete = 1;
}

// ---- text that the room reads itself

nck_status_t nck_decode_source(nck_decode_t *self, const nck_source_t *source) {
    if (!NCK_HAS_CALLS) return NCK_E_STATE;
    const int begun = self->line.number > 0 || !nck_decode_is_empty(self) || self->text.begun;
    if (begun || self->text.complete || self->text.over || self->macro.reads) return NCK_E_STATE;
    if (self->session.before) return NCK_E_STATE;
    if (source->text == NULL && source->read == NULL) return NCK_E_ARGUMENT;
    self->macro.source = *source;
    self->macro.reads = 1;
    return NCK_OK;
}

int nck_decode_reads(const nck_decode_t *self) {
    if (self->session.phase != NCK_SESSION_NOT) return 1;
    return self->macro.reads && !self->text.over;
}

size_t nck_decode_used(const nck_decode_t *self) { return self->macro.place.offset; }

// The text from an offset on: in place, or as many bytes as the buffer holds.
static size_t look(const nck_source_t *source, size_t offset, char *buffer, const char **text_out) {
    *text_out = buffer;
    if (source->text == NULL) return source->read(source->user, offset, buffer, PIECE);
    *text_out = source->text + offset;
    return source->size - offset;
}

void nck_decode_fetch(nck_decode_t *self) {
    if (!NCK_HAS_CALLS) return;
    nck_macro_t *const macro = &self->macro;
    char buffer[PIECE];
    const char *text;
    macro->line = macro->place;
    self->line.number = macro->place.line;
    self->line.after_cr = (uint8_t)macro->place.after_cr;
    while (self->line.state == NCK_LINE_OPEN) {
        const size_t n = look(&macro->source, macro->place.offset, buffer, &text);
        if (n == 0) {
            nck_decode_end(self);
            break;
        }
        macro->place.offset += take(self, text, n);
    }
    macro->place.line = self->line.number;
    macro->place.after_cr = self->line.after_cr;
}

// Where the program ends, what follows it is not read: is it text?
void nck_decode_watch(nck_decode_t *self) {
    if (!NCK_HAS_CALLS) return;
    char buffer[PIECE];
    const char *text;
    if (!self->macro.reads || self->macro.jumped) return; // subprograms stand behind the end
    const size_t n = look(&self->macro.source, self->macro.place.offset, buffer, &text);
    watch_rest(self, text, n < NCK_LINE_MAX ? n : NCK_LINE_MAX);
}
