// SPDX-License-Identifier: MIT
// Room 2, toolcomp: block → block. Tool offsets in; radius compensation has its place here.
#ifndef NCK_PREP_TOOLCOMP_H
#define NCK_PREP_TOOLCOMP_H

#include "nck/base/machine.h" // nck_machine_t
#include "nck/base/records.h" // nck_block_t

// The room's state.
typedef struct nck_toolcomp {
    const nck_machine_t *machine; // who has X, Y and Z
} nck_toolcomp_t;

// Cost: constant. Context: any, before the tick runs.
void nck_toolcomp_init(nck_toolcomp_t *self, const nck_machine_t *machine);

// Turn a block of the tool tip into a block of the machine: target and arc centre are moved by the
// tool offset in force, which is zero afterwards. Blocks without motion pass. Cost: constant.
// Context: prep.
void nck_toolcomp_push(const nck_toolcomp_t *self, nck_block_t *block);

#endif
