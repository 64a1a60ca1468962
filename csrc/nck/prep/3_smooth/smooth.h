// SPDX-License-Identifier: MIT
// Room 3, smooth: block → seg. Lines, arcs and helices become exact pieces of path.
#ifndef NCK_PREP_SMOOTH_H
#define NCK_PREP_SMOOTH_H

#include "nck/base/machine.h" // nck_machine_t
#include "nck/base/records.h" // nck_block_t nck_seg_t
#include "nck/base/status.h"  // nck_status_t

typedef struct nck_smooth {
    const nck_machine_t *machine;
    int64_t position_nm[NCK_AXIS_MAX]; // end of the last seg [nm, ndeg]
    double position[NCK_AXIS_MAX];     // the same [mm, deg]
    double s;                          // path length so far [path mm]
    uint32_t seq;                      // of the next seg
} nck_smooth_t;

// Begin at the machine's start position. Cost: constant. Context: any, before the tick runs.
void nck_smooth_init(nck_smooth_t *self, const nck_machine_t *machine);

// Make the seg of a block (RAPID, LINE, ARC, DWELL or WAIT), the running number of which is
// block_seq.
// Returns NCK_OK and the seg; NCK_EMPTY if the block has no length (it vanishes; its exact stop, if
// any, is of no use either, since nothing moved); NCK_E_FEED_MISSING if the feed comes out as zero
// or less (feed per revolution of a spindle that stands). Cost: constant. Context: prep.
nck_status_t nck_smooth_push(nck_smooth_t *self, const nck_block_t *block, uint32_t block_seq,
                             nck_seg_t *seg_out);

#endif
