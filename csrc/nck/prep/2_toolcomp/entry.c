// SPDX-License-Identifier: MIT
// Where a program begins in the middle: what is before it is not cut, and the tool comes from where
// it stands to where its centre would be: away from the work first, across, and in at a feed.
#include "nck/prep/2_toolcomp/parts.h"

#include <string.h> // memcmp memcpy

nck_status_t nck_comp_way_in(const nck_toolcomp_t *self, nck_block_t *block) {
    const int64_t *const start_nm = self->machine->start_nm;
    const uint32_t part = block->output.number;
    int64_t to_nm[NCK_AXIS_MAX]; // where the tool would be, a machine position
    memcpy(to_nm, block->target_nm, sizeof to_nm);
    for (unsigned x = 0; x < 3; x++) to_nm[x] += block->tool_nm[x];
    if (!memcmp(to_nm, start_nm, sizeof to_nm)) return NCK_EMPTY; // it is there
    block->kind = part == NCK_WAY_IN ? NCK_BLOCK_LINE : NCK_BLOCK_RAPID;
    if (part == NCK_WAY_IN) return NCK_OK;
    // The axis that goes first, and how high it goes: above both ends.
    const unsigned axis = nck_machine_approach_axis(self->machine);
    const int64_t height_nm = nck_machine_approach_nm(self->machine);
    int64_t high_nm = start_nm[axis];
    if (to_nm[axis] > high_nm) high_nm = to_nm[axis];
    if (height_nm < INT64_MAX && height_nm > high_nm) high_nm = height_nm;
    const int64_t *const at_nm = part == NCK_WAY_AWAY ? start_nm : to_nm;
    for (unsigned x = 0; x < NCK_AXIS_MAX; x++) {
        const int64_t tool_nm = x < 3 ? block->tool_nm[x] : 0;
        block->target_nm[x] = (x == axis ? high_nm : at_nm[x]) - tool_nm;
    }
    return NCK_OK;
}
