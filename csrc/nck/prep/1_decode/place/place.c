// SPDX-License-Identifier: MIT
// Where the program's zero is: work offsets, G92, tool length.
#include "nck/prep/1_decode/place/parts.h"
#include "nck/prep/1_decode/state/state.h" // nck_decode_fail_code nck_decode_fail_step …
#include "nck/prep/1_decode/number/number.h" // nck_decode_axis_word nck_decode_steps …
#include "nck/prep/1_decode/modal/modal.h" // nck_decode_speed_limit
#include "nck/base/real.h" // nck_real_of

#include <stddef.h> // NULL
#include <string.h> // memcpy memset

enum {
    SYSTEMS_OF_OTHERS = 6, // G54 … G59
    G154_MOST = 99, G54 = 540, G54_1 = 541, G110 = 1100, G154 = 1540
};

static const double turn_most = 1e6; // of G10 L2 R [deg]

// G43.1: the words of X Y Z are the offset.
static nck_status_t set_length(nck_decode_t *self) {
    int64_t value_nm[3];
    memcpy(value_nm, self->place.tool_nm, sizeof value_nm);
    for (unsigned axis = 0; axis < 3; axis++) {
        if (!(self->words.axes >> axis & 1u)) continue;
        const nck_status_t status = nck_decode_axis_word(self, axis, &value_nm[axis]);
        if (status != NCK_OK) return status;
    }
    memcpy(self->place.tool_nm, value_nm, sizeof value_nm);
    nck_decode_origin(self);
    return NCK_EMPTY;
}

// Is a tool's offset in the table? NCK_EMPTY: it has none, as no tool has where there is no table.
static nck_status_t find_length(nck_decode_t *self, int64_t number, nck_tool_t *tool_out) {
    const int has_h = (self->words.letters & NCK_LETTER('H')) != 0;
    if (number == 0) return NCK_EMPTY;
    if (nck_table_find(self, (uint32_t)number, tool_out)) return NCK_OK;
    if (self->machine->tool_count == 0) {
        nck_decode_note_word(self, NCK_NOTE_LENGTH, 'H', nck_real_of(number));
        return NCK_EMPTY;
    }
    if (has_h) return nck_decode_fail_word(self, NCK_E_TOOL_UNKNOWN, 'H', nck_real_of(number), 0.0);
    return nck_decode_fail_step(self, NCK_E_TOOL_UNKNOWN, NCK_STEP_LENGTH, 'H', nck_real_of(number),
                                0.0);
}

// G43 with H: the table's offset; without: of the tool in the spindle, but Fanuc's counts the last
// H; H0, no tool and G49: none, and none where the machine has no table at all, which is noted.
// G43.2 with H adds one.
nck_status_t nck_decode_length(nck_decode_t *self, nck_block_t *out) {
    const nck_words_t *const words = &self->words;
    const int has_h = (words->letters & NCK_LETTER('H')) != 0;
    const uint16_t code = words->code[NCK_STEP_LENGTH];
    int64_t number = code == 430 ? self->modal.tool_in : 0;
    (void)out;
    if (code == 431) return set_length(self);
    const int needs_h = code == 432 || (code == 430 && self->tongue == NCK_TONGUE_FANUC);
    if (needs_h && !has_h) {
        return nck_decode_fail_step(self, NCK_E_WORD_MISSING, NCK_STEP_LENGTH, 'H',
                                    self->words.code[NCK_STEP_LENGTH] / 10.0, 0.0);
    }
    nck_status_t status = nck_decode_whole(self, 'H', NCK_DECODE_VALUE_MAX, number, &number);
    nck_tool_t tool = {0};
    if (status == NCK_OK) status = find_length(self, number, &tool);
    if (status != NCK_OK && status != NCK_EMPTY) return status;
    for (unsigned axis = 0; axis < 3; axis++) {
        if (code != 432) self->place.tool_nm[axis] = 0;
        self->place.tool_nm[axis] += tool.offset_nm[axis];
    }
    nck_decode_origin(self);
    return NCK_EMPTY;
}

// The zero of a further system: what the program has set, else what the machine has.
static void read_further(const nck_decode_t *self, uint32_t number, int64_t *zero_nm) {
    const nck_machine_t *const machine = self->machine;
    memset(zero_nm, 0, NCK_AXIS_MAX * sizeof *zero_nm);
    for (uint32_t k = 0; k < machine->work_more_count; k++) {
        if (machine->work_more[k].number != number) continue;
        memcpy(zero_nm, machine->work_more[k].zero_nm, NCK_AXIS_MAX * sizeof *zero_nm);
    }
    for (unsigned axis = 0; axis < NCK_AXIS_MAX; axis++) {
        const double *const set = nck_variable_find(self, nck_variable_work(number, axis));
        if (set != NULL) zero_nm[axis] = (int64_t)*set;
    }
}

// Which one P names, from 1.
static nck_status_t read_further_number(nck_decode_t *self, int64_t most, uint32_t *number_out) {
    int64_t number = 0;
    const nck_status_t status = nck_decode_whole(self, 'P', most, 0, &number);
    *number_out = (uint32_t)number;
    if (status != NCK_OK || number > 0) return status;
    return nck_decode_fail_word(self, NCK_E_NUMBER_RANGE, 'P', 0.0, nck_real_of(most));
}

nck_status_t nck_decode_work(nck_decode_t *self, nck_block_t *out) {
    const unsigned code = self->words.code[NCK_STEP_WORK];
    const int fanuc = (self->tongue & NCK_TONGUES_FANUC) != 0;
    const int says = code == G54 && fanuc && (self->words.letters & NCK_LETTER('P'));
    (void)out;
    // Fanuc's G54.1 P, G54 P; Haas' G154 P, and G110 …, which are its first ones.
    if (code == G54_1 || code >= G110 || says) {
        uint32_t number = (code - G110) / 10 + 1;
        if (code < G110 || code == G154) {
            if (!nck_has_word(self, 'P')) return nck_decode_fail_missing(self, NCK_STEP_WORK, 'P');
            const int64_t most = code == G154 ? G154_MOST : NCK_WORK_MOST;
            const nck_status_t status = read_further_number(self, most, &number);
            if (status != NCK_OK) return status;
        }
        read_further(self, number, self->place.work_nm[NCK_WORK_SYSTEMS]);
        self->place.work_system = NCK_WORK_SYSTEMS;
        self->place.work_more = number;
        nck_decode_origin(self);
        return NCK_EMPTY;
    }
    self->place.work_system = code <= 590 ? (code - 540) / 10 : code - 590 + 5;
    nck_decode_origin(self);
    return NCK_EMPTY;
}

// G92: the present position gets the name that the words say.
static nck_status_t rename_position(nck_decode_t *self) {
    int64_t g92_nm[NCK_AXIS_MAX];
    const int limits = self->lathe && (self->words.letters & NCK_LETTER('S'));
    const nck_status_t limited = limits ? nck_decode_speed_limit(self) : NCK_EMPTY;
    if (limited != NCK_EMPTY || (limits && self->words.axes == 0)) return limited;
    if (self->words.axes == 0) return nck_decode_fail_missing(self, NCK_STEP_OFFSET, 'X');
    // Fanuc's G92 while G52 is in force: which of them then counts goes by the control.
    if (self->place.is_local && nck_is_fanuc(self)) {
        return nck_decode_fail_code(self, NCK_E_UNSUPPORTED, NCK_STEP_OFFSET);
    }
    self->place.is_local = 0;
    memcpy(g92_nm, self->place.g92_nm, sizeof g92_nm);
    for (unsigned axis = 0; axis < NCK_AXIS_MAX; axis++) {
        int64_t value = 0;
        if (!(self->words.axes & ((uint32_t)1 << axis))) continue;
        const nck_status_t status = nck_decode_axis_word(self, axis, &value);
        if (status != NCK_OK) return status;
        g92_nm[axis] += nck_turned_place(self, axis) - value;
    }
    memcpy(self->place.g92_nm, g92_nm, sizeof g92_nm);
    memcpy(self->place.g92_kept_nm, g92_nm, sizeof g92_nm);
    return NCK_EMPTY;
}

// G52: the program's zero lies there in the work system. RS274NGC keeps it where G92 does; on
// Fanuc's controls both would count, and what then holds goes by the control.
static nck_status_t set_local(nck_decode_t *self) {
    const int fanuc = nck_is_fanuc(self);
    int64_t g92_nm[NCK_AXIS_MAX];
    if (self->words.axes == 0) return nck_decode_fail_missing(self, NCK_STEP_OFFSET, 'X');
    if (fanuc && self->modal.incremental) {
        return nck_decode_fail_code(self, NCK_E_INCREMENTAL, NCK_STEP_OFFSET);
    }
    memcpy(g92_nm, self->place.g92_nm, sizeof g92_nm);
    for (unsigned axis = 0; axis < NCK_AXIS_MAX; axis++) {
        if (fanuc && !self->place.is_local && g92_nm[axis] != 0) {
            return nck_decode_fail_code(self, NCK_E_UNSUPPORTED, NCK_STEP_OFFSET);
        }
        if (!(self->words.axes & ((uint32_t)1 << axis))) continue;
        const nck_status_t status = nck_decode_axis_word(self, axis, &g92_nm[axis]);
        if (status != NCK_OK) return status;
    }
    memcpy(self->place.g92_nm, g92_nm, sizeof g92_nm);
    memcpy(self->place.g92_kept_nm, g92_nm, sizeof g92_nm);
    self->place.is_local = 1;
    return NCK_EMPTY;
}

// R turns a work system of RS274NGC by G10 L2. L20 in one that is turned is not built.
static nck_status_t check_turn(nck_decode_t *self, int64_t list) {
    const int turns = nck_has_word(self, 'R');
    const double degrees = turns ? nck_word_real(self, 'R') : 0.0;
    const int here = list == NCK_LIST_WORK_HERE;
    const int builds = NCK_HAS_LAYOUTS && self->tongue == NCK_TONGUE_LINUXCNC && !here
                       && self->machine->kinematics != NCK_KINEMATICS_LATHE_XZ;
    if (here && self->layout.on != 0) {
        return nck_decode_fail_code(self, NCK_E_LAYOUT_ON, NCK_STEP_OFFSET);
    }
    if (!builds && (degrees > 0.0 || degrees < 0.0)) {
        return nck_decode_fail_word(self, NCK_E_UNSUPPORTED, 'R', degrees, 0.0);
    }
    if (degrees >= -turn_most && degrees <= turn_most) return NCK_OK;
    return nck_decode_fail_range(self, 'R', turn_most);
}

// G10 L2 L20 Pn: which work system, 0 for the one in force, to Fanuc for the external offset. Q is
// nothing to it.
static nck_status_t read_system(nck_decode_t *self, int64_t list, int64_t **zero_out,
                                uint32_t *row_out) {
    const nck_words_t *const words = &self->words;
    const int64_t most = self->tongue == NCK_TONGUE_LINUXCNC ? NCK_WORK_SYSTEMS : SYSTEMS_OF_OTHERS;
    int64_t number = 0;
    if (words->letters & NCK_LETTER('Q')) {
        return nck_decode_fail_word(self, NCK_E_WORD_UNUSED, 'Q', 0.0, 0.0);
    }
    nck_status_t status = check_turn(self, list);
    if (status == NCK_OK) status = nck_decode_whole(self, 'P', most, 0, &number);
    if (status != NCK_OK) return status;
    *row_out = number > 0 ? (uint32_t)number - 1 : self->place.work_system;
    *zero_out = self->place.work_nm[*row_out];
    if (number == 0 && (self->tongue & NCK_TONGUES_FANUC)) *zero_out = self->place.outer_nm;
    return NCK_OK;
}

// What an axis word adds to.
static nck_status_t read_zero(nck_decode_t *self, unsigned axis, int64_t before_nm,
                              int64_t *value_out) {
    const nck_status_t status = nck_decode_axis_word(self, axis, value_out);
    *value_out += before_nm;
    return status == NCK_OK ? nck_decode_steps(self, axis, 0, 0, value_out) : status;
}

// G10 L2: the zero of a work system for the axes named, which Fanuc's G91 adds to; L20: it is where
// the axes have the places that the words say.
static nck_status_t set_work(nck_decode_t *self, int64_t list) {
    const int adds = self->modal.incremental && (self->tongue & NCK_TONGUES_FANUC);
    const int64_t *const in_force = self->place.work_nm[self->place.work_system];
    int64_t *kept = NULL;
    uint32_t row = 0;
    const nck_status_t system = read_system(self, list, &kept, &row);
    if (system != NCK_OK) return system;
    int64_t work[NCK_AXIS_MAX];
    memcpy(work, kept, sizeof work);
    for (unsigned axis = 0; axis < NCK_AXIS_MAX; axis++) {
        int64_t value = 0;
        if (!(self->words.axes & ((uint32_t)1 << axis))) continue;
        const nck_status_t status = read_zero(self, axis, adds ? work[axis] : 0, &value);
        if (status != NCK_OK) return status;
        const int64_t here = self->place.position_nm[axis] - self->place.origin_nm[axis];
        work[axis] = list == NCK_LIST_WORK ? value : here + in_force[axis] - value;
    }
    memcpy(kept, work, sizeof work);
    const int turns = nck_has_word(self, 'R');
    if (turns) nck_turned_set(self, row, nck_word_real(self, 'R'));
    return NCK_EMPTY;
}

// Fanuc's G10 L20: the zero of a further system for the axes named, kept among the parameters.
static nck_status_t set_further(nck_decode_t *self) {
    int64_t work_nm[NCK_AXIS_MAX];
    uint32_t number = 0;
    nck_status_t status = read_further_number(self, NCK_WORK_MOST, &number);
    if (status != NCK_OK) return status;
    if (self->words.letters & (NCK_LETTER('Q') | NCK_LETTER('R'))) {
        const int letter = self->words.letters & NCK_LETTER('R') ? 'R' : 'Q';
        return nck_decode_fail_word(self, NCK_E_WORD_UNUSED, letter, 0.0, 0.0);
    }
    read_further(self, number, work_nm);
    for (unsigned axis = 0; axis < NCK_AXIS_MAX && status == NCK_OK; axis++) {
        if (!(self->words.axes & ((uint32_t)1 << axis))) continue;
        const int64_t before_nm = self->modal.incremental ? work_nm[axis] : 0;
        int64_t value_nm = 0;
        status = read_zero(self, axis, before_nm, &value_nm);
        if (status != NCK_OK) break;
        status = nck_variable_wait(self, nck_variable_work(number, axis), nck_real_of(value_nm));
    }
    status = nck_variable_commit(self, status);
    const int in_force = self->place.work_system == NCK_WORK_SYSTEMS
                         && self->place.work_more == number;
    if (in_force) read_further(self, number, self->place.work_nm[NCK_WORK_SYSTEMS]);
    return status == NCK_OK ? NCK_EMPTY : status;
}

// G10: L says of what.
static nck_status_t set_data(nck_decode_t *self) {
    const nck_words_t *const words = &self->words;
    int64_t list = 0;
    if (!nck_has_word(self, 'L')) return nck_decode_fail_missing(self, NCK_STEP_OFFSET, 'L');
    if (!nck_has_word(self, 'P')) return nck_decode_fail_missing(self, NCK_STEP_OFFSET, 'P');
    if (!nck_number_whole(&words->number['L' - 'A'], 0, &list)) list = 0; // none has that number
    const nck_status_t known = nck_table_lists(self, list);
    if (known != NCK_OK) return known;
    const int fanuc = (self->tongue & NCK_TONGUES_FANUC) != 0;
    if (list == NCK_LIST_WORK_HERE && fanuc) return set_further(self);
    if (list == NCK_LIST_WORK || list == NCK_LIST_WORK_HERE) return set_work(self, list);
    const nck_status_t status = nck_table_set(self, list);
    return status == NCK_OK ? NCK_EMPTY : status;
}

nck_status_t nck_decode_offset(nck_decode_t *self) {
    nck_status_t status = NCK_EMPTY;
    switch (self->words.code[NCK_STEP_OFFSET]) {
    case 281:
    case 301: // here
        memcpy(self->place.home_nm[self->words.code[NCK_STEP_OFFSET] == 301],
               self->place.position_nm, sizeof self->place.position_nm);
        break;
    case 100: status = set_data(self); break;
    case 520: status = set_local(self); break;
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
