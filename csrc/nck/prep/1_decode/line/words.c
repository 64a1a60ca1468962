// SPDX-License-Identifier: MIT
// One source line → words: a single pass over its bytes.
#include "nck/prep/1_decode/line/line.h"
#include "nck/prep/1_decode/state/state.h" // nck_decode_fail nck_decode_skips nck_value_is …
#include "nck/prep/1_decode/number/number.h" // nck_number_read nck_number_real …
#include "nck/prep/1_decode/tongue/tongue.h" // nck_decode_code nck_decode_who nck_lathe_code …
#include "nck/prep/1_decode/place/place.h" // nck_layout_bit nck_layout_collides
#include "nck/prep/1_decode/macro/macro.h" // nck_argument_keep nck_argument_place …
#include "nck/prep/1_decode/motion/motion.h" // nck_corner_keep nck_corner_speaks nck_polar_read

#include <stddef.h> // NULL

// Does the line have a word of this letter? Asked of lines that are refused, read or not.
static int says(const nck_decode_t *self, char letter) {
    const char *const text = self->line.text;
    int comment = 0;
    for (uint32_t k = 0; k < self->line.size && (comment || text[k] != ';'); k++) {
        if (text[k] == '(' || text[k] == ')') comment = text[k] == '(';
        if (!comment && (text[k] & ~0x20) == letter && !nck_is_letter(text[k + 1])) return 1;
    }
    return 0;
}

void nck_decode_excuse(nck_decode_t *self) {
    if (says(self, 'F')) self->modal.excused |= NCK_EXCUSED_FEED;
    if (says(self, 'S')) self->modal.excused |= NCK_EXCUSED_SPEED;
    if (self->modal.motion == NCK_MOTION_NONE && says(self, 'G')) {
        self->modal.motion = NCK_MOTION_REFUSED;
    }
}

static unsigned column_of(const nck_decode_t *self, const char *at) {
    return (unsigned)(at - self->line.text) + 1;
}

// Does a value begin here that is no plain number? Two letters begin a function.
static int begins_value(const char *at) {
    if (*at == '+' || *at == '-') at = nck_decode_skip(at + 1);
    return *at == '#' || *at == '[' || (nck_is_letter(at[0]) && nck_is_letter(at[1]));
}

// A letter without a number behind it: a control word, a letter with a value, or a mistake.
// NCK_EMPTY: the letter does not count.
static nck_status_t read_value(nck_decode_t *self, const char **at, nck_number_t *out) {
    const char *const letter = *at;
    const char *const first = nck_decode_skip(letter + 1);
    double value = 0.0;
    nck_status_t status = nck_decode_control(self, at);
    if (status != NCK_EMPTY) return status == NCK_OK ? NCK_EMPTY : status;
    const nck_flag_t flag = nck_printer_flag(self, (char)(*letter & ~0x20));
    if (flag != NCK_FLAG_NONE) {
        *at = letter + 1;
        nck_number_tenths(0, out);
        return flag == NCK_FLAG_IDLE ? NCK_EMPTY : NCK_OK;
    }
    if (!begins_value(first) || !NCK_HAS_VARIABLES) {
        return nck_decode_fail(self, begins_value(first) ? NCK_E_UNSUPPORTED : NCK_E_NUMBER,
                               column_of(self, letter), *letter & ~0x20, 0.0, 0.0);
    }
    *at = first;
    status = nck_decode_value(self, at, 0, &value);
    if (status != NCK_OK) return status;
    nck_decode_number(value, out);
    return nck_value_is(value) ? NCK_OK : NCK_EMPTY;
}

// The number behind a letter, inline: 18 instructions a word less.
static inline nck_status_t read_number(nck_decode_t *self, const char **at, nck_number_t *out) {
    const char *const next = nck_number_read(self->line.text, *at + 1, out);
    if (next == NULL) return read_value(self, at, out);
    *at = next;
    return NCK_OK;
}

// What is neither a letter nor a blank nor a comment.
static nck_status_t fail_character(nck_decode_t *self, const char *at) {
    const char c = *at;
    nck_status_t code = NCK_E_CHARACTER;
    if (c == '[' || c == '@' || c == '^') code = NCK_E_UNSUPPORTED;
    if (c == '.' || c == '+' || c == '-') code = NCK_E_NUMBER;
    return nck_decode_fail(self, code, column_of(self, at), 0, (double)(unsigned char)c, 0.0);
}

// A code whose step has one already. G80 cancels cycles, and a motion beside it is the motion;
// Fanuc's last one of a group counts, so the G90 of a safety line is none.
static nck_status_t collide(nck_words_t *words, unsigned step, int64_t tenths) {
    if (!(words->codes & NCK_STEP(step))) return NCK_OK;
    if (step == NCK_STEP_LAYOUT) {
        const int both = nck_layout_collides(words->code[step], nck_layout_bit(tenths));
        return both ? NCK_E_MODAL_GROUP : NCK_OK;
    }
    const int before = words->code[step] == 800, now = tenths == 800;
    const int turns = words->code[step] == NCK_MOTION_TURN || words->code[step] == NCK_MOTION_FACE;
    if (step == NCK_STEP_MOTION && turns && tenths <= NCK_MOTION_FACE) return NCK_OK;
    if (step != NCK_STEP_MOTION || before == now) return NCK_E_MODAL_GROUP;
    return now ? NCK_EMPTY : NCK_OK;
}

static void keep_code(nck_words_t *words, unsigned step, int64_t tenths) {
    const uint32_t bit = NCK_STEP(step);
    const uint32_t before = (words->codes & bit) != 0 ? words->code[step] : 0u;
    const int many = step == NCK_STEP_LAYOUT;
    words->code[step] = (uint16_t)(many ? before | nck_layout_bit(tenths) : (uint64_t)tenths);
    words->codes |= bit;
    words->steps |= bit;
}

// A printer's text is no word.
static const char *behind_code(const nck_decode_t *self, const char *at, unsigned step) {
    const int may = step == NCK_STEP_OWN || step == NCK_STEP_STOP;
    return may ? nck_printer_text(self, at, step) : at;
}

// The code of a letter and its number: what it is called here, its step and what it takes.
static nck_status_t find_code(const nck_decode_t *self, int letter, const nck_number_t *number,
                              int64_t *tenths, unsigned *step, uint32_t *takes) {
    if (!nck_number_whole(number, 1, tenths)) {
        return letter == 'G' ? NCK_E_G_UNKNOWN : NCK_E_M_UNKNOWN;
    }
    if (self->lathe && letter == 'G') *tenths = nck_lathe_code(self, *tenths);
    return nck_decode_code(self, letter, *tenths, step, takes);
}

// G and M codes: sorted into the step that executes them.
static nck_status_t read_code(nck_decode_t *self, const char **at) {
    nck_words_t *const words = &self->words;
    const unsigned column = column_of(self, *at);
    const int letter = **at & ~0x20;
    nck_number_t number;
    int64_t tenths = 0;
    unsigned step = 0;
    uint32_t takes = 0;

    const char *const printed = self->tongue == NCK_TONGUE_MARLIN ? nck_printer_code(*at, &number)
                                                                  : NULL;
    nck_status_t status = NCK_OK;
    if (printed != NULL) *at = printed;
    else status = read_number(self, at, &number);
    if (status != NCK_OK) return status;
    status = find_code(self, letter, &number, &tenths, &step, &takes);
    if (status == NCK_OK && step == NCK_STEP_COUNT) return NCK_OK; // it ends what is not built
    if (status == NCK_OK) status = collide(words, step, tenths);
    if (status == NCK_EMPTY) return NCK_OK;
    if (status != NCK_OK) {
        const double who = status == NCK_E_OTHER_BASE ? nck_decode_who(letter, tenths) : 0.0;
        return nck_decode_fail(self, status, column, letter, nck_number_real(&number), who);
    }
    words->takes |= takes;
    words->code_column[step] = (uint16_t)column;
    const int own_g = letter == 'G' && step == NCK_STEP_OWN;
    keep_code(words, step, own_g ? tenths + NCK_CODE_OWN_G : tenths);
    *at = behind_code(self, *at, step);
    return NCK_OK;
}

// I, J or K of G65 or G66.
static nck_status_t read_argument(nck_decode_t *self, const char **at) {
    const char *const first = *at;
    nck_number_t number;
    unsigned place = 0;
    nck_status_t status = nck_argument_place(self, first, &place);
    if (status != NCK_OK) return status;
    status = read_number(self, at, &number);
    return status == NCK_OK ? nck_argument_keep(self, first, place, &number) : status;
}

static nck_status_t read_word(nck_decode_t *self, const char **at) {
    nck_words_t *const words = &self->words;
    const char letter = (char)(**at & ~0x20);
    const unsigned index = (unsigned)(letter - 'A');

    const char *const first = *at;
    if (letter == 'G' || (letter == 'M' && !nck_words_are_arguments(words))) {
        return read_code(self, at);
    }
    if (letter == 'O') {
        // An O word, or O of a printer's G28.
        if (nck_printer_flag(self, 'O') == NCK_FLAG_NONE) return nck_decode_o_word(self, at);
        ++*at;
        return NCK_EMPTY;
    }
    const int calls = (words->codes & NCK_STEP(NCK_STEP_CALL)) != 0; // plain lines ask no more
    if (calls && letter >= 'I' && letter <= 'K' && nck_words_are_arguments(words)) {
        return read_argument(self, at);
    }
    const nck_status_t status = read_number(self, at, &words->number[index]);
    if (status != NCK_OK) return status;
    if (words->letters & NCK_LETTER(letter)) {
        return nck_decode_fail(self, NCK_E_WORD_TWICE, column_of(self, first), letter, 0.0, 0.0);
    }
    words->letters |= NCK_LETTER(letter);
    words->column[index] = (uint16_t)column_of(self, first);
    return NCK_OK;
}

// ,R ,C and ,A of a language that has them.
static nck_status_t read_corner(nck_decode_t *self, const char **at) {
    const char *const first = *at;
    const char *const word = nck_decode_skip(first + 1);
    const char letter = (char)(*word & ~0x20);
    nck_number_t number;
    const int slants = NCK_HAS_LAYOUTS && letter == 'A';
    if (!nck_corner_speaks(self) || (letter != 'R' && letter != 'C' && !slants)) {
        return fail_character(self, first);
    }
    *at = word;
    const nck_status_t status = read_number(self, at, &number);
    if (status != NCK_OK) return status;
    if (slants) return nck_slant_keep(self, column_of(self, word), &number);
    if (self->held.corner.word.letter != 0) {
        return nck_decode_fail(self, NCK_E_WORD_TWICE, column_of(self, word), letter, 0.0, 0.0);
    }
    nck_corner_keep(self, letter, column_of(self, word), &number, 0);
    return NCK_OK;
}

// Fanuc's / in the middle: what stands behind it may be skipped.
static nck_status_t skip_rest(nck_decode_t *self, const char **at) {
    if (!(self->tongue & NCK_TONGUES_FANUC)) return fail_character(self, *at);
    if (nck_decode_skips(self, at)) *at = self->line.text + self->line.size;
    return NCK_OK;
}

// Fanuc's <NAME> of a program, which stands first in its line.
static nck_status_t read_program_name(nck_decode_t *self, const char **at) {
    const nck_words_t *const words = &self->words;
    const int is_first = words->codes == 0 && words->letters == 0;
    const char *end = *at;
    while (*end != '>' && *end != '\n') end++;
    if (!(self->tongue & NCK_TONGUES_FANUC) || !is_first || *end == '\n') {
        return fail_character(self, *at);
    }
    *at = end + 1;
    return NCK_OK;
}

// LinuxCNC's $ of a spindle: $0 is the one that there is, $-1 are all.
static nck_status_t read_spindle(nck_decode_t *self, const char **at) {
    const char *const first = *at;
    nck_number_t number;
    const char *const end = nck_number_read(self->line.text, first + 1, &number);
    if (self->tongue != NCK_TONGUE_LINUXCNC || end == NULL) return fail_character(self, first);
    const double which = nck_number_real(&number);
    *at = end;
    if (!(which > 0.0) && !(which < -1.0)) return NCK_OK;
    return nck_decode_fail_at(self, NCK_E_NUMBER_RANGE, first, '$', which, 0.0);
}

// What begins with another sign, or is a mistake.
static nck_status_t read_sign(nck_decode_t *self, const char **at) {
    switch (**at) {
    case ':': return nck_decode_o_word(self, at);
    case ',': return read_corner(self, at);
    case '/': return skip_rest(self, at);
    case '<': return read_program_name(self, at);
    case '$': return read_spindle(self, at);
    case '@':
    case '^': return NCK_HAS_LAYOUTS ? nck_polar_read(self, at) : fail_character(self, *at);
    case '*':
        if (self->tongue == NCK_TONGUE_MARLIN) return nck_printer_checksum(self, at);
        return fail_character(self, *at);
    default: return fail_character(self, *at);
    }
}

// What begins with no letter: a remark, a parameter, or the name of a program behind a colon.
static nck_status_t read_other(nck_decode_t *self, const char **at) {
    const char *const first = *at;
    if (*first == '#') return nck_decode_assign(self, at);
    if (*first != '(') return read_sign(self, at);
    while (**at != ')' && **at != '\n') ++*at;
    if (**at == '\n') {
        return nck_decode_fail(self, NCK_E_COMMENT, column_of(self, first), 0, 0.0, 0.0);
    }
    ++*at;
    return NCK_OK;
}

nck_status_t nck_decode_words(nck_decode_t *self, const char *at) {
    nck_status_t status = NCK_OK;
    self->words.letters = 0;
    self->words.axes = 0;
    self->words.steps = 0;
    self->words.codes = 0;
    self->words.takes = 0;
    self->words.tail = 0;
    self->words.place = 0;
    self->words.polars = 0;
    while (status >= NCK_OK && *at != '\n') {
        if (nck_is_letter(*at)) {
            status = read_word(self, &at);
        } else if (*at == ' ' || *at == '\t') {
            at++;
        } else if (*at == ';') {
            self->words.tail = 1;
            break;
        } else {
            status = read_other(self, &at);
        }
    }
    if (status > NCK_OK) status = NCK_OK;
    return self->macro.waiting == 0 ? status : nck_variable_commit(self, status);
}
