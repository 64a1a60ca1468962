// SPDX-License-Identifier: MIT
// The line that nearly all lines of large programs are: G0 or G1, or neither, and words of X Y Z.
// Whatever else a line says, and every mistake, is left to the reader that knows all words: so
// nothing here needs a column, a step or a diagnostic.
#include "nck/prep/1_decode/integer.h" // nck_decode_asks_integers
#include "nck/prep/1_decode/parts.h"

enum { CODE_NONE = -1, CODE_LINE = 10 }; // in tenths

enum { WHOLE_MOST = 9 }; // digits in front of a number's point, so that its counts fit

static const int64_t power_of_ten[] = {1, 10, 100, 1000, 10000, 100000, 1000000, 10000000,
                                       100000000, 1000000000};

// A line as far as it is read.
typedef struct quick {
    int64_t nm[3]; // what X Y Z say, of those that are named; then where they lead
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
                          && (self->held.contour.mode | self->entry.waits | self->layout.on) == 0;
    const int linear = !(self->place.rotary & 7u);
    return self->text.words && by_itself && linear && (noted & wanted) == wanted;
}

static inline unsigned digit_of(const char *at) {
    return (unsigned)(unsigned char)*at - (unsigned)'0';
}

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

// A number of few digits that is whole in counts of the scale. NULL if it is none of these, or
// beyond the scale's limit.
static inline const char *read_counts(const nck_decode_t *self, const char *at,
                                      const nck_scale_t *scale, int64_t *out) {
    const int negative = *at == '-';
    const char *const first = at + negative;
    uint64_t mantissa = 0;
    unsigned behind = 0;
    const char *end = read_digits(first, &mantissa, &behind);
    int shift = scale->power;
    if (end - first > WHOLE_MOST) return (const char *)0;
    if (behind == digit_of(".")) {
        const char *const point = end;
        end = read_digits(point + 1, &mantissa, &behind);
        shift -= (int)(end - point) - 1;
        if (shift < 0 || end == first + 1) return (const char *)0;
    } else if (end == first || (mantissa != 0 && nck_decode_asks_integers(self))) {
        return (const char *)0;
    }
    const int64_t counts = (int64_t)mantissa * power_of_ten[shift] * scale->factor;
    if (counts > scale->limit) return (const char *)0;
    *out = negative ? -counts : counts;
    return end;
}

static inline const char *read_axis(const nck_decode_t *self, quick_t *line, unsigned axis,
                                    const char *at) {
    const uint32_t bit = 1u << axis;
    if (line->axes & bit) return (const char *)0;
    line->axes |= bit;
    return read_counts(self, at, &self->place.scale[axis == NCK_AXIS_X], &line->nm[axis]);
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

// A word. NULL: it is none for here, or a mistake.
static inline const char *read_word(const nck_decode_t *self, quick_t *line, const char *at) {
    const unsigned letter = (unsigned)(unsigned char)*at & ~0x20u;
    if (letter >= 'X' && letter <= 'Z') return read_axis(self, line, letter - 'X', at + 1);
    if (letter == 'G') return read_code(line, at + 1);
    return letter == 'N' ? read_name(line, at + 1) : (const char *)0;
}

// Words with blanks between them, to the line's end. 0: one is none for here, or a mistake.
static inline int read_words(const nck_decode_t *self, quick_t *line) {
    const char *at = self->line.text;
    for (;;) {
        while (*at == ' ') at++;
        if (*at == '\n') return 1;
        at = read_word(self, line, at);
        if (!at) return 0;
    }
}

// Where a named axis goes, counted from there. 0: beyond the numbers' range, or its travel.
static inline int find_target(const nck_decode_t *self, quick_t *line, const int64_t *from_nm,
                              unsigned axis) {
    const nck_axis_t *const travel = &self->machine->axis[axis];
    const int64_t limit = self->place.scale[0].limit;
    if (!(line->axes & 1u << axis)) return 1;
    const int64_t target = line->nm[axis] + from_nm[axis];
    line->nm[axis] = target;
    return (uint64_t)(target + limit) <= 2 * (uint64_t)limit && target >= travel->min_nm
           && target <= travel->max_nm;
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
    const int cuts = line.code == CODE_LINE;
    self->text.quick = 1;
    self->line.tag = self->line.number;
    self->modal.motion = line.code;
    for (unsigned axis = 0; axis < 3; axis++) {
        if (line.axes & 1u << axis) self->place.position_nm[axis] = line.nm[axis];
    }
    nck_decode_block(self, cuts ? NCK_BLOCK_LINE : NCK_BLOCK_RAPID, out);
    out->feed = cuts ? self->modal.feed : 0.0;
    return 1;
}
