// SPDX-License-Identifier: MIT
// Room 3, smooth: block → seg. Exact lines, arcs, helices; clocked splines within a tolerance.
#ifndef NCK_PREP_SMOOTH_H
#define NCK_PREP_SMOOTH_H

#include "nck/base/limits.h"  // NCK_AXIS_MAX NCK_OPTIMAL_MEMBER
#include "nck/base/records.h" // nck_block_t nck_seg_t nck_output_t
#include "nck/base/status.h"  // nck_status_t
#include "nck/base/terms.h"   // nck_terms_t
#include "nck/prep/3_smooth/clocked.h" // nck_clocked_t

// What the room gives: a seg, or an output between segs.
typedef struct nck_smooth_item {
    uint8_t is_output;   // 1: output, 0: seg
    uint8_t reserved[7]; // 0
    nck_seg_t seg;
    nck_output_t output; // after_segs is set
} nck_smooth_item_t;

// The room's state: filled by nck_smooth_init, written by the room alone.
typedef struct nck_smooth {
    const nck_terms_t *terms;
    int64_t position_nm[NCK_AXIS_MAX]; // end of the last block pushed [nm, ndeg]
    double position[NCK_AXIS_MAX];     // the same [mm, deg]
    double s;            // length of all segs pulled [path mm]
    double known;        // and of the blocks that have been pushed [path mm]
    uint32_t seq;        // of the next seg pulled
    uint8_t hungry;      // 1: pull needs a block
    uint8_t ended;       // 1: no more blocks
    uint8_t rests;       // 1: the path does, behind the last seg pulled

    // The block that waits for its turn, behind a clocked run perhaps.
    struct {
        uint8_t has_seg;     // 1: it moves or rests
        uint8_t has_output;  // 1: it hands over something, before its seg
        nck_seg_t seg;       // exact
        nck_output_t output;
    } next;

    // The seg that is given in pieces, since the spindle's speed changes along it.
    struct {
        double from;   // given up to here [path mm]; its length: nothing is left
        nck_seg_t seg;
    } divide;

    NCK_OPTIMAL_MEMBER(nck_clocked_t, clocked) // the run in work, of the optimal slope
} nck_smooth_t;

// Begin at the machine's start position. Cost: constant. Context: any, before the tick runs.
void nck_smooth_init(nck_smooth_t *self, const nck_terms_t *terms);

// Take a block of any kind, the running number of which is block_seq. Blocks without length vanish.
// Returns NCK_OK; NCK_FULL if nck_smooth_pull has not asked for a block (pull until it says
// NCK_EMPTY; so the segs depend on the blocks alone); NCK_E_FEED_MISSING if the feed comes out as
// zero or less (feed per revolution of a spindle that stands): the block is not taken.
// Cost: constant. Context: prep.
nck_status_t nck_smooth_push(nck_smooth_t *self, const nck_block_t *block, uint32_t block_seq);

// Push and pull in one, for a move on the exact path where no block waits in the room: its seg.
// Returns NCK_OK; NCK_EMPTY: it has no length and vanishes; NCK_E_FEED_MISSING; NCK_FULL: it has to
// be pushed. Cost: constant. Context: prep.
nck_status_t nck_smooth_pass(nck_smooth_t *self, const nck_block_t *block, uint32_t block_seq,
                             nck_seg_t *seg_out);

// 1 if the last pull has asked for a block and none has come since. Cost: constant. Context: prep.
static inline int nck_smooth_is_hungry(const nck_smooth_t *self) { return (int)self->hungry; }

// There are no more blocks: end of the program, or an error. Cost: constant. Context: prep.
void nck_smooth_end(nck_smooth_t *self);

// There are more blocks after all: the path goes on from the end that nck_smooth_pull has told by
// NCK_DONE. Cost: constant. Context: prep.
void nck_smooth_go_on(nck_smooth_t *self);

// 1 if no block is under way. Cost: constant. Context: prep.
int nck_smooth_is_empty(const nck_smooth_t *self);

// Nobody knows when more blocks come: a clocked path goes on with what is known of it, if that is
// enough for a window. Behind NCK_EMPTY. Cost: constant. Context: prep.
void nck_smooth_hurry(nck_smooth_t *self);

// What the next step of a clocked path takes at most, in hundreds of a PC's instructions; 0: there
// is none. Cost: constant. Context: prep.
uint32_t nck_smooth_price(nck_smooth_t *self);

// Give the next seg or output, in order.
// Returns NCK_OK and the item; NCK_FULL if it has to be called again; NCK_EMPTY if it needs another
// block or nck_smooth_end; NCK_DONE if all is given.
// Cost: constant; of a clocked run as nck_clocked_pull.
// Context: prep.
nck_status_t nck_smooth_pull(nck_smooth_t *self, nck_smooth_item_t *item_out);

// 1 if what must always hold does: for tests. Cost: constant. Context: prep.
int nck_smooth_invariants(const nck_smooth_t *self);

#endif
