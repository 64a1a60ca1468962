// SPDX-License-Identifier: MIT
// Words of printers (Marlin): E, which is the axis U, and M codes of heaters, fans and motors,
// which are handed over with their number.
#include "nck/prep/1_decode/parts.h"

#include <stddef.h> // NULL

// U, and where its place is if there may be one.
enum { AXIS_U = 6, AXIS_E = NCK_AXIS_MAX > AXIS_U ? AXIS_U : 0 };

// What a code does beside being handed over.
enum { PLAIN = 0, VALUE = 1, WAITS = 2, FULL = 4, ENDS = 8, TEXT = 16, LIMITS = 32 };

typedef struct printer_code {
    uint16_t code;
    uint8_t does;
} printer_code_t;

static const printer_code_t codes[] = {
    {82, PLAIN}, {83, PLAIN}, {104, VALUE}, {109, VALUE | WAITS}, {106, VALUE | FULL},
    {107, PLAIN}, {140, VALUE}, {190, VALUE | WAITS}, {141, VALUE}, {191, VALUE | WAITS},
    {117, TEXT}, {118, TEXT}, {17, PLAIN}, {18, PLAIN}, {84, PLAIN}, {105, PLAIN}, {110, PLAIN},
    {114, PLAIN}, {115, PLAIN}, {119, PLAIN}, {220, VALUE}, {221, VALUE}, {400, ENDS},
    {201, LIMITS}, {202, LIMITS}, {203, LIMITS}, {204, LIMITS}, {205, LIMITS}, {900, PLAIN}
};

static const printer_code_t *row_of(int64_t code) {
    for (unsigned k = 0; k < sizeof codes / sizeof codes[0]; k++) {
        if (codes[k].code == code) return &codes[k];
    }
    return NULL;
}

static const printer_code_t *find(const nck_decode_t *self, int64_t code) {
    return self->tongue == NCK_TONGUE_MARLIN ? row_of(code) : NULL;
}

int nck_printer_names(int64_t code) { return row_of(code) != NULL; }

int nck_printer_has(const nck_decode_t *self, int64_t code) { return find(self, code) != NULL; }

int nck_printer_speaks(const nck_decode_t *self) {
    const nck_words_t *const words = &self->words;
    const uint32_t own = NCK_STEP(NCK_STEP_OWN);
    return (words->codes & own) && nck_printer_has(self, words->code[NCK_STEP_OWN] / 10);
}

const char *nck_printer_text(const nck_decode_t *self, const char *at, int64_t tenths) {
    const printer_code_t *const code = find(self, tenths / 10);
    if (code == NULL || !(code->does & TEXT)) return at;
    while (*at != '\n' && *at != ';') at++;
    return at;
}

// All words are the code's.
nck_status_t nck_printer_resolve(nck_decode_t *self) {
    nck_words_t *const words = &self->words;
    words->steps = NCK_STEP(NCK_STEP_OWN);
    if (words->codes == words->steps) return NCK_OK;
    return nck_decode_fail_code(self, NCK_E_MODAL_GROUP, NCK_STEP_OWN);
}

// S, or R of a wait; a fan without S turns fully.
static nck_status_t read_value(nck_decode_t *self, const printer_code_t *code, double *value_out) {
    const double full = 255.0, most = 1e6;
    const int s = (self->words.letters & NCK_LETTER('S')) != 0;
    const char letter = s ? 'S' : 'R';
    *value_out = full;
    if (!s && !(self->words.letters & NCK_LETTER('R'))) {
        if (code->does & FULL) return NCK_OK;
        return nck_decode_fail_step(self, NCK_E_WORD_MISSING, NCK_STEP_OWN, 'S', code->code, 0.0);
    }
    *value_out = nck_number_real(&self->words.number[letter - 'A']);
    if (*value_out >= 0.0 && *value_out <= most) return NCK_OK;
    return nck_decode_fail_word(self, NCK_E_NUMBER_RANGE, letter, *value_out, most);
}

nck_status_t nck_decode_printer(nck_decode_t *self, nck_block_t *out) {
    const printer_code_t *const code = find(self, self->words.code[NCK_STEP_OWN] / 10);
    double value = 0.0;
    if (code == NULL) return NCK_EMPTY;
    if (code->code == 82 || code->code == 83) {
        self->modal.extrudes_steps = code->code == 83;
        return NCK_EMPTY;
    }
    if (code->does & LIMITS) nck_decode_assume(self, NCK_NOTE_LIMITS);
    if (code->does & ENDS) return nck_decode_give_dwell(self, 0.0, out);
    if (!(code->does & VALUE)) return nck_decode_give_m(self, code->code, out);
    const nck_status_t status = read_value(self, code, &value);
    if (status != NCK_OK) return status;
    (void)nck_decode_give_output(self, code->does & WAITS ? NCK_BLOCK_WAIT : NCK_BLOCK_OUTPUT,
                                 NCK_OUTPUT_SETTING, value, out);
    out->output.number = code->code;
    return NCK_OK;
}

// M82 and M83 against G90 and G91: the word becomes one of the others' kind.
static nck_status_t convert(nck_decode_t *self, nck_number_t *word) {
    const int64_t at_nm = self->place.position_nm[AXIS_E] - self->place.origin_nm[AXIS_E];
    const int sets = (self->words.codes & NCK_STEP(NCK_STEP_OFFSET)) != 0; // G92 E
    int64_t value_nm = 0;
    if (sets || self->modal.extrudes_steps == self->modal.incremental) return NCK_OK;
    nck_status_t status = nck_decode_axis_word(self, AXIS_E, &value_nm);
    value_nm += self->modal.extrudes_steps ? at_nm : -at_nm;
    if (status == NCK_OK) status = nck_decode_steps(self, AXIS_E, 0, 0, &value_nm);
    if (status == NCK_OK) nck_decode_write(self, AXIS_E, value_nm, word);
    return status;
}

nck_status_t nck_printer_extrude(nck_decode_t *self) {
    nck_words_t *const words = &self->words;
    const uint32_t e = NCK_LETTER('E'), u = NCK_LETTER('U');
    nck_number_t *const word = &words->number['U' - 'A'];
    if (words->codes & NCK_STEP(NCK_STEP_DISTANCE)) { // G90 and G91 are said of E too
        self->modal.extrudes_steps = words->code[NCK_STEP_DISTANCE] == 910;
    }
    if (!(words->letters & e)) return NCK_OK;
    if (words->letters & u) return nck_decode_fail_word(self, NCK_E_WORD_TWICE, 'U', 0.0, 0.0);
    if (!(self->place.axes >> AXIS_U & 1u)) {
        return nck_decode_fail_word(self, NCK_E_AXIS_UNKNOWN, 'E', 0.0, 0.0);
    }
    *word = words->number['E' - 'A'];
    words->column['U' - 'A'] = words->column['E' - 'A'];
    words->letters = (words->letters & ~e) | u;
    return (words->codes & NCK_STEP(NCK_STEP_DISTANCE)) != 0 ? NCK_OK : convert(self, word);
}
