// SPDX-License-Identifier: MIT
// Room 2, toolcomp: tool offsets.
#include "nck/prep/2_toolcomp/toolcomp.h"

void nck_toolcomp_init(nck_toolcomp_t *self, const nck_machine_t *machine) {
    self->machine = machine;
}

// Plane axes in the order of G17 XY, G18 ZX, G19 YZ.
static void move_centre(nck_block_t *block) {
    const int u = block->plane == 17 ? NCK_AXIS_X : block->plane == 18 ? NCK_AXIS_Z : NCK_AXIS_Y;
    const int v = block->plane == 17 ? NCK_AXIS_Y : block->plane == 18 ? NCK_AXIS_X : NCK_AXIS_Z;
    block->centre_mm[0] += (double)block->tool_nm[u] * 1e-6;
    block->centre_mm[1] += (double)block->tool_nm[v] * 1e-6;
}

void nck_toolcomp_push(const nck_toolcomp_t *self, nck_block_t *block) {
    if (block->kind > NCK_BLOCK_ARC) return;
    if (block->kind == NCK_BLOCK_ARC) move_centre(block);
    for (int x = NCK_AXIS_X; x <= NCK_AXIS_Z; x++) {
        if (self->machine->axis[x].present) block->target_nm[x] += block->tool_nm[x];
        block->tool_nm[x] = 0;
    }
}
