// SPDX-License-Identifier: MIT
// T: a tool to change to, or on Fanuc's lathes the turret and an offset.
#include "nck/prep/1_decode/place/parts.h"
#include "nck/prep/1_decode/state/state.h" // nck_decode_fail_word nck_decode_find_tool …
#include "nck/prep/1_decode/number/number.h" // nck_decode_whole
#include "nck/base/real.h" // nck_real_of

#include <stddef.h> // NULL

// A machine without a table does not say which tools it has.
int nck_tool_is_known(const nck_decode_t *self, uint32_t number) {
    return number == 0 || self->machine->tool_count == 0
           || nck_decode_find_tool(self, number) != NULL;
}

nck_status_t nck_decode_set_tool(nck_decode_t *self, double value, nck_block_t *out) {
    const uint32_t number = (uint32_t)value;
    if (!nck_tool_is_known(self, number)) {
        return nck_decode_fail_word(self, NCK_E_TOOL_UNKNOWN, 'T', value, 0.0);
    }
    self->modal.tool_next = number;
    return nck_decode_give_output(self, NCK_BLOCK_OUTPUT, NCK_OUTPUT_TOOL, value, out);
}

nck_status_t nck_decode_tool(nck_decode_t *self, nck_block_t *out) {
    int64_t number = 0;
    const nck_status_t status = nck_decode_whole(self, 'T', NCK_DECODE_VALUE_MAX, 0, &number);
    if (status != NCK_OK) return status;
    if (!self->lathe || number < NCK_LATHE_TOOLS) {
        return nck_decode_set_tool(self, nck_real_of(number), out);
    }
    // The turret turns at T itself, and the program waits for it; offset 00 ends the one in force.
    const uint32_t tool = (uint32_t)(number / NCK_LATHE_TOOLS);
    const uint32_t offset = (uint32_t)(number % NCK_LATHE_TOOLS);
    const int known = nck_tool_is_known(self, tool);
    const uint32_t unknown = !known ? tool : !nck_tool_is_known(self, offset) ? offset : 0;
    if (unknown != 0) {
        return nck_decode_fail_word(self, NCK_E_TOOL_UNKNOWN, 'T', (double)unknown, 0.0);
    }
    if (self->modal.comp) return nck_decode_fail_word(self, NCK_E_COMP_ON, 'T', 0.0, 0.0);
    nck_tool_t entry;
    const int has_entry = offset != 0 && nck_table_find(self, offset, &entry);
    const int turns = tool != self->modal.tool_in;
    self->modal.tool_in = tool;
    self->modal.tool_next = tool;
    self->modal.offset_in = (int32_t)offset;
    for (unsigned axis = 0; axis < 3; axis++) {
        self->place.tool_nm[axis] = has_entry ? entry.offset_nm[axis] : 0;
    }
    nck_decode_origin(self);
    if (!turns) return NCK_EMPTY;
    return nck_decode_give_output(self, NCK_BLOCK_WAIT, NCK_OUTPUT_TOOL, (double)tool, out);
}
