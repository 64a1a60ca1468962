// SPDX-License-Identifier: MIT
// The tool table: the machine's, and what G10 L1 L10 … L13 has changed in it. The changes stand
// among the parameters.
#include "nck/prep/1_decode/place/parts.h"
#include "nck/prep/1_decode/state/state.h" // nck_decode_fail_missing nck_decode_fail_word …
#include "nck/prep/1_decode/number/number.h" // nck_decode_axis_word nck_decode_length_word …
#include "nck/base/real.h" // nck_rounded nck_real_of

#include <stddef.h> // NULL size_t

// What may be changed.
enum { FIELD_X, FIELD_Y, FIELD_Z, FIELD_RADIUS, FIELD_NOSE, FIELD_WEAR, FIELD_RADIUS_WEAR };

enum { L_ENTRY = 1, L_HERE = 10, L_FIXTURE = 11, L_RADIUS = 12, L_RADIUS_WEAR = 13 };

static double changed(const nck_decode_t *self, uint32_t number, unsigned field, double otherwise) {
    const double *const value = nck_variable_find(self, nck_variable_tool(number, field));
    return value != NULL ? *value : otherwise;
}

int nck_table_find(const nck_decode_t *self, uint32_t number, nck_tool_t *tool_out) {
    const nck_tool_t *const entry = nck_decode_find_tool(self, number);
    if (entry == NULL) return 0;
    *tool_out = *entry;
    if (!NCK_HAS_VARIABLES) return 1;
    for (unsigned axis = 0; axis < 3; axis++) {
        const double offset = nck_real_of(entry->offset_nm[axis]);
        tool_out->offset_nm[axis] = nck_rounded(changed(self, number, FIELD_X + axis, offset));
    }
    tool_out->offset_nm[NCK_AXIS_Z] += nck_rounded(changed(self, number, FIELD_WEAR, 0.0));
    tool_out->radius_mm = changed(self, number, FIELD_RADIUS, entry->radius_mm);
    tool_out->wear_mm = changed(self, number, FIELD_RADIUS_WEAR, entry->wear_mm);
    tool_out->orientation = (uint32_t)changed(self, number, FIELD_NOSE, entry->orientation);
    return 1;
}

// What is not changed any more is what the machine has: a row that is there takes its value.
void nck_table_forget(nck_decode_t *self, uint32_t number) {
    const nck_tool_t *const tool = nck_decode_find_tool(self, number);
    if (!NCK_HAS_VARIABLES || tool == NULL) return;
    const double fields[] = {nck_real_of(tool->offset_nm[0]), nck_real_of(tool->offset_nm[1]),
                             nck_real_of(tool->offset_nm[2]), tool->radius_mm,
                             (double)tool->orientation, 0.0, tool->wear_mm};
    for (unsigned field = FIELD_X; field <= FIELD_RADIUS_WEAR; field++) {
        const uint64_t key = nck_variable_tool(number, field);
        if (nck_variable_find(self, key)) (void)nck_variable_set(self, key, fields[field]);
    }
}

// What a line changes counts once all of it is good.
static nck_status_t keep(nck_decode_t *self, uint32_t number, unsigned field, double value) {
    return nck_variable_wait(self, nck_variable_tool(number, field), value);
}

// L1: the words are the offsets; L10: offsets by which the axes stand at the places that the words
// say; L11: the same in G59.3, without G92.
static nck_status_t set_offsets(nck_decode_t *self, uint32_t number, int64_t list) {
    for (unsigned axis = 0; axis < 3; axis++) {
        int64_t word_nm = 0, offset_nm = self->place.position_nm[axis];
        if (!(self->words.axes >> axis & 1u)) continue;
        nck_status_t status = nck_decode_axis_word(self, axis, &word_nm);
        if (status != NCK_OK) return status;
        if (list == L_FIXTURE) offset_nm -= self->place.work_nm[NCK_WORK_SYSTEMS - 1][axis];
        if (list == L_HERE) {
            offset_nm -= self->place.origin_nm[axis] - self->place.tool_nm[axis];
        }
        offset_nm = list == L_ENTRY ? word_nm : offset_nm - word_nm;
        status = nck_decode_steps(self, axis, 0, 0, &offset_nm);
        if (status == NCK_OK) status = keep(self, number, FIELD_X + axis, nck_real_of(offset_nm));
        if (status != NCK_OK) return status;
    }
    return NCK_OK;
}

// R: the radius, Q: the orientation.
static nck_status_t set_shape(nck_decode_t *self, uint32_t number) {
    int64_t radius_nm = 0, nose = 0;
    nck_status_t status = NCK_OK;
    if (self->words.letters & NCK_LETTER('R')) {
        status = nck_decode_length_word(self, 'R', &radius_nm);
        const double radius = nck_real_of(radius_nm) * 1e-6;
        if (status == NCK_OK) status = keep(self, number, FIELD_RADIUS, radius);
    }
    if (status != NCK_OK || !(self->words.letters & NCK_LETTER('Q'))) return status;
    status = nck_decode_whole(self, 'Q', 9, 0, &nose);
    return status == NCK_OK ? keep(self, number, FIELD_NOSE, nck_real_of(nose)) : status;
}

// Fanuc's mills: R is the length (L10), its wear (L11, in older programs L1); G91 adds to it. What
// a change does to an offset in force goes by the control.
static nck_status_t set_length(nck_decode_t *self, uint32_t number, int64_t list) {
    nck_tool_t tool = {0};
    int64_t value_nm = 0;
    const unsigned field = list == L_HERE ? FIELD_Z : FIELD_WEAR;
    const int64_t *const in_force = self->place.tool_nm;
    (void)nck_table_find(self, number, &tool); // it is there
    if ((in_force[0] | in_force[1] | in_force[2]) != 0) {
        return nck_decode_fail_word(self, NCK_E_UNSUPPORTED, 'H', 0.0, 0.0);
    }
    nck_status_t status = nck_decode_length_word(self, 'R', &value_nm);
    if (self->modal.incremental) {
        const int64_t wear_nm = nck_rounded(changed(self, number, FIELD_WEAR, 0.0));
        value_nm += field == FIELD_WEAR ? wear_nm : tool.offset_nm[NCK_AXIS_Z] - wear_nm;
    }
    if (status == NCK_OK) status = nck_decode_steps(self, NCK_AXIS_Z, 0, 0, &value_nm);
    return status == NCK_OK ? keep(self, number, field, nck_real_of(value_nm)) : status;
}

// The same of the radius for D (L12) and its wear (L13), as the machine says that the words are.
static nck_status_t set_radius(nck_decode_t *self, uint32_t number, int64_t list) {
    nck_tool_t tool = {0};
    int64_t value_nm = 0;
    const double share = self->machine->dialect.d_offset == NCK_D_DIAMETER ? 0.5 : 1.0;
    const unsigned field = list == L_RADIUS ? FIELD_RADIUS : FIELD_RADIUS_WEAR;
    (void)nck_table_find(self, number, &tool); // it is there
    const nck_status_t status = nck_decode_length_word(self, 'R', &value_nm);
    double value = nck_real_of(value_nm) * 1e-6 * share;
    if (self->modal.incremental) value += list == L_RADIUS ? tool.radius_mm : tool.wear_mm;
    return status == NCK_OK ? keep(self, number, field, value) : status;
}

// Whose a list of G10 is; what no row gives to a language is refused there. Fanuc's L20 is of its
// further work systems (G54.1); its lathes' tools are not built.
static const struct list {
    uint8_t list, whose; // bits of nck_tongue_t
} lists[] = {
    {L_ENTRY, NCK_TONGUE_LINUXCNC | NCK_TONGUE_FANUC},
    {NCK_LIST_WORK, NCK_TONGUE_LINUXCNC | NCK_TONGUE_FANUC | NCK_TONGUE_TURNING | NCK_TONGUE_GRBL},
    {L_HERE, NCK_TONGUE_LINUXCNC | NCK_TONGUE_FANUC},
    {L_FIXTURE, NCK_TONGUE_LINUXCNC | NCK_TONGUE_FANUC},
    {L_RADIUS, NCK_TONGUE_FANUC}, {L_RADIUS_WEAR, NCK_TONGUE_FANUC},
    {NCK_LIST_WORK_HERE, NCK_TONGUE_LINUXCNC | NCK_TONGUES_FANUC | NCK_TONGUE_GRBL}
};

nck_status_t nck_table_lists(nck_decode_t *self, int64_t list) {
    const int radius = list == L_RADIUS || list == L_RADIUS_WEAR;
    const int open = radius && self->machine->dialect.d_offset == NCK_D_OPEN;
    const int here = list == NCK_LIST_WORK_HERE && !(self->tongue & NCK_TONGUES_FANUC);
    const int built = NCK_HAS_VARIABLES || list == NCK_LIST_WORK || here;
    for (size_t k = 0; k < sizeof lists / sizeof lists[0] && built && !open; k++) {
        if (lists[k].list == list && (lists[k].whose & self->tongue)) return NCK_OK;
    }
    return nck_decode_fail_word(self, NCK_E_UNSUPPORTED, 'L', nck_word_real(self, 'L'), 0.0);
}

// The words that the list has no use for, 0: there are none.
static int stranger(const nck_decode_t *self) {
    const uint32_t fanuc = NCK_LETTERS_AXES | NCK_LETTER('Q');
    const uint32_t others = NCK_LETTERS_AXES & ~(uint32_t)NCK_LETTERS_XYZ;
    const uint32_t left = self->words.letters & (nck_is_fanuc(self) ? fanuc : others);
    for (int letter = 'A'; letter <= 'Z'; letter++) {
        if (left & NCK_LETTER(letter)) return letter;
    }
    return 0;
}

nck_status_t nck_table_set(nck_decode_t *self, int64_t list) {
    int64_t number = 0;
    const int letter = stranger(self);
    if (letter != 0) return nck_decode_fail_word(self, NCK_E_WORD_UNUSED, letter, 0.0, 0.0);
    nck_status_t status = nck_decode_whole(self, 'P', NCK_DECODE_VALUE_MAX, 0, &number);
    if (status != NCK_OK) return status;
    if (nck_decode_find_tool(self, (uint32_t)number) == NULL) {
        return nck_decode_fail_word(self, NCK_E_TOOL_UNKNOWN, 'P', nck_real_of(number), 0.0);
    }
    if (nck_is_fanuc(self)) {
        if (self->words.letters & NCK_LETTER('R')) {
            status = list >= L_RADIUS ? set_radius(self, (uint32_t)number, list)
                                      : set_length(self, (uint32_t)number, list);
            return nck_variable_commit(self, status);
        }
        return nck_decode_fail_missing(self, NCK_STEP_OFFSET, 'R');
    }
    status = set_offsets(self, (uint32_t)number, list);
    if (status == NCK_OK) status = set_shape(self, (uint32_t)number);
    return nck_variable_commit(self, status);
}
