// SPDX-License-Identifier: MIT
// Words of printers (Marlin): E, which is the axis U, and M codes of heaters, fans and motors,
// which are handed over with their number.
#include "nck/prep/1_decode/tongue/parts.h"
#include "nck/prep/1_decode/state/state.h" // nck_decode_assume nck_decode_fail_at …
#include "nck/prep/1_decode/number/number.h" // nck_decode_axis_word nck_decode_steps …

#include <stddef.h> // NULL

// U, and where its place is if there may be one.
enum { AXIS_U = 6, AXIS_E = NCK_AXIS_MAX > AXIS_U ? AXIS_U : 0 };

// What a code does beside being handed over.
enum { PLAIN = 0, VALUE = 1, WAITS = 2, FULL = 4, ENDS = 8, TEXT = 16, LIMITS = 32, TRAVEL = 64 };

enum { CODE_DIGITS = 4 };

static const double pause_most_s = 1e6;
enum { PERCENT = 220, PERCENT_MOST = 10000, PERCENT_PLAIN = 100 }; // of M220
enum { CHECKS = 862, CHECKS_LAST = 6 }; // M862.1 … M862.6: is it the printer that is meant?

typedef struct printer_code {
    uint16_t code;
    uint8_t does;
} printer_code_t;

// Marlin 2.1, and what PrusaSlicer writes for its printers (M73 M86 M142 M601 M862 …) and for
// RepRapFirmware (M116 M374 M375 M376 M557 M566 M568 M572). All of them move nothing, but M600,
// M601, M125 and M25, which wait for a person.
static const printer_code_t codes[] = {
    {82, PLAIN}, {83, PLAIN}, {104, VALUE}, {109, VALUE | WAITS}, {106, VALUE | FULL}, {107, PLAIN},
    {140, VALUE}, {190, VALUE | WAITS}, {141, VALUE}, {191, VALUE | WAITS}, {117, TEXT},
    {118, TEXT}, {17, TEXT}, {18, TEXT}, {84, TEXT}, {105, TEXT}, {110, PLAIN}, {114, TEXT},
    {115, TEXT}, {119, TEXT}, {220, VALUE}, {221, VALUE}, {400, ENDS}, {201, LIMITS}, {202, LIMITS},
    {203, LIMITS}, {204, LIMITS}, {205, LIMITS}, {900, TEXT}, {16, TEXT}, {24, TEXT},
    {25, TEXT | WAITS}, {27, TEXT}, {31, TEXT}, {42, TEXT}, {73, TEXT}, {74, TEXT}, {75, TEXT},
    {76, TEXT}, {77, TEXT}, {78, TEXT}, {80, TEXT}, {81, TEXT}, {85, TEXT}, {86, TEXT}, {87, TEXT},
    {92, TEXT}, {108, TEXT}, {111, TEXT}, {113, TEXT}, {120, TEXT}, {121, TEXT}, {123, TEXT},
    {125, TEXT | WAITS}, {142, TEXT}, {145, TEXT}, {149, TEXT}, {150, TEXT}, {154, TEXT},
    {155, TEXT}, {163, TEXT}, {164, TEXT}, {165, TEXT}, {166, TEXT}, {192, TEXT | WAITS},
    {193, TEXT | WAITS}, {207, TEXT}, {208, TEXT}, {209, TEXT}, {211, TRAVEL}, {217, TEXT},
    {226, TEXT | WAITS}, {240, TEXT}, {250, TEXT}, {255, TEXT}, {256, TEXT}, {260, TEXT},
    {261, TEXT}, {280, TEXT}, {281, TEXT}, {282, TEXT}, {290, TEXT}, {291, TEXT}, {292, TEXT},
    {300, TEXT}, {301, TEXT}, {302, TEXT}, {303, TEXT}, {304, TEXT}, {305, TEXT}, {306, TEXT},
    {309, TEXT}, {350, TEXT}, {355, TEXT}, {374, TEXT}, {375, TEXT}, {376, TEXT}, {401, TEXT},
    {402, TEXT}, {404, TEXT}, {405, TEXT}, {406, TEXT}, {407, TEXT}, {410, TEXT}, {412, TEXT},
    {413, TEXT}, {420, TEXT}, {421, TEXT}, {425, TEXT}, {430, TEXT}, {486, TEXT}, {500, TEXT},
    {501, TEXT}, {502, TEXT}, {503, TEXT}, {504, TEXT}, {555, TEXT}, {557, TEXT}, {566, LIMITS},
    {568, TEXT}, {569, TEXT}, {572, TEXT}, {575, TEXT}, {591, TEXT}, {592, TEXT}, {593, TEXT},
    {600, TEXT | WAITS}, {601, TEXT | WAITS}, {602, TEXT}, {603, TEXT}, {851, TEXT}, {CHECKS, TEXT},
    {906, TEXT}, {907, TEXT}, {908, TEXT}, {910, TEXT}, {911, TEXT}, {912, TEXT}, {913, TEXT},
    {914, TEXT}, {915, TEXT}, {919, TEXT}, {116, TEXT | WAITS}, {561, TEXT}, {928, TEXT}
};

// What a code of G is that moves something on a printer and that no text tells: a retraction of the
// firmware's own, a probe, or a way of its own (G12 wipes, G26 prints a mesh, G27 parks;
// G80 of Prusa's probes the bed).
static const struct {
    uint32_t letters; // that it may have; 0: any text
    uint16_t tenths;
} g_codes[] = {
    {NCK_LETTER('S') | NCK_LETTER('P') | NCK_LETTER('R'), 100}, {NCK_LETTER('S'), 110}, {0, 290},
    {0, 120}, {0, 260}, {0, 270}, {0, 350}, {0, 800},
    {NCK_LETTER('X') | NCK_LETTER('Y') | NCK_LETTER('E') | NCK_LETTER('C'), 300},
    {NCK_LETTER('A') | NCK_LETTER('E') | NCK_LETTER('I') | NCK_LETTER('T'), 340}
};

enum { CODE_LAST = 99999 }; // in tenths, of M
enum { G_CODES = sizeof g_codes / sizeof g_codes[0] };

static const printer_code_t *row_of(int64_t code) {
    for (unsigned k = 0; k < sizeof codes / sizeof codes[0]; k++) {
        if (codes[k].code == code) return &codes[k];
    }
    return NULL;
}

static const printer_code_t *find(const nck_decode_t *self, int64_t code) {
    return self->tongue == NCK_TONGUE_MARLIN ? row_of(code) : NULL;
}

int nck_printer_names(int64_t tenths) {
    if (!NCK_HAS_FOREIGN) return 0;
    if (tenths < 0 || tenths > CODE_LAST) return 0;
    const int32_t code = (int32_t)tenths / 10;
    const int32_t part = (int32_t)tenths % 10;
    const int checks = code == CHECKS && part >= 1 && part <= CHECKS_LAST;
    return (checks || (part == 0 && code != CHECKS)) && row_of(code) != NULL;
}

int nck_printer_has(const nck_decode_t *self, int64_t tenths) {
    return self->tongue == NCK_TONGUE_MARLIN && nck_printer_names(tenths);
}

int nck_printer_has_g(const nck_decode_t *self, int64_t tenths, uint32_t *takes_out) {
    if (!NCK_HAS_FOREIGN) return 0;
    unsigned k = 0;
    while (k < G_CODES && g_codes[k].tenths != tenths) k++;
    if (self->tongue != NCK_TONGUE_MARLIN || k == G_CODES) return 0;
    *takes_out = g_codes[k].letters;
    return 1;
}

int nck_printer_speaks(const nck_decode_t *self) {
    const nck_words_t *const words = &self->words;
    const uint32_t own = NCK_STEP(NCK_STEP_OWN);
    return (words->codes & own) && nck_printer_has(self, words->code[NCK_STEP_OWN]);
}

const char *nck_printer_code(const char *at, nck_number_t *out) {
    if (!NCK_HAS_FOREIGN) return NULL;
    const char *const first = at + 1;
    int32_t tenths = 0;
    if ((*at & ~0x20) != 'M') return NULL;
    for (at = first; nck_is_digit(*at) && at - first < CODE_DIGITS; at++) {
        tenths = 10 * tenths + 10 * (*at - '0');
    }
    const int has_tenths = *at == '.' && nck_is_digit(at[1]);
    if (*at != ' ' && *at != '\t' && !has_tenths) return NULL; // nothing that could be misread
    if (has_tenths) {
        tenths += at[1] - '0';
        at += 2;
    }
    nck_number_tenths(tenths, out);
    return at > first ? at : NULL;
}

// One past the digits behind a *, NULL: there are none, or something stands behind them.
static const char *checksum_end(const char *at, int32_t *value_out) {
    const char *const first = at + 1;
    *value_out = 0;
    for (at = first; nck_is_digit(*at) && at - first < 3; at++) {
        *value_out = 10 * *value_out + (*at - '0');
    }
    const char *const end = at;
    while (*at == ' ' || *at == '\t') at++;
    return end > first && (*at == '\n' || *at == ';') ? end : NULL;
}

// May any text stand behind the code of a step?
static int has_text(const nck_decode_t *self, unsigned step) {
    const int32_t tenths = self->words.code[step];
    if (step == NCK_STEP_STOP) return 1;
    if (tenths >= NCK_CODE_OWN_G) return self->words.takes == 0;
    const printer_code_t *const code = find(self, tenths / 10);
    return code != NULL && (code->does & TEXT);
}

const char *nck_printer_text(const nck_decode_t *self, const char *at, unsigned step) {
    if (!NCK_HAS_FOREIGN) return at;
    const int numbered = nck_has_word(self, 'N');
    int32_t value = 0;
    if (self->tongue != NCK_TONGUE_MARLIN || !has_text(self, step)) return at;
    while (*at != '\n' && *at != ';') {
        if (numbered && *at == '*' && checksum_end(at, &value) != NULL) break;
        at++;
    }
    return at;
}

// S or P with a number; 0: neither.
static char time_at(const char *at) {
    const char letter = (char)(*at & ~0x20);
    return (letter == 'S' || letter == 'P') && nck_is_digit(at[1]) ? letter : 0;
}

int nck_printer_pauses(const nck_decode_t *self, double *wait_out) {
    if (!NCK_HAS_FOREIGN || self->tongue != NCK_TONGUE_MARLIN) return 0;
    const char *at = self->line.text + self->words.code_column[NCK_STEP_STOP];
    int pauses = 0;
    while (nck_is_digit(*at)) at++;
    at = nck_skip_blanks(at);
    while (time_at(at) != 0) {
        const char letter = time_at(at);
        nck_number_t number;
        at = nck_skip_blanks(nck_number_read(self->line.text, at + 1, &number));
        const double value = nck_number_real(&number), wait = letter == 'S' ? value : value / 1e3;
        if (!pauses || letter == 'S') *wait_out = wait < pause_most_s ? wait : pause_most_s;
        pauses = 1;
    }
    return pauses;
}

nck_status_t nck_printer_checksum(nck_decode_t *self, const char **at) {
    if (!NCK_HAS_FOREIGN) return NCK_E_UNSUPPORTED;
    int32_t value = 0, sum = 0;
    const char *const end = checksum_end(*at, &value);
    for (const char *each = self->line.text; each < *at; each++) {
        sum = (int32_t)((uint32_t)sum ^ (unsigned char)*each);
    }
    if (end == NULL) return nck_decode_fail_at(self, NCK_E_NUMBER, *at, '*', 0.0, 0.0);
    if (value != sum) return nck_decode_fail_at(self, NCK_E_NUMBER_RANGE, *at, '*', value, sum);
    *at = end;
    return NCK_OK;
}

// Of M220: B keeps the percent in force, R is the one that was kept.
static int keeps_percent(const nck_decode_t *self, char letter) {
    const int sets = NCK_HAS_KEPT && (self->words.codes & NCK_STEP(NCK_STEP_OWN)) != 0
                     && self->words.code[NCK_STEP_OWN] == 10 * PERCENT;
    return sets && (letter == 'B' || letter == 'R');
}

nck_flag_t nck_printer_flag(const nck_decode_t *self, char letter) {
    if (!NCK_HAS_FOREIGN || self->tongue != NCK_TONGUE_MARLIN) return NCK_FLAG_NONE;
    const int homes = (self->words.codes & NCK_STEP(NCK_STEP_OFFSET)) != 0
                      && self->words.code[NCK_STEP_OFFSET] == 280;
    const int axis = letter >= 'X' && letter <= 'Z';
    if ((homes && axis) || keeps_percent(self, letter)) return NCK_FLAG_WORD;
    return homes ? NCK_FLAG_IDLE : NCK_FLAG_NONE;
}

// All words are the code's.
nck_status_t nck_printer_resolve(nck_decode_t *self) {
    if (!NCK_HAS_FOREIGN) return NCK_OK;
    nck_words_t *const words = &self->words;
    words->steps = NCK_STEP(NCK_STEP_OWN);
    if (words->codes == words->steps) return NCK_OK;
    return nck_decode_fail_code(self, NCK_E_MODAL_GROUP, NCK_STEP_OWN);
}

// What M220 comes to; NCK_EMPTY: it changes nothing.
static nck_status_t read_percent(nck_decode_t *self, double *value_out) {
    nck_kept_t *const kept = NCK_KEPT_AT(self, entry.kept);
    const int sets = nck_has_word(self, 'S'), returns = nck_has_word(self, 'R');
    if (!NCK_HAS_KEPT) return NCK_EMPTY;
    if (nck_has_word(self, 'B')) kept->percent_back = kept->percent ? kept->percent : PERCENT_PLAIN;
    if (!sets && !(returns && kept->percent_back != 0)) return NCK_EMPTY;
    *value_out = sets ? nck_word_real(self, 'S') : kept->percent_back;
    if (!(*value_out >= 0.0 && *value_out <= (double)PERCENT_MOST)) {
        return nck_decode_fail_word(self, NCK_E_NUMBER_RANGE, 'S', *value_out, PERCENT_MOST);
    }
    kept->percent = (uint16_t)*value_out;
    return NCK_OK;
}

// S, or R of a wait; a fan without S turns fully.
static nck_status_t read_value(nck_decode_t *self, const printer_code_t *code, double *value_out) {
    const double full = 255.0, most = 1e6;
    if (code->code == PERCENT && NCK_HAS_KEPT) return read_percent(self, value_out);
    const int s = nck_has_word(self, 'S');
    const char letter = s ? 'S' : 'R';
    *value_out = full;
    if (!s && !(self->words.letters & NCK_LETTER('R'))) {
        if (code->does & FULL) return NCK_OK;
        return nck_decode_fail_step(self, NCK_E_WORD_MISSING, NCK_STEP_OWN, 'S', code->code, 0.0);
    }
    *value_out = nck_word_real(self, letter);
    if (*value_out >= 0.0 && *value_out <= most) return NCK_OK;
    return nck_decode_fail_word(self, NCK_E_NUMBER_RANGE, letter, *value_out, most);
}

// M211 S: are axes held within their travel? Without S it only asks.
static void hold_ends(nck_decode_t *self) {
    if (!nck_has_word(self, 'S')) return;
    self->modal.roams = !(nck_word_real(self, 'S') > 0.0);
    if (self->modal.roams) nck_decode_assume(self, NCK_NOTE_ENDS_OFF);
}

nck_status_t nck_decode_printer(nck_decode_t *self, nck_block_t *out) {
    if (!NCK_HAS_FOREIGN) return NCK_EMPTY;
    const printer_code_t *const code = find(self, self->words.code[NCK_STEP_OWN] / 10);
    double value = 0.0;
    if (code == NULL) return NCK_EMPTY;
    if (code->code == 82 || code->code == 83) {
        self->modal.extrudes_steps = code->code == 83;
        return NCK_EMPTY;
    }
    if (code->does & LIMITS) nck_decode_assume(self, NCK_NOTE_LIMITS);
    if (code->does & TRAVEL) hold_ends(self);
    if (code->does & ENDS) return nck_decode_give_dwell(self, 0.0, out);
    if (!(code->does & VALUE)) {
        const nck_block_kind_t kind = code->does & WAITS ? NCK_BLOCK_WAIT : NCK_BLOCK_OUTPUT;
        return nck_decode_give_output(self, kind, NCK_OUTPUT_M, code->code, out);
    }
    const nck_status_t status = read_value(self, code, &value);
    if (status != NCK_OK) return status;
    (void)nck_decode_give_output(self, code->does & WAITS ? NCK_BLOCK_WAIT : NCK_BLOCK_OUTPUT,
                                 NCK_OUTPUT_SETTING, value, out);
    out->output.number = code->code;
    return NCK_OK;
}

// Does E of this line count in steps? incremental: what its other words do.
static int extrudes_steps(nck_decode_t *self, int incremental) {
    nck_modes_t *const modal = &self->modal;
    const int says = (self->words.codes & NCK_STEP(NCK_STEP_DISTANCE)) != 0;
    const uint32_t firmware = self->machine->firmware;
    if (says && firmware == NCK_FIRMWARE_MARLIN) modal->extrudes_steps = (uint8_t)incremental;
    return modal->extrudes_steps || (incremental && firmware == NCK_FIRMWARE_KLIPPER);
}

nck_status_t nck_printer_extrude(nck_decode_t *self) {
    if (!NCK_HAS_FOREIGN) return NCK_OK;
    nck_words_t *const words = &self->words;
    const uint32_t e = NCK_LETTER('E'), u = NCK_LETTER('U');
    const int says = (words->codes & NCK_STEP(NCK_STEP_DISTANCE)) != 0;
    const int sets = (words->codes & NCK_STEP(NCK_STEP_OFFSET)) != 0; // G92 E
    const int incremental = says ? words->code[NCK_STEP_DISTANCE] == 910 : self->modal.incremental;
    const int steps = extrudes_steps(self, incremental);
    nck_number_t *const word = &words->number['U' - 'A'];
    if (!(words->letters & e)) return NCK_OK;
    if (words->letters & u) return nck_decode_fail_word(self, NCK_E_WORD_TWICE, 'U', 0.0, 0.0);
    if (!(self->place.axes >> AXIS_U & 1u)) {
        return nck_decode_fail_word(self, NCK_E_AXIS_UNKNOWN, 'E', 0.0, 0.0);
    }
    *word = words->number['E' - 'A'];
    words->column['U' - 'A'] = words->column['E' - 'A'];
    words->letters = (words->letters & ~e) | u;
    if (sets || steps == incremental) return NCK_OK;
    // The word of E becomes one of the others' kind.
    const int64_t at_nm = self->place.position_nm[AXIS_E] - self->place.origin_nm[AXIS_E];
    int64_t value_nm = 0;
    nck_status_t status = nck_decode_axis_word(self, AXIS_E, &value_nm);
    value_nm += steps ? at_nm : -at_nm;
    if (status == NCK_OK) status = nck_decode_steps(self, AXIS_E, 0, 0, &value_nm);
    if (status == NCK_OK) nck_decode_write(self, AXIS_E, value_nm, word);
    return status;
}
