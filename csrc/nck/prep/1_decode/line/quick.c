// SPDX-License-Identifier: MIT
// The line that nearly all lines of large programs are: G0 or G1, or neither, and words of X Y Z.
// Whatever else a line says, and every mistake, is left to the reader that knows all words: so
// nothing here needs a column, a step or a diagnostic.
#include "nck/prep/1_decode/line/line.h"
#include "nck/prep/1_decode/state/state.h" // nck_decode_block
#include "nck/prep/1_decode/number/number.h" // nck_decode_asks_integers
#include "nck/prep/1_decode/motion/motion.h" // nck_decode_has_feed

enum { CODE_NONE = -1, CODE_LINE = 10 }; // in tenths

enum { WHOLE_MOST = 9 }; // digits in front of a number's point, so that its counts fit

static const int64_t power_of_ten[] = {1, 10, 100, 1000, 10000, 100000, 1000000, 10000000,
                                       100000000, 1000000000};

// A line as far as it is read.
typedef struct quick {
    int64_t at[3]; // what X Y Z say, of those that are named; then where they lead [nm]
    uint32_t axes; // bit k: axis k is named
    int code;      // in tenths; CODE_NONE: none yet
    int is_named;  // 1: N was read
} quick_t;

// A program that has begun and moves straight, and in which nothing but modes is in force. Behind a
// line that was one for here that is so.
static int is_plain(const nck_decode_t *self) {
    if (self->text.quick) return 1;
    const uint32_t noted = self->finding.given | self->finding.notes;
    const uint32_t wanted = 1u << NCK_NOTE_UNITS | 1u << NCK_NOTE_DISTANCE;
    const int by_itself = self->macro.seek.kind == NCK_SEEK_NOT && self->macro.modal == 0
                          && (self->held.contour.mode | self->entry.waits | self->layout.on
                           | self->session.passes) == 0;
    const int linear = !(self->place.rotary & 7u);
    return self->text.words && by_itself && linear && (noted & wanted) == wanted;
}

static inline unsigned digit_of(const char *at) {
    return (unsigned)(unsigned char)*at - (unsigned)'0';
}

static inline unsigned letter_of(const char *at) { return (unsigned)(unsigned char)*at & ~0x20u; }

// Digits in a row, behind those of the mantissa; of too many the mantissa is worth nothing. What
// stands behind them, as a digit's distance from 0, goes to *behind_out.
static inline const char *read_digits(const char *at, uint64_t *mantissa, unsigned *behind_out) {
    unsigned digit = digit_of(at);
    while (digit <= 9) {
        *mantissa = *mantissa * 10 + digit;
        at++;
        digit = digit_of(at);
    }
    *behind_out = digit;
    return at;
}

// A number of few digits as parts of a unit, 10^power of them, if it is whole in these. NULL if it
// is none of these.
static inline const char *read_parts(const nck_decode_t *self, const char *at, int power,
                                     int64_t *out) {
    const int negative = *at == '-';
    const char *const first = at + negative;
    uint64_t mantissa = 0;
    unsigned behind = 0;
    const char *end = read_digits(first, &mantissa, &behind);
    int shift = power;
    if (end - first > WHOLE_MOST) return (const char *)0;
    if (behind == digit_of(".")) {
        const char *const point = end;
        end = read_digits(point + 1, &mantissa, &behind);
        shift -= (int)(end - point) - 1;
        if (shift < 0 || end == first + 1) return (const char *)0;
    } else if (end == first || (mantissa != 0 && nck_decode_asks_integers(self))) {
        return (const char *)0;
    }
    const int64_t parts = (int64_t)mantissa * power_of_ten[shift];
    *out = negative ? -parts : parts;
    return end;
}

static inline const char *read_axis(const nck_decode_t *self, quick_t *line, unsigned axis,
                                    const char *at) {
    if (line->axes >> axis & 1u) return (const char *)0;
    line->axes |= 1u << axis;
    return read_parts(self, at, self->place.scale[0].power, &line->at[axis]);
}

// G0 or G1.
static const char *read_code(quick_t *line, const char *at) {
    const char *const digit = *at == '0' && digit_of(at + 1) <= 9 ? at + 1 : at;
    if (line->code != CODE_NONE || digit_of(digit) > 1) return (const char *)0;
    line->code = digit_of(digit) == 0 ? 0 : CODE_LINE;
    return digit + 1;
}

static const char *read_name(quick_t *line, const char *at) {
    uint64_t name = 0;
    unsigned behind = 0;
    const char *const end = read_digits(at, &name, &behind);
    const int is_good = !line->is_named && end > at;
    line->is_named = 1;
    return is_good ? end : (const char *)0;
}

// A blank, or a word of another letter. NULL: it is none for here, or a mistake.
static inline const char *read_other(quick_t *line, const char *at) {
    const unsigned letter = letter_of(at);
    if (*at == ' ') return at + 1;
    if (letter == 'G') return read_code(line, at + 1);
    return letter == 'N' ? read_name(line, at + 1) : (const char *)0;
}

// Words with blanks between them, to the line's end; most are axes with one blank behind them.
// 0: one is none for here, or a mistake.
static inline int read_words(const nck_decode_t *self, quick_t *line) {
    const char *at = self->line.text;
    for (;;) {
        const unsigned axis = letter_of(at) - 'X';
        if (axis <= NCK_AXIS_Z) at = read_axis(self, line, axis, at + 1);
        else if (*at == '\n') return 1;
        else at = read_other(line, at);
        if (!at) return 0;
        if (*at == ' ') at++;
    }
}

// 1 if a number is no further from 0 than the limit.
static inline int is_within(int64_t value, int64_t limit) {
    return (uint64_t)(value + limit) <= 2 * (uint64_t)limit;
}

// Where a named axis goes, counted from there. 0: beyond the numbers' range, or its travel.
static inline int find_target(const nck_decode_t *self, quick_t *line, const int64_t *from_nm,
                              unsigned axis) {
    const nck_axis_t *const travel = &self->machine->axis[axis];
    const nck_scale_t *const scale = &self->place.scale[axis == NCK_AXIS_X];
    if (!(line->axes & 1u << axis)) return 1;
    const int64_t word = line->at[axis] * scale->factor;
    const int64_t target = word + from_nm[axis];
    line->at[axis] = target;
    return is_within(word, scale->limit) && is_within(target, scale->limit)
           && target >= travel->min_nm && target <= travel->max_nm;
}

static inline int find_targets(const nck_decode_t *self, quick_t *line) {
    const int64_t *const from_nm =
        self->modal.incremental ? self->place.position_nm : self->place.origin_nm;
    return find_target(self, line, from_nm, NCK_AXIS_X)
           && find_target(self, line, from_nm, NCK_AXIS_Y)
           && find_target(self, line, from_nm, NCK_AXIS_Z);
}

// 1 if the line is one for here, and no mistake is in it.
static inline int read_line(const nck_decode_t *self, quick_t *line) {
    if (self->line.overflow || !read_words(self, line)) return 0;
    if (line->axes == 0 || (line->axes & ~self->place.axes)) return 0;
    if (!find_targets(self, line)) return 0;
    if (line->code == CODE_NONE) line->code = self->modal.motion;
    if (line->code != CODE_LINE) return line->code < CODE_LINE;
    return self->modal.feed_mode == NCK_FEED_PER_MINUTE && self->modal.feed > 0.0;
}

int nck_decode_quick(nck_decode_t *self, nck_block_t *out) {
    quick_t line;
    if (!is_plain(self)) return 0;
    line.axes = 0;
    line.code = CODE_NONE;
    line.is_named = 0;
    if (!read_line(self, &line)) return 0;
    self->text.quick = 1;
    self->line.tag = self->line.number;
    self->modal.motion = line.code;
    self->modal.group = (uint8_t)line.code;
    for (unsigned axis = 0; axis < 3; axis++) {
        if (line.axes & 1u << axis) self->place.position_nm[axis] = line.at[axis];
    }
    nck_decode_block(self, line.code == CODE_LINE ? NCK_BLOCK_LINE : NCK_BLOCK_RAPID, out);
    if (nck_decode_has_feed(self, out->kind)) out->feed = self->modal.feed;
    return 1;
}
