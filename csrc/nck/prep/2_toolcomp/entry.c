// SPDX-License-Identifier: MIT
// Where a program begins in the middle: what is before it is not cut, and the tool comes from where
// it stands to where its centre would be: away from the work first, across, and in at a feed.
#include "nck/prep/2_toolcomp/parts.h"

#include <string.h> // memcmp memcpy

// Where the parts of the way end, machine positions.
typedef struct way {
    int64_t to_nm[NCK_AXIS_MAX]; // where the tool would be
    int64_t high_nm;             // of the axis that goes first, above both ends
    unsigned axis;
} way_t;

static void find_way(const nck_toolcomp_t *self, const nck_block_t *block, way_t *way_out) {
    const int64_t height_nm = nck_machine_approach_nm(self->machine);
    const unsigned axis = nck_machine_approach_axis(self->machine);
    memcpy(way_out->to_nm, block->target_nm, sizeof way_out->to_nm);
    for (unsigned x = 0; x < 3; x++) way_out->to_nm[x] += block->tool_nm[x];
    int64_t high_nm = self->machine->start_nm[axis];
    if (way_out->to_nm[axis] > high_nm) high_nm = way_out->to_nm[axis];
    if (height_nm < INT64_MAX && height_nm > high_nm) high_nm = height_nm;
    way_out->axis = axis;
    way_out->high_nm = high_nm;
}

nck_status_t nck_comp_way_in(const nck_toolcomp_t *self, nck_block_t *block) {
    const int64_t *const start_nm = self->machine->start_nm;
    const uint32_t part = block->output.number;
    way_t way;
    find_way(self, block, &way);
    if (!memcmp(way.to_nm, start_nm, sizeof way.to_nm)) return NCK_EMPTY; // it is there
    block->kind = part == NCK_WAY_IN ? NCK_BLOCK_LINE : NCK_BLOCK_RAPID;
    if (part == NCK_WAY_IN) return NCK_OK;
    const int64_t *const at_nm = part == NCK_WAY_AWAY ? start_nm : way.to_nm;
    for (unsigned x = 0; x < NCK_AXIS_MAX; x++) {
        const int64_t tool_nm = x < 3 ? block->tool_nm[x] : 0;
        block->target_nm[x] = (x == way.axis ? way.high_nm : at_nm[x]) - tool_nm;
    }
    return NCK_OK;
}
