// SPDX-License-Identifier: MIT
// The line that nearly all lines of large programs are: G0 or G1, or neither, and words of X Y Z.
// Whatever else a line says, and every mistake, is left to the reader that knows all words: so
// nothing here needs a column, a step or a diagnostic.
#include "nck/prep/1_decode/parts.h"

#include <string.h> // memcpy

enum { CODE_NONE = -1, CODE_LINE = 10 }; // in tenths

// A line as far as it is read.
typedef struct quick {
    const char *at;
    int64_t target_nm[NCK_AXIS_MAX];
    uint32_t axes; // bit k: axis k is named
    int64_t code;  // in tenths; CODE_NONE: none yet
    int is_named;  // 1: N was read
} quick_t;

// A program that has begun and moves straight, and in which nothing but modes is in force.
static int is_plain(const nck_decode_t *self) {
    const uint32_t noted = self->finding.given | self->finding.notes;
    const uint32_t wanted = 1u << NCK_NOTE_UNITS | 1u << NCK_NOTE_DISTANCE;
    const int whole = self->text.words && !(self->line.overflow | self->line.binary);
    const int by_itself = self->macro.seek.kind == NCK_SEEK_NOT && self->macro.modal == 0;
    const int moves = self->modal.motion == 0 || self->modal.motion == CODE_LINE;
    const int linear = !(self->place.rotary & 7u);
    return whole && by_itself && moves && linear && (noted & wanted) == wanted;
}

static int read_axis(const nck_decode_t *self, quick_t *line, unsigned axis,
                     const nck_number_t *word) {
    const nck_scale_t *const scale = &self->place.scale[axis == NCK_AXIS_X];
    const nck_axis_t *const travel = &self->machine->axis[axis];
    const uint32_t bit = 1u << axis;
    int64_t value = 0;
    if ((line->axes & bit) || !nck_number_fixed(self->line.text, word, scale, &value)) return 0;
    value += self->modal.incremental ? self->place.position_nm[axis] : self->place.origin_nm[axis];
    line->axes |= bit;
    line->target_nm[axis] = value;
    return value >= -scale->limit && value <= scale->limit && value >= travel->min_nm
           && value <= travel->max_nm;
}

static int read_code(quick_t *line, const nck_number_t *word) {
    const int is_first = line->code == CODE_NONE;
    return is_first && nck_number_whole(word, 1, &line->code)
           && (line->code == 0 || line->code == CODE_LINE);
}

static int read_word(const nck_decode_t *self, quick_t *line) {
    const int letter = *line->at & ~0x20;
    const int is_axis = letter >= 'X' && letter <= 'Z';
    nck_number_t word;
    if (!is_axis && letter != 'G' && letter != 'N') return 0;
    line->at = nck_number_read(self->line.text, line->at + 1, &word);
    if (!line->at) return 0;
    if (is_axis) return read_axis(self, line, (unsigned)letter - 'X', &word);
    if (letter == 'G') return read_code(line, &word);
    const int again = line->is_named;
    line->is_named = 1;
    return !again;
}

// 1 if the line is one for here, and no mistake is in it.
static int read_line(const nck_decode_t *self, quick_t *line) {
    while (*line->at == ' ') line->at++;
    while (*line->at != '\n') {
        if (!read_word(self, line)) return 0;
    }
    if (line->code == CODE_NONE) line->code = self->modal.motion;
    const int cuts = line->code == CODE_LINE;
    const int has_feed = self->modal.feed_mode == NCK_FEED_PER_MINUTE && self->modal.feed > 0.0;
    return line->axes != 0 && !(line->axes & ~self->place.axes) && line->code <= CODE_LINE
           && (!cuts || has_feed);
}

int nck_decode_quick(nck_decode_t *self, nck_block_t *out) {
    quick_t line;
    if (!is_plain(self)) return 0;
    line.at = self->line.text;
    line.axes = 0;
    line.code = CODE_NONE;
    line.is_named = 0;
    memcpy(line.target_nm, self->place.position_nm, sizeof line.target_nm);
    if (!read_line(self, &line)) return 0;
    const int cuts = line.code == CODE_LINE;
    self->line.tag = self->line.number;
    self->modal.motion = (int32_t)line.code;
    memcpy(self->place.position_nm, line.target_nm, sizeof line.target_nm);
    nck_decode_block(self, cuts ? NCK_BLOCK_LINE : NCK_BLOCK_RAPID, out);
    out->feed = cuts ? self->modal.feed : 0.0;
    return 1;
}
