// SPDX-License-Identifier: MIT
// Where the program's zero is: work offsets, G92, tool length.
#include "nck/prep/1_decode/parts.h"

#include <stddef.h> // NULL
#include <string.h> // memcpy memset

void nck_decode_origin(nck_decode_t *self) {
    const int64_t *const work = self->place.work_nm[self->place.work_system];
    for (unsigned axis = 0; axis < NCK_AXIS_MAX; axis++) {
        const int64_t tool = axis < 3 ? self->place.tool_nm[axis] : 0;
        self->place.origin_nm[axis] = work[axis] + self->place.g92_nm[axis] + tool;
    }
}

// G43 with H: the table's offset; without: of the tool in the spindle; H0, no tool and G49: none.
nck_status_t nck_decode_length(nck_decode_t *self, nck_block_t *out) {
    const nck_words_t *const words = &self->words;
    const nck_number_t *const word = &words->number['H' - 'A'];
    const int has_h = (words->letters & NCK_LETTER('H')) != 0;
    int64_t number = words->code[NCK_STEP_LENGTH] == 430 ? self->modal.tool_in : 0;
    (void)out;
    if (has_h && (!nck_number_whole(word, 0, &number) || number < 0
                  || number > NCK_DECODE_VALUE_MAX)) {
        return nck_decode_fail_word(self, NCK_E_NUMBER_RANGE, 'H', nck_number_real(word),
                                    NCK_DECODE_VALUE_MAX);
    }
    const nck_tool_t *const tool = nck_decode_find_tool(self, (uint32_t)number);
    if (number != 0 && tool == NULL) {
        const unsigned column = has_h ? words->column['H' - 'A']
                                      : words->code_column[NCK_STEP_LENGTH];
        return nck_decode_fail(self, NCK_E_TOOL_UNKNOWN, column, 'H', (double)number, 0.0);
    }
    for (unsigned axis = 0; axis < 3; axis++) {
        self->place.tool_nm[axis] = number != 0 ? tool->offset_nm[axis] : 0;
    }
    nck_decode_origin(self);
    return NCK_EMPTY;
}

nck_status_t nck_decode_work(nck_decode_t *self, nck_block_t *out) {
    const unsigned code = self->words.code[NCK_STEP_WORK];
    (void)out;
    self->place.work_system = code <= 590 ? (code - 540) / 10 : code - 590 + 5;
    nck_decode_origin(self);
    return NCK_EMPTY;
}

static nck_status_t fail_missing(nck_decode_t *self, int letter) {
    return nck_decode_fail(self, NCK_E_WORD_MISSING, self->words.code_column[NCK_STEP_OFFSET],
                           letter, 0.0, 0.0);
}

// G92: the present position gets the name that the words say.
static nck_status_t rename_position(nck_decode_t *self) {
    const int64_t *const work = self->place.work_nm[self->place.work_system];
    int64_t g92_nm[NCK_AXIS_MAX];
    if (self->words.axes == 0) return fail_missing(self, 'X');
    memcpy(g92_nm, self->place.g92_nm, sizeof g92_nm);
    for (unsigned axis = 0; axis < NCK_AXIS_MAX; axis++) {
        int64_t value = 0;
        if (!(self->words.axes & ((uint32_t)1 << axis))) continue;
        const nck_status_t status = nck_decode_axis_word(self, axis, &value);
        if (status != NCK_OK) return status;
        const int64_t tool = axis < 3 ? self->place.tool_nm[axis] : 0;
        g92_nm[axis] = self->place.position_nm[axis] - tool - work[axis] - value;
    }
    memcpy(self->place.g92_nm, g92_nm, sizeof g92_nm);
    memcpy(self->place.g92_kept_nm, g92_nm, sizeof g92_nm);
    return NCK_EMPTY;
}

// G10 L2 Pn: which work system, 0 for the one in force.
static nck_status_t read_system(nck_decode_t *self, int64_t *number_out) {
    const nck_words_t *const words = &self->words;
    int64_t list = 0;
    if (!(words->letters & NCK_LETTER('L'))) return fail_missing(self, 'L');
    if (!(words->letters & NCK_LETTER('P'))) return fail_missing(self, 'P');
    if (!nck_number_whole(&words->number['L' - 'A'], 0, &list) || list != 2) {
        return nck_decode_fail_word(self, NCK_E_UNSUPPORTED, 'L',
                                    nck_number_real(&words->number['L' - 'A']), 0.0);
    }
    if (words->letters & NCK_LETTER('R')) {
        return nck_decode_fail_word(self, NCK_E_UNSUPPORTED, 'R', 0.0, 0.0);
    }
    if (!nck_number_whole(&words->number['P' - 'A'], 0, number_out) || *number_out < 0
        || *number_out > NCK_WORK_SYSTEMS) {
        return nck_decode_fail_word(self, NCK_E_NUMBER_RANGE, 'P',
                                    nck_number_real(&words->number['P' - 'A']), NCK_WORK_SYSTEMS);
    }
    return NCK_OK;
}

// G10 L2: the zero of a work system for the axes named.
static nck_status_t set_work(nck_decode_t *self) {
    const nck_words_t *const words = &self->words;
    int64_t number = 0;
    const nck_status_t system = read_system(self, &number);
    if (system != NCK_OK) return system;
    int64_t *const work = self->place.work_nm[number > 0 ? number - 1 : self->place.work_system];
    for (unsigned axis = 0; axis < NCK_AXIS_MAX; axis++) {
        int64_t value = 0;
        if (!(words->axes & ((uint32_t)1 << axis))) continue;
        const nck_status_t status = nck_decode_axis_word(self, axis, &value);
        if (status != NCK_OK) return status;
        work[axis] = value;
    }
    return NCK_EMPTY;
}

nck_status_t nck_decode_offset(nck_decode_t *self, nck_block_t *out) {
    nck_status_t status = NCK_EMPTY;
    switch (self->words.code[NCK_STEP_OFFSET]) {
    case 280:
    case 300: return nck_decode_reference(self, out);
    case 100: status = set_work(self); break;
    case 920: status = rename_position(self); break;
    case 921: // forget
        memset(self->place.g92_kept_nm, 0, sizeof self->place.g92_kept_nm);
        memset(self->place.g92_nm, 0, sizeof self->place.g92_nm);
        break;
    case 922: // suspend
        memset(self->place.g92_nm, 0, sizeof self->place.g92_nm);
        break;
    default: // G92.3: bring back
        memcpy(self->place.g92_nm, self->place.g92_kept_nm, sizeof self->place.g92_nm);
        break;
    }
    nck_decode_origin(self);
    return status;
}
